// SPDX-License-Identifier: Apache-2.0
#include "samples/draw/files.h"

#include <jpeglib.h>
#include <png.h>

#include <cstdio>
#include <memory>
#include <stdexcept>

namespace tactics::samples {

namespace {

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

File create(const std::string& path) {
    File file(std::fopen(path.c_str(), "wb"), &std::fclose);
    if (!file) throw std::runtime_error(path + ": cannot be written");
    return file;
}

void close(File file, const std::string& path) {
    if (std::fclose(file.release()) != 0) throw std::runtime_error(path + ": cannot be written to the end; is the disk full?");
}

void fail(j_common_ptr info) {
    char message[JMSG_LENGTH_MAX];
    (*info->err->format_message)(info, message);
    throw std::runtime_error(message);
}

}  // namespace

void write_jpeg(const Image& image, const std::string& path) {
    File file = create(path);
    jpeg_error_mgr errors{};
    jpeg_compress_struct info{};
    info.err = jpeg_std_error(&errors);
    errors.error_exit = fail;
    jpeg_create_compress(&info);
    const std::unique_ptr<jpeg_compress_struct, void (*)(jpeg_compress_struct*)> tidy(&info, jpeg_destroy_compress);
    jpeg_stdio_dest(&info, file.get());
    info.image_width = static_cast<JDIMENSION>(image.width);
    info.image_height = static_cast<JDIMENSION>(image.height);
    info.input_components = image.channels;
    info.in_color_space = image.channels == 3 ? JCS_RGB : JCS_GRAYSCALE;
    jpeg_set_defaults(&info);  // 4:2:0 for colour
    jpeg_set_quality(&info, 90, TRUE);
    info.dct_method = JDCT_ISLOW;  // the same on every processor
    jpeg_start_compress(&info, TRUE);
    while (info.next_scanline < info.image_height) {
        auto* row = const_cast<JSAMPROW>(image.row(static_cast<int>(info.next_scanline)));  // libjpeg reads it only
        jpeg_write_scanlines(&info, &row, 1);
    }
    jpeg_finish_compress(&info);
    close(std::move(file), path);
}

void write_png(const Image& image, const std::string& path) {
    png_image info{};
    info.version = PNG_IMAGE_VERSION;
    info.width = static_cast<png_uint_32>(image.width);
    info.height = static_cast<png_uint_32>(image.height);
    info.format = image.channels == 3 ? PNG_FORMAT_RGB : PNG_FORMAT_GRAY;
    File file = create(path);
    if (png_image_write_to_stdio(&info, file.get(), 0, image.pixels.data(), static_cast<png_int_32>(image.row_bytes()),
                                 nullptr) == 0)
        throw std::runtime_error(path + ": " + info.message);
    close(std::move(file), path);
}

}  // namespace tactics::samples
