#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <vector>

#include "commands/command_face.hpp"
#include "commands/command_lateral_force.hpp"
#include "commands/command_surface.hpp"
#include "commands/commands.hpp"
#include "friction_band.hpp"
#include "measured_chain.hpp"
#include "output_names.hpp"
#include "reproduction.hpp"
#include "ringfilm/base/display.hpp"
#include "ringfilm/cycle/setup/contact_setup.hpp"
#include "ringfilm/instrument/documents/contact_measurement.hpp"
#include "ringfilm/io/measurement/measurement_text.hpp"
#include "ringfilm/io/storage/atomic_file.hpp"
#include "ringfilm/io/storage/shipped.hpp"
#include "ringfilm/io/text/toml_tree.hpp"
#include "ringfilm/report/html.hpp"

namespace ringfilm::app {
namespace {

namespace fs = std::filesystem;

constexpr double kOfTable1 = 1e-3;  // relative; the files round heights far below that

/// As cases and pages write it: run-in.
std::string word_of(std::string ring) {
  std::replace(ring.begin(), ring.end(), '_', '-');
  return ring;
}

/// The single commands of docs/manual/measured-chain.md, all writing into one folder.
class Chain {
 public:
  Chain(fs::path files, fs::path folder) : files_(std::move(files)), folder_(std::move(folder)) {}

  /// A page for each surface by itself.
  void measure_surfaces() const {
    surface({measuring("surface_liner"), {file("liner.sur")}});
    for (const std::string ring : chain::kRings) {
      surface({measuring("surface_" + ring), {file("ring_" + ring + ".x3p")}});
    }
  }

  /// Fragments and pages of one ring, and a case that includes the fragments. @returns path of the case
  std::string measure_ring(const std::string& ring) const {
    PairCommand contact{measuring(ring + "_contact"), {file("ring_" + ring + ".x3p")}, {file("liner.sur")}, {}};
    contact.outputs.fragment = in_folder(ring + "_contact.toml");
    pair(contact);

    FaceCommand shape;
    shape.trace = file("face_" + ring + ".csv");
    shape.rule = chain::face_rule();
    shape.outputs = outputs(ring + "_face");
    shape.outputs.fragment = in_folder(ring + "_face.toml");
    face(shape);

    LateralForceCommand friction;
    for (const std::string each : chain::kRings) friction.files.paths.push_back(file("loops_" + each + ".csv"));
    friction.silicon = ForceFiles{{file("loops_silicon.csv")}, {}};
    friction.reference = chain::silicon_reference();
    friction.rule = chain::force_rule();
    friction.sample = ring;
    friction.outputs = outputs(ring + "_shear_strength");
    friction.outputs.fragment = in_folder(ring + "_shear_strength.toml");
    lateral_force(friction);
    return written_case(ring);
  }

  /// The contact law of the maps of a ring and the liner, and what each law makes of friction, as files and as text.
  std::string measure_band(const std::string& ring, const cycle::Case& measured) const {
    const io::Units units;
    const auto read = [&](const std::string& name) { return instrument::read_surface_file(file(name), {}, units); };
    instrument::ContactAnalysis analysis;
    analysis.preparation = chain::surface_analysis().preparation;
    analysis.material = {cycle::composite_modulus(measured) / 2, cycle::kUsualHardness};
    analysis.shifts = chain::kPositions;
    analysis.regions_across = analysis.regions_down = 2;
    analysis.has_flow = true;
    const instrument::SurfaceFile liner = read("liner.sur");
    const io::Measurement law = contact_measurement(read("ring_" + ring + ".x3p"), &liner, analysis);
    const MeasurementOutputs of_law = outputs(ring + "_law"), of_band = outputs(ring + "_friction_band");
    deliver(law, of_law);
    const io::Measurement band = friction_band({word_of(ring), measured, cycle::kUsualHardness, *of_law.netcdf});
    deliver(band, of_band);
    return io::measurement_text(band, units);
  }

 private:
  std::string file(const std::string& name) const { return (files_ / name).string(); }
  std::string in_folder(const std::string& name) const { return (folder_ / name).string(); }

  MeasurementOutputs outputs(const std::string& stem) const {
    MeasurementOutputs of;
    of.netcdf = in_folder(stem + ".nc");
    of.page = in_folder(stem + ".html");
    of.summary = SummaryForm::kNothing;
    return of;
  }

  MeasuringCommand measuring(const std::string& stem) const {
    MeasuringCommand of;
    of.analysis = chain::surface_analysis();
    of.outputs = outputs(stem);
    return of;
  }

