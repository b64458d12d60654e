#pragma once
#include <string>

#include "ringfilm/instrument/formats/zip_archive.hpp"

/// Names of the entries of an X3P as its writers have them: with backslashes, in a folder.
namespace ringfilm::instrument {

/// The name of an entry with slashes, of a link like "bindata\\data.bin" or "./bindata/data.bin".
std::string entry_name(std::string link);

/// The entry of that name, or the one whose name differs by its slashes alone; `name` itself where there is none.
std::string stored_entry(const ZipArchive& archive, const std::string& name);

/// main.xml at the top of the archive, or in its only folder that has one; empty where there is none.
std::string main_entry(const ZipArchive& archive);

}  // namespace ringfilm::instrument
