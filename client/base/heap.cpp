#include "client/base/heap.hpp"

#include <malloc.h>

namespace cd {

namespace {

constexpr int mebibyte = 1 << 20;

/// Once set, the thresholds no longer grow with the largest array that was freed.
void set_thresholds(int map_above, int return_above) {
    ::mallopt(M_MMAP_THRESHOLD, map_above);
    ::mallopt(M_TRIM_THRESHOLD, return_above);
}

} // namespace

void return_freed_memory() {
    set_thresholds(4 * mebibyte, 8 * mebibyte);
}

void keep_freed_memory() {
    ::malloc_trim(0);
    set_thresholds(32 * mebibyte, 64 * mebibyte);
}

} // namespace cd
