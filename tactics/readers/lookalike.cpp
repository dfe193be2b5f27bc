// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/lookalike.h"

#include <algorithm>
#include <string_view>

#include "tactics/error.h"

namespace tactics {

namespace {

using namespace std::string_view_literals;

constexpr SourceWords kExport{"open it and export what you need as PNG"};
constexpr SourceWords kUnpack{"unpack it first and name the picture in it"};
constexpr SourceWords kPage{"convert a page of it to PNG first, for example with pdftoppm -r 300 -png"};
constexpr SourceWords kDraw{"convert it to PNG first, for example with rsvg-convert -w 2000"};
constexpr SourceWords kFrame{"save the frame that you want as PNG"};
constexpr SourceWords kRaw{"save it as JPEG or TIFF with the camera's own program"};
constexpr SourceWords kPhoto{"name a photo or a figure: JPEG, PNG, TIFF, WebP, GIF, BMP, EXR, HDR, PNM"};

struct Kind {
    std::size_t at;
    std::string_view bytes;
    SourceWords what;
    SourceWords mend;
};

constexpr Kind kKinds[] = {
    {0, "%PDF-", SourceWords("a PDF document"), kPage},
    {0, "%!PS", SourceWords("a PostScript document"),
     SourceWords("convert a page of it to PNG first, for example with gs -sDEVICE=png16m -r300")},
    {0, "\xC5\xD0\xD3\xC6", SourceWords("an EPS drawing"),
     SourceWords("convert it to PNG first, for example with gs -sDEVICE=png16m -r300")},
    {0, "\xD0\xCF\x11\xE0", SourceWords("an old Word, Excel or PowerPoint file"), kExport},
    {0, "{\\rtf", SourceWords("an RTF document"), kExport},
    {0, "\x1F\x8B", SourceWords("a gzip archive"), kUnpack},
    {0, "BZh", SourceWords("a bzip2 archive"), kUnpack},
    {0,
     "\xFD"
     "7zXZ",
     SourceWords("an xz archive"), kUnpack},
    {0, "\x28\xB5\x2F\xFD", SourceWords("a Zstandard archive"), kUnpack},
    {0, "7z\xBC\xAF\x27\x1C", SourceWords("a 7-Zip archive"), kUnpack},
    {0, "Rar!", SourceWords("a RAR archive"), kUnpack},
    {257, "ustar", SourceWords("a tar archive"), kUnpack},
    {4, "ftyp", SourceWords("a video"), kFrame},
    {8, "AVI ", SourceWords("a video"), kFrame},
    {0, "\x1A\x45\xDF\xA3", SourceWords("a video"), kFrame},
    {0, "\0\0\1\xBA"sv, SourceWords("a video"), kFrame},
    {8, "WAVE", SourceWords("a sound file"), kPhoto},
    {0, "OggS", SourceWords("a sound file"), kPhoto},
    {0, "fLaC", SourceWords("a sound file"), kPhoto},
    {0, "ID3", SourceWords("a sound file"), kPhoto},
    {0,
     "\x7F"
     "ELF",
     SourceWords("a program"), kPhoto},
    {0, "MZ", SourceWords("a Windows program"), kPhoto},
    {0, "SQLite format 3", SourceWords("a database"), kPhoto},
    {0, "glTF", SourceWords("a 3-D model"), SourceWords("make a picture of it first")},
    {0, "NRRD000", SourceWords("a file of voxels (NRRD)"),
     SourceWords("measure says how much is in it; make a picture of a slice to draw it")},
};

// Pictures all the same, in formats that are not read.
constexpr Kind kUnread[] = {
    {0, "II*\0\x10\0\0\0CR"sv, SourceWords("a Canon raw photo"), kRaw},
    {0, "IIRO", SourceWords("an Olympus raw photo"), kRaw},
    {0, "IIU\0"sv, SourceWords("a Panasonic raw photo"), kRaw},
    {0, "FUJIFILMCCD-RAW", SourceWords("a Fujifilm raw photo"), kRaw},
    {0, "FOVb", SourceWords("a Sigma raw photo"), kRaw},
    {0, "gimp xcf", SourceWords("a GIMP working file"), kExport},
    {0, "SDPX", SourceWords("a DPX film frame"), kFrame},
    {0, "XPDS", SourceWords("a DPX film frame"), kFrame},
    {4, "jP  \r\n", SourceWords("a JPEG 2000 picture"), SourceWords("convert it to PNG first, for example with opj_decompress")},
    {0, "\xFF\x4F\xFF\x51", SourceWords("a JPEG 2000 picture"),
     SourceWords("convert it to PNG first, for example with opj_decompress")},
    {4, "JXL \r\n", SourceWords("a JPEG XL picture"), SourceWords("convert it to PNG first, for example with djxl")},
    {0, "\xFF\x0A", SourceWords("a JPEG XL picture"), SourceWords("convert it to PNG first, for example with djxl")},
};

bool same(char a, char b) {
    const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
    return lower(a) == lower(b);
}

bool holds(std::string_view text, std::string_view word) {
    return std::search(text.begin(), text.end(), word.begin(), word.end(), same) != text.end();
}

// Office files are ZIP archives; the names of the first files in them tell which.
Phrase kind_of_archive(std::string_view head) {
    if (holds(head, "word/")) return phrase("a Word document (docx)");
    if (holds(head, "ppt/")) return phrase("a PowerPoint file (pptx)");
    if (holds(head, "xl/")) return phrase("an Excel sheet (xlsx)");
    if (holds(head, "application/vnd.oasis.opendocument.text")) return phrase("an OpenDocument text (odt)");
    if (holds(head, "application/vnd.oasis.opendocument")) return phrase("an OpenDocument file");
    if (holds(head, "application/epub+zip")) return phrase("an e-book (EPUB)");
    if (holds(head, "[Content_Types].xml")) return phrase("an Office file");
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

Phrase answer(const Phrase& what, const Phrase& mend) { return phrase("looks like {0}, not a picture; {1}", what, mend); }

Phrase text_answer(std::string_view text) {
    const auto start = text.find_first_not_of(" \t\r\n\f");
    if (start == std::string_view::npos) return answer(phrase("a text file with nothing but blanks"), phrase(kPhoto));
    const std::string_view body = text.substr(start);
    if (holds(body, "<svg")) return answer(phrase("an SVG drawing"), phrase(kDraw));
    if (holds(body.substr(0, 256), "<!doctype html") || holds(body.substr(0, 256), "<html"))
        return answer(phrase("an HTML page"), phrase("save the picture that is on it, not the page"));
    if (body.substr(0, 5) == "<?xml") return answer(phrase("an XML file"), phrase(kPhoto));
    if (body.substr(0, 5) == "#VRML" || body.substr(0, 6) == "solid ")
        return answer(phrase("a 3-D model"), phrase("make a picture of it first"));
    if (body[0] == '{' || body[0] == '[') return answer(phrase("JSON data"), phrase(kPhoto));
    if (is_table(body)) return answer(phrase("a table of data (CSV)"), phrase("draw a chart of it first"));
    return answer(phrase("a text file"), phrase("lay it out in braille with {0}, or {1}", spelled("text"), phrase(kPhoto)));
}

}  // namespace

Phrase lookalike(std::span<const unsigned char> head) {
    std::string_view text(reinterpret_cast<const char*>(head.data()), head.size());
    if (std::all_of(head.begin(), head.end(), [](unsigned char byte) { return byte == 0; }))
        return phrase("holds nothing but zero bytes, perhaps after a broken download or copy; get a fresh copy of it");
    if (text.substr(0, 4) == "PK\3\4") {
        const Phrase office = kind_of_archive(text);
        return office.empty() ? answer(phrase("a ZIP archive"), phrase(kUnpack)) : answer(office, phrase(kExport));
    }
    const auto is = [&](const Kind& kind) {
        return text.size() > kind.at && text.substr(kind.at, kind.bytes.size()) == kind.bytes;
    };
    for (const Kind& kind : kUnread)
        if (is(kind)) return phrase("looks like {0}, which is not read; {1}", phrase(kind.what), phrase(kind.mend));
    for (const Kind& kind : kKinds)
        if (is(kind)) return answer(phrase(kind.what), phrase(kind.mend));
    if (text.substr(0, 3) == "\xEF\xBB\xBF") text.remove_prefix(3);  // byte order mark
    if (is_text(text)) return text_answer(text);
    if (holds(text.substr(0, 1024), "%PDF-")) return answer(phrase("a PDF document"), phrase(kPage));  // some have rubbish before
    return phrase("is not a picture of a known kind; {0}", phrase(kPhoto));
}

}  // namespace tactics
