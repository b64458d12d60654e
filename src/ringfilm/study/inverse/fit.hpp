#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ringfilm/cycle/result/result.hpp"
#include "ringfilm/study/inverse/variable.hpp"

/// A fit of a case to measurements as one plain value in SI, and what comes of it; docs/theory/fit.md.
namespace ringfilm::study {

/// How a discrepancy between model and reality enters a fit.
enum class Discrepancy {
  kNone,      ///< the model is taken as right
  kStated,    ///< its standard deviation is known
  kEstimated  ///< its standard deviation is that under which the residuals are most likely
};

/// A measured curve over crank angle, or values of cycles at operating points.
struct Measured {
  cycle::Quantity quantity;                ///< quantity that is measured
  std::vector<double> crank_angle_deg;     ///< angle of each value, -360 to 360; empty: values of cycles [degree]
  std::vector<std::size_t> bases;          ///< case of each value at its operating point; one for a curve
  std::vector<double> values, deviations;  ///< measured values and their standard deviations [SI]
  std::optional<double> offset;            ///< standard deviation of an unknown error common to all values [SI]
  std::optional<double> scale;             ///< standard deviation of an unknown relative error of all values [-]
  std::optional<double> angle_shift_deg;   ///< standard deviation of an unknown error of all crank angles [degree]
  Discrepancy discrepancy = Discrepancy::kNone;
  double discrepancy_deviation = 0;    ///< where it is stated [SI]
  double discrepancy_length_deg = 30;  ///< along a curve; assumed [degree]

  bool is_curve() const { return !crank_angle_deg.empty(); }
};

/// A number of the case that a fit finds.
struct FitParameter : Variable {
  std::optional<double> prior_mean, prior_deviation;  ///< what is known of it without the measurement [SI]
};

enum class Intervals {
  kProfile,  ///< by the profile likelihood
  kLinear    ///< by the covariance
};

/// What a fit is to do.
struct Fit {
  std::string title;
  std::vector<Measured> measured;
  std::vector<FitParameter> parameters;
  std::size_t starts = 3;  ///< places from which the search starts: the case's own, then spread; assumed
  std::uint64_t seed = 1;
  Intervals intervals = Intervals::kProfile;
};

/// What the model gives at values of the parameters.
struct ModelOutput {
  std::vector<std::vector<double>> axes;    ///< crank angles of the curve of each Measured; empty for values [degree]
  std::vector<std::vector<double>> values;  ///< curve of each Measured, or a value for each measured one [SI]
  std::vector<double> predicted;            ///< values for which bands are requested [SI]
};

/// Computes the model at several places of the parameters between their bounds, in parallel; nothing where a case has
/// no solution.
using Model = std::function<std::vector<std::optional<ModelOutput>>(const std::vector<std::vector<double>>& places)>;

/// A parameter after the fit.
struct FittedParameter {
  double value = 0, low = 0, high = 0;      ///< with its 95 % interval [SI]
  double deviation = 0;                     ///< standard deviation by the covariance [SI]
  bool identified = false;                  ///< does the measurement bound it within its bounds?
  bool at_lower = false, at_upper = false;  ///< does its interval end at a bound?
};

/// A common error of a measured series after the fit.
struct FittedNuisance {
  std::size_t measured = 0;         ///< place in Fit::measured
  std::string name;                 ///< "offset", "scale", "angle_shift"
  double value = 0, deviation = 0;  ///< [SI], angles [degree]
};

/// A measured series after the fit.
struct FittedSeries {
  std::vector<double> computed;  ///< model with offset, scale and shift, at each measured value [SI]
  std::vector<double> band;      ///< half the width of its 95 % band by the parameters [SI]
  double residual_rms = 0;       ///< root mean square of computed less measured [SI]
  double discrepancy = 0;        ///< standard deviation of the discrepancy [SI]
};

struct PredictedValue {
  double value = 0, low = 0, high = 0;  ///< with its 95 % band by the parameters [SI]
};

struct FitResult {
  std::vector<FittedParameter> parameters;
  std::vector<std::vector<double>> correlation;  ///< correlation of the parameters
  std::vector<FittedNuisance> nuisances;
  std::vector<FittedSeries> series;
  std::vector<PredictedValue> predicted;
  std::vector<std::string> not_identified;  ///< directions that are not determined, in words
  std::vector<std::string> notes;           ///< what must be known about the fit
  double residual_rms = 0;                  ///< root mean square of all residuals over their standard deviations [-]
  double sum_of_squares = 0;                ///< sum over residuals and priors, in standard deviations [-]
  std::size_t n_values = 0;                 ///< measured values
  std::size_t n_starts_agreed = 0;          ///< starts that ended at the best sum
  double derivative_error = 0;              ///< norm of the error of the derivatives over the norm of these [-]
  bool has_converged = false;
};

/// Fits the parameters. Throws ConvergenceError where the model has no solution at any start.
FitResult fit(const Fit& problem, const std::vector<double>& first_places, const Model& model);

}  // namespace ringfilm::study
