#include "ringfilm/film/wall_transport.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "ringfilm/film/cavitation.hpp"
#include "ringfilm/film/gas_reach.hpp"

namespace ringfilm::film {
namespace {

/// Oil that fills less than this share of the gap lies on the wall alone [-].
constexpr double kOnWallAlone = 1 / kOnWall;
/// A stretch of fewer nodes is as the implicit balance leaves it.
constexpr std::size_t kFewNodes = 3;

/// Nodes of a stretch in gas, in the direction of the motion, with the oil on it.
struct Stretch {
  std::vector<int> nodes;
  std::vector<double> end;       ///< end of each node, from the begin of the first one [m]
  std::vector<double> oil;       ///< up to there, at the begin of the step [kg/m]
  std::vector<double> oil_next;  ///< by the implicit balance [kg/m]
};

/// Oil up to a place: a monotone cubic through the ends of the nodes, so that none is less than no oil.
class OilUpTo {
 public:
  explicit OilUpTo(const Stretch& of) : of_(of), slope_(of.end.size() + 1) {
    const std::size_t n = of.end.size();
    const auto mean = [&](std::size_t i) { return (oil(i + 1) - oil(i)) / (place(i + 1) - place(i)); };
    slope_[0] = mean(0);
    slope_[n] = mean(n - 1);
    for (std::size_t i = 1; i < n; ++i) {
      const double a = mean(i - 1), b = mean(i);
      slope_[i] = a > 0 && b > 0 ? 2 * a * b / (a + b) : 0;
    }
  }

  double operator()(double x) const {
    if (x <= 0) return 0;
    const auto next = std::lower_bound(of_.end.begin(), of_.end.end(), x);
    if (next == of_.end.end()) return of_.oil.back();
    const auto i = static_cast<std::size_t>(next - of_.end.begin());
    const double length = place(i + 1) - place(i), t = (x - place(i)) / length, s = 1 - t;
    return oil(i) * s * s * (1 + 2 * t) + oil(i + 1) * t * t * (3 - 2 * t) +
           length * t * s * (slope_[i] * s - slope_[i + 1] * t);
  }

 private:
  double place(std::size_t i) const { return i == 0 ? 0 : of_.end[i - 1]; }
  double oil(std::size_t i) const { return i == 0 ? 0 : of_.oil[i - 1]; }

  const Stretch& of_;
  std::vector<double> slope_;
};

class Transport {
 public:
  Transport(const FilmProblem& problem, const FilmInputs& inputs, const FilmState& before, FilmState& state)
      : grid_(problem.grid), inputs_(inputs), before_(before), state_(state), reach_(problem.grid, inputs) {}

  /// Oil that has passed the film or blows out behind it, up to the edge.
  void behind(double way, PassedOil& passed) {
    const Stretch on = stretch(inputs_.U > 0 ? grid_.n_cells() - 1 : 1, inputs_.U > 0 ? -1 : 1);
    if (on.nodes.size() < kFewNodes) return;
    const double came = on.oil_next.back() - on.oil.back() + passed.out;
    if (came < 0) return;
    const std::vector<double> moved = moved_by(on, way, came);
    if (!lay(on, moved)) return;
    passed.out += on.oil_next.back() - moved.back();
  }

  /// Oil that comes to the film from the edge at which the wall enters.
  void ahead(double way, const PassedOil& passed) {
    Stretch on = stretch(inputs_.U > 0 ? 1 : grid_.n_cells() - 1, inputs_.U > 0 ? 1 : -1);
    if (on.nodes.size() < kFewNodes || passed.in < 0) return;
    std::vector<double> moved = moved_by(on, way, passed.in);
    // The nodes next to the film have what is left of what the balance has there.
    const double all = on.oil_next.back();
    if (moved.back() < all) {
      for (std::size_t i = moved.size(); i-- > 0;) {
        const double more = all - moved.back(), begin = i == 0 ? 0 : moved[i - 1];
        const double room = std::max(most(on, i) - (moved[i] - begin), 0.0), put = std::min(room, more);
        for (std::size_t k = i; k < moved.size(); ++k) moved[k] += put;
        if (put == more) break;
      }
    } else {
      for (double& one : moved) one = std::min(one, all);
    }
    lay(on, moved);
  }

