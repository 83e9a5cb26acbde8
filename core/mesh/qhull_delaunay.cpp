#include "core/mesh/qhull_delaunay.h"

#include "core/base/error.h"
#include "core/base/text.h"

extern "C" {
#include <libqhull_r/qhull_ra.h>
}

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csetjmp>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>

namespace pbffd {
namespace {

/// Qhull writes its complaints to a stream; this one keeps them in memory.
class Complaints {
 public:
  Complaints() : stream_(open_memstream(&text_, &size_)) {}
  ~Complaints() {
    std::fclose(stream_);
    std::free(text_);
  }
  Complaints(const Complaints&) = delete;
  Complaints& operator=(const Complaints&) = delete;

  FILE* stream() { return stream_; }
  /// The first line, without the number that Qhull puts in front.
  std::string firstLine() {
    std::fflush(stream_);
    const std::string all(text_, size_);
    return all.substr(0, all.find('\n'));
  }

 private:
  char* text_ = nullptr;
  std::size_t size_ = 0;
  FILE* stream_;
};

/// Of so many points on one sphere, or of one circle, Qhull makes one cell, which it goes through again for each of
/// them: two spheres of 20,000 vertices take minutes, a torus of as many 20 s.
constexpr int greatestCell = 40;

/// One run of Qhull. It leaves by longjmp where it gives up, so nothing with a destructor may live in the
/// functions that call into it.
class Run {
 public:
  explicit Run(const Points& points) : points_(points) {
    qh_zero(&qh_, complaints_.stream());
    qh_meminit(&qh_, complaints_.stream());
    qh_initqhull_start(&qh_, nullptr, nullptr, complaints_.stream());
  }
  ~Run() {
    qh_.NOerrexit = True;
    qh_freeqhull(&qh_, !qh_ALL);
    int longCount = 0;
    int longBytes = 0;
    qh_memfreeshort(&qh_, &longCount, &longBytes);
  }
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;

  /// Reads the options and makes the first simplex. False where Qhull gave up.
  bool start(const char* options) {
    return guarded(
        [](qhT* qh, void* self, const char* command) {
          const Points& points = static_cast<Run*>(self)->points_;
          qh_initflags(qh, const_cast<char*>(command));
          qh->PROJECTdelaunay = True;
          qh_init_B(qh, const_cast<double*>(points.data()), static_cast<int>(points.rows()), 3, False);
          qh_initbuild(qh);
          qh->facet_next = qh->facet_list;
        },
        options);
  }

  /// Adds up to `count` more points: the loop of Qhull's own qh_buildhull, which cannot be left between two
  /// points without losing one.
  bool addPoints(int count) {
    left_ = count;
    return guarded(
        [](qhT* qh, void* self, const char*) {
          int& left = static_cast<Run*>(self)->left_;
          for (; left > 0; --left) {
            facetT* facet = nullptr;
            pointT* const furthest = qh_nextfurthest(qh, &facet);
            if (furthest == nullptr) {
              return;
            }
            --qh->num_outside;
            if (!qh_addpoint(qh, furthest, facet, qh->ONLYmax)) {
              return;
            }
            noteCells(qh, self);
          }
        },
        nullptr);
  }
  /// Whether the last slice was used up.
  bool hasMore() const { return left_ == 0; }
  /// Whether more than `greatestCell` points were found on one sphere.
  bool hasGreatCell() const { return hasGreatCell_; }
  Index vertexCount() const { return qh_.num_vertices; }
  std::string complaint() { return complaints_.firstLine(); }

  DelaunayCells cells() {
    DelaunayCells cells;
    qhT* const qh = &qh_;
    facetT* facet = nullptr;
    FORALLfacets {
      if (facet->upperdelaunay) {
        continue;
      }
      const std::size_t begin = cells.points.size();
      vertexT* vertex = nullptr;
      vertexT** vertexp = nullptr;
      FOREACHvertex_(facet->vertices) {
        const int row = qh_pointid(qh, vertex->point);
        // The point at infinity that option Qz adds comes last.
        if (row >= 0 && row < points_.rows()) {
          cells.points.push_back(row);
        }
      }
      if (cells.points.size() < begin + 4) {
        cells.points.resize(begin);
        continue;
      }
      std::sort(cells.points.begin() + static_cast<std::ptrdiff_t>(begin), cells.points.end());
      cells.start.push_back(static_cast<Index>(cells.points.size()));
    }
    return cells;
  }

