#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "ringfilm/base/error.hpp"
#include "ringfilm/instrument/documents/surface_figures.hpp"
#include "ringfilm/instrument/documents/surface_side.hpp"
#include "ringfilm/instrument/documents/surface_values.hpp"
#include "ringfilm/io/case/contact_fragment.hpp"
#include "ringfilm/models/contact/asperity_contact.hpp"
#include "ringfilm/surface/asperity/scatter.hpp"
#include "ringfilm/surface/asperity/summits.hpp"

namespace ringfilm::instrument {
namespace {

/// Which filters and pixels the numbers hold for: of all maps in one, or one for each side.
std::string pair_measured_with(const Side& ring, const Side& liner) {
  const std::string of_ring = measured_with(ring.surfaces.front()), of_liner = measured_with(liner.surfaces.front());
  return of_ring == of_liner ? of_ring : "ring: " + of_ring + "; liner: " + of_liner;
}

/// Deviations and correlations of the parameters themselves, from those of their logarithms.
void set_scatter(const surface::PairScatter& scatter, io::PairOfSurfaces& pair) {
  const auto& covariance = scatter.covariance_log;
  const auto deviation = [&](std::size_t k) { return std::sqrt(covariance[k][k]); };
  cycle::MeasuredContact& to = pair.measured;
  to.regions = static_cast<double>(std::max(scatter.first_count, scatter.second_count));
  if (scatter.without_scatter == "both") return;
  to.asperity_density_deviation = deviation(0) * scatter.central.density_per_m2;
  to.asperity_radius_deviation = deviation(1) * scatter.central.beta_m;
  to.roughness_deviation = deviation(2) * scatter.central.sigma_m;
  to.density_radius_correlation = surface::correlation(covariance, 0, 1);
  to.density_roughness_correlation = surface::correlation(covariance, 0, 2);
  to.radius_roughness_correlation = surface::correlation(covariance, 1, 2);
}

/// Means over the samples of both sides.
cycle::Plateau plateau_for_case(const Side& ring, const Side& liner) {
  const auto mean = [](const auto& samples, const auto& value) {
    double sum = 0;
    for (const auto& sample : samples) sum += value(sample);
    return sum / static_cast<double>(samples.size());
  };
  const auto mean_plateau = [&](const auto& value) { return mean(liner.plateaus, value); };
  cycle::Plateau plateau;
  plateau.Rpq = mean_plateau([](const PlateauMeasures& of) { return of.curve.Rpq_m; });
  plateau.Rvq = mean_plateau([](const PlateauMeasures& of) { return of.curve.Rvq_m; });
  plateau.Rmq = mean_plateau([](const PlateauMeasures& of) { return of.curve.Rmq; });
  plateau.surface_roughness = mean_plateau([](const PlateauMeasures& of) { return of.Sq_m; });
  plateau.offset = mean_plateau([](const PlateauMeasures& of) { return of.offset_m; });
  plateau.ring_roughness = mean(ring.measures, [](const surface::SurfaceMeasures& of) { return of.Sq_m; });
  return plateau;
}

io::MeasuredGroup plateau_group(const cycle::Plateau& plateau, const std::string& rule) {
  Group group("The plateau of the liner, which carries", rule);
  group.add("Rpq", "rms of the plateau", "Rpq", "m", "um", *plateau.Rpq);
  group.add("Rvq", "rms of the valleys", "Rvq", "m", "um", *plateau.Rvq);
  group.add("Rmq", "material ratio where plateau and valleys meet", "Rmq", "1", "%", *plateau.Rmq);
  group.add("ring_roughness", "rms height of the ring", "Rq", "m", "um", plateau.ring_roughness);
  group.add("surface_roughness", "rms height of the whole liner", "Rq", "m", "um", *plateau.surface_roughness);
  group.add("plateau_offset", "mean plane of the plateau above that of the whole liner", "z_p", "m", "um",
            *plateau.offset);
  return group;
}

io::PairOfSurfaces pair_for_case(const Side& ring, const Side& liner, const SurfaceAnalysis& analysis,
                                 const surface::PairScatter& scatter, const SurfaceFile* flat) {
  io::PairOfSurfaces pair;
  pair.asperity_density = scatter.central.density_per_m2;
  pair.asperity_radius = scatter.central.beta_m;
  pair.roughness = scatter.central.sigma_m;
  pair.roughness_measure = cycle::RoughnessMeasure::kAsGiven;
  pair.measured.ring_surface = names_of(ring);
  pair.measured.liner_surface = names_of(liner);
  const PreparedSurface& first = ring.surfaces.front();
  pair.measured.filter = first.prepared.form.text + " removed; filter: " + first.prepared.filter_text();
  if (flat != nullptr) *pair.measured.filter += "; noise of " + file_name(flat->origin.path) + " removed";
  pair.measured.short_cutoff = analysis.preparation.short_cutoff_m;
  pair.measured.long_cutoff = analysis.preparation.long_cutoff_m;
  pair.measured.step = first.map.step_x_m;
  pair.measured.roughness_rule = sigma_text(analysis.sigma_rule);
  pair.measured.difference_scheme = moment_text(first, analysis);
  set_scatter(scatter, pair);
  if (!liner.plateaus.empty()) {
    pair.plateau = plateau_for_case(ring, liner);
    pair.measured.roughness_rule = "Rq of the ring and Rpq of the plateau of the liner, root-sum-square";
  }
  return pair;
}

/// What a Gaussian surface of these numbers has; nothing where none exists.
std::optional<models::SummitStatistics> summits_of(const surface::PairScatter& scatter) {
  return models::summit_statistics(
      {scatter.central.density_per_m2, scatter.central.beta_m, scatter.central.sigma_m, 1});
}

io::MeasuredGroup summit_plane_group(const models::SummitStatistics& summits, const std::string& rule) {
  Group group("Summits of a Gaussian surface with this N, beta and sigma", rule);
  group.add("asperity_bandwidth", "bandwidth parameter", "alpha", "1", "1", summits.bandwidth);
  group.add("asperity_slope", "rms slope", "h'", "1", "1", summits.rms_slope);
  group.add("summit_plane_offset", "plane of the summits above that of the surface", "z_s", "m", "um",
            summits.summit_offset);
  group.add("summit_spread", "standard deviation of the summit heights", "sigma_s", "m", "um", summits.summit_spread);
  return group;
}

io::MeasuredGroup pair_group(const surface::PairScatter& scatter, const std::string& rule, const std::string& sigma) {
  Group group = asperity_group("The pair in contact", scatter.central, rule, sigma);
  if (scatter.without_scatter == "both") return group;
  std::array<double, 3> errors = {scatter.central.density_per_m2, scatter.central.beta_m, scatter.central.sigma_m};
  for (std::size_t k = 0; k < 3; ++k) errors[k] *= std::sqrt(scatter.mean_covariance_log[k][k]);
  add_scatter("standard deviation of one region of each, relative", errors, scatter.covariance_log, group);
  return group;
}

}  // namespace

io::Measurement pair_measurement(const std::vector<SurfaceFile>& ring_files,
                                 const std::vector<SurfaceFile>& liner_files, const SurfaceAnalysis& analysis,
                                 const SurfaceFile* flat) {
  if (analysis.liner == CarryingPart::kPlateau && analysis.sigma_rule == surface::SigmaRule::ra) {
    throw InputError("--sigma Ra and --plateau contradict each other: Rpq of the plateau is an rms height",
                     "leave --sigma out, or --plateau");
  }
  if (analysis.hardness && analysis.sigma_rule == surface::SigmaRule::ra) {
    throw InputError(
        "--sigma Ra and --hardness contradict each other: contact laws with a hardness take sigma as the rms "
        "height, Rq",
        "leave --sigma out, or --hardness");
  }
  const Side ring = measured_side("ring", ring_files, analysis, flat);
  const Side liner = measured_side("liner", liner_files, analysis, flat, analysis.liner);
  const surface::PairScatter scatter = scatter_of_pair(ring.measures, liner.measures, analysis.sigma_rule);

  io::Measurement all;
  all.kind = "pair";
  all.title = "Contact of " + names_of(ring) + " with " + names_of(liner);
  for (const Side* side : {&ring, &liner}) {
    for (const PreparedSurface& surface : side->surfaces) {
      std::vector<std::string> lines = source_lines(surface);
      lines.front() = side->name + ": " + lines.front();
      all.sources.insert(all.sources.end(), lines.begin(), lines.end());
    }
  }
  all.statements = analysis_lines(ring.surfaces.front(), analysis);
  all.statements.push_back("sigma: " + sigma_text(analysis.sigma_rule));
  all.statements.push_back("m2 and m4 of both surfaces add up");
  if (!liner.plateaus.empty()) {
    all.statements.push_back(
        "liner: Rpq, m2 and m4 of its plateau, what lies above the meeting of both lines of its "
        "material ratio curve; its Sa and Sq are those of the plateau");
  }
  if (flat != nullptr) all.statements.push_back("moments of the flat " + flat->origin.path + " removed both");
  const auto add_notes = [&](const Side& side, const std::vector<SurfaceFile>& files) {
    for (std::size_t k = 0; k < files.size(); ++k) {
      for (const std::string& note : surface_notes(files[k], side.surfaces[k], analysis)) {
        all.notes.push_back(file_name(files[k].origin.path) + ": " + note);
      }
    }
  };
  add_notes(ring, ring_files);
  add_notes(liner, liner_files);
  add_doubts(flat, all.notes);
  bool same_steps = true;
  for (const Side* side : {&ring, &liner}) {
    for (const PreparedSurface& surface : side->surfaces) {
      same_steps = same_steps && !steps_differ(surface.map, ring.surfaces.front().map);
    }
  }
  if (!same_steps && !analysis.preparation.short_cutoff_m) {
    all.notes.push_back(
        "the maps have different steps: without a common --short-cutoff their m4 do not belong together");
  }
  if (!scatter.without_scatter.empty()) {
    all.notes.push_back(scatter.without_scatter == "both"
                            ? "one region of each surface: N, beta and sigma have no scatter; name more files or --grid"
                            : "one region of the " +
                                  std::string(scatter.without_scatter == "first" ? "ring" : "liner") +
                                  ": it adds nothing to the scatter, which is then too small");
  }

  if (scatter.without_scatter != "both") {
    const std::size_t samples = std::max(ring.measures.size(), liner.measures.size());
    if (samples < kEnoughForScatter) all.notes.push_back(few_samples_note(samples));
  }

  const std::string rule = pair_measured_with(ring, liner);
  all.groups.push_back(pair_group(scatter, rule, rule + "; " + surface_sigma_text(analysis.sigma_rule)));
  io::PairOfSurfaces pair = pair_for_case(ring, liner, analysis, scatter, flat);
  if (pair.plateau) all.groups.push_back(plateau_group(*pair.plateau, rule));
  const auto summits = summits_of(scatter);
  if (summits) all.groups.push_back(summit_plane_group(*summits, rule));
  if (!summits && analysis.hardness) {
    all.notes.push_back(
        "no Gaussian surface has this N, beta and sigma together: the fragment states no plane of the summits");
  }
  const surface::HeightMap &first = ring.surfaces.front().map, &second = liner.surfaces.front().map;
  const bool maps = !first.is_profile() && !second.is_profile();
  if (maps && !pair.plateau && !steps_differ(first, second)) {
    all.groups.push_back(summit_group("Summits of the composite surface counted one by one (first map of each)",
                                      count_summits_of_pair(first, second), scatter.central, rule));
  }
  all.tables.push_back(side_table(ring, analysis, "What the ring brings into the pair"));
  all.tables.push_back(side_table(liner, analysis, "What the liner brings into the pair"));
  if (scatter.without_scatter != "both") all.tables.push_back(covariance_table(scatter.covariance_log));
  for (const Side* side : {&ring, &liner}) {
    const PreparedSurface& surface = side->surfaces.front();
    if (surface.map.is_profile()) continue;
    all.maps.push_back(height_map(surface, side->name + "_height"));
    all.maps.back().title = "Heights of the " + side->name;
  }
  std::vector<std::string> heading = {"N, beta and sigma of " + names_of(ring) + " against " + names_of(liner)};
  for (const Side* side : {&ring, &liner}) {
    for (std::string& line : digest_lines(*side)) heading.push_back(std::move(line));
  }
  for (const auto* files : {&ring_files, &liner_files}) {
    for (const SurfaceFile& file : *files) add_doubts(&file, heading, "note: ");
  }
  add_doubts(flat, heading, "note: ");
  if (summits) pair.hardness = analysis.hardness;
  all.fragment = contact_fragment(pair, heading);
  return all;
}

}  // namespace ringfilm::instrument
