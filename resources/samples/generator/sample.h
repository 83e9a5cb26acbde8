#pragma once

#include "core/mesh/mesh.h"

#include <string>
#include <vector>

namespace pbffd::samples {

/// U x 2, row i = texture coordinate i, within [0, 1].
using TextureCoordinates = Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>;

/// A model as its OBJ file will hold it. The tables of the corners have one entry a corner of `faces`.
struct Sample {
  std::string name;   ///< the file's name without its ending
  std::string about;  ///< one line for the head of the file
  Points positions;   ///< N x 3, row i = vertex i; y is up
  Polygons faces;     ///< counter-clockwise from outside
  Points normals;
  std::vector<Index> normalOfCorner;
  TextureCoordinates textures;
  std::vector<Index> textureOfCorner;
  std::vector<std::string> groups;
  std::vector<Index> groupOfFace;
  bool isClosed = true;  ///< whether the surface is meant to have no boundary
};

// One sample of each kind that people bring.

Sample makeCreature();  ///< a quadruped with limbs, ears and a tail: triangles
Sample makeFigure();    ///< a standing person with the arms out: quads
Sample makeHand();      ///< five fingers, close beside each other: triangles
Sample makeBracket();   ///< a machine part with flat faces, holes and a fillet: quads
Sample makeVase();      ///< an open surface: quads, and triangles at the pole
Sample makeBar();       ///< long and straight, to be bent and twisted: quads

/// The text of the OBJ file: positions, texture coordinates, normals and the faces group by group.
std::string toObj(const Sample& sample);

/// Throws InvalidInput that names the sample and what is wrong: a surface that is not one piece, not
/// manifold, or not closed where it should be.
void requireSound(const Sample& sample);

}  // namespace pbffd::samples
