#include "ringfilm/cycle/menisci/liner_side.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ringfilm::cycle {
namespace {

/// Stretch over which the film ahead of a meniscus is averaged [m].
constexpr double kReading = 60e-6;
/// Pieces that are shorter are joined with the one before [m].
constexpr double kMinPiece = 5e-6;

}  // namespace

double LinerSide::mass() const {
  double sum = 0;
  for (const Piece& piece : pieces_) sum += piece.mass();
  return sum;
}

double LinerSide::mass_between(double from, double to) const {
  auto piece = std::partition_point(pieces_.begin(), pieces_.end(), [&](const Piece& p) { return p.inner > from; });
  if (piece == pieces_.end() && pieces_.empty()) return 0;
  if (piece == pieces_.end()) --piece;
  double sum = 0;
  while (true) {
    const double begin = std::max(from, piece->inner), end = std::min(to, piece->outer);
    if (end > begin) sum += piece->mass(begin, end);
    if (piece == pieces_.begin() || piece->outer >= to) return sum;
    --piece;
  }
}

double LinerSide::mean_beyond(double place) const {
  const double from = std::max(place, end_);
  const double to = pieces_.empty() ? from : std::min(from + kReading, pieces_.front().outer);
  return to > from ? mass_between(from, to) / (to - from) : 0;
}

double LinerSide::mean_between(double from, double to) const {
  if (to - from > kReading) return mass_between(from + 0.5 * kReading, to + 0.5 * kReading) / (to - from);
  return (mean_beyond(from) + 4 * mean_beyond(0.5 * (from + to)) + mean_beyond(to)) / 6;
}

double LinerSide::take_up(double place) {
  double taken = 0;
  while (!pieces_.empty() && pieces_.back().outer <= place) {
    taken += pieces_.back().mass();
    pieces_.pop_back();
  }
  if (!pieces_.empty() && pieces_.back().inner < place) {
    Piece& cut = pieces_.back();
    taken += cut.mass(cut.inner, place);
    cut = {place, cut.outer, cut.at(place), cut.at_outer};
  }
  end_ = place;
  return taken;
}

void LinerSide::lay(double place, double mass, double at_inner, double at_outer) {
  const double length = end_ - place, mean = mass / length;
  const double half = std::clamp(0.5 * (at_inner - at_outer), -mean, mean);
  const bool is_joined =
      length < kMinPiece && !pieces_.empty() && pieces_.back().outer - pieces_.back().inner < kMinPiece;
  if (is_joined) {
    Piece& last = pieces_.back();
    const double joined = (last.mass() + mass) / (last.outer - place);
    last = {place, last.outer, joined, joined};
  } else {
    pieces_.push_back({place, end_, mean + half, mean - half});
  }
  end_ = place;
}

double LinerSide::cut_beyond(double place) {
  double removed = 0;
  std::size_t whole = 0;
  for (; whole < pieces_.size() && pieces_[whole].inner >= place; ++whole) removed += pieces_[whole].mass();
  pieces_.erase(pieces_.begin(), pieces_.begin() + static_cast<std::ptrdiff_t>(whole));
  if (!pieces_.empty() && pieces_.front().outer > place) {
    Piece& cut = pieces_.front();
    removed += cut.mass(place, cut.outer);
    cut = {cut.inner, place, cut.at_inner, cut.at(place)};
  }
  return removed;
}

void LinerSide::add_beyond(double inner, double outer, double at_inner, double at_outer) {
  if (outer > inner) pieces_.insert(pieces_.begin(), {inner, outer, at_inner, at_outer});
}

void LinerSide::shape(const std::vector<Point>& points) {
  const double inner = points.front().place, outer = points.back().place, mass = mass_between(inner, outer);
  double all = 0;
  for (std::size_t k = 1; k < points.size(); ++k) {
    all += 0.5 * (points[k].place - points[k - 1].place) * (points[k].oil + points[k - 1].oil);
  }
  if (!(all > 0) || !(mass > 0) || pieces_.empty() || pieces_.front().outer < outer) return;
  std::vector<Piece> shaped;
  const auto keep = [&](const Piece& piece, double from, double to) {
    if (to > from) shaped.push_back({from, to, piece.at(from), piece.at(to)});
  };
  for (const Piece& piece : pieces_) keep(piece, std::max(piece.inner, outer), piece.outer);
  for (std::size_t k = points.size() - 1; k > 0; --k) {
    const Point &from = points[k - 1], &to = points[k];
    if (to.place > from.place) shaped.push_back({from.place, to.place, from.oil * mass / all, to.oil * mass / all});
  }
  for (const Piece& piece : pieces_) keep(piece, piece.inner, std::min(piece.outer, inner));
  pieces_ = std::move(shaped);
}

void LinerSide::add_to_cells(double cell, double sign, std::vector<double>& mass) const {
  const int last = static_cast<int>(mass.size()) - 1;
  for (const Piece& piece : pieces_) {
    const double first = std::min(sign * piece.inner, sign * piece.outer),
                 end = std::max(sign * piece.inner, sign * piece.outer);
    const int from = std::clamp(static_cast<int>(first / cell), 0, last);
    const int to = std::clamp(static_cast<int>(end / cell), 0, last);
    for (int c = from; c <= to; ++c) {
      const double low = c == from ? first : c * cell, high = c == to ? end : (c + 1) * cell;
      if (high > low) mass[c] += piece.mass(std::min(sign * low, sign * high), std::max(sign * low, sign * high));
    }
  }
}

}  // namespace ringfilm::cycle
