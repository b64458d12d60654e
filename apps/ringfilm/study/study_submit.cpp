#include "study/study_submit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <sstream>

#include "commands/commands.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/io/storage/atomic_file.hpp"
#include "study/slurm_queue.hpp"
#include "study/study_files.hpp"

namespace ringfilm::app {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kUsualParts = 8;

/// "1-3,7" for 1, 2, 3, 7.
std::string ranges(const std::vector<std::uint64_t>& numbers) {
  std::string text;
  for (std::size_t i = 0; i < numbers.size();) {
    std::size_t last = i;
    while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) ++last;
    text += fmt::format("{}{}", text.empty() ? "" : ",", numbers[i]);
    if (last > i) text += fmt::format("-{}", numbers[last]);
    i = last + 1;
  }
  return text;
}

/// A word of a line #SBATCH, which sbatch itself takes apart.
std::string sbatch_word(const std::string& word) {
  if (is_plain(word)) return word;
  std::string quoted = "\"";
  for (const char c : word) quoted.append(c == '"' || c == '\\' ? "\\" : "").append(1, c);
  return quoted.append(1, '"');
}

class SlurmStudy {
 public:
  SlurmStudy(const SubmitOptions& options, const StudyFiles& files) : options_(options), files_(files) {}

  /// Names that sbatch would take for something else.
  void check_names() const {
    const auto is_odd = [](unsigned char c) { return c < ' ' || c == '"' || c == '\\'; };
    const std::string name = files_.name();
    if (std::any_of(name.begin(), name.end(), is_odd)) {
      throw InputError(fmt::format("{}: sbatch cannot write to files of this name", files_.result()),
                       "name an output without quotes, backslashes and line ends");
    }
    for (const std::string& word : options_.further) {
      if (std::any_of(word.begin(), word.end(), [](unsigned char c) { return c < ' '; }))
        throw InputError("an option of sbatch has a line end in it", "leave it out");
    }
    if (!options_.further.empty() && options_.further.front().rfind('-', 0) != 0) {
      throw InputError(fmt::format("{}: this is not an option of sbatch", options_.further.front()),
                       "for example: -- --partition=long");
    }
  }

  std::string array_script() const { return fmt::format("{}.array.sh", files_.name()); }
  std::string merge_script() const { return fmt::format("{}.merge.sh", files_.name()); }
  std::string place(const std::string& script) const { return (fs::path(files_.folder()) / script).string(); }

  std::string array_text(const std::vector<std::uint64_t>& missing) const {
    const StudyOptions& study = options_.study;
    const int threads = std::max(study.threads, 1);
    std::string text =
        "#!/bin/bash\n"
        "# The parts of a study as a job array: each task computes one part into a file of its own. A part that is\n"
        "# there is not computed again, and one that was begun continues where it stopped, so that this can be "
        "submitted\n"
        "# again at any time, from the folder in which it lies, with: sbatch and its name.\n";
    text += directives("parts");
    text += fmt::format("#SBATCH --array={}\n#SBATCH --cpus-per-task={}\n", ranges(missing), threads);
    text += log_directive(fmt::format("part-%a-of-{}", study.parts));
    text += further();
    text += start();
    text += fmt::format(
        "part=$SLURM_ARRAY_TASK_ID\n"
        "growing={}$part-of-{}.growing\n"
        "# Where a task was put back into the queue, the one before may take a moment to end.\n"
        "if [ -e \"$growing\" ] && command -v flock >/dev/null; then flock --wait 600 \"$growing\" true; fi\n",
        shell_word((fs::path(files_.folder()) / (files_.name() + ".part-")).string()), study.parts);
    return text + fmt::format("exec {} study {} -o {} --shard \"$part/{}\" --threads {} --resume{}\n", program(),
                              shell_word(study.study_path), shell_word(study.output), study.parts, threads,
                              study.yes ? " --yes" : "");
  }

  std::string merge_text() const {
    return std::string(
               "#!/bin/bash\n"
               "# Joins the parts of a study when all are there; as a job, or started by hand.\n") +
           directives("merge") + log_directive("merge") + further() + start() +
           fmt::format("exec {} study merge {} -o {}\n", program(), shell_word(options_.study.study_path),
                       shell_word(options_.study.output));
  }

  /// Hands a script to sbatch, from the folder in which it lies. @returns the number of the job
  std::string submit(const std::string& script, const std::string& options) const {
    const std::string command = fmt::format("sbatch --parsable {}{}", options, shell_word("./" + script));
    const CommandOutput printed = output_of(fmt::format("cd -- {} && {}", shell_word(files_.folder()), command));
    std::istringstream lines(printed.text);
    for (std::string line; printed.exit_code == 0 && std::getline(lines, line);) {
      const std::string number = line.substr(0, line.find(';'));  // after it: the cluster's name
      if (!number.empty() && is_number(number)) return number;
    }
    throw FailedChecks(fmt::format("{}sbatch did not take {}; to try by hand, in {}: {}", printed.text, place(script),
                                   files_.folder(), command));
  }

