#pragma once
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "ringfilm/study/design/plan.hpp"

namespace ringfilm::study {

/// Are there scenarios of the method that differ in one factor alone?
bool has_pairs(const Sampling& sampling);
/// A hash of a point without the number of one of its factors: the same for points that differ in it alone.
std::uint64_t hash_without(const Point& point, std::size_t factor);
/// Thinning of pairs: one in this many sets of values of the other factors is examined, to limit the memory.
std::uint64_t thinning_of_pairs(const Plan& plan);

/// Looks for factors that change no value of the cycle at all, as scenarios come.
///
/// Two scenarios of one base that differ in one factor alone are a pair. A factor is idle where there are pairs and the
/// values of each are the same to the last bit. The scenarios of a sample differ in all factors: there the factors are
/// idle where all scenarios of a base have the same values. Scenarios that were not solved do not count.
class IdleFactors {
 public:
  /// The plan must outlive it.
  explicit IdleFactors(const Plan& plan);

  /// One scenario; `values` as in ScenarioRow. Any order.
  void add(std::uint64_t scenario, std::span<const double> values);

  /// Are all factors in use, whatever comes?
  bool is_decided() const;

  /// Are there pairs of this factor, and no value that differs?
  bool is_idle(std::size_t factor) const { return !factors_[factor].has_effect && factors_[factor].n_pairs > 0; }

  /// One sentence for each idle factor, or one for all of them.
  std::vector<std::string> notes() const;

 private:
  struct Seen {
    double number;         ///< number of the factor in the first scenario of a set
    std::uint64_t values;  ///< hash of the values of the cycle
  };
  struct Watched {
    bool has_effect = false;
    std::uint64_t n_pairs = 0;
    std::map<std::uint64_t, Seen> by_others;  ///< by the hash of base and other numbers
  };
  struct BaseValues {
    std::uint64_t n = 0, values = 0;  ///< solved scenarios, hash of the values of the first of them
    bool differ = false;
  };
  void look_for_pair(std::size_t factor, const Point& point, std::uint64_t values);

  const Plan& plan_;
  bool has_pairs_;          ///< are there scenarios that differ in one factor alone?
  std::uint64_t thinning_;  ///< one in this many sets of values of the other factors is examined
  std::vector<Watched> factors_;
  std::vector<BaseValues> bases_;
};

}  // namespace ringfilm::study
