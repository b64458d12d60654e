#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <variant>

#include "arguments.hpp"
#include "array_view.hpp"
#include "dataset_writer.hpp"
#include "members.hpp"
#include "result_object.hpp"
#include "ringfilm/cycle/result/effort_quantities.hpp"
#include "ringfilm/io/case/case_file.hpp"
#include "ringfilm/io/result/result_csv.hpp"
#include "ringfilm/io/result/result_document.hpp"
#include "ringfilm/io/result/result_file.hpp"
#include "ringfilm/io/result/result_file_document.hpp"
#include "ringfilm/io/result/result_json.hpp"
#include "ringfilm/io/storage/atomic_file.hpp"
#include "ringfilm/io/text/suggestion.hpp"
#include "ringfilm/report/html.hpp"
#include "ringfilm/study/ensemble/ledger.hpp"

namespace ringfilm::python {
namespace {

std::string documented(const cycle::Quantity& quantity, const std::string& dimensions) {
  std::string text = quantity.long_name;
  if (!text.empty()) text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  text += " [" + quantity.unit + "]" + dimensions;
  if (!quantity.equation.empty()) text += " Source: docs/theory, " + quantity.equation + ".";
  return text;
}

/// The values of a table by their names.
template <class Quantities, class Values>
void put_values(const Quantities& quantities, const Values& of, py::dict& values) {
  for (const auto& quantity : quantities) values[py::str(quantity.name)] = of.*quantity.value;
}

py::dict values_of(const ResultObject& self) {
  py::dict values;
  put_values(cycle::cycle_quantities(), self.result().values, values);
  if (!self.result().unrolled.is_absent())
    put_values(cycle::unrolled_cycle_quantities(), self.result().unrolled_values, values);
  return values;
}

py::dict values_of(const PackObject& self) {
  py::dict values;
  put_values(cycle::summed_quantities(), self.result().values, values);
  return values;
}

/// The units of those values.
template <class Object>
py::dict units_of(const Object& self) {
  py::dict units;
  const py::dict values = values_of(self);
  const auto put = [&](const auto& quantities) {
    for (const cycle::Quantity& quantity : quantities) {
      if (values.contains(quantity.name)) units[py::str(quantity.name)] = quantity.unit;
    }
  };
  put(cycle::cycle_quantities());
  put(cycle::unrolled_cycle_quantities());
  return units;
}

py::list notes_of(const ResultObject& self) { return notes_list(self.document().input_notes, self.result().notes); }

/// Those of the rings, each with its ring.
py::list notes_of(const PackObject& self) {
  std::vector<cycle::Note> notes = self.result().notes;
  const std::vector<std::size_t> numbers = io::ring_numbers(self.document());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const io::ResultDocument& ring = self.document().rings[i];
    const std::string rail = ring.rail > 0 ? "." + std::to_string(ring.rail) : "";
    for (cycle::Note note : ring.result.notes) {
      note.message = "ring " + std::to_string(numbers[i]) + rail + ": " + note.message;
      notes.push_back(std::move(note));
    }
  }
  return notes_list(self.document().input_notes, notes);
}

py::list ledger(const ResultObject& self) {
  py::list lifted;
  for (const study::LedgerEntry& entry : self.document().ledger) {
    if (entry.variants.empty()) continue;
    py::list variants;
    for (const study::LedgerVariant& variant : entry.variants) {
      py::dict one = members_dict(variant), values;
      put_values(cycle::cycle_quantities(), variant.values, values);
      one["values"] = values;
      variants.append(one);
    }
    py::dict reported = members_dict(entry);
    reported["variants"] = variants;
    lifted.append(reported);
  }
  return lifted;
}

/// Every variable of the result file, as (dimensions, array, attributes).
template <class Object>
DatasetWriter dataset(const py::object& self) {
  DatasetWriter writer(self);
  io::put_document(writer, self.cast<const Object&>().document());
  return writer;
}

/// The variable that a name means; nothing if there is none.
std::optional<std::string> spelling_of(const std::string& name, const py::dict& variables) {
  for (const std::string& spelling : {name, "cycle_" + name, "derived_" + name}) {
    if (variables.contains(spelling)) return spelling;
  }
  return std::nullopt;
}

constexpr const char* kNameExample = "min_film_thickness";

py::object variable(const DatasetWriter& writer, const std::string& name) {
  const py::dict& variables = writer.variables();
  if (const auto spelling = spelling_of(name, variables)) return variables[py::str(*spelling)].cast<py::tuple>()[1];
  std::vector<std::string> names;
  for (const auto& entry : variables) names.push_back(py::cast<std::string>(entry.first));
  throw py::key_error("this result has no " + name + io::did_you_mean(name, names));
}

py::object item(const py::object& self, const GivenText& given) {
  const std::string name = text_of("name", given.value, kNameExample);
  const auto& result = self.cast<const ResultObject&>();
  for (const auto& quantity : cycle::curve_quantities()) {
    if (quantity.name == name) return column_view(result.result().samples, quantity.value, self);
  }
  return variable(dataset<ResultObject>(self), name);
}

std::string repr(const ResultObject& self) {
  std::string text = "<ringfilm.Result";
  if (!self.title().empty()) text += " \"" + self.title() + "\"";
  if (!self.reason().empty()) return text + ": not solved: " + self.reason() + ">";
  return text + ": " + std::to_string(self.result().samples.size()) + " crank angles" +
         (self.result().complete ? "" : ", stopped before the end of the cycle") + ">";
}

constexpr const char* kResultDoc =
    R"(What one engine cycle gave: curves over crank angle, values of the cycle, fields along the face, and all that one
must know about them.

Curves are attributes and items, numpy arrays of shape (crank_angle,) in SI without a copy, read-only:
result.min_film_thickness, result["min_film_thickness"]. Values of the cycle are attributes (result.fmep), unless a
curve has the same name, and all are in result.values. Every variable of a result file is an item by its name there.
Loads, friction and flow are those of the whole ring; signs: see docs/manual/result-file.md. Crank angles are in
degrees, 0 = firing TDC, from 0 to 720. Results can be pickled.)";

