#pragma once
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "ringfilm/io/life/life_output.hpp"

namespace ringfilm::io {

/// Units of the names in wear_object() that no state has.
nlohmann::ordered_json wear_units();

/// How a scenario of wear was integrated, and its coefficients.
nlohmann::ordered_json wear_object(const LifeDocument& document);

/// The measured faces above their lowest points, at the places of the life's faces.
nlohmann::ordered_json measured_faces(const LifeDocument& document);

/// A running time in hours; null where there is none.
nlohmann::ordered_json hours_or_null(const std::optional<double>& time);

}  // namespace ringfilm::io
