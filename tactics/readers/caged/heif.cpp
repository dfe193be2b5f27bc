// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/caged/heif.h"

#ifdef TACTICS_HEIF

#include <libheif/heif.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>

namespace {

template <auto release>
struct Release {
    void operator()(auto* held) const { release(held); }
};

class HeifInput final : public OIIO::ImageInput {
public:
    const char* format_name() const override { return "heif"; }

    // The claimed size only; the program looks at it before anything is decoded.
    bool open(const std::string& name, OIIO::ImageSpec& spec) override {
        close();
        context_.reset(heif_context_alloc());
        heif_image_handle* handle = nullptr;
        heif_error error = heif_context_read_from_file(context_.get(), name.c_str(), nullptr);
        if (error.code == heif_error_Ok) error = heif_context_get_primary_image_handle(context_.get(), &handle);
        handle_.reset(handle);
        if (!is_good(error)) return false;
        const bool alpha = heif_image_handle_has_alpha_channel(handle) != 0;
        spec = OIIO::ImageSpec(heif_image_handle_get_width(handle), heif_image_handle_get_height(handle), alpha ? 4 : 3,
                               OIIO::TypeDesc::UINT8);
        if (alpha && heif_image_handle_is_premultiplied_alpha(handle) == 0) spec.attribute("oiio:UnassociatedAlpha", 1);
        m_spec = spec;
        return true;
    }

    bool read_native_scanline(int subimage, int miplevel, int y, int, void* data) override {
        if (subimage != 0 || miplevel != 0 || y < 0 || y >= m_spec.height || !decode()) return false;
        std::memcpy(data, plane_ + static_cast<std::size_t>(y) * static_cast<std::size_t>(stride_), m_spec.scanline_bytes());
        return true;
    }

    bool close() override {
        plane_ = nullptr;
        image_.reset();
        handle_.reset();
        context_.reset();
        return true;
    }

private:
    bool is_good(const heif_error& error) {
        if (error.code == heif_error_Ok) return true;
        errorfmt("{}", error.message);
        return false;
    }

    bool decode() {
        if (plane_ != nullptr) return true;
        if (handle_ == nullptr) return false;
        const auto chroma = m_spec.nchannels == 4 ? heif_chroma_interleaved_RGBA : heif_chroma_interleaved_RGB;
        heif_image* image = nullptr;
        const heif_error error = heif_decode_image(handle_.get(), &image, heif_colorspace_RGB, chroma, nullptr);
        image_.reset(image);
        if (!is_good(error)) return false;
        const auto* plane = heif_image_get_plane_readonly(image, heif_channel_interleaved, &stride_);
        // The claimed size stands beside the compressed picture, which has its own.
        if (plane == nullptr || heif_image_get_chroma_format(image) != chroma || stride_ < 0 ||
            static_cast<std::size_t>(stride_) < m_spec.scanline_bytes() ||
            heif_image_get_width(image, heif_channel_interleaved) < m_spec.width ||
            heif_image_get_height(image, heif_channel_interleaved) < m_spec.height) {
            errorfmt("its picture is smaller than it claims");
            return false;
        }
        plane_ = plane;
        return true;
    }

    std::unique_ptr<heif_context, Release<heif_context_free>> context_;
    std::unique_ptr<heif_image_handle, Release<heif_image_handle_release>> handle_;
    std::unique_ptr<heif_image, Release<heif_image_release>> image_;
    const std::uint8_t* plane_ = nullptr;  // of image_; null until it is known to be as large as claimed
    int stride_ = 0;
};

}  // namespace

std::unique_ptr<OIIO::ImageInput> heif_input() { return std::make_unique<HeifInput>(); }

#else

std::unique_ptr<OIIO::ImageInput> heif_input() { return nullptr; }

#endif
