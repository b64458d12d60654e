#include "ringfilm/instrument/grid/height_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "ringfilm/base/display.hpp"

namespace ringfilm::instrument {
namespace {

using surface::HeightMap;
using Weight = Doubt::Weight;

constexpr std::size_t kMinPoints = 8;    // fewest points of a map that is judged
constexpr std::size_t kMinLine = 5;      // fewest points of a row or column that is judged
constexpr double kUnequal = 1e-3;        // share of a step: places stored in single precision are even to that
constexpr std::size_t kSample = 65536;   // points from which the bulk of the heights is found
constexpr std::size_t kFrequent = 10;    // times of a value that may not be by chance
constexpr std::size_t kNeighbours = 10;  // values above and below with which it is compared
constexpr double kTimesUsual = 3;        // as often as its neighbours: digits scatter less
constexpr double kScatter = 8;           // standard deviations of a count above it
constexpr double kFewRepeats = 0.1;      // share of the lines; more of them are a ruled surface, or interpolated
constexpr double kFewFar = 0.01;         // share of the points; more of them, of many values, are a structure
constexpr std::size_t kFewValues = 3;    // distinct values that may mark points without a height

constexpr double kSteep = 3;  // rms slope, 72 degree: optical instruments end below, and styli far below
constexpr double kImpossibleSlope = 100;
constexpr double kHighShare = 0.1;    // Sq over the longer side: a plane tilted by 19 degree has that
constexpr double kAtom_m = 0.05e-9;   // rms roughness of cleaved mica and of polished silicon
constexpr double kNothing_m = 1e-12;  // rms roughness below every instrument's resolution
constexpr double kSharp = 100;        // sigma over beta; white noise of rms slope 3 has 17

constexpr char kMask[] = "write nan in place of these points, or mask them in the program that wrote the file";

std::string place(const HeightMap& map, std::size_t point) {
  if (map.is_profile()) return fmt::format("point {}", point + 1);
  return fmt::format("row {}, column {}", point / map.points_x + 1, point % map.points_x + 1);
}

/// In the unit of the file, where the user reads the number.
std::string shown(double height_m, const HeightUnit& unit) {
  return fmt::format("{:.6g} {}", height_m / unit.size_m, unit.name);
}

/// A row or a column of a map.
class Line {
 public:
  Line(const HeightMap& map, bool is_row, std::size_t number)
      : map_(map),
        first_(is_row ? number * map.points_x : number),
        stride_(is_row ? 1 : map.points_x),
        size_(is_row ? map.points_x : map.points_y) {}

  std::size_t size() const { return size_; }
  std::optional<double> at(std::size_t i) const {
    const std::size_t point = first_ + i * stride_;
    if (!map_.measured(point)) return std::nullopt;
    return map_.height_m[point];
  }

