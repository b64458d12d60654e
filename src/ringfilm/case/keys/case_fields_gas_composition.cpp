#include "ringfilm/case/keys/case_fields_table.hpp"

namespace ringfilm::cycle::table {
namespace {

constexpr When kGasOfPack{[](const Case& c) { return c.gas_path.is_computed() || c.purpose == CasePurpose::kGasPath; },
                          "gas_path.model = \"orifice-volume\", or for ringfilm gas"};

}  // namespace

void append_gas_composition_fields(std::vector<Field>& fields) {
  fields.insert(
      fields.end(),
      {
          field({.key = "gas.composition.fuel",
                 .kind = choice<&Case::gas, &Gas::composition, &GasComposition::fuel>({{"none", Fuel::kNone},
                                                                                       {"hydrogen", Fuel::kHydrogen},
                                                                                       {"methane", Fuel::kMethane},
                                                                                       {"gasoline", Fuel::kGasoline},
                                                                                       {"diesel", Fuel::kDiesel}}),
                 .when = kGasOfPack,
                 .help = "fuel of the charge, whose gases are followed through the ring pack; none: one gas without "
                         "composition",
                 .example = "\"hydrogen\"",
                 .uses = {.gas = true}}),
          field({.key = "gas.composition.excess_air_ratio",
                 .kind = NumberKind{member<&Case::gas, &Gas::composition, &GasComposition::excess_air_ratio>},
                 .unit = kPlainNumber,
                 .range = between(0.5, 20),
                 .when = kComposition,
                 .help = "air of the charge over the air that burns its fuel completely, lambda; assumed",
                 .example = "2.0",
                 .uses = {.gas = true}}),
          field({.key = "gas.composition.premixed_share",
                 .kind = NumberKind{member<&Case::gas, &Gas::composition, &GasComposition::premixed_share>},
                 .unit = kPlainNumber,
                 .range = between(0, 1),
                 .when = kComposition,
                 .help = "share of the fuel that is in the charge before it burns, 0 where it is injected as it burns; "
                         "assumed",
                 .example = "1.0",
                 .uses = {.gas = true}}),
          field({.key = "gas.composition.humidity",
                 .kind = NumberKind{member<&Case::gas, &Gas::composition, &GasComposition::humidity>},
                 .unit = kPlainNumber,
                 .range = between(0, 0.1),
                 .when = kComposition,
                 .help = "water in the air, over its dry mass; that of 20 degC and 70 % relative humidity, assumed",
                 .example = "0.01",
                 .uses = {.gas = true}}),
          field({.key = "gas.composition.residual_share",
                 .kind = NumberKind{member<&Case::gas, &Gas::composition, &GasComposition::residual_share>},
                 .unit = kPlainNumber,
                 .range = between(1e-3, 0.9),
                 .when = kComposition,
                 .help = "burnt gas in the charge before it burns, by mass: residual and recirculated; typical, "
                         "assumed",
                 .example = "0.05",
                 .uses = {.gas = true}}),
          field({.key = "gas.composition.burn",
                 .kind = choice<&Case::gas, &Gas::composition, &GasComposition::burn>(
                     {{"wiebe", BurnLaw::kWiebe}, {"step", BurnLaw::kStep}}),
                 .when = kComposition,
                 .help = "burnt share of the gas that enters the pack: that of a mixed cylinder, or a step when the "
                         "combustion ends, as at a wall that the flame reaches last",
                 .example = "\"step\"",
                 .uses = {.gas = true}}),
          field({.key = "gas.composition.burn_begin",
                 .kind = NumberKind{member<&Case::gas, &Gas::composition, &GasComposition::burn_begin_deg>},
                 .unit = si_unit("degree"),
                 .range = between(-90, 90),
                 .when = kComposition,
                 .help = "begin of the combustion, counted from firing TDC; it lasts gas.burn_duration; typical, "
                         "assumed",
                 .example = "\"-10 degree\"",
                 .uses = {.gas = true}}),
          field({.key = "gas.composition.crankcase_air",
                 .kind = NumberKind{member<&Case::gas, &Gas::composition, &GasComposition::crankcase_air>},
                 .unit = kKilogramPerHour,
                 .range = between(0, 1),
                 .when = kComposition,
                 .help = "air that ventilates the crankcase, share of one cylinder; 0: what passes the rings alone",
                 .example = "\"2 kg/h\"",
                 .uses = {.gas = true}}),
      });
}

}  // namespace ringfilm::cycle::table
