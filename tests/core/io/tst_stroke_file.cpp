#include "core/io/stroke/stroke_file.h"
#include "core/sculpt/deform/alpha.h"
#include "core/sculpt/deform/brush_model.h"
#include "tests/support/test_main.h"

#include <QElapsedTimer>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <fstream>
#include <random>
#include <sstream>

using namespace core;

namespace
{
/// Returns a file of one stroke with one sample. The arguments are inserted into their JSON objects.
std::string file(const std::string& stroke, const std::string& sample = R"("position":[1,0,0])")
{
    return R"({"format":"fettle-strokes","version":1,"strokes":[{"samples":[{)" + sample + "}]," + stroke + "}]}";
}
const std::string least = R"("tool":"pull","radius":0.25)";

std::optional<StrokeFileError> errorOf(const std::string& text)
{
    try {
        parseStrokes(text);
    } catch (const StrokeFileError& error) {
        return error;
    }
    return std::nullopt;
}

/// Returns the strokes of a file that contains no commands.
std::vector<Stroke> strokesOf(const std::string& text)
{
    std::vector<Stroke> strokes;
    for (FileEntry& entry : parseStrokes(text))
        strokes.push_back(std::get<Stroke>(std::move(entry)));
    return strokes;
}

bool same(const Stroke& a, const Stroke& b)
{
    std::ostringstream left, right;
    writeStrokes(left, {a});
    writeStrokes(right, {b});
    return left.str() == right.str();
}

Stroke randomStroke(std::mt19937_64& random)
{
    const auto between = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
    Stroke stroke;
    stroke.settings.tool = static_cast<Tool>(random() % toolNames().size());
    stroke.settings.inverted = random() % 2 == 0;
    stroke.settings.brush = static_cast<BrushShape>(random() % 2);
    stroke.settings.topology = static_cast<Topology>(random() % 2);
    stroke.settings.symmetry = static_cast<Symmetry>(random() % 4);
    stroke.settings.radial = random() % 2 == 0 ? 1 : 1 + static_cast<int>(random() % 32);
    stroke.settings.add = random() % 2 == 0;
    stroke.settings.join = random() % 2 == 0;
    if (random() % 2)
        stroke.settings.alpha = builtInAlpha(builtInAlphas()[random() % builtInAlphas().size()]);
    else if (random() % 2)
        stroke.alpha = {"marks/\"a\".png", random() % 2 ? "0123456789abcdef" : ""};
    stroke.settings.alphaFollows = random() % 2 == 0;
    stroke.settings.anchored = random() % 2 == 0;
    if (random() % 2)
        stroke.model = {"models/a.stl", "fedcba9876543210"};
    stroke.settings.detailLength = random() % 2 ? 0 : between(0.01, 1);
    stroke.settings.color = {static_cast<std::uint8_t>(random()), 7, 255};
    stroke.settings.place = static_cast<Placement>(random() % 3);
    stroke.settings.radius = between(1e-3, 10);
    stroke.settings.strength = between(0, 10);
    stroke.settings.falloff = random() % 4 == 0 ? 0 : 3 + static_cast<int>(random() % 14);
    stroke.settings.detail = between(0.1, 4);
    stroke.settings.spacing = random() % 2 ? 0 : between(0.01, 1);
    stroke.settings.airbrush = random() % 2 ? 0 : between(core::minAirbrush, core::maxAirbrush);
    for (int i = 0; i < 5; ++i) {
        StrokeSample sample;
        sample.time = between(0, 100);
        sample.position = Vec3(between(-1, 1), between(-1, 1), between(-1e-300, 1e-300));
        sample.direction = Vec3(between(-1, 1), 1, between(-1, 1));
        sample.pressure = between(0, 1);
        sample.rotation =
            Eigen::Quaterniond(between(0.1, 1), between(-1, 1), between(-1, 1), between(-1, 1)).normalized();
        if (random() % 2)
            sample.radius = between(0.1, 1);
        if (random() % 2)
            sample.strength = between(0, 10);
        if (random() % 2)
            sample.up = Vec3(between(-1, 1), between(-1, 1), between(1e-3, 1));
        stroke.samples.push_back(sample);
    }
    return stroke;
}
} // namespace

class TestStrokeFile : public QObject
{
    Q_OBJECT

    using Kind = StrokeFileError::Kind;

private Q_SLOTS:
    void defaults_areTheDesigns();
    void values_arriveWhereTheyBelong();
    void keys_mayComeInAnyOrder();
    void writing_andReadingGivesTheSameBits();
    void shapes_areNamed();
    void turntable_isRotationAboutY();
    void rotation_isNormalised();
    void symmetry_isAPlaneOrTrueForThePapers();
    void accepts_data();
    void accepts();
    void refuses_data();
    void refuses();
    void refusal_saysTheType();
    void refusal_namesStrokeAndSample();
    void refusal_namesLineAndByteOfSyntax();
    void refusal_ofDepthIsImmediate();
    void refusal_atEachTruncation();
    void reads_aMillionSamples();
    void commands_roundTrip();
    void axisOfATube_isNotWritten();
    void partCommands_roundTrip();
    void readStrokes_refusesWhatIsNoFile();
    void readStrokes_takesAStream();
};

void TestStrokeFile::defaults_areTheDesigns()
{
    const std::vector<Stroke> strokes = strokesOf(file(least));
    QCOMPARE(strokes.size(), std::size_t(1));
    const StrokeSettings& settings = strokes[0].settings;
    QVERIFY(settings.tool == Tool::Pull && settings.brush == BrushShape::Sphere && settings.place == Placement::Point);
    QCOMPARE(settings.radius, 0.25);
    QCOMPARE(settings.strength, 1.0);
    QCOMPARE(settings.falloff, 4);
    QCOMPARE(settings.detail, 1.0);
    QCOMPARE(settings.spacing, 0.0);
    const StrokeSample& sample = strokes[0].samples.at(0);
    QVERIFY(sample.position == Vec3(1, 0, 0));
    QCOMPARE(sample.time, 0.0);
    QCOMPARE(sample.pressure, 1.0);
    QVERIFY(sample.rotation.coeffs() == Eigen::Quaterniond::Identity().coeffs());
    QVERIFY(!sample.radius && !sample.strength);
}

