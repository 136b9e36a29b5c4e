#include "common/job/scenario.hpp"

#include "common/core/varint.hpp"

#include <array>
#include <optional>
#include <string>

namespace cd {

namespace {

constexpr std::uint8_t version = 1;

/// The form in which a pose is packed. The values are part of the format (scenario.hpp).
enum class Form : std::uint8_t { Identity = 0, Translation = 1, Matrix = 2, Quaternion = 3 };

Form form_of(const Pose& pose) {
    if (pose.kind() == Pose::Kind::Quaternion) {
        return Form::Quaternion;
    }
    if (pose.matrix() != Mat3::Identity()) {
        return Form::Matrix;
    }
    return pose.translation() == Vec3::Zero() ? Form::Identity : Form::Translation;
}

constexpr std::size_t numbers_in(Form form) {
    constexpr std::array<std::size_t, 4> numbers{0, 3, 12, 7};
    return numbers[static_cast<std::size_t>(form)];
}

/// The properties that the scenarios of one run share.
struct RunKind {
    Form a = Form::Identity;
    Form b = Form::Identity;
    std::uint32_t body_a = 0;
    std::uint32_t body_b = 0;

    [[nodiscard]] std::size_t scenario_bytes() const {
        return sizeof(double) * (numbers_in(a) + numbers_in(b));
    }
    friend bool operator==(const RunKind&, const RunKind&) = default;
};

RunKind kind_of(const Scenario& scenario) {
    return {form_of(scenario.poses.a), form_of(scenario.poses.b), scenario.body_a, scenario.body_b};
}

/// Returns the number of scenarios in the run that begins with the first of `scenarios`.
std::size_t run_length(std::span<const Scenario> scenarios) {
    const RunKind kind = kind_of(scenarios[0]);
    // A run of scenarios without doubles is limited, or a few bytes could claim any number of them.
    const std::size_t length_max = kind.scenario_bytes() == 0 ? 1 : scenarios.size();
    std::size_t length = 1;
    while (length < length_max && scenarios[length].index == scenarios[length - 1].index + 1 &&
           kind_of(scenarios[length]) == kind) {
        ++length;
    }
    return length;
}

void put_pose(ByteWriter& out, const Pose& pose, Form form) {
    if (form == Form::Matrix) {
        for (int row = 0; row < 3; ++row) {
            const Vec3 values = pose.matrix().row(row);
            out.put_array(std::span<const double>(values.data(), 3));
        }
    }
    if (form == Form::Quaternion) {
        const Quaternion& q = pose.quaternion();
        out.put_array(std::span<const double>(std::array<double, 4>{q.w, q.x, q.y, q.z}));
    }
    if (form != Form::Identity) {
        out.put_array(std::span<const double>(pose.translation().data(), 3));
    }
}

/// Reads a pose. Returns nothing if a number is not finite or the quaternion is zero.
std::optional<Pose> get_pose(ByteReader& in, Form form) {
    Mat3 matrix = Mat3::Identity();
    if (form == Form::Matrix) {
        for (int i = 0; i < 9; ++i) {
            matrix(i / 3, i % 3) = in.get<double>();
        }
    }
    Quaternion q;
    if (form == Form::Quaternion) {
        q.w = in.get<double>();
        q.x = in.get<double>();
        q.y = in.get<double>();
        q.z = in.get<double>();
        if (q == Quaternion{0, 0, 0, 0}) {
            return std::nullopt;
        }
    }
    Vec3 translation = Vec3::Zero();
    if (form != Form::Identity) {
        for (int i = 0; i < 3; ++i) {
            translation[i] = in.get<double>();
        }
    }
    const Pose pose = form == Form::Quaternion ? Pose::from_quaternion(q, translation)
                                               : Pose::from_matrix(matrix, translation);
    return pose.is_finite() ? std::optional(pose) : std::nullopt;
}

Error bad_frame(const char* what) {
    return {ErrorCode::BadFrame, std::string("packed scenarios: ") + what};
}

struct RunHeader {
    RunKind kind;
    std::uint64_t length = 0;
    std::uint64_t index = 0; ///< Index of the run's first scenario.
};

/// Reads a run's header. Returns nothing if the header is malformed or the run does not fit `in`.
std::optional<RunHeader> get_run_header(ByteReader& in, std::uint64_t index_expected) {
    const auto forms = in.get<std::uint8_t>();
    const auto length = get_varint(in);
    const auto step = get_varint(in);
    const auto body_a = get_varint(in);
    const auto body_b = get_varint(in);
    if (forms > 0xf || !length || !step || !body_a || !body_b || *body_a > UINT32_MAX ||
        *body_b > UINT32_MAX) {
        return std::nullopt;
    }
    RunHeader header;
    header.kind = {static_cast<Form>(forms & 3),
                   static_cast<Form>(forms >> 2),
                   static_cast<std::uint32_t>(*body_a),
                   static_cast<std::uint32_t>(*body_b)};
    header.length = *length;
    header.index = index_expected + static_cast<std::uint64_t>(unzigzag(*step));
    const std::size_t scenario_bytes = header.kind.scenario_bytes();
    const std::uint64_t length_max = scenario_bytes == 0 ? 1 : in.remaining() / scenario_bytes;
    const bool fits = header.length >= 1 && header.length <= length_max &&
                      header.index <= UINT64_MAX - header.length;
    return fits ? std::optional(header) : std::nullopt;
}

Status get_run(ByteReader& in, const RunHeader& header, std::vector<Scenario>& scenarios) {
    for (std::uint64_t i = 0; i < header.length; ++i) {
        const auto a = get_pose(in, header.kind.a);
        const auto b = get_pose(in, header.kind.b);
        if (!a || !b) {
            return Error{ErrorCode::BadInput,
                         "the pose of body " + std::string(a ? "b" : "a") + " in scenario " +
                             std::to_string(header.index + i) +
                             " is not finite or has a zero quaternion"};
        }
        scenarios.push_back(
            {header.index + i, header.kind.body_a, header.kind.body_b, PosePair{*a, *b}});
    }
    return Done{};
}

} // namespace

Bytes pack_scenarios(std::span<const Scenario> scenarios) {
    ByteWriter out;
    out.put(version);
    put_varint(out, scenarios.size());
    std::uint64_t index_expected = 0;
    while (!scenarios.empty()) {
        const std::size_t length = run_length(scenarios);
        const Scenario& first = scenarios.front();
        const RunKind kind = kind_of(first);
        out.put(static_cast<std::uint8_t>(static_cast<unsigned>(kind.a) |
                                          static_cast<unsigned>(kind.b) << 2));
        put_varint(out, length);
        put_varint(out, zigzag(static_cast<std::int64_t>(first.index - index_expected)));
        put_varint(out, kind.body_a);
        put_varint(out, kind.body_b);
        for (const Scenario& scenario : scenarios.first(length)) {
            put_pose(out, scenario.poses.a, kind.a);
            put_pose(out, scenario.poses.b, kind.b);
        }
        index_expected = first.index + length;
        scenarios = scenarios.subspan(length);
    }
    return out.take();
}

Result<std::vector<Scenario>> unpack_scenarios(std::span<const std::byte> bytes,
                                               std::uint64_t count_max) {
    ByteReader in(bytes);
    if (in.get<std::uint8_t>() != version) {
        return bad_frame("unknown version");
    }
    const auto count = get_varint(in);
    if (!count) {
        return bad_frame("no count");
    }
    if (*count > count_max) {
        return Error{ErrorCode::TooLarge,
                     "packed scenarios: " + std::to_string(*count) + " of them, and at most " +
                         std::to_string(count_max) + " are taken"};
    }
    std::vector<Scenario> scenarios;
    std::uint64_t index_expected = 0;
    while (scenarios.size() < *count) {
        const auto header = get_run_header(in, index_expected);
        if (!header || header->length > *count - scenarios.size()) {
            return bad_frame("a run that is malformed or cut short");
        }
        if (const Status status = get_run(in, *header, scenarios); !status) {
            return status.error();
        }
        index_expected = header->index + header->length;
    }
    if (!in.complete()) {
        return bad_frame("bytes left over");
    }
    return scenarios;
}

} // namespace cd
