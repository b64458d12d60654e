#pragma once
#include <set>
#include <string>
#include <vector>

#include "ringfilm/cycle/case/case.hpp"
#include "ringfilm/io/case/case_file.hpp"
#include "ringfilm/io/text/toml_tree.hpp"

namespace ringfilm::io {

/// All keys of a case, from its file, the files it includes, its oil file and the command line; each key once and
/// known.
struct CaseTree {
  std::string path;  ///< of the case file, as named
  std::vector<TomlEntry> entries;
  std::vector<cycle::InputFile> files;
  std::vector<std::string> notes;
  std::vector<Fault> faults;            ///< unknown and repeated keys, files that cannot be read
  std::set<std::string> faulty;         ///< keys, or whole sections ("engine."), on which nothing more can be said
  std::set<std::string> from_oil_file;  ///< keys that describe the oil, whether this case has a use for them or not
  bool complete = true;                 ///< false: a file is missing, so that keys may be
};

/// Throws InputError if the case file itself cannot be read; all other faults are reported in the tree.
CaseTree read_case_tree(const std::string& path, const std::vector<Override>& overrides);

}  // namespace ringfilm::io
