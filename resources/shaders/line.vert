#version 330 core
// A ribbon between two points that faces the eye, from no buffer at all: a strip of two triangles. Never thinner than it can be shown.
uniform mat4 view;       // room to eye space
uniform mat4 projection;
uniform vec3 from;
uniform vec3 to;
uniform float halfWidth;  // m
uniform float pixel;      // what a pixel covers at a distance of 1 m, m
uniform vec2 alphas;      // at both ends

out float side;
out float alpha;

const float minPixels = 0.9;

void main()
{
    vec3 a = (view * vec4(from, 1.0)).xyz;
    vec3 b = (view * vec4(to, 1.0)).xyz;
    bool isFirst = gl_VertexID < 2;
    vec3 here = isFirst ? a : b;
    vec3 across = cross(b - a, here);
    across = length(across) > 1e-9 ? normalize(across) : vec3(0.0);
    side = (gl_VertexID & 1) == 0 ? -1.0 : 1.0;
    alpha = isFirst ? alphas.x : alphas.y;
    gl_Position = projection * vec4(here + across * side * max(halfWidth, minPixels * pixel * length(here)), 1.0);
}
