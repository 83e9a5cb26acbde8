#include "app/dataset/apply.h"

#include "app/dataset/apply_steps.h"
#include "core/mesh/io/mesh_io.h"

namespace pbffd {
namespace {

void announce(const StagedFiles& staged, const ApplyOptions& options) {
  if (options.staging) {
    options.staging(staged.folder());
  }
}

ApplyReport applyToOne(const Project& project, const std::filesystem::path& source,
                       const std::filesystem::path& target, const ApplyOptions& options,
                       const Progress& progress) {
  if (isDataset(source) && formatOfEnding(source) == MeshFormat::none) {
    requireSameEnding(source, target);
  }
  StagedFiles staged(target);
  announce(staged, options);
  const auto dataset = openDataset(source, progress);
  if (dataset->pointCount() == 0) {
    failForNoPoints(source);
  }
  ApplyReport report;
  report.points = dataset->pointCount();
  const bool isVolume = dependsOnVolumeCells(project) && dataset->hasVolumeCells();
  if (isVolume) {
    report.remarks.push_back(volumeCellsRemark(source));
  }
  std::optional<Similarity> toRest;
  if (options.align) {
    toRest = alignedToRest(project, dataset->sample(strideFor(report.points)), progress, report);
  }
  const PlacedSpace space = placedSpace(project, isVolume, toRest, progress);
  for (Remark& remark : dataset->write(target, staged, {space, options.transports, progress})) {
    report.remarks.push_back(std::move(remark));
  }
  report.hasMoved = space.hasMoved();
  remarkIfStill(project, source, report);
  progress.throwIfCancelled();
  staged.commit();
  return report;
}

ApplyReport applyToPartition(const Project& project, const std::filesystem::path& source,
                             const std::filesystem::path& target, const ApplyOptions& options,
                             const Progress& progress) {
  const Partition partition = readPartition(source, target);
  StagedFiles staged(target);
  announce(staged, options);
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
  remarkIfStill(project, source, report);
  staged.write(target, indexText(partition));
  progress.throwIfCancelled();
  staged.commit();
  return report;
}

}  // namespace

ApplyReport applyToFile(const Project& project, const std::filesystem::path& source,
                        const std::filesystem::path& target, const ApplyOptions& options,
                        const Progress& progress) {
  return isPartition(source) ? applyToPartition(project, source, target, options, progress)
                             : applyToOne(project, source, target, options, progress);
}

std::string applicableEndings() {
  std::vector<std::string_view> endings = datasetEndings();
  endings.insert(endings.end(), partitionEndings.begin(), partitionEndings.end());
  return listed(endings);
}

bool isApplicable(const std::filesystem::path& path) {
  return isPartition(path) || isDataset(path);
}

bool isApplicableAs(const std::filesystem::path& source, const std::filesystem::path& target) {
  return isWritableAs(source, target);
}

bool hasNamedArrays(const std::filesystem::path& path) {
  return isPartition(path) || isVtkDataset(path);
}

}  // namespace pbffd
