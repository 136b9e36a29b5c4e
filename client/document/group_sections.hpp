// The sections of a report about groups of contacts.
#pragma once

#include "client/compare/group_statuses.hpp"
#include "client/document/html.hpp"
#include "client/document/run_names.hpp"
#include "client/document/run_overview.hpp"
#include "client/folder/run_manifest.hpp"

#include <string>
#include <vector>

namespace cd {

/// How a run compares with its baseline, for the report.
struct BaselineNote {
    std::string name;   ///< How the user named the baseline; empty: there is none.
    std::string digest; ///< Its digest, or why it has none.
    std::vector<std::string> warnings = {}; ///< Also about statuses, without a baseline.
};

/// Writes the matrix of parts, the table of groups, and the comparison with a baseline. All
/// references must outlive the object.
class GroupSections {
  public:
    GroupSections(const RunNames& names,
                  const RunManifest& manifest,
                  const RunOverview& overview,
                  const GroupStatuses& statuses)
        : names_(names), manifest_(manifest), overview_(overview), statuses_(statuses) {}

    /// Each function returns a section, or nothing if there is nothing to say.
    [[nodiscard]] Html matrix() const;
    [[nodiscard]] Html table() const;
    [[nodiscard]] Html against(const BaselineNote& baseline) const;

  private:
    [[nodiscard]] std::vector<Html> row_of(const JudgedGroup& judged, bool has_status) const;
    [[nodiscard]] std::string share_of(const JudgedGroup& judged) const;
    [[nodiscard]] bool is_of_file() const { return manifest_.poses.kind == PosesKind::File; }

    const RunNames& names_;
    const RunManifest& manifest_;
    const RunOverview& overview_;
    const GroupStatuses& statuses_;
};

} // namespace cd
