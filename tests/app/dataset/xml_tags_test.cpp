#include "app/dataset/xml_tags.h"
#include "core/base/error.h"
#include "tests/support/test_main.h"

#include <QtTest>

namespace pbffd {

class XmlTagsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void tagsComeWithTheirPlaces() {
    const std::string text = "<?xml version='1.0'?><!-- <no/> --><a x=\"1\" y = '&lt;&amp;>'>text<b/></a >";
    const auto tags = scanXmlTags(text);
    QCOMPARE(tags.size(), std::size_t{3});
    QCOMPARE(tags[0].name, std::string("a"));
    QCOMPARE(tags[0].value("x"), std::string("1"));
    QCOMPARE(tags[0].value("y"), std::string("<&>"));
    QCOMPARE(tags[0].value("z"), std::string());
    const XmlTag::Attribute* y = tags[0].find("y");
    QCOMPARE(text.substr(y->begin, y->end - y->begin), std::string("&lt;&amp;>"));
    QVERIFY(tags[1].isEmpty && !tags[1].isEnd && tags[2].isEnd);
    QCOMPARE(text.substr(tags[2].begin, tags[2].end - tags[2].begin), std::string("</a >"));
  }

  void scanStopsBehindTheLastTag() { QCOMPARE(scanXmlTags("<a/><b/><c", "b").size(), std::size_t{2}); }

  void malformedTagsAreErrors_data() {
    QTest::addColumn<QString>("text");
    for (const char* text :
         {"<", "<a", "<a x>", "<a x=1>", "<a x=\"1>", "<!-- ", "<?", "a < b", "<a =\"\"/>", "<>"}) {
      QTest::newRow(text) << text;
    }
  }
  void malformedTagsAreErrors() {
    QFETCH(QString, text);
    QVERIFY_EXCEPTION_THROWN(scanXmlTags(text.toStdString()), InvalidInput);
  }

  void escapedTextComesBack() {
    const std::string text = "a<b>&\"c'";
    QCOMPARE(scanXmlTags("<t v=\"" + escapedForXml(text) + "\"/>")[0].value("v"), text);
  }
};

const test::Registration<XmlTagsTest> registration;

}  // namespace pbffd

#include "xml_tags_test.moc"
