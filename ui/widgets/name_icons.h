#pragma once

#include <QFileIconProvider>

namespace ui
{
/// Determines icons and types of files from their names alone. Qt's own provider reads files, which blocks for ever on
/// files such as /proc/kmsg. Thread: any.
class NameIcons : public QFileIconProvider
{
public:
    QIcon icon(IconType type) const override { return QFileIconProvider::icon(type); }
    QIcon icon(const QFileInfo& file) const override;
    QString type(const QFileInfo& file) const override;
};
} // namespace ui
