#include "ringfilm/io/measurement/thinned_curve.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {

using namespace ringfilm;
using io::thinned;
using io::ThinnedSeries;

io::MeasuredCurve long_curve(bool logarithmic) {
  io::MeasuredCurve curve;
  curve.x_axis.logarithmic = logarithmic;
  io::MeasuredSeries series{"height", "", {}, false};
  for (int i = 0; i < 20000; ++i) {
    curve.x.push_back(1.0 + i);
    series.y.push_back(std::sin(i / 300.0));
  }
  series.y[7777] = 12;
  series.y[13001] = -9;
  curve.series = {series};
  return curve;
}

TEST(ThinnedCurve, KeepsEveryPeakAndTheOrder) {
  const io::MeasuredCurve curve = long_curve(false);
  const ThinnedSeries few = thinned(curve, curve.series[0], 500);
  EXPECT_LE(few.x.size(), 4u * 500u);
  EXPECT_GE(few.x.size(), 2u * 500u);
  EXPECT_TRUE(std::is_sorted(few.x.begin(), few.x.end()));
  EXPECT_EQ(few.x.front(), curve.x.front());
  EXPECT_EQ(few.x.back(), curve.x.back());
  const auto at = [&](double x) { return few.y[std::find(few.x.begin(), few.x.end(), x) - few.x.begin()]; };
  EXPECT_EQ(at(7778), 12);
  EXPECT_EQ(at(13002), -9);
}

TEST(ThinnedCurve, KeepsGaps) {
  io::MeasuredCurve curve = long_curve(false);
  for (int i = 4000; i < 6000; ++i) curve.series[0].y[i] = std::nan("");
  const ThinnedSeries few = thinned(curve, curve.series[0], 500);
  bool has_gap = false;
  for (std::size_t i = 0; i < few.x.size(); ++i) {
    const bool missing = few.x[i] > 4000 && few.x[i] <= 6000;
    EXPECT_EQ(std::isnan(few.y[i]), missing) << few.x[i];
    has_gap = has_gap || missing;
  }
  EXPECT_TRUE(has_gap);
}

TEST(ThinnedCurve, SpendsItsPointsEvenlyAlongALogarithmicAxis) {
  const io::MeasuredCurve curve = long_curve(true);
  const ThinnedSeries few = thinned(curve, curve.series[0], 500);
  // The first decade of 4.3 holds 9 points: all of them are drawn.
  EXPECT_EQ(std::count_if(few.x.begin(), few.x.end(), [](double x) { return x < 9.5; }), 9);
  EXPECT_LE(few.x.size(), 4u * 500u);
}

TEST(ThinnedCurve, LeavesAShortCurveAlone) {
  io::MeasuredCurve curve = long_curve(false);
  curve.x.resize(2000);
  curve.series[0].y.resize(2000);
  EXPECT_EQ(thinned(curve, curve.series[0], 500).y, curve.series[0].y);
}

}  // namespace
