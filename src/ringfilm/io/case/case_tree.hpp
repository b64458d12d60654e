#pragma once
#include <set>
#include <string>
#include <vector>

#include "ringfilm/case/case.hpp"
#include "ringfilm/io/case/case_file.hpp"
#include "ringfilm/io/text/toml_tree.hpp"

namespace ringfilm::io {

/// All keys of a case, from its file, the files it includes, its oil file and the command line; each key once and
/// known.
struct CaseTree {
  std::string path;  ///< path of the case file, as named
  std::vector<TomlEntry> entries;
  std::vector<cycle::InputFile> files;
  std::vector<std::string> notes;
  std::vector<Fault> faults;            ///< unknown and repeated keys, files that cannot be read
  std::set<std::string> faulty;         ///< keys, or whole sections ("engine."), that cannot be checked further
  std::set<std::string> from_oil_file;  ///< keys that describe the oil, whether this case has a use for them or not
  std::set<std::string> assumed;        ///< keys whose line, or the header of a section of theirs, has a comment with
                                        ///< the word "assumed"
  bool complete = true;                 ///< false: a file is missing, so that keys may be
};

/// Throws InputError if the case file itself cannot be read; all other faults are reported in the tree.
/// @param dropped receives the keys of files that state in another way what an override states, which are omitted;
/// nullptr: they are faults
CaseTree read_case_tree(const std::string& path, const std::vector<Override>& overrides,
                        std::vector<DroppedKey>* dropped = nullptr);

/// The keys that an oil file states of [lubricant], by their whole names, and what has no place in it as faults.
/// @param folder folder of the file
std::vector<TomlEntry> oil_entries(const TomlValue& root, const std::string& folder, std::vector<Fault>& faults);

/// The keys of the case of each ring, as a file of its own would have them.
struct PackTrees {
  std::vector<CaseTree> trees;  ///< one where the case is not a ring pack
  bool is_pack = false;
  std::vector<Fault> faults;             ///< faults of the pack as a whole
  std::vector<Fault> missing_pressures;  ///< faults on pressures between two rings that the case does not state
};

/// Cuts the tree of a ring pack ([[ring]] sections, whose keys are "ring.1.face_width", ...) into those of its rings.
/// The gas pressure below a ring is that above the next one; `contact` in a ring replaces keys of [contact] for it.
PackTrees pack_trees(CaseTree tree);

}  // namespace ringfilm::io
