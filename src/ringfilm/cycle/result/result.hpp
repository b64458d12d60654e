#pragma once
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "ringfilm/base/members.hpp"

/// What one engine cycle gives. Two tables name every quantity once: `curve_quantities` over crank angle and
/// `cycle_quantities` for the cycle as a whole; CSV, JSON, NetCDF, report and Python walk them.
namespace ringfilm::cycle {

/// Everything at one crank angle. SI. Loads, friction and flow are for the whole ring: for the circumference pi x bore,
/// without the gap for an unrolled film. The places where the cavity begins and ends are those of the strip opposite
/// the gap. Signs: velocity and friction on the liner are positive towards TDC. `viscous_friction_ring` is the shear at
/// the ring in the same sense of motion, so that the force on the ring itself is its opposite. Flows of oil and gas are
/// positive from chamber to crankcase.
struct Sample {
  double crank_angle_deg = 0;          ///< in [0, 720), 0 = firing TDC [degree]
  double piston_position = 0;          ///< distance below TDC [m]
  double piston_velocity = 0;          ///< U_p, positive towards TDC [m/s]
  double sliding_distance = 0;         ///< path on the liner since firing TDC, down and up strokes added [m]
  double gas_pressure = 0;             ///< in the cylinder, absolute [Pa]
  double crankcase_pressure = 0;       ///< under the ring, absolute [Pa]
  double applied_load = 0;             ///< W: what presses the ring on the liner, its tension and the gas behind it [N]
  double hydrodynamic_load = 0;        ///< W_h: carried by the film, of absolute pressure [N]
  double land_lift = 0;                ///< part of W_h by the honing of the liner; 0 without film.land_lift [N]
  double asperity_load = 0;            ///< W_a: carried by touching asperities [N]
  double asperity_load_share = 0;      ///< part of W_a in what oil and asperities carry beyond the gas [-]
  double min_film_thickness = 0;       ///< h_m: thinnest place of the film, where the face is lowest [m]
  double lambda_ratio = 0;             ///< h_m over composite roughness [-]
  double asperity_contact_area = 0;    ///< A_a, in real contact [m2]
  double mean_real_pressure = 0;       ///< W_a/A_a; 0 where asperities carry less than 1 % of the load [Pa]
  double boundary_friction = 0;        ///< f_b = tau_0 A_a + zeta W_a, modulus [N]
  double viscous_friction = 0;         ///< f_v: oil shear on the liner, modulus [N]
  double viscous_friction_liner = 0;   ///< oil shear on the liner, signed, positive towards TDC [N]
  double viscous_friction_ring = 0;    ///< oil shear at the ring, sign as defined above [N]
  double total_friction = 0;           ///< f_t = f_b + f_v [N]
  double friction_on_liner = 0;        ///< boundary and viscous, positive towards TDC [N]
  double friction_coefficient = 0;     ///< f_t/W [-]
  double power_loss = 0;               ///< f_t |U_p| [W]
  double archard_wear_load_rate = 0;   ///< asperity load x speed [W]
  double oil_flow_middle = 0;          ///< oil flow through the middle of the face, in the frame of the ring [kg/s]
  double oil_flow_chamber_edge = 0;    ///< oil flow through the edge at the chamber, in the frame of the ring [kg/s]
  double oil_flow_crankcase_edge = 0;  ///< oil flow through the edge at the crankcase, in the frame of the ring [kg/s]
  double stribeck_number = 0;          ///< eta |U_p|/(p sigma), eta of the oil at 1 atm, p = W per area of the face [-]
  double peak_film_pressure = 0;       ///< largest along the face, absolute [Pa]
  double cavitated_fraction = 0;       ///< share of the face that is a cavity [-]
  double wetted_begin = 0;             ///< chamber-side end of the wetted face, from the chamber edge [m]
  double wetted_end = 0;               ///< crankcase-side end of it; between them lies no gas of an edge [m]
  double gas_breakthrough = 0;         ///< 1 where gas of an edge reaches the lowest place of the face, else 0 [-]
  double gas_flow_through_film = 0;    ///< gas through the film where it breaks through, else 0 [kg/s]
  double distance_off_liner = 0;       ///< at which gas holds the ring off the liner; 0: film and asperities carry [m]
  double rupture_position = 0;      ///< where the cavity begins, from the chamber edge [m]; NaN where the film is full
  double reformation_position = 0;  ///< where the cavity ends, from the chamber edge [m]; NaN where the film is full
  double film_temperature = 0;      ///< temperature of the oil film [K]
  double film_ahead = 0;            ///< oil on the liner ahead of the ring; NaN where it floods the inlet [m]
  double film_left_behind = 0;      ///< oil on the liner behind a trailing edge in gas; NaN at an edge of oil [m]
  double bead_volume = 0;           ///< scraped oil that the ring moves ahead of it [m3]
  double viscous_heating_rise = 0;  ///< mean rise of its temperature above that of its walls, by shear [K]
  double flash_temperature = 0;     ///< mean rise of the liner's surface under the face, by boundary friction [K]
  /// Largest difference of pressure that the film holds against gas where it leaves over the one that acts [-]; NaN
  /// where the film leaves into oil or towards the lower pressure.
  double gas_holding_margin = 0;
  double peak_shear_rate = 0;        ///< largest along the face [1/s]
  double max_local_deformation = 0;  ///< by which face and liner are pressed apart at most, over their edges [m]
  double twist = 0;                  ///< twist of the section, positive with the face towards the chamber [rad]
  double newton_iterations = 0;      ///< spent on the way here from the crank step before
  double crank_sub_steps = 0;        ///< steps taken on that way
  double fallbacks = 0;              ///< bracketed searches and shorter steps that were needed on it
  double load_residual = 0;          ///< |W_h + W_a - W|/W [-]
};

/// Name, unit and meaning of one quantity; `name` is the word used everywhere, from the CSV header to the caption.
struct Quantity {
  std::string name;          ///< e.g. "min_film_thickness"
  std::string unit;          ///< SI, UDUNITS spelling; "degree" for crank angles, "1" dimensionless
  std::string display_unit;  ///< engineer's unit, e.g. "um"
  std::string long_name;     ///< plain words, e.g. "minimum film thickness"
  std::string symbol;        ///< as in docs/theory, e.g. "h_m"
  std::string equation;      ///< label in docs/theory, e.g. "eq-power-loss"
};

/// Is it a share of a regime of lubrication? It may vanish: its errors are relative to the whole.
inline bool is_regime_share(const Quantity& quantity) { return quantity.equation == "eq-regime-shares"; }

/// A quantity over crank angle and where `Sample` has it.
struct CurveQuantity : Quantity {
  double Sample::*value;  ///< the member that holds it
};

/// In the order of the CSV columns. The first is the crank angle.
const std::vector<CurveQuantity>& curve_quantities();

/// Values of the cycle as a whole, SI, in the order of `cycle_quantities()`. Means over time and peaks over the crank
/// steps of the last cycle (docs/theory/cycle-values.md); angles with 0 = firing TDC.
struct CycleValues {
  double energy_per_cycle = 0;              ///< E: friction energy of one cycle [J]
  double mean_power_loss = 0;               ///< mean power of total friction [W]
  double fmep = 0;                          ///< friction mean effective pressure of this ring: E over swept volume [Pa]
  double mean_boundary_power = 0;           ///< part of mean_power_loss by boundary friction [W]
  double mean_viscous_power = 0;            ///< part of it by oil shear on the liner [W]
  double mean_boundary_friction = 0;        ///< mean modulus of the boundary friction [N]
  double peak_boundary_friction = 0;        ///< largest modulus [N]
  double peak_boundary_friction_angle = 0;  ///< crank angle of it [degree]
  double mean_viscous_friction = 0;         ///< mean modulus of the viscous friction on the liner [N]
  double peak_viscous_friction = 0;         ///< largest modulus on the liner [N]
  double peak_viscous_friction_angle = 0;   ///< crank angle of it [degree]
  double mean_total_friction = 0;           ///< mean total friction, f_t = f_b + f_v [N]
  double peak_total_friction = 0;           ///< largest f_t [N]
  double peak_total_friction_angle = 0;     ///< crank angle of it [degree]
  double peak_friction_coefficient = 0;     ///< largest f_t/W [-]
  double peak_friction_coefficient_angle = 0;   ///< crank angle of it [degree]
  double peak_friction_coefficient_firing = 0;  ///< within +-60 degree of firing TDC [-]
  double min_film_thickness = 0;                ///< smallest h_m of the cycle [m]
  double min_film_thickness_angle = 0;          ///< crank angle of it [degree]
  double max_film_thickness = 0;                ///< largest h_m of the cycle [m]
  double peak_gas_pressure = 0;                 ///< peak pressure of the cylinder, absolute [Pa]
  double peak_gas_pressure_angle = 0;           ///< crank angle of it [degree]
  double lambda_ratio_at_peak_pressure = 0;     ///< h_m/sigma at the peak of the cylinder pressure [-]
  double min_lambda_ratio = 0;                  ///< smallest h_m/sigma of the cycle [-]
  double peak_mean_real_pressure = 0;           ///< largest W_a/A_a; 0 where asperities never carry 1 % [Pa]
  double boundary_regime_cycle_share = 0;       ///< share of time in which asperities carry more than 90 % [-]
  double mixed_regime_cycle_share = 0;          ///< share of time in which asperities carry 1 to 90 % [-]
  double full_film_cycle_share = 0;             ///< share of time in which asperities carry less than 1 % [-]
  double boundary_regime_distance_share = 0;    ///< share of the sliding distance in boundary lubrication [-]
  double mixed_regime_distance_share = 0;       ///< share of the sliding distance in mixed lubrication [-]
  double full_film_distance_share = 0;          ///< share of the sliding distance in full-film lubrication [-]
  double boundary_regime_energy_share = 0;      ///< share of the friction energy in boundary lubrication [-]
  double mixed_regime_energy_share = 0;         ///< share of the friction energy in mixed lubrication [-]
  double full_film_energy_share = 0;            ///< share of the friction energy in full-film lubrication [-]
  /// Weighted with the load, as are the next two: what a scenario is on a Stribeck curve [-].
  double mean_friction_coefficient = 0;
  double mean_stribeck_number = 0;     ///< weighted with the load [-]
  double mean_lambda_ratio = 0;        ///< weighted with the load [-]
  double net_oil_flow = 0;             ///< mean through the middle of the face, positive to the crankcase [kg/s]
  double mean_absolute_oil_flow = 0;   ///< mean of its modulus [kg/s]
  double peak_film_pressure = 0;       ///< largest along the face and over the cycle, absolute [Pa]
  double mean_cavitated_fraction = 0;  ///< share of the face that is a cavity [-]
  double oil_scraped_up =
      0;  ///< left above the ring at TDC, per cycle; 0 where the film on the liner is not followed [kg]
  /// Oil left below the ring at BDC, per cycle; 0 where the film on the liner is not followed [kg]
  double oil_scraped_down = 0;
  /// Oil that the oil ring lays on the liner less what it scrapes off, per cycle; 0 where the film is not followed [kg]
  double oil_replenished = 0;
  double gas_through_film_forward = 0;         ///< gas through a broken film towards the crankcase, per cycle [kg]
  double gas_through_film_back = 0;            ///< gas through it back towards the chamber, per cycle, positive [kg]
  double off_liner_share = 0;                  ///< share of the cycle in which gas holds the ring off the liner [-]
  double peak_viscous_heating_rise = 0;        ///< largest rise of the film's temperature by shear [K]
  double peak_viscous_heating_rise_angle = 0;  ///< crank angle of it [degree]
  double peak_flash_temperature = 0;           ///< largest rise of the liner's surface under the face [K]
  double peak_flash_temperature_angle = 0;     ///< crank angle of it [degree]
  double peak_local_deformation = 0;           ///< largest by which face and liner are pressed apart [m]
  double peak_local_deformation_angle = 0;     ///< crank angle of it [degree]
  double peak_twist = 0;                       ///< twist of the section that is largest by its size [rad]
  double peak_twist_angle = 0;                 ///< crank angle of it [degree]
  double archard_wear_load = 0;                ///< integral of asperity load x speed over the cycle [J]
  double power_stroke_energy = 0;              ///< part of E from 0 to 180 degree [J]
  double exhaust_stroke_energy = 0;            ///< part of E from 180 to 360 degree [J]
  double intake_stroke_energy = 0;             ///< part of E from 360 to 540 degree [J]
  double compression_stroke_energy = 0;        ///< part of E from 540 to 720 degree [J]
};

/// A value of the cycle and where `CycleValues` has it.
struct CycleQuantity : Quantity {
  double CycleValues::*value;    ///< the member that holds it
  bool adds_over_rings = false;  ///< is the sum over the rings that of the pack?
};
const std::vector<CycleQuantity>& cycle_quantities();  ///< in the order of files and tables

/// Those that add up over the rings of a pack.
const std::vector<CycleQuantity>& summed_quantities();

/// Adds the summed_quantities() of a ring.
void add_ring(const CycleValues& ring, CycleValues& pack);

/// Index of a name in cycle_quantities(); nothing where no value of a cycle has it.
std::optional<std::size_t> cycle_quantity_index(const std::string& name);

/// Fields along the face at some crank angles, of an unrolled film along its strip halfway; row-major [angle][node]. x
/// from the chamber edge.
struct FaceFields {
  std::vector<double> x;                  ///< [m]
  std::vector<double> face_height;        ///< h_s as installed [m]
  std::vector<double> crank_angle_deg;    ///< may be empty
  std::vector<double> film_thickness;     ///< [m]
  std::vector<double> film_pressure;      ///< [Pa] absolute
  std::vector<double> film_content;       ///< theta, liquid share of the gap [-]
  std::vector<double> lambda_ratio;       ///< h(x)/sigma [-]
  std::vector<double> local_deformation;  ///< delta, over the mean of both edges; empty: face and liner are rigid [m]
  std::vector<double> asperity_pressure;  ///< [Pa]
};

/// What one crank angle gives beyond `Sample` where the film is unrolled.
struct UnrolledSample {
  double gap_leakage = 0;      ///< oil out of the film through both ends of the ring [kg/s]; negative: drawn in
  double ends_share_load = 0;  ///< 1 - load of the strip opposite the gap x length / load of the whole ring [-]
  /// 1 - total friction of the strip opposite the gap x length / that of the whole ring [-]
  double ends_share_friction = 0;
  /// 1 - middle oil flow of the strip opposite the gap x length / that of the whole ring; NaN where that is 0 [-]
  double ends_share_flow = 0;
  double gap_leakage_low_end = 0;    ///< part of the leakage through the end y = 0 [kg/s]
  double gap_leakage_high_end = 0;   ///< part of the leakage through the end y = length [kg/s]
  double oil_flow_without_ends = 0;  ///< at the middle section, if all were like the strip opposite the gap [kg/s]
  double open_area = 0;              ///< between ring and bore where the ring is lifted off [m2]
  double lifted_angle = 0;           ///< angle around the bore of these parts [degree]
  double max_clearance = 0;          ///< largest film thickness of all strips, each at its lowest place [m]
  double max_clearance_place = 0;    ///< where that is, from the middle of the gap [degree]
  double gas_opening = 0;        ///< gap all around that gas passes like these parts, eq-open-gas-path; in no file [m]
  double load_without_ends = 0;  ///< load carried, if all strips were like the one opposite the gap; in no file [N]
  /// Total friction, if all strips were like the one opposite the gap; in no file [N]
  double friction_without_ends = 0;
};

/// A quantity over crank angle of an unrolled film and where `UnrolledSample` has it.
struct UnrolledQuantity : Quantity {
  double UnrolledSample::*value;  ///< the member that holds it
};
/// In the order of their CSV columns.
const std::vector<UnrolledQuantity>& unrolled_quantities();

/// What the ends of the gap do over a cycle, in the order of `unrolled_cycle_quantities()`.
struct UnrolledValues {
  double mean_gap_leakage = 0;           ///< positive out of the film [kg/s]
  double mean_absolute_gap_leakage = 0;  ///< mean modulus of the leakage [kg/s]
  double peak_gap_leakage = 0;           ///< largest either way, positive out of the film [kg/s]
  double peak_gap_leakage_angle = 0;     ///< crank angle of it [degree]
  double gap_leakage_share = 0;          ///< mean absolute leakage over mean absolute flow at the middle section [-]
  double ends_share_mean_load = 0;       ///< 1 - mean as if without ends / mean of the whole ring [-]
  /// Share of the ends in the mean friction power: 1 - mean as if without ends / mean of the whole ring [-]
  double ends_share_friction_power = 0;
  double ends_share_absolute_flow = 0;  ///< share of the ends in the mean absolute flow at the middle section [-]
  double mean_open_area = 0;            ///< between ring and bore where the ring is lifted off [m2]
  double peak_open_area = 0;            ///< [m2]
  double peak_open_area_angle = 0;      ///< crank angle of it [degree]
  double peak_clearance = 0;            ///< largest film thickness of all strips over the cycle [m]
  double peak_clearance_angle = 0;      ///< crank angle of it [degree]
};

/// A value of the cycle of an unrolled film and where `UnrolledValues` has it.
struct UnrolledCycleQuantity : Quantity {
  double UnrolledValues::*value;  ///< the member that holds it
};
const std::vector<UnrolledCycleQuantity>& unrolled_cycle_quantities();  ///< in the order of files and tables

/// Fields of the unrolled film at some crank angles: x from the chamber edge, y from one end of the gap around to the
/// other, or from the joint of a closed ring. Reduced along the face to [angle][y], and in full over [angle][y][x]
/// where that was asked for; what was not is empty.
struct UnrolledFields {
  double circumference = 0;                     ///< pi x bore [m]
  double end_gap = 0;                           ///< between y = length and y = 0 [m]; 0: a closed ring
  double gap_position = 0;                      ///< position of the middle of the gap around the bore [rad]
  std::vector<double> x;                        ///< along the face, from 0 to its width [m]
  std::vector<double> y;                        ///< around the ring, from 0 to its length [m]
  std::vector<double> crank_angle_deg;          ///< may be empty
  std::vector<float> film_thickness;            ///< [m], [angle][y][x]
  std::vector<float> film_pressure;             ///< [Pa] absolute
  std::vector<float> film_content;              ///< theta, liquid share of the gap [-]
  std::vector<float> asperity_pressure;         ///< [Pa]
  std::vector<float> strip_hydrodynamic_load;   ///< carried by the film, per length in y [N/m], [angle][y]
  std::vector<float> strip_asperity_load;       ///< carried by asperities, per length in y [N/m]
  std::vector<float> strip_peak_film_pressure;  ///< largest across the face, absolute [Pa]
  std::vector<float> strip_cavitated_fraction;  ///< share of the width [-]
  std::vector<float> strip_min_film_thickness;  ///< smallest across the face [m]
  std::vector<float> strip_total_friction;      ///< friction of oil and asperities, per length in y [N/m]
  std::vector<float> strip_oil_flow_middle;     ///< positive to the crankcase, per length in y [kg/(m s)]
  std::vector<float> strip_lifted_off;          ///< 1 where the ring is lifted off, else 0 [-]
  std::vector<float> strip_bore_deviation;  ///< radius of the bore over that of the round one; of a ring that bends [m]

