#include "ringfilm/cycle/setup/ring_conditions.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>

#include "ringfilm/case/conditions.hpp"
#include "ringfilm/cycle/setup/kinematics.hpp"

namespace ringfilm::cycle {

double pressure_behind_ring(const Gas& gas, double above, double below) {
  // With a share of 1 that is `above` to the last bit.
  return gas.pressure_behind_ring * above + (1 - gas.pressure_behind_ring) * below;
}

namespace {

/// Rise above the walls [K], eq-viscous-heating-step: that of the step before in proportion to the viscosity, which
/// falls with the rise.
double rise_of_step(const OilSetup& oil, double wall_temperature, const HeatBefore& before) {
  if (before.rise == 0) return 0;
  const double cold = before.rise * oil.range->viscosity(wall_temperature) / before.viscosity;
  const double high = std::min(cold, oil.hottest - wall_temperature);
  if (high <= 0) return 0;
  const auto excess = [&](double rise) {
    return rise - before.rise * oil.range->viscosity(wall_temperature + rise) / before.viscosity;
  };
  const double at_high = excess(high);
  if (at_high <= 0) return high;
  constexpr double kTolerance = 1e-9;  // [K]
  boost::uintmax_t most = 100;
  const auto [low_end, high_end] = boost::math::tools::toms748_solve(
      excess, 0.0, high, -cold, at_high, [](double a, double b) { return b - a < kTolerance; }, most);
  return 0.5 * (low_end + high_end);
}

}  // namespace

RingConditions ring_conditions(const Setup& setup, double crank_angle_deg, double time_step, const HeatBefore& before) {
  const double angle = wrapped(crank_angle_deg);
  const RingSetup& ring = setup.ring;
  const Case& c = setup.input;
  const double above = ring.lands.above.pressure(angle), below = ring.lands.below.pressure(angle);
  const double U = setup.engine.crank.velocity(radians(angle), setup.engine.speed);
  const bool turned =
      c.ring.face.orientation == Orientation::kLeadingEdge && motion(angle) == Motion::kTowardsCrankcase;

  RingConditions at;
  at.axis = turned ? Axis::kFromCrankcase : Axis::kFromChamber;
  at.piston_velocity = U;
  at.crank_angle_deg = angle;
  at.below_tdc = setup.engine.crank.position(radians(angle));
  at.inputs.U = turned ? -U : U;
  film::EdgeState chamber{above}, crankcase{below};
  // Where the film leaves, gas may be; where it enters, too, unless oil floods the inlet.
  const bool up = motion(angle) == Motion::kTowardsTdc, flooded = c.film.supply_at_inlet() == OilSupply::kFlooded;
  if (up || !flooded) crankcase.fluid = c.film.crankcase_edge;
  if (!up || !flooded) chamber.fluid = c.film.chamber_edge;
  film::EdgeState& inlet = up ? chamber : crankcase;
  if (!flooded && inlet.fluid == EdgeFluid::kGas) {
    const double place = at.below_tdc + (up ? 0 : c.ring.face_width);
    at.oil_ahead = ring.oil.density * along_stroke(c.supply.film, place);
    inlet.supply = at.oil_ahead;
  }
  at.inputs.left = turned ? crankcase : chamber;
  at.inputs.right = turned ? chamber : crankcase;
  at.inputs.broken = c.film.broken;
  if (c.film.outlet == Outlet::kCapillary) at.inputs.surface_tension = c.lubricant.surface_tension;
  at.inputs.p_cavitation = std::min({c.film.cavitation_pressure, above, below});
  const double behind =
      ring.lands.behind ? ring.lands.behind->pressure(angle) : pressure_behind_ring(c.gas, above, below);
  at.inputs.load = (ring.elastic_pressure + behind) * c.ring.face_width;
  at.inputs.time_step = time_step;
  if (ring.twisting) {
    at.on_section = ring.twisting->gas({above, behind, below});
    at.on_section.axial -= ring.mass * setup.engine.crank.acceleration(radians(angle), setup.engine.speed);
  }
  at.film_temperature = ring.oil.temperature;
  if (ring.oil.walls) at.film_temperature = ring.oil.walls->film(at.below_tdc);
  at.film_temperature += rise_of_step(ring.oil, at.film_temperature, before);
  at.inputs.oil = ring.oil.range->at(at.film_temperature);
  return at;
}

}  // namespace ringfilm::cycle
