#include "ringfilm/io/result/result_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netcdf.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include "../result_example.hpp"
#include "../scratch_folder.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/io/storage/digest.hpp"
#include "ringfilm/io/storage/digest_trailer.hpp"
#include "ringfilm/io/text/units.hpp"

namespace ringfilm::io {
namespace {

using testing::HasSubstr;

/// Equal to the bit: NaN equals NaN.
void expect_same(double a, double b, const std::string& what) {
  EXPECT_EQ(std::memcmp(&a, &b, sizeof a), 0) << what << ": " << a << " against " << b;
}

void expect_same(const std::vector<double>& a, const std::vector<double>& b, const std::string& what) {
  ASSERT_EQ(a.size(), b.size()) << what;
  for (std::size_t i = 0; i < a.size(); ++i) expect_same(a[i], b[i], what);
}

void expect_same(const cycle::CycleValues& a, const cycle::CycleValues& b) {
  for (const auto& quantity : cycle::cycle_quantities())
    expect_same(a.*quantity.value, b.*quantity.value, quantity.name);
}

void expect_same(const cycle::CycleResult& a, const cycle::CycleResult& b) {
  ASSERT_EQ(a.samples.size(), b.samples.size());
  for (std::size_t k = 0; k < a.samples.size(); ++k) {
    for (const auto& q : cycle::curve_quantities()) expect_same(a.samples[k].*q.value, b.samples[k].*q.value, q.name);
  }
  expect_same(a.values, b.values);
  expect_same(a.fields.x, b.fields.x, "x");
  expect_same(a.fields.face_height, b.fields.face_height, "face_height");
  expect_same(a.fields.crank_angle_deg, b.fields.crank_angle_deg, "field_crank_angle");
  expect_same(a.fields.film_thickness, b.fields.film_thickness, "film_thickness");
  expect_same(a.fields.film_pressure, b.fields.film_pressure, "film_pressure");
  expect_same(a.fields.film_content, b.fields.film_content, "film_content");
  expect_same(a.fields.lambda_ratio, b.fields.lambda_ratio, "lambda_ratio");
  expect_same(a.fields.asperity_pressure, b.fields.asperity_pressure, "asperity_pressure");
  expect_same(a.stroke.liner_position, b.stroke.liner_position, "liner_position");
  expect_same(a.stroke.archard_wear_load_density, b.stroke.archard_wear_load_density, "archard_wear_load_density");
  EXPECT_EQ(a.derived, b.derived);
  ASSERT_EQ(a.notes.size(), b.notes.size());
  for (std::size_t i = 0; i < a.notes.size(); ++i) {
    EXPECT_EQ(a.notes[i].topic, b.notes[i].topic);
    EXPECT_EQ(a.notes[i].message, b.notes[i].message);
    EXPECT_EQ(a.notes[i].count, b.notes[i].count);
  }
  EXPECT_EQ(a.effort.cycles_integrated, b.effort.cycles_integrated);
  EXPECT_EQ(a.effort.periodicity_error, b.effort.periodicity_error);
  EXPECT_EQ(a.effort.crank_steps, b.effort.crank_steps);
  EXPECT_EQ(a.effort.newton_iterations, b.effort.newton_iterations);
  EXPECT_EQ(a.effort.sub_steps, b.effort.sub_steps);
  EXPECT_EQ(a.effort.fallback_secant, b.effort.fallback_secant);
  EXPECT_EQ(a.effort.fallback_sub_step, b.effort.fallback_sub_step);
  EXPECT_EQ(a.effort.max_load_residual, b.effort.max_load_residual);
  EXPECT_EQ(a.effort.max_newton_step, b.effort.max_newton_step);
  EXPECT_EQ(a.effort.max_mass_residual, b.effort.max_mass_residual);
  EXPECT_EQ(a.complete, b.complete);
}

void expect_same(const cycle::ContactCurves& a, const cycle::ContactCurves& b) {
  expect_same(a.separation, b.separation, "contact_separation");
  ASSERT_EQ(a.laws.size(), b.laws.size());
  for (std::size_t i = 0; i < a.laws.size(); ++i) {
    EXPECT_EQ(a.laws[i].name, b.laws[i].name);
    EXPECT_EQ(a.laws[i].label, b.laws[i].label);
  }
  expect_same(a.pressure, b.pressure, "contact_law_pressure");
  expect_same(a.log_deviation, b.log_deviation, "contact_law_log_deviation");
  expect_same(a.real_area, b.real_area, "contact_law_real_area");
  expect_same(a.phi_x, b.phi_x, "contact_law_phi_x");
  expect_same(a.phi_y, b.phi_y, "contact_law_phi_y");
  expect_same(a.phi_s, b.phi_s, "contact_law_phi_s");
}

void expect_same_ledger(const std::vector<study::LedgerEntry>& a, const std::vector<study::LedgerEntry>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].topic, b[i].topic);
    EXPECT_EQ(a[i].statement, b[i].statement);
    EXPECT_EQ(a[i].consequence, b[i].consequence);
    EXPECT_EQ(a[i].source, b[i].source);
    EXPECT_EQ(a[i].can_be_lifted, b[i].can_be_lifted);
    ASSERT_EQ(a[i].variants.size(), b[i].variants.size());
    for (std::size_t j = 0; j < a[i].variants.size(); ++j) {
      EXPECT_EQ(a[i].variants[j].setting, b[i].variants[j].setting);
      EXPECT_EQ(a[i].variants[j].solved, b[i].variants[j].solved);
      EXPECT_EQ(a[i].variants[j].reason, b[i].variants[j].reason);
      expect_same(a[i].variants[j].values, b[i].variants[j].values);
    }
  }
}

