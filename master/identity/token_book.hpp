// The tokens of a cluster: who may still join, and as what. A state machine: no clock, no disk.
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
    /// What is asked of a new token.
    struct Terms {
        CertifiedRole role = CertifiedRole::Worker;
        std::uint32_t uses = 1;
        WallTime until;
    };
    /// A proof, and what it is over.
    struct Proof {
        std::uint64_t token = 0;
        Sha256 proof;
        Sha256 binding; ///< Of the connection that it came over.
        std::string_view request;
    };

    /// Expired ones are forgotten. Errors: BadInput for terms that are none; TooLarge when there
    /// are `limits::tokens_max`.
    [[nodiscard]] Result<JoinToken>
    create(const Terms& terms, const Sha256& authority, WallTime now);

    /// Counts one use. Errors: Refused with the reason.
    [[nodiscard]] Result<CertifiedRole> redeem(const Proof& proof, WallTime now);

    /// All of it as text, without any secret; and back. Errors: BadInput.
    [[nodiscard]] std::string to_text() const;
    [[nodiscard]] static Result<TokenBook> parse(const std::string& text);

  private:
    struct Entry {
        Sha256 stored; ///< `stored_secret`.
        CertifiedRole role = CertifiedRole::Worker;
        std::uint32_t uses_left = 0;
        WallTime until;
    };
    std::map<std::uint64_t, Entry> tokens_;
};

} // namespace cd
