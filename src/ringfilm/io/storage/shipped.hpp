#pragma once
#include <optional>
#include <string>

#include "ringfilm/base/error.hpp"

namespace ringfilm::io {

/// The folder that holds the shipped `cases/` and `data/`: $RINGFILM_DATA, else <program>/../share/ringfilm, else
/// <program>/.. (a build folder inside the checkout), of the Python module <module>/share, else the same in one of the
/// four folders above it; else ringfilm in one of $XDG_DATA_DIRS (/usr/local/share and /usr/share where that is not
/// set); nothing if none of them does. See also shipped_folder().
std::optional<std::string> find_shipped_folder();

/// The folder of find_shipped_folder(); throws InputError where there is none.
std::string shipped_folder();

/// Why find_shipped_folder() finds nothing, and what to set.
Fault missing_shipped_folder();

}  // namespace ringfilm::io
