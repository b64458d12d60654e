#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ringfilm/study/design/factor.hpp"

/// A study as one plain value in SI: what varies, how it is sampled, what is kept. Its defaults are written here.
namespace ringfilm::study {

/// What is computed of each scenario: the films of its rings, with the gas path that the case has, or its gas alone.
enum class Compute { kFilms, kGas };
enum class StudyKind { kMap, kUncertainty, kCompare, kScreening };

/// A case from which scenarios start.
struct Base {
  std::string name;
  cycle::Case input;
};

/// Factors whose texts decide what is read from files: the file itself, its columns, their units. They act together,
/// since a column is one of the file's: a scenario takes what was read with the texts of all of them.
struct FileReading {
  std::vector<std::size_t> factors;  ///< indices of the factors in Study::factors
  /// Puts into a scenario of a base what the files gave with a choice of each of `factors`; nothing where the scenario
  /// leaves the base's own. Throws InputError where they cannot be read so.
  std::function<void(cycle::Case&, std::size_t base, const std::vector<std::optional<std::size_t>>& choices)> put;
};

/// Correlation of the normal scores of two factors, that is of normal factors themselves; eq-copula.
struct Correlation {
  std::size_t first = 0, second = 0;  ///< indices of the factors in Study::factors
  double value = 0;                   ///< between -1 and 1, without the ends [-]
  SourceMark mark;
};

enum class Method { kGrid, kOneAtATime, kLatinHypercube, kSobol, kList, kMorris, kOperatingPoints };

/// Does the study state all points itself?
inline bool is_listed(Method method) { return method == Method::kList || method == Method::kOperatingPoints; }
enum class Indices { kNone, kFirstAndTotal };

/// A study continues until the confidence interval of a statistic is this narrow.
struct StoppingRule {
  std::string value;               ///< one of cycle_quantities()
  std::optional<double> quantile;  ///< its share; absent: the mean
  double width = 0;                ///< width of the interval at which the study ends [unit of the value]
  std::uint64_t most = 0;          ///< never more points than these
  SourceMark mark = {};
};

/// An operating point with its share in a weighted mean.
struct WeightedPoint {
  std::string name;
  double weight = 1;  ///< relative to that of the others [-]
};

struct Sampling {
  Method method = Method::kSobol;
  /// Points of Latin hypercube and Sobol. Every base is run at each of them; with indices each takes two runs, and one
  /// more for each group of factors.
  std::uint64_t scenarios = 1024;
  Indices indices = Indices::kNone;
  std::optional<StoppingRule> until;
  std::vector<WeightedPoint> points;      ///< points and weights of kOperatingPoints, whose numbers are in `list`
  std::vector<std::vector<double>> list;  ///< values of all factors, point by point [SI]; the index of a choice
  std::uint64_t trajectories = 20;        ///< number of trajectories of Morris' method
  std::size_t levels = 4;                 ///< number of levels of Morris' method, even
};

enum class Curves { kNone, kAll, kQuantiles };

/// What stays of a scenario beside the values of its cycle.
struct OutputSelection {
  Curves curves = Curves::kNone;
  /// Names of cycle::curve_quantities(), without the crank angle.
  std::vector<std::string> quantities = {"min_film_thickness", "total_friction", "friction_on_liner", "power_loss"};
  double crank_step_deg = 2;  ///< step of the crank angle axis that all scenarios have in common [degree]
  SourceMark quantities_mark, crank_step_mark;
};

/// How accurate the values of a study are, and on how many of its scenarios that is estimated.
struct Accuracy {
  /// Accuracy of films across the face with flooded inlets in bases that state neither an accuracy nor cells and steps;
  /// nothing: they are computed with the cells and steps that a case has without these keys [%].
  std::optional<double> asked = 0.5;
  /// Scenarios that are integrated again on a finer grid; nothing: kUsualSample where an accuracy is asked for.
  std::optional<std::uint64_t> sample;
  static constexpr std::uint64_t kUsualSample = 16;
  static constexpr std::uint64_t kMaxSample = 10'000;
};

struct Study {
  std::string title;
  StudyKind kind = StudyKind::kUncertainty;
  Compute compute = Compute::kFilms;
  std::uint64_t seed = 1;
  std::vector<Base> bases;
  std::vector<Factor> factors;
  std::vector<FileReading> readings;  ///< readings by all factors that decide what is read from files
  std::vector<Correlation> correlations;
  Sampling sampling;
  OutputSelection keep;
  Accuracy accuracy;
};

}  // namespace ringfilm::study