void TestStrokeFile::values_arriveWhereTheyBelong()
{
    const Stroke stroke =
        strokesOf(file(
                      R"("tool":"smooth","brush":"ray","radius":2.5,"strength":3,"falloff":16,"detail":0.5,
           "topology":"uniform","detail_length":0.125,"fusion":true,"symmetry":"z","radial":6,"spacing":0.25,
           "airbrush":10,
           "place":"ray","add":true,"invert":true,"color":[200,120,80])",
                      R"("t":1.5,"position":[1,2,3],"direction":[0,0,-1],"pressure":0.5,"rotation":[0,1,0,0],
           "radius":4,"strength":0,"up":[0,2,-1])"))
            .at(0);
    QVERIFY(stroke.settings.tool == Tool::Smooth && stroke.settings.place == Placement::Ray);
    QCOMPARE(stroke.settings.radius, 2.5);
    QCOMPARE(stroke.settings.strength, 3.0);
    QCOMPARE(stroke.settings.falloff, 16);
    QCOMPARE(stroke.settings.detail, 0.5);
    QCOMPARE(stroke.settings.spacing, 0.25);
    QCOMPARE(stroke.settings.airbrush, 10.0);
    QCOMPARE(stroke.settings.detailLength, 0.125);
    QVERIFY(stroke.settings.brush == BrushShape::Ray && stroke.settings.topology == Topology::Uniform);
    QVERIFY(stroke.settings.symmetry == Symmetry::Z);
    QCOMPARE(stroke.settings.radial, 6);
    QVERIFY(stroke.settings.inverted);
    QVERIFY(stroke.settings.add && stroke.settings.color == (Rgb{200, 120, 80}));
    const StrokeSample& sample = stroke.samples.at(0);
    QCOMPARE(sample.time, 1.5);
    QVERIFY(sample.position == Vec3(1, 2, 3) && sample.direction == Vec3(0, 0, -1));
    QCOMPARE(sample.pressure, 0.5);
    QVERIFY(sample.rotation.coeffs() == Eigen::Vector4d(0, 1, 0, 0));
    QCOMPARE(sample.radius.value(), 4.0);
    QCOMPARE(sample.strength.value(), 0.0);
    QVERIFY(sample.up.value() == Vec3(0, 2, -1));
}

void TestStrokeFile::keys_mayComeInAnyOrder()
{
    const auto strokes = strokesOf(
        R"({"strokes":[{"samples":[{"t":1,"position":[1,2,3]},{"position":[4,5,6]}],"radius":1,"tool":"push"},
            {"radius":1,"samples":[],"tool":"pull"}],"version":1.0,"format":"fettle-strokes"})");
    QCOMPARE(strokes.size(), std::size_t(2));
    QCOMPARE(strokes[0].samples.size(), std::size_t(2));
    QVERIFY(strokes[0].samples[1].position == Vec3(4, 5, 6));
    QVERIFY(strokes[1].samples.empty());
}

/// Built-in alphas are found by name. Alphas and models in files keep their file name.
void TestStrokeFile::shapes_areNamed()
{
    const Stroke read = strokesOf(file(least + R"(,"alpha":"star","alpha_follows":true,"model":"a.stl")")).at(0);
    QCOMPARE(read.settings.alpha, builtInAlpha("star"));
    QVERIFY(read.alpha.file.empty() && read.settings.alphaFollows && !read.settings.model);
    QCOMPARE(read.model.file, std::string("a.stl"));
    Stroke stroke;
    stroke.settings.alpha = std::make_shared<Alpha>(1, 1, std::vector<std::uint8_t>{9}, "/pictures/mark.png");
    stroke.settings.model = BrushModel::of(icosphere(1, 1), "/models/ball.stl").model;
    std::ostringstream text;
    writeStrokes(text, {stroke});
    const Stroke again = strokesOf(text.str()).at(0);
    QVERIFY(!again.settings.alpha && !again.settings.model);
    QCOMPARE(again.alpha.file, std::string("/pictures/mark.png"));
    QCOMPARE(again.alpha.fingerprint, stroke.settings.alpha->fingerprint());
    QCOMPARE(again.model.file, std::string("/models/ball.stl"));
    QCOMPARE(again.model.fingerprint, stroke.settings.model->fingerprint());
    QVERIFY(same(stroke, again));
}

void TestStrokeFile::writing_andReadingGivesTheSameBits()
{
    std::mt19937_64 random(1);
    std::vector<Stroke> strokes;
    for (int i = 0; i < 100; ++i)
        strokes.push_back(randomStroke(random));
    std::ostringstream out;
    writeStrokes(out, {strokes.begin(), strokes.end()});
    const std::vector<Stroke> back = strokesOf(out.str());
    QCOMPARE(back.size(), strokes.size());
    for (std::size_t i = 0; i < back.size(); ++i) {
        QVERIFY(same(back[i], strokes[i]));
        for (std::size_t j = 0; j < back[i].samples.size(); ++j) {
            QVERIFY(back[i].samples[j].position == strokes[i].samples[j].position);
            QVERIFY(back[i].samples[j].rotation.coeffs() == strokes[i].samples[j].rotation.coeffs());
            QVERIFY(back[i].samples[j].radius == strokes[i].samples[j].radius);
            QVERIFY(back[i].samples[j].up == strokes[i].samples[j].up);
        }
    }
}

void TestStrokeFile::turntable_isRotationAboutY()
{
    for (const double t : {0.0, 0.25, 1.0, 7.5, -3.0}) {
        const Stroke stroke =
            strokesOf(file(least + R"(,"turntable_deg_per_s":36)", R"("position":[1,0,0],"t":)" + std::to_string(t)))
                .at(0);
        const double angle = 36 * t * 3.14159265358979323846 / 180;
        const Vec3 turned = stroke.samples.at(0).rotation * Vec3(1, 0, 0);
        QVERIFY((turned - Vec3(std::cos(angle), 0, -std::sin(angle))).norm() < 1e-14);
    }
    const auto plain = strokesOf(file(least + R"(,"turntable_deg_per_s":0)")).at(0);
    QVERIFY(plain.samples[0].rotation.coeffs() == Eigen::Quaterniond::Identity().coeffs());
}

