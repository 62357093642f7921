#version 330 core
// A picture with premultiplied alpha, as it would be seen on a screen. Its back is a dark plate.
in vec2 at;

uniform sampler2D picture; // sRGB, its first line the topmost
uniform float opacity;

out vec4 fragColor; // linear

vec3 toLinear(vec3 c)
{
    return mix(c / 12.92, pow((c + 0.055) / 1.055, vec3(2.4)), step(0.04045, c));
}

void main()
{
    vec4 seen = texture(picture, vec2(0.5 + 0.5 * at.x, 0.5 - 0.5 * at.y));
    if (seen.a < 0.004)
        discard;
    vec3 color = gl_FrontFacing ? toLinear(min(seen.rgb / seen.a, 1.0)) : vec3(0.012);
    fragColor = vec4(color, seen.a * opacity);
}
