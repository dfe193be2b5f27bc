// SPDX-License-Identifier: Apache-2.0
#include "tactics/transport/braille_reports.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace tactics {

namespace {

// HID Usage Tables 1.4, page 41h.
constexpr std::uint32_t kDisplay = 0x41'0001, kRow = 0x41'0002, kEightDots = 0x41'0003, kSixDots = 0x41'0004;
constexpr std::uint32_t kBraillePage = 0x41, kButtonPage = 0x09;
// HID 1.11, 6.2.2: type and tag of an item, the size left out.
enum Item : std::uint8_t {
    kInput = 0x80,
    kOutput = 0x90,
    kFeature = 0xB0,
    kCollection = 0xA0,
    kEnd = 0xC0,
    kUsagePage = 0x04,
    kReportSize = 0x74,
    kReportId = 0x84,
    kReportCount = 0x94,
    kPush = 0xA4,
    kPop = 0xB4,
    kUsage = 0x08,
    kUsageLeast = 0x18,
    kUsageMost = 0x28,
};
constexpr std::uint8_t kLongItem = 0xFE;
constexpr std::uint32_t kApplication = 1, kConstant = 1, kVariable = 2;
// As large as the kernel's own limits: 16 kB a report, 4 kB a descriptor. More is no display.
constexpr std::uint64_t kMostBits = 16'384 * 8;
constexpr std::size_t kMostPushed = 16, kMostItems = 4096;

struct Globals {
    std::uint32_t page = 0, size = 0, count = 0;
    int report = 0;
};

struct Field {
    BrailleReports::Line line;
    int columns = 0, dots = 0;
    std::size_t row = 0;  // counted from 1; 0: it is in none
};

// Several in their order. One of four bytes names its page itself; any other is of the page that is set when its main item comes
// (HID 1.11, 6.2.2.8).
struct Usage {
    std::uint32_t value = 0, most = 0;
    bool with_page = false;
};

class Reader {
public:
    explicit Reader(std::span<const std::uint8_t> descriptor) : rest_(descriptor) {}

    // False: it is broken.
    bool read() {
        for (std::size_t items = 0; !rest_.empty(); ++items) {
            const std::uint8_t prefix = rest_[0];
            if (items == kMostItems) return false;
            if (prefix == kLongItem) {
                if (rest_.size() < 2 || rest_.size() < 3u + rest_[1]) return false;
                rest_ = rest_.subspan(3u + rest_[1]);
                continue;
            }
            const std::size_t size = (prefix & 3) == 3 ? 4 : prefix & 3;
            if (rest_.size() < 1 + size) return false;
            std::uint32_t value = 0;
            for (std::size_t i = 0; i < size; ++i) value |= static_cast<std::uint32_t>(rest_[1 + i]) << 8 * i;
            rest_ = rest_.subspan(1 + size);
            if (!take(prefix & 0xFC, value, size)) return false;
        }
        return depth_ == 0;
    }
    std::vector<Field> fields;
    std::map<int, std::uint64_t> bits, sent_bits;  // of every output report, and of every input report
    std::map<int, std::vector<BrailleReports::Bits>> keys;
    bool numbered = false;

private:
    bool take(int item, std::uint32_t value, std::size_t size) {
        switch (item) {
            case kUsagePage: globals_.page = value; break;
            case kReportSize: globals_.size = value; break;
            case kReportCount: globals_.count = value; break;
            case kReportId:
                if (value == 0 || value > 255) return false;
                globals_.report = static_cast<int>(value);
                numbered = true;
                break;
            case kPush:
                if (pushed_.size() == kMostPushed) return false;
                pushed_.push_back(globals_);
                break;
            case kPop:
                if (pushed_.empty()) return false;
                globals_ = pushed_.back();
                pushed_.pop_back();
                break;
            case kUsage:
            case kUsageLeast: usages_.push_back({value, value, size == 4}); break;
            case kUsageMost:
                if (!usages_.empty()) usages_.back().most = value;
                break;
            case kCollection:
                begin_collection(value);
                usages_.clear();
                break;
            case kEnd:
                if (depth_ == 0) return false;
                if (display_ == depth_) display_ = 0;
                if (row_ == depth_) row_ = 0;
                --depth_;
                usages_.clear();
                break;
            case kOutput:
            case kInput: {
                const bool fits = item == kOutput ? take_output(value) : take_input(value);
                usages_.clear();
                return fits;
            }
            case kFeature: usages_.clear(); break;
            default: break;
        }
        return true;
    }

    std::uint32_t whole(const Usage& usage) const { return usage.with_page ? usage.value : globals_.page << 16 | usage.value; }
    bool is_first(std::uint32_t usage) const { return !usages_.empty() && whole(usages_.front()) == usage; }

