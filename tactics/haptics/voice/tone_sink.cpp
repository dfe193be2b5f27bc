// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/voice/tone_sink.h"

#include "tactics/error.h"
#include "tactics/text/utf8.h"

namespace tactics {

namespace {

class Nowhere : public ToneSink {
public:
    void take(std::span<const std::int16_t>) override {}
};

}  // namespace

OpenedTones open_tones(const std::string& wish) {
    if (wish == "none") return {std::make_unique<Nowhere>(), ""};
    if (wish.starts_with("wav:") && wish.size() > 4) return {open_wav(wish.substr(4)), ""};
    if (wish != "alsa")
        throw Error(Fault::usage, beginning_of(to_line(wish)), "tones do not go there; write alsa, wav:FILE or none");
    OpenedTones opened;
    opened.sink = open_alsa(opened.note);
    if (opened.sink == nullptr) opened.sink = std::make_unique<Nowhere>();
    return opened;
}

}  // namespace tactics
