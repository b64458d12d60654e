#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ringfilm/study/design/copula.hpp"
#include "ringfilm/study/design/study.hpp"
#include "ringfilm/study/design/study_values.hpp"
#include "ringfilm/study/sampling/latin_hypercube.hpp"
#include "ringfilm/study/sampling/morris.hpp"
#include "ringfilm/study/sampling/sobol_points.hpp"

/// Which scenarios a study runs, with which numbers; docs/theory/study.md.
namespace ringfilm::study {

/// One scenario.
struct Point {
  std::size_t base = 0;  ///< index of its base case
  /// For each factor its number [SI], or the index of its choice; nothing where it leaves the base as it is.
  std::vector<std::optional<double>> values;
};

/// Everything that is wrong with a study, as far as it can be found before a case is run: empty names, keys that do not
/// exist, are not numbers or not in use, distributions without support, values out of the range of their key, a
/// correlation matrix that is not positive definite, a plan that its method cannot make.
std::vector<Fault> faults_of(const Study& study);

/// All scenarios of a study, by their number. Each costs as much as it has factors, whichever comes first and whatever
/// was asked for before; nothing is stored for them. The same study gives the same numbers whatever it is split into,
/// and with Sobol points and Morris trajectories whatever their count: such a study can be extended, see can_grow(). A
/// Latin hypercube, a grid and a list cannot.
class Plan {
 public:
  /// Throws InputError with all faults_of(study).
  explicit Plan(Study study);

  const Study& study() const { return study_; }
  const StudyValues& values() const { return values_; }  ///< values that the study has of every scenario

  std::uint64_t size() const;  ///< scenarios of all bases
  std::uint64_t most() const;  ///< up to which the study may be extended; size() where it may not
  bool can_grow() const;       ///< do its scenarios stay the same where there are more of them?

  /// Scenario i. Throws std::out_of_range unless i < most().
  Point point(std::uint64_t i) const;
  std::size_t base_of(std::uint64_t i) const { return place(i).base; }

  /// Scenarios of one base, and the number among all of its point p (in its own order, as statistics require them).
  /// Points of a sample come base after base: the same point of all bases is stored side by side, with the same
  /// numbers.
  std::uint64_t n_points(std::size_t base) const;
  std::uint64_t scenario(std::size_t base, std::uint64_t p) const;
  /// The point within its base of a scenario.
  std::uint64_t point_of(std::uint64_t i) const { return place(i).point; }

  /// Is point p one of a sample of the factors, from which means and quantiles may be taken? Not on a grid, along a
  /// trajectory, nor where points for indices share coordinates with others.
  bool is_sample(std::uint64_t p) const;
  /// Points that come together (2 + groups with indices, those of a trajectory, otherwise 1): a study continues by
  /// these.
  std::uint64_t points_per_row() const;

  /// The groups of factors for which indices are reported; each factor alone where none is correlated.
  const std::vector<FactorGroup>& groups() const { return groups_; }
  /// Throws std::logic_error unless the plan is of this method.
  const MorrisTrajectories& trajectories() const;

  /// What must be known about the plan, one sentence each.
  std::vector<std::string> notes() const;

  /// All on which the numbers of a scenario depend, as text for a digest: bases, factors, correlations, method, seed;
  /// the number of points only where they change with it. Files count by their contents, not by their names.
  std::string digest_text() const;

 private:
  struct Place {
    std::size_t base;
    std::uint64_t point;
  };
  Place place(std::uint64_t i) const;
  bool is_block_by_block() const;
  std::vector<double> shares(std::uint64_t p) const;
  std::vector<std::optional<double>> grid_values(std::size_t base, std::uint64_t p) const;
  std::vector<std::optional<double>> one_at_a_time_values(std::size_t base, std::uint64_t p) const;
  std::vector<std::optional<double>> sampled_values(std::uint64_t p) const;

  Study study_;
  StudyValues values_;
  std::vector<FactorGroup> groups_;
  std::vector<std::uint64_t> n_points_;  ///< number of points of each base
  Copula copula_;
  SobolPoints sobol_;
  LatinHypercube hypercube_;
  MorrisTrajectories trajectories_;
};

/// With fewer rows the bootstrap does not see how uneven they are; docs/theory/study.md.
inline constexpr std::uint64_t kFewRows = 64;

/// Where the numbers of a distribution lie in a plan that requires levels: shares of its probability [-].
inline constexpr double kLowShare = 0.05, kHighShare = 0.95;   ///< one at a time, about the median
inline constexpr double kMinShare = 0.005, kMaxShare = 0.995;  ///< ends of a trajectory of Morris

}  // namespace ringfilm::study
