#pragma once

#include <QCoreApplication>
#include <QString>

namespace app
{
class Document;
class SculptWorker;

/// When the display goes away, Qt ends the program by exit(). While a rescue lives, changes that no file holds are written
/// then, to a file of their own that the next start offers among the recent ones, and stderr says so. One at a time; gui thread.
class Rescue
{
    Q_DECLARE_TR_FUNCTIONS(app::Rescue)

public:
    /// Neither is owned.
    Rescue(Document* document, SculptWorker* worker);
    ~Rescue();
    Q_DISABLE_COPY_MOVE(Rescue)

private:
    static void atExit();
    void keepModel() const;

    static Rescue* s_present;
    Document* m_document;
    SculptWorker* m_worker;
};
} // namespace app
