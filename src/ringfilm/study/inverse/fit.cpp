#include "ringfilm/study/inverse/fit.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ringfilm/base/error.hpp"
#include "ringfilm/base/number_text.hpp"
#include "ringfilm/study/inverse/fit_residuals.hpp"
#include "ringfilm/study/inverse/identifiability.hpp"
#include "ringfilm/study/inverse/least_squares.hpp"
#include "ringfilm/study/inverse/profile.hpp"
#include "ringfilm/study/sampling/latin_hypercube.hpp"

namespace ringfilm::study {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kTolerance = 1e-6;     // change of the sum of squares: a thousandth of a standard deviation
constexpr double kSameSum = 0.1;        // sums that differ by less are of one minimum
constexpr int kRefits = 3;              // with the discrepancy estimated anew; it settles at once
constexpr double kHalfBand = 1.959964;  // half a 95 % band in standard deviations
constexpr double kTooLarge = 2;         // mean square of the residuals from which on the model does not fit; assumed
constexpr double kMinRank = 30;         // values from which on that mean is a measure

class Fitting {
 public:
  Fitting(const Fit& fit, const Model& model) : fit_(fit), residuals_(fit, model), problem_(residuals_.problem()) {}

  FitResult run(const std::vector<double>& first_places) {
    search(first_places);
    estimate_discrepancies();
    describe();
    return std::move(result_);
  }

 private:
  std::vector<VectorXd> starts(const std::vector<double>& first_places) const {
    const std::size_t n = residuals_.n_parameters();
    std::vector<VectorXd> all(std::max<std::size_t>(fit_.starts, 1), VectorXd::Zero(residuals_.n_unknowns()));
    std::copy(first_places.begin(), first_places.end(), all.front().data());
    const std::size_t n_others = all.size() - 1;
    if (n_others == 0) return all;
    const LatinHypercube spread(n_others, fit_.seed);
    for (std::size_t k = 0; k < n_others; ++k) {
      for (std::size_t j = 0; j < n; ++j) all[k + 1][static_cast<Index>(j)] = spread.share(k, j);
    }
    return all;
  }

  void search(const std::vector<double>& first_places) {
    std::vector<LeastSquaresSolution> ends;
    for (const VectorXd& start : starts(first_places)) {
      LeastSquaresSolution end = solve_least_squares(problem_, start, std::nullopt, kTolerance);
      if (end.residuals.size() > 0) ends.push_back(std::move(end));
    }
    if (ends.empty()) {
      throw ConvergenceError("the case has no solution at any of the " + std::to_string(fit_.starts) +
                             " places from which the fit starts; narrow the bounds to where it has one");
    }
    best_ = *std::min_element(ends.begin(), ends.end(), [](const auto& a, const auto& b) { return a.sum < b.sum; });
    result_.n_starts_agreed = static_cast<std::size_t>(
        std::count_if(ends.begin(), ends.end(), [&](const auto& end) { return end.sum - best_.sum < kSameSum; }));
    if (ends.size() > 1 && result_.n_starts_agreed == 1) {
      result_.notes.push_back("only one of " + std::to_string(ends.size()) +
                              " starts ended at the best fit: there may be a better one; raise [fit] starts");
    }
  }

  void estimate_discrepancies() {
    const auto is_estimated = [](const Measured& one) { return one.discrepancy == Discrepancy::kEstimated; };
    if (std::none_of(fit_.measured.begin(), fit_.measured.end(), is_estimated)) return;
    for (int i = 0; i < kRefits; ++i) {
      std::vector<double> deviations = residuals_.discrepancies();
      const std::optional<ModelOutput> output = residuals_.output(best_.x);
      if (!output) return;
      for (std::size_t k = 0; k < deviations.size(); ++k) {
        if (is_estimated(fit_.measured[k])) {
          deviations[k] = likely_discrepancy(fit_.measured[k], series_residuals(k, *output));
        }
      }
      residuals_.set_discrepancies(deviations);
      best_ = solve_least_squares(problem_, best_.x, std::nullopt, kTolerance);
    }
  }

