#pragma once
#include <cstddef>
#include <cstdint>
#include <string>

/// How a fuzz target begins: RINGFILM_FUZZ_TARGET(name) { ... return 0; }, with its input in `data` and `size`. With
/// libFuzzer each target is a program of its own; else one program, replay, holds them all by their names.
#ifdef RINGFILM_LIBFUZZER
#define RINGFILM_FUZZ_TARGET(name) extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
#else
#define RINGFILM_FUZZ_TARGET(name)                                                      \
  static int fuzz_target_##name(const std::uint8_t* data, std::size_t size);            \
  static const bool kListed_##name = ringfilm::fuzz::listed(#name, fuzz_target_##name); \
  static int fuzz_target_##name(const std::uint8_t* data, std::size_t size)
#endif

namespace ringfilm::fuzz {

using Target = int (*)(const std::uint8_t* data, std::size_t size);

/// Lets replay find the target by its name. Returns true.
bool listed(const std::string& name, Target target);

}  // namespace ringfilm::fuzz
