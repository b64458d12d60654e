#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "ringfilm/instrument/documents/force_sample.hpp"
#include "ringfilm/io/measurement/measurement.hpp"

namespace ringfilm::instrument {

/// How the lateral signal becomes a coefficient, and what it was found from; common to all samples.
struct ForceCalibration {
  surface::Calibration calibration;
  std::string name;                            ///< for the record: cases that share it are correlated
  std::optional<ForceSample> silicon;          ///< sample of silicon, for CalibrationMethod::kSilicon
  surface::Uncertain silicon_coefficient;      ///< assumed coefficient of friction of silicon
  std::optional<surface::Lever> lever;         ///< data of the lever, for CalibrationMethod::kGeometry
  std::vector<ForceSample> facets;             ///< samples of the two facets, for CalibrationMethod::kWedge
  std::array<surface::Uncertain, 2> angles{};  ///< angles of the facets [rad]
  std::optional<surface::WedgeCalibration> wedge;
  std::vector<std::string> sources;  ///< sources of lever data; those of loops are stored with them
};

/// Throws InputError where the friction on silicon does not rise with load, or the reference is invalid.
ForceCalibration silicon_calibration(ForceSample silicon, surface::Uncertain reference);

/// Throws InputError for samples that have no loops (offsets are required), unlike kinds of load, and what the wedge
/// method refuses.
ForceCalibration wedge_calibration(std::vector<ForceSample> facets, const std::array<surface::Uncertain, 2>& angles_rad,
                                   const ForceRule& rule);

/// Everything that is reported of friction loops: lines, calibration, coefficients with their shares of uncertainty.
/// @param requested the sample whose fragment is made; absent: of a single sample, else none
io::Measurement force_measurement(const std::vector<ForceSample>& samples, const ForceCalibration& calibration,
                                  const ForceRule& rule, const std::optional<std::size_t>& requested);

}  // namespace ringfilm::instrument
