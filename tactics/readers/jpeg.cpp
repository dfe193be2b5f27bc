// SPDX-License-Identifier: Apache-2.0
// JPEG by libjpeg-turbo. The size is reduced inside the inverse transform, which is the cheapest shrinking there is.
#include <algorithm>
#include <array>
#include <csetjmp>
#include <cstdio>
#include <string>
#include <vector>

// clang-format off
#include <jpeglib.h>  // needs <cstdio> before it
#include <jerror.h>   // needs jpeglib.h before it
// clang-format on

#include "tactics/error.h"
#include "tactics/readers/limits.h"
#include "tactics/readers/rows.h"
#include "tactics/readers/upright.h"

namespace tactics {

namespace {

// A file of a few kilobytes can hold thousands of empty passes over a large picture. Real ones have about ten.
constexpr int kMaxPasses = 100;

// Walks over the segments before the picture to the first Exif block. libjpeg could save it, but would save as many as
// a hostile file has.
int orientation_of(std::FILE* file) {
    constexpr int kMaxSegments = 200;
    constexpr std::array<unsigned char, 6> kExif = {'E', 'x', 'i', 'f', 0, 0};
    constexpr int kApp1 = 0xE1, kStartOfScan = 0xDA;
    if (std::fseek(file, 2, SEEK_SET) != 0) return 1;
    for (int i = 0; i < kMaxSegments; ++i) {
        if (std::fgetc(file) != 0xFF) return 1;
        int marker = std::fgetc(file);
        while (marker == 0xFF) marker = std::fgetc(file);
        std::array<unsigned char, 2> length{};
        if (marker <= 0 || marker == kStartOfScan || std::fread(length.data(), 1, 2, file) != 2) return 1;
        const std::size_t size = static_cast<std::size_t>(length[0] << 8 | length[1]);
        if (size < 2) return 1;
        if (marker != kApp1) {
            if (std::fseek(file, static_cast<long>(size - 2), SEEK_CUR) != 0) return 1;
            continue;
        }
        std::vector<unsigned char> block(size - 2);
        block.resize(std::fread(block.data(), 1, block.size(), file));
        if (block.size() > kExif.size() && std::equal(kExif.begin(), kExif.end(), block.begin()))
            return exif_orientation(std::span(block).subspan(kExif.size()));
    }
    return 1;
}

// Feeds libjpeg from the file. Its own source hands over 4 kB at a time, and libjpeg takes its slow path through the
// Huffman codes whenever less than 3 kB are at hand (512 bytes a block): with large pieces a photograph is decoded in
// four fifths of the time.
class Feed {
public:
    explicit Feed(std::FILE* file) : file_(file), buffer_(kPiece) {
        source_.feed = this;
        source_.init_source = [](j_decompress_ptr) {};
        source_.fill_input_buffer = fill;
        source_.skip_input_data = skip;
        source_.resync_to_restart = jpeg_resync_to_restart;
        source_.term_source = [](j_decompress_ptr) {};
    }

    Feed(const Feed&) = delete;
    Feed& operator=(const Feed&) = delete;

    void attach(jpeg_decompress_struct& info) { info.src = &source_; }

private:
    static constexpr std::size_t kPiece = 128 * 1024;

    struct Manager : jpeg_source_mgr {
        Feed* feed = nullptr;
    };

    static boolean fill(j_decompress_ptr info) {
        Feed& feed = *static_cast<Manager*>(info->src)->feed;
        std::size_t got = std::fread(feed.buffer_.data(), 1, kPiece, feed.file_);
        if (got == 0) {  // as libjpeg's own: a warning, and an end marker for what is missing
            if (!feed.begun_) ERREXIT(info, JERR_INPUT_EMPTY);
            WARNMS(info, JWRN_JPEG_EOF);
            feed.buffer_[0] = 0xFF;
            feed.buffer_[1] = JPEG_EOI;
            got = 2;
        }
        feed.begun_ = true;
        feed.source_.next_input_byte = feed.buffer_.data();
        feed.source_.bytes_in_buffer = got;
        return TRUE;
    }

