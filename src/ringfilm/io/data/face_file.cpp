#include "ringfilm/io/data/face_file.hpp"

#include <algorithm>

#include "ringfilm/io/table/csv_quantity.hpp"

namespace ringfilm::io {

FaceFile read_face(const NamedFile& file, const Units& units) {
  const CsvFile csv = read_csv(file);
  std::vector<Fault> faults;
  FaceFile face;
  face.x = quantity_column(csv, "x", "m", "x [mm]", units, faults);
  const bool is_z = !csv.find("height") && csv.find("z");
  face.height = quantity_column(csv, is_z ? "z" : "height", "m", "height [um]", units, faults);
  face.notes = csv.notes;
  const bool falls = std::is_sorted(face.x.rbegin(), face.x.rend()) && face.x.size() > 2;
  if (falls && faults.empty()) {
    std::reverse(face.x.begin(), face.x.end());
    std::reverse(face.height.begin(), face.height.end());
    face.notes.push_back(csv.source.path + ": x falls from row to row: the face was turned about");
  }
  for (std::size_t i = 1; i < face.x.size(); ++i) {
    if (face.x[i] > face.x[i - 1]) continue;
    faults.push_back({csv.cell_mark(falls ? face.x.size() - 1 - i : i, *csv.find("x")),
                      face.x[i] == face.x[i - 1] ? "this x comes twice" : "x falls from the row before to this one",
                      "x must increase from row to row"});
    break;
  }
  if (!faults.empty()) throw InputError(faults);
  face.sha256 = csv.source.sha256;
  return face;
}

}  // namespace ringfilm::io
