// Join tokens: they let a program without a certificate join a cluster.
#pragma once

#include "common/core/files/hash.hpp"
#include "common/core/result.hpp"

#include <cstdint>
#include <string>
#include <string_view>

namespace cd {

/// A secret that an admin passes to a new member over a trusted channel.
struct JoinToken {
    std::uint64_t id = 0;
    Sha256 secret;    ///< Never sent, and not stored by the master.
    Sha256 authority; ///< Fingerprint of the authority that the master must prove.
};

/// Returns "cdt1." and the three members in hexadecimal, separated by dots.
[[nodiscard]] std::string to_text(const JoinToken& token);
/// Parses the result of `to_text`. Errors: BadInput, whose detail does not show the text.
[[nodiscard]] Result<JoinToken> parse_join_token(std::string_view text);

/// Returns SHA-256 of the token's secret. The master stores this form, which serves to check a
/// proof, but not to make one.
[[nodiscard]] Sha256 stored_secret(const JoinToken& token);

/// Proves possession of the token as in SCRAM (RFC 5802, section 3). The proof does not help an
/// observer to join, and is valid on one connection for one certificate request. `binding` is the
/// channel binding of the connection.
[[nodiscard]] Sha256
join_proof(const JoinToken& token, const Sha256& binding, std::string_view request);
/// Checks a `join_proof`. `stored` is the `stored_secret` of the token.
[[nodiscard]] bool is_join_proof(const Sha256& proof,
                                 const Sha256& stored,
                                 const Sha256& binding,
                                 std::string_view request);

} // namespace cd
