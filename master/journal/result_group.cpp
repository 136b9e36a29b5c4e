#include "master/journal/result_group.hpp"

#include "common/core/check.hpp"
#include "common/core/files/disk_file.hpp"
#include "master/journal/row_bytes.hpp"

#include <algorithm>

namespace cd {

namespace {

constexpr const char* what = "a group of results";
constexpr std::uint8_t flag_surfaces_only = 1;
constexpr std::uint8_t flag_cut = 2;
constexpr std::uint8_t flag_insides_skipped = 4;
constexpr std::uint8_t flag_distance = 8;
constexpr std::uint8_t flags_all =
    flag_surfaces_only | flag_cut | flag_insides_skipped | flag_distance;

constexpr std::uint64_t classes = 8;

/// The class and the flags of a row in one number.
std::uint64_t state_of(const ScenarioFacts& facts) {
    const int flags = (facts.surfaces_only ? flag_surfaces_only : 0) |
                      (facts.is_cut ? flag_cut : 0) |
                      (facts.insides_skipped ? flag_insides_skipped : 0) |
                      (facts.has_distance ? flag_distance : 0);
    return static_cast<std::uint64_t>(facts.kind) + classes * static_cast<std::uint64_t>(flags);
}

bool set_state(ScenarioFacts& facts, std::uint64_t state) {
    static_assert(static_cast<std::uint64_t>(ScenarioClass::Near) + 1 == classes);
    const std::uint64_t flags = state / classes;
    facts.kind = static_cast<ScenarioClass>(state % classes);
    facts.surfaces_only = (flags & flag_surfaces_only) != 0;
    facts.is_cut = (flags & flag_cut) != 0;
    facts.insides_skipped = (flags & flag_insides_skipped) != 0;
    facts.has_distance = (flags & flag_distance) != 0;
    return flags <= flags_all;
}

/// Writes a number for each row as runs of equal numbers. A run is the number and its length
/// less 1.
template <class NumberOf>
void put_runs(ByteWriter& out, std::span<const ResultRow> rows, const NumberOf& number_of) {
    for (std::size_t i = 0; i < rows.size();) {
        const std::uint64_t number = number_of(i);
        const std::size_t begin = i;
        while (i < rows.size() && number_of(i) == number) {
            ++i;
        }
        put_varint(out, number);
        put_varint(out, i - begin - 1);
    }
}

/// Reads what `put_runs` wrote. Calls `take` with each row and number; it returns their validity.
template <class Take>
bool get_runs(ByteReader& in, std::span<ResultRow> rows, const Take& take) {
    for (std::size_t i = 0; i < rows.size();) {
        const auto number = get_varint(in);
        const auto more = get_varint(in);
        if (!number || !more || *more >= rows.size() - i) {
            return false;
        }
        for (const std::size_t end = i + *more + 1; i < end; ++i) {
            if (!take(rows[i], *number)) {
                return false;
            }
        }
    }
    return true;
}

/// Writes the rows by columns, as runs except for the numbers of pairs, which rarely repeat.
void put_rows(ByteWriter& out, std::span<const ResultRow> rows) {
    put_varint(out, rows.size());
    for (const ResultRow& row : rows) {
        put_varint(out, row.facts.pair_count);
    }
    put_runs(out, rows, [&](std::size_t i) { // The step from the previous scenario, minus 1.
        const std::uint64_t before = i == 0 ? ~std::uint64_t{0} : rows[i - 1].scenario;
        return zigzag(static_cast<std::int64_t>(rows[i].scenario - before - 1));
    });
    put_runs(out, rows, [&](std::size_t i) { return rows[i].length; });
    put_runs(out, rows, [&](std::size_t i) { return state_of(rows[i].facts); });
    put_runs(out, rows, [&](std::size_t i) { return rows[i].facts.near_count; });
}

bool get_rows(ByteReader& in, std::vector<ResultRow>& rows) {
    const auto count = get_varint(in);
    if (!count || !may_hold(in, *count, 1)) {
        return false;
    }
    rows.resize(*count);
    for (ResultRow& row : rows) {
        const auto pairs = get_varint(in);
        if (!pairs) {
            return false;
        }
        row.facts.pair_count = *pairs;
    }
    std::uint64_t before = ~std::uint64_t{0};
    const auto take_scenario = [&](ResultRow& row, std::uint64_t step) {
        before += static_cast<std::uint64_t>(unzigzag(step)) + 1;
        row.scenario = before;
        return true;
    };
    const auto take_length = [](ResultRow& row, std::uint64_t length) {
        row.length = length;
        return true;
    };
    const auto take_state = [](ResultRow& row, std::uint64_t state) {
        return set_state(row.facts, state);
    };
    const auto take_near = [](ResultRow& row, std::uint64_t near) {
        row.facts.near_count = near;
        return true;
    };
    return get_runs(in, rows, take_scenario) && get_runs(in, rows, take_length) &&
           get_runs(in, rows, take_state) && get_runs(in, rows, take_near);
}

void put_maps(ByteWriter& out, std::span<const Bytes> maps) {
    put_varint(out, maps.size());
    for (const Bytes& map : maps) {
        put_varint(out, map.size());
        put_bytes(out, map);
    }
}

bool get_maps(ByteReader& in, std::vector<Bytes>& maps) {
    const auto count = get_varint(in);
    if (!count || !may_hold(in, *count, 1)) {
        return false;
    }
    for (std::uint64_t i = 0; i < *count; ++i) {
        const auto map = in.get_bytes(get_varint(in).value_or(0));
        maps.emplace_back(map.begin(), map.end());
    }
    return !in.failed();
}

/// Writes the distinct processes, and then the runs, which refer to a process by its index.
void put_authors(ByteWriter& out, std::span<const AuthorRun> runs) {
    std::vector<InstanceId> processes;
    for (const AuthorRun& run : runs) {
        if (std::ranges::find(processes, run.author) == processes.end()) {
            processes.push_back(run.author);
        }
    }
    put_varint(out, processes.size());
    out.put_array(std::span<const InstanceId>(processes));
    put_varint(out, runs.size());
    for (const AuthorRun& run : runs) {
        const auto place = std::ranges::find(processes, run.author) - processes.begin();
        put_varint(out, static_cast<std::uint64_t>(place));
        put_varint(out, run.rows);
    }
}

bool get_authors(ByteReader& in, std::uint64_t rows, std::vector<AuthorRun>& runs) {
    const auto processes = in.get_array<InstanceId>(get_varint(in).value_or(0));
    const auto count = get_varint(in);
    if (in.failed() || !count || !may_hold(in, *count, 2)) {
        return false;
    }
    for (std::uint64_t i = 0; i < *count; ++i) {
        const auto place = get_varint(in);
        const auto length = get_varint(in);
        if (!place || !length || *place >= processes.size() || *length > rows) {
            return false;
        }
        rows -= *length;
        runs.push_back({*length, processes[*place]});
    }
    return rows == 0;
}

void put_remarks(ByteWriter& out, std::span<const Remark> remarks) {
    put_varint(out, remarks.size());
    for (const Remark& remark : remarks) {
        put_enumeration(out, remark.kind);
        out.put(remark.author);
        if (remark.kind != Remark::Kind::Withdrawn) {
            put_varint(out, remark.scenario);
            put_hash(out, remark.digest);
        }
    }
}

bool get_remarks(ByteReader& in, std::vector<Remark>& remarks) {
    const auto count = get_varint(in);
    if (!count || !may_hold(in, *count, 1 + sizeof(InstanceId))) {
        return false;
    }
    for (std::uint64_t i = 0; i < *count; ++i) {
        Remark remark;
        const bool is_kind = get_enumeration(in, remark.kind, Remark::Kind::Withdrawn);
        remark.author = in.get<InstanceId>();
        if (!is_kind) {
            return false;
        }
        if (remark.kind != Remark::Kind::Withdrawn) {
            const auto scenario = get_varint(in);
            if (!scenario) {
                return false;
            }
            remark.scenario = *scenario;
            remark.digest = get_hash(in);
        }
        remarks.push_back(remark);
    }
    return !in.failed();
}

void put_losses(ByteWriter& out, std::span<const LostPositions> losses) {
    put_varint(out, losses.size());
    for (const LostPositions& lost : losses) {
        put_varint(out, lost.positions.first);
        put_varint(out, lost.positions.count);
        out.put(lost.process);
    }
}

bool get_losses(ByteReader& in, std::vector<LostPositions>& losses) {
    const auto count = get_varint(in);
    if (!count || !may_hold(in, *count, 2 + sizeof(InstanceId))) {
        return false;
    }
    for (std::uint64_t i = 0; i < *count; ++i) {
        const auto first = get_varint(in);
        const auto length = get_varint(in);
        if (!first || !length || *length == 0 || *first + *length < *first) {
            return false;
        }
        losses.push_back({{*first, *length}, in.get<InstanceId>()});
    }
    return !in.failed();
}

} // namespace

Bytes encode_group(const ResultGroup& group) {
    std::uint64_t authored = 0;
    for (const AuthorRun& run : group.authors) {
        authored += run.rows;
    }
    CD_CHECK(authored == group.rows.size());
    ByteWriter out;
    out.put(group.begin);
    put_rows(out, group.rows);
    put_maps(out, group.maps);
    put_authors(out, group.authors);
    put_remarks(out, group.remarks);
    put_losses(out, group.losses);
    return out.take();
}

Result<ResultGroup> decode_group(std::span<const std::byte> bytes) {
    ByteReader in(bytes);
    ResultGroup group;
    group.begin = in.get<std::uint64_t>();
    if (!get_rows(in, group.rows) || !get_maps(in, group.maps)) {
        return damaged_row(what);
    }
    if (!get_authors(in, group.rows.size(), group.authors) || !get_remarks(in, group.remarks) ||
        !get_losses(in, group.losses) || !in.complete()) {
        return damaged_row(what);
    }
    return group;
}

} // namespace cd
