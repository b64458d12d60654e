#pragma once
#include <numbers>

#include "ringfilm/film/kernels/lane_block.hpp"

/// Oil and sums of one solved film, along the face in the lanes of a register. Plain pointers, so that what is compiled
/// for one machine holds no code that another one shares.
namespace ringfilm::film {

/// A film as arrays over n+1 nodes and n cells; FilmGrid and FilmState define them.
struct FilmView {
  int n_cells;
  const double *node_height, *face_height, *share, *spacing;
  const double *p, *deficit, *mass_per_area;
  const double* shear_deficit;  ///< 1 where gas fills the gap next to a thin film, which bears no shear; else `deficit`
  double h_m;                   ///< [m]
  double deficit_share;         ///< 1: theta = 1 - deficit; 0: theta = 1
  int left_gas_end = 0, right_gas_begin = 1 << 30;  ///< nodes before and from there on are next to gas of an edge
  double left_supply = kUnlimited, right_supply = kUnlimited;  ///< four times that of the edges [kg/m2]
  bool is_steady = false;                                      ///< no storage: the inlet is limited as a whole
  int first_held = 0, last_held = -1;                          ///< faces of a Throat, the rest as there
  double throat_pressure = 0, throat_reach = 0, throat_place = 0;
  double outlet = 1;  ///< GasReach::outlet [-]
  /// FlowFactors; nullptr: none.
  const double *mobility = nullptr, *carried = nullptr, *thinning = nullptr, *sliding_stress = nullptr,
               *inverse_gap = nullptr;
};

/// Factor of the shear rate by a slope of the pressure, as its root mean square across the film, eq-shear-rate.
inline constexpr double kPressureShear = 0.5 * std::numbers::inv_sqrt3;

/// One lane of a block: z, and how far apart its numbers are.
struct LaneView {
  const double* z;
  int stride;
  double p_cavitation, inverse_content_scale;
};

/// Where pressure and deficit of a film go.
struct FilmPressure {
  double *p, *deficit;
};

/// What a film is expected to hold, from up to three films before it (film/time_scheme.hpp).
struct ExpectedMass {
  double of_state, of_before, of_older;  ///< weights [-]
  const double *state, *before, *older;  ///< mass per area [kg/m2]
};

/// Sums over the nodes of one film [kg/m2].
struct MassSums {
  double off;  ///< by which it is not what was expected, in modulus
  double all;
};

/// The last two films, by which the next one is guessed (eq-continued-film).
struct FilmMotion {
  const double *p, *p_before, *deficit, *deficit_before;
  double ratio;  ///< length of the step over that of the step before it [-]
  double p_cavitation;
};

/// The step that led to a film.
struct StepView {
  double U;                            ///< [m/s]
  double rate;                         ///< 1/dt [1/s]
  const double* mass_per_area_before;  ///< [kg/m2]
};

/// Fits of an oil's laws (models/oil/oil_fit.hpp).
struct FittedOilView {
  const double *K, *rho;
  double centre, inverse_half_width;
};

/// Oil at n+1 nodes.
struct NodalOilView {
  const double *rho, *K;
};

/// Faces through which the flux is required, in rising order, and where it goes [kg/(m s)].
struct FluxRequest {
  const int* face;
  double* flux;
  int count;
};

/// Sums of FilmHeating over the cells that oil fills from end to end, with what its mean flux is made of.
struct HeatingSums {
  double dissipation, conductance;  ///< [W/m], [-]
  double flow;                      ///< int of the mass flux, in the frame of the face [kg/s]
  double length;                    ///< [m]
};

/// Sums over the face of one film.
struct FilmSums {
  double hydrodynamic_load;                ///< [N/m]
  double shear_couette, shear_poiseuille;  ///< [N/m]
  double storage;                          ///< growth of the mass on the face [kg/(m s)]
  double peak_pressure;                    ///< [Pa]
  double peak_shear_squared;  ///< largest squared shear rate at inner nodes that oil fills or passes [1/s2]
  HeatingSums heating;
};

/// Fits of the contact laws (models/asperity_contact.hpp), lowest power first: eighth roots of F_5/2 and F_2.
struct FittedContactView {
  const double *F_52, *F_2;
  double reach, per_gap, pressure_scale, area_scale;
  double spread;       ///< 1: at the local gap; 0: at h_m on the whole face
  double turning_gap;  ///< the load beyond it is also summed separately [m]
};

/// Cubics that are the contact law (models::ContactPieces): four coefficients of each piece of both eighth roots.
struct TabulatedContactView {
  const double *pressure, *area;
  double reach, per_gap, pressure_scale, area_scale;
  double end;          ///< largest place in the last piece, counted in pieces
  double spread;       ///< 1: contact at the local gap; 0: at h_m on the whole face
  double turning_gap;  ///< gap beyond which the load is also summed separately [m]
};

struct ContactSums {
  double load, load_beyond;  ///< [N/m]
  double area;               ///< [m]
};

/// Mass flux in +x through the face between nodes i and i+1. @param rho,K of these two nodes
RINGFILM_INLINE double flux_through(const FilmView& film, double U, const double* rho, const double* K, int i) {
  const double h = film.h_m + film.face_height[i];
  const double stream = film.carried == nullptr ? h : h + film.carried[i];
  const double dp = film.p[i + 1] - film.p[i];
  const auto mobile = [&](int k) { return film.mobility == nullptr ? K[k] : K[k] * film.mobility[i + k]; };
  const double supply = i == 0 ? film.left_supply : i == film.n_cells - 1 ? film.right_supply : kUnlimited;
  const bool is_limited = supply < kUnlimited;
  const auto film_content = [&](bool from_left) {
    if (is_limited && from_left == (i == 0)) return 1.0;  // the edge, see limit_inlet
    const int node = from_left ? i : i + 1;
    const bool on_wall = node < film.left_gas_end || node >= film.right_gas_begin;
    const bool is_behind = U >= 0 ? node >= film.right_gas_begin : node < film.left_gas_end;
    const double filled = 1 - film.deficit_share * film.deficit[node];
    return min(carried_share(filled, on_wall ? kOnWall : kBetweenWalls),
               hanging_share(filled, is_behind ? film.outlet : 1.0));
  };
  const double content = film_content(U >= 0);
  const double upstream = film.h_m + film.node_height[U >= 0 ? i : i + 1] + (stream - h);
  double carried = entrainment(0.25 * U, content, carried_gap(content, upstream, stream).gap);
  const double inward = i == 0 ? 1 : -1, arriving = inward * U > 0 ? 0.25 * inward * U : 0;
  if (is_limited && !film.is_steady && arriving > 0) {
    const double limit = supply / (rho[0] + rho[1]);
    carried = 0.25 * U * (limit < stream ? limit : stream);
  }
  double flux = face_flux(carried, rho[0] + rho[1], film_content(dp <= 0) * conductance(h * h * h, film.spacing[i]),
                          mobile(0) + mobile(1), dp);
  const int before = U >= 0 ? i : i + 1, behind = U >= 0 ? i + 1 : i;
  const double held = film.throat_pressure - film.p[before];
  if (film.deficit_share > 0 && i >= film.first_held && i <= film.last_held && held > 0) {
    using One = base::Pack<1, base::InstructionSet::kBaseline>;
    const double density = rho[0] + rho[1], rate = 0.25 * U * density;
    const double rise = film.throat_place * (rate < 0 ? -rate : rate) /
                        (conductance(h * h * h, film.spacing[i]) * (mobile(0) + mobile(1)));
    const double held_back =
        rate *
        passed_gap<One>(content * carried_gap(content, upstream, stream).gap, held, rise, film.throat_reach).gap.v;
    const bool is_edge = behind == 0 || behind == film.n_cells;
    const bool on_wall = behind < film.left_gas_end || behind >= film.right_gas_begin;
    const double pressing =
        pressing_share<One>(is_edge ? 0 : 1 - film.deficit[behind], on_wall ? kPressingOnWall : kPressingBetweenWalls)
            .v;
    flux = (1 - pressing) * held_back + pressing * flux;
  }
  if (!is_limited || !(film.is_steady || inward * dp < 0)) return flux;
  const double limit = arriving * supply;
  return inward * flux > limit ? inward * limit : flux;
}

/// Heat of cell i, over the `length` of it that oil fills. @param rho,K of node i and the one after it
template <class Some>
RINGFILM_INLINE CellHeating<Some> heating_of_cell(const FilmView& film, double U, const double* rho, const double* K,
                                                  int i, Some length, Some slope) {
  const Some h = Some(film.h_m) + Some::load(film.face_height + i);
  const Some rho_left = Some::load(rho), rho_right = Some::load(rho + 1);
  const Some left = rho_left / Some::load(K), right = rho_right / Some::load(K + 1);  // viscosities
  const auto mean = [](Some a, Some b) RINGFILM_INLINE_BODY { return Some(0.5) * (a + b); };
  CellOil<Some> oil{mean(rho_left, rho_right), mean(left, right), mean(left, right)};
  if (film.thinning != nullptr) {
    oil.eta = mean(left * Some::load(film.thinning + i), right * Some::load(film.thinning + i + 1));
  }
  if (film.mobility != nullptr) {
    oil.eta_of_flow = mean(left / Some::load(film.mobility + i), right / Some::load(film.mobility + i + 1));
  }
  const Some stream = film.carried == nullptr ? h : h + Some::load(film.carried + i);
  const Some sliding = film.sliding_stress == nullptr ? Some(1) : Some::load(film.sliding_stress + i);
  const Some inverse_gap = film.inverse_gap == nullptr ? sliding : Some::load(film.inverse_gap + i);
  return cell_heating(Some(U), length, slope, h, stream, sliding, inverse_gap, oil);
}

/// Sums along the face with packs of Real, and what is left over one by one.
template <class Real, class One>
class AlongFace {
 public:
  /// What each node holds, its oil from the fits.
  RINGFILM_INLINE static void mass_per_area(const FilmView& film, const FittedOilView& oil, double* to) {
    visit_each<kAbreast>(0, film.n_cells + 1, [&]<class Some, int kPacks>(int begin) RINGFILM_INLINE_BODY {
      Some t[kPacks], rho[kPacks];
      for (int a = 0; a < kPacks; ++a) t[a] = fit_place<Some>(film, oil, begin + a * Some::kWidth);
      base::sum_of_powers<kDensityTerms, kPacks>(oil.rho, t, rho);
      for (int a = 0; a < kPacks; ++a) {
        const int i = begin + a * Some::kWidth;
        (rho[a] * theta<Some>(film, i) * (Some(film.h_m) + Some::load(film.node_height + i))).store(to + i);
      }
    });
  }

