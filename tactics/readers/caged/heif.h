// SPDX-License-Identifier: Apache-2.0
// HEIC and AVIF by libheif, in place of OpenImageIO's own plugin. In version 2.4 that plugin takes the size claimed by a file for
// the size of the decoded picture, and reads past the picture's end if the claim is larger; it also reads a header from EXIF data
// that may be shorter than a header.
#pragma once

#include <OpenImageIO/imageio.h>

#include <memory>

/// Its file is opened by name. Upright, 8 bits a sample. Null where the module was built without libheif.
std::unique_ptr<OIIO::ImageInput> heif_input();
