#include "ringfilm/cycle/integration/side_by_side.hpp"

#include <algorithm>
#include <bit>
#include <deque>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "ringfilm/film/reynolds.hpp"
#include "ringfilm/film/solver/lane_newton.hpp"

namespace ringfilm::cycle {
namespace {

using Owned = std::unique_ptr<BatchMember>;

/// Largest number of integrations that wait for a lane of their kind.
constexpr std::size_t kMaxWaiting = 64;
/// Integrations of one kind may share a block, whose sweeps are as long as the longest film in it.
struct LaneKind {
  unsigned cells;  ///< room for so many: a power of two
  const film::FilmKernels* kernels;
  film::LaneLaws laws;
  film::LaneCavity cavity;
  film::Terms terms;
  friend auto operator<=>(const LaneKind&, const LaneKind&) = default;
};

LaneKind kind_of(const TimeIntegration& integration) {
  const film::FilmProblem& problem = integration.problem();
  return {std::bit_ceil(static_cast<unsigned>(problem.grid.n_cells())), problem.kernels,
          film::best_laws(integration.instant().at.inputs),
          problem.cavitation == film::Cavitation::kMassConserving ? film::LaneCavity::kFilmContent
                                                                  : film::LaneCavity::kMultiplier,
          problem.terms};
}

/// The lanes of one kind.
class Block {
 public:
  explicit Block(const LaneKind& kind)
      : newton_(*kind.kernels, kind.kernels->width, static_cast<int>(kind.cells)),
        laws_(kind.laws),
        integrations_(kind.kernels->width) {}

  bool has_free_lane() const { return n_busy_ < newton_.width(); }
  bool is_empty() const { return n_busy_ == 0; }

  void take(Owned integration) {
    const auto lane =
        static_cast<int>(std::find(integrations_.begin(), integrations_.end(), nullptr) - integrations_.begin());
    integrations_[lane] = std::move(integration);
    ++n_busy_;
    newton_.bind(lane, integrations_[lane]->integration().problem());
    propose(lane);
  }

  /// One iteration of all lanes; integrations that are done leave.
  void iterate(const std::function<void(Owned)>& finished, LaneEffort& effort) {
    newton_.iterate();
    ++effort.sweeps;
    effort.lane_sweeps += n_busy_;
    effort.node_sweeps += newton_.nodes_swept();
    for (int lane = 0; lane < newton_.width(); ++lane) {
      if (integrations_[lane] == nullptr || newton_.phase(lane) == film::LaneNewton::Phase::kRunning) continue;
      integrations_[lane]->conclude(find(lane, effort));
      if (!integrations_[lane]->done()) {
        propose(lane);
        continue;
      }
      newton_.clear(lane);
      --n_busy_;
      finished(std::exchange(integrations_[lane], nullptr));
    }
  }

 private:
  void propose(int lane) {
    TimeIntegration& integration = integrations_[lane]->integration();
    integration.propose();
    const film::FilmState& guess = integration.guess();
    newton_.start(lane, integration.proposed(), integration.remembered(), guess, guess.h_m,
                  film::Unknowns::kFilmAndSeparation, laws_);
  }

  /// The candidate as the lane leaves it, or found one by one where a lane is not enough.
  film::FilmReport find(int lane, LaneEffort& effort) {
    TimeIntegration& integration = integrations_[lane]->integration();
    const film::FilmProblem& problem = integration.problem();
    const film::FilmInputs& inputs = integration.proposed();
    if (integration.is_off_liner()) {  // the lane seeks films that carry
      ++effort.single_solves;
      return integration.solve();
    }
    film::FilmReport report;
    report.iterations = newton_.iterations(lane);
    report.last_step = newton_.last_step(lane);
    if (newton_.phase(lane) == film::LaneNewton::Phase::kSolved) {
      const double peak = newton_.peak_pressure(lane);
      const bool holds = laws_ == film::LaneLaws::kGiven ? !film::is_glass(*inputs.oil, inputs.p_cavitation, peak)
                                                         : peak <= inputs.oil->fit()->high;
      if (holds) {
        newton_.read(lane, integration.candidate());
        film::complete_state(problem, inputs, laws_, integration.candidate());
        report.converged = true;
        report.failure = film::Failure::kNone;
        return report;
      }
    }
    if (newton_.phase(lane) == film::LaneNewton::Phase::kFailed && inputs.fallback == film::Fallback::kNone) {
      return report;  // alone it would fail the same way
    }
    ++effort.single_solves;
    film::FilmReport alone = integration.solve();
    alone.iterations += report.iterations;
    return alone;
  }

  film::LaneNewton newton_;
  film::LaneLaws laws_;  ///< oil laws of all lanes
  std::vector<Owned> integrations_;
  int n_busy_ = 0;
};

}  // namespace

void integrate_alone(BatchMember& integrating, const std::function<void()>& pulse) {
  while (!integrating.done()) {
    integrating.integration().propose();
    integrating.conclude(integrating.integration().solve());
    if (pulse) pulse();
  }
}

LaneEffort integrate_side_by_side(const std::function<Owned()>& next, const std::function<void(Owned)>& finished,
                                  const std::function<void()>& pulse) {
  LaneEffort effort;
  std::map<LaneKind, Block> blocks;
  std::map<LaneKind, std::deque<Owned>> waiting;
  std::size_t n_waiting = 0;
  bool more = true;
  const auto fetch = [&] {
    Owned integration = next();
    more = integration != nullptr;
    if (!more) return;
    if (integration->done()) return finished(std::move(integration));
    if (!integration->integration().fits_a_lane()) {
      integrate_alone(*integration, pulse);
      return finished(std::move(integration));
    }
    const LaneKind kind = kind_of(integration->integration());
    Block& block = blocks.try_emplace(kind, kind).first->second;
    if (block.has_free_lane() && waiting[kind].empty()) return block.take(std::move(integration));
    waiting[kind].push_back(std::move(integration));
    ++n_waiting;
  };
  const auto refill = [&](const LaneKind& kind, Block& block) {
    auto& queue = waiting[kind];
    while (block.has_free_lane()) {
      if (!queue.empty()) {
        block.take(std::move(queue.front()));
        queue.pop_front();
        --n_waiting;
      } else if (more && n_waiting < kMaxWaiting) {
        fetch();
      } else {
        return;
      }
    }
  };
  while (more && blocks.empty()) fetch();
  while (!blocks.empty()) {
    for (auto at = blocks.begin(); at != blocks.end();) {
      refill(at->first, at->second);
      if (at->second.is_empty()) {
        at = blocks.erase(at);
      } else {
        at->second.iterate(finished, effort);
        if (pulse) pulse();
        ++at;
      }
    }
    while (more && blocks.empty()) fetch();
  }
  return effort;
}

}  // namespace ringfilm::cycle
