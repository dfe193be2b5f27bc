// SPDX-License-Identifier: Apache-2.0
#include "tests/haptics/inverse3_server.h"

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <optional>

namespace tactics::tests {

namespace {

constexpr double kMass = 0.1, kDamping = 2;  // kg, N s/m: a handle that nobody holds
constexpr double kHolds = 0.1;               // s without a message until this service lets its device go

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

std::uint32_t turned(std::uint32_t word, int by) { return word << by | word >> (32 - by); }

// FIPS 180-4, SHA-1: what the handshake of RFC 6455 wants.
std::array<std::uint8_t, 20> sha1(std::string text) {
    const std::uint64_t bits = 8 * text.size();
    text += '\x80';
    while (text.size() % 64 != 56) text += '\0';
    for (int i = 7; i >= 0; --i) text += static_cast<char>(bits >> 8 * i);
    std::uint32_t h[5] = {0x67452301, 0xEFCDAB89, 0x98BADCFE, 0x10325476, 0xC3D2E1F0};
    for (std::size_t at = 0; at < text.size(); at += 64) {
        std::uint32_t w[80];
        for (std::size_t i = 0; i < 16; ++i) {
            w[i] = 0;
            for (std::size_t k = 0; k < 4; ++k) w[i] = w[i] << 8 | static_cast<std::uint8_t>(text[at + 4 * i + k]);
        }
        for (std::size_t i = 16; i < 80; ++i) w[i] = turned(w[i - 3] ^ w[i - 8] ^ w[i - 14] ^ w[i - 16], 1);
        std::uint32_t a = h[0], b = h[1], c = h[2], d = h[3], e = h[4];
        for (std::size_t i = 0; i < 80; ++i) {
            const std::uint32_t f = i < 20 ? (b & c) | (~b & d) : i < 40 || i >= 60 ? b ^ c ^ d : (b & c) | (b & d) | (c & d);
            constexpr std::uint32_t kRounds[] = {0x5A827999, 0x6ED9EBA1, 0x8F1BBCDC, 0xCA62C1D6};
            const std::uint32_t next = turned(a, 5) + f + e + kRounds[i / 20] + w[i];
            e = d, d = c, c = turned(b, 30), b = a, a = next;
        }
        h[0] += a, h[1] += b, h[2] += c, h[3] += d, h[4] += e;
    }
    std::array<std::uint8_t, 20> sum{};
    for (std::size_t i = 0; i < 20; ++i) sum[i] = static_cast<std::uint8_t>(h[i / 4] >> (24 - 8 * (i % 4)));
    return sum;
}

std::string base64(const std::array<std::uint8_t, 20>& bytes) {
    constexpr const char* kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < 21; i += 3) {
        std::uint32_t three = 0;
        for (std::size_t k = 0; k < 3; ++k) three = three << 8 | (i + k < bytes.size() ? bytes[i + k] : 0);
        for (int k = 3; k >= 0; --k) text += kLetters[three >> 6 * k & 63];
    }
    text.back() = '=';
    return text;
}

bool send_all(int socket, const std::string& bytes, const std::atomic<bool>& ended) {
    for (std::size_t at = 0; at < bytes.size() && !ended;) {
        pollfd ready{socket, POLLOUT, 0};
        if (poll(&ready, 1, 20) == 0) continue;
        const ssize_t sent = send(socket, bytes.data() + at, bytes.size() - at, MSG_NOSIGNAL | MSG_DONTWAIT);
        if (sent < 0) return false;
        at += static_cast<std::size_t>(sent);
    }
    return true;
}

std::string frame(int opcode, const std::string& text, bool last = true) {
    std::string bytes;
    bytes += static_cast<char>((last ? 0x80 : 0) | opcode);
    const std::size_t size = text.size();
    if (size < 126) {
        bytes += static_cast<char>(size);
    } else {
        const bool wide = size > 0xFFFF;
        bytes += static_cast<char>(wide ? 127 : 126);
        for (int i = wide ? 7 : 1; i >= 0; --i) bytes += static_cast<char>(size >> 8 * i);
    }
    return bytes + text;
}

std::string in_letters(const std::string& text) {
    std::string bytes;
    for (std::size_t i = 0; i < text.size(); ++i) bytes += frame(i == 0 ? 1 : 0, text.substr(i, 1), i + 1 == text.size());
    return bytes;
}

// What comes in from a client: frames that are masked and whole. Nothing: there is none yet.
struct Incoming {
    int opcode = 0;
    std::string text;
};
std::optional<Incoming> next_frame(std::string& bytes) {
    if (bytes.size() < 6) return std::nullopt;
    const auto at = [&](std::size_t i) { return static_cast<std::uint8_t>(bytes[i]); };
    std::size_t size = at(1) & 0x7F, head = 2;
    if (size == 126) size = static_cast<std::size_t>(at(2) << 8 | at(3)), head = 4;
    if (size == 127) return Incoming{-1, ""};  // no client of an Inverse3 has so much to say
    if ((at(1) & 0x80) == 0 || (at(0) & 0x80) == 0) return Incoming{-1, ""};
    if (bytes.size() < head + 4 + size) return std::nullopt;
    Incoming in{at(0) & 0x0F, bytes.substr(head + 4, size)};
    for (std::size_t i = 0; i < size; ++i) in.text[i] = static_cast<char>(in.text[i] ^ bytes[head + i % 4]);
    bytes.erase(0, head + 4 + size);
    return in;
}

// The number behind "name": in a text. By hand, so that the two sides share no reader of JSON.
std::optional<double> number_behind(const std::string& text, const std::string& name, std::size_t from) {
    const std::size_t at = text.find("\"" + name + "\"", from);
    if (at == std::string::npos) return std::nullopt;
    const char* begin = text.c_str() + text.find_first_not_of(" :", at + name.size() + 2);
    char* end = nullptr;
    const double value = std::strtod(begin, &end);
    return end == begin ? std::nullopt : std::optional(value);
}

std::string vector_text(const Point3& value) {
    char text[160];
    std::snprintf(text, sizeof text, R"({"x": %.9g, "y": %.9g, "z": %.9g})", value.x, value.y, value.z);
    return text;
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
        text.replace(at, what.size(), by);
    return text;
}

}  // namespace

