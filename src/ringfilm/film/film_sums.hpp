#pragma once
#include "ringfilm/film/lane_block.hpp"

/// Oil and sums of one solved film, along the face in the lanes of a register. Plain pointers, so that what is compiled
/// for one machine holds no code that another one shares.
namespace ringfilm::film {

/// A film as arrays over n+1 nodes and n cells; what they are is told by FilmGrid and FilmState.
struct FilmView {
  int n_cells;
  const double *node_height, *face_height, *share, *spacing;
  const double *p, *deficit;
  const double *rho, *K, *content;
  double h_m;         ///< [m]
  double fill_share;  ///< 1: theta = 1 - deficit; 0: theta = 1
};

/// Where oil and content of a film go.
struct FilmContent {
  double *rho, *K, *content;
};

/// One lane of a block: z, and how far apart its numbers are.
struct LaneView {
  const double* z;
  int stride;
  double p_cavitation, inverse_fill_scale;
};

/// Where pressure and deficit of a film go.
struct FilmPressure {
  double *p, *deficit;
};

/// The step that led to a film.
struct StepView {
  double U;                      ///< [m/s]
  double rate;                   ///< 1/dt [1/s]
  const double* content_before;  ///< [kg/m2]
};

/// Fits of an oil's laws (models/oil_fit.hpp).
struct FittedOilView {
  const double *K, *rho;
  double centre, inverse_half_width;
};

/// Sums over the face of one film.
struct FilmSums {
  double hydrodynamic_load;                ///< [N/m]
  double shear_couette, shear_poiseuille;  ///< [N/m]
  double storage;                          ///< growth of the mass on the face [kg/(m s)]
  double peak_pressure;                    ///< [Pa]
};

/// Fits of the contact laws (models/asperity_contact.hpp), lowest power first: eighth roots of F_5/2 and F_2.
struct FittedContactView {
  const double *F_52, *F_2;
  double reach, per_gap, pressure_scale, area_scale;
  double spread;       ///< 1: at the local gap; 0: at h_m on the whole face
  double turning_gap;  ///< the load beyond it is told apart [m]
};

struct ContactSums {
  double load, load_beyond;  ///< [N/m]
  double area;               ///< [m]
};

/// One polynomial at several packs, side by side so that no sum waits for its last term.
template <int kTerms, int kAbreast, class Real>
RINGFILM_INLINE void sum_of_powers(const double* c, const Real* t, Real* value) {
  for (int a = 0; a < kAbreast; ++a) value[a] = Real(c[kTerms - 1]);
#pragma GCC unroll 32
  for (int k = kTerms - 2; k >= 0; --k) {
    for (int a = 0; a < kAbreast; ++a) value[a] = value[a] * t[a] + Real(c[k]);
  }
}

/// Sums along the face with packs of Real, and what is left over one by one.
template <class Real, class One>
class AlongFace {
 public:
  /// Oil at the nodes from the fits, and what each node holds.
  RINGFILM_INLINE static void complete(const FilmView& film, const FittedOilView& oil, const FilmContent& to) {
    constexpr int kAbreast = 4;
    const int n_nodes = film.n_cells + 1;
    int i = 0;
    for (; i + kAbreast * Real::kWidth <= n_nodes; i += kAbreast * Real::kWidth) {
      complete_at<Real, kAbreast>(film, oil, to, i);
    }
    for (; i + Real::kWidth <= n_nodes; i += Real::kWidth) complete_at<Real, 1>(film, oil, to, i);
    for (; i < n_nodes; ++i) complete_at<One, 1>(film, oil, to, i);
  }

  /// Pressure and deficit of n+1 nodes from a lane.
  RINGFILM_INLINE static void read(const LaneView& lane, int n_nodes, const FilmPressure& to) {
    int i = 0;
    for (; i + Real::kWidth <= n_nodes; i += Real::kWidth) read_at<Real>(lane, to, i);
    for (; i < n_nodes; ++i) read_at<One>(lane, to, i);
  }

  RINGFILM_INLINE static FilmSums sums(const FilmView& film, const StepView& step) {
    Sums<Real> packs(film);
    Sums<One> rest(film);
    int i = 0;
    for (; i + Real::kWidth <= film.n_cells; i += Real::kWidth) {
      packs.add_node(film, step, i);
      packs.add_face(film, i);
    }
    for (; i < film.n_cells; ++i) {
      rest.add_node(film, step, i);
      rest.add_face(film, i);
    }
    rest.add_node(film, step, film.n_cells);
    double peak = rest.peak.v;
    double lanes[Real::kWidth];
    packs.peak.store(lanes);
    for (const double lane : lanes) peak = peak > lane ? peak : lane;
    return {packs.load.sum() + rest.load.v, 0.25 * step.U * (packs.couette.sum() + rest.couette.v),
            0.5 * (packs.poiseuille.sum() + rest.poiseuille.v), step.rate * (packs.storage.sum() + rest.storage.v),
            peak};
  }