  VectorXd series_residuals(std::size_t k, const ModelOutput& output) const {
    const std::vector<double>& values = fit_.measured[k].values;
    return residuals_.computed(k, best_.x, output) -
           Eigen::Map<const VectorXd>(values.data(), static_cast<Index>(values.size()));
  }

  void describe() {
    const std::optional<Derivatives> derivatives = residuals_.derivatives(best_.x);
    const std::optional<ModelOutput> output = residuals_.output(best_.x);
    if (!derivatives || !output) throw ConvergenceError("the case has no solution beside the best fit");
    result_.has_converged = best_.has_converged;
    put_sums();
    const Identifiability sure = identifiability_of(*derivatives);
    put_parameters(sure, derivatives->of_residuals);
    put_series(sure, *derivatives, *output);
    for (const FreeDirection& free : sure.directions) result_.not_identified.push_back(free.words);
    result_.derivative_error = derivatives->error / derivatives->of_residuals.norm();
    put_notes();
  }

  void put_sums() {
    const Index n = residuals_.n_measured();
    result_.n_values = static_cast<std::size_t>(n);
    result_.sum_of_squares = best_.sum;
    result_.residual_rms = std::sqrt(best_.residuals.head(n).squaredNorm() / static_cast<double>(n));
  }

  Identifiability identifiability_of(const Derivatives& derivatives) const {
    const auto n = static_cast<Index>(residuals_.n_parameters());
    const Index n_nuisances = residuals_.n_unknowns() - n;
    const MatrixXd measured = derivatives.of_residuals.topRows(residuals_.n_measured());
    MatrixXd all = measured.transpose() * measured;
    all.bottomRightCorner(n_nuisances, n_nuisances).diagonal().array() += 1;  // their priors
    MatrixXd prior = MatrixXd::Zero(n, n);
    std::vector<NamedParameter> names;
    for (Index j = 0; j < n; ++j) {
      const FitParameter& parameter = fit_.parameters[static_cast<std::size_t>(j)];
      const double slope = slope_at(parameter, best_.x[j]), value = value_at(parameter, best_.x[j]);
      if (parameter.prior_deviation) prior(j, j) = std::pow(slope / *parameter.prior_deviation, 2);
      names.push_back({parameter.name(), value == 0 ? 0 : slope / value});
    }
    return identifiability(marginal_information(all, n), prior, derivatives.error * derivatives.error, names);
  }

  void put_parameters(const Identifiability& sure, const MatrixXd& jacobian) {
    const auto n = static_cast<Index>(residuals_.n_parameters());
    for (Index j = 0; j < n; ++j) {
      const FitParameter& parameter = fit_.parameters[static_cast<std::size_t>(j)];
      const double deviation = std::sqrt(sure.covariance(j, j));
      const PlaceInterval interval = fit_.intervals == Intervals::kProfile
                                         ? profile_interval(problem_, best_, jacobian, j, deviation)
                                         : PlaceInterval{std::max(best_.x[j] - kHalfBand * deviation, 0.),
                                                         std::min(best_.x[j] + kHalfBand * deviation, 1.)};
      FittedParameter fitted;
      fitted.value = value_at(parameter, best_.x[j]);
      fitted.low = value_at(parameter, interval.low);
      fitted.high = value_at(parameter, interval.high);
      fitted.deviation = deviation * slope_at(parameter, best_.x[j]);
      fitted.at_lower = interval.low <= 0;
      fitted.at_upper = interval.high >= 1;
      fitted.identified = sure.is_determined[static_cast<std::size_t>(j)] && !(fitted.at_lower && fitted.at_upper);
      result_.parameters.push_back(fitted);
      std::vector<double> row;
      for (Index k = 0; k < n; ++k) {
        row.push_back(sure.covariance(j, k) / std::sqrt(sure.covariance(j, j) * sure.covariance(k, k)));
      }
      result_.correlation.push_back(std::move(row));
    }
  }

