#include "commands/command_line.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <set>

#include "commands/commands.hpp"
#include "exit_codes.hpp"
#include "gas_path/command_gas.hpp"
#include "option_values.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/base/trimmed.hpp"
#include "ringfilm/io/result/result_file.hpp"
#include "ringfilm/io/text/suggestion.hpp"
#include "text/command_arguments.hpp"

namespace ringfilm::app {
namespace {

constexpr const char* kProgramFooter = R"(Examples:
  ringfilm new my_engine.toml
  ringfilm check my_engine.toml
  ringfilm run my_engine.toml --output my_engine.nc
  ringfilm run my_engine.toml --set operating.speed='3000 rpm' --json
  ringfilm gas cases/ring-pack/two_rings.toml --json
  ringfilm report my_engine.nc --output my_engine.html
  ringfilm reproduce styles2014
  ringfilm verify
  ringfilm surface liner.x3p --form cylinder --html liner.html
  ringfilm pair --ring ring.x3p --liner liner.x3p --form tilt --fragment contact.toml
  ringfilm contact --surface ring.x3p --surface liner.x3p --composite-modulus "134.8 GPa" --hardness "2.5 GPa" -o law.nc
  ringfilm conform cases/distorted-bore/followed.toml --html conform.html
  ringfilm face trace.csv --heights material --width "1.2 mm" --fragment face.toml
  ringfilm lateral-force new.csv --silicon silicon.csv --reference ahimou2007 --fragment shear.toml
  ringfilm synthetic honed liner.x3p --hatch-angle "45 degree" --seed 7
  ringfilm reproduce measured
  ringfilm study cases/studies/new_ring_uncertainty.toml -o uncertainty

Exit codes: 0 done, 1 internal error, 2 bad input, 3 no balance found, 4 a check failed, 5 could not write.
)";

constexpr const char* kRunFooter = R"(Examples:
  ringfilm run case.toml
  ringfilm run case.toml --output result.nc --csv curves.csv
  ringfilm run case.toml --set operating.speed='3000 rpm' --set solver.cells=400 --json
  ringfilm run case.toml --ledger --output result.nc
  ringfilm run case.toml --error-estimate --jobs 4
  ringfilm run verification/rayleigh1918_step/best.toml

A case with a table [pad] instead of [engine] and [ring] is the film of a slider, a step or two plates that approach
each other, steady or in time; --ledger and --error-estimate are for rings.

--set KEY= takes a key out of the case. A key of the case that --set makes unused is dropped, with a line on standard
error: --set ring.tangential_force='12.5 N' takes the place of ring.elastic_pressure.
An output that exists is replaced at once when the new one is complete; a kill or a full disk leaves the old one.
A study that exists is replaced with --overwrite only.
)";

constexpr const char* kGasFooter = R"(Examples:
  ringfilm gas cases/ring-pack/two_rings.toml
  ringfilm gas cases/ring-pack/two_rings.toml --set gas_path.ring_motion=axial --json
  ringfilm gas case.toml --set operating.speed='4500 rpm' --csv gas.csv
  ringfilm gas case.toml --vary operating.speed='1000 rpm, 3000 rpm' --vary ring.1.end_gap='0.25 mm, 0.5 mm'

The gas alone is computed: keys of oil, contact and film may be missing.
)";

constexpr const char* kCheckFooter = R"(Examples:
  ringfilm check case.toml
  ringfilm check case.toml --set operating.speed='3000 rpm'
  ringfilm check case.toml --json

Default inputs are keys that the case does not state; modelling assumptions are what the models take for granted.
)";

constexpr const char* kOilsFooter = R"(Examples:
  ringfilm oils
  ringfilm run case.toml --set lubricant.grade='SAE 10W-40'
)";

constexpr const char* kPairsFooter = R"(Examples:
  ringfilm pairs
  ringfilm run case.toml --set contact.friction_pair=crn-on-grey-iron --set contact.boundary_shear_strength_coefficient=
)";

constexpr const char* kFieldsFooter = R"(Examples:
  ringfilm fields
  ringfilm fields ring
  ringfilm fields ring.face clearance
)";

constexpr const char* kNewFooter = R"(Examples:
  ringfilm new my_engine.toml
  ringfilm new truck.toml --engine heavy-duty
  ringfilm new truck.toml --engine heavy-duty --trace pressure.csv

Numbers marked "typical, assumed" are guesses at the size. Of a trace the columns, their units and the dead centre at
angle 0 are read; what the file does not show is printed as missing.
)";

