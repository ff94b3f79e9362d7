#include "core/guarded_map.h"

#include <signal.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <mutex>
#include <string>

#include "core/regular_file.h"

namespace cdfr {
namespace {

const std::size_t page = static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
constexpr std::size_t most_maps = 1000;

/// Where an open map lies, for the handler: a fault inside means that the map is alive.
struct Place {
  std::atomic<GuardedMap*> map{nullptr};
  std::atomic<const std::byte*> open{nullptr}, guarded{nullptr};
  std::atomic<std::size_t> size{0};

  bool holds(const std::byte* at) const noexcept {
    const auto inside = [&](const std::byte* base) {
      return base != nullptr && at >= base && at < base + size;
    };
    return inside(open) || inside(guarded);
  }
};

std::array<Place, most_maps> places;
std::atomic<std::size_t> places_used{0};
std::mutex places_mutex;  // for those who come and go
struct sigaction before_segv, before_bus;

void pass_on(int signal, siginfo_t* info, void* context) {
  const struct sigaction& before = signal == SIGBUS ? before_bus : before_segv;
  if ((before.sa_flags & SA_SIGINFO) != 0) return before.sa_sigaction(signal, info, context);
  if (before.sa_handler != SIG_DFL && before.sa_handler != SIG_IGN) return before.sa_handler(signal);
  // Back at the faulting access, which now ends the process as it would have without this handler.
  ::sigaction(signal, &before, nullptr);
}

void handle(int signal, siginfo_t* info, void* context) {
  const int kept_errno = errno;
  const auto* at = static_cast<const std::byte*>(info->si_addr);
  const std::size_t used = places_used;
  bool done = false;
  for (std::size_t i = 0; i < used && !done; ++i) {
    if (places[i].holds(at)) done = places[i].map.load()->handle_fault(at, signal == SIGBUS);
  }
  errno = kept_errno;
  if (!done) pass_on(signal, info, context);
}

void install_handler() {
  struct sigaction action {};
  action.sa_sigaction = handle;
  // Not deferred: a check may itself run into a page that is gone.
  action.sa_flags = SA_SIGINFO | SA_NODEFER | SA_ONSTACK;
  ::sigemptyset(&action.sa_mask);
  ::sigaction(SIGSEGV, &action, &before_segv);
  ::sigaction(SIGBUS, &action, &before_bus);
}

}  // namespace

Result<std::shared_ptr<GuardedMap>> GuardedMap::open(const std::filesystem::path& path) {
  const Result<RegularFile> file = RegularFile::open(path);
  if (!file) return file.error();
  std::shared_ptr<GuardedMap> map(new GuardedMap);
  const struct stat& status = file->status();
  map->path_ = path;
  map->device_ = status.st_dev;
  map->inode_ = status.st_ino;
  map->changed_[0] = status.st_mtim.tv_sec;
  map->changed_[1] = status.st_mtim.tv_nsec;
  map->slot_ = most_maps;
  const std::size_t size = file->size();
  if (size == 0) return map;
  const auto mapped = [&](int protection) {
    void* memory = ::mmap(nullptr, size, protection, MAP_PRIVATE, file->descriptor(), 0);
    return memory == MAP_FAILED ? nullptr : static_cast<std::byte*>(memory);
  };
  map->open_ = mapped(PROT_READ);
  map->guarded_ = mapped(PROT_NONE);
  map->size_ = size;
  if (map->open_ == nullptr || map->guarded_ == nullptr) return RegularFile::error("cannot map");
  map->read_ = std::make_unique<std::atomic<std::uint64_t>[]>(size / block_size / 64 + 1);

  static std::once_flag once;
  std::call_once(once, install_handler);
  const std::lock_guard lock(places_mutex);
  const auto is_free = [](const Place& place) { return place.map == nullptr; };
  const auto free = std::find_if(places.begin(), places.end(), is_free);
  if (free == places.end()) return Error{Code::file_open, 0, "too many fields are open"};
  map->slot_ = static_cast<std::size_t>(free - places.begin());
  free->map = map.get();
  free->size = size;
  free->open = map->open_;
  free->guarded = map->guarded_;
  places_used = std::max(places_used.load(), map->slot_ + 1);
  return map;
}

GuardedMap::~GuardedMap() {
  if (slot_ < most_maps) {
    const std::lock_guard lock(places_mutex);
    places[slot_].open = nullptr;
    places[slot_].guarded = nullptr;
    places[slot_].map = nullptr;
  }
  if (open_ != nullptr) ::munmap(open_, size_);
  if (guarded_ != nullptr) ::munmap(guarded_, size_);
}

std::span<const std::byte> GuardedMap::guard(const BlockCheck& check) noexcept {
  check_ = &check;
  return {guarded_, size_};
}

void GuardedMap::fail(std::size_t where) noexcept {
  if (!failed_.exchange(true)) where_ = where;
}

/// In one step, so that no thread ever sees less than all of it.
void GuardedMap::replace(std::byte* base, std::size_t first, std::size_t end) noexcept {
  const std::size_t pages = (end - first + page - 1) / page * page;
  void* fresh = ::mmap(nullptr, pages, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (fresh == MAP_FAILED) _exit(1);  // no memory for what harms nobody, and no way to go on
  if (base == guarded_ && check_ != nullptr) check_->fill(first, end, static_cast<std::byte*>(fresh));
  ::mprotect(fresh, pages, PROT_READ);
  if (::mremap(fresh, pages, pages, MREMAP_MAYMOVE | MREMAP_FIXED, base + first) == MAP_FAILED) _exit(1);
}

bool GuardedMap::handle_fault(const std::byte* at, bool gone) noexcept {
  const bool is_open = at >= open_ && at < open_ + size_;
  std::byte* base = is_open ? open_ : guarded_;
  const auto offset = static_cast<std::size_t>(at - base);
  if (gone) {
    fail(offset);
    const std::size_t first = offset / page * page;
    replace(base, first, std::min(first + page, size_));
    return true;
  }
  const std::size_t block = offset / block_size;
  std::atomic<std::uint64_t>& word = read_[block / 64];
  const std::uint64_t bit = std::uint64_t{1} << (block % 64);
  const std::size_t first = block * block_size, end = std::min(first + block_size, size_);
  if (is_open || check_ == nullptr) return false;
  if ((word.load(std::memory_order_acquire) & bit) != 0) {
    // Another thread was first. If the access goes on failing, it was a write.
    static thread_local const std::byte* last = nullptr;
    static thread_local int times = 0;
    times = last == at ? times + 1 : 0;
    last = at;
    return times < 1000;
  }
  if (!check_->good(first, end)) {
    fail(first);
    replace(guarded_, first, end);
  } else if (::mprotect(guarded_ + first, end - first, PROT_READ) != 0) {
    // Too many pieces for the kernel. What cannot be opened by itself is opened with all the rest.
    for (std::size_t i = 0; i < size_; i += block_size) {
      if (!check_->good(i, std::min(i + block_size, size_))) fail(i);
    }
    if (failed()) {
      replace(guarded_, 0, size_);
    } else if (::mprotect(guarded_, size_, PROT_READ) != 0) {
      return false;
    }
    for (std::size_t i = 0; i <= size_ / block_size / 64; ++i) read_[i] = ~std::uint64_t{0};
  }
  word.fetch_or(bit, std::memory_order_release);
  return true;
}

Result<void> GuardedMap::status() const {
  if (failed()) {
    const std::string where = std::to_string(where_.load());
    return Error{Code::file_format, where_, "damaged, or cut short while it was read, at byte " + where};
  }
  struct stat now {};
  const bool same = ::stat(path_.c_str(), &now) == 0 && now.st_dev == device_ && now.st_ino == inode_ &&
                    static_cast<std::size_t>(now.st_size) == size_ && now.st_mtim.tv_sec == changed_[0] &&
                    now.st_mtim.tv_nsec == changed_[1];
  if (!same) return Error{Code::file_open, 0, "was changed or replaced while it was read"};
  return {};
}

}  // namespace cdfr
