#include "ringfilm/case/keys/case_fields_table.hpp"

namespace ringfilm::cycle::table {
namespace {

constexpr When kGapPoints{[](const Case& c) { return !c.pad.has_formula(); }, "pad.face.form = \"points\""};
constexpr When kSeparation{[](const Case& c) { return c.pad.separation.has_value(); }, "pad.separation is given"};
constexpr When kOscillation{[](const Case& c) { return c.pad.oscillation.amplitude.has_value(); },
                            "pad.oscillation.amplitude is given"};
constexpr When kTransient{[](const Case& c) { return c.pad.is_transient(); },
                          "pad.separation_history or pad.oscillation.amplitude is given"};
constexpr When kFiniteWidth{[](const Case& c) { return c.pad.width.has_value(); }, "pad.width is given"};
constexpr When kOpenSides{[](const Case& c) { return c.pad.has_sides_at_pressures(); },
                          "pad.width is given and pad.sides = \"open\""};

}  // namespace

void append_pad_fields(std::vector<Field>& fields) {
  const Unit mm{"m", "mm"}, um{"m", "um"}, second{"s", "s"}, bar{"Pa", "bar"};
  const Range pressure = between(-1e9, 1e10);
  const Range time = between(-1e9, 1e9);
  fields.insert(
      fields.end(),
      {
          field("pad.length", NumberKind{member<&Case::pad, &Pad::length>}, mm, above(0, 1e3), Need::kRequired, {},
                {"length along the motion, L; any key of [pad] makes the case a film of stated shape without engine, "
                 "gas and ring",
                 "\"76.2 mm\""}),
          field("pad.width", OptionalNumberKind{member<&Case::pad, &Pad::width>}, mm, above(0, 1e3), Need::kOptional,
                {}, {"width across the motion, B; if omitted, the pad is infinitely wide", "\"50 mm\""}),
          field("pad.gap", FileKind{member<&Case::pad, &Pad::gap_file>}, kNoUnit, {}, Need::kRequired, kGapPoints,
                {"CSV file x [mm],h [um] of the gap from x = 0 to the length, g; straight between points, the same x "
                 "twice is a step; with a width also a map, CSV x [mm],y [mm],h [um] or NetCDF h(y, x); in its place "
                 "[pad.face] gives the gap by a formula",
                 "\"gap.csv\""}),
          field("pad.speed", NumberKind{member<&Case::pad, &Pad::speed>}, {"m/s", "m/s"}, between(0, 1e5),
                Need::kRequired, {}, {"speed of the flat surface, U; the pad and its gap stand still", "\"4.57 m/s\""}),
          field("pad.direction", choice<&Case::pad, &Pad::direction>({"+x", "-x"}), kNoUnit, {}, Need::kDefault, {},
                {"which way the flat surface moves", "\"+x\""}),
          field("pad.left_pressure", NumberKind{member<&Case::pad, &Pad::left_pressure>}, bar, pressure,
                Need::kRequired, {}, {"pressure at x = 0, from the zero that the case chooses", "\"0 bar\""}),
          field("pad.right_pressure", NumberKind{member<&Case::pad, &Pad::right_pressure>}, bar, pressure,
                Need::kRequired, {}, {"pressure at x = length, from the same zero", "\"0 bar\""}),
          field(
              "pad.sides", choice<&Case::pad, &Pad::sides>({"open", "periodic", "closed"}), kNoUnit, {}, Need::kDefault,
              kFiniteWidth,
              {"what the film ends at across the motion: stated pressures, its own other side, or walls", "\"open\""}),
          field("pad.front_pressure", NumberKind{member<&Case::pad, &Pad::front_pressure>}, bar, pressure,
                Need::kRequired, kOpenSides, {"pressure at y = 0, from the same zero", "\"0 bar\""}),
          field("pad.back_pressure", NumberKind{member<&Case::pad, &Pad::back_pressure>}, bar, pressure,
                Need::kRequired, kOpenSides, {"pressure at y = width, from the same zero", "\"0 bar\""}),
          field("pad.separation", OptionalNumberKind{member<&Case::pad, &Pad::separation>}, um, between(-1, 1),
                Need::kOptional, {}, {"added to the gap everywhere: h = g + s", "\"0 um\""}),
          field("pad.load", OptionalNumberKind{member<&Case::pad, &Pad::load>}, {"N/m", "N/m"}, above(0, 1e12),
                Need::kOptional, {},
                {"load per metre of width that the film carries; the separation is found", "\"100000 N/m\""}),
          field("pad.separation_history", OptionalFileKind{member<&Case::pad, &Pad::separation_history_file>}, kNoUnit,
                {}, Need::kOptional, {},
                {"CSV file time [s],h [um] of the separation, straight between points", "\"separation.csv\""}),
          field("pad.time_step", NumberKind{member<&Case::pad, &Pad::time_step>}, second, above(0, 1e9),
                Need::kRequired, kTransient, {"time step of the integration", "\"0.001 s\""}),
          field("pad.end_time", OptionalNumberKind{member<&Case::pad, &Pad::end_time>}, second, time, Need::kOptional,
                kTransient,
                {"where the integration ends; if omitted, with the history; required with an oscillation", "\"1 s\""}),
          field("pad.output_step", OptionalNumberKind{member<&Case::pad, &Pad::output_step>}, second, above(0, 1e9),
                Need::kOptional, kTransient,
                {"spacing of the instants that are kept, whole time steps; if omitted, every step", "\"0.01 s\""}),
          field("pad.face.form",
                choice<&Case::pad, &Pad::face, &FaceShape::form>({"polynomial", "parabola", "points", "cosine"}),
                kNoUnit, {}, Need::kDefault, {},
                {"how the gap, g(x), is given: points are those of pad.gap; with a width a formula is the same at "
                 "every y",
                 "\"parabola\""}),
      });
  const std::vector<Field> formula = face_fields<&Case::pad, &Pad::face>(
      {"pad.face", "\"parabola\" or \"cosine\"",
       "height of the parabola at the edge farther from its lowest point; of the cosine, which has one "
       "period along the pad, from its lowest to its highest point",
       1, "length"});
  fields.insert(fields.end(), formula.begin(), formula.end());
  fields.insert(
      fields.end(),
      {
          field("pad.oscillation.amplitude",
                OptionalNumberKind{member<&Case::pad, &Pad::oscillation, &PadOscillation::amplitude>}, um, above(0, 1),
                Need::kOptional, kSeparation,
                {"the separation oscillates about pad.separation: s(t) = s + amplitude cos(2 pi t/period + phase)",
                 "\"2 um\""}),
          field("pad.oscillation.period", NumberKind{member<&Case::pad, &Pad::oscillation, &PadOscillation::period>},
                second, above(0, 1e9), Need::kRequired, kOscillation, {"period of the oscillation", "\"0.01 s\""}),
          field("pad.oscillation.phase", NumberKind{member<&Case::pad, &Pad::oscillation, &PadOscillation::phase_deg>},
                {"degree", "degree"}, between(-360, 360), Need::kDefault, kOscillation,
                {"phase of the oscillation at t = 0", "\"0 degree\""}),
      });
}

}  // namespace ringfilm::cycle::table
