// Tests the expansion of X3D scenes: the written text contains nothing that a simple reader would misread, and it is
// within its limits.

#include "core/io/mesh/x3d_expansion.h"

#include "core/util/file_error.h"
#include "tests/support/test_main.h"

#include <QRegularExpression>
#include <QSet>
#include <QTest>

#include <array>
#include <cmath>
#include <optional>

namespace
{
using core::FileFault;
using core::io::X3dExpansion;
using Kind = core::FileErrorKind;

const std::filesystem::path path = "a.x3d";

X3dExpansion expanded(const QByteArray& scene, const QByteArray& head = {})
{
    const QByteArray text = "<?xml version='1.0'?>\n<X3D>" + head + "<Scene>" + scene + "</Scene></X3D>";
    return core::io::expandX3d({path, {text.constData(), std::size_t(text.size())}});
}

QString sceneOf(const X3dExpansion& expansion)
{
    const QString text = QString::fromStdString(expansion.text);
    const qsizetype begin = text.indexOf("<Scene>") + 7;
    return text.mid(begin, text.indexOf("</Scene>") - begin);
}

QString sceneOf(const QByteArray& scene)
{
    return sceneOf(expanded(scene));
}

/// Returns the value of the attribute's first occurrence.
QString valueOf(const QString& text, const char* attribute)
{
    return QRegularExpression(QStringLiteral(" %1=\"([^\"]*)\"").arg(QLatin1StringView(attribute)))
        .match(text)
        .captured(1);
}

std::optional<core::FileError> errorOf(const QByteArray& scene, const QByteArray& head = {})
{
    try {
        expanded(scene, head);
    } catch (const core::FileError& error) {
        return error;
    }
    return std::nullopt;
}

const QByteArray box = "<Shape><Box/></Shape>", points = "<Coordinate point='0 0 0 1 0 0 1 1 0 0 1 0 0 0 1 1 0 1'/>";
} // namespace

class TestX3dExpansion : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void uses_areThereAgain();
    void names_areThoseOfOneFile();
    void groups_areHeldToWhatTheyShow_data();
    void groups_areHeldToWhatTheyShow();
    void emptyGroups_areLeftOut();
    void faces_areWoundAnticlockwise_data();
    void faces_areWoundAnticlockwise();
    void colors_areThoseOfPoints_data();
    void colors_areThoseOfPoints();
    void units_areScaled();
    void angles_areInRadians();
    void invisibleNodes_areLeftOut();
    void layers_hideChildByChild();
    void expandedFiles_stayAsTheyAre();
    void axes_areOfUnitLength();
    void namesOfPrototypes_holdInsideOnly();
    void closedExtrusions_haveNoCaps();
    void doubledEnds_haveTheirSections_data();
    void doubledEnds_haveTheirSections();
    void straightSpines_doNotTurn_data();
    void straightSpines_doNotTurn();
    void grids_areMadeOfQuads();
    void primitives_haveNumbers();
    void unreadSurfaces_areCounted();
    void badFiles_areRefused_data();
    void badFiles_areRefused();
    void growth_isBounded();
    void chainsOfUses_areBounded();
    void cutFiles_areRefused();

    void wordsAndNames_areTakenGenerously();
    void usesOfOtherKinds_areUnread();
    void inlines_haveAlternatives();
    void colors_areNumbers();
    void fewPoints_areTheSetsOwn();
};

void TestX3dExpansion::uses_areThereAgain()
{
    const QString scene =
        sceneOf("<Transform DEF='T' translation='1 2 3'>" + box + "</Transform><Group><Transform USE='T'/></Group>");
    QCOMPARE(scene.count(" translation=\"1 2 3\">"), 2);
    QCOMPARE(scene.count("<Box"), 1); // the shape is written once and referred to by its name
    QCOMPARE(scene.count("<Shape USE=\"" + valueOf(scene.mid(scene.indexOf("<Shape")), "DEF") + "\""), 1);
    QCOMPARE(sceneOf("<Switch whichChoice='-1'><Shape DEF='S'><Box/></Shape></Switch><Shape USE='S'/>").count("<Box"),
             1);
}

/// Inlined files share a scene in which names are global, so no name may occur in two files.
void TestX3dExpansion::names_areThoseOfOneFile()
{
    const std::string text = ("<X3D><Scene><Shape DEF='A'><IndexedFaceSet coordIndex='0 1 2'>" + points +
                              "</IndexedFaceSet></Shape><Shape><Cone/></Shape><Shape USE='A'/></Scene></X3D>")
                                 .toStdString();
    QSet<QString> all;
    qsizetype count = 0;
    for (const std::size_t number : {0, 1, 11, 110}) {
        const QString scene = sceneOf(core::io::expandX3d({path, text}, {.fileNumber = number}));
        QSet<QString> own;
        static const QRegularExpression definition(QStringLiteral(" DEF=\"([^\"]*)\""));
        for (auto match = definition.globalMatch(scene); match.hasNext();)
            own.insert(match.next().captured(1));
        QCOMPARE(own.size(), scene.count(QStringLiteral(" DEF=")));
        QVERIFY(own.contains(valueOf(scene, "USE")));
        count += own.size();
        all += own;
    }
    QVERIFY(count > 0);
    QCOMPARE(all.size(), count);
}

