#include "client/export/result_writer.hpp"
#include "client/words.hpp"

#include <optional>

namespace cd {

namespace {

/// A field as RFC 4180 wants it.
std::string csv_field(std::string_view text) {
    if (text.find_first_of(",\"\r\n") == std::string_view::npos) {
        return std::string(text);
    }
    std::string field = "\"";
    for (const char c : text) {
        field += (c == '"') ? "\"\"" : std::string(1, c);
    }
    return field + "\"";
}

std::string part_name(const Mesh* mesh, std::uint32_t triangle) {
    const Part* part = part_of(mesh, triangle);
    return part == nullptr ? "" : csv_field(part->name);
}

class ScenariosCsvWriter final : public ResultWriter {
  public:
    explicit ScenariosCsvWriter(OutputFile file) : file_(std::move(file)) {}

    Status add(const ScenarioResult& result) override {
        const bool counted_pairs = result.level != Level::Any;
        const bool is_undecided = result.kind == ScenarioClass::Undecided;
        return file_.write(
            header_once() + std::to_string(result.index) + "," + std::string(to_text(result.kind)) +
            "," + (counted_pairs ? std::to_string(result.pair_count) : "") + "," +
            (result.is_cut() ? "1" : "0") + "," +
            (is_undecided ? exact_text(result.distance_bound) : "") + "," +
            (result.surfaces_only ? "1" : "0") + "," + csv_field(result.failure) + "\n");
    }

    Status finish() override {
        if (Status written = file_.write(header_once()); !written) {
            return written;
        }
        return file_.commit();
    }

  private:
    [[nodiscard]] std::string header_once() {
        const bool first = !has_header_;
        has_header_ = true;
        return first ? "scenario,class,count,cut,distance_bound,surfaces_only,failure\n" : "";
    }

    OutputFile file_;
    bool has_header_ = false;
};

class CsvWriter final : public ResultWriter {
  public:
    CsvWriter(const ExportContext& context,
              std::unique_ptr<ResultWriter> scenarios,
              std::optional<OutputFile> pairs,
              std::optional<OutputFile> points)
        : context_(context),
          scenarios_(std::move(scenarios)),
          pairs_(std::move(pairs)),
          points_(std::move(points)) {}

    Status add(const ScenarioResult& result) override {
        if (Status added = scenarios_->add(result); !added) {
            return added;
        }
        std::string pairs;
        std::string points;
        for (std::size_t i = 0; i < result.pairs.size(); ++i) {
            add_pair(result, i, pairs, points);
        }
        if (Status written = write(pairs_, pairs); !written) {
            return written;
        }
        return write(points_, points);
    }

    Status finish() override {
        for (std::optional<OutputFile>* file : {&pairs_, &points_}) {
            if (!file->has_value()) {
                continue;
            }
            if (Status done = (*file)->commit(); !done) {
                return done;
            }
        }
        return scenarios_->finish();
    }

  private:
    static Status write(std::optional<OutputFile>& file, const std::string& text) {
        return file && !text.empty() ? file->write(text) : Status(Done{});
    }

    void add_pair(const ScenarioResult& result,
                  std::size_t place,
                  std::string& pairs,
                  std::string& points) const {
        const ContactPair& pair = result.pairs[place];
        const std::string key = std::to_string(result.index) + "," + std::to_string(pair.a) + "," +
                                std::to_string(pair.b);
        pairs += key + "," + std::string(pair_class_name(pair.kind)) + "," +
                 part_name(context_.meshes[0].get(), pair.a) + "," +
                 part_name(context_.meshes[1].get(), pair.b) + "\n";
        for_each_point(result, place, [&](const Vec3& point) {
            points += key + "," + exact_text(point.x()) + "," + exact_text(point.y()) + "," +
                      exact_text(point.z()) + "\n";
        });
    }

    ExportContext context_;
    std::unique_ptr<ResultWriter> scenarios_;
    std::optional<OutputFile> pairs_;
    std::optional<OutputFile> points_;
};

Status create_with_header(const std::filesystem::path& path,
                          std::string_view header,
                          std::optional<OutputFile>& file) {
    auto created = OutputFile::create(path);
    if (!created) {
        return created.error();
    }
    file.emplace(std::move(created.value()));
    return file->write(header);
}

} // namespace

std::unique_ptr<ResultWriter> make_scenarios_csv_writer(OutputFile file) {
    return std::make_unique<ScenariosCsvWriter>(std::move(file));
}

Result<std::unique_ptr<ResultWriter>> make_csv_writer(const ExportContext& context,
                                                      const std::filesystem::path& dir) {
    auto scenarios = OutputFile::create(dir / "scenarios.csv");
    if (!scenarios) {
        return scenarios.error();
    }
    std::optional<OutputFile> pairs;
    std::optional<OutputFile> points;
    if (context.level >= Level::Pairs) {
        const Status created = create_with_header(
            dir / "pairs.csv", "scenario,triangle_a,triangle_b,class,part_a,part_b\n", pairs);
        if (!created) {
            return created.error();
        }
    }
    if (context.level == Level::Contacts) {
        const Status created = create_with_header(
            dir / "points.csv", "scenario,triangle_a,triangle_b,x,y,z\n", points);
        if (!created) {
            return created.error();
        }
    }
    return std::unique_ptr<ResultWriter>(
        std::make_unique<CsvWriter>(context,
                                    make_scenarios_csv_writer(std::move(scenarios.value())),
                                    std::move(pairs),
                                    std::move(points)));
}

} // namespace cd
