#include "tests/vr/panels/example_panels.h"

#include "tests/support/translation_file.h"

#include <QPainter>

namespace
{
QString lengthened(const QString& text)
{
    const qsizetype more = (2 * text.size() + 4) / 5;
    QString tail;
    while (tail.size() < more)
        tail += text.at(tail.size() % text.size()).isLetter() ? text.at(tail.size() % text.size()).toLower()
                                                              : QLatin1Char('n');
    return text + tail;
}

class Lengthener : public QTranslator
{
public:
    QString translate(const char*, const char* text, const char*, int) const override
    {
        return lengthened(QString::fromUtf8(text));
    }
    bool isEmpty() const override { return false; }
};

QImage modelPicture(int hue)
{
    QImage picture(256, 256, QImage::Format_ARGB32_Premultiplied);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    QRadialGradient light(QPointF(105, 95), 130);
    light.setColorAt(0, QColor::fromHsv(hue, 60, 235));
    light.setColorAt(1, QColor::fromHsv(hue, 90, 120));
    painter.setBrush(light);
    painter.drawEllipse(QRectF(38, 38, 180, 180));
    return picture;
}

vr::FilesPanel files(int count)
{
    static const QStringList names{QStringLiteral("horn"),   QStringLiteral("horn-2"),
                                   QStringLiteral("horn-3"), QStringLiteral("teapot with a long and winding name"),
                                   QStringLiteral("head"),   QStringLiteral("broken"),
                                   QStringLiteral("vase"),   QStringLiteral("tablet"),
                                   QStringLiteral("花瓶-2")};
    vr::FilesPanel panel;
    panel.folder = QStringLiteral("Fettle");
    for (int i = 0; i < count; ++i) {
        vr::FileTile tile{QStringLiteral("/models/%1.glb").arg(i), names[i % names.size()], {}, i % names.size() == 5};
        if (i % names.size() != 5 && i % names.size() != 4)
            tile.picture = modelPicture(i * 40 % 360);
        panel.files << tile;
    }
    return panel;
}

std::vector<ExamplePanel> toolPanels()
{
    const vr::ToolPanel plain;
    vr::ToolPanel busy;
    busy.tool = core::Tool::Paint;
    busy.brush = core::BrushShape::Ray;
    busy.topology = core::Topology::Uniform;
    busy.isSymmetric = busy.isInverse = busy.addsNext = busy.canUndo = busy.canRedo = true;
    return {{"tools", plain}, {"tools-all", busy}};
}

std::vector<ExamplePanel> colorPanels()
{
    vr::ColorPanel color{.color = {200, 120, 80}, .channel = 1, .swatches = {}};
    const ExamplePanel bare{"color-bare", color};
    for (const core::Rgb swatch : {core::Rgb{255, 255, 255},
                                   {30, 30, 32},
                                   {232, 190, 160},
                                   {200, 120, 80},
                                   {140, 74, 46},
                                   {204, 52, 44},
                                   {236, 156, 40},
                                   {244, 216, 84},
                                   {96, 160, 72},
                                   {52, 124, 190},
                                   {70, 62, 140},
                                   {190, 90, 150},
                                   {1, 2, 3}})
        color.swatches << swatch;
    return {{"color", color}, bare};
}

std::vector<ExamplePanel> filesPanels()
{
    vr::FilesPanel empty = files(0), chosen = files(9), last = files(9), busy = files(3);
    chosen.chosen = chosen.files[1].path;
    chosen.hasUnsavedChanges = true;
    last.page = 1;
    last.chosen = last.files[6].path;
    last.saved = QStringLiteral("horn-4.glb, horn-4.stl");
    busy.isBusy = true;
    return {{"files", chosen}, {"files-last", last}, {"files-empty", empty}, {"files-busy", busy}};
}

std::vector<ExamplePanel> partsPanels()
{
    vr::PartsPanel panel;
    const auto add = [&](const QString& name, bool isVisible, bool isLocked, std::optional<core::Rgb> tag) {
        const auto id = static_cast<core::PartId>(panel.parts.size());
        panel.parts << vr::PartRow{{id, name.toStdString(), isVisible, isLocked, tag}, name};
    };
    add(QStringLiteral("body"), true, false, {});
    const vr::PartsPanel one = panel;
    add(QStringLiteral("wheel"), true, false, core::Rgb{204, 52, 44});
    add(QStringLiteral("a wheel with a long name that somebody typed at the window"), false, true,
        core::Rgb{52, 124, 190});
    add(QStringLiteral("花瓶-2"), false, false, {});
    add(QStringLiteral("axle"), true, true, {});
    add(QStringLiteral("roof"), true, false, {});
    add(QStringLiteral("lamp"), true, false, {});
    panel.active = 1;
    panel.canUndo = panel.canRedo = true;
    vr::PartsPanel marked = panel, last = panel, busy = panel;
    marked.marked = {0, 2};
    last.page = 1;
    last.active = 6;
    busy.isBusy = true;
    vr::PartsPanel preview = busy;
    preview.preview = core::SetOperation::Difference;
    vr::PartsPanel shapes = panel;
    shapes.shown = vr::PartsPage::Shapes;
    shapes.shape = core::Primitive::Kind::Capsule;
    vr::PartsPanel tube = shapes;
    tube.shape = core::Primitive::Kind::Tube;
    tube.makesPart = true;
    vr::PartsPanel names = panel;
    names.shown = vr::PartsPage::Name;
    vr::PartsPanel cut = panel;
    cut.shown = vr::PartsPage::Cut;
    return {{"parts-shapes", shapes}, {"parts-cut", cut},        {"parts", panel},     {"parts-one", one},
            {"parts-name", names},    {"parts-marked", marked},  {"parts-last", last}, {"parts-busy", busy},
            {"parts-tube", tube},     {"parts-preview", preview}};
}

std::vector<ExamplePanel> lessonPanels()
{
    vr::LessonPanel shown{QStringLiteral("First clay: a pear"),
                          QStringLiteral("Pull the neck"),
                          QStringLiteral("Take Pull, and draw the top of the ball upwards in three strokes."),
                          0,
                          5,
                          {},
                          true};
    shown.marks = {{QStringLiteral("something sculpted in this step"), false},
                   {QStringLiteral("no holes"), true},
                   {QStringLiteral("in one piece"), true},
                   {QStringLiteral("at least 125 mm tall (now 100 mm)"), false},
                   {QStringLiteral("at most 110 mm long, seen from above (now 100 mm)"), true},
                   {QStringLiteral("flat base: at least 10.0 cm² (now 0.0 mm²)"), false},
                   {QStringLiteral("ready to print"), true}};
    vr::LessonPanel paged = shown;
    paged.title = QStringLiteral("A very long title of a step that somebody wrote without looking at it");
    paged.text =
        QString(shown.text + QLatin1Char(' ')).repeated(9) + QStringLiteral("用手柄把泥球的顶部拉起来，分三笔完成。");
    paged.step = 4;
    paged.page = 1;
    paged.isPlaying = true;
    vr::LessonPanel bare = shown;
    bare.canPlay = false;
    bare.marks.clear();
    bare.step = 2;
    vr::LessonPanel end = shown;
    end.title = QStringLiteral("That was the last step");
    end.text = QStringLiteral("You met 14 of 16 goals. Keep sculpting, if you like.");
    end.step = end.steps;
    end.canPlay = false;
    end.marks = {{QStringLiteral("Pull the neck: 5 of 5"), true}, {QStringLiteral("Push a hollow: 3 of 5"), false}};
    return {{"lesson", shown}, {"lesson-paged", paged}, {"lesson-bare", bare}, {"lesson-end", end}};
}
} // namespace

