// How one talks with a display of pins. Unlike an embosser it answers, and is asked how large it is.
#pragma once

#include <string>
#include <string_view>

#include "tactics/option.h"

namespace tactics {

struct PinDisplay {
    int baud = 115200;          ///< of its serial line, without flow control
    std::string_view question;  ///< bytes that ask for its size; empty: it cannot be asked
    /// What the answer says of it is put into the settings. false: that is no answer, or not all of it.
    bool (*learn)(std::string_view heard, Settings& settings) = nullptr;
    /// How many bytes the first of the messages has that encode made; each is answered before the next is sent.
    std::size_t (*message)(std::string_view bytes) = nullptr;
    enum class Reply { none, key, taken, refused };  ///< key: one of its keys was pressed
    Reply (*reply)(std::string_view heard) = nullptr;
};

}  // namespace tactics
