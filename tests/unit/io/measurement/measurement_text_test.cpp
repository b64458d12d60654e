#include "ringfilm/io/measurement/measurement_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <sstream>

#include "../measurement_example.hpp"

namespace ringfilm::io {
namespace {

using testing::HasSubstr;

const double kNone = std::numeric_limits<double>::quiet_NaN();

std::string number(double value, double error, const char* unit = "m", const char* shown_in = "um") {
  MeasuredValue described;
  described.unit = unit;
  described.display_unit = shown_in;
  return measured_number(described, value, error, Units());
}

TEST(MeasuredNumber, RoundsTheErrorUpAndTheValueToItsPlace) {
  EXPECT_EQ(number(0.41234e-6, 0.0123e-6), "0.412 +- 0.013");
  EXPECT_EQ(number(0.41234e-6, 0.0323e-6), "0.41 +- 0.04");
  EXPECT_EQ(number(5120e-6, 230e-6), "5100 +- 300");
  EXPECT_EQ(number(-1.62, 0.11, "1", "1"), "-1.62 +- 0.11");
  EXPECT_EQ(number(0, 0.2e-6), "0.0 +- 0.2");
}

TEST(MeasuredNumber, HasFourDigitsWithoutAnError) {
  EXPECT_EQ(number(0.31234e-6, kNone), "0.3123");
  EXPECT_EQ(number(31234e-6, kNone), "31234");
  EXPECT_EQ(number(0, kNone), "0");
  EXPECT_EQ(number(0.3, 0.0, "m", ""), "0.3000");
}

TEST(MeasuredNumber, WritesACountAsOne) {
  EXPECT_EQ(number(1624, kNone, "1", "1"), "1624");
  EXPECT_EQ(number(-3, kNone, "1", ""), "-3");
  EXPECT_EQ(number(3e-6, kNone), "3.000");
  EXPECT_EQ(number(3, 1, "1", "1"), "3.0 +- 1.0");
}

TEST(MeasuredNumber, TakesPowersOfTenFarFromOne) {
  EXPECT_EQ(number(1.23456e-16, kNone, "m", "m"), "1.235e-16");
  EXPECT_EQ(number(1.23456e9, 2.1e7, "m-2", ""), "(1.23 +- 0.03)e9");
}

TEST(MeasuredNumber, IsNoneWithoutAValue) { EXPECT_EQ(number(kNone, 0.1), "none"); }

TEST(MeasuredNumber, GivesTheSpreadOfATemperatureWithoutItsOffset) {
  EXPECT_EQ(number(293.15, 2.0, "K", "degC"), "20 +- 2");
}

TEST(MeasurementText, NamesFilterAndPixelBesideEachParameter) {
  const std::string text = measurement_text(example::measurement(), Units());
  EXPECT_THAT(text, HasSubstr("read: cases/measured/liner.x3p"));
  EXPECT_THAT(text, HasSubstr("done: a plane was removed"));
  EXPECT_THAT(text, HasSubstr("note: N depends on the cut-off"));
  std::istringstream lines(text);
  int n_found = 0;
  for (std::string line; std::getline(lines, line);) {
    EXPECT_LE(line.size(), 100u) << line;
    if (line.find("0.412 +- 0.013  um") == std::string::npos) continue;
    ++n_found;
    EXPECT_THAT(line, HasSubstr("Sq "));
    EXPECT_THAT(line, HasSubstr("root mean square height"));
    EXPECT_THAT(line, HasSubstr("Gaussian filter 0.8 mm"));
  }
  EXPECT_EQ(n_found, 1);
}

TEST(MeasurementText, SetsColumnsUnderTheirUnits) {
  const std::string text = measurement_text(example::measurement(), Units());
  EXPECT_THAT(text, HasSubstr("\nEach region\n"
                              "           N   beta\n"
                              "      [um-2]   [um]\n"
                              "  1  0.03830  5.100\n"
                              "  2  0.04120   none\n"));
}

TEST(MeasurementText, BreaksATableThatIsTooWideIntoBlocks) {
  Measurement document;
  MeasuredTable wide{"wide", "Wide", {}, {}, {"row"}};
  for (int i = 0; i < 15; ++i) {
    wide.columns.push_back({"column_" + std::to_string(i), "", "", "1", "1", kNone, kNone, ""});
    wide.values.push_back({1000.0 + i});
  }
  document.tables = {wide};
  const std::string text = measurement_text(document, Units());
  std::istringstream lines(text);
  int n_rows = 0;
  for (std::string line; std::getline(lines, line);) {
    EXPECT_LE(line.size(), 100u) << line;
    n_rows += line.rfind("  row", 0) == 0;
  }
  EXPECT_EQ(n_rows, 2);
  for (int i = 0; i < 15; ++i) EXPECT_THAT(text, HasSubstr(std::to_string(1000 + i)));
}

TEST(MeasurementText, HasNoLineForUnitsWhereThereAreNone) {
  Measurement document;
  document.tables = {{"counts", "Counts", {{"n", "", "", "1", "1", kNone, kNone, ""}}, {{3}}, {"a"}}};
  EXPECT_EQ(measurement_text(document, Units()), "\n\nCounts\n     n\n  a  3\n");
}

TEST(Measurement, WithoutOrderIsRefused) {
  const auto refused = [](auto corrupt) {
    Measurement document = example::measurement();
    corrupt(document);
    EXPECT_THROW(check_measurement(document), std::logic_error);
  };
  EXPECT_NO_THROW(check_measurement(example::measurement()));
  refused([](Measurement& m) { m.groups[0].values[0].name = m.groups[1].values[0].name; });
  refused([](Measurement& m) { m.groups[0].values[0].name = "two words"; });
  refused([](Measurement& m) { m.key_values = {"not_there"}; });
  refused([](Measurement& m) { m.tables[0].values[1].pop_back(); });
  refused([](Measurement& m) { m.tables[0].row_labels.pop_back(); });
  refused([](Measurement& m) { m.curves[0].series[0].y.pop_back(); });
  refused([](Measurement& m) { std::swap(m.curves[0].x[3], m.curves[0].x[4]); });
  refused([](Measurement& m) { m.maps[0].values.pop_back(); });
  refused([](Measurement& m) { m.maps[0].step_y = 0; });
}

}  // namespace
}  // namespace ringfilm::io
