#include "ringfilm/io/measurement/force_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "../case_example.hpp"

namespace ringfilm::io {
namespace {

using ::testing::HasSubstr;

ForceFile read_text(const std::string& text) {
  const ScratchFolder folder;
  write_text(folder / "f.csv", text);
  return read_force({folder / "f.csv", "f.csv"}, Units());
}

std::string reported_of_forces(const std::string& text) {
  try {
    read_text(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::string rows(const std::string& load, const std::string& loop, int count, double tmr) {
  std::string text;
  for (int i = 0; i < count; ++i) {
    text += load + "," + loop + (loop.empty() ? "" : ",") + std::to_string(i) + "," + std::to_string(300 + tmr) + "," +
            std::to_string(300 - tmr) + "\n";
  }
  return text;
}

const std::string kHeader = "load [nN],position [um],trace [mV],retrace [mV]\n";
const std::string kNumbered = "load [nN],loop,position [um],trace [mV],retrace [mV]\n";

TEST(ForceFile, ReadsLoopsAndTheSample) {
  const ForceFile force =
      read_text("# sample: new ring, spot 3\n" + kHeader + rows("10", "", 12, 5) + rows("20", "", 11, 9));
  EXPECT_EQ(force.sample, "new ring, spot 3");
  EXPECT_EQ(force.load_unit, surface::LoadUnit::kNewton);
  ASSERT_EQ(force.loops.size(), 2u);
  EXPECT_DOUBLE_EQ(force.loops[1].load, 20e-9);
  EXPECT_EQ(force.loops[1].position_m.size(), 11u);
  EXPECT_NEAR(surface::loop_friction(force.loops[0], 0.1).tmr_V, 5e-3, 1e-15);
  EXPECT_TRUE(force.loads.empty());
}

TEST(ForceFile, DistinguishesLoopsByNumberOrPosition) {
  EXPECT_EQ(read_text(kNumbered + rows("10", "1", 12, 5) + rows("10", "2", 12, 6)).loops.size(), 2u);
  EXPECT_EQ(read_text(kHeader + rows("10", "", 12, 5) + rows("10", "", 12, 6)).loops.size(), 2u);
}

TEST(ForceFile, ReadsLoadsInVolts) {
  const ForceFile force = read_text("load [V],tmr [mV]\n0.5,10\n1,20\n");
  EXPECT_EQ(force.load_unit, surface::LoadUnit::kVolt);
  ASSERT_EQ(force.loads.size(), 2u);
  EXPECT_DOUBLE_EQ(force.loads[0].load, 0.5);
  EXPECT_DOUBLE_EQ(force.loads[1].tmr_V, 0.02);
  EXPECT_EQ(force.loads[1].loops, 1);
  EXPECT_EQ(force.loads[1].tmr_deviation_V, 0);
}

TEST(ForceFile, ReadsDeviationsOfASummary) {
  const ForceFile force =
      read_text("load [nN],tmr [mV],load_deviation [nN],tmr_deviation [mV],loops\n5,10,0.1,0.5,4\n9,20,0.2,0.6,5\n");
  EXPECT_DOUBLE_EQ(force.loads[1].load_deviation, 0.2e-9);
  EXPECT_DOUBLE_EQ(force.loads[1].tmr_deviation_V, 0.6e-3);
  EXPECT_EQ(force.loads[1].loops, 5);
}

TEST(ForceFile, ReportsFileAndLineOfAFault) {
  EXPECT_THAT(reported_of_forces(kHeader + rows("10", "", 3, 5) + rows("20", "", 12, 5)),
              HasSubstr("f.csv:2:1: the friction loop that begins here has only 3 positions"));
  EXPECT_THAT(reported_of_forces(kNumbered + rows("10", "1", 12, 5) + "10,1,4,305,295\n"),
              HasSubstr("f.csv:14:6: the position does not rise"));
  EXPECT_THAT(reported_of_forces(kNumbered + rows("10", "1.5", 12, 5)),
              HasSubstr("f.csv:2:4: loop is not a whole number"));
  EXPECT_THAT(reported_of_forces("load [nN],tmr [mV],tmr_deviation [mV]\n1,2,0.1\n2,3,0\n"),
              HasSubstr("f.csv:3:5: the standard"));
  EXPECT_THAT(reported_of_forces("load [nN],tmr [mV],load_deviation [nN]\n1,2,-0.1\n2,3,0\n"),
              HasSubstr("f.csv:2:5: a standard"));
}

TEST(ForceFile, AsksForUnitsAndColumns) {
  EXPECT_THAT(reported_of_forces("load,tmr [mV]\n1,2\n2,3\n"), HasSubstr("the column load has no unit"));
  EXPECT_THAT(reported_of_forces("load [bar],tmr [mV]\n1,2\n2,3\n"), HasSubstr("f.csv:1:1: the column load"));
  EXPECT_THAT(reported_of_forces("load [nN],tmr [nN]\n1,2\n2,3\n"), HasSubstr("the column tmr"));
  EXPECT_THAT(reported_of_forces("load [nN],trace [mV]\n1,2\n2,3\n"), HasSubstr("the file has no column retrace"));
  EXPECT_THAT(reported_of_forces("load [nN],friction [mV]\n1,2\n2,3\n"),
              HasSubstr("neither friction loops nor their summary"));
  EXPECT_THAT(reported_of_forces("load [nN],tmr [mV],trace [mV]\n1,2,3\n2,3,4\n"), HasSubstr("in one table"));
}

}  // namespace
}  // namespace ringfilm::io
