#include "file_hash.h"

#include <openssl/evp.h>

#include <array>
#include <cerrno>
#include <cstddef>
#include <fstream>
#include <memory>
#include <system_error>
#include <vector>

#include "interrupt.h"
#include "stop.h"

namespace cdfr::command {
namespace {

constexpr std::size_t piece_bytes = std::size_t{1} << 20;

struct Free {
  void operator()(EVP_MD_CTX* context) const noexcept { ::EVP_MD_CTX_free(context); }
};

std::string hexadecimal(const unsigned char* bytes, std::size_t count) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i) {
    text += "0123456789abcdef"[bytes[i] >> 4];
    text += "0123456789abcdef"[bytes[i] & 15];
  }
  return text;
}

}  // namespace

std::string sha256_of(const std::filesystem::path& path) {
  const DeferInterrupts defer;
  const std::unique_ptr<EVP_MD_CTX, Free> context(::EVP_MD_CTX_new());
  if (!context || ::EVP_DigestInit_ex(context.get(), ::EVP_sha256(), nullptr) != 1) {
    stop_failed(path, "cannot be hashed: OpenSSL has no SHA-256");
  }
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  std::vector<char> piece(piece_bytes);
  while (stream.read(piece.data(), static_cast<std::streamsize>(piece.size())) || stream.gcount() > 0) {
    ::EVP_DigestUpdate(context.get(), piece.data(), static_cast<std::size_t>(stream.gcount()));
    stop_if_interrupted();
  }
  if (!stream.eof()) stop_failed(path, "cannot be read: " + std::generic_category().message(errno));
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int length = 0;
  ::EVP_DigestFinal_ex(context.get(), digest.data(), &length);
  return hexadecimal(digest.data(), length);
}

}  // namespace cdfr::command
