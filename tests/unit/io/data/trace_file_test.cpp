#include "ringfilm/io/data/trace_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "../case_example.hpp"

namespace ringfilm::io {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class Trace : public ::testing::Test {
 protected:
  TraceFile read(const std::string& text, const TraceColumns& stated = {}) {
    write_text(folder_ / "p.csv", text);
    return read_trace({folder_ / "p.csv", "p.csv"}, stated, units_);
  }
  std::string reported(const std::string& text, const TraceColumns& stated = {}) {
    try {
      read(text, stated);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

  ScratchFolder folder_;
  Units units_;
};

TEST_F(Trace, IsReadInAnyUnitOfItsHeader) {
  const auto samples = read("angle [rad],p [bar]\n0,1\n0.157079632679489656,62\n").samples;
  EXPECT_DOUBLE_EQ(samples.crank_angle_deg.at(1), 9);
  EXPECT_THAT(samples.value, ElementsAre(1e5, 62e5));
}

TEST_F(Trace, MayRunOverAnyCycle) {
  std::string text = "crank_angle [degree],p [Pa]\n";
  for (int angle = -180; angle <= 540; angle += 10) text += std::to_string(angle) + ",1e5\n";
  const auto samples = read(text).samples;
  EXPECT_EQ(samples.crank_angle_deg.size(), 73u);
  EXPECT_EQ(samples.crank_angle_deg.front(), -180);
}

TEST_F(Trace, IsTheSameInEveryDressOfItsText) {
  const auto plain = read("crank_angle [degree],p [Pa]\n0,100000.5\n1,2e5\n").samples;
  for (const char* text :
       {"crank_angle [degree],p [Pa]\r\n0,100000.5\r\n1,2e5\r\n", "crank_angle [degree],p [Pa]\r0,100000.5\r1,2e5\r",
        "\xEF\xBB\xBF"
        "crank_angle [degree],p [Pa]\n0,100000.5\n1,2e5\n",
        "# rig 7\n\n# sensor B\ncrank_angle [degree],p [Pa]\n\n0,100000.5\n  \n1,+2e5",
        "\"crank_angle [degree]\",\"p [Pa]\"\n0,100000.5\n1,2e5\n",
        "crank_angle [degree] , p [Pa]\n 0 ,\t100000.5\n1, 2e5 \n", "crank_angle [degree];p [Pa]\n0;100000,5\n1;2e5\n",
        "crank_angle [degree]\tp [Pa]\n0\t100000.5\n1\t2e5\n", "crank_angle [degree],p [Pa],\n0,100000.5,\n1,2e5,\n"}) {
    const auto samples = read(text).samples;
    EXPECT_EQ(samples.crank_angle_deg, plain.crank_angle_deg) << text;
    EXPECT_EQ(samples.value, plain.value) << text;
  }
}

TEST_F(Trace, NotesCommentsByteOrderMarkAndDecimalCommas) {
  EXPECT_THAT(read("# rig 7\ncrank_angle [degree],p [Pa]\n0,1e5\n1,2e5\n").notes, ElementsAre(HasSubstr("# rig 7")));
  EXPECT_THAT(read("\xEF\xBB\xBF"
                   "crank_angle [degree],p [Pa]\n0,1e5\n1,2e5\n")
                  .notes,
              ElementsAre(HasSubstr("byte-order")));
  EXPECT_THAT(read("crank_angle [degree];p [Pa]\n0;1,5e5\n1;2e5\n").notes, ElementsAre(HasSubstr("decimal commas")));
}

TEST_F(Trace, TakesTheNamedColumnOfSeveral) {
  const std::string text = "CAD_0=firing_TDC,p_Pa_load25,p_Pa_load50\n-143,168700,232080\n-142,169310,233920\n";
  TraceColumns stated;
  stated.pressure_unit = "Pa";
  stated.angle_unit = "degree";
  EXPECT_THAT(reported(text, stated), HasSubstr("2 columns of the file may be the pressure"));
  EXPECT_THAT(reported(text, stated), HasSubstr("gas.pressure_column; the file has: CAD_0=firing_TDC, p_Pa_load25"));
  stated.pressure_column = "p_Pa_load50";
  EXPECT_THAT(read(text, stated).samples.value, ElementsAre(232080, 233920));
  stated.pressure_column = "p_Pa_load75";
  EXPECT_THAT(reported(text, stated), HasSubstr("the file has no column p_Pa_load75 (gas.pressure_column)"));
}

TEST_F(Trace, AsksForUnitsOnceAndRefusesContradictions) {
  const std::string bare = "crank_angle,p\n0,1e5\n1,2e5\n";
  EXPECT_THAT(reported(bare), HasSubstr("p.csv:1:1: the column crank_angle has no unit"));
  EXPECT_THAT(reported(bare), HasSubstr("p.csv:1:13: the column p has no unit"));
  EXPECT_THAT(reported(bare), HasSubstr("or state gas.pressure_unit"));
  TraceColumns stated;
  stated.pressure_unit = "bar";
  EXPECT_THAT(reported("crank_angle [degree],p [Pa]\n0,1e5\n1,2e5\n", stated),
              HasSubstr("p.csv:1:22: the file states Pa, gas.pressure_unit states bar"));
  stated.pressure_unit = "Pa";
  EXPECT_EQ(read("crank_angle [degree],p [Pa]\n0,1e5\n1,2e5\n", stated).samples.value.size(), 2u);
}

TEST_F(Trace, TakesItsUnitsFromARowBelowTheNames) {
  for (const char* text :
       {"Crank Angle;PCYL1\ndeg;bar\n0;1,5\n1;2\n", "crank_angle,p\n[deg],(bar)\n0,1.5\n1,2\n",
        "crank_angle\tp\n\u00B0CA\tbara\n0\t1.5\n1\t2\n",
        "crank_angle,p,\n\n# rig 7\n\"degKW\",\"bar\",\n0,1.5,\n1,2,\n", "crank_angle [deg],p\ndeg,bar\n0,1.5\n1,2\n",
        "crank_angle [deg],p\n,bar\n0,1.5\n1,2\n", "crank_angle,p,n\ndeg,bar,-\n0,1.5,3\n1,2,4\n"}) {
    const TraceFile file = read(text);
    EXPECT_THAT(file.samples.crank_angle_deg, ElementsAre(0, 1)) << text;
    EXPECT_THAT(file.samples.value, ElementsAre(1.5e5, 2e5)) << text;
  }
  EXPECT_THAT(read("crank_angle,p\ndeg,bar\n0,1\n1,2\n").notes,
              ElementsAre("p.csv has a row of units in line 2, which was used"));
}

TEST_F(Trace, ReadsUnitsInParenthesesAndNamesWithThem) {
  for (const char* heads : {"CAD (deg),p (bar)", "CAD(deg),p(bar)", "CAD [deg],p (bar)", "CAD (deg),p (cyl 1) (bar)"}) {
    const TraceFile file = read(std::string(heads) + "\n0,1.5\n1,2\n");
    EXPECT_THAT(file.samples.crank_angle_deg, ElementsAre(0, 1)) << heads;
    EXPECT_THAT(file.samples.value, ElementsAre(1.5e5, 2e5)) << heads;
  }
  TraceColumns stated;
  stated.pressure_column = "p_1 (bar)";
  EXPECT_THAT(read("CAD (deg),p_1 (bar),p_2 (bar)\n0,1,2\n1,3,4\n", stated).samples.value, ElementsAre(1e5, 3e5));
  stated.pressure_column = "p_2";
  EXPECT_THAT(read("CAD (deg),p_1 (bar),p_2 (bar)\n0,1,2\n1,3,4\n", stated).samples.value, ElementsAre(2e5, 4e5));
  EXPECT_THAT(reported("CAD (deg),p (cyl 1)\n0,1\n1,2\n"), HasSubstr("the column p (cyl 1) has no unit"));
}

TEST_F(Trace, ComparesTheRowOfUnitsWithWhatIsStated) {
  const std::string rows = "0,1\n1,2\n";
  TraceColumns stated;
  stated.pressure_unit = "MPa";
  EXPECT_THAT(reported("crank_angle,p\ndeg,bar\n" + rows, stated),
              HasSubstr("p.csv:2:5: the file states bar, gas.pressure_unit states MPa"));
  stated.pressure_unit = "bar";
  EXPECT_THAT(read("crank_angle,p\ndeg,bar\n" + rows, stated).samples.value, ElementsAre(1e5, 2e5));
  EXPECT_THAT(reported("crank_angle [deg],p [Pa]\ndeg,bar\n" + rows),
              HasSubstr("p.csv:2:5: the unit of p is bar here and Pa in the header"));
  stated = {};
  stated.reference = cycle::PressureReference::kGauge;
  EXPECT_THAT(reported("crank_angle,p\ndeg,bara\n" + rows, stated), HasSubstr("p.csv:2:5: the unit bara is absolute"));
  EXPECT_THAT(reported("crank_angle,p\ndeg,barg\n" + rows), HasSubstr("p.csv:2:5: the unit barg is gauge"));
}

TEST_F(Trace, RefusesAnUnknownUnitInTheRowOfUnits) {
  EXPECT_THAT(reported("crank_angle,p\ndeg,kp/cmm\n0,1\n1,2\n"),
              ::testing::AllOf(HasSubstr("p.csv:2:5: the column p has an unknown unit \"kp/cmm\""),
                               HasSubstr("a pressure is in bar, Pa, kPa or MPa")));
  TraceColumns stated;
  stated.pressure_column = "p";
  EXPECT_THAT(reported("crank_angle,p\ndeg,kp/cmm\n0,1\n1,2\n", stated),
              HasSubstr("p.csv:2:5: the column p has an unknown unit \"kp/cmm\""));
  EXPECT_THAT(reported("crank_angle;p\n-;bar\n0;1\n1;2\n"),
              HasSubstr("p.csv:2:1: the column crank_angle is dimensionless, not an angle"));
  // Text between the numbers, or below the units, is not a row of units.
  EXPECT_THAT(reported("crank_angle,p\ndeg,3 bar\n0,1\n1,2\n"), HasSubstr("p.csv:2:1: \"deg\" is not a number"));
  EXPECT_THAT(reported("crank_angle,p\ndeg,bar\ndeg,bar\n1,2\n"), HasSubstr("p.csv:3:1: \"deg\" is not a number"));
}

TEST_F(Trace, RefusesWhatIsNotATraceWithLineAndColumn) {
  const std::string head = "crank_angle [degree],p [Pa]\n";
  EXPECT_THAT(reported(head), HasSubstr("p.csv: the file has no row of numbers"));
  EXPECT_THAT(reported(head + "0,1e5\n"), HasSubstr("p.csv: the file has only one row of numbers"));
  EXPECT_THAT(reported("0,1e5\n1,2e5\n"), HasSubstr("p.csv:1:1: the first line must name the columns"));
  EXPECT_THAT(reported(head + "0,1e5\n1,2e5\n1,3e5\n"), HasSubstr("p.csv:4:1: the crank angle 1 degree comes twice"));
  EXPECT_THAT(reported(head + "0,1e5\n2,2e5\n1,3e5\n"),
              HasSubstr("p.csv:4:1: the crank angle falls from 2 to 1 degree"));
  EXPECT_THAT(reported(head + "0,1e5\n1,nan\n2,inf\n"), HasSubstr("p.csv:3:3: nan is not a finite number"));
  EXPECT_THAT(reported(head + "0,1e5\n1,nan\n2,inf\n"), HasSubstr("p.csv:4:3: inf is not a finite number"));
  EXPECT_THAT(reported(head + "0,1e5\n1,high\n"), HasSubstr("p.csv:3:3: \"high\" is not a number"));
  EXPECT_THAT(reported(head + "0,1e5\n1,\n"), HasSubstr("p.csv:3:3: a value is missing"));
  EXPECT_THAT(reported(head + "0,1e5\n1\n"), HasSubstr("p.csv:3:1: the row has 1 values, the header names 2 columns"));
  EXPECT_THAT(reported(head + "0,0,100000,5\n0,1,100000,6\n"), HasSubstr("separate the columns by semicolons"));
  EXPECT_THAT(reported(head + "0,1e5\n721,2e5\n"), HasSubstr("the crank angles span 721 degree"));
  EXPECT_THAT(reported("crank_angle [degree],p [N]\n0,1\n1,2\n"),
              HasSubstr("p.csv:1:22: the column p is not a pressure: \"N\" measures something else"));
  EXPECT_THAT(reported("crank_angle [degree],x [N]\n0,1\n1,2\n"), HasSubstr("no column of the file is a pressure"));
  EXPECT_THAT(reported("t [s],p [Pa]\n0,1e5\n1,2e5\n"), HasSubstr("no column of the file is a crank angle"));
}

TEST_F(Trace, RefusesPressuresThatCannotBe) {
  const std::string head = "crank_angle [degree],p [Pa]\n";
  EXPECT_THAT(reported(head + "0,-500\n1,6e6\n"),
              HasSubstr("p.csv:2:3: the pressure is -500 Pa; an absolute pressure is above 0"));
  EXPECT_THAT(reported(head + "0,0\n1,6e6\n"), HasSubstr("the pressure is 0 Pa; an absolute pressure is above 0"));
  EXPECT_THAT(reported(head + "0,-500\n1,6e6\n"), HasSubstr("gas.pressure_reference = \"gauge\""));
  EXPECT_THAT(reported(head + "0,1e5\n1,6e6\n2,-5e6\n"),
              ::testing::AllOf(HasSubstr("one sample alone"), ::testing::Not(HasSubstr("\"gauge\""))));
  EXPECT_THAT(reported(head + "0,-5e6\n1,-5e6\n2,6e6\n"), HasSubstr("is the unit of the trace right?"));
  TraceColumns gauge;
  gauge.reference = cycle::PressureReference::kGauge;
  EXPECT_THAT(read(head + "0,-500\n1,6e6\n", gauge).samples.value, ElementsAre(-500, 6e6));
  EXPECT_THAT(reported(head + "0,1\n1,62\n"), HasSubstr("the highest pressure of the trace is 0.00062 bar"));
  EXPECT_THAT(reported(head + "0,1\n1,62\n"), HasSubstr("between 0.5 and 1000 bar"));
  for (const char* missing : {"-9999", "-9999.0"}) {
    EXPECT_THAT(reported("crank_angle [degree],p [bar]\n0,1\n1," + std::string(missing) + "\n2,-9999\n"),
                HasSubstr("If the number marks a missing sample, write nan in its place"));
  }
}

TEST_F(Trace, UnitsThatStateTheReferenceAgreeWithTheKeyOrAreRefused) {
  TraceColumns gauge;
  gauge.reference = cycle::PressureReference::kGauge;
  const auto trace = [](const std::string& unit) { return "crank_angle [degree],p [" + unit + "]\n0,1\n1,62\n"; };
  for (const char* unit : {"barg", "bar(g)", "bar (gauge)", "bar rel"}) {
    EXPECT_THAT(read(trace(unit), gauge).samples.value, ElementsAre(1e5, 62e5)) << unit;
    EXPECT_THAT(reported(trace(unit)), HasSubstr("is gauge, but gas.pressure_reference = \"absolute\"")) << unit;
  }
  for (const char* unit : {"bara", "bar abs", "bar (absolute)"}) {
    EXPECT_THAT(read(trace(unit)).samples.value, ElementsAre(1e5, 62e5)) << unit;
    EXPECT_THAT(reported(trace(unit), gauge), HasSubstr("is absolute, but gas.pressure_reference = \"gauge\"")) << unit;
  }
  EXPECT_THAT(read(trace("psig"), gauge).samples.value.front(), ::testing::DoubleNear(6894.757, 0.001));
  EXPECT_THAT(reported(trace("bar x"), gauge), HasSubstr("unknown unit"));
}

TEST_F(Trace, WorkbooksNameHowToExport) {
  EXPECT_THAT(reported("PK\x03\x04 [Content_Types].xml"), HasSubstr("save the table as CSV"));
  EXPECT_THAT(reported("MATLAB 5.0 MAT-file, Platform: GLNXA64"), HasSubstr("writematrix"));
}

TEST_F(Trace, NumberedColumnsMayBeCycles) {
  EXPECT_THAT(reported("CA [deg],p1 [bar],p2 [bar],p3 [bar]\n0,1,1,1\n1,2,2,2\n"),
              HasSubstr("or all, with one cycle each, with \"p*\""));
  EXPECT_EQ(pattern_of_cycles({"Cycle 1", "Cycle 2", "Cycle 3"}), "Cycle *");
  for (const std::vector<std::string>& others : {std::vector<std::string>{"p_cyl", "p_intake"}, {"p25", "p50"}, {}}) {
    EXPECT_EQ(pattern_of_cycles(others), "");
  }
}

TEST_F(Trace, CommasThatMayPartThousandsAreRefused) {
  EXPECT_THAT(reported("angle [deg]\tp [kPa]\n0\t998\n1\t4,573\n2\t1,100\n"),
              HasSubstr("p.csv:3:3: \"4,573\" may be 4573 or 4.573"));
  EXPECT_THAT(read("\"angle [deg]\",\"p [bar]\"\n\"0\",\"1,0000\"\n\"1\",\"1,5009\"\n").samples.value,
              ElementsAre(1e5, 1.5009e5));
}

TEST_F(Trace, ACommentNamesTheColumnsAsAHeaderWould) {
  for (const char* header : {"# CA_deg,Pcyl_bar", "#CA(deg),P(bar)", "# Crank angle / deg,Pressure / bar"}) {
    EXPECT_THAT(read(std::string(header) + "\n0,1\n1,62\n").samples.value, ElementsAre(1e5, 62e5)) << header;
  }
}

TEST_F(Trace, TheOutlineHasTheNotesOfTheText) {
  write_text(folder_ / "p.csv", "Rig 7\nCA [deg];p [bar]\n0;1,5\n1;62\nEND\n");
  const TraceOutline seen = trace_outline({folder_ / "p.csv", "p.csv"}, units_);
  EXPECT_THAT(seen.notes, ElementsAre(::testing::AllOf(HasSubstr("decimal commas"), HasSubstr("END"))));
}

TEST_F(Trace, CrankcaseMayBeNearTheAtmosphere) {
  TraceColumns crankcase;
  crankcase.reference = cycle::PressureReference::kGauge;
  crankcase.place = TracePlace::kCrankcase;
  EXPECT_THAT(read("crank_angle [degree],p [mbar]\n0,30\n5,-20\n", crankcase).samples.value, ElementsAre(3000, -2000));
  EXPECT_THAT(reported("crank_angle [degree],p [mbar]\n0,30\n5,-1020\n", crankcase),
              HasSubstr("gauge pressure is above -1.01325 bar"));
}

TEST_F(Trace, RepeatsAfterACycleOrIsReported) {
  std::string head = "crank_angle [degree],p [bar]\n0,20\n";
  for (int angle = 10; angle < 720; angle += 10) head += std::to_string(angle) + ",10\n";
  head += "720,";
  EXPECT_THAT(read(head + "20.01\n").notes, ::testing::IsEmpty());
  EXPECT_THAT(read(head + "20.5\n").notes, ElementsAre(HasSubstr("20.5 bar one cycle later, at 720 degree")));
  EXPECT_THAT(reported(head + "90\n"),
              HasSubstr("p.csv:74:5: the pressure is 20 bar at 0 degree and 90 bar one cycle"));
}

TEST_F(Trace, HoleInsideIsReportedAsTheHole) {
  std::string text = "crank_angle [degree],p [bar]\n";
  for (int angle = 0; angle < 720; ++angle) {
    if (angle <= 400 || angle >= 411) text += std::to_string(angle) + "," + (angle < 90 ? "9" : "2") + "\n";
  }
  EXPECT_THAT(reported(text), HasSubstr("no samples between 400 and 411 degree"));
}

// However coarse the trace is elsewhere: the manual promises 10 degree to every trace.
TEST_F(Trace, SamplesAreNowhereMoreThanTenDegreesApart) {
  const std::string head = "crank_angle [degree],p [bar]\n";
  EXPECT_THAT(reported(head + "0,62\n180,2\n360,1\n540,1\n"),
              ::testing::AllOf(HasSubstr("p.csv:3:1: no samples between 0 and 180 degree, nor in 2 more steps"),
                               HasSubstr("10 degree apart at the most")));
  const auto every = [&](int step) {
    std::string text = head;
    for (int angle = 0; angle < 720; angle += step) text += std::to_string(angle) + ",1\n";
    return text;
  };
  EXPECT_EQ(reported(every(10)), "");
  EXPECT_THAT(reported(every(12)), HasSubstr("no samples between 0 and 12 degree"));
  TraceColumns crankcase;
  crankcase.place = TracePlace::kCrankcase;
  EXPECT_THAT(reported(every(12), crankcase), HasSubstr("no samples between 0 and 12 degree"));
}

TEST(PartialTrace, OfOneRevolutionIsRefusedWithTheCycleThatIsExpected) {
  const CaseFolder folder;
  std::string text = "crank_angle [degree],p [bar]\n";
  for (int angle = 0; angle <= 360; ++angle) text += std::to_string(angle) + ",2\n";
  folder.write("p.csv", text);
  EXPECT_THAT(folder.faults(), HasSubstr("0 to 360 degree of the cycle, one revolution; a four-stroke cycle of 720 "
                                         "degrees is expected, and gas.intake_pressure is not stated"));
}

TEST(PartialTrace, RequiresThePressuresThatJoinIt) {
  const CaseFolder folder;
  std::string text = "crank_angle [degree],p [bar]\n";
  for (int angle = -143; angle <= 123; ++angle) text += std::to_string(angle) + ",2\n";
  folder.write("p.csv", text);
  EXPECT_THAT(
      folder.faults(),
      HasSubstr("the trace covers only -143 to 123 degree of the cycle, and gas.intake_pressure is not stated"));
  EXPECT_THAT(folder.faults(), HasSubstr("gas.exhaust_pressure is not stated"));
  // All that is missing is reported at once.
  EXPECT_THAT(folder.faults({{"gas.pressure_reference", ""}}),
              ::testing::AllOf(HasSubstr("the key gas.pressure_reference is missing"),
                               HasSubstr("gas.intake_pressure is not stated"),
                               HasSubstr("gas.exhaust_pressure is not stated")));
  EXPECT_EQ(folder.faults({{"gas.intake_pressure", "1.6 bar"}, {"gas.exhaust_pressure", "1.9 bar"}}), "");
  EXPECT_THAT(CaseFolder().faults({{"gas.intake_pressure", "1.6 bar"}}),
              HasSubstr("gas.intake_pressure is not used in this case"));
}

TEST(WholeTrace, EndsTenDegreesBeforeItBeginsAgainAtTheMost) {
  const CaseFolder folder;
  const auto write_until = [&](int last) {
    std::string text = "crank_angle [degree],p [bar]\n";
    for (int angle = 0; angle <= last; angle += 5) text += std::to_string(angle) + (angle < 90 ? ",9\n" : ",1\n");
    folder.write("p.csv", text);
  };
  write_until(710);
  EXPECT_EQ(folder.faults(), "");
  write_until(705);
  EXPECT_THAT(folder.faults(), HasSubstr("the trace has no samples between 705 and 720 degree"));
  EXPECT_THAT(folder.faults(), ::testing::Not(HasSubstr("gas.intake_pressure is not stated")));
}

TEST(CrankcaseTrace, SharesReferenceAndZeroWithTheCylinder) {
  CaseText text;
  text.gas += "crankcase_pressure = \"crankcase.csv\"\n";
  const CaseFolder folder(text);
  EXPECT_THAT(folder.faults(),
              HasSubstr("case.toml:13:22: gas.crankcase_pressure: crankcase.csv: there is no such file"));
  std::string trace = "crank_angle [degree],p [bar]\n";
  for (int angle = 0; angle < 720; angle += 10) trace += std::to_string(angle) + ",1.1\n";
  folder.write("crankcase.csv", trace);
  ASSERT_TRUE(folder.read().gas.crankcase_trace.has_value());
  folder.write("crankcase.csv", "crank_angle [degree],p [bar]\n0,1\n10,1.1\n");
  EXPECT_THAT(folder.faults(), HasSubstr("the trace of gas.crankcase_pressure covers only a part of the cycle"));
}

TEST(MeasuredHeavyDutyTrace, IsReadByItsColumns) {
  const std::string path = std::string(RINGFILM_SOURCE_FOLDER) + "/../shared/data/pressure_hd_1200rpm_libicepost.csv";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no measured traces beside the checkout: " << path;
  TraceColumns stated;
  stated.pressure_unit = "Pa";
  stated.angle_unit = "degree";
  stated.pressure_column = "p_Pa_load100";
  const auto samples = read_trace({path, path}, stated, Units()).samples;
  // As published with the file: -143 to 123 degrees by 1 degree, peak 233 bar.
  ASSERT_EQ(samples.value.size(), 267u);
  EXPECT_EQ(samples.crank_angle_deg.front(), -143);
  EXPECT_NEAR(*std::max_element(samples.value.begin(), samples.value.end()), 233e5, 0.5e5);
}

}  // namespace
}  // namespace ringfilm::io
