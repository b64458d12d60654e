#include "ringfilm/life/wear_integration.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "ringfilm/base/display.hpp"
#include "ringfilm/base/error.hpp"

namespace ringfilm::life {
namespace {

/// A jump below this share of the one that the depth allows makes no progress.
constexpr double kMinJump = 1e-6;
/// A jump that was too long for what else changes is taken again with this share of its length.
constexpr double kShortened = 0.7;
/// The next jump is at most this much longer than the last one.
constexpr double kGrowth = 2;
/// Aimed at below the allowed difference, so that few jumps are rejected.
constexpr double kCaution = 0.8;

/// A coating of which this many times would be lost before a reported time, with its wear spread evenly over the face,
/// does not last until then.
constexpr double kSurelyLost = 2;
/// Jumps through such a coating.
constexpr double kCoarseJumps = 100;

double largest(const std::vector<double>& values) {
  return values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
}

class Integration {
 public:
  Integration(const Wear& wear, double end, std::size_t n_face, std::size_t n_liner, const WearLoadOf& load,
              const WearLimits& limits)
      : wear_(wear), load_(load), limits_(limits), end_(end), next_(end) {
    now_.face.assign(n_face, 0.0);
    now_.liner.assign(n_liner, 0.0);
  }

  WearHistory run(const std::vector<double>& times) {
    WearHistory history;
    for (const double time : times) {
      const WornDepths there = wear_.jumps ? at_equal_jumps(time) : at_chosen_jumps(time);
      if (worn_through_) break;
      history.states.push_back(there);
    }
    history.effort = effort_;
    history.worn_through = worn_through_;
    return history;
  }

 private:
  struct Jump {
    WornDepths end;
    double stage_difference = 0;
    bool lacks_last_stage = false;
  };

  /// Depths after a jump with the present load, which must be known.
  WornDepths first_stage(double time) const {
    const double K = coefficient_integral(wear_, now_.time, time);
    WornDepths end{time, now_.face, worn_liner(time, *load_now_, *load_now_)};
    for (std::size_t i = 0; i < now_.face.size(); ++i) end.face[i] += K * load_now_->face[i];
    return end;
  }

  /// From the present depths over a time that may not be kept.
  Jump jump_to(double time) {
    if (!load_now_) load_now_ = measured(now_);
    const double K = coefficient_integral(wear_, now_.time, time);
    Jump jump{first_stage(time), 0};
    WearLoad later = *load_now_;
    if (wear_.scheme == WearScheme::kHeun && time > now_.time) {
      const double share = share_of_coating(jump.end);
      later = later_load(share, jump);
      for (std::size_t i = 0; i < now_.face.size(); ++i) {
        const double depth = now_.face[i] + 0.5 * K * (load_now_->face[i] + later.face[i]);
        jump.stage_difference = std::max(jump.stage_difference, share * std::abs(depth - jump.end.face[i]));
        jump.end.face[i] = depth;
      }
    }
    jump.end.liner = worn_liner(time, *load_now_, later);
    return jump;
  }

  /// Depths of the liner after a jump with these loads at its ends.
  std::vector<double> worn_liner(double time, const WearLoad& from, const WearLoad& to) const {
    const double K = wear_.liner_coefficient.value_or(0) * (time - now_.time);
    std::vector<double> depth = now_.liner;
    for (std::size_t i = 0; i < depth.size(); ++i) depth[i] += 0.5 * K * (from.liner[i] + to.liner[i]);
    return depth;
  }

  /// How much of the way to an end the coating lasts, at most all of it.
  double share_of_coating(const WornDepths& end) const {
    if (!is_through(end)) return 1;
    const double before = largest(now_.face), after = largest(end.face);
    return after > before ? std::clamp((*limits_.deepest - before) / (after - before), 0.0, 1.0) : 1;
  }

  WornDepths on_the_way(const WornDepths& end, double share) const {
    if (share == 1) return end;
    const auto between = [share](double from, double to) { return from + share * (to - from); };
    WornDepths there{between(now_.time, end.time), now_.face, now_.liner};
    for (std::size_t i = 0; i < there.face.size(); ++i) there.face[i] = between(now_.face[i], end.face[i]);
    for (std::size_t i = 0; i < there.liner.size(); ++i) there.liner[i] = between(now_.liner[i], end.liner[i]);
    return there;
  }

