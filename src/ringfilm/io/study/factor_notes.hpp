#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "ringfilm/study/design/idle_factors.hpp"
#include "ringfilm/study/statistics/flat_factors.hpp"

namespace ringfilm::io {

/// One sentence for each value that hardly changes with one or more factors of the study, in the units of people.
/// @param tolerance below which it changes, relative [-]
std::vector<std::string> flat_notes(const study::Plan& plan, const std::vector<study::FlatRange>& ranges,
                                    double tolerance);

/// Notes on factors that change nothing, or hardly anything, as scenarios come.
class FactorNotes {
 public:
  /// The plan must outlive it.
  explicit FactorNotes(const study::Plan& plan);

  /// The values that add() takes from now on, of Plan::values().quantities; they become fewer.
  std::vector<std::size_t> columns();

  /// One scenario. @param values values of the columns that were asked for last, NaN where it was not solved
  void add(std::uint64_t scenario, std::span<const double> values);

  std::vector<std::string> notes() const;

 private:
  const study::Plan& plan_;
  study::IdleFactors idle_;
  study::FlatFactors flat_;
  bool takes_all_ = true;  ///< does add() take all values, or those that `flat_` looks at?
};

}  // namespace ringfilm::io
