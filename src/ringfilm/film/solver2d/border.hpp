#pragma once
#include <functional>
#include <vector>

#include "ringfilm/film/film2d.hpp"
#include "ringfilm/film/kernels/film2d_kernels.hpp"

namespace ringfilm::film {

/// The border of a linear system: unknowns b of the ring next to those of the film's nodes x,
///
///     A x + C b = f,   R x + D b = g.
///
/// It is eliminated with what an approximate solve makes of C, Y: (D - R Y) b = g - R x, then x - Y b.
class Border {
 public:
  using Solve = std::function<void(const double* rhs, double* x)>;

  virtual ~Border() = default;
  virtual int count() const = 0;
  /// Y, from the columns of now.
  virtual void solve_columns(const Solve& approximately) = 0;
  /// D - R Y. @returns false where the load of a rigid ring does not fall with its separation
  virtual bool factor() = 0;
  /// y += C b.
  virtual void add_columns(const double* b, double* y) = 0;
  /// `to` = R x + D b.
  virtual void multiply(const double* x, const double* b, double* to) = 0;
  /// Brings f's approximate solution x and g to those of the whole system.
  virtual void eliminate(const double* g, double* x, double* b) = 0;
};

/// Border of a rigid ring: one unknown, ln h_m.
class RigidBorder final : public Border {
 public:
  /// @param n numbers of a vector x; column and row are those of the block
  RigidBorder(const Film2dKernels& kernels, const Film2dBlock& block, std::size_t n)
      : kernels_(&kernels), block_(&block), n_(n), solution_(n, 0.0) {}

  double& corner() { return corner_; }  ///< D

  int count() const override { return 1; }
  void solve_columns(const Solve& approximately) override;
  bool factor() override;
  void add_columns(const double* b, double* y) override;
  void multiply(const double* x, const double* b, double* to) override;
  void eliminate(const double* g, double* x, double* b) override;

 private:
  const Film2dKernels* kernels_;
  const Film2dBlock* block_;
  std::size_t n_;
  std::vector<double> solution_;  ///< Y
  double corner_ = 0, slope_ = 0;
};

/// Border of a ring that bends: the unknowns of its beam, over a length. A strip's film is eliminated as if all strips
/// were displaced alike, because the stiffness of the ring limits differences between near strips. So D - R Y is a
/// band.
class BeamBorder final : public Border {
 public:
  /// @param first the first strip that is solved
  BeamBorder(const Film2dKernels& kernels, const Film2dBlock& block, const Film2dProblem& problem, int first);

  /// @param scale length that the unknowns count in [m] @param lowest strip, from which bending counts
  /// @param contact_slope of each strip's asperities, with its share of the length, in those units [N/m]
  /// @param closing slope of each strip's separation in its film, closed_separation() [-]
  void set(double scale, int lowest, std::vector<double> contact_slope, const std::vector<double>& closing);

  int count() const override { return ring_.n_unknowns(); }
  void solve_columns(const Solve& approximately) override;
  bool factor() override;
  void add_columns(const double* b, double* y) override;
  void multiply(const double* x, const double* b, double* to) override;
  void eliminate(const double* g, double* x, double* b) override;

 private:
  /// Those of the strips that are solved, at the strips and at the faces between them, as the block has strips.
  void spread(const double* b);

  const Film2dKernels* kernels_;
  const Film2dBlock* block_;
  ElasticRing ring_;
  int n_strips_, first_;  ///< number of strips of the film; index of the first that is solved
  Ends ends_;
  double length_;  ///< length of the film in y [m]
  double scale_ = 0;
  int lowest_ = 0;
  std::vector<double> contact_slope_;
  std::vector<double> stiffened_;                ///< displacement that each unknown needs, flattened by it [-]
  std::vector<double> share_;                    ///< share of the length that each strip has
  std::vector<double> closing_;                  ///< slope of each displacement in its unknown [-]
  std::vector<double> solution_;                 ///< Y of all strips displaced alike
  std::vector<double> own_, low_, high_, sums_;  ///< scratch: values at the strips, in the order of the block
  std::vector<double> factor_, left_, bent_;
};

}  // namespace ringfilm::film
