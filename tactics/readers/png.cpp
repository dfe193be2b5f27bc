// PNG by libpng, row by row. The gamma, colour profile and chromaticities in a file are not applied: samples are taken as
// sRGB, as most programs write and show them.
#include <png.h>

#include <algorithm>
#include <array>
#include <csetjmp>
#include <cstdio>
#include <memory>
#include <vector>

#include "tactics/error.h"
#include "tactics/readers/limits.h"
#include "tactics/readers/rows.h"
#include "tactics/readers/upright.h"

namespace tactics {

namespace {

// Chunks that cost time or memory to unpack and say nothing about the pixels.
constexpr png_byte kUnread[] = "iCCP\0gAMA\0cHRM\0sRGB\0zTXt\0iTXt\0tEXt\0sPLT\0hIST\0pHYs\0tIME";

// libpng reports errors by a function that may not return; see jpeg.cpp for how exceptions and jumps are kept apart.
class Decoder {
public:
    explicit Decoder(Source& source) : source_(source) {}
    ~Decoder() { png_destroy_read_struct(&png_, &info_, nullptr); }
    Decoder(const Decoder&) = delete;
    Decoder& operator=(const Decoder&) = delete;

    void open() {
        std::rewind(source_.file.get());
        guarded([&] {
            png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, on_error, on_warning);
            if (png_ == nullptr) std::longjmp(jump_, 1);
            info_ = png_create_info_struct(png_);
            if (info_ == nullptr) std::longjmp(jump_, 1);
            png_set_read_fn(png_, this, on_read);
            png_set_user_limits(png_, PNG_UINT_31_MAX, PNG_UINT_31_MAX);  // judged below, in our own words
            png_set_chunk_malloc_max(png_, 4 << 20);
            png_set_chunk_cache_max(png_, 100);
            png_set_keep_unknown_chunks(png_, PNG_HANDLE_CHUNK_NEVER, kUnread, static_cast<int>(sizeof kUnread / 5));
            png_read_info(png_, info_);
        });
        height_ = png_get_image_height(png_, info_);
        width_ = png_get_image_width(png_, info_);
        check_claimed_size(source_.name, width_, height_);
    }

    // From here on rows are grey or RGB of 8 bits, with alpha behind if the file has any kind of transparency.
    RowShape start() {
        interlaced_ = png_get_interlace_type(png_, info_) != PNG_INTERLACE_NONE;
        if (interlaced_) check_whole_size(source_.name, "an interlaced PNG", width_, height_);
        guarded([&] {
            png_set_expand(png_);
            png_set_scale_16(png_);
            if (interlaced_) png_set_interlace_handling(png_);
            png_read_update_info(png_, info_);
        });
        RowShape shape;
        shape.size = size();
        const int channels = png_get_channels(png_, info_);
        shape.colours = channels >= 3 ? 3 : 1;
        shape.alpha = channels == 2 || channels == 4 ? Alpha::straight : Alpha::none;
        shape.orientation = orientation();
        return shape;
    }

    void read(const RowShape& shape, RowReceiver<std::uint8_t>& rows) {
        const auto row_bytes = static_cast<std::size_t>(width_) * static_cast<std::size_t>(shape.channels());
        const std::size_t kept = interlaced_ ? height_ : 1;
        // Left as it comes from the system: what is not yet read is not yet there.
        const auto memory = std::make_unique_for_overwrite<std::uint8_t[]>(row_bytes * kept);
        const int passes = interlaced_ ? 7 : 1;
        for (int pass = 1; pass <= passes; ++pass)
            for (line_ = 0; line_ < height_; ++line_) {
                pass_ = interlaced_ ? pass : 0;
                std::uint8_t* row = memory.get() + (interlaced_ ? line_ * row_bytes : 0);
                guarded([&] { png_read_row(png_, row, nullptr); });
                if (pass == passes) rows.add(row);
            }
    }

    Size size() const { return {static_cast<int>(width_), static_cast<int>(height_)}; }

    int orientation() {
        png_uint_32 bytes = 0;
        png_bytep block = nullptr;
        return png_get_eXIf_1(png_, info_, &bytes, &block) != 0 ? exif_orientation({block, bytes}) : 1;
    }

private:
    template <class Body>
    void guarded(const Body& body) {
        if (setjmp(jump_) != 0) fail();
        body();
    }

    static void on_error(png_structp png, png_const_charp message) {
        auto& decoder = *static_cast<Decoder*>(png_get_error_ptr(png));
        std::snprintf(decoder.message_.data(), decoder.message_.size(), "%s", message);
        std::longjmp(decoder.jump_, 1);
    }

    static void on_warning(png_structp, png_const_charp) {}

    static void on_read(png_structp png, png_bytep to, std::size_t count) {
        auto& decoder = *static_cast<Decoder*>(png_get_io_ptr(png));
        if (std::fread(to, 1, count, decoder.source_.file.get()) == count) return;
        decoder.ended_ = true;
        png_error(png, "the file ends");
    }

    [[noreturn]] void fail() const {
        const long long line = height_ == 0 ? 0 : static_cast<long long>(line_) + 1;
        if (ended_) throw_cut_short(source_.name, line, height_, pass_);
        throw_damaged(source_.name, line, height_, message_.data(), pass_);
    }

    Source& source_;
    png_structp png_ = nullptr;
    png_infop info_ = nullptr;
    png_uint_32 width_ = 0, height_ = 0, line_ = 0;
    int pass_ = 0;
    bool interlaced_ = false;
    bool ended_ = false;
    std::jmp_buf jump_{};
    std::array<char, 200> message_{"libpng has no memory"};
};

bool recognises(std::span<const unsigned char> head) {
    constexpr std::array<unsigned char, 8> kSignature = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
    return head.size() >= kSignature.size() && std::equal(kSignature.begin(), kSignature.end(), head.begin());
}

PictureInfo inspect(Source& source) {
    Decoder decoder(source);
    decoder.open();
    PictureInfo facts{"PNG", decoder.size().width, decoder.size().height};
    if (turns_sideways(decoder.orientation())) std::swap(facts.width, facts.height);
    return facts;
}

Image read(Source& source, const ReadRequest& request) {
    Decoder decoder(source);
    decoder.open();
    const RowShape shape = decoder.start();
    RowReceiver<std::uint8_t> rows(shape, request);
    decoder.read(shape, rows);
    return rows.finish();
}

}  // namespace

extern const Reader png_reader;
const Reader png_reader{
    .name = "PNG",
    .summary = "screenshots and drawings; 1 to 16 bits, palette, transparency over white (gamma and profiles are not applied)",
    .extensions = "png apng",
    .recognises = recognises,
    .inspect = inspect,
    .read = read,
};

}  // namespace tactics
