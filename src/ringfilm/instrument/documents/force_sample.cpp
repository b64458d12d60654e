#include "ringfilm/instrument/documents/force_sample.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <limits>

#include "ringfilm/base/error.hpp"
#include "ringfilm/instrument/grid/binary_reader.hpp"
#include "ringfilm/instrument/surface_file.hpp"
#include "ringfilm/io/measurement/force_file.hpp"
#include "ringfilm/io/storage/digest.hpp"

namespace ringfilm::instrument {
namespace {

using surface::LoadUnit;

const char* si_unit(LoadUnit unit) { return unit == LoadUnit::kVolt ? "V" : "N"; }

double quantity(const std::string& option, const std::string& text, const std::string& unit, const std::string& example,
                const io::Units& units) {
  try {
    return units.quantity(text, unit, example);
  } catch (const io::UnitError& problem) {
    throw InputError(option + " \"" + text + "\" " + problem.what(), problem.remedy);
  }
}

double load_deviation(const ForceRule& rule, LoadUnit unit, const io::Units& units) {
  if (!rule.load_deviation) return 0;
  return quantity(rule.load_deviation_word, *rule.load_deviation, si_unit(unit), "0.5 nN", units);
}

/// Reports which sample it is, which the analysis cannot.
[[noreturn]] void refuse_for(const std::string& name, const InputError& refusal) {
  std::vector<Fault> faults = refusal.faults();
  for (Fault& fault : faults) {
    if (fault.mark.file.empty()) fault.message = name + ": " + fault.message;
  }
  throw InputError(std::move(faults));
}

void fit(ForceSample& sample, const ForceRule& rule, const io::Units& units) {
  try {
    if (!sample.loops.empty()) {
      sample.loads =
          surface::friction_of_loads(sample.loops, rule.end_share, load_deviation(rule, sample.load_unit, units));
    } else if (rule.load_deviation) {
      const double deviation = load_deviation(rule, sample.load_unit, units);
      for (surface::LoadFriction& load : sample.loads) load.load_deviation = deviation;
    }
    std::stable_sort(sample.loads.begin(), sample.loads.end(),
                     [](const auto& a, const auto& b) { return a.load < b.load; });
    sample.line = surface::friction_load_line(sample.loads, rule.deviations);
  } catch (const InputError& refusal) {
    refuse_for(sample.name, refusal);
  }
}

/// A file that is given twice would count its scatter as known twice as well.
void add_file(ForceSample& sample, const std::string& digest, const std::string& path) {
  if (std::find(sample.digests.begin(), sample.digests.end(), digest) != sample.digests.end()) {
    refuse(path, "this file is given twice for sample " + sample.name, "name each file once");
  }
  sample.paths.push_back(path);
  sample.digests.push_back(digest);
}

/// Moves the loops and loads of another file into its sample.
void append(ForceSample& sample, io::ForceFile& file, const std::string& path) {
  if (sample.load_unit != file.load_unit) {
    refuse(path, "the loads of sample " + sample.name + " are in volts in one file and in newtons in another",
           "both in volts of the normal signal, or both in newtons");
  }
  if (sample.loops.empty() != file.loops.empty()) {
    refuse(path, "sample " + sample.name + " has loops in one file and their summary in another",
           "give loops alone, or one summary");
  }
  std::move(file.loops.begin(), file.loops.end(), std::back_inserter(sample.loops));
  std::move(file.loads.begin(), file.loads.end(), std::back_inserter(sample.loads));
}

std::string size_text(const io::ForceFile& file) {
  return file.loops.empty() ? fmt::format("summary of {} loads", file.loads.size())
                            : fmt::format("{} friction loops", file.loops.size());
}

std::size_t channel_of(const std::vector<ChannelValues>& all, const std::string& path, const std::string& requested) {
  std::vector<Channel> channels;
  for (const ChannelValues& one : all) channels.push_back(one.channel);
  const ChannelFound found = find_channel(channels, requested);
  if (found.index) return *found.index;
  refuse(path,
         (found.n_named == 0
              ? fmt::format("there is no channel {} among:\n{}", requested, channel_list(channels))
              : fmt::format("{} channels are named {}:\n{}", found.n_named, requested, channel_list(channels))),
         "name the lateral signals of trace and retrace: --channels TRACE,RETRACE");
}

/// A lateral signal in volts; NaN where nothing was measured.
std::vector<double> volts(const ChannelValues& signal, const std::string& path, const ScanChannels& channels,
                          const io::Units& units) {
  const std::string unit = channels.signal_unit.value_or(signal.channel.unit);
  if (unit.empty() || !units.measures(unit, "V")) {
    refuse(path,
           fmt::format("the lateral signal {} is {}", signal.channel.name,
                       unit.empty() ? "without a unit" : "in \"" + unit + "\", which is not a voltage"),
           "choose another channel with --channels, or state the unit: --signal-unit mV");
  }
  const Scale scale = units.scale(unit, "V");
  std::vector<double> values = signal.value;
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = signal.is_missing(i) ? std::numeric_limits<double>::quiet_NaN() : scale.to_si(values[i]);
  }
  return values;
}

double step_of(const ChannelValues& signal, const std::string& path, const ScanChannels& channels,
               const io::Units& units) {
  if (channels.step) return quantity("--step-x", *channels.step, "m", "20 nm", units);
  if (signal.step_x > 0 && !signal.step_unit.empty() && units.measures(signal.step_unit, "m")) {
    return units.scale(signal.step_unit, "m").to_si(signal.step_x);
  }
  refuse(path, "the file does not state the step between its points", "state it, for example --step-x \"20 nm\"");
}

LoadUnit kind_of_load(const std::string& load, const io::Units& units) {
  try {
    units.quantity(load, "V", "0.5 V");
    return LoadUnit::kVolt;
  } catch (const io::UnitError&) {
    quantity("--load", load, "N", "10 nN", units);
    return LoadUnit::kNewton;
  }
}

}  // namespace

