#pragma once
#include "ringfilm/film/kernels/kernels.hpp"
#include "ringfilm/film/kernels/newton_sweep.hpp"

/// For the sources that compile the kernels, each for one kind of machine: kernels_*.cpp.
namespace ringfilm::film {

template <class Real, class Wide, LaneLaws kLaws, LaneCavity kCavity>
void sweep_with_terms(LaneBlock& block) {
  if (block.terms == Terms::kPlain) {
    NewtonSweep<Real, Wide, kLaws, kCavity, Terms::kPlain>(block).run();
  } else {
    NewtonSweep<Real, Wide, kLaws, kCavity, Terms::kAll>(block).run();
  }
}

template <class Real, class Wide>
void sweep(LaneBlock& block) {
  const bool film_content = block.cavity == LaneCavity::kFilmContent;
  if (block.laws == LaneLaws::kFitted) {
    if (film_content) {
      sweep_with_terms<Real, Wide, LaneLaws::kFitted, LaneCavity::kFilmContent>(block);
    } else {
      sweep_with_terms<Real, Wide, LaneLaws::kFitted, LaneCavity::kMultiplier>(block);
    }
  } else {
    if (film_content) {
      sweep_with_terms<Real, Wide, LaneLaws::kGiven, LaneCavity::kFilmContent>(block);
    } else {
      sweep_with_terms<Real, Wide, LaneLaws::kGiven, LaneCavity::kMultiplier>(block);
    }
  }
}

template <class Real, class One>
void mass_per_area(const FilmView& film, const FittedOilView& oil, double* to) {
  AlongFace<Real, One>::mass_per_area(film, oil, to);
}

template <class Real, class One>
void read_lane(const LaneView& lane, int n_nodes, const FilmPressure& to) {
  AlongFace<Real, One>::read(lane, n_nodes, to);
}

template <class Real, class One>
double remembered_mass(const ExpectedMass& mass, int n_nodes, double* to) {
  return AlongFace<Real, One>::remembered_mass(mass, n_nodes, to);
}

template <class Real, class One>
MassSums mass_off(const double* mass, const ExpectedMass& expected, int n_nodes) {
  return AlongFace<Real, One>::mass_off(mass, expected, n_nodes);
}

template <class Real, class One>
void continued(const FilmMotion& film, int n_nodes, const FilmPressure& to) {
  AlongFace<Real, One>::continued(film, n_nodes, to);
}

template <class Real, class One, class Oil>
FilmSums sums(const FilmView& film, const Oil& oil, const StepView& step, const FluxRequest& fluxes) {
  return AlongFace<Real, One>::sums(film, oil, step, fluxes);
}

template <class Real, class One, class Oil>
HeatingSums heating_sums(const FilmView& film, const Oil& oil, double U) {
  return AlongFace<Real, One>::heating(film, oil, U);
}

template <class Real, class One>
int next_node(const double* deficit, int i, int end, bool cavity) {
  return AlongFace<Real, One>::next_node(deficit, i, end, cavity);
}

template <class Real, class One, class View>
ContactSums contact_sums(const FilmView& film, const View& contact) {
  return AlongFace<Real, One>::contact(film, contact);
}

template <int kWidth, base::InstructionSet kSet>
constexpr FilmKernels kernels_of(std::string_view name) {
  using Real = base::Pack<kWidth, kSet>;
  using One = base::Pack<1, kSet>;
  return {name,
          kWidth,
          sweep<Real, Real>,
          sweep<One, Real>,
          mass_per_area<Real, One>,
          read_lane<Real, One>,
          remembered_mass<Real, One>,
          mass_off<Real, One>,
          continued<Real, One>,
          sums<Real, One, FittedOilView>,
          sums<Real, One, NodalOilView>,
          heating_sums<Real, One, FittedOilView>,
          heating_sums<Real, One, NodalOilView>,
          next_node<Real, One>,
          contact_sums<Real, One, FittedContactView>,
          contact_sums<Real, One, TabulatedContactView>};
}

}  // namespace ringfilm::film
