#pragma once
#include "ringfilm/base/pack.hpp"
#include "ringfilm/film/kernels/film2d_kernels.hpp"
#include "ringfilm/film/kernels/newton_sweep.hpp"

/// One iteration of Newton's method on a two-dimensional film, pack by pack: a lane is a strip.
/// docs/theory/two-dimensional-film.md.
namespace ringfilm::film {

/// Calls body(colour, k): packs that start at slot k, of both colours.
template <class Real, class Body>
RINGFILM_INLINE void for_packs(const ZebraShape& shape, const Body& body) {
  for (int colour = 0; colour < 2; ++colour) {
    for (int k = 0; k < shape.slots(colour); k += Real::kWidth) body(colour, k);
  }
}

/// @tparam kBends the ring bends: slopes by the separations of the strips apart. A choice of the compiler, not of the
/// machine: which products and sums it fuses, and so the last bit, depends on all that is done with them.
template <class Real, LaneCavity kCavity, bool kSteps, Terms kTerms, bool kBends>
class Film2dBalance {
  using Mask = typename Real::Mask;
  static constexpr bool kFilmContent = kCavity == LaneCavity::kFilmContent;

 public:
  RINGFILM_INLINE explicit Film2dBalance(Film2dBlock& block)
      : b_(block),
        shape_(block.system.shape),
        inverse_content_scale_(1 / block.content_scale),
        motion_(Real(block.quarter_U), inverse_content_scale_),
        ln_h_scale_(block.ln_h_scale) {}

  RINGFILM_INLINE void run() {
    for (int colour = 0; colour < 2; ++colour) {
      for (int i = 0; i < shape_.n_across - 1; ++i) row(colour, i);
    }
    b_.load = mean_load();
  }

 private:
  using Node = film::Node<Real>;
  using Flux = film::Flux<Real>;

  RINGFILM_INLINE Node node(std::size_t place) const {
    const Real z = Real::load(b_.z + place);
    Real p = max(Real(0), z);  // over p_c: gradients alone count
    if constexpr (kTerms == Terms::kAll) p += Real::load(b_.bound + place);
    const Real theta = kFilmContent ? Real(1) + min(Real(0), z) * inverse_content_scale_ : Real(1);
    return {p,
            theta,
            Real::load(b_.rho + place),
            Real::load(b_.drho_dp + place),
            Real::load(b_.K + place),
            Real::load(b_.dK_dp + place),
            z > Real(0),
            theta};
  }

  /// The node as flow by pressure in one direction sees it. @param mobility of that direction
  RINGFILM_INLINE Node mobile(Node node, const double* mobility, std::size_t place) const {
    if constexpr (kTerms == Terms::kAll) {
      const Real factor = Real::load(mobility + place);
      node.K = factor * node.K;
      node.dK = factor * node.dK;
    }
    return node;
  }

  /// Mean of h^3 over a face, and a third of its slope in h_m.
  struct Cube {
    Real value, square;
  };
  RINGFILM_INLINE Cube cube(Real h, const double* second, const double* third, std::size_t place) const {
    const Real square = h * h;
    if constexpr (kSteps) {
      const Real variance = Real::load(second + place);
      return {h * (square + Real(3) * variance) + Real::load(third + place), square + variance};
    } else {
      return {square * h, square};
    }
  }

  RINGFILM_INLINE static Flux cross_flux(Cube cubed, Real conductance, const Node& low, const Node& high) {
    return film::cross_flux(conductance * cubed.value, conductance * cubed.square, low, high);
  }

  RINGFILM_INLINE Flux flux_after(int i, std::size_t place, Real h_m, const Node& left, const Node& right) const {
    const Real h = h_m + Real::load(b_.face_x + place);
    const Cube cubed = cube(h, b_.face_x_second, b_.face_x_third, place);
    const Real conductance(b_.conductance[i]);
    Real upstream = h;
    if constexpr (kFilmContent) {
      upstream = h_m + motion_.upstream(Real::load(b_.node_height + place),
                                        Real::load(b_.node_height + place + shape_.stride));
    }
    if constexpr (kTerms == Terms::kAll) {
      const Real beyond = Real::load(b_.carried + place), carried = h + beyond;
      Flux flux = film::flux(motion_, carried, upstream + beyond, conductance * cubed.value, conductance * cubed.square,
                             left, right);
      const auto is_steady = Real(0) >= Real(b_.rate);
      if (i == 0) limit_inlet(motion_.quarter_U, carried, Real(1), Real(b_.left_supply), is_steady, left, right, flux);
      if (i == shape_.n_across - 2)
        limit_inlet(motion_.quarter_U, carried, Real(-1), Real(b_.right_supply), is_steady, left, right, flux);
      return flux;
    } else {
      return film::flux(motion_, h, upstream, conductance * cubed.value, conductance * cubed.square, left, right);
    }
  }

