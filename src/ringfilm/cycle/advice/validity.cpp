#include "ringfilm/cycle/advice/validity.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ringfilm/base/constants.hpp"
#include "ringfilm/base/display.hpp"
#include "ringfilm/cycle/advice/gas_edge_notes.hpp"
#include "ringfilm/cycle/advice/gas_plausibility.hpp"
#include "ringfilm/cycle/advice/limits.hpp"
#include "ringfilm/cycle/setup/contact_setup.hpp"
#include "ringfilm/film/load_balance.hpp"

namespace ringfilm::cycle {
namespace {

/// Below this lambda ratio asperities carry most of the load, their contact spots grow together and the flow between
/// them is no longer that of a smooth gap: Greenwood-Tripp and Reynolds are both outside what they were made for.
constexpr double kContactModelNeeds = 0.5;
/// Below this one the smooth-gap Reynolds equation is off, and flow factors are extrapolated.
constexpr double kSmoothGapNeeds = 1.0;
/// Newtonian flow is an assumption above this shear rate (docs/theory/assumptions.md).
constexpr double kNewtonianUpTo = 1e6;  // [1/s]

template <typename Condition>
long count(const std::vector<Sample>& base, Condition condition) {
  return std::count_if(base.begin(), base.end(), condition);
}

/// A ring has no face this steep: units are mixed up, or a polynomial is used beyond the width to which it was fitted.
constexpr double kSteepestFace = 0.1;  // height over width

void append_face_note(const Setup& setup, std::vector<Note>& notes) {
  const double width = setup.input.ring.face_width;
  const double rise =
      std::max(setup.ring.face.height(0), setup.ring.face.height(width)) - setup.ring.face.minimum().height;
  if (rise <= kSteepestFace * width) return;
  notes.push_back(
      {"face-too-steep",
       formatted("the face rises to %.4g mm on a width of %.4g mm: is it used beyond the width to which it was "
                 "fitted, or with other units?",
                 number_in(rise, kMillimetre), number_in(width, kMillimetre)),
       1});
}

/// Allowed error of the straight lines between points of the face, over the thinnest film or the roughness. At this
/// value the smallest film of a parabola is off by 5 %, its friction by 0.3 % (docs/manual/robustness.md).
constexpr double kCoarsePoints = 0.1;

/// How far a curved face may lie from the straight lines next to its lowest point, |h''| dx^2/8, with h'' of the three
/// points around it [m]; 0 for two points, which have no curvature.
double error_between_points(const RingFace& face) {
  const std::size_t n = face.x.size();
  if (n < 3) return 0;
  const auto lowest = std::min_element(face.height.begin(), face.height.end()) - face.height.begin();
  const std::size_t k = std::clamp<std::size_t>(static_cast<std::size_t>(lowest), 1, n - 2);
  const double left = face.x[k] - face.x[k - 1], right = face.x[k + 1] - face.x[k];
  const double curvature =
      2 * ((face.height[k + 1] - face.height[k]) / right - (face.height[k] - face.height[k - 1]) / left) /
      (left + right);
  const double longest = std::max(left, right);
  return std::abs(curvature) * longest * longest / 8;
}

void append_points_note(const Setup& setup, double thinnest_film, std::vector<Note>& notes) {
  const RingFace& face = setup.input.ring.face;
  if (face.form != FaceForm::kPoints) return;
  if (face.x.size() == 2) {
    notes.push_back({"face-points-few",
                     "the face has two points only and is a straight line between them: a barrel or a worn face needs "
                     "more points",
                     1});
    return;
  }
  const double error = error_between_points(face), film = std::max(thinnest_film, setup.ring.sigma);
  if (error <= kCoarsePoints * film) return;
  notes.push_back(
      {"face-points-few",
       formatted("the straight lines between the points next to the lowest place of the face are %.2g um away "
                 "from a curve through them, where the film is %.2g um thin: give more points there (of a "
                 "curved face), or smooth their noise",
                 number_in(error, kMicrometre), number_in(thinnest_film, kMicrometre)),
       1});
}

/// With fewer cells peak film pressures of the shipped cases are off by more than 1 %, their friction by more than 0.1
/// % (docs/manual/robustness.md).
constexpr int kMinCells = 50;

void append_grid_note(const Setup& setup, std::vector<Note>& notes) {
  const int cells = setup.input.solver.cells;
  const bool is_chosen = setup.input.solver.accuracy.has_value();  // by an accuracy that was measured
  if (setup.cells == CellsOfFace::kGraded || is_chosen || cells >= kMinCells) return;
  notes.push_back(
      {"coarse-grid",
       formatted("%d cells across the face are few: friction is off by up to 0.2 %% with 32 cells, 1 %% with 16 "
                 "and 30 %% with 8, the peak film pressure by 2, 14 and 30 %%: take %d solver.cells or more",
                 cells, kMinCells),
       1});
}

/// From this share on the modulus below the coating moves E' by about as much as moduli are known.
constexpr double kCoatingFelt = 0.1;

void append_coating_note(const Setup& setup, double lowest_lambda_ratio, std::vector<Note>& notes) {
  const Case& c = setup.input;
  const Coating& coating = c.ring.coating;
  const bool acts = setup.ring.asperities && coating.youngs_modulus && coating.thickness &&
                    !c.contact.composite_modulus && coating.contact_modulus == ContactModulus::kCoating;
  if (!acts) return;
  // Spots are largest where the film is thinnest.
  const models::GreenwoodTripp::Parameters& pair = *setup.ring.asperities;
  const double separation = lowest_lambda_ratio * setup.ring.sigma - plateau_offset(c.contact);
  const double radius =
      models::contact_spot_radius(pair.beta, pair.sigma, std::clamp(separation / pair.sigma, 0.0, 8.0));
  const double share = models::share_below_coating(radius, *coating.thickness, coating.poissons_ratio);
  if (share <= kCoatingFelt) return;
  notes.push_back(
      {"coating-thin",
       formatted("the coating of %.3g um is thin for contact spots of %.3g um radius: about %.0f %% of their "
                 "approach comes from below it, and E' has the coating's modulus alone",
                 number_in(*coating.thickness, kMicrometre), number_in(radius, kMicrometre), 100 * share),
       1});
}

void append_oil_table_note(const Setup& setup, const std::vector<Sample>& base, std::vector<Note>& notes) {
  if (!setup.input.lubricant.table_file) return;
  const double highest = setup.input.lubricant.table->pressure.back();
  const auto beyond = [&](const Sample& s) { return s.peak_film_pressure > highest; };
  const long steps = count(base, beyond);
  if (steps == 0) return;
  notes.push_back(
      {"oil-table-left",
       formatted("film pressures go beyond the %.4g bar at which the oil table ends: its last slopes are continued",
                 number_in(highest, kBar)),
       steps});
}

/// Flow beside a jump of pressure goes with one over the distance from it, so that its sum has no limit.
void append_gap_leakage_note(const Case& c, std::vector<Note>& notes) {
  if (!c.is_unrolled() || !c.ring.end_gap) return;
  notes.push_back({"gap-leakage-grows",
                   "the leakage into the gap grows with the logarithm of shorter cells at the ends: there the mean "
                   "pressure meets those at the edges of the face in a jump; what the ends do to load, friction and "
                   "flow of the ring does not",
                   1});
}

double shear_rate(const Sample& s) { return std::abs(s.piston_velocity) / s.min_film_thickness; }

/// A ring that leaves the liner by h shortens its circumference by 2 pi h, until its ends meet. Closed gaps of ISO 6621
/// are 0.2 to 0.5 % of the bore; this is twice the largest.
constexpr double kMaxEndGap = 0.01;  // share of the bore
/// Mean effective pressure that an engine delivers, about [Pa]: no single ring takes as much.
constexpr double kWholeEngine = 1e6;

/// Above this rise viscosity, which falls by 2 to 4 % a kelvin in a warm engine and by 10 % in a cold one, is off by
/// more than other inputs [K].
constexpr double kWarmFilm = 5;

void append_heating_note(const Setup& setup, const std::vector<Sample>& base, std::vector<Note>& notes) {
  const auto warmest = std::max_element(base.begin(), base.end(), [](const Sample& a, const Sample& b) {
    return a.viscous_heating_rise < b.viscous_heating_rise;
  });
  const bool is_heated = setup.input.thermal.is_heated();
  const auto above = [&](const Sample& s) {
    return is_heated ? s.film_temperature >= setup.ring.oil.hottest : s.viscous_heating_rise > kWarmFilm;
  };
  const long steps = count(base, above);
  if (steps == 0) return;
  notes.push_back(
      {"viscous-heating-high",
       is_heated
           ? formatted("viscous heating would make the film warmer than the %.0f degC up to which its oil is prepared: "
                       "that temperature is taken",
                       number_in(setup.ring.oil.hottest, kCelsius))
           : formatted("viscous heating makes the film up to %.3g K warmer than its walls (at %.0f degree), and its "
                       "viscosity is that at their temperature; thermal.viscous_heating = \"in-film\" takes the rise "
                       "into account",
                       warmest->viscous_heating_rise, warmest->crank_angle_deg),
       steps});
}

/// From this share of the friction energy on boundary friction alone decides how friction changes with the film.
constexpr double kMostlyBoundary = 0.7;

void append_boundary_share_note(const Contact& contact, const CycleValues& values, std::vector<Note>& notes) {
  // Both are 0 where the cycle was not finished.
  if (values.mean_boundary_power <= kMostlyBoundary * values.mean_power_loss) return;
  const std::string carries = contact.model == ContactLaw::kTable ? "contact.law" : roughness_keys(contact);
  notes.push_back({"friction-mostly-boundary",
                   formatted("%.0f %% of the friction energy is boundary friction: friction of such a ring falls with "
                             "speed and with thicker oil, while that of rings that were measured rises with speed "
                             "(NACA TN 1249; Wakuri 1992); what decides it are the roughness that carries (%s), the "
                             "temperatures of the walls and contact.boundary_shear_strength_coefficient",
                             100 * values.mean_boundary_power / values.mean_power_loss, carries.c_str()),
                   1});
}

/// Half-space contact holds for small slopes; tan 11 degree is taken as the largest.
constexpr double kSteepestAsperity = 0.2;

void append_asperity_notes(const Setup& setup, const std::vector<Sample>& base, std::vector<Note>& notes) {
  const std::optional<double>& stated = setup.input.contact.hardness;
  const double hardness = stated.value_or(kUsualHardness);
  const std::string of_softer = "the hardness of the softer face, " + text_in(hardness, kGigapascal, 3) +
                                (stated ? " (contact.hardness)" : " (assumed: grey iron; state contact.hardness)");
  const auto& pair = setup.ring.asperities;
  const auto summits = pair ? models::summit_statistics(*pair) : std::nullopt;
  if (pair && !summits) {
    notes.push_back({"asperities-inconsistent",
                     "no Gaussian surface has these contact.asperity_density, contact.asperity_radius and " +
                         roughness_keys(setup.input.contact) +
                         " together (bandwidth parameter below 1.5): were they measured on the same "
                         "surface, with the same cut-off?",
                     1});
  }
  const double slope = summits ? summits->rms_slope : 0;
  const double psi = summits ? models::plasticity_index(*pair, summits->summit_spread, hardness) : 0;
  const auto highest = std::max_element(base.begin(), base.end(), [](const Sample& a, const Sample& b) {
    return a.mean_real_pressure < b.mean_real_pressure;
  });
  const auto beyond = [&](const Sample& s) { return s.mean_real_pressure > hardness; };
  const bool is_elastic = setup.input.contact.is_elastic();
  if (is_elastic && beyond(*highest)) {
    notes.push_back(
        {"contact-beyond-hardness",
         formatted("mean pressure on the real area of contact up to %.3g GPa (at %.0f degree), beyond %s: the "
                   "load against film is a fit, real area and spot size are too small",
                   number_in(highest->mean_real_pressure, kGigapascal), highest->crank_angle_deg, of_softer.c_str()),
         count(base, beyond)});
  } else if (is_elastic && psi > 1 && highest->mean_real_pressure > 0) {
    notes.push_back(
        {"contact-plastic",
         formatted("plasticity index %.2f with %s: above 1 asperities deform plastically, while the contact is "
                   "computed as elastic",
                   psi, of_softer.c_str()),
         1});
  }
  if (slope > kSteepestAsperity && highest->mean_real_pressure > 0) {
    notes.push_back({"asperity-slopes-high",
                     formatted("N, beta and sigma are those of a surface with rms slopes of %.2f; elastic contact of "
                               "half-spaces holds for slopes up to about %.1f",
                               slope, kSteepestAsperity),
                     1});
  }
}

/// From this share on the extrapolated part of a contact law counts.
constexpr double kMuchExtrapolated = 0.01;

void append_contact_table_notes(const Setup& setup, const std::vector<Sample>& base, double beyond,
                                std::vector<Note>& notes) {
  if (setup.input.contact.model != ContactLaw::kTable) return;
  const Contact& contact = setup.input.contact;
  const double shift = contact.law_shift;
  const std::vector<double>& rows = contact.law->rows.h;
  const auto first_row = std::find_if(rows.begin(), rows.end(), [shift](double h) { return h + shift > 0; });
  const double first = *first_row + shift;  // there is one: the law was set up
  const auto below = [&](const Sample& s) { return s.min_film_thickness < first; };
  const auto thinnest = std::min_element(base.begin(), base.end(), [](const Sample& a, const Sample& b) {
    return a.min_film_thickness < b.min_film_thickness;
  });
  if (below(*thinnest)) {
    notes.push_back(
        {"contact-law-left",
         formatted("the film is down to %.3g um thin (at %.0f degree), and contact.law begins at %.3g um: its "
                   "pressure is extrapolated below that; compute smaller separations",
                   number_in(thinnest->min_film_thickness, kMicrometre), thinnest->crank_angle_deg,
                   number_in(first, kMicrometre)),
         count(base, below)});
  }
  if (beyond > kMuchExtrapolated) {
    notes.push_back(
        {"contact-law-extrapolated",
         formatted("%.2g %% of the load that asperities carry over the cycle comes from separations beyond %.3g "
                   "um, where few or no spots of the maps of contact.law touch: there it is extrapolated",
                   100 * beyond, number_in(contact.law->last_supported_separation + shift, kMicrometre)),
         1});
  }
}

/// Where the film is thinner than the first row of the lift of the honing.
void append_land_notes(const Setup& setup, const std::vector<Sample>& base, std::vector<Note>& notes) {
  if (setup.ring.land == nullptr) return;
  const double first = setup.ring.land->table().separation.front(), width = setup.input.film.land_law->width;
  const auto below = [&](const Sample& s) { return s.min_film_thickness < first; };
  if (const long n = count(base, below); n > 0) {
    notes.push_back({"land-law-left",
                     formatted("the film is thinner than %.3g um, where film.land_law begins: its lift is extrapolated "
                               "below that; compute smaller separations",
                               number_in(first, kMicrometre)),
                     n});
  }
  if (setup.input.film.has_gas_edge()) {
    notes.push_back({"land-lift-flooded",
                     "film.land_law is the lift of a flooded land, and edges of the face are in gas: where little oil "
                     "comes, the lift is an upper bound",
                     1});
  }
  constexpr double kOtherWidth = 0.1;  // share of the width; lift is about proportional to it
  const double face = setup.input.ring.face_width;
  if (std::abs(face / width - 1) > kOtherWidth) {
    notes.push_back({"land-width-differs",
                     formatted("film.land_law is that of a land of %.3g um, and the face is %.3g um wide: lift depends "
                               "on the width; compute it with --width of the face",
                               number_in(width, kMicrometre), number_in(face, kMicrometre)),
                     1});
  }
}

/// From this difference to a smooth gap on the end of a table of flow factors counts.
constexpr double kMuchBeyondLast = 0.02;

/// Where the film is outside the rows of measured flow factors.
void append_measured_flow_notes(const Setup& setup, const std::vector<Sample>& base, std::vector<Note>& notes) {
  if (!setup.input.film.is_measured()) return;
  const film::MeasuredFactors& measured = setup.ring.factors.measured;
  const film::MeasuredFactors::Flow all[] = {measured.pressure_flow, measured.shear_flow, measured.stress,
                                             measured.average_gap};
  const models::MeasuredFlow& flow =
      **std::find_if(std::begin(all), std::end(all), [](const auto& of) { return of != nullptr; });
  const auto share = [&](const auto& is_there) {
    return 100 * static_cast<double>(count(base, is_there)) / static_cast<double>(base.size());
  };
  const auto below = [&](const Sample& s) { return s.min_film_thickness < flow.first(); };
  const auto beyond = [&](const Sample& s) { return s.min_film_thickness > flow.last(); };
  if (share(below) > 0) {
    notes.push_back(
        {"flow-factors-left",
         formatted("over %.3g %% of the crank angles the film is thinner than %.3g um, where the flow factors of "
                   "contact.law begin: they keep their first values there; compute smaller separations",
                   share(below), number_in(flow.first(), kMicrometre)),
         count(base, below)});
  }
  const double difference = std::abs(flow.pressure_flow(flow.last()) - 1);
  if (share(beyond) > 0 || difference > kMuchBeyondLast) {
    notes.push_back(
        {"flow-factors-extrapolated",
         formatted("the flow factors of contact.law end at %.3g um, with phi_x %.3g %% from 1; beyond it this "
                   "falls with the square of the film thickness; over %.3g %% of the crank angles the whole "
                   "face is there",
                   number_in(flow.last(), kMicrometre), 100 * difference, share(beyond)),
         count(base, beyond)});
  }
}

/// Allowed rise of the face within a cell, over the film. At this value the flow through the cell is wrong by
/// a factor of two.
constexpr double kUnseen = 0.25;

void append_cell_note(const film::FilmGrid& grid, const Sample& thinnest, CellsOfFace cells, std::vector<Note>& notes) {
  const double rise = *std::min_element(grid.face_height.begin(), grid.face_height.end());
  if (rise <= kUnseen * thinnest.min_film_thickness) return;
  const std::string remedy =
      cells == CellsOfFace::kUniform
          ? formatted("take more solver.cells than %d", grid.n_cells())
          : formatted(
                "the %d cells are graded for films of %.3g nm already; check face, load and oil, which make a thinner "
                "film",
                grid.n_cells(), number_in(film::kAtom, kNanometre));
  notes.push_back(
      {"cells-too-long",
       formatted("the face rises by %.3g nm within the cell at its lowest place, where the film is %.3g nm thin "
                 "(at %.0f degree): %s",
                 number_in(rise, kNanometre), number_in(thinnest.min_film_thickness, kNanometre),
                 thinnest.crank_angle_deg, remedy.c_str()),
       1});
}

/// Results that are numbers, but not those of a ring in an engine.
void append_limit_notes(const Setup& setup, const std::vector<Sample>& base, double fmep, std::vector<Note>& notes) {
  const double length = setup.input.ring_length();
  const double freedom =
      setup.input.ring.end_gap.value_or(kMaxEndGap * setup.input.engine.bore) / (2 * std::numbers::pi);
  const auto stress = [&](const Sample& s) {
    return std::max(std::abs(s.viscous_friction_liner), std::abs(s.viscous_friction_ring)) /
           (length * setup.input.ring.face_width);
  };
  const auto where = [](const Sample& s) { return formatted(" (at %.0f degree)", s.crank_angle_deg); };
  const auto film = [](const Sample& s) { return s.min_film_thickness; };
  const auto pressure = [](const Sample& s) { return s.peak_film_pressure; };
  const Limit too_thick = {
      Limit::Allowed::kBelow, "film-too-thick", freedom, 1e-6,
      setup.input.ring.end_gap
          ? "the ring floats up to %.4g um off the liner%s: at %.3g um its ends meet (ring.end_gap)"
          : "the ring floats up to %.4g um off the liner%s: at %.3g um the ends of a ring with a gap of 1 %% of the "
            "bore, twice the largest usual one, meet"};
  append_limit_note(kFilmBelowMolecules, base, film, where, notes);
  append_limit_note(too_thick, base, film, where, notes);
  append_limit_note(kFilmPressureHigh, base, pressure, where, notes);
  append_limit_note(kShearStressHigh, base, stress, where, notes);
  if (fmep > kWholeEngine) {
    notes.push_back(
        {"friction-too-high",
         formatted("the ring alone has a friction mean effective pressure of %.3g kPa, more than the %.0f kPa "
                   "that an engine delivers: units, oil temperature or load are not those of an engine",
                   number_in(fmep, kKilopascal), number_in(kWholeEngine, kKilopascal)),
         1});
  }
}

}  // namespace

void append_validity_notes(const Setup& setup, const film::FilmGrid& grid, const std::vector<Sample>& base,
                           const CycleValues& values, const UntrustedContact& untrusted, std::vector<Note>& notes) {
  if (base.empty()) return;
  const auto lowest = std::min_element(
      base.begin(), base.end(), [](const Sample& a, const Sample& b) { return a.lambda_ratio < b.lambda_ratio; });
  const auto below = [&](double limit) { return count(base, [&](const Sample& s) { return s.lambda_ratio < limit; }); };
  if (lowest->lambda_ratio < kContactModelNeeds) {
    notes.push_back(
        {"lambda-ratio-too-low",
         formatted("lambda ratio down to %.2f (at %.0f degree): below %.1f neither the contact model nor the "
                   "smooth-gap film holds",
                   lowest->lambda_ratio, lowest->crank_angle_deg, kContactModelNeeds),
         below(kContactModelNeeds)});
  } else if (lowest->lambda_ratio < kSmoothGapNeeds && setup.input.film.flow_factors != Roughness::kMeasured) {
    notes.push_back({"lambda-ratio-low",
                     formatted("lambda ratio down to %.2f (at %.0f degree): below %.1f %s", lowest->lambda_ratio,
                               lowest->crank_angle_deg, kSmoothGapNeeds,
                               setup.input.film.flow_factors == Roughness::kNone
                                   ? "the flow through the roughness differs from that of a smooth gap"
                                   : "the flow factors are at the end of what they were fitted to"),
                     below(kSmoothGapNeeds)});
  }
  const auto fastest = std::max_element(base.begin(), base.end(),
                                        [](const Sample& a, const Sample& b) { return shear_rate(a) < shear_rate(b); });
  if (!setup.input.lubricant.thins() && shear_rate(*fastest) > kNewtonianUpTo) {
    notes.push_back({"shear-rate-high",
                     formatted("shear rate U/h up to %.1e 1/s (at %.0f degree) while the oil is taken as Newtonian",
                               shear_rate(*fastest), fastest->crank_angle_deg),
                     count(base, [](const Sample& s) { return shear_rate(s) > kNewtonianUpTo; })});
  }
  append_origin_note(setup.input, notes);
  append_limit_notes(setup, base, values.fmep, notes);
  append_boundary_share_note(setup.input.contact, values, notes);
  append_asperity_notes(setup, base, notes);
  append_contact_table_notes(setup, base, untrusted.share_of_cycle, notes);
  append_land_notes(setup, base, notes);
  append_measured_flow_notes(setup, base, notes);
  append_gas_edge_notes(base, values, notes);
  append_heating_note(setup, base, notes);
  append_cell_note(grid, *lowest, setup.cells, notes);
  append_grid_note(setup, notes);
  append_face_note(setup, notes);
  append_points_note(setup, lowest->min_film_thickness, notes);
  append_gap_leakage_note(setup.input, notes);
  append_coating_note(setup, lowest->lambda_ratio, notes);
  append_oil_table_note(setup, base, notes);
  if (untrusted.steps > 0) {
    notes.push_back(
        {"polynomial-beyond-range",
         formatted("the F5/2 polynomial as printed rises again beyond a lambda ratio of 1.911: up to %.0f %% "
                   "of the asperity load comes from there",
                   100 * untrusted.largest_share),
         untrusted.steps});
  }
}

namespace {

/// Error of the values of a cycle below which steps that are off do not count, where the case states no accuracy: that
/// which a study asks of its values [%].
constexpr double kUsualAccuracy = 0.5;

/// Error in time of the film at each base angle [-]. It lasts until the oil under the face is renewed: oil enters at
/// half the speed of the ring, so that this takes a path of twice the width of the face.
std::vector<double> errors_in_time(const std::vector<Sample>& base, const std::vector<UncontrolledStep>& steps,
                                   double face_width) {
  constexpr double kRoundOff = 1e-9;  // [degree]
  const std::size_t n = base.size();
  std::vector<double> errors(n, 0.0);
  for (const UncontrolledStep& step : steps) {
    const auto next = std::find_if(base.begin(), base.end(), [&](const Sample& s) {
      return s.crank_angle_deg >= step.crank_angle_deg - kRoundOff;
    });
    double path = 0;
    for (std::size_t i = 0, k = (next - base.begin()) % n; i < n && path <= 2 * face_width; ++i, k = (k + 1) % n) {
      errors[k] = std::max(errors[k], std::min(step.error, 1.0));
      path += std::max(base[(k + 1) % n].sliding_distance - base[k].sliding_distance, 0.0);  // from 0 again at 720
    }
  }
  return errors;
}

/// By how much the friction work of the cycle or its smallest film may be off, whichever is more [-].
double effect_of(const std::vector<Sample>& base, const std::vector<double>& errors) {
  double work = 0, uncertain = 0;
  for (std::size_t k = 0; k < base.size(); ++k) {
    work += base[k].power_loss;
    uncertain += errors[k] * base[k].power_loss;
  }
  const auto lowest = std::min_element(base.begin(), base.end(), [](const Sample& a, const Sample& b) {
    return a.min_film_thickness < b.min_film_thickness;
  });
  return std::max(work > 0 ? uncertain / work : 0.0, errors[lowest - base.begin()]);
}

}  // namespace

void append_step_note(const Setup& setup, const std::vector<Sample>& base, const std::vector<UncontrolledStep>& steps,
                      std::vector<Note>& notes) {
  if (steps.empty() || base.empty()) return;
  const auto angle = [](const UncontrolledStep& a, const UncontrolledStep& b) {
    return a.crank_angle_deg < b.crank_angle_deg;
  };
  const auto [first, last] = std::minmax_element(steps.begin(), steps.end(), angle);
  const UncontrolledStep worst =
      *std::max_element(steps.begin(), steps.end(), [](const auto& a, const auto& b) { return a.error < b.error; });
  const double effect = effect_of(base, errors_in_time(base, steps, setup.input.ring.face_width));
  const double accuracy = setup.input.solver.accuracy.value_or(kUsualAccuracy) / 100;
  const std::string place =
      steps.size() == 1 ? formatted("at %.1f degree", worst.crank_angle_deg)
                        : formatted("between %.1f and %.1f degree", first->crank_angle_deg, last->crank_angle_deg);
  const auto percent = [](double share) -> std::string {
    if (share > 10) return "more than 1000 %";  // without a limit where no error is known
    return formatted(share < 0.095 ? "%.1g %%" : "%.0f %%", 100 * share);
  };
  notes.push_back(
      {effect < accuracy ? "step-control-without-effect" : "step-control-at-its-limit",
       formatted("steps of 1/%d of the crank step with an error in time of more than %.3g %%, %s, the largest "
                 "%s: friction work and smallest film of the cycle may be off by %s (accuracy %.3g %%)",
                 TimeIntegration::kTicksPerBaseStep, 100 * TimeIntegration::kUncontrolledError, place.c_str(),
                 percent(worst.error).c_str(), percent(effect).c_str(), 100 * accuracy),
       static_cast<long>(steps.size())});
}

Note settling_note(double cycles, double oil_ahead) {
  return {
      "oil-not-settled",
      formatted("after %.0f cycles one differs little from the next, but all further ones are estimated to move up to "
                "%.2g %% of the oil on the liner: friction and films of a nearly dry ring may be off by several times "
                "that",
                cycles, std::min(100.0, 100 * oil_ahead)),
      1};
}

void append_effort_notes(const Effort& effort, const TimeIntegration::Totals& totals, std::vector<Note>& notes) {
  if (effort.fallback_secant > 0) {
    notes.push_back({"bracketed-search", "steps on which Newton's method failed and a bracketed search solved the film",
                     effort.fallback_secant});
  }
  if (effort.fallback_sub_step > 0) {
    notes.push_back({"shorter-steps",
                     "attempts at a step that were repeated with a shorter one since no film was found",
                     effort.fallback_sub_step});
  }
  if (totals.exact_law_solves > 0) {
    notes.push_back({"beyond-property-fit",
                     "steps that were solved with the laws of oil and contact themselves: pressures beyond their fits, "
                     "or a bracketed search",
                     totals.exact_law_solves});
  }
}

}  // namespace ringfilm::cycle
