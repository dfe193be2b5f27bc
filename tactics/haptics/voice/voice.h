// SPDX-License-Identifier: Apache-2.0
// Voices: a screen reader's speech, a separate synthesiser, a text server on the network, a file. The kinds are in a list
// (list.inc), one per line.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "tactics/text/phrase.h"

namespace tactics {

/// A voice. For one thread at a time; no function throws Error. `say` and `stop` return within a second, unless a library waits
/// for a stalled service, which Speaking survives.
class Voice {
public:
    virtual ~Voice() = default;
    virtual std::string_view name() const = 0;
    /// Speaks the text and interrupts the current speech. One line of UTF-8, of at most kMostSpoken bytes (spoken_line).
    virtual void say(const std::string& text) = 0;
    virtual void stop() = 0;
    /// Whether it takes each utterance at once, so that none has to be dropped.
    virtual bool takes_turns() const { return false; }
    /// Why speech is not heard, and the remedy, one line; empty: no known trouble.
    virtual Phrase trouble() { return {}; }
};

struct VoiceWish {
    std::string kind = "auto";    ///< or the name of a kind, with its address after a colon: "tcp:HOST:PORT"
    std::string language = "en";  ///< a BCP 47 tag
    int rate = 0;                 ///< words per minute, kLeastRate to kMostRate; 0: the voice's default
};
/// The range of espeak-ng (espeak-ng(1), -s), whose default is kUsualRate.
inline constexpr int kLeastRate = 80, kUsualRate = 175, kMostRate = 450;

struct OpenedVoice {
    std::unique_ptr<Voice> voice;  ///< never empty: "none" if there is no other
    Phrase note;                   ///< why it is not the requested one, and what to install; empty: it is
};

struct VoiceKind {
    std::string_view name = {};     ///< "tcp", as it is typed
    std::string_view address = {};  ///< what must follow it after a colon: "HOST:PORT"; empty: nothing
    std::string_view summary = {};
    bool automatic = false;  ///< "auto" tries it
    /// `where` is the part after the colon. Empty, with a note that says why, if there is none. Throws Error(usage) if `where` is
    /// invalid, Error(failed) for a file that cannot be written.
    std::unique_ptr<Voice> (*open)(const VoiceWish& wish, const std::string& where, Phrase& note) = nullptr;
};

std::span<const VoiceKind* const> voice_kinds();

/// Missing speech gives a note, not a failure. Throws Error(usage) for an unknown kind, language or rate, and the errors of a
/// kind. Returns within some seconds; call it before playing begins.
OpenedVoice open_voice(const VoiceWish& wish);

inline constexpr std::size_t kMostSpoken = 1000;  ///< bytes; a minute of speech

/// Text as one line for a speaker: control characters become blanks, invalid UTF-8 becomes '?', and it is cut at kMostSpoken
/// bytes.
std::string spoken_line(std::string_view text);

}  // namespace tactics
