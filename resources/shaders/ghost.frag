#version 330 core
// Clearest at its outline; a little shade shows what is round.
in vec3 toEye;
in vec3 eyeNormal;
in float solid;

uniform vec3 color;  // as the target encodes it
uniform vec2 alphas; // where it faces the eye, and where it turns away

out vec4 fragColor;

const vec3 toLight = normalize(vec3(-0.35, 0.80, 0.50)); // eye space

void main()
{
    vec3 n = normalize(eyeNormal);
    float away = 1.0 - abs(dot(n, normalize(toEye)));
    float light = 0.5 + 0.5 * dot(n, toLight);
    fragColor = vec4(color * (0.72 + 0.40 * light), solid * mix(alphas.x, alphas.y, away * away * away));
}
