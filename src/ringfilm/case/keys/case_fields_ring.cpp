#include "ringfilm/case/keys/case_fields_table.hpp"

namespace ringfilm::cycle::table {
namespace {

constexpr When kPoints{[](const Case& c) { return c.ring.face.form == FaceForm::kPoints; },
                       "ring.face.form = \"points\""};
constexpr When kFourModuli{[](const Case& c) { return !c.contact.composite_modulus; },
                           "contact.composite_modulus is not stated"};
constexpr When kFourModuliOrFreeGap{
    [](const Case& c) { return !c.contact.composite_modulus || c.ring.free_gap || c.ring.radial_thickness; },
    "contact.composite_modulus is not stated, or ring.radial_thickness is stated"};

constexpr When kGap{[](const Case& c) {
                      return c.is_unrolled() || c.gas_path.is_computed() || c.purpose == CasePurpose::kGasPath ||
                             c.has_closure();
                    },
                    "film.dimension = \"unrolled\", or gas_path.model = \"orifice-volume\", or for ringfilm conform, "
                    "with liner.distortion or [conform]"};
constexpr When kUnrolled{[](const Case& c) { return c.is_unrolled(); }, "film.dimension = \"unrolled\""};
constexpr When kGivenPressures{[](const Case& c) { return !c.gas_path.is_computed(); }, "gas_path.model = \"given\""};
constexpr When kGapped{[](const Case& c) { return (c.is_unrolled() && c.ring.end_gap.has_value()) || c.has_closure(); },
                       "ring.end_gap is stated"};
constexpr When kBends{[](const Case& c) {
                        return c.ring.free_gap.has_value() || c.has_closure() || c.gas_path.is_computed() ||
                               c.purpose == CasePurpose::kGasPath;
                      },
                      "ring.free_gap is stated, or gas_path.model = \"orifice-volume\", or ring.conformity = "
                      "\"beam\", or for ringfilm conform"};
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

constexpr Unit kLength{"m", "mm"};
constexpr Unit kModulus{"Pa", "GPa"};

}  // namespace

void append_ring_fields(std::vector<Field>& fields) {
  fields.insert(
      fields.end(),
      {
          field("ring.name", TextKind{member<&Case::ring, &Ring::name>}, kNoUnit, {}, Need::kDefault, {},
                {"what the ring is called, for people", "\"top compression ring\""}),
          field("ring.face_width", NumberKind{member<&Case::ring, &Ring::face_width>}, kLength, above(0, 0.05),
                Need::kRequired, {}, {"axial width of the ring face, b", "\"1.2 mm\""}),
          field("ring.youngs_modulus", NumberKind{member<&Case::ring, &Ring::youngs_modulus>}, kModulus,
                between(1e8, 1e13), Need::kDefault, kFourModuliOrFreeGap,
                {"Young's modulus of the ring, E_1; commonly quoted, not verified", "\"203 GPa\""}),
          field("ring.poissons_ratio", NumberKind{member<&Case::ring, &Ring::poissons_ratio>}, kPlainNumber,
                Range{0, 0.5, false, true}, Need::kDefault, kFourModuli, {"Poisson's ratio of the ring, nu_1", "0.3"}),
          field("ring.elastic_pressure", OptionalNumberKind{member<&Case::ring, &Ring::elastic_pressure>},
                {"Pa", "MPa"}, above(0, 1e8), Need::kOptional, {},
                {"pressure of the ring on the bore by its own tension, p_e; one of the ways to state it",
                 "\"0.20 MPa\""}),
          field("ring.tangential_force", OptionalNumberKind{member<&Case::ring, &Ring::tangential_force>}, {"N", "N"},
                above(0, 1e5), Need::kOptional, {},
                {"force that closes the ring at its gap, F_t = p_e b B/2; one of the ways to state it", "\"10.7 N\""}),
          field("ring.free_gap", OptionalNumberKind{member<&Case::ring, &Ring::free_gap>}, kLength, above(0, 1),
                Need::kOptional, {},
                {"gap of the free ring less that of the closed one, s; with ring.radial_thickness one of the ways to "
                 "state it",
                 "\"10.5 mm\""}),
          field("ring.radial_thickness", OptionalNumberKind{member<&Case::ring, &Ring::radial_thickness>}, kLength,
                above(0, 0.2), Need::kOptional, kBends,
                {"radial thickness of the ring, t; with ring.free_gap one of the ways to state it; for gas_path, "
                 "ring.conformity "
                 "and ringfilm conform",
                 "\"3.5 mm\""}),
          field("ring.pressure_above", OptionalNumberOrFileKind{member<&Case::ring, &Ring::pressure_above>},
                {"Pa", "bar"}, above(0, 1e8), Need::kOptional, kGivenPressures,
                {"gas pressure above the ring, absolute, or a CSV file like that of the cylinder; if omitted, that of "
                 "the cylinder, in a pack that below the ring above",
                 "\"land_2.csv\""}),
          field("ring.pressure_below", OptionalNumberOrFileKind{member<&Case::ring, &Ring::pressure_below>},
                {"Pa", "bar"}, above(0, 1e8), Need::kOptional, kGivenPressures,
                {"gas pressure below the ring, absolute, or a CSV file like that of the cylinder; if omitted, that of "
                 "the crankcase",
                 "\"1.4 bar\""}),
          field("ring.land_below", OptionalNumberKind{member<&Case::ring, &Ring::land_below>}, kLength, above(0, 1),
                Need::kOptional, kOilOnLiner,
                {"in a pack, height of the piston land down to the next ring; if omitted, the face width, with a note",
                 "\"3.5 mm\""}),
          field("ring.end_gap", OptionalNumberKind{member<&Case::ring, &Ring::end_gap>}, kLength, above(0, 1),
                Need::kOptional, kGap,
                {"gap between the ends of the ring in the bore, g; if omitted, the ring is closed", "\"0.3 mm\""}),
          field("ring.gap_position", NumberKind{member<&Case::ring, &Ring::gap_position_deg>}, {"degree", "degree"},
                between(-360, 360), Need::kDefault, kGapped,
                {"where around the bore the middle of the gap is; in a round bore a label of the results alone",
                 "\"0 degree\""}),
          field("ring.conformity", choice<&Case::ring, &Ring::conformity>({"rigid", "beam"}), kNoUnit, {},
                Need::kDefault, kUnrolled,
                {"how the ring of an unrolled film meets the bore: one separation all around in a round bore, or as a "
                 "beam that bends in the bore of liner.distortion",
                 "\"beam\""}),
          field("ring.local_deformation", choice<&Case::ring, &Ring::local_deformation>({"none", "half-space"}),
                kNoUnit, {}, Need::kDefault, {},
                {"whether face and liner give way locally to the pressure between them, as elastic half-spaces with "
                 "E' of the contact",
                 "\"half-space\""}),
          field("ring.pressure_orders",
                FourierTermsKind{member<&Case::ring, &Ring::pressure_orders>, 2, TermPlace::kOneSection}, kPlainNumber,
                between(-10, 10), Need::kOptional, {},
                {"for ringfilm conform and ring.conformity: orders of the pressure of the ring on a round bore, "
                 "relative to its mean, "
                 "angles from the gap's middle; if omitted, uniform pressure",
                 "[{ order = 2, amplitude = 0.25, phase = \"0 degree\" }]"}),
          field("ring.pressure_points", OptionalFileKind{member<&Case::ring, &Ring::pressure_points>}, kNoUnit, {},
                Need::kOptional, {},
                {"for ringfilm conform and ring.conformity: in place of orders a CSV of that pressure, angle "
                 "[degree],pressure [bar], one turn of evenly spaced angles from the gap's middle; relative to its "
                 "mean",
                 "\"pressure.csv\""}),
          field("ring.pressure_points_orders", CountKind{member<&Case::ring, &Ring::pressure_points_orders>},
                kPlainNumber, between(2, 40), Need::kDefault, kPressurePoints,
                {"highest order of the pressure that is kept of its points; what is finer is removed", "8"}),
          field("ring.free_shape", OptionalFileKind{member<&Case::ring, &Ring::free_shape>}, kNoUnit, {},
                Need::kOptional, {},
                {"CSV of the running surface of the free ring, angle [degree],radius [mm] from end to end about any "
                 "centre: tension and pressure around the ring; with ring.radial_thickness one of the ways to state it",
                 "\"free_ring.csv\""}),
          field(
              "ring.free_shape_smoothing", NumberKind{member<&Case::ring, &Ring::free_shape_smoothing>}, kLength,
              above(0, 1), Need::kRequired, kFreeShape,
              {"shortest wave around the ring that is kept of its free shape; what is finer is removed", "\"30 mm\""}),
          field(
              "ring.face.form", choice<&Case::ring, &Ring::face, &RingFace::form>({"polynomial", "parabola", "points"}),
              kNoUnit, {}, Need::kRequired, {},
              {"how the height of the face, h_s(x), is given; height is the gap to a straight liner", "\"parabola\""}),
          field("ring.face.height_zero",
                choice<&Case::ring, &Ring::face, &RingFace::height_zero>({"minimum", "as-given"}), kNoUnit, {},
                Need::kDefault, {},
                {"zero of the stored face heights: their lowest point or the input's own; the film is the true gap in "
                 "both",
                 "\"minimum\""}),
          field(
              "ring.face.orientation",
              choice<&Case::ring, &Ring::face, &RingFace::orientation>({"x0-chamber", "x0-crankcase", "leading-edge"}),
              kNoUnit, {}, Need::kDefault, {},
              {"which edge is x = 0: a ring-fixed one, or always the leading one (turns over at each reversal)",
               "\"x0-chamber\""}),
      });
  const std::vector<Field> formula = face_fields<&Case::ring, &Ring::face>(
      {"ring.face", "\"parabola\"", "height of the parabola at the edge farther from its lowest point", 0.01, "width"});
  fields.insert(fields.end(), formula.begin(), formula.end());
  fields.insert(
      fields.end(),
      {
          field("ring.face.file", FileKind{member<&Case::ring, &Ring::face, &RingFace::points_file>}, kNoUnit, {},
                Need::kRequired, kPoints,
                {"CSV file of measured points: x [mm],height [um], from x = 0 to the face width", "\"face.csv\""}),
          field("ring.face.measured.trace",
                OptionalTextKind{member<&Case::ring, &Ring::face, &RingFace::measured, &MeasuredFace::trace>}, kNoUnit,
                {}, Need::kOptional, {}, {"file of the trace that the face was fitted to", "\"new.csv\""}),
          field("ring.face.measured.width",
                OptionalNumberKind{member<&Case::ring, &Ring::face, &RingFace::measured, &MeasuredFace::width>},
                kLength, above(0, 0.05), Need::kOptional, {},
                {"width that the face was fitted over; ring.face_width must be the same", "\"1.2 mm\""}),
          field("ring.face.measured.levelling",
                OptionalTextKind{member<&Case::ring, &Ring::face, &RingFace::measured, &MeasuredFace::levelling>},
                kNoUnit, {}, Need::kOptional, {},
                {"how the tilt of the trace was removed", "\"running surface level\""}),
          field("ring.face.measured.residual_rms",
                OptionalNumberKind{member<&Case::ring, &Ring::face, &RingFace::measured, &MeasuredFace::residual_rms>},
                {"m", "um"}, between(0, 1e-3), Need::kOptional, {}, {"rms distance of trace and face", "\"0.05 um\""}),
          field("ring.face.measured.largest_residual",
                OptionalNumberKind{
                    member<&Case::ring, &Ring::face, &RingFace::measured, &MeasuredFace::largest_residual>},
                {"m", "um"}, between(0, 1e-2), Need::kOptional, {},
                {"largest distance of trace and face", "\"0.2 um\""}),
          field("ring.face.measured.fit_artifact",
                OptionalTextKind{member<&Case::ring, &Ring::face, &RingFace::measured, &MeasuredFace::fit_artifact>},
                kNoUnit, {}, Need::kOptional, {},
                {"where the face has a shape that its trace has not", "\"x = 1.14 to 1.2 mm: falls\""}),
          field("ring.coating.youngs_modulus",
                OptionalNumberKind{member<&Case::ring, &Ring::coating, &Coating::youngs_modulus>}, kModulus,
                between(1e8, 1e13), Need::kOptional, kFourModuli,
                {"Young's modulus of the coating on the face; enters E' in place of the ring's", "\"280 GPa\""}),
          field("ring.coating.poissons_ratio",
                NumberKind{member<&Case::ring, &Ring::coating, &Coating::poissons_ratio>}, kPlainNumber,
                Range{0, 0.5, false, true}, Need::kRequired, kCoated, {"Poisson's ratio of the coating", "0.3"}),
          field("ring.coating.thickness", OptionalNumberKind{member<&Case::ring, &Ring::coating, &Coating::thickness>},
                {"m", "um"}, above(0, 1e-2), Need::kOptional, kCoated,
                {"thickness of the coating; a note reports where the base affects contact spots", "\"100 um\""}),
          field("ring.coating.contact_modulus",
                choice<&Case::ring, &Ring::coating, &Coating::contact_modulus>({"coating", "base"}), kNoUnit, {},
                Need::kDefault, kCoated,
                {"whose modulus the contact spots feel: that of the coating, or of the ring below", "\"coating\""}),
          field("liner.youngs_modulus", NumberKind{member<&Case::liner, &Liner::youngs_modulus>}, kModulus,
                between(1e8, 1e13), Need::kDefault, kFourModuli,
                {"Young's modulus of the liner, E_2; commonly quoted, not verified", "\"92.3 GPa\""}),
          field("liner.poissons_ratio", NumberKind{member<&Case::liner, &Liner::poissons_ratio>}, kPlainNumber,
                Range{0, 0.5, false, true}, Need::kDefault, kFourModuli,
                {"Poisson's ratio of the liner, nu_2", "0.211"}),
          field(
              "liner.thermal_conductivity", NumberKind{member<&Case::liner, &Liner::thermal_conductivity>},
              {"W/(m K)", "W/(m K)"}, between(0.1, 2500), Need::kDefault, {},
              {"thermal conductivity of the liner, k_2, for the flash temperature; typical of grey cast iron, assumed",
               "\"55 W/(m K)\""}),
          field("liner.density", NumberKind{member<&Case::liner, &Liner::density>}, {"kg/m3", "kg/m3"},
                between(500, 25000), Need::kDefault, {},
                {"density of the liner, rho_2; typical of grey cast iron, assumed", "\"7200 kg/m3\""}),
          field("liner.specific_heat", NumberKind{member<&Case::liner, &Liner::specific_heat>},
                {"J/(kg K)", "J/(kg K)"}, between(50, 5000), Need::kDefault, {},
                {"specific heat of the liner, c_2; typical of grey cast iron, assumed", "\"490 J/(kg K)\""}),
          field("liner.distortion",
                FourierTermsKind{member<&Case::liner, &Liner::distortion>, 0, TermPlace::kAlongStroke}, {"m", "um"},
                between(-1, 1), Need::kOptional, {},
                {"for ringfilm conform and ring.conformity: orders of the cold bore; the radius grows by the sum of "
                 "amplitude "
                 "cos(order (angle - phase)), with a height along the stroke where it changes",
                 "[{ order = 2, amplitude = \"15 um\", phase = \"0 degree\" }]"}),
          field("liner.thermal_distortion",
                FourierTermsKind{member<&Case::liner, &Liner::thermal_distortion>, 0, TermPlace::kAlongStroke},
                {"m", "um"}, between(-1, 1), Need::kOptional, {},
                {"for ringfilm conform and ring.conformity: the same of the part that heat adds",
                 "[{ order = 4, amplitude = \"2 um\", phase = \"45 degree\" }]"}),
          field("liner.distortion_map", OptionalFileKind{member<&Case::liner, &Liner::distortion_map>}, kNoUnit, {},
                Need::kOptional, {},
                {"for ringfilm conform and ring.conformity: CSV of the measured bore, height [mm],angle "
                 "[degree],deviation [um] of the "
                 "radius, whole turns of evenly spaced angles; adds to the orders",
                 "\"bore.csv\""}),
          field("liner.dynamic_distortion", OptionalFileKind{member<&Case::liner, &Liner::dynamic_distortion>}, kNoUnit,
                {}, Need::kOptional, {},
                {"for ring.conformity: CSV of what the cycle adds to the radius of the bore at the place of the ring, "
                 "crank_angle [degree],angle [degree],deviation [um], whole turns over the whole cycle; if omitted, "
                 "zero",
                 "\"dynamic.csv\""}),
          field("liner.distortion_map_orders", CountKind{member<&Case::liner, &Liner::map_orders>}, kPlainNumber,
                between(1, 60), Need::kDefault, kDistortionMap,
                {"highest order of the bore that is kept of the maps; what is finer is removed", "20"}),
          field("conform.gas_pressure", NumberKind{member<&Case::conform, &Conform::gas_pressure>}, {"Pa", "bar"},
                between(0, 1e8), Need::kDefault, kCloses,
                {"for ringfilm conform: gas pressure behind the ring above that in front of it", "\"3 bar\""}),
          field("conform.height", OptionalNumberKind{member<&Case::conform, &Conform::height>}, kLength, between(-5, 5),
                Need::kOptional, {},
                {"for ringfilm conform: where along the stroke the ring is, in a bore that changes with it",
                 "\"20 mm\""}),
      });
}

}  // namespace ringfilm::cycle::table
