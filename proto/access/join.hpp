// Getting a certificate from a master: joining and renewing.
#pragma once

#include "proto/access/join_token.hpp"
#include "proto/channel/asio.hpp"
#include "proto/channel/endpoint.hpp"
#include "proto/channel/tls.hpp"

#include <string>

namespace cd {

/// Gets a certificate for a new key by proving that this end has the token. The master must belong
/// to the token's authority. `name` is a display name. Errors: BadInput for an invalid name; those
/// of `connect` and `greet`; Refused with the master's reason.
[[nodiscard]] asio::awaitable<Result<Credential>>
join_cluster(Endpoint master, JoinToken token, std::string name);

/// Gets a certificate with the role and name of the certificate in `tls`, but a new key and
/// validity. Errors: those of `connect` and `greet`; Refused with the master's reason.
[[nodiscard]] asio::awaitable<Result<Credential>> renew_credential(Endpoint master,
                                                                   std::shared_ptr<const Tls> tls);

} // namespace cd