void TestStrokeFile::rotation_isNormalised()
{
    const auto stroke = strokesOf(file(least, R"("position":[1,0,0],"rotation":[0,0.7071,0,0.7071])")).at(0);
    QVERIFY(std::abs(stroke.samples[0].rotation.norm() - 1) < 1e-15);
}

void TestStrokeFile::symmetry_isAPlaneOrTrueForThePapers()
{
    const auto planeOf = [](const std::string& value) {
        return strokesOf(file(least + R"(,"symmetry":)" + value)).at(0).settings.symmetry;
    };
    QVERIFY(planeOf(R"("none")") == Symmetry::None && planeOf("false") == Symmetry::None);
    QVERIFY(planeOf(R"("x")") == Symmetry::X && planeOf(R"("z")") == Symmetry::Z);
    QVERIFY(planeOf(R"("y")") == Symmetry::Y && planeOf("true") == Symmetry::Y);
}

void TestStrokeFile::accepts_data()
{
    QTest::addColumn<QString>("stroke");
    const auto row = [](const char* text) { QTest::newRow(text) << QString::fromUtf8(text); };
    row(R"("tool":"pull","radius":1e-6)");
    row(R"("tool":"pull","radius":1,"fusion":false)");
    row(R"("tool":"pull","radius":1,"fusion":true)");
    row(R"("tool":"pull","radius":1,"symmetry":false)");
    row(R"("tool":"pull","radius":1,"falloff":0)");
    row(R"("tool":"pull","radius":1,"falloff":4.0)");
    row(R"("tool":"pull","radius":1,"strength":0)");
    row(R"("tool":"pull","radius":1,"place":"nearest")");
    row(R"("tool":"\u0070ull","radius":1)");
}

void TestStrokeFile::accepts()
{
    QFETCH(QString, stroke);
    QVERIFY(!errorOf(file(stroke.toStdString())));
}

