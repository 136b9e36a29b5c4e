// What a request to the page's interface asks for: the target below /api/v1/.
#pragma once

#include "common/core/files/hash.hpp"
#include "common/core/result.hpp"
#include "common/pair/triangle_pair.hpp"
#include "proto/messages/client_messages.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace cd {

enum class PageTopic : std::uint8_t {
    Source,
    Cluster,
    History,
    Jobs,
    Job,
    Progress,
    Classes,
    Counts,
    Distances,
    Poses,
    Keys,
    Bodies,
    Steps,
    Map,
    Parts,
    PartNames,
    ClosedParts,
    Scenario,
    Pairs,
    Points,
    Hits,
    Next,
    Mesh,
};

/// Scenarios of a job, or steps: a range, or a sample of evenly spaced ones.
struct ScenarioChoice {
    std::uint64_t first = 0;
    std::uint64_t count = 0;
    std::uint64_t sample = 0; ///< Size of the sample; 0: the range is meant.

    [[nodiscard]] std::uint64_t size() const { return sample != 0 ? sample : count; }
    /// Returns the index of the chosen scenario `i`, below `size()`, in a job of `total` scenarios.
    [[nodiscard]] std::uint64_t at(std::uint64_t i, std::uint64_t total) const {
        return sample != 0 ? sampled_scenario(i, sample, total) : first + i;
    }
    /// `noun` says what is chosen, for messages. Errors: BadInput if the range exceeds `count_max`
    /// or the job, or the sample its bound.
    [[nodiscard]] Status
    check(std::uint64_t total, std::uint64_t count_max, std::string_view noun = "scenario") const;
};

/// Describes the next scenario in contact, or near, after or before a scenario.
struct NextContact {
    enum class Kind : std::uint8_t { Contact, Near, Either };

    std::uint64_t from = 0;
    bool is_backwards = false;
    /// Only scenarios with such a pair of this part of A; empty: any part.
    std::string part_a = {};
    std::string part_b = {};
    Kind kind = Kind::Contact;
    /// Only scenarios of this body, by its name or number; empty: any body.
    std::string body = {};
    /// The bodies of these parts, by their names or numbers; empty, in a job of two: A and B.
    std::string body_a = {};
    std::string body_b = {};

    /// True if a scenario of this class may be meant. `value` is a `ScenarioClass` or `no_class`.
    [[nodiscard]] bool has_class(std::uint8_t value) const;
    /// True if a pair of this class makes a scenario of its parts.
    [[nodiscard]] bool has_pair(PairClass value) const {
        return kind == Kind::Either || (kind == Kind::Near) == (value == PairClass::Near);
    }
};

struct PageRequest {
    PageTopic topic = PageTopic::Source;
    std::string job;          ///< Id of the job, for the topics about one.
    std::uint64_t number = 0; ///< The scenario, or the body of a map or of parts.
    ScenarioChoice choice;    ///< For arrays of scenarios or steps.
    NextContact next;
    Sha256 mesh;
};

/// All targets that are not static begin with this.
inline constexpr std::string_view page_api = "/api/v1/";

/// Parses a target that begins with `page_api`. It is untrusted. Errors: NotFound if there is no
/// such route; BadInput naming the parameter that is missing, unknown or invalid.
[[nodiscard]] Result<PageRequest> parse_page_request(std::string_view target);

/// Decodes %XX, and + as a blank, in a parameter's value; nothing if an escape is invalid.
[[nodiscard]] std::optional<std::string> percent_decoded(std::string_view text);

} // namespace cd
