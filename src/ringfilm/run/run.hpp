#pragma once
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "ringfilm/base/error.hpp"
#include "ringfilm/case/case.hpp"
#include "ringfilm/cycle/closure/static_closure.hpp"
#include "ringfilm/cycle/simulate.hpp"
#include "ringfilm/io/gas_path/gas_path_output.hpp"
#include "ringfilm/io/pad/pad_output.hpp"
#include "ringfilm/io/result/result_file.hpp"
#include "ringfilm/pad/solve_pad.hpp"

/// The driver of all problems that a case can state. Program and Python module compute with it alone; a life over many
/// cycles is life::run_life, a study study::run_study.
namespace ringfilm::run {

/// What a run is to find out beside the result itself; of rings alone.
struct Options {
  bool ledger = false;          ///< the other choice for every assumption that can be lifted
  bool error_estimate = false;  ///< other grids
  /// Are the other grids computed all the same where solver.accuracy is stated? Who computes one case after the other
  /// asks for it of the last.
  bool accuracy_estimate = true;
  int threads = 0;  ///< for both; 0: as many as the machine runs at once
  /// Does the document of one ring describe its case: inputs, contact curves, assumptions? That takes as long as a
  /// cycle. Else Outcome::input has it, for io::result_document.
  bool describe = true;
};

/// How errors name the options of rings: as members, or as a program has them.
struct OptionNames {
  std::string ledger = "ledger";                  ///< Options::ledger
  std::string error_estimate = "error_estimate";  ///< Options::error_estimate
};

/// Throws InputError for options of rings where the case is another problem, or its gas alone.
void check_options(const cycle::Case& c, const Options& options, const OptionNames& names = {});

/// Receives how far a run is; may be slow; what it throws ends the work.
class Observer : public cycle::Observer, public pad::Observer {
 public:
  virtual void begins(const std::string& name) = 0;        ///< the integration of this case or ring
  virtual void others_ended(int n_done, int n_total) = 0;  ///< other grids and choices; never twice at a time
};

/// A case of one ring or of a ring pack, with what is to be known of it.
struct Request {
  cycle::Case input;              ///< a cycle, not a pad, a closure or gas alone
  std::string name;               ///< for the progress
  bool ledger = false;            ///< as in Options
  bool error_estimate = false;    ///< as in Options
  bool describe = true;           ///< as in Options
  bool accuracy_estimate = true;  ///< as in Options
};

/// One engine cycle, and why its integration stopped early if it did; the document then holds all up to there.
struct CycleOutcome {
  io::ResultDocument document;              ///< the result, of a pack with its rings
  std::optional<ConvergenceError> stopped;  ///< why the integration stopped early
  std::optional<cycle::Case> input;         ///< case of one ring with its gas, where the document does not describe it
};

/// Integrates each case, then all that ledgers and error estimates require in one batch. A pack is computed with its
/// gas, through films where the case has it so, each rail of an oil ring by itself, and together where its rings share
/// the oil on the liner. Same case, same bits. Throws InputError.
std::vector<CycleOutcome> run_cycles(const std::vector<Request>& requested, int threads = 0,
                                     Observer* observer = nullptr);

/// The result of a case, by Case::problem and Case::purpose: an engine cycle, a pad, the gas of a pack alone, a ring
/// in its bore.
using Result = std::variant<io::ResultDocument, io::PadDocument, io::GasPathDocument, cycle::StaticClosure>;

/// What run_case() found, and why it stopped early if it did.
struct Outcome {
  Result result;                            ///< what was found; where a cycle or a pad stopped, all up to there
  std::optional<ConvergenceError> stopped;  ///< why it did
  std::optional<cycle::Case> input;         ///< as in CycleOutcome
};

/// Computes a case, whatever its problem. Same case, same bits.
/// @param name of the case, for the progress
/// Throws InputError: a rule broken, or options for rings with another problem; ConvergenceError where there is nothing
/// to return.
Outcome run_case(const cycle::Case& c, const Options& options = {}, Observer* observer = nullptr,
                 const std::string& name = "");

}  // namespace ringfilm::run
