#pragma once
#include <cstddef>
#include <cstdint>
#include <string>

/// What every fuzz target does: the bytes become a file, a reader is let at it.
namespace ringfilm::fuzz {

/// Writes the bytes as `name` into a folder of this process, beside a copy of fuzz/beside, and returns the path. The
/// folder is gone when the process ends.
std::string input_file(const std::uint8_t* data, std::size_t size, const std::string& name);

}  // namespace ringfilm::fuzz
