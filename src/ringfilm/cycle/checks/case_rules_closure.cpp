#include "ringfilm/cycle/checks/case_rules_closure.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>

#include "ringfilm/base/display.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/cycle/checks/case_rules.hpp"
#include "ringfilm/cycle/setup/free_ring.hpp"

namespace ringfilm::cycle {
namespace {

using Breaches = std::vector<RuleBreach>;

void check_section(const Case& c, Breaches& breaches) {
  const std::optional<double> t = c.ring.thickness();
  if (!t) {
    if (c.problem != Problem::kClosure && !c.bends()) return;
    breaches.push_back({"ring.radial_thickness",
                        "the key ring.radial_thickness is missing: how a ring bends follows from it",
                        "write, for example, radial_thickness = \"3.5 mm\" in [ring]", RuleBreach::By::kMissingKey});
  } else if (!(*t < c.engine.bore / 4)) {
    breaches.push_back({"ring.radial_thickness",
                        "ring.radial_thickness = " + text_in(*t, kMillimetre) + " is not thin in a bore of " +
                            text_in(c.engine.bore, kMillimetre),
                        "the ring is a thin curved beam: its thickness is below a quarter of the bore, usually 1/25"});
  }
}

void check_end_gap(const Case& c, Breaches& breaches) {
  const std::optional<double> t = c.ring.thickness();
  if (!c.ring.end_gap || !t) return;
  const double circumference = std::numbers::pi * (c.engine.bore - *t);
  if (*c.ring.end_gap < circumference / 2) return;
  const bool is_all = *c.ring.end_gap >= circumference;
  breaches.push_back({"ring.end_gap",
                      "ring.end_gap = " + text_in(*c.ring.end_gap, kMillimetre) + " is not below " +
                          (is_all ? "" : "half of ") + "the circumference of the ring at its centroid, " +
                          text_in(circumference, kMillimetre),
                      "state the gap between the ends of the ring in the bore, for example \"0.3 mm\""});
}

/// What the terms of one list add to the radius at most, at any one height [m].
double largest_deviation(const std::vector<FourierTerm>& terms) {
  double most = 0;
  for (const FourierTerm& at : terms) {
    double sum = 0;
    for (const FourierTerm& term : terms) {
      if (!term.height || !at.height || *term.height == *at.height) sum += std::abs(term.amplitude);
    }
    most = std::max(most, sum);
  }
  return most;
}

void check_bore(const char* key, const std::vector<FourierTerm>& terms, const Case& c, Breaches& breaches) {
  const double deviation = largest_deviation(terms);
  if (deviation < c.engine.bore / 2) return;
  breaches.push_back({key,
                      std::string("the amplitudes of ") + key + ", " + text_in(deviation, kMillimetre) +
                          " together, leave no bore of the radius " + text_in(c.engine.bore / 2, kMillimetre),
                      "amplitudes are deviations of the radius, for example \"15 um\""});
}

/// Deviations of a map that small deflections about the closed ring may still follow, over the radius of the bore.
constexpr double kMaxOfMap = 0.1;

void check_map(const char* key, const std::vector<std::vector<double>>& map, const Case& c, Breaches& breaches) {
  double most = 0;
  for (const std::vector<double>& row : map) {
    for (const double deviation : row) most = std::max(most, std::abs(deviation));
  }
  if (most < kMaxOfMap * c.engine.bore / 2) return;
  breaches.push_back(
      {key,
       std::string(key) + " deviates by " + text_in(most, kMillimetre) + " from a bore of the radius " +
           text_in(c.engine.bore / 2, kMillimetre) + ", more than small deflections of a ring can follow",
       "the map has deviations of the radius, mostly below 0.1 mm, not the radius itself; check its unit"});
}

/// A term without a height holds at all; heights of one list are stated for each term or for none.
void check_heights(const char* key, const std::vector<FourierTerm>& terms, Breaches& breaches) {
  const auto with = std::count_if(terms.begin(), terms.end(), [](const auto& term) { return term.height.has_value(); });
  if (with == 0 || with == static_cast<std::ptrdiff_t>(terms.size())) return;
  breaches.push_back({key, std::string(key) + " has terms with a height and terms without one",
                      "state the height of every term, or of none"});
}

/// Heights between which the bore is known by these sections.
void check_covered(const char* key, const std::vector<double>& heights, double height, Breaches& breaches) {
  if (heights.empty()) return;
  const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
  if (height >= *low && height <= *high) return;
  breaches.push_back({"conform.height",
                      "conform.height = " + text_in(height, kMillimetre) + " is outside the bore that is known by " +
                          key + ", " + range_in(*low, *high, kMillimetre),
                      "heights are not extrapolated: state one between these, or more sections of the bore"});
}

/// A ring that bends over a cycle passes the whole stroke.
void check_stroke_covered(const char* key, const std::vector<double>& heights, const Case& c, Breaches& breaches) {
  if (!c.bends() || heights.empty()) return;
  const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
  if (*low <= 0 && *high >= c.engine.stroke) return;
  breaches.push_back({key,
                      std::string("the bore is known by ") + key + " from " + range_in(*low, *high, kMillimetre) +
                          ", and the ring passes " + range_in(0, c.engine.stroke, kMillimetre),
                      "heights count from the ring at TDC and are not extrapolated: state sections at or beyond both "
                      "ends of the stroke"});
}

std::vector<double> heights_of(const std::vector<FourierTerm>& terms) {
  std::vector<double> heights;
  for (const FourierTerm& term : terms) {
    if (term.height) heights.push_back(*term.height);
  }
  return heights;
}

void check_place(const Case& c, Breaches& breaches) {
  const std::vector<double> cold = heights_of(c.liner.distortion), hot = heights_of(c.liner.thermal_distortion);
  const std::vector<double>& map = c.liner.map->height;
  const bool varies = !cold.empty() || !hot.empty() || map.size() > 1;
  if (c.problem == Problem::kClosure && varies && !c.conform.height) {
    breaches.push_back({"conform.height", "conform.height is missing: the bore changes along the stroke",
                        "state where the ring is, for example height = \"20 mm\" in [conform]",
                        RuleBreach::By::kMissingKey});
  } else if (c.conform.height && !varies && !c.liner.distortion_map) {
    breaches.push_back({"conform.height", "conform.height is stated, and the bore is the same at all heights",
                        "take it out, or state heights in liner.distortion or a liner.distortion_map"});
  }
  check_stroke_covered("liner.distortion", cold, c, breaches);
  check_stroke_covered("liner.thermal_distortion", hot, c, breaches);
  if (map.size() > 1) check_stroke_covered("liner.distortion_map", map, c, breaches);
  if (!c.conform.height) return;
  check_covered("liner.distortion", cold, *c.conform.height, breaches);
  check_covered("liner.thermal_distortion", hot, *c.conform.height, breaches);
  check_covered("liner.distortion_map", map, *c.conform.height, breaches);
}

/// Points of the pressure in place of its orders.
void check_pressure_points(const Ring& ring, Breaches& breaches) {
  if (!ring.pressure_points) return;
  const char* key = "ring.pressure_points";
  if (!ring.pressure_orders.empty() || ring.free_shape) {
    breaches.push_back({key,
                        std::string("the pressure of the ring is stated twice: ring.pressure_points and ") +
                            (ring.free_shape ? "ring.free_shape" : "ring.pressure_orders"),
                        "state one of them"});
  }
  const std::vector<double>& pressure = ring.pressure_around->pressure;
  if (pressure.empty()) return;  // not read
  double sum = 0;
  for (const double one : pressure) sum += one;
  if (!(sum > 0)) {
    breaches.push_back({key, "the pressure of ring.pressure_points pulls the bore inwards all in all",
                        "pressures that press on the bore are positive"});
  }
  const auto most = static_cast<int>((pressure.size() - 1) / 2);
  if (ring.pressure_points_orders <= most) return;
  breaches.push_back({"ring.pressure_points_orders",
                      "ring.pressure_points_orders = " + std::to_string(ring.pressure_points_orders) +
                          " is more than " + std::to_string(pressure.size()) + " points have",
                      "take " + std::to_string(most) + " or fewer, or state more points"});
}

/// Orders of the pressure that a smoothing may leave; a line force of more would be noise.
constexpr int kMinOrders = 2, kMaxOrders = 40;

}  // namespace

bool shows_free_ring(const Case& c, std::vector<RuleBreach>& breaches) {
  const std::size_t before = breaches.size();
  const Ring& ring = c.ring;
  if (!ring.pressure_orders.empty()) {
    breaches.push_back({"ring.pressure_orders",
                        "the pressure of the ring is stated twice: ring.pressure_orders and ring.free_shape",
                        "the free shape is that of one pressure; remove one of the two"});
  }
  const std::optional<double> t = ring.thickness();
  if (!t) {
    breaches.push_back({"ring.radial_thickness", "ring.free_shape is stated without ring.radial_thickness",
                        "write, for example, radial_thickness = \"3.5 mm\" in [ring]", RuleBreach::By::kMissingKey});
    return false;
  }
  if (!(ring.free_shape_smoothing > 0) || !(c.engine.bore > *t)) return false;  // refused elsewhere
  const int orders = orders_of_free_ring(c);
  if (orders < kMinOrders || orders > kMaxOrders) {
    const double circumference = std::numbers::pi * (c.engine.bore - *t);
    breaches.push_back({"ring.free_shape_smoothing",
                        "ring.free_shape_smoothing = " + text_in(ring.free_shape_smoothing, kMillimetre) + " leaves " +
                            std::to_string(orders) + " orders of the pressure",
                        "state a length between " + text_in(circumference / kMaxOrders, kMillimetre) + " and " +
                            text_in(circumference / kMinOrders, kMillimetre) +
                            ": the shortest wave around the ring that is shape and not noise"});
  }
  if (breaches.size() > before || ring.free_ring->radius.empty()) return false;
  try {
    free_ring(c);
  } catch (const InputError& error) {
    for (const Fault& fault : error.faults()) {
      breaches.push_back({"ring.free_shape", "ring.free_shape: " + fault.message, fault.remedy});
    }
  }
  return breaches.size() == before;
}

void append_closure_breaches(const Case& c, std::vector<RuleBreach>& breaches) {
  if (!(c.engine.bore > 0)) return;  // refused by its own range
  check_section(c, breaches);
  check_end_gap(c, breaches);
  check_bore("liner.distortion", c.liner.distortion, c, breaches);
  check_bore("liner.thermal_distortion", c.liner.thermal_distortion, c, breaches);
  if (c.liner.distortion_map) check_map("liner.distortion_map", c.liner.map->deviation, c, breaches);
  if (c.liner.dynamic_distortion) check_map("liner.dynamic_distortion", c.liner.dynamic->deviation, c, breaches);
  check_heights("liner.distortion", c.liner.distortion, breaches);
  check_heights("liner.thermal_distortion", c.liner.thermal_distortion, breaches);
  check_place(c, breaches);
  check_pressure_points(c.ring, breaches);
}

}  // namespace ringfilm::cycle
