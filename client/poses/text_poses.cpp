#include "client/poses/text_poses.hpp"

#include "client/import/text/text_reader.hpp"
#include "common/core/errors.hpp"
#include "common/core/limits/engine.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

namespace cd {

namespace {

Error bad(std::uint64_t line, const std::string& detail) {
    return bad_input("line " + std::to_string(line) + ": " + detail);
}

Error cut_short(std::uint64_t lines) {
    return {ErrorCode::Io, "cannot be read beyond line " + std::to_string(lines)};
}

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

/// Replaces each doubled quote by one quote (RFC 4180).
std::string with_single_quotes(std::string_view text) {
    std::string single;
    for (std::size_t i = 0; i < text.size(); ++i) {
        single += text[i];
        i += text.substr(i).starts_with("\"\"") ? 1 : 0;
    }
    return single;
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

std::vector<std::string_view>
split(std::string_view line, std::string_view separators, bool joins) {
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

PoseTable make_table(std::vector<double> numbers, PoseLayout layout, bool of_both_bodies) {
    NpyArray array;
    const std::uint64_t row = numbers_of(layout) * (of_both_bodies ? 2 : 1);
    array.shape = {numbers.size() / row, row};
    const auto bytes = std::as_bytes(std::span(numbers));
    array.data.assign(bytes.begin(), bytes.end());
    return {NpyRows::of(std::move(array)), layout, of_both_bodies};
}

enum class ColumnSet { Quaternion, Matrix, Euler };

/// The position of a missing column, each of whose numbers is 0.
constexpr std::size_t no_column = static_cast<std::size_t>(-1);

/// The column that holds one number of a pose, and the factor for that number.
struct NumberColumn {
    std::size_t index = no_column;
    double factor = 1;
};

struct Columns {
    ColumnSet set = ColumnSet::Quaternion;
    std::vector<NumberColumn> numbers; ///< In layout order; factors convert radians to degrees.
    std::vector<std::string> zeros;    ///< Names of missing columns, which count as 0.
    std::size_t scenario = no_column;
    std::size_t body = no_column;
    std::size_t id = no_column;
    std::size_t time = no_column;
    std::size_t count = 0;
};

constexpr std::string_view known_columns =
    "the first line must name x,y,z,qx,qy,qz,qw or m00 to m23, or some of x, y, z, roll_deg, "
    "pitch_deg, yaw_deg (or roll_rad, pitch_rad, yaw_rad)";
constexpr std::array<std::string_view, 3> angle_names{"roll", "pitch", "yaw"};
constexpr double degrees_per_radian = 180 / std::numbers::pi;

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
        for (const std::string_view word : split(line, ",", false)) {
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
            return bad(line,
                       "column '" + name + "' does not say its unit: name it " + name + "_deg or " +
                           name + "_rad");
        }
        if (names.has(name + "_deg") && names.has(name + "_rad")) {
            return bad(line, "columns '" + name + "_deg' and '" + name + "_rad' are one angle");
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
Status find_numbers(const HeaderNames& names, std::uint64_t line, Columns& columns) {
    for (const std::string_view wanted : names_of(columns.set)) {
        const std::string name(wanted);
        columns.numbers.push_back(find_column(names, name, columns.set));
        if (columns.numbers.back().index != no_column) {
            continue;
        }
        columns.zeros.push_back(name);
        if (columns.set != ColumnSet::Euler) {
            return bad(line, "there is no column '" + name + "'; " + std::string(known_columns));
        }
    }
    if (columns.zeros.size() == columns.numbers.size()) {
        return bad(line, "there is no column of a pose; " + std::string(known_columns));
    }
    return Done{};
}

/// Checks all column names. Errors: BadInput for an unknown or a repeated column.
Status check_others(const HeaderNames& names, std::uint64_t line, const Columns& columns) {
    constexpr std::array<std::string_view, 6> others{"id", "t", "time", "name", "scenario", "body"};
    for (std::size_t i = 0; i < names.all().size(); ++i) {
        const std::string& name = names.all()[i];
        const bool is_number =
            std::ranges::any_of(columns.numbers, [&](const NumberColumn& column) {
                return column.index != no_column && names.all()[column.index] == name;
            });
        if (!is_number && std::find(others.begin(), others.end(), name) == others.end()) {
            return bad(line, "column '" + name + "' is not known; " + std::string(known_columns));
        }
        if (names.index_of(name) != i) {
            return bad(line, "column '" + name + "' appears twice");
        }
    }
    return Done{};
}

/// Checks the columns that name scenario and body. Errors: BadInput if one of them is missing for
/// poses of both bodies, or if `scenario` is given for poses of one body.
Status check_bodies(const HeaderNames& names, std::uint64_t line, bool of_both_bodies) {
    if (of_both_bodies && (!names.has("scenario") || !names.has("body"))) {
        return bad(line, "poses of both bodies need the columns 'scenario' and 'body'");
    }
    if (!of_both_bodies && names.has("scenario")) {
        return bad(line,
                   "column 'scenario' is for poses of both bodies; say of = \"both\" (--both), or "
                   "leave it out");
    }
    return Done{};
}

Result<Columns> read_header(std::string_view line, std::uint64_t number, bool of_both_bodies) {
    const HeaderNames names(line);
    Columns columns;
    columns.count = names.all().size();
    columns.set = names.has("qx") || names.has("qw") ? ColumnSet::Quaternion
                  : names.has("m00")                 ? ColumnSet::Matrix
                                                     : ColumnSet::Euler;
    columns.scenario = names.index_of("scenario");
    columns.body = names.index_of("body");
    columns.id = names.index_of("id");
    columns.time = names.index_of("t");
    CD_TRY(check_angles(names, number));
    CD_TRY(find_numbers(names, number, columns));
    CD_TRY(check_others(names, number, columns));
    CD_TRY(check_bodies(names, number, of_both_bodies));
    return columns;
}

/// Reads the numbers of one line, as a matrix or as x y z qx qy qz qw.
Result<std::vector<double>> read_numbers(const std::vector<std::string_view>& words,
                                         const Columns& columns,
                                         std::uint64_t line) {
    std::vector<double> numbers;
    for (std::size_t i = 0; i < columns.numbers.size(); ++i) {
        const NumberColumn& column = columns.numbers[i];
        if (column.index == no_column) {
            numbers.push_back(0);
            continue;
        }
        const std::string_view word = words[column.index];
        const auto number = to_number(word);
        if (!number || !std::isfinite(column.factor * *number)) {
            return bad(line,
                       std::string(names_of(columns.set)[i]) + " is '" + std::string(word) +
                           "', not a number");
        }
        numbers.push_back(column.factor * *number);
    }
    if (columns.set == ColumnSet::Euler) {
        const Quaternion q = quaternion_from_euler(numbers[3], numbers[4], numbers[5]);
        numbers.resize(3);
        numbers.insert(numbers.end(), {q.x, q.y, q.z, q.w});
    }
    return numbers;
}

/// Adds a row's time to the labels. Errors: BadInput for anything but a finite number.
Status add_time(std::string_view word, std::uint64_t line, PoseLabels& labels) {
    const auto time = to_number(word);
    if (!time || !std::isfinite(*time)) {
        return bad(line, "t is '" + std::string(word) + "', not a number");
    }
    labels.times.push_back(*time);
    return Done{};
}

/// Adds a row's id and time to the labels, as far as the file has them. Errors: BadInput for an id
/// that is too long, and for a time that is not a number.
Status add_labels(const std::vector<std::string_view>& words,
                  const Columns& columns,
                  std::uint64_t line,
                  PoseLabels& labels) {
    if (columns.id != no_column) {
        const std::string id = with_single_quotes(words[columns.id]);
        if (id.size() > limits::label_bytes_max) {
            return bad(line,
                       "the id is longer than " + std::to_string(limits::label_bytes_max) +
                           " bytes");
        }
        add_pose_id(labels, id);
    }
    return columns.time == no_column ? Status(Done{}) : add_time(words[columns.time], line, labels);
}

bool is_body_a(std::string_view word) {
    return word == "a" || word == "A" || word == "0";
}

bool is_body_b(std::string_view word) {
    return word == "b" || word == "B" || word == "1";
}

/// Collects rows with `scenario` and `body`, in any order, into pairs of poses.
class BothBodies {
  public:
    explicit BothBodies(std::size_t numbers) : numbers_(numbers) {}

    Status add(std::string_view scenario_word,
               std::string_view body_word,
               const std::vector<double>& numbers,
               std::uint64_t line) {
        const auto scenario = to_number(scenario_word);
        const bool is_count = scenario && 0 <= *scenario && *scenario < rows_max &&
                              std::floor(*scenario) == *scenario;
        const bool is_a = is_body_a(body_word);
        const bool is_b = is_body_b(body_word);
        if (!is_count || (!is_a && !is_b)) {
            return bad(line,
                       "scenario '" + std::string(scenario_word) + "', body '" +
                           std::string(body_word) + "': a count from 0, and a or b are expected");
        }
        const std::size_t slot = 2 * static_cast<std::size_t>(*scenario) + (is_b ? 1 : 0);
        if (slot >= seen_.size()) {
            // Refuses a large gap, which only a broken file has, though rows may have any order.
            if (slot > 2 * (rows_ + gap_max)) {
                return bad(line, "scenario " + std::string(scenario_word) + " is far out of order");
            }
            seen_.resize(slot / 2 * 2 + 2, false);
            values_.resize(seen_.size() * numbers_);
            lines_.resize(seen_.size());
        }
        if (seen_[slot]) {
            return bad(line, "scenario " + std::string(scenario_word) + " has this body twice");
        }
        if (is_a) {
            order_.push_back(slot / 2);
        }
        seen_[slot] = true;
        lines_[slot] = line;
        ++rows_;
        std::copy(numbers.begin(),
                  numbers.end(),
                  values_.begin() + static_cast<std::ptrdiff_t>(slot * numbers_));
        return Done{};
    }

    Result<std::vector<double>> finish() {
        const auto missing = std::find(seen_.begin(), seen_.end(), false);
        if (missing != seen_.end()) {
            const auto slot = static_cast<std::size_t>(missing - seen_.begin());
            return bad_input("scenario " + std::to_string(slot / 2) + " has no pose of body " +
                             (slot % 2 == 0 ? "a" : "b"));
        }
        return std::move(values_);
    }
    /// Returns the scenario numbers of the rows of body a, in the order of the file.
    [[nodiscard]] const std::vector<std::size_t>& order() const { return order_; }
    /// Returns the line of each pose that `finish` returns.
    std::vector<std::uint64_t> take_lines() { return std::move(lines_); }

  private:
    static constexpr double rows_max = 1e15;
    static constexpr std::size_t gap_max = 1'000'000;

    std::size_t numbers_;
    std::size_t rows_ = 0;
    std::vector<bool> seen_;
    std::vector<double> values_;
    std::vector<std::size_t> order_;
    std::vector<std::uint64_t> lines_;
};

} // namespace

Result<PoseTable> read_csv_poses(std::istream& in, bool of_both_bodies) {
    std::string line;
    std::uint64_t number = 0;
    std::optional<Columns> columns;
    std::vector<double> values;
    std::vector<std::uint64_t> lines;
    std::optional<BothBodies> both;
    PoseLabels labels;
    while (std::getline(in, line)) {
        ++number;
        if (number == 1 && line.starts_with("\xEF\xBB\xBF")) {
            line.erase(0, 3); // Drops a byte order mark, which spreadsheets write.
        }
        if (is_comment(line)) {
            continue;
        }
        if (!columns) {
            columns = CD_TRY(read_header(line, number, of_both_bodies));
            both.emplace(columns->set == ColumnSet::Matrix ? 12 : 7);
            continue;
        }
        const auto words = split(line, ",", false);
        if (words.size() != columns->count) {
            return bad(number,
                       std::to_string(words.size()) + " values, but the first line names " +
                           std::to_string(columns->count));
        }
        const auto numbers = CD_TRY(read_numbers(words, *columns, number));
        if (!of_both_bodies) {
            if (columns->body != no_column && !is_body_b(words[columns->body])) {
                return bad(number,
                           "a pose of another body than b; poses of both need of = \"both\" "
                           "(--both)");
            }
            values.insert(values.end(), numbers.begin(), numbers.end());
            lines.push_back(number);
        } else {
            CD_TRY(both->add(words[columns->scenario], words[columns->body], numbers, number));
        }
        if (!of_both_bodies || is_body_a(words[columns->body])) {
            CD_TRY(add_labels(words, *columns, number, labels));
        }
    }
    if (in.bad()) {
        return cut_short(number);
    }
    if (!columns) {
        return bad_input("there is no line that names the columns");
    }
    if (of_both_bodies) {
        values = CD_TRY(both->finish());
        lines = both->take_lines();
    }
    PoseTable table =
        make_table(std::move(values),
                   columns->set == ColumnSet::Matrix ? PoseLayout::Matrix34 : PoseLayout::Xyzw,
                   of_both_bodies);
    table.from_angles = columns->set == ColumnSet::Euler;
    table.zeros = std::move(columns->zeros);
    table.lines = std::move(lines);
    table.labels = of_both_bodies ? labels.moved_to(both->order()) : std::move(labels);
    return table;
}

Result<PoseTable> read_tum_poses(std::istream& in) {
    std::string line;
    std::uint64_t number = 0;
    std::vector<double> values;
    std::vector<std::uint64_t> lines;
    PoseLabels labels;
    while (std::getline(in, line)) {
        ++number;
        if (is_comment(line)) {
            continue;
        }
        const auto words = split(line, " \t", true);
        if (words.size() != 8) {
            return bad(number,
                       std::to_string(words.size()) +
                           " numbers where TUM has 8: time x y z qx qy qz qw");
        }
        CD_TRY(add_time(words[0], number, labels));
        for (std::size_t i = 1; i < words.size(); ++i) {
            const auto value = to_number(words[i]);
            if (!value) {
                return bad(number, "'" + std::string(words[i]) + "' is not a number");
            }
            values.push_back(*value);
        }
        lines.push_back(number);
    }
    if (in.bad()) {
        return cut_short(number);
    }
    PoseTable table = make_table(std::move(values), PoseLayout::Xyzw, false);
    table.lines = std::move(lines);
    table.labels = std::move(labels);
    return table;
}

} // namespace cd
