#include "core/text.hpp"

#include <array>
#include <cmath>
#include <cstdio>

namespace cracksim {

namespace {

template <class... Values>
std::string formatted(const char* format, Values... values) {
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), format, values...);
    return text.data();
}

}  // namespace

std::string hex(std::uint64_t value) { return formatted("%016llx", static_cast<unsigned long long>(value)); }

std::string rounded(double value, int digits) { return formatted("%.*g", digits, value); }

std::string bytes_text(double bytes) {
    if (bytes < 1e6) {
        return formatted("%.0f kB", bytes / 1e3);
    }
    if (bytes < 1e12) {
        return bytes < 1e9 ? formatted("%.0f MB", bytes / 1e6) : formatted("%.1f GB", bytes / 1e9);
    }
    return formatted("%.1f TB", bytes / 1e12);
}

std::string duration_text(double s) {
    if (s < 100) {
        return formatted(s < 9.95 ? "%.1f s" : "%.0f s", s);
    }
    const auto whole = static_cast<long>(std::lround(s));
    return whole < 6000 ? formatted("%ld min %ld s", whole / 60, whole % 60)
                        : formatted("%ld h %ld min", whole / 3600, whole / 60 % 60);
}

}  // namespace cracksim
