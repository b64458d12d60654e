#include "ringfilm/io/measurement/measurement_netcdf.hpp"

#include <gtest/gtest.h>
#include <netcdf.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "../measurement_example.hpp"
#include "../scratch_folder.hpp"
#include "ringfilm/base/error.hpp"

namespace ringfilm::io {
namespace {

const Provenance kWriter{"ringfilm 0.0.0", "abc", "g++", ""};

/// Reads by the library itself, not by our reader.
class OpenedMeasurement {
 public:
  explicit OpenedMeasurement(const std::string& path) {
    EXPECT_EQ(nc_open(path.c_str(), NC_NOWRITE, &file_), NC_NOERR);
  }
  OpenedMeasurement(const OpenedMeasurement&) = delete;
  OpenedMeasurement& operator=(const OpenedMeasurement&) = delete;
  ~OpenedMeasurement() { nc_close(file_); }

  int variable(const std::string& name) const {
    int number = -1;
    EXPECT_EQ(nc_inq_varid(file_, name.c_str(), &number), NC_NOERR) << name;
    return number;
  }
  std::vector<std::string> dimensions(const std::string& name) const {
    int n = 0, numbers[NC_MAX_VAR_DIMS];
    nc_inq_varndims(file_, variable(name), &n);
    nc_inq_vardimid(file_, variable(name), numbers);
    std::vector<std::string> names;
    for (int i = 0; i < n; ++i) {
      char text[NC_MAX_NAME + 1];
      nc_inq_dimname(file_, numbers[i], text);
      names.push_back(text);
    }
    return names;
  }
  std::vector<double> numbers(const std::string& name) const {
    int n = 0, ids[NC_MAX_VAR_DIMS];
    nc_inq_varndims(file_, variable(name), &n);
    nc_inq_vardimid(file_, variable(name), ids);
    std::size_t count = 1;
    for (int i = 0; i < n; ++i) {
      std::size_t length = 0;
      nc_inq_dimlen(file_, ids[i], &length);
      count *= length;
    }
    std::vector<double> values(count);
    EXPECT_EQ(nc_get_var_double(file_, variable(name), values.data()), NC_NOERR) << name;
    return values;
  }
  std::string text(const std::string& name, const char* attribute) const {
    const int number = name.empty() ? NC_GLOBAL : variable(name);
    std::size_t length = 0;
    EXPECT_EQ(nc_inq_attlen(file_, number, attribute, &length), NC_NOERR) << name << " " << attribute;
    std::string value(length, ' ');
    nc_get_att_text(file_, number, attribute, value.data());
    return value;
  }
  double number(const std::string& name, const char* attribute) const {
    double value = 0;
    EXPECT_EQ(nc_get_att_double(file_, variable(name), attribute, &value), NC_NOERR) << name << " " << attribute;
    return value;
  }
  bool has(const std::string& name, const char* attribute) const {
    return nc_inq_attid(file_, variable(name), attribute, nullptr) == NC_NOERR;
  }
  std::vector<std::string> texts(const std::string& name, std::size_t count) const {
    std::vector<char*> pointers(count);
    EXPECT_EQ(nc_get_var_string(file_, variable(name), pointers.data()), NC_NOERR) << name;
    std::vector<std::string> values(pointers.begin(), pointers.end());
    nc_free_string(count, pointers.data());
    return values;
  }

 private:
  int file_ = -1;
};

void expect_same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(std::isnan(a[i]), std::isnan(b[i])) << i;
    if (std::isnan(a[i])) continue;
    ASSERT_EQ(a[i], b[i]) << i;
  }
}

