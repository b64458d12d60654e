#pragma once
#include "ringfilm/cycle/setup/setup.hpp"

namespace ringfilm::benchmarks {

/// What is integrated: the paper's new ring at 1500 rpm, steps of 1 degree, and scenarios around it that differ in
/// speed
/// (+-20 %), elastic pressure (+-20 %) and oil temperature (+-10 K), so that no lane does what its neighbour does.
class Scenarios {
 public:
  Scenarios(int cells, cycle::Cavitation cavitation);

  /// @param i from 0; 0 is the ring as the paper has it
  cycle::Setup setup(std::size_t i) const;
  int cells() const { return base_.solver.cells; }

 private:
  cycle::Case base_;
  double elastic_pressure_;  ///< of the base [Pa]
};

}  // namespace ringfilm::benchmarks
