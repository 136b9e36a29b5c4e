#include "common/job/scenario_file.hpp"

#include "common/core/check.hpp"
#include "common/job/packed_scenarios.hpp"

#include <algorithm>
#include <mutex>

namespace cd {

namespace {

constexpr FileKind kind{0x31'4e'43'53'44'43'00'00, 1}; // "\0\0CDSCN1"
constexpr std::uint64_t block_scenarios_max = 4096;

/// A file as a source. Caches the last block, because most reads continue the previous read.
class ScenarioFileSource final : public PoseSource {
  public:
    explicit ScenarioFileSource(BlockFile file) : file_(std::move(file)) {}

    [[nodiscard]] std::uint64_t count() const override { return file_.count(); }

    [[nodiscard]] Result<std::vector<Scenario>> read(std::uint64_t first,
                                                     std::uint64_t count) override {
        CD_CHECK(first <= this->count());
        CD_CHECK(count <= this->count() - first);
        const std::lock_guard lock(mutex_);
        std::vector<Scenario> scenarios;
        while (scenarios.size() < count) {
            const std::uint64_t next = first + scenarios.size();
            if (Status loaded = load(*file_.block_of(next)); !loaded) {
                return loaded.error();
            }
            const std::uint64_t skipped = next - kept_.front().index;
            const std::uint64_t taken =
                std::min<std::uint64_t>(kept_.size() - skipped, count - scenarios.size());
            const auto from = kept_.begin() + static_cast<std::ptrdiff_t>(skipped);
            scenarios.insert(scenarios.end(), from, from + static_cast<std::ptrdiff_t>(taken));
        }
        return scenarios;
    }

  private:
    [[nodiscard]] Status load(std::size_t block) {
        const BlockPlace& place = file_.blocks()[block];
        if (!kept_.empty() && kept_.front().index == place.first) {
            return Done{};
        }
        kept_.clear();
        const Result<Bytes> packed = file_.read(block);
        if (!packed) {
            return packed.error();
        }
        auto scenarios = unpack_scenarios(packed.value(), place.count);
        if (!scenarios || scenarios.value().size() != place.count ||
            scenarios.value().front().index != place.first ||
            scenarios.value().back().index != place.first + place.count - 1) {
            return Error{ErrorCode::Io,
                         file_.path().string() + " is damaged: it holds other scenarios than its "
                                                 "table says"};
        }
        kept_ = std::move(scenarios.value());
        return Done{};
    }

    BlockFile file_;
    std::mutex mutex_;
    std::vector<Scenario> kept_;
};

/// Makes a source of a file's scenarios. Errors: the error in `file`; Io if the scenarios' indices
/// do not run from 0 without a gap.
Result<std::unique_ptr<PoseSource>> source_of(Result<BlockFile> file) {
    if (!file) {
        return file.error();
    }
    const std::vector<BlockPlace>& blocks = file.value().blocks();
    if (!blocks.empty() && blocks.back().first + blocks.back().count != file.value().count()) {
        return Error{ErrorCode::Io,
                     file.value().path().string() + " is damaged: scenarios are missing in it"};
    }
    return std::unique_ptr<PoseSource>(
        std::make_unique<ScenarioFileSource>(std::move(file.value())));
}

} // namespace

Result<ScenarioWriter> ScenarioWriter::create(const std::filesystem::path& path) {
    Result<BlockFileWriter> file = BlockFileWriter::create(path, kind);
    return file ? Result<ScenarioWriter>(ScenarioWriter(std::move(file.value()))) : file.error();
}

Result<ScenarioWriter> ScenarioWriter::resume(const std::filesystem::path& path) {
    Result<BlockFileWriter> file = BlockFileWriter::resume(path, kind);
    return file ? Result<ScenarioWriter>(ScenarioWriter(std::move(file.value()))) : file.error();
}

Status ScenarioWriter::add(std::span<const Scenario> scenarios) {
    while (!scenarios.empty()) {
        const auto block =
            scenarios.first(std::min<std::size_t>(scenarios.size(), block_scenarios_max));
        const Status added = file_.add(block.front().index, block.size(), pack_scenarios(block));
        if (!added) {
            return added;
        }
        scenarios = scenarios.subspan(block.size());
    }
    return Done{};
}

Status ScenarioWriter::finish() {
    return file_.finish();
}

Result<std::unique_ptr<PoseSource>> open_scenario_file(const std::filesystem::path& path) {
    return source_of(BlockFile::open(path, kind));
}

Result<std::unique_ptr<PoseSource>>
open_unfinished_scenario_file(const std::filesystem::path& path) {
    return source_of(BlockFile::open_unfinished(path, kind));
}

} // namespace cd
