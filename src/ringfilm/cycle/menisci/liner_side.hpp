#pragma once
#include <cstddef>
#include <vector>

namespace ringfilm::cycle {

/// Oil on the liner on one side of the film, in linear pieces from the meniscus outwards. Places are counted along the
/// liner in the direction that leads away from the film.
class LinerSide {
 public:
  explicit LinerSide(double end) : end_(end) {}

  double end() const { return end_; }  ///< place of the meniscus [m]
  double mass() const;                 ///< [kg/m]
  /// Mean over the 60 um beyond a place, or beyond the meniscus where that is farther; 0 where the liner ends [kg/m2].
  double mean_beyond(double place) const;
  /// Mean of mean_beyond() between two places [kg/m2].
  double mean_between(double from, double to) const;
  /// Oil between two places [kg/m].
  double mass_between(double from, double to) const;

  /// The meniscus moves outwards and takes up what lies there. @returns its mass [kg/m]
  double take_up(double place);
  /// The meniscus moves inwards and leaves oil. @param mass of it, at least 0 [kg/m] @param at_inner,at_outer mass per
  /// area at the ends of the piece, whose difference is kept as far as none is below 0 [kg/m2]
  void lay(double place, double mass, double at_inner, double at_outer);

  /// Removes all beyond a place; what follows is added there. @returns its mass [kg/m]
  double cut_beyond(double place);
  /// Adds a piece at the outer end. @param at_inner,at_outer mass per area [kg/m2]
  void add_beyond(double inner, double outer, double at_inner, double at_outer);

  /// Oil at a place.
  struct Point {
    double place;  ///< [m]
    double oil;    ///< [kg/m2]
  };
  /// Between the first and the last of these points, outwards, the same mass comes to lie as the lines through them
  /// have it. They lie beyond the meniscus.
  void shape(const std::vector<Point>& points);

  /// Adds the mass in each of equal cells. @param sign of the places of the cells, which begin at 0
  void add_to_cells(double cell, double sign, std::vector<double>& mass) const;

 private:
  struct Piece {
    double inner, outer;        ///< places [m]
    double at_inner, at_outer;  ///< mass per area [kg/m2]

    double at(double place) const { return at_inner + (at_outer - at_inner) * (place - inner) / (outer - inner); }
    /// Between two of its places [kg/m].
    double mass(double from, double to) const { return 0.5 * (to - from) * (at(from) + at(to)); }
    double mass() const { return 0.5 * (outer - inner) * (at_inner + at_outer); }
  };

  double end_;
  std::vector<Piece> pieces_;  ///< the outermost first
};

}  // namespace ringfilm::cycle
