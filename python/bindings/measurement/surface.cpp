#include <cmath>

#include "measurement/height_maps.hpp"
#include "measurement/measured_files.hpp"
#include "record.hpp"
#include "ringfilm/base/number_text.hpp"
#include "ringfilm/instrument/surface_file.hpp"
#include "ringfilm/surface/asperity/asperities.hpp"
#include "ringfilm/surface/asperity/summits.hpp"
#include "ringfilm/surface/topography/material_ratio.hpp"
#include "ringfilm/surface/topography/preparation.hpp"
#include "ringfilm/surface/topography/roughness.hpp"

namespace ringfilm::python {
namespace {

using namespace surface;

const std::map<std::string, FormKind> kFormKinds{{"none", FormKind::none},
                                                 {"mean", FormKind::mean},
                                                 {"tilt", FormKind::tilt},
                                                 {"cylinder", FormKind::cylinder},
                                                 {"polynomial", FormKind::polynomial}};
const std::map<std::string, FilterKind> kFilters{{"gaussian", FilterKind::gaussian},
                                                 {"robust-gaussian", FilterKind::robust_gaussian},
                                                 {"valley-suppression", FilterKind::valley_suppression}};
const std::map<std::string, MomentDirection> kMomentDirections{{"x", MomentDirection::x},
                                                               {"y", MomentDirection::y},
                                                               {"mean", MomentDirection::mean},
                                                               {"geometric", MomentDirection::geometric}};
const std::map<std::string, DifferenceScheme> kSchemes{{"neighbours", DifferenceScheme::neighbours},
                                                       {"seven-point", DifferenceScheme::seven_point}};
const std::map<std::string, SigmaRule> kRules{{"ra", SigmaRule::ra}, {"rq", SigmaRule::rq}};
const std::map<std::string, CavityRule> kCavityRules{{"below-depth", CavityRule::below_depth},
                                                     {"below-plateau", CavityRule::below_plateau},
                                                     {"below-core", CavityRule::below_core}};

py::tuple prepared(const GivenNumbers& heights, const GivenStep& step, const GivenText& form,
                   const Given<kinds::Integer>& degree, const GivenMaybeNumber& short_cutoff,
                   const GivenMaybeNumber& long_cutoff, const GivenText& filter) {
  HeightMap map = height_map(heights, step);
  Preparation steps;
  steps.form = {chosen("form", form, kFormKinds), integer_of("degree", degree.value)};
  steps.short_cutoff_m = maybe_number_of("short_cutoff", short_cutoff.value, "m");
  steps.long_cutoff_m = maybe_number_of("long_cutoff", long_cutoff.value, "m");
  steps.filter = chosen("filter", filter, kFilters);
  const Prepared done = prepare(map, steps);
  return py::make_tuple(heights_of(map, py::len(py::module_::import("numpy").attr("shape")(heights.value)) == 1),
                        done.lines());
}

/// Throws InputError unless it is finite and not below zero.
double from_zero_on(const char* name, const GivenNumber& given, const char* unit) {
  const double value = number_of(name, given.value, unit);
  if (!(std::isfinite(value) && value >= 0)) {
    throw InputError(std::string(name) + " = " + number_text(value) + " is not a finite number of at least 0");
  }
  return value;
}

void bind_surface_records(py::module_& module) {
  Record<HeightStatistics>(module, "HeightStatistics",
                           "Height statistics of a map; of a profile Ra, Rq, ..., Rpt, Rvt and Rt. "
                           "Source: docs/theory, eq-surface-heights.")
      .with("points", &HeightStatistics::points, "Measured points.")
      .with("missing", &HeightStatistics::missing, "Points without a height.")
      .with("mean_m", &HeightStatistics::mean_m, "Mean height [m].")
      .with("Sa_m", &HeightStatistics::Sa_m, "Mean absolute deviation [m].")
      .with("Sq_m", &HeightStatistics::Sq_m, "Rms deviation [m].")
      .with("Ssk", &HeightStatistics::Ssk, "Skewness [-].")
      .with("Sku", &HeightStatistics::Sku, "Kurtosis [-], 3 for a Gaussian.")
      .with("Sp_m", &HeightStatistics::Sp_m, "Highest peak above the mean, Rpt of a profile [m].")
      .with("Sv_m", &HeightStatistics::Sv_m, "Deepest pit below the mean, Rvt of a profile [m], positive.")
      .with("Sz_m", &HeightStatistics::Sz_m, "Peak to pit, Rt of a profile [m].");
  Record<SampledHeights>(module, "SampledHeights",
                         "Means over the sampling lengths of a profile. Source: eq-surface-sampling-length.")
      .with("Rp_m", &SampledHeights::Rp_m, "Highest peak above the mean [m].")
      .with("Rv_m", &SampledHeights::Rv_m, "Deepest pit below the mean [m], positive.")
      .with("Rz_m", &SampledHeights::Rz_m, "Peak to pit [m].")
      .with("sampling_length_m", &SampledHeights::sampling_length_m, "Length of each [m].")
      .with("count", &SampledHeights::count, "How many.");
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
      .with("Rmq", &ProbabilityRoughness::Rmq, "Material ratio where both meet [-].")
      .with("plateau_m", &ProbabilityRoughness::plateau_m, "Mean plane of the plateau [m].")
      .with("meet_m", &ProbabilityRoughness::meet_m, "Height where both meet [m].");
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
  moments_record.type().def(py::init([](const GivenNumber& m0, const GivenNumber& m2, const GivenNumber& m4) {
                              return SpectralMoments{from_zero_on("m0_m2", m0, "m2"), from_zero_on("m2", m2, ""),
                                                     from_zero_on("m4_per_m2", m4, "1/m2")};
                            }),
                            py::arg("m0_m2"), py::arg("m2"), py::arg("m4_per_m2"),
                            "From three numbers from 0 on [m2, -, 1/m2]. Raises InputError.");
  Record<SurfaceMeasures> measures(module, "SurfaceMeasures", "What one surface brings into a pair.");
  measures.with("Sa_m", &SurfaceMeasures::Sa_m, "Mean absolute deviation [m].")
      .with("Sq_m", &SurfaceMeasures::Sq_m, "Rms deviation [m].")
      .with("moments", &SurfaceMeasures::moments, "Its SpectralMoments.");
  measures.type().def(
      py::init([](const GivenNumber& Sa, const GivenNumber& Sq, const GivenOne<SpectralMoments>& of) {
        return SurfaceMeasures{from_zero_on("Sa_m", Sa, "m"), from_zero_on("Sq_m", Sq, "m"), one_of("moments", of)};
      }),
      py::arg("Sa_m"), py::arg("Sq_m"), py::arg("moments"),
      "From lengths from 0 on [m] and SpectralMoments. Raises InputError.");
  Record<AsperityParameters> asperities(module, "AsperityParameters",
                                        "What a contact model takes. Source: docs/theory/surface.md.");
  asperities.with("density_per_m2", &AsperityParameters::density_per_m2, "N [1/m2].")
      .with("beta_m", &AsperityParameters::beta_m, "Mean summit radius [m].")
      .with("sigma_m", &AsperityParameters::sigma_m, "Composite roughness [m].");
  asperities.type()
      .def("roughness_parameter", &AsperityParameters::roughness_parameter, "N beta sigma [-].")
      .def("slope", &AsperityParameters::slope, "sigma/beta [-].");
}

void bind_surface_functions(py::module_& module) {
  module.def("_prepare", &prepared, py::arg("heights"), py::arg("step"), py::arg("form"), py::arg("degree"),
             py::arg("short_cutoff"), py::arg("long_cutoff"), py::arg("filter"), "See ringfilm.surface.prepare.");
  module.def(
      "gaussian_transmission",
      [](const GivenNumbers& wavelength, const GivenNumbers& cutoff) {
        return mapped({{"wavelength", &wavelength}, {"cutoff", &cutoff}},
                      [](const std::vector<double>& at) { return gaussian_transmission(at[0], at[1]); });
      },
      py::arg("wavelength"), py::arg("cutoff"),
      R"(Share of the amplitude of a wave that a Gaussian S-filter lets pass [-].

wavelength, cutoff: above 0, numbers or arrays of shapes that fit together [m]. Raises InputError.
Source: docs/theory, eq-surface-gaussian.)");
  module.def(
      "height_statistics",
      [](const GivenNumbers& heights, const GivenStep& step) { return height_statistics(height_map(heights, step)); },
      py::arg("heights"), py::arg("step"),
      R"(Height statistics of all measured points about their mean.

heights: shape (y, x), or (x,) for a profile [m]; NaN where nothing was measured. step: a number or (x, y) [m].
Raises InputError for fewer than 4 points or a flat surface. Source: docs/theory, eq-surface-heights.)");
  module.def(
      "sampled_heights",
      [](const GivenNumbers& heights, const GivenStep& step, const GivenMaybeNumber& sampling_length) {
        return sampled_heights(height_map(heights, step),
                               maybe_number_of("sampling_length", sampling_length.value, "m"));
      },
      py::arg("heights"), py::arg("step"), py::arg("sampling_length") = py::none(),
      R"(Rp, Rv and Rz of a profile: means over its sampling lengths.

heights: shape (x,) [m]; NaN where nothing was measured. step: a number [m]. sampling_length: the long cut-off [m];
None: a fifth of the profile. Raises InputError. Source: ISO 21920-2, docs/theory, eq-surface-sampling-length.)");
  module.def(
      "row_roughness",
      [](const GivenNumbers& heights, const GivenStep& step) { return row_roughness(height_map(heights, step)); },
      py::arg("heights"), py::arg("step"),
      "Ra and Rq of the rows of a map of shape (y, x) [m]. Raises InputError where no row has 8 measured points.");
  module.def(
      "material_ratio_curve",
      [](const GivenNumbers& heights, const GivenStep& step) {
        return array_of(material_ratio_curve(height_map(heights, step)));
      },
      py::arg("heights"), py::arg("step"),
      "Heights of the measured points, falling, shape (points,) [m]: the material ratio curve.");
  module.def(
      "core_roughness", [](const GivenNumbers& curve) { return core_roughness(row_of("curve", curve.value)); },
      py::arg("curve"),
      "Rk family of a material ratio curve of shape (points,) [m]. Source: ISO 13565-2, eq-surface-core.");
  module.def(
      "probability_roughness",
      [](const GivenNumbers& curve) { return probability_roughness(row_of("curve", curve.value)); }, py::arg("curve"),
      "Rpq, Rvq, Rmq of a material ratio curve [m]; None for a surface made in one step. Source: ISO 13565-3.");
  module.def(
      "cavities",
      [](const GivenNumbers& curve, const GivenText& rule, const GivenNumber& depth) {
        return cavities(row_of("curve", curve.value), chosen("rule", rule, kCavityRules),
                        number_of("depth", depth.value, "m"));
      },
      py::arg("curve"), py::arg("rule") = "below-plateau", py::arg("depth") = 0.0,
      R"(Share of the area that are pores and grooves, of a material ratio curve of shape (points,) [m].

rule: "below-plateau", "below-core" or "below-depth" with its depth below the median [m]. Raises InputError.
Source: docs/theory, eq-surface-cavities.)");
  module.def(
      "moments",
      [](const GivenNumbers& heights, const GivenStep& step, const GivenText& direction, const GivenText& scheme) {
        return moments(moment_table(height_map(heights, step), chosen("scheme", scheme, kSchemes)),
                       chosen("direction", direction, kMomentDirections));
      },
      py::arg("heights"), py::arg("step"), py::arg("direction") = "mean", py::arg("scheme") = "neighbours",
      R"(Spectral moments of a map of shape (y, x), or of a profile (x,) along x [m].

direction: "mean" of x and y, "geometric", "x", "y". scheme: "neighbours" or "seven-point".
Raises InputError for fewer than 16 complete stencils. Source: docs/theory, eq-surface-moments.)");
  module.def(
      "surface_measures",
      [](const GivenNumbers& heights, const GivenStep& step, const GivenText& direction, const GivenText& scheme) {
        return surface_measures(height_map(heights, step), chosen("direction", direction, kMomentDirections),
                                chosen("scheme", scheme, kSchemes));
      },
      py::arg("heights"), py::arg("step"), py::arg("direction") = "mean", py::arg("scheme") = "neighbours",
      "What a levelled and filtered map of shape (y, x) [m] brings into a pair; arguments as for moments(). "
      "Raises InputError. Source: docs/theory/surface.md.");
  module.def(
      "single_parameters",
      [](const GivenOne<SurfaceMeasures>& of, const GivenText& rule) {
        return single_parameters(one_of("surface", of), chosen("rule", rule, kRules));
      },
      py::arg("surface"), py::arg("rule") = "ra",
      "N, beta, sigma of one surface against a smooth flat. rule: \"ra\" or \"rq\", what sigma is. Raises InputError.");
  module.def(
      "pair_parameters",
      [](const GivenOne<SurfaceMeasures>& first, const GivenOne<SurfaceMeasures>& second, const GivenText& rule) {
        return pair_parameters(one_of("first", first), one_of("second", second), chosen("rule", rule, kRules));
      },
      py::arg("first"), py::arg("second"), py::arg("rule") = "ra",
      "N, beta, sigma of two surfaces in contact. rule: \"ra\" or \"rq\", what sigma is; contact laws other than the "
      "default of a case take \"rq\". Raises InputError. "
      "Source: eq-asperity-pair.");
  module.def(
      "asperity_parameters",
      [](const GivenOne<SpectralMoments>& of, const GivenNumber& sigma) {
        return asperity_parameters(one_of("moments", of), number_of("sigma", sigma.value, "m"));
      },
      py::arg("moments"), py::arg("sigma"),
      "N and beta of moments; sigma [m] is taken over. Raises InputError. Source: eq-asperity-density.");
  module.def(
      "moments_of",
      [](const GivenNumber& density, const GivenNumber& beta) {
        return moments_of(number_of("density", density.value, "1/m2"), number_of("beta", beta.value, "m"));
      },
      py::arg("density"), py::arg("beta"),
      "Moments that give N [1/m2] and beta [m], the inverse of asperity_parameters(); m0 stays 0. "
      "Raises InputError. Source: eq-asperity-density, eq-asperity-radius.");
  module.def(
      "count_summits",
      [](const GivenNumbers& heights, const GivenStep& step) { return count_summits(height_map(heights, step)); },
      py::arg("heights"), py::arg("step"),
      "Summits of a map of shape (y, x) [m], one by one. Raises InputError for a profile. Source: eq-summits.");
  module.def(
      "summit_theory",
      [](const GivenNumber& m0, const GivenNumber& m2, const GivenNumber& m4) {
        return summit_theory(number_of("m0", m0.value, "m2"), number_of("m2", m2.value, ""),
                             number_of("m4", m4.value, "1/m2"));
      },
      py::arg("m0"), py::arg("m2"), py::arg("m4"),
      "What Gaussian isotropic surfaces of these moments should show [m2, -, 1/m2]. Raises InputError. "
      "Source: Nayak (1971), eq-nayak.");
}

struct MeasuredMap {
  py::array heights;  ///< read-only
  double step_x_m, step_y_m;
  std::string plausibility, sha256, format;
  std::vector<std::string> notes;

