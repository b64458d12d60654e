#include "ringfilm/cycle/pack/oil_consumption.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ringfilm/cycle/checks/case_rules.hpp"
#include "ringfilm/cycle/checks/case_rules_oil_consumption.hpp"
#include "ringfilm/cycle/pack/liner_evaporation.hpp"

/// Oil that leaves the liner, against closed forms.
namespace ringfilm::cycle {
namespace {

using ::testing::HasSubstr;

constexpr double kBore = 0.089, kStroke = 0.08, kRod = 0.14, kSpeed = 157, kT = 440, kBeta = 0.05;
constexpr double kMolarMass = 0.4, kBoiling = 760;

EvaporatingLiner one_fraction() {
  EvaporatingLiner liner;
  liner.crank = {kStroke / 2, kRod};
  liner.speed = kSpeed;
  liner.bore = kBore;
  liner.fractions = {{1, kBoiling, kMolarMass}};
  liner.temperature = [](double) { return kT; };
  liner.mass_transfer = [](double) { return kBeta; };
  liner.film.assign(100, 800 * 1e-6);
  liner.carried = 800 * 1e-6 * 5e-3;
  liner.reach = 0.02;
  return liner;
}

/// Mean distance of the ring from its TDC position over a cycle, by Simpson's rule [m].
double mean_distance() {
  constexpr int n = 2000;
  double sum = 0;
  for (int k = 0; k <= n; ++k) {
    const double phi = 2 * std::numbers::pi * k / n, r = kStroke / 2;
    const double s = r * (1 - std::cos(phi)) + kRod - std::sqrt(kRod * kRod - std::pow(r * std::sin(phi), 2));
    sum += s * (k == 0 || k == n ? 1 : k % 2 == 1 ? 4 : 2);
  }
  return sum / (3 * n);
}

TEST(LinerEvaporation, OfOneFractionIsTheFluxOverTheMeanOpenArea) {
  const EvaporatedOil oil = evaporated_oil(one_fraction());
  const double p = 101325 * std::exp((4.4 + std::log(kBoiling)) * (1 - kBoiling / kT));
  const double expected = kBeta * kMolarMass * p / (8.314462618 * kT) * std::numbers::pi * kBore * mean_distance();
  EXPECT_NEAR(oil.of_fresh_oil / expected, 1, 1e-9);  // both integrate a periodic path
  EXPECT_NEAR(oil.rate / expected, 1, 1e-9);          // the film does not dry out
  EXPECT_LT(oil.within_reach, oil.rate);
}

TEST(LinerEvaporation, KeepsTheMassOfTheOil) {
  EvaporatingLiner liner = one_fraction();
  liner.fractions = {{0.2, 690, 0.33}, {0.5, 760, 0.42}, {0.3, 850, 0.5}};
  liner.temperature = [](double place) { return 460 - 500 * place; };
  const EvaporatedOil oil = evaporated_oil(liner);
  // Rounding of sums over a few thousand passes of cells that hold far more than evaporates.
  EXPECT_NEAR((oil.replenished - oil.stored) / oil.evaporated, 1, 1e-9);
  EXPECT_LT(oil.within_reach, oil.rate);
  EXPECT_LT(oil.rate, oil.of_fresh_oil);
}

TEST(LinerEvaporation, WithoutRenewalAboveTheReachLeavesOnlyWhatLiesWithinIt) {
  EvaporatingLiner liner = one_fraction();
  liner.carried = 0;
  liner.film.assign(100, 800 * 1e-9);
  const EvaporatedOil oil = evaporated_oil(liner);
  EXPECT_NEAR(oil.rate, oil.within_reach, 1e-12 * oil.rate);
  EXPECT_GT(oil.cycles, 1);
}

TEST(ThrownDistance, OfAViscousFilmIsTheChangeOfSpeedOverItsRate) {
  const models::CrankSlider crank{kStroke / 2, kRod};
  constexpr double kFilm = 2e-6, kNu = 3e-6;
  double largest = 0;
  for (int k = 0; k < 18000; ++k) largest = std::max(largest, crank.velocity(-k * 1e-4, kSpeed));
  // u = a h^2/(3 nu) while the piston slows down from its largest speed and gains it again.
  EXPECT_NEAR(thrown_distance(crank, kSpeed, kFilm, kNu) / (2 * largest * kFilm * kFilm / (3 * kNu)), 1, 2e-3);
}

TEST(ThrownDistance, OfAThickFilmIsThatOfAFreeBody) {
  const models::CrankSlider crank{kStroke / 2, kRod};
  // A free body keeps the largest speed of the piston: it gets ahead of it by what that speed covers up to TDC and on.
  double largest = 0, at = 0;
  for (int k = 0; k < 31400; ++k) {
    const double speed = crank.velocity(-k * 1e-4, kSpeed);
    if (speed > largest) {
      largest = speed;
      at = -k * 1e-4;
    }
  }
  const double time = (std::numbers::pi - at) / kSpeed;
  const double ahead = largest * time - (crank.position(at) - crank.position(std::numbers::pi));
  EXPECT_NEAR(thrown_distance(crank, kSpeed, 1, 1e-9) / ahead, 1, 5e-3);  // steps of 0.25 degree
}

TEST(OilLosses, NeedTheOilOnTheLiner) {
  const Case flooded;
  const CycleResult result;
  const CycleResult* const rings[] = {&result};
  EXPECT_TRUE(oil_losses(flooded, rings, std::nullopt).empty());
}

/// A ring with its oil on the liner, and a result of it.
struct Example {
  Case input;
  CycleResult result;

