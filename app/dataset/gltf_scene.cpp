#include "app/dataset/gltf_scene.h"

#include "core/base/text.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace pbffd {
namespace {

using Json = nlohmann::ordered_json;

class SceneReader {
 public:
  explicit SceneReader(const GltfDocument& document) : document_(document) {}

  GltfScene read() {
    placeMeshes();
    const Json& meshes = document_.list("meshes");
    for (std::size_t m = 0; m < meshes.size(); ++m) {
      const auto primitives = meshes[m].find("primitives");
      for (const Json& primitive : primitives == meshes[m].end() ? Json::array() : *primitives) {
        take(primitive, m);
      }
    }
    return std::move(scene_);
  }

 private:
  std::optional<std::size_t> indexIn(const Json& object, const char* key) const {
    const auto found = object.find(key);
    if (found == object.end()) {
      return std::nullopt;
    }
    if (!found->is_number_unsigned()) {
      document_.fail(format("\"{}\" is no whole number", key));
    }
    return found->get<std::size_t>();
  }

  /// The numbers of a list of exactly so many; the fallback where there is none.
  std::vector<double> numbers(const Json& object, const char* key, std::vector<double> otherwise) const {
    const auto found = object.find(key);
    if (found == object.end()) {
      return otherwise;
    }
    std::vector<double> values;
    for (const Json& entry : *found) {
      if (!entry.is_number()) {
        document_.fail(format("\"{}\" of a node holds something that is no number", key));
      }
      values.push_back(entry.get<double>());
    }
    if (values.size() != otherwise.size()) {
      document_.fail(format("\"{}\" of a node should have {} numbers", key, otherwise.size()));
    }
    return values;
  }

  AffineMap ownMap(const Json& node) const {
    if (node.contains("matrix")) {
      const std::vector<double> m = numbers(node, "matrix", std::vector<double>(16));
      return Eigen::Map<const Eigen::Matrix4d>(m.data()).topRows<3>();
    }
    const std::vector<double> t = numbers(node, "translation", {0.0, 0.0, 0.0});
    const std::vector<double> r = numbers(node, "rotation", {0.0, 0.0, 0.0, 1.0});
    const std::vector<double> s = numbers(node, "scale", {1.0, 1.0, 1.0});
    const Mat3 turn = Eigen::Quaterniond(r[3], r[0], r[1], r[2]).normalized().matrix();
    return makeMap(turn * Vec3(s[0], s[1], s[2]).asDiagonal(), Vec3(t[0], t[1], t[2]));
  }

  /// Walks the nodes from the roots down.
  void placeMeshes() {
    const Json& nodes = document_.list("nodes");
    meshMaps_.resize(document_.list("meshes").size());
    std::vector<bool> isChild(nodes.size(), false);
    for (const Json& node : nodes) {
      for (const Json& child : node.value("children", Json::array())) {
        if (child.is_number_unsigned() && child.get<std::size_t>() < nodes.size()) {
          isChild[child.get<std::size_t>()] = true;
        }
      }
    }
    visits_ = 0;
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      if (!isChild[n]) {
        placeNode(n, identityMap());
      }
    }
  }

  void placeNode(std::size_t n, const AffineMap& parent) {
    const Json& nodes = document_.list("nodes");
    if (n >= nodes.size() || ++visits_ > nodes.size()) {
      document_.fail("its nodes are no tree");
    }
    const AffineMap map = composed(parent, ownMap(nodes[n]));
    if (const auto mesh = indexIn(nodes[n], "mesh")) {
      if (nodes[n].contains("extensions") && nodes[n]["extensions"].contains("EXT_mesh_gpu_instancing")) {
        document_.fail(
            format("node {} draws mesh {} many times; make the copies meshes of their own", n, *mesh));
      }
      // A skin places its mesh by the joints alone.
      placeMesh(*mesh, nodes[n].contains("skin") ? identityMap() : map);
    }
    for (const Json& child : nodes[n].value("children", Json::array())) {
      placeNode(child.is_number_unsigned() ? child.get<std::size_t>() : nodes.size(), map);
    }
  }

