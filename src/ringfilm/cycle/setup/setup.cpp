#include "ringfilm/cycle/setup/setup.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "ringfilm/base/constants.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/base/number_text.hpp"
#include "ringfilm/case/accuracy.hpp"
#include "ringfilm/case/case_face.hpp"
#include "ringfilm/cycle/setup/contact_setup.hpp"
#include "ringfilm/cycle/setup/free_ring.hpp"
#include "ringfilm/cycle/setup/land_pressure.hpp"
#include "ringfilm/cycle/setup/oil_setup.hpp"
#include "ringfilm/cycle/setup/ring_conditions.hpp"
#include "ringfilm/cycle/setup/ring_section.hpp"
#include "ringfilm/cycle/setup/trace_zero.hpp"

namespace ringfilm::cycle {
namespace {

/// @param turn to add to the angles [degree]  @param rise to add to the pressures [Pa]
models::CyclePressure absolute_trace(const Case& c, SampledTrace trace, double turn, double rise) {
  for (double& angle : trace.crank_angle_deg) angle += turn;
  for (double& p : trace.value) p += rise;
  if (models::covers_cycle(trace.crank_angle_deg)) return {std::move(trace.crank_angle_deg), std::move(trace.value)};
  if (!c.gas.intake_pressure || !c.gas.exhaust_pressure) {
    throw InputError("the pressure trace covers only a part of the cycle",
                     "state gas.intake_pressure and gas.exhaust_pressure; the rest is then joined smoothly");
  }
  return models::join_partial_trace(trace.crank_angle_deg, trace.value, *c.gas.intake_pressure,
                                    *c.gas.exhaust_pressure);
}

models::RingFace ring_face(const Case& c) {
  const RingFace& f = c.ring.face;
  return f.form == FaceForm::kPoints ? models::RingFace::points(f.x, f.height, c.ring.face_width)
                                     : face_of_formula(f, c.ring.face_width);
}

/// On the face [Pa].
double largest_mean_pressure(const Case& c, const LandPressures& lands) {
  const double behind =
      lands.behind ? lands.behind->peak() : pressure_behind_ring(c.gas, lands.above.peak(), lands.below.peak());
  return elastic_pressure(c) + behind;
}

models::CyclePressure computed_pressure(const SampledTrace& trace) { return {trace.crank_angle_deg, trace.value}; }

LandPressures land_pressures(const Case& c) {
  if (c.gas_path.is_computed() && !c.ring.has_computed_gas) {
    throw InputError("the gas between the rings is computed for a whole ring pack, and this is a ring by itself",
                     "run the pack, or state gas_path.model = \"given\" with ring.pressure_above and "
                     "ring.pressure_below, for which ringfilm gas --csv writes traces");
  }
  const LandPressure &above = c.ring.pressure_above, &below = c.ring.pressure_below;
  LandPressures lands{above.is_stated() ? land_pressure(c, above) : cylinder_pressure(c),
                      below.is_stated() ? land_pressure(c, below) : crankcase_pressure(c)};
  if (c.ring.pressure_behind) lands.behind = computed_pressure(**c.ring.pressure_behind);
  if (c.ring.gas_path.kind == RingKind::kOil) lands.behind = lands.below;  // holes drain the groove
  return lands;
}

/// A section by which the face could turn, but does not.
void add_twist_note(const Case& c, std::vector<Note>& notes) {
  if (!c.ring.section.is_stated() || c.ring.section.twist == RingTwist::kNone || c.twists()) return;
  notes.push_back({kRingTwistOmitted,
                   "the section of the ring is stated and its face does not turn: that is computed of a compression "
                   "ring whose film is one across the face, without local deformation, and that is not turned over",
                   1});
}

std::shared_ptr<const models::LandLift> land_lift(const Case& c) {
  if (c.film.land_lift == LandLift::kNone) return nullptr;
  models::LandTable rows = c.film.land_law->rows;
  for (double& lift : rows.lift) lift *= c.film.land_factor;
  return std::make_shared<const models::LandLift>(std::move(rows));
}

Setup with_oil(const Case& stated, PreparedOil oil, LandPressures lands) {
  const Case c = with_accuracy(stated);
  if (c.solver.properties == Properties::kFitted) fit_properties(oil, largest_mean_pressure(c, lands));
  film::FactorLaws factors = factor_laws(c, roughness(c), oil.setup.thinning);
  add_twist_note(c, oil.notes);
  return {c,
          {crank_slider(c), c.operating.speed},
          {ring_face(c), elastic_pressure(c), composite_modulus(c), roughness(c), asperity_contact(c), asperities(c),
           std::move(lands), std::move(oil.setup), std::move(factors),
           c.twists() ? std::optional(twisting_ring(c)) : std::nullopt, c.twists() ? section_mass(c) : 0,
           radial_collapse(c), land_lift(c)},
          std::move(oil.notes)};
}

}  // namespace

models::CyclePressure land_pressure(const Case& c, const LandPressure& land) {
  if (land.computed) return computed_pressure(**land.computed);
  return land.trace ? absolute_trace(c, **land.trace, turn_of_traces_deg(c.gas), rise_of_traces(c.gas))
                    : models::CyclePressure(land.constant.value());
}

models::CrankSlider crank_slider(const Case& c) { return {c.engine.stroke / 2, c.engine.connecting_rod_length}; }

models::CyclePressure cylinder_pressure(const Case& c) {
  if (c.gas.model == GasModel::kTrace) {
    return absolute_trace(c, *c.gas.cylinder_pressure, turn_of_traces_deg(c.gas) + c.gas.angle_offset_deg,
                          rise_of_cylinder_trace(c));
  }
  const Gas& g = c.gas;
  return models::wiebe_pressure({crank_slider(c), g.compression_ratio, g.peak_pressure, g.peak_angle_deg,
                                 g.burn_duration_deg, g.intake_pressure.value_or(Gas::kWiebeIntakePressure),
                                 g.exhaust_pressure.value_or(Gas::kWiebeExhaustPressure), g.exhaust_valve_opening_deg,
                                 g.exhaust_valve_closing_deg, g.intake_valve_opening_deg, g.intake_valve_closing_deg});
}

models::CyclePressure crankcase_pressure(const Case& c) {
  return c.gas.crankcase_trace
             ? absolute_trace(c, **c.gas.crankcase_trace, turn_of_traces_deg(c.gas), rise_of_traces(c.gas))
             : models::CyclePressure(c.gas.crankcase_pressure);
}

std::optional<models::WallTemperatures> wall_temperatures(const Thermal& thermal) {
  if (!thermal.is_stated()) return std::nullopt;
  std::vector<double> distance, liner;
  for (const StrokeValue& point : thermal.liner) {
    distance.push_back(point.distance);
    liner.push_back(point.value);
  }
  return models::WallTemperatures(thermal.film, thermal.ring, std::move(distance), std::move(liner));
}

std::string usual_tension() {
  return "compression rings press with 0.05 to 0.5 MPa, oil rings with up to 2 MPa; check the units of the tension, "
         "ring.face_width and engine.bore";
}

double elastic_pressure(const Case& c) {
  const Ring& r = c.ring;
  if (r.elastic_pressure) return *r.elastic_pressure;
  if (const auto& force = r.tangential_force ? r.tangential_force : r.expander_force) {
    return models::elastic_pressure_from_tangential_force(*force, r.rails * r.face_width, c.engine.bore);
  }
  if (r.free_shape) {
    return models::elastic_pressure_from_tangential_force(free_ring(c).tangential_force, r.face_width, c.engine.bore);
  }
  if (const auto section = stated_section(r)) {
    return models::elastic_pressure_from_section(r.free_gap.value(), second_moment_in_plane(*section), r.face_width,
                                                 r.youngs_modulus, c.engine.bore);
  }
  return models::elastic_pressure_from_free_gap(r.free_gap.value(), r.thickness().value(), r.youngs_modulus,
                                                c.engine.bore);
}

namespace {

/// Radial thickness and end gap over the bore, where they are not stated (assumed: the middle of usual rings).
constexpr double kUsualThickness = 1.0 / 25, kUsualGap = 0.0035;

/// Share of the face above its lowest place; half of one that turns over, or whose face is not stated.
double share_above_lowest(const Case& c) {
  const RingFace& face = c.ring.face;
  const bool is_known = face.form == FaceForm::kPoints ? !face.x.empty() : c.ring.face_width > 0;
  if (!is_known || face.orientation == Orientation::kLeadingEdge) return 0.5;
  const double share = ring_face(c).minimum().x / c.ring.face_width;
  return face.orientation == Orientation::kX0Crankcase ? 1 - share : share;
}

}  // namespace

models::RadialCollapse radial_collapse(const Case& c) {
  const Ring& ring = c.ring;
  const double thickness = ring.radial_thickness.value_or(kUsualThickness * c.engine.bore);
  const double gap = ring.end_gap.value_or(kUsualGap * c.engine.bore);
  return {share_above_lowest(c), models::radial_stiffness(thickness, ring.youngs_modulus, c.engine.bore),
          gap / (2 * std::numbers::pi)};
}

namespace {

film::MeasuredFactors measured_factors(const Case& c) {
  film::MeasuredFactors factors;
  if (!c.film.is_measured()) return factors;
  film::MeasuredFactors::Flow flow = c.contact.law->flow;
  if (c.contact.law_shift != 0) {
    flow = std::make_shared<const models::MeasuredFlow>(flow->shifted(c.contact.law_shift));
  }
  if (c.film.flow_factors == Roughness::kMeasured) factors.pressure_flow = flow;
  if (c.film.shear_flow == Roughness::kMeasured) factors.shear_flow = flow;
  if (c.film.stress_factors == Roughness::kMeasured) factors.stress = flow;
  if (c.film.average_gap == AverageGap::kMeasured) factors.average_gap = flow;
  factors.eyring_stress = c.contact.eyring_shear_stress;
  return factors;
}

}  // namespace

film::FactorLaws factor_laws(const Case& c, double sigma, const std::optional<film::ThinningOil>& thinning) {
  film::FactorLaws laws;
  laws.thinning = thinning;
  laws.sigma = sigma;
  const models::PatirCheng rough(c.film.orientation);
  if (c.film.flow_factors == Roughness::kPatirCheng) {
    laws.pressure_flow = rough;
    laws.cross_flow = models::PatirCheng(1 / c.film.orientation);
  }
  if (c.film.stress_factors == Roughness::kPatirCheng) laws.stress = rough;
  if (c.film.shear_flow == Roughness::kPatirCheng) {
    laws.shear_flow = rough;
    laws.share_difference = 1 - 2 * ring_roughness_share(c);
  }
  laws.average_gap = c.film.average_gap;
  laws.measured = measured_factors(c);
  return laws;
}

namespace {

/// A setup has one face.
void check_one_face(const Case& c) {
  const char* remedy =
      "ringfilm run and ringfilm.run compute a whole pack; by itself set up one of Case::rings, of with_gas_path(pack) "
      "where the gas is computed";
  if (c.is_pack()) {
    throw InputError("the case is a pack of " + std::to_string(c.rings.size()) + " rings, and one ring is set up here",
                     remedy);
  }
  if (c.ring.rails > 1) {
    throw InputError("the ring has " + std::to_string(c.ring.rails) + " rails, and one face is set up here", remedy);
  }
}

}  // namespace

Setup prepare(const Case& c) {
  check_one_face(c);
  if (c.problem == Problem::kClosure) {
    throw InputError("the case states the static closure of a ring alone, not a cycle",
                     "compute it with ringfilm conform, or state engine, gas, oil and surfaces, too");
  }
  PreparedOil oil =
      prepared_oil(c.lubricant, wall_temperatures(c.thermal),
                   {c.operating.oil_temperature, c.engine.stroke, c.thermal.is_heated() ? kServedRise : 0});
  return with_oil(c, std::move(oil), land_pressures(c));
}

Setup prepare(const Case& c, const OwnOil& oil) {
  check_one_face(c);
  if (c.thermal.is_stated()) {
    throw InputError("an own oil is known at one temperature, and the case has those of ring and liner ([thermal])",
                     "state operating.oil_temperature in place of [thermal]");
  }
  if (c.thermal.is_heated()) {
    throw InputError("an own oil is known at one temperature, and thermal.viscous_heating = \"in-film\" changes it",
                     "state thermal.viscous_heating = \"none\"; viscous_heating_rise is reported in both cases");
  }
  if (c.lubricant.thins()) {
    throw InputError("an own oil is known without shear, and lubricant.shear_thinning is not \"none\"",
                     "state lubricant.shear_thinning = \"none\"");
  }
  LandPressures lands = land_pressures(c);
  PreparedOil prepared = own_oil(oil.name, oil.law, c.operating.oil_temperature, largest_mean_pressure(c, lands));
  return with_oil(c, std::move(prepared), std::move(lands));
}

}  // namespace ringfilm::cycle
