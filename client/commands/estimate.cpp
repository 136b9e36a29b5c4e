#include "client/commands/estimate.hpp"

#include "client/base/temporary_folder.hpp"
#include "client/export/result_sink.hpp"
#include "client/folder/folder_run.hpp"
#include "client/folder/run_recorder.hpp"
#include "client/local/done_scenario.hpp"
#include "common/core/errors.hpp"
#include "common/core/limits/client.hpp"
#include "common/core/words.hpp"
#include "common/job/run_scenario.hpp"
#include "common/job/scenario_file.hpp"
#include "web/status/table.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>
#include <optional>
#include <random>
#include <variant>
#include <vector>

namespace cd {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

/// Samples are run again until they have taken this much thread time, to measure warm caches.
constexpr double warm_seconds = 0.02;
constexpr int passes_max = 8;
/// Bounds the pairs of samples, whose results stay in memory until they are written.
constexpr std::uint64_t sampled_pairs_max = 4'000'000;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Divides [0, count) into `samples` equal parts and draws a random index from each. Equal steps
/// would meet a few values of a grid's axes again and again.
std::vector<std::uint64_t> spread(std::uint64_t count, std::uint64_t samples) {
    const std::uint64_t size = std::min(count, samples);
    std::mt19937_64 random; // The default seed makes estimates repeatable.
    std::vector<std::uint64_t> indices(size);
    std::uint64_t begin = 0;
    for (std::uint64_t i = 0; i < size; ++i) {
        const std::uint64_t end = begin + (count - begin) / (size - i);
        indices[i] = begin + random() % (end - begin);
        begin = end;
    }
    return indices;
}

struct Sample {
    Scenario scenario;
    std::optional<DoneScenario> done; ///< Nothing if the time ran out before the sample.
    QueryStatistics work;
    double seconds = 0; ///< Time on one thread.
};

/// Orders samples with a stride, so that the ones run before the time limit cover the whole job.
std::vector<std::size_t> visiting_order(std::size_t size) {
    constexpr std::size_t stride = 16;
    std::vector<std::size_t> order;
    for (std::size_t first = 0; first < stride; ++first) {
        for (std::size_t i = first; i < size; i += stride) {
            order.push_back(i);
        }
    }
    return order;
}

/// Runs each sample once on the pool's threads, until `end` or until the samples have
/// `sampled_pairs_max` pairs, but at least one sample.
void run_samples(const ScenarioRunner& runner,
                 ThreadPool& pool,
                 Clock::time_point end,
                 std::vector<Sample>& samples) {
    const std::vector<std::size_t> order = visiting_order(samples.size());
    std::atomic<std::size_t> next = 0;
    std::atomic<std::uint64_t> pairs = 0;
    parallel_for(pool, pool.size(), [&](std::size_t) {
        ScenarioSession session(runner);
        for (std::size_t i = next++; i < order.size(); i = next++) {
            Sample& sample = samples[order[i]];
            const auto start = Clock::now();
            if (i != 0 && (start >= end || pairs >= sampled_pairs_max)) {
                return;
            }
            ScenarioRun run = session.run(sample.scenario);
            DoneScenario done = done_scenario(std::move(run.result), std::move(run.found));
            sample.seconds = seconds_since(start);
            sample.work = run.statistics;
            pairs += done.result.pairs.size();
            if (!run.is_stopped) {
                sample.done = std::move(done);
            }
        }
    });
}

double sum_of(const std::vector<Sample>& samples) {
    return std::accumulate(samples.begin(),
                           samples.end(),
                           0.0,
                           [](double sum, const Sample& sample) { return sum + sample.seconds; });
}

/// Sizes in bytes of the files in a results folder.
struct FolderBytes {
    std::uint64_t scenarios = 0; ///< Size of files that grow with the scenarios.
    std::uint64_t maps = 0;      ///< Size of files that grow with what is in contact.
};

/// Writes the samples' results as a run does: records and exports.
Status
write_results(const PreparedJob& job, const std::vector<Sample>& samples, const fs::path& folder) {
    auto sink =
        CD_TRY(ResultSink::open({folder, job.spec.output.formats, "text"}, export_context(job)));
    auto recorder = CD_TRY(RunRecorder::open(
        folder, job.query.maps ? body_part_runs(*job.meshes[0], *job.meshes[1]) : nullptr));
    for (const Sample& sample : samples) {
        CD_TRY(sink.add(sample.done->result, sample.done->found));
        CD_TRY(recorder.add(*sample.done));
    }
    CD_TRY(recorder.finish());
    return sink.finish(sink.map());
}

Status write_poses(const std::vector<Sample>& samples, const fs::path& folder) {
    std::vector<Scenario> scenarios;
    for (const Sample& sample : samples) {
        scenarios.push_back(sample.scenario);
        scenarios.back().index = scenarios.size() - 1;
    }
    auto writer = CD_TRY(ScenarioWriter::create(folder / "scenarios"));
    CD_TRY(writer.add(scenarios));
    return writer.finish();
}

/// Returns the file sizes of a run with only these samples: records, exports and kept poses.
Result<FolderBytes>
bytes_of(const PreparedJob& job, bool keeps_inputs, const std::vector<Sample>& samples) {
    const auto folder = CD_TRY(TemporaryFolder::make("cdctl-estimate"));
    CD_TRY(write_results(job, samples, folder.path()));
    if (keeps_inputs && !job.grid) {
        CD_TRY(write_poses(samples, folder.path()));
    }
    FolderBytes bytes;
    for (const auto& entry : fs::recursive_directory_iterator(folder.path())) {
        const std::string name = entry.path().filename().string();
        const bool is_map = name.starts_with("map") || name == "groups.csv";
        (is_map ? bytes.maps : bytes.scenarios) += entry.file_size();
    }
    return bytes;
}

/// Counts the triangles of both bodies that are in contact in every `step`-th sample.
double triangles_touched(const std::vector<Sample>& samples, std::size_t step) {
    ContactMapSum sum;
    for (std::size_t i = 0; i < samples.size(); i += step) {
        const DoneScenario& done = *samples[i].done;
        sum.add(done.found.empty() ? done.result.pairs : done.found);
    }
    const ContactMap map = sum.take();
    return static_cast<double>(map.bodies[0].size() + map.bodies[1].size());
}

/// Returns how many times more triangles are in contact in the whole job than in the samples.
/// Assumes that their number grows as a power of the number of scenarios, with the exponent between
/// half of the samples and all samples, up to the number of triangles of both meshes.
double triangles_factor(const PreparedJob& job, const std::vector<Sample>& samples) {
    const double all = triangles_touched(samples, 1);
    const double some = triangles_touched(samples, 2);
    if (all == 0 || some == 0) {
        return 1;
    }
    const auto most =
        static_cast<double>(job.meshes[0]->triangles().size() + job.meshes[1]->triangles().size());
    const double times =
        static_cast<double>(job.poses->count()) / static_cast<double>(samples.size());
    return std::min(std::pow(times, std::log2(std::max(1.0, all / some))), most / all);
}

/// Reads samples, ascending by index: as many as possible before `end`, but at least one. Errors:
/// from reading `poses`.
Result<std::vector<Sample>>
read_samples(PoseSource& poses, std::uint64_t samples_max, Clock::time_point end) {
    const std::vector<std::uint64_t> indices = spread(poses.count(), samples_max);
    std::vector<Sample> samples;
    for (const std::size_t place : visiting_order(indices.size())) {
        if (!samples.empty() && Clock::now() >= end) {
            break;
        }
        auto read = CD_TRY(poses.read(indices[place], 1));
        samples.push_back({std::move(read.front()), {}, {}, 0});
    }
    std::ranges::sort(samples, {}, [](const Sample& sample) { return sample.scenario.index; });
    return samples;
}

/// Extrapolates the samples' times to the job, with a range of two standard errors. The threads
/// share the samples' time, but not `more_per_scenario`, the seconds to read and write a scenario.
void put_times(const std::vector<Sample>& samples,
               double more_per_scenario,
               unsigned threads,
               RunEstimate& estimate) {
    const auto count = static_cast<double>(samples.size());
    const double mean = sum_of(samples) / count;
    double squares = 0;
    for (const Sample& sample : samples) {
        squares += (sample.seconds - mean) * (sample.seconds - mean);
    }
    const double error = samples.size() < 2 ? mean : std::sqrt(squares / (count - 1) / count);
    const auto seconds = [&](double per_sample) {
        return static_cast<double>(estimate.scenarios) * (per_sample / threads + more_per_scenario);
    };
    estimate.seconds = seconds(mean);
    estimate.seconds_low = seconds(std::max(0.0, mean - 2 * error));
    estimate.seconds_high = seconds(mean + 2 * error);
}

/// Extrapolates box and triangle tests to the whole job.
void put_work(const std::vector<Sample>& samples, RunEstimate& estimate) {
    const auto count = static_cast<double>(samples.size());
    const double times = static_cast<double>(estimate.scenarios) / count;
    for (const Sample& sample : samples) {
        estimate.box_tests += times * static_cast<double>(sample.work.box_tests);
        estimate.triangle_tests += times * static_cast<double>(sample.work.triangle_tests);
    }
}

/// Extrapolates the size of the results folder. Returns the seconds that writing a scenario takes.
Result<double> put_bytes(const PreparedJob& job,
                         const EstimateOptions& options,
                         const std::vector<Sample>& samples,
                         RunEstimate& estimate) {
    const bool keeps_inputs =
        options.keeps_inputs && input_bytes(job) <= limits::run_inputs_bytes_max;
    const auto base_start = Clock::now();
    const FolderBytes base = CD_TRY(bytes_of(job, keeps_inputs, {}));
    const double base_seconds = seconds_since(base_start);
    const auto start = Clock::now();
    const FolderBytes bytes = CD_TRY(bytes_of(job, keeps_inputs, samples));
    const double seconds = seconds_since(start);
    const auto size = static_cast<double>(samples.size());
    const auto more = [](std::uint64_t with, std::uint64_t without) {
        return static_cast<double>(with - std::min(with, without));
    };
    const double times = static_cast<double>(estimate.scenarios) / size;
    const double grown = times * more(bytes.scenarios, base.scenarios) +
                         triangles_factor(job, samples) * more(bytes.maps, base.maps);
    estimate.bytes = base.scenarios + base.maps + (keeps_inputs ? bytes_beside_poses(job) : 0) +
                     static_cast<std::uint64_t>(grown);
    // Returns seconds per scenario, without `base_seconds`, the time of an empty run, which syncs
    // each file once and does not grow with the number of scenarios.
    return std::max(0.0, seconds - base_seconds) / size;
}

std::string size_text(std::uint64_t bytes) {
    const auto size = static_cast<double>(bytes);
    if (bytes < 50'000'000) {
        return fixed_text(size / 1e6, 1) + " MB";
    }
    return fixed_text(size / 1e9, size < 10e9 ? 1 : 0) + " GB";
}

/// Formats seconds without a unit, with at most two decimals.
std::string seconds_text(double seconds) {
    return fixed_text(seconds, seconds < 1 ? 2 : seconds < 10 ? 1 : 0);
}

std::uint64_t free_bytes_near(fs::path folder) {
    std::error_code error;
    folder = fs::absolute(folder, error);
    while (!fs::exists(folder, error) && folder.has_relative_path()) {
        folder = folder.parent_path();
    }
    const fs::space_info space = fs::space(folder, error);
    return error ? UINT64_MAX : space.available;
}

} // namespace

