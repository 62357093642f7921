#pragma once

#include "vr/panels/panel_content.h"
#include "vr/panels/panel_layout.h"

#include <memory>
#include <vector>

class QTranslator;

/// Installs a translation while it exists.
class TestTranslation
{
public:
    /// Longer by two fifths, as a translation may be.
    static TestTranslation longer();
    /// Of translations/fettle_<language>.ts.
    static TestTranslation ofLanguage(const QString& language);
    TestTranslation(TestTranslation&&) = default;
    ~TestTranslation();

private:
    explicit TestTranslation(std::unique_ptr<QTranslator> translator);

    std::unique_ptr<QTranslator> m_translator;
};

struct ExamplePanel
{
    const char* name;
    vr::PanelContent content;
};

/// Each panel in each of its states.
std::vector<ExamplePanel> examplePanels();
vr::PanelLayout exampleLayout(int index);