 private:
  const HeightMap& map_;
  std::size_t first_, stride_, size_;
};

/// The one value of a line, if all its measured points have it.
std::optional<double> constant_of(const Line& line) {
  std::optional<double> value;
  std::size_t measured = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const std::optional<double> height = line.at(i);
    if (!height) continue;
    if (value && *value != *height) return std::nullopt;
    value = height;
    ++measured;
  }
  if (measured < kMinLine) return std::nullopt;
  return value;
}

struct Sequence {
  double first = 0, last = 0, step = 0;
  /// Does its lower end lie at 0 or at its own step, as that of counts and most axes does?
  bool counts() const {
    const double low = step > 0 ? first : last, size = std::abs(step);
    return std::min(std::abs(low), std::abs(low - size)) <= kUnequal * size;
  }
};

/// The points from..to of a line as a sequence of even steps, or of even steps that were rounded to some digit.
std::optional<Sequence> sequence_of(const Line& line, std::size_t from, std::size_t to) {
  if (to < from + kMinLine) return std::nullopt;
  const std::optional<double> first = line.at(from), last = line.at(to - 1);
  if (!first || !last || *first == *last) return std::nullopt;
  const Sequence found{*first, *last, (*last - *first) / static_cast<double>(to - 1 - from)};
  const double slack = kUnequal * std::abs(found.step);
  double least = std::numeric_limits<double>::infinity(), most = -least, before = *first;
  for (std::size_t i = from + 1; i < to; ++i) {
    const std::optional<double> here = line.at(i);
    if (!here) return std::nullopt;
    const double even = found.first + found.step * static_cast<double>(i - from);
    if (!(std::abs(*here - even) <= 0.5 * std::abs(found.step))) return std::nullopt;
    least = std::min(least, *here - before);
    most = std::max(most, *here - before);
    before = *here;
  }
  const double rounding = most - least;
  if (!(least * most > 0) || rounding > 0.5 * std::abs(found.step)) return std::nullopt;
  before = *first;
  for (std::size_t i = from + 1; i < to; ++i) {  // rounding leaves two gaps, and no place further off than one digit
    const double gap = *line.at(i) - before, even = found.first + found.step * static_cast<double>(i - from);
    before += gap;
    if (std::min(gap - least, most - gap) > slack || std::abs(before - even) > rounding + slack) return std::nullopt;
  }
  return found;
}

/// The corner where a row and a column of places meet may hold anything.
std::optional<Sequence> sequence_of(const Line& line) {
  for (const auto& [from, to] :
       {std::pair<std::size_t, std::size_t>{0, line.size()}, {1, line.size()}, {0, line.size() - 1}}) {
    if (const auto found = sequence_of(line, from, to)) return found;
  }
  return std::nullopt;
}

/// Which rows and columns do not belong to a measured surface.
struct OddLines {
  std::vector<std::uint8_t> row, column;  ///< 1: odd; empty: none is
  std::vector<Doubt> doubts;

  bool contains(const HeightMap& map, std::size_t point) const {
    return (!row.empty() && row[point / map.points_x] != 0) || (!column.empty() && column[point % map.points_x] != 0);
  }
};

std::vector<std::size_t> points_of_lines(const HeightMap& map, bool is_row, const std::vector<std::size_t>& lines) {
  std::vector<std::size_t> points;
  for (const std::size_t k : lines) {
    for (std::size_t i = 0; i < (is_row ? map.points_x : map.points_y); ++i) {
      points.push_back(is_row ? map.index(i, k) : map.index(k, i));
    }
  }
  return points;
}

/// The lines of one direction. Where half of them are straight, the surface is: nothing is odd then.
void find_odd_lines(const HeightMap& map, bool is_row, const HeightUnit& unit, OddLines& odd) {
  const std::size_t count = is_row ? map.points_y : map.points_x;
  const char* const word = is_row ? "row" : "column";
  std::vector<std::optional<double>> constant(count);
  std::vector<std::optional<Sequence>> sequence(count);
  std::vector<std::size_t> constants;
  std::size_t straight = 0, varied = 0;
  bool same = true;
  for (std::size_t k = 0; k < count; ++k) {
    const Line line(map, is_row, k);
    constant[k] = constant_of(line);
    if (!constant[k]) sequence[k] = sequence_of(line);
    if (constant[k]) {
      constants.push_back(k);
      same = same && *constant[k] == *constant[constants.front()];
    }
    const bool is_straight = constant[k] || sequence[k];
    straight += is_straight ? 1 : 0;
    varied += is_straight ? 0 : 1;
  }
  const bool few = 2 * straight < count;
  std::vector<std::uint8_t>& mark = is_row ? odd.row : odd.column;
  const auto set = [&](std::size_t k) {
    if (mark.empty()) mark.assign(count, 0);
    mark[k] = 1;
  };
  if (!constants.empty() && varied > 0 && (few || same)) {
    for (const std::size_t k : constants) set(k);
    const std::size_t first = constants.front();
    const std::string value = shown(*constant[first], unit);
    odd.doubts.push_back({constants.size() == 1
                              ? fmt::format("{} {} holds one value throughout, {}", word, first + 1, value)
                              : fmt::format("{} {}s hold one value throughout, the first of them {} {}: {}",
                                            constants.size(), word, word, first + 1, value),
                          std::string("if it was not measured, remove it or ") + kMask, Weight::kNote,
                          points_of_lines(map, is_row, constants)});
  }
  if (!few) return;
  const auto from_edge = [&](bool from_start) {
    for (std::size_t n = 0; n < count; ++n) {
      const std::size_t k = from_start ? n : count - 1 - n;
      if (constant[k]) continue;
      if (!sequence[k]) return;
      set(k);
      odd.doubts.push_back({fmt::format("{} {} goes in even steps from {} to {}: its values are numbers or places, not "
                                        "heights",
                                        word, k + 1, shown(sequence[k]->first, unit), shown(sequence[k]->last, unit)),
                            fmt::format("remove this {} from the file", word),
                            sequence[k]->counts() ? Weight::kRefusal : Weight::kNote});
    }
  };
  from_edge(true);
  from_edge(false);
}

/// Is a line that is not straight the same as the one before it, point for point?
bool repeats_last(const HeightMap& map, bool is_row, std::size_t k) {
  const Line line(map, is_row, k), last(map, is_row, k - 1);
  std::size_t measured = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line.at(i) != last.at(i)) return false;
    if (line.at(i)) ++measured;
  }
  return measured >= kMinLine && !constant_of(line) && !sequence_of(line);
}

