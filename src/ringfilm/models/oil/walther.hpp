#pragma once

/// The two numbers of Walther's law, log log (nu + 0.7) = A - B log T with nu in mm2/s (ASTM D341).
namespace ringfilm::models {

inline constexpr double kMm2PerSecond = 1e-6;  ///< [m2/s]
inline constexpr double kWaltherOffset = 0.7;  ///< [mm2/s]

}  // namespace ringfilm::models
