// Only there so that cmake/precompiled.h is compiled.
