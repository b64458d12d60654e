#include "ringfilm/io/measurement/bore_map_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ringfilm/io/text/csv_quantity.hpp"

namespace ringfilm::io {
namespace {

constexpr std::size_t kFewestAngles = 8;
constexpr double kSameAngle = 1e-3;  // [degree], what rounding in a file leaves

/// The rows of a map, height after height.
class BoreRows {
 public:
  BoreRows(const CsvFile& csv, const Units& units, std::vector<Fault>& faults) : csv_(csv), faults_(faults) {
    height_ = quantity_column(csv, "height", "m", "height [mm]", units, faults);
    angle_ = quantity_column(csv, "angle", "degree", "angle [degree]", units, faults);
    deviation_ = quantity_column(csv, "deviation", "m", "deviation [um]", units, faults);
  }

  cycle::BoreMap map() {
    cycle::BoreMap map;
    for (std::size_t first = 0; first < height_.size() && faults_.empty();) {
      std::size_t end = first + 1;
      while (end < height_.size() && height_[end] == height_[first]) ++end;
      if (!map.height.empty() && height_[first] < map.height.back()) {
        refuse(first, "height", "the height falls from one section of the bore to the next",
               "list the sections from the lowest height to the highest, each one once");
        break;
      }
      const std::size_t n = without_repeated_end(first, end);
      if (faults_.empty()) check_section(first, n, map);
      map.height.push_back(height_[first]);
      map.deviation.emplace_back(deviation_.begin() + static_cast<std::ptrdiff_t>(first),
                                 deviation_.begin() + static_cast<std::ptrdiff_t>(first + n));
      first = end;
    }
    return map;
  }

 private:
  /// @returns the number of angles of a section, of which the last may repeat the first
  std::size_t without_repeated_end(std::size_t first, std::size_t end) {
    const std::size_t n = end - first;
    if (n < 2 || std::abs(angle_[end - 1] - angle_[first] - 360) > kSameAngle) return n;
    if (deviation_[end - 1] != deviation_[first]) {
      refuse(end - 1, "deviation",
             fmt::format("the deviation at {:.6g} degree is {:.6g} um, and {:.6g} um one turn before", angle_[end - 1],
                         1e6 * deviation_[end - 1], 1e6 * deviation_[first]),
             "the bore is periodic: state each angle once, or the same deviation at both ends");
    }
    return n - 1;
  }

  void check_section(std::size_t first, std::size_t n, cycle::BoreMap& map) {
    if (n < kFewestAngles) {
      refuse(first, "angle", fmt::format("a section of the bore has {} angles", n),
             fmt::format("{} evenly spaced angles over one turn or more are required", kFewestAngles));
      return;
    }
    if (!map.deviation.empty() && n != map.deviation.front().size()) {
      refuse(first + std::min(n, map.deviation.front().size()) - 1, "angle",
             fmt::format("this section of the bore has {} angles, the first {}", n, map.deviation.front().size()),
             "the map has holes: state every angle at every height");
      return;
    }
    if (map.deviation.empty()) map.first_angle_deg = angle_[first];
    const double step = 360.0 / static_cast<double>(n);
    for (std::size_t i = 0; i < n; ++i) {
      const double even = map.first_angle_deg + static_cast<double>(i) * step;
      if (std::abs(angle_[first + i] - even) <= kSameAngle + 1e-3 * step) continue;
      refuse(
          first + i, "angle",
          fmt::format("angle = {:.6g} degree, where {} angles over one turn from {:.6g} degree on have {:.6g} degree",
                      angle_[first + i], n, map.first_angle_deg, even),
          "angles rise evenly over one whole turn without holes, and are the same at all heights; are they degrees?");
      return;
    }
  }

  void refuse(std::size_t row, const char* column, const std::string& message, const std::string& remedy) {
    faults_.push_back({csv_.cell_mark(row, *csv_.find(column)), message, remedy});
  }

  const CsvFile& csv_;
  std::vector<Fault>& faults_;
  std::vector<double> height_, angle_, deviation_;
};

}  // namespace

BoreMapFile read_bore_map(const NamedFile& file, const Units& units) {
  const CsvFile csv = read_csv(file);
  std::vector<Fault> faults;
  BoreRows rows(csv, units, faults);
  BoreMapFile bore;
  if (faults.empty()) bore.map = rows.map();
  if (!faults.empty()) throw InputError(faults);
  bore.sha256 = csv.source.sha256;
  bore.notes = csv.notes;
  return bore;
}

}  // namespace ringfilm::io
