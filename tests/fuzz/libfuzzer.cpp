// Entry points for libFuzzer: a program called fuzz_NAME feeds the target NAME.
#include "tests/fuzz/targets.hpp"

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <span>
#include <string>

namespace {

const cd::fuzz::Target* chosen = nullptr;

} // namespace

extern "C" int LLVMFuzzerInitialize(int* /*count*/, char*** arguments) {
    const std::string program = std::filesystem::path(**arguments).filename();
    for (const cd::fuzz::Target& target : cd::fuzz::targets()) {
        if (program == "fuzz_" + std::string(target.name)) {
            chosen = &target;
            return 0;
        }
    }
    std::fprintf(stderr, "%s names no target: call it fuzz_TARGET\n", program.c_str());
    std::exit(2);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    chosen->run(std::as_bytes(std::span(data, size)));
    return 0;
}
