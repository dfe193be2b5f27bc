// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/stl.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <string_view>

#include "tactics/error.h"
#include "tactics/units.h"

namespace tactics {

namespace {

constexpr long long kHeaderBytes = 84, kTriangleBytes = 50;
constexpr std::size_t kMostStlWord = 100;  // letters of a word or number of a text STL

[[noreturn]] void fail(const Source& source, const Phrase& why) { throw Error(Fault::failed, source.name, why); }

std::uint32_t number(const unsigned char* bytes) {
    return std::uint32_t{bytes[0]} | std::uint32_t{bytes[1]} << 8 | std::uint32_t{bytes[2]} << 16 | std::uint32_t{bytes[3]} << 24;
}

long long size_of(Source& source) {
    if (source.file == nullptr || std::fseek(source.file.get(), 0, SEEK_END) != 0) return 0;
    return std::ftell(source.file.get());
}

struct StlHead {
    std::array<unsigned char, kHeaderBytes> bytes{};
    long long size = 0;    ///< of the file
    long long needed = 0;  ///< for as many triangles as a binary file says
    bool text = false;
};

// Binary files may also begin with "solid"; then their size decides.
StlHead head_of(Source& source) {
    StlHead head;
    head.size = size_of(source);
    if (head.size == 0) return head;
    std::rewind(source.file.get());
    const std::size_t got = std::fread(head.bytes.data(), 1, head.bytes.size(), source.file.get());
    std::rewind(source.file.get());
    if (got == head.bytes.size()) head.needed = kHeaderBytes + kTriangleBytes * number(head.bytes.data() + 80);
    std::string_view start(reinterpret_cast<const char*>(head.bytes.data()), got);
    while (!start.empty() && (start[0] == ' ' || (start[0] >= '\t' && start[0] <= '\r'))) start.remove_prefix(1);
    head.text = start.starts_with("solid") && head.size != head.needed;
    return head;
}

void each_binary(Source& source, const StlHead& head, const std::function<void(const Triangle&)>& take) {
    if (head.size < kHeaderBytes)
        fail(source, phrase("is cut short in its first {0} bytes, or is no STL model; get a complete copy of it",
                            std::to_string(kHeaderBytes)));
    const std::uint32_t count = number(head.bytes.data() + 80);
    if (head.size < head.needed)
        fail(source, phrase("is cut short, or is no STL model: it says that it has {0} triangles, which are {1} bytes, and has "
                            "{2}; get a complete copy of it",
                            std::to_string(count), std::to_string(head.needed), std::to_string(head.size)));
    std::fseek(source.file.get(), kHeaderBytes, SEEK_SET);
    std::array<unsigned char, kTriangleBytes> bytes{};
    for (std::uint32_t i = 0; i < count; ++i) {
        if (std::fread(bytes.data(), 1, bytes.size(), source.file.get()) != bytes.size())
            fail(source, phrase("cannot be read to its end; get a fresh copy of it"));
        Triangle triangle;
        for (std::size_t k = 0; k < 9; ++k) {
            const double value = std::bit_cast<float>(number(bytes.data() + 12 + 4 * k));
            if (!std::isfinite(value))
                fail(source,
                     phrase("has a corner that is no number, in triangle {0}; save the model again", std::to_string(i + 1)));
            triangle.corners[k / 3][k % 3] = value;
        }
        take(triangle);
    }
    if (count == 0) fail(source, phrase("has no triangles; save the model again with its surface"));
}

// solid NAME, then facets: facet normal X Y Z, outer loop, three times vertex X Y Z, endloop, endfacet; endsolid NAME. Normals
// are not needed, and some files leave them out.
class TextStl {
public:
    explicit TextStl(Source& source) : source_(source) { std::rewind(source_.file.get()); }

    void each(const std::function<void(const Triangle&)>& take) {
        bool any = false, open = false;
        while (next()) {
            if (word_ == "solid" || word_ == "endsolid") {
                open = word_ == "solid";
                skip_line();
            } else if (word_ == "facet") {
                count_ = 0;
            } else if (word_ == "normal") {
                for (int i = 0; i < 3; ++i) next();
            } else if (word_ == "vertex") {
                corner();
            } else if (word_ == "endfacet") {
                if (count_ != 3) fail(phrase("a facet has {0} corners; save the model as triangles", std::to_string(count_)));
                take(triangle_);
                any = true;
            } else if (word_ != "outer" && word_ != "loop" && word_ != "endloop") {
                if (std::feof(source_.file.get()) != 0) break;  // cut in a word
                fail(phrase("\"{0}\" is no word of an STL; save the model again", word_.substr(0, 40)));
            }
        }
        if (open) fail(phrase("the file ends before \"endsolid\"; get a complete copy of it"));
        if (!any) tactics::fail(source_, phrase("has no triangles; save the model again with its surface"));
    }

private:
    [[noreturn]] void fail(const Phrase& why) const {
        throw Error(Fault::failed, source_.name + ":" + std::to_string(line_), why);
    }

    int letter() { return std::fgetc(source_.file.get()); }

    bool next() {
        word_.clear();
        int c = letter();
        for (; c == ' ' || (c >= '\t' && c <= '\r'); c = letter())
            if (c == '\n') ++line_;
        for (; c != EOF && c != ' ' && !(c >= '\t' && c <= '\r'); c = letter()) {
            if (word_.size() == kMostStlWord)
                fail(phrase("there is a word of over {0} letters; this is no STL model", std::to_string(kMostStlWord)));
            word_ += static_cast<char>(c);
        }
        if (c != EOF) std::ungetc(c, source_.file.get());
        return !word_.empty();
    }

    void skip_line() {
        for (int c = letter(); c != EOF; c = letter())
            if (c == '\n') {
                ++line_;
                return;
            }
    }

    void corner() {
        for (std::size_t k = 0; k < 3; ++k) {
            if (!next()) fail(phrase("the file ends in a corner; get a complete copy of it"));
            const auto value = parse_number(word_.starts_with('+') ? std::string_view(word_).substr(1) : std::string_view(word_));
            if (!value) fail(phrase("\"{0}\" is no number; a corner is three numbers such as 1.5e+01", word_.substr(0, 40)));
            if (count_ < 3) triangle_.corners[static_cast<std::size_t>(count_)][k] = *value;
        }
        if (count_ < 1000) ++count_;
    }

    Source& source_;
    std::string word_;
    long long line_ = 1;
    int count_ = 0;  // corners of the facet
    Triangle triangle_{};
};

}  // namespace

bool is_stl(Source& source) {
    const StlHead head = head_of(source);
    if (head.text || (head.needed > kHeaderBytes && head.size == head.needed)) return true;
    std::string end = source.name.size() < 4 ? "" : source.name.substr(source.name.size() - 4);
    for (char& c : end) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return head.size > 0 && end == ".stl";
}

void each_triangle(Source& source, const std::function<void(const Triangle&)>& take) {
    const StlHead head = head_of(source);
    if (head.text)
        TextStl(source).each(take);
    else
        each_binary(source, head, take);
}

}  // namespace tactics
