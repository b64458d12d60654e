#include "ringfilm/io/inverse/fit_output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "ringfilm/io/result/record_json.hpp"

namespace ringfilm::io {
namespace {

using nlohmann::ordered_json;

constexpr double kMinCorrelation = 0.05;   // below it factors of the study are independent
constexpr double kMaxCorrelation = 0.999;  // a study refuses those that follow from each other

ordered_json parameters_array(const FitDocument& document) {
  ordered_json list = ordered_json::array();
  for (std::size_t j = 0; j < document.result.parameters.size(); ++j) {
    const study::FitParameter& parameter = document.file.problem.parameters[j];
    const study::FittedParameter& fitted = document.result.parameters[j];
    list.push_back({{"key", parameter.name()},
                    {"value", fitted.value},
                    {"low", fitted.low},
                    {"high", fitted.high},
                    {"unit", parameter.unit},
                    {"deviation", fitted.deviation},
                    {"identified", fitted.identified},
                    {"low_at_bound", fitted.at_lower},
                    {"high_at_bound", fitted.at_upper}});
  }
  return list;
}

ordered_json measured_array(const FitDocument& document) {
  ordered_json list = ordered_json::array();
  for (std::size_t i = 0; i < document.result.series.size(); ++i) {
    const study::Measured& measured = document.file.problem.measured[i];
    const study::FittedSeries& series = document.result.series[i];
    list.push_back({{"quantity", measured.quantity.name},
                    {"unit", measured.quantity.unit},
                    {"values", measured.values.size()},
                    {"residual_rms", series.residual_rms},
                    {"discrepancy", series.discrepancy}});
    for (const study::FittedNuisance& nuisance : document.result.nuisances) {
      if (nuisance.measured != i) continue;
      list.back()[nuisance.name] = {{"value", nuisance.value}, {"deviation", nuisance.deviation}};
    }
  }
  return list;
}

ordered_json predictions_object(const FitDocument& document) {
  ordered_json object = ordered_json::object();
  for (std::size_t i = 0; i < document.predicted.size(); ++i) {
    const study::PredictedValue& value = document.result.predicted[i];
    object[document.predicted[i].name] = {
        {"value", value.value}, {"low", value.low}, {"high", value.high}, {"unit", document.predicted[i].unit}};
  }
  return object;
}

std::string number(double value) { return std::isfinite(value) ? exact_text(value) : ""; }

/// "1.5e-06 m" in quotes, or the number alone.
std::string with_unit(double value, const std::string& unit) {
  return unit == "1" ? exact_text(value) : quoted(exact_text(value) + " " + unit);
}

}  // namespace

std::string fit_json(const FitDocument& document) {
  const study::FitResult& result = document.result;
  ordered_json object = {{"title", document.file.problem.title},        {"parameters", parameters_array(document)},
                         {"residual_rms", result.residual_rms},         {"sum_of_squares", result.sum_of_squares},
                         {"measured_values", result.n_values},          {"not_identified", result.not_identified},
                         {"correlation", result.correlation},           {"measured", measured_array(document)},
                         {"predictions", predictions_object(document)}, {"notes", result.notes},
                         {"converged", result.has_converged},           {"starts", document.file.problem.starts},
                         {"starts_agreed", result.n_starts_agreed},     {"derivative_error", result.derivative_error},
                         {"cases_computed", document.n_computed},       {"cases_stored", document.n_stored}};
  put_provenance(this_program(), object);
  return json_text(object);
}

std::string fit_csv(const FitDocument& document) {
  std::string csv = "series,quantity,unit,crank_angle [degree],measured,deviation,computed,band\n";
  for (std::size_t i = 0; i < document.result.series.size(); ++i) {
    const study::Measured& measured = document.file.problem.measured[i];
    const study::FittedSeries& series = document.result.series[i];
    for (std::size_t k = 0; k < measured.values.size(); ++k) {
      csv += fmt::format("{},{},{},{},{},{},{},{}\n", i + 1, measured.quantity.name, measured.quantity.unit,
                         measured.is_curve() ? number(measured.crank_angle_deg[k]) : "", number(measured.values[k]),
                         number(measured.deviations[k]), number(series.computed[k]), number(series.band[k]));
    }
  }
  return csv;
}

std::string fit_study(const FitDocument& document, const std::string& case_name) {
  const auto& parameters = document.file.problem.parameters;
  const study::FitResult& result = document.result;
  std::string text = fmt::format(
      "# The fitted parameters with their scatter.\ntitle = {}\nkind = \"uncertainty\"\n\n[[base]]\nname = \"fitted\"\n"
      "case = {}\n",
      quoted(document.file.problem.title), quoted(case_name));
  std::vector<std::size_t> numbers;
  for (std::size_t j = 0; j < parameters.size(); ++j) {
    // Studies have no factor for a number of a list or the size of a unit.
    if (parameters[j].item || parameters[j].how != study::FactorMode::kSet) continue;
    numbers.push_back(j);
    const study::FittedParameter& fitted = result.parameters[j];
    text += fmt::format(
        "\n[[factor]]\nkey = \"{}\"\ndistribution = \"normal\"\nmean = {}\ndeviation = {}\ntruncate = [{}, {}]\n"
        "source = \"fitted: {}\"\n",
        parameters[j].key, with_unit(fitted.value, parameters[j].unit), with_unit(fitted.deviation, parameters[j].unit),
        with_unit(parameters[j].lower, parameters[j].unit), with_unit(parameters[j].upper, parameters[j].unit),
        fitted.identified ? "identified by the measurement" : "NOT identified by the measurement");
  }
  for (std::size_t a = 0; a < numbers.size(); ++a) {
    for (std::size_t b = a + 1; b < numbers.size(); ++b) {
      const double value = std::clamp(result.correlation[numbers[a]][numbers[b]], -kMaxCorrelation, kMaxCorrelation);
      if (std::abs(value) < kMinCorrelation) continue;
      text += fmt::format("\n[[correlation]]\nfactors = [\"{}\", \"{}\"]\nvalue = {:.4f}\n", parameters[numbers[a]].key,
                          parameters[numbers[b]].key, value);
    }
  }
  return text + "\n[plan]\nmethod = \"sobol\"\nscenarios = 256\n";
}

}  // namespace ringfilm::io
