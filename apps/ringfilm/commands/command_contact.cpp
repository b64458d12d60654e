#include <algorithm>
#include <optional>

#include "commands/commands.hpp"
#include "measurement_outputs.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/instrument/documents/contact_measurement.hpp"
#include "ringfilm/instrument/documents/contact_of_case.hpp"
#include "ringfilm/io/measurement/contact_law_file.hpp"
#include "ringfilm/io/text/units.hpp"
#include "text/shared_options.hpp"

namespace ringfilm::app {
namespace {

/// What `contact` was asked for.
struct ContactCommand {
  /// Case whose law is tabulated instead of that of maps.
  std::optional<std::string> case_path;
  std::vector<io::Override> settings;                             ///< overrides of keys of the case
  std::vector<double> lambda = {0.5, 1, 1.5, 2, 2.5, 3, 3.5, 4};  ///< lambda ratios at which the law is tabulated
  std::vector<std::string> surfaces;                              ///< one file, or two: ring and liner
  instrument::SurfaceOptions reading;
  instrument::ContactAnalysis analysis;
  MeasurementOutputs outputs;
};

void deliver_law(const io::Measurement& measurement, const MeasurementOutputs& outputs) {
  deliver(measurement, outputs, {{}, lists_of(measurement, io::kContactLawTable), {}});
}

/// A file is for a case to read; what is only shown has a note.
void check_law(io::Measurement& measurement, const MeasurementOutputs& outputs) {
  try {
    io::check_contact_law(measurement);
  } catch (const InputError& refusal) {
    if (outputs.netcdf) throw;
    const Fault& fault = refusal.faults().front();
    measurement.notes.push_back(fault.message + "; " + fault.remedy);
  }
}

/// Computes the contact law of a measured pair, or that of a case, and writes what was asked for.
void contact(const ContactCommand& command) {
  if (command.case_path) {
    const auto claimed = claimed_outputs(command.outputs, {*command.case_path});
    const cycle::Case input = case_with_settings(*command.case_path, command.settings);
    return deliver_law(instrument::contact_of_case(input, command.lambda), command.outputs);
  }
  const auto claimed = claimed_outputs(command.outputs, command.surfaces);
  const io::Units units;
  const auto first = instrument::read_surface_file(command.surfaces.front(), command.reading, units);
  std::optional<instrument::SurfaceFile> second;
  if (command.surfaces.size() > 1) second = read_surface_file(command.surfaces.back(), command.reading, units);
  io::Measurement measurement = contact_measurement(first, second ? &*second : nullptr, command.analysis);
  check_law(measurement, command.outputs);
  deliver_law(measurement, command.outputs);
}

constexpr const char* kContactFooter = R"(Examples:
  ringfilm contact --surface ring.x3p --surface liner.x3p --composite-modulus "134.8 GPa" --hardness "2.5 GPa" -o law.nc
  ringfilm contact --surface ring.x3p --surface liner.x3p --composite-modulus "134.8 GPa" --shifts 8 --html law.html
  ringfilm contact --surface wave.csv --unit um --step-x "0.5 um" --composite-modulus "134.8 GPa" --periodic \
      --separations "0.32 um, 0.27 um" --json

