#include "ringfilm/instrument/grid/height_checks.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "ringfilm/base/number_text.hpp"
#include "synthetic_surfaces.hpp"
#include "written_files.hpp"

namespace ringfilm::instrument {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

const HeightUnit kUm{"um", 1e-6};

/// 64 x 48 points of Sq 0.3 um in steps of 1 um.
surface::HeightMap map_of_surface() { return rough("a", 0.3e-6, 5).map; }

/// One line a doubt, refusals with a mark in front.
std::vector<std::string> doubts(const surface::HeightMap& map) {
  std::vector<std::string> lines;
  for (const Doubt& doubt : height_doubts(map, kUm)) {
    EXPECT_NE(doubt.remedy, "") << doubt.message;
    lines.push_back((doubt.weight == Doubt::Weight::kRefusal   ? "refused: "
                     : doubt.weight == Doubt::Weight::kMissing ? "missing: "
                                                               : "") +
                    doubt.message);
  }
  return lines;
}

surface::HeightMap scaled(surface::HeightMap map, double factor) {
  for (double& height : map.height_m) height *= factor;
  return map;
}

/// The map with another column in front.
template <class Value>
surface::HeightMap with_first_column(const surface::HeightMap& map, const Value& value) {
  surface::HeightMap wider = map;
  ++wider.points_x;
  wider.height_m.clear();
  for (std::size_t j = 0; j < map.points_y; ++j) {
    wider.height_m.push_back(value(j));
    for (std::size_t i = 0; i < map.points_x; ++i) wider.height_m.push_back(map.height_m[map.index(i, j)]);
  }
  return wider;
}

TEST(HeightChecks, SurfacesOfEveryKindPass) {
  EXPECT_THAT(doubts(map_of_surface()), IsEmpty());
  surface::HeightMap honed = map_of_surface();  // a plateau of 30 nm with grooves of 3 um in a tenth of the columns
  for (std::size_t i = 0; i < honed.points(); ++i) {
    honed.height_m[i] *= 0.1;
    const double across = static_cast<double>(i % honed.points_x % 10) - 5;
    if (across > 0) honed.height_m[i] -= 3e-6 * std::exp(-across);
  }
  EXPECT_THAT(doubts(honed), IsEmpty());
  surface::HeightMap etched = map_of_surface();  // two levels, 20 Sq apart, and one column in between
  for (std::size_t i = 0; i < etched.points(); ++i) {
    if (i % etched.points_x > 40) etched.height_m[i] -= 6e-6;
  }
  EXPECT_THAT(doubts(etched), IsEmpty());
  surface::HeightMap tilted = map_of_surface();
  for (std::size_t i = 0; i < tilted.points(); ++i) tilted.height_m[i] += 0.1e-6 * static_cast<double>(i % 64);
  EXPECT_THAT(doubts(tilted), IsEmpty());
  surface::HeightMap plane = tilted;  // all rows are even sequences: the surface is, and no edge is odd
  for (std::size_t i = 0; i < plane.points(); ++i) plane.height_m[i] = 0.1e-6 * static_cast<double>(i % 64);
  EXPECT_THAT(doubts(plane), IsEmpty());
  surface::HeightMap grooved = tilted;  // turned: the same in each row
  for (std::size_t i = 0; i < grooved.points(); ++i) grooved.height_m[i] = grooved.height_m[i % 64];
  EXPECT_THAT(doubts(grooved), IsEmpty());
}

TEST(HeightChecks, AnEdgeThatCountsIsRefused) {
  const surface::HeightMap map = map_of_surface();
  const auto counts = [&](double from, double step) {
    return doubts(with_first_column(map, [&](std::size_t j) { return (from + step * static_cast<double>(j)) * 1e-6; }));
  };
  EXPECT_THAT(counts(0, 1),
              ElementsAre("refused: column 1 goes in even steps from 0 um to 47 um: its values are numbers "
                          "or places, not heights"));
  EXPECT_THAT(counts(1, 1), ElementsAre(HasSubstr("refused: column 1 goes in even steps from 1 um to 48 um")));
  EXPECT_THAT(counts(48, -1), ElementsAre(HasSubstr("refused: column 1 goes in even steps from 48 um to 1 um")));
  EXPECT_THAT(counts(-10, 0.25), ElementsAre(HasSubstr("column 1 goes in even steps from -10 um to 1.75 um")));
  // Places with one digit: steps of 0.83 become 0.8 and 0.9.
  EXPECT_THAT(doubts(with_first_column(
                  map, [](std::size_t j) { return std::round(8.3 * static_cast<double>(j)) / 10 * 1e-6; })),
              ElementsAre(HasSubstr("refused: column 1 goes in even steps from 0 um to 39 um")));
}

TEST(HeightChecks, AxesAlongBothEdgesWithAnythingInTheirCorner) {
  surface::HeightMap map =
      with_first_column(map_of_surface(), [](std::size_t j) { return 0.5e-6 * (static_cast<double>(j) - 1); });
  for (std::size_t i = 1; i < map.points_x; ++i) map.height_m[i] = 0.5e-6 * static_cast<double>(i - 1);
  map.height_m[0] = 48e-6;
  EXPECT_THAT(doubts(map),
              ElementsAre(HasSubstr("row 1 goes in even steps"), HasSubstr("column 1 goes in even steps")));
  map.missing.assign(map.points(), 0);
  map.missing[0] = 1;
  EXPECT_THAT(doubts(map),
              ElementsAre(HasSubstr("row 1 goes in even steps"), HasSubstr("column 1 goes in even steps")));
}

TEST(HeightChecks, ALineOfOneValueIsNotedWithItsNumberAndValue) {
  surface::HeightMap map = map_of_surface();
  const auto fill_row = [&map](std::size_t row, double value) {
    for (std::size_t i = 0; i < map.points_x; ++i) map.height_m[map.index(i, row)] = value;
  };
  fill_row(47, -0.8e-6);
  EXPECT_THAT(doubts(map), ElementsAre("row 48 holds one value throughout, -0.8 um"));
  for (std::size_t row = 12; row < 47; ++row) fill_row(row, -0.8e-6);  // a scan that was broken off
  EXPECT_THAT(doubts(map), ElementsAre("36 rows hold one value throughout, the first of them row 13: -0.8 um"));
  fill_row(47, -0.08);  // with 80 mm nothing can be computed: not a measured row
  for (std::size_t row = 12; row < 47; ++row) fill_row(row, -0.08);
  EXPECT_THAT(doubts(map), ElementsAre(AllOf(HasSubstr("missing: 36 rows hold one value throughout"),
                                             HasSubstr("these points were taken as missing"))));
}

TEST(HeightChecks, AValueFarFromAllOthersIsNamedWithItsPlace) {
  surface::HeightMap map = map_of_surface();
  const auto at = [&map](std::size_t column, std::size_t row) -> double& {
    return map.height_m[map.index(column - 1, row - 1)];
  };
  at(7, 3) = 8e-6;
  EXPECT_THAT(doubts(map), ElementsAre(AllOf(HasSubstr("1 height lies far from the rest, for example 8 um in row 3, "
                                                       "column 7"),
                                             HasSubstr("the rest lies between"))));
  at(20, 30) = at(21, 30) = 8e-6;
  EXPECT_THAT(doubts(map), ElementsAre(HasSubstr("3 points far from the rest repeat one value, 8 um, the first of them "
                                                 "row 3, column 7")));
  // So far that nothing can be computed with them: a value that repeats marks missing points.
  at(7, 3) = at(20, 30) = at(21, 30) = -9999e-6;
  EXPECT_THAT(doubts(map),
              ElementsAre(AllOf(HasSubstr("missing: 3 points far from the rest repeat one value, -9999 um"),
                                HasSubstr("these points were taken as missing"))));
  EXPECT_THAT(height_doubts(map, {"um", 1e-6}).front().points,
              ElementsAre(map.index(6, 2), map.index(19, 29), map.index(20, 29)));
  for (std::size_t i = 0; i < map.points(); i += 3) map.height_m[i] = -9999e-6;
  EXPECT_THAT(doubts(map), ElementsAre(HasSubstr("missing: 1026 points far from the rest")));
  // A single height does not: the map is refused.
  at(1, 1) = 9999e-6;
  EXPECT_THAT(doubts(map), ElementsAre(HasSubstr("refused: "), HasSubstr("refused: 1 height lies far from the rest")));
}

TEST(HeightChecks, AValueAmongTheOthersThatIsMuchMoreFrequent) {
  surface::HeightMap coarse = map_of_surface();  // an instrument with a coarse digit
  for (double& height : coarse.height_m) height = std::round(height / 5e-9) * 5e-9;
  EXPECT_THAT(doubts(coarse), IsEmpty());
  for (surface::HeightMap map : {map_of_surface(), coarse}) {
    for (std::size_t i = 5; i < map.points(); i += 50) map.height_m[i] = 0;
    EXPECT_THAT(doubts(map), ElementsAre(HasSubstr("% of the heights are 0 um, the first of them row 1, column 6")));
  }
  surface::HeightMap few = map_of_surface();
  for (std::size_t i = 5; i < few.points(); i += 100) few.height_m[i] = 0;
  EXPECT_THAT(doubts(few), ElementsAre(HasSubstr("1 % of the heights are 0 um")));
}

TEST(HeightChecks, ARangeThatEndedOnOneSideOrOnBoth) {
  surface::HeightMap map = map_of_surface();
  for (double& height : map.height_m) height = std::min(height, 0.6e-6);
  EXPECT_THAT(doubts(map), ElementsAre(HasSubstr("% of the heights are 0.6 um, the highest value")));
  for (double& height : map.height_m) height = std::max(height, -0.6e-6);
  EXPECT_THAT(doubts(map), ElementsAre(HasSubstr("the lowest value"), HasSubstr("the highest value")));
}

TEST(HeightChecks, LinesThatWereWrittenTwice) {
  surface::HeightMap map = map_of_surface();
  const auto copy_row = [&map](std::size_t j) {
    for (std::size_t i = 0; i < map.points_x; ++i) map.height_m[map.index(i, j)] = map.height_m[map.index(i, j - 1)];
  };
  copy_row(20);
  EXPECT_THAT(doubts(map), ElementsAre("row 21 repeats the one before it, point for point"));
  copy_row(30);
  EXPECT_THAT(doubts(map), ElementsAre("row 21 repeats the one before it, point for point, and so do 1 more"));
  for (std::size_t j = 1; j < map.points_y; j += 2) copy_row(j);  // interpolated to the nearest row
  EXPECT_THAT(doubts(map), IsEmpty());
}

TEST(HeightChecks, LinesThatWereNotMeasuredAreNoneThatWereWrittenTwice) {
  surface::HeightMap map = map_of_surface();
  for (std::size_t j = 0; j < 3; ++j) {
    for (std::size_t i = 0; i < map.points_x; ++i) {
      map.height_m[map.index(i, j)] = std::numeric_limits<double>::quiet_NaN();
    }
  }
  EXPECT_THAT(doubts(map), Not(Contains(HasSubstr("repeats"))));
}

TEST(HeightChecks, SlopesAndHeightsBeyondThoseOfSurfaces) {
  const surface::HeightMap map = map_of_surface();
  EXPECT_THAT(doubts(scaled(map, 30)), ElementsAre(HasSubstr("the rms slope is ")));
  EXPECT_THAT(doubts(scaled(map, 1e6)), ElementsAre(AllOf(HasSubstr("the rms slope is "), Not(HasSubstr("refused")))));
  surface::HeightMap waves = map;  // 40 um high waves of 2 mm length, in a map of 4 mm
  waves.step_x_m = waves.step_y_m = 64e-6;
  for (std::size_t i = 0; i < waves.points(); ++i)
    waves.height_m[i] = 0.8e-3 * std::sin(0.2 * static_cast<double>(i % 64));
  EXPECT_THAT(doubts(waves), ElementsAre(HasSubstr("more than 0.1 of the length of 4.096 mm")));
}

TEST(HeightChecks, HeightsBelowAnAtom) {
  const surface::HeightMap map = map_of_surface();
  EXPECT_THAT(doubts(scaled(map, 1e-4)), ElementsAre(HasSubstr("below the size of an atom")));
  EXPECT_THAT(doubts(scaled(map, 1e-6)), ElementsAre(HasSubstr("refused: Sq is 0.0002")));
  EXPECT_THAT(doubts(scaled(map, 0)), ElementsAre("all heights are equal"));
  EXPECT_THAT(doubts(scaled(map, 1e-3)), IsEmpty());  // Sq 0.3 nm: a wafer
}

TEST(HeightChecks, ALengthInFrontOfAProfile) {
  surface::HeightMap profile = rough("a", 0.3e-6, 5, {401, 1, 2.5e-6, 2.5e-6}).map;
  profile.points_y = 1;
  EXPECT_THAT(doubts(profile), IsEmpty());
  surface::HeightMap places = profile;
  for (std::size_t i = 0; i < places.points(); ++i) places.height_m[i] = 1e-9 * static_cast<double>(i);
  EXPECT_THAT(doubts(places), ElementsAre("all heights go in even steps from 0 um to 0.4 um, as numbers or places do"));
  profile.height_m[0] = 1e-6;  // 400 steps of 2.5 um are 1 mm
  EXPECT_THAT(doubts(profile), ElementsAre(HasSubstr("the first value, 1, is the length of the profile in mm")));
}

TEST(HeightChecks, LeadingValuesThatCountTheOthers) {
  const auto counted = [](std::vector<double> head) {
    for (int i = 0; i < 40; ++i) head.push_back(0.4 * std::sin(i));
    std::string lines;
    for (const Doubt& doubt : count_doubts(head)) {
      lines += (doubt.weight == Doubt::Weight::kRefusal ? "refused: " : "") + doubt.message;
    }
    return lines;
  };
  EXPECT_EQ(counted({}), "");
  EXPECT_EQ(counted({0.1, 33}), "");
  EXPECT_EQ(counted({40}), "refused: the first value, 40, is the number of the values behind it");
  EXPECT_EQ(counted({10, 40}), "refused: the first 2 values, 10, 40, state the number of the values behind them, 40");
  EXPECT_THAT(counted({8, 5}), HasSubstr("the first 2 values, 8, 5"));  // a map in one column: # alone makes a profile
  std::vector<double> map = {8, 5};
  for (int i = 0; i < 40; ++i) map.push_back(0.4 * std::sin(i));
  EXPECT_THAT(count_doubts(map).at(0).remedy, HasSubstr("a map of 8 x 5 points, write a row of the map a line"));
  EXPECT_THAT(counted({8, 5, 1}), HasSubstr("the first 3 values"));
}

TEST(HeightChecks, AFileIsReadWithItsDoubtsOrRefused) {
  std::string text;
  for (int j = 0; j < 12; ++j) {
    for (int i = 0; i < 10; ++i)
      text += number_text(std::sin(3.7 * i * i + 1.3 * j * j + i * j)) + (i < 9 ? "," : "\n");
  }
  SurfaceOptions options;
  options.height_unit = "um";
  options.step_x = "5 um";
  EXPECT_THAT(read_bytes("a.csv", text, options).origin.doubts, IsEmpty());
  const std::string spike = "9" + text;  // the first height becomes 9...
  EXPECT_THAT(read_bytes("a.csv", spike, options).origin.doubts,
              ElementsAre(AllOf(HasSubstr("in row 1, column 1"), HasSubstr("write nan"))));
  options.height_unit = "pm";
  const std::string words = refusal("a.csv", spike, options);
  EXPECT_THAT(words, AllOf(HasSubstr("below the size of an atom"), HasSubstr("state the right one")));
}

TEST(HeightChecks, ARowThatWasNotMeasuredIsMissingInTheMapThatIsRead) {
  std::string text;
  for (int j = 0; j < 12; ++j) {
    for (int i = 0; i < 10; ++i) {
      text += number_text(j == 11 ? -8000.0 : std::sin(3.7 * i * i + 1.3 * j * j + i * j)) + (i < 9 ? "," : "\n");
    }
  }
  SurfaceOptions options;
  options.height_unit = "um";
  options.step_x = "5 um";
  const SurfaceFile file = read_bytes("a.csv", text, options);
  EXPECT_THAT(file.origin.doubts, ElementsAre(HasSubstr("row 12 holds one value throughout, -8000 um")));
  for (std::size_t i = 0; i < 120; ++i) EXPECT_EQ(file.map.measured(i), i < 110) << i;
  EXPECT_THAT(file.plausibility_line, HasSubstr("8.33 % missing"));  // 10 of 120 points
}

TEST(HeightChecks, WhatTheUserStatesAgainstTheFileIsADoubt) {
  const std::string header = "# Width: 40 um\n# Height: 40 um\n# Value units: nm\n";
  std::string rows;
  for (int i = 0; i < 16; ++i) rows += number_text(100 * std::sin(i * i)) + (i % 4 == 3 ? "\n" : " ");
  SurfaceOptions options;
  EXPECT_THAT(read_bytes("a.txt", header + rows).origin.doubts, IsEmpty());
  options.height_unit = "nm";
  options.step_x = "10 um";
  EXPECT_THAT(read_bytes("a.txt", header + rows, options).origin.doubts, IsEmpty());
  options.height_unit = "pm";
  options.step_x = "20 um";
  EXPECT_THAT(read_bytes("a.txt", header + rows, options).origin.doubts,
              ElementsAre(HasSubstr("the file states the heights in nm, and pm is used in its place"),
                          HasSubstr("the file states a step along x of 10 um, and 20 um is used"),
                          HasSubstr("the file states a step along y of 10 um, and 20 um is used")));
  // Numbers of points that are taken as places.
  SurfaceOptions lateral;
  lateral.lateral_unit = "um";
  EXPECT_THAT(read_bytes("a.csv", "x,z [um]\n0,1\n1,2\n2,1\n3,2\n", lateral).origin.doubts,
              ElementsAre(HasSubstr("x counts 0, 1, 2 ... and was taken as places in um")));
}

}  // namespace
}  // namespace ringfilm::instrument
