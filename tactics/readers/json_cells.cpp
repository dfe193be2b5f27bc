// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/json_cells.h"

#include <rapidjson/error/en.h>
#include <rapidjson/reader.h>

#include <vector>

#include "tactics/error.h"
#include "tactics/text/utf8.h"

namespace tactics {

namespace {

constexpr std::size_t kJsonChunk = 256 * 1024;
constexpr unsigned kDeepest = 32;  // of what is skipped

// The input stream of RapidJSON. A value that is too long ends it.
class JsonBytes {
public:
    using Ch = char;

    JsonBytes(const Source& source, JsonPosition& position) : source_(source), position_(position), buffer_(kJsonChunk) {
        std::rewind(source_.file.get());
        fill();
        if (std::string_view(buffer_.data(), end_).starts_with("\xEF\xBB\xBF")) position_.at = at_ = 3;
    }

    Ch Peek() const { return at_ < end_ ? buffer_[at_] : '\0'; }
    Ch Take() {
        if (at_ == end_) return '\0';
        const char c = buffer_[at_];
        ++position_.at;
        if (c == '\n') {
            ++position_.line;
            position_.line_begin = position_.at;
        }
        ++position_.since;
        if (++at_ == end_ || too_long()) fill();
        return c;
    }
    std::size_t Tell() const { return position_.at; }
    // Of streams that are written to.
    Ch* PutBegin() { return nullptr; }
    void Put(Ch) {}
    void Flush() {}
    std::size_t PutEnd(Ch*) { return 0; }

    bool too_long() const { return position_.since > kLongestJsonValue; }
    bool at_end() const { return at_ == end_; }

private:
    void fill() {
        at_ = end_ = 0;
        if (too_long()) return;
        end_ = std::fread(buffer_.data(), 1, buffer_.size(), source_.file.get());
        if (std::ferror(source_.file.get()) != 0) throw Error(Fault::failed, source_.name, phrase("it cannot be read"));
    }

    const Source& source_;
    JsonPosition& position_;
    std::vector<char> buffer_;
    std::size_t at_ = 0, end_ = 0;
};

struct Told {
    JsonCells& cells;

    bool Null() { return cells.value(""); }
    bool Bool(bool yes) { return cells.value(yes ? "true" : "false"); }
    bool RawNumber(const char* text, rapidjson::SizeType length, bool) { return cells.value({text, length}); }
    bool String(const char* text, rapidjson::SizeType length, bool) { return cells.value({text, length}); }
    bool Key(const char* text, rapidjson::SizeType length, bool) { return cells.name({text, length}); }
    bool StartObject() { return cells.object_begins(); }
    bool StartArray() { return cells.array_begins(); }
    bool EndObject(rapidjson::SizeType) { return cells.ends(); }
    bool EndArray(rapidjson::SizeType) { return cells.ends(); }
    // Never told, as numbers stay text.
    bool Int(int) { return false; }
    bool Uint(unsigned) { return false; }
    bool Int64(std::int64_t) { return false; }
    bool Uint64(std::uint64_t) { return false; }
    bool Double(double) { return false; }
};

}  // namespace

void JsonCells::read() {
    JsonBytes bytes(source_, position_);
    Told told{*this};
    rapidjson::Reader reader;
    constexpr unsigned kFlags = rapidjson::kParseIterativeFlag | rapidjson::kParseNumbersAsStringsFlag |
                                rapidjson::kParseNanAndInfFlag | rapidjson::kParseValidateEncodingFlag;
    const rapidjson::ParseResult result = reader.Parse<kFlags>(bytes, told);
    if (!result.IsError() || result.Code() == rapidjson::kParseErrorTermination) return;
    if (bytes.too_long()) fail(phrase("a value is longer than {0} bytes; is this a table?", std::to_string(kLongestJsonValue)));
    if (bytes.at_end()) fail(phrase("it ends in the middle; get all of it"));
    std::string what = rapidjson::GetParseError_En(result.Code());
    if (what.ends_with('.')) what.pop_back();
    fail(phrase("it is no JSON: {0}", what));
}

void JsonCells::fail(const Phrase& message) const {
    throw Error(
        Fault::failed,
        source_.name + ":" + std::to_string(position_.line) + ":" + std::to_string(position_.at - position_.line_begin + 1),
        message);
}

void JsonCells::check_count(std::size_t expected) const {
    if (form_ == TableForm::arrays && index_ != expected)
        fail(phrase("there are {0} values for {1} in the row before; write null for gaps", std::to_string(index_),
                    std::to_string(expected)));
}

bool JsonCells::name(std::string_view text) {
    position_.since = 0;
    if (skipped_ == 0) key_ = text;
    return true;
}

bool JsonCells::object_begins() {
    if (!opens()) return true;
    if (depth_ == 1) {
        set(TableForm::columns);
        return true;
    }
    if (depth_ == 2 && !in_object()) {
        set(TableForm::records);
        row_line_ = position_.line;
        return true;
    }
    return skip("{...}");
}

bool JsonCells::array_begins() {
    if (!opens() || depth_ == 1) return true;
    if (depth_ == 2 && in_object()) {
        index_ = 0;
        return column_begins(key_);
    }
    if (depth_ == 2) set(TableForm::arrays);
    if (depth_ > 3 || (depth_ == 3 && !(in_object() && key_ == "z"))) return skip("[...]");
    row_line_ = position_.line;
    index_ = 0;
    return true;
}

// Whether it is no part of what is skipped.
bool JsonCells::opens() {
    position_.since = 0;
    ++depth_;
    if (skipped_ == 0) return true;
    if (depth_ > kDeepest) fail(phrase("it is nested more than {0} deep; is this a table?", std::to_string(kDeepest)));
    return false;
}

// What is nested where a value should be.
bool JsonCells::skip(std::string_view shown) {
    if (depth_ == 2 && in_object())
        fail(phrase("\"{0}\" is an object; a table is an array of objects, or an object of arrays", beginning_of(to_line(key_))));
    skipped_ = depth_;
    return put(shown);
}

bool JsonCells::ends() {
    position_.since = 0;
    const unsigned depth = depth_--;
    if (skipped_ > 0) {
        if (skipped_ == depth) skipped_ = 0;
        return true;
    }
    return depth == 3 || (depth == 2 && !in_object()) ? row_ends() : true;
}

bool JsonCells::value(std::string_view text) {
    position_.since = 0;
    if (skipped_ > 0) return true;
    if (depth_ == 0) fail(phrase("there is one value; a table is an array or an object"));
    if (depth_ == 1 && in_object()) return true;  // what is said of the whole
    if (depth_ > 1) return put(text);
    set(TableForm::values);
    row_line_ = position_.line;
    index_ = 0;
    return put(text) && row_ends();
}

bool JsonCells::put(std::string_view text) {
    if (!cell(text)) return false;
    ++index_;
    return true;
}

void JsonCells::set(TableForm form) {
    if (form_ && *form_ != form) fail(phrase("its rows are not of one kind; write all as objects, or all as arrays"));
    form_ = form;
}

}  // namespace tactics
