#include "ringfilm/io/measurement/bore_map_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <span>
#include <utility>

#include "ringfilm/base/constants.hpp"
#include "ringfilm/io/table/csv_quantity.hpp"
#include "ringfilm/models/gas/gas.hpp"
#include "ringfilm/models/gas/trace_span.hpp"

namespace ringfilm::io {
namespace {

constexpr std::size_t kMinAngles = 8;
constexpr double kSameAngle = 1e-3;  // [degree], what rounding in a file leaves

/// By what the sections of a bore are listed.
struct SectionColumn {
  const char *name, *unit, *example, *noun;
};
constexpr SectionColumn kByHeight{"height", "m", "height [mm]", "height"};
constexpr SectionColumn kByCrankAngle{"crank_angle", "degree", "crank_angle [degree]", "crank angle"};

/// All angles of one section each.
struct Sections {
  std::vector<double> at;  ///< rising
  double first_angle_deg = 0;
  std::vector<std::vector<double>> deviation;  ///< [m]
};

/// An angle of one turn that is not where evenly spaced angles lie [degree].
struct UnevenAngle {
  std::size_t place;
  double even;  ///< the angle that belongs there
};

std::optional<UnevenAngle> first_uneven(std::span<const double> angle, double first_angle) {
  const double step = 360.0 / static_cast<double>(angle.size());
  for (std::size_t i = 0; i < angle.size(); ++i) {
    const double even = first_angle + static_cast<double>(i) * step;
    if (!(std::abs(angle[i] - even) <= kSameAngle + 1e-3 * step)) return UnevenAngle{i, even};
  }
  return std::nullopt;
}

/// The rows of a map, section after section.
class BoreRows {
 public:
  BoreRows(const CsvFile& csv, const SectionColumn& by, const Units& units, std::vector<Fault>& faults)
      : csv_(csv), by_(by), faults_(faults) {
    at_ = quantity_column(csv, by.name, by.unit, by.example, units, faults);
    angle_ = quantity_column(csv, "angle", "degree", "angle [degree]", units, faults);
    deviation_ = quantity_column(csv, "deviation", "m", "deviation [um]", units, faults);
  }

  Sections sections() {
    Sections all;
    for (std::size_t first = 0; first < at_.size() && faults_.empty();) {
      std::size_t end = first + 1;
      while (end < at_.size() && at_[end] == at_[first]) ++end;
      if (!all.at.empty() && at_[first] < all.at.back()) {
        refuse(first, by_.name, fmt::format("the {} falls from one section of the bore to the next", by_.noun),
               fmt::format("list the sections from the lowest {} to the highest, each one once", by_.noun));
        break;
      }
      const std::size_t n = without_repeated_end(first, end);
      if (faults_.empty()) check_section(first, n, all);
      first_row_.push_back(first);
      all.at.push_back(at_[first]);
      all.deviation.emplace_back(deviation_.begin() + static_cast<std::ptrdiff_t>(first),
                                 deviation_.begin() + static_cast<std::ptrdiff_t>(first + n));
      first = end;
    }
    return all;
  }

  /// Sections over a cycle, each once, from 0 degree on.
  cycle::DynamicBore over_cycle(Sections all) {
    remove_repeated_section(all);
    if (faults_.empty() && !models::covers_cycle(all.at)) refuse_hole(all.at);
    cycle::DynamicBore bore;
    if (!faults_.empty()) return bore;
    bore.first_angle_deg = all.first_angle_deg;
    std::vector<std::size_t> order(all.at.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    for (double& angle : all.at) angle -= base::kCycleDeg * std::floor(angle / base::kCycleDeg);
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return all.at[a] < all.at[b]; });
    for (const std::size_t k : order) {
      bore.crank_angle_deg.push_back(all.at[k]);
      bore.deviation.push_back(std::move(all.deviation[k]));
    }
    return bore;
  }

 private:
  /// @returns the number of angles of a section, of which the last may repeat the first
  std::size_t without_repeated_end(std::size_t first, std::size_t end) {
    const std::size_t n = end - first;
    if (n < 2 || std::abs(angle_[end - 1] - angle_[first] - 360) > kSameAngle) return n;
    if (deviation_[end - 1] != deviation_[first]) {
      refuse(end - 1, "deviation",
             fmt::format("the deviation at {:.6g} degree is {}, and {} one turn before", angle_[end - 1],
                         text_in(deviation_[end - 1], kMicrometre), text_in(deviation_[first], kMicrometre)),
             "the bore is periodic: state each angle once, or the same deviation at both ends");
    }
    return n - 1;
  }

  void remove_repeated_section(Sections& all) {
    if (all.at.size() < 2) return;
    const double span = all.at.back() - all.at.front(), beyond = span - base::kCycleDeg;
    if (beyond < -kSameAngle) return;
    if (beyond > kSameAngle) {
      refuse(first_row_.back(), by_.name, fmt::format("the crank angles span {:.6g} degree", span),
             "one cycle of 720 degree is expected; cut the cycles, or take their mean");
    } else if (all.deviation.back() != all.deviation.front()) {
      refuse(first_row_.back(), by_.name,
             fmt::format("the bore at {:.6g} degree is not that of one cycle before", all.at.back()),
             "what the cycle adds is periodic: state each crank angle once, or the same deviations at both ends");
    } else {
      all.at.pop_back();
      all.deviation.pop_back();
    }
  }

