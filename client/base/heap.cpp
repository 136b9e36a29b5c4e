#include "client/base/heap.hpp"

#include <malloc.h>

namespace cd {

void keep_heap_small() {
    // Fixes both thresholds: by default they grow with the largest array freed so far.
    ::mallopt(M_MMAP_THRESHOLD, 4 << 20);
    ::mallopt(M_TRIM_THRESHOLD, 8 << 20);
}

void return_free_memory() {
    ::malloc_trim(0);
}

} // namespace cd
