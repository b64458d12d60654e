#pragma once
#include <optional>
#include <vector>

namespace ringfilm::models {

/// Whose temperature an oil film has that is too thin to differ from its walls.
enum class FilmTemperature {
  kMeanOfWalls,  ///< the mean of ring and liner
  kLiner,        ///< temperature of the liner next to the ring
  kRing          ///< temperature of the ring
};

/// Temperatures of the ring and along the liner, eq-film-temperature. Distances are those of the ring from its TDC
/// position; the liner is linear between its points and constant beyond them.
class WallTemperatures {
 public:
  /// @param ring [K]; may be absent where `film` is kLiner @param distance [m], increasing; with `liner` [K] may be
  /// empty where `film` is kRing
  WallTemperatures(FilmTemperature film, std::optional<double> ring, std::vector<double> distance,
                   std::vector<double> liner);

  double liner(double distance) const;  ///< next to the ring at that distance [m] below its TDC position [K]
  double film(double distance) const;   ///< temperature of the oil film at that distance [K]

  struct Range {
    double low, high;  ///< [K]
  };
  Range film_range() const;  ///< over any stroke

 private:
  FilmTemperature film_;
  std::optional<double> ring_;
  std::vector<double> distance_, liner_;
};

}  // namespace ringfilm::models
