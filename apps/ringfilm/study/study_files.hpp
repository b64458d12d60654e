#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace ringfilm::app {

/// A file with rows of one part of a study.
struct PartFile {
  std::string path;
  std::uint64_t part = 1, parts = 1;
  bool is_finished = false;
};

/// How the files of a study are called; docs/manual/study.md.
class StudyFiles {
 public:
  /// @param output a folder, or the name of the result with .nc at its end
  explicit StudyFiles(const std::string& output);

  std::string result() const { return stem_ + ".nc"; }
  std::string table() const { return stem_ + ".csv"; }
  std::string page() const { return stem_ + ".html"; }
  std::array<std::string, 3> outputs() const { return {result(), table(), page()}; }

  /// Rows of a part while they are computed, and when all are there.
  std::string growing(std::uint64_t part, std::uint64_t parts) const;
  std::string finished(std::uint64_t part, std::uint64_t parts) const;

  /// What a task of a cluster prints while it computes a part.
  std::string log(std::uint64_t part, std::uint64_t parts) const;
  std::string merge_log() const { return stem_ + ".merge.log"; }

  std::string folder() const;
  /// The start of all names, without the folder.
  std::string name() const;

  /// Makes the folder if it is missing. Throws OutputError.
  void make_folder() const;

  /// All existing parts, in their order.
  std::vector<PartFile> parts() const;

 private:
  std::string stem_;  ///< with its folder
};

}  // namespace ringfilm::app
