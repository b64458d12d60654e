#include "study/study_part_status.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace ringfilm::app {
namespace {

/// Last line that is not empty; the file may be long.
std::string last_line(const std::string& path) {
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  if (!file) return "";
  constexpr std::streamoff kLookedAt = 4096;
  file.seekg(std::max<std::streamoff>(0, static_cast<std::streamoff>(file.tellg()) - kLookedAt));
  std::string last;
  for (std::string line; std::getline(file, line);) {
    // What a terminal would take for orders is not for it.
    std::replace_if(
        line.begin(), line.end(), [](unsigned char c) { return c < ' '; }, ' ');
    if (line.find_first_not_of(' ') != std::string::npos) last = line;
  }
  return last;
}

std::string log_text(const std::string& path) {
  const std::string line = last_line(path);
  return line.empty() ? "" : fmt::format("\n  {} ends with: {}", path, line);
}

}  // namespace

std::string last_change_text(const std::string& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) return "";
  return fmt::format(", last at {:%Y-%m-%d %H:%M:%S}", fmt::localtime(status.st_mtime));
}

PartStatus::PartStatus(const StudyFiles& files, const std::optional<StudyJobs>& jobs) : files_(files), jobs_(jobs) {
  if (jobs_) states_ = queue_states(*jobs_);
}

std::string PartStatus::of(std::uint64_t part, std::uint64_t parts) const {
  std::string text;
  if (jobs_ && jobs_->parts == parts && states_) {
    const auto state = states_->find(part);
    if (state != states_->end()) {
      text += fmt::format("\n  in the queue as job {}_{}: {}", jobs_->array, part, state->second);
    } else {
      text += "\n  not in the queue of Slurm";
    }
  }
  return text + log_text(files_.log(part, parts));
}

std::string PartStatus::of_merge() const {
  if (!jobs_ || jobs_->merge.empty() || std::filesystem::exists(files_.result())) return "";
  std::string state = "squeue does not answer";
  if (states_) state = states_->contains(0) ? states_->at(0) : "not in the queue of Slurm";
  return fmt::format("the job that joins the parts, {}: {}{}\n", jobs_->merge, state, log_text(files_.merge_log()));
}

}  // namespace ringfilm::app
