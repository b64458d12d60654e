#pragma once
#include <memory>
#include <string>

namespace ringfilm::instrument {

/// Bounds on the foreign program.
struct ConversionLimits {
  double seconds = 60;                              ///< longest wall time [s]
  std::size_t output_bytes = std::size_t{1} << 30;  ///< largest converted file
  std::size_t memory_bytes = std::size_t{8} << 30;  ///< largest address space
};

/// The file as .gwy, converted by the installed program `gwyddion`, which runs as a process of its own without display
/// and with an empty home folder that is removed afterwards. Throws InputError if the program is not installed, does
/// not support the format or leaves its bounds.
std::shared_ptr<const std::string> converted_by_gwyddion(const std::string& path, const ConversionLimits& limits = {});

/// Is the program installed where PATH leads?
bool has_gwyddion();

}  // namespace ringfilm::instrument