 private:
  using Step = void (*)(qhT* qh, void* self, const char* text);

  bool guarded(Step step, const char* text) {
    const int failure = setjmp(qh_.errexit);
    if (failure == 0) {
      qh_.NOerrexit = False;
      step(&qh_, this, text);
    }
    qh_.NOerrexit = True;
    return failure == 0;
  }

  /// Looks at the cells of the point that was added last.
  static void noteCells(qhT* qh, void* self) {
    vertexT* const vertex = qh->vertex_tail->previous;
    facetT* neighbor = nullptr;
    facetT** neighborp = nullptr;
    FOREACHneighbor_(vertex) {
      if (qh_setsize(qh, neighbor->vertices) > greatestCell) {
        static_cast<Run*>(self)->hasGreatCell_ = true;
      }
    }
  }

  const Points& points_;
  Complaints complaints_;
  qhT qh_;
  int left_ = 0;  ///< of the slice that is being added
  bool hasGreatCell_ = false;
};

/// Few enough points at a time that a request to stop is heard at once, however slow the points are.
bool addAllPoints(Run& run, Index total, bool stopsAtGreatCell, const Progress& progress) {
  using Clock = std::chrono::steady_clock;
  int slice = 512;
  while (run.hasMore()) {
    progress.throwIfCancelled();
    progress.report("Placing points: cells",
                    static_cast<double>(run.vertexCount()) / static_cast<double>(total));
    const auto begin = Clock::now();
    if (!run.addPoints(slice) || (stopsAtGreatCell && run.hasGreatCell())) {
      return false;
    }
    const auto spent = Clock::now() - begin;
    if (spent < std::chrono::milliseconds(50)) {
      slice *= 2;
    } else if (spent > std::chrono::milliseconds(200)) {
      slice = std::max(64, slice / 2);
    }
  }
  return true;
}

/// The points off by a hair, each coordinate in its own way, the same at every call.
Points joggled(const Points& points) {
  constexpr double amplitude = 1e-9;
  Points moved = points;
  std::uint64_t state = 0x9e3779b97f4a7c15;
  for (Eigen::Index i = 0; i < moved.size(); ++i) {
    state = state * 6364136223846793005U + 1442695040888963407U;
    moved.data()[i] += amplitude * (std::ldexp(static_cast<double>(state >> 11), -52) - 1.0);
  }
  return moved;
}

}  // namespace

DelaunayCells delaunayCells(const Points& points, const Progress& progress) {
  const auto total = static_cast<Index>(points.rows());
  std::string complaint;
  bool hasGreatCell = false;
  const auto attempt = [&](const Points& input, const char* options,
                           bool stopsAtGreatCell = false) -> std::optional<DelaunayCells> {
    Run run(input);
    if (run.start(options) && addAllPoints(run, total, stopsAtGreatCell, progress)) {
      return run.cells();
    }
    hasGreatCell = stopsAtGreatCell && run.hasGreatCell();
    complaint = run.complaint();
    return std::nullopt;
  };
  if (auto cells = attempt(points, "qhull v Qbb", true)) {
    return *std::move(cells);
  }
  // Points all on one sphere (the corners of a cube) make no first simplex without a point at infinity.
  if (!hasGreatCell) {
    if (auto cells = attempt(points, "qhull v Qbb Qz")) {
      return *std::move(cells);
    }
  }
  // Where rounding defeats that too, or great cells take too long. (Qhull's own option QJ is no help: it takes
  // flat sets for solid ones.)
  if (auto cells = attempt(joggled(points), "qhull v Qbb Qz")) {
    return *std::move(cells);
  }
  throw SolverError(format("The Voronoi diagram of {} sites cannot be made: {} Try another number of sites.",
                           total, complaint));
}

}  // namespace pbffd
