#include "ui/settings/stored_values.h"

#include "ui/util/color_convert.h"

#include <QStringList>

namespace ui::stored
{
void read(const QSettings& settings, const QString& key, QList<core::Rgb>& colors)
{
    if (!settings.contains(key))
        return;
    colors.clear();
    for (const QString& name : settings.value(key).toStringList())
        if (const QColor color(name); color.isValid())
            colors << toRgb(color);
}

void write(QSettings& settings, const QString& key, const QList<core::Rgb>& colors)
{
    QStringList names;
    for (const core::Rgb& color : colors)
        names << toQt(color).name();
    settings.setValue(key, names);
}

void read(const QSettings& settings, const QString& key, QList<PrinterPreset>& printers)
{
    if (const QList<PrinterPreset> stored = printersOf(settings.value(key).toStringList()); !stored.isEmpty())
        printers = stored;
}

void write(QSettings& settings, const QString& key, const QList<PrinterPreset>& printers)
{
    settings.setValue(key, toLines(printers));
}

void read(const QSettings& settings, const QString& group, QMap<QString, QString>& texts)
{
    const QString prefix = group + u'/';
    for (const QString& key : settings.allKeys())
        if (key.startsWith(prefix))
            texts.insert(key.mid(prefix.size()), settings.value(key).toString());
}

void write(QSettings& settings, const QString& group, const QMap<QString, QString>& texts)
{
    settings.remove(group);
    for (auto text = texts.cbegin(); text != texts.cend(); ++text)
        settings.setValue(group + u'/' + text.key(), text.value());
}
} // namespace ui::stored
