#include "ringfilm/models/contact/single_asperity.hpp"

#include <cmath>
#include <numbers>

namespace ringfilm::models {
namespace {

using std::numbers::pi;

// @cite zhao2000: mean pressure at first yield over hardness, and approach of full plasticity over that of first yield.
constexpr double kFirstYield = 0.4, kFullPlasticity = 54;
constexpr double kTabor = 2.84;  // hardness over yield strength, @cite jackson2005

/// @cite kogut2003: load and area over those of the first yield between its ranges, factor and exponent.
struct Range {
  double up_to, load, load_exponent, area, area_exponent;
};
constexpr std::array<Range, 3> kKogutEtsion{
    {{1, 1, 1.5, 1, 1}, {6, 1.03, 1.425, 0.93, 1.136}, {110, 1.40, 1.263, 0.94, 1.146}}};

}  // namespace

SingleAsperity::SingleAsperity(AsperityLaw law, const AsperityMaterial& material, double radius)
    : law_(law), material_(material), radius_(radius) {
  const double ratio = pi * material.hardness / (2 * material.E_star);
  switch (law) {
    case AsperityLaw::kElastic:
      break;
    case AsperityLaw::kZhaoMaiettaChang:
      critical_ = std::pow(1.5 * kFirstYield * ratio, 2) * radius;
      limits_ = {critical_, kFullPlasticity * critical_, 0};
      break;
    case AsperityLaw::kKogutEtsion:
      critical_ = std::pow((0.454 + 0.41 * material.nu) * ratio, 2) * radius;
      limits_ = {critical_, 6 * critical_, 110 * critical_};
      break;
    case AsperityLaw::kJacksonGreen:
      critical_ = std::pow(1.295 * std::exp(0.736 * material.nu) / kTabor * ratio, 2) * radius;
      limits_ = {1.9 * critical_, 0, 0};
      break;
  }
}

double SingleAsperity::hertz_load(double w) const {
  return 4.0 / 3.0 * material_.E_star * std::sqrt(radius_) * w * std::sqrt(w);
}

double SingleAsperity::jackson_green_load(double w) const {
  const double yield = material_.hardness / kTabor, C = 1.295 * std::exp(0.736 * material_.nu);
  const double strain = yield / material_.E_star, B = 0.14 * std::exp(23 * strain);
  const double x = w / critical_;
  const double radius_ratio = 0.5 * pi * C * strain * std::sqrt(x) * std::pow(x / 1.9, 0.5 * B);
  const double hardness = kTabor * -std::expm1(-0.82 * std::pow(radius_ratio, -0.7));  // over the yield strength
  const double elastic = std::exp(-0.25 * std::pow(x, 5.0 / 12)) * x * std::sqrt(x);
  const double plastic = 4 * hardness / C * -std::expm1(-std::pow(x, 5.0 / 9) / 25) * x;
  return hertz_load(critical_) * (elastic + plastic);
}

double SingleAsperity::load(double w) const {
  const double x = critical_ > 0 ? w / critical_ : 0;
  switch (law_) {
    case AsperityLaw::kElastic:
      break;
    case AsperityLaw::kZhaoMaiettaChang: {
      if (x <= 1) break;
      if (x >= kFullPlasticity) return 2 * pi * radius_ * w * material_.hardness;
      const double pressure =
          material_.hardness * (1 - (1 - kFirstYield) * std::log(kFullPlasticity / x) / std::log(kFullPlasticity));
      return pressure * area(w);
    }
    case AsperityLaw::kKogutEtsion:
      for (const Range& range : kKogutEtsion) {
        if (x <= range.up_to) return hertz_load(critical_) * range.load * std::pow(x, range.load_exponent);
      }
      return 2 * pi * radius_ * w * material_.hardness;
    case AsperityLaw::kJacksonGreen:
      if (x > 1.9) return jackson_green_load(w);
      break;
  }
  return hertz_load(w);
}

double SingleAsperity::area(double w) const {
  const double elastic = pi * radius_ * w;
  const double x = critical_ > 0 ? w / critical_ : 0;
  switch (law_) {
    case AsperityLaw::kElastic:
      break;
    case AsperityLaw::kZhaoMaiettaChang: {
      if (x <= 1) break;
      if (x >= kFullPlasticity) return 2 * elastic;
      const double y = (x - 1) / (kFullPlasticity - 1);
      return elastic * (1 + y * y * (3 - 2 * y));
    }
    case AsperityLaw::kKogutEtsion:
      for (const Range& range : kKogutEtsion) {
        if (x <= range.up_to) return pi * radius_ * critical_ * range.area * std::pow(x, range.area_exponent);
      }
      return 2 * elastic;
    case AsperityLaw::kJacksonGreen: {
      if (x <= 1.9) break;
      const double B = 0.14 * std::exp(23 * material_.hardness / kTabor / material_.E_star);
      return elastic * std::pow(x / 1.9, B);
    }
  }
  return elastic;
}

}  // namespace ringfilm::models
