#include "client/commands/run_at_hand.hpp"

#include "client/commands/fetched_job.hpp"
#include "client/commands/run_command.hpp"

#include <cstdlib>
#include <system_error>

namespace cd {

namespace {

void remove_folder(const std::filesystem::path& folder) {
    std::error_code ignored;
    if (!folder.empty()) {
        std::filesystem::remove_all(folder, ignored);
    }
}

Status
fetch_into(const std::filesystem::path& dir, const std::string& id, const MasterOptions& master) {
    auto job = FetchedJob::open(master, id);
    if (!job) {
        return job.error();
    }
    job.value().prepared().spec.output.dir = dir;
    job.value().prepared().spec.output.formats.clear();
    const auto written = job.value().write(folder_options({}, master), "text");
    return written ? Status(Done{}) : written.error();
}

} // namespace

Result<RunAtHand> RunAtHand::open(const std::string& argument, const MasterOptions& master) {
    if (is_folder(argument)) {
        auto run = OpenedRun::open(argument);
        return run ? Result<RunAtHand>(RunAtHand(std::move(run.value()), {})) : run.error();
    }
    std::string name = (std::filesystem::temp_directory_path() / "cdctl-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) {
        return Error{ErrorCode::Io, "cannot create " + name};
    }
    const Status fetched = fetch_into(name, argument, master);
    auto run = fetched ? OpenedRun::open(name) : Result<OpenedRun>(fetched.error());
    if (!run) {
        remove_folder(name);
        return run.error();
    }
    return RunAtHand(std::move(run.value()), name);
}

RunAtHand::~RunAtHand() {
    remove_folder(temporary_);
}

} // namespace cd