  /// Pressure and deficit of n+1 nodes from a lane.
  RINGFILM_INLINE static void read(const LaneView& lane, int n_nodes, const FilmPressure& to) {
    visit_each<1>(0, n_nodes, [&]<class Some, int>(int i) RINGFILM_INLINE_BODY { read_at<Some>(lane, to, i); });
  }

  /// The first node from `i` on and before `end` that is a cavity, or with `cavity` false that is not; else `end`.
  RINGFILM_INLINE static int next_node(const double* deficit, int i, int end, bool cavity) {
    const double sign = cavity ? 1 : -1;
    while (i + Real::kWidth <= end &&
           !Real::any(Real(sign) * (Real::load(deficit + i) - Real(kCavityThreshold)) > Real(0))) {
      i += Real::kWidth;
    }
    while (i < end && (deficit[i] > kCavityThreshold) != cavity) ++i;
    return i;
  }

  /// What a step of second order remembers. @returns the least of it
  RINGFILM_INLINE static double remembered_mass(const ExpectedMass& mass, int n_nodes, double* to) {
    Least<Real> packs;
    Least<One> rest;
    visit_each<1>(0, n_nodes, [&]<class Some, int>(int i) RINGFILM_INLINE_BODY {
      const Some remembered =
          Some(mass.of_state) * Some::load(mass.state + i) + Some(mass.of_before) * Some::load(mass.before + i);
      remembered.store(to + i);
      Some& least = sums_of<Some>(packs, rest).least;
      least = min(least, remembered);
    });
    return -largest(-packs.least, -rest.least);
  }

