#include "ringfilm/base/pack.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "../../traps/floating_point_traps.hpp"

namespace ringfilm::base {
namespace {

/// A pack is to do in every lane what a double does.
template <class Real>
class PackOf : public ::testing::Test {
 protected:
  using Mask = typename Real::Mask;

  static std::vector<double> numbers(Real pack) {
    std::vector<double> all(Real::kWidth);
    pack.store(all.data());
    return all;
  }
  /// first, first + step, ... in the lanes.
  static Real ramp(double first, double step) {
    std::vector<double> all;
    for (int lane = 0; lane < Real::kWidth; ++lane) all.push_back(first + lane * step);
    return Real::load(all.data());
  }
  /// 1 where the mask holds, 0 elsewhere.
  static std::vector<double> flags(Mask mask) { return numbers(select(mask, Real(1), Real(0))); }

  /// `pack` must hold, lane by lane, what `of_doubles` gives for the lanes of a and b.
  template <class Operation>
  static void expect_lane_by_lane(Real pack, Real a, Real b, Operation of_doubles) {
    for (int lane = 0; lane < Real::kWidth; ++lane) {
      EXPECT_EQ(numbers(pack)[lane], of_doubles(numbers(a)[lane], numbers(b)[lane])) << "lane " << lane;
    }
  }
};

using Widths = ::testing::Types<Pack<1, InstructionSet::kBaseline>, Pack<2, InstructionSet::kBaseline>>;
TYPED_TEST_SUITE(PackOf, Widths);

TYPED_TEST(PackOf, OneNumberFillsAllLanes) {
  for (const double x : this->numbers(TypeParam(0.1))) EXPECT_EQ(x, 0.1);
  for (const double x : this->numbers(TypeParam(-0.0))) EXPECT_TRUE(std::signbit(x));
  for (const double x : this->numbers(TypeParam(INFINITY))) EXPECT_EQ(x, INFINITY);
}

TYPED_TEST(PackOf, CalculatesLikeADoubleInEveryLane) {
  const TypeParam a = this->ramp(0.1, 0.7), b = this->ramp(-3.3, 1.9);
  this->expect_lane_by_lane(a + b, a, b, [](double x, double y) { return x + y; });
  this->expect_lane_by_lane(a - b, a, b, [](double x, double y) { return x - y; });
  this->expect_lane_by_lane(a * b, a, b, [](double x, double y) { return x * y; });
  this->expect_lane_by_lane(a / b, a, b, [](double x, double y) { return x / y; });
  this->expect_lane_by_lane(-a, a, b, [](double x, double) { return -x; });
  TypeParam sum = a;
  sum += b;
  this->expect_lane_by_lane(sum, a, b, [](double x, double y) { return x + y; });
  sum -= b;
  this->expect_lane_by_lane(sum, a, b, [](double x, double y) { return (x + y) - y; });
}

TYPED_TEST(PackOf, ComparesAndChoosesInEveryLane) {
  const TypeParam a = this->ramp(1, -3), b = this->ramp(0, 0);  // lane 0: a > b; lane 1: a < b
  this->expect_lane_by_lane(select(a < b, TypeParam(5), TypeParam(6)), a, b,
                            [](double x, double y) { return x < y ? 5 : 6; });
  this->expect_lane_by_lane(select(a > b, TypeParam(5), TypeParam(6)), a, b,
                            [](double x, double y) { return x > y ? 5 : 6; });
  this->expect_lane_by_lane(max(a, b), a, b, [](double x, double y) { return std::max(x, y); });
  this->expect_lane_by_lane(min(a, b), a, b, [](double x, double y) { return std::min(x, y); });
  this->expect_lane_by_lane(abs(a), a, b, [](double x, double) { return std::abs(x); });
  for (const double equal : this->flags(a >= a)) EXPECT_EQ(equal, 1);
  for (const double equal : this->flags(a > a)) EXPECT_EQ(equal, 0);
}

TYPED_TEST(PackOf, OfTwoOneOfWhichIsNotANumberTheSecondIsTaken) {
  const ringfilm::traps::NoTraps no_traps;  // a NaN on purpose
  const TypeParam nan(std::numeric_limits<double>::quiet_NaN());
  for (const TypeParam taken : {max(nan, TypeParam(1)), min(nan, TypeParam(1))}) {
    for (const double x : this->numbers(taken)) EXPECT_EQ(x, 1);
  }
  for (const TypeParam taken : {max(TypeParam(1), nan), min(TypeParam(1), nan)}) {
    for (const double x : this->numbers(taken)) EXPECT_TRUE(std::isnan(x));
  }
}

TYPED_TEST(PackOf, MasksAreJoinedLaneByLane) {
  const TypeParam x = this->ramp(-1, 2);  // lane 0 below, lane 1 above 0
  for (const double a : {-2.0, 0.0, 2.0}) {
    for (const double b : {-2.0, 0.0, 2.0}) {
      const auto over_a = x > TypeParam(a), over_b = x > TypeParam(b);
      this->expect_lane_by_lane(select(TypeParam::both(over_a, over_b), TypeParam(1), TypeParam(0)), x, x,
                                [&](double v, double) { return v > a && v > b; });
      this->expect_lane_by_lane(select(TypeParam::differ(over_a, over_b), TypeParam(1), TypeParam(0)), x, x,
                                [&](double v, double) { return (v > a) != (v > b); });
      this->expect_lane_by_lane(select(TypeParam::only(over_a, over_b), TypeParam(1), TypeParam(0)), x, x,
                                [&](double v, double) { return v > a && !(v > b); });
    }
  }
}

TYPED_TEST(PackOf, AnyIsTrueForOneLaneOfAll) {
  for (int lane = 0; lane < TypeParam::kWidth; ++lane) {
    std::vector<double> one(TypeParam::kWidth, 0.0);
    one[lane] = 1;
    EXPECT_TRUE(TypeParam::any(TypeParam::load(one.data()) > TypeParam(0))) << "lane " << lane;
  }
  EXPECT_FALSE(TypeParam::any(TypeParam(0) > TypeParam(0)));
}

TYPED_TEST(PackOf, SumsFromTheFirstLaneOn) {
  const TypeParam x = this->ramp(0.1, 0.2);
  double sum = 0;
  for (const double lane : this->numbers(x)) sum += lane;
  EXPECT_EQ(x.sum(), sum);
}

TYPED_TEST(PackOf, GathersNumbersThatLieApart) {
  std::vector<double> memory;
  for (int i = 0; i < 3 * TypeParam::kWidth; ++i) memory.push_back(i);
  for (const int stride : {1, 2, 3}) {
    const auto gathered = this->numbers(TypeParam::gather(memory.data(), stride));
    for (int lane = 0; lane < TypeParam::kWidth; ++lane) EXPECT_EQ(gathered[lane], lane * stride);
  }
}

TYPED_TEST(PackOf, OnePolynomialAtPacksAbreast) {
  const double c[] = {0.7, -1.3, 0.4, 2.1};
  const TypeParam t[] = {this->ramp(-0.7, 1.1), this->ramp(0.2, -0.3)};
  TypeParam value[2];
  sum_of_powers<4, 2>(c, t, value);
  for (int a = 0; a < 2; ++a) {
    for (int lane = 0; lane < TypeParam::kWidth; ++lane) {
      const double x = this->numbers(t[a])[lane];
      const double direct = c[0] + c[1] * x + c[2] * x * x + c[3] * x * x * x;
      // a handful of operations of order one, but for powers of steps beyond one
      EXPECT_NEAR(this->numbers(value[a])[lane], direct, 1e-14 * (1 + std::abs(x * x * x))) << "lane " << lane;
    }
  }
}

}  // namespace
}  // namespace ringfilm::base
