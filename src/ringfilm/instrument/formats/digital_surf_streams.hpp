#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "ringfilm/instrument/grid/binary_reader.hpp"

/// Packed heights of compressed Digital Surf files (DSCOMPRESSED): a table of sizes, then zlib streams (RFC 1950).
namespace ringfilm::instrument {

/// One stream in the file.
struct PackedStream {
  std::size_t offset = 0;    ///< first byte in the file
  std::size_t packed = 0;    ///< bytes in the file
  std::size_t unpacked = 0;  ///< bytes of heights
};

/// The streams of a block of heights, which lie one behind the other.
struct PackedHeights {
  std::vector<PackedStream> streams;
  std::size_t end = 0;  ///< first byte of the file behind them
};

/// The table at `offset`: number of streams, and of each its unpacked and its packed size (32 bit). Throws InputError
/// where the streams reach past the end of the file or do not unpack to `length` bytes.
PackedHeights packed_heights(const BinaryReader& in, std::size_t offset, std::size_t length);

/// The heights, `length` bytes. Throws InputError for a damaged stream, or one that unpacks to another size than
/// stated.
std::string unpacked_heights(const BinaryReader& in, const PackedHeights& packed, std::size_t length);

}  // namespace ringfilm::instrument