void TestStrokeFile::refuses_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<Kind>("kind");
    QTest::addColumn<QString>("key");
    const auto row = [](const std::string& text, Kind kind, const char* key) {
        QTest::newRow(text.substr(0, 150).c_str()) << QString::fromStdString(text) << kind << QString::fromUtf8(key);
    };
    const auto stroke = [&](const std::string& more, Kind kind, const char* key) {
        row(file(least + "," + more), kind, key);
    };
    const auto sample = [&](const std::string& more, Kind kind, const char* key) { row(file(least, more), kind, key); };
    const std::string at = R"("position":[1,0,0],)";

    row("", Kind::Syntax, "");
    row("solid pipe\n", Kind::Syntax, "");
    row("{}", Kind::NotStrokes, "format");
    for (const char* other : {"[]", "1", "null", "true", "\"fettle-strokes\"", R"({"asset":{}})"})
        QVERIFY(errorOf(other)->kind == Kind::NotStrokes);
    row(R"({"format":"gcode"})", Kind::NotStrokes, "format");
    row(R"({"format":"fettle-strokes","version":2,"strokes":[]})", Kind::NotStrokes, "version");
    row(R"({"format":"fettle-strokes","strokes":[]})", Kind::MissingKey, "version");
    row(R"({"format":"fettle-strokes","version":1})", Kind::MissingKey, "strokes");
    row(R"({"format":"fettle-strokes","version":"1","strokes":[]})", Kind::WrongType, "version");
    row(R"({"format":"fettle-strokes","version":1,"strokes":{}})", Kind::WrongType, "strokes");
    row(R"({"format":"fettle-strokes","version":1,"strokes":[1]})", Kind::WrongType, "strokes");
    row(R"({"format":"fettle-strokes","version":1,"strokes":[[]]})", Kind::WrongType, "strokes");
    row(R"({"format":"fettle-strokes","version":1,"strokes":[],"more":1})", Kind::UnknownKey, "more");
    row(R"({"format":"fettle-strokes","version":1,"strokes":[]} x)", Kind::Syntax, "strokes");
    row(R"({"format":"fettle-strokes","version":1,"version":1,"strokes":[]})", Kind::DuplicateKey, "version");

    row(file(R"("radius":1)"), Kind::MissingKey, "tool");
    row(file(R"("tool":"pull")"), Kind::MissingKey, "radius");
    row(R"({"format":"fettle-strokes","version":1,"strokes":[{"tool":"pull","radius":1}]})", Kind::MissingKey,
        "samples");
    row(file(R"("radius":1,"tool":"melt")"), Kind::UnknownValue, "tool: \"melt\"");
    row(file(R"("radius":1,"tool":1)"), Kind::WrongType, "tool");
    row(file(R"("radius":1,"tool":null)"), Kind::WrongType, "tool");
    for (const char* bad : {"0", "-1", "1e-7", "1e7", "1e300", "1e-320"})
        row(file(R"("tool":"pull","radius":)" + std::string(bad)), Kind::OutOfRange, "radius");
    for (const char* bad : {"1e999", "-1e999", "NaN", "Infinity", "-Infinity"})
        row(file(R"("tool":"pull","radius":)" + std::string(bad)), Kind::NotANumber, "radius");
    row(file(R"("tool":"pull","radius":"1")"), Kind::WrongType, "radius");
    row(file(R"("tool":"pull","radius":[1])"), Kind::WrongType, "radius");
    row(file(R"("tool":"pull","radius":true)"), Kind::WrongType, "radius");
    row(file(R"("tool":"pull","radius":{})"), Kind::WrongType, "radius");

    stroke(R"("Radius":1)", Kind::UnknownKey, "Radius");
    stroke(R"("":1)", Kind::UnknownKey, "\"\"");
    stroke(R"("radius":1)", Kind::DuplicateKey, "radius");
    stroke(R"("brush":"cube")", Kind::UnknownValue, "brush: \"cube\"");
    stroke(R"("strength":10.5)", Kind::OutOfRange, "strength");
    stroke(R"("strength":-1)", Kind::OutOfRange, "strength");
    for (const char* bad : {"1", "2", "17", "-3"})
        stroke(R"("falloff":)" + std::string(bad), Kind::OutOfRange, "falloff");
    stroke(R"("falloff":3.5)", Kind::WrongType, "falloff");
    stroke(R"("detail":0)", Kind::OutOfRange, "detail");
    stroke(R"("detail_length":0)", Kind::OutOfRange, "detail_length");
    stroke(R"("topology":"none")", Kind::UnknownValue, "topology: \"none\"");
    stroke(R"("fusion":1)", Kind::WrongType, "fusion");
    stroke(R"("symmetry":1)", Kind::WrongType, "symmetry");
    stroke(R"("symmetry":"w")", Kind::UnknownValue, "symmetry: \"w\"");
    for (const char* bad : {"0", "33", "-2", "1e300"})
        stroke(R"("radial":)" + std::string(bad), Kind::OutOfRange, "radial");
    stroke(R"("radial":2.5)", Kind::WrongType, "radial");
    stroke(R"("radial":"6")", Kind::WrongType, "radial");
    stroke(R"("airbrush":61)", Kind::OutOfRange, "airbrush");
    stroke(R"("airbrush":-1)", Kind::OutOfRange, "airbrush");
    stroke(R"("airbrush":true)", Kind::WrongType, "airbrush");
    stroke(R"("spacing":5)", Kind::OutOfRange, "spacing");
    stroke(R"("spacing":1e-12)", Kind::OutOfRange, "spacing");
    stroke(R"("spacing":-0.1)", Kind::OutOfRange, "spacing");
    stroke(R"("place":"floor")", Kind::UnknownValue, "place: \"floor\"");
    stroke(R"("add":"no")", Kind::WrongType, "add");
    stroke(R"("invert":1)", Kind::WrongType, "invert");
    stroke(R"("alpha":"")", Kind::UnknownValue, "alpha: \"\"");
    stroke(R"("alpha":3)", Kind::WrongType, "alpha");
    stroke(R"("alpha_follows":"yes")", Kind::WrongType, "alpha_follows");
    stroke(R"("anchored":1)", Kind::WrongType, "anchored");
    stroke(R"("model":"")", Kind::UnknownValue, "model: \"\"");
    stroke(R"("model":true)", Kind::WrongType, "model");
    stroke(R"("color":[1,2])", Kind::WrongType, "color");
    stroke(R"("color":[1,2,256])", Kind::OutOfRange, "color");
    stroke(R"("color":[1,2,0.5])", Kind::WrongType, "color");
    stroke(R"("color":"red")", Kind::WrongType, "color");
    stroke(R"("turntable_deg_per_s":1e10)", Kind::OutOfRange, "turntable_deg_per_s");
    stroke(R"("place":"ray","note":1)", Kind::UnknownKey, "note");

    stroke(R"("up":[0,1,0])", Kind::UnknownKey, "up");
    sample(at + R"("up":[0,0,0])", Kind::OutOfRange, "up");
    sample(at + R"("up":[0,1e10,0])", Kind::OutOfRange, "up");
    sample(at + R"("up":[0,1])", Kind::WrongType, "up");
    sample(at + R"("up":[0,1,0,0])", Kind::WrongType, "up");
    sample(at + R"("up":"y")", Kind::WrongType, "up");

    stroke(R"("by":[1,0,0])", Kind::UnknownKey, "by");
    const auto command = [&](const std::string& keys, Kind kind, const char* key) {
        row(R"({"format":"fettle-strokes","version":1,"strokes":[{)" + keys + "}]}", kind, key);
    };
    command(R"("command":"melt")", Kind::UnknownValue, "command: \"melt\"");
    command(R"("command":1)", Kind::WrongType, "command");
    command(R"("command":"move")", Kind::MissingKey, "by");
    command(R"("command":"move","by":[1,0])", Kind::WrongType, "by");
    command(R"("command":"move","by":[1e10,0,0])", Kind::OutOfRange, "by");
    command(R"("command":"move","by":[1,0,0],"factor":2)", Kind::UnknownKey, "factor");
    command(R"("command":"move","by":[1,0,0],"radius":2)", Kind::UnknownKey, "radius");
    command(R"("by":[1,0,0],"tool":"pull","command":"move")", Kind::UnknownKey, "tool");
    command(R"("command":"move","command":"move","by":[1,0,0])", Kind::DuplicateKey, "command");
    command(R"("command":"rotate","rotation":[0,0,0,2])", Kind::OutOfRange, "rotation");
    command(R"("command":"rotate","rotation":[0,0,1])", Kind::WrongType, "rotation");
    for (const char* bad : {"0", "-1", "1e-7", "1e7"})
        command(R"("command":"scale","factor":)" + std::string(bad), Kind::OutOfRange, "factor");
    command(R"("command":"mirror")", Kind::MissingKey, "plane");
    command(R"("command":"mirror","plane":"none")", Kind::UnknownValue, "plane: \"none\"");
    command(R"("command":"recentre","plane":"x")", Kind::UnknownKey, "plane");
    command(R"("command":"fill")", Kind::MissingKey, "color");
    command(R"("command":"fill","color":[1,2,256])", Kind::OutOfRange, "color");
    command(R"("command":"remesh","detail_length":0)", Kind::OutOfRange, "detail_length");
    command(R"("command":"symmetrize","plane":"x","keep":"left")", Kind::UnknownValue, "keep: \"left\"");
    command(R"("command":"flatten_base")", Kind::MissingKey, "height");
    command(R"("command":"mask")", Kind::MissingKey, "how");
    command(R"("command":"mask","how":"harder")", Kind::UnknownValue, "how: \"harder\"");
    command(R"("command":"mask","how":"color")", Kind::MissingKey, "color");
    command(R"("command":"mask","how":"grow","color":[1,2,3])", Kind::UnknownKey, "color");
    command(R"("command":"flatten_base","height":0)", Kind::OutOfRange, "height");
    command(R"("command":"place_on_bed","height":1)", Kind::UnknownKey, "height");
    command(R"("command":"edit_part")", Kind::MissingKey, "name");
    command(R"("command":"edit_part","name":5)", Kind::WrongType, "name");
    command(R"("command":"edit_part","name":"a","list_position":1001)", Kind::OutOfRange, "list_position");
    command(R"("command":"edit_part","name":"a","locked":1)", Kind::WrongType, "locked");
    command(R"("command":"show_parts")", Kind::MissingKey, "parts");
    command(R"("command":"show_parts","parts":3)", Kind::WrongType, "parts");
    command(R"("command":"show_parts","parts":[0.5])", Kind::WrongType, "parts");
    command(R"("command":"show_parts","parts":[-1])", Kind::OutOfRange, "parts");
    command(R"("command":"show_parts","parts":[[1]])", Kind::WrongType, "parts");
    command(R"("command":"move","by":[1,0,0],"part":32768)", Kind::OutOfRange, "part");
    command(R"("command":"combine_parts","parts":[1],"operation":"xor")", Kind::UnknownValue, "operation: \"xor\"");
    command(R"("command":"hide","what":"parts")", Kind::UnknownValue, "what: \"parts\"");
    command(R"("command":"delete_part","parts":[1])", Kind::UnknownKey, "parts");
    command(R"("command":"trim","along":[0,0,9])", Kind::MissingKey, "outline");
    command(R"("command":"trim","outline":[],"eye":[0,0,9])", Kind::MissingKey, "along");
    command(R"("command":"trim","outline":[],"along":[0,0,0])", Kind::OutOfRange, "along");
    command(R"("command":"trim","outline":[1,2,3],"along":[0,0,1])", Kind::WrongType, "outline");
    command(R"("command":"trim","outline":[[1,2]],"along":[0,0,1])", Kind::WrongType, "outline");
    command(R"("command":"trim","outline":[[1,2,3,4]],"along":[0,0,1])", Kind::WrongType, "outline");
    command(R"("command":"trim","outline":[[[1,2,3]]],"along":[0,0,1])", Kind::WrongType, "outline");
    command(R"("command":"trim","outline":["a"],"along":[0,0,1])", Kind::WrongType, "outline");
    command(R"("command":"trim","outline":[],"along":[0,0,1],"remove":"left")", Kind::UnknownValue, "remove: \"left\"");
    command(R"("command":"trim","outline":[],"along":[0,0,1],"symmetry":"w")", Kind::UnknownValue, "symmetry: \"w\"");
    command(R"("command":"trim","outline":[],"along":[0,0,1],"plane":"x")", Kind::UnknownKey, "plane");
    command(R"("command":"trim","outline":[],"along":[0,0,1],"side":"inside")", Kind::UnknownKey, "side");
    command(R"("command":"hide_area","outline":[],"along":[0,0,1],"remove":"inside")", Kind::UnknownKey, "remove");
    command(R"("command":"hide_area","outline":[],"along":[0,0,1],"side":"left")", Kind::UnknownValue,
            "side: \"left\"");
    command(R"("command":"mask_area","outline":[],"along":[0,0,1],"front":1)", Kind::WrongType, "front");
    command(R"("command":"split_part","along":[0,0,1])", Kind::MissingKey, "outline");
    command(R"("command":"move","by":[1,0,0],"eye":[0,0,9])", Kind::UnknownKey, "eye");
    command(R"("command":"insert")", Kind::MissingKey, "file");
    command(R"("command":"insert","file":"")", Kind::UnknownValue, "file: \"\"");
    command(R"("command":"insert","file":"a.stl","centre":[0,0,0])", Kind::UnknownKey, "centre");
    command(R"("command":"insert","file":"a.stl","where":"centre")", Kind::MissingKey, "centre");
    command(R"("command":"insert","file":"a.stl","where":"floor")", Kind::MissingKey, "centre");
    command(R"("command":"insert","file":"a.stl","combine":"melt")", Kind::UnknownValue, "combine: \"melt\"");
    command(R"("command":"insert","file":"a.stl","combine":"join","name":"a")", Kind::UnknownKey, "name");
    command(R"("command":"insert","file":"a.stl","primitive":"ball","radius":1)", Kind::UnknownKey, "file");
    command(R"("command":"insert","file":"a.stl","edge_length":1)", Kind::UnknownKey, "edge_length");
    command(R"("command":"insert","primitive":"blob")", Kind::UnknownValue, "primitive: \"blob\"");
    command(R"("command":"insert","primitive":"ball")", Kind::MissingKey, "radius");
    command(R"("command":"insert","primitive":"ball","radius":1,"height":1)", Kind::UnknownKey, "height");
    command(R"("command":"insert","primitive":"ball","radius":1,"axis":"w")", Kind::UnknownValue, "axis: \"w\"");
    command(R"("command":"insert","primitive":"tube","path":[[0,0,0,1],[9,0,0,1]],"along":[1,0,0])", Kind::UnknownKey,
            "along");
    command(R"("command":"insert","primitive":"capsule","radius":1,"height":3,"axis":"x","along":[1,0,0])",
            Kind::UnknownKey, "axis");
    command(R"("command":"insert","primitive":"capsule","radius":1,"height":3,"along":[0,0,0])", Kind::OutOfRange,
            "along");
    command(R"("command":"insert","file":"a.stl","along":[1,0,0])", Kind::UnknownKey, "along");
    command(R"("command":"insert","primitive":"torus","radius":1,"tube_radius":0)", Kind::OutOfRange, "tube_radius");
    command(R"("command":"insert","primitive":"cone","radius":1,"top_radius":-1,"height":1)", Kind::OutOfRange,
            "top_radius");
    command(R"("command":"insert","primitive":"lathe")", Kind::MissingKey, "profile");
    for (const char* bad : {"1", "\"a\"", "[1,2]", "[[1]]", "[[1,2,3]]", "[[[1]]]", "[[1,2],3]", "{}", "true"})
        command(R"("command":"insert","primitive":"lathe","profile":)" + std::string(bad), Kind::WrongType, "profile");
    command(R"("command":"insert","primitive":"tube")", Kind::MissingKey, "path");
    command(R"("command":"insert","primitive":"tube","path":[[0,0,0,1]],"profile":[[1,2]])", Kind::UnknownKey,
            "profile");
    for (const char* bad : {"1", "[1,2,3,4]", "[[1,2,3]]", "[[1,2,3,4,5]]", "[[1,2,3,\"4\"]]"})
        command(R"("command":"insert","primitive":"tube","path":)" + std::string(bad), Kind::WrongType, "path");

    sample("", Kind::MissingKey, "position");
    sample(R"("position":[1,0])", Kind::WrongType, "position");
    sample(R"("position":[1,0,0,0])", Kind::WrongType, "position");
    sample(R"("position":[1,0,"0"])", Kind::WrongType, "position");
    sample(R"("position":[1,0,[0]])", Kind::WrongType, "position");
    sample(R"("position":[1,0,null])", Kind::WrongType, "position");
    sample(R"("position":[1,0,true])", Kind::WrongType, "position");
    sample(R"("position":[1,0,NaN])", Kind::NotANumber, "position");
    sample(R"("position":[1,0,1e400])", Kind::NotANumber, "position");
    sample(R"("position":[1,0,1e40])", Kind::OutOfRange, "position");
    sample(R"("position":1)", Kind::WrongType, "position");
    sample(R"("position":{"x":1})", Kind::WrongType, "position");
    sample(at + R"("pressure":1.5)", Kind::OutOfRange, "pressure");
    sample(at + R"("pressure":-0.5)", Kind::OutOfRange, "pressure");
    sample(at + R"("t":"now")", Kind::WrongType, "t");
    sample(at + R"("t":1e300)", Kind::OutOfRange, "t");
    sample(at + R"("rotation":[0,0,0,0])", Kind::OutOfRange, "rotation");
    sample(at + R"("rotation":[0,0,0,2])", Kind::OutOfRange, "rotation");
    sample(at + R"("rotation":[0,0,0])", Kind::WrongType, "rotation");
    sample(at + R"("radius":0)", Kind::OutOfRange, "radius");
    sample(at + R"("strength":11)", Kind::OutOfRange, "strength");
    sample(at + R"("position":[1,0,0])", Kind::DuplicateKey, "position");
    sample(at + R"("tilt":1)", Kind::UnknownKey, "tilt");
    row(file(least + R"(,"place":"ray")", at + R"("direction":[0,0,0])"), Kind::OutOfRange, "direction");
    row(file(least + R"(,"place":"ray")"), Kind::MissingKey, "direction");
    row(file(least + R"(,"brush":"ray")"), Kind::MissingKey, "direction");
}

