#include "ringfilm/study/inverse/optimisation.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <utility>

#include "ringfilm/base/error.hpp"
#include "ringfilm/study/ensemble/threads.hpp"
#include "ringfilm/study/inverse/constrained_search.hpp"
#include "ringfilm/study/sampling/latin_hypercube.hpp"

namespace ringfilm::study {
namespace {

constexpr double kMargin = 1e-6;   // relative, by which searches stay within constraints, so that designs meet them
constexpr double kAtLimit = 1e-3;  // relative distance up to which a constraint binds
constexpr double kAtBound = 1e-4;  // place up to which a variable is at its bound
constexpr double kAugmentation = 1e-3;  // weight of the sum of the objectives beside their largest; assumed

/// A search from a start.
struct Task {
  std::size_t combination;
  std::vector<double> places;
};

class Optimiser {
 public:
  Optimiser(const Optimisation& problem, const DesignFunction& design, int threads)
      : problem_(problem), design_(design), threads_(threads) {}

  OptimisationResult run(const std::vector<double>& first_places) {
    const std::vector<Task> tasks = starts(first_places);
    look(tasks);
    const std::size_t n_objectives = problem_.objectives.size();
    std::vector<Design> anchors;
    for (std::size_t k = 0; k < n_objectives; ++k) anchors.push_back(best_of(k, tasks));
    if (!is_feasible(problem_, anchors.front())) {
      result_.nearest = anchors.front();
      return std::move(result_);
    }
    if (n_objectives == 1) {
      result_.best = anchors.front();
    } else {
      find_front(anchors);
    }
    describe_best();
    return std::move(result_);
  }

 private:
  std::vector<Task> starts(const std::vector<double>& first_places) const {
    const std::size_t n = problem_.variables.size(), n_starts = n == 0 ? 1 : std::max<std::size_t>(problem_.starts, 1);
    std::vector<Task> tasks;
    for (std::size_t c = 0; c < problem_.n_combinations(); ++c) {
      tasks.push_back({c, first_places});
      if (n_starts < 2) continue;
      const LatinHypercube spread(n_starts - 1, problem_.seed);
      for (std::size_t k = 0; k + 1 < n_starts; ++k) {
        Task task{c, {}};
        for (std::size_t j = 0; j < n; ++j) task.places.push_back(spread.share(k, j));
        tasks.push_back(std::move(task));
      }
    }
    return tasks;
  }

  /// Does work for each task on threads; the designs that it computes are kept in the order of the tasks.
  template <class Work>
  void for_each(const std::vector<Task>& tasks, const Work& work) {
    std::vector<std::vector<Design>> traces(tasks.size());
    std::atomic<std::size_t> next = 0;
    std::atomic<bool> has_ended = false;
    const int n = std::max(1, std::min(n_threads(threads_), static_cast<int>(tasks.size())));
    on_threads(n, [&](int) {
      try {
        for (std::size_t i = next++; i < tasks.size() && !has_ended; i = next++) work(tasks[i], traces[i]);
      } catch (...) {
        has_ended = true;
        throw;
      }
    });
    for (std::vector<Design>& trace : traces) {
      std::move(trace.begin(), trace.end(), std::back_inserter(result_.designs));
    }
  }

  Design computed(const Task& task, const std::vector<double>& places, std::vector<Design>& trace) const {
    trace.push_back(design_(task.combination, places));
    return trace.back();
  }

  /// Computes all starts, from which the sizes of objectives and constraints follow.
  void look(const std::vector<Task>& tasks) {
    for_each(tasks, [&](const Task& task, std::vector<Design>& trace) { computed(task, task.places, trace); });
    objective_sizes_.assign(problem_.objectives.size(), 0);
    constraint_sizes_.assign(problem_.constraints.size(), 0);
    bool is_solved = false;
    for (const Design& design : result_.designs) {
      if (!design.is_solved()) continue;
      is_solved = true;
      for (std::size_t k = 0; k < objective_sizes_.size(); ++k) {
        objective_sizes_[k] = std::max(objective_sizes_[k], std::abs(design.objectives[k]));
      }
      for (std::size_t k = 0; k < constraint_sizes_.size(); ++k) {
        constraint_sizes_[k] = std::max(constraint_sizes_[k], std::abs(design.constraints[k]));
      }
    }
    if (!is_solved) {
      throw ConvergenceError("no design has a solution at any of the " + std::to_string(result_.designs.size()) +
                             " starts; the first: " + result_.designs.front().reason);
    }
    for (double& size : objective_sizes_) size = size > 0 ? size : 1;
    for (double& size : constraint_sizes_) size = size > 0 ? size : 1;
  }

