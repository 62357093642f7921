#pragma once

#include "core/util/file_error.h"

#include <QCoreApplication>
#include <QString>

namespace ui
{
/// Says what is wrong with a malformed file: what was expected, what was found, where. Any thread.
class FileFaultMessages
{
    Q_DECLARE_TR_FUNCTIONS(ui::FileFaultMessages)

public:
    /// Returns one sentence. `where`: the file's name, with line or byte.
    static QString sentence(const core::FileError& error, const QString& where);

private:
    /// Returns what was expected; an empty text if the fault does not say it. Likewise the functions below.
    static QString expected(const core::FileError& error);
    static QString ofModel(const core::FileError& error, const QString& where);
    static QString ofGltf(const core::FileError& error, const QString& where);
    static QString ofPackage(const core::FileError& error, const QString& where);
};
} // namespace ui
