// cdctl: the user's command line program.
#include "client/base/heap.hpp"
#include "client/base/standard_output.hpp"
#include "client/cli/cli.hpp"
#include "client/commands/commands.hpp"
#include "client/commands/remote_commands.hpp"
#include "common/core/host/log.hpp"

#include <cstdio>
#include <exception>
#include <new>

int main(int argc, char** argv) {
    try {
        cd::keep_heap_small();
        cd::start_logging("cdctl", "warning"); // Programs read stdout, so it gets no log.
        const cd::CommandLine line = cd::parse_command_line({argv + 1, argv + argc});
        if (!line.command) {
            std::fputs(line.text.c_str(), line.exit_code == 0 ? stdout : stderr);
            return cd::finish_standard_output(line.exit_code);
        }
        return cd::finish_standard_output(
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
