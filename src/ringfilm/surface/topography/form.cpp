#include "ringfilm/surface/topography/form.hpp"

#include <algorithm>
#include <cmath>

#include "ringfilm/base/error.hpp"
#include "ringfilm/surface/topography/cylinder_fit.hpp"
#include "ringfilm/surface/topography/polynomial_fit.hpp"

namespace ringfilm::surface {
namespace {

constexpr int kMaxFormDegree = 12;

/// Takes a form, which gives its heights row by row, off the measured points, and reports where and how large it was.
template <class Form>
FormRemoved subtract(HeightMap& map, const Form& form) {
  const FormAtCentre centre = form.at_centre();
  double sum = 0, squares = 0;
  std::size_t count = 0;
  std::vector<double> row(map.points_x);
  for (std::size_t j = 0; j < map.points_y; ++j) {
    form.row(j, row);
    double row_sum = 0, row_squares = 0;
    for (std::size_t i = 0; i < map.points_x; ++i) {
      const std::size_t point = map.index(i, j);
      if (!map.measured(point)) {
        map.height_m[point] = 0;
        continue;
      }
      const double above = row[i] - centre.value;
      map.height_m[point] -= row[i];
      row_sum += above;
      row_squares += above * above;
      ++count;
    }
    sum += row_sum;
    squares += row_squares;
  }
  const double mean = sum / static_cast<double>(count);
  FormRemoved removed;
  removed.mean_m = centre.value;
  removed.slope_x = centre.slope_x;
  removed.slope_y = centre.slope_y;
  removed.rms_m = std::sqrt(std::max(0.0, squares / static_cast<double>(count) - mean * mean));
  return removed;
}

FormRemoved remove_polynomial(HeightMap& map, FormKind kind, int degree) {
  FormRemoved removed = subtract(map, fit_polynomial(map, degree));
  removed.kind = kind;
  removed.degree = degree;
  if (degree == 0) {
    removed.text = "mean height";
  } else if (degree == 1) {
    removed.text = map.is_profile() ? "least-squares line" : "least-squares plane";
  } else {
    removed.text = "least-squares polynomial of degree " + std::to_string(degree);
  }
  return removed;
}

FormRemoved remove_cylinder(HeightMap& map) {
  const CylinderForm form = fit_cylinder(map);
  FormRemoved removed = subtract(map, form);
  removed.kind = FormKind::cylinder;
  removed.cylinder = form.cylinder();
  removed.text = map.is_profile() ? "least-squares circle" : "least-squares cylinder";
  removed.text += " of radius " + length_text(removed.cylinder->radius_m);
  return removed;
}

}  // namespace

FormRemoved remove_form(HeightMap& map, const FormChoice& choice) {
  check_map(map);
  switch (choice.kind) {
    case FormKind::none:
      break;
    case FormKind::mean:
      return remove_polynomial(map, FormKind::mean, 0);
    case FormKind::tilt:
      return remove_polynomial(map, FormKind::tilt, 1);
    case FormKind::cylinder:
      return remove_cylinder(map);
    case FormKind::polynomial:
      if (choice.degree < 0 || choice.degree > kMaxFormDegree) {
        throw InputError("a polynomial form of degree " + std::to_string(choice.degree) + " is not offered",
                         "degrees from 0 to " + std::to_string(kMaxFormDegree));
      }
      return remove_polynomial(map, FormKind::polynomial, choice.degree);
  }
  FormRemoved removed;
  removed.text = "nothing";
  return removed;
}

}  // namespace ringfilm::surface
