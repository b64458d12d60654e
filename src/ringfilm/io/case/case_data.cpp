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
#include "ringfilm/io/pad/pad_file.hpp"

namespace ringfilm::io {
namespace {

using cycle::Case;

/// "1.2 mm" in one file and "1200 um" in another differ in the last bit: the last point is the edge.
void fit_to_width(std::vector<double>& x, double width) {
  if (!x.empty() && std::abs(x.back() - width) <= 1e-9 * width) x.back() = width;
  if (!x.empty() && std::abs(x.front()) <= 1e-9 * width) x.front() = 0;
}

std::vector<DataFile> pad_files(const cycle::Pad& pad, const Units& units) {
  std::vector<DataFile> files;
  if (!pad.has_formula() && !pad.gap_file.empty()) {
    files.push_back({"pad.gap", pad.gap_file, [&units](const NamedFile& file, Case& c) -> ReadData {
                       GapFile gap = read_gap(file, units);
                       c.pad.gap_x = std::move(gap.x);
                       c.pad.gap_y = std::move(gap.y);
                       c.pad.gap_height = std::move(gap.height);
                       fit_to_width(c.pad.gap_x, c.pad.length);
                       if (c.pad.width) fit_to_width(c.pad.gap_y, *c.pad.width);
                       return {gap.sha256, gap.notes};
                     }});
  }
  if (pad.separation_history_file) {
    files.push_back(
        {"pad.separation_history", *pad.separation_history_file, [&units](const NamedFile& file, Case& c) -> ReadData {
           SeparationHistory history = read_separation_history(file, units);
           c.pad.history_time = std::move(history.time);
           c.pad.history_separation = std::move(history.separation);
           return {history.sha256, history.notes};
         }});
  }
  return files;
}

/// How the columns of a trace are read, after the keys of the case at that time.
TraceColumns trace_columns(const cycle::Gas& gas, TracePlace place) {
  if (place == TracePlace::kCylinder) {
    return {gas.pressure_column, gas.angle_column, gas.pressure_unit, gas.angle_unit, gas.pressure_reference, place};
  }
  return {std::nullopt, std::nullopt, gas.pressure_unit, gas.angle_unit, gas.pressure_reference, place};
}

void append_gas_files(const cycle::Gas& gas, const Units& units, std::vector<DataFile>& files) {
  if (gas.model == cycle::GasModel::kTrace && !gas.cylinder_pressure_file.empty()) {
    files.push_back(
        {"gas.cylinder_pressure", gas.cylinder_pressure_file, [&units](const NamedFile& file, Case& c) -> ReadData {
           TraceFile trace = read_trace(file, trace_columns(c.gas, TracePlace::kCylinder), units);
           c.gas.cylinder_pressure = std::move(trace.samples);
           return {trace.sha256, trace.notes};
         }});
  }
  if (gas.crankcase_pressure_file) {
    files.push_back(
        {"gas.crankcase_pressure", *gas.crankcase_pressure_file, [&units](const NamedFile& file, Case& c) -> ReadData {
           TraceFile trace = read_trace(file, trace_columns(c.gas, TracePlace::kCrankcase), units);
           c.gas.crankcase_trace = std::move(trace.samples);
           return {trace.sha256, trace.notes};
         }});
  }
}

/// A piston land's pressure where it is a file.
void append_land_file(const std::string& key, cycle::LandPressure cycle::Ring::*land, const cycle::Ring& ring,
                      const Units& units, std::vector<DataFile>& files) {
  const std::optional<std::string>& name = (ring.*land).file;
  if (!name) return;
  files.push_back({key, *name, [&units, land](const NamedFile& file, Case& to) -> ReadData {
                     TraceFile trace = read_trace(file, trace_columns(to.gas, TracePlace::kCrankcase), units);
                     (to.ring.*land).trace = std::move(trace.samples);
                     return {trace.sha256, trace.notes};
                   }});
}

/// What the case does not state of boundary friction is that of the pair.
void take_pair(const models::FrictionPair& pair, Case& to) {
  to.contact.pair = pair;
  to.contact.boundary_shear_strength_coefficient = pair.friction;
  if (!to.stated.contains("contact.hardness")) to.contact.hardness = pair.hardness;
}

}  // namespace

std::vector<DataFile> data_files(const Case& c, const Units& units) {
  if (c.problem == cycle::Problem::kPad) return pad_files(c.pad, units);
  std::vector<DataFile> files;
  if (c.liner.distortion_map) {
    files.push_back(
        {"liner.distortion_map", *c.liner.distortion_map, [&units](const NamedFile& file, Case& to) -> ReadData {
           BoreMapFile bore = read_bore_map(file, units);
           to.liner.map = std::move(bore.map);
           return {bore.sha256, bore.notes};
         }});
  }
  if (c.ring.pressure_points) {
    files.push_back(
        {"ring.pressure_points", *c.ring.pressure_points, [&units](const NamedFile& file, Case& to) -> ReadData {
           PressurePointsFile points = read_pressure_points(file, units);
           to.ring.pressure_around = std::move(points.points);
           return {points.sha256, points.notes};
         }});
  }
  if (c.ring.free_shape) {
    files.push_back({"ring.free_shape", *c.ring.free_shape, [&units](const NamedFile& file, Case& to) -> ReadData {
                       FreeShapeFile shape = read_free_shape(file, units);
                       to.ring.free_ring = std::move(shape.ring);
                       return {shape.sha256, shape.notes};
                     }});
  }
  if (c.problem == cycle::Problem::kClosure) return files;
  if (c.liner.dynamic_distortion) {
    files.push_back({"liner.dynamic_distortion", *c.liner.dynamic_distortion,
                     [&units](const NamedFile& file, Case& to) -> ReadData {
                       DynamicBoreFile bore = read_dynamic_bore(file, units);
                       to.liner.dynamic = std::move(bore.dynamic);
                       return {bore.sha256, bore.notes};
                     }});
  }
  append_gas_files(c.gas, units, files);
  append_land_file("ring.pressure_above", &cycle::Ring::pressure_above, c.ring, units, files);
  append_land_file("ring.pressure_below", &cycle::Ring::pressure_below, c.ring, units, files);
  if (c.ring.face.form == cycle::FaceForm::kPoints && !c.ring.face.points_file.empty()) {
    files.push_back({"ring.face.file", c.ring.face.points_file, [&units](const NamedFile& file, Case& to) -> ReadData {
                       FaceFile points = read_face(file, units);
                       to.ring.face.x = std::move(points.x);
                       to.ring.face.height = std::move(points.height);
                       fit_to_width(to.ring.face.x, to.ring.face_width);
                       return {points.sha256, points.notes};
                     }});
  }
  if (c.lubricant.table_file) {
    files.push_back({"lubricant.table", *c.lubricant.table_file, [&units](const NamedFile& file, Case& to) -> ReadData {
                       OilFile oil = read_oil_table(file, units);
                       to.lubricant.table = std::move(oil.table);
                       return {oil.sha256, oil.notes};
                     }});
  }
  if (c.contact.model == cycle::ContactLaw::kTable && !c.contact.law_file.empty()) {
    files.push_back({"contact.law", c.contact.law_file, [](const NamedFile& file, Case& to) -> ReadData {
                       ContactLawFile law = read_contact_law(file);
                       to.contact.law = std::move(law.law);
                       return {law.sha256, law.notes};
                     }});
  }
  if (c.contact.friction_pair) {
    const std::string name = *c.contact.friction_pair;
    files.push_back({"contact.friction_pair", kPairsFile, [&units, name](const NamedFile& file, Case& to) -> ReadData {
                       const FrictionPairs all = read_friction_pairs(file, units);
                       take_pair(pair_of_name(all, name), to);
                       return {all.sha256, {}};
                     }});
  }
  return files;
}

void read_data_file(const DataFile& data, Case& c) {
  const ReadData read = data.read(locate(data.name, ""), c);
  c.files.push_back({data.key, data.name, read.sha256});
  c.notes.insert(c.notes.end(), read.notes.begin(), read.notes.end());
}

}  // namespace ringfilm::io
