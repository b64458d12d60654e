#pragma once
#include <cstddef>

/// How numbers of a two-dimensional film lie in memory while it is solved: strips of even and odd number apart, like
/// the stripes of a zebra, and along a row (one place across, strips of one colour) side by side. So the neighbours in
/// y of a whole row of even strips are a row of odd ones, and both can be worked on pack by pack.
namespace ringfilm::film {

inline constexpr int kPackPadding = 8;  ///< numbers of the widest pack

struct ZebraShape {
  int n_across = 0;  ///< nodes across
  int n_strips = 0;  ///< those that are solved; a row has room for one neighbour more on either side
  int stride = 0;    ///< from one row to the next

  ZebraShape() = default;
  ZebraShape(int across, int strips)
      : n_across(across),
        n_strips(strips),
        stride(kPackPadding + (strips / 2 + 1 + kPackPadding - 1) / kPackPadding * kPackPadding) {}

  /// Strips of colour 0 (even) or 1 (odd).
  int slots(int colour) const { return (n_strips + 1 - colour) / 2; }
  std::size_t colour_size() const { return static_cast<std::size_t>(n_across) * stride; }
  /// With room behind the last row for its last pack's neighbours, in whole pairs of packs.
  std::size_t size() const { return 2 * (colour_size() + kPackPadding); }
  /// Index of node i of strip s, -1 <= s <= n_strips.
  std::size_t at(int i, int s) const {
    const int colour = s & 1;
    return static_cast<std::size_t>(colour * n_across + i) * stride + kPackPadding + (s - colour) / 2;
  }
  /// Index of a number of a whole strip: of a zebra with one node across.
  std::size_t strip(int s) const {
    const int colour = s & 1;
    return static_cast<std::size_t>(colour) * stride + kPackPadding + (s - colour) / 2;
  }
  std::size_t strip_size() const { return 2 * (static_cast<std::size_t>(stride) + kPackPadding); }
};

/// In a row of the other colour, where the neighbours of slot k are: k + shift.
constexpr int low_shift(int colour) { return colour == 0 ? -1 : 0; }
constexpr int high_shift(int colour) { return colour == 0 ? 0 : 1; }

}  // namespace ringfilm::film
