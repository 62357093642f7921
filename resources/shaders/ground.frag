#version 330 core
// Grid lines one pixel wide at every distance, each tenth one stronger, and a soft shade where the model stands.
// Everything fades before it would shimmer. Lengths in mm, in the headset in m.
in vec3 world;

uniform vec3 eyePosition;      // Qt3D's, world space
uniform mat4 viewMatrix;       // Qt3D's
uniform mat4 projectionMatrix; // Qt3D's, perspective or orthographic
uniform float cell;       // between the finest lines
uniform vec3 center;      // the middle of the grid
uniform float reach;      // where the grid has faded away
uniform vec3 under;       // the ground under the model
uniform vec2 footprint;   // half width and depth of the model's box
uniform vec3 lineColor;   // as the target takes colours
uniform float lineAlpha;
uniform float shade;

out vec4 fragColor;

float lines(vec2 p, float spacing)
{
    vec2 q = p / spacing;
    vec2 width = fwidth(q);
    vec2 d = abs(fract(q - 0.5) - 0.5) / width;
    vec2 cover = clamp(1.0 - d, 0.0, 1.0) * clamp(0.35 / width - 0.5, 0.0, 1.0);
    return max(cover.x, cover.y);
}

void main()
{
    vec2 p = world.xz;
    float away = length(p - center.xz) / reach;
    float fade = pow(clamp(1.0 - away, 0.0, 1.0), 1.5);
    vec3 back = vec3(viewMatrix[0][2], viewMatrix[1][2], viewMatrix[2][2]);
    vec3 toEye = normalize(mix(eyePosition - world, back, projectionMatrix[3][3]));
    fade *= smoothstep(0.02, 0.22, toEye.y); // from below it would hide the model
    float line = max(0.45 * lines(p, cell), lines(p, 10.0 * cell)) * lineAlpha * fade;

    float from = length((p - under.xz) / footprint);
    float shadow = shade * exp(-1.6 * from * from) * smoothstep(0.0, 0.25, toEye.y);

    // The line over the shadow, as one colour with alpha.
    float alpha = line + shadow * (1.0 - line);
    fragColor = vec4(lineColor * line / max(alpha, 1e-4), alpha);
}
