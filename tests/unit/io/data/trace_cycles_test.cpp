#include "ringfilm/io/data/trace_cycles.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "../case_example.hpp"
#include "ringfilm/io/data/trace_file.hpp"

namespace ringfilm::io {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;

/// A pressure whose peak is `peak` bar at 10 degree.
double bar_at(int angle, double peak) { return 1 + (peak - 1) * std::exp(-std::pow((angle - 10) / 40.0, 2)); }

class TraceCycles : public ::testing::Test {
 protected:
  TraceFile read(const std::string& text, TraceColumns stated = {}) {
    write_text(folder_ / "p.csv", text);
    stated.reference = cycle::PressureReference::kAbsolute;
    return read_trace({folder_ / "p.csv", "p.csv"}, stated, units_);
  }
  static std::string cycle_rows(double peak, const std::string& front = "", int from = -360, int to = 360) {
    std::string rows;
    for (int angle = from; angle < to; ++angle) rows += fmt::format("{}{},{:.9f}\n", front, angle, bar_at(angle, peak));
    return rows;
  }

  ScratchFolder folder_;
  Units units_;
  const std::string head_ = "angle [deg],p [bar]\n";
};

TEST_F(TraceCycles, CyclesBehindEachOtherGiveTheirMeanMedianOrOneOfThem) {
  const std::string text = head_ + cycle_rows(50) + cycle_rows(60) + cycle_rows(76);
  const auto peak_of = [&](const char* cycle) {
    TraceColumns stated;
    if (cycle != nullptr) stated.cycle = cycle;
    const TraceFile trace = read(text, stated);
    EXPECT_EQ(trace.samples.value.size(), 720u);
    EXPECT_EQ(trace.samples.crank_angle_deg.front(), -360);
    return trace.samples.value[370];
  };
  EXPECT_NEAR(peak_of(nullptr), 62e5, 1);
  EXPECT_NEAR(peak_of("mean"), 62e5, 1);
  EXPECT_NEAR(peak_of("median"), 60e5, 1);
  EXPECT_NEAR(peak_of("3"), 76e5, 1);
  // Deviation of 50, 60 and 76: 13.1 bar, 21 % of 62.
  EXPECT_THAT(read(text).notes, Contains(AllOf(HasSubstr("p.csv has 3 cycles, and their mean was taken (gas.cycle)"),
                                               HasSubstr("62 bar on the mean with a standard deviation of 21 %"))));
  for (const char* wrong : {"4", "0", "average"}) {
    TraceColumns stated;
    stated.cycle = wrong;
    EXPECT_THROW(read(text, stated), InputError) << wrong;
  }
}

TEST_F(TraceCycles, ACycleNumberOrAnglesThatGoOnAreCyclesToo) {
  EXPECT_NEAR(read("cycle,angle [deg],p [bar]\n" + cycle_rows(50, "1,") + cycle_rows(60, "2,")).samples.value[370],
              55e5, 1);
  std::string rows;
  for (int angle = -360; angle < 1080; ++angle) {
    rows += fmt::format("{},{:.9f}\n", angle, bar_at(angle < 360 ? angle : angle - 720, angle < 360 ? 50 : 60));
  }
  EXPECT_NEAR(read(head_ + rows).samples.value[370], 55e5, 1);
}

TEST_F(TraceCycles, AStartInMidCycleIsJoinedAndAPartAtTheEndIsOmitted) {
  TraceFile trace = read(head_ + cycle_rows(50, "", 100, 360) + cycle_rows(50, "", -360, 100));
  EXPECT_EQ(trace.samples.value.size(), 720u);
  EXPECT_EQ(trace.samples.crank_angle_deg.front(), 100);
  EXPECT_EQ(trace.samples.crank_angle_deg.back(), 819);
  trace = read(head_ + cycle_rows(50) + cycle_rows(60) + cycle_rows(90, "", -360, -100));
  EXPECT_NEAR(trace.samples.value[370], 55e5, 1);
  EXPECT_THAT(trace.notes, Contains(HasSubstr("the last 260 degree, a part of a cycle, were omitted")));
}

TEST_F(TraceCycles, FallingAnglesAreTurned) {
  std::string rows;
  for (int angle = 359; angle >= -360; --angle) rows += fmt::format("{},{:.9f}\n", angle, bar_at(angle, 50));
  const TraceFile turned = read(head_ + rows), plain = read(head_ + cycle_rows(50));
  EXPECT_EQ(turned.samples.crank_angle_deg, plain.samples.crank_angle_deg);
  EXPECT_EQ(turned.samples.value, plain.samples.value);
  EXPECT_THAT(turned.notes, Contains(HasSubstr("the rows were turned about")));
}

TEST_F(TraceCycles, ColumnsThatAPatternNamesAreCycles) {
  std::string rows;
  for (int angle = -360; angle < 360; ++angle)
    rows += fmt::format("{},{:.9f},{:.9f}\n", angle, bar_at(angle, 50), bar_at(angle, 60));
  const std::string text = "angle [deg],p1 [bar],p2 [bar]\n" + rows;
  TraceColumns stated;
  stated.pressure_column = "p*";
  EXPECT_NEAR(read(text, stated).samples.value[370], 55e5, 1);
  EXPECT_THROW(read(text), InputError) << "two pressures may be two cylinders";
}

TEST_F(TraceCycles, ARowWithoutANumberIsOmittedAndNoted) {
  std::string text = head_ + cycle_rows(50);
  const std::size_t at = text.find("\n-200,") + 6;
  text.replace(at, text.find('\n', at) - at, "NaN");
  const TraceFile trace = read(text);
  EXPECT_EQ(trace.samples.value.size(), 719u);
  EXPECT_THAT(trace.notes, Contains(HasSubstr("1 row without a number omitted, the first in line 162")));
}

TEST_F(TraceCycles, TheHeadersThatPeopleHave) {
  const TraceFile plain = read(head_ + cycle_rows(50));
  const std::string rows = cycle_rows(50);
  for (const std::string& text :
       {"CA_deg,Pcyl_bar\n" + rows, "Crank angle / deg,Pressure / bar\n" + rows,
        "\"Crank angle, deg\",\"p, bar\"\n" + rows, "Test 17, engine 3, 1500 rpm\n" + head_ + rows,
        head_ + rows + "END OF DATA\n", "KW [\xB0KW],p [bar]\n" + rows}) {
    const TraceFile trace = read(text);
    EXPECT_EQ(trace.samples.value, plain.samples.value) << text.substr(0, 60);
    EXPECT_EQ(trace.samples.crank_angle_deg, plain.samples.crank_angle_deg) << text.substr(0, 60);
  }
  TraceColumns stated;
  stated.table.columns = "angle [deg], p [bar]";
  EXPECT_EQ(read(rows, stated).samples.value, plain.samples.value);
  try {
    read("time [ms],p [bar]\n" + rows);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(std::string(error.what()), HasSubstr("at n rpm it grows by 6 n degree per second"));
  }
}

}  // namespace
}  // namespace ringfilm::io
