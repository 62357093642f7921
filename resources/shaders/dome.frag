#version 330 core
// A calm room without walls: lightest at the horizon, dithered so that it shows no bands.
in vec3 direction;

uniform vec3 topColor; // sRGB
uniform vec3 horizonColor;
uniform vec3 bottomColor;

out vec4 fragColor; // linear

vec3 toLinear(vec3 c)
{
    return mix(c / 12.92, pow((c + 0.055) / 1.055, vec3(2.4)), step(0.04045, c));
}

float noise(vec2 p)
{
    return fract(52.9829189 * fract(dot(p, vec2(0.06711056, 0.00583715))));
}

void main()
{
    float height = normalize(direction).y;
    vec3 color = mix(horizonColor, height > 0.0 ? topColor : bottomColor, smoothstep(0.0, 0.9, abs(height)));
    fragColor = vec4(toLinear(color + (noise(gl_FragCoord.xy) - 0.5) / 255.0), 1.0);
}
