#include "ringfilm/cycle/regimes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "../../../scenarios/usual_engine.hpp"
#include "../sample_between_pressures.hpp"
#include "../tabulated_case.hpp"

namespace ringfilm::cycle::testing {
namespace {

/// One sample at each dead centre: speed rises evenly from 0 and falls back to it, power the other way round.
std::vector<Sample> four_samples(double load_share, double next_load_share) {
  std::vector<Sample> samples(4);
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const bool is_even = k % 2 == 0;
    samples[k].crank_angle_deg = 180.0 * static_cast<double>(k);
    samples[k].asperity_load_share = is_even ? load_share : next_load_share;
    samples[k].piston_velocity = is_even ? 0 : k == 1 ? -2 : 2;
    samples[k].power_loss = is_even ? 4 : 0;
  }
  return samples;
}

// The logarithm of the load share is a straight line: 1 % in the middle of each step, 90 % at s.
TEST(Regimes, SharesOfTimeDistanceAndEnergyAreThoseOfStraightLines) {
  CycleValues v;
  put_regime_shares(four_samples(1e-4, 1), v);
  const double s = 1 + std::log(0.9) / std::log(1e4);
  EXPECT_NEAR(v.full_film_cycle_share, 0.5, 1e-12);
  EXPECT_NEAR(v.mixed_regime_cycle_share, s - 0.5, 1e-12);
  EXPECT_NEAR(v.boundary_regime_cycle_share, 1 - s, 1e-12);
  EXPECT_NEAR(v.full_film_distance_share, 0.25, 1e-12);
  EXPECT_NEAR(v.mixed_regime_distance_share, s * s - 0.25, 1e-12);
  EXPECT_NEAR(v.boundary_regime_distance_share, 1 - s * s, 1e-12);
  EXPECT_NEAR(v.full_film_energy_share, 0.75, 1e-12);
  EXPECT_NEAR(v.mixed_regime_energy_share, 0.25 - (1 - s) * (1 - s), 1e-12);
  EXPECT_NEAR(v.boundary_regime_energy_share, (1 - s) * (1 - s), 1e-12);
}

TEST(Regimes, EachMayTakeTheWholeCycle) {
  struct Whole {
    double load_share, next_load_share;
    std::string regime;
  };
  for (const Whole& of :
       {Whole{0, 1e-5, "full_film"}, Whole{0.02, 0.89, "mixed_regime"}, Whole{0.91, 1, "boundary_regime"}}) {
    CycleValues values;
    put_regime_shares(four_samples(of.load_share, of.next_load_share), values);
    for (const CycleQuantity& quantity : cycle_quantities()) {
      if (!is_regime_share(quantity)) continue;
      EXPECT_EQ(values.*quantity.value, quantity.name.starts_with(of.regime) ? 1 : 0) << quantity.name;
    }
  }
}

TEST(Regimes, TheOneWithMostOfTheEnergyPredominates) {
  CycleValues values;
  values.mean_power_loss = 10;
  const auto predominant = [&](double boundary, double full_film, double boundary_power) {
    values.boundary_regime_energy_share = boundary;
    values.full_film_energy_share = full_film;
    values.mean_boundary_power = boundary_power;
    return regime_name(predominant_regime(values));
  };
  EXPECT_EQ(predominant(0.6, 0.3, 7), "boundary");
  EXPECT_EQ(predominant(0.4, 0.4, 7), "mixed");
  EXPECT_EQ(predominant(0, 0.6, 4.9), "full film");
  EXPECT_EQ(predominant(0, 0.6, 5.1), "mixed") << "more than half of the power is boundary friction";
}

/// Load share of asperities that carry W_a under a parabola with its lowest place at `apex`. @param beyond load of the
/// film beyond the pressures at the edges, over W_a
double load_share(EdgeFluid edges, double apex, double beyond, double above, double below) {
  Case c = styles_new_ring();
  c.ring.face = {};
  c.ring.face.form = FaceForm::kParabola;
  c.ring.face.crown_height = 15e-6;
  c.ring.face.apex = apex;
  c.film.cavitation = Cavitation::kMassConserving;
  c.film.chamber_edge = c.film.crankcase_edge = edges;
  film::FilmIntegrals integrals;
  integrals.asperity_load = 50;
  const double of_edges = (apex * above + (1 - apex) * below) * c.ring.face_width;
  integrals.hydrodynamic_load = of_edges + beyond * integrals.asperity_load;
  return sample_between_pressures(c, 1e-6, above, below, integrals).asperity_load_share;
}

// The pressures at the edges reach up to the lowest place of the face and carry their part of the load without oil.
TEST(AsperityLoadShare, CountsWhatTheOilCarriesBeyondThePressuresAtTheEdges) {
  for (const EdgeFluid edges : {EdgeFluid::kOil, EdgeFluid::kGas}) {
    for (const double apex : {0.3, 0.5, 0.8}) {
      EXPECT_NEAR(load_share(edges, apex, 3, 40e5, 1e5), 0.25, 1e-9) << apex;
      EXPECT_NEAR(load_share(edges, apex, 1e-9, 1e5, 6e5), 1, 1e-6) << "a dry ring with an apex at " << apex;
      EXPECT_EQ(load_share(edges, apex, -0.2, 40e5, 1e5), 1) << apex;
    }
  }
}

// ln p falls evenly, by 1 over the length.
TEST(FullFilmLambdaRatio, IsWhereTheLawFallsBelowAHundredthOfTheTension) {
  constexpr double kLength = 0.2e-6, kHighest = 1e9;
  Case c = with_table(styles_new_ring(), 0, 8);
  ContactLawTable law = *c.contact.law;
  for (std::size_t k = 0; k < law.rows.h.size(); ++k) {
    law.rows.pressure[k] = kHighest * std::exp(-law.rows.h[k] / kLength);
    law.rows.area_share[k] = law.rows.pressure[k] / 2.5e9;
  }
  c.contact.law = base::Shared<ContactLawTable>(std::move(law));
  c.solver.cells = 40;
  c.solver.crank_step_deg = c.output.crank_angle_step_deg = 4;
  const double expected = kLength / 0.48e-6 * std::log(kHighest / (0.01 * 2e5));
  // Between its rows the law is a cubic, whose error moves it by a thousandth of the length.
  EXPECT_NEAR(simulated(c).derived.at("full_film_lambda_ratio"), expected, 1e-3 * expected);
}

/// The contact laws of a case, each with what it requires.
constexpr int kLaws = 8;
Case with_law(Case c, int law) {
  Contact& contact = c.contact;
  contact.hardness = 2.5e9;
  if (law > 0 && law < 5) contact.summit_plane = SummitPlane::kNayak;
  if (law == 2 || law == 3) contact.model = ContactLaw::kGreenwoodWilliamson;
  if (law == 3 || law == 4) contact.asperity = AsperityLaw::kZhaoMaiettaChang;
  if (law == 5) contact.model = ContactLaw::kBushGibsonThomas;
  if (law == 6) contact.model = ContactLaw::kPlastic;
  return law == 7 ? with_table(c, 0, 8) : c;
}

/// A flooded ring on few cells with long steps.
Case random_ring(int index) {
  scenarios::RepeatableNumbers draw(1000 + static_cast<std::uint64_t>(index));
  Case c = scenarios::usual_engine(draw, 500, 6000);
  c.contact.boundary_shear_strength_coefficient = draw.log_between(0.05, 0.4);
  c.solver.cells = 30;
  c.solver.crank_step_deg = c.output.crank_angle_step_deg = 4;
  return with_law(c, index % kLaws);
}

// No lambda ratio shows the regime with all laws: a ring that rubs most of its power away is not one of full film.
TEST(Regimes, NoRingOf200OfAllContactLawsIsCalledFullFilmWhereMostOfItsPowerIsBoundaryFriction) {
  int computed = 0, rubbing = 0, full_film = 0, boundary = 0;
  for (int index = 0; index < 200; ++index) {
    CycleResult result;
    try {
      result = simulated(random_ring(index));
    } catch (const StoppedCycle&) {
      continue;
    }
    ++computed;
    const CycleValues& v = result.values;
    const bool rubs = v.mean_boundary_power > 0.5 * v.mean_power_loss;
    const Regime regime = predominant_regime(v);
    rubbing += rubs;
    full_film += regime == Regime::kFullFilm;
    boundary += regime == Regime::kBoundary;
    EXPECT_FALSE(rubs && regime == Regime::kFullFilm) << index;
    for (const double sum :
         {v.boundary_regime_cycle_share + v.mixed_regime_cycle_share + v.full_film_cycle_share,
          v.boundary_regime_distance_share + v.mixed_regime_distance_share + v.full_film_distance_share,
          v.boundary_regime_energy_share + v.mixed_regime_energy_share + v.full_film_energy_share}) {
      EXPECT_NEAR(sum, 1, 1e-12) << index;
    }
    // What is sheared in full films is part of the viscous energy; counted in whole steps, of which each crossing of
    // 1 % may miss one.
    double in_full_films = 0, full_steps = 0, all = 0;
    for (const Sample& s : result.samples) {
      all += s.power_loss;
      if (s.asperity_load_share >= 0.01) continue;
      in_full_films += s.viscous_friction * std::abs(s.piston_velocity);
      full_steps += 1;
    }
    EXPECT_LT(in_full_films / all, v.mean_viscous_power / v.mean_power_loss + 0.05) << index;
    EXPECT_NEAR(full_steps / static_cast<double>(result.samples.size()), v.full_film_cycle_share, 0.06) << index;
  }
  EXPECT_GE(computed, 190);
  // The claim is about many rings of each kind.
  EXPECT_GT(rubbing, 40);
  EXPECT_GT(full_film, 20);
  EXPECT_GT(boundary, 10);
}

}  // namespace
}  // namespace ringfilm::cycle::testing
