// SPDX-License-Identifier: Apache-2.0
// The words of a command line, sorted: options with their values, and what belongs to none.
#include <optional>

#include "cli/command.h"
#include "tactics/error.h"

namespace tactics {

namespace {

const Flag* find_flag(std::span<const Flag> flags, std::string_view name) {
    for (const Flag& flag : flags)
        if (flag.name == name || (!flag.letter.empty() && flag.letter == name)) return &flag;
    for (const Flag& flag : flags)
        if (!flag.also.empty() && flag.also == name) return &flag;
    return nullptr;
}

[[noreturn]] void refuse_unknown(const Command& command, std::span<const Flag> flags, const std::string& word) {
    std::vector<std::string_view> names;
    for (const Flag& flag : flags) names.push_back(flag.name);
    const std::string name = word.substr(0, word.find('=')).substr(0, 80);
    throw Error(Fault::usage, "",
                phrase("there is no option {0}{1}; see tactics help {2}, and write ./{0} for a file of that name", name,
                       did_you_mean(name, names), command.name));
}

// Parses the words in order, by the rules of POSIX and GNU (Utility Conventions, guidelines 3 to 11; getopt_long).
class Sorting {
public:
    Sorting(const Command& command, std::span<const Flag> flags) : command_(command), flags_(flags), values_(flags.size()) {}

    void take(const std::string& word) {
        if (waiting_ != nullptr) {
            values_of(*waiting_).push_back(word);  // even if it looks like an option
            waiting_ = nullptr;
        } else if (only_words_ || word.size() < 2 || word[0] != '-') {
            words_.push_back(word);
        } else if (word == "--") {
            only_words_ = true;
        } else if (word.starts_with("--")) {
            take_name(word);
        } else {
            take_letters(word);
        }
        last_ = word;
    }

    Given given() && {
        if (waiting_ != nullptr)
            throw Error(Fault::usage, last_, phrase("its value is missing; write {0} {1}", last_, waiting_->value));
        if (unknown_) refuse_unknown(command_, flags_, *unknown_);
        Given given(command_.flags);
        given.words = std::move(words_);
        for (std::size_t i = 0; i < flags_.size(); ++i) {
            const bool is_switch = flags_[i].value.empty();
            if (values_[i].size() > 1 && !flags_[i].repeatable) {
                if (!is_switch) throw Error(Fault::usage, flags_[i].name, phrase("this option is given twice; give it once"));
                values_[i].resize(1);
            }
            for (auto& value : values_[i]) given.add(flags_[i].name, std::move(value));
        }
        return given;
    }

private:
    std::vector<std::string>& values_of(const Flag& flag) { return values_[static_cast<std::size_t>(&flag - flags_.data())]; }

    // A switch is there now; another option has `value` or waits for the next word.
    void meet(const Flag& flag, const std::optional<std::string>& value) {
        if (flag.value.empty() || value)
            values_of(flag).push_back(value.value_or(""));
        else
            waiting_ = &flag;
    }

    void take_name(const std::string& word) {  // --name or --name=value
        const auto equals = word.find('=');
        const Flag* flag = find_flag(flags_, word.substr(0, equals));
        if (flag == nullptr) {
            miss(word);
        } else if (equals == std::string::npos) {
            meet(*flag, std::nullopt);
        } else {
            if (flag->value.empty())
                throw Error(Fault::usage, flag->name, phrase("this option takes no value; leave out {0}", word.substr(equals)));
            meet(*flag, word.substr(equals + 1));
        }
    }

    void take_letters(const std::string& word) {  // -q, -qo FILE, -oFILE
        for (std::size_t i = 1; i < word.size(); ++i) {
            const Flag* flag = find_flag(flags_, std::string("-") + word[i]);
            if (flag == nullptr) return miss(i == 1 ? word : "-" + word.substr(i));
            const bool last = i + 1 == word.size();
            meet(*flag, flag->value.empty() || last ? std::nullopt : std::optional(word.substr(i + 1)));
            if (!flag->value.empty()) return;
        }
    }

    void miss(const std::string& word) {
        if (!unknown_) unknown_ = word;
    }

    const Command& command_;
    std::span<const Flag> flags_;
    std::vector<std::vector<std::string>> values_;
    std::vector<std::string> words_;
    const Flag* waiting_ = nullptr;  // for its value
    bool only_words_ = false;        // after "--"
    std::optional<std::string> unknown_;
    std::string last_;
};

}  // namespace

Given parse_words(const Command& command, const std::vector<std::string>& words) {
    const std::vector<Flag> flags = all_flags(command);
    Sorting sorting(command, flags);
    for (const auto& word : words) sorting.take(word);
    return std::move(sorting).given();
}

}  // namespace tactics
