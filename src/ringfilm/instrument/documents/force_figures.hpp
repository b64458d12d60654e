#pragma once
#include <string>
#include <vector>

#include "ringfilm/instrument/documents/force_measurement.hpp"

/// The pictures of friction loops and of friction against load.
namespace ringfilm::instrument {

using SampleList = std::vector<const ForceSample*>;

/// A sample's name as part of a name in a file: letters, digits and "_"; made unlike by its number where need be.
std::vector<std::string> words_of(const SampleList& samples);

/// "V" or "N".
std::string load_unit_of(surface::LoadUnit unit);
/// "V" or "nN".
std::string load_display_of(surface::LoadUnit unit);

/// Loops of a few loads, trace and retrace; empty where there are none.
std::vector<io::MeasuredCurve> loop_curves(const ForceSample& sample, const std::string& word, double end_share);

/// psi TMR against load with the fitted lines, whose slopes are the coefficients, like Fig. 6 of styles2014.
io::MeasuredCurve friction_curve(const SampleList& samples, const std::vector<std::string>& words,
                                 const surface::Calibration& calibration);

}  // namespace ringfilm::instrument
