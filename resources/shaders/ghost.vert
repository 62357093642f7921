#version 330 core
// Translucent shapes: somebody in the headset seen from the desktop, or parts that a preview takes away.
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 normal;
layout(location = 2) in vec4 color;

uniform mat4 place; // its own space to eye space, mm
uniform mat4 projection; // perspective or orthographic

out vec3 toEye; // eye space, any length
out vec3 eyeNormal;
out float solid;

void main()
{
    vec4 eye = place * vec4(position, 1.0);
    toEye = mix(-eye.xyz, vec3(0.0, 0.0, 1.0), projection[3][3]);
    eyeNormal = mat3(place) * normal.xyz;
    solid = color.r;
    gl_Position = projection * eye;
}
