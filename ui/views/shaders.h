#pragma once

namespace pbffd::ui::shaders {

/// The surface: one light model of its own, camera-bound lights. Attributes vertexMC, normalMC.
/// Uniforms meshColor (rgba), isLit.
extern const char* const meshVertex;
extern const char* const meshFragment;

/// One flat colour. Uniform flatColor; pointSize for vertices drawn as points.
extern const char* const flatVertex;
extern const char* const flatFragment;

/// The edges of the polygons, fading out where they get shorter than some pixels. Attribute edgeLength (world).
/// Uniforms flatColor, pixelsPerUnit.
extern const char* const edgeVertex;

/// Lines of any width with smooth borders, made of quads; see Stroke. Attributes ownMC (own end),
/// otherMC, strokeIn (side, end, own radius, other radius), styleIn (dash, gap, cap), colorIn.
extern const char* const strokeVertex;
extern const char* const strokeFragment;

/// Triangles with a colour for each corner. Attributes vertexMC, colorIn.
extern const char* const fillVertex;
extern const char* const fillFragment;

/// Control points: sprites of constant size. Attributes vertexMC, colorIn, styleIn (shape, size, marks,
/// opacity); see PointSprite.
extern const char* const pointVertex;
extern const char* const pointFragment;

}  // namespace pbffd::ui::shaders
