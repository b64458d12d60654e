#include <fmt/format.h>

#include <filesystem>
#include <iostream>

#include "command_options.hpp"
#include "commands/commands.hpp"
#include "exit_codes.hpp"
#include "inverse/inverse_files.hpp"
#include "ringfilm/base/joined.hpp"
#include "ringfilm/io/inverse/case_elsewhere.hpp"
#include "ringfilm/io/storage/atomic_file.hpp"
#include "ringfilm/run/inverse/run_inverse.hpp"
#include "stop_request.hpp"
#include "text/shared_options.hpp"

namespace ringfilm::app {
namespace {

/// The values of a design: a row of each variable, objective and constraint.
std::string design_table(const io::OptimisationFile& file, const study::Design& design) {
  const io::Units units;
  const study::Optimisation& problem = file.problem;
  std::vector<std::vector<std::string>> rows;
  const std::vector<std::size_t> chosen = problem.combination(design.combination);
  for (std::size_t k = 0; k < chosen.size(); ++k) {
    rows.push_back({problem.choices[k].key, problem.choices[k].texts[chosen[k]], ""});
  }
  for (std::size_t j = 0; j < problem.variables.size(); ++j) {
    const study::Variable& variable = problem.variables[j];
    const auto in_units = [&](double x) { return units.shown(x, variable.unit, variable.display_unit, 6); };
    rows.push_back({variable.name(), in_units(design.values[j]),
                    "from " + in_units(variable.lower) + " to " + in_units(variable.upper)});
  }
  for (std::size_t k = 0; k < problem.objectives.size(); ++k) {
    const study::Objective& one = problem.objectives[k];
    rows.push_back({one.quantity.name,
                    units.shown(design.objectives[k], one.quantity.unit, one.quantity.display_unit, 6),
                    one.goal == study::Goal::kMinimise ? "minimised" : "maximised"});
  }
  for (std::size_t k = 0; k < problem.constraints.size(); ++k) {
    const study::Constraint& one = problem.constraints[k];
    const auto in_units = [&](double x) { return units.shown(x, one.quantity.unit, one.quantity.display_unit, 6); };
    rows.push_back({one.quantity.name, in_units(design.constraints[k]),
                    (one.is_lower ? "at least " : "at most ") + in_units(one.limit)});
  }
  return aligned_table(rows);
}

std::string front_table(const io::OptimisationDocument& document) {
  const io::Units units;
  const study::Optimisation& problem = document.file.problem;
  std::vector<std::vector<std::string>> rows(1);
  for (const study::Objective& one : problem.objectives) rows[0].push_back(one.quantity.name);
  for (const study::Variable& variable : problem.variables) rows[0].push_back(variable.name());
  for (const study::Design& design : document.result.front) {
    auto& row = rows.emplace_back();
    for (std::size_t k = 0; k < problem.objectives.size(); ++k) {
      const cycle::Quantity& quantity = problem.objectives[k].quantity;
      row.push_back(units.shown(design.objectives[k], quantity.unit, quantity.display_unit, 5));
    }
    for (std::size_t j = 0; j < problem.variables.size(); ++j) {
      const study::Variable& variable = problem.variables[j];
      row.push_back(units.shown(design.values[j], variable.unit, variable.display_unit, 5));
    }
  }
  return aligned_table(rows);
}

std::string optimisation_summary(const io::OptimisationDocument& document) {
  const study::OptimisationResult& result = document.result;
  const study::Optimisation& problem = document.file.problem;
  std::string text = problem.title + "\n";
  if (!result.front.empty()) {
    text += fmt::format("front of {} designs, none of which is better in all objectives\n{}", result.front.size(),
                        front_table(document));
  }
  if (result.best) {
    text += result.front.empty() ? "best design\n" : "design of the front nearest to the best of each objective\n";
    text += design_table(document.file, *result.best);
    std::vector<std::string> binding;
    for (const std::size_t k : result.binding) binding.push_back(problem.constraints[k].quantity.name);
    for (const std::string& bound : result.at_bounds) binding.push_back(bound);
    text += "binding: " + (binding.empty() ? "none" : joined(binding, ", ")) + "\n";
  } else {
    text += "design nearest to the constraints\n" + design_table(document.file, *result.nearest);
  }
  return text +
         fmt::format("{} designs were looked at, {} cases were computed\n", result.designs.size(), document.n_computed);
}

void write_optimisation(const InverseRequest& request, const io::OptimisationDocument& document) {
  const std::string json = io::optimisation_json(document);
  std::vector<std::pair<std::string, std::string>> files = {{"optimisation.json", json},
                                                            {"designs.csv", io::designs_csv(document)}};
  if (document.result.best) {
    const cycle::Case best = run::case_of_design(document.file, *document.result.best, 0);
    const std::string& point = document.file.problem.points.front().name;
    std::vector<std::string> heading = {"The best design" + (point.empty() ? "" : " at the point " + point) + "."};
    files.emplace_back("best.toml", io::resolved_case_in(request.output, best, heading));
  }
  for (const auto& [name, content] : files) io::write_atomically(in_folder(request.output, name), content);
  if (request.json) {
    std::cout << json;
  } else {
    std::cout << optimisation_summary(document);
    for (const auto& [name, content] : files) std::cout << "wrote " << in_folder(request.output, name) << "\n";
  }
  if (document.result.best) return;
  throw FailedChecks(joined(io::broken_constraints(document, io::Units()), "\n") +
                     "\nno design between the bounds meets all constraints");
}

void optimise_case(const InverseRequest& request) {
  io::OptimisationFile file = run::read_optimisation(request.path);
  io::PointStore store(prepared_store(request));
  const StopRequest stop;
  write_optimisation(request, run::run_optimisation(std::move(file), store, inverse_options(request, stop)));
}

constexpr const char* kOptimiseFooter = R"(Examples:
  ringfilm optimise optimisation.toml
  ringfilm optimise optimisation.toml -o results --json

The folder of the output has every case that was computed (points.jsonl): after a kill the same command continues with
them. Targets that cannot be met end with exit code 4 and the distance to each. docs/manual/optimise.md describes the
file.
)";

void declare_optimise(CommandOptions& add, InverseRequest& request) {
  declare_inverse(add, request,
                  {"OPT.toml", "file of the optimisation", "folder for results (default ./<file>)",
                   "print the optimisation as JSON, SI units, instead of the table"});
}

}  // namespace

void add_optimise_command(Program& program) {
  program.add("optimise", "Search the design of a case that meets targets", kOptimiseFooter, declare_optimise,
              optimise_case);
}

}  // namespace ringfilm::app
