#pragma once
#include <stdexcept>

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

}  // namespace ringfilm::cycle
