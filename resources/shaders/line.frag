#version 330 core
in float side;
in float alpha;

uniform vec3 color; // linear

out vec4 fragColor;

void main()
{
    fragColor = vec4(color, alpha * (1.0 - smoothstep(0.45, 1.0, abs(side))));
}
