#version 330 core
// A rectangle in the scene, from no buffer at all: a strip of two triangles. Its depth is that of the far plane: all clay is before it.
uniform mat4 clip;
uniform vec3 center;
uniform vec3 halfRight;
uniform vec3 halfUp;

out vec2 place; // 0..1, origin at the image's top left

void main()
{
    place = vec2(gl_VertexID & 1, gl_VertexID >> 1);
    vec2 at = place * 2.0 - 1.0;
    gl_Position = clip * vec4(center + at.x * halfRight - at.y * halfUp, 1.0);
    gl_Position.z = gl_Position.w;
}
