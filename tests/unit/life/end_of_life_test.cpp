#include "ringfilm/life/end_of_life.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "ringfilm/life/wear/face_distance.hpp"

namespace ringfilm::life {
namespace {

TEST(EndOfLife, ALimitIsReachedFromWhicheverSide) {
  EXPECT_DOUBLE_EQ(reaching_time({0, 10, 20}, {1, 2, 6}, 4).value(), 15);
  EXPECT_DOUBLE_EQ(reaching_time({0, 10, 20}, {6, 5, 1}, 3).value(), 15);
  EXPECT_EQ(reaching_time({0, 10, 20}, {1, 2, 6}, 7), std::nullopt);
  EXPECT_EQ(reaching_time({0, 10}, {std::nan(""), 1}, 1), std::nullopt);
}

TEST(FaceDistance, OffsetAndTiltAreFree) {
  const std::vector<double> x = {0, 1, 2, 3, 4}, flat(5, 0.0), line = {1, 3, 5, 7, 9}, wave = {0, 1, 0, -1, 0};
  EXPECT_NEAR(rms_distance(x, line, flat, 2), 0, 1e-12);
  std::vector<double> both;
  for (std::size_t i = 0; i < x.size(); ++i) both.push_back(line[i] + wave[i]);
  // Of (0, 1, 0, -1, 0) about its line of slope -0.2: 2 - 0.4 over five places.
  EXPECT_NEAR(rms_distance(x, both, flat, 2), std::sqrt(1.6 / 5), 1e-12);
}

}  // namespace
}  // namespace ringfilm::life