/// Lines that an instrument or a program wrote twice.
void find_repeated_lines(const HeightMap& map, bool is_row, std::vector<Doubt>& doubts) {
  const std::size_t count = is_row ? map.points_y : map.points_x;
  const char* const word = is_row ? "row" : "column";
  std::vector<std::size_t> repeated;
  for (std::size_t k = 1; k < count; ++k) {
    if (repeats_last(map, is_row, k)) repeated.push_back(k);
  }
  if (repeated.empty() || static_cast<double>(repeated.size()) > kFewRepeats * static_cast<double>(count)) return;
  doubts.push_back({fmt::format("{} {} repeats the one before it, point for point{}", word, repeated.front() + 1,
                                repeated.size() == 1 ? "" : fmt::format(", and so do {} more", repeated.size() - 1)),
                    fmt::format("a {} that was lost or written twice: measure again, or remove it", word)});
}

OddLines odd_lines(const HeightMap& map, const HeightUnit& unit) {
  OddLines odd;
  if (!map.is_profile()) {
    find_odd_lines(map, true, unit, odd);
    find_odd_lines(map, false, unit, odd);
    find_repeated_lines(map, true, odd.doubts);
    find_repeated_lines(map, false, odd.doubts);
  } else if (const auto places = sequence_of(Line(map, true, 0))) {
    odd.doubts.push_back({fmt::format("all heights go in even steps from {} to {}, as numbers or places do",
                                      shown(places->first, unit), shown(places->last, unit)),
                          "name the columns of places and heights in the first line, for example: x [um],z [um]"});
  }
  return odd;
}

/// Range of the heights without those far from the rest.
struct Bulk {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
};

/// Every n-th height, rising.
std::vector<double> sample_of(const HeightMap& map, const OddLines& odd) {
  const std::size_t stride = map.points() / kSample + 1;
  std::vector<double> value;
  for (std::size_t i = 0; i < map.points(); i += stride) {
    if (map.measured(i) && !odd.contains(map, i)) value.push_back(map.height_m[i]);
  }
  std::sort(value.begin(), value.end());
  return value;
}

/// A value and how many points have it.
struct Repeated {
  double value = 0;
  std::size_t times = 0;
};

/// Rising values, each once.
std::vector<Repeated> counted(const std::vector<double>& rising) {
  std::vector<Repeated> values;
  for (auto from = rising.begin(); from != rising.end();) {
    const auto to = std::upper_bound(from, rising.end(), *from);
    values.push_back({*from, static_cast<std::size_t>(to - from)});
    from = to;
  }
  return values;
}

