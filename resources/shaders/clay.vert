#version 330 core
// The clay, for the desktop and for the headset alike. Positions in mm; `normal` need not have unit length.
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 normal; // w: how far it is masked, 0 to 1
layout(location = 2) in vec4 color; // sRGB
layout(location = 3) in float footprint; // b(x), or 0 outside
layout(location = 4) in float shade; // of what was measured there, 0 to 1

uniform mat4 view;       // mm to eye space
uniform mat4 projection; // perspective or orthographic
uniform vec3 cutNormal;  // of the plane through the origin where a line is drawn
uniform vec4 ball;       // a spherical brush's footprint: centre, radius; mm
uniform vec4 ballImage;  // and that of its mirror image
uniform float ballFalloff; // n of its b(x); 0: no weighting
uniform float sectors;     // about y, in each of which they are

out vec3 toEye; // eye space, any length
out vec3 eyePosition;
out vec3 eyeNormal;
out vec3 albedo; // linear
out float masked; // 0 to 1
out float fromCut; // mm
out float fault; // the shade
out float taken; // by the brush: 0 not, else so much, and seen at its rim, too

vec3 toLinear(vec3 c)
{
    return mix(c / 12.92, pow((c + 0.055) / 1.055, vec3(2.4)), step(0.04045, c));
}

const float atRim = 0.35;

// Turned by so many sectors that it lies in that of the brush.
vec3 inSectorOf(vec3 center)
{
    if (sectors < 1.5 || dot(position.xz, position.xz) == 0.0 || dot(center.xz, center.xz) == 0.0)
        return position;
    float part = 6.28318530718 / sectors;
    float turn = part * round((atan(center.x, center.z) - atan(position.x, position.z)) / part);
    vec2 sideways = mat2(cos(turn), -sin(turn), sin(turn), cos(turn)) * position.xz;
    return vec3(sideways.x, position.y, sideways.y);
}

float share(vec4 brush)
{
    float x = distance(inSectorOf(brush.xyz), brush.xyz) / brush.w;
    float n = ballFalloff;
    float b = n == 0.0 ? 1.0 : (n - 1.0) * pow(x, n) - n * pow(x, n - 1.0) + 1.0;
    return brush.w > 0.0 && x <= 1.0 ? mix(atRim, 1.0, b) : 0.0;
}

void main()
{
    vec4 eye = view * vec4(position, 1.0);
    eyePosition = eye.xyz;
    toEye = mix(-eye.xyz, vec3(0.0, 0.0, 1.0), projection[3][3]);
    eyeNormal = mat3(view) * normal.xyz;
    albedo = toLinear(color.rgb);
    masked = normal.w;
    fault = shade;
    fromCut = dot(cutNormal, position);
    taken = max(max(share(ball), share(ballImage)), footprint > 0.0 ? mix(atRim, 1.0, footprint) : 0.0);
    gl_Position = projection * eye;
}
