// Credentials on disk.
#pragma once

#include "common/core/result.hpp"
#include "common/core/timing/wire.hpp"
#include "proto/channel/endpoint.hpp"
#include "proto/identity/certificate.hpp"

#include <filesystem>
#include <string>
#include <string_view>

namespace cd {

/// The path in `folder` of the credential with which a program connects to this master.
[[nodiscard]] std::filesystem::path credential_path(const std::filesystem::path& folder,
                                                    const Endpoint& master);

/// Writes key, certificate and authority to one PEM file, atomically, with mode 0600. Creates the
/// file's folder. Errors: Io; BadInput if the path names no file.
[[nodiscard]] Status write_credential(const std::filesystem::path& path,
                                      const Credential& credential);

/// Reads a file that `write_credential` wrote. Errors: those of `read_private`; BadInput if the
/// file holds no credential.
[[nodiscard]] Result<Credential> read_credential(const std::filesystem::path& path);

/// Checks that the file can be written, before a step that cannot be repeated. Creates the file's
/// folder. Errors: BadInput if the path names no file; Io.
[[nodiscard]] Status check_can_write(const std::filesystem::path& path);
/// Writes a small file atomically, with mode 0600. Creates the file's folder. Errors: BadInput; Io.
[[nodiscard]] Status write_private(const std::filesystem::path& path, std::string_view text);
/// Reads a small file. Errors: NotFound; Io; TooLarge; Refused if other users may read the file, or
/// if its owner is neither the process's user nor root.
[[nodiscard]] Result<std::string> read_private(const std::filesystem::path& path);

/// Returns when to renew a certificate: after half of its validity. The validity begins
/// `timing::clock_difference_max` before the issue; that time does not count.
[[nodiscard]] WallTime renew_at(const Identity& identity);

} // namespace cd
