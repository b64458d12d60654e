#pragma once
#include <memory>
#include <optional>

#include "ringfilm/case/case.hpp"
#include "ringfilm/models/contact/asperity_contact.hpp"

/// The contact of a case's ring with its liner.
namespace ringfilm::cycle {

/// Hardness of a grey iron liner, typical, assumed (data/materials/hardness.csv): the softer face of most pairs [Pa].
inline constexpr double kUsualHardness = 2.5e9;

/// Is the law the closed form of Greenwood and Tripp with the numbers of a pair, as styles2014 feeds it? Its sigma is
/// used as given there, a root-sum-square of Ra; all other laws of N, beta and sigma take the rms height.
bool is_closed_form(const Contact& contact);

/// E' of the keys, of the moduli or of the table [Pa].
double composite_modulus(const Case& c);

/// Composite roughness as the contact model uses it [m].
double roughness(const Case& c);

/// N, beta and sigma of the pair; nothing where the law is a table.
std::optional<models::GreenwoodTripp::Parameters> asperities(const Case& c);

/// The law of `contact.model`. Throws InputError where no surface has its parameters.
std::shared_ptr<const models::AsperityContact> asperity_contact(const Case& c);

}  // namespace ringfilm::cycle
