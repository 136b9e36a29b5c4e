// Messages for joining a cluster, over TLS only.
#pragma once

#include "common/core/files/hash.hpp"
#include "proto/identity/certificate.hpp"

#include <cstdint>
#include <string>

namespace cd {

/// Requests a certificate for a Joiner that has none. Answered by Certified.
struct Join {
    std::uint64_t token = 0; ///< The token's `id` (join_token.hpp).
    Sha256 proof;            ///< `join_proof` (join_token.hpp).
    std::string name;        ///< Display name in the certificate.
    std::string request;     ///< PEM from `make_certificate_request`.
};

/// Requests a new certificate with the role and name of the one that the Joiner shows. Answered by
/// Certified.
struct Renew {
    std::string request; ///< PEM.
};

struct Certified {
    std::string certificate; ///< PEM.
    std::string authority;   ///< PEM certificate of the authority that signed it.
};

/// Requests a new join token for an admin. Answered by TokenCreated.
struct TokenCreate {
    CertifiedRole role = CertifiedRole::Worker;
    std::uint64_t seconds = 0; ///< Lifetime of the token.
    std::uint32_t uses = 1;    ///< How often programs may join with the token.
};

struct TokenCreated {
    std::string token; ///< Text of the JoinToken (join_token.hpp).
};

} // namespace cd
