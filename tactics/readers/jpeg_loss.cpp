// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/jpeg_loss.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <stdexcept>

// clang-format off
#include <jpeglib.h>  // needs <cstdio> before it
// clang-format on

#include "tactics/readers/read.h"

namespace tactics {

namespace {

// libjpeg must not go on after an error; with a picture of a size that it can hold there is none but want of memory.
[[noreturn]] void give_up(j_common_ptr) { throw std::runtime_error("a picture could not be stored as JPEG"); }

class Encoder {
public:
    Encoder() {
        codec_.err = jpeg_std_error(&errors_);
        errors_.error_exit = give_up;
        jpeg_create_compress(&codec_);
    }
    Encoder(const Encoder&) = delete;
    Encoder& operator=(const Encoder&) = delete;
    ~Encoder() {
        jpeg_destroy_compress(&codec_);
        std::free(bytes_);  // from malloc, says jpeg_mem_dest
    }

    std::span<const unsigned char> encode(const Image& image, int quality) {
        jpeg_mem_dest(&codec_, &bytes_, &size_);
        codec_.image_width = static_cast<JDIMENSION>(image.width);
        codec_.image_height = static_cast<JDIMENSION>(image.height);
        codec_.input_components = image.channels;
        codec_.in_color_space = image.channels == 3 ? JCS_RGB : JCS_GRAYSCALE;
        jpeg_set_defaults(&codec_);  // with colour at half resolution
        jpeg_set_quality(&codec_, quality, TRUE);
        codec_.dct_method = JDCT_ISLOW;  // the same on every processor
        jpeg_start_compress(&codec_, TRUE);
        for (int y = 0; y < image.height; ++y) {
            JSAMPROW row = const_cast<JSAMPROW>(image.row(y));  // libjpeg only reads it
            jpeg_write_scanlines(&codec_, &row, 1);
        }
        jpeg_finish_compress(&codec_);
        return {bytes_, size_};
    }

private:
    jpeg_compress_struct codec_{};
    jpeg_error_mgr errors_{};
    unsigned char* bytes_ = nullptr;
    unsigned long size_ = 0;
};

}  // namespace

Image through_jpeg(const Image& image, int quality) {
    if (std::max(image.width, image.height) > JPEG_MAX_DIMENSION) throw std::logic_error("this picture is too large for JPEG");
    Encoder encoder;
    Source source = memory_source(encoder.encode(image, quality), "a picture in memory");
    Image read = read_picture(source, {0, image.channels == 3});
    read.mm_per_pixel = image.mm_per_pixel;
    return read;
}

}  // namespace tactics
