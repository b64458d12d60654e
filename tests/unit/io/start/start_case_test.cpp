#include "ringfilm/io/start/start_case.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include "../case_example.hpp"
#include "ringfilm/cycle/case/case_fields.hpp"
#include "ringfilm/io/case/case_file.hpp"
#include "ringfilm/io/start/trace_keys.hpp"
#include "ringfilm/io/storage/shipped_oils.hpp"

namespace ringfilm::io {
namespace {

using ::testing::HasSubstr;

class StartCaseOf : public ::testing::TestWithParam<std::string> {
 protected:
  void SetUp() override { ASSERT_EQ(::setenv("RINGFILM_DATA", RINGFILM_SOURCE_FOLDER, 1), 0); }
  void TearDown() override { ASSERT_EQ(::unsetenv("RINGFILM_DATA"), 0); }
};

TEST_P(StartCaseOf, CanBeReadUnchanged) {
  const ScratchFolder folder;
  const StartCase start = start_case({GetParam(), std::nullopt, ""});
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
  const std::string text = start_case({GetParam(), std::nullopt, ""}).text;
  for (const cycle::Field& field : cycle::case_fields()) {
    if (!cycle::belongs(field, cycle::Case{})) continue;  // the case that it starts is a cycle
    const std::string name = field.key.substr(field.key.rfind('.') + 1);
    EXPECT_TRUE(text.find("\n" + name + " = ") != std::string::npos ||
                text.find("\n# " + name + " = ") != std::string::npos)
        << field.key;
  }
}

INSTANTIATE_TEST_SUITE_P(Engines, StartCaseOf, ::testing::ValuesIn(start_engines()),
                         [](const auto& one) { return one.param == "passenger-car" ? "PassengerCar" : "HeavyDuty"; });

TEST(StartCase, OfAnUnknownEngineListsThoseThatAreKnown) {
  try {
    start_case({"moped", std::nullopt, ""});
    FAIL() << "there is a moped";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("one of: passenger-car, heavy-duty"));
  }
}

TEST(TraceKeys, AskForWhatTheFileDoesNotShow) {
  const ScratchFolder folder;
  write_text(folder / "p.csv", full_trace());
  const TraceKeys keys = trace_keys(folder / "p.csv", "", Units());
  ASSERT_EQ(keys.missing.size(), 1u);
  EXPECT_THAT(keys.missing.front(),
              HasSubstr("gas.pressure_reference: absolute or gauge? The lowest pressure is 1 bar"));
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
