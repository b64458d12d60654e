#pragma once
#include <optional>
#include <string>
#include <vector>

#include "ringfilm/cycle/result/result.hpp"
#include "ringfilm/io/case/case_file.hpp"
#include "ringfilm/io/study/document_reader.hpp"
#include "ringfilm/io/text/toml_table.hpp"
#include "ringfilm/study/inverse/variable.hpp"

namespace ringfilm::io {

/// A value of TOML as one writes it, exactly: overrides are made of it.
std::string toml_text(const TomlValue& value);

/// The quantities that a case gives, by name: run::value_quantities and run::curve_quantities.
using QuantitiesOfCase = std::vector<cycle::Quantity> (*)(const cycle::Case&);
struct CaseQuantities {
  QuantitiesOfCase values, curves;
};

/// What files that vary one case have in common: the case at operating points, variables between bounds.
class VariedDocumentReader : protected DocumentReader {
 protected:
  using DocumentReader::DocumentReader;

  /// `case` and `compute` of the file. @returns whether the case could be read; it is then the first of `bases_`
  bool read_case_of(TomlTable& table);

  /// Reads the case with overrides, and keeps it. @param mark where faults without a place are reported
  /// @returns its place in `bases_`; nothing where it cannot be read
  std::optional<std::size_t> add_base(const std::vector<Override>& overrides, const SourceMark& mark);

  /// The overrides of a table `{ "operating.speed" = "1000 rpm" }`, file names relative to the document.
  std::vector<Override> overrides_of(const TomlValue& values);
  /// One of them. @param value as toml_text() writes it
  Override override_of(const std::string& key, const TomlValue& value);

  /// Bounds of a key: `key`, `lower`, `upper`, `how`, `item`, `spacing`.
  std::optional<study::Variable> read_variable(TomlTable& table);

  /// The quantity that `quantity` of a table names, among those of `known`.
  std::optional<cycle::Quantity> read_quantity(TomlTable& table, const std::vector<cycle::Quantity>& known);

  /// A positive number with the unit of a quantity; a temperature as a difference.
  std::optional<double> read_deviation(TomlTable& table, const std::string& key, const cycle::Quantity& quantity);

  const cycle::Case& first_base() const { return bases_.front(); }

  std::string case_path_;
  study::Compute compute_ = study::Compute::kFilms;
  std::vector<cycle::Case> bases_;
};

}  // namespace ringfilm::io