TestTranslation::TestTranslation(std::unique_ptr<QTranslator> translator) : m_translator(std::move(translator))
{
    QCoreApplication::installTranslator(m_translator.get());
}

TestTranslation::~TestTranslation()
{
    if (m_translator)
        QCoreApplication::removeTranslator(m_translator.get());
}

TestTranslation TestTranslation::longer()
{
    return TestTranslation(std::make_unique<Lengthener>());
}

TestTranslation TestTranslation::ofLanguage(const QString& language)
{
    return TestTranslation(std::make_unique<TranslationFile>(
        QStringLiteral(FETTLE_SOURCE_DIR "/translations/fettle_%1.ts").arg(language)));
}

std::vector<ExamplePanel> examplePanels()
{
    std::vector<ExamplePanel> all = toolPanels();
    for (const auto& more : {colorPanels(), filesPanels()})
        all.insert(all.end(), more.begin(), more.end());
    const vr::HeadsetSettings changed{.wands = {},
                                      .heightOffset = 0.12,
                                      .turnRate = 150,
                                      .showsFloor = false,
                                      .showsPerformance = true,
                                      .hapticLevels = {{1, 0.8, 0.5, 0.3, 0.05, 0}}};
    all.push_back({"settings", vr::SettingsPanel()});
    all.push_back({"settings-changed", vr::SettingsPanel::of(changed, vr::SettingsPage::General)});
    all.push_back({"settings-feel", vr::SettingsPanel::of(changed, vr::SettingsPage::Haptics)});
    all.push_back({"performance", vr::PerformancePanel{{0.02, 0.11, 0.08, 0.31, 0.12, 0.54, 0.2}, 1.38, 0.42, 90, 3}});
    all.push_back({"notice", vr::NoticePanel{QStringLiteral("Saved as horn-4.")}});
    all.push_back({"notice-of-two-lines",
                   vr::NoticePanel{QStringLiteral(
                       "The ball would be too close to the model: move away from it, or make the brush smaller.")}});
    all.push_back(
        {"notice-of-many-lines",
         vr::NoticePanel{QStringLiteral(
             "“teapot with a long and winding name.stl” cannot be opened: 12 triangles meet others, 3 edges belong to "
             "more than two "
             "triangles, and two shells lie within each other. Open it at the desktop, where it can be repaired.")}});
    for (const auto& more : {lessonPanels(), partsPanels()})
        all.insert(all.end(), more.begin(), more.end());
    return all;
}

vr::PanelLayout exampleLayout(int index)
{
    return vr::layoutOf(examplePanels()[static_cast<std::size_t>(index)].content);
}