void TestX3dExpansion::groups_areHeldToWhatTheyShow_data()
{
    QTest::addColumn<QByteArray>("scene");
    QTest::addColumn<int>("boxes");
    const QByteArray two = box + box;
    QTest::newRow("Collision") << "<Collision>" + box + "<Shape containerField='proxy'><Sphere/></Shape></Collision>"
                               << 1;
    for (const char* name : {"Group", "StaticGroup", "Anchor", "Billboard", "CADAssembly", "CADPart", "Transform"})
        QTest::newRow(name) << "<" + QByteArray(name) + ">" + two + "</" + name + ">" << 2;
    QTest::newRow("LOD") << "<LOD><MetadataString/>" + box + "<Group>" + two + "</Group></LOD>" << 1;
    QTest::newRow("Switch") << "<Switch whichChoice='1'>" + box + "<Group>" + two + "</Group></Switch>" << 2;
    QTest::newRow("Switch, none") << "<Switch>" + box + "</Switch>" << 0;
    QTest::newRow("Switch, beyond") << "<Switch whichChoice='7'>" + box + "</Switch>" << 0;
    QTest::newRow("prototype") << "<ProtoDeclare><ProtoBody>" + box + "</ProtoBody></ProtoDeclare>" + box << 1;
}

void TestX3dExpansion::groups_areHeldToWhatTheyShow()
{
    QFETCH(QByteArray, scene);
    QFETCH(int, boxes);
    const X3dExpansion expansion = expanded(scene);
    QCOMPARE(sceneOf(expansion).count("<Box"), boxes);
    QCOMPARE(sceneOf(expansion).count("Sphere"), 0);
    QCOMPARE(expansion.unread, std::size_t(0));
}

/// Empty groups are removed, because Assimp ascends two levels at their end.
void TestX3dExpansion::emptyGroups_areLeftOut()
{
    QCOMPARE(sceneOf("<Group/><Transform><Group><Transform translation='1 1 1'/></Group></Transform>"), QString());
    QCOMPARE(sceneOf("<Group><Shape><IndexedLineSet coordIndex='0 1'/></Shape></Group>"), QString());
}

void TestX3dExpansion::faces_areWoundAnticlockwise_data()
{
    QTest::addColumn<QByteArray>("node");
    QTest::addColumn<QString>("indices");
    const auto row = [](const char* name, const QByteArray& attributes, const char* indices) {
        QTest::addRow("%s %s", name, attributes.constData())
            << "<" + QByteArray(name) + " " + attributes + ">" + points + "</" + name + ">" << QString(indices);
    };
    row("IndexedFaceSet", "coordIndex='0 1 2 3 -1 0,1 , 4'", "0 1 2 3 -1 0 1 4 -1");
    row("IndexedFaceSet", "ccw='false' coordIndex='0 1 2 3 -1 -1 0 1 -1 0 1 4'", "3 2 1 0 -1 4 1 0 -1");
    row("IndexedTriangleSet", "index='0 1 2 2 3 0 4 5'", "0 1 2 -1 2 3 0 -1");
    row("IndexedTriangleStripSet", "index='0 1 2 3 4 -1 0 1 5'", "0 1 2 -1 2 1 3 -1 2 3 4 -1 0 1 5 -1");
    row("IndexedTriangleFanSet", "index='0 1 2 3 -1'", "0 1 2 -1 0 2 3 -1");
    row("IndexedQuadSet", "index='0 1 2 3 4 5'", "0 1 2 3 -1");
    row("TriangleSet", "ccw='false'", "2 1 0 -1 5 4 3 -1");
    row("QuadSet", "", "0 1 2 3 -1");
    row("TriangleStripSet", "stripCount='4'", "0 1 2 -1 2 1 3 -1");
    row("TriangleFanSet", "fanCount='3 3'", "0 1 2 -1 3 4 5 -1");
    row("TriangleFanSet", "fanCount='1 0 4'", "1 2 3 -1 1 3 4 -1");
}

void TestX3dExpansion::faces_areWoundAnticlockwise()
{
    QFETCH(QByteArray, node);
    QFETCH(QString, indices);
    const QString scene = sceneOf("<Shape>" + node + "</Shape>");
    QVERIFY(scene.contains("<IndexedFaceSet"));
    QCOMPARE(valueOf(scene, "coordIndex"), indices);
    QCOMPARE(scene.count("<Coordinate"), 1);
}

void TestX3dExpansion::colors_areThoseOfPoints_data()
{
    QTest::addColumn<QByteArray>("attributes");
    QTest::addColumn<QString>("colors"); // colours of points 0 to 5, of which four are used
    QTest::newRow("points'") << QByteArray() << "1 0 0 0 1 0 0 0 1 1 1 1 1 1 1 1 1 1";
    QTest::newRow("corners'") << QByteArray("colorIndex='2 2 0 -1 0 0 1'") << "0 0 1 0 0 1 1 0 0 0 1 0 1 1 1 1 1 1";
    QTest::newRow("faces'") << QByteArray("colorPerVertex='false'") << "0 1 0 1 0 0 0 1 0 0 1 0 1 1 1 1 1 1";
    QTest::newRow("faces', by index") << QByteArray("colorPerVertex='false' colorIndex='1 2'")
                                      << "0 0 1 0 1 0 0 0 1 0 0 1 1 1 1 1 1 1";
}

void TestX3dExpansion::colors_areThoseOfPoints()
{
    QFETCH(QByteArray, attributes);
    QFETCH(QString, colors);
    const QByteArray color = "<Color color='1 0 0 0 1 0 0 0 1'/>";
    const QString scene = sceneOf("<Shape><IndexedFaceSet coordIndex='0 1 2 -1 0 2 3' " + attributes + ">" + points +
                                  color + "</IndexedFaceSet></Shape>");
    if (attributes.startsWith("colorIndex"))
        colors.replace(0, 17, "1 0 0 0 0 1 1 0 0"); // a point has the colour of its last corner
    QCOMPARE(valueOf(scene, "color"), colors);
}

