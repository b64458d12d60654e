#include <algorithm>

#include "ringfilm/case/keys/case_fields_table.hpp"

namespace ringfilm::cycle::table {
namespace {

/// Does the gas flow through gaps and clearances? With given pressures for `ringfilm gas` alone.
bool has_gas_path(const Case& c) { return c.gas_path.is_computed() || c.purpose == CasePurpose::kGasPath; }

constexpr When kComputedGas{[](const Case& c) { return has_gas_path(c); },
                            "gas_path.model = \"orifice-volume\", or for ringfilm gas"};
constexpr When kRingInGroove{
    [](const Case& c) { return has_gas_path(c) && c.ring.gas_path.kind == RingKind::kCompression; },
    "gas_path.model = \"orifice-volume\", or for ringfilm gas, and ring.kind = \"compression\""};
constexpr When kPartOfPack{[](const Case& c) {
                             return has_gas_path(c) || c.ring.gas_path.kind == RingKind::kOil ||
                                    c.stated.contains("ring.kind");
                           },
                           "gas_path.model = \"orifice-volume\", or it is stated"};
constexpr When kOilRing{[](const Case& c) { return c.ring.gas_path.kind == RingKind::kOil; }, "ring.kind = \"oil\""};
constexpr When kSeveralRails{[](const Case& c) { return c.ring.rails > 1; }, "ring.rails is more than 1"};

constexpr Unit kGasTemperature{"K", "K"};
constexpr Unit kVolume{"m3", "mm3"};

/// Gas between the coldest start and a flame.
Range gas_temperature() { return between(150, 3000); }

std::vector<Field> common_fields() {
  return {
      field("gas_path.model", choice<&Case::gas_path, &GasPath::model>({"given", "orifice-volume"}), kNoUnit, {},
            Need::kDefault, {},
            {"gas pressures between the rings as stated (ring.pressure_below), or computed from volumes, end gaps and "
             "side clearances; ringfilm gas with stated pressures computes the flows between them",
             "\"orifice-volume\""}),
      field("gas_path.ring_motion", choice<&Case::gas_path, &GasPath::ring_motion>({"seated", "axial"}), kNoUnit, {},
            Need::kDefault, kComputedGas,
            {"rings on their lower flanks, or moved in their grooves by gas, inertia and friction on the bore",
             "\"axial\""}),
      field(
          "gas_path.film", choice<&Case::gas_path, &GasPath::film>({"sealing", "breakthrough"}), kNoUnit, {},
          Need::kDefault, kComputedGas,
          {"films that let no gas pass, or gas through the gap over the face, all around, where the film does not hold "
           "it; gas and films are then computed in turns",
           "\"breakthrough\""}),
      field("gas_path.discharge_coefficient", NumberKind{member<&Case::gas_path, &GasPath::discharge_coefficient>},
            kPlainNumber, above(0, 1), Need::kDefault, kComputedGas,
            {"discharge coefficient of the end gaps, C; typical, assumed", "0.65"}),
      field("gas_path.gas_constant", NumberKind{member<&Case::gas_path, &GasPath::gas_constant>},
            {"J/(kg K)", "J/(kg K)"}, between(50, 5000), Need::kDefault, kComputedGas,
            {"specific gas constant, R; that of air", "\"287 J/(kg K)\""}),
      field("gas_path.heat_capacity_ratio", NumberKind{member<&Case::gas_path, &GasPath::heat_capacity_ratio>},
            kPlainNumber, between(1.01, 2), Need::kDefault, kComputedGas,
            {"ratio of the heat capacities, gamma; typical of burned gas, assumed", "1.33"}),
      field("gas_path.viscosity", NumberKind{member<&Case::gas_path, &GasPath::viscosity>}, {"Pa s", "Pa s"},
            between(1e-6, 1e-3), Need::kDefault, kComputedGas,
            {"viscosity of the gas in the side clearances, mu; of air at 500 K, assumed", "\"2.7e-5 Pa s\""}),
      field("gas_path.chamber_temperature", NumberKind{member<&Case::gas_path, &GasPath::chamber_temperature>},
            kGasTemperature, gas_temperature(), Need::kDefault, kComputedGas,
            {"temperature of the gas that enters from the combustion chamber; typical, assumed", "\"600 K\""}),
      field("gas_path.crankcase_temperature", NumberKind{member<&Case::gas_path, &GasPath::crankcase_temperature>},
            kGasTemperature, gas_temperature(), Need::kDefault, kComputedGas,
            {"temperature of the gas in the crankcase; typical, assumed", "\"360 K\""}),
      field("gas_path.choking_smoothing", NumberKind{member<&Case::gas_path, &GasPath::choking_smoothing>},
            kPlainNumber, between(1e-6, 0.1), Need::kDefault, kComputedGas,
            {"above a pressure ratio of 1 less this number the flow of an orifice is a straight line", "1e-3"}),
      field("gas_path.sliding_smoothing_speed", NumberKind{member<&Case::gas_path, &GasPath::sliding_smoothing_speed>},
            {"m/s", "m/s"}, above(0, 10), Need::kDefault, kComputedGas,
            {"speed of the piston over which the friction of the rings on the bore changes its sign, U_0; used with "
             "gas_path.ring_motion = \"axial\"",
             "\"0.05 m/s\""}),
  };
}

std::vector<Field> ring_fields() {
  return {
      field("ring.kind", choice<&Case::ring, &Ring::gas_path, &RingGasPath::kind>({"compression", "oil"}), kNoUnit, {},
            Need::kDefault, kPartOfPack,
            {"compression ring, or oil ring, which is an end gap alone to the gas and has a drained groove",
             "\"compression\""}),
      field("ring.rails", CountKind{member<&Case::ring, &Ring::rails>}, kPlainNumber, between(1, 4), Need::kDefault,
            kOilRing,
            {"faces of the oil ring, each with a film of its own: 2 of a two- or three-piece ring; ring.face_width, "
             "ring.face and [contact] are those of each",
             "2"}),
      field("ring.rail_distance", OptionalNumberKind{member<&Case::ring, &Ring::rail_distance>}, {"m", "mm"},
            above(0, 0.05), Need::kOptional, kSeveralRails,
            {"free height between two rails; if omitted, a rail's face width", "\"1.6 mm\""}),
      field("ring.expander_force", OptionalNumberKind{member<&Case::ring, &Ring::expander_force>}, {"N", "N"},
            above(0, 1e5), Need::kOptional, kOilRing,
            {"tangential force of the expander that presses the rails, which share it: p_e = 2 F/(B n b)", "\"25 N\""}),
      field("ring.gap_area", OptionalNumberKind{member<&Case::ring, &Ring::gas_path, &RingGasPath::gap_area>},
            {"m2", "mm2"}, between(0, 1e-4), Need::kOptional, kComputedGas,
            {"area of the end gap, as the gas passes it; if omitted, ring.end_gap times ring.land_clearance",
             "\"0.08 mm2\""}),
      field("ring.volume_below", NumberKind{member<&Case::ring, &Ring::gas_path, &RingGasPath::volume_below>}, kVolume,
            between(0, 1e-3), Need::kDefault, kComputedGas,
            {"volume of the piston land below, with its clearance; 0: it is the region below it", "\"500 mm3\""}),
      field("ring.temperature_below", NumberKind{member<&Case::ring, &Ring::gas_path, &RingGasPath::temperature_below>},
            kGasTemperature, gas_temperature(), Need::kDefault, kComputedGas,
            {"temperature of the gas on the piston land below; typical, assumed", "\"423.15 K\""}),
      field("ring.groove_volume", OptionalNumberKind{member<&Case::ring, &Ring::gas_path, &RingGasPath::groove_volume>},
            kVolume, between(0, 1e-3), Need::kOptional, kRingInGroove,
            {"volume of the gas in the groove of the ring", "\"300 mm3\""}),
      field("ring.groove_temperature",
            NumberKind{member<&Case::ring, &Ring::gas_path, &RingGasPath::groove_temperature>}, kGasTemperature,
            gas_temperature(), Need::kDefault, kRingInGroove,
            {"temperature of the gas in the groove; typical, assumed", "\"473.15 K\""}),
      field("ring.side_clearance",
            OptionalNumberKind{member<&Case::ring, &Ring::gas_path, &RingGasPath::side_clearance>}, {"m", "um"},
            above(0, 2e-3), Need::kOptional, kRingInGroove,
            {"clearance of the ring in its groove along the bore's axis", "\"50 um\""}),
      field("ring.land_clearance",
            OptionalNumberKind{member<&Case::ring, &Ring::gas_path, &RingGasPath::land_clearance>}, {"m", "mm"},
            above(0, 0.02), Need::kOptional, kComputedGas,
            {"radial clearance between the piston lands and the bore", "\"0.2 mm\""}),
      field("ring.mass", OptionalNumberKind{member<&Case::ring, &Ring::gas_path, &RingGasPath::mass>}, {"kg", "g"},
            above(0, 10), Need::kOptional, kRingInGroove,
            {"mass of the ring; with gas_path.ring_motion = \"axial\" this or ring.density", "\"8 g\""}),
      field("ring.density", OptionalNumberKind{member<&Case::ring, &Ring::gas_path, &RingGasPath::density>},
            {"kg/m3", "kg/m3"}, between(500, 25000), Need::kOptional, kRingInGroove,
            {"density of the ring, of which its mass is made: times face width, radial thickness and circumference",
             "\"7200 kg/m3\""}),
      field("ring.bore_friction_coefficient",
            NumberKind{member<&Case::ring, &Ring::gas_path, &RingGasPath::bore_friction_coefficient>}, kPlainNumber,
            between(0, 1), Need::kDefault, kRingInGroove,
            {"friction of the ring on the bore, as its motion in the groove feels it; typical, assumed", "0.05"}),
  };
}

}  // namespace

void append_gas_path_fields(std::vector<Field>& fields) {
  const auto place = [&fields](const char* key) {
    return std::find_if(fields.begin(), fields.end(), [key](const Field& one) { return one.key == key; });
  };
  std::vector<Field> of_ring = ring_fields(), common = common_fields();
  fields.insert(place("ring.face.form"), of_ring.begin(), of_ring.end());
  fields.insert(place("ring.name"), common.begin(), common.end());
}

}  // namespace ringfilm::cycle::table
