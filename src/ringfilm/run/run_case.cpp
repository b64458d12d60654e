#include <utility>

#include "ringfilm/cycle/pack/gas_of_pack.hpp"
#include "ringfilm/gas_path/solve_gas_path.hpp"
#include "ringfilm/io/case/case_file.hpp"
#include "ringfilm/run/run.hpp"

namespace ringfilm::run {
namespace {

bool is_of_rings(const cycle::Case& c) {
  return c.problem == cycle::Problem::kCycle && c.purpose != cycle::CasePurpose::kGasPath;
}

io::PadDocument pad_document(const cycle::Case& c, pad::PadResult result) {
  return {c.title, io::case_entries(c), c.notes, io::this_run(), std::move(result)};
}

Outcome pad_outcome(const cycle::Case& c, Observer* observer, const std::string& name) {
  if (observer != nullptr) observer->begins(name);
  try {
    return {pad_document(c, pad::solve_pad(c, observer)), std::nullopt, std::nullopt};
  } catch (const pad::StoppedPad& stop) {
    return {pad_document(c, stop.result), stop, std::nullopt};
  }
}

io::GasPathDocument gas_outcome(const cycle::Case& c) {
  const gas_path::Pack pack = cycle::gas_pack(c);
  return io::gas_path_document(c, pack, gas_path::solve_gas_path(pack, cycle::given_pressures(c)));
}

}  // namespace

void check_options(const cycle::Case& c, const Options& options, const OptionNames& names) {
  if (is_of_rings(c)) return;
  std::vector<Fault> faults;
  if (options.ledger) {
    faults.push_back(
        {{}, names.ledger + " is for rings: other problems have no assumptions that could be lifted", "remove it"});
  }
  if (options.error_estimate) {
    faults.push_back({{},
                      names.error_estimate + " is for rings: the errors of other problems are not estimated",
                      "remove it, and run the case with twice the cells to see what changes"});
  }
  if (!faults.empty()) throw InputError(std::move(faults));
}

Outcome run_case(const cycle::Case& c, const Options& options, Observer* observer, const std::string& name) {
  if (is_of_rings(c)) {
    const Request request{c, name, options.ledger, options.error_estimate, options.describe, options.accuracy_estimate};
    CycleOutcome cycle = std::move(run_cycles({request}, options.threads, observer).front());
    return {std::move(cycle.document), std::move(cycle.stopped), std::move(cycle.input)};
  }
  check_options(c, options);
  if (c.problem == cycle::Problem::kPad) return pad_outcome(c, observer, name);
  if (c.problem == cycle::Problem::kClosure) return {cycle::static_closure(c), std::nullopt, std::nullopt};
  return {gas_outcome(c), std::nullopt, std::nullopt};
}

}  // namespace ringfilm::run
