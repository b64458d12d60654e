#include <numbers>

#include "arguments.hpp"
#include "case_object.hpp"
#include "ringfilm/case/keys/case_fields.hpp"
#include "ringfilm/cycle/checks/case_rules.hpp"
#include "ringfilm/instrument/documents/conformity.hpp"
#include "ringfilm/io/case/case_file.hpp"
#include "ringfilm/io/measurement/section_numbers.hpp"
#include "ringfilm/run/run.hpp"

namespace ringfilm::python {
namespace {

/// The static closure of a case that may be that of a cycle.
cycle::Case closure_of(const cycle::Case& c) {
  if (c.problem == cycle::Problem::kPad) {
    throw InputError("a pad has no ring that could close", "give the case of a ring");
  }
  cycle::Case of = c.rings.empty() ? c : c.rings.front();
  of.problem = cycle::Problem::kClosure;
  std::vector<Fault> faults;
  for (const cycle::RuleBreach& breach : cycle::broken_rules(of)) faults.push_back({{}, breach.message, breach.remedy});
  if (!faults.empty()) throw InputError(std::move(faults));
  return of;
}

cycle::Case closure_case(const py::object& given) {
  if (py::isinstance<CaseObject>(given)) return closure_of(py::cast<const CaseObject&>(given).value());
  std::vector<io::DroppedKey> dropped;
  return io::read_closure_case(path_of("case, if it is not a ringfilm.Case,", given), {}, io::Units(), dropped);
}

py::dict conform(const py::object& given) {
  const cycle::Case input = closure_case(given);
  const auto closure = std::get<cycle::StaticClosure>(run::run_case(input).result);
  const io::Measurement document = instrument::conformity_of_case(input, closure);
  py::dict of;
  of["title"] = document.title;
  for (const io::MeasuredGroup& group : document.groups) {
    for (const io::MeasuredValue& value : group.values) of[value.name.c_str()] = value.value;
  }
  for (const io::MeasuredTable& table : document.tables) {
    py::list rows;
    for (std::size_t i = 0; i < table.values.front().size(); ++i) {
      py::list row;
      for (const std::vector<double>& column : table.values) row.append(column[i]);
      rows.append(table.values.size() == 1 ? py::object(row[0]) : py::object(py::tuple(row)));
    }
    of[table.name.c_str()] = rows;
  }
  for (const instrument::ClosureColumn& column : instrument::closure_columns(closure)) {
    of[column.name.c_str()] = array_of(column.values);
  }
  if (closure.section) {
    py::dict section;
    for (const io::SectionNumbers& one : io::section_numbers(*closure.section)) {
      section[one.name.c_str()] =
          one.value.size() == 1 ? py::object(py::float_(one.value.front())) : py::cast(one.value);
    }
    of["section"] = section;
  }
  of["notes"] = document.notes;
  return of;
}

}  // namespace

void bind_conform(py::module_& module) {
  module.def("conform", &conform, py::arg("case"),
             R"(Static closure of the ring of a case in its bore: what `ringfilm conform` prints.

case: a ringfilm.Case, or the path of a case file, in which keys of film and cycle may be missing.

Returns a dict in SI, angles in degrees from the middle of the gap: max_clearance, max_clearance_angle, open_area,
contact_angle, mean_wall_force, share_in_points, moment_at_back, tangential_force, ..., contact_arcs as pairs,
contact_points, point_forces as pairs of angle and force, pressure_orders as triples of order, amplitude over the mean
and phase, and arrays around the ring: angle, bore, clearance, line_force, cumulative_force, moment, target_force,
free_angle and free_radius of the free ring. With ring.free_shape also free_shape_smoothing, free_shape_orders,
free_shape_residual, force_deviation and pressure_deviation; with ring.section or ring.section_form also section, a
dict of its area, centroid, second moments, torsion constant and assembly twist. Raises InputError, ConvergenceError,
TypeError.
Source: docs/theory, eq-closure-complementarity.)");
}

}  // namespace ringfilm::python
