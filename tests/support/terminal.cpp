#include "tests/support/terminal.hpp"

#include "common/core/check.hpp"

#include <fcntl.h>
#include <stdlib.h>
#include <unistd.h>

#include <array>

namespace cd::tests {

Terminal::Terminal() : screen_(::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC)) {
    CD_CHECK(screen_ >= 0 && ::grantpt(screen_) == 0 && ::unlockpt(screen_) == 0);
    std::array<char, 64> name{};
    CD_CHECK(::ptsname_r(screen_, name.data(), name.size()) == 0);
    device_ = name.data();
    held_open_ = ::open(device_.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC);
    CD_CHECK(held_open_ >= 0);
}

Terminal::~Terminal() {
    ::close(held_open_);
    ::close(screen_);
}

const std::string& Terminal::text() {
    std::array<char, 1024> bytes{};
    for (;;) {
        const ssize_t count = ::read(screen_, bytes.data(), bytes.size());
        if (count <= 0) {
            return text_;
        }
        text_.append(bytes.data(), static_cast<std::size_t>(count));
    }
}

} // namespace cd::tests
