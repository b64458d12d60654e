#include "ringfilm/pad/land_film.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <optional>

#include "ringfilm/base/error.hpp"
#include "ringfilm/base/number_text.hpp"
#include "ringfilm/film/integrals/film2d_integrals.hpp"
#include "ringfilm/film/load_balance.hpp"
#include "ringfilm/film/solver2d/steady_film2d.hpp"
#include "ringfilm/models/oil/lubricant.hpp"
#include "ringfilm/pad/pad_grid_2d.hpp"

namespace ringfilm::pad {
namespace {

constexpr int kMinCells = 12;           // number on the coarsest grid in each direction
constexpr int kMaxNodes = 2'000'000;    // as of a pad
constexpr int kMaxGaps = 60;            // that are tried on the way to a gap
constexpr double kClosest = 0.99;       // ratio of two gaps between which no other one is tried
constexpr double kLandDensity = 850;    // without influence: flows are reported as volumes [kg/m3]
constexpr double kAcrossOverWidth = 2;  // length of a patch across the motion over the width of the land (assumed)
constexpr double kSame = 1e-9;          // lengths that differ by less of themselves are the same

/// A rectangle of the map: its first corner [m].
struct Corner {
  double x, y;
};

/// Heights of the map between its points, which repeats or ends half a step beyond its last points.
class Heights {
 public:
  Heights(const surface::HeightMap& map, film::Ends sides) : map_(map), repeats_(sides == film::Ends::kJoined) {}

  double at(double x, double y) const {
    const Place i = place(x / map_.step_x_m, map_.points_x), j = place(y / map_.step_y_m, map_.points_y);
    const auto height = [&](std::size_t column, std::size_t row) { return map_.height_m[map_.index(column, row)]; };
    const double low = height(i.low, j.low) + i.part * (height(i.high, j.low) - height(i.low, j.low));
    const double high = height(i.low, j.high) + i.part * (height(i.high, j.high) - height(i.low, j.high));
    return low + j.part * (high - low);
  }

 private:
  struct Place {
    std::size_t low, high;
    double part;
  };
  Place place(double at, std::size_t n) const {
    const double nearest = std::round(at);
    if (std::abs(at - nearest) < 1e-6) at = nearest;  // rounding of places that are points
    const auto whole = static_cast<std::size_t>(std::max(0.0, std::floor(at)));
    const double part = std::max(0.0, at) - std::floor(std::max(0.0, at));
    if (repeats_) return {whole % n, (whole + 1) % n, part};
    return {std::min(whole, n - 1), std::min(whole + 1, n - 1), part};
  }

  const surface::HeightMap& map_;
  bool repeats_;
};

/// One patch: its films on ever finer grids.
class Patch {
 public:
  Patch(const LandFilmProblem& land, const Corner& corner, double length, Cells cells) : land_(land) {
    const Heights heights(land.surface, land.sides);
    std::vector<double> x, y, gap;
    for (int i = 0; i <= cells.along; ++i) x.push_back(land.width * i / cells.along);
    for (int j = 0; j <= cells.across; ++j) y.push_back(length * j / cells.across);
    double sum = 0;
    for (const double b : y) {
      for (const double a : x) {
        const double height = heights.at(corner.x + a, corner.y + b);
        highest_ = std::max(highest_, height);
        gap.push_back(-height);
      }
    }
    for (double& one : gap) one += highest_;
    const GapSurface surface(std::move(x), std::move(y), std::move(gap));
    while (true) {
      levels_.push_back(level(surface, cells));
      if (cells.along < 2 * kMinCells || cells.across < 2 * kMinCells) break;
      cells = {cells.along / 2, cells.across / 2};
    }
    std::reverse(levels_.begin(), levels_.end());
    const Level& finest = levels_.back();
    std::size_t node = 0;
    for (const double across : finest.problem.around.share) {
      for (const double along : finest.problem.strip.grid.share)
        sum += across * along * finest.problem.gap.node[node++];
    }
    mean_ = sum / (land.width * length);
    oil_ = models::closed_form_oil(land.viscosity, kLandDensity, 0, {0, 0, 0});
  }

  double highest() const { return highest_; }

