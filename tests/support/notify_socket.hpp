// A datagram socket that receives what a daemon tells the service manager (NOTIFY_SOCKET).
#pragma once

#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstddef>
#include <string>

namespace cd::tests {

class NotifySocket {
  public:
    /// A name that begins with @ makes an abstract socket.
    explicit NotifySocket(const std::string& name) : name_(name) {
        sockaddr_un address{};
        address.sun_family = AF_UNIX;
        name.copy(address.sun_path, sizeof address.sun_path - 1);
        if (name[0] == '@') {
            address.sun_path[0] = '\0';
        }
        const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + name.size());
        EXPECT_EQ(::bind(socket_, reinterpret_cast<const sockaddr*>(&address), size), 0) << name;
    }
    NotifySocket(const NotifySocket&) = delete;
    NotifySocket& operator=(const NotifySocket&) = delete;
    ~NotifySocket() { ::close(socket_); }

    /// The variable of the environment that names the socket.
    [[nodiscard]] std::string variable() const { return "NOTIFY_SOCKET=" + name_; }

    /// Returns the next message, or "" if none comes within `limit`.
    [[nodiscard]] std::string next(std::chrono::milliseconds limit = std::chrono::minutes(1)) {
        pollfd waited{socket_, POLLIN, 0};
        if (::poll(&waited, 1, static_cast<int>(limit.count())) != 1) {
            return "";
        }
        std::array<char, 256> bytes{};
        const ssize_t size = ::recv(socket_, bytes.data(), bytes.size(), 0);
        return size < 0 ? "" : std::string(bytes.data(), static_cast<std::size_t>(size));
    }

  private:
    std::string name_;
    int socket_ = ::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
};

} // namespace cd::tests
