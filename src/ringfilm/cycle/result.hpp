#pragma once
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

/// What one engine cycle gives. Two tables name every quantity once: `curve_quantities` over crank angle and
/// `cycle_quantities` for the cycle as a whole; CSV, JSON, NetCDF, report and Python walk them.
namespace ringfilm::cycle {

/// Everything at one crank angle. SI; loads, friction and flow for the whole ring: the circumference pi x bore, of an
/// unrolled film without the gap. Where the cavity begins and ends is told of its strip halfway, opposite the gap.
/// Signs: velocity and friction on the liner positive towards TDC; `viscous_friction_ring` is the shear at the ring in
/// the same sense of motion, so that the force on the ring itself is its opposite; oil flow positive from chamber to
/// crankcase.
struct Sample {
  double crank_angle_deg = 0;
  double piston_position = 0, piston_velocity = 0, sliding_distance = 0;
  double gas_pressure = 0, crankcase_pressure = 0;
  double applied_load = 0, hydrodynamic_load = 0, asperity_load = 0;
  double min_film_thickness = 0, film_parameter = 0, asperity_contact_area = 0;
  double boundary_friction = 0, viscous_friction = 0, viscous_friction_liner = 0, viscous_friction_ring = 0;
  double total_friction = 0, friction_on_liner = 0, friction_coefficient = 0, power_loss = 0;
  double wear_drive = 0;  ///< asperity load x speed
  double oil_flow_middle = 0, oil_flow_chamber_edge = 0, oil_flow_crankcase_edge = 0;
  double stribeck_number = 0, peak_film_pressure = 0, cavitated_fraction = 0;
  double rupture_position = 0, reformation_position = 0;  ///< along the face; NaN where the film is full
  double newton_iterations = 0, crank_sub_steps = 0, fallbacks = 0, load_residual = 0;
};

/// Name, unit and meaning of one quantity; `name` is the word used everywhere, from the CSV header to the caption.
struct Quantity {
  std::string name;
  std::string unit;          ///< SI, UDUNITS spelling; "degree" for crank angles, "1" dimensionless
  std::string display_unit;  ///< engineer's unit, e.g. "um"
  std::string long_name;     ///< plain words, e.g. "minimum film thickness"
  std::string symbol;        ///< as in docs/theory, e.g. "h_m"
  std::string equation;      ///< label in docs/theory, e.g. "eq-power-loss"
};

/// A quantity over crank angle and where `Sample` has it.
struct CurveQuantity : Quantity {
  double Sample::*value;
};

/// In the order of the CSV columns. The first is the crank angle.
const std::vector<CurveQuantity>& curve_quantities();

/// Values of the cycle as a whole, SI, in the order of `cycle_quantities()`.
struct CycleValues {
  double energy_per_cycle = 0, mean_power_loss = 0, fmep = 0;
  double mean_boundary_power = 0, mean_viscous_power = 0;
  double mean_boundary_friction = 0, peak_boundary_friction = 0, peak_boundary_friction_angle = 0;
  double mean_viscous_friction = 0, peak_viscous_friction = 0, peak_viscous_friction_angle = 0;
  double mean_total_friction = 0, peak_total_friction = 0, peak_total_friction_angle = 0;
  double peak_friction_coefficient = 0, peak_friction_coefficient_angle = 0;
  double peak_friction_coefficient_firing = 0;  ///< within +-60 degree of firing TDC
  double min_film_thickness = 0, min_film_thickness_angle = 0, max_film_thickness = 0;
  double peak_gas_pressure = 0, peak_gas_pressure_angle = 0;
  double film_parameter_at_peak_pressure = 0, min_film_parameter = 0;
  double mixed_share = 0;
  /// Weighted with the load: what a scenario is on a Stribeck curve.
  double mean_friction_coefficient = 0, mean_stribeck_number = 0, mean_film_parameter = 0;
  double net_oil_flow = 0, mean_absolute_oil_flow = 0;
  double peak_film_pressure = 0, mean_cavitated_fraction = 0;
  double wear_drive_energy = 0;  ///< integral of asperity load x speed over the cycle
  double power_stroke_energy = 0, exhaust_stroke_energy = 0, intake_stroke_energy = 0, compression_stroke_energy = 0;
};

/// A value of the cycle and where `CycleValues` has it.
struct CycleQuantity : Quantity {
  double CycleValues::*value;
};
const std::vector<CycleQuantity>& cycle_quantities();  ///< in the order of files and tables

/// Where a name stands among cycle_quantities(); nothing where no value of a cycle has it.
std::optional<std::size_t> cycle_quantity_index(const std::string& name);

/// Fields along the face at some crank angles, of an unrolled film along its strip halfway; row-major [angle][node]. x
/// from the chamber edge.
struct FaceFields {
  std::vector<double> x;                  ///< [m]
  std::vector<double> face_height;        ///< h_s as installed [m]
  std::vector<double> crank_angle_deg;    ///< may be empty
  std::vector<double> film_thickness;     ///< [m]
  std::vector<double> film_pressure;      ///< [Pa] absolute
  std::vector<double> fill;               ///< theta, liquid share of the gap [-]
  std::vector<double> film_parameter;     ///< h(x)/sigma [-]
  std::vector<double> asperity_pressure;  ///< [Pa]
};

/// What one crank angle gives beyond `Sample` where the film is unrolled.
struct UnrolledSample {
  double gap_leakage = 0;          ///< oil out of the film through both ends of the ring [kg/s]; negative: drawn in
  double ends_share_load = 0;      ///< 1 - strip opposite the gap x length / whole ring [-]
  double ends_share_friction = 0;  ///< the same of the total friction [-]
  double ends_share_flow = 0;      ///< the same of the oil flow at the middle section; NaN where that is 0 [-]
  double gap_leakage_low_end = 0, gap_leakage_high_end = 0;  ///< of it, through y = 0 and y = length [kg/s]
  double oil_flow_without_ends = 0;  ///< at the middle section, if all were like the strip opposite the gap [kg/s]
  /// Load [N] and total friction [N] likewise: what the shares over the cycle are made of; in no file.
  double load_without_ends = 0, friction_without_ends = 0;
};

/// A quantity over crank angle of an unrolled film and where `UnrolledSample` has it.
struct UnrolledQuantity : Quantity {
  double UnrolledSample::*value;
};
/// In the order of their CSV columns.
const std::vector<UnrolledQuantity>& unrolled_quantities();

/// What the ends of the gap do over a cycle, in the order of `unrolled_cycle_quantities()`.
struct UnrolledValues {
  double mean_gap_leakage = 0, mean_absolute_gap_leakage = 0;  ///< [kg/s]
  double peak_gap_leakage = 0;                                 ///< largest either way, with its sign [kg/s]
  double peak_gap_leakage_angle = 0;                           ///< [degree]
  double gap_leakage_share = 0;          ///< mean absolute leakage over mean absolute flow at the middle section [-]
  double ends_share_mean_load = 0;       ///< [-]
  double ends_share_friction_power = 0;  ///< of the mean [-]
  double ends_share_absolute_flow = 0;   ///< of the mean at the middle section [-]
};

/// A value of the cycle of an unrolled film and where `UnrolledValues` has it.
struct UnrolledCycleQuantity : Quantity {
  double UnrolledValues::*value;
};
const std::vector<UnrolledCycleQuantity>& unrolled_cycle_quantities();  ///< in the order of files and tables

/// Fields of the unrolled film at some crank angles: x from the chamber edge, y from one end of the gap around to the
/// other, or from the joint of a closed ring. In full over [angle][y][x], or reduced along the face to [angle][y];
/// what was not asked for is empty.
struct UnrolledFields {
  double circumference = 0;              ///< pi x bore [m]
  double end_gap = 0;                    ///< between y = length and y = 0 [m]; 0: a closed ring
  double gap_position = 0;               ///< of the middle of the gap around the bore [rad]
  std::vector<double> x, y;              ///< [m]
  std::vector<double> crank_angle_deg;   ///< may be empty
  std::vector<float> film_thickness;     ///< [m], [angle][y][x]
  std::vector<float> film_pressure;      ///< [Pa] absolute
  std::vector<float> fill;               ///< theta, liquid share of the gap [-]
  std::vector<float> asperity_pressure;  ///< [Pa]
  std::vector<float> strip_hydrodynamic_load, strip_asperity_load;  ///< per length in y [N/m], [angle][y]
  std::vector<float> strip_peak_film_pressure;                      ///< [Pa] absolute
  std::vector<float> strip_cavitated_fraction;                      ///< share of the width [-]
  std::vector<float> strip_min_film_thickness;                      ///< [m]
  std::vector<float> strip_oil_flow_middle;  ///< positive to the crankcase, per length in y [kg/(m s)]

