#version 330 core
// A pane that hardly tints what is behind it, with a border of constant width on the screen.
in vec2 at;

uniform vec3 color;   // as the target takes colours
uniform float border; // pixels

out vec4 fragColor;

void main()
{
    vec2 pixels = (1.0 - abs(at)) / max(fwidth(at), 1e-9);
    float line = clamp(border + 0.5 - min(pixels.x, pixels.y), 0.0, 1.0);
    fragColor = vec4(color, mix(0.04, 0.35, line));
}
