#pragma once
#include <functional>

#include "ringfilm/models/contact/asperity_contact.hpp"
#include "ringfilm/models/contact/single_asperity.hpp"
#include "ringfilm/models/contact/tabulated_contact.hpp"

namespace ringfilm::models {

/// Laws for Gaussian surfaces by their summits, or by the share of the heights above the separation.
enum class ContactModel {
  kGreenwoodTripp,       ///< two rough surfaces, pairs of summits
  kGreenwoodWilliamson,  ///< one rough surface against a flat
  /// One rough surface against a flat, with the joint distribution of summit heights and curvatures.
  kBushGibsonThomas,
  kPlastic,  ///< hardness times the material ratio
};

/// From which plane the separation is measured.
enum class SummitPlane {
  kSurface,  ///< mean plane of the surfaces, used as if it were the mean plane of the summits
  kNayak,    ///< mean plane of the summits, from their bandwidth parameter
};

/// Whose density and radius a law of pairs takes.
enum class ContactMoments {
  kPair,        ///< density and radius of the sum of both surfaces
  kOneSurface,  ///< density and radius of one of two like surfaces
};

/// Which law of the contact of a pair, and what it needs.
struct SummitContactChoice {
  ContactModel model = ContactModel::kGreenwoodTripp;
  AsperityLaw asperity = AsperityLaw::kElastic;
  SummitPlane plane = SummitPlane::kSurface;
  ContactMoments moments = ContactMoments::kPair;
  double hardness = 0;  ///< hardness of the softer face; 0 where nothing uses it [Pa]
  double nu = 0.3;      ///< Poisson's ratio of the softer face [-]
};

/// Pressure and area share at a separation [m].
struct PressureAndArea {
  double pressure;    ///< [Pa]
  double area_share;  ///< [-]
};
/// The law as a function, by quadrature: eq-summit-contact, eq-bush-gibson-thomas, eq-plastic-contact. Throws
/// InputError where no Gaussian surface has these parameters, but with SummitPlane::kSurface nothing asks for one.
std::function<PressureAndArea(double)> summit_contact(const GreenwoodTripp::Parameters& pair,
                                                      const SummitContactChoice& choice);

/// Table of a contact law from separation 0 to where its pressure is negligible.
ContactTable tabulated(const std::function<PressureAndArea(double)>& law, double sigma);

}  // namespace ringfilm::models
