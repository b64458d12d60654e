#include "ringfilm/instrument/formats/digital_surf_streams.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <cstdint>

namespace ringfilm::instrument {
namespace {

constexpr std::size_t kEntrySize = 8;     // unpacked and packed size of a stream
constexpr std::size_t kMaxPacked = 1032;  // deflate packs at most 258 bytes into 2 bit
constexpr char kDamaged[] = "the file was cut short or damaged: copy it again, or save it without compression";

/// Ends a stream of zlib in any case.
class Inflation {
 public:
  Inflation() { is_ready_ = inflateInit(&stream_) == Z_OK; }
  Inflation(const Inflation&) = delete;
  Inflation& operator=(const Inflation&) = delete;
  ~Inflation() {
    if (is_ready_) inflateEnd(&stream_);
  }

  /// Unpacks all of `packed` into the `room` bytes at `target`, which it must fill.
  bool fills(std::string_view packed, char* target, std::size_t room) {
    if (!is_ready_) return false;
    // zlib writes to next_out alone, but its member next_in is not const.
    stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
    stream_.avail_in = static_cast<uInt>(packed.size());
    stream_.next_out = reinterpret_cast<Bytef*>(target);
    stream_.avail_out = static_cast<uInt>(room);
    return inflate(&stream_, Z_FINISH) == Z_STREAM_END && stream_.avail_out == 0;
  }

 private:
  z_stream stream_{};
  bool is_ready_ = false;
};

}  // namespace

PackedHeights packed_heights(const BinaryReader& in, std::size_t offset, std::size_t length) {
  const std::size_t count = in.number<std::uint32_t>(offset, "the number of packed streams");
  const std::size_t table = offset + 4;
  if (count == 0 || count > in.size() / kEntrySize) {
    in.refuse_at(offset, fmt::format("the heights are packed in {} streams", count), kDamaged);
  }
  in.at(table, count * kEntrySize, "the table of packed streams");
  PackedHeights packed;
  packed.end = table + count * kEntrySize;
  std::size_t total = 0;
  for (std::size_t i = 0; i < count; ++i) {
    PackedStream stream;
    stream.unpacked = in.number<std::uint32_t>(table + i * kEntrySize, "the unpacked size of a stream");
    stream.packed = in.number<std::uint32_t>(table + i * kEntrySize + 4, "the packed size of a stream");
    stream.offset = packed.end;
    const std::string name = fmt::format("packed stream {} of {}", i + 1, count);
    in.at(stream.offset, stream.packed, name);
    if (stream.unpacked > kMaxPacked * (stream.packed + 1)) {
      in.refuse_at(
          table + i * kEntrySize,
          fmt::format("{} has {} bytes, and {} unpacked: more than any can hold", name, stream.packed, stream.unpacked),
          kDamaged);
    }
    packed.end += stream.packed;
    total += stream.unpacked;
    packed.streams.push_back(stream);
  }
  if (total != length) {
    in.refuse_at(offset, fmt::format("the packed streams hold {} bytes, and the map needs {}", total, length),
                 kDamaged);
  }
  return packed;
}

std::string unpacked_heights(const BinaryReader& in, const PackedHeights& packed, std::size_t length) {
  std::string heights(length, '\0');
  std::size_t place = 0;
  for (const PackedStream& stream : packed.streams) {
    const std::string_view bytes = in.at(stream.offset, stream.packed, "a packed stream");
    if (!Inflation().fills(bytes, heights.data() + place, stream.unpacked)) {
      in.refuse_at(stream.offset, fmt::format("this zlib stream does not unpack to {} bytes", stream.unpacked),
                   kDamaged);
    }
    place += stream.unpacked;
  }
  return heights;
}

}  // namespace ringfilm::instrument
