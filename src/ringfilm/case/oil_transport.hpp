#pragma once
#include <optional>

#include "ringfilm/case/case_choices.hpp"

/// The input of the oil consumption: parts of a Case.
namespace ringfilm::cycle {

/// The keys under `evaporation`: transfer of oil vapour from the liner to the gas. The defaults are typical and
/// assumed.
struct Evaporation {
  std::optional<double> mass_transfer_coefficient;      ///< beta; absent: from the transfer of heat [m/s]
  std::optional<double> heat_transfer_coefficient;      ///< alpha of gas and liner; absent: `heat_transfer` [W/(m2 K)]
  HeatTransfer heat_transfer = HeatTransfer::kWoschni;  ///< correlation of the transfer of heat
  double lewis_number = 8;                              ///< thermal diffusivity of the gas over that of the vapour [-]
};

/// The keys under `oil_transport`: what carries oil into the chamber. Where a case does not state a key, its default
/// has a band. All are typical and assumed.
struct OilTransport {
  double gas_load = 0.006;        ///< oil that gas carries back through the first gap, over its mass [-]
  double land_film = 2.5e-6;      ///< oil film on the top piston land [m]
  double top_land_height = 6e-3;  ///< height of the top piston land, from the first ring to the crown [m]
  double scraped_share = 0.1;     ///< share of the oil left above the ring at TDC that does not come back [-]
  struct Band {
    double low, high;  ///< ends of the band of a default
  };
  static constexpr Band kGasLoad{0.0034, 0.0114}, kLandFilm{1e-6, 5e-6}, kScrapedShare{0, 1};
};

}  // namespace ringfilm::cycle
