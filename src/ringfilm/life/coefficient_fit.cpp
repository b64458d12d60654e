#include "ringfilm/life/coefficient_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ringfilm/base/error.hpp"
#include "ringfilm/base/table.hpp"
#include "ringfilm/life/duty_wear.hpp"
#include "ringfilm/life/wear/face_distance.hpp"
#include "ringfilm/life/wear/wear_bounds.hpp"

namespace ringfilm::life {
namespace {

/// Share of the roughness below which the heights of a face about a straight line count as nothing.
constexpr double kFlat = 0.1;

/// What a measured face requires of a scenario: an area, or to be as close as possible.
struct Target {
  FittedCoefficient row;
  std::vector<double> face;  ///< measured face at the nodes, for FitBasis::kClosestFace [m]
};

/// The face after some wear, on the way to all targets.
struct PathPoint {
  double clock = 0;  ///< integral of the coefficient over the running time [m2 s/N]
  double area = 0;   ///< [m2]
  std::vector<double> height;
};

/// Where a path between two faces is closest to a third: its squared distance is a parabola of the share of the way.
struct Closest {
  double share = 0, square = 0;  ///< share of the way [-]; square of the rms distance [m2]
};
Closest closest_between(double at_start, double halfway, double at_end) {
  const double bend = 2 * (at_start - 2 * halfway + at_end), slope = 4 * halfway - 3 * at_start - at_end;
  double share = at_end < at_start ? 1 : 0;
  if (bend > 0) share = std::clamp(-0.5 * slope / bend, 0.0, 1.0);
  return {share, std::max(0.0, at_start + share * (slope + share * bend))};
}

class Fit {
 public:
  Fit(const Life& life, const CycleIntegrators& integrators, PackGas& gas)
      : life_(frozen(life)), wear_(life_, integrators, gas) {}

  CoefficientFit run() {
    const std::vector<Target> targets = targets_of_faces();
    follow_faces(targets);
    CoefficientFit fit;
    fit.range = {std::numeric_limits<double>::infinity(), 0};
    fit.largest_area = path_.back().area;
    for (const Target& target : targets) {
      FittedCoefficient row = target.row;
      const std::optional<double> clock = target.face.empty() ? clock_at(row.worn_area) : closest(target, row);
      if (clock && *clock > 0 && row.worn_area > kNegligibleArea) row.coefficient = *clock / row.time;
      fit.rows.push_back(row);
      if (!row.coefficient || row.time != life_.states.back().time) continue;
      fit.range.low = std::min(fit.range.low, *row.coefficient);
      fit.range.high = std::max(fit.range.high, *row.coefficient);
    }
    if (fit.range.high == 0) {
      throw ConvergenceError(
          "no wear coefficient leads from the first to the last measured face: the face of the base "
          "case is worn through, or nothing wears it");
    }
    fit.cycles = wear_.cycles();
    return fit;
  }

 private:
  static Life frozen(Life life) {
    life.wear.surface = WornSurface::kFrozen;
    life.wear.coefficient = 1e-15;  // any: the clock is its integral
    life.wear.liner_coefficient.reset();
    return life;
  }

  std::vector<Target> targets_of_faces() const {
    std::vector<Target> targets;
    const FaceHeights first = face_heights(life_.states.front().input);
    for (std::size_t i = 1; i < life_.states.size(); ++i) {
      const MeasuredState& state = life_.states[i];
      const FaceHeights face = face_heights(state.input);
      for (const double share : trusted_margins()) {
        const WearBound bound = least_wear(first, face, share * first.width(), Tilt::kFree);
        targets.push_back({{state.time, FitBasis::kMinWear, bound.margin, bound.area, {}, {}}, {}});
      }
      std::vector<double> at_nodes;
      for (const double x : wear_.face().x()) at_nodes.push_back(interpolate_linear(face.x, face.height, x));
      for (const double half_width : compared_half_widths()) {
        if (half_width > 0.5 * face.width()) continue;
        targets.push_back({{state.time, FitBasis::kClosestFace, half_width, 0, {}, {}}, at_nodes});
      }
    }
    return targets;
  }

