#include "ringfilm/life/wear/wear_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "ringfilm/cycle/setup/setup.hpp"

namespace ringfilm::life {
namespace {

struct Place {
  double x, y;
};

/// Is `b` not below the line from `a` to `c`?
bool is_above(const Place& a, const Place& b, const Place& c) {
  return (b.y - a.y) * (c.x - a.x) >= (c.y - a.y) * (b.x - a.x);
}

/// Corners of the lower convex hull of places with increasing x.
std::vector<Place> lower_hull(const std::vector<Place>& places) {
  std::vector<Place> hull;
  for (const Place& place : places) {
    while (hull.size() >= 2 && is_above(hull[hull.size() - 2], hull.back(), place)) hull.pop_back();
    hull.push_back(place);
  }
  return hull;
}

/// The line that lies above all places and is lowest at `at`: the edge of their upper hull there.
struct Line {
  double at_middle, slope;
};
Line lowest_line_above(std::vector<Place> places, double at) {
  for (Place& place : places) place.y = -place.y;
  const std::vector<Place> hull = lower_hull(places);
  std::size_t k = 1;
  while (k + 1 < hull.size() && hull[k].x < at) ++k;
  const double slope = -(hull[k].y - hull[k - 1].y) / (hull[k].x - hull[k - 1].x);
  return {-hull[k].y - slope * hull[k].x, slope};
}

/// Trapezoidal rule over neighbouring places.
double area_under(const std::vector<Place>& places) {
  std::vector<double> x, y;
  for (const Place& place : places) {
    x.push_back(place.x);
    y.push_back(place.y);
  }
  return life::area_under(x, y);
}

}  // namespace

FaceHeights face_heights(const cycle::Case& c, cycle::HeightZero zero) {
  constexpr int kCells = 2400;  // 0.5 um of a face of 1.2 mm
  const models::RingFace given = cycle::prepare(c).ring.face;
  const bool is_turned = c.ring.face.orientation == cycle::Orientation::kX0Crankcase;
  const models::RingFace face = is_turned ? given.turned() : given;
  const double lowest = zero == cycle::HeightZero::kMinimum ? face.minimum().height : 0, width = c.ring.face_width;
  FaceHeights heights;
  for (int i = 0; i <= kCells; ++i) {
    heights.x.push_back(i == kCells ? width : width * i / kCells);
    heights.height.push_back(face.height(heights.x.back()) - lowest);
  }
  return heights;
}

Gain largest_gain(const FaceHeights& earlier, const FaceHeights& later) {
  Gain gain{0, earlier.height[0] - later.height[0]};
  for (std::size_t i = 1; i < earlier.x.size(); ++i) {
    const double height = earlier.height[i] - later.height[i];
    if (height > gain.height) gain = {earlier.x[i], height};
  }
  return gain;
}

FaceHeights turned(const FaceHeights& face) {
  FaceHeights other;
  other.x.assign(face.x.rbegin(), face.x.rend());
  for (double& x : other.x) x = face.width() - x;
  other.height.assign(face.height.rbegin(), face.height.rend());
  return other;
}

WearBound least_wear(const FaceHeights& earlier, const FaceHeights& later, double margin, Tilt tilt) {
  if (earlier.x.size() != later.x.size()) throw std::invalid_argument("faces at other places");
  const double middle = 0.5 * earlier.width();
  std::vector<Place> gained;  // that offset and tilt must outweigh, over the trusted part
  for (std::size_t i = 0; i < earlier.x.size(); ++i) {
    const double x = earlier.x[i];
    constexpr double kRounding = 1e-12;
    if (x < margin - kRounding || x > earlier.width() - margin + kRounding) continue;
    gained.push_back({x - middle, earlier.height[i] - later.height[i]});
  }
  // The area is least where the line is lowest at the mean place of the trusted part, its middle.
  Line line{std::max_element(gained.begin(), gained.end(), [](const Place& a, const Place& b) { return a.y < b.y; })->y,
            0};
  if (tilt == Tilt::kFree) line = lowest_line_above(gained, 0);
  WearBound bound;
  bound.margin = margin;
  bound.tilt = std::atan(line.slope);
  for (Place& place : gained) {
    place.y = line.at_middle + line.slope * place.x - place.y;
    bound.largest_depth = std::max(bound.largest_depth, place.y);
  }
  bound.depth_at_middle = gained[gained.size() / 2].y;
  bound.area = area_under(gained);
  return bound;
}

double area_under(const std::vector<double>& x, const std::vector<double>& y) {
  double sum = 0;
  for (std::size_t i = 1; i < x.size(); ++i) sum += 0.5 * (y[i] + y[i - 1]) * (x[i] - x[i - 1]);
  return sum;
}

const std::vector<double>& trusted_margins() {
  static const std::vector<double> margins = {0, 1.0 / 20, 1.0 / 12, 1.0 / 4};
  return margins;
}

std::vector<ConcaveStretch> concave_stretches(const FaceHeights& face, double least) {
  std::vector<Place> places;
  for (std::size_t i = 0; i < face.x.size(); ++i) places.push_back({face.x[i], face.height[i]});
  const std::vector<Place> hull = lower_hull(places);
  std::vector<ConcaveStretch> stretches;
  for (std::size_t k = 1; k < hull.size(); ++k) {
    ConcaveStretch stretch{hull[k - 1].x, hull[k].x, 0};
    for (const Place& place : places) {
      if (place.x <= stretch.from || place.x >= stretch.to) continue;
      const double share = (place.x - stretch.from) / (stretch.to - stretch.from);
      stretch.height = std::max(stretch.height, place.y - ((1 - share) * hull[k - 1].y + share * hull[k].y));
    }
    if (stretch.height >= least) stretches.push_back(stretch);
  }
  return stretches;
}

}  // namespace ringfilm::life
