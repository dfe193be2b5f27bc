// SPDX-License-Identifier: Apache-2.0
// All formats except JPEG, PNG and TIFF, by OpenImageIO in a separate program: see caged/protocol.h.
#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "tactics/error.h"
#include "tactics/readers/caged_answer.h"
#include "tactics/readers/descriptor_copy.h"
#include "tactics/readers/exr.h"
#include "tactics/readers/limits.h"
#include "tactics/readers/rows.h"
#include "tactics/readers/upright.h"

namespace tactics {

namespace {

using namespace std::string_view_literals;

// The first bytes of a format, its common name and its name in OpenImageIO, and whether it is decoded whole.
struct OpenimageioForm {
    std::string_view name;
    const char* plugin;
    std::size_t at;
    std::string_view bytes;
    bool whole = false;
};

constexpr OpenimageioForm kOpenimageioForms[] = {
    {"WebP", "webp", 8, "WEBP", true},         {"GIF", "gif", 0, "GIF87a", true},
    {"GIF", "gif", 0, "GIF89a", true},         {"BMP", "bmp", 0, "BM"},
    {"EXR", "openexr", 0, "\x76\x2F\x31\x01"}, {"HDR", "hdr", 0, "#?"},
    {"PSD", "psd", 0, "8BPS", true},           {"HEIC", "heif", 4, "ftypheic", true},
    {"HEIC", "heif", 4, "ftypheix", true},     {"HEIC", "heif", 4, "ftypmif1", true},
    {"AVIF", "heif", 4, "ftypavif", true},     {"ICO", "ico", 0, "\0\0\1\0"sv, true},
};
// These have readers of their own and come here only for comparison.
constexpr OpenimageioForm kOwnForms[] = {
    {"JPEG", "jpeg", 0, "\xFF\xD8"},
    {"PNG", "png", 0, "\x89PNG"},
    {"TIFF", "tiff", 0, "II*\0"sv},
    {"TIFF", "tiff", 0, "MM\0*"sv},
};
constexpr std::size_t kMostWord = 1000;  // bytes of one that a file has
constexpr OpenimageioForm kPnm{"PNM", "pnm", 0, {}, false};
constexpr OpenimageioForm kTarga{"TGA", "targa", 0, {}, true};

using Bytes = std::span<const unsigned char>;

long long openimageio_number_at(Bytes head, std::size_t at, std::size_t size, bool big_endian = false) {
    long long value = 0;
    for (std::size_t i = 0; i < size && at + size <= head.size(); ++i)
        value = value << 8 | head[at + (big_endian ? i : size - 1 - i)];
    return value;
}

bool is_pnm(Bytes head) {
    const bool kind =
        head.size() > 3 && head[0] == 'P' && ((head[1] >= '1' && head[1] <= '6') || head[1] == 'F' || head[1] == 'f');
    return kind && (head[2] == ' ' || head[2] == '\n' || head[2] == '\r' || head[2] == '\t' || head[2] == '#');
}

// TGA has no signature at its start; its header is small and each field has few legal values.
bool is_targa(Bytes head) {
    if (head.size() < 18) return false;
    const int map = head[1], type = head[2] & 7, bits = head[16];
    const bool palette = type == 1;
    if (map > 1 || (head[2] & ~11) != 0 || type < 1 || type > 3 || (palette && map != 1)) return false;
    if (map == 0 && openimageio_number_at(head, 3, 4) != 0) return false;
    if (map == 1 && head[7] != 15 && head[7] != 16 && head[7] != 24 && head[7] != 32) return false;
    const bool deep = bits == 15 || bits == 16 || bits == 24 || bits == 32;
    return (type == 2 ? deep : bits == 8 || bits == 16) && openimageio_number_at(head, 12, 2) > 0 &&
           openimageio_number_at(head, 14, 2) > 0 && (head[17] & 0xC0) == 0;
}

const OpenimageioForm* form_in(std::span<const OpenimageioForm> forms, Bytes head) {
    const std::string_view text(reinterpret_cast<const char*>(head.data()), head.size());
    for (const OpenimageioForm& form : forms)
        if (text.size() > form.at && text.substr(form.at, form.bytes.size()) == form.bytes) return &form;
    return nullptr;
}

const OpenimageioForm* form_of_openimageio(Bytes head) {
    if (const OpenimageioForm* form = form_in(kOpenimageioForms, head)) return form;
    if (is_pnm(head)) return &kPnm;
    return is_targa(head) ? &kTarga : nullptr;
}

// Some plugins ask for the memory of the whole picture as soon as they open it, so its size is looked up here first.
void check_claim(const std::string& name, const OpenimageioForm& form, Bytes head) {
    long long width = 1, height = 1;
    if (form.name == "GIF") {
        width = openimageio_number_at(head, 6, 2);
        height = openimageio_number_at(head, 8, 2);
    } else if (form.name == "WebP") {
        // https://developers.google.com/speed/webp/docs/riff_container: extended, lossless, lossy
        const std::string_view kind(reinterpret_cast<const char*>(head.data()) + 12, 4);
        const long long bits = openimageio_number_at(head, 21, 4);
        width = kind == "VP8X"   ? openimageio_number_at(head, 24, 3) + 1
                : kind == "VP8L" ? (bits & 0x3FFF) + 1
                                 : openimageio_number_at(head, 26, 2) & 0x3FFF;
        height = kind == "VP8X"   ? openimageio_number_at(head, 27, 3) + 1
                 : kind == "VP8L" ? (bits >> 14 & 0x3FFF) + 1
                                  : openimageio_number_at(head, 28, 2) & 0x3FFF;
    } else if (form.name == "PSD") {
        width = openimageio_number_at(head, 18, 4, true);
        height = openimageio_number_at(head, 14, 4, true);
    } else if (form.name == "TGA") {
        width = openimageio_number_at(head, 12, 2);
        height = openimageio_number_at(head, 14, 2);
    }
    check_claimed_size(name, width, height);
    if (form.whole) check_whole_size(name, form.name, width, height);
}

// The length that the file claims, or 0. Some writers store nonsense there, so it only explains a failure.
long long claimed_bytes(const OpenimageioForm& form, Bytes head) {
    if (form.name == "BMP") return openimageio_number_at(head, 2, 4);
    if (form.name == "WebP") return openimageio_number_at(head, 4, 4) + 8;
    // Its header and colours (Adobe Photoshop File Formats Specification), whose memory the plugin asks for unseen.
    if (form.name == "PSD") return 30 + openimageio_number_at(head, 26, 4, true);
    return 0;
}

long long size_of_openimageio(std::FILE* file) {
    if (std::fseek(file, 0, SEEK_END) != 0) return 0;
    return std::ftell(file);
}

class Picture {
public:
    Picture(Source& source, std::string_view verb, std::vector<std::string> keys = {}) : name_(source.name) {
        std::array<unsigned char, 64> buffer{};  // zeros after a shorter file
        std::rewind(source.file.get());
        const auto size = std::fread(buffer.data(), 1, buffer.size(), source.file.get());
        const OpenimageioForm* form = form_of_openimageio(Bytes(buffer).first(size));
        if (form == nullptr) form = form_in(kOwnForms, buffer);
        if (form == nullptr) throw std::logic_error("openimageio: read what it does not recognise");
        form_ = *form;
        check_asked_for(source);
        cut_ = claimed_bytes(form_, buffer) > size_of_openimageio(source.file.get());
        constexpr std::size_t kHeader = 30;  // of what tells its length: BMP (26 at least), WebP
        const bool trusted = form_.name == "PSD";
        if (cut_ && size < kHeader && !trusted) throw_cut();
        check_claim(name_, form_, buffer);
        if (cut_ && trusted) throw_cut();
        std::FILE* file = source.file.get();
        if (fileno(file) < 0) {
            copy_ = with_descriptor(file);
            file = copy_.get();
            if (file == nullptr)
                throw Error(Fault::failed, name_, phrase("cannot be kept in a temporary file; make room for it"));
        }
        answer_.emplace(name_, CagedRequest{verb, form_.plugin, std::move(keys), fileno(file)});
        const bool opened = answer_->read(caged::Frame::facts, &facts_, sizeof facts_);
        if (!opened && ends_early()) throw_cut();
        if (!opened) throw_unreadable(why());
        check_claimed_size(name_, facts_.width, facts_.height);
        if (form_.whole) check_whole_size(name_, form_.name, facts_.width, facts_.height);
        const bool known = (facts_.colours == 1 || facts_.colours == 3) && facts_.alpha >= 0 && facts_.alpha <= 2 &&
                           facts_.orientation >= 0 && facts_.orientation <= 8;
        if (!known) throw_unreadable("it says what no picture is");
    }

