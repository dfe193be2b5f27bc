// SPDX-License-Identifier: Apache-2.0
#include "cli/verbs/play_speech.h"

#include <memory>
#include <utility>

#include "cli/report/say.h"
#include "tactics/error.h"
#include "tactics/haptics/voice/plot_words.h"
#include "tactics/haptics/voice/voice.h"
#include "tactics/text/catalogue.h"

namespace tactics {

std::optional<Speaking> speaking_of(const Given& given, const Plot& plot, const PlotFrame& frame, bool quiet) {
    if (!given.has("--speak")) {
        if (given.has("--language")) throw Error(Fault::usage, "--language", phrase("it is that of --speak; name a voice, too"));
        return std::nullopt;
    }
    const std::string language = given.value("--language", "en");
    OpenedVoice opened = open_voice({.kind = given.value("--speak"), .language = language});
    if (!opened.note.empty() && !quiet) say(opened.note);
    if (!quiet && spoken_language(language) != language.substr(0, language.find('-')))
        say(phrase("there are no words in the language \"{0}\" yet, so the voice reads English ones", language));
    const auto span = [](const FeltAxis& axis, double length) { return AxisSpan{axis.low, axis.high, length}; };
    const SpokenFrame spoken{span(frame.x, frame.width), span(frame.y, frame.height), span(frame.z, frame.depth)};
    PlotWords words(std::make_shared<Plot>(plot), spoken);
    return std::optional<Speaking>(std::in_place, std::move(opened.voice),
                                   [words, language](const Announcement& one) { return words.of(one).in(language); });
}

void tell_voice(Speaking& speaking, bool quiet) {
    const bool ended = speaking.finish();
    if (quiet) return;
    if (!speaking.note().empty()) say(speaking.note());
    if (!ended) say(phrase("the voice did not end and is left to itself"));
}

}  // namespace tactics
