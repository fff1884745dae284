// Solution of 12.chart_step: beside a border there is one step, not two.
vec3 chart_step(vec4 before, vec4 own, vec4 after) {
    bool has_before = before.w == own.w, has_after = after.w == own.w;
    vec3 from = has_before ? before.xyz : own.xyz, to = has_after ? after.xyz : own.xyz;
    return 1000.0 * (to - from) / max(float(has_before) + float(has_after), 1.0);
}
