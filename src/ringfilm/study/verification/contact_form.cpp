#include "ringfilm/study/verification/contact_form.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "ringfilm/models/contact/persson.hpp"
#include "ringfilm/surface/contact/flow_cell.hpp"
#include "ringfilm/surface/contact/rough_contact.hpp"
#include "ringfilm/surface/synthetic/synthetic.hpp"

namespace ringfilm::study {
namespace {

using std::numbers::pi;
using surface::ContactAtSeparation;
using surface::HeightMap;
using surface::MapEdges;
using surface::RoughContact;

constexpr double kNotOfThis = std::numeric_limits<double>::quiet_NaN();
constexpr double kAmplitude = 0.01, kFull = pi * kAmplitude;  // E* = 1 and wave length 1: pressure p* of full contact

template <class Height>
HeightMap map_of(int columns, int rows, double step, const Height& height) {
  HeightMap map{static_cast<std::size_t>(columns), static_cast<std::size_t>(rows), step, step, {}, {}};
  map.height_m.reserve(map.points());
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) map.height_m.push_back(height(i * step, j * step));
  }
  return map;
}

/// The mean over places of the wave between the points, since the error of one depends on where its spot ends.
double of_wave(const ContactForm& form, const std::string& quantity) {
  constexpr int kPlaces = 16;
  const double step = 1.0 / form.points;
  double sum = 0;
  for (int k = 0; k < kPlaces; ++k) {
    const HeightMap map = map_of(form.points, 1, step, [&](double x, double) {
      return kAmplitude * std::cos(2 * pi * (x + step * k / kPlaces));
    });
    surface::ContactMaterial material{1, {}};
    if (form.hardness > 0) material.hardness = form.hardness * kFull;
    RoughContact contact(map, MapEdges::periodic, material);
    const ContactAtSeparation found = contact.solve(form.separation * kAmplitude);
    const double peak = *std::max_element(contact.pressure().begin(), contact.pressure().end());
    const double value = quantity == "contact_pressure" ? found.pressure / kFull
                         : quantity == "real_area"      ? found.area_share
                         : quantity == "peak_pressure"  ? peak / kFull
                                                        : kNotOfThis;
    sum += value / kPlaces;
  }
  return sum;
}

/// Waves along both axes, z = D cos(2 pi x) cos(2 pi y): full contact needs sqrt(2) p*.
double of_egg_box(const ContactForm& form, const std::string& quantity) {
  const double step = 1.0 / form.points;
  const HeightMap map = map_of(form.points, form.points, step, [](double x, double y) {
    return kAmplitude * std::cos(2 * pi * x) * std::cos(2 * pi * y);
  });
  RoughContact contact(map, MapEdges::periodic, {1, {}});
  const ContactAtSeparation found = contact.solve(form.separation * kAmplitude);
  const double P = found.pressure / (std::numbers::sqrt2 * kFull);
  if (quantity == "hertz_area") return found.area_share / std::pow(P, 2.0 / 3);
  if (quantity == "open_area") return (1 - found.area_share) / (1 - P);
  return kNotOfThis;
}

double of_punches(const ContactForm& form, const std::string& quantity) {
  constexpr double kSinking = 1e-4;
  const HeightMap map = map_of(form.points, 1, 1.0 / form.points,
                               [&](double x, double) { return std::min(x, 1 - x) < form.size ? 1e-3 : -1.0; });
  RoughContact contact(map, MapEdges::periodic, {1, {}});
  const ContactAtSeparation found = contact.solve(contact.highest_m() - kSinking);
  if (quantity == "centre_pressure") return contact.pressure()[0] / found.pressure;
  if (quantity == "sinking") return kSinking / found.pressure;
  return kNotOfThis;
}

