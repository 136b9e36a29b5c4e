// The join tokens of a cluster, each with its role and its uses. A state machine: no clock, no
// disk.
#pragma once

#include "common/core/limits/master.hpp"
#include "common/core/result.hpp"
#include "proto/access/join_token.hpp"
#include "proto/identity/certificate.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

namespace cd {

class TokenBook {
  public:
    /// Properties of a new token.
    struct Terms {
        CertifiedRole role = CertifiedRole::Worker;
        std::uint32_t uses = 1;
        WallTime until;
    };
    /// A peer's proof that it knows a token, and the data that the proof covers.
    struct Proof {
        std::uint64_t token = 0;
        Sha256 proof;
        Sha256 binding;           ///< TLS channel binding of the connection that carried the proof.
        std::string_view request; ///< Certificate request.
    };

    /// Creates a token, after forgetting expired ones. Errors: BadInput for invalid terms; TooLarge
    /// with `limits::tokens_max` tokens.
    [[nodiscard]] Result<JoinToken>
    create(const Terms& terms, const Sha256& authority, WallTime now);

    /// Counts one use of the token. Returns the token's role. Errors: Refused with the reason.
    [[nodiscard]] Result<CertifiedRole> redeem(const Proof& proof, WallTime now);

    /// Returns the book as text, without the tokens' secrets.
    [[nodiscard]] std::string to_text() const;
    /// Inverse of `to_text`. Errors: BadInput for damaged text.
    [[nodiscard]] static Result<TokenBook> parse(const std::string& text);

  private:
    struct Entry {
        Sha256 stored; ///< `stored_secret` of the token.
        CertifiedRole role = CertifiedRole::Worker;
        std::uint32_t uses_left = 0;
        WallTime until;
    };
    std::map<std::uint64_t, Entry> tokens_;
};

} // namespace cd