    PictureInfo info() const {
        PictureInfo info{std::string(form_.name), facts_.width, facts_.height};
        if (turns_sideways(facts_.orientation)) std::swap(info.width, info.height);
        return info;
    }

    template <class Sample>
    Image read(const ReadRequest& request) {
        RowShape shape;
        shape.size = {facts_.width, facts_.height};
        shape.colours = facts_.colours;
        shape.alpha = facts_.alpha == 0 ? Alpha::none : facts_.alpha == 1 ? Alpha::straight : Alpha::premultiplied;
        shape.orientation = facts_.orientation;
        RowReceiver<Sample> rows(shape, request);
        each_row<Sample>(static_cast<std::size_t>(shape.channels()), [&](const Sample* row) { rows.add(row); });
        return rows.finish();
    }

    DecimalPicture decimals(std::span<const std::string_view> keys, long long most) {
        DecimalPicture picture{facts_.width, facts_.height, {}, {}, facts_.colours == 1 && facts_.alpha == 0};
        const long long count = static_cast<long long>(facts_.width) * facts_.height;
        if (count > most)
            throw Error(Fault::failed, name_,
                        phrase("has {0} x {1} samples; at most {2} million are read, make it smaller first",
                               std::to_string(facts_.width), std::to_string(facts_.height), std::to_string(most / 1'000'000)));
        for (const std::string_view key : keys) {
            std::string text;
            if (!answer_->read(caged::Frame::word, text, kMostWord)) throw_unreadable(why());
            if (!text.empty()) picture.words.emplace_back(key, std::move(text));
        }
        const std::size_t channels = static_cast<std::size_t>(facts_.colours) + (facts_.alpha != 0 ? 1 : 0),
                          width = static_cast<std::size_t>(facts_.width);
        picture.samples.reserve(static_cast<std::size_t>(count));
        each_row<float>(channels, [&](const float* row) {
            for (std::size_t x = 0; x < width; ++x) picture.samples.push_back(row[x * channels]);
        });
        return picture;
    }

