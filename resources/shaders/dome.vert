#version 330 core
// All that lies behind everything else: one triangle over the whole view, from no buffer at all.
uniform mat4 view;       // room to eye space
uniform mat4 projection; // perspective, of any asymmetry

out vec3 direction; // room space, any length

void main()
{
    vec2 at = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2) * 2.0 - 1.0;
    vec3 eye = vec3((at.x + projection[2][0]) / projection[0][0], (at.y + projection[2][1]) / projection[1][1], -1.0);
    direction = transpose(mat3(view)) * eye;
    gl_Position = vec4(at, 1.0, 1.0);
}
