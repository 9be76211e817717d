#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "physics/lattice/sweep/row_sweep_single.cpp"
#include <hwy/foreach_target.h>

#undef CRACKSIM_REAL
#define CRACKSIM_REAL float
#include "physics/lattice/sweep/row_sweep-inl.hpp"
