#include "ringfilm/study/inverse/fit_residuals.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ringfilm::study {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kStep = 1. / 512;      // step of differences between the bounds; assumed
constexpr double kNuisanceStep = 1e-3;  // step of differences, in standard deviations
constexpr double kMaxNuisance = 8;      // standard deviations; an error of the measurement is not larger

std::vector<double> places_in(const VectorXd& x, std::size_t n) { return {x.data(), x.data() + n}; }

/// A difference quotient: places and weights.
struct Difference {
  double left, right;
};

/// The places of a difference about x that stay within the bounds.
Difference difference_about(double x, double step) { return {std::max(x - step, 0.), std::min(x + step, 1.)}; }

}  // namespace

FitResiduals::FitResiduals(const Fit& fit, const Model& model) : fit_(fit), model_(model) {
  for (std::size_t i = 0; i < fit.measured.size(); ++i) {
    const Measured& measured = fit.measured[i];
    n_measured_ += static_cast<Index>(measured.values.size());
    if (measured.offset) nuisances_.push_back({i, "offset", *measured.offset});
    if (measured.scale) nuisances_.push_back({i, "scale", *measured.scale});
    if (measured.angle_shift_deg) nuisances_.push_back({i, "angle_shift", *measured.angle_shift_deg});
  }
  n_priors_ = static_cast<Index>(nuisances_.size());
  for (const FitParameter& parameter : fit.parameters) n_priors_ += parameter.prior_deviation ? 1 : 0;
  std::vector<double> stated;
  for (const Measured& measured : fit.measured) stated.push_back(measured.discrepancy_deviation);
  set_discrepancies(stated);
}

VectorXd FitResiduals::lower() const {
  VectorXd bounds = VectorXd::Zero(n_unknowns());
  bounds.tail(static_cast<Index>(nuisances_.size())).setConstant(-kMaxNuisance);
  return bounds;
}

VectorXd FitResiduals::upper() const {
  VectorXd bounds = VectorXd::Ones(n_unknowns());
  bounds.tail(static_cast<Index>(nuisances_.size())).setConstant(kMaxNuisance);
  return bounds;
}

void FitResiduals::set_discrepancies(const std::vector<double>& deviations) {
  discrepancies_ = deviations;
  whitenings_.clear();
  for (std::size_t i = 0; i < fit_.measured.size(); ++i) whitenings_.emplace_back(fit_.measured[i], deviations[i]);
}

std::optional<ModelOutput> FitResiduals::output(const VectorXd& x) const {
  return std::move(model_({places_in(x, n_parameters())}).front());
}

SeriesErrors FitResiduals::errors_of(std::size_t series, const VectorXd& x) const {
  SeriesErrors errors;
  for (std::size_t k = 0; k < nuisances_.size(); ++k) {
    const Nuisance& nuisance = nuisances_[k];
    if (nuisance.measured != series) continue;
    const double value = x[static_cast<Index>(n_parameters() + k)] * nuisance.deviation;
    (nuisance.name == "offset"  ? errors.offset
     : nuisance.name == "scale" ? errors.scale
                                : errors.angle_shift_deg) = value;
  }
  return errors;
}

VectorXd FitResiduals::computed(std::size_t series, const VectorXd& x, const ModelOutput& output) const {
  return computed_series(fit_.measured[series], output, series, errors_of(series, x));
}

MatrixXd FitResiduals::restored(const MatrixXd& of_residuals, std::size_t series) const {
  Index first = 0;
  for (std::size_t i = 0; i < series; ++i) first += static_cast<Index>(fit_.measured[i].values.size());
  const auto n = static_cast<Index>(fit_.measured[series].values.size());
  return whitenings_[series].restored(of_residuals.middleRows(first, n));
}

VectorXd FitResiduals::whitened(const VectorXd& x, const ModelOutput& output) const {
  VectorXd all(n_measured_);
  Index at = 0;
  for (std::size_t i = 0; i < fit_.measured.size(); ++i) {
    const std::vector<double>& values = fit_.measured[i].values;
    const auto n = static_cast<Index>(values.size());
    all.segment(at, n) = whitenings_[i](computed(i, x, output) - Eigen::Map<const VectorXd>(values.data(), n));
    at += n;
  }
  return all;
}

VectorXd FitResiduals::of_output(const VectorXd& x, const ModelOutput& output) const {
  VectorXd all(n_measured_ + n_priors_);
  all.head(n_measured_) = whitened(x, output);
  Index at = n_measured_;
  for (std::size_t j = 0; j < n_parameters(); ++j) {
    const FitParameter& parameter = fit_.parameters[j];
    if (!parameter.prior_deviation) continue;
    const double value = value_at(parameter, x[static_cast<Index>(j)]);
    all[at++] = (value - *parameter.prior_mean) / *parameter.prior_deviation;
  }
  const auto n = static_cast<Index>(nuisances_.size());
  all.tail(n) = x.tail(n);
  return all;
}

