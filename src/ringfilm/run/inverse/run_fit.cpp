#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "ringfilm/run/inverse/case_numbers.hpp"
#include "ringfilm/run/inverse/evaluator.hpp"
#include "ringfilm/run/inverse/run_inverse.hpp"

namespace ringfilm::run {
namespace {

using study::Measured;
using study::ModelOutput;

/// The model of a fit: all cases at values of the parameters.
class FitModel {
 public:
  FitModel(const io::FitFile& file, const study::VariedCases& cases, io::PointStore& store,
           const InverseOptions& options)
      : file_(file), cases_(cases), evaluate_(cases, curves_of(file), store, options.pulse), threads_(options.threads) {
    std::set<std::size_t> used = {0};
    for (const Measured& measured : file.problem.measured) used.insert(measured.bases.begin(), measured.bases.end());
    bases_.assign(used.begin(), used.end());
  }

  std::vector<std::optional<ModelOutput>> operator()(const std::vector<std::vector<double>>& places) {
    std::vector<Trial> trials;
    for (const std::vector<double>& at : places) {
      const std::vector<double> values = study::values_at(cases_.variables(), at);
      for (const std::size_t base : bases_) trials.push_back({base, values});
    }
    const std::vector<io::StoredPoint> points = evaluate_.all(trials, threads_);
    if (predicted_.empty()) find_predicted(points);
    std::vector<std::optional<ModelOutput>> outputs;
    for (std::size_t i = 0; i < places.size(); ++i) outputs.push_back(output(&points[i * bases_.size()]));
    return outputs;
  }

  const std::vector<cycle::Quantity>& predicted() const { return predicted_; }

 private:
  static std::vector<std::string> curves_of(const io::FitFile& file) {
    std::set<std::string> names;
    for (const Measured& measured : file.problem.measured) {
      if (measured.is_curve()) names.insert(measured.quantity.name);
    }
    return {names.begin(), names.end()};
  }

  /// The values of the case itself that are numbers; the same for all later trials.
  void find_predicted(const std::vector<io::StoredPoint>& points) {
    const std::vector<cycle::Quantity> known = value_quantities(cases_.base(0));
    for (std::size_t i = 0; i < points.size(); i += bases_.size()) {
      if (!points[i].reason.empty()) continue;
      for (const cycle::Quantity& quantity : known) {
        const auto value = points[i].values.find(quantity.name);
        if (value != points[i].values.end() && std::isfinite(value->second)) predicted_.push_back(quantity);
      }
      return;
    }
  }

  std::optional<ModelOutput> output(const io::StoredPoint* points) const {
    ModelOutput output;
    for (std::size_t k = 0; k < bases_.size(); ++k) {
      if (!points[k].reason.empty()) return std::nullopt;
    }
    const auto point_of = [&](std::size_t base) -> const io::StoredPoint& {
      return points[std::lower_bound(bases_.begin(), bases_.end(), base) - bases_.begin()];
    };
    for (const Measured& measured : file_.problem.measured) {
      std::vector<double>& values = output.values.emplace_back();
      std::vector<double>& axis = output.axes.emplace_back();
      if (measured.is_curve()) {
        const io::StoredPoint& point = point_of(measured.bases.front());
        const auto curve = point.curves.find(measured.quantity.name);
        if (curve == point.curves.end()) return std::nullopt;
        axis = point.crank_angle_deg;
        values = curve->second;
      } else {
        for (const std::size_t base : measured.bases) {
          const auto value = point_of(base).values.find(measured.quantity.name);
          if (value == point_of(base).values.end()) return std::nullopt;
          values.push_back(value->second);
        }
      }
      if (!std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); })) {
        return std::nullopt;
      }
    }
    for (const cycle::Quantity& quantity : predicted_) {
      const auto value = points[0].values.find(quantity.name);
      output.predicted.push_back(value == points[0].values.end() ? NAN : value->second);
    }
    return output;
  }

  const io::FitFile& file_;
  const study::VariedCases& cases_;
  Evaluator evaluate_;
  int threads_;
  std::vector<std::size_t> bases_;  ///< those that are measured, and the case itself; rising
  std::vector<cycle::Quantity> predicted_;
};

}  // namespace

io::FitFile read_fit(const std::string& path) { return io::read_fit(path, {value_quantities, curve_quantities}); }

io::FitDocument run_fit(io::FitFile file, io::PointStore& store, const InverseOptions& options) {
  const study::VariedCases cases(file.bases, {file.problem.parameters.begin(), file.problem.parameters.end()},
                                 file.compute);
  FitModel model(file, cases, store, options);
  const std::size_t n_before = store.n_added();
  io::FitDocument document;
  document.result =
      study::fit(file.problem, cases.own_places(), [&model](const auto& places) { return model(places); });
  std::vector<double> values;
  for (const study::FittedParameter& parameter : document.result.parameters) values.push_back(parameter.value);
  document.fitted = cases.at(0, values);
  document.predicted = model.predicted();
  document.n_computed = store.n_added() - n_before;
  document.n_stored = store.n_read();
  document.file = std::move(file);
  return document;
}

}  // namespace ringfilm::run
