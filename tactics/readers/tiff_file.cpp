// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/tiff_file.h"

#include <cstdio>
#include <memory>
#include <string_view>

#include "tactics/error.h"
#include "tactics/readers/limits.h"

namespace tactics {

TiffFile::~TiffFile() {
    if (tiff_ != nullptr) TIFFClose(tiff_);
}

void TiffFile::open() {
    constexpr tmsize_t kMaxLibraryBytes = 1LL << 30;  // at once, inside libtiff
    std::fseek(source_.file.get(), 0, SEEK_END);
    size_ = std::ftell(source_.file.get());
    std::rewind(source_.file.get());
    // Handlers of this file alone: the ones of the library are shared by all threads.
    const std::unique_ptr<TIFFOpenOptions, decltype(&TIFFOpenOptionsFree)> options(TIFFOpenOptionsAlloc(), &TIFFOpenOptionsFree);
    TIFFOpenOptionsSetMaxSingleMemAlloc(options.get(), kMaxLibraryBytes);
    TIFFOpenOptionsSetErrorHandlerExtR(options.get(), on_error, this);
    TIFFOpenOptionsSetWarningHandlerExtR(options.get(), on_warning, this);
    const auto on_write = [](thandle_t, void*, tmsize_t) -> tmsize_t { return -1; };
    const auto on_close = [](thandle_t) { return 0; };
    const auto on_size = [](thandle_t handle) { return static_cast<toff_t>(of(handle).size_); };
    // m: no memory map; O: offsets of strips are read when they are needed.
    tiff_ =
        TIFFClientOpenExt("picture", "rmO", this, on_read, on_write, on_seek, on_close, on_size, nullptr, nullptr, options.get());
    if (tiff_ == nullptr) fail(0);
    read_tags();
    check_claimed_size(name(), tags_.width, tags_.height);
    broken_ = false;  // tags that make no sense and are not needed do no harm
    ended_ = false;
}

void TiffFile::require(bool good, long long line) const {
    if (!good || broken_) fail(line);
}

void TiffFile::refuse(const Phrase& what) const {
    throw Error(Fault::failed, name(), phrase("is a TIFF {0}; save it as an ordinary TIFF or PNG of 8 or 16 bits", what));
}

void TiffFile::fail(long long line) const {
    if (ended_) throw_cut_short(name(), line, tags_.height);
    throw_damaged(name(), line, tags_.height, message_[0] != 0 ? message_.data() : "libtiff cannot read it");
}

void TiffFile::read_tags() {
    TiffTags& t = tags_;
    TIFFGetField(tiff_, TIFFTAG_IMAGEWIDTH, &t.width);
    TIFFGetField(tiff_, TIFFTAG_IMAGELENGTH, &t.height);
    TIFFGetFieldDefaulted(tiff_, TIFFTAG_BITSPERSAMPLE, &t.bits);
    TIFFGetFieldDefaulted(tiff_, TIFFTAG_SAMPLESPERPIXEL, &t.samples);
    TIFFGetFieldDefaulted(tiff_, TIFFTAG_SAMPLEFORMAT, &t.format);
    TIFFGetFieldDefaulted(tiff_, TIFFTAG_PLANARCONFIG, &t.planar);
    TIFFGetFieldDefaulted(tiff_, TIFFTAG_COMPRESSION, &t.compression);
    TIFFGetFieldDefaulted(tiff_, TIFFTAG_ORIENTATION, &t.orientation);
    TIFFGetFieldDefaulted(tiff_, TIFFTAG_ROWSPERSTRIP, &t.rows_per_strip);
    TIFFGetFieldDefaulted(tiff_, TIFFTAG_INKSET, &t.ink_set);
    if (TIFFGetField(tiff_, TIFFTAG_PHOTOMETRIC, &t.photometric) == 0)
        t.photometric = t.samples >= 3 ? PHOTOMETRIC_RGB : PHOTOMETRIC_MINISBLACK;
    t.tiled = TIFFIsTiled(tiff_) != 0;
    std::uint32_t kind = 0;
    TIFFGetFieldDefaulted(tiff_, TIFFTAG_SUBFILETYPE, &kind);
    t.preview = (kind & FILETYPE_REDUCEDIMAGE) != 0;
    std::uint16_t extras = 0;
    std::uint16_t* kinds = nullptr;
    TIFFGetFieldDefaulted(tiff_, TIFFTAG_EXTRASAMPLES, &extras, &kinds);
    for (std::uint16_t i = 0; i < extras && t.alpha == Alpha::none; ++i) {
        if (kinds[i] == EXTRASAMPLE_ASSOCALPHA) t.alpha = Alpha::premultiplied;
        if (kinds[i] == EXTRASAMPLE_UNASSALPHA) t.alpha = Alpha::straight;
        t.alpha_at = t.samples - extras + i;
    }
    if (t.alpha != Alpha::none && t.alpha_at < t.stored_colours()) t.alpha = Alpha::none;
}

int TiffFile::on_error(TIFF*, void* user, const char*, const char* format, va_list words) {
    TiffFile& file = of(user);
    if (!file.broken_) std::vsnprintf(file.message_.data(), file.message_.size(), format, words);
    file.broken_ = true;
    return 1;  // dealt with: nothing is printed
}

// libtiff only warns when JPEG or fax data end too early, and fills up with grey.
int TiffFile::on_warning(TIFF*, void* user, const char*, const char* format, va_list words) {
    TiffFile& file = of(user);
    std::array<char, 200> text{};
    std::vsnprintf(text.data(), text.size(), format, words);
    const std::string_view view(text.data());
    if (file.broken_ ||
        !(view.starts_with("Corrupt JPEG") || view.starts_with("Premature end of JPEG") || view.starts_with("Premature EOF")))
        return 1;
    file.message_ = text;
    file.broken_ = true;
    return 1;
}

tmsize_t TiffFile::on_read(thandle_t handle, void* to, tmsize_t count) {
    TiffFile& file = of(handle);
    const auto got = static_cast<tmsize_t>(std::fread(to, 1, static_cast<std::size_t>(count), file.source_.file.get()));
    if (got < count) file.ended_ = true;
    return got;
}

toff_t TiffFile::on_seek(thandle_t handle, toff_t offset, int from) {
    TiffFile& file = of(handle);
    if (from == SEEK_SET && offset > static_cast<toff_t>(file.size_)) {
        file.ended_ = true;
        return static_cast<toff_t>(-1);
    }
    if (std::fseek(file.source_.file.get(), static_cast<long>(offset), from) != 0) return static_cast<toff_t>(-1);
    return static_cast<toff_t>(std::ftell(file.source_.file.get()));
}

}  // namespace tactics
