#include "ringfilm/cycle/pack/liner_evaporation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>

#include "ringfilm/cycle/setup/kinematics.hpp"

namespace ringfilm::cycle {
namespace {

/// Halves of the cycle, from firing and from gas-exchange TDC: the ring goes down and comes up again.
constexpr std::size_t kHalves = 2;
constexpr double kHalfDeg = kCycleDeg / kHalves;
/// Steps of each half. A constant coefficient is integrated to round-off, since the path of the ring is periodic.
constexpr int kSteps = 720;
constexpr double kRepeats = 1e-6;  ///< relative change of the rate from one cycle to the next
constexpr int kMaxCycles = 300;

/// Fractions along the liner and under the rings over the cycles.
class CompositionOnLiner {
 public:
  explicit CompositionOnLiner(const EvaporatingLiner& liner)
      : liner_(liner),
        n_cells_(liner.film.size()),
        n_fractions_(liner.fractions.size()),
        cell_(liner.crank.stroke() / static_cast<double>(n_cells_)) {
    for (const models::OilFraction& fraction : liner.fractions) {
      molar_mass_.push_back(fraction.molar_mass_or_correlated());
      fresh_.push_back(fraction.share / molar_mass_.back());
    }
    for (std::size_t c = 0; c < n_cells_; ++c) {
      const double T = liner.temperature(place(c));
      for (const models::OilFraction& fraction : liner.fractions) {
        concentration_.push_back(models::vapour_concentration(fraction.boiling_point, T));
      }
      for (const double moles : fresh_) on_liner_.push_back(liner.film[c] * moles);
    }
    for (const double moles : fresh_) under_rings_.push_back(liner.carried * moles);
    for (std::size_t half = 0; half < kHalves; ++half) expose(half);
  }

  EvaporatedOil until_it_repeats() {
    const double per_cycle = std::numbers::pi * liner_.bore, period = radians(kCycleDeg) / liner_.speed;
    EvaporatedOil oil;
    oil.of_fresh_oil = fresh_rate() * per_cycle / period;
    double before = 0, within_reach = 0;
    for (oil.cycles = 1; oil.cycles <= kMaxCycles; ++oil.cycles) {
      const double stored = mass();
      replenished_ = evaporated_ = within_reach = 0;
      for (std::size_t half = 0; half < kHalves; ++half) {
        for (std::size_t c = 0; c < n_cells_; ++c) pass(c);
        for (std::size_t c = 0; c < n_cells_; ++c) {
          const double lost = evaporate(half, c);
          evaporated_ += lost;
          if (place(c) >= liner_.reach) within_reach += lost;
        }
        for (std::size_t c = n_cells_; c-- > 0;) pass(c);
      }
      oil.stored = (mass() - stored) * per_cycle;
      if (std::abs(evaporated_ - before) <= kRepeats * evaporated_) break;
      before = evaporated_;
    }
    oil.cycles = std::min(oil.cycles, kMaxCycles);
    oil.replenished = replenished_ * per_cycle;
    oil.evaporated = evaporated_ * per_cycle;
    oil.rate = oil.evaporated / period;
    oil.within_reach = within_reach * per_cycle / period;
    return oil;
  }

 private:
  double place(std::size_t cell) const { return (static_cast<double>(cell) + 0.5) * cell_; }
  std::span<double> moles(std::size_t cell) { return {on_liner_.data() + cell * n_fractions_, n_fractions_}; }

