#include <filesystem>

#include "study/study_submit.hpp"
#include "text/shared_options.hpp"

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

constexpr int kMaxWords = 64;  // those for another program among them
constexpr std::uint64_t kMaxParts = 1'000'000;

/// The command with the words that are alone: an action or none, the study, those for another program.
struct StudyRequest : SubmitOptions {
  std::vector<std::string> alone;
  std::string action;
};

void read_shard(const std::string& text, StudyOptions& study) {
  const std::size_t slash = text.find('/');
  if (slash == std::string::npos) {
    throw InputError(fmt::format("--shard {}: this is not i/n", text), "for example --shard 2/8");
  }
  study.is_part = true;
  study.part = CommandOptions::count_of("--shard", text.substr(0, slash), kMaxParts, "a number", "");
  study.parts = CommandOptions::count_of("--shard", text.substr(slash + 1), kMaxParts, "a number", "");
  if (study.part > study.parts) {
    throw InputError(fmt::format("--shard {}: there is no part {} of {}", text, study.part, study.parts),
                     "parts count from 1");
  }
}

void take_words(StudyRequest& request) {
  const bool has_action = request.alone.size() >= 2;
  const auto study = request.alone.begin() + (has_action ? 1 : 0);
  request.study.study_path = *study;
  request.further.insert(request.further.begin(), study + 1, request.alone.end());
  if (has_action) request.action = request.alone.front();
  if (has_action && request.action != "merge" && request.action != "status" && request.action != "submit") {
    throw InputError(fmt::format("ringfilm study {}: this is not an action", request.action),
                     "one of: merge, status, submit");
  }
  if (!request.further.empty() && request.action != "submit") {
    throw InputError(fmt::format("ringfilm study {}: this is one word too many", request.further.front()),
                     "one study at a time");
  }
}

void declare_study(CommandOptions& add, StudyRequest& request) {
  StudyOptions& study = request.study;
  add.text("STUDY.toml", request.alone, "", "the study's file; before it: merge, status or submit")
      ->required()
      ->expected(1, kMaxWords);
  // The first option takes the arguments behind --, too; but a command only accepts -- as long as another may still
  // come.
  add.text("OPTION", request.further, "", "of submit, behind --: options of sbatch");
  const CLI::Option* output =
      add.text("-o,--output", study.output, "OUT", "folder for results, or X.nc (default ./<study>)");
  const CLI::Option* shard = add.read("--shard", "i/n", "compute part i of n only",
                                      [&study](const std::string& text) { read_shard(text, study); });
  const CLI::Option* resume = add.flag("--resume", study.resume, "continue with what is there");
  const CLI::Option* overwrite =
      add.flag("--overwrite", study.overwrite, "replace the study in the output, which is refused without it");
  const CLI::Option* yes =
      add.flag("--yes", study.yes,
               "run a grid of more than 10000 points, keep more than 2 GB of curves, submit unseen by squeue");
  const CLI::Option* threads = add_threads(add, study.threads);
  const CLI::Option* engine = add.text("--engine", request.engine, "NAME", "of submit: slurm");
  const CLI::Option* parts =
      add.count("--parts", request.parts, kMaxParts, "a number", "", "of submit: into how many parts (default 8)");
  const CLI::Option* rehearsal =
      add.flag("--dry-run", request.is_rehearsal, "of submit: write and show the scripts, submit nothing");

  add.rule([=, &request, &study](Faults&) {
    take_words(request);
    if (!is_stated(output)) study.output = std::filesystem::path(study.study_path).stem().string();
    if (study.resume && study.overwrite) {
      throw InputError("--resume keeps the scenarios that are there, --overwrite replaces them", "keep one of the two");
    }
    if (request.action == "submit") {
      if (is_any_stated({shard, resume, overwrite})) {
        throw InputError("ringfilm study submit takes none of --shard, --resume and --overwrite",
                         "it always computes what is missing, in --parts parts");
      }
      return;
    }
    if (is_any_stated({engine, parts, rehearsal})) {
      throw InputError("--engine, --parts and --dry-run are options of ringfilm study submit", "leave them out");
    }
    if (!request.action.empty() && is_any_stated({shard, resume, overwrite, yes, threads})) {
      throw InputError(fmt::format("ringfilm study {} takes no other option than -o", request.action),
                       "leave the others out");
    }
  });
}

void carry_out_study(const StudyRequest& request) {
  if (request.action == "submit") return submit_study(request);
  if (request.action == "merge") return merge_study(request.study);
  if (request.action == "status") return print_study_status(request.study);
  run_study(request.study);
}

}  // namespace

void add_study_command(Program& program) {
  program.add("study", "Run many scenarios around a case: maps, uncertainty, comparison", kStudyFooter, declare_study,
              carry_out_study);
}

}  // namespace ringfilm::app
