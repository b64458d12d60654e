#pragma once
#include <string>
#include <string_view>

/// The last line of each NetCDF file that ringfilm writes: "ringfilm sha256 " and the digest of all bytes before the
/// line. HDF5 ends where its first block states, so that other programs read the file without noticing the line.
/// Reading checks it first, because the HDF5 library can break down on a damaged file.
namespace ringfilm::io {

/// Length of the line with its two line ends [byte].
inline constexpr std::size_t kDigestTrailerSize = 82;

/// The line for bytes whose SHA-256 has these 64 hexadecimal digits.
std::string digest_trailer(std::string_view digits);

/// Do the bytes begin as a NetCDF file, of HDF5 or classic?
bool begins_as_netcdf(std::string_view bytes);

/// Do the bytes end with such a line, be its digest theirs or not?
bool has_digest_trailer(std::string_view bytes);

/// The bytes before the line. Throws InputError if there is no such line, or if the bytes are not those of its digest.
/// @param name how errors name the file
std::string_view content_before_trailer(const std::string& name, std::string_view bytes);

}  // namespace ringfilm::io
