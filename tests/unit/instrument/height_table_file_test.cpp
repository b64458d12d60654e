#include "ringfilm/instrument/formats/height_table_file.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ringfilm/base/number_text.hpp"
#include "written_files.hpp"

namespace ringfilm::instrument {
namespace {

using testing::HasSubstr;

SurfaceOptions with(const char* height_unit, const char* lateral_unit, const char* step = nullptr) {
  SurfaceOptions options;
  if (height_unit != nullptr) options.height_unit = height_unit;
  if (lateral_unit != nullptr) options.lateral_unit = lateral_unit;
  if (step != nullptr) options.step_x = step;
  return options;
}

TEST(HeightTable, AMatrixAsksForItsUnitAndStep) {
  const std::string text = "1;2;3;4\n5;;7;nan\n";
  EXPECT_THAT(refusal("a.csv", text), HasSubstr("--unit um"));
  EXPECT_THAT(refusal("a.csv", text, with("um", nullptr)), HasSubstr("--step-x"));
  const SurfaceFile file = read_bytes("a.csv", text, with("um", nullptr, "2 um"));
  ASSERT_EQ(file.map.points_x, 4u);
  ASSERT_EQ(file.map.points_y, 2u);
  EXPECT_DOUBLE_EQ(file.map.step_y_m, 2e-6);
  EXPECT_DOUBLE_EQ(file.map.height_m[4], 5e-6);
  EXPECT_EQ(file.map.missing, (std::vector<std::uint8_t>{0, 0, 0, 0, 0, 1, 0, 1}));
}

TEST(HeightTable, SeparatorsAndDecimalCommas) {
  for (const char* text :
       {"1.5,2,3,4\n5,6,7,8\n", "1,5;2;3;4\n5;6;7;8\n", "1.5\t2\t3\t4\n5\t6\t7\t8\n", "  1.5 2  3 4\r\n5 6 7 8\r\n",
        "1,5 2,0 3,0 4,0\n5,0 6,0 7,0 8,0\n", "1.5, 2, 3, 4\n5, 6, 7, 8",
        "\xEF\xBB\xBF"
        "1.5;2;3;4;\n5;6;7;8;\n"}) {
    const SurfaceFile file = read_bytes("a.csv", text, with("um", nullptr, "2 um"));
    ASSERT_EQ(file.map.points_x, 4u) << text;
    EXPECT_DOUBLE_EQ(file.map.height_m[0], 1.5e-6) << text;
    EXPECT_DOUBLE_EQ(file.map.height_m[7], 8e-6) << text;
  }
}

TEST(HeightTable, AnEmptyCellAtTheEndOfARowIsAMissingHeight) {
  const SurfaceFile file = read_bytes("a.csv", "1,2,3,\n5,6,7,8\n9,10,11,\n", with("um", nullptr, "2 um"));
  ASSERT_EQ(file.map.points_x, 4u);
  EXPECT_EQ(file.map.missing, (std::vector<std::uint8_t>{0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 1}));
}

TEST(HeightTable, ARowOfTabulatorsIsARowOfMissingHeights) {
  const SurfaceFile file = read_bytes("a.txt", "\t\n1\t2\t3\t4\n\t\t\t\n5\t6\t7\t8\n", with("um", nullptr, "2 um"));
  ASSERT_EQ(file.map.points_y, 3u) << "the blank line in front is not a row";
  EXPECT_EQ(std::count(file.map.missing.begin(), file.map.missing.end(), 1), 4);
  EXPECT_FALSE(file.map.measured(file.map.index(3, 1)));
}

TEST(HeightTable, TheCommentsOfGwyddionStateUnitAndSize) {
  const SurfaceFile file =
      read_bytes("a.txt",
                 "# Channel: Topography\n# Width: 8.0 \u00B5m\n# Height: 4.0 \u00B5m\n# Value units: m\n1e-9 2e-9 3e-9 "
                 "4e-9\n5e-9 6e-9 7e-9 8e-9\n");
  EXPECT_DOUBLE_EQ(file.map.step_x_m, 2e-6);
  EXPECT_DOUBLE_EQ(file.map.height_m[7], 8e-9);
}

TEST(HeightTable, RowsThatDoNotFillTheStatedHeightAreNoted) {
  const auto notes = [](const std::string& height, int rows) {
    std::string text = "# Width: 1.00 \u00B5m\n# Height: " + height + " \u00B5m\n# Value units: m\n";
    for (int row = 0; row < rows; ++row) text += "1e-9 2e-9 4e-9 3e-9 5e-9 7e-9\n";
    return read_bytes("a.txt", text).origin.doubts;
  };
  const auto uneven = HasSubstr("give steps of 0.166667 and 0.2");
  EXPECT_THAT(notes("1.00", 5), testing::Contains(uneven));
  EXPECT_TRUE(notes("1.00", 6).empty());
  // 7/6 is written as 1.17: steps of 0.16667 and 0.16714 differ by less than the digits state.
  EXPECT_TRUE(notes("1.17", 7).empty());
  EXPECT_TRUE(notes("1.17e0", 7).empty());
  EXPECT_FALSE(notes("1.1700", 7).empty() && notes("1.1800", 7).empty());
}

TEST(HeightTable, WidthAndHeightInDifferentUnitsGiveBothSteps) {
  const std::string heights = "# Value units: m\n1e-9 2e-9 3e-9 4e-9\n5e-9 6e-9 7e-9 8e-9\n";
  const SurfaceFile file =
      read_bytes("a.txt", "# Channel: Topography\n# Width: 10 \u00B5m\n# Height: 10 mm\n" + heights);
  EXPECT_DOUBLE_EQ(file.map.step_x_m, 2.5e-6);
  EXPECT_DOUBLE_EQ(file.map.step_y_m, 5e-3);
  // Equal steps in two units are not noted as uneven: 1.00 um / 4 and 0.00050 mm / 2.
  EXPECT_TRUE(read_bytes("a.txt", "# Width: 1.00 um\n# Height: 0.00050 mm\n" + heights).origin.doubts.empty());
  EXPECT_FALSE(read_bytes("a.txt", "# Width: 1.00 um\n# Height: 0.00060 mm\n" + heights).origin.doubts.empty());
  // A scan over time has one length only.
  EXPECT_THAT(refusal("a.txt", "# Width: 10 um\n# Height: 10 s\n" + heights), HasSubstr("--step-x"));
}

TEST(HeightTable, AStatedSideThatIsNotALengthIsNamedWithItsLine) {
  const auto refused = [](const std::string& width, const SurfaceOptions& options = {}) {
    const std::string heights = "# Value units: m\n1e-9 2e-9 3e-9\n5e-9 6e-9 7e-9\n";
    return refusal("a.txt", "# Channel: Z\n# Width: " + width + "\n# Height: 4 um\n" + heights, options);
  };
  EXPECT_THAT(refused("0 um"), HasSubstr("a.txt:2:1: Width is 0 um, but the side of a map is longer than 0"));
  EXPECT_THAT(refused("-3 um"), HasSubstr("a.txt:2:1: Width is -3 um"));
  EXPECT_THAT(refused("10 s"), HasSubstr("a.txt:2:1: Width is 10 s, a time and not a length"));
  EXPECT_THAT(refused("10 px"), HasSubstr("a.txt:2:1: Width is 10 px, and \"px\" is not a unit of length"));
  EXPECT_THAT(refused("0 um"), HasSubstr("correct the header of the file, or state the step"));
  const SurfaceFile file =
      read_bytes("a.txt", "# Width: 0 um\n# Height: 4 um\n# Value units: m\n1e-9 2e-9 3e-9\n5e-9 6e-9 7e-9\n",
                 with(nullptr, nullptr, "2 um"));
  EXPECT_EQ(file.map.points_x, 3u);
  EXPECT_DOUBLE_EQ(file.map.step_x_m, 2e-6);
}

TEST(HeightTable, ARowBelowTheNamesMayStateTheUnits) {
  for (const char* text : {"x;z\nmm;um\n0;1\n0,1;2\n0,2;3\n", "x\tz\n[mm]\t[um]\n0\t1\n0.1\t2\n0.2\t3\n",
                           "x [mm],z\n,(um)\n0,1\n0.1,2\n0.2,3\n"}) {
    const SurfaceFile file = read_bytes("a.csv", text);
    ASSERT_EQ(file.map.points_x, 3u) << text;
    EXPECT_NEAR(file.map.step_x_m, 1e-4, 1e-12) << text;
    EXPECT_DOUBLE_EQ(file.map.height_m[2], 3e-6) << text;
    EXPECT_THAT(file.origin.notes, testing::Contains("the row of units in line 2 was used")) << text;
  }
  EXPECT_THAT(refusal("a.csv", "x [um];z [um]\nmm;um\n0;1\n1;2\n"),
              HasSubstr("a.csv:2:1: the unit of x is mm here and um in the header"));
}

TEST(HeightTable, AMapOfFewColumnsIsTheMapThatItsHeaderStates) {
  const std::string header = "# Channel: Z\n# Width: 4.0 um\n# Height: 6.0 um\n# Value units: nm\n";
  SurfaceFile file = read_bytes("a.txt", header + "1\t2\n3\t4\n5\t6\n");
  ASSERT_EQ(file.map.points_x, 2u);
  ASSERT_EQ(file.map.points_y, 3u);
  EXPECT_DOUBLE_EQ(file.map.step_x_m, 2e-6);
  EXPECT_DOUBLE_EQ(file.map.step_y_m, 2e-6);
  EXPECT_DOUBLE_EQ(file.map.height_m[5], 6e-9);
  file = read_bytes("a.txt", header + "1 2 3\n4 5 6\n7 8 9\n");
  ASSERT_EQ(file.map.points_x, 3u);
  ASSERT_EQ(file.map.points_y, 3u);
  EXPECT_DOUBLE_EQ(file.map.height_m[8], 9e-9);
  // One column is a profile along y.
  file = read_bytes("a.txt", header + "1\n2\n3\n");
  EXPECT_TRUE(file.map.is_profile());
  EXPECT_DOUBLE_EQ(file.map.step_x_m, 2e-6);
}

TEST(HeightTable, TextThatIsNotATableNamesTheLineAndWhatIsRead) {
  const std::string text = "# export\n\nInstrument: Surf 3000\nDistance;Depth\n0;1\n1;2\n";
  const std::string words = refusal("a.txt", text);
  EXPECT_THAT(words, HasSubstr("a.txt:3:1: this line starts neither numbers nor columns of heights, and "));
  EXPECT_THAT(words, HasSubstr("Instrument: Surf 3000"));
  EXPECT_THAT(words, HasSubstr("text is read as a matrix of heights, as points x, y, z, or as a profile x, z"));
  EXPECT_THAT(words, testing::Not(HasSubstr("SUR or text")));
}

TEST(HeightTable, PointsInAnyOrderWithHoles) {
  const SurfaceFile file =
      read_bytes("a.csv",
                 "x [mm],y [mm],z [um]\n0.2,0.1,23\n0,0,11\n0.1,0,12\n0.2,0,13\n0,0.1,21\n0.1,0.1,\n"
                 "0,0.2,31\n0.2,0.2,33\n");
  ASSERT_EQ(file.map.points_x, 3u);
  ASSERT_EQ(file.map.points_y, 3u);
  EXPECT_DOUBLE_EQ(file.map.step_x_m, 1e-4);
  EXPECT_DOUBLE_EQ(file.map.height_m[file.map.index(2, 1)], 23e-6);
  EXPECT_EQ(file.map.missing, (std::vector<std::uint8_t>{0, 0, 0, 0, 1, 0, 0, 1, 0}));
}

TEST(HeightTable, PointsWithoutNamesAskForTheirUnits) {
  const std::string text = "0 0 1\n1 0 2\n0 1 3\n1 1 4\n";
  EXPECT_THAT(refusal("a.xyz", text, with("um", nullptr)), HasSubstr("--lateral-unit"));
  const SurfaceFile file = read_bytes("a.xyz", text, with("um", "mm"));
  EXPECT_DOUBLE_EQ(file.map.step_x_m, 1e-3);
  EXPECT_DOUBLE_EQ(file.map.height_m[3], 4e-6);
}

TEST(HeightTable, PlacesRoundedToFewDigitsStillLieOnTheGrid) {
  std::string text;
  for (int j = 0; j < 30; ++j) {
    for (int i = 0; i < 40; ++i) {
      char line[80];
      std::snprintf(line, sizeof line, "%.3f\t%.3f\t%d\n", i / 3.0, j / 7.0, 100 * j + i);
      text += line;
    }
  }
  const SurfaceFile file = read_bytes("a.xyz", text, with("nm", "um"));
  ASSERT_EQ(file.map.points_x, 40u);
  ASSERT_EQ(file.map.points_y, 30u);
  EXPECT_DOUBLE_EQ(file.map.height_m[file.map.index(17, 23)], 2317e-9);
  EXPECT_NEAR(file.map.step_x_m, 1e-6 / 3, 1e-10);  // three digits over 39 steps
}

TEST(HeightTable, PointsOffTheGridAreRefused) {
  std::string turned;  // by 2 degree
  for (int i = 0; i < 48; ++i) {
    const double x = i % 8, y = static_cast<double>(i / 8);
    turned += fmt::format("{:.6f} {:.6f} {}\n", x - 0.0349 * y, y + 0.0349 * x, std::sin(i * i));
  }
  EXPECT_THAT(refusal("a.xyz", turned, with("um", "um")),
              testing::AllOf(HasSubstr("off the grid"), HasSubstr("turned")));
  EXPECT_THAT(refusal("a.xyz", "0 0 1\n1 0 2\n0 1 3\n1.3 1 4\n", with("um", "mm")), HasSubstr("off the grid"));
  EXPECT_THAT(refusal("a.xyz", "0 0 1\n1 0 2\n0 1 3\n0 1 4\n", with("um", "mm")),
              HasSubstr("point 4: a second height"));
}

TEST(HeightTable, ProfilesKeepTheirPlaces) {
  const ScratchFolder folder;
  const std::string path = folder.write("a.csv", "x [mm];height [um]\n0,0;1,5\n0,1;2\n0,25;\n0,4;3\n");
  const TraceFile file = read_trace_file(path, {}, units());
  ASSERT_EQ(file.trace.x_m.size(), 3u);
  EXPECT_DOUBLE_EQ(file.trace.x_m[2], 4e-4);
  EXPECT_DOUBLE_EQ(file.trace.height_m[0], 1.5e-6);
  EXPECT_THAT(refusal("a.csv", "x [mm],z [um]\n0,1\n1,2\n1,3\n"), HasSubstr("a.csv:4:1: x falls or repeats"));
}

TEST(HeightTable, AProfileWhosePlacesFallIsTurnedAbout) {
  const SurfaceFile file = read_bytes("a.csv", "x [mm],z [um]\n2,1\n1,\n0,3\n");
  EXPECT_DOUBLE_EQ(file.map.height_m[0], 3e-6);
  EXPECT_EQ(file.map.missing, (std::vector<std::uint8_t>{0, 1, 0}));
  EXPECT_THAT(file.origin.notes, testing::Contains(HasSubstr("the profile was turned about")));
  EXPECT_THAT(refusal("a.csv", "x [mm],z [um]\n2,1\n1,2\n3,3\n"),
              HasSubstr("a.csv:4:1: x rises or repeats: 3 after 1"));
  // A line of length and count in front of places and heights.
  EXPECT_THAT(refusal("a.csv", "10,4\n0,1\n1,2\n2,1\n", with("um", "um")),
              HasSubstr("if the first line is not part of the profile, start it with #"));
}

TEST(HeightTable, TextOfTwoBytesALetter) {
  const std::string text = "x [\u00B5m],z [\u00B5m]\n0,1\n1,2\n2,4\n";
  for (const bool high_first : {false, true}) {
    handmade::Bytes bytes(high_first);
    bytes.i16(0xFEFF);
    for (std::size_t i = 0; i < text.size(); ++i) {
      const auto letter = static_cast<unsigned char>(text[i]);
      bytes.i16(letter == 0xC2 ? static_cast<unsigned char>(text[++i]) : letter);  // of Latin-1
    }
    EXPECT_DOUBLE_EQ(read_bytes("a.csv", bytes).map.height_m[2], 4e-6) << high_first;
  }
}

/// 8 x 6 heights, none of which is like another.
std::string eight_by_six(double factor = 1, const std::string& separator = "\t") {
  std::string text;
  for (int i = 0; i < 48; ++i) {
    text += number_text(factor * std::sin(0.7 * i * i + 0.2)) + (i % 8 == 7 ? "\n" : separator);
  }
  return text;
}

TEST(HeightTable, ImagesThatFollowEachOtherAreChannels) {
  const auto image = [](const std::string& name, const std::string& unit, double factor) {
    return "# Channel: " + name + "\n# Width: 8.000 \u00B5m\n# Height: 6.000 \u00B5m\n# Value units: " + unit + "\n" +
           eight_by_six(factor);
  };
  const std::string two = image("Height", "m", 1e-7) + "\n" + image("Height (back)", "m", 2e-7);
  EXPECT_THAT(refusal("a.txt", two), HasSubstr("2: Height (back) [m], 8 x 6 points"));
  SurfaceOptions options;
  for (const char* channel : {"1", "2"}) {
    options.channel = channel;
    const SurfaceFile file = read_bytes("a.txt", two, options);
    ASSERT_EQ(file.map.points_x, 8u);
    ASSERT_EQ(file.map.points_y, 6u);
    EXPECT_DOUBLE_EQ(file.map.step_y_m, 1e-6);
    EXPECT_NEAR(file.map.height_m[0], (channel[0] == '1' ? 1e-7 : 2e-7) * std::sin(0.2), 1e-13);
    EXPECT_THAT(file.origin.doubts, testing::IsEmpty());
  }
  // The only one that holds heights is taken; comments behind the last row are no other image.
  const SurfaceFile file =
      read_bytes("a.txt", image("Phase", "deg", 1) + image("Height", "m", 1e-7) + "# Channel: end\n");
  EXPECT_EQ(file.origin.channel_number, 2u);
  EXPECT_EQ(file.origin.channels.size(), 2u);
}

TEST(HeightTable, RowsThatABlankLinePartsAreDoubted) {
  const std::string rows = eight_by_six();
  const SurfaceOptions options = with("um", nullptr, "5 um");
  EXPECT_THAT(read_bytes("a.txt", "\n" + rows + "\n", options).origin.doubts, testing::IsEmpty());
  EXPECT_THAT(read_bytes("a.txt", rows + "\n" + eight_by_six(2), options).origin.doubts,
              testing::ElementsAre(HasSubstr("the blank line 7 parts rows")));
}

TEST(HeightTable, TheCommentsOfGwyddionInOtherLanguages) {
  for (const char* head :
       {"# Kanal: Topographie\n# Breite: 8,00 \u00B5m\n# H\u00F6he: 6,00 \u00B5m\n# Werteinheiten: nm\n",
        "# Canal: Hauteur\n# Largeur: 8.00 \u00B5m\n# Hauteur: 6.00 \u00B5m\n# Unit\u00E9s: nm\n"}) {
    const SurfaceFile file = read_bytes("a.txt", head + eight_by_six(100));
    EXPECT_DOUBLE_EQ(file.map.step_x_m, 1e-6) << head;
    EXPECT_DOUBLE_EQ(file.map.step_y_m, 1e-6) << head;
    EXPECT_NEAR(file.map.height_m[0], 1e-7 * std::sin(0.2), 1e-12) << head;
  }
}

TEST(HeightTable, TheCommentsOfSpip) {
  const std::string head =
      "# File Format = ASCII\n# x-pixels = 8\n# y-pixels = 6\n# x-length = 8000\n# y-length = 6000\n";
  SurfaceFile file = read_bytes("a.asc", head + "# z-unit = nm\n# Start of Data:\n" + eight_by_six(100));
  EXPECT_DOUBLE_EQ(file.map.step_x_m, 1e-6);
  EXPECT_NEAR(file.map.height_m[0], 1e-7 * std::sin(0.2), 1e-12);
  SurfaceOptions options;
  for (const bool is_stated : {false, true}) {  // the natural answer to a missing unit changes nothing
    if (is_stated) options.height_unit = "nm";
    file = read_bytes("a.asc", head + "# Bit2nm = 0.5\n" + eight_by_six(200), options);
    EXPECT_NEAR(file.map.height_m[0], 1e-7 * std::sin(0.2), 1e-12);
    EXPECT_THAT(file.origin.doubts, testing::IsEmpty());
    EXPECT_THAT(file.origin.notes, testing::Contains(HasSubstr("Bit2nm = 0.5")));
  }
  file = read_bytes("a.asc", head + "# Bit2nm = 0.5\n# z-unit = nm\n" + eight_by_six(100));
  EXPECT_THAT(file.origin.doubts, testing::ElementsAre(HasSubstr("line 6 states Bit2nm = 0.5, which was not used")));
  file = read_bytes("a.asc", head + "# z-unit = nm\n" + eight_by_six(100) + "10\t2\t31\t4\t25\t6\t17\t8\n");
  EXPECT_THAT(file.origin.doubts,
              testing::Contains(HasSubstr("the comments state 8 x 6 points, and the file has 8 x 7")));
}

TEST(HeightTable, SpreadsheetsAndMatlab) {
  const SurfaceOptions options = with("um", nullptr, "5 um");
  const double first = 1e-6 * std::sin(0.2), tolerance = 1e-11;
  std::string quoted = eight_by_six(1, "\",\"");
  for (std::size_t i = 0; (i = quoted.find('\n', i)) != std::string::npos; i += 3) quoted.replace(i, 1, "\"\n\"");
  quoted = "\"" + quoted.substr(0, quoted.size() - 1);
  for (const std::string& text : {quoted, "sep=;\n" + eight_by_six(1, ";"), "% exported\n" + eight_by_six(1, " ")}) {
    const SurfaceFile file = read_bytes("a.csv", text, options);
    ASSERT_EQ(file.map.points_x, 8u) << text;
    ASSERT_EQ(file.map.points_y, 6u) << text;
    EXPECT_NEAR(file.map.height_m[0], first, tolerance) << text;
  }
  EXPECT_EQ(read_bytes("a.csv", "No Data,1,2,3\n4,5,---,7\n", options).map.missing,
            (std::vector<std::uint8_t>{1, 0, 0, 0, 0, 0, 1, 0}));
}

TEST(HeightTable, CountsInFrontOfTheHeightsAreRefused) {
  std::string heights;
  for (int i = 0; i < 48; ++i) heights += number_text(std::sin(0.7 * i * i)) + "\n";
  EXPECT_THAT(refusal("a.txt", "10.0\n48\n" + heights, with("um", nullptr, "2.5 um")),
              testing::AllOf(HasSubstr("the first 2 values, 10, 48"), HasSubstr("start their lines with #")));
  EXPECT_EQ(read_bytes("a.txt", "# 10.0\n# 48\n" + heights, with("um", nullptr, "2.5 um")).map.points_x, 48u);
  EXPECT_THAT(
      refusal("a.txt", "8 6\n" + eight_by_six(1, " "), with("um", nullptr, "5 um")),
      testing::AllOf(HasSubstr("the row has 8 values, and 2 are required"), HasSubstr("one of counts, with #")));
  std::string points;
  for (int i = 0; i < 48; ++i) points += fmt::format("{} {} {}\n", i % 8, i / 8, std::sin(0.7 * i * i));
  EXPECT_THAT(refusal("a.xyz", "8 6 48\n" + points, with("um", "mm")),
              testing::AllOf(HasSubstr("the first point, 8, 6, 48, counts the 48 points"), HasSubstr("with #")));
  EXPECT_THAT(refusal("a.xyz", "8 6 1\n" + points, with("um", "mm")), HasSubstr("counts the 48 points"));
  EXPECT_EQ(refusal("a.xyz", points, with("um", "mm")), "");
}

TEST(HeightTable, PointsWithFurtherColumnsAreNotAMatrix) {
  std::string numbered, normals;
  for (int i = 0; i < 48; ++i) {
    const std::string point = fmt::format("{} {} {}", i % 8, i / 8, std::sin(0.7 * i * i));
    numbered += fmt::format("{} {}\n", i, point);
    normals += point + " 0 0 1\n";
  }
  const SurfaceOptions options = with("um", "um", "1 um");
  EXPECT_THAT(refusal("a.txt", normals, options), HasSubstr("columns 1 and 2 of 6 are the places of points"));
  EXPECT_THAT(refusal("a.txt", numbered, options), HasSubstr("columns 2 and 3 of 4 are the places of points"));
  EXPECT_THAT(refusal("a.txt", numbered, options), HasSubstr("--columns \"-, x [um], y [um], z [um]\""));
  SurfaceOptions stated;
  stated.table.columns = "-, x [um], y [um], z [um]";
  EXPECT_EQ(read_bytes("a.txt", numbered, stated).map.points_x, 8u) << "as the remedy states";
  const SurfaceFile file = read_bytes("a.txt", "id x y z\n" + numbered, with("um", "mm"));
  ASSERT_EQ(file.map.points_x, 8u);
  ASSERT_EQ(file.map.points_y, 6u);
}

TEST(HeightTable, PlacesOfFewDigits) {
  const auto points = [](double step, const char* format) {
    std::string text = "x [mm],y [mm],z [um]\n";
    for (int i = 0; i < 64 * 20; ++i) {
      const int column = i % 64, row = i / 64;
      if (column == 30) continue;  // a column that was not measured
      text += fmt::format(fmt::runtime(format), step * column, step * row, std::sin(0.7 * i * i));
    }
    return text;
  };
  const SurfaceFile file = read_bytes("a.csv", points(0.00083, "{:.4f},{:.4f},{:.4f}\n"));
  ASSERT_EQ(file.map.points_x, 64u);
  ASSERT_EQ(file.map.points_y, 20u);
  EXPECT_NEAR(file.map.step_x_m, 0.83e-6, 0.1e-6 / 63);  // one digit over 63 steps
  EXPECT_FALSE(file.map.measured(30));
  EXPECT_EQ(measured_points(file.map), 63u * 20u);
  // With one digit fewer neighbours share a place.
  EXPECT_THAT(refusal("a.csv", points(0.00083, "{:.3f},{:.3f},{:.4f}\n")), HasSubstr("a second height"));
}

TEST(HeightTable, StepsOfOneOrTwoDigitsAreOneStep) {
  const auto points = [](const auto& is_measured) {
    std::string text = "x [um],y [um],z [um]\n";
    for (int i = 0; i < 64 * 20; ++i) {
      if (!is_measured(i % 64)) continue;
      text += fmt::format("{:.0f},{:.0f},{:.4f}\n", 1.66 * (i % 64), 1.66 * (i / 64), std::sin(0.7 * i * i));
    }
    return text;
  };
  const SurfaceFile file = read_bytes("a.csv", points([](int) { return true; }));
  ASSERT_EQ(file.map.points_x, 64u);
  ASSERT_EQ(file.map.points_y, 20u);
  EXPECT_NEAR(file.map.step_x_m, 1.66e-6, 1e-6 / 63);
  EXPECT_THAT(file.origin.doubts, testing::IsEmpty());
  // With columns that are missing this is ambiguous: the grid of whole digits has empty columns, which is noted.
  EXPECT_THAT(read_bytes("a.csv", points([](int column) { return column < 20 || column > 24; })).origin.doubts,
              testing::Contains(HasSubstr("columns of the grid have no point")));
}

TEST(HeightTable, TheNotesNameDecimalCommasAndUnusedColumns) {
  const auto notes = [](const std::string& text, const SurfaceOptions& options = {}) {
    std::string all;
    for (const std::string& note : read_bytes("a.csv", text, options).origin.notes) all += note + "\n";
    return all;
  };
  EXPECT_THAT(notes("0,25;0,5;1;2\n3;4;5;6\n", with("um", nullptr, "1 um")), HasSubstr("decimal commas"));
  EXPECT_THAT(notes("No;x [um];z [um];light\n1;0;1.5;9\n2;1;2.5;9\n3;2;1.5;9\n"),
              HasSubstr("columns that were not used: No, light"));
  EXPECT_THAT(notes("x [um];z [um]\n0;1.5\n1;2.5\n2;1\n"), testing::Not(HasSubstr("not used")));
}

TEST(HeightTable, AOfAHeightIsTheAngstrom) {
  const SurfaceFile file = read_bytes(
      "a.csv", "Meta Data\nFile Type,Profile\n\nLateral (um),Total Profile (A),\n0.0,13000.0,\n0.5,1e4,\n1.0,9e3,\n");
  EXPECT_DOUBLE_EQ(file.map.height_m[0], 1.3e-6);
  EXPECT_DOUBLE_EQ(file.map.step_x_m, 0.5e-6);
}

TEST(HeightTable, TrueOfAColumnOfValidityIsMeasured) {
  const SurfaceFile file = read_bytes("a.csv", "x [um],z [um],valid\n0,1.5,true\n1,2.5,False\n2,1,true\n");
  EXPECT_EQ(file.map.missing, (std::vector<std::uint8_t>{0, 1, 0}));
}

TEST(HeightTable, TwoValuesThatMayBeOneAreNamedWhereTheyDoNotFollowEachOther) {
  EXPECT_THAT(refusal("a.txt", "3,25\n1,52\n2,12\n", with("um", "um")),
              HasSubstr("--columns \"z [um]\" for one number"));
}

TEST(HeightTable, FilesOfOtherProgramsNameHowToExport) {
  const std::string zeros(200, '\0');
  EXPECT_THAT(refusal("a.xlsx", "PK\x03\x04" + zeros + "[Content_Types].xml" + zeros),
              testing::AllOf(HasSubstr("this is an Excel workbook (xlsx) or another Office file, not text"),
                             HasSubstr("save the table as CSV")));
  EXPECT_THAT(refusal("a.mat", "MATLAB 5.0 MAT-file, Platform: GLNXA64" + zeros), HasSubstr("writematrix"));
  EXPECT_THAT(refusal("a.tdms", "TDSm" + zeros), HasSubstr("this is a TDMS file of LabVIEW"));
  EXPECT_THAT(refusal("a.h5", "\x89HDF\r\n\x1a\n" + zeros), HasSubstr("h5py"));
}

TEST(HeightTable, FaultsNameLineAndColumn) {
  EXPECT_THAT(refusal("a.csv", "1,2,3,4\n5,6,seven,8\n", with("um", nullptr, "1 um")),
              HasSubstr("a.csv:2:5: \"seven\" is not a finite number"));
  EXPECT_THAT(refusal("a.csv", "1,2,3,4\n5,6,7\n", with("um", nullptr, "1 um")),
              HasSubstr("a.csv:2:1: the row has 3 values, and 4 are required"));
  EXPECT_THAT(refusal("a.csv", "x [mm],q [um]\n1,2\n2,3\n"), HasSubstr("there is no column z among: x, q"));
  EXPECT_THAT(refusal("a.csv", "1,2,3,1e999\n5,6,7,8\n", with("um", nullptr, "1 um")),
              HasSubstr("not a finite number"));
}

}  // namespace
}  // namespace ringfilm::instrument
