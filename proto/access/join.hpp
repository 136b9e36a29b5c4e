// How a program gets its certificate from a master, the first time and again.
#pragma once

#include "proto/access/join_token.hpp"
#include "proto/channel/channel.hpp"

#include <string>

namespace cd {

/// Proves the token to the master that it pins, and gets a certificate for a new key. `name` is for
/// people. Errors: BadInput for a name that is not good; those of `connect` and `greet`; Refused
/// with the master's reason.
[[nodiscard]] asio::awaitable<Result<Credential>>
join_cluster(Endpoint master, JoinToken token, std::string name);

/// A certificate like the one that `tls` shows, for a new key, with a new end. Errors: as above.
[[nodiscard]] asio::awaitable<Result<Credential>> renew_credential(Endpoint master,
                                                                   std::shared_ptr<const Tls> tls);

} // namespace cd
