#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <numbers>
#include <random>
#include <vector>

#include "ringfilm/models/conformity/ring_closure.hpp"

/// Rings in random bores: each closure must be found and meet all conditions of contact.
/// usage: random_closures [COUNT [SEED]]
namespace {

using namespace ringfilm::models;

constexpr double kTurn = 2 * std::numbers::pi;

/// Bores from 0.03 um to contact in points alone, orders 1 to 14; rings with and without gas, gap and orders.
class RandomClosures {
 public:
  explicit RandomClosures(unsigned seed) : random_(seed) {}

  RingAtWall next() {
    const double scale = std::pow(10, -7.5 + 3.5 * share());
    std::vector<FourierOrder> bore, pressure;
    for (int left = 1 + whole(4); left > 0; --left) {
      const int n = 1 + whole(share() < 0.2 ? 14 : 6);
      bore.push_back({n, scale * (share() - 0.3) * 40 / std::pow(n, 3), kTurn * share()});
    }
    if (share() < 0.5) pressure = {{2 + whole(5), 0.8 * (share() - 0.5), kTurn * share()}};
    const double diameter = 0.05 + 0.1 * share();
    const RingBeamSize size{diameter,
                            1e-3 + 2e-3 * share(),
                            diameter / (20 + 15 * share()),
                            share() < 0.5 ? 203e9 : 110e9,
                            5 + 20 * share(),
                            share() < 0.1 ? 0 : 1e-3 * share()};
    const double gas_pressure = share() < 0.4 ? 0 : std::pow(10, 2 + 4.5 * share());
    return {RingBeam(size, FourierSeries(pressure)), FourierSeries(bore),
            gas_pressure * size.face_width * diameter / 2};
  }

 private:
  double share() { return std::uniform_real_distribution<double>(0, 1)(random_); }
  int whole(int below) { return static_cast<int>(below * share()); }

  std::mt19937 random_;
};

bool meets_all_conditions(const RingClosure& closure) {
  const double largest = closure.largest_clearance().clearance;
  const double force = closure.ring().beam().size().tangential_force + closure.ring().gas();
  bool holds = closure.unbalanced_share() <= 1e-6 * force;
  for (const LiftOff& span : closure.lift_offs()) holds = holds && span.smallest().clearance >= -1e-7 * largest;
  for (const PointForce& one : closure.point_forces()) holds = holds && one.force > 0;
  for (const ContactArc& arc : closure.arcs()) {
    for (int k = 0; k <= 40; ++k) {
      holds = holds && closure.line_force(arc.from + (arc.to - arc.from) * k / 40) >=
                           -1e-4 * force;  // between the places at which the search looks
    }
  }
  return holds;
}

}  // namespace

int main(int argc, char** argv) {
  const int count = argc > 1 ? std::atoi(argv[1]) : 20000;
  const unsigned seed = argc > 2 ? static_cast<unsigned>(std::atoi(argv[2])) : 1;
  RandomClosures closures(seed);
  int n_faults = 0;
  double longest = 0;
  const auto begin = std::chrono::steady_clock::now();
  const auto seconds_since = [](const auto& then) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - then).count();
  };
  for (int i = 0; i < count; ++i) {
    const auto start = std::chrono::steady_clock::now();
    try {
      if (!meets_all_conditions(RingClosure(closures.next()))) {
        std::printf("closure %d breaks a condition of contact\n", i);
        ++n_faults;
      }
    } catch (const std::exception& error) {
      std::printf("closure %d: %s\n", i, error.what());
      ++n_faults;
    }
    longest = std::max(longest, seconds_since(start));
  }
  std::printf("%d closures, %d faults, %.2g ms each, the longest %.2g s\n", count, n_faults,
              1e3 * seconds_since(begin) / count, longest);
  return n_faults == 0 ? 0 : 1;
}
