#pragma once
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "ringfilm/cycle/result/effort_quantities.hpp"
#include "ringfilm/io/result/input_members.hpp"
#include "ringfilm/io/result/pack_gas_layout.hpp"
#include "ringfilm/io/result/provenance_attributes.hpp"
#include "ringfilm/io/result/result_file.hpp"
#include "ringfilm/io/result/result_file_contact.hpp"
#include "ringfilm/io/result/result_file_quantities.hpp"
#include "ringfilm/io/result/result_file_unrolled.hpp"

/// The one description of the result file (docs/manual/result-file.md): writing and reading both walk it.
namespace ringfilm::io {

/// Raised by one whenever a name or a meaning changes.
constexpr long kResultSchema = 7;

/// A ledger variant as a row of a table; its values are a row of `variant_values`.
struct VariantRow : study::LedgerVariant {
  long entry = 0;  ///< row of the ledger entry it belongs to
};

template <class File, class Document>
void exchange_attributes(File& file, Document& document) {
  file.attribute("title", document.title);
  exchange_provenance(file, document.provenance);
  file.attribute("complete", document.result.complete);
  file.attribute("ledger_computed", document.ledger_computed);
  if constexpr (File::kReads) {
    if (file.has_variable("rail")) file.attribute("rail", document.rail);
  } else {
    if (document.rail > 0) file.attribute("rail", document.rail);
  }
  auto& effort = document.result.effort;
  for (const cycle::EffortQuantity& quantity : cycle::effort_quantities()) {
    const std::string name = "effort_" + quantity.name;
    std::visit([&](auto member) { file.attribute(name.c_str(), effort.*member); }, quantity.value);
  }
}

template <class File, class Result>
void exchange_curves(File& file, Result& result) {
  file.rows("crank_angle", result.samples);
  for (const auto& quantity : cycle::curve_quantities()) {
    file.column("crank_angle", quantity, result.samples, quantity.value);
  }
  for (const auto& quantity : cycle::cycle_quantities()) {
    file.scalar(cycle_variable(quantity), result.values.*quantity.value);
  }
  exchange_scalars(file, "derived_", cycle::derived_quantities(), result.derived);
}

/// Nothing where the errors were not asked for: a file without grid runs has none.
template <class File, class Document>
void exchange_errors(File& file, Document& document) {
  if constexpr (File::kReads) {
    std::vector<study::GridRun> runs;
    file.rows("grid_run", runs);
    if (!runs.empty()) document.errors = study::no_estimate(document.result.samples.size());
  }
  if (!document.errors) return;
  auto& errors = *document.errors;
  exchange_rows(file, "grid_run", "grid_run_", errors.runs);
  for (const auto& quantity : cycle::curve_quantities()) {
    if (!study::has_error(quantity)) continue;
    file.column("crank_angle", error_variable(quantity), errors.samples, quantity.value);
  }
  for (const auto& quantity : cycle::cycle_quantities()) {
    const cycle::Quantity variable = cycle_variable(quantity);
    file.scalar(error_variable(variable), errors.values.*quantity.value);
    file.scalar(order_variable(variable, "cells"), errors.order_in_cells.*quantity.value);
    file.scalar(order_variable(variable, "step"), errors.order_in_step.*quantity.value);
  }
}

template <class File, class Result>
void exchange_fields(File& file, Result& result) {
  auto& fields = result.fields;
  file.numbers({"x"}, described("x", "m", "position along the ring face from the chamber edge", "x"), fields.x);
  file.numbers({"x"}, described("face_height", "m", "height of the ring face as installed", "h_s", "eq-film-thickness"),
               fields.face_height);
  file.numbers({"field_crank_angle"},
               described("field_crank_angle", "degree", "crank angle of the fields, 0 = firing TDC", "varphi"),
               fields.crank_angle_deg);
  const std::vector<const char*> grid = {"field_crank_angle", "x"};
  file.numbers(grid, described("film_thickness", "m", "film thickness along the face", "h", "eq-film-thickness"),
               fields.film_thickness);
  file.numbers(grid, described("film_pressure", "Pa", "absolute film pressure along the face", "p", "eq-reynolds"),
               fields.film_pressure);
  file.numbers(grid, described("film_content", "1", "liquid share of the gap", "theta", "eq-film-content"),
               fields.film_content);
  file.numbers(grid, described("local_lambda_ratio", "1", "lambda ratio along the face", "lambda", "eq-lambda-ratio"),
               fields.lambda_ratio);
  file.numbers(
      grid, described("asperity_pressure", "Pa", "asperity contact pressure along the face", "p_a", "eq-asperity-load"),
      fields.asperity_pressure);
  exchange_present(file, grid,
                   described("local_deformation", "m", "local deformation of face and liner, over that at the edges",
                             "delta", "eq-local-deformation"),
                   fields.local_deformation);
  auto& stroke = result.stroke;
  file.numbers({"liner_position"},
               described("liner_position", "m", "distance below the position of the ring at TDC", "s"),
               stroke.liner_position);
  file.numbers({"liner_position"},
               described("archard_wear_load_density", "J m-1", "work of asperity contact per length of liner and cycle",
                         "w", "eq-archard-wear-load"),
               stroke.archard_wear_load_density);
  for (const cycle::StrokeFilm& film : cycle::stroke_films()) {
    exchange_present(file, {"liner_position"}, film, (stroke.*film.films)[film.stroke]);
  }
}

/// The inputs of a case and the files that it was read from.
template <class File, class Document>
void exchange_inputs(File& file, Document& document) {
  exchange_rows(file, "input", "input_", document.inputs);
  exchange_rows(file, "file", "file_", document.files);
}

template <class File, class Document>
void exchange_case(File& file, Document& document) {
  file.scalar(text("resolved_case", "a complete case file in SI that gives the same bits again"),
              document.resolved_case);
  exchange_inputs(file, document);
}

/// @param table the variants of all entries one after the other, a row of `values` each
template <class File, class Ledger, class VariantTable>
void exchange_ledger(File& file, Ledger& ledger, VariantTable& table) {
  exchange_rows(file, "ledger_entry", "ledger_", ledger);
  auto& variants = table.rows;
  file.rows("ledger_variant", variants);
  file.column("ledger_variant", count("variant_entry", "row of the ledger entry, from 0"), variants,
              &VariantRow::entry);
  exchange_members<study::LedgerVariant>(file, "ledger_variant", "variant_", variants);
  file.texts("cycle_quantity", text("cycle_quantity", "column of variant_values"), table.quantities);
  file.texts("cycle_quantity", text("cycle_quantity_unit", "unit of that column"), table.units);
  file.numbers({"ledger_variant", "cycle_quantity"},
               text("variant_values", "cycle values with that setting; units in cycle_quantity_unit"), table.values);
}

/// Unit of a cycle quantity by its name; empty if there is none of that name.
inline std::string unit_of(const std::string& name) {
  for (const auto& quantity : cycle::cycle_quantities()) {
    if (quantity.name == name) return quantity.unit;
  }
  return "";
}

template <class File, class Document>
void exchange_comparison(File& file, Document& document) {
  auto& rows = document.comparison;
  const auto published = [](auto& row) -> auto& { return row.published; };
  file.rows("comparison", rows);
  exchange_members<study::PublishedValue>(file, "comparison", "comparison_", rows, published);
  exchange_members<study::ComparisonRow>(file, "comparison", "comparison_", rows);
  std::vector<std::string> units;
  for (const auto& row : rows) units.push_back(unit_of(row.published.quantity));
  file.texts("comparison", text("comparison_unit", "unit of the values compared"), units);
}

/// The oil consumption of a pack, or of a case of one ring; nothing where it is not computed.
template <class File, class Document>
void exchange_oil_losses(File& file, Document& document) {
  if constexpr (!File::kReads) {
    if (document.oil_losses.empty()) return;
  }
  exchange_rows(file, "oil_loss", "oil_loss_", document.oil_losses);
}

/// What the rings of a pack have in common.
template <class File, class Document>
void exchange_pack(File& file, Document& document) {
  file.attribute("title", document.title);
  exchange_provenance(file, document.provenance);
  file.scalar(text("pack_case", "a complete case file of the pack in SI that gives the same bits again"),
              document.resolved_case);
  exchange_pack_gas(file, document);
  exchange_oil_losses(file, document);
}

/// Everything, in the order of the file.
template <class File, class Document, class VariantTable>
void exchange(File& file, Document& document, VariantTable& variants) {
  exchange_attributes(file, document);
  exchange_curves(file, document.result);
  exchange_errors(file, document);
  exchange_fields(file, document.result);
  exchange_unrolled(file, document.result);
  exchange_contact(file, document.contact);
  exchange_case(file, document);
  exchange_notes(file, document.input_notes, document.result.notes);
  exchange_ledger(file, document.ledger, variants);
  exchange_comparison(file, document);
}

}  // namespace ringfilm::io
