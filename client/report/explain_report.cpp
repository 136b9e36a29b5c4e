#include "client/report/explain_report.hpp"

#include "client/base/table.hpp"

#include <nlohmann/json.hpp>

#include <array>
#include <cstdio>

namespace cd {

namespace {

std::string milliseconds(double seconds) {
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "%.3f", 1e3 * seconds);
    return text.data();
}

double total(const WorkerScore& score) {
    return score.backlog + score.coming + score.transfer + score.blocks + score.eviction +
           score.work;
}

Table table_by_triangles(const Explained& explained) {
    Table table;
    table.columns = {{"worker", "WORKER", CellKind::Text},
                     {"name", "NAME", CellKind::Text},
                     {"held", "HELD", CellKind::Count},
                     {"missing", "MISSING", CellKind::Count},
                     {"load", "LOAD", CellKind::Share},
                     {"scenarios", "SCENARIOS", CellKind::Count},
                     {"chosen", "", CellKind::Text}};
    for (const WorkerScore& score : explained.workers) {
        table.rows.push_back({"w-" + std::to_string(score.worker.value),
                              score.name,
                              score.held_triangles,
                              score.missing_triangles,
                              score.load,
                              score.scenarios,
                              score.is_chosen ? "chosen" : (score.may_take ? "" : "takes none")});
    }
    return table;
}

Table table_by_time(const Explained& explained) {
    Table table;
    table.columns = {{"worker", "WORKER", CellKind::Text},
                     {"name", "NAME", CellKind::Text},
                     {"backlog", "BACKLOG", CellKind::Text},
                     {"coming", "COMING", CellKind::Text},
                     {"transfer", "TRANSFER", CellKind::Text},
                     {"blocks", "BLOCKS", CellKind::Text},
                     {"eviction", "EVICTION", CellKind::Text},
                     {"work", "WORK", CellKind::Text},
                     {"total", "TOTAL MS", CellKind::Text},
                     {"chosen", "", CellKind::Text}};
    for (const WorkerScore& score : explained.workers) {
        table.rows.push_back({"w-" + std::to_string(score.worker.value),
                              score.name,
                              milliseconds(score.backlog),
                              milliseconds(score.coming),
                              milliseconds(score.transfer),
                              milliseconds(score.blocks),
                              milliseconds(score.eviction),
                              milliseconds(score.work),
                              milliseconds(total(score)),
                              score.is_chosen ? "chosen" : (score.may_take ? "" : "takes none")});
    }
    return table;
}

nlohmann::ordered_json score_json(const WorkerScore& score, bool by_time) {
    nlohmann::ordered_json entry;
    entry["worker"] = "w-" + std::to_string(score.worker.value);
    entry["name"] = score.name;
    entry["chosen"] = score.is_chosen;
    entry["may_take"] = score.may_take;
    entry["scenarios"] = score.scenarios;
    entry["load"] = score.load;
    entry["held_triangles"] = score.held_triangles;
    entry["missing_triangles"] = score.missing_triangles;
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

} // namespace

std::string explained_text(const Explained& explained, const std::string& job) {
    std::string text = "scenario " + std::to_string(explained.scenario) + " of " + job + ", " +
                       explained.strategy + "\n";
    const bool is_scored = !explained.why.empty(); // Empty once the job has ended.
    text += !is_scored ? ""
                       : "  touches     " + std::to_string(explained.roots_a) + " roots of A, " +
                             std::to_string(explained.roots_b) + " of B\n";
    text += "  is          " + explained.where + "\n";
    text += !is_scored ? "" : "  now chosen  " + explained.why + "\n";
    text += explained.note.empty() ? "" : "  note        " + explained.note + "\n";
    if (!explained.workers.empty()) {
        text += table_text(explained.is_by_time ? table_by_time(explained)
                                                : table_by_triangles(explained),
                           false,
                           "  ");
    }
    return text;
}

std::string explained_json(const Explained& explained, const std::string& job) {
    nlohmann::ordered_json document;
    document["job"] = job;
    document["scenario"] = explained.scenario;
    document["strategy"] = explained.strategy;
    document["where"] = explained.where;
    document["why"] = explained.why;
    document["note"] = explained.note;
    if (!explained.why.empty()) { // Empty once the job has ended.
        document["roots_a"] = explained.roots_a;
        document["roots_b"] = explained.roots_b;
    }
    document["workers"] = nlohmann::ordered_json::array();
    for (const WorkerScore& score : explained.workers) {
        document["workers"].push_back(score_json(score, explained.is_by_time));
    }
    return document.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

} // namespace cd