void TestStrokeFile::refuses()
{
    QFETCH(QString, text);
    QFETCH(Kind, kind);
    QFETCH(QString, key);
    const auto error = errorOf(text.toStdString());
    QVERIFY(error);
    QCOMPARE(static_cast<int>(error->kind), static_cast<int>(kind));
    if (kind != Kind::Syntax)
        QCOMPARE(QString::fromStdString(error->key), key);
}

/// A value of a wrong type is refused with the type that the key takes.
void TestStrokeFile::refusal_saysTheType()
{
    using Value = StrokeFileError::Value;
    const std::pair<const char*, Value> rows[] = {
        {R"("command":"transform","centre":[0,0,0],"scale":2)", Value::ThreeNumbers},
        {R"("command":"transform","centre":[0,0,0],"scale_axes":2)", Value::FourNumbers},
        {R"("command":"trim","along":2)", Value::ThreeNumbers},
        {R"("command":"trim","eye":2)", Value::ThreeNumbers},
        {R"("command":"trim","outline":2)", Value::Triples},
        {R"("command":"trim","front":1)", Value::TrueOrFalse},
        {R"("command":"insert","primitive":"tube","path":2)", Value::Quadruples},
        {R"("command":"insert","primitive":"lathe","profile":2)", Value::Pairs},
    };
    for (const auto& [keys, wanted] : rows) {
        const auto error =
            errorOf(R"({"format":"fettle-strokes","version":1,"strokes":[{)" + std::string(keys) + "}]}");
        QVERIFY2(error && error->kind == Kind::WrongType, keys);
        QVERIFY2(error->wanted == wanted, keys);
    }
}

