#pragma once
#include <cmath>
#include <limits>
#include <string>

#include "ringfilm/io/result/result_file.hpp"

namespace ringfilm::io {

/// A document in which no two numbers are equal and nothing is omitted, so that a mix-up of two fields shows.
inline ResultDocument example_document(int n_samples = 5) {
  double next = 0;
  const auto number = [&next] { return std::sqrt(next += 1.0) * 1e-7; };

  ResultDocument document;
  document.title = "Example, \"quoted\" \xC2\xB5m";
  document.inputs = {
      {"engine.bore", "0.089", "89 mm", false, "cylinder bore", 0.089, "m"},
      {"film.cavitation", "\"mass-conserving\"", "mass-conserving", true, "cavitation model", std::nan(""), ""}};
  document.resolved_case = "title = \"Example\"\n[engine]\nbore = 0.089\n";
  document.files = {{"case", "example.toml", std::string(64, 'a')},
                    {"gas.cylinder_pressure", "p.csv", std::string(64, 'b')}};
  document.input_notes = {"p.csv begins with a byte-order mark"};
  document.provenance = {"ringfilm 9.9", "0123abc", "GNU 12", "avx2, 1 lane"};

  cycle::CycleResult& result = document.result;
  for (int k = 0; k < n_samples; ++k) {
    cycle::Sample sample;
    for (const auto& quantity : cycle::curve_quantities()) sample.*quantity.value = number();
    sample.crank_angle_deg = k;
    if (k % 2 == 0) sample.rupture_position = std::numeric_limits<double>::quiet_NaN();
    result.samples.push_back(sample);
  }
  for (const auto& quantity : cycle::cycle_quantities()) result.values.*quantity.value = number();
  result.fields.x = {0, 1e-4, 2e-4};
  result.fields.face_height = {3e-6, 0, 4e-6};
  result.fields.crank_angle_deg = {0, 20};
  for (int i = 0; i < 6; ++i) {
    result.fields.film_thickness.push_back(number());
    result.fields.film_pressure.push_back(number());
    result.fields.film_content.push_back(number());
    result.fields.lambda_ratio.push_back(number());
    result.fields.asperity_pressure.push_back(number());
  }
  result.stroke.liner_position = {1e-3, 2e-3};
  result.stroke.archard_wear_load_density = {number(), number()};
  for (const auto& quantity : cycle::derived_quantities()) result.derived[quantity.name] = number();
  result.derived["not_in_the_table"] = number();
  result.notes = {{"density-extrapolated", "the density table ends at 40 degC", 1}, {"lambda-low", "below 0.5", 17}};
  result.effort = {3.5, 1e-9, 720, 2900, 4, 2, 1, 1e-15, 2e-9, 3e-14};
  result.complete = true;

  document.contact.separation = {0, 1e-6, 2e-6};
  document.contact.laws = {{"of_the_case", "law of the case"}, {"plastic", "plastic"}};
  for (int i = 0; i < 6; ++i) {
    document.contact.pressure.push_back(number());
    document.contact.log_deviation.push_back(i < 3 ? number() : std::nan(""));
  }
  for (auto* const along : {&document.contact.real_area, &document.contact.phi_x, &document.contact.phi_y}) {
    for (int i = 0; i < 3; ++i) along->push_back(number());
  }

  study::LedgerEntry lifted{"cavitation", "the film ruptures", "", "docs/theory", true, {}};
  study::LedgerVariant variant{"film.cavitation = \"reynolds-exit\"", {}, true, ""};
  for (const auto& quantity : cycle::cycle_quantities()) variant.values.*quantity.value = number();
  lifted.variants = {variant, {"contact.integrals = \"polynomial-as-printed\"", {}, false, "no balance at 12 degree"}};
  document.ledger = {{"oil-supply", "oil at 62 bar", "too much flow", "docs/theory", false, {}}, lifted};
  document.ledger_computed = true;
  study::ComparisonRow row{
      {"paper", "fmep", "FMEP", number(), "ring.elastic_pressure"}, number(), number(), "a = 1", number()};
  study::ComparisonRow plain{{"paper", "mean_power_loss", "power", number(), ""}, number(), number(), "", std::nullopt};
  document.comparison = {row, plain};

  study::ErrorEstimate errors = study::no_estimate(result.samples.size());
  errors.runs = {{100, 1, 1e-3, true, ""}, {200, 1, 1e-3, false, "no balance at 12 degree"}};
  for (cycle::Sample& sample : errors.samples) {
    for (const auto& quantity : cycle::curve_quantities()) {
      if (study::has_error(quantity)) sample.*quantity.value = number();
    }
  }
  for (const auto& quantity : cycle::cycle_quantities()) {
    errors.values.*quantity.value = number();
    errors.order_in_cells.*quantity.value = number();
  }
  document.errors = errors;
  return document;
}

/// How the fields of an unrolled film are kept.
enum class KeptFields { kNone, kInFull, kByStrips };

/// The same of a film on the unrolled ring, of four strips.
inline ResultDocument unrolled_document(KeptFields kept, int n_samples = 5) {
  ResultDocument document = example_document(n_samples);
  double next = 1e6;
  const auto number = [&next] { return std::sqrt(next += 1.0) * 1e-7; };
  cycle::CycleResult& result = document.result;
  for (int k = 0; k < n_samples; ++k) {
    cycle::UnrolledSample sample;
    for (const auto& quantity : cycle::unrolled_quantities()) sample.*quantity.value = number();
    if (k == 0) sample.ends_share_flow = std::numeric_limits<double>::quiet_NaN();
    result.unrolled_samples.push_back(sample);
  }
  for (const auto& quantity : cycle::unrolled_cycle_quantities()) result.unrolled_values.*quantity.value = number();
  cycle::UnrolledFields& unrolled = result.unrolled;
  unrolled.circumference = 0.2803;
  unrolled.end_gap = 0.3e-3;
  unrolled.gap_position = 0.1;
  unrolled.y = {0, 0.01, 0.27, 0.28};
  unrolled.x = result.fields.x;
  unrolled.crank_angle_deg = result.fields.crank_angle_deg;
  const std::size_t n_strips = unrolled.y.size() * unrolled.crank_angle_deg.size();
  const auto fill = [&](const std::vector<cycle::UnrolledField>& fields, std::size_t n) {
    for (const cycle::UnrolledField& field : fields) {
      for (std::size_t i = 0; i < n; ++i) (unrolled.*field.values).push_back(static_cast<float>(number()));
    }
  };
  if (kept == KeptFields::kInFull) fill(cycle::unrolled_fields(), n_strips * unrolled.x.size());
  if (kept == KeptFields::kByStrips) fill(cycle::strip_fields(), n_strips);
  for (study::GridRun& run : document.errors->runs) run.cells_y = 180;
  return document;
}

}  // namespace ringfilm::io
