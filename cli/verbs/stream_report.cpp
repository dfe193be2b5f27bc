// SPDX-License-Identifier: Apache-2.0
#include "cli/verbs/stream_report.h"

#include "tactics/text/json.h"
#include "tactics/text/rounded.h"
#include "tactics/text/table.h"

namespace tactics {

namespace {

constexpr std::string_view kDirections[] = {"right", "down", "up"};

std::string media_table(const StreamReport& report) {
    std::vector<Row> rows = {{"medium", "levels", "bits in", "bits carried", "loss", "what is lost"}};
    for (const StreamMedium& medium : report.media) {
        const CarriedForces& carried = medium.carried;
        std::string lost = carried.levels < report.stream.levels ? "steps finer than " + to_text(kLeastForce) + " N" : "";
        if (carried.cut > 0)
            lost += (lost.empty() ? "" : "; ") + ("forces over " + to_text(medium.channel.most_force)) + " N (" +
                    percent(static_cast<double>(carried.cut) / static_cast<double>(report.stream.ticks)) + " of its ticks)";
        rows.push_back({medium.channel.name, std::to_string(carried.levels), fixed(report.stream.high, 0), fixed(carried.bits, 0),
                        exact_percent(carried.loss), lost.empty() ? "nothing" : lost});
    }
    return aligned(std::move(rows));
}

}  // namespace

std::string text_of(const StreamReport& report) {
    const MeasuredStream& stream = report.stream;
    const auto ticks = static_cast<double>(stream.ticks);
    std::string text = report.file + ": recording of " + std::to_string(stream.ticks) + " ticks in " +
                       rounded(stream.seconds, 1e-3) + " s, forces up to " + rounded(stream.most, 1e-3) + " N in " +
                       std::to_string(stream.levels) + " levels\n";
    text += "bits in it: " + fixed(stream.low, 0) + " to " + fixed(stream.high, 0) + " (" + fixed(stream.low / ticks, 3) +
            " to " + fixed(stream.high / ticks, 3) + " a tick)\n";
    text += "enough for a hand that feels a tenth of a force: " + std::to_string(stream.felt) + " ticks, " +
            rounded(1000 * static_cast<double>(stream.felt) / ticks, 0.1) + " of 1000\n\n";
    std::vector<Row> rows = {{"force", "bits", "of its levels alone, a tick", "topology index"}};
    for (std::size_t i = 0; i < stream.along.size(); ++i)
        rows.push_back({std::string(kDirections[i]), fixed(stream.along[i].high, 0), fixed(stream.along[i].alone.corrected, 3),
                        fixed(stream.along[i].topology, 3)});
    text += aligned(std::move(rows));
    if (!report.media.empty()) text += "\n" + media_table(report);
    return text;
}

std::string json_of(const StreamReport& report) {
    const MeasuredStream& stream = report.stream;
    JsonAnswer json;
    json.add("input", report.file);
    json.add("format", "recording");
    json.add("ticks", static_cast<double>(stream.ticks));
    json.add("seconds", stream.seconds);
    json.add("most_force_n", stream.most);
    json.add("levels", stream.levels);
    json.add("low_bits", stream.low);
    json.add("high_bits", stream.high);
    json.add("felt_ticks", static_cast<double>(stream.felt));
    std::vector<std::string> along, media;
    for (std::size_t i = 0; i < stream.along.size(); ++i) {
        JsonObject one;
        one.add("direction", kDirections[i]);
        one.add("low_bits", stream.along[i].low);
        one.add("high_bits", stream.along[i].high);
        one.add("levels_alone_bits_a_tick", stream.along[i].alone.corrected);
        one.add("topology_index", stream.along[i].topology);
        along.push_back(one.text());
    }
    for (const StreamMedium& medium : report.media) {
        JsonObject one;
        one.add("medium", medium.channel.name);
        one.add("kind", medium.channel.kind);
        one.add("most_force_n", medium.channel.most_force);
        one.add("levels", medium.carried.levels);
        one.add("carried_bits", medium.carried.bits);
        one.add("loss", medium.carried.loss);
        one.add("ticks_cut", static_cast<double>(medium.carried.cut));
        media.push_back(one.text());
    }
    json.add_raw("along", json_array(along));
    json.add_raw("media", json_array(media));
    json.add_raw("notes", json_text_array(report.notes));
    return json.text() + "\n";
}

}  // namespace tactics
