// SPDX-License-Identifier: Apache-2.0
// A scripted tour of a plot, spoken by the voice that is named: for the script of the same name.
//
//     speech VOICE SECONDS     SECONDS between one announcement and the next
#include <chrono>
#include <cstdio>
#include <exception>
#include <thread>
#include <vector>

#include "tactics/haptics/voice/plot_words.h"
#include "tactics/haptics/voice/speaking.h"
#include "tactics/text/number.h"

namespace {

using namespace tactics;

Plot drive() {
    Plot plot;
    plot.x.name = "time (s)";
    plot.y.name = "speed, m/s";
    plot.curves = {{"car", {{0, 0}, {2, 8}, {4, 30}, {10, 3}}}, {"bus", {{0, 0}, {5, 20}, {10, 20}}}};
    plot.marks = {{"A", 8, 28}};
    return plot;
}

std::vector<Announcement> tour() {
    using enum Telling;
    return {{.telling = position, .x = 2.5, .y = 12},
            {.telling = under_finger, .felt = FeltPart::x_tick, .x = 2.5},
            {.telling = under_finger, .felt = FeltPart::y_grid, .y = 10},
            {.telling = under_finger, .felt = FeltPart::curve, .series = 0},
            {.telling = nearest, .x = 1.7, .y = 8},
            {.telling = highest, .series = 0},
            {.telling = comparison, .series = 0, .other = 1, .x = 3},
            {.telling = position, .x = -1.25, .y = -3},
            {.telling = nearest, .x = 8, .y = 25},
            {.telling = curve_end, .x = 10, .y = 4}};
}

int speak(const char* voice, double seconds) {
    using Clock = std::chrono::steady_clock;
    const auto begun = Clock::now();
    OpenedVoice opened = open_voice({.kind = voice});
    if (!opened.note.empty()) std::printf("note %s\n", opened.note.english().c_str());
    const PlotWords words(std::make_shared<const Plot>(drive()), {{0, 10, 100}, {0, 30, 60}});
    const auto opened_at = Clock::now();
    Speaking speaking(std::move(opened.voice), [words](const Announcement& one) { return words.of(one).english(); });
    for (const Announcement& one : tour()) {
        std::printf("asked %s\n", words.of(one).english().c_str());
        speaking.ask(one);
        std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
    }
    const auto ending = Clock::now();
    const bool ended = speaking.finish();
    const SpokenCounts counts = speaking.counts();
    const auto between = [](Clock::time_point from, Clock::time_point to) {
        return to_text(std::chrono::duration<double>(to - from).count());
    };
    if (!speaking.note().empty()) std::printf("note %s\n", speaking.note().english().c_str());
    std::printf("counts said %llu overtaken %llu dropped %llu ended %d\nseconds open %s end %s\n",
                static_cast<unsigned long long>(counts.said), static_cast<unsigned long long>(counts.overtaken),
                static_cast<unsigned long long>(counts.dropped), ended ? 1 : 0, between(begun, opened_at).c_str(),
                between(ending, Clock::now()).c_str());
    return 0;
}

}  // namespace

int main(int count, char** words) {
    const auto seconds = count == 3 ? parse_number(words[2]) : std::nullopt;
    if (!seconds) return std::fprintf(stderr, "usage: speech VOICE SECONDS\n"), 1;
    try {
        return speak(words[1], *seconds);
    } catch (const std::exception& fault) {
        return std::fprintf(stderr, "%s\n", fault.what()), 2;
    }
}
