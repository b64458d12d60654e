#pragma once
#include <cstddef>
#include <nlohmann/json_fwd.hpp>

#include "ringfilm/io/result/result_file.hpp"

namespace ringfilm::report {

/// What the page shows of a ring pack as a whole: sums of its rings, oil at the chamber, gas between the rings.
/// @param first_case index of its first ring among the cases of the page
nlohmann::ordered_json pack_payload(const io::ResultDocument& pack, std::size_t first_case);

/// The gas between the rings: values and curves over crank angle.
nlohmann::ordered_json gas_alone_payload(const io::PackGas& gas);

}  // namespace ringfilm::report
