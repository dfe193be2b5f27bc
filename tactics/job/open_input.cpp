// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/open_input.h"

#include "tactics/error.h"
#include "tactics/job/holds.h"
#include "tactics/readers/svg/pdf.h"

namespace tactics {

namespace {

// As a file that is gone when it is closed.
Source kept(const std::string& bytes, const std::string& name) {
    Source source{name, {std::tmpfile(), &std::fclose}};
    std::FILE* file = source.file.get();
    if (file == nullptr || std::fwrite(bytes.data(), 1, bytes.size(), file) != bytes.size() || std::fflush(file) != 0)
        throw Error(Fault::failed, name, "cannot be kept in a temporary file; make room for it");
    std::rewind(file);
    return source;
}

}  // namespace

Source open_input(const std::string& path, int page, std::vector<std::string>& notes) {
    return page_of_input(open_source(path), path, page, notes);
}

Source page_of_input(Source source, const std::string& path, int page, std::vector<std::string>& notes) {
    if (look_at(source) != Holds::pdf) {
        if (page > 0) throw Error(Fault::usage, spelled("page"), path + " is no PDF; leave it out");
        return source;
    }
    const int pages = pages_of_pdf(source);
    if (page > pages)
        throw Error(Fault::usage, source.name,
                    "there is no page " + std::to_string(page) + ", but pages 1 to " + std::to_string(pages));
    if (page == 0 && pages > 1)
        notes.push_back("this is page 1 of " + std::to_string(pages) + "; " + spelled("page") + " 2 is the next");
    return kept(pdf_page_as_png(source, page == 0 ? 1 : page), source.name);
}

}  // namespace tactics
