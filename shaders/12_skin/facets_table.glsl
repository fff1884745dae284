// What of the specular terms is in a table, where the knob says so.
#if SKIN_SPECULAR == SKIN_SPECULAR_TABLES
uniform sampler2D skin_facets;  // x: the distribution over n·h along u and m along v, encoded; y: the rise of Schlick's F
#endif
