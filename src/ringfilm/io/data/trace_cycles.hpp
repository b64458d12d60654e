#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

/// Cycles of a cylinder pressure that follow each other, or are columns of one file, made into one cycle.
namespace ringfilm::io {

/// Samples as a file has them, without those that lack a number.
struct TraceRows {
  std::vector<double> crank_angle_deg;
  std::vector<std::vector<double>> pressure;  ///< one list for each column of pressures; any unit
  std::vector<std::size_t> row;               ///< row of each sample in the file, from 0
  std::vector<std::string> notes;
};

/// Turns samples whose crank angle falls from row to row, also over several cycles.
void turn_falling(TraceRows& rows);

/// What `gas.cycle` chooses of several cycles: "mean", "median" or the number of one of them, from 1; "mean" if absent.
class CycleChoice {
 public:
  explicit CycleChoice(const std::optional<std::string>& text);
  bool is_valid() const { return kind_ != Kind::kUnknown; }
  /// The value of one sample.
  double value_of(std::vector<double> of_cycles) const;
  std::optional<std::size_t> number() const { return number_; }  ///< from 1; nothing for mean and median
  std::string words() const;                                     ///< "their mean", "cycle 3"

 private:
  enum class Kind { kMean, kMedian, kNumber, kUnknown };
  Kind kind_ = Kind::kMean;
  std::optional<std::size_t> number_;
};

/// One cycle of those in the rows: they are several where the angle falls back by 360 degrees or more, where it spans
/// more than a cycle without a hole, or where there are several columns. A part of a cycle at the end is omitted. Rows
/// of a single cycle are not changed. The scatter of the peaks is noted.
/// @param shown the file, for notes
/// @param pressure_scale of the values to Pa, for notes; nothing where the unit is not known
/// @returns how many cycles there are; 1 where the rows are not changed
std::size_t join_cycles(TraceRows& rows, const CycleChoice& choice, const std::string& shown,
                        std::optional<double> pressure_scale);

}  // namespace ringfilm::io
