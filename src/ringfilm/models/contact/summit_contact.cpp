#include "ringfilm/models/contact/summit_contact.hpp"

#include <boost/math/interpolators/cubic_hermite.hpp>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "ringfilm/base/error.hpp"

namespace ringfilm::models {
namespace {

using std::numbers::pi;
using std::numbers::sqrt2;
using Quadrature = boost::math::quadrature::gauss<double, 15>;

double density(double x, double sigma) {
  return std::exp(-0.5 * x * x / (sigma * sigma)) / (sigma * std::sqrt(2 * pi));
}
double share_above(double x, double sigma) { return 0.5 * std::erfc(x / (sigma * sqrt2)); }

SummitStatistics summits_of(const GreenwoodTripp::Parameters& pair) {
  const auto summits = summit_statistics(pair);
  if (summits) return *summits;
  throw InputError(
      "no Gaussian surface has these asperity density, radius and roughness together (bandwidth parameter below 1.5): "
      "the plane of its summits is not known",
      "measure all three on one surface with one cut-off, or contact.summit_plane = \"surface\"");
}

/// Integral of f(w) weight(w) over w from 0 on, with the limits of the asperity between panels; in v = sqrt(w), in
/// which loads are smooth.
template <class Function>
double over_approaches(const SingleAsperity& asperity, double end, double panel, const Function& f) {
  std::vector<double> ends;
  for (const double limit : asperity.limits()) {
    if (limit > 0 && limit < end) ends.push_back(std::sqrt(limit));
  }
  ends.push_back(std::sqrt(end));
  const auto integrand = [&](double v) { return 2 * v * f(v * v); };
  double sum = 0, from = 0;
  for (const double to : ends) {
    const int pieces = 1 + static_cast<int>((to - from) / std::sqrt(panel));
    for (int k = 0; k < pieces; ++k) {
      const double width = (to - from) / pieces;
      sum += Quadrature::integrate(integrand, from + k * width, from + (k + 1) * width);
    }
    from = to;
  }
  return sum;
}

constexpr double kFarthest = 9;  // standard deviations beyond which no summit is

/// Summits of one height distribution: both laws of Greenwood.
std::function<PressureAndArea(double)> greenwood(const GreenwoodTripp::Parameters& pair,
                                                 const SummitContactChoice& choice) {
  const bool of_pairs = choice.model == ContactModel::kGreenwoodTripp;
  const bool of_one = of_pairs && choice.moments == ContactMoments::kOneSurface;
  const double beta = of_one ? sqrt2 * pair.beta : pair.beta;
  double offset = 0, sigma = pair.sigma;
  if (choice.plane == SummitPlane::kNayak) {
    const SummitStatistics summits = summits_of(pair);
    offset = summits.summit_offset * (of_one ? sqrt2 : 1);  // both planes of the summits of two like surfaces
    sigma = summits.summit_spread;
  }
  const SingleAsperity asperity(choice.asperity, {pair.E_prime / 2, choice.hardness, choice.nu},
                                of_pairs ? beta / 2 : beta);
  const double per_area = of_pairs ? 4 * pi * pair.N * pair.N * beta : pair.N;
  return [=](double h) -> PressureAndArea {
    const double d = h - offset;
    const double end = std::max(kFarthest * sigma - d, sigma);
    const double panel = 0.25 * sigma / std::max(1.0, -d / (4 * sigma));  // far below the plane all is about w = -d
    const auto integral = [&](const auto& of) {
      return per_area * over_approaches(asperity, end, panel, [&](double w) {
               return of(w) * (of_pairs ? share_above(d + w, sigma) : density(d + w, sigma));
             });
    };
    return {integral([&](double w) { return asperity.load(w); }), integral([&](double w) { return asperity.area(w); })};
  };
}

/// Hertz's contact of a summit with two curvatures (@cite johnson1985, section 4.2): what the geometric mean radius has
/// to be corrected by.
struct EllipticFactors {
  double load, area;
};
EllipticFactors elliptic_factors(double curvature_ratio) {
  if (curvature_ratio > 1 - 1e-9) return {1, 1};
  const auto ratio_of = [](double axes) {  // curvature ratio of the ellipse with these axes, b/a
    const double e = std::sqrt(1 - axes * axes), K = boost::math::ellint_1(e), E = boost::math::ellint_2(e);
    return (K - E) / (E / (axes * axes) - K);
  };
  double low = 1e-6, high = 1 - 1e-12;
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (low + high);
    (ratio_of(middle) < curvature_ratio ? low : high) = middle;
  }
  const double axes = 0.5 * (low + high), e = std::sqrt(1 - axes * axes);
  const double K = boost::math::ellint_1(e), E = boost::math::ellint_2(e);
  const double F_1 = std::cbrt(4 / (pi * e * e) * std::pow(axes, 1.5) * std::sqrt((E / (axes * axes) - K) * (K - E)));
  const double F_2 = 2 / pi * std::sqrt(axes) * K / F_1;
  return {std::pow(F_2, -1.5), F_1 * F_1 / F_2};
}

/// F_n for negative arguments, too, where few heights are below.
constexpr double kFewBelow = -5;
double height_integral(double n, double lambda) {
  if (lambda > kFewBelow) return lambda > 30 ? 0 : gaussian_integral(n, lambda);
  const double square = lambda * lambda;
  return std::pow(-lambda, n) * (1 + n * (n - 1) / (2 * square) * (1 + (n - 2) * (n - 3) / (4 * square)));
}

/// height_integral of one exponent, from a table where most summits are: with these steps to 3e-7 of its value.
class HeightIntegral {
 public:
  /// @param n at least 1
  explicit HeightIntegral(double n) : n_(n), table_(values(n), values(n - 1, -n), kFewBelow, kStep) {}
  double operator()(double lambda) const {
    return lambda >= kFewBelow && lambda < kEnd ? table_(lambda) : height_integral(n_, lambda);
  }

