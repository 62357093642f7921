#version 330 core
// Hemisphere of sky and table, a key light over the viewer's left shoulder, a cool rim, a highlight; what the material
// makes of them is in its numbers. All linear; `encodeSrgb` is 1 where the target is not an sRGB image.
// Where a million triangles are hardly larger than a pixel each operation counts: powers and exponentials are few.
in vec4 placeAndTint;
in vec4 normalAndMask;
in vec4 crease;
in vec4 albedoAndMeasure;

uniform mat4 projection;
uniform vec4 ballInEye;    // a spherical brush's footprint: centre, radius; eye space
uniform vec4 imageInEye;   // and that of its mirror image
uniform float ballFalloff; // n of its b(x); 0: no weighting
uniform float ballCore;    // the part of the radius within which the weight is 1
uniform float tinted;      // how strongly the brush's footprint shows, 0 to 1
uniform float cavity;      // how strongly valleys are darkened and ridges lightened, 0 to 1
uniform vec4 cutPlane;     // where a line is drawn; eye space
uniform vec4 cutImage;     // and another one, which has a part in the same cut; or the same

uniform vec3 up;          // eye space, unit length: towards the sky
uniform mat3 lights;      // turns the lights' own axes, which are a desktop viewer's, into eye space
uniform vec3 tint;        // linear; times the vertex's colour
uniform float wrap;       // 0: shadow begins where the light grazes; 1: at the far side
uniform float gloss;      // strength of the highlight
uniform float sharpness;  // its exponent
uniform float rim;        // strength of the rim
uniform vec3 through;     // linear; shines out of the shadow's edge
uniform vec3 sheen;       // linear; where the surface turns away
uniform bool flatShading; // each triangle in one shade
uniform float encodeSrgb;
uniform float cut;       // 1: a line where the planes cut
uniform float cutSide;   // 1: what is on the positive side of either plane is tinted
uniform float cutMarked; // 1: only what has a weight is cut
uniform float shaded;    // 1: coloured by fault in the place of its own colours

out vec4 fragColor;

const vec3 keyDirection = normalize(vec3(-0.45, 0.75, 0.62)); // the lights' axes
const vec3 fillDirection = normalize(vec3(0.85, -0.10, 0.45));
const vec3 keyColor = vec3(1.00, 0.955, 0.88) * 1.12;
const vec3 fillColor = vec3(0.62, 0.74, 0.95) * 0.16;
const vec3 skyColor = vec3(0.74, 0.80, 0.92) * 0.38;
const vec3 tableColor = vec3(0.62, 0.50, 0.42) * 0.20;

// By roots instead of powers, to within a fifth of a level of 255.
vec3 toSrgb(vec3 c)
{
    vec3 r2 = sqrt(c), r4 = sqrt(r2), r8 = sqrt(r4);
    return mix(c * 12.92, 0.662002687 * r2 + 0.684122060 * r4 - 0.323583601 * r8 - 0.0225411470 * c,
               step(0.0031308, c));
}

// Rolls highlights off above 0.8 instead of clipping them.
vec3 soften(vec3 c)
{
    vec3 over = max(c - 0.8, 0.0) / 0.2;
    return min(c, 0.8) + 0.2 - 0.2 / (1.0 + over + 0.5 * over * over);
}

// Light in the middle, dark at the edges: seen on every colour.
vec3 withCut(vec3 color)
{
    vec4 place = vec4(placeAndTint.xyz, 1.0);
    float fromCut = max(dot(cutPlane, place), dot(cutImage, place));
    float isCut = max(1.0 - cutMarked, step(0.5, placeAndTint.w));
    color = mix(color, mix(color, vec3(0.68, 0.045, 0.026), 0.45), cutSide * isCut * step(0.0, fromCut));
    float pixels = abs(fromCut) / max(fwidth(fromCut), 1e-9);
    vec3 edged = mix(color, vec3(0.02), 0.25 * clamp(2.0 - pixels, 0.0, 1.0));
    return mix(color, mix(edged, vec3(0.92, 0.96, 1.0), 0.5 * clamp(1.0 - pixels, 0.0, 1.0)), cut * isCut);
}

