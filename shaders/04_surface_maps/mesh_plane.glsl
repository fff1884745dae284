// Plane of the mesh in this invocation's pixel, for who compares depths on it.

// Unit length, world space; 0: not known. Normals of vertices, interpolated, are tilted against it.
vec3 mesh_plane = vec3(0.0);