constexpr const char* kReproduceFooter = R"(Examples:
  ringfilm reproduce styles2014
  ringfilm reproduce styles2014 --output paper
  ringfilm reproduce measured --output measured
)";

constexpr const char* kReportFooter = R"(Examples:
  ringfilm report new.nc worn.nc --output comparison.html
  ringfilm report new.nc --overlay floating_liner.csv --output measured.html
  ringfilm report unrolled.nc --vts fields

The overlay has a column crank_angle [degree] (0 at firing TDC) and columns named like the curves of a result, with
their units: friction_on_liner [N], min_film_thickness [um], ...
)";

constexpr const char* kVerifyFooter = R"(Examples:
  ringfilm verify
  ringfilm verify --list
  ringfilm verify rayleigh1918_step ausas2009_oscillating_squeeze
  ringfilm verify --output verification.html

Each case is computed here and now beside an answer that is known from elsewhere: a closed form, a quadrature, a
publication, an independent program. The exit code is 4 if a number lies outside its tolerance.
)";

std::string version_text() {
  const io::Provenance provenance = io::this_program();
  return provenance.program + " (commit " + provenance.commit + "; " + provenance.compiler + ")";
}

/// Settings as the ledger prints them, key = value, are three arguments: joins them to one.
std::vector<std::string> with_joined_settings(int argc, const char* const* argv) {
  std::vector<std::string> joined;
  bool may_be_setting = false;
  for (int i = 0; i < argc; ++i) {
    const std::string word = argv[i];
    may_be_setting = may_be_setting || word == "--set";
    if (may_be_setting && word == "=" && i + 1 < argc && joined.back() != "--set") {
      joined.back() += "=" + std::string(argv[++i]);
    } else {
      joined.push_back(word);
    }
  }
  return joined;
}

io::VtsShape vts_shape_of(const std::string& word) {
  if (word == "cylinder") return io::VtsShape::kCylinder;
  if (word == "plane") return io::VtsShape::kPlane;
  throw InputError("--vts-shape " + word + ": this is not a choice", "one of: cylinder, plane");
}

/// The case and the settings on the command line of `run` and `check`. A setting may follow --set or the one before it,
/// so the arguments that are alone are distinguished by their equal sign.
struct CaseArguments {
  std::vector<std::string> alone, set;

  void add_to(CLI::App& command) {
    command.add_option("CASE.toml", alone, "the case file")->required()->type_name("");
    command.add_option("--set", set, "a key of the case to replace; read as TOML, else as text; may be repeated")
        ->allow_extra_args(false)
        ->type_name("key=value ...");
  }

  std::string case_path() const {
    std::string path;
    for (const std::string& word : alone) {
      if (is_setting(word)) continue;
      if (!path.empty()) throw InputError("two case files are named: " + path + " and " + word, "run them one by one");
      path = word;
    }
    if (path.empty()) throw InputError("no case file is named", "for example ringfilm run case.toml");
    return path;
  }

  std::vector<io::Override> overrides() const {
    std::vector<io::Override> overrides;
    for (const std::string& word : set) overrides.push_back(override_of(word));
    for (const std::string& word : alone) {
      if (is_setting(word)) overrides.push_back(override_of(word));
    }
    check_once(overrides);
    return overrides;
  }

 private:
  static void check_once(const std::vector<io::Override>& overrides) {
    std::vector<Fault> faults;
    std::set<std::string> keys, twice;
    for (const io::Override& one : overrides) {
      if (!keys.insert(one.key).second) twice.insert(one.key);
    }
    for (const std::string& key : twice) {
      faults.push_back({{}, "--set " + key + " is given more than once", "keep one of them"});
    }
    if (!faults.empty()) throw InputError(std::move(faults));
  }

  bool is_setting(const std::string& word) const { return !set.empty() && word.find('=') != std::string::npos; }
};

/// One command: its own help and, once the arguments are read, what it does.
class Commands {
 public:
  explicit Commands(CLI::App& program) : program_(program) {}

