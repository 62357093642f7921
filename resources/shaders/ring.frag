#version 330 core
// A ring, or a disc, or a part of it that begins at the top and runs clockwise.
in vec2 at;

uniform float inner; // the hole's share of the radius; at least a pixel and a half of ring are left
uniform float sweep; // 0 to 1, the whole way around
uniform vec3 color;  // linear
uniform float alpha;

out vec4 fragColor;

const float fullTurn = 6.28318530718;

void main()
{
    float r = length(at);
    float pixel = max(fwidth(r), 1e-6);
    float hole = min(inner, 1.0 - 2.5 * pixel);
    float cover = clamp((1.0 - r) / pixel, 0.0, 1.0);
    if (inner > 0.0)
        cover *= clamp((r - hole) / pixel, 0.0, 1.0);
    float turn = atan(at.x, at.y) / fullTurn;
    turn = turn < 0.0 ? turn + 1.0 : turn;
    fragColor = vec4(color, alpha * cover * (turn <= sweep ? 1.0 : 0.0));
}