/// The densest half of the distinct heights of a sample, each value counted once however often it occurs.
std::optional<Bulk> densest_half(std::vector<double> value) {
  value.erase(std::unique(value.begin(), value.end()), value.end());
  if (value.size() < kMinPoints) return std::nullopt;
  const std::size_t half = value.size() / 2;
  std::size_t best = 0;
  for (std::size_t i = 0; i + half < value.size(); ++i) {
    if (value[i + half] - value[i] < value[best + half] - value[best]) best = i;
  }
  return Bulk{value[best], value[best + half]};
}

/// Widened from the densest half as long as the next height is closer than all of the bulk is wide.
/// @param tail takes the heights outside of it, rising
Bulk bulk_of(const HeightMap& map, const OddLines& odd, const std::vector<double>& sample, std::vector<double>& tail) {
  const std::optional<Bulk> half = densest_half(sample);
  if (!half) return {};
  const double reach = 2 * (half->high - half->low);
  Bulk bulk = *half;
  for (std::size_t i = 0; i < map.points(); ++i) {
    if (!map.measured(i) || odd.contains(map, i)) continue;
    const double z = map.height_m[i];
    if (z < half->low - reach || z > half->high + reach) {
      tail.push_back(z);
    } else {
      bulk.low = std::min(bulk.low, z);
      bulk.high = std::max(bulk.high, z);
    }
  }
  std::sort(tail.begin(), tail.end());
  auto above = std::upper_bound(tail.begin(), tail.end(), bulk.high);
  auto below = std::lower_bound(tail.begin(), tail.end(), bulk.low);
  for (bool wider = true; wider;) {
    wider = false;
    for (; above != tail.end() && *above - bulk.high <= bulk.high - bulk.low; ++above) {
      wider = true;
      bulk.high = *above;
    }
    for (; below != tail.begin() && bulk.low - *(below - 1) <= bulk.high - bulk.low; --below) {
      wider = true;
      bulk.low = *(below - 1);
    }
  }
  tail.erase(below, above);
  return bulk;
}

std::vector<std::size_t> points_with(const HeightMap& map, const OddLines& odd, double value) {
  std::vector<std::size_t> points;
  for (std::size_t i = 0; i < map.points(); ++i) {
    if (map.measured(i) && map.height_m[i] == value && !odd.contains(map, i)) points.push_back(i);
  }
  return points;
}

/// What lies on one side of the bulk, rising.
void add_far_heights(const HeightMap& map, const OddLines& odd, const Bulk& bulk, const std::vector<double>& far,
                     const HeightUnit& unit, std::vector<Doubt>& doubts) {
  if (far.empty()) return;
  const std::vector<Repeated> all = counted(far);
  const auto [repeated, most] =
      *std::max_element(all.begin(), all.end(), [](const Repeated& a, const Repeated& b) { return a.times < b.times; });
  std::vector<double> values = far;
  const auto distinct = static_cast<std::size_t>(std::unique(values.begin(), values.end()) - values.begin());
  const double share = static_cast<double>(far.size()) / static_cast<double>(map.points());
  if (distinct > kFewValues && share > kFewFar) return;  // grooves, steps: part of the surface
  const std::string others =
      fmt::format("the rest lies between {} and {}", shown(bulk.low, unit), shown(bulk.high, unit));
  std::vector<std::size_t> points = points_with(map, odd, repeated);
  const std::string where = place(map, points.front());
  if (most > 1) {
    doubts.push_back({fmt::format("{} points far from the rest repeat one value, {}, the first of them {}; {}", most,
                                  shown(repeated, unit), where, others),
                      std::string("if the value marks points without a height, ") + kMask, Weight::kNote,
                      std::move(points)});
  } else {
    doubts.push_back(
        {fmt::format("{} far from the rest, for example {} in {}; {}",
                     far.size() == 1 ? std::string("1 height lies") : fmt::format("{} heights lie", far.size()),
                     shown(repeated, unit), where, others),
         std::string("if they are not part of the surface, ") + kMask});
  }
}

