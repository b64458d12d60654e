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
  const Unit degree{"degree", "degree"};
  const Unit bar{"Pa", "bar"};
  fields.insert(
      fields.end(),
      {
          field("gas.model", choice<&Case::gas, &Gas::model>({"trace", "wiebe"}), kNoUnit, {}, Need::kDefault, {},
                {"cylinder pressure from a file, or from a single-zone cycle with Wiebe heat release", "\"trace\""}),
          field(
              "gas.cylinder_pressure", FileKind{member<&Case::gas, &Gas::cylinder_pressure_file>}, kNoUnit, {},
              Need::kRequired, kTrace,
              {"CSV file of cylinder pressure against crank angle, units in its header", "\"cylinder_pressure.csv\""}),
          field("gas.pressure_reference", choice<&Case::gas, &Gas::pressure_reference>({"absolute", "gauge"}), kNoUnit,
                {}, Need::kRequired, kAnyTrace,
                {"what zero pressure means in the trace; gauge = above 1.01325 bar", "\"absolute\""}),
          field("gas.angle_zero", choice<&Case::gas, &Gas::angle_zero>({"firing-tdc", "gas-exchange-tdc"}), kNoUnit, {},
                Need::kRequired, kAnyTrace, {"which dead centre has crank angle 0 in the trace", "\"firing-tdc\""}),
          field("gas.trace_origin",
                choice<&Case::gas, &Gas::trace_origin>({"not-stated", "measured", "computed", "synthetic"}), kNoUnit,
                {}, Need::kDefault, kTrace, {"where the trace comes from; shown wherever it appears", "\"measured\""}),
          field("gas.pressure_column", OptionalTextKind{member<&Case::gas, &Gas::pressure_column>}, kNoUnit, {},
                Need::kOptional, kTrace,
                {"name of the pressure column, where the file has several", "\"cylinder_pressure\""}),
          field("gas.angle_column", OptionalTextKind{member<&Case::gas, &Gas::angle_column>}, kNoUnit, {},
                Need::kOptional, kTrace,
                {"name of the crank angle column, where the file has several", "\"crank_angle\""}),
          field("gas.pressure_unit", OptionalTextKind{member<&Case::gas, &Gas::pressure_unit>}, kNoUnit, {},
                Need::kOptional, kAnyTrace,
                {"unit of the pressure, for a trace whose header does not carry it", "\"bar\""}),
          field("gas.angle_unit", OptionalTextKind{member<&Case::gas, &Gas::angle_unit>}, kNoUnit, {}, Need::kOptional,
                kAnyTrace, {"unit of the crank angle, for a trace whose header does not carry it", "\"degree\""}),
          field("gas.compression_ratio", NumberKind{member<&Case::gas, &Gas::compression_ratio>}, kPlainNumber,
                above(1, 60), Need::kDefault, kWiebe, {"largest over smallest cylinder volume", "10.5"}),
          field("gas.peak_pressure", NumberKind{member<&Case::gas, &Gas::peak_pressure>}, bar, above(0, 1e8),
                Need::kDefault, kWiebe, {"highest cylinder pressure, absolute", "\"62 bar\""}),
          field("gas.peak_angle", NumberKind{member<&Case::gas, &Gas::peak_angle_deg>}, degree, strictly_between(0, 90),
                Need::kDefault, kWiebe, {"crank angle of the highest pressure after firing TDC", "\"20 degree\""}),
          field("gas.burn_duration", NumberKind{member<&Case::gas, &Gas::burn_duration_deg>}, degree, between(1, 180),
                Need::kDefault, kWiebe, {"length of the heat release", "\"60 degree\""}),
          field("gas.exhaust_valve_opening", NumberKind{member<&Case::gas, &Gas::exhaust_valve_opening_deg>}, degree,
                valve_angle, Need::kDefault, kWiebe,
                {"exhaust valve opens, counted from firing TDC", "\"130 degree\""}),
          field("gas.exhaust_valve_closing", NumberKind{member<&Case::gas, &Gas::exhaust_valve_closing_deg>}, degree,
                valve_angle, Need::kDefault, kWiebe,
                {"exhaust valve closes, counted from firing TDC", "\"375 degree\""}),
          field("gas.intake_valve_opening", NumberKind{member<&Case::gas, &Gas::intake_valve_opening_deg>}, degree,
                valve_angle, Need::kDefault, kWiebe, {"intake valve opens, counted from firing TDC", "\"345 degree\""}),
          field("gas.intake_valve_closing", NumberKind{member<&Case::gas, &Gas::intake_valve_closing_deg>}, degree,
                valve_angle, Need::kDefault, kWiebe,
                {"intake valve closes, counted from firing TDC", "\"590 degree\""}),
          field("gas.intake_pressure", OptionalNumberKind{member<&Case::gas, &Gas::intake_pressure>}, bar, pressure,
                Need::kOptional, kWiebeOrPartial,
                {"pressure during intake, absolute; must be stated for a partial trace", "\"0.95 bar\""}),
          field("gas.exhaust_pressure", OptionalNumberKind{member<&Case::gas, &Gas::exhaust_pressure>}, bar, pressure,
                Need::kOptional, kWiebeOrPartial,
                {"pressure during exhaust, absolute; must be stated for a partial trace", "\"1.05 bar\""}),
          field("gas.crankcase_pressure",
                NumberOrFileKind{member<&Case::gas, &Gas::crankcase_pressure>,
                                 member<&Case::gas, &Gas::crankcase_pressure_file>},
                bar, pressure, Need::kDefault, {},
                {"pressure under the ring, absolute, or a CSV file like the cylinder pressure; assumed atmospheric",
                 "\"1.01325 bar\""}),
          field("gas.pressure_behind_ring", NumberKind{member<&Case::gas, &Gas::pressure_behind_ring>}, kPlainNumber,
                between(0, 1), Need::kDefault, {},
                {"share of the excess of the gas pressure above the ring over that below it that acts behind the ring",
                 "1.0"}),
      });
}

}  // namespace ringfilm::cycle::table