  std::string written_case(const std::string& ring) const {
    const std::string common = fs::absolute(files_ / "common.toml").lexically_normal().string();
    const std::string path = in_folder(ring + ".toml");
    const std::string title = "Measured chain, " + word_of(ring) + " ring (synthetic instrument files)";
    io::write_atomically(path,
                         fmt::format("# Written by ringfilm reproduce measured.\ntitle = {}\ninclude = [\n  {},\n"
                                     "  \"{}_contact.toml\",\n  \"{}_face.toml\",\n  \"{}_shear_strength.toml\",\n]\n",
                                     io::quoted(title), io::quoted(common), ring, ring, ring));
    return path;
  }

  fs::path files_, folder_;
};

/// One ring as the paper states it and as its files gave it.
struct RingPair {
  std::string ring;
  cycle::Case target, result;
};

double height_um(const std::vector<double>& coefficients, double x_mm) {
  double height = 0;
  for (const double c : coefficients) height = height * x_mm + c;
  return height;
}

/// Largest distance of the two polynomials over the face [um].
double distance_um(const RingPair& of) {
  constexpr int kPlaces = 1200;
  const double width_mm = number_in(of.target.ring.face_width, kMillimetre);
  double largest = 0;
  for (int k = 0; k <= kPlaces; ++k) {
    const double x = width_mm * k / kPlaces;
    largest = std::max(largest, std::abs(height_um(of.result.ring.face.coefficients, x) -
                                         height_um(of.target.ring.face.coefficients, x)));
  }
  return largest;
}

/// Prints what should have come back beside what did, and keeps how many did not.
class TargetAndResult {
 public:
  std::string text() const { return text_; }
  int failures() const { return failures_; }

  void add(const RingPair& of) {
    const cycle::Contact &target = of.target.contact, &result = of.result.contact;
    const cycle::MeasuredContact& measured = result.measured;
    const std::string word = word_of(of.ring);
    text_ += fmt::format("{:<29}{:>12}{:>14}{:>12}\n", word + " ring", "target", "result", "difference");
    const auto table_1 = [&](const char* name, double scale, double in_paper, double here,
                             const std::optional<double>& deviation) {
      const bool holds = std::abs(here / in_paper - 1) <= kOfTable1;
      row(name, in_paper / scale, here / scale, holds,
          deviation ? fmt::format("one region +- {:.2g}", *deviation / scale) : "");
    };
    table_1("Table 1: N [um-2]", 1e12, target.asperity_density, result.asperity_density,
            measured.asperity_density_deviation);
    table_1("         beta [um]", 1e-6, target.asperity_radius, result.asperity_radius,
            measured.asperity_radius_deviation);
    table_1("         sigma [um]", 1e-6, target.roughness, result.roughness, measured.roughness_deviation);

    const cycle::MeasuredShearStrength& shares = measured.shear_strength;
    const double own = std::hypot(shares.slope_deviation.value_or(0), shares.calibration_deviation.value_or(0));
    const double zeta = target.boundary_shear_strength_coefficient;
    // The reference is the same in files and chain: what is left is the scatter of the loops.
    row("Table 2: zeta", zeta, result.boundary_shear_strength_coefficient,
        std::abs(result.boundary_shear_strength_coefficient - zeta) <= own,
        fmt::format("loops +- {:.2g}, reference of silicon +- {:.2g}", own, shares.reference_deviation.value_or(0)));

    for (std::size_t k = 0; k < target_coefficients(of); ++k) {
      const std::string name = fmt::format("{} {}", k == 0 ? "Table 4:" : "        ", static_cast<char>('a' + k));
      row(name, of.target.ring.face.coefficients[k], of.result.ring.face.coefficients[k], true, "");
    }
    const double distance = distance_um(of),
                 noise = number_in(of.result.ring.face.measured.residual_rms.value_or(0), kMicrometre);
    text_ += fmt::format("{:<29}{:>12}{:>14.4f}{:>12}  noise {:.2g} um{}\n", "         largest distance [um]", "0",
                         distance, "", noise, verdict(distance <= noise));
  }

 private:
  static std::size_t target_coefficients(const RingPair& of) {
    return std::min(of.target.ring.face.coefficients.size(), of.result.ring.face.coefficients.size());
  }

  std::string verdict(bool holds) {
    failures_ += holds ? 0 : 1;
    return holds ? "" : "  TOO FAR OFF";
  }

