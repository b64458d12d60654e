#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "ringfilm/cycle/menisci_cycle.hpp"
#include "ringfilm/cycle/simulate_batch.hpp"
#include "styles_case.hpp"

/// The film between two menisci over whole cycles (docs/theory/menisci.md).
namespace ringfilm::cycle::testing {
namespace {

Case on_liner(Case c, double speed_rpm, double film) {
  c.film.cavitation = Cavitation::kMassConserving;
  c.film.chamber_edge = c.film.crankcase_edge = EdgeFluid::kGas;
  c.film.supply = OilSupply::kFilmOnLiner;
  c.supply.film = {{0, film}};
  c.supply.reach = 10e-3;
  c.operating.speed = speed_rpm * std::numbers::pi / 30;
  return c;
}

// Gas breaks through after firing TDC, upstrokes begin with a bead, 0.3 um leave the ring dry.
TEST(MenisciCycle, NoOilIsLostOrCreated) {
  for (const double film : {2e-6, 0.3e-6}) {
    for (const Scraped scraped : {Scraped::kBead, Scraped::kDiscarded}) {
      Case c = on_liner(styles_new_ring(), 1500, film);
      c.supply.scraped = scraped;
      const cycle::Setup setup = prepare(c);
      MenisciIntegration integration(setup, 1e-2);
      const double before = integration.liner().all();
      for (int cycle = 0; cycle < 2; ++cycle) {
        integration.integrate_cycle();
        EXPECT_NEAR(integration.liner().all() / before, 1, 1e-12) << film;
      }
      EXPECT_LT(std::abs(integration.liner().owed()) / before, 1e-3) << film;
    }
  }
}

CycleResult simulated(Case c) {
  c.solver.method = Method::kMenisci;
  return simulate(prepare(c));
}

bool has_note(const CycleResult& result, const std::string& topic) {
  return std::any_of(result.notes.begin(), result.notes.end(), [&](const Note& note) { return note.topic == topic; });
}

TEST(MenisciCycle, ADryRingCarriesOn) {
  const CycleResult result = simulated(on_liner(styles_new_ring(), 1500, 0.1e-6));
  EXPECT_FALSE(has_note(result, kMenisciNotUsed));
  ASSERT_EQ(result.samples.size(), 720u);
  for (const Sample& sample : result.samples) EXPECT_LT(sample.load_residual, 0.02) << sample.crank_angle_deg;
  EXPECT_LT(result.values.max_film_thickness, 1.5e-6);
}

// Gas blows through after firing TDC, the film ruptures after each dead centre, and exhaust ends dry.
TEST(MenisciCycle, IsThatOfTheFixedGrid) {
  Case c = on_liner(styles_new_ring(), 1500, 2e-6);
  c.output.crank_angles_deg = {2, 5, 10, 90, 182, 185, 190, 270, 385, 450, 542, 545, 550, 630, 715};
  const CycleResult grid = simulate(prepare(c)), menisci = simulated(c);
  EXPECT_FALSE(has_note(menisci, kMenisciNotUsed));
  for (std::size_t k = 0; k < grid.samples.size(); ++k) {
    EXPECT_NEAR(menisci.samples[k].min_film_thickness / grid.samples[k].min_film_thickness, 1, 0.01)
        << grid.samples[k].crank_angle_deg;
  }
  const CycleValues &a = menisci.values, &b = grid.values;
  EXPECT_NEAR(a.fmep / b.fmep, 1, 0.01);
  EXPECT_NEAR(a.min_film_thickness / b.min_film_thickness, 1, 0.005);
  EXPECT_NEAR(a.max_film_thickness / b.max_film_thickness, 1, 0.005);
  EXPECT_NEAR(a.oil_replenished / b.oil_replenished, 1, 0.01);
  EXPECT_NEAR(a.oil_scraped_down / b.oil_scraped_down, 1, 0.01);
  EXPECT_NEAR(a.gas_through_film_forward / b.gas_through_film_forward, 1, 0.1);
  EXPECT_LE(menisci.effort.cycles_integrated, 6);
}

TEST(MenisciCycle, IsTheSameEachTime) {
  const Case c = on_liner(styles_embedded_ring(), 3000, 1e-6);
  EXPECT_EQ(simulated(c).values.fmep, simulated(c).values.fmep);
}

TEST(MenisciCycle, WhereThereIsNoneCellsAreUsedWithANote) {
  Case flooded = on_liner(styles_new_ring(), 1500, 2e-6);
  flooded.film.supply = OilSupply::kFlooded;
  const CycleResult menisci = simulated(flooded);
  EXPECT_TRUE(has_note(menisci, kMenisciNotUsed));
  EXPECT_EQ(menisci.values.fmep, simulate(prepare(flooded)).values.fmep);
  Case turning = on_liner(styles_new_ring(), 1500, 2e-6);
  turning.ring.face.orientation = Orientation::kLeadingEdge;
  EXPECT_EQ(no_menisci_since(prepare(turning)), "the face turns over with the stroke");
  Case with_fields = on_liner(styles_new_ring(), 1500, 2e-6);
  with_fields.output.fields = FieldOutput::kAll;
  EXPECT_EQ(no_menisci_since(prepare(with_fields)), "output.fields asks for pressures on cells");
  Case capillary = on_liner(styles_new_ring(), 1500, 2e-6);
  capillary.film.outlet = Outlet::kCapillary;
  EXPECT_EQ(no_menisci_since(prepare(capillary)), "film.outlet is not \"half-gap\"");
  EXPECT_FALSE(no_menisci_since(prepare(on_liner(styles_new_ring(), 1500, 2e-6))));
}

TEST(MenisciCycle, IsTheSameInABatch) {
  Case c = on_liner(styles_new_ring(), 1500, 2e-6);
  c.solver.method = Method::kMenisci;
  Case flooded = c;
  flooded.film.supply = OilSupply::kFlooded;
  const std::vector<Case> cases{c, flooded, c};
  std::size_t given = 0;
  std::vector<double> fmep(cases.size());
  simulate_batch(
      [&]() -> std::optional<cycle::Setup> {
        if (given == cases.size()) return std::nullopt;
        return prepare(cases[given++]);
      },
      [&](BatchOutcome outcome) { fmep[outcome.index] = outcome.result.values.fmep; });
  EXPECT_EQ(fmep[0], fmep[2]);
  EXPECT_EQ(fmep[0], simulate(prepare(c)).values.fmep);
  EXPECT_NE(fmep[0], fmep[1]);
}

TEST(LinerSide, ShapedOilKeepsItsMass) {
  LinerSide side(0);
  side.add_beyond(0, 1e-3, 1e-3, 2e-3);
  side.add_beyond(1e-3, 3e-3, 2e-3, 2e-3);
  const double all = side.mass(), between = side.mass_between(0.5e-3, 2e-3);
  side.shape({{0.5e-3, 1}, {1e-3, 2}, {2e-3, 1}});
  EXPECT_NEAR(side.mass() / all, 1, 1e-12);
  EXPECT_NEAR(side.mass_between(0.5e-3, 2e-3) / between, 1, 1e-12);
  EXPECT_GT(side.mass_between(0.9e-3, 1.1e-3), side.mass_between(1.8e-3, 2e-3));
}

}  // namespace
}  // namespace ringfilm::cycle::testing
