#pragma once
#include <memory>
#include <vector>

#include "ringfilm/cycle/cycle_run.hpp"
#include "ringfilm/cycle/simulate.hpp"

namespace ringfilm::cycle {

/// The rings of a pack on their liner, stroke by stroke from BDC before compression on.
class PackRuns {
 public:
  /// @param below distances of the chamber edges of the rings from that of the first one [m]
  PackRuns(const std::vector<Setup>& rings, const std::vector<double>& below, const LinerFilm& liner);

  /// All rings to the next dead centre. The ring that leads comes first, and each of the others finds the film that the
  /// ring before it has left. @returns whether all got there
  bool finish_stroke(Observer* observer);
  bool begins_compression() const { return runs_.front()->begins_compression(); }  ///< as CycleRun

  LinerFilm& liner() { return *liner_; }
  const std::vector<std::unique_ptr<CycleRun>>& runs() const { return runs_; }

 private:
  std::shared_ptr<LinerFilm> liner_;
  std::vector<std::unique_ptr<CycleRun>> runs_;
};

}  // namespace ringfilm::cycle
