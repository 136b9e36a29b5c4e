#include "client/poses/text_poses.hpp"

#include "client/import/text/text_reader.hpp"
#include "client/poses/csv_columns.hpp"
#include "common/core/errors.hpp"
#include "common/core/limits/engine.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cd {

namespace {

Error cut_short(std::uint64_t lines) {
    return {ErrorCode::Io, "cannot be read beyond line " + std::to_string(lines)};
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

/// Makes a table of rows with a pose of each body of `bodies`; empty: with one pose.
PoseTable
make_table(std::vector<double> numbers, PoseLayout layout, std::vector<std::string> bodies) {
    NpyArray array;
    const std::uint64_t row = numbers_of(layout) * std::max<std::size_t>(1, bodies.size());
    array.shape = {numbers.size() / row, row};
    const auto bytes = std::as_bytes(std::span(numbers));
    array.data.assign(bytes.begin(), bytes.end());
    return {NpyRows::of(std::move(array)), layout, std::move(bodies)};
}

/// The numbers of the rates of a pose: velocity, acceleration, spin.
constexpr std::size_t rates_size = 9;

/// Takes the rates, which follow the numbers of each pose, out of rows of `size` and `rates_size`
/// numbers.
std::vector<PoseRates> take_rates(std::vector<double>& values, std::size_t size) {
    std::vector<PoseRates> rates;
    std::vector<double> poses;
    for (std::size_t row = 0; row < values.size(); row += size + rates_size) {
        const double* const of_row = &values[row];
        poses.insert(poses.end(), of_row, of_row + size);
        const auto vector = [&](std::size_t at) {
            return Vec3(of_row[at], of_row[at + 1], of_row[at + 2]);
        };
        rates.push_back({vector(size), vector(size + 3), vector(size + 6)});
    }
    values = std::move(poses);
    return rates;
}

/// Reads the pose of a line, and behind it its rates, if the file has them.
Result<std::vector<double>> read_numbers(const std::vector<std::string_view>& words,
                                         const CsvColumns& columns,
                                         std::uint64_t line) {
    auto numbers = CD_TRY(read_csv_numbers(words, columns, line));
    const auto rates = CD_TRY(read_csv_rates(words, columns, line));
    numbers.insert(numbers.end(), rates.begin(), rates.end());
    return numbers;
}

/// Adds a row's time to the labels. Errors: BadInput for anything but a finite number.
Status add_time(std::string_view word, std::uint64_t line, PoseLabels& labels) {
    const auto time = to_number(word);
    if (!time || !std::isfinite(*time)) {
        return error_in_line(line, "t is '" + std::string(word) + "', not a number");
    }
    labels.times.push_back(*time);
    return Done{};
}

/// Adds a row's id and time to the labels, as far as the file has them. Errors: BadInput for an id
/// that is too long, and for a time that is not a number.
Status add_labels(const std::vector<std::string_view>& words,
                  const CsvColumns& columns,
                  std::uint64_t line,
                  PoseLabels& labels) {
    if (columns.id != no_column) {
        const std::string id = with_single_quotes(words[columns.id]);
        if (id.size() > limits::label_bytes_max) {
            return error_in_line(line,
                                 "the id is longer than " +
                                     std::to_string(limits::label_bytes_max) + " bytes");
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
            return error_in_line(line,
                                 "scenario '" + std::string(scenario_word) + "', body '" +
                                     std::string(body_word) +
                                     "': a count from 0, and a or b are expected");
        }
        const std::size_t slot = 2 * static_cast<std::size_t>(*scenario) + (is_b ? 1 : 0);
        if (slot >= seen_.size()) {
            // Refuses a large gap, which only a broken file has, though rows may have any order.
            if (slot > 2 * (rows_ + gap_max)) {
                return error_in_line(
                    line, "scenario " + std::string(scenario_word) + " is far out of order");
            }
            seen_.resize(slot / 2 * 2 + 2, false);
            values_.resize(seen_.size() * numbers_);
            lines_.resize(seen_.size());
        }
        if (seen_[slot]) {
            return error_in_line(line,
                                 "scenario " + std::string(scenario_word) + " has this body twice");
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
    std::optional<CsvColumns> columns;
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
            columns = CD_TRY(read_csv_header(
                line, number, of_both_bodies ? CsvRows::BothBodies : CsvRows::BodyB));
            both.emplace(columns->numbers_each() + columns->rates.size());
            continue;
        }
        const auto words = split_line(line, ",", false);
        if (words.size() != columns->count) {
            return error_in_line(number,
                                 std::to_string(words.size()) +
                                     " values, but the first line names " +
                                     std::to_string(columns->count));
        }
        const auto numbers = CD_TRY(read_numbers(words, *columns, number));
        if (!of_both_bodies) {
            if (columns->body != no_column && !is_body_b(words[columns->body])) {
                return error_in_line(
                    number,
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
    std::vector<PoseRates> rates;
    if (!columns->rates.empty()) {
        rates = take_rates(values, columns->numbers_each());
    }
    PoseTable table =
        make_table(std::move(values),
                   columns->set == ColumnSet::Matrix ? PoseLayout::Matrix34 : PoseLayout::Xyzw,
                   of_both_bodies ? both_bodies() : std::vector<std::string>());
    table.from_angles = columns->set == ColumnSet::Euler;
    table.zeros = std::move(columns->zeros);
    table.rates = std::move(rates);
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
        const auto words = split_line(line, " \t", true);
        if (words.size() != 8) {
            return error_in_line(number,
                                 std::to_string(words.size()) +
                                     " numbers where TUM has 8: time x y z qx qy qz qw");
        }
        CD_TRY(add_time(words[0], number, labels));
        for (std::size_t i = 1; i < words.size(); ++i) {
            const auto value = to_number(words[i]);
            if (!value) {
                return error_in_line(number, "'" + std::string(words[i]) + "' is not a number");
            }
            values.push_back(*value);
        }
        lines.push_back(number);
    }
    if (in.bad()) {
        return cut_short(number);
    }
    PoseTable table = make_table(std::move(values), PoseLayout::Xyzw, {});
    table.lines = std::move(lines);
    table.labels = std::move(labels);
    return table;
}

} // namespace cd
