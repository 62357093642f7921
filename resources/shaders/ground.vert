#version 330 core
// The ground: a square in the plane y = 0 of its own space, put in place by Qt3D.
in vec3 vertexPosition;

uniform mat4 modelMatrix;
uniform mat4 mvp;

out vec3 world;

void main()
{
    world = vec3(modelMatrix * vec4(vertexPosition, 1.0));
    gl_Position = mvp * vec4(vertexPosition, 1.0);
}
