// cdctl: the user's command line program.
#include "client/base/exit_code.hpp"
#include "client/base/heap.hpp"
#include "client/cli/cli.hpp"
#include "client/commands/commands.hpp"
#include "common/core/host/log.hpp"

#include <cstdio>
#include <exception>
#include <new>

namespace {

/// Flushes stdout and returns `code`. If `code` says that a verb succeeded but not all of its
/// output could be written, prints a line on stderr and returns `exit_incomplete`.
int finish_standard_output(int code) {
    const bool is_written = std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
    if (is_written || (code != cd::exit_done && code != cd::exit_contacts)) {
        return code;
    }
    std::fputs("cdctl: standard output: not all could be written; is its disk full, or its reader "
               "gone?\n",
               stderr);
    return cd::exit_incomplete;
}

} // namespace

int main(int argc, char** argv) {
    try {
        cd::return_freed_memory();
        cd::start_logging("cdctl", "warning"); // No log goes to stdout, which programs read.
        const cd::CommandLine line = cd::parse_command_line({argv + 1, argv + argc});
        if (!line.command) {
            std::fputs(line.text.c_str(), line.exit_code == 0 ? stdout : stderr);
            return finish_standard_output(line.exit_code);
        }
        return finish_standard_output(
            std::visit([](const auto& command) { return cd::execute(command); }, *line.command));
    } catch (const std::bad_alloc&) {
        std::fputs("cdctl: out of memory; it takes a smaller mesh, fewer --threads or a larger "
                   "machine\n",
                   stderr);
        return 2;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "cdctl: %s\n", error.what());
        return 2;
    }
}
