// SPDX-License-Identifier: Apache-2.0
#include "cli/verbs/stream_report.h"

#include <cmath>

#include "cli/report/user_language.h"
#include "tactics/text/json.h"
#include "tactics/text/table.h"

namespace tactics {

namespace {

constexpr std::string_view kDirections[] = {"right", "down", "up"};
constexpr SourceWords kSpoken[] = {"right", "down", "up"};

Phrase rounded_to(double value, double step) { return numeral(std::round(value / step) * step); }

std::string in_words(const Phrase& line) { return line.in(user_language()) + "\n"; }

Phrase lost_of(const StreamMedium& medium, const StreamReport& report) {
    const CarriedForces& carried = medium.carried;
    std::vector<Phrase> lost;
    if (carried.levels < report.stream.levels) lost.push_back(phrase("steps finer than {0} N", numeral(kLeastForce)));
    if (carried.cut > 0)
        lost.push_back(phrase("forces over {0} N ({1} of its ticks)", numeral(medium.channel.most_force),
                              for_user(percent(static_cast<double>(carried.cut) / static_cast<double>(report.stream.ticks)))));
    if (lost.empty()) return phrase("nothing");
    return lost.size() == 1 ? lost[0] : phrase("{0}; {1}", lost[0], lost[1]);
}

std::string media_table(const StreamReport& report) {
    std::vector<Row> rows = {in_language(
        {phrase("medium"), phrase("levels"), phrase("bits in"), phrase("bits carried"), phrase("loss"), phrase("what is lost")},
        user_language())};
    for (const StreamMedium& medium : report.media) {
        const CarriedForces& carried = medium.carried;
        rows.push_back({medium.channel.name, std::to_string(carried.levels), for_user(fixed(report.stream.bits, 0)),
                        for_user(fixed(carried.bits, 0)), for_user(exact_percent(carried.loss)),
                        lost_of(medium, report).in(user_language())});
    }
    return aligned(std::move(rows));
}

}  // namespace

std::string text_of(const StreamReport& report) {
    const MeasuredStream& stream = report.stream;
    const auto ticks = static_cast<double>(stream.ticks);
    std::string text = in_words(phrase("{0}: recording of {1} ticks in {2} s, forces up to {3} N in {4} levels", report.file,
                                       std::to_string(stream.ticks), rounded_to(stream.seconds, 1e-3),
                                       rounded_to(stream.most, 1e-3), std::to_string(stream.levels)));
    text +=
        in_words(phrase("bits in it: {0} to {1} ({2} to {3} a tick), {4} by the shortest code", for_user(fixed(stream.low, 0)),
                        for_user(fixed(stream.high, 0)), for_user(fixed(stream.low / ticks, 3)),
                        for_user(fixed(stream.high / ticks, 3)), for_user(fixed(stream.bits, 0))));
    text += in_words(phrase("enough for a hand that feels a tenth of a force: {0} ticks, {1} of 1000",
                            std::to_string(stream.felt), rounded_to(1000 * static_cast<double>(stream.felt) / ticks, 0.1))) +
            "\n";
    std::vector<Row> rows = {in_language(
        {phrase("force"), phrase("bits"), phrase("of its levels alone, a tick"), phrase("topology index")}, user_language())};
    for (std::size_t i = 0; i < stream.along.size(); ++i)
        rows.push_back({phrase(kSpoken[i]).in(user_language()), for_user(fixed(stream.along[i].bits, 0)),
                        for_user(fixed(stream.along[i].alone.corrected, 3)), for_user(fixed(stream.along[i].topology, 3))});
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
    json.add("bits", stream.bits);
    json.add("high_bits", stream.high);
    json.add("felt_ticks", static_cast<double>(stream.felt));
    std::vector<std::string> along, media;
    for (std::size_t i = 0; i < stream.along.size(); ++i) {
        JsonObject one;
        one.add("direction", kDirections[i]);
        one.add("low_bits", stream.along[i].low);
        one.add("bits", stream.along[i].bits);
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