 private:
  static constexpr double kStep = 1.0 / 64, kEnd = 6;
  static std::vector<double> values(double n, double scale = 1) {
    std::vector<double> F;
    for (double lambda = kFewBelow; lambda <= kEnd; lambda += kStep) F.push_back(scale * gaussian_integral(n, lambda));
    return F;
  }
  double n_;
  boost::math::interpolators::cardinal_cubic_hermite<std::vector<double>> table_;  // F_n' = -n F_(n-1)
};

/// Summits with the joint distribution of height and curvatures @cite nayak1971 @cite bush1975.
std::function<PressureAndArea(double)> bush_gibson_thomas(const GreenwoodTripp::Parameters& pair) {
  const SummitStatistics summits = summits_of(pair);
  const double m0 = pair.sigma * pair.sigma, m2 = 0.5 * summits.rms_slope * summits.rms_slope;
  const double m4 = summits.bandwidth * m2 * m2 / m0;
  const double spread_u = std::sqrt(2 * m4 / 3);  // standard deviation of the mean curvature u
  const double height_of_u = 1.5 * m2 / m4;       // mean height of summits with this curvature over it
  const double s = std::sqrt(m0 - 1.5 * m2 * m2 / m4);
  constexpr int kTau = 48, kU = 40;
  constexpr double kMaxU = 9;
  struct Node {
    double height, load, area;
  };
  std::vector<EllipticFactors> factors;
  for (int k = 0; k < kTau; ++k) {
    const double tau = (k + 0.5) / kTau;
    factors.push_back(elliptic_factors((1 - tau) / (1 + tau)));
  }
  std::vector<Node> nodes;
  for (int i = 0; i < kU; ++i) {
    const double u = (i + 0.5) / kU * kMaxU * spread_u;
    double load = 0, area = 0;
    for (int k = 0; k < kTau; ++k) {
      const double tau = (k + 0.5) / kTau, product = u * u * (1 - tau * tau);  // product of both principal curvatures
      const double weight = u / kTau * (3 * u * tau / m4) * std::exp(-1.5 * u * u * tau * tau / m4) * product;
      load += weight * std::pow(product, -0.25) * factors[k].load;
      area += weight * std::pow(product, -0.5) * factors[k].area;
    }
    const double of_u = density(u, spread_u) * kMaxU * spread_u / kU / (2 * pi * m2);
    nodes.push_back({height_of_u * u, of_u * load * 2.0 / 3.0 * pair.E_prime * s * std::sqrt(s), of_u * area * pi * s});
  }
  return [nodes, s, of_load = HeightIntegral(1.5), of_area = HeightIntegral(1)](double h) {
    PressureAndArea sum{0, 0};
    for (const Node& node : nodes) {
      const double lambda = (h - node.height) / s;
      sum.pressure += node.load * of_load(lambda);
      sum.area_share += node.area * of_area(lambda);
    }
    return sum;
  };
}

}  // namespace

std::function<PressureAndArea(double)> summit_contact(const GreenwoodTripp::Parameters& pair,
                                                      const SummitContactChoice& choice) {
  switch (choice.model) {
    case ContactModel::kGreenwoodTripp:
    case ContactModel::kGreenwoodWilliamson:
      break;
    case ContactModel::kBushGibsonThomas:
      return bush_gibson_thomas(pair);
    case ContactModel::kPlastic:
      return [sigma = pair.sigma, hardness = choice.hardness](double h) -> PressureAndArea {
        const double share = share_above(h, sigma);
        return {hardness * share, share};
      };
  }
  return greenwood(pair, choice);
}

ContactTable tabulated(const std::function<PressureAndArea(double)>& law, double sigma) {
  constexpr double kStep = 0.1, kLeft = 1e-12;  // step over sigma; share of the pressure at 0 where the table ends
  ContactTable table;
  for (int k = 0; k < 400; ++k) {
    const double h = k * kStep * sigma;
    const PressureAndArea of = law(h);
    if (!table.pressure.empty() && !(of.pressure > kLeft * table.pressure.front())) break;
    table.h.push_back(h);
    table.pressure.push_back(of.pressure);
    table.area_share.push_back(of.area_share);
  }
  return table;
}

}  // namespace ringfilm::models
