#include "ui/views/shaders.h"

namespace pbffd::ui::shaders {

// The tags "//VTK::..." are filled in by VTK: the GLSL version, the outputs, the peeling of translucent layers.

const char* const meshVertex = R"(//VTK::System::Dec
in vec4 vertexMC;
in vec3 normalMC;
uniform mat4 MCDCMatrix;
uniform mat4 MCVCMatrix;
out vec3 normalVC;
out vec3 positionVC;
void main() {
  positionVC = (MCVCMatrix * vertexMC).xyz;
  normalVC = mat3(MCVCMatrix) * normalMC;
  gl_Position = MCDCMatrix * vertexMC;
}
)";

const char* const meshFragment = R"(//VTK::System::Dec
in vec3 normalVC;
in vec3 positionVC;
uniform vec4 meshColor;
uniform int cameraParallel;
//VTK::DepthPeeling::Dec
//VTK::Output::Dec

// Elevation and azimuth as unit vectors in camera space, the strength as w; then the light of the camera itself.
const vec4 key = vec4(-0.4575, 0.6691, 0.5856, 0.85);
const vec4 fill = vec4(0.7068, -0.3090, 0.6364, 0.32);
const vec4 back = vec4(0.2400, 0.3746, -0.8956, 0.35);
const float headStrength = 0.12;
const float ambient = 0.16;
const float diffuse = 0.90;
const float specular = 0.12;

// The power is 28, by squaring: pow() is many times slower where a processor draws.
float highlight(vec4 light, vec3 normal, vec3 toEye) {
  float at = max(dot(normal, normalize(light.xyz + toEye)), 0.0);
  float at4 = at * at * at * at;
  float at8 = at4 * at4;
  return light.w * at8 * at8 * at8 * at4;
}

void main() {
  //VTK::Depth::Impl
  //VTK::DepthPeeling::PreColor
  vec3 toEye = cameraParallel != 0 ? vec3(0.0, 0.0, 1.0) : normalize(-positionVC);
  float size = length(normalVC);
  vec3 normal = size > 0.0 ? normalVC / size : toEye;
  if (!gl_FrontFacing) {
    normal = -normal;
  }
  float light = key.w * max(dot(normal, key.xyz), 0.0) + fill.w * max(dot(normal, fill.xyz), 0.0) +
                back.w * max(dot(normal, back.xyz), 0.0) + headStrength * max(dot(normal, toEye), 0.0);
  float shine = highlight(key, normal, toEye) + highlight(back, normal, toEye);
  vec3 shaded = meshColor.rgb * (ambient + diffuse * light) + vec3(specular * shine);
  gl_FragData[0] = vec4(min(shaded, vec3(1.0)), meshColor.a);
  //VTK::DepthPeeling::Impl
}
)";

const char* const flatVertex = R"(//VTK::System::Dec
in vec4 vertexMC;
uniform mat4 MCDCMatrix;
out float strength;
void main() {
  strength = 1.0;
  gl_Position = MCDCMatrix * vertexMC;
}
)";

const char* const flatFragment = R"(//VTK::System::Dec
in float strength;
uniform vec4 flatColor;
//VTK::Output::Dec
void main() {
  gl_FragData[0] = vec4(flatColor.rgb, flatColor.a * strength);
}
)";

const char* const edgeVertex = R"(//VTK::System::Dec
in vec4 vertexMC;
in vec3 normalMC;
in float edgeLength;
uniform mat4 MCVCMatrix;
uniform mat4 VCDCMatrix;
uniform int cameraParallel;
uniform float pixelsPerUnit;
uniform float fadedPixels;
uniform float towardsEye;
out float strength;
void main() {
  vec4 positionVC = MCVCMatrix * vertexMC;
  vec3 toEye = cameraParallel != 0 ? vec3(0.0, 0.0, 1.0) : normalize(-positionVC.xyz);
  vec3 normalVC = mat3(MCVCMatrix) * normalMC;
  float facing = abs(dot(normalVC, toEye)) / max(length(normalVC), 1e-20);
  // Towards the eye by a hair, so that the surface does not hide its own edges.
  if (cameraParallel != 0) {
    positionVC.z += towardsEye;
  } else {
    positionVC.xyz *= 1.0 - 0.001;
  }
  gl_Position = VCDCMatrix * positionVC;
  // As near to one another as the turn of the surface brings them.
  strength = smoothstep(fadedPixels, 3.0 * fadedPixels, facing * edgeLength * pixelsPerUnit / gl_Position.w);
}
)";

