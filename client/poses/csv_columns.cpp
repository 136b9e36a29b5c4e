#include "client/poses/csv_columns.hpp"

#include "client/import/text/text_reader.hpp"
#include "common/core/errors.hpp"
#include "common/job/poses/pose_source.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace cd {

namespace {

std::string_view without_blanks(std::string_view text) {
    constexpr std::string_view blanks = " \t\r";
    const std::size_t first = text.find_first_not_of(blanks);
    return first == std::string_view::npos
               ? std::string_view{}
               : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// Removes blanks and one pair of quotes around a text.
std::string_view trimmed(std::string_view text) {
    text = without_blanks(text);
    const bool is_quoted = text.size() >= 2 && text.front() == '"' && text.back() == '"';
    return is_quoted ? without_blanks(text.substr(1, text.size() - 2)) : text;
}

/// Returns the position of the first separator outside quotes; npos if there is none.
std::size_t end_of_word(std::string_view line, std::string_view separators) {
    bool is_quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        is_quoted = is_quoted != (line[i] == '"');
        if (!is_quoted && separators.find(line[i]) != std::string_view::npos) {
            return i;
        }
    }
    return std::string_view::npos;
}

constexpr std::string_view known_columns =
    "the first line must name x,y,z,qx,qy,qz,qw or m00 to m23, or some of x, y, z, roll_deg, "
    "pitch_deg, yaw_deg (or roll_rad, pitch_rad, yaw_rad)";
constexpr std::array<std::string_view, 3> angle_names{"roll", "pitch", "yaw"};
constexpr double degrees_per_radian = 180 / std::numbers::pi;

/// The columns of a vector: how the body moves from its pose on.
using RateNames = std::array<std::string_view, 3>;
constexpr std::array<RateNames, 3> rate_names{
    RateNames{"vx", "vy", "vz"}, RateNames{"ax", "ay", "az"}, RateNames{"wx", "wy", "wz"}};
constexpr RateNames spin_in_degrees{"wx_deg", "wy_deg", "wz_deg"};

const std::vector<std::string_view>& names_of(ColumnSet set) {
    static const std::vector<std::string_view> quaternion{"x", "y", "z", "qx", "qy", "qz", "qw"};
    static const std::vector<std::string_view> euler{"x", "y", "z", "roll", "pitch", "yaw"};
    static const std::vector<std::string_view> matrix{
        "m00", "m01", "m02", "m03", "m10", "m11", "m12", "m13", "m20", "m21", "m22", "m23"};
    return set == ColumnSet::Quaternion ? quaternion : set == ColumnSet::Euler ? euler : matrix;
}

/// The names of a file's columns, in lower case.
class HeaderNames {
  public:
    explicit HeaderNames(std::string_view line) {
        for (const std::string_view word : split_line(line, ",", false)) {
            names_.emplace_back(word);
            for (char& c : names_.back()) {
                c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
            }
        }
    }

    [[nodiscard]] const std::vector<std::string>& all() const { return names_; }
    /// Returns the position of a column, or `no_column`.
    [[nodiscard]] std::size_t index_of(std::string_view name) const {
        const auto found = std::ranges::find(names_, name);
        return found == names_.end() ? no_column : static_cast<std::size_t>(found - names_.begin());
    }
    [[nodiscard]] bool has(std::string_view name) const { return index_of(name) != no_column; }

