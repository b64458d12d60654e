#pragma once
#include <Eigen/Core>
#include <string>
#include <vector>

/// What a measurement determines of the parameters of a fit; docs/theory/fit.md.
namespace ringfilm::study {

/// A direction in which the parameters can move without a change of what was measured.
struct FreeDirection {
  std::vector<double> parts;  ///< part of each parameter, in places between the bounds; length 1 together
  std::string words;          ///< "only the product A x B is determined"
};

/// How sure the parameters are, as places between their bounds.
struct Identifiability {
  Eigen::MatrixXd covariance;             ///< finite: what is not determined scatters within the bounds
  std::vector<double> deviations;         ///< by the measurement alone; infinite where nothing is determined
  std::vector<FreeDirection> directions;  ///< which are not determined
  std::vector<bool> is_determined;        ///< is the 95 % interval of each parameter narrower than its bounds?
};

/// A parameter as the words name it.
struct NamedParameter {
  std::string name;
  /// Relative change of the value per change of its place; 0 where the value is 0.
  double relative_slope = 0;
};

/// @param information of the measurement on the parameters, eq-information: second derivatives of half the sum of
/// squares with respect to their places, nuisance parameters eliminated
/// @param prior information that is not from the measurement
/// @param noise square of the norm of the error of the derivatives, below which information is not seen
Identifiability identifiability(const Eigen::MatrixXd& information, const Eigen::MatrixXd& prior, double noise,
                                const std::vector<NamedParameter>& parameters);

/// The information on the first `n` unknowns of all, the others eliminated by the Schur complement.
Eigen::MatrixXd marginal_information(const Eigen::MatrixXd& all, Eigen::Index n);

}  // namespace ringfilm::study
