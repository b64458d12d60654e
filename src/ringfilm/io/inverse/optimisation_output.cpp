#include "ringfilm/io/inverse/optimisation_output.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "ringfilm/io/result/record_json.hpp"

namespace ringfilm::io {
namespace {

using nlohmann::ordered_json;
using study::Optimisation;

/// The text of a choice without the quotes of TOML.
std::string plain_text(const std::string& toml) {
  const TomlValue value = parse_toml_value(toml);
  return value.kind == TomlValue::Kind::kText ? value.text : toml;
}

ordered_json variables_object(const Optimisation& problem, const study::Design& design) {
  ordered_json object = ordered_json::object();
  for (std::size_t j = 0; j < problem.variables.size(); ++j) object[problem.variables[j].name()] = design.values[j];
  const std::vector<std::size_t> chosen = problem.combination(design.combination);
  for (std::size_t k = 0; k < chosen.size(); ++k) {
    object[problem.choices[k].key] = plain_text(problem.choices[k].texts[chosen[k]]);
  }
  return object;
}

ordered_json design_object(const Optimisation& problem, const DesignQuantities& one) {
  ordered_json object = {{"variables", variables_object(problem, one.design)}};
  ordered_json objectives = ordered_json::array(), constraints = ordered_json::array();
  for (std::size_t k = 0; k < problem.objectives.size(); ++k) {
    objectives.push_back({{"quantity", problem.objectives[k].quantity.name}, {"value", one.design.objectives[k]}});
  }
  for (std::size_t k = 0; k < problem.constraints.size(); ++k) {
    const study::Constraint& constraint = problem.constraints[k];
    constraints.push_back({{"quantity", constraint.quantity.name},
                           {constraint.is_lower ? "at_least" : "at_most", constraint.limit},
                           {"value", one.design.constraints[k]}});
  }
  object["quantities"] = one.quantities;
  object["objectives"] = std::move(objectives);
  object["constraints"] = std::move(constraints);
  if (problem.points.size() == 1) return object;
  object["points"] = ordered_json::array();
  for (std::size_t p = 0; p < problem.points.size(); ++p) {
    object["points"].push_back({{"name", problem.points[p].name}, {"quantities", one.points[p]}});
  }
  return object;
}

ordered_json violated_array(const OptimisationDocument& document) {
  ordered_json list = ordered_json::array();
  if (!document.nearest) return list;
  const Optimisation& problem = document.file.problem;
  for (std::size_t k = 0; k < problem.constraints.size(); ++k) {
    const study::Constraint& constraint = problem.constraints[k];
    const double value = document.nearest->design.constraints[k], by = study::excess(constraint, value);
    if (by <= 0) continue;
    list.push_back({{"quantity", constraint.quantity.name},
                    {constraint.is_lower ? "at_least" : "at_most", constraint.limit},
                    {"reached", value},
                    {"by", by},
                    {"unit", constraint.quantity.unit}});
  }
  return list;
}

}  // namespace

std::vector<std::string> broken_constraints(const OptimisationDocument& document, const Units& units) {
  std::vector<std::string> words;
  if (!document.nearest) return words;
  const Optimisation& problem = document.file.problem;
  for (std::size_t k = 0; k < problem.constraints.size(); ++k) {
    const study::Constraint& constraint = problem.constraints[k];
    const cycle::Quantity& quantity = constraint.quantity;
    const double value = document.nearest->design.constraints[k], by = study::excess(constraint, value);
    if (by <= 0) continue;
    const auto shown = [&](double x) { return units.shown(x, quantity.unit, quantity.display_unit, 4); };
    const std::string distance = quantity.unit == "K" ? fmt::format("{:.4g} K", by) : shown(by);
    words.push_back(fmt::format("{} cannot be met: {} at the nearest design, {} {} {} = {}", quantity.name,
                                shown(value), distance, constraint.is_lower ? "below" : "above",
                                constraint.is_lower ? "at_least" : "at_most", shown(constraint.limit)));
  }
  return words;
}

std::string optimisation_json(const OptimisationDocument& document) {
  const Optimisation& problem = document.file.problem;
  ordered_json object = {{"title", problem.title}, {"feasible", document.best.has_value()}};
  object["best"] = document.best ? design_object(problem, *document.best) : ordered_json();
  if (document.nearest) object["nearest"] = design_object(problem, *document.nearest);
  object["violated"] = violated_array(document);
  if (problem.objectives.size() > 1) {
    object["front"] = ordered_json::array();
    for (const DesignQuantities& one : document.front) object["front"].push_back(design_object(problem, one));
  }
  object["binding"] = ordered_json::array();
  for (const std::size_t k : document.result.binding) {
    object["binding"].push_back(problem.constraints[k].quantity.name);
  }
  object["at_bounds"] = document.result.at_bounds;
  ordered_json units = ordered_json::object();
  for (const study::Variable& variable : problem.variables) units[variable.name()] = variable.unit;
  for (const study::Objective& one : problem.objectives) units[one.quantity.name] = one.quantity.unit;
  for (const study::Constraint& one : problem.constraints) units[one.quantity.name] = one.quantity.unit;
  object["units"] = std::move(units);
  object["designs"] = document.result.designs.size();
  object["cases_computed"] = document.n_computed;
  object["cases_stored"] = document.n_stored;
  put_provenance(this_program(), object);
  return json_text(object);
}

std::string designs_csv(const OptimisationDocument& document) {
  const Optimisation& problem = document.file.problem;
  const auto heading = [](const std::string& name, const std::string& unit) {
    return unit == "1" ? name : fmt::format("{} [{}]", name, unit);
  };
  std::string csv;
  const auto add = [&csv](const std::string& cell) { csv += (csv.empty() || csv.back() == '\n' ? "" : ",") + cell; };
  for (const study::ChoiceVariable& choice : problem.choices) add(choice.key);
  for (const study::Variable& variable : problem.variables) add(heading(variable.name(), variable.unit));
  for (const study::Objective& one : problem.objectives) add(heading(one.quantity.name, one.quantity.unit));
  for (const study::Constraint& one : problem.constraints) {
    add(heading(one.quantity.name + (one.is_lower ? "_at_least" : "_at_most"), one.quantity.unit));
  }
  add("feasible");
  csv += "\n";
  for (const study::Design& design : document.result.designs) {
    const std::vector<std::size_t> chosen = problem.combination(design.combination);
    for (std::size_t k = 0; k < chosen.size(); ++k) add(quoted(plain_text(problem.choices[k].texts[chosen[k]])));
    for (const double value : design.values) add(exact_text(value));
    for (std::size_t k = 0; k < problem.objectives.size(); ++k) {
      add(design.is_solved() ? exact_text(design.objectives[k]) : "");
    }
    for (std::size_t k = 0; k < problem.constraints.size(); ++k) {
      add(design.is_solved() ? exact_text(design.constraints[k]) : "");
    }
    add(study::is_feasible(problem, design) ? "1" : "0");
    csv += "\n";
  }
  return csv;
}

}  // namespace ringfilm::io