  private:
    std::vector<std::string> names_;
};

/// Checks the angles' names. Errors: BadInput for an angle without a unit, or in both units.
Status check_angles(const HeaderNames& names, std::uint64_t line) {
    for (const std::string_view angle : angle_names) {
        const std::string name(angle);
        if (names.has(name)) {
            return error_in_line(line,
                                 "column '" + name + "' does not say its unit: name it " + name +
                                     "_deg or " + name + "_rad");
        }
        if (names.has(name + "_deg") && names.has(name + "_rad")) {
            return error_in_line(line,
                                 "columns '" + name + "_deg' and '" + name + "_rad' are one angle");
        }
    }
    return Done{};
}

/// Finds the column of one number, under its name with or without a unit.
NumberColumn find_column(const HeaderNames& names, const std::string& name, ColumnSet set) {
    if (names.has(name) || set != ColumnSet::Euler) {
        return {names.index_of(name)};
    }
    return names.has(name + "_rad")
               ? NumberColumn{names.index_of(name + "_rad"), degrees_per_radian}
               : NumberColumn{names.index_of(name + "_deg")};
}

/// Finds the columns of all numbers of a pose. Errors: BadInput for a required column that is
/// missing.
Status find_numbers(const HeaderNames& names, std::uint64_t line, CsvColumns& columns) {
    for (const std::string_view wanted : names_of(columns.set)) {
        const std::string name(wanted);
        columns.numbers.push_back(find_column(names, name, columns.set));
        if (columns.numbers.back().index != no_column) {
            continue;
        }
        columns.zeros.push_back(name);
        if (columns.set != ColumnSet::Euler) {
            return error_in_line(
                line, "there is no column '" + name + "'; " + std::string(known_columns));
        }
    }
    if (columns.zeros.size() == columns.numbers.size()) {
        return error_in_line(line, "there is no column of a pose; " + std::string(known_columns));
    }
    return Done{};
}

/// Returns true if the file has the columns of a vector. Errors: BadInput for one or two of them.
Result<bool> has_rates(const HeaderNames& names, const RateNames& wanted, std::uint64_t line) {
    const auto missing =
        std::ranges::find_if(wanted, [&](std::string_view name) { return !names.has(name); });
    const auto given =
        std::ranges::find_if(wanted, [&](std::string_view name) { return names.has(name); });
    if (given == wanted.end() || missing == wanted.end()) {
        return missing == wanted.end();
    }
    return error_in_line(line,
                         "column '" + std::string(*given) + "' needs column '" +
                             std::string(*missing) + "' as well");
}

/// Finds the columns of velocity, acceleration and spin. Errors: BadInput for one or two columns of
/// three, and for a spin in both units.
Status find_rates(const HeaderNames& names, std::uint64_t line, CsvColumns& columns) {
    const bool has_degrees = CD_TRY(has_rates(names, spin_in_degrees, line));
    bool has_any = has_degrees;
    for (const RateNames& wanted : rate_names) {
        const bool is_spin = &wanted == &rate_names.back();
        const bool has_these = CD_TRY(has_rates(names, wanted, line));
        if (is_spin && has_these && has_degrees) {
            return error_in_line(line, "columns 'wx' and 'wx_deg' are one spin");
        }
        has_any = has_any || has_these;
        const RateNames& found = is_spin && has_degrees ? spin_in_degrees : wanted;
        for (const std::string_view name : found) {
            columns.rates.push_back(
                {names.index_of(name), is_spin && has_degrees ? 1 / degrees_per_radian : 1});
        }
    }
    if (!has_any) {
        columns.rates.clear();
    }
    return Done{};
}

/// Checks all column names. Errors: BadInput for an unknown or a repeated column.
Status check_others(const HeaderNames& names, std::uint64_t line, const CsvColumns& columns) {
    constexpr std::array<std::string_view, 7> others{
        "id", "t", "time", "name", "scenario", "step", "body"};
    for (std::size_t i = 0; i < names.all().size(); ++i) {
        const std::string& name = names.all()[i];
        const auto is_this = [&](const NumberColumn& column) {
            return column.index != no_column && names.all()[column.index] == name;
        };
        const bool is_number = std::ranges::any_of(columns.numbers, is_this) ||
                               std::ranges::any_of(columns.rates, is_this);
        if (!is_number && std::find(others.begin(), others.end(), name) == others.end()) {
            return error_in_line(
                line, "column '" + name + "' is not known; " + std::string(known_columns));
        }
        if (names.index_of(name) != i) {
            return error_in_line(line, "column '" + name + "' appears twice");
        }
    }
    return Done{};
}

/// Checks the columns that name scenario, step and body. Errors: BadInput for one that is missing,
/// or that belongs to other rows.
Status check_bodies(const HeaderNames& names, std::uint64_t line, CsvRows rows) {
    if (rows == CsvRows::Scene && (!names.has("step") || !names.has("body"))) {
        return error_in_line(line, "poses of a scene need the columns 'step' and 'body'");
    }
    if (rows == CsvRows::BothBodies && (!names.has("scenario") || !names.has("body"))) {
        return error_in_line(line, "poses of both bodies need the columns 'scenario' and 'body'");
    }
    if (rows == CsvRows::Scene && names.has("scenario")) {
        return error_in_line(line, "column 'scenario' is for two bodies; a scene has 'step'");
    }
    if (rows != CsvRows::Scene && names.has("step")) {
        return error_in_line(line, "column 'step' is for the [poses] of a job with [bodies]");
    }
    if (rows == CsvRows::BodyB && names.has("scenario")) {
        return error_in_line(
            line,
            "column 'scenario' is for poses of both bodies; say of = \"both\" (--both), or "
            "leave it out");
    }
    return Done{};
}

/// Reads a number. Nothing for a word that is no number, and for one that becomes infinite.
std::optional<double> number_of(std::string_view word, double factor) {
    const auto number = to_number(word);
    const double value = factor * number.value_or(0);
    return number && !std::isinf(value) ? std::optional(value) : std::nullopt;
}

/// Computes the quaternion of the angles behind a translation, and puts it in their place.
void turn_angles(std::vector<double>& numbers) {
    const Quaternion q = quaternion_from_euler(numbers[3], numbers[4], numbers[5]);
    numbers.resize(3);
    numbers.insert(numbers.end(), {q.x, q.y, q.z, q.w});
}

} // namespace

