#pragma once
#include <memory>
#include <numbers>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "ringfilm/base/shared.hpp"
#include "ringfilm/case/case_choices.hpp"
#include "ringfilm/case/gas_composition.hpp"
#include "ringfilm/case/lubricant.hpp"
#include "ringfilm/case/measured_contact.hpp"
#include "ringfilm/case/oil_transport.hpp"
#include "ringfilm/case/plateau.hpp"
#include "ringfilm/case/ring_face.hpp"
#include "ringfilm/case/ring_section.hpp"
#include "ringfilm/case/stated_shapes.hpp"
#include "ringfilm/models/contact/friction_pair.hpp"
#include "ringfilm/models/contact/measured_flow.hpp"
#include "ringfilm/models/land/land_lift.hpp"
#include "ringfilm/models/wall_temperature.hpp"

/// The input of one engine cycle, or of a pad, as one plain value: SI units, complete, checked. Angles alone are in
/// degrees (suffix `_deg`; of the crank 0 = firing TDC), because that is the grid on which everything is asked for and
/// stored (docs/decisions/0002-crank-angle-in-degrees.md).
///
/// A default is written here and nowhere else. A member without a default belongs to a key that must be stated;
/// `cycle/case/case_fields.hpp` has the one table of keys, units, ranges and meanings.
namespace ringfilm::cycle {

/// A value at one place of the stroke.
struct StrokeValue {
  double distance = 0;  ///< distance of the ring from its TDC position [m]
  double value = 0;     ///< [SI unit of the quantity]
};

/// A quantity sampled over crank angle, as its file gives it (any range within one cycle, any spacing, increasing).
struct SampledTrace {
  std::vector<double> crank_angle_deg;  ///< [degree], zero as its file has it
  std::vector<double> value;            ///< [SI]
};

using OilTable = models::OilTable;  ///< viscosity and density of an oil of one's own

/// The keys under `engine`.
struct Engine {
  double bore = 0;                   ///< bore of the cylinder, B [m]
  double stroke = 0;                 ///< twice the crank radius [m]
  double connecting_rod_length = 0;  ///< between the centres of its bearings [m]
  std::optional<double> cylinders;   ///< number of cylinders; absent: values of one cylinder alone [-]
};

/// The keys under `operating`.
struct Operating {
  double speed = 0;            ///< speed of the crankshaft, omega [rad/s]
  double oil_temperature = 0;  ///< temperature of the film, one value for the whole stroke; not used with [thermal] [K]
  std::optional<double> brake_power;  ///< brake power of the engine, for the specific consumption of oil [W]
  std::optional<double> fuel_rate;    ///< fuel that the engine burns, for the share of oil in it [kg/s]
};

using FilmTemperature = models::FilmTemperature;  ///< `thermal.film`

/// `thermal.viscous_heating`: what the heat of shear does to the film.
enum class ViscousHeating {
  kNone,   ///< nothing: its rise of temperature is reported alone
  kInFilm  ///< the oil of a step is warmer by it
};

/// The keys under `thermal`: wall temperatures in place of one oil temperature, and the film's own heat.
struct Thermal {
  std::optional<double> ring;                              ///< temperature of the face of the ring [K]
  std::vector<StrokeValue> liner;                          ///< by distance, increasing; one point: the same everywhere
  FilmTemperature film = FilmTemperature::kMeanOfWalls;    ///< whose temperature the oil film has
  ViscousHeating viscous_heating = ViscousHeating::kNone;  ///< heating by shear, above that temperature