  void add_run() {
    auto& command = add("run", "Compute one engine cycle, or a pad, and print its summary", [this] {
      const std::string case_path = run_words_.case_path();
      if (csv_ && csv_->empty()) csv_ = std::filesystem::path(case_path).stem().string() + ".csv";
      run({case_path,
           run_words_.overrides(),
           output_,
           csv_,
           json_ ? SummaryForm::kJson : SummaryForm::kTable,
           {ledger_, error_estimate_, jobs()}});
    });
    run_words_.add_to(command);
    command.add_option("-o,--output", output_, "write the whole result as NetCDF-4")->type_name("X.nc");
    command
        .add_option("--csv", csv_,
                    "write the curves as CSV, SI units: over crank angle, of a pad along its length; without a name: "
                    "that of the case in this folder")
        ->expected(0, 1)
        ->type_name("X.csv");
    command.add_flag("--json", json_, "print the values as JSON, SI units, instead of the table");
    command.add_flag("--ledger", ledger_, "run the other choice for every modelling assumption that can be lifted");
    command.add_flag(
        "--error-estimate", error_estimate_,
        "integrate four other grids too and give every value its error (cost: docs/theory/error-estimate.md); always "
        "done where solver.accuracy is stated");
    add_jobs(command);
    command.footer(kRunFooter);
  }

  void add_gas() {
    auto& command = add("gas", "Compute the gas between the rings of a pack: pressures, blow-by, ring motion", [this] {
      const std::string case_path = gas_words_.case_path();
      if (csv_ && csv_->empty()) csv_ = std::filesystem::path(case_path).stem().string() + ".csv";
      gas({case_path, gas_words_.overrides(), csv_, output_, varied_,
           json_ ? SummaryForm::kJson : SummaryForm::kTable});
    });
    gas_words_.add_to(command);
    command.add_option("-o,--output", output_, "write values and curves of the gas as NetCDF-4")->type_name("X.nc");
    command
        .add_option("--vary", varied_,
                    "compute all combinations of the values of one or more keys (repeat it) and print blow-by and peak "
                    "pressures of each as CSV")
        ->type_name("KEY=VALUE,VALUE,...")
        ->allow_extra_args(false);
    command
        .add_option("--csv", csv_,
                    "write pressures, flows and ring positions over crank angle as CSV, SI units; without a name: "
                    "that of the case in this folder")
        ->expected(0, 1)
        ->type_name("X.csv");
    command.add_flag("--json", json_, "print the values as JSON instead of the table");
    command.footer(kGasFooter);
  }

  void add_check() {
    auto& command =
        add("check", "Read a case of a ring or a pad, report everything that is wrong with it, run nothing", [this] {
          check({check_words_.case_path(), check_words_.overrides(), json_ ? SummaryForm::kJson : SummaryForm::kTable});
        });
    check_words_.add_to(command);
    command.add_flag("--json", json_, "print inputs, default inputs, modelling assumptions and notes as JSON");
    command.footer(kCheckFooter);
  }

  void add_fields() {
    auto& command =
        add("fields", "Print the keys of a case with unit, default, range and meaning", [this] { fields(fields_); });
    command.add_option("WORD", fields_.words, "a section, a key or a part of it; all keys if none is named")
        ->type_name("...");
    command.footer(kFieldsFooter);
  }

  void add_oils() {
    auto& command = add("oils", "List the shipped oils with their viscosities",
                        [this] { oils({json_ ? SummaryForm::kJson : SummaryForm::kTable}); });
    command.add_flag("--json", json_, "print the list as JSON, SI units");
    command.footer(kOilsFooter);
  }

  void add_pairs() {
    auto& command = add("pairs", "List the shipped pairs of coating and liner with their boundary friction",
                        [this] { pairs({json_ ? SummaryForm::kJson : SummaryForm::kTable}); });
    command.add_flag("--json", json_, "print the list as JSON, SI units");
    command.footer(kPairsFooter);
  }

  void add_new() {
    auto& command = add("new", "Write a commented case to start from", [this] { start_case(new_); });
    command.add_option("CASE.toml", new_.path, "the file to write; must not exist yet")->required()->type_name("");
    command.add_option("--engine", new_.engine, "whose typical numbers: passenger-car (default) or heavy-duty")
        ->type_name("ENGINE");
    command.add_option("--trace", new_.trace, "file of the cylinder pressure, whose columns and units are read")
        ->type_name("X.csv");
    command.footer(kNewFooter);
  }

  void add_report() {
    auto& command = add("report", "Draw results as one self-contained web page, or fields for ParaView", [this] {
      if (vts_shape_) report_.vts_shape = vts_shape_of(*vts_shape_);
      report(report_);
    });
    command.add_option("X.nc", report_.results, "results of ringfilm run --output, or one of ringfilm gas --output")
        ->required()
        ->type_name("...");
    command.add_option("--overlay", report_.overlays, "measured curves to lay over; may be repeated")
        ->allow_extra_args(false)
        ->type_name("X.csv");
    command.add_option("-o,--output,--html", report_.output, "the page to write")->type_name("X.html");
    command
        .add_option(
            "--vts", report_.vts_folder,
            "write the fields around the ring of one result: a .vts file for each crank angle, a .pvd file of all")
        ->type_name("DIR");
    command.add_option("--vts-shape", vts_shape_, "cylinder (default): on the bore; plane: unrolled")
        ->type_name("SHAPE");
    command.footer(kReportFooter);
  }

