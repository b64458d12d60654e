#include "ringfilm/case/keys/case_fields_table.hpp"

namespace ringfilm::cycle::table {
namespace {

/// Does oil evaporate from the liner?
bool evaporates(const Case& c) { return c.follows_oil() && c.lubricant.evaporates(); }

constexpr When kEvaporation{
    evaporates, "lubricant.distillation or lubricant.noack is stated, with film.supply = \"film-on-liner\""};
constexpr When kHeatTransfer{
    [](const Case& c) { return evaporates(c) && !c.evaporation.mass_transfer_coefficient; },
    "lubricant.distillation or lubricant.noack is stated, with film.supply = \"film-on-liner\" and without "
    "evaporation.mass_transfer_coefficient"};
constexpr When kCorrelation{
    [](const Case& c) { return kHeatTransfer.holds(c) && !c.evaporation.heat_transfer_coefficient; },
    "lubricant.distillation or lubricant.noack is stated, with film.supply = \"film-on-liner\" and without "
    "evaporation.mass_transfer_coefficient and evaporation.heat_transfer_coefficient"};

}  // namespace

void append_oil_consumption_fields(std::vector<Field>& fields) {
  fields.insert(
      fields.end(),
      {
          field({.key = "evaporation.mass_transfer_coefficient",
                 .kind = OptionalNumberKind{member<&Case::evaporation, &Evaporation::mass_transfer_coefficient>},
                 .unit = si_unit("m/s"),
                 .range = between(0, 10),
                 .need = Need::kOptional,
                 .when = kEvaporation,
                 .help = "transfer of oil vapour from liner to gas, beta; if omitted, it follows from that of heat",
                 .example = "\"0.05 m/s\""}),
          field({.key = "evaporation.heat_transfer_coefficient",
                 .kind = OptionalNumberKind{member<&Case::evaporation, &Evaporation::heat_transfer_coefficient>},
                 .unit = si_unit("W/(m2 K)"),
                 .range = above(0, 1e5),
                 .need = Need::kOptional,
                 .when = kHeatTransfer,
                 .help = "transfer of heat from gas to liner, alpha, over the whole cycle; if omitted, by correlation",
                 .example = "\"300 W/(m2 K)\""}),
          field({.key = "evaporation.heat_transfer",
                 .kind = choice<&Case::evaporation, &Evaporation::heat_transfer>({{"woschni", HeatTransfer::kWoschni}}),
                 .when = kCorrelation,
                 .help = "correlation of the transfer of heat from gas to liner",
                 .example = "\"woschni\""}),
          field({.key = "evaporation.lewis_number",
                 .kind = NumberKind{member<&Case::evaporation, &Evaporation::lewis_number>},
                 .unit = kPlainNumber,
                 .range = between(0.1, 100),
                 .when = kHeatTransfer,
                 .help = "thermal diffusivity of the gas over the diffusivity of the oil vapour in it, Le; typical, "
                         "assumed",
                 .example = "8.0"}),
          field({.key = "oil_transport.gas_load",
                 .kind = NumberKind{member<&Case::oil_transport, &OilTransport::gas_load>},
                 .unit = kPlainNumber,
                 .range = between(0, 1),
                 .when = kOilFollowed,
                 .help = "mass of oil that gas carries back through the first gap, over the mass of that gas; typical, "
                         "assumed",
                 .example = "0.006"}),
          field({.key = "oil_transport.land_film",
                 .kind = NumberKind{member<&Case::oil_transport, &OilTransport::land_film>},
                 .unit = kMicrometre,
                 .range = between(0, 1e-3),
                 .when = kOilFollowed,
                 .help = "oil film on the top piston land, which inertia throws into the chamber; typical, "
                         "assumed",
                 .example = "\"2.5 um\""}),
          field({.key = "oil_transport.top_land_height",
                 .kind = NumberKind{member<&Case::oil_transport, &OilTransport::top_land_height>},
                 .unit = kMillimetre,
                 .range = above(0, 1),
                 .when = kOilFollowed,
                 .help = "height of the top piston land, from the first ring to the piston crown; typical, assumed",
                 .example = "\"6 mm\""}),
          field({.key = "oil_transport.scraped_share",
                 .kind = NumberKind{member<&Case::oil_transport, &OilTransport::scraped_share>},
                 .unit = kPlainNumber,
                 .range = between(0, 1),
                 .when = kOilFollowed,
                 .help = "share of the oil left above the first ring at TDC that does not come back; typical, assumed",
                 .example = "0.1"}),
      });
}

}  // namespace ringfilm::cycle::table
