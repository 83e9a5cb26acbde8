#include "app/dataset/gltf_dataset.h"

#include "app/dataset/gltf_scene.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/text.h"

#include <Eigen/LU>
#include <optional>
#include <system_error>

namespace pbffd {
namespace {

Points moved(const Points& points, const AffineMap& map) {
  Points result(points.rows(), 3);
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    result.row(i) = applyMap(map, points.row(i).transpose());
  }
  return result;
}

class GltfDataset : public Dataset {
 public:
  explicit GltfDataset(const std::filesystem::path& path) : document_(path), scene_(sceneOf(document_)) {}

  std::int64_t pointCount() const override {
    std::int64_t count = 0;
    for (const auto& [accessor, positions] : scene_.positions) {
      count += document_.count(accessor);
    }
    return count;
  }

  bool hasVolumeCells() const override { return false; }

  Points sample(std::int64_t stride) const override {
    Points all(pointCount(), 3);
    Eigen::Index at = 0;
    for (const auto& [accessor, positions] : scene_.positions) {
      const Points points = moved(document_.rows(accessor, 3), positions.toScene);
      all.middleRows(at, points.rows()) = points;
      at += points.rows();
    }
    return all(Eigen::seq(0, all.rows() - 1, stride), Eigen::all);
  }

  std::vector<Remark> write(const std::filesystem::path& target, StagedFiles& staged,
                            const Carrying& carrying) override {
    requireSameEnding(document_.path(), target);
    if (!carrying.transports.empty()) {
      failForMissingArray(
          document_.path(), carrying.transports.front(),
          "only VTK data sets have named arrays; the normals and tangents of a glTF model turn by "
          "themselves. Name none.");
    }
    if (carrying.space.movesAnything()) {
      for (const auto& [accessor, positions] : scene_.positions) {
        deform(accessor, positions, carrying);
      }
    }
    const GltfDocument::Files files = document_.encode(target);
    for (const auto& [name, bytes] : files.buffers) {
      staged.write(target.parent_path() / name, *bytes);
    }
    staged.write(target, unmovedBytes().value_or(files.bytes));
    return remarks(target);
  }

 private:
  /// What nothing moved keeps its very bytes.
  std::optional<std::string> unmovedBytes() const {
    return hasMoved_ ? std::nullopt : std::optional(readFile(document_.path()));
  }

  void deform(std::size_t accessor, const GltfPositions& positions, const Carrying& carrying) {
    const Points local = document_.rows(accessor, 3);
    const Points rest = moved(local, positions.toScene);
    const SpaceImage image = carrying.space.image(rest, carrying.progress);
    const bool turns = std::any_of(image.gradients.begin(), image.gradients.end(),
                                   [](const Mat3& gradient) { return gradient != Mat3::Identity(); });
    if (image.positions == rest && !turns) {
      return;
    }
    hasMoved_ = true;
    const Mat3 toScene = positions.toScene.leftCols<3>();
    const Mat3 toLocal = toScene.inverse();
    Points result = local;
    std::vector<Mat3> gradients = image.gradients;
    for (Eigen::Index i = 0; i < local.rows(); ++i) {
      const Vec3 displacement = (image.positions.row(i) - rest.row(i)).transpose();
      result.row(i) += (toLocal * displacement).transpose();
      Mat3& gradient = gradients[static_cast<std::size_t>(i)];
      gradient = toLocal * gradient * toScene;
    }
    store(accessor, result);
    for (const std::size_t normals : positions.normals) {
      turn(normals, gradients, FieldKind::normal, 3);
    }
    for (const std::size_t tangents : positions.tangents) {
      turn(tangents, gradients, FieldKind::vector, 4);
    }
  }

  /// Unit vectors stay unit vectors; the fourth number of a tangent is a sign and stays.
  void turn(std::size_t accessor, const std::vector<Mat3>& gradients, FieldKind kind, int width) {
    GltfDocument::Rows rows = document_.rows(accessor, width);
    if (static_cast<std::size_t>(rows.rows()) != gradients.size()) {
      document_.fail(
          format("accessor {} has {} rows for {} positions", accessor, rows.rows(), gradients.size()));
    }
    for (Eigen::Index i = 0; i < rows.rows(); ++i) {
      const Mat3& gradient = gradients[static_cast<std::size_t>(i)];
      const Vec3 before = rows.row(i).head<3>();
      const Vec3 after = transported(gradient, before, kind);
      if (gradient != Mat3::Identity() && after.norm() > 0.0) {
        rows.row(i).head<3>() = after.normalized() * before.norm();
      }
    }
    store(accessor, rows);
  }

  void store(std::size_t accessor, const GltfDocument::Rows& rows) {
    document_.setRows(accessor, rows);
    // The same bytes again, for the bounds that stand with each accessor.
    if (const auto twins = scene_.twins.find(accessor); twins != scene_.twins.end()) {
      for (const std::size_t twin : twins->second) {
        document_.setRows(twin, rows);
      }
    }
  }

  std::vector<Remark> remarks(const std::filesystem::path& target) const {
    std::vector<Remark> remarks;
    if (scene_.hasMorphTargets && hasMoved_) {
      remarks.push_back(
          format("The morph targets of {} were kept: they add what they did to the deformed mesh.",
                 document_.path().string()));
    }
    std::error_code ignored;
    const auto folder = [](const std::filesystem::path& path) {
      return path.parent_path().empty() ? std::filesystem::path(".") : path.parent_path();
    };
    if (!std::filesystem::equivalent(folder(document_.path()), folder(target), ignored)) {
      for (const std::string& name : document_.filesBeside()) {
        remarks.push_back(format("{} names the file {}, which was not copied.", target.string(), name));
      }
    }
    return remarks;
  }

  GltfDocument document_;
  GltfScene scene_;
  bool hasMoved_ = false;
};

}  // namespace

std::unique_ptr<Dataset> openGltfDataset(const std::filesystem::path& path, const Progress&) {
  return std::make_unique<GltfDataset>(path);
}

}  // namespace pbffd
