#pragma once

#include <QCoreApplication>
#include <QString>

namespace vr
{
/// Returns the path of the manifest of the active runtime that the system names; empty: it names none.
QString systemManifest();

/// Finds out why the loader reports that there is no runtime. The loader reads a manifest, a JSON file that names the
/// runtime's library, but it gives the same result whether there is no manifest, or a broken one.
class ActiveRuntime
{
    Q_DECLARE_TR_FUNCTIONS(vr::ActiveRuntime)

public:
    /// Returns the path of the manifest that the loader reads, by the chapter "Runtime Discovery" of Khronos' loader
    /// specification: that of XR_RUNTIME_JSON, or the one that the system names. Empty: there is none.
    static QString manifest();

    /// Returns two sentences for the user that say what is wrong with a manifest and what helps. `path`: empty: the
    /// system names none. `reason`: name of the loader's result. Returns an empty text if nothing is wrong.
    static QString faultOf(const QString& path, const QString& reason);

private:
    /// Returns the library that a manifest names, as an absolute path; a library without a folder is returned as it is.
    static QString libraryOf(const QString& path);
};
} // namespace vr
