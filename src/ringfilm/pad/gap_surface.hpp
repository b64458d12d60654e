#pragma once
#include <utility>
#include <vector>

#include "ringfilm/film/film_state.hpp"

namespace ringfilm::pad {

/// A gap over x and y: bilinear between points, with steps along whole lines where an x or a y appears twice. Between
/// such lines lie its pieces, counted along x and along y.
class GapSurface {
 public:
  /// @param x from 0 to the length, increasing, twice at a step [m]
  /// @param y from 0 to the width, increasing, twice at a step [m]
  /// @param height for each x of the first y, then of the next [m]
  GapSurface(std::vector<double> x, std::vector<double> y, std::vector<double> height);

  /// The same at every y. @param along pieces by formulas, from x = 0 to the length
  GapSurface(std::vector<film::GapPiece> along, double width);

  /// Begin and end of each piece [m].
  const std::vector<std::pair<double, double>>& pieces_x() const { return ends_x_; }
  const std::vector<std::pair<double, double>>& pieces_y() const { return ends_y_; }

  /// Height as seen from the piece `(piece_x, piece_y)`, in which or on whose edge the place lies [m].
  double height(int piece_x, int piece_y, double x, double y) const;

 private:
  struct Axis {
    std::vector<double> places;
    std::vector<int> first, last;  ///< numbers of the points at which each piece begins and ends
  };
  /// Between which points a place lies, and how far along.
  struct Between {
    int point;
    double part;
  };
  static Axis axis(std::vector<double> places);
  static std::vector<std::pair<double, double>> ends(const Axis& axis);
  static Between between(const Axis& axis, int piece, double place);

  Axis x_, y_;
  std::vector<std::pair<double, double>> ends_x_, ends_y_;
  std::vector<double> height_;
  std::vector<film::GapPiece> formulas_;  ///< one for each piece along x; empty: points
};

}  // namespace ringfilm::pad