void TestX3dExpansion::units_areScaled()
{
    const QByteArray inch = "<head><unit category='length' name='inch' conversionFactor='0.0254'/></head>";
    QVERIFY(sceneOf(expanded(box, inch)).startsWith("<Transform scale=\"0.0254 0.0254 0.0254\"><Shape"));
    QCOMPARE(sceneOf(expanded("<Group/>", inch)), QString());
    QVERIFY(!sceneOf(expanded(box, "<head><unit category='angle' conversionFactor='0.1'/></head>")).contains("scale"));
    // An inlined file has a unit of its own and scales itself to metres.
    const QByteArray quarter = "<head><unit category='length' conversionFactor='0.25'/></head>";
    QVERIFY(sceneOf(expanded("<Inline url='a.x3d'/>", quarter))
                .contains("<Transform scale=\"0.25 0.25 0.25\"><Transform scale=\"4 4 4\"><Inline url="));
}

/// Angles in a unit that the file defines are converted to radians, the unit of X3D.
void TestX3dExpansion::angles_areInRadians()
{
    const QByteArray half = "<head><unit category='angle' name='half radian' conversionFactor='0.5'/></head>";
    for (const QByteArray& node :
         {"<Transform rotation='0 0 1 %1' scaleOrientation='0 1 0 -%2'>" + box + "</Transform>",
          QByteArray("<Shape><Extrusion spine='0 0 0 0 1 0 0 2 0' orientation='0 1 0 %1 0 0 1 %2 1 0 0 -%1'/></Shape>"),
          QByteArray("<Shape><ArcClose2D startAngle='-%1' endAngle='%2'/></Shape>")}) {
        const auto with = [&node](const char* first, const char* second) {
            return QByteArray(node).replace("%1", first).replace("%2", second);
        };
        QCOMPARE(sceneOf(expanded(with("3", "0.25"), half)), sceneOf(with("1.5", "0.125")));
    }
    QVERIFY(errorOf({}, "<head><unit category='angle' conversionFactor='-1'/></head>"));
    QVERIFY(!errorOf({}, "<head><unit category='mass' conversionFactor='x'/></head>"));
}

/// X3D 4 adds groups and shapes with a `visible` attribute.
void TestX3dExpansion::invisibleNodes_areLeftOut()
{
    for (const char* name : {"Group", "Transform", "Anchor", "Switch whichChoice='0'", "LOD", "Collision"}) {
        const QByteArray begin = "<" + QByteArray(name) + " DEF='A' visible='%'>",
                         end = "</" + QByteArray(name).split(' ').front() + ">";
        const QByteArray group = begin + "<Group>" + box + "</Group>" + end + box + "<Group><Group USE='A'/></Group>";
        const auto boxes = [&group](const char* visible) {
            const X3dExpansion expansion = expanded(QByteArray(group).replace("%", visible));
            return expansion.unread == 0 ? sceneOf(expansion).count(QRegularExpression("<Box|Shape USE")) : -1;
        };
        QCOMPARE(boxes("true"), 3);
        QCOMPARE(boxes(""), 3);
        QCOMPARE(boxes("false"), 1);
        QCOMPARE(boxes(" FALSE "), 1);
    }
    QCOMPARE(sceneOf("<Shape visible='false'><Sphere/></Shape>" + box).count("Sphere"), 0);
    QCOMPARE(expanded("<Shape visible='false'><Sphere/></Shape>" + box).hidden, std::size_t(1));
    QCOMPARE(expanded("<Group visible='false'>" + box + box + "</Group>" + box).hidden, std::size_t(1));
    QCOMPARE(expanded("<Group visible='false'><Viewpoint/></Group>" + box).hidden, std::size_t(0));
    QCOMPARE(sceneOf("<Inline visible='false' url='a.x3d'/>"), QString());
    QCOMPARE(expanded("<Group visible='false'><ProtoInstance name='x'/></Group>").unread, std::size_t(0));
    // A hidden level of detail does not count as a level.
    QCOMPARE(sceneOf("<LOD><Group visible='false'>" + box + "</Group>" + box + box + "</LOD>").count("<Box"), 1);
}

/// A CADLayer has a visibility value for each child in version 3, and one value for all children in version 4.
void TestX3dExpansion::layers_hideChildByChild()
{
    const auto shown = [](const QByteArray& visible, const char* version) {
        const QByteArray text = "<X3D version='" + QByteArray(version) + "'><Scene><CADLayer DEF='L' visible='" +
                                visible + "'><MetadataSet/>" + "<Shape><Box/></Shape><Shape><Sphere/></Shape>" +
                                "<Shape><Cone/></Shape></CADLayer></Scene></X3D>";
        const QString scene = sceneOf(core::io::expandX3d({path, text.toStdString()}));
        return QString(scene.contains("<Box") ? "B" : "") + (scene.contains("<Sphere") ? "S" : "") +
               (scene.contains("<IndexedFaceSet") ? "C" : "");
    };
    for (const char* version : {"3.1", "3.3", ""}) {
        QCOMPARE(shown("", version), QStringLiteral("BSC"));
        QCOMPARE(shown("false", version), QStringLiteral("SC")); // a missing value means visible
        QCOMPARE(shown("FALSE, true", version), QStringLiteral("SC"));
        QCOMPARE(shown("true false", version), QStringLiteral("BC"));
        QCOMPARE(shown("true true false false", version), QStringLiteral("BS"));
        QCOMPARE(shown("false false false", version), QString());
    }
    QCOMPARE(shown("false", "4.0"), QString());
    QCOMPARE(shown("true", "4.0"), QStringLiteral("BSC"));
}

void TestX3dExpansion::expandedFiles_stayAsTheyAre()
{
    const X3dExpansion once =
        expanded("<Transform DEF='T'><Shape><ArcClose2D closureType='1 &quot; &lt; &amp; 2'/></Shape>" + box +
                 "<Shape><Cone/></Shape></Transform><Transform USE='T'/><Shape><IndexedTriangleSet index='0 1 2'>" +
                 points + "</IndexedTriangleSet></Shape>");
    QCOMPARE(core::io::expandX3d({path, once.text}).text, once.text);
    // a named group of which nothing is left takes no number from those after it
    const X3dExpansion other = expanded("<Group DEF='A'><Group DEF='B'><ProtoInstance name='x'/></Group></Group>"
                                        "<Group DEF='C'>" +
                                        box + "</Group>");
    QVERIFY(sceneOf(other).contains("_C\""));
    QCOMPARE(core::io::expandX3d({path, other.text}).text, other.text);
}

