// SPDX-License-Identifier: Apache-2.0
// Writes utterances line by line to a file, each with its time in seconds.
#include <chrono>
#include <cstdio>
#include <fstream>

#include "tactics/error.h"
#include "tactics/haptics/voice/voice.h"

namespace tactics {

namespace {

using Clock = std::chrono::steady_clock;

class Recording : public Voice {
public:
    explicit Recording(const std::string& path) : path_(path), file_(path, std::ios::binary | std::ios::trunc) {
        if (!file_) throw Error(Fault::failed, path, phrase("cannot be written; see that its folder is there and yours"));
    }
    std::string_view name() const override { return "recording"; }
    bool takes_turns() const override { return true; }
    void say(const std::string& text) override { write(text); }
    void stop() override {}
    Phrase trouble() override {
        if (file_) return {};
        return phrase("{0}: what is spoken can no longer be written there; make room on the disk", path_);
    }

private:
    // Milliseconds of the time since it was opened, by integers: no locale has a part in it.
    void write(const std::string& text) {
        const auto ms = std::chrono::duration_cast<std::chrono::milliseconds>(Clock::now() - begun_).count();
        char time[32];
        std::snprintf(time, sizeof time, "%lld.%03lld ", static_cast<long long>(ms / 1000), static_cast<long long>(ms % 1000));
        file_ << time << text << '\n' << std::flush;
    }
    std::string path_;
    std::ofstream file_;
    Clock::time_point begun_ = Clock::now();
};

std::unique_ptr<Voice> open_recording(const VoiceWish&, const std::string& where, Phrase&) {
    return std::make_unique<Recording>(where);
}

}  // namespace

extern const VoiceKind recording_voice;
const VoiceKind recording_voice{.name = "recording",
                                .address = "FILE",
                                .summary = "a file: each utterance is a line, after the time in seconds at which it was spoken",
                                .open = &open_recording};

}  // namespace tactics
