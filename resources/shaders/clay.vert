#version 330 core
// The clay, for the desktop and for the headset alike. Positions in mm; `normal` need not have unit length.
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 normal;
layout(location = 2) in vec4 color; // sRGB

uniform mat4 view;       // mm to eye space
uniform mat4 projection; // perspective or orthographic
uniform vec3 cutNormal;  // of the plane through the origin where a line is drawn

out vec3 toEye; // eye space, any length
out vec3 eyePosition;
out vec3 eyeNormal;
out vec3 albedo; // linear
out float fromCut; // mm

vec3 toLinear(vec3 c)
{
    return mix(c / 12.92, pow((c + 0.055) / 1.055, vec3(2.4)), step(0.04045, c));
}

void main()
{
    vec4 eye = view * vec4(position, 1.0);
    eyePosition = eye.xyz;
    toEye = mix(-eye.xyz, vec3(0.0, 0.0, 1.0), projection[3][3]);
    eyeNormal = mat3(view) * normal.xyz;
    albedo = toLinear(color.rgb);
    fromCut = dot(cutNormal, position);
    gl_Position = projection * eye;
}