  /// The film at a separation, from that of the separation before where there was one: states fall from call to call.
  LandFilmPoint point(double separation) {
    const double h_m = separation - highest_;
    LandFilmPoint of;
    of.separation = separation;
    of.lowest_gap = h_m;
    of.mean_gap = h_m + mean_;
    double coarse_lift = std::nan(""), slow_lift = std::nan("");
    const std::size_t n = levels_.size(), first = films_.empty() || n < 2 ? 0 : n - 2;
    films_.resize(n);
    for (std::size_t k = first; k < n; ++k) {
      std::optional<film::FilmState>& film = films_[k];
      film::FilmState guess = film    ? *film
                              : k > 0 ? refined(levels_[k - 1], *films_[k - 1], levels_[k])
                                      : full(levels_[k], h_m);
      film = closed_in(levels_[k], std::move(guess), h_m, of.iterations);
      // The influence of the speed is that on the grid before the finest, at a fraction of the cost.
      if (k + 2 != n && n > 1) continue;
      coarse_lift = lift(levels_[k], *film);
      film::FilmState slow = *film;
      const film::FilmReport slower = film::solve_steady_film2d(levels_[k].problem, inputs(0.5 * land_.speed), slow);
      if (slower.converged) slow_lift = lift(levels_[k], slow);
    }
    add_integrals(*films_.back(), of);
    of.speed_exponent = coarse_lift > 0 && slow_lift > 0 ? std::log2(coarse_lift / slow_lift)
                                                         : std::numeric_limits<double>::quiet_NaN();
    return of;
  }

 private:
  struct Level {
    film::Film2dProblem problem;
  };

  Level level(const GapSurface& surface, Cells cells) const {
    PadGrid2d grid = pad_grid_2d(surface, cells, land_.sides);
    Level level;
    level.problem.strip.grid = std::move(grid.grid);
    level.problem.around = std::move(grid.around);
    level.problem.gap = std::move(grid.gap);
    return level;
  }

  film::Film2dInputs inputs(double speed) const {
    film::Film2dInputs inputs;
    inputs.strip.oil = oil_;
    inputs.strip.U = speed;
    inputs.strip.left.pressure = inputs.strip.right.pressure = land_.ambient_pressure;
    inputs.strip.p_cavitation = land_.cavitation_pressure;
    inputs.p_low = inputs.p_high = land_.ambient_pressure;
    inputs.strip.load = std::max(land_.ambient_pressure - land_.cavitation_pressure, kMinScale) * land_.width;
    return inputs;
  }

  film::FilmState full(const Level& level, double h_m) const {
    film::FilmState state;
    state.h_m = h_m;
    state.p.assign(level.problem.n_nodes(), land_.ambient_pressure);
    state.deficit.assign(level.problem.n_nodes(), 0.0);
    return state;
  }

  /// The film at the lowest gap h_m from a film at another one, by gaps between them where the cavities of the one do
  /// not lead to those of the other.
  film::FilmState closed_in(const Level& level, film::FilmState from, double h_m, int& iterations) const {
    std::vector<double> gaps{h_m};
    film::FilmState film = std::move(from);
    double reached = film.h_m;
    for (int tried = 0; !gaps.empty(); ++tried) {
      film::FilmState next = film;
      next.h_m = gaps.back();
      const film::FilmReport report = film::solve_steady_film2d(level.problem, inputs(land_.speed), next);
      iterations = report.iterations;
      if (report.converged) {
        film = std::move(next);
        reached = gaps.back();
        gaps.pop_back();
      } else if (tried == 0) {  // begin with a wide gap, full of oil
        reached = std::max(reached, h_m) + mean_;
        film = full(level, reached);
        gaps.push_back(reached);
      } else if (tried < kMaxGaps && gaps.back() < kClosest * reached) {
        gaps.push_back(std::sqrt(reached * gaps.back()));
      } else {
        throw ConvergenceError("no steady film of the land was found at a lowest gap of " + surface::length_text(h_m) +
                               "; larger separations, or a coarser map, have one");
      }
    }
    return film;
  }

