#include "ringfilm/pad/gap_surface.hpp"

#include <algorithm>

namespace ringfilm::pad {

GapSurface::GapSurface(std::vector<double> x, std::vector<double> y, std::vector<double> height)
    : x_(axis(std::move(x))),
      y_(axis(std::move(y))),
      ends_x_(ends(x_)),
      ends_y_(ends(y_)),
      height_(std::move(height)) {}

GapSurface::GapSurface(std::vector<film::GapPiece> along, double width)
    : ends_y_{{0, width}}, formulas_(std::move(along)) {
  for (const film::GapPiece& piece : formulas_) ends_x_.emplace_back(piece.begin, piece.end);
}

GapSurface::Axis GapSurface::axis(std::vector<double> places) {
  Axis axis;
  axis.first.push_back(0);
  const int n = static_cast<int>(places.size());
  for (int i = 1; i < n; ++i) {
    if (places[i] != places[i - 1]) continue;
    axis.last.push_back(i - 1);
    axis.first.push_back(i);
  }
  axis.last.push_back(n - 1);
  axis.places = std::move(places);
  return axis;
}

std::vector<std::pair<double, double>> GapSurface::ends(const Axis& axis) {
  std::vector<std::pair<double, double>> ends;
  for (std::size_t k = 0; k < axis.first.size(); ++k) {
    ends.emplace_back(axis.places[axis.first[k]], axis.places[axis.last[k]]);
  }
  return ends;
}

GapSurface::Between GapSurface::between(const Axis& axis, int piece, double place) {
  const auto begin = axis.places.begin();
  // The last point but one of the piece is the last after which a place of it can lie.
  const auto after = std::upper_bound(begin + axis.first[piece] + 1, begin + axis.last[piece], place);
  const int point = static_cast<int>(after - begin) - 1;
  const double low = axis.places[point], high = axis.places[point + 1];
  return {point, (place - low) / (high - low)};
}

double GapSurface::height(int piece_x, int piece_y, double x, double y) const {
  if (!formulas_.empty()) return formulas_[piece_x].height(x);
  const Between i = between(x_, piece_x, x), j = between(y_, piece_y, y);
  const double* low = height_.data() + static_cast<std::size_t>(j.point) * x_.places.size() + i.point;
  const double* high = low + x_.places.size();
  const auto along = [&i](const double* row) { return row[0] + i.part * (row[1] - row[0]); };
  return along(low) + j.part * (along(high) - along(low));
}

}  // namespace ringfilm::pad
