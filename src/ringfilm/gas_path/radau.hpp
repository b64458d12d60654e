#pragma once
#include <Eigen/LU>
#include <cstddef>
#include <span>
#include <vector>

namespace ringfilm::gas_path {

/// Ordinary differential equations y' = f(t, y), scaled so that the unknowns are of order 1.
class OdeSystem {
 public:
  virtual ~OdeSystem() = default;
  virtual std::size_t size() const = 0;
  /// f(t, y)
  virtual void rates(double t, std::span<const double> y, std::span<double> f) = 0;
  /// df_i/dy_k, row by row
  virtual void jacobian(double t, std::span<const double> y, std::span<double> J) = 0;
  /// Shortens a change of the unknowns that an iteration proposes, where it leads out of their range.
  virtual void limit(std::span<const double> y, std::span<double> change) const = 0;
};

/// Factors of a square matrix with row exchanges.
class LuFactors {
 public:
  /// @param matrix row by row @returns false where the matrix is singular
  bool factorize(const std::vector<double>& matrix, std::size_t n);
  /// Replaces the right-hand side by the solution.
  void solve(std::span<double> x) const;

 private:
  Eigen::PartialPivLU<Eigen::MatrixXd> lu_;
};

/// One step of the Radau IIA method of order 5 @cite hairer1996, section IV.8: three stages, L-stable, solved together
/// by a simplified Newton iteration, with the embedded error estimate of its authors.
class RadauStep {
 public:
  static constexpr std::size_t kStages = 3;
  /// Places of the stages in the step, and weights of the quadrature with which the step ends.
  static const double kNodes[kStages], kWeights[kStages];

  /// How a step ended.
  struct Outcome {
    bool solved = false;  ///< did the iteration end?
    double error = 0;     ///< estimate in units of `scale`, root mean square
  };

  /// Solves the stages from t to t + h. @param scale error that each unknown may have
  Outcome solve(OdeSystem& system, double t, std::span<const double> y, double h, std::span<const double> scale);

  /// Unknowns at a stage of the step solved last; the last stage is its end.
  std::span<const double> stage(std::size_t j) const { return {stages_.data() + j * n_, n_}; }
  /// Unknowns within that step, by the polynomial through its begin and its stages. @param share 0 to 1
  void interpolate(double share, std::span<double> y) const;
  /// Carries the derivatives of the unknowns by something (rows of `n_columns`) from the begin to the end of the step.
  void carry(std::vector<double>& derivatives, std::size_t n_columns) const;
  /// The next step does not continue this one: its unknowns, or what acts on them, have jumped.
  void forget() { has_guess_ = false; }

 private:
  /// Where the iteration takes the Jacobian: at the begin of the step, or at each stage anew, which costs more and
  /// converges where a flow turns within the step.
  enum class Slopes { kOfBegin, kOfStages };

  bool factorize(double h);
  bool factorize_at_stages(OdeSystem& system, double t, double h);
  void guess(std::span<const double> y, double h);
  bool iterate(OdeSystem& system, double t, double h, std::span<const double> scale, Slopes slopes);
  double error(OdeSystem& system, double t, double h, std::span<const double> scale);

  std::size_t n_ = 0;
  std::vector<double> begin_, first_, stages_, rates_, jacobian_, matrix_, change_, before_;
  LuFactors all_, one_;
  double last_step_ = 0;
  bool has_guess_ = false;
};

}  // namespace ringfilm::gas_path
