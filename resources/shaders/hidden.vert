#version 330 core
// Places what a lens hides as near as can be, so that nothing is drawn behind it.
uniform mat4 projection;

in vec2 vertexPosition; // eye space, at z = -1

void main()
{
    gl_Position = projection * vec4(vertexPosition, -1.0, 1.0);
    gl_Position.z = -gl_Position.w;
}
