#include "height_maps.hpp"
#include "record.hpp"
#include "ringfilm/instrument/surface_file.hpp"
#include "ringfilm/surface/asperities.hpp"
#include "ringfilm/surface/bearing.hpp"
#include "ringfilm/surface/preparation.hpp"
#include "ringfilm/surface/roughness.hpp"
#include "ringfilm/surface/summits.hpp"

namespace ringfilm::python {
namespace {

using namespace surface;

const std::map<std::string, FormKind> kForms{{"none", FormKind::none},
                                             {"mean", FormKind::mean},
                                             {"tilt", FormKind::tilt},
                                             {"cylinder", FormKind::cylinder},
                                             {"polynomial", FormKind::polynomial}};
const std::map<std::string, FilterKind> kFilters{{"gaussian", FilterKind::gaussian},
                                                 {"robust-gaussian", FilterKind::robust_gaussian}};
const std::map<std::string, MomentDirection> kDirections{{"x", MomentDirection::x},
                                                         {"y", MomentDirection::y},
                                                         {"mean", MomentDirection::mean},
                                                         {"geometric", MomentDirection::geometric}};
const std::map<std::string, DifferenceScheme> kSchemes{{"neighbours", DifferenceScheme::neighbours},
                                                       {"seven-point", DifferenceScheme::seven_point}};
const std::map<std::string, SigmaRule> kRules{{"ra", SigmaRule::ra}, {"rq", SigmaRule::rq}};
const std::map<std::string, CavityRule> kCavityRules{{"below-depth", CavityRule::below_depth},
                                                     {"below-plateau", CavityRule::below_plateau},
                                                     {"below-core", CavityRule::below_core}};

py::tuple prepared(const Heights& heights, const py::object& step, const std::string& form, int degree,
                   const std::optional<double>& short_cutoff, const std::optional<double>& long_cutoff,
                   const std::string& filter) {
  HeightMap map = height_map(heights, step);
  Preparation wanted;
  wanted.form = {chosen("form", form, kForms), degree};
  wanted.short_cutoff_m = short_cutoff;
  wanted.long_cutoff_m = long_cutoff;
  wanted.filter = chosen("filter", filter, kFilters);
  const Prepared done = prepare(map, wanted);
  return py::make_tuple(heights_of(map, heights), done.lines());
}

void bind_records(py::module_& module) {
  Record<HeightStatistics>(module, "HeightStatistics",
                           "Height statistics; Ra, Rq, ... of a profile. Source: docs/theory, eq-surface-heights.")
      .with("points", &HeightStatistics::points, "Measured points.")
      .with("missing", &HeightStatistics::missing, "Points without a height.")
      .with("mean_m", &HeightStatistics::mean_m, "Mean height [m].")
      .with("Sa_m", &HeightStatistics::Sa_m, "Mean absolute deviation [m].")
      .with("Sq_m", &HeightStatistics::Sq_m, "Rms deviation [m].")
      .with("Ssk", &HeightStatistics::Ssk, "Skewness [-].")
      .with("Sku", &HeightStatistics::Sku, "Kurtosis [-], 3 for a Gaussian.")
      .with("Sp_m", &HeightStatistics::Sp_m, "Highest peak above the mean [m].")
      .with("Sv_m", &HeightStatistics::Sv_m, "Deepest pit below the mean [m], positive.")
      .with("Sz_m", &HeightStatistics::Sz_m, "Peak to pit [m].");
  Record<RowRoughness>(module, "RowRoughness", "Roughness of the rows of a map, each about its own mean.")
      .with("Ra_m", &RowRoughness::Ra_m, "Mean of Ra [m].")
      .with("Rq_m", &RowRoughness::Rq_m, "Root of the mean square of Rq [m].")
      .with("rows", &RowRoughness::rows, "Rows that had enough points.");
  Record<CoreRoughness>(module, "CoreRoughness", "Core, peaks and valleys after ISO 13565-2.")
      .with("Rk_m", &CoreRoughness::Rk_m, "Core roughness [m].")
      .with("Rpk_m", &CoreRoughness::Rpk_m, "Reduced peaks [m].")
      .with("Rvk_m", &CoreRoughness::Rvk_m, "Reduced valleys [m].")
      .with("Mr1", &CoreRoughness::Mr1, "Material ratio where the core begins [-].")
      .with("Mr2", &CoreRoughness::Mr2, "Material ratio where it ends [-].")
      .with("upper_m", &CoreRoughness::upper_m, "Height of the core's line at 0 [m].")
      .with("lower_m", &CoreRoughness::lower_m, "Height of the core's line at 1 [m].");
  Record<ProbabilityRoughness>(module, "ProbabilityRoughness", "A surface made in two steps, after ISO 13565-3.")
      .with("Rpq_m", &ProbabilityRoughness::Rpq_m, "Rms of the plateau [m].")
      .with("Rvq_m", &ProbabilityRoughness::Rvq_m, "Rms of the valleys [m].")
      .with("Rmq", &ProbabilityRoughness::Rmq, "Material ratio where both meet [-].");
  Record<Cavities>(module, "Cavities", "Pores and grooves. Source: docs/theory, eq-surface-cavities.")
      .with("area_share", &Cavities::area_share, "Of the measured points [-].")
      .with("threshold_m", &Cavities::threshold_m, "Height below which a point counts [m].")
      .with("mean_depth_m", &Cavities::mean_depth_m, "Mean depth below the median [m].")
      .with("volume_m", &Cavities::volume_m, "Volume for each nominal area [m].");
  Record<Summits>(module, "Summits", "Summits counted one by one. Source: docs/theory, eq-summits.")
      .with("count", &Summits::count, "How many.")
      .with("density_per_m2", &Summits::density_per_m2, "Per area [1/m2].")
      .with("mean_curvature_per_m", &Summits::mean_curvature_per_m, "Mean curvature [1/m].")
      .with("mean_radius_m", &Summits::mean_radius_m, "1/mean curvature [m].")
      .with("mean_height_m", &Summits::mean_height_m, "Above the mean of the map [m].")
      .with("rms_height_m", &Summits::rms_height_m, "Of the summits about their own mean [m].");
  Record<SummitTheory>(module, "SummitTheory", "What Gaussian isotropic surfaces should show, after Nayak (1971).")
      .with("bandwidth", &SummitTheory::bandwidth, "m0 m4/m2^2 [-].")
      .with("density_per_m2", &SummitTheory::density_per_m2, "Summits per area [1/m2].")
      .with("mean_curvature_per_m", &SummitTheory::mean_curvature_per_m, "Mean curvature [1/m].")
      .with("mean_height_m", &SummitTheory::mean_height_m, "Mean height [m].")
      .with("rms_height_m", &SummitTheory::rms_height_m, "Rms height about it [m].");
  Record<SpectralMoments> moments_record(module, "SpectralMoments",
                                         "Variances of heights, slopes, curvatures. Source: eq-surface-moments.");
  moments_record.with("m0_m2", &SpectralMoments::m0_m2, "Of heights [m2].")
      .with("m2", &SpectralMoments::m2, "Of slopes [-].")
      .with("m4_per_m2", &SpectralMoments::m4_per_m2, "Of curvatures [1/m2].");
  moments_record.type().def(py::init([](double m0, double m2, double m4) {
                              return SpectralMoments{m0, m2, m4};
                            }),
                            py::arg("m0_m2"), py::arg("m2"), py::arg("m4_per_m2"), "From three numbers in SI.");
  Record<SurfaceMeasures> measures(module, "SurfaceMeasures", "What one surface brings into a pair.");
  measures.with("Sa_m", &SurfaceMeasures::Sa_m, "Mean absolute deviation [m].")
      .with("Sq_m", &SurfaceMeasures::Sq_m, "Rms deviation [m].")
      .with("moments", &SurfaceMeasures::moments, "Its SpectralMoments.");
  measures.type().def(py::init([](double Sa, double Sq, const SpectralMoments& of) {
                        return SurfaceMeasures{Sa, Sq, of};
                      }),
                      py::arg("Sa_m"), py::arg("Sq_m"), py::arg("moments"), "From numbers in SI.");
  Record<AsperityParameters> asperities(module, "AsperityParameters",
                                        "What a contact model takes. Source: docs/theory/surface.md.");
  asperities.with("density_per_m2", &AsperityParameters::density_per_m2, "N [1/m2].")
      .with("beta_m", &AsperityParameters::beta_m, "Mean summit radius [m].")
      .with("sigma_m", &AsperityParameters::sigma_m, "Composite roughness [m].");
  asperities.type()
      .def("tabor", &AsperityParameters::tabor, "N beta sigma [-].")
      .def("slope", &AsperityParameters::slope, "sigma/beta [-].");
}

void bind_functions(py::module_& module) {
  module.def("_prepare", &prepared, py::arg("heights"), py::arg("step"), py::arg("form"), py::arg("degree"),
             py::arg("short_cutoff"), py::arg("long_cutoff"), py::arg("filter"), "See ringfilm.surface.prepare.");
  module.def("gaussian_transmission", py::vectorize(&gaussian_transmission), py::arg("wavelength"), py::arg("cutoff"),
             "Share of the amplitude of a wave that a Gaussian S-filter lets pass [-]; numbers or arrays [m].");
  module.def(
      "height_statistics",
      [](const Heights& heights, const py::object& step) { return height_statistics(height_map(heights, step)); },
      py::arg("heights"), py::arg("step"),
      R"(Height statistics of all measured points about their mean.

heights: shape (y, x), or (x,) for a profile [m]; NaN where nothing was measured. step: a number or (x, y) [m].
Raises InputError for fewer than 4 points or a flat surface. Source: docs/theory, eq-surface-heights.)");
  module.def(
      "row_roughness",
      [](const Heights& heights, const py::object& step) { return row_roughness(height_map(heights, step)); },
      py::arg("heights"), py::arg("step"),
      "Ra and Rq of the rows of a map of shape (y, x) [m]. Raises InputError where no row has 8 measured points.");
  module.def(
      "bearing_curve",
      [](const Heights& heights, const py::object& step) { return array_of(bearing_curve(height_map(heights, step))); },
      py::arg("heights"), py::arg("step"),
      "Heights of the measured points, falling, shape (points,) [m]: the bearing curve.");
  module.def(
      "core_roughness", [](const Heights& curve) { return core_roughness(numbers_of(curve)); }, py::arg("curve"),
      "Rk family of a bearing curve of shape (points,) [m]. Source: ISO 13565-2, eq-surface-core.");
  module.def(
      "probability_roughness", [](const Heights& curve) { return probability_roughness(numbers_of(curve)); },
      py::arg("curve"),
      "Rpq, Rvq, Rmq of a bearing curve [m]; None for a surface made in one step. Source: ISO 13565-3.");
  module.def(
      "cavities",
      [](const Heights& curve, const std::string& rule, double depth) {
        return cavities(numbers_of(curve), chosen("rule", rule, kCavityRules), depth);
      },
      py::arg("curve"), py::arg("rule") = "below-plateau", py::arg("depth") = 0.0,
      R"(Share of the area that are pores and grooves, of a bearing curve of shape (points,) [m].

rule: "below-plateau", "below-core" or "below-depth" with its depth below the median [m]. Raises InputError.
Source: docs/theory, eq-surface-cavities.)");
  module.def(
      "moments",
      [](const Heights& heights, const py::object& step, const std::string& direction, const std::string& scheme) {
        return moments(moment_table(height_map(heights, step), chosen("scheme", scheme, kSchemes)),
                       chosen("direction", direction, kDirections));
      },
      py::arg("heights"), py::arg("step"), py::arg("direction") = "mean", py::arg("scheme") = "neighbours",
      R"(Spectral moments of a map of shape (y, x), or of a profile (x,) along x [m].

direction: "mean" of x and y, "geometric", "x", "y". scheme: "neighbours" or "seven-point".
Raises InputError for fewer than 16 complete stencils. Source: docs/theory, eq-surface-moments.)");
  module.def(
      "surface_measures",
      [](const Heights& heights, const py::object& step, const std::string& direction, const std::string& scheme) {
        return surface_measures(height_map(heights, step), chosen("direction", direction, kDirections),
                                chosen("scheme", scheme, kSchemes));
      },
      py::arg("heights"), py::arg("step"), py::arg("direction") = "mean", py::arg("scheme") = "neighbours",
      "What a levelled and filtered map of shape (y, x) [m] brings into a pair; words as for moments(). "
      "Raises InputError. Source: docs/theory/surface.md.");
  module.def(
      "single_parameters",
      [](const SurfaceMeasures& of, const std::string& rule) {
        return single_parameters(of, chosen("rule", rule, kRules));
      },
      py::arg("surface"), py::arg("rule") = "ra",
      "N, beta, sigma of one surface against a smooth flat. rule: \"ra\" or \"rq\", what sigma is. Raises InputError.");
  module.def(
      "pair_parameters",
      [](const SurfaceMeasures& first, const SurfaceMeasures& second, const std::string& rule) {
        return pair_parameters(first, second, chosen("rule", rule, kRules));
      },
      py::arg("first"), py::arg("second"), py::arg("rule") = "ra",
      "N, beta, sigma of two surfaces in contact. rule: \"ra\" or \"rq\", what sigma is. Raises InputError. "
      "Source: eq-asperity-pair.");
  module.def(
      "asperity_parameters", [](const SpectralMoments& of, double sigma) { return asperity_parameters(of, sigma); },
      py::arg("moments"), py::arg("sigma"),
      "N and beta of moments; sigma [m] is taken over. Raises InputError. Source: eq-asperity-density.");
  module.def("moments_of", &moments_of, py::arg("density"), py::arg("beta"),
             "Moments that give N [1/m2] and beta [m], the inverse of asperity_parameters(); m0 stays 0.");
  module.def(
      "count_summits",
      [](const Heights& heights, const py::object& step) { return count_summits(height_map(heights, step)); },
      py::arg("heights"), py::arg("step"),
      "Summits of a map of shape (y, x) [m], one by one. Raises InputError for a profile. Source: eq-summits.");
  module.def("summit_theory", &summit_theory, py::arg("m0"), py::arg("m2"), py::arg("m4"),
             "What Gaussian isotropic surfaces of these moments should show [m2, -, 1/m2]. Source: Nayak (1971), "
             "eq-nayak.");
}

struct MeasuredMap {
  instrument::SurfaceFile file;
};

void bind_files(py::module_& module) {
  py::class_<MeasuredMap>(module, "MeasuredMap", "A map of heights as an instrument's file gave it.")
      .def_property_readonly(
          "heights", [](const MeasuredMap& self) { return heights_of(self.file.map); },
          "Shape (y, x), of a profile (x,) [m]; NaN where nothing was measured.")
      .def_property_readonly(
          "step",
          [](const MeasuredMap& self) { return py::make_tuple(self.file.map.step_x_m, self.file.map.step_y_m); },
          "Between the points along x and y [m], as every function here takes it.")
      .def_property_readonly(
          "plausibility", [](const MeasuredMap& self) { return self.file.plausibility_line; },
          "A line that says whether the map can be what one thinks it is.")
      .def_property_readonly(
          "notes", [](const MeasuredMap& self) { return self.file.origin.notes; }, "What is odd about the file.")
      .def_property_readonly(
          "sha256", [](const MeasuredMap& self) { return self.file.origin.sha256; }, "Digest of the file.")
      .def_property_readonly(
          "format", [](const MeasuredMap& self) { return self.file.origin.format; }, "Format of the file.")
      .def(
          "__repr__",
          [](const MeasuredMap& self) { return "<ringfilm.surface.MeasuredMap " + self.file.plausibility_line + ">"; },
          "The plausibility line.");
  module.def(
      "read",
      [](const py::object& path, const std::optional<std::string>& channel,
         const std::optional<std::string>& height_unit, const std::optional<std::string>& lateral_unit,
         const std::optional<std::string>& step_x, const std::optional<std::string>& step_y) {
        instrument::SurfaceOptions options;
        options.channel = channel;
        options.height_unit = height_unit;
        options.lateral_unit = lateral_unit;
        options.step_x = step_x;
        options.step_y = step_y;
        const auto name = py::cast<std::string>(py::module_::import("os").attr("fspath")(path));
        return MeasuredMap{instrument::read_surface_file(name, options, io::Units())};
      },
      py::arg("path"), py::arg("channel") = py::none(), py::arg("height_unit") = py::none(),
      py::arg("lateral_unit") = py::none(), py::arg("step_x") = py::none(), py::arg("step_y") = py::none(),
      R"(Heights from a file of any known format (docs/manual/surface-files.md): X3P, SDF, SUR, GSF, .gwy, text.

channel: number from 1, or name. height_unit, lateral_unit: "um"; step_x, step_y: "0.5 um", where the file does not say.
Returns a MeasuredMap. Raises InputError with file, place, rule and remedy.)");
}

}  // namespace

void bind_surface(py::module_& module) {
  py::module_ part = module.def_submodule("surface", "Analysis of measured heights; see ringfilm.surface.");
  bind_records(part);
  bind_functions(part);
  bind_files(part);
}

}  // namespace ringfilm::python
