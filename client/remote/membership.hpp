// What cdctl shows to masters: joined with a token, kept in a file, renewed when it is used.
#pragma once

#include "client/cli/cli.hpp"
#include "proto/access/join_token.hpp"
#include "proto/channel/channel.hpp"

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>

namespace cd {

/// Where the credential for this master is: where the user says, or in the folder of the user's
/// state. Empty where the user wants none.
[[nodiscard]] std::filesystem::path client_credential_path(const MasterOptions& options,
                                                           const Endpoint& master);

/// With what to connect; null where there is no credential, and none was named. One that has lived
/// half of its time is renewed, or else a warning printed. Errors: those of `read_credential`.
/// `stop` ends a renewal that goes on.
[[nodiscard]] Result<std::shared_ptr<const Tls>>
client_tls(const MasterOptions& options, const Endpoint& master, const std::stop_token& stop = {});

/// When the credential for this master is due to be renewed; nothing where there is none.
[[nodiscard]] std::optional<std::chrono::system_clock::time_point>
renewal_time(const MasterOptions& options, const Endpoint& master);

/// Gets a credential and writes it to the file. Returns what it says. Errors: those of
/// `join_cluster` and `write_credential`.
[[nodiscard]] Result<Identity> join_as_client(const Endpoint& master,
                                              const JoinToken& token,
                                              const std::string& name,
                                              const std::filesystem::path& path);

} // namespace cd
