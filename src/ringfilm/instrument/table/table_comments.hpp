#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ringfilm/base/error.hpp"
#include "ringfilm/instrument/grid/channel.hpp"
#include "ringfilm/io/table/text_table.hpp"

/// What the comments in front of a matrix of heights state: those of Gwyddion, in any of its languages, and of SPIP.
namespace ringfilm::instrument {

/// "10.0 um" of a comment.
struct StatedLength {
  double value = 0;
  double rounding = 0;  ///< half a unit of its last digit
  std::string unit;
};

/// What is stated of one map.
struct StatedMap {
  std::string name;                               ///< name of the channel; may be empty
  std::string unit;                               ///< unit of the heights; may be empty
  double height_factor = 1;                       ///< heights in `unit` are the numbers of the file times it
  std::optional<StatedLength> width, height;      ///< in one unit where both are lengths
  std::optional<std::size_t> points_x, points_y;  ///< number of points of a row, number of rows
  std::vector<Fault> faults;                      ///< faults of width and height
  std::vector<std::string> notes;
  std::vector<Doubt> doubts;
};

/// The comments of one map. Only lines "name: value" and "name = value" count.
class TableComments {
 public:
  TableComments(std::string file, const std::vector<io::TextLine>& comments);

  /// All that they state together.
  StatedMap stated() const;

 private:
  struct Entry {
    std::string name;  ///< as written
    std::string key;   ///< in lower case
    std::string value;
    int number = 0;
    std::string line;
  };

  const Entry* find(std::string_view key) const;
  std::optional<StatedLength> side(const Entry& entry, const std::string& usual_unit, StatedMap& map) const;

  std::string file_;
  std::vector<Entry> entries_;
};

}  // namespace ringfilm::instrument
