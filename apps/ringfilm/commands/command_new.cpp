#include <algorithm>
#include <filesystem>
#include <iostream>
#include <optional>

#include "command_options.hpp"
#include "commands/commands.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/base/joined.hpp"
#include "ringfilm/io/case/case_file.hpp"
#include "ringfilm/io/start/start_case.hpp"
#include "ringfilm/io/start/start_documents.hpp"
#include "ringfilm/io/storage/atomic_file.hpp"
#include "ringfilm/io/text/suggestion.hpp"
#include "ringfilm/io/text/toml_tree.hpp"
#include "text/shared_options.hpp"

namespace ringfilm::app {
namespace {

constexpr const char* kOperatingPoints = "operating-points";

struct NewOptions {
  std::vector<std::string> words;           ///< [study KIND | life] and the file
  std::string path;                         ///< the last of them
  std::optional<std::string> case_path;     ///< case of a study or a life
  std::optional<std::string> engine, pack;  ///< one of io::start_engines(); the first of them if both are absent
  std::optional<std::string> load, state;   ///< one of io::start_loads(), one of io::start_states()
  std::optional<std::string> trace;         ///< file of the cylinder pressure
  io::TableReading table;                   ///< how the trace is read
  std::optional<std::string> points;        ///< file of a study of operating points, written as well
  bool has_all_keys = false;                ///< every key of a ring, those without need as comments
};

io::StartOptions start_options(const NewOptions& options) {
  if (options.engine && options.pack) {
    throw InputError("--engine and --pack both name an engine", "name it once; --pack has all its rings");
  }
  if (options.has_all_keys && options.pack) {
    throw InputError("--all is for the case of one ring", "remove it; `ringfilm fields` shows the keys of a pack");
  }
  io::StartOptions start;
  start.engine = options.engine.value_or(options.pack.value_or(start.engine));
  start.is_pack = options.pack.has_value();
  start.load = options.load.value_or(start.load);
  start.state = options.state.value_or(start.state);
  start.trace = options.trace;
  start.trace_table = options.table;
  start.has_all_keys = options.has_all_keys;
  start.case_folder = std::filesystem::path(options.path).parent_path().string();
  return start;
}

/// Refuses to replace a file.
void check_is_new(const std::string& path) {
  io::check_can_write(path, io::Sink::kFile);
  std::error_code error;
  if (!std::filesystem::exists(path, error)) return;
  throw InputError(path + ": this file exists already", "name one that does not, nothing is replaced here");
}

/// A path as a file in the folder of `document` names it.
std::string seen_from(const std::string& document, const std::string& path) {
  const auto folder = std::filesystem::absolute(document).parent_path();
  return std::filesystem::relative(path, folder).generic_string();
}

/// Writes a study or a life of a case.
void start_document(const NewOptions& options) {
  const std::string command = options.words.front(), &path = options.path;
  const bool is_life = command == "life";
  if (options.words.size() != (is_life ? 2u : 3u)) {
    throw InputError("ringfilm new " + command + " requires " + (is_life ? "a file" : "a kind and a file"),
                     is_life ? "for example ringfilm new life life.toml --case my.toml"
                             : "for example ringfilm new study map map.toml --case my.toml");
  }
  if (!options.case_path) {
    throw InputError("ringfilm new " + command + " requires a case",
                     "name it with --case my.toml; ringfilm new my.toml writes one");
  }
  const bool has_points = !is_life && options.words[1] == kOperatingPoints;
  const std::pair<const char*, bool> stated[] = {{"--engine", options.engine && !has_points},
                                                 {"--pack", options.pack.has_value()},
                                                 {"--load", options.load.has_value()},
                                                 {"--state", options.state.has_value()},
                                                 {"--trace", options.trace.has_value()},
                                                 {"--points", options.points.has_value()},
                                                 {"--all", options.has_all_keys}};
  for (const auto& [option, is_stated] : stated) {
    if (is_stated)
      throw InputError(std::string(option) + " is for a case, and a " + command + " is written", "remove it");
  }
  check_is_new(path);
  const io::OutputClaim claimed(path);
  const std::string seen = seen_from(path, *options.case_path);
  const cycle::Case c = io::read_case(*options.case_path, {});
  if (c.problem != cycle::Problem::kCycle) {
    throw InputError(*options.case_path + " is not the case of a ring or a pack", "name one with --case");
  }
  std::string text;
  if (is_life) {
    text = io::start_life(c, seen);
  } else {
    const std::string& kind = options.words[1];
    std::vector<std::string> kinds = io::start_study_kinds();
    kinds.emplace_back(kOperatingPoints);
    if (std::ranges::find(kinds, kind) == kinds.end()) {
      throw InputError(
          "there is no study of the kind " + io::quoted(kind) + " to start from" + io::did_you_mean(kind, kinds),
          "one of: " + joined(kinds, ", "));
    }
    if (has_points && !options.engine) {
      throw InputError("operating points are those of an engine, and none is named",
                       "--engine with one of " + joined(io::start_engines(), ", ") + ", or a file of your own");
    }
    io::StartOptions points = start_options(options);
    if (c.gas.model == cycle::GasModel::kTrace) points.trace = c.gas.cylinder_pressure_file;  // pressures are its own
    text = has_points ? io::start_points(points, seen) : io::start_study(kind, c, seen);
  }
  io::write_atomically(path, text);
  std::cout << "wrote " << path << "\nnext: ringfilm " << command << " " << path << "\n";
}

/// Writes a commented case to start from, and a study of its operating points; or a study or a life of a case.
void start_file(const NewOptions& options) {
  const std::string& path = options.path;
  if (options.words.front() == "study" || options.words.front() == "life") return start_document(options);
  if (options.words.size() > 1) {
    throw InputError("ringfilm new " + options.words.front() + ": one file is written, or a study or life of a case",
                     "ringfilm new my.toml, ringfilm new study map map.toml --case my.toml");
  }
  if (options.case_path) {
    throw InputError("--case is for ringfilm new study and ringfilm new life", "remove it");
  }
  check_is_new(path);
  const io::OutputClaim claimed(path);
  std::optional<io::OutputClaim> claimed_points;
  if (options.points) {
    check_is_new(*options.points);
    claimed_points.emplace(*options.points);
  }
  const io::StartOptions start = start_options(options);
  const io::StartCase made = io::start_case(start);
  io::write_atomically(path, made.text);
  if (options.points) {
    io::write_atomically(*options.points, io::start_points(start, seen_from(*options.points, path)));
    std::cout << "wrote " << *options.points << "\n";
  }
  std::cout << "wrote " << path << "\n";
  for (const std::string& one : made.found) std::cout << "found in " << *options.trace << ": " << one << "\n";
  for (const std::string& one : made.missing) std::cout << "missing: " << one << "\n";
  for (const std::string& one : made.notes) std::cout << "note: " << one << "\n";
  if (made.missing.empty()) {
    std::cout << "next: ringfilm run " << path << "\n";
    if (options.points) std::cout << "next: ringfilm study " << *options.points << "\n";
  } else {
    std::cout << "next: state what is missing in " << path << " (lines with MISSING), then ringfilm check " << path
              << "\n";
  }
}

constexpr const char* kNewFooter = R"(Examples:
  ringfilm new my_engine.toml
  ringfilm new truck.toml --engine heavy-duty --trace pressure.csv
  ringfilm new pack.toml --pack hydrogen
  ringfilm new first_hour.toml --state new
  ringfilm new study map map.toml --case my_engine.toml
  ringfilm new study operating-points points.toml --case pack.toml --engine hydrogen
  ringfilm new life life.toml --case my_engine.toml

KIND is map, uncertainty, compare or operating-points. Numbers marked "typical, assumed" are guesses at the size. Of a
trace the columns, their units and the dead centre at angle 0 are read; what the file does not show is printed as
missing.
)";

void declare_new(CommandOptions& add, NewOptions& options) {
  add.text("FILE.toml", options.words, "", "the file to write; must not exist yet; before it: study KIND, or life")
      ->required();
  add.rule([&options](Faults&) { options.path = options.words.back(); });
  add.text("--case", options.case_path, "CASE.toml", "of a study or a life: the case that it is about");
  add.text("--engine", options.engine, "ENGINE",
           "typical numbers: passenger-car (default), another one of data/engines, or an own file of that form");
  add.text("--pack", options.pack, "ENGINE", "the same engines with all their rings, their gas and their oil");
  add.text("--load", options.load, "LOAD", "part or full (default)");
  add.text("--state", options.state, "STATE", "of the surfaces: new, run-in (default) or worn");
  add.text("--points", options.points, "POINTS.toml",
           "a study of the case at weighted operating points, written as well; must not exist yet");
  add.flag("--all", options.has_all_keys, "write every key of a ring, those that need no decision as comments");
  add.text("--trace", options.trace, "X.csv", "file of the cylinder pressure, whose columns and units are read");
  add_table(add, options.table);
}

}  // namespace

void add_new_command(Program& program) {
  program.add("new", "Write a commented case, study or life to start from", kNewFooter, declare_new, start_file);
}

}  // namespace ringfilm::app
