#include "ringfilm/models/conformity/free_shape.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <string>

#include "ringfilm/base/display.hpp"
#include "ringfilm/base/error.hpp"

namespace ringfilm::models {
namespace {

using std::numbers::pi;

constexpr double kArc = 0.02;  // longest piece of a centroid that is taken as an arc [rad]
/// Places along the ring follow from lengths, whose errors add up: they count a tenth of distances from it.
constexpr double kWeightAlong = 0.1;

/// A section of the free ring: its centroid and the direction of its normal.
struct Section {
  double x, y, direction;
};

/// By how much the free ring is turned against the closed one from its end to phi, the integral of its curvature [rad].
double rotation(const RingBeam& beam, double phi) {
  const double r = beam.centroid_radius();
  const double force = beam.target_force().integral(beam.half_gap(), phi);
  return (beam.target_moment_slope(phi) - r * force) / (beam.stiffness() * r);
}

/// The end of an arc of the centroid. @param step over it [rad]
Section after_arc(const Section& from, double r, double step, double direction) {
  const double half = (direction - from.direction) / 2, middle = from.direction + half;
  const double chord = r * step * (std::abs(half) < 1e-8 ? 1 : std::sin(half) / half);
  return {from.x - chord * std::sin(middle), from.y + chord * std::cos(middle), direction};
}

ShapePoint on_surface(const Section& at, double half_thickness) {
  return {at.x + half_thickness * std::cos(at.direction), at.y + half_thickness * std::sin(at.direction)};
}

/// These places and as many between them as arcs ask for. `kept` has where they are.
std::vector<double> refined(const std::vector<double>& phi, std::vector<std::size_t>& kept) {
  std::vector<double> all;
  for (std::size_t i = 0; i < phi.size(); ++i) {
    if (i > 0) {
      const int pieces = std::max(1, static_cast<int>(std::ceil((phi[i] - phi[i - 1]) / kArc)));
      for (int k = 1; k < pieces; ++k) all.push_back(phi[i - 1] + (phi[i] - phi[i - 1]) * k / pieces);
    }
    kept.push_back(all.size());
    all.push_back(phi[i]);
  }
  return all;
}

/// What is measured of the shape itself: how long it is up to each point, and which way it looks there.
struct MeasuredLine {
  std::vector<double> length;     ///< along the running surface [m]
  std::vector<double> direction;  ///< direction of the normal, without jumps [rad]
};

MeasuredLine measured_line(const std::vector<ShapePoint>& points) {
  MeasuredLine line{{0}, {}};
  std::vector<double> chords, of_chords;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const double dx = points[i + 1].x - points[i].x, dy = points[i + 1].y - points[i].y;
    chords.push_back(std::hypot(dx, dy));
    const double raw = std::atan2(dy, dx) - pi / 2;
    of_chords.push_back(of_chords.empty() ? raw : raw - 2 * pi * std::round((raw - of_chords.back()) / (2 * pi)));
  }
  // An arc is longer than its chord by the square of its turn, that between the chords beside it.
  for (std::size_t i = 0; i < chords.size(); ++i) {
    const std::size_t low = std::max<std::size_t>(i, 1) - 1, high = std::min(i + 1, chords.size() - 1);
    const double turn = (of_chords[high] - of_chords[low]) / static_cast<double>(high - low);
    line.length.push_back(line.length.back() + chords[i] * (1 + turn * turn / 24));
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t last = of_chords.size() - 1, k = std::clamp<std::size_t>(i, 1, last);
    // Chords look as their middles do; in between and beyond them the direction is continued straight.
    const double from = (line.length[k - 1] + line.length[k]) / 2, to = (line.length[k] + line.length[k + 1]) / 2;
    const double share = (line.length[i] - from) / (to - from);
    line.direction.push_back(of_chords[k - 1] + share * (of_chords[k] - of_chords[k - 1]));
  }
  return line;
}

/// Where the points are on the ring: lengths of its centroid, half of which lies on either side of the back [rad].
std::vector<double> places_of(const RingBeamSize& size, const std::vector<ShapePoint>& points) {
  const double r = size.centroid_radius();
  const MeasuredLine line = measured_line(points);
  std::vector<double> length;
  for (std::size_t i = 0; i < points.size(); ++i) {
    length.push_back(line.length[i] - size.centroid_depth() * (line.direction[i] - line.direction.front()));
  }
  std::vector<double> phi;
  for (const double one : length) phi.push_back(pi + (one - length.back() / 2) / r);
  return phi;
}

void check_points(const RingBeamSize& size, const std::vector<ShapePoint>& points, int last_order) {
  const auto needed = static_cast<std::size_t>(kPointsOfWave * std::max(last_order, kPointsOfWave));
  if (points.size() >= needed) return;
  throw InputError("the free shape has " + std::to_string(points.size()) + " points, fewer than the " +
                       std::to_string(needed) + " that order " + std::to_string(last_order) + " of its pressure needs",
                   "measure more points from end to end of the ring, or smooth over a longer length than " +
                       text_in(pi * (size.bore - size.radial_thickness) / last_order, kMillimetre));
}

void check_length(const RingBeamSize& size, const std::vector<double>& phi) {
  constexpr double kMax = 2e-3;
  const double r = size.centroid_radius(), length = r * (phi.back() - phi.front());
  const double expected = 2 * pi * r - size.end_gap;
  const bool rises = std::is_sorted(phi.begin(), phi.end());
  if (rises && std::abs(length - expected) <= kMax * expected) return;
  throw InputError("the free shape does not close: its centroid is " + text_in(length, kMillimetre) +
                       " long, that of the closed ring " + text_in(expected, kMillimetre),
                   "give points of the running surface from one end of the ring to the other, in the sense of the "
                   "angle, and the end gap of the closed ring");
}

RingBeam unit_beam(RingBeamSize size, const FourierSeries& orders) {
  size.tangential_force = 1;
  return {size, orders};
}

/// Target, place and direction of a ring that is nearest to points.
class NearestShape {
 public:
  NearestShape(const RingBeamSize& size, const std::vector<ShapePoint>& points, int last_order)
      : points_(points),
        r_(size.centroid_radius()),
        half_thickness_(size.centroid_depth()),
        phi_(places_of(size, points)) {
    check_length(size, phi_);
    fine_ = refined(phi_, kept_);
    append_turns(unit_beam(size, {}), nullptr);
    for (int n = 2; n <= last_order; ++n) {
      for (const double phase : {0.0, pi / (2 * n)}) {
        append_turns(unit_beam(size, FourierSeries({{n, 1, phase}})), &turns_.front());
      }
    }
    place_roughly();
  }

