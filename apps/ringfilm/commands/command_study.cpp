#include "commands/command_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <optional>
#include <set>

#include "commands/commands.hpp"
#include "faults.hpp"
#include "output_names.hpp"
#include "ringfilm/base/display.hpp"
#include "ringfilm/cycle/result/result.hpp"
#include "ringfilm/film/kernels/kernels.hpp"
#include "ringfilm/io/storage/atomic_file.hpp"
#include "ringfilm/io/storage/digest.hpp"
#include "ringfilm/io/storage/shard_file.hpp"
#include "ringfilm/io/study/study_file.hpp"
#include "ringfilm/io/study/study_netcdf.hpp"
#include "ringfilm/io/study/study_result.hpp"
#include "ringfilm/report/study_page.hpp"
#include "ringfilm/study/design/kept_curves.hpp"
#include "ringfilm/study/design/scenario.hpp"
#include "ringfilm/study/sampled_error.hpp"
#include "ringfilm/study/statistics/stopping_rule.hpp"
#include "ringfilm/study/study_run.hpp"
#include "stop_request.hpp"
#include "study/slurm_queue.hpp"
#include "study/study_files.hpp"
#include "study/study_part_status.hpp"
#include "study/study_progress.hpp"
#include "study/study_summary.hpp"

namespace ringfilm::app {
namespace {

namespace fs = std::filesystem;

/// A study that was read and found valid.
struct Loaded {
  io::StudyFile file;
  study::Plan plan;

  explicit Loaded(const std::string& path) : file(io::read_study(path)), plan(file.study) {
    study::check_scenarios(plan);
  }

  const std::optional<study::StoppingRule>& until() const { return file.study.sampling.until; }

  /// Takes the number of points from the rows, which alone show it in a study with `until`.
  void take_points_of(const io::ShardReader& rows) {
    if (until()) take_points(rows.next() / rows_of_a_point());
  }

  void take_points(std::uint64_t points) {
    file.study = study::with_points(file.study, points);
    plan = study::Plan(file.study);
  }

  std::uint64_t rows_of_a_point() const { return plan.points_per_row() * file.study.bases.size(); }

  io::Extension longer() const { return plan.can_grow() ? io::Extension::kAllowed : io::Extension::kRefused; }

  /// Are the rows found the first ones of this study, which has become longer since?
  bool continues_from(const io::ShardHeader& found, const io::ShardHeader& expected) const {
    return plan.can_grow() && io::is_beginning_of(found, expected);
  }

  std::vector<std::string> names_of_curves() const {
    std::vector<std::string> names;
    for (const study::KeptCurve& curve : study::kept_curves(plan.study())) names.push_back(curve.quantity.name);
    return names;
  }