  RINGFILM_INLINE static MassSums mass_off(const double* mass, const ExpectedMass& expected, int n_nodes) {
    Off<Real> packs;
    Off<One> rest;
    visit_nodes<1>(0, n_nodes, [&]<class Some, int>(int i) RINGFILM_INLINE_BODY {
      const Some is = Some::load(mass + i);
      const Some want = Some(expected.of_state) * Some::load(expected.state + i) +
                        Some(expected.of_before) * Some::load(expected.before + i) +
                        Some(expected.of_older) * Some::load(expected.older + i);
      Off<Some>& to = sums_of<Some>(packs, rest);
      to.off += abs(is - want);
      to.all += is;
    });
    return {packs.off.sum() + rest.off.v, packs.all.sum() + rest.all.v};
  }

  /// Pressure and deficit change further as they did over the last step; a node that would leave its film or its cavity
  /// crosses over.
  RINGFILM_INLINE static void continued(const FilmMotion& film, int n_nodes, const FilmPressure& to) {
    constexpr double kMaxOfPressureLost = 0.5;  // in a film that gets thicker
    constexpr double kNewDeficit = 1e-6;
    visit_each<1>(0, n_nodes, [&]<class Some, int>(int i) RINGFILM_INLINE_BODY {
      const Some p = Some::load(film.p + i), d = Some::load(film.deficit + i),
                 d_before = Some::load(film.deficit_before + i);
      const Some p_next = p + Some(film.ratio) * (p - Some::load(film.p_before + i));
      const Some d_next = d + Some(film.ratio) * (d - d_before);
      const auto was_cavity = d_before > Some(0), is_cavity = d > Some(0);
      const auto stays_cavity = Some::both(was_cavity, is_cavity);
      const auto is_new = Some::only(Some::only(p_next < Some(film.p_cavitation), is_cavity), was_cavity);
      const auto moves = Some::only(Some::only(p_next > Some(kMaxOfPressureLost) * p, is_cavity), was_cavity);
      const Some in_film = select(moves, p_next, p);
      select(is_new, Some(film.p_cavitation), in_film).store(to.p + i);
      const Some in_cavity = select(Some::both(stays_cavity, d_next < Some(1)), max(Some(0), d_next), d);
      select(is_new, Some(kNewDeficit), in_cavity).store(to.deficit + i);
    });
  }

