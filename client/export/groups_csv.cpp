#include "client/export/result_writer.hpp"
#include "client/formats/csv_rows.hpp"
#include "common/core/errors.hpp"
#include "common/core/words.hpp"

#include <string>
#include <string_view>

namespace cd {

Status write_groups_csv(const GroupSum& sum,
                        std::uint64_t tested,
                        const std::filesystem::path& dir,
                        const ExportContext& context) {
    auto file = CD_TRY(RowFile::create(
        dir / "groups.csv", "part_a,part_b,class,scenarios,share,pairs,worst,worst_pairs\n"));
    for (const Group& group : sum.groups()) {
        const double share = static_cast<double>(group.scenarios) / static_cast<double>(tested);
        CD_TRY(file.add(csv_field(group.part_a),
                        ",",
                        csv_field(group.part_b),
                        ",",
                        to_text(group.kind),
                        ",",
                        group.scenarios,
                        ",",
                        context.limit_pairs == 0 ? exact_text(share) : std::string(),
                        ",",
                        group.pairs,
                        ",",
                        group.worst,
                        ",",
                        group.worst_pairs,
                        "\n"));
    }
    if (sum.left_out() != 0) {
        CD_TRY(file.add("*,*,,,,", sum.left_out(), ",,\n"));
    }
    return file.commit();
}

} // namespace cd
