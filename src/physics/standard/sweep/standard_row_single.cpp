#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "physics/standard/sweep/standard_row_single.cpp"
#include <hwy/foreach_target.h>

#undef CRACKSIM_REAL
#define CRACKSIM_REAL float
#include "physics/standard/sweep/standard_row-inl.hpp"
