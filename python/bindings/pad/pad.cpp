#include <algorithm>

#include "arguments.hpp"
#include "array_view.hpp"
#include "dataset_writer.hpp"
#include "pad/pad_object.hpp"
#include "result_object.hpp"
#include "ringfilm/io/case/case_file.hpp"
#include "ringfilm/io/pad/pad_file_layout.hpp"
#include "ringfilm/io/pad/pad_netcdf.hpp"
#include "ringfilm/io/result/result_file.hpp"
#include "ringfilm/io/storage/atomic_file.hpp"

namespace ringfilm::python {
namespace {

/// The film at all instants: (time, x), with a width (time, y, x).
py::array film(const PadObject& self, std::vector<double> pad::Profile::*member) {
  const pad::PadResult& result = self.result();
  const auto& instants = result.y.empty() ? result.profiles : result.fields;
  std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(instants.size())};
  if (!result.y.empty()) shape.push_back(static_cast<py::ssize_t>(result.y.size()));
  shape.push_back(static_cast<py::ssize_t>(result.x.size()));
  py::array_t<double> values(shape);
  double* to = values.mutable_data();
  for (const pad::Profile& instant : instants) to = std::copy((instant.*member).begin(), (instant.*member).end(), to);
  return values;
}

void bind_film(py::class_<PadObject>&, const char*, const std::string&, double pad::Profile::*) {}
void bind_film(py::class_<PadObject>& type, const char* name, const std::string& doc,
               std::vector<double> pad::Profile::*member) {
  type.def_property_readonly(
      name, [member](const PadObject& self) { return film(self, member); }, doc.c_str());
}

py::dict values(const PadObject& self) {
  py::dict values;
  if (self.result().samples.empty()) return values;
  for (const auto& quantity : pad::reported_quantities(self.result()))
    values[py::str(quantity.name)] = self.result().samples.back().*quantity.value;
  return values;
}

py::tuple pad_dataset(const py::object& self) {
  DatasetWriter writer(self);
  io::put_pad(writer, self.cast<const PadObject&>().document());
  return py::make_tuple(writer.variables(), writer.attributes());
}

void bind_numbers(py::class_<PadObject>& type) {
  auto quantities = pad::pad_quantities();
  quantities.insert(quantities.end(), pad::width_quantities().begin(), pad::width_quantities().end());
  for (const auto& quantity : quantities) {
    const auto getter = [member = quantity.value](const py::object& self) {
      return column_view(self.cast<const PadObject&>().result().samples, member, self);
    };
    type.def_property_readonly(
        quantity.name.c_str(), py::cpp_function(getter),
        (quantity.long_name + " [" + quantity.unit + "], shape (time,). Source: docs/theory/pad.md.").c_str());
  }
  type.def_property_readonly(
      "x", [](const py::object& self) { return view(self.cast<const PadObject&>().result().x, self); },
      "Places along the pad [m], shape (x,); a step of the gap appears twice.");
  type.def_property_readonly(
      "y", [](const py::object& self) { return view(self.cast<const PadObject&>().result().y, self); },
      "Places across the pad [m], shape (y,); empty without a width.");
  for_each_member<pad::Profile>([&type](const auto& member) {
    bind_film(
        type, member.name,
        std::string(member.long_name) + " [" + member.unit + "], shape (time, x), with a width (time, y, x); a copy.",
        member.value);
  });
}

}  // namespace

void bind_pad(py::module_& module) {
  py::class_<PadObject> type(module, "PadResult",
                             R"(The film between a pad of stated shape and a flat surface that moves past it.

Numbers are arrays over time, of one instant for a steady film, per metre of width or the mean over it; forces of the
whole pad are the total_... ones. SI; read-only, without a copy. `values` holds those of the last instant.
Source: docs/theory/pad.md.)");
  bind_numbers(type);
  type.def_property_readonly("values", &values, "The numbers of the last instant, {name: float in SI}.");
  type.def_property_readonly(
      "title", [](const PadObject& self) { return self.document().title; }, "Title of the case, a str.");
  type.def_property_readonly(
      "complete", [](const PadObject& self) { return self.result().complete; },
      "False where the film could not be solved to the end.");
  type.def_property_readonly(
      "notes", [](const PadObject& self) { return notes_list(self.document().input_notes, self.result().notes); },
      "What one must know about this result: tuples (topic, sentence, how many times).");
  type.def(
      "write",
      [](const PadObject& self, const py::object& path) { io::write_pad(path_of("path", path), self.document()); },
      py::arg("path"), "Writes the same NetCDF file as `ringfilm run --output`. Raises OutputError.");
  type.def(
      "write_csv",
      [](const PadObject& self, const py::object& path) {
        io::write_atomically(path_of("path", path), io::pad_csv(self.result()));
      },
      py::arg("path"), "Writes the film along the pad as `ringfilm run --csv`. Raises OutputError.");
  type.def("_dataset", &pad_dataset, "Variables and attributes of the result file, for to_xarray.");
  type.def(
      "to_xarray", [](const py::object& self) { return plain_layer("ringfilm._frames", "pad_to_xarray")(self); },
      "The result as an xarray.Dataset over time, x and, with a width, y, as xarray reads it from the file of write(); "
      "SI.");
  type.def(
      "to_pandas",
      [](const py::object& self, const GivenText& units) {
        return plain_layer("ringfilm._frames", "pad_to_pandas")(self, units.value);
      },
      py::arg("units") = "attrs",
      "The numbers of all instants as a pandas.DataFrame, indexed by time [s]. units: as in Result.to_pandas.");
  type.def(
      "plot",
      [](const py::object& self, const GivenText& what, const py::object& axes, const py::object& label,
         const py::kwargs& style) {
        return plain_layer("ringfilm._plots", "plot_pad")(self, text_of("what", what.value, "film"), axes, label,
                                                          **style);
      },
      py::arg("what") = "film", py::arg("axes") = py::none(), py::arg("label") = py::none(),
      R"(Draws the pad with matplotlib, in units that go by the size of the numbers.

what: "film" (gap and pressure of the last instant), "film_thickness", "pressure", "film_content", or a number over time
    ("load").
axes, label, style: as in Result.plot; not for "film", which is two panels.
Returns the matplotlib.figure.Figure. Raises ValueError for what cannot be drawn.)");
  type.def(
      "__repr__",
      [](const PadObject& self) {
        return "<ringfilm.PadResult \"" + self.document().title +
               "\": " + std::to_string(self.result().samples.size()) + " instants>";
      },
      "Title and number of instants.");
  type.def(py::pickle(&pad_state, &pad_of_state));
}

}  // namespace ringfilm::python
