#version 330 core
// A ribbon of constant width on the screen along a curve in the model's space. Each point comes twice, side -1 and +1.
in vec3 vertexPosition;
in vec3 vertexNext; // the next point of the curve
in float vertexSide;

uniform mat4 mvp;
uniform vec2 viewport; // pixels
uniform float halfWidth; // pixels

out float side;

void main()
{
    vec4 here = mvp * vec4(vertexPosition, 1.0);
    vec4 next = mvp * vec4(vertexNext, 1.0);
    vec2 along = (next.xy / next.w - here.xy / here.w) * viewport;
    vec2 across = length(along) > 1e-6 ? normalize(vec2(-along.y, along.x)) : vec2(0.0);
    here.xy += across * vertexSide * halfWidth * 2.0 / viewport * here.w;
    side = vertexSide;
    gl_Position = here;
}