template <class Object>
py::object plot(const py::object& self, const GivenText& what, const py::object& axes, const py::object& label,
                const py::kwargs& style) {
  const char* function = std::is_same_v<Object, PackObject> ? "plot_pack" : "plot_result";
  return plain_layer("ringfilm._plots", function)(self, text_of("what", what.value, "film"), axes, label, **style);
}

/// What the results of a ring and of a pack have in common.
template <class Object>
void bind_document(py::class_<Object>& type) {
  type.def_property_readonly(
      "title", [](const Object& self) { return self.title(); }, "Title of the case, a str.");
  type.def_property_readonly(
      "values", [](const Object& self) { return values_of(self); },
      "All values of the cycle, of a pack what the friction of all rings adds up to, {name: float in SI}.");
  type.def_property_readonly(
      "units", [](const Object& self) { return units_of(self); }, "The units of `values`, {name: str}.");
  type.def_property_readonly(
      "notes", [](const Object& self) { return notes_of(self); },
      "What one must know about this result: tuples (topic, sentence, how many times).");
  type.def_property_readonly(
      "inputs",
      [](const Object& self) {
        py::list list;
        for (const auto& entry : self.document().inputs)
          list.append(py::make_tuple(entry.key, entry.value, entry.shown, entry.assumed));
        return list;
      },
      "The case as it was used: tuples (key, value as in a case file in SI, value for people, assumed).");
  type.def_property_readonly(
      "resolved_case", [](const Object& self) { return self.document().resolved_case; },
      "A complete case file in SI that gives the same bits again, a str.");
  type.def_property_readonly(
      "provenance", [](const Object& self) { return members_dict(self.document().provenance); },
      "What computed the result: program, commit, compiler, kernels.");
  type.def_property_readonly(
      "complete", [](const Object& self) { return self.result().complete; },
      "False where the integration stopped, or never began; the curves then hold what it had passed.");
  type.def(
      "write",
      [](const Object& self, const py::object& path) {
        const std::string name = path_of("path", path);
        const io::ResultDocument& document = self.document();
        const py::gil_scoped_release others_go_on;
        io::write_result(name, document);
      },
      py::arg("path"),
      "Writes the same NetCDF file as `ringfilm run --output`, byte by byte, aside first. Raises OutputError.");
  type.def(
      "write_csv",
      [](const Object& self, const py::object& path) {
        io::write_atomically(path_of("path", path), io::result_csv(self.document()));
      },
      py::arg("path"),
      "Writes the curves as `ringfilm run --csv`, of a pack with the column ring. Raises OutputError.");
  type.def(
      "write_report",
      [](const Object& self, const py::object& path) {
        io::write_atomically(path_of("path", path), report::report_page({self.document()}, {}));
      },
      py::arg("path"), "Writes the result as one self-contained web page, as `ringfilm report`. Raises OutputError.");
  type.def(
      "to_json", [](const Object& self) { return io::result_json(self.document()); },
      "The values of the cycle as `ringfilm run --json` prints them, a str.");
  type.def(
      "_dataset",
      [](const py::object& self) {
        const DatasetWriter writer = dataset<Object>(self);
        return py::make_tuple(writer.variables(), writer.attributes());
      },
      "Variables and attributes of the result file, for to_xarray.");
  type.def(
      "to_xarray",
      [](const py::object& self, const std::string& angles) {
        return plain_layer("ringfilm._frames", "result_to_xarray")(self, angles);
      },
      py::arg("angles") = "cycle",
      R"(The result as an xarray.Dataset with the dimensions, coordinates, variables and attributes of its file:
the same as xarray.open_dataset gives of what write() wrote, in SI, numbers without a copy.

angles: "cycle", crank angles from 0 to 720 degree as in the file, or "firing", from -360 to 360 with firing TDC in the
    middle, for .sel(crank_angle=-20). Raises ValueError for another word.)");
  type.def(
      "_ipython_key_completions_", [](const py::object& self) { return self.attr("keys")(); },
      "What a notebook completes in result[...].");
  type.def(
      "keys", [](const py::object& self) { return py::list(dataset<Object>(self).variables()); },
      "Names of all that [] gives, as in the result file, in its order.");
  type.def(
      "__contains__",
      [](const py::object& self, const py::object& name) {
        return py::isinstance<py::str>(name) &&
               spelling_of(text_of("name", name, kNameExample), dataset<Object>(self).variables()).has_value();
      },
      py::arg("name"), "Does [] give something for this name?");
}

