#include "study/study_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <tuple>

#include "ringfilm/base/error.hpp"

namespace ringfilm::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFinished = ".rows";
constexpr const char* kGrowing = ".growing";

}  // namespace

StudyFiles::StudyFiles(const std::string& output) {
  const fs::path path(output);
  stem_ = path.extension() == ".nc" ? fs::path(path).replace_extension().string() : (path / "study").string();
}

std::string StudyFiles::growing(std::uint64_t part, std::uint64_t parts) const {
  return fmt::format("{}.part-{}-of-{}{}", stem_, part, parts, kGrowing);
}

std::string StudyFiles::finished(std::uint64_t part, std::uint64_t parts) const {
  return fmt::format("{}.part-{}-of-{}{}", stem_, part, parts, kFinished);
}

std::string StudyFiles::log(std::uint64_t part, std::uint64_t parts) const {
  return fmt::format("{}.part-{}-of-{}.log", stem_, part, parts);
}

std::string StudyFiles::folder() const {
  const fs::path folder = fs::path(stem_).parent_path();
  return folder.empty() ? "." : folder.string();
}

std::string StudyFiles::name() const { return fs::path(stem_).filename().string(); }

void StudyFiles::make_folder() const {
  const fs::path folder = fs::path(stem_).parent_path();
  std::error_code error;
  if (!folder.empty()) fs::create_directories(folder, error);
  if (error) throw OutputError(fmt::format("{}: the folder could not be made: {}", folder.string(), error.message()));
}

std::vector<PartFile> StudyFiles::parts() const {
  const fs::path stem(stem_);
  const fs::path folder = stem.has_parent_path() ? stem.parent_path() : fs::path(".");
  const std::string start = stem.filename().string() + ".part-";
  const std::regex rest("([0-9]{1,9})-of-([0-9]{1,9})(\\.rows|\\.growing)");
  std::vector<PartFile> found;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (name.compare(0, start.size(), start) != 0) continue;
    const std::string tail = name.substr(start.size());
    std::smatch match;
    if (!std::regex_match(tail, match, rest)) continue;
    found.push_back({(stem.has_parent_path() ? entry->path() : fs::path(name)).string(), std::stoull(match[1]),
                     std::stoull(match[2]), match[3] == kFinished});
  }
  std::sort(found.begin(), found.end(), [](const PartFile& a, const PartFile& b) {
    return std::tuple(a.parts, a.part, !a.is_finished) < std::tuple(b.parts, b.part, !b.is_finished);
  });
  return found;
}

}  // namespace ringfilm::app
