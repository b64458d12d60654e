#pragma once
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "ringfilm/base/members.hpp"
#include "ringfilm/case/case.hpp"
#include "ringfilm/cycle/result/result.hpp"
#include "ringfilm/gas_path/result.hpp"
#include "ringfilm/models/crank_slider.hpp"

/// Oil that leaves the liner for the chamber (docs/theory/oil-consumption.md).
namespace ringfilm::cycle {

/// A part of the oil consumption, or a sum of the parts, with its band.
struct OilLoss {
  std::string name;        ///< "evaporation", "scraped_up", "carried_by_gas", "thrown_off", "total", "engine", ...
  std::string unit;        ///< SI unit of the three values
  double low = 0;          ///< with the assumptions that give the least
  double value = 0;        ///< expected
  double high = 0;         ///< with the assumptions that give the most
  std::string assumption;  ///< what makes the difference between the three
  std::string input = {};  ///< key of a case that narrows the band of the part; empty: of a sum, or without a band
};

/// The members of a loss, as all outputs have them.
constexpr auto members(const OilLoss*) {
  return std::tuple{Member{"name", "", "part of the oil consumption", &OilLoss::name},
                    Member{"unit", "", "SI unit of the values", &OilLoss::unit},
                    Member{"low", "", "oil consumption, lower end, in the unit of its row", &OilLoss::low},
                    Member{"value", "", "oil consumption, in the unit of its row", &OilLoss::value},
                    Member{"high", "", "oil consumption, upper end, in the unit of its row", &OilLoss::high},
                    Member{"assumption", "", "what makes the band", &OilLoss::assumption},
                    Member{"input", "", "key that narrows the band of the part", &OilLoss::input}};
}

/// Name of the sum of all parts of one cylinder.
inline constexpr const char* kTotalOilLoss = "total";
/// Names of what the total comes to for the engine: as a rate, over brake power, over fuel.
inline constexpr const char *kEngineOilLoss = "engine", *kSpecificOilLoss = "brake_specific",
                            *kFuelShareOfOil = "fuel_share";

/// The band of the total that remains where the assumption of one part is known.
struct NarrowedBand {
  std::string part;       ///< name of the part
  std::string input;      ///< key of a case that narrows its band
  double low = 0;         ///< lower end of the total with the part at its value [kg/s]
  double high = 0;        ///< upper end [kg/s]
  double band_share = 0;  ///< share of the width of the total's band that goes away [-]
};

constexpr auto members(const NarrowedBand*) {
  return std::tuple{
      Member{"part", "", "part of the oil consumption", &NarrowedBand::part},
      Member{"input", "", "key that narrows the band of the part", &NarrowedBand::input},
      Member{"low", "kg/s", "lower end of the total with the part at its value", &NarrowedBand::low},
      Member{"high", "kg/s", "upper end of the total with the part at its value", &NarrowedBand::high},
      Member{"band_share", "1", "share of the total's band that goes away", &NarrowedBand::band_share},
  };
}

/// What narrows the band of the total most, in falling order, eq-narrowed-band. Parts without a band are omitted.
/// @param losses as oil_losses() returns them
std::vector<NarrowedBand> narrowed_bands(const std::vector<OilLoss>& losses);

/// A value of a loss under a name of its own, as studies have it.
struct OilLossQuantity : Quantity {
  const char* loss;          ///< OilLoss::name
  double OilLoss::*member;   ///< its value, or an end of its band
  const char* requires_key;  ///< key of a case without which there is none; nullptr: none
};
/// The total with its ends, the values of the parts, and what the total comes to for the engine.
const std::vector<OilLossQuantity>& oil_loss_quantities();

/// Distance that a film on the top piston land moves towards the crown at each TDC by its inertia, eq-thrown-distance
/// [m].
/// @param speed of the crankshaft [rad/s] @param film its thickness [m] @param kinematic_viscosity [m2/s]
double thrown_distance(const models::CrankSlider& crank, double speed, double film, double kinematic_viscosity);

/// The oil consumption of a cylinder by its parts, their sum, and what that is for the engine. Empty where the oil on
/// the liner is not followed or a ring is not complete.
/// @param c case of the pack, each rail of an oil ring by itself (with_rails), or of one ring @param rings results of
/// its rings, from the chamber down @param gas nothing where the gas path is not computed
std::vector<OilLoss> oil_losses(const Case& c, std::span<const CycleResult* const> rings,
                                const std::optional<gas_path::GasPathResult>& gas);

}  // namespace ringfilm::cycle
