#include "arguments.hpp"
#include "bindings.hpp"
#include "case_values.hpp"
#include "ringfilm/case/keys/case_fields.hpp"
#include "ringfilm/cycle/advice/note_topics.hpp"
#include "ringfilm/cycle/closure/static_closure.hpp"
#include "ringfilm/cycle/pack/gas_quantities.hpp"
#include "ringfilm/cycle/pack/oil_consumption.hpp"
#include "ringfilm/cycle/result/effort_quantities.hpp"
#include "ringfilm/cycle/result/result.hpp"
#include "ringfilm/io/case/shipped_oils.hpp"
#include "ringfilm/io/data/shipped_pairs.hpp"
#include "ringfilm/io/result/pack_sums.hpp"
#include "ringfilm/io/result/result_file.hpp"
#include "ringfilm/io/text/units.hpp"
#include "ringfilm/life/life_result.hpp"
#include "ringfilm/pad/pad_result.hpp"

namespace ringfilm::python {
namespace {

/// What `ringfilm pairs --json` prints.
py::dict shipped_library() {
  const io::Units units;
  return py::dict(from_json(io::pairs_json(io::shipped_pairs(units).pairs, io::shipped_surfaces(units))));
}

struct FieldRow {
  std::string key, unit, display_unit, active_when, help, example;
  py::object default_value;
  bool is_required;
  std::optional<std::pair<double, double>> range;
  std::vector<std::string> choices;
};

std::vector<FieldRow> fields() {
  std::vector<FieldRow> rows;
  for (const cycle::Field& field : cycle::case_fields()) {
    const auto blank = cycle::blank_case(field.uses.cycle ? cycle::Problem::kCycle : cycle::Problem::kPad);
    FieldRow row{field.key,
                 field.unit,
                 field.display_unit,
                 field.active_when,
                 field.help,
                 field.example,
                 py::none(),
                 cycle::is_required(field, blank),
                 {},
                 {}};
    if (!row.is_required) row.default_value = si_value(field, blank);
    if (field.range) row.range = {field.range->low, field.range->high};
    if (const auto* choice = std::get_if<cycle::ChoiceKind>(&field.kind)) row.choices = choice->names;
    rows.push_back(std::move(row));
  }
  return rows;
}

template <class Quantities>
std::vector<cycle::Quantity> plain(const Quantities& quantities) {
  return {quantities.begin(), quantities.end()};
}

py::dict quantities() {
  py::dict tables;
  tables["curve"] = plain(cycle::curve_quantities());
  tables["cycle"] = plain(cycle::cycle_quantities());
  tables["derived"] = plain(cycle::derived_quantities());
  tables["unrolled_curve"] = plain(cycle::unrolled_quantities());
  tables["unrolled_cycle"] = plain(cycle::unrolled_cycle_quantities());
  tables["pad"] = plain(pad::pad_quantities());
  tables["pad_width"] = plain(pad::width_quantities());
  tables["pad_front"] = plain(pad::front_quantities());
  tables["pad_film"] = pad::profile_quantities();
  tables["unrolled_field"] = plain(cycle::unrolled_fields());
  tables["strip"] = plain(cycle::strip_fields());
  tables["stroke"] = plain(cycle::stroke_films());
  tables["effort"] = plain(cycle::effort_quantities());
  tables["closure"] = plain(cycle::closure_quantities());
  tables["section"] = plain(cycle::section_quantities());
  tables["gas"] = plain(cycle::gas_sum_quantities());
  tables["gas_region"] = plain(cycle::gas_region_quantities());
  tables["gas_path"] = plain(cycle::gas_path_quantities());
  tables["gas_scalar"] = plain(cycle::gas_scalar_quantities());
  tables["gas_ring"] = plain(cycle::gas_ring_quantities());
  tables["pack_oil"] = plain(io::pack_oil_quantities());
  tables["oil_consumption"] = plain(cycle::oil_loss_quantities());
  tables["worn"] = plain(life::worn_quantities());
  return tables;
}

}  // namespace

void bind_tables(py::module_& module) {
  using cycle::Quantity;
  py::class_<FieldRow>(module, "Field", "One key of a case. Source: src/ringfilm/cycle/case/case_fields.hpp.")
      .def_readonly("key", &FieldRow::key, "Its name, for example engine.bore.")
      .def_readonly("unit", &FieldRow::unit, "SI unit; 1 for a plain number, empty for text.")
      .def_readonly("display_unit", &FieldRow::display_unit, "The unit in which people write it.")
      .def_readonly("default", &FieldRow::default_value,
                    "What holds where it is not stated, in SI; None: nothing does.")
      .def_readonly("is_required", &FieldRow::is_required, "Must a case state it, where it is in use?")
      .def_readonly("range", &FieldRow::range, "Smallest and largest value in SI; None: any.")
      .def_readonly("choices", &FieldRow::choices, "The values that it may have; empty where it is not a choice.")
      .def_readonly("active_when", &FieldRow::active_when, "When it is in use, as text; empty: always.")
      .def_readonly("help", &FieldRow::help, "One line: what it is, symbol, source if assumed.")
      .def_readonly("example", &FieldRow::example, "The right-hand side as one would write it in a case file.")
      .def(
          "__repr__", [](const FieldRow& self) { return "<ringfilm.Field " + self.key + ": " + self.help + ">"; },
          "Key and help.");
  py::class_<Quantity>(module, "Quantity", "Name, unit and meaning of a number in results.")
      .def_readonly("name", &Quantity::name, "The name used everywhere.")
      .def_readonly("unit", &Quantity::unit, "SI unit; degree for crank angles, 1 for plain numbers.")
      .def_readonly("display_unit", &Quantity::display_unit, "The unit in which people read it.")
      .def_readonly("long_name", &Quantity::long_name, "The name in full.")
      .def_readonly("symbol", &Quantity::symbol, "As in docs/theory.")
      .def_readonly("equation", &Quantity::equation, "Label in docs/theory; may be empty.")
      .def(
          "__repr__",
          [](const Quantity& self) {
            return "<ringfilm.Quantity " + self.name + " [" + self.unit + "]: " + self.long_name + ">";
          },
          "Name, unit and meaning.");
  module.def(
      "oils", [] { return py::list(from_json(io::oils_json(io::shipped_oils(io::Units())))); },
      R"(The shipped oils, a list of dicts as `ringfilm oils --json` prints them, SI units.

The key `grade` is a value of lubricant.grade, or None. At 150 degC by the law of temperature, without shear
thinning.)");
  module.def(
      "pairs", [] { return py::list(shipped_library()["pairs"]); },
      R"(The shipped pairs of coating and liner, a list of dicts as `ringfilm pairs --json` prints them, SI units.

The key `name` is a value of contact.friction_pair. `state` is "lubricated" or "dry": a dry coefficient is that of a
probe without oil, which orders surfaces and is not an input of an engine.)");
  module.def(
      "surface_classes",
      [] {
        py::dict all = shipped_library();
        all.attr("pop")("pairs");
        return all;
      },
      R"(The shipped classes of surfaces, {"liners": list of dicts, "rings": list of dicts}, SI units.

`state` is "new", "run-in" or "worn". Rpq, Rvq and Rmq of a liner and `roughness` of a ring, its Rq, are values of
[contact.plateau].)");
  module.def("fields", &fields, "All keys of a case, a list of Field in the order of a case file.");
  module.def(
      "note_topics",
      [] {
        std::vector<std::string> topics;
        for (const cycle::NoteTopic& topic : cycle::note_topics()) topics.push_back(topic.name);
        return topics;
      },
      "Topics of the notes on results, the most serious first.");
  module.def("quantities", &quantities,
             R"(All quantities of results, {table: list of Quantity}: "curve" over crank angle, "cycle" for the cycle as
a whole, "derived" constants of a case, "stroke" over the liner, "effort" of the integration; "unrolled_curve",
"unrolled_cycle", "unrolled_field" and "strip" of an unrolled film; "pad", "pad_width", "pad_front", "pad_film";
"closure" of a ring in its bore; "gas", "gas_region", "gas_path", "gas_scalar", "gas_ring", "pack_oil" of a pack;
"oil_consumption" of its studies; "worn" over a life.)");
  module.def(
      "_unit_scale",
      [](const std::string& display_unit, const std::string& unit) {
        const Scale scale = io::Units().scale(display_unit, unit);
        return py::make_tuple(scale.factor / scale.divisor, scale.offset);
      },
      py::arg("display_unit"), py::arg("unit"), "SI = value * first + second, of a value in the display unit.");
  module.def(
      "version",
      [] {
        const io::Provenance program = io::this_program();
        return program.program + " commit " + program.commit;
      },
      "Name, version and commit of the program that this is.");
}

}  // namespace ringfilm::python