/// In a cell of 16 radii of the spot; what the images displace is measured from the mean plane, so that the numbers are
/// compared at their load.
double of_sphere(const ContactForm& form, const std::string& quantity) {
  constexpr double kRadius = 1, kSpot = 0.02, kCells = 16;
  const double cell = kCells * kSpot, step = cell / form.points, half = cell / 2;
  const HeightMap map = map_of(form.points, form.points, step, [&](double x, double y) {
    return -((x - half) * (x - half) + (y - half) * (y - half)) / (2 * kRadius);
  });
  RoughContact contact(map, MapEdges::periodic, {1, {}});
  const double wanted = 4 * kSpot * kSpot * kSpot / (3 * kRadius);
  double low = contact.highest_m() * 0.5, high = contact.highest_m();
  for (int k = 0; k < 30; ++k) {
    const double h = (low + high) / 2;
    (contact.solve(h).pressure * cell * cell > wanted ? low : high) = h;
  }
  const ContactAtSeparation found = contact.solve(low);
  const double peak = *std::max_element(contact.pressure().begin(), contact.pressure().end());
  if (quantity == "peak_pressure") return peak / (2 * kSpot / (pi * kRadius));
  if (quantity == "real_area") return found.area_share * cell * cell / (pi * kSpot * kSpot);
  return kNotOfThis;
}

HeightMap rough_map(int points) {
  constexpr double kStep = 0.4;
  const auto n = static_cast<std::size_t>(points);
  return surface::gaussian_surface({n, n, kStep, kStep}, surface::gaussian_correlation(5, 5), 0.5, 1);
}

double rms_slope(const HeightMap& map) {
  double squares = 0;
  for (std::size_t j = 0; j < map.points_y; ++j) {
    for (std::size_t i = 0; i < map.points_x; ++i) {
      const double z = map.height_m[map.index(i, j)];
      squares += std::pow((map.height_m[map.index((i + 1) % map.points_x, j)] - z) / map.step_x_m, 2) +
                 std::pow((map.height_m[map.index(i, (j + 1) % map.points_y)] - z) / map.step_y_m, 2);
    }
  }
  return std::sqrt(squares / static_cast<double>(map.points()));
}

/// Real area at which the flow stops, the mean of both directions, while the surfaces come closer.
double percolation_area(RoughContact& contact) {
  constexpr double kFirst = 0.5, kStep = 0.03;  // first separation and step over the rms height
  constexpr double kShut = 1e-6;                // largest conductance of a closed gap over h^3
  double area = 0, shut_x = 0, shut_y = 0;
  for (double h = kFirst; h > 0 && (shut_x == 0 || shut_y == 0); h -= kStep) {
    const double separation = h * contact.rms_m(), smallest = kShut * std::pow(separation, 3), former = area;
    area = contact.solve(separation).area_share;
    std::vector<double> gap(contact.gap().begin(), contact.gap().end());
    for (std::size_t i = 0; i < gap.size(); ++i) gap[i] = contact.pressure()[i] > 0 ? 0 : std::max(gap[i], 0.0);
    const auto of = surface::flow_factors(gap, contact.grid());
    if (shut_x == 0 && of.conductance_x < smallest) shut_x = (former + area) / 2;
    if (shut_y == 0 && of.conductance_y < smallest) shut_y = (former + area) / 2;
  }
  return (shut_x + shut_y) / 2;
}

double of_rough(const ContactForm& form, const std::string& quantity) {
  const HeightMap map = rough_map(form.points);
  const double slope = rms_slope(map);
  surface::ContactMaterial material{1, {}};
  if (form.hardness > 0) material.hardness = form.hardness * slope;
  RoughContact contact(map, MapEdges::periodic, material);
  const double h = form.separation * contact.rms_m();
  if (quantity == "pressure_flow_deficit") {  // (1 - phi)(h/Sq)^2, the mean of both directions
    std::vector<double> gap;
    for (const double z : map.height_m) gap.push_back(h - z);
    const auto of = surface::flow_factors(gap, contact.grid());
    const double phi = 0.5 * (of.conductance_x + of.conductance_y) / (h * h * h);
    return (1 - phi) * form.separation * form.separation;
  }
  if (quantity == "percolation_area") return percolation_area(contact);
  const ContactAtSeparation found = contact.solve(h);
  if (quantity == "area_slope") return found.area_share * slope / found.pressure;  // kappa, of E* = 1
  if (quantity == "real_pressure" && form.hardness > 0) {                          // over the hardness
    return found.pressure / (form.hardness * slope * found.pixel_share);
  }
  return kNotOfThis;
}

