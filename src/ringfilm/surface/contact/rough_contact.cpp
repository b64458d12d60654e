#include "ringfilm/surface/contact/rough_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "ringfilm/base/error.hpp"
#include "ringfilm/base/number_text.hpp"

namespace ringfilm::surface {
namespace {

constexpr double kTolerance = 1e-6;       // residual, of the rms height
constexpr int kMaxIterations = 1000;      // 20 to 100 were needed
constexpr double kMaxMissing = 0.5;       // share of all points
constexpr double kDepthOfMissing = 1000;  // heights of the map below its mean: out of reach

ContactGrid grid_of(const HeightMap& map, MapEdges edges) {
  return {map.points_x, map.points_y, map.step_x_m, map.is_profile() ? map.step_x_m : map.step_y_m, edges};
}

double checked(double value, const char* name, const char* example) {
  if (std::isfinite(value) && value > 0) return value;
  throw InputError(std::string("a ") + name + " of " + number_text(value) + " Pa is not above 0",
                   std::string("for example ") + example);
}

double dot(std::span<const double> a, std::span<const double> b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

}  // namespace

RoughContact::RoughContact(const HeightMap& sum, MapEdges edges, const ContactMaterial& material)
    : grid_(grid_of(sum, edges)),
      cap_(material.hardness ? checked(*material.hardness, "hardness", "\"2.5 GPa\"")
                             : std::numeric_limits<double>::max()),
      half_space_(grid_, checked(material.E_star, "contact modulus", "\"67.4 GPa\"")),
      z_(sum.height_m),
      missing_(sum.missing) {
  check_map(sum, 2);
  measured_points_ = static_cast<double>(surface::measured_points(sum));
  const double missing_share = 1 - measured_points_ / static_cast<double>(sum.points());
  if (missing_share > kMaxMissing) {
    throw InputError(number_text(100 * missing_share, 3) + " % of the points of the pair have no height, more than " +
                         number_text(100 * kMaxMissing, 3) + " %",
                     "measure again, or take a region with fewer missing points");
  }
  double mean = 0;
  for (std::size_t i = 0; i < z_.size(); ++i) mean += measured(i) ? z_[i] : 0;
  mean /= measured_points_;
  double squares = 0, lowest = 0;
  for (std::size_t i = 0; i < z_.size(); ++i) {
    if (!measured(i)) continue;
    z_[i] -= mean;
    squares += z_[i] * z_[i];
    highest_m_ = std::max(highest_m_, z_[i]);
    lowest = std::min(lowest, z_[i]);
  }
  Sq_m_ = std::sqrt(squares / measured_points_);
  if (!(Sq_m_ > 0)) throw InputError("the pair of surfaces is flat: it has no roughness to touch with");
  for (std::size_t i = 0; i < z_.size(); ++i) {
    if (!measured(i)) z_[i] = -kDepthOfMissing * (highest_m_ - lowest);
  }
  for (auto* const field : {&p_, &gap_, &violation_, &former_violation_, &direction_, &work_}) {
    field->assign(z_.size(), 0.0);
  }
}

void RoughContact::update_gap(double separation_m) {
  half_space_.displace(p_, gap_);
  for (std::size_t i = 0; i < z_.size(); ++i) gap_[i] += separation_m - z_[i];
}

/// Violation of the complementarity at each point and its rms over the points in contact, relative to Sq.
double RoughContact::complementarity() {
  double squares = 0, contacts = 0;
  for (std::size_t i = 0; i < z_.size(); ++i) {
    const double gap = gap_[i];
    const bool free = p_[i] <= 0 ? gap < 0 : p_[i] >= cap_ ? gap > 0 : true;
    violation_[i] = free ? gap : 0;
    squares += violation_[i] * violation_[i];
    contacts += p_[i] > 0 ? 1 : 0;
  }
  return std::sqrt(squares / std::max(contacts, 1.0)) / Sq_m_;
}

/// Projected conjugate gradients after @cite polonsky1999 with both bounds, preconditioned by the half-space itself:
/// the direction is the pressure that would displace what violates the complementarity.
int RoughContact::iterate(double separation_m, double& residual) {
  double former_product = 0;
  std::fill(direction_.begin(), direction_.end(), 0.0);
  std::fill(former_violation_.begin(), former_violation_.end(), 0.0);
  update_gap(separation_m);
  for (int iteration = 0; iteration < kMaxIterations; ++iteration) {
    residual = complementarity();
    if (residual < kTolerance) return iteration;
    half_space_.press(violation_, work_);
    double product = 0, common = 0;
    for (std::size_t i = 0; i < z_.size(); ++i) {
      if (violation_[i] == 0) continue;
      product += violation_[i] * work_[i];
      common += former_violation_[i] * work_[i];
    }
    const double keep = former_product > 0 ? std::max(0.0, (product - common) / former_product) : 0;
    for (std::size_t i = 0; i < z_.size(); ++i) {
      direction_[i] = violation_[i] == 0 ? 0 : work_[i] + keep * direction_[i];
    }
    former_product = product;
    former_violation_.swap(violation_);
    const double curvature = half_space_.work(direction_);
    if (!(curvature > 0)) break;
    const double step = dot(former_violation_, direction_) / curvature;
    for (std::size_t i = 0; i < z_.size(); ++i) {
      if (direction_[i] != 0) p_[i] = std::clamp(p_[i] - step * direction_[i], 0.0, cap_);
    }
    update_gap(separation_m);
  }
  residual = complementarity();
  return kMaxIterations;
}

ContactAtSeparation RoughContact::solve(double separation_m) {
  if (!(separation_m > 0)) {
    throw InputError("a separation of " + length_text(separation_m) + " is not above 0",
                     "half-space theory ends before the mean planes meet");
  }
  if (separation_m >= highest_m_) std::fill(p_.begin(), p_.end(), 0.0);
  double residual = 0;
  const int iterations = iterate(separation_m, residual);
  if (!(residual < kTolerance)) {
    throw ConvergenceError("no contact pressure was found at a separation of " + length_text(separation_m) +
                           ": residual " + number_text(residual) + " after " + std::to_string(iterations) +
                           " iterations");
  }
  return measures(separation_m, residual, iterations);
}

void check_area(const ContactAtSeparation& contact) {
  constexpr double kPixels = 0.005;  // by which the area is uncertain
  if (contact.area_share <= kMaxContactArea + kPixels) return;
  throw InputError("at a separation of " + length_text(contact.separation_m) + " the real contact area is " +
                       number_text(100 * contact.area_share, 3) + " % of the nominal one, more than " +
                       number_text(100 * kMaxContactArea, 3) + " %",
                   "state larger separations: half-space theory ends here");
}

ContactAtSeparation RoughContact::measures(double separation_m, double residual, int iterations) const {
  ContactAtSeparation of;
  of.separation_m = separation_m;
  of.residual = residual;
  of.iterations = iterations;
  double sum = 0, contacts = 0, at_cap = 0, gap = 0, near = 0;
  std::vector<std::uint8_t> contact(p_.size());
  const std::size_t columns = grid_.points_x, rows = grid_.points_y;
  const auto is_missing = [&](std::size_t i, std::size_t j) { return missing_[j * columns + i] != 0; };
  for (std::size_t point = 0; point < p_.size(); ++point) {
    if (measured(point)) gap += std::max(gap_[point], 0.0);
    if (!(p_[point] > 0)) continue;
    contact[point] = 1;
    sum += p_[point];
    contacts += 1;
    at_cap += p_[point] >= cap_ ? 1 : 0;
    if (missing_.empty()) continue;
    const std::size_t i = point % columns, j = point / columns;
    const bool is_near = (i > 0 && is_missing(i - 1, j)) || (i + 1 < columns && is_missing(i + 1, j)) ||
                         (j > 0 && is_missing(i, j - 1)) || (j + 1 < rows && is_missing(i, j + 1));
    near += is_near ? p_[point] : 0;
  }
  const double points = static_cast<double>(p_.size());
  of.mean_gap_m = gap / measured_points_;
  of.pressure = sum / points;
  of.pixel_share = contacts / points;
  if (contacts == 0) return of;
  of.area_share = std::max(corrected_area_share(contact, grid_, points), of.pressure / cap_);
  of.share_at_cap = at_cap / contacts;
  of.load_next_to_missing = near / sum;
  const double area = points * grid_.step_x_m * grid_.step_y_m;
  const double spots = static_cast<double>(count_spots(contact, grid_));
  of.spots_per_m2 = spots / area;
  of.spot_radius_m = std::sqrt(of.area_share * area / (spots * std::numbers::pi));
  return of;
}

}  // namespace ringfilm::surface
