#include "client/poses/scene_csv.hpp"

#include "client/import/text/text_reader.hpp"
#include "client/poses/csv_columns.hpp"
#include "common/core/errors.hpp"
#include "common/core/limits/engine.hpp"

#include <algorithm>
#include <cmath>
#include <compare>
#include <map>
#include <numeric>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace cd {

namespace {

/// The place of a row: which body at which step.
struct StepSlot {
    std::uint64_t step = 0;
    std::size_t body = 0;

    friend auto operator<=>(const StepSlot&, const StepSlot&) = default;
};

/// Collects the rows of a scene, which may come in any order.
class SceneRows {
  public:
    SceneRows(CsvColumns columns, bool nan_is_absent)
        : columns_(std::move(columns)), nan_is_absent_(nan_is_absent) {}

    /// Adds a line. Errors: BadInput naming it.
    Status add(std::string_view text, std::uint64_t line) {
        const auto words = split_line(text, ",", false);
        if (words.size() != columns_.count) {
            return error_in_line(line,
                                 std::to_string(words.size()) +
                                     " values, but the first line names " +
                                     std::to_string(columns_.count));
        }
        const auto step = CD_TRY(step_in(words[columns_.step], line));
        const auto body = CD_TRY(body_of(words[columns_.body], line));
        const auto numbers = CD_TRY(read_csv_numbers(words, columns_, line, nan_is_absent_));
        if (columns_.time != no_column) {
            CD_TRY(add_time(step, words[columns_.time], line));
        }
        if (!columns_.rates.empty()) {
            // The numbers of an absent body are all nan, its velocities as well.
            PoseRates rates;
            if (!std::isnan(numbers.front())) {
                const auto read = CD_TRY(read_csv_rates(words, columns_, line));
                rates = rates_of(read);
            }
            rates_.push_back(rates);
        }
        slots_.push_back({step, body});
        lines_.push_back(line);
        values_.insert(values_.end(), numbers.begin(), numbers.end());
        return Done{};
    }

    /// Returns the rows of all steps. Errors: BadInput for a row that is missing or doubled, and
    /// for times that do not rise.
    Result<PoseTable> finish() {
        const auto places = CD_TRY(rows_by_place());
        CD_TRY(check_times());
        PoseTable table = make_table(places);
        for (const std::size_t row : places) {
            table.lines.push_back(lines_[row]);
            if (!rates_.empty()) {
                table.rates.push_back(rates_[row]);
            }
        }
        for (const auto& [step, time] : times_) {
            table.labels.times.push_back(time.first);
        }
        table.bodies = std::move(names_);
        table.zeros = columns_.zeros;
        table.from_angles = columns_.set == ColumnSet::Euler;
        return table;
    }

  private:
    /// A step's time, and the line that gave it.
    using StepTime = std::pair<double, std::uint64_t>;

    static PoseRates rates_of(const std::vector<double>& numbers) {
        return {Vec3(numbers[0], numbers[1], numbers[2]),
                Vec3(numbers[3], numbers[4], numbers[5]),
                Vec3(numbers[6], numbers[7], numbers[8])};
    }

    static Result<std::uint64_t> step_in(std::string_view word, std::uint64_t line) {
        const auto step = to_whole(word);
        if (!step || *step > limits::scenarios_max) {
            return error_in_line(line, "step is '" + std::string(word) + "', not a count from 0");
        }
        return *step;
    }

    Result<std::size_t> body_of(std::string_view word, std::uint64_t line) {
        const auto [found, is_new] = bodies_.try_emplace(std::string(word), names_.size());
        if (is_new) {
            names_.emplace_back(word);
        }
        if (names_.size() > limits::bodies_max) {
            return error_in_line(line,
                                 "is of body number " + std::to_string(names_.size()) +
                                     "; a job has at most " + std::to_string(limits::bodies_max) +
                                     " bodies");
        }
        return found->second;
    }

    Status add_time(std::uint64_t step, std::string_view word, std::uint64_t line) {
        const auto time = to_number(word);
        if (!time || !std::isfinite(*time)) {
            return error_in_line(line, "t is '" + std::string(word) + "', not a number");
        }
        const auto [found, is_new] = times_.try_emplace(step, *time, line);
        if (!is_new && found->second.first != *time) {
            return error_in_line(line,
                                 "step " + std::to_string(step) + " has another t in line " +
                                     std::to_string(found->second.second));
        }
        return Done{};
    }

