#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <string>

#include "support/scene_draft.hpp"

namespace cracksim::test {

namespace {

using Components = std::array<std::optional<Formula>, 3>;

constexpr double far = std::numeric_limits<double>::infinity();

std::string quoted_list(const Components& components) {
    std::string text;
    for (const auto& component : components) {
        text += (text.empty() ? "[" : ", ") + (component ? "'" + component->text + "'" : std::string{"null"});
    }
    return text + "]";
}

std::array<oracle::Field, 3> meaning(const Components& components) {
    std::array<oracle::Field, 3> fields;
    for (std::size_t i = 0; i < 3; ++i) {
        fields[i] = components[i] ? components[i]->value : oracle::Field{};
    }
    return fields;
}

/// A linear function along an axis: 0 at a place inside the block, 1 at half the block's length beyond it.
Formula from_inside(SceneDraft& draft, std::size_t axis) {
    const double inside = draft.number(0.2, 0.8) * static_cast<double>(draft.scene.cells[axis]);
    return (coordinate(axis) + constant(-draft.place(axis, inside))) * constant(2 / draft.length(axis));
}

/// Waves along an axis through the block, of amplitude 1.
Formula waves(SceneDraft& draft, std::size_t axis) {
    const Formula distance = from_inside(draft, axis);
    return sin(distance * constant(draft.number(0.5, 4)));
}

/// The speed (m/s) that causes strains of `thresholds` times the typical threshold.
double speed_for(const SceneDraft& draft, double thresholds) {
    return thresholds * draft.typical_threshold * draft.speed();
}

void draw_velocity(SceneDraft& draft, bool supported) {
    Components v;
    for (std::size_t i = 0; i < 3; ++i) {
        const Formula shape = draft.chance(0.75) ? from_inside(draft, i) : waves(draft, draft.whole(0, 2));
        v[i] = draft.chance(0.9) ? constant(speed_for(draft, draft.signed_number(0.5, 4))) * shape : constant(0);
    }
    if (!supported && draft.option(0.3, "drift", "no drift")) {
        // The whole block drifts more than a hundred edges away from its rest position.
        const std::size_t axis = draft.whole(0, 2);
        v[axis] = *v[axis] + constant(draft.signed_number(1.5, 3) * draft.speed());
    }
    draft.scene.velocity = meaning(v);
    draft.text << "  velocity: " << quoted_list(v) << '\n';
}

/// Waves whose largest strain is about a threshold.
void draw_displacement(SceneDraft& draft) {
    Components u;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t axis = draft.whole(0, 2);
        const double size = draft.number(0.4, 1.5) * draft.typical_threshold * draft.length(axis) / 8;
        u[i] = constant(size) * waves(draft, axis);
    }
    draft.scene.displacement = meaning(u);
    draft.text << "  displacement: " << quoted_list(u) << '\n';
}

/// The velocity of a support that strains `length` (m) by a few thresholds until the end.
Formula draw_pull(SceneDraft& draft, double length) {
    if (draft.option(0.25, "support at rest", "moving support")) {
        return constant(0);
    }
    const double duration = static_cast<double>(draft.scene.steps) * draft.scene.step;
    const double way = draft.signed_number(2, 6) * draft.typical_threshold * length;
    const Formula speed = constant(way / duration);
    if (!draft.option(0.5, "support by expression", "uniform support")) {
        return speed;
    }
    const Formula frequency = constant(draft.number(0.02, 0.3) * draft.speed() / draft.scene.edge[0]);
    const Formula swing = sin(frequency * time() + constant(draft.number(0, 3)));
    return draft.chance(0.5) ? speed * swing : speed * (constant(1) + swing * from_inside(draft, draft.whole(0, 2)));
}

Components draw_pulls(SceneDraft& draft, double length) {
    Components v;
    for (std::size_t i = 0; i < 3; ++i) {
        if (draft.option(0.6, "held component", "free component")) {
            v[i] = draw_pull(draft, length);
        }
    }
    if (!v[0] && !v[1] && !v[2]) {
        v[draft.whole(0, 2)] = draw_pull(draft, length);
    }
    return v;
}

std::string box_text(const oracle::Support& support) {
    const auto corner = [](const oracle::Vector& at) {
        std::string text;
        for (const double x : at) {
            text += (text.empty() ? "[" : ", ") + (x == far ? ".inf" : x == -far ? "-.inf" : number_text(x));
        }
        return text + "]";
    };
    return "[" + corner(support.lower) + ", " + corner(support.upper) + "]";
}

void add_support(SceneDraft& draft, oracle::Support support, const Components& velocity) {
    support.velocity = meaning(velocity);
    draft.text << "  - {name: support " << draft.scene.supports.size() << ", where: {box: " << box_text(support)
               << "}, velocity: " << quoted_list(velocity) << "}\n";
    draft.scene.supports.push_back(support);
}

/// Holds the masses of one side of the block, or of half of that side.
void add_side(SceneDraft& draft, std::size_t axis, bool upper, const Components& velocity) {
    oracle::Support side{{-far, -far, -far}, {far, far, far}, {}};
    const auto cells = static_cast<double>(draft.scene.cells[axis]);
    (upper ? side.lower : side.upper)[axis] = draft.place(axis, upper ? cells - 0.5 : 0.5);
    const std::size_t next = (axis + 1) % 3;
    if (draft.option(0.35, "support of half a side", "support of a side")) {
        side.upper[next] = draft.place(next, std::floor(0.5 * static_cast<double>(draft.scene.cells[next])) + 0.5);
    }
    add_support(draft, side, velocity);
}

/// Holds all masses in the components that the first support leaves free.
void add_rails(SceneDraft& draft, const Components& taken) {
    const double length = std::min({draft.length(0), draft.length(1), draft.length(2)});
    Components rails;
    for (std::size_t i = 0; i < 3; ++i) {
        rails[i] = taken[i] ? std::optional<Formula>{} : draw_pull(draft, length);
    }
    if (rails[0] || rails[1] || rails[2]) {
        draft.options.insert("overlapping supports");
        add_support(draft, {{-far, -far, -far}, {far, far, far}, {}}, rails);
    }
}

void draw_supports(SceneDraft& draft) {
    const std::size_t axis = draft.whole(0, 2);
    const Components first = draw_pulls(draft, draft.length(axis));
    draft.text << "supports:\n";
    add_side(draft, axis, false, first);
    if (draft.option(0.4, "supports of both sides", "support of one side")) {
        add_side(draft, axis, true, draw_pulls(draft, draft.length(axis)));
    } else if (draft.chance(0.7)) {
        add_rails(draft, first);
    }
}

}  // namespace

void draw_loads(SceneDraft& draft) {
    const Formula zero = constant(0);
    draft.scene.velocity = draft.scene.displacement = {zero.value, zero.value, zero.value};
    const bool supported = draft.option(0.6, "supports", "no supports");
    const bool moves = draft.option(0.85, "initial velocity", "at rest") || !supported;
    const bool deformed = draft.option(0.4, "initial displacement", "undeformed");
    if (moves || deformed) {
        draft.text << "initial:\n";
    }
    if (moves) {
        draw_velocity(draft, supported);
    }
    if (deformed) {
        draw_displacement(draft);
    }
    if (supported) {
        draw_supports(draft);
    }
}

}  // namespace cracksim::test
