// SPDX-License-Identifier: Apache-2.0
// The braille display of a screen reader, by BrlAPI (BRLTTY's manual, "The BrlAPI C library"). Its library is opened only on
// demand, so that the program runs without it.
#include "tactics/error.h"
#include "tactics/transport/cell_display.h"
#include "tactics/transport/shared_library.h"

namespace tactics {

CellDisplaySize told_size(unsigned columns, unsigned lines) {
    const auto known = [](unsigned count) { return count <= 1'000'000 ? static_cast<int>(count) : 0; };
    return {known(columns), known(lines), 8};
}

}  // namespace tactics

#ifdef TACTICS_BRLAPI

#include <brlapi.h>

#include <future>
#include <thread>
#include <utility>
#include <vector>

namespace tactics {

namespace {

using std::chrono::milliseconds;

const std::string kPlace = "brlapi";

// What is used of it.
struct Library {
    decltype(&brlapi_openConnection) open = nullptr;
    decltype(&brlapi_closeConnection) close = nullptr;
    decltype(&brlapi_getDisplaySize) size = nullptr;
    decltype(&brlapi_enterTtyMode) enter = nullptr;
    decltype(&brlapi_enterTtyModeWithPath) enter_path = nullptr;
    decltype(&brlapi_leaveTtyMode) leave = nullptr;
    decltype(&brlapi_writeDots) write = nullptr;
    decltype(&brlapi_readKeyWithTimeout) read_key = nullptr;
    decltype(&brlapi_strerror) words = nullptr;
    decltype(&brlapi_error_location) fault = nullptr;

    std::string why() const { return words(fault()); }
};

Library open_library() {
    const std::string names[] = {"libbrlapi.so.0.8"};
    const SharedLibrary file(names, kPlace,
                             "the library of BrlAPI is not installed; install libbrlapi0.8, which comes with brltty");
    Library library;
    file.find(library.open, "brlapi_openConnection");
    file.find(library.close, "brlapi_closeConnection");
    file.find(library.size, "brlapi_getDisplaySize");
    file.find(library.enter, "brlapi_enterTtyMode");
    file.find(library.enter_path, "brlapi_enterTtyModeWithPath");
    file.find(library.leave, "brlapi_leaveTtyMode");
    file.find(library.write, "brlapi_writeDots");
    file.find(library.read_key, "brlapi_readKeyWithTimeout");
    file.find(library.words, "brlapi_strerror");
    file.find(library.fault, "brlapi_error_location");
    return library;
}

// The result of a call, and the reason of a failure, which the library keeps per thread.
struct Said {
    int result = 0;
    std::string why;
};

class BrlApi : public CellDisplay {
public:
    BrlApi(const std::string& host, milliseconds patience) : library_(open_library()), patience_(patience) {
        const Said opened = ask([open = library_.open, host] {
            brlapi_connectionSettings_t wish{nullptr, host.empty() ? nullptr : host.c_str()};
            return open(&wish, nullptr);
        });
        if (opened.result < 0)
            throw Error(Fault::failed, kPlace,
                        phrase("no screen reader answers ({0}); start BRLTTY, or name where it runs: brlapi:HOST:0", opened.why));
        const auto told = std::make_shared<std::pair<unsigned, unsigned>>();
        const Said sized = ask([size = library_.size, told] { return size(&told->first, &told->second); });
        if (sized.result < 0) fail(phrase("the size of the display is not told"), sized.why);
        const auto [columns, lines] = *told;
        if (columns <= 1 && lines <= 1)
            fail(  // BRLTTY without a display has one cell
                phrase("no braille display is there; plug it in and look whether BRLTTY finds it"), sized.why);
        size_ = told_size(columns, lines);
        // The console that it is started from, or, where there is none (ssh, cron), whatever is in front.
        const Said given = ask([enter = library_.enter, enter_path = library_.enter_path] {
            const int entered = enter(BRLAPI_TTY_DEFAULT, nullptr);
            return entered < 0 ? enter_path(nullptr, 0, nullptr) : entered;
        });
        if (given.result < 0) fail(phrase("the display is not given to this program"), given.why);
    }
    ~BrlApi() override {
        if (silent_) return;
        try {
            ask([leave = library_.leave] { return leave(); });
            library_.close();
        } catch (const Error&) {  // the connection ends with this program
        }
    }
    BrlApi(const BrlApi&) = delete;
    BrlApi& operator=(const BrlApi&) = delete;

    CellDisplaySize size() const override { return size_; }

    void show(std::span<const std::uint8_t> cells) override {
        const std::vector<unsigned char> dots(cells.begin(), cells.end());
        const Said taken = ask([write = library_.write, dots] { return write(dots.data()); });
        if (taken.result < 0)
            throw Error(Fault::failed, kPlace,
                        phrase("the display took no picture: {0}; look whether BRLTTY still runs", taken.why));
    }

    bool key_within(milliseconds time) override {
        brlapi_keyCode_t key = 0;
        const int pressed = library_.read_key(static_cast<int>(time.count()), &key);
        if (pressed < 0)
            throw Error(Fault::failed, kPlace,
                        phrase("the screen reader is gone: {0}; look whether BRLTTY still runs", library_.why()));
        return pressed > 0;
    }

private:
    // The library waits for its server without limit. A call that does not return stays in its own thread and keeps the library's
    // locks, so the library is not called again.
    template <class Call>
    Said ask(const Call& call) {
        std::packaged_task<Said()> task([call, library = library_] {
            const int result = call();
            return Said{result, result < 0 ? library.why() : ""};
        });
        std::future<Said> answer = task.get_future();
        std::thread(std::move(task)).detach();
        if (answer.wait_for(patience_) == std::future_status::ready) return answer.get();
        silent_ = true;
        throw Error(Fault::failed, kPlace, phrase("the screen reader does not answer; start BRLTTY again"));
    }
    [[noreturn]] void fail(const Phrase& what, const std::string& why) {
        library_.close();
        throw Error(Fault::failed, kPlace, why.empty() ? what : phrase("{0} ({1})", what, why));
    }
    Library library_;
    milliseconds patience_;
    bool silent_ = false;
    CellDisplaySize size_;
};

}  // namespace

std::unique_ptr<CellDisplay> open_brlapi(const std::string& host, milliseconds patience) {
    return std::make_unique<BrlApi>(host, patience);
}

}  // namespace tactics

#else

namespace tactics {

std::unique_ptr<CellDisplay> open_brlapi(const std::string&, std::chrono::milliseconds) {
    throw Error(Fault::failed, "brlapi",
                phrase("this program was built without BrlAPI; install libbrlapi-dev and build it again"));
}

}  // namespace tactics

#endif
