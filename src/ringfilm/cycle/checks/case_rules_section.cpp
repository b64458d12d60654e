#include "ringfilm/cycle/checks/case_rules_section.hpp"

#include <cmath>
#include <numbers>
#include <string>

#include "ringfilm/base/display.hpp"
#include "ringfilm/cycle/setup/ring_section.hpp"

namespace ringfilm::cycle {
namespace {

using Breaches = std::vector<RuleBreach>;

/// Corners of a section at the most: its torsion is found between all of them.
constexpr std::size_t kMaxCorners = 200;
/// Difference of a stated radial thickness and that of the corners that is let through [-].
constexpr double kAlikeThickness = 0.02;
/// By how much a face may be wider than its section, for rounding [-].
constexpr double kAlikeHeight = 1e-6;

/// A corner as a person counts and writes it.
std::string corner_text(const models::SectionPolygon& corners, std::size_t i) {
  return "corner " + std::to_string(i + 1) + " (" + text_in(corners[i].axial, kMillimetre) + ", " +
         text_in(corners[i].radial, kMillimetre) + ")";
}

std::string side_text(const models::SectionPolygon& corners, std::size_t i) {
  return "that from corner " + std::to_string(i + 1) + " to corner " + std::to_string((i + 1) % corners.size() + 1);
}

/// @param what "ring.section" or what made the polygon
RuleBreach breach_of_polygon(const char* key, const std::string& what, const models::SectionPolygon& corners,
                             const models::FaultOfPolygon& found) {
  switch (found.fault) {
    case models::PolygonFault::kFewCorners:
      return {key, what + " has " + std::to_string(corners.size()) + " corners",
              "a section has three corners or more, axial and radial, in the order in which they follow one another"};
    case models::PolygonFault::kRepeatedCorner:
      return {key,
              what + " has " + corner_text(corners, found.first) + " and " + corner_text(corners, found.second) +
                  " at the same place",
              "state each corner once; the last is joined to the first"};
    case models::PolygonFault::kNoArea:
      return {key, what + " has no area: all its corners lie on a line",
              "state the axial length first, then the radial one, of each corner"};
    case models::PolygonFault::kOverlaps:
      break;
  }
  return {key,
          what + " overlaps itself: two of its sides meet, " + side_text(corners, found.first) + " and " +
              side_text(corners, found.second),
          "state the corners in the order in which they follow one another around the section"};
}

void check_lengths_of_form(const Ring& ring, Breaches& breaches) {
  const RingSection& section = ring.section;
  const double height = section_height(ring), thickness = *ring.radial_thickness;
  const auto refuse = [&](const char* key, double length, const char* of, double limit) {
    breaches.push_back({key,
                        std::string(key) + " = " + text_in(length, kMillimetre) + " is not below the " + of +
                            " of the section, " + text_in(limit, kMillimetre),
                        "check the units of both"});
  };
  if (section.form == SectionForm::kInnerBevel) {
    if (!(section.bevel_width < thickness)) {
      refuse("ring.bevel_width", section.bevel_width, "radial thickness", thickness);
    }
    const double depth = section.bevel_width * std::tan(section.bevel_angle_deg * std::numbers::pi / 180);
    const double room = section.bevel_side == models::SectionSide::kBoth ? height / 2 : height;
    if (!(depth < room)) {
      breaches.push_back({"ring.bevel_width",
                          "an inner bevel of ring.bevel_width = " + text_in(section.bevel_width, kMillimetre) +
                              " and ring.bevel_angle = " + text_in(section.bevel_angle_deg, si_unit("degree")) +
                              " is " + text_in(depth, kMillimetre) + " high, and the section has " +
                              text_in(room, kMillimetre) + " for it",
                          "the width is along the flank, the angle against the flank"});
    }
  }
  if (section.form == SectionForm::kNapier) {
    if (!(section.step_height < height)) refuse("ring.step_height", section.step_height, "height", height);
    if (!(section.step_depth < thickness)) {
      refuse("ring.step_depth", section.step_depth, "radial thickness", thickness);
    }
  }
  if (section.form == SectionForm::kTaper && !(section.taper_angle_deg > 0)) {
    breaches.push_back({"ring.taper_angle", "ring.section_form = \"taper\" is stated without an angle of the face",
                        "write, for example, taper_angle = \"1 degree\" in [ring], or ring.section_form = "
                        "\"rectangular\"",
                        RuleBreach::By::kMissingKey});
  }
}

/// @returns whether there is a polygon with an area
bool check_polygon(const Case& c, Breaches& breaches) {
  const Ring& ring = c.ring;
  const RingSection& section = ring.section;
  const bool by_corners = !section.corners.empty();
  const char* key = by_corners ? "ring.section" : "ring.section_form";
  if (by_corners && section.form != SectionForm::kNone) {
    breaches.push_back({"ring.section",
                        "the section of the ring is stated twice: ring.section and ring.section_form",
                        "state one of them",
                        RuleBreach::By::kValues,
                        {{"ring.section"}, {"ring.section_form"}}});
    return false;
  }
  if (section.corners.size() > kMaxCorners) {
    breaches.push_back({key, "ring.section has " + std::to_string(section.corners.size()) + " corners",
                        "state no more than " + std::to_string(kMaxCorners)});
    return false;
  }
  const std::size_t before = breaches.size();
  if (!by_corners) {
    if (!ring.radial_thickness) {
      breaches.push_back({"ring.radial_thickness", "ring.section_form is stated without ring.radial_thickness",
                          "write, for example, radial_thickness = \"3.5 mm\" in [ring]", RuleBreach::By::kMissingKey});
      return false;
    }
    check_lengths_of_form(ring, breaches);
    if (breaches.size() > before) return false;
  }
  const models::SectionPolygon corners = section_polygon(ring);
  const auto found = models::polygon_fault(corners);
  if (!found) return true;
  breaches.push_back(breach_of_polygon(key, by_corners ? "ring.section" : "the section by its form", corners, *found));
  return false;
}

void check_section_in_bore(const Case& c, Breaches& breaches) {
  const Ring& ring = c.ring;
  const char* key = ring.section.corners.empty() ? "ring.section_form" : "ring.section";
  const models::SectionExtent extent = models::section_extent(section_polygon(ring));
  if (!(extent.thickness() < c.engine.bore / 4)) {
    breaches.push_back({key,
                        std::string(key) + " is " + text_in(extent.thickness(), kMillimetre) +
                            " thick and not thin in a bore of " + text_in(c.engine.bore, kMillimetre),
                        "a corner has its axial length first, then the radial one; check their units"});
  }
  if (ring.radial_thickness &&
      std::abs(extent.thickness() - *ring.radial_thickness) > kAlikeThickness * *ring.radial_thickness) {
    breaches.push_back({"ring.radial_thickness",
                        "ring.radial_thickness = " + text_in(*ring.radial_thickness, kMillimetre) +
                            " is not that of ring.section, " + text_in(extent.thickness(), kMillimetre),
                        "omit it, or correct the corners"});
  }
  if (ring.face_width > (1 + kAlikeHeight) * extent.height()) {
    breaches.push_back(
        {key,
         std::string(key) + " is " + text_in(extent.height(), kMillimetre) +
             " high, less than its face is wide (ring.face_width = " + text_in(ring.face_width, kMillimetre) + ")",
         "a corner has its axial length first, then the radial one; check their units"});
  }
}

void check_groove_of_section(const Ring& ring, Breaches& breaches) {
  const auto& groove = ring.section.groove_height;
  if (!groove) return;
  const double height = section_height(ring);
  if (!(height < *groove)) {
    breaches.push_back({"ring.groove_height",
                        "the section of the ring, " + text_in(height, kMillimetre) +
                            " high, is wider than its groove, ring.groove_height = " + text_in(*groove, kMillimetre),
                        "a groove is higher than its ring by the side clearance, usually 30 to 100 um"});
  } else if (ring.gas_path.side_clearance) {
    breaches.push_back({"ring.groove_height",
                        "the side clearance is stated twice: ring.groove_height and ring.side_clearance",
                        "state one of them",
                        RuleBreach::By::kValues,
                        {{"ring.groove_height"}, {"ring.side_clearance"}}});
  }
}

void check_clearance_in_bore(const Ring& ring, Breaches& breaches) {
  const std::optional<double> clearance = side_clearance(ring);
  if (!ring.section.clearance_protrusion || !clearance || *clearance > 0) return;
  breaches.push_back({"ring.clearance_protrusion",
                      "ring.clearance_protrusion = " + text_in(*ring.section.clearance_protrusion, kMillimetre) +
                          " leaves the ring in the bore a side clearance of " + text_in(*clearance, kMicrometre),
                      "the clearance grows as a keystone ring comes out of its groove; check ring.side_clearance and "
                      "ring.land_clearance"});
}

void check_twist_of_face(const Case& c, Breaches& breaches) {
  if (c.ring.section.twist != RingTwist::kQuasiStatic || !c.stated.contains("ring.twist") || c.can_twist()) return;
  breaches.push_back(
      {"ring.twist",
       "ring.twist = \"quasi-static\" turns the face of a compression ring that is rigid against its "
       "film and keeps its sense, and this case has " +
           std::string(c.is_unrolled()                                       ? "film.dimension = \"unrolled\""
                       : c.ring.local_deformation != LocalDeformation::kNone ? "ring.local_deformation = \"half-space\""
                       : c.ring.face.orientation == Orientation::kLeadingEdge
                           ? "ring.face.orientation = \"leading-edge\""
                           : "ring.kind = \"oil\""),
       "state ring.twist = \"none\", or change that"});
}

}  // namespace

bool append_section_breaches(const Case& c, Breaches& breaches) {
  if (!c.ring.section.is_stated()) return true;
  if (!check_polygon(c, breaches)) return false;
  check_section_in_bore(c, breaches);
  check_groove_of_section(c.ring, breaches);
  check_clearance_in_bore(c.ring, breaches);
  if (c.problem == Problem::kCycle && c.purpose != CasePurpose::kGasPath) check_twist_of_face(c, breaches);
  return true;
}

}  // namespace ringfilm::cycle
