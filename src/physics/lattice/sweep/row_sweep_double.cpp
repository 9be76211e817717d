#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "physics/lattice/sweep/row_sweep_double.cpp"
#include <hwy/foreach_target.h>

#undef CRACKSIM_REAL
#define CRACKSIM_REAL double
#include "physics/lattice/sweep/row_sweep-inl.hpp"
