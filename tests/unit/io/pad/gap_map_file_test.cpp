#include "ringfilm/io/pad/gap_map_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netcdf.h>

#include <cmath>

#include "../case_example.hpp"
#include "ringfilm/io/pad/pad_file.hpp"

namespace ringfilm::io {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

GapFile map_of(const std::string& text) {
  const ScratchFolder folder;
  write_text(folder / "gap.csv", text);
  return read_gap({folder / "gap.csv", "gap.csv"}, Units());
}

std::string map_refusal(const std::string& text) {
  try {
    map_of(text);
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

const char* const kHead = "x [mm],y [cm],h [um]\n";

TEST(GapMapFile, ReadsAFullRectangleWhicheverCoordinateRunsFirst) {
  for (const char* rows : {"0,0,1\n5,0,2\n0,2,3\n5,2,4\n", "0,0,1\n0,2,3\n5,0,2\n5,2,4\n"}) {
    const GapFile gap = map_of(std::string(kHead) + rows);
    EXPECT_THAT(gap.x, ElementsAre(0, 5e-3)) << rows;
    EXPECT_THAT(gap.y, ElementsAre(0, 2e-2));
    EXPECT_THAT(gap.height, ElementsAre(1e-6, 2e-6, 3e-6, 4e-6));
  }
}

TEST(GapMapFile, KeepsStepsOfBothDirections) {
  const GapFile gap = map_of(
      "x [mm],y [mm],height [um]\n0,0,1\n1,0,2\n1,0,3\n2,0,4\n0,1,5\n1,1,6\n1,1,7\n2,1,8\n"
      "0,1,9\n1,1,10\n1,1,11\n2,1,12\n0,3,13\n1,3,14\n1,3,15\n2,3,16\n");
  EXPECT_THAT(gap.x, ElementsAre(0, 1e-3, 1e-3, 2e-3));
  EXPECT_THAT(gap.y, ElementsAre(0, 1e-3, 1e-3, 3e-3));
  EXPECT_DOUBLE_EQ(gap.height[9], 10e-6);
}

TEST(GapMapFile, RefusesWhatIsNoFullRectangle) {
  const std::string head = kHead;
  EXPECT_THAT(map_refusal(head + "0,0,1\n5,0,2\n0,2,3\n"),
              HasSubstr("gap.csv:4:3: the last y has 1 points, the first 2"));
  EXPECT_THAT(map_refusal(head + "0,0,1\n5,0,2\n0,2,3\n4,2,4\n"), HasSubstr("gap.csv:5:1: x = 4 mm is given here"));
  EXPECT_THAT(map_refusal(head + "0,0,1\n0,2,1\n5,0,2\n5,3,4\n"), HasSubstr("gap.csv:5:3: y = 30 mm is given here"));
  EXPECT_THAT(map_refusal(head + "0,0,1\n5,0,2\n"), HasSubstr("only one y"));
  EXPECT_THAT(map_refusal(head + "0,0,1\n0,2,2\n"), HasSubstr("only one x"));
  EXPECT_THAT(map_refusal("x [mm],y,h [um]\n0,0,1\n5,0,2\n"), HasSubstr("the column y has no unit"));
}

TEST(GapMapFile, TellsWhatIsWrongWithTheFirstLineOfItAlone) {
  const std::string head = kHead;
  EXPECT_THAT(map_refusal(head + "5,0,1\n0,0,2\n5,2,3\n0,2,4\n"), HasSubstr("gap.csv:3:1: x falls within the first y"));
  EXPECT_THAT(map_refusal(head + "0,2,1\n0,0,2\n5,2,3\n5,0,4\n"), HasSubstr("gap.csv:3:3: y falls within the first x"));
  EXPECT_THAT(map_refusal(head + "0,0,1\n3,0,2\n2,0,2\n5,0,2\n0,2,1\n2,2,2\n3,2,2\n5,2,2\n"),
              HasSubstr("gap.csv:4:1: x falls within the first y"));
  for (const char* first : {"0,0,1\n9,0,1\n", "0,0,1\n5,0,1\n", "5,0,1\n9,0,1\n"}) {
    EXPECT_THAT(map_refusal(head + first + "0,2,1\n5,2,1\n9,2,1\n0,3,1\n5,3,1\n9,3,1\n"),
                HasSubstr("the first y has no point at x = "))
        << first;
  }
  EXPECT_THAT(map_refusal(head + "0,0,1\n9,0,1\n0,2,1\n5,2,1\n9,2,1\n"), HasSubstr("gap.csv:3:1: the first y has no"));
}

TEST(GapMapFile, RefusesColumnsThatMakeNoMap) {
  EXPECT_THAT(map_refusal("x [mm],z [mm],h [um]\n0,0,1\n5,0,2\n0,2,3\n5,2,4\n"),
              HasSubstr("gap.csv:1:1: x runs to and fro as in a map, and there is no column y"));
  EXPECT_THAT(map_refusal("x [mm],x [mm],y [mm],h [um]\n0,0,0,1\n5,5,0,2\n0,0,2,3\n5,5,2,4\n"),
              HasSubstr("gap.csv:1:8: the file has two columns x"));
}

TEST(GapMapFile, RefusesAStepAtASide) {
  EXPECT_THAT(map_refusal(std::string(kHead) + "0,0,1\n0,0,2\n5,0,3\n0,2,1\n0,2,2\n5,2,3\n"),
              HasSubstr("gap.csv:3:1: a step at an end of the pad"));
  EXPECT_THAT(map_refusal(std::string(kHead) + "0,0,1\n5,0,2\n0,0,3\n5,0,4\n0,2,3\n5,2,4\n"),
              HasSubstr("gap.csv:4:3: a step at an end of the pad"));
}

TEST(GapMapFile, RefusesMorePlacesThanAreRead) {
  std::string text = kHead;
  for (const char* y : {"0", "1"}) {
    for (std::size_t i = 0; i <= kMaxGapPlaces; ++i) text += std::to_string(i) + "," + y + ",1\n";
  }
  EXPECT_THAT(map_refusal(text), HasSubstr("the map has 4097 places along x"));
}

TEST(GapMapFile, RefusesHeightsThatNoOilFilmHas) {
  // The default fill of NetCDF as a table would print it.
  EXPECT_THAT(map_refusal(std::string(kHead) + "0,0,1\n5,0,2\n0,2,3\n5,2,9.969e36\n"),
              HasSubstr("gap.csv:5:5: 9.969e+30 m is not the thickness of an oil film"));
  EXPECT_THAT(map_refusal(std::string(kHead) + "0,0,1\n5,0,-1.1e6\n0,2,3\n5,2,4\n"), HasSubstr("gap.csv:3:5: -1.1 m"));
  EXPECT_EQ(map_refusal(std::string(kHead) + "0,0,1\n5,0,1e6\n0,2,3\n5,2,4\n"), "");  // a metre is allowed
}

struct Netcdf {
  std::vector<double> x = {0, 2, 6}, y = {0, 0.5};
  std::vector<double> height = {1, 2, 3, 4, 5, 6};
  nc_type type = NC_DOUBLE;
  std::size_t n_written = 6;  ///< of the heights; the others are left to the library
  int kind = NC_NETCDF4;
  bool x_first = false;  ///< h(x, y)
  std::string name = "height", unit = "um";
  std::vector<std::pair<std::string, double>> attributes = {};  ///< of the heights
};

/// A file with h(y, x), as most programs write it.
void write_netcdf(const std::string& path, const Netcdf& map = {}) {
  int file = 0, dimensions[2], variable = 0;
  ASSERT_EQ(nc_create(path.c_str(), map.kind, &file), NC_NOERR);
  nc_def_dim(file, "y", map.y.size(), &dimensions[0]);
  nc_def_dim(file, "x", map.x.size(), &dimensions[1]);
  int x = 0, y = 0;
  const auto define = [&](const char* name, nc_type type, int n, const int* of, const char* unit, int* number) {
    ASSERT_EQ(nc_def_var(file, name, type, n, of, number), NC_NOERR);
    if (*unit != '\0') nc_put_att_text(file, *number, "units", std::string(unit).size(), unit);
  };
  define("x", NC_DOUBLE, 1, &dimensions[1], "mm", &x);
  define("y", NC_DOUBLE, 1, &dimensions[0], "m", &y);
  const int turned[] = {dimensions[1], dimensions[0]};
  define(map.name.c_str(), map.type, 2, map.x_first ? turned : dimensions, map.unit.c_str(), &variable);
  for (const auto& [name, value] : map.attributes) {
    ASSERT_EQ(nc_put_att_double(file, variable, name.c_str(), map.type, 1, &value), NC_NOERR);
  }
  ASSERT_EQ(nc_enddef(file), NC_NOERR);
  ASSERT_EQ(nc_put_var_double(file, x, map.x.data()), NC_NOERR);
  ASSERT_EQ(nc_put_var_double(file, y, map.y.data()), NC_NOERR);
  for (std::size_t k = 0; k < map.n_written; ++k) {
    const std::size_t n = map.x_first ? map.y.size() : map.x.size(), at[] = {k / n, k % n};
    ASSERT_EQ(nc_put_var1_double(file, variable, at, &map.height[k]), NC_NOERR);
  }
  nc_close(file);
}

std::string netcdf_refusal(const Netcdf& map) {
  const ScratchFolder folder;
  write_netcdf(folder / "gap.nc", map);
  try {
    read_gap({folder / "gap.nc", "gap.nc"}, Units());
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
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

TEST(GapMapFile, ReadsUnitsThatAreStoredAsAString) {
  const ScratchFolder folder;
  const std::string path = folder / "gap.nc";
  write_netcdf(path);
  int file = 0, variable = 0;
  ASSERT_EQ(nc_open(path.c_str(), NC_WRITE, &file), NC_NOERR);
  nc_inq_varid(file, "height", &variable);
  nc_del_att(file, variable, "units");
  const char* unit = "\u00b5m";
  ASSERT_EQ(nc_put_att_string(file, variable, "units", 1, &unit), NC_NOERR);
  nc_close(file);
  EXPECT_THAT(read_gap({path, "gap.nc"}, Units()).height, ElementsAre(1e-6, 2e-6, 3e-6, 4e-6, 5e-6, 6e-6));
}

// NetCDF leaves what is never written at the default fill of its type, without an attribute that states it.
TEST(GapMapFile, PointsOfNetcdfThatWereNeverWrittenAreHoles) {
  for (const nc_type type : {NC_DOUBLE, NC_FLOAT, NC_INT, NC_SHORT}) {
    Netcdf map;
    map.type = type;
    EXPECT_EQ(netcdf_refusal(map), "") << type;
    map.n_written = 4;
    EXPECT_THAT(netcdf_refusal(map), HasSubstr("the map has a hole at x = 2 mm, y = 500 mm")) << type;
  }
}

// The library ends in a segmentation fault on some damaged files of the classic formats.
TEST(GapMapFile, RefusesClassicNetcdfWithTheCommandThatConvertsIt) {
  for (const int kind : {NC_CLASSIC_MODEL, NC_64BIT_OFFSET, NC_64BIT_DATA}) {
    Netcdf map;
    map.kind = kind;
    EXPECT_THAT(netcdf_refusal(map),
                AllOf(HasSubstr("gap.nc: is a NetCDF file of a classic format; only NetCDF-4 is read"),
                      HasSubstr("convert it: nccopy -k nc4 gap.nc gap-nc4.nc")))
        << kind;
  }
}

TEST(GapMapFile, RefusesHeightsInNetcdfThatNoOilFilmHas) {
  Netcdf map;
  map.height[5] = -1e20;  // a hole of some program, in um
  EXPECT_THAT(netcdf_refusal(map), HasSubstr("at x = 6 mm, y = 500 mm: -1e+14 m is not the thickness of an oil film"));
}

TEST(GapMapFile, RefusesHolesOfNetcdf) {
  Netcdf nan;
  nan.height[3] = std::nan("");
  EXPECT_THAT(netcdf_refusal(nan), HasSubstr("a hole at x = 0 mm, y = 500 mm"));
  for (const char* attribute : {"_FillValue", "missing_value"}) {
    Netcdf marked;
    marked.attributes = {{attribute, -99}};
    EXPECT_EQ(netcdf_refusal(marked), "");
    marked.height[5] = -99;
    EXPECT_THAT(netcdf_refusal(marked), HasSubstr("a hole at x = 6 mm, y = 500 mm")) << attribute;
  }
}

TEST(GapMapFile, RefusesNetcdfThatIsNoMap) {
  Netcdf turned, bare, mass, packed, other;
  turned.x_first = true;
  EXPECT_THAT(netcdf_refusal(turned),
              AllOf(HasSubstr("height does not run over (y, x)"), HasSubstr("a row of all x for each y")));
  bare.unit = "";
  EXPECT_THAT(netcdf_refusal(bare), AllOf(HasSubstr("the variable height has no units"), HasSubstr("for example")));
  mass.unit = "kg";
  EXPECT_THAT(netcdf_refusal(mass), AllOf(HasSubstr("the variable height"), HasSubstr("length")));
  packed.attributes = {{"scale_factor", 2}};
  EXPECT_THAT(netcdf_refusal(packed), HasSubstr("packed with scale_factor"));
  other.name = "g";
  EXPECT_THAT(netcdf_refusal(other), HasSubstr("no variable h"));
}

TEST(GapMapFile, TellsAxesOfNetcdfByTheirIndex) {
  Netcdf falls;
  falls.x = {0, 6, 2};
  EXPECT_THAT(netcdf_refusal(falls), HasSubstr("gap.nc: x[2] = 2 mm lies below x[1] = 6 mm"));
  EXPECT_THAT(netcdf_refusal(falls), Not(HasSubstr("row before")));
  Netcdf step;
  step.x = {0, 2, 2};
  EXPECT_THAT(netcdf_refusal(step), HasSubstr("x[2] = 2 mm is a step at an end of the pad"));
  Netcdf thrice;
  thrice.x = {0, 2, 2, 2, 6};
  thrice.height = {1, 2, 3, 4, 5, 1, 2, 3, 4, 5};
  thrice.n_written = 10;
  EXPECT_THAT(netcdf_refusal(thrice), HasSubstr("x[3] = 2 mm comes three times"));
}

}  // namespace
}  // namespace ringfilm::io
