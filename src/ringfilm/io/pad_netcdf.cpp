#include "ringfilm/io/pad_netcdf.hpp"

#include "ringfilm/io/atomic_file.hpp"
#include "ringfilm/io/pad_file_layout.hpp"
#include "ringfilm/io/result_file_writer.hpp"

namespace ringfilm::io {

void write_pad(const std::string& path, const PadDocument& document) {
  ResultFileWriter file(path);
  put_pad(file, document);
  write_atomically(path, file.bytes());
}

}  // namespace ringfilm::io
