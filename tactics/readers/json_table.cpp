// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/json_table.h"

#include <algorithm>
#include <unordered_map>

#include "tactics/error.h"
#include "tactics/readers/json_cells.h"
#include "tactics/text/number.h"
#include "tactics/text/utf8.h"

namespace tactics {

namespace {

class JsonHead : public JsonCells {
public:
    explicit JsonHead(const Source& source) : JsonCells(source) { head_.name = source.name; }

    TableHead head() {
        read();
        head_.form = form();
        if (form() == TableForm::columns) rows_of_columns();
        if (names_.empty() && widest_ == 0)
            throw Error(Fault::failed, head_.name, phrase("there is no row in it; write one, such as [{\"x\": 1, \"y\": 2.5}]"));
        if (names_.empty())
            name_columns_by_number(head_, widest_);
        else
            name_columns(head_, std::move(names_), head_.rows.empty() ? 1 : head_.rows.front().line);
        for (TableRow& row : head_.rows) row.cells.resize(head_.columns.size());
        if (form() == TableForm::arrays) take_names(head_);
        return std::move(head_);
    }

protected:
    bool cell(std::string_view text) override {
        if (in_heights()) {
            heights_ = true;
            return true;
        }
        const std::size_t at = form() == TableForm::records ? column_of(key()) : index();
        if (form() == TableForm::columns) {
            std::vector<std::string>& column = columns_.back();
            ++count_;
            if (names_.back() == "x" || names_.back() == "y") {
                std::vector<double>& along = names_.back() == "x" ? head_.across : head_.up;
                const auto number = parse_number(text);
                if (number && along.size() < kMostTableColumns)
                    along.push_back(*number);
                else
                    no_side_ = true;
            }
            if (column.size() < kHeadRows) column.emplace_back(text);
            return true;
        }
        if (at >= kMostTableColumns)
            fail(phrase("there are more than {0} columns; keep those that are to be shown", std::to_string(kMostTableColumns)));
        widest_ = std::max(widest_, at + 1);
        if (cells_.size() <= at) cells_.resize(at + 1);
        cells_[at] = text;
        return true;
    }

    bool row_ends() override {
        if (in_heights() || form() == TableForm::columns) return true;
        check_count(head_.rows.empty() ? index() : head_.rows.front().cells.size());
        head_.rows.push_back({row_line(), std::move(cells_)});
        cells_.clear();
        return head_.rows.size() < kHeadRows;
    }

    bool column_begins(const std::string& name) override {
        if (names_.size() == kMostTableColumns)
            fail(phrase("there are more than {0} columns; keep those that are to be shown", std::to_string(kMostTableColumns)));
        names_.push_back(name);
        columns_.emplace_back();
        head_.rows_expected = std::max(head_.rows_expected, count_);
        count_ = 0;
        return true;
    }

private:
    std::size_t column_of(const std::string& name) {
        const auto [known, fresh] = indices_.try_emplace(name, names_.size());
        if (fresh && to_line(name).empty()) fail(phrase("a value has no name"));
        if (fresh) names_.push_back(name);
        return known->second;
    }

    void rows_of_columns() {
        if (heights_) {
            const auto z = std::find(names_.begin(), names_.end(), "z") - names_.begin();
            if (!columns_[static_cast<std::size_t>(z)].empty())
                throw Error(Fault::failed, head_.name, phrase("z has rows and numbers; write all of it as rows"));
            if (no_side_)
                throw Error(Fault::failed, head_.name,
                            phrase("x and y of a surface are numbers, at most {0} each", std::to_string(kMostTableColumns)));
            head_.form = TableForm::heights;
            return;
        }
        head_.across.clear();
        head_.up.clear();
        head_.rows_expected = std::max(head_.rows_expected, count_);
        std::size_t rows = 0;
        for (const auto& column : columns_) rows = std::max(rows, column.size());
        head_.rows.resize(rows);
        for (std::size_t i = 0; i < rows; ++i) {
            head_.rows[i].line = i + 1;
            for (const auto& column : columns_) head_.rows[i].cells.push_back(i < column.size() ? column[i] : "");
        }
    }

    TableHead head_;
    std::vector<std::string> names_, cells_;
    std::vector<std::vector<std::string>> columns_;
    std::unordered_map<std::string, std::size_t> indices_;
    std::size_t widest_ = 0, count_ = 0;
    bool heights_ = false, no_side_ = false;
};

class JsonRows : public JsonCells {
public:
    JsonRows(const Source& source, const TableHead& head, std::span<const std::size_t> wanted, const TakeRow& take)
        : JsonCells(source),
          head_(head),
          wanted_(wanted.begin(), wanted.end()),
          take_(take),
          cells_(wanted.size()),
          views_(wanted.size()) {}

