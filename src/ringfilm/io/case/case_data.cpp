#include "ringfilm/io/case/case_data.hpp"

#include <cmath>
#include <utility>

#include "ringfilm/io/data/face_file.hpp"
#include "ringfilm/io/data/oil_file.hpp"
#include "ringfilm/io/data/shipped_pairs.hpp"
#include "ringfilm/io/data/trace_file.hpp"
#include "ringfilm/io/measurement/bore_map_file.hpp"
#include "ringfilm/io/measurement/contact_law_file.hpp"
#include "ringfilm/io/measurement/free_shape_file.hpp"
#include "ringfilm/io/measurement/land_law_file.hpp"
#include "ringfilm/io/pad/pad_file.hpp"

namespace ringfilm::io {
namespace {

using cycle::Case;

/// "1.2 mm" in one file and "1200 um" in another differ in the last bit: the last point is the edge.
void fit_to_width(std::vector<double>& x, double width) {
  if (!x.empty() && std::abs(x.back() - width) <= 1e-9 * width) x.back() = width;
  if (!x.empty() && std::abs(x.front()) <= 1e-9 * width) x.front() = 0;
}

/// What the case does not state of boundary friction is that of the pair.
void take_pair(const models::FrictionPair& pair, Case& to) {
  to.contact.pair = pair;
  to.contact.boundary_shear_strength_coefficient = pair.friction;
  if (!to.stated.contains("contact.hardness")) to.contact.hardness = pair.hardness;
}

/// Gathers the files that a case names.
class DataFiles {
 public:
  explicit DataFiles(const Units& units) : units_(units) {}

  /// The file of a key where the case names one. @param put what puts the contents into a case
  template <class Contents, class Put>
  void add(const std::string& key, const std::optional<std::string>& name,
           Contents (*read)(const NamedFile&, const Units&), const Put& put) {
    if (!name || name->empty()) return;
    files_.push_back({key, *name, [&units = units_, read, put](const NamedFile& file, Case& c) -> ReadData {
                        Contents contents = read(file, units);
                        put(contents, c);
                        return {std::move(contents.sha256), std::move(contents.notes)};
                      }});
  }

  /// A trace over crank angle, whose columns are read after the keys of the case at that time.
  template <class Put>
  void add_trace(const std::string& key, const std::optional<std::string>& name, TracePlace place, const Put& put) {
    if (!name || name->empty()) return;
    files_.push_back({key, *name, [&units = units_, place, put](const NamedFile& file, Case& c) -> ReadData {
                        TraceFile trace = read_trace(file, trace_columns(c.gas, place), units);
                        put(std::move(trace.samples), c);
                        return {std::move(trace.sha256), std::move(trace.notes)};
                      }});
  }

  /// The shipped pairs of coating and liner, for the one of that name.
  void add_pair(const std::string& name) {
    files_.push_back(
        {"contact.friction_pair", kPairsFile, [&units = units_, name](const NamedFile& file, Case& c) -> ReadData {
           const FrictionPairs all = read_friction_pairs(file, units);
           take_pair(pair_of_name(all, name), c);
           return {all.sha256, {}};
         }});
  }

  std::vector<DataFile> files() && { return std::move(files_); }

 private:
  static TraceColumns trace_columns(const cycle::Gas& gas, TracePlace place) {
    TraceColumns columns{{}, {}, gas.pressure_unit, gas.angle_unit, gas.pressure_reference, place, {}, {}};
    if (place == TracePlace::kCylinder) {
      columns.pressure_column = gas.pressure_column;
      columns.angle_column = gas.angle_column;
      columns.cycle = gas.cycle;
      columns.table.columns = gas.columns;
      if (gas.skip_lines > 0) columns.table.skip_lines = static_cast<std::size_t>(gas.skip_lines);
    }
    return columns;
  }

