// Bounds the freed memory that this process keeps.
#pragma once

namespace cd {

/// Makes the allocator map arrays above 4 MiB separately, and trim more than 8 MiB of free memory
/// at a heap's end: importing and building need several times the memory that stays in use.
void keep_heap_small();

/// Returns free memory within the heaps to the system. Called after importing and building.
void return_free_memory();

} // namespace cd
