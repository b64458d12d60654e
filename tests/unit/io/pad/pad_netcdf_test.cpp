#include "ringfilm/io/pad/pad_netcdf.hpp"

#include <gtest/gtest.h>
#include <netcdf.h>

#include <cmath>

#include "../scratch_folder.hpp"

namespace ringfilm::io {
namespace {

class OpenedPad {
 public:
  explicit OpenedPad(const std::string& path) { EXPECT_EQ(nc_open(path.c_str(), NC_NOWRITE, &file_), NC_NOERR); }
  OpenedPad(const OpenedPad&) = delete;
  OpenedPad& operator=(const OpenedPad&) = delete;
  ~OpenedPad() { nc_close(file_); }

  bool has(const std::string& name) const {
    int variable = 0;
    return nc_inq_varid(file_, name.c_str(), &variable) == NC_NOERR;
  }

  std::string dimensions(const std::string& name) const {
    int n = 0, numbers[NC_MAX_VAR_DIMS] = {}, variable = 0;
    EXPECT_EQ(nc_inq_varid(file_, name.c_str(), &variable), NC_NOERR) << name;
    nc_inq_varndims(file_, variable, &n);
    nc_inq_vardimid(file_, variable, numbers);
    std::string all;
    for (int i = 0; i < n; ++i) {
      char text[NC_MAX_NAME + 1] = {};
      nc_inq_dimname(file_, numbers[i], text);
      all += std::string(i > 0 ? "," : "") + text;
    }
    return all;
  }

  std::vector<double> values(const std::string& name, std::size_t n) const {
    std::vector<double> values(n);
    int variable = 0;
    nc_inq_varid(file_, name.c_str(), &variable);
    EXPECT_EQ(nc_get_var_double(file_, variable, values.data()), NC_NOERR) << name;
    return values;
  }

 private:
  int file_ = -1;
};

PadDocument two_instants() {
  PadDocument document;
  document.title = "a pad";
  pad::PadResult& result = document.result;
  result.x = {0, 0.5, 0.5, 1};
  for (const double time : {0.0, 0.25}) {
    pad::Sample sample;
    sample.time = time;
    sample.load = 3 + time;
    result.samples.push_back(sample);
    result.profiles.push_back({time, {2, 2, 1, 1}, {0, 4, 4, 0}, {1, 0.5, 1, 1}});
  }
  result.notes.push_back({"mass-residual", "it is large"});
  return document;
}

TEST(PadNetcdf, HoldsTheFilmAlongAnInfinitelyWidePad) {
  const ScratchFolder folder;
  write_pad(folder / "film.nc", two_instants());
  const OpenedPad file(folder / "film.nc");
  EXPECT_EQ(file.dimensions("pressure"), "time,x");
  EXPECT_EQ(file.dimensions("load"), "time");
  EXPECT_EQ(file.values("x", 4), (std::vector<double>{0, 0.5, 0.5, 1}));
  EXPECT_EQ(file.values("film_thickness", 8), (std::vector<double>{2, 2, 1, 1, 2, 2, 1, 1}));
  EXPECT_EQ(file.values("load", 2), (std::vector<double>{3, 3.25}));
  EXPECT_TRUE(file.has("note_text"));
  EXPECT_FALSE(file.has("y"));
  EXPECT_FALSE(file.has("total_load"));
}

TEST(PadNetcdf, HoldsTheFieldsOfAPadWithAWidth) {
  PadDocument document = two_instants();
  document.result.y = {0, 2};
  for (const double time : {0.0, 0.25}) {
    document.result.fields.push_back(
        {time, {2, 2, 1, 1, 4, 4, 3, 3}, std::vector<double>(8, time), std::vector<double>(8, 1)});
  }
  document.result.samples.back().total_load = 7;
  const ScratchFolder folder;
  write_pad(folder / "film.nc", document);
  const OpenedPad file(folder / "film.nc");
  EXPECT_EQ(file.dimensions("film_thickness"), "time,y,x");
  EXPECT_EQ(file.dimensions("film_content"), "time,y,x");
  EXPECT_EQ(file.values("y", 2), (std::vector<double>{0, 2}));
  EXPECT_EQ(file.values("film_thickness", 16)[12], 4);
  EXPECT_EQ(file.values("pressure", 16)[15], 0.25);
  EXPECT_EQ(file.values("total_load", 2), (std::vector<double>{0, 7}));
  EXPECT_TRUE(file.has("flow_front"));

  for (pad::Sample& sample : document.result.samples) sample.flow_front = std::nan("");
  write_pad(folder / "joined.nc", document);
  const OpenedPad joined(folder / "joined.nc");
  EXPECT_FALSE(joined.has("flow_front")) << "a flow that is not reported";
  EXPECT_TRUE(joined.has("flow_back"));
}

}  // namespace
}  // namespace ringfilm::io
