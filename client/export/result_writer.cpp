#include "client/export/result_writer.hpp"

#include "common/core/printable.hpp"

#include <algorithm>
#include <set>

namespace cd {

namespace {

constexpr std::string_view special_in_names = "/\\:*?\"<>|&'";

/// Returns a name without what is special in paths or XML; it is not hidden, nor an option.
std::string plain_file_name(const std::string& name) {
    constexpr std::size_t bytes_max = 100;
    const std::string valid = valid_utf8(name);
    std::string plain(utf8_prefix(valid, bytes_max));
    std::ranges::replace_if(
        plain,
        [](char c) {
            const auto code = static_cast<unsigned char>(c);
            return code < 0x20 || code == 0x7f ||
                   special_in_names.find(c) != std::string_view::npos;
        },
        '_');
    const bool is_odd = plain.empty() || plain[0] == '.' || plain[0] == '-';
    return is_odd ? "_" + plain : plain;
}

} // namespace

void ExportContext::describe(const Query& query) {
    level = query.level;
    listed = {query.limit_pairs, query.maps, query.first_hits};
    clearance = query.clearance;
    question = query.question;
    up_to = query.up_to;
}

std::optional<std::uint64_t> ExportContext::bundle_of(const ScenarioResult& result) const {
    const auto& views = bodies.back().views;
    return steps && views && result.step ? std::optional(*result.step % views->bundles())
                                         : std::nullopt;
}

std::string body_file_name(const std::vector<ExportBody>& bodies, std::size_t body) {
    std::set<std::string> taken{"contacts"};
    std::string name;
    for (std::size_t i = 0; i <= body; ++i) {
        name = plain_file_name(bodies[i].name);
        while (!taken.insert(name).second) {
            name += "_";
        }
    }
    return name;
}

std::string_view pair_class_name(PairClass kind) {
    switch (kind) {
    case PairClass::Separate:
        return "separate";
    case PairClass::Touch:
        return "touch";
    case PairClass::Coplanar:
        return "coplanar";
    case PairClass::Proper:
        return "proper";
    case PairClass::Near:
        return "near";
    }
    return "unknown";
}

std::vector<double> pair_distances(const ScenarioResult& result) {
    std::vector<double> distances;
    auto near = result.near_distances.begin();
    for (const ContactPair& pair : result.pairs) {
        distances.push_back(pair.kind == PairClass::Near ? *near++ : 0);
    }
    return distances;
}

} // namespace cd
