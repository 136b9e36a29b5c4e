#include "common/job/result/pair_hit.hpp"

#include "common/core/errors.hpp"
#include "common/job/result/canonical_numbers.hpp"
#include "common/shots/line_hit.hpp"

#include <string>

namespace cd {

namespace {

Error bad(const char* what) {
    return {ErrorCode::BadFrame, std::string("result record: ") + what};
}

/// Returns whether some hit has these flags.
bool are_possible(std::uint8_t flags) {
    const auto has = [flags](std::uint8_t flag) { return (flags & flag) != 0; };
    const bool passes = has(hit_flag::front) || has(hit_flag::back);
    return flags <= hit_flag::all && !(has(hit_flag::front) && has(hit_flag::back)) &&
           !(has(hit_flag::edge) && has(hit_flag::corner)) && (passes || !has(hit_flag::crosses));
}

} // namespace

void put_hits(ByteWriter& out, std::span<const PairHit> hits) {
    std::vector<double> depths;
    std::vector<std::uint8_t> flags;
    std::vector<std::uint8_t> ranks;
    for (const PairHit& hit : hits) {
        depths.push_back(hit.depth);
        flags.push_back(hit.flags);
        ranks.push_back(hit.rank);
    }
    put_numbers(out, depths);
    out.put_array(std::span<const std::uint8_t>(flags));
    out.put_array(std::span<const std::uint8_t>(ranks));
}

Status get_hits(ByteReader& in, std::size_t count, std::vector<PairHit>& hits) {
    const auto depths = in.get_array<double>(count);
    const auto flags = in.get_array<std::uint8_t>(count);
    const auto ranks = in.get_array<std::uint8_t>(count);
    if (in.failed()) {
        return bad("hits cut short");
    }
    hits.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        if (!is_distance(depths[i]) || !are_possible(flags[i])) {
            return bad("a hit that no line has");
        }
        hits.push_back({depths[i], flags[i], ranks[i]});
    }
    return Done{};
}

} // namespace cd
