#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "ringfilm/instrument/documents/surface_measurement.hpp"
#include "ringfilm/surface/asperity/scatter.hpp"
#include "ringfilm/surface/asperity/summits.hpp"

/// Groups, tables and lines that the documents share.
namespace ringfilm::instrument {

/// A group of values that are added one by one.
struct Group : io::MeasuredGroup {
  /// @param usual_remark remark on all values that have none of their own
  explicit Group(std::string heading, std::string usual_remark = "")
      : io::MeasuredGroup{std::move(heading), {}}, remark(std::move(usual_remark)) {}

  /// A value with the usual remark and without a standard error.
  void add(const std::string& name, const std::string& long_name, const std::string& symbol, const std::string& unit,
           const std::string& display_unit, double value) {
    add(name, long_name, symbol, unit, display_unit, value, remark);
  }
  /// A value with a remark of its own. @param error its standard error; NaN: none
  void add(const std::string& name, const std::string& long_name, const std::string& symbol, const std::string& unit,
           const std::string& display_unit, double value, const std::string& own_remark, double error = std::nan("")) {
    values.push_back({name, long_name, symbol, unit, display_unit, value, error, own_remark});
  }

  std::string remark;  ///< filter, pixel size and rule of the values
};

/// Another column of a table. @returns its values, for its rows
std::vector<double>& add_column(io::MeasuredTable& table, const std::string& name, const std::string& long_name,
                                const std::string& symbol, const std::string& unit, const std::string& display_unit);

/// Another row of a table without labels.
/// @param values as many as there are columns, or more, of which the rest is omitted
void add_row(io::MeasuredTable& table, const std::vector<double>& values);
/// Another row with its label.
void add_row(io::MeasuredTable& table, const std::string& label, const std::vector<double>& values);

/// A curve without places and series.
io::MeasuredCurve curve_of(const std::string& name, const std::string& title, const std::string& caption,
                           const io::MeasuredAxis& x_axis, const io::MeasuredAxis& y_axis);

/// Lines on the origin of a file: format, channel, instrument, date, plausibility, digest and statements of the user.
/// @param channel text on the channel among several
std::vector<std::string> origin_lines(const SurfaceOrigin& origin, const std::string& channel,
                                      const std::string& plausibility_line);

/// Where a region lies on its map.
io::MeasuredFrame frame_of(const surface::Region& region, const surface::HeightMap& map, const std::string& label);

/// The last part of a path.
std::string file_name(const std::string& path);

/// Are two steps one, but for the digits of their files?
bool same_step(double a_m, double b_m);
/// Do the steps of two maps differ? A profile has no step along y.
bool steps_differ(const surface::HeightMap& a, const surface::HeightMap& b);

/// How slopes and curvatures were made, and along which direction.
std::string moment_text(const PreparedSurface& surface, const SurfaceAnalysis& analysis);

/// Form, filters, rules, in their order.
std::vector<std::string> analysis_lines(const PreparedSurface& surface, const SurfaceAnalysis& analysis);

/// Adds the doubts about a file as lines that name it. @param file nullptr: none @param before what each line starts
/// with
void add_doubts(const SurfaceFile* file, std::vector<std::string>& lines, const std::string& before = "");

/// What is odd about a surface or how it was measured: doubts about its file, tilt left in, steps that differ, missing
/// points.
std::vector<std::string> surface_notes(const SurfaceFile& file, const PreparedSurface& surface,
                                       const SurfaceAnalysis& analysis);

/// Which roughness of one surface is used as sigma.
std::string surface_sigma_text(surface::SigmaRule rule);

/// N, beta, sigma, N beta sigma and sigma/beta. @param sigma_text how sigma came about
Group asperity_group(const std::string& title, const surface::AsperityParameters& of, const std::string& remark,
                     const std::string& sigma_text);

/// Means of N, beta and sigma over regions with their standard errors, standard deviations and correlations.
io::MeasuredGroup scatter_group(const surface::ParameterScatter& scatter, const std::string& remark,
                                const std::string& sigma_text);

/// Adds to N, beta and sigma, the first values of a group, their scatter.
/// @param words meaning of the relative deviations
/// @param standard_error standard error of each of the three values
/// @param covariance_log covariance of their logarithms
void add_scatter(const std::string& words, const std::array<double, 3>& standard_error,
                 const surface::ParameterScatter::Matrix& covariance_log, Group& group);

/// Number and density of summits; their radius and heights where there are any.
io::MeasuredGroup summit_group(const std::string& title, const surface::Summits& summits,
                               const surface::AsperityParameters& of_moments, const std::string& remark);

/// Fewer samples than this report little of deviations and correlations.
inline constexpr std::size_t kEnoughForScatter = 5;
std::string few_samples_note(std::size_t samples);

/// Covariance of the logarithms of N, beta and sigma of one sample.
io::MeasuredTable covariance_table(const surface::ParameterScatter::Matrix& covariance_log);

/// Place and parameters of each region.
io::MeasuredTable region_table(const PreparedSurface& surface, const std::vector<surface::SurfaceMeasures>& measures,
                               const std::vector<surface::AsperityParameters>& parameters);

}  // namespace ringfilm::instrument
