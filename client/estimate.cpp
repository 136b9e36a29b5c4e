#include "client/estimate.hpp"

#include "client/words.hpp"
#include "common/job/run_scenario.hpp"

#include <nlohmann/json.hpp>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>
#include <optional>
#include <vector>

namespace cd {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr std::uint64_t bytes_without_a_word = 1'000'000'000;
/// Samples that take microseconds are run again until so much time has passed: then they are warm.
constexpr double warm_seconds = 0.02;
constexpr int passes_max = 8;
/// Results of samples are kept until they are written, so their pairs are bounded.
constexpr std::uint64_t sampled_pairs_max = 4'000'000;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Evenly spread over [0, count), ascending, each once.
std::vector<std::uint64_t> spread(std::uint64_t count, std::uint64_t samples) {
    const std::uint64_t size = std::min(count, samples);
    std::vector<std::uint64_t> indices(size);
    for (std::uint64_t i = 0; i < size; ++i) {
        const double place = (static_cast<double>(i) + 0.5) / static_cast<double>(size);
        indices[i] =
            std::min(count - 1, static_cast<std::uint64_t>(place * static_cast<double>(count)));
    }
    return indices;
}

struct Sample {
    Scenario scenario;
    std::optional<ScenarioResult> result; ///< Nothing where time was over before.
    double seconds = 0;                   ///< Of one thread.
};

/// With a stride, so that the samples that were run when time is over are spread over the job.
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

/// Runs each sample once on the pool's threads, as a run would.
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
            if (start >= end || pairs >= sampled_pairs_max) {
                return;
            }
            ScenarioRun run = session.run(sample.scenario);
            (void)digest_of(run.result);
            sample.seconds = seconds_since(start);
            pairs += run.result.pairs.size();
            if (!run.is_stopped) {
                sample.result = std::move(run.result);
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

/// A folder that is gone with the object.
class TemporaryFiles {
  public:
    TemporaryFiles()
        : folder_(fs::temp_directory_path() / ("cdctl-estimate-" + std::to_string(::getpid()))) {}
    TemporaryFiles(const TemporaryFiles&) = delete;
    TemporaryFiles& operator=(const TemporaryFiles&) = delete;
    ~TemporaryFiles() {
        std::error_code ignored;
        fs::remove_all(folder_, ignored);
    }

    /// Bytes of the files that these results make in the job's formats.
    Result<std::uint64_t> write(const PreparedJob& job, const std::vector<Sample>& samples) {
        auto files = ResultFiles::open(folder_, job.spec.output.formats, export_context(job));
        if (!files) {
            return files.error();
        }
        for (const Sample& sample : samples) {
            if (Status added = files.value().add(*sample.result); !added) {
                return added.error();
            }
        }
        if (Status finished = files.value().finish({}); !finished) {
            return finished.error();
        }
        std::uint64_t bytes = 0;
        for (const auto& entry : fs::recursive_directory_iterator(folder_)) {
            bytes += entry.is_regular_file() ? entry.file_size() : 0;
        }
        return bytes;
    }

  private:
    fs::path folder_;
};

/// Errors: those of the poses.
Result<std::vector<Sample>> read_samples(PoseSource& poses, std::uint64_t samples_max) {
    std::vector<Sample> samples;
    for (const std::uint64_t index : spread(poses.count(), samples_max)) {
        auto read = poses.read(index, 1);
        if (!read) {
            return read.error();
        }
        samples.push_back({std::move(read.value().front()), {}, 0});
    }
    return samples;
}

/// The seconds that samples of these times stand for, and their range.
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
    const double scale = static_cast<double>(estimate.scenarios) / threads;
    estimate.seconds = scale * (mean + more_per_scenario);
    estimate.seconds_low = scale * (std::max(0.0, mean - 2 * error) + more_per_scenario);
    estimate.seconds_high = scale * (mean + 2 * error + more_per_scenario);
}

std::string size_text(std::uint64_t bytes) {
    const auto size = static_cast<double>(bytes);
    if (bytes < 50'000'000) {
        return fixed_text(size / 1e6, 1) + " MB";
    }
    return fixed_text(size / 1e9, size < 10e9 ? 1 : 0) + " GB";
}

/// Without a unit.
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
    auto read = read_samples(*job.poses, options.samples_max);
    if (!read) {
        return read.error();
    }
    std::vector<Sample>& samples = read.value();
    RunEstimate estimate;
    estimate.scenarios = job.poses->count();
    const double read_seconds = seconds_since(start) / static_cast<double>(samples.size());

    const auto end = start + options.time_max;
    const ScenarioRunner runner(*job.trees[0], *job.trees[1], job.query, options.first_stage);
    double spent = 0;
    for (int pass = 0; pass < passes_max && spent < warm_seconds; ++pass) {
        run_samples(runner, pool, pass == 0 ? end : Clock::time_point::max(), samples);
        std::erase_if(samples, [](const Sample& sample) { return !sample.result; });
        spent += sum_of(samples);
    }
    estimate.sampled = samples.size();
    if (samples.empty()) {
        return Error{ErrorCode::BadInput,
                     "a scenario takes longer than " +
                         seconds_text(std::chrono::duration<double>(options.time_max).count()) +
                         " s, so the run cannot be estimated"};
    }
    double write_seconds = 0;
    if (!job.spec.output.dir.empty()) {
        TemporaryFiles empty;
        const auto base = empty.write(job, {});
        if (!base) {
            return base.error();
        }
        const auto write_start = Clock::now();
        const auto bytes = empty.write(job, samples);
        if (!bytes) {
            return bytes.error();
        }
        // Each file is synchronised to the disk once a run, not once a scenario.
        write_seconds = std::max(0.0, seconds_since(write_start) - 0.05);
        const double per_scenario =
            static_cast<double>(bytes.value() - std::min(bytes.value(), base.value())) /
            static_cast<double>(samples.size());
        estimate.bytes = base.value() + static_cast<std::uint64_t>(
                                            per_scenario * static_cast<double>(estimate.scenarios));
    }
    put_times(samples,
              read_seconds + write_seconds / static_cast<double>(samples.size()),
              pool.size(),
              estimate);
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

std::string estimate_json(const RunEstimate& estimate) {
    const nlohmann::ordered_json json{
        {"scenarios", estimate.scenarios},
        {"sampled", estimate.sampled},
        {"seconds",
         {{"low", estimate.seconds_low},
          {"expected", estimate.seconds},
          {"high", estimate.seconds_high}}},
        {"scenarios_per_second",
         static_cast<double>(estimate.scenarios) / std::max(estimate.seconds, 1e-9)},
        {"bytes", estimate.bytes}};
    return json.dump(2) + "\n";
}

Status check_room(const RunEstimate& estimate, const OutputSpec& output) {
    const std::uint64_t free = free_bytes_near(output.dir);
    if (estimate.bytes <= std::min(bytes_without_a_word, free / 2)) {
        return Done{};
    }
    std::string formats;
    for (const std::string& format : output.formats) {
        formats += (formats.empty() ? "" : ",") + format;
    }
    return Error{ErrorCode::BadInput,
                 output.dir.string() + ": the results would take about " +
                     size_text(estimate.bytes) + " as " + formats + ", and " + size_text(free) +
                     " are free; choose other --formats, a lower --level or --limit-pairs, or say "
                     "--yes"};
}

} // namespace cd
