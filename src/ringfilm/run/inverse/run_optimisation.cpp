#include <cmath>
#include <utility>

#include "ringfilm/run/inverse/case_numbers.hpp"
#include "ringfilm/run/inverse/evaluator.hpp"
#include "ringfilm/run/inverse/run_inverse.hpp"

namespace ringfilm::run {
namespace {

using study::Design;

/// Computes the designs of an optimisation.
class DesignModel {
 public:
  DesignModel(const io::OptimisationFile& file, const study::VariedCases& cases, io::PointStore& store,
              const InverseOptions& options)
      : file_(file), cases_(cases), evaluate_(cases, {}, store, options.pulse) {}

  Design design(std::size_t combination, const std::vector<double>& places) const {
    Design design;
    design.combination = combination;
    design.places = places;
    design.values = study::values_at(cases_.variables(), places);
    std::vector<io::StoredPoint> points;
    for (std::size_t p = 0; p < file_.problem.points.size(); ++p) {
      points.push_back(evaluate_({file_.base(combination, p), design.values}));
      design.reason = points.back().reason;
      if (!design.is_solved()) return design;
    }
    for (const study::Objective& one : file_.problem.objectives) {
      design.objectives.push_back(value(one.quantity.name, one.over, points, design));
    }
    for (const study::Constraint& one : file_.problem.constraints) {
      design.constraints.push_back(value(one.quantity.name, one.over, points, design));
    }
    return design;
  }

  /// All that the cases of a design give; they are in the store.
  io::DesignQuantities quantities(const Design& design) const {
    io::DesignQuantities all{design, {}, {}};
    for (std::size_t p = 0; p < file_.problem.points.size(); ++p) {
      all.points.push_back(evaluate_({file_.base(design.combination, p), design.values}).values);
    }
    for (const auto& [name, first] : all.points.front()) {
      std::vector<double> values;
      for (const auto& point : all.points) {
        const auto found = point.find(name);
        values.push_back(found == point.end() ? NAN : found->second);
      }
      all.quantities[name] = study::over_points(study::OverPoints::kMean, file_.problem.points, values);
    }
    return all;
  }

 private:
  double value(const std::string& name, study::OverPoints over, const std::vector<io::StoredPoint>& points,
               Design& design) const {
    std::vector<double> values;
    for (const io::StoredPoint& point : points) {
      const auto found = point.values.find(name);
      if (found == point.values.end() || !std::isfinite(found->second)) {
        design.reason = "the case gives no " + name;
        return NAN;
      }
      values.push_back(found->second);
    }
    return study::over_points(over, file_.problem.points, values);
  }

  const io::OptimisationFile& file_;
  const study::VariedCases& cases_;
  Evaluator evaluate_;
};

}  // namespace

io::OptimisationFile read_optimisation(const std::string& path) {
  return io::read_optimisation(path, {value_quantities, curve_quantities});
}

io::OptimisationDocument run_optimisation(io::OptimisationFile file, io::PointStore& store,
                                          const InverseOptions& options) {
  const study::VariedCases cases(file.bases, file.problem.variables, file.compute);
  const DesignModel model(file, cases, store, options);
  const std::size_t n_before = store.n_added();
  io::OptimisationDocument document;
  document.result = study::optimise(
      file.problem, cases.own_places(),
      [&model](std::size_t combination, const std::vector<double>& places) {
        return model.design(combination, places);
      },
      options.threads);
  if (document.result.best) document.best = model.quantities(*document.result.best);
  if (document.result.nearest) document.nearest = model.quantities(*document.result.nearest);
  for (const Design& design : document.result.front) document.front.push_back(model.quantities(design));
  document.n_computed = store.n_added() - n_before;
  document.n_stored = store.n_read();
  document.file = std::move(file);
  return document;
}

cycle::Case case_of_design(const io::OptimisationFile& file, const Design& design, std::size_t point) {
  return study::VariedCases(file.bases, file.problem.variables, file.compute)
      .at(file.base(design.combination, point), design.values);
}

}  // namespace ringfilm::run
