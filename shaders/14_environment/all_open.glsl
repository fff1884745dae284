// Light from all around that nothing in the picture hides; screen_occlusion.glsl is read instead of it where something does.
