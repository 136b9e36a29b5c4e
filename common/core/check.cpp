#include "common/core/check.hpp"

#include "common/core/host/log.hpp"

#include <cstdlib>

namespace cd {

void check_failed(const char* condition, const char* file, int line) {
    log_critical("broken invariant: {} at={}:{}", condition, file, line);
    std::abort();
}

} // namespace cd