  io::ShardHeader header(std::uint64_t part, std::uint64_t parts) const {
    const io::Provenance program = io::this_program();
    std::string inputs;
    std::set<std::string> known;  // a file may be reached by several names
    // The study's own file may be reworded: its content is part of the plan.
    for (const cycle::InputFile& input : file.files) {
      const std::string line = fmt::format("{} {}\n", input.role, input.sha256);
      if (input.role != "study" && known.insert(line).second) inputs += line;
    }
    const study::ScenarioRange range = study::shard_range(plan.most(), part, parts);
    return {io::sha256(plan.digest_text()),
            io::sha256(inputs),
            fmt::format("{} commit {} {}", program.program, program.commit, program.compiler),
            part,
            parts,
            range.first,
            range.end,
            plan.values().quantities.size(),
            names_of_curves(),
            study::kept_angles(plan.study().keep).size(),
            std::string(film::kernels().name)};
  }
};

std::string resume_command(const StudyOptions& options) {
  std::string command =
      fmt::format("ringfilm study {} -o {}", word_to_copy(options.study_path), word_to_copy(options.output));
  if (options.is_part) command += fmt::format(" --shard {}/{}", options.part, options.parts);
  if (options.threads > 0) command += fmt::format(" --threads {}", options.threads);
  return command + (options.yes ? " --yes" : "") + " --resume";
}

std::string resume_command(StudyOptions options, std::uint64_t part, std::uint64_t parts) {
  options.is_part = true;
  options.part = part;
  options.parts = parts;
  return resume_command(options);
}

void check_grid(const StudyOptions& options, const study::Plan& plan) {
  if (options.yes || plan.study().sampling.method != study::Method::kGrid || plan.size() <= study::kMaxGrid) return;
  throw InputError(fmt::format("the full grid has {} points, more than {}", plan.size(), study::kMaxGrid),
                   "add --yes if that is meant, or sample: method = \"sobol\"");
}

/// Curves of so many bytes are only kept where the user allows it.
constexpr double kMaxCurves = 2e9;

void check_curves(const StudyOptions& options, const study::Plan& plan) {
  const study::OutputSelection& keep = plan.study().keep;
  const double row = static_cast<double>(sizeof(float) * study::kept_curves(plan.study()).size()) *
                     static_cast<double>(study::kept_angles(keep).size());
  const double bytes = row * static_cast<double>(plan.most());
  if (options.yes || bytes <= kMaxCurves) return;
  throw InputError(
      fmt::format("the curves of {} scenarios take {:.1f} GB on the disk, and as much again where all are kept",
                  plan.most(), number_in(bytes, kGigabyte)),
      "add --yes if that is meant, or keep fewer quantities, a larger keep.crank_step, or curves = \"none\"");
}

void check_parts(const StudyOptions& options, const Loaded& study) {
  if (!study.until() || !options.is_part) return;
  throw InputError("a study with plan.until cannot be run in parts: whether it may stop depends on all of its rows",
                   "leave --shard out, or take until out of the plan");
}

void check_can_be_submitted(const StudyOptions& options, const Loaded& study) {
  if (!study.until()) return;
  throw InputError("a study with plan.until cannot be submitted: whether it may stop depends on all of its rows",
                   fmt::format("run it as one job, ringfilm study {} -o {} --resume, or take until out of the plan",
                               word_to_copy(options.study_path), word_to_copy(options.output)));
}

void check_outputs_apart(const StudyFiles& files, const Loaded& study) {
  Faults faults;
  for (const cycle::InputFile& input : study.file.files) {
    for (const std::string& output : files.outputs()) {
      if (!is_same_file(output, input.path)) continue;
      faults.refuse(output + ": the output is a file that the study is read from", "name another output");
    }
  }
  faults.check();
}

/// Computes the scenarios of a part up to before `end`.
void compute(const StudyOptions& options, const Loaded& study, io::ShardWriter& writer,
             const study::ScenarioRange& range, const StopRequest& stop) {
  StudyProgress progress(fs::path(options.study_path).stem().string(), writer.n_rows(), range.size());
  study::StudyRunOptions run_options;
  run_options.batch.threads = options.threads;
  run_options.order = study::RowOrder::kAsFinished;
  run_options.there = writer.beyond();
  const auto finished = [&](const study::ScenarioBlock& block) {
    try {
      writer.append(block);
    } catch (const OutputError& error) {
      throw OutputError(fmt::format("{}\n{} of {} scenarios are kept; free disk space, then: {}", error.what(),
                                    writer.n_rows(), range.size(), resume_command(options)));
    }
    progress.show(writer.n_rows(), writer.n_unsolved());
    return stop.is_made() ? study::Continuation::kNo : study::Continuation::kYes;
  };
  study::run_scenarios(study.plan, {writer.next(), range.end}, finished, run_options);
  if (writer.next() == range.end) return;
  throw stop.stopped(fmt::format("stopped: {} of {} scenarios are kept; to continue: {}", writer.n_rows(), range.size(),
                                 resume_command(options)));
}

/// Is a study with `until` sure enough with the rows that are there?
bool is_sure(const Loaded& study, const io::ShardReader& rows) {
  const study::StoppingRule& until = *study.until();
  std::vector<double> values;
  rows.append_values(*study.plan.values().index(until.value), values);
  return study::is_sure(until, study::interval_widths(study.plan, values));
}

/// Are all rows of a part there? Of a study with `until`: as many as it takes.
bool is_whole(Loaded study, const io::ShardReader& rows) {
  if (!study.until()) return rows.is_complete();
  const std::uint64_t points = rows.next() / study.rows_of_a_point();
  if (!rows.is_intact() || rows.next() % study.rows_of_a_point() != 0 || !study::is_look(study.file.study, points))
    return false;
  study.take_points(points);
  return points == study.until()->most || is_sure(study, rows);
}

/// Computes what is missing of a part, and of a study with `until` as much as it takes.
void compute_rows(const StudyOptions& options, Loaded& study, io::ShardWriter& writer, const std::string& path) {
  const io::ShardHeader header = study.header(options.part, options.parts);
  const StopRequest stop;
  if (!study.until()) return compute(options, study, writer, header.range(), stop);
  for (std::optional<std::uint64_t> points = study.file.study.sampling.scenarios; points;
       points = study::next_look(*study.until(), *points)) {
    study.take_points(*points);
    // What was there before is not computed again, and what is beyond was computed because it had to be.
    if (writer.next() > study.plan.size()) continue;
    compute(options, study, writer, {0, study.plan.size()}, stop);
    if (is_sure(study, io::ShardReader(path))) return;
  }
}

/// How far the rows of a part are. Rows of another study show it by the file name alone.
std::string state_text(const Loaded& study, const PartFile& file, const io::ShardReader& rows) {
  if (!file.is_finished) return "not finished";
  if (!rows.is_intact()) return "corrupted after these: --resume keeps them and computes the others again";
  const bool is_same = io::difference(rows.header(), study.header(file.part, file.parts)).empty();
  return is_same && !is_whole(study, rows) ? "not complete: --resume computes the others" : "finished";
}

void remove_rows(const std::string& path) {
  std::error_code error;
  fs::remove(path, error);
  if (error) throw OutputError(fmt::format("{}: could not be removed: {}", path, error.message()));
}

/// Computes a part and gives its rows their final name before another process can lock them.
/// @returns the rows of a study in one part, opened before another process can replace them
std::vector<io::ShardReader> compute_part(const StudyOptions& options, Loaded& study, const StudyFiles& files) {
  const std::string growing = files.growing(options.part, options.parts);
  io::ShardWriter writer(growing, study.header(options.part, options.parts), study.longer(),
                         options.overwrite ? io::Rows::kReplaced : io::Rows::kContinued);
  // Otherwise --resume would find the finished rows that are being replaced.
  if (options.overwrite) remove_rows(files.finished(options.part, options.parts));
  compute_rows(options, study, writer, growing);
  std::vector<io::ShardReader> rows;
  if (!options.is_part) rows.emplace_back(growing);
  writer.rename(files.finished(options.part, options.parts));
  return rows;
}

/// Integrates a sample of the scenarios again, which shows how accurate the rows are.
std::optional<study::SampledError> estimated_error(const StudyOptions& options, const io::StudyRows& rows) {
  const StopRequest stop;
  StudyProgress progress("accuracy", 0, study::sample_size(rows.plan));
  study::BatchOptions batch;
  batch.threads = options.threads;
  batch.pulse = [&] {
    if (stop.is_made()) {
      throw stop.stopped(fmt::format("stopped: all scenarios are kept; to continue: {}", resume_command(options)));
    }
  };
  return study::sampled_error(
      rows.plan, [&rows](std::uint64_t i) { return rows.row(i); },
      [&progress](int done, int) { progress.show(static_cast<std::uint64_t>(done), 0); }, batch);
}

/// Writes results and summary of a study of which all rows are there.
void write_results(const StudyOptions& options, const StudyFiles& files, const Loaded& study,
                   std::vector<io::ShardReader> shards) {
  io::StudyRows rows{study.file, study.plan, std::move(shards)};
  rows.error = estimated_error(options, rows);
  io::write_study_result(files.result(), rows);
  io::write_study_csv(files.table(), rows);
  io::write_atomically(files.page(), report::study_page(rows, io::Units(), io::this_program()));
  std::cout << study_summary(rows) << "\n";
  for (const std::string& output : files.outputs()) std::cout << "wrote " << output << "\n";
  std::uint64_t unsolved = 0;
  for (const io::ShardReader& shard : rows.shards) unsolved += shard.n_unsolved();
  if (unsolved == study.plan.size()) throw FailedChecks("not one scenario could be solved");
}

/// The parts that make up a study, in their order. Throws InputError for parts that are missing, unfinished or of
/// something else.
std::vector<io::ShardReader> joined_parts(const StudyOptions& options, const StudyFiles& files, const Loaded& study) {
  Faults faults;
  std::vector<io::ShardReader> shards;
  std::optional<std::uint64_t> parts;
  const auto resume_hint = [&](std::uint64_t part) {
    return *parts == 1 ? resume_command(options) : resume_command(options, part, *parts);
  };
  for (const PartFile& file : files.parts()) {
    if (!file.is_finished) continue;
    if (parts && *parts != file.parts) {
      throw InputError(fmt::format("{}: there are parts of {} and parts of {}", file.path, *parts, file.parts),
                       "delete those of one kind");
    }
    parts = file.parts;
    shards.emplace_back(file.path);
    const io::ShardHeader expected = study.header(file.part, file.parts);
    const io::ShardHeader& found = shards.back().header();
    const std::string differs = io::difference(found, expected);
    const bool may_continue = study.continues_from(found, expected);
    if (!differs.empty() && !may_continue) {
      faults.refuse(fmt::format("{}: these rows are of {}", file.path, differs), "compute this part anew");
    } else if (may_continue || !is_whole(study, shards.back())) {
      faults.refuse(fmt::format("{}: this part is not complete{}", file.path,
                                shards.back().is_intact() ? "" : ", since a block of it is corrupted"),
                    resume_hint(file.part));
    }
  }
  if (!parts) {
    throw InputError(fmt::format("{}: there is no finished part of a study", options.output),
                     "compute the parts first, for example with --shard 1/4");
  }
  for (std::uint64_t part = 1; part <= *parts; ++part) {
    if (fs::exists(files.finished(part, *parts))) continue;
    const bool is_begun = fs::exists(files.growing(part, *parts));
    faults.refuse(fmt::format("part {} of {} is {}", part, *parts, is_begun ? "not finished" : "missing"),
                  resume_hint(part));
  }
  faults.check();
  return shards;
}

/// Refuses an output with a study that is being computed, and without --resume or --overwrite one that is there: it may
/// have taken days.
void check_is_free(const StudyOptions& options, const StudyFiles& files, const Loaded& study) {
  const std::string growing = files.growing(options.part, options.parts);
  io::check_not_being_written(growing);
  const std::string finished = files.finished(options.part, options.parts);
  const bool has_rows = fs::exists(growing) || fs::exists(finished);
  if (options.overwrite || (options.resume && has_rows)) return;
  if (fs::exists(growing)) {
    throw InputError(fmt::format("{}: this study was not finished", growing),
                     "continue it with --resume, begin anew with --overwrite, or name another output");
  }
  if (fs::exists(finished)) {
    const std::string differs =
        io::difference(io::ShardReader(finished).header(), study.header(options.part, options.parts));
    throw InputError(fmt::format("{}: the output has a finished {} {}", finished,
                                 options.is_part ? "part of" : "study of", differs.empty() ? "this plan" : differs),
                     differs.empty() ? "--resume keeps its scenarios, --overwrite replaces it; or name another output"
                                     : "name another output, or replace it with --overwrite");
  }
  // The rows may be deleted once the results are written.
  Faults faults;
  for (const std::string& path : files.outputs()) {
    if (options.is_part || !fs::exists(path)) continue;
    faults.refuse(path + ": there are results already", "replace them with --overwrite, or name another output");
  }
  faults.check();
}

void check_can_write(const StudyFiles& files) {
  for (const std::string& output : files.outputs()) io::check_can_write(output, io::Sink::kFile);
}

}  // namespace

void run_study(const StudyOptions& options) {
  Loaded study(options.study_path);
  check_grid(options, study.plan);
  check_parts(options, study);
  check_curves(options, study.plan);
  const StudyFiles files(options.output);
  const std::string growing = files.growing(options.part, options.parts);
  const std::string finished = files.finished(options.part, options.parts);
  study.header(options.part, options.parts);  // there is such a part
  check_outputs_apart(files, study);
  check_is_free(options, files, study);
  files.make_folder();
  check_can_write(files);
  bool is_there = false;
  if (options.resume && fs::exists(finished)) {
    const io::ShardReader there(finished);
    const io::ShardHeader expected = study.header(options.part, options.parts);
    const std::string differs = io::difference(there.header(), expected);
    const bool may_continue = study.continues_from(there.header(), expected);
    if (!differs.empty() && !may_continue) {
      throw InputError(fmt::format("{}: these rows are of {}", finished, differs),
                       "results of both must not be mixed: name another output, or replace it with --overwrite");
    }
    is_there = !may_continue && is_whole(study, there);
    // Its rows, as far as they are intact, are the first ones of what is computed now. Where somebody else has begun
    // with that, they continue with their own.
    if (!is_there && !fs::exists(growing) && std::rename(finished.c_str(), growing.c_str()) != 0 && errno != ENOENT)
      io::fail_to_write(growing, errno);
  }
  std::vector<io::ShardReader> shards;
  if (!is_there) shards = compute_part(options, study, files);
  if (options.is_part) {
    std::cout << fmt::format("part {} of {} is {}: {}\n", options.part, options.parts,
                             is_there ? "there already" : "done", finished);
    return;
  }
  if (is_there) shards.emplace_back(finished);
  study.take_points_of(shards.front());
  try {
    write_results(options, files, study, std::move(shards));
  } catch (const OutputError& error) {
    throw OutputError(
        fmt::format("{}\nall scenarios are kept; free disk space, then: {}", error.what(), resume_command(options)));
  }
}

void merge_study(const StudyOptions& options) {
  Loaded study(options.study_path);
  const StudyFiles files(options.output);
  check_outputs_apart(files, study);
  std::vector<io::ShardReader> shards = joined_parts(options, files, study);
  study.take_points_of(shards.front());
  check_can_write(files);
  write_results(options, files, study, std::move(shards));
}

std::vector<std::uint64_t> missing_parts(StudyOptions& options, std::uint64_t usual) {
  const Loaded study(options.study_path);
  check_grid(options, study.plan);
  check_can_be_submitted(options, study);
  check_curves(options, study.plan);
  const StudyFiles files(options.output);
  check_outputs_apart(files, study);
  const std::vector<PartFile> there = files.parts();
  if (options.parts == 0) options.parts = there.empty() ? std::min(usual, study.plan.size()) : there.front().parts;
  if (options.parts > study.plan.size()) {
    throw InputError(fmt::format("--parts {}: the study has {} scenarios", options.parts, study.plan.size()),
                     "each part requires one at least");
  }
  Faults faults;
  std::set<std::uint64_t> finished;
  for (const PartFile& file : there) {
    if (file.parts != options.parts) {
      faults.refuse(fmt::format("{}: this is a part of {}, not of {}", file.path, file.parts, options.parts),
                    fmt::format("continue with --parts {}, name another output, or delete this file", file.parts));
      continue;
    }
    if (!file.is_finished) io::check_not_being_written(file.path);
    const io::ShardHeader expected = study.header(file.part, file.parts);
    // A header that was cut off contains nothing: the part is begun anew.
    if (!file.is_finished && fs::file_size(file.path) < io::size_without_rows(expected)) continue;
    const io::ShardReader rows(file.path);
    const std::string differs = io::difference(rows.header(), expected);
    if (!differs.empty() && !study.continues_from(rows.header(), expected)) {
      faults.refuse(fmt::format("{}: these rows are of {}", file.path, differs),
                    "results of both must not be mixed: name another output, or delete this file");
    } else if (differs.empty() && file.is_finished && rows.is_complete()) {
      finished.insert(file.part);
    }
  }
  faults.check();
  std::vector<std::uint64_t> missing;
  for (std::uint64_t part = 1; part <= options.parts; ++part) {
    if (!finished.contains(part)) missing.push_back(part);
  }
  return missing;
}

void print_study_status(const StudyOptions& options) {
  const Loaded study(options.study_path);
  const StudyFiles files(options.output);
  const std::vector<PartFile> parts = files.parts();
  std::cout << fmt::format("{}: {} scenarios\n", study.plan.study().title, study.plan.size());
  if (parts.empty()) std::cout << fmt::format("{} contains nothing of it\n", options.output);
  std::optional<std::uint64_t> last_parts, last_part;
  const std::optional<StudyJobs> jobs = StudyJobs::read(files);
  const PartStatus on_the_way(files, jobs);
  const auto print_missing = [&](std::uint64_t until) {
    for (std::uint64_t part = last_part.value_or(0) + 1; last_parts && part < until; ++part)
      std::cout << fmt::format("part {} of {}: not begun{}\n", part, *last_parts, on_the_way.of(part, *last_parts));
  };
  if (parts.empty() && jobs) last_parts = jobs->parts;
  for (const PartFile& file : parts) {
    if (last_parts && *last_parts != file.parts) {
      print_missing(*last_parts + 1);
      last_part.reset();
    }
    last_parts = file.parts;
    print_missing(file.part);
    last_part = file.part;
    std::string line;
    try {
      const io::ShardReader shard(file.path);
      const std::string differs = io::difference(shard.header(), study.header(file.part, file.parts));
      line = fmt::format("{} of {} scenarios, {} not solved, {}", shard.n_rows(), shard.header().range().size(),
                         shard.n_unsolved_rows(), state_text(study, file, shard));
      if (!differs.empty()) line += fmt::format("; these rows are of {}", differs);
      if (!file.is_finished)
        line += fmt::format("{}{}", last_change_text(file.path), on_the_way.of(file.part, file.parts));
      std::vector<io::ShardReader::Unsolved> unsolved;
      shard.append_unsolved(unsolved);
      constexpr std::size_t kReported = 3;
      for (std::size_t i = 0; i < std::min(unsolved.size(), kReported); ++i)
        line += fmt::format("\n  scenario {}: {}", unsolved[i].scenario, unsolved[i].reason);
      if (unsolved.size() > kReported) line += fmt::format("\n  and {} more", unsolved.size() - kReported);
    } catch (const InputError& error) {
      line = error.faults().front().message;
    }
    std::cout << fmt::format("part {} of {}: {}\n", file.part, file.parts, line);
  }
  if (last_parts) print_missing(*last_parts + 1);
  std::cout << on_the_way.of_merge();
}

}  // namespace ringfilm::app
