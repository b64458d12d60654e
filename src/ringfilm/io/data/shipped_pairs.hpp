#pragma once
#include <string>
#include <vector>

#include "ringfilm/io/data/shipped_surfaces.hpp"
#include "ringfilm/io/text/source_text.hpp"
#include "ringfilm/io/text/units.hpp"
#include "ringfilm/models/contact/friction_pair.hpp"

/// Pairs of coating and liner in data/pairs of the shipped folder.
namespace ringfilm::io {

/// The file, as a case anywhere names it.
inline constexpr const char* kPairsFile = "data/pairs/boundary_friction.toml";

/// The pairs of a file and its digest.
struct FrictionPairs {
  std::vector<models::FrictionPair> pairs;
  std::string sha256;
};

/// Reads pairs. Throws InputError with the faults of the file: keys that are unknown or missing, a band that does not
/// enclose the coefficient, a name that comes twice.
FrictionPairs read_friction_pairs(const NamedFile& file, const Units& units);

/// The shipped ones. Throws InputError where the shipped folder is not found.
FrictionPairs shipped_pairs(const Units& units);

/// The pair of that name. Throws InputError that lists the names.
models::FrictionPair pair_of_name(const FrictionPairs& pairs, const std::string& name);

std::string name_of(models::FrictionState state);  ///< "lubricated", "dry"

/// The list for a terminal (`ringfilm pairs`).
std::string pairs_table(const std::vector<models::FrictionPair>& pairs);
/// The lists of pairs, liners and rings as JSON, SI units.
std::string pairs_json(const std::vector<models::FrictionPair>& pairs, const SurfaceClasses& surfaces);

}  // namespace ringfilm::io
