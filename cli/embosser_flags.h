// What commands ask alike about an embosser whose bytes they read.
#pragma once

#include "cli/command.h"
#include "print/format.h"

namespace tactics {

/// --embosser; nullptr: none was named. Throws Error(usage) with the nearest name.
const Format* embosser_given(const Given& given);

/// All of --set, as NAME.OPTION=VALUE of that embosser. Throws Error(usage).
Settings embosser_settings(const Format& format, const Given& given);

/// All bytes of the files, one after the other; "-" is standard input. Throws Error: not there, over 256 MB together.
std::string bytes_of_files(const std::vector<std::string>& files);

}  // namespace tactics
