#pragma once
#include "ringfilm/film/menisci/menisci_film.hpp"

/// When the ends of a film change their places: a meniscus comes to an edge or to the throat, or leaves it; a film
/// becomes too short, or oil fills a dry throat (eq-menisci-places).
namespace ringfilm::film {

/// A step ends at the change of a place where its margin is below 0 by no more than this [-].
inline constexpr double kReachedMargin = 1e-2;

/// The smallest margin up to the next change of a place, scaled: below 0 it is due.
double margin_of_places(const MenisciFilm& film, const MenisciInputs& inputs, const MenisciState& state,
                        const MenisciBalance& balance);

/// Changes the places that are due. @returns whether one has changed: the balance is another one then
bool change_places(const MenisciFilm& film, const MenisciInputs& inputs, const MenisciBalance& balance,
                   MenisciState& state);

}  // namespace ringfilm::film
