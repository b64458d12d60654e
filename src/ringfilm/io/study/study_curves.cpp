#include "ringfilm/io/study/study_curves.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ringfilm/study/statistics/statistics.hpp"

namespace ringfilm::io {
namespace {

/// Size of the curves that are read at once [byte].
constexpr std::size_t kBytesAtATime = std::size_t{1} << 27;

/// Quantiles of numbers whose order is of no more use. @param shares increasing
std::vector<double> quantiles_of(std::vector<float>& numbers, const std::vector<double>& shares) {
  std::vector<double> quantiles(shares.size(), std::numeric_limits<double>::quiet_NaN());
  if (numbers.empty()) return quantiles;
  auto begin = numbers.begin();  // all before are no greater than all from here
  for (std::size_t s = 0; s < shares.size(); ++s) {
    const double place = study::quantile_place(numbers.size(), shares[s]);
    const auto before = numbers.begin() + static_cast<std::ptrdiff_t>(place);
    if (before >= begin) std::nth_element(begin, before, numbers.end());
    begin = std::max(begin, before);
    const double low = *before, rest = place - std::floor(place);
    quantiles[s] = rest > 0 ? low + rest * (*std::min_element(before + 1, numbers.end()) - low) : low;
  }
  return quantiles;
}

class BandReader {
 public:
  explicit BandReader(const StudyRows& rows)
      : rows_(rows),
        keep_(rows.plan.study().keep),
        n_angles_(kept_angles(keep_).size()),
        samples_(rows.plan.study().bases.size()) {
    const bool is_sample = rows.plan.is_sample(0);
    for (std::size_t base = 0; base < samples_.size(); ++base) {
      for (std::uint64_t p = 0; p < rows.plan.n_points(base); ++p) {
        if (!is_sample || rows.plan.is_sample(p)) samples_[base].push_back(rows.plan.scenario(base, p));
      }
    }
  }

  std::vector<CurveBand> bands() {
    const std::vector<study::KeptCurve> kept = study::kept_curves(rows_.plan.study());
    const std::size_t n_bases = rows_.plan.study().bases.size(), n_shares = band_shares().size();
    std::vector<CurveBand> bands;
    for (std::size_t base = 0; base < n_bases; ++base) {
      for (std::size_t curve = 0; curve < kept.size(); ++curve) {
        bands.push_back({base, curve, kept[curve].quantity, band_shares(),
                         std::vector<std::vector<double>>(n_shares, std::vector<double>(n_angles_))});
      }
    }
    const std::uint64_t n = rows_.plan.size();
    const std::size_t at_once = std::clamp<std::size_t>(kBytesAtATime / sizeof(float) / std::max<std::uint64_t>(n, 1),
                                                        1, std::max<std::size_t>(n_angles_, 1));
    for (std::size_t q = 0; q < kept.size(); ++q) {
      for (std::size_t first = 0; first < n_angles_; first += at_once) {
        const std::size_t n_now = std::min(at_once, n_angles_ - first);
        const std::vector<float> block = rows_.curve(q, first, n_now, {0, n});
        for (std::size_t base = 0; base < n_bases; ++base) {
          for (std::size_t k = 0; k < n_now; ++k) put(block.data() + k * n, first + k, bands[base * kept.size() + q]);
        }
      }
    }
    return bands;
  }

 private:
  /// @param numbers numbers of all scenarios at one angle
  void put(const float* numbers, std::size_t angle, CurveBand& band) {
    of_base_.clear();
    for (const std::uint64_t i : samples_[band.base]) {
      if (std::isfinite(numbers[i])) of_base_.push_back(numbers[i]);
    }
    const std::vector<double> quantiles = quantiles_of(of_base_, band.shares);
    for (std::size_t s = 0; s < quantiles.size(); ++s) band.values[s][angle] = quantiles[s];
  }

  const StudyRows& rows_;
  const study::OutputSelection& keep_;
  std::size_t n_angles_;
  std::vector<std::vector<std::uint64_t>> samples_;  ///< scenarios of each base from which quantiles are taken
  std::vector<float> of_base_;
};

}  // namespace

const std::vector<double>& band_shares() {
  static const std::vector<double> shares = {0.05, 0.25, 0.5, 0.75, 0.95};
  return shares;
}

std::vector<CurveBand> curve_bands(const StudyRows& rows) {
  if (rows.plan.study().keep.curves == study::Curves::kNone) return {};
  return BandReader(rows).bands();
}

}  // namespace ringfilm::io
