#pragma once
#include <set>
#include <string>
#include <vector>

#include "ringfilm/base/error.hpp"
#include "ringfilm/case/case.hpp"
#include "ringfilm/io/case/case_entry.hpp"
#include "ringfilm/io/text/units.hpp"

namespace ringfilm::io {

/// `--set key=value` of the command line: the value is read as TOML, else as text; an empty value removes the key, so
/// that another way to state the same (a ring's tension, a gas model) can replace it.
struct Override {
  std::string key;               ///< "engine.bore"
  std::string value;             ///< as written, e.g. "89 mm"; empty: the key is removed
  std::string option = "--set";  ///< option of the command line that states it, for messages
};

/// A key of a file that overrides make unused, or state in another way.
struct DroppedKey {
  std::string key;  ///< name of the key with its section
  SourceMark mark;  ///< place of the key
};

using cycle::CasePurpose;

/// Reads a case with its includes, oil file, traces and points; overrides come last and replace.
/// Throws one InputError with every fault found in all files. File names are relative to the file that names them,
/// those of an override to the working folder; `data/lubricants/...` falls back to the shipped folder.
cycle::Case read_case(const std::string& path, const std::vector<Override>& overrides = {});

/// Reads a case for a purpose, with units at hand.
cycle::Case read_case(const std::string& path, const std::vector<Override>& overrides, const Units& units,
                      CasePurpose purpose = CasePurpose::kFilm);

/// Reads a case whose overrides may make keys of the files unused: those are dropped from the case and put into
/// `dropped`. A key that the files alone leave unused, or an override that is unused itself, is an error.
cycle::Case read_case_dropping(const std::string& path, const std::vector<Override>& overrides, const Units& units,
                               std::vector<DroppedKey>& dropped, CasePurpose purpose = CasePurpose::kFilm);

/// The static closure of the ring of a case (cycle::Problem::kClosure): keys that only film and cycle use may be stated
/// or missing. Throws InputError, of a pad, too.
cycle::Case read_closure_case(const std::string& path, const std::vector<Override>& overrides, const Units& units,
                              std::vector<DroppedKey>& dropped);

/// Keys whose line in the case file, or the header of their section, has a comment with the word "assumed", of a ring
/// of a pack as "ring.2.face_width"; not those that overrides state. Throws InputError where the file cannot be read.
std::set<std::string> keys_called_assumed(const std::string& path, const std::vector<Override>& overrides);

/// "ring.elastic_pressure (my.toml:31), ...", for messages.
std::string listed(const std::vector<DroppedKey>& dropped);

/// The ring pack of these cases, of one engine and one or more rings, from the chamber to the crankcase.
cycle::Case ring_pack(std::vector<cycle::Case> rings);

/// The keys of a ring pack from those of the cases of its rings: those of the engine once, then those of each ring.
std::vector<CaseEntry> pack_entries(const std::vector<std::vector<CaseEntry>>& rings);

/// The active keys with the values in use, in table order.
std::vector<CaseEntry> case_entries(const cycle::Case& c);

/// A complete case file in SI that gives the same bits again: every active key, an oil file written out key by key.
/// Traces and tables are named by path, as seen from the working folder of the run.
std::string resolved_case(const cycle::Case& c);

/// A case file of these entries; the keys of the rings of a pack (`ring.2.face_width`) are in [[ring]] sections.
std::string case_text(const std::vector<CaseEntry>& entries);

}  // namespace ringfilm::io
