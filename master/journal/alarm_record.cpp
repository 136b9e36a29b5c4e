#include "master/journal/alarm_record.hpp"

#include "common/core/limits/master.hpp"
#include "master/journal/row_bytes.hpp"

namespace cd {

namespace {

template <class T>
void add_to(std::vector<T>& list, const T& one, std::size_t most) {
    list.push_back(one);
    if (list.size() > most) {
        list.erase(list.begin());
    }
}

} // namespace

void AlarmRecord::add(const std::string& text) {
    ++count;
    add_to(last, text, limits::alarms_kept_max);
}

void AlarmRecord::quarantine(InstanceId process) {
    add_to(quarantined, process, limits::quarantined_kept_max);
}

Bytes encode_alarms(const AlarmRecord& alarms) {
    ByteWriter out;
    out.put(alarms.count);
    put_varint(out, alarms.last.size());
    for (const std::string& text : alarms.last) {
        out.put_text(text);
    }
    put_varint(out, alarms.quarantined.size());
    out.put_array(std::span<const InstanceId>(alarms.quarantined));
    return out.take();
}

Result<AlarmRecord> decode_alarms(std::span<const std::byte> bytes) {
    ByteReader in(bytes);
    AlarmRecord alarms;
    alarms.count = in.get<std::uint64_t>();
    const std::uint64_t texts = get_varint(in).value_or(limits::alarms_kept_max + 1);
    if (texts > limits::alarms_kept_max) {
        return damaged_row("a list of alarms");
    }
    for (std::uint64_t i = 0; i < texts; ++i) {
        alarms.last.push_back(in.get_text());
    }
    const std::uint64_t processes = get_varint(in).value_or(limits::quarantined_kept_max + 1);
    if (processes > limits::quarantined_kept_max) {
        return damaged_row("a list of alarms");
    }
    alarms.quarantined = in.get_array<InstanceId>(processes);
    if (!in.complete()) {
        return damaged_row("a list of alarms");
    }
    return alarms;
}

} // namespace cd
