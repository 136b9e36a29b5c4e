// What is said by who wants to belong to the cluster; over TLS alone.
#pragma once

#include "common/core/files/hash.hpp"
#include "proto/identity/certificate.hpp"

#include <cstdint>
#include <string>

namespace cd {

/// Of a Joiner without a certificate. Answered by Certified.
struct Join {
    std::uint64_t token = 0; ///< Its number.
    Sha256 proof;            ///< `join_proof` (join_token.hpp).
    std::string name;        ///< For people: what the certificate will call its holder.
    std::string request;     ///< PEM, of `make_certificate_request`.
};

/// Of a Joiner with a certificate: another one like it. Answered by Certified.
struct Renew {
    std::string request; ///< PEM.
};

struct Certified {
    std::string certificate; ///< PEM, like
    std::string authority;   ///< the certificate that it is signed with.
};

/// Of an admin, as a client. Answered by TokenCreated.
struct TokenCreate {
    CertifiedRole role = CertifiedRole::Worker;
    std::uint64_t seconds = 0; ///< From now on.
    std::uint32_t uses = 1;
};

struct TokenCreated {
    std::string token; ///< As `to_text` writes it.
};

} // namespace cd
