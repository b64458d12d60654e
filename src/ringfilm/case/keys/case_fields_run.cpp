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
constexpr When kBroken{[](const Case& c) {
                         const bool is_pad = c.problem == Problem::kPad;
                         return c.film.cavitation == Cavitation::kMassConserving &&
                                (is_pad ? c.film.has_gas_edge_of_pad() : c.film.has_gas_edge());
                       },
                       "an edge of the film is \"gas\", and film.cavitation = \"mass-conserving\""};
constexpr When kNotFlooded{[](const Case& c) { return c.film.supply_at_inlet() != OilSupply::kFlooded; },
                           "film.supply is not \"flooded\""};
constexpr When kRingFilm{[](const Case& c) { return c.problem != Problem::kPad; }, "the film is not that of a pad"};
constexpr When kFaceFilm{[](const Case& c) { return !c.is_unrolled() && c.problem != Problem::kPad; },
                         "film.dimension = \"face\", and not of a pad"};
constexpr When kFilmOnLiner{[](const Case& c) { return c.film.supply_at_inlet() == OilSupply::kFilmOnLiner; },
                            "film.supply = \"film-on-liner\""};
constexpr When kLandTable{[](const Case& c) { return c.film.land_lift == LandLift::kTable; },
                          "film.land_lift = \"table\""};
constexpr When kPattern{[](const Case& c) { return c.film.has_factors(Roughness::kPatirCheng); },
                        "film.flow_factors, film.shear_flow or film.stress_factors = \"patir-cheng\""};

std::string edge_help(const std::string& edge, const std::string& stroke) {
  return "what the " + edge + " edge of the face meets on the " + stroke +
         ", where the film leaves there: oil, or gas that fills the face up to the meniscus; where the film enters "
         "there, film.supply states how much oil is at hand";
}

}  // namespace