/// Each quantity of a table as an array of its member of all rows.
template <class Quantities, class Rows>
void bind_columns(py::class_<ResultObject>& type, const Quantities& quantities, Rows cycle::CycleResult::*rows,
                  const char* dimensions) {
  for (const auto& quantity : quantities) {
    const auto getter = [member = quantity.value, rows](const py::object& self) {
      return column_view(self.cast<const ResultObject&>().result().*rows, member, self);
    };
    type.def_property_readonly(quantity.name.c_str(), py::cpp_function(getter),
                               documented(quantity, dimensions).c_str());
  }
}

void bind_values(py::class_<ResultObject>& type) {
  const auto& curves = cycle::curve_quantities();
  for (const auto& quantity : cycle::cycle_quantities()) {
    const auto is_same = [&](const auto& curve) { return curve.name == quantity.name; };
    const bool is_curve = std::any_of(curves.begin(), curves.end(), is_same);
    const auto getter = [member = quantity.value](const ResultObject& self) { return self.result().values.*member; };
    type.def_property_readonly(((is_curve ? "cycle_" : "") + quantity.name).c_str(), py::cpp_function(getter),
                               documented(quantity, ", a float; NaN where the cycle was not finished.").c_str());
  }
  for (const auto& quantity : cycle::unrolled_cycle_quantities()) {
    const auto getter = [member = quantity.value](const ResultObject& self) {
      return self.result().unrolled.is_absent() ? std::numeric_limits<double>::quiet_NaN()
                                                : self.result().unrolled_values.*member;
    };
    type.def_property_readonly(quantity.name.c_str(), py::cpp_function(getter),
                               documented(quantity, ", a float; NaN unless the film is unrolled.").c_str());
  }
}

