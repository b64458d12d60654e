#pragma once
#include <string>
#include <vector>

#include "ringfilm/cycle/result/result.hpp"

/// Surfaces whose contact, or the flow between which, has a closed form (verification/contact_closed_forms).
namespace ringfilm::study {

/// A surface of one wave length, E* = 1 and amplitude 1/100 where nothing else is stated: all numbers are ratios.
struct ContactForm {
  std::string surface;    ///< one of contact_surfaces()
  int points = 0;         ///< along an axis
  double separation = 0;  ///< wave, egg box: h/D; gap: the mean gap over the amplitude; rough: over the rms height [-]
  double hardness = 0;    ///< wave: H/p*; rough and persson: over E* h'; 0: elastic [-]
  double size = 0;        ///< punches: half width over the period; persson: p/(E* h') [-]
};

/// "wave", "egg-box", "punches", "sphere", "rough", "gap", "persson".
const std::vector<std::string>& contact_surfaces();

/// What a surface has: see the README of the verification.
const std::vector<cycle::Quantity>& contact_form_quantities();

/// @param quantity one of contact_form_quantities(), of a surface that has it; else NaN [-]
double contact_form_value(const ContactForm& form, const std::string& quantity);

}  // namespace ringfilm::study