  void refuse_hole(const std::vector<double>& at) {
    if (at.empty()) return;
    std::size_t before = at.size() - 1;
    for (std::size_t k = 0; k + 1 < at.size(); ++k) {
      if (at[k + 1] - at[k] > models::kMaxSampleDistanceDeg) {
        before = k;
        break;
      }
    }
    const double next = before + 1 < at.size() ? at[before + 1] : at.front() + base::kCycleDeg;
    refuse(first_row_[before], by_.name,
           fmt::format("the bore is not known between {:.6g} and {:.6g} degree crank angle", at[before], next),
           fmt::format("sections over the whole cycle of 720 degree are required, at most {:.6g} degree apart; are the "
                       "crank angles degrees?",
                       models::kMaxSampleDistanceDeg));
  }

  void check_section(std::size_t first, std::size_t n, Sections& all) {
    if (n < kMinAngles) {
      refuse(first, "angle", fmt::format("a section of the bore has {} angles", n),
             fmt::format("{} evenly spaced angles over one turn are required", kMinAngles));
      return;
    }
    if (!all.deviation.empty() && n != all.deviation.front().size()) {
      refuse(first + std::min(n, all.deviation.front().size()) - 1, "angle",
             fmt::format("this section of the bore has {} angles, the first {}", n, all.deviation.front().size()),
             fmt::format("the map has holes: state every angle at every {}", by_.noun));
      return;
    }
    if (all.deviation.empty()) all.first_angle_deg = angle_[first];
    const auto uneven = first_uneven({angle_.data() + first, n}, all.first_angle_deg);
    if (!uneven) return;
    refuse(first + uneven->place, "angle",
           fmt::format("angle = {:.6g} degree, where {} angles over one turn from {:.6g} degree on have {:.6g} degree",
                       angle_[first + uneven->place], n, all.first_angle_deg, uneven->even),
           fmt::format("angles rise evenly over one whole turn without holes, and are the same at every {}; are they "
                       "degrees?",
                       by_.noun));
  }

  void refuse(std::size_t row, const char* column, const std::string& message, const std::string& remedy) {
    faults_.push_back({csv_.cell_mark(row, *csv_.find(column)), message, remedy});
  }

  const CsvFile& csv_;
  const SectionColumn& by_;
  std::vector<Fault>& faults_;
  std::vector<double> at_, angle_, deviation_;
  std::vector<std::size_t> first_row_;  ///< first row of each section
};

/// Angles of one turn, evenly spaced.
void check_turn(const CsvFile& csv, const std::vector<double>& angle, std::vector<Fault>& faults) {
  const std::size_t n = angle.size();
  if (n < kMinAngles) {
    faults.push_back({csv.cell_mark(0, *csv.find("angle")), fmt::format("the pressure has {} angles", n),
                      fmt::format("{} evenly spaced angles over one turn are required", kMinAngles)});
    return;
  }
  const auto uneven = first_uneven(angle, angle.front());
  if (!uneven) return;
  faults.push_back({csv.cell_mark(uneven->place, *csv.find("angle")),
                    fmt::format("angle = {:.6g} degree, where {} angles over one turn have {:.6g} degree",
                                angle[uneven->place], n, uneven->even),
                    "angles rise evenly over one whole turn, each of them once; are they degrees?"});
}

}  // namespace

PressurePointsFile read_pressure_points(const NamedFile& file, const Units& units) {
  const CsvFile csv = read_csv(file);
  std::vector<Fault> faults;
  const std::vector<double> angle = quantity_column(csv, "angle", "degree", "angle [degree]", units, faults);
  PressurePointsFile read;
  read.points.pressure = quantity_column(csv, "pressure", "Pa", "pressure [bar]", units, faults);
  if (faults.empty()) check_turn(csv, angle, faults);
  if (!faults.empty()) throw InputError(faults);
  read.points.first_angle_deg = angle.front();
  read.sha256 = csv.source.sha256;
  read.notes = csv.notes;
  return read;
}

BoreMapFile read_bore_map(const NamedFile& file, const Units& units) {
  const CsvFile csv = read_csv(file);
  std::vector<Fault> faults;
  BoreRows rows(csv, kByHeight, units, faults);
  Sections all;
  if (faults.empty()) all = rows.sections();
  if (!faults.empty()) throw InputError(faults);
  BoreMapFile bore;
  bore.map = {std::move(all.at), all.first_angle_deg, std::move(all.deviation)};
  bore.sha256 = csv.source.sha256;
  bore.notes = csv.notes;
  return bore;
}

DynamicBoreFile read_dynamic_bore(const NamedFile& file, const Units& units) {
  const CsvFile csv = read_csv(file);
  std::vector<Fault> faults;
  BoreRows rows(csv, kByCrankAngle, units, faults);
  DynamicBoreFile bore;
  if (faults.empty()) bore.dynamic = rows.over_cycle(rows.sections());
  if (!faults.empty()) throw InputError(faults);
  bore.sha256 = csv.source.sha256;
  bore.notes = csv.notes;
  return bore;
}

}  // namespace ringfilm::io
