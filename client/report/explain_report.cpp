#include "client/report/explain_report.hpp"

#include "common/core/words.hpp"
#include "web/status/table.hpp"

#include <nlohmann/json.hpp>

#include <functional>

namespace cd {

namespace {

double total(const WorkerScore& score) {
    return score.backlog + score.coming + score.transfer + score.blocks + score.eviction +
           score.work;
}

std::string worker_name(const WorkerScore& score) {
    return "w-" + std::to_string(score.worker.value);
}

Table score_table(const Explained& explained) {
    using enum CellKind;
    using Score = WorkerScore;
    TableOf<Score> table(explained.workers);
    table.add("worker", "WORKER", Text, worker_name);
    table.add("name", "NAME", Text, &Score::name);
    const auto add_milliseconds = [&](const char* key, const char* title, auto seconds) {
        table.add(key, title, Text, [seconds](const Score& score) {
            return fixed_text(1e3 * std::invoke(seconds, score), 3);
        });
    };
    if (explained.is_by_time) {
        add_milliseconds("backlog", "BACKLOG", &Score::backlog);
        add_milliseconds("coming", "COMING", &Score::coming);
        add_milliseconds("transfer", "TRANSFER", &Score::transfer);
        add_milliseconds("blocks", "BLOCKS", &Score::blocks);
        add_milliseconds("eviction", "EVICTION", &Score::eviction);
        add_milliseconds("work", "WORK", &Score::work);
        add_milliseconds("total", "TOTAL MS", total);
    } else {
        table.add("held", "HELD", Count, &Score::held_triangles);
        table.add("missing", "MISSING", Count, &Score::missing_triangles);
        table.add("load", "LOAD", Share, &Score::load);
        table.add("scenarios", "SCENARIOS", Count, &Score::scenarios);
    }
    table.add("chosen", "", Text, [](const Score& score) {
        return score.is_chosen ? "chosen" : score.may_take ? "" : "takes none";
    });
    return table.take();
}

nlohmann::ordered_json score_json(const WorkerScore& score, bool by_time) {
    nlohmann::ordered_json entry{{"worker", worker_name(score)},
                                 {"name", score.name},
                                 {"chosen", score.is_chosen},
                                 {"may_take", score.may_take},
                                 {"scenarios", score.scenarios},
                                 {"load", score.load},
                                 {"held_triangles", score.held_triangles},
                                 {"missing_triangles", score.missing_triangles}};
    if (by_time) {
        entry["backlog_ms"] = 1e3 * score.backlog;
        entry["coming_ms"] = 1e3 * score.coming;
        entry["transfer_ms"] = 1e3 * score.transfer;
        entry["blocks_ms"] = 1e3 * score.blocks;
        entry["eviction_ms"] = 1e3 * score.eviction;
        entry["work_ms"] = 1e3 * score.work;
        entry["total_ms"] = 1e3 * total(score);
    }
    return entry;
}

std::string effort_text(const SearchEffort& effort) {
    if (effort.cells != 0) {
        return "  tests       " + counted(effort.cells, "cell") + " of time, " +
               grouped(effort.leaves) + " of them leaves\n";
    }
    return "  needs       " + grouped(effort.roots_used) + " of " +
           counted(effort.roots_named, "pair") + " of roots that may have the distance\n";
}

nlohmann::ordered_json effort_json(const SearchEffort& effort) {
    if (effort.cells != 0) {
        return {{"cells", effort.cells}, {"leaves", effort.leaves}};
    }
    return {{"roots_named", effort.roots_named}, {"roots_used", effort.roots_used}};
}

} // namespace

std::string explained_text(const Explained& explained, const std::string& job) {
    std::string text = "scenario " + std::to_string(explained.scenario) + " of " + job + ", " +
                       explained.strategy + "\n";
    const bool is_scored = !explained.why.empty(); // The job has ended if `why` is empty.
    text += !is_scored ? ""
                       : "  touches     " + std::to_string(explained.roots_a) + " roots of A, " +
                             std::to_string(explained.roots_b) + " of B\n";
    text += !explained.effort ? "" : effort_text(*explained.effort);
    text += "  is          " + explained.where + "\n";
    text += !is_scored ? "" : "  now chosen  " + explained.why + "\n";
    text += explained.note.empty() ? "" : "  note        " + explained.note + "\n";
    if (!explained.workers.empty()) {
        text += table_text(score_table(explained), false, "  ");
    }
    return text;
}

std::string explained_json(const Explained& explained, const std::string& job) {
    nlohmann::ordered_json document{{"job", job},
                                    {"scenario", explained.scenario},
                                    {"strategy", explained.strategy},
                                    {"where", explained.where},
                                    {"why", explained.why},
                                    {"note", explained.note}};
    if (!explained.why.empty()) { // The job has not ended.
        document["roots_a"] = explained.roots_a;
        document["roots_b"] = explained.roots_b;
    }
    if (explained.effort) {
        document["effort"] = effort_json(*explained.effort);
    }
    document["workers"] = nlohmann::ordered_json::array();
    for (const WorkerScore& score : explained.workers) {
        document["workers"].push_back(score_json(score, explained.is_by_time));
    }
    return json_text(document);
}

} // namespace cd
