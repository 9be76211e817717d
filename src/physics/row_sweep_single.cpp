#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "physics/row_sweep_single.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "physics/row_sweep-inl.hpp"
#include "physics/row_sweep.hpp"

HWY_BEFORE_NAMESPACE();
namespace cracksim::physics::HWY_NAMESPACE {

void SweepSingle(SweepView<float>& v, const RowView& row, Measure measure) { SweepRow(v, row, measure); }
void SweepEntitiesSingle(const SweepView<float>& v, GatheredEntities<float>& entities) { SweepEntities(v, entities); }

}  // namespace cracksim::physics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace cracksim::physics {

HWY_EXPORT(SweepSingle);
HWY_EXPORT(SweepEntitiesSingle);

void sweep_row(SweepView<float>& v, const RowView& row, Measure measure) {
    HWY_DYNAMIC_DISPATCH(SweepSingle)(v, row, measure);
}

void sweep_entities(const SweepView<float>& v, GatheredEntities<float>& entities) {
    HWY_DYNAMIC_DISPATCH(SweepEntitiesSingle)(v, entities);
}

}  // namespace cracksim::physics

#endif
