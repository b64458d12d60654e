#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "ringfilm/cycle/result/result.hpp"
#include "ringfilm/report/payload/map_picture.hpp"

namespace ringfilm::report {

/// Values of one field in steps of 1/65534 of their range. SI.
struct PackedField {
  std::string name;
  double low = 0, high = 0;  ///< values that 0 and 65534 stand for; 65535: no value
  std::vector<std::uint16_t> values;
};

/// The largest picture of one case that a page carries: with three fields about 3 MB.
struct PictureLimits {
  std::size_t angles = 24, strips = 201, nodes = 81;
  std::size_t strip_angles = 361;  ///< crank angles of fields over (crank_angle, y)
};

/// Fields of the unrolled film as a page carries them: every so many angles, strips and nodes, none of them a mean, the
/// first and the last always, and the angle of the highest pressure.
struct UnrolledPicture {
  std::vector<double> x, y, crank_angle_deg;
  std::vector<PackedField> fields;  ///< [angle][y][x]; film content, film pressure and film thickness
  /// Extremes of each angle, among all that is stored.
  std::vector<MapPoint> highest_pressure, lowest_film_content;
};
UnrolledPicture unrolled_picture(const cycle::UnrolledFields& fields, const PictureLimits& limits = {});

/// Sums of strips as a page carries them: every so many angles, all strips.
struct StripPicture {
  std::vector<double> crank_angle_deg;
  std::vector<PackedField> fields;  ///< [angle][y]
};
StripPicture strip_picture(const cycle::UnrolledFields& fields, const PictureLimits& limits = {});

/// About every `n / most`-th of n things in a row, at most `most`: the first and the last are among them.
std::vector<std::size_t> spread(std::size_t n, std::size_t most);

}  // namespace ringfilm::report
