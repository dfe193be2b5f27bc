#include "cli/screen.h"

#include <algorithm>

#include "cli/chain.h"
#include "print/cell_rows.h"
#include "print/embosser.h"
#include "print/pin_display.h"
#include "tactics/error.h"
#include "tactics/transport/cell_display.h"
#include "tactics/transport/channels.h"
#include "tactics/words.h"

namespace tactics {

namespace {

using std::chrono::milliseconds;

constexpr milliseconds kStep{50};

// --set of that format; others are filters'.
Settings settings_of(const Format& format, const std::vector<std::string>& sets) {
    Settings settings(format.options);
    for (const std::string& text : sets)
        if (const Change change = parse_change(text, "--set"); change.name == format.name) settings.set(change.option, change.value, change.place, change.name);
    return settings;
}

class PinScreen : public Screen {
public:
    PinScreen(const Format& format, const std::string& path, const std::vector<std::string>& sets)
        : format_(format), display_(*format.embosser->display), settings_(settings_of(format, sets)), path_(path),
          channel_(open_serial(path, display_.baud, Flow::none)) {
        if (!display_.question.empty()) learn();
    }

    const Format& format() const override { return format_; }
    const Settings& settings() const override { return settings_; }
    bool keeps() const override { return true; }

    void show(const Page& page) override {
        const std::string bytes = format_.encode(page, settings_);
        for (std::string_view rest = bytes; !rest.empty();) {
            const std::size_t size = std::max<std::size_t>(1, display_.message(rest));
            send(rest.substr(0, size));
            hear_reply();
            rest.remove_prefix(size);
        }
    }

    bool key_within(milliseconds time) override { return display_.reply(channel_->hear(time)) == PinDisplay::Reply::key; }

private:
    // A display that was just plugged in may miss the first question.
    void learn() {
        constexpr int kQuestions = 3;
        std::string heard;
        for (int question = 0; question < kQuestions; ++question) {
            send(display_.question);
            for (milliseconds waited{0}; waited < milliseconds{1000}; waited += kStep) {
                heard += channel_->hear(kStep);
                if (display_.learn(heard, settings_)) return;
            }
        }
        throw Error(Fault::failed, path_, "no answer as of " + std::string(format_.name) + "; switch it on, look whether this is its line (tactics devices), and end other programs that use it");
    }

    void send(std::string_view bytes) {
        DeliveryWish wish;
        wish.patience = milliseconds{5000};
        if (const Delivery sent = deliver(*channel_, bytes, wish); sent.ending != Ending::done)
            throw Error(Fault::failed, path_, sent.ending == Ending::gone ? "the display is gone: unplugged or switched off" : "the display takes nothing; switch it off and on again");
    }

    // It is answered when its pins stand; one that never answers is sent all the same.
    void hear_reply() {
        std::string heard;
        for (milliseconds waited{0}; waited < (answers_ ? milliseconds{5000} : kStep); waited += kStep) {
            heard += channel_->hear(kStep);
            switch (display_.reply(heard)) {
                case PinDisplay::Reply::taken: return;
                case PinDisplay::Reply::refused:
                    throw Error(Fault::failed, path_, "the display refused what it was sent; look whether it is a " + std::string(format_.embosser->models));
                default: break;
            }
        }
        answers_ = false;
    }

    const Format& format_;
    const PinDisplay& display_;
    Settings settings_;
    std::string path_;
    std::unique_ptr<Channel> channel_;
    bool answers_ = true;
};

class CellScreen : public Screen {
public:
    CellScreen(std::unique_ptr<CellDisplay> display, bool keeps)
        : format_(*find_format("braille-display")), settings_(format_.options), display_(std::move(display)), keeps_(keeps) {
        const CellDisplaySize size = display_->size();
        settings_.set("columns", std::to_string(size.columns), "the display", format_.name);
        settings_.set("lines", std::to_string(size.lines), "the display", format_.name);
        settings_.set("dots", std::to_string(size.dots), "the display", format_.name);
    }

    const Format& format() const override { return format_; }
    const Settings& settings() const override { return settings_; }
    bool keeps() const override { return keeps_; }
    bool key_within(milliseconds time) override { return display_->key_within(time); }

    void show(const Page& page) override {
        const CellDisplaySize size = display_->size();
        display_->show(cells_of(page, static_cast<std::size_t>(size.columns), static_cast<std::size_t>(size.lines)));
    }

private:
    const Format& format_;
    Settings settings_;
    std::unique_ptr<CellDisplay> display_;
    bool keeps_;
};

}  // namespace

std::unique_ptr<Screen> open_screen(const std::string& address, const std::vector<std::string>& sets, const std::string& place) {
    const auto colon = address.find(':');
    const std::string name = address.substr(0, colon), rest = colon == std::string::npos ? "" : address.substr(colon + 1);
    if (name == "hid") return std::make_unique<CellScreen>(open_hid_display(rest), true);
    if (name == "brlapi") return std::make_unique<CellScreen>(open_brlapi(rest), false);
    std::vector<std::string_view> names{"brlapi", "hid"};
    for (const Format* format : formats()) {
        if (format->embosser == nullptr || format->embosser->display == nullptr) continue;
        names.push_back(format->name);
        if (name != format->name) continue;
        if (rest.empty()) throw Error(Fault::usage, place, "say which line it is on: " + name + ":/dev/ttyUSB0; see tactics devices");
        return std::make_unique<PinScreen>(*format, rest, sets);
    }
    throw Error(Fault::usage, place, "there is no display \"" + name.substr(0, 80) + "\"" + did_you_mean(name, names) +
                                         "; it is dot-pad:/dev/ttyUSB0, graphiti:/dev/ttyACM0, hid: or brlapi:, for example; see tactics devices and tactics list displays");
}

}  // namespace tactics
