#pragma once

#include "ui/brush/preset_file.h"
#include "ui/util/background_thread.h"

#include <QObject>

#include <stop_token>
#include <vector>

namespace ui
{
/// The brush presets of the program and of the user; each user preset is a file in the user's data. Thread: gui; files
/// are read and pictures drawn on background threads.
class PresetLibrary : public QObject
{
    Q_OBJECT

public:
    struct Entry
    {
        PresetFile file;
        QString name; ///< shown name, translated if the preset is part of the program
        QString tip;  ///< purpose of a preset of the program; else empty
        bool isOurs = false;
    };

    explicit PresetLibrary(QObject* parent = nullptr) : QObject(parent) {}
    ~PresetLibrary() override;

    /// Returns the program's presets in the order of the list, then the user's by name.
    const std::vector<Entry>& entries() const { return m_entries; }
    /// Reads all presets again and emits loaded(). A file that is no preset, or of a newer version, is left out;
    /// refused() reports each such file once.
    void load();
    /// Stops earlier drawing, then draws all presets in turn; pictureMade() delivers each picture.
    void draw(int pixels);

    // Each function below except exportTo() reads all presets again after a change. A failure is reported by refused()
    // and changes nothing.

    /// Writes a new preset of the user. If the name is in use, a number is appended. Returns the new file; empty:
    /// refused.
    QString add(core::BrushPreset preset, const QString& name);
    void rename(const Entry& entry, const QString& name);
    /// Moves the file to the trash. Nothing is deleted if there is no trash.
    void remove(const Entry& entry);
    /// Adds the preset of a file to the user's presets. Returns the new file; empty: refused.
    QString import(const QString& path);
    void exportTo(const Entry& entry, const QString& path);

    /// Returns the folder of the user's presets.
    static QString folder();

Q_SIGNALS:
    void loaded();
    /// `path`: file of the preset
    void pictureMade(const QString& path, const QImage& picture);
    /// A preset was left out or could not be changed. `sentence`: the reason.
    void refused(const QString& sentence);

private:
    void take(std::vector<PresetFile> files);
    QString freeName(const QString& wanted) const;
    QString freePath(const QString& name) const;
    bool isWritten(const QString& problem);

    std::vector<Entry> m_entries;
    QStringList m_told; ///< messages about left-out files that were already reported
    std::stop_source m_drawing;
    BackgroundThread m_reader, m_painter; ///< last members: destroyed first, because their jobs use the other members
};
} // namespace ui