const char* const strokeVertex = R"(//VTK::System::Dec
in vec3 ownMC;
in vec3 otherMC;
in vec4 strokeIn;
in vec3 styleIn;
in vec4 colorIn;
uniform mat4 MCDCMatrix;
uniform vec2 viewSize;
uniform float pixelRatio;
out vec4 color;
out vec2 startPixel;
out vec2 endPixel;
out vec2 radii;
out vec3 style;

void main() {
  color = colorIn;
  style = styleIn;
  bool isStart = strokeIn.y < 0.5;
  radii = pixelRatio * (isStart ? strokeIn.zw : strokeIn.wz);
  vec4 own = MCDCMatrix * vec4(ownMC, 1.0);
  vec4 other = MCDCMatrix * vec4(otherMC, 1.0);
  float ownInside = own.z + own.w;
  float otherInside = other.z + other.w;
  startPixel = vec2(0.0);
  endPixel = vec2(0.0);
  if (ownInside <= 0.0 && otherInside <= 0.0) {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
    return;
  }
  if (ownInside <= 0.0) {
    own = mix(own, other, ownInside / (ownInside - otherInside) + 1e-5);
  } else if (otherInside <= 0.0) {
    other = mix(other, own, otherInside / (otherInside - ownInside) + 1e-5);
  }
  vec2 ownPixel = 0.5 * viewSize * own.xy / own.w;
  vec2 otherPixel = 0.5 * viewSize * other.xy / other.w;
  startPixel = isStart ? ownPixel : otherPixel;
  endPixel = isStart ? otherPixel : ownPixel;
  vec2 along = otherPixel - ownPixel;
  float len = length(along);
  along = len > 1e-3 ? along / len : vec2(isStart ? 1.0 : -1.0, 0.0);
  float reach = max(radii.x, radii.y) + 1.0;
  float side = isStart ? strokeIn.x : -strokeIn.x;
  vec2 corner = ownPixel - reach * along + side * reach * vec2(-along.y, along.x);
  gl_Position = vec4(corner / (0.5 * viewSize) * own.w, own.z, own.w);
}
)";

const char* const strokeFragment = R"(//VTK::System::Dec
in vec4 color;
in vec2 startPixel;
in vec2 endPixel;
in vec2 radii;
in vec3 style;
uniform vec2 viewSize;
uniform float pixelRatio;
uniform float opacity;
//VTK::Output::Dec
void main() {
  vec2 pixel = gl_FragCoord.xy - 0.5 * viewSize - startPixel;
  vec2 along = endPixel - startPixel;
  float len = max(length(along), 1e-3);
  float at = dot(pixel, along) / len;
  float inside = clamp(at, 0.0, len);
  float distance = length(pixel - inside * along / len) - mix(radii.x, radii.y, inside / len);
  float beyond = max(-at, at - len);
  if (style.z < 0.5) {  // joined to others: ends sharply, so that no pixel is drawn twice
    if (at < 0.0 || at >= len) {
      discard;
    }
  } else if (style.z > 1.5) {  // cut flat
    distance = max(distance, beyond);
  }
  float alpha = color.a * opacity * clamp(0.5 - distance, 0.0, 1.0);
  if (style.y > 0.0) {
    float dash = style.x * pixelRatio;
    float inPeriod = mod(at, dash + style.y * pixelRatio);
    alpha *= clamp(min(inPeriod, dash - inPeriod) + 0.5, 0.0, 1.0);
  }
  if (alpha < 0.004) {
    discard;
  }
  gl_FragData[0] = vec4(color.rgb, alpha);
}
)";

