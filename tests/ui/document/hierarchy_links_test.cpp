#include "ui/document/hierarchy_links.h"

#include "tests/support/test_main.h"

#include <QtTest>

#include <utility>

namespace pbffd::test {

using ui::HierarchyLink;
using ui::hierarchyLinks;
using Ids = std::vector<PointId>;

/// Three levels: 20 stands for 10 and 11, 10 for 1 and 2, 11 for 3; nothing stands for 4, and 12 for nothing
/// that is there.
ControlSet family() {
  const auto levelOf = [](const std::vector<std::pair<PointId, Ids>>& points) {
    Level level;
    for (const auto& [id, members] : points) {
      ControlPoint point;
      point.id = id;
      point.mergedFrom = members;
      level.append(point);
    }
    return level;
  };
  ControlSet set;
  set.levels = {levelOf({{20, {10, 11}}}), levelOf({{12, {99}}, {10, {1, 2}}, {11, {3}}}),
                levelOf({{1, {}}, {2, {}}, {3, {}}, {4, {}}})};
  return set;
}

class HierarchyLinksTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void everyLinkIsFoundOnce();
  void branchesGoUpAndDown();
  void childrenAndParents();
  void outsideTheLevelsThereIsNothing();
};

void HierarchyLinksTest::everyLinkIsFoundOnce() {
  const std::vector<HierarchyLink> all{{0, 0, 1}, {0, 0, 2}, {1, 1, 0}, {1, 1, 1}, {1, 2, 2}};
  QVERIFY(hierarchyLinks(family()) == all);
}

void HierarchyLinksTest::branchesGoUpAndDown() {
  QVERIFY(hierarchyLinks(family(), 1, {20}) == hierarchyLinks(family()));
  const std::vector<HierarchyLink> throughTen{{0, 0, 1}, {1, 1, 0}, {1, 1, 1}};
  QVERIFY(hierarchyLinks(family(), 2, {10}) == throughTen);
  const std::vector<HierarchyLink> aboveThree{{0, 0, 2}, {1, 2, 2}};
  QVERIFY(hierarchyLinks(family(), 3, {3}) == aboveThree);
  QVERIFY(hierarchyLinks(family(), 3, {4}).empty());
}

void HierarchyLinksTest::childrenAndParents() {
  QCOMPARE(ui::childrenOf(family(), 2, {11, 10}), Ids({1, 2, 3}));
  QCOMPARE(ui::parentsOf(family(), 3, {1, 2, 3, 4}), Ids({10, 11}));
}

void HierarchyLinksTest::outsideTheLevelsThereIsNothing() {
  QVERIFY(ui::childrenOf(family(), 3, {1}).empty());
  QVERIFY(ui::parentsOf(family(), 1, {20}).empty());
  QVERIFY(hierarchyLinks(family(), 7, {20}).empty());
  QVERIFY(hierarchyLinks(ControlSet(), 1, {1}).empty());
}

const Registration<HierarchyLinksTest> registration;

}  // namespace pbffd::test

#include "hierarchy_links_test.moc"
