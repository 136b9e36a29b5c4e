// Bounds the freed memory that this process keeps.
#pragma once

namespace cd {

/// Makes the allocator map large arrays separately and trim the heaps' free ends. Importing and
/// building need several times the memory that remains in use.
void keep_heap_small();

/// Returns free memory within the heaps to the system. Called after importing and building.
void return_free_memory();

} // namespace cd