    void begin_collection(std::uint32_t kind) {
        ++depth_;
        if (display_ == 0 && kind == kApplication && is_first(kDisplay)) display_ = depth_;
        if (display_ != 0 && row_ == 0 && is_first(kRow)) {
            row_ = depth_;
            ++rows_;
        }
    }

    // The position of the item in its report; nothing: it is larger than any report.
    std::optional<std::uint64_t> room_in(std::map<int, std::uint64_t>& reports) {
        const std::uint64_t many = static_cast<std::uint64_t>(globals_.size) * globals_.count;
        std::uint64_t& end = reports[globals_.report];
        const std::uint64_t begin = end;
        if (many > kMostBits || begin + many > kMostBits) return std::nullopt;
        end += many;
        return begin;
    }

    bool take_output(std::uint32_t flags) {
        const auto begin = room_in(bits);
        if (!begin) return false;
        const bool cells = display_ != 0 && (flags & kConstant) == 0 && (is_first(kEightDots) || is_first(kSixDots));
        if (!cells || globals_.size != 8 || globals_.count == 0 || *begin % 8 != 0) return true;
        const Field field{{globals_.report, static_cast<std::size_t>(*begin / 8)},
                          static_cast<int>(globals_.count),
                          is_first(kSixDots) ? 6 : 8,
                          row_ == 0 ? 0 : rows_};
        if (!fields.empty() && goes_on(fields.back(), field))
            fields.back().columns += field.columns;
        else
            fields.push_back(field);
        return true;
    }
    static bool goes_on(const Field& last, const Field& next) {
        return last.row == next.row && last.dots == next.dots && last.line.report == next.line.report &&
               last.line.begin + static_cast<std::size_t>(last.columns) == next.line.begin;
    }

    bool take_input(std::uint32_t flags) {
        const auto begin = room_in(sent_bits);
        if (!begin) return false;
        if (display_ == 0 || globals_.size != 1 || (flags & (kConstant | kVariable)) != kVariable) return true;
        // Bits and usages in their order; the last usage is that of all further bits.
        std::uint64_t at = *begin;
        const std::uint64_t end = at + globals_.count;
        for (std::size_t i = 0; i < usages_.size() && at < end; ++i) {
            const Usage& usage = usages_[i];
            const std::uint64_t count = usage.most > usage.value ? std::uint64_t{usage.most} - usage.value + 1 : 1;
            const std::uint64_t behind = i + 1 == usages_.size() ? end : std::min(end, at + count);
            const std::uint32_t page = whole(usage) >> 16;
            if (page == kBraillePage || page == kButtonPage)
                keys[globals_.report].push_back({static_cast<std::size_t>(at), static_cast<std::size_t>(behind)});
            at = behind;
        }
        return true;
    }

    std::span<const std::uint8_t> rest_;
    Globals globals_;
    std::vector<Globals> pushed_;
    std::vector<Usage> usages_;
    std::size_t depth_ = 0, display_ = 0, row_ = 0;  // collections around, and which of them are the display and the row
    std::size_t rows_ = 0;
};

}  // namespace

BrailleReports braille_reports(std::span<const std::uint8_t> descriptor) {
    BrailleReports reports;
    Reader reader(descriptor);
    if (!reader.read()) return reports;
    std::map<std::pair<int, int>, int> cells;  // of all lines of that width and those dots
    for (const Field& field : reader.fields) cells[{field.columns, field.dots}] += field.columns;
    int most = 0;
    for (const Field& field : reader.fields) {
        if (const int all = cells[{field.columns, field.dots}]; all > most) {
            most = all;
            reports.columns = field.columns;
            reports.dots = field.dots;
        }
    }
    reports.numbered = reader.numbered;
    reports.keys = std::move(reader.keys);
    for (const Field& field : reader.fields) {
        if (field.columns != reports.columns || field.dots != reports.dots) continue;
        reports.lines.push_back(field.line);
        reports.sizes[field.line.report] = static_cast<std::size_t>((reader.bits[field.line.report] + 7) / 8);
    }
    return reports;
}

bool KeyWatch::pressed(std::span<const std::uint8_t> report) {
    const int id = numbered_ && !report.empty() ? report[0] : 0;
    if (numbered_) report = report.subspan(std::min<std::size_t>(1, report.size()));
    const auto found = keys_.find(id);
    if (found == keys_.end()) return false;
    const bool none = down_.empty();
    down_.erase(id);
    for (const BrailleReports::Bits& bits : found->second)
        for (std::size_t bit = bits.begin; bit < std::min(bits.end, 8 * report.size()); ++bit)
            if ((report[bit / 8] >> bit % 8 & 1) != 0) down_.insert(id);
    return none && !down_.empty();
}

}  // namespace tactics
