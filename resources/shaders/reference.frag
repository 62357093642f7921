#version 330 core
// A picture with premultiplied alpha, fainter than it is.
in vec2 place;

uniform sampler2D picture;
uniform float opacity;

out vec4 fragColor;

void main()
{
    fragColor = texture(picture, place) * opacity;
}
