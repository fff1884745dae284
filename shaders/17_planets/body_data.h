// Data for the passes that draw a body.
#pragma once
#include <common/shared.h>

#include "common/view_rays.h"

BEGIN_SHARED

// Laws of reflection, as the knob `law` names them after `own`.
const int LAW_LAMBERT = 1, LAW_WRAPPED = 2, LAW_LOMMEL_SEELIGER = 3, LAW_MINNAERT = 4, LAW_HAPKE = 5;

// A body's surface.
struct SurfaceLaw {
    int law;
    float wrap, wrap_power;  // of LAW_WRAPPED
    float minnaert;          // exponent k of LAW_MINNAERT
    vec3 terminator;         // colour of the light where the sun is low, for clouds; white for rock
    vec3 tint;               // factor for the map's colours
    float relief;            // strength of the map of normals, 0 to 1
    float gloss;             // of ice where the map's alpha is 1; 0: none
    float ice;               // 1: bright grey areas of the map are ice, unaffected by the tint
};

// Rings, seen from the middle of the planet. Their strips run from the inner to the outer edge.
struct Rings {
    float inner, outer;  // radii, metres; outer 0: there are none
    float brightness;    // exposure over that of the planet
};

// A body in the picture. Camera: at the origin. Lengths in metres. "Round" space is the body's own axes, stretched along its
// axis of rotation by 1 / (1 - flattening): there it is a sphere.
struct BodyNow {
    ViewRays rays;
    vec3 center;   // from the camera, world axes
    float radius;  // at its equator
    mat3 to_body;  // from world axes to the body's: +y its north pole, +z its prime meridian
    float flattening;
    vec3 to_sun;    // unit length, world axes
    float sun_rad;  // half the angle that the sun's disc fills there
    vec3 sunlight;  // radiance of a white Lambertian surface that faces the sun
    float reach;    // radius of all that belongs to it, air and rings too
    SurfaceLaw surface;
    Rings rings;
    vec3 other;          // a body that may stand before the sun: from this one's centre, world axes
    float other_radius;  // 0: there is none
    float cloud_turn;    // of the cloud map against the ground, in turns to the west
    float flow_days;     // since the map of moving clouds was photographed
    float flow_period;   // days between two of its frames
    float moment;        // of the Sun's granules, in cells of time
    ivec2 corner;        // the first pixel of the dispatch
};

END_SHARED
