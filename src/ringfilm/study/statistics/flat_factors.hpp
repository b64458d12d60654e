#pragma once
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "ringfilm/study/design/idle_factors.hpp"
#include "ringfilm/study/design/plan.hpp"

namespace ringfilm::study {

/// Friction, film and blow-by of an engine are measured to a few percent: a smaller change is not seen there [-].
inline constexpr double kNotMeasured = 0.02;

/// Numbers of a factor over which a value of the scenarios hardly changes while the other factors stay: a fit of the
/// factor to a measured value is not determined there.
struct FlatRange {
  std::size_t factor = 0;    ///< index of the factor in Study::factors
  std::size_t value = 0;     ///< index of the value in Plan::values().quantities
  bool is_whole = true;      ///< are these all numbers of the factor?
  double low = 0, high = 0;  ///< smallest and largest of them [SI]
};

/// Looks for such ranges as scenarios come, of the values that people measure: friction, film and blow-by.
///
/// Scenarios of one base that differ in one factor alone belong together. A range is flat where the values of each such
/// set differ by less than `tolerance` of the largest among them. Below and above a range that is not the whole there
/// are listed numbers, of which a flat part has three or more: two may lie on both sides of an extremum.
class FlatFactors {
 public:
  /// The plan must outlive it. @param tolerance relative difference [-]
  FlatFactors(const Plan& plan, double tolerance);

  /// The values that it looks at, of Plan::values().quantities; none where no scenarios differ in one factor alone.
  const std::vector<std::size_t>& watched() const { return watched_; }

  /// One scenario; `values` are those of watched(), NaN where it was not solved. Any order.
  void add(std::uint64_t scenario, std::span<const double> values);

  /// Factor by factor, without those that change nothing at all and are reported by `idle`.
  std::vector<FlatRange> ranges(const IdleFactors& idle) const;

 private:
  /// Values by the number of the factor.
  using Curve = std::map<double, std::vector<double>>;
  /// Curves of one factor, by the hash of base and other numbers.
  using Curves = std::map<std::uint64_t, Curve>;

  bool is_flat(const Curves& curves, std::size_t value, double low, double high) const;
  void append_ranges(std::size_t factor, std::size_t value, std::vector<FlatRange>& ranges) const;

  const Plan& plan_;
  double tolerance_;
  std::uint64_t thinning_;  ///< one in this many sets of values of the other factors is examined
  std::vector<std::size_t> watched_;
  std::vector<Curves> curves_;  ///< curves of each factor
};

}  // namespace ringfilm::study
