#pragma once
#include "ringfilm/film/edge.hpp"
#include "ringfilm/film/factors/roughness.hpp"
#include "ringfilm/gas_path/pack.hpp"
#include "ringfilm/models/contact/summit_contact.hpp"
#include "ringfilm/models/oil/lubricant.hpp"
#include "ringfilm/models/oil/shear_thinning.hpp"

/// What a case may choose among: the values of keys that are a name.
namespace ringfilm::cycle {

/// An engine cycle, a pad where any key of `pad` is stated, or the static closure of a ring in its bore alone, where
/// keys of `conform` and none of a cycle are.
enum class Problem {
  kCycle,   ///< a ring over the four strokes
  kPad,     ///< a film of stated shape
  kClosure  ///< a ring that bends in a bore, without film
};

/// What a case is read for.
enum class CasePurpose {
  kFilm,     ///< a cycle or a pad
  kGasPath,  ///< the gas of the ring pack alone: keys of film, oil and contact may be missing
  kClosure   ///< the static closure of the ring alone
};

/// `pad.direction`: which way the flat surface moves.
enum class Direction {
  kPlusX,  ///< towards larger x
  kMinusX  ///< towards x = 0
};

/// `pad.sides`: what the film ends at across the motion.
enum class Sides {
  kOpen,      ///< stated pressures
  kPeriodic,  ///< its own other side
  kClosed     ///< walls
};

/// `gas.model`: where the cylinder pressure comes from.
enum class GasModel {
  kTrace,  ///< a file
  kWiebe   ///< a single-zone cycle with Wiebe heat release
};

/// `gas.pressure_reference`: the zero of the pressures of a trace.
enum class PressureReference {
  kAbsolute,  ///< no pressure
  kGauge      ///< 1.01325 bar
};

/// `gas.angle_zero`: the dead centre at which a trace has crank angle 0.
enum class AngleZero {
  kFiringTdc,      ///< the dead centre of the firing, as everywhere else
  kGasExchangeTdc  ///< the dead centre of the gas exchange, 360 degree off
};

/// `gas.pegging`: how the zero of the pressures of a cylinder's trace is found.
enum class Pegging {
  kNone,       ///< as the trace and gas.pressure_offset have it
  kIntake,     ///< the pressure at bottom dead centre after intake is gas.intake_pressure
  kPolytropic  ///< compression follows gas.polytropic_index
};

/// `gas.trace_origin`: where a trace comes from.
enum class TraceOrigin {
  kNotStated,  ///< not stated in the case
  kMeasured,   ///< on an engine
  kComputed,   ///< by a model of the engine
  kSynthetic   ///< made up; marked SYNTHETIC wherever it appears
};

/// `gas_path.model`: where the pressures between the rings come from.
enum class GasPathModel {
  kGiven,         ///< as stated: ring.pressure_above, ring.pressure_below
  kOrificeVolume  ///< volumes, orifices and channels between chamber and crankcase
};

/// `gas_path.film`: does gas pass the films of the rings?
enum class FilmGas {
  kSealing,      ///< no
  kBreakthrough  ///< where a film does not hold the gas, through the gap over it, all around
};

/// `gas_path.properties`: where gas constant, heat capacity ratio and viscosity of the gas come from.
enum class GasProperties {
  kStated,  ///< keys of the case
  kMixture  ///< the composition of the gas, one for the whole run
};

using models::BurnLaw;  ///< `gas.composition.burn`
using models::Fuel;     ///< `gas.composition.fuel`

using gas_path::RingKind;    ///< `ring.kind`
using gas_path::RingMotion;  ///< `gas_path.ring_motion`

/// `ring.face.form` and `pad.face.form`: how the height of the face is given.
enum class FaceForm {
  kPolynomial,  ///< coefficients
  kParabola,    ///< crown height and place of the lowest point
  kPoints,      ///< points of a file, straight between them
  kCosine       ///< for a pad: one period, as in a journal bearing that is unwrapped; crown height and lowest point
};

/// `ring.face.height_zero`: zero of the stored heights of the face.
enum class HeightZero {
  kMinimum,  ///< its lowest point
  kAsGiven   ///< the zero of the input
};

/// `ring.face.orientation`: which edge is x = 0 of the input.
enum class Orientation {
  kX0Chamber,    ///< that at the chamber
  kX0Crankcase,  ///< that at the crankcase
  kLeadingEdge   ///< always the leading one: the face turns over at each reversal
};

/// `ring.coating.contact_modulus`: whose modulus the contact spots feel.
enum class ContactModulus {
  kCoating,  ///< modulus of the coating
  kBase      ///< modulus of the ring below
};

/// `contact.model`: the law of the asperity contact, as models::ContactModel, or a table.
enum class ContactLaw {
  kGreenwoodTripp,       ///< two rough surfaces, pairs of summits
  kGreenwoodWilliamson,  ///< one rough surface against a flat
  /// One rough surface against a flat, with the joint distribution of summit heights and curvatures
  kBushGibsonThomas,
  kPlastic,  ///< hardness times the material ratio
  kTable     ///< table of the contact of a measured pair
};

using models::AsperityLaw;     ///< `contact.asperity`
using models::ContactMoments;  ///< `contact.moments`
using models::SummitPlane;     ///< `contact.summit_plane`

/// `contact.roughness_measure`: what is made of the stated roughness.
enum class RoughnessMeasure {
  kAsGiven,  ///< it is sigma
  kRaToRq    ///< it is Ra, and sigma is sqrt(pi/2) = 1.2533 times as much, as for a Gaussian surface
};

/// `contact.integrals`: the Gaussian height integrals F_2 and F_5/2.
enum class ContactIntegrals {
  kExact,               ///< their values
  kPolynomial4Digit,    ///< a fit of the literature, zero from its first root on
  kPolynomialAsPrinted  ///< the fit as styles2014 has it, digits cut off: rises again beyond 1.911
};

/// `contact.lambda_ratio`: what the contact pressure follows.
enum class LambdaRatio {
  kLocal,   ///< h(x)/sigma along the face
  kNominal  ///< h_m/sigma, on the whole face
};

/// `lubricant.viscosity_temperature`: law of viscosity against temperature.
enum class ViscosityTemperature {
  kWalther,  ///< ASTM D341 through the points
  kHoupert   ///< Houpert's term
};

using ViscosityPressure = models::ViscosityPressureLaw;  ///< `lubricant.viscosity_pressure`

/// `lubricant.density_temperature`: law of density against temperature.
enum class DensityTemperature {
  kTable,              ///< linear through the points and beyond
  kThermalExpansivity  ///< by the expansivity gamma
};

/// `lubricant.compressibility`: law of density against pressure.
enum class Compressibility {
  kDowsonHigginson,  ///< rho_0 [1 + a p/(1 + b p)]
  kNone              ///< none: pressure does not change it
};

/// `film.dimension`: on what the film is solved.
enum class FilmDimension {
  kFace,     ///< across the face, alike all around
  kUnrolled  ///< the whole unrolled ring, with the ends of its gap
};

/// `ring.conformity`: how the ring meets the bore.
enum class Conformity {
  kRigid,  ///< one separation all around, in a round bore
  kBeam    ///< a beam with free ends that bends in a bore out of round
};

/// `ring.local_deformation`: do face and liner give way to the pressure between them?
enum class LocalDeformation {
  kNone,      ///< both are rigid
  kHalfSpace  ///< as elastic half-spaces in plane strain across the face
};

/// `film.cavitation`: how the film ruptures.
enum class Cavitation {
  kReynoldsExit,   ///< pressure is never below p_c (Reynolds)
  kMassConserving  ///< and mass is kept, too (JFO)
};

/// `conditions`: from which edges, supply of oil and temperatures a case starts.
enum class Conditions {
  kOfTheCase,  ///< what the keys state; edges of oil by default
  kAsInPaper,  ///< edges flooded with oil, one oil temperature, as in styles2014
  kEngine,     ///< gas at the edges, oil on the liner, walls as measured at full load
  kHotEngine   ///< those of kEngine with hotter walls
};

/// `film.supply`: what lies on the liner ahead of an edge of gas.
enum class OilSupply {
  kFlooded,     ///< as much oil as the film takes
  kGiven,       ///< a stated film that does not change from stroke to stroke
  kFilmOnLiner  ///< what the strokes before have left there, and on downstrokes what the oil ring leaves
};

/// `supply.scraped`: what becomes of oil that an inlet does not take.
enum class Scraped {
  kBead,      ///< it moves on ahead of the edge, feeds the film, and stays behind at the end of the stroke
  kDiscarded  ///< it is gone
};

/// `evaporation.heat_transfer`: the correlation of the transfer of heat from the gas to the liner.
enum class HeatTransfer {
  kWoschni  ///< eq-woschni
};

/// `film.outlet`: what the liner takes along where oil hangs on the face behind the film.
enum class Outlet {
  kHalfGap,   ///< half of the gap
  kCapillary  ///< what a meniscus leaves at the capillary number of the liner, eq-outlet
};

using film::AverageGap;                          ///< `film.average_gap`
using film::Roughness;                           ///< `film.flow_factors`, `film.shear_flow`, `film.stress_factors`
using ShearThinning = models::ShearThinningLaw;  ///< `lubricant.shear_thinning`
using film::BrokenFilm;                          ///< `film.broken`
using film::EdgeFluid;                           ///< `film.chamber_edge`, `film.crankcase_edge`

/// `solver.crank_step_control`: how long a crank step is.
enum class StepControl {
  kAdaptive,  ///< refined where the film needs it
  kFixed      ///< the stated one alone
};

/// `solver.time_scheme`: how the film remembers those before it.
enum class TimeScheme {
  kBackwardEuler,  ///< the last one
  kBdf2            ///< the last two, eq-bdf2
};

/// `solver.cell_lengths`: how the cells share the face.
enum class CellLengths {
  kUniform,  ///< all alike
  kByGap     ///< short where the face is low, eq-cells-by-gap
};

/// `solver.method`: how film and load balance are solved.
enum class Method {
  kCoupledNewton,    ///< both at once by Newton's method
  kPointRelaxation,  ///< pressures one by one, in a relaxed correction of h_m, as in styles2014
  kMenisci  ///< differential equations of a film between two menisci; on cells, as the first, where there is none
};

/// `film.land_lift`: lift of the honing of the liner, beside the film of the face.
enum class LandLift {
  kNone,  ///< the face alone lifts
  kTable  ///< by the table that `ringfilm land` computed of a scan
};

/// `solver.properties`: what the iteration asks for oil and contact.
enum class Properties {
  kFitted,  ///< polynomials fitted to their laws
  kExact    ///< the laws themselves
};

/// `output.fields`: at which crank angles pressure and film along the face are kept.
enum class FieldOutput {
  kNone,    ///< at none
  kListed,  ///< at Output::field_angles_deg
  kAll      ///< at all of the result
};

/// `output.reduction`: what is kept of the fields of an unrolled film.
enum class FieldReduction {
  kNone,      ///< each place
  kAlongFace  ///< what each strip across the face sums up to
};

}  // namespace ringfilm::cycle
