#include "app/dataset/apply.h"

#include "app/dataset/apply_steps.h"
#include "core/base/file.h"
#include "core/mesh/io/mesh_io.h"

namespace pbffd {
namespace {

ApplyReport applyToOne(const Project& project, const std::filesystem::path& source,
                       const std::filesystem::path& target, const ApplyOptions& options,
                       const Progress& progress) {
  if (isDataset(source) && formatOfEnding(source) == MeshFormat::none) {
    requireSameEnding(source, target);
  }
  StagedFiles staged(target);
  const auto dataset = openDataset(source, progress);
  if (dataset->pointCount() == 0) {
    failForNoPoints(source);
  }
  ApplyReport report{dataset->pointCount(), 1, {}};
  const bool isVolume = dependsOnVolumeCells(project) && dataset->hasVolumeCells();
  if (isVolume) {
    report.remarks.push_back(volumeCellsRemark(source));
  }
  std::optional<Similarity> toRest;
  if (options.align) {
    toRest = alignedToRest(project, dataset->sample(strideFor(report.points)), progress, report);
  }
  const PlacedSpace space = placedSpace(project, isVolume, toRest, progress);
  for (std::string& remark : dataset->write(target, staged, {space, options.transports, progress})) {
    report.remarks.push_back(std::move(remark));
  }
  progress.throwIfCancelled();
  staged.commit();
  return report;
}

ApplyReport applyToPartition(const Project& project, const std::filesystem::path& source,
                             const std::filesystem::path& target, const ApplyOptions& options,
                             const Progress& progress) {
  const Partition partition = readPartition(source, target);
  StagedFiles staged(target);
  ApplyReport before;
  const bool isVolume = dependsOnVolumeCells(project) && haveVolumeCells(partition, {}, progress);
  if (isVolume) {
    before.remarks.push_back(volumeCellsRemark(source));
  }
  std::optional<Similarity> toRest;
  if (options.align) {
    toRest = alignedToRest(project, samplePoints(partition, progress), progress, before);
  }
  const PlacedSpace space = placedSpace(project, isVolume, toRest, progress);
  ApplyReport report = stagePieces(partition, {}, staged, {space, options.transports, progress});
  if (report.points == 0) {
    failForNoPoints(source);
  }
  report.remarks.insert(report.remarks.begin(), before.remarks.begin(), before.remarks.end());
  writeFileAtomically(staged.add(target), indexText(partition));
  progress.throwIfCancelled();
  staged.commit();
  return report;
}

}  // namespace

ApplyReport applyToFile(const Project& project, const std::filesystem::path& source,
                        const std::filesystem::path& target, const ApplyOptions& options,
                        const Progress& progress) {
  requireDistinct(options.transports);
  return isPartition(source) ? applyToPartition(project, source, target, options, progress)
                             : applyToOne(project, source, target, options, progress);
}

std::string applicableEndings() {
  return datasetEndings().replace(datasetEndings().find(" and .gltf"), 10, ", .gltf, .pvtu and .pvtp");
}

bool isApplicable(const std::filesystem::path& path) {
  return isPartition(path) || isDataset(path);
}

}  // namespace pbffd