  void row(const std::string& name, double target, double result, bool holds, const std::string& remark) {
    text_ += fmt::format("{:<29}{:>12.6g}{:>14.7g}{:>+10.4f} %{}{}{}\n", name, target, result,
                         100 * (result / target - 1), remark.empty() ? "" : "  ", remark, verdict(holds));
  }

  std::string text_;
  int failures_ = 0;
};

std::vector<io::ResultDocument> computed_rings(const std::vector<RingPair>& rings, int jobs) {
  std::vector<run::Request> requests;
  for (const RingPair& ring : rings) {
    requests.push_back({ring.result, ring.ring + " ring, measured", true, true});
  }
  for (const RingPair& ring : rings) {
    requests.push_back({ring.target, ring.ring + " ring", false, true});
  }
  return computed(requests, jobs);
}

/// Film and friction of the measured rings over those of the paper's tables.
std::string cycles_table(const std::vector<io::ResultDocument>& measured,
                         const std::vector<io::ResultDocument>& published) {
  const EngineeringText in_words;
  std::string text = fmt::format("{:<34}{:<12}", "the three rings", "");
  for (const std::string ring : chain::kRings) text += fmt::format("{:>24}", word_of(ring));
  text += "\n";
  for (const char* name : {"min_film_thickness", "lambda_ratio_at_peak_pressure", "peak_friction_coefficient_firing",
                           "mean_power_loss", "mean_boundary_power", "mean_absolute_oil_flow"}) {
    text += fmt::format("{:<34}{:<12}{}\n", name, "measured", cells(name, measured, in_words));
    text += fmt::format("{:<34}{:<12}{}\n", "", "styles2014", cells(name, published, in_words));
  }
  return text;
}

}  // namespace

void reproduce_measured(const ReproduceOptions& options) {
  const fs::path shipped = (fs::path(io::shipped_folder()) / "cases").lexically_normal();
  const fs::path folder = options.folder.empty() ? fs::path("measured") : fs::path(options.folder);
  if (is_same_file(folder.string(), (shipped / "measured").string())) {
    throw InputError("--output " + folder.string() + " is the folder of what is read", "name another one");
  }
  const std::string page = (folder / "report.html").string();
  const io::OutputClaim claimed = claimed_report(page);
  const Chain chain(shipped / "measured", folder);
  std::cout << "From files of instruments to the cycle: three rings of Styles et al. 2014 at 1500 rpm and 120 degC\n"
            << "surfaces, faces and friction loops: SYNTHETIC, made such that Tables 1, 2 and 4 come back\n"
            << "cylinder pressure: SYNTHETIC, made for this project\n\n";

  chain.measure_surfaces();
  const io::Units units;
  std::vector<RingPair> rings;
  TargetAndResult table;
  for (const std::string ring : chain::kRings) {
    const std::string path = chain.measure_ring(ring);
    rings.push_back({ring, case_for_report((shipped / "styles2014" / (word_of(ring) + ".toml")).string(), units),
                     case_for_report(path, units)});
    table.add(rings.back());
  }
  std::cout << table.text() << "\n";

  if (options.bands == FrictionBands::kComputed) {
    for (const RingPair& ring : rings) std::cout << chain.measure_band(ring.ring, ring.result) << "\n";
  }
  std::vector<io::ResultDocument> documents = computed_rings(rings, options.jobs);
  const auto half = documents.begin() + static_cast<std::ptrdiff_t>(rings.size());
  const std::vector<io::ResultDocument> published(std::make_move_iterator(half),
                                                  std::make_move_iterator(documents.end()));
  documents.erase(half, documents.end());
  for (std::size_t i = 0; i < rings.size(); ++i) {
    io::write_result((folder / (rings[i].ring + ".nc")).string(), documents[i]);
  }
  std::cout << cycles_table(documents, published) << "\n";
  io::write_atomically(page, ringfilm::report::report_page(documents, {}));
  std::cout << "cases and results:     " << (folder / "{new,run_in,embedded}.{toml,nc}").string() << "\n"
            << "pages of measurements: " << (folder / "{surface_*,*_contact,*_face,*_shear_strength}.html").string()
            << (options.bands == FrictionBands::kComputed
                    ? "\nlaws of the maps:      " + (folder / "{*_law,*_friction_band}.{nc,html}").string()
                    : std::string())
            << "\nreport:                " << fs::absolute(page).string() << "\n";
  if (table.failures() > 0) {
    throw FailedChecks(fmt::format("{} of the values that should come back are too far off", table.failures()));
  }
}

}  // namespace ringfilm::app
