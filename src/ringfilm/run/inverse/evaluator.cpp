#include "ringfilm/run/inverse/evaluator.hpp"

#include <algorithm>
#include <atomic>
#include <utility>

#include "ringfilm/film/kernels/kernels.hpp"
#include "ringfilm/io/storage/digest.hpp"
#include "ringfilm/run/inverse/case_numbers.hpp"
#include "ringfilm/study/design/scenario.hpp"
#include "ringfilm/study/ensemble/batch.hpp"
#include "ringfilm/study/ensemble/threads.hpp"

namespace ringfilm::run {
namespace {

/// Calls a function from within the integration.
class Pulse : public Observer {
 public:
  explicit Pulse(const std::function<void()>& pulse) : pulse_(pulse) {}
  void begins(const std::string&) override { beat(); }
  void advanced(int, double) override { beat(); }
  void advanced(double, double) override { beat(); }
  void others_ended(int, int) override { beat(); }

 private:
  void beat() const {
    if (pulse_) pulse_();
  }
  const std::function<void()>& pulse_;
};

}  // namespace

Evaluator::Evaluator(const study::VariedCases& cases, std::vector<std::string> curves, io::PointStore& store,
                     std::function<void()> pulse)
    : cases_(cases), curves_(std::move(curves)), store_(store), pulse_(std::move(pulse)) {
  const io::Provenance program = io::this_program();
  program_ = program.program + " " + program.commit + " " + program.compiler + " " + std::string(film::kernels().name);
  for (const std::string& curve : curves_) program_ += " " + curve;
}

io::StoredPoint Evaluator::operator()(const Trial& trial) const {
  if (pulse_) pulse_();
  io::StoredPoint point;
  cycle::Case c;
  try {
    c = cases_.at(trial.base, trial.values);
  } catch (const InputError& refusal) {
    point.reason = study::reason_of(refusal);
    return point;
  }
  const std::string key =
      io::sha256(program_ + (cases_.compute() == study::Compute::kGas ? " gas\n" : "\n") + study::digest_text(c));
  if (auto stored = store_.find(key)) return std::move(*stored);
  try {
    Pulse pulse(pulse_);
    CaseNumbers numbers = case_numbers(c, curves_, &pulse);
    point = {"", std::move(numbers.values), std::move(numbers.crank_angle_deg), std::move(numbers.curves)};
  } catch (const InputError& refusal) {
    point.reason = study::reason_of(refusal);
  } catch (const ConvergenceError& stop) {
    point.reason = stop.what();
  }
  store_.add(key, point);
  return point;
}

std::vector<io::StoredPoint> Evaluator::all(const std::vector<Trial>& trials, int threads) const {
  std::vector<io::StoredPoint> points(trials.size());
  std::atomic<std::size_t> next = 0;
  std::atomic<bool> has_ended = false;
  const int n = std::min(study::n_threads(threads), static_cast<int>(trials.size()));
  study::on_threads(std::max(n, 1), [&](int) {
    try {
      for (std::size_t i = next++; i < trials.size() && !has_ended; i = next++) points[i] = (*this)(trials[i]);
    } catch (...) {
      has_ended = true;
      throw;
    }
  });
  return points;
}

}  // namespace ringfilm::run
