#include "ringfilm/models/conformity/beam_elements.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace ringfilm::models::testing {
namespace {

using std::numbers::pi;

/// The ring of cases/distorted-bore without end gap.
RingBeam ring() { return {{0.089, 1.2e-3, 3.5e-3, 203e9, 10.68, 0}, {}}; }

std::vector<double> even_nodes(int n) {
  std::vector<double> phi;
  for (int i = 0; i <= n; ++i) phi.push_back(2 * pi * i / n);
  return phi;
}

/// Unknowns of amplitude cos(order phi).
std::vector<double> wave(const BeamElements& elements, int order, double amplitude) {
  std::vector<double> u;
  for (int i = 0; i < elements.n_nodes(); ++i) {
    u.push_back(amplitude * std::cos(order * elements.phi()[i]));
    u.push_back(-amplitude * order * std::sin(order * elements.phi()[i]) * elements.slope_length(i));
  }
  return u;
}

double energy(const BeamElements& elements, const std::vector<double>& u) {
  constexpr int kWidth = BeamElements::kWidth;
  double sum = 0;
  for (std::size_t i = 0; i < u.size(); ++i) {
    sum += 0.5 * elements.stiffness()[i * kWidth] * u[i] * u[i];
    for (std::size_t k = 1; k < kWidth && i + k < u.size(); ++k) {
      sum += elements.stiffness()[i * kWidth + k] * u[i] * u[i + k];
    }
  }
  return sum;
}

/// k/(2 r) times the integral of (u + u'')^2.
double exact_energy(const RingBeam& beam, int order, double amplitude) {
  const double bent = amplitude * (1 - order * order);
  return beam.stiffness() / (2 * beam.centroid_radius()) * bent * bent * pi;
}

TEST(BeamElements, EnergyOfAWaveIsThatOfTheBeamToFourthOrder) {
  const RingBeam beam = ring();
  for (const int order : {2, 3, 4}) {
    double error[2];
    for (const int k : {0, 1}) {
      const BeamElements elements(beam, even_nodes(40 << k));
      error[k] = energy(elements, wave(elements, order, 1e-6)) / exact_energy(beam, order, 1e-6) - 1;
    }
    EXPECT_LT(std::abs(error[1]), 1e-4) << order;
    EXPECT_NEAR(error[0] / error[1], 16, 2) << order;
  }
}

TEST(BeamElements, ADisplacedRingIsNotBent) {
  const RingBeam beam = ring();
  const BeamElements elements(beam, even_nodes(180));
  EXPECT_LT(energy(elements, wave(elements, 1, 15e-6)), 1e-8 * exact_energy(beam, 2, 15e-6));
}

TEST(BeamElements, ForceOfAShapeIsThatOfItsUnknowns) {
  const RingBeam beam = ring();
  const BeamElements elements(beam, even_nodes(90));
  const std::vector<double> force = elements.force_of_shape(FourierSeries({{3, 5e-6, 0}}));
  double work = 0;
  const std::vector<double> u = wave(elements, 3, 5e-6);
  for (std::size_t i = 0; i < u.size(); ++i) work += 0.5 * force[i] * u[i];
  EXPECT_NEAR(work / exact_energy(beam, 3, 5e-6), 1, 1e-4);
}

}  // namespace
}  // namespace ringfilm::models::testing
