#include "ringfilm/io/text/units.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>
#include <thread>
#include <vector>

namespace ringfilm::io {
namespace {

using ::testing::HasSubstr;

struct Reading {
  const char* text;
  const char* si_unit;
  double value;  // by hand, from the definition of the unit
};

class UnitsRead : public ::testing::TestWithParam<Reading> {};

TEST_P(UnitsRead, GiveTheDoubleNearestToTheSiValue) {
  const Units units;
  const auto [text, si_unit, value] = GetParam();
  // 4 ulp: the definitions behind psi, rpm and degF are themselves rounded products.
  EXPECT_DOUBLE_EQ(units.quantity(text, si_unit, ""), value) << text;
}

INSTANTIATE_TEST_SUITE_P(
    Quantities, UnitsRead,
    ::testing::Values(
        Reading{"82.5 mm", "m", 0.0825}, Reading{"1.56 um", "m", 1.56e-6}, Reading{"1.56 \u00B5m", "m", 1.56e-6},
        Reading{"1.56 \u03BCm", "m", 1.56e-6}, Reading{"1.2mm", "m", 1.2e-3}, Reading{"+1.2e-3 m", "m", 1.2e-3},
        Reading{"1 inch", "m", 0.0254}, Reading{"12.5 N", "N", 12.5}, Reading{"203 GPa", "Pa", 203e9},
        Reading{"1.01325 bar", "Pa", 101325}, Reading{"1.01325 bara", "Pa", 101325}, Reading{"1 atm", "Pa", 101325},
        Reading{"100 psi", "Pa", 689475.7293168361}, Reading{"2 N/mm2", "Pa", 2e6}, Reading{"2 MPa", "Pa", 2e6},
        Reading{"1500 rpm", "rad/s", 157.07963267948966}, Reading{"1500 rev/min", "rad/s", 157.07963267948966},
        Reading{"1500\u00A0rpm", "rad/s", 157.07963267948966},
        Reading{"\u00A01500\u202Frpm ", "rad/s", 157.07963267948966}, Reading{"5 mPa\u00A0s", "Pa s", 5e-3},
        Reading{"157 rad/s", "rad/s", 157}, Reading{"25 rps", "rad/s", 157.07963267948966},
        Reading{"120 degC", "K", 393.15}, Reading{"120 \u00B0C", "K", 393.15}, Reading{"248 degF", "K", 393.15},
        Reading{"393.15 K", "K", 393.15}, Reading{"0.097 um-2", "m-2", 0.097e12},
        Reading{"0.097 um^-2", "m-2", 0.097e12}, Reading{"0.097 1/um2", "m-2", 0.097e12},
        Reading{"59.99 mm2/s", "m2/s", 59.99e-6}, Reading{"59.99 cSt", "m2/s", 59.99e-6},
        Reading{"59.99 mm\u00B2/s", "m2/s", 59.99e-6}, Reading{"5 cP", "Pa s", 5e-3}, Reading{"5 mPa.s", "Pa s", 5e-3},
        Reading{"5 mPa s", "Pa s", 5e-3}, Reading{"833.8 kg/m3", "kg/m3", 833.8},
        Reading{"0.8338 g/cm3", "kg/m3", 833.8}, Reading{"1e-8 m2/N", "Pa-1", 1e-8}, Reading{"10 1/GPa", "Pa-1", 1e-8},
        Reading{"1e-3 1/K", "K-1", 1e-3}, Reading{"1e-3 K-1", "K-1", 1e-3}, Reading{"20 degree", "degree", 20},
        Reading{"20 deg", "degree", 20}, Reading{"20 degCA", "degree", 20}, Reading{"20 Grad", "degree", 20},
        Reading{"20 GRAD", "degree", 20}, Reading{"20 Grad KW", "degree", 20}, Reading{"20 \u00B0 KW", "degree", 20},
        Reading{"20 deg CA", "degree", 20}, Reading{"3 mrad", "degree", 0.54 / std::numbers::pi},
        Reading{"0.5 rev", "degree", 180}, Reading{"100 gon", "degree", 90}, Reading{"5 lb", "kg", 2.26796185},
        Reading{"5 thou", "m", 127e-6}, Reading{"250 HV", "Pa", 2.4516625e9}, Reading{"250 HV10", "Pa", 2.4516625e9},
        Reading{"250 HV 0.3", "Pa", 2.4516625e9}, Reading{"250 HBW 2.5/187.5", "Pa", 2.4516625e9},
        Reading{"6 Grad/s", "rad/s", std::numbers::pi / 30}, Reading{"3.14159265358979312 rad", "degree", 180}));

struct Refusal {
  const char* text;
  const char* si_unit;
  const char* message;
  const char* remedy;
};

class UnitsRefuse : public ::testing::TestWithParam<Refusal> {};

TEST_P(UnitsRefuse, StateWhatIsWrongAndWhatToWrite) {
  const Units units;
  const auto [text, si_unit, message, remedy] = GetParam();
  try {
    units.quantity(text, si_unit, "\"1 something\"");
    FAIL() << text << " was read";
  } catch (const UnitError& error) {
    EXPECT_THAT(error.what(), HasSubstr(message)) << text;
    EXPECT_THAT(error.remedy, HasSubstr(remedy)) << text;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Texts, UnitsRefuse,
    ::testing::Values(
        Refusal{"12.5", "N", "has no unit", "a force is required here, for example \"1 something\""},
        Refusal{"12.5 mm", "N", "is not a force", "a force is required"},
        Refusal{"12,5 N", "N", "decimal comma", "decimal point"},
        Refusal{"1 500 rpm", "rad/s", "second number", "one number"},
        Refusal{"nan N", "N", "not a finite number", "a force"},
        Refusal{"inf bar", "Pa", "not a finite number", "a pressure"},
        Refusal{"1e400 N", "N", "out of the range of numbers", "a force"},
        Refusal{"-inf bar", "Pa", "not a finite number", "a pressure"},
        Refusal{"much", "N", "does not start with a number", "a force"},
        Refusal{"", "N", "does not start with a number", "a force"}, Refusal{"5 furlongs", "N", "", "a force"},
        Refusal{"5 xyz", "m", "unknown unit \"xyz\"", "a length"},
        Refusal{"20 grad", "degree", "unknown unit", "write degree, or gon"},
        Refusal{"2 Mrad", "degree", "more than a revolution", "write degree, rad or rev"},
        Refusal{"20 grad", "rad", "unknown unit", "write degree, or gon"},
        Refusal{"2 krad", "rad", "more than a revolution", "write degree, rad or rev"},
        Refusal{"2 krev", "degree", "more than a revolution", "write degree, rad or rev"},
        Refusal{"2 barg", "Pa", "gauge pressure", "add the atmosphere"},
        Refusal{"30 psig", "Pa", "gauge pressure", "add the atmosphere"},
        Refusal{"1500 RPM", "rad/s", "unknown unit \"RPM\"", "write rpm"},
        Refusal{"1500 U/min", "rad/s", "\"U/min\"", "write rpm"},
        Refusal{"1\u00A0500 rpm", "rad/s", "second number", "one number"},
        Refusal{"2 PSI", "Pa", "\"PSI\"", "write psi"}, Refusal{"157 1/s", "rad/s", "turns or radians", "rpm or rad/s"},
        Refusal{"25 Hz", "rad/s", "turns or radians", "rpm or rad/s"},
        Refusal{"20 percent", "degree", "turns or radians", "degree or rad"},
        Refusal{"120 C", "K", "is not a temperature", "degC"}, Refusal{"10 bar", "K", "is not a temperature", "degC"},
        // UDUNITS by itself turns um2 over into um-2.
        Refusal{"0.097 um2", "m-2", "is not a number per area", "a number per area"}));

TEST(Units, ThePoundOfAForceIsThePoundForce) {
  const Units units;
  // 0.45359237 kg times 9.80665 m/s2, and an inch of 25.4 mm; UDUNITS has ten digits of the pound-force.
  const double pound = 0.45359237 * 9.80665, inch = 0.0254, digits = 1e-9;
  for (const char* text : {"3 lb", "3 lbs", "3 lbf"}) {
    EXPECT_NEAR(units.quantity(text, "N", "") / (3 * pound), 1, digits) << text;
  }
  EXPECT_NEAR(units.quantity("2 lb/in", "N/m", "") / (2 * pound / inch), 1, digits);
  EXPECT_NEAR(units.quantity("100 lb/in2", "Pa", "") / (100 * pound / inch / inch), 1, digits);
  EXPECT_NEAR(units.quantity("30 Msi", "Pa", "") / (30e6 * pound / inch / inch), 1, digits);
}

TEST(Units, HardnessAfterRockwellByTheTableOfTheStandard) {
  const Units units;
  EXPECT_DOUBLE_EQ(units.quantity("60 HRC", "Pa", ""), 697 * 9.80665e6);
  // ASTM E140 between the rows that are kept: 52 HRC are 544 HV, 62 HRC 746 HV. 1 %: the curve is bent.
  EXPECT_NEAR(units.quantity("52 HRC", "Pa", ""), 544 * 9.80665e6, 0.01 * 544 * 9.80665e6);
  EXPECT_NEAR(units.quantity("62 HRC", "Pa", ""), 746 * 9.80665e6, 0.01 * 746 * 9.80665e6);
  for (const char* text : {"19 HRC", "69 HRC"}) {
    try {
      units.quantity(text, "Pa", "2.5 GPa");
      ADD_FAILURE() << text;
    } catch (const UnitError& error) {
      EXPECT_THAT(error.what(), HasSubstr("ASTM E140, of steels converts from 20 to 68 HRC"));
    }
  }
  EXPECT_FALSE(units.measures("HRC", "Pa")) << "no factor converts it";
}

TEST(Units, ViscositiesOfFlowCups) {
  const Units units;
  // ASTM D2161, table of kinematic viscosities at 100 degF: 10 mm2/s are 58.8 SUS, 100 mm2/s 463.5; the digits given.
  EXPECT_NEAR(units.quantity("58.8 SUS", "m2/s", ""), 10e-6, 0.02e-6);
  EXPECT_NEAR(units.quantity("463.5 SSU", "m2/s", ""), 100e-6, 0.05e-6);
  // 7.31 E - 6.31/E by hand.
  EXPECT_NEAR(units.quantity("5 \u00B0E", "m2/s", ""), 35.288e-6, 1e-12);
  EXPECT_NEAR(units.quantity("10 degE", "m2/s", ""), 72.469e-6, 1e-12);
  EXPECT_THROW(units.quantity("1 degE", "m2/s", ""), UnitError);
  EXPECT_THROW(units.quantity("20 SUS", "m2/s", ""), UnitError);
  EXPECT_THROW(units.quantity("60 SUS", "Pa s", ""), UnitError);
}

TEST(Units, RefuseAPageInPlaceOfAUnit) {
  EXPECT_THROW(Units().quantity("1 " + std::string(1 << 20, '('), "m", ""), UnitError);
}

TEST(Units, ShowTheUnitThatPeopleRead) {
  const Units units;
  EXPECT_EQ(units.shown(0.089, "m", "mm"), "89 mm");
  EXPECT_EQ(units.shown(393.15, "K", "degC"), "120 degC");
  EXPECT_EQ(units.shown(157.07963267948966, "rad/s", "rpm"), "1500 rpm");
  EXPECT_EQ(units.shown(9.7e10, "m-2", "um-2"), "0.097 um-2");
  EXPECT_EQ(units.shown(0.3, "1", "1"), "0.3");
}

TEST(Units, ConvertAsMessagesDo) {
  const Units units;
  for (const DisplayUnit& unit : {kPlainNumber,
                                  kNanometre,
                                  kMicrometre,
                                  kMillimetre,
                                  kSquareMillimetre,
                                  kWornArea,
                                  kCubicMillimetre,
                                  kPerSquareMicrometre,
                                  kBar,
                                  kKilopascal,
                                  kMegapascal,
                                  kGigapascal,
                                  kNanonewton,
                                  kNewtonPerMillimetre,
                                  kGram,
                                  kMilligram,
                                  kMilligramPerSecond,
                                  kLitrePerMinute,
                                  kMillipascalSecond,
                                  kSquareMillimetrePerSecond,
                                  kCelsius,
                                  kDegree,
                                  kArcMinute,
                                  kMilliradian,
                                  kRpm}) {
    const Scale scale = units.scale(unit.name, unit.si);
    EXPECT_DOUBLE_EQ(unit.scale.to_si(3), scale.to_si(3)) << unit.name;
    EXPECT_DOUBLE_EQ(number_in(3, unit), scale.from_si(3)) << unit.name;
  }
  EXPECT_EQ(text_in(1.5e-6, kMicrometre), "1.5 um");
  EXPECT_EQ(range_in(0, 0.0123456, kMillimetre, 3), "0 to 12.3 mm");
}

TEST(Units, ReadBackTheirOwnSiTextBitByBit) {
  const Units units;
  for (const double value : {0.1, 1.0 / 3.0, 157.07963267948966, 9.7e10, 1e-300}) {
    for (const char* unit : {"m", "N", "Pa", "rad/s", "K", "degree", "m-2", "m2/s", "kg/m3", "Pa-1", "K-1"}) {
      EXPECT_EQ(units.quantity(exact_text(value) + " " + unit, unit, ""), value) << unit;
    }
  }
}

TEST(Units, MayBeReadByManyThreadsAtOnce) {
  std::vector<double> read(8, 0.0);
  std::vector<std::thread> threads;
  for (double& value : read) {
    threads.emplace_back([&value] {
      const Units units;
      for (int i = 0; i < 200; ++i) value += units.quantity("2 mm", "m", "");
    });
  }
  for (std::thread& thread : threads) thread.join();
  // 200 sums of 0.002, each rounded.
  for (const double value : read) EXPECT_NEAR(value, 0.4, 1e-12);
}

}  // namespace
}  // namespace ringfilm::io
