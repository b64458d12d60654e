#include "ringfilm/case/keys/case_fields_table.hpp"

namespace ringfilm::cycle::table {
namespace {

constexpr When kPoints{[](const Case& c) { return c.ring.face.form == FaceForm::kPoints; },
                       "ring.face.form = \"points\""};
constexpr When kFourModuli{[](const Case& c) { return !c.contact.composite_modulus; },
                           "contact.composite_modulus is not stated"};
constexpr When kFourModuliOrFreeGap{
    [](const Case& c) { return !c.contact.composite_modulus || c.ring.free_gap || c.ring.thickness(); },
    "contact.composite_modulus is not stated, or ring.radial_thickness or ring.section is stated"};

constexpr When kGap{[](const Case& c) {
                      return c.is_unrolled() || c.gas_path.is_computed() || c.purpose == CasePurpose::kGasPath ||
                             c.has_closure();
                    },
                    "film.dimension = \"unrolled\", or gas_path.model = \"orifice-volume\", or for ringfilm conform, "
                    "with liner.distortion or [conform]"};
constexpr When kUnrolled{[](const Case& c) { return c.is_unrolled(); }, "film.dimension = \"unrolled\""};
constexpr When kGivenPressures{[](const Case& c) { return !c.gas_path.is_computed(); }, "gas_path.model = \"given\""};
constexpr When kGapped{[](const Case& c) {
                         const bool has_gas = c.gas_path.is_computed() || c.purpose == CasePurpose::kGasPath;
                         return (c.is_unrolled() && c.ring.end_gap.has_value()) || c.has_closure() ||
                                (has_gas && c.stated.contains("ring.gap_position"));
                       },
                       "ring.end_gap is stated, or it is stated in a pack whose gas is computed"};
constexpr When kBends{[](const Case& c) {
                        return c.ring.free_gap.has_value() || c.has_closure() || c.gas_path.is_computed() ||
                               c.purpose == CasePurpose::kGasPath || c.ring.section.is_stated();
                      },
                      "ring.free_gap or the section of the ring is stated, or gas_path.model = \"orifice-volume\", or "
                      "ring.conformity = \"beam\", or for ringfilm conform"};
constexpr When kCloses{
    [](const Case& c) { return c.has_closure(); },
    "a bore or a ring is stated for ringfilm conform, as with liner.distortion, or ring.conformity = \"beam\""};
constexpr When kDistortionMap{
    [](const Case& c) { return c.liner.distortion_map.has_value() || c.liner.dynamic_distortion.has_value(); },
    "liner.distortion_map or liner.dynamic_distortion is stated"};
constexpr When kPressurePoints{[](const Case& c) { return c.ring.pressure_points.has_value(); },
                               "ring.pressure_points is stated"};
constexpr When kFreeShape{[](const Case& c) { return c.ring.free_shape.has_value(); }, "ring.free_shape is stated"};
using TermPlace = FourierTermsKind::Place;
constexpr When kOilOnLiner{[](const Case& c) { return c.film.supply_at_inlet() == OilSupply::kFilmOnLiner; },
                           "film.supply = \"film-on-liner\""};
constexpr When kCoated{
    [](const Case& c) { return !c.contact.composite_modulus && c.ring.coating.youngs_modulus.has_value(); },
    "ring.coating.youngs_modulus is stated, and contact.composite_modulus is not"};

}  // namespace

void append_ring_fields(std::vector<Field>& fields) {
  fields.insert(
      fields.end(),
      {
          field({.key = "ring.name",
                 .kind = TextKind{member<&Case::ring, &Ring::name>},
                 .help = "what the ring is called, for people",
                 .example = "\"top compression ring\"",
                 .uses = {.closure = true, .gas = true},
                 .is_for_record = true}),
          field({.key = "ring.face_width",
                 .kind = NumberKind{member<&Case::ring, &Ring::face_width>},
                 .unit = kMillimetre,
                 .range = above(0, 0.05),
                 .need = Need::kRequired,
                 .help = "axial width of the ring face, b",
                 .example = "\"1.2 mm\"",
                 .uses = {.closure = true, .gas = true}}),
          field({.key = "ring.youngs_modulus",
                 .kind = NumberKind{member<&Case::ring, &Ring::youngs_modulus>},
                 .unit = kGigapascal,
                 .range = between(1e8, 1e13),
                 .when = kFourModuliOrFreeGap,
                 .help = "Young's modulus of the ring, E_1; commonly quoted, not verified",
                 .example = "\"203 GPa\"",
                 .uses = {.closure = true, .gas = true}}),
          field({.key = "ring.poissons_ratio",
                 .kind = NumberKind{member<&Case::ring, &Ring::poissons_ratio>},
                 .unit = kPlainNumber,
                 .range = Range{0, 0.5, false, true},
                 .when = kFourModuli,
                 .help = "Poisson's ratio of the ring, nu_1",
                 .example = "0.3"}),
          field({.key = "ring.elastic_pressure",
                 .kind = OptionalNumberKind{member<&Case::ring, &Ring::elastic_pressure>},
                 .unit = kMegapascal,
                 .range = above(0, 1e8),
                 .need = Need::kOptional,
                 .help = "pressure of the ring on the bore by its own tension, p_e; one of the ways to state it",
                 .example = "\"0.20 MPa\"",
                 .uses = {.closure = true, .gas = true}}),
          field({.key = "ring.tangential_force",
                 .kind = OptionalNumberKind{member<&Case::ring, &Ring::tangential_force>},
                 .unit = si_unit("N"),
                 .range = above(0, 1e5),
                 .need = Need::kOptional,
                 .help = "force that closes the ring at its gap, F_t = p_e b B/2; one of the ways to state it",
                 .example = "\"10.7 N\"",
                 .uses = {.closure = true, .gas = true}}),
          field(
              {.key = "ring.free_gap",
               .kind = OptionalNumberKind{member<&Case::ring, &Ring::free_gap>},
               .unit = kMillimetre,
               .range = above(0, 1),
               .need = Need::kOptional,
               .help =
                   "gap of the free ring less that of the closed one, s; with ring.radial_thickness one of the ways to "
                   "state it",
               .example = "\"10.5 mm\"",
               .uses = {.closure = true, .gas = true}}),
          field({.key = "ring.radial_thickness",
                 .kind = OptionalNumberKind{member<&Case::ring, &Ring::radial_thickness>},
                 .unit = kMillimetre,
                 .range = above(0, 0.2),
                 .need = Need::kOptional,
                 .when = kBends,
                 .help =
                     "radial thickness of the ring, t; with ring.free_gap one of the ways to state it; for gas_path, "
                     "ring.conformity "
                     "and ringfilm conform",
                 .example = "\"3.5 mm\"",
                 .uses = {.closure = true, .gas = true}}),
          field({.key = "ring.pressure_above",
                 .kind = OptionalNumberOrFileKind{member<&Case::ring, &Ring::pressure_above>},
                 .unit = kBar,
                 .range = above(0, 1e8),
                 .need = Need::kOptional,
                 .when = kGivenPressures,
                 .help = "gas pressure above the ring, absolute, or a CSV file like that of the cylinder; if omitted, "
                         "that of "
                         "the cylinder, in a pack that below the ring above",
                 .example = "\"land_2.csv\"",
                 .uses = {.gas = true}}),
          field({.key = "ring.pressure_below",
                 .kind = OptionalNumberOrFileKind{member<&Case::ring, &Ring::pressure_below>},
                 .unit = kBar,
                 .range = above(0, 1e8),
                 .need = Need::kOptional,
                 .when = kGivenPressures,
                 .help = "gas pressure below the ring, absolute, or a CSV file like that of the cylinder; if omitted, "
                         "that of "
                         "the crankcase",
                 .example = "\"1.4 bar\"",
                 .uses = {.gas = true}}),
          field({.key = "ring.land_below",
                 .kind = OptionalNumberKind{member<&Case::ring, &Ring::land_below>},
                 .unit = kMillimetre,
                 .range = above(0, 1),
                 .need = Need::kOptional,
                 .when = kOilOnLiner,
                 .help = "in a pack, height of the piston land down to the next ring; if omitted, the face width, with "
                         "a note",
                 .example = "\"3.5 mm\""}),
          field({.key = "ring.end_gap",
                 .kind = OptionalNumberKind{member<&Case::ring, &Ring::end_gap>},
                 .unit = kMillimetre,
                 .range = above(0, 1),
                 .need = Need::kOptional,
                 .when = kGap,
                 .help = "gap between the ends of the ring in the bore, g; if omitted, the ring is closed",
                 .example = "\"0.3 mm\"",
                 .uses = {.closure = true, .gas = true}}),
          field({.key = "ring.gap_position",
                 .kind = NumberKind{member<&Case::ring, &Ring::gap_position_deg>},
                 .unit = si_unit("degree"),
                 .range = between(-360, 360),
                 .when = kGapped,
                 .help =
                     "where around the bore the middle of the gap is, in a bore that is not round and, for the gas of "
                     "a pack, against the gap of the next ring",
                 .example = "\"0 degree\"",
                 .uses = {.closure = true, .gas = true}}),
          field({.key = "ring.conformity",
                 .kind = choice<&Case::ring, &Ring::conformity>(
                     {{"rigid", Conformity::kRigid}, {"beam", Conformity::kBeam}}),
                 .when = kUnrolled,
                 .help = "how the ring of an unrolled film meets the bore: one separation all around in a round bore, "
                         "or as a "
                         "beam that bends in the bore of liner.distortion",
                 .example = "\"beam\""}),
          field(
              {.key = "ring.local_deformation",
               .kind = choice<&Case::ring, &Ring::local_deformation>(
                   {{"none", LocalDeformation::kNone}, {"half-space", LocalDeformation::kHalfSpace}}),
               .help =
                   "whether face and liner give way locally to the pressure between them, as elastic half-spaces with "
                   "E' of the contact",
               .example = "\"half-space\""}),
          field({.key = "ring.pressure_orders",
                 .kind = FourierTermsKind{member<&Case::ring, &Ring::pressure_orders>, 2, TermPlace::kOneSection},
                 .unit = kPlainNumber,
                 .range = between(-10, 10),
                 .need = Need::kOptional,
                 .help =
                     "for ringfilm conform and ring.conformity: orders of the pressure of the ring on a round bore, "
                     "relative to its mean, "
                     "angles from the gap's middle; if omitted, uniform pressure",
                 .example = "[{ order = 2, amplitude = 0.25, phase = \"0 degree\" }]",
                 .uses = {.closure = true}}),
          field({.key = "ring.pressure_points",
                 .kind = OptionalFileKind{member<&Case::ring, &Ring::pressure_points>},
                 .need = Need::kOptional,
                 .help =
                     "for ringfilm conform and ring.conformity: in place of orders a CSV of that pressure, angle "
                     "[degree],pressure [bar], one turn of evenly spaced angles from the gap's middle; relative to its "
                     "mean",
                 .example = "\"pressure.csv\"",
                 .uses = {.closure = true}}),
          field({.key = "ring.pressure_points_orders",
                 .kind = CountKind{member<&Case::ring, &Ring::pressure_points_orders>},
                 .unit = kPlainNumber,
                 .range = between(2, 40),
                 .when = kPressurePoints,
                 .help = "highest order of the pressure that is kept of its points; what is finer is removed",
                 .example = "8",
                 .uses = {.closure = true}}),
          field(
              {.key = "ring.free_shape",
               .kind = OptionalFileKind{member<&Case::ring, &Ring::free_shape>},
               .need = Need::kOptional,
               .help =
                   "CSV of the running surface of the free ring, angle [degree],radius [mm] from end to end about any "
                   "centre: tension and pressure around the ring; with ring.radial_thickness one of the ways to state "
                   "it",
               .example = "\"free_ring.csv\"",
               .uses = {.closure = true, .gas = true}}),
          field({.key = "ring.free_shape_smoothing",
                 .kind = NumberKind{member<&Case::ring, &Ring::free_shape_smoothing>},
                 .unit = kMillimetre,
                 .range = above(0, 1),
                 .need = Need::kRequired,
                 .when = kFreeShape,
                 .help = "shortest wave around the ring that is kept of its free shape; what is finer is removed",
                 .example = "\"30 mm\"",
                 .uses = {.closure = true, .gas = true}}),
          field({.key = "ring.face.form",
                 .kind = choice<&Case::ring, &Ring::face, &RingFace::form>({{"polynomial", FaceForm::kPolynomial},
                                                                            {"parabola", FaceForm::kParabola},
                                                                            {"points", FaceForm::kPoints}}),
                 .need = Need::kRequired,
                 .help = "how the height of the face, h_s(x), is given; height is the gap to a straight liner",
                 .example = "\"parabola\""}),
          field({.key = "ring.face.height_zero",
                 .kind = choice<&Case::ring, &Ring::face, &RingFace::height_zero>(
                     {{"minimum", HeightZero::kMinimum}, {"as-given", HeightZero::kAsGiven}}),
                 .help = "zero of the stored face heights: their lowest point or the input's own; the film is the true "
                         "gap in "
                         "both",
                 .example = "\"minimum\""}),
          field(
              {.key = "ring.face.orientation",
               .kind = choice<&Case::ring, &Ring::face, &RingFace::orientation>(
                   {{"x0-chamber", Orientation::kX0Chamber},
                    {"x0-crankcase", Orientation::kX0Crankcase},
                    {"leading-edge", Orientation::kLeadingEdge}}),
               .help = "which edge is x = 0: a ring-fixed one, or always the leading one (turns over at each reversal)",
               .example = "\"x0-chamber\""}),
      });
  const std::vector<Field> formula =
      face_fields<&Case::ring, &Ring::face>({"ring.face",
                                             "\"parabola\"",
                                             "height of the parabola at the edge farther from its lowest point",
                                             0.01,
                                             "width",
                                             {}});
  fields.insert(fields.end(), formula.begin(), formula.end());
  fields.insert(
      fields.end(),
      {
          field({.key = "ring.face.file",
                 .kind = FileKind{member<&Case::ring, &Ring::face, &RingFace::points_file>},
                 .need = Need::kRequired,
                 .when = kPoints,
                 .help = "CSV file of measured points: x [mm],height [um], from x = 0 to the face width",
                 .example = "\"face.csv\""}),
          field({.key = "ring.face.measured.trace",
                 .kind = OptionalTextKind{member<&Case::ring, &Ring::face, &RingFace::measured, &MeasuredFace::trace>},
                 .need = Need::kOptional,
                 .help = "file of the trace that the face was fitted to",
                 .example = "\"new.csv\"",
                 .is_for_record = true}),
          field(
              {.key = "ring.face.measured.width",
               .kind = OptionalNumberKind{member<&Case::ring, &Ring::face, &RingFace::measured, &MeasuredFace::width>},
               .unit = kMillimetre,
               .range = above(0, 0.05),
               .need = Need::kOptional,
               .help = "width that the face was fitted over; ring.face_width must be the same",
               .example = "\"1.2 mm\"",
               .is_for_record = true}),
          field({.key = "ring.face.measured.levelling",
                 .kind =
                     OptionalTextKind{member<&Case::ring, &Ring::face, &RingFace::measured, &MeasuredFace::levelling>},
                 .need = Need::kOptional,
                 .help = "how the tilt of the trace was removed",
                 .example = "\"running surface level\"",
                 .is_for_record = true}),
          field({.key = "ring.face.measured.residual_rms",
                 .kind =
                     OptionalNumberKind{
                         member<&Case::ring, &Ring::face, &RingFace::measured, &MeasuredFace::residual_rms>},
                 .unit = kMicrometre,
                 .range = between(0, 1e-3),
                 .need = Need::kOptional,
                 .help = "rms distance of trace and face",
                 .example = "\"0.05 um\"",
                 .is_for_record = true}),
          field({.key = "ring.face.measured.largest_residual",
                 .kind =
                     OptionalNumberKind{
                         member<&Case::ring, &Ring::face, &RingFace::measured, &MeasuredFace::largest_residual>},
                 .unit = kMicrometre,
                 .range = between(0, 1e-2),
                 .need = Need::kOptional,
                 .help = "largest distance of trace and face",
                 .example = "\"0.2 um\"",
                 .is_for_record = true}),
          field(
              {.key = "ring.face.measured.fit_artifact",
               .kind =
                   OptionalTextKind{member<&Case::ring, &Ring::face, &RingFace::measured, &MeasuredFace::fit_artifact>},
               .need = Need::kOptional,
               .help = "where the face has a shape that its trace has not",
               .example = "\"x = 1.14 to 1.2 mm: falls\"",
               .is_for_record = true}),
          field({.key = "ring.coating.youngs_modulus",
                 .kind = OptionalNumberKind{member<&Case::ring, &Ring::coating, &Coating::youngs_modulus>},
                 .unit = kGigapascal,
                 .range = between(1e8, 1e13),
                 .need = Need::kOptional,
                 .when = kFourModuli,
                 .help = "Young's modulus of the coating on the face; enters E' in place of the ring's",
                 .example = "\"280 GPa\""}),
          field({.key = "ring.coating.poissons_ratio",
                 .kind = NumberKind{member<&Case::ring, &Ring::coating, &Coating::poissons_ratio>},
                 .unit = kPlainNumber,
                 .range = Range{0, 0.5, false, true},
                 .need = Need::kRequired,
                 .when = kCoated,
                 .help = "Poisson's ratio of the coating",
                 .example = "0.3"}),
          field({.key = "ring.coating.thickness",
                 .kind = OptionalNumberKind{member<&Case::ring, &Ring::coating, &Coating::thickness>},
                 .unit = kMicrometre,
                 .range = above(0, 1e-2),
                 .need = Need::kOptional,
                 .when = kCoated,
                 .help = "thickness of the coating; a note reports where the base affects contact spots",
                 .example = "\"100 um\""}),
          field({.key = "ring.coating.contact_modulus",
                 .kind = choice<&Case::ring, &Ring::coating, &Coating::contact_modulus>(
                     {{"coating", ContactModulus::kCoating}, {"base", ContactModulus::kBase}}),
                 .when = kCoated,
                 .help = "whose modulus the contact spots feel: that of the coating, or of the ring below",
                 .example = "\"coating\""}),
          field({.key = "liner.youngs_modulus",
                 .kind = NumberKind{member<&Case::liner, &Liner::youngs_modulus>},
                 .unit = kGigapascal,
                 .range = between(1e8, 1e13),
                 .when = kFourModuli,
                 .help = "Young's modulus of the liner, E_2; commonly quoted, not verified",
                 .example = "\"92.3 GPa\""}),
          field({.key = "liner.poissons_ratio",
                 .kind = NumberKind{member<&Case::liner, &Liner::poissons_ratio>},
                 .unit = kPlainNumber,
                 .range = Range{0, 0.5, false, true},
                 .when = kFourModuli,
                 .help = "Poisson's ratio of the liner, nu_2",
                 .example = "0.211"}),
          field({.key = "liner.thermal_conductivity",
                 .kind = NumberKind{member<&Case::liner, &Liner::thermal_conductivity>},
                 .unit = si_unit("W/(m K)"),
                 .range = between(0.1, 2500),
                 .help = "thermal conductivity of the liner, k_2, for the flash temperature; typical of grey cast "
                         "iron, assumed",
                 .example = "\"55 W/(m K)\""}),
          field({.key = "liner.density",
                 .kind = NumberKind{member<&Case::liner, &Liner::density>},
                 .unit = si_unit("kg/m3"),
                 .range = between(500, 25000),
                 .help = "density of the liner, rho_2; typical of grey cast iron, assumed",
                 .example = "\"7200 kg/m3\""}),
          field({.key = "liner.specific_heat",
                 .kind = NumberKind{member<&Case::liner, &Liner::specific_heat>},
                 .unit = si_unit("J/(kg K)"),
                 .range = between(50, 5000),
                 .help = "specific heat of the liner, c_2; typical of grey cast iron, assumed",
                 .example = "\"490 J/(kg K)\""}),
          field(
              {.key = "liner.distortion",
               .kind = FourierTermsKind{member<&Case::liner, &Liner::distortion>, 0, TermPlace::kAlongStroke},
               .unit = kMicrometre,
               .range = between(-1, 1),
               .need = Need::kOptional,
               .help =
                   "for ringfilm conform and ring.conformity: orders of the cold bore; the radius grows by the sum of "
                   "amplitude "
                   "cos(order (angle - phase)), with a height along the stroke where it changes",
               .example = "[{ order = 2, amplitude = \"15 um\", phase = \"0 degree\" }]",
               .uses = {.closure = true}}),
          field({.key = "liner.thermal_distortion",
                 .kind = FourierTermsKind{member<&Case::liner, &Liner::thermal_distortion>, 0, TermPlace::kAlongStroke},
                 .unit = kMicrometre,
                 .range = between(-1, 1),
                 .need = Need::kOptional,
                 .help = "for ringfilm conform and ring.conformity: the same of the part that heat adds",
                 .example = "[{ order = 4, amplitude = \"2 um\", phase = \"45 degree\" }]",
                 .uses = {.closure = true}}),
          field({.key = "liner.distortion_map",
                 .kind = OptionalFileKind{member<&Case::liner, &Liner::distortion_map>},
                 .need = Need::kOptional,
                 .help = "for ringfilm conform and ring.conformity: CSV of the measured bore, height [mm],angle "
                         "[degree],deviation [um] of the "
                         "radius, whole turns of evenly spaced angles; adds to the orders",
                 .example = "\"bore.csv\"",
                 .uses = {.closure = true}}),
          field(
              {.key = "liner.dynamic_distortion",
               .kind = OptionalFileKind{member<&Case::liner, &Liner::dynamic_distortion>},
               .need = Need::kOptional,
               .help =
                   "for ring.conformity: CSV of what the cycle adds to the radius of the bore at the place of the "
                   "ring, "
                   "crank_angle [degree],angle [degree],deviation [um], whole turns over the whole cycle; if omitted, "
                   "zero",
               .example = "\"dynamic.csv\""}),
          field({.key = "liner.distortion_map_orders",
                 .kind = CountKind{member<&Case::liner, &Liner::map_orders>},
                 .unit = kPlainNumber,
                 .range = between(1, 60),
                 .when = kDistortionMap,
                 .help = "highest order of the bore that is kept of the maps; what is finer is removed",
                 .example = "20",
                 .uses = {.closure = true}}),
          field({.key = "conform.gas_pressure",
                 .kind = NumberKind{member<&Case::conform, &Conform::gas_pressure>},
                 .unit = kBar,
                 .range = between(0, 1e8),
                 .when = kCloses,
                 .help = "for ringfilm conform: gas pressure behind the ring above that in front of it",
                 .example = "\"3 bar\"",
                 .uses = {.closure = true}}),
          field({.key = "conform.height",
                 .kind = OptionalNumberKind{member<&Case::conform, &Conform::height>},
                 .unit = kMillimetre,
                 .range = between(-5, 5),
                 .need = Need::kOptional,
                 .help = "for ringfilm conform: where along the stroke the ring is, in a bore that changes with it",
                 .example = "\"20 mm\"",
                 .uses = {.closure = true}}),
      });
}

}  // namespace ringfilm::cycle::table