  void add_reproduce() {
    auto& command = add("reproduce", "Compute a publication anew and compare with it", [this] {
      reproduce_.jobs = jobs();
      if (bands_) reproduce_.bands = FrictionBands::kComputed;
      reproduce(reproduce_);
    });
    command
        .add_option("publication", reproduce_.publication,
                    "styles2014: three rings, new, run-in and embedded; measured: the same from files of instruments")
        ->required()
        ->type_name("");
    command.add_option("-o,--output", reproduce_.folder, "folder for results and report (default ./<publication>)")
        ->type_name("DIR");
    command.add_flag("--friction-band", bands_,
                     "of measured: press the maps against each other, and compute film and friction with each law");
    add_jobs(command);
    command.footer(kReproduceFooter);
  }

  void add_verify() {
    auto& command = add("verify", "Compute cases with known answers and report how far off they are", [this] {
      verify_.requested = list_ ? VerifyRequest::kNames : verify_json_ ? VerifyRequest::kJson : VerifyRequest::kTable;
      verify(verify_);
    });
    command.add_option("NAME", verify_.names, "cases to check; all if none is named")->type_name("...");
    command.add_flag("--list", list_, "print the names of the cases, compute nothing");
    command.add_flag("--json", verify_json_, "print the rows as JSON, SI units, instead of the table");
    command.add_option("-o,--output,--html", verify_.output, "write the same as a web page")->type_name("X.html");
    command.footer(kVerifyFooter);
  }

  void add_conform() { add_conform_command(program_, actions_); }
  void add_study() { add_study_command(program_, actions_); }
  void add_life() { add_life_command(program_, actions_); }

  /// Commands that read instruments.
  void add_measuring() {
    add_surface_commands(program_, actions_);
    add_contact_command(program_, actions_);
    add_face_command(program_, actions_);
    add_lateral_force_command(program_, actions_);
    add_synthetic_command(program_, actions_);
  }

  /// What the chosen command does.
  std::function<void()> chosen() const {
    for (const auto& [command, action] : actions_) {
      if (command->parsed()) return action;
    }
    return {};
  }

 private:
  CLI::App& add(const char* name, const char* description, std::function<void()> action) {
    CLI::App* command = program_.add_subcommand(name, description);
    actions_.emplace_back(command, std::move(action));
    return *command;
  }

  void add_jobs(CLI::App& command) {
    command
        .add_option(
            "--jobs", jobs_,
            "threads for the other integrations of ledger and error estimate, 1 to 1024; without it as many as the "
            "machine runs at once; the numbers are the same")
        ->type_name("N");
  }
  int jobs() const { return jobs_ ? thread_count("--jobs", *jobs_) : 0; }

  CLI::App& program_;
  Actions actions_;
  CaseArguments run_words_, check_words_, gas_words_;
  std::optional<std::string> output_, csv_, jobs_, vts_shape_;
  std::vector<std::string> varied_;
  bool json_ = false, ledger_ = false, error_estimate_ = false;
  FieldsOptions fields_;
  NewOptions new_;
  ReportOptions report_;
  ReproduceOptions reproduce_;
  bool bands_ = false;
  VerifyOptions verify_;
  bool list_ = false, verify_json_ = false;
};

std::string did_you_mean(const std::string& word, const std::vector<std::string>& known) {
  const std::string near = io::nearest_word(word, known);
  return near.empty() ? "" : "; did you mean " + near + "?";
}

std::string joined_names(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

/// The first of the arguments after a command that begins as an option and is not one of its options.
std::optional<InputError> unknown_option(const CLI::App& command, const std::vector<std::string>& arguments) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  for (const std::string& word : arguments) {
    if (word == "--") return std::nullopt;  // what follows is for another program
    const std::string name = word.substr(0, word.find('='));
    if (name.rfind("--", 0) != 0 || std::find(names.begin(), names.end(), name) != names.end()) continue;
    return InputError(name + ": ringfilm " + command.get_name() + " has no such option" + did_you_mean(name, names),
                      "ringfilm " + command.get_name() + " --help lists its options");
  }
  return std::nullopt;
}

