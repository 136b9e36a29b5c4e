// One target as libFuzzer calls it: CD_FUZZ_TARGET names it.
#include "tests/fuzz/targets.hpp"

#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    cd::fuzz::CD_FUZZ_TARGET(std::as_bytes(std::span(data, size)));
    return 0;
}
