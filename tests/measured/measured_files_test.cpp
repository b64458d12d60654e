#include "measured_files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "../unit/instrument/written_files.hpp"
#include "measured_chain.hpp"

namespace ringfilm::measured_files {
namespace {

const std::string kCases = std::string(RINGFILM_SOURCE_FOLDER) + "/cases";

std::string committed(const std::string& name) {
  std::ifstream file(kCases + "/measured/" + name, std::ios::binary);
  std::stringstream bytes;
  bytes << file.rdbuf();
  return bytes.str();
}

const std::vector<GeneratedFile>& generated_files() {
  static const std::vector<GeneratedFile> files = all_files(kCases);
  return files;
}

bool is_text(const std::string& name) { return std::filesystem::path(name).extension() == ".csv"; }

/// Numbers of a text apart from its lines of comment.
std::vector<double> numbers_of(const std::string& text) {
  std::vector<double> numbers;
  std::stringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::stringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) numbers.push_back(std::strtod(cell.c_str(), nullptr));
  }
  return numbers;
}

TEST(MeasuredFiles, AreWhatTheirMakerWrites) {
  ASSERT_EQ(generated_files().size(), 11u);
  for (const GeneratedFile& made : generated_files()) {
    const std::string bytes = committed(made.name);
    ASSERT_FALSE(bytes.empty()) << made.name;
    if (bytes == made.bytes) continue;
    // Another libm may round the other way: two steps of the file, in text 1e-4 and in maps 0.1 nm.
    if (is_text(made.name)) {
      const std::vector<double> here = numbers_of(made.bytes), there = numbers_of(bytes);
      ASSERT_EQ(here.size(), there.size()) << made.name;
      for (std::size_t i = 0; i < here.size(); ++i) ASSERT_NEAR(here[i], there[i], 2.1e-4) << made.name << ", " << i;
    } else {
      const surface::HeightMap here = instrument::read_bytes(made.name, made.bytes).map;
      const surface::HeightMap there = instrument::read_bytes(made.name, bytes).map;
      ASSERT_EQ(here.points(), there.points()) << made.name;
      ASSERT_EQ(here.missing, there.missing) << made.name;
      for (std::size_t i = 0; i < here.points(); ++i) {
        ASSERT_NEAR(here.height_m[i], there.height_m[i], 2.1e-10) << made.name << ", " << i;
      }
    }
  }
}

TEST(MeasuredFiles, StateThatTheyAreSynthetic) {
  for (const GeneratedFile& made : generated_files()) {
    const std::string bytes = committed(made.name);
    if (is_text(made.name)) {
      EXPECT_EQ(bytes.rfind("# SYNTHETIC", 0), 0u) << made.name;
      continue;
    }
    const instrument::SurfaceOrigin origin = instrument::read_bytes(made.name, bytes).origin;
    std::string reported = origin.instrument;
    for (const std::string& note : origin.notes) reported += note;
    EXPECT_THAT(reported, testing::HasSubstr("SYNTHETIC")) << made.name;
    EXPECT_THAT(reported, testing::HasSubstr("seed")) << made.name;
  }
}

TEST(MeasuredFiles, StaySmall) {
  std::uintmax_t bytes = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(kCases + "/measured")) {
    if (entry.is_regular_file()) bytes += entry.file_size();
  }
  EXPECT_GT(bytes, 500000u);
  EXPECT_LT(bytes, 1000000u);  // what a checkout may be asked to carry
}

TEST(MeasuredFiles, AreMadeFromTheValuesOfThePaper) {
  const std::vector<TargetRing> rings = target_rings(kCases);
  ASSERT_EQ(rings.size(), 3u);
  EXPECT_EQ(rings[1].name, "run_in");
  EXPECT_DOUBLE_EQ(rings[1].beta_m, 1.34e-6);            // Table 1
  EXPECT_DOUBLE_EQ(rings[2].shear_strength, 0.1423);     // Table 2
  EXPECT_DOUBLE_EQ(rings[0].face_mm_um.front(), 427.9);  // Table 4
}

}  // namespace
}  // namespace ringfilm::measured_files
