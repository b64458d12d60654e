#include "ringfilm/models/conformity/beam_elements.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ringfilm::models {
namespace {

/// Gauss' points and weights of order 7 on [0, 1].
struct GaussPoint {
  double s, weight;
};
constexpr GaussPoint kGauss[] = {{0.069431844202973712, 0.17392742256872693},
                                 {0.33000947820757187, 0.32607257743127307},
                                 {0.66999052179242813, 0.32607257743127307},
                                 {0.93056815579702629, 0.17392742256872693}};

}  // namespace

BeamElements::BeamElements(const RingBeam& beam, std::vector<double> phi)
    : phi_(std::move(phi)), rigidity_(beam.stiffness() / beam.centroid_radius()) {
  const int n = n_nodes();
  for (int i = 0; i < n; ++i) {
    const int low = std::max(i - 1, 0), high = std::min(i + 1, n - 1);
    length_.push_back((phi_[high] - phi_[low]) / (high - low));
  }
  stiffness_.assign(static_cast<std::size_t>(2 * n) * kWidth, 0.0);
  for (int e = 0; e + 1 < n; ++e) {
    for (const GaussPoint& at : kGauss) {
      const Shapes shapes = bending(e, at.s);
      const double weight = rigidity_ * at.weight * (phi_[e + 1] - phi_[e]);
      for (int a = 0; a < 4; ++a) {
        for (int b = a; b < 4; ++b) {
          stiffness_[static_cast<std::size_t>(2 * e + a) * kWidth + b - a] +=
              weight * shapes.value[a] * shapes.value[b];
        }
      }
    }
  }
}

BeamElements::Shapes BeamElements::bending(int e, double s) const {
  const double h = phi_[e + 1] - phi_[e];
  const double left = h / length_[e], right = h / length_[e + 1];
  const double u[4] = {1 - s * s * (3 - 2 * s), left * s * (1 - s) * (1 - s), s * s * (3 - 2 * s),
                       -right * s * s * (1 - s)};
  const double curvature[4] = {12 * s - 6, left * (6 * s - 4), 6 - 12 * s, right * (6 * s - 2)};
  Shapes shapes;
  for (int a = 0; a < 4; ++a) shapes.value[a] = u[a] + curvature[a] / (h * h);
  return shapes;
}

std::vector<double> BeamElements::force_of_shape(const FourierSeries& deviation) const {
  constexpr double kPiece = 0.5;  // largest length of a piece times the highest order [rad]
  int highest = 1;
  for (const FourierOrder& one : deviation.orders()) highest = std::max(highest, one.order);
  std::vector<double> force(2 * phi_.size(), 0.0);
  for (int e = 0; e + 1 < n_nodes(); ++e) {
    const double h = phi_[e + 1] - phi_[e];
    const int pieces = static_cast<int>(std::ceil(highest * h / kPiece));
    for (int piece = 0; piece < pieces; ++piece) {
      for (const GaussPoint& at : kGauss) {
        const double s = (piece + at.s) / pieces, angle = phi_[e] + s * h;
        const double bent = deviation(angle) + deviation.derivative(angle, 2);
        const Shapes shapes = bending(e, s);
        for (int a = 0; a < 4; ++a) {
          force[2 * e + a] += rigidity_ * at.weight / pieces * h * bent * shapes.value[a];
        }
      }
    }
  }
  return force;
}

}  // namespace ringfilm::models
