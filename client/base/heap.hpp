// How much memory this process holds on to after it was freed.
#pragma once

namespace cd {

/// From now on large arrays come straight from the system and go back to it, and so does what is
/// free at the ends of the threads' heaps. Importing and building take several times the memory
/// that stays.
void keep_heap_small();

/// Gives back what is free within the heaps. For after importing and building.
void return_free_memory();

} // namespace cd
