#pragma once
#include <cstddef>
#include <vector>

#include "ringfilm/film/film_state.hpp"

namespace ringfilm::film {

/// Lowest place of a gap, at which gases of both edges meet.
struct LowestPlace {
  double x = 0;       ///< [m]
  double height = 0;  ///< h_s there [m]
};

/// The lowest place of a gap that is a parabola in each cell.
LowestPlace lowest_place(const FilmGrid& grid);

/// h_s at a place of a gap that is a parabola in each cell [m].
double gap_height(const FilmGrid& grid, double x);

/// Points of Simpson's rule on a stretch of a gap, in either direction: the ends and the middle of each cell. The first
/// and the last cell are cut at the ends of the stretch, and one at a place within it.
class GapPoints {
 public:
  /// @param h_m added to the heights of the grid  @param begin,place,end of the stretch in its direction, within the
  /// grid; a place outside of it counts as its nearer end [m]
  void set(const FilmGrid& grid, double h_m, double begin, double place, double end);

  std::size_t size() const { return size_; }                     ///< an odd number, 3 at the least
  std::size_t at_place() const { return at_place_; }             ///< the point at the place
  const std::vector<double>& x() const { return x_; }            ///< places of the points [m]
  const std::vector<double>& h() const { return h_; }            ///< gap at the points [m]
  const std::vector<double>& weight() const { return weight_; }  ///< weights of Simpson's rule [m]

  static std::size_t most(const FilmGrid& grid) { return 2 * grid.face_height.size() + 5; }  ///< points at the most

  /// Adds up from the first point on. @param f at each point, asked for in their order  @param sum integral up to each
  template <class Integrand>
  void integrate(const Integrand& f, std::vector<double>& sum) const {
    double first = f(std::size_t{0}), total = sum[0] = 0;
    for (std::size_t c = 0; c < cells_; ++c) {
      const double middle = f(2 * c + 1), last = f(2 * c + 2), part = cell_[c] / 24;
      sum[2 * c + 1] = total + part * (5 * first + 8 * middle - last);
      sum[2 * c + 2] = total += 4 * part * (first + 4 * middle + last);
      first = last;
    }
  }

 private:
  void add_stretch(const FilmGrid& grid, double h_m, double begin, double end);
  void add_cell(double to, double middle, double last);

  std::size_t at_place_ = 0, size_ = 0, cells_ = 0;
  std::vector<double> cell_;  ///< length of the cells [m]
  std::vector<double> x_, h_, weight_;
};

}  // namespace ringfilm::film
