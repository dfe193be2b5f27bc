#include "tactics/transport/delivery.h"

#include <algorithm>
#include <thread>

namespace tactics {

namespace {

using std::chrono::milliseconds;

// In steps, so that being cancelled is seen soon.
constexpr milliseconds kStep{100};
// The kernel takes at most so much of a USB printer's bytes in one call (measured on 6.1).
constexpr std::size_t kChunk = 8192;

}  // namespace

Delivery deliver(Channel& channel, std::string_view bytes, const DeliveryWish& wish) {
    Delivery delivery;
    std::size_t end = bytes.size();
    bool cancelled = false;
    milliseconds waited{0};
    const auto tell = [&](std::optional<Ending> trouble) {
        if (wish.tell) wish.tell(delivery.accepted, trouble);
    };
    const auto look_for_cancel = [&] {
        if (cancelled || !wish.is_cancelled || !wish.is_cancelled()) return;
        cancelled = true;
        const auto page = std::lower_bound(wish.pages.begin(), wish.pages.end(), delivery.accepted);
        end = std::min(end, page == wish.pages.end() || delivery.accepted == 0 ? delivery.accepted : *page);
    };
    // One step of waiting; false: patience is over.
    const auto wait = [&] {
        if (channel.wait(kStep)) return true;
        if (waited == milliseconds{0}) tell(channel.trouble());
        waited += kStep;
        return waited < wish.patience;
    };
    for (look_for_cancel(); delivery.accepted < end; look_for_cancel()) {
        const Channel::Taken taken = channel.take(bytes.substr(delivery.accepted, std::min(kChunk, end - delivery.accepted)));
        delivery.accepted += taken.bytes;
        if (taken.ending != Ending::done) {
            delivery.ending = taken.ending;
            delivery.why = taken.why;
            delivery.accepted -= std::min(delivery.accepted, channel.on_the_way());
            return delivery;
        }
        if (taken.bytes > 0) {
            waited = milliseconds{0};
            tell(std::nullopt);
            continue;
        }
        if (wait()) continue;
        delivery.ending = channel.trouble();
        return delivery;
    }
    // Closing now would lose what is still on its way.
    constexpr milliseconds kLook{10};
    waited = milliseconds{0};
    for (std::size_t left = channel.on_the_way(), now = left; left > 0; left = now) {
        std::this_thread::sleep_for(kLook);
        now = channel.on_the_way();
        waited = now < left ? milliseconds{0} : waited + kLook;
        if (waited == kStep) tell(channel.trouble());
        if (waited < wish.patience) continue;
        delivery.ending = channel.trouble();
        delivery.accepted -= std::min(delivery.accepted, left);
        return delivery;
    }
    delivery.ending = delivery.accepted < bytes.size() ? Ending::cancelled : Ending::done;
    return delivery;
}

std::size_t pages_within(const std::vector<std::size_t>& pages, std::size_t accepted) {
    return static_cast<std::size_t>(std::upper_bound(pages.begin(), pages.end(), accepted) - pages.begin());
}

}  // namespace tactics