double of_gap(const ContactForm& form, const std::string& quantity) {
  constexpr int kRows = 4;
  const double e = 1 / form.separation, step = 1.0 / form.points;
  std::vector<double> gap;
  for (int j = 0; j < kRows; ++j) {
    for (int i = 0; i < form.points; ++i) gap.push_back(1 + e * std::cos(2 * pi * (i + 0.5) * step));
  }
  const auto of =
      surface::flow_factors(gap, {static_cast<std::size_t>(form.points), kRows, step, 0.01, MapEdges::periodic});
  if (quantity == "pressure_flow_across") return of.conductance_x;
  if (quantity == "pressure_flow_along") return of.conductance_y;
  if (quantity == "couette_flow_across") return of.couette;
  if (quantity == "pressure_stress_across") return of.pressure_stress;
  return kNotOfThis;
}

double of_persson(const ContactForm& form, const std::string& quantity) {
  if (form.hardness == 0) return quantity == "real_area" ? models::persson_area(form.size, 1) : kNotOfThis;
  const models::PerssonArea area = models::persson_area(form.size, 1, form.hardness);
  if (quantity == "elastic_area") return area.elastic;
  if (quantity == "plastic_area") return area.plastic;
  return quantity == "real_area" ? area.total() : kNotOfThis;
}

}  // namespace

const std::vector<std::string>& contact_surfaces() {
  static const std::vector<std::string> names = {"wave", "egg-box", "punches", "sphere", "rough", "gap", "persson"};
  return names;
}

const std::vector<cycle::Quantity>& contact_form_quantities() {
  static const std::vector<cycle::Quantity> all = {
      {"contact_pressure", "1", "1", "mean pressure over that of full contact", "p/p*", ""},
      {"real_area", "1", "1", "real contact area", "A", ""},
      {"hertz_area", "1", "1", "real area over the pressure to the power 2/3", "A/P^(2/3)", ""},
      {"open_area", "1", "1", "area without contact over the pressure missing to full contact", "(1-A)/(1-P)", ""},
      {"percolation_area", "1", "1", "real area at which the flow stops", "A_c", ""},
      {"peak_pressure", "1", "1", "peak pressure", "p_0", ""},
      {"centre_pressure", "1", "1", "pressure in the centre of a punch over the mean", "p(0)/p", ""},
      {"sinking", "1", "1", "depth of the punches per mean pressure", "d E*/p", ""},
      {"area_slope", "1", "1", "real area times E* h' over the pressure", "kappa", ""},
      {"real_pressure", "1", "1", "pressure on the real area over the hardness", "p/(H A)", ""},
      {"elastic_area", "1", "1", "area in elastic contact", "A_el", ""},
      {"plastic_area", "1", "1", "area at the hardness", "A_pl", ""},
      {"pressure_flow_across", "1", "1", "pressure flow across the wave", "phi", ""},
      {"pressure_flow_along", "1", "1", "pressure flow along the crests", "phi", ""},
      {"couette_flow_across", "1", "1", "flow of a sliding wall across the wave", "2 Q/(U h)", ""},
      {"pressure_stress_across", "1", "1", "stress by pressure across the wave", "phi_fp", ""},
      {"pressure_flow_deficit", "1", "1", "(1 - phi)(h/sigma)^2", "", ""}};
  return all;
}

double contact_form_value(const ContactForm& form, const std::string& quantity) {
  if (form.surface == "wave") return of_wave(form, quantity);
  if (form.surface == "egg-box") return of_egg_box(form, quantity);
  if (form.surface == "punches") return of_punches(form, quantity);
  if (form.surface == "sphere") return of_sphere(form, quantity);
  if (form.surface == "rough") return of_rough(form, quantity);
  if (form.surface == "gap") return of_gap(form, quantity);
  return of_persson(form, quantity);
}

}  // namespace ringfilm::study
