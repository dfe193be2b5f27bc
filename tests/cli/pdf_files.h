// SPDX-License-Identifier: Apache-2.0
// Small PDF files written by hand, the harmless and the others.
#pragma once

#include <string>
#include <vector>

namespace tactics::tests {

/// A file of these objects: the first is number 1 and the catalogue, the third what the file says of itself.
inline std::string pdf_of(const std::vector<std::string>& objects) {
    std::string bytes = "%PDF-1.4\n", table;
    for (std::size_t i = 0; i < objects.size(); ++i) {
        std::string at = std::to_string(bytes.size());
        table += std::string(10 - at.size(), '0') + at + " 00000 n \n";
        bytes += std::to_string(i + 1) + " 0 obj\n" + objects[i] + "\nendobj\n";
    }
    const std::string size = std::to_string(objects.size() + 1), begin = std::to_string(bytes.size());
    return bytes + "xref\n0 " + size + "\n0000000000 65535 f \n" + table + "trailer << /Size " + size +
           " /Root 1 0 R /Info 3 0 R >>\nstartxref\n" + begin + "\n%%EOF\n";
}

inline std::string stream_of(const std::string& entries, const std::string& bytes) {
    return "<< " + entries + " /Length " + std::to_string(bytes.size()) + " >>\nstream\n" + bytes + "\nendstream";
}

/// One page, a line across it, and what it says of itself.
inline std::string pdf_that_says(const std::string& info) {
    return pdf_of({"<< /Type /Catalog /Pages 2 0 R >>", "<< /Type /Pages /Kids [4 0 R] /Count 1 >>", "<< " + info + " >>",
                   "<< /Type /Page /Parent 2 0 R /MediaBox [0 0 400 400] /Contents 5 0 R >>",
                   stream_of("", "3 w 80 80 m 320 320 l S")});
}

/// Pages of 400 x 300 points, each with that on it; the font F is Helvetica.
inline std::string pdf_pages(const std::vector<std::string>& contents) {
    std::vector<std::string> objects = {"<< /Type /Catalog /Pages 2 0 R >>", "", "<< >>"};
    std::string kids;
    for (const std::string& content : contents) {
        const std::size_t page = objects.size() + 1;
        kids += std::to_string(page) + " 0 R ";
        objects.push_back("<< /Type /Page /Parent 2 0 R /MediaBox [0 0 400 300] /Contents " + std::to_string(page + 1) +
                          " 0 R /Resources << /Font << /F << /Type /Font /Subtype /Type1 /BaseFont /Helvetica >> >> >> >>");
        objects.push_back(stream_of("", content));
    }
    objects[1] = "<< /Type /Pages /Kids [" + kids + "] /Count " + std::to_string(contents.size()) + " >>";
    return pdf_of(objects);
}
inline std::string pdf_page(const std::string& content) { return pdf_pages({content}); }

/// A page of a form that draws the next one sixteen times, ten times over: 16^10 lines in under 3 kB.
inline std::string pdf_bomb() {
    constexpr int kForms = 10;
    std::vector<std::string> objects = {"<< /Type /Catalog /Pages 2 0 R >>", "<< /Type /Pages /Kids [4 0 R] /Count 1 >>", "<< >>",
                                        "<< /Type /Page /Parent 2 0 R /MediaBox [0 0 400 400] /Contents 5 0 R /Resources << "
                                        "/XObject << /F 6 0 R >> >> >>",
                                        stream_of("", "/F Do")};
    for (int form = 0; form < kForms; ++form) {
        const std::string next = std::to_string(objects.size() + 2);
        std::string draws;
        for (int i = 0; i < 16; ++i) draws += "/F Do ";
        objects.push_back(stream_of(
            "/Type /XObject /Subtype /Form /BBox [0 0 400 400] /Resources << /XObject << /F " + next + " 0 R >> >>", draws));
    }
    objects.push_back(stream_of("/Type /XObject /Subtype /Form /BBox [0 0 400 400]", "0 0 m 400 400 l S"));
    return pdf_of(objects);
}

}  // namespace tactics::tests
