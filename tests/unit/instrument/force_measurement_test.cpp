#include "ringfilm/instrument/documents/force_measurement.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "ringfilm/base/error.hpp"

namespace ringfilm::instrument {
namespace {

using ::testing::HasSubstr;

/// Loops without noise: TMR = offset + slope load, two loops a load.
ForceSample sample(const std::string& name, double slope_V_per_N, double offset_V = 1e-3) {
  ForceSample of;
  of.name = name;
  of.load_unit = surface::LoadUnit::kNewton;
  of.sources = {name + ".csv: loops"};
  of.paths = {"measured/" + name + ".csv"};
  of.digests = {"0123456789abcdef"};
  for (const double load : {10e-9, 20e-9, 30e-9, 40e-9, 50e-9}) {
    for (int number = 0; number < 2; ++number) {
      surface::FrictionLoop loop{load, {}, {}, {}};
      for (int i = 0; i < 20; ++i) {
        loop.position_m.push_back(1e-7 * i);
        loop.trace_V.push_back(offset_V + slope_V_per_N * load);
        loop.retrace_V.push_back(-offset_V - slope_V_per_N * load);
      }
      of.loops.push_back(loop);
    }
  }
  of.loads = surface::friction_of_loads(of.loops, 0.1, 0);
  of.line = surface::friction_load_line(of.loads, surface::DeviationScale::kFromResiduals);
  return of;
}

ForceCalibration on_silicon(const std::string& name = "silicon") {
  ForceSample silicon = sample(name, 2e5, 1.7e-3);
  ForceCalibration of = silicon_calibration(silicon, surface::kSiliconWarmack);
  of.name = "a calibration";
  return of;
}

TEST(ForceMeasurement, IsValidWhateverSamplesAreCalled) {
  // Names that would meet as words in a file, those of the calibration among them.
  std::vector<ForceSample> samples;
  for (const char* name :
       {"silicon", "x", "deviation x", "slope", "2 x", "x_2", "", "\u00D8 15", "a-b", "a b", "loops 2"}) {
    samples.push_back(sample(name, 3e5));
  }
  EXPECT_NO_THROW(io::check_measurement(force_measurement(samples, on_silicon(), {}, std::nullopt)));
  EXPECT_NO_THROW(io::check_measurement(force_measurement({samples[0]}, on_silicon(), {}, std::nullopt)));
}

TEST(ForceMeasurement, RefusesASampleThatIsItsOwnCalibration) {
  ForceSample one = sample("new", 2e5);
  one.paths = {"a/new.csv"};
  one.digests = {"fedcba9876543210"};  // the numbers decide, not the bytes of the file
  const ForceCalibration of = silicon_calibration(one, surface::kSiliconWarmack);
  try {
    force_measurement({sample("worn", 3e5), sample("new", 2e5)}, of, {}, std::nullopt);
    FAIL() << "not refused";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("the sample new (measured/new.csv) and the calibration on silicon (a/new.csv) "
                                        "have the same loops"));
  }
  ForceSample summary = one;
  summary.loops.clear();
  EXPECT_THROW(force_measurement({summary}, silicon_calibration(summary, surface::kSiliconWarmack), {}, std::nullopt),
               InputError);
}

TEST(ForceMeasurement, HasAFragmentOfOneSampleOrTheOneThatIsNamed) {
  const std::vector<ForceSample> samples = {sample("a", 2e5), sample("b", 4e5)};
  EXPECT_EQ(force_measurement(samples, on_silicon(), {}, std::nullopt).fragment, "");
  EXPECT_THAT(force_measurement(samples, on_silicon(), {}, 1).fragment, HasSubstr("coefficient = 0.36\n"));
  EXPECT_THAT(force_measurement({samples[0]}, on_silicon(), {}, std::nullopt).fragment,
              HasSubstr("coefficient = 0.18\n"));
}

TEST(ForceMeasurement, DrawsEveryMeasuredLoadOfEverySample) {
  const io::Measurement all = force_measurement({sample("a", 2e5), sample("b", 4e5)}, on_silicon(), {}, std::nullopt);
  const io::MeasuredCurve& friction = all.curves.front();
  ASSERT_EQ(friction.name, "friction_against_load");
  int drawn = 0;
  for (const io::MeasuredSeries& series : friction.series) {
    for (std::size_t i = 0; i < series.y.size(); ++i) {
      // The line of b: psi (1 mV + 4e5 V/N load) with psi = 0.18/2e5 N/V.
      if (series.name == "line_b") {
        EXPECT_NEAR(series.y[i], 0.18 / 2e5 * 1e-3 + 0.36 * friction.x[i], 1e-18);
      }
      drawn += series.points && std::isfinite(series.y[i]);
    }
  }
  EXPECT_EQ(drawn, 3 * 5);
}

TEST(WedgeCalibration, RequiresTwoFacetsWithLoops) {
  const std::array<surface::Uncertain, 2> angles{{{0.7, 0.01}, {-0.7, 0.01}}};
  EXPECT_THROW(wedge_calibration({sample("up", 1e5)}, angles, {}), InputError);
  std::vector<ForceSample> facets = {sample("up", 1e5), sample("down", 1e5)};
  facets[1].loops.clear();
  EXPECT_THROW(wedge_calibration(facets, angles, {}), InputError);
}

}  // namespace
}  // namespace ringfilm::instrument
