#include "ringfilm/io/case/case_edit.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "../case_example.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/io/data/trace_file.hpp"
#include "ringfilm/study/design/scenario.hpp"

namespace ringfilm::io {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

TomlValue text(const std::string& words) { return parse_toml_value(quoted(words)); }

std::string refusal_of_edit(const std::function<void()>& act) {
  try {
    act();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(CaseEdit, StatesAValueAsACaseFileDoes) {
  cycle::Case c = CaseFolder().read();
  const Units units;
  state(c, "operating.speed", text("3000 rpm"), units);
  EXPECT_DOUBLE_EQ(c.operating.speed, 314.15926535897932);
  state(c, "liner.youngs_modulus", text("100 GPa"), units);
  EXPECT_EQ(c.liner.youngs_modulus, 100e9);
  EXPECT_THAT(c.stated, Contains("liner.youngs_modulus"));
  check_case(c);
}

TEST(CaseEdit, LeavesTheCaseAloneWhereAValueIsRefused) {
  cycle::Case c = CaseFolder().read();
  const std::string before = study::digest_text(c);
  const Units units;
  EXPECT_THAT(refusal_of_edit([&] { state(c, "operating.speed", text("3000"), units); }), HasSubstr("has no unit"));
  EXPECT_THAT(refusal_of_edit([&] { state(c, "operating.sped", text("3000 rpm"), units); }),
              HasSubstr("did you mean operating.speed?"));
  EXPECT_THAT(refusal_of_edit([&] { state(c, "gas.cylinder_pressure", text("nothing.csv"), units); }),
              HasSubstr("nothing.csv"));
  EXPECT_EQ(study::digest_text(c), before);
}

TEST(CaseEdit, ChangesKeysThatOnlyFitTogetherAtOnce) {
  const CaseFolder folder;
  cycle::Case c = folder.read();
  const std::string before = study::digest_text(c);
  const Units units;
  std::string rows = "crank_angle [degree],p1 [bar],p2 [bar]\n";
  for (int a = 0; a < 720; a += 5) rows += std::to_string(a) + "," + std::to_string(20 + a / 10) + ",30\n";
  folder.write("two.csv", rows);
  const std::string file = folder / "two.csv";
  EXPECT_THROW(state(c, "gas.cylinder_pressure", text(file), units), TraceKeyError);
  EXPECT_THROW(state(c, "gas.pressure_column", text("p2"), units), TraceKeyError);
  EXPECT_THAT(refusal_of_edit([&] { state(c, "gas.pressure_column", text("p2"), units); }), Not(HasSubstr("update")));
  const std::vector<Change> wrong{{"gas.cylinder_pressure", text(file)},
                                  {"gas.pressure_column", text("p2")},
                                  {"operating.speed", text("2000")},
                                  {"engine.bore", text("-1 mm")}};
  EXPECT_THAT(refusal_of_edit([&] { update(c, wrong, units); }),
              AllOf(HasSubstr("operating.speed"), HasSubstr("engine.bore")));
  EXPECT_EQ(study::digest_text(c), before);
  update(c, {{"gas.pressure_column", text("p2")}, {"gas.cylinder_pressure", text(file)}}, units);
  EXPECT_EQ(c.gas.cylinder_pressure->value.front(), 30e5);
  // And back again: a key is taken out together with its file.
  update(c, {{"gas.pressure_column", std::nullopt}, {"gas.cylinder_pressure", text(folder / "p.csv")}}, units);
  EXPECT_FALSE(c.gas.pressure_column);
}

TEST(CaseEdit, GivesBackTheDefaultOfAKeyThatIsTakenOut) {
  cycle::Case c = CaseFolder().read();
  const Units units;
  state(c, "liner.youngs_modulus", text("100 GPa"), units);
  retract(c, "liner.youngs_modulus", units);
  EXPECT_EQ(c.liner.youngs_modulus, cycle::Liner{}.youngs_modulus);
  EXPECT_THAT(c.stated, Not(Contains("liner.youngs_modulus")));
}

TEST(CaseEdit, ChecksWhatIsMissingUnusedAndAtOdds) {
  cycle::Case c = CaseFolder().read();
  const Units units;
  retract(c, "engine.bore", units);
  EXPECT_THAT(refusal_of_edit([&] { check_case(c); }), HasSubstr("the key engine.bore is missing"));
  state(c, "engine.bore", text("89 mm"), units);
  state(c, "gas.peak_pressure", text("60 bar"), units);
  EXPECT_THAT(refusal_of_edit([&] { check_case(c); }), HasSubstr("gas.peak_pressure is not used in this case"));
  retract(c, "gas.peak_pressure", units);
  check_case(c);
}

TEST(CaseEdit, ReadsATraceAnewWhenItsMeaningChanges) {
  const CaseFolder folder;
  cycle::Case c = folder.read();
  const Units units;
  const double before = c.gas.cylinder_pressure->value.front();
  state(c, "gas.pressure_reference", text("absolute"), units);
  EXPECT_EQ(c.gas.cylinder_pressure->value.front(), before);
  EXPECT_THAT(c.files, Contains(::testing::Field(&cycle::InputFile::role, "gas.cylinder_pressure")).Times(1));
}

}  // namespace
}  // namespace ringfilm::io
