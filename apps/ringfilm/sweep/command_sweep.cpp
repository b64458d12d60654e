#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <functional>
#include <iostream>
#include <limits>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <utility>

#include "commands/commands.hpp"
#include "output_names.hpp"
#include "progress.hpp"
#include "ringfilm/base/display.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/base/joined.hpp"
#include "ringfilm/case/keys/case_fields.hpp"
#include "ringfilm/cycle/setup/setup.hpp"
#include "ringfilm/io/storage/atomic_file.hpp"
#include "ringfilm/run/inverse/case_numbers.hpp"
#include "ringfilm/study/ensemble/threads.hpp"
#include "text/engineering_text.hpp"
#include "text/shared_options.hpp"
#include "variations.hpp"

namespace ringfilm::app {
namespace {

struct SweepOptions : CaseOptions {
  std::vector<std::string> varied;  ///< as written: KEY=VALUE, VALUE, ... or KEY=FROM..TO
  std::size_t points = 11;
  std::optional<std::string> csv;
  std::optional<std::string> modelica;  ///< table of the FMEP
  bool chen_flynn = false;              ///< fit of the FMEP over peak pressure and piston speed
  int threads = 0;
};

/// What a combination has.
struct Row {
  std::vector<io::Override> settings;
  std::map<std::string, double> values;  ///< run::value_quantities() by name; empty where it was not solved [SI]
  std::string reason;                    ///< why it was not

