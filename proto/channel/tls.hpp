// What one end of secured connections shows, and whom it takes.
#pragma once

#include "proto/identity/certificate.hpp"

#include <memory>
#include <optional>

namespace cd {

/// TLS 1.3 alone, by certificates of one authority. Never changes, and serves any number of
/// connections, on both of their ends.
class Tls {
  public:
    /// Shows this credential, and takes who shows one of the same authority. Errors: BadInput for
    /// texts that do not belong together.
    [[nodiscard]] static Result<std::shared_ptr<const Tls>> make(const Credential& credential);
    /// Shows nothing, and takes whom the authority of this fingerprint has signed.
    [[nodiscard]] static std::shared_ptr<const Tls> make_joining(const Sha256& authority);

    Tls(const Tls&) = delete;
    Tls& operator=(const Tls&) = delete;
    ~Tls();

    /// What it shows; nothing while joining.
    [[nodiscard]] const std::optional<Identity>& identity() const;

    struct State; ///< Known to stream.cpp.
    [[nodiscard]] State& state() const { return *state_; }

  private:
    explicit Tls(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

/// What a program shows from now on: another Tls when its certificate has been renewed. One
/// thread's.
struct TlsSlot {
    std::shared_ptr<const Tls> now; ///< Null: plain.
};

} // namespace cd
