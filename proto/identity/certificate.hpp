// The certificates of a cluster: who signs them, and what they say.
#pragma once

#include "common/core/files/hash.hpp"
#include "common/core/result.hpp"

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace cd {

using WallTime = std::chrono::system_clock::time_point;
/// Nothing where the clock does not reach: it ends in the year 2262.
[[nodiscard]] std::optional<WallTime> wall_time(std::int64_t seconds_since_1970);

/// What the holder of a certificate may be. One certificate names one role.
enum class CertifiedRole : std::uint8_t {
    Master = 0,
    Worker = 1,
    Submitter = 2, ///< Gives jobs, and sees and ends them.
    Admin = 3,     ///< A submitter who also lets others in.
    Metrics = 4,   ///< Looks at the state of the cluster.
};

[[nodiscard]] std::string_view to_text(CertifiedRole role);
[[nodiscard]] std::optional<CertifiedRole> certified_role_from_text(std::string_view text);

/// What a certificate says of its holder.
struct Identity {
    CertifiedRole role = CertifiedRole::Submitter;
    std::string name; ///< For people; a good one.
    WallTime from;
    WallTime until;
};

/// A new private key (ECDSA, P-256), and a request for a certificate that proves that the key is
/// there. Both are PEM. The key never leaves the process but into a file of its own.
struct CertificateRequest {
    std::string key;
    std::string request;
};
[[nodiscard]] CertificateRequest make_certificate_request();

/// What one end of a connection shows: PEM texts that belong together.
struct Credential {
    std::string key;
    std::string certificate;
    std::string authority; ///< The certificate that all others are signed with.
};

/// Signs the certificates of one cluster.
class CertificateAuthority {
  public:
    /// A new one, with a key of its own.
    [[nodiscard]] static CertificateAuthority make(WallTime now);
    /// Errors: BadInput for texts that are not a certificate and its key.
    [[nodiscard]] static Result<CertificateAuthority> parse(const std::string& certificate,
                                                            const std::string& key);

    CertificateAuthority(CertificateAuthority&&) noexcept;
    CertificateAuthority& operator=(CertificateAuthority&&) noexcept;
    ~CertificateAuthority();

    [[nodiscard]] const std::string& certificate() const;
    [[nodiscard]] std::string key() const;
    /// By which tokens pin it.
    [[nodiscard]] Sha256 fingerprint() const;

    /// A certificate for the key of the request, of which nothing else is looked at. The bytes may
    /// be hostile. Errors: BadInput.
    [[nodiscard]] Result<std::string> sign(const std::string& request,
                                           const Identity& identity) const;

    /// A new key with a certificate for it.
    [[nodiscard]] Credential issue(const Identity& identity) const;

  private:
    struct State;
    explicit CertificateAuthority(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

/// What a certificate (PEM) says; whether it may be believed is not looked at. Errors: BadInput for
/// one that is not of such a cluster.
[[nodiscard]] Result<Identity> read_identity(const std::string& certificate);

/// SHA-256 of a certificate's DER form.
[[nodiscard]] Result<Sha256> certificate_fingerprint(const std::string& certificate);

} // namespace cd
