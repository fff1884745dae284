// The Earth's air by each method. Pipelines for the method `tables` have chapter 10's sun_table.glsl instead of sun_closed.glsl.
#include "10_atmosphere/random_paths.glsl"
#include "17_planets/air_shell.glsl"
#include "17_planets/body_inputs.glsl"

// The air on a ray of round space, as air_before() has it. `sun_cosine`: at the ray's point nearest to the centre.
Along earth_air(vec3 from, vec3 direction, vec3 to_sun, float way, float sun_cosine) {
#if ATMOSPHERE_METHOD == ATMOSPHERE_METHOD_TRUTH && !defined(BODY_SMALL)
    Path path = air_path(from, direction, to_sun, way);
    if (path.way <= 0.0) return Along(vec3(0.0), vec3(1.0));
    Along all = in_scatter(32 * planets.air_steps, path);
#if ATMOSPHERE_ORDERS == ATMOSPHERE_ORDERS_MULTIPLE
    start_random(gl_GlobalInvocationID.xy, seed);
    vec3 through = vec3(1.0);
    float squares = 0.0;
    all.light += scattered_often(path, atmosphere.paths, through, squares);
#endif
#else
    Along all = air_before(from, direction, to_sun, way, planets.air_steps);
#if ATMOSPHERE_METHOD != ATMOSPHERE_METHOD_TABLES && ATMOSPHERE_ORDERS == ATMOSPHERE_ORDERS_MULTIPLE
    all.light = with_more_orders(all.light, sun_cosine);
#endif
#endif
    return all;
}