  double value(const std::string& name) const {
    const auto found = values.find(name);
    return found == values.end() ? std::numeric_limits<double>::quiet_NaN() : found->second;
  }
};

/// What is printed, as far as the cases have it, with the head of its column.
struct Column {
  const char *name, *head;
};
constexpr std::array kColumns = {Column{"fmep", "FMEP"},
                                 Column{"mean_power_loss", "mean power"},
                                 Column{"mean_boundary_power", "boundary"},
                                 Column{"peak_total_friction", "peak friction"},
                                 Column{"min_film_thickness", "min. film"},
                                 Column{"blow_by_flow", "blow-by"},
                                 Column{"load", "load"}};

std::vector<NamedOutput> outputs_of(const SweepOptions& options) {
  return {{"--csv", options.csv, OutputKind::kCsv, io::Sink::kFileOrDevice},
          {"--modelica", options.modelica, std::nullopt, io::Sink::kFileOrDevice}};
}

void compute(const cycle::Case& c, Row& row) {
  try {
    row.values = run::case_numbers(c, {}).values;
  } catch (const ConvergenceError& error) {
    row.reason = error.what();
  }
}

std::string settings_text(const Row& row) {
  std::vector<std::string> texts;
  for (const io::Override& one : row.settings) texts.push_back(one.key + " = " + one.value);
  return joined(texts, ", ");
}

/// The settings and the values that decide, a line each; the lowest friction is named below.
std::string table_of(const std::vector<Row>& rows, const std::vector<cycle::Quantity>& quantities) {
  const EngineeringText in_words;
  std::vector<std::pair<const char*, const cycle::Quantity*>> columns;
  for (const Column& column : kColumns) {
    const auto found = std::ranges::find(quantities, column.name, &cycle::Quantity::name);
    if (found != quantities.end()) columns.emplace_back(column.head, &*found);
  }
  std::string text;
  std::vector<std::size_t> widths;
  for (std::size_t k = 0; k < rows.front().settings.size(); ++k) {
    std::size_t width = rows.front().settings[k].key.size();
    for (const Row& row : rows) width = std::max(width, row.settings[k].value.size());
    widths.push_back(width + 2);
    text += fmt::format("{:<{}}", rows.front().settings[k].key, widths.back());
  }
  for (const auto& [head, quantity] : columns) text += fmt::format("{:>15}", head);
  text += "\n";
  for (const Row& row : rows) {
    for (std::size_t k = 0; k < row.settings.size(); ++k)
      text += fmt::format("{:<{}}", row.settings[k].value, widths[k]);
    for (const auto& [head, quantity] : columns) {
      text += fmt::format("{:>15}", row.values.empty() ? "not solved" : in_words(*quantity, row.value(quantity->name)));
    }
    text += "\n";
  }
  const Row* best = nullptr;
  for (const Row& row : rows) {
    if (row.value("fmep") < (best == nullptr ? std::numeric_limits<double>::infinity() : best->value("fmep"))) {
      best = &row;
    }
  }
  if (best != nullptr) {
    text += fmt::format("lowest FMEP: {} at {}\n", in_words("fmep", best->value("fmep")), settings_text(*best));
  }
  for (const Row& row : rows) {
    if (row.values.empty()) text += "not solved: " + settings_text(row) + ": " + row.reason + "\n";
  }
  return text;
}

std::string csv_of(const std::vector<Row>& rows, const std::vector<cycle::Quantity>& quantities) {
  std::vector<std::string> cells;
  for (const io::Override& one : rows.front().settings) cells.push_back(one.key);
  for (const cycle::Quantity& quantity : quantities) {
    cells.push_back(quantity.name + (quantity.unit == "1" ? "" : " [" + quantity.unit + "]"));
  }
  std::string text = joined(cells, ",") + "\n";
  for (const Row& row : rows) {
    cells.clear();
    for (const io::Override& one : row.settings) cells.push_back(quoted_cell(one.value));
    for (const cycle::Quantity& quantity : quantities) cells.push_back(fmt::format("{}", row.value(quantity.name)));
    text += joined(cells, ",") + "\n";
  }
  return text;
}

std::string json_of(const std::string& case_path, const std::vector<Row>& rows,
                    const std::vector<cycle::Quantity>& quantities) {
  nlohmann::ordered_json all{{"case", case_path}, {"scenarios", nlohmann::ordered_json::array()}};
  for (const Row& row : rows) {
    nlohmann::ordered_json one;
    for (const io::Override& setting : row.settings) one["settings"][setting.key] = setting.value;
    one["complete"] = !row.values.empty();
    if (row.values.empty()) one["reason"] = row.reason;
    for (const cycle::Quantity& quantity : quantities) {
      if (row.values.contains(quantity.name)) one["values"][quantity.name] = row.value(quantity.name);
    }
    all["scenarios"].push_back(std::move(one));
  }
  for (const cycle::Quantity& quantity : quantities) all["units"][quantity.name] = quantity.unit;
  return all.dump(2) + "\n";
}

/// The varied values of a key as numbers [SI].
std::vector<double> numbers_of(const Variation& of, const io::Units& units) {
  const auto ring = cycle::ring_key(of.key);
  const cycle::Field* field = cycle::find_field(ring ? ring->key : of.key);
  if (field == nullptr || field->unit.empty()) {
    throw InputError("--modelica: " + of.key + " is not a number", "vary one or two numbers, such as operating.speed");
  }
  std::vector<double> numbers;
  for (const std::string& value : of.values) numbers.push_back(units.quantity(value, field->unit, "1500 rpm"));
  if (std::ranges::adjacent_find(numbers, std::greater_equal()) != numbers.end()) {
    throw InputError("--modelica: the values of " + of.key + " do not rise", "state them from low to high");
  }
  return numbers;
}

/// The FMEP as a table of Modelica's CombiTable1D or, of two keys, CombiTable2D.
std::string modelica_text(const std::vector<Row>& rows, const std::vector<std::vector<double>>& axes) {
  const auto number = [](double value) { return fmt::format("{:.9g}", value); };
  const std::size_t n_columns = axes.size() == 1 ? 1 : axes[1].size();
  std::string text = fmt::format("#1\ndouble fmep({},{})  # [Pa]; rows: {}", axes[0].size() + (axes.size() > 1),
                                 n_columns + 1, rows.front().settings[0].key);
  if (axes.size() > 1) text += ", columns: " + rows.front().settings[1].key;
  text += ", SI\n";
  if (axes.size() > 1) {
    text += "0";
    for (const double value : axes[1]) text += " " + number(value);
    text += "\n";
  }
  for (std::size_t i = 0; i < axes[0].size(); ++i) {
    text += number(axes[0][i]);
    for (std::size_t j = 0; j < n_columns; ++j) text += " " + number(rows[i * n_columns + j].value("fmep"));
    text += "\n";
  }
  return text;
}

/// FMEP = constant + of_pressure p_max + of_speed v + of_square v^2 through all rows, @cite chenflynn1965.
struct ChenFlynn {
  std::array<double, 4> value{}, deviation{};  ///< [Pa], [-], [Pa s/m], [Pa s2/m2]
  double residual_rms = 0;                     ///< [Pa]
};
constexpr std::array kChenFlynn = {"constant", "peak_pressure", "piston_speed", "piston_speed_squared"};

/// The terms of the cases, a row each. Throws InputError where they do not determine all four coefficients.
Eigen::MatrixXd terms_of(const std::vector<cycle::Case>& cases) {
  const auto n = static_cast<Eigen::Index>(cases.size());
  Eigen::MatrixXd terms(n, 4);
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const double v = cases[at].engine.stroke * cases[at].operating.speed / std::numbers::pi;
    const cycle::Case& ring = cases[at].is_pack() ? cases[at].rings.front() : cases[at];
    terms.row(i) << 1, cycle::cylinder_pressure(ring).peak(), v, v * v;
  }
  const Eigen::RowVectorXd scale = terms.cwiseAbs().colwise().maxCoeff();
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> rank(Eigen::MatrixXd(terms.array().rowwise() / scale.array()));
  constexpr double kDetermined = 1e-6;
  rank.setThreshold(kDetermined);
  if (n < 5 || rank.rank() < 4) {
    throw InputError("--chen-flynn: the cases do not determine its four coefficients",
                     "vary operating.speed over three values or more and gas.peak_pressure over two or more");
  }
  return terms;
}

ChenFlynn chen_flynn(const std::vector<Row>& rows, const Eigen::MatrixXd& terms) {
  const auto n = static_cast<Eigen::Index>(rows.size());
  Eigen::VectorXd fmep(n);
  for (Eigen::Index i = 0; i < n; ++i) fmep(i) = rows[static_cast<std::size_t>(i)].value("fmep");
  const Eigen::RowVectorXd scale = terms.cwiseAbs().colwise().maxCoeff();
  const Eigen::MatrixXd scaled = terms.array().rowwise() / scale.array();
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(scaled);
  const Eigen::VectorXd x = qr.solve(fmep);
  const double variance = (scaled * x - fmep).squaredNorm() / static_cast<double>(n - 4);
  const Eigen::MatrixXd covariance = variance * (scaled.transpose() * scaled).inverse();
  ChenFlynn fit;
  for (Eigen::Index k = 0; k < 4; ++k) {
    fit.value[static_cast<std::size_t>(k)] = x(k) / scale(k);
    fit.deviation[static_cast<std::size_t>(k)] = std::sqrt(covariance(k, k)) / scale(k);
  }
  fit.residual_rms = std::sqrt((scaled * x - fmep).squaredNorm() / static_cast<double>(n));
  return fit;
}

std::string chen_flynn_line(const ChenFlynn& fit) {
  const auto term = [&](std::size_t k, double per = 1) {
    return fmt::format("({:.4g} +- {:.1g})", number_in(fit.value[k], kKilopascal) / per,
                       number_in(fit.deviation[k], kKilopascal) / per);
  };
  return "Chen-Flynn: FMEP [kPa] = " + term(0) + " + " + term(1, number_in(1, kBar)) + " p_max [bar] + " + term(2) +
         " v [m/s] + " + term(3) + " v^2; rms residual " + text_in(fit.residual_rms, kKilopascal, 3) + "\n";
}

std::string with_chen_flynn(const std::string& json, const ChenFlynn& fit) {
  auto all = nlohmann::ordered_json::parse(json);
  for (std::size_t k = 0; k < kChenFlynn.size(); ++k) {
    all["chen_flynn"][kChenFlynn[k]] = {{"value", fit.value[k]}, {"standard_deviation", fit.deviation[k]}};
  }
  all["chen_flynn"]["residual_rms"] = fit.residual_rms;
  return all.dump(2) + "\n";
}

/// What the outputs need of the keys, checked before anything is computed.
std::vector<std::vector<double>> axes_of(const SweepOptions& options, const std::vector<Variation>& varied) {
  if (!options.modelica) return {};
  if (varied.size() > 2) {
    throw InputError(
        "--modelica writes tables of one or two keys, and " + std::to_string(varied.size()) + " are varied",
        "vary one or two, and fix the others with --set");
  }
  const io::Units units;
  std::vector<std::vector<double>> axes;
  for (const Variation& one : varied) axes.push_back(numbers_of(one, units));
  return axes;
}

void sweep(const SweepOptions& options) {
  const VariationForm form{"", "operating.speed=1000..6000 or lubricant.grade='SAE 0W-20, SAE 5W-30'", options.points};
  const std::vector<Variation> varied = variations(options.varied, form);
  Faults faults;
  check_names(outputs_of(options), faults);
  faults.check();
  const std::vector<std::vector<double>> axes = axes_of(options, varied);
  const std::vector<cycle::Case> cases =
      cases_of(options.case_path, options.overrides, varied, form, cycle::CasePurpose::kFilm);
  std::vector<cycle::InputFile> files;
  for (const cycle::Case& c : cases) files.insert(files.end(), c.files.begin(), c.files.end());
  check_apart(outputs_of(options), files, "case", faults);
  const bool has_friction = cases.front().problem == cycle::Problem::kCycle;
  if (!has_friction && (options.modelica || options.chen_flynn)) {
    faults.refuse("--modelica and --chen-flynn are for the FMEP of rings, and the case has none", "take --csv");
  }
  faults.check();
  std::optional<Eigen::MatrixXd> terms;
  if (options.chen_flynn) terms = terms_of(cases);
  const std::vector<io::OutputClaim> claimed = claims(outputs_of(options));
  std::vector<Row> rows(cases.size());
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i].settings = combination(varied, i, form);
  std::atomic<std::size_t> next = 0, n_done = 0;
  std::mutex shows;
  std::optional<ProgressLine> line(std::in_place);
  study::on_threads(std::min(study::n_threads(options.threads), static_cast<int>(rows.size())), [&](int) {
    for (std::size_t i = next++; i < rows.size(); i = next++) {
      compute(cases[i], rows[i]);
      const std::lock_guard lock(shows);
      line->show(fmt::format("{} of {} cases", ++n_done, rows.size()));
    }
  });
  line.reset();
  const std::vector<cycle::Quantity> quantities = run::value_quantities(cases.front());
  const auto n_failed = std::ranges::count_if(rows, [](const Row& row) { return row.values.empty(); });
  if (options.csv) io::write_atomically(*options.csv, csv_of(rows, quantities));
  if (options.modelica && n_failed == 0) io::write_atomically(*options.modelica, modelica_text(rows, axes));
  std::optional<ChenFlynn> fit;
  if (options.chen_flynn && n_failed == 0) fit = chen_flynn(rows, *terms);
  if (options.summary == SummaryForm::kJson) {
    const std::string json = json_of(options.case_path, rows, quantities);
    std::cout << (fit ? with_chen_flynn(json, *fit) : json);
  } else {
    std::cout << table_of(rows, quantities) << (fit ? chen_flynn_line(*fit) : "");
    if (n_failed == 0) print_written(outputs_of(options));
  }
  if (n_failed > 0) {
    throw FailedChecks(fmt::format("{} of {} cases were not solved{}", n_failed, rows.size(),
                                   options.modelica || options.chen_flynn ? "; no table of Modelica and no fit" : ""));
  }
}

