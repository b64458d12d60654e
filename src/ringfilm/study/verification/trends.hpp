#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ringfilm/cycle/result/result.hpp"

/// Published trends of measured rings, and whether computed numbers follow them. docs/manual/guide/measured-trends.md.
namespace ringfilm::study {

/// How a curve over crank angle becomes one number.
enum class WindowValue { kMax, kMin, kMean };

/// A part of the cycle.
struct CrankWindow {
  double from_deg = 0, to_deg = 0;  ///< from 0 at firing TDC to 720 [degree]
  WindowValue value = WindowValue::kMean;
};

/// The number of a run that a trend compares.
struct TrendProbe {
  /// A value of the cycle, with a window a curve over crank angle, or a value of the gas of a pack.
  std::string quantity;
  std::optional<std::string> share_of;  ///< quantity of the same kind to which it is relative
  std::optional<std::size_t> ring;      ///< number of the ring, from 1; nothing: all rings, or the only one
  std::optional<CrankWindow> window;
};

/// The quantity of a probe by its name; nothing where there is none of its kind. @param name quantity or share_of
std::optional<cycle::Quantity> find_probed(const TrendProbe& probe, const std::string& name);

/// The quantity that the probe gives: that of its name, or a share.
cycle::Quantity probed_quantity(const TrendProbe& probe);

/// Is it a value of the gas of a pack, for which no film is needed?
bool is_of_gas(const TrendProbe& probe);

/// What a published trend states of the numbers of its levels, from the first to the last.
enum class TrendExpectation { kRises, kFalls, kHasMinimumInside, kUnchanged, kLargerChangeThan, kWithin };
/// Each expectation with its word in files and tables.
const std::vector<std::pair<std::string, TrendExpectation>>& trend_expectations();

/// Do the computed numbers follow the published trend?
enum class Agreement { kAgrees, kDisagrees };
/// Each outcome with its word in files and tables.
const std::vector<std::pair<std::string, Agreement>>& agreements();

/// The word of a choice of trend_expectations() or agreements().
template <class Choice>
const std::string& word_of(const std::vector<std::pair<std::string, Choice>>& choices, Choice choice) {
  std::size_t i = 0;
  while (choices[i].second != choice) ++i;
  return choices[i].first;
}

/// One run of a trend.
struct TrendLevel {
  std::string name;                   ///< what is set, for people: "2000 rpm"
  std::vector<std::string> settings;  ///< "key=value" beyond those of the trend
};

/// A published statement with the runs that express it.
struct Trend {
  std::string id;                     ///< unique word
  std::string statement;              ///< what was published, in plain English
  std::string source;                 ///< entry of the bibliography, or the number of a paper
  std::string size;                   ///< published size; empty: none
  std::string assumed;                ///< what the source does not state
  std::string base;                   ///< name of a TrendBase
  std::vector<std::string> settings;  ///< "key=value" of all levels
  std::vector<TrendLevel> levels;     ///< from low to high
  TrendProbe probe;
  TrendExpectation expectation = TrendExpectation::kRises;
  std::string than;                        ///< kLargerChangeThan: id of the other trend
  double least_limit = 0, most_limit = 0;  ///< kWithin [SI]
  double least_change = 0;                 ///< relative change below which a number is unchanged [-]
  Agreement known = Agreement::kAgrees;    ///< recorded outcome
  std::string reason;                      ///< physical reason of a recorded disagreement; empty where it agrees
};

/// A case from which the runs of trends start.
struct TrendBase {
  std::string name;
  std::string path;          ///< file of the case; empty: the start case of an engine
  std::string start_engine;  ///< engine of io::start_case; empty: a file
};

/// A published statement that no case of this program can express.
struct InexpressibleTrend {
  std::string id, statement, source, reason;
};

/// All trends with their bases.
struct TrendList {
  std::vector<TrendBase> bases;
  std::vector<Trend> trends;
  std::vector<InexpressibleTrend> inexpressible;
};

/// The computed numbers of a trend, and what they mean.
struct TrendOutcome {
  Trend trend;
  cycle::Quantity quantity;        ///< what the numbers are
  std::vector<double> values;      ///< number of each level; NaN where its run stopped [SI]
  double change = 0;               ///< last over first, less one [-]
  std::vector<std::string> stops;  ///< levels whose run found no solution, with the reason
  Agreement found = Agreement::kDisagrees;

  /// Did each run end, and is the outcome the recorded one?
  bool is_as_recorded() const { return stops.empty() && found == trend.known; }
};

/// Last over first number, less one [-].
double relative_change(const std::vector<double>& values);

/// Do these numbers follow the trend? @param values number of each level; a NaN disagrees
/// @param change_of_other relative_change() of the trend `than`; without effect on other expectations
Agreement agreement(const Trend& trend, const std::vector<double>& values, double change_of_other);

}  // namespace ringfilm::study
