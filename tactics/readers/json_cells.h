// SPDX-License-Identifier: Apache-2.0
// JSON (RFC 8259) as a sequence of cells, in rows or columns.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "tactics/readers/read.h"
#include "tactics/readers/table.h"
#include "tactics/text/phrase.h"

namespace tactics {

inline constexpr std::size_t kLongestJsonValue = 65'536;  // bytes; of blanks between values, too

/// Where a reader of bytes is.
struct JsonPosition {
    std::size_t at = 0;                    ///< bytes
    std::size_t line = 1, line_begin = 0;  ///< from 1, and where it begins
    std::size_t since = 0;                 ///< bytes since the last value
};

/// Numbers stay text. A nested structure in place of a value is one cell, "[...]" or "{...}".
class JsonCells {
public:
    explicit JsonCells(const Source& source) : source_(source) {}
    virtual ~JsonCells() = default;
    JsonCells(const JsonCells&) = delete;
    JsonCells& operator=(const JsonCells&) = delete;

    /// From the start until the end, or until enough is known. Throws Error with the line and the letter in it.
    void read();

    /// Events of the JSON reader; they return whether to continue.
    bool value(std::string_view text);
    bool name(std::string_view text);
    bool object_begins();
    bool array_begins();
    bool ends();

    TableForm form() const { return form_.value_or(TableForm::values); }

protected:
    /// A cell of `key()` or, in arrays, of `index()`; whether more is wanted.
    virtual bool cell(std::string_view text) = 0;
    virtual bool row_ends() = 0;
    virtual bool column_begins(const std::string& name) = 0;

    [[noreturn]] void fail(const Phrase& message) const;
    /// Rows that are arrays are equally long.
    void check_count(std::size_t expected) const;
    const std::string& key() const { return key_; }
    std::size_t index() const { return index_; }
    std::size_t row_line() const { return row_line_; }
    bool in_heights() const { return depth_ == 3 && skipped_ == 0; }

private:
    bool in_object() const { return form_ == TableForm::columns; }
    bool opens();
    bool skip(std::string_view shown);
    bool put(std::string_view text);
    void set(TableForm form);

    const Source& source_;
    JsonPosition position_;
    std::optional<TableForm> form_;
    std::string key_;
    std::size_t index_ = 0, row_line_ = 1;
    unsigned depth_ = 0, skipped_ = 0;
};

}  // namespace tactics
