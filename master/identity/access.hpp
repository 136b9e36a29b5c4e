// Access rights of a connection, by the certificate that its peer showed.
#pragma once

#include "common/core/result.hpp"
#include "proto/codec/message.hpp"
#include "proto/identity/certificate.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

namespace cd {

class MasterIdentity;

/// A connection without TLS has all rights; the master accepts one only on loopback or with
/// --insecure.
class Access {
  public:
    Access() = default;
    Access(MasterIdentity& identity, std::optional<Identity> holder)
        : identity_(&identity), holder_(std::move(holder)) {}

    /// Null without TLS.
    [[nodiscard]] MasterIdentity* identity() const { return identity_; }
    /// Empty if the peer showed no certificate.
    [[nodiscard]] const std::optional<Identity>& holder() const { return holder_; }

    /// Owner of the jobs submitted over this connection: the certificate's holder or, without TLS,
    /// the user named by the client.
    [[nodiscard]] const std::string& owner() const { return holder_ ? holder_->name : user_; }
    void set_user(std::string user) { user_ = std::move(user); }
    /// Checks that this connection may change, end or remove a job whose owner is `of_job`. The
    /// owner, an admin, and everybody without TLS may. Errors: Refused naming the owner.
    [[nodiscard]] Status check_owner(const std::string& of_job) const;

    /// Checks that this connection may give a job this priority. Above 0 an admin may, and
    /// everybody without TLS. Errors: Refused.
    [[nodiscard]] Status check_priority(std::int32_t priority) const;

    /// Checks that the certificate has not expired and that its holder is not on the list of
    /// refused names. Passes without TLS or without a certificate. Errors: Refused with the reason.
    [[nodiscard]] Status check_holder() const;
    /// Checks that the peer may connect in this role. Errors: Refused with the reason.
    [[nodiscard]] Status check(Role role) const;
    /// Checks that the peer, as a client, may send this message. Errors: Refused with the reason.
    [[nodiscard]] Status check(const Message& message) const;

  private:
    /// True for an admin, and for everybody without TLS.
    [[nodiscard]] bool is_admin() const;

    MasterIdentity* identity_ = nullptr;
    std::optional<Identity> holder_;
    std::string user_;
};

} // namespace cd