  py::tuple state() const { return py::make_tuple(heights, step_x_m, step_y_m, plausibility, sha256, format, notes); }
};

MeasuredMap map_of(const py::tuple& state) {
  if (state.size() != 7) throw py::value_error("this pickle was written by another version of ringfilm");
  MeasuredMap map{py::cast<py::array>(state[0]),
                  py::cast<double>(state[1]),
                  py::cast<double>(state[2]),
                  py::cast<std::string>(state[3]),
                  py::cast<std::string>(state[4]),
                  py::cast<std::string>(state[5]),
                  py::cast<std::vector<std::string>>(state[6])};
  map.heights.attr("setflags")(py::arg("write") = false);
  return map;
}

bool is_same(const MeasuredMap& a, const MeasuredMap& b) {
  const py::object equal = py::module_::import("numpy").attr("array_equal");
  return py::cast<bool>(equal(a.heights, b.heights, py::arg("equal_nan") = true)) && a.step_x_m == b.step_x_m &&
         a.step_y_m == b.step_y_m && a.plausibility == b.plausibility && a.sha256 == b.sha256 && a.format == b.format &&
         a.notes == b.notes;
}

/// A channel by its number or its name.
std::optional<std::string> channel_of(const py::object& given) {
  if (PyIndex_Check(given.ptr()) && !PyBool_Check(given.ptr())) return std::to_string(integer_of("channel", given));
  if (!given.is_none() && !PyUnicode_Check(given.ptr())) {
    throw py::type_error("channel must be a number from 1 or a name, not of type " +
                         py::cast<std::string>(py::type::of(given).attr("__name__")));
  }
  return maybe_text_of("channel", given, "Height");
}

MeasuredMap measured(const Given<kinds::Path>& path, const Given<kinds::NumberOrText>& channel,
                     const GivenMaybeText& height_unit, const GivenMaybeText& lateral_unit,
                     const GivenMaybeText& step_x, const GivenMaybeText& step_y, const GivenMaybeText& columns,
                     const Given<kinds::Integer>& skip_lines, const Given<kinds::Words>& missing) {
  instrument::SurfaceOptions options = file_options(height_unit, lateral_unit, "step_x", step_x);
  options.table = table_reading(columns, skip_lines, missing);
  options.channel = channel_of(channel.value);
  options.step_y = maybe_text_of("step_y", step_y.value, "0.5 um");
  const auto file = instrument::read_surface_file(path_of("path", path.value), options, io::Units());
  MeasuredMap map{heights_of(file.map, true), file.map.step_x_m,  file.map.step_y_m, file.plausibility_line,
                  file.origin.sha256,         file.origin.format, file.origin.notes};
  map.notes.insert(map.notes.end(), file.origin.doubts.begin(), file.origin.doubts.end());
  map.heights.attr("setflags")(py::arg("write") = false);
  return map;
}

void bind_files(py::module_& module) {
  py::class_<MeasuredMap>(module, "MeasuredMap", "A map of heights as an instrument's file gave it.")
      .def_readonly("heights", &MeasuredMap::heights,
                    "Shape (y, x), of a profile (x,) [m]; NaN where nothing was measured. Read-only: .copy() for an "
                    "array to work on.")
      .def_property_readonly(
          "step", [](const MeasuredMap& self) { return py::make_tuple(self.step_x_m, self.step_y_m); },
          "Between the points along x and y [m], as every function here takes it.")
      .def_readonly("plausibility", &MeasuredMap::plausibility, "A line on whether the map can be what one expects.")
      .def_readonly("notes", &MeasuredMap::notes,
                    "What was chosen when the file was read, and why its heights may not be those of the surface.")
      .def_readonly("sha256", &MeasuredMap::sha256, "Digest of the file.")
      .def_readonly("format", &MeasuredMap::format, "Format of the file.")
      .def(
          "__eq__",
          [](const MeasuredMap& self, const py::object& other) -> py::object {
            if (!py::isinstance<MeasuredMap>(other)) return py::reinterpret_borrow<py::object>(Py_NotImplemented);
            return py::bool_(is_same(self, py::cast<const MeasuredMap&>(other)));
          },
          py::arg("other"),
          "Are the heights and all that is reported of them the same? Points that were not measured are.")
      .def(py::pickle([](const MeasuredMap& self) { return self.state(); }, &map_of))
      .def(
          "__repr__",
          [](const MeasuredMap& self) { return "<ringfilm.surface.MeasuredMap " + self.plausibility + ">"; },
          "The plausibility line.");
  module.def("read", &measured, py::arg("path"), py::arg("channel") = py::none(), py::arg("height_unit") = py::none(),
             py::arg("lateral_unit") = py::none(), py::arg("step_x") = py::none(), py::arg("step_y") = py::none(),
             py::arg("columns") = py::none(), py::arg("skip_lines") = 0, py::arg("missing") = py::tuple(),
             R"(Heights from a file of any known format (docs/manual/surface-files.md): X3P, SDF, SUR, GSF, .gwy, text.

channel: number from 1, or name. height_unit, lateral_unit: "um"; step_x, step_y: "0.5 um", where the file has none.
Of a text file: columns, names and units of all its columns, "x [um], -, z [um]", - is not used; skip_lines, lines in
front of its table; missing, a word or number that marks a missing height, or several.
Returns a MeasuredMap. Raises InputError with file, place, rule and remedy, and TypeError.)");
}

}  // namespace

void bind_surface(py::module_& module) {
  py::module_ part = module.def_submodule("surface", "Analysis of measured heights; see ringfilm.surface.");
  bind_surface_records(part);
  bind_surface_functions(part);
  bind_files(part);
  bind_contact_law(part);
  bind_land_film(part);
}

}  // namespace ringfilm::python
