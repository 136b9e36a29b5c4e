#include "bench/accuracy/suites/pair_suite.hpp"

#include "bench/accuracy/timing.hpp"

#include <algorithm>
#include <numeric>

namespace cd::bench {

namespace {

constexpr std::uint8_t no_answer = 0xff;

/// One engine's answers on a batch, on the swapped batch, and on the reordered batch.
struct Answers {
    explicit Answers(std::size_t size) : plain(size), swapped(size), reordered(size) {
        for (const SharedArray<std::uint8_t>* each : {&plain, &swapped, &reordered}) {
            std::fill(each->values().begin(), each->values().end(), no_answer);
        }
    }

    SharedArray<std::uint8_t> plain;
    SharedArray<std::uint8_t> swapped;
    SharedArray<std::uint8_t> reordered;
};

bool is_contact(std::uint8_t answer) {
    return answer != 0;
}

PairTotals
judge(const Answers& answers, std::span<const PairClass> truth, bool tells_class, Ending ending) {
    PairTotals totals;
    totals.ending = ending;
    for (std::size_t i = 0; i < truth.size(); ++i) {
        const std::uint8_t answer = answers.plain[i];
        if (answer == no_answer) {
            ++totals.unanswered;
            continue;
        }
        const auto kind = static_cast<std::size_t>(truth[i]);
        const bool touches = truth[i] != PairClass::Separate;
        ++totals.pairs[kind];
        totals.wrong[kind] += is_contact(answer) != touches ? 1u : 0u;
        totals.wrong_class += tells_class && touches && answer != kind && answer != 0 ? 1u : 0u;
        const auto differs = [&](std::uint8_t other) {
            return other != no_answer && other != answer ? 1u : 0u;
        };
        totals.swap_differs += differs(answers.swapped[i]);
        totals.order_differs += differs(answers.reordered[i]);
    }
    return totals;
}

PairTotals ask(const Engine& engine,
               const PairBatch& batch,
               std::span<const PairClass> truth,
               const PairSuiteOptions& options) {
    const Answers answers(batch.size());
    const PairBatch swapped = batch.swapped();
    const PairBatch reordered = batch.reordered();
    const Ending ending = run_isolated(options.limit, [&] {
        const auto pairs = engine.make_pairs();
        pairs->prepare(batch.groups());
        pairs->decide(answers.plain.values());
        pairs->prepare(swapped.groups());
        pairs->decide(answers.swapped.values());
        pairs->prepare(reordered.groups());
        pairs->decide(answers.reordered.values());
    });
    return judge(answers, truth, engine.make_pairs()->tells_class(), ending);
}

/// Returns whole groups from the start with about `pairs_max` pairs in all.
std::vector<PairGroup> first_groups(const PairBatch& batch, std::size_t pairs_max) {
    std::vector<PairGroup> first;
    std::size_t pairs = 0;
    for (const PairGroup& group : batch.groups()) {
        if (pairs >= pairs_max) {
            break;
        }
        first.push_back(first_candidates(group, pairs_max - pairs));
        pairs += first.back().candidates.size();
    }
    return first;
}

/// Times the engines that neither crashed nor hung.
void time_engines(std::span<const Engine> engines,
                  const PairBatch& batch,
                  const PairSuiteOptions& options,
                  std::vector<PairTotals>& totals) {
    const PairBatch timed(first_groups(batch, options.pairs_timed));
    const SharedArray<double> seconds(engines.size());
    const auto limit = options.limit * static_cast<int>(engines.size());
    const Ending ending = run_isolated(limit, [&] {
        std::vector<std::size_t> sound;
        std::vector<std::unique_ptr<PairEngine>> prepared;
        for (std::size_t i = 0; i < engines.size(); ++i) {
            if (totals[i].ending == Ending::Done) {
                sound.push_back(i);
                prepared.push_back(engines[i].make_pairs());
                prepared.back()->prepare(timed.groups());
            }
        }
        std::vector<std::uint8_t> answers(timed.size());
        const std::vector<double> medians = interleaved_medians(
            options.rounds, prepared.size(), [&](std::size_t i) { prepared[i]->decide(answers); });
        for (std::size_t i = 0; i < sound.size(); ++i) {
            seconds[sound[i]] = medians[i] / static_cast<double>(timed.size());
        }
    });
    for (std::size_t i = 0; i < engines.size() && ending == Ending::Done; ++i) {
        totals[i].seconds_a_pair = seconds[i];
    }
}

void write_row(CsvFile& csv,
               const std::string& suite,
               const std::string& category,
               const Engine& engine,
               const PairTotals& totals) {
    std::vector<std::string> cells{suite, category, engine.name, engine.is_ours ? "yes" : "no"};
    for (const std::uint64_t pairs : totals.pairs) {
        cells.push_back(cell(pairs));
    }
    for (const std::uint64_t wrong : totals.wrong) {
        cells.push_back(cell(wrong));
    }
    for (const std::uint64_t count :
         {totals.wrong_class, totals.swap_differs, totals.order_differs, totals.unanswered}) {
        cells.push_back(cell(count));
    }
    cells.emplace_back(to_text(totals.ending));
    const bool timed = totals.seconds_a_pair > 0;
    cells.push_back(timed ? cell(1e9 * totals.seconds_a_pair) : std::string());
    csv.row(cells);
}

} // namespace

void PairTotals::add(const PairTotals& other) {
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        pairs[i] += other.pairs[i];
        wrong[i] += other.wrong[i];
    }
    wrong_class += other.wrong_class;
    swap_differs += other.swap_differs;
    order_differs += other.order_differs;
    unanswered += other.unanswered;
    ending = other.ending;
}

std::vector<PairTotals> run_category(const std::string& suite,
                                     const std::string& category,
                                     const ChunkMaker& next_chunk,
                                     std::span<const Engine> engines,
                                     const PairSuiteOptions& options,
                                     CsvFile& csv) {
    std::vector<PairTotals> totals(engines.size());
    bool is_first = true;
    for (PairBatch batch = next_chunk(); batch.size() > 0; batch = next_chunk()) {
        const std::vector<PairClass> truth = batch.truth(options.threads);
        for (std::size_t i = 0; i < engines.size(); ++i) {
            if (engines[i].make_pairs && totals[i].ending == Ending::Done) {
                totals[i].add(ask(engines[i], batch, truth, options));
            }
        }
        if (is_first && options.rounds > 0) {
            time_engines(engines, batch, options, totals);
        }
        is_first = false;
    }
    for (std::size_t i = 0; i < engines.size(); ++i) {
        write_row(csv, suite, category, engines[i], totals[i]);
    }
    return totals;
}

CsvFile open_pairs_csv(const std::filesystem::path& folder) {
    return {folder / "pairs.csv",
            {"suite",
             "category",
             "engine",
             "ours",
             "separate",
             "touch",
             "coplanar",
             "proper",
             "invented",
             "missed_touch",
             "missed_coplanar",
             "missed_proper",
             "wrong_class",
             "swap_differs",
             "order_differs",
             "unanswered",
             "ending",
             "ns_pair"}};
}

} // namespace cd::bench