void bind_words(py::class_<ResultObject>& type) {
  type.def_property_readonly(
      "derived", [](const ResultObject& self) { return self.result().derived; },
      "Constants that follow from the case, {name: float in SI}: composite modulus, elastic pressure and others.");
  type.def_property_readonly(
      "assumptions",
      [](const ResultObject& self) {
        py::list list;
        for (const auto& entry : self.document().ledger)
          list.append(py::make_tuple(entry.topic, entry.statement, entry.consequence, entry.source));
        return list;
      },
      "What the cycle takes for granted: tuples (topic, statement, consequence, source).");
  type.def_property_readonly("ledger", &ledger,
                             R"(What it would change to lift an assumption, if run(ledger=True) was asked to find out.

Dicts in the order of `assumptions`, of those that were lifted: topic, statement and the others, and variants, a list of
dicts: setting as one would write it, values {name: float in SI} of the cycle with this setting alone changed, solved,
reason (empty; why it was not solved, with NaN for values). Empty where it was not asked for.)");
  type.def_property_readonly(
      "effort",
      [](const ResultObject& self) {
        py::dict values;
        for (const cycle::EffortQuantity& quantity : cycle::effort_quantities()) {
          const py::str name(quantity.name);
          std::visit([&](auto member) { values[name] = self.result().effort.*member; }, quantity.value);
        }
        return values;
      },
      "What the solver did, {name: number}.");
  type.def_property_readonly(
      "reason", [](const ResultObject& self) { return self.reason(); },
      "Why a scenario of a batch was not solved, on one line; empty where it was.");
}

void bind_outputs(py::class_<ResultObject>& type) {
  type.def_static(
      "read", [](const py::object& path) { return result_object(io::read_result(path_of("path", path))); },
      py::arg("path"),
      "A result from a NetCDF file that this module or `ringfilm run` wrote; of a ring pack a PackResult. Raises "
      "InputError.");
  type.def(
      "to_pandas",
      [](const py::object& self, const GivenText& units) {
        return plain_layer("ringfilm._frames", "result_to_pandas")(self, units.value);
      },
      py::arg("units") = "attrs",
      R"(The curves as a pandas.DataFrame, one column a quantity in SI, indexed by crank angle [degree].

units: "attrs", the units in frame.attrs["units"] alone, or "columns", also in the names of the columns as in the CSV
    file: "gas_pressure [Pa]". Raises ValueError for another word.)");
  type.def(
      "plot", &plot<ResultObject>, py::arg("what") = "overview", py::arg("axes") = py::none(),
      py::arg("label") = py::none(),
      R"(Draws the result with matplotlib, in units of engineers, from -360 to 360 degree with firing TDC in the middle.

what: "overview" (pressure, film, friction), "friction", "film", "stribeck", or the name of a curve or of a field
    (curves of up to 8 angles, a map of more).
axes: a matplotlib Axes to draw into, in its next colour; a new figure without it. Not for "overview", "friction" and
    "film", which are several panels.
label: for a legend; title and speed of the case where axes is given.
style: arguments of matplotlib's plot(), of pcolormesh() for a map.
Returns the matplotlib.figure.Figure. Raises ValueError for what cannot be drawn.)");
  type.def("__getitem__", &item, py::arg("name"),
           R"(A curve, a value of the cycle or a field, by its name in the result file (docs/manual/result-file.md):
"film_pressure" has the shape (field_crank_angle, x). Raises KeyError.)");
  type.def(
      "__iter__", [](const py::object& self) { return py::iter(self.attr("keys")()); }, "Over keys().");
  type.def(
      "__len__", [](const py::object& self) { return py::len(self.attr("keys")()); }, "How many keys().");
  type.def("__repr__", &repr, "Title and number of crank angles.");
  type.def(
      "_repr_html_", [](const py::object& self) { return plain_layer("ringfilm._notebook", "result_html")(self); },
      "The values of the cycle that decide, as a notebook shows them.");
  type.def(py::pickle(
      [](const ResultObject& self) {
        return py::make_tuple(py::bytes(io::result_bytes(self.document())), self.reason());
      },
      [](const py::tuple& state) {
        io::ResultDocument document = io::result_of_bytes("a pickle", py::cast<std::string>(state[0]));
        return ResultObject(std::move(document), py::cast<std::string>(state[1]));
      }));
}

