#include "common/core/check.hpp"

#include <spdlog/spdlog.h>

#include <cstdlib>

namespace cd {

void check_failed(const char* condition, const char* file, int line) {
    spdlog::critical("broken invariant: {} at={}:{}", condition, file, line);
    spdlog::default_logger()->flush();
    std::abort();
}

} // namespace cd
