#include "ringfilm/study/batch.hpp"

#include <optional>
#include <string>

#include "case_object.hpp"
#include "errors.hpp"
#include "result_object.hpp"
#include "ringfilm/film/kernels.hpp"
#include "run.hpp"

namespace ringfilm::python {
namespace {

enum class Curves { kAll, kNone };

Curves curves_of(const std::string& word) {
  if (word == "all") return Curves::kAll;
  if (word == "none") return Curves::kNone;
  throw InputError("curves = \"" + word + "\" is not known", "choose one of \"all\", \"none\"");
}

io::Provenance of_batch() {
  io::Provenance provenance = io::this_program();
  provenance.kernels = std::string(film::kernels().name) + ", " + std::to_string(film::kernels().width) + " lanes";
  return provenance;
}

/// Cases from an iterator, results into a list that is filled in any order.
class Batch {
 public:
  Batch(py::iterator cases, py::object total, Curves curves, py::object progress)
      : cases_(std::move(cases)), total_(std::move(total)), curves_(curves), progress_(std::move(progress)) {}

  py::list run(int threads) {
    {
      const py::gil_scoped_release others_go_on;
      study::simulate_cases([this] { return next(); }, [this](study::Ending ending) { put(std::move(ending)); },
                            {threads});
    }
    return results_;
  }

 private:
  std::optional<cycle::Case> next() {
    const py::gil_scoped_acquire lock;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    if (cases_ == py::iterator::sentinel()) return std::nullopt;
    const py::object one = py::reinterpret_borrow<py::object>(*cases_);
    if (!py::isinstance<CaseObject>(one)) {
      throw py::type_error("simulate_many takes cases, not " + py::cast<std::string>(py::repr(py::type::of(one))));
    }
    cycle::Case input = one.cast<const CaseObject&>().value();
    results_.append(py::none());
    inputs_.push_back(input);
    ++cases_;
    return input;
  }

  void put(study::Ending ending) {
    const py::gil_scoped_acquire lock;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    const std::size_t i = ending.index;
    std::string reason = ending.reason();
    if (curves_ == Curves::kNone) {
      cycle::CycleResult values;
      values.values = ending.result.values;
      values.unrolled_values = ending.result.unrolled_values;
      values.derived = std::move(ending.result.derived);
      values.notes = std::move(ending.result.notes);
      values.effort = ending.result.effort;
      values.complete = ending.result.complete;
      ending.result = std::move(values);
    }
    if (!ending.is_solved()) ending.result.complete = false;
    results_[i] = py::cast(std::make_unique<ResultObject>(std::move(inputs_[i].value()), std::move(ending.result),
                                                          provenance_, std::move(reason)));
    inputs_[i].reset();
    ++n_ended_;
    if (!progress_.is_none()) progress_(n_ended_, total_);
  }

  py::iterator cases_;
  py::object total_;
  Curves curves_;
  py::object progress_;
  io::Provenance provenance_ = of_batch();
  std::vector<std::optional<cycle::Case>> inputs_;  ///< of cases on their way
  py::list results_;
  std::size_t n_ended_ = 0;
};

py::list simulate_many(const py::object& cases, const py::object& threads, const py::object& progress,
                       const std::string& curves) {
  const py::object total = py::hasattr(cases, "__len__") ? py::object(py::int_(py::len(cases))) : py::none();
  return Batch(py::iter(cases), total, curves_of(curves), progress).run(threads_of(threads));
}

}  // namespace

void bind_batch(py::module_& module) {
  module.def("_simulate_many", &simulate_many, py::arg("cases"), py::arg("threads"), py::arg("progress"),
             py::arg("curves"), "Results of a batch, a list; see ringfilm.simulate_many.");
}

}  // namespace ringfilm::python
