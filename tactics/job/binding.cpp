// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/binding.h"

#include <exception>
#include <shared_mutex>
#include <utility>

#include "tactics/error.h"
#include "tactics/transport/file.h"

namespace tactics {

namespace {

// What an outline calls it.
std::string name_in_outline(const Outcome& outcome, const Page& page) {
    if (!page.title.empty()) return page.title;
    if (outcome.pdf_page == 0) return stem_of(outcome.input);
    return phrase("{0}, page {1}", stem_of(outcome.input), std::to_string(outcome.pdf_page)).in(page.language);
}

}  // namespace

PageBinding::PageBinding(std::span<const Item> items, const Wishes& wishes, std::size_t ahead, WriteGate* gate)
    : items_(items), wishes_(wishes), ahead_(ahead), gate_(gate) {
    if (items.empty()) return;
    const std::vector<Output>& outputs = items.front().outputs;
    for (std::size_t i = 0; i < outputs.size(); ++i)
        if (outputs[i].bound) {
            if (outputs[i].path != "-") check_folder_of(outputs[i].path);
            files_.push_back({outputs[i], i, book_of(*outputs[i].format, wishes.settings_of(*outputs[i].format))});
        }
}

// Another turn of the sheet is no reason for a file that holds one.
void PageBinding::check_sizes(const Outcome& outcome) const {
    for (const BoundPages& bound : outcome.to_bind)
        for (const File& file : files_) {
            if (file.at != bound.output || file.pages == 0 || holds_several_sizes(*file.output.format)) continue;
            const Page& page = bound.pages.front();
            if (page.width == file.size.x && page.height == file.size.y) continue;
            throw Error(Fault::failed, "",
                        phrase("its page is turned, or of another size than those before it, and one {0} holds pages of one "
                               "size; name {1} and {2}, or choose a pdf",
                               file.output.format->name, spelled("orientation"), spelled("paper")));
        }
}

void PageBinding::bind(Outcome& outcome) {
    try {
        check_sizes(outcome);
        for (const BoundPages& bound : outcome.to_bind)
            for (File& file : files_) {
                if (file.at != bound.output) continue;
                const Page& first = bound.pages.front();
                // Each picture begins on a front, as its pages were arranged: the back of a drawing stays blank.
                if (wishes_.sheet.duplex && file.pages % 2 == 1) {
                    const Page blank = empty_like(first);
                    file.book->add(std::span(&blank, 1), "");
                    ++file.pages;
                }
                file.book->add(bound.pages, name_in_outline(outcome, first));
                if (file.pages == 0) file.size = {first.width, first.height};
                for (Made& made : outcome.made)
                    if (made.output.bound && made.output.path == file.output.path) made.page = file.pages + 1;
                file.pages += bound.pages.size();
            }
    } catch (const Error& error) {
        outcome.error = phrase("{0}: {1}", name_of_input(outcome), error.told());
        outcome.fault = error.fault();
    } catch (const std::exception& error) {  // such as no memory: later ones must not wait for ever
        outcome.error = phrase("{0}: it cannot be bound into one file: {1}", name_of_input(outcome), error.what());
        outcome.fault = Fault::failed;
    }
}

void PageBinding::take(std::size_t index, Outcome& outcome, const Next& next) {
    std::unique_lock lock(mutex_);
    moved_.wait(lock, [&] { return index < next_ + ahead_; });
    waiting_.emplace(index, std::move(outcome));
    for (auto first = waiting_.begin(); first != waiting_.end() && first->first == next_; first = waiting_.begin()) {
        Outcome done = std::move(first->second);
        waiting_.erase(first);
        if (done.error.empty()) bind(done);
        if (!done.error.empty()) missing_.push_back(name_of_input(done));
        up_to_date_ = up_to_date_ || done.up_to_date;
        done.to_bind.clear();
        next(next_++, done);
        moved_.notify_all();
    }
}

std::vector<BoundFile> PageBinding::write() {
    std::vector<BoundFile> written;
    if (up_to_date_) return written;
    for (File& file : files_) {
        BoundFile told{file.output.path, file.pages, missing_, {}};
        try {
            if (file.pages > 0) {
                const std::string title = wishes_.sheet.title.empty() ? stem_of(file.output.path) : wishes_.sheet.title;
                const std::string bytes = file.book->finish(title);
                std::shared_lock<WriteGate> lock;
                if (gate_ != nullptr) lock = std::shared_lock(*gate_);
                write_file(file.output.path, bytes);
            }
        } catch (const Error& error) {
            told.error = error.told();
        }
        written.push_back(std::move(told));
    }
    return written;
}

}  // namespace tactics