void TestX3dExpansion::axes_areOfUnitLength()
{
    const auto rotation = [](const QByteArray& attribute) {
        return valueOf(sceneOf("<Transform " + attribute + ">" + box + "</Transform>"), "rotation");
    };
    QCOMPARE(rotation("rotation='0 0 5 1.5'"), QStringLiteral("0 0 1 1.5"));
    const QStringList numbers = rotation("rotation='1 1 1 2'").split(u' ');
    QCOMPARE(numbers.size(), 4);
    double squares = 0;
    for (const QString& number : numbers.first(3))
        squares += number.toDouble() * number.toDouble();
    QVERIFY(std::abs(squares - 1) < 1e-12);
    QCOMPARE(numbers[3], QStringLiteral("2"));
    QCOMPARE(rotation("rotation='0 0 0 1'"), QString()); // without an axis there is no rotation
    for (int x = 1; x < 30; ++x) {                       // an axis that has been normalised stays bit for bit the same
        const QString once = rotation("rotation='" + QByteArray::number(x) + " 1 0 0.5'");
        QCOMPARE(rotation("rotation='" + once.toLatin1() + "'"), once);
    }
    QCOMPARE(valueOf(sceneOf("<Transform scaleOrientation='0 3 0 .5'>" + box + "</Transform>"), "scaleOrientation"),
             QStringLiteral("0 1 0 0.5"));
}

void TestX3dExpansion::namesOfPrototypes_holdInsideOnly()
{
    const QByteArray prototype = "<ProtoDeclare><ProtoBody><Shape DEF='S'><Sphere/></Shape></ProtoBody></ProtoDeclare>";
    const QString scene = sceneOf("<Shape DEF='S'><Box/></Shape>" + prototype + "<Group><Shape USE='S'/></Group>");
    QCOMPARE(scene.count("Sphere"), 0);
    QCOMPARE(scene.count("<Box"), 1);
    const auto error = errorOf(prototype + "<Shape USE='S'/>");
    QVERIFY(error);
    QCOMPARE(static_cast<int>(error->fault), static_cast<int>(FileFault::Missing));
}

/// A ring with a scale and an orientation for each point is closed like one without them.
void TestX3dExpansion::closedExtrusions_haveNoCaps()
{
    const QByteArray ring = "<Shape><Extrusion crossSection='1 1 1 -1 -1 -1 -1 1 1 1' "
                            "spine='5 0 0 0 0 5 -5 0 0 0 0 -5 5 0 0' ";
    const QString plain = sceneOf(ring + "/></Shape>");
    QCOMPARE(sceneOf(ring + "scale='1 1 1 1 1 1 1 1 1 1'/></Shape>"), plain);
    QCOMPARE(sceneOf(ring + "orientation='0 0 1 0 0 0 1 0 0 0 1 0 0 0 1 0 0 0 1 0'/></Shape>"), plain);
    QCOMPARE(valueOf(plain, "coordIndex").count(QStringLiteral("-1")), 16);
    QCOMPARE(valueOf(sceneOf(ring + "scale='1 1 1 1 1 1 1 1 2 2'/></Shape>"), "coordIndex").count(u"-1"), 18);
}

void TestX3dExpansion::doubledEnds_haveTheirSections_data()
{
    QTest::addColumn<QString>("spine");
    QTest::addColumn<int>("atBegin"); // repetitions of the first point
    QTest::addColumn<int>("atEnd");
    for (const char* spine : {"0 0 0 0 10 0 10 20 0", "0 0 0 0 0 5 3 0 9 9 1 9", "0 0 0 0 10 0"})
        for (const auto& [atBegin, atEnd] : {std::pair(1, 0), std::pair(0, 1), std::pair(2, 3)})
            QTest::addRow("%s: %d, %d", spine, atBegin, atEnd) << QString(spine) << atBegin << atEnd;
}

/// Tests spines that repeat their first or last point. The repetitions change nothing, unless a repeated point has a
/// cross-section of its own.
void TestX3dExpansion::doubledEnds_haveTheirSections()
{
    QFETCH(QString, spine);
    QFETCH(int, atBegin);
    QFETCH(int, atEnd);
    const auto extrusion = [](const QString& along, const QByteArray& attributes = {}) {
        return sceneOf("<Shape><Extrusion spine='" + along.toLatin1() + "' " + attributes + "/></Shape>");
    };
    const QStringList numbers = spine.split(u' ');
    const QString first = numbers.first(3).join(u' ') + u' ', last = u' ' + numbers.last(3).join(u' ');
    const QString plain = extrusion(spine), doubled = first.repeated(atBegin) + spine + last.repeated(atEnd);
    QCOMPARE(extrusion(doubled), plain);
    if (atBegin == 0) { // a smaller cross-section at the repeated last point makes a step in the cap
        const auto points = [](const QString& scene) { return valueOf(scene, "point").split(u' '); };
        const QByteArray ones = QByteArray("1 1 ").repeated(numbers.size() / 3);
        const QStringList stepped = points(extrusion(doubled, "scale='" + ones + "0.5 0.5'"));
        constexpr int sectionNumbers = 12; // coordinates of a cross-section of four corners
        QCOMPARE(stepped.size(), points(plain).size() + sectionNumbers);
        QCOMPARE(stepped.first(points(plain).size()), points(plain));
        for (int i = 0; i < sectionNumbers; ++i) {
            const auto of = [i](const QStringList& list) { return list[list.size() - sectionNumbers + i].toDouble(); };
            QVERIFY(std::abs(of(stepped) - (of(points(plain)) + numbers[numbers.size() - 3 + i % 3].toDouble()) / 2) <
                    1e-9);
        }
    }
}