  bool is_stated() const { return ring || !liner.empty(); }  ///< are there walls? Else one oil temperature
  bool is_heated() const { return viscous_heating == ViscousHeating::kInFilm; }  ///< by its own shear
};

/// The keys under `gas`, with the traces that they name.
struct Gas {
  GasModel model = GasModel::kTrace;  ///< cylinder pressure from a file, or from a cycle with Wiebe heat release
  // model = "trace"
  std::string cylinder_pressure_file;            ///< CSV of pressure against crank angle, as named
  base::Shared<SampledTrace> cylinder_pressure;  ///< [Pa] as the file gives it: absolute or gauge, zero as stated below
  PressureReference pressure_reference{};        ///< zero of the traces; gauge: above 1.01325 bar
  AngleZero angle_zero{};                        ///< dead centre at which the traces have crank angle 0
  TraceOrigin trace_origin = TraceOrigin::kNotStated;  ///< shown wherever the trace appears
  std::optional<std::string> pressure_column;          ///< name in the header; absent: the only pressure in the file
  std::optional<std::string> angle_column;             ///< name in the header; absent: the only crank angle in the file
  std::optional<std::string> pressure_unit;            ///< for a header that does not carry it
  std::optional<std::string> angle_unit;               ///< for a header that does not carry it
  std::optional<std::string> columns;                  ///< names and units of all columns, for a file without a header
  int skip_lines = 0;                                  ///< lines of the file in front of the table
  std::optional<std::string> cycle;  ///< which of several cycles: "mean", "median" or a number; absent: their mean
  double pressure_offset = 0;        ///< added to the trace of the cylinder [Pa]
  double angle_offset_deg = 0;       ///< added to the crank angles of the trace of the cylinder [degree]
  Pegging pegging = Pegging::kNone;  ///< how the zero of the trace of the cylinder is found
  std::optional<double> imep;        ///< stated for this pressure, to be compared with that of the pressure [Pa]
  double polytropic_index = 1.32;    ///< exponent of the compression, for pegging; typical, assumed [-]
  // model = "wiebe"; angles 0 = firing TDC
  double compression_ratio = 10.5;         ///< largest over smallest cylinder volume [-]
  double peak_pressure = 62e5;             ///< [Pa] absolute
  double peak_angle_deg = 20;              ///< crank angle of the peak pressure after firing TDC [degree]
  double burn_duration_deg = 60;           ///< length of the heat release [degree]
  double exhaust_valve_opening_deg = 130;  ///< [degree]
  double exhaust_valve_closing_deg = 375;  ///< [degree]
  double intake_valve_opening_deg = 345;   ///< [degree]
  double intake_valve_closing_deg = 590;   ///< [degree]
  /// Temperature of the charge when the intake valve closes; typical, assumed [K].
  double charge_temperature = 350;
  // wiebe, and a trace that covers only a part of the cycle (there without default)
  std::optional<double> intake_pressure;                   ///< in the cylinder during intake, absolute [Pa]
  std::optional<double> exhaust_pressure;                  ///< in the cylinder during exhaust, absolute [Pa]
  static constexpr double kWiebeIntakePressure = 0.95e5;   ///< pressure during intake unless the case states it [Pa]
  static constexpr double kWiebeExhaustPressure = 1.05e5;  ///< pressure during exhaust unless the case states it [Pa]
  // always
  double crankcase_pressure = 101325;  ///< under the ring, absolute [Pa]; not used where a trace is given
  std::optional<std::string> crankcase_pressure_file;         ///< CSV like that of the cylinder, as named
  std::optional<base::Shared<SampledTrace>> crankcase_trace;  ///< [Pa] as that file gives it
  /// Share of the excess of the pressure above the ring over that below it that acts behind the ring [-]; see
  /// pressure_behind_ring() in integration/ring_conditions.hpp.
  double pressure_behind_ring = 1.0;
  GasComposition composition;  ///< what the gas consists of
};

/// A gas pressure next to a ring that is not that of the cylinder or of the crankcase: one value, or a trace.
struct LandPressure {
  std::optional<double> constant;                   ///< absolute [Pa]
  std::optional<std::string> file;                  ///< CSV like that of the cylinder, as named
  std::optional<base::Shared<SampledTrace>> trace;  ///< [Pa] as that file gives it

  std::optional<base::Shared<SampledTrace>> computed;  ///< by the gas path: absolute [Pa], 0 = firing TDC

