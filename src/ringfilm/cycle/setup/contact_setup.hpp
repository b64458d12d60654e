#pragma once
#include <memory>
#include <optional>
#include <string>

#include "ringfilm/case/case.hpp"
#include "ringfilm/models/contact/asperity_contact.hpp"
#include "ringfilm/models/contact/plateau.hpp"

/// The contact of a case's ring with its liner.
namespace ringfilm::cycle {

/// Hardness of a grey iron liner, typical, assumed (data/materials/hardness.csv): the softer face of most pairs [Pa].
inline constexpr double kUsualHardness = 2.5e9;

/// Is the law the closed form of Greenwood and Tripp with the numbers of a pair, as styles2014 feeds it? Its sigma is
/// used as given there, a root-sum-square of Ra; all other laws of N, beta and sigma take the rms height.
bool is_closed_form(const Contact& contact);

/// E' of the keys, of the moduli or of the table [Pa].
double composite_modulus(const Case& c);

/// The lines of `contact.plateau`, of the values that it states; nothing where the liner has no stated plateau.
std::optional<models::PlateauCurve> plateau_curve(const Contact& contact);

/// Key or section that states sigma, for messages.
std::string roughness_keys(const Contact& contact);

/// Planes and rms height of that liner, by the curve or as they were measured.
std::optional<models::PlateauPlanes> plateau_planes(const Contact& contact);

/// Mean plane of the plateau above that of the whole liner [m]; 0 without `contact.plateau`.
double plateau_offset(const Contact& contact);

/// The case with a Gaussian surface of the same composite roughness in place of `contact.plateau`.
Case without_plateau(Case c);

/// The case with another rms of the plateau over valleys that stay where they are, eq-life-run-in-plateau; a case
/// without `contact.plateau` as it is. @param Rpq [m]
Case with_plateau_roughness(Case c, double Rpq);

/// Composite roughness that film and lambda ratio refer to, that of the whole surfaces [m].
double roughness(const Case& c);

/// Composite roughness of what carries [m]: the same, or that of ring and plateau. Not of a table.
double asperity_roughness(const Case& c);

/// Share of the ring in the square of the composite roughness [-]; of film.shear_flow.
double ring_roughness_share(const Case& c);

/// N, beta and sigma of the pair, of its plateau where the case has one; nothing where the law is a table.
std::optional<models::GreenwoodTripp::Parameters> asperities(const Case& c);

/// The law of `contact.model`. Throws InputError where no surface has its parameters.
std::shared_ptr<const models::AsperityContact> asperity_contact(const Case& c);

}  // namespace ringfilm::cycle