    bool linear() const { return facts_.linear != 0; }

private:
    template <class Sample, class Take>
    void each_row(std::size_t channels, const Take& take) {
        const std::size_t row = static_cast<std::size_t>(facts_.width) * channels;
        const int batch = std::clamp(facts_.batch, 1, facts_.height);
        if (static_cast<long long>(row) * batch > kMaxWholePixels)
            throw Error(Fault::failed, name_, phrase("has tiles that are too large to be read; save it without tiles"));
        const auto samples = std::make_unique_for_overwrite<Sample[]>(row * static_cast<std::size_t>(batch));
        for (int y = 0; y < facts_.height; y += batch) {
            const int end = std::min(y + batch, facts_.height);
            if (!answer_->read(caged::Frame::rows, samples.get(), row * static_cast<std::size_t>(end - y) * sizeof(Sample))) {
                if (ends_early()) throw_cut_short(name_, y + 1, facts_.height);
                throw_damaged(name_, y + 1, facts_.height, why());
            }
            for (int i = 0; i < end - y; ++i) take(samples.get() + static_cast<std::size_t>(i) * row);
        }
    }

    void check_asked_for(const Source& source) const {
        const std::string format = form_.plugin;
        if (std::find(std::begin(kAskedFormats), std::end(kAskedFormats), format) == std::end(kAskedFormats)) return;
        if (std::find(source.allowed.begin(), source.allowed.end(), format) != source.allowed.end()) return;
        throw Error(Fault::failed, name_,
                    phrase("is of the format {0}, which is read only if it is asked for, as hostile files break its library; "
                           "convert it to PNG first or, if you trust it, add {1} {2}",
                           form_.name, spelled("allow"), format));
    }