  bool is_stated() const { return constant || file || computed; }  ///< by a constant, by a file, or computed
};

/// The keys under `gas_path`: the gas and how it passes the rings. The defaults are typical and assumed.
struct GasPath {
  GasPathModel model = GasPathModel::kGiven;     ///< pressures between the rings as stated, or by volumes and orifices
  RingMotion ring_motion = RingMotion::kSeated;  ///< rings on their lower flanks, or moved along the bore's axis
  FilmGas film = FilmGas::kSealing;              ///< do the films of the rings let gas pass?
  GasProperties properties = GasProperties::kStated;  ///< gas constant, heat capacity ratio and viscosity
  double mixture_burnt_share = 1;                     ///< burnt gas in that mixture, the rest is fresh charge [-]
  double mixture_temperature = 500;                   ///< temperature of that mixture [K]
  double discharge_coefficient = 0.65;                ///< discharge coefficient of the end gaps, C [-]
  double gas_constant = 287;                          ///< gas constant of air, R [J/(kg K)]
  double heat_capacity_ratio = 1.33;                  ///< heat capacity ratio of burned gas, gamma [-]
  double viscosity = 2.7e-5;                          ///< viscosity of air at 500 K, mu [Pa s]
  double chamber_temperature = 600;                   ///< temperature of the gas that enters from the chamber [K]
  double crankcase_temperature = 360;                 ///< temperature of the gas in the crankcase [K]
  double choking_smoothing = 1e-3;                    ///< distance from a pressure ratio of 1 that is bridged [-]
  double sliding_smoothing_speed = 0.05;              ///< U_0, of the friction on the bore near the dead centres [m/s]
  double gap_carry_over = 0.5;  ///< share of a jet's velocity head that an aligned end gap below it recovers [-]
  double gap_reach = 5e-3;      ///< distance of two end gaps around the bore from which on they are apart [m]

  bool is_computed() const { return model == GasPathModel::kOrificeVolume; }  ///< the pressures between the rings
  bool passes_films() const { return is_computed() && film == FilmGas::kBreakthrough; }  ///< does the gas?
};

/// What the gas meets at a ring: keys under `ring`, used where GasPath::is_computed().
struct RingGasPath {
  RingKind kind = RingKind::kCompression;   ///< where its gas goes
  std::optional<double> gap_area;           ///< area of the end gap; absent: end_gap times land_clearance [m2]
  std::optional<double> groove_volume;      ///< volume of the gas behind and above the ring [m3]
  double groove_temperature = 473.15;       ///< temperature of the gas in the groove; typical, assumed [K]
  double volume_below = 0;                  ///< volume of the piston land below; 0: the region below it [m3]
  double temperature_below = 423.15;        ///< temperature of the gas at the piston land below; typical, assumed [K]
  std::optional<double> side_clearance;     ///< clearance of the ring in its groove, along the bore's axis [m]
  std::optional<double> land_clearance;     ///< radial, between piston lands and bore [m]
  std::optional<double> mass;               ///< mass of the ring [kg]
  std::optional<double> density;            ///< density of the material of the ring, in place of its mass [kg/m3]
  double bore_friction_coefficient = 0.05;  ///< coefficient of friction of the ring on the bore; typical, assumed [-]
  /// Computed: gap through which gas passes the film, at each degree of crank angle; empty: the film seals [m].
  std::vector<double> face_opening;
  /// Computed: temperatures of the gas above and below the ring; absent: those of chamber and crankcase [K].
  std::optional<double> computed_temperature_above, computed_temperature_below;
};

/// The keys under `ring`.
struct Ring {
  std::string name;               ///< for people; empty: its number
  double face_width = 0;          ///< b, along the cylinder's axis [m]
  double youngs_modulus = 203e9;  ///< E_1 [Pa]
  double poissons_ratio = 0.3;    ///< nu_1 [-]
  // exactly one of: elastic_pressure | tangential_force | expander_force | (free_gap and radial_thickness) | free_shape
  std::optional<double> elastic_pressure;  ///< p_e, on the bore by the ring's own tension [Pa]
  std::optional<double> tangential_force;  ///< F_t = p_e b B/2, that closes the ring at its gap [N]
  /// Tangential force of the expander of an oil ring, which its rails share; F_t = p_e n b B/2 [N].
  std::optional<double> expander_force;
  std::optional<double> free_gap;          ///< gap of the free ring less that of the closed one [m]
  std::optional<double> radial_thickness;  ///< ring thickness t; with free_gap, and with gas_path [m]
  RingSection section;                     ///< not stated: a rectangle of face width and thickness
  LandPressure pressure_above;             ///< pressure at the piston land above; not stated: that of the cylinder
  LandPressure pressure_below;             ///< pressure at the piston land below; not stated: that of the crankcase
  /// In the groove, computed by the gas path: absolute [Pa], 0 = firing TDC. Absent: Gas::pressure_behind_ring.
  std::optional<base::Shared<SampledTrace>> pressure_behind;
  bool has_computed_gas = false;     ///< was the gas path of the pack computed for this ring?
  std::optional<double> land_below;  ///< height of the piston land down to the next ring [m]
  // keys of an oil ring
  int rails = 1;                        ///< faces, each face_width wide and with a film of its own
  std::optional<double> rail_distance;  ///< free height between two rails; absent: as high as a rail is wide [m]
  // film.dimension = "unrolled"; the end gap also where the gas path is computed
  std::optional<double> end_gap;               ///< between the ends of the ring in the bore; absent: a closed ring [m]
  double gap_position_deg = 0;                 ///< position of the middle of the gap around the bore [degree]
  Conformity conformity = Conformity::kRigid;  ///< does the ring of an unrolled film bend?
  LocalDeformation local_deformation = LocalDeformation::kNone;  ///< deformation by the film's pressure
  RingGasPath gas_path;                                          ///< what the gas meets at the ring
  /// Fourier terms of the target pressure of the ring, relative to its mean, from the gap's middle.
  std::vector<FourierTerm> pressure_orders;
  std::optional<std::string> pressure_points;    ///< CSV of that pressure around the ring, as named
  base::Shared<PressurePoints> pressure_around;  ///< points in the file pressure_points
  int pressure_points_orders = 8;                ///< the highest order that is kept of it
  std::optional<std::string> free_shape;         ///< CSV of the measured free ring, as named
  base::Shared<FreeRing> free_ring;              ///< free shape in the file free_shape
  double free_shape_smoothing = 0;               ///< shortest wave around the ring that is kept of it [m]
  RingFace face;                                 ///< shape of the face across its width
  Coating coating;                               ///< absent unless its modulus is stated

