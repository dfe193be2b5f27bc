// SPDX-License-Identifier: Apache-2.0
// A text server on the network speaks: it receives one line of UTF-8 for each utterance, and sends no answer. So a haptic grapher
// had its positions spoken by a synthesiser on another machine (J. P. Fritz, K. E. Barner, "Design of a haptic graphing system",
// RESNA
// 1996). It cannot be told to be silent.
#include <chrono>

#include "tactics/error.h"
#include "tactics/haptics/voice/voice.h"
#include "tactics/transport/channels.h"

namespace tactics {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kPatience{300};  // for a server that takes nothing, with each utterance

class TextServer : public Voice {
public:
    TextServer(std::unique_ptr<Channel> channel, std::string place) : channel_(std::move(channel)), place_(std::move(place)) {}
    std::string_view name() const override { return "tcp"; }

    // A line that was begun is ended before the next, which is left out if that takes too long.
    void say(const std::string& text) override {
        const auto end = Clock::now() + kPatience;
        if (channel_ == nullptr) return;
        if (rest_.empty() || send_until(end)) {
            rest_ = text + "\n";
            const std::size_t whole = rest_.size();
            send_until(end);
            if (rest_.size() == whole) rest_.clear();
        }
    }
    void stop() override {}
    Phrase trouble() override { return trouble_; }

private:
    bool send_until(Clock::time_point end) {
        while (!rest_.empty()) {
            const Channel::Taken taken = channel_->take(rest_);
            if (taken.ending != Ending::done) {
                trouble_ = phrase("{0}: the text server is gone; start it, then play again", place_);
                channel_.reset();
                rest_.clear();
                return false;
            }
            rest_.erase(0, taken.bytes);
            if (taken.bytes > 0) continue;
            const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now());
            if (left.count() <= 0) {
                trouble_ = phrase("{0}: the text server takes no text; see whether it still speaks", place_);
                return false;
            }
            channel_->wait(left);
        }
        return true;
    }
    std::unique_ptr<Channel> channel_;
    std::string place_, rest_;
    Phrase trouble_;
};

std::unique_ptr<Voice> open_tcp_text(const VoiceWish&, const std::string& where, Phrase& note) {
    const auto colon = where.rfind(':');
    if (colon == std::string::npos || colon == 0 || colon + 1 == where.size())
        throw Error(Fault::usage, "tcp:" + where, phrase("a text server has a host and a port; write tcp:HOST:PORT"));
    try {
        return std::make_unique<TextServer>(open_tcp(where.substr(0, colon), where.substr(colon + 1)), where);
    } catch (const Error& error) {
        note = phrase("nothing speaks: {0}", error.told());
        return nullptr;
    }
}

}  // namespace

extern const VoiceKind tcp_voice;
const VoiceKind tcp_voice{.name = "tcp",
                          .address = "HOST:PORT",
                          .summary = "a text server on the network, which receives a line of UTF-8 for each utterance",
                          .open = &open_tcp_text};

}  // namespace tactics
