#pragma once
#include <span>
#include <string>
#include <vector>

#include "ringfilm/case/case.hpp"
#include "ringfilm/cycle/result/result.hpp"
#include "ringfilm/io/result/result_file.hpp"

namespace ringfilm::io {

/// All that a result file holds of one integration by this program: the case key by key, what it was read from, what
/// computed it, and the result. Ledger, comparison and error estimate remain empty.
ResultDocument result_document(const cycle::Case& c, cycle::CycleResult result);

/// The result of a ring pack from those of its rings, whose titles become "TITLE: ring 1 (NAME)".
/// @param title title of the pack
ResultDocument pack_document(const std::string& title, std::vector<ResultDocument> rings);

/// The number of each ring of a pack, from 1; rails of an oil ring have the number of their ring.
std::vector<std::size_t> ring_numbers(const ResultDocument& pack);

/// The rings of a pack, or the one ring of a document that is not a pack; a view of the document.
std::span<const ResultDocument> rings_of(const ResultDocument& document);

}  // namespace ringfilm::io
