// The parameters of a haptic mouse and of the finger on it, in a text file that anyone can change.
//
//     # a heavier lever, another finger
//     lever = heavy
//     lever.delay = 0.001 s
//     finger = soft
//     finger.preload = 0.8 N
//
// `lever` and `finger` take one of the presets (lever.h) and come before what changes it. `#` starts a comment. What is not named
// keeps its default.
#pragma once

#include <string>
#include <string_view>

#include "tactics/haptics/lever.h"

namespace tactics {

struct MouseSettings {
    LeverSettings lever;
    FingerSettings finger;
    bool operator==(const MouseSettings&) const = default;
};

/// `origin` is the file's name for messages. Throws Error(usage) with the line: no such name, a number, unit or range that does
/// not fit, twice the same.
MouseSettings read_mouse(std::string_view text, std::string_view origin);

/// All parameters, one a line with its unit; read_mouse reads them back to within 1e-6.
std::string to_text(const MouseSettings& mouse);

}  // namespace tactics
