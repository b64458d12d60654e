#pragma once

/// Packs of numbers that go through a calculation side by side, one in each lane of a vector register. Code written for
/// a pack runs with one number, two, four or eight; every lane sees what it would see alone.
namespace ringfilm::base {

/// What compiled code may ask of the machine. Part of a pack's type, so that functions compiled for different machines
/// never share a name.
enum class InstructionSet { kBaseline, kAvx2, kAvx512 };

#define RINGFILM_INLINE [[gnu::always_inline]] inline
/// RINGFILM_INLINE for a lambda, placed after its parameters.
#define RINGFILM_INLINE_BODY __attribute__((always_inline))

template <int kWidth>
struct PackValues {
  typedef double Values __attribute__((vector_size(8 * kWidth)));
  typedef long long Mask __attribute__((vector_size(8 * kWidth)));
  typedef int Whole __attribute__((vector_size(4 * kWidth)));
};
template <>
struct PackValues<1> {
  typedef double Values;
  typedef bool Mask;
};

/// `kLanes` doubles. Where the instruction set has it, a product may be fused with the sum that it enters.
template <int kLanes, InstructionSet kSet>
struct Pack {
  using Values = typename PackValues<kLanes>::Values;
  using Mask = typename PackValues<kLanes>::Mask;
  static constexpr int kWidth = kLanes;
  Values v;

  Pack() = default;
  RINGFILM_INLINE Pack(double in_all_lanes) : v(in_all_lanes - Values{}) {}

  RINGFILM_INLINE static Pack of(Values values) {
    Pack p;
    p.v = values;
    return p;
  }
  RINGFILM_INLINE static Pack load(const double* from) {
    Pack p;
    __builtin_memcpy(&p.v, from, sizeof p.v);
    return p;
  }
  /// Numbers that lie `stride` apart.
  RINGFILM_INLINE static Pack gather(const double* from, int stride) {
    if constexpr (kLanes == 8) {
      return of(Values{from[0], from[stride], from[2 * stride], from[3 * stride], from[4 * stride], from[5 * stride],
                       from[6 * stride], from[7 * stride]});
    } else if constexpr (kLanes == 4) {
      return of(Values{from[0], from[stride], from[2 * stride], from[3 * stride]});
    } else if constexpr (kLanes == 2) {
      return of(Values{from[0], from[stride]});
    } else {
      return load(from);
    }
  }
  /// The four numbers of a row for each lane, a pack for each column.
  RINGFILM_INLINE static void turn_rows(const double* const* row, Pack (&column)[4]) {
    if constexpr (kLanes == 1) {
      for (int c = 0; c < 4; ++c) column[c] = load(row[0] + c);
    } else if constexpr (kLanes == 2) {
      for (int c = 0; c < 4; c += 2) {
        const Values one = load(row[0] + c).v, other = load(row[1] + c).v;
        column[c] = of(__builtin_shufflevector(one, other, 0, 2));
        column[c + 1] = of(__builtin_shufflevector(one, other, 1, 3));
      }
    } else if constexpr (kLanes == 4) {
      for (int c = 0; c < 4; ++c) column[c] = of(Values{row[0][c], row[1][c], row[2][c], row[3][c]});
    } else {
      typedef double Row __attribute__((vector_size(32)));
      Values both[4];  // rows of lanes k and k + 4
      for (int k = 0; k < 4; ++k) {
        Row low, high;
        __builtin_memcpy(&low, row[k], sizeof low);
        __builtin_memcpy(&high, row[k + 4], sizeof high);
        both[k] = __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
      }
      const Values even_01 = __builtin_shufflevector(both[0], both[1], 0, 8, 2, 10, 4, 12, 6, 14);
      const Values odd_01 = __builtin_shufflevector(both[0], both[1], 1, 9, 3, 11, 5, 13, 7, 15);
      const Values even_23 = __builtin_shufflevector(both[2], both[3], 0, 8, 2, 10, 4, 12, 6, 14);
      const Values odd_23 = __builtin_shufflevector(both[2], both[3], 1, 9, 3, 11, 5, 13, 7, 15);
      column[0] = of(__builtin_shufflevector(even_01, even_23, 0, 1, 8, 9, 4, 5, 12, 13));
      column[1] = of(__builtin_shufflevector(odd_01, odd_23, 0, 1, 8, 9, 4, 5, 12, 13));
      column[2] = of(__builtin_shufflevector(even_01, even_23, 2, 3, 10, 11, 6, 7, 14, 15));
      column[3] = of(__builtin_shufflevector(odd_01, odd_23, 2, 3, 10, 11, 6, 7, 14, 15));
    }
  }
  /// The whole numbers below numbers from 0 to the largest int, which go to `to` as well.
  RINGFILM_INLINE Pack whole(int (&to)[kLanes]) const {
    if constexpr (kLanes == 1) {
      to[0] = static_cast<int>(v);
      return Pack(to[0]);
    } else {
      const auto below = __builtin_convertvector(v, typename PackValues<kLanes>::Whole);
      __builtin_memcpy(to, &below, sizeof below);
      return of(__builtin_convertvector(below, Values));
    }
  }
  RINGFILM_INLINE void store(double* to) const { __builtin_memcpy(to, &v, sizeof v); }

