#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <iostream>
#include <numbers>
#include <utility>

#include "example_document.hpp"
#include "measurement_example.hpp"
#include "ringfilm/io/result/result_document.hpp"
#include "ringfilm/report/gas_page.hpp"
#include "ringfilm/report/html.hpp"
#include "ringfilm/report/measurement_page.hpp"
#include "study_example.hpp"

namespace {

/// A bore of order 4, 8 um, and a ring that is apart from it by 1.5 um over 40 degree.
ringfilm::io::Measurement closure() {
  using namespace ringfilm;
  io::MeasuredCurve shape;
  shape.name = "bore_around";
  shape.title = "Bore and ring";
  shape.x_axis = {"angle", "angle from the middle of the gap", "degree", "degree"};
  shape.y_axis = {"deviation", "deviation of the radius", "m", "um"};
  shape.series = {{"bore", "bore", {}}, {"ring", "ring", {}}};
  for (int degree = 0; degree <= 360; ++degree) {
    shape.x.push_back(degree);
    shape.series[0].y.push_back(8e-6 * std::cos(4 * degree * std::numbers::pi / 180));
    shape.series[1].y.push_back(shape.series[0].y.back() - (degree > 70 && degree < 110 ? 1.5e-6 : 0));
  }
  io::Measurement all;
  all.kind = "conformity";
  all.title = "Ring in its bore (made-up numbers)";
  all.curves.push_back(std::move(shape));
  return all;
}

/// A pack with the gas of formulas and the oil of its first ring: piston land 2 at a tenth of the cylinder, a ring that
/// rises from 200 to 300 degree.
ringfilm::io::ResultDocument pack_with_gas() {
  using namespace ringfilm;
  io::ResultDocument pack = io::pack_document("a pack", {example::document("top"), example::document("second", 0.7)});
  cycle::CycleResult& top = pack.rings.front().result;
  for (std::vector<double>& film : top.stroke.film_ahead) film.assign(top.stroke.liner_position.size(), 2e-6);
  for (std::vector<double>& film : top.stroke.film_behind) film.assign(top.stroke.liner_position.size(), 1.5e-6);
  top.values.oil_scraped_up = 0.25e-6;
  const auto& samples = top.samples;
  io::PackGas gas;
  gas.regions = {
      {"chamber", 62e5, 20, 6e5}, {"groove 1", 61e5, 21, 6e5}, {"land 2", 6e5, 90, 2e5}, {"crankcase", 1e5, 0, 1e5}};
  gas.paths = {{"end gap 1", 2e-6, 3e-6, 1e-6},
               {"above ring 1", 0, 5e-7, 5e-7},
               {"below ring 1", 0, 5e-7, 5e-7},
               {"end gap 2", 2e-6, 2e-6, 0}};
  gas.events = {{1, 200, "leaves-lower"}, {1, 210, "lands-upper"}, {1, 290, "leaves-upper"}, {1, 300, "lands-lower"}};
  gas.rings = {{1}};
  gas_path::RingMotionValues motion;
  motion.departures = 1;
  motion.least_seating_force = -12.5;
  motion.least_seating_force_angle_deg = 210;
  motion.unseated_share = 0.14;
  motion.largest_static_twist = 1e-3;
  motion.largest_static_twist_angle_deg = 20;
  motion.twisted_share = 0.2;
  gas.motion = {motion};
  gas.sums.blow_by_per_cycle = 2e-6;
  gas.sums.blow_by_flow = 2.1e-5;
  gas.sums.mass_defect = 1e-16;
  gas.sums.cycles_integrated = 4;
  gas.sums.periodic = true;
  gas.sums.period_in_cycles = 1;
  for (int k = 0; k < 720; ++k) {
    const double p = samples[k].gas_pressure;
    gas.crank_angle_deg.push_back(k);
    gas.pressure.insert(gas.pressure.end(), {p, 0.98 * p, 1e5 + 0.1 * p, 1e5});
    gas.flow.insert(gas.flow.end(), {1e-10 * p, 0, 0, 2e-11 * p});
    gas.position.push_back(k > 210 && k < 290 ? 50e-6 : 0);
  }
  pack.gas = std::move(gas);
  return pack;
}

/// The same pack with another end gap and more friction.
ringfilm::io::ResultDocument pack_with_other_gap() {
  ringfilm::io::ResultDocument pack = pack_with_gas();
  for (ringfilm::io::ResultDocument& ring : pack.rings) {
    ring.inputs.push_back({"ring.end_gap", "2e-4", "0.2 mm", false, "end gap of the ring", 2e-4, "m"});
    for (ringfilm::cycle::Sample& sample : ring.result.samples) sample.total_friction *= 1.2;
  }
  return pack;
}

/// The gas of that pack alone.
ringfilm::io::GasPathFile gas_alone(const std::string& title) {
  ringfilm::io::GasPathFile file;
  file.title = title;
  file.inputs = {{"engine.bore", "0.089", "89 mm", false, "bore of the cylinder", 0.089, "m"},
                 {"ring.1.side_clearance", "5e-5", "50 um", false, "clearance in the groove", 5e-5, "m"},
                 {"ring.2.side_clearance", "5e-5", "50 um", true, "clearance in the groove", 5e-5, "m"}};
  file.notes = {{"oil-ring-missing", "the pack has no oil ring: " + title, 1}};
  file.gas = pack_with_gas().gas;
  return file;
}

}  // namespace

