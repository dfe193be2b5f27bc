// SPDX-License-Identifier: Apache-2.0
// Pictures to files. JPEG as cameras store it, PNG for what was never a photograph.
#pragma once

#include <string>

#include "tactics/image.h"

namespace tactics::samples {

/// Quality 90, colour at half resolution (4:2:0). Throws std::runtime_error naming the file.
void write_jpeg(const Image& image, const std::string& path);
/// 8 bits, grey or RGB. Throws std::runtime_error naming the file.
void write_png(const Image& image, const std::string& path);

}  // namespace tactics::samples
