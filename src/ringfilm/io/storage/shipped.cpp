#include "ringfilm/io/storage/shipped.hpp"

#include <dlfcn.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <vector>

#include "ringfilm/base/error.hpp"

namespace ringfilm::io {
namespace {

namespace fs = std::filesystem;

/// The folder of the shared library that this code is a part of; nothing where it is a part of the program.
std::optional<fs::path> module_folder() {
  Dl_info info;
  if (::dladdr(reinterpret_cast<const void*>(&find_shipped_folder), &info) == 0 || info.dli_fname == nullptr) return {};
  std::error_code error;
  const fs::path file = fs::canonical(info.dli_fname, error);
  if (error || file.filename().string().find(".so") == std::string::npos) return std::nullopt;
  return file.parent_path();
}

/// Around the module, or else the program.
std::vector<fs::path> own_folders() {
  std::vector<fs::path> folders;
  if (const auto module = module_folder()) {
    // Beside the module (a wheel), or above lib/python3/dist-packages/ringfilm or the same in a build folder.
    folders.push_back(*module / "share");
    fs::path above = *module;
    for (int i = 0; i < 4; ++i) {
      above = above.parent_path();
      folders.push_back(above / "share" / "ringfilm");
      folders.push_back(above);
    }
    return folders;
  }
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (error) return folders;
  const fs::path above = program.parent_path().parent_path();
  return {above / "share" / "ringfilm", above};
}

std::vector<fs::path> candidates() {
  // Stated by the user: nothing else is looked at, so that a wrong name is seen and not papered over.
  if (const char* stated = std::getenv("RINGFILM_DATA"); stated != nullptr && *stated != '\0') return {stated};
  std::vector<fs::path> folders = own_folders();
  // A program of somebody else on the library, or Python: where the system keeps shared data, freedesktop.org's Base
  // Directory Specification.
  const char* stated = std::getenv("XDG_DATA_DIRS");
  const std::string shared = stated != nullptr && *stated != '\0' ? stated : "/usr/local/share:/usr/share";
  for (std::size_t begin = 0; begin <= shared.size();) {
    const std::size_t end = std::min(shared.find(':', begin), shared.size());
    const fs::path folder = shared.substr(begin, end - begin);
    if (folder.is_absolute()) folders.push_back(folder / "ringfilm");
    begin = end + 1;
  }
  return folders;
}

bool holds_shipped_data(const fs::path& folder) {
  std::error_code error;
  return fs::is_directory(folder / "cases", error) && fs::is_directory(folder / "data", error);
}

}  // namespace

std::optional<std::string> find_shipped_folder() {
  for (const fs::path& folder : candidates()) {
    if (holds_shipped_data(folder)) return folder.string();
  }
  return std::nullopt;
}

Fault missing_shipped_folder() {
  const std::string required = "the folder that holds cases/ and data/ as they are shipped";
  const char* stated = std::getenv("RINGFILM_DATA");
  if (stated == nullptr || *stated == '\0') {
    return {{},
            "the shipped cases and data are not found",
            "set the environment variable RINGFILM_DATA to " + required + ", or run the installed program"};
  }
  std::error_code error;
  const fs::path folder = fs::weakly_canonical(stated, error);
  const bool is_inside = !error && holds_shipped_data(folder.parent_path());
  return {{},
          "the shipped cases and data are not found: the environment variable RINGFILM_DATA is " + std::string(stated) +
              ", which holds no cases/ and data/",
          "set RINGFILM_DATA to " + (is_inside ? folder.parent_path().string() + ", " : "") + required};
}

std::string shipped_folder() {
  if (const auto folder = find_shipped_folder()) return *folder;
  throw InputError({missing_shipped_folder()});
}

}  // namespace ringfilm::io
