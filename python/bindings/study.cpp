#include <algorithm>
#include <cstdint>
#include <map>
#include <memory>

#include "arguments.hpp"
#include "array_view.hpp"
#include "errors.hpp"
#include "interpreter.hpp"
#include "record.hpp"
#include "result_object.hpp"
#include "ringfilm/cycle/advice/note_topics.hpp"
#include "ringfilm/io/study/factor_notes.hpp"
#include "ringfilm/io/study/study_file.hpp"
#include "ringfilm/io/study/study_result.hpp"
#include "ringfilm/study/design/kept_curves.hpp"
#include "ringfilm/study/design/scenario.hpp"
#include "ringfilm/study/sampled_error.hpp"
#include "ringfilm/study/scenario_note.hpp"
#include "ringfilm/study/statistics/sobol_indices.hpp"
#include "ringfilm/study/statistics/statistics.hpp"
#include "ringfilm/study/statistics/stopping_rule.hpp"
#include "ringfilm/study/study_run.hpp"
#include "ringfilm/study/study_words.hpp"

namespace ringfilm::python {
namespace {

using study::Plan;

/// A study that was read and found sound; shared by the study and its results.
struct Loaded {
  io::StudyFile file;
  Plan plan;

  explicit Loaded(io::StudyFile read) : file(std::move(read)), plan(file.study) { study::check_scenarios(plan); }
  const study::Study& study() const { return plan.study(); }
};

struct StudyObject {
  std::shared_ptr<const Loaded> loaded;
};

struct StudyResultObject {
  std::shared_ptr<const Loaded> loaded;
  std::vector<std::vector<double>> values;  ///< values of each cycle quantity over the scenarios
  std::vector<std::string> reasons;         ///< reason of each scenario; empty where it was solved
  std::vector<float> curves;                ///< curves that the study keeps: [scenario][quantity][angle]
  struct Note {
    study::ScenarioNote shown;             ///< note that comes before all others
    std::vector<std::uint32_t> scenarios;  ///< scenarios that carry the note
  };
  std::map<std::pair<std::size_t, std::string>, Note> notes = {};  ///< notes on single results, by rank and topic
  /// Discretisation error of the values, where the study estimates it.
  std::optional<study::SampledError> error = {};
};

std::vector<double> of_base(const StudyResultObject& self, std::size_t quantity, std::size_t base, bool sample_only) {
  const Plan& plan = self.loaded->plan;
  std::vector<double> values;
  for (std::uint64_t p = 0; p < plan.n_points(base); ++p) {
    if (!sample_only || plan.is_sample(p)) values.push_back(self.values[quantity][plan.scenario(base, p)]);
  }
  return values;
}

std::size_t quantity_index(const StudyResultObject& self, const std::string& name) {
  // As a result file has it, or as a study has it, where no curve can be meant.
  const std::string plain = name.rfind("cycle_", 0) == 0 ? name.substr(6) : name;
  if (const auto found = self.loaded->plan.values().index(plain)) return *found;
  throw UnknownKeyError("\"" + name + "\" is not a value of this study", "study.values lists them");
}

std::size_t quantity_index(const StudyResultObject& self, const GivenText& value) {
  return quantity_index(self, text_of("value", value.value, "fmep"));
}

std::size_t base_index(const Loaded& loaded, const GivenMaybeText& given) {
  const std::optional<std::string> name = maybe_text_of("base", given.value, "new");
  const auto& bases = loaded.study().bases;
  if (!name && bases.size() == 1) return 0;
  std::string names;
  for (std::size_t i = 0; i < bases.size(); ++i) {
    if (name && bases[i].name == *name) return i;
    names += (i == 0 ? "" : ", ") + bases[i].name;
  }
  throw InputError(name ? "there is no base \"" + *name + "\"" : "the study has several bases", "one of: " + names);
}

py::array points(const StudyObject& self) {
  const auto columns = io::factor_columns(self.loaded->plan);
  const auto rows = static_cast<py::ssize_t>(self.loaded->plan.size());
  py::array_t<double> all({rows, static_cast<py::ssize_t>(columns.size())});
  auto to = all.mutable_unchecked<2>();
  for (std::size_t j = 0; j < columns.size(); ++j) {
    for (py::ssize_t i = 0; i < rows; ++i) to(i, static_cast<py::ssize_t>(j)) = columns[j][i];
  }
  return all;
}

py::list factors(const Loaded& loaded) {
  py::list all;
  const auto variables = io::factor_variables(loaded.study());
  for (std::size_t j = 0; j < variables.size(); ++j) {
    const study::Factor& factor = loaded.study().factors[j];
    std::vector<std::string> keys, choices;
    for (const study::Target& target : factor.targets) keys.push_back(target.key);
    if (const auto* words = std::get_if<study::Choices>(&factor.variation)) {
      for (const study::Choice& choice : words->values) choices.push_back(choice.text);
    }
    py::dict one;
    one["name"] = factor.name;
    one["variable"] = variables[j];
    one["unit"] = factor.unit;
    one["keys"] = keys;
    one["choices"] = choices;
    one["source"] = factor.source;
    all.append(one);
  }
  return all;
}

py::list base_of_scenarios(const Loaded& loaded) {
  py::list names;
  for (std::uint64_t i = 0; i < loaded.plan.size(); ++i)
    names.append(loaded.study().bases[loaded.plan.base_of(i)].name);
  return names;
}

/// Computes what is missing of the scenarios of the result's plan.
void compute(StudyResultObject& result, int threads, const py::object& progress) {
  const Plan& plan = result.loaded->plan;
  const auto n = static_cast<std::size_t>(plan.size());
  const std::size_t n_there = result.reasons.size();
  result.reasons.resize(n);
  for (std::vector<double>& values : result.values) values.resize(n);
  study::StudyRunOptions options;
  options.batch.threads = threads;
  options.longest_wait = 0.2;
  const auto finished = [&](const study::ScenarioBlock& block) {
    for (std::size_t i = 0; i < block.rows.size(); ++i) {
      const std::size_t scenario = block.first + i;
      for (std::size_t q = 0; q < result.values.size(); ++q) result.values[q][scenario] = block.rows[i].values[q];
      result.reasons[scenario] = block.rows[i].reason;
      for (const cycle::Note& note : block.rows[i].notes) {
        const auto badness = block.has_cycle ? cycle::note_badness(note.topic, block.rows[i].values) : std::nullopt;
        const study::ScenarioNote one{scenario, note.message, badness};
        const auto [found, is_first] = result.notes.try_emplace({cycle::note_rank(note.topic), note.topic});
        if (is_first || one.comes_before(found->second.shown)) found->second.shown = one;
        found->second.scenarios.push_back(static_cast<std::uint32_t>(scenario));
      }
      // Rows come in their order.
      result.curves.insert(result.curves.end(), block.rows[i].curves.begin(), block.rows[i].curves.end());
    }
    const py::gil_scoped_acquire lock;
    if (!progress.is_none()) progress(block.first + block.rows.size(), n);
    return study::Continuation::kYes;
  };
  Interruptible all;
  options.batch.pulse = [&all] { all.pulse(); };
  all.run([&] { study::run_scenarios(plan, {n_there, plan.size()}, finished, options); });
}

StudyResultObject computed(const StudyObject& self, int threads, const py::object& progress) {
  StudyResultObject result{self.loaded, {}, {}, {}};
  result.values.resize(self.loaded->plan.values().quantities.size());
  compute(result, threads, progress);
  const std::optional<study::StoppingRule> until = self.loaded->study().sampling.until;
  if (!until) return result;
  const std::size_t value = quantity_index(result, until->value);
  std::optional<std::uint64_t> points = self.loaded->study().sampling.scenarios;
  while (!study::is_sure(*until, study::interval_widths(result.loaded->plan, result.values[value]))) {
    points = study::next_look(*until, *points);
    if (!points) break;
    io::StudyFile longer = result.loaded->file;
    longer.study = study::with_points(longer.study, *points);
    result.loaded = std::make_shared<const Loaded>(std::move(longer));
    compute(result, threads, progress);
  }
  return result;
}

StudyResultObject run(const StudyObject& self, int threads, const py::object& progress) {
  StudyResultObject result = computed(self, threads, progress);
  const auto own = [&result](std::uint64_t i) {
    std::vector<double> row;
    for (const std::vector<double>& values : result.values) row.push_back(values[i]);
    return row;
  };
  study::BatchOptions options;
  options.threads = threads;
  Interruptible all;
  options.pulse = [&all] { all.pulse(); };
  all.run([&] { result.error = study::sampled_error(result.loaded->plan, own, {}, options); });
  return result;
}

std::optional<py::dict> accuracy(const StudyResultObject& self) {
  if (!self.error) return std::nullopt;
  const study::SampledError& error = *self.error;
  const auto& quantities = self.loaded->plan.values().quantities;
  py::dict quantiles, reported;
  for (std::size_t i = 0; i < quantities.size(); ++i) {
    if (error.quantiles[i]) quantiles[py::str(quantities[i].name)] = *error.quantiles[i];
  }
  reported["scenarios"] = error.scenarios;
  reported["unsolved"] = error.n_unsolved;
  reported["asked"] = error.asked;
  reported["coverage"] = error.coverage();
  reported["relative_error"] = quantiles;
  return reported;
}

py::dict notes_by_topic(const StudyResultObject& self) {
  py::dict notes;
  for (const auto& [key, note] : self.notes)
    notes[py::str(key.second)] = py::make_tuple(note.shown.message, note.scenarios);
  return notes;
}

std::vector<std::string> plan_notes(const StudyResultObject& self) {
  std::vector<std::string> notes = self.loaded->plan.notes();
  io::FactorNotes factors(self.loaded->plan);
  const std::vector<std::size_t> columns = factors.columns();
  std::vector<double> row;
  for (std::size_t i = 0; i < self.reasons.size(); ++i) {
    row.clear();
    for (const std::size_t q : columns) row.push_back(self.values[q][i]);
    factors.add(i, row);
  }
  for (std::string& note : factors.notes()) notes.push_back(std::move(note));
  return notes;
}

py::dict statistics(const StudyResultObject& self, const GivenText& value, const GivenMaybeText& base) {
  const std::size_t b = base_index(*self.loaded, base);
  const bool is_sample = self.loaded->plan.is_sample(0);
  const std::vector<double> values = of_base(self, quantity_index(self, value), b, is_sample);
  const std::vector<double> sorted = study::sorted_values(values);
  py::dict reported;
  reported["count"] = sorted.size();
  reported["omitted"] = values.size() - sorted.size();
  if (const auto mean = study::mean_of(values)) {
    reported["mean"] = mean->value;
    reported["standard_error"] = mean->standard_error;
    reported["deviation"] = mean->deviation;
  }
  if (sorted.empty()) return reported;
  reported["lowest"] = sorted.front();
  reported["highest"] = sorted.back();
  py::dict quantiles, intervals;
  for (const double share : {0.05, 0.25, 0.5, 0.75, 0.95}) {
    const study::Quantile quantile = study::quantile_of(sorted, share);
    quantiles[py::float_(share)] = quantile.value;
    intervals[py::float_(share)] = py::make_tuple(quantile.low, quantile.high);
  }
  reported["quantiles"] = quantiles;
  reported["quantile_intervals"] = intervals;
  return reported;
}

py::list sobol(const StudyResultObject& self, const GivenText& value, const GivenMaybeText& base) {
  const Plan& plan = self.loaded->plan;
  if (self.loaded->study().sampling.indices == study::Indices::kNone) {
    throw InputError("the plan of this study has no points for Sobol indices",
                     "write indices = \"first-and-total\" into [plan]");
  }
  const auto values = of_base(self, quantity_index(self, value), base_index(*self.loaded, base), false);
  const auto found = study::sobol_indices(values, plan.groups().size());
  py::list rows;
  if (!found) return rows;
  const auto interval = [](const study::Interval& of) { return py::make_tuple(of.low, of.high); };
  for (std::size_t g = 0; g < plan.groups().size(); ++g) {
    py::dict row;
    row["factor"] = plan.groups()[g].name;
    row["first"] = found->first[g].value;
    row["first_interval"] = interval(found->first[g]);
    row["total"] = found->total[g].value;
    row["total_interval"] = interval(found->total[g]);
    rows.append(row);
  }
  return rows;
}

/// A curve of all scenarios, shape (scenario, crank_angle), without a copy.
py::array curves(const py::object& object, const GivenText& quantity) {
  const std::string name = text_of("quantity", quantity.value, "film_thickness");
  const auto& self = object.cast<const StudyResultObject&>();
  const std::vector<study::KeptCurve> kept = study::kept_curves(self.loaded->study());
  const std::size_t n_angles = study::kept_angles(self.loaded->study().keep).size();
  for (std::size_t q = 0; q < kept.size(); ++q) {
    if (kept[q].quantity.name != name) continue;
    const auto angles = static_cast<py::ssize_t>(n_angles);
    const auto row = static_cast<py::ssize_t>(kept.size() * n_angles * sizeof(float));
    return view(self.curves.data() + q * n_angles, {static_cast<py::ssize_t>(self.reasons.size()), angles},
                {row, static_cast<py::ssize_t>(sizeof(float))}, object);
  }
  throw InputError("the study keeps no curves of " + name, "write [keep] with curves and quantities into the study");
}

/// Variables as (dimensions, array, attributes), for to_xarray.
py::dict study_dataset(const py::object& object) {
  const auto& self = object.cast<const StudyResultObject&>();
  const py::tuple scenario = py::make_tuple("scenario");
  py::dict variables;
  const auto& quantities = self.loaded->plan.values().quantities;
  for (std::size_t q = 0; q < quantities.size(); ++q) {
    py::dict attributes;
    attributes["units"] = quantities[q].unit;
    attributes["long_name"] = quantities[q].long_name;
    if (self.error && self.error->quantiles[q]) {
      attributes["relative_error_95_percent"] = *self.error->quantiles[q];
    }
    variables[py::str(quantities[q].name)] = py::make_tuple(scenario, view(self.values[q], object), attributes);
  }
  const Plan& plan = self.loaded->plan;
  py::array_t<std::int8_t> sample(static_cast<py::ssize_t>(plan.size()));
  for (std::uint64_t i = 0; i < plan.size(); ++i)
    sample.mutable_at(static_cast<py::ssize_t>(i)) = plan.is_sample(plan.point_of(i)) ? 1 : 0;
  py::dict attributes;
  attributes["units"] = "1";
  attributes["long_name"] = study::kSampleWords;
  variables["sample"] = py::make_tuple(scenario, sample, attributes);
  return variables;
}

StudyObject read_study(const std::string& path) {
  return StudyObject{std::make_shared<const Loaded>(io::read_study(path))};
}

void bind_plan(py::module_& module) {
  py::class_<StudyObject>(module, "Study",
                          R"(Many scenarios of one or several cases: what varies, and how it is sampled.

A study is read from a file or a dict (docs/manual/study.md). len(study) is the number of its scenarios.
Source: docs/theory/study.md.)")
      .def(py::init([](const py::object& given) {
             if (!py::isinstance<py::dict>(given)) return read_study(path_of("study, if it is not a dict,", given));
             return plain_layer("ringfilm._notebook", "study_of")(given).cast<StudyObject>();
           }),
           py::arg("study"),
           R"(A study from the path of its file, or from a dict with the tables and keys of that file.

File names in a dict are relative to the working folder. Raises InputError with every fault.)")
      .def_static(
          "_read_in",
          [](const py::object& path, const py::object& folder) {
            const std::string name = path_of("path", path), of_names = path_of("folder", folder);
            return StudyObject{std::make_shared<const Loaded>(io::read_study(name, of_names))};
          },
          py::arg("path"), py::arg("folder"), "A study whose file names are relative to another folder.")
      .def_static(
          "read", [](const py::object& path) { return read_study(path_of("path", path)); }, py::arg("path"),
          "A study with its bases and all that they name. Raises InputError with every fault, as the program "
          "prints them.")
      .def(
          "__len__", [](const StudyObject& self) { return self.loaded->plan.size(); }, "How many scenarios.")
      .def_property_readonly(
          "title", [](const StudyObject& self) { return self.loaded->study().title; }, "Its title, a str.")
      .def_property_readonly(
          "bases",
          [](const StudyObject& self) {
            std::vector<std::string> names;
            for (const study::Base& base : self.loaded->study().bases) names.push_back(base.name);
            return names;
          },
          "Names of the base cases, a list of str.")
      .def_property_readonly(
          "factors", [](const StudyObject& self) { return factors(*self.loaded); },
          "What varies: dicts with name, variable (as in files), unit in SI, keys, choices, source of its scatter.")
      .def_property_readonly(
          "notes", [](const StudyObject& self) { return self.loaded->plan.notes(); },
          "What must be known about the plan, a list of str.")
      .def_property_readonly(
          "values", [](const StudyObject& self) { return self.loaded->plan.values().quantities; },
          "What each scenario has: a list of ringfilm.Quantity, by whose names a StudyResult is asked.")
      .def_property_readonly(
          "points", &points,
          "Numbers of the factors, shape (scenario, factor), in SI; of choices the index; NaN where a factor leaves "
          "its base as it is.")
      .def_property_readonly(
          "base_of", [](const StudyObject& self) { return base_of_scenarios(*self.loaded); },
          "Name of the base case of each scenario, a list.")
      .def(
          "to_pandas",
          [](const py::object& self, const GivenText& units) {
            return plain_layer("ringfilm._frames", "study_to_pandas")(self, units.value);
          },
          py::arg("units") = "attrs",
          "The plan as a pandas.DataFrame: one row a scenario, one column a factor, and the base. units: as in "
          "Result.to_pandas.")
      .def(
          "run",
          [](const py::object& self, const py::object& threads, const py::object& progress) {
            return run(self.cast<const StudyObject&>(), threads_of(threads), progress);
          },
          py::arg("threads") = py::none(), py::arg("progress") = py::none(),
          R"(Computes all scenarios, in memory; a study that must survive is run by `ringfilm study`.

threads: None, or 1 to 1024; the numbers do not depend on it. progress: called as progress(done, total) now and then.
Returns a StudyResult. Ctrl-C ends the run with KeyboardInterrupt. A scenario that cannot be solved is a row of NaN with
its reason. A plan with `until` continues until its interval is narrow enough: the result then has more scenarios than
this study, its own `study` is the plan as it ended, and `total` grows. Raises InputError.)")
      .def(
          "_repr_html_", [](const py::object& self) { return plain_layer("ringfilm._notebook", "table_html")(self); },
          "The table of to_pandas(), as a notebook shows it.")
      .def(
          "__repr__",
          [](const StudyObject& self) {
            return "<ringfilm.Study \"" + self.loaded->study().title +
                   "\": " + std::to_string(self.loaded->plan.size()) + " scenarios>";
          },
          "Title and number of scenarios.");
}

void bind_results(py::module_& module) {
  py::class_<StudyResultObject>(module, "StudyResult",
                                "Values of the cycle of all scenarios of a study. Source: docs/theory/study.md.")
      .def(
          "__len__", [](const StudyResultObject& self) { return self.reasons.size(); }, "How many scenarios.")
      .def_property_readonly(
          "study", [](const StudyResultObject& self) { return StudyObject{self.loaded}; }, "The Study.")
      .def_property_readonly(
          "unsolved",
          [](const StudyResultObject& self) {
            py::dict reasons;
            for (std::size_t i = 0; i < self.reasons.size(); ++i) {
              if (!self.reasons[i].empty()) reasons[py::int_(i)] = self.reasons[i];
            }
            return reasons;
          },
          "Why scenarios were not solved, {scenario from 0: reason}.")
      .def_property_readonly("notes", &notes_by_topic,
                             "The notes on single results, the most serious first, {topic: (message of the scenario "
                             "where it is worst, else of the first, list of scenarios from 0)}.")
      .def_property_readonly(
          "accuracy", &accuracy,
          R"(How accurate the values are: an estimate of a sample of the scenarios; None without a sample.

A dict: scenarios (from 0, that were compared), unsolved (how many others were drawn), asked (accuracies asked for [%]),
coverage (share of the sampled values within the accuracy asked for; None where none is), relative_error ({value: 95 %
quantile of its relative error}).
Source: docs/theory/error-estimate.md, eq-sampled-error.)")
      .def_property_readonly("plan_notes", &plan_notes,
                             "Notes on the plan, among them the factors that change no value, a list of str.")
      .def(
          "__getitem__",
          [](const py::object& self, const GivenText& name) {
            const auto& result = self.cast<const StudyResultObject&>();
            return view(result.values[quantity_index(result, name)], self);
          },
          py::arg("value"), "A value of the cycle over the scenarios, shape (scenario,), SI. Raises UnknownKeyError.")
      .def("curves", &curves, py::arg("quantity"),
           R"(A curve of all scenarios, shape (scenario, crank_angle), SI, single precision, without a copy.

Of a pack those of ring 2 are "ring_2_total_friction", and "total_friction" is that of all rings. Over crank_angle; NaN
where a scenario was not solved. Raises InputError unless the study keeps it ([keep] in its file).)")
      .def_property_readonly(
          "crank_angle",
          [](const StudyResultObject& self) {
            return py::array(py::cast(study::kept_angles(self.loaded->study().keep)));
          },
          "The axis of curves(), from -360 to below 360 [degree]; empty where no curves are kept.")
      .def("statistics", &statistics, py::arg("value"), py::arg("base") = py::none(),
           R"(Mean with its standard error, deviation, quantiles (5, 25, 50, 75, 95 %) with their 95 % intervals.

value: name of a value of the cycle. base: name of the base case, None where there is one. Returns a dict in SI; of a
plan that is not a sample (a grid, a list) only its order counts. Raises InputError. Source: docs/theory/study.md.)")
      .def("sobol_indices", &sobol, py::arg("value"), py::arg("base") = py::none(),
           R"(Which factor decides: first and total Sobol indices with their 95 % intervals.

value, base: as for statistics(). Returns a list of dicts, one a group of factors; empty where the value does not vary.
Raises InputError where the plan has no points for indices. Source: docs/theory/study.md, eq-first-index.)")
      .def("_dataset", &study_dataset, "Variables for to_xarray.")
      .def(
          "to_xarray",
          [](const py::object& self) { return plain_layer("ringfilm._frames", "study_result_to_xarray")(self); },
          "An xarray.Dataset over scenario, SI: base, factors and choices (as texts) as coordinates, kept curves over "
          "scenario, crank_angle and ring.")
      .def(
          "to_pandas",
          [](const py::object& self, const GivenText& units) {
            return plain_layer("ringfilm._frames", "study_result_to_pandas")(self, units.value);
          },
          py::arg("units") = "attrs",
          "A pandas.DataFrame: one row a scenario, columns base, factors, values of the cycle in SI, reason. units: as "
          "in Result.to_pandas.")
      .def(
          "_repr_html_", [](const py::object& self) { return plain_layer("ringfilm._notebook", "table_html")(self); },
          "The table of to_pandas(), as a notebook shows it.")
      .def(
          "__repr__",
          [](const StudyResultObject& self) {
            return "<ringfilm.StudyResult \"" + self.loaded->study().title +
                   "\": " + std::to_string(self.reasons.size()) + " scenarios>";
          },
          "Title and number of scenarios.");
}

}  // namespace

void bind_study(py::module_& module) {
  bind_results(module);  // first, so that the docstring of Study.run() can name what it returns
  bind_plan(module);
}

}  // namespace ringfilm::python
