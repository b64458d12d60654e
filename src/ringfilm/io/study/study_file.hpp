#pragma once
#include <string>
#include <vector>

#include "ringfilm/case/case.hpp"
#include "ringfilm/study/design/study.hpp"

namespace ringfilm::io {

/// A study as its file states it.
struct StudyFile {
  study::Study study;  ///< bases read, numbers in SI
  /// The study's own file, then every file that its bases, choices and list were read from, each once.
  std::vector<cycle::InputFile> files;
};

/// Reads a study with its bases and all that they name. File names are relative to the study's file. Throws one
/// InputError with every fault found; what joins factors and plan is checked by study::Plan.
StudyFile read_study(const std::string& path);
/// Reads a study whose file names are relative to `folder`; empty for the working folder.
StudyFile read_study(const std::string& path, const std::string& folder);

}  // namespace ringfilm::io
