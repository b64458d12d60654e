#include "ringfilm/film/kernels/kernels.hpp"

#include <array>
#include <cstdlib>
#include <string>

#include "ringfilm/base/error.hpp"

namespace ringfilm::film {

extern const FilmKernels kBaselineKernels;
#if defined(RINGFILM_X86_KERNELS)
extern const FilmKernels kAvx2Kernels, kAvx512Kernels;
#endif

namespace {

/// Those that this machine runs, the narrowest first.
std::vector<const FilmKernels*> available() {
  std::vector<const FilmKernels*> kernels = {&kBaselineKernels};
#if defined(RINGFILM_X86_KERNELS)
  __builtin_cpu_init();
  const bool avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  if (avx2) kernels.push_back(&kAvx2Kernels);
  if (avx2 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512vl")) {
    kernels.push_back(&kAvx512Kernels);
  }
#endif
  return kernels;
}

}  // namespace

const FilmKernels& kernels() {
  const char* requested = std::getenv("RINGFILM_KERNELS");
  return requested == nullptr || *requested == '\0' ? *available().back() : kernels(requested);
}

const FilmKernels& kernels(std::string_view name) {
  std::string known;
  for (const FilmKernels* one : available()) {
    if (one->name == name) return *one;
    known += (known.empty() ? "" : ", ") + std::string(one->name);
  }
  throw InputError("there are no kernels \"" + std::string(name) + "\" that this machine can run",
                   "set RINGFILM_KERNELS to one of " + known + ", or leave it out for the last of them");
}

std::vector<std::string_view> kernel_names() {
  std::vector<std::string_view> names;
  for (const FilmKernels* one : available()) names.push_back(one->name);
  return names;
}

}  // namespace ringfilm::film
