#pragma once
#include <string>
#include <vector>

#include "ringfilm/io/text/units.hpp"
#include "ringfilm/study/verification/verification.hpp"

namespace ringfilm::io {

/// One folder of verification/: README.md (heading and first paragraph), reference.toml with the tables [[run]],
/// [[value]], [[order]], [[bound]], [[optimum]] and [[curve]], and the cases that they name.
/// docs/manual/verification.md. Throws InputError with every fault of reference.toml, or those of a case.
study::Verification read_verification(const std::string& folder, const Units& units);

/// The folders of verification/ in the shipped folder but that of the trends (trends_file.hpp), by name in alphabetic
/// order. Throws InputError if there is none.
std::vector<std::string> verification_folders();

/// What cannot be checked, from the tables [[not_covered]] of a TOML file, each with what and reason.
std::vector<study::NotCovered> read_not_covered(const std::string& path, const Units& units);

}  // namespace ringfilm::io
