#include "fuzz_target.hpp"
#include "input_file.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/io/data/trace_file.hpp"

/// A pressure trace as CSV, taken for absolute in a cylinder and for gauge in a crankcase.
RINGFILM_FUZZ_TARGET(trace) {
  using namespace ringfilm;
  static const io::Units units;
  const std::string path = fuzz::input_file(data, size, "trace.csv");
  io::TraceColumns cylinder;
  cylinder.angle_unit = "degree";
  io::TraceColumns crankcase;
  crankcase.reference = cycle::PressureReference::kGauge;
  crankcase.place = io::TracePlace::kCrankcase;
  for (const io::TraceColumns& columns : {cylinder, crankcase}) {
    try {
      io::read_trace({path, "trace.csv"}, columns, units);
    } catch (const InputError& error) {
      describe(error.faults());
    }
  }
  return 0;
}
