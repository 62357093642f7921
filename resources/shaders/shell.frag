#version 330 core
// A translucent shell: hardly seen but where it turns away.
in vec3 eyeNormal;
in vec3 toEye;

uniform vec3 color; // linear
uniform float strength;

out vec4 fragColor;

void main()
{
    float away = 1.0 - abs(dot(normalize(eyeNormal), normalize(toEye)));
    fragColor = vec4(color, strength * (0.03 + 0.62 * away * away * away));
}
