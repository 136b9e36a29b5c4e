#include "common/core/host/service_notice.hpp"

#include "common/core/host/log.hpp"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <cstring>

namespace cd {

namespace {

/// Sends a datagram to a socket of the file system, or, if the name begins with @, to an abstract
/// one. Returns 0 or an error number.
int send_to(std::string_view name, std::string_view text) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    if (name.size() >= sizeof address.sun_path || (name[0] != '/' && name[0] != '@')) {
        return EINVAL;
    }
    std::copy(name.begin(), name.end(), address.sun_path);
    if (name[0] == '@') {
        address.sun_path[0] = '\0';
    }
    const int socket = ::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
    if (socket < 0) {
        return errno;
    }
    const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + name.size());
    const ssize_t sent = ::sendto(socket,
                                  text.data(),
                                  text.size(),
                                  MSG_NOSIGNAL,
                                  reinterpret_cast<const sockaddr*>(&address),
                                  size);
    const int error = sent < 0 ? errno : 0;
    ::close(socket);
    return error;
}

} // namespace

void notify_service(std::string_view state) {
    const char* const name = std::getenv("NOTIFY_SOCKET");
    if (name == nullptr || *name == '\0') {
        return;
    }
    if (const int error = send_to(name, state); error != 0) {
        log_warning("service manager not told: state={} socket=\"{}\" error=\"{}\"",
                    state,
                    name,
                    std::strerror(error));
    }
}

} // namespace cd
