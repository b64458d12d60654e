#include "ringfilm/io/pad/pad_netcdf.hpp"

#include "ringfilm/io/pad/pad_file_layout.hpp"
#include "ringfilm/io/result/result_file_writer.hpp"
#include "ringfilm/io/storage/atomic_file.hpp"

namespace ringfilm::io {

void write_pad(const std::string& path, const PadDocument& document) {
  ResultFileWriter file(path);
  put_pad(file, document);
  write_atomically(path, file.bytes());
}

}  // namespace ringfilm::io
