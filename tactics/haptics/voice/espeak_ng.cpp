// SPDX-License-Identifier: Apache-2.0
// The program espeak-ng (espeak-ng(1)): one process speaks one utterance, which it reads from its standard input, and is ended by
// the next utterance. Without words among its arguments it reads its input line by line.
#include <chrono>

#include "tactics/haptics/voice/voice.h"
#include "tactics/transport/child.h"

namespace tactics {

namespace {

class EspeakNg : public Voice {
public:
    explicit EspeakNg(std::vector<std::string> words) : words_(std::move(words)) {}
    std::string_view name() const override { return "espeak-ng"; }
    void say(const std::string& text) override {
        look();
        speaking_.reset();
        speaking_ = std::make_unique<ChildBeside>(words_, text + "\n");
    }
    void stop() override {
        look();
        speaking_.reset();
    }
    Phrase trouble() override {
        look();
        return trouble_;
    }

private:
    void look() {
        if (speaking_ == nullptr || speaking_->how() == ChildAnswer::End::done) return;
        trouble_ = phrase("espeak-ng spoke nothing; see that \"espeak-ng hello\" is heard");
    }
    std::vector<std::string> words_;
    std::unique_ptr<ChildBeside> speaking_;
    Phrase trouble_;
};

std::unique_ptr<Voice> open_espeak_ng(const VoiceWish& wish, const std::string&, Phrase& note) {
    std::vector<std::string> words = {"espeak-ng", "-v", wish.language};
    if (wish.rate != 0) words.insert(words.end(), {"-s", std::to_string(wish.rate)});
    // Without a sound: is it there, and does it know the language?
    std::vector<std::string> quiet = words;
    quiet.emplace_back("-q");
    const ChildAnswer answer = run_child(quiet, "a\n", {.time = std::chrono::seconds(3), .bytes = 1 << 16});
    if (answer.end == ChildAnswer::End::done) return std::make_unique<EspeakNg>(std::move(words));
    if (answer.end == ChildAnswer::End::missing)
        note = phrase("espeak-ng is not there; install espeak-ng");
    else if (answer.end == ChildAnswer::End::failed)
        note = phrase("espeak-ng does not speak \"{0}\"; name a language that it knows, such as en", wish.language);
    else
        note = phrase("espeak-ng does not answer; see that \"espeak-ng hello\" is heard");
    return nullptr;
}

}  // namespace

extern const VoiceKind espeak_ng_voice;
const VoiceKind espeak_ng_voice{.name = "espeak-ng",
                                .summary = "the synthesiser espeak-ng, run as a separate program",
                                .automatic = true,
                                .open = &open_espeak_ng};

}  // namespace tactics
