// Encodes the members of each message in the order of their declaration (PROTOCOL.md). Only the
// codec includes this.
#pragma once

#include "proto/codec/members.hpp"
#include "proto/codec/message.hpp"
#include "proto/codec/wire_archive.hpp"

#include <type_traits>

namespace cd {

/// The values of an enumeration that may be sent.
template <class E>
struct EnumRange {
    E first;
    E last;
};

constexpr EnumRange<Level> range_of(Level /*of*/) {
    return {Level::Any, Level::Contacts};
}
constexpr EnumRange<Role> range_of(Role /*of*/) {
    return {Role::Worker, Role::Joiner};
}
constexpr EnumRange<ErrorCode> range_of(ErrorCode /*of*/) {
    return {ErrorCode::BadInput, ErrorCode::Interrupted};
}
constexpr EnumRange<SubtreeForm> range_of(SubtreeForm /*of*/) {
    return {SubtreeForm::Binary, SubtreeForm::Wide};
}
constexpr EnumRange<PeerOutcome> range_of(PeerOutcome /*of*/) {
    return {PeerOutcome::Given, PeerOutcome::Refused};
}
constexpr EnumRange<AnalysisMode> range_of(AnalysisMode /*of*/) {
    return {AnalysisMode::Auto, AnalysisMode::Never};
}
constexpr EnumRange<IdKind> range_of(IdKind /*of*/) {
    return {IdKind::None, IdKind::Text};
}
constexpr EnumRange<PosesKind> range_of(PosesKind /*of*/) {
    return {PosesKind::Grid, PosesKind::Random};
}
constexpr EnumRange<JobState> range_of(JobState /*of*/) {
    return {JobState::Running, JobState::Failed};
}
constexpr EnumRange<WorkerState> range_of(WorkerState /*of*/) {
    return {WorkerState::Alive, WorkerState::Lost};
}
constexpr EnumRange<CertifiedRole> range_of(CertifiedRole /*of*/) {
    return {CertifiedRole::Master, CertifiedRole::Metrics};
}

/// Reads or writes a member; an enumeration takes one byte.
template <class Archive, class T>
void exchange_member(Archive& archive, T& member) {
    if constexpr (std::is_enum_v<T>) {
        const auto range = range_of(member);
        auto byte = static_cast<std::uint8_t>(member);
        archive(byte);
        const bool is_known = byte >= static_cast<std::uint8_t>(range.first) &&
                              byte <= static_cast<std::uint8_t>(range.last);
        if constexpr (Archive::is_input) {
            if (!is_known) {
                throw WireError("an enumeration's value out of range");
            }
            member = static_cast<T>(byte);
        } else {
            CD_CHECK(is_known);
        }
    } else {
        archive(member);
    }
}

/// Marks the structs whose members are encoded one by one.
template <class T>
concept MemberByMember = std::is_aggregate_v<T> && std::is_class_v<T> && !std::is_empty_v<T> &&
                         !is_flat<T> && !is_array<T>;

template <class Archive, MemberByMember T>
void serialize(Archive& archive, T& value) {
    visit_members(value, [&](auto&... members) { (exchange_member(archive, members), ...); });
}

/// Omits the counts of tests, which stay on the machine that made them.
template <class Archive>
void serialize(Archive& archive, InsideStatistics& s) {
    archive(s.scenarios, s.seconds);
}

/// Reads no further than the version if the version is another.
template <class Archive>
void serialize(Archive& archive, Hello& hello) {
    visit_members(hello, [&](std::uint16_t& its_version, auto&... members) {
        archive(its_version);
        if constexpr (Archive::is_input) {
            if (its_version != protocol_version) {
                archive.skip_rest();
                return;
            }
        }
        (exchange_member(archive, members), ...);
    });
}

} // namespace cd
