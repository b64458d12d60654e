#include "ringfilm/life/coefficient_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ringfilm/base/table.hpp"
#include "ringfilm/life/duty_wear.hpp"
#include "ringfilm/life/wear/face_distance.hpp"
#include "ringfilm/life/wear/wear_bounds.hpp"

namespace ringfilm::life {
namespace {

/// What a measured face requires of a scenario: an area, or to be as close as possible.
struct Target {
  FittedCoefficient row;
  std::vector<double> face;  ///< of FittedCoefficient::Basis::kClosestFace, at the nodes [m]
};

/// The face after some wear, on the way to all targets.
struct Waypoint {
  double clock = 0;  ///< integral of the coefficient over the running time [m2 s/N]
  double area = 0;   ///< [m2]
  std::vector<double> height;
};

class Fit {
 public:
  Fit(const Life& life, const CycleIntegrators& integrators) : life_(frozen(life)), wear_(life_, integrators) {}

  CoefficientFit run() {
    const std::vector<Target> targets = targets_of_faces();
    double largest = 0;
    for (const Target& target : targets) largest = std::max(largest, target.row.worn_area);
    pass_faces_until(largest);
    CoefficientFit fit;
    fit.range = {std::numeric_limits<double>::infinity(), 0};
    fit.largest_area = path_.back().area;
    for (const Target& target : targets) {
      FittedCoefficient row = target.row;
      const std::optional<double> clock = target.face.empty() ? clock_at(row.worn_area) : closest(target, row);
      if (clock) row.coefficient = *clock / row.time;
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
        targets.push_back({{state.time, FitBasis::kLeastWear, bound.margin, bound.area, {}, {}}, {}});
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

  void pass_faces_until(double largest) {
    Waypoint start;
    start.height = wear_.face().heights(std::vector<double>(wear_.face().n_nodes(), 0.0), 0);
    path_ = {start};
    WearLimits limits;
    limits.deepest = life_.wear.coating_thickness.value_or(kAssumedCoating);
    limits.after_jump = [this](const WornDepths& now) {
      path_.push_back(
          {coefficient_integral(life_.wear, 0, now.time), wear_.area(now.face), wear_.face().heights(now.face, 0)});
    };
    limits.is_enough = [this, largest] { return path_.back().area >= largest; };
    integrate_wear(
        life_.wear, {kLongestTime}, wear_.face().n_nodes(), 0,
        [this](double time, const std::vector<double>& worn) { return wear_.load(time, worn); }, limits);
  }

  /// When the face has lost an area; nothing where the path ended before.
  std::optional<double> clock_at(double area) const {
    for (std::size_t i = 1; i < path_.size(); ++i) {
      if (path_[i].area < area) continue;
      const double share = (area - path_[i - 1].area) / (path_[i].area - path_[i - 1].area);
      return path_[i - 1].clock + share * (path_[i].clock - path_[i - 1].clock);
    }
    return std::nullopt;
  }

  /// When it is closest to a measured face; nothing where that is before any wear.
  std::optional<double> closest(const Target& target, FittedCoefficient& row) const {
    double least = std::numeric_limits<double>::infinity();
    std::size_t at = 0;
    for (std::size_t i = 0; i < path_.size(); ++i) {
      const double rms = rms_distance(wear_.face().x(), path_[i].height, target.face, row.trusted);
      if (rms >= least) continue;
      least = rms;
      at = i;
    }
    row.rms = least;
    row.worn_area = path_[at].area;
    if (at == 0) return std::nullopt;
    return path_[at].clock;
  }

  Life life_;
  DutyWear wear_;
  std::vector<Waypoint> path_;
};

}  // namespace

CoefficientFit fit_coefficient(const Life& life, const CycleIntegrators& integrators) {
  return Fit(life, integrators).run();
}

}  // namespace ringfilm::life
