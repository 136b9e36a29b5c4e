#include "client/export/shots/shot_writers.hpp"
#include "client/formats/array_file.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace cd {

namespace {

class ShotsArrays final : public ResultWriter {
  public:
    ShotsArrays(const ExportContext& context, std::unique_ptr<ArrayFile> file)
        : file_(std::move(file)),
          index_(file_->add_array({"index", NpyType::U8})),
          offsets_(file_->add_array({"offsets", NpyType::U8})),
          hits_(file_->add_array({"hits", NpyType::U4, 2})),
          depth_(file_->add_array({"depth", NpyType::F8})),
          flags_(file_->add_array({"flags", NpyType::U1})),
          rank_(file_->add_array({"rank", NpyType::U1})) {
        if (context.steps) {
            scene_ = SceneArrays{context,
                                 file_->add_array({"step", NpyType::U8}),
                                 file_->add_array({"bundle", NpyType::U8}),
                                 file_->add_array({"body", NpyType::U4})};
        }
        append(offsets_, std::vector<std::uint64_t>{0});
    }

    Status add(const ScenarioResult& result) override {
        std::vector<std::uint32_t> pairs;
        std::vector<double> depths;
        std::vector<std::uint8_t> flags;
        std::vector<std::uint8_t> ranks;
        for (std::size_t i = 0; i < result.hits.size(); ++i) {
            pairs.insert(pairs.end(), {result.pairs[i].a, result.pairs[i].b});
            depths.push_back(result.hits[i].depth);
            flags.push_back(result.hits[i].flags);
            ranks.push_back(result.hits[i].rank);
        }
        end_ += result.hits.size();
        append(index_, std::vector<std::uint64_t>{result.index});
        append(offsets_, std::vector<std::uint64_t>{end_});
        append(hits_, pairs);
        append(depth_, depths);
        append(flags_, flags);
        append(rank_, ranks);
        if (scene_) {
            append(scene_->step,
                   std::vector<std::uint64_t>{scene_->context.steps->step_of(result.index)});
            append(scene_->bundle,
                   std::vector<std::uint64_t>{scene_->context.bundle_of(result).value_or(0)});
            append(scene_->body, std::vector<std::uint32_t>{result.body_a});
        }
        return status_;
    }

    Status finish() override { return status_ ? file_->finish() : status_; }

  private:
    /// What the file of a scene has besides.
    struct SceneArrays {
        ExportContext context;
        std::size_t step;
        std::size_t bundle;
        std::size_t body;
    };

    template <class T>
    void append(std::size_t array, const std::vector<T>& values) {
        status_ = status_ ? file_->append(array, std::span<const T>(values)) : status_;
    }

    std::unique_ptr<ArrayFile> file_;
    std::size_t index_;
    std::size_t offsets_;
    std::size_t hits_;
    std::size_t depth_;
    std::size_t flags_;
    std::size_t rank_;
    std::optional<SceneArrays> scene_;
    std::uint64_t end_ = 0; ///< Number of hits so far.
    Status status_ = Done{};
};

} // namespace

std::unique_ptr<ResultWriter> make_shots_array_writer(std::string_view format,
                                                      const ExportContext& context,
                                                      const std::filesystem::path& dir) {
    return std::make_unique<ShotsArrays>(context,
                                         make_array_file(format, dir, "shots", context.stop));
}

} // namespace cd
