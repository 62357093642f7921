#version 330 core
// Hemisphere of sky and table, a key light over the viewer's left shoulder, a cool rim, a highlight; what the material
// makes of them is in its numbers. All linear; `encodeSrgb` is 1 where the target is not an sRGB image.
in vec3 toEye;
in vec3 eyePosition;
in vec3 eyeNormal;
in vec3 albedo;
in float fromCut;
in float taken;
in float fault;
in float masked;

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
uniform float cut;       // 1: a line where fromCut is 0
uniform float shaded;    // 1: coloured by fault in the place of its own colours

out vec4 fragColor;

const vec3 keyDirection = normalize(vec3(-0.45, 0.75, 0.62)); // the lights' axes
const vec3 fillDirection = normalize(vec3(0.85, -0.10, 0.45));
const vec3 keyColor = vec3(1.00, 0.955, 0.88) * 1.12;
const vec3 fillColor = vec3(0.62, 0.74, 0.95) * 0.16;
const vec3 skyColor = vec3(0.74, 0.80, 0.92) * 0.38;
const vec3 tableColor = vec3(0.62, 0.50, 0.42) * 0.20;

vec3 toSrgb(vec3 c)
{
    return mix(c * 12.92, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c));
}

// Rolls highlights off above 0.8 instead of clipping them.
vec3 soften(vec3 c)
{
    vec3 over = max(c - 0.8, 0.0);
    return min(c, 0.8) + 0.2 * (1.0 - exp(-over / 0.2));
}

// Light in the middle, dark at the edges: seen on every colour.
vec3 withCut(vec3 color)
{
    float pixels = abs(fromCut) / max(fwidth(fromCut), 1e-9);
    vec3 edged = mix(color, vec3(0.02), 0.45 * clamp(2.4 - pixels, 0.0, 1.0));
    return mix(color, mix(edged, vec3(0.92, 0.96, 1.0), 0.85 * clamp(1.3 - pixels, 0.0, 1.0)), cut);
}

// Lighter, and a little blue: seen on white clay, too.
vec3 withFootprint(vec3 color)
{
    return mix(color, vec3(0.42, 0.72, 1.0), 0.26 * taken);
}

// Darker, and hatched: to be told from dark paint.
vec3 withMask(vec3 color)
{
    float stripe = smoothstep(0.30, 0.36, abs(fract((gl_FragCoord.x - gl_FragCoord.y) / 9.0) - 0.5));
    vec3 shadow = mix(color, vec3(dot(color, vec3(0.3, 0.6, 0.1))), 0.6) * mix(0.34, 0.20, stripe);
    return mix(color, shadow, masked);
}

// Blue to pale below one half; above, where a limit is broken, yellow to vermilion, and hatched.
vec3 faultColor()
{
    if (fault < 0.5)
        return mix(vec3(0.0, 0.168, 0.445), vec3(0.672, 0.807, 0.855), 2.0 * fault);
    float stripe = smoothstep(0.28, 0.36, abs(fract((gl_FragCoord.x + gl_FragCoord.y) / 10.0) - 0.5));
    return mix(vec3(0.871, 0.776, 0.054), vec3(0.578, 0.045, 0.0), 2.0 * fault - 1.0) * mix(1.0, 0.45, stripe);
}

void main()
{
    vec3 n = normalize(flatShading ? cross(dFdx(eyePosition), dFdy(eyePosition)) : eyeNormal);
    vec3 v = normalize(toEye);
    vec3 toKey = lights * keyDirection;
    float key = dot(n, toKey);
    float wrapped = max((key + wrap) / (1.0 + wrap), 0.0);
    float fill = max(dot(n, lights * fillDirection), 0.0);
    float sky = 0.5 + 0.5 * dot(n, up);
    vec3 light = keyColor * wrapped * wrapped + fillColor * fill + mix(tableColor, skyColor, sky);

    float facing = max(dot(n, v), 0.0);
    float highlight = pow(max(dot(n, normalize(toKey + v)), 0.0), sharpness) * gloss;
    float edge = pow(1.0 - facing, 4.0) * (0.25 + 0.75 * sky) * rim;
    float shadowEdge = exp(-9.0 * key * key);
    vec3 color = mix(albedo * tint, faultColor(), shaded) * light + keyColor * highlight * step(0.0, key) + skyColor * edge;
    color += through * shadowEdge + sheen * (1.0 - facing) * (1.0 - facing) * (0.4 + 0.6 * sky);

    color = withCut(withFootprint(withMask(soften(color))));
    fragColor = vec4(mix(color, toSrgb(color), encodeSrgb), 1.0);
}
