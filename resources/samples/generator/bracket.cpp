#include "resources/samples/generator/sample.h"
#include "resources/samples/generator/surface_details.h"

#include <array>
#include <cmath>
#include <map>
#include <numbers>

namespace pbffd::samples {
namespace {

// The bracket is drawn as a flat strip (s along it, w across it), given a thickness, and bent by a right
// angle over a fillet.

constexpr double width = 1.2;
constexpr double foot = 1.15;     ///< length of the part that lies
constexpr double upright = 0.55;  ///< length of the part that stands, below its round end
constexpr double thickness = 0.2;
constexpr double fillet = 0.3;      ///< radius on the inside
constexpr double edgeLoop = 0.018;  ///< distance of the first row of faces from a sharp edge
constexpr int cellsAcross = 24;
constexpr double cell = width / cellsAcross;

const double arc = 0.5 * std::numbers::pi * (fillet + 0.5 * thickness);
const double bossStart = foot + arc + upright;
const std::array<double, 5> layers{0.0, edgeLoop, 0.5 * thickness, thickness - edgeLoop, thickness};

using Place = Eigen::Vector2d;

/// A flat mesh of quads whose vertices are found by their places.
class Plan {
 public:
  void addQuad(const Place& a, const Place& b, const Place& c, const Place& d) {
    faces.push_back({vertexAt(a), vertexAt(b), vertexAt(c), vertexAt(d)});
  }

  std::vector<Place> places;
  std::vector<std::array<Index, 4>> faces;  ///< counter-clockwise, s to the right and w up

 private:
  Index vertexAt(const Place& place) {
    const std::pair<long, long> key(std::lround(place.x() * 1e7), std::lround(place.y() * 1e7));
    const auto [entry, isNew] = vertexOf_.emplace(key, static_cast<Index>(places.size()));
    if (isNew) {
      places.push_back(place);
    }
    return entry->second;
  }

  std::map<std::pair<long, long>, Index> vertexOf_;
};

/// Quads between a closed outline and the round hole within it, narrow at the hole, and at the outline
/// where `isEdge`.
void addAroundHole(Plan& plan, const std::vector<Place>& outline, const Place& middle, double radius,
                   bool isEdge) {
  const int rings = 7;
  const auto placeAt = [&](int ring, std::size_t i) -> Place {
    const Place& outer = outline[i % outline.size()];
    const Place ray = outer - middle;
    const double length = ray.norm() - radius;
    double share = static_cast<double>(ring) / rings;
    if (ring == rings - 1) {
      share = 1.0 - edgeLoop / length;
    } else if (ring == 1 && isEdge) {
      share = edgeLoop / length;
    }
    return outer - share * length / ray.norm() * ray;
  };
  for (int ring = 0; ring < rings; ++ring) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
      plan.addQuad(placeAt(ring, i), placeAt(ring, i + 1), placeAt(ring + 1, i + 1), placeAt(ring + 1, i));
    }
  }
}

/// The cuts across the strip, with a narrow row of faces at each edge.
std::vector<double> cutsAcross() {
  std::vector<double> cuts{0.0, edgeLoop};
  for (int i = 1; i < cellsAcross; ++i) {
    cuts.push_back(i * cell);
  }
  cuts.push_back(width - edgeLoop);
  cuts.push_back(width);
  return cuts;
}

/// The cuts along the strip: a narrow row at the foot's end, even parts elsewhere.
std::vector<double> cutsAlong() {
  std::vector<double> cuts{0.0, edgeLoop};
  const auto addEven = [&](double end, int count) {
    const double from = cuts.back() == edgeLoop ? 0.0 : cuts.back();
    for (int i = 1; i <= count; ++i) {
      cuts.push_back(from + (end - from) * i / count);
    }
  };
  addEven(foot, static_cast<int>(std::lround(foot / cell)));
  addEven(foot + arc, 14);
  addEven(bossStart, static_cast<int>(std::lround(upright / cell)));
  return cuts;
}

/// The squares of cells in the foot that give way to a hole: [along, across), in cells.
struct HoleSquare {
  int along;
  int across;
  static constexpr int size = 8;
  bool holds(double s, double w) const {
    return s > along * cell && s < (along + size) * cell && w > across * cell && w < (across + size) * cell;
  }
};
constexpr std::array<HoleSquare, 2> holeSquares{HoleSquare{7, 2}, HoleSquare{7, 14}};

std::vector<Place> outlineOf(const HoleSquare& square) {
  std::vector<Place> outline;
  const Place low(square.along * cell, square.across * cell);
  const std::array<Place, 4> directions{Place(cell, 0), Place(0, cell), Place(-cell, 0), Place(0, -cell)};
  Place at = low;
  for (const Place& direction : directions) {
    for (int i = 0; i < HoleSquare::size; ++i) {
      outline.push_back(at);
      at += direction;
    }
  }
  return outline;
}

