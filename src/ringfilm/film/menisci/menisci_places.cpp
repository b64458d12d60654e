#include "ringfilm/film/menisci/menisci_places.hpp"

#include <algorithm>
#include <cmath>

namespace ringfilm::film {
namespace {

/// Scales of the margins: of a place [m], a speed beyond that of the liner [m/s], a share of the mean pressure.
constexpr double kPlace = 1e-5, kSpeed = 1e-2, kPressure = 0.1;
/// Margin that is as good as any larger one [-].
constexpr double kFar = 1;
/// A film forms where by this share more oil comes than fills the throat [-].
constexpr double kSurplusToFill = 0.01;
/// A meniscus that leaves an edge or the throat begins as far from it [m].
constexpr double kFirstDistance = 2e-8;

/// One end of a film with the two places between which it is free.
struct End {
  double outward;  ///< 1: the right one
  double edge, throat;
  double velocity;  ///< velocity of a free meniscus there [m/s]

  double inside_edge(double x) const { return outward * (edge - x) / kPlace; }
  double outside_throat(double x) const { return outward * (x - throat) / kPlace; }
  /// Has the face its lowest place at this edge?
  bool has_no_room() const { return !(outward * (edge - throat) > 2 * kFirstDistance); }
};

struct Margins {
  const MenisciFilm& film;
  const MenisciInputs& inputs;
  const MenisciBalance& balance;

  End left() const { return {-1, 0, film.throat().x, balance.left.velocity}; }
  End right() const { return {1, film.width(), film.throat().x, balance.right.velocity}; }

  double of_pressure(double p) const { return p / (kPressure * inputs.film.load / film.width()); }
  double of_speed(const End& end) const { return end.outward * end.velocity / (std::abs(inputs.film.U) + kSpeed); }
  double of_end(const End& end, const Meniscus& meniscus) const {
    switch (meniscus.place) {
      case MeniscusPlace::kAtEdge:
        return of_speed(end);
      case MeniscusPlace::kAtThroat:
        return of_pressure(balance.excess);
      case MeniscusPlace::kFree:
        break;
    }
    return std::min(end.inside_edge(meniscus.x), end.outside_throat(meniscus.x));
  }
  /// A film behind the throat, which the liner feeds there, would be under tension: the pressure at the throat is below
  /// that behind the film.
  double of_tension(const MenisciState& state) const {
    const Meniscus& leading = inputs.left_leads() ? state.left : state.right;
    if (leading.place != MeniscusPlace::kAtThroat) return kFar;
    return of_pressure(inputs.leading().pressure - inputs.trailing().pressure - balance.excess);
  }
  /// Is the film too short, or cannot it exist?
  double of_film(const MenisciState& state) const { return std::min(of_length(state), of_tension(state)); }
  double of_length(const MenisciState& state) const { return (state.right.x - state.left.x - kMinFilmLength) / kPlace; }
  /// More oil comes than passes, and a film that formed of it would grow.
  double of_filling() const {
    const double none = balance.arriving > 0 ? 1 : -1;
    const double surplus = balance.passing > 0 ? balance.arriving / balance.passing - 1 : none;
    return std::max(kSurplusToFill - surplus, -balance.growth / (std::abs(inputs.film.U) + kSpeed));
  }

  bool change(const End& end, Meniscus& meniscus) const {
    if (of_end(end, meniscus) >= 0) return false;
    const MeniscusPlace before = meniscus.place;
    const Meniscus at_edge{end.edge, MeniscusPlace::kAtEdge}, at_throat{end.throat, MeniscusPlace::kAtThroat};
    if (before == MeniscusPlace::kFree) {
      meniscus = end.inside_edge(meniscus.x) < 0 ? at_edge : at_throat;
    } else if (end.has_no_room()) {
      meniscus = before == MeniscusPlace::kAtEdge ? at_throat : at_edge;
    } else {
      meniscus.place = MeniscusPlace::kFree;
      meniscus.x += before == MeniscusPlace::kAtEdge ? -end.outward * kFirstDistance : end.outward * kFirstDistance;
    }
    return true;
  }
};

}  // namespace

double margin_of_places(const MenisciFilm& film, const MenisciInputs& inputs, const MenisciState& state,
                        const MenisciBalance& balance) {
  const Margins margins{film, inputs, balance};
  if (state.is_dry()) return std::min(margins.of_filling(), kFar);
  return std::min({kFar, margins.of_end(margins.left(), state.left), margins.of_end(margins.right(), state.right),
                   margins.of_film(state)});
}

bool change_places(const MenisciFilm& film, const MenisciInputs& inputs, const MenisciBalance& balance,
                   MenisciState& state) {
  const Margins margins{film, inputs, balance};
  if (state.is_dry()) {
    if (margins.of_filling() >= 0) return false;
    state = film.film_at_throat(inputs, state);
    return true;
  }
  if (margins.of_film(state) < 0) {
    state.left = state.right = {film.throat().x, MeniscusPlace::kAtThroat};
    return true;
  }
  const bool left_changed = margins.change(margins.left(), state.left);
  const bool right_changed = margins.change(margins.right(), state.right);
  return left_changed || right_changed;
}

}  // namespace ringfilm::film
