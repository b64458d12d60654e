#include "input_file.hpp"

#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

/// The scanner of UDUNITS 2.2.28 loses the copy of an identifier in a text that names no unit.
extern "C" const char* __lsan_default_suppressions() { return "leak:utlex"; }

namespace ringfilm::fuzz {
namespace {

namespace fs = std::filesystem;

class Folder {
 public:
  Folder() {
    const fs::path memory = "/dev/shm";  // spares the disk
    std::error_code error;
    const fs::path above = fs::is_directory(memory, error) ? memory : fs::temp_directory_path();
    std::string name = (above / "ringfilm-fuzz-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no scratch folder");
    path = name;
    for (const auto& entry : fs::directory_iterator(RINGFILM_SOURCE_FOLDER "/fuzz/beside")) {
      fs::copy_file(entry.path(), path / entry.path().filename());
    }
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() {
    std::error_code error;
    fs::remove_all(path, error);
  }

  fs::path path;
};

}  // namespace

std::string input_file(const std::uint8_t* data, std::size_t size, const std::string& name) {
  static const Folder folder;
  const std::string path = (folder.path / name).string();
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  file.write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  file.close();
  if (!file) throw std::runtime_error("cannot write " + path);
  return path;
}

}  // namespace ringfilm::fuzz
