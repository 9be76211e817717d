#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "physics/standard/sweep/standard_row_double.cpp"
#include <hwy/foreach_target.h>

#undef CRACKSIM_REAL
#define CRACKSIM_REAL double
#include "physics/standard/sweep/standard_row-inl.hpp"
