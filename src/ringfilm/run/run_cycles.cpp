#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <span>
#include <utility>

#include "ringfilm/cycle/advice/note_topics.hpp"
#include "ringfilm/cycle/pack/gas_through_films.hpp"
#include "ringfilm/cycle/pack/oil_consumption.hpp"
#include "ringfilm/cycle/pack/rails_of_pack.hpp"
#include "ringfilm/cycle/pack/simulate_pack.hpp"
#include "ringfilm/film/kernels/kernels.hpp"
#include "ringfilm/io/result/result_document.hpp"
#include "ringfilm/run/run.hpp"
#include "ringfilm/study/ensemble/batch.hpp"
#include "ringfilm/study/ensemble/supply_slope.hpp"

namespace ringfilm::run {
namespace {

/// Integrations of other grids and choices know one ring by itself.
void refuse_inquiries(const Request& requested) {
  if (!requested.ledger && !requested.error_estimate) return;
  throw InputError(std::string("the rings of the pack share the oil on the liner (film.supply = \"film-on-liner\"), "
                               "and ") +
                       (requested.ledger ? "a ledger" : "an error estimate") + " computes each ring by itself",
                   "remove it, or compute one ring as [ring] or with film.supply = \"given\"");
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

void add_errors(const Request& requested, std::span<const study::Ending> ended, io::ResultDocument& document) {
  document.errors = study::error_estimate(requested.input, document.result, ended);
  const auto notes = study::notes_on(*document.errors);
  document.result.notes.insert(document.result.notes.end(), notes.begin(), notes.end());
  if (auto note = study::note_on_accuracy(requested.input, document.result, *document.errors)) {
    document.result.notes.push_back(std::move(*note));
  }
  cycle::sort_notes(document.result.notes);
}

/// A request among the rings of all.
struct RequestedRings {
  std::size_t n_rings = 0;           ///< number of rings of the pack, each rail of an oil ring by itself; 0: one ring
  std::vector<std::size_t> rails;    ///< cycle::rail_number of each ring of the pack
  std::vector<std::string> labels;   ///< cycle::ring_label likewise
  std::optional<io::PackGas> gas{};  ///< where it is computed
  std::vector<cycle::OilLoss> oil_losses{};  ///< losses of the pack, where the oil on the liner is followed
};

/// The rings of all requests, integrated.
struct Rings {
  std::vector<Request> requests;
  std::vector<CycleOutcome> outcomes;  ///< one for each
  std::vector<RequestedRings> of_request;
};

/// Runs of other grids and choices for all rings in one batch.
void add_inquiries(Rings& rings, int threads, Observer* observer) {
  const std::vector<Request>& requested = rings.requests;
  std::vector<CycleOutcome>& all = rings.outcomes;
  std::vector<cycle::Case> further;
  std::vector<FollowUpRuns> inquiries(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].stopped) continue;
    if (requested[i].error_estimate) {
      inquiries[i].n_other_grids = append(study::other_grids(requested[i].input), further);
    }
    if (requested[i].ledger) {
      inquiries[i].ledger = study::ledger_plan(requested[i].input);
      append(inquiries[i].ledger.cases, further);
    }
  }
  const auto reported = [&](int n_done, int n_total) {
    if (observer != nullptr) observer->others_ended(n_done, n_total);
  };
  const std::string others = fmt::format("; other grids and choices {} lanes", film::kernels().width);
  const std::vector<study::Ending> ended = study::endings(further, reported, {threads});

