#include "app/apply_mpi/shared_apply.h"

#include "app/apply_mpi/work_notes.h"
#include "app/dataset/apply_steps.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/project/project_file.h"

#include <exception>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <utility>

namespace pbffd::mpi {
namespace {

/// Does parts of the work that may throw, and asks the others after each how theirs went: all go on, or all
/// stop. Where it failed on several ranks the lowest one says why.
class Together {
 public:
  Together(const Ranks& ranks, InterruptWatch& watch) : ranks_(ranks), watch_(watch) {}
  /// After a failure the ranks wait for each other: the first to leave makes mpirun end the rest, and by now
  /// each has removed what it staged.
  ~Together() {
    if (hasFailed_) {
      ranks_.any(false);
      watch_.setLastWords([] { return std::string(); });
    }
  }
  Together(const Together&) = delete;
  Together& operator=(const Together&) = delete;

  template <class Work>
  auto operator()(const Work& work) {
    std::exception_ptr failure;
    std::optional<decltype(work())> result;
    try {
      result = work();
    } catch (...) {
      failure = std::current_exception();
    }
    const int failed = ranks_.lowest(failure != nullptr);
    hasFailed_ = failed >= 0;
    if (failed == ranks_.rank()) {
      std::rethrow_exception(failure);
    }
    if (hasFailed_) {
      throw OtherRankFailed();
    }
    return std::move(*result);
  }

 private:
  const Ranks& ranks_;
  InterruptWatch& watch_;
  bool hasFailed_ = false;
};

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
  return {loadProject(work.project, progress).project, readPartition(work.source, work.target)};
}

/// The first rank's, on every rank.
Similarity shared(const Similarity& first, const Ranks& ranks) {
  std::vector<double> numbers{first.scale};
  numbers.insert(numbers.end(), first.rotation.data(), first.rotation.data() + 9);
  numbers.insert(numbers.end(), first.translation.data(), first.translation.data() + 3);
  numbers = ranks.fromFirst(numbers);
  return Similarity{numbers[0], Eigen::Map<const Mat3>(numbers.data() + 1),
                    Eigen::Map<const Vec3>(numbers.data() + 10)};
}

/// What is to be said of the pieces, by the lowest rank that has one with points.
std::vector<Remark> sharedRemarks(const ApplyReport& staged, const Ranks& ranks) {
  constexpr char end = '\0';
  const int speaker = ranks.lowest(staged.points > 0);
  if (speaker < 0) {
    return {};
  }
  std::string text;
  for (const Remark& remark : staged.remarks) {
    text += remark.text + end + remark.option + end;
  }
  std::istringstream lines(ranks.from(speaker, text));
  std::vector<Remark> remarks;
  std::string option;
  while (std::getline(lines, text, end) && std::getline(lines, option, end)) {
    remarks.emplace_back(text, option);
  }
  return remarks;
}

/// What a rank says that is ended because another one is gone, or by the user.
std::string lastWords(const std::optional<WorkNotes::Lost>& lost, const Partition& partition) {
  if (!lost) {
    return stoppedWords();
  }
  const std::string place = lost->piece
                                ? format("while it worked on {}", describePiece(partition, *lost->piece))
                                : "before its first piece";
  return format(
      "pbffd-apply-mpi: Could not deform {}: rank {} ended {}. It was killed, or there was not enough memory "
      "for it; nothing was written. Try fewer ranks.\n",
      partition.index.string(), lost->rank, place);
}

void cleanUpWhenEnded(InterruptWatch& watch, const WorkNotes& notes, const Partition& partition,
                      const std::filesystem::path& folder) {
  watch.setLastWords([notes, partition, folder] {
    const std::string words = lastWords(notes.lost(), partition);
    removeStaged(folder);
    return words;
  });
}

}  // namespace

std::string stoppedWords() {
  return "pbffd-apply-mpi: Stopped, by the user or because another rank ended; nothing was written.\n";
}

ApplyReport applyShared(const SharedApply& work, const Ranks& ranks, InterruptWatch& watch,
                        const Progress& progress) {
  // Before everything that is to be gone when it waits for the others.
  Together together(ranks, watch);
  const Input input = together([&] { return readInput(work, progress); });
  const auto first =
      together([&] { return ranks.isFirst() ? std::make_shared<StagedFiles>(work.target) : nullptr; });
  const std::filesystem::path folder = ranks.fromFirst(first ? first->folder().string() : std::string());
  const WorkNotes notes(ranks, folder);
  cleanUpWhenEnded(watch, notes, input.partition, folder);
  const PieceShare share{static_cast<std::size_t>(ranks.rank()), static_cast<std::size_t>(ranks.count()),
                         [&](std::size_t piece) { notes.workingOn(piece); }};
  ApplyReport report;
  const bool isVolume = dependsOnVolumeCells(input.project) &&
                        ranks.any(together([&] { return haveVolumeCells(input.partition, share, progress); }));
  if (isVolume && ranks.isFirst()) {
    report.remarks.push_back(volumeCellsRemark(work.source));
  }
  std::optional<Similarity> toRest;
  if (work.options.align) {
    // By the first rank from the points of all pieces, so that it does not depend on how many ranks there are.
    toRest = shared(together([&] {
                      return ranks.isFirst()
                                 ? alignedToRest(input.project, samplePoints(input.partition, progress),
                                                 progress, report)
                                 : Similarity();
                    }),
                    ranks);
  }
  StagedFiles mine({folder, format("r{}-", ranks.rank())});
  const ApplyReport staged = together([&] {
    const PlacedSpace space = placedSpace(input.project, isVolume, toRest, progress);
    return stagePieces(input.partition, share, mine, {space, work.options.transports, progress});
  });
  report.points = ranks.sum(staged.points);
  report.hasMoved = ranks.any(staged.hasMoved);
  report.pieces = input.partition.pieces.size();
  const std::vector<Remark> remarks = sharedRemarks(staged, ranks);
  report.remarks.insert(report.remarks.end(), remarks.begin(), remarks.end());
  remarkIfStill(input.project, work.source, report);
  together([&] {
    if (report.points == 0) {
      failForNoPoints(work.source);
    }
    if (first) {
      first->write(work.target, indexText(input.partition));
      first->prepare();
    }
    mine.prepare();
    return true;
  });
  // From here on only names are given; the index, which the others belong to, comes last.
  together([&] {
    mine.commit();
    return true;
  });
  together([&] {
    if (first) {
      first->commit();
    }
    return true;
  });
  return report;
}

}  // namespace pbffd::mpi