  /// Radial thickness t: as stated, or that of the corners of the section [m].
  std::optional<double> thickness() const {
    if (radial_thickness || section.corners.size() < 3) return radial_thickness;
    return models::section_extent(section.corners).thickness();
  }
};

/// The keys under `liner`.
struct Liner {
  double youngs_modulus = 92.3e9;  ///< E_2 [Pa]
  double poissons_ratio = 0.211;   ///< nu_2 [-]
  // properties of grey cast iron, for the flash temperature
  double thermal_conductivity = 55;  ///< [W/(m K)]
  double density = 7200;             ///< [kg/m3]
  double specific_heat = 490;        ///< [J/(kg K)]
  // out of roundness, for rings that bend: deviations of the radius that add up
  std::vector<FourierTerm> distortion;            ///< distortion of the cold bore [m]
  std::vector<FourierTerm> thermal_distortion;    ///< by heat [m]
  std::optional<std::string> distortion_map;      ///< CSV of the measured bore, as named
  base::Shared<BoreMap> map;                      ///< bore in the file distortion_map
  std::optional<std::string> dynamic_distortion;  ///< CSV of the part that changes over the cycle, as named
  base::Shared<DynamicBore> dynamic;              ///< distortion in the file dynamic_distortion
  int map_orders = 20;                            ///< the highest order that is kept of both files

