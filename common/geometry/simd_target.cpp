#include "common/geometry/simd_target.hpp"

#include "common/geometry/highway_targets.hpp"

#include <hwy/highway.h>

#include <array>
#include <cstdlib>
#include <string>
#include <vector>

namespace cd {

namespace {

struct Name {
    SimdTarget target;
    std::string_view text;
    std::int64_t bits; ///< Highway's bits of the target.
};

constexpr std::int64_t avx512_bits = HWY_AVX3 | HWY_AVX3_DL;
constexpr std::array<Name, 5> names{{
    {SimdTarget::Avx512, "avx512", avx512_bits},
    {SimdTarget::Avx2, "avx2", HWY_AVX2},
    {SimdTarget::Sse4, "sse4", HWY_SSE4},
    {SimdTarget::Neon, "neon", HWY_NEON},
    {SimdTarget::Scalar, "scalar", HWY_SCALAR | HWY_EMU128},
}};

constexpr std::string_view automatic = "auto";

const Name& name_of(SimdTarget target) {
    return names[static_cast<std::size_t>(target)];
}

std::vector<SimdTarget> find_available() {
    std::vector<SimdTarget> found;
    // The static target always runs, although Highway reports no NEON on processors without AES
    // instructions, which this code does not use.
    const std::int64_t bits = (hwy::SupportedTargets() | HWY_STATIC_TARGET) & HWY_TARGETS;
    for (const Name& name : names) {
        if ((bits & name.bits) != 0) {
            found.push_back(name.target);
        }
    }
    return found;
}

Result<SimdTarget> find_target(std::string_view text) {
    if (text == automatic) {
        return available_simd_targets().front();
    }
    std::string known{automatic};
    for (const SimdTarget target : available_simd_targets()) {
        if (to_text(target) == text) {
            return target;
        }
        known += ", " + std::string(to_text(target));
    }
    return Error{ErrorCode::BadInput,
                 "no SIMD target \"" + std::string(text) + "\" on this host; there are " + known};
}

void use(SimdTarget target) {
    hwy::GetChosenTarget().Update(name_of(target).bits);
}

/// Returns the environment variable CD_SIMD, or "auto" if it is unset or empty.
std::string_view setting() {
    const char* text = std::getenv("CD_SIMD"); // NOLINT(concurrency-mt-unsafe): never set here.
    return text != nullptr && *text != 0 ? text : automatic;
}

/// Chooses the target on the first call, before Highway does, which would ignore CD_SIMD.
void choose_once() {
    [[maybe_unused]] static const bool chosen = [] {
        const auto wanted = find_target(setting());
        use(wanted ? wanted.value() : available_simd_targets().front());
        return true;
    }();
}

} // namespace

std::string_view to_text(SimdTarget target) {
    return name_of(target).text;
}

std::span<const SimdTarget> available_simd_targets() {
    static const std::vector<SimdTarget> available = find_available();
    return available;
}

SimdTarget simd_target() {
    choose_once();
    const std::size_t in_use = hwy::GetChosenTarget().GetIndex();
    for (const SimdTarget target : available_simd_targets()) {
        hwy::ChosenTarget one;
        one.Update(name_of(target).bits);
        if (one.GetIndex() == in_use) {
            return target;
        }
    }
    return available_simd_targets().back();
}

Status force_simd_target(std::string_view name) {
    choose_once();
    const auto wanted = find_target(name);
    if (!wanted) {
        return wanted.error();
    }
    use(wanted.value());
    return Done{};
}

Status check_simd_environment() {
    const auto wanted = find_target(setting());
    return wanted ? Status(Done{}) : Status(wanted.error());
}

} // namespace cd
