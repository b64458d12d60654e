#include "life/command_life.hpp"

#include <fmt/format.h>

#include <iostream>

#include "life/life_summary.hpp"
#include "output_names.hpp"
#include "progress.hpp"
#include "ringfilm/film/kernels/kernels.hpp"
#include "ringfilm/io/life/life_output.hpp"
#include "ringfilm/io/storage/atomic_file.hpp"
#include "ringfilm/report/life_page.hpp"
#include "ringfilm/study/ensemble/cycle_integrators.hpp"
#include "text/shared_options.hpp"

namespace ringfilm::app {
namespace {

struct LifeOptions {
  std::string life_path;
  std::optional<std::string> output;  ///< NetCDF
  std::optional<std::string> page;    ///< web page
  SummaryForm summary = SummaryForm::kTable;
  int threads = 0;  ///< 0: as many as the machine runs at once
};

std::vector<NamedOutput> outputs_of(const LifeOptions& options) {
  return {{"--output", options.output, OutputKind::kNetcdf}, {"--html", options.page, OutputKind::kPage}};
}

io::LifeFile checked_life(const LifeOptions& options) {
  io::LifeFile file = io::read_life(options.life_path);
  Faults faults;
  check_names(outputs_of(options), faults);
  check_apart(outputs_of(options), file.files, "life", faults);
  faults.check();
  return file;
}

/// A coating that is worn through ends a life before its last hours.
void check_end(const life::LifeResult& result) {
  if (!result.wear || !result.wear->worn_through) return;
  throw FailedChecks(fmt::format("the coating is worn through after {}; nothing later was computed",
                                 life::hours_text(result.wear->worn_through->time)));
}

void run_life(const LifeOptions& options) {
  io::LifeDocument document{checked_life(options), {}, io::this_run()};
  const std::vector<io::OutputClaim> claimed = claims(outputs_of(options));
  document.provenance.kernels += fmt::format("; bands {} lanes", film::kernels().width);
  {
    ProgressLine line;
    const auto progress = [&](int ended, int total) {
      line.show(fmt::format("{}: {} of {} cycles", options.life_path, ended, total));
    };
    document.result = life::run_life(document.file.life, study::cycle_integrators({options.threads}, progress));
  }
  const bool is_worth_writing = !document.result.states.empty();
  if (options.output && is_worth_writing) io::write_life(*options.output, document);
  if (options.page && is_worth_writing) io::write_atomically(*options.page, report::life_page(document));
  if (options.summary == SummaryForm::kJson) {
    std::cout << io::life_json(document);
  } else {
    std::cout << life_summary(document);
    if (is_worth_writing) print_written(outputs_of(options));
  }
  check_end(document.result);
}

constexpr const char* kLifeFooter =
    "Examples:\n"
    "  ringfilm life cases/life/styles2014.toml\n"
    "  ringfilm life my_life.toml --json\n"
    "  ringfilm life my_life.toml --output my_life.nc --html my_life.html\n"
    "  ringfilm life faces new.toml run-in.toml embedded.toml\n"
    "What a life file holds: docs/manual/guide/life.md";

constexpr int kMaxWords = 64;

/// The command with the words that are alone: a life, or faces and cases.
struct LifeRequest : LifeOptions {
  std::vector<std::string> alone;
  bool has_faces() const { return alone.front() == "faces"; }
};

void declare_life(CommandOptions& add, LifeRequest& request) {
  add.text("LIFE.toml", request.alone, "", "the life's file; or faces, and cases whose faces are compared")
      ->required()
      ->expected(1, kMaxWords);
  const CLI::Option* output =
      add.text("-o,--output", request.output, "X.nc", "write all values over the hours as NetCDF");
  const CLI::Option* page = add.text("--html", request.page, "X.html", "write the same as a web page");
  add.json(request.summary, "print JSON, SI units, instead of the table");
  const CLI::Option* threads = add_threads(add, request.threads);

  add.rule([=, &request](Faults&) {
    request.life_path = request.alone.front();
    if (request.has_faces() && is_any_stated({output, page, threads})) {
      throw InputError("ringfilm life faces takes no other option than --json", "leave the others out");
    }
    if (!request.has_faces() && request.alone.size() > 1) {
      throw InputError("ringfilm life " + request.alone[1] + ": this is one word too many",
                       "one life at a time; ringfilm life faces A.toml B.toml compares faces");
    }
  });
}

void carry_out_life(const LifeRequest& request) {
  if (!request.has_faces()) return run_life(request);
  compare_faces({{request.alone.begin() + 1, request.alone.end()}, request.summary});
}

}  // namespace

void add_life_command(Program& program) {
  program.add("life", "Friction, oil and film of a ring over its running hours", kLifeFooter, declare_life,
              carry_out_life);
}

}  // namespace ringfilm::app
