// Tests the preset file: a written one is read again, and each invalid one is refused with the place of its error.
#include "core/io/stroke/brush_file.h"
#include "core/sculpt/deform/alpha.h"
#include "tests/support/test_main.h"

#include <QTest>

#include <random>

using PresetFault = core::StrokeFileError::Kind;

class TestBrushFile : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void whatIsWrittenIsRead();
    void theLeastPresetHasANewBrushsValues();
    void refuses_data();
    void refuses();
    void aNewerVersionIsSaidFirst();
    void depthIsRefusedAtItsFirstBracket();
    void filesThatCannotBeRead();
};

namespace
{
/// Returns a preset file with `stroke` in its "stroke" object and `more` after its name.
std::string preset(const std::string& stroke, const std::string& more = {})
{
    return R"({"format":"fettle-brush","version":1,"name":"A")" + more + R"(,"stroke":{)" + stroke + "}}";
}

std::optional<core::StrokeFileError> presetError(const std::string& text)
{
    try {
        core::parseBrush(text);
    } catch (const core::StrokeFileError& error) {
        return error;
    }
    return std::nullopt;
}

core::BrushPreset randomPreset(std::mt19937& random)
{
    const auto share = [&] { return std::uniform_real_distribution<double>(0, 1)(random); };
    const auto coin = [&] { return random() % 2 == 0; };
    core::BrushPreset made;
    made.name = coin() ? "Haut, groß" : "皮肤 \"A\\B\"";
    made.stroke.tool = static_cast<core::Tool>(random() % core::toolNames().size());
    made.stroke.strength = 10 * share();
    made.stroke.falloff = coin() ? 0 : static_cast<int>(3 + random() % 14);
    made.stroke.spacing = coin() ? 0 : 0.001 + 3 * share();
    made.stroke.airbrush = coin() ? 0 : core::minAirbrush + 30 * share();
    made.stroke.inverted = coin();
    made.stroke.alphaFollows = coin();
    made.stroke.anchored = coin();
    made.chosen = {coin(), coin(), coin(), coin()};
    if (made.chosen.reach)
        made.stroke.brush = core::BrushShape::Ray;
    if (made.chosen.topology)
        made.stroke.topology = core::Topology::Keep;
    if (made.chosen.detail)
        made.stroke.detail = 0.05 + 10 * share();
    if (made.chosen.color)
        made.stroke.color = {1, static_cast<std::uint8_t>(random()), 255};
    if (coin())
        made.radiusShare = core::minPresetRadius + 0.4 * share();
    if (coin()) {
        made.stroke.alpha = core::builtInAlpha("pores");
    } else if (coin()) {
        made.alpha.file = "skin.png";
        made.alphaImage = coin() ? "aGVsbG8=" : "";
    }
    return made;
}
} // namespace

void TestBrushFile::whatIsWrittenIsRead()
{
    std::mt19937 random(1);
    for (int i = 0; i < 300; ++i) {
        const core::BrushPreset before = randomPreset(random);
        const core::BrushPreset after = core::parseBrush(core::toJson(before));
        QVERIFY(after.name == before.name && after.radiusShare == before.radiusShare);
        QVERIFY(after.chosen == before.chosen && after.alphaImage == before.alphaImage);
        QVERIFY(after.alpha.file == before.alpha.file && after.stroke.alpha == before.stroke.alpha);
        const core::StrokeSettings &a = after.stroke, &b = before.stroke;
        QVERIFY(a.tool == b.tool && a.brush == b.brush && a.strength == b.strength && a.falloff == b.falloff);
        QVERIFY(a.detail == b.detail && a.topology == b.topology && a.spacing == b.spacing);
        QVERIFY(a.airbrush == b.airbrush && a.inverted == b.inverted && a.alphaFollows == b.alphaFollows);
        QCOMPARE(a.anchored, b.anchored);
        QVERIFY(a.color == b.color);
    }
}

void TestBrushFile::theLeastPresetHasANewBrushsValues()
{
    const core::BrushPreset least = core::parseBrush(preset(R"("tool":"clay")"));
    QVERIFY(least.stroke.tool == core::Tool::Clay && least.stroke.strength == 1 && least.stroke.falloff == 4);
    QCOMPARE(least.stroke.spacing, core::presetSpacing);
    QCOMPARE(least.stroke.airbrush, core::defaultAirbrush);
    QVERIFY(least.chosen == core::BrushPreset::Choices() && !least.radiusShare);
}

