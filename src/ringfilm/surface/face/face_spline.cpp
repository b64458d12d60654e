#include "ringfilm/surface/face/face_spline.hpp"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <utility>

#include "ringfilm/base/display.hpp"
#include "ringfilm/base/error.hpp"

namespace ringfilm::surface {
namespace {

constexpr std::size_t kMinSplinePoints = 8;
constexpr double kMinSteps = 4;

void check(const std::vector<double>& x, const std::vector<double>& height, double cutoff) {
  if (x.size() != height.size() || x.size() < kMinSplinePoints) {
    throw InputError("a trace of " + std::to_string(x.size()) + " places and " + std::to_string(height.size()) +
                         " heights cannot be smoothed",
                     "equally many of both are required, " + std::to_string(kMinSplinePoints) + " or more");
  }
  const auto finite = [](double v) { return std::isfinite(v); };
  if (!std::all_of(x.begin(), x.end(), finite) || !std::all_of(height.begin(), height.end(), finite)) {
    throw InputError("the trace holds a value that is not a number", "leave points that were not measured out");
  }
  if (!std::is_sorted(x.begin(), x.end(), std::less_equal<>())) {
    throw InputError("the places of the trace do not rise", "x must increase from point to point");
  }
  const double length = x.back() - x.front(), step = length / static_cast<double>(x.size() - 1);
  if (!std::isfinite(cutoff) || cutoff < kMinSteps * step || cutoff > length) {
    throw InputError(
        formatted("a spline cannot be as stiff as a wavelength of %f um: the trace is %f um long with "
                  "steps of %f um",
                  number_in(cutoff, kMicrometre), number_in(length, kMicrometre), number_in(step, kMicrometre)),
        "four steps to the length of the trace are allowed, for example a tenth of the length");
  }
}

/// The length of trace that each point represents.
std::vector<double> lengths(const std::vector<double>& x) {
  std::vector<double> w(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    w[i] = (x[std::min(i + 1, x.size() - 1)] - x[i == 0 ? 0 : i - 1]) / 2;
  }
  return w;
}

}  // namespace

SmoothingSpline::SmoothingSpline(std::vector<double> x_m, const std::vector<double>& height_m, double cutoff_m)
    : x_m_(std::move(x_m)), height_m_(height_m), curvature_(x_m_.size(), 0.0), cutoff_m_(cutoff_m) {
  check(x_m_, height_m_, cutoff_m);
  // Lengths in mean steps, so that no power of them over- or underflows.
  const int n = static_cast<int>(x_m_.size());
  const double step = (x_m_.back() - x_m_.front()) / (n - 1);
  std::vector<double> x(x_m_.size());
  for (int i = 0; i < n; ++i) x[i] = (x_m_[i] - x_m_.front()) / step;
  const std::vector<double> w = lengths(x);
  const double stiffness = std::pow(cutoff_m / step / (2 * std::numbers::pi), 4);
  Eigen::SparseMatrix<double> second(n, n - 2), gram(n - 2, n - 2);  // second differences; of the basis' curvature
  std::vector<Eigen::Triplet<double>> of_second, of_gram;
  for (int j = 0; j < n - 2; ++j) {
    const double left = x[j + 1] - x[j], right = x[j + 2] - x[j + 1];
    of_second.insert(of_second.end(), {{j, j, 1 / left}, {j + 1, j, -1 / left - 1 / right}, {j + 2, j, 1 / right}});
    of_gram.emplace_back(j, j, (left + right) / 3);
    if (j + 1 < n - 2) of_gram.insert(of_gram.end(), {{j, j + 1, right / 6}, {j + 1, j, right / 6}});
  }
  second.setFromTriplets(of_second.begin(), of_second.end());
  gram.setFromTriplets(of_gram.begin(), of_gram.end());
  Eigen::SparseMatrix<double> softness(n, n);
  softness.reserve(Eigen::VectorXi::Constant(n, 1));
  for (int i = 0; i < n; ++i) softness.insert(i, i) = stiffness / w[i];
  const Eigen::Map<const Eigen::VectorXd> y(height_m.data(), n);
  const Eigen::SparseMatrix<double> resisting = softness * second;
  const Eigen::SparseMatrix<double> system = gram + Eigen::SparseMatrix<double>(second.transpose() * resisting);
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(system);
  const Eigen::VectorXd moments = factors.solve(second.transpose() * y);
  if (factors.info() != Eigen::Success || !moments.allFinite()) {
    throw InputError("the trace cannot be smoothed: its steps are too unlike", "sample it evenly");
  }
  Eigen::Map<Eigen::VectorXd>(height_m_.data(), n) = y - resisting * moments;
  for (int j = 0; j < n - 2; ++j) curvature_[j + 1] = moments[j] / (step * step);
}

double SmoothingSpline::height_m(double x) const {
  const std::size_t above = std::clamp<std::size_t>(
      static_cast<std::size_t>(std::upper_bound(x_m_.begin(), x_m_.end(), x) - x_m_.begin()), 1, x_m_.size() - 1);
  const std::size_t i = above - 1;
  const double step = x_m_[above] - x_m_[i], t = (x - x_m_[i]) / step;
  const double line = (1 - t) * height_m_[i] + t * height_m_[above];
  if (t < 0 || t > 1) {
    // Straight on, with the slope of the end.
    const double slope =
        (height_m_[above] - height_m_[i]) / step + (t < 0 ? -step / 6 * curvature_[above] : step / 6 * curvature_[i]);
    return t < 0 ? height_m_[i] + slope * (x - x_m_[i]) : height_m_[above] + slope * (x - x_m_[above]);
  }
  return line - step * step / 6 * t * (1 - t) * ((2 - t) * curvature_[i] + (1 + t) * curvature_[above]);
}

double SmoothingSpline::error_share(double x) const {
  // 1/(2 pi) times the integral of the squared transmission 1/(1 + u^4) is 3 sqrt(2)/16.
  const double step = (x_m_.back() - x_m_.front()) / static_cast<double>(x_m_.size() - 1);
  const double inside = std::sqrt(3 * std::numbers::sqrt2 / 16 * step * 2 * std::numbers::pi / cutoff_m_);
  const double from_end = std::min(x - x_m_.front(), x_m_.back() - x);
  return from_end < cutoff_m_ / 2 ? 2 * inside : inside;
}

}  // namespace ringfilm::surface
