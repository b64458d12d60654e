#pragma once
#include <optional>
#include <string>
#include <vector>

#include "ringfilm/io/text/units.hpp"
#include "ringfilm/surface/friction_loop/lateral_force.hpp"

/// Friction loops of samples, from text files or from scans of a lateral force microscope.
namespace ringfilm::instrument {

/// How loops become a friction-load line.
struct ForceRule {
  double end_share = 0.1;  ///< share of the scan length that is cut off at each end [-]
  surface::DeviationScale deviations = surface::DeviationScale::kFromResiduals;
  std::optional<std::string> load_deviation;             ///< standard deviation of each load, e.g. "0.5 nN"
  std::string load_deviation_word = "--load-deviation";  ///< what errors call it: the option, or a function's argument
};

/// Which channels of a scan are the lateral signals, and what the file does not state.
struct ScanChannels {
  std::string trace, retrace;              ///< number counted from 1, or name
  std::optional<std::string> step;         ///< step of the points along a line, e.g. "20 nm"
  std::optional<std::string> signal_unit;  ///< unit of the lateral signals, e.g. "mV"
};

/// One sample: its loops, the friction signal of each load and the line through them.
struct ForceSample {
  std::string name;
  std::vector<std::string> sources;  ///< a line for each file
  std::vector<std::string> paths;    ///< each file as the user named it
  std::vector<std::string> digests;  ///< SHA-256 of each file
  surface::LoadUnit load_unit{};
  std::vector<surface::FrictionLoop> loops;  ///< empty where a file has the summary alone
  std::vector<surface::LoadFriction> loads;  ///< rising
  surface::LineFit line;
};

/// Samples of CSV files; files that name the same sample are taken together, others are called like their file. Throws
/// InputError with the faults of the files, loads of unlike kinds, and what the analysis refuses.
std::vector<ForceSample> read_force_samples(const std::vector<std::string>& paths, const ForceRule& rule,
                                            const io::Units& units);

/// One sample of scans, each at the load that is at its place in `loads` ("10 nN", "0.5 V"); one loop a line.
ForceSample read_force_scans(const std::string& name, const std::vector<std::string>& paths,
                             const std::vector<std::string>& loads, const ScanChannels& channels, const ForceRule& rule,
                             const io::Units& units);

}  // namespace ringfilm::instrument
