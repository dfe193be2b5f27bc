// SPDX-License-Identifier: Apache-2.0
#include "print/screen.h"

#include <algorithm>

#include "print/cell_rows.h"
#include "print/embosser.h"
#include "print/pin_display.h"
#include "tactics/error.h"

namespace tactics {

namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;
using Kind = PinAnswer::Kind;

constexpr milliseconds kForAnswer{1500};  // that a message has come in, and its size
constexpr milliseconds kForPins{5000};    // that pins stand, of those that say so
constexpr milliseconds kBetween{50};      // between messages to one that says nothing: a row is 4 ms on the line
constexpr int kTimes = 3;

class PinScreen : public Screen {
public:
    PinScreen(const Format& format, const Settings& settings, std::unique_ptr<Channel> channel, std::string place)
        : format_(format),
          display_(*format.embosser->display),
          settings_(settings),
          place_(std::move(place)),
          channel_(std::move(channel)) {
        ask();
    }
    ~PinScreen() override {
        try {
            if (!display_.farewell.empty()) send(display_.farewell);
        } catch (const Error&) {  // it is gone, and its keys with it
        }
    }
    PinScreen(const PinScreen&) = delete;
    PinScreen& operator=(const PinScreen&) = delete;

    const Format& format() const override { return format_; }
    const Settings& settings() const override { return settings_; }
    bool keeps() const override { return true; }

    bool show(const Page& page) override {
        const std::string bytes = format_.encode(page, settings_);
        bool confirmed = true;
        for (std::string_view rest = bytes; !rest.empty();) {
            const std::string_view message = rest.substr(0, std::max<std::size_t>(1, display_.message(rest)));
            confirmed = set(message) && confirmed;
            rest.remove_prefix(message.size());
        }
        return confirmed;
    }

    bool key_within(milliseconds time) override {
        const auto end = Clock::now() + time;
        while (const auto answer = pressed_ ? std::nullopt : answer_until(end)) take_keys(answer->kind);
        const bool pressed = pressed_;
        pressed_ = false;
        return pressed;
    }

private:
    // One that was just plugged in may miss the first question.
    void ask() {
        for (int time = 0; time < kTimes; ++time) {
            send(display_.question);
            const auto end = Clock::now() + kForAnswer;
            while (const auto answer = answer_until(end)) {
                if (answer->kind == Kind::told) return;
                if (answer->kind == Kind::too_small)
                    throw Error(Fault::failed, place_,
                                phrase("the display has cells for text but no pins; show on it by brlapi:"));
            }
        }
        throw Error(Fault::failed, place_,
                    phrase("no answer as of {0}; switch it on, look whether this is its line (tactics devices), and end other "
                           "programs that use it, such as BRLTTY",
                           format_.name));
    }

    // Whether its pins stand, as far as it says.
    bool set(std::string_view message) {
        const int row = display_.row(message);
        for (int time = 0; time < kTimes; ++time) {
            send(message);
            auto end = Clock::now() + (answers_ ? kForAnswer : kBetween);
            bool again = false, taken = false;
            while (const auto answer = again ? std::nullopt : answer_until(end)) {
                take_keys(answer->kind);
                if (row >= 0 && answer->row >= 0 && answer->row != row) continue;  // of a row before
                if (answer->kind == Kind::standing) return true;
                if (answer->kind == Kind::refused)
                    throw Error(
                        Fault::failed, place_,
                        phrase("the display refused what it was sent; look whether it is a {0}", format_.embosser->models));
                if (answer->kind == Kind::taken && !taken) {
                    taken = true;
                    end = Clock::now() + kForPins;
                }
                again = answer->kind == Kind::again;
            }
            if (!again) {
                if (!taken) answers_ = false;
                return taken;
            }
        }
        throw Error(Fault::failed, place_,
                    phrase("the display takes no picture now; wait a moment, or switch it off and on again"));
    }

    void take_keys(Kind kind) {
        if (kind == Kind::keys_down && !down_) pressed_ = true;
        if (kind == Kind::keys_down) down_ = true;
        if (kind == Kind::keys_up) down_ = false;
    }

    // The next answer; nothing: none came until then.
    std::optional<PinAnswer> answer_until(Clock::time_point end) {
        for (;;) {
            if (const auto answer = display_.next(heard_, settings_)) {
                if (!display_.thanks.empty()) send(display_.thanks);
                return answer;
            }
            const auto left = std::chrono::duration_cast<milliseconds>(end - Clock::now());
            if (left.count() <= 0) return std::nullopt;
            const auto more = channel_->hear(left);
            if (!more) gone();
            constexpr std::size_t kMost = 4096;  // of what makes no sense
            heard_ += *more;
            if (heard_.size() > kMost) heard_.erase(0, heard_.size() - kMost);
        }
    }

    void send(std::string_view bytes) {
        DeliveryWish wish;
        wish.patience = kForPins;
        if (const Delivery sent = deliver(*channel_, bytes, wish); sent.ending == Ending::gone)
            gone();
        else if (sent.ending != Ending::done)
            throw Error(Fault::failed, place_, phrase("the display takes nothing; switch it off and on again"));
    }

    [[noreturn]] void gone() const {
        throw Error(Fault::failed, place_, phrase("the display is gone; plug it in, switch it on and show the picture again"));
    }

    const Format& format_;
    const PinDisplay& display_;
    Settings settings_;
    std::string place_;
    std::unique_ptr<Channel> channel_;
    std::string heard_;
    bool answers_ = true, down_ = false, pressed_ = false;
};

class CellScreen : public Screen {
public:
    CellScreen(std::unique_ptr<CellDisplay> display, bool keeps, const std::string& place)
        : format_(*find_format("braille-display")), settings_(format_.options), display_(std::move(display)), keeps_(keeps) {
        const CellDisplaySize size = display_->size();
        try {
            settings_.set("columns", std::to_string(size.columns), "", format_.name);
            settings_.set("lines", std::to_string(size.lines), "", format_.name);
            settings_.set("dots", std::to_string(size.dots), "", format_.name);
        } catch (const Error&) {
            throw Error(
                Fault::failed, place,
                phrase("the display tells of {0} x {1} cells, on which nothing can be shown; look whether it is switched on",
                       std::to_string(size.columns), std::to_string(size.lines)));
        }
    }

    const Format& format() const override { return format_; }
    const Settings& settings() const override { return settings_; }
    bool keeps() const override { return keeps_; }
    bool key_within(milliseconds time) override { return display_->key_within(time); }

    bool show(const Page& page) override {
        const CellDisplaySize size = display_->size();
        display_->show(cells_of(page, static_cast<std::size_t>(size.columns), static_cast<std::size_t>(size.lines)));
        return true;
    }

private:
    const Format& format_;
    Settings settings_;
    std::unique_ptr<CellDisplay> display_;
    bool keeps_;
};

}  // namespace

std::unique_ptr<Screen> pin_screen(const Format& format, const Settings& settings, std::unique_ptr<Channel> channel,
                                   const std::string& place) {
    return std::make_unique<PinScreen>(format, settings, std::move(channel), place);
}

std::unique_ptr<Screen> cell_screen(std::unique_ptr<CellDisplay> display, bool keeps, const std::string& place) {
    return std::make_unique<CellScreen>(std::move(display), keeps, place);
}

}  // namespace tactics