  void placeMesh(std::size_t mesh, const AffineMap& map) {
    if (mesh >= meshMaps_.size()) {
      document_.fail(format("there is no mesh {}", mesh));
    }
    if (meshMaps_[mesh] && *meshMaps_[mesh] != map) {
      document_.fail(
          format("mesh {} stands in several places of the scene, and cannot be bent in each; give each "
                 "place a mesh of its own",
                 mesh));
    }
    if (!(std::abs(map.leftCols<3>().determinant()) > 0.0)) {
      document_.fail(format("a node flattens mesh {} to nothing", mesh));
    }
    meshMaps_[mesh] = map;
  }

  void take(const Json& primitive, std::size_t mesh) {
    const Json extensions = primitive.value("extensions", Json::object());
    if (extensions.contains("KHR_draco_mesh_compression")) {
      document_.fail(format("mesh {} is compressed (Draco); save the model without compression", mesh));
    }
    const auto attributes = primitive.find("attributes");
    const auto named = attributes == primitive.end() ? std::nullopt : indexIn(*attributes, "POSITION");
    if (!named) {
      return;
    }
    const std::size_t position = rowsOf("POSITION", *named, 3);
    const AffineMap map = meshMaps_[mesh].value_or(identityMap());
    const auto [at, isNew] = scene_.positions.try_emplace(position);
    if (!isNew && at->second.toScene != map) {
      document_.fail(
          format("accessor {} is shared by meshes in several places of the scene, and cannot be bent in "
                 "each; save the model with buffers of their own",
                 position));
    }
    at->second.toScene = map;
    claim(*attributes, "NORMAL", 3, position, at->second.normals);
    claim(*attributes, "TANGENT", 4, position, at->second.tangents);
    scene_.hasMorphTargets = scene_.hasMorphTargets || primitive.contains("targets");
  }

  /// An array that turns with these positions cannot turn with others as well.
  void claim(const Json& attributes, const char* role, int width, std::size_t position,
             std::set<std::size_t>& mine) {
    const auto named = indexIn(attributes, role);
    if (!named) {
      return;
    }
    const std::size_t accessor = rowsOf(role, *named, width);
    const auto [at, isNew] = owners_.try_emplace(accessor, position);
    if (!isNew && at->second != position) {
      document_.fail(
          format("accessor {} gives normals or tangents to two sets of positions; save the model with "
                 "buffers of their own",
                 accessor));
    }
    mine.insert(accessor);
  }

  /// The accessor that stands for the rows of this one: the first with the very same bytes in this role.
  std::size_t rowsOf(const char* role, std::size_t accessor, int width) {
    const GltfDocument::Place place = document_.placeOf(accessor, width);
    const auto [at, isNew] = standFor_.try_emplace({role, place}, accessor);
    if (isNew) {
      claimBytes(place, accessor, sizeof(float) * static_cast<std::size_t>(width));
    } else if (at->second != accessor) {
      scene_.twins[at->second].insert(accessor);
    }
    return at->second;
  }

  /// Bytes that change in two ways would change twice.
  void claimBytes(const GltfDocument::Place& place, std::size_t accessor, std::size_t rowBytes) {
    std::vector<bool>& taken = taken_[place.buffer];
    taken.resize(std::max(taken.size(), place.begin + place.count * place.stride));
    for (std::size_t i = 0; i < place.count; ++i) {
      const auto row = taken.begin() + static_cast<std::ptrdiff_t>(place.begin + i * place.stride);
      const auto end = row + static_cast<std::ptrdiff_t>(rowBytes);
      if (std::find(row, end, true) != end) {
        document_.fail(
            format("accessor {} lies over bytes of other positions, normals or tangents; save the model with "
                   "buffers of their own",
                   accessor));
      }
      std::fill(row, end, true);
    }
  }

  const GltfDocument& document_;
  GltfScene scene_;
  std::vector<std::optional<AffineMap>> meshMaps_;
  std::map<std::size_t, std::size_t> owners_;
  std::map<std::pair<std::string_view, GltfDocument::Place>, std::size_t> standFor_;
  std::map<std::size_t, std::vector<bool>> taken_;  ///< by buffer
  std::size_t visits_ = 0;
};

}  // namespace

GltfScene sceneOf(const GltfDocument& document) {
  return document.guarded([&] { return SceneReader(document).read(); });
}

}  // namespace pbffd
