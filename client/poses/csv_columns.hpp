// The lines and columns of text files of poses.
#pragma once

#include "common/core/result.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace cd {

/// Returns the error BadInput "line LINE: DETAIL".
[[nodiscard]] Error error_in_line(std::uint64_t line, const std::string& detail);

/// Splits a line at the separators that are outside quotes. Words have no blanks and no quotes
/// around them; `joins` drops empty words, so that separators in a row are one.
[[nodiscard]] std::vector<std::string_view>
split_line(std::string_view line, std::string_view separators, bool joins);

/// True for a blank line and for one that begins with '#'.
[[nodiscard]] bool is_comment(std::string_view line);

/// Whose poses the rows of a CSV file have.
enum class CsvRows : std::uint8_t {
    BodyB,      ///< One row for each scenario.
    BothBodies, ///< Two rows for each scenario, with the columns `scenario` and `body`.
    Scene,      ///< A row for each body at each step, with the columns `step` and `body`.
};

/// How the columns of a CSV file describe a rotation.
enum class ColumnSet : std::uint8_t { Quaternion, Matrix, Euler };

/// The position of a missing column, each of whose numbers is 0.
inline constexpr std::size_t no_column = static_cast<std::size_t>(-1);

/// The column that holds one number of a pose, and the factor for that number.
struct NumberColumn {
    std::size_t index = no_column;
    double factor = 1;
};

/// The positions of a CSV file's columns.
struct CsvColumns {
    ColumnSet set = ColumnSet::Quaternion;
    std::vector<NumberColumn> numbers; ///< In layout order; factors convert radians to degrees.
    std::vector<std::string> zeros;    ///< Names of missing columns, which count as 0.
    std::size_t scenario = no_column;
    std::size_t step = no_column;
    std::size_t body = no_column;
    std::size_t id = no_column;
    std::size_t time = no_column;
    std::size_t count = 0;
    /// Of velocity, acceleration and spin; empty if the file has none of them. Factors convert
    /// degrees to radians.
    std::vector<NumberColumn> rates;

    /// Number of the numbers that `read_csv_numbers` returns: 12 of a matrix, else 7.
    [[nodiscard]] std::size_t numbers_each() const { return set == ColumnSet::Matrix ? 12 : 7; }
};

/// Finds the columns that the first line names. Errors: BadInput naming the line and the column
/// that is missing, unknown or repeated; a velocity with one or two of its three columns.
[[nodiscard]] Result<CsvColumns>
read_csv_header(std::string_view line, std::uint64_t number, CsvRows rows);

/// Reads the numbers of one line, as a matrix of 3 rows and 4 columns or as x y z qx qy qz qw. With
/// `allows_nan` a line whose numbers are all NaN gives NaN. Errors: BadInput naming the line, also
/// for other numbers that are not finite.
[[nodiscard]] Result<std::vector<double>>
read_csv_numbers(const std::vector<std::string_view>& words,
                 const CsvColumns& columns,
                 std::uint64_t line,
                 bool allows_nan = false);

/// Reads the velocity, the acceleration and the spin of a line, in the file's unit of length,
/// seconds and radians; nothing if the file has none of them. Those that it lacks are 0. Errors:
/// BadInput naming the line, for numbers that are not finite.
[[nodiscard]] Result<std::vector<double>> read_csv_rates(const std::vector<std::string_view>& words,
                                                         const CsvColumns& columns,
                                                         std::uint64_t line);

} // namespace cd