/// An option that takes one value and is given more often.
std::optional<InputError> repeated_option(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options()) {
    const std::size_t n = option->results().size();
    if (option->get_positional() || option->get_items_expected_max() != 1 || n < 2) continue;
    const std::string times = n == 2 ? "twice" : std::to_string(n) + " times";
    return InputError(option->get_name() + " is given " + times, "give it once");
  }
  return std::nullopt;
}

/// An option at the end or before another one, without the value that it takes.
std::optional<InputError> option_without_value(const std::string& refusal) {
  const std::string needs = ": 1 required ", missing = " missing";
  const std::size_t at = refusal.find(needs), end = refusal.rfind(missing);
  if (at == std::string::npos || end == std::string::npos || end < at + needs.size()) return std::nullopt;
  const std::string option = refusal.substr(0, at);
  const std::string value = refusal.substr(at + needs.size(), end - at - needs.size());
  return InputError(option + " has no value", "write " + option + " " + value);
}

/// The command that the first arguments name: a command of the program, or one of its own ("synthetic gaussian").
const CLI::App& named_command(const CLI::App& program, const std::vector<std::string>& arguments) {
  const CLI::App* command = &program;
  for (const std::string& word : arguments) {
    const auto inner = command->get_subcommands([&word](const CLI::App* one) { return one->get_name() == word; });
    if (inner.empty()) break;
    command = inner.front();
  }
  return *command;
}

/// What CLI11 states of numbers of values, in the terms of a user.
std::optional<InputError> wrong_number_of_values(const CLI::App& program, const std::vector<std::string>& arguments,
                                                 const CLI::ParseError& refusal) {
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&refusal) == nullptr) return std::nullopt;
  if (const auto repeated = repeated_option(named_command(program, arguments))) return repeated;
  return option_without_value(refusal.what());
}

/// What is wrong with a line that CLI11 refuses, where a word of it may be misspelt.
std::optional<InputError> misspelt_word(const CLI::App& program, const std::vector<std::string>& arguments) {
  if (arguments.empty()) return std::nullopt;
  const std::string& first = arguments.front();
  std::vector<std::string> names;
  for (const CLI::App* command : program.get_subcommands({})) {
    if (command->get_name() == first) return unknown_option(*command, arguments);
    names.push_back(command->get_name());
  }
  if (first.rfind('-', 0) == 0) return std::nullopt;
  return InputError("ringfilm " + first + ": this is not a command" + did_you_mean(first, names),
                    "one of: " + joined_names(names));
}

}  // namespace

io::Override override_of(const std::string& text) {
  const std::size_t equal_sign = text.find('=');
  if (equal_sign == std::string::npos || equal_sign == 0) {
    throw InputError("--set " + text + ": this is not key=value", "for example --set operating.speed='3000 rpm'");
  }
  return {trimmed(text.substr(0, equal_sign)), trimmed(text.substr(equal_sign + 1))};
}

Request read_command_line(int argc, const char* const* argv) {
  CLI::App program(
      "Friction, film and oil flow of a piston ring over one engine cycle, from measured surfaces; films of pads, too.",
      "ringfilm");
  program.set_version_flag("--version", version_text());
  program.require_subcommand(1);
  program.footer(kProgramFooter);
  const auto commands = std::make_shared<Commands>(program);
  commands->add_run();
  commands->add_gas();
  commands->add_check();
  commands->add_conform();
  commands->add_report();
  commands->add_reproduce();
  commands->add_verify();
  commands->add_study();
  commands->add_life();
  commands->add_measuring();
  commands->add_fields();
  commands->add_oils();
  commands->add_pairs();
  commands->add_new();
  const std::vector<std::string> words = with_joined_settings(argc, argv);
  std::vector<const char*> joined;
  for (const std::string& word : words) joined.push_back(word.c_str());
  try {
    program.parse(static_cast<int>(joined.size()), joined.data());
  } catch (const CLI::ParseError& refusal) {
    if (refusal.get_exit_code() != 0) {
      const std::vector<std::string> arguments(argv + std::min(argc, 1), argv + argc);
      auto error = misspelt_word(program, arguments);
      if (!error) error = wrong_number_of_values(program, arguments, refusal);
      if (error) return {[error] { throw InputError(*error); }, kBadInput};
    }
    return {{}, program.exit(refusal) == 0 ? kFine : kBadInput};
  }
  const std::function<void()> chosen = commands->chosen();
  return {[commands, chosen] { chosen(); }, kFine};
}

}  // namespace ringfilm::app
