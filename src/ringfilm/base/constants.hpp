#pragma once

namespace ringfilm::base {

/// Standard atmosphere: the zero of gauge pressures and the reference of the density law [Pa].
inline constexpr double kAtmosphere = 101325;

}  // namespace ringfilm::base