  std::span<const study::Ending> rest = ended;
  const auto taken = [&rest](std::size_t n) { return std::exchange(rest, rest.subspan(n)).first(n); };
  for (std::size_t i = 0; i < all.size(); ++i) {
    io::ResultDocument& document = all[i].document;
    if (inquiries[i].n_other_grids > 0) add_errors(requested[i], taken(inquiries[i].n_other_grids), document);
    if (!inquiries[i].is_empty()) document.provenance.kernels += others;
    document.ledger_computed = requested[i].ledger && !all[i].stopped;
    if (document.ledger_computed) {
      const auto variants = taken(inquiries[i].ledger.cases.size());
      document.ledger = study::ledger(std::move(inquiries[i].ledger), variants, document.result.values);
    } else if (!all[i].input) {
      document.ledger = study::assumptions(requested[i].input);
    }
  }
}

/// Of a pack or of one ring; empty where a ring stopped.
std::vector<cycle::OilLoss> oil_losses_of(const cycle::CaseWithGas& found,
                                          const std::vector<cycle::RingOutcome>& outcomes) {
  std::vector<const cycle::CycleResult*> results;
  for (const cycle::RingOutcome& outcome : outcomes) results.push_back(&outcome.result);
  return cycle::oil_losses(found.input, results, found.gas);
}

/// Integrates a case: alone or in its pack its bits are the same whatever else is computed.
void integrate(const Request& requested, Rings& rings, Observer* observer) {
  cycle::Case faces = cycle::with_rails(requested.input);
  const bool are_together = cycle::shares_oil(faces);
  if (observer != nullptr) observer->begins(requested.name);
  cycle::CaseWithGas found = cycle::solve_gas_through_films(std::move(faces), observer);
  RequestedRings& of = rings.of_request.emplace_back();
  if (found.gas) {
    of.gas = io::pack_gas(*found.gas, found.input.gas_path.gas_constant, found.input.engine.cylinders);
  }
  of.n_rings = found.input.rings.size();
  for (std::size_t i = 0; i < of.n_rings; ++i) {
    of.rails.push_back(cycle::rail_number(requested.input, i));
    of.labels.push_back(cycle::ring_label(requested.input, i));
  }
  const auto ring_begins = [&](std::size_t i) {
    if (observer != nullptr && of.n_rings > 0) observer->begins(requested.name + ", ring " + of.labels[i]);
  };
  std::vector<cycle::RingOutcome> outcomes =
      cycle::simulate_rings(found.input, observer, cycle::AtStop::kContinue, ring_begins);
  of.oil_losses = oil_losses_of(found, outcomes);
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    Request& ring = rings.requests.emplace_back(requested);
    ring.input = found.input.is_pack() ? std::move(found.input.rings[i]) : std::move(found.input);
    if (requested.accuracy_estimate && !are_together && ring.input.solver.accuracy) ring.error_estimate = true;
    CycleOutcome& done = rings.outcomes.emplace_back();
    if (requested.accuracy_estimate && of.n_rings == 0 && !outcomes[i].stop) {
      study::add_supply_note(ring.input, outcomes[i].result);
    }
    if (outcomes[i].stop) done.stopped = ConvergenceError(outcomes[i].stop->message, outcomes[i].stop->crank_angle_deg);
    if (requested.describe || of.n_rings > 0) {
      done.document = io::result_document(ring.input, std::move(outcomes[i].result));
    } else {
      done.document.result = std::move(outcomes[i].result);
      done.document.provenance = io::this_run();
      done.input = ring.input;
    }
    if (of.n_rings == 0) done.document.oil_losses = of.oil_losses;
  }
}

CycleOutcome pack_of(const std::string& title, std::vector<CycleOutcome> rings, RequestedRings of) {
  CycleOutcome pack;
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
  pack.document.oil_losses = std::move(of.oil_losses);
  return pack;
}

}  // namespace

std::vector<CycleOutcome> run_cycles(const std::vector<Request>& requested, int threads, Observer* observer) {
  for (const Request& one : requested) {
    if (cycle::shares_oil(cycle::with_rails(one.input))) refuse_inquiries(one);
  }
  Rings rings;
  for (const Request& one : requested) integrate(one, rings, observer);
  add_inquiries(rings, threads, observer);
  std::vector<CycleOutcome> all;
  auto next = std::make_move_iterator(rings.outcomes.begin());
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

}  // namespace ringfilm::run
