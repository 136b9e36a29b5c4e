// Decides what a connection may request, by its certificate.
#pragma once

#include "common/core/result.hpp"
#include "proto/codec/message.hpp"
#include "proto/identity/certificate.hpp"

#include <optional>
#include <string>
#include <utility>

namespace cd {

class MasterIdentity;

/// A connection without TLS, which only loopback or --insecure allow, may request everything.
class Access {
  public:
    Access() = default;
    Access(MasterIdentity& identity, std::optional<Identity> holder)
        : identity_(&identity), holder_(std::move(holder)) {}

    /// Null without TLS.
    [[nodiscard]] MasterIdentity* identity() const { return identity_; }
    /// Empty if the peer showed no certificate.
    [[nodiscard]] const std::optional<Identity>& holder() const { return holder_; }

    /// Owner of the jobs submitted here: the certificate's holder or, without TLS, the user named
    /// by the client.
    [[nodiscard]] const std::string& owner() const { return holder_ ? holder_->name : user_; }
    void set_user(std::string user) { user_ = std::move(user); }
    /// Checks whether this connection may end or remove a job of this owner: its owner, an admin,
    /// and anyone without TLS may. Errors: Refused naming the owner.
    [[nodiscard]] Status check_owner(const std::string& of_job) const;

    /// Checks that the holder's certificate is valid and the holder not refused. Always passes
    /// without TLS or while joining. Errors: Refused with the reason.
    [[nodiscard]] Status check_holder() const;
    /// Checks that the holder may greet in this role. Errors: Refused with the reason.
    [[nodiscard]] Status check(Role role) const;
    /// Checks that the holder may send this message as a client. Errors: Refused with the reason.
    [[nodiscard]] Status check(const Message& message) const;

  private:
    MasterIdentity* identity_ = nullptr;
    std::optional<Identity> holder_;
    std::string user_;
};

} // namespace cd
