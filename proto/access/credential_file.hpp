// Credentials on disk.
#pragma once

#include "common/core/result.hpp"
#include "proto/channel/channel.hpp"
#include "proto/identity/certificate.hpp"

#include <filesystem>
#include <string>
#include <string_view>

namespace cd {

/// The file of a program's credential for this master.
[[nodiscard]] std::filesystem::path credential_path(const std::filesystem::path& folder,
                                                    const Endpoint& master);

/// Writes key, certificate and authority to one PEM file, atomically, with mode 0600. Creates its
/// folder. Errors: Io; BadInput if the path names no file.
[[nodiscard]] Status write_credential(const std::filesystem::path& path,
                                      const Credential& credential);

/// Errors: NotFound; Io; BadInput for any other content; Refused if other users may read the file.
[[nodiscard]] Result<Credential> read_credential(const std::filesystem::path& path);

/// Checks that the file can be written, before a step that cannot be repeated. Creates its folder.
/// Errors: BadInput if the path names no file; Io.
[[nodiscard]] Status check_can_write(const std::filesystem::path& path);
/// Writes a small file atomically, with mode 0600. Creates its folder. Errors: BadInput; Io.
[[nodiscard]] Status write_private(const std::filesystem::path& path, std::string_view text);
/// Errors: NotFound; Io; TooLarge; Refused if other users may read the file, or if it belongs to
/// another user than the process or root.
[[nodiscard]] Result<std::string> read_private(const std::filesystem::path& path);

/// When to renew the certificate: after half of the time for which it was issued. It also covers
/// `limits::clock_difference_max` before its issue, which does not count.
[[nodiscard]] WallTime renew_at(const Identity& identity);

} // namespace cd
