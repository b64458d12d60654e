#include "measurement/height_maps.hpp"

#include <cmath>
#include <limits>

namespace ringfilm::python {

surface::HeightMap height_map(const GivenNumbers& given, const GivenStep& step) {
  const MaybeMasked heights = maybe_masked_of("heights", given.value);
  const py::ssize_t dimensions = heights.values.ndim();
  if (dimensions != 1 && dimensions != 2) {
    throw InputError("heights have " + std::to_string(dimensions) + " dimensions",
                     "an array of shape (y, x) is required here, or (x,) for a profile");
  }
  surface::HeightMap map;
  map.points_x = static_cast<std::size_t>(heights.values.shape(dimensions - 1));
  map.points_y = dimensions == 1 ? 1 : static_cast<std::size_t>(heights.values.shape(0));
  std::tie(map.step_x_m, map.step_y_m) = pair_of("step", step.value, "m");
  const double* from = heights.values.data();
  map.height_m.assign(from, from + heights.values.size());
  const bool* const masked = heights.mask ? heights.mask->data() : nullptr;
  for (std::size_t i = 0; i < map.height_m.size(); ++i) {
    if (!std::isnan(map.height_m[i]) && !(masked && masked[i])) continue;
    if (map.missing.empty()) map.missing.assign(map.height_m.size(), 0);
    map.missing[i] = 1;
    map.height_m[i] = 0;
  }
  surface::check_map(map);
  return map;
}

py::array heights_of(const surface::HeightMap& map, bool as_row) {
  const auto columns = static_cast<py::ssize_t>(map.points_x), rows = static_cast<py::ssize_t>(map.points_y);
  std::vector<py::ssize_t> shape{rows, columns};
  if (as_row && map.is_profile()) shape = {columns};
  py::array_t<double> heights(shape);
  double* to = heights.mutable_data();
  for (std::size_t i = 0; i < map.height_m.size(); ++i)
    to[i] = map.measured(i) ? map.height_m[i] : std::numeric_limits<double>::quiet_NaN();
  return heights;
}

}  // namespace ringfilm::python
