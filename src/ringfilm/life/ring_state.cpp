#include "ringfilm/life/ring_state.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "ringfilm/case/case_face.hpp"
#include "ringfilm/cycle/setup/contact_setup.hpp"
#include "ringfilm/life/wear/run_in_depth.hpp"
#include "ringfilm/models/ring.hpp"

namespace ringfilm::life {
namespace {

using cycle::FaceForm;

models::RingFace model_of(const cycle::RingFace& face, double width) {
  return face.form == FaceForm::kPoints ? models::RingFace::points(face.x, face.height, width)
                                        : cycle::face_of_formula(face, width);
}

/// What a face has in common with those that are made of it: neither formula nor points, nor where they came from.
cycle::RingFace without_shape(const cycle::RingFace& face) {
  cycle::RingFace bare;
  bare.height_zero = face.height_zero;
  bare.orientation = face.orientation;
  return bare;
}

/// Coefficients in m over x in m, as many as `n`, with the lowest point of the face at zero.
std::vector<double> coefficients_from_minimum(const cycle::RingFace& face, double width, std::size_t n) {
  std::vector<double> in_si(n, 0.0);
  double scale = face.height_unit;
  for (std::size_t power = 0; power < face.coefficients.size(); ++power) {
    in_si[n - 1 - power] = face.coefficients[face.coefficients.size() - 1 - power] * scale;
    scale /= face.length_unit;
  }
  in_si.back() -= model_of(face, width).minimum().height;
  return in_si;
}

cycle::RingFace interpolated_polynomial(const cycle::RingFace& a, const cycle::RingFace& b, double share,
                                        double width) {
  const std::size_t n = std::max(a.coefficients.size(), b.coefficients.size());
  const std::vector<double> from = coefficients_from_minimum(a, width, n), to = coefficients_from_minimum(b, width, n);
  cycle::RingFace face = without_shape(a);
  face.form = FaceForm::kPolynomial;
  face.length_unit = face.height_unit = 1;
  for (std::size_t k = 0; k < n; ++k) face.coefficients.push_back((1 - share) * from[k] + share * to[k]);
  return face;
}

/// At the nodes of the film's grid, halfway between them and at the points of both faces, where the slope may jump.
cycle::RingFace interpolated_points(const cycle::RingFace& a, const cycle::RingFace& b, double share, double width,
                                    int cells) {
  const models::RingFace from = model_of(a, width), to = model_of(b, width);
  const double lowest_from = from.minimum().height, lowest_to = to.minimum().height;
  cycle::RingFace face = without_shape(a);
  face.form = FaceForm::kPoints;
  for (int i = 0; i <= 2 * cells; ++i) face.x.push_back(i == 2 * cells ? width : width * i / (2 * cells));
  for (const cycle::RingFace* one : {&a, &b}) {
    if (one->form != FaceForm::kPoints) continue;
    for (const double x : one->x) {
      if (x > 0 && x < width) face.x.push_back(x);
    }
  }
  std::sort(face.x.begin(), face.x.end());
  face.x.erase(std::unique(face.x.begin(), face.x.end()), face.x.end());
  for (const double x : face.x) {
    face.height.push_back((1 - share) * (from.height(x) - lowest_from) + share * (to.height(x) - lowest_to));
  }
  return face;
}

double log_interpolated(double from, double to, double share) {
  if (from == to) return from;
  const bool is_positive = from > 0 && to > 0;  // zeta alone may be zero
  return is_positive ? from * std::pow(to / from, share) : (1 - share) * from + share * to;
}

}  // namespace

RingState ring_state_of(const cycle::Case& c) {
  const double sigma = c.contact.plateau.is_stated() ? cycle::roughness(c) : c.contact.roughness;
  return {c.ring.face, c.contact.asperity_density,  c.contact.asperity_radius,
          sigma,       c.contact.roughness_measure, c.contact.boundary_shear_strength_coefficient};
}

cycle::Case with_ring_state(cycle::Case c, const RingState& state) {
  c.ring.face = state.face;
  c.contact.asperity_density = state.asperity_density;
  c.contact.asperity_radius = state.asperity_radius;
  c.contact.roughness = state.roughness;
  c.contact.roughness_measure = state.roughness_measure;
  if (state.Rpq) c = cycle::with_plateau_roughness(std::move(c), *state.Rpq);
  c.contact.boundary_shear_strength_coefficient = state.boundary_shear_strength_coefficient;
  return c;
}

double run_in_roughness(const cycle::Case& c) {
  const auto curve = cycle::plateau_curve(c.contact);
  return curve ? curve->Rpq : c.contact.roughness;
}

RingState run_in_state(const cycle::Case& c, double roughness) {
  const bool has_plateau = c.contact.plateau.is_stated();
  cycle::Case smoother = has_plateau ? cycle::with_plateau_roughness(c, roughness) : c;
  if (!has_plateau) smoother.contact.roughness = roughness;
  RingState state = ring_state_of(smoother);
  state.asperity_radius *= cycle::asperity_roughness(c) / cycle::asperity_roughness(smoother);
  if (has_plateau) state.Rpq = roughness;
  return state;
}

double least_depth_scale(const cycle::Case& c, double limit) {
  const double stated = run_in_roughness(c);
  const double rms = c.contact.plateau.is_stated() ? stated : cycle::asperity_roughness(c);
  return kMeanPeakHeight * rms * (1 - limit / stated);
}

RingState turned(RingState state) {
  using cycle::Orientation;
  Orientation& orientation = state.face.orientation;
  if (orientation == Orientation::kX0Chamber) {
    orientation = Orientation::kX0Crankcase;
  } else if (orientation == Orientation::kX0Crankcase) {
    orientation = Orientation::kX0Chamber;
  }
  return state;
}

RingState with_part(RingState earlier, const RingState& later, Part part) {
  switch (part) {
    case Part::kFace:
      earlier.face = later.face;
      earlier.gap = later.gap;
      break;
    case Part::kRoughness:
      earlier.asperity_density = later.asperity_density;
      earlier.asperity_radius = later.asperity_radius;
      earlier.roughness = later.roughness;
      earlier.roughness_measure = later.roughness_measure;
      earlier.Rpq = later.Rpq;
      break;
    case Part::kShearStrength:
      earlier.boundary_shear_strength_coefficient = later.boundary_shear_strength_coefficient;
      break;
  }
  return earlier;
}

RingState interpolated(const RingState& earlier, const RingState& later, double share, double width, int cells) {
  const bool are_polynomials = earlier.face.form == FaceForm::kPolynomial && later.face.form == FaceForm::kPolynomial;
  RingState state;
  state.face = are_polynomials ? interpolated_polynomial(earlier.face, later.face, share, width)
                               : interpolated_points(earlier.face, later.face, share, width, cells);
  state.asperity_density = log_interpolated(earlier.asperity_density, later.asperity_density, share);
  state.asperity_radius = log_interpolated(earlier.asperity_radius, later.asperity_radius, share);
  state.roughness = log_interpolated(earlier.roughness, later.roughness, share);
  state.roughness_measure = earlier.roughness_measure;
  state.boundary_shear_strength_coefficient =
      log_interpolated(earlier.boundary_shear_strength_coefficient, later.boundary_shear_strength_coefficient, share);
  return state;
}

double path_share(const Interpolation& path, double from, double to, double time) {
  if (path.scale == TimeScale::kLinear) return (time - from) / (to - from);
  const auto s = [&path](double t) { return std::log1p(t / path.time_constant); };
  return (s(time) - s(from)) / (s(to) - s(from));
}

StateOrigin state_origin_at(const std::vector<MeasuredState>& states, double time) {
  const bool is_measured =
      std::any_of(states.begin(), states.end(), [&](const MeasuredState& one) { return one.time == time; });
  if (is_measured) return StateOrigin::kMeasured;
  return time > states.back().time ? StateOrigin::kHeld : StateOrigin::kInterpolated;
}

RingState state_on_path(const std::vector<MeasuredState>& states, const Interpolation& path, double time, int cells) {
  const auto later =
      std::lower_bound(states.begin(), states.end(), time,
                       [](const MeasuredState& one, double running_time) { return one.time < running_time; });
  if (later == states.end()) return ring_state_of(states.back().input);
  if (later->time == time) return ring_state_of(later->input);
  if (later == states.begin()) throw std::invalid_argument("a running time before the first state");
  const MeasuredState& earlier = *(later - 1);
  return interpolated(ring_state_of(earlier.input), ring_state_of(later->input),
                      path_share(path, earlier.time, later->time, time), later->input.ring.face_width, cells);
}

}  // namespace ringfilm::life
