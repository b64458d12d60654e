#include "ringfilm/models/contact/tabulated_contact.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "ringfilm/base/display.hpp"
#include "ringfilm/base/error.hpp"

namespace ringfilm::models {
namespace {

constexpr double kLeftAtReach = 1e-11;  // pressure at the reach over that at separation 0
constexpr std::size_t kMinRows = TabulatedContact::kMinRows;
constexpr int kBefore = 8, kBeyond = 24;  // places before the first row and beyond the last one
constexpr int kCubics = 256;
constexpr double kTailWindow = 4.605170185988091;  // ln 100: rows whose slope and curvature the tail has

void check_falling(const std::vector<double>& values, const std::vector<double>& h, const char* name) {
  const std::size_t rows = h.size();
  if (rows < kMinRows) {
    throw InputError("a contact law of fewer than 4 rows with contact is not a law", "state more separations");
  }
  const auto refuse = [&](const std::string& where) {
    throw InputError(std::string("the ") + name + " of a contact law " + where,
                     "separations rise, pressures and areas fall; rows without contact are not part of a law");
  };
  if (values.size() != rows || !(values.back() > 0)) refuse("is not above 0 in each row");
  for (std::size_t k = 1; k < rows; ++k) {
    if (values[k] < values[k - 1]) continue;
    refuse("does not fall from row to row: " + number_text(values[k - 1]) + " at a separation of " +
           text_in(h[k - 1], kMicrometre) + ", " + number_text(values[k]) + " at " + text_in(h[k], kMicrometre));
  }
}

/// ln of a value beyond the last row: its slope at the end, and the curvature of the last rows.
struct Tail {
  double h, value, slope, curvature;
  double at(double separation) const {
    const double d = separation - h;
    return value + d * (slope + 0.5 * curvature * d);
  }
};

/// By least squares through the last row: value(h) - last = slope d + curvature d^2/2 over the last two decades, 3
/// rows or more. A tail that bends upwards is taken as straight.
Tail tail_of(const std::vector<double>& h, const std::vector<double>& value) {
  const std::size_t n = h.size();
  std::size_t from = n - 3;
  while (from > 0 && std::log(value[from] / value[n - 1]) < kTailWindow) --from;
  double aa = 0, ab = 0, bb = 0, ay = 0, by = 0;
  for (std::size_t k = from; k + 1 < n; ++k) {
    const double a = h[k] - h[n - 1], b = 0.5 * a * a, y = std::log(value[k] / value[n - 1]);
    aa += a * a;
    ab += a * b;
    bb += b * b;
    ay += a * y;
    by += b * y;
  }
  const double last = std::log(value[n - 1]);
  const double determinant = aa * bb - ab * ab;
  const double slope = (ay * bb - by * ab) / determinant, curvature = (by * aa - ay * ab) / determinant;
  if (curvature <= 0 && slope < 0) return {h[n - 1], last, slope, curvature};
  return {h[n - 1], last, ay / aa, 0};
}

/// Separation at which the tail has fallen to this value, searched between its beginning and far away.
double place_of(const Tail& tail, double log_value) {
  double low = tail.h, step = 0.25 / -tail.slope;
  while (tail.at(low + step) > log_value) low += step;
  double high = low + step;
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (low + high);
    (tail.at(middle) > log_value ? low : high) = middle;
  }
  return high;
}

/// Slopes of the cubic spline with two continuous derivatives and no jump of the third next to the ends; where it would
/// not fall they are limited after Fritsch and Carlson 1980.
std::vector<double> falling_slopes(const std::vector<double>& x, const std::vector<double>& y) {
  const std::size_t n = x.size();
  std::vector<double> slope(n), upper(n), step(n - 1), secant(n - 1);
  for (std::size_t k = 0; k + 1 < n; ++k) {
    step[k] = x[k + 1] - x[k];
    secant[k] = (y[k + 1] - y[k]) / step[k];
  }
  // Rows lower * s[k-1] + diagonal * s[k] + over * s[k+1] = right, eliminated downwards.
  const auto eliminate = [&](std::size_t k, double lower, double diagonal, double over, double right) {
    const double pivot = k == 0 ? diagonal : diagonal - lower * upper[k - 1];
    upper[k] = over / pivot;
    slope[k] = (right - (k == 0 ? 0 : lower * slope[k - 1])) / pivot;
  };
  const double first = step[0] + step[1], last = step[n - 2] + step[n - 3];
  eliminate(0, 0, step[1], first,
            ((step[0] + 2 * first) * step[1] * secant[0] + step[0] * step[0] * secant[1]) / first);
  for (std::size_t k = 1; k + 1 < n; ++k) {
    eliminate(k, step[k], 2 * (step[k - 1] + step[k]), step[k - 1],
              3 * (step[k] * secant[k - 1] + step[k - 1] * secant[k]));
  }
  eliminate(
      n - 1, last, step[n - 3], 0,
      (step[n - 2] * step[n - 2] * secant[n - 3] + (2 * last + step[n - 2]) * step[n - 3] * secant[n - 2]) / last);
  for (std::size_t k = n - 1; k-- > 0;) slope[k] -= upper[k] * slope[k + 1];
  for (std::size_t k = 0; k < n; ++k) {
    const double near = k == 0 ? secant[0] : k + 1 == n ? secant[n - 2] : std::max(secant[k - 1], secant[k]);
    slope[k] = std::clamp(slope[k], 3 * near, 0.0);  // both secants fall: within this the cubic falls, too
  }
  return slope;
}

/// Eighth roots at places that rise from 0 to the reach, with their slopes.
struct Root {
  double scale = 0;
  std::vector<double> h, y, slope;