  /// Is the bore round, without any stated distortion?
  bool is_round() const {
    return distortion.empty() && thermal_distortion.empty() && !distortion_map && !dynamic_distortion;
  }
};

/// The keys under `conform`: the static closure of the ring in its bore.
struct Conform {
  double gas_pressure = 0;       ///< behind the ring, above that in front of it [Pa]
  std::optional<double> height;  ///< along the stroke, of a bore that changes with it [m]
};

/// The contact law of a measured pair (docs/theory/contact-of-measured-pair.md), as `ringfilm contact` writes it.
struct ContactLawTable {
  models::ContactTable rows;             ///< separations that rise, with contact
  std::vector<double> mean_gap;          ///< mean gap at each of the rows [m]
  double composite_roughness = 0;        ///< rms of both maps together [m]
  double composite_modulus = 0;          ///< E' [Pa]
  std::optional<double> hardness;        ///< nothing: elastic [Pa]
  double last_supported_separation = 0;  ///< up to here several spots carry; beyond it is an extrapolation [m]
  /// Through the same gaps; nullptr where the file has none.
  std::shared_ptr<const models::MeasuredFlow> flow;
  std::optional<double> shift_deviation;           ///< standard deviation of the shift of the separation [m]
  std::optional<double> factor_deviation;          ///< standard deviation of ln p [-]
  std::optional<double> shift_factor_correlation;  ///< correlation of the shift and ln p [-]
};

/// The keys under `contact`.
struct Contact {
  ContactLaw model = ContactLaw::kGreenwoodTripp;    ///< law of the asperity contact
  AsperityLaw asperity = AsperityLaw::kElastic;      ///< how its asperities deform
  SummitPlane summit_plane = SummitPlane::kSurface;  ///< from which plane the separation is measured
  ContactMoments moments = ContactMoments::kPair;    ///< whose N and beta the law of pairs takes
  std::string law_file;                              ///< file of the law for kTable
  base::Shared<ContactLawTable> law;                 ///< law in law_file; empty without one
  double law_shift = 0;                              ///< shift of the law to larger separations [m]
  double law_factor = 1;                             ///< factor of the law's pressure and area [-]
  double asperity_density = 0;                       ///< N: asperity peaks per area of the pair [1/m2]
  double asperity_radius = 0;                        ///< beta: mean radius of their summits [m]
  double roughness = 0;                              ///< sigma: composite roughness of the pair, as stated [m]
  /// Is it used as stated, or is it Ra, to be multiplied by sqrt(pi/2) = 1.2533 for the rms?
  RoughnessMeasure roughness_measure = RoughnessMeasure::kAsGiven;
  double boundary_shear_strength_coefficient = 0;  ///< zeta: boundary shear strength over contact pressure [-]
  double eyring_shear_stress = 2e6;                ///< tau_0, of the boundary film [Pa]
  std::optional<std::string> friction_pair;        ///< name of a pair in data/pairs, which states zeta and the hardness
  base::Shared<models::FrictionPair> pair;         ///< pair named by friction_pair; without a name where there is none
  std::optional<double> composite_modulus;         ///< E' of 2/E' = sum (1 - nu^2)/E; absent: of ring and liner [Pa]
  /// H of the softer face; the contact is elastic, and its pressure is compared with it [Pa].
  std::optional<double> hardness;
  ContactIntegrals integrals = ContactIntegrals::kExact;  ///< integrals of the heights, F_2 and F_5/2
  LambdaRatio lambda_ratio = LambdaRatio::kLocal;         ///< contact pressure from h(x)/sigma, or h_m/sigma all over
  double ring_roughness_share = 0;  ///< share of the ring's own roughness in the square of sigma [-]; film.shear_flow
  Plateau plateau;                  ///< in place of sigma: plateau and valleys of the liner
  MeasuredContact measured;         ///< where N, beta, sigma and zeta come from

  /// Does nothing limit the pressure on the real area?
  bool is_elastic() const {
    return model == ContactLaw::kBushGibsonThomas || (model == ContactLaw::kTable && !law->hardness) ||
           ((model == ContactLaw::kGreenwoodTripp || model == ContactLaw::kGreenwoodWilliamson) &&
            asperity == AsperityLaw::kElastic);
  }
};

/// Lift of a flat land on a rough liner (docs/theory/land.md), as `ringfilm land` writes it.
struct LandLawTable {
  models::LandTable rows;                    ///< separations that rise, with lift
  double width = 0;                          ///< width of the land that was computed [m]
  double roughness = 0;                      ///< rms height of the surfaces [m]
  double lowest_gap = 0;                     ///< at the first row [m]
  std::optional<double> log_lift_deviation;  ///< standard deviation of ln lift over the patches [-]
};

/// The keys under `film`.
struct Film {
  FilmDimension dimension = FilmDimension::kFace;  ///< across the face, alike all around, or the whole unrolled ring
  Cavitation cavitation = Cavitation::kMassConserving;  ///< where the film ruptures: Reynolds, or mass kept (JFO)
  double cavitation_pressure = 101325;  ///< p_c, absolute [Pa]; of a pad counted like its other pressures
  /// What lies at an edge where the film leaves, and with a supply that is not flooded where it enters.
  EdgeFluid chamber_edge = EdgeFluid::kOil;
  EdgeFluid crankcase_edge = EdgeFluid::kOil;  ///< fluid at the edge towards the crankcase, as chamber_edge

  OilSupply supply = OilSupply::kFlooded;        ///< what enters at an edge of gas; see supply_at_inlet
  BrokenFilm broken = BrokenFilm::kFreeSurface;  ///< what passes where gas of an edge blows through the film
  Outlet outlet = Outlet::kHalfGap;              ///< what a film leaves where oil hangs on the face behind it

