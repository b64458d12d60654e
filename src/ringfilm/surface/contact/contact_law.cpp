#include "ringfilm/surface/contact/contact_law.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "ringfilm/base/error.hpp"
#include "ringfilm/surface/contact/flow_cell.hpp"
#include "ringfilm/surface/topography/regions.hpp"

namespace ringfilm::surface {
namespace {

constexpr std::size_t kUsualSeparations = 16;
constexpr double kMinUsual = 0.4;            // Sq
constexpr double kMaxUsual = 0.97;           // share of the height of the highest point
constexpr double kMaxUsualArea = 1.0 / 3.0;  // rings remain below it
// Separations without contact over the height of the highest point.
constexpr double kUsualOfFlow[] = {2.0, 1.6, 1.3, 1.1};
constexpr double kMinGap = 1e-4;                      // Sq: first place of the distribution of the gap
constexpr double kGapsPerDecade = 16, kMaxGap = 100;  // places, and the last one over Sq or the largest separation

HeightMap sum_at(const SurfacePair& pair, std::size_t position) {
  if (!pair.second) return pair.first;
  const Shift shift = shift_of(position, *pair.second, pair.edges);
  return sum_of_surfaces(pair.first, *pair.second, pair.edges, shift.x, shift.y);
}

RoughContact contact_at(const SurfacePair& pair, std::size_t position) {
  return {sum_at(pair, position), pair.edges, pair.material};
}

std::size_t positions_of(const SurfacePair& pair) { return pair.second ? std::max<std::size_t>(pair.shifts, 1) : 1; }

/// Largest first: each solution is the first guess of the next.
std::vector<std::size_t> falling_order(std::span<const double> values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return values[a] > values[b]; });
  return order;
}

void add(const ContactAtSeparation& of, double weight, ContactLawPoint& to) {
  ContactAtSeparation& mean = to.mean;
  mean.separation_m = of.separation_m;
  mean.residual = std::max(mean.residual, of.residual);
  mean.iterations += of.iterations;
  for (const auto member :
       {&ContactAtSeparation::pressure, &ContactAtSeparation::area_share, &ContactAtSeparation::pixel_share,
        &ContactAtSeparation::mean_gap_m, &ContactAtSeparation::spots_per_m2}) {
    mean.*member += weight * of.*member;
  }
  // Shares of the area in contact and of the load: divided by the sums at the end.
  mean.share_at_cap += weight * of.pixel_share * of.share_at_cap;
  mean.load_next_to_missing += weight * of.pressure * of.load_next_to_missing;
}

double variance(const HeightMap& map) {
  double sum = 0, squares = 0, count = 0;
  for (std::size_t i = 0; i < map.points(); ++i) {
    if (!map.measured(i)) continue;
    sum += map.height_m[i];
    squares += map.height_m[i] * map.height_m[i];
    count += 1;
  }
  return count > 0 ? squares / count - sum * sum / (count * count) : 0;
}

/// Share of the first surface in the variance of the heights, less that of the second: 1 where only the first is rough.
double roughness_difference(const SurfacePair& pair) {
  if (!pair.second) return 1;
  const double first = variance(pair.first), second = variance(*pair.second);
  return first + second > 0 ? (first - second) / (first + second) : 1;
}

/// True gap, closed in contact; points without a height have that of the deepest one that was measured.
std::vector<double> open_gap(const RoughContact& contact) {
  std::vector<double> gap(contact.gap().begin(), contact.gap().end());
  double deepest = 0;
  for (std::size_t i = 0; i < gap.size(); ++i) {
    gap[i] = contact.pressure()[i] > 0 ? 0 : std::max(gap[i], 0.0);
    if (contact.measured(i)) deepest = std::max(deepest, gap[i]);
  }
  for (double& h : gap) h = std::min(h, deepest);
  return gap;
}

/// Even in ln H, from far below the roughness to far above the largest separation.
std::vector<double> gap_places(double Sq_m, std::span<const double> separations_m) {
  const double largest = std::max(kMaxGap * Sq_m, 2 * *std::max_element(separations_m.begin(), separations_m.end()));
  std::vector<double> places;
  for (int k = 0; places.empty() || places.back() < largest; ++k) {
    places.push_back(kMinGap * Sq_m * std::pow(10.0, k / kGapsPerDecade));
  }
  return places;
}

/// Adds the open gaps to the distribution, each to both places next to it, so that area and mean gap are kept.
void add_gaps(const RoughContact& contact, std::span<const double> gap, const std::vector<double>& places,
              double weight, std::vector<double>& share) {
  share.resize(places.size());
  double points = 0;
  for (std::size_t i = 0; i < gap.size(); ++i) points += contact.measured(i) ? 1 : 0;
  const double each = weight / points;
  for (std::size_t i = 0; i < gap.size(); ++i) {
    if (!contact.measured(i) || !(gap[i] > 0)) continue;
    const double place = kGapsPerDecade * std::log10(gap[i] / places.front());
    const auto low = static_cast<std::size_t>(std::clamp(place, 0.0, static_cast<double>(places.size()) - 2));
    const double upper = std::clamp((gap[i] - places[low]) / (places[low + 1] - places[low]), 0.0, 1.0);
    share[low] += each * (1 - upper);
    share[low + 1] += each * upper;
  }
}

