#include "client/export/body_map.hpp"
#include "client/export/result_writer.hpp"
#include "client/export/vtp_body.hpp"
#include "client/export/vtp_file.hpp"
#include "client/formats/array_spool.hpp"
#include "common/core/errors.hpp"

#include <array>
#include <optional>
#include <utility>

namespace cd {

namespace {

/// An array of contacts.vtp.
struct PointColumn {
    const char* name;
    NpyType type;
};

/// The coordinates, and the arrays of the points. Numbers of scenarios are signed, since ParaView
/// compares in signed integers or doubles.
constexpr std::array<PointColumn, 5> columns{{{"Points", NpyType::F8},
                                              {"class", NpyType::U1},
                                              {"scenario", NpyType::I8},
                                              {"triangle_a", NpyType::U4},
                                              {"triangle_b", NpyType::U4}}};

/// The type of the numbers of points in lines.
constexpr NpyType line_end_type = NpyType::I8;

/// Writes contacts.vtp: spools the columns, since a VTP file begins with the number of its points.
class VtpContacts final : public ResultWriter {
  public:
    VtpContacts(const ExportContext& context,
                std::filesystem::path path,
                std::vector<ArraySpool> spools,
                std::optional<ArraySpool> line_ends)
        : path_(std::move(path)),
          stop_(context.stop),
          spools_(std::move(spools)),
          line_ends_(std::move(line_ends)) {}

    Status add(const ScenarioResult& result) override {
        Status status = Done{};
        for (std::size_t i = 0; i < result.pairs.size(); ++i) {
            const bool is_line = line_ends_ && result.pairs[i].kind == PairClass::Near;
            for_each_point(result, i, [&](const Vec3& point) {
                status = status && is_line ? line_ends_->append(points_) : status;
                status = status ? add_point(result, result.pairs[i], point) : status;
            });
        }
        return status;
    }

    Status finish() override {
        VtpData data;
        data.points = CD_TRY(spools_[0].finish());
        for (std::size_t i = 1; i < columns.size(); ++i) {
            auto numbers = CD_TRY(spools_[i].finish());
            data.point_arrays.push_back({columns[i].name, std::move(numbers)});
        }
        data.dots = consecutive_cells(data.points.count / 3, 1);
        if (line_ends_) {
            data.lines.connectivity = CD_TRY(line_ends_->finish());
            data.lines.ends = make_numbers<std::int64_t>(
                data.lines.connectivity.count / 2, [](std::uint64_t i) { return 2 * (i + 1); });
        }
        CD_TRY(write_vtp(data, path_, stop_));
        spools_.clear(); // Removes their files: from here on the folder may be moved.
        line_ends_.reset();
        return Done{};
    }

  private:
    Status add_point(const ScenarioResult& result, const ContactPair& pair, const Vec3& point) {
        ++points_;
        CD_TRY(spools_[0].append(std::span<const double>(point.data(), 3)));
        CD_TRY(spools_[1].append(static_cast<std::uint8_t>(pair.kind)));
        CD_TRY(spools_[2].append(static_cast<std::int64_t>(result.index)));
        CD_TRY(spools_[3].append(pair.a));
        return spools_[4].append(pair.b);
    }

    std::filesystem::path path_;
    StopCheck stop_;
    std::vector<ArraySpool> spools_; ///< One for each of `columns`.
    /// With a clearance, the numbers of the two points of each near pair.
    std::optional<ArraySpool> line_ends_;
    std::int64_t points_ = 0;
};

/// Writes nothing: below `level contacts` there are no points.
class NoContacts final : public ResultWriter {
  public:
    Status add(const ScenarioResult& /*result*/) override { return Done{}; }
    Status finish() override { return Done{}; }
};

/// What the map says of each triangle of a body.
struct BodyNumbers {
    std::vector<std::uint64_t> scenarios;
    std::optional<std::vector<std::uint64_t>> in_contact = std::nullopt;
};

Result<BodyNumbers> numbers_of(const ExportMap& map, std::size_t body, const Mesh& mesh) {
    BodyNumbers numbers{CD_TRY(scenarios_of_triangles(map.map.bodies[body], mesh))};
    if (map.contacts) {
        numbers.in_contact = CD_TRY(scenarios_of_triangles(map.contacts->bodies[body], mesh));
    }
    return numbers;
}

VtpArray integers(const std::string& name, const std::vector<std::uint64_t>& values) {
    return {name,
            make_numbers<std::int64_t>(values.size(), [&](std::uint64_t i) { return values[i]; })};
}

Status write_body(const std::shared_ptr<const Mesh>& mesh,
                  const BodyNumbers& numbers,
                  std::uint64_t tested,
                  const std::filesystem::path& path,
                  const ExportContext& context) {
    const bool is_float = mesh->precision() == Precision::Float;
    const std::vector<std::uint64_t>& scenarios = numbers.scenarios;
    VtpData data = vtp_body(mesh, mesh->vertices(), is_float ? NpyType::F4 : NpyType::F8);
    std::vector<VtpArray> map{integers(map_column_name(context), scenarios)};
    if (numbers.in_contact) {
        map.push_back(integers("in_contact", *numbers.in_contact));
    }
    if (context.map_pairs() == 0) {
        const double all = tested == 0 ? 1 : static_cast<double>(tested);
        map.push_back(
            {"share", make_numbers<double>(scenarios.size(), [&scenarios, all](std::uint64_t i) {
                 return static_cast<double>(scenarios[i]) / all;
             })});
    }
    data.cell_arrays.insert(data.cell_arrays.begin(), map.begin(), map.end());
    return write_vtp(data, path, context.stop);
}

} // namespace

Result<std::unique_ptr<ResultWriter>> make_vtp_writer(const ExportContext& context,
                                                      const std::filesystem::path& dir) {
    if (context.level != Level::Contacts) {
        return std::unique_ptr<ResultWriter>(std::make_unique<NoContacts>());
    }
    const std::filesystem::path path = dir / "contacts.vtp";
    std::vector<ArraySpool> spools;
    for (const PointColumn& column : columns) {
        auto spool = CD_TRY(ArraySpool::create(path, column.type));
        spools.push_back(std::move(spool));
    }
    std::optional<ArraySpool> line_ends;
    if (context.clearance) {
        line_ends = CD_TRY(ArraySpool::create(path, line_end_type));
    }
    return std::unique_ptr<ResultWriter>(
        std::make_unique<VtpContacts>(context, path, std::move(spools), std::move(line_ends)));
}

Status write_vtp_bodies(const ExportMap& map,
                        std::uint64_t tested,
                        const std::filesystem::path& dir,
                        const ExportContext& context) {
    for (std::size_t i = 0; i < map.map.bodies.size(); ++i) {
        const auto& mesh = context.bodies[i].mesh;
        const BodyNumbers numbers = CD_TRY(numbers_of(map, i, *mesh));
        const std::string name = body_file_name(context.bodies, i) + ".vtp";
        CD_TRY(write_body(mesh, numbers, tested, dir / name, context));
    }
    return Done{};
}

} // namespace cd
