#pragma once
#include <vector>

#include "ringfilm/film/film_state.hpp"

/// Complementarity of pressure and fill by one number z per node [Pa]: z > 0 is a full film with p = p_c + z; z <= 0 is
/// a cavity at p_c whose fill is theta = 1 + z/scale (mass-conserving), or where z balances the broken conservation of
/// mass (Reynolds exit). eqs eq-complementarity, eq-fill.
namespace ringfilm::film {

/// z of a stored state when the cavitation pressure is now `p_c`.
void z_from_state(const FilmState& state, double p_c, double scale, std::vector<double>& z);

/// Pressure and deficit of z at the inner nodes; the edges are left alone.
void state_from_z(const std::vector<double>& z, double p_c, double scale, FilmState& state);

/// theta at a node.
inline double fill(Cavitation cavitation, double deficit) {
  return cavitation == Cavitation::kMassConserving ? 1 - deficit : 1.0;
}

/// Moves z by the Newton step, but stops every node that would change sides just beyond the kink: beyond it the
/// linearisation is that of the other side.
class KinkedUpdate {
 public:
  struct Outcome {
    int to_film = 0;  ///< nodes that went from cavity to film
    int to_cavity = 0;
    double largest = 0;  ///< largest change, relative to the scale
  };

  /// @param step for the inner nodes 1..n-1; @param iteration counts from 1
  Outcome apply(std::vector<double>& z, const std::vector<double>& step, double scale, int iteration);

  /// To be called before the first iteration of a solve.
  void start();

 private:
  int reach_ = 1;          ///< cells by which an advancing front is helped along next
  int largest_reach_ = 0;  ///< 0: no more help
  std::vector<int> flipped_;
};

}  // namespace ringfilm::film
