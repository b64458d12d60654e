// A cycle with an oil law of one's own: a free-volume law of viscosity after Doolittle over Tait's law of density, in
// place of the laws that a case can name.
//   own_oil CASE.toml
#include <cmath>
#include <cstdio>
#include <exception>
#include <memory>

#include "ringfilm/ringfilm.hpp"

namespace {

using namespace ringfilm;

/// Doolittle's law on the volume that Tait's equation of state gives, at one temperature; illustrative numbers, not
/// those of an oil on the market. K0 and K0_slope are the bulk modulus at no pressure and its slope.
class FreeVolumeOil {
 public:
  FreeVolumeOil(double viscosity, double density) : eta_0_(viscosity), rho_0_(density) {}

  double density(double p) const { return rho_0_ / volume(p); }
  double viscosity(double p) const {
    const double occupied = 0.66;  // of the volume at no pressure
    const double B = 4.0;
    return eta_0_ * std::exp(B * occupied * (1 / (volume(p) - occupied) - 1 / (1 - occupied)));
  }

 private:
  static double volume(double p) {  // relative to that at no pressure
    const double K0 = 1.2e9, K0_slope = 11;
    return 1 - std::log(1 + p / K0 * (1 + K0_slope)) / (1 + K0_slope);
  }
  double eta_0_, rho_0_;
};

void compute(const char* case_path) {
  const cycle::Case input = io::read_case(case_path);
  const cycle::CycleResult of_the_case = cycle::simulate(cycle::prepare(input));

  const double viscosity = of_the_case.derived.at("oil_viscosity"), density = of_the_case.derived.at("oil_density");
  const FreeVolumeOil oil(viscosity, density);
  const auto law = models::oil_of_functions([oil](double p) { return oil.viscosity(p); },
                                            [oil](double p) { return oil.density(p); });
  const cycle::Setup setup = cycle::prepare(input, {"Doolittle on Tait's volume", law});
  const cycle::CycleResult own = cycle::simulate(setup);

  std::printf("viscosity at 10 MPa: the case %.4f mPa s, own law %.4f mPa s\n",
              cycle::prepare(input).ring.oil.range->at(input.operating.oil_temperature)->viscosity(10e6) * 1e3,
              law->viscosity(10e6) * 1e3);
  std::printf("mean power loss: the case %.4f W, own law %.4f W\n", of_the_case.values.mean_power_loss,
              own.values.mean_power_loss);
  std::printf("polynomials replace the own law in the inner loop: %s\n",
              setup.ring.oil.range->has_fit() ? "yes" : "no");
  for (const cycle::Note& note : own.notes) std::printf("note: %s\n", note.message.c_str());

  // The same law for many cases on all threads.
  study::BatchOptions options;
  options.prepare = [&](const cycle::Case& c) { return cycle::prepare(c, {"Doolittle on Tait's volume", law}); };
  std::vector<cycle::Case> cases(8, input);
  for (std::size_t i = 0; i < cases.size(); ++i) cases[i].operating.speed *= 1 + 0.1 * static_cast<double>(i);
  for (const study::Ending& ending : study::endings(cases, {}, options)) {
    std::printf("scenario %zu: %.4f W %s\n", ending.index, ending.result.values.mean_power_loss,
                ending.reason().c_str());
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: own_oil CASE.toml\n");
    return 2;
  }
  try {
    compute(argv[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