  ringfilm contact --case new.toml --lambda 1,1.286,2,3
  ringfilm contact --case new.toml --set contact.model=greenwood-williamson --set contact.summit_plane=nayak --json

The separation is the distance of the mean planes of the undeformed, levelled maps. One surface meets a smooth flat.
E' = 2 E*, with 1/E* = sum (1 - nu^2)/E. Without --hardness contact is elastic. Nothing is filtered without a cut-off.
)";

void read_lambda(CommandOptions& add, const std::string& list, std::vector<double>& lambda) {
  constexpr double kMax = 100;
  lambda.clear();
  for (const std::string& word : comma_separated(list)) {
    add.collect([&] { lambda.push_back(add.number_of("--lambda", word, 0, kMax, "1,1.286,2,3")); });
  }
}

void read_separations(CommandOptions& add, const std::string& list, std::vector<double>& separations_m) {
  for (const std::string& word : comma_separated(list)) {
    add.collect([&] {
      const double one = add.length_of("--separations", word, "0.32 um, 0.27 um");
      if (std::find(separations_m.begin(), separations_m.end(), one) != separations_m.end()) {
        throw InputError("--separations has " + word + " twice", "state each separation once");
      }
      separations_m.push_back(one);
    });
  }
}

void declare_contact(CommandOptions& add, ContactCommand& command) {
  using surface::FormKind, surface::MapEdges;
  instrument::ContactAnalysis& analysis = command.analysis;
  const CLI::Option* surfaces = add.text("--surface", command.surfaces, "FILE",
                                         "map of the ring's face, then that of the liner; one: against a flat");
  add.text("--case", command.case_path, "CASE.toml", "tabulate the law that a case uses, instead of that of maps");
  const CLI::Option* lambda =
      add.read("--lambda", "N,...", "lambda ratios of --case, separated by commas (default 0.5 to 4)",
               [&add, &command](const std::string& list) { read_lambda(add, list, command.lambda); });
  const CLI::Option* settings = add_settings(add, command.settings);
  const CLI::Option* modulus =
      add.pressure("--composite-modulus", analysis.material.E_star, "134.8 GPa", "E' of 2/E' = sum (1 - nu^2)/E");
  const CLI::Option* hardness = add.pressure("--hardness", analysis.material.hardness, "2.5 GPa",
                                             "of the softer face; without it contact is elastic");
  const CLI::Option* separations =
      add.read("--separations", "\"LENGTH, ...\"",
               "distances of the mean planes, separated by commas; without it evenly from the highest point down",
               [&add, &analysis](const std::string& list) { read_separations(add, list, analysis.separations_m); });
  const CLI::Option* periodic = add.flag("--periodic", analysis.edges, MapEdges::periodic,
                                         "the maps repeat; only their mean is removed unless --form states more");
  const CLI::Option* mirrored =
      add.flag("--mirrored", analysis.edges, MapEdges::mirrored, "the maps continue by their mirror images (default)");
  const CLI::Option* shifts = add.count("--shifts", analysis.shifts, 1000, "a count", "for example --shifts 8",
                                        "relative positions of both maps over which the law is the mean (default 1)");
  const CLI::Option* grid =
      add.counts("--grid", analysis.regions_across, analysis.regions_down, "2x2",
                 "equal regions across and down whose laws scatter, from the mean plane of the whole");
  const CLI::Option* flow = add.flag("--flow-factors", analysis.has_flow,
                                     "pressure and shear flow factors of the true gap, beyond contact, too");
  const CLI::Option* form = add_map_options(add, command.reading, analysis.preparation, "tilt; with --periodic mean");
  add_outputs(add, command.outputs, false);

  add.rule([=, &command, &analysis](Faults& faults) {
    if (command.case_path) {
      if (is_any_stated({surfaces, modulus, hardness, separations, shifts, grid, periodic, mirrored, flow})) {
        faults.refuse("--case has its own surfaces: --surface and its options do not belong to it",
                      "set keys of the case with --set, for example --set contact.hardness='2.5 GPa'");
      }
      return;
    }
    if (!is_stated(surfaces)) {
      faults.refuse("there is nothing to compute", "name maps with --surface, or a case with --case");
    }
    if (is_any_stated({lambda, settings})) {
      faults.refuse("--lambda and --set belong to --case", "name one with --case");
    }
    if (command.surfaces.size() > 2) {
      faults.refuse("--surface is given more than twice", "name the ring's map, then the liner's");
    }
    if (is_stated(periodic) && is_stated(mirrored)) {
      faults.refuse("--periodic and --mirrored contradict each other", "state one of them");
    }
    if (!is_stated(form)) {
      analysis.preparation.form = {analysis.edges == MapEdges::periodic ? FormKind::mean : FormKind::tilt};
    }
    if (!is_stated(modulus)) {
      faults.refuse("--composite-modulus is missing", "for example --composite-modulus \"134.8 GPa\"");
    }
    analysis.material.E_star /= 2;  // it was E'
    if (command.surfaces.size() < 2 && analysis.shifts > 1) {
      faults.refuse("--shifts moves two maps over each other, and there is one", "name two with --surface");
    }
  });
}

}  // namespace

void add_contact_command(Program& program) {
  program.add("contact", "Contact law of a measured pair: pressure, real area and gap against the separation",
              kContactFooter, declare_contact, contact);
}

}  // namespace ringfilm::app
