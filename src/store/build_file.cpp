#include "cdfr/store/build_file.h"

#include <sys/statvfs.h>
#include <xxhash.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include "core/floating_environment.h"
#include "core/mapped_file.h"
#include "core/parallel.h"
#include "core/progress.h"
#include "core/scratch.h"
#include "core/whole_file.h"
#include "field/build_field.h"
#include "field/domain.h"
#include "field/finished_block.h"
#include "mesh/large_mesh.h"
#include "store/arrays.h"
#include "store/opened_file.h"
#include "store/part_files.h"
#include "store/work_folder.h"
#include "store/work_size.h"
#include "store/write_field.h"

namespace cdfr {
namespace {

/// What the work is, as its folder keeps it. Work that is for something else starts over.
struct Job {
  std::uint32_t version = format::version;
  std::uint32_t flip = 0;
  std::uint64_t mesh_size = 0, mesh_hash = 0;
  double margin = 0, gain = 0;
  std::uint64_t expected_queries = 0;
  double band = 0;
  std::int32_t max_triangles = 0, max_level = 0, sign = 0, lists = 0, domain = 0, zero = 0;

  friend bool operator==(const Job&, const Job&) = default;
};

Result<Job> job_of(const std::filesystem::path& mesh, const FileBuildOptions& options, Progress& progress) {
  const Result<MappedFile> file = MappedFile::open(mesh);
  if (!file) return file.error();
  const std::span<const std::byte> bytes = file->bytes();
  const std::unique_ptr<XXH64_state_t, decltype(&XXH64_freeState)> state(XXH64_createState(),
                                                                         &XXH64_freeState);
  XXH64_reset(state.get(), 0);
  constexpr std::size_t piece = std::size_t{1} << 24;
  for (std::size_t at = 0; at < bytes.size(); at += piece) {
    if (!progress.poll()) return Progress::error();
    XXH64_update(state.get(), bytes.data() + at, std::min(piece, bytes.size() - at));
  }
  Job job;
  job.flip = options.flip ? 1 : 0;
  job.mesh_size = bytes.size();
  job.mesh_hash = XXH64_digest(state.get());
  job.margin = options.build.margin;
  job.gain = options.build.gain;
  job.expected_queries = options.build.expected_queries;
  job.max_triangles = options.build.max_triangles_per_leaf;
  job.max_level = options.build.max_level;
  job.sign = static_cast<std::int32_t>(options.build.sign);
  job.lists = static_cast<std::int32_t>(options.build.lists);
  job.domain = static_cast<std::int32_t>(options.build.domain);
  job.band = options.build.band;
  return job;
}

std::optional<Job> read_job(const std::filesystem::path& path) {
  const Result<MappedFile> file = MappedFile::open(path);
  if (!file || file->bytes().size() != sizeof(Job)) return std::nullopt;
  Job job;
  std::memcpy(&job, file->bytes().data(), sizeof job);
  return job;
}

Result<void> write_job(const std::filesystem::path& path, const Job& job) {
  Result<WholeFile> file = WholeFile::create(path);
  if (!file) return file.error();
  if (Result<void> written = file->write(std::as_bytes(std::span(&job, 1))); !written) return written;
  return file->finish();
}

/// Would the output be taken? It is written much later.
Result<void> check_output(const std::filesystem::path& output) {
  const Result<WholeFile> file = WholeFile::create(output);
  return file ? Result<void>() : file.error();
}

Result<void> check_disk(const std::filesystem::path& folder, std::uint64_t wanted) {
  struct statvfs status {};
  if (::statvfs(folder.c_str(), &status) != 0) return {};  // not every file system can say
  const std::uint64_t free = std::uint64_t{status.f_bavail} * status.f_frsize;
  if (free >= wanted) return {};
  return Error{Code::file_write, 0,
               "the disk has " + std::to_string(free >> 20) + " MiB free, the work needs about " +
                   std::to_string((wanted >> 20) + 1) + " MiB"};
}

class FileBuild {
 public:
  FileBuild(const std::filesystem::path& mesh, const std::filesystem::path& output,
            const FileBuildOptions& options, WorkFolder& work, Progress& progress)
      : mesh_(mesh),
        output_(output),
        options_(options),
        work_(work),
        progress_(progress),
        scratch_(work.path()) {}

