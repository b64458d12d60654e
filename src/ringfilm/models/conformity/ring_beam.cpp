#include "ringfilm/models/conformity/ring_beam.hpp"

#include <cmath>
#include <numbers>
#include <string>

#include "ringfilm/base/display.hpp"
#include "ringfilm/base/error.hpp"

namespace ringfilm::models {
namespace {

using std::numbers::pi;

void check_beam(const RingBeamSize& size, const FourierSeries& orders) {
  const auto positive = [](double x) { return x > 0 && std::isfinite(x); };
  if (!positive(size.bore)) throw InputError("the bore is not a positive length", "for example \"89 mm\"");
  if (!positive(size.face_width) || !positive(size.radial_thickness)) {
    throw InputError("the section of the ring, " + text_in(size.face_width, kMillimetre) + " by " +
                         text_in(size.radial_thickness, kMillimetre) + ", has no positive second moment",
                     "state a positive ring.face_width and ring.radial_thickness");
  }
  if (!(size.radial_thickness < size.bore / 2)) {
    throw InputError("ring.radial_thickness = " + text_in(size.radial_thickness, kMillimetre) + " fills a bore of " +
                         text_in(size.bore, kMillimetre),
                     "a thin ring is about 1/25 of the bore thick");
  }
  if (!positive(size.youngs_modulus) || !positive(size.tangential_force)) {
    throw InputError("Young's modulus and the tangential force of the ring must be positive",
                     "for example \"203 GPa\" and \"10.7 N\"");
  }
  const double most = pi * (size.bore - size.radial_thickness) / 2;
  if (!(size.end_gap >= 0 && size.end_gap < most)) {
    throw InputError(
        "ring.end_gap = " + text_in(size.end_gap, kMillimetre) + " leaves less than half of the circumference",
        "a ring that holds itself in the bore has an end gap below " + text_in(most, kMillimetre));
  }
  for (const FourierOrder& one : orders.orders()) {
    if (one.order >= 2) continue;
    throw InputError("a pressure of order " + std::to_string(one.order) + " is not in balance on the ring",
                     "orders of ring.pressure_orders are 2 or higher; the mean follows from the tension");
  }
}

}  // namespace

/// y'' + y = force with y = y' = 0 at `start`.
RingBeam::Response RingBeam::response(const FourierOrder& force, double start, double phi) {
  const double n = force.order, turn = n * force.phase, x = phi - start;
  if (force.order == 1) {
    return {force.amplitude / 2 *
                (x * std::sin(phi - turn) + (std::cos(phi - turn) - std::cos(phi + turn - 2 * start)) / 2),
            force.amplitude / 2 *
                (x * std::cos(phi - turn) + (std::sin(phi - turn) + std::sin(phi + turn - 2 * start)) / 2)};
  }
  const double size = force.amplitude / (1 - n * n), at = n * start - turn;
  return {size * (std::cos(n * phi - turn) - std::cos(at) * std::cos(x) + n * std::sin(at) * std::sin(x)),
          size * (-n * std::sin(n * phi - turn) + std::cos(at) * std::sin(x) + n * std::sin(at) * std::cos(x))};
}

RingBeam::Response RingBeam::response(double phi) const {
  Response sum{0, 0};
  for (const FourierOrder& one : force_.orders()) {
    const Response of_order = response(one, half_gap_, phi);
    sum.value += of_order.value;
    sum.slope += of_order.slope;
  }
  return sum;
}

RingBeam::RingBeam(const RingBeamSize& size, const FourierSeries& pressure_orders) : size_(size) {
  check_beam(size, pressure_orders);
  r_ = size.centroid_radius();
  k_ = size.youngs_modulus * second_moment() / (r_ * r_);
  half_gap_ = size.end_gap / (2 * r_);
  std::vector<FourierOrder> orders{{0, size.tangential_force, 0}};
  for (const FourierOrder& one : pressure_orders.orders()) {
    orders.push_back({one.order, one.amplitude * size.tangential_force, one.phase});
  }
  force_ = FourierSeries(orders);
  // No resultant: value and slope of the moment at the far end vanish with the right terms of order 1.
  const double end = 2 * pi - half_gap_;
  const Response of_target = response(end);
  const Response of_cosine = response({1, 1, 0}, half_gap_, end), of_sine = response({1, 1, pi / 2}, half_gap_, end);
  const double determinant = of_cosine.value * of_sine.slope - of_sine.value * of_cosine.slope;
  const double cosine = (of_sine.value * of_target.slope - of_target.value * of_sine.slope) / determinant;
  const double sine = (of_target.value * of_cosine.slope - of_cosine.value * of_target.slope) / determinant;
  projection_ = std::hypot(cosine, sine) / size.tangential_force;
  orders.push_back({1, std::hypot(cosine, sine), std::atan2(sine, cosine)});
  force_ = FourierSeries(std::move(orders));
}

double RingBeam::second_moment() const {
  if (size_.section_second_moment) return *size_.section_second_moment;
  const double t = size_.radial_thickness;
  return size_.face_width * t * t * t / 12;
}

double RingBeam::target_moment(double phi) const { return r_ * response(phi).value; }
double RingBeam::target_moment_slope(double phi) const { return r_ * response(phi).slope; }

}  // namespace ringfilm::models