 private:
  static bool lies_on_wall(double deficit) { return 1 - deficit < kOnWallAlone; }

  /// From an edge inwards as far as all oil lies on the wall, in the direction of the motion.
  Stretch stretch(int from, int inwards) const {
    Stretch on;
    const EdgeState* gas = reach_.gas_at(from);
    if (gas == nullptr || gas->fluid != EdgeFluid::kGas) return on;
    for (int i = from; i > 0 && i < grid_.n_cells() && reach_.gas_at(i) == gas; i += inwards) {
      if (!lies_on_wall(state_.deficit[i]) || !lies_on_wall(before_.deficit[i])) break;
      on.nodes.push_back(i);
    }
    const bool against = (inputs_.U > 0) != (inwards > 0);
    if (against) std::reverse(on.nodes.begin(), on.nodes.end());
    double end = 0, oil = 0, oil_next = 0;
    for (const int i : on.nodes) {
      on.end.push_back(end += grid_.share[i]);
      on.oil.push_back(oil += grid_.share[i] * before_.mass_per_area[i]);
      on.oil_next.push_back(oil_next += grid_.share[i] * state_.mass_per_area[i]);
    }
    return on;
  }

  /// Oil up to the end of each node after the wall has moved on, with what has come evenly over its way.
  static std::vector<double> moved_by(const Stretch& on, double way, double came) {
    const OilUpTo oil(on);
    std::vector<double> moved;
    for (const double end : on.end) moved.push_back(end < way ? came * end / way : came + oil(end - way));
    return moved;
  }

  /// The most oil of a node that lies on the wall alone [kg/m].
  double most(const Stretch& on, std::size_t i) const {
    const int node = on.nodes[i];
    return kOnWallAlone * grid_.share[node] * inputs_.oil->density(state_.p[node]) *
           (state_.h_m + grid_.node_height[node]);
  }

  bool lay(const Stretch& on, const std::vector<double>& moved) {
    double begin = 0;
    for (std::size_t i = 0; i < moved.size(); ++i) {
      if (moved[i] - begin > most(on, i)) return false;
      begin = moved[i];
    }
    begin = 0;
    for (std::size_t i = 0; i < moved.size(); ++i) {
      const int node = on.nodes[i];
      const double oil = std::max(moved[i] - begin, 0.0);
      begin = moved[i];
      state_.mass_per_area[node] = oil / grid_.share[node];
      state_.deficit[node] = 1 - kOnWallAlone * oil / most(on, i);
    }
    return true;
  }

  const FilmGrid& grid_;
  const FilmInputs& inputs_;
  const FilmState& before_;
  FilmState& state_;
  GasReach reach_;
};

}  // namespace

void move_with_wall(const FilmProblem& problem, const FilmInputs& inputs, const FilmState& before, double way,
                    PassedOil& passed, FilmState& state) {
  if (!inputs.has_gas() || !(way > 0)) return;
  Transport transport(problem, inputs, before, state);
  transport.behind(way, passed);
  transport.ahead(way, passed);
}

double spread_debt_in_gas(const FilmProblem& problem, const FilmInputs& inputs, std::vector<double>& remembered) {
  const FilmGrid& grid = problem.grid;
  const GasReach reach(grid, inputs);
  const auto settle = [&](int from, int to, int step) {
    for (int i = from; i != to; i += step) {
      if (remembered[i] >= 0 || reach.gas_at(i) == nullptr || reach.gas_at(i + step) != reach.gas_at(i)) continue;
      remembered[i + step] += remembered[i] * grid.share[i] / grid.share[i + step];
      remembered[i] = 0;
    }
  };
  const int last = grid.n_cells() - 1;
  settle(1, last, 1);
  settle(last, 1, -1);
  return *std::min_element(remembered.begin(), remembered.end());
}

}  // namespace ringfilm::film
