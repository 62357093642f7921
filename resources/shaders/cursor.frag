#version 330 core
// Light in the middle, dark at the edges: seen on every ground.
in float side;

uniform float halfWidth;
uniform vec3 color; // sRGB
uniform float alpha;

out vec4 fragColor;

void main()
{
    float pixels = abs(side) * halfWidth;
    float core = clamp(0.42 * halfWidth - pixels + 0.5, 0.0, 1.0);
    float outer = clamp(halfWidth - pixels, 0.0, 1.0);
    fragColor = vec4(color * core, alpha * mix(0.45 * outer, 1.0, core));
}
