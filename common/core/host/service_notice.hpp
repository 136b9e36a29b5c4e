// Tells a service manager such as systemd how far a daemon is, over the socket that the environment
// variable NOTIFY_SOCKET names.
#pragma once

#include <string_view>

namespace cd {

/// Sends `state`, such as READY=1 or STOPPING=1, to the service manager. Without NOTIFY_SOCKET does
/// nothing; logs a warning if the socket does not take it.
void notify_service(std::string_view state);

} // namespace cd
