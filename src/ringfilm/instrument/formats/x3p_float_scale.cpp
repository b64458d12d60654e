#include "ringfilm/instrument/formats/x3p_float_scale.hpp"

#include <fmt/format.h>

#include <cmath>

namespace ringfilm::instrument {
namespace {

/// rms height about the mean.
double rms_of_values(const ChannelValues& values) {
  double count = 0, mean = 0, squares = 0;
  for (std::size_t i = 0; i < values.value.size(); ++i) {
    if (values.is_missing(i)) continue;
    count += 1;
    const double off = values.value[i] - mean;
    mean += off / count;
    squares += off * (values.value[i] - mean);
  }
  return count > 0 ? std::sqrt(squares / count) : 0;
}

}  // namespace

void apply_float_scale(const X3pFloatScale& scale, ChannelValues& values) {
  const auto [type, increment, offset] = scale;
  if (increment == 1 && offset == 0) return;
  constexpr double kAtom_m = 0.05e-9;  // rms height of the smoothest surfaces
  const double rms_m = rms_of_values(values), scaled_m = rms_m * increment;
  const bool is_applied = increment == 1 || !(scaled_m < kAtom_m && rms_m >= kAtom_m);
  if (is_applied) {
    for (std::size_t i = 0; i < values.value.size(); ++i) {
      if (!values.is_missing(i)) values.value[i] = values.value[i] * increment + offset;
    }
  }
  if (increment == 1) return;
  const std::string rule = fmt::format(
      "main.xml, CZ/Increment: heights of type {} are floating-point numbers, which are in metres as a rule", type);
  values.doubts.push_back(
      is_applied
          ? Doubt{fmt::format("{}, and were multiplied by the increment {:g}", rule, increment),
                  "if the heights come out too small, export the file with an increment of 1"}
          : Doubt{fmt::format("{}; with the increment {:g} their rms height would be {:.3g} m, heights below the "
                              "size of an atom: they were read without it",
                              rule, increment, scaled_m),
                  "if they are not in metres, export the file with heights in metres and an increment of 1"});
}

}  // namespace ringfilm::instrument
