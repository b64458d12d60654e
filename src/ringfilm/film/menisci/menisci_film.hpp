#pragma once
#include <vector>

#include "ringfilm/film/film_state.hpp"
#include "ringfilm/film/integrals/film_integrals.hpp"
#include "ringfilm/film/menisci/asperity_curve.hpp"
#include "ringfilm/film/menisci/gap_points.hpp"
#include "ringfilm/film/menisci/meniscus.hpp"

namespace ringfilm::film {

/// Balance of mass and load of a film between two menisci, and what follows for its unknowns.
struct MenisciBalance {
  double lift_rate = 0;                  ///< dh_m/dt [m/s]
  double bead_rate = 0;                  ///< [kg/(m s)]
  MeniscusMotion left, right;            ///< at an edge as of a free meniscus
  double flow_left = 0, flow_right = 0;  ///< mass flux in +x at the menisci [kg/(m s)]
  /// Pressure of the gas over that of the film at a throat that it blows through; below 0 the film holds it [Pa]
  double excess = 0;
  double film_mass = 0;  ///< oil between the menisci [kg/m]
  /// Place up to which the film bears pressure, of the end that leaves: its meniscus, or before it where the pressure
  /// would fall below that of the gas (eq-menisci-outlet) [m]
  double outlet = 0;
  double peak_pressure = 0;  ///< highest at a point [Pa]
  /// Of a dry throat: film that arrives, and the largest that passes without a full film [m].
  double arriving = 0, passing = 0;
  double growth = 0;  ///< speed at which a film becomes longer that forms there of a surplus [m/s]
};

/// How exactly a balance is found.
enum class Iteration {
  kUntilSolved,
  kOnce  ///< one of Newton's iterations, from a solved film nearby: its change is exact to first order
};

/// A film across a face between two menisci, its pressure by quadrature (docs/theory/menisci.md). Holds memory of the
/// last balance.
class MenisciFilm {
 public:
  /// Refers to both, of one gap without jumps and with one lowest place. @param grid for the pressure of the film
  /// @param contact for the asperities, whose load needs shorter cells
  MenisciFilm(const FilmGrid& grid, const FilmProblem& contact);

  double width() const { return grid_->width; }  ///< [m]
  const LowestPlace& throat() const { return throat_; }
  const AsperityCurve& asperities() const { return asperities_; }

  /// Solves the balance, eq-menisci-balance. Throws ConvergenceError where it has none. @param rate lift_rate of a film
  /// nearby, from which the iteration starts [m/s]
  MenisciBalance balance(const MenisciInputs& inputs, const MenisciState& state, const OnLiner& on_liner, double rate,
                         Iteration iteration = Iteration::kUntilSolved);

  /// Motion of the menisci and the bead of a balance at hand, for other films on the liner. The flow at a throat
  /// remains.
  void set_motion(const MenisciInputs& inputs, const MenisciState& state, const OnLiner& on_liner,
                  MenisciBalance& balance) const;

  /// A short film at the throat of a dry ring, which holds back the gas of the higher pressure there.
  MenisciState film_at_throat(const MenisciInputs& inputs, const MenisciState& dry) const;

  /// Integrals of the film for which `balance` was called last. Flows beyond the menisci are those of the films on the
  /// liner that the caller states.
  FilmIntegrals integrals(const MenisciInputs& inputs, const MenisciState& state, const MenisciBalance& balance) const;

 private:
  /// The end of the film that leaves, at which it has the pressure of the gas there.
  struct Outlet {
    std::size_t beyond;  ///< first point beyond it
    double value = 0;    ///< smallest flow at the leading meniscus, or largest reduced pressure there
    double cube = 0, squeezed = 0, mass = 0;  ///< integrals up to the outlet
    double x = 0;
    bool is_at_throat = false;
  };
  void lay_points(const MenisciInputs& inputs, const MenisciState& state);
  void integrate_flow();
  template <class Value, class Rise, class Sense>
  Outlet outlet(const Value& value, const Rise& rise, const Sense& sense) const;
  Outlet end_at(std::size_t point, double value) const;
  MenisciBalance dry_balance(const MenisciInputs& inputs, const MenisciState& state, const OnLiner& on_liner);
  double growth(const MenisciInputs& inputs, const MenisciState& dry, const OnLiner& on_liner);
  double squeeze_resistance(const MenisciInputs& inputs, double h_m) const;
  PassingFilm passing_throat(const MenisciInputs& inputs, const MenisciInputs::Edge& gas, double h_m) const;

  const FilmGrid* grid_;
  const FilmProblem* contact_;
  LowestPlace throat_;
  AsperityCurve asperities_;
  GapPoints points_;
  /// At the points, from the leading meniscus on: 1/h^2 and 1/h^3; reduced pressure, pressure, dp/dPhi and density of
  /// the last balance, and the density with which flows were found.
  std::vector<double> inverse_square_, inverse_cube_, reduced_, pressure_, slope_, density_, rho_;
  std::size_t n_rho_ = 0;  ///< number of points of `rho_`
  /// Integrals from the leading meniscus in the direction of the liner: int 1/h^3, int rho/h^2, M = int rho, int M/h^3.
  std::vector<double> cubes_, squares_, mass_, squeezed_;
};

}  // namespace ringfilm::film