Error error_in_line(std::uint64_t line, const std::string& detail) {
    return bad_input("line " + std::to_string(line) + ": " + detail);
}

std::vector<std::string_view>
split_line(std::string_view line, std::string_view separators, bool joins) {
    std::vector<std::string_view> words;
    while (true) {
        const std::size_t end = end_of_word(line, separators);
        const std::string_view word = trimmed(line.substr(0, end));
        if (!joins || !word.empty()) {
            words.push_back(word);
        }
        if (end == std::string_view::npos) {
            return words;
        }
        line.remove_prefix(end + 1);
    }
}

bool is_comment(std::string_view line) {
    const std::string_view text = trimmed(line);
    return text.empty() || text.front() == '#';
}

Result<CsvColumns> read_csv_header(std::string_view line, std::uint64_t number, CsvRows rows) {
    const HeaderNames names(line);
    CsvColumns columns;
    columns.count = names.all().size();
    columns.set = names.has("qx") || names.has("qw") ? ColumnSet::Quaternion
                  : names.has("m00")                 ? ColumnSet::Matrix
                                                     : ColumnSet::Euler;
    columns.scenario = names.index_of("scenario");
    columns.step = names.index_of("step");
    columns.body = names.index_of("body");
    columns.id = names.index_of("id");
    columns.time = names.index_of("t");
    CD_TRY(check_angles(names, number));
    CD_TRY(find_numbers(names, number, columns));
    CD_TRY(find_rates(names, number, columns));
    CD_TRY(check_others(names, number, columns));
    CD_TRY(check_bodies(names, number, rows));
    return columns;
}

Result<std::vector<double>> read_csv_numbers(const std::vector<std::string_view>& words,
                                             const CsvColumns& columns,
                                             std::uint64_t line,
                                             bool allows_nan) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    std::vector<double> numbers;
    std::optional<std::size_t> first_nan;
    bool has_finite = false;
    for (std::size_t i = 0; i < columns.numbers.size(); ++i) {
        const NumberColumn& column = columns.numbers[i];
        if (column.index == no_column) {
            numbers.push_back(0);
            continue;
        }
        const auto number = number_of(words[column.index], column.factor);
        const bool is_nan = !number || std::isnan(*number);
        first_nan = is_nan && !first_nan ? std::optional(i) : first_nan;
        has_finite = has_finite || !is_nan;
        if (!number || (is_nan && !allows_nan) || (first_nan && has_finite)) {
            const std::size_t bad = is_nan ? i : *first_nan;
            return error_in_line(line,
                                 std::string(names_of(columns.set)[bad]) + " is '" +
                                     std::string(words[columns.numbers[bad].index]) +
                                     "', not a number");
        }
        numbers.push_back(*number);
    }
    if (first_nan) {
        return std::vector<double>(columns.numbers_each(), nan);
    }
    if (columns.set == ColumnSet::Euler) {
        turn_angles(numbers);
    }
    return numbers;
}

Result<std::vector<double>> read_csv_rates(const std::vector<std::string_view>& words,
                                           const CsvColumns& columns,
                                           std::uint64_t line) {
    std::vector<double> rates;
    for (std::size_t i = 0; i < columns.rates.size(); ++i) {
        const NumberColumn& column = columns.rates[i];
        if (column.index == no_column) {
            rates.push_back(0);
            continue;
        }
        const auto number = number_of(words[column.index], column.factor);
        if (!number || std::isnan(*number)) {
            return error_in_line(line,
                                 std::string(rate_names[i / 3][i % 3]) + " is '" +
                                     std::string(words[column.index]) + "', not a number");
        }
        rates.push_back(*number);
    }
    return rates;
}

} // namespace cd