void TestStrokeFile::refusal_namesStrokeAndSample()
{
    const std::string good = R"({"tool":"pull","radius":1,"samples":[{"position":[0,0,1]}]},)";
    const auto error =
        errorOf(R"({"format":"fettle-strokes","version":1,"strokes":[)" + good + good +
                R"({"tool":"pull","radius":1,"samples":[{"position":[0,0,1]},{"position":[0,0,1],"pressure":2}]}]})");
    QVERIFY(error && error->kind == Kind::OutOfRange);
    QCOMPARE(error->stroke.value(), std::size_t(2));
    QCOMPARE(error->sample.value(), std::size_t(1));
    QCOMPARE(error->min.value(), 0.0);
    QCOMPARE(error->max.value(), 1.0);

    const auto late =
        errorOf(R"({"format":"fettle-strokes","version":1,"strokes":[)" + good +
                R"({"samples":[{"position":[0,0,1],"direction":[1,0,0]},{"position":[0,0,1],"direction":[0,0,0]}],
                                    "tool":"pull","radius":1,"place":"ray"}]})");
    QVERIFY(late && late->key == "direction");
    QCOMPARE(late->stroke.value(), std::size_t(1));
    QCOMPARE(late->sample.value(), std::size_t(1));

    const auto whole = errorOf(R"({"format":"fettle-strokes","version":1,"strokes":[)" + good + R"({"tool":"melt"}]})");
    QCOMPARE(whole->stroke.value(), std::size_t(1));
    QVERIFY(!whole->sample);
}

void TestStrokeFile::refusal_namesLineAndByteOfSyntax()
{
    const auto error = errorOf("{\"format\":\"fettle-strokes\",\n\"version\":1,\n  strokes:[]}");
    QVERIFY(error && error->kind == Kind::Syntax);
    QCOMPARE(error->line, std::size_t(3));
    QCOMPARE(error->byte, std::size_t(44));
}

void TestStrokeFile::refusal_ofDepthIsImmediate()
{
    const std::string deep(10'000'000, '[');
    QVERIFY(errorOf(deep)->kind == Kind::NotStrokes);
    QVERIFY(errorOf(file(least, R"("position":)" + deep))->kind == Kind::WrongType);
    std::string objects;
    for (int i = 0; i < 1'000'000; ++i)
        objects += R"({"strokes":)";
    QVERIFY(errorOf(objects));
}

