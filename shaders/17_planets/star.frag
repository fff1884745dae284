// A star's image: a Gaussian.
layout(location = 0) in vec2 away_px;
layout(location = 1) flat in vec2 star;
layout(location = 0) out vec4 color;

void main() {
    float light = star.x * exp(-dot(away_px, away_px) / (2.0 * star.y * star.y));
    color = vec4(light * vec3(0.95, 0.97, 1.0), 0.0);
}
