#pragma once

#include <QFileIconProvider>

namespace ui
{
/// Icons and kinds of files by their names. Qt's own provider reads files to know them, and waits for ever where one
/// does not answer, such as /proc/kmsg. Thread: any.
class NameIcons : public QFileIconProvider
{
public:
    QIcon icon(IconType type) const override { return QFileIconProvider::icon(type); }
    QIcon icon(const QFileInfo& file) const override;
    QString type(const QFileInfo& file) const override;
};
} // namespace ui
