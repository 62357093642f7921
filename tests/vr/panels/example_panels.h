#pragma once

#include "vr/panels/panel_content.h"
#include "vr/panels/panel_layout.h"

#include <memory>
#include <vector>

class QTranslator;

/// A translation that is installed for the lifetime of this object.
class TestTranslation
{
public:
    /// Makes every text longer by two fifths, as a translation may be.
    static TestTranslation longer();
    /// Loads translations/fettle_<language>.ts.
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

/// Returns every panel in each of its states.
std::vector<ExamplePanel> examplePanels();
vr::PanelLayout exampleLayout(int index);
