#include "ringfilm/io/text/trade_terms.hpp"

#include <algorithm>
#include <array>
#include <cctype>

namespace ringfilm::io {
namespace {

constexpr std::string_view kEndGap =
    "the closed gap is the one between the ends of the ring in the bore; it is used with film.dimension = \"unrolled\" "
    "and with gas_path.model = \"orifice-volume\"";
constexpr std::string_view kFreeGap = "ring.free_gap is the total free gap less the closed gap";
constexpr std::string_view kTension =
    "state one of ring.tangential_force, ring.elastic_pressure, or ring.free_gap with ring.radial_thickness";
constexpr std::string_view kDiametral =
    "F_t = F_d/2.05 for cast iron, F_d/2.15 for spheroidal graphite iron (docs/manual/guide/from-drawing-to-case.md)";
constexpr std::string_view kBarrel =
    "it is the height at the edge of the face: barrel drop (face width/gauge width)^2 "
    "(docs/manual/guide/from-drawing-to-case.md)";
constexpr std::string_view kPoints =
    "the film has the running surface alone: give it as points, ring.face.form = \"points\" with ring.face.file";
constexpr std::string_view kSection =
    "the section of the ring is \"rectangular\", \"inner-bevel\", \"napier\", \"taper\" or \"keystone\" with its "
    "lengths "
    "and angles, or has its corners in ring.section (docs/manual/guide/from-drawing-to-case.md)";
constexpr std::string_view kTwist = "the twist follows from the section of the ring, ring.section or ring.section_form";
constexpr std::string_view kGroove =
    "it is used with gas_path.model = \"orifice-volume\"; otherwise gas.pressure_behind_ring is the share of the "
    "excess "
    "gas pressure that acts behind the ring";

constexpr std::string_view kTwoViscosities =
    "state it at its temperature: [{ temperature = \"40 degC\", value = \"70 mm2/s\" }, "
    "{ temperature = \"100 degC\", value = \"11 mm2/s\" }]";
constexpr std::string_view kIndex =
    "with one value of lubricant.kinematic_viscosity at 40 or 100 degC it gives the other";
constexpr std::string_view kHths =
    "the viscosity at 150 degC and 1e6 1/s of the data sheet, with lubricant.shear_thinning";

constexpr auto kTerms = std::to_array<TradeTerm>({
    {"closed_gap", "ring.end_gap", kEndGap},
    {"gap_closed", "ring.end_gap", kEndGap},
    {"total_free_gap", "ring.free_gap", kFreeGap},
    {"diametral_force", "ring.tangential_force", kDiametral},
    {"diametral_load", "ring.tangential_force", kDiametral},
    {"tangential_load", "ring.tangential_force", ""},
    {"tangential_tension", "ring.tangential_force", ""},
    {"tension", "ring.tangential_force", kTension},
    {"unit_pressure", "ring.elastic_pressure", ""},
    {"specific_pressure", "ring.elastic_pressure", ""},
    {"wall_pressure", "ring.elastic_pressure", ""},
    {"barrel_drop", "ring.face.crown_height", kBarrel},
    {"barrel_height", "ring.face.crown_height", kBarrel},
    {"barrel", "ring.face.crown_height", kBarrel},
    {"gauge_width", "ring.face.crown_height", kBarrel},
    {"axial_width", "ring.face_width", ""},
    {"axial_height", "ring.face_width", ""},
    {"ring_width", "ring.face_width", ""},
    {"radial_width", "ring.radial_thickness", ""},
    {"wall_thickness", "ring.radial_thickness", ""},
    {"nominal_diameter", "engine.bore", ""},
    {"keystone", "ring.section_form", kSection},
    {"taper", "ring.section_form", kSection},
    {"tapered", "ring.section_form", kSection},
    {"chamfer", "", kPoints},
    {"chamfers", "", kPoints},
    {"bevel", "ring.section_form", kSection},
    {"napier", "ring.section_form", kSection},
    {"scraper", "ring.section_form", kSection},
    {"twist", "ring.twist", kTwist},
    {"kv40", "lubricant.kinematic_viscosity", kTwoViscosities},
    {"kv100", "lubricant.kinematic_viscosity", kTwoViscosities},
    {"kv", "lubricant.kinematic_viscosity", kTwoViscosities},
    {"vi", "lubricant.viscosity_index", kIndex},
    {"hths", "lubricant.hths_viscosity", kHths},
    {"sae", "lubricant.grade", ""},
    {"rpm", "operating.speed", ""},
    {"conrod", "engine.connecting_rod_length", ""},
    {"con_rod", "engine.connecting_rod_length", ""},
    {"preload", "ring.tangential_force", kTension},
    {"side_clearance", "ring.side_clearance", kGroove},
    {"groove_clearance", "ring.side_clearance", kGroove},
});

/// The gap of a ring; that of a pad is a key of its own.
constexpr TradeTerm kGap{"gap", "ring.end_gap", kEndGap};

}  // namespace

const TradeTerm* trade_term(const std::string& key) {
  if (key == "ring.gap") return &kGap;
  std::string name = "_" + key.substr(key.rfind('.') + 1) + "_";
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return c == '-' ? '_' : static_cast<char>(std::tolower(c)); });
  const auto found = std::find_if(kTerms.begin(), kTerms.end(), [&name](const TradeTerm& term) {
    return name.find("_" + std::string(term.word) + "_") != std::string::npos;
  });
  return found == kTerms.end() ? nullptr : &*found;
}

}  // namespace ringfilm::io
