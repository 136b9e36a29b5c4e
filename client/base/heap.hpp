// How much freed memory malloc keeps for the next allocation.
#pragma once

namespace cd {

/// For importing and building, which need several times the memory that stays in use: arrays above
/// 4 MiB are mapped separately, and free memory above 8 MiB at the heap's end is returned.
void return_freed_memory();

/// For running: keeps up to 64 MiB of freed memory for the results of the next scenarios. To map
/// and clear it anew for each can take longer than the search.
void keep_freed_memory();

} // namespace cd
