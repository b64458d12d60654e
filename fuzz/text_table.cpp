#include "ringfilm/io/table/text_table.hpp"

#include <string_view>

#include "fuzz_target.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/io/text/text_encoding.hpp"

/// Any bytes as a table of numbers: with named columns, and as heights with all that the user may state.
RINGFILM_FUZZ_TARGET(text_table) {
  using namespace ringfilm::io;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const std::optional<DecodedText> text = decoded(bytes);
  TableReading stated;
  stated.columns = "x [um], -, z [um]";
  stated.skip_lines = 1;
  stated.missing = {"-9999", "none"};
  for (const TableReading& reading : {TableReading(), stated}) {
    for (const TableRules& rules :
         {TableRules{TableHeader::kRequired, Gaps::kListed}, TableRules{TableHeader::kOptional, Gaps::kKept}}) {
      try {
        for (const TextTable& table : read_text_tables("a.csv", text ? text->text : bytes, rules, reading)) {
          table.account();
        }
      } catch (const ringfilm::InputError& error) {
        ringfilm::describe(error.faults());
      }
    }
  }
  outline_of_text(bytes, stated);
  return 0;
}
