#include "ringfilm/io/study/study_curves.hpp"

#include <gtest/gtest.h>
#include <netcdf.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <set>

#include "../case_example.hpp"
#include "ringfilm/io/study/study_netcdf.hpp"

namespace ringfilm::io {
namespace {

/// Eight points of two bases; the curve of point p at angle k is the (3 p mod 8)-th of the numbers 1 + k ... 8 + k, of
/// the second base 100 more; its last point is not solved.
class StudyCurves : public ::testing::Test {
 protected:
  static constexpr std::size_t kAngles = 5;

  StudyFile study(const std::string& curves) {
    folder_.write("case.toml", CaseText{}.text());
    folder_.write("p.csv", full_trace());
    return read_study(folder_.write(
        "study.toml",
        "[[base]]\nname = \"a\"\ncase = \"case.toml\"\n[[base]]\nname = \"b\"\ncase = \"case.toml\"\n[[factor]]\n"
        "key = \"operating.speed\"\nrange = [\"1000 rpm\", \"2000 rpm\"]\n[plan]\nmethod = \"sobol\"\nscenarios = 8\n"
        "[keep]\ncurves = \"" +
            curves + "\"\nquantities = [\"power_loss\"]\ncrank_step = \"144 degree\"\n"));
  }

  static study::ScenarioRow row(std::uint64_t i) {
    const std::size_t base = i % 2, p = i / 2;
    const std::size_t n_values = cycle::cycle_quantities().size();
    if (i == 15) {
      return {std::vector<double>(n_values, std::numeric_limits<double>::quiet_NaN()), "no film",
              std::vector<float>(kAngles, std::numeric_limits<float>::quiet_NaN())};
    }
    study::ScenarioRow row{std::vector<double>(n_values, static_cast<double>(i)), "", {}};
    for (std::size_t k = 0; k < kAngles; ++k) row.curves.push_back(static_cast<float>(1 + 3 * p % 8 + k + 100 * base));
    return row;
  }

  /// The rows in files that end before these scenarios.
  std::vector<ShardReader> shards(const StudyFile& file, const std::vector<std::uint64_t>& ends) {
    std::vector<ShardReader> all;
    std::uint64_t next = 0;
    for (const std::uint64_t end : ends) {
      const std::string path = folder_ / ("rows" + std::to_string(end) + "of" + std::to_string(ends.size()));
      std::filesystem::remove(path);
      ShardWriter writer(path, {"plan", "inputs", "program", 1, 1, next, end, cycle::cycle_quantities().size(),
                                file.study.keep.quantities, kAngles});
      for (; next < end; ++next) writer.append({next, {row(next)}});
      all.emplace_back(path);
    }
    return all;
  }

  static std::string bytes_of(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  ScratchFolder folder_;
};

TEST_F(StudyCurves, BandsAreQuantilesOverTheScenariosOfEachBase) {
  const StudyFile file = study("quantiles");
  const study::Plan plan(file.study);
  const StudyRows rows{file, plan, shards(file, {6, 16})};
  const std::vector<CurveBand> bands = curve_bands(rows);
  ASSERT_EQ(bands.size(), 2u);
  EXPECT_EQ(bands[0].quantity.name, "power_loss");
  EXPECT_EQ(bands[0].shares, (std::vector<double>{0.05, 0.25, 0.5, 0.75, 0.95}));
  // Of 1 ... 8 the quantile q is q (8 + 1/3) + 1/3, no less than 1 and no more than 8 (hyndman1996, definition 8).
  const double of_eight[] = {1, 0.25 * (8 + 1.0 / 3) + 1.0 / 3, 4.5, 0.75 * (8 + 1.0 / 3) + 1.0 / 3, 8};
  for (std::size_t s = 0; s < 5; ++s) {
    ASSERT_EQ(bands[0].values[s].size(), kAngles);
    for (std::size_t k = 0; k < kAngles; ++k)
      EXPECT_NEAR(bands[0].values[s][k], of_eight[s] + static_cast<double>(k), 1e-12);  // rounding
  }
  // Point 7, which is not solved, would be 3 * 7 mod 8 = 5, the number 106: 101 ... 105, 107, 108 are left.
  EXPECT_EQ(bands[1].base, 1u);
  EXPECT_EQ(bands[1].values[2][0], 104);
  EXPECT_EQ(bands[1].values[4][0], 108);
}

TEST_F(StudyCurves, NoneAreReportedWhereNoneAreKept) {
  const StudyFile file = study("none");
  const study::Plan plan(file.study);
  EXPECT_TRUE(curve_bands(StudyRows{file, plan, {}}).empty());
}

TEST_F(StudyCurves, ResultHasTheSameBytesHoweverItsRowsWereSplit) {
  for (const char* kind : {"all", "quantiles"}) {
    const StudyFile file = study(kind);
    const study::Plan plan(file.study);
    std::set<std::string> found;
    for (const std::vector<std::uint64_t>& ends : {std::vector<std::uint64_t>{16}, {1, 9, 16}, {8, 16}}) {
      const StudyRows rows{file, plan, shards(file, ends)};
      const std::string path = folder_ / "study.nc";
      write_study_result(path, rows);
      found.insert(bytes_of(path));
    }
    EXPECT_EQ(found.size(), 1u) << kind;
  }
}

TEST_F(StudyCurves, ResultHasEveryCurveOverScenarioCrankAngleAndRing) {
  const StudyFile file = study("all");
  const study::Plan plan(file.study);
  write_study_result(folder_ / "study.nc", StudyRows{file, plan, shards(file, {16})});
  int nc = 0, variable = 0, n_dimensions = 0, dimensions[NC_MAX_VAR_DIMS] = {};
  ASSERT_EQ(nc_open((folder_ / "study.nc").c_str(), NC_NOWRITE, &nc), NC_NOERR);
  ASSERT_EQ(nc_inq_varid(nc, "curve_power_loss", &variable), NC_NOERR);
  nc_inq_varndims(nc, variable, &n_dimensions);
  nc_inq_vardimid(nc, variable, dimensions);
  ASSERT_EQ(n_dimensions, 3);
  const char* names[] = {"scenario", "crank_angle", "ring"};
  const std::size_t lengths[] = {16, kAngles, 1};
  for (int d = 0; d < 3; ++d) {
    char name[NC_MAX_NAME + 1] = {};
    std::size_t length = 0;
    nc_inq_dim(nc, dimensions[d], name, &length);
    EXPECT_STREQ(name, names[d]);
    EXPECT_EQ(length, lengths[d]);
  }
  std::vector<float> curves(16 * kAngles);
  nc_get_var_float(nc, variable, curves.data());
  for (std::uint64_t i = 0; i < 15; ++i) {
    for (std::size_t k = 0; k < kAngles; ++k) EXPECT_EQ(curves[i * kAngles + k], row(i).curves[k]);
  }
  EXPECT_TRUE(std::isnan(curves.back()));
  ASSERT_EQ(nc_inq_varid(nc, "crank_angle", &variable), NC_NOERR);
  double angles[kAngles] = {};
  nc_get_var_double(nc, variable, angles);
  EXPECT_EQ(angles[0], -288);
  EXPECT_EQ(angles[4], 288);
  nc_close(nc);
}

}  // namespace
}  // namespace ringfilm::io
