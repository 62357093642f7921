#version 330 core
// One triangle over the whole view, from no buffer at all.
out vec2 place; // 0..1, origin at the bottom left

void main()
{
    place = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);
    gl_Position = vec4(place * 2.0 - 1.0, 1.0, 1.0);
}
