#include "figures.hpp"

#include <cstdio>

namespace ringfilm::benchmarks {

void Figures::take(const benchmark::BenchmarkReporter::Run& run) {
  if (run.run_type != benchmark::BenchmarkReporter::Run::RT_Iteration || run.error_occurred) return;
  const double seconds = run.real_accumulated_time / static_cast<double>(run.iterations);
  const auto [at, is_first] = fastest_.try_emplace(run.run_name.function_name, Fastest{seconds, run.counters});
  if (!is_first && seconds < at->second.seconds) at->second = {seconds, run.counters};
}

std::optional<double> Figures::seconds(const std::string& name) const {
  const auto at = fastest_.find(name);
  if (at == fastest_.end()) return std::nullopt;
  return at->second.seconds;
}

std::optional<double> Figures::counter(const std::string& name, const std::string& which) const {
  const auto at = fastest_.find(name);
  if (at == fastest_.end()) return std::nullopt;
  const auto counter = at->second.counters.find(which);
  if (counter == at->second.counters.end()) return std::nullopt;
  return counter->second.value;
}

void Collector::ReportRuns(const std::vector<Run>& runs) {
  for (const Run& run : runs) {
    figures_.take(run);
    if (run.error_occurred) {
      std::fprintf(stderr, "%-44s %s\n", run.run_name.function_name.c_str(), run.error_message.c_str());
    } else if (run.run_type == Run::RT_Iteration) {
      std::fprintf(stderr, "%-44s %12.4f ms\n", run.run_name.function_name.c_str(),
                   1e3 * run.real_accumulated_time / static_cast<double>(run.iterations));
    }
  }
}

}  // namespace ringfilm::benchmarks
