#include <iostream>

#include "commands.hpp"
#include "output_names.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/io/atomic_file.hpp"
#include "ringfilm/io/overlay_file.hpp"
#include "ringfilm/io/result_file.hpp"
#include "ringfilm/report/html.hpp"

namespace ringfilm::app {
namespace {

void check_output_apart(const ReportOptions& options) {
  for (const auto& inputs : {options.results, options.overlays}) {
    for (const std::string& input : inputs) {
      if (is_same_file(input, options.output)) {
        throw InputError(options.output + ": the page would replace a file that it is drawn from", "name another file");
      }
    }
  }
}

}  // namespace

void report(const ReportOptions& options) {
  io::check_can_write(options.output, io::Sink::kFileOrDevice);
  check_output_apart(options);
  std::vector<io::ResultDocument> documents;
  for (const std::string& path : options.results) documents.push_back(io::read_result(path));
  std::vector<ringfilm::report::Overlay> overlays;
  const io::Units units;
  for (const std::string& path : options.overlays) {
    for (const io::OverlayCurve& curve : io::read_overlay(path, units)) {
      overlays.push_back({curve.name, curve.quantity, curve.source, curve.crank_angle_deg, curve.value});
    }
  }
  io::write_atomically(options.output, ringfilm::report::report_page(documents, overlays));
  std::cout << "wrote " << options.output << "\n";
}

}  // namespace ringfilm::app
