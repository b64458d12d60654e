#pragma once
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "ringfilm/base/error.hpp"
#include "ringfilm/io/result/result_file.hpp"
#include "ringfilm/study/ensemble/assumed_inputs.hpp"

namespace ringfilm::io {

/// The values of the cycle as one flat JSON object, SI with angles in degrees: title, every entry of
/// cycle::cycle_quantities(), of an unrolled film of cycle::unrolled_cycle_quantities(), and every derived constant by
/// its name, then `units`, `notes`, `assumed`, `effort`, what computed it (`program`, `commit`, ...) and `complete`;
/// with published values `comparison`; with an error estimate also `errors`, by the same names and in the same units,
/// and `error_estimate` with the grids that were integrated and `order_in_cells` and `order_in_step` as seen. JSON has
/// no NaN: such a value is null.
std::string result_json(const ResultDocument& document);

/// Rows of a comparison with published values, each with every member of its record.
nlohmann::ordered_json comparison_array(const std::vector<study::ComparisonRow>& rows);

/// What `ringfilm check` finds out about a case.
struct CaseCheck {
  std::string path;                                          ///< path of the case
  std::vector<CaseEntry> inputs;                             ///< all keys in use
  std::vector<std::vector<study::LedgerEntry>> assumptions;  ///< modelling assumptions of each ring; none of a pad
  std::vector<cycle::Note> notes;                            ///< those of reading with the topic "input"
  /// What the assumed inputs decide, the first most; absent where it was not computed.
  std::optional<std::vector<study::AssumedInput>> assumed_inputs = {};
};

/// The check of a case as JSON: "stated" and "default_inputs", "modelling_assumptions" and "notes", "assumed_inputs"
/// (null where they were not computed), and "errors", which is empty.
std::string check_json(const CaseCheck& check);

/// What is wrong with a case as JSON: "case" and "errors", each with its file, line, column and text of the line (null
/// where it has no place in a file), message and remedy (null where there is none).
std::string errors_json(const std::string& case_path, const std::vector<Fault>& faults);

}  // namespace ringfilm::io
