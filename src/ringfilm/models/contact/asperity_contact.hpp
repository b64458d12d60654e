#pragma once
#include <array>
#include <optional>

#include "ringfilm/models/contact/contact_fit.hpp"
#include "ringfilm/models/contact/contact_law.hpp"

/// What rough surfaces carry where they touch (docs/theory/contact.md).
namespace ringfilm::models {

/// Where the height integrals F_2 and F_5/2 of contact come from.
enum class ContactIntegralForm {
  kExact,               ///< quadrature, to rounding
  kPolynomial4Digit,    ///< a fit of the literature, zero from its first root on
  kPolynomialAsPrinted  ///< the fit as styles2014 prints it, digits cut off: rises again beyond 1.911
};

/// Exact Gaussian integral F_n(lambda) = 1/sqrt(2 pi) int_lambda^inf (s - lambda)^n exp(-s^2/2) ds,
/// eq-gaussian-integral, by quadrature to rounding; n = 3/2, 2, 5/2 are what contact needs. n >= 1, 0 <= lambda <= 30.
double gaussian_integral(double n, double lambda);

/// A polynomial of the literature in place of F_n(lambda): the fifth power first, never below zero, and zero from `end`
/// on.
struct ContactQuintic {
  std::array<double, 6> c;  ///< coefficients in lambda, that of the fifth power first [-]
  double end;               ///< lambda from which on it is zero [-]
};

/// Contact of two rough surfaces after Greenwood and Tripp @cite greenwood1971, eqs eq-asperity-load, eq-asperity-area.
/// Convention: 2/E_prime = sum (1 - nu^2)/E goes with 8 sqrt(2)/15.
class GreenwoodTripp final : public AsperityContact {
 public:
  /// What a pair of surfaces brings.
  struct Parameters {
    double N;                                                ///< density of asperity peaks [1/m2]
    double beta;                                             ///< mean radius of asperity summits [m]
    double sigma;                                            ///< composite roughness [m]
    double E_prime;                                          ///< E' of 2/E' = sum (1 - nu^2)/E [Pa]
    ContactIntegralForm form = ContactIntegralForm::kExact;  ///< form of the height integrals F_2 and F_5/2
  };

  explicit GreenwoodTripp(const Parameters& parameters);  ///< all of them above zero

  /// For the exact form positive and strictly falling in h.
  Contact contact(double h) const override;
  void pressure(double h, double& p_a, double& dp_a_dh) const override;  ///< mean contact pressure and its slope in h

  const Parameters& parameters() const { return parameters_; }        ///< as given
  double pressure_scale() const { return pressure_scale_; }           ///< p_a/F_5/2 [Pa]
  double area_scale() const { return area_scale_; }                   ///< (A_a/A)/F_2 [-]
  double length_scale() const override { return parameters_.sigma; }  ///< sigma [m]
  /// Only the integrals of the exact form are smooth.
  bool has_kinks() const override { return parameters_.form != ContactIntegralForm::kExact; }
  /// Where the polynomial of F_5/2 as printed rises again (docs/theory/paper-errata.md) [m].
  double trusted_up_to() const override { return kPolynomialTurns * parameters_.sigma; }

  /// What may replace the integrals of the exact form; nullptr for the other forms.
  const ContactFit* fit() const { return quintics_ ? nullptr : &contact_fit(); }

  /// That fit with the scales of this contact.
  std::optional<FittedContact> fitted() const override {
    if (fit() == nullptr) return std::nullopt;
    return FittedContact{fit(), ContactFit::kEnd * parameters_.sigma, pressure_scale_, area_scale_};
  }

  /// In place of F_5/2; nullptr for the exact form.
  const ContactQuintic* quintic_52() const { return quintics_ ? &quintics_->F_52 : nullptr; }

  /// Beyond this separation the contact pressure is taken as zero (exact form: lambda = 8, share below 1e-16) [m].
  double reach() const override { return reach_; }

 private:
  static constexpr double kPolynomialTurns = 1.911;  // lambda ratio

  struct Quintics {
    ContactQuintic F_52, F_2;
  };

  Parameters parameters_;
  double pressure_scale_;  ///< 8 sqrt(2)/15 pi (N beta sigma)^2 sqrt(sigma/beta) E' [Pa]
  double area_scale_;      ///< pi^2 (N beta sigma)^2 [-]
  double reach_;           ///< [m]
  std::optional<Quintics> quintics_;
};

/// What N, beta and sigma state of an isotropic Gaussian surface (@cite mccool1987, @cite nayak1971), eqs
/// eq-spectral-moments, eq-summit-plane.
struct SummitStatistics {
  double bandwidth;      ///< alpha = m0 m4/m2^2 [-]
  double rms_slope;      ///< h' = sqrt(2 m2) [-]
  double summit_offset;  ///< height of the mean plane of the summits above that of the surface [m]
  double summit_spread;  ///< sigma_s, standard deviation of the summit heights [m]
};
/// Nothing where no such surface exists: alpha below 1.5.
std::optional<SummitStatistics> summit_statistics(const GreenwoodTripp::Parameters& pair);

/// Plasticity index of Greenwood and Williamson @cite greenwood1966, eq-plasticity-index [-]: above 1 the asperities
/// deform plastically at any usual load. @param sigma_s of the summit heights [m] @param hardness of the softer face
/// [Pa]
double plasticity_index(const GreenwoodTripp::Parameters& pair, double sigma_s, double hardness);

/// Radius of the mean contact spot at the lambda ratio lambda, eq-contact-spot [m].
double contact_spot_radius(double beta, double sigma, double lambda);

/// Share of a contact spot's approach that comes from below a coating of this thickness, eq-share-below-coating [-];
/// 1 at the most. Poisson's ratio is that of the coating.
double share_below_coating(double spot_radius, double thickness, double nu);

/// E' of 2/E' = sum (1 - nu^2)/E, eq-composite-modulus [Pa]. Throws InputError unless E > 0 and -1 < nu <= 0.5.
double composite_modulus(double E_1, double nu_1, double E_2, double nu_2);

}  // namespace ringfilm::models
