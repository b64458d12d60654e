#include "ringfilm/instrument/documents/surface_measurement.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <utility>

#include "ringfilm/base/error.hpp"
#include "ringfilm/instrument/documents/material_ratio_values.hpp"
#include "ringfilm/instrument/documents/standard_surfaces.hpp"
#include "ringfilm/instrument/documents/surface_figures.hpp"
#include "ringfilm/instrument/documents/surface_side.hpp"
#include "ringfilm/instrument/documents/surface_values.hpp"
#include "ringfilm/io/case/contact_fragment.hpp"
#include "ringfilm/surface/asperity/scatter.hpp"
#include "ringfilm/surface/asperity/summits.hpp"
#include "ringfilm/surface/topography/material_ratio.hpp"
#include "ringfilm/surface/topography/roughness.hpp"

namespace ringfilm::instrument {
namespace {

constexpr double kDegreesPerRadian = 57.29577951308232;
constexpr std::size_t kEnoughForMaterialRatio = 100;  // points of the probability parameters

io::MeasuredGroup height_group(const PreparedSurface& surface) {
  const surface::HeightStatistics heights = height_statistics(surface.map);
  const bool profile = surface.map.is_profile();
  Group group("Heights", measured_with(surface) +
                             (profile ? "; ISO 21920-2 (ISO 4287), over the whole profile" : "; ISO 25178-2"));
  const auto add = [&](const char* tail, const char* words, double value, const char* unit, const char* display) {
    const std::string name = std::string(profile ? "R" : "S") + tail;
    group.add(name, words, name, unit, display, value);
  };
  add("a", "mean absolute deviation of heights", heights.Sa_m, "m", "um");
  add("q", "rms height", heights.Sq_m, "m", "um");
  add("sk", "skewness", heights.Ssk, "1", "1");
  add("ku", "kurtosis", heights.Sku, "1", "1");
  add(profile ? "pt" : "p", "highest peak above the mean", heights.Sp_m, "m", "um");
  add(profile ? "vt" : "v", "deepest pit below the mean", heights.Sv_m, "m", "um");
  add(profile ? "t" : "z", "peak to pit", heights.Sz_m, "m", "um");
  return group;
}

io::MeasuredGroup sampled_height_group(const PreparedSurface& surface, const SurfaceAnalysis& analysis) {
  const std::optional<double>& cutoff = analysis.preparation.long_cutoff_m;
  const surface::SampledHeights heights = sampled_heights(surface.map, cutoff);
  const std::string length = surface::length_text(heights.sampling_length_m);
  Group group("Heights, means over sampling lengths",
              measured_with(surface) + "; " +
                  (heights.count == 1 ? "one sampling length of " + length
                                      : fmt::format("mean of {} sampling lengths of {}", heights.count, length)) +
                  "; ISO 21920-2 (ISO 4287)");
  group.add("Rp", "highest peak above the mean, of each sampling length", "Rp", "m", "um", heights.Rp_m);
  group.add("Rv", "deepest pit below the mean, of each sampling length", "Rv", "m", "um", heights.Rv_m);
  group.add("Rz", "peak to pit of each sampling length", "Rz", "m", "um", heights.Rz_m);
  group.add("sampling_length", "sampling length", "", "m", "mm", heights.sampling_length_m,
            cutoff ? "the long cut-off" : "a fifth of the profile, without a long cut-off");
  group.add("sampling_lengths", "how many are in the profile", "", "1", "1", static_cast<double>(heights.count),
            "those that fit, in its middle");
  return group;
}

io::MeasuredGroup moment_group(const PreparedSurface& surface, const SurfaceAnalysis& analysis,
                               const surface::SpectralMoments* noise) {
  const surface::MomentTable table = moment_table(surface.map, analysis.scheme);
  Group group("Slopes and curvatures", measured_with(surface) + "; " + scheme_text(analysis.scheme));
  const auto add = [&](const std::string& name, const std::string& words, const char* unit, const char* display,
                       double value) { group.add(name, words, name, unit, display, value); };
  add(surface.map.is_profile() ? "Rdq" : "Sdq", "rms slope", "1", "1", rms_slope(table));
  add("m0", "variance of heights", "m2", "um2", table.m0_m2);
  if (!surface.map.is_profile()) {
    add("m2_x", "variance of slopes along x", "1", "1", table.m2_x);
    add("m2_y", "variance of slopes along y", "1", "1", table.m2_y);
    add("m4_x", "variance of curvatures along x", "m-2", "mm-2", table.m4_x_per_m2);
    add("m4_y", "variance of curvatures along y", "m-2", "mm-2", table.m4_y_per_m2);
  }
  const auto add_both = [&](const char* tail, const std::string& words, const surface::SpectralMoments& of) {
    add(std::string("m2") + tail, "variance of slopes" + words, "1", "1", of.m2);
    add(std::string("m4") + tail, "variance of curvatures" + words, "m-2", "mm-2", of.m4_per_m2);
  };
  if (analysis.angle_rad) {
    add_both("_at_angle", fmt::format(", profiles at {:.4g} degree to x", *analysis.angle_rad * kDegreesPerRadian),
             moments_at_angle(table, *analysis.angle_rad));
  }
  const surface::SpectralMoments used = moments(table, analysis.direction);
  if (noise == nullptr) {
    add_both("", ", in use", used);
  } else {
    add_both("", ", in use, less the noise of the flat", without_noise(used, *noise));
  }
  return group;
}

/// What the plateau of a surface made in two steps brings into a pair, and the fragment that states it; nothing of
/// another surface.
void add_plateau(const PreparedSurface& surface, const SurfaceAnalysis& analysis, const surface::SpectralMoments* noise,
                 const std::optional<surface::ProbabilityRoughness>& curve, io::Measurement& to) {
  if (!curve) return;
  const PlateauMeasures of = plateau_measures(surface.map, *curve, analysis, noise);
  const surface::AsperityParameters plateau = asperity_parameters(of.moments, curve->Rpq_m);
  Group group("Plateau, against a smooth surface", measured_with(surface));
  group.add("plateau_asperity_density", "asperity peaks per area of the plateau", "N", "m-2", "mm-2",
            plateau.density_per_m2);
  group.add("plateau_asperity_radius", "mean radius of their summits", "beta", "m", "um", plateau.beta_m);
  group.add("plateau_offset", "mean plane of the plateau above that of the surface", "z_p", "m", "um", of.offset_m);
  to.groups.push_back(group);
  cycle::Plateau stated;
  stated.Rpq = curve->Rpq_m;
  stated.Rvq = curve->Rvq_m;
  stated.Rmq = curve->Rmq;
  stated.surface_roughness = of.Sq_m;
  stated.offset = of.offset_m;
  to.fragment = io::plateau_fragment(
      stated, {"Plateau of " + file_name(surface.origin.path) + ", SHA-256 " + surface.origin.sha256,
               "a case states contact.plateau.ring_roughness, N and beta of the pair, too: ringfilm pair --plateau"});
}

std::vector<surface::AsperityParameters> parameters_of(const std::vector<surface::SurfaceMeasures>& measures,
                                                       const SurfaceAnalysis& analysis) {
  std::vector<surface::AsperityParameters> parameters;
  for (const surface::SurfaceMeasures& one : measures) {
    parameters.push_back(single_parameters(one, analysis.sigma_rule));
  }
  return parameters;
}

void add_asperities(const PreparedSurface& surface, const SurfaceAnalysis& analysis,
                    const surface::SpectralMoments* noise, io::Measurement& to) {
  const std::vector<surface::SurfaceMeasures> measures = measures_of_regions(surface, analysis, noise);
  const std::vector<surface::AsperityParameters> parameters = parameters_of(measures, analysis);
  const std::string with = measured_with(surface), sigma = with + "; " + surface_sigma_text(analysis.sigma_rule);
  if (parameters.size() < 2) {
    to.groups.push_back(
        asperity_group("Asperities, this surface against a smooth one", parameters.front(), with, sigma));
  } else {
    const surface::ParameterScatter scatter = surface::scatter_of(parameters);
    to.groups.push_back(scatter_group(scatter, with, sigma));
    to.tables.push_back(covariance_table(scatter.covariance_log));
    if (parameters.size() < kEnoughForScatter) to.notes.push_back(few_samples_note(parameters.size()));
  }
  if (!surface.regions.empty()) to.tables.push_back(region_table(surface, measures, parameters));
}

}  // namespace

io::Measurement surface_measurement(const SurfaceFile& file, const SurfaceAnalysis& analysis, const SurfaceFile* flat) {
  const PreparedSurface surface = prepare_surface(file, analysis);
  const std::string with = measured_with(surface);
  io::Measurement all;
  all.kind = "surface";
  all.title = "Surface " + file_name(file.origin.path);
  all.sources = source_lines(surface);
  all.statements = analysis_lines(surface, analysis);
  std::optional<surface::SpectralMoments> noise;
  if (flat != nullptr) {
    noise = noise_moments(*flat, surface, analysis);
    all.statements.push_back("moments of the flat " + flat->origin.path + " removed m0, m2 and m4 of N and beta");
  }
  all.notes = surface_notes(file, surface, analysis);
  add_doubts(flat, all.notes);

  // A map that is too small, flat or empty for one of them still has the others.
  const auto attempt = [&](const char* what, const auto& add) {
    try {
      add();
    } catch (const InputError& refusal) {
      all.notes.push_back(std::string("no ") + what + ": " + refusal.faults().front().message);
    }
  };
  attempt("height statistics", [&] { all.groups.push_back(height_group(surface)); });
  if (surface.map.is_profile()) {
    attempt("Rp, Rv and Rz", [&] { all.groups.push_back(sampled_height_group(surface, analysis)); });
  }
  std::optional<surface::ProbabilityRoughness> two_steps;
  {
    const std::vector<double> falling = surface::material_ratio_curve(surface.map);
    if (falling.size() >= kEnoughForMaterialRatio) {
      attempt("material ratio parameters", [&] {
        two_steps = surface::probability_roughness(falling);
        all.groups.push_back(material_ratio_group(surface, falling, analysis, two_steps));
      });
    }
    all.curves.push_back(profile_curve(surface));
    all.curves.push_back(material_ratio_curve(falling));
    attempt("marks of the core", [&] {
      const surface::CoreRoughness core = surface::core_roughness(falling);
      all.curves.back().marks = {{core.Mr1, "Mr1"}, {core.Mr2, "Mr2"}};
    });
  }
  const surface::SpectralMoments* const removed = noise ? &*noise : nullptr;
  attempt("slopes and curvatures", [&] { all.groups.push_back(moment_group(surface, analysis, removed)); });
  if (!surface.map.is_profile()) attempt("texture", [&] { all.groups.push_back(texture_group(surface)); });
  if (!surface.map.is_profile() && analysis.standard_surfaces == StandardSurfaces::kSfAndSl) {
    for (io::MeasuredGroup& group : standard_groups(file, analysis, all.notes)) all.groups.push_back(std::move(group));
  }
  attempt("N, beta and sigma", [&] { add_asperities(surface, analysis, removed, all); });
  attempt("plateau", [&] { add_plateau(surface, analysis, removed, two_steps, all); });
  if (!surface.map.is_profile()) {
    attempt("summits", [&] {
      all.groups.push_back(summit_group(
          "Summits counted one by one (higher than all eight neighbours)", count_summits(surface.map),
          single_parameters(surface_measures(surface.map, analysis.direction, analysis.scheme), analysis.sigma_rule),
          with));
    });
  }
  attempt("power spectrum", [&] { all.curves.push_back(spectrum_curve(surface)); });
  attempt("table against the short cut-off", [&] {
    all.tables.push_back(scale_table(surface, analysis));
    if (all.tables.back().row_labels.size() > 1) all.curves.push_back(scale_curve(all.tables.back(), analysis));
  });
  if (!surface.map.is_profile()) all.maps.push_back(height_map(surface, "height"));
  return all;
}

io::Measurement surfaces_measurement(const std::vector<SurfaceFile>& files, const SurfaceAnalysis& analysis,
                                     const SurfaceFile* flat) {
  const Side side = measured_side("surface", files, analysis, flat);
  io::Measurement all;
  all.kind = "surface";
  all.title = "Surface " + names_of(side);
  const std::vector<surface::AsperityParameters> parameters = parameters_of(side.measures, analysis);
  bool unlike = false;
  for (std::size_t k = 0; k < files.size(); ++k) {
    const PreparedSurface& surface = side.surfaces[k];
    for (std::string& line : source_lines(surface)) all.sources.push_back(std::move(line));
    for (const std::string& note : surface_notes(files[k], surface, analysis)) {
      all.notes.push_back(file_name(surface.origin.path) + ": " + note);
    }
    if (!surface.map.is_profile()) {
      all.maps.push_back(height_map(surface, fmt::format("height_{}", k + 1)));
      all.maps.back().title = "Heights of " + file_name(surface.origin.path);
    }
    unlike = unlike || measured_with(surface) != measured_with(side.surfaces.front());
  }
  add_doubts(flat, all.notes);
  if (unlike) all.notes.push_back("the files have different steps: their m4, N and beta do not belong together");
  if (parameters.size() < kEnoughForScatter) all.notes.push_back(few_samples_note(parameters.size()));
  all.statements = analysis_lines(side.surfaces.front(), analysis);
  if (flat != nullptr) all.statements.push_back("moments of the flat " + flat->origin.path + " removed m2 and m4");
  const std::string with = measured_with(side.surfaces.front());
  const surface::ParameterScatter scatter = surface::scatter_of(parameters);
  all.groups.push_back(scatter_group(scatter, with, with + "; " + surface_sigma_text(analysis.sigma_rule)));
  all.tables.push_back(side_table(side, analysis, "What each sample measures"));
  all.tables.push_back(covariance_table(scatter.covariance_log));
  return all;
}

}  // namespace ringfilm::instrument