/// How often each of the values next to one occurs, the mean over up to kNeighbours on both sides.
double times_of_neighbours(const std::vector<Repeated>& values, std::size_t of) {
  const std::size_t from = of > kNeighbours ? of - kNeighbours : 0, to = std::min(of + kNeighbours + 1, values.size());
  std::size_t sum = 0;
  for (std::size_t i = from; i < to; ++i) sum += i == of ? 0 : values[i].times;
  return static_cast<double>(sum) / static_cast<double>(to - from - 1);
}

/// Values within the range of the others that are far more frequent than their neighbours: no data, or a range that
/// ended. Many of them are the digits of the instrument.
void add_frequent_values(const HeightMap& map, const OddLines& odd, const Bulk& bulk, const std::vector<double>& sample,
                         const HeightUnit& unit, std::vector<Doubt>& doubts) {
  const std::vector<Repeated> values = counted(sample);
  std::vector<std::size_t> frequent;
  for (std::size_t i = 0; i < values.size() && values.size() > kNeighbours; ++i) {
    if (values[i].times < kFrequent || values[i].value < bulk.low || values[i].value > bulk.high) continue;
    const double usual = times_of_neighbours(values, i), times = static_cast<double>(values[i].times);
    if (times >= kTimesUsual * usual && times >= usual + kScatter * std::sqrt(usual)) frequent.push_back(i);
  }
  if (frequent.size() > kFewValues) return;
  for (const std::size_t i : frequent) {
    const double share = static_cast<double>(values[i].times) / static_cast<double>(sample.size());
    const char* const end = i == 0 ? ", the lowest value" : i + 1 == values.size() ? ", the highest value" : "";
    doubts.push_back(
        {fmt::format("{:.2g} % of the heights are {}{}, the first of them {}, and the values next to it are {:.0f} "
                     "times rarer",
                     100 * share, shown(values[i].value, unit), end,
                     place(map, points_with(map, odd, values[i].value).front()),
                     static_cast<double>(values[i].times) / times_of_neighbours(values, i)),
         std::string("if the value marks points without a height or the end of the range, ") + kMask});
  }
}

/// Sums over the points that `use` lets through.
struct Extent {
  double Sq_m = 0;
  double rms_slope = 0;
  double curvature_per_m = 0;  ///< rms of the second differences along the rows over the square of the step
};

template <class Use>
Extent extent_of(const HeightMap& map, const Use& use) {
  double count = 0, mean = 0, squares = 0;  // Welford: heights may be far from zero
  double slopes[2] = {0, 0}, pairs[2] = {0, 0}, curvatures = 0, triples = 0;
  for (std::size_t j = 0; j < map.points_y; ++j) {
    for (std::size_t i = 0; i < map.points_x; ++i) {
      const std::size_t here = map.index(i, j);
      if (!use(here)) continue;
      const double z = map.height_m[here];
      count += 1;
      const double off = z - mean;
      mean += off / count;
      squares += off * (z - mean);
      const auto slope = [&](std::size_t next, double step, int along) {
        if (!use(next)) return;
        const double of = (map.height_m[next] - z) / step;
        slopes[along] += of * of;
        pairs[along] += 1;
      };
      if (i + 1 < map.points_x) slope(here + 1, map.step_x_m, 0);
      if (j + 1 < map.points_y) slope(map.index(i, j + 1), map.step_y_m, 1);
      if (i > 0 && i + 1 < map.points_x && use(here - 1) && use(here + 1)) {
        const double of = (map.height_m[here - 1] - 2 * z + map.height_m[here + 1]) / (map.step_x_m * map.step_x_m);
        curvatures += of * of;
        triples += 1;
      }
    }
  }
  const auto mean_of = [](double sum, double number) { return number > 0 ? sum / number : 0; };
  return {std::sqrt(mean_of(squares, count)), std::sqrt(mean_of(slopes[0], pairs[0]) + mean_of(slopes[1], pairs[1])),
          std::sqrt(mean_of(curvatures, triples))};
}

