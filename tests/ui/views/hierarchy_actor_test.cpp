#include "ui/views/hierarchy_actor.h"

#include "tests/support/test_main.h"

#include <QtTest>

#include <vtkNew.h>
#include <vtkRenderer.h>

namespace pbffd::ui {
namespace {

using Link = HierarchyActor::Link;

constexpr Rgba white{1, 1, 1, 1};
constexpr Rgba black{0, 0, 0, 1};

Link linkAt(double x, bool hasGlyphs) {
  return {Vec3(x, 0, 0), Vec3(x, 1, 0), hasGlyphs, hasGlyphs};
}

}  // namespace

class HierarchyActorTest : public QObject {
  Q_OBJECT

  vtkNew<vtkRenderer> renderer_;

  std::vector<Stroke> strokesOf(std::vector<Link> links) {
    HierarchyActor actor(*renderer_);
    actor.setColors({white, black});
    actor.setLinks(std::move(links));
    return actor.strokes();
  }

 private Q_SLOTS:
  void linesGoFromParentToChildOverTheirHalos() {
    const auto strokes = strokesOf({linkAt(0, true), linkAt(2, true)});
    QCOMPARE(strokes.size(), std::size_t(4));
    for (std::size_t i = 0; i < 2; ++i) {
      const Stroke& halo = strokes[i];
      const Stroke& line = strokes[i + 2];
      QVERIFY(line.from == Vec3(2.0 * static_cast<double>(i), 0, 0) && line.to == line.from + Vec3::UnitY());
      QVERIFY(halo.from == line.from && halo.to == line.to);
      QVERIFY(line.widthFrom > line.widthTo && halo.widthTo > line.widthTo);
      QVERIFY(line.colorFrom == white && halo.colorFrom[0] == 0 && halo.colorFrom[3] < 1);
    }
  }

  void knotsStandWhereNoGlyphIsDrawn() {
    Link link = linkAt(1, true);
    link.hasChildGlyph = false;
    const auto strokes = strokesOf({link});
    QCOMPARE(strokes.size(), std::size_t(4));
    QVERIFY(strokes[3].from == link.child && strokes[3].to == link.child);
    QVERIFY(strokes[3].cap == Stroke::Cap::round);
  }

  void manyLinesAreFaint() {
    const std::vector<Link> many(2000, linkAt(0, true));
    QVERIFY(strokesOf(many).back().colorTo[3] < 0.5);
    QVERIFY(strokesOf(many).back().colorTo[3] > 0.4);
  }

  void noLinksDrawNothing() { QVERIFY(strokesOf({}).empty()); }
};

const pbffd::test::Registration<HierarchyActorTest> registration;

}  // namespace pbffd::ui

#include "hierarchy_actor_test.moc"