  /// Flux on from node i, and the balance of node i if it is not an edge.
  RINGFILM_INLINE void row(int colour, int i) {
    const std::size_t begin = static_cast<std::size_t>(colour * shape_.n_across + i) * shape_.stride + kPackPadding;
    const std::size_t strips = static_cast<std::size_t>(colour) * shape_.stride + kPackPadding;
    const std::ptrdiff_t other = static_cast<std::ptrdiff_t>(shape_.colour_size()) * (1 - 2 * colour);
    for (int k = 0; k < shape_.slots(colour); k += Real::kWidth) {
      const std::size_t place = begin + k, strip = strips + k;
      const Node here = node(place);
      const std::size_t next = place + shape_.stride;
      Flux out = flux_after(i, place, Real::load(b_.h_m + strip), mobile(here, b_.mobility, place),
                            mobile(node(next), b_.mobility, next));
      if (i == shape_.n_across - 2) out.by_right = Real(0);  // the edges are given
      if (i == 0) out.by_left = Real(0);
      if (i > 0) {
        const std::size_t low = place + other + low_shift(colour), high = place + other + high_shift(colour);
        balance(i, place, strip, mobile(here, b_.mobility_across, place), mobile(node(low), b_.mobility_across, low),
                mobile(node(high), b_.mobility_across, high), taken(strip), out);
      }
      give(strip, out);
    }
  }

  /// The flux that the row before has left, of each strip.
  RINGFILM_INLINE Flux taken(std::size_t strip) const {
    return {Real::load(b_.flux + strip), Real::load(b_.flux_by_left + strip), Real::load(b_.flux_by_right + strip),
            Real::load(b_.flux_by_h + strip)};
  }
  RINGFILM_INLINE void give(std::size_t strip, const Flux& flux) {
    flux.value.store(b_.flux + strip);
    flux.by_left.store(b_.flux_by_left + strip);
    flux.by_right.store(b_.flux_by_right + strip);
    flux.by_h.store(b_.flux_by_h + strip);
  }

  RINGFILM_INLINE void balance(int i, std::size_t place, std::size_t strip, const Node& here, const Node& low,
                               const Node& high, const Flux& in, const Flux& out) {
    const StripSystem& to = b_.system;
    const Real h_m = Real::load(b_.h_m + strip);
    const Mask inside = Real::load(b_.is_strip + strip) > Real(0);
    const Real share(b_.share[i]);
    const Cube low_cube =
        cube(Real::load(b_.low_h_m + strip) + Real::load(b_.low_face + place), b_.low_second, b_.low_third, place);
    const Cube high_cube =
        cube(Real::load(b_.high_h_m + strip) + Real::load(b_.high_face + place), b_.high_second, b_.high_third, place);
    const Flux from = cross_flux(low_cube, share * Real::load(b_.low_conductance + strip), low, here);
    const Flux on = cross_flux(high_cube, share * Real::load(b_.high_conductance + strip), here, high);

    const Real height = Real::load(b_.node_height + place);
    const Real volume = share * Real(b_.rate);
    Real gap = h_m + height;
    if constexpr (kTerms == Terms::kAll) gap += Real::load(b_.stored + place);
    const Real stored = volume * gap;  // times rho theta
    const Real filled = filled_density<kFilmContent>(here);
    Real residual = stored * filled - Real::load(b_.inflow + place) + (out.value - in.value) + (on.value - from.value);
    Real diagonal = (out.by_left - in.by_right) + (on.by_left - from.by_right);
    if constexpr (kFilmContent) {
      diagonal += stored * filled_density_slope(here, inverse_content_scale_);
    } else {
      const Real multiplier = multiplier_weight(Real(b_.conductance[i - 1] + b_.conductance[i]),
                                                Real(b_.start_h) + height, Real(b_.cavity_K));
      diagonal = select(here.is_film, diagonal + stored * here.drho, multiplier);
      residual += multiplier * min(Real(0), Real::load(b_.z + place));
    }
    const Real by_h = (volume * filled + (out.by_h - in.by_h) + (on.by_h - from.by_h)) * ln_h_scale_;
    // Rows of the system in units of z: what is left of them can be compared.
    const Real per_diagonal = select(inside, Real(1) / select(inside, diagonal, Real(1)), Real(0));
    (-(in.by_left * per_diagonal)).store(to.west + place);
    (out.by_right * per_diagonal).store(to.east + place);
    (-(from.by_left * per_diagonal)).store(to.low + place);
    (on.by_right * per_diagonal).store(to.high + place);
    (by_h * per_diagonal).store(b_.column + place);
    if constexpr (kBends) {
      const Real scale = per_diagonal * ln_h_scale_;
      ((volume * filled + (out.by_h - in.by_h)) * scale).store(b_.own_column + place);
      (-(from.by_h * scale)).store(b_.low_column + place);
      (on.by_h * scale).store(b_.high_column + place);
    }
    (-(residual * per_diagonal)).store(b_.rhs + place);
    select(here.is_film, share * Real::load(b_.weight + strip), Real(0)).store(b_.load_row + place);
    diagonal.store(to.diagonal + place);
  }

