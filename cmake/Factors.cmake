# Where other people's factors are, for the back ends and for the yardsticks.
include_guard()
find_path(CHOLMOD_HEADERS cholmod.h PATH_SUFFIXES suitesparse)
find_library(CHOLMOD_LIBRARY cholmod)
find_path(MUMPS_HEADERS dmumps_c.h)
find_library(MUMPS_LIBRARY dmumps)
mark_as_advanced(CHOLMOD_HEADERS CHOLMOD_LIBRARY MUMPS_HEADERS MUMPS_LIBRARY)
