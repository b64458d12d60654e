#pragma once
#include <string>
#include <vector>

#include "ringfilm/io/result/result_file_layout.hpp"
#include "ringfilm/io/result/ring_gatherer.hpp"

namespace ringfilm::io {

/// The variants of all ledger entries one after the other, and their cycle values row by row.
struct VariantTable {
  std::vector<VariantRow> rows;
  std::vector<std::string> quantities;  ///< name of each column of `values`
  std::vector<std::string> units;
  std::vector<double> values;
};
VariantTable variant_table(const std::vector<study::LedgerEntry>& ledger);

/// A pack: what its rings have in common, then all that they have along the dimension `ring`.
template <class File>
void put_pack(File& file, const ResultDocument& document) {
  exchange_pack(file, document);
  RingGatherer rings;
  for (const ResultDocument& ring : document.rings) {
    rings.next_ring();
    const VariantTable variants = variant_table(ring.ledger);
    exchange(rings, ring, variants);
  }
  rings.write(file);
}

/// All of a result, its marks as a file of ours among them, to whoever takes the calls of ResultFileWriter.
template <class File>
void put_document(File& file, const ResultDocument& document) {
  file.attribute("Conventions", std::string("CF-1.10"));
  file.attribute("ringfilm_schema", kResultSchema);
  if (document.is_pack()) return put_pack(file, document);
  const VariantTable variants = variant_table(document.ledger);
  exchange(file, document, variants);
}

}  // namespace ringfilm::io
