#include "computation.hpp"

#include <fmt/format.h>

#include <iterator>
#include <span>
#include <utility>

#include "progress.hpp"
#include "ringfilm/cycle/integration/setup.hpp"
#include "ringfilm/cycle/note_topics.hpp"
#include "ringfilm/cycle/simulate.hpp"
#include "ringfilm/film/kernels/kernels.hpp"
#include "ringfilm/io/result/result_document.hpp"

namespace ringfilm::app {
namespace {

/// The case itself, on one lane: its bits are the same whatever else is computed.
Computation integrated(const RunRequest& requested, ComputationWatch& watch) {
  const cycle::Case& input = requested.input;
  watch.begins(requested);
  Computation done;
  cycle::CycleResult result;
  try {
    result = cycle::simulate(cycle::prepare(input), &watch);
  } catch (const cycle::StoppedCycle& stop) {
    result = stop.result;
    result.complete = false;
    done.stopped = stop;
  }
  done.document = io::result_document(input, std::move(result));
  return done;
}

/// What is to be found out about one computation by further integrations, and where theirs are in the batch of all.
struct FollowUpRuns {
  study::LedgerPlan ledger;
  std::size_t n_other_grids = 0;

  bool is_empty() const { return n_other_grids == 0 && ledger.cases.empty(); }
};

/// Moves `cases` to the end of `all`. @returns how many
std::size_t append(std::vector<cycle::Case> cases, std::vector<cycle::Case>& all) {
  const std::size_t n = cases.size();
  std::move(cases.begin(), cases.end(), std::back_inserter(all));
  return n;
}

void add_errors(const RunRequest& requested, std::span<const study::Ending> ended, io::ResultDocument& document) {
  document.errors = study::error_estimate(requested.input, document.result, ended);
  const auto notes = study::notes_on(*document.errors);
  document.result.notes.insert(document.result.notes.end(), notes.begin(), notes.end());
  cycle::sort_notes(document.result.notes);
}

/// Prints the progress on a line.
class LineWatch : public ComputationWatch {
 public:
  void begins(const RunRequest& one) override { integration_.emplace(line_, one.name); }
  void advanced(int cycle, double crank_angle_deg) override { integration_->advanced(cycle, crank_angle_deg); }
  void others_ended(int n_done, int n_total) override {
    line_.show(fmt::format("{} of {} other grids and choices", n_done, n_total));
  }

 private:
  ProgressLine line_;
  std::optional<IntegrationProgress> integration_;
};

std::vector<Computation> of_single_rings(const std::vector<RunRequest>& requested, const study::BatchOptions& options,
                                         ComputationWatch& watch) {
  std::vector<Computation> all;
  for (const RunRequest& one : requested) all.push_back(integrated(one, watch));

  std::vector<cycle::Case> further;
  std::vector<FollowUpRuns> inquiries(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].stopped) continue;
    if (requested[i].errors == ErrorRequest::kEstimated) {
      inquiries[i].n_other_grids = append(study::other_grids(requested[i].input), further);
    }
    if (requested[i].ledger == LedgerRequest::kComputed) {
      inquiries[i].ledger = study::ledger_plan(requested[i].input);
      append(inquiries[i].ledger.cases, further);
    }
  }
  const auto reported = [&](int n_done, int n_total) { watch.others_ended(n_done, n_total); };
  const std::string others = fmt::format("; other grids and choices {} lanes", film::kernels().width);
  const std::vector<study::Ending> ended = study::endings(further, reported, options);

  std::span<const study::Ending> rest = ended;
  const auto taken = [&rest](std::size_t n) { return std::exchange(rest, rest.subspan(n)).first(n); };
  for (std::size_t i = 0; i < all.size(); ++i) {
    io::ResultDocument& document = all[i].document;
    if (inquiries[i].n_other_grids > 0) add_errors(requested[i], taken(inquiries[i].n_other_grids), document);
    if (!inquiries[i].is_empty()) document.provenance.kernels += others;
    document.ledger_computed = requested[i].ledger == LedgerRequest::kComputed && !all[i].stopped;
    if (document.ledger_computed) {
      const auto variants = taken(inquiries[i].ledger.cases.size());
      document.ledger = study::ledger(std::move(inquiries[i].ledger), variants, document.result.values);
    } else {
      document.ledger = study::assumptions(requested[i].input);
    }
  }
  return all;
}

/// The rings of a pack as requests of their own; of others the request as it is.
void append_rings(const RunRequest& requested, std::vector<RunRequest>& requests) {
  if (!requested.input.is_pack()) return requests.push_back(requested);
  for (std::size_t i = 0; i < requested.input.rings.size(); ++i) {
    requests.push_back(requested);
    requests.back().input = requested.input.rings[i];
    requests.back().name += fmt::format(", ring {}", i + 1);
  }
}

Computation pack_of(const std::string& title, std::vector<Computation> rings) {
  Computation pack;
  std::vector<io::ResultDocument> documents;
  for (std::size_t i = 0; i < rings.size(); ++i) {
    documents.push_back(std::move(rings[i].document));
    if (!rings[i].stopped || pack.stopped) continue;
    pack.stopped = ConvergenceError(fmt::format("ring {}: {}", i + 1, rings[i].stopped->what()),
                                    rings[i].stopped->crank_angle_deg());
  }
  pack.document = io::pack_document(title, std::move(documents));
  return pack;
}

}  // namespace

std::vector<Computation> computations(const std::vector<RunRequest>& requested, const study::BatchOptions& options) {
  LineWatch watch;
  return computations(requested, options, watch);
}

std::vector<Computation> computations(const std::vector<RunRequest>& requested, const study::BatchOptions& options,
                                      ComputationWatch& watch) {
  std::vector<RunRequest> requests;
  for (const RunRequest& one : requested) append_rings(one, requests);
  std::vector<Computation> singles = of_single_rings(requests, options, watch);
  std::vector<Computation> all;
  auto next = std::make_move_iterator(singles.begin());
  for (const RunRequest& one : requested) {
    const auto n = static_cast<std::ptrdiff_t>(one.input.rings.size());
    if (n == 0) {
      all.push_back(*next++);
    } else {
      all.push_back(pack_of(one.input.title, {next, next + n}));
      next += n;
    }
  }
  return all;
}

}  // namespace ringfilm::app