  void put_series(const Identifiability& sure, const Derivatives& derivatives, const ModelOutput& output) {
    for (std::size_t k = 0; k < fit_.measured.size(); ++k) {
      const VectorXd computed = residuals_.computed(k, best_.x, output), residuals = series_residuals(k, output);
      FittedSeries series;
      series.computed.assign(computed.data(), computed.data() + computed.size());
      series.residual_rms = std::sqrt(residuals.squaredNorm() / static_cast<double>(residuals.size()));
      series.discrepancy = residuals_.discrepancies()[k];
      const VectorXd half = kHalfBand * band(sure, derivatives, k);
      series.band.assign(half.data(), half.data() + half.size());
      result_.series.push_back(std::move(series));
    }
    const VectorXd variances =
        (derivatives.of_predicted * sure.covariance).cwiseProduct(derivatives.of_predicted).rowwise().sum();
    for (std::size_t i = 0; i < output.predicted.size(); ++i) {
      const double half = kHalfBand * std::sqrt(std::max(variances[static_cast<Index>(i)], 0.));
      result_.predicted.push_back({output.predicted[i], output.predicted[i] - half, output.predicted[i] + half});
    }
    put_nuisances(derivatives.of_residuals);
  }

  /// Standard deviation of what is computed for a series, by the parameters.
  VectorXd band(const Identifiability& sure, const Derivatives& derivatives, std::size_t k) const {
    const MatrixXd slopes =
        residuals_.restored(derivatives.of_residuals, k).leftCols(static_cast<Index>(residuals_.n_parameters()));
    return (slopes * sure.covariance).cwiseProduct(slopes).rowwise().sum().cwiseMax(0).cwiseSqrt();
  }

  void put_nuisances(const MatrixXd& jacobian) {
    MatrixXd information = jacobian.transpose() * jacobian;
    information.diagonal().array() += 1e-9 * information.diagonal().maxCoeff();  // parameters that are not determined
    const MatrixXd covariance = information.ldlt().solve(MatrixXd::Identity(information.rows(), information.cols()));
    for (std::size_t k = 0; k < residuals_.nuisances().size(); ++k) {
      const Nuisance& nuisance = residuals_.nuisances()[k];
      const auto at = static_cast<Index>(residuals_.n_parameters() + k);
      result_.nuisances.push_back({nuisance.measured, nuisance.name, best_.x[at] * nuisance.deviation,
                                   std::sqrt(covariance(at, at)) * nuisance.deviation});
    }
  }

  void put_notes() {
    const double freedom = static_cast<double>(result_.n_values) - static_cast<double>(residuals_.n_parameters());
    const double mean_square = result_.residual_rms * result_.residual_rms;
    const bool has_discrepancy = std::any_of(residuals_.discrepancies().begin(), residuals_.discrepancies().end(),
                                             [](double deviation) { return deviation > 0; });
    const double limit = freedom >= kMinRank ? kTooLarge : 2 * kTooLarge;
    if (mean_square > limit && !has_discrepancy) {
      result_.notes.push_back("the residuals are " + number_text(result_.residual_rms, 2) +
                              " times as large as the stated deviations: the model does not describe the measurement "
                              "within them, and the intervals are too narrow; state discrepancy = \"estimated\"");
    }
    if (freedom < 1) {
      result_.notes.push_back("there are " + std::to_string(result_.n_values) + " measured values for " +
                              std::to_string(residuals_.n_parameters()) +
                              " parameters: nothing is left to show whether the model is right");
    }
    if (!result_.has_converged) result_.notes.push_back("the search ended before it converged");
    for (std::size_t j = 0; j < fit_.parameters.size(); ++j) {
      const Index at = static_cast<Index>(j);
      if (best_.x[at] > 0 && best_.x[at] < 1) continue;
      result_.notes.push_back(fit_.parameters[j].name() + " is at its " + (best_.x[at] <= 0 ? "lower" : "upper") +
                              " bound: the best fit lies beyond it");
    }
  }

  const Fit& fit_;
  FitResiduals residuals_;
  LeastSquares problem_;
  LeastSquaresSolution best_;
  FitResult result_;
};

}  // namespace

FitResult fit(const Fit& problem, const std::vector<double>& first_places, const Model& model) {
  return Fitting(problem, model).run(first_places);
}

}  // namespace ringfilm::study
