#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "ringfilm/study/measurement.hpp"
#include "ringfilm/study/verification/contact_form.hpp"
#include "ringfilm/study/verification/dry_wear.hpp"
#include "ringfilm/study/verification/evaporation_form.hpp"

/// Runs with known answers, the checks on them and what came of each. docs/manual/verification.md.
namespace ringfilm::study {

/// How far a number may be from the known one. Exactly one of the two is meant.
struct Tolerance {
  enum class Kind { kRelative, kAbsolute };
  Kind kind = Kind::kRelative;
  double value = 0;  ///< [-] or [unit of the quantity]
};

/// What every check carries.
struct Check {
  std::string label;    ///< label, unique within the verification, e.g. "load at K = 1"
  std::string source;   ///< where the known number is from: page, equation, or the derivation in the README
  std::string because;  ///< why the tolerance is what it is
};

/// A number of one run.
struct ValueCheck : Check {
  std::string run;  ///< key of Verification::runs
  Probe probe;
  double expected = 0;  ///< [SI]
  Tolerance tolerance;
};

enum class Refinement { kCells, kTimeStep };

/// How fast the error of a number falls as the run is refined.
struct OrderCheck : Check {
  std::string run;           ///< key of Verification::runs, or empty
  std::string manufactured;  ///< one of manufactured_films(), where there is no run
  Probe probe;
  double exact = 0;  ///< [SI]
  Refinement refinement = Refinement::kCells;
  std::vector<double> levels;  ///< numbers of cells, or time steps [s] (steps of the integration, if manufactured)
  std::optional<int> cells;    ///< held while time is refined; nothing: as in the run, and a must if manufactured
  double order = 0;            ///< expected slope of the error [-]
  double tolerance = 0;        ///< tolerance of the order [-]
};

/// How far a place may be off on any of many grids, counted in their cells. The error of a front scatters with where in
/// its cell it lies, so that a slope through some levels would depend on the choice of levels.
struct BoundCheck : Check {
  std::string run;
  Probe probe;                           ///< number to compare, a length
  double exact = 0;                      ///< [m]
  int fewest_cells = 0, most_cells = 0;  ///< every number from the one to the other is run
  double most = 0;                       ///< largest error allowed [cells]
};

/// Where a number is largest among runs that differ in one parameter: the vertex of the parabola through three.
struct OptimumCheck : Check {
  std::vector<std::string> runs;   ///< three
  std::vector<double> parameters;  ///< one each, increasing [-]
  Probe probe;
  double expected = 0;  ///< parameter of the largest [-]
  Tolerance tolerance;
};

/// Around a dead centre, where a film is momentary.
struct DeadCentreZone {
  double reach_deg = 0;  ///< to either side [degree]
  double tolerance = 0;  ///< wider than elsewhere, of the same kind
};

/// A profile that wears without oil.
struct WearCheck : Check {
  DryWear profile;
  std::string quantity;  ///< one of dry_wear_quantities()
  double expected = 0;   ///< [SI]
  Tolerance tolerance;
};

/// A surface in contact, or the flow between two: a number, or how fast its error falls with the step.
struct ContactCheck : Check {
  ContactForm form;
  std::string quantity;        ///< one of contact_form_quantities()
  double expected = 0;         ///< [-]
  Tolerance tolerance;         ///< tolerance of the number, or of the order
  std::vector<double> levels;  ///< numbers of points; empty: the number itself
  double order = 0;            ///< expected slope of the error; with levels [-]
};

/// Oil that evaporates, or the transfer of heat that carries it away.
struct EvaporationCheck : Check {
  EvaporationForm form;
  std::string quantity;  ///< one of evaporation_quantities()
  double expected = 0;   ///< [SI]
  Tolerance tolerance;
};

/// A curve of a ring over crank angle.
struct CurveCheck : Check {
  std::string run;
  std::string quantity;                 ///< name of a curve that find_curve() returns
  std::vector<double> crank_angle_deg;  ///< [degree]
  std::vector<double> expected;         ///< [SI]
  Tolerance tolerance;                  ///< relative to the value at each angle, or absolute
  std::optional<DeadCentreZone> dead_centre_zone;
};

/// One folder of verification/.
struct Verification {
  std::string name;   ///< name of the folder
  std::string title;  ///< heading of its README
  std::string claim;  ///< first paragraph of its README
  std::map<std::string, cycle::Case> runs;
  std::vector<ValueCheck> values;
  std::vector<OrderCheck> orders;
  std::vector<BoundCheck> bounds;
  std::vector<OptimumCheck> optima;
  std::vector<CurveCheck> curves;
  std::vector<WearCheck> wear;
  std::vector<ContactCheck> contact;
  std::vector<EvaporationCheck> evaporation;
};

enum class Verdict { kHolds, kFails };

/// One line of the table.
struct VerificationRow {
  std::string label, quantity;  ///< quantity: as in the glossary, or e.g. "order in cells"
  std::string unit, display_unit;
  double expected = 0, got = 0;
  double error = 0;  ///< in the kind of the tolerance
  Tolerance tolerance;
  Verdict verdict = Verdict::kFails;
  std::string source, because;
};

/// The error of one number on a ladder of refinements, to be drawn.
struct ConvergenceLine {
  std::string label;
  Refinement refinement = Refinement::kCells;
  std::string step_unit;       ///< "s", or empty where steps are counted as a share
  std::vector<double> levels;  ///< one over the number of cells or steps, or steps in time [s]
  std::vector<double> errors;  ///< relative to the known number; as it is where that is zero [-]
  double expected_order = 0;
  std::optional<double> observed_order;  ///< nothing where the errors are held below a bound
  std::optional<double> bound;           ///< largest error allowed over level to the expected order
};

struct VerificationOutcome {
  std::string name, title, claim;
  std::vector<VerificationRow> rows;
  std::vector<ConvergenceLine> lines;
  std::vector<std::string> stops;  ///< runs that found no solution; their rows fail

  Verdict verdict() const;
};

/// Something that a verification would need and this program cannot compute.
struct NotCovered {
  std::string what, reason;
};

/// Runs what the checks need, each run once. Same verification, same bits.
VerificationOutcome verify(const Verification& verification);

}  // namespace ringfilm::study
