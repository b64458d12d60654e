#pragma once
#include <string>
#include <tuple>
#include <vector>

#include "ringfilm/base/members.hpp"
#include "ringfilm/case/case.hpp"

/// Which assumed inputs decide the result of a case most: each changed alone.
namespace ringfilm::study {

/// A number that was assumed, and what another value makes of friction and film.
struct AssumedInput {
  std::string key;             ///< "ring.2.elastic_pressure"
  std::string value;           ///< value in use, "0.2 MPa"
  bool is_default = true;      ///< does the case not state it? Else a comment of its file calls it assumed
  std::string setting;         ///< what was computed, "ring.2.elastic_pressure = \"0.24 MPa\""
  double fmep_change = 0;      ///< change of the friction mean effective pressure, of a pack of all rings [-]
  double min_film_change = 0;  ///< change of the minimum film thickness, of a pack that of the thinnest film [-]
  bool solved = true;          ///< did the changed case reach its end?
};

/// The members of an assumed input, as all outputs have them.
constexpr auto members(const AssumedInput*) {
  using A = AssumedInput;
  return std::tuple{
      Member{"key", "", "key of the assumed input", &A::key},
      Member{"value", "", "value in use", &A::value},
      Member{"is_default", "1", "1 where the case does not state it", &A::is_default},
      Member{"setting", "", "the one setting that was changed", &A::setting},
      Member{"fmep_change", "1", "relative change of the FMEP", &A::fmep_change},
      Member{"min_film_change", "1", "relative change of the minimum film thickness", &A::min_film_change},
      Member{"solved", "1", "1 where the changed case was solved", &A::solved}};
}

/// The case as it is computed to see the size of a change: without fields, between two menisci where it has such a film
/// (FMEP within 1 % for 98 % of random engines, docs/theory/menisci.md), else on half of the usual cells with a
/// threefold error of the steps (FMEP of the shipped pack 0.7 % lower).
cycle::Case coarse_case(cycle::Case c);

/// Does the coarse case take some hundredths of a second? Where it has a film between two menisci.
bool is_quick(const cycle::Case& c);

/// The largest change of the FMEP first, then those that were not solved.
void rank(std::vector<AssumedInput>& inputs);

}  // namespace ringfilm::study
