#include "common/job/result/contact_map.hpp"

#include "common/core/files/bytes.hpp"
#include "common/geometry/number_sorter.hpp"
#include "common/shots/line_hit.hpp"

#include <algorithm>
#include <utility>

namespace cd {

namespace {

using Entries = std::vector<TriangleContacts>;

/// The list `Body::touched` is merged into `Body::sums` once it has at least this many entries and
/// at least as many as `sums`.
constexpr std::size_t touched_enough = 1u << 16;

/// Merges two lists in ascending order of triangles; adds the counts of equal triangles.
Entries merged(const Entries& one, const Entries& other) {
    Entries sum;
    sum.reserve(one.size() + other.size());
    auto next = other.begin();
    for (const TriangleContacts& entry : one) {
        while (next != other.end() && next->triangle < entry.triangle) {
            sum.push_back(*next++);
        }
        sum.push_back(entry);
        if (next != other.end() && next->triangle == entry.triangle) {
            sum.back().scenarios += (next++)->scenarios;
        }
    }
    sum.insert(sum.end(), next, other.end());
    return sum;
}

/// Counts how often each number occurs in an ascending list.
Entries counted(std::span<const std::uint32_t> ascending) {
    Entries entries;
    for (const std::uint32_t triangle : ascending) {
        if (entries.empty() || entries.back().triangle != triangle) {
            entries.push_back({triangle, 0});
        }
        ++entries.back().scenarios;
    }
    return entries;
}

} // namespace

std::vector<ContactPair> crossings_of(const ScenarioResult& result) {
    std::vector<ContactPair> crossings;
    for (std::size_t i = 0; i < result.hits.size(); ++i) {
        if ((result.hits[i].flags & hit_flag::crosses) != 0) {
            crossings.push_back(result.pairs[i]);
        }
    }
    return crossings;
}

// ---- The sum of a task --------------------------------------------------------------------------

struct ContactMapSum::Body {
    Entries sums;
    /// Contains a triangle once for each scenario in contact that `sums` does not count yet.
    std::vector<std::uint32_t> touched;
};

struct ContactMapSum::State {
    NumberSorter sorter;
    std::vector<std::uint32_t> triangles; ///< Scratch: triangles of the scenario being added.
    std::array<Body, 2> bodies;
    PartContactSum parts;

    void sum_up(Body& body) const {
        sorter.sort(body.touched);
        body.sums = merged(body.sums, counted(body.touched));
        body.touched.clear();
    }
    /// Counts each triangle in `triangles` for `body`, and empties that list.
    void touch(Body& body, Count count) {
        sorter.sort(triangles);
        if (count == Count::Once) {
            triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
        }
        body.touched.insert(body.touched.end(), triangles.begin(), triangles.end());
        triangles.clear();
        if (body.touched.size() >= std::max(touched_enough, body.sums.size())) {
            sum_up(body);
        }
    }
};

ContactMapSum::ContactMapSum(std::shared_ptr<const BodyPartRuns> parts)
    : parts_(std::move(parts)) {}
ContactMapSum::ContactMapSum(ContactMapSum&&) noexcept = default;
ContactMapSum& ContactMapSum::operator=(ContactMapSum&&) noexcept = default;
ContactMapSum::~ContactMapSum() = default;

ContactMapSum::State& ContactMapSum::state() {
    if (state_ == nullptr) {
        state_ = std::make_unique<State>();
        state_->parts = PartContactSum(parts_);
    }
    return *state_;
}

void ContactMapSum::add(const ScenarioResult& result, std::span<const ContactPair> found) {
    const bool is_shots = result.question == Question::Shots;
    add(found, is_shots ? Count::EachTime : Count::Once);
    if (parts_ == nullptr) {
        return;
    }
    const std::vector<ContactPair> crossings = crossings_of(result);
    const std::span<const ContactPair> listed = is_shots ? crossings : result.pairs;
    const std::span<const ContactPair> counted = result.level >= Level::Pairs ? listed : found;
    if (!counted.empty()) {
        state().parts.add(result.index, counted);
    }
}

void ContactMapSum::add(std::span<const ContactPair> pairs) {
    add(pairs, Count::Once);
}

void ContactMapSum::add(std::span<const ContactPair> pairs, Count count) {
    if (pairs.empty()) {
        return;
    }
    State& s = state();
    for (const ContactPair& pair : pairs) {
        s.triangles.push_back(pair.a);
    }
    s.touch(s.bodies[0], count);
    for (const ContactPair& pair : pairs) {
        s.triangles.push_back(pair.b);
    }
    s.touch(s.bodies[1], count);
}

void ContactMapSum::add(const ContactMap& map) {
    if (map.empty()) {
        return;
    }
    State& s = state();
    for (std::size_t i = 0; i < map.bodies.size(); ++i) {
        s.bodies[i].sums = merged(s.bodies[i].sums, map.bodies[i]);
    }
    s.parts.add(map.parts);
}

bool ContactMapSum::empty() const {
    return state_ == nullptr;
}

std::uint64_t ContactMapSum::bytes() const {
    std::uint64_t bytes = 0;
    if (state_ != nullptr) {
        for (const Body& body : state_->bodies) {
            bytes += body.sums.size() * sizeof(TriangleContacts) +
                     body.touched.size() * sizeof(std::uint32_t);
        }
        bytes += state_->parts.bytes();
    }
    return bytes;
}

ContactMap ContactMapSum::take() {
    ContactMap map;
    if (state_ != nullptr) {
        for (std::size_t i = 0; i < map.bodies.size(); ++i) {
            state_->sum_up(state_->bodies[i]);
            map.bodies[i] = std::move(state_->bodies[i].sums);
        }
        map.parts = state_->parts.sums();
        state_.reset();
    }
    return map;
}

// ---- The sum of a job ---------------------------------------------------------------------------

void ContactMapTotal::add(const ContactMap& map) {
    for (std::size_t i = 0; i < scenarios_.size(); ++i) {
        const Entries& entries = map.bodies[i];
        std::vector<std::uint64_t>& scenarios = scenarios_[i];
        if (!entries.empty() && entries.back().triangle >= scenarios.size()) {
            scenarios.resize(std::size_t{entries.back().triangle} + 1);
        }
        for (const TriangleContacts& entry : entries) {
            scenarios[entry.triangle] += entry.scenarios;
        }
    }
    parts_.add(map.parts);
}

ContactMap ContactMapTotal::map() const {
    ContactMap map;
    for (std::size_t i = 0; i < scenarios_.size(); ++i) {
        for (std::uint32_t triangle = 0; triangle < scenarios_[i].size(); ++triangle) {
            if (scenarios_[i][triangle] != 0) {
                map.bodies[i].push_back({triangle, scenarios_[i][triangle]});
            }
        }
    }
    map.parts = parts_.sums();
    return map;
}

Sha256 digest_of(const ContactMap& map) {
    ByteWriter out;
    for (const Entries& entries : map.bodies) {
        out.put(std::uint64_t{entries.size()});
        for (const TriangleContacts& entry : entries) {
            out.put(std::uint64_t{entry.triangle});
            out.put(entry.scenarios);
        }
    }
    return sha256(out.bytes());
}

} // namespace cd
