#pragma once
#include <vector>

#include "ringfilm/cycle/case/case.hpp"
#include "ringfilm/cycle/result.hpp"

namespace ringfilm::cycle {

/// Is the law the closed form of Greenwood and Tripp with the numbers of a pair, as styles2014 feeds it? Its sigma is
/// used as given there, a root-sum-square of Ra; all other laws of N, beta and sigma take the rms height.
bool is_closed_form(const Contact& contact);

/// Notes on numbers of the contact that no pair of ring and liner has (docs/theory/contact.md).
/// @param sigma composite roughness as the contact model uses it [m]
void append_contact_notes(const Case& c, double sigma, std::vector<Note>& notes);

}  // namespace ringfilm::cycle
