#include "oracle/models.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <ostream>
#include <set>
#include <system_error>

#include "cdfr/mesh/read.h"
#include "cdfr/parts/part.h"

namespace cdfr::oracle {
namespace {

namespace fs = std::filesystem;

bool letter_or_digit(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; }

std::string identifier(std::string text) {
  for (char& c : text) c = letter_or_digit(c) ? c : '_';
  return text;
}

bool is_mesh_file(const fs::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension == ".stl" || extension == ".obj" || extension == ".ply";
}

std::vector<fs::path> mesh_files(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code failed;
  for (fs::recursive_directory_iterator i(folder, failed), end; !failed && i != end; i.increment(failed)) {
    if (i->is_regular_file() && is_mesh_file(i->path())) files.push_back(i->path());
  }
  std::ranges::sort(files);
  return files;
}

}  // namespace

std::ostream& operator<<(std::ostream& out, const Model& model) { return out << model.name; }

std::vector<Model> models() {
  std::vector<Model> result;
  for (const std::string_view part : part_names()) {
    result.push_back({"part_" + identifier(std::string(part)), std::string(part), ""});
  }
  const fs::path folder = fs::path(CDFR_SHARED_DATA) / "public";
  std::set<std::string> taken;
  for (const fs::path& file : mesh_files(folder)) {
    std::string name = identifier(file.lexically_relative(folder).string());
    while (!taken.insert(name).second) name += '_';
    result.push_back({name, "", file.string()});
  }
  return result;
}

Result<Mesh> load(const Model& model) {
  return model.part.empty() ? read_mesh(model.file) : make_part(model.part);
}

}  // namespace cdfr::oracle
