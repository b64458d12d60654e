#include "ringfilm/surface/topography/cylinder_fit.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <numbers>
#include <optional>

#include "ringfilm/base/error.hpp"

namespace ringfilm::surface {
namespace {

using Parameters = CylinderForm::Parameters;
using Vector5 = Eigen::Matrix<double, 5, 1>;
using Matrix5 = Eigen::Matrix<double, 5, 5>;

constexpr int kMaxNewtonSteps = 40;

double from_centre(std::size_t i, std::size_t points, double step_m) {
  return (static_cast<double>(i) - 0.5 * static_cast<double>(points - 1)) * step_m;
}

/// Across a cylinder: places and height under the ridge.
struct Section {
  double across, along, root, drop;
};

Section section(const Parameters& at, double x_m, double y_m) {
  const double sine = std::sin(at.angle_rad), cosine = std::cos(at.angle_rad);
  const double across = -x_m * sine + y_m * cosine - at.offset_m, along = x_m * cosine + y_m * sine;
  const double bend = at.curvature_per_m * across;
  const double root = std::sqrt(std::max(0.0, 1 - bend * bend));
  return {across, along, root, -bend * across / (1 + root)};
}

/// Sums of squares and products of the residuals and their slopes.
struct NormalEquations {
  Matrix5 products = Matrix5::Zero();
  Vector5 right = Vector5::Zero();
  double squares = 0;
  std::size_t points = 0;
};

/// Nothing where the map reaches over the side.
std::optional<NormalEquations> normal_equations(const HeightMap& map, const Parameters& at) {
  NormalEquations sums;
  const double k = std::hypot(1.0, at.tilt), c = at.curvature_per_m;
  const double sine = std::sin(at.angle_rad), cosine = std::cos(at.angle_rad);
  for (std::size_t j = 0; j < map.points_y; ++j) {
    const double y = from_centre(j, map.points_y, map.step_y_m);
    Matrix5 products = Matrix5::Zero();
    Vector5 right = Vector5::Zero();
    double squares = 0;
    for (std::size_t i = 0; i < map.points_x; ++i) {
      const std::size_t point = map.index(i, j);
      if (!map.measured(point)) continue;
      const double x = from_centre(i, map.points_x, map.step_x_m);
      const double u = -x * sine + y * cosine, v = x * cosine + y * sine, w = u - at.offset_m;
      const double under_root = 1 - c * c * w * w;
      if (under_root < 1e-4) return std::nullopt;
      const double r = std::sqrt(under_root), drop = -c * w * w / (1 + r), side = -c * w / r;
      Vector5 slopes;
      slopes << 1, v + drop * at.tilt / k, k * w * w * (1 / (1 + r) - 1 / r), -k * side, at.tilt * u - k * side * v;
      const double residual = map.height_m[point] - (at.height_m + at.tilt * v + k * drop);
      products.selfadjointView<Eigen::Lower>().rankUpdate(slopes);
      right += residual * slopes;
      squares += residual * residual;
      ++sums.points;
    }
    sums.products += products;
    sums.right += right;
    sums.squares += squares;
  }
  sums.products.triangularView<Eigen::StrictlyUpper>() = sums.products.transpose();
  return sums;
}

/// From the paraboloid of least squares: across the axis it bends most.
Parameters first_guess(const HeightMap& map) {
  const FormAtCentre at = fit_polynomial(map, 2).at_centre();
  Parameters guess{at.value, 0, 0, 0, -std::numbers::pi / 2};
  double slope_across = at.slope_x;
  if (map.is_profile()) {
    guess.curvature_per_m = -at.curve_xx;
  } else {
    Eigen::Matrix2d bending;
    bending << at.curve_xx, at.curve_xy, at.curve_xy, at.curve_yy;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> main(bending);
    const int most = std::abs(main.eigenvalues()[0]) >= std::abs(main.eigenvalues()[1]) ? 0 : 1;
    const Eigen::Vector2d across = main.eigenvectors().col(most);
    guess.angle_rad = std::atan2(-across[0], across[1]);
    slope_across = at.slope_x * across[0] + at.slope_y * across[1];
    guess.tilt = at.slope_x * across[1] - at.slope_y * across[0];
    guess.curvature_per_m = -main.eigenvalues()[most];
  }
  if (guess.curvature_per_m == 0) return guess;
  const double sine = slope_across / std::hypot(1.0, slope_across);
  guess.curvature_per_m /= std::pow(1 + slope_across * slope_across, 1.5);
  guess.offset_m = sine / guess.curvature_per_m;
  guess.height_m -= section(guess, 0, 0).drop;
  return guess;
}

[[noreturn]] void no_curvature() {
  throw InputError("no cylinder is found: the curvature of the map cannot be separated from its roughness",
                   "take the tilt off instead");
}

[[noreturn]] void over_the_side() {
  throw InputError("no cylinder is found: the map would reach over its side", "take a polynomial off instead");
}

}  // namespace

CylinderForm fit_cylinder(const HeightMap& map) {
  check_map(map, 6);
  Parameters at = first_guess(map);
  if (at.curvature_per_m == 0) no_curvature();
  // A profile has no tilt along its axis and no angle.
  const Vector5 is_free = map.is_profile() ? Vector5(1, 0, 1, 1, 0) : Vector5::Ones();
  std::optional<NormalEquations> sums = normal_equations(map, at);
  if (!sums) over_the_side();
  Matrix5 inverse;
  for (int step = 0; step < kMaxNewtonSteps; ++step) {
    Matrix5 products = is_free.asDiagonal() * sums->products * is_free.asDiagonal();
    Vector5 scale;
    for (int i = 0; i < 5; ++i) {
      if (is_free[i] == 0) products(i, i) = 1;
      scale[i] = products(i, i) > 0 ? 1 / std::sqrt(products(i, i)) : 1;
    }
    const Matrix5 scaled = scale.asDiagonal() * products * scale.asDiagonal();
    const Eigen::LDLT<Matrix5> solver(scaled);
    if (!(solver.vectorD().minCoeff() > 1e-14)) no_curvature();
    inverse = scale.asDiagonal() * solver.solve(Matrix5::Identity()) * scale.asDiagonal();
    const Vector5 change = inverse * (is_free.asDiagonal() * sums->right);
    double share = 1;
    std::optional<NormalEquations> next;
    Parameters trial = at;
    for (int halving = 0; halving < 8; ++halving, share *= 0.5) {
      trial = {at.height_m + share * change[0], at.tilt + share * change[1], at.curvature_per_m + share * change[2],
               at.offset_m + share * change[3], at.angle_rad + share * change[4]};
      next = normal_equations(map, trial);
      if (next && next->squares <= sums->squares * (1 + 1e-12)) break;
      next.reset();
    }
    if (!next) break;  // round-off: no step makes it smaller
    const bool settled = sums->squares - next->squares <= 1e-12 * next->squares &&
                         std::abs(change[2]) <= 1e-10 * std::abs(trial.curvature_per_m);
    at = trial;
    sums = next;
    if (settled) break;
  }
  const double freedom = std::max(1.0, static_cast<double>(sums->points) - is_free.sum());
  const double error = std::sqrt(inverse(2, 2) * sums->squares / freedom);
  if (!(std::abs(at.curvature_per_m) > 3 * error)) no_curvature();
  return CylinderForm(map, at);
}

CylinderForm::CylinderForm(const HeightMap& map, const Parameters& parameters)
    : points_x_(map.points_x),
      points_y_(map.points_y),
      step_x_m_(map.step_x_m),
      step_y_m_(map.step_y_m),
      at_(parameters) {}

double CylinderForm::height_at(double x_m, double y_m) const {
  const Section place = section(at_, x_m, y_m);
  return at_.height_m + at_.tilt * place.along + std::hypot(1.0, at_.tilt) * place.drop;
}

void CylinderForm::row(std::size_t j, std::span<double> heights) const {
  const double y = from_centre(j, points_y_, step_y_m_);
  for (std::size_t i = 0; i < points_x_; ++i) heights[i] = height_at(from_centre(i, points_x_, step_x_m_), y);
}

FormAtCentre CylinderForm::at_centre() const {
  const Section place = section(at_, 0, 0);
  const double side = -std::hypot(1.0, at_.tilt) * at_.curvature_per_m * place.across / place.root;
  const double sine = std::sin(at_.angle_rad), cosine = std::cos(at_.angle_rad);
  FormAtCentre centre;
  centre.value = height_at(0, 0);
  centre.slope_x = at_.tilt * cosine - side * sine;
  centre.slope_y = points_y_ == 1 ? 0.0 : at_.tilt * sine + side * cosine;
  return centre;
}

Cylinder CylinderForm::cylinder() const {
  Cylinder found;
  found.radius_m = 1 / at_.curvature_per_m;
  found.axis_tilt_rad = std::atan(at_.tilt);
  found.ridge_offset_m = at_.offset_m;
  double angle = std::remainder(at_.angle_rad, 2 * std::numbers::pi);
  // The opposite direction describes an identical axis.
  if (angle > std::numbers::pi / 2 || angle <= -std::numbers::pi / 2) {
    angle += angle > 0 ? -std::numbers::pi : std::numbers::pi;
    if (points_y_ > 1) {
      found.axis_tilt_rad = -found.axis_tilt_rad;
      found.ridge_offset_m = -found.ridge_offset_m;
    }
  }
  found.axis_angle_rad = points_y_ == 1 ? std::numbers::pi / 2 : angle;
  return found;
}

}  // namespace ringfilm::surface
