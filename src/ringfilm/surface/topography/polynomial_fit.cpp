#include "ringfilm/surface/topography/polynomial_fit.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <vector>

#include "ringfilm/base/error.hpp"

namespace ringfilm::surface {
namespace {

double scaled_place(std::size_t i, std::size_t points) {
  return points == 1 ? 0.0 : 2.0 * static_cast<double>(i) / static_cast<double>(points - 1) - 1.0;
}

/// Legendre polynomials of degrees 0 to values.size() - 1 at t.
void legendre(double t, Eigen::Ref<Eigen::VectorXd> values) {
  values[0] = 1;
  if (values.size() > 1) values[1] = t;
  for (Eigen::Index n = 2; n < values.size(); ++n) {
    const double number = static_cast<double>(n);
    values[n] = ((2 * number - 1) * t * values[n - 1] - (number - 1) * values[n - 2]) / number;
  }
}

/// Row i: the Legendre polynomials at point i of an axis.
Eigen::MatrixXd basis(std::size_t points, int degree) {
  Eigen::MatrixXd values(degree + 1, static_cast<Eigen::Index>(points));
  for (std::size_t i = 0; i < points; ++i) legendre(scaled_place(i, points), values.col(static_cast<Eigen::Index>(i)));
  return values;
}

struct Term {
  int a, b;  // powers of x and y
};

std::vector<Term> terms_of(int degree, bool profile) {
  std::vector<Term> terms;
  for (int b = 0; b <= (profile ? 0 : degree); ++b) {
    for (int a = 0; a + b <= degree; ++a) terms.push_back({a, b});
  }
  return terms;
}

/// Adds the products of the basis at row j to the normal equations.
void add_row(const std::vector<Term>& terms, const Eigen::MatrixXd& products_x, const Eigen::VectorXd& heights_x,
             const Eigen::VectorXd& y, Eigen::MatrixXd& normal, Eigen::VectorXd& right) {
  for (std::size_t m = 0; m < terms.size(); ++m) {
    const auto row = static_cast<Eigen::Index>(m);
    right[row] += heights_x[terms[m].a] * y[terms[m].b];
    for (std::size_t n = 0; n <= m; ++n) {
      normal(row, static_cast<Eigen::Index>(n)) += products_x(terms[m].a, terms[n].a) * y[terms[m].b] * y[terms[n].b];
    }
  }
}

}  // namespace

PolynomialForm::PolynomialForm(const HeightMap& map, Eigen::MatrixXd coefficients)
    : points_x_(map.points_x),
      points_y_(map.points_y),
      half_x_m_(0.5 * map.step_x_m * static_cast<double>(map.points_x - 1)),
      half_y_m_(0.5 * map.step_y_m * static_cast<double>(map.points_y - 1)),
      coefficients_(std::move(coefficients)) {}

void PolynomialForm::row(std::size_t j, std::span<double> heights) const {
  Eigen::VectorXd y(coefficients_.cols());
  legendre(scaled_place(j, points_y_), y);
  const Eigen::VectorXd in_x = coefficients_ * y;
  for (std::size_t i = 0; i < points_x_; ++i) {
    // Clenshaw's sum
    const double t = scaled_place(i, points_x_);
    double later = 0, sum = 0;
    for (Eigen::Index n = in_x.size() - 1; n > 0; --n) {
      const double number = static_cast<double>(n);
      const double next = in_x[n] + (2 * number + 1) / (number + 1) * t * sum - (number + 1) / (number + 2) * later;
      later = sum;
      sum = next;
    }
    heights[i] = in_x[0] + t * sum - 0.5 * later;
  }
}

FormAtCentre PolynomialForm::at_centre() const {
  // Values, first and second derivatives of the Legendre polynomials at 0.
  const Eigen::Index count = std::max(coefficients_.rows(), coefficients_.cols());
  Eigen::MatrixXd at(3, count);
  for (Eigen::Index n = 0; n < count; ++n) {
    if (n < 2) {
      at.col(n) << (n == 0 ? 1 : 0), (n == 0 ? 0 : 1), 0;
      continue;
    }
    const double number = static_cast<double>(n), a = (2 * number - 1) / number, b = (number - 1) / number;
    at(0, n) = -b * at(0, n - 2);
    at(1, n) = a * at(0, n - 1) - b * at(1, n - 2);
    at(2, n) = 2 * a * at(1, n - 1) - b * at(2, n - 2);
  }
  const auto derivative = [&](int in_x, int in_y) {
    return (at.row(in_x).head(coefficients_.rows()) * coefficients_ *
            at.row(in_y).head(coefficients_.cols()).transpose())(0, 0);
  };
  const double per_x = 1 / half_x_m_, per_y = half_y_m_ > 0 ? 1 / half_y_m_ : 0.0;
  return {derivative(0, 0),
          derivative(1, 0) * per_x,
          derivative(0, 1) * per_y,
          derivative(2, 0) * per_x * per_x,
          derivative(1, 1) * per_x * per_y,
          derivative(0, 2) * per_y * per_y};
}

PolynomialForm fit_polynomial(const HeightMap& map, int degree) {
  const std::vector<Term> terms = terms_of(degree, map.is_profile());
  check_map(map, terms.size());
  const auto count = static_cast<Eigen::Index>(terms.size());
  const Eigen::MatrixXd x = basis(map.points_x, degree), y = basis(map.points_y, map.is_profile() ? 0 : degree);
  const Eigen::MatrixXd products_whole = x * x.transpose();
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(count, count);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(count);
  // Heights about one of them: a large offset would cost digits.
  double reference = 0;
  for (std::size_t i = 0; i < map.points(); ++i) {
    if (map.measured(i)) {
      reference = map.height_m[i];
      break;
    }
  }
  Eigen::VectorXd heights(static_cast<Eigen::Index>(map.points_x));
  for (std::size_t j = 0; j < map.points_y; ++j) {
    Eigen::MatrixXd products = products_whole;
    for (std::size_t i = 0; i < map.points_x; ++i) {
      const std::size_t point = map.index(i, j);
      const auto column = static_cast<Eigen::Index>(i);
      if (map.measured(point)) {
        heights[column] = map.height_m[point] - reference;
      } else {
        heights[column] = 0;
        products.noalias() -= x.col(column) * x.col(column).transpose();
      }
    }
    add_row(terms, products, x * heights, y.col(static_cast<Eigen::Index>(j)), normal, right);
  }
  normal.triangularView<Eigen::StrictlyUpper>() = normal.transpose();
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> solver;
  solver.setThreshold(1e-11);  // the resolution of the normal equations
  solver.compute(normal);
  if (solver.rank() < count) {
    throw InputError("the measured points do not determine a form of degree " + std::to_string(degree),
                     "take a lower degree, or a region with fewer missing points");
  }
  const Eigen::VectorXd solution = solver.solve(right);
  Eigen::MatrixXd coefficients = Eigen::MatrixXd::Zero(x.rows(), y.rows());
  for (std::size_t m = 0; m < terms.size(); ++m) {
    coefficients(terms[m].a, terms[m].b) = solution[static_cast<Eigen::Index>(m)];
  }
  coefficients(0, 0) += reference;
  return PolynomialForm(map, std::move(coefficients));
}

}  // namespace ringfilm::surface
