#include "ringfilm/instrument/formats/trade_table_file.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "written_files.hpp"

namespace ringfilm::instrument {
namespace {

using testing::Contains;
using testing::HasSubstr;

double height_of(int i) { return std::sin(0.7 * i * i + 0.2); }

/// 8 x 6 heights; each row begins with `front` of its number and ends with `behind`.
template <class Front>
std::string rows_of(const Front& front, const std::string& separator, const std::string& behind, double factor = 1) {
  std::string text;
  for (int j = 0; j < 6; ++j) {
    text += front(j);
    for (int i = 0; i < 8; ++i) {
      text += fmt::format("{:.6f}{}", factor * height_of(8 * j + i), i == 7 ? behind : separator);
    }
    text += "\n";
  }
  return text;
}

std::string bare(const std::string& separator, double factor = 1) {
  return rows_of([](int) { return std::string(); }, separator, "", factor);
}

void expect_map(const std::string& text, double step_m, const SurfaceOptions& options = {}) {
  const SurfaceFile file = read_bytes("a.csv", text, options);
  ASSERT_EQ(file.map.points_x, 8u);
  ASSERT_EQ(file.map.points_y, 6u);
  EXPECT_NEAR(file.map.step_x_m, step_m, 1e-12);
  EXPECT_NEAR(file.map.step_y_m, step_m, 1e-12);
  for (int i = 0; i < 48; ++i) EXPECT_NEAR(file.map.height_m[static_cast<std::size_t>(i)], 1e-6 * height_of(i), 1e-12);
}

TEST(TradeTable, Keyence) {
  std::string rows = bare("\",\"");
  for (std::size_t i = 0; (i = rows.find('\n', i)) != std::string::npos; i += 3) rows.replace(i, 1, "\"\n\"");
  rows = "\"" + rows.substr(0, rows.size() - 1);
  const std::string head =
      "\"Measurement date\",\"2024/01/01\"\n\"Model\",\"VK\"\n\"XY calibration\",\"2000\",\"nm\"\n"
      "\"Horizontal\",\"8\"\n\"Vertical\",\"6\"\n\"Unit\",\"um\"\n\n\"Height\"\n";
  expect_map(head + rows, 2e-6);
  std::string other = head;
  other.replace(other.find("\"6\""), 3, "\"7\"");
  EXPECT_THAT(read_bytes("a.csv", other + rows).origin.doubts, Contains(HasSubstr("the head states 8 x 7 points")));
}

TEST(TradeTable, Olympus) {
  const std::string head =
      "\"Information\"\n\"Sample\",\"A\"\n\"XResolution\",0.5,\"um\"\n\"YResolution\",0.5,\"um\"\n"
      "\"ZResolution\",0.001,\"um\"\n\n\"DataLine\",\"POS = 0\",\"POS = 1\",\n";
  expect_map(head + rows_of([](int j) { return fmt::format("{},", j); }, ",", ","), 0.5e-6);
  EXPECT_THAT(refusal("a.csv", head + rows_of([](int j) { return fmt::format("{},", j + (j > 3 ? 1 : 0)); }, ",", ",")),
              HasSubstr("the row is numbered 5 behind 3"));
}

TEST(TradeTable, SizeAndConversionFactorInFront) {
  expect_map(
      "h=6 w=8\npixel size=1.0e-006 m\ndata unit=rad\nheight conversion factor (-> m)=5.0e-008\n" + bare(" ", 20),
      1e-6);
}

TEST(TradeTable, PointsOfAlicona) {
  std::string text = "GPoint3DVector { 48 n {\n";
  for (int i = 0; i < 48; ++i) text += fmt::format("{}.0 {}.0 {:.6f} 0 0 1\n", i % 8, i / 8, height_of(i));
  SurfaceOptions options;
  options.height_unit = options.lateral_unit = "um";
  expect_map(text + "}\n}\n", 1e-6, options);
  options.lateral_unit.reset();  // one unit for all three
  expect_map(text + "}\n}\n", 1e-6, options);
  options = {};
  expect_map(text + "}\n}\n", 1e-6, options);
  EXPECT_THAT(read_bytes("a.csv", text + "}\n}\n").origin.doubts,
              Contains(HasSubstr("the file states no unit: um was assumed for x, y and z, which makes steps of 1 um")));
}

TEST(TradeTable, PointsOfAliconaInMetres) {
  std::string text = "GPoint3DVector { 48 n {\n";
  for (int i = 0; i < 48; ++i)
    text += fmt::format("{:.9f} {:.9f} {:.12f}\n", 1e-6 * (i % 8), 1e-6 * (i / 8), 1e-6 * height_of(i));
  expect_map(text + "}\n}\n", 1e-6);
  EXPECT_THAT(read_bytes("a.csv", text).origin.doubts, Contains(HasSubstr("m was assumed")));
}

/// The head of the MetroPro reference guide up to the first #, for 8 x 6 points from column 3 and row 2 of the camera.
std::string zygo_head(const char* first, bool has_zoom) {
  return std::string(first) +
         "\n0 8 3 5 \"Mon Jan 01 00:00:00 2024         \"\n0 0 0 0 0 0\n3 2 8 6\n\"comment 1 2 3\"\n\"\"\n\"\"\n"
         "0 0.5 6.33e-007 0.3 1.02 0 1.0e-006 1704067200\n640 480 0 0 0 0 \"50X\"\n0 0 0 0 0 0 0 0 0 0\n"
         "1 1 20 2 0 0 0 0 0\n0 \"\"\n1 0\n" +
         (has_zoom ? "\"1.00X\"\n" : "") + "#\n";
}

TEST(TradeTable, ZygoAscii) {
  constexpr double kHeightOfPhase = 0.5 * 6.33e-7 * 1.02 / 32768;  // 9.9e-12 m: the phases round to half of that
  const auto with = [&](int missing, const std::string& intensities) {
    std::string text = zygo_head("Zygo ASCII Data File - Format 2", true) + intensities + "#\n";
    for (int i = 0; i < 48; ++i) {
      text += i == missing ? "2147483640" : fmt::format("{:.0f}", 1e-6 * height_of(i) / kHeightOfPhase);
      text += i % 10 == 9 ? " \n" : " ";
    }
    return text + "\n#\n";
  };
  for (const std::string intensities : {"", "0 0 0\n12 13 14\n"}) {
    const SurfaceFile file = read_bytes("a.asc", with(9, intensities));
    ASSERT_EQ(file.map.points_x, 8u);
    ASSERT_EQ(file.map.points_y, 6u);
    EXPECT_NEAR(file.map.step_x_m, 1e-6, 1e-15);
    for (int i = 0; i < 48; ++i) {
      const auto at = static_cast<std::size_t>(i);
      if (i == 9) continue;
      EXPECT_NEAR(file.map.height_m[at], 1e-6 * height_of(i), 0.51 * kHeightOfPhase);
    }
    EXPECT_FALSE(file.map.measured(9));
    EXPECT_EQ(file.origin.format, "text, Zygo ASCII");
  }
  const std::string whole = with(-1, "");
  EXPECT_THAT(refusal("a.asc", whole.substr(0, whole.find_last_of(' ', whole.size() - 30))), HasSubstr("of 8 x 6"));
  std::string many = whole;
  many.replace(many.find("3 2 8 6"), 7, "3 2 9999 9999");
  EXPECT_THAT(refusal("a.asc", many), HasSubstr("more than the file can hold"));
}

TEST(TradeTable, ZygoXyz) {
  std::string text = zygo_head("Zygo XYZ Data File - Format 1", false);
  for (int i = 0; i < 48; ++i) {
    text += i == 9 ? fmt::format("{} {} No Data\n", 3 + i % 8, 2 + i / 8)
                   : fmt::format("{} {} {:.6f}\n", 3 + i % 8, 2 + i / 8, height_of(i));
  }
  const SurfaceFile file = read_bytes("a.xyz", text + "#\n");
  ASSERT_EQ(file.map.points(), 48u);
  EXPECT_FALSE(file.map.measured(9));
  EXPECT_NEAR(file.map.height_m[47], 1e-6 * height_of(47), 1e-12);
  EXPECT_NEAR(file.map.step_y_m, 1e-6, 1e-15);
  EXPECT_THAT(refusal("a.xyz", text + "3 9 0.5\n#\n"), HasSubstr("the point lies outside of the 8 x 6 points"));
}

TEST(TradeTable, ProfilesOfOtherPrograms) {
  const auto profile = [](const std::string& head, const char* row) {
    std::string text = head;
    for (int i = 0; i < 48; ++i) text += fmt::format(fmt::runtime(row), i, 0.5 * i, height_of(i));
    return text;
  };
  SurfaceOptions um;
  um.height_unit = "um";
  for (const auto& [text, options] :
       {std::pair(profile("X_(microns),y1\n", "{1},{2:.6f}\n"), um),
        std::pair(
            profile("Counter\tAltitude (\u00B5m)\tEncoder1 (\u00B5m)\tEncoder2 (\u00B5m)\n", "{0}\t{2:.6f}\t{1}\t0\n"),
            SurfaceOptions()),
        std::pair(profile("Mahr MarSurf\nDate;2024-01-01\nx [um];z [um]\n", "{1};{2:.6f}\n"), SurfaceOptions()),
        std::pair(profile("X;Y;valid\n[um];[um];[1/0]\n", "{1};{2:.6f};1\n"), SurfaceOptions())}) {
    const SurfaceFile file = read_bytes("a.csv", text, options);
    ASSERT_EQ(file.map.points_x, 48u) << text.substr(0, 40);
    EXPECT_TRUE(file.map.is_profile());
    EXPECT_NEAR(file.map.step_x_m, 0.5e-6, 1e-12);
    EXPECT_NEAR(file.map.height_m[5], 1e-6 * height_of(5), 1e-12) << text.substr(0, 40);
  }
  const std::string marked = profile("X;Y;valid\n[um];[um];[1/0]\n", "{1};{2:.6f};1\n");
  EXPECT_FALSE(read_bytes("a.csv", marked.substr(0, marked.size() - 2) + "0\n").map.measured(47));
}

TEST(TradeTable, UnevenPlacesOfAProfileAreResampledWithTheirError) {
  std::string text = "x [um],z [um]\n";
  for (int i = 0; i < 200; ++i) {
    const double x = 0.5 * i + (i % 3 == 1 ? 0.1 : 0);
    text += fmt::format("{:.4f},{:.6f}\n", x, std::sin(0.2 * x));
  }
  const SurfaceFile file = read_bytes("a.csv", text);
  ASSERT_EQ(file.map.points_x, 200u);
  for (std::size_t i = 0; i < 200; ++i) {
    // Linear interpolation errs by the curvature, 0.04, times a step of 0.6 squared over 8.
    EXPECT_NEAR(file.map.height_m[i], 1e-6 * std::sin(0.2 * file.map.step_x_m * 1e6 * static_cast<double>(i)), 2e-9);
  }
  EXPECT_THAT(file.origin.notes, Contains(HasSubstr("the places are uneven, in steps of 0.4 to 0.6 um")));
}

TEST(TradeTable, LengthAndCountInFrontAreTakenByTheStatedStep) {
  std::string text = "0.0240\n48\n";
  for (int i = 0; i < 48; ++i) text += fmt::format("{:.6f}\n", height_of(i));
  SurfaceOptions options;
  options.height_unit = "um";
  options.step_x = "0.5 um";  // 0.024 mm / 48
  const SurfaceFile file = read_bytes("a.txt", text, options);
  EXPECT_EQ(file.map.points_x, 48u);
  EXPECT_THAT(file.origin.notes, Contains(HasSubstr("the length in mm and the number of the heights")));
  options.step_x = "2.5 um";
  EXPECT_THAT(refusal("a.txt", text, options), HasSubstr("state the number of the values behind them"));
}

TEST(TradeTable, NumbersBehindUnknownWordsAreRefusedWithTheChoice) {
  const std::string text = "Instrument: Surf 3000\nOperator: M\n" + bare(" ");
  EXPECT_THAT(refusal("a.txt", text), HasSubstr("the numbers seem to begin in line 3: --skip-lines 2"));
  SurfaceOptions options;
  options.height_unit = "um";
  options.step_x = "1 um";
  options.table.skip_lines = 2;
  expect_map(text, 1e-6, options);
}

}  // namespace
}  // namespace ringfilm::instrument
