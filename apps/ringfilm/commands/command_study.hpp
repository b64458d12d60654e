#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace ringfilm::app {

struct StudyOptions {
  std::string study_path;
  std::string output;  ///< a folder, or a name that ends in .nc
  std::uint64_t part = 1, parts = 1;
  bool is_part = false;  ///< was --shard given? Then nothing is joined at the end
  bool resume = false;
  bool overwrite = false;  ///< replace a study that is there
  bool yes = false;        ///< run a full grid however large
  int threads = 0;         ///< 0: as many as the machine runs at once
};

/// Runs a study or a part of it. Throws FailedChecks where it was stopped, or where nothing could be solved.
void run_study(const StudyOptions& options);

/// Joins the parts of a study into its result files.
void merge_study(const StudyOptions& options);

/// Checks a study that is to be computed in parts, and what exists where they shall go, as run_study does. Where
/// options.parts is 0 it becomes the number of existing ones, else `usual`.
/// @returns the parts that are not finished. Throws InputError
std::vector<std::uint64_t> missing_parts(StudyOptions& options, std::uint64_t usual);

/// Prints which parts of a study are done, how far the others are and what was not solved.
void print_study_status(const StudyOptions& options);

}  // namespace ringfilm::app