    [[noreturn]] void throw_unreadable(const std::string& why) const {
        throw Error(
            Fault::failed, name_,
            phrase("cannot be read as {0}: {1}; it is damaged or of a rare kind, get a fresh copy or convert it to PNG first",
                   form_.name, why));
    }

    [[noreturn]] void throw_cut() const { throw Error(Fault::failed, name_, phrase("is cut short; get a complete copy of it")); }

    // After a failure: the file is shorter than it says, or OpenImageIO met its end (in its words for GIF, "at position 199,
    // asked for 3 bytes, got 1").
    bool ends_early() const {
        const std::string_view said = answer_->why();
        return cut_ || said.find("end of file") != std::string_view::npos ||
               (said.find("asked for ") != std::string_view::npos && said.find(" bytes, got ") != std::string_view::npos);
    }

    // OpenImageIO's message as part of our line: without line ends and descriptor names.
    std::string why() const {
        std::string text = answer_->why();
        const std::string path = "/dev/fd/0", quoted = '"' + path + '"';
        for (const auto& [name, instead] :
             {std::pair(quoted + ": ", ""), std::pair(quoted, "the file"), std::pair(path, "the file")})
            if (const auto at = text.find(name); at != std::string::npos) text.replace(at, name.size(), instead);
        std::replace_if(
            text.begin(), text.end(), [](unsigned char c) { return c < ' '; }, ' ');
        text.erase(text.find_last_not_of(" .") + 1);
        return text;
    }

    std::string name_;
    OpenimageioForm form_{};
    bool cut_ = false;
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> copy_{nullptr, &std::fclose};
    std::optional<CagedAnswer> answer_;
    caged::Facts facts_;
};

bool recognises_openimageio(Bytes head) { return form_of_openimageio(head) != nullptr; }

PictureInfo inspect_openimageio(Source& source) { return Picture(source, "inspect").info(); }

Image read_openimageio(Source& source, const ReadRequest& request) {
    Picture picture(source, "read");
    return picture.linear() ? picture.read<float>(request) : picture.read<std::uint8_t>(request);
}

}  // namespace

DecimalPicture read_exr(Source& source, std::span<const std::string_view> keys, long long most) {
    Picture picture(source, "read", {keys.begin(), keys.end()});
    if (!picture.linear())
        throw Error(Fault::failed, source.name, phrase("is an EXR of whole numbers; save it with 16 or 32-bit decimal numbers"));
    return picture.decimals(keys, most);
}

extern const Reader openimageio_reader;
const Reader openimageio_reader{
    .name = "OpenImageIO",
    .summary =
        "the rest: WebP, GIF (first frame), BMP, PNM, HEIC, AVIF, TGA; EXR and HDR, where the value 1 is white, or the 99th "
        "percentile if that would be far too dark or bright; PSD and ICO if allowed",
    .extensions = "webp gif bmp dib pbm pgm ppm pnm pfm exr hdr heic heif avif psd tga ico",
    .recognises = recognises_openimageio,
    .inspect = inspect_openimageio,
    .read = read_openimageio,
};

}  // namespace tactics