constexpr const char* kPackDoc =
    R"(What one engine cycle of a ring pack gave: a Result for each ring, and their sums.

pack.rings[0] is the ring next to the chamber. Every variable of the result file is an item by its name there, with the
dimension ring in front: pack["min_film_thickness"] has the shape (ring, crank_angle). Values are SI.)";

py::object pack_item(const py::object& self, const GivenText& given) {
  return variable(dataset<PackObject>(self), text_of("name", given.value, kNameExample));
}

/// The JSON document of a pack.
py::dict json_of(const PackObject& pack) { return from_json(io::result_json(pack.document())); }

/// A part of the document; None where it does not have the part.
std::optional<py::dict> part_of_json(const PackObject& pack, const char* name) {
  const py::dict document = json_of(pack);
  if (!document.contains(name)) return std::nullopt;
  return py::dict(document[name]);
}

void bind_pack(py::module_& module) {
  py::class_<PackObject> type(module, "PackResult", kPackDoc);
  bind_document(type);
  type.def_property_readonly(
      "rings",
      [](const PackObject& self) {
        py::list rings;
        for (const io::ResultDocument& ring : self.document().rings) {
          rings.append(py::cast(std::make_unique<ResultObject>(ring)));
        }
        return rings;
      },
      "The Result of each ring, from the chamber to the crankcase, a list.");
  type.def_property_readonly(
      "by_ring", [](const PackObject& self) { return py::list(json_of(self)["by_ring"]); },
      "The same of each ring, the rails of an oil ring added up, a list of dicts with its number as ring.");
  type.def_property_readonly(
      "gas",
      [](const py::object& self) -> py::object {
        const std::optional<py::dict> gas = part_of_json(self.cast<const PackObject&>(), "gas");
        return gas ? plain_layer("ringfilm._documents", "gas_of_pack")(self, *gas) : py::none();
      },
      "The gas between the rings of one cylinder, a GasPathResult, with what `ringfilm run --json` and `ringfilm gas "
      "--json` print as items: blow-by, regions, ring_events, ring_motion, paths; None where the pressures are given. "
      "Its curves are variables of the result, too: gas_region_pressure, gas_path_flow, ring_position.");
  type.def_property_readonly(
      "oil", [](const PackObject& self) { return part_of_json(self, "oil"); },
      "Film on the liner above the pack and all oil that the first ring leaves there, a dict in SI; None where the oil "
      "on "
      "the liner is not followed.");
  type.def_property_readonly(
      "oil_consumption", [](const PackObject& self) { return part_of_json(self, "oil_consumption"); },
      "Estimated oil consumption of one cylinder and its parts, a dict in SI as `ringfilm run --json` prints it: low, "
      "value, high and assumption, evaporation, scraped_up, carried_by_gas, thrown_off; None where the oil on the "
      "liner is not followed.");
  type.def("plot", &plot<PackObject>, py::arg("what") = "overview", py::arg("axes") = py::none(),
           py::arg("label") = py::none(),
           R"(Draws the rings with matplotlib, a line for each, in units of engineers over the crank angle.

what: "overview" (pressure, film, total friction), "friction", "film", "stribeck", or the name of a curve. A field
    belongs to one ring: pack.rings[0].plot("film_pressure").
axes, style: as in Result.plot. label: before the number of each ring in a legend.
Returns the matplotlib.figure.Figure. Raises ValueError for what cannot be drawn.)");
  type.def("__getitem__", &pack_item, py::arg("name"),
           R"(A variable of the result file by its name: "min_film_thickness" has the shape (ring, crank_angle),
"cycle_fmep" or "fmep" the shape (ring,). Raises KeyError.)");
  type.def(
      "__len__", [](const PackObject& self) { return self.document().rings.size(); }, "How many rings.");
  for (const cycle::CycleQuantity& quantity : cycle::summed_quantities()) {
    const auto getter = [member = quantity.value](const PackObject& self) {
      return self.document().result.values.*member;
    };
    type.def_property_readonly(quantity.name.c_str(), py::cpp_function(getter),
                               documented(quantity, " of all rings, a float; NaN where one stopped.").c_str());
  }
  type.def(
      "to_pandas",
      [](const py::object& self, const GivenText& units) {
        return plain_layer("ringfilm._notebook", "pack_to_pandas")(self, units.value);
      },
      py::arg("units") = "attrs",
      "The values of the cycle as a pandas.DataFrame in SI, a row each ring. units: as in Result.to_pandas.");
  type.def(
      "_repr_html_", [](const py::object& self) { return plain_layer("ringfilm._notebook", "pack_html")(self); },
      "The rings side by side, as a notebook shows them.");
  type.def(
      "__repr__",
      [](const PackObject& self) {
        return "<ringfilm.PackResult \"" + self.document().title +
               "\": " + std::to_string(self.document().rings.size()) + " rings>";
      },
      "Title and number of rings.");
  type.def(
      py::pickle([](const PackObject& self) { return py::make_tuple(py::bytes(io::result_bytes(self.document()))); },
                 [](const py::tuple& state) {
                   return PackObject(io::result_of_bytes("a pickle", py::cast<std::string>(state[0])));
                 }));
}

}  // namespace