  /// With oil that is given.
  RINGFILM_INLINE static FilmSums sums(const FilmView& film, const NodalOilView& oil, const StepView& step,
                                       const FluxRequest& fluxes) {
    Sums<Real> packs(film, step);
    Sums<One> rest(film, step);
    visit_nodes<1>(0, film.n_cells, [&]<class Some, int>(int i) RINGFILM_INLINE_BODY {
      sums_of<Some>(packs, rest).add(film, step, oil.rho + i, oil.K + i, i);
    });
    visit_each<1>(1, film.n_cells, [&]<class Some, int>(int i) RINGFILM_INLINE_BODY {
      sums_of<Some>(packs, rest).add_shear_rate(film, step, oil.rho + i, oil.K + i, i);
    });
    for (int k = 0; k < fluxes.count; ++k) {
      const int i = fluxes.face[k];
      fluxes.flux[k] = flux_through(film, step.U, oil.rho + i, oil.K + i, i);
    }
    rest.add_node(film, step, film.n_cells);
    return total(packs, rest, step);
  }

  /// With oil from the fits.
  RINGFILM_INLINE static FilmSums sums(const FilmView& film, const FittedOilView& oil, const StepView& step,
                                       const FluxRequest& fluxes) {
    Sums<Real> packs(film, step);
    Sums<One> rest(film, step);
    int flux = 0;
    visit_stretches(film, oil, [&](int begin, int end, const double* rho, const double* K) RINGFILM_INLINE_BODY {
      visit_nodes<1>(begin, end, [&]<class Some, int>(int i) RINGFILM_INLINE_BODY {
        sums_of<Some>(packs, rest).add(film, step, rho + (i - begin), K + (i - begin), i);
      });
      visit_each<1>(begin < 1 ? 1 : begin, end, [&]<class Some, int>(int i) RINGFILM_INLINE_BODY {
        sums_of<Some>(packs, rest).add_shear_rate(film, step, rho + (i - begin), K + (i - begin), i);
      });
      for (; flux < fluxes.count && fluxes.face[flux] < end; ++flux) {
        const int i = fluxes.face[flux];
        fluxes.flux[flux] = flux_through(film, step.U, rho + (i - begin), K + (i - begin), i);
      }
    });
    rest.add_node(film, step, film.n_cells);
    return total(packs, rest, step);
  }

  /// With oil that is given.
  RINGFILM_INLINE static HeatingSums heating(const FilmView& film, const NodalOilView& oil, double U) {
    Heating<Real> packs;
    Heating<One> rest;
    visit_nodes<1>(0, film.n_cells, [&]<class Some, int>(int i) RINGFILM_INLINE_BODY {
      sums_of<Some>(packs, rest).add(film, U, oil.rho + i, oil.K + i, i);
    });
    return total(packs, rest);
  }

