#pragma once
#include <nlohmann/json.hpp>
#include <vector>

#include "ringfilm/cycle/pack/oil_consumption.hpp"

namespace ringfilm::io {

/// The oil consumption as `oil_consumption` of `ringfilm run --json`: the band of the total of one cylinder, then each
/// part and each sum for the engine by its name, with its band and its assumption, and in `narrowed_by` what
/// narrows the band of the total, in falling order; SI units in `units`.
nlohmann::ordered_json oil_consumption_object(const std::vector<cycle::OilLoss>& losses);

}  // namespace ringfilm::io
