#version 330 core
// A rectangle in the room, from no buffer at all: a strip of two triangles.
uniform mat4 clip; // room to clip space
uniform vec3 center;
uniform vec3 halfX;
uniform vec3 halfY;

out vec2 at;    // -1 to 1
out vec3 world; // room space

void main()
{
    at = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
    world = center + at.x * halfX + at.y * halfY;
    gl_Position = clip * vec4(world, 1.0);
}