  const Units& units_;
  std::vector<DataFile> files_;
};

void add_pad_files(const cycle::Pad& pad, DataFiles& files) {
  if (!pad.has_formula()) {
    files.add("pad.gap", pad.gap_file, read_gap, [](GapFile& gap, Case& c) {
      c.pad.gap_x = std::move(gap.x);
      c.pad.gap_y = std::move(gap.y);
      c.pad.gap_height = std::move(gap.height);
      fit_to_width(c.pad.gap_x, c.pad.length);
      if (c.pad.width) fit_to_width(c.pad.gap_y, *c.pad.width);
    });
  }
  files.add("pad.separation_history", pad.separation_history_file, read_separation_history,
            [](SeparationHistory& history, Case& c) {
              c.pad.history_time = std::move(history.time);
              c.pad.history_separation = std::move(history.separation);
            });
}

void add_gas_files(const Case& c, DataFiles& files) {
  using cycle::SampledTrace;
  if (c.gas.model == cycle::GasModel::kTrace) {
    files.add_trace("gas.cylinder_pressure", c.gas.cylinder_pressure_file, TracePlace::kCylinder,
                    [](SampledTrace trace, Case& to) { to.gas.cylinder_pressure = std::move(trace); });
  }
  files.add_trace("gas.crankcase_pressure", c.gas.crankcase_pressure_file, TracePlace::kCrankcase,
                  [](SampledTrace trace, Case& to) { to.gas.crankcase_trace = std::move(trace); });
  files.add_trace("ring.pressure_above", c.ring.pressure_above.file, TracePlace::kCrankcase,
                  [](SampledTrace trace, Case& to) { to.ring.pressure_above.trace = std::move(trace); });
  files.add_trace("ring.pressure_below", c.ring.pressure_below.file, TracePlace::kCrankcase,
                  [](SampledTrace trace, Case& to) { to.ring.pressure_below.trace = std::move(trace); });
}

/// Files of numbers in the order in which they are read.
void add_files(const Case& c, DataFiles& files) {
  if (c.problem == cycle::Problem::kPad) return add_pad_files(c.pad, files);
  files.add("liner.distortion_map", c.liner.distortion_map, read_bore_map,
            [](BoreMapFile& bore, Case& to) { to.liner.map = std::move(bore.map); });
  files.add("ring.pressure_points", c.ring.pressure_points, read_pressure_points,
            [](PressurePointsFile& points, Case& to) { to.ring.pressure_around = std::move(points.points); });
  files.add("ring.free_shape", c.ring.free_shape, read_free_shape,
            [](FreeShapeFile& shape, Case& to) { to.ring.free_ring = std::move(shape.ring); });
  if (c.problem == cycle::Problem::kClosure) return;
  files.add("liner.dynamic_distortion", c.liner.dynamic_distortion, read_dynamic_bore,
            [](DynamicBoreFile& bore, Case& to) { to.liner.dynamic = std::move(bore.dynamic); });
  add_gas_files(c, files);
  if (c.ring.face.form == cycle::FaceForm::kPoints) {
    files.add("ring.face.file", c.ring.face.points_file, read_face, [](FaceFile& points, Case& to) {
      to.ring.face.x = std::move(points.x);
      to.ring.face.height = std::move(points.height);
      fit_to_width(to.ring.face.x, to.ring.face_width);
    });
  }
  files.add("lubricant.table", c.lubricant.table_file, read_oil_table,
            [](OilFile& oil, Case& to) { to.lubricant.table = std::move(oil.table); });
  if (c.contact.model == cycle::ContactLaw::kTable) {
    files.add(
        "contact.law", c.contact.law_file, +[](const NamedFile& file, const Units&) { return read_contact_law(file); },
        [](ContactLawFile& law, Case& to) { to.contact.law = std::move(law.law); });
  }
  if (c.film.land_lift == cycle::LandLift::kTable) {
    files.add("film.land_law", c.film.land_law_file, read_land_law,
              [](LandLawFile& law, Case& to) { to.film.land_law = std::move(law.law); });
  }
  if (c.contact.friction_pair) files.add_pair(*c.contact.friction_pair);
}

}  // namespace

std::vector<DataFile> data_files(const Case& c, const Units& units) {
  DataFiles files(units);
  add_files(c, files);
  return std::move(files).files();
}

void read_data_file(const DataFile& data, Case& c) {
  const ReadData read = data.read(locate(data.name, ""), c);
  c.files.push_back({data.key, data.name, read.sha256});
  c.notes.insert(c.notes.end(), read.notes.begin(), read.notes.end());
}

}  // namespace ringfilm::io
