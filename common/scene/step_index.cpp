#include "common/scene/step_index.hpp"

#include "common/core/check.hpp"
#include "common/core/errors.hpp"
#include "common/core/files/compress.hpp"
#include "common/core/varint.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

namespace cd {

StepCoverage& StepCoverage::operator+=(const StepCoverage& other) {
    tested += other.tested;
    apart += other.apart;
    ignored += other.ignored;
    fixed += other.fixed;
    absent += other.absent;
    return *this;
}

void StepIndex::add_step(const StepCoverage& coverage) {
    ends_.push_back(count() + coverage.tested);
    coverage_.push_back(coverage);
}

void StepIndex::set_times(std::vector<double> times) {
    CD_CHECK(times.empty() || times.size() == ends_.size() || times.size() == ends_.size() + 1);
    times_ = std::move(times);
}

std::uint64_t StepIndex::first_of(std::uint64_t step) const {
    CD_CHECK(step < ends_.size());
    return step == 0 ? 0 : ends_[step - 1];
}

std::uint64_t StepIndex::end_of(std::uint64_t step) const {
    CD_CHECK(step < ends_.size());
    return ends_[step];
}

std::uint64_t StepIndex::step_of(std::uint64_t scenario) const {
    CD_CHECK(scenario < count());
    const auto end = std::ranges::upper_bound(ends_, scenario);
    return static_cast<std::uint64_t>(end - ends_.begin());
}

double StepIndex::time_of(std::uint64_t step) const {
    CD_CHECK(step < ends_.size());
    return times_.empty() ? static_cast<double>(step) : times_[step];
}

double StepIndex::time_at(std::uint64_t step, double tau) const {
    CD_CHECK(step < ends_.size());
    if (times_.size() <= ends_.size()) {
        return time_of(step) + tau;
    }
    return std::lerp(times_[step], times_[step + 1], tau);
}

// ---- Packing ------------------------------------------------------------------------------------

namespace {

constexpr std::uint8_t version = 1;
constexpr int compression_level = 3;
/// Unpacked steps may have so many bytes: some ten million steps.
constexpr std::size_t bytes_max = 512u << 20;

Error damaged(const char* what) {
    return {ErrorCode::BadFrame, std::string("packed steps: ") + what};
}

/// Reads what became of the pairs of a step. Returns nothing if it is cut short.
std::optional<StepCoverage> get_coverage(ByteReader& in) {
    StepCoverage coverage;
    for (std::uint64_t* number : {&coverage.tested,
                                  &coverage.apart,
                                  &coverage.ignored,
                                  &coverage.fixed,
                                  &coverage.absent}) {
        const auto value = get_varint(in);
        if (!value) {
            return std::nullopt;
        }
        *number = *value;
    }
    return coverage;
}

/// Kinds of times: that of each step, and also that of the last one's end.
constexpr std::uint8_t with_begins = 1;
constexpr std::uint8_t with_end = 2;

std::uint8_t times_kind(const StepIndex& steps) {
    return steps.times().empty()                   ? 0
           : steps.times().size() == steps.steps() ? with_begins
                                                   : with_end;
}

std::size_t times_in(std::uint8_t kind, std::uint64_t steps) {
    return kind == 0 ? 0 : steps + (kind == with_end ? 1 : 0);
}

} // namespace

Bytes pack_steps(const StepIndex& steps) {
    ByteWriter out;
    out.put(version);
    put_varint(out, steps.steps());
    out.put(times_kind(steps));
    for (const StepCoverage& step : steps.coverage()) {
        for (const std::uint64_t number :
             {step.tested, step.apart, step.ignored, step.fixed, step.absent}) {
            put_varint(out, number);
        }
    }
    out.put_array(steps.times());
    return compress(out.bytes(), compression_level);
}

Result<std::shared_ptr<const StepIndex>> unpack_steps(std::span<const std::byte> bytes,
                                                      std::uint64_t scenarios) {
    const Bytes plain = CD_TRY(decompress(bytes, bytes_max));
    ByteReader in(plain);
    if (in.get<std::uint8_t>() != version) {
        return damaged("unknown version");
    }
    const auto count = get_varint(in);
    const auto kind = in.get<std::uint8_t>();
    if (!count || *count == 0 || *count > in.remaining() || kind > with_end) {
        return damaged("no number of steps");
    }
    auto steps = std::make_shared<StepIndex>();
    for (std::uint64_t i = 0; i < *count; ++i) {
        const auto coverage = get_coverage(in);
        if (!coverage || coverage->tested > scenarios - steps->count()) {
            return damaged("a step that is cut short, or has too many scenarios");
        }
        steps->add_step(*coverage);
    }
    std::vector<double> times = in.get_array<double>(times_in(kind, *count));
    const bool are_finite =
        std::ranges::all_of(times, [](double time) { return std::isfinite(time); });
    if (!in.complete() || !are_finite || steps->count() != scenarios) {
        return damaged("times or scenarios that do not fit");
    }
    steps->set_times(std::move(times));
    return std::shared_ptr<const StepIndex>(std::move(steps));
}

} // namespace cd