void expect_same_comparison(const std::vector<study::ComparisonRow>& a, const std::vector<study::ComparisonRow>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].published.source, b[i].published.source);
    EXPECT_EQ(a[i].published.quantity, b[i].published.quantity);
    EXPECT_EQ(a[i].published.statement, b[i].published.statement);
    EXPECT_EQ(a[i].published.value, b[i].published.value);
    EXPECT_EQ(a[i].published.decided_by, b[i].published.decided_by);
    EXPECT_EQ(a[i].computed, b[i].computed);
    EXPECT_EQ(a[i].deviation, b[i].deviation);
    EXPECT_EQ(a[i].strongest_setting, b[i].strongest_setting);
    EXPECT_EQ(a[i].with_strongest_setting, b[i].with_strongest_setting);
  }
}

void expect_same(const study::ErrorEstimate& a, const study::ErrorEstimate& b) {
  ASSERT_EQ(a.runs.size(), b.runs.size());
  for (std::size_t i = 0; i < a.runs.size(); ++i) {
    EXPECT_EQ(a.runs[i].cells, b.runs[i].cells);
    EXPECT_EQ(a.runs[i].crank_step_deg, b.runs[i].crank_step_deg);
    EXPECT_EQ(a.runs[i].step_error, b.runs[i].step_error);
    EXPECT_EQ(a.runs[i].solved, b.runs[i].solved);
    EXPECT_EQ(a.runs[i].reason, b.runs[i].reason);
  }
  ASSERT_EQ(a.samples.size(), b.samples.size());
  for (std::size_t k = 0; k < a.samples.size(); ++k) {
    for (const auto& q : cycle::curve_quantities()) expect_same(a.samples[k].*q.value, b.samples[k].*q.value, q.name);
  }
  expect_same(a.values, b.values);
  expect_same(a.order_in_cells, b.order_in_cells);
  expect_same(a.order_in_step, b.order_in_step);
}

void expect_same(const ResultDocument& a, const ResultDocument& b) {
  EXPECT_EQ(a.title, b.title);
  ASSERT_EQ(a.inputs.size(), b.inputs.size());
  for (std::size_t i = 0; i < a.inputs.size(); ++i) {
    EXPECT_EQ(a.inputs[i].key, b.inputs[i].key);
    EXPECT_EQ(a.inputs[i].value, b.inputs[i].value);
    EXPECT_EQ(a.inputs[i].shown, b.inputs[i].shown);
    EXPECT_EQ(a.inputs[i].assumed, b.inputs[i].assumed);
    EXPECT_EQ(a.inputs[i].help, b.inputs[i].help);
    EXPECT_EQ(a.inputs[i].unit, b.inputs[i].unit);
    EXPECT_EQ(exact_text(a.inputs[i].value_si), exact_text(b.inputs[i].value_si));  // NaN is not equal to itself
  }
  EXPECT_EQ(a.resolved_case, b.resolved_case);
  ASSERT_EQ(a.files.size(), b.files.size());
  for (std::size_t i = 0; i < a.files.size(); ++i) {
    EXPECT_EQ(a.files[i].role, b.files[i].role);
    EXPECT_EQ(a.files[i].path, b.files[i].path);
    EXPECT_EQ(a.files[i].sha256, b.files[i].sha256);
  }
  EXPECT_EQ(a.input_notes, b.input_notes);
  EXPECT_EQ(a.provenance.program, b.provenance.program);
  EXPECT_EQ(a.provenance.commit, b.provenance.commit);
  EXPECT_EQ(a.provenance.compiler, b.provenance.compiler);
  EXPECT_EQ(a.provenance.kernels, b.provenance.kernels);
  expect_same(a.result, b.result);
  expect_same(a.contact, b.contact);
  expect_same_ledger(a.ledger, b.ledger);
  EXPECT_EQ(a.ledger_computed, b.ledger_computed);
  expect_same_comparison(a.comparison, b.comparison);
  ASSERT_EQ(a.errors.has_value(), b.errors.has_value());
  if (a.errors) expect_same(*a.errors, *b.errors);
}