  /// By Gauss and Newton. @returns whether nothing changes any more, at a shape of this ring
  bool solve() {
    constexpr int kMaxSteps = 40;
    bool is_at_rest = false;
    for (int step = 0; step < kMaxSteps; ++step) {
      linearise();
      const Eigen::VectorXd change = A_.ldlt().solve(b_);
      double moved = 0;
      for (std::size_t k = 0; k < unknowns_.size(); ++k) {
        unknowns_[k] += scale_[k] * change[k];
        moved = std::max(moved, std::abs(change[k]) / std::sqrt(static_cast<double>(points_.size())));
      }
      if (!std::isfinite(moved)) return false;
      is_at_rest = moved < 1e-12;  // [m]
      if (is_at_rest) break;
    }
    linearise();
    return is_at_rest && residual() < 1e-3;  // [m]; more is another shape
  }

  /// Force of the mean pressure, then of the orders' cosines and sines [N].
  double force(std::size_t k) const { return unknowns_[kRigid + k]; }
  double residual() const { return std::sqrt(sum_ / static_cast<double>(points_.size())); }

  /// Standard deviations of these forces.
  std::vector<double> deviations() const {
    const auto left = static_cast<double>(points_.size()) - static_cast<double>(unknowns_.size());
    const double variance = left > 0 ? sum_ / left : std::numeric_limits<double>::infinity();
    const Eigen::MatrixXd inverse = A_.ldlt().solve(Eigen::MatrixXd::Identity(A_.rows(), A_.cols()));
    std::vector<double> all;
    for (std::size_t k = kRigid; k < unknowns_.size(); ++k) {
      all.push_back(scale_[k] * std::sqrt(variance * inverse(k, k)));
    }
    return all;
  }