Inverse3Server::Inverse3Server(Misbehaviour does, int from) : what(does), after(from) {
    listener_ = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    if (listener_ < 0 || bind(listener_, reinterpret_cast<sockaddr*>(&address), size) != 0 || listen(listener_, 8) != 0 ||
        getsockname(listener_, reinterpret_cast<sockaddr*>(&address), &size) != 0)
        std::abort();
    port_ = ntohs(address.sin_port);
    thread_ = std::thread([this] { serve(); });
}

Inverse3Server::~Inverse3Server() {
    ended_ = true;
    thread_.join();
    close(listener_);
}

std::vector<Inverse3Server::Heard> Inverse3Server::heard() const {
    const std::lock_guard lock(mutex_);
    return heard_;
}
std::vector<std::string> Inverse3Server::messages() const {
    const std::lock_guard lock(mutex_);
    return messages_;
}
Point3 Inverse3Server::handle() const {
    const std::lock_guard lock(mutex_);
    return place_;
}

void Inverse3Server::serve() {
    while (!ended_) {
        pollfd asked{listener_, POLLIN, 0};
        if (poll(&asked, 1, 10) <= 0) continue;
        const int client = accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
        if (client < 0) continue;
        const int yes = 1;
        setsockopt(client, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
        ++accepted_;
        talk(client);
        {
            const std::lock_guard lock(mutex_);
            force_ = {};  // whose session is over has no force
        }
        if (what == Misbehaviour::vanishes) {
            const linger hard{1, 0};
            setsockopt(client, SOL_SOCKET, SO_LINGER, &hard, sizeof hard);
        }
        close(client);
    }
}

void Inverse3Server::talk(int client) {
    std::string bytes;
    bool greeted = false;
    int number = 0;
    while (!ended_) {
        if (greeted && what == Misbehaviour::deaf && number >= after) {
            std::this_thread::sleep_for(std::chrono::milliseconds{5});
            continue;
        }
        pollfd told{client, POLLIN, 0};
        if (poll(&told, 1, 10) == 0) continue;
        char piece[4096];
        const ssize_t got = recv(client, piece, sizeof piece, 0);
        if (got <= 0) return;
        bytes.append(piece, static_cast<std::size_t>(got));
        if (!greeted) {
            const std::size_t end = bytes.find("\r\n\r\n"), key = bytes.find("Sec-WebSocket-Key: ");
            if (end == std::string::npos) continue;
            if (what == Misbehaviour::no_web_socket)
                send_all(client, "HTTP/1.1 404 Not Found\r\nContent-Length: 0\r\n\r\n", ended_);
            if (what == Misbehaviour::not_even_http) send_all(client, "220 mail.example ESMTP\r\n", ended_);
            if (what == Misbehaviour::no_web_socket || what == Misbehaviour::not_even_http || key == std::string::npos) return;
            const std::string asked = bytes.substr(key + 19, bytes.find("\r\n", key) - key - 19);
            const std::string answered = base64(sha1(asked + "258EAFA5-E914-47DA-95CA-C5AB0DC85B11"));
            bytes.erase(0, end + 4);
            greeted = true;
            if (!send_all(client,
                          "HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
                          "Sec-WebSocket-Accept: " +
                              answered + "\r\n\r\n",
                          ended_) ||
                !answer(client, -1))
                return;
        }
        while (const auto in = next_frame(bytes)) {
            if (in->opcode == 10) ++pongs_;
            if (in->opcode == 8) {
                ++farewells_;
                send_all(client, frame(8, in->text), ended_);
            }
            if (in->opcode == 9) send_all(client, frame(10, in->text), ended_);
            if (in->opcode == 8 || in->opcode < 0) return;
            if (in->opcode != 1 && in->opcode != 2) continue;  // clients that say JSON in binary frames are about
            take(in->text, number);
            if (!answer(client, number)) return;
            ++number;
        }
    }
}

// A device is told a force by its id and by nothing else.
bool Inverse3Server::take(const std::string& message, int number) {
    const std::lock_guard lock(mutex_);
    if (number == 0) messages_.push_back(message);
    const std::size_t command = message.find("\"set_cursor_force\""), id = message.find("\"049D\"");
    if (command == std::string::npos || id == std::string::npos || id > command) return ++bad_, false;
    const std::size_t values = message.find("\"values\"", command);
    const auto x = number_behind(message, "x", values), y = number_behind(message, "y", values),
               z = number_behind(message, "z", values);
    if (!x || !y || !z) return ++bad_, false;
    move();
    force_ = {*x, *y, *z};
    heard_.push_back({now(), force_, accepted_});
    return true;
}

// The handle, up to now, by the force of the message before.
void Inverse3Server::move() {
    const double time = now(), passed = moved_ > 0 ? std::min(time - moved_, kHolds) : 0;
    moved_ = time;
    constexpr double kStep = 1e-4;
    for (double t = 0; t < passed && !held; t += kStep) {
        velocity_ = velocity_ + (kStep / kMass) * (force_ - kDamping * velocity_);
        place_ = place_ + kStep * velocity_;
    }
}

std::string Inverse3Server::state(bool inventory) {
    const std::lock_guard lock(mutex_);
    std::string list;
    const char* ids[] = {"049D", "04BA"};
    for (int i = 0; i < devices; ++i) {
        list += std::string(list.empty() ? "" : ", ") + R"({"device_id": ")" + ids[i] + R"(", )";
        if (inventory)
            list +=
                R"("config": {"type": "inverse3", "port": "/dev/ttyACM0", "device_info": {"major_version": 7, "minor_version": 4, )"
                R"("id": "049D", "device_type": 4}, "handedness": "right", "preset": "defaults", "basis": {"permutation": "XYZ"}}, )";
        list +=
            R"("state": {"angular_position": {"a0": -69.3, "a1": 137.6, "a2": 19.8}, "body_orientation": {"w": 1.0, "x": 0.0, )"
            R"("y": 0.0, "z": 0.0}, "cursor_position": )" +
            vector_text(place_) + R"(, "cursor_velocity": )" + vector_text(velocity_) + R"(, "current_cursor_force": )" +
            vector_text(force_) + R"(, "control_domain": "cartesian", "control_mode": "idle"}, "status": {"calibrated": )" +
            (calibrated ? "true" : "false") + R"(, "in_use": true, "power_supply": true, "ready": )" +
            (ready ? "true" : "false") + R"(, "started": true}})";
    }
    return std::string(R"({"session_id": 7, "inverse3": [)") + list +
           R"(], "wireless_verse_grip": [{"device_id": "61548", "state": {"orientation": {"w": 1, "x": 0, "y": 0, "z": 0}, )"
           R"("hall": 0, "battery_level": 0.9, "buttons": {"a": false, "b": )" +
           (button ? "true" : "false") + R"(, "c": false}}, "status": {"connected": true}}]})";
}

std::string Inverse3Server::wrong(int number, const std::string& right) {
    const std::string place = R"("cursor_position": {"x": )";
    const auto with_x = [&](const std::string& x) { return replaced(right, place, place + x + R"(, "x_true": )"); };
    switch (what.load()) {
        case Misbehaviour::not_json: return "the service is being updated";
        case Misbehaviour::half_json: return right.substr(0, right.size() / 2);
        case Misbehaviour::not_a_number: return with_x("NaN");
        case Misbehaviour::huge: return with_x(number % 2 == 0 ? "1e300" : "1e999");
        case Misbehaviour::far: return with_x("40");
        case Misbehaviour::no_place: return replaced(right, "cursor_position", "cursor_place");
        case Misbehaviour::a_text_for_x: return with_x(R"("0.1")");
        case Misbehaviour::another_id: return replaced(right, "049D", "0000");
        case Misbehaviour::no_device: return R"({"inverse3": []})";
        case Misbehaviour::deep: return R"({"inverse3": )" + std::string(100'000, '[') + std::string(100'000, ']') + "}";
        case Misbehaviour::ten_megabytes: return right + std::string(10u << 20, ' ');
        default: return right;
    }
}

// false: the connection is over.
bool Inverse3Server::answer(int client, int number) {
    const bool bad = number >= after;
    const Misbehaviour how = bad ? what.load() : Misbehaviour::none;
    const std::string right = state(number < 0), text = bad ? wrong(number, right) : right;
    switch (how) {
        case Misbehaviour::mute: return true;
        case Misbehaviour::binary: return send_all(client, frame(2, text), ended_);
        case Misbehaviour::fragments: return send_all(client, in_letters(text), ended_);
        case Misbehaviour::pings: return send_all(client, frame(9, "still there?") + frame(1, text), ended_);
        case Misbehaviour::twice: return send_all(client, frame(1, text) + frame(1, text), ended_);
        case Misbehaviour::broken_frame: return send_all(client, frame(3, text), ended_);
        case Misbehaviour::masked_frame: {
            std::string bytes = frame(1, text);
            bytes[1] = static_cast<char>(bytes[1] | 0x80);
            return send_all(client, bytes, ended_);
        }
        case Misbehaviour::closes: send_all(client, frame(8, "\x03\xE8"), ended_); return false;
        case Misbehaviour::vanishes: return false;
        default: return send_all(client, frame(1, text), ended_);
    }
}

}  // namespace tactics::tests
