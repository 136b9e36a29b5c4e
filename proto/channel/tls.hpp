// The TLS configuration of one end: its credential and the authority that it trusts.
#pragma once

#include "proto/identity/certificate.hpp"

#include <memory>
#include <optional>

namespace cd {

/// TLS 1.3 only, with certificates of one authority. Immutable; serves any number of connections,
/// connecting and accepting.
class Tls {
  public:
    /// Shows this credential to peers and trusts its authority. Errors: BadInput for texts that do
    /// not belong together.
    [[nodiscard]] static Result<std::shared_ptr<const Tls>> make(const Credential& credential);
    /// Shows no certificate to peers and trusts the authority with this fingerprint.
    [[nodiscard]] static std::shared_ptr<const Tls> make_joining(const Sha256& authority);

    Tls(const Tls&) = delete;
    Tls& operator=(const Tls&) = delete;
    ~Tls();

    /// The identity in the certificate that this end shows; empty while joining.
    [[nodiscard]] const std::optional<Identity>& identity() const;

    struct State; ///< Defined in tls_state.hpp.
    [[nodiscard]] State& state() const { return *state_; }

  private:
    explicit Tls(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

/// A program's current Tls, replaced when its certificate is renewed. Not thread-safe.
struct TlsSlot {
    std::shared_ptr<const Tls> now; ///< Null: plain TCP.
};

} // namespace cd