Result<RunEstimate>
estimate_run(const PreparedJob& job, ThreadPool& pool, const EstimateOptions& options) {
    const auto start = Clock::now();
    auto read = CD_TRY(read_samples(*job.poses, options.samples_max, start + options.time_max / 2));
    std::vector<Sample>& samples = read;
    RunEstimate estimate;
    estimate.scenarios = job.poses->count();
    // Random poses are generated on all threads; other poses are read on one thread.
    const bool is_random = std::holds_alternative<RandomPoses>(job.spec.poses);
    const auto reads = static_cast<double>(samples.size() * (is_random ? pool.size() : 1));
    const double read_seconds = seconds_since(start) / reads;

    const auto end = start + options.time_max;
    const ScenarioRunner runner(TreesByBody(job.trees), job.query, options.first_stage);
    double spent = 0;
    for (int pass = 0; pass < passes_max && spent < warm_seconds; ++pass) {
        run_samples(runner, pool, pass == 0 ? end : Clock::time_point::max(), samples);
        std::erase_if(samples, [](const Sample& sample) { return !sample.done; });
        spent += sum_of(samples);
    }
    estimate.sampled = samples.size();
    double write_seconds = 0;
    if (!job.spec.output.dir.empty()) {
        const auto written = CD_TRY(put_bytes(job, options, samples, estimate));
        write_seconds = written;
    }
    put_work(samples, estimate);
    put_times(samples, read_seconds + write_seconds, pool.size(), estimate);
    return estimate;
}