void TestStrokeFile::refusal_atEachTruncation()
{
    std::mt19937_64 random(2);
    std::ostringstream out;
    writeStrokes(out, {randomStroke(random), randomStroke(random)});
    std::string text = out.str();
    text.pop_back(); // the final line break may be missing
    for (std::size_t length = 0; length < text.size(); ++length)
        QVERIFY(errorOf(text.substr(0, length)));
    for (int i = 0; i < 3000; ++i) { // a file with a flipped byte must be read or refused
        std::string broken = text;
        broken[random() % broken.size()] = static_cast<char>(random());
        errorOf(broken);
    }
}

void TestStrokeFile::reads_aMillionSamples()
{
    Stroke stroke;
    stroke.settings.radius = 1;
    stroke.samples.resize(1'000'000);
    for (std::size_t i = 0; i < stroke.samples.size(); ++i)
        stroke.samples[i].position = Vec3(0.1 * static_cast<double>(i), 1.0 / 3, -7);
    std::ostringstream out;
    writeStrokes(out, {stroke});
    QElapsedTimer timer;
    timer.start();
    const auto back = strokesOf(out.str());
    qInfo("%zu bytes, 1e6 samples: %lld ms", out.str().size(), timer.elapsed());
    QCOMPARE(back.at(0).samples.size(), stroke.samples.size());
    QVERIFY(back[0].samples.back().position == stroke.samples.back().position);
}

void TestStrokeFile::commands_roundTrip()
{
    const std::string text = R"({"format":"fettle-strokes","version":1,"strokes":[
{"command":"move","by":[1,-2,0.1]},
{"command":"rotate","rotation":[0,0,0.6,0.8]},
{"command":"scale","factor":2.5},
{"command":"mirror","plane":"z"},
{"command":"recentre"},
{"command":"insert","file":"a \"b\".stl","where":"beside"},
{"command":"insert","file":"a.stl","where":"as_it_is"},
{"command":"insert","file":"a.stl","where":"centre","centre":[0,3,0]},
{"command":"insert","file":"a.stl","where":"floor","centre":[0,3,0],"combine":"subtract"},
{"command":"insert","primitive":"box","width":1,"height":2,"depth":3,"where":"beside","combine":"join"},
{"command":"insert","primitive":"ball","radius":1.5,"edge_length":0.1,"where":"as_it_is","combine":"intersect"},
{"command":"insert","primitive":"cylinder","radius":1.5,"height":4,"axis":"x","where":"beside"},
{"command":"insert","primitive":"cone","radius":1.5,"top_radius":0,"height":4,"axis":"z","where":"beside"},
{"command":"insert","primitive":"capsule","radius":1.5,"height":4,"where":"beside"},
{"command":"insert","primitive":"capsule","radius":1.5,"height":4,"along":[1,0.5,-2],"where":"beside","symmetry":"x"},
{"command":"insert","file":"a.stl","where":"beside","symmetry":"z"},
{"command":"insert","primitive":"torus","radius":1.5,"tube_radius":0.5,"where":"beside"},
{"command":"insert","primitive":"lathe","profile":[[0,-1],[2.5,0],[1,3]],"where":"beside"},
{"command":"insert","primitive":"tube","path":[[0,0,0,2],[9,1.5,0,1]],"where":"as_it_is"},
{"command":"fill","color":[200,120,80]},
{"command":"remesh"},
{"command":"remesh","detail_length":0.1},
{"command":"symmetrize","plane":"y","keep":"positive"},
{"command":"symmetrize","plane":"x","keep":"negative"},
{"command":"place_on_bed"},
{"command":"flatten_base","height":0.5},
{"command":"mask","how":"shrink"},
{"command":"mask","how":"color","color":[200,120,80]},
{"command":"trim","outline":[[0,0,5],[9,0.1,5]],"along":[0,0,-1],"eye":[0,0,99],"remove":"inside","symmetry":"x"},
{"command":"trim","outline":[[0,0,5]],"along":[0,-1,0],"remove":"outside","symmetry":"none","color":[1,2,3]}]}
)";
    const std::vector<FileEntry> entries = parseStrokes(text);
    QCOMPARE(entries.size(), std::size_t(30));
    std::ostringstream out;
    writeStrokes(out, entries);
    QCOMPARE(out.str(), text);
    const auto commandAt = [&](std::size_t i) { return std::get<FileCommand>(entries[i]); };
    QVERIFY(std::get<Move>(commandAt(0).command).by == Vec3(1, -2, 0.1));
    QCOMPARE(std::get<Mirror>(commandAt(3).command).axis, 2);
    QCOMPARE(commandAt(5).file, "a \"b\".stl");
    QVERIFY(std::get<Insert>(commandAt(7).command).place == Insert::Place::Centre);
    QVERIFY(std::get<Insert>(commandAt(8).command).combination == Insert::Combination::Subtract);
    const core::Primitive lathe = *std::get<Insert>(commandAt(17).command).primitive;
    QVERIFY(lathe.kind == core::Primitive::Kind::Lathe && lathe.profile.size() == 3 && lathe.profile[1].radius == 2.5);
    QVERIFY(!std::get<Insert>(commandAt(7).command).primitive);
    const core::Primitive tube = *std::get<Insert>(commandAt(18).command).primitive;
    QVERIFY(tube.path == (std::vector<core::TubePoint>{{{0, 0, 0}, 2}, {{9, 1.5, 0}, 1}}));
    QVERIFY(std::get<Symmetrize>(commandAt(23).command).keep == Half::Negative);
    QCOMPARE(std::get<core::FlattenBase>(commandAt(25).command).height, 0.5);
    QCOMPARE(std::get<core::MaskOperation>(commandAt(26).command).how, core::MaskOperation::Kind::Shrink);
    const auto trim = std::get<core::Trim>(commandAt(28).command);
    QVERIFY(trim.area.eye == Vec3(0, 0, 99) && trim.area.outline.at(1) == Vec3(9, 0.1, 5) && !trim.color);
    QVERIFY(std::get<core::Trim>(commandAt(29).command).area.direction == Vec3(0, -1, 0));
    const auto slanted = std::get<Insert>(commandAt(14).command);
    QVERIFY(slanted.primitive->axis == Vec3(1, 0.5, -2) && slanted.symmetry == core::Symmetry::X);

    const auto swapped =
        parseStrokes(R"({"format":"fettle-strokes","version":1,"strokes":[{"by":[1,0,0],"command":"move"}]})");
    QVERIFY(std::get<Move>(std::get<FileCommand>(swapped.at(0)).command).by == Vec3(1, 0, 0));
}

