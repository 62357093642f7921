#pragma once

#include "ui/brush/preset_file.h"
#include "ui/util/background_thread.h"

#include <QObject>

#include <stop_token>
#include <vector>

namespace ui
{
/// The brush presets of the program, and those of the user: a file each in the user's data. Reads, writes and draws
/// them. Thread: gui; files are read and pictures drawn on a thread.
class PresetLibrary : public QObject
{
    Q_OBJECT

public:
    struct Entry
    {
        PresetFile file;
        QString name; ///< in the user's language, if it is one of ours
        QString tip;  ///< what one of ours is for; else empty
        bool isOurs = false;
    };

    explicit PresetLibrary(QObject* parent = nullptr) : QObject(parent) {}
    ~PresetLibrary() override;

    /// Returns ours in the order of the shelf, then the user's by name.
    const std::vector<Entry>& entries() const { return m_entries; }
    /// Reads all presets anew, then loaded(). A file that is no preset, or of a newer version, is left out, which
    /// refused() says once; the others stay.
    void load();
    /// Draws the pictures that are not there yet, one after the other: pictureMade().
    void draw(int pixels);

    // Each reads all presets anew. What cannot be done is said by refused(), and changes nothing.

    /// Writes a new preset of the user's, with that name or one that is free. Returns its file; empty: refused.
    QString add(core::BrushPreset preset, const QString& name);
    void rename(const Entry& entry, const QString& name);
    /// Puts the file into the trash; where there is none, nothing is deleted.
    void remove(const Entry& entry);
    /// Copies the file's preset among the user's. Returns its new file; empty: refused.
    QString import(const QString& path);
    void exportTo(const Entry& entry, const QString& path);

    /// Returns the folder of the user's presets.
    static QString folder();

Q_SIGNALS:
    void loaded();
    /// `path`: of the preset's file.
    void pictureMade(const QString& path, const QImage& picture);
    /// Says in one sentence why a preset is left out.
    void refused(const QString& sentence);

private:
    void take(std::vector<PresetFile> files);
    QString freeName(const QString& wanted) const;
    QString freePath(const QString& name) const;
    bool isWritten(const QString& problem);

    std::vector<Entry> m_entries;
    QStringList m_told; ///< sentences about files that were left out
    std::stop_source m_drawing;
    BackgroundThread m_reader, m_painter; ///< last
};
} // namespace ui