    static void skip(j_decompress_ptr info, long count) {
        if (count <= 0) return;
        auto left = static_cast<std::size_t>(count);
        while (left > info->src->bytes_in_buffer) {
            left -= info->src->bytes_in_buffer;
            fill(info);
        }
        info->src->next_input_byte += left;
        info->src->bytes_in_buffer -= left;
    }

    std::FILE* file_;
    std::vector<JOCTET> buffer_;
    bool begun_ = false;
    Manager source_{};
};

// libjpeg reports errors by a function that may not return. It jumps back into `guarded`, over C frames and over bodies
// that hold nothing with a destructor; only then is the exception thrown.
class Decoder {
public:
    explicit Decoder(Source& source)
        : source_(source), orientation_(orientation_of(source.file.get())), feed_(source.file.get()) {}
    ~Decoder() { jpeg_destroy_decompress(&info); }
    Decoder(const Decoder&) = delete;
    Decoder& operator=(const Decoder&) = delete;

    jpeg_decompress_struct info{};

    int orientation() const { return orientation_; }

    void open() {
        std::rewind(source_.file.get());
        info.err = jpeg_std_error(&errors_);
        errors_.error_exit = [](j_common_ptr common) {
            common->err->format_message(common, of(common).message_.data());
            std::longjmp(of(common).jump_, 1);
        };
        errors_.emit_message = [](j_common_ptr common, int level) {
            if (level < 0) of(common).heed(common->err->msg_code);
        };
        errors_.output_message = [](j_common_ptr) {};
        info.client_data = this;
        guarded([&] {
            jpeg_create_decompress(&info);
            feed_.attach(info);
            jpeg_read_header(&info, TRUE);
        });
        begun_ = true;
        passes_ = jpeg_has_multiple_scans(&info) != 0;
        check_claimed_size(source_.name, info.image_width, info.image_height);
    }

    void start() {
        if (passes_) check_whole_size(source_.name, "a progressive JPEG", info.image_width, info.image_height);
        watch_.progress_monitor = [](j_common_ptr common) {
            Decoder& decoder = of(common);
            if (decoder.info.input_scan_number <= kMaxPasses) return;
            decoder.say("it has too many passes");
            std::longjmp(decoder.jump_, 1);
        };
        info.progress = &watch_;
        guarded([&] { jpeg_start_decompress(&info); });
        if (passes_ && ended_) fail();  // all that is missing is passes: the picture would only be blurred
    }

    void read(JSAMPROW row) {
        guarded([&] { jpeg_read_scanlines(&info, &row, 1); });
    }

private:
    static Decoder& of(j_common_ptr common) { return *static_cast<Decoder*>(common->client_data); }

    template <class Body>
    void guarded(const Body& body) {
        if (setjmp(jump_) != 0) fail();
        body();
    }

    void say(const char* what) { std::snprintf(message_.data(), message_.size(), "%s", what); }

    // Warnings are about rubbish that may be skipped, or about picture data that is lost. The latter is an error here.
    void heed(int code) {
        if (code == JWRN_JPEG_EOF) ended_ = true;
        if (code == JWRN_HIT_MARKER) cut_short_ = true;
        if (code != JWRN_HIT_MARKER && code != JWRN_HUFF_BAD_CODE && code != JWRN_ARITH_BAD_CODE && code != JWRN_MUST_RESYNC)
            return;
        say("its compressed data makes no sense");
        std::longjmp(jump_, 1);
    }

    [[noreturn]] void fail() const {
        // Input comes in rows of MCUs, the smallest blocks that hold all colours.
        const long long line = begun_ ? 1 + static_cast<long long>(info.input_iMCU_row) * info.max_v_samp_factor * DCTSIZE : 0;
        const int pass = passes_ ? info.input_scan_number : 0;
        if (ended_ || cut_short_) throw_cut_short(source_.name, line, info.image_height, pass);
        throw_damaged(source_.name, line, info.image_height, message_.data(), pass);
    }