std::vector<ForceSample> read_force_samples(const std::vector<std::string>& paths, const ForceRule& rule,
                                            const io::Units& units) {
  std::vector<ForceSample> samples;
  std::vector<Fault> faults;
  for (const std::string& path : paths) {
    try {
      io::ForceFile file = io::read_force({path, path}, units);
      const std::string name = file.sample.empty() ? std::filesystem::path(path).stem().string() : file.sample;
      const std::string source = path + ": " + size_text(file) + ", sample " + name + "; SHA-256 " + file.sha256;
      const std::string digest = file.sha256;
      auto known = std::find_if(samples.begin(), samples.end(), [&](const auto& s) { return s.name == name; });
      if (known == samples.end()) {
        ForceSample sample;
        sample.name = name;
        sample.load_unit = file.load_unit;
        sample.loops = std::move(file.loops);
        sample.loads = std::move(file.loads);
        samples.push_back(std::move(sample));
        known = std::prev(samples.end());
      } else {
        append(*known, file, path);
      }
      known->sources.push_back(source);
      for (const std::string& note : file.notes) {
        if (note.find("# sample:") == std::string::npos) known->sources.push_back(note);
      }
      add_file(*known, digest, path);
    } catch (const InputError& refusal) {
      faults.insert(faults.end(), refusal.faults().begin(), refusal.faults().end());
    }
  }
  if (!faults.empty()) throw InputError(std::move(faults));
  for (ForceSample& sample : samples) fit(sample, rule, units);
  return samples;
}

ForceSample read_force_scans(const std::string& name, const std::vector<std::string>& paths,
                             const std::vector<std::string>& loads, const ScanChannels& channels, const ForceRule& rule,
                             const io::Units& units) {
  if (paths.size() != loads.size()) {
    throw InputError(fmt::format("{}: {} scans, but {} loads", name, paths.size(), loads.size()),
                     "a scan is made at one load: state the load of each, in the order of the files");
  }
  ForceSample sample;
  sample.name = name;
  sample.load_unit = kind_of_load(loads.front(), units);
  for (std::size_t k = 0; k < paths.size(); ++k) {
    const double load = quantity("--load", loads[k], si_unit(sample.load_unit),
                                 sample.load_unit == LoadUnit::kVolt ? "0.5 V" : "10 nN", units);
    const std::vector<ChannelValues> all = read_channels(paths[k]);
    const ChannelValues& trace = all[channel_of(all, paths[k], channels.trace)];
    const ChannelValues& retrace = all[channel_of(all, paths[k], channels.retrace)];
    if (&trace == &retrace) {
      refuse(paths[k], "trace and retrace are one channel", "--channels requires two, for example --channels 3,4");
    }
    if (trace.channel.points_x != retrace.channel.points_x || trace.channel.points_y != retrace.channel.points_y) {
      refuse(paths[k], "trace and retrace are not of one size", "choose the two lateral channels of one scan");
    }
    std::vector<surface::FrictionLoop> loops =
        surface::loops_of_scan(load, trace.channel.points_x, step_of(trace, paths[k], channels, units),
                               volts(trace, paths[k], channels, units), volts(retrace, paths[k], channels, units));
    add_file(sample, io::file_sha256(paths[k]), paths[k]);
    sample.sources.push_back(fmt::format("{}: {} of {} lines at {}, channels {} and {}; SHA-256 {}", paths[k],
                                         loops.size(), trace.channel.points_y, loads[k], trace.channel.name,
                                         retrace.channel.name, sample.digests.back()));
    std::move(loops.begin(), loops.end(), std::back_inserter(sample.loops));
  }
  fit(sample, rule, units);
  return sample;
}

}  // namespace ringfilm::instrument
