#include "app/dataset/apply_steps.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/ffd/deform/displacement.h"

#include <algorithm>

namespace pbffd {
namespace {

constexpr std::int64_t alignmentPoints = 40000;

/// Points that lie farther off than this share of the diagonal, in the mean, may be of another shape.
constexpr double doubtfulShare = 0.02;

/// Does something with a piece; its errors then name the piece.
template <class Work>
auto atPiece(const Partition& partition, std::size_t piece, const Work& work) {
  const auto prefix = [&] {
    return describePiece(partition, piece) + " of " + partition.index.string() + ": ";
  };
  try {
    return work();
  } catch (const InvalidInput& error) {
    throw InvalidInput(prefix() + error.what());
  } catch (const IoError& error) {
    throw IoError(prefix() + error.what());
  }
}

void begin(const PieceShare& share, std::size_t piece) {
  if (share.begins) {
    share.begins(piece);
  }
}

std::unique_ptr<Dataset> openPiece(const Partition& partition, std::size_t piece, const Progress& progress) {
  return openDataset(partition.pieces[piece].source, progress);
}

}  // namespace

bool dependsOnVolumeCells(const Project& project) {
  const Level& level = project.controls.finest();
  return std::any_of(level.begin(), level.end(), [](const ControlPoint& point) {
    return point.enabled && point.reach == Reach::connected;
  });
}

std::string volumeCellsRemark(const std::filesystem::path& source) {
  return format(
      "{} has volume cells, so every control point reaches all of its region (reach: all); otherwise they "
      "would tear.",
      source.string());
}

void remarkIfStill(const Project& project, const std::filesystem::path& source, ApplyReport& report) {
  if (report.hasMoved) {
    return;
  }
  if (LevelDisplacements(project.controls.master, project.controls.finest()).isAnyMoved()) {
    report.remarks.push_back(
        {format("No point of {} lies where the project moves anything, so none was moved. Where it lies "
                "elsewhere or in another size, fit its place, size and turn first.",
                source.string()),
         "--align similarity"});
  } else {
    report.remarks.push_back(format("The project is at rest, so nothing in {} was moved.", source.string()));
  }
}

PlacedSpace placedSpace(const Project& project, bool hasVolumeCells, const std::optional<Similarity>& toRest,
                        const Progress& progress) {
  const ReachRule rule = hasVolumeCells ? ReachRule::all : ReachRule::asStored;
  return PlacedSpace(SpaceDeformation(project.mesh, project.controls, rule, progress), toRest);
}

void failForNoPoints(const std::filesystem::path& source) {
  throw InvalidInput(
      format("Could not apply the project to {}: it has no points. Check that it is the right file.",
             source.string()));
}

Similarity alignedToRest(const Project& project, const Points& points, const Progress& progress,
                         ApplyReport& report) {
  const Alignment alignment = alignSimilar(points, *project.mesh, progress);
  const double share = alignment.meanDistance / project.mesh->diagonal();
  report.remarks.push_back(format(
      "Aligned to the project's mesh: scale {:.6g}, mean distance of the points from its vertices {:.2g} % of "
      "its diagonal.{}",
      alignment.toRest.scale, 100.0 * share,
      share > doubtfulShare ? " That is far: is it the same shape?" : ""));
  return alignment.toRest;
}

std::int64_t strideFor(std::int64_t points) {
  return std::max<std::int64_t>(1, (points + alignmentPoints - 1) / alignmentPoints);
}

bool haveVolumeCells(const Partition& partition, const PieceShare& share, const Progress& progress) {
  for (std::size_t p = share.first; p < partition.pieces.size(); p += share.step) {
    begin(share, p);
    if (atPiece(partition, p, [&] { return openPiece(partition, p, progress)->hasVolumeCells(); })) {
      return true;
    }
  }
  return false;
}

std::int64_t countPoints(const Partition& partition, const PieceShare& share, const Progress& progress) {
  std::int64_t count = 0;
  for (std::size_t p = share.first; p < partition.pieces.size(); p += share.step) {
    begin(share, p);
    count += atPiece(partition, p, [&] { return openPiece(partition, p, progress)->pointCount(); });
  }
  return count;
}

Points samplePoints(const Partition& partition, const Progress& progress) {
  const std::int64_t stride = strideFor(countPoints(partition, {}, progress));
  Points points(0, 3);
  for (std::size_t p = 0; p < partition.pieces.size(); ++p) {
    const Points more =
        atPiece(partition, p, [&] { return openPiece(partition, p, progress)->sample(stride); });
    points.conservativeResize(points.rows() + more.rows(), 3);
    points.bottomRows(more.rows()) = more;
  }
  if (points.rows() == 0) {
    failForNoPoints(partition.index);
  }
  return points;
}

ApplyReport stagePieces(const Partition& partition, const PieceShare& share, StagedFiles& staged,
                        const Carrying& carrying) {
  ApplyReport report;
  report.pieces = 0;
  for (std::size_t p = share.first; p < partition.pieces.size(); p += share.step) {
    begin(share, p);
    atPiece(partition, p, [&] {
      const auto dataset = openPiece(partition, p, carrying.progress);
      const bool isFirstWithPoints = report.points == 0 && dataset->pointCount() > 0;
      report.points += dataset->pointCount();
      std::vector<Remark> remarks = dataset->write(partition.pieces[p].target, staged, carrying);
      // What is to be said of one piece is to be said of all.
      if (isFirstWithPoints) {
        report.remarks = std::move(remarks);
      }
      return 0;
    });
    ++report.pieces;
  }
  report.hasMoved = carrying.space.hasMoved();
  return report;
}

}  // namespace pbffd
