#pragma once
#include <string>
#include <vector>

#include "ringfilm/io/result/result_file.hpp"
#include "ringfilm/pad/pad_result.hpp"

namespace ringfilm::io {

/// What is reported of a pad: the case as it was used, and the result.
struct PadDocument {
  std::string title;                     ///< Case::title
  std::vector<CaseEntry> inputs;         ///< the active keys with the values in use, in table order
  std::vector<std::string> input_notes;  ///< Case::notes
  Provenance provenance;                 ///< what computed it
  pad::PadResult result;                 ///< up to the last good instant where it stopped
};

/// The numbers of the last instant as one flat JSON object, SI: title, every entry of
/// pad::reported_quantities() and of pad::front_quantities() by its name; for an integration in
/// time `history` with the same as arrays; then `units`, `notes`, `assumed`, `effort`, `program`, `commit`, `kernels`
/// and `complete`. JSON has no NaN: such a value is null.
std::string pad_json(const PadDocument& document);

/// The film along the pad, with a width on the strip next to its middle, as CSV text: a row for each node at each
/// instant, two with the same x at a step of the gap, columns pad::profile_quantities(), header `name [unit]` or `name`
/// alone if dimensionless; each number in the fewest digits that give it back exactly.
std::string pad_csv(const pad::PadResult& result);

}  // namespace ringfilm::io
