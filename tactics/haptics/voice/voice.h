// SPDX-License-Identifier: Apache-2.0
// What speaks: a screen reader's speech, a synthesiser of its own, a text server in the network, a file. The kinds are in a list
// (list.inc), one a line.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace tactics {

/// One that speaks. For one thread at a time; nothing of it throws Error. `say` and `stop` return within a second, unless a
/// library waits for a service that has stalled; Speaking bears that.
class Voice {
public:
    virtual ~Voice() = default;
    virtual std::string_view name() const = 0;
    /// Speaks it instead of what it still speaks. One line of UTF-8, of at most kMostSpoken bytes (spoken_line).
    virtual void say(const std::string& text) = 0;
    virtual void stop() = 0;
    /// Nothing need be left out for it: it is done with an utterance as soon as it was said.
    virtual bool takes_turns() const { return false; }
    /// Why what was said is not heard, and how to mend it, one line; empty: nothing is known against it.
    virtual std::string trouble() { return {}; }
};

struct VoiceWish {
    std::string kind = "auto";    ///< or the name of a kind, with what stands behind its name and a colon: "tcp:HOST:PORT"
    std::string language = "en";  ///< a tag of BCP 47
    int rate = 0;                 ///< words a minute, kLeastRate to kMostRate; 0: as the voice speaks by itself
};
/// What espeak-ng takes (espeak-ng(1), -s); it speaks kUsualRate by itself.
inline constexpr int kLeastRate = 80, kUsualRate = 175, kMostRate = 450;

struct OpenedVoice {
    std::unique_ptr<Voice> voice;  ///< never empty: "none" where there is no other
    std::string note;              ///< why it is not what was wished, and what to install; empty: it is
};

struct VoiceKind {
    std::string_view name = {};     ///< "tcp", as it is typed
    std::string_view address = {};  ///< what must stand behind it and a colon: "HOST:PORT"; empty: nothing
    std::string_view summary = {};
    bool automatic = false;  ///< "auto" tries it
    /// `where` is what stands behind the colon. Empty, with a note that says why, if there is none. Throws Error(usage) if
    /// `where` means nothing, Error(failed) for a file that cannot be written.
    std::unique_ptr<Voice> (*open)(const VoiceWish& wish, const std::string& where, std::string& note) = nullptr;
};

std::span<const VoiceKind* const> voice_kinds();

/// Speech that is absent is a note, not a failure. Throws Error(usage): no such kind, language or rate; and what a kind throws.
/// Returns within some seconds: before playing begins.
OpenedVoice open_voice(const VoiceWish& wish);

inline constexpr std::size_t kMostSpoken = 1000;  ///< bytes; a minute of speech

/// What a line-by-line speaker can take: controls become blanks, what is no UTF-8 becomes '?', and it ends at kMostSpoken bytes.
std::string spoken_line(std::string_view text);

}  // namespace tactics