  RINGFILM_INLINE friend Pack operator+(Pack a, Pack b) { return of(a.v + b.v); }
  RINGFILM_INLINE friend Pack operator-(Pack a, Pack b) { return of(a.v - b.v); }
  RINGFILM_INLINE friend Pack operator*(Pack a, Pack b) { return of(a.v * b.v); }
  RINGFILM_INLINE friend Pack operator/(Pack a, Pack b) { return of(a.v / b.v); }
  RINGFILM_INLINE friend Pack operator-(Pack a) { return of(-a.v); }
  RINGFILM_INLINE Pack& operator+=(Pack b) { return *this = *this + b; }
  RINGFILM_INLINE Pack& operator-=(Pack b) { return *this = *this - b; }

  RINGFILM_INLINE friend Mask operator<(Pack a, Pack b) { return a.v < b.v; }
  RINGFILM_INLINE friend Mask operator>(Pack a, Pack b) { return a.v > b.v; }
  RINGFILM_INLINE friend Mask operator>=(Pack a, Pack b) { return a.v >= b.v; }

  /// a where the mask holds, else b.
  RINGFILM_INLINE friend Pack select(Mask mask, Pack a, Pack b) { return of(mask ? a.v : b.v); }
  /// Larger of a and b; b where one of them is not a number.
  RINGFILM_INLINE friend Pack max(Pack a, Pack b) { return of(a.v > b.v ? a.v : b.v); }
  RINGFILM_INLINE friend Pack min(Pack a, Pack b) { return of(a.v < b.v ? a.v : b.v); }
  RINGFILM_INLINE friend Pack abs(Pack a) { return max(a, -a); }
  RINGFILM_INLINE friend Pack sqrt(Pack a) {
    double lanes[kLanes];
    a.store(lanes);
    for (double& one : lanes) one = __builtin_sqrt(one);
    return load(lanes);
  }

  RINGFILM_INLINE static Mask both(Mask a, Mask b) {
    if constexpr (kLanes == 1) {
      return a && b;
    } else {
      return a & b;
    }
  }
  /// The last `count` lanes.
  RINGFILM_INLINE static Mask last(int count) {
    double from_end[kLanes];
    for (int lane = 0; lane < kLanes; ++lane) from_end[lane] = kLanes - lane;
    return load(from_end) < Pack(count + 0.5);
  }
  RINGFILM_INLINE static Mask differ(Mask a, Mask b) {
    if constexpr (kLanes == 1) {
      return a != b;
    } else {
      return a ^ b;
    }
  }
  /// Where a holds and b does not.
  RINGFILM_INLINE static Mask only(Mask a, Mask b) {
    if constexpr (kLanes == 1) {
      return a && !b;
    } else {
      return a & ~b;
    }
  }
  RINGFILM_INLINE static bool any(Mask mask) {
    if constexpr (kLanes == 1) {
      return mask;
#if defined(__AVX512DQ__)
    } else if constexpr (kLanes == 8) {
      return __builtin_ia32_cvtq2mask512(mask) != 0;
#endif
#if defined(__AVX__)
    } else if constexpr (kLanes == 4) {
      return __builtin_ia32_movmskpd256(reinterpret_cast<Values>(mask)) != 0;
#endif
    } else {
      long long found = 0;
      for (int lane = 0; lane < kLanes; ++lane) found |= mask[lane];
      return found != 0;
    }
  }
  /// Sum over the lanes, from the first on.
  RINGFILM_INLINE double sum() const {
    if constexpr (kLanes == 1) {
      return v;
    } else {
      double total = v[0];
      for (int lane = 1; lane < kLanes; ++lane) total += v[lane];
      return total;
    }
  }
};

/// One polynomial with `kTerms` coefficients, lowest power first, at several packs: side by side, so that no sum waits
/// for its last term.
template <int kTerms, int kAbreast, class Real>
RINGFILM_INLINE void sum_of_powers(const double* c, const Real* t, Real* value) {
  for (int a = 0; a < kAbreast; ++a) value[a] = Real(c[kTerms - 1]);
#pragma GCC unroll 32
  for (int k = kTerms - 2; k >= 0; --k) {
    for (int a = 0; a < kAbreast; ++a) value[a] = value[a] * t[a] + Real(c[k]);
  }
}

}  // namespace ringfilm::base
