#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "commands/commands.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/base/joined.hpp"
#include "ringfilm/cycle/advice/advice.hpp"
#include "ringfilm/cycle/closure/static_closure.hpp"
#include "ringfilm/cycle/pack/gas_of_pack.hpp"
#include "ringfilm/cycle/pack/rails_of_pack.hpp"
#include "ringfilm/cycle/setup/setup.hpp"
#include "ringfilm/io/case/case_file.hpp"
#include "ringfilm/io/case/case_text.hpp"
#include "ringfilm/io/case/shipped_oils.hpp"
#include "ringfilm/io/data/shipped_pairs.hpp"
#include "ringfilm/io/result/result_json.hpp"
#include "ringfilm/pad/pad_setup.hpp"
#include "ringfilm/run/assumed_inputs.hpp"
#include "ringfilm/study/ensemble/assumed_inputs.hpp"
#include "ringfilm/study/ensemble/ledger.hpp"
#include "text/shared_options.hpp"
#include "text/wrapped_text.hpp"

namespace ringfilm::app {
namespace {

/// What setting up the models of a case gives, ring by ring; of a pad nothing.
io::CaseCheck checked(const cycle::Case& input, const std::string& path) {
  io::CaseCheck check{path, io::case_entries(input), {}, {}};
  for (const std::string& note : input.notes) check.notes.push_back({"input", note, 1});
  if (input.problem == cycle::Problem::kPad) {
    pad::prepare_pad(input);
    return check;
  }
  if (input.problem == cycle::Problem::kClosure) {
    cycle::ring_beam(input);
    return check;
  }
  const cycle::Case with_gas = cycle::with_gas_path(cycle::with_rails(input));
  const std::vector<cycle::Case> rings = input.is_pack() ? with_gas.rings : std::vector{with_gas};
  std::vector<std::pair<cycle::Note, std::vector<std::string>>> of_rings;  // each note once, and who has it
  for (std::size_t i = 0; i < rings.size(); ++i) {
    check.assumptions.push_back(study::assumptions(rings[i]));
    for (const cycle::Note& note : cycle::advice(cycle::prepare(rings[i]))) {
      const auto same = std::ranges::find_if(of_rings, [&](const auto& one) {
        return one.first.topic == note.topic && one.first.message == note.message;
      });
      if (same == of_rings.end()) {
        of_rings.push_back({note, {cycle::ring_label(input, i)}});
      } else {
        same->second.push_back(cycle::ring_label(input, i));
      }
    }
  }
  for (auto& [note, labels] : of_rings) {
    if (input.is_pack()) {
      note.message = fmt::format("ring{} {}: {}", labels.size() > 1 ? "s" : "", joined(labels, "; "), note.message);
    }
    check.notes.push_back(std::move(note));
  }
  return check;
}

std::size_t n_default_inputs(const io::CaseCheck& check) {
  return static_cast<std::size_t>(std::count_if(check.inputs.begin(), check.inputs.end(),
                                                [](const io::CaseEntry& entry) { return entry.assumed; }));
}

void print_counts(const io::CaseCheck& check) {
  const std::size_t n_default = n_default_inputs(check);
  std::cout << fmt::format("{}: no errors; {} keys stated, {} default inputs\n", check.path,
                           check.inputs.size() - n_default, n_default);
}

/// The topics of all rings, for who does not ask for the statements.
void print_topics(const io::CaseCheck& check) {
  std::vector<std::string> topics;
  for (const auto& ring : check.assumptions) {
    for (const study::LedgerEntry& one : ring) {
      if (std::find(topics.begin(), topics.end(), one.topic) == topics.end()) topics.push_back(one.topic);
    }
  }
  if (topics.empty()) return;
  std::cout << wrapped(words(fmt::format("{} modelling assumptions ({}); --all explains them and the default inputs",
                                         topics.size(), joined(topics, ", "))));
}

void print_inputs(const io::CaseCheck& check) {
  if (n_default_inputs(check) > 0) std::cout << "default inputs, keys that the case does not state:\n";
  for (const io::CaseEntry& entry : check.inputs) {
    if (entry.assumed) std::cout << fmt::format("  {} = {}  ({})\n", entry.key, entry.shown, entry.help);
  }
}

void print_assumptions(const io::CaseCheck& check, const cycle::Case& input) {
  for (std::size_t i = 0; i < check.assumptions.size(); ++i) {
    if (i == 0) {
      std::cout << "modelling assumptions, as in docs/theory/assumptions.md:\n";
    } else {
      std::cout << fmt::format("modelling assumptions of ring {} where they differ from those of ring 1:\n",
                               cycle::ring_label(input, i));
    }
    for (const study::LedgerEntry& one : check.assumptions[i]) {
      const auto is_same = [&one](const study::LedgerEntry& first) { return first.statement == one.statement; };
      const auto& first_ring = check.assumptions.front();
      if (i > 0 && std::any_of(first_ring.begin(), first_ring.end(), is_same)) continue;
      const std::string consequence = one.consequence.empty() ? "" : "; " + one.consequence;
      std::cout << "  " << wrapped(words(one.topic + ": " + one.statement + consequence));
    }
  }
}

}  // namespace

void print_dropped(const std::vector<io::DroppedKey>& dropped) {
  if (dropped.empty()) return;
  std::cerr << "--set makes keys of the case unused, they are dropped: " << io::listed(dropped) << "\n";
}

cycle::Case case_with_settings(const std::string& path, const std::vector<io::Override>& settings,
                               cycle::CasePurpose purpose) {
  std::vector<io::DroppedKey> dropped;
  cycle::Case input = io::read_case_dropping(path, settings, io::Units(), dropped, purpose);
  print_dropped(dropped);
  return input;
}

namespace {

struct CheckOptions : CaseOptions {
  bool assumptions = false;  ///< what assumed inputs decide is computed, however long it takes
  bool all = false;          ///< default inputs and modelling assumptions one by one
  int threads = 0;
};

/// Adds what the assumed inputs of a ring or pack decide, where it takes a second or so or was asked for.
void add_assumed_inputs(const CheckOptions& options, const cycle::Case& input, io::CaseCheck& check) {
  if (input.problem != cycle::Problem::kCycle || !(options.assumptions || study::is_quick(input))) return;
  const auto called_assumed = io::keys_called_assumed(options.case_path, options.overrides);
  try {
    check.assumed_inputs = run::assumed_inputs(input, called_assumed, options.threads);
  } catch (const ConvergenceError& stop) {
    check.notes.push_back(
        {"assumed-inputs", std::string("what the assumed inputs decide was not computed: ") + stop.what(), 1});
  }
}

std::string percent(double change) { return fmt::format("{:+.1f} %", 100 * change); }

/// Changes below this are those of a coarse computation.
constexpr double kMinChange = 0.01;
/// More of them decide nothing.
constexpr std::size_t kMaxInputs = 10;

void print_assumed_inputs(const CheckOptions& options, const io::CaseCheck& check, const cycle::Case& input) {
  if (input.problem != cycle::Problem::kCycle) return;
  if (!check.assumed_inputs) {
    const std::size_t n = run::n_assumed_inputs(input, io::keys_called_assumed(options.case_path, options.overrides));
    if (n > 0 && !options.assumptions) {
      std::cout << fmt::format("assumed inputs: {}; --assumptions computes which of them decide the result most\n", n);
    }
    return;
  }
  const std::vector<study::AssumedInput>& all = *check.assumed_inputs;
  const auto end = std::find_if(
      all.begin(), all.begin() + static_cast<std::ptrdiff_t>(std::min(all.size(), kMaxInputs)),
      [](const study::AssumedInput& one) { return !one.solved || std::abs(one.fmep_change) < kMinChange; });
  if (end != all.begin()) {
    std::cout << "assumed inputs that decide the result most, each changed alone:\n";
    std::cout << fmt::format("  {:>9} {:>10}  {}\n", "FMEP", "min. film", "setting (now)");
  }
  for (auto one = all.begin(); one != end; ++one) {
    std::cout << fmt::format("  {:>9} {:>10}  {} ({}, {})\n", percent(one->fmep_change), percent(one->min_film_change),
                             one->setting, one->value, one->is_default ? "default" : "called assumed in the file");
  }
  const auto n_others = all.end() - end;
  if (n_others > 0) std::cout << fmt::format("  {} more assumed inputs change less\n", n_others);
}

void check(const CheckOptions& options) {
  const std::string& path = options.case_path;
  const auto found_in = [&](const cycle::Case& input) {
    io::CaseCheck found = checked(input, path);
    add_assumed_inputs(options, input, found);
    return found;
  };
  if (options.summary == SummaryForm::kJson) {
    try {
      std::cout << io::check_json(found_in(case_with_settings(path, options.overrides)));
    } catch (const InputError& error) {
      std::cout << io::errors_json(path, error.faults());
      throw;
    }
    return;
  }
  const cycle::Case input = case_with_settings(path, options.overrides);
  const io::CaseCheck found = found_in(input);
  print_counts(found);
  for (const cycle::Note& note : found.notes) std::cout << wrapped(words("note: " + note.message));
  print_assumed_inputs(options, found, input);
  if (!options.all) return print_topics(found);
  print_inputs(found);
  print_assumptions(found, input);
}

struct FieldsOptions {
  std::vector<std::string> words;  ///< sections, keys or parts of keys; empty: all keys
};

/// Prints the table of case keys.
void fields(const FieldsOptions& options) { std::cout << io::fields_table(options.words); }

/// Options of `oils` and `pairs`.
struct OilsOptions {
  SummaryForm summary = SummaryForm::kTable;
};

/// Prints the shipped oils.
void oils(const OilsOptions& options) {
  const std::vector<io::ShippedOil> shipped = io::shipped_oils(io::Units());
  std::cout << (options.summary == SummaryForm::kJson ? io::oils_json(shipped) : io::oils_table(shipped));
}

/// Prints the shipped pairs of coating and liner with their boundary friction, and the classes of surfaces.
void pairs(const OilsOptions& options) {
  const io::Units units;
  const auto shipped = io::shipped_pairs(units).pairs;
  const io::SurfaceClasses surfaces = io::shipped_surfaces(units);
  std::cout << (options.summary == SummaryForm::kJson ? io::pairs_json(shipped, surfaces)
                                                      : io::pairs_table(shipped) + "\n" + io::surfaces_table(surfaces));
}

constexpr const char* kCheckFooter = R"(Examples:
  ringfilm check case.toml
  ringfilm check case.toml --set operating.speed='3000 rpm'
  ringfilm check case.toml --json
  ringfilm check case.toml --all
  ringfilm check pack.toml --assumptions

Default inputs are keys that the case does not state; modelling assumptions are what the models take for granted.
Assumed inputs are defaults that are assumed and keys whose line in the file has a comment with the word "assumed". Each
is made 20 % larger alone, a temperature 10 K higher, and computed coarsely: at once for one ring whose film
is integrated in some hundredths of a second, else with --assumptions.
)";

constexpr const char* kFieldsFooter = R"(Examples:
  ringfilm fields
  ringfilm fields ring
  ringfilm fields ring.face clearance
)";

