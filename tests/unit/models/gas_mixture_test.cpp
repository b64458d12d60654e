#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "ringfilm/models/gas/charge_mixture.hpp"
#include "ringfilm/models/gas/mixture.hpp"
#include "ringfilm/models/gas/water_vapour.hpp"
#include "ringfilm/models/oil/dilution.hpp"

namespace ringfilm::models {
namespace {

constexpr Fuel kAllFuels[] = {Fuel::kHydrogen, Fuel::kMethane, Fuel::kGasoline, Fuel::kDiesel};

double sum(const Shares& shares) { return std::accumulate(shares.begin(), shares.end(), 0.0); }

// Textbook values of air, and of the air that a mass of fuel needs (heywood1988 and, of hydrogen, 34.3).
TEST(GasMixture, AirAndItsRatiosToFuelsHaveTheirKnownValues) {
  const MixtureProperties air = mixture_properties(dry_air(), 300);
  EXPECT_NEAR(air.gas_constant, 287.05, 0.02);
  EXPECT_NEAR(air.heat_capacity_ratio, 1.400, 2e-3);
  EXPECT_NEAR(air.viscosity, 1.85e-5, 0.02e-5);
  EXPECT_NEAR(stoichiometric_air_fuel_ratio(Fuel::kHydrogen), 34.3, 0.1);
  EXPECT_NEAR(stoichiometric_air_fuel_ratio(Fuel::kMethane), 17.2, 0.1);
  EXPECT_NEAR(stoichiometric_air_fuel_ratio(Fuel::kGasoline), 14.6, 0.1);
  EXPECT_NEAR(stoichiometric_air_fuel_ratio(Fuel::kDiesel), 14.5, 0.1);
}

TEST(GasMixture, OfOneSpeciesIsThatSpecies) {
  for (std::size_t i = 0; i < kNSpecies; ++i) {
    Shares alone{};
    alone[i] = 1;
    const auto of = static_cast<Species>(i);
    const MixtureProperties found = mixture_properties(alone, 500);
    EXPECT_DOUBLE_EQ(molar_mass(alone), molar_mass(of));
    EXPECT_NEAR(found.viscosity, viscosity(of, 500), 1e-15 * viscosity(of, 500));
    EXPECT_NEAR(found.heat_capacity_ratio, specific_heat(of, 500) / (specific_heat(of, 500) - found.gas_constant),
                1e-12);
  }
}

// Both ends of a mixture are what is mixed.
TEST(GasMixture, OfTwoHasThemAtItsEnds) {
  Shares hydrogen{};
  share(hydrogen, Species::kHydrogen) = 1;
  EXPECT_EQ(mixed(dry_air(), hydrogen, 0), dry_air());
  EXPECT_EQ(mixed(dry_air(), hydrogen, 1), hydrogen);
}

TEST(ChargeMixture, BurnsWithoutLossOfMass) {
  for (const Fuel fuel : kAllFuels) {
    for (const double lambda : {0.8, 1.0, 2.5}) {
      const ChargeMixture charge{fuel, lambda, 1, 0.01};
      const Shares fresh = fresh_charge(charge), burnt = burnt_gas(charge);
      EXPECT_NEAR(sum(fresh), 1, 1e-14);
      EXPECT_NEAR(sum(burnt), 1, 1e-14);
      // Nitrogen neither burns nor leaves.
      EXPECT_NEAR(share(burnt, Species::kNitrogen), share(fresh, Species::kNitrogen), 2e-5) << fuel_name(fuel);
      if (lambda == 1) {
        EXPECT_NEAR(share(burnt, Species::kOxygen), 0, 1e-12);
      } else {
        EXPECT_EQ(share(burnt, fuel_species(fuel)) > 0, lambda < 1);
      }
    }
  }
}

// 2 H2 + O2 -> 2 H2O: of 1 kg of hydrogen 8.94 kg of water, at lambda = 2 in 1 + 2 34.3 kg of gas.
TEST(ChargeMixture, MakesTheWaterOfItsHydrogen) {
  const Shares burnt = burnt_gas({Fuel::kHydrogen, 2, 1, 0});
  EXPECT_NEAR(share(burnt, Species::kWater), 8.9367 / (1 + 2 * stoichiometric_air_fuel_ratio(Fuel::kHydrogen)), 1e-5);
}

TEST(ChargeMixture, BurntShareIsThatOfTheResidualGasBeforeAndOneAfter) {
  const CrankSlider crank{0.04, 0.14};
  for (const BurnLaw law : {BurnLaw::kWiebe, BurnLaw::kStep}) {
    const Burning burning{law, -10, 60, 0.05};
    EXPECT_NEAR(burnt_share(burning, crank, 540), 0.05, 1e-12);
    EXPECT_DOUBLE_EQ(burnt_share(burning, crank, 709), 0.05);
    EXPECT_DOUBLE_EQ(burnt_share(burning, crank, 50), 1);
    EXPECT_DOUBLE_EQ(burnt_share(burning, crank, 359), 1);
    EXPECT_NEAR(burnt_share(burning, crank, 361), 1, 0.02);
    for (int angle = 361; angle < 540; ++angle) {
      EXPECT_LE(burnt_share(burning, crank, angle + 1), burnt_share(burning, crank, angle) + 1e-15);
    }
  }
  EXPECT_NEAR(burnt_share({BurnLaw::kWiebe, -10, 60, 0.05}, crank, 20), 0.05 + 0.95 * 0.578, 2e-3);
  EXPECT_DOUBLE_EQ(burnt_share({BurnLaw::kStep, -10, 60, 0.05}, crank, 49), 0.05);
}

/// Saturation pressure of water by the equation of wagner2002, independent of Antoine's constants [Pa].
double saturation_of_iapws(double T) {
  const double t = 1 - T / 647.096;
  return 22.064e6 *
         std::exp(647.096 / T *
                  (-7.85951783 * t + 1.84408259 * std::pow(t, 1.5) - 11.7866497 * std::pow(t, 3) +
                   22.6807411 * std::pow(t, 3.5) - 15.9618719 * std::pow(t, 4) + 1.80122502 * std::pow(t, 7.5)));
}

TEST(WaterVapour, IsSaturatedWithinOneAndAHalfPercentOfIapws) {
  for (double T = 274.15; T < 645; T += 1) {
    EXPECT_NEAR(water_saturation_pressure(T) / saturation_of_iapws(T), 1, 0.015) << T;
    EXPECT_NEAR(*dew_point(water_saturation_pressure(T)), T, 1e-6);
  }
  EXPECT_FALSE(dew_point(100).has_value());
  EXPECT_DOUBLE_EQ(*dew_point(3e7), kHottestWater);
}

// Of 0.2 mole of water in 1 mole at 1 bar, what is left at 50 degC has the partial pressure of saturation.
TEST(WaterVapour, CondensesDownToSaturation) {
  const double T = 323.15, p = 1e5, M_dry = 0.029, M_w = molar_mass(Species::kWater);
  const double mass = 0.2 * M_w + 0.8 * M_dry;
  const double condensed = condensable_water(0.2 * M_w / mass, mass, p, T) * mass / M_w;
  const double left = 0.2 - condensed;
  EXPECT_NEAR(left / (left + 0.8) * p, water_saturation_pressure(T), 1e-6 * p);
  EXPECT_EQ(condensable_water(0.2 * M_w / mass, mass, p, 372), 0);
}

TEST(OilDilution, HasTheLiquidsAtTheEndsOfABlend) {
  EXPECT_EQ(blended_viscosity(80e-6, 2.7e-6, 0), 80e-6);
  EXPECT_EQ(blended_viscosity(80e-6, 2.7e-6, 1), 2.7e-6);
  EXPECT_NEAR(blended_viscosity(80e-6, 2.7e-6, 1e-9), 80e-6, 1e-12);
  EXPECT_NEAR(blended_viscosity(7e-6, 7e-6, 0.3), 7e-6, 1e-18);
  double before = 80e-6;
  for (double share = 0.1; share < 1; share += 0.1) {
    const double nu = blended_viscosity(80e-6, 2.7e-6, share);
    EXPECT_LT(nu, before);
    before = nu;
  }
}

// The indices of the rule as it is printed, 14.534 ln ln(nu + 0.8) + 10.975, mix linearly.
TEST(OilDilution, BlendsByTheIndexOfTheStandard) {
  const auto index = [](double nu) { return 14.534 * std::log(std::log(nu + 0.8)) + 10.975; };
  const double mixed_index = 0.95 * index(80) + 0.05 * index(2.7);
  EXPECT_NEAR(index(1e6 * blended_viscosity(80e-6, 2.7e-6, 0.05)), mixed_index, 1e-9);
}

// Einstein's 2.5 for drops that do not move inside, 1 for drops that do not resist.
TEST(OilDilution, OfDropsIsBetweenTheLimitsOfTaylor) {
  EXPECT_EQ(emulsion_ratio(0, 1e-3, 0.05), 1);
  EXPECT_NEAR(emulsion_ratio(0.02, 1e9, 0.05), 1 + 2.5 * 0.02, 1e-9);
  EXPECT_NEAR(emulsion_ratio(0.02, 0, 0.05), 1 + 0.02, 1e-12);
  EXPECT_NEAR(water_viscosity(293.15), 1.002e-3, 0.01e-3);
  EXPECT_EQ(water_volume_share(0, 850), 0);
  EXPECT_EQ(water_volume_share(1, 850), 1);
}

}  // namespace
}  // namespace ringfilm::models
