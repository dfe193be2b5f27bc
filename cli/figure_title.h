// The title that a figure has at its top.
#pragma once

#include <string>
#include <vector>

#include "cli/print_words.h"

namespace tactics {

/// Words above all others, in several lines or too long for one line of braille, are the page's title, which has room for that.
/// They are marked, as no name stands for them then. Empty: there is none. `places` are those of `told`, in percent.
std::string take_title(std::vector<ToldWords>& told, const std::vector<PrintPlace>& places);

}  // namespace tactics