    void rows() {
        read();
        if (head_.form == TableForm::columns) take_columns();
    }

protected:
    bool cell(std::string_view text) override {
        if (head_.form == TableForm::heights) {
            if (in_heights()) cells_.emplace_back(text);
            return true;
        }
        if (head_.form == TableForm::records) {
            for (const std::size_t place : places_of(key())) cells_[place] = text;
            return true;
        }
        if (head_.form == TableForm::columns) {
            for (const std::size_t place : places_of(key())) {
                kept_bytes_ += text.size() + 1;
                if (kept_bytes_ > kMostJsonColumns)
                    fail(phrase("its columns are more than {0} MiB of text; write it as rows, [[1, 2.5], [2, 3.5]]",
                                std::to_string(kMostJsonColumns >> 20)));
                cells_[place].append(text.substr(0, text.find('\0'))).append(1, '\0');
            }
            return true;
        }
        for (std::size_t i = 0; i < wanted_.size(); ++i)
            if (index() == wanted_[i]) cells_[i] = text;
        return true;
    }

    bool row_ends() override {
        if (head_.form == TableForm::columns) return true;
        check_count(head_.columns.size());
        give(row_line());
        if (head_.form == TableForm::heights) cells_.clear();
        for (std::string& cell : cells_) cell.clear();
        return true;
    }

    bool column_begins(const std::string&) override { return true; }

private:
    // Which of the wanted columns that is.
    const std::vector<std::size_t>& places_of(const std::string& name) {
        const auto [known, fresh] = places_.try_emplace(name);
        if (fresh) {
            if (places_.size() > kMostTableColumns)
                fail(phrase("there are more than {0} columns; keep those that are to be shown",
                            std::to_string(kMostTableColumns)));
            const std::string line = to_line(name);
            for (std::size_t i = 0; i < wanted_.size(); ++i)
                if (head_.columns[wanted_[i]] == line) known->second.push_back(i);
        }
        return known->second;
    }

    void give(std::size_t line) {
        if (skipped_rows_ < head_.skipped) {
            ++skipped_rows_;
            return;
        }
        if (rows_++ == kMostTableRows)
            fail(phrase("there are more than {0} rows; keep every tenth or hundredth", std::to_string(kMostTableRows)));
        views_.assign(cells_.begin(), cells_.end());
        take_(line, views_, false);
    }

    void take_columns() {
        std::vector<std::string_view> rest(cells_.begin(), cells_.end());
        std::size_t line = 0;
        const auto some = [](std::string_view column) { return !column.empty(); };
        while (std::any_of(rest.begin(), rest.end(), some)) {
            if (!std::all_of(rest.begin(), rest.end(), some))
                throw Error(Fault::failed, place_of_row(head_, line + 1),
                            phrase("one of its columns ends here, and another goes on; write null for gaps"));
            for (std::size_t i = 0; i < rest.size(); ++i) {
                const auto end = std::min(rest[i].find('\0'), rest[i].size());
                views_[i] = rest[i].substr(0, end);
                rest[i].remove_prefix(std::min(end + 1, rest[i].size()));
            }
            if (line++ == kMostTableRows)
                fail(phrase("there are more than {0} rows; keep every tenth or hundredth", std::to_string(kMostTableRows)));
            take_(line, views_, false);
        }
    }

    const TableHead& head_;
    std::vector<std::size_t> wanted_;
    const TakeRow& take_;
    std::vector<std::string> cells_;
    std::vector<std::string_view> views_;
    std::unordered_map<std::string, std::vector<std::size_t>> places_;
    std::size_t rows_ = 0, skipped_rows_ = 0, kept_bytes_ = 0;
};

}  // namespace

bool begins_json(const Source& source) {
    if (source.file == nullptr) return false;
    std::rewind(source.file.get());
    int c = std::getc(source.file.get());
    if (c == 0xEF && std::getc(source.file.get()) == 0xBB && std::getc(source.file.get()) == 0xBF)
        c = std::getc(source.file.get());
    while (c == ' ' || c == '\t' || c == '\r' || c == '\n') c = std::getc(source.file.get());
    std::rewind(source.file.get());
    return c == '[' || c == '{';
}

TableHead json_table_head(Source& source) { return JsonHead(source).head(); }

void read_json_rows(Source& source, const TableHead& head, std::span<const std::size_t> wanted, const TakeRow& take) {
    JsonRows(source, head, wanted, take).rows();
}

}  // namespace tactics
