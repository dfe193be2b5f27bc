// SPDX-License-Identifier: Apache-2.0
// The pages of many pictures in one file, in the order of the pictures.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "print/page_book.h"
#include "tactics/job/make_pages.h"

namespace tactics {

/// The result for a file: written or not.
struct BoundFile {
    std::string path;
    std::size_t pages = 0;             ///< 0: no picture has a page, and no file is written
    std::vector<std::string> missing;  ///< pictures without a page in it
    Phrase error;                      ///< why it could not be written; empty: it was written
};

/// Takes outcomes with bound outputs (item.h) as they finish, from any thread, and passes them on in the order of their items.
class PageBinding {
public:
    using Next = std::function<void(std::size_t index, const Outcome& outcome)>;

    /// Throws Error(failed) if a file has no folder. `ahead`: the number of outcomes that may wait for an earlier one; a thread
    /// that brings a later one blocks, so that memory is bounded. All three must outlive it.
    PageBinding(std::span<const Item> items, const Wishes& wishes, std::size_t ahead, WriteGate* gate = nullptr);

    bool any() const { return !files_.empty(); }
    /// Calls `next` for this outcome, and for those that waited for it. An outcome whose pages do not fit the others is passed on
    /// with an error. `made` then says at which page each begins.
    void take(std::size_t index, Outcome& outcome, const Next& next);
    /// Writes the files, each whole or not at all, after the last outcome. A batch that was up to date has none.
    std::vector<BoundFile> write();

private:
    struct File {
        Output output;
        std::size_t at = 0;  // index of an item's output
        std::unique_ptr<PageBook> book;
        std::size_t pages = 0;
        Point size{};  // of the first page, mm
    };
    void bind(Outcome& outcome);
    void check_sizes(const Outcome& outcome) const;

    const std::span<const Item> items_;
    const Wishes& wishes_;
    const std::size_t ahead_;
    WriteGate* const gate_;
    std::mutex mutex_;
    std::condition_variable moved_;
    std::map<std::size_t, Outcome> waiting_;
    std::size_t next_ = 0;
    bool up_to_date_ = false;
    std::vector<File> files_;
    std::vector<std::string> missing_;
};

}  // namespace tactics