 private:
  /// Unknowns of the rigid position: first point of the centroid line (x, y) and direction.
  static constexpr std::size_t kRigid = 3;

  void append_turns(const RingBeam& beam, const std::vector<double>* mean) {
    std::vector<double> turns;
    for (std::size_t i = 0; i < fine_.size(); ++i) {
      turns.push_back(rotation(beam, fine_[i]) - (mean ? (*mean)[i] : 0));
    }
    turns_.push_back(std::move(turns));
  }

  /// As a closed ring about the mean of the points, turned as the quarters lie.
  void place_roughly() {
    const std::size_t n = points_.size();
    const ShapePoint &low = points_[n / 4], &high = points_[n - 1 - n / 4];
    unknowns_.assign(kRigid + turns_.size(), 0.0);
    const double direction =
        std::atan2(high.y - low.y, high.x - low.x) - (phi_[n / 4] + phi_[n - 1 - n / 4]) / 2 + 3 * pi / 2;
    unknowns_[2] = direction;
    double x = 0, y = 0;
    for (std::size_t i = 0; i < n; ++i) {
      x += (points_[i].x - r_ * std::cos(direction + phi_[i])) / static_cast<double>(n);
      y += (points_[i].y - r_ * std::sin(direction + phi_[i])) / static_cast<double>(n);
    }
    unknowns_[0] = x + r_ * std::cos(direction + phi_.front());
    unknowns_[1] = y + r_ * std::sin(direction + phi_.front());
  }

  double direction_at(std::size_t i) const {
    double direction = unknowns_[2] + fine_[i];
    for (std::size_t k = 0; k < turns_.size(); ++k) direction += unknowns_[kRigid + k] * turns_[k][i];
    return direction;
  }

  /// Distances of the points, what each unknown changes of them, and the normal equations of both.
  void linearise() {
    const std::size_t n = unknowns_.size();
    std::vector<std::vector<double>> rows;
    std::vector<double> missed;
    // Displacement of the centroid by direction and forces.
    std::vector<double> moved_x(n - 2, 0.0), moved_y(n - 2, 0.0);
    Section at{unknowns_[0], unknowns_[1], direction_at(0)};
    sum_ = 0;
    for (std::size_t i = 0, next = 0; i < fine_.size(); ++i) {
      if (i > 0) {
        const double step = fine_[i] - fine_[i - 1];
        const Section to = after_arc(at, r_, step, direction_at(i));
        const double half = r_ * step / 2, c_0 = half * std::cos(at.direction), s_0 = half * std::sin(at.direction);
        const double c_1 = half * std::cos(to.direction), s_1 = half * std::sin(to.direction);
        for (std::size_t k = 0; k + 2 < n; ++k) {
          const double before = turn(k, i - 1), after = turn(k, i);
          moved_x[k] -= before * c_0 + after * c_1;
          moved_y[k] -= before * s_0 + after * s_1;
        }
        at = to;
      }
      if (i != kept_[next]) continue;
      const ShapePoint on = on_surface(at, half_thickness_), &point = points_[next++];
      const double c = std::cos(at.direction), s = std::sin(at.direction);
      const double off = (point.x - on.x) * c + (point.y - on.y) * s,
                   along = (point.y - on.y) * c - (point.x - on.x) * s;
      sum_ += off * off;
      std::vector<double> normal{c, s}, tangent{-kWeightAlong * s, kWeightAlong * c};
      for (std::size_t k = 0; k + 2 < n; ++k) {
        normal.push_back(moved_x[k] * c + moved_y[k] * s);
        tangent.push_back(kWeightAlong * (moved_y[k] * c - moved_x[k] * s + half_thickness_ * turn(k, i)));
      }
      rows.push_back(std::move(normal));
      rows.push_back(std::move(tangent));
      missed.push_back(off);
      missed.push_back(kWeightAlong * along);
      if (next == kept_.size()) break;
    }
    sum_up(rows, missed);
  }

  /// Rotation at arc i by the direction of the whole ring (k = 0), then by each force.
  double turn(std::size_t k, std::size_t i) const { return k == 0 ? 1 : turns_[k - 1][i]; }

