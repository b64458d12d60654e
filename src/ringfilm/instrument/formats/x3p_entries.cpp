#include "ringfilm/instrument/formats/x3p_entries.hpp"

#include <algorithm>

namespace ringfilm::instrument {

std::string entry_name(std::string link) {
  std::replace(link.begin(), link.end(), '\\', '/');
  return link.rfind("./", 0) == 0 ? link.substr(2) : link;
}

std::string stored_entry(const ZipArchive& archive, const std::string& name) {
  if (archive.size(name)) return name;
  for (const std::string& stored : archive.names()) {
    if (entry_name(stored) == name) return stored;
  }
  return name;
}

std::string main_entry(const ZipArchive& archive) {
  const std::string name = "main.xml", top = stored_entry(archive, name);
  if (archive.size(top)) return top;
  std::string found;
  for (const std::string& stored : archive.names()) {
    const std::string entry = entry_name(stored);
    if (entry.size() <= name.size() ||
        entry.compare(entry.size() - name.size() - 1, name.size() + 1, "/" + name) != 0) {
      continue;
    }
    if (!found.empty()) return "";
    found = stored;
  }
  return found;
}

}  // namespace ringfilm::instrument
