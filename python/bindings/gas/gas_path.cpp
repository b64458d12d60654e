#include <memory>

#include "arguments.hpp"
#include "array_view.hpp"
#include "case_object.hpp"
#include "ringfilm/case/keys/case_fields.hpp"
#include "ringfilm/cycle/checks/case_rules.hpp"
#include "ringfilm/io/case/case_file.hpp"
#include "ringfilm/io/gas_path/gas_path_output.hpp"
#include "ringfilm/report/gas_page.hpp"
#include "ringfilm/run/run.hpp"

namespace ringfilm::python {
namespace {

/// Throws InputError with what is wrong with the gas of a case that was changed in memory.
void check_gas(const cycle::Case& c) {
  std::vector<Fault> faults;
  const auto add = [&faults](const std::vector<cycle::RuleBreach>& breaches) {
    for (const cycle::RuleBreach& breach : breaches) faults.push_back({{}, breach.message, breach.remedy});
  };
  for (const cycle::Case& ring : c.is_pack() ? c.rings : std::vector{c}) add(cycle::broken_gas_rules(ring));
  add(cycle::broken_pack_rules(c));
  if (!faults.empty()) throw InputError(std::move(faults));
}

cycle::Case case_for_gas(const py::object& given, const py::object& overrides) {
  if (!py::isinstance<CaseObject>(given)) {
    std::vector<io::Override> stated;
    for (const auto& [key, value] : texts_of("overrides", overrides, "1500 rpm")) stated.push_back({key, value});
    std::vector<io::DroppedKey> dropped;
    return io::read_case_dropping(path_of("case, if it is not a ringfilm.Case,", given), stated, io::Units(), dropped,
                                  io::CasePurpose::kGasPath);
  }
  if (!overrides.is_none())
    throw py::type_error("overrides go with the path of a case file; set the keys of a ringfilm.Case");
  cycle::Case c = py::cast<const CaseObject&>(given).value();
  check_gas(c);
  c.purpose = cycle::CasePurpose::kGasPath;
  for (cycle::Case& ring : c.rings) ring.purpose = c.purpose;
  return c;
}

py::array_t<double> column(const std::vector<std::vector<double>>& rows, std::size_t i) {
  py::array_t<double> values(static_cast<py::ssize_t>(rows.size()));
  for (std::size_t k = 0; k < rows.size(); ++k) values.mutable_at(static_cast<py::ssize_t>(k)) = rows[k][i];
  return values;
}

/// The record of the gas, and a function of its web page.
py::tuple gas_with_page(const py::object& given, const Given<kinds::MaybeTexts>& overrides) {
  const cycle::Case c = case_for_gas(given, overrides.value);
  const auto computed = std::make_shared<io::GasPathDocument>();
  {
    const py::gil_scoped_release others_go_on;
    *computed = std::get<io::GasPathDocument>(run::run_case(c).result);
  }
  const io::GasPathDocument& document = *computed;
  py::dict record = from_json(io::gas_path_json(document));
  const gas_path::GasPathResult& result = document.result;
  py::dict pressure, flow, position;
  for (std::size_t i = 0; i < result.regions.size(); ++i) {
    pressure[py::str(result.regions[i].name)] = column(result.pressure, i);
  }
  for (std::size_t i = 0; i < result.paths.size(); ++i) {
    flow[py::str(path_name(result.paths[i]))] = column(result.flow, i);
  }
  for (std::size_t i = 0; i < result.motion.size(); ++i) {
    if (result.motion[i].has_groove) position[py::int_(i + 1)] = column(result.position, i);
  }
  py::array_t<double> angle(static_cast<py::ssize_t>(result.pressure.size()));
  for (py::ssize_t k = 0; k < angle.size(); ++k) angle.mutable_at(k) = static_cast<double>(k);
  py::dict share;
  const std::vector<gas_path::ScalarValues>& scalars = document.gas.scalars;
  for (std::size_t i = 0; i < scalars.size(); ++i) {
    py::dict of_regions;
    for (std::size_t k = 0; k < result.regions.size(); ++k) {
      py::array_t<double> values(static_cast<py::ssize_t>(result.pressure.size()));
      for (std::size_t row = 0; row < result.pressure.size(); ++row) {
        values.mutable_at(static_cast<py::ssize_t>(row)) =
            document.gas.share[(row * result.regions.size() + k) * scalars.size() + i];
      }
      of_regions[py::str(result.regions[k].name)] = values;
    }
    share[py::str(scalars[i].name)] = of_regions;
  }
  record["curves"] = py::dict(py::arg("crank_angle") = angle, py::arg("pressure") = pressure, py::arg("flow") = flow,
                              py::arg("position") = position, py::arg("share") = share);
  const py::cpp_function page([computed] {
    const io::GasPathDocument& of = *computed;
    return report::gas_page({of.title, of.provenance, of.inputs, of.files, of.input_notes, of.notes, of.gas});
  });
  return py::make_tuple(record, page);
}

}  // namespace

void bind_gas_path(py::module_& module) {
  module.def("_gas_path", &gas_with_page, py::arg("case"), py::arg("overrides") = py::none(),
             "Record and page for ringfilm.gas_path: a dict, and a function of the text of the page.");
}

}  // namespace ringfilm::python