double longer_side(const HeightMap& map) {
  const double x = map.step_x_m * static_cast<double>(map.points_x);
  return map.is_profile() ? x : std::max(x, map.step_y_m * static_cast<double>(map.points_y));
}

bool is_impossible(const Extent& of, const HeightMap& map) {
  return of.rms_slope > kImpossibleSlope || of.Sq_m > longer_side(map);
}

void add_size_doubts(const Extent& of, const HeightMap& map, std::vector<Doubt>& doubts) {
  const char* const symbol = map.is_profile() ? "Rq" : "Sq";
  const std::string units = "the unit of the heights or the step is wrong: state the right one";
  if (of.rms_slope > kSteep) {
    doubts.push_back({fmt::format("the rms slope is {:.4g}, and no surface can be measured that is steeper than {}",
                                  of.rms_slope, kSteep),
                      units});
  } else if (of.Sq_m > kHighShare * longer_side(map)) {
    doubts.push_back({fmt::format("{} is {}, more than {} of the length of {}", symbol, surface::length_text(of.Sq_m),
                                  kHighShare, surface::length_text(longer_side(map))),
                      units});
  } else if (of.Sq_m == 0) {
    doubts.push_back({"all heights are equal", "is it the right file or channel?"});
  } else if (of.Sq_m < kAtom_m) {
    doubts.push_back({fmt::format("{} is {}: such heights are below the size of an atom ({} is the smoothest surface)",
                                  symbol, text_in(of.Sq_m, kNanometre, 3), text_in(kAtom_m, kNanometre)),
                      "the unit of the heights is wrong: state the right one",
                      of.Sq_m < kNothing_m ? Weight::kRefusal : Weight::kNote});
  } else if (const double ratio = of.Sq_m * of.curvature_per_m * 8 / (3 * std::sqrt(std::numbers::pi));
             ratio > kSharp) {  // beta = 3 sqrt(pi) / (8 sqrt(m4)), eq-asperity-radius
    doubts.push_back({fmt::format("sigma/beta is {:.4g} as read; no surface has more than {}", ratio, kSharp), units});
  }
}

/// A value that repeats far from the rest, or throughout a line, and makes the map impossible is not a height: its
/// points are missing. The map is refused where it is impossible without them, too.
void weigh_impossible(const HeightMap& map, const Extent& whole, std::vector<Doubt>& doubts) {
  std::vector<std::uint8_t> mark(map.points(), 0);
  for (const Doubt& doubt : doubts) {
    for (const std::size_t point : doubt.points) mark[point] = 1;
  }
  const Extent rest = extent_of(map, [&](std::size_t i) { return map.measured(i) && mark[i] == 0; });
  const bool is_refused = is_impossible(rest, map);
  for (Doubt& doubt : doubts) {
    if (doubt.points.empty() && !is_refused) continue;
    doubt.weight = is_refused ? Weight::kRefusal : Weight::kMissing;
    doubt.message += fmt::format("; with all points the rms height is {} and the rms slope {:.3g}",
                                 surface::length_text(whole.Sq_m), whole.rms_slope);
    if (!is_refused) {
      doubt.message += ": these points were taken as missing";
      doubt.remedy =
          std::string("if they are heights, the unit or the step is wrong: state the right one; else ") + kMask;
    }
  }
}

/// A single value in front of a profile may be its length [mm or um].
void add_length_doubt(const HeightMap& map, const HeightUnit& unit, std::vector<Doubt>& doubts) {
  if (!map.is_profile() || !map.measured(0)) return;
  const double first = map.height_m[0] / unit.size_m;
  for (const auto& [word, size_m] : {std::pair("mm", 1e-3), std::pair("um", 1e-6)}) {
    for (const std::size_t left_out : {1u, 2u}) {
      const double length = map.step_x_m * static_cast<double>(map.points_x - left_out);
      if (!(std::abs(first * size_m - length) <= 1e-6 * length)) continue;
      doubts.push_back({fmt::format("the first value, {:.6g}, is the length of the profile in {}", first, word),
                        "if it is not a height, remove it, or start its line with #"});
      return;
    }
  }
}

}  // namespace

