#pragma once

#include "core/io/stroke/stroke_file.h"

#include <QCoreApplication>
#include <QString>

namespace ui
{
/// Describes the error of a stroke or preset file: one sentence with file, place and reason.
class StrokeFileMessages
{
    Q_DECLARE_TR_FUNCTIONS(ui::StrokeFileMessages)

public:
    static QString sentence(const QString& path, const core::StrokeFileError& error);
    /// Returns line, stroke and sample, as far as known.
    static QString place(const core::StrokeFileError& error);
    static QString reason(const core::StrokeFileError& error);

private:
    static QString wrongType(const QString& key, core::StrokeFileError::Value wanted);
};
} // namespace ui
