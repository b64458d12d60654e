#include "ringfilm/io/pad/pad_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "../case_example.hpp"
#include "ringfilm/io/case/case_edit.hpp"
#include "ringfilm/io/pad/pad_output.hpp"

namespace ringfilm::io {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

GapFile gap_of_pad(const std::string& text) {
  const ScratchFolder folder;
  write_text(folder / "gap.csv", text);
  return read_gap({folder / "gap.csv", "gap.csv"}, Units());
}

std::string pad_refusal(const std::string& text) {
  try {
    gap_of_pad(text);
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(PadFile, ReadsAGapInTheUnitsOfItsHeader) {
  const GapFile gap = gap_of_pad("# milled\nx [mm],h [um]\n0,20\n7,20\n7,10\n10,10\n");
  EXPECT_THAT(gap.x, ElementsAre(0, 0.007, 0.007, 0.01));
  EXPECT_THAT(gap.height, ElementsAre(20e-6, 20e-6, 10e-6, 10e-6));
  EXPECT_THAT(gap.notes, ElementsAre(HasSubstr("milled")));
  EXPECT_THAT(gap_of_pad("height [mm];x [m]\n0,02;0\n0,01;0,01\n").height, ElementsAre(0.02e-3, 0.01e-3));
}

TEST(PadFile, TakesItsUnitsFromARowBelowTheNames) {
  EXPECT_THAT(gap_of_pad("x;h\n[mm];[um]\n0;20\n7;10,5\n").height, ElementsAre(20e-6, 10.5e-6));
  EXPECT_THAT(pad_refusal("x;h\nmm;smoot\n0;20\n7;10\n"), HasSubstr("gap.csv:2:4: the column h has an unknown unit"));
}

TEST(PadFile, RefusesStepsThatAreNone) {
  EXPECT_THAT(pad_refusal("x [mm],h [um]\n0,1\n1,1\n1,2\n1,3\n2,1\n"),
              HasSubstr("gap.csv:5:1: this x comes three times"));
  EXPECT_THAT(pad_refusal("x [mm],h [um]\n0,1\n0,2\n2,1\n"), HasSubstr("gap.csv:3:1: a step at an end"));
  EXPECT_THAT(pad_refusal("x [mm],h [um]\n0,1\n2,2\n2,1\n"), HasSubstr("gap.csv:4:1: a step at an end"));
  EXPECT_THAT(pad_refusal("x [mm],h [um]\n0,1\n2,2\n1,1\n"), HasSubstr("gap.csv:4:1: x falls"));
}

TEST(PadFile, RefusesAGapThatNoOilFilmHas) {
  EXPECT_THAT(pad_refusal("x [mm],h [um]\n0,1\n1,9.969e36\n"), HasSubstr("gap.csv:3:3: 9.969e+30 m is not"));
}

TEST(PadFile, ReadsAHistoryOfSeparations) {
  const ScratchFolder folder;
  write_text(folder / "h.csv", "time [ms],separation [um]\n0,10\n2,5\n");
  const SeparationHistory history = read_separation_history({folder / "h.csv", "h.csv"}, Units());
  EXPECT_THAT(history.time, ElementsAre(0, 0.002));
  EXPECT_THAT(history.separation, ElementsAre(10e-6, 5e-6));
}

TEST(PadOutput, WritesAllRowsOfAllInstants) {
  pad::PadResult result;
  result.x = {0, 0.5, 0.5, 1};
  for (const double time : {0.0, 0.25}) {
    result.samples.push_back({});
    result.profiles.push_back({time, {2, 2, 1, 1}, {0, -0.0, 3, 0}, {1, 0.5, 1, 1}});
  }
  EXPECT_EQ(pad_csv(result),
            "time [s],x [m],film_thickness [m],pressure [Pa],film_content\n"
            "0,0,2,0,1\n0,0.5,2,0,0.5\n0,0.5,1,3,1\n0,1,1,0,1\n"
            "0.25,0,2,0,1\n0.25,0.5,2,0,0.5\n0.25,0.5,1,3,1\n0.25,1,1,0,1\n");
}

TEST(PadOutput, OmitsFlowsThatAreNotReported) {
  PadDocument document;
  document.result.x = {0, 1};
  document.result.y = {0, 1};
  document.result.samples.resize(1);
  EXPECT_THAT(pad_json(document), HasSubstr("flow_front"));
  pad::Sample& sample = document.result.samples.front();
  sample.flow_front = sample.flow_back = sample.mass_flow_front = sample.mass_flow_back = std::nan("");
  EXPECT_THAT(pad_json(document), Not(HasSubstr("flow_front")));
  EXPECT_THAT(pad_json(document), Not(HasSubstr("flow_back")));
  EXPECT_THAT(pad_json(document), HasSubstr("total_load"));
  document.result.is_history = true;
  EXPECT_THAT(pad_json(document), Not(HasSubstr("flow_front")));
}

/// A pad that is complete, beside its gap.
class PadFolder {
 public:
  PadFolder() { write_text(folder_ / "gap.csv", "x [mm],h [um]\n0,20\n10,10\n"); }
  cycle::Case read(const std::string& more = "", const std::vector<Override>& overrides = {}) const {
    write_text(folder_ / "pad.toml",
               "[pad]\nlength = \"10 mm\"\ngap = \"gap.csv\"\nspeed = \"5 m/s\"\nleft_pressure = \"0 Pa\"\n"
               "right_pressure = \"-1 bar\"\nseparation = \"1 um\"\n"
               "[lubricant]\nviscosity = \"39 cP\"\ndensity = \"850 kg/m3\"\n" +
                   more);
    return read_case(folder_ / "pad.toml", overrides);
  }

 private:
  ScratchFolder folder_;
};

TEST(PadCase, IsReadWithTheDefaultsOfAPad) {
  const cycle::Case c = PadFolder().read();
  EXPECT_EQ(c.problem, cycle::Problem::kPad);
  EXPECT_DOUBLE_EQ(c.lubricant.viscosity, 0.039);
  EXPECT_EQ(c.lubricant.constant_density, 850);
  EXPECT_EQ(c.lubricant.viscosity_pressure, cycle::ViscosityPressure::kNone);
  EXPECT_EQ(c.lubricant.compressibility, cycle::Compressibility::kNone);
  EXPECT_EQ(c.film.cavitation_pressure, 0);
  EXPECT_EQ(c.pad.right_pressure, -1e5);
  EXPECT_THAT(c.pad.gap_x, ElementsAre(0, 0.01));
}

TEST(PadCase, WrittenOutInFullIsTheSameCaseAgain) {
  const PadFolder folder;
  const cycle::Case c = folder.read("viscosity_pressure = \"barus\"\npressure_viscosity_coefficient = \"2e-8 Pa-1\"\n");
  const ScratchFolder other;
  write_text(other / "again.toml", resolved_case(c));
  const cycle::Case again = read_case(other / "again.toml", {{"pad.gap", c.pad.gap_file}});
  EXPECT_EQ(resolved_case(again), resolved_case(c));
}

TEST(PadCase, AFormulaInPlaceOfAFileLeavesNoPoints) {
  cycle::Case c = PadFolder().read();
  const auto value = [](const char* text) { return parse_toml_value(text); };
  update(c,
         {{"pad.gap", std::nullopt},
          {"pad.face.form", value("\"cosine\"")},
          {"pad.face.crown_height", value("\"10 um\"")}},
         Units());
  EXPECT_THAT(c.pad.gap_x, IsEmpty());
  check_case(c);
  const ScratchFolder other;
  write_text(other / "again.toml", resolved_case(c));
  EXPECT_EQ(resolved_case(read_case(other / "again.toml", {})), resolved_case(c));
}

TEST(PadCase, NegativePressuresAreForPadsAlone) {
  EXPECT_EQ(PadFolder().read("", {{"film.cavitation_pressure", "-1 bar"}}).film.cavitation_pressure, -1e5);
  const CaseFolder ring;
  EXPECT_THROW(ring.read({{"film.cavitation_pressure", "-1 bar"}}), InputError);
}

}  // namespace
}  // namespace ringfilm::io
