#version 330 core
// A square in the plane z = 0 of its own space, -1 to 1, put in place by Qt3D.
in vec3 vertexPosition;

uniform mat4 mvp;

out vec2 at;

void main()
{
    at = vertexPosition.xy;
    gl_Position = mvp * vec4(vertexPosition, 1.0);
}
