#pragma once
#include <memory>
#include <optional>

#include "ringfilm/cycle/case/case.hpp"
#include "ringfilm/models/asperity_contact.hpp"

/// The contact of a case's ring with its liner.
namespace ringfilm::cycle {

/// Of a grey iron liner, typical, assumed (data/materials/hardness.csv): the softer face of most pairs [Pa].
inline constexpr double kUsualHardness = 2.5e9;

/// E' of the keys, of the moduli or of the table [Pa].
double composite_modulus(const Case& c);

/// Composite roughness as the contact model uses it [m].
double roughness(const Case& c);

/// N, beta and sigma of the pair; nothing where the law is a table.
std::optional<models::GreenwoodTripp::Parameters> asperities(const Case& c);

/// The law of `contact.model`. Throws InputError where no surface has its parameters.
std::shared_ptr<const models::AsperityContact> asperity_contact(const Case& c);

}  // namespace ringfilm::cycle
