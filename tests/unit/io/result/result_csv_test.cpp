#include "ringfilm/io/result/result_csv.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>
#include <sstream>

namespace ringfilm::io {
namespace {

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

TEST(ResultCsv, HeaderIsTheContractOfNames) {
  // The first columns as scripts of other people rely on them.
  EXPECT_THAT(result_csv(std::vector<cycle::Sample>{}),
              testing::StartsWith(
                  "crank_angle [degree],piston_velocity [m/s],gas_pressure [Pa],applied_load [N],min_film_thickness "
                  "[m],lambda_ratio,hydrodynamic_load [N],asperity_load [N],asperity_contact_area [m2],"
                  "boundary_friction [N],viscous_friction [N],viscous_friction_ring [N],total_friction [N],"
                  "friction_on_liner [N],friction_coefficient,power_loss [W],oil_flow_middle [kg/s],"
                  "peak_film_pressure [Pa],cavitated_fraction,sliding_distance [m],"));
}

TEST(ResultCsv, NumbersReadBackExactlyAndAnglesStayShort) {
  cycle::Sample sample;
  sample.crank_angle_deg = 719;
  sample.piston_velocity = -0.1;
  sample.gas_pressure = 2395369.6737;
  sample.min_film_thickness = std::nextafter(6.173208178341159e-7, 1.0);
  sample.oil_flow_middle = -0.0;
  sample.rupture_position = -std::numeric_limits<double>::quiet_NaN();
  const auto lines = split(result_csv({sample}), '\n');
  ASSERT_EQ(lines.size(), 2u);
  const auto header = split(lines[0], ','), row = split(lines[1], ',');
  ASSERT_EQ(header.size(), row.size());
  EXPECT_EQ(row[0], "719");
  EXPECT_EQ(row[1], "-0.1");
  EXPECT_EQ(row[2], "2395369.6737");
  EXPECT_EQ(row[16], "0") << header[16];
  EXPECT_EQ(std::strtod(row[4].c_str(), nullptr), sample.min_film_thickness);
  const auto column = std::find(header.begin(), header.end(), "rupture_position [m]") - header.begin();
  EXPECT_EQ(row.at(static_cast<std::size_t>(column)), "nan");
}

TEST(ResultCsv, ErrorsFollowAllCurvesAndOnlyWhereACurveCanHaveOne) {
  cycle::Sample sample;
  study::ErrorEstimate errors = study::no_estimate(1);
  errors.samples[0].total_friction = 0.25;
  const auto plain = split(split(result_csv({sample}), '\n')[0], ',');
  const auto lines = split(result_csv({sample}, errors), '\n');
  const auto header = split(lines[0], ','), row = split(lines[1], ',');
  ASSERT_GT(header.size(), plain.size());
  EXPECT_TRUE(std::equal(plain.begin(), plain.end(), header.begin()));
  const auto column = std::find(header.begin(), header.end(), "total_friction_error [N]") - header.begin();
  EXPECT_EQ(row.at(static_cast<std::size_t>(column)), "0.25");
  EXPECT_EQ(std::count(header.begin(), header.end(), "newton_iterations_error"), 0);
}

}  // namespace
}  // namespace ringfilm::io