/// Writes the pages that the browser test opens: write_example_pages FOLDER
int main(int argc, char** argv) {
  using namespace ringfilm;
  if (argc != 2) {
    std::cerr << "write_example_pages FOLDER\n";
    return 2;
  }
  const std::string folder = argv[1];
  const auto write = [&](const std::string& name, const std::string& page) {
    std::ofstream file(fmt::format("{}/{}", folder, name), std::ios::binary);
    file << page;
    return file.good();
  };

  std::vector<io::ResultDocument> three = {example::document("Styles et al. 2014, new ring", 1.0),
                                           example::document("Styles et al. 2014, run-in ring", 0.7),
                                           example::document("Styles et al. 2014, embedded ring", 0.35)};
  report::Overlay measured{.name = "floating liner, test 12",
                           .quantity = "friction_on_liner",
                           .source = "measured.csv",
                           .crank_angle_deg = {},
                           .value = {}};
  for (int k = 0; k < 720; k += 6) {
    measured.crank_angle_deg.push_back(k);
    measured.value.push_back(0.9 * three[1].result.samples[k].friction_on_liner);
  }
  const bool three_written = write("three.html", report::report_page(three, {measured}));

  io::ResultDocument hostile = example::document("</script><img src=x onerror=\"window.hostile=1\"> & <b>bold</b>");
  hostile.inputs.push_back({"ring.face.file", "\"<svg onload=window.hostile=1>\"", "<svg onload=window.hostile=1>",
                            false, "<script>window.hostile=1</script>"});
  hostile.result.notes.push_back({"hostile", "<img src=x onerror=window.hostile=1>", 1});
  const bool hostile_written = write("hostile.html", report::report_page({hostile}, {}));

  const io::ResultDocument pack =
      io::pack_document("a pack", {example::document("top"), example::document("second", 0.7)});
  const bool pack_written =
      write("pack.html", report::report_page({pack}, {})) &&
      write("ring_pack.html", report::report_page({pack_with_gas()}, {})) &&
      write("two_packs.html", report::report_page({pack_with_gas(), pack_with_other_gap()}, {})) &&
      write("gas.html", report::gas_page(gas_alone("the gas of a pack"))) &&
      write("hostile_gas.html", report::gas_page(gas_alone(hostile.title)));

  io::ResultDocument coarse = example::document("coarse grid");
  for (cycle::Sample& error : coarse.errors->samples) {
    error.min_film_thickness *= 20;
    error.lambda_ratio *= 20;
  }
  const bool coarse_written = write("coarse.html", report::report_page({coarse}, {}));

  io::ResultDocument bare;
  bare.title = "stopped early";
  bare.result.complete = false;
  bare.result.samples.assign(three[0].result.samples.begin(), three[0].result.samples.begin() + 30);
  const bool bare_written = write("bare.html", report::report_page({bare}, {}));

  std::vector<io::ResultDocument> around = {example::document("unrolled, fields"),
                                            example::document("unrolled, strips", 0.7),
                                            example::document("unrolled, face", 0.35)};
  example::add_unrolled_film(around[0], example::CircumferentialGrid::kFields);
  example::add_unrolled_film(around[1], example::CircumferentialGrid::kStripsOnly);
  const bool around_written = write("unrolled.html", report::report_page(around, {}));

  const io::Units units;
  const io::Measurement surface = io::example::measurement(900, 600);
  const bool surface_written =
      write("measurement.html", report::measurement_page(surface, units, {"ringfilm 0.0.0", "abc", "g++", ""}));
  io::Measurement hostile_surface = io::example::measurement();
  hostile_surface.title = hostile_surface.sources[0] = hostile_surface.notes[0] = hostile_surface.maps[0].title =
      hostile_surface.maps[0].frames[0].label = hostile_surface.curves[0].title =
          hostile_surface.curves[1].marks[0].label = hostile_surface.fragment = hostile.title;
  hostile_surface.groups[0].values[0].remark = hostile_surface.tables[0].row_labels[0] = hostile.title;
  const bool hostile_surface_written =
      write("hostile_measurement.html", report::measurement_page(hostile_surface, units, {}));
  const bool closure_written =
      write("closure.html", report::measurement_page(closure(), units, {"ringfilm 0.0.0", "abc", "g++", ""}));
  bool studies_written = true;
  for (const auto& [name, page] :
       {std::pair{"study_uncertainty.html", example::uncertainty_page()},
        std::pair{"study_map.html", example::map_page()}, std::pair{"study_screening.html", example::screening_page()},
        std::pair{"study_comparison.html", example::comparison_page()},
        std::pair{"study_points.html", example::points_page()}, std::pair{"study_sweep.html", example::sweep_page()},
        std::pair{"hostile_study.html", example::uncertainty_page(hostile.title)}})
    studies_written = write(name, page) && studies_written;
  return three_written && studies_written && around_written && hostile_written && coarse_written && pack_written &&
                 bare_written && closure_written && surface_written && hostile_surface_written
             ? 0
             : 1;
}
