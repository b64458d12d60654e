#include "ringfilm/models/section/polygon.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ringfilm/models/section/section_forms.hpp"

namespace ringfilm::models {
namespace {

constexpr double kHeight = 1.2e-3, kThickness = 3.5e-3;

TEST(SectionPolygon, RectangleHasTheMomentsOfItsSides) {
  const SectionArea of = section_area(rectangular_section(kHeight, kThickness));
  EXPECT_NEAR(of.area, kHeight * kThickness, 1e-18);
  EXPECT_NEAR(of.centroid.axial, kHeight / 2, 1e-15);
  EXPECT_NEAR(of.centroid.radial, kThickness / 2, 1e-15);
  EXPECT_NEAR(of.axial, kThickness * std::pow(kHeight, 3) / 12, 1e-24);
  EXPECT_NEAR(of.radial, kHeight * std::pow(kThickness, 3) / 12, 1e-24);
  EXPECT_EQ(of.product, 0);
}

TEST(SectionPolygon, SenseAndPlaceOfTheCornersHaveNoInfluence) {
  const SectionPolygon section = bevelled_section(kHeight, kThickness, 6e-4, 0.8, SectionSide::kChamber);
  SectionPolygon other(section.rbegin(), section.rend());
  for (SectionPoint& corner : other) {
    corner.axial += 0.03;
    corner.radial -= 0.02;
  }
  const SectionArea a = section_area(section), b = section_area(other);
  EXPECT_NEAR(b.area, a.area, 1e-12 * a.area);
  EXPECT_NEAR(b.product, a.product, 1e-9 * a.product);
  EXPECT_NEAR(b.centroid.axial - 0.03, a.centroid.axial, 1e-12);
}

TEST(SectionPolygon, BevelTowardsTheChamberHasAPositiveProductOfInertia) {
  const auto product = [](SectionSide side) {
    return section_area(bevelled_section(kHeight, kThickness, 6e-4, std::numbers::pi / 4, side)).product;
  };
  EXPECT_GT(product(SectionSide::kChamber), 0);
  EXPECT_NEAR(product(SectionSide::kCrankcase), -product(SectionSide::kChamber), 1e-24);
  EXPECT_EQ(product(SectionSide::kBoth), 0);
}

TEST(SectionPolygon, PrincipalAxesTurnWithTheSection) {
  constexpr double kTurn = 0.3;
  SectionPolygon turned;
  for (const SectionPoint& p : rectangular_section(kHeight, kThickness)) {
    turned.push_back({p.axial * std::cos(kTurn) + p.radial * std::sin(kTurn),
                      p.radial * std::cos(kTurn) - p.axial * std::sin(kTurn)});
  }
  const PrincipalAxes axes = principal_axes(section_area(turned));
  EXPECT_NEAR(axes.largest, kHeight * std::pow(kThickness, 3) / 12, 1e-22);
  EXPECT_NEAR(axes.smallest, kThickness * std::pow(kHeight, 3) / 12, 1e-22);
  EXPECT_NEAR(axes.angle, kTurn, 1e-12);
}

TEST(SectionPolygon, FaultsAreFoundWithTheirPlace) {
  const auto fault = [](const SectionPolygon& section) { return polygon_fault(section).value().fault; };
  EXPECT_FALSE(polygon_fault(napier_section(1.5e-3, kThickness, 4e-4, 5e-4, 0.02)));
  EXPECT_FALSE(polygon_fault(keystone_section(1.5e-3, kThickness, 0.1, SectionSide::kBoth)));
  EXPECT_EQ(fault({{0, 0}, {1, 0}}), PolygonFault::kFewCorners);
  EXPECT_EQ(fault({{0, 0}, {1, 0}, {1, 0}, {0, 1}}), PolygonFault::kRepeatedCorner);
  EXPECT_EQ(fault({{0, 0}, {1, 0}, {2, 0}}), PolygonFault::kNoArea);
  EXPECT_EQ(fault({{0, 0}, {1, 1}, {1, 0}, {0, 1}}), PolygonFault::kOverlaps);          // a bow tie
  EXPECT_EQ(fault({{0, 0}, {2, 0}, {1, 0}, {1, 1}}), PolygonFault::kOverlaps);          // turns back onto a side
  EXPECT_EQ(fault({{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}}), PolygonFault::kOverlaps);  // a corner on a side
  const FaultOfPolygon bow = polygon_fault({{0, 0}, {1, 1}, {1, 0}, {0, 1}}).value();
  EXPECT_EQ(bow.first, 0U);
  EXPECT_EQ(bow.second, 2U);
}

TEST(SectionPolygon, NormalizedHasNoCornersOnStraightSides) {
  const SectionPolygon corners = normalized({{0, 0}, {0, 1}, {1, 1}, {1, 0}, {0.5, 0}});
  EXPECT_EQ(corners.size(), 4U);
  EXPECT_NEAR(section_area(corners).area, 1, 1e-15);
}

}  // namespace
}  // namespace ringfilm::models