  /// With oil from the fits.
  RINGFILM_INLINE static HeatingSums heating(const FilmView& film, const FittedOilView& oil, double U) {
    Heating<Real> packs;
    Heating<One> rest;
    visit_stretches(film, oil, [&](int begin, int end, const double* rho, const double* K) RINGFILM_INLINE_BODY {
      visit_nodes<1>(begin, end, [&]<class Some, int>(int i) RINGFILM_INLINE_BODY {
        sums_of<Some>(packs, rest).add(film, U, rho + (i - begin), K + (i - begin), i);
      });
    });
    return total(packs, rest);
  }

  template <class View>
  RINGFILM_INLINE static ContactSums contact(const FilmView& film, const View& contact) {
    Contact<Real> packs;
    Contact<One> rest;
    const int n_nodes = film.n_cells + 1;
    int i = 0;
    for (; i + Real::kWidth <= n_nodes; i += Real::kWidth) packs.add(film, contact, i, Real::last(Real::kWidth));
    if (n_nodes >= Real::kWidth && i < n_nodes) {
      packs.add(film, contact, n_nodes - Real::kWidth, Real::last(n_nodes - i));
    } else {
      for (; i < n_nodes; ++i) rest.add(film, contact, i, true);
    }
    return {contact.pressure_scale * (packs.load.sum() + rest.load.v),
            contact.pressure_scale * (packs.beyond.sum() + rest.beyond.v),
            contact.area_scale * (packs.area.sum() + rest.area.v)};
  }

 private:
  static constexpr int kAbreast = 4;    ///< packs whose polynomials are summed side by side
  static constexpr int kStretch = 257;  ///< nodes whose oil is at hand at a time

  /// Calls visit<Pack, packs>(first node) for all nodes from `begin` to before `end`: with kPacks packs of Real as
  /// often as they fit, then with one, then node by node.
  template <int kPacks, class Visit>
  RINGFILM_INLINE static void visit_nodes(int begin, int end, const Visit& visit) {
    int i = begin;
    if constexpr (kPacks > 1) {
      for (; i + kPacks * Real::kWidth <= end; i += kPacks * Real::kWidth) visit.template operator()<Real, kPacks>(i);
    }
    for (; i + Real::kWidth <= end; i += Real::kWidth) visit.template operator()<Real, 1>(i);
    for (; i < end; ++i) visit.template operator()<One, 1>(i);
  }

  /// Visits each node where a node may be visited twice without harm: the last pack ends with the last node.
  template <int kPacks, class Visit>
  RINGFILM_INLINE static void visit_each(int begin, int end, const Visit& visit) {
    int i = begin;
    if constexpr (kPacks > 1) {
      for (; i + kPacks * Real::kWidth <= end; i += kPacks * Real::kWidth) visit.template operator()<Real, kPacks>(i);
    }
    for (; i + Real::kWidth <= end; i += Real::kWidth) visit.template operator()<Real, 1>(i);
    if (i < end && end - begin >= Real::kWidth) return visit.template operator()<Real, 1>(end - Real::kWidth);
    for (; i < end; ++i) visit.template operator()<One, 1>(i);
  }

  /// Calls visit(first cell, end of cells, rho, K) for stretches of the face, with the oil from their first node on.
  template <class Visit>
  RINGFILM_INLINE static void visit_stretches(const FilmView& film, const FittedOilView& oil, const Visit& visit) {
    double rho[kStretch], K[kStretch];
    const int n = film.n_cells;
    for (int begin = 0; begin < n; begin += kStretch - 1) {  // the last node of a stretch is the first of the next
      const int end = begin + kStretch < n + 1 ? begin + kStretch : n + 1;
      visit_each<kAbreast>(begin, end, [&]<class Some, int kPacks>(int i) RINGFILM_INLINE_BODY {
        Some t[kPacks], value[kPacks];
        for (int a = 0; a < kPacks; ++a) t[a] = fit_place<Some>(film, oil, i + a * Some::kWidth);
        base::sum_of_powers<kFluidityTerms, kPacks>(oil.K, t, value);
        for (int a = 0; a < kPacks; ++a) value[a].store(K + (i - begin) + a * Some::kWidth);
        base::sum_of_powers<kDensityTerms, kPacks>(oil.rho, t, value);
        for (int a = 0; a < kPacks; ++a) value[a].store(rho + (i - begin) + a * Some::kWidth);
      });
      visit(begin, end - 1, static_cast<const double*>(rho), static_cast<const double*>(K));
    }
  }

