#pragma once
#include <string_view>

namespace ringfilm::benchmarks {

/// As many floating-point operations a second as the machine can do with one kind of instructions.
struct FmaPeak {
  double (*run)(long rounds);   ///< returns a number that depends on all of them
  double operations_per_round;  ///< a product and a sum are two
};

/// For the kernels of that name (film/kernels/kernels.hpp).
const FmaPeak& fma_peak(std::string_view kernels);

}  // namespace ringfilm::benchmarks