  /// Integral of the mass transfer coefficient while the ring is below a cell, the mean over the cell.
  void expose(std::size_t half) {
    std::vector<double>& exposure = exposure_[half];
    exposure.assign(n_cells_ + 1, 0.0);
    std::vector<double> whole(n_cells_ + 1, 0.0);  // passed over all cells before that one
    const double step_deg = kHalfDeg / kSteps, step_time = radians(step_deg) / liner_.speed;
    for (int k = 0; k < kSteps; ++k) {
      const double angle = static_cast<double>(half) * kHalfDeg + (k + 0.5) * step_deg;
      const double cells = liner_.crank.position(radians(angle)) / cell_;
      const auto full = std::min(static_cast<std::size_t>(cells), n_cells_);
      const double passed = liner_.mass_transfer(angle) * step_time;
      whole[full] += passed;
      exposure[full] += passed * (cells - static_cast<double>(full));
    }
    double below = 0;
    for (std::size_t c = n_cells_; c-- > 0;) {
      below += whole[c + 1];
      exposure[c] = (exposure[c] + below) * std::pow(liner_.temperature(place(c)), liner_.wall_temperature_power);
    }
  }

  /// Rate of oil that does not change, per length of circumference and cycle, eq-fresh-rate [kg/m].
  double fresh_rate() const {
    double all = 0, sum = 0;
    for (const double one : fresh_) all += one;
    for (std::size_t c = 0; c < n_cells_; ++c) {
      for (std::size_t i = 0; i < n_fractions_; ++i) {
        const double flux = molar_mass_[i] * fresh_[i] / all * concentration_[c * n_fractions_ + i];
        for (const auto& exposure : exposure_) sum += flux * exposure[c] * cell_;
      }
    }
    return sum;
  }

  /// The rings pass a cell: its oil and that under them mix, and each keeps its share of the whole, eq-renewal.
  void pass(std::size_t c) {
    const double on_cell = liner_.film[c] * cell_, all = on_cell + liner_.carried;
    if (!(all > 0)) return;
    const std::span<double> cell = moles(c);
    for (std::size_t i = 0; i < n_fractions_; ++i) {
      if (place(c) >= liner_.reach) {
        const double fresh = liner_.film[c] * fresh_[i];
        replenished_ += (fresh - cell[i]) * cell_ * molar_mass_[i];
        cell[i] = fresh;
      }
      const double mixed = under_rings_[i] + cell[i] * cell_;
      under_rings_[i] = mixed * liner_.carried / all;
      cell[i] = mixed * (on_cell / all) / cell_;
    }
  }

  /// Mass that leaves a cell in half a cycle, per length of circumference [kg/m].
  double evaporate(std::size_t half, std::size_t c) {
    const std::span<double> cell = moles(c);
    const double before = mass_of(cell);
    models::evaporate(cell, {concentration_.data() + c * n_fractions_, n_fractions_}, exposure_[half][c]);
    return (before - mass_of(cell)) * cell_;
  }

  double mass_of(std::span<const double> moles) const {
    double sum = 0;
    for (std::size_t i = 0; i < n_fractions_; ++i) sum += moles[i] * molar_mass_[i];
    return sum;
  }

  /// On the liner and under the rings, per length of circumference [kg/m].
  double mass() {
    double sum = mass_of(under_rings_);
    for (std::size_t c = 0; c < n_cells_; ++c) sum += mass_of(moles(c)) * cell_;
    return sum;
  }

  const EvaporatingLiner& liner_;
  std::size_t n_cells_, n_fractions_;
  double cell_;                                        ///< [m]
  std::vector<double> molar_mass_;                     ///< molar mass of each fraction [kg/mol]
  std::vector<double> fresh_;                          ///< moles of each fraction in fresh oil [mol/kg]
  std::vector<double> concentration_;                  ///< vapour of each fraction at each cell [mol/m3]
  std::vector<double> on_liner_;                       ///< fractions at each cell [mol/m2]
  std::vector<double> under_rings_;                    ///< fractions that the rings carry [mol/m]
  std::array<std::vector<double>, kHalves> exposure_;  ///< exposure of each cell [m]
  double replenished_ = 0, evaporated_ = 0;            ///< in the last cycle [kg/m]
};

}  // namespace

EvaporatedOil evaporated_oil(const EvaporatingLiner& liner) { return CompositionOnLiner(liner).until_it_repeats(); }

}  // namespace ringfilm::cycle
