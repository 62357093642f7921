#version 330 core
// Where equal sectors meet: lines of constant width on the screen from the middle of a square (plane.vert), the first along its x axis.
// They fade towards the rim.
in vec2 at;

uniform vec3 color;    // as the target takes colours
uniform float border;  // pixels, half a line's width
uniform float sectors; // how many

out vec4 fragColor;

void main()
{
    float part = radians(360.0) / sectors;
    float nearest = part * round(atan(at.y, at.x) / part);
    vec2 across = vec2(-sin(nearest), cos(nearest)); // another one in the next sector: fwidth would see that as a line
    float pixel = abs(dot(dFdx(at), across)) + abs(dot(dFdy(at), across));
    float line = clamp(border + 0.5 - abs(dot(at, across)) / max(pixel, 1e-9), 0.0, 1.0);
    fragColor = vec4(color, 0.6 * line * (1.0 - smoothstep(0.7, 1.0, length(at))));
}
