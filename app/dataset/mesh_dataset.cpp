#include "app/dataset/mesh_dataset.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/mesh/io/mesh_io.h"

#include <utility>

namespace pbffd {
namespace {

class MeshDataset : public Dataset {
 public:
  MeshDataset(std::filesystem::path path, Mesh mesh) : path_(std::move(path)), mesh_(std::move(mesh)) {}

  std::int64_t pointCount() const override { return mesh_.vertexCount(); }
  bool hasVolumeCells() const override { return false; }
  Points sample(std::int64_t stride) const override {
    return mesh_.positions(Eigen::seq(0, mesh_.positions.rows() - 1, stride), Eigen::all);
  }

  std::vector<Remark> write(const std::filesystem::path& target, StagedFiles& staged,
                            const Carrying& carrying) override {
    const MeshFormat format = formatOfEnding(target);
    if (format == MeshFormat::none) {
      throw InvalidInput(
          pbffd::format("Could not write {}: {} is a mesh, and the ending names no mesh format. Use .obj, "
                        ".off, .ply or .stl.",
                        target.string(), path_.string()));
    }
    if (!carrying.transports.empty()) {
      failForMissingArray(
          path_, carrying.transports.front(),
          "only VTK data sets have named arrays; the normals of a mesh turn by themselves. Name none.");
    }
    staged.write(target, encodeMesh(mesh_, deformed(carrying), format, carrying.progress));
    return {mesh_.remarks.begin(), mesh_.remarks.end()};
  }

 private:
  DeformedShape deformed(const Carrying& carrying) const {
    if (!carrying.space.movesAnything()) {
      return {mesh_.positions, {}};
    }
    SpaceImage image = carrying.space.image(mesh_.positions, carrying.progress);
    return {std::move(image.positions), std::move(image.gradients)};
  }

  std::filesystem::path path_;
  Mesh mesh_;
};

}  // namespace

std::unique_ptr<Dataset> openMeshDataset(const std::filesystem::path& path, const Progress& progress) {
  return std::make_unique<MeshDataset>(path, readMesh(path, progress));
}

}  // namespace pbffd