/// The round end around the large hole: the strip's last cut, straight sides, and a half circle.
std::vector<Place> bossOutline(const Place& middle) {
  std::vector<Place> outline;
  const double radius = 0.5 * width;
  const int side = 8;
  const int half = 40;
  for (int i = 1; i <= side; ++i) {
    outline.emplace_back(bossStart + radius * i / side, 0.0);
  }
  for (int i = 1; i <= half; ++i) {
    const double angle = std::numbers::pi * i / half;
    outline.emplace_back(middle + radius * Place(std::sin(angle), -std::cos(angle)));
  }
  for (int i = side - 1; i >= 0; --i) {
    outline.emplace_back(bossStart + radius * i / side, width);
  }
  const std::vector<double> across = cutsAcross();
  for (auto w = across.rbegin() + 1; w != across.rend(); ++w) {
    outline.emplace_back(bossStart, *w);
  }
  return outline;
}

Plan makePlan() {
  Plan plan;
  const std::vector<double> along = cutsAlong();
  const std::vector<double> across = cutsAcross();
  for (std::size_t i = 0; i + 1 < along.size(); ++i) {
    for (std::size_t j = 0; j + 1 < across.size(); ++j) {
      const double s = 0.5 * (along[i] + along[i + 1]);
      const double w = 0.5 * (across[j] + across[j + 1]);
      if (!holeSquares[0].holds(s, w) && !holeSquares[1].holds(s, w)) {
        plan.addQuad({along[i], across[j]}, {along[i + 1], across[j]}, {along[i + 1], across[j + 1]},
                     {along[i], across[j + 1]});
      }
    }
  }
  for (const HoleSquare& square : holeSquares) {
    const Place middle((square.along + 0.5 * HoleSquare::size) * cell,
                       (square.across + 0.5 * HoleSquare::size) * cell);
    addAroundHole(plan, outlineOf(square), middle, 0.13, false);
  }
  const Place middle(bossStart + 0.5 * width, 0.5 * width);
  addAroundHole(plan, bossOutline(middle), middle, 0.3, true);
  return plan;
}

/// The bend: the strip lies along x up to the fillet and then stands along y; t is the height above its
/// lower side, w runs along -z.
Vec3 bent(const Place& place, double t) {
  const double s = place.x();
  const double z = 0.5 * width - place.y();
  const double reach = fillet + thickness - t;
  if (s <= foot) {
    return {s, t, z};
  }
  if (s >= foot + arc) {
    return {foot + reach, fillet + thickness + s - foot - arc, z};
  }
  const double angle = 0.5 * std::numbers::pi * (s - foot) / arc;
  return {foot + reach * std::sin(angle), fillet + thickness - reach * std::cos(angle), z};
}

/// The plan's edges that have a face on one side only, in the direction of that face.
std::vector<std::array<Index, 2>> borderOf(const Plan& plan) {
  std::map<std::array<Index, 2>, bool> isInside;
  std::vector<std::array<Index, 2>> edges;
  for (const auto& face : plan.faces) {
    for (int i = 0; i < 4; ++i) {
      edges.push_back({face[i], face[(i + 1) % 4]});
      isInside[edges.back()] = true;
    }
  }
  std::erase_if(edges, [&](const auto& edge) { return isInside.contains({edge[1], edge[0]}); });
  return edges;
}

void extrude(const Plan& plan, Sample& sample) {
  const auto count = static_cast<Index>(plan.places.size());
  const auto last = static_cast<Index>(layers.size()) - 1;
  // Inner layers have vertices on the border only.
  std::vector<Index> vertexOf(plan.places.size() * layers.size(), -1);
  std::vector<Vec3> points;
  const auto vertexAt = [&](Index place, Index layer) {
    Index& vertex = vertexOf[static_cast<std::size_t>(layer * count + place)];
    if (vertex < 0) {
      vertex = static_cast<Index>(points.size());
      points.push_back(bent(plan.places[place], layers[layer]));
    }
    return vertex;
  };
  for (const auto& face : plan.faces) {
    sample.faces.add(std::array{vertexAt(face[0], last), vertexAt(face[1], last), vertexAt(face[2], last),
                                vertexAt(face[3], last)});
    sample.faces.add(
        std::array{vertexAt(face[3], 0), vertexAt(face[2], 0), vertexAt(face[1], 0), vertexAt(face[0], 0)});
  }
  for (const auto& [a, b] : borderOf(plan)) {
    for (Index layer = 0; layer < last; ++layer) {
      sample.faces.add(
          std::array{vertexAt(a, layer), vertexAt(b, layer), vertexAt(b, layer + 1), vertexAt(a, layer + 1)});
    }
  }
  sample.positions.resize(static_cast<Eigen::Index>(points.size()), 3);
  for (std::size_t i = 0; i < points.size(); ++i) {
    sample.positions.row(static_cast<Eigen::Index>(i)) = points[i];
  }
}

}  // namespace

Sample makeBracket() {
  Sample sample;
  sample.name = "bracket";
  sample.about = "An angle bracket with three holes and a fillet";
  extrude(makePlan(), sample);
  addCreasedNormals(sample, 40.0);
  addBoxTextures(sample);
  addSingleGroup(sample);
  return sample;
}

}  // namespace pbffd::samples
