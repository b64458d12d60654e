#include "ringfilm/study/sampling/sobol_points.hpp"

#include <boost/random/sobol.hpp>
#include <stdexcept>

#include "ringfilm/study/sampling/hash.hpp"

namespace ringfilm::study {
namespace {

constexpr unsigned kDigits = 32;

}  // namespace

SobolPoints::SobolPoints(std::size_t n_dimensions, std::uint64_t seed)
    : n_dimensions_(n_dimensions), seed_(seed), directions_(n_dimensions * kDigits) {
  if (n_dimensions == 0) return;
  if (n_dimensions > kMaxDimensions) throw std::invalid_argument("more dimensions than direction numbers");
  boost::random::sobol_engine<std::uint64_t, 64u> engine(n_dimensions);
  for (unsigned k = 0; k < kDigits; ++k) {
    // Point 2^(k+1) - 1 has the Gray code 2^k: it is the k-th direction number alone. The engine omits the origin.
    engine.seed((std::uint64_t{1} << (k + 1)) - 2);
    for (std::size_t j = 0; j < n_dimensions; ++j)
      directions_[j * kDigits + k] = static_cast<std::uint32_t>(engine() >> 32);
  }
}

std::uint32_t SobolPoints::digits(std::uint64_t point, std::size_t dimension) const {
  const std::uint32_t* direction = directions_.data() + dimension * kDigits;
  std::uint32_t result = 0;
  for (std::uint64_t code = point ^ (point >> 1); code != 0; code >>= 1, ++direction) {
    if (code & 1) result ^= *direction;
  }
  return result;
}

double SobolPoints::share(std::uint64_t point, std::size_t dimension) const {
  if (point >= kMaxPoints || dimension >= n_dimensions_) throw std::out_of_range("no such coordinate of a point");
  return scrambled(digits(point, dimension), hash(seed_, dimension));
}

double scrambled(std::uint32_t digits, std::uint64_t seed) {
  std::uint32_t result = 0;
  for (unsigned k = 0; k < kDigits; ++k) {
    const std::uint64_t before = k == 0 ? 0 : digits >> (kDigits - k);
    const auto flip = static_cast<std::uint32_t>(hash(seed, k, before) >> 63);
    result |= ((digits >> (kDigits - 1 - k) & 1u) ^ flip) << (kDigits - 1 - k);
  }
  const std::uint64_t rest = hash(seed, kDigits, digits) >> 32;
  return share_of(static_cast<std::uint64_t>(result) << 32 | rest);
}

}  // namespace ringfilm::study
