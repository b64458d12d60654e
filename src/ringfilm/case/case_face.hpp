#pragma once
#include <algorithm>
#include <stdexcept>
#include <utility>
#include <vector>

#include "ringfilm/case/case.hpp"
#include "ringfilm/models/ring.hpp"

namespace ringfilm::cycle {

/// The face of a form other than points. @param width that x runs over [m]
inline models::RingFace face_of_formula(const FaceShape& shape, double width) {
  switch (shape.form) {
    case FaceForm::kPolynomial:
      return models::RingFace::polynomial(shape.coefficients, shape.length_unit, shape.height_unit, width);
    case FaceForm::kParabola:
      return models::RingFace::parabola(shape.crown_height, shape.apex, width);
    case FaceForm::kCosine:
      return models::RingFace::cosine(shape.crown_height, shape.apex, width);
    case FaceForm::kPoints:
      break;
  }
  throw std::logic_error("points are not a formula of a face");
}

/// The lowest point of the gap of a pad, by its formula or among its points.
inline models::RingFace::Minimum lowest_point(const Pad& pad) {
  if (pad.has_formula()) return face_of_formula(pad.face, pad.length).minimum();
  const auto lowest = std::min_element(pad.gap_height.begin(), pad.gap_height.end());
  return {pad.gap_x[(lowest - pad.gap_height.begin()) % pad.gap_x.size()], *lowest};
}

/// Begin and end of each groove of the pad, cut off at its ends [m].
inline std::vector<std::pair<double, double>> groove_ends(const Pad& pad) {
  std::vector<std::pair<double, double>> ends;
  for (const double position : pad.grooves.positions) {
    const double middle = position * pad.length, half = 0.5 * pad.grooves.width;
    ends.emplace_back(std::max(middle - half, 0.0), std::min(middle + half, pad.length));
  }
  return ends;
}

}  // namespace ringfilm::cycle
