// Reports standard output that could not be written, for example to a full disk.
#pragma once

namespace cd {

/// Flushes stdout. Returns `code`, or where a verb that succeeded could not write all, a line on
/// stderr and `exit_incomplete`.
[[nodiscard]] int finish_standard_output(int code);

} // namespace cd
