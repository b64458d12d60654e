#pragma once
#include <string>
#include <vector>

#include "ringfilm/io/result/result_file_quantities.hpp"

/// What a result file holds of an unrolled film alone: a part of the description in result_file_layout.hpp.
namespace ringfilm::io {

template <class File, class Result>
void exchange_unrolled_curves(File& file, Result& result) {
  if constexpr (File::kReads) result.unrolled_samples.resize(result.samples.size());
  for (const auto& quantity : cycle::unrolled_quantities()) {
    file.column("crank_angle", quantity, result.unrolled_samples, quantity.value);
  }
  for (const auto& quantity : cycle::unrolled_cycle_quantities()) {
    file.scalar(cycle_variable(quantity), result.unrolled_values.*quantity.value);
  }
}

/// Each of the fields if it was kept.
template <class File, class Unrolled>
void exchange_unrolled_fields(File& file, const std::vector<const char*>& grid,
                              const std::vector<cycle::UnrolledField>& fields, const std::string& prefix,
                              Unrolled& unrolled) {
  for (const cycle::UnrolledField& field : fields) {
    cycle::Quantity variable = field;
    variable.name = prefix + field.name;
    exchange_present(file, grid, variable, unrolled.*field.values);
  }
}

/// Nothing of a film across the face: its file has no y. After the curves, and after the fields along the face, whose
/// x and crank angles these have as well.
template <class File, class Result>
void exchange_unrolled(File& file, Result& result) {
  auto& unrolled = result.unrolled;
  file.numbers({"y"}, described("y", "m", "position around the ring, from one end of its gap to the other", "y"),
               unrolled.y);
  if (unrolled.y.empty()) return;
  file.scalar(described("ring_circumference", "m", "circumference of the bore", "pi B"), unrolled.circumference);
  file.scalar(described("ring_end_gap", "m", "gap between the ends of the ring, 0: a closed ring", "g"),
              unrolled.end_gap);
  file.scalar(described("ring_gap_position", "rad", "where around the bore the middle of the gap is", "psi_g"),
              unrolled.gap_position);
  if constexpr (File::kReads) {
    unrolled.x = result.fields.x;
    unrolled.crank_angle_deg = result.fields.crank_angle_deg;
  }
  exchange_unrolled_curves(file, result);
  exchange_unrolled_fields(file, {"field_crank_angle", "y", "x"}, cycle::unrolled_fields(), "unrolled_", unrolled);
  exchange_unrolled_fields(file, {"field_crank_angle", "y"}, cycle::strip_fields(), "", unrolled);
}

}  // namespace ringfilm::io
