// SPDX-License-Identifier: Apache-2.0
#include "cli/verbs/play_scene.h"

#include <algorithm>

#include "cli/interrupt_count.h"
#include "cli/report/report.h"
#include "cli/report/say.h"
#include "cli/verbs/tick_log.h"
#include "tactics/haptics/loop/play_loop.h"
#include "tactics/haptics/loop/timed_scene.h"

namespace tactics {

namespace {

void tell_news(const std::string& device, DeviceNews news, const std::string& why) {
    const std::string place = device == "hid:" ? "hid" : device;
    if (news == DeviceNews::gone)
        say(phrase("{0}: it is gone; plug it in again, or end with Ctrl-C", place));
    else if (news == DeviceNews::silent)
        say(phrase("{0}: it says nothing, its force is off; unplug it and plug it in again, or end with Ctrl-C", place));
    else
        say(news == DeviceNews::back ? phrase("{0}: there again", place) : Phrase(why));
}

}  // namespace

PlayedScene play_scene(Scene& scene, HapticDevice& device, Fusion* fusion, SceneWish wish) {
    const double rate = wish.settings.rate_hz;
    wish.settings.most_records = static_cast<std::size_t>(std::clamp(rate * wish.seconds.value_or(600), 1000.0, 2e6));
    TimedScene timed(scene);
    Playing play(timed, fusion, wish.settings);
    std::optional<TickLog> log;
    if (!wish.csv.empty()) log.emplace(wish.csv, play.recorder(), wish.columns);
    count_interrupts();
    const bool by_wall = wish.by_wall || device.is_real();
    if (log && by_wall) log->write_beside();
    const auto ended = [&] {
        if (log && !by_wall) log->keep_up();
        return interrupts() > 0;
    };
    const PlayLoop loop{rate, wish.seconds, ended,
                        [&](DeviceNews news, const std::string& why) { tell_news(wish.device, news, why); }};
    // By the clock on the wall where something moves by it; else as quickly as the processor can.
    StepClock stepped;
    std::optional<MonotonicClock> punctual;
    if (by_wall) punctual.emplace(true);
    const PlayLoopReport report = run_play(loop, punctual ? static_cast<Clock&>(*punctual) : stepped, device, play);
    const bool before_others = punctual && punctual->goes_before_others();
    punctual.reset();

    // Reports the results even if the log failed.
    PlayedScene played;
    played.records = play.recorder().records();
    played.figures = figures_of(played.records, report, play, wish.law, timed.times(), fusion != nullptr ? fusion->resets() : 0,
                                before_others, by_wall);
    played.lost = play.recorder().lost();
    try {
        if (log) log->finish();
    } catch (const Error& error) {
        played.unlogged = error;
    }
    return played;
}

void tell_figures(const PlayedScene& played, bool quiet, bool json, const std::string& more) {
    if (json) {
        std::string object = figures_json(played.figures);
        if (!more.empty()) object.insert(object.size() - 1, "," + more);
        print_out(object + "\n");
    } else if (!quiet) {
        for (const Phrase& line : figure_lines(played.figures, played.lost)) say(line);
    }
}

}  // namespace tactics
