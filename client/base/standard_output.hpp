// Reports standard output that could not be written, for example to a full disk.
#pragma once

namespace cd {

/// Flushes stdout and returns `code`. If a verb succeeded but not all of its output could be
/// written, prints a line on stderr and returns `exit_incomplete`.
[[nodiscard]] int finish_standard_output(int code);

} // namespace cd