void TestX3dExpansion::straightSpines_doNotTurn_data()
{
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("y");
    QTest::addColumn<double>("z");
    QTest::addColumn<int>("digits"); // significant digits of the written numbers
    for (const auto& [x, y, z] : {std::array{0.1, 0.2, 0.3}, {0.3, 0.7, 0.2}, {1.0, 2.0, 3.0}, {0.7, -0.1, 0.0}})
        for (const int digits : {6, 8, 16})
            QTest::addRow("%g %g %g, %d digits", x, y, z, digits) << x << y << z << digits;
}

/// Additional points on a straight part of the spine, with rounded coordinates, must not change its ends.
void TestX3dExpansion::straightSpines_doNotTurn()
{
    QFETCH(double, x);
    QFETCH(double, y);
    QFETCH(double, z);
    QFETCH(int, digits);
    const QByteArray bend = "2.5 7.5 5.25";
    const auto sections = [&](const std::vector<double>& along, bool isBent) {
        QByteArray spine;
        for (const double t : along)
            for (const double component : {x, y, z})
                spine += QByteArray::number(t * component, 'g', digits) + ' ';
        const QString scene = sceneOf("<Shape><Extrusion crossSection='1 .2 1 -.2 -1 -.2 -1 .2' spine='" + spine +
                                      (isBent ? bend : QByteArray()) + "'/></Shape>");
        return valueOf(scene, "point").split(u' ');
    };
    constexpr qsizetype sectionNumbers = 12;
    for (const bool isBent : {false, true}) {
        const QStringList two = sections({0, 5}, isBent), many = sections({0, 1, 1.7, 3, 5}, isBent);
        QCOMPARE(many.size(), two.size() + 3 * sectionNumbers);
        for (const bool atEnd : {false, true})
            for (qsizetype i = 0; i < sectionNumbers; ++i) {
                const auto at = [&](const QStringList& list) {
                    return list[atEnd ? list.size() - 1 - i : i].toDouble();
                };
                QVERIFY(std::abs(at(many) - at(two)) < (digits == 6 ? 1e-3 : 1e-5));
            }
    }
}

void TestX3dExpansion::grids_areMadeOfQuads()
{
    const auto grid = [](const QByteArray& attributes, const QByteArray& inside = {}) {
        return sceneOf("<Shape><ElevationGrid xDimension='3' zDimension='2' height='1 2 3 4 5,6 7' " + attributes +
                       ">" + inside + "</ElevationGrid></Shape>");
    };
    const QString plain = grid("xSpacing='10' zSpacing='.5'");
    QCOMPARE(valueOf(plain, "point"), QStringLiteral("0 1 0 10 2 0 20 3 0 0 4 0.5 10 5 0.5 20 6 0.5"));
    QCOMPARE(valueOf(plain, "coordIndex"), QStringLiteral("0 3 4 1 -1 1 4 5 2 -1"));
    QCOMPARE(valueOf(grid("ccw='false'"), "coordIndex"), QStringLiteral("1 4 3 0 -1 2 5 4 1 -1"));
    QCOMPARE(valueOf(grid(""), "point"), QStringLiteral("0 1 0 1 2 0 2 3 0 0 4 1 1 5 1 2 6 1"));
    QCOMPARE(valueOf(grid("colorPerVertex='false'", "<Color color='1 0 0 0 1 0'/>"), "color"),
             QStringLiteral("1 0 0 0 1 0 0 1 0 1 0 0 0 1 0 0 1 0")); // a point has the colour of its last face
    QCOMPARE(sceneOf("<Shape><ElevationGrid/></Shape><Shape><ElevationGrid xDimension='1' zDimension='9'/></Shape>"),
             QString());
}

/// Lists of numbers must be written with single spaces as separators.
void TestX3dExpansion::primitives_haveNumbers()
{
    QCOMPARE(sceneOf("<Shape><Box DEF='B' size=' .01,+.02, 3e-2' solid='true'/></Shape>").count("0.01 0.02 0.03\"/>"),
             1);
    QCOMPARE(valueOf(sceneOf("<Shape><Rectangle2D size='1,2'/></Shape>"), "size"), QStringLiteral("1 2"));
    QCOMPARE(valueOf(sceneOf("<Shape><TriangleSet2D vertices='0 0 1,0 1 1'/></Shape>"), "vertices"),
             QStringLiteral("0 0 1 0 1 1"));
    QCOMPARE(valueOf(sceneOf("<Shape><ArcClose2D radius='2' closureType='CHORD'/></Shape>"), "closureType"),
             QStringLiteral("CHORD"));
}

void TestX3dExpansion::unreadSurfaces_areCounted()
{
    QCOMPARE(expanded("<Shape><Text string='a'/></Shape>").unread, std::size_t(1));
    QCOMPARE(expanded("<Group><ProtoInstance name='x'/><GeoTransform>" + box + "</GeoTransform></Group>").unread,
             std::size_t(2));
    const QByteArray defined = "<Switch><Group DEF='P'><Group>" + box + "</Group></Group></Switch>";
    QCOMPARE(expanded(defined + "<HAnimHumanoid><HAnimJoint><Group USE='P'/></HAnimJoint></HAnimHumanoid>").unread,
             std::size_t(1));
    QCOMPARE(expanded(defined + "<HAnimHumanoid DEF='H'><Group USE='H'/></HAnimHumanoid>").unread, std::size_t(0));
    QCOMPARE(expanded("<Shape><Appearance/><LineSet/></Shape><Viewpoint/><Script/><PointLight/>").unread,
             std::size_t(0));
}

