#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "study/study_files.hpp"

/// Slurm as its commands show it.
namespace ringfilm::app {

/// What a command of the shell printed on both outputs, and how it ended.
struct CommandOutput {
  std::string text;
  int exit_code = 0;
};
CommandOutput output_of(const std::string& command_line);

/// A word as the shell takes it literally.
std::string shell_word(const std::string& word);

/// A word for people to copy: in quotes only where the shell would take it for something else.
std::string word_to_copy(const std::string& word);

/// Does a word consist of characters that neither the shell nor sbatch takes for anything else?
bool is_plain(const std::string& word);

/// Does a text consist of digits alone? True for an empty one.
bool is_number(const std::string& text);

/// Is there such a command?
bool is_command(const std::string& name);

/// The jobs that a study was submitted as.
struct StudyJobs {
  std::string array, merge;  ///< their numbers
  std::uint64_t parts = 0;

  static std::string path(const StudyFiles& files);
  /// Nothing where the study was not submitted, or by hand.
  static std::optional<StudyJobs> read(const StudyFiles& files);
  void write(const StudyFiles& files) const;
};

/// States of the tasks that are still in the queue by their part, "RUNNING" or "PENDING (Resources)"; 0 is the merge.
/// Nothing where squeue is not there or does not answer.
std::optional<std::map<std::uint64_t, std::string>> queue_states(const StudyJobs& jobs);

}  // namespace ringfilm::app
