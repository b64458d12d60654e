#include "ringfilm/study/ensemble/batch.hpp"

#include <optional>
#include <string>

#include "arguments.hpp"
#include "case_object.hpp"
#include "errors.hpp"
#include "interpreter.hpp"
#include "result_object.hpp"
#include "ringfilm/cycle/cycle_values.hpp"
#include "ringfilm/film/kernels/kernels.hpp"

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
    Interruptible batch;
    study::BatchOptions options;
    options.threads = threads;
    options.pulse = [&batch] { batch.pulse(); };
    batch.run([&] {
      study::simulate_cases([this] { return next(); }, [this](study::Ending ending) { end(std::move(ending)); },
                            options);
    });
    return results_;
  }

 private:
  /// A case of the batch, and the place of its result.
  struct Given {
    std::size_t place;
    cycle::Case input;
  };

  std::optional<cycle::Case> next() {
    const py::gil_scoped_acquire lock;
    for (; cases_ != py::iterator::sentinel(); ++cases_) {
      const py::object one = py::reinterpret_borrow<py::object>(*cases_);
      if (!py::isinstance<CaseObject>(one)) {
        throw py::type_error("simulate_many takes cases, not " + py::cast<std::string>(py::repr(py::type::of(one))));
      }
      auto& object = one.cast<CaseObject&>();
      Given given{results_.size(), object.value()};
      results_.append(py::none());
      try {
        check(object);
      } catch (const InputError& refusal) {
        study::Ending ending{0, {}, std::nullopt, refusal};
        ending.result.values = cycle::no_cycle_values();
        put(std::move(given), std::move(ending));
        continue;
      }
      cycle::Case input = given.input;
      given_.push_back(std::move(given));
      ++cases_;
      return input;
    }
    return std::nullopt;
  }

  static void check(CaseObject& one) {
    if (one.value().problem == cycle::Problem::kPad) {
      throw InputError("this is a pad, which has no engine cycle", "run it by itself: case.run()");
    }
    if (one.value().is_pack()) {
      throw InputError("this is a ring pack; a batch takes cases of one ring", "give case.rings, or run it by itself");
    }
    one.check();
  }

  void end(study::Ending ending) {
    const py::gil_scoped_acquire lock;
    std::optional<Given>& given = given_[ending.index];
    put(std::move(*given), std::move(ending));
    given.reset();
  }

  void put(Given given, study::Ending ending) {
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
    results_[given.place] = py::cast(std::make_unique<ResultObject>(std::move(given.input), std::move(ending.result),
                                                                    provenance_, std::move(reason)));
    ++n_ended_;
    if (!progress_.is_none()) progress_(n_ended_, total_);
  }

  py::iterator cases_;
  py::object total_;
  Curves curves_;
  py::object progress_;
  io::Provenance provenance_ = of_batch();
  std::vector<std::optional<Given>> given_;  ///< those on their way, in the order of the batch
  py::list results_;
  std::size_t n_ended_ = 0;
};

py::list simulate_many(const py::object& cases, const py::object& threads, const py::object& progress,
                       const GivenText& curves) {
  const py::object total = py::hasattr(cases, "__len__") ? py::object(py::int_(py::len(cases))) : py::none();
  return Batch(py::iter(cases), total, curves_of(text_of("curves", curves.value, "all")), progress)
      .run(threads_of(threads));
}

}  // namespace

void bind_batch(py::module_& module) {
  module.def("_simulate_many", &simulate_many, py::arg("cases"), py::arg("threads"), py::arg("progress"),
             py::arg("curves"), "Results of a batch, a list; see ringfilm.simulate_many.");
}

}  // namespace ringfilm::python