  bool empty() const { return crank_angle_deg.empty(); }  ///< no angle was asked for
  /// Does it belong to a film across the face, which has nothing of it?
  bool is_absent() const { return y.empty(); }
};

/// A field of an unrolled film and where `UnrolledFields` has it.
struct UnrolledField : Quantity {
  std::vector<float> UnrolledFields::*values;  ///< the member that holds it, [angle][y][x] or [angle][y]
};
/// Fields over (crank_angle, y, x), then those over (crank_angle, y).
const std::vector<UnrolledField>& unrolled_fields();
const std::vector<UnrolledField>& strip_fields();  ///< those reduced along the face

/// Where on the stroke asperities rub: contact work per liner length over one cycle.
struct StrokeProfile {
  std::vector<double> liner_position;  ///< distance below the ring's TDC position, bin centres [m]
  std::vector<double>
      archard_wear_load_density;  ///< contact work per length of liner [J/m] (= N summed over the passes)
  /// Oil on the liner where the ring is, ahead of it, by stroke from power on; empty where it is not followed
  /// (`film.supply = "film-on-liner"`) [m].
  std::array<std::vector<double>, 4> film_ahead;
  std::array<std::vector<double>, 4> film_behind;  ///< oil on the liner behind the ring, by stroke as `film_ahead` [m]
};

/// A film on the liner over the stroke, and where `StrokeProfile` has it.
struct StrokeFilm : Quantity {
  std::array<std::vector<double>, 4> StrokeProfile::*films;  ///< the member that holds it
  std::size_t stroke;                                        ///< 0 power, 1 exhaust, 2 intake, 3 compression
};
const std::vector<StrokeFilm>& stroke_films();  ///< in the order of files

/// Something the user must know about this result: a law outside its range, a remedy that was used.
struct Note {
  std::string topic;    ///< short, stable word, e.g. "density-extrapolated"
  std::string message;  ///< a sentence with figures and units
  long count = 1;       ///< crank steps or evaluations concerned
};

/// The members of a note, as all outputs have them.
constexpr auto members(const Note*) {
  return std::tuple{Member{"topic", "", "stable word for the note", &Note::topic},
                    Member{"message", "", "what the user must know about this result", &Note::message},
                    Member{"count", "1", "crank steps or evaluations concerned", &Note::count}};
}

/// What the integration cost, and how well it kept its tolerances.
struct Effort {
  double cycles_integrated = 0;  ///< until periodic
  double periodicity_error =
      0;                 ///< largest relative difference of the state one cycle apart, or of the oil from its end [-]
  long crank_steps = 0;  ///< taken in all cycles integrated, shortened ones among them
  /// Newton iterations of all films that were sought, also of steps that were repeated with a shorter length
  long newton_iterations = 0;
  long sub_steps = 0;            ///< crank steps shorter than solver.crank_step
  long fallback_secant = 0;      ///< films that a bracketed search found because Newton's method failed
  long fallback_sub_step = 0;    ///< times that a step was cut because no film was found
  double max_load_residual = 0;  ///< |W_h + W_a - W|/W [-]
  double max_newton_step = 0;    ///< last relative Newton step accepted, worst of the cycle [-]
  /// Worst mass balance of a step, relative to the largest flow at the middle section [-].
  double max_mass_residual = 0;
  long relaxation_sweeps = 0;  ///< sweeps of solver.method = "point-relaxation"
};

/// All that an integration gives. Plain data: what files, pages and other programs are made of.
struct CycleResult {
  std::vector<Sample> samples;                   ///< at the crank angles asked for
  CycleValues values;                            ///< from the whole integration, whatever was asked for
  FaceFields fields;                             ///< where output.fields asks for them; x and face_height always
  std::vector<UnrolledSample> unrolled_samples;  ///< beside `samples`; empty without an unrolled film
  UnrolledValues unrolled_values;                ///< NaN where the integration stopped
  UnrolledFields unrolled;                       ///< without an unrolled film not even y
  StrokeProfile stroke;                          ///< empty where the integration stopped
  std::map<std::string, double> derived;  ///< composite_modulus, elastic_pressure, ... [SI]; see derived_quantities()
  std::vector<Note> notes;  ///< laws outside their range, remedies that were used; empty: nothing to be known
  Effort effort;            ///< effort of the whole integration, the cycles before the last one too
  bool complete = true;     ///< false: the integration stopped; `samples` are those that it had passed
};

/// Constants that follow from the case before anything is integrated (keys of CycleResult::derived).
const std::vector<Quantity>& derived_quantities();

}  // namespace ringfilm::cycle
