#include <algorithm>

#include "ringfilm/case/keys/case_fields_table.hpp"
#include "ringfilm/models/gas/mixture.hpp"

namespace ringfilm::cycle::table {
namespace {

/// Does the gas flow through gaps and clearances? With given pressures for `ringfilm gas` alone.
bool has_gas_path(const Case& c) { return c.gas_path.is_computed() || c.purpose == CasePurpose::kGasPath; }

constexpr When kComputedGas{[](const Case& c) { return has_gas_path(c); },
                            "gas_path.model = \"orifice-volume\", or for ringfilm gas"};
constexpr When kGasFlow{
    [](const Case& c) { return has_gas_path(c) || c.film.has_gas_edge(); },
    "gas_path.model = \"orifice-volume\", or for ringfilm gas, or film.chamber_edge or film.crankcase_edge is \"gas\""};
constexpr When kStatedProperties{
    [](const Case& c) { return kGasFlow.holds(c) && c.gas_path.properties == GasProperties::kStated; },
    "gas_path.properties = \"stated\", with gas_path.model = \"orifice-volume\", or for ringfilm gas, or "
    "film.chamber_edge or film.crankcase_edge is \"gas\""};
constexpr When kMixture{
    [](const Case& c) { return has_gas_path(c) && c.gas_path.properties == GasProperties::kMixture; },
    "gas_path.properties = \"mixture\""};
constexpr When kRingInGroove{
    [](const Case& c) { return has_gas_path(c) && c.ring.gas_path.kind == RingKind::kCompression; },
    "gas_path.model = \"orifice-volume\", or for ringfilm gas, and ring.kind = \"compression\""};
constexpr When kBodyInGroove{
    [](const Case& c) {
      return (has_gas_path(c) || c.ring.section.is_stated()) && c.ring.gas_path.kind == RingKind::kCompression;
    },
    "gas_path.model = \"orifice-volume\", or for ringfilm gas, or the section of the ring is stated, and ring.kind = "
    "\"compression\""};
constexpr When kLandOfRing{
    [](const Case& c) { return has_gas_path(c) || c.ring.section.is_stated(); },
    "gas_path.model = \"orifice-volume\", or for ringfilm gas, or the section of the ring is stated"};
constexpr When kPartOfPack{[](const Case& c) {
                             return has_gas_path(c) || c.ring.gas_path.kind == RingKind::kOil ||
                                    c.stated.contains("ring.kind");
                           },
                           "gas_path.model = \"orifice-volume\", or it is stated"};
constexpr When kGapPositions{[](const Case& c) { return has_gas_path(c) && c.stated.contains("ring.gap_position"); },
                             "ring.gap_position is stated, with gas_path.model = \"orifice-volume\" or for ringfilm "
                             "gas"};
constexpr When kOilRing{[](const Case& c) { return c.ring.gas_path.kind == RingKind::kOil; }, "ring.kind = \"oil\""};
constexpr When kSeveralRails{[](const Case& c) { return c.ring.rails > 1; }, "ring.rails is more than 1"};

/// Gas between the coldest start and a flame.
Range gas_temperature() { return between(150, 3000); }

std::vector<Field> common_fields() {
  return {
      field({.key = "gas_path.model",
             .kind = choice<&Case::gas_path, &GasPath::model>(
                 {{"given", GasPathModel::kGiven}, {"orifice-volume", GasPathModel::kOrificeVolume}}),
             .help = "gas pressures between the rings as stated (ring.pressure_below), or computed from volumes, end "
                     "gaps and "
                     "side clearances; ringfilm gas with stated pressures computes the flows between them",
             .example = "\"orifice-volume\"",
             .uses = {.gas = true}}),
      field({.key = "gas_path.ring_motion",
             .kind = choice<&Case::gas_path, &GasPath::ring_motion>(
                 {{"seated", RingMotion::kSeated}, {"axial", RingMotion::kAxial}}),
             .when = kComputedGas,
             .help = "rings on their lower flanks, or moved in their grooves by gas, inertia and friction on the bore",
             .example = "\"axial\"",
             .uses = {.gas = true}}),
      field({.key = "gas_path.film",
             .kind = choice<&Case::gas_path, &GasPath::film>(
                 {{"sealing", FilmGas::kSealing}, {"breakthrough", FilmGas::kBreakthrough}}),
             .when = kComputedGas,
             .help = "films that let no gas pass, or gas through the gap over the face, all around, where the film "
                     "does not hold "
                     "it; gas and films are then computed in turns",
             .example = "\"breakthrough\""}),
      field({.key = "gas_path.discharge_coefficient",
             .kind = NumberKind{member<&Case::gas_path, &GasPath::discharge_coefficient>},
             .unit = kPlainNumber,
             .range = above(0, 1),
             .when = kComputedGas,
             .help = "discharge coefficient of the end gaps, C; typical, assumed",
             .example = "0.65",
             .uses = {.gas = true}}),
      field({.key = "gas_path.properties",
             .kind = choice<&Case::gas_path, &GasPath::properties>(
                 {{"stated", GasProperties::kStated}, {"mixture", GasProperties::kMixture}}),
             .when = kComputedGas,
             .help = "gas constant, heat capacity ratio and viscosity as stated, or of the mixture that "
                     "gas.composition gives, one for the whole run",
             .example = "\"mixture\"",
             .uses = {.gas = true}}),
      field({.key = "gas_path.mixture_burnt_share",
             .kind = NumberKind{member<&Case::gas_path, &GasPath::mixture_burnt_share>},
             .unit = kPlainNumber,
             .range = between(0, 1),
             .when = kMixture,
             .help = "share of burnt gas in the mixture that gives the properties, the rest is fresh charge; assumed",
             .example = "0.5",
             .uses = {.gas = true}}),
      field({.key = "gas_path.mixture_temperature",
             .kind = NumberKind{member<&Case::gas_path, &GasPath::mixture_temperature>},
             .unit = si_unit("K"),
             .range = between(models::kColdestMixture, models::kHottestMixture),
             .when = kMixture,
             .help = "temperature of the mixture that gives the properties; typical, assumed",
             .example = "\"500 K\"",
             .uses = {.gas = true}}),
      field({.key = "gas_path.gap_carry_over",
             .kind = NumberKind{member<&Case::gas_path, &GasPath::gap_carry_over>},
             .unit = kPlainNumber,
             .range = between(0, 0.95),
             .when = kGapPositions,
             .help = "share of the velocity head of the jet out of an end gap that the gap of the next ring recovers "
                     "right below it, kappa; assumed",
             .example = "0.5",
             .uses = {.gas = true}}),
      field({.key = "gas_path.gap_reach",
             .kind = NumberKind{member<&Case::gas_path, &GasPath::gap_reach>},
             .unit = kMillimetre,
             .range = above(0, 1),
             .when = kGapPositions,
             .help = "distance of two end gaps around the bore from which on the jet of one misses the other; assumed",
             .example = "\"5 mm\"",
             .uses = {.gas = true}}),
      field({.key = "gas_path.gas_constant",
             .kind = NumberKind{member<&Case::gas_path, &GasPath::gas_constant>},
             .unit = si_unit("J/(kg K)"),
             .range = between(50, 5000),
             .when = kStatedProperties,
             .help = "specific gas constant, R; that of air",
             .example = "\"287 J/(kg K)\"",
             .uses = {.gas = true}}),
      field({.key = "gas_path.heat_capacity_ratio",
             .kind = NumberKind{member<&Case::gas_path, &GasPath::heat_capacity_ratio>},
             .unit = kPlainNumber,
             .range = between(1.01, 2),
             .when = kStatedProperties,
             .help = "ratio of the heat capacities, gamma; typical of burned gas, assumed",
             .example = "1.33",
             .uses = {.gas = true}}),
      field({.key = "gas_path.viscosity",
             .kind = NumberKind{member<&Case::gas_path, &GasPath::viscosity>},
             .unit = si_unit("Pa s"),
             .range = between(1e-6, 1e-3),
             .when = kStatedProperties,
             .help = "viscosity of the gas in side clearances and broken films, mu; of air at 500 K, assumed",
             .example = "\"2.7e-5 Pa s\"",
             .uses = {.gas = true}}),
      field({.key = "gas_path.chamber_temperature",
             .kind = NumberKind{member<&Case::gas_path, &GasPath::chamber_temperature>},
             .unit = si_unit("K"),
             .range = gas_temperature(),
             .when = kGasFlow,
             .help = "temperature of the gas that enters from the combustion chamber; typical, assumed",
             .example = "\"600 K\"",
             .uses = {.gas = true}}),
      field({.key = "gas_path.crankcase_temperature",
             .kind = NumberKind{member<&Case::gas_path, &GasPath::crankcase_temperature>},
             .unit = si_unit("K"),
             .range = gas_temperature(),
             .when = kGasFlow,
             .help = "temperature of the gas in the crankcase; typical, assumed",
             .example = "\"360 K\"",
             .uses = {.gas = true}}),
      field({.key = "gas_path.choking_smoothing",
             .kind = NumberKind{member<&Case::gas_path, &GasPath::choking_smoothing>},
             .unit = kPlainNumber,
             .range = between(1e-6, 0.1),
             .when = kGasFlow,
             .help = "above a pressure ratio of 1 less this number the flow of an orifice is a straight line",
             .example = "1e-3",
             .uses = {.gas = true}}),
      field(
          {.key = "gas_path.sliding_smoothing_speed",
           .kind = NumberKind{member<&Case::gas_path, &GasPath::sliding_smoothing_speed>},
           .unit = si_unit("m/s"),
           .range = above(0, 10),
           .when = kLandOfRing,
           .help =
               "speed of the piston over which the friction of the rings on the bore changes its sign, U_0; used with "
               "gas_path.ring_motion = \"axial\" and for the twist of a section",
           .example = "\"0.05 m/s\"",
           .uses = {.gas = true}}),
  };
}

std::vector<Field> ring_fields() {
  return {
      field({.key = "ring.kind",
             .kind = choice<&Case::ring, &Ring::gas_path, &RingGasPath::kind>(
                 {{"compression", RingKind::kCompression}, {"oil", RingKind::kOil}}),
             .when = kPartOfPack,
             .help = "compression ring, or oil ring, which is an end gap alone to the gas and has a drained groove",
             .example = "\"compression\"",
             .uses = {.gas = true}}),
      field(
          {.key = "ring.rails",
           .kind = CountKind{member<&Case::ring, &Ring::rails>},
           .unit = kPlainNumber,
           .range = between(1, 4),
           .when = kOilRing,
           .help =
               "faces of the oil ring, each with a film of its own: 2 of a two- or three-piece ring; ring.face_width, "
               "ring.face and [contact] are those of each",
           .example = "2"}),
      field({.key = "ring.rail_distance",
             .kind = OptionalNumberKind{member<&Case::ring, &Ring::rail_distance>},
             .unit = kMillimetre,
             .range = above(0, 0.05),
             .need = Need::kOptional,
             .when = kSeveralRails,
             .help = "free height between two rails; if omitted, a rail's face width",
             .example = "\"1.6 mm\""}),
      field({.key = "ring.expander_force",
             .kind = OptionalNumberKind{member<&Case::ring, &Ring::expander_force>},
             .unit = si_unit("N"),
             .range = above(0, 1e5),
             .need = Need::kOptional,
             .when = kOilRing,
             .help = "tangential force of the expander that presses the rails, which share it: p_e = 2 F/(B n b)",
             .example = "\"25 N\""}),
      field({.key = "ring.gap_area",
             .kind = OptionalNumberKind{member<&Case::ring, &Ring::gas_path, &RingGasPath::gap_area>},
             .unit = kSquareMillimetre,
             .range = between(0, 1e-4),
             .need = Need::kOptional,
             .when = kComputedGas,
             .help = "area of the end gap, as the gas passes it; if omitted, ring.end_gap times ring.land_clearance",
             .example = "\"0.08 mm2\"",
             .uses = {.gas = true}}),
      field({.key = "ring.volume_below",
             .kind = NumberKind{member<&Case::ring, &Ring::gas_path, &RingGasPath::volume_below>},
             .unit = kCubicMillimetre,
             .range = between(0, 1e-3),
             .when = kComputedGas,
             .help = "volume of the piston land below, with its clearance; 0: it is the region below it",
             .example = "\"500 mm3\"",
             .uses = {.gas = true}}),
      field({.key = "ring.temperature_below",
             .kind = NumberKind{member<&Case::ring, &Ring::gas_path, &RingGasPath::temperature_below>},
             .unit = si_unit("K"),
             .range = gas_temperature(),
             .when = kComputedGas,
             .help = "temperature of the gas on the piston land below; typical, assumed",
             .example = "\"423.15 K\"",
             .uses = {.gas = true}}),
      field({.key = "ring.groove_volume",
             .kind = OptionalNumberKind{member<&Case::ring, &Ring::gas_path, &RingGasPath::groove_volume>},
             .unit = kCubicMillimetre,
             .range = between(0, 1e-3),
             .need = Need::kOptional,
             .when = kRingInGroove,
             .help = "volume of the gas in the groove of the ring",
             .example = "\"300 mm3\"",
             .uses = {.gas = true}}),
      field({.key = "ring.groove_temperature",
             .kind = NumberKind{member<&Case::ring, &Ring::gas_path, &RingGasPath::groove_temperature>},
             .unit = si_unit("K"),
             .range = gas_temperature(),
             .when = kRingInGroove,
             .help = "temperature of the gas in the groove; typical, assumed",
             .example = "\"473.15 K\"",
             .uses = {.gas = true}}),
      field({.key = "ring.side_clearance",
             .kind = OptionalNumberKind{member<&Case::ring, &Ring::gas_path, &RingGasPath::side_clearance>},
             .unit = kMicrometre,
             .range = above(0, 2e-3),
             .need = Need::kOptional,
             .when = kBodyInGroove,
             .help = "clearance of the ring in its groove along the bore's axis",
             .example = "\"50 um\"",
             .uses = {.gas = true}}),
      field({.key = "ring.land_clearance",
             .kind = OptionalNumberKind{member<&Case::ring, &Ring::gas_path, &RingGasPath::land_clearance>},
             .unit = kMillimetre,
             .range = above(0, 0.02),
             .need = Need::kOptional,
             .when = kLandOfRing,
             .help = "radial clearance between the piston lands and the bore",
             .example = "\"0.2 mm\"",
             .uses = {.gas = true}}),
      field({.key = "ring.mass",
             .kind = OptionalNumberKind{member<&Case::ring, &Ring::gas_path, &RingGasPath::mass>},
             .unit = kGram,
             .range = above(0, 10),
             .need = Need::kOptional,
             .when = kBodyInGroove,
             .help = "mass of the ring; with gas_path.ring_motion = \"axial\" this or ring.density",
             .example = "\"8 g\"",
             .uses = {.gas = true}}),
      field({.key = "ring.density",
             .kind = OptionalNumberKind{member<&Case::ring, &Ring::gas_path, &RingGasPath::density>},
             .unit = si_unit("kg/m3"),
             .range = between(500, 25000),
             .need = Need::kOptional,
             .when = kBodyInGroove,
             .help =
                 "density of the ring, of which its mass is made: times face width, radial thickness and circumference",
             .example = "\"7200 kg/m3\"",
             .uses = {.gas = true}}),
      field({.key = "ring.bore_friction_coefficient",
             .kind = NumberKind{member<&Case::ring, &Ring::gas_path, &RingGasPath::bore_friction_coefficient>},
             .unit = kPlainNumber,
             .range = between(0, 1),
             .when = kRingInGroove,
             .help = "friction of the ring on the bore, as its motion in the groove feels it; typical, assumed",
             .example = "0.05",
             .uses = {.gas = true}}),
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
