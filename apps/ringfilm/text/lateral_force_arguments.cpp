#include <CLI/CLI.hpp>

#include "commands/command_lateral_force.hpp"
#include "option_values.hpp"
#include "text/command_arguments.hpp"

namespace ringfilm::app {
namespace {

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

struct LateralForceArguments {
  LateralForceCommand command;
  std::vector<std::string> silicon, silicon_loads, wedge_angles, channels;
  std::optional<std::string> reference;
  std::string end_share = "0.1", deviations = "from-residuals";
  OutputArguments outputs;

  void add_to(CLI::App& app) {
    const auto add = [&app](const char* name, auto& to, const char* help, const char* type) {
      return app.add_option(name, to, help)->type_name(type);
    };
    add("FILE", command.files.paths, "friction loops: text files, or scans with --load and --channels", "...")
        ->required();
    add("--load", command.files.loads, "normal load of each scan, in the order of the files; may be repeated", "LOAD")
        ->allow_extra_args(false);
    add("--channels", channels, "the lateral signals of trace and retrace in a scan: numbers from 1, or names",
        "TRACE RETRACE")
        ->expected(2);
    add("--signal-unit", command.channels.signal_unit, "of these channels, where the file does not state it", "UNIT");
    add("--step-x", command.channels.step, "distance of points of a scan, where the file does not state it", "LENGTH");
    add("--name", command.name, "what the sample of the scans is called", "NAME");
    add("--end-share", end_share, "share of the line that is cut off at each end, where the lever turns over", "0.1")
        ->capture_default_str();
    add("--load-deviation", command.rule.load_deviation, "standard deviation of each load; without it loads are exact",
        "\"0.5 nN\"");
    add("--deviations", deviations,
        "errors of the line: from-residuals (the scatter about it) or stated (deviations as stated or measured)",
        "WORD")
        ->capture_default_str();
    add("--silicon", silicon, "calibrate on these loops on silicon; may be repeated", "FILE")->allow_extra_args(false);
    add("--silicon-load", silicon_loads, "normal load of each scan of silicon; may be repeated", "LOAD")
        ->allow_extra_args(false);
    add("--reference", reference,
        "coefficient of friction of silicon: ahimou2007 (0.19 +- 0.1), warmack1994 (0.18 +- 0.03), or one's own",
        "\"0.19 +- 0.1\"");
    add("--lever", command.lever, "calibrate by the sizes of a rectangular lever", "LEVER.toml");
    add("--wedge", command.wedge, "calibrate on loops on a facet of a grating; twice", "FILE")->allow_extra_args(false);
    add("--wedge-angle", wedge_angles, "angle of each facet to the base; twice", "\"54.7 deg +- 0.5 deg\"")
        ->allow_extra_args(false);
    add("--calibration", command.calibration_name,
        "its name in the record; samples that share it are correlated (default made of the files)", "NAME");
    add("--sample", command.sample, "whose coefficient the fragment has, where there are several", "NAME");
    outputs.add_to(app, true);
    app.footer(kLateralForceFooter);
  }

  LateralForceCommand read() const {
    LateralForceCommand of = command;
    const io::Units units;
    OptionValues values(units);
    of.rule.end_share = values.number("--end-share", end_share, 0, 0.49, "0.1");
    of.rule.deviations = values.chosen<surface::DeviationScale>(
        "--deviations", deviations,
        {{"from-residuals", surface::DeviationScale::kFromResiduals}, {"stated", surface::DeviationScale::kStated}});
    read_scans(of, values);
    const int ways = int{!silicon.empty()} + int{command.lever.has_value()} + int{!command.wedge.empty()};
    if (ways != 1) {
      values.refuse(ways == 0 ? "no calibration is named: a signal in volts is not a friction yet"
                              : "more than one calibration is named",
                    "one of --silicon FILE --reference VALUE, --lever LEVER.toml, --wedge FILE --wedge FILE");
    }
    read_silicon(of, values);
    read_wedge(of, values);
    values.check();
    of.outputs = outputs.selected();
    return of;
  }

 private:
  void read_scans(LateralForceCommand& of, OptionValues& values) const {
    const bool scans = !of.files.loads.empty() || !silicon_loads.empty();
    if (scans && channels.size() != 2) {
      values.refuse("a load is stated for a scan, but not which channels are trace and retrace",
                    "for example --channels 3 4");
    }
    if (!scans && !channels.empty()) {
      values.refuse("--channels are of scans, and a scan is made at one load that the file does not contain",
                    "state the load of each file: --load \"10 nN\" --load \"20 nN\"");
    }
    if (of.name && of.files.loads.empty()) {
      values.refuse("--name is for scans", "a text file names its sample in a line \"# sample: NAME\"");
    }
    if (channels.size() == 2) {
      of.channels.trace = channels[0];
      of.channels.retrace = channels[1];
    }
  }

  void read_silicon(LateralForceCommand& of, OptionValues& values) const {
    if (!silicon.empty()) of.silicon = ForceFiles{silicon, silicon_loads};
    if (silicon.empty()) {
      if (reference || !silicon_loads.empty()) {
        values.refuse("--reference and --silicon-load go with --silicon", "add --silicon FILE, or leave them out");
      }
      return;
    }
    if (!reference) {
      values.refuse("--silicon without --reference: the coefficient of friction of silicon is not one number",
                    "ahimou2007 (0.19 +- 0.1), warmack1994 (0.18 +- 0.03), or for example \"0.19 +- 0.05\"");
      return;
    }
    of.reference = *reference == "ahimou2007"    ? surface::kSiliconAhimou
                   : *reference == "warmack1994" ? surface::kSiliconWarmack
                                                 : values.uncertain("--reference", *reference, "1", "0.19 +- 0.1");
  }

  void read_wedge(LateralForceCommand& of, OptionValues& values) const {
    if (command.wedge.empty() && wedge_angles.empty()) return;
    if (command.wedge.size() != 2 || wedge_angles.size() != 2) {
      values.refuse("the wedge method requires two facets, each with its angle",
                    "--wedge up.csv --wedge flat.csv --wedge-angle \"54.7 deg\" --wedge-angle \"0 deg\"");
      return;
    }
    constexpr double kDegree = 3.14159265358979323846 / 180;
    for (std::size_t k = 0; k < 2; ++k) {
      const surface::Uncertain angle = values.uncertain("--wedge-angle", wedge_angles[k], "degree", "54.7 deg");
      of.wedge_angles_rad[k] = {angle.value * kDegree, angle.deviation * kDegree};
    }
  }
};

}  // namespace

void add_lateral_force_command(CLI::App& program, Actions& actions) {
  CLI::App* command =
      program.add_subcommand("lateral-force", "Friction loops of an AFM: coefficient of boundary shear strength");
  const auto arguments = std::make_shared<LateralForceArguments>();
  arguments->add_to(*command);
  actions.emplace_back(command, [arguments] { lateral_force(arguments->read()); });
}

}  // namespace ringfilm::app