  RINGFILM_INLINE static ContactSums contact(const FilmView& film, const FittedContactView& contact) {
    Contact<Real> packs;
    Contact<One> rest;
    int i = 0;
    for (; i + Real::kWidth <= film.n_cells + 1; i += Real::kWidth) packs.add(film, contact, i);
    for (; i <= film.n_cells; ++i) rest.add(film, contact, i);
    return {contact.pressure_scale * (packs.load.sum() + rest.load.v),
            contact.pressure_scale * (packs.beyond.sum() + rest.beyond.v),
            contact.area_scale * (packs.area.sum() + rest.area.v)};
  }

 private:
  template <class Some>
  RINGFILM_INLINE static Some theta(const FilmView& film, int i) {
    return Some(1) - Some(film.fill_share) * Some::load(film.deficit + i);
  }

  template <class Some>
  RINGFILM_INLINE static void read_at(const LaneView& lane, const FilmPressure& to, int i) {
    const Some z = Some::gather(lane.z + i * lane.stride, lane.stride);
    (Some(lane.p_cavitation) + max(Some(0), z)).store(to.p + i);
    max(Some(0), -z * Some(lane.inverse_fill_scale)).store(to.deficit + i);
  }

  template <class Some, int kAbreast>
  RINGFILM_INLINE static void complete_at(const FilmView& film, const FittedOilView& oil, const FilmContent& to,
                                          int begin) {
    Some t[kAbreast], K[kAbreast], rho[kAbreast];
    for (int a = 0; a < kAbreast; ++a) {
      const Some p = Some::load(film.p + begin + a * Some::kWidth);
      t[a] = min(Some(1), (p - Some(oil.centre)) * Some(oil.inverse_half_width));
    }
    sum_of_powers<kFluidityTerms, kAbreast>(oil.K, t, K);
    sum_of_powers<kDensityTerms, kAbreast>(oil.rho, t, rho);
    for (int a = 0; a < kAbreast; ++a) {
      const int i = begin + a * Some::kWidth;
      K[a].store(to.K + i);
      rho[a].store(to.rho + i);
      (rho[a] * theta<Some>(film, i) * (Some(film.h_m) + Some::load(film.node_height + i))).store(to.content + i);
    }
  }

  template <class Some>
  struct Sums {
    Some load{0}, couette{0}, poiseuille{0}, storage{0}, peak;

    RINGFILM_INLINE explicit Sums(const FilmView& film) : peak(film.p[0]) {}

    RINGFILM_INLINE void add_node(const FilmView& film, const StepView& step, int i) {
      const Some p = Some::load(film.p + i);
      const Some share = Some::load(film.share + i);
      load += share * p;
      storage += share * (Some::load(film.content + i) - Some::load(step.content_before + i));
      peak = max(peak, p);
    }
    RINGFILM_INLINE void add_face(const FilmView& film, int i) {
      const Some h = Some(film.h_m) + Some::load(film.face_height + i);
      const Some K_left = Some::load(film.K + i);
      const Some K_right = Some::load(film.K + i + 1);
      // Twice the mean viscosity, times K of both: one division serves viscosity and gap.
      const Some eta = Some::load(film.rho + i) * K_right + Some::load(film.rho + i + 1) * K_left;
      const Some fill = theta<Some>(film, i) + theta<Some>(film, i + 1);
      couette += Some::load(film.spacing + i) * fill * eta / (h * K_left * K_right);
      poiseuille += h * (Some::load(film.p + i + 1) - Some::load(film.p + i));
    }
  };

  template <class Some>
  struct Contact {
    Some load{0}, beyond{0}, area{0};

    RINGFILM_INLINE void add(const FilmView& film, const FittedContactView& contact, int i) {
      const Some gap = Some(film.h_m) + Some(contact.spread) * Some::load(film.node_height + i);
      const typename Some::Mask inside = gap < Some(contact.reach);
      if (!Some::any(inside)) return;
      // Far ones count for nothing, but must be numbers.
      const Some t = min(Some(1), max(Some(0), gap) * Some(contact.per_gap) - Some(1));
      Some root_52(contact.F_52[kContactTerms - 1]);
      Some root_2(contact.F_2[kContactTerms - 1]);
#pragma GCC unroll 32
      for (int k = kContactTerms - 2; k >= 0; --k) {
        root_52 = root_52 * t + Some(contact.F_52[k]);
        root_2 = root_2 * t + Some(contact.F_2[k]);
      }
      const Some weight = select(inside, Some::load(film.share + i), Some(0));
      const Some p = weight * eighth_power(root_52);
      load += p;
      beyond += select(gap > Some(contact.turning_gap), p, Some(0));
      area += weight * eighth_power(root_2);
    }
    RINGFILM_INLINE static Some eighth_power(Some root) {
      const Some square = root * root;
      const Some fourth = square * square;
      return fourth * fourth;
    }
  };
};

}  // namespace ringfilm::film
