// The certificates of a cluster: their authority and content.
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
/// Converts a time. Empty outside the range of the clock, which ends in the year 2262.
[[nodiscard]] std::optional<WallTime> wall_time(std::int64_t seconds_since_1970);

/// The role of a certificate's holder. One certificate names one role.
enum class CertifiedRole : std::uint8_t {
    Master = 0,
    Worker = 1,
    Submitter = 2, ///< Submits jobs, observes all jobs, and cancels and removes its own.
    Admin = 3,     ///< Manages all jobs, join tokens, meshes and workers, and submits jobs.
    Metrics = 4,   ///< Reads the state of the cluster.
};

[[nodiscard]] std::string_view to_text(CertifiedRole role);
[[nodiscard]] std::optional<CertifiedRole> certified_role_from_text(std::string_view text);

/// The holder and validity in a certificate.
struct Identity {
    CertifiedRole role = CertifiedRole::Submitter;
    std::string name; ///< Display name that satisfies `is_good_name`.
    WallTime from;    ///< Start of validity.
    WallTime until;   ///< End of validity.
};

/// A new private key (ECDSA, P-256), and a certificate request that proves its possession. Both are
/// PEM. The key leaves the process only into the owner's credential file.
struct CertificateRequest {
    std::string key;
    std::string request;
};
[[nodiscard]] CertificateRequest make_certificate_request();

/// The credential of one end of a connection: PEM texts that belong together.
struct Credential {
    std::string key;
    std::string certificate;
    std::string authority; ///< Certificate of the authority that signs all others.
};

/// Signs the certificates of one cluster.
class CertificateAuthority {
  public:
    /// Makes a new authority with a new key.
    [[nodiscard]] static CertificateAuthority make(WallTime now);
    /// Reads an authority from PEM. Errors: BadInput for texts that are not a certificate of an
    /// authority and its key.
    [[nodiscard]] static Result<CertificateAuthority> parse(const std::string& certificate,
                                                            const std::string& key);

    CertificateAuthority(CertificateAuthority&&) noexcept;
    CertificateAuthority& operator=(CertificateAuthority&&) noexcept;
    ~CertificateAuthority();

    [[nodiscard]] const std::string& certificate() const;
    [[nodiscard]] std::string key() const;
    /// The fingerprint that pins the authority in join tokens.
    [[nodiscard]] Sha256 fingerprint() const;

    /// Signs a certificate for the key of the request, and ignores the request's other fields. The
    /// request is untrusted. Errors: BadInput.
    [[nodiscard]] Result<std::string> sign(const std::string& request,
                                           const Identity& identity) const;

    /// Makes a new key and a certificate for it.
    [[nodiscard]] Credential issue(const Identity& identity) const;

  private:
    struct State;
    explicit CertificateAuthority(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

/// Reads a PEM certificate without verifying it. Errors: BadInput if it is no certificate of a
/// cdcluster.
[[nodiscard]] Result<Identity> read_identity(const std::string& certificate);

/// SHA-256 of a certificate's DER form. Errors: BadInput if the text is no certificate.
[[nodiscard]] Result<Sha256> certificate_fingerprint(const std::string& certificate);

} // namespace cd