void add_flow(const RoughContact& contact, const ContactAtSeparation& found, double difference, double weight,
              const std::vector<double>& places, FlowFactorsOfLaw& to) {
  const std::vector<double> gap = open_gap(contact);
  const FlowFactorsOfGap of = flow_factors(gap, contact.grid());
  const double cube = found.separation_m * found.separation_m * found.separation_m;
  double mean = 0;
  for (const double h : gap) mean += h;
  mean /= static_cast<double>(gap.size());
  to.phi_x += weight * of.conductance_x / cube;
  to.phi_y += weight * of.conductance_y / cube;
  to.phi_s += weight * difference * (mean - of.couette) / contact.rms_m();
  to.phi_fp += weight * of.pressure_stress / found.separation_m;
  add_gaps(contact, gap, places, weight, to.gap_share);
  to.residual = std::max(to.residual, of.residual);
}

void complete(ContactLawPoint& point) {
  ContactAtSeparation& mean = point.mean;
  if (mean.pixel_share > 0) mean.share_at_cap /= mean.pixel_share;
  if (mean.pressure > 0) mean.load_next_to_missing /= mean.pressure;
  if (mean.spots_per_m2 > 0) mean.spot_radius_m = std::sqrt(mean.area_share / (mean.spots_per_m2 * std::numbers::pi));
}

/// The highest point of all positions above the mean plane of its own [m].
double highest_point(const SurfacePair& pair) {
  double highest = 0;
  for (std::size_t position = 0; position < positions_of(pair); ++position) {
    highest = std::max(highest, contact_at(pair, position).highest_m());
  }
  return highest;
}

constexpr double kFewSpots = 5;  // on all maps of a law: fewer are one sample

double last_supported(const ContactLaw& law, std::size_t positions) {
  const double area = static_cast<double>(law.grid.points() * positions) * law.grid.step_x_m * law.grid.step_y_m;
  double last = 0, smallest = std::numeric_limits<double>::max();
  for (const ContactLawPoint& point : law.points) {
    smallest = std::min(smallest, point.mean.separation_m);
    if (point.mean.spots_per_m2 * area >= kFewSpots) last = std::max(last, point.mean.separation_m);
  }
  return last > 0 ? last : smallest;
}

/// Pressure and area of each sample at each separation.
struct Samples {
  std::vector<std::vector<double>> pressure, area;

  void add(std::size_t separations, double before = 0) {
    pressure.emplace_back(separations, before);
    area.emplace_back(separations, before);
  }
  void set(std::size_t k, const ContactAtSeparation& of) {
    pressure.back()[k] = of.pressure;
    area.back()[k] = of.area_share;
  }
};

/// Standard deviation over the samples that have a value at separation k; 0 for fewer than two.
double deviation_of(const std::vector<std::vector<double>>& samples, std::size_t k) {
  double n = 0, sum = 0, squares = 0;
  for (const auto& sample : samples) {
    if (!std::isfinite(sample[k])) continue;
    sum += sample[k];
    n += 1;
  }
  for (const auto& sample : samples) {
    if (std::isfinite(sample[k])) squares += (sample[k] - sum / n) * (sample[k] - sum / n);
  }
  return n < 2 ? 0 : std::sqrt(squares / (n - 1));
}

/// The law of each region of the first position, from the mean plane of the whole: long waves are what they scatter by.
/// A region whose own mean plane lies above the separation would be pressed flat: it has no value there, NaN.
Samples laws_of_regions(const SurfacePair& pair, std::span<const double> separations_m,
                        const std::vector<std::size_t>& order) {
  Samples samples;
  if (pair.regions_across * pair.regions_down < 2) return samples;
  const HeightMap whole = sum_at(pair, 0);
  const double plane = mean_height(whole);
  for (const Region& region : grid_regions(whole, pair.regions_across, pair.regions_down)) {
    const HeightMap part = part_of_map(whole, region);
    const double rise = mean_height(part) - plane;
    RoughContact contact(part, MapEdges::mirrored, pair.material);
    samples.add(separations_m.size(), std::numeric_limits<double>::quiet_NaN());
    for (const std::size_t k : order) {
      if (separations_m[k] > rise) samples.set(k, contact.solve(separations_m[k] - rise));
    }
  }
  return samples;
}

/// Scatter of the laws by the pressures at separations that several spots support and where each sample has one.
LawScatter scatter_of(const Samples& samples, const ContactLaw& law) {
  std::vector<double> at, spots;
  std::vector<std::vector<double>> pressure(samples.pressure.size());
  for (std::size_t k = 0; k < law.points.size(); ++k) {
    const ContactAtSeparation& mean = law.points[k].mean;
    const bool is_everywhere = std::all_of(samples.pressure.begin(), samples.pressure.end(),
                                           [k](const auto& sample) { return std::isfinite(sample[k]); });
    if (mean.separation_m > law.last_supported_m || !is_everywhere) continue;
    at.push_back(mean.separation_m);
    spots.push_back(mean.spots_per_m2);
    for (std::size_t j = 0; j < pressure.size(); ++j) pressure[j].push_back(samples.pressure[j][k]);
  }
  return law_scatter(at, spots, pressure);
}

