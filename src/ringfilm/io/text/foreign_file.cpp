#include "ringfilm/io/text/foreign_file.hpp"

#include <algorithm>
#include <string>

namespace ringfilm::io {
namespace {

constexpr std::size_t kSearched = 65536;  // at either end of an archive, where its entries are named

struct ForeignKind {
  std::string_view start, entry;  ///< first bytes; text near either end, empty where the start is enough
  const char *name, *remedy;
};
constexpr const char* kWorkbookRemedy = "save the table as CSV in the program that wrote it";
constexpr const char* kMatRemedy = "write the table as CSV, in MATLAB: writematrix([x z], \"table.csv\")";
constexpr ForeignKind kKinds[] = {
    {"PK\x03\x04", "[Content_Types].xml", "an Excel workbook (xlsx) or another Office file", kWorkbookRemedy},
    {"PK\x03\x04", "application/vnd.oasis.opendocument", "a workbook or another OpenDocument file (ods)",
     kWorkbookRemedy},
    {"\xD0\xCF\x11\xE0", "", "a workbook of Excel 97 (xls) or another old Office file", kWorkbookRemedy},
    {"MATLAB 5.0 MAT-file", "", "a MAT file of MATLAB", kMatRemedy},
    {"MATLAB 7.3 MAT-file", "", "a MAT file of MATLAB", kMatRemedy},
    {"TDSm", "", "a TDMS file of LabVIEW",
     "write the table as CSV: in DIAdem or Excel with the TDM add-in, in Python with npTDMS and pandas"},
};

}  // namespace

std::optional<Fault> foreign_file_fault(const SourceMark& file, std::string_view bytes) {
  const std::string_view begin = bytes.substr(0, kSearched),
                         end = bytes.substr(bytes.size() - std::min(bytes.size(), kSearched));
  for (const ForeignKind& kind : kKinds) {
    if (!bytes.starts_with(kind.start)) continue;
    if (begin.find(kind.entry) == std::string_view::npos && end.find(kind.entry) == std::string_view::npos) continue;
    return Fault{file, std::string("this is ") + kind.name + ", not text", kind.remedy};
  }
  return std::nullopt;
}

}  // namespace ringfilm::io
