// Exercise 14.bent_cone: the part of a reflection that the open cone lets through.
// Starter: all of it.

// [bent_cone]
// The open directions above a surface are taken for a cone around the bent normal, with the
// angle `cone_rad` between its axis and its side (0 to pi/2). What the surface reflects comes
// from a cone with the angle `lobe_rad` (above 0, to pi/2). Between the axes of the two lies the
// angle `between_rad`.
//
// Returns the share of the lobe's cone that lies within the open one, by solid angle. The solid
// angle of a cone is 2 pi (1 - cos(angle)).
// - Where one cone lies wholly within the other, the common part is the narrower cone.
// - Where they do not touch, it is 0.
// - In between let it fall from the one to the other as smoothstep does over between_rad.
//
// At most 1, at least 0.
// [/bent_cone]
float lobe_in_cone(float cone_rad, float lobe_rad, float between_rad) {
    return 1.0;
}