  bool empty() const { return crank_angle_deg.empty(); }  ///< no angle was asked for
  /// Does it belong to a film across the face, which has nothing of it?
  bool is_absent() const { return y.empty(); }
};

/// A field of an unrolled film and where `UnrolledFields` has it.
struct UnrolledField : Quantity {
  std::vector<float> UnrolledFields::*values;
};
/// Fields over (crank_angle, y, x), then those over (crank_angle, y).
const std::vector<UnrolledField>& unrolled_fields();
const std::vector<UnrolledField>& strip_fields();  ///< those reduced along the face

/// Where on the stroke asperities rub: contact work per liner length over one cycle.
struct StrokeProfile {
  std::vector<double> liner_position;      ///< distance below the ring's TDC position, bin centres [m]
  std::vector<double> wear_drive_density;  ///< contact work per length of liner [J/m] (= N summed over the passes)
};

/// Something the user must know about this result: a law outside its range, a remedy that was used.
struct Note {
  std::string topic;    ///< short, stable word, e.g. "density-extrapolated"
  std::string message;  ///< a sentence with figures and units
  long count = 1;       ///< crank steps or evaluations concerned
};

/// What the march cost, and how well it kept its tolerances.
struct Effort {
  double cycles_marched = 0;     ///< until periodic
  double periodicity_error = 0;  ///< largest relative difference of the state one cycle apart [-]
  long crank_steps = 0, newton_iterations = 0, sub_steps = 0;
  long fallback_secant = 0, fallback_sub_step = 0;
  double max_load_residual = 0;  ///< |W_h + W_a - W|/W [-]
  double max_newton_step = 0;    ///< last relative Newton step accepted, worst of the cycle [-]
  double max_mass_residual =
      0;                       ///< worst mass balance of a step, relative to the largest flow at the middle section [-]
  long relaxation_sweeps = 0;  ///< of solver.method = "point-relaxation"
};

/// All that a march gives. Plain data: what files, pages and other programs are made of.
struct CycleResult {
  std::vector<Sample> samples;  ///< at the crank angles asked for
  CycleValues values;           ///< from the whole march, whatever was asked for
  FaceFields fields;
  std::vector<UnrolledSample> unrolled_samples;  ///< beside `samples`; empty without an unrolled film
  UnrolledValues unrolled_values;                ///< NaN where the march stopped
  UnrolledFields unrolled;                       ///< without an unrolled film not even y
  StrokeProfile stroke;
  std::map<std::string, double> derived;  ///< composite_modulus, elastic_pressure, ... [SI]; see derived_quantities()
  std::vector<Note> notes;
  Effort effort;
  bool complete = true;  ///< false: the march stopped; `samples` are those that it had passed
};

/// Constants that follow from the case before anything is marched (keys of CycleResult::derived).
const std::vector<Quantity>& derived_quantities();

}  // namespace ringfilm::cycle
