#pragma once
#include <string>

#include "ringfilm/instrument/grid/channel.hpp"

namespace ringfilm::instrument {

/// Does a text begin as the two text files of MetroPro and Mx do?
bool is_zygo_text(const std::string& text);

/// Reads the heights of a text of Zygo's programs MetroPro and Mx: "Zygo ASCII Data File - Format 2", phases as whole
/// numbers, or "Zygo XYZ Data File - Format 1", columns and rows of points with heights in um. The shape is that of
/// the MetroPro reference guide (Zygo, OMP-0347): 13 or 14 lines with the size, the wavelength W, the scale S, the
/// obliquity O and the lateral resolution, then `#` between the parts. A height is phase * S W O / R with R of 4096,
/// 32768 or 131072; phases from 2147483640 on are missing. Throws InputError with the line, the rule and the remedy.
InstrumentFile read_zygo_text(const std::string& file, const std::string& text);

}  // namespace ringfilm::instrument
