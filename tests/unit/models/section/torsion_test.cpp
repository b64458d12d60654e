#include "ringfilm/models/section/torsion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "ringfilm/models/section/section_forms.hpp"

namespace ringfilm::models {
namespace {

/// St Venant's series for the sides a >= b, timoshenko1970, chapter 10.
double of_rectangle(double a, double b) {
  double sum = 0;
  for (int n = 1; n < 100; n += 2) sum += std::tanh(n * std::numbers::pi * a / (2 * b)) / std::pow(n, 5);
  return a * std::pow(b, 3) / 3 * (1 - 192 / std::pow(std::numbers::pi, 5) * b / a * sum);
}

void expect_between(const SectionPolygon& section, double exact) {
  const TorsionConstant of = torsion_constant(section);
  // The bounds hold whatever the mesh, to the rounding of its equations.
  EXPECT_LE(of.lower, exact * (1 + 1e-9));
  EXPECT_GE(of.upper, exact * (1 - 1e-9));
  EXPECT_NEAR(of.value, exact, kTorsionTolerance * exact);
}

TEST(Torsion, BoundsHoldTheClosedForms) {
  expect_between({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, of_rectangle(1, 1));
  expect_between(rectangular_section(1.2e-3, 3.5e-3), of_rectangle(3.5e-3, 1.2e-3));
  expect_between({{0, 0}, {0.5, std::sqrt(3) / 2}, {1, 0}}, std::sqrt(3) / 80);
  EXPECT_NEAR(torsion_constant({{0, 0}, {1, 0}, {1, 1}, {0, 1}}).value, 0.1406, 5e-5);
}

TEST(Torsion, BoundsMeetAtReentrantCorners) {
  const TorsionConstant of = torsion_constant(napier_section(1.5e-3, 3.5e-3, 4e-4, 5e-4, 0.02));
  EXPECT_LT(of.upper - of.lower, kTorsionTolerance * of.value);
  EXPECT_LT(of.upper, torsion_constant(rectangular_section(1.5e-3, 3.5e-3)).lower);
}

TEST(Torsion, GoesWithTheFourthPowerOfTheSize) {
  const SectionPolygon section = bevelled_section(1.2, 3.5, 0.6, std::numbers::pi / 4, SectionSide::kChamber);
  SectionPolygon small;
  for (const SectionPoint& corner : section) small.push_back({1e-3 * corner.axial, 1e-3 * corner.radial});
  const double of_small = torsion_constant(small).value;
  EXPECT_NEAR(of_small, 1e-12 * torsion_constant(section).value, 1e-9 * of_small);
}

}  // namespace
}  // namespace ringfilm::models