  /// An objective to be minimised, over its size.
  double objective(std::size_t k, const Design& design) const {
    const double sign = problem_.objectives[k].goal == Goal::kMinimise ? 1 : -1;
    return sign * design.objectives[k] / objective_sizes_[k];
  }

  double excess_of(std::size_t k, const Design& design) const {
    return relative_excess(problem_.constraints[k], design.constraints[k], constraint_sizes_[k]);
  }

  /// The largest excess of all constraints; infinite without a solution.
  double worst_excess(const Design& design) const {
    if (!design.is_solved()) return std::numeric_limits<double>::infinity();
    double worst = -std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < problem_.constraints.size(); ++k) worst = std::max(worst, excess_of(k, design));
    return worst;
  }

  using Objectives = std::function<std::vector<double>(const Design&)>;

  /// Searches from all tasks. @param objectives to be minimised, the largest of them
  void search(const std::vector<Task>& tasks, const Objectives& objectives, bool with_constraints) {
    if (problem_.variables.empty()) return;
    SearchOptions options;
    options.max_evaluations = problem_.max_evaluations;
    for_each(tasks, [&](const Task& task, std::vector<Design>& trace) {
      const MeritFunction merit = [&](const std::vector<double>& places) -> std::optional<Merit> {
        const Design design = computed(task, places, trace);
        if (!design.is_solved()) return std::nullopt;
        Merit found{objectives(design), {}};
        for (std::size_t k = 0; with_constraints && k < problem_.constraints.size(); ++k) {
          found.constraints.push_back(excess_of(k, design) + kMargin);
        }
        return found;
      };
      search_from(task.places, merit, options);
    });
  }

  /// The feasible design with the lowest objective, or the one that is nearest to feasible.
  template <class Value>
  Design lowest(const Value& value) const {
    const auto is_better = [&](const Design& a, const Design& b) {
      const double excess_a = std::max(worst_excess(a), 0.), excess_b = std::max(worst_excess(b), 0.);
      if (excess_a != excess_b) return excess_a < excess_b;
      return a.is_solved() && value(a) < value(b);
    };
    return *std::min_element(result_.designs.begin(), result_.designs.end(), is_better);
  }

  Design best_of(std::size_t k, const std::vector<Task>& tasks) {
    const auto value = [&, k](const Design& design) { return objective(k, design); };
    const Objectives alone = [&](const Design& design) { return std::vector<double>{value(design)}; };
    search(tasks, alone, true);
    Design best = lowest(value);
    if (!is_feasible(problem_, best)) {
      // First to where the constraints are met, then on from there.
      search(
          {{best.combination, best.places}},
          [&](const Design& design) {
            std::vector<double> all;
            for (std::size_t i = 0; i < problem_.constraints.size(); ++i) all.push_back(excess_of(i, design));
            return all;
          },
          false);
      best = lowest(value);
      if (is_feasible(problem_, best)) search({{best.combination, best.places}}, alone, true);
      best = lowest(value);
    }
    return best;
  }