  Result<FileBuildReport> run() {
    const Result<Job> job = job_of(mesh_, options_, progress_);
    if (!job) return job.error();
    if (options_.fresh || read_job(inside("job")) != *job) {
      work_.clear();
      if (Result<void> room = check_disk(work_.path(), disk_for(mesh_)); !room) return room.error();
      if (Result<void> written = write_job(inside("job"), *job); !written) return written.error();
    }
    if (Result<void> ready = prepare(); !ready) return ready.error();
    return build();
  }

 private:
  std::filesystem::path inside(const char* name) const { return work_.path() / name; }
  const Scratch* scratch() const noexcept { return options_.memory == 0 ? nullptr : &scratch_; }

  /// Everything but the octree, as a file of its own; from then on mapped from there.
  Result<void> prepare() {
    progress_.phase(0.02, 0.2, 3);
    if (!std::filesystem::exists(inside("prepared"))) {
      const Result<LargeMesh> mesh = read_large_mesh(mesh_, scratch_, options_.flip, progress_);
      if (!mesh) return mesh.error();
      progress_.step();
      Result<FieldData> field = prepare_field(mesh->view(), options_.build, progress_, scratch());
      if (!field) return field.error();
      progress_.step();
      lay_lattice(*field, scratch());
      const Arrays arrays = arrays_of(*field, options_.unit);
      if (Result<void> written = write_field(arrays, nullptr, inside("prepared"), Packing::none, progress_);
          !written)
        return written;
    }
    Result<StoredField> prepared = load_prepared(inside("prepared"));
    if (!prepared) return prepared.error();
    field_ = prepared->field.data();
    return {};
  }

  Result<FileBuildReport> build() {
    progress_.watch(field_.map.get());
    const Result<FileBuildReport> report = finished();
    // What was prepared may turn out to be damaged: that is the reason then.
    if (!report && field_.failed()) return field_.status().error();
    return report;
  }

  Result<FileBuildReport> finished() {
    Result<PartFiles> parts = PartFiles::open(work_.path());
    if (!parts) return parts.error();
    BlockCut cut(field_.space(), field_.tree.lattice, field_.options, progress_, cells_left_out(field_));
    if (progress_.cancelled()) return Progress::error();
    FileBuildReport report;
    report.blocks = cut.size();
    report.blocks_kept = parts->size();
    if (parts->size() < cut.size()) {
      const BlockSink sink = [&](FinishedBlock block) { return parts->append(std::move(block)); };
      if (Result<void> built = finish_blocks(field_, cut, parts->size(), progress_, sink); !built)
        return built.error();
    }
    FieldData whole = field_;
    if (Result<void> given = parts->give(whole, cut.octree(), scratch()); !given) return given.error();
    const Arrays arrays = arrays_of(whole, options_.unit);
    const Result<void> written =
        write_field(arrays, field_.map.get(), inside("field"), options_.packing, progress_);
    if (!written) return written.error();
    if (Result<void> free = check_output(output_); !free) return free.error();
    std::error_code failed;
    std::filesystem::rename(inside("field"), output_, failed);
    if (failed) return Error{Code::file_write, 0, "cannot rename the finished file: " + failed.message()};
    work_.remove();
    return report;
  }

  const std::filesystem::path& mesh_;
  const std::filesystem::path& output_;
  const FileBuildOptions& options_;
  WorkFolder& work_;
  Progress& progress_;
  Scratch scratch_;
  FieldData field_;
};

}  // namespace

Result<FileBuildReport> build_file(const std::filesystem::path& mesh, const std::filesystem::path& output,
                                   const FileBuildOptions& options, const Run& run) {
  if (std::optional<Error> error = refused(options.build)) return *error;
  if (Result<MappedFile> there = MappedFile::open(mesh); !there) return there.error();
  if (const std::uint64_t least = least_memory(mesh, run.threads);
      options.memory > 0 && options.memory < least) {
    return Error{Code::bad_option, 0,
                 "memory: this mesh needs at least " + std::to_string((least >> 20) + 1) + " MiB"};
  }
  if (Result<void> free = check_output(output); !free) return free.error();
  Result<WorkFolder> work = WorkFolder::open(output);
  if (!work) return work.error();
  const FloatingEnvironment environment;
  Progress progress(run);
  Result<FileBuildReport> report = Progress::error();
  try {
    with_threads(run, [&] { report = FileBuild(mesh, output, options, *work, progress).run(); });
  } catch (const std::bad_alloc&) {
    return Error{Code::file_write, 0, "neither memory nor the disk has room for the work"};
  }
  // What was refused is not to be gone on with.
  if (!report && report.error().code != Code::cancelled && report.error().code != Code::file_write)
    work->remove();
  return report;
}

}  // namespace cdfr
