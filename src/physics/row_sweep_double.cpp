#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "physics/row_sweep_double.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "physics/row_sweep-inl.hpp"
#include "physics/row_sweep.hpp"

HWY_BEFORE_NAMESPACE();
namespace cracksim::physics::HWY_NAMESPACE {

void SweepDouble(SweepView<double>& v, const RowView& row, Measure measure) { SweepRow(v, row, measure); }
void SweepEntitiesDouble(const SweepView<double>& v, GatheredEntities<double>& entities) { SweepEntities(v, entities); }

}  // namespace cracksim::physics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace cracksim::physics {

HWY_EXPORT(SweepDouble);
HWY_EXPORT(SweepEntitiesDouble);

void sweep_row(SweepView<double>& v, const RowView& row, Measure measure) {
    HWY_DYNAMIC_DISPATCH(SweepDouble)(v, row, measure);
}

void sweep_entities(const SweepView<double>& v, GatheredEntities<double>& entities) {
    HWY_DYNAMIC_DISPATCH(SweepEntitiesDouble)(v, entities);
}

}  // namespace cracksim::physics

#endif
