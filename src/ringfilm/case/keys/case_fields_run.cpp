#include "ringfilm/case/keys/case_fields_table.hpp"

namespace ringfilm::cycle::table {
namespace {

constexpr When kTwoDimensions{
    [](const Case& c) { return c.is_unrolled() || (c.problem == Problem::kPad && c.pad.width.has_value()); },
    "film.dimension = \"unrolled\", or pad.width is given"};
constexpr When kGapEnds{[](const Case& c) { return c.is_unrolled() && c.ring.end_gap.has_value(); },
                        "ring.end_gap is stated"};
constexpr When kUnrolledFields{[](const Case& c) { return c.is_unrolled() && c.output.fields != FieldOutput::kNone; },
                               "film.dimension = \"unrolled\" and output.fields are asked for"};

constexpr When kInletLeft{[](const Case& c) { return c.enters_out_of_gas(Direction::kPlusX); },
                          "film.left_edge = \"gas\", pad.direction = \"+x\" and pad.speed is not 0"};
constexpr When kInletRight{[](const Case& c) { return c.enters_out_of_gas(Direction::kMinusX); },
                           "film.right_edge = \"gas\", pad.direction = \"-x\" and pad.speed is not 0"};

constexpr When kGasEdge{[](const Case& c) { return c.film.has_gas_edge(); },
                        "film.chamber_edge or film.crankcase_edge is \"gas\""};
constexpr When kNotFlooded{[](const Case& c) { return c.film.supply_at_inlet() != OilSupply::kFlooded; },
                           "film.supply is not \"flooded\""};
constexpr When kRingFilm{[](const Case& c) { return c.problem != Problem::kPad; }, "the film is not that of a pad"};
constexpr When kFaceFilm{[](const Case& c) { return !c.is_unrolled() && c.problem != Problem::kPad; },
                         "film.dimension = \"face\", and not of a pad"};
constexpr When kFilmOnLiner{[](const Case& c) { return c.film.supply_at_inlet() == OilSupply::kFilmOnLiner; },
                            "film.supply = \"film-on-liner\""};
constexpr When kPattern{[](const Case& c) { return c.film.has_factors(Roughness::kPatirCheng); },
                        "film.flow_factors, film.shear_flow or film.stress_factors = \"patir-cheng\""};

std::string edge_help(const std::string& edge, const std::string& stroke) {
  return "what the " + edge + " edge of the face meets on the " + stroke +
         ", where the film leaves there: oil, or gas that fills the face up to the meniscus; where the film enters "
         "there, film.supply states how much oil is at hand";
}

}  // namespace

void append_run_fields(std::vector<Field>& fields) {
  const Unit degree{"degree", "degree"};
  fields.insert(
      fields.end(),
      {
          field("film.dimension", choice<&Case::film, &Film::dimension>({"face", "unrolled"}), kNoUnit, {},
                Need::kDefault, {},
                {"film across the face alone, alike all around, or on the whole unrolled ring with the ends of its gap",
                 "\"face\""}),
          field("film.cavitation", choice<&Case::film, &Film::cavitation>({"reynolds-exit", "mass-conserving"}),
                kNoUnit, {}, Need::kDefault, {},
                {"where the film ruptures: pressure never below p_c (Reynolds), or also mass kept (JFO)",
                 "\"mass-conserving\""}),
          field(
              "film.cavitation_pressure", NumberKind{member<&Case::film, &Film::cavitation_pressure>}, {"Pa", "bar"},
              between(-1e9, 1e9), Need::kDefault, {},
              {"pressure at which the film ruptures, p_c; never above the pressures at the edges; absolute for a ring",
               "\"1.01325 bar\""}),
          field("film.chamber_edge", choice<&Case::film, &Film::chamber_edge>({"oil", "gas"}), kNoUnit, {},
                Need::kDefault, {}, {edge_help("chamber", "downstroke"), "\"gas\""}),
          field("film.crankcase_edge", choice<&Case::film, &Film::crankcase_edge>({"oil", "gas"}), kNoUnit, {},
                Need::kDefault, {}, {edge_help("crankcase", "upstroke"), "\"gas\""}),
          field("film.supply", choice<&Case::film, &Film::supply>({"flooded", "given", "film-on-liner"}), kNoUnit, {},
                Need::kDefault, kGasEdge,
                {"oil at an edge of gas where the film enters: as much as it takes, the same film on every stroke, or "
                 "what earlier strokes left on the liner",
                 "\"film-on-liner\""}),
          field("film.left_edge", choice<&Case::film, &Film::left_edge>({"oil", "gas"}), kNoUnit, {}, Need::kDefault,
                {}, {"what the film meets at x = 0: oil, which floods it, or gas at pad.left_pressure", "\"gas\""}),
          field("film.right_edge", choice<&Case::film, &Film::right_edge>({"oil", "gas"}), kNoUnit, {}, Need::kDefault,
                {}, {"what the film meets at x = length: oil, or gas at pad.right_pressure", "\"gas\""}),
          field("film.supply_left", OptionalNumberKind{member<&Case::film, &Film::supply_left>}, {"m", "um"},
                above(0, 1), Need::kRequired, kInletLeft,
                {"film on the flat surface that comes in at x = 0, out of the gas, f", "\"2 um\""}),
          field("film.supply_right", OptionalNumberKind{member<&Case::film, &Film::supply_right>}, {"m", "um"},
                above(0, 1), Need::kRequired, kInletRight,
                {"film on the flat surface that comes in at x = length, out of the gas, f", "\"2 um\""}),
          field("film.flow_factors", choice<&Case::film, &Film::flow_factors>({"none", "patir-cheng", "measured"}),
                kNoUnit, {}, Need::kDefault, {},
                {"flow by pressure: that of smooth walls, or with the factors phi_x and, unrolled, phi_y of rough "
                 "ones, of the literature from h(x)/sigma or of the gap of contact.law",
                 "\"patir-cheng\""}),
          field("film.shear_flow", choice<&Case::film, &Film::shear_flow>({"none", "patir-cheng", "measured"}), kNoUnit,
                {}, Need::kDefault, {},
                {"flow by sliding: that of smooth walls, or with what the roughness of one of them carries, phi_s",
                 "\"patir-cheng\""}),
          field("film.stress_factors", choice<&Case::film, &Film::stress_factors>({"none", "patir-cheng", "measured"}),
                kNoUnit, {}, Need::kDefault, {},
                {"shear stress: that of smooth walls, or with the factors phi_f, phi_fp and, with film.shear_flow, "
                 "phi_fs of rough ones; measured: with the true gaps of contact.law, and no stress beyond that of "
                 "contact.eyring_shear_stress",
                 "\"patir-cheng\""}),
          field("film.average_gap", choice<&Case::film, &Film::average_gap>({"nominal", "truncated", "measured"}),
                kNoUnit, {}, Need::kDefault, {},
                {"film thickness that the gap stores and the liner carries: the nominal one, or the mean of that "
                 "between Gaussian surfaces that do not overlap, or of the true gap of contact.law",
                 "\"nominal\""}),
          field("film.orientation", NumberKind{member<&Case::film, &Film::orientation>}, kPlainNumber, above(0, 1e6),
                Need::kDefault, kPattern,
                {"orientation of the roughness, gamma: its correlation length along the motion over that across it; "
                 "below 1 ridges across, 1 isotropic, above 1 ridges along; tables reach from 1/9 to 9",
                 "1.0"}),
          field(
              "supply.film", StrokeValuesKind{member<&Case::supply, &Supply::film>}, {"m", "um"}, above(0, 1e-3),
              Need::kOptional, kNotFlooded,
              {"film on the liner ahead of the ring, f; with film-on-liner what the oil ring leaves on downstrokes; or "
               "[distance of the ring from its TDC position, film] at increasing distances, linear between them and "
               "constant beyond",
               "\"2 um\""}),
          field("supply.reach", OptionalNumberKind{member<&Case::supply, &Supply::reach>}, {"m", "mm"}, between(0, 5),
                Need::kOptional, kFilmOnLiner,
                {"distance below the TDC position of the chamber edge from which on the oil ring lays its film ahead "
                 "of the ring "
                 "on each downstroke",
                 "\"10 mm\""}),
          field("supply.scraped", choice<&Case::supply, &Supply::scraped>({"bead", "discarded"}), kNoUnit, {},
                Need::kDefault, kFilmOnLiner,
                {"oil that the inlet does not take: it stays ahead of the edge as a bead until the stroke ends, or is "
                 "lost at once",
                 "\"bead\""}),
          field("solver.accuracy", OptionalNumberKind{member<&Case::solver, &Solver::accuracy>}, {"%", "%"},
                between(0.05, 10), Need::kOptional, kFaceFilm,
                {"accuracy that values of the cycle are to reach; it chooses cells, cell_lengths, crank_step, "
                 "crank_step_control, time_scheme, step_error and tolerance in place of what is stated there",
                 "\"0.5 %\""}),
          field("solver.cells", CountKind{member<&Case::solver, &Solver::cells>}, kPlainNumber, between(8, 100000),
                Need::kDefault, {}, {"cells across the face", "200"}),
          field("solver.cell_lengths", choice<&Case::solver, &Solver::cell_lengths>({"uniform", "by-gap"}), kNoUnit, {},
                Need::kDefault, kRingFilm, {"cells of one length, or short ones where the face is low", "\"uniform\""}),
          field("solver.cells_y", CountKind{member<&Case::solver, &Solver::cells_y>}, kPlainNumber, between(4, 100000),
                Need::kDefault, kTwoDimensions, {"cells around the ring, or across the pad", "180"}),
          field("solver.end_cell", OptionalNumberKind{member<&Case::solver, &Solver::end_cell>}, {"m", "um"},
                above(0, 1), Need::kOptional, kGapEnds,
                {"length around the ring of the cells at the ends of its gap; if omitted, 1/50 of the face width",
                 "\"24 um\""}),
          field("solver.crank_step", NumberKind{member<&Case::solver, &Solver::crank_step_deg>}, degree, above(0, 15),
                Need::kDefault, {},
                {"crank step of the integration; whole steps must make 720 degrees", "\"1 degree\""}),
          field("solver.crank_step_control", choice<&Case::solver, &Solver::crank_step_control>({"adaptive", "fixed"}),
                kNoUnit, {}, Need::kDefault, {},
                {"refine the crank step where the film needs it, or integrate with the stated step alone",
                 "\"adaptive\""}),
          field("solver.time_scheme", choice<&Case::solver, &Solver::time_scheme>({"backward-euler", "bdf2"}), kNoUnit,
                {}, Need::kDefault, kRingFilm,
                {"a step follows from the film before it (first order), or from the two before it (second order)",
                 "\"bdf2\""}),
          field("solver.step_error", NumberKind{member<&Case::solver, &Solver::step_error>}, kPlainNumber,
                between(1e-8, 0.1), Need::kDefault,
                {[](const Case& c) {
                   return c.solver.crank_step_control == StepControl::kAdaptive ||
                          c.film.supply_at_inlet() == OilSupply::kFilmOnLiner;
                 },
                 "solver.crank_step_control = \"adaptive\" or film.supply = \"film-on-liner\""},
                {"error that one step may make in the logarithm of the film, weighted by contact with bdf2; in the oil "
                 "on the face eight times as much with bdf2, half with backward-euler; and share of the oil on the "
                 "liner that a cycle, and all cycles to come by estimate, may move",
                 "1e-3"}),
          field("solver.tolerance", NumberKind{member<&Case::solver, &Solver::tolerance>}, kPlainNumber,
                between(1e-14, 1e-2), Need::kDefault, {},
                {"relative error that the iteration may leave in film and pressure", "1e-8"}),
          field("solver.method",
                choice<&Case::solver, &Solver::method>({"coupled-newton", "point-relaxation", "nested-secant"}),
                kNoUnit, {}, Need::kDefault, {},
                {"how film and load balance are solved: the fast way, the paper's, or two nested loops",
                 "\"coupled-newton\""}),
          field("solver.properties", choice<&Case::solver, &Solver::properties>({"fitted", "exact"}), kNoUnit, {},
                Need::kDefault, {},
                {"what the iteration asks: polynomials fitted to the laws of oil and contact, or the laws themselves",
                 "\"fitted\""}),
          field("output.crank_angles", AnglesKind{}, degree, above(0, 90), Need::kDefault, {},
                {"crank angles of the result: a step, or a list of angles counted from firing TDC", "\"1 degree\""}),
          field("output.fields", FieldAnglesKind{}, degree, {}, Need::kDefault, {},
                {"pressure and film along the face: \"none\", \"all\", or a list of crank angles", "\"none\""}),
          field("output.reduction", choice<&Case::output, &Output::reduction>({"none", "along-face"}), kNoUnit, {},
                Need::kDefault, kUnrolledFields,
                {"fields of an unrolled film at each place, or only what each strip across the face sums up to",
                 "\"none\""}),
      });
}

}  // namespace ringfilm::cycle::table
