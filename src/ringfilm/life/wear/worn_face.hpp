#pragma once
#include <vector>

#include "ringfilm/case/case.hpp"
#include "ringfilm/film/film_state.hpp"

namespace ringfilm::life {

/// A face that wears: its heights as installed at the nodes of the film and halfway between them, the depths that it
/// has lost at the nodes. Between two nodes the lost depth is linear.
class WornFace {
 public:
  /// @param c before it wears; not with orientation "leading-edge"
  explicit WornFace(const cycle::Case& c);

  std::size_t n_nodes() const { return grid_.x.size(); }
  const std::vector<double>& x() const { return grid_.x; }  ///< places of the nodes, from the chamber edge [m]
  const std::vector<double>& share() const {
    return grid_.share;
  }  ///< length of the face that belongs to each node [m]

  /// The face of a case after it has lost these depths at the nodes, and tilted about its middle. Where nothing is lost
  /// and nothing tilted, that of the case it was made of. @param tilt slope against the liner [rad]
  cycle::RingFace face(const std::vector<double>& worn, double tilt) const;

  /// Heights of that face at the nodes above its lowest point [m].
  std::vector<double> heights(const std::vector<double>& worn, double tilt) const;

 private:
  double height_at(std::size_t k, const std::vector<double>& worn, double tilt) const;

  cycle::RingFace unworn_;
  film::FilmGrid grid_;
};

}  // namespace ringfilm::life
