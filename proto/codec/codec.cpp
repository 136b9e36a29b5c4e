#include "proto/codec/codec.hpp"

#include "common/core/limits/engine.hpp"
#include "common/core/limits/web.hpp"
#include "common/core/limits/wire.hpp"
#include "common/core/printable.hpp"
#include "common/core/timing/wire.hpp"
#include "proto/codec/wire_messages.hpp"

#include <algorithm>
#include <functional>
#include <utility>

namespace cd {
namespace {

// Describes a violated invariant of a message's members; null if there is none. A violation is a
// bug before encoding, and the peer's fault after decoding.
using Problem = const char*;

template <class T>
Problem problem_of(const T& /*message*/) {
    return nullptr;
}

Problem problem_of(const Hello& hello) {
    if (!(hello.weight > 0) || hello.weight > limits::worker_weight_max) {
        return "a weight that is not positive or too large";
    }
    if (hello.threads > limits::worker_threads_max) {
        return "more threads than a worker may have";
    }
    for (const std::string* text : {&hello.name, &hello.build, &hello.user}) {
        if (text->size() > limits::hello_text_bytes_max || !is_printable(*text)) {
            return "a name that is too long or not printable";
        }
    }
    return nullptr;
}

Problem problem_of_strategy(const std::string& name) {
    return is_strategy_name(name) ? nullptr : "a strategy's name that is none";
}
Problem problem_of(const AddJob& job) {
    return query_problem(job.query);
}
Problem problem_of(const Submit& submit) {
    const Problem problem = query_problem(submit.query);
    return problem != nullptr ? problem : problem_of_strategy(submit.cluster.strategy);
}
Problem problem_of(const JobDescription& description) {
    return problem_of(description.submit);
}
Problem problem_of(const Explained& explained) {
    return problem_of_strategy(explained.strategy);
}

Problem problem_of_sample(std::uint64_t sample) {
    return sample > limits::page_sample_max ? "a sample of too many scenarios" : nullptr;
}
Problem problem_of(const ResultsQuery& query) {
    return problem_of_sample(query.sample);
}
Problem problem_of(const PosesQuery& query) {
    return problem_of_sample(query.sample);
}

/// Requires that the intervals in `held` ascend within [first, next) and have `count` scenarios.
Problem problem_of(const ResultsPart& part) {
    std::uint64_t end = part.first;
    std::uint64_t count = 0;
    for (const ScenarioInterval& run : part.held) {
        if (run.first < end || run.first > part.next || run.count > part.next - run.first) {
            return "scenarios that do not ascend or lie outside the part";
        }
        end = run.first + run.count;
        count += run.count;
    }
    return end > part.next || count != part.count ? "another number of records than of scenarios"
                                                  : nullptr;
}

Problem problem_of_pairs(const WorkUnit& unit) {
    const auto& offsets = unit.pair_offsets;
    if (offsets.size() != unit.count + 1 || offsets.front() != 0 ||
        offsets.back() != unit.pairs.size()) {
        return "offsets of pairs that do not span the pairs of the scenarios";
    }
    if (!std::is_sorted(offsets.begin(), offsets.end())) {
        return "offsets of pairs that descend";
    }
    for (std::size_t i = 0; i + 1 < offsets.size(); ++i) {
        const auto pairs = std::span(unit.pairs).subspan(offsets[i], offsets[i + 1] - offsets[i]);
        if (std::adjacent_find(pairs.begin(), pairs.end(), std::greater_equal<>()) != pairs.end()) {
            return "pairs of a scenario that do not ascend";
        }
    }
    return nullptr;
}

Problem problem_of(const WorkUnit& unit) {
    if (unit.count == 0 || (!unit.is_analysed() && unit.count > limits::range_scenarios_max)) {
        return "no scenarios, or too many";
    }
    if (unit.first > limits::scenarios_max) {
        return "a first scenario beyond the largest job";
    }
    if (unit.results_wait_ms > timing::results_wait_max.count()) {
        return "results that wait too long";
    }
    if (!unit.is_analysed()) {
        return unit.pairs.empty() ? nullptr : "pairs without offsets";
    }
    return problem_of_pairs(unit);
}

Problem problem_of_roots(const std::vector<RootIndex>& roots) {
    const bool ascends =
        std::adjacent_find(roots.begin(), roots.end(), std::greater_equal<>()) == roots.end();
    return ascends ? nullptr : "roots that do not ascend";
}

Problem problem_of(const WantSubtrees& want) {
    return problem_of_roots(want.roots);
}
Problem problem_of(const Evicted& evicted) {
    return problem_of_roots(evicted.roots);
}
Problem problem_of(const Hint& hint) {
    return problem_of_roots(hint.roots);
}
Problem problem_of(const Held& held) {
    return problem_of_roots(held.roots);
}
Problem problem_of(const FetchFailed& failed) {
    return problem_of_roots(failed.roots);
}
Problem problem_of_scenarios(const std::vector<std::uint64_t>& scenarios) {
    const bool ascends =
        std::adjacent_find(scenarios.begin(), scenarios.end(), std::greater_equal<>()) ==
        scenarios.end();
    return ascends ? nullptr : "scenarios that do not ascend";
}
Problem problem_of(const Recall& recall) {
    return problem_of_scenarios(recall.scenarios);
}
Problem problem_of(const Recalled& recalled) {
    return problem_of_scenarios(recalled.scenarios);
}
Problem problem_of(const Inventory& inventory) {
    for (const Recalled& task : inventory.tasks) {
        if (const Problem problem = problem_of(task)) {
            return problem;
        }
    }
    for (const InventoryTree& tree : inventory.trees) {
        if (const Problem problem = problem_of_roots(tree.held)) {
            return problem;
        }
    }
    return nullptr;
}
Problem problem_of(const PeerFetch& fetch) {
    return problem_of_roots(fetch.roots);
}
Problem problem_of(const PeerFetched& fetched) {
    return problem_of_roots(fetched.missing);
}

Problem problem_of(const FetchFromPeers& fetch) {
    if (fetch.hashes.size() != fetch.roots.size()) {
        return "another number of hashes than of roots";
    }
    if (fetch.sources.empty() || fetch.sources.size() > limits::peer_sources_max) {
        return "no source, or too many";
    }
    for (const PeerSource& source : fetch.sources) {
        if (source.host.size() > limits::hello_text_bytes_max || !is_printable(source.host)) {
            return "a host that is too long or not printable";
        }
    }
    return problem_of_roots(fetch.roots);
}

template <class Part>
Problem problem_of_part(const Part& part) {
    if (part.bytes_total > limits::mesh_bytes_max || part.bytes.size() > part.bytes_total ||
        part.offset > part.bytes_total - part.bytes.size()) {
        return "a part outside its mesh";
    }
    return nullptr;
}
/// Limits `count`, because receivers size their buffers by it.
Problem problem_of(const JobPoses& poses) {
    return poses.count > limits::poses_answer_scenarios ? "more scenarios than are sent at once"
                                                        : nullptr;
}

Problem problem_of(const MeshPart& part) {
    return problem_of_part(part);
}
Problem problem_of(const MeshBytes& part) {
    return problem_of_part(part);
}

Problem problem_of(const Results& results) {
    if (!(results.compute_seconds >= 0)) {
        return "a negative time";
    }
    return results.compute_seconds > timing::compute_seconds_max ? "an impossibly long time"
                                                                 : nullptr;
}

Problem problem_of_pem(const std::string& text) {
    return text.size() > limits::certificate_bytes_max ? "a certificate that is too long" : nullptr;
}

Problem problem_of(const Join& join) {
    if (!is_good_name(join.name)) {
        return "a name that is empty, too long or not printable, or begins or ends with a blank";
    }
    return problem_of_pem(join.request);
}
Problem problem_of(const Renew& renew) {
    return problem_of_pem(renew.request);
}
Problem problem_of(const Certified& certified) {
    const Problem problem = problem_of_pem(certified.certificate);
    return problem == nullptr ? problem_of_pem(certified.authority) : problem;
}
Problem problem_of(const TokenCreated& created) {
    return created.token.size() > limits::hello_text_bytes_max || !is_printable(created.token)
               ? "a token that is too long or not printable"
               : nullptr;
}

/// Estimates the encoded size in bytes, which avoids reallocations for large messages.
template <class T>
std::size_t bytes_expected(const T& /*message*/) {
    return 256;
}

std::size_t bytes_expected(const Subtrees& subtrees) {
    std::size_t bytes = 256;
    for (const SubtreeBlock& block : subtrees.blocks) {
        bytes += block.compressed.size() + 64;
    }
    return bytes;
}

std::size_t bytes_expected(const Results& results) {
    return 256 + results.records.size() + results.map.size();
}
std::size_t bytes_expected(const ResultsPart& part) {
    return 256 + part.records.size();
}
std::size_t bytes_expected(const ContactMapAnswer& part) {
    return 256 + part.map.size();
}
std::size_t bytes_expected(const MeshPart& part) {
    return 256 + part.bytes.size();
}
std::size_t bytes_expected(const MeshBytes& part) {
    return 256 + part.bytes.size();
}

template <class T>
Message decode_as(WireInput& in) {
    T message{};
    in(message);
    if (in.remaining() != 0) {
        throw WireError("bytes left over");
    }
    if (const Problem problem = problem_of(message)) {
        throw WireError(problem);
    }
    return message;
}

using Decoder = Message (*)(WireInput&);

template <std::size_t... I>
constexpr auto make_decoders(std::index_sequence<I...> /*places*/) {
    return std::array<Decoder, sizeof...(I)>{decode_as<std::variant_alternative_t<I, Message>>...};
}

constexpr auto decoders = make_decoders(std::make_index_sequence<std::variant_size_v<Message>>());

} // namespace

Bytes encode_message(const Message& message) {
    return std::visit(
        [](const auto& m) {
            CD_CHECK(problem_of(m) == nullptr);
            WireOutput out(bytes_expected(m));
            out(m);
            return out.take();
        },
        message);
}

Result<Message> decode_message(std::uint16_t type, std::span<const std::byte> payload) {
    if (type == 0 || type > decoders.size()) {
        return Error{ErrorCode::BadFrame, "unknown message " + std::to_string(type)};
    }
    try {
        WireInput in(payload);
        return decoders[type - 1u](in);
    } catch (const WireError& error) {
        return Error{ErrorCode::BadFrame,
                     "message '" + std::string(message_name(type)) + "': " + error.what()};
    }
}

} // namespace cd
