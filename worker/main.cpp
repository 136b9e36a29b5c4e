// cdworker: runs the collision tests that a master assigns.
#include "common/core/host/log_style.hpp"
#include "worker/config.hpp"
#include "worker/run_worker.hpp"

#include <cstdio>

int main(int count, char** arguments) {
    const cd::WorkerCommandLine line = cd::parse_worker_command_line(count, arguments);
    if (!line.config) {
        std::fputs(line.text.c_str(), line.exit_code == 0 ? stdout : stderr);
        return line.exit_code;
    }
    cd::start_logging("cdworker", line.config->log);
    return line.config->join ? cd::join_as_worker(*line.config) : cd::run_worker(*line.config);
}