 private:
  std::string directives(const std::string& what) const {
    std::string name = fmt::format("{}-{}", fs::path(options_.study.study_path).stem().string(), what);
    for (char& c : name) c = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' ? c : '_';
    // A task that is run again must not lose the lines of its first run.
    return fmt::format("#SBATCH --job-name={}\n#SBATCH --requeue\n#SBATCH --open-mode=append\n", name);
  }

  std::string log_directive(const std::string& tail) const {
    std::string pattern;
    for (const char c : files_.name()) pattern.append(c == '%' ? 2 : 1, c);
    return fmt::format("#SBATCH {}\n", sbatch_word(fmt::format("--output={}.{}.log", pattern, tail)));
  }

  std::string further() const {
    if (options_.further.empty()) return "";
    std::string line = "#SBATCH";
    for (const std::string& word : options_.further) line.append(" ").append(sbatch_word(word));
    return line.append("\n");
  }

  /// The folder and the surroundings in which the study was submitted: names of files are relative to it.
  static std::string start() {
    std::string text = fmt::format("set -eu\ncd -- {}\n", shell_word(fs::current_path().string()));
    for (const char* name : {"RINGFILM_DATA", "RINGFILM_KERNELS"}) {
      if (const char* value = std::getenv(name)) text += fmt::format("export {}={}\n", name, shell_word(value));
    }
    return text;
  }

  static std::string program() {
    std::error_code error;
    const fs::path own = fs::read_symlink("/proc/self/exe", error);
    return error ? "ringfilm" : shell_word(own.string());
  }

  const SubmitOptions& options_;
  const StudyFiles& files_;
};

void check_not_in_queue(const StudyFiles& files, const StudyOptions& options) {
  const auto jobs = StudyJobs::read(files);
  if (!jobs) return;
  const auto states = queue_states(*jobs);
  if (states ? states->empty() : options.yes) return;
  const bool has_merge = !jobs->merge.empty();  // not where sbatch did not take it
  const std::string reported =
      has_merge ? fmt::format("jobs {} and {}", jobs->array, jobs->merge) : "job " + jobs->array;
  if (!states) {
    throw InputError(fmt::format("squeue does not answer: {} of this study may be in the queue still", reported),
                     "try again when it does, or add --yes if they are surely gone");
  }
  throw InputError(fmt::format("this study is in the queue already, as {}", reported),
                   fmt::format("wait for {}, or: scancel {}{}{}", has_merge ? "them" : "it", jobs->array,
                               has_merge ? " " : "", jobs->merge));
}

std::string submit_merge(const SlurmStudy& slurm, const std::string& array) {
  try {
    return slurm.submit(slurm.merge_script(), fmt::format("--dependency=afterok:{} --kill-on-invalid-dep=yes ", array));
  } catch (const FailedChecks& refusal) {
    throw FailedChecks(fmt::format("{}\nthe parts are in the queue, as job {}; to take them back: scancel {}",
                                   refusal.what(), array, array));
  }
}

}  // namespace

void submit_study(const SubmitOptions& given) {
  if (given.engine != "slurm") {
    throw InputError(
        given.engine.empty() ? "no engine is named" : fmt::format("--engine {}: there is no such engine", given.engine),
        "--engine slurm is there; any other starts the same command for each part, see docs/manual/study.md");
  }
  SubmitOptions options = given;
  options.study.is_part = true;
  options.study.parts = given.parts;
  const StudyFiles files(options.study.output);
  const SlurmStudy slurm(options, files);
  slurm.check_names();
  const std::vector<std::uint64_t> missing = missing_parts(options.study, kUsualParts);
  if (missing.empty()) {
    std::cout << fmt::format("all {} parts are there; to join them: ringfilm study merge {} -o {}\n",
                             options.study.parts, word_to_copy(options.study.study_path),
                             word_to_copy(options.study.output));
    return;
  }
  if (!options.is_rehearsal) {
    if (!is_command("sbatch")) {
      throw InputError("sbatch, the command of Slurm that takes jobs, is not here",
                       "submit on a machine of the cluster; --dry-run only writes the scripts");
    }
    check_not_in_queue(files, options.study);
  }
  files.make_folder();
  const std::string array = slurm.place(slurm.array_script()), merge = slurm.place(slurm.merge_script());
  io::write_atomically(array, slurm.array_text(missing));
  io::write_atomically(merge, slurm.merge_text());
  if (options.is_rehearsal) {
    std::cout << fmt::format("--- {}\n{}--- {}\n{}--- nothing was submitted\n", array, slurm.array_text(missing), merge,
                             slurm.merge_text());
    return;
  }
  StudyJobs jobs;
  jobs.parts = options.study.parts;
  jobs.array = slurm.submit(slurm.array_script(), "");
  jobs.write(files);
  jobs.merge = submit_merge(slurm, jobs.array);
  jobs.write(files);
  std::cout << fmt::format(
      "job {}: {} of {} parts, {}\n"
      "job {}: joins them when all are done; where one fails, it is not run\n"
      "how far it is: ringfilm study status {} -o {}\n"
      "after a failure the same command again computes what is missing\n",
      jobs.array, missing.size(), options.study.parts, array, jobs.merge, word_to_copy(options.study.study_path),
      word_to_copy(options.study.output));
}

}  // namespace ringfilm::app
