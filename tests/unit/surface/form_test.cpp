#include "ringfilm/surface/topography/form.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "ringfilm/base/error.hpp"
#include "surface_maps.hpp"

namespace ringfilm::surface {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr double kRoundOff_m = 1e-16;  // 1e-12 of heights of 100 um

double largest(const HeightMap& map) {
  double most = 0;
  for (std::size_t i = 0; i < map.points(); ++i) {
    if (map.measured(i)) most = std::max(most, std::abs(map.height_m[i]));
  }
  return most;
}

TEST(Form, APlaneIsRemovedToRoundOffWithItsSlopes) {
  for (const double share_missing : {0.0, 0.3}) {
    HeightMap map = map_of(61, 40, 1e-6, 2e-6, [](double x, double y) { return 3e-6 + 0.01 * x - 0.002 * y; });
    if (share_missing > 0) lose_points(map, share_missing, 3);
    const FormRemoved removed = remove_form(map, {FormKind::tilt, 0});
    EXPECT_NEAR(removed.slope_x, 0.01, 1e-14);
    EXPECT_NEAR(removed.slope_y, -0.002, 1e-14);
    EXPECT_NEAR(removed.mean_m, 3e-6 + 0.01 * 30e-6 - 0.002 * 39e-6, 1e-18);
    EXPECT_LT(largest(map), kRoundOff_m);
    EXPECT_THAT(removed.text, HasSubstr("plane"));
  }
}

TEST(Form, ReportsHowLargeItWas) {
  HeightMap map = map_of(61, 1, 1e-6, 0, [](double x, double) { return 0.02 * x; });
  // 61 even steps: variance (61^2 - 1)/12 of a step.
  EXPECT_NEAR(remove_form(map, {FormKind::tilt, 1}).rms_m, 0.02e-6 * std::sqrt((61.0 * 61 - 1) / 12), 1e-18);
  EXPECT_EQ(remove_form(map, {FormKind::none, 0}).text, "nothing");
}

TEST(Form, AMapWithoutAMeanKeepsItsTilt) {
  HeightMap map = map_of(5, 1, 1e-6, 0, [](double x, double) { return 1e-6 + x; });
  remove_form(map, {FormKind::mean, 0});
  EXPECT_NEAR(map.height_m[0], -2e-6, 1e-20);
  EXPECT_NEAR(map.height_m[4], 2e-6, 1e-20);
}

TEST(Form, APolynomialIsRemovedToRoundOffAndAHigherOneIsNot) {
  const auto cubic = [](double x, double y) {
    const double u = x / 1e-4, v = y / 1e-4;
    return 1e-5 * (0.3 + u - 2 * v + u * v - v * v + u * u * v - 0.5 * u * u * u);
  };
  HeightMap map = map_of(90, 70, 1e-6, 1.5e-6, cubic);
  lose_points(map, 0.1, 5);
  HeightMap lower = map;
  remove_form(map, {FormKind::polynomial, 3});
  EXPECT_LT(largest(map), kRoundOff_m);
  remove_form(lower, {FormKind::polynomial, 2});
  EXPECT_GT(largest(lower), 1e-7);
}

TEST(Form, AProfileOfDegreeEightIsRemoved) {
  HeightMap map = map_of(300, 1, 1e-6, 0, [](double x, double) { return 1e-5 * std::pow(x / 1e-4 - 1.2, 8); });
  remove_form(map, {FormKind::polynomial, 8});
  EXPECT_LT(largest(map), 1e-15);  // 1e-12 of 3.7e-4 m and the condition of degree 8
}

struct CylinderCase {
  const char* name;
  double radius_m, angle_rad, tilt_rad, offset_m, missing;
};

class FormOfACylinder : public ::testing::TestWithParam<CylinderCase> {};

/// Heights by intersecting a vertical line with the cylinder in space: a quadratic equation, not the form of the code.
double height_of_cylinder(const CylinderCase& of, double x, double y) {
  const double R = std::abs(of.radius_m);
  const double d[3] = {std::cos(of.angle_rad) * std::cos(of.tilt_rad), std::sin(of.angle_rad) * std::cos(of.tilt_rad),
                       std::sin(of.tilt_rad)};
  // A point of the axis: offset across it, R below (convex) or above the plane.
  const double q[3] = {-of.offset_m * std::sin(of.angle_rad), of.offset_m * std::cos(of.angle_rad),
                       of.radius_m > 0 ? -R : R};
  const double p[3] = {x - q[0], y - q[1], -q[2]};
  const double pd = p[0] * d[0] + p[1] * d[1] + p[2] * d[2];
  const double a = 1 - d[2] * d[2], b = p[2] - pd * d[2];
  const double c = p[0] * p[0] + p[1] * p[1] + p[2] * p[2] - pd * pd - R * R;
  const double root = std::sqrt(b * b - a * c);
  return (-b + (of.radius_m > 0 ? root : -root)) / a;
}

TEST_P(FormOfACylinder, IsFoundWithItsRadiusAndItsAxis) {
  const CylinderCase& of = GetParam();
  const double half_x = 119.5e-6 * 2, half_y = 59.5e-6 * 3;
  HeightMap map =
      map_of(240, 120, 2e-6, 3e-6, [&](double x, double y) { return height_of_cylinder(of, x - half_x, y - half_y); });
  if (of.missing > 0) lose_points(map, of.missing, 11);
  const FormRemoved removed = remove_form(map, {FormKind::cylinder, 0});
  ASSERT_TRUE(removed.cylinder);
  // Heights near R have R times 1e-16 of round-off; a curvature costs it over the sag.
  const double sag = half_y * half_y / (2 * std::abs(of.radius_m));
  const double relative = 100 * 2.2e-16 * std::abs(of.radius_m) / sag;
  EXPECT_NEAR(removed.cylinder->radius_m / of.radius_m, 1, relative);
  EXPECT_NEAR(removed.cylinder->axis_angle_rad, of.angle_rad, relative);
  EXPECT_NEAR(removed.cylinder->axis_tilt_rad, of.tilt_rad, 10 * relative);
  EXPECT_NEAR(removed.cylinder->ridge_offset_m, of.offset_m, 100e-6 * relative);
  EXPECT_LT(largest(map), 100 * 2.2e-16 * std::abs(of.radius_m));
}

INSTANTIATE_TEST_SUITE_P(Cases, FormOfACylinder,
                         ::testing::Values(CylinderCase{"AlongX", 0.0445, 0, 0, 0, 0},
                                           CylinderCase{"NearX", -0.0445, 0.05, 0.001, 20e-6, 0},
                                           CylinderCase{"NearY", 0.005, 1.5, -0.01, -30e-6, 0.2},
                                           CylinderCase{"Slanted", 0.001, 0.7, 0.02, 40e-6, 0.1},
                                           CylinderCase{"Strong", 0.0006, -0.3, 0.0, 50e-6, 0}),
                         [](const auto& of) { return of.param.name; });

TEST(Form, ACircleIsRemovedFromAProfile) {
  const double R = 0.002;
  HeightMap map = map_of(401, 1, 1e-6, 0,
                         [&](double x, double) { return std::sqrt(R * R - (x - 150e-6) * (x - 150e-6)) - R + 4e-6; });
  const FormRemoved removed = remove_form(map, {FormKind::cylinder, 0});
  EXPECT_NEAR(removed.cylinder->radius_m, R, 1e-9 * R);
  EXPECT_NEAR(removed.cylinder->ridge_offset_m, -50e-6, 1e-12);
  EXPECT_LT(largest(map), 1e-16);
}

TEST(Form, ACylinderThatIsNotThereIsRefused) {
  HeightMap plane = map_of(30, 30, 1e-6, 1e-6, [](double x, double y) { return 1e-2 * x + 0 * y; });
  EXPECT_THAT(
      [&] {
        remove_form(plane, {FormKind::cylinder, 0});
      },
      ThrowsMessage<InputError>(HasSubstr("curvature of the map cannot be separated")));
  std::mt19937 generator(4);
  std::normal_distribution<double> normal;
  HeightMap rough = map_of(30, 30, 1e-6, 1e-6, [&](double, double) { return 1e-7 * normal(generator); });
  EXPECT_THROW(remove_form(rough, {FormKind::cylinder, 0}), InputError);
}

TEST(Form, WhatTheMeasuredPointsDoNotDetermineIsRefused) {
  HeightMap map = map_of(20, 20, 1e-6, 1e-6, [](double x, double y) { return x + y; });
  map.missing.assign(map.points(), 1);
  for (std::size_t i = 0; i < 20; ++i) map.missing[map.index(i, 7)] = 0;  // one row is left
  EXPECT_THAT(
      [&] {
        remove_form(map, {FormKind::tilt, 1});
      },
      ThrowsMessage<InputError>(HasSubstr("do not determine a form of degree 1")));
  HeightMap few = map_of(2, 1, 1e-6, 0, [](double x, double) { return x; });
  EXPECT_THAT(
      [&] {
        remove_form(few, {FormKind::polynomial, 3});
      },
      ThrowsMessage<InputError>(HasSubstr("2 measured points, fewer than 4")));
  EXPECT_THROW(remove_form(few, {FormKind::polynomial, 13}), InputError);
}

TEST(Topography, MapsThatNoAnalysisCanTakeAreRefused) {
  const HeightMap good = map_of(4, 3, 1e-6, 1e-6, [](double x, double y) { return x * y; });
  EXPECT_NO_THROW(check_map(good, 12));
  const auto refused = [](HeightMap map, const char* why) {
    EXPECT_THAT([&] { check_map(map); }, ThrowsMessage<InputError>(HasSubstr(why)));
  };
  HeightMap map = good;
  map.height_m[6] = NAN;
  refused(map, "column 3 of row 2 is not a number but nan");
  map.height_m[6] = INFINITY;
  refused(map, "column 3 of row 2 is not a number but inf");
  refused({}, "a map of 0 x 0 points has no heights");
  map.missing.assign(12, 0);
  refused(map, "is not a number");
  map.missing[6] = 1;
  EXPECT_NO_THROW(check_map(map));
  map = good;
  map.height_m.pop_back();
  refused(map, "holds 11 heights");
  map = good;
  map.points_x = 1;
  map.points_y = 12;
  refused(map, "one column");
  map = good;
  map.step_x_m = 0;
  refused(map, "not positive lengths");
  map = good;
  map.step_y_m = NAN;
  refused(map, "not positive lengths");
  map = good;
  map.points_x = SIZE_MAX / 2 + 2;
  refused(map, "holds 12 heights");
  map = good;
  map.missing.assign(12, 1);
  refused(map, "0 measured points");
  EXPECT_THROW(check_map(HeightMap{}), InputError);
}

}  // namespace
}  // namespace ringfilm::surface
