#include "scenarios.hpp"

#include <cmath>
#include <string>

#include "ringfilm/io/case/case_file.hpp"

namespace ringfilm::benchmarks {
namespace {

/// The i-th of numbers that film content -1 ... 1 evenly, 0 the first: multiples of an irrational number.
double spread(std::size_t i, double irrational) {
  const double x = 0.5 + static_cast<double>(i) * irrational;
  return 2 * (x - std::floor(x)) - 1;
}

// Powers of 1/1.2207440846, the root of x^4 = x + 1: three sequences that keep apart from one another.
constexpr double kFirst = 0.8191725133961645, kSecond = 0.6710436067037893, kThird = 0.5497004779019703;

constexpr double kSpeedRange = 0.2, kPressureRange = 0.2;
constexpr double kTemperatureRange = 10;  // [K]

}  // namespace

Scenarios::Scenarios(int cells, cycle::Cavitation cavitation)
    : base_(io::read_case(std::string(RINGFILM_SOURCE_FOLDER) + "/cases/styles2014/new.toml")) {
  base_.solver.cells = cells;
  base_.solver.crank_step_deg = 1;
  base_.solver.crank_step_control = cycle::StepControl::kFixed;
  base_.film.cavitation = cavitation;
  base_.output.fields = cycle::FieldOutput::kNone;
  elastic_pressure_ = cycle::prepare(base_).ring.elastic_pressure;
}

cycle::Setup Scenarios::setup(std::size_t i) const {
  cycle::Case c = base_;
  c.operating.speed *= 1 + kSpeedRange * spread(i, kFirst);
  c.operating.oil_temperature += kTemperatureRange * spread(i, kSecond);
  c.ring.tangential_force.reset();
  c.ring.free_gap.reset();
  c.ring.radial_thickness.reset();
  c.ring.elastic_pressure = elastic_pressure_ * (1 + kPressureRange * spread(i, kThird));
  return cycle::prepare(c);
}

}  // namespace ringfilm::benchmarks