  Example() {
    input.engine.bore = kBore;
    input.engine.stroke = kStroke;
    input.engine.connecting_rod_length = kRod;
    input.operating.speed = kSpeed;
    input.operating.oil_temperature = kT;
    input.ring.face_width = 1.2e-3;
    input.film.chamber_edge = input.film.crankcase_edge = EdgeFluid::kGas;
    input.film.supply = OilSupply::kFilmOnLiner;
    input.supply.reach = 0.02;
    input.lubricant.kinematic_viscosity = {{313.15, 60e-6}, {373.15, 9.6e-6}};
    input.lubricant.constant_density = 800;
    input.evaporation.mass_transfer_coefficient = kBeta;
    input.lubricant.distillation = {{1, kBoiling, kMolarMass}};
    result.derived = {{"oil_density", 800}, {"oil_viscosity", 2e-3}};
    result.values.min_film_thickness = 1e-6;
    result.values.max_film_thickness = 2e-6;
    result.values.oil_scraped_up = 1e-8;
    for (int b = 0; b < 100; ++b) result.stroke.liner_position.push_back((b + 0.5) * kStroke / 100);
    result.stroke.film_behind.fill(std::vector<double>(100, 1e-6));
  }
  std::vector<OilLoss> losses(const std::optional<gas_path::GasPathResult>& gas = std::nullopt) const {
    const CycleResult* const rings[] = {&result};
    return oil_losses(input, rings, gas);
  }
};

gas_path::GasPathResult gas_that_flows_back() {
  using gas_path::PathKind;
  gas_path::GasPathResult gas;
  gas.regions = {{"chamber", 0, 0, 0}, {"groove 1", 0, 0, 0}, {"crankcase", 0, 0, 0}};
  gas.paths = {{PathKind::kEndGap, 0, 0, 2}, {PathKind::kAboveRing, 0, 0, 1}, {PathKind::kBelowRing, 0, 1, 2}};
  gas.transported = {2e-6, 1e-7, 1e-7};
  gas.back = {1e-6, 9e-6, 5e-7};
  gas.duration = 0.08;
  gas.trapped_mass = 5e-4;
  return gas;
}

TEST(ReverseBlowBy, IsWhatComesFromBelowTheRing) {
  const gas_path::GasPathResult gas = gas_that_flows_back();
  EXPECT_DOUBLE_EQ(reverse_blow_by(gas, 0), 1.5e-6);
  EXPECT_EQ(reverse_blow_by(gas, 1), 0);
  const gas_path::GasSums sums = gas_sums(gas, 287);
  EXPECT_DOUBLE_EQ(sums.reverse_blow_by_charge_share.value(), 3e-3);
  EXPECT_DOUBLE_EQ(sums.returned_to_chamber_per_cycle.value(), 10e-6);
  EXPECT_DOUBLE_EQ(sums.returned_from_crankcase_per_cycle.value(), 1.5e-6);
}

TEST(OilLosses, AreTheirPartsAddedUp) {
  Example example;
  example.input.engine.cylinders = 4;
  example.input.operating.brake_power = 25e3;
  example.input.operating.fuel_rate = 2e-3;
  const std::vector<OilLoss> losses = example.losses(gas_that_flows_back());
  ASSERT_EQ(losses.size(), 8U);
  double low = 0, value = 0, high = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_LE(losses[i].low, losses[i].value) << losses[i].name;
    EXPECT_LE(losses[i].value, losses[i].high) << losses[i].name;
    EXPECT_FALSE(losses[i].assumption.empty());
    low += losses[i].low;
    value += losses[i].value;
    high += losses[i].high;
  }
  EXPECT_DOUBLE_EQ(losses[4].low, low);
  EXPECT_DOUBLE_EQ(losses[4].value, value);
  EXPECT_DOUBLE_EQ(losses[4].high, high);
  EXPECT_EQ(losses[5].name, kEngineOilLoss);
  EXPECT_DOUBLE_EQ(losses[5].value, 4 * value);
  EXPECT_DOUBLE_EQ(losses[6].value, 4 * value / 25e3);
  EXPECT_DOUBLE_EQ(losses[7].value, 4 * value / 2e-3);
}

TEST(OilLosses, OfGasAndBeadAreSharesOfThem) {
  Example example;
  example.input.stated = {"oil_transport.gas_load"};
  example.input.oil_transport.gas_load = 0.01;
  const std::vector<OilLoss> losses = example.losses(gas_that_flows_back());
  const double cycles = kSpeed / (4 * std::numbers::pi);
  EXPECT_NEAR(losses[1].value, 0.1 * 1e-8 * cycles, 1e-20);
  EXPECT_EQ(losses[1].low, 0);
  EXPECT_NEAR(losses[2].value, 0.01 * 1.5e-6 * cycles, 1e-18);
  EXPECT_EQ(losses[2].low, losses[2].high);
  EXPECT_THAT(losses[2].assumption, HasSubstr("as stated"));
}

TEST(OilLosses, WithoutFractionsOrGasReportThatTheyAreNotComputed) {
  Example example;
  example.input.lubricant.distillation.clear();
  const std::vector<OilLoss> losses = example.losses();
  EXPECT_EQ(losses[0].high, 0);
  EXPECT_THAT(losses[0].assumption, HasSubstr("not computed"));
  EXPECT_EQ(losses[2].high, 0);
  EXPECT_THAT(losses[2].assumption, HasSubstr("not computed"));
  EXPECT_EQ(losses.size(), 5U);
}

std::string first_breach(const Example& example) {
  std::vector<RuleBreach> breaches;
  append_oil_consumption_breaches(example.input, breaches);
  return breaches.empty() ? "" : breaches.front().message;
}

TEST(OilConsumptionRules, AskForFractionsThatAreAnOil) {
  Example example;
  EXPECT_EQ(first_breach(example), "");
  example.input.lubricant.distillation = {{0.3, 700, {}}, {0.6, 760, {}}};
  EXPECT_THAT(first_breach(example), HasSubstr("add up to 0.9, not 1"));
  example.input.lubricant.distillation = {{0.3, 760, {}}, {0.7, 700, {}}};
  EXPECT_THAT(first_breach(example), HasSubstr("after 486.85 degC"));
  example.input.lubricant.distillation = {{1, 430, {}}};
  EXPECT_THAT(first_breach(example), HasSubstr("above the last boiling point"));
}

TEST(OilConsumptionRules, AskForTheNumberOfCylinders) {
  Example example;
  example.input.operating.brake_power = 25e3;
  EXPECT_THAT(first_breach(example), HasSubstr("engine.cylinders is missing"));
  example.input.engine.cylinders = 3.5;
  EXPECT_THAT(first_breach(example), HasSubstr("is not whole"));
}

TEST(OilConsumptionRules, AskForOneWayToStateTheVolatility) {
  Example example;
  example.input.lubricant.noack = 0.12;
  EXPECT_THAT(first_breach(example), HasSubstr("lubricant.noack and lubricant.distillation are both stated"));
  example.input.lubricant.distillation.clear();
  EXPECT_EQ(first_breach(example), "");
}

TEST(OilLosses, OfANoackLossAreThoseOfItsFractions) {
  Example noack, fractions;
  noack.input.lubricant.distillation.clear();
  noack.input.lubricant.noack = 0.12;
  fractions.input.lubricant.distillation = models::distillation_of_noack(0.12);
  EXPECT_GT(noack.losses()[0].value, 0);
  EXPECT_EQ(noack.losses()[0].value, fractions.losses()[0].value);
  noack.input.lubricant.noack = 0.2;
  EXPECT_GT(noack.losses()[0].value, fractions.losses()[0].value);
}

TEST(NarrowedBands, ComeInTheOrderOfWhatTheyTakeAway) {
  const std::vector<OilLoss> losses = Example().losses(gas_that_flows_back());
  const std::vector<NarrowedBand> bands = narrowed_bands(losses);
  const OilLoss& total = losses[4];
  ASSERT_GE(bands.size(), 3U);
  double shares = 0;
  for (std::size_t i = 0; i < bands.size(); ++i) {
    const auto part = std::ranges::find(losses, bands[i].part, &OilLoss::name);
    ASSERT_NE(part, losses.end());
    EXPECT_EQ(bands[i].input, part->input);
    EXPECT_NEAR(bands[i].high - bands[i].low, (1 - bands[i].band_share) * (total.high - total.low), 1e-12 * total.high);
    EXPECT_LE(bands[i].low, total.value * (1 + 1e-12));
    EXPECT_GE(bands[i].high, total.value * (1 - 1e-12));
    EXPECT_LE(bands[i].band_share, bands[i > 0 ? i - 1 : 0].band_share);
    shares += bands[i].band_share;
  }
  EXPECT_NEAR(shares, 1, 1e-12) << "the parts are all that the band is made of";
}

TEST(NarrowedBands, DoNotHaveAnInputThatIsStated) {
  Example example;
  example.input.stated = {"oil_transport.gas_load"};
  for (const NarrowedBand& band : narrowed_bands(example.losses(gas_that_flows_back()))) {
    EXPECT_NE(band.input, "oil_transport.gas_load");
  }
  EXPECT_TRUE(narrowed_bands({}).empty());
}

TEST(OilLossQuantities, NameLossesThatThereAre) {
  Example example;
  example.input.engine.cylinders = 4;
  example.input.operating.brake_power = 25e3;
  example.input.operating.fuel_rate = 2e-3;
  const std::vector<OilLoss> losses = example.losses(gas_that_flows_back());
  for (const OilLossQuantity& quantity : oil_loss_quantities()) {
    const auto loss = std::ranges::find(losses, quantity.loss, &OilLoss::name);
    ASSERT_NE(loss, losses.end()) << quantity.name;
    EXPECT_EQ(loss->unit, quantity.unit) << quantity.name;
  }
}

}  // namespace
}  // namespace ringfilm::cycle
