#include <algorithm>
#include <cmath>
#include <iterator>

#include "support/oracle.hpp"
#include "support/oracle_block.hpp"

namespace cracksim::oracle {

namespace {

/// All duplets of a mass, in the order of the masses at their other ends.
std::vector<Duplet> around(const Scene& scene, std::size_t mass) {
    const Place stride{1, scene.cells[0], scene.cells[0] * scene.cells[1]};
    std::vector<Duplet> found;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t plane = vertex(scene, mass)[axis];
        const std::size_t opposite = across(mass, axis);
        if (plane == 0 || plane == scene.cells[axis]) {
            continue;
        }
        if (corner_place[mass % corners][axis] == 1) {
            found.push_back({mass, opposite + corners * stride[axis], axis});
        } else {
            found.push_back({opposite - corners * stride[axis], mass, axis});
        }
    }
    std::erase_if(found, [&](const Duplet& duplet) { return is_notched(scene, duplet.a, duplet.b); });
    std::ranges::sort(found);
    return found;
}

/// Adds the tree of the masses that meet at a vertex; `first` is the smallest of them.
void grow_tree(const Scene& scene, std::size_t first, std::vector<bool>& visited, std::vector<Duplet>& tree) {
    std::vector<std::size_t> queue{first};
    visited[first] = true;
    for (std::size_t next = 0; next < queue.size(); ++next) {
        const std::size_t mass = queue[next];
        for (const Duplet& duplet : around(scene, mass)) {
            const std::size_t neighbour = duplet.a == mass ? duplet.b : duplet.a;
            if (!visited[neighbour]) {
                visited[neighbour] = true;
                queue.push_back(neighbour);
                tree.push_back(duplet);
            }
        }
    }
}

/// The finalizer of SplitMix64.
std::uint64_t scramble(std::uint64_t v) {
    v += 0x9e3779b97f4a7c15U;
    v = (v ^ (v >> 30U)) * 0xbf58476d1ce4e5b9U;
    v = (v ^ (v >> 27U)) * 0x94d049bb133111ebU;
    return v ^ (v >> 31U);
}

/// (-ln U)^(1/shape) / Gamma(1 + 1/shape); U in (0, 1) is a SplitMix64 hash of the seed and two ids.
double weibull_factor(const Weibull& weibull, std::size_t a, std::size_t b) {
    std::uint64_t key = scramble(weibull.seed);
    key = scramble(key ^ scramble(a));
    key = scramble(key ^ scramble(b));
    const double uniform = std::ldexp(static_cast<double>(key >> 12U) + 0.5, -52);
    return std::pow(-std::log(uniform), 1 / weibull.shape) / std::tgamma(1 + 1 / weibull.shape);
}

}  // namespace

std::vector<Duplet> duplets(const Scene& scene) {
    std::vector<Duplet> found;
    std::vector<bool> visited(mass_count(scene), false);
    for (std::size_t m = 0; m < mass_count(scene); ++m) {
        if (scene.duplets == Duplets::tree && !visited[m]) {
            grow_tree(scene, m, visited, found);
        }
        if (scene.duplets == Duplets::corners) {
            std::ranges::copy_if(around(scene, m), std::back_inserter(found),
                                 [&](const Duplet& d) { return d.a == m; });
        }
    }
    std::ranges::sort(found);
    return found;
}

double threshold(const Scene& scene, const Duplet& duplet) {
    const bool by_face = scene.sensors == Sensors::stress;
    const std::size_t a = by_face ? duplet.a / corners : duplet.a;
    const std::size_t b = by_face ? duplet.b / corners : duplet.b;
    const Vector at = by_face ? plus(centre(scene, a), 0.5, plus(centre(scene, b), -1, centre(scene, a)))
                              : rest_position(scene, duplet.a);
    return (scene.weibull ? weibull_factor(*scene.weibull, a, b) : 1) * scene.threshold(at, 0);
}

}  // namespace cracksim::oracle
