#include "unpacked.h"

#include <stdlib.h>
#include <unistd.h>
#include <zlib.h>

#include <array>
#include <string>
#include <system_error>

namespace cdfr::bench {

Unpacked::Unpacked(const std::filesystem::path& packed) {
  std::string name = (std::filesystem::temp_directory_path() / "cdfr-bench-XXXXXX").string();
  const int out = mkstemp(name.data());
  path_ = name;
  if (out < 0) return;
  if (const gzFile in = gzopen(packed.c_str(), "rb")) {
    std::array<char, 1 << 16> part;
    int size = 0;
    while ((size = gzread(in, part.data(), part.size())) > 0) {
      if (write(out, part.data(), static_cast<std::size_t>(size)) != size) break;
    }
    gzclose(in);
  }
  close(out);
}

Unpacked::~Unpacked() {
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
}

}  // namespace cdfr::bench
