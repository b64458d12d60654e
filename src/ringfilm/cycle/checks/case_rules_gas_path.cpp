#include "ringfilm/cycle/checks/case_rules_gas_path.hpp"

#include <numbers>
#include <optional>
#include <string>

#include "ringfilm/base/display.hpp"
#include "ringfilm/cycle/checks/case_rules.hpp"
#include "ringfilm/cycle/setup/ring_section.hpp"

namespace ringfilm::cycle {
namespace {

using Breaches = std::vector<RuleBreach>;

void require(const std::optional<double>& value, const std::string& key, Breaches& breaches) {
  if (value) return;
  const Field& field = *find_field(key);
  breaches.push_back({key, "the key " + key + " is missing: " + field.help,
                      "write, for example, " + key.substr(key.find('.') + 1) + " = " + field.example,
                      RuleBreach::By::kMissingKey});
}

void check_end_gap_of_gas(const Case& c, Breaches& breaches) {
  const Ring& ring = c.ring;
  const RingGasPath& gas = ring.gas_path;
  const double circumference = std::numbers::pi * c.engine.bore;
  if (gas.gap_area && ring.end_gap && !c.is_unrolled()) {
    breaches.push_back({"ring.gap_area",
                        "the end gap is stated twice: ring.gap_area and ring.end_gap",
                        "state ring.gap_area, or ring.end_gap with ring.land_clearance",
                        RuleBreach::By::kValues,
                        {{"ring.gap_area"}, {"ring.end_gap"}}});
  }
  if (!gas.gap_area && !ring.end_gap) {
    require(gas.gap_area, "ring.gap_area", breaches);
  } else if (!gas.gap_area) {
    require(gas.land_clearance, "ring.land_clearance", breaches);
  }
  const std::string remedy = "check the units of the end gap and of ring.land_clearance";
  if (ring.end_gap && *ring.end_gap >= circumference) {
    breaches.push_back({"ring.end_gap",
                        "ring.end_gap = " + text_in(*ring.end_gap, kMillimetre) +
                            " is wider than the circumference of the bore, " + text_in(circumference, kMillimetre),
                        remedy});
  }
  if (gas.gap_area && gas.land_clearance && *gas.gap_area >= circumference * *gas.land_clearance) {
    breaches.push_back({"ring.gap_area",
                        "ring.gap_area = " + text_in(*gas.gap_area, kSquareMillimetre) +
                            " is more than the whole clearance between piston land and bore, " +
                            text_in(circumference * *gas.land_clearance, kSquareMillimetre) +
                            ": a gap wider than the "
                            "circumference",
                        remedy});
  }
}

void check_groove(const Case& c, Breaches& breaches) {
  const Ring& ring = c.ring;
  const RingGasPath& gas = ring.gas_path;
  require(gas.groove_volume, "ring.groove_volume", breaches);
  require(side_clearance(ring), "ring.side_clearance", breaches);
  if (gas.gap_area || !ring.end_gap) require(gas.land_clearance, "ring.land_clearance", breaches);
  const std::optional<double> thickness = ring.thickness();
  require(thickness, "ring.radial_thickness", breaches);
  if (!gas.land_clearance || !thickness) return;
  if (*thickness <= *gas.land_clearance) {
    breaches.push_back({"ring.radial_thickness",
                        "ring.radial_thickness = " + text_in(*thickness, kMillimetre) +
                            " is not more than ring.land_clearance = " + text_in(*gas.land_clearance, kMillimetre) +
                            ": the ring has no flank in its groove",
                        "check the units of both"});
  }
  if (2 * *thickness >= c.engine.bore) {
    breaches.push_back({"ring.radial_thickness",
                        "ring.radial_thickness = " + text_in(*thickness, kMillimetre) + " fills the bore of " +
                            text_in(c.engine.bore, kMillimetre),
                        "check its unit"});
  }
}

void check_motion(const Case& c, Breaches& breaches) {
  const RingGasPath& gas = c.ring.gas_path;
  if (gas.mass && gas.density) {
    breaches.push_back({"ring.mass",
                        "the mass of the ring is stated twice: ring.mass and ring.density",
                        "state one of them",
                        RuleBreach::By::kValues,
                        {{"ring.mass"}, {"ring.density"}}});
  } else if (c.gas_path.ring_motion == RingMotion::kAxial) {
    if (!gas.density) require(gas.mass, "ring.mass", breaches);
    if (!(c.ring.face_width > 0)) require(std::nullopt, "ring.face_width", breaches);
  }
}

/// The ring of that number, from 1, of a pack or of a case of one ring.
const Ring& ring_of(const Case& c, std::size_t number) { return c.is_pack() ? c.rings[number - 1].ring : c.ring; }

std::string key_of(const Case& c, std::size_t number, const char* key) {
  return c.is_pack() ? pack_key(number, key) : key;
}

}  // namespace

void append_gas_path_breaches(const Case& c, Breaches& breaches) {
  check_end_gap_of_gas(c, breaches);
  if (c.ring.gas_path.kind == RingKind::kOil) return;
  check_groove(c, breaches);
  check_motion(c, breaches);
}

void append_composition_breaches(const Case& c, Breaches& breaches) {
  const bool is_stated = c.gas.composition.is_stated();
  if (is_stated && !c.gas_path.is_computed()) {
    breaches.push_back({"gas.composition.fuel",
                        "gas.composition.fuel is stated, and the pressures between the rings are not computed: gas "
                        "of a known composition fills volumes whose masses are known",
                        "write model = \"orifice-volume\" in [gas_path], or remove [gas.composition]"});
  }
  if (!is_stated && c.gas_path.properties == GasProperties::kMixture) {
    breaches.push_back({"gas.composition.fuel",
                        "gas_path.properties = \"mixture\" needs the composition of the gas, and "
                        "gas.composition.fuel is not stated",
                        "write, for example, fuel = \"gasoline\" in [gas.composition], or properties = \"stated\"",
                        RuleBreach::By::kMissingKey});
  }
}

std::vector<RuleBreach> broken_pack_rules(const Case& pack) {
  Breaches breaches;
  const std::size_t n = pack.is_pack() ? pack.rings.size() : 1;
  if (!pack.is_pack() && pack.ring.rails > 1) {
    breaches.push_back({"ring.rails", "ring.rails = " + std::to_string(pack.ring.rails) + " in a case of one ring",
                        "write the ring as [[ring]]: its rails are computed as the rings of a pack"});
  }
  for (std::size_t i = 2; i <= n; ++i) {
    const bool oil_before = ring_of(pack, i - 1).gas_path.kind == RingKind::kOil;
    if (!oil_before || ring_of(pack, i).gas_path.kind == RingKind::kOil) continue;
    breaches.push_back({pack_key(i - 1, "ring.kind"),
                        "rings out of order: ring " + std::to_string(i - 1) + " is an oil ring, and ring " +
                            std::to_string(i) + " below it a compression ring",
                        "[[ring]] sections go from the chamber to the crankcase, oil rings last"});
  }
  if (pack.gas_path.is_computed() && ring_of(pack, n).gas_path.volume_below > 0) {
    const std::string key = key_of(pack, n, "ring.volume_below");
    breaches.push_back({key, key + " is a volume below the last ring, where the crankcase is",
                        "leave it out, or add the oil ring as a [[ring]] with kind = \"oil\" and its gap_area"});
  }
  return breaches;
}

}  // namespace ringfilm::cycle
