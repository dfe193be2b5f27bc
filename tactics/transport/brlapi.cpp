// SPDX-License-Identifier: Apache-2.0
// The braille display of a screen reader, by BrlAPI (BRLTTY's manual, "The BrlAPI C library"). Its library is opened only when it
// is asked for, so that the program runs where it is not installed.
#include "tactics/error.h"
#include "tactics/transport/cell_display.h"
#include "tactics/transport/shared_library.h"

#ifdef TACTICS_BRLAPI

#include <brlapi.h>

#include <vector>

namespace tactics {

namespace {

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

class BrlApi : public CellDisplay {
public:
    explicit BrlApi(const std::string& host) : library_(open_library()) {
        brlapi_connectionSettings_t wish{nullptr, host.empty() ? nullptr : host.c_str()};
        if (library_.open(&wish, nullptr) < 0)
            throw Error(Fault::failed, kPlace,
                        "no screen reader answers (" + library_.why() + "); start BRLTTY, or name where it runs: brlapi:HOST:0");
        unsigned columns = 0, lines = 0;
        if (library_.size(&columns, &lines) < 0) fail("the size of the display is not told");
        if (columns * lines <= 1)
            fail(  // BRLTTY without a display has one cell
                "no braille display is there; plug it in and look whether BRLTTY finds it");
        size_ = {static_cast<int>(columns), static_cast<int>(lines), 8};
        // The console that it is started from, or, where there is none (ssh, cron), whatever is in front.
        if (library_.enter(BRLAPI_TTY_DEFAULT, nullptr) < 0 && library_.enter_path(nullptr, 0, nullptr) < 0)
            fail("the display is not given to this program");
    }
    ~BrlApi() override {
        library_.leave();
        library_.close();
    }
    BrlApi(const BrlApi&) = delete;
    BrlApi& operator=(const BrlApi&) = delete;

    CellDisplaySize size() const override { return size_; }

    void show(std::span<const std::uint8_t> cells) override {
        const std::vector<unsigned char> dots(cells.begin(), cells.end());
        if (library_.write(dots.data()) < 0)
            throw Error(Fault::failed, kPlace,
                        "the display took no picture: " + library_.why() + "; look whether BRLTTY still runs");
    }

    bool key_within(std::chrono::milliseconds time) override {
        brlapi_keyCode_t key = 0;
        const int pressed = library_.read_key(static_cast<int>(time.count()), &key);
        if (pressed < 0)
            throw Error(Fault::failed, kPlace,
                        "the screen reader is gone: " + library_.why() + "; look whether BRLTTY still runs");
        return pressed > 0;
    }

private:
    [[noreturn]] void fail(const std::string& what) {
        const std::string why = library_.why();
        library_.close();
        throw Error(Fault::failed, kPlace, what + " (" + why + ")");
    }
    Library library_;
    CellDisplaySize size_;
};

}  // namespace

std::unique_ptr<CellDisplay> open_brlapi(const std::string& host) { return std::make_unique<BrlApi>(host); }

}  // namespace tactics

#else

namespace tactics {

std::unique_ptr<CellDisplay> open_brlapi(const std::string&) {
    throw Error(Fault::failed, "brlapi", "this program was built without BrlAPI; install libbrlapi-dev and build it again");
}

}  // namespace tactics

#endif