  /// @param k the interval of the separation, from the one given on
  ValueAndSlope<double> at(double separation, std::size_t& k) const {
    while (k + 2 < h.size() && h[k + 1] <= separation) ++k;
    const double d = h[k + 1] - h[k], t = (separation - h[k]) / d, rise = y[k + 1] - y[k];
    const double a = slope[k] * d, b = slope[k + 1] * d;
    const double c_2 = 3 * rise - 2 * a - b, c_3 = a + b - 2 * rise;
    return {y[k] + t * (a + t * (c_2 + t * c_3)), (a + t * (2 * c_2 + 3 * t * c_3)) / d};
  }
};

Root root_of(const std::vector<double>& h, const std::vector<double>& value, double reach) {
  Root root;
  const Tail tail = tail_of(h, value);
  // Before the first row ln p rises with the slope of the first two.
  const double first_slope = std::log(value[1] / value[0]) / (h[1] - h[0]);
  root.scale = value[0] * std::exp(-first_slope * h[0]);
  const auto add = [&](double place, double log_value) {
    root.h.push_back(place);
    root.y.push_back(std::exp((log_value - std::log(root.scale)) / 8));
  };
  for (int k = 0; h[0] > 0 && k < kBefore; ++k) {
    add(h[0] * k / kBefore, std::log(value[0]) + first_slope * h[0] * (static_cast<double>(k) / kBefore - 1));
  }
  for (std::size_t k = 0; k < h.size() && h[k] < reach; ++k) add(h[k], std::log(value[k]));
  const double last = root.h.back();
  for (int k = 1; k <= kBeyond; ++k) {
    const double place = last + (reach - last) * k / kBeyond;
    add(place, tail.at(place));
  }
  root.slope = falling_slopes(root.h, root.y);
  return root;
}

ContactPieces::Cubics cubics_of(const Root& root, double reach) {
  ContactPieces::Cubics cubics;
  cubics.reserve(kCubics);
  const double width = reach / kCubics;
  std::size_t interval = 0;
  auto from = root.at(0, interval);
  for (int k = 0; k < kCubics; ++k) {
    const auto to = root.at((k + 1) * width, interval);
    const double rise = to.value - from.value;
    const double least = 3 * std::min(rise, 0.0);  // within it the cubic falls
    const double a = std::max(from.slope * width, least), b = std::max(to.slope * width, least);
    cubics.push_back({from.value, a, 3 * rise - 2 * a - b, a + b - 2 * rise});
    from = to;
  }
  return cubics;
}

}  // namespace

TabulatedContact::TabulatedContact(const ContactTable& table, double trusted_up_to_m)
    : trusted_up_to_(trusted_up_to_m) {
  check_falling(table.pressure, table.h, "pressure");
  check_falling(table.area_share, table.h, "area");
  ContactTable used = table;
  while (used.h.size() > kMinRows && used.h.back() > trusted_up_to_m) {
    for (auto* const column : {&used.h, &used.pressure, &used.area_share}) column->pop_back();
  }
  trusted_up_to_ = std::min(trusted_up_to_m, used.h.back());
  const Tail tail = tail_of(used.h, used.pressure);
  const double first_slope = std::log(used.pressure[1] / used.pressure[0]) / (used.h[1] - used.h[0]);
  const double end = std::log(used.pressure[0]) - first_slope * used.h[0] + std::log(kLeftAtReach);
  const double reach = tail.at(tail.h) > end ? place_of(tail, end) : tail.h;
  const Root pressure_root = root_of(used.h, used.pressure, reach), area_root = root_of(used.h, used.area_share, reach);
  pieces_ = {cubics_of(pressure_root, reach), cubics_of(area_root, reach), reach, pressure_root.scale, area_root.scale};
  for (std::size_t k = 0; k < used.h.size() && used.h[k] < reach; ++k) {
    row_error_ = std::max(row_error_, std::abs(contact(used.h[k]).pressure / used.pressure[k] - 1));
  }
}

void TabulatedContact::pressure(double h, double& p_a, double& dp_a_dh) const {
  if (std::isnan(h)) {
    p_a = dp_a_dh = h;
    return;
  }
  if (h >= pieces_.reach) {
    p_a = dp_a_dh = 0;
    return;
  }
  const double inside = std::max(h, 0.0);
  const auto [piece, d] = pieces_.place(inside);
  const auto& c = pieces_.pressure[piece];
  const double root = ContactPieces::value(c, d), square = root * root, seventh = square * square * square * root;
  const double slope = (c[1] + d * (2 * c[2] + 3 * d * c[3])) / pieces_.reach * static_cast<double>(kCubics);
  dp_a_dh = pieces_.pressure_scale * 8 * seventh * slope;
  p_a = pieces_.pressure_scale * seventh * root + dp_a_dh * (h - inside);
}

AsperityContact::Contact TabulatedContact::contact(double h) const {
  Contact c{};
  pressure(h, c.pressure, c.pressure_slope);
  if (std::isnan(h)) {
    c.area_share = h;
  } else if (h < pieces_.reach) {
    const auto [piece, d] = pieces_.place(std::max(h, 0.0));
    c.area_share = pieces_.area_scale * ContactPieces::eighth_power(ContactPieces::value(pieces_.area[piece], d));
  }
  return c;
}

}  // namespace ringfilm::models
