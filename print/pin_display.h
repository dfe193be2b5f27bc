// SPDX-License-Identifier: Apache-2.0
// Communication with a pin display. Unlike an embosser, it answers, reports its size, and has keys.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "tactics/option.h"

namespace tactics {

/// One message from a display.
struct PinAnswer {
    enum class Kind {
        taken,     ///< it received a message; its pins are not set yet
        standing,  ///< its pins are set
        again,     ///< it could not take the message now; send it once more
        refused,
        keys_down,  ///< a key is pressed
        keys_up,    ///< no key is pressed
        told,       ///< its size is now in the settings
        too_small,  ///< it reports that it has no pins
        other,
    };
    Kind kind = Kind::other;
    int row = -1;  ///< row of the message that it answers; -1: the last message
};

struct PinDisplay {
    int baud = 115200;          ///< speed of its serial line, without flow control
    std::string_view question;  ///< bytes that ask for its size, or test its presence
    std::string_view farewell;  ///< bytes that end the session; its pins stay up
    std::string_view thanks;    ///< bytes that it expects after each of its answers; empty: none
    /// Takes the first complete answer from the received bytes, with anything before it; nothing: none yet. Throws Error for a
    /// size that no display has.
    std::optional<PinAnswer> (*next)(std::string& heard, Settings& settings) = nullptr;
    /// Length of the first message that encode made, in bytes; the display answers each before the next is sent.
    std::size_t (*message)(std::string_view bytes) = nullptr;
    /// Row of that message, as answers name it; -1: answers name none.
    int (*row)(std::string_view message) = nullptr;
};

}  // namespace tactics
