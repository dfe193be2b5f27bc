// SPDX-License-Identifier: Apache-2.0
// HEIC and AVIF by libheif, in place of OpenImageIO's own plugin. In version 2.4 that takes the size that a file claims for the
// size of the picture that comes out of it, and where the claim is larger copies from behind the picture's end; and it reads a
// header from EXIF data that may be shorter than one.
#pragma once

#include <OpenImageIO/imageio.h>

#include <memory>

/// Its file is opened by name. Upright, 8 bits a sample. Null where the module was built without libheif.
std::unique_ptr<OIIO::ImageInput> heif_input();
