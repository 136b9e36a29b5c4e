#include "common/job/packed_scenarios.hpp"

#include "common/core/check.hpp"
#include "common/core/files/disk_file.hpp"
#include "common/core/varint.hpp"

#include <algorithm>
#include <array>
#include <string>

namespace cd {

namespace {

constexpr std::uint8_t version = 2;
constexpr std::uint8_t forms_scene = 0x10;  ///< The scenarios of the run have steps.
constexpr std::uint8_t forms_motion = 0x20; ///< They are motions.
constexpr std::uint8_t forms_rests = 0x40;  ///< They are motions, and A rests.
constexpr std::uint8_t forms_max = 0x7f;

/// The form in which a pose is packed. The values are part of the format.
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

Form form_of_a(std::uint8_t forms) {
    return static_cast<Form>(forms & 3);
}

Form form_of_b(std::uint8_t forms) {
    return static_cast<Form>(forms >> 2 & 3);
}

bool have_steps(std::uint8_t forms) {
    return (forms & forms_scene) != 0;
}

bool are_motions(std::uint8_t forms) {
    return (forms & forms_motion) != 0;
}

bool rests_a(std::uint8_t forms) {
    return (forms & forms_rests) != 0;
}

/// Whether forms of motions make sense; all other forms do.
bool are_consistent(std::uint8_t forms) {
    const bool are_turns =
        form_of_a(forms) == Form::Quaternion && form_of_b(forms) == Form::Quaternion;
    return are_motions(forms) ? are_turns : !rests_a(forms);
}

std::uint8_t forms_of(const Scenario& scenario) {
    const bool rests = scenario.to && scenario.to->a == scenario.poses.a;
    return static_cast<std::uint8_t>(
        static_cast<unsigned>(form_of(scenario.poses.a)) |
        static_cast<unsigned>(form_of(scenario.poses.b)) << 2 | (scenario.step ? forms_scene : 0u) |
        (scenario.to ? forms_motion : 0u) | (rests ? forms_rests : 0u));
}

/// Returns how many doubles the end of a motion takes.
std::size_t numbers_at_end(std::uint8_t forms) {
    return are_motions(forms) ? numbers_in(Form::Quaternion) * (rests_a(forms) ? 1 : 2) : 0;
}

std::size_t bytes_with_forms(std::uint8_t forms) {
    return sizeof(std::uint32_t) + (have_steps(forms) ? sizeof(std::uint64_t) : 0) +
           sizeof(double) * (numbers_in(form_of_a(forms)) + numbers_in(form_of_b(forms)) +
                             numbers_at_end(forms));
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

Error bad_pose(const char* body, std::uint64_t index) {
    return {ErrorCode::BadInput,
            std::string("the pose of body ") + body + " in scenario " + std::to_string(index) +
                " is not finite or has a zero quaternion"};
}

Error bad_frame(const char* what) {
    return {ErrorCode::BadFrame, std::string("packed scenarios: ") + what};
}

void put_run_header(ByteWriter& out,
                    std::uint8_t forms,
                    std::uint64_t length,
                    std::uint32_t body_a,
                    std::uint32_t body_b,
                    std::uint64_t index_least) {
    out.put(forms);
    put_varint(out, length);
    put_varint(out, body_a);
    put_varint(out, body_b);
    put_varint(out, index_least);
}

/// The first scenarios of a list that can be packed as one run.
struct RunStart {
    std::size_t length = 0;
    std::uint64_t index_least = 0;
};

RunStart run_start(std::span<const Scenario> scenarios) {
    const Scenario& first = scenarios.front();
    const std::uint8_t forms = forms_of(first);
    std::uint64_t least = first.index;
    std::uint64_t most = first.index;
    std::size_t length = 1;
    while (length < scenarios.size()) {
        const Scenario& next = scenarios[length];
        const std::uint64_t low = std::min(least, next.index);
        const std::uint64_t high = std::max(most, next.index);
        if (next.body_a != first.body_a || next.body_b != first.body_b || forms_of(next) != forms ||
            high - low > UINT32_MAX) {
            break;
        }
        least = low;
        most = high;
        ++length;
    }
    return {length, least};
}

} // namespace

// ---- Packing a list -----------------------------------------------------------------------------

std::size_t packed_bytes(const Scenario& scenario) {
    return bytes_with_forms(forms_of(scenario));
}

Bytes pack_scenarios(std::span<const Scenario> scenarios) {
    ByteWriter out;
    out.put(version);
    put_varint(out, scenarios.size());
    while (!scenarios.empty()) {
        const auto [length, index_least] = run_start(scenarios);
        const Scenario& first = scenarios.front();
        const std::uint8_t forms = forms_of(first);
        put_run_header(out, forms, length, first.body_a, first.body_b, index_least);
        for (const Scenario& scenario : scenarios.first(length)) {
            out.put(static_cast<std::uint32_t>(scenario.index - index_least));
            if (scenario.step) {
                out.put(*scenario.step);
            }
            put_pose(out, scenario.poses.a, form_of_a(forms));
            put_pose(out, scenario.poses.b, form_of_b(forms));
            if (scenario.to && !rests_a(forms)) {
                put_pose(out, scenario.to->a, Form::Quaternion);
            }
            if (scenario.to) {
                put_pose(out, scenario.to->b, Form::Quaternion);
            }
        }
        scenarios = scenarios.subspan(length);
    }
    return out.take();
}

Bytes PackedScenarios::join(std::span<const Slice> slices) {
    ByteWriter out;
    std::uint64_t count = 0;
    for (const Slice& slice : slices) {
        count += slice.count;
    }
    out.put(version);
    put_varint(out, count);
    for (const Slice& slice : slices) {
        std::uint64_t next = slice.first;
        const std::uint64_t end = slice.first + slice.count;
        CD_CHECK(end <= slice.list->count());
        while (next < end) {
            const Run& run = slice.list->runs_[slice.list->run_of(next)];
            const std::uint64_t length = std::min(end, run.first + run.count) - next;
            put_run_header(out, run.forms, length, run.body_a, run.body_b, run.index_least);
            put_bytes(out, slice.list->bytes_of(run, next, length));
            next += length;
        }
    }
    return out.take();
}

// ---- Unpacking ----------------------------------------------------------------------------------

/// Reads a run's header. Returns nothing if it is malformed or the run does not fit `in`.
std::optional<PackedScenarios::Run> PackedScenarios::get_run(ByteReader& in) {
    Run run;
    run.forms = in.get<std::uint8_t>();
    const auto length = get_varint(in);
    const auto body_a = get_varint(in);
    const auto body_b = get_varint(in);
    const auto index_least = get_varint(in);
    if (run.forms > forms_max || !are_consistent(run.forms) || !length || *length == 0 || !body_a ||
        !body_b || !index_least || *body_a > UINT32_MAX || *body_b > UINT32_MAX ||
        *index_least > UINT64_MAX - UINT32_MAX ||
        *length > in.remaining() / bytes_with_forms(run.forms)) {
        return std::nullopt;
    }
    run.body_a = static_cast<std::uint32_t>(*body_a);
    run.body_b = static_cast<std::uint32_t>(*body_b);
    run.index_least = *index_least;
    run.count = *length;
    return run;
}

Result<PackedScenarios> PackedScenarios::open(Bytes bytes, std::uint64_t count_max) {
    PackedScenarios packed;
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
    while (packed.count() < *count) {
        std::optional<Run> run = get_run(in);
        if (!run || run->count > *count - packed.count()) {
            return bad_frame("a run that is malformed or cut short");
        }
        run->first = packed.count();
        run->offset = bytes.size() - in.remaining();
        (void)in.get_bytes(run->count * bytes_with_forms(run->forms));
        packed.runs_.push_back(*run);
    }
    if (!in.complete()) {
        return bad_frame("bytes left over");
    }
    packed.bytes_ = std::move(bytes);
    return packed;
}

std::size_t PackedScenarios::run_of(std::uint64_t i) const {
    CD_CHECK(i < count());
    const auto after = std::ranges::upper_bound(runs_, i, {}, &Run::first);
    return static_cast<std::size_t>(after - runs_.begin()) - 1;
}

std::span<const std::byte>
PackedScenarios::bytes_of(const Run& run, std::uint64_t i, std::uint64_t count) const {
    const std::size_t each = bytes_with_forms(run.forms);
    return std::span(bytes_).subspan(run.offset + (i - run.first) * each, count * each);
}

std::uint64_t PackedScenarios::index_at(std::uint64_t i) const {
    const Run& run = runs_[run_of(i)];
    return run.index_least + ByteReader(bytes_of(run, i, 1)).get<std::uint32_t>();
}

ScenarioBodies PackedScenarios::bodies_at(std::uint64_t i) const {
    const Run& run = runs_[run_of(i)];
    ByteReader in(bytes_of(run, i, 1));
    (void)in.get<std::uint32_t>(); // The index.
    const auto step = have_steps(run.forms) ? std::optional(in.get<std::uint64_t>()) : std::nullopt;
    return {run.body_a, run.body_b, step};
}

Result<Scenario> PackedScenarios::at(std::uint64_t i) const {
    const Run& run = runs_[run_of(i)];
    ByteReader in(bytes_of(run, i, 1));
    const std::uint64_t index = run.index_least + in.get<std::uint32_t>();
    const auto step = have_steps(run.forms) ? std::optional(in.get<std::uint64_t>()) : std::nullopt;
    const auto a = get_pose(in, form_of_a(run.forms));
    const auto b = a ? get_pose(in, form_of_b(run.forms)) : std::nullopt;
    if (!b) {
        return bad_pose(a ? "b" : "a", index);
    }
    Scenario scenario{index, run.body_a, run.body_b, PosePair{*a, *b}, step};
    if (are_motions(run.forms)) {
        const auto to_a = rests_a(run.forms) ? a : get_pose(in, Form::Quaternion);
        const auto to_b = to_a ? get_pose(in, Form::Quaternion) : std::nullopt;
        if (!to_b) {
            return bad_pose(to_a ? "b" : "a", index);
        }
        scenario.to = PosePair{*to_a, *to_b};
    }
    return scenario;
}

Result<std::vector<Scenario>> unpack_scenarios(std::span<const std::byte> bytes,
                                               std::uint64_t count_max) {
    const auto packed = PackedScenarios::open(Bytes(bytes.begin(), bytes.end()), count_max);
    if (!packed) {
        return packed.error();
    }
    std::vector<Scenario> scenarios;
    scenarios.reserve(packed.value().count());
    for (std::uint64_t i = 0; i < packed.value().count(); ++i) {
        Result<Scenario> scenario = packed.value().at(i);
        if (!scenario) {
            return scenario.error();
        }
        scenarios.push_back(scenario.value());
    }
    return scenarios;
}

} // namespace cd
