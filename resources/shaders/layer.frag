#version 330 core
// Lays a picture with premultiplied alpha over what is there.
in vec2 place;

uniform sampler2D picture;

out vec4 fragColor;

void main()
{
    fragColor = texture(picture, place);
}