  template <class Some>
  RINGFILM_INLINE static Some fit_place(const FilmView& film, const FittedOilView& oil, int i) {
    return min(Some(1), (Some::load(film.p + i) - Some(oil.centre)) * Some(oil.inverse_half_width));
  }

  template <class Some>
  RINGFILM_INLINE static Some theta(const FilmView& film, int i) {
    return Some(1) - Some(film.deficit_share) * Some::load(film.deficit + i);
  }

  template <class Some>
  RINGFILM_INLINE static Some sheared(const FilmView& film, int i) {
    return Some(1) - Some(film.deficit_share) * Some::load(film.shear_deficit + i);
  }

  template <class Some>
  RINGFILM_INLINE static void read_at(const LaneView& lane, const FilmPressure& to, int i) {
    const Some z = Some::gather(lane.z + i * lane.stride, lane.stride);
    (Some(lane.p_cavitation) + max(Some(0), z)).store(to.p + i);
    max(Some(0), -z * Some(lane.inverse_content_scale)).store(to.deficit + i);
  }

  template <class Some>
  struct Least {
    Some least{0};
  };
  template <class Some>
  struct Off {
    Some off{0}, all{0};
  };

  template <class Some>
  struct Heating {
    Some dissipation{0}, conductance{0}, flow{0}, length{0};

    /// @param rho,K of node i and the one after it
    RINGFILM_INLINE void add(const FilmView& film, double U, const double* rho, const double* K, int i) {
      const auto cavity = max(Some::load(film.deficit + i), Some::load(film.deficit + i + 1)) > Some(kCavityThreshold);
      const Some spacing = Some::load(film.spacing + i), cell = select(cavity, Some(0), spacing);
      const Some slope = (Some::load(film.p + i + 1) - Some::load(film.p + i)) / spacing;
      const CellHeating<Some> heat = heating_of_cell(film, U, rho, K, i, cell, slope);
      dissipation += heat.dissipation;
      conductance += heat.conductance;
      flow += heat.flow;
      length += cell;
    }
  };

  template <class Some>
  struct Sums {
    Some load{0}, couette{0}, poiseuille{0}, storage{0}, peak, shear_squared{0};
    Heating<Some> heating;
    int upstream;  ///< index of the upstream one of the two nodes of a cell, whose oil fills the cell

    RINGFILM_INLINE Sums(const FilmView& film, const StepView& step) : peak(film.p[0]), upstream(step.U >= 0 ? 0 : 1) {}

    RINGFILM_INLINE void add_node(const FilmView& film, const StepView& step, int i) {
      const Some p = Some::load(film.p + i);
      const Some share = Some::load(film.share + i);
      load += share * p;
      storage += share * (Some::load(film.mass_per_area + i) - Some::load(step.mass_per_area_before + i));
      peak = max(peak, p);
    }
    /// Node and cell i. @param rho,K of node i and the one after it
    RINGFILM_INLINE void add(const FilmView& film, const StepView& step, const double* rho, const double* K, int i) {
      add_node(film, step, i);
      add_face(film, rho, K, i);
      heating.add(film, step.U, rho, K, i);
    }
    /// Adds the shear rate at an inner node, eq-shear-rate. @param rho,K of node i
    RINGFILM_INLINE void add_shear_rate(const FilmView& film, const StepView& step, const double* rho, const double* K,
                                        int i) {
      const Some h = Some(film.h_m) + Some::load(film.node_height + i);
      const Some length = Some::load(film.spacing + i - 1) + Some::load(film.spacing + i);
      const Some fall = Some::load(film.p + i + 1) - Some::load(film.p + i - 1);
      const Some inertia = Some::load(rho) * length;  // inertia of the viscosity rho/K
      const Some slide = Some(step.U) * inertia, press = Some(kPressureShear) * h * h * fall * Some::load(K);
      const Some reach = h * inertia;
      const Some squared = (slide * slide + press * press) / (reach * reach);
      shear_squared = max(shear_squared, select(sheared<Some>(film, i) > Some(0), squared, Some(0)));
    }
    /// @param rho,K of node i and the one after it
    RINGFILM_INLINE void add_face(const FilmView& film, const double* rho, const double* K, int i) {
      const Some h = Some(film.h_m) + Some::load(film.face_height + i);
      Some content = sheared<Some>(film, i + upstream);
      const auto in_cavity = content < Some(1);
      if (Some::any(in_cavity)) {
        const Some at_node = Some(film.h_m) + Some::load(film.node_height + i + upstream);
        content = select(in_cavity, content * carried_gap(content, at_node, h).gap / h, content);
      }
      couette += cell_shear(Some::load(film.spacing + i), content, h, Some::load(rho), Some::load(K),
                            Some::load(rho + 1), Some::load(K + 1));
      poiseuille += h * (Some::load(film.p + i + 1) - Some::load(film.p + i));
    }
  };

