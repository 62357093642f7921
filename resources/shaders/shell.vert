#version 330 core
// A ball in the room.
in vec3 vertexPosition; // on the unit sphere

uniform mat4 view;       // room to eye space
uniform mat4 projection;
uniform vec3 center;
uniform float radius;

out vec3 eyeNormal;
out vec3 toEye;

void main()
{
    vec4 eye = view * vec4(center + radius * vertexPosition, 1.0);
    eyeNormal = mat3(view) * vertexPosition;
    toEye = -eye.xyz;
    gl_Position = projection * eye;
}
