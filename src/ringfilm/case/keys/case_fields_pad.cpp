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
          field(
              {.key = "pad.length",
               .kind = NumberKind{member<&Case::pad, &Pad::length>},
               .unit = mm,
               .range = above(0, 1e3),
               .need = Need::kRequired,
               .help =
                   "length along the motion, L; any key of [pad] makes the case a film of stated shape without engine, "
                   "gas and ring",
               .example = "\"76.2 mm\"",
               .uses = {.cycle = false, .pad = true}}),
          field({.key = "pad.width",
                 .kind = OptionalNumberKind{member<&Case::pad, &Pad::width>},
                 .unit = mm,
                 .range = above(0, 1e3),
                 .need = Need::kOptional,
                 .help = "width across the motion, B; if omitted, the pad is infinitely wide",
                 .example = "\"50 mm\"",
                 .uses = {.cycle = false, .pad = true}}),
          field(
              {.key = "pad.gap",
               .kind = FileKind{member<&Case::pad, &Pad::gap_file>},
               .need = Need::kRequired,
               .when = kGapPoints,
               .help =
                   "CSV file x [mm],h [um] of the gap from x = 0 to the length, g; straight between points, the same x "
                   "twice is a step; with a width also a map, CSV x [mm],y [mm],h [um] or NetCDF h(y, x); in its place "
                   "[pad.face] gives the gap by a formula",
               .example = "\"gap.csv\"",
               .uses = {.cycle = false, .pad = true}}),
          field({.key = "pad.speed",
                 .kind = NumberKind{member<&Case::pad, &Pad::speed>},
                 .unit = {"m/s", "m/s"},
                 .range = between(0, 1e5),
                 .need = Need::kRequired,
                 .help = "speed of the flat surface, U; the pad and its gap stand still",
                 .example = "\"4.57 m/s\"",
                 .uses = {.cycle = false, .pad = true}}),
          field({.key = "pad.direction",
                 .kind = choice<&Case::pad, &Pad::direction>({{"+x", Direction::kPlusX}, {"-x", Direction::kMinusX}}),
                 .help = "which way the flat surface moves",
                 .example = "\"+x\"",
                 .uses = {.cycle = false, .pad = true}}),
          field({.key = "pad.left_pressure",
                 .kind = NumberKind{member<&Case::pad, &Pad::left_pressure>},
                 .unit = bar,
                 .range = pressure,
                 .need = Need::kRequired,
                 .help = "pressure at x = 0, from the zero that the case chooses",
                 .example = "\"0 bar\"",
                 .uses = {.cycle = false, .pad = true}}),
          field({.key = "pad.right_pressure",
                 .kind = NumberKind{member<&Case::pad, &Pad::right_pressure>},
                 .unit = bar,
                 .range = pressure,
                 .need = Need::kRequired,
                 .help = "pressure at x = length, from the same zero",
                 .example = "\"0 bar\"",
                 .uses = {.cycle = false, .pad = true}}),
          field({.key = "pad.sides",
                 .kind = choice<&Case::pad, &Pad::sides>(
                     {{"open", Sides::kOpen}, {"periodic", Sides::kPeriodic}, {"closed", Sides::kClosed}}),
                 .when = kFiniteWidth,
                 .help = "what the film ends at across the motion: stated pressures, its own other side, or walls",
                 .example = "\"open\"",
                 .uses = {.cycle = false, .pad = true}}),
          field({.key = "pad.front_pressure",
                 .kind = NumberKind{member<&Case::pad, &Pad::front_pressure>},
                 .unit = bar,
                 .range = pressure,
                 .need = Need::kRequired,
                 .when = kOpenSides,
                 .help = "pressure at y = 0, from the same zero",
                 .example = "\"0 bar\"",
                 .uses = {.cycle = false, .pad = true}}),
          field({.key = "pad.back_pressure",
                 .kind = NumberKind{member<&Case::pad, &Pad::back_pressure>},
                 .unit = bar,
                 .range = pressure,
                 .need = Need::kRequired,
                 .when = kOpenSides,
                 .help = "pressure at y = width, from the same zero",
                 .example = "\"0 bar\"",
                 .uses = {.cycle = false, .pad = true}}),
          field({.key = "pad.separation",
                 .kind = OptionalNumberKind{member<&Case::pad, &Pad::separation>},
                 .unit = um,
                 .range = between(-1, 1),
                 .need = Need::kOptional,
                 .help = "added to the gap everywhere: h = g + s",
                 .example = "\"0 um\"",
                 .uses = {.cycle = false, .pad = true}}),
          field({.key = "pad.load",
                 .kind = OptionalNumberKind{member<&Case::pad, &Pad::load>},
                 .unit = {"N/m", "N/m"},
                 .range = above(0, 1e12),
                 .need = Need::kOptional,
                 .help = "load per metre of width that the film carries; the separation is found",
                 .example = "\"100000 N/m\"",
                 .uses = {.cycle = false, .pad = true}}),
          field({.key = "pad.separation_history",
                 .kind = OptionalFileKind{member<&Case::pad, &Pad::separation_history_file>},
                 .need = Need::kOptional,
                 .help = "CSV file time [s],h [um] of the separation, straight between points",
                 .example = "\"separation.csv\"",
                 .uses = {.cycle = false, .pad = true}}),
          field({.key = "pad.time_step",
                 .kind = NumberKind{member<&Case::pad, &Pad::time_step>},
                 .unit = second,
                 .range = above(0, 1e9),
                 .need = Need::kRequired,
                 .when = kTransient,
                 .help = "time step of the integration",
                 .example = "\"0.001 s\"",
                 .uses = {.cycle = false, .pad = true}}),
          field({.key = "pad.end_time",
                 .kind = OptionalNumberKind{member<&Case::pad, &Pad::end_time>},
                 .unit = second,
                 .range = time,
                 .need = Need::kOptional,
                 .when = kTransient,
                 .help = "where the integration ends; if omitted, with the history; required with an oscillation",
                 .example = "\"1 s\"",
                 .uses = {.cycle = false, .pad = true}}),
          field({.key = "pad.output_step",
                 .kind = OptionalNumberKind{member<&Case::pad, &Pad::output_step>},
                 .unit = second,
                 .range = above(0, 1e9),
                 .need = Need::kOptional,
                 .when = kTransient,
                 .help = "spacing of the instants that are kept, whole time steps; if omitted, every step",
                 .example = "\"0.01 s\"",
                 .uses = {.cycle = false, .pad = true}}),
          field({.key = "pad.face.form",
                 .kind = choice<&Case::pad, &Pad::face, &FaceShape::form>({{"polynomial", FaceForm::kPolynomial},
                                                                           {"parabola", FaceForm::kParabola},
                                                                           {"points", FaceForm::kPoints},
                                                                           {"cosine", FaceForm::kCosine}}),
                 .help =
                     "how the gap, g(x), is given: points are those of pad.gap; with a width a formula is the same at "
                     "every y",
                 .example = "\"parabola\"",
                 .uses = {.cycle = false, .pad = true}}),
      });
  const std::vector<Field> formula = face_fields<&Case::pad, &Pad::face>(
      {"pad.face",
       "\"parabola\" or \"cosine\"",
       "height of the parabola at the edge farther from its lowest point; of the cosine, which has one "
       "period along the pad, from its lowest to its highest point",
       1,
       "length",
       {.cycle = false, .pad = true}});
  fields.insert(fields.end(), formula.begin(), formula.end());
  fields.insert(
      fields.end(),
      {
          field({.key = "pad.oscillation.amplitude",
                 .kind = OptionalNumberKind{member<&Case::pad, &Pad::oscillation, &PadOscillation::amplitude>},
                 .unit = um,
                 .range = above(0, 1),
                 .need = Need::kOptional,
                 .when = kSeparation,
                 .help =
                     "the separation oscillates about pad.separation: s(t) = s + amplitude cos(2 pi t/period + phase)",
                 .example = "\"2 um\"",
                 .uses = {.cycle = false, .pad = true}}),
          field({.key = "pad.oscillation.period",
                 .kind = NumberKind{member<&Case::pad, &Pad::oscillation, &PadOscillation::period>},
                 .unit = second,
                 .range = above(0, 1e9),
                 .need = Need::kRequired,
                 .when = kOscillation,
                 .help = "period of the oscillation",
                 .example = "\"0.01 s\"",
                 .uses = {.cycle = false, .pad = true}}),
          field({.key = "pad.oscillation.phase",
                 .kind = NumberKind{member<&Case::pad, &Pad::oscillation, &PadOscillation::phase_deg>},
                 .unit = {"degree", "degree"},
                 .range = between(-360, 360),
                 .when = kOscillation,
                 .help = "phase of the oscillation at t = 0",
                 .example = "\"0 degree\"",
                 .uses = {.cycle = false, .pad = true}}),
      });
}

}  // namespace ringfilm::cycle::table
