#version 330 core
// The clay, for the desktop and for the headset alike. Positions in mm; `normal` need not have unit length.
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 normal; // w: how far it is masked, 0 to 1
layout(location = 2) in vec4 color;  // sRGB; a: curvature, 128/255 where the surface is flat
layout(location = 3) in float weight; // b(x) of the footprint, or 0 outside
layout(location = 4) in float shade;  // of what was measured there, 0 to 1
layout(location = 5) in vec4 edge;    // along the sharp edge through it; w: how sharp it is, 0 to 1

uniform mat4 view;       // mm to eye space, scaled evenly
uniform mat4 projection; // perspective or orthographic
uniform float shaded;    // 1: coloured by the shade, and by no curvature
uniform vec4 ball;         // a spherical brush's footprint: centre, radius; mm
uniform vec4 ballImage;    // and that of its mirror image
uniform float ballFalloff; // n of its b(x); 0: no weighting
uniform float ballCore;    // the part of the radius within which the weight is 1
uniform float sectors;     // about y, in each of which they are
uniform vec2 sector;       // cosine and sine of the angle of one
// A transformation that is shown before it is made; the weights say how far each vertex takes part.
uniform float moved;    // 1: there is one
uniform vec3 moveCentre, moveBy;
uniform vec3 turnAxis;  // unit length
uniform float turnAngle; // radians
uniform mat3 stretch;   // difference from the identity

// Four by four: what a triangle is set up for counts more than its pixels where there are many.
out vec4 placeAndTint;     // eye space; w: b(x) of the footprint
out vec4 normalAndMask;    // eye space, shorter the sharper the edge; w: how far it is masked
out vec4 crease;           // along the sharp edge in eye space, as long as w: how sharp it is
out vec4 albedoAndMeasure; // linear; w: the shade, or the curvature

vec3 toLinear(vec3 c)
{
    return mix(c / 12.92, pow((c + 0.055) / 1.055, vec3(2.4)), step(0.04045, c));
}

// The brush's b(x) in the other sectors; in that of the brush each pixel has its own (clay.frag).
float weightInSectors()
{
    float nearest = max(ball.w * ball.w, 1e-18);
    vec3 turned = position;
    for (float k = 1.0; k < sectors; k += 1.0) {
        turned.xz = vec2(sector.x * turned.x + sector.y * turned.z, sector.x * turned.z - sector.y * turned.x);
        vec3 way = turned - ball.xyz, imageWay = turned - ballImage.xyz;
        nearest = min(nearest, dot(way, way));
        nearest = ballImage.w > 0.0 ? min(nearest, dot(imageWay, imageWay)) : nearest;
    }
    float x = min(sqrt(nearest) / max(ball.w, 1e-9), 1.0);
    float inner = max(x - ballCore, 0.0) / (1.0 - ballCore);
    float n = ballFalloff;
    float b = n == 0.0 ? 1.0 : 1.0 - pow(inner, n - 1.0) * (n - (n - 1.0) * inner);
    return b * min(6.0 - 6.0 * x, 1.0);
}

vec3 turned(vec3 v, float angle)
{
    return mix(turnAxis * dot(turnAxis, v), v, cos(angle)) + sin(angle) * cross(turnAxis, v);
}

// The place with this freedom, its normal and the direction of its sharp edge (core/parts/part_transform.h).
void move(float freedom, inout vec3 place, inout vec3 facing, inout vec3 along)
{
    float angle = freedom * turnAngle;
    mat3 stretched = mat3(1.0) + freedom * stretch;
    place = moveCentre + freedom * moveBy + turned(stretched * (place - moveCentre), angle);
    facing = turned(transpose(inverse(stretched)) * facing, angle);
    along = turned(along, angle);
}

void main()
{
    vec3 place = position, facing = normal.xyz, along = edge.xyz;
    if (moved > 0.0)
        move(weight, place, facing, along);
    vec4 eye = view * vec4(place, 1.0);
    mat3 turn = mat3(view);
    float unit = inversesqrt(dot(view[0].xyz, view[0].xyz));
    float sharp = max(edge.w, 0.0);
    placeAndTint = vec4(eye.xyz, moved > 0.0 ? 0.0 : max(weight, weightInSectors()));
    normalAndMask = vec4(unit * (1.0 - sharp) * (turn * facing), normal.w);
    crease = vec4(unit * sharp * (turn * along), sharp);
    albedoAndMeasure = vec4(toLinear(color.rgb), mix(color.a, shade, shaded));
    gl_Position = projection * eye;
}
