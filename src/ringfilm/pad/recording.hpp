#pragma once
#include <optional>
#include <vector>

#include "ringfilm/film/integrals/film_integrals.hpp"
#include "ringfilm/pad/pad_result.hpp"
#include "ringfilm/pad/pad_setup.hpp"

/// What is reported of a film, alike in one dimension and two.
namespace ringfilm::pad {

/// Edge pressures joined by a line, at the nodes along x [Pa].
std::vector<double> pressures_between_edges(const PadSetup& setup, const film::FilmGrid& grid);

/// What rounding makes of a film in which nothing flows: of its pressures, and of the oil that it holds from step to
/// step. A balance is not measured by smaller flows. @param thickest film [m] @returns mass flux [kg/(m s)]
double flux_of_rounding(const film::FilmProblem& problem, const film::FilmInputs& inputs, const film::FilmState& state,
                        double thickest);

struct Peak {
  double pressure, position;  ///< [Pa], [m]
};

/// Top of the parabola through the highest node and its neighbours; the node where they do not bend down.
Peak top_of_parabola(Peak node, double p_before, double p_after, double spacing);

/// Load, friction, flow and film; without peak, balance and ends of cavities.
Sample sample_of(const PadSetup& setup, const film::FilmIntegrals& sums, double h_m, double time);

/// Adds the resultant of the pressure around a journal, eq-pad-journal, and the friction coefficient with it, where the
/// case states its radius. @param across weight of each strip @param p at the nodes, strip after strip [Pa]
void add_journal_load(const PadSetup& setup, const film::FilmGrid& grid, const std::vector<double>& across,
                      const std::vector<double>& p, Sample& sample);

/// Ends of the cavities in the sense of the motion; at rest the left one counts as upstream.
/// @param deficit at the nodes of the strip whose cavities `sums` holds
void add_fronts(const PadSetup& setup, const film::FilmInputs& inputs, const std::vector<double>& deficit,
                const film::FilmIntegrals& sums, Sample& sample);

/// Places of nodes, those of steps twice. @param last where the first node is repeated, if it is [m]
std::vector<double> places_with_steps(const std::vector<double>& nodes, const std::vector<int>& steps,
                                      std::optional<double> last);

struct ProfilePoint {
  double film_thickness, pressure, film_content;  ///< [m], [Pa], [-]
};
void append_node(Profile& along, const ProfilePoint& point);

/// Both sides of a step of the gap along x. The film content of the node is that of its downstream side; upstream the
/// same oil flows through the other gap. @param left, right film thickness [m]
void append_step(const PadSetup& setup, Profile& along, double left, double right, double pressure,
                 double film_content);

}  // namespace ringfilm::pad
