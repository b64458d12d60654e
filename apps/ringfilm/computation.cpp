#include "computation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <span>
#include <utility>

#include "progress.hpp"
#include "ringfilm/cycle/checks/note_topics.hpp"
#include "ringfilm/cycle/pack/gas_through_films.hpp"
#include "ringfilm/cycle/pack/rails_of_pack.hpp"
#include "ringfilm/cycle/pack/simulate_pack.hpp"
#include "ringfilm/cycle/setup/setup.hpp"
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

/// The rings of a pack that share the oil on the liner, together.
std::vector<Computation> integrated_together(std::span<const RunRequest> rings, ComputationWatch& watch) {
  watch.begins(rings.front());
  std::vector<cycle::Setup> setups;
  for (const RunRequest& ring : rings) setups.push_back(cycle::prepare(ring.input));
  std::vector<Computation> all;
  for (cycle::RingOutcome& outcome : cycle::simulate_pack(std::move(setups), &watch)) {
    Computation done;
    if (outcome.stop) done.stopped = ConvergenceError(outcome.stop->message, outcome.stop->crank_angle_deg);
    done.document = io::result_document(rings[all.size()].input, std::move(outcome.result));
    all.push_back(std::move(done));
  }
  return all;
}

/// Integrations of other grids and choices know one ring by itself.
void refuse_inquiries(const RunRequest& requested) {
  const bool ledger = requested.ledger == LedgerRequest::kComputed;
  if (!ledger && requested.errors == ErrorRequest::kNone) return;
  throw InputError(std::string("the rings of the pack share the oil on the liner (film.supply = \"film-on-liner\"), "
                               "and ") +
                       (ledger ? "a ledger" : "an error estimate") + " computes each ring by itself",
                   "leave it out, or compute one ring as [ring] or with film.supply = \"given\"");
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
  if (auto note = study::note_on_accuracy(requested.input, document.result, *document.errors)) {
    document.result.notes.push_back(std::move(*note));
  }
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

/// A request among the rings of all.
struct RequestedRings {
  std::size_t n_rings = 0;           ///< of the pack, each rail of an oil ring by itself; 0: one ring
  std::vector<std::size_t> rails;    ///< cycle::rail_number of each ring of the pack
  std::vector<std::string> labels;   ///< cycle::ring_label likewise
  std::optional<io::PackGas> gas{};  ///< where it is computed
};

/// The rings of all requests: to be integrated one by one, or several together.
struct Rings {
  std::vector<RunRequest> requests;
  std::vector<std::size_t> together;  ///< sizes of the groups that follow one another in `requests`
  std::vector<RequestedRings> of_request;
};

std::vector<Computation> of_rings(const Rings& rings, const study::BatchOptions& options, ComputationWatch& watch) {
  const std::vector<RunRequest>& requested = rings.requests;
  std::vector<Computation> all;
  for (const std::size_t n : rings.together) {
    const std::span<const RunRequest> group(requested.data() + all.size(), n);
    if (n == 1) {
      all.push_back(integrated(group.front(), watch));
    } else {
      std::ranges::move(integrated_together(group, watch), std::back_inserter(all));
    }
  }

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

/// A result that was to reach an accuracy reports which it has reached.
void estimate_where_asked(RunRequest& ring) {
  if (ring.input.solver.accuracy) ring.errors = ErrorRequest::kEstimated;
}

/// The rings of a pack as requests of their own; of others the request as it is.
void append_rings(const RunRequest& requested, Rings& rings, ComputationWatch& watch) {
  if (requested.input.gas_path.passes_films()) watch.begins(requested);
  cycle::CaseWithGas pack = cycle::solve_gas_through_films(cycle::with_rails(requested.input), &watch);
  const std::size_t n = pack.input.rings.size();
  RequestedRings& of = rings.of_request.emplace_back(RequestedRings{n, {}, {}});
  if (pack.gas) of.gas = io::pack_gas(*pack.gas, pack.input.gas_path.gas_constant);
  if (n == 0) {
    rings.requests.push_back(requested);
    rings.requests.back().input = std::move(pack.input);
    estimate_where_asked(rings.requests.back());
    rings.together.push_back(1);
    return;
  }
  for (std::size_t i = 0; i < n; ++i) {
    of.rails.push_back(cycle::rail_number(requested.input, i));
    of.labels.push_back(cycle::ring_label(requested.input, i));
    rings.requests.push_back(requested);
    rings.requests.back().input = pack.input.rings[i];
    rings.requests.back().name += ", ring " + cycle::ring_label(requested.input, i);
  }
  if (cycle::shares_oil(pack.input)) {
    refuse_inquiries(requested);
    rings.together.push_back(n);
  } else {
    for (RunRequest& ring : std::span(rings.requests).last(n)) estimate_where_asked(ring);
    rings.together.insert(rings.together.end(), n, 1);
  }
}

Computation pack_of(const std::string& title, std::vector<Computation> rings, RequestedRings of) {
  Computation pack;
  std::vector<io::ResultDocument> documents;
  for (std::size_t i = 0; i < rings.size(); ++i) {
    documents.push_back(std::move(rings[i].document));
    documents.back().rail = static_cast<long>(of.rails[i]);
    if (!rings[i].stopped || pack.stopped) continue;
    pack.stopped = ConvergenceError(fmt::format("ring {}: {}", of.labels[i], rings[i].stopped->what()),
                                    rings[i].stopped->crank_angle_deg());
  }
  pack.document = io::pack_document(title, std::move(documents));
  pack.document.gas = std::move(of.gas);
  return pack;
}

}  // namespace

std::vector<Computation> computations(const std::vector<RunRequest>& requested, const study::BatchOptions& options) {
  LineWatch watch;
  return computations(requested, options, watch);
}

std::vector<Computation> computations(const std::vector<RunRequest>& requested, const study::BatchOptions& options,
                                      ComputationWatch& watch) {
  Rings rings;
  for (const RunRequest& one : requested) append_rings(one, rings, watch);
  std::vector<Computation> singles = of_rings(rings, options, watch);
  std::vector<Computation> all;
  auto next = std::make_move_iterator(singles.begin());
  for (std::size_t i = 0; i < requested.size(); ++i) {
    RequestedRings& of = rings.of_request[i];
    const auto n = static_cast<std::ptrdiff_t>(of.n_rings);
    if (n == 0) {
      all.push_back(*next++);
    } else {
      all.push_back(pack_of(requested[i].input.title, {next, next + n}, std::move(of)));
      next += n;
    }
  }
  return all;
}

}  // namespace ringfilm::app
