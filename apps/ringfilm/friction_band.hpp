#pragma once
#include <string>

#include "ringfilm/case/case.hpp"
#include "ringfilm/io/measurement/measurement.hpp"

namespace ringfilm::app {

/// Two maps and the case of their ring.
struct FrictionBandRequest {
  std::string ring;      ///< name of the ring, for titles
  cycle::Case input;     ///< with N, beta, sigma of the maps and Greenwood and Tripp as styles2014 feeds it
  double hardness;       ///< hardness of the softer face [Pa]
  std::string law_path;  ///< contact law of the maps with flow factors, as `contact` writes it
};

/// What each contact law makes of film and friction, with the coefficient of boundary friction of the case and with the
/// band of oils with additives: table and picture of the laws.
io::Measurement friction_band(const FrictionBandRequest& request);

}  // namespace ringfilm::app
