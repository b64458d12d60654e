#include "height_maps.hpp"

#include <cmath>
#include <limits>

namespace ringfilm::python {

surface::HeightMap height_map(const Heights& heights, const py::object& step) {
  if (heights.ndim() != 1 && heights.ndim() != 2) {
    throw InputError("heights have " + std::to_string(heights.ndim()) + " dimensions",
                     "an array of shape (y, x) is wanted here, or (x,) for a profile");
  }
  surface::HeightMap map;
  const bool is_profile = heights.ndim() == 1;
  map.points_x = static_cast<std::size_t>(heights.shape(heights.ndim() - 1));
  map.points_y = is_profile ? 1 : static_cast<std::size_t>(heights.shape(0));
  if (py::hasattr(step, "__len__")) {
    const auto [x, y] = py::cast<std::pair<double, double>>(step);
    map.step_x_m = x;
    map.step_y_m = y;
  } else {
    map.step_x_m = map.step_y_m = py::cast<double>(step);
  }
  map.height_m.assign(heights.data(), heights.data() + heights.size());
  for (std::size_t i = 0; i < map.height_m.size(); ++i) {
    if (!std::isnan(map.height_m[i])) continue;
    if (map.missing.empty()) map.missing.assign(map.height_m.size(), 0);
    map.missing[i] = 1;
    map.height_m[i] = 0;
  }
  surface::check_map(map);
  return map;
}

namespace {

py::array filled(const surface::HeightMap& map, const std::vector<py::ssize_t>& shape) {
  py::array_t<double> heights(shape);
  double* to = heights.mutable_data();
  for (std::size_t i = 0; i < map.height_m.size(); ++i)
    to[i] = map.measured(i) ? map.height_m[i] : std::numeric_limits<double>::quiet_NaN();
  return heights;
}

}  // namespace

py::array heights_of(const surface::HeightMap& map, const Heights& like) {
  return filled(map, {like.shape(), like.shape() + like.ndim()});
}

py::array heights_of(const surface::HeightMap& map) {
  const auto columns = static_cast<py::ssize_t>(map.points_x), rows = static_cast<py::ssize_t>(map.points_y);
  return map.is_profile() ? filled(map, {columns}) : filled(map, {rows, columns});
}

std::vector<double> numbers_of(const Heights& array) { return {array.data(), array.data() + array.size()}; }

py::array array_of(const std::vector<double>& values) {
  return py::array_t<double>(static_cast<py::ssize_t>(values.size()), values.data());
}

}  // namespace ringfilm::python
