// cdmaster: accepts jobs from clients and distributes them to workers.
#include "common/core/host/log.hpp"
#include "common/core/host/log_style.hpp"
#include "master/check_state.hpp"
#include "master/config.hpp"
#include "master/run_master.hpp"

#include <cstdio>

int main(int count, char** arguments) {
    const cd::MasterCommandLine line = cd::parse_master_command_line(count, arguments);
    if (!line.config) {
        std::fputs(line.text.c_str(), line.exit_code == 0 ? stdout : stderr);
        return line.exit_code;
    }
    if (line.config->check) {
        const cd::StateReport report = cd::check_state(line.config->state);
        for (const std::string& text : report.lines) {
            std::puts(text.c_str());
        }
        return report.is_sound ? 0 : 2;
    }
    cd::start_logging("cdmaster", line.config->log);
    const cd::Status status =
        line.config->init ? cd::init_master(*line.config) : cd::run_master(*line.config);
    if (!status) {
        if (line.config->log.format == "json") {
            cd::log_critical("cannot run: error=\"{}\"", status.error().detail);
        } else {
            std::fprintf(stderr, "cdmaster: %s\n", status.error().detail.c_str());
        }
        return status.error().code == cd::ErrorCode::Refused ? 5 : 2;
    }
    return 0;
}
