#include <iostream>

#include "commands.hpp"
#include "ringfilm/io/atomic_file.hpp"
#include "ringfilm/io/overlay_file.hpp"
#include "ringfilm/io/result_file.hpp"
#include "ringfilm/report/html.hpp"

namespace ringfilm::app {

void report(const ReportOptions& options) {
  io::check_can_write(options.output, io::Sink::kFileOrDevice);
  std::vector<io::ResultDocument> documents;
  for (const std::string& path : options.results) documents.push_back(io::read_result(path));
  std::vector<ringfilm::report::Overlay> overlays;
  for (const std::string& path : options.overlays) {
    for (const io::MeasuredCurve& curve : io::read_overlay(path)) {
      overlays.push_back({curve.name, curve.quantity, curve.source, curve.crank_angle_deg, curve.value});
    }
  }
  io::write_atomically(options.output, ringfilm::report::report_page(documents, overlays));
  std::cout << "wrote " << options.output << "\n";
}

}  // namespace ringfilm::app
