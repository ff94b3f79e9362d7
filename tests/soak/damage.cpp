/// Damages files by bits, words and cuts, half of them with checksums that fit: each is refused, answers NaN,
/// or is caught by verify; none gives a wrong answer in silence.
///   soak_damage [--files N] [--seed S]
#include <stdlib.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "cdfr/store/store.h"
#include "store/seal.h"
#include "support/meshes.h"
#include "support/random.h"

namespace cdfr {
namespace {

std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::string damaged(std::string bytes, test::Random& random) {
  switch (random.below(4)) {
    case 0:
      return bytes.substr(0, random.below(bytes.size()));
    case 1: {
      const std::uint64_t words[] = {0, 1, 0xffffffffU, ~std::uint64_t{0}, 0x7ff0000000000000U, 0x80000000U};
      std::memcpy(bytes.data() + random.below(bytes.size() - 8), &words[random.below(6)],
                  4 + 4 * random.below(2));
      return bytes;
    }
    default:
      for (std::uint64_t i = 0; i <= random.below(3); ++i) {
        const std::uint64_t bit = random.below(8 * bytes.size());
        bytes[bit / 8] = static_cast<char>(bytes[bit / 8] ^ (1 << bit % 8));
      }
      return bytes;
  }
}

int run(int count, char** arguments) {
  long files = 100000, seed = 1;
  for (int i = 1; i + 1 < count; i += 2) {
    const std::string name = arguments[i];
    (name == "--files" ? files : seed) = std::atol(arguments[i + 1]);
  }
  std::string pattern = (std::filesystem::temp_directory_path() / "cdfr-soak-XXXXXX").string();
  if (::mkdtemp(pattern.data()) == nullptr) return 1;
  const std::filesystem::path folder = pattern, file = folder / "field.cdfr";
  test::Random random(static_cast<std::uint64_t>(seed));
  std::vector<Mesh> meshes{test::sphere_mesh(1), test::sphere_mesh(1),
                           test::soup(20, {{-1, -1, -1}, {1, 1, 1}}, 2)};
  meshes[1].triangles.pop_back();
  BuildOptions options;
  options.max_triangles_per_leaf = 8;
  options.max_level = 2;
  std::vector<Field> fields;
  std::vector<std::string> wholes;
  for (const Mesh& mesh : meshes) {
    fields.push_back(Field::build(mesh.view(), options).value());
    save(fields.back(), file, "mm").value();
    wholes.push_back(bytes_of(file));
  }
  long refused = 0, silent = 0, told = 0, caught = 0, wrong = 0;
  for (long i = 0; i < files && wrong == 0; ++i) {
    const std::size_t which = random.below(fields.size());
    std::string bytes = damaged(wholes[which], random);
    const bool sealed = random.below(2) == 0;
    if (sealed) seal(bytes);
    std::filesystem::remove(file);
    std::ofstream(file, std::ios::binary) << bytes;
    const Result<StoredField> loaded = load(file);
    if (!loaded) {
      ++refused;
      continue;
    }
    bool right = true;
    for (int k = 0; k < 20; ++k) {
      const double size = k % 5 == 0 ? 50 : 1.3;
      const Vec3 p = random.in({{-size, -size, -size}, {size, size, size}});
      const double distance = loaded->field.distance(p);
      right = right && (std::isnan(distance) || distance == fields[which].distance(p));
    }
    if (right) {
      ++(loaded->field.status() ? silent : told);
      continue;
    }
    // Only a forger gets this far, and no farther.
    if (sealed && !verify(file)) {
      ++caught;
    } else {
      ++wrong;
      std::fprintf(stderr, "soak: wrong answer, file %ld of seed %ld\n", i, seed);
    }
  }
  std::printf("%ld files: %ld refused, %ld told by status, %ld caught by verify, %ld right, %ld wrong\n",
              files, refused, told, caught, silent, wrong);
  std::filesystem::remove_all(folder);
  return wrong == 0 ? 0 : 1;
}

}  // namespace
}  // namespace cdfr

int main(int count, char** arguments) { return cdfr::run(count, arguments); }
