#pragma once
#include <functional>
#include <string>
#include <vector>

#include "ringfilm/case/case.hpp"
#include "ringfilm/io/text/source_text.hpp"
#include "ringfilm/io/text/units.hpp"

/// The files of numbers that a case names: traces, face points, oil tables, gaps.
namespace ringfilm::io {

/// What a file gave besides its numbers.
struct ReadData {
  std::string sha256;
  std::vector<std::string> notes;
};

/// A file that the case names and uses.
struct DataFile {
  std::string key;                                                    ///< that names it
  std::string name;                                                   ///< as named
  std::function<ReadData(const NamedFile& file, cycle::Case&)> read;  ///< puts its numbers into a case
};

/// The files of `c` in the order in which they are read. `units` must outlive them.
std::vector<DataFile> data_files(const cycle::Case& c, const Units& units);

/// Puts the numbers of one file into the case and records it. Throws InputError with the faults of the file.
void read_data_file(const DataFile& data, cycle::Case& c);

}  // namespace ringfilm::io
