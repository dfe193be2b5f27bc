// SPDX-License-Identifier: Apache-2.0
// Grey decimal numbers in OpenEXR files, read and written through OpenImageIO.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tactics/readers/read.h"

namespace tactics {

struct DecimalPicture {
    int width = 0, height = 0;
    std::vector<float> samples;                              ///< of its first channel, unchanged
    std::vector<std::pair<std::string, std::string>> words;  ///< those of the keys asked for that the file has
    bool grey = true;                                        ///< it has no other channel
};

/// Throws Error(failed): damaged, over `most` samples (nothing is read then), or OpenImageIO is not installed.
DecimalPicture read_exr(Source& source, std::span<const std::string_view> keys, long long most);

/// One channel, Y, of 32 bits, compressed without loss. Words are attributes. Each row is asked for once, from the top. Same
/// rows, same bytes. Throws Error(failed) if OpenImageIO is not installed. Words have no line ends.
std::string write_exr(int width, int height, const std::vector<std::pair<std::string_view, std::string>>& words,
                      const std::function<void(int row, std::span<float> samples)>& rows);

}  // namespace tactics