  /// The load at the end of the first stage, or where it is as deep as the coating. A face that deep may have no cycle.
  WearLoad later_load(double share, Jump& jump) {
    const WornDepths there = on_the_way(jump.end, share);
    if (share == 1) return measured(there);
    try {
      return measured(there);
    } catch (const ConvergenceError&) {
      jump.lacks_last_stage = true;
      return *load_now_;
    }
  }

  bool is_through(const WornDepths& depths) const {
    return limits_.deepest && largest(depths.face) >= *limits_.deepest;
  }

  WearLoad measured(const WornDepths& now) {
    WearLoad load = load_of(now);
    effort_.balance_error = std::max(effort_.balance_error, load.balance_error);
    return load;
  }

  /// A cycle without a solution reports how deep the face was by then.
  WearLoad load_of(const WornDepths& now) {
    try {
      return load_(now);
    } catch (const ConvergenceError& stopped) {
      throw ConvergenceError(where(now) + ": " + stopped.what(), stopped.crank_angle_deg());
    }
  }

  static std::string where(const WornDepths& now) {
    return "after " + hours_text(now.time) + " of wear, " + text_in(largest(now.face), kMicrometre) + " deep";
  }

  void keep(Jump jump) {
    if (is_through(jump.end)) worn_through_ = on_the_way(jump.end, share_of_coating(jump.end));
    ++effort_.jumps;
    effort_.stage_difference = std::max(effort_.stage_difference, jump.stage_difference);
    effort_.lacks_last_stage = jump.lacks_last_stage;
    now_ = std::move(jump.end);
    load_now_.reset();
    if (limits_.after_jump) limits_.after_jump(passed());
  }

  /// The present depths; after a jump through the coating those at its end.
  const WornDepths& passed() const { return worn_through_ ? *worn_through_ : now_; }

  /// Whole jumps as far as they go, and a part of one on the side to a time between two.
  WornDepths at_equal_jumps(double time) {
    if (time == 0) return now_;
    const double length = end_ / *wear_.jumps;
    constexpr double kRounding = 1e-9;
    while (!worn_through_ && now_.time + length <= time * (1 + kRounding)) {
      const int done = effort_.jumps + 1;
      keep(jump_to(done == *wear_.jumps ? end_ : done * length));
    }
    if (worn_through_ || std::abs(time - now_.time) <= kRounding * length) return now_;
    Jump part = jump_to(time);
    WornDepths there = part.end;
    if (is_through(there)) keep(std::move(part));
    return there;
  }

  /// Refuses to continue where nothing is gained by it.
  void check_progress(double until) const {
    const bool is_short = next_ < kMinJump * longest_by_depth() || !(until > now_.time);
    if (!is_short && effort_.jumps < kMaxJumps) return;
    throw ConvergenceError(where(now_) + ": " +
                           (is_short ? "the jumps became too short" : std::to_string(kMaxJumps) + " jumps were taken") +
                           "; take a larger wear.jump_error or wear.largest_depth, or a smaller wear.coefficient");
  }

  /// The longest jump whose depth at the present rates is allowed.
  double longest_by_depth() const { return longest_by_depth(wear_.largest_depth); }
  double longest_by_depth(double depth) const {
    const bool is_running_in = wear_.running_in_coefficient && now_.time < wear_.running_in_time;
    const double rate = largest(load_now_->face) * (is_running_in ? *wear_.running_in_coefficient : wear_.coefficient);
    return rate * end_ > depth ? depth / rate : end_;
  }

  /// Is the coating surely worn through before that time?
  bool is_lost_before(double time) const {
    if (!limits_.deepest || !limits_.decay_depth || limits_.is_enough) return false;
    const double mean = std::accumulate(load_now_->face.begin(), load_now_->face.end(), 0.0) /
                        static_cast<double>(load_now_->face.size());
    return coefficient_integral(wear_, now_.time, time) * mean > kSurelyLost * (*limits_.deepest - largest(now_.face));
  }