std::vector<Doubt> height_doubts(const HeightMap& map, const HeightUnit& unit) {
  if (measured_points(map) < kMinPoints) return {};
  OddLines odd = odd_lines(map, unit);
  std::vector<Doubt> doubts = std::move(odd.doubts);
  std::vector<double> tail;
  const std::vector<double> sample = sample_of(map, odd);
  const Bulk bulk = bulk_of(map, odd, sample, tail);
  const auto split = std::lower_bound(tail.begin(), tail.end(), bulk.low);
  add_far_heights(map, odd, bulk, {tail.begin(), split}, unit, doubts);
  add_far_heights(map, odd, bulk, {split, tail.end()}, unit, doubts);
  add_frequent_values(map, odd, bulk, sample, unit, doubts);
  const auto measured = [&map](std::size_t i) { return map.measured(i); };
  const Extent whole = extent_of(map, measured);
  if (doubts.empty()) {
    add_size_doubts(whole, map, doubts);
  } else {
    // What is odd is judged by itself, and the rest without it.
    const Extent rest = extent_of(map, [&](std::size_t i) {
      return map.measured(i) && !odd.contains(map, i) && map.height_m[i] >= bulk.low && map.height_m[i] <= bulk.high;
    });
    if (is_impossible(whole, map)) weigh_impossible(map, whole, doubts);
    add_size_doubts(rest, map, doubts);
  }
  add_length_doubt(map, unit, doubts);
  return doubts;
}

void set_missing(surface::HeightMap& map, const std::vector<std::size_t>& points) {
  if (map.missing.empty()) map.missing.assign(map.points(), 0);
  for (const std::size_t point : points) {
    map.missing[point] = 1;
    map.height_m[point] = 0;
  }
}

std::vector<Doubt> count_doubts(const std::vector<double>& value) {
  const auto is_count = [](double v) { return v >= 2 && v == std::floor(v) && v < 1e9; };
  for (std::size_t head = 1; head <= 3 && head + kMinPoints <= value.size(); ++head) {
    const auto rest = static_cast<double>(value.size() - head);
    double counts = 0, product = 1;
    std::string factors;
    for (std::size_t i = 0; i < head; ++i) {
      if (!is_count(value[i])) continue;
      if (value[i] == rest) counts = value[i];
      product *= value[i];
      factors += fmt::format("{}{:.0f}", factors.empty() ? "" : " x ", value[i]);
      if (counts == 0 && product == rest) counts = product;
    }
    if (counts == 0) continue;
    const bool is_map = std::find(value.begin(), value.begin() + static_cast<std::ptrdiff_t>(head), rest) ==
                        value.begin() + static_cast<std::ptrdiff_t>(head);
    const auto [low, high] = std::minmax_element(value.begin() + static_cast<std::ptrdiff_t>(head), value.end());
    bool is_far = false;
    std::string values;
    for (std::size_t i = 0; i < head; ++i) {
      is_far = is_far || value[i] > *high + (*high - *low);
      values += fmt::format("{}{:.6g}", values.empty() ? "" : ", ", value[i]);
    }
    return {{head == 1 ? fmt::format("the first value, {}, is the number of the values behind it", values)
                       : fmt::format("the first {} values, {}, state the number of the values behind them, {:.0f}",
                                     head, values, rest),
             is_map ? "if the values behind them are those of a map of " + factors +
                          " points, write a row of the map a line, without the counts"
                    : std::string("they are not heights if they are the head of the file: start their lines with #"),
             is_far ? Weight::kRefusal : Weight::kNote}};
  }
  return {};
}

}  // namespace ringfilm::instrument
