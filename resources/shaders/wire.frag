#version 330 core
// The sides of the triangles, each half a line; where they would run together they fade to an even shade.
noperspective in vec3 fromSides; // pixels
flat in float narrowest;         // pixels

uniform float halfWidth; // pixels

out vec4 fragColor;

void main()
{
    float distance = min(fromSides.x, min(fromSides.y, fromSides.z));
    float cover = clamp(halfWidth + 0.5 - distance, 0.0, 1.0);
    fragColor = vec4(vec3(0.06, 0.07, 0.09), 0.62 * cover * mix(0.25, 1.0, smoothstep(1.5, 7.0, narrowest)));
}
