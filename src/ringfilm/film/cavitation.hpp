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

/// Is the node part of a cavity? One that the iteration left just beyond the kink is full at p_c.
inline bool is_cavity(double deficit) {
  constexpr double kRounding = 1e-9;  // ten times as far as a node is put beyond the kink
  return deficit > kRounding;
}

/// Moves z by the Newton step, but stops every node that would change sides just beyond the kink: beyond it the
/// linearisation is that of the other side. A front that only advances into a cavity would do so by one node an
/// iteration; it is helped along by 1, 2, 4 ... nodes.
class KinkedUpdate {
 public:
  struct Outcome {
    int to_film = 0;  ///< nodes that went from cavity to film
    int to_cavity = 0;
    double largest = 0;  ///< largest change, relative to the scale or to a larger multiplier
  };

  /// @param step for the inner nodes 1..n-1
  Outcome apply(std::vector<double>& z, const std::vector<double>& step, double scale);

  /// To be called before the first iteration of a solve.
  void start();

 private:
  void help_along(std::vector<double>& z, const Outcome& outcome, double beyond);

  int reach_ = 0;          ///< cells by which an advancing front was helped along in the last iteration
  int largest_reach_ = 0;  ///< 0: no more help
  int retreats_left_ = 0;
  int advances_ = 0;  ///< iterations in a row in which fronts only advanced
  std::vector<int> flipped_;
};

}  // namespace ringfilm::film