std::string bytes_of_measurement(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

TEST(MeasurementNetcdf, HoldsValuesWithUnitErrorAndRemark) {
  const ScratchFolder folder;
  const Measurement document = example::measurement();
  write_measurement(folder / "a.nc", document, kWriter);
  const OpenedMeasurement file(folder / "a.nc");
  for (const MeasuredGroup& group : document.groups) {
    for (const MeasuredValue& value : group.values) {
      EXPECT_TRUE(file.dimensions(value.name).empty());
      expect_same_bits(file.numbers(value.name), {value.value});
      EXPECT_EQ(file.text(value.name, "units"), value.unit);
      EXPECT_EQ(file.text(value.name, "long_name"), value.long_name);
      EXPECT_EQ(file.text(value.name, "remark"), value.remark);
      EXPECT_EQ(file.has(value.name, "standard_error"), !std::isnan(value.standard_error));
      if (std::isnan(value.standard_error)) continue;
      EXPECT_EQ(file.number(value.name, "standard_error"), value.standard_error);
    }
  }
  EXPECT_EQ(file.text("", "title"), document.title);
  EXPECT_EQ(file.text("", "program"), kWriter.program);
  EXPECT_EQ(file.texts("note_text", 2), document.notes);
  EXPECT_EQ(file.texts("fragment", 1).front(), document.fragment);
}

TEST(MeasurementNetcdf, HoldsAMapOverItsPlaces) {
  const ScratchFolder folder;
  const Measurement document = example::measurement();
  const MeasuredMap& map = document.maps.front();
  write_measurement(folder / "a.nc", document, kWriter);
  const OpenedMeasurement file(folder / "a.nc");
  EXPECT_EQ(file.dimensions("surface_height"), (std::vector<std::string>{"surface_height_y", "surface_height_x"}));
  EXPECT_EQ(file.dimensions("surface_height_x"), std::vector<std::string>{"surface_height_x"});
  expect_same_bits(file.numbers("surface_height"), map.values);
  EXPECT_TRUE(std::isnan(file.number("surface_height", "_FillValue")));
  const std::vector<double> rows = file.numbers("surface_height_y");
  ASSERT_EQ(rows.size(), map.points_y);
  EXPECT_EQ(rows.front(), 0);
  EXPECT_EQ(rows.back(), static_cast<double>(map.points_y - 1) * map.step_y);
  EXPECT_EQ(file.text("surface_height_x", "units"), "m");
  EXPECT_EQ(file.texts("surface_height_frame", 2), (std::vector<std::string>{"1", "2"}));
  expect_same_bits(file.numbers("surface_height_frame_width"), {0.2e-3, 0.2e-3});
}

TEST(MeasurementNetcdf, HoldsCurvesAndTablesOverDimensionsOfTheirOwn) {
  const ScratchFolder folder;
  const Measurement document = example::measurement();
  write_measurement(folder / "a.nc", document, kWriter);
  const OpenedMeasurement file(folder / "a.nc");
  for (const MeasuredCurve& curve : document.curves) {
    const std::string along = curve.name + "_" + curve.x_axis.name;
    EXPECT_EQ(file.dimensions(along), std::vector<std::string>{along});
    expect_same_bits(file.numbers(along), curve.x);
    for (const MeasuredSeries& series : curve.series) {
      EXPECT_EQ(file.dimensions(curve.name + "_" + series.name), std::vector<std::string>{along});
      expect_same_bits(file.numbers(curve.name + "_" + series.name), series.y);
      EXPECT_EQ(file.text(curve.name + "_" + series.name, "units"), curve.y_axis.unit);
    }
  }
  expect_same_bits(file.numbers("bearing_mark_place"), {0.09, 0.88});
  EXPECT_EQ(file.texts("bearing_mark_label", 2), (std::vector<std::string>{"Mr1", "Mr2"}));
  EXPECT_EQ(file.dimensions("regions_asperity_density"), std::vector<std::string>{"regions_row"});
  expect_same_bits(file.numbers("regions_asperity_radius"), document.tables.front().values[1]);
  EXPECT_EQ(file.texts("regions_row", 2), document.tables.front().row_labels);
}

TEST(MeasurementNetcdf, SameDocumentGivesTheSameBytes) {
  const ScratchFolder folder;
  write_measurement(folder / "a.nc", example::measurement(), kWriter);
  write_measurement(folder / "b.nc", example::measurement(), kWriter);
  EXPECT_EQ(bytes_of_measurement(folder / "a.nc"), bytes_of_measurement(folder / "b.nc"));
}

TEST(MeasurementNetcdf, TakesAnEmptyDocument) {
  const ScratchFolder folder;
  Measurement document;
  document.tables = {{"empty", "Nothing", {{"a", "", "", "1", "1", 0, 0, ""}}, {{}}, {}}};
  write_measurement(folder / "a.nc", document, kWriter);
  EXPECT_EQ(OpenedMeasurement(folder / "a.nc").text("", "commit"), "abc");
}

TEST(MeasurementNetcdf, LeavesNothingBehindWhereItCannotBeWritten) {
  const ScratchFolder folder;
  EXPECT_THROW(write_measurement(folder / "no_folder/a.nc", example::measurement(), kWriter), OutputError);
  Measurement document = example::measurement();
  document.maps[0].name = document.groups[0].values[0].name;  // two variables of one name
  EXPECT_THROW(write_measurement(folder / "a.nc", document, kWriter), std::logic_error);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace ringfilm::io