  /// eq-life-coarse: explicit where the depth is small beside that within which waviness decays, and never unstable.
  /// What is lost of the cross-section is that of an explicit jump.
  WornDepths coarse_jump(double time) const {
    const double K = coefficient_integral(wear_, now_.time, time);
    std::vector<double> damped;
    for (const double load : load_now_->face) damped.push_back(load / (1 + K * load / *limits_.decay_depth));
    const double all = std::accumulate(load_now_->face.begin(), load_now_->face.end(), 0.0);
    const double share = all > 0 ? all / std::accumulate(damped.begin(), damped.end(), 0.0) : 1;
    WornDepths end{time, now_.face, worn_liner(time, *load_now_, *load_now_)};
    for (std::size_t i = 0; i < end.face.size(); ++i) end.face[i] += K * share * damped[i];
    return end;
  }

  /// By few jumps to the end of a coating that does not last until that time. Where it lasts, or a face has no cycle,
  /// nothing has happened.
  void wear_through_before(double time) {
    const Integration before = *this;
    const double depth = *limits_.deepest / kCoarseJumps;
    std::vector<WornDepths> all_passed;
    try {
      while (!worn_through_ && now_.time < time && effort_.jumps < kMaxJumps) {
        if (!load_now_) load_now_ = measured(now_);
        WornDepths end = coarse_jump(std::min(time, now_.time + longest_by_depth(depth)));
        if (is_through(end)) worn_through_ = on_the_way(end, share_of_coating(end));
        now_ = std::move(end);
        all_passed.push_back(passed());
        load_now_.reset();
        ++effort_.jumps;
      }
    } catch (const ConvergenceError&) {
      worn_through_.reset();
    }
    if (!worn_through_) return restore(before);
    effort_.coarse_depth = depth;
    for (const WornDepths& there : all_passed) {
      if (limits_.after_jump) limits_.after_jump(there);
    }
  }

  void restore(const Integration& before) {
    now_ = before.now_;
    load_now_ = before.load_now_;
    effort_ = before.effort_;
  }

  WornDepths at_chosen_jumps(double time) {
    if (now_.time < time && !load_now_) load_now_ = measured(now_);
    if (now_.time < time && is_lost_before(time)) wear_through_before(time);
    while (!worn_through_ && now_.time < time) {
      if (!load_now_) load_now_ = measured(now_);
      double length = std::min({next_, time - now_.time, longest_by_depth()});
      const double until = length == time - now_.time ? time : now_.time + length;
      check_progress(until);
      if (limits_.is_too_long && limits_.is_too_long(now_, first_stage(until))) {
        next_ = kShortened * length;
        continue;
      }
      Jump jump = jump_to(until);
      if (jump.stage_difference > wear_.jump_error) {
        ++effort_.rejected_jumps;
        next_ = 0.5 * length;
        continue;
      }
      // The difference of the stages grows with the square of the length.
      const double wished = jump.stage_difference > 0
                                ? kCaution * length * std::sqrt(wear_.jump_error / jump.stage_difference)
                                : kGrowth * length;
      // A jump that was cut at a reported time does not shorten those after it.
      next_ = until == time ? std::max(next_, std::min(wished, kGrowth * length)) : std::min(wished, kGrowth * length);
      keep(std::move(jump));
      if (limits_.is_enough && limits_.is_enough()) break;
    }
    return now_;
  }

  const Wear& wear_;
  const WearLoadOf& load_;
  const WearLimits& limits_;
  double end_, next_;
  WornDepths now_;
  std::optional<WearLoad> load_now_;
  WearEffort effort_;
  std::optional<WornDepths> worn_through_;
};

}  // namespace

double coefficient_integral(const Wear& wear, double from, double to) {
  if (!wear.running_in_coefficient) return wear.coefficient * (to - from);
  const double before = std::clamp(wear.running_in_time, from, to) - from;
  return *wear.running_in_coefficient * before + wear.coefficient * (to - from - before);
}

WearHistory integrate_wear(const Wear& wear, const std::vector<double>& times, std::size_t n_face, std::size_t n_liner,
                           const WearLoadOf& load, const WearLimits& limits) {
  return Integration(wear, times.empty() ? 0.0 : times.back(), n_face, n_liner, load, limits).run(times);
}

}  // namespace ringfilm::life
