#pragma once
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "ringfilm/base/error.hpp"

namespace ringfilm::instrument {

/// No map may have more points than this: 1 GiB of heights.
inline constexpr std::size_t kMaxPoints = std::size_t{1} << 27;
/// No file may be larger [byte].
inline constexpr std::size_t kMaxInstrumentFile = std::size_t{1} << 30;

/// A reason to doubt that the heights are those of the surface, as they were read.
struct Doubt {
  /// Is the user informed, are points taken as missing, or is the file refused?
  enum class Weight { kNote, kMissing, kRefusal };
  std::string message;            ///< place, value and rule
  std::string remedy;             ///< next step
  Weight weight = Weight::kNote;  ///< kRefusal: the result would certainly not be a surface
  std::vector<std::size_t> points =
      {};  ///< points with the doubtful value; of kMissing: those that are taken as missing
};

/// What a file states about one of its maps before the values are read.
struct Channel {
  std::string name;  ///< as the file writes it; may be empty
  std::string unit;  ///< unit of the values, e.g. "um"; empty where the file does not state it
  std::size_t points_x = 0;
  std::size_t points_y = 0;  ///< 1 for a profile
};

/// One map of any quantity: heights, a lateral signal, a light intensity. Row after row, the first row at y = 0.
struct ChannelValues {
  Channel channel;
  double step_x = 0.0;                ///< [step_unit]; 0 where the file does not state it
  double step_y = 0.0;                ///< [step_unit]; 0 where the file does not say, and of a profile
  std::string step_unit;              ///< e.g. "m"; empty where the file does not state it
  std::string assumed_unit;           ///< unit of x, y, z alike where neither file nor user states it; mostly empty
  std::string step_unit_y;            ///< unit of step_y where it is another one than step_unit; else empty
  std::vector<Fault> step_faults;     ///< what is wrong with the size that the file states
  std::vector<double> x;              ///< [step_unit] places of a profile that need not be even; else empty
  std::vector<double> value;          ///< points_x * points_y [channel.unit]; 0 where missing
  std::vector<std::uint8_t> missing;  ///< 1 where nothing was measured; empty if every point was
  std::vector<std::string> notes;     ///< for the record: how the values were read
  std::vector<Doubt> doubts;          ///< what may be wrong with them, as far as the reader can judge

  bool is_missing(std::size_t point) const { return !missing.empty() && missing[point] != 0; }

  /// Marks a point as missing.
  void set_missing(std::size_t point) {
    if (missing.empty()) missing.assign(value.size(), 0);
    missing[point] = 1;
    value[point] = 0;
  }
  /// Marks the points whose value is not a number (NaN) as missing.
  void set_missing_where_nan() {
    for (std::size_t i = 0; i < value.size(); ++i) {
      if (std::isnan(value[i])) set_missing(i);
    }
  }
};

/// A file whose header was read and found valid. The values come when asked for, one channel at a time.
struct InstrumentFile {
  std::string format;      ///< e.g. "X3P (ISO 25178-72)"
  std::string instrument;  ///< as the file names it; may be empty
  std::string date;        ///< as the file writes it; may be empty
  std::vector<std::string> notes;
  std::vector<Channel> channels;                           ///< one or more
  std::function<ChannelValues(std::size_t index)> values;  ///< values of channels[index]; throws InputError
};

}  // namespace ringfilm::instrument
