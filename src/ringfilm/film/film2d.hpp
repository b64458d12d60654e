#pragma once
#include <vector>

#include "ringfilm/film/film_state.hpp"

/// A film in two dimensions: x across the face, in the direction of motion, y around the ring or across a pad. A strip
/// is what lies along x at one y; its film is that of film/, and strips exchange oil through the gradient of pressure
/// in y (eq-film-2d-reynolds). docs/theory/two-dimensional-film.md.
///
/// Nodal numbers are stored strip by strip: node i across of strip j at [j * n_across + i]. A FilmState of a
/// two-dimensional film holds them in that order.
namespace ringfilm::film {

/// What the two-dimensional film ends at in y.
enum class Ends {
  kOpen,    ///< at two given pressures, which the first and the last strip have
  kJoined,  ///< at each other: the last strip is followed by the first
  kClosed,  ///< at walls, or at planes of symmetry: nothing flows through
};

/// Strips at nodes in y. Open and closed: n cells between n+1 strips; joined: n cells, the last of which leads from the
/// last of n strips to the first.
struct CircumferentialGrid {
  Ends ends = Ends::kOpen;
  double length = 0;            ///< [m]
  std::vector<double> y;        ///< positions of the strips, from 0 [m]
  std::vector<double> spacing;  ///< lengths of the cells [m]
  std::vector<double> share;    ///< half of each neighbouring cell, for each strip [m]

  int n_strips() const { return static_cast<int>(y.size()); }
  int n_cells() const { return static_cast<int>(spacing.size()); }
  /// The strip next to the middle of the length.
  int halfway() const;
};

/// @param y of the strips: from 0 to the length, but for a joined two-dimensional film, whose strips end before it [m]
CircumferentialGrid around_at(std::vector<double> y, double length, Ends ends);

CircumferentialGrid uniform_around(int n_cells, double length, Ends ends);

/// Open at both ends, where the cells are `end_cell` long; they grow inwards by the same factor, at the most
/// `kSteepestGrowth`, up to those of the middle, which are all alike. Where there are too few for that growth all are
/// longer by one factor, the end cells too. A larger end cell than length / n_cells is cut to that: then all are alike.
CircumferentialGrid refined_around(int n_cells, double length, double end_cell);
inline constexpr double kSteepestGrowth = 1.3;

/// Heights above the lowest point of the whole gap [m], where the balance of mass needs them. Faces are stored like
/// nodes: those in x at [j * n_cells_across + i] lie midway between nodes i and i+1 of strip j, those in y at
/// [j * n_across + i] between strips j and j+1 (the last with the first where joined).
struct Film2dGap {
  std::vector<double> node;    ///< mean over what belongs to the node
  std::vector<double> face_x;  ///< mean over the share of the strip in y
  std::vector<double> face_y;  ///< mean over the share of the node in x
  /// Where the gap jumps within a face: second and third moments about the mean; all four empty if it never does
  std::vector<double> face_x_second, face_x_third, face_y_second, face_y_third;  ///< [m2], [m3]
};

/// Gap of a two-dimensional film that has in each strip the gap of the grid across.
Film2dGap gap_of_strips(const FilmGrid& across, const CircumferentialGrid& around);

/// The numbers of strip j among those of all, `width` of each strip.
std::vector<double> row_of_strip(const std::vector<double>& all, int j, int width);

/// The flow factors of strip j among those of all; lists without influence stay empty.
FlowFactors factors_of_strip(const FlowFactors& all, int j, int n_strips);

/// A ring that bends (eq-film-2d-ring): a beam with two unknowns at each of its nodes, its separation from the liner
/// and the change of that over the length of a cell [m]. Strip j is at node `first_node` + j.
struct ElasticRing {
  static constexpr int kWidth = 4;  ///< an unknown is coupled to itself and the three after it

  int first_node = 0;  ///< 1 where free ends lie beyond the first and the last strip
  /// Upper band of the symmetric stiffness, kWidth entries for each unknown; empty: the ring is rigid [N/m].
  std::vector<double> band;
  /// By how much a strip and the liner flatten by a load per length, eq-ring-flattening; 0: they do not, and the film
  /// has no closed_film() [m2/N].
  double flattening = 0;

  bool bends() const { return !band.empty(); }
  int n_unknowns() const { return static_cast<int>(band.size()) / kWidth; }
  int of_strip(int j) const { return 2 * (first_node + j); }
};

/// What does not change over a cycle.
struct Film2dProblem {
  FilmProblem strip;  ///< grid across, contact, cavitation, tolerance; heights of its grid: of contact alone
  CircumferentialGrid around;
  Film2dGap gap;
  ElasticRing ring;

  int n_across() const { return strip.grid.n_cells() + 1; }
  std::size_t n_nodes() const { return static_cast<std::size_t>(n_across()) * around.n_strips(); }
};

/// What acts on the film during one step. `strip.load` is the mean per length in y; `strip.source` has a value for each
/// node of the two-dimensional film.
struct Film2dInputs {
  FilmInputs strip;
  double p_low = 0, p_high = 0;  ///< at y = 0 and at y = length, where open; not below p_c [Pa]
  /// How much the separation at each strip exceeds `h_m`, whatever the ring carries. Empty: by nothing [m].
  std::vector<double> rise;
  /// Load of each strip, with the mean `strip.load`. Empty: that of all [N/m].
  std::vector<double> strip_loads;
  /// By which the shape of the bore keeps a ring that bends from the liner, at each of its unknowns; empty: a bore that
  /// is round [N].
  std::vector<double> bore_force;

  double load_of(int strip_number) const { return strip_loads.empty() ? strip.load : strip_loads[strip_number]; }
};

/// How much the separation at each strip exceeds `h_m`, that of a ring that bends included; empty: by nothing [m].
/// @param ring as of FilmState; empty: it is rigid [m]
std::vector<double> rise_of_strips(const Film2dProblem& problem, const Film2dInputs& inputs,
                                   const std::vector<double>& ring);

/// The separations of a ring that bends, h_m and more, strip by strip; of a rigid one h_m alone [m].
std::vector<double> separations(const Film2dProblem& problem, const FilmState& state);

/// L D L^T of a band as ElasticRing has it, in its place. @returns false where it is not positive definite
bool factor_band(std::vector<double>& band);
/// Solves for a right-hand side in its place.
void solve_band(const std::vector<double>& factored, double* x);

/// The thinnest film of a ring that flattens, which is what the valleys of rough surfaces hold that are pressed
/// together; 0 where the ring does not, or nothing but the film carries it [m].
double closed_film(const Film2dProblem& problem);

/// Separation of surfaces whose film is h thick (eq-ring-closed-film) [m]: the same for films of twice `closed` and
/// more, and all where that is 0; without limit below zero as the film falls to `closed`. @param slope of it in h [-]
double closed_separation(double h, double closed, double* slope = nullptr);

/// Displacements of a ring that bends over h_m, of which a state has those of its film [m].
/// @param ring as of FilmState
std::vector<double> displacements(const Film2dProblem& problem, double h_m, std::vector<double> ring);

/// What pushes a ring that bends from the liner at each of its unknowns, film and asperities apart: bore and bending,
/// eq-film-2d-ring [N]. @param displacement of the unknowns, from any separation [m]
std::vector<double> bending_force(const ElasticRing& of, const Film2dInputs& inputs,
                                  const std::vector<double>& displacement);

}  // namespace ringfilm::film
