#pragma once
#include "ringfilm/base/pack.hpp"

namespace ringfilm::benchmarks {

/// A machine of its own, so that a pack for it may be a type of its own.
inline constexpr auto kCounted = static_cast<base::InstructionSet>(-1);

/// Additions, subtractions, products and quotients of counted packs so far, one each. Comparisons, choices, signs,
/// loads and stores are not counted.
struct Operations {
  static inline long done = 0;
};

}  // namespace ringfilm::benchmarks

namespace ringfilm::base {

/// A single number that counts what is done with it; all else as of any pack.
template <>
struct Pack<1, benchmarks::kCounted> {
  using Values = double;
  using Mask = bool;
  static constexpr int kWidth = 1;
  double v;

  Pack() = default;
  Pack(double in_all_lanes) : v(in_all_lanes) {}

  static Pack of(double value) { return Pack(value); }
  static Pack load(const double* from) { return Pack(*from); }
  static Pack gather(const double* from, int) { return Pack(*from); }
  static void turn_rows(const double* const* row, Pack (&column)[4]) {
    for (int c = 0; c < 4; ++c) column[c] = Pack(row[0][c]);
  }
  Pack whole(int (&to)[1]) const {
    to[0] = static_cast<int>(v);
    return Pack(to[0]);
  }
  void store(double* to) const { *to = v; }

  friend Pack operator+(Pack a, Pack b) { return counted(a.v + b.v); }
  friend Pack operator-(Pack a, Pack b) { return counted(a.v - b.v); }
  friend Pack operator*(Pack a, Pack b) { return counted(a.v * b.v); }
  friend Pack operator/(Pack a, Pack b) { return counted(a.v / b.v); }
  friend Pack operator-(Pack a) { return Pack(-a.v); }
  Pack& operator+=(Pack b) { return *this = *this + b; }
  Pack& operator-=(Pack b) { return *this = *this - b; }

  friend bool operator<(Pack a, Pack b) { return a.v < b.v; }
  friend bool operator>(Pack a, Pack b) { return a.v > b.v; }
  friend bool operator>=(Pack a, Pack b) { return a.v >= b.v; }
  friend Pack select(bool mask, Pack a, Pack b) { return mask ? a : b; }
  friend Pack max(Pack a, Pack b) { return a.v > b.v ? a : b; }
  friend Pack min(Pack a, Pack b) { return a.v < b.v ? a : b; }
  friend Pack abs(Pack a) { return max(a, -a); }

  static bool last(int count) { return count > 0; }
  static bool both(bool a, bool b) { return a && b; }
  static bool either(bool a, bool b) { return a || b; }
  static bool differ(bool a, bool b) { return a != b; }
  static bool only(bool a, bool b) { return a && !b; }
  static bool any(bool mask) { return mask; }
  double sum() const { return v; }

 private:
  static Pack counted(double result) {
    ++benchmarks::Operations::done;
    return Pack(result);
  }
};

}  // namespace ringfilm::base
