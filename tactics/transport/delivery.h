// SPDX-License-Identifier: Apache-2.0
// Delivers bytes to a device and distinguishes the possible failures. Nothing is ever sent twice: an embosser that receives half
// a page again spoils two.
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tactics {

enum class Ending {
    done,
    paper_out,  ///< the device says so, and had no paper until patience was over
    stalled,    ///< it took nothing for that long and says nothing
    gone,       ///< unplugged, switched off, or the connection was closed
    cancelled,
    failed,  ///< anything else, in words
};

/// The way to a device. Closing it loses nothing that was taken, if drained() said so before.
class Channel {
public:
    struct Taken {
        std::size_t bytes = 0;
        Ending ending = Ending::done;  ///< anything else: it takes no more
        std::string why = {};          ///< of Ending::failed
    };
    virtual ~Channel() = default;
    /// As many of the bytes (at least one) as it takes without waiting; 0: it has to be waited for.
    virtual Taken take(std::string_view bytes) = 0;
    /// Until it takes more, at most that long; false: not yet.
    virtual bool wait(std::chrono::milliseconds time) = 0;
    /// The device's reason for accepting nothing; stalled: no reason known.
    virtual Ending trouble() = 0;
    /// The number of accepted bytes still on their way to the device, as far as known.
    virtual std::size_t on_the_way() = 0;
    /// The device's output within that time, empty if none, as for most; no value: it is gone.
    virtual std::optional<std::string> hear(std::chrono::milliseconds) { return ""; }
    /// Discards the bytes on their way, if possible; closing would still send them.
    virtual void discard() {}
};

struct DeliveryWish {
    std::chrono::milliseconds patience{60'000};  ///< how long a device may take nothing
    std::vector<std::size_t> pages = {};         ///< where pages end, ascending: a delivery is cut there
    enum class Cancel { no, behind_page, at_once };
    std::function<Cancel()> cancel = {};  ///< asked now and then; nothing: no
    /// Told when the device has taken more, and of its trouble: of missing paper at once, of taking nothing after 10 s, each
    /// once. May be empty.
    std::function<void(std::size_t accepted, std::optional<Ending> trouble)> tell = {};
};

struct Delivery {
    Ending ending = Ending::done;
    std::size_t accepted = 0;  ///< bytes accepted by the device; how many it punched is unknown
    std::string why;           ///< of Ending::failed
};

/// Sends all bytes in order, each at most once. Returns when everything has left or nothing more will; the rest is discarded, so
/// that continuing after it repeats nothing.
Delivery deliver(Channel& channel, std::string_view bytes, const DeliveryWish& wish);

/// The number of complete pages.
std::size_t pages_within(const std::vector<std::size_t>& pages, std::size_t accepted);

}  // namespace tactics
