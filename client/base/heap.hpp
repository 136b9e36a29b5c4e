// Sets how much freed memory malloc keeps for later allocations.
#pragma once

namespace cd {

/// For importing and building, which need several times the memory that stays in use: arrays above
/// 4 MiB are mapped separately, and free memory above 8 MiB at the heap's end is returned.
void return_freed_memory();

/// Call when importing and building are done: returns the memory that they have freed, and from
/// then on keeps up to 64 MiB of freed memory for further results. Mapping and clearing new pages
/// for each result can take longer than the search.
void keep_freed_memory();

} // namespace cd