  /// The film of a coarser grid, at the nodes of a finer one.
  film::FilmState refined(const Level& coarse, const film::FilmState& state, const Level& fine) const {
    const std::vector<double>&from_x = coarse.problem.strip.grid.x, &from_y = coarse.problem.around.y;
    const std::vector<double>&to_x = fine.problem.strip.grid.x, &to_y = fine.problem.around.y;
    film::FilmState guess;
    guess.h_m = state.h_m;
    for (const double y : to_y) {
      const auto [j, v] = between(from_y, y);
      for (const double x : to_x) {
        const auto [i, u] = between(from_x, x);
        const std::size_t low = j * from_x.size() + i, high = low + from_x.size();
        const auto& p = state.p;
        guess.p.push_back((1 - v) * ((1 - u) * p[low] + u * p[low + 1]) + v * ((1 - u) * p[high] + u * p[high + 1]));
        guess.deficit.push_back(state.deficit[(v < 0.5 ? low : high) + (u < 0.5 ? 0 : 1)]);
      }
    }
    return guess;
  }
  static std::pair<std::size_t, double> between(const std::vector<double>& nodes, double at) {
    const auto after = std::upper_bound(nodes.begin() + 1, nodes.end() - 1, at) - nodes.begin();
    const auto first = static_cast<std::size_t>(after) - 1;
    return {first, std::clamp((at - nodes[first]) / (nodes[first + 1] - nodes[first]), 0.0, 1.0)};
  }

  double lift(const Level& level, const film::FilmState& state) const {
    double sum = 0;
    std::size_t node = 0;
    for (const double across : level.problem.around.share) {
      for (const double along : level.problem.strip.grid.share) {
        sum += across * along * (state.p[node++] - land_.ambient_pressure);
      }
    }
    return sum / (land_.width * level.problem.around.length);
  }

  void add_integrals(const film::FilmState& state, LandFilmPoint& of) const {
    const Level& finest = levels_.back();
    const film::Film2dIntegrals sums = film::film2d_integrals(finest.problem, inputs(land_.speed), state, state);
    of.lift = lift(finest, state);
    of.friction_stress = (sums.mean.shear_couette + sums.mean.shear_poiseuille) / land_.width;
    of.flow = sums.mean.flow_right / (kLandDensity * land_.speed);
    const auto empty = std::count_if(state.deficit.begin(), state.deficit.end(), [](double d) { return d > 0; });
    of.cavitated_fraction = static_cast<double>(empty) / static_cast<double>(state.deficit.size());
  }

  static constexpr double kMinScale = 1e4;  // scale of pressures, where ambient is the cavitation pressure [Pa]

