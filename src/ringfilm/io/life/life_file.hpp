#pragma once
#include <string>
#include <vector>

#include "ringfilm/case/case.hpp"
#include "ringfilm/io/case/case_file.hpp"
#include "ringfilm/life/life.hpp"

namespace ringfilm::io {

/// A life as its file states it.
struct LifeFile {
  life::Life life;  ///< cases read, numbers in SI
  /// The life's own file, then every file that its cases were read from, each once.
  std::vector<cycle::InputFile> files;
};

/// Reads a life with all cases that it names; overrides hold for each of them. File names are relative to the life's
/// file. Throws one InputError with every fault found, those of life::faults_of among them.
LifeFile read_life(const std::string& path, const std::vector<Override>& overrides = {});

}  // namespace ringfilm::io
