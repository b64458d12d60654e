#include "ringfilm/instrument/formats/smd_file.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "written_files.hpp"

namespace ringfilm::instrument {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr int kPoints = 40;
double height_of(int i) { return std::sin(0.7 * i * i + 0.2); }  // [um]

/// Words end with NUL, sections with ETX, the file with SUB, as ISO 5436-2 has them; | stands for NUL.
std::string smd(std::string axis_x, int points = kPoints, const std::string& feature = "PRF| 0 PROFILE|") {
  std::string text = "ISO 5436-2 - 2000| own|\r\n" + feature + "\r\n" + axis_x + "\r\n" +
                     fmt::format("CZ| A| {} UM| 1.0e-3 D|\r\n", kPoints) + "\x03\r\n" +
                     "DATE 01-01-2024|\r\nINSTRUMENT_ID S3|\r\n\x03\r\n";
  for (int i = 0; i < points; ++i) {
    text += i == 7 ? std::string("BAD\r\n") : fmt::format("{:.4f}\r\n", 1e3 * height_of(i));
  }
  text += "\x03\r\n";
  for (char& c : text) c = c == '|' ? '\0' : c;
  unsigned sum = 0;
  for (const char c : text) sum += static_cast<unsigned char>(c);
  return text + fmt::format("{}\r\n\x03\r\n\x1A\r\n", sum % 65535);
}

const std::string kX = "CX| I| 40 MM| 1.0 D| 0.0005";

TEST(SmdFile, AProfileWithItsStepScaleAndMissingPoint) {
  const SurfaceFile file = read_bytes("a.smd", smd(kX));
  EXPECT_EQ(file.origin.format, "SMD (ISO 5436-2)");
  EXPECT_EQ(file.origin.date, "01-01-2024");
  EXPECT_EQ(file.origin.instrument, "S3");
  EXPECT_THAT(file.origin.doubts, IsEmpty());
  ASSERT_EQ(file.map.points_x, static_cast<std::size_t>(kPoints));
  EXPECT_TRUE(file.map.is_profile());
  EXPECT_NEAR(file.map.step_x_m, 0.5e-6, 1e-15);
  for (int i = 0; i < kPoints; ++i) {
    const auto at = static_cast<std::size_t>(i);
    EXPECT_EQ(file.map.measured(at), i != 7);
    if (i == 7) continue;
    EXPECT_NEAR(file.map.height_m[at], 1e-6 * height_of(i), 1e-13);  // seven digits
  }
}

TEST(SmdFile, AnotherCheckSumIsNoted) {
  std::string edited = smd(kX);
  edited.replace(edited.find("own"), 3, "our");
  EXPECT_THAT(read_bytes("a.smd", edited).origin.doubts, ElementsAre(HasSubstr("states the check sum")));
}

TEST(SmdFile, WhatIsNotSuchAProfileIsRefused) {
  EXPECT_THAT(refusal("a.smd", smd("CX| A| 40 MM| 1.0 D|")), HasSubstr("a.smd:3:1: the x axis is not incremental"));
  EXPECT_THAT(refusal("a.smd", smd(kX, 39)), HasSubstr("there are 39 heights, and CX and CZ state 40 and 40"));
  EXPECT_THAT(refusal("a.smd", smd(kX, kPoints, "SUR| 0 MAP|")), HasSubstr("a.smd:2:1: this is a surface"));
  const std::string whole = smd(kX);
  EXPECT_THAT(refusal("a.smd", whole.substr(0, whole.size() - 200)), HasSubstr("the file ends within a section"));
}

}  // namespace
}  // namespace ringfilm::instrument
