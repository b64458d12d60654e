#include "ringfilm/cycle/closure/static_closure.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "ringfilm/base/display.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/cycle/setup/free_ring.hpp"
#include "ringfilm/cycle/setup/setup.hpp"
#include "ringfilm/models/ring.hpp"

namespace ringfilm::cycle {
namespace {

using models::FourierOrder;
using models::FourierSeries;
using std::numbers::pi;

double in_rad(double degrees) { return degrees * pi / 180; }

void append_scaled(const FourierSeries& series, double factor, std::vector<FourierOrder>& orders) {
  for (FourierOrder one : series.orders()) {
    one.amplitude *= factor;
    if (one.amplitude != 0) orders.push_back(one);
  }
}

FourierSeries series_of(const std::vector<FourierTerm>& terms, const std::optional<double>& height) {
  std::vector<FourierOrder> orders;
  for (const FourierTerm& term : terms) {
    if (term.height == height) orders.push_back({term.order, term.amplitude, in_rad(term.phase_deg)});
  }
  return FourierSeries(std::move(orders));
}

/// Sections of the bore at heights that rise.
struct Sections {
  std::vector<double> height;
  std::vector<FourierSeries> series;
};

Sections sections_of(const std::vector<FourierTerm>& terms) {
  std::set<double> heights;
  for (const FourierTerm& term : terms) heights.insert(term.height.value());
  Sections all;
  for (const double height : heights) {
    all.height.push_back(height);
    all.series.push_back(series_of(terms, height));
  }
  return all;
}

std::vector<FourierSeries> series_of(const std::vector<std::vector<double>>& rows, double first_angle_deg,
                                     int last_order) {
  std::vector<FourierSeries> all;
  for (const std::vector<double>& row : rows) {
    const int last = std::min(last_order, static_cast<int>((row.size() - 1) / 2));
    all.push_back(models::fourier_series(row, in_rad(first_angle_deg), last));
  }
  return all;
}

Sections sections_of(const BoreMap& map, int last_order) {
  return {map.height, series_of(map.deviation, map.first_angle_deg, last_order)};
}

/// Straight between two sections.
void append_at(const Sections& sections, double height, std::vector<FourierOrder>& orders) {
  const auto after = std::upper_bound(sections.height.begin(), sections.height.end(), height);
  if (after == sections.height.begin() || height > sections.height.back()) {
    throw InputError("conform.height = " + text_in(height, kMillimetre) + " is outside the bore that is known, " +
                         range_in(sections.height.front(), sections.height.back(), kMillimetre),
                     "heights are not extrapolated: state one between these, or more sections of the bore");
  }
  const std::size_t above = static_cast<std::size_t>(after - sections.height.begin());
  if (above == sections.height.size()) return append_scaled(sections.series.back(), 1, orders);
  const double low = sections.height[above - 1], share = (height - low) / (sections.height[above] - low);
  append_scaled(sections.series[above - 1], 1 - share, orders);
  append_scaled(sections.series[above], share, orders);
}

void append_terms(const std::vector<FourierTerm>& terms, std::optional<double> height,
                  std::vector<FourierOrder>& orders) {
  if (terms.empty()) return;
  if (terms.front().height) {
    append_at(sections_of(terms), height.value_or(0), orders);
  } else {
    append_scaled(series_of(terms, std::nullopt), 1, orders);
  }
}

/// Over their mean; what they have of order 1 is not in balance, and that of the projection takes its place.
FourierSeries orders_of_points(const Ring& ring) {
  const PressurePoints& points = *ring.pressure_around;
  const FourierSeries all =
      models::fourier_series(points.pressure, in_rad(points.first_angle_deg), ring.pressure_points_orders);
  std::vector<FourierOrder> orders(all.orders().begin() + 2, all.orders().end());
  for (FourierOrder& one : orders) one.amplitude /= all.orders().front().amplitude;
  return FourierSeries(std::move(orders));
}

/// Where a ring of this length opens when it bends by -M_w/(E I), to first order along the tangent at the gap.
double first_order_free_gap(const models::RingBeam& beam) {
  constexpr int kSteps = 7200;
  const double from = beam.half_gap(), step = 2 * (pi - from) / kSteps;
  double sum = 0;
  for (int i = 0; i < kSteps; ++i) {
    const double phi = from + (i + 0.5) * step;
    sum += step * beam.target_moment(phi) * (1 - std::cos(phi));
  }
  return sum / beam.stiffness();
}

/// How much of the circumference the target pressure pulls on [degree], by its values at each.
int degrees_of_pull(const models::RingBeam& beam) {
  int count = 0;
  for (int k = 0; k < 360; ++k) {
    const double phi = in_rad(k + 0.5);
    const bool is_gap = phi < beam.half_gap() || phi > 2 * pi - beam.half_gap();
    count += !is_gap && beam.target_force()(phi) < 0 ? 1 : 0;
  }
  return count;
}

std::vector<std::string> closure_notes(const Case& c, const FourierSeries& bore, const models::RingClosure& ring) {
  constexpr double kSmall = 0.01;
  std::vector<std::string> notes;
  const double share = std::max(bore.bound(), ring.largest_clearance().clearance) / (c.engine.bore / 2);
  if (share > kSmall) {
    notes.push_back("the bore deviates, or the ring lifts off, by " + number_text(100 * share) +
                    " % of the radius: the theory holds for deflections that are small against it");
  }
  const double thickness = ring.ring().beam().size().radial_thickness / ring.ring().beam().centroid_radius();
  if (thickness > 0.2) {
    notes.push_back("the ring is " + number_text(100 * thickness) +
                    " % of its radius thick: the theory of thin curved beams is less accurate from 20 % on");
  }
  const models::RingBeam& beam = ring.ring().beam();
  const int pulling = degrees_of_pull(beam);
  if (pulling > 0) {
    notes.push_back("the target pressure of the ring is negative over " + std::to_string(pulling) +
                    " degree of its circumference: there its own tension pulls on the bore; are the amplitudes of "
                    "ring.pressure_orders relative to the mean?");
  }
  constexpr double kWideGap = 0.05;
  const double open = beam.half_gap() / pi;
  if (open > kWideGap) {
    notes.push_back("the end gap is " + number_text(100 * open) +
                    " % of the circumference: is the unit of ring.end_gap right?");
  }
  return notes;
}

ClosureValues values_of(const Case& c, const models::RingClosure& closure) {
  const models::RingBeam& beam = closure.ring().beam();
  const auto largest = closure.largest_clearance();
  ClosureValues of;
  of.max_clearance = largest.clearance;
  of.max_clearance_angle = number_in(largest.phi, kDegree);
  of.open_area = closure.clearance_integral() * c.engine.bore / 2;
  of.contact_angle = number_in(closure.contact_angle(), kDegree);
  of.mean_wall_force = closure.force() / (2 * pi);
  of.share_in_points = closure.force_in_points() / closure.force();
  of.moment_at_back = closure.moment(pi);
  of.tangential_force = beam.size().tangential_force;
  of.second_moment = beam.second_moment();
  of.free_gap = first_order_free_gap(beam);
  of.projection = beam.projection();
  of.unbalanced_share = closure.unbalanced_share();
  return of;
}

}  // namespace

const std::vector<ClosureQuantity>& closure_quantities() {
  using V = ClosureValues;
  static const std::vector<ClosureQuantity> table = {
      {{"max_clearance", "m", "um", "largest clearance between ring and bore", "c_max", "eq-closure-lift-off"},
       &V::max_clearance},
      {{"max_clearance_angle", "degree", "degree", "place of the largest clearance, from the middle of the gap",
        "phi_max", "eq-closure-lift-off"},
       &V::max_clearance_angle},
      {{"open_area", "m2", "mm2", "open area between ring and bore without the end gap", "A_o", "eq-closure-area"},
       &V::open_area},
      {{"contact_angle", "degree", "degree", "angle of all contact arcs", "phi_c", "eq-closure-complementarity"},
       &V::contact_angle},
      {{"mean_wall_force", "N/rad", "N/rad", "mean force of the wall", "w_m", "eq-closure-mean-force"},
       &V::mean_wall_force},
      {{"share_in_points", "1", "%", "share of the wall's force in point forces", "s_P", "eq-closure-mean-force"},
       &V::share_in_points},
      {{"moment_at_back", "N m", "N m", "bending moment opposite the gap, closing positive", "M_b",
        "eq-closure-moment"},
       &V::moment_at_back},
      {{"tangential_force", "N", "N", "tangential force of the ring", "F_t", "eq-closure-target"},
       &V::tangential_force},
      {{"second_moment", "m4", "mm4", "second moment of the section", "I", "eq-closure-beam"}, &V::second_moment},
      {{"free_gap", "m", "mm", "opening of the free ring less the end gap, to first order", "s",
        "eq-closure-free-shape"},
       &V::free_gap},
      {{"projection", "1", "%", "pressure of order 1 that balances the target, over its mean", "a_1",
        "eq-closure-target"},
       &V::projection},
      {{"unbalanced_share", "1", "1", "resultant of wall and gas over the tangential force", "r_F",
        "eq-closure-complementarity"},
       &V::unbalanced_share},
  };
  return table;
}

FourierSeries bore_deviation(const Case& c, std::optional<double> height) {
  std::vector<FourierOrder> orders;
  append_terms(c.liner.distortion, height, orders);
  append_terms(c.liner.thermal_distortion, height, orders);
  if (c.liner.distortion_map && !c.liner.map->height.empty()) {
    const Sections map = sections_of(*c.liner.map, c.liner.map_orders);
    append_at(map, map.height.size() > 1 ? height.value_or(map.height.front()) : map.height.front(), orders);
  }
  return FourierSeries(std::move(orders));
}

std::vector<FourierSeries> dynamic_deviations(const Case& c) {
  if (!c.liner.dynamic_distortion) return {};
  return series_of(c.liner.dynamic->deviation, c.liner.dynamic->first_angle_deg, c.liner.map_orders);
}

std::vector<double> bore_heights(const Case& c) {
  std::set<double> heights;
  for (const auto* terms : {&c.liner.distortion, &c.liner.thermal_distortion}) {
    for (const FourierTerm& term : *terms) {
      if (term.height) heights.insert(*term.height);
    }
  }
  if (c.liner.distortion_map && c.liner.map->height.size() > 1)
    heights.insert(c.liner.map->height.begin(), c.liner.map->height.end());
  return {heights.begin(), heights.end()};
}

models::RingBeam ring_beam(const Case& c) {
  models::RingBeamSize size = beam_size(c);
  if (c.ring.free_shape) {
    const models::FreeShapeFit fit = free_ring(c);
    size.tangential_force = fit.tangential_force;
    return {size, fit.pressure_orders};
  }
  size.tangential_force =
      models::tangential_force_from_elastic_pressure(elastic_pressure(c), c.ring.face_width, c.engine.bore);
  return {size, c.ring.pressure_points ? orders_of_points(c.ring) : series_of(c.ring.pressure_orders, std::nullopt)};
}

StaticClosure static_closure(const Case& whole) {
  const Case& c = whole.rings.empty() ? whole : whole.rings.front();
  const models::RingBeam beam = ring_beam(c);
  const FourierSeries bore = bore_deviation(c, c.conform.height).turned(in_rad(c.ring.gap_position_deg));
  const double gas = c.conform.gas_pressure * c.ring.face_width * c.engine.bore / 2;
  models::RingClosure closure(models::RingAtWall(beam, bore, gas));
  const ClosureValues values = values_of(c, closure);
  std::vector<std::string> notes = closure_notes(c, bore, closure);
  std::optional<models::FreeShapeFit> shape;
  if (c.ring.free_shape) shape = free_ring(c);
  return {std::move(closure), values, std::move(shape), std::move(notes), section_values(c)};
}

}  // namespace ringfilm::cycle
