#include "master/submission/label_spool.hpp"

#include "common/core/check.hpp"
#include "common/core/files/bytes.hpp"
#include "common/core/limits/engine.hpp"

#include <algorithm>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace cd {

namespace {

constexpr std::uint64_t magic = 0x32'42'41'4c'44'43'00'00; // "\0\0CDLAB2"

Bytes encode(const PoseLabels& labels) {
    ByteWriter out;
    out.put_array(std::span<const std::int64_t>(labels.integers));
    for (const std::string& text : labels.texts) {
        out.put_text(text);
    }
    out.put_array(std::span<const double>(labels.times));
    out.put_array(std::span<const double>(labels.end_times));
    return out.take();
}

/// Returns false if the bytes are not labels of `scenarios` scenarios in these columns.
bool decode(std::span<const std::byte> bytes,
            LabelColumns columns,
            std::size_t scenarios,
            PoseLabels& labels) {
    ByteReader in(bytes);
    const bool has_integers = columns.ids == IdKind::Integer;
    labels.integers = in.get_array<std::int64_t>(has_integers ? scenarios : 0);
    for (std::size_t i = 0; columns.ids == IdKind::Text && i < scenarios && !in.failed(); ++i) {
        labels.texts.push_back(in.get_text());
    }
    labels.times = in.get_array<double>(columns.has_times ? scenarios : 0);
    labels.end_times = in.get_array<double>(columns.has_end_times ? scenarios : 0);
    return in.complete();
}

SpoolFile::Content content_of(LabelColumns columns, std::uint64_t scenarios) {
    return {
        {magic, static_cast<std::uint64_t>(columns.ids), columns.has_times, columns.has_end_times},
        scenarios};
}

} // namespace

Status LabelSpool::write_last() {
    if (Status written = file_.append(encode(last_)); !written) {
        return written;
    }
    last_ = {};
    last_count_ = 0;
    return Done{};
}

Result<PoseLabels> LabelSpool::read_run(std::uint64_t run) const {
    const Result<Bytes> bytes = file_.read(file_.run(run));
    if (!bytes) {
        return bytes.error();
    }
    const std::uint64_t scenarios =
        std::min(limits::pose_run_scenarios, file_.scenarios() - run * limits::pose_run_scenarios);
    PoseLabels labels;
    return decode(bytes.value(), columns_, scenarios, labels)
               ? Result(std::move(labels))
               : file_.damaged("a run does not hold labels of its scenarios");
}

Result<std::unique_ptr<LabelSpool>> LabelSpool::create(const std::filesystem::path& directory,
                                                       LabelColumns columns,
                                                       std::uint64_t scenarios) {
    auto file = SpoolFile::create(directory / "labels", content_of(columns, scenarios));
    if (!file) {
        return file.error();
    }
    return std::unique_ptr<LabelSpool>(new LabelSpool(std::move(file.value()), columns));
}

Result<std::unique_ptr<LabelSpool>>
LabelSpool::open(const std::filesystem::path& path, LabelColumns columns, std::uint64_t scenarios) {
    auto file = SpoolFile::open(path, content_of(columns, scenarios));
    if (!file) {
        return file.error();
    }
    return std::unique_ptr<LabelSpool>(new LabelSpool(std::move(file.value()), columns));
}

Status LabelSpool::append(const PoseLabels& labels, std::size_t scenarios) {
    if (!columns_.fit(labels, scenarios)) {
        return Error{ErrorCode::BadInput, "ids or times that do not match the announced columns"};
    }
    const bool is_long = std::ranges::any_of(labels.texts, [](const std::string& text) {
        return text.size() > limits::label_bytes_max;
    });
    if (is_long) {
        return Error{ErrorCode::BadInput,
                     "the id of a scenario is longer than " +
                         std::to_string(limits::label_bytes_max) + " bytes"};
    }
    if (scenarios > file_.scenarios() - count_) {
        return Error{ErrorCode::BadInput, "labels of more scenarios than were announced"};
    }
    std::size_t taken = 0;
    for (const SpoolFile::Slice& slice : SpoolFile::slices(count_, scenarios)) {
        last_.append(labels.slice(taken, slice.count));
        last_count_ += slice.count;
        taken += slice.count;
        if (last_count_ == limits::pose_run_scenarios) {
            if (Status status = write_last(); !status) {
                return status;
            }
        }
    }
    count_ += scenarios;
    return Done{};
}

Status LabelSpool::seal(const std::filesystem::path& path, Durability durability) {
    CD_CHECK(count_ == file_.scenarios());
    if (last_count_ != 0) {
        if (Status status = write_last(); !status) {
            return status;
        }
    }
    return file_.seal(path, durability);
}

Status LabelSpool::verify() const {
    for (std::uint64_t run = 0; run < file_.runs(); ++run) {
        if (const auto labels = read_run(run); !labels) {
            return labels.error();
        }
    }
    return Done{};
}

Result<PoseLabels> LabelSpool::read(std::uint64_t first, std::uint64_t count) const {
    CD_CHECK(first <= file_.scenarios() && count <= file_.scenarios() - first);
    PoseLabels labels;
    for (const SpoolFile::Slice& slice : SpoolFile::slices(first, count)) {
        const Result<PoseLabels> run = read_run(slice.run);
        if (!run) {
            return run.error();
        }
        labels.append(run.value().slice(slice.first, slice.count));
    }
    return labels;
}

} // namespace cd
