#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "ringfilm/study/design/study.hpp"

/// Correlated factors: groups, and the Gaussian copula that joins the members of each.
namespace ringfilm::study {

/// Factors that are correlated with each other, directly or through others, and with no other factor. One alone that is
/// correlated with nothing is a group, too. Indices are reported of groups: those of correlated factors apart from each
/// other have no clear meaning @cite jacques2006.
struct FactorGroup {
  std::string name;                  ///< those of its factors, joined by " and "
  std::vector<std::size_t> factors;  ///< increasing
};

/// Does one of its factors move anything in that base?
bool applies(const FactorGroup& group, const Study& study, std::size_t base);

/// Every factor in one group; in the order of the first factors of the groups.
std::vector<FactorGroup> factor_groups(const Study& study);

/// Lower triangle, row by row, of a matrix L with L L^T = the matrix given (Cholesky), or the first row at which it
/// shows that the matrix is not positive definite to rounding.
struct Triangle {
  std::size_t n = 0;
  std::vector<double> entries;            ///< [i * n + j], 0 above the diagonal
  std::optional<std::size_t> failed_row;  ///< then `entries` are of no use
};
Triangle triangle(std::size_t n, const std::vector<double>& matrix);

/// Turns independent shares into those of correlated factors with a normal copula @cite nelsen2006; eq-copula.
class Copula {
 public:
  Copula() = default;
  /// Presumes a study without faults.
  explicit Copula(const Study& study);

  /// Replaces the shares of correlated factors, one for each factor, in (0, 1), by correlated ones; each stays even in
  /// (0, 1). Others are left as they are, bit by bit.
  void correlate(std::vector<double>& shares) const;

 private:
  struct Block {
    std::vector<std::size_t> factors;
    Triangle triangle;
  };
  std::vector<Block> blocks_;
};

/// Correlation matrix of the members of a group, row by row.
std::vector<double> correlation_matrix(const Study& study, const FactorGroup& group);

}  // namespace ringfilm::study