std::optional<VectorXd> FitResiduals::residuals(const VectorXd& x) const {
  const std::optional<ModelOutput> there = output(x);
  return there ? std::optional(of_output(x, *there)) : std::nullopt;
}

void FitResiduals::put_nuisances(const VectorXd& x, const ModelOutput& output, MatrixXd& jacobian) const {
  for (Index k = static_cast<Index>(n_parameters()); k < n_unknowns(); ++k) {
    VectorXd left = x, right = x;
    left[k] -= kNuisanceStep;
    right[k] += kNuisanceStep;
    jacobian.col(k) = (of_output(right, output) - of_output(left, output)) / (2 * kNuisanceStep);
  }
}

/// The model at the unknowns and, parameter by parameter and step by step, to the left and right of them.
FitResiduals::Stencil FitResiduals::stencil(const VectorXd& x, const std::vector<double>& steps) const {
  std::vector<std::vector<double>> places = {places_in(x, n_parameters())};
  Stencil all;
  all.at = {x};
  for (std::size_t j = 0; j < n_parameters(); ++j) {
    for (const double step : steps) {
      const auto [left, right] = difference_about(x[static_cast<Index>(j)], step);
      for (const double place : {left, right}) {
        all.at.push_back(x);
        all.at.back()[static_cast<Index>(j)] = place;
        places.push_back(places_in(all.at.back(), n_parameters()));
      }
    }
  }
  all.outputs = model_(places);
  return all;
}

/// Where the case beside has no solution the difference is one-sided.
std::optional<FitResiduals::Pair> FitResiduals::pair(const Stencil& all, std::size_t index, Index column) const {
  const std::size_t first = 1 + 2 * index;
  const std::size_t left = all.outputs[first] ? first : 0, right = all.outputs[first + 1] ? first + 1 : 0;
  if (left == right) return std::nullopt;
  const double width = all.at[right][column] - all.at[left][column];
  return Pair{*all.outputs[left], *all.outputs[right], width,
              (of_output(all.at[right], *all.outputs[right]) - of_output(all.at[left], *all.outputs[left])) / width};
}

std::optional<MatrixXd> FitResiduals::jacobian(const VectorXd& x) const {
  const Stencil all = stencil(x, {kStep});
  if (!all.outputs.front()) return std::nullopt;
  MatrixXd jacobian(n_measured_ + n_priors_, n_unknowns());
  for (std::size_t j = 0; j < n_parameters(); ++j) {
    const auto column = static_cast<Index>(j);
    const std::optional<Pair> about = pair(all, j, column);
    if (!about) return std::nullopt;
    jacobian.col(column) = about->quotient;
  }
  put_nuisances(x, *all.outputs.front(), jacobian);
  return jacobian;
}

std::optional<Derivatives> FitResiduals::derivatives(const VectorXd& x) const {
  // Central differences with a step and twice as much: their difference is three times the error of the first.
  const Stencil all = stencil(x, {kStep, 2 * kStep});
  if (!all.outputs.front()) return std::nullopt;
  Derivatives found;
  found.of_residuals.resize(n_measured_ + n_priors_, n_unknowns());
  const auto n_predicted = static_cast<Index>(all.outputs.front()->predicted.size());
  found.of_predicted.resize(n_predicted, static_cast<Index>(n_parameters()));
  double error = 0;
  for (std::size_t j = 0; j < n_parameters(); ++j) {
    const auto column = static_cast<Index>(j);
    const std::optional<Pair> near = pair(all, 2 * j, column), far = pair(all, 2 * j + 1, column);
    if (!near || !far) return std::nullopt;
    const Eigen::Map<const VectorXd> high(near->right.predicted.data(), n_predicted),
        low(near->left.predicted.data(), n_predicted);
    found.of_predicted.col(column) = (high - low) / near->width;
    error += (far->quotient - near->quotient).squaredNorm();
    found.of_residuals.col(column) = near->quotient;
  }
  put_nuisances(x, *all.outputs.front(), found.of_residuals);
  found.error = std::sqrt(error);
  return found;
}

LeastSquares FitResiduals::problem() const {
  return {lower(), upper(), [this](const VectorXd& x) { return residuals(x); },
          [this](const VectorXd& x, const VectorXd&) { return jacobian(x); }};
}

}  // namespace ringfilm::study
