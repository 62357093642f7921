#pragma once

#include "vr/panels/panel_content.h"

#include <memory>
#include <vector>

class QTranslator;

/// What the program says, in another way than in English, while this lives.
class OtherWords
{
public:
    /// Longer by two fifths, as a translation may be.
    static OtherWords longer();
    /// Of translations/fettle_<language>.ts.
    static OtherWords ofLanguage(const QString& language);
    OtherWords(OtherWords&&) = default;
    ~OtherWords();

private:
    explicit OtherWords(std::unique_ptr<QTranslator> translator);

    std::unique_ptr<QTranslator> m_translator;
};

struct ExamplePanel
{
    const char* name;
    vr::PanelContent content;
};

/// Each panel in each of its states.
std::vector<ExamplePanel> examplePanels();
