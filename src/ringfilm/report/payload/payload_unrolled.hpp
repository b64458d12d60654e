#pragma once
#include <nlohmann/json.hpp>
#include <optional>

#include "ringfilm/cycle/result/result.hpp"

namespace ringfilm::report {

/// Pictures of the unrolled film for the script of the page; null where the result has none.
/// @param rupture_pressure rupture pressure of a model without a film content, whose cavities have this pressure [Pa]
nlohmann::ordered_json unrolled_payload(const cycle::UnrolledFields& fields, std::optional<double> rupture_pressure);

/// What the ends of the gap do over a cycle, by name; null without an unrolled film.
nlohmann::ordered_json unrolled_values(const cycle::CycleResult& result);

/// Adds the curves that only an unrolled film has to those of its case, under their names.
void add_unrolled_curves(const cycle::CycleResult& result, int digits, nlohmann::ordered_json& curves);

}  // namespace ringfilm::report