py::object plain_layer(const char* module, const char* function) { return py::module_::import(module).attr(function); }

py::list notes_list(const std::vector<std::string>& of_input, const std::vector<cycle::Note>& of_result) {
  py::list list;
  for (const std::string& note : of_input) list.append(members_tuple(cycle::Note{"input", note}));
  for (const cycle::Note& note : of_result) list.append(members_tuple(note));
  return list;
}

py::object result_object(io::ResultDocument document) {
  if (document.is_pack()) return py::cast(std::make_unique<PackObject>(std::move(document)));
  return py::cast(std::make_unique<ResultObject>(std::move(document)));
}

ResultObject::ResultObject(cycle::Case input, cycle::CycleResult result, io::Provenance provenance, std::string reason)
    : input_(std::move(input)), reason_(std::move(reason)) {
  document_.result = std::move(result);
  document_.provenance = std::move(provenance);
}

const io::ResultDocument& ResultObject::document() const {
  if (input_) {
    io::Provenance provenance = std::move(document_.provenance);
    document_ = io::result_document(*input_, std::move(document_.result));
    document_.provenance = std::move(provenance);
    document_.ledger = study::assumptions(*input_);
    input_.reset();
  }
  return document_;
}

void bind_result(py::module_& module) {
  py::class_<ResultObject> type(module, "Result", kResultDoc);
  bind_document(type);
  bind_columns(type, cycle::curve_quantities(), &cycle::CycleResult::samples, ", shape (crank_angle,).");
  bind_columns(type, cycle::unrolled_quantities(), &cycle::CycleResult::unrolled_samples,
               ", shape (crank_angle,); empty unless the film is unrolled.");
  bind_values(type);
  bind_words(type);
  bind_outputs(type);
  bind_pack(module);
  module.def(
      "_write_text",
      [](const py::object& path, const std::string& text) { io::write_atomically(path_of("path", path), text); },
      py::arg("path"), py::arg("text"), "Writes a text file aside, then renames it. Raises OutputError.");
}

}  // namespace ringfilm::python
