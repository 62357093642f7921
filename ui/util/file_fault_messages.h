#pragma once

#include "core/util/file_error.h"

#include <QCoreApplication>
#include <QString>

namespace ui
{
/// Describes the fault of a malformed file: what was expected, what was found, and where. Thread: any.
class FileFaultMessages
{
    Q_DECLARE_TR_FUNCTIONS(ui::FileFaultMessages)

public:
    /// Returns one sentence. `where`: the file's name with line or byte.
    static QString sentence(const core::FileError& error, const QString& where);

private:
    /// Each of these functions returns the text for its own faults, and an empty text for all other faults.
    static QString expected(const core::FileError& error);
    static QString ofModel(const core::FileError& error, const QString& where);
    static QString ofGltf(const core::FileError& error, const QString& where);
    static QString ofPackage(const core::FileError& error, const QString& where);
};
} // namespace ui
