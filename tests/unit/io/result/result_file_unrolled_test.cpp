#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netcdf.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "../result_example.hpp"
#include "../scratch_folder.hpp"
#include "ringfilm/io/result/result_csv.hpp"
#include "ringfilm/io/result/result_file.hpp"
#include "ringfilm/io/result/result_json.hpp"

/// What a result on the unrolled ring has beside that of a film across the face, in each form of output.
namespace ringfilm::io {
namespace {

template <class Row, class Quantities>
void expect_same_unrolled(const Row& a, const Row& b, const Quantities& quantities) {
  for (const auto& q : quantities) {
    if (std::isnan(a.*q.value)) {
      EXPECT_TRUE(std::isnan(b.*q.value)) << q.name;
    } else {
      EXPECT_EQ(a.*q.value, b.*q.value) << q.name;
    }
  }
}

void expect_same_unrolled(const cycle::CycleResult& a, const cycle::CycleResult& b) {
  ASSERT_EQ(a.unrolled_samples.size(), b.unrolled_samples.size());
  for (std::size_t k = 0; k < a.unrolled_samples.size(); ++k) {
    expect_same_unrolled(a.unrolled_samples[k], b.unrolled_samples[k], cycle::unrolled_quantities());
  }
  expect_same_unrolled(a.unrolled_values, b.unrolled_values, cycle::unrolled_cycle_quantities());
  EXPECT_EQ(a.unrolled.circumference, b.unrolled.circumference);
  EXPECT_EQ(a.unrolled.end_gap, b.unrolled.end_gap);
  EXPECT_EQ(a.unrolled.gap_position, b.unrolled.gap_position);
  EXPECT_EQ(a.unrolled.x, b.unrolled.x);
  EXPECT_EQ(a.unrolled.y, b.unrolled.y);
  EXPECT_EQ(a.unrolled.crank_angle_deg, b.unrolled.crank_angle_deg);
  for (const auto* fields : {&cycle::unrolled_fields(), &cycle::strip_fields()}) {
    for (const auto& field : *fields) EXPECT_EQ(a.unrolled.*field.values, b.unrolled.*field.values) << field.name;
  }
}

TEST(UnrolledResultFile, GivesEverythingBackHoweverFieldsAreKept) {
  const ScratchFolder folder;
  for (const KeptFields kept : {KeptFields::kNone, KeptFields::kInFull, KeptFields::kByStrips}) {
    const ResultDocument document = unrolled_document(kept);
    write_result(folder / "a.nc", document);
    const ResultDocument read = read_result(folder / "a.nc");
    expect_same_unrolled(document.result, read.result);
    ASSERT_TRUE(read.errors.has_value());
    EXPECT_EQ(read.errors->runs.at(1).cells_y, 180);
  }
}

TEST(UnrolledResultFile, AFilmAcrossTheFaceHasNothingOfIt) {
  const ScratchFolder folder;
  write_result(folder / "a.nc", example_document());
  EXPECT_TRUE(read_result(folder / "a.nc").result.unrolled.is_absent());
}

TEST(UnrolledResultFile, AStoppedIntegrationWithoutSamplesComesBackAsSuch) {
  const ScratchFolder folder;
  ResultDocument document = unrolled_document(KeptFields::kNone, 0);
  document.result.samples.clear();
  document.errors.reset();
  document.result.complete = false;
  write_result(folder / "a.nc", document);
  const ResultDocument read = read_result(folder / "a.nc");
  EXPECT_FALSE(read.result.unrolled.is_absent());
  EXPECT_TRUE(read.result.unrolled_samples.empty());
}

TEST(UnrolledResultFile, FieldsAreOverAngleStripAndNodeInPiecesOfOneAngle) {
  const ScratchFolder folder;
  ResultDocument document = unrolled_document(KeptFields::kInFull);
  cycle::UnrolledFields& unrolled = document.result.unrolled;
  unrolled.y.resize(500, 0.2);  // smaller ones are not worth their pieces
  for (const auto& field : cycle::unrolled_fields()) (unrolled.*field.values).resize(2 * 500 * 3, 0.5F);
  write_result(folder / "a.nc", document);
  int file = 0, variable = 0, type = 0, n_dimensions = 0, storage = 0, shuffled = 0, deflated = 0, level = 0;
  ASSERT_EQ(nc_open((folder / "a.nc").c_str(), NC_NOWRITE, &file), NC_NOERR);
  for (const char* name :
       {"unrolled_film_thickness", "unrolled_film_pressure", "unrolled_film_content", "unrolled_asperity_pressure"}) {
    ASSERT_EQ(nc_inq_varid(file, name, &variable), NC_NOERR) << name;
    int dimensions[3] = {};
    ASSERT_EQ(nc_inq_varndims(file, variable, &n_dimensions), NC_NOERR);
    ASSERT_EQ(n_dimensions, 3);
    ASSERT_EQ(nc_inq_var(file, variable, nullptr, &type, nullptr, dimensions, nullptr), NC_NOERR);
    EXPECT_EQ(type, NC_FLOAT);
    std::vector<std::string> names;
    for (const int dimension : dimensions) {
      char text[NC_MAX_NAME + 1] = {};
      ASSERT_EQ(nc_inq_dimname(file, dimension, text), NC_NOERR);
      names.emplace_back(text);
    }
    EXPECT_THAT(names, ::testing::ElementsAre("field_crank_angle", "y", "x"));
    std::size_t piece[3] = {};
    ASSERT_EQ(nc_inq_var_chunking(file, variable, &storage, piece), NC_NOERR);
    EXPECT_THAT(piece, ::testing::ElementsAre(1, 500, 3));
    ASSERT_EQ(nc_inq_var_deflate(file, variable, &shuffled, &deflated, &level), NC_NOERR);
    EXPECT_EQ(deflated, 1);
    for (const char* attribute : {"units", "long_name", "symbol", "source_equation"}) {
      EXPECT_EQ(nc_inq_att(file, variable, attribute, nullptr, nullptr), NC_NOERR) << name << " " << attribute;
    }
  }
  nc_close(file);
}

TEST(UnrolledResultCsv, HasItsColumnsAfterTheCurvesAndBeforeTheErrors) {
  const ResultDocument document = unrolled_document(KeptFields::kNone);
  const auto header = [](const std::string& csv) { return csv.substr(0, csv.find('\n')); };
  const std::string plain = header(result_csv(document.result.samples));
  const std::string own = header(result_csv(document.result.samples, {}, document.result.unrolled_samples));
  EXPECT_EQ(own, plain +
                     ",gap_leakage [kg/s],ends_share_load,ends_share_friction,ends_share_flow,"
                     "gap_leakage_low_end [kg/s],gap_leakage_high_end [kg/s],oil_flow_without_ends [kg/s],"
                     "open_area [m2],lifted_angle [degree],max_clearance [m],max_clearance_place [degree]");
  const std::string all =
      header(result_csv(document.result.samples, document.errors, document.result.unrolled_samples));
  EXPECT_THAT(all, ::testing::StartsWith(own + ","));
  EXPECT_THAT(plain, ::testing::Not(::testing::HasSubstr("gap_leakage")));
}

TEST(UnrolledResultJson, HasItsValuesByNameWithTheirUnits) {
  const ResultDocument document = unrolled_document(KeptFields::kNone);
  const auto object = nlohmann::json::parse(result_json(document));
  for (const auto& quantity : cycle::unrolled_cycle_quantities()) {
    EXPECT_EQ(object.at(quantity.name).get<double>(), document.result.unrolled_values.*quantity.value);
    EXPECT_EQ(object.at("units").at(quantity.name), quantity.unit);
  }
  EXPECT_EQ(object.at("error_estimate").at("runs").at(0).at("cells_y"), 180);
  const auto face = nlohmann::json::parse(result_json(example_document()));
  EXPECT_FALSE(face.contains("mean_gap_leakage"));
  EXPECT_EQ(face.at("error_estimate").at("runs").at(0).at("cells_y"), 0);
}

}  // namespace
}  // namespace ringfilm::io