  Roughness flow_factors = Roughness::kNone;      ///< factors of the flow by pressure
  Roughness shear_flow = Roughness::kNone;        ///< factors of the flow by sliding
  Roughness stress_factors = Roughness::kNone;    ///< factors of the shear stress
  AverageGap average_gap = AverageGap::kNominal;  ///< gap that the film stores and the wall carries
  double orientation = 1;  ///< gamma of the roughness: correlation length along the motion over that across it [-]

  LandLift land_lift = LandLift::kNone;  ///< lift of the honing beside the film of the face
  std::string land_law_file;             ///< file of the law for LandLift::kTable
  base::Shared<LandLawTable> land_law;   ///< law in land_law_file; empty without one
  double land_factor = 1;                ///< factor of the lift of the law [-]

  /// Is one of the factors of this origin?
  bool has_factors(Roughness of) const { return flow_factors == of || shear_flow == of || stress_factors == of; }
  /// Is the flow, or a part of it, that through the gap of contact.law?
  bool is_measured() const { return has_factors(Roughness::kMeasured) || average_gap == AverageGap::kMeasured; }
  /// Does the film differ by roughness from that of smooth walls?
  bool is_rough() const {
    return has_factors(Roughness::kPatirCheng) || is_measured() || average_gap != AverageGap::kNominal;
  }
  /// Does the film of a ring end at gas?
  bool has_gas_edge() const { return chamber_edge == EdgeFluid::kGas || crankcase_edge == EdgeFluid::kGas; }
  /// What a film finds where it enters: edges of oil flood it, whatever the conditions set as `supply`.
  OilSupply supply_at_inlet() const { return has_gas_edge() ? supply : OilSupply::kFlooded; }
  // keys of a pad
  EdgeFluid left_edge = EdgeFluid::kOil;   ///< at x = 0
  EdgeFluid right_edge = EdgeFluid::kOil;  ///< at x = length
  std::optional<double> supply_left;       ///< film that enters at the left edge, if that has gas [m]
  std::optional<double> supply_right;      ///< film that enters at the right edge, if that has gas [m]

