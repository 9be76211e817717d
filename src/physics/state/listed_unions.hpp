#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "physics/state/unions.hpp"

namespace cracksim::physics {

/// The unions of a list of masses, each once, in the order of their first masses in the list. Two ranks that keep the
/// same list of masses and exchange changed part numbers have the same list of unions.
class ListedUnions {
public:
    struct Entry {
        LocalUnion local_union;
        std::uint32_t first;  ///< place of the first mass in the list
    };
    struct NewPart {
        std::uint32_t place;  ///< place of a mass in the list
        std::uint8_t part;
    };

    /// The largest memory per mass of the list.
    static constexpr std::size_t bytes_per_mass =
        sizeof(LocalMass) + sizeof(VertexSite) + sizeof(std::uint8_t) + sizeof(std::uint32_t) + sizeof(Entry);

    ListedUnions(const Unions& unions, std::vector<LocalMass> masses);

    [[nodiscard]] std::span<const LocalMass> masses() const { return masses_; }
    [[nodiscard]] std::span<const Entry> entries() const { return entries_; }
    /// A hash of the part numbers of all masses in the list, to detect that two ranks have different parts for the same
    /// masses. It has 53 bits, so a double represents it exactly.
    [[nodiscard]] std::uint64_t fingerprint() const { return fingerprint_; }
    /// Takes the current part numbers. Returns the masses whose part number has changed since the last call, ascending.
    [[nodiscard]] std::vector<NewPart> update(const Unions& unions);

private:
    static constexpr std::uint32_t none = ~std::uint32_t{0};

    void find_entries();
    /// True if a mass before this one in the list is in the same union.
    [[nodiscard]] bool is_listed_before(std::size_t place) const;

    std::vector<LocalMass> masses_;
    std::vector<VertexSite> vertex_;
    std::vector<std::uint8_t> part_;
    std::vector<std::uint32_t> before_;  ///< the previous mass in the list at the same vertex, or `none`
    std::vector<Entry> entries_;
    std::uint64_t fingerprint_{0};
};

}  // namespace cracksim::physics