std::string bytes_of_result(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

void put_bytes(const std::string& path, const std::string& bytes) { std::ofstream(path, std::ios::binary) << bytes; }

std::string refusal_of_result(const std::string& path) {
  try {
    read_result(path);
  } catch (const InputError& error) {
    return error.what();
  }
  return "not refused";
}

/// Of a file that the library of NetCDF wrote, to be read as one of ours.
void append_digest(const std::string& path) {
  const std::string bytes = bytes_of_result(path);
  put_bytes(path, bytes + digest_trailer(sha256(bytes)));
}

TEST(ResultFile, GivesEveryFieldBackToTheBit) {
  const ScratchFolder folder;
  const ResultDocument document = example_document();
  write_result(folder / "a.nc", document);
  expect_same(document, read_result(folder / "a.nc"));
}

TEST(ResultFile, GivesAnEmptyStoppedResultBack) {
  const ScratchFolder folder;
  ResultDocument document;
  document.result.complete = false;
  write_result(folder / "a.nc", document);
  expect_same(document, read_result(folder / "a.nc"));
}

TEST(ResultFile, GivesCompressedFieldsAndALongCaseBack) {
  const ScratchFolder folder;
  ResultDocument document = example_document(3000);
  document.resolved_case = std::string(200000, 'c');  // beyond the 64 KiB of an attribute
  write_result(folder / "a.nc", document);
  expect_same(document, read_result(folder / "a.nc"));
}

TEST(ResultFile, SameDocumentGivesSameBytes) {
  const ScratchFolder folder;
  write_result(folder / "a.nc", example_document(1500));
  write_result(folder / "b.nc", example_document(1500));
  EXPECT_EQ(bytes_of_result(folder / "a.nc"), bytes_of_result(folder / "b.nc"));
}

TEST(ResultFile, IsRefusedWhereverItIsCutOff) {
  const ScratchFolder folder;
  write_result(folder / "a.nc", example_document(1500));
  const std::string whole = bytes_of_result(folder / "a.nc");
  for (const double share : {0.0, 0.001, 0.1, 0.5, 0.9, 0.999}) {
    put_bytes(folder / "cut.nc", whole.substr(0, static_cast<std::size_t>(share * static_cast<double>(whole.size()))));
    EXPECT_THAT(refusal_of_result(folder / "cut.nc"), HasSubstr("cut.nc")) << share;
  }
}

TEST(ResultFile, IsRefusedWhereverOneBitIsFlipped) {
  const ScratchFolder folder;
  write_result(folder / "a.nc", example_document());
  const std::string whole = bytes_of_result(folder / "a.nc");
  // A prime step comes by every place of a structure; the first block and the digest itself in full.
  for (std::size_t i = 0; i < whole.size(); i += i < 512 || i + kDigestTrailerSize >= whole.size() ? 1 : 97) {
    std::string changed = whole;
    changed[i] = static_cast<char>(changed[i] ^ (1 << i % 8));
    EXPECT_THROW(result_of_bytes("a.nc", changed), InputError) << "byte " << i;
  }
}

TEST(ResultFile, WithoutItsDigestIsRefusedBeforeItIsParsed) {
  const ScratchFolder folder;
  write_result(folder / "a.nc", example_document());
  const std::string whole = bytes_of_result(folder / "a.nc");
  put_bytes(folder / "b.nc", whole.substr(0, whole.size() - kDigestTrailerSize));
  EXPECT_THAT(refusal_of_result(folder / "b.nc"), HasSubstr("run its case again"));
  put_bytes(folder / "b.nc", whole + whole.substr(whole.size() - kDigestTrailerSize));
  EXPECT_THAT(refusal_of_result(folder / "b.nc"), HasSubstr("do not have the SHA-256 digest at its end"));
}

TEST(ResultFile, DigestIsThatOfTheBytesBeforeTheLastLine) {
  const ScratchFolder folder;
  write_result(folder / "a.nc", example_document());
  const std::string whole = bytes_of_result(folder / "a.nc");
  const std::size_t size = whole.rfind("\nringfilm sha256 ");
  ASSERT_EQ(size, whole.size() - kDigestTrailerSize);
  EXPECT_EQ(whole.substr(size + 17), sha256(whole.substr(0, size)) + "\n");
}

TEST(ResultFile, ForeignFilesAreRefusedWithTheirName) {
  const ScratchFolder folder;
  EXPECT_THAT(refusal_of_result(folder / "none.nc"), HasSubstr("no such file"));
  EXPECT_THAT(refusal_of_result(folder.path()), HasSubstr("folder"));
  put_bytes(folder / "text.nc", "title = \"a case\"\n");
  EXPECT_THAT(refusal_of_result(folder / "text.nc"), HasSubstr("not a NetCDF file"));

  int file = 0, variable = 0;
  ASSERT_EQ(nc_create((folder / "other.nc").c_str(), NC_NETCDF4, &file), NC_NOERR);
  ASSERT_EQ(nc_def_var(file, "temperature", NC_DOUBLE, 0, nullptr, &variable), NC_NOERR);
  ASSERT_EQ(nc_close(file), NC_NOERR);
  EXPECT_THAT(refusal_of_result(folder / "other.nc"), HasSubstr("does not end with the SHA-256 digest"));
  append_digest(folder / "other.nc");
  EXPECT_THAT(refusal_of_result(folder / "other.nc"), HasSubstr("not one of ringfilm"));
}

/// As nc_copy_var, which does not copy texts; without attributes.
void copy_variable(int from, int number, int to) {
  char name[NC_MAX_NAME + 1] = {};
  int type = 0, n_dimensions = 0, dimensions[NC_MAX_VAR_DIMS] = {}, variable = 0;
  ASSERT_EQ(nc_inq_var(from, number, name, &type, &n_dimensions, dimensions, nullptr), NC_NOERR);
  std::size_t count = 1;
  for (int i = 0; i < n_dimensions; ++i) {
    char dimension[NC_MAX_NAME + 1] = {};
    std::size_t length = 0;
    ASSERT_EQ(nc_inq_dim(from, dimensions[i], dimension, &length), NC_NOERR);
    ASSERT_EQ(nc_inq_dimid(to, dimension, &dimensions[i]), NC_NOERR);
    count *= length;
  }
  ASSERT_EQ(nc_def_var(to, name, type, n_dimensions, dimensions, &variable), NC_NOERR);
  std::vector<char*> values(count, nullptr);  // each as large as the largest type in the file
  ASSERT_EQ(nc_get_var(from, number, values.data()), NC_NOERR);
  ASSERT_EQ(nc_put_var(to, variable, values.data()), NC_NOERR);
  if (type == NC_STRING) nc_free_string(count, values.data());
}

/// Copies a result into a file that the library lets us change; the table of the ledger's variants may be left to the
/// caller to write.
enum class LedgerTable { kCopied, kLeftOut };
void make_editable(const std::string& path, const std::string& copy, LedgerTable ledger_table) {
  int from = 0, to = 0, n_dimensions = 0, n_variables = 0, n_attributes = 0;
  ASSERT_EQ(nc_open(path.c_str(), NC_NOWRITE, &from), NC_NOERR);
  ASSERT_EQ(nc_create(copy.c_str(), NC_NETCDF4, &to), NC_NOERR);
  ASSERT_EQ(nc_inq(from, &n_dimensions, &n_variables, &n_attributes, nullptr), NC_NOERR);
  char name[NC_MAX_NAME + 1] = {};
  for (int i = 0; i < n_dimensions; ++i) {
    std::size_t size = 0;
    ASSERT_EQ(nc_inq_dim(from, i, name, &size), NC_NOERR);
    if (ledger_table == LedgerTable::kLeftOut && name == std::string("cycle_quantity")) continue;
    ASSERT_EQ(nc_def_dim(to, name, size, nullptr), NC_NOERR);
  }
  for (int i = 0; i < n_attributes; ++i) {
    ASSERT_EQ(nc_inq_attname(from, NC_GLOBAL, i, name), NC_NOERR);
    ASSERT_EQ(nc_copy_att(from, NC_GLOBAL, name, to, NC_GLOBAL), NC_NOERR);
  }
  for (int i = 0; i < n_variables; ++i) {
    ASSERT_EQ(nc_inq_varname(from, i, name), NC_NOERR);
    const std::string variable = name;
    const bool is_of_table = variable == "variant_values" || variable.rfind("cycle_quantity", 0) == 0;
    if (ledger_table == LedgerTable::kLeftOut && is_of_table) continue;
    copy_variable(from, i, to);
  }
  nc_close(from);
  ASSERT_EQ(nc_close(to), NC_NOERR);
}

/// The example as a file of another version would be: its ledger has these cycle values, valued 0, 1, 2, ...
void write_with_ledger_of(const std::string& path, const std::vector<cycle::Quantity>& quantities) {
  write_result(path + ".all", example_document());
  make_editable(path + ".all", path, LedgerTable::kLeftOut);
  int file = 0, rows = 0, columns = 0, names = 0, units = 0, table = 0;
  std::size_t n_rows = 0;
  ASSERT_EQ(nc_open(path.c_str(), NC_WRITE, &file), NC_NOERR);
  ASSERT_EQ(nc_inq_dimid(file, "ledger_variant", &rows), NC_NOERR);
  ASSERT_EQ(nc_inq_dimlen(file, rows, &n_rows), NC_NOERR);
  ASSERT_EQ(nc_def_dim(file, "cycle_quantity", quantities.size(), &columns), NC_NOERR);
  ASSERT_EQ(nc_def_var(file, "cycle_quantity", NC_STRING, 1, &columns, &names), NC_NOERR);
  ASSERT_EQ(nc_def_var(file, "cycle_quantity_unit", NC_STRING, 1, &columns, &units), NC_NOERR);
  const int both[] = {rows, columns};
  ASSERT_EQ(nc_def_var(file, "variant_values", NC_DOUBLE, 2, both, &table), NC_NOERR);
  std::vector<const char*> name, unit;
  std::vector<double> values;
  for (const auto& quantity : quantities) {
    name.push_back(quantity.name.c_str());
    unit.push_back(quantity.unit.c_str());
  }
  for (std::size_t i = 0; i < n_rows * quantities.size(); ++i) values.push_back(static_cast<double>(i));
  ASSERT_EQ(nc_put_var_string(file, names, name.data()), NC_NOERR);
  ASSERT_EQ(nc_put_var_string(file, units, unit.data()), NC_NOERR);
  ASSERT_EQ(nc_put_var_double(file, table, values.data()), NC_NOERR);
  ASSERT_EQ(nc_close(file), NC_NOERR);
  append_digest(path);
}

TEST(ResultFile, LedgerOfAnotherVersionIsReadByNamesOrRefused) {
  const ScratchFolder folder;
  const auto& known = cycle::cycle_quantities();
  std::vector<cycle::Quantity> quantities(known.begin(), known.end());
  std::reverse(quantities.begin(), quantities.end());
  write_with_ledger_of(folder / "turned.nc", quantities);
  const ResultDocument turned = read_result(folder / "turned.nc");
  const cycle::CycleValues& values = turned.ledger.at(1).variants.at(0).values;
  EXPECT_EQ(values.*known.back().value, 0);
  EXPECT_EQ(values.*known.front().value, static_cast<double>(known.size() - 1));

  quantities.pop_back();
  write_with_ledger_of(folder / "fewer.nc", quantities);
  EXPECT_THAT(refusal_of_result(folder / "fewer.nc"), HasSubstr("variant_values has"));
  quantities.back().name = "mean_temper";
  write_with_ledger_of(folder / "other.nc", quantities);
  EXPECT_THAT(refusal_of_result(folder / "other.nc"), HasSubstr("mean_temper"));
}

TEST(ResultFile, NewerSchemaAndMissingVariablesAreRefused) {
  const ScratchFolder folder;
  write_result(folder / "whole.nc", example_document());
  make_editable(folder / "whole.nc", folder / "a.nc", LedgerTable::kCopied);
  int file = 0, variable = 0;
  ASSERT_EQ(nc_open((folder / "a.nc").c_str(), NC_WRITE, &file), NC_NOERR);
  ASSERT_EQ(nc_inq_varid(file, "power_loss", &variable), NC_NOERR);
  ASSERT_EQ(nc_rename_var(file, variable, "lost"), NC_NOERR);
  ASSERT_EQ(nc_close(file), NC_NOERR);
  append_digest(folder / "a.nc");
  EXPECT_THAT(refusal_of_result(folder / "a.nc"), HasSubstr("power_loss"));

  make_editable(folder / "whole.nc", folder / "a.nc", LedgerTable::kCopied);
  const long newer = 1000;
  ASSERT_EQ(nc_open((folder / "a.nc").c_str(), NC_WRITE, &file), NC_NOERR);
  ASSERT_EQ(nc_put_att_long(file, NC_GLOBAL, "ringfilm_schema", NC_INT64, 1, &newer), NC_NOERR);
  ASSERT_EQ(nc_close(file), NC_NOERR);
  append_digest(folder / "a.nc");
  EXPECT_THAT(refusal_of_result(folder / "a.nc"), HasSubstr("newer ringfilm"));
}

TEST(ResultFile, EveryNumberHasAUnitAndFieldsTheirEquation) {
  const ScratchFolder folder;
  write_result(folder / "a.nc", example_document());
  int file = 0, n_variables = 0;
  ASSERT_EQ(nc_open((folder / "a.nc").c_str(), NC_NOWRITE, &file), NC_NOERR);
  ASSERT_EQ(nc_inq_nvars(file, &n_variables), NC_NOERR);
  // Their columns or rows have units of their own, in variables beside them; the last one is in no table.
  const std::set<std::string> mixed = {"variant_values",      "comparison_published",
                                       "comparison_computed", "comparison_with_strongest_setting",
                                       "input_value_si",      "derived_not_in_the_table"};
  for (int i = 0; i < n_variables; ++i) {
    char name[NC_MAX_NAME + 1] = {};
    int type = 0;
    ASSERT_EQ(nc_inq_var(file, i, name, &type, nullptr, nullptr, nullptr), NC_NOERR);
    if (type == NC_STRING || mixed.contains(name)) continue;
    EXPECT_EQ(nc_inq_att(file, i, "units", nullptr, nullptr), NC_NOERR) << name;
  }
  for (const char* field : {"face_height", "film_thickness", "film_pressure", "film_content", "local_lambda_ratio",
                            "asperity_pressure", "archard_wear_load_density"}) {
    int variable = 0;
    ASSERT_EQ(nc_inq_varid(file, field, &variable), NC_NOERR) << field;
    EXPECT_EQ(nc_inq_att(file, variable, "symbol", nullptr, nullptr), NC_NOERR) << field;
    EXPECT_EQ(nc_inq_att(file, variable, "source_equation", nullptr, nullptr), NC_NOERR) << field;
  }
  int units = 0;
  EXPECT_EQ(nc_inq_varid(file, "comparison_unit", &units), NC_NOERR);
  nc_close(file);
}

TEST(ResultFile, CurvesCarryUnitsNamesAndSymbols) {
  const ScratchFolder folder;
  write_result(folder / "a.nc", example_document());
  int file = 0, variable = 0, dimension = 0;
  ASSERT_EQ(nc_open((folder / "a.nc").c_str(), NC_NOWRITE, &file), NC_NOERR);
  ASSERT_EQ(nc_inq_varid(file, "min_film_thickness", &variable), NC_NOERR);
  ASSERT_EQ(nc_inq_vardimid(file, variable, &dimension), NC_NOERR);
  char name[NC_MAX_NAME + 1] = {};
  ASSERT_EQ(nc_inq_dimname(file, dimension, name), NC_NOERR);
  EXPECT_STREQ(name, "crank_angle");
  const auto attribute = [&](const char* key) {
    std::size_t size = 0;
    EXPECT_EQ(nc_inq_attlen(file, variable, key, &size), NC_NOERR) << key;
    std::string value(size, '\0');
    EXPECT_EQ(nc_get_att_text(file, variable, key, value.data()), NC_NOERR) << key;
    return value;
  };
  EXPECT_EQ(attribute("units"), "m");
  EXPECT_EQ(attribute("long_name"), "minimum film thickness");
  EXPECT_FALSE(attribute("symbol").empty());
  EXPECT_FALSE(attribute("source_equation").empty());
  ASSERT_EQ(nc_inq_varid(file, "crank_angle", &variable), NC_NOERR);
  EXPECT_EQ(attribute("units"), "degree");
  nc_close(file);
}

}  // namespace
}  // namespace ringfilm::io