  /// Over all nodes, of strips that are given too.
  RINGFILM_INLINE double mean_load() const {
    Real load(0);
    for (int colour = 0; colour < 2; ++colour) {
      for (int i = 0; i < shape_.n_across; ++i) {
        const std::size_t row = static_cast<std::size_t>(colour * shape_.n_across + i) * shape_.stride;
        Real along(0);
        for (int k = 0; k + Real::kWidth <= shape_.stride; k += Real::kWidth) {
          const Real weight = Real::load(b_.weight + static_cast<std::size_t>(colour) * shape_.stride + k);
          Real over = max(Real(0), Real::load(b_.z + row + k));
          if constexpr (kTerms == Terms::kAll) over += Real::load(b_.bound + row + k);
          along += weight * (Real(b_.p_cavitation) + over);
        }
        load += Real(b_.share[i]) * along;
      }
    }
    return load.sum();
  }

  Film2dBlock& b_;
  const ZebraShape shape_;
  Real inverse_content_scale_;
  Motion<Real, kFilmContent, kTerms> motion_;
  Real ln_h_scale_;
};

template <class Real>
void oil(Film2dBlock& b) {
  constexpr int kAbreast = 2;
  static_assert(kPackPadding % (Real::kWidth) == 0);
  const std::size_t n = b.system.shape.size();
  for (std::size_t place = 0; place < n; place += kAbreast * Real::kWidth) {
    Real t[kAbreast], value[kAbreast];
    const auto store = [&](double* to) RINGFILM_INLINE_BODY {
      for (int a = 0; a < kAbreast; ++a) value[a].store(to + place + a * Real::kWidth);
    };
    for (int a = 0; a < kAbreast; ++a) {
      Real p = Real(b.p_cavitation) + max(Real(0), Real::load(b.z + place + a * Real::kWidth));
      if (b.terms == Terms::kAll) p += Real::load(b.bound + place + a * Real::kWidth);
      t[a] = min(Real(1), (p - Real(b.fit_centre)) * Real(b.fit_inverse_half_width));
    }
    base::sum_of_powers<kFluidityTerms, kAbreast>(b.fit_K, t, value);
    store(b.K);
    base::sum_of_powers<kFluiditySlopeTerms, kAbreast>(b.fit_dK, t, value);
    store(b.dK_dp);
    base::sum_of_powers<kDensityTerms, kAbreast>(b.fit_rho, t, value);
    store(b.rho);
    base::sum_of_powers<kDensitySlopeTerms, kAbreast>(b.fit_drho, t, value);
    store(b.drho_dp);
  }
}

template <class Real, LaneCavity kCavity, bool kSteps, Terms kTerms>
void balance_of_steps(Film2dBlock& b) {
  if (b.own_column != nullptr) {
    Film2dBalance<Real, kCavity, kSteps, kTerms, true>(b).run();
  } else {
    Film2dBalance<Real, kCavity, kSteps, kTerms, false>(b).run();
  }
}

template <class Real, LaneCavity kCavity, Terms kTerms>
void balance_of(Film2dBlock& b) {
  if (b.has_steps) {
    balance_of_steps<Real, kCavity, true, kTerms>(b);
  } else {
    balance_of_steps<Real, kCavity, false, kTerms>(b);
  }
}

template <class Real>
void balance(Film2dBlock& b) {
  using enum LaneCavity;
  using enum Terms;
  if (b.cavity == kFilmContent) {
    b.terms == kPlain ? balance_of<Real, kFilmContent, kPlain>(b) : balance_of<Real, kFilmContent, kAll>(b);
  } else {
    b.terms == kPlain ? balance_of<Real, kMultiplier, kPlain>(b) : balance_of<Real, kMultiplier, kAll>(b);
  }
}

template <class Real, bool kFilmContent, Terms kTerms>
void update_nodes(Film2dBlock& b, const double* step) {
  const ZebraShape& shape = b.system.shape;
  KinkStep<Real> kink{Real(b.scale), Real(1 / b.scale), Real(b.content_scale), Real(1 / b.content_scale)};
  Real peak(0), check(0);
  for_packs<Real>(shape, [&](int colour, int k) RINGFILM_INLINE_BODY {
    const auto inside =
        Real::load(b.is_strip + static_cast<std::size_t>(colour) * shape.stride + kPackPadding + k) > Real(0);
    for (int i = 1; i < shape.n_across - 1; ++i) {
      const std::size_t place = static_cast<std::size_t>(colour * shape.n_across + i) * shape.stride + kPackPadding + k;
      const Real move = select(inside, Real::load(step + place), Real(0));
      const Real after = kink.template take<kFilmContent>(Real::load(b.z + place), move);
      check += select(inside, after, Real(0));
      Real over = after;
      if constexpr (kTerms == Terms::kAll) over = max(Real(0), after) + Real::load(b.bound + place);
      peak = max(peak, select(inside, over, Real(0)));
      after.store(b.z + place);
    }
  });
  double lanes[Real::kWidth];
  const auto highest = [&](Real of) RINGFILM_INLINE_BODY {
    of.store(lanes);
    double most_of_all = lanes[0];
    for (const double lane : lanes) most_of_all = lane > most_of_all ? lane : most_of_all;
    return most_of_all;
  };
  b.largest = highest(kink.largest);
  b.peak = highest(peak);
  b.check = check.sum();
  b.to_film = highest(kink.to_film) > 0;
  b.to_cavity = highest(kink.to_cavity) > 0;
}

template <class Real>
void update(Film2dBlock& b, const double* step) {
  using enum Terms;
  if (b.cavity == LaneCavity::kFilmContent) {
    b.terms == kPlain ? update_nodes<Real, true, kPlain>(b, step) : update_nodes<Real, true, kAll>(b, step);
  } else {
    b.terms == kPlain ? update_nodes<Real, false, kPlain>(b, step) : update_nodes<Real, false, kAll>(b, step);
  }
}

/// Calls body(place) for the packs of a row that hold strips: node i across, strips of one colour. Rows are worked on
/// one after the other, as they lie in memory.
template <class Real, class Body>
RINGFILM_INLINE void for_row(const ZebraShape& shape, int colour, int i, const Body& body) {
  const std::size_t row = static_cast<std::size_t>(colour * shape.n_across + i) * shape.stride + kPackPadding;
  const int slots = shape.slots(colour);
  for (int k = 0; k < slots; k += Real::kWidth) body(row + k);
}

/// The system's diagonal is 1: what is left of it after the elimination of the node before is inverted.
template <class Real>
void factor(const StripSystem& s) {
  const std::size_t stride = s.shape.stride;
  for (int colour = 0; colour < 2; ++colour) {
    for (int i = 1; i < s.shape.n_across - 1; ++i) {
      for_row<Real>(s.shape, colour, i, [&](std::size_t place) RINGFILM_INLINE_BODY {
        const Real inverse = Real(1) / (Real(1) - Real::load(s.west + place) * Real::load(s.upper + place - stride));
        inverse.store(s.inverse + place);
        (Real::load(s.east + place) * inverse).store(s.upper + place);
      });
    }
  }
}

template <class Real>
void relax(const StripSystem& s, int colour, const double* rhs, double* x) {
  const int n = s.shape.n_across - 1;
  const std::size_t stride = s.shape.stride;
  // From a place to the same slot of the other colour.
  const std::ptrdiff_t other = static_cast<std::ptrdiff_t>(s.shape.colour_size()) * (1 - 2 * colour);
  for (int i = 1; i < n; ++i) {
    for_row<Real>(s.shape, colour, i, [&](std::size_t place) RINGFILM_INLINE_BODY {
      const double* beside = x + place + other;
      const Real given = Real::load(rhs + place) - Real::load(s.low + place) * Real::load(beside + low_shift(colour)) -
                         Real::load(s.high + place) * Real::load(beside + high_shift(colour));
      const Real before = Real::load(x + place - stride);
      ((given - Real::load(s.west + place) * before) * Real::load(s.inverse + place)).store(x + place);
    });
  }
  for (int i = n - 2; i > 0; --i) {
    for_row<Real>(s.shape, colour, i, [&](std::size_t place) RINGFILM_INLINE_BODY {
      (Real::load(x + place) - Real::load(s.upper + place) * Real::load(x + place + stride)).store(x + place);
    });
  }
}

template <class Real>
void product(const StripSystem& s, const double* x, double* y) {
  const std::size_t stride = s.shape.stride;
  for (int colour = 0; colour < 2; ++colour) {
    const std::ptrdiff_t other = static_cast<std::ptrdiff_t>(s.shape.colour_size()) * (1 - 2 * colour);
    for (int i = 1; i < s.shape.n_across - 1; ++i) {
      for_row<Real>(s.shape, colour, i, [&](std::size_t place) RINGFILM_INLINE_BODY {
        const double* beside = x + place + other;
        const Real sum = Real::load(x + place) + Real::load(s.west + place) * Real::load(x + place - stride) +
                         Real::load(s.east + place) * Real::load(x + place + stride) +
                         Real::load(s.low + place) * Real::load(beside + low_shift(colour)) +
                         Real::load(s.high + place) * Real::load(beside + high_shift(colour));
        sum.store(y + place);
      });
    }
  }
}

/// Strips that are worked on at a time between a two-dimensional film and a coarser one.
inline constexpr int kTransfer = 64;

template <class Real>
void to_coarse(const ZebraShape& fine, const double* weight, const double* rhs, const ZebraShape& coarse, double* to) {
  const int n = coarse.n_strips;
  for (int i = 1; i < fine.n_across - 1; ++i) {
    const std::size_t even = fine.at(i, 0), odd = fine.at(i, 1);
    double* to_even = to + coarse.at(i, 0);
    double* to_odd = to + coarse.at(i, 1);
    for (int begin = 0; begin < n; begin += kTransfer) {
      alignas(64) double sum[kTransfer];
      for (int k = 0; k < kTransfer && begin + k < n; k += Real::kWidth) {
        const std::size_t a = even + begin + k, b = odd + begin + k;
        (Real::load(weight + a) * Real::load(rhs + a) + Real::load(weight + b) * Real::load(rhs + b)).store(sum + k);
      }
      const int count = n - begin < kTransfer ? n - begin : kTransfer;
      for (int k = 0; k < count; k += 2) to_even[(begin + k) / 2] = sum[k];
      for (int k = 1; k < count; k += 2) to_odd[(begin + k) / 2] = sum[k];
    }
  }
}

/// Interpolates the odd strips alone: the even strips are relaxed first, whatever their values are.
template <class Real>
void from_coarse(const ZebraShape& coarse, const double* x, const ZebraShape& fine, const double* own,
                 const double* beside, double* to) {
  const int n = fine.slots(1);
  for (int i = 1; i < fine.n_across - 1; ++i) {
    const double* from_even = x + coarse.at(i, 0);
    const double* from_odd = x + coarse.at(i, 1);
    const std::size_t odd = fine.at(i, 1);
    for (int begin = 0; begin < n; begin += kTransfer) {
      alignas(64) double strip[kTransfer + kPackPadding] = {};
      const int count = n - begin < kTransfer ? n - begin : kTransfer;
      for (int k = 0; k <= count; k += 2) strip[k] = from_even[(begin + k) / 2];
      for (int k = 1; k <= count; k += 2) strip[k] = from_odd[(begin + k) / 2];
      for (int k = 0; k < count; k += Real::kWidth) {
        const std::size_t place = odd + begin + k;
        (Real::load(own + place) * Real::load(strip + k) + Real::load(beside + place) * Real::load(strip + k + 1))
            .store(to + place);
      }
    }
  }
}

/// Calls body(place, strip) for the packs of all nodes across, edges included.
template <class Real, class Body>
RINGFILM_INLINE void for_strips(const ZebraShape& shape, const Body& body) {
  for (int colour = 0; colour < 2; ++colour) {
    const std::size_t strips = static_cast<std::size_t>(colour) * shape.stride + kPackPadding;
    const int slots = shape.slots(colour);
    for (int i = 0; i < shape.n_across; ++i) {
      const std::size_t row = static_cast<std::size_t>(colour * shape.n_across + i) * shape.stride + kPackPadding;
      for (int k = 0; k < slots; k += Real::kWidth) body(i, row + k, strips + k);
    }
  }
}

template <class Real>
void add_columns(const Film2dBlock& b, const double* own, const double* low, const double* high, double* y) {
  for_strips<Real>(b.system.shape, [&](int, std::size_t place, std::size_t strip) RINGFILM_INLINE_BODY {
    const Real sum = Real::load(b.own_column + place) * Real::load(own + strip) +
                     Real::load(b.low_column + place) * Real::load(low + strip) +
                     Real::load(b.high_column + place) * Real::load(high + strip);
    (Real::load(y + place) + sum).store(y + place);
  });
}

template <class Real>
void strip_sums(const ZebraShape& shape, const double* row, const double* x, double* sums) {
  for (std::size_t strip = 0; strip < shape.strip_size(); ++strip) sums[strip] = 0;
  for_strips<Real>(shape, [&](int, std::size_t place, std::size_t strip) RINGFILM_INLINE_BODY {
    (Real::load(sums + strip) + Real::load(row + place) * Real::load(x + place)).store(sums + strip);
  });
}

template <class Real>
void strip_loads(const Film2dBlock& b, double* loads) {
  const ZebraShape& shape = b.system.shape;
  for (std::size_t strip = 0; strip < shape.strip_size(); ++strip) loads[strip] = 0;
  for_strips<Real>(shape, [&](int i, std::size_t place, std::size_t strip) RINGFILM_INLINE_BODY {
    const Real p = Real(b.p_cavitation) + Real::load(b.bound + place) + max(Real(0), Real::load(b.z + place));
    (Real::load(loads + strip) + Real(b.share[i]) * p).store(loads + strip);
  });
}

template <class Real>
void take_columns(const ZebraShape& shape, const double* column, const double* of_strip, double* x) {
  for_strips<Real>(shape, [&](int, std::size_t place, std::size_t strip) RINGFILM_INLINE_BODY {
    (Real::load(x + place) - Real::load(column + place) * Real::load(of_strip + strip)).store(x + place);
  });
}

template <class Real>
double dot(const double* a, const double* b, std::size_t n) {
  Real sum[4] = {Real(0), Real(0), Real(0), Real(0)};
  std::size_t i = 0;
  for (; i + 4 * Real::kWidth <= n; i += 4 * Real::kWidth) {
    for (int s = 0; s < 4; ++s) {
      const std::size_t at = i + static_cast<std::size_t>(s) * Real::kWidth;
      sum[s] += Real::load(a + at) * Real::load(b + at);
    }
  }
  double total = ((sum[0] + sum[1]) + (sum[2] + sum[3])).sum();
  for (; i < n; ++i) total += a[i] * b[i];
  return total;
}

template <class Real>
void add(double c, const double* x, double* y, std::size_t n) {
  std::size_t i = 0;
  for (; i + Real::kWidth <= n; i += Real::kWidth) {
    (Real::load(y + i) + Real(c) * Real::load(x + i)).store(y + i);
  }
  for (; i < n; ++i) y[i] += c * x[i];
}

template <int kWidth, base::InstructionSet kSet>
constexpr Film2dKernels film2d_kernels_of(std::string_view name) {
  using Real = base::Pack<kWidth, kSet>;
  return {name,
          oil<Real>,
          balance<Real>,
          update<Real>,
          factor<Real>,
          relax<Real>,
          product<Real>,
          to_coarse<Real>,
          from_coarse<Real>,
          add_columns<Real>,
          strip_sums<Real>,
          strip_loads<Real>,
          take_columns<Real>,
          dot<Real>,
          add<Real>};
}

}  // namespace ringfilm::film