  /// Does the film of a pad end at gas?
  bool has_gas_edge_of_pad() const { return left_edge == EdgeFluid::kGas || right_edge == EdgeFluid::kGas; }
};

/// The keys under `supply`, of a film whose inlet is not flooded.
struct Supply {
  /// On the liner ahead of the ring, or what the oil ring leaves [m]; by distance, increasing; one point: everywhere.
  std::vector<StrokeValue> film;
  std::optional<double>
      reach;  ///< liner from so far below the TDC position of the chamber edge has it on downstrokes [m]
  Scraped scraped = Scraped::kBead;  ///< oil that an inlet does not take
};

/// The keys under `solver`.
struct Solver {
  std::optional<double> accuracy;  ///< to be reached: chooses cells, steps and scheme below (with_accuracy) [%]
  int cells = 200;                 ///< across the face
  CellLengths cell_lengths = CellLengths::kUniform;  ///< how they share it
  int cells_y = 180;               ///< cells in y of a two-dimensional film: around the ring, or across the pad
  std::optional<double> end_cell;  ///< length of the cells at the ends of the gap [m]
  static constexpr double kEndCell = 1.0 / 50;  ///< where it is not stated, of the face width [-]
  double crank_step_deg = 1.0;                  ///< crank angle step of the integration; whole steps make 720 [degree]
  StepControl crank_step_control = StepControl::kAdaptive;  ///< refine that step where the film needs it?
  TimeScheme time_scheme = TimeScheme::kBdf2;               ///< scheme of the time step
  double step_error = 1e-3;  ///< error in time let through per step, adaptive: in ln h_m; half of it in the oil [-]
  double tolerance = 1e-8;   ///< relative error left by the Newton iteration in film and pressure [-]
  Method method = Method::kCoupledNewton;       ///< how film and load balance are solved
  Properties properties = Properties::kFitted;  ///< polynomials fitted to the laws of oil and contact, or these laws
};

/// The keys under `output`.
struct Output {
  double crank_angle_step_deg = 1.0;                 ///< used where the list is empty [degree]
  std::vector<double> crank_angles_deg;              ///< explicit list, increasing, within [0, 720)
  FieldOutput fields = FieldOutput::kNone;           ///< at which angles pressure and film along the face are kept
  std::vector<double> field_angles_deg;              ///< where kListed: explicit list, increasing [degree]
  FieldReduction reduction = FieldReduction::kNone;  ///< reduction of the fields of an unrolled film
};

/// The keys under `pad.oscillation`: s(t) = separation + amplitude cos(2 pi t/period + phase) from t = 0 on.
struct PadOscillation {
  std::optional<double> amplitude;  ///< absent: the separation stays [m]
  double period = 0;                ///< [s]
  double phase_deg = 0;             ///< [degree]
};

/// A film of stated shape without ring and engine (docs/theory/pad.md). Pressures count from one zero, which the case
/// chooses; loads are per metre of width, means over it where it is finite.
struct Pad {
  double length = 0;                  ///< L, along the motion [m]
  std::optional<double> width;        ///< B, across the motion; absent: infinitely wide [m]
  FaceShape face{FaceForm::kPoints};  ///< its gap by a formula, or by points
  std::string gap_file;               ///< CSV or NetCDF of the points of the gap, as named
  std::vector<double> gap_x;          ///< x of the points, from 0 to the length, increasing; twice at a step [m]
  std::vector<double> gap_y;       ///< y of a map, from 0 to the width, increasing; empty: the same gap at every y [m]
  std::vector<double> gap_height;  ///< gap at each x; in a map, at each x of the first y, then of the next [m]
  PadGrooves grooves;              ///< cut into the formula of the gap
  std::optional<double> journal_radius;     ///< journal of which the film is unwrapped; absent: a flat pad [m]
  double speed = 0;                         ///< speed of the flat surface [m/s]
  Direction direction = Direction::kPlusX;  ///< which way the flat surface moves
  double left_pressure = 0;                 ///< at x = 0 [Pa]
  double right_pressure = 0;                ///< at x = length [Pa]
  // width
  Sides sides = Sides::kOpen;  ///< what the film ends at across the motion
  double front_pressure = 0;   ///< at y = 0, open sides [Pa]
  double back_pressure = 0;    ///< at y = width, open sides [Pa]
  // exactly one of: separation | load | separation_history
  std::optional<double> separation;                    ///< adds to the gap; the mean of an oscillation [m]
  std::optional<double> load;                          ///< carried by the film, which finds its separation [N/m]
  std::optional<std::string> separation_history_file;  ///< CSV of separation against time, as named
  std::vector<double> history_time;                    ///< [s], increasing
  std::vector<double> history_separation;              ///< at these times, straight between them [m]
  // separation_history | oscillation
  PadOscillation oscillation;         ///< about the separation
  double time_step = 0;               ///< time step of the integration [s]
  std::optional<double> end_time;     ///< absent: end of the history [s]
  std::optional<double> output_step;  ///< absent: every time step is kept [s]

  bool has_sides_at_pressures() const { return width && sides == Sides::kOpen; }  ///< for pads with a width only

  /// Is the gap a formula over x, without points?
  bool has_formula() const { return face.form != FaceForm::kPoints; }
  /// Removes what files gave.
  void clear_points() {
    for (auto* points : {&gap_x, &gap_y, &gap_height, &history_time, &history_separation}) points->clear();
  }
  /// Is the film integrated over time?
  bool is_transient() const { return separation_history_file.has_value() || oscillation.amplitude.has_value(); }
  /// Where the integration begins [s].
  double first_time() const { return history_time.empty() ? 0.0 : history_time.front(); }
  /// Where the integration ends [s].
  double last_time() const { return end_time.value_or(history_time.empty() ? 0.0 : history_time.back()); }
};

/// A file that the case was read from, for the record.
struct InputFile {
  std::string role;    ///< "case", "include", "gas.cylinder_pressure", ...
  std::string path;    ///< as named
  std::string sha256;  ///< SHA-256 checksum of the file
};

/// All keys of a case. Members that a problem or a model does not use stay as they are.
struct Case {
  Problem problem = Problem::kCycle;               ///< a pad where any of its keys is stated
  CasePurpose purpose = CasePurpose::kFilm;        ///< what it was read for
  std::string title;                               ///< for people; names pages and figures
  Conditions conditions = Conditions::kOfTheCase;  ///< from which defaults the rest starts
  Engine engine;                                   ///< bore and crank
  Operating operating;                             ///< speed and oil temperature
  Thermal thermal;                                 ///< temperatures of ring and liner, if the film has them
  Gas gas;                                         ///< pressure above, below and behind the ring
  GasPath gas_path;                                ///< how the gas passes the rings
  Ring ring;                                       ///< size, tension, face, coating, gap
  Liner liner;                                     ///< what the bore is made of
  Conform conform;                                 ///< the static closure of the ring in its bore
  Contact contact;                                 ///< roughness of the pair and boundary friction
  Lubricant lubricant;                             ///< the oil by its laws, or by a table
  Supply supply;                                   ///< oil on the liner, if the inlet is not flooded
  Evaporation evaporation;                         ///< transfer of oil vapour from the liner to the gas
  OilTransport oil_transport;                      ///< what carries oil into the chamber
  Film film;                                       ///< in one dimension or two, and how it ruptures
  Solver solver;                                   ///< grid, steps, tolerances
  Output output;                                   ///< what is kept of the integration
  Pad pad;                                         ///< pad, for Problem::kPad only
  /// Case of each ring of a ring pack ([[ring]]), from the chamber to the crankcase, complete and without rings of its
  /// own. `ring` and `contact` of the pack itself are those of the first ring. Empty: a case of one ring.
  std::vector<Case> rings;

