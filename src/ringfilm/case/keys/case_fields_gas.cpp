#include "ringfilm/case/keys/case_fields_table.hpp"
#include "ringfilm/models/gas/gas.hpp"

namespace ringfilm::cycle::table {
namespace {

bool partial_trace(const Case& c) {
  const auto& angles = c.gas.cylinder_pressure->crank_angle_deg;
  return c.gas.model == GasModel::kTrace && !angles.empty() && !models::covers_cycle(angles);
}

constexpr When kTrace{[](const Case& c) { return c.gas.model == GasModel::kTrace; }, "gas.model = \"trace\""};
constexpr When kWiebe{[](const Case& c) { return c.gas.model == GasModel::kWiebe; }, "gas.model = \"wiebe\""};
/// Does the mass of the charge count: its share that flows back through the gaps, and its temperature?
bool has_charge(const Case& c) {
  return c.gas_path.is_computed() || c.purpose == CasePurpose::kGasPath || c.follows_oil();
}
constexpr When kCharge{has_charge,
                       "gas_path.model = \"orifice-volume\", for ringfilm gas, or film.supply = \"film-on-liner\""};
constexpr When kWiebeOrCharge{[](const Case& c) { return c.gas.model == GasModel::kWiebe || has_charge(c); },
                              "gas.model = \"wiebe\" or gas_path.model = \"orifice-volume\", for ringfilm gas, or "
                              "film.supply = \"film-on-liner\""};
bool is_pegged(const Case& c, Pegging by) { return c.gas.model == GasModel::kTrace && c.gas.pegging == by; }
constexpr When kPolytropic{[](const Case& c) { return is_pegged(c, Pegging::kPolytropic); },
                           "gas.pegging = \"polytropic\""};
constexpr When kRatio{
    [](const Case& c) {
      return c.gas.model == GasModel::kWiebe || has_charge(c) || is_pegged(c, Pegging::kPolytropic);
    },
    "gas.model = \"wiebe\", gas.pegging = \"polytropic\" or gas_path.model = \"orifice-volume\", for ringfilm gas, or "
    "film.supply = \"film-on-liner\""};
constexpr When kIntake{
    [](const Case& c) { return c.gas.model == GasModel::kWiebe || partial_trace(c) || is_pegged(c, Pegging::kIntake); },
    "gas.model = \"wiebe\", gas.pegging = \"intake\" or a trace over a part of the cycle"};
constexpr When kWiebeOrOil{[](const Case& c) { return c.gas.model == GasModel::kWiebe || c.follows_oil(); },
                           "gas.model = \"wiebe\" or film.supply = \"film-on-liner\""};
constexpr When kWiebeOrComposition{
    [](const Case& c) { return c.gas.model == GasModel::kWiebe || kComposition.holds(c); },
    "gas.model = \"wiebe\" or gas.composition.fuel is stated"};
constexpr When kAnyTrace{
    [](const Case& c) {
      return c.gas.model == GasModel::kTrace || c.gas.crankcase_pressure_file || c.ring.pressure_above.file ||
             c.ring.pressure_below.file;
    },
    "gas.model = \"trace\", or gas.crankcase_pressure, ring.pressure_above or ring.pressure_below is a trace"};
constexpr When kWiebeOrPartial{[](const Case& c) { return c.gas.model == GasModel::kWiebe || partial_trace(c); },
                               "gas.model = \"wiebe\" or a trace over a part of the cycle"};

}  // namespace

void append_gas_fields(std::vector<Field>& fields) {
  const Range pressure = above(0, 1e6);
  const Range valve_angle = between(0, 720);
  fields.insert(
      fields.end(),
      {
          field({.key = "gas.model",
                 .kind = choice<&Case::gas, &Gas::model>({{"trace", GasModel::kTrace}, {"wiebe", GasModel::kWiebe}}),
                 .help = "cylinder pressure from a file, or from a single-zone cycle with Wiebe heat release",
                 .example = "\"trace\"",
                 .uses = {.gas = true}}),
          field({.key = "gas.cylinder_pressure",
                 .kind = FileKind{member<&Case::gas, &Gas::cylinder_pressure_file>},
                 .need = Need::kRequired,
                 .when = kTrace,
                 .help = "CSV file of cylinder pressure against crank angle, units in its header",
                 .example = "\"cylinder_pressure.csv\"",
                 .uses = {.gas = true}}),
          field({.key = "gas.pressure_reference",
                 .kind = choice<&Case::gas, &Gas::pressure_reference>(
                     {{"absolute", PressureReference::kAbsolute}, {"gauge", PressureReference::kGauge}}),
                 .need = Need::kRequired,
                 .when = kAnyTrace,
                 .help = "what zero pressure means in the trace; gauge = above 1.01325 bar",
                 .example = "\"absolute\"",
                 .uses = {.gas = true}}),
          field({.key = "gas.angle_zero",
                 .kind = choice<&Case::gas, &Gas::angle_zero>(
                     {{"firing-tdc", AngleZero::kFiringTdc}, {"gas-exchange-tdc", AngleZero::kGasExchangeTdc}}),
                 .need = Need::kRequired,
                 .when = kAnyTrace,
                 .help = "which dead centre has crank angle 0 in the trace",
                 .example = "\"firing-tdc\"",
                 .uses = {.gas = true}}),
          field({.key = "gas.trace_origin",
                 .kind = choice<&Case::gas, &Gas::trace_origin>({{"not-stated", TraceOrigin::kNotStated},
                                                                 {"measured", TraceOrigin::kMeasured},
                                                                 {"computed", TraceOrigin::kComputed},
                                                                 {"synthetic", TraceOrigin::kSynthetic}}),
                 .when = kTrace,
                 .help = "where the trace comes from; shown wherever it appears",
                 .example = "\"measured\"",
                 .uses = {.gas = true},
                 .is_for_record = true}),
          field({.key = "gas.pressure_column",
                 .kind = OptionalTextKind{member<&Case::gas, &Gas::pressure_column>},
                 .need = Need::kOptional,
                 .when = kTrace,
                 .help = "name of the pressure column, where the file has several",
                 .example = "\"cylinder_pressure\"",
                 .uses = {.gas = true}}),
          field({.key = "gas.angle_column",
                 .kind = OptionalTextKind{member<&Case::gas, &Gas::angle_column>},
                 .need = Need::kOptional,
                 .when = kTrace,
                 .help = "name of the crank angle column, where the file has several",
                 .example = "\"crank_angle\"",
                 .uses = {.gas = true}}),
          field({.key = "gas.pressure_unit",
                 .kind = OptionalTextKind{member<&Case::gas, &Gas::pressure_unit>},
                 .need = Need::kOptional,
                 .when = kAnyTrace,
                 .help = "unit of the pressure, for a trace whose header does not carry it",
                 .example = "\"bar\"",
                 .uses = {.gas = true}}),
          field({.key = "gas.angle_unit",
                 .kind = OptionalTextKind{member<&Case::gas, &Gas::angle_unit>},
                 .need = Need::kOptional,
                 .when = kAnyTrace,
                 .help = "unit of the crank angle, for a trace whose header does not carry it",
                 .example = "\"degree\"",
                 .uses = {.gas = true}}),
          field({.key = "gas.columns",
                 .kind = OptionalTextKind{member<&Case::gas, &Gas::columns>},
                 .need = Need::kOptional,
                 .when = kTrace,
                 .help = "names and units of all columns of the trace, for a file without a header",
                 .example = "\"crank_angle [degree], pressure [bar]\"",
                 .uses = {.gas = true}}),
          field({.key = "gas.skip_lines",
                 .kind = CountKind{member<&Case::gas, &Gas::skip_lines>},
                 .unit = kPlainNumber,
                 .range = between(0, 100000),
                 .when = kTrace,
                 .help = "lines of the trace in front of its table",
                 .example = "12",
                 .uses = {.gas = true}}),
          field({.key = "gas.cycle",
                 .kind = OptionalTextKind{member<&Case::gas, &Gas::cycle>},
                 .need = Need::kOptional,
                 .when = kTrace,
                 .help = "of several cycles in the trace: mean, median or the number of one; without it their mean",
                 .example = "\"mean\"",
                 .uses = {.gas = true}}),
          field({.key = "gas.pressure_offset",
                 .kind = NumberKind{member<&Case::gas, &Gas::pressure_offset>},
                 .unit = kBar,
                 .range = between(-1e7, 1e7),
                 .when = kTrace,
                 .help = "pressure to add to the trace of the cylinder",
                 .example = "\"0.2 bar\"",
                 .uses = {.gas = true}}),
          field({.key = "gas.angle_offset",
                 .kind = NumberKind{member<&Case::gas, &Gas::angle_offset_deg>},
                 .unit = si_unit("degree"),
                 .range = between(-360, 360),
                 .when = kTrace,
                 .help = "angle to add to the crank angles of the trace of the cylinder",
                 .example = "\"0.5 degree\"",
                 .uses = {.gas = true}}),
          field({.key = "gas.pegging",
                 .kind = choice<&Case::gas, &Gas::pegging>(
                     {{"none", Pegging::kNone}, {"intake", Pegging::kIntake}, {"polytropic", Pegging::kPolytropic}}),
                 .when = kTrace,
                 .help =
                     "how the zero of the trace is found: as it is, by gas.intake_pressure at bottom dead centre, or "
                     "by gas.polytropic_index",
                 .example = "\"intake\"",
                 .uses = {.gas = true}}),
          field({.key = "gas.polytropic_index",
                 .kind = NumberKind{member<&Case::gas, &Gas::polytropic_index>},
                 .unit = kPlainNumber,
                 .range = between(1, 1.67),
                 .when = kPolytropic,
                 .help = "polytropic index of compression for pegging; typical, assumed",
                 .example = "1.32",
                 .uses = {.gas = true}}),
          field({.key = "gas.compression_ratio",
                 .kind = NumberKind{member<&Case::gas, &Gas::compression_ratio>},
                 .unit = kPlainNumber,
                 .range = above(1, 60),
                 .when = kRatio,
                 .help = "largest over smallest cylinder volume",
                 .example = "10.5",
                 .uses = {.gas = true}}),
          field({.key = "gas.peak_pressure",
                 .kind = NumberKind{member<&Case::gas, &Gas::peak_pressure>},
                 .unit = kBar,
                 .range = above(0, 1e8),
                 .when = kWiebe,
                 .help = "highest cylinder pressure, absolute",
                 .example = "\"62 bar\"",
                 .uses = {.gas = true}}),
          field({.key = "gas.peak_angle",
                 .kind = NumberKind{member<&Case::gas, &Gas::peak_angle_deg>},
                 .unit = si_unit("degree"),
                 .range = strictly_between(0, 90),
                 .when = kWiebe,
                 .help = "crank angle of the highest pressure after firing TDC",
                 .example = "\"20 degree\"",
                 .uses = {.gas = true}}),
          field({.key = "gas.burn_duration",
                 .kind = NumberKind{member<&Case::gas, &Gas::burn_duration_deg>},
                 .unit = si_unit("degree"),
                 .range = between(1, 180),
                 .when = kWiebeOrComposition,
                 .help = "length of the heat release",
                 .example = "\"60 degree\"",
                 .uses = {.gas = true}}),
          field({.key = "gas.exhaust_valve_opening",
                 .kind = NumberKind{member<&Case::gas, &Gas::exhaust_valve_opening_deg>},
                 .unit = si_unit("degree"),
                 .range = valve_angle,
                 .when = kWiebeOrOil,
                 .help = "exhaust valve opens, counted from firing TDC",
                 .example = "\"130 degree\"",
                 .uses = {.gas = true}}),
          field({.key = "gas.exhaust_valve_closing",
                 .kind = NumberKind{member<&Case::gas, &Gas::exhaust_valve_closing_deg>},
                 .unit = si_unit("degree"),
                 .range = valve_angle,
                 .when = kWiebe,
                 .help = "exhaust valve closes, counted from firing TDC",
                 .example = "\"375 degree\"",
                 .uses = {.gas = true}}),
          field({.key = "gas.intake_valve_opening",
                 .kind = NumberKind{member<&Case::gas, &Gas::intake_valve_opening_deg>},
                 .unit = si_unit("degree"),
                 .range = valve_angle,
                 .when = kWiebe,
                 .help = "intake valve opens, counted from firing TDC",
                 .example = "\"345 degree\"",
                 .uses = {.gas = true}}),
          field({.key = "gas.intake_valve_closing",
                 .kind = NumberKind{member<&Case::gas, &Gas::intake_valve_closing_deg>},
                 .unit = si_unit("degree"),
                 .range = valve_angle,
                 .when = kWiebeOrCharge,
                 .help = "intake valve closes, counted from firing TDC",
                 .example = "\"590 degree\"",
                 .uses = {.gas = true}}),
          field({.key = "gas.charge_temperature",
                 .kind = NumberKind{member<&Case::gas, &Gas::charge_temperature>},
                 .unit = si_unit("K"),
                 .range = between(150, 1000),
                 .when = kCharge,
                 .help = "temperature of the charge when the intake valve closes; typical, assumed",
                 .example = "\"350 K\"",
                 .uses = {.gas = true}}),
          field({.key = "gas.intake_pressure",
                 .kind = OptionalNumberKind{member<&Case::gas, &Gas::intake_pressure>},
                 .unit = kBar,
                 .range = pressure,
                 .need = Need::kOptional,
                 .when = kIntake,
                 .help = "pressure during intake, absolute; must be stated for a partial trace",
                 .example = "\"0.95 bar\"",
                 .uses = {.gas = true}}),
          field({.key = "gas.exhaust_pressure",
                 .kind = OptionalNumberKind{member<&Case::gas, &Gas::exhaust_pressure>},
                 .unit = kBar,
                 .range = pressure,
                 .need = Need::kOptional,
                 .when = kWiebeOrPartial,
                 .help = "pressure during exhaust, absolute; must be stated for a partial trace",
                 .example = "\"1.05 bar\"",
                 .uses = {.gas = true}}),
          field({.key = "gas.crankcase_pressure",
                 .kind = NumberOrFileKind{member<&Case::gas, &Gas::crankcase_pressure>,
                                          member<&Case::gas, &Gas::crankcase_pressure_file>},
                 .unit = kBar,
                 .range = pressure,
                 .help =
                     "pressure under the ring, absolute, or a CSV file like the cylinder pressure; assumed atmospheric",
                 .example = "\"1.01325 bar\"",
                 .uses = {.gas = true}}),
          field({.key = "gas.pressure_behind_ring",
                 .kind = NumberKind{member<&Case::gas, &Gas::pressure_behind_ring>},
                 .unit = kPlainNumber,
                 .range = between(0, 1),
                 .help = "share of the excess of the gas pressure above the ring over that below it that acts behind "
                         "the ring",
                 .example = "1.0"}),
      });
}

}  // namespace ringfilm::cycle::table
