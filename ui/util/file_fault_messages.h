#pragma once

#include "core/util/file_error.h"

#include <QCoreApplication>
#include <QString>

namespace ui
{
/// What is wrong with a malformed file in words: what was expected, what was found, where. Any thread.
class FileFaultMessages
{
    Q_DECLARE_TR_FUNCTIONS(ui::FileFaultMessages)

public:
    /// One sentence; `where` is the file's name, with line or byte.
    static QString sentence(const core::FileError& error, const QString& where);

private:
    /// Empty where the fault says no such thing.
    static QString expected(const core::FileError& error);
    static QString ofModel(const core::FileError& error, const QString& where);
    static QString ofGltf(const core::FileError& error, const QString& where);
    static QString ofPackage(const core::FileError& error, const QString& where);
};
} // namespace ui
