#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "ringfilm/study/inverse/fit.hpp"
#include "ringfilm/study/inverse/least_squares.hpp"
#include "ringfilm/study/inverse/measured_series.hpp"

namespace ringfilm::study {

/// A common error of a series among the unknowns of a fit, in standard deviations of its own.
struct Nuisance {
  std::size_t measured = 0;  ///< place in Fit::measured
  std::string name;          ///< "offset", "scale", "angle_shift"
  double deviation = 1;      ///< standard deviation [SI], angles [degree]
};

/// Derivatives of the residuals, and how far they can be off.
struct Derivatives {
  Eigen::MatrixXd of_residuals;  ///< with respect to all unknowns
  Eigen::MatrixXd of_predicted;  ///< derivatives of ModelOutput::predicted with respect to the parameters
  double error = 0;              ///< norm of the error of those with respect to the parameters
};

/// The residuals of a fit over its unknowns: places of the parameters between their bounds, then nuisances in standard
/// deviations. First those of the measured values, then the priors of parameters and nuisances.
class FitResiduals {
 public:
  FitResiduals(const Fit& fit, const Model& model);

  std::size_t n_parameters() const { return fit_.parameters.size(); }
  const std::vector<Nuisance>& nuisances() const { return nuisances_; }
  Eigen::Index n_unknowns() const { return static_cast<Eigen::Index>(n_parameters() + nuisances_.size()); }
  Eigen::Index n_measured() const { return n_measured_; }  ///< residuals of measured values
  Eigen::VectorXd lower() const;
  Eigen::VectorXd upper() const;

  /// Standard deviations of the discrepancies that later residuals count with.
  void set_discrepancies(const std::vector<double>& deviations);
  const std::vector<double>& discrepancies() const { return discrepancies_; }

  std::optional<ModelOutput> output(const Eigen::VectorXd& x) const;
  /// What is computed for a series at the unknowns, of their output.
  Eigen::VectorXd computed(std::size_t series, const Eigen::VectorXd& x, const ModelOutput& output) const;

  /// Rows of a matrix over all residuals that belong to a series, in its own units.
  Eigen::MatrixXd restored(const Eigen::MatrixXd& of_residuals, std::size_t series) const;

  std::optional<Eigen::VectorXd> residuals(const Eigen::VectorXd& x) const;
  std::optional<Eigen::MatrixXd> jacobian(const Eigen::VectorXd& x) const;
  /// By two steps of each parameter, which show the error.
  std::optional<Derivatives> derivatives(const Eigen::VectorXd& x) const;

  /// As a problem over all unknowns.
  LeastSquares problem() const;

 private:
  struct Stencil {
    std::vector<Eigen::VectorXd> at;  ///< unknowns; the first are those in the middle
    std::vector<std::optional<ModelOutput>> outputs;
  };
  Stencil stencil(const Eigen::VectorXd& x, const std::vector<double>& steps) const;
  /// A difference of the stencil.
  struct Pair {
    const ModelOutput &left, &right;
    double width;              ///< by which the parameter differs
    Eigen::VectorXd quotient;  ///< difference of the residuals over the width
  };
  /// Nothing where neither case beside has a solution. @param index among the pairs @param column of the parameter
  std::optional<Pair> pair(const Stencil& all, std::size_t index, Eigen::Index column) const;

  /// All residuals of an output of the model, which may belong to other nuisances.
  Eigen::VectorXd of_output(const Eigen::VectorXd& x, const ModelOutput& output) const;
  SeriesErrors errors_of(std::size_t series, const Eigen::VectorXd& x) const;
  void put_nuisances(const Eigen::VectorXd& x, const ModelOutput& output, Eigen::MatrixXd& jacobian) const;
  Eigen::VectorXd whitened(const Eigen::VectorXd& x, const ModelOutput& output) const;

  const Fit& fit_;
  const Model& model_;
  std::vector<Nuisance> nuisances_;
  std::vector<double> discrepancies_;
  std::vector<Whitening> whitenings_;
  Eigen::Index n_measured_ = 0, n_priors_ = 0;
};

}  // namespace ringfilm::study
