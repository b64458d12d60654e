#include "ringfilm/io/start/start_case.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include <algorithm>
#include <cctype>
#include <iterator>

#include "../case_example.hpp"
#include "ringfilm/case/keys/case_fields.hpp"
#include "ringfilm/io/case/case_file.hpp"
#include "ringfilm/io/case/shipped_oils.hpp"
#include "ringfilm/io/start/trace_keys.hpp"

namespace ringfilm::io {
namespace {

using ::testing::HasSubstr;

const std::vector<std::string> kEngines = {"passenger-car", "heavy-duty", "hydrogen", "light-duty-diesel",
                                           "turbo-gasoline"};

class StartCaseOf : public ::testing::TestWithParam<std::string> {
 protected:
  void SetUp() override { ASSERT_EQ(::setenv("RINGFILM_DATA", RINGFILM_SOURCE_FOLDER, 1), 0); }
  void TearDown() override { ASSERT_EQ(::unsetenv("RINGFILM_DATA"), 0); }
};

TEST_P(StartCaseOf, CanBeReadUnchanged) {
  const ScratchFolder folder;
  const StartCase start = start_case({.engine = GetParam(), .has_all_keys = true});
  write_text(folder / "my.toml", start.text);
  const cycle::Case c = read_case(folder / "my.toml");
  EXPECT_EQ(c.gas.model, cycle::GasModel::kWiebe);
  EXPECT_TRUE(start.missing.empty());
  for (const std::string& key : c.stated) {
    if (key.rfind("lubricant.", 0) == 0) continue;  // those of the oil's file
    EXPECT_THAT(start.text, HasSubstr("\n" + key.substr(key.rfind('.') + 1) + " = ")) << key;
  }
}

TEST_P(StartCaseOf, HasEveryKeyOrItsComment) {
  const std::string text = start_case({.engine = GetParam(), .has_all_keys = true}).text;
  for (const cycle::Field& field : cycle::case_fields()) {
    if (!cycle::belongs(field, cycle::Case{})) continue;  // the case that it starts is a cycle
    const std::string name = field.key.substr(field.key.rfind('.') + 1);
    EXPECT_TRUE(text.find("\n" + name + " = ") != std::string::npos ||
                text.find("\n# " + name + " = ") != std::string::npos)
        << field.key;
  }
}

TEST_P(StartCaseOf, HasFortyLinesAndTheValuesOfTheLongOne) {
  const ScratchFolder folder;
  const std::string text = start_case({.engine = GetParam()}).text;
  EXPECT_LE(std::count(text.begin(), text.end(), '\n'), 40);
  write_text(folder / "short.toml", text);
  write_text(folder / "long.toml", start_case({.engine = GetParam(), .has_all_keys = true}).text);
  const cycle::Case c = read_case(folder / "short.toml"), all = read_case(folder / "long.toml");
  EXPECT_EQ(c.stated, all.stated);
  EXPECT_EQ(resolved_case(c), resolved_case(all));
}

INSTANTIATE_TEST_SUITE_P(Engines, StartCaseOf, ::testing::ValuesIn(kEngines), [](const auto& one) {
  std::string name;  // "passenger-car": "passengercar"
  std::copy_if(one.param.begin(), one.param.end(), std::back_inserter(name), ::isalpha);
  return name;
});

TEST(StartCase, OfAnUnknownEngineListsThoseThatAreKnown) {
  ASSERT_EQ(::setenv("RINGFILM_DATA", RINGFILM_SOURCE_FOLDER, 1), 0);
  EXPECT_EQ(start_engines(), kEngines);
  try {
    start_case({.engine = "moped"});
    FAIL() << "there is a moped";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(),
                HasSubstr("one of: passenger-car, heavy-duty, hydrogen, light-duty-diesel, turbo-gasoline"));
  }
}

/// Of a trace that was measured in the passenger-car engine.
TraceKeys keys_of(const std::string& path) {
  cycle::Engine engine;
  engine.bore = 89e-3;
  engine.stroke = 79.5e-3;
  engine.connecting_rod_length = 138.1e-3;
  return trace_keys(path, "", engine, Units());
}

TEST(TraceKeys, AskForWhatTheFileDoesNotShow) {
  const ScratchFolder folder;
  write_text(folder / "p.csv", full_trace());
  const TraceKeys keys = keys_of(folder / "p.csv");
  ASSERT_EQ(keys.missing.size(), 1u);
  EXPECT_THAT(keys.missing.front(),
              HasSubstr("gas.pressure_reference: absolute or gauge? The lowest pressure is 1 bar"));
}

/// What is reported of a trace of these rows, all that is asked for or the error.
std::string reported(const std::string& heads, const std::vector<std::pair<double, double>>& rows) {
  const ScratchFolder folder;
  std::string text = heads + "\n";
  for (const auto& [angle, pressure] : rows) text += std::to_string(angle) + "," + std::to_string(pressure) + "\n";
  write_text(folder / "p.csv", text);
  try {
    std::string asked;
    for (const std::string& one : keys_of(folder / "p.csv").missing) asked += one + "\n";
    return asked;
  } catch (const InputError& error) {
    return error.what();
  }
}

/// A bell of 41 bar at 10 degree on 1.2 bar.
std::vector<std::pair<double, double>> bell(double from = -360, double to = 358, double scale = 1) {
  std::vector<std::pair<double, double>> rows;
  for (double angle = from; angle <= to; angle += 2) {
    const double distance = (angle - 10) / 20;
    rows.push_back({angle, scale * (1.2 + 40 / (1 + distance * distance))});
  }
  return rows;
}

const std::string kHeads = "crank_angle [degree],pressure [bar]";

// Angles that fall and cycles behind each other are read; the level of the pressure remains to be asked for.
TEST(TraceKeys, ReadFallingAnglesAndSeveralCycles) {
  auto rows = bell();
  std::reverse(rows.begin(), rows.end());
  EXPECT_THAT(reported(kHeads, rows), HasSubstr("gas.pressure_reference: absolute or gauge?"));
  EXPECT_THAT(reported(kHeads, bell(-360, 1078)), HasSubstr("gas.pressure_reference: absolute or gauge?"));
}

TEST(TraceKeys, RefuseATraceAsACaseDoes) {
  auto rows = bell();
  rows.insert(rows.begin() + 5, rows[4]);
  EXPECT_THAT(reported(kHeads, rows), HasSubstr("the crank angle -352 degree comes twice"));
  EXPECT_THAT(reported(kHeads, bell(-360, 358, 1e-3)), HasSubstr("the highest pressure of the trace is 0.0412 bar"));
  EXPECT_THAT(reported(kHeads, bell(-360, 358, 1e5)), HasSubstr("the highest pressure of the trace is 4.12e+06 bar"));
  EXPECT_THAT(reported("crank_angle [degree],pressure [mm]", bell()),
              HasSubstr("the column pressure is not a pressure: \"mm\" measures something else"));
  rows = bell();
  rows.erase(rows.begin() + 190, rows.begin() + 200);
  EXPECT_THAT(reported(kHeads, rows), HasSubstr("no samples between 18 and 40 degree"));
  EXPECT_THAT(reported(kHeads, bell(-60, 60)), HasSubstr("less than the 180 degree"));
}

TEST(TraceKeys, DoNotTakeADisturbedSampleForAGaugeTrace) {
  auto rows = bell();
  rows[100].second = -0.5;
  EXPECT_THAT(reported(kHeads, rows),
              HasSubstr("gas.pressure_reference: absolute or gauge? One sample alone, at -160 degree"));
  rows[100].second = -50;
  EXPECT_THAT(reported(kHeads, rows), HasSubstr("an absolute pressure is above 0, a gauge pressure is above -1.01325"));
  rows[100].second = rows[101].second = -0.5;
  EXPECT_EQ(reported(kHeads, rows), "");
  EXPECT_EQ(reported("crank_angle (deg),pressure (bara)", bell()), "");
}

TEST(TraceKeys, AskForEverythingAtOnce) {
  const std::string asked = reported("crank_angle,pressure", bell(-180, 180));
  for (const char* key :
       {"gas.pressure_unit", "gas.pressure_reference", "gas.intake_pressure", "gas.exhaust_pressure"}) {
    EXPECT_THAT(asked, HasSubstr(key));
  }
  EXPECT_THAT(asked, ::testing::Not(HasSubstr("gas.angle_unit")));  // 360 radians are not a cycle
  EXPECT_THAT(asked, ::testing::Not(HasSubstr("gas.angle_zero")));
}

TEST(ShippedOils, AreFoundByTheirGrade) {
  ASSERT_EQ(::setenv("RINGFILM_DATA", RINGFILM_SOURCE_FOLDER, 1), 0);
  for (const ShippedOil& oil : shipped_oils(Units())) {
    if (oil.grade.empty()) continue;
    EXPECT_EQ(shipped_oil_of_grade(oil.grade).shown, oil.file);
  }
  EXPECT_THROW(shipped_oil_of_grade("SAE 99"), InputError);
  ASSERT_EQ(::unsetenv("RINGFILM_DATA"), 0);
}

}  // namespace
}  // namespace ringfilm::io
