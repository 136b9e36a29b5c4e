#include "bench/cluster/trace/trace.hpp"

#include "common/core/files/checked_file.hpp"
#include "common/core/files/compress.hpp"
#include "common/core/varint.hpp"

#include <algorithm>

namespace cd::bench {

namespace {

constexpr FileKind trace_kind{0x656361727463'6463, 3}; // "cdctrace"
constexpr std::size_t trace_bytes_max = std::size_t{1} << 32;
constexpr int compression_level = 3;

// Writes and reads members in one order: `Stream` is a TraceWriter or a TraceReader.

template <class Stream, class T>
void exchange(Stream& stream, std::vector<T>& values) {
    stream.size(values);
    for (T& value : values) {
        exchange(stream, value);
    }
}

/// Roots ascend: writes the first, then the steps.
template <class Stream>
void exchange_roots(Stream& stream, std::vector<RootIndex>& roots) {
    stream.size(roots);
    RootIndex before = 0;
    for (RootIndex& root : roots) {
        RootIndex step = root - before;
        stream.whole(step);
        root = before + step;
        before = root;
    }
}

template <class Stream>
void exchange(Stream& stream, RootTrace& root) {
    stream.whole(root.triangles);
    stream.whole(root.bytes);
    stream.whole(root.compressed_bytes);
    stream.whole(root.memory_bytes);
    stream.real(root.open_seconds);
}

template <class Stream>
void exchange(Stream& stream, CutTrace& cut) {
    stream.whole(cut.depth);
    stream.whole(cut.top_bytes);
    exchange(stream, cut.roots);
}

template <class Stream>
void exchange(Stream& stream, ScenarioTrace& scenario) {
    stream.real(scenario.analysis_seconds);
    stream.whole(scenario.analysis_box_tests);
    stream.whole(scenario.root_pairs);
    stream.real(scenario.meeting_size);
    stream.real(scenario.work_seconds);
    stream.real(scenario.binary_seconds);
    stream.whole(scenario.batch_bytes);
    stream.whole(scenario.result_bytes);
    exchange_roots(stream, scenario.roots_a);
    exchange_roots(stream, scenario.roots_b);
}

template <class Stream>
void exchange(Stream& stream, WholeTrace& whole) {
    stream.real(whole.seconds);
    stream.real(whole.binary_seconds);
    stream.whole(whole.box_tests);
    stream.whole(whole.triangle_tests);
    stream.whole(whole.wide_box_tests);
    stream.whole(whole.wide_triangle_tests);
}

template <class Stream>
void exchange(Stream& stream, DepthTrace& depth) {
    exchange(stream, depth.a);
    exchange(stream, depth.scenarios);
}

template <class Stream>
void exchange(Stream& stream, Trace& trace) {
    stream.text(trace.name);
    stream.whole(trace.triangles_a);
    stream.whole(trace.triangles_b);
    stream.real(trace.box_test_ns);
    stream.real(trace.triangle_test_ns);
    stream.real(trace.results.packing_seconds);
    stream.real(trace.results.intake_seconds);
    stream.real(trace.results.journal_seconds);
    exchange(stream, trace.whole);
    exchange(stream, trace.b);
    exchange(stream, trace.depths);
}

class TraceWriter {
  public:
    template <class T>
    void whole(const T& value) {
        put_varint(out_, value);
    }
    void real(double value) { out_.put(value); }
    void text(const std::string& value) { out_.put_text(value); }
    template <class T>
    void size(const std::vector<T>& values) {
        whole(values.size());
    }
    [[nodiscard]] Bytes take() { return out_.take(); }

  private:
    ByteWriter out_;
};

class TraceReader {
  public:
    explicit TraceReader(std::span<const std::byte> bytes) : in_(bytes) {}

    template <class T>
    void whole(T& value) {
        value = static_cast<T>(get_varint(in_).value_or(0));
    }
    void real(double& value) { value = in_.get<double>(); }
    void text(std::string& value) { value = in_.get_text(); }
    /// Each element takes at least one byte.
    template <class T>
    void size(std::vector<T>& values) {
        values.resize(std::min<std::uint64_t>(get_varint(in_).value_or(0), in_.remaining()));
    }
    [[nodiscard]] bool complete() const { return in_.complete(); }

  private:
    ByteReader in_;
};

} // namespace

const DepthTrace* Trace::at(std::uint32_t depth_a) const {
    const auto found =
        std::ranges::find(depths, depth_a, [](const DepthTrace& depth) { return depth.a.depth; });
    return found == depths.end() ? nullptr : &*found;
}

Status write_trace(const std::filesystem::path& path, const Trace& trace) {
    TraceWriter writer;
    Trace copy = trace; // `exchange` needs a mutable object, which it fills when reading.
    exchange(writer, copy);
    return write_checked(path, trace_kind, compress(writer.take(), compression_level));
}

Result<Trace> read_trace(const std::filesystem::path& path) {
    const Result<Bytes> content = read_checked(path, trace_kind);
    if (!content) {
        return content.error();
    }
    const Result<Bytes> bytes = decompress(content.value(), trace_bytes_max);
    if (!bytes) {
        return bytes.error();
    }
    TraceReader reader(bytes.value());
    Trace trace;
    exchange(reader, trace);
    if (!reader.complete()) {
        return Error{ErrorCode::Io, path.string() + " is not a whole trace"};
    }
    return trace;
}

} // namespace cd::bench
