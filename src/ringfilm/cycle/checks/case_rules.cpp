#include "ringfilm/cycle/checks/case_rules.hpp"

#include <cmath>
#include <optional>

#include "ringfilm/base/display.hpp"
#include "ringfilm/base/joined.hpp"
#include "ringfilm/case/keys/case_fields.hpp"
#include "ringfilm/cycle/advice/gas_plausibility.hpp"
#include "ringfilm/cycle/checks/case_rules_closure.hpp"
#include "ringfilm/cycle/checks/case_rules_gas_path.hpp"
#include "ringfilm/cycle/checks/case_rules_measured.hpp"
#include "ringfilm/cycle/checks/case_rules_oil.hpp"
#include "ringfilm/cycle/checks/case_rules_oil_consumption.hpp"
#include "ringfilm/cycle/checks/case_rules_pad.hpp"
#include "ringfilm/cycle/checks/case_rules_plateau.hpp"
#include "ringfilm/cycle/checks/case_rules_section.hpp"
#include "ringfilm/cycle/checks/case_rules_unrolled.hpp"
#include "ringfilm/cycle/setup/contact_setup.hpp"
#include "ringfilm/cycle/setup/kinematics.hpp"
#include "ringfilm/cycle/setup/oil_setup.hpp"
#include "ringfilm/cycle/setup/setup.hpp"
#include "ringfilm/models/gas/gas.hpp"
#include "ringfilm/models/gas/trace_span.hpp"

