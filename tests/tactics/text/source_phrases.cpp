// SPDX-License-Identifier: Apache-2.0
#include "tests/tactics/text/source_phrases.h"

#include <algorithm>
#include <cctype>
#include <map>

namespace tactics::tests {

namespace {

struct Token {
    enum class Kind { word, string, mark } kind = Kind::mark;
    std::string text;
};

bool is_letter(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

// A string that begins at `at`, without its marks; strings beside each other are one. `at` is then behind it.
std::string take_string(const std::string& text, std::size_t& at) {
    std::string plain;
    for (++at; at < text.size() && text[at] != '"'; ++at) {
        if (text[at] != '\\') {
            plain += text[at];
        } else if (text[++at] == 'x') {
            plain += static_cast<char>(std::stoi(text.substr(at + 1, 2), nullptr, 16));
            at += 2;
        } else {
            plain += text[at] == 'n' ? '\n' : text[at] == 't' ? '\t' : text[at];
        }
    }
    ++at;
    return plain;
}

// Enough of C++ for what stands around phrases: no raw strings.
std::vector<Token> tokens_of(const std::string& text) {
    std::vector<Token> tokens;
    for (std::size_t at = 0; at < text.size();) {
        if (text.compare(at, 2, "//") == 0) {
            at = std::min(text.find('\n', at), text.size());
        } else if (text[at] == '"') {
            std::string plain = take_string(text, at);
            if (!tokens.empty() && tokens.back().kind == Token::Kind::string)
                tokens.back().text += plain;
            else
                tokens.push_back({Token::Kind::string, std::move(plain)});
        } else if (text[at] == '\'') {
            const std::size_t end = text.find('\'', at + (text[at + 1] == '\\' ? 3 : 2));
            const bool digits = at > 0 && is_letter(text[at - 1]);  // 10'000
            at = digits || end == std::string::npos ? at + 1 : end + 1;
        } else if (is_letter(text[at])) {
            const std::size_t from = at;
            while (at < text.size() && is_letter(text[at])) ++at;
            tokens.push_back({Token::Kind::word, text.substr(from, at - from)});
        } else {
            if (std::isspace(static_cast<unsigned char>(text[at])) == 0) tokens.push_back({Token::Kind::mark, {text[at]}});
            ++at;
        }
    }
    return tokens;
}

class Reading {
public:
    explicit Reading(const SourceFile& file) : tokens_(tokens_of(file.text)), path_(file.path) {}

    std::vector<SourcePhrase> run() {
        for (std::size_t at = 0; at < tokens_.size(); ++at) {
            if (tokens_[at].kind != Token::Kind::word) continue;
            const std::string& word = tokens_[at].text;
            if ((word == "phrase" || word == "TEXTURE" || word == "SourceWords") && is(at + 1, "(") && is_string(at + 2))
                found_.push_back({tokens_[at + 2].text, "", path_});
            else if (word == "mend" && at > 0 && is(at - 1, ".") && is(at + 1, "=") && is_string(at + 2))  // of a rule
                found_.push_back({tokens_[at + 2].text, "", path_});
            else if (word == "phrases" && is(at + 1, "("))
                take_plural(at + 2);
            else if (word == "SourceWords")
                take_list(at + 1);
        }
        return std::move(found_);
    }

    // Of each call of that name, the strings in one of its parts.
    std::vector<std::string> plain_words(std::string_view name, int part) const {
        std::vector<std::string> plain;
        for (std::size_t at = 0; at + 1 < tokens_.size(); ++at)
            if (tokens_[at].kind == Token::Kind::word && tokens_[at].text == name && is(at + 1, "(")) look(at + 2, part, plain);
        return plain;
    }

private:
    void look(std::size_t at, int part, std::vector<std::string>& plain) const {
        std::vector<bool> calls;  // what is open: brackets of a call, or others
        for (int now = 0; at < tokens_.size(); ++at) {
            if (is(at, "(") || is(at, "{") || is(at, "[")) {
                calls.push_back(tokens_[at - 1].kind == Token::Kind::word);
            } else if (is(at, ")") || is(at, "}") || is(at, "]")) {
                if (calls.empty()) return;
                calls.pop_back();
            } else if (is(at, ",") && calls.empty()) {
                ++now;
            } else if (is_string(at) && now == part && !is(at - 1, "=") &&
                       std::find(calls.begin(), calls.end(), true) == calls.end() &&
                       std::any_of(tokens_[at].text.begin(), tokens_[at].text.end(), is_letter)) {
                plain.push_back(tokens_[at].text);
            }
        }
    }

    bool is(std::size_t at, std::string_view mark) const {
        return at < tokens_.size() && tokens_[at].kind == Token::Kind::mark && tokens_[at].text == mark;
    }
    bool is_string(std::size_t at) const { return at < tokens_.size() && tokens_[at].kind == Token::Kind::string; }

    // Behind the number, which may have commas within brackets.
    void take_plural(std::size_t at) {
        int depth = 0;
        for (; at < tokens_.size() && (depth > 0 || !is(at, ",")); ++at)
            depth += is(at, "(") || is(at, "{") ? 1 : is(at, ")") || is(at, "}") ? -1 : 0;
        if (is_string(at + 1) && is(at + 2, ",") && is_string(at + 3))
            found_.push_back({tokens_[at + 1].text, tokens_[at + 3].text, path_});
    }

    // std::array<SourceWords, 9> kNames{"one", "two"};
    void take_list(std::size_t at) {
        while (at < tokens_.size() &&
               (tokens_[at].kind == Token::Kind::word || is(at, ",") || is(at, ">") || is(at, "[") || is(at, "]")))
            ++at;
        if (!is(at, "{") && !is(at, "=")) return;
        for (; at < tokens_.size() && !is(at, ";"); ++at)
            if (is_string(at) && !is(at - 1, "(")) found_.push_back({tokens_[at].text, "", path_});
    }

    std::vector<Token> tokens_;
    std::string path_;
    std::vector<SourcePhrase> found_;
};

}  // namespace

std::vector<SourcePhrase> phrases_in(const SourceFile& file) { return Reading(file).run(); }

std::vector<std::string> plain_words_in(const SourceFile& file) {
    const Reading reading(file);
    std::vector<std::string> plain = reading.plain_words("Error", 2);
    // CUPS reads what its filter says.
    if (file.path.starts_with("cli/") && !file.path.ends_with("/cups_filter.cpp") && !file.path.ends_with("/print_job.cpp"))
        for (std::string& words : reading.plain_words("say", 0)) plain.push_back(std::move(words));
    return plain;
}

std::vector<SourcePhrase> phrases_of_the_program() {
    std::vector<SourcePhrase> all;
    std::map<std::string, std::size_t> known;
    for (const SourceFile& file : tree()) {
        if (!is_source(file) || starts_with_any(file.path, {"tests/", "samples/"}) ||
            file.path.starts_with("tactics/text/phrase.h"))
            continue;
        for (SourcePhrase& one : phrases_in(file)) {
            if (one.english.empty()) continue;
            const auto [entry, fresh] = known.emplace(one.english, all.size());
            if (fresh)
                all.push_back(std::move(one));
            else if (all[entry->second].plural.empty())
                all[entry->second].plural = one.plural;
        }
    }
    return all;
}

}  // namespace tactics::tests
