// SPDX-License-Identifier: Apache-2.0
// How one talks with a display of pins. Unlike an embosser it answers, is asked how large it is, and has keys.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "tactics/option.h"

namespace tactics {

/// One thing that a display says.
struct PinAnswer {
    enum class Kind {
        taken,     ///< a message has come in; its pins do not stand yet
        standing,  ///< its pins stand
        again,     ///< it could not take the message now: it is to be sent once more
        refused,
        keys_down,  ///< some key is pressed
        keys_up,    ///< none is
        told,       ///< its size was put into the settings
        too_small,  ///< it has told that it has no pins
        other,
    };
    Kind kind = Kind::other;
    int row = -1;  ///< of the message that is meant; -1: the last
};

struct PinDisplay {
    int baud = 115200;          ///< of its serial line, without flow control
    std::string_view question;  ///< bytes that ask for its size, or whether it is there
    std::string_view farewell;  ///< bytes that end the talk; its pins stay
    std::string_view thanks;    ///< bytes that it wants after each of its answers; empty: none
    /// The first whole answer of what was heard, which is taken off, with what stood before it; nothing: there is none yet.
    /// Throws Error for a size that no display has.
    std::optional<PinAnswer> (*next)(std::string& heard, Settings& settings) = nullptr;
    /// How many bytes the first of the messages has that encode made; each is answered before the next is sent.
    std::size_t (*message)(std::string_view bytes) = nullptr;
    /// Which row that message is for, as answers name it; -1: answers name none.
    int (*row)(std::string_view message) = nullptr;
};

}  // namespace tactics
