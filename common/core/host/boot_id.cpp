#include "common/core/host/boot_id.hpp"

#include "common/core/files/hash.hpp"

#include <fstream>
#include <span>
#include <string>

namespace cd {

std::uint64_t boot_id() {
    static const std::uint64_t id = [] {
        std::ifstream file("/proc/sys/kernel/random/boot_id");
        std::string text;
        return std::getline(file, text) ? checksum(std::as_bytes(std::span(text))) : 0;
    }();
    return id;
}

} // namespace cd
