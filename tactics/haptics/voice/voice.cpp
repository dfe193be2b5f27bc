// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/voice/voice.h"

#include <algorithm>
#include <vector>

#include "tactics/error.h"
#include "tactics/text/utf8.h"

namespace tactics {

#define VOICE(name) extern const VoiceKind name##_voice;
#include "tactics/haptics/voice/list.inc"
#undef VOICE

std::span<const VoiceKind* const> voice_kinds() {
    static const VoiceKind* const kKinds[] = {
#define VOICE(name) &name##_voice,
#include "tactics/haptics/voice/list.inc"
#undef VOICE
    };
    return kKinds;
}

namespace {

// It becomes a word of another program's command line.
bool is_language(std::string_view tag) {
    const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    return !tag.empty() && tag.size() <= 35 && is_letter(tag.front()) &&
           std::all_of(tag.begin(), tag.end(), [&](char c) { return is_letter(c) || (c >= '0' && c <= '9') || c == '-'; });
}

std::unique_ptr<Voice> silence() {
    Phrase note;
    return none_voice.open({}, "", note);
}

OpenedVoice open_first(const VoiceWish& wish) {
    std::vector<Phrase> notes;
    for (const VoiceKind* kind : voice_kinds()) {
        if (!kind->automatic) continue;
        Phrase note;
        if (auto voice = kind->open(wish, "", note)) return {std::move(voice), ""};
        notes.push_back(std::move(note));
    }
    Phrase all;
    for (Phrase& note : notes) all = all.empty() ? std::move(note) : phrase("{0}; {1}", std::move(all), std::move(note));
    return {silence(), phrase("nothing speaks: {0}", std::move(all))};
}

}  // namespace

OpenedVoice open_voice(const VoiceWish& wish) {
    if (!is_language(wish.language))
        throw Error(Fault::usage, "language \"" + beginning_of(to_line(wish.language)) + "\"",
                    phrase("is no tag of a language; write it as en or de-AT"));
    if (wish.rate != 0 && (wish.rate < kLeastRate || wish.rate > kMostRate))
        throw Error(Fault::usage, "speech",
                    phrase("speaks {0} to {1} words a minute, not {2}", std::to_string(kLeastRate), std::to_string(kMostRate),
                           std::to_string(wish.rate)));
    if (wish.kind == "auto") return open_first(wish);
    const auto colon = std::min(wish.kind.find(':'), wish.kind.size());
    const std::string name = wish.kind.substr(0, colon), where = wish.kind.substr(std::min(colon + 1, wish.kind.size()));
    std::vector<std::string_view> names = {"auto"};
    for (const VoiceKind* kind : voice_kinds()) {
        names.push_back(kind->name);
        if (kind->name != name) continue;
        if (where.empty() != kind->address.empty())
            throw Error(Fault::usage, wish.kind,
                        kind->address.empty() ? phrase("nothing stands behind this voice; write {0}", name)
                                              : phrase("say where; write {0}:{1}", name, kind->address));
        OpenedVoice opened;
        opened.voice = kind->open(wish, where, opened.note);
        if (opened.voice == nullptr) opened.voice = silence();
        return opened;
    }
    throw Error(Fault::usage, beginning_of(to_line(wish.kind)), phrase("no such voice{0}", did_you_mean(name, names)));
}

std::string spoken_line(std::string_view text) {
    std::string line = to_line(text);
    if (line.size() <= kMostSpoken) return line;
    std::string_view rest = line;
    while (line.size() - rest.size() < kMostSpoken) {
        std::string_view next = rest;
        take_letter(next);
        if (line.size() - next.size() > kMostSpoken) break;
        rest = next;
    }
    line.resize(line.size() - rest.size());
    return line;
}

}  // namespace tactics