void append_run_fields(std::vector<Field>& fields) {
  fields.insert(
      fields.end(),
      {
          field({.key = "film.dimension",
                 .kind = choice<&Case::film, &Film::dimension>(
                     {{"face", FilmDimension::kFace}, {"unrolled", FilmDimension::kUnrolled}}),
                 .help = "film across the face alone, alike all around, or on the whole unrolled ring with the ends of "
                         "its gap",
                 .example = "\"face\""}),
          field({.key = "film.cavitation",
                 .kind = choice<&Case::film, &Film::cavitation>(
                     {{"reynolds-exit", Cavitation::kReynoldsExit}, {"mass-conserving", Cavitation::kMassConserving}}),
                 .help = "where the film ruptures: pressure never below p_c (Reynolds), or also mass kept (JFO)",
                 .example = "\"mass-conserving\"",
                 .uses = {.pad = true}}),
          field({.key = "film.cavitation_pressure",
                 .kind = NumberKind{member<&Case::film, &Film::cavitation_pressure>},
                 .unit = kBar,
                 .range = between(-1e9, 1e9),
                 .help = "pressure at which the film ruptures, p_c; never above the pressures at the edges; absolute "
                         "for a ring",
                 .example = "\"1.01325 bar\"",
                 .uses = {.pad = true}}),
          field({.key = "film.chamber_edge",
                 .kind = choice<&Case::film, &Film::chamber_edge>({{"oil", EdgeFluid::kOil}, {"gas", EdgeFluid::kGas}}),
                 .help = edge_help("chamber", "downstroke"),
                 .example = "\"gas\""}),
          field(
              {.key = "film.crankcase_edge",
               .kind = choice<&Case::film, &Film::crankcase_edge>({{"oil", EdgeFluid::kOil}, {"gas", EdgeFluid::kGas}}),
               .help = edge_help("crankcase", "upstroke"),
               .example = "\"gas\""}),
          field({.key = "film.supply",
                 .kind = choice<&Case::film, &Film::supply>({{"flooded", OilSupply::kFlooded},
                                                             {"given", OilSupply::kGiven},
                                                             {"film-on-liner", OilSupply::kFilmOnLiner}}),
                 .when = kGasEdge,
                 .help = "oil at an edge of gas where the film enters: as much as it takes, the same film on every "
                         "stroke, or "
                         "what earlier strokes left on the liner",
                 .example = "\"film-on-liner\""}),
          field({.key = "film.broken",
                 .kind = choice<&Case::film, &Film::broken>({{"free-surface", BrokenFilm::kFreeSurface},
                                                             {"half-passes", BrokenFilm::kHalfPasses},
                                                             {"nothing-passes", BrokenFilm::kNothingPasses}}),
                 .when = kBroken,
                 .help = "oil that passes the lowest place of the face while gas blows through there against the "
                         "motion: what a film with a free surface carries on the liner, half of the gap as without "
                         "gas, or none; assumed",
                 .example = "\"free-surface\"",
                 .uses = {.pad = true}}),
          field({.key = "film.outlet",
                 .kind = choice<&Case::film, &Film::outlet>(
                     {{"half-gap", Outlet::kHalfGap}, {"capillary", Outlet::kCapillary}}),
                 .when = kNotFlooded,
                 .help = "what lies on the liner where it drains oil that hangs on the face behind the film: half of "
                         "the gap, or less as the capillary number falls; assumed",
                 .example = "\"half-gap\""}),
          field({.key = "film.left_edge",
                 .kind = choice<&Case::film, &Film::left_edge>({{"oil", EdgeFluid::kOil}, {"gas", EdgeFluid::kGas}}),
                 .help = "what the film meets at x = 0: oil, which floods it, or gas at pad.left_pressure",
                 .example = "\"gas\"",
                 .uses = {.cycle = false, .pad = true}}),
          field({.key = "film.right_edge",
                 .kind = choice<&Case::film, &Film::right_edge>({{"oil", EdgeFluid::kOil}, {"gas", EdgeFluid::kGas}}),
                 .help = "what the film meets at x = length: oil, or gas at pad.right_pressure",
                 .example = "\"gas\"",
                 .uses = {.cycle = false, .pad = true}}),
          field({.key = "film.supply_left",
                 .kind = OptionalNumberKind{member<&Case::film, &Film::supply_left>},
                 .unit = kMicrometre,
                 .range = above(0, 1),
                 .need = Need::kRequired,
                 .when = kInletLeft,
                 .help = "film on the flat surface that comes in at x = 0, out of the gas, f",
                 .example = "\"2 um\"",
                 .uses = {.cycle = false, .pad = true}}),
          field({.key = "film.supply_right",
                 .kind = OptionalNumberKind{member<&Case::film, &Film::supply_right>},
                 .unit = kMicrometre,
                 .range = above(0, 1),
                 .need = Need::kRequired,
                 .when = kInletRight,
                 .help = "film on the flat surface that comes in at x = length, out of the gas, f",
                 .example = "\"2 um\"",
                 .uses = {.cycle = false, .pad = true}}),
          field({.key = "film.flow_factors",
                 .kind = choice<&Case::film, &Film::flow_factors>({{"none", Roughness::kNone},
                                                                   {"patir-cheng", Roughness::kPatirCheng},
                                                                   {"measured", Roughness::kMeasured}}),
                 .help =
                     "flow by pressure: that of smooth walls, or with the factors phi_x and, unrolled, phi_y of rough "
                     "ones, of the literature from h(x)/sigma or of the gap of contact.law",
                 .example = "\"patir-cheng\"",
                 .uses = {.pad = true}}),
          field({.key = "film.shear_flow",
                 .kind = choice<&Case::film, &Film::shear_flow>({{"none", Roughness::kNone},
                                                                 {"patir-cheng", Roughness::kPatirCheng},
                                                                 {"measured", Roughness::kMeasured}}),
                 .help =
                     "flow by sliding: that of smooth walls, or with what the roughness of one of them carries, phi_s",
                 .example = "\"patir-cheng\"",
                 .uses = {.pad = true}}),
          field({.key = "film.stress_factors",
                 .kind = choice<&Case::film, &Film::stress_factors>({{"none", Roughness::kNone},
                                                                     {"patir-cheng", Roughness::kPatirCheng},
                                                                     {"measured", Roughness::kMeasured}}),
                 .help =
                     "shear stress: that of smooth walls, or with the factors phi_f, phi_fp and, with film.shear_flow, "
                     "phi_fs of rough ones; measured: with the true gaps of contact.law, and no stress beyond that of "
                     "contact.eyring_shear_stress",
                 .example = "\"patir-cheng\"",
                 .uses = {.pad = true}}),
          field({.key = "film.average_gap",
                 .kind = choice<&Case::film, &Film::average_gap>({{"nominal", AverageGap::kNominal},
                                                                  {"truncated", AverageGap::kTruncated},
                                                                  {"measured", AverageGap::kMeasured}}),
                 .help =
                     "film thickness that the gap stores and the liner carries: the nominal one, or the mean of that "
                     "between Gaussian surfaces that do not overlap, or of the true gap of contact.law",
                 .example = "\"nominal\"",
                 .uses = {.pad = true}}),
          field(
              {.key = "film.land_lift",
               .kind = choice<&Case::film, &Film::land_lift>({{"none", LandLift::kNone}, {"table", LandLift::kTable}}),
               .help = "lift of the honing, beside the film of the face: none, or by a table of a scan",
               .example = "\"table\""}),
          field({.key = "film.land_law",
                 .kind = FileKind{member<&Case::film, &Film::land_law_file>},
                 .need = Need::kRequired,
                 .when = kLandTable,
                 .help = "lift of a land that ringfilm land --output wrote, or a CSV with its columns",
                 .example = "\"land.nc\""}),
          field({.key = "film.land_factor",
                 .kind = NumberKind{member<&Case::film, &Film::land_factor>},
                 .unit = kPlainNumber,
                 .range = above(0, 1e3),
                 .when = kLandTable,
                 .help = "factor of the lift in film.land_law, for its band over patches",
                 .example = "1.0"}),
          field(
              {.key = "film.orientation",
               .kind = NumberKind{member<&Case::film, &Film::orientation>},
               .unit = kPlainNumber,
               .range = above(0, 1e6),
               .when = kPattern,
               .help =
                   "orientation of the roughness, gamma: its correlation length along the motion over that across it; "
                   "below 1 ridges across, 1 isotropic, above 1 ridges along; tables reach from 1/9 to 9",
               .example = "1.0",
               .uses = {.pad = true}}),
          field({.key = "supply.film",
                 .kind = StrokeValuesKind{member<&Case::supply, &Supply::film>},
                 .unit = kMicrometre,
                 .range = above(0, 1e-3),
                 .need = Need::kOptional,
                 .when = kNotFlooded,
                 .help = "film on the liner ahead of the ring, f; with film-on-liner what the oil ring leaves on "
                         "downstrokes; or "
                         "[distance of the ring from its TDC position, film] at increasing distances, linear between "
                         "them and "
                         "constant beyond",
                 .example = "\"2 um\""}),
          field(
              {.key = "supply.reach",
               .kind = OptionalNumberKind{member<&Case::supply, &Supply::reach>},
               .unit = kMillimetre,
               .range = between(0, 5),
               .need = Need::kOptional,
               .when = kFilmOnLiner,
               .help =
                   "distance below the TDC position of the chamber edge from which on the oil ring lays its film ahead "
                   "of the ring "
                   "on each downstroke",
               .example = "\"10 mm\""}),
          field({.key = "supply.scraped",
                 .kind = choice<&Case::supply, &Supply::scraped>(
                     {{"bead", Scraped::kBead}, {"discarded", Scraped::kDiscarded}}),
                 .when = kFilmOnLiner,
                 .help = "oil that the inlet does not take: it stays ahead of the edge as a bead until the stroke "
                         "ends, or is "
                         "lost at once",
                 .example = "\"bead\""}),
          field({.key = "solver.accuracy",
                 .kind = OptionalNumberKind{member<&Case::solver, &Solver::accuracy>},
                 .unit = si_unit("%"),
                 .range = between(0.05, 10),
                 .need = Need::kOptional,
                 .when = kFaceFilm,
                 .help = "accuracy that values of the cycle are to reach; it chooses cells, cell_lengths, crank_step, "
                         "crank_step_control, time_scheme, step_error and tolerance in place of what is stated there",
                 .example = "\"0.5 %\""}),
          field({.key = "solver.cells",
                 .kind = CountKind{member<&Case::solver, &Solver::cells>},
                 .unit = kPlainNumber,
                 .range = between(8, 100000),
                 .help = "cells across the face",
                 .example = "200",
                 .uses = {.pad = true}}),
          field({.key = "solver.cell_lengths",
                 .kind = choice<&Case::solver, &Solver::cell_lengths>(
                     {{"uniform", CellLengths::kUniform}, {"by-gap", CellLengths::kByGap}}),
                 .when = kRingFilm,
                 .help = "cells of one length, or short ones where the face is low",
                 .example = "\"uniform\""}),
          field({.key = "solver.cells_y",
                 .kind = CountKind{member<&Case::solver, &Solver::cells_y>},
                 .unit = kPlainNumber,
                 .range = between(4, 100000),
                 .when = kTwoDimensions,
                 .help = "cells around the ring, or across the pad",
                 .example = "180",
                 .uses = {.pad = true}}),
          field(
              {.key = "solver.end_cell",
               .kind = OptionalNumberKind{member<&Case::solver, &Solver::end_cell>},
               .unit = kMicrometre,
               .range = above(0, 1),
               .need = Need::kOptional,
               .when = kGapEnds,
               .help = "length around the ring of the cells at the ends of its gap; if omitted, 1/50 of the face width",
               .example = "\"24 um\""}),
          field({.key = "solver.crank_step",
                 .kind = NumberKind{member<&Case::solver, &Solver::crank_step_deg>},
                 .unit = si_unit("degree"),
                 .range = above(0, 15),
                 .help = "crank step of the integration; whole steps must make 720 degrees",
                 .example = "\"1 degree\""}),
          field({.key = "solver.crank_step_control",
                 .kind = choice<&Case::solver, &Solver::crank_step_control>(
                     {{"adaptive", StepControl::kAdaptive}, {"fixed", StepControl::kFixed}}),
                 .help = "refine the crank step where the film needs it, or integrate with the stated step alone",
                 .example = "\"adaptive\""}),
          field(
              {.key = "solver.time_scheme",
               .kind = choice<&Case::solver, &Solver::time_scheme>(
                   {{"backward-euler", TimeScheme::kBackwardEuler}, {"bdf2", TimeScheme::kBdf2}}),
               .when = kRingFilm,
               .help = "a step follows from the film before it (first order), or from the two before it (second order)",
               .example = "\"bdf2\""}),
          field({.key = "solver.step_error",
                 .kind = NumberKind{member<&Case::solver, &Solver::step_error>},
                 .unit = kPlainNumber,
                 .range = between(1e-8, 0.1),
                 .when = {[](const Case& c) {
                            return c.solver.crank_step_control == StepControl::kAdaptive ||
                                   c.film.supply_at_inlet() == OilSupply::kFilmOnLiner;
                          },
                          "solver.crank_step_control = \"adaptive\" or film.supply = \"film-on-liner\""},
                 .help =
                     "error that one step may make in the logarithm of the film, weighted by contact with bdf2; in the "
                     "oil "
                     "on the face eight times as much with bdf2, half with backward-euler; and share of the oil on the "
                     "liner that a cycle, and all cycles to come by estimate, may move",
                 .example = "1e-3"}),
          field({.key = "solver.tolerance",
                 .kind = NumberKind{member<&Case::solver, &Solver::tolerance>},
                 .unit = kPlainNumber,
                 .range = between(1e-14, 1e-2),
                 .help = "relative error that the iteration may leave in film and pressure",
                 .example = "1e-8",
                 .uses = {.pad = true}}),
          field({.key = "solver.method",
                 .kind = choice<&Case::solver, &Solver::method>({{"coupled-newton", Method::kCoupledNewton},
                                                                 {"point-relaxation", Method::kPointRelaxation},
                                                                 {"menisci", Method::kMenisci}}),
                 .help = "how film and load balance are solved: on cells the fast way, or the paper's; or without "
                         "cells, a film between two menisci that follows the oil on the liner, which takes a tenth of "
                         "the time (on cells the fast way, with a note, where the case has no such film)",
                 .example = "\"coupled-newton\""}),
          field(
              {.key = "solver.properties",
               .kind = choice<&Case::solver, &Solver::properties>(
                   {{"fitted", Properties::kFitted}, {"exact", Properties::kExact}}),
               .help =
                   "what the iteration asks: polynomials fitted to the laws of oil and contact, or the laws themselves",
               .example = "\"fitted\""}),
          field({.key = "output.crank_angles",
                 .kind = AnglesKind{},
                 .unit = si_unit("degree"),
                 .range = above(0, 90),
                 .help = "crank angles of the result: a step, or a list of angles counted from firing TDC",
                 .example = "\"1 degree\"",
                 .is_for_record = true}),
          field({.key = "output.fields",
                 .kind = FieldAnglesKind{},
                 .unit = si_unit("degree"),
                 .help = "pressure and film along the face: \"none\", \"all\", or a list of crank angles",
                 .example = "\"none\"",
                 .is_for_record = true}),
          field({.key = "output.reduction",
                 .kind = choice<&Case::output, &Output::reduction>(
                     {{"none", FieldReduction::kNone}, {"along-face", FieldReduction::kAlongFace}}),
                 .when = kUnrolledFields,
                 .help = "fields of an unrolled film at each place, or only what each strip across the face sums up to",
                 .example = "\"none\"",
                 .is_for_record = true}),
      });
}

}  // namespace ringfilm::cycle::table
