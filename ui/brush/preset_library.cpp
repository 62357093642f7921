#include "ui/brush/preset_library.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QStandardPaths>

#include <algorithm>

namespace ui
{
namespace
{
struct PresetTexts
{
    Q_DECLARE_TR_FUNCTIONS(ui::PresetTexts)

public:
    struct Row
    {
        QString file, name, tip;
    };
    static std::vector<Row> rows();
};

std::vector<PresetTexts::Row> PresetTexts::rows()
{
    return {
        {QStringLiteral("clay-buildup"), tr("Clay Buildup"), tr("Adds clay in thick rolls, more where you pause.")},
        {QStringLiteral("raked-clay"), tr("Raked Clay"), tr("Adds clay in strips, as a rake does.")},
        {QStringLiteral("carve"), tr("Carve"), tr("Cuts a groove with soft edges.")},
        {QStringLiteral("swell"), tr("Swell"), tr("Inflates the surface under it, with a soft edge.")},
        {QStringLiteral("panel"), tr("Panel"), tr("Raises a plate of one height, with steep sides.")},
        {QStringLiteral("fine-line"), tr("Fine Line"), tr("Scores a sharp line: wrinkles, eyelids, seams.")},
        {QStringLiteral("ridge"), tr("Ridge"), tr("Raises a sharp edge.")},
        {QStringLiteral("polish"), tr("Polish"), tr("Removes bumps and keeps hollows.")},
        {QStringLiteral("plane-off"), tr("Plane Off"), tr("Cuts flat faces, like a knife.")},
        {QStringLiteral("big-move"), tr("Big Move"), tr("Moves large parts of the model, softly.")},
        {QStringLiteral("horn"), tr("Horn"), tr("Pulls out horns, tails and roots.")},
        {QStringLiteral("pores"), tr("Pores"), tr("Stamps skin pores.")},
        {QStringLiteral("scales"), tr("Scales"), tr("Stamps scales along the stroke.")},
        {QStringLiteral("cracks"), tr("Cracks"), tr("Stamps the cracks of dry earth.")},
        {QStringLiteral("weave"), tr("Weave"), tr("Stamps woven cloth along the stroke.")},
        {QStringLiteral("rough-stone"), tr("Rough Stone"), tr("Makes the surface rough, like broken stone.")},
    };
}

PresetLibrary::Entry entryOf(const PresetFile& file)
{
    const std::vector<PresetTexts::Row> rows = PresetTexts::rows();
    PresetLibrary::Entry entry{file, QString::fromStdString(file.preset->name), {}, file.path.startsWith(u':')};
    const QString stem = QFileInfo(file.path).completeBaseName();
    const auto row = std::ranges::find(rows, stem, &PresetTexts::Row::file);
    if (entry.isOurs && row != rows.end()) {
        entry.name = row->name;
        entry.tip = row->tip;
    }
    return entry;
}

std::vector<PresetFile> readAll(const QString& folder)
{
    std::vector<PresetFile> files;
    for (const QString& path : bundledPresets())
        files.push_back(readPreset(path));
    for (const QString& name : QDir(folder).entryList({QStringLiteral("*.json")}, QDir::Files, QDir::Name))
        files.push_back(readPreset(QDir(folder).filePath(name)));
    return files;
}

/// Shortens the name to core::maxPresetName bytes of UTF-8, without splitting a character.
std::string cutName(const QString& name)
{
    QString cut = name.simplified();
    while (cut.toUtf8().size() > static_cast<qsizetype>(core::maxPresetName))
        cut.chop(cut.size() > 1 && cut.back().isLowSurrogate() ? 2 : 1);
    return cut.toStdString();
}
} // namespace

PresetLibrary::~PresetLibrary()
{
    m_drawing.request_stop();
    m_painter.drop();
}

QString PresetLibrary::folder()
{
    return QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + QStringLiteral("/brushes/presets");
}

void PresetLibrary::load()
{
    m_reader.run([folder = folder()] { return readAll(folder); },
                 [this](std::vector<PresetFile> files) { take(std::move(files)); });
}

void PresetLibrary::take(std::vector<PresetFile> files)
{
    m_entries.clear();
    QStringList problems;
    for (const PresetFile& file : files) {
        if (file.preset)
            m_entries.push_back(entryOf(file));
        else if (!m_told.contains(file.problem))
            problems << file.problem;
    }
    std::ranges::stable_sort(m_entries, [](const Entry& a, const Entry& b) {
        if (a.isOurs || b.isOurs)
            return a.isOurs && !b.isOurs;
        return a.name.localeAwareCompare(b.name) < 0;
    });
    m_told << problems;
    if (problems.size() == 1)
        Q_EMIT refused(tr("A brush preset was left out: %1", "a sentence that says why").arg(problems.constFirst()));
    else if (!problems.isEmpty())
        Q_EMIT refused(tr("%n brush presets were left out. The first: %1", "a sentence that says why",
                          static_cast<int>(problems.size()))
                           .arg(problems.constFirst()));
    Q_EMIT loaded();
}

void PresetLibrary::draw(int pixels)
{
    m_drawing.request_stop();
    m_drawing = {};
    m_painter.drop();
    for (const Entry& entry : m_entries) {
        m_painter.run(
            [file = entry.file, pixels, stop = m_drawing.get_token()] { return presetImage(file, pixels, stop); },
            [this, path = entry.file.path](const QImage& picture) {
                if (!picture.isNull())
                    Q_EMIT pictureMade(path, picture);
            });
    }
}

/// Returns the wanted name, with a number appended if the name is in use.
QString PresetLibrary::freeName(const QString& wanted) const
{
    const auto isTaken = [&](const QString& name) {
        return std::ranges::any_of(m_entries, [&](const Entry& entry) { return entry.name == name; });
    };
    QString name = wanted;
    for (int number = 2; isTaken(name); ++number)
        name = QStringLiteral("%1 %2").arg(wanted).arg(number);
    return name;
}

/// Returns an unused path in the user's folder. The file name is the preset's name in lower case, with '-' for every
/// character that is no letter or digit, and a number if needed.
QString PresetLibrary::freePath(const QString& name) const
{
    constexpr qsizetype maxStem = 40;
    QString stem;
    for (const QChar c : name.toLower().left(maxStem))
        stem += c.isLetterOrNumber() ? c : QLatin1Char('-');
    QString path = QDir(folder()).filePath(stem + QStringLiteral(".json"));
    for (int number = 2; QFile::exists(path); ++number)
        path = QDir(folder()).filePath(QStringLiteral("%1-%2.json").arg(stem).arg(number));
    return path;
}

bool PresetLibrary::isWritten(const QString& problem)
{
    if (!problem.isEmpty())
        Q_EMIT refused(problem);
    load();
    return problem.isEmpty();
}

QString PresetLibrary::add(core::BrushPreset preset, const QString& name)
{
    preset.name = cutName(freeName(name));
    const QString path = freePath(QString::fromStdString(preset.name));
    QDir().mkpath(folder()); // if this fails, writePreset() reports it
    QString problem = embedAlpha(preset, path);
    if (problem.isEmpty())
        problem = writePreset(preset, path);
    return isWritten(problem) ? path : QString();
}

void PresetLibrary::rename(const Entry& entry, const QString& name)
{
    core::BrushPreset preset = *entry.file.preset;
    const std::string cut = cutName(name);
    if (cut.empty() || cut == preset.name)
        return load();
    preset.name = cutName(freeName(QString::fromStdString(cut)));
    isWritten(writePreset(preset, entry.file.path));
}

void PresetLibrary::remove(const Entry& entry)
{
    QFile file(entry.file.path);
    isWritten(file.moveToTrash() ? QString()
                                 : tr("%1 was not deleted: it cannot be moved to the trash.").arg(entry.name));
}

QString PresetLibrary::import(const QString& path)
{
    const PresetFile file = readPreset(path);
    if (!file.preset) {
        Q_EMIT refused(file.problem);
        return {};
    }
    core::BrushPreset preset = *file.preset;
    if (const QString problem = embedAlpha(preset, path); !problem.isEmpty()) {
        Q_EMIT refused(problem);
        return {};
    }
    return add(preset, QString::fromStdString(preset.name));
}

void PresetLibrary::exportTo(const Entry& entry, const QString& path)
{
    core::BrushPreset preset = *entry.file.preset;
    QString problem = embedAlpha(preset, entry.file.path);
    if (problem.isEmpty())
        problem = writePreset(preset, path);
    if (!problem.isEmpty())
        Q_EMIT refused(problem);
}
} // namespace ui
