#include "ringfilm/report/payload/unrolled_picture.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ringfilm::report {
namespace {

PackedField quantised(const std::string& name, const std::vector<float>& values) {
  PackedField field{name, 0, 0, {}};
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  if (low <= high) {
    field.low = low;
    field.high = high;
  }
  constexpr double kSteps = MapPicture::kMissing - 1;
  const double range = field.high - field.low;
  field.values.reserve(values.size());
  for (const double value : values) {
    const double share = range > 0 ? (value - field.low) / range : 0;
    field.values.push_back(std::isfinite(value) ? static_cast<std::uint16_t>(std::lround(kSteps * share))
                                                : MapPicture::kMissing);
  }
  return field;
}

template <class Value>
std::vector<Value> picked(const std::vector<Value>& values, const std::vector<std::size_t>& kept) {
  std::vector<Value> some;
  some.reserve(kept.size());
  for (const std::size_t k : kept) some.push_back(values[k]);
  return some;
}

/// Values of a field at the nodes kept.
std::vector<float> thinned(const std::vector<float>& values, const std::vector<std::size_t>& angles,
                           const std::vector<std::size_t>& strips, const std::vector<std::size_t>& nodes,
                           const cycle::UnrolledFields& fields) {
  std::vector<float> some;
  some.reserve(angles.size() * strips.size() * nodes.size());
  for (const std::size_t k : angles) {
    for (const std::size_t j : strips) {
      for (const std::size_t i : nodes) some.push_back(values[(k * fields.y.size() + j) * fields.x.size() + i]);
    }
  }
  return some;
}

/// The point of one angle that comes first in the order of `before`.
template <class Before>
MapPoint extreme(const std::vector<float>& values, std::size_t angle, const cycle::UnrolledFields& fields,
                 Before before) {
  const std::size_t n_across = fields.x.size(), n_nodes = n_across * fields.y.size();
  const auto begin = values.begin() + static_cast<std::ptrdiff_t>(angle * n_nodes);
  const auto found =
      static_cast<std::size_t>(std::min_element(begin, begin + static_cast<std::ptrdiff_t>(n_nodes), before) - begin);
  return {fields.x[found % n_across], fields.y[found / n_across], begin[static_cast<std::ptrdiff_t>(found)]};
}

}  // namespace

std::vector<std::size_t> spread(std::size_t n, std::size_t most) {
  const std::size_t stride = n <= most ? 1 : (n - 1 + most - 2) / (most - 1);
  std::vector<std::size_t> kept;
  for (std::size_t k = 0; k < n; k += stride) kept.push_back(k);
  if (n > 0 && kept.back() != n - 1) kept.push_back(n - 1);
  return kept;
}

UnrolledPicture unrolled_picture(const cycle::UnrolledFields& fields, const PictureLimits& limits) {
  UnrolledPicture picture;
  const std::size_t n_nodes = fields.x.size() * fields.y.size();
  const std::size_t n_values = n_nodes * fields.crank_angle_deg.size();
  if (n_values == 0 || fields.film_pressure.size() != n_values) return picture;
  std::vector<std::size_t> angles = spread(fields.crank_angle_deg.size(), limits.angles);
  const auto peak = static_cast<std::size_t>(
      std::max_element(fields.film_pressure.begin(), fields.film_pressure.end()) - fields.film_pressure.begin());
  if (!std::binary_search(angles.begin(), angles.end(), peak / n_nodes)) {
    angles.insert(std::lower_bound(angles.begin(), angles.end(), peak / n_nodes), peak / n_nodes);
  }
  const auto strips = spread(fields.y.size(), limits.strips);
  const auto nodes = spread(fields.x.size(), limits.nodes);
  picture.x = picked(fields.x, nodes);
  picture.y = picked(fields.y, strips);
  picture.crank_angle_deg = picked(fields.crank_angle_deg, angles);
  for (const char* name : {"film_pressure", "film_content", "film_thickness"}) {
    const auto& known = cycle::unrolled_fields();
    const auto field = std::find_if(known.begin(), known.end(), [&](const auto& one) { return one.name == name; });
    const std::vector<float>& values = fields.*field->values;
    if (values.size() != n_values) continue;
    picture.fields.push_back(quantised(name, thinned(values, angles, strips, nodes, fields)));
  }
  for (const std::size_t k : angles) {
    picture.highest_pressure.push_back(extreme(fields.film_pressure, k, fields, std::greater<float>()));
    if (fields.film_content.size() == n_values)
      picture.lowest_film_content.push_back(extreme(fields.film_content, k, fields, std::less<float>()));
  }
  return picture;
}

StripPicture strip_picture(const cycle::UnrolledFields& fields, const PictureLimits& limits) {
  StripPicture picture;
  const std::size_t n_values = fields.y.size() * fields.crank_angle_deg.size();
  if (n_values == 0) return picture;
  const auto angles = spread(fields.crank_angle_deg.size(), limits.strip_angles);
  const cycle::UnrolledFields& f = fields;
  for (const cycle::UnrolledField& field : cycle::strip_fields()) {
    const std::vector<float>& values = f.*field.values;
    if (values.size() != n_values) continue;
    std::vector<float> some;
    for (const std::size_t k : angles) {
      const auto begin = values.begin() + static_cast<std::ptrdiff_t>(k * f.y.size());
      some.insert(some.end(), begin, begin + static_cast<std::ptrdiff_t>(f.y.size()));
    }
    picture.fields.push_back(quantised(field.name, some));
  }
  if (!picture.fields.empty()) picture.crank_angle_deg = picked(fields.crank_angle_deg, angles);
  return picture;
}

}  // namespace ringfilm::report
