#include "ringfilm/io/measurement/free_shape_file.hpp"

#include <fmt/format.h>

#include "ringfilm/io/table/csv_quantity.hpp"

namespace ringfilm::io {
namespace {

void check_rows(const CsvFile& csv, const cycle::FreeRing& ring, std::vector<Fault>& faults) {
  const auto refuse = [&](std::size_t row, const char* column, const std::string& message, const std::string& remedy) {
    faults.push_back({csv.cell_mark(row, *csv.find(column)), message, remedy});
  };
  for (std::size_t i = 0; i < ring.radius.size() && faults.empty(); ++i) {
    if (!(ring.radius[i] > 0)) {
      refuse(i, "radius", "radius = " + text_in(ring.radius[i], kMillimetre) + " is not a distance from a centre",
             "state the radius of the running surface of the free ring, not its deviation");
    }
    if (i == 0) continue;
    if (!(ring.angle_deg[i] > ring.angle_deg[i - 1])) {
      refuse(i, "angle", fmt::format("angle = {:.6g} degree does not rise from row to row", ring.angle_deg[i]),
             "list the points from one end of the ring to the other");
    } else if (ring.angle_deg[i] - ring.angle_deg.front() >= 360) {
      refuse(i, "angle", fmt::format("angle = {:.6g} degree is a whole turn after the first", ring.angle_deg[i]),
             "a free ring has two ends, between which it is open: list the points from one to the other");
    }
  }
}

}  // namespace

FreeShapeFile read_free_shape(const NamedFile& file, const Units& units) {
  const CsvFile csv = read_csv(file);
  std::vector<Fault> faults;
  FreeShapeFile shape;
  shape.ring.angle_deg = quantity_column(csv, "angle", "degree", "angle [degree]", units, faults);
  shape.ring.radius = quantity_column(csv, "radius", "m", "radius [mm]", units, faults);
  if (faults.empty()) check_rows(csv, shape.ring, faults);
  if (!faults.empty()) throw InputError(faults);
  shape.sha256 = csv.source.sha256;
  shape.notes = csv.notes;
  return shape;
}

}  // namespace ringfilm::io
