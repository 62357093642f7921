#version 330 core
// Tells each pixel of a triangle how far it is from the triangle's sides. After clay.vert.
layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;

uniform vec2 viewport; // pixels

noperspective out vec3 fromSides; // pixels
flat out float narrowest;         // pixels; the triangle's least height

vec2 cross2(vec2 v)
{
    return vec2(-v.y, v.x);
}

void main()
{
    // A triangle that reaches behind the eye has no sides on the screen to measure from.
    if (min(gl_in[0].gl_Position.w, min(gl_in[1].gl_Position.w, gl_in[2].gl_Position.w)) <= 0.0)
        return;
    vec2 p[3];
    for (int i = 0; i < 3; ++i)
        p[i] = 0.5 * viewport * gl_in[i].gl_Position.xy / gl_in[i].gl_Position.w;
    float doubleArea = dot(cross2(p[1] - p[0]), p[2] - p[0]);
    if (doubleArea <= 1e-6)
        return;
    vec3 sides = vec3(length(p[2] - p[1]), length(p[0] - p[2]), length(p[1] - p[0]));
    vec3 heights = doubleArea / sides;
    narrowest = min(heights.x, min(heights.y, heights.z));
    for (int i = 0; i < 3; ++i) {
        fromSides = vec3(0.0);
        fromSides[i] = heights[i];
        gl_Position = gl_in[i].gl_Position;
        EmitVertex();
    }
}
