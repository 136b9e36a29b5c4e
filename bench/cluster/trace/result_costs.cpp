#include "bench/cluster/trace/result_costs.hpp"

#include "bench/cluster/cpu_clock.hpp"
#include "common/job/result/packed_records.hpp"
#include "master/journal/journal.hpp"
#include "proto/codec/codec.hpp"

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <utility>

namespace cd::bench {

namespace {

/// A worker keeps results for 50 ms: that many of about 200 us on two threads.
constexpr std::size_t results_together = 256;
constexpr JobId job{1};

/// A journal with one job; each write waits for the disk.
class Writer {
  public:
    static Result<std::unique_ptr<Writer>> open(const std::filesystem::path& folder,
                                                std::uint64_t scenarios) {
        std::filesystem::remove_all(folder);
        auto journal = Journal::open({.directory = folder, .synced = false});
        if (!journal) {
            return journal.error();
        }
        return std::unique_ptr<Writer>(new Writer(std::move(journal.value()), scenarios));
    }

    /// Returns when all results are merged and on disk.
    void write(TakenResults taken) {
        AddResults add{job, store_, {}, {}, {}};
        const std::vector<Sha256> digests = taken.results.digests();
        for (std::size_t i = 0; i < digests.size(); ++i) {
            const ResultRow& row = taken.results.rows()[i];
            static_cast<void>(merger_.add(row.scenario, row.facts, digests[i]));
        }
        add.results = std::move(taken.results);
        wait_for(journal_->add(std::move(add)));
    }

  private:
    Writer(std::unique_ptr<Journal> journal, std::uint64_t scenarios)
        : journal_(std::move(journal)), merger_(scenarios) {
        journal_->start({[this](std::uint64_t position) {
                             const std::lock_guard lock(mutex_);
                             committed_ = position;
                             changed_.notify_all();
                         },
                         [](const std::string&) {}});
        JobRecord record;
        record.id = job;
        record.submit.scenarios = scenarios;
        store_ = ResultStore::create(journal_->results_path(job), job, scenarios);
        wait_for(journal_->add(AcceptJob{record}));
    }

    void wait_for(std::uint64_t position) {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return committed_ >= position; });
    }

    std::mutex mutex_;
    std::condition_variable changed_;
    std::uint64_t committed_ = 0;
    std::unique_ptr<Journal> journal_;
    std::shared_ptr<ResultStore> store_;
    ResultMerger merger_;
};

Bytes pack(const TaskContent& task, std::span<const Bytes> records) {
    Results results;
    results.task = TaskId{1};
    results.job = task.job;
    results.count = static_cast<std::uint32_t>(records.size());
    Bytes all;
    for (const Bytes& record : records) {
        all.insert(all.end(), record.begin(), record.end());
    }
    results.records = pack_records(all);
    return encode_message(results);
}

Result<TakenResults> take(const TaskContent& task, const Bytes& payload) {
    static const std::uint16_t type = message_type(Results{});
    const Result<Message> message = decode_message(type, payload);
    if (!message) {
        return message.error();
    }
    return take_results(task, std::get<Results>(message.value()));
}

template <class Work>
double seconds_of(double (*clock)(), const Work& work) {
    const double start = clock();
    work();
    return clock() - start;
}

/// Measures every step of one message of results.
Result<ResultCosts>
cost_of_message(const TaskContent& task, std::span<const Bytes> records, Writer& writer) {
    ResultCosts costs;
    Bytes payload;
    costs.packing_seconds = seconds_of(cpu_seconds, [&] { payload = pack(task, records); });
    Result<TakenResults> taken = Error{};
    costs.intake_seconds = seconds_of(cpu_seconds, [&] { taken = take(task, payload); });
    if (!taken) {
        return taken.error();
    }
    // The master's thread merges; the journal's thread does the rest.
    costs.journal_seconds =
        seconds_of(process_cpu_seconds, [&] { writer.write(std::move(taken.value())); });
    return costs;
}

TaskContent task_of(const std::shared_ptr<const JobMaterial>& material,
                    std::span<const Analysis> analyses) {
    TaskContent task;
    task.job = job;
    task.material = material;
    for (const Analysis& analysis : analyses) {
        task.analyses.push_back(std::make_shared<const Analysis>(analysis));
    }
    return task;
}

Result<ResultCosts> one_pass(const std::shared_ptr<const JobMaterial>& material,
                             std::span<const Analysis> analyses,
                             std::span<const Bytes> records,
                             Writer& writer) {
    ResultCosts sum;
    for (std::size_t begin = 0; begin < records.size(); begin += results_together) {
        const std::size_t count = std::min(results_together, records.size() - begin);
        const TaskContent task = task_of(material, analyses.subspan(begin, count));
        const auto costs = cost_of_message(task, records.subspan(begin, count), writer);
        if (!costs) {
            return costs.error();
        }
        sum.packing_seconds += costs.value().packing_seconds;
        sum.intake_seconds += costs.value().intake_seconds;
        sum.journal_seconds += costs.value().journal_seconds;
    }
    return sum;
}

double median(std::vector<double> values) {
    std::ranges::sort(values);
    return values[values.size() / 2];
}

} // namespace

Result<ResultCosts> measure_result_costs(const std::shared_ptr<const JobMaterial>& material,
                                         std::span<const Analysis> analyses,
                                         std::span<const Bytes> records,
                                         const std::filesystem::path& folder,
                                         unsigned passes) {
    std::vector<double> packing;
    std::vector<double> intake;
    std::vector<double> journal;
    for (unsigned pass = 0; pass < passes; ++pass) {
        auto writer = Writer::open(folder, records.size());
        if (!writer) {
            return writer.error();
        }
        const auto costs = one_pass(material, analyses, records, *writer.value());
        if (!costs) {
            return costs.error();
        }
        packing.push_back(costs.value().packing_seconds);
        intake.push_back(costs.value().intake_seconds);
        journal.push_back(costs.value().journal_seconds);
    }
    const auto count = static_cast<double>(std::max<std::size_t>(records.size(), 1));
    return ResultCosts{median(packing) / count, median(intake) / count, median(journal) / count};
}

} // namespace cd::bench
