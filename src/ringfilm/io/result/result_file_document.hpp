#pragma once
#include <string>
#include <vector>

#include "ringfilm/io/result/pack_sums.hpp"
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

/// What the rings of a pack add up to, `pack_fmep` and the like, and the oil above it.
template <class File>
void put_pack_sums(File& file, const ResultDocument& document) {
  for (const cycle::CycleQuantity& quantity : cycle::summed_quantities()) {
    cycle::Quantity variable = quantity;
    variable.name.insert(0, "pack_");
    variable.long_name.insert(0, "all rings: ");
    file.scalar(variable, document.result.values.*quantity.value);
  }
  const std::optional<PackOil> oil = pack_oil(document);
  for (const PackOilQuantity& quantity : pack_oil_quantities()) {
    if (oil) file.scalar(quantity, *oil.*quantity.value);
  }
}

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
  if (document.result.complete) put_pack_sums(file, document);
}

/// All of a result, its marks as a file of ours among them, to whoever takes the calls of ResultFileWriter.
template <class File>
void put_document(File& file, const ResultDocument& document) {
  file.attribute("Conventions", std::string("CF-1.10"));
  file.attribute("ringfilm_schema", kResultSchema);
  if (document.is_pack()) return put_pack(file, document);
  const VariantTable variants = variant_table(document.ledger);
  exchange(file, document, variants);
  exchange_oil_losses(file, document);
}

}  // namespace ringfilm::io
