// Defaults of Maps::variant()'s macros: surfaces without maps.
#ifndef MAPS_PLACED
#define MAPS_PLACED 0
#define MAPS_SECOND_UVS 0
#define MAPS_COLORS 0
#define MAPS_TWO_SIDED 0
#define MAPS_UNLIT 0
#endif
#ifndef SURFACE_GGX
#define SURFACE_GGX 0
#endif
