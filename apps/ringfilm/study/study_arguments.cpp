#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <filesystem>
#include <memory>

#include "commands/command_study.hpp"
#include "ringfilm/base/error.hpp"
#include "study/study_submit.hpp"
#include "text/command_arguments.hpp"

namespace ringfilm::app {
namespace {

constexpr const char* kStudyFooter = R"(Examples:
  ringfilm study study.toml -o results
  ringfilm study study.toml -o results --resume
  ringfilm study study.toml -o results --shard 2/8
  ringfilm study status study.toml -o results
  ringfilm study merge study.toml -o results
  ringfilm study submit study.toml -o results --engine slurm --parts 16 -- --partition=long

Ctrl-C stops after the current block; --resume continues with what is there, after a kill, too, and computes nothing
twice.
A study that is in the output, finished or not, is replaced with --overwrite only.
--shard i/n computes the i-th of n parts, on any machine that sees the output; merge joins the parts.
submit writes a job array of the parts and the job that joins them into the output and hands them to the scheduler; what
follows -- is passed to sbatch.
)";

constexpr int kMostWords = 64;  // those for another program among them

struct StudyArguments {
  std::vector<std::string> alone, further;
  std::optional<std::string> output, shard, threads, engine, parts;
  bool resume = false, overwrite = false, yes = false, is_rehearsal = false;

  void run() const {
    const bool has_action = alone.size() >= 2;
    std::vector<std::string> beyond = further;
    if (alone.size() > 2) beyond.insert(beyond.begin(), alone.begin() + 2, alone.end());
    const std::string action = has_action ? alone.front() : "";
    if (has_action && action != "merge" && action != "status" && action != "submit") {
      throw InputError(fmt::format("ringfilm study {}: this is not an action", action),
                       "one of: merge, status, submit");
    }
    if (!beyond.empty() && action != "submit") {
      throw InputError(fmt::format("ringfilm study {}: this is one word too many", beyond.front()),
                       "one study at a time");
    }
    StudyOptions options;
    options.study_path = has_action ? alone[1] : alone.front();
    options.output = output.value_or(std::filesystem::path(options.study_path).stem().string());
    options.resume = resume;
    options.overwrite = overwrite;
    if (resume && overwrite) {
      throw InputError("--resume keeps the scenarios that are there, --overwrite replaces them", "keep one of the two");
    }
    options.yes = yes;
    if (threads) options.threads = static_cast<int>(number("--threads", *threads, kMostThreads));
    if (shard) read_shard(options);
    if (action == "submit") return submit(options, beyond);
    if (engine || parts || is_rehearsal) {
      throw InputError("--engine, --parts and --dry-run are options of ringfilm study submit", "leave them out");
    }
    if (has_action && (shard || resume || overwrite || yes || threads)) {
      throw InputError(fmt::format("ringfilm study {} takes no other option than -o", action), "leave the others out");
    }
    if (action == "merge") return merge_study(options);
    if (action == "status") return print_study_status(options);
    run_study(options);
  }

 private:
  static constexpr std::uint64_t kMostThreads = 1024, kMostParts = 1'000'000;

  static std::uint64_t number(const char* option, const std::string& text, std::uint64_t most) {
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error == std::errc{} && end == text.data() + text.size() && value >= 1 && value <= most) return value;
    throw InputError(fmt::format("{} {}: this is not a number from 1 to {}", option, text, most));
  }

  void submit(const StudyOptions& options, const std::vector<std::string>& beyond) const {
    if (shard || resume || overwrite) {
      throw InputError("ringfilm study submit takes none of --shard, --resume and --overwrite",
                       "it always computes what is missing, in --parts parts");
    }
    SubmitOptions how;
    how.study = options;
    how.study.is_part = true;
    how.study.parts = parts ? number("--parts", *parts, kMostParts) : 0;
    how.engine = engine.value_or("");
    how.is_rehearsal = is_rehearsal;
    how.further = beyond;
    submit_study(how);
  }

  void read_shard(StudyOptions& options) const {
    const std::size_t slash = shard->find('/');
    if (slash == std::string::npos)
      throw InputError(fmt::format("--shard {}: this is not i/n", *shard), "for example --shard 2/8");
    options.is_part = true;
    options.part = number("--shard", shard->substr(0, slash), kMostParts);
    options.parts = number("--shard", shard->substr(slash + 1), kMostParts);
    if (options.part > options.parts) {
      throw InputError(fmt::format("--shard {}: there is no part {} of {}", *shard, options.part, options.parts),
                       "parts count from 1");
    }
  }
};

}  // namespace

void add_study_command(CLI::App& program, Actions& actions) {
  CLI::App* command =
      program.add_subcommand("study", "Run many scenarios around a case: maps, uncertainty, comparison");
  const auto arguments = std::make_shared<StudyArguments>();
  command->add_option("STUDY.toml", arguments->alone, "the study's file; before it: merge, status or submit")
      ->required()
      ->expected(1, kMostWords)
      ->type_name("");
  // The first option takes the arguments behind --, too; but a command only accepts -- as long as another may still
  // come.
  command->add_option("OPTION", arguments->further, "of submit, behind --: options of sbatch")->type_name("");
  command->add_option("-o,--output", arguments->output, "folder for results, or X.nc (default ./<study>)")
      ->type_name("OUT");
  command->add_option("--shard", arguments->shard, "compute part i of n only")->type_name("i/n");
  command->add_flag("--resume", arguments->resume, "continue with what is there");
  command->add_flag("--overwrite", arguments->overwrite,
                    "replace the study in the output, which is refused without it");
  command->add_flag("--yes", arguments->yes,
                    "run a grid of more than 10000 points, keep more than 2 GB of curves, submit unseen by squeue");
  command->add_option("--threads", arguments->threads, "1 to 1024; without it as many as the machine runs at once")
      ->type_name("N");
  command->add_option("--engine", arguments->engine, "of submit: slurm")->type_name("NAME");
  command->add_option("--parts", arguments->parts, "of submit: into how many parts (default 8)")->type_name("N");
  command->add_flag("--dry-run", arguments->is_rehearsal, "of submit: write and show the scripts, submit nothing");
  command->footer(kStudyFooter);
  actions.emplace_back(command, [arguments] { arguments->run(); });
}

}  // namespace ringfilm::app