    /// Returns for each step, and in it for each body, the number of its row.
    [[nodiscard]] Result<std::vector<std::size_t>> rows_by_place() const {
        std::vector<std::size_t> rows(slots_.size());
        std::iota(rows.begin(), rows.end(), std::size_t{0});
        std::ranges::stable_sort(rows, [&](std::size_t left, std::size_t right) {
            return slots_[left] < slots_[right];
        });
        for (std::size_t place = 0; place < rows.size(); ++place) {
            const StepSlot& slot = slots_[rows[place]];
            if (place > 0 && slot == slots_[rows[place - 1]]) {
                return error_in_line(lines_[rows[place]],
                                     "step " + std::to_string(slot.step) + " has body " +
                                         names_[slot.body] + " twice");
            }
            if (slot != slot_at(place)) {
                return no_row(slot_at(place));
            }
        }
        const StepSlot behind = slot_at(rows.size());
        return behind.body == 0 ? Result(std::move(rows)) : no_row(behind);
    }

    /// Returns which body and step a place is for, if no row is missing.
    [[nodiscard]] StepSlot slot_at(std::size_t place) const {
        const std::size_t each = std::max<std::size_t>(1, names_.size());
        return {place / each, place % each};
    }

    [[nodiscard]] Error no_row(const StepSlot& slot) const {
        return bad_input("step " + std::to_string(slot.step) + " has no row of body " +
                         names_[slot.body] +
                         "; for an absent body write nan as its numbers, and [poses] absent = "
                         "\"nan\"");
    }

    [[nodiscard]] Status check_times() const {
        const std::pair<const std::uint64_t, StepTime>* before = nullptr;
        for (const auto& time : times_) {
            if (before != nullptr && !(before->second.first < time.second.first)) {
                return error_in_line(time.second.second,
                                     "t does not rise from step " + std::to_string(before->first) +
                                         " to step " + std::to_string(time.first));
            }
            before = &time;
        }
        return Done{};
    }

    [[nodiscard]] PoseTable make_table(const std::vector<std::size_t>& places) {
        const std::size_t each = columns_.numbers_each();
        NpyArray array;
        array.shape = {slot_at(places.size()).step, names_.size() * each};
        array.data.reserve(values_.size() * sizeof(double));
        for (const std::size_t row : places) {
            const auto numbers = std::as_bytes(std::span(values_).subspan(row * each, each));
            array.data.insert(array.data.end(), numbers.begin(), numbers.end());
        }
        values_ = {};
        return {NpyRows::of(std::move(array)),
                columns_.set == ColumnSet::Matrix ? PoseLayout::Matrix34 : PoseLayout::Xyzw};
    }

    CsvColumns columns_;
    bool nan_is_absent_;
    std::map<std::string, std::size_t> bodies_; ///< The place of each name in `names_`.
    std::vector<std::string> names_;
    std::map<std::uint64_t, StepTime> times_; ///< By step.
    std::vector<StepSlot> slots_;             ///< Of each row.
    std::vector<std::uint64_t> lines_;        ///< Of each row.
    std::vector<double> values_;              ///< The numbers of all rows.
    std::vector<PoseRates> rates_;            ///< Of each row, if the file has velocities.
};

} // namespace

Result<PoseTable> read_scene_csv(std::istream& in, bool nan_is_absent) {
    std::string line;
    std::uint64_t number = 0;
    std::optional<SceneRows> rows;
    while (std::getline(in, line)) {
        ++number;
        if (number == 1 && line.starts_with("\xEF\xBB\xBF")) {
            line.erase(0, 3); // Drops a byte order mark, which spreadsheets write.
        }
        if (is_comment(line)) {
            continue;
        }
        if (rows) {
            CD_TRY(rows->add(line, number));
        } else {
            auto columns = CD_TRY(read_csv_header(line, number, CsvRows::Scene));
            rows.emplace(std::move(columns), nan_is_absent);
        }
    }
    if (in.bad()) {
        return Error{ErrorCode::Io, "cannot be read beyond line " + std::to_string(number)};
    }
    return rows ? rows->finish() : bad_input("there is no line that names the columns");
}

} // namespace cd
