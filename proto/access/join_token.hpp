// Tokens: what lets someone join a cluster who has no certificate yet.
#pragma once

#include "common/core/files/hash.hpp"
#include "common/core/result.hpp"

#include <cstdint>
#include <string>
#include <string_view>

namespace cd {

/// Given to who is to join, by a way that is trusted.
struct JoinToken {
    std::uint64_t id = 0;
    Sha256 secret;    ///< Never sent, and not kept by the master.
    Sha256 authority; ///< Fingerprint: whom to believe that it is the master.
};

/// "cdt1." and the three in hexadecimal, with points between them.
[[nodiscard]] std::string to_text(const JoinToken& token);
/// Errors: BadInput, not repeating the text.
[[nodiscard]] Result<JoinToken> parse_join_token(std::string_view text);

/// What the master keeps of a token: enough to check a proof, not to make one.
[[nodiscard]] Sha256 stored_secret(const JoinToken& token);

// The proof is that of SCRAM (RFC 5802, section 3): who sees it learns nothing to join with, and it
// holds on one connection for one request alone. `binding` is that of the connection.
[[nodiscard]] Sha256
join_proof(const JoinToken& token, const Sha256& binding, std::string_view request);
[[nodiscard]] bool is_join_proof(const Sha256& proof,
                                 const Sha256& stored,
                                 const Sha256& binding,
                                 std::string_view request);

} // namespace cd