// The brush's b(x) at this place, or at its mirror image; 0 outside, with a soft rim where nothing is weighted.
float weightHere()
{
    vec3 way = placeAndTint.xyz - ballInEye.xyz, imageWay = placeAndTint.xyz - imageInEye.xyz;
    float squared = dot(way, way), imageSquared = dot(imageWay, imageWay);
    float x = min(sqrt(imageInEye.w > 0.0 ? min(squared, imageSquared) : squared) / max(ballInEye.w, 1e-9), 1.0);
    float inner = max(x - ballCore, 0.0) / (1.0 - ballCore);
    float n = ballFalloff;
    float b = n == 0.0 ? 1.0 : 1.0 - pow(inner, n - 1.0) * (n - (n - 1.0) * inner);
    return b * min(6.0 - 6.0 * x, 1.0);
}

// A little bluer, on dark clay by a little light: the shades beneath stay as they are.
vec3 withFootprint(vec3 color)
{
    float taken = tinted * max(weightHere() * (1.0 - normalAndMask.w), placeAndTint.w);
    return mix(color, color * vec3(0.76, 0.97, 1.12) + vec3(0.0, 0.012, 0.05), taken);
}

// Valleys darker, ridges lighter.
vec3 withCavity(vec3 color)
{
    float bent = (255.0 * albedoAndMeasure.w - 128.0) / 127.0;
    return color * (1.0 + cavity * (bent < 0.0 ? 0.9 * bent : 0.5 * bent));
}

// What the corners' normals are, as the triangle has them: a smooth corner has its vertex's. One on a sharp edge has
// the triangle's own, but for what lies along the edge: there each of its two sides goes on smoothly.
vec3 surfaceNormal()
{
    vec3 own = cross(dFdx(placeAndTint.xyz), dFdy(placeAndTint.xyz));
    if (flatShading)
        return normalize(own);
    own *= inversesqrt(dot(own, own));
    float along = dot(own, crease.xyz) / max(abs(crease.w), 1e-3);
    return normalize(normalAndMask.xyz + crease.w * own - along * crease.xyz);
}

// Darker, and hatched: to be told from dark paint.
vec3 withMask(vec3 color)
{
    float stripe = smoothstep(0.30, 0.36, abs(fract((gl_FragCoord.x - gl_FragCoord.y) / 9.0) - 0.5));
    vec3 shadow = mix(color, vec3(dot(color, vec3(0.3, 0.6, 0.1))), 0.6) * mix(0.34, 0.20, stripe);
    return mix(color, shadow, normalAndMask.w);
}

// Blue to pale below one half; above, where a limit is broken, yellow to vermilion, and hatched.
vec3 faultColor()
{
    float fault = albedoAndMeasure.w;
    if (fault < 0.5)
        return mix(vec3(0.0, 0.168, 0.445), vec3(0.672, 0.807, 0.855), 2.0 * fault);
    float stripe = smoothstep(0.28, 0.36, abs(fract((gl_FragCoord.x + gl_FragCoord.y) / 10.0) - 0.5));
    return mix(vec3(0.871, 0.776, 0.054), vec3(0.578, 0.045, 0.0), 2.0 * fault - 1.0) * mix(1.0, 0.45, stripe);
}

void main()
{
    vec3 n = surfaceNormal();
    vec3 v = normalize(mix(-placeAndTint.xyz, vec3(0.0, 0.0, 1.0), projection[3][3]));
    vec3 toKey = lights * keyDirection;
    float key = dot(n, toKey);
    float wrapped = max((key + wrap) / (1.0 + wrap), 0.0);
    float fill = max(dot(n, lights * fillDirection), 0.0);
    float sky = 0.5 + 0.5 * dot(n, up);
    vec3 light = keyColor * wrapped * wrapped + fillColor * fill + mix(tableColor, skyColor, sky);

    float facing = max(dot(n, v), 0.0);
    float highlight = pow(max(dot(n, normalize(toKey + v)), 0.0), sharpness) * gloss;
    float away = (1.0 - facing) * (1.0 - facing);
    float edge = away * away * (0.25 + 0.75 * sky) * rim;
    float shadowEdge = 1.0 / (1.0 + 2.25 * key * key); // to the fourth power
    shadowEdge *= shadowEdge;
    shadowEdge *= shadowEdge;
    vec3 color = mix(albedoAndMeasure.rgb * tint, faultColor(), shaded) * light
        + keyColor * highlight * step(0.0, key) + skyColor * edge;
    color += through * shadowEdge + sheen * away * (0.4 + 0.6 * sky);

    color = withCut(withFootprint(withMask(withCavity(soften(color)))));
    fragColor = vec4(mix(color, toSrgb(color), encodeSrgb), 1.0);
}
