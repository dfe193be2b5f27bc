// SPDX-License-Identifier: Apache-2.0
#include "tactics/transport/delivery.h"

#include <algorithm>
#include <thread>

namespace tactics {

namespace {

using std::chrono::milliseconds;
using Cancel = DeliveryWish::Cancel;

// In steps, so that being cancelled is seen soon.
constexpr milliseconds kStep{100};
// A machine that punches a page may take nothing for some seconds.
constexpr milliseconds kQuiet{10'000};
// The kernel takes at most so much of a USB printer's bytes in one call (measured on 6.1).
constexpr std::size_t kChunk = 8192;

class Delivering {
public:
    Delivering(Channel& channel, std::string_view bytes, const DeliveryWish& wish)
        : channel_(channel), bytes_(bytes), wish_(wish), end_(bytes.size()) {}

    Delivery run() {
        for (look_for_cancel(); accepted_ < end_; look_for_cancel()) {
            const Channel::Taken taken = channel_.take(bytes_.substr(accepted_, std::min(kChunk, end_ - accepted_)));
            accepted_ += taken.bytes;
            if (taken.ending != Ending::done) return end_with(taken.ending, taken.why);
            if (taken.bytes > 0)
                take_notice();
            else if (!channel_.wait(kStep) && is_over())
                return end_with(channel_.trouble());
        }
        // Closing now would lose what is still on its way.
        for (std::size_t left = channel_.on_the_way(); left > 0;) {
            std::this_thread::sleep_for(kStep / 10);
            const std::size_t now = channel_.on_the_way();
            if (now < left)
                take_notice();
            else if (is_over(kStep / 10) || channel_.trouble() == Ending::gone || cancel() == Cancel::at_once)
                return end_with(cancel() == Cancel::at_once ? Ending::cancelled : channel_.trouble());
            left = now;
        }
        return {accepted_ < bytes_.size() ? Ending::cancelled : Ending::done, accepted_, ""};
    }

private:
    Cancel cancel() const { return wish_.cancel ? wish_.cancel() : Cancel::no; }

    // The current page is sent to its end, if that is known.
    void look_for_cancel() {
        const Cancel now = cancel();
        if (now == Cancel::at_once) end_ = accepted_;
        if (now == Cancel::no || cancelled_) return;
        cancelled_ = true;
        const auto page = std::lower_bound(wish_.pages.begin(), wish_.pages.end(), accepted_);
        end_ = std::min(end_, page == wish_.pages.end() || accepted_ == 0 ? accepted_ : *page);
    }

    void take_notice() {
        waited_ = milliseconds{0};
        told_.reset();
        if (wish_.tell) wish_.tell(accepted_ - std::min(accepted_, channel_.on_the_way()), std::nullopt);
    }

    // It took nothing for another step; true: patience is over.
    bool is_over(milliseconds step = kStep) {
        waited_ += step;
        const bool look = waited_ == step || waited_.count() % 1000 < step.count();
        const Ending trouble = look ? channel_.trouble() : Ending::done;
        const bool worth = trouble == Ending::paper_out || (trouble == Ending::stalled && waited_ >= kQuiet);
        if (worth && told_ != trouble && wish_.tell) {
            told_ = trouble;
            wish_.tell(accepted_ - std::min(accepted_, channel_.on_the_way()), trouble);
        }
        return waited_ >= wish_.patience;
    }

    Delivery end_with(Ending ending, std::string why = "") {
        accepted_ -= std::min(accepted_, channel_.on_the_way());
        channel_.discard();
        return {ending, accepted_, std::move(why)};
    }

    Channel& channel_;
    std::string_view bytes_;
    const DeliveryWish& wish_;
    std::size_t end_, accepted_ = 0;
    bool cancelled_ = false;
    milliseconds waited_{0};
    std::optional<Ending> told_;
};

}  // namespace

Delivery deliver(Channel& channel, std::string_view bytes, const DeliveryWish& wish) {
    return Delivering(channel, bytes, wish).run();
}

std::size_t pages_within(const std::vector<std::size_t>& pages, std::size_t accepted) {
    return static_cast<std::size_t>(std::upper_bound(pages.begin(), pages.end(), accepted) - pages.begin());
}

}  // namespace tactics