/// A file has the axis only where it means something.
void TestStrokeFile::axisOfATube_isNotWritten()
{
    for (const auto kind : {core::Primitive::Kind::Tube, core::Primitive::Kind::Cylinder}) {
        core::Primitive solid;
        solid.kind = kind;
        solid.path = {{{0, 0, 0}, 1}, {{9, 0, 0}, 1}};
        solid.axis = Vec3::UnitX();
        Insert insert;
        insert.primitive = solid;
        std::ostringstream out;
        writeStrokes(out, std::vector<FileEntry>{FileCommand{insert, "", 0}});
        QCOMPARE(out.str().find("axis") != std::string::npos, core::hasAxis(kind));
        QCOMPARE(parseStrokes(out.str()).size(), std::size_t(1));
    }
}

void TestStrokeFile::partCommands_roundTrip()
{
    const std::string text = R"({"format":"fettle-strokes","version":1,"strokes":[
{"command":"move","by":[1,-2,0.1],"part":3},
{"command":"edit_part","name":"R\"ad ü","locked":true,"tag":[255,0,9],"list_position":2,"part":1},
{"command":"edit_part","name":"","locked":false},
{"command":"insert","primitive":"ball","radius":1.5,"where":"beside","combine":"part","name":"B\"all ü"},
{"command":"insert","file":"a.stl","where":"beside","combine":"part"},
{"command":"show_parts","parts":[0,32767]},
{"command":"show_parts","parts":[]},
{"command":"duplicate_part","name":"a","part":1},
{"command":"delete_part","part":1},
{"command":"separate_part"},
{"command":"combine_parts","operation":"subtract","parts":[2,4],"part":1},
{"command":"hide","what":"unmasked"},
{"command":"hide","what":"none"},
{"command":"mask_area","outline":[[0,0,5]],"along":[0,0,-1],"side":"inside","symmetry":"none","invert":true},
{"command":"mask_area","outline":[[0,0,5]],"along":[0,0,-1],"side":"outside","symmetry":"y"},
{"command":"hide_area","outline":[],"along":[0,0,-1],"eye":[0,0,9],"side":"inside","symmetry":"none","front":true},
{"command":"split_part","outline":[],"along":[0,0,-1],"side":"outside","symmetry":"none","name":"Arm","color":[1,2,3]},
{"command":"trim","outline":[],"along":[0,0,-1],"remove":"inside","symmetry":"none","front":true,"part":2},
{"command":"hide","what":"no_part"}]}
)";
    const std::vector<FileEntry> entries = parseStrokes(text);
    std::ostringstream out;
    writeStrokes(out, entries);
    QCOMPARE(out.str(), text);
    const auto commandAt = [&](std::size_t i) { return std::get<FileCommand>(entries[i]); };
    QCOMPARE(commandAt(0).part, core::PartId(3));
    QCOMPARE(std::get<core::EditPart>(commandAt(1).command).name, std::string("R\"ad ü"));
    QVERIFY(!std::get<core::EditPart>(commandAt(2).command).tag);
    QCOMPARE(std::get<core::ShowParts>(commandAt(5).command).visible.back(), core::PartId(32767));
    QCOMPARE(std::get<core::CombineParts>(commandAt(10).command).others.size(), std::size_t(2));
    QVERIFY(std::get<core::MaskArea>(commandAt(13).command).isErasing);
    QVERIFY(std::get<core::MaskArea>(commandAt(14).command).area.side == core::ViewArea::Side::Outside);
    QVERIFY(std::get<core::HideArea>(commandAt(15).command).area.isFrontOnly);
    QCOMPARE(std::get<core::SplitPart>(commandAt(16).command).name, std::string("Arm"));
    QVERIFY(std::get<core::Trim>(commandAt(17).command).area.isFrontOnly);
    QVERIFY(!std::get<core::EditPart>(commandAt(2).command).position);
    QCOMPARE(std::get<core::Insert>(commandAt(3).command).name, std::string("B\"all ü"));
    const std::string stroke = R"("tool":"pull","radius":1,"part":7)";
    QCOMPARE(std::get<Stroke>(parseStrokes(file(stroke)).at(0)).settings.part, core::PartId(7));
}

void TestStrokeFile::readStrokes_refusesWhatIsNoFile()
{
    QTemporaryDir folder;
    const std::string base = folder.path().toStdString();
    QVERIFY_EXCEPTION_THROWN(readStrokes(base + "/missing.json"), StrokeFileError);
    QVERIFY_EXCEPTION_THROWN(readStrokes(base), StrokeFileError);
    std::ofstream(base + "/empty.json");
    QVERIFY_EXCEPTION_THROWN(readStrokes(base + "/empty.json"), StrokeFileError);
    std::ofstream(base + "/good.json") << file(least);
    QCOMPARE(readStrokes(base + "/good.json").size(), std::size_t(1));
}

void TestStrokeFile::readStrokes_takesAStream()
{
    std::istringstream good(file(least)), empty;
    QCOMPARE(readStrokes(good).size(), std::size_t(1));
    QVERIFY_EXCEPTION_THROWN(readStrokes(empty), StrokeFileError);
    std::ifstream missing("/nowhere/strokes.json");
    try {
        readStrokes(missing);
        QFAIL("a stream that cannot be read was accepted");
    } catch (const StrokeFileError& error) {
        QCOMPARE(error.kind, StrokeFileError::Kind::CannotRead);
    }
}

FETTLE_TEST(TestStrokeFile)
#include "tst_stroke_file.moc"