constexpr const char* kOilsFooter = R"(Examples:
  ringfilm oils
  ringfilm run case.toml --set lubricant.grade='SAE 10W-40'
)";

constexpr const char* kPairsFooter = R"(Examples:
  ringfilm pairs
  ringfilm run case.toml --set contact.friction_pair=crn-on-grey-iron --set contact.boundary_shear_strength_coefficient=
)";

void declare_check(CommandOptions& add, CheckOptions& options) {
  add_case(add, options);
  add.flag("--assumptions", options.assumptions,
           "compute which assumed inputs decide friction and film, where that takes long, too: of a pack some minutes");
  add.flag("--all", options.all, "print every default input and every modelling assumption, with its consequence");
  add_jobs(add, options.threads);
  add.json(options.summary, "print inputs, default inputs, modelling assumptions and notes as JSON");
}

void declare_fields(CommandOptions& add, FieldsOptions& options) {
  add.text("WORD", options.words, "...", "a section, a key or a part of it; all keys if none is named");
}

void declare_list(CommandOptions& add, OilsOptions& options) {
  add.json(options.summary, "print the list as JSON, SI units");
}

}  // namespace

void add_check_command(Program& program) {
  program.add("check", "Read a case of a ring or a pad, report everything that is wrong with it and what is assumed",
              kCheckFooter, declare_check, check);
}

void add_data_commands(Program& program) {
  program.add("fields", "Print the keys of a case with unit, default, range and meaning", kFieldsFooter, declare_fields,
              fields);
  program.add("oils", "List the shipped oils with their viscosities", kOilsFooter, declare_list, oils);
  program.add("pairs",
              "List the shipped pairs of coating and liner with their boundary friction, and classes of surfaces",
              kPairsFooter, declare_list, pairs);
}

}  // namespace ringfilm::app
