#pragma once
#include <string>
#include <vector>

#include "ringfilm/cycle/result/result.hpp"

/// Fields of the unrolled film for ParaView and other programs that read VTK's XML files (docs/manual/report.md).
namespace ringfilm::io {

/// Where the points are.
enum class VtsShape {
  kCylinder,  ///< on the bore: its axis is z, z = -x, chamber above; y goes around z by the right hand
  kPlane      ///< unrolled: (x, y, 0)
};

/// One structured grid: x runs fastest, then y; a closed ring repeats its first strip at its end. Point data as the
/// fields are named, Float32, SI, of a ring that bends those by strip, too; points Float64 [m].
/// @param angle index of the crank angle. Throws InputError if a field has another size than [angle][y][x].
std::string vts_text(const cycle::UnrolledFields& fields, std::size_t angle, VtsShape shape);

/// The list of the files with the crank angle [degree] as their time.
std::string pvd_text(const std::vector<std::string>& names, const std::vector<double>& crank_angle_deg);

/// Can a series be written there? Throws InputError if `folder` is something else, or cannot be made or written to.
void check_can_write_series(const std::string& folder);

/// Writes `stem`_0000.vts, ... and last of all `stem`.pvd into `folder`, which is made if it is not there. The files
/// take their names when all of them are on the disk; those that an older `stem`.pvd lists beyond them are removed.
/// Returns the path of the .pvd file. Throws InputError if there are no fields over (crank_angle, y, x), OutputError.
std::string write_vts_series(const std::string& folder, const std::string& stem, const cycle::UnrolledFields& fields,
                             VtsShape shape);

}  // namespace ringfilm::io
