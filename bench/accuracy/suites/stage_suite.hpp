// Measures how many pairs each stage of our decision settles, and the total cost of such a pair.
#pragma once

#include "bench/accuracy/csv.hpp"
#include "bench/accuracy/suites/pair_batch.hpp"

#include <cstddef>
#include <string>

namespace cd::bench {

/// Writes a row for each stage that settles any pair: their number, and the time per pair among
/// pairs of this stage, earlier stages included. The row "all" takes the pairs in their given
/// order.
void run_stages(const std::string& suite,
                const std::string& category,
                const PairBatch& batch,
                std::size_t rounds,
                CsvFile& csv);

[[nodiscard]] CsvFile open_stages_csv(const std::filesystem::path& folder);

} // namespace cd::bench
