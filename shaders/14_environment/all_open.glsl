// Light from all around that nothing in the picture hides; screen_occlusion.glsl is read in place of it where something does.
