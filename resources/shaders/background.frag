#version 330 core
// A calm gradient from top to bottom, a little lighter behind the model, dithered so that it shows no bands.
in vec2 place;

uniform vec3 topColor; // sRGB
uniform vec3 bottomColor;
uniform float glow; // added behind the model

out vec4 fragColor;

float noise(vec2 p)
{
    return fract(52.9829189 * fract(dot(p, vec2(0.06711056, 0.00583715))));
}

void main()
{
    vec3 color = mix(bottomColor, topColor, smoothstep(0.0, 1.0, place.y));
    vec2 away = place - vec2(0.5, 0.52);
    color += glow * exp(-4.0 * dot(away, away));
    fragColor = vec4(color + (noise(gl_FragCoord.xy) - 0.5) / 255.0, 1.0);
}
