// SPDX-License-Identifier: Apache-2.0
// Silence.
#include "tactics/haptics/voice/voice.h"

namespace tactics {

namespace {

class Silence : public Voice {
public:
    std::string_view name() const override { return "none"; }
    void say(const std::string&) override {}
    void stop() override {}
};

std::unique_ptr<Voice> open_none(const VoiceWish&, const std::string&, Phrase&) { return std::make_unique<Silence>(); }

}  // namespace

extern const VoiceKind none_voice;
const VoiceKind none_voice{.name = "none", .summary = "nothing is spoken", .open = &open_none};

}  // namespace tactics