void TestBrushFile::refuses_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<PresetFault>("kind");
    QTest::addColumn<QString>("key");
    const auto row = [](const std::string& text, PresetFault kind, const char* key) {
        QTest::newRow(text.substr(0, 150).c_str()) << QString::fromStdString(text) << kind << QString::fromUtf8(key);
    };
    const auto stroke = [&](const std::string& more, PresetFault kind, const char* key) {
        row(preset(R"("tool":"clay",)" + more), kind, key);
    };
    const auto beside = [&](const std::string& more, PresetFault kind, const char* key) {
        row(preset(R"("tool":"clay")", "," + more), kind, key);
    };
    row("", PresetFault::Syntax, "");
    row("solid pipe\n", PresetFault::Syntax, "");
    row("[1,", PresetFault::NotBrush, "");
    for (const char* other : {"[]", "1", "null", "true", "\"fettle-brush\""})
        row(other, PresetFault::NotBrush, "");
    row("{}", PresetFault::NotBrush, "format");
    row(R"({"format":"fettle-strokes","version":1,"strokes":[]})", PresetFault::NotBrush, "format");
    row(R"({"format":"fettle-brush"})", PresetFault::NotBrush, "version");
    row(R"({"format":"fettle-brush","version":"1"})", PresetFault::NotBrush, "version");
    row(R"({"format":"fettle-brush","version":0.5})", PresetFault::NotBrush, "version");
    row(R"({"format":"fettle-brush","version":1})", PresetFault::MissingKey, "name");
    row(R"({"format":"fettle-brush","version":1,"name":"A"})", PresetFault::MissingKey, "stroke");
    row(R"({"format":"fettle-brush","version":1,"name":"A","stroke":[]})", PresetFault::WrongType, "stroke");
    row(R"({"format":"fettle-brush","version":1,"name":"A","stroke":1})", PresetFault::WrongType, "stroke");
    row(preset(R"("tool":"clay")") + " x", PresetFault::Syntax, "stroke");
    for (const char* name : {"\"\"", "\"   \"", R"("a\nb")", R"("a\u0000")"})
        QVERIFY(presetError(std::string(R"({"format":"fettle-brush","version":1,"name":)") + name +
                            R"(,"stroke":{"tool":"clay"}})")
                    ->kind == PresetFault::UnknownValue);
    row(R"({"format":"fettle-brush","version":1,"name":1,"stroke":{"tool":"clay"}})", PresetFault::WrongType, "name");
    beside(R"("more":1)", PresetFault::UnknownKey, "more");
    beside(R"("version":1)", PresetFault::DuplicateKey, "version");
    beside(R"("radius_share":0.6)", PresetFault::OutOfRange, "radius_share");
    beside(R"("radius_share":0)", PresetFault::OutOfRange, "radius_share");
    beside(R"("radius_share":"0.1")", PresetFault::WrongType, "radius_share");
    beside(R"("radius_share":null)", PresetFault::WrongType, "radius_share");
    beside(R"("radius_share":1e999)", PresetFault::NotANumber, "radius_share");
    beside(R"("alpha_image":"a b")", PresetFault::UnknownValue, "alpha_image: \"a b\"");
    beside(R"("alpha_image":"aGVsbG8=")", PresetFault::UnknownKey, "alpha_image");

    row(preset(R"("strength":1)"), PresetFault::MissingKey, "tool");
    row(preset(R"("tool":"melt")"), PresetFault::UnknownValue, "tool: \"melt\"");
    row(preset(R"("tool":null)"), PresetFault::WrongType, "tool");
    stroke(R"("tool":"clay")", PresetFault::DuplicateKey, "tool");
    for (const char* key : {"samples", "radius", "symmetry", "radial", "place", "add", "command", "fusion", "more"})
        stroke('"' + std::string(key) + R"(":1)", PresetFault::UnknownKey, key);
    stroke(R"("airbrush":61)", PresetFault::OutOfRange, "airbrush");
    stroke(R"("airbrush":0.05)", PresetFault::OutOfRange, "airbrush");
    stroke(R"("airbrush":true)", PresetFault::WrongType, "airbrush");
    stroke(R"("strength":11)", PresetFault::OutOfRange, "strength");
    stroke(R"("strength":{})", PresetFault::WrongType, "strength");
    stroke(R"("strength":1e999)", PresetFault::NotANumber, "strength");
    stroke(R"("falloff":2)", PresetFault::OutOfRange, "falloff");
    stroke(R"("falloff":3.5)", PresetFault::WrongType, "falloff");
    stroke(R"("spacing":-1)", PresetFault::OutOfRange, "spacing");
    stroke(R"("detail":0)", PresetFault::OutOfRange, "detail");
    stroke(R"("color":[1,2])", PresetFault::WrongType, "color");
    stroke(R"("color":[1,2,256])", PresetFault::OutOfRange, "color");
    stroke(R"("color":[[1],2,3])", PresetFault::WrongType, "color");
    stroke(R"("alpha":"")", PresetFault::UnknownValue, "alpha: \"\"");
    stroke(R"("topology":"finest")", PresetFault::UnknownValue, "topology: \"finest\"");
    stroke(R"("invert":"yes")", PresetFault::WrongType, "invert");
}

void TestBrushFile::refuses()
{
    QFETCH(QString, text);
    QFETCH(PresetFault, kind);
    QFETCH(QString, key);
    const auto error = presetError(text.toStdString());
    QVERIFY(error);
    QCOMPARE(error->kind, kind);
    QCOMPARE(QString::fromStdString(error->key), key);
    QVERIFY(!error->stroke && !error->sample); // preset errors have no indices, because a preset has only one stroke
}

/// A newer version is reported first, whatever other errors the file has before or after it.
void TestBrushFile::aNewerVersionIsSaidFirst()
{
    for (const char* text :
         {R"({"format":"fettle-brush","version":2})", R"({"glow":{"format":[1]},"version":2,"format":"fettle-brush"})",
          R"({"format":"fettle-brush","stroke":{"tool":"melt","version":1},"version":7,"name":5})"}) {
        const auto error = presetError(text);
        QVERIFY(error && error->kind == PresetFault::NewerVersion);
    }
}

void TestBrushFile::depthIsRefusedAtItsFirstBracket()
{
    const std::string deep(1000000, '[');
    QVERIFY(presetError(deep)->kind == PresetFault::NotBrush);
    QVERIFY(presetError(R"({"format":"fettle-brush","version":1,"name":)" + deep)->kind == PresetFault::WrongType);
    QVERIFY(presetError(preset(R"("tool":"clay","color":)" + deep))->kind == PresetFault::WrongType);
}

void TestBrushFile::filesThatCannotBeRead()
{
    try {
        core::readBrush("/nowhere/brush.json");
        QFAIL("there is no such file");
    } catch (const core::StrokeFileError& error) {
        QCOMPARE(error.kind, PresetFault::CannotRead);
    }
}

FETTLE_TEST(TestBrushFile)
#include "tst_brush_file.moc"