const char* const fillVertex = R"(//VTK::System::Dec
in vec4 vertexMC;
in vec4 colorIn;
uniform mat4 MCDCMatrix;
out vec4 color;
void main() {
  color = colorIn;
  gl_Position = MCDCMatrix * vertexMC;
}
)";

const char* const fillFragment = R"(//VTK::System::Dec
in vec4 color;
//VTK::Output::Dec
void main() {
  gl_FragData[0] = color;
}
)";

const char* const pointVertex = R"(//VTK::System::Dec
in vec4 vertexMC;
in vec4 colorIn;
in vec4 styleIn;
uniform mat4 MCDCMatrix;
out vec4 color;
out vec4 style;
void main() {
  color = colorIn;
  style = styleIn;
  gl_Position = MCDCMatrix * vertexMC;
}
)";

const char* const pointFragment = R"(//VTK::System::Dec
in vec4 color;
in vec4 style;
uniform vec4 haloColor;
uniform vec4 ringColor;
uniform vec4 activeColor;
uniform float pixelRatio;
uniform float spriteSize;
uniform float opacity;
//VTK::Output::Dec

const float haloWidth = 1.4;

float cover(float distance) {
  return clamp(0.5 - distance * pixelRatio, 0.0, 1.0);
}

vec4 over(vec4 top, vec4 below) {
  float alpha = top.a + below.a * (1.0 - top.a);
  return alpha > 0.0 ? vec4((top.rgb * top.a + below.rgb * below.a * (1.0 - top.a)) / alpha, alpha) : vec4(0.0);
}

float triangleDistance(vec2 p, float r) {
  float slope = 0.8660254;
  return max(dot(vec2(abs(p.x), p.y), vec2(slope, -0.5)), p.y) - 0.55 * r;
}

float shapeDistance(vec2 p, int shape, float r) {
  if (shape == 1) {
    return abs(length(p) - r + 1.0) - 1.0;
  }
  if (shape == 2) {
    return (abs(p.x) + abs(p.y) - 1.15 * r) * 0.7071;
  }
  if (shape == 3) {
    return max(abs(p.x), abs(p.y)) - 0.85 * r;
  }
  if (shape == 4) {
    return triangleDistance(p - vec2(0.0, 0.15 * r), 1.15 * r);
  }
  return length(p) - r;
}

vec4 ring(vec2 p, float radius, vec4 ringPaint, vec4 below) {
  float distance = abs(length(p) - radius) - 0.8;
  below = over(vec4(haloColor.rgb, 0.55 * cover(distance - 0.8)), below);
  return over(vec4(ringPaint.rgb, ringPaint.a * cover(distance)), below);
}

void main() {
  vec2 p = (gl_PointCoord - 0.5) * spriteSize;
  int code = int(style.x + 0.5);
  int shape = code % 8;
  bool isHollow = code >= 8;
  int marks = int(style.z + 0.5);
  float r = 0.5 * style.y;
  float distance = shapeDistance(p, shape, r);
  if (isHollow) {
    float hollow = abs(distance + 0.75) - 0.75;
    float slash = max(abs(p.x + p.y) * 0.7071 - 0.75, length(p) - r - 2.0);
    distance = min(shape == 1 ? distance : hollow, slash);
  }
  vec4 paint = vec4(0.0);
  if ((marks & 1) != 0) {
    vec4 selected = ringColor;
    if ((marks & 4) != 0) {
      selected.a *= step(0.35, fract(atan(p.y, p.x) * 10.0 / 6.2831853));
    }
    paint = ring(p, 9.0, selected, paint);
  }
  if ((marks & 2) != 0) {
    paint = ring(p, 11.6, activeColor, paint);
  }
  if ((marks & 8) != 0) {
    paint = ring(p, 9.0, activeColor, paint);
  }
  paint = over(vec4(haloColor.rgb, cover(distance - haloWidth)), paint);
  paint = over(vec4(color.rgb, cover(distance)), paint);
  paint.a *= style.w * opacity;
  if (paint.a < 0.02) {
    discard;
  }
  gl_FragData[0] = paint;
}
)";

}  // namespace pbffd::ui::shaders
