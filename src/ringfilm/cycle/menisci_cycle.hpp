#pragma once
#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "ringfilm/cycle/cycle_values.hpp"
#include "ringfilm/cycle/menisci/menisci_integration.hpp"
#include "ringfilm/cycle/result/result.hpp"

namespace ringfilm::cycle {

/// Topic of the note on a case that was computed on cells instead.
inline constexpr const char* kMenisciNotUsed = "menisci-not-used";

/// What keeps the film of a ring from being integrated between two menisci (docs/theory/menisci.md), as a part of a
/// sentence; nothing where nothing does.
std::optional<std::string> no_menisci_since(const Setup& setup);

/// Cycles of a film between two menisci until they repeat themselves.
class MenisciCycles {
 public:
  /// Throws ConvergenceError where no step is found, or cycles come no closer to each other.
  /// @param tolerance error that a step may make in ln h_m
  MenisciCycles(const Setup& setup, double tolerance);

  int cycles() const { return cycles_; }                                 ///< that were integrated
  bool repeats() const { return repeats_; }                              ///< did the last cycle end as it began?
  double distance() const { return std::max(film_moved_, oil_moved_); }  ///< from the state that repeats itself [-]
  const MenisciIntegration& integration() const { return integration_; }
  /// Film, pressure and flows at a crank angle of the last cycle, within [0, 720).
  MenisciSample sample(double crank_angle_deg);
  /// At the ends of its steps, in the order of their angles within [0, 720).
  std::vector<MenisciSample> samples_at_steps();
  OilOfCycle oil() const;

 private:
  void add_change_of_gas(const MenisciStep& step, double from_deg, double to_deg, std::vector<MenisciSample>& samples);

  MenisciIntegration integration_;
  LinerOil::Account account_;  ///< account of the last cycle
  int cycles_ = 0;
  bool repeats_ = false;
  double film_moved_ = 0, oil_moved_ = 0;
};

/// The cycle of a film between menisci as simulate() has it; nothing where the case has no such film, or none was
/// found: `on_cells` is the scenario without it then, with a note.
std::optional<CycleResult> simulate_menisci(const Setup& setup, std::optional<Setup>& on_cells);

/// A scenario of `solver.method = "menisci"` to be computed on cells, with a note. @param reason part of a sentence
Setup without_menisci(const Setup& setup, const std::string& reason);

}  // namespace ringfilm::cycle