  /// Weighted Chebyshev problems between the anchors, eq-chebyshev.
  void find_front(const std::vector<Design>& anchors) {
    const std::size_t n = anchors.size();
    std::vector<double> ideal(n), range(n);
    for (std::size_t k = 0; k < n; ++k) {
      ideal[k] = objective(k, anchors[k]);
      double worst = ideal[k];
      for (const Design& anchor : anchors) worst = std::max(worst, objective(k, anchor));
      range[k] = worst > ideal[k] ? worst - ideal[k] : 1;
    }
    const auto part = [&](std::size_t k, const Design& design) { return (objective(k, design) - ideal[k]) / range[k]; };
    for (const std::vector<double>& weights : spread_weights(n, std::max(problem_.front_points, n + 1) - 1)) {
      const Objectives weighted = [&](const Design& design) {
        double sum = 0;
        for (std::size_t k = 0; k < n; ++k) sum += part(k, design);
        std::vector<double> all;
        for (std::size_t k = 0; k < n; ++k) all.push_back(weights[k] * part(k, design) + kAugmentation * sum);
        return all;
      };
      const auto largest = [&](const Design& design) {
        const std::vector<double> all = weighted(design);
        return *std::max_element(all.begin(), all.end());
      };
      const Design from = lowest(largest);
      search({{from.combination, from.places}}, weighted, true);
      result_.front.push_back(lowest(largest));
    }
    result_.front.insert(result_.front.end(), anchors.begin(), anchors.end());
    keep_non_dominated();
    result_.best = *std::min_element(result_.front.begin(), result_.front.end(), [&](const Design& a, const Design& b) {
      double far_a = 0, far_b = 0;
      for (std::size_t k = 0; k < n; ++k) {
        far_a += std::pow(part(k, a), 2);
        far_b += std::pow(part(k, b), 2);
      }
      return far_a < far_b;
    });
  }

  void keep_non_dominated() {
    std::vector<std::vector<double>> points;
    for (const Design& design : result_.front) {
      points.emplace_back();
      for (std::size_t k = 0; k < design.objectives.size(); ++k) points.back().push_back(objective(k, design));
    }
    std::vector<Design> kept;
    for (const std::size_t i : non_dominated(points)) kept.push_back(std::move(result_.front[i]));
    std::stable_sort(kept.begin(), kept.end(),
                     [](const Design& a, const Design& b) { return a.objectives.front() < b.objectives.front(); });
    result_.front = std::move(kept);
  }

  void describe_best() {
    for (std::size_t k = 0; k < problem_.constraints.size(); ++k) {
      if (excess_of(k, *result_.best) > -kAtLimit) result_.binding.push_back(k);
    }
    for (std::size_t j = 0; j < problem_.variables.size(); ++j) {
      const double place = result_.best->places[j];
      if (place > kAtBound && place < 1 - kAtBound) continue;
      result_.at_bounds.push_back(problem_.variables[j].name() + " at its " + (place < 0.5 ? "lower" : "upper") +
                                  " bound");
    }
  }

  const Optimisation& problem_;
  const DesignFunction& design_;
  int threads_;
  std::vector<double> objective_sizes_, constraint_sizes_;
  OptimisationResult result_;
};

}  // namespace

std::size_t Optimisation::n_combinations() const {
  std::size_t n = 1;
  for (const ChoiceVariable& choice : choices) n *= choice.texts.size();
  return n;
}

std::vector<std::size_t> Optimisation::combination(std::size_t i) const {
  std::vector<std::size_t> indices(choices.size());
  for (std::size_t k = choices.size(); k-- > 0;) {
    indices[k] = i % choices[k].texts.size();
    i /= choices[k].texts.size();
  }
  return indices;
}

double excess(const Constraint& constraint, double value) {
  return constraint.is_lower ? constraint.limit - value : value - constraint.limit;
}

double relative_excess(const Constraint& constraint, double value, double size) {
  return excess(constraint, value) / (constraint.limit != 0 ? std::abs(constraint.limit) : size);
}

bool is_feasible(const Optimisation& problem, const Design& design) {
  if (!design.is_solved()) return false;
  for (std::size_t k = 0; k < problem.constraints.size(); ++k) {
    if (!(excess(problem.constraints[k], design.constraints[k]) <= 0)) return false;
  }
  return true;
}

double over_points(OverPoints over, const std::vector<WeightedPoint>& points, const std::vector<double>& values) {
  if (over == OverPoints::kMin) return *std::min_element(values.begin(), values.end());
  if (over == OverPoints::kMax) return *std::max_element(values.begin(), values.end());
  double sum = 0, weights = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    sum += points[i].weight * values[i];
    weights += points[i].weight;
  }
  return sum / weights;
}

OptimisationResult optimise(const Optimisation& problem, const std::vector<double>& first_places,
                            const DesignFunction& design, int threads) {
  return Optimiser(problem, design, threads).run(first_places);
}

}  // namespace ringfilm::study
