#include "ringfilm/io/gap_map_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netcdf.h>

#include "case_example.hpp"
#include "ringfilm/io/pad_file.hpp"

namespace ringfilm::io {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

GapFile gap_of(const std::string& text) {
  const ScratchFolder folder;
  write_text(folder / "gap.csv", text);
  return read_gap({folder / "gap.csv", "gap.csv"}, Units());
}

std::string refusal(const std::string& text) {
  try {
    gap_of(text);
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

const char* const kHead = "x [mm],y [cm],h [um]\n";

TEST(GapMapFile, ReadsAFullRectangleWhicheverCoordinateRunsFirst) {
  for (const char* rows : {"0,0,1\n5,0,2\n0,2,3\n5,2,4\n", "0,0,1\n0,2,3\n5,0,2\n5,2,4\n"}) {
    const GapFile gap = gap_of(std::string(kHead) + rows);
    EXPECT_THAT(gap.x, ElementsAre(0, 5e-3)) << rows;
    EXPECT_THAT(gap.y, ElementsAre(0, 2e-2));
    EXPECT_THAT(gap.height, ElementsAre(1e-6, 2e-6, 3e-6, 4e-6));
  }
}

TEST(GapMapFile, KeepsStepsOfBothDirections) {
  const GapFile gap = gap_of(
      "x [mm],y [mm],height [um]\n0,0,1\n1,0,2\n1,0,3\n2,0,4\n0,1,5\n1,1,6\n1,1,7\n2,1,8\n"
      "0,1,9\n1,1,10\n1,1,11\n2,1,12\n0,3,13\n1,3,14\n1,3,15\n2,3,16\n");
  EXPECT_THAT(gap.x, ElementsAre(0, 1e-3, 1e-3, 2e-3));
  EXPECT_THAT(gap.y, ElementsAre(0, 1e-3, 1e-3, 3e-3));
  EXPECT_DOUBLE_EQ(gap.height[9], 10e-6);
}

TEST(GapMapFile, RefusesWhatIsNoFullRectangle) {
  const std::string head = kHead;
  EXPECT_THAT(refusal(head + "0,0,1\n5,0,2\n0,2,3\n"), HasSubstr("gap.csv:4:3: the last y has 1 points, the first 2"));
  EXPECT_THAT(refusal(head + "0,0,1\n5,0,2\n0,2,3\n4,2,4\n"), HasSubstr("gap.csv:5:1: x = 4 mm stands here"));
  EXPECT_THAT(refusal(head + "0,0,1\n0,2,1\n5,0,2\n5,3,4\n"), HasSubstr("gap.csv:5:3: y = 30 mm stands here"));
  EXPECT_THAT(refusal(head + "0,0,1\n5,0,2\n"), HasSubstr("only one y"));
  EXPECT_THAT(refusal(head + "0,0,1\n0,2,2\n"), HasSubstr("only one x"));
  EXPECT_THAT(refusal("x [mm],y,h [um]\n0,0,1\n5,0,2\n"), HasSubstr("the column y has no unit"));
}

TEST(GapMapFile, RefusesAStepAtASide) {
  EXPECT_THAT(refusal(std::string(kHead) + "0,0,1\n5,0,2\n0,0,3\n5,0,4\n0,2,3\n5,2,4\n"),
              HasSubstr("gap.csv:4:3: a step at an end of the pad"));
}

TEST(GapMapFile, RefusesMorePlacesThanAreRead) {
  std::string text = kHead;
  for (const char* y : {"0", "1"}) {
    for (std::size_t i = 0; i <= kMostGapPlaces; ++i) text += std::to_string(i) + "," + y + ",1\n";
  }
  EXPECT_THAT(refusal(text), HasSubstr("the map has 4097 places along x"));
}

/// A file of NetCDF-4 with h(y, x), as most programs write it.
void write_netcdf(const std::string& path) {
  int file = 0, dimensions[2], variable = 0;
  ASSERT_EQ(nc_create(path.c_str(), NC_NETCDF4, &file), NC_NOERR);
  nc_def_dim(file, "y", 2, &dimensions[0]);
  nc_def_dim(file, "x", 3, &dimensions[1]);
  const auto put = [&](const char* name, int n, const int* of, const char* unit, const std::vector<double>& values) {
    nc_def_var(file, name, NC_DOUBLE, n, of, &variable);
    nc_put_att_text(file, variable, "units", std::string(unit).size(), unit);
    ASSERT_EQ(nc_put_var_double(file, variable, values.data()), NC_NOERR);
  };
  put("x", 1, &dimensions[1], "mm", {0, 2, 6});
  put("y", 1, &dimensions[0], "m", {0, 0.5});
  put("height", 2, dimensions, "um", {1, 2, 3, 4, 5, 6});
  nc_close(file);
}

TEST(GapMapFile, ReadsNetcdf) {
  const ScratchFolder folder;
  write_netcdf(folder / "gap.nc");
  const GapFile gap = read_gap({folder / "gap.nc", "gap.nc"}, Units());
  EXPECT_THAT(gap.x, ElementsAre(0, 2e-3, 6e-3));
  EXPECT_THAT(gap.y, ElementsAre(0, 0.5));
  EXPECT_THAT(gap.height, ElementsAre(1e-6, 2e-6, 3e-6, 4e-6, 5e-6, 6e-6));
  EXPECT_EQ(gap.sha256.size(), 64u);
}

}  // namespace
}  // namespace ringfilm::io
