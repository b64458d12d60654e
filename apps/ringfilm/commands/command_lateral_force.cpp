#include "commands/command_lateral_force.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <numbers>

#include "ringfilm/base/error.hpp"
#include "ringfilm/instrument/documents/force_measurement.hpp"
#include "ringfilm/io/measurement/lever_file.hpp"
#include "text/shared_options.hpp"

namespace ringfilm::app {
namespace {

using instrument::ForceCalibration;
using instrument::ForceSample;

std::vector<std::string> inputs_of(const LateralForceCommand& command) {
  std::vector<std::string> inputs = command.files.paths;
  if (command.silicon) inputs.insert(inputs.end(), command.silicon->paths.begin(), command.silicon->paths.end());
  inputs.insert(inputs.end(), command.wedge.begin(), command.wedge.end());
  if (command.lever) inputs.push_back(*command.lever);
  return inputs;
}

std::string stem_of(const std::string& path) { return std::filesystem::path(path).stem().string(); }

std::vector<ForceSample> read_samples(const LateralForceCommand& command, const io::Units& units) {
  const ForceFiles& files = command.files;
  if (files.loads.empty()) return instrument::read_force_samples(files.paths, command.rule, units);
  std::vector<ForceSample> samples;
  samples.push_back(instrument::read_force_scans(command.name.value_or(stem_of(files.paths.front())), files.paths,
                                                 files.loads, command.channels, command.rule, units));
  return samples;
}

ForceSample read_silicon(const LateralForceCommand& command, const io::Units& units) {
  const ForceFiles& files = *command.silicon;
  if (!files.loads.empty()) {
    return instrument::read_force_scans("silicon", files.paths, files.loads, command.channels, command.rule, units);
  }
  std::vector<ForceSample> silicon = instrument::read_force_samples(files.paths, command.rule, units);
  if (silicon.size() > 1) {
    throw InputError(fmt::format("the files of --silicon hold {} samples: {} and {}", silicon.size(), silicon[0].name,
                                 silicon[1].name),
                     "files of one sample have the same line \"# sample: NAME\" before the header");
  }
  return std::move(silicon.front());
}

/// A few digits of what was read, so that another calibration has another name.
std::string short_digest(const std::vector<std::string>& digests) {
  constexpr std::size_t kDigits = 8;
  std::string text;
  for (const std::string& digest : digests) {
    if (!text.empty()) text += "+";
    text += digest.substr(0, kDigits);
  }
  return text;
}

std::string file_name(const std::string& path) { return std::filesystem::path(path).filename().string(); }

ForceCalibration on_silicon(const LateralForceCommand& command, const io::Units& units) {
  ForceCalibration of = silicon_calibration(read_silicon(command, units), command.reference);
  of.name = fmt::format("silicon {:.6g} +- {:.3g}, {} ({})", command.reference.value, command.reference.deviation,
                        file_name(command.silicon->paths.front()), short_digest(of.silicon->digests));
  return of;
}

ForceCalibration by_lever(const LateralForceCommand& command, surface::LoadUnit load_unit, const io::Units& units) {
  const io::LeverFile file = io::read_lever({*command.lever, *command.lever}, load_unit, units);
  ForceCalibration of;
  of.calibration = surface::calibrate_by_geometry(file.lever, load_unit);
  of.lever = file.lever;
  of.sources = {*command.lever + ": sizes of a lever; SHA-256 " + file.sha256};
  of.name = fmt::format("lever {} ({})", file_name(*command.lever), short_digest({file.sha256}));
  return of;
}

ForceCalibration on_wedge(const LateralForceCommand& command, const io::Units& units) {
  ForceCalibration of = wedge_calibration(instrument::read_force_samples(command.wedge, command.rule, units),
                                          command.wedge_angles_rad, command.rule);
  of.name = fmt::format("wedge {}, {} ({}, {})", file_name(command.wedge[0]), file_name(command.wedge[1]),
                        short_digest(of.facets[0].digests), short_digest(of.facets[1].digests));
  return of;
}

std::optional<std::size_t> requested_sample(const LateralForceCommand& command,
                                            const std::vector<ForceSample>& samples) {
  std::string names;
  for (const ForceSample& sample : samples) names += (names.empty() ? "" : ", ") + sample.name;
  if (command.sample) {
    for (std::size_t i = 0; i < samples.size(); ++i) {
      if (samples[i].name == *command.sample) return i;
    }
    throw InputError("--sample " + *command.sample + ": there is no such sample", "one of: " + names);
  }
  if (command.outputs.fragment && samples.size() > 1) {
    throw InputError(fmt::format("--fragment: a case takes one coefficient, and there are {} samples", samples.size()),
                     "state which: --sample NAME, one of: " + names);
  }
  return std::nullopt;
}

constexpr const char* kLateralForceFooter = R"(Examples:
  ringfilm lateral-force new.csv --silicon silicon.csv --reference ahimou2007
  ringfilm lateral-force new.csv worn.csv --silicon silicon.csv --reference "0.18 +- 0.03" --html friction.html
  ringfilm lateral-force new.csv worn.csv --silicon silicon.csv --reference warmack1994 --sample new --fragment new.toml
  ringfilm lateral-force new.csv --lever lever.toml
  ringfilm lateral-force new.csv --wedge up.csv --wedge down.csv --wedge-angle "54.7 deg" --wedge-angle "-54.7 deg"
  ringfilm lateral-force a.001 a.002 a.003 --load "10 nN" --load "20 nN" --load "30 nN" --channels 3 4 --name new \
      --silicon silicon.csv --reference ahimou2007

Loops as text: a line "# sample: NAME", then load [nN],position [um],trace [mV],retrace [mV], and loop, its number; or
their summary: load [nN],tmr [mV]. Loads in nN or in V of the normal signal, in samples and calibration alike.
V-shaped levers are calibrated on silicon or on a wedge; --lever holds for rectangular ones (eqs A-1 to A-9):
  shape = "rectangular"            length = "450 um +- 5 um"     tip_height = "17 um +- 1 um"
  poissons_ratio = "0.27 +- 0.02"  sensitivity_ratio = "1 +- 0.05"
and for loads in newtons also youngs_modulus, width, thickness, torsional_sensitivity = "0.05 V/nm +- 5 %".
)";

/// The command with what is checked before it becomes part of it.
struct LateralForceRequest : LateralForceCommand {
  ForceFiles silicon_files;
  std::vector<std::string> named_channels;
  std::vector<surface::Uncertain> angles_rad;
};

void check_scans(LateralForceRequest& request, Faults& faults) {
  const std::vector<std::string>& channels = request.named_channels;
  const bool has_scans = !request.files.loads.empty() || !request.silicon_files.loads.empty();
  if (has_scans && channels.empty()) {
    faults.refuse("a load is stated for a scan, but not which channels are trace and retrace",
                  "for example --channels 3 4");
  }
  if (!has_scans && !channels.empty()) {
    faults.refuse("--channels are of scans, and a scan is made at one load that the file does not contain",
                  "state the load of each file: --load \"10 nN\" --load \"20 nN\"");
  }
  if (request.name && request.files.loads.empty()) {
    faults.refuse("--name is for scans", "a text file names its sample in a line \"# sample: NAME\"");
  }
  if (channels.empty()) return;
  request.channels.trace = channels.front();
  request.channels.retrace = channels.back();
}

void check_calibration(const LateralForceRequest& request, Faults& faults) {
  const int ways =
      int{!request.silicon_files.paths.empty()} + int{request.lever.has_value()} + int{!request.wedge.empty()};
  if (ways == 1) return;
  faults.refuse(ways == 0 ? "no calibration is named: a signal in volts is not a friction yet"
                          : "more than one calibration is named",
                "one of --silicon FILE --reference VALUE, --lever LEVER.toml, --wedge FILE --wedge FILE");
}

void check_silicon(LateralForceRequest& request, const CLI::Option* reference, Faults& faults) {
  if (!request.silicon_files.paths.empty()) {
    request.silicon = request.silicon_files;
    if (is_stated(reference)) return;
    faults.refuse("--silicon without --reference: the coefficient of friction of silicon is not one number",
                  "ahimou2007 (0.19 +- 0.1), warmack1994 (0.18 +- 0.03), or for example \"0.19 +- 0.05\"");
  } else if (is_stated(reference) || !request.silicon_files.loads.empty()) {
    faults.refuse("--reference and --silicon-load go with --silicon", "add --silicon FILE, or leave them out");
  }
}

void check_wedge(LateralForceRequest& request, const CLI::Option* angle, Faults& faults) {
  if (request.wedge.empty() && !is_stated(angle)) return;
  if (request.wedge.size() != 2 || angle->count() != 2) {
    faults.refuse("the wedge method requires two facets, each with its angle",
                  "--wedge up.csv --wedge flat.csv --wedge-angle \"54.7 deg\" --wedge-angle \"0 deg\"");
  } else if (request.angles_rad.size() == 2) {
    request.wedge_angles_rad = {request.angles_rad.front(), request.angles_rad.back()};
  }
}

void declare_lateral_force(CommandOptions& add, LateralForceRequest& request) {
  using surface::DeviationScale;
  add.text("FILE", request.files.paths, "...", "friction loops: text files, or scans with --load and --channels")
      ->required();
  add.texts("--load", request.files.loads, "LOAD",
            "normal load of each scan, in the order of the files; may be repeated");
  add.text("--channels", request.named_channels, "TRACE RETRACE",
           "the lateral signals of trace and retrace in a scan: numbers from 1, or names")
      ->expected(2);
  add.text("--signal-unit", request.channels.signal_unit, "UNIT",
           "of these channels, where the file does not state it");
  add.text("--step-x", request.channels.step, "LENGTH",
           "distance of points of a scan, where the file does not state it");
  add.text("--name", request.name, "NAME", "what the sample of the scans is called");
  add.number("--end-share", request.rule.end_share, 0, 0.49, "0.1", "0.1",
             "share of the line that is cut off at each end, where the lever turns over")
      ->capture_default_str();
  add.text("--load-deviation", request.rule.load_deviation, "\"0.5 nN\"",
           "standard deviation of each load; without it loads are exact");
  add.choice("--deviations", request.rule.deviations,
             {{"from-residuals", DeviationScale::kFromResiduals}, {"stated", DeviationScale::kStated}},
             "errors of the line: from-residuals (the scatter about it) or stated (deviations as stated or measured)")
      ->capture_default_str();
  add.texts("--silicon", request.silicon_files.paths, "FILE", "calibrate on these loops on silicon; may be repeated");
  add.texts("--silicon-load", request.silicon_files.loads, "LOAD",
            "normal load of each scan of silicon; may be repeated");
  const CLI::Option* reference = add.read(
      "--reference", "\"0.19 +- 0.1\"",
      "coefficient of friction of silicon: ahimou2007 (0.19 +- 0.1), warmack1994 (0.18 +- 0.03), or one's own",
      [&](const std::string& text) {
        request.reference = text == "ahimou2007"    ? surface::kSiliconAhimou
                            : text == "warmack1994" ? surface::kSiliconWarmack
                                                    : add.uncertain_of("--reference", text, "1", "0.19 +- 0.1");
      });
  add.text("--lever", request.lever, "LEVER.toml", "calibrate by the sizes of a rectangular lever");
  add.texts("--wedge", request.wedge, "FILE", "calibrate on loops on a facet of a grating; twice");
  const CLI::Option* angle =
      add.read_each("--wedge-angle", "\"54.7 deg +- 0.5 deg\"", "angle of each facet to the base; twice",
                    [&](const std::string& text) {
                      constexpr double kOneDegree = std::numbers::pi / 180;  // [rad]
                      const surface::Uncertain one = add.uncertain_of("--wedge-angle", text, "degree", "54.7 deg");
                      request.angles_rad.push_back({one.value * kOneDegree, one.deviation * kOneDegree});
                    });
  add.text("--calibration", request.calibration_name, "NAME",
           "its name in the record; samples that share it are correlated (default made of the files)");
  add.text("--sample", request.sample, "NAME", "whose coefficient the fragment has, where there are several");
  add_outputs(add, request.outputs, true);

  add.rule([=, &request](Faults& faults) {
    check_scans(request, faults);
    check_calibration(request, faults);
    check_silicon(request, reference, faults);
    check_wedge(request, angle, faults);
  });
}

}  // namespace

void lateral_force(const LateralForceCommand& command) {
  const auto claimed = claimed_outputs(command.outputs, inputs_of(command));
  const io::Units units;
  const std::vector<ForceSample> samples = read_samples(command, units);
  const std::optional<std::size_t> requested = requested_sample(command, samples);
  ForceCalibration calibration = command.silicon ? on_silicon(command, units)
                                 : command.lever ? by_lever(command, samples.front().load_unit, units)
                                                 : on_wedge(command, units);
  if (command.calibration_name) calibration.name = *command.calibration_name;
  const io::Measurement measurement = force_measurement(samples, calibration, command.rule, requested);
  deliver(measurement, command.outputs);
}

void add_lateral_force_command(Program& program) {
  program.add("lateral-force", "Friction loops of an AFM: coefficient of boundary shear strength", kLateralForceFooter,
              declare_lateral_force, lateral_force);
}

}  // namespace ringfilm::app
