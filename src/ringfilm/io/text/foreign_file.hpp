#pragma once
#include <optional>
#include <string_view>

#include "ringfilm/base/error.hpp"

/// Files in which other programs keep tables, and that are not text.
namespace ringfilm::io {

/// What a file is where it is a workbook (xlsx, ods), a MAT file or a TDMS file, and how to export a table from it;
/// nothing for other files.
std::optional<Fault> foreign_file_fault(const SourceMark& file, std::string_view bytes);

/// How to export a table from HDF5.
inline constexpr const char* kHdf5Remedy =
    "write the table as CSV: in MATLAB with h5read and writematrix, in Python with h5py and numpy.savetxt";

}  // namespace ringfilm::io
