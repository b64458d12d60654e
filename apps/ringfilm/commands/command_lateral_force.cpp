#include "commands/command_lateral_force.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "ringfilm/base/error.hpp"
#include "ringfilm/instrument/documents/force_measurement.hpp"
#include "ringfilm/io/measurement/lever_file.hpp"

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
  deliver(measurement, command.outputs, numbers_of(measurement));
}

}  // namespace ringfilm::app
