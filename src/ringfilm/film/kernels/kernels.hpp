#pragma once
#include <string_view>
#include <vector>

#include "ringfilm/film/kernels/film_sums.hpp"
#include "ringfilm/film/kernels/lane_block.hpp"

/// The inner loops of the film, compiled for several kinds of machine from one source; the best is chosen at run time.
namespace ringfilm::film {

struct FilmKernels {
  std::string_view name;             ///< "avx512"
  int width;                         ///< lanes of `sweep`
  void (*sweep)(LaneBlock&);         ///< Newton's iteration, `width` films
  void (*single_sweep)(LaneBlock&);  ///< one film
  void (*mass_per_area)(const FilmView&, const FittedOilView&, double* to);
  void (*read)(const LaneView&, int n_nodes, const FilmPressure&);
  double (*remembered_mass)(const ExpectedMass&, int n_nodes, double* to);
  MassSums (*mass_off)(const double* mass, const ExpectedMass&, int n_nodes);
  void (*continued)(const FilmMotion&, int n_nodes, const FilmPressure&);
  FilmSums (*sums)(const FilmView&, const FittedOilView&, const StepView&, const FluxRequest&);
  FilmSums (*sums_of_given_oil)(const FilmView&, const NodalOilView&, const StepView&, const FluxRequest&);
  HeatingSums (*heating)(const FilmView&, const FittedOilView&, double U);
  HeatingSums (*heating_of_given_oil)(const FilmView&, const NodalOilView&, double U);
  int (*next_node)(const double* deficit, int i, int end, bool cavity);
  ContactSums (*contact)(const FilmView&, const FittedContactView&);
  ContactSums (*tabulated_contact)(const FilmView&, const TabulatedContactView&);
};

/// The widest that this machine has, or the one that the environment variable RINGFILM_KERNELS names ("baseline",
/// "avx2", "avx512"). Throws InputError for an unknown name and for one that this machine cannot run.
const FilmKernels& kernels();

/// The kernels of the given name. Throws InputError for an unknown name and for one that this machine cannot run.
const FilmKernels& kernels(std::string_view name);

/// Names that this machine can run, the narrowest first.
std::vector<std::string_view> kernel_names();

}  // namespace ringfilm::film