  /// Does the film differ from that of a Newtonian oil between smooth walls?
  bool has_flow_factors() const { return film.is_rough() || lubricant.thins(); }
  /// Do asperities carry load? Those of a pad do where a composite modulus is stated.
  bool has_contact() const { return problem == Problem::kCycle || contact.composite_modulus.has_value(); }
  bool is_pack() const { return !rings.empty(); }  ///< several rings, or one written as [[ring]]
  /// Is the oil on the liner followed from stroke to stroke?
  bool follows_oil() const { return problem == Problem::kCycle && film.supply_at_inlet() == OilSupply::kFilmOnLiner; }
  /// Around the ring, too?
  bool is_unrolled() const { return problem == Problem::kCycle && film.dimension == FilmDimension::kUnrolled; }
  /// Does its ring bend in the bore?
  bool bends() const { return is_unrolled() && ring.conformity == Conformity::kBeam; }
  /// Does its section turn over the cycle, and the face with it?
  bool twists() const {
    return ring.section.is_stated() && ring.section.twist == RingTwist::kQuasiStatic && can_twist();
  }
  bool can_twist() const;  ///< is the film one across the rigid face of a compression ring that never turns over?
  /// Is anything stated that only a ring that bends uses?
  bool has_closure() const {
    return bends() || problem == Problem::kClosure || !liner.is_round() || !ring.pressure_orders.empty() ||
           ring.pressure_points || ring.free_shape || conform.gas_pressure > 0 || conform.height;
  }
  /// Does the film of a pad enter out of gas, with a surface that moves that way?
  bool enters_out_of_gas(Direction direction) const {
    const EdgeFluid inlet = direction == Direction::kPlusX ? film.left_edge : film.right_edge;
    return inlet == EdgeFluid::kGas && pad.direction == direction && pad.speed > 0;
  }
  /// Around the bore; of an unrolled film without the gap [m].
  double ring_length() const;
  /// Requested length of the cells at the ends of the ring [m].
  double end_cell() const { return solver.end_cell.value_or(Solver::kEndCell * ring.face_width); }

  std::set<std::string> stated;  ///< keys that the user gave; every other active key is an assumption
  std::vector<InputFile> files;  ///< everything that was read
  /// Notes of the reader on the input (byte-order mark, synthetic trace, ...).
  std::vector<std::string> notes;
};

inline bool Case::can_twist() const {
  return problem == Problem::kCycle && !is_unrolled() && ring.local_deformation == LocalDeformation::kNone &&
         ring.face.orientation != Orientation::kLeadingEdge && ring.gas_path.kind == RingKind::kCompression;
}

inline double Case::ring_length() const {
  const double circumference = std::numbers::pi * engine.bore;
  return is_unrolled() ? circumference - ring.end_gap.value_or(0) : circumference;
}

/// The case before anything is stated. What is usual for a ring's oil and its absolute pressures is not for a pad.
inline Case blank_case(Problem problem) {
  Case c;
  c.problem = problem;
  if (problem == Problem::kPad) {
    c.title = "pad";
    c.lubricant.viscosity_pressure = ViscosityPressure::kNone;
    c.lubricant.compressibility = Compressibility::kNone;
    c.film.cavitation_pressure = 0;
  }
  return c;
}

}  // namespace ringfilm::cycle
