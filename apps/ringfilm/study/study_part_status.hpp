#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "study/slurm_queue.hpp"
#include "study/study_files.hpp"

namespace ringfilm::app {

/// ", last at 2026-01-31 17:05": when rows were last written to the file; empty where that is not known.
std::string last_change_text(const std::string& path);

/// What is known of parts of a study that are not finished: their state in the queue of Slurm, and the last lines
/// of their logs.
class PartStatus {
 public:
  /// Asks the queue once.
  PartStatus(const StudyFiles& files, const std::optional<StudyJobs>& jobs);

  /// Indented lines, each with a line end before it; empty where nothing is known.
  std::string of(std::uint64_t part, std::uint64_t parts) const;
  /// Whole lines about the job that joins the parts.
  std::string of_merge() const;

 private:
  const StudyFiles& files_;
  std::optional<StudyJobs> jobs_;
  std::optional<std::map<std::uint64_t, std::string>> states_;
};

}  // namespace ringfilm::app
