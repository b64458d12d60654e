#include "ringfilm/case/accuracy.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "ringfilm/film/time_scheme.hpp"
#include "styles_case.hpp"

namespace ringfilm::cycle {
namespace {

using testing::styles_embedded_ring;
using testing::styles_new_ring;

TEST(TimeScheme, Bdf2IsExactOnParabolas) {
  const double step = 0.7, last = 0.4, older = 0.5;
  const auto y = [](double t) { return 2 + 3 * t - 5 * t * t; };
  const film::Bdf2 scheme(step, last);
  const double remembered = scheme.of_state * y(0) - scheme.of_before * y(-last);
  EXPECT_NEAR((y(step) - remembered) / scheme.time_step, 3 - 10 * step, 1e-12);
  const film::Prediction prediction = film::Prediction::parabola(step, last, older);
  EXPECT_NEAR(prediction.expected(y(0), y(-last), y(-last - older)), y(step), 1e-12);
  EXPECT_NEAR(film::Prediction::parabola(1, 1, 1).error_share, 2.0 / 9, 1e-15);
}

TEST(TimeScheme, ErrorOfBdf2IsThatOfTheCubicItMeets) {
  const double step = 0.3, last = 0.2, older = 0.4;
  const auto y = [](double t) { return t * t * t; };
  // y' = 3 t^2 is given, so that the new value follows from the remembered ones.
  const film::Bdf2 scheme(step, last);
  const double remembered = scheme.of_state * y(0) - scheme.of_before * y(-last);
  const double found = remembered + scheme.time_step * 3 * step * step;
  const film::Prediction p = film::Prediction::parabola(step, last, older);
  const double expected = p.expected(y(0), y(-last), y(-last - older));
  EXPECT_NEAR(p.error_share * std::abs(y(step) - expected), std::abs(found - y(step)), 1e-12);
}

double film_in_mid_stroke(TimeScheme scheme, double step_deg) {
  Case c = styles_new_ring();
  c.operating.speed *= 3;
  c.solver.cells = 60;
  c.solver.time_scheme = scheme;
  c.solver.crank_step_deg = step_deg;
  c.output.crank_angles_deg = {460};
  return simulate(prepare(c)).samples.front().min_film_thickness;
}

TEST(TimeScheme, FilmsConvergeWithItsOrder) {
  const double exact = film_in_mid_stroke(TimeScheme::kBdf2, 0.25);
  const auto order = [&](TimeScheme scheme) {
    return std::log2(std::abs(film_in_mid_stroke(scheme, 4) - exact) / std::abs(film_in_mid_stroke(scheme, 2) - exact));
  };
  EXPECT_NEAR(order(TimeScheme::kBackwardEuler), 1, 0.2);
  EXPECT_GT(order(TimeScheme::kBdf2), 1.8);
}

TEST(Accuracy, MeasuredPointsAreKeptAndOthersLieBetweenThem) {
  EXPECT_EQ(resolution_for(0.5).cells_by_gap, 72);
  EXPECT_EQ(resolution_for(5).uniform_cells, 40);
  EXPECT_DOUBLE_EQ(resolution_for(1).step_error, 1e-2);
  EXPECT_DOUBLE_EQ(resolution_for(1).tolerance, 1e-6);
  for (double accuracy = 0.05; accuracy < 10; accuracy *= 1.1) {
    for (int Resolution::*cells : {&Resolution::cells_by_gap, &Resolution::uniform_cells}) {
      EXPECT_GE(resolution_for(accuracy).*cells, resolution_for(1.1 * accuracy).*cells);
    }
    EXPECT_LE(resolution_for(accuracy).step_error, resolution_for(1.1 * accuracy).step_error);
    EXPECT_LE(resolution_for(accuracy).crank_step_deg, resolution_for(1.1 * accuracy).crank_step_deg);
  }
}

TEST(Accuracy, StepsAreNoLongerThanThoseOfTheCurves) {
  Case c = styles_new_ring();
  c.solver.accuracy = 1;
  EXPECT_EQ(with_accuracy(c).solver.crank_step_deg, 1);
  c.output.crank_angles_deg = {0};
  EXPECT_EQ(with_accuracy(c).solver.crank_step_deg, 12);
  c.output.crank_angles_deg = {17};
  EXPECT_EQ(with_accuracy(c).solver.crank_step_deg, 1);
  EXPECT_EQ(with_accuracy(with_accuracy(c)).solver.cells, 48);
}

TEST(Accuracy, CellsAreUniformBelowHalfAPercentAndWhereFacesShareThem) {
  Case c = styles_new_ring();
  c.solver.accuracy = 0.4;
  EXPECT_EQ(with_accuracy(c).solver.cell_lengths, CellLengths::kUniform);
  EXPECT_GT(with_accuracy(c).solver.cells, resolution_for(0.5).uniform_cells);
  c.solver.accuracy = 0.5;
  EXPECT_EQ(with_accuracy(c).solver.cell_lengths, CellLengths::kByGap);
  EXPECT_EQ(with_accuracy(c, CellLengths::kUniform).solver.cells, resolution_for(0.5).uniform_cells);
}

TEST(Accuracy, NextToGasAFifthOfItIsAskedFor) {
  Case c = styles_new_ring();
  c.solver.accuracy = 5;
  c.film.chamber_edge = EdgeFluid::kGas;
  EXPECT_EQ(with_accuracy(c).solver.cells, resolution_for(1).cells_by_gap);
  c.solver.accuracy = 1;
  EXPECT_EQ(with_accuracy(c).solver.cells, resolution_for(0.2).uniform_cells);
}

TEST(Accuracy, NearlyAllValuesReachIt) {
  long all = 0, within = 0;
  for (Case c : {styles_new_ring(), styles_embedded_ring()}) {
    for (const Cavitation cavitation : {Cavitation::kReynoldsExit, Cavitation::kMassConserving}) {
      c.film.cavitation = cavitation;
      c.output.crank_angles_deg = {0};
      Case fine = c;
      fine.solver.cells = 800;
      fine.solver.crank_step_deg = 0.25;
      fine.solver.time_scheme = TimeScheme::kBdf2;
      c.solver.accuracy = 1;
      const CycleValues is = simulate(prepare(c)).values, want = simulate(prepare(fine)).values;
      for (const CycleQuantity& quantity : cycle_quantities()) {
        if (quantity.name.ends_with("_angle") || want.*quantity.value == 0) continue;
        ++all;
        within += std::abs(is.*quantity.value - want.*quantity.value) <= 0.01 * std::abs(want.*quantity.value);
      }
    }
  }
  EXPECT_GT(all, 100);
  // docs/manual/performance.md, "accuracy and cost": 95 of 100 over random engines.
  EXPECT_GE(static_cast<double>(within), 0.93 * static_cast<double>(all));
}

TEST(Accuracy, ResultHasWhatItStandsFor) {
  Case c = styles_new_ring();
  c.output.crank_angles_deg = {0};
  c.solver.accuracy = 5;
  const CycleResult result = simulate(prepare(c));
  const auto note = std::find_if(result.notes.begin(), result.notes.end(),
                                 [](const Note& n) { return n.topic == "accuracy-asked-for"; });
  ASSERT_NE(note, result.notes.end());
  EXPECT_NE(note->message.find("24 by-gap cells"), std::string::npos);
  EXPECT_NE(note->message.find("bdf2"), std::string::npos);
}

TEST(Accuracy, StandsForStepsOfSecondOrderWithOilOnTheLinerToo) {
  Case c = styles_new_ring();
  c.solver.accuracy = 5;
  c.film.chamber_edge = EdgeFluid::kGas;
  c.film.supply = OilSupply::kFilmOnLiner;
  EXPECT_NE(accuracy_text(with_accuracy(c)).find("bdf2"), std::string::npos);
}

}  // namespace
}  // namespace ringfilm::cycle
