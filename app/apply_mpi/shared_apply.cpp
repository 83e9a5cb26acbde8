#include "app/apply_mpi/shared_apply.h"

#include "app/dataset/apply_steps.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/text.h"
#include "core/project/project_file.h"

#include <exception>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace pbffd::mpi {
namespace {

/// Does a part of the work that may throw, then asks the others how theirs went: all go on, or all stop. Where
/// it failed on several ranks the lowest one says why.
template <class Work>
auto together(const Ranks& ranks, const Work& work) {
  std::exception_ptr failure;
  std::optional<decltype(work())> result;
  try {
    result = work();
  } catch (...) {
    failure = std::current_exception();
  }
  const int failed = ranks.lowest(failure != nullptr);
  if (failed == ranks.rank()) {
    std::rethrow_exception(failure);
  }
  if (failed >= 0) {
    throw OtherRankFailed();
  }
  return std::move(*result);
}

struct Input {
  Project project;
  Partition partition;
};

Input readInput(const SharedApply& work, const Progress& progress) {
  if (!isPartition(work.source)) {
    throw InvalidInput(
        format("Could not share {} among processes: it is no partitioned data set (.pvtu, .pvtp). Use "
               "pbffd apply.",
               work.source.string()));
  }
  requireDistinct(work.options.transports);
  return {loadProject(work.project, progress).project, readPartition(work.source, work.target)};
}

/// The alignment is found on the first rank, from the points of all pieces, so that it does not depend on how
/// many ranks there are.
std::optional<Similarity> sharedAlignment(const SharedApply& work, const Input& input, const Ranks& ranks,
                                          const Progress& progress, ApplyReport& report) {
  if (!work.options.align) {
    return std::nullopt;
  }
  const Similarity mine = together(ranks, [&] {
    return ranks.isFirst()
               ? alignedToRest(input.project, samplePoints(input.partition, progress), progress, report)
               : Similarity();
  });
  std::vector<double> numbers{mine.scale};
  numbers.insert(numbers.end(), mine.rotation.data(), mine.rotation.data() + 9);
  numbers.insert(numbers.end(), mine.translation.data(), mine.translation.data() + 3);
  numbers = ranks.fromFirst(numbers);
  return Similarity{numbers[0], Eigen::Map<const Mat3>(numbers.data() + 1),
                    Eigen::Map<const Vec3>(numbers.data() + 10)};
}

}  // namespace

ApplyReport applyShared(const SharedApply& work, const Ranks& ranks, StopWatch& watch,
                        const Progress& progress) {
  const Input input = together(ranks, [&] { return readInput(work, progress); });
  const PieceShare share{static_cast<std::size_t>(ranks.rank()), static_cast<std::size_t>(ranks.count())};
  ApplyReport report;
  const bool isVolume =
      dependsOnVolumeCells(input.project) &&
      ranks.any(together(ranks, [&] { return haveVolumeCells(input.partition, share, progress); }));
  if (isVolume && ranks.isFirst()) {
    report.remarks.push_back(volumeCellsRemark(work.source));
  }
  const auto toRest = sharedAlignment(work, input, ranks, progress, report);
  const auto first =
      together(ranks, [&] { return ranks.isFirst() ? std::make_shared<StagedFiles>(work.target) : nullptr; });
  const std::filesystem::path folder = ranks.fromFirst(first ? first->folder().string() : std::string());
  watch.setFolder(folder);
  StagedFiles mine({folder, format("r{}-", ranks.rank())});
  const ApplyReport staged = together(ranks, [&] {
    const PlacedSpace space = placedSpace(input.project, isVolume, toRest, progress);
    return stagePieces(input.partition, share, mine, {space, work.options.transports, progress});
  });
  report.points = ranks.sum(staged.points);
  report.pieces = input.partition.pieces.size();
  report.remarks.insert(report.remarks.end(), staged.remarks.begin(), staged.remarks.end());
  together(ranks, [&] {
    if (report.points == 0) {
      failForNoPoints(work.source);
    }
    if (first) {
      writeFileAtomically(first->add(work.target), indexText(input.partition));
    }
    return true;
  });
  // From here on only names are given; the index, which the others belong to, comes last.
  together(ranks, [&] {
    mine.commit();
    return true;
  });
  together(ranks, [&] {
    if (first) {
      first->commit();
    }
    return true;
  });
  return report;
}

}  // namespace pbffd::mpi