  template <class Some, template <class> class Of>
  RINGFILM_INLINE static Of<Some>& sums_of(Of<Real>& packs, Of<One>& rest) {
    if constexpr (Some::kWidth == Real::kWidth) {
      return packs;
    } else {
      return rest;
    }
  }

  RINGFILM_INLINE static HeatingSums total(const Heating<Real>& packs, const Heating<One>& rest) {
    return {packs.dissipation.sum() + rest.dissipation.v, packs.conductance.sum() + rest.conductance.v,
            packs.flow.sum() + rest.flow.v, packs.length.sum() + rest.length.v};
  }

  RINGFILM_INLINE static double largest(Real packs, One rest) {
    double most = rest.v, lanes[Real::kWidth];
    packs.store(lanes);
    for (const double lane : lanes) most = most > lane ? most : lane;
    return most;
  }

  RINGFILM_INLINE static FilmSums total(const Sums<Real>& packs, const Sums<One>& rest, const StepView& step) {
    return {packs.load.sum() + rest.load.v,
            0.25 * step.U * (packs.couette.sum() + rest.couette.v),
            0.5 * (packs.poiseuille.sum() + rest.poiseuille.v),
            step.rate * (packs.storage.sum() + rest.storage.v),
            largest(packs.peak, rest.peak),
            largest(packs.shear_squared, rest.shear_squared),
            total(packs.heating, rest.heating)};
  }

  template <class Some>
  struct Contact {
    Some load{0}, beyond{0}, area{0};

    /// @param counted nodes that have not been counted yet
    template <class View>
    RINGFILM_INLINE void add(const FilmView& film, const View& contact, int i, typename Some::Mask counted) {
      const Some gap = Some(film.h_m) + Some(contact.spread) * Some::load(film.node_height + i);
      const typename Some::Mask inside = Some::both(gap < Some(contact.reach), counted);
      if (!Some::any(inside)) return;
      const Roots root = roots(contact, max(Some(0), gap) * Some(contact.per_gap));
      const Some weight = select(inside, Some::load(film.share + i), Some(0));
      const Some p = weight * eighth_power(root.pressure);
      load += p;
      beyond += select(gap > Some(contact.turning_gap), p, Some(0));
      area += weight * eighth_power(root.area);
    }

   private:
    /// Eighth roots of what a node adds to load and area.
    struct Roots {
      Some pressure, area;
    };
    RINGFILM_INLINE static Roots roots(const FittedContactView& contact, Some place) {
      // Far ones count for nothing, but must be numbers.
      const Some t = min(Some(1), place - Some(1));
      Roots root;
      base::sum_of_powers<kContactTerms, 1>(contact.F_52, &t, &root.pressure);
      base::sum_of_powers<kContactTerms, 1>(contact.F_2, &t, &root.area);
      return root;
    }
    RINGFILM_INLINE static Roots roots(const TabulatedContactView& contact, Some place) {
      const OnPieces<Some> on(min(place, Some(contact.end)));
      return {cubic(on, contact.pressure), cubic(on, contact.area)};
    }
    RINGFILM_INLINE static Some cubic(const OnPieces<Some>& on, const double* cubics) {
      Some c[4];
      on.coefficients([cubics](int) RINGFILM_INLINE_BODY { return cubics; }, c);
      return on.value(c);
    }
    RINGFILM_INLINE static Some eighth_power(Some root) {
      const Some square = root * root;
      const Some fourth = square * square;
      return fourth * fourth;
    }
  };
};

}  // namespace ringfilm::film
