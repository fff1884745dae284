// Light from all around that nothing stands in the way of: for 14_environment/image_light.glsl.
bool light_arrives(vec3 position, vec3 direction) { return true; }
