#pragma once
#include <cstddef>
#include <vector>

#include "ringfilm/cycle/result/result.hpp"
#include "ringfilm/io/study/study_result.hpp"
#include "ringfilm/study/design/kept_curves.hpp"

/// Statistics of the curves of all scenarios.
namespace ringfilm::io {

/// The axis of the curves that a study keeps, from -360 to below 360 [degree].
using study::kept_angles;

/// How one quantity scatters over the scenarios of one base.
struct CurveBand {
  std::size_t base = 0;
  std::size_t curve = 0;  ///< index in study::kept_curves()
  cycle::Quantity quantity;
  std::vector<double> shares;               ///< shares of the quantiles, increasing [-]
  std::vector<std::vector<double>> values;  ///< [share][angle of kept_angles()] [SI]; NaN where nothing was solved
};

/// Shares of the quantiles that are reported of curves.
const std::vector<double>& band_shares();

/// Quantiles over the scenarios of each base, base after base, of each curve that is kept; of a sample (see
/// Plan::is_sample), or of all points where the plan is not a sample. Scenarios that were not solved are omitted. Empty
/// where no curves are kept. Each angle has its own quantiles: a band is not a curve of any scenario. Curves are read a
/// block of angles at a time: at most 128 MB of them or one angle, and 12 bytes for each scenario beside.
std::vector<CurveBand> curve_bands(const StudyRows& rows);

}  // namespace ringfilm::io