std::string estimate_text(const RunEstimate& estimate) {
    const auto rate = [&](double seconds) {
        return static_cast<double>(estimate.scenarios) / std::max(seconds, 1e-9);
    };
    const bool is_narrow = estimate.seconds_high < 1.5 * std::max(estimate.seconds_low, 1e-9);
    const std::string time =
        is_narrow
            ? seconds_text(estimate.seconds) + " s here (" + rate_text(rate(estimate.seconds))
            : seconds_text(estimate.seconds_low) + " to " + seconds_text(estimate.seconds_high) +
                  " s here (" + rate_text(rate(estimate.seconds));
    return "about " + time + "/s)" + (estimate.bytes == 0 ? "" : ", " + size_text(estimate.bytes));
}

std::string estimate_json(const RunEstimate& estimate, const Status& room) {
    const nlohmann::ordered_json json{
        {"scenarios", estimate.scenarios},
        {"sampled", estimate.sampled},
        {"seconds",
         {{"low", estimate.seconds_low},
          {"expected", estimate.seconds},
          {"high", estimate.seconds_high}}},
        {"scenarios_per_second",
         static_cast<double>(estimate.scenarios) / std::max(estimate.seconds, 1e-9)},
        {"box_tests", std::round(estimate.box_tests)},
        {"triangle_tests", std::round(estimate.triangle_tests)},
        {"bytes", estimate.bytes},
        {"refused", room ? nlohmann::ordered_json() : nlohmann::ordered_json(room.error().detail)}};
    return json_text(json);
}

Status check_room(const RunEstimate& estimate, const OutputSpec& output, std::uint64_t bytes_max) {
    const std::uint64_t free = free_bytes_near(output.dir);
    if (estimate.bytes <= std::min(bytes_max, free / 2)) {
        return Done{};
    }
    std::string formats;
    for (const std::string& format : output.formats) {
        formats += (formats.empty() ? "" : ",") + format;
    }
    return bad_input(output.dir.string() + ": the run would take " + estimate_text(estimate) +
                     " as " + formats + ", and " + size_text(free) +
                     " are free; choose other --formats, a lower --level or --limit-pairs, or say "
                     "--yes");
}

} // namespace cd
