// What `cdctl doctor` finds.
#pragma once

#include <span>
#include <string>

namespace cd {

/// One line of the doctor.
struct Finding {
    enum class Grade { Ok, Warn, Fail };

    Grade grade = Grade::Ok;
    std::string topic; ///< "tree cache"
    std::string text;  ///< What was found; for a fault also what to do.

    friend bool operator==(const Finding&, const Finding&) = default;
};

/// Returns the findings as lines: grade, topic and text in columns.
[[nodiscard]] std::string findings_text(std::span<const Finding> findings);
/// Returns the findings as a JSON array of objects.
[[nodiscard]] std::string findings_json(std::span<const Finding> findings);

} // namespace cd
