#pragma once

/// Attributes of every NetCDF file of ringfilm that describe the program that wrote it.
namespace ringfilm::io {

/// Writes them to `file`, or reads them from it: whichever it does with an attribute.
template <class File, class Provenance>
void exchange_provenance(File& file, Provenance& provenance) {
  file.attribute("program", provenance.program);
  file.attribute("commit", provenance.commit);
  file.attribute("compiler", provenance.compiler);
}

}  // namespace ringfilm::io
