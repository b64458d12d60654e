#include "ringfilm/io/data/face_file.hpp"

#include "ringfilm/io/text/csv_quantity.hpp"

namespace ringfilm::io {

FaceFile read_face(const NamedFile& file, const Units& units) {
  const CsvFile csv = read_csv(file);
  std::vector<Fault> faults;
  FaceFile face;
  face.x = quantity_column(csv, "x", "m", "x [mm]", units, faults);
  face.height = quantity_column(csv, "height", "m", "height [um]", units, faults);
  for (std::size_t i = 1; i < face.x.size(); ++i) {
    if (face.x[i] > face.x[i - 1]) continue;
    faults.push_back({csv.cell_mark(i, *csv.find("x")),
                      face.x[i] == face.x[i - 1] ? "this x comes twice" : "x falls from the row before to this one",
                      "x must increase from row to row"});
    break;
  }
  if (!faults.empty()) throw InputError(faults);
  face.sha256 = csv.source.sha256;
  face.notes = csv.notes;
  return face;
}

}  // namespace ringfilm::io
