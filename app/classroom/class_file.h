#pragma once

#include "ui/classroom/classroom.h"

#include <QCoreApplication>

namespace app
{
/// An error in a class file: one sentence with the file, the line or key, and the reason.
struct ClassFileError
{
    QString sentence;
};

/// Reads and writes the file that a teacher makes for a class. It is UTF-8 text with one "key = value" per line; lines
/// that begin with #, ; or [ are ignored. Thread: any.
class ClassFile
{
    Q_DECLARE_TR_FUNCTIONS(app::ClassFile)

public:
    /// Reads a class file. A relative folder is resolved against the file's folder; it need not exist. Throws
    /// ClassFileError.
    static ui::Classroom read(const QString& path);
    /// Writes the file completely or not at all. Returns an empty string, or one sentence about the error.
    /// Precondition: the title has no line break.
    static QString write(const QString& path, const ui::Classroom& classroom);
    /// Returns one sentence why the class cannot use its lesson; empty if it can or has none.
    static QString lessonProblem(const ui::Classroom& classroom);
};
} // namespace app