void TestX3dExpansion::badFiles_areRefused_data()
{
    QTest::addColumn<QByteArray>("scene");
    QTest::addColumn<int>("kind");
    QTest::addColumn<int>("fault");
    QTest::addColumn<QString>("token");
    const auto row = [](const char* name, const QByteArray& scene, FileFault fault, const char* token,
                        Kind kind = Kind::Malformed) {
        QTest::newRow(name) << scene << static_cast<int>(kind) << static_cast<int>(fault) << QString(token);
    };
    const auto set = [](const QByteArray& attributes) {
        return "<Shape><IndexedFaceSet " + attributes + ">" + points + "</IndexedFaceSet></Shape>";
    };
    row("holds itself", "\n<Group DEF='G'><Group USE='G'/></Group>", FileFault::TooDeep, "nodes of USE=G");
    row("not defined", "\n<Group USE='G'/>", FileFault::Missing, "DEF=G");
    row("no XML", "\n<Group>", FileFault::XmlSyntax, "mismatched tag");
    row("no index", "\n" + set("coordIndex='0 x 2'"), FileFault::VertexIndex, "x");
    row("negative", "\n" + set("coordIndex='0 -2 2'"), FileFault::VertexIndex, "-2");
    row("beyond", "\n" + set("coordIndex='0 1 6'"), FileFault::None, "6", Kind::IndexOutOfRange);
    const auto fans = [](const QByteArray& counts) {
        return "<Shape><TriangleFanSet fanCount='" + counts + "'>" + points + "</TriangleFanSet></Shape>";
    };
    row("fan beyond", "\n" + fans("7"), FileFault::None, "6", Kind::IndexOutOfRange);
    row("fans beyond", "\n" + fans("3 4"), FileFault::None, "6", Kind::IndexOutOfRange);
    row("fan of less than none", "\n" + fans("3 -1"), FileFault::Count, "-1");
    row("no coordinate",
        "\n<Shape><IndexedFaceSet coordIndex='0 1 2'><Coordinate point='0 0 0 1 abc 0 1 1 0'/>" +
            QByteArray("</IndexedFaceSet></Shape>"),
        FileFault::Number, "abc");
    for (const char* numbers : {"0 0 0 1 0 0 1 1 0 7", "0 0 0 1 0 0 1 1 0 7 7"})
        QTest::addRow("points of %s", numbers)
            << "\n<Shape><IndexedFaceSet coordIndex='0 1 2'><Coordinate point='" + QByteArray(numbers) +
                   "'/></IndexedFaceSet></Shape>"
            << static_cast<int>(Kind::Malformed) << static_cast<int>(FileFault::NotNumbers) << QStringLiteral("point");
    row("three numbers for four", "\n<Transform rotation='0 1 0'>" + box + "</Transform>", FileFault::Number, "0 1 0");
    row("no number", "\n<Shape><Cone height='a'/></Shape>", FileFault::Number, "a");
    const auto shape = [](const QByteArray& node) { return "\n<Shape><" + node + "/></Shape>"; };
    row("infinite", shape("Box size='1.#INF .01 .01'"), FileFault::Number, "1.#INF");
    row("number with a unit", shape("Sphere radius='0.01m'"), FileFault::Number, "0.01m");
    row("infinite angle", shape("ArcClose2D endAngle='inf'"), FileFault::Number, "inf");
    row("no numbers of triangles", shape("TriangleSet2D vertices='0 0 1 0 x 1'"), FileFault::Number, "x");
    row("two numbers for three", shape("Box size='1 2'"), FileFault::NotNumbers, "size");
    row("three numbers for two", shape("Rectangle2D size='1 2 3'"), FileFault::NotNumbers, "size");
    row("two radii", shape("Cylinder radius='1 5'"), FileFault::NotNumbers, "radius");
    row("two dimensions", shape("ElevationGrid xDimension='2 2' zDimension='2' height='0 0 0 0'"),
        FileFault::NotNumbers, "xDimension");
    row("no height", shape("ElevationGrid xDimension='2' zDimension='2' height='0 0 x 0'"), FileFault::Number, "x");
    row("too few heights", shape("ElevationGrid xDimension='2' zDimension='2' height='0 0 0'"), FileFault::NotNumbers,
        "height");
    row("far too few heights", shape("ElevationGrid xDimension='9999999999' zDimension='9999999999' height='0 0'"),
        FileFault::NotNumbers, "height");
    row("negative dimension", shape("ElevationGrid xDimension='-2' zDimension='-2' height='0 0 0 0'"), FileFault::Count,
        "-2");
    row("deep", "\n" + QByteArray("<Group>").repeated(300) + QByteArray("</Group>").repeated(300),
        FileFault::XmlTooDeep, "");
}

void TestX3dExpansion::badFiles_areRefused()
{
    QFETCH(QByteArray, scene);
    QFETCH(int, kind);
    QFETCH(int, fault);
    QFETCH(QString, token);
    const auto error = errorOf(scene);
    QVERIFY(error);
    QCOMPARE(static_cast<int>(error->kind), kind);
    QCOMPARE(static_cast<int>(error->fault), fault);
    QCOMPARE(QString::fromStdString(error->token), token);
    // the error is in line 3: the declaration and the scene's first line precede it
    QCOMPARE(error->place.number, std::uint64_t(3));
    const QByteArray entities = "<!DOCTYPE X3D [<!ENTITY a 'b'>]><X3D><Scene/></X3D>";
    QVERIFY_THROWS_EXCEPTION(core::FileError, core::io::expandX3d({path, entities.toStdString()}));
    QVERIFY(errorOf({}, "<head><unit category='length' conversionFactor='0'/></head>"));
}

