#include "ringfilm/instrument/documents/material_ratio_values.hpp"

#include <fmt/format.h>

#include <string>

#include "ringfilm/base/error.hpp"
#include "ringfilm/instrument/documents/surface_values.hpp"
#include "ringfilm/surface/topography/areal_texture.hpp"

namespace ringfilm::instrument {
namespace {

constexpr double kUsualRatioDepth_m = 1e-6;  // assumed: usual on drawings of liners
constexpr double kReferenceRatio = 0.05;     // leaves the highest peaks aside

}  // namespace

io::MeasuredGroup material_ratio_group(const PreparedSurface& surface, const std::vector<double>& falling,
                                       const SurfaceAnalysis& analysis,
                                       const std::optional<surface::ProbabilityRoughness>& two_steps) {
  const bool is_profile = surface.map.is_profile();
  const std::string with = measured_with(surface), letter = is_profile ? "R" : "S";
  const std::string core_standard = is_profile ? "ISO 21920-2 (ISO 13565-2)" : "ISO 25178-2";
  Group group("Material ratio curve", with + "; " + core_standard);
  const auto add = [&](const std::string& name, const char* words, double value, const char* unit,
                       const char* display) { group.add(name, words, name, unit, display, value); };
  const surface::CoreRoughness core = surface::core_roughness(falling);
  if (!two_steps) group.remark += "; no plateau over deeper valleys, eq-surface-probability";
  add(letter + "k", "core roughness", core.Rk_m, "m", "um");
  add(letter + "pk", "reduced peaks", core.Rpk_m, "m", "um");
  add(letter + "vk", "reduced valleys", core.Rvk_m, "m", "um");
  const std::string ratio = is_profile ? "Mr" : "Smr";
  add(ratio + "1", "material ratio of the peaks", core.Mr1, "1", "%");
  add(ratio + "2", "material ratio where valleys begin", core.Mr2, "1", "%");
  group.remark = with + fmt::format("; triangle of the valleys, {}vk (1 - {}2)/2", letter, ratio);
  group.add("oil_retention_volume", "oil that the valleys can hold, for each area", "V_o", "m", "um",
            surface::oil_retention_volume(core));
  if (two_steps) {
    group.remark = with + "; " + (is_profile ? "ISO 21920-2 (ISO 13565-3)" : "ISO 25178-2");
    add(letter + "pq", "rms of the plateau", two_steps->Rpq_m, "m", "um");
    add(letter + "vq", "rms of the valleys", two_steps->Rvq_m, "m", "um");
    add(letter + "mq", "material ratio where plateau and valleys meet", two_steps->Rmq, "1", "%");
  }
  const double depth_m = analysis.ratio_depth_m.value_or(kUsualRatioDepth_m);
  group.remark = with + "; " + core_standard +
                 fmt::format("; {} below the height at {:g} %{}", surface::length_text(depth_m), 100 * kReferenceRatio,
                             analysis.ratio_depth_m ? "" : ", both assumed");
  add(letter + "mr", "material ratio at a depth", surface::material_ratio_at_depth(falling, kReferenceRatio, depth_m),
      "1", "%");
  if (!is_profile) {
    const surface::VolumeParameters volumes = surface::volume_parameters(falling);
    group.remark = with + "; ISO 25178-2, planes at 10 and 80 %";
    add("Vmp", "material of the peaks, for each area", volumes.Vmp_m, "m", "um");
    add("Vmc", "material of the core, for each area", volumes.Vmc_m, "m", "um");
    add("Vvc", "void of the core, for each area", volumes.Vvc_m, "m", "um");
    add("Vvv", "void of the valleys, for each area", volumes.Vvv_m, "m", "um");
  }
  const auto& cavity_depth_m = analysis.cavity_depth_m;
  const surface::Cavities pores = cavity_depth_m
                                      ? surface::cavities(falling, surface::CavityRule::below_depth, *cavity_depth_m)
                                      : surface::cavities(falling, surface::CavityRule::below_plateau);
  group.remark = cavity_depth_m ? "deeper than " + surface::length_text(*cavity_depth_m) + " below the median"
                                : "deeper than 3 standard deviations of the plateau below the median";
  group.add("cavity_area_share", "area share of cavities (porosity)", "", "1", "%", pores.area_share);
  group.add("cavity_mean_depth", "their mean depth below the median", "", "m", "um", pores.mean_depth_m);
  group.add("cavity_volume", "their volume for each area", "", "m", "um", pores.volume_m);
  return group;
}

io::MeasuredGroup texture_group(const PreparedSurface& surface) {
  const surface::HeightMap& map = surface.map;
  const std::string with = measured_with(surface);
  Group group("Texture", with + "; ISO 25178-2");
  group.add("Sdr", "developed interfacial area ratio", "Sdr", "1", "%", surface::developed_area_ratio(map));
  try {
    const surface::AutocorrelationLengths lengths = surface::autocorrelation_lengths(map);
    group.remark += ", autocorrelation to 0.2";
    group.add("Sal", "autocorrelation length", "Sal", "m", "um", lengths.Sal_m);
    if (lengths.Str) group.add("Str", "texture aspect ratio", "Str", "1", "1", *lengths.Str);
  } catch (const InputError&) {  // waves as long as the map: they have no length here
  }
  if (const auto honing = surface::honing_angle(map)) {
    group.remark = with + "; angular spectrum of the slopes, in steps of 1 degree";
    group.add("honing_angle", "angle between the grooves of a cross-hatch", "", "rad", "degree", honing->angle_rad);
    group.add("honing_angle_scatter", "standard deviation of the directions of its grooves", "", "rad", "degree",
              honing->scatter_rad);
    group.add("honing_lay", "direction of the stronger grooves, from x towards y", "", "rad", "degree",
              honing->first_rad);
    group.add("honing_second_lay", "direction of the others, from x towards y", "", "rad", "degree",
              honing->second_rad);
  }
  return group;
}

}  // namespace ringfilm::instrument