void check_reach(double highest_m, std::span<const double> separations_m) {
  const double largest = *std::max_element(separations_m.begin(), separations_m.end());
  if (largest < highest_m) return;
  throw InputError("a separation of " + length_text(largest) + " lies beyond the highest point of the pair, " +
                       length_text(highest_m) + " above the mean plane: nothing touches there",
                   "state smaller separations");
}

}  // namespace

Shift shift_of(std::size_t k, const HeightMap& second, MapEdges edges) {
  if (k == 0) return {};
  // Additive recurrence of the plastic number: evenly spread, whatever their count.
  constexpr double kFirst = 0.7548776662466927, kSecond = 0.5698402909980532;
  const std::size_t images = edges == MapEdges::mirrored ? 2 : 1;
  const auto place = [&](double ratio, std::size_t points) {
    const double turn = ratio * static_cast<double>(k);
    return static_cast<std::size_t>((turn - std::floor(turn)) * static_cast<double>(images * points));
  };
  return {place(kFirst, second.points_x), place(kSecond, second.points_y)};
}

ContactLaw contact_law(const SurfacePair& pair, std::span<const double> separations_m) {
  ContactLaw law;
  law.points.resize(separations_m.size());
  law.first_pressure.resize(separations_m.size());
  law.highest_m = highest_point(pair);
  if (!pair.has_flow) check_reach(law.highest_m, separations_m);
  const double difference = roughness_difference(pair);
  const std::size_t positions = positions_of(pair);
  const std::vector<std::size_t> order = falling_order(separations_m);
  Samples samples;
  for (std::size_t position = 0; position < positions; ++position) {
    RoughContact contact = contact_at(pair, position);
    if (position == 0) {
      law.Sq_m = contact.rms_m();
      law.missing_share = contact.missing_share();
      law.grid = contact.grid();
      if (pair.has_flow) law.gap_places_m = gap_places(law.Sq_m, separations_m);
    }
    samples.add(separations_m.size());
    for (const std::size_t k : order) {
      const ContactAtSeparation found = contact.solve(separations_m[k]);
      check_area(found);
      samples.set(k, found);
      if (position == 0) law.first_pressure[k] = found.pressure;
      const double weight = 1 / static_cast<double>(positions);
      add(found, weight, law.points[k]);
      if (pair.has_flow) add_flow(contact, found, difference, weight, law.gap_places_m, law.points[k].flow);
    }
    if (position > 0) continue;
    law.pressure.assign(contact.pressure().begin(), contact.pressure().end());
    law.gap_m.assign(contact.gap().begin(), contact.gap().end());
    for (double& gap : law.gap_m) gap = std::max(gap, 0.0);
  }
  const Samples regions = laws_of_regions(pair, separations_m, order);
  for (std::size_t k = 0; k < law.points.size(); ++k) {
    ContactLawPoint& point = law.points[k];
    complete(point);
    point.pressure_deviation = deviation_of(samples.pressure, k);
    point.area_deviation = deviation_of(samples.area, k);
    point.pressure_deviation_of_regions = deviation_of(regions.pressure, k);
    point.area_deviation_of_regions = deviation_of(regions.area, k);
  }
  law.last_supported_m = last_supported(law, positions);
  law.scatter = scatter_of(samples, law) + scatter_of(regions, law);
  return law;
}

std::vector<ContactAtSeparation> contact_of_first_position(const SurfacePair& pair,
                                                           std::span<const double> separations_m) {
  RoughContact contact = contact_at(pair, 0);
  std::vector<ContactAtSeparation> found(separations_m.size());
  for (const std::size_t k : falling_order(separations_m)) found[k] = contact.solve(separations_m[k]);
  return found;
}

std::vector<double> usual_separations(const SurfacePair& pair) {
  RoughContact contact = contact_at(pair, 0);
  const double from = kMaxUsual * contact.highest_m();
  const double to = std::min(kMinUsual * contact.rms_m(), from / 2);
  std::vector<double> separations;
  if (pair.has_flow) {
    for (const double ratio : kUsualOfFlow) separations.push_back(ratio * contact.highest_m());
  }
  for (std::size_t k = 0; k < kUsualSeparations; ++k) {
    const double h = from + (to - from) * static_cast<double>(k) / (kUsualSeparations - 1);
    if (k > 1 && contact.solve(h).pixel_share > kMaxUsualArea) break;
    separations.push_back(h);
  }
  return separations;
}

std::size_t fast_size(std::size_t points) {
  const auto is_fast = [](std::size_t n) {
    for (const std::size_t factor : {2, 3, 5, 7}) {
      while (n % factor == 0) n /= factor;
    }
    return n == 1;
  };
  while (points > 1 && !is_fast(points)) --points;
  return points;
}

}  // namespace ringfilm::surface