    Source& source_;
    int orientation_;
    Feed feed_;
    bool begun_ = false;      // the header is read
    bool passes_ = false;     // the picture comes in several passes: progressive, or a colour at a time
    bool ended_ = false;      // the file ended before the end marker
    bool cut_short_ = false;  // picture data ended before the picture
    jpeg_error_mgr errors_{};
    jpeg_progress_mgr watch_{};
    std::jmp_buf jump_{};
    std::array<char, JMSG_LENGTH_MAX> message_{};
};

// The smallest reduction to N/8 that leaves at least the pixels that are wanted. Only 1, 2, 4 and 8 are taken: the
// transforms to other sizes have no vector code and cost more than the next larger of these.
void reduce(jpeg_decompress_struct& info, Size wanted) {
    const auto enough = [&](unsigned n) {
        return info.image_width * n >= 8 * static_cast<unsigned>(wanted.width) &&
               info.image_height * n >= 8 * static_cast<unsigned>(wanted.height);
    };
    info.scale_denom = 8;
    info.scale_num = 1;
    while (info.scale_num < 8 && !enough(info.scale_num)) info.scale_num *= 2;
}

// Adobe's programs store CMYK inverted (255 = no ink), others as it is. Ink mixes subtractively; the true appearance of the ink
// is in a colour profile, which a line drawing does not need.
void cmyk_to_rgb(const JSAMPLE* cmyk, std::uint8_t* rgb, std::size_t width, bool inverted) {
    const unsigned flip = inverted ? 0 : 255;
    for (std::size_t x = 0; x < width; ++x, cmyk += 4)
        for (int c = 0; c < 3; ++c) *rgb++ = static_cast<std::uint8_t>(((cmyk[c] ^ flip) * (cmyk[3] ^ flip) + 127u) / 255u);
}

bool recognises_jpeg(std::span<const unsigned char> head) {
    return head.size() >= 3 && head[0] == 0xFF && head[1] == 0xD8 && head[2] == 0xFF;
}

PictureInfo inspect_jpeg(Source& source) {
    Decoder decoder(source);
    decoder.open();
    PictureInfo facts{"JPEG", static_cast<int>(decoder.info.image_width), static_cast<int>(decoder.info.image_height)};
    if (turns_sideways(decoder.orientation())) std::swap(facts.width, facts.height);
    return facts;
}

Image read_jpeg(Source& source, const ReadRequest& request) {
    Decoder decoder(source);
    decoder.open();
    auto& info = decoder.info;
    const bool ink = info.num_components == 4;
    if (info.num_components != 1 && info.num_components != 3 && !ink)
        throw Error(Fault::failed, source.name,
                    phrase("is a JPEG with {0} colours; save it as grey or RGB", std::to_string(info.num_components)));
    const bool colour = request.colour && info.num_components != 1;
    info.out_color_space = ink ? JCS_CMYK : colour ? JCS_RGB : JCS_GRAYSCALE;
    const Size whole{static_cast<int>(info.image_width), static_cast<int>(info.image_height)};
    const Size wanted = shrunk_size(whole, request.longest);
    reduce(info, wanted);
    const int scale = static_cast<int>(info.scale_num);
    if (info.scale_num < 8) info.do_fancy_upsampling = FALSE;  // what it smooths is averaged away
    info.do_block_smoothing = FALSE;                           // it guesses at passes that are missing
    decoder.start();

    RowShape shape;
    shape.size = {static_cast<int>(info.output_width), static_cast<int>(info.output_height)};
    shape.colours = ink || colour ? 3 : 1;
    shape.orientation = decoder.orientation();
    RowReceiver<std::uint8_t> rows(shape, request, wanted, {whole.width * scale, whole.height * scale});
    std::vector<std::uint8_t> row(info.output_width * static_cast<std::size_t>(info.output_components));
    std::vector<std::uint8_t> rgb(ink ? info.output_width * std::size_t{3} : 0);
    while (info.output_scanline < info.output_height) {
        decoder.read(row.data());
        if (ink) cmyk_to_rgb(row.data(), rgb.data(), info.output_width, info.saw_Adobe_marker != 0);
        rows.add(ink ? rgb.data() : row.data());
    }
    return rows.finish();
}

}  // namespace

extern const Reader jpeg_reader;
const Reader jpeg_reader{
    .name = "JPEG",
    .summary = "photographs; EXIF orientation, grey, colour and CMYK, progressive up to 120 million pixels",
    .extensions = "jpg jpeg jpe jfif",
    .recognises = recognises_jpeg,
    .inspect = inspect_jpeg,
    .read = read_jpeg,
};

}  // namespace tactics
