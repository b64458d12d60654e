#pragma once
#include <benchmark/benchmark.h>

#include <map>
#include <optional>
#include <string>

namespace ringfilm::benchmarks {

/// What the benchmarks reported, by name: of each the fastest of its repetitions.
class Figures {
 public:
  void take(const benchmark::BenchmarkReporter::Run& run);

  /// Processor time of one of what the benchmark counts [s].
  std::optional<double> seconds(const std::string& name) const;
  std::optional<double> counter(const std::string& name, const std::string& which) const;

 private:
  struct Fastest {
    double seconds;
    benchmark::UserCounters counters;
  };
  std::map<std::string, Fastest> fastest_;
};

/// Reports on standard error what is being measured, and keeps the figures.
class Collector : public benchmark::BenchmarkReporter {
 public:
  explicit Collector(Figures& figures) : figures_(figures) {}
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override;

 private:
  Figures& figures_;
};

}  // namespace ringfilm::benchmarks
