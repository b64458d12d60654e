#pragma once
#include <span>
#include <string>
#include <vector>

#include "ringfilm/instrument/documents/surface_measurement.hpp"
#include "ringfilm/surface/asperity/scatter.hpp"
#include "ringfilm/surface/asperity/summits.hpp"

/// Rows and lines that measurements of one surface and of a pair share.
namespace ringfilm::instrument {

io::MeasuredValue value_of(const std::string& name, const std::string& long_name, const std::string& symbol,
                           const std::string& unit, const std::string& display_unit, double value,
                           const std::string& remark);

/// Another column of a table, empty.
void add_column(io::MeasuredTable& table, const std::string& name, const std::string& long_name,
                const std::string& symbol, const std::string& unit, const std::string& display_unit);

/// Another row. @param values as many as there are columns, or more, of which the rest is omitted
void add_row(io::MeasuredTable& table, const std::string& label, std::span<const double> values);

/// Where a region lies on its map.
io::MeasuredFrame frame_of(const surface::Region& region, const surface::HeightMap& map, const std::string& label);

/// The last part of a path.
std::string file_name(const std::string& path);

/// Are two steps one, but for the digits of their files?
bool same_step(double a_m, double b_m);
/// Of two maps; a profile has no step along y.
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
io::MeasuredGroup asperity_group(const std::string& title, const surface::AsperityParameters& of,
                                 const std::string& remark, const std::string& sigma_text);

/// Means of N, beta and sigma over regions with their standard errors, standard deviations and correlations.
io::MeasuredGroup scatter_group(const surface::ParameterScatter& scatter, const std::string& remark,
                                const std::string& sigma_text);

/// The three correlations of N, beta and sigma. @param covariance_log of their logarithms
void add_correlations(const surface::ParameterScatter::Matrix& covariance_log, const std::string& remark,
                      io::MeasuredGroup& group);

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
