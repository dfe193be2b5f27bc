// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/lookalike.h"

#include <algorithm>
#include <string_view>

#include "tactics/error.h"

namespace tactics {

namespace {

using namespace std::string_view_literals;

constexpr std::string_view kExport = "open it and export what you need as PNG";
constexpr std::string_view kUnpack = "unpack it first and name the picture in it";
constexpr std::string_view kPage = "convert a page of it to PNG first, for example with pdftoppm -r 300 -png";
constexpr std::string_view kDraw = "convert it to PNG first, for example with rsvg-convert -w 2000";
constexpr std::string_view kFrame = "save the frame that you want as PNG";
constexpr std::string_view kRaw = "save it as JPEG or TIFF with the camera's own program";
constexpr std::string_view kPhoto = "name a photo or a figure: JPEG, PNG, TIFF, WebP, GIF, BMP, EXR, HDR, PNM";

struct Kind {
    std::size_t at;
    std::string_view bytes;
    std::string_view what;
    std::string_view mend;
};

constexpr Kind kKinds[] = {
    {0, "%PDF-", "a PDF document", kPage},
    {0, "%!PS", "a PostScript document", "convert a page of it to PNG first, for example with gs -sDEVICE=png16m -r300"},
    {0, "\xC5\xD0\xD3\xC6", "an EPS drawing", "convert it to PNG first, for example with gs -sDEVICE=png16m -r300"},
    {0, "\xD0\xCF\x11\xE0", "an old Word, Excel or PowerPoint file", kExport},
    {0, "{\\rtf", "an RTF document", kExport},
    {0, "\x1F\x8B", "a gzip archive", kUnpack},
    {0, "BZh", "a bzip2 archive", kUnpack},
    {0,
     "\xFD"
     "7zXZ",
     "an xz archive", kUnpack},
    {0, "\x28\xB5\x2F\xFD", "a Zstandard archive", kUnpack},
    {0, "7z\xBC\xAF\x27\x1C", "a 7-Zip archive", kUnpack},
    {0, "Rar!", "a RAR archive", kUnpack},
    {257, "ustar", "a tar archive", kUnpack},
    {4, "ftyp", "a video", kFrame},
    {8, "AVI ", "a video", kFrame},
    {0, "\x1A\x45\xDF\xA3", "a video", kFrame},
    {0, "\0\0\1\xBA"sv, "a video", kFrame},
    {8, "WAVE", "a sound file", kPhoto},
    {0, "OggS", "a sound file", kPhoto},
    {0, "fLaC", "a sound file", kPhoto},
    {0, "ID3", "a sound file", kPhoto},
    {0,
     "\x7F"
     "ELF",
     "a program", kPhoto},
    {0, "MZ", "a Windows program", kPhoto},
    {0, "SQLite format 3", "a database", kPhoto},
    {0, "glTF", "a 3-D model", "make a picture of it first"},
    {0, "NRRD000", "a file of voxels (NRRD)", "measure says how much is in it; make a picture of a slice to draw it"},
};

// Pictures all the same, in formats that are not read.
constexpr Kind kUnread[] = {
    {0, "II*\0\x10\0\0\0CR"sv, "a Canon raw photo", kRaw},
    {0, "IIRO", "an Olympus raw photo", kRaw},
    {0, "IIU\0"sv, "a Panasonic raw photo", kRaw},
    {0, "FUJIFILMCCD-RAW", "a Fujifilm raw photo", kRaw},
    {0, "FOVb", "a Sigma raw photo", kRaw},
    {0, "gimp xcf", "a GIMP working file", kExport},
    {0, "SDPX", "a DPX film frame", kFrame},
    {0, "XPDS", "a DPX film frame", kFrame},
    {4, "jP  \r\n", "a JPEG 2000 picture", "convert it to PNG first, for example with opj_decompress"},
    {0, "\xFF\x4F\xFF\x51", "a JPEG 2000 picture", "convert it to PNG first, for example with opj_decompress"},
    {4, "JXL \r\n", "a JPEG XL picture", "convert it to PNG first, for example with djxl"},
    {0, "\xFF\x0A", "a JPEG XL picture", "convert it to PNG first, for example with djxl"},
};

bool same(char a, char b) {
    const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
    return lower(a) == lower(b);
}

bool holds(std::string_view text, std::string_view word) {
    return std::search(text.begin(), text.end(), word.begin(), word.end(), same) != text.end();
}

// Office files are ZIP archives; the names of the first files in them tell which.
std::string_view kind_of_archive(std::string_view head) {
    if (holds(head, "word/")) return "a Word document (docx)";
    if (holds(head, "ppt/")) return "a PowerPoint file (pptx)";
    if (holds(head, "xl/")) return "an Excel sheet (xlsx)";
    if (holds(head, "application/vnd.oasis.opendocument.text")) return "an OpenDocument text (odt)";
    if (holds(head, "application/vnd.oasis.opendocument")) return "an OpenDocument file";
    if (holds(head, "application/epub+zip")) return "an e-book (EPUB)";
    if (holds(head, "[Content_Types].xml")) return "an Office file";
    return {};
}

bool is_text(std::string_view head) {
    return std::none_of(head.begin(), head.end(), [](char c) {
        const auto byte = static_cast<unsigned char>(c);
        return byte == 0x7F || (byte < 0x20 && c != '\n' && c != '\r' && c != '\t' && c != '\f');
    });
}

// A table: the first two lines have the same separator equally often.
bool is_table(std::string_view text) {
    const auto end = text.find('\n');
    if (end == std::string_view::npos) return false;
    const std::string_view first = text.substr(0, end), rest = text.substr(end + 1);
    const std::string_view second = rest.substr(0, rest.find('\n'));
    return std::any_of(std::begin(",;\t"), std::end(",;\t") - 1, [&](char mark) {
        const auto count = std::count(first.begin(), first.end(), mark);
        return count > 0 && count == std::count(second.begin(), second.end(), mark);
    });
}

std::string answer(std::string_view what, std::string_view mend) {
    return "looks like " + std::string(what) + ", not a picture; " + std::string(mend);
}

std::string text_answer(std::string_view text) {
    const auto start = text.find_first_not_of(" \t\r\n\f");
    if (start == std::string_view::npos) return answer("a text file with nothing but blanks", kPhoto);
    const std::string_view body = text.substr(start);
    if (holds(body, "<svg")) return answer("an SVG drawing", kDraw);
    if (holds(body.substr(0, 256), "<!doctype html") || holds(body.substr(0, 256), "<html"))
        return answer("an HTML page", "save the picture that is on it, not the page");
    if (body.substr(0, 5) == "<?xml") return answer("an XML file", kPhoto);
    if (body.substr(0, 5) == "#VRML" || body.substr(0, 6) == "solid ") return answer("a 3-D model", "make a picture of it first");
    if (body[0] == '{' || body[0] == '[') return answer("JSON data", kPhoto);
    if (is_table(body)) return answer("a table of data (CSV)", "draw a chart of it first");
    return answer("a text file", "lay it out in braille with " + spelled("text") + ", or " + std::string(kPhoto));
}

}  // namespace

std::string lookalike(std::span<const unsigned char> head) {
    std::string_view text(reinterpret_cast<const char*>(head.data()), head.size());
    if (std::all_of(head.begin(), head.end(), [](unsigned char byte) { return byte == 0; }))
        return "holds nothing but zero bytes, perhaps after a broken download or copy; get a fresh copy of it";
    if (text.substr(0, 4) == "PK\3\4") {
        const auto office = kind_of_archive(text);
        return office.empty() ? answer("a ZIP archive", kUnpack) : answer(office, kExport);
    }
    const auto is = [&](const Kind& kind) {
        return text.size() > kind.at && text.substr(kind.at, kind.bytes.size()) == kind.bytes;
    };
    for (const Kind& kind : kUnread)
        if (is(kind)) return "looks like " + std::string(kind.what) + ", which is not read; " + std::string(kind.mend);
    for (const Kind& kind : kKinds)
        if (is(kind)) return answer(kind.what, kind.mend);
    if (text.substr(0, 3) == "\xEF\xBB\xBF") text.remove_prefix(3);  // byte order mark
    if (is_text(text)) return text_answer(text);
    if (holds(text.substr(0, 1024), "%PDF-")) return answer("a PDF document", kPage);  // some have rubbish before
    return "is not a picture of a known kind; " + std::string(kPhoto);
}

}  // namespace tactics