  void sum_up(const std::vector<std::vector<double>>& rows, const std::vector<double>& missed) {
    const std::size_t n = unknowns_.size();
    scale_.assign(n, 0.0);
    for (const std::vector<double>& row : rows) {
      for (std::size_t k = 0; k < n; ++k) scale_[k] += row[k] * row[k];
    }
    for (double& scale : scale_) scale = 1 / std::sqrt(scale);
    A_.setZero(n, n);
    b_.setZero(n);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      for (std::size_t k = 0; k < n; ++k) {
        const double value = scale_[k] * rows[i][k];
        b_[k] += value * missed[i];
        for (std::size_t l = 0; l <= k; ++l) A_(k, l) += value * scale_[l] * rows[i][l];
      }
    }
  }

  const std::vector<ShapePoint>& points_;
  double r_, half_thickness_;
  std::vector<double> phi_;                 ///< angles of the points [rad]
  std::vector<double> fine_;                ///< angles of the points and of the arcs between them [rad]
  std::vector<std::size_t> kept_;           ///< which of these the points are
  std::vector<std::vector<double>> turns_;  ///< by each unit of force, at the places of arcs [rad/N]
  std::vector<double> unknowns_, scale_;
  Eigen::MatrixXd A_;  ///< matrix of the normal equations, lower half
  Eigen::VectorXd b_;
  double sum_ = 0;  ///< sum of the squared distances [m2]
};

}  // namespace

std::vector<ShapePoint> free_shape(const RingBeam& beam, const std::vector<double>& phi) {
  std::vector<double> places = phi;
  const auto at_back = std::lower_bound(places.begin(), places.end(), pi);
  const auto back = static_cast<std::size_t>(at_back - places.begin());
  places.insert(at_back, pi);
  std::vector<std::size_t> kept;
  const std::vector<double> fine = refined(places, kept);
  const double r = beam.centroid_radius(), turned = rotation(beam, pi);
  const auto direction = [&](double place) { return place + rotation(beam, place) - turned; };
  std::vector<Section> sections{{0, 0, direction(fine.front())}};
  for (std::size_t i = 1; i < fine.size(); ++i) {
    sections.push_back(after_arc(sections.back(), r, fine[i] - fine[i - 1], direction(fine[i])));
  }
  const Section& opposite = sections[kept[back]];
  std::vector<ShapePoint> points;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    if (i == back) continue;
    Section at = sections[kept[i]];
    at.x -= opposite.x + r;
    at.y -= opposite.y;
    points.push_back(on_surface(at, beam.size().centroid_depth()));
  }
  return points;
}

FreeShapeFit target_of_free_shape(const RingBeamSize& size, const std::vector<ShapePoint>& points, int last_order) {
  check_points(size, points, last_order);
  NearestShape nearest(size, points, last_order);
  const bool is_found = nearest.solve();
  FreeShapeFit fit;
  fit.tangential_force = nearest.force(0);
  if (!is_found || !(fit.tangential_force > 0)) {
    throw InputError("the free shape is not that of a ring that presses outwards all in all: its tangential force is " +
                         number_text(fit.tangential_force) + " N, and its points are " +
                         text_in(nearest.residual(), kMicrometre) + " (rms) from the shape of this force",
                     "list the points of the running surface from one end of the ring to the other in the sense of the "
                     "angle; check their unit");
  }
  fit.residual = nearest.residual();
  const std::vector<double> deviation = nearest.deviations();
  fit.force_deviation = deviation.front() / fit.tangential_force;
  std::vector<FourierOrder> orders;
  double variance = 0;
  for (int n = 2; n <= last_order; ++n) {
    const std::size_t k = 2 * static_cast<std::size_t>(n) - 3;
    const double cosine = nearest.force(k) / fit.tangential_force, sine = nearest.force(k + 1) / fit.tangential_force;
    orders.push_back({n, std::hypot(cosine, sine), std::atan2(sine, cosine) / n});
    variance += (deviation[k] * deviation[k] + deviation[k + 1] * deviation[k + 1]) / 2;
  }
  fit.pressure_deviation = std::sqrt(variance) / fit.tangential_force;
  fit.pressure_orders = FourierSeries(std::move(orders));
  return fit;
}

}  // namespace ringfilm::models
