#include "rooms/made_tree.h"

#include <stdlib.h>

#include <fstream>
#include <stdexcept>

namespace cdfr::rooms {

namespace fs = std::filesystem;

MadeTree::MadeTree() {
  std::string name = (fs::temp_directory_path() / "cdfr_rooms_XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make " + name);
  root_ = name;
  write("include/cdfr/version.h", "/// Public.\n#pragma once\n");
  write("include/cdfr/cdfr.h", "/// Public.\n#pragma once\n");
  for (const char* room : {"core", "geometry", "field", "contour", "store"}) {
    const std::string name_of_room = room;
    write("include/cdfr/" + name_of_room + "/public.h", "/// A room.\n#pragma once\n");
    write("src/" + name_of_room + "/inner.h", "/// A room.\n#pragma once\n");
    write("src/" + name_of_room + "/inner.cpp", "#include \"" + name_of_room + "/inner.h\"\n");
    write("src/" + name_of_room + "/CMakeLists.txt", "target_sources(cdfr PRIVATE inner.cpp)\n");
  }
  write("src/CMakeLists.txt", "add_library(cdfr)\n");
}

MadeTree::~MadeTree() {
  std::error_code ignored;
  fs::remove_all(root_, ignored);
}

void MadeTree::write(const std::string& path, const std::string& text) const {
  fs::create_directories((root_ / path).parent_path());
  std::ofstream(root_ / path, std::ios::binary) << text;
}

void MadeTree::make_folder(const std::string& path) const { fs::create_directories(root_ / path); }

}  // namespace cdfr::rooms