  const LandFilmProblem& land_;
  std::vector<Level> levels_;                          // from the coarsest on
  std::vector<std::optional<film::FilmState>> films_;  // film of the last separation on each level
  std::shared_ptr<const models::OilAtTemperature> oil_;
  double highest_ = -std::numeric_limits<double>::infinity(), mean_ = 0;
};

double rms(const std::vector<double>& heights) {
  double squares = 0;
  for (const double height : heights) squares += height * height;
  return std::sqrt(squares / static_cast<double>(heights.size()));
}

void check_land_map(const LandFilmProblem& land) {
  const surface::HeightMap& map = land.surface;
  surface::check_map(map);
  if (map.is_profile()) {
    throw InputError("the surface is a profile, and the film of a land has two dimensions",
                     "name the map of an area with --surface");
  }
  if (surface::measured_points(map) < map.points()) {
    throw InputError(std::to_string(map.points() - surface::measured_points(map)) +
                         " points of the surface have no height, and the film needs the gap everywhere",
                     "name a map whose gaps are filled, or a part of it that is measured as a whole");
  }
  const double length = static_cast<double>(map.points_x) * map.step_x_m;
  if (land.width > length * (1 + kSame)) {
    throw InputError("the land is " + surface::length_text(land.width) + " wide, and the map is " +
                         surface::length_text(length) + " long along its rows",
                     "name a larger map, or a --width of at most that length; rows are along the motion");
  }
}

/// Corners of at most so many patches of the map that do not overlap, evenly among all.
std::vector<Corner> corners(const LandFilmProblem& land, double length) {
  const surface::HeightMap& map = land.surface;
  const double map_x = static_cast<double>(map.points_x) * map.step_x_m;
  const double map_y = static_cast<double>(map.points_y) * map.step_y_m;
  const int n_x = std::max(1, static_cast<int>(map_x / land.width * (1 + kSame)));
  const int n_y = std::max(1, static_cast<int>(map_y / length * (1 + kSame)));
  std::vector<Corner> all, chosen;
  for (int j = 0; j < n_y; ++j) {
    for (int i = 0; i < n_x; ++i) all.push_back({i * land.width, j * length});
  }
  const std::size_t n = all.size(), count = std::min<std::size_t>(n, static_cast<std::size_t>(land.patches));
  for (std::size_t k = 0; k < count; ++k) chosen.push_back(all[k * n / count]);
  return chosen;
}

void check_separations(const LandFilmProblem& land, double highest) {
  std::vector<Fault> faults;
  for (const double separation : land.separations) {
    if (separation - highest >= film::kMolecules) continue;
    faults.push_back({{},
                      "at a separation of " + surface::length_text(separation) +
                          " the surfaces touch: the highest point of the map is " + surface::length_text(highest) +
                          " above the mean plane, a lowest gap of " + surface::length_text(separation - highest),
                      "state separations above " + surface::length_text(highest + 0.02e-6) +
                          " (a lowest gap of 20 nm); ringfilm contact computes what carries below"});
  }
  if (!faults.empty()) throw InputError(faults);
}

/// Mean and standard deviation over the patches of a member.
void average(const std::vector<LandFilmPoint>& of, double LandFilmPoint::*member, double& mean, double* deviation) {
  double sum = 0, squares = 0, n = 0;
  for (const LandFilmPoint& one : of) {
    if (std::isnan(one.*member)) continue;
    sum += one.*member;
    n += 1;
  }
  mean = n > 0 ? sum / n : std::numeric_limits<double>::quiet_NaN();
  if (deviation == nullptr || n < 2) return;
  for (const LandFilmPoint& one : of) squares += (one.*member - mean) * (one.*member - mean);
  *deviation = std::sqrt(squares / (n - 1));
}

LandFilmPoint mean_of(const std::vector<LandFilmPoint>& patches) {
  LandFilmPoint of;
  of.separation = patches.front().separation;
  using P = LandFilmPoint;
  average(patches, &P::lift, of.lift, &of.lift_scatter);
  average(patches, &P::friction_stress, of.friction_stress, &of.friction_scatter);
  for (double P::*member : {&P::flow, &P::mean_gap, &P::cavitated_fraction, &P::speed_exponent}) {
    average(patches, member, of.*member, nullptr);
  }
  of.lowest_gap = patches.front().lowest_gap;
  for (const LandFilmPoint& one : patches) {
    of.lowest_gap = std::min(of.lowest_gap, one.lowest_gap);
    of.iterations = std::max(of.iterations, one.iterations);
  }
  return of;
}

}  // namespace

LandFilm land_film(const LandFilmProblem& land) {
  check_land_map(land);
  const surface::HeightMap& map = land.surface;
  const double map_y = static_cast<double>(map.points_y) * map.step_y_m;
  LandFilm result;
  // A map that repeats is taken over all of its period.
  result.patch_length = land.sides == film::Ends::kJoined ? map_y : std::min(map_y, kAcrossOverWidth * land.width);
  const Cells cells{std::max(2, static_cast<int>(std::ceil(land.width / map.step_x_m * (1 - kSame)))),
                    std::max(2, static_cast<int>(std::ceil(result.patch_length / map.step_y_m * (1 - kSame))))};
  if (static_cast<double>(cells.along + 1) * (cells.across + 1) > kMaxNodes) {
    throw InputError("a patch has " + std::to_string(cells.along) + " x " + std::to_string(cells.across) +
                         " points, and two million are the most",
                     "state a --short-cutoff and name a coarser map");
  }
  result.cells_along = cells.along;
  result.cells_across = cells.across;
  result.roughness = rms(map.height_m);
  const std::vector<Corner> places = corners(land, result.patch_length);
  result.patches = static_cast<int>(places.size());
  result.highest = *std::max_element(map.height_m.begin(), map.height_m.end());
  std::vector<std::vector<LandFilmPoint>> of_separation(land.separations.size());
  // The highest point of the map bounds those of all patches: nothing is computed before the separations are checked.
  check_separations(land, result.highest);
  std::vector<std::size_t> falling(land.separations.size());
  std::iota(falling.begin(), falling.end(), std::size_t{0});
  std::stable_sort(falling.begin(), falling.end(),
                   [&](std::size_t a, std::size_t b) { return land.separations[a] > land.separations[b]; });
  for (const Corner& corner : places) {
    Patch patch(land, corner, result.patch_length, cells);
    for (const std::size_t k : falling) of_separation[k].push_back(patch.point(land.separations[k]));
  }
  for (const std::vector<LandFilmPoint>& patches : of_separation) result.points.push_back(mean_of(patches));
  return result;
}

}  // namespace ringfilm::pad