  /// Until the face has lost the largest area of the targets and moves away from all the faces that it shall approach.
  void follow_faces(const std::vector<Target>& targets) {
    double largest = 0;
    for (const Target& target : targets) largest = std::max(largest, target.row.worn_area);
    PathPoint start;
    start.height = wear_.face().heights(std::vector<double>(wear_.face().n_nodes(), 0.0), 0);
    path_ = {start};
    WearLimits limits;
    limits.deepest = life_.wear.coating_thickness.value_or(kAssumedCoating);
    limits.after_jump = [this](const WornDepths& now) {
      path_.push_back(
          {coefficient_integral(life_.wear, 0, now.time), wear_.area(now.face), wear_.face().heights(now.face, 0)});
    };
    limits.is_enough = [&] {
      return path_.back().area >= largest && std::all_of(targets.begin(), targets.end(), [this](const Target& target) {
               return target.face.empty() || moves_away(target) || is_flat(target, path_.back().height);
             });
    };
    try {
      integrate_wear(
          life_.wear, {kMaxTime}, wear_.face().n_nodes(), 0, [this](const WornDepths& now) { return wear_.load(now); },
          limits);
    } catch (const ConvergenceError&) {
      if (path_.back().area < largest) throw;  // else the path ends where a deeper face has no cycle
    }
  }

  double square_distance(const Target& target, const std::vector<double>& height) const {
    const double rms = rms_distance(wear_.face().x(), height, target.face, target.row.trusted);
    return rms * rms;
  }

  bool moves_away(const Target& target) const {
    const std::size_t n = path_.size();
    return n > 1 && square_distance(target, path_[n - 1].height) > square_distance(target, path_[n - 2].height);
  }

  /// Is a face of the scenario a straight line over the width that is compared, beside its roughness? From then on its
  /// distance is that of the measured face from its own line.
  bool is_flat(const Target& target, const std::vector<double>& height) const {
    const std::vector<double> line(height.size(), 0.0);
    return rms_distance(wear_.face().x(), height, line, target.row.trusted) < kFlat * wear_.roughness_at({});
  }

  /// When the face has lost an area; nothing where the path ended before.
  std::optional<double> clock_at(double area) const {
    if (area <= kNegligibleArea) return std::nullopt;
    for (std::size_t i = 1; i < path_.size(); ++i) {
      if (path_[i].area < area) continue;
      const double share = (area - path_[i - 1].area) / (path_[i].area - path_[i - 1].area);
      return path_[i - 1].clock + share * (path_[i].clock - path_[i - 1].clock);
    }
    return std::nullopt;
  }

  /// When it is closest to a measured face; nothing where that is before any wear or at the end of the path.
  std::optional<double> closest(const Target& target, FittedCoefficient& row) const {
    if (path_.size() < 2) return std::nullopt;
    double least = square_distance(target, path_[0].height);
    double way = 0;  // in jumps
    for (std::size_t i = 1; i < path_.size(); ++i) {
      const PathPoint &from = path_[i - 1], &to = path_[i];
      std::vector<double> halfway;
      for (std::size_t k = 0; k < to.height.size(); ++k) halfway.push_back(0.5 * (from.height[k] + to.height[k]));
      const Closest there = closest_between(square_distance(target, from.height), square_distance(target, halfway),
                                            square_distance(target, to.height));
      if (there.square >= least) continue;
      least = there.square;
      way = static_cast<double>(i - 1) + there.share;
    }
    const std::size_t before = std::min(static_cast<std::size_t>(way), path_.size() - 2);
    const double share = way - static_cast<double>(before);
    const PathPoint &from = path_[before], &to = path_[before + 1];
    row.rms = std::sqrt(least);
    row.worn_area = from.area + share * (to.area - from.area);
    row.is_flat = is_flat(target, share < 1 ? from.height : to.height);
    if (row.is_flat || way == static_cast<double>(path_.size() - 1)) return std::nullopt;
    return from.clock + share * (to.clock - from.clock);
  }

  Life life_;
  DutyWear wear_;
  std::vector<PathPoint> path_;
};

}  // namespace

CoefficientFit fit_coefficient(const Life& life, const CycleIntegrators& integrators, PackGas& gas) {
  return Fit(life, integrators, gas).run();
}

}  // namespace ringfilm::life
