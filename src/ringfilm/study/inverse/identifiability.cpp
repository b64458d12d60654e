#include "ringfilm/study/inverse/identifiability.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "ringfilm/base/number_text.hpp"

namespace ringfilm::study {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kHalfWidth = 1.959964;       // half a 95 % interval in standard deviations of a normal distribution
constexpr double kMinPart = 0.1;              // part of a direction below which a parameter is not named; assumed
constexpr double kMinShare = 0.05;            // part of a direction above which a parameter is not determined; assumed
constexpr double kSameSize = 0.05;            // relative difference up to which two changes form a product or a ratio
constexpr double kUniformVariance = 1. / 12;  // variance of a place that may be anywhere between the bounds

/// A parameter in a direction.
struct Part {
  std::string name;
  double change;  ///< relative, or of the bounds where the value is 0
};

std::vector<Part> named_parts(const VectorXd& direction, const std::vector<NamedParameter>& parameters) {
  std::vector<Part> parts;
  const bool is_relative = std::all_of(parameters.begin(), parameters.end(),
                                       [](const NamedParameter& one) { return one.relative_slope != 0; });
  for (std::size_t j = 0; j < parameters.size(); ++j) {
    const double slope = is_relative ? parameters[j].relative_slope : 1;
    // A part counts by its place between the bounds, and is named by its relative change.
    if (std::abs(direction[static_cast<Eigen::Index>(j)]) < kMinPart * direction.cwiseAbs().maxCoeff()) continue;
    parts.push_back({parameters[j].name, direction[static_cast<Eigen::Index>(j)] * slope});
  }
  std::stable_sort(parts.begin(), parts.end(),
                   [](const Part& a, const Part& b) { return std::abs(a.change) > std::abs(b.change); });
  return parts;
}

std::string direction_words(const VectorXd& direction, const std::vector<NamedParameter>& parameters) {
  const std::vector<Part> parts = named_parts(direction, parameters);
  if (parts.size() == 1) return parts[0].name + " is not determined: it hardly changes what was measured";
  const double ratio = parts[1].change / parts[0].change;
  std::vector<std::string> names;
  for (const Part& part : parts) names.push_back(part.name);
  if (parts.size() == 2 && std::abs(ratio + 1) < kSameSize) {
    std::sort(names.begin(), names.end());
    return "only the product " + names[0] + " x " + names[1] + " is determined";
  }
  if (parts.size() == 2 && std::abs(ratio - 1) < kSameSize) {
    std::sort(names.begin(), names.end());
    return "only the ratio " + names[0] + " / " + names[1] + " is determined";
  }
  std::string words =
      "only a combination is determined: what was measured hardly changes when " + parts[0].name + " rises by 1 %";
  for (std::size_t k = 1; k < parts.size(); ++k) {
    const double change = parts[k].change / parts[0].change;  // in percent for 1 %
    words += std::string(k + 1 == parts.size() ? " and " : ", ") + parts[k].name +
             (change < 0 ? " falls by " : " rises by ") + number_text(std::abs(change), 2) + " %";
  }
  return words;
}

}  // namespace

MatrixXd marginal_information(const MatrixXd& all, Eigen::Index n) {
  const Eigen::Index rest = all.rows() - n;
  if (rest == 0) return all;
  const MatrixXd others = all.bottomRightCorner(rest, rest), joint = all.topRightCorner(n, rest);
  return all.topLeftCorner(n, n) - joint * others.fullPivLu().solve(joint.transpose());
}

Identifiability identifiability(const MatrixXd& information, const MatrixXd& prior, double noise,
                                const std::vector<NamedParameter>& parameters) {
  const Eigen::Index n = information.rows();
  const Eigen::SelfAdjointEigenSolver<MatrixXd> modes(information);
  Identifiability found;
  // A direction whose 95 % interval is as wide as the bounds themselves is not determined.
  const double least = 4 * kHalfWidth * kHalfWidth;
  VectorXd variance = VectorXd::Zero(n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const VectorXd direction = modes.eigenvectors().col(k);
    const double value = modes.eigenvalues()[k];
    if (value > std::max(least, noise)) {
      variance += direction.cwiseAbs2() / value;
      continue;
    }
    FreeDirection free{{direction.data(), direction.data() + n}, direction_words(direction, parameters)};
    found.directions.push_back(std::move(free));
    for (Eigen::Index j = 0; j < n; ++j) {
      if (std::abs(direction[j]) > kMinShare) variance[j] = std::numeric_limits<double>::infinity();
    }
  }
  for (Eigen::Index j = 0; j < n; ++j) {
    found.deviations.push_back(std::sqrt(variance[j]));
    found.is_determined.push_back(2 * kHalfWidth * found.deviations.back() < 1);
  }
  MatrixXd all = information + prior;
  if (!found.directions.empty()) all.diagonal().array() += 1 / kUniformVariance;
  found.covariance = all.fullPivLu().inverse();
  return found;
}

}  // namespace ringfilm::study
