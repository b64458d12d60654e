#include "ringfilm/cycle/integration/sampling.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "ringfilm/base/constants.hpp"
#include "ringfilm/film/cavitation.hpp"
#include "ringfilm/film/gas_holding.hpp"
#include "ringfilm/film/load_balance.hpp"
#include "ringfilm/models/flash_temperature.hpp"
#include "ringfilm/models/gas/gas_flow.hpp"

namespace ringfilm::cycle {
namespace {

/// Quantities that turn with the film's axis, brought to x from the chamber edge.
struct FromChamber {
  double shear_couette, shear_poiseuille;
  double flow_chamber, flow_middle, flow_crankcase;
  double cavity_begin, cavity_end;
  double wetted_begin, wetted_end;
};

/// Value of a position or a film that does not exist.
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

FromChamber from_chamber(const film::FilmIntegrals& f, Axis axis, double width) {
  const double begin = f.cavities.empty() ? kUnknown : f.cavities.front().begin;
  const double end = f.cavities.empty() ? kUnknown : f.cavities.back().end;
  if (axis == Axis::kFromChamber) {
    return {f.shear_couette, f.shear_poiseuille, f.flow_left, f.flow_middle, f.flow_right, begin, end,
            f.wetted_begin,  f.wetted_end};
  }
  return {-f.shear_couette, -f.shear_poiseuille, -f.flow_right,        -f.flow_middle,        -f.flow_left,
          width - end,      width - begin,       width - f.wetted_end, width - f.wetted_begin};
}

double mean_real_pressure(double load, double area, double applied_load) {
  constexpr double kFelt = 0.01;  // share of the load: below it the ratio is one of two negligible numbers
  return load > kFelt * applied_load && area > 0 ? load / area : 0;
}

/// eq-asperity-load-share.
double asperity_load_share(const film::FilmProblem& problem, const Instant& instant,
                           const film::FilmIntegrals& integrals) {
  constexpr double kFelt = 1e-3;  // share of the load: a ring that gas and suction hold has no contact to share it
  film::FilmInputs in = instant.at.inputs;
  in.h_m_before = instant.state->h_m;
  const double by_oil = integrals.hydrodynamic_load - film::edge_pressure_load(problem, std::move(in));
  const double carried = integrals.asperity_load + std::max(by_oil, 0.0);
  return integrals.asperity_load / std::max(carried, kFelt * instant.at.inputs.load);
}

/// eq-gas-holding-margin; NaN where the film leaves into oil or towards the lower pressure.
double gas_holding_margin(const film::FilmGrid& grid, const film::FilmInputs& in, double h_m, film::FilmEdge exit) {
  const bool to_right = exit == film::FilmEdge::kRight;
  const film::EdgeState &outlet = to_right ? in.right : in.left, &inlet = to_right ? in.left : in.right;
  if (outlet.fluid != film::EdgeFluid::kGas || outlet.pressure <= inlet.pressure) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const double held = 6 * std::abs(in.U) * film::gas_holding_integral(grid, h_m, exit) *
                      film::mean_viscosity(*in.oil, inlet.pressure, outlet.pressure);
  return held / (outlet.pressure - inlet.pressure);
}

/// eq-flash-temperature of boundary friction on the whole face [K].
double flash_temperature(const Case& c, double boundary_friction, double speed) {
  const double heat_flux = boundary_friction * speed / (c.ring_length() * c.ring.face_width);
  const Liner& liner = c.liner;
  return models::flash_temperature(heat_flux, c.ring.face_width, speed,
                                   {liner.thermal_conductivity, liner.density, liner.specific_heat});
}

/// eq-face-flow: gas through a film that does not hold it, towards the crankcase [kg/s].
/// @param h_m smallest film thickness [m] @param above @param below pressures at the edges [Pa]
double gas_flow_through_film(const Case& c, double h_m, double above, double below) {
  const GasPath& gas = c.gas_path;
  const RingGasPath& ring = c.ring.gas_path;
  const double temperature = above > below ? ring.computed_temperature_above.value_or(gas.chamber_temperature)
                                           : ring.computed_temperature_below.value_or(gas.crankcase_temperature);
  const models::GasChannel face{c.ring_length(), c.ring.face_width, gas.viscosity, gas.gas_constant, temperature};
  return face.limited_flow({gas.heat_capacity_ratio, gas.choking_smoothing}, h_m, above, below);
}

}  // namespace

double boundary_friction(const Contact& contact, double load, double area) {
  return contact.eyring_shear_stress * area + contact.boundary_shear_strength_coefficient * load;
}

Sample sample(const Setup& setup, const film::FilmProblem& problem, const Instant& instant,
              const film::FilmIntegrals& integrals) {
  const double length = setup.input.ring_length();
  const double angle = instant.crank_angle_deg;
  const film::FilmInputs& in = instant.at.inputs;
  const FromChamber f = from_chamber(integrals, instant.at.axis, problem.grid.width);
  const Motion sense = motion(angle);
  const double sign = sense == Motion::kTowardsTdc ? 1 : -1;
  const double mean_pressure = in.mean_pressure(problem.grid);

  Sample s;
  s.crank_angle_deg = angle;
  s.piston_position = instant.at.below_tdc;
  const bool from_chamber_edge = instant.at.axis == Axis::kFromChamber;
  s.piston_velocity = instant.at.piston_velocity;
  s.sliding_distance = sliding_distance(setup.engine.crank, angle, s.piston_position);
  s.gas_pressure = from_chamber_edge ? in.left.pressure : in.right.pressure;
  s.crankcase_pressure = from_chamber_edge ? in.right.pressure : in.left.pressure;
  s.applied_load = in.load * length;
  s.hydrodynamic_load = integrals.hydrodynamic_load * length;
  s.land_lift = integrals.land_lift * length;
  s.asperity_load = integrals.asperity_load * length;
  s.asperity_load_share = asperity_load_share(problem, instant, integrals);
  s.min_film_thickness = instant.state->h_m;
  s.lambda_ratio = instant.state->h_m / setup.ring.sigma;
  s.asperity_contact_area = integrals.asperity_area * length;
  s.mean_real_pressure = mean_real_pressure(integrals.asperity_load, integrals.asperity_area, in.load);
  s.boundary_friction =
      boundary_friction(setup.input.contact, integrals.asperity_load, integrals.asperity_area) * length;
  s.viscous_friction_liner = (f.shear_couette + f.shear_poiseuille) * length;
  s.viscous_friction_ring = (f.shear_couette - f.shear_poiseuille) * length;
  s.viscous_friction = std::abs(s.viscous_friction_liner);
  s.total_friction = s.boundary_friction + s.viscous_friction;
  s.friction_on_liner = sign * s.boundary_friction + s.viscous_friction_liner;
  s.friction_coefficient = s.total_friction / s.applied_load;
  const double speed = std::abs(s.piston_velocity);
  s.power_loss = s.total_friction * speed;
  s.archard_wear_load_rate = s.asperity_load * speed;
  s.oil_flow_middle = f.flow_middle * length;
  s.oil_flow_chamber_edge = f.flow_chamber * length;
  s.oil_flow_crankcase_edge = f.flow_crankcase * length;
  const OilSetup& oil = setup.ring.oil;
  const bool is_one_temperature = !oil.walls && !setup.input.thermal.is_heated();
  const double eta = is_one_temperature ? oil.viscosity : in.oil->viscosity(base::kAtmosphere);
  s.stribeck_number = eta * speed / (mean_pressure * setup.ring.sigma);
  s.film_temperature = instant.at.film_temperature;
  s.viscous_heating_rise =
      integrals.heating.rise(setup.input.lubricant.thermal_conductivity, setup.input.lubricant.specific_heat);
  s.flash_temperature = flash_temperature(setup.input, s.boundary_friction, speed);
  const bool leaves_at_x_b = (sense == Motion::kTowardsTdc) == from_chamber_edge;
  s.gas_holding_margin = gas_holding_margin(problem.grid, in, instant.state->h_m,
                                            leaves_at_x_b ? film::FilmEdge::kRight : film::FilmEdge::kLeft);
  s.peak_shear_rate = integrals.peak_shear_rate;
  for (const double delta : instant.state->deformation) {
    s.max_local_deformation = std::max(s.max_local_deformation, delta);
  }
  s.twist = instant.state->tilt;
  s.peak_film_pressure = integrals.peak_pressure;
  s.cavitated_fraction = integrals.cavitated_fraction;
  s.wetted_begin = f.wetted_begin;
  s.wetted_end = f.wetted_end;
  if (integrals.is_broken_through) {
    s.gas_breakthrough = 1;
    s.gas_flow_through_film =
        gas_flow_through_film(setup.input, s.min_film_thickness, s.gas_pressure, s.crankcase_pressure);
  }
  const double rho = setup.ring.oil.density;
  const film::EdgeState& trailing = in.U >= 0 ? in.right : in.left;
  const double behind = in.U >= 0 ? integrals.flow_right : -integrals.flow_left;
  const bool is_known = trailing.fluid == film::EdgeFluid::kGas && in.U != 0;
  s.film_ahead = instant.at.oil_ahead > 0 ? instant.at.oil_ahead / rho : kUnknown;
  s.film_left_behind = is_known ? behind / (rho * std::abs(in.U)) : kUnknown;
  s.bead_volume = instant.bead * length / rho;
  s.rupture_position = sense == Motion::kTowardsTdc ? f.cavity_begin : f.cavity_end;
  s.reformation_position = sense == Motion::kTowardsTdc ? f.cavity_end : f.cavity_begin;
  s.newton_iterations = instant.effort.newton_iterations;
  s.crank_sub_steps = instant.effort.steps;
  s.fallbacks = instant.effort.fallbacks;
  s.load_residual = std::abs(integrals.hydrodynamic_load + integrals.asperity_load - in.load) / in.load;
  if (instant.at.off_liner) {  // the ring holds itself
    s.distance_off_liner = s.min_film_thickness;
    s.load_residual = 0;
  }
  return s;
}

FaceFields empty_fields(const Setup& setup, const film::FilmGrid& grid) {
  FaceFields fields;
  fields.x = grid.x;
  fields.face_height = grid.node_height;
  if (setup.input.ring.face.height_zero == HeightZero::kAsGiven) {
    for (double& height : fields.face_height) height += setup.ring.face.minimum().height;
  }
  return fields;
}

void append_fields(const Setup& setup, const TimeIntegration& integration, const Instant& instant, FaceFields& fields) {
  const film::FilmProblem& problem = integration.problem();
  const film::FilmState& state = *instant.state;
  const int n = problem.grid.n_cells();
  const int strip = integration.film2d() == nullptr ? 0 : integration.film2d()->around.halfway();
  fields.crank_angle_deg.push_back(instant.crank_angle_deg);
  const double separation = state.h_m + integration.rise(state, strip);
  const double closed = integration.film2d() == nullptr ? 0 : film::closed_film(*integration.film2d());
  const double of_contact = film::closed_separation(separation, closed);
  for (int k = 0; k <= n; ++k) {
    const int i = instant.at.axis == Axis::kFromChamber ? k : n - k;
    const double height = problem.grid.node_height[i], h = separation + height;
    const bool local = problem.contact_spread == film::ContactSpread::kLocal;
    fields.film_thickness.push_back(h);
    if (!state.deformation.empty()) fields.local_deformation.push_back(state.deformation[i]);
    const std::size_t at = static_cast<std::size_t>(strip) * (n + 1) + i;
    fields.film_pressure.push_back(state.p[at]);
    fields.film_content.push_back(film::film_content(problem.cavitation, state.deficit[at]));
    fields.lambda_ratio.push_back(h / setup.ring.sigma);
    fields.asperity_pressure.push_back(setup.ring.contact->contact(local ? of_contact + height : of_contact).pressure);
  }
}

}  // namespace ringfilm::cycle