namespace ringfilm::cycle {
namespace {

using Breaches = std::vector<RuleBreach>;
constexpr RuleBreach::By kMissingKey = RuleBreach::By::kMissingKey;

/// Do whole steps make one cycle? A step typed with few digits ("0.333333 degree") does not.
bool divides_cycle(double step_deg) {
  const double steps = kCycleDeg / step_deg;
  return std::abs(steps - std::round(steps)) <= 1e-9 * steps;
}

/// Fields of this many values are 80 MB each, five of them in a file.
constexpr double kMaxFieldValues = 1e7;

void check_field_size(const Case& c, Breaches& breaches) {
  const Output& output = c.output;
  if (output.fields == FieldOutput::kNone) return;
  const double all = output.crank_angles_deg.empty() ? kCycleDeg / output.crank_angle_step_deg
                                                     : static_cast<double>(output.crank_angles_deg.size());
  const double angles = output.fields == FieldOutput::kAll ? all : static_cast<double>(output.field_angles_deg.size());
  if (angles * c.solver.cells <= kMaxFieldValues) return;
  breaches.push_back({"output.fields",
                      "output.fields asks for " + number_text(angles) + " angles on " + number_text(c.solver.cells) +
                          " cells, more than " + number_text(kMaxFieldValues) + " values a field",
                      "list the angles that matter, for example [\"0 degree\", \"20 degree\"]"});
}

void check_cavitation_pressure(const Film& film, Breaches& breaches) {
  constexpr double kMax = 1e7;
  if (film.cavitation_pressure > kMax) {
    breaches.push_back(
        {"film.cavitation_pressure",
         "film.cavitation_pressure = " + text_in(film.cavitation_pressure, kBar) + " is above " + text_in(kMax, kBar),
         "no oil film of a ring ruptures there; give the absolute pressure of the cavity"});
  }
  if (film.cavitation_pressure >= 0) return;
  breaches.push_back({"film.cavitation_pressure",
                      "film.cavitation_pressure = " + text_in(film.cavitation_pressure, kBar) + " is below zero",
                      "pressures around a ring are absolute, for example \"1.01325 bar\""});
}

void check_engine(const Case& c, Breaches& breaches) {
  if (c.engine.connecting_rod_length > c.engine.stroke / 2) return;
  breaches.push_back({"engine.connecting_rod_length",
                      "engine.connecting_rod_length = " + text_in(c.engine.connecting_rod_length, kMillimetre) +
                          " is not longer than the crank radius, " + text_in(c.engine.stroke / 2, kMillimetre),
                      "the crank could not turn; check engine.stroke and engine.connecting_rod_length"});
}

void check_wiebe(const Gas& gas, Breaches& breaches) {
  if (gas.peak_angle_deg >= gas.exhaust_valve_opening_deg) {
    breaches.push_back({"gas.exhaust_valve_opening", "the exhaust valve opens before the peak of the pressure",
                        "gas.exhaust_valve_opening must be later than gas.peak_angle"});
  }
  if (gas.exhaust_valve_opening_deg >= gas.exhaust_valve_closing_deg) {
    breaches.push_back({"gas.exhaust_valve_closing", "the exhaust valve closes before it opens",
                        "count both angles from firing TDC, for example 130 and 375 degree"});
  }
  if (gas.intake_valve_opening_deg >= gas.intake_valve_closing_deg) {
    breaches.push_back({"gas.intake_valve_closing", "the intake valve closes before it opens",
                        "count both angles from firing TDC, for example 345 and 590 degree"});
  }
}

/// A part of the cycle that is too short to be joined.
bool refuse_short_trace(const std::vector<double>& angles, Breaches& breaches) {
  const double span = angles.back() - angles.front();
  if (span >= models::kMinPartialTraceDeg) return false;
  const std::string least = number_text(models::kMinPartialTraceDeg) + " degree";
  breaches.push_back({"gas.cylinder_pressure",
                      "the trace covers " + number_text(angles.front()) + " to " + number_text(angles.back()) +
                          " degree, less than the " + least + " that compression and expansion take" +
                          (models::spans_radians(angles) ? ": are its crank angles in radians?" : ""),
                      models::spans_radians(angles)
                          ? "then state the unit in its header, crank_angle [rad]"
                          : "give " + least +
                                " about firing TDC or more, from the closing of the intake valve to the opening of "
                                "the exhaust valve; is the unit of the crank angle right?"});
  return true;
}

void check_pegging(const Case& c, Breaches& breaches) {
  const Gas& gas = c.gas;
  if (gas.pegging == Pegging::kNone) return;
  if (gas.pressure_offset != 0) {
    breaches.push_back({"gas.pressure_offset", "gas.pressure_offset and gas.pegging are both stated",
                        "each of them determines the zero of the trace: keep one"});
  }
  if (gas.pegging == Pegging::kIntake && !gas.intake_pressure) {
    breaches.push_back(
        {"gas.intake_pressure", "gas.intake_pressure is not stated, and gas.pegging = \"intake\" requires it",
         "the absolute pressure at bottom dead centre after intake, for example \"0.95 bar\"", kMissingKey});
  }
  if (gas.pegging == Pegging::kPolytropic && !c.stated.contains("gas.compression_ratio")) {
    breaches.push_back({"gas.compression_ratio",
                        "gas.compression_ratio is not stated, and gas.pegging = \"polytropic\" requires it",
                        "largest over smallest cylinder volume, for example 10.5", kMissingKey});
  }
}

void check_trace(const Case& c, Breaches& breaches) {
  const Gas& gas = c.gas;
  const auto& angles = gas.cylinder_pressure->crank_angle_deg;
  if (angles.empty() && gas.cylinder_pressure_file.empty()) {
    breaches.push_back({"gas.cylinder_pressure",
                        "the key gas.cylinder_pressure is missing: " + find_field("gas.cylinder_pressure")->help,
                        "gas.model = \"trace\" requires a trace"});
  }
  check_pegging(c, breaches);
  if (angles.empty() || models::covers_cycle(angles)) return;
  if (refuse_short_trace(angles, breaches)) return;
  const double missing = angles.front() + kCycleDeg - angles.back();
  if (missing < kCycleDeg - 2 * models::kMaxPartialTraceDeg) {
    breaches.push_back({"gas.cylinder_pressure",
                        "the trace has no samples between " + number_text(angles.back()) + " and " +
                            number_text(angles.front() + kCycleDeg) + " degree, where the cycle begins again",
                        "samples may be " + number_text(models::kMaxSampleDistanceDeg) +
                            " degree apart at the most; complete the cycle, or cut the trace to " +
                            number_text(-models::kMaxPartialTraceDeg) + " to " +
                            number_text(models::kMaxPartialTraceDeg) +
                            " degree about firing TDC and state gas.intake_pressure and gas.exhaust_pressure"});
    return;
  }
  const std::string span = "the trace covers only " + number_text(angles.front()) + " to " +
                           number_text(angles.back()) + " degree of the cycle" +
                           (models::covers_one_revolution(angles) ? std::string(", ") + models::kOneRevolution : "") +
                           ", and ";
  const std::string remedy = " is required to join the rest smoothly, for example ";
  if (!gas.intake_pressure) {
    breaches.push_back({"gas.intake_pressure", span + "gas.intake_pressure is not stated",
                        "an absolute pressure" + remedy + "intake_pressure = \"0.95 bar\" in [gas]", kMissingKey});
  }
  if (!gas.exhaust_pressure) {
    breaches.push_back({"gas.exhaust_pressure", span + "gas.exhaust_pressure is not stated",
                        "an absolute pressure" + remedy + "exhaust_pressure = \"1.05 bar\" in [gas]", kMissingKey});
  }
  const std::optional<TraceStart> start = trace_start(c);
  if (!start || !contradicts_intake(*start)) return;
  breaches.push_back({"gas.intake_pressure",
                      "the trace begins with " + text_in(start->pressure, kBar) + " absolute at " +
                          number_text(start->crank_angle_deg) +
                          " degree, where gas.intake_pressure = " + text_in(start->lowest, kBar) +
                          " can be compressed to " + text_in(start->highest, kBar) + " at most",
                      "they belong to one engine: check both, the unit of the trace and gas.pressure_reference"});
}

void check_whole_cycle(const char* key, const std::optional<base::Shared<SampledTrace>>& trace, Breaches& breaches) {
  if (!trace || models::covers_cycle((*trace)->crank_angle_deg)) return;
  breaches.push_back({key, std::string("the trace of ") + key + " covers only a part of the cycle",
                      "give samples over the whole cycle, none more than " +
                          number_text(models::kMaxSampleDistanceDeg) + " degrees apart, or one pressure"});
}

/// All ways to state the tension end where ring.elastic_pressure does.
void check_tension_range(const Case& c, Breaches& breaches) {
  const Ring& ring = c.ring;
  if (!(ring.face_width > 0) || !(c.engine.bore > 0)) return;  // refused by their own ranges
  const double highest = find_field("ring.elastic_pressure")->range->high, p_e = elastic_pressure(c);
  if (p_e <= highest) return;
  const char* key = ring.tangential_force ? "ring.tangential_force"
                    : ring.expander_force ? "ring.expander_force"
                    : ring.free_shape     ? "ring.free_shape"
                                          : "ring.free_gap";
  breaches.push_back({key,
                      std::string(key) + " makes an elastic pressure of " + text_in(p_e, kMegapascal) +
                          " on a face of " + text_in(ring.face_width, kMillimetre) + ", above the " +
                          text_in(highest, kMegapascal) + " at which ring.elastic_pressure ends",
                      usual_tension()});
}

RuleBreach tension_stated_twice(const Ring& ring, const std::string& remedy) {
  std::vector<std::vector<std::string>> ways;
  if (ring.elastic_pressure) ways.push_back({"ring.elastic_pressure"});
  if (ring.tangential_force) ways.push_back({"ring.tangential_force"});
  if (ring.expander_force) ways.push_back({"ring.expander_force"});
  if (ring.free_gap && ring.radial_thickness) {
    ways.push_back({"ring.free_gap", "ring.radial_thickness"});
  } else if (ring.free_gap) {
    ways.push_back({"ring.free_gap"});
  }
  if (ring.free_shape) ways.push_back({"ring.free_shape", "ring.free_shape_smoothing"});
  std::vector<std::string> keys;
  for (const auto& way : ways) keys.push_back(way.front());
  return {ring.tangential_force ? "ring.tangential_force" : keys.back(),
          "the tension of the ring is stated twice: " + joined(keys, " and "), remedy, RuleBreach::By::kValues, ways};
}

void check_tension(const Case& c, Breaches& breaches) {
  const Ring& ring = c.ring;
  const bool gap = ring.free_gap.has_value();  // the thickness alone is that of a ring that bends
  const int stated = (ring.elastic_pressure ? 1 : 0) + (ring.tangential_force ? 1 : 0) + (ring.expander_force ? 1 : 0) +
                     (gap ? 1 : 0) + (ring.free_shape ? 1 : 0);
  const std::string ways =
      "state one of ring.elastic_pressure, ring.tangential_force, ring.expander_force of an oil ring, ring.free_gap "
      "with ring.radial_thickness, or ring.free_shape";
  if (stated == 0) {
    breaches.push_back({"ring.elastic_pressure", "the tension of the ring is missing", ways, kMissingKey});
  } else if (stated > 1) {
    breaches.push_back(tension_stated_twice(ring, ways));
  } else if (gap && !ring.thickness()) {
    breaches.push_back({"ring.radial_thickness", "ring.free_gap is stated without ring.radial_thickness", ways});
  } else if (!ring.free_shape || shows_free_ring(c, breaches)) {
    check_tension_range(c, breaches);
  }
}

void check_face_points(const Ring& ring, Breaches& breaches) {
  const RingFace& face = ring.face;
  if (face.x.empty() || (face.x.front() <= 0 && face.x.back() >= ring.face_width)) return;
  breaches.push_back({"ring.face.file",
                      "the points of the face run from x = " + range_in(face.x.front(), face.x.back(), kMillimetre) +
                          " and do not cover the face width of " + text_in(ring.face_width, kMillimetre),
                      "points from x = 0 to ring.face_width are required; heights are not extrapolated"});
}

/// A fit holds over the width of its trace only: beyond it a polynomial runs away, and less of it is another face.
void check_measured_width(const Ring& ring, Breaches& breaches) {
  constexpr double kRounding = 1e-6;  // both are typed or written with eight digits
  const std::optional<double>& fitted = ring.face.measured.width;
  if (!fitted || std::abs(ring.face_width - *fitted) <= kRounding * *fitted) return;
  breaches.push_back(
      {"ring.face_width",
       "ring.face_width = " + text_in(ring.face_width, kMillimetre) + ", but the face was fitted over " +
           text_in(*fitted, kMillimetre) + " (ring.face.measured.width)",
       "state the width that was measured, or fit the trace again over this one: ringfilm face --width"});
}

void check_angles(const Case& c, Breaches& breaches) {
  const auto refuse_step = [&breaches](const std::string& key, double step_deg) {
    breaches.push_back({key, key + " = " + number_text(step_deg) + " degree does not divide the cycle of 720 degrees",
                        "whole steps must make a cycle, for example \"1 degree\" or \"0.5 degree\""});
  };
  if (!divides_cycle(c.solver.crank_step_deg)) refuse_step("solver.crank_step", c.solver.crank_step_deg);
  const bool by_step = c.output.crank_angles_deg.empty();
  if (by_step && !divides_cycle(c.output.crank_angle_step_deg)) {
    refuse_step("output.crank_angles", c.output.crank_angle_step_deg);
  }
  constexpr double kFinestDeg = 0.01;  // 72 000 rows
  if (by_step && c.output.crank_angle_step_deg < kFinestDeg) {
    breaches.push_back({"output.crank_angles", "output.crank_angles asks for more than 72000 angles",
                        "the finest step is \"0.01 degree\""});
  }
  if (c.solver.crank_step_deg < kFinestDeg) {
    breaches.push_back({"solver.crank_step", "solver.crank_step asks for more than 72000 steps",
                        "the finest step is \"0.01 degree\""});
  }
  check_field_size(c, breaches);
}

/// Laws that need the hardness, or a surface that exists.
void check_contact_law(const Case& c, Breaches& breaches) {
  const Contact& contact = c.contact;
  if (contact.model == ContactLaw::kTable) return;
  const bool is_plastic = contact.model == ContactLaw::kPlastic ||
                          (contact.model != ContactLaw::kBushGibsonThomas && contact.asperity != AsperityLaw::kElastic);
  if (is_plastic && !contact.hardness) {
    breaches.push_back({"contact.hardness", "contact.hardness is missing: asperities that flow need it",
                        "that of the softer face, for example \"2.5 GPa\" of grey iron", kMissingKey});
  }
  const bool has_plane = contact.model == ContactLaw::kBushGibsonThomas ||
                         (contact.model != ContactLaw::kPlastic && contact.summit_plane == SummitPlane::kNayak);
  if (!has_plane) return;
  if (contact.asperity_density > 0 && contact.asperity_radius > 0 && asperity_roughness(c) > 0 &&
      !models::summit_statistics({contact.asperity_density, contact.asperity_radius, asperity_roughness(c), 1})) {
    breaches.push_back({"contact.summit_plane",
                        "no Gaussian surface has these contact.asperity_density, contact.asperity_radius and " +
                            roughness_keys(contact) +
                            " together (bandwidth parameter below 1.5): its summits are not known",
                        "measure all three on one surface with one cut-off, or contact.summit_plane = \"surface\" "
                        "with contact.model = \"greenwood-tripp\" or \"greenwood-williamson\""});
  }
}

void check_local_deformation(const Ring& ring, Breaches& breaches) {
  if (ring.local_deformation == LocalDeformation::kNone || ring.face.orientation != Orientation::kLeadingEdge) return;
  breaches.push_back({"ring.local_deformation",
                      "ring.local_deformation = \"half-space\" needs a face that stays as it is installed, and with "
                      "ring.face.orientation = \"leading-edge\" it turns over at each reversal",
                      "state the edge that looks at the chamber, or take \"none\""});
}

/// Rules of engine and gas: what the gas path alone uses, too.
void check_engine_and_gas(const Case& c, Breaches& breaches) {
  check_engine(c, breaches);
  if (c.gas.model == GasModel::kWiebe) {
    check_wiebe(c.gas, breaches);
  } else {
    check_trace(c, breaches);
  }
  check_whole_cycle("gas.crankcase_pressure", c.gas.crankcase_trace, breaches);
}

}  // namespace

std::vector<RuleBreach> broken_gas_rules(const Case& c) {
  Breaches breaches;
  check_engine_and_gas(c, breaches);
  append_cylinder_breaches(c.engine, breaches);
  if (!c.gas_path.is_computed() && !c.stated.contains("gas_path.model")) {
    breaches.push_back({"gas_path.model", "gas_path.model is not stated: there is no gas to compute",
                        "write model = \"orifice-volume\" in [gas_path], or \"given\" for what flows between stated "
                        "pressures",
                        kMissingKey});
    return breaches;
  }
  if (!append_section_breaches(c, breaches)) return breaches;
  append_composition_breaches(c, breaches);
  append_gas_path_breaches(c, breaches);
  if (c.gas_path.ring_motion == RingMotion::kAxial && c.ring.gas_path.kind == RingKind::kCompression) {
    if (c.ring.face_width > 0) check_tension(c, breaches);
  }
  return breaches;
}

std::vector<RuleBreach> broken_rules(const Case& c) {
  if (c.problem == Problem::kPad) return broken_pad_rules(c);
  Breaches breaches;
  if (!append_section_breaches(c, breaches)) return breaches;
  if (c.problem == Problem::kClosure) {
    check_tension(c, breaches);
    append_closure_breaches(c, breaches);
    return breaches;
  }
  check_cavitation_pressure(c.film, breaches);
  append_gas_edge_breaches(c, breaches);
  append_flow_factor_breaches(c, breaches);
  check_engine_and_gas(c, breaches);
  if (c.gas_path.is_computed()) append_gas_path_breaches(c, breaches);
  append_composition_breaches(c, breaches);
  append_thermal_breaches(c, breaches);
  check_whole_cycle("ring.pressure_above", c.ring.pressure_above.trace, breaches);
  check_whole_cycle("ring.pressure_below", c.ring.pressure_below.trace, breaches);
  check_tension(c, breaches);
  if (c.ring.face.form == FaceForm::kPoints) check_face_points(c.ring, breaches);
  check_measured_width(c.ring, breaches);
  check_local_deformation(c.ring, breaches);
  append_measured_breaches(c.contact.measured, breaches);
  if (append_plateau_breaches(c, breaches)) check_contact_law(c, breaches);
  if (!c.lubricant.table_file) append_oil_law_breaches(c.lubricant, breaches);
  append_oil_consumption_breaches(c, breaches);
  check_angles(c, breaches);
  append_unrolled_breaches(c, breaches);
  if (c.has_closure()) append_closure_breaches(c, breaches);
  if (breaches.empty()) append_viscosity_breaches(c, breaches);
  return breaches;
}

}  // namespace ringfilm::cycle
