// How many pairs each stage of our decision settles, and what a pair that needs it costs in all.
#pragma once

#include "bench/accuracy/csv.hpp"
#include "bench/accuracy/suites/pair_batch.hpp"

#include <cstddef>
#include <string>

namespace cd::bench {

/// Writes a row a stage that settles any of the pairs: how many, and the time of a pair among its
/// like, with what the stages before it cost. And a row "all": the pairs as they come.
void run_stages(const std::string& suite,
                const std::string& category,
                const PairBatch& batch,
                std::size_t rounds,
                CsvFile& csv);

[[nodiscard]] CsvFile open_stages_csv(const std::filesystem::path& folder);

} // namespace cd::bench
