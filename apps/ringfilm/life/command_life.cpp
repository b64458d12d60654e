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

namespace ringfilm::app {
namespace {

io::LifeFile checked_life(const LifeOptions& options) {
  io::LifeFile file = io::read_life(options.life_path);
  if (options.output) check_suffix("--output", *options.output, OutputKind::kNetcdf);
  if (options.page) check_suffix("--html", *options.page, OutputKind::kPage);
  for (const auto& output : {options.output, options.page}) {
    if (!output) continue;
    io::check_can_write(*output, io::Sink::kFile);
    for (const cycle::InputFile& input : file.files) {
      if (!is_same_file(*output, input.path)) continue;
      throw InputError(*output + ": the output is a file that the life is read from", "name another file");
    }
  }
  return file;
}

/// A coating that is worn through ends a life before its last hours.
void check_end(const life::LifeResult& result) {
  if (!result.wear || !result.wear->worn_through) return;
  throw FailedChecks(fmt::format("the coating is worn through after {}; nothing later was computed",
                                 life::hours_text(result.wear->worn_through->time)));
}

}  // namespace

void run_life(const LifeOptions& options) {
  io::LifeDocument document{checked_life(options), {}, io::this_run()};
  const std::vector<io::OutputClaim> claimed = claims({options.output, options.page});
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
    if (options.output && is_worth_writing) std::cout << "wrote " << *options.output << "\n";
    if (options.page && is_worth_writing) std::cout << "wrote " << *options.page << "\n";
  }
  check_end(document.result);
}

}  // namespace ringfilm::app