constexpr const char* kSweepFooter = R"(Examples:
  ringfilm sweep case.toml operating.speed=1000..6000
  ringfilm sweep case.toml lubricant.grade='SAE 0W-20, SAE 5W-30' operating.speed='1000..6000 rpm' --points 6
  ringfilm sweep case.toml gas.peak_pressure='30, 60, 90' operating.speed=1000..6000 --chen-flynn --modelica fmep.txt
  ringfilm sweep pack.toml ring.1.face.crown_height='2 um, 4 um, 8 um' --csv crowns.csv

A bare number has the unit of `ringfilm fields`. All combinations are computed, the last key fastest;
`ringfilm study` computes larger plans, with a page, and continues after a kill.
)";

void declare_sweep(CommandOptions& add, SweepOptions& options) {
  add.text("CASE.toml", options.case_path, "", "the case file")->required();
  add_settings(add, options.overrides);
  add.text("KEY=VALUES", options.varied, "...", "a key with a list of values, or a range FROM..TO; several keys")
      ->required();
  add.number("--points", options.points, 2, 1000, "11", "N", "values of a range, with both ends");
  add.text("--csv", options.csv, "X.csv", "write all values of the cycles as CSV, SI units");
  add.text("--modelica", options.modelica, "X.txt", "write the FMEP over one or two numbers as a table of Modelica");
  add.flag("--chen-flynn", options.chen_flynn,
           "fit constant, peak pressure and mean piston speed to the FMEP, with standard deviations");
  add_threads(add, options.threads);
  add.json(options.summary, "print settings and values as JSON, SI units, instead of the table");
}

}  // namespace

void add_sweep_command(Program& program) {
  program.add("sweep", "Compute a case over values of one key or several, and print a table", kSweepFooter,
              declare_sweep, sweep);
}

}  // namespace ringfilm::app
