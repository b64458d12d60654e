#include "ringfilm/study/design/plan.hpp"

#include <algorithm>
#include <bit>
#include <map>
#include <numeric>
#include <stdexcept>

#include "ringfilm/base/number_text.hpp"
#include "ringfilm/cycle/advice/gas_plausibility.hpp"
#include "ringfilm/study/design/scenario.hpp"
#include "ringfilm/study/design/wording.hpp"
#include "ringfilm/study/sampling/hash.hpp"

namespace ringfilm::study {
namespace {

/// Streams of random numbers of one seed.
enum Stream : std::uint64_t { kSobolStream, kHypercubeStream, kMorrisStream };

Study checked(Study study) {
  const std::vector<Fault> faults = faults_of(study);
  if (!faults.empty()) throw InputError(faults);
  return study;
}

/// Values of a factor one at a time, beside where it stays.
std::size_t n_single_levels(const Factor& factor) {
  return std::holds_alternative<Distribution>(factor.variation) ? 2 : n_levels(factor.variation);
}

double single_level(const Factor& factor, std::size_t i) {
  const auto* distribution = std::get_if<Distribution>(&factor.variation);
  return distribution ? quantile(*distribution, i == 0 ? kLowShare : kHighShare) : level(factor.variation, i);
}

std::uint64_t points_of(const Study& study, std::size_t base) {
  std::uint64_t n = 1;
  for (const Factor& factor : study.factors) {
    if (!applies(factor, base)) continue;
    if (study.sampling.method == Method::kGrid) {
      n *= n_levels(factor.variation);
    } else {
      n += n_single_levels(factor);
    }
  }
  return n;
}

std::string text_of(const Variation& variation) {
  if (const auto* d = std::get_if<Distribution>(&variation)) {
    std::string text = "distribution " + std::to_string(static_cast<int>(d->shape));
    for (const double x : {d->mean, d->deviation, d->median, d->log_deviation, d->lower, d->mode, d->upper})
      text.append(" ").append(exact(x));
    for (const auto& end : {d->lowest, d->highest}) text.append(" ").append(end ? exact(*end) : "-");
    return text;
  }
  if (const auto* span = std::get_if<Span>(&variation)) {
    return "span " + exact(span->low) + " " + exact(span->high) + " " + std::to_string(span->points) + " " +
           std::to_string(static_cast<int>(span->spacing));
  }
  std::string text = std::holds_alternative<Listed>(variation) ? "listed" : "levels";
  if (const auto* levels = std::get_if<Levels>(&variation)) {
    for (const double x : levels->values) text.append(" ").append(exact(x));
  }
  if (const auto* choices = std::get_if<Choices>(&variation)) {
    for (const Choice& choice : choices->values) {
      text.append(" \"").append(choice.file_sha256.empty() ? choice.text : choice.file_sha256).append("\"");
    }
  }
  return text;
}

/// Notes on bases whose pressure stays while the speed changes, as far as scenarios spread over the plan show it.
void append_kept_pressures(const Plan& plan, std::vector<std::string>& notes) {
  std::map<std::string, std::string> bases;  // by the message
  for (std::size_t b = 0; b < plan.study().bases.size(); ++b) {
    std::vector<cycle::Case> cases;
    for (const std::uint64_t i : spread_scenarios(plan, b)) {
      try {
        cases.push_back(scenario_case(plan.study(), plan.point(i)));
      } catch (const InputError&) {
        // A scenario that is refused has no pressure; its row has the reason.
      }
    }
    std::vector<const cycle::Case*> all;
    for (const cycle::Case& one : cases) all.push_back(&one);
    const std::optional<std::string> kept = cycle::kept_pressure(all);
    if (!kept) continue;
    std::string& names = bases[*kept];
    names += (names.empty() ? "\"" : ", \"") + plan.study().bases[b].name + "\"";
  }
  for (const auto& [message, names] : bases) {
    notes.push_back("base " + names + ": " + message +
                    "; vary gas.peak_pressure or gas.cylinder_pressure with the speed");
  }
}

}  // namespace

Plan::Plan(Study study)
    : study_(checked(std::move(study))),
      values_(study_values(study_, study_.bases.front().input)),
      groups_(factor_groups(study_)),
      copula_(study_) {
  const Sampling& sampling = study_.sampling;
  const std::size_t n_bases = study_.bases.size(), n_factors = study_.factors.size();
  const auto seed = [this](Stream stream) { return hash(study_.seed, stream); };
  for (std::size_t base = 0; base < n_bases; ++base) {
    switch (sampling.method) {
      case Method::kGrid:
      case Method::kOneAtATime:
        n_points_.push_back(points_of(study_, base));
        break;
      case Method::kLatinHypercube:
      case Method::kSobol:
        n_points_.push_back(sampling.scenarios * points_per_row());
        break;
      case Method::kList:
      case Method::kOperatingPoints:
        n_points_.push_back(sampling.list.size());
        break;
      case Method::kMorris:
        n_points_.push_back(sampling.trajectories * points_per_row());
        break;
    }
  }
  if (sampling.method == Method::kSobol) {
    const std::size_t n_sets = sampling.indices == Indices::kNone ? 1 : 2;
    sobol_ = SobolPoints(n_sets * n_factors, seed(kSobolStream));
  }
  if (sampling.method == Method::kLatinHypercube) {
    hypercube_ = LatinHypercube(sampling.scenarios, seed(kHypercubeStream));
  }
  if (sampling.method == Method::kMorris) {
    trajectories_ = MorrisTrajectories(n_factors, sampling.levels, seed(kMorrisStream));
  }
}

std::uint64_t Plan::points_per_row() const {
  if (study_.sampling.method == Method::kMorris) return study_.factors.size() + 1;
  return study_.sampling.indices == Indices::kFirstAndTotal ? groups_.size() + 2 : 1;
}

std::uint64_t Plan::size() const { return std::accumulate(n_points_.begin(), n_points_.end(), std::uint64_t{0}); }

std::uint64_t Plan::most() const {
  const auto& until = study_.sampling.until;
  if (!until) return size();
  return std::max(size(), until->most * points_per_row() * study_.bases.size());
}

bool Plan::can_grow() const {
  return study_.sampling.method == Method::kSobol || study_.sampling.method == Method::kMorris;
}

bool Plan::is_block_by_block() const {
  return study_.sampling.method == Method::kGrid || study_.sampling.method == Method::kOneAtATime;
}

Plan::Place Plan::place(std::uint64_t i) const {
  if (i >= most()) throw std::out_of_range("no such scenario in the plan");
  const std::uint64_t n_bases = study_.bases.size();
  if (!is_block_by_block()) return {static_cast<std::size_t>(i % n_bases), i / n_bases};
  std::size_t base = 0;
  for (; i >= n_points_[base]; ++base) i -= n_points_[base];
  return {base, i};
}

std::uint64_t Plan::n_points(std::size_t base) const { return n_points_.at(base); }

std::uint64_t Plan::scenario(std::size_t base, std::uint64_t p) const {
  const std::uint64_t n_bases = study_.bases.size();
  const std::uint64_t i = is_block_by_block()
                              ? std::accumulate(n_points_.begin(), n_points_.begin() + static_cast<long>(base), p)
                              : p * n_bases + base;
  const Place found = place(i);
  if (found.base != base || found.point != p) throw std::out_of_range("no such point of that base");
  return i;
}

Point Plan::point(std::uint64_t i) const {
  const auto [base, p] = place(i);
  switch (study_.sampling.method) {
    case Method::kGrid:
      return {base, grid_values(base, p)};
    case Method::kOneAtATime:
      return {base, one_at_a_time_values(base, p)};
    case Method::kLatinHypercube:
    case Method::kSobol:
    case Method::kList:
    case Method::kMorris:
    case Method::kOperatingPoints:
      break;
  }
  Point point{base, sampled_values(p)};
  for (std::size_t j = 0; j < study_.factors.size(); ++j) {
    if (!applies(study_.factors[j], base)) point.values[j].reset();
  }
  return point;
}

std::vector<std::optional<double>> Plan::grid_values(std::size_t base, std::uint64_t p) const {
  std::vector<std::optional<double>> values(study_.factors.size());
  // The last factor runs fastest, as in nested loops.
  for (std::size_t j = study_.factors.size(); j-- > 0;) {
    const Factor& factor = study_.factors[j];
    if (!applies(factor, base)) continue;
    const std::size_t n = n_levels(factor.variation);
    values[j] = level(factor.variation, p % n);
    p /= n;
  }
  return values;
}

std::vector<std::optional<double>> Plan::one_at_a_time_values(std::size_t base, std::uint64_t p) const {
  std::vector<std::optional<double>> values(study_.factors.size());
  std::uint64_t first = 1;  // point 0 moves nothing
  for (std::size_t j = 0; j < study_.factors.size(); ++j) {
    const Factor& factor = study_.factors[j];
    if (!applies(factor, base)) continue;
    const std::size_t n = n_single_levels(factor);
    if (p >= first && p < first + n) {
      values[j] = single_level(factor, p - first);
    } else if (const auto* distribution = std::get_if<Distribution>(&factor.variation)) {
      values[j] = quantile(*distribution, 0.5);
    }
    first += n;
  }
  return values;
}

std::vector<double> Plan::shares(std::uint64_t p) const {
  const std::size_t n = study_.factors.size();
  std::vector<double> shares(n);
  switch (study_.sampling.method) {
    case Method::kLatinHypercube:
      for (std::size_t j = 0; j < n; ++j) shares[j] = hypercube_.share(p, j);
      break;
    case Method::kSobol: {
      const std::uint64_t row = p / points_per_row(), part = p % points_per_row();
      // Part 0 is the row of matrix A, part 1 that of B; part 2 + g is A with the factors of group g from B.
      for (std::size_t j = 0; j < n; ++j) shares[j] = sobol_.share(row, part == 1 ? n + j : j);
      if (part < 2) break;
      for (const std::size_t j : groups_[part - 2].factors) shares[j] = sobol_.share(row, n + j);
      break;
    }
    case Method::kMorris:
      shares = trajectories_.point(p);
      for (std::size_t j = 0; j < n; ++j) {
        if (std::holds_alternative<Distribution>(study_.factors[j].variation))
          shares[j] = kMinShare + (kMaxShare - kMinShare) * shares[j];
      }
      break;
    case Method::kGrid:
    case Method::kOneAtATime:
    case Method::kList:
    case Method::kOperatingPoints:
      throw std::logic_error("a plan that is not drawn from shares");
  }
  return shares;
}

std::vector<std::optional<double>> Plan::sampled_values(std::uint64_t p) const {
  if (is_listed(study_.sampling.method)) {
    const std::vector<double>& row = study_.sampling.list[p];
    return {row.begin(), row.end()};
  }
  std::vector<double> drawn = shares(p);
  copula_.correlate(drawn);
  std::vector<std::optional<double>> values(drawn.size());
  for (std::size_t j = 0; j < drawn.size(); ++j) values[j] = value_at(study_.factors[j].variation, drawn[j]);
  return values;
}

bool Plan::is_sample(std::uint64_t p) const {
  const bool is_chosen =
      study_.sampling.method == Method::kMorris || study_.sampling.method == Method::kOperatingPoints;
  if (is_block_by_block() || is_chosen) return false;
  return study_.sampling.indices == Indices::kNone || p % points_per_row() < 2;
}

const MorrisTrajectories& Plan::trajectories() const {
  if (study_.sampling.method != Method::kMorris) throw std::logic_error("a plan without trajectories");
  return trajectories_;
}

std::vector<std::string> Plan::notes() const {
  const Sampling& sampling = study_.sampling;
  std::vector<std::string> notes;
  if (sampling.method == Method::kLatinHypercube) {
    notes.push_back("a Latin hypercube of another number of scenarios has other points: this study cannot be extended");
  }
  if (sampling.method == Method::kSobol && !std::has_single_bit(sampling.scenarios)) {
    notes.push_back(std::to_string(sampling.scenarios) +
                    " scenarios are not a power of two: Sobol points are evenest at powers of two");
  }
  if (sampling.method == Method::kSobol || sampling.method == Method::kLatinHypercube) {
    notes.push_back(std::string("the intervals of means and quantiles presume independent points; ") +
                    (sampling.method == Method::kSobol ? "scrambled Sobol points" : "the points of a Latin hypercube") +
                    " are more even, so that the intervals are wider than need be");
  }
  if (sampling.method == Method::kList) {
    notes.push_back(
        "means, quantiles and their intervals presume that the points of the list were drawn at random from what the "
        "factors may be; for points that were chosen otherwise they do not show how likely a value is");
  }
  if (sampling.indices != Indices::kNone && sampling.scenarios < kFewRows) {
    notes.push_back("indices from " + std::to_string(sampling.scenarios) + " rows, fewer than " +
                    std::to_string(kFewRows) + ", can be further off than their intervals state");
  }
  if (sampling.method == Method::kOneAtATime && !study_.correlations.empty()) {
    notes.push_back("one factor at a time: the others stay at their medians, and correlations play no part");
  }
  if (sampling.method == Method::kOneAtATime || sampling.method == Method::kMorris) {
    const bool has_distribution = std::any_of(study_.factors.begin(), study_.factors.end(), [](const Factor& factor) {
      return std::holds_alternative<Distribution>(factor.variation);
    });
    const bool one = sampling.method == Method::kOneAtATime;
    const double low = one ? kLowShare : kMinShare, high = one ? kHighShare : kMaxShare;
    if (has_distribution) {
      notes.push_back("distributions are taken from their " + number_text(100 * low) + " % to their " +
                      number_text(100 * high) + " % quantile");
    }
  }
  if (sampling.indices == Indices::kFirstAndTotal && groups_.size() < study_.factors.size()) {
    notes.push_back("correlated factors share one index: the contribution of each cannot be separated");
  }
  append_kept_pressures(*this, notes);
  return notes;
}

std::string Plan::digest_text() const {
  const Sampling& sampling = study_.sampling;
  std::string text = "seed " + std::to_string(study_.seed) + "\nmethod " +
                     std::to_string(static_cast<int>(sampling.method)) + " indices " +
                     std::to_string(static_cast<int>(sampling.indices)) + "\n";
  if (study_.compute == Compute::kGas) text.append("gas alone\n");
  if (sampling.method == Method::kLatinHypercube) text.append("points " + std::to_string(sampling.scenarios) + "\n");
  if (sampling.method == Method::kMorris) text.append("levels " + std::to_string(sampling.levels) + "\n");
  for (const Base& base : study_.bases) {
    const cycle::Case input = with_accuracy_of_study(base.input, study_);
    text.append("base\n").append(study::digest_text(input));
  }
  for (const Factor& factor : study_.factors) {
    text.append("factor \"").append(factor.name).append("\" ").append(std::to_string(static_cast<int>(factor.how)));
    text.append(" ").append(text_of(factor.variation)).append("\n");
    for (const Target& target : factor.targets) {
      text.append("  ").append(target.key).append(" ").append(exact(target.gain));
      text.append(" ").append(target.base ? std::to_string(*target.base) : "all").append("\n");
    }
  }
  for (const Correlation& one : study_.correlations) {
    text.append("correlation ").append(std::to_string(one.first)).append(" ").append(std::to_string(one.second));
    text.append(" ").append(exact(one.value)).append("\n");
  }
  for (const auto& row : sampling.list) {
    text.append("row");
    for (const double x : row) text.append(" ").append(exact(x));
    text.append("\n");
  }
  return text;
}

}  // namespace ringfilm::study
