#pragma once

#include <cstddef>
#include <optional>
#include <variant>

#include "physics/engine.hpp"
#include "physics/lattice/views.hpp"

namespace cracksim::physics {

/// One sweep over all rows of entities, in ascending order, which adds their forces to the unions. The force on a union
/// is complete after the last row that meets its vertex. View: SweepView or StandardView, whose kernel is
/// sweep_row(view, row, measure).
template <template <class> class View>
class EntitySweep {
public:
    using AnyView = std::variant<View<double>, View<float>>;

    /// Keeps references to what the view points to. Serves one sweep.
    EntitySweep(const Lattice& lattice, const AnyView& view, Measure measure)
        : lattice_{&lattice}, view_{view}, measure_{measure} {}

    /// Adds the forces of the entities of a row.
    void add(std::size_t row) {
        const RowView row_view = view_of(lattice_->cell_rows()[row]);
        std::visit([&](auto& view) { sweep_row(view, row_view, measure_); }, view_);
    }
    [[nodiscard]] Swept add_all() {
        for (std::size_t row = 0; row < lattice_->cell_rows().size(); ++row) {
            add(row);
        }
        return found();
    }
    /// The energies of the owned entities in the rows swept so far.
    [[nodiscard]] Swept found() const {
        const auto found = [&](const auto& view) {
            const bool has_over_step = measure_ == Measure::all && finds_over_step(view);
            return Swept{
                view.dissipated, view.elastic, has_over_step ? std::optional{view.over_step} : std::nullopt, {}};
        };
        return std::visit(found, view_);
    }

private:
    const Lattice* lattice_;
    AnyView view_;
    Measure measure_;
};

}  // namespace cracksim::physics
