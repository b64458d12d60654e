#include "ringfilm/models/wall_temperature.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "ringfilm/base/table.hpp"

namespace ringfilm::models {

WallTemperatures::WallTemperatures(FilmTemperature film, std::optional<double> ring, std::vector<double> distance,
                                   std::vector<double> liner)
    : film_(film), ring_(ring), distance_(std::move(distance)), liner_(std::move(liner)) {
  const bool has_ring = film_ == FilmTemperature::kLiner || ring_;
  const bool has_liner = film_ == FilmTemperature::kRing || !liner_.empty();
  if (!has_ring || !has_liner || distance_.size() != liner_.size()) {
    throw std::invalid_argument("a film takes its temperature from a wall that has none");
  }
}

double WallTemperatures::liner(double distance) const {
  return interpolate_linear(distance_, liner_, std::clamp(distance, distance_.front(), distance_.back()));
}

double WallTemperatures::film(double distance) const {
  switch (film_) {
    case FilmTemperature::kLiner:
      return liner(distance);
    case FilmTemperature::kRing:
      return *ring_;
    case FilmTemperature::kMeanOfWalls:
      break;
  }
  return 0.5 * (*ring_ + liner(distance));
}

WallTemperatures::Range WallTemperatures::film_range() const {
  if (film_ == FilmTemperature::kRing) return {*ring_, *ring_};
  const auto [low, high] = std::minmax_element(distance_.begin(), distance_.end(),
                                               [this](double a, double b) { return liner(a) < liner(b); });
  return {film(*low), film(*high)};
}

}  // namespace ringfilm::models
