#pragma once

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>

#include <memory>
#include <vector>

namespace app
{
/// Sets the program's language for the lifetime of the object.
class LoadedLanguage
{
public:
    explicit LoadedLanguage(const QString& locale)
    {
        QLocale::setDefault(QLocale(locale));
        load(QStringLiteral("qtbase_") + locale, QLibraryInfo::path(QLibraryInfo::TranslationsPath));
        load(QStringLiteral("fettle_") + locale, QStringLiteral(FETTLE_QM_DIR));
    }
    ~LoadedLanguage() { QLocale::setDefault(QLocale::c()); }

private:
    void load(const QString& name, const QString& folder)
    {
        auto translator = std::make_unique<QTranslator>();
        if (translator->load(name, folder))
            QCoreApplication::installTranslator(translator.get());
        m_translators.push_back(std::move(translator));
    }
    std::vector<std::unique_ptr<QTranslator>> m_translators;
};
} // namespace app