/// Each group contains the previous one twice: 2^40 boxes in 3 kB.
void TestX3dExpansion::growth_isBounded()
{
    QByteArray scene = "<Group DEF='g0'>" + box + "</Group>";
    for (int i = 1; i < 40; ++i) {
        const QByteArray before = "<Group USE='g" + QByteArray::number(i - 1) + "'/>";
        scene += "<Switch><Group DEF='g" + QByteArray::number(i) + "'>" + before + before + "</Group></Switch>";
    }
    QVERIFY(!errorOf(scene));
    const auto many = errorOf(scene + "<Group USE='g39'/>");
    QVERIFY(many && many->kind == Kind::TooManyElements && many->token == "nodes");
    const QByteArray longText = "<Transform DEF='T'><Inline url='" + QByteArray(1 << 20, '1') + "'/></Transform>" +
                                QByteArray("<Transform USE='T'/>").repeated(200);
    const auto large = errorOf(longText);
    QVERIFY(large && large->kind == Kind::UnpacksTooLarge);
}

/// Each group uses the previous one, which nests deeper than the file itself does.
void TestX3dExpansion::chainsOfUses_areBounded()
{
    const auto chain = [](int length) {
        QByteArray scene = "<Switch><Group DEF='g0'>" + box + "</Group>";
        for (int i = 1; i < length; ++i)
            scene +=
                "<Group DEF='g" + QByteArray::number(i) + "'><Group USE='g" + QByteArray::number(i - 1) + "'/></Group>";
        return scene + "</Switch><Group USE='g" + QByteArray::number(length - 1) + "'/>";
    };
    QCOMPARE(sceneOf(chain(200)).count("<Box"), 1);
    const auto error = errorOf(chain(60'000));
    QVERIFY(error);
    QCOMPARE(static_cast<int>(error->fault), static_cast<int>(FileFault::TooDeep));
}

void TestX3dExpansion::cutFiles_areRefused()
{
    const std::string whole = expanded("<Transform DEF='T'>" + box + "</Transform><Transform USE='T'/>").text;
    const std::size_t end = whole.rfind('>');
    for (std::size_t length = 0; length < end; ++length) {
        const std::string cut = whole.substr(0, length);
        QVERIFY_THROWS_EXCEPTION(core::FileError, core::io::expandX3d({path, cut}));
    }
}

/// Tests files of other programs that deviate from the standard.
void TestX3dExpansion::wordsAndNames_areTakenGenerously()
{
    const auto set = [](const QByteArray& ccw, const QByteArray& coordinates) {
        return "<Shape><IndexedFaceSet ccw='" + ccw + "' coordIndex='0 1 2 -1'>" + coordinates +
               "</IndexedFaceSet></Shape>";
    };
    for (const char* no : {"false", "FALSE", "False", " false "})
        QCOMPARE(valueOf(sceneOf(set(no, points)), "coordIndex"), QStringLiteral("2 1 0 -1"));
    for (const char* yes : {"true", "TRUE", "", "fals", "falsee"})
        QCOMPARE(valueOf(sceneOf(set(yes, points)), "coordIndex"), QStringLiteral("0 1 2 -1"));
    QCOMPARE(valueOf(sceneOf(set("", "<CoordinateDouble point='0 0 0 1 0 0 0.1 1 0'/>")), "point"),
             QStringLiteral("0 0 0 1 0 0 0.1 1 0"));
    QCOMPARE(expanded(set("", "<GeoCoordinate point='0 0 0 1 0 0 0 1 0'/>")).unread, std::size_t(1));
    QCOMPARE(sceneOf("<Switch whichChoice=' 1 '><Group/>" + box + "</Switch>").count("<Box"), 1);
    QCOMPARE(sceneOf("<LOD><Group/>" + box + box + "</LOD>").count("<Box"), 1);
    const std::string text = "<x:X3D xmlns:x='u' xmlns:y='v'><x:Scene><x:Shape><x:Box/></x:Shape>"
                             "<y:Shape><y:Box/></y:Shape></x:Scene></x:X3D>";
    QCOMPARE(sceneOf(core::io::expandX3d({path, text})).count("<Box"), 1);
    for (const char* root :
         {"<X3D xmlns:y='http://www.web3d.org/specifications/x3d-3.3.xsd'><Scene>",
          "<X3D xmlns='u' xmlns:y='u'><Scene>", "<X3D><Scene xmlns:y='http://www.web3d.org/specifications/x3d'>",
          "<X3D xmlns:y='v'><Scene>", "<X3D><Scene>"}) {
        const std::string inner = root + std::string("<y:Shape><y:Box/></y:Shape></Scene></X3D>");
        QCOMPARE(sceneOf(core::io::expandX3d({path, inner})).count("<Box"),
                 inner.find("web3d") != std::string::npos || inner.find("'u'") != std::string::npos ? 1 : 0);
    }
}

/// Tests USE of a node of a wrong kind, and of the node that contains it.
void TestX3dExpansion::usesOfOtherKinds_areUnread()
{
    for (const QByteArray& scene : {box + "<Shape DEF='S'><IndexedFaceSet coordIndex='0 1 2'>" + points +
                                        "</IndexedFaceSet></Shape><Shape><IndexedFaceSet USE='S'/></Shape>",
                                    box + "<Shape DEF='S'><Shape USE='S'/></Shape>"}) {
        const X3dExpansion expansion = expanded(scene);
        QCOMPARE(expansion.unread, std::size_t(1));
        QVERIFY(!sceneOf(expansion).contains("<IndexedFaceSet USE"));
    }
}

void TestX3dExpansion::inlines_haveAlternatives()
{
    using Find = std::function<std::optional<std::string>(std::string_view)>;
    const auto inlineOf = [](const QByteArray& urls, const Find& find) {
        const std::string text = "<X3D><Scene><Inline url='" + urls.toStdString() + "'/></Scene></X3D>";
        return core::io::expandX3d({path, text}, {.find = find});
    };
    const Find hasB = [](std::string_view url) {
        return url == "b c.x3d" || url == "b%20c.x3d#view" ? std::optional<std::string>("b c.x3d") : std::nullopt;
    };
    const QByteArray urls = R"("http://a/b.x3d" "a.wrl", "b c.x3d" "d.x3d")";
    QCOMPARE(valueOf(sceneOf(inlineOf(urls, hasB)), "url"), QStringLiteral("b c.x3d"));
    QCOMPARE(inlineOf(urls, hasB).unread, std::size_t(0));
    QCOMPARE(valueOf(sceneOf(inlineOf(R"("b%20c.x3d" "b%20c.x3d#view")", hasB)), "url"), QStringLiteral("b c.x3d"));
    QCOMPARE(valueOf(sceneOf(inlineOf(urls, {})), "url"), QStringLiteral("http://a/b.x3d"));
    QCOMPARE(valueOf(sceneOf(inlineOf("b c.x3d", hasB)), "url"), QStringLiteral("b c.x3d"));
    for (const char* missing : {"a.x3d", "\"a.x3d\"", "\"a.x3d\" \"\"", "\"a.x3d\" \"b"}) {
        QVERIFY(!sceneOf(inlineOf(missing, hasB)).contains("<Inline"));
        QCOMPARE(inlineOf(missing, hasB).unread, std::size_t(1));
    }
    for (const char* none : {"", "\"\"", " , ", "\" \" \"\""}) {
        QCOMPARE(inlineOf(none, hasB).unread, std::size_t(0)); // the list contains no file name
        QCOMPARE(sceneOf(inlineOf(none, {})), QString());
    }
    for (const char* blank : {"\" a.x3d\"", "\",a.x3d\"", " a.x3d"})
        QCOMPARE(valueOf(sceneOf(inlineOf(blank, {})), "url"), QStringLiteral("a.x3d"));
}

/// A colour with thousands of digits is written in short form at each of its points.
void TestX3dExpansion::colors_areNumbers()
{
    QByteArray coordinates, indices;
    for (int i = 0; i < 3000; ++i) {
        coordinates += QByteArray::number(i) + " 0 0 ";
        indices += QByteArray::number(i) + (i % 3 == 2 ? " -1 " : " ");
    }
    const auto colored = [&](const QByteArray& color) {
        return "<Shape><IndexedFaceSet colorIndex='" + QByteArray("0 0 0 -1 ").repeated(1000) + "' coordIndex='" +
               indices + "'><Coordinate point='" + coordinates + "'/><Color color='" + color +
               "'/></IndexedFaceSet></Shape>";
    };
    const X3dExpansion expansion = expanded(colored("0." + QByteArray(20'000, '5') + " 0 1"));
    QVERIFY(expansion.text.size() < 200'000);
    const auto error = errorOf("\n" + colored("0 red 0"));
    QVERIFY(error && error->fault == FileFault::Number && error->token == "red");
}

/// Sets that use few points of a large shared Coordinate node must not each copy all of it.
void TestX3dExpansion::fewPoints_areTheSetsOwn()
{
    QByteArray coordinates, colors;
    for (int i = 0; i < 9; ++i) {
        coordinates += QByteArray::number(i) + " 0 " + QByteArray::number(i % 2) + " ";
        colors += "0." + QByteArray::number(i) + " 1 0 ";
    }
    const auto set = [](const QByteArray& indices, const QByteArray& inside) {
        return "<Shape><IndexedFaceSet coordIndex='" + indices + "'>" + inside + "</IndexedFaceSet></Shape>";
    };
    const QByteArray shared = "<Coordinate DEF='C' point='" + coordinates + "'/>",
                     color = "<Color color='" + colors + "'/>";
    const QString few = sceneOf(set("0 1 -1 8 6 2 -1 2 6 7", shared + color));
    QCOMPARE(valueOf(few, "point"), QStringLiteral("8 0 0 6 0 0 2 0 0 7 0 1"));
    QCOMPARE(valueOf(few, "coordIndex"), QStringLiteral("0 1 2 -1 2 1 3 -1"));
    QCOMPARE(valueOf(few, "color"), QStringLiteral("0.8 1 0 0.6 1 0 0.2 1 0 0.7 1 0"));
    const QString more = sceneOf(set("0 1 2 3 4", shared) + set("4 5 6 7 8", "<Coordinate USE='C'/>"));
    QCOMPARE(more.count("<Coordinate DEF"), 1);
    QCOMPARE(more.count("<Coordinate USE"), 1);
    QCOMPARE(valueOf(more, "point"), QString::fromLatin1(coordinates.trimmed()));
    const auto sizeOf = [&](int sets) {
        QByteArray scene = set("0 1 2", "<Coordinate DEF='C' point='" + coordinates.repeated(1000) + "'/>");
        for (int i = 1; i < sets; ++i)
            scene += set("8 6 2", "<Coordinate USE='C'/>");
        return expanded(scene).text.size();
    };
    QVERIFY(sizeOf(1) < 1000);
    QVERIFY(sizeOf(1000) < 1000 * sizeOf(1));
    // Sets that share colours, too, write each used colour once.
    QByteArray many = set("0 1 2", "<Coordinate DEF='C' point='" + coordinates.repeated(10'000) +
                                       "'/><Color DEF='K' color='" + colors.repeated(10'000) + "'/>");
    for (int i = 0; i < 10'000; ++i)
        many += set("8 6 2", "<Coordinate USE='C'/><Color USE='K'/>");
    QCOMPARE(sceneOf(many).count("<Color "), 10'001);
}

FETTLE_TEST(TestX3dExpansion)
#include "tst_x3d_expansion.moc"
