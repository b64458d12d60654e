#pragma once
#include <string>
#include <vector>

#include "ringfilm/io/start/start_engine.hpp"

/// Typical numbers of cases to start from, whatever the engine. An empty remark: typical, assumed.
namespace ringfilm::io {

/// A pair of the shipped classes of surfaces in oil: a plateau-honed liner of grey iron and a nitrided ring.
/// N beta sigma = 0.05, the upper end of its range (greenwood1971). Throws InputError where the shipped folder is not
/// found.
std::vector<StartValue> start_contact(const std::string& state);

/// Walls of the point, of `conditions = "engine"` where it states none.
std::vector<StartValue> start_walls(const StartPoint& point);

}  // namespace ringfilm::io
