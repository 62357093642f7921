<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>app::BooleanCommand</name>
    <message>
        <source>Unites models, subtracts all others from the first, or keeps what all have in common. The models must be watertight. OUT keeps their place and is in mm. Status 1: nothing is left, or there is no sound result.</source>
        <translation>Vereinigt Modelle, zieht alle anderen vom ersten ab oder behält, was allen gemeinsam ist. Die Modelle müssen wasserdicht sein. OUT behält ihre Lage und ist in mm. Status 1: Es bleibt nichts übrig, oder es gibt kein fehlerfreies Ergebnis.</translation>
    </message>
    <message>
        <source>The operation: one of %1.</source>
        <translation>Die Operation: eine von %1.</translation>
    </message>
    <message>
        <source>The first model; or -.</source>
        <translation>Das erste Modell; oder -.</translation>
    </message>
    <message>
        <source>The other models; or -.</source>
        <translation>Die anderen Modelle; oder -.</translation>
    </message>
    <message>
        <source>Axis that points up in the files that are read (default: z for STL, 3MF and AMF, y for others).</source>
        <translation>Achse, die in den gelesenen Dateien nach oben zeigt (Vorgabe: z bei STL, 3MF und AMF, sonst y).</translation>
    </message>
    <message>
        <source>boolean: &quot;%1&quot; is not an operation: the operations are %2.</source>
        <translation>boolean: „%1“ ist keine Operation: Die Operationen sind %2.</translation>
    </message>
    <message>
        <source>%1 Did you mean %2?</source>
        <translation>%1 Meinten Sie %2?</translation>
    </message>
    <message>
        <source>boolean: the operation is missing: one of %1.</source>
        <translation>boolean: Die Operation fehlt: eine von %1.</translation>
    </message>
    <message>
        <source>%1 cannot be combined with others, because its surface does not bound a solid (%2). fettle convert --repair may make it watertight.</source>
        <translation>%1 kann nicht mit anderen verknüpft werden, weil seine Oberfläche keinen Körper begrenzt (%2). fettle convert --repair kann es vielleicht wasserdicht machen.</translation>
    </message>
    <message>
        <source>The models have no space in common. Nothing was written.</source>
        <translation>Die Modelle haben keinen gemeinsamen Raum. Es wurde nichts geschrieben.</translation>
    </message>
    <message>
        <source>Nothing is left of %1. Nothing was written.</source>
        <translation>Von %1 bleibt nichts übrig. Es wurde nichts geschrieben.</translation>
    </message>
    <message>
        <source>The models cannot be combined soundly: near (%1, %2, %3) mm faces lie so close to each other that they still meet after rounding. Move a model a little. Nothing was written.</source>
        <translation>Die Modelle lassen sich nicht ohne Fehler verknüpfen: Bei (%1, %2, %3) mm liegen Flächen so dicht beieinander, dass sie sich nach dem Runden noch treffen. Verschieben Sie ein Modell ein wenig. Es wurde nichts geschrieben.</translation>
    </message>
    <message>
        <source>%1: %2 x %3 x %4 mm, triangles: %5, volume: %6.</source>
        <translation>%1: %2 x %3 x %4 mm, Dreiecke: %5, Volumen: %6.</translation>
    </message>
    <message numerus="yes">
        <source>boolean: needs two models or more; %n were given.</source>
        <translation>
            <numerusform>boolean: braucht zwei Modelle oder mehr; angegeben wurde %n.</numerusform>
            <numerusform>boolean: braucht zwei Modelle oder mehr; angegeben wurden %n.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>app::BrushExport</name>
    <message>
        <source>There is not enough memory to make a brush of this model.</source>
        <translation>Der Speicher reicht nicht, um aus diesem Modell einen Pinsel zu machen.</translation>
    </message>
</context>
<context>
    <name>app::CheckCommand</name>
    <message>
        <source>%1 is watertight.</source>
        <translation>%1 ist wasserdicht.</translation>
    </message>
    <message>
        <source>file</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>faces</source>
        <translation>Flächen</translation>
    </message>
    <message>
        <source>size, mm</source>
        <translation>Größe, mm</translation>
    </message>
    <message>
        <source>print-ready</source>
        <translation>druckfertig</translation>
    </message>
    <message>
        <source>One JSON object per file, each on its line.</source>
        <translation>Ein JSON-Objekt je Datei, jedes in einer eigenen Zeile.</translation>
    </message>
    <message>
        <source>wall, mm</source>
        <translation>Wand, mm</translation>
    </message>
    <message>
        <source>overhang</source>
        <translation>Überhang</translation>
    </message>
    <message>
        <source>base, mm²</source>
        <translation>Standfläche, mm²</translation>
    </message>
    <message>
        <source>fits</source>
        <translation>passt</translation>
    </message>
    <message>
        <source>it does not fit the bed</source>
        <translation>es passt nicht auf das Druckbett</translation>
    </message>
    <message>
        <source>%1 of its surface is thinner than %2 mm</source>
        <translation>%1 der Oberfläche sind dünner als %2 mm</translation>
    </message>
    <message>
        <source>%1 of its surface overhangs by more than %2 degrees</source>
        <translation>%1 der Oberfläche hängen um mehr als %2 Grad über</translation>
    </message>
    <message>
        <source>it stands on a point or an edge</source>
        <translation>es steht auf einem Punkt oder einer Kante</translation>
    </message>
    <message>
        <source>%1 is watertight, but: %2.</source>
        <translation>%1 ist wasserdicht, aber: %2.</translation>
    </message>
    <message>
        <source>check: --bed must be three lengths in mm, as in 250,210,220, not &quot;%1&quot;.</source>
        <translation>check: --bed muss drei Längen in mm nennen, wie in 250,210,220, nicht „%1“.</translation>
    </message>
    <message>
        <source>Says whether models are closed, manifold, oriented, free of self-intersections, and bound a solid. Status 0: all are, whatever --print finds; 1: not all.</source>
        <translation>Prüft, ob Modelle geschlossen, mannigfaltig, einheitlich orientiert und frei von Selbstdurchdringungen sind und einen Körper umschließen. Status 0: alle, unabhängig vom Ergebnis von --print; 1: nicht alle.</translation>
    </message>
    <message>
        <source>Models, or folders of models; or -.</source>
        <translation>Modelle oder Ordner mit Modellen; oder -.</translation>
    </message>
    <message>
        <source>CSV with a header row.</source>
        <translation>CSV mit Kopfzeile.</translation>
    </message>
    <message>
        <source>Also measure wall thickness, overhangs and bed contact.</source>
        <translation>Auch Wandstärken, Überhänge und die Auflage auf dem Druckbett messen.</translation>
    </message>
    <message>
        <source>Nozzle width in mm; walls should be two lines thick (default: 0.4).</source>
        <translation>Düsendurchmesser in mm; Wände sollten zwei Linien dick sein (Vorgabe: 0.4).</translation>
    </message>
    <message>
        <source>Steepest overhang that prints without support, in degrees from the vertical (default: 45).</source>
        <translation>Stärkster Überhang, der sich ohne Stützen drucken lässt, in Grad aus der Senkrechten (Vorgabe: 45).</translation>
    </message>
    <message>
        <source>Width, depth and height of the printer&apos;s build volume, in mm (default: not checked).</source>
        <translation>Breite, Tiefe und Höhe des Bauraums des Druckers, in mm (Vorgabe: wird nicht geprüft).</translation>
    </message>
    <message>
        <source>vertices</source>
        <translation>Eckpunkte</translation>
    </message>
    <message>
        <source>triangles</source>
        <translation>Dreiecke</translation>
    </message>
    <message>
        <source>closed</source>
        <translation>geschlossen</translation>
    </message>
    <message>
        <source>two faces at each edge</source>
        <translation>zwei Flächen an jeder Kante</translation>
    </message>
    <message>
        <source>consistently oriented faces</source>
        <translation>Flächen einheitlich orientiert</translation>
    </message>
    <message>
        <source>bounds a solid</source>
        <translation>umschließt einen Körper</translation>
    </message>
    <message>
        <source>self-intersections</source>
        <translation>Selbstdurchdringungen</translation>
    </message>
    <message>
        <source>parts</source>
        <translation>Teile</translation>
    </message>
    <message>
        <source>holes through it</source>
        <translation>durchgehende Löcher</translation>
    </message>
    <message>
        <source>volume, mm³</source>
        <translation>Volumen, mm³</translation>
    </message>
    <message>
        <source>surface, mm²</source>
        <translation>Oberfläche, mm²</translation>
    </message>
    <message>
        <source>shortest edge, mm</source>
        <translation>kürzeste Kante, mm</translation>
    </message>
    <message>
        <source>longest edge, mm</source>
        <translation>längste Kante, mm</translation>
    </message>
    <message>
        <source>triangles without area</source>
        <translation>Dreiecke ohne Fläche</translation>
    </message>
    <message>
        <source>still valid when opened</source>
        <translation>bleibt beim Öffnen fehlerfrei</translation>
    </message>
    <message>
        <source>strokes</source>
        <translation>Striche</translation>
    </message>
    <message>
        <source>working time, s</source>
        <translation>Arbeitszeit, s</translation>
    </message>
    <message>
        <source>thinnest wall allowed, mm</source>
        <translation>dünnste erlaubte Wand, mm</translation>
    </message>
    <message>
        <source>thinnest wall, mm</source>
        <translation>dünnste Wand, mm</translation>
    </message>
    <message>
        <source>surface that is too thin</source>
        <translation>zu dünne Oberfläche</translation>
    </message>
    <message>
        <source>surface that overhangs</source>
        <translation>überhängende Oberfläche</translation>
    </message>
    <message>
        <source>fits the bed</source>
        <translation>passt aufs Druckbett</translation>
    </message>
    <message>
        <source>possible unit</source>
        <translation>vermutlich erstellt in</translation>
    </message>
    <message>
        <source>pupil</source>
        <translation>Kind</translation>
    </message>
    <message>
        <source>turn begun</source>
        <translation>Beginn des Durchgangs</translation>
    </message>
    <message>
        <source>time of the turn, s</source>
        <translation>Dauer des Durchgangs, s</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
</context>
<context>
    <name>app::ClassEnd</name>
    <message>
        <source>End the class? The current pupil&apos;s work will be saved.</source>
        <translation>Die Klasse beenden? Die gerade offene Arbeit wird gespeichert.</translation>
    </message>
    <message>
        <source>End the class? It is nobody&apos;s turn, and all work is saved.</source>
        <translation>Die Klasse beenden? Niemand ist an der Reihe, und alle Arbeiten sind gespeichert.</translation>
    </message>
    <message numerus="yes">
        <source>%n models are not yet in the class folder.</source>
        <translation>
            <numerusform>%n Modell ist noch nicht im Ordner der Klasse.</numerusform>
            <numerusform>%n Modelle sind noch nicht im Ordner der Klasse.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n models were copied to %1.</source>
        <translation>
            <numerusform>%n Modell wurde nach %1 kopiert.</numerusform>
            <numerusform>%n Modelle wurden nach %1 kopiert.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>app::ClassFileController</name>
    <message>
        <source>Saved %1.</source>
        <translation>%1 wurde gespeichert.</translation>
    </message>
    <message>
        <source>A double click on %1 begins it, on every computer that has Fettle.</source>
        <translation>Ein Doppelklick auf %1 beginnt die Klasse, auf jedem Rechner mit Fettle.</translation>
    </message>
    <message>
        <source>Classroom</source>
        <translation>Klassenraum</translation>
    </message>
    <message>
        <source>Begin the class &quot;%1&quot; now?</source>
        <translation>Die Klasse „%1“ jetzt beginnen?</translation>
    </message>
    <message>
        <source>This window closes, and only the class is there. Leaving it asks for your PIN.</source>
        <translation>Dieses Fenster wird geschlossen, und nur die Klasse ist zu sehen. Zum Verlassen brauchen Sie Ihre PIN.</translation>
    </message>
    <message>
        <source>&amp;Begin the Class Now</source>
        <translation>Klasse jetzt &amp;beginnen</translation>
    </message>
    <message>
        <source>C&amp;hange…</source>
        <translation>Ä&amp;ndern …</translation>
    </message>
    <message>
        <source>&amp;Not Now</source>
        <translation>Ni&amp;cht jetzt</translation>
    </message>
    <message numerus="yes">
        <source>%n models of a class are still on this computer.</source>
        <translation>
            <numerusform>%n Modell einer Klasse ist noch auf diesem Rechner.</numerusform>
            <numerusform>%n Modelle einer Klasse sind noch auf diesem Rechner.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n models are still on this computer and not in %1.</source>
        <translation>
            <numerusform>%n Modell ist noch auf diesem Rechner und nicht in %1.</numerusform>
            <numerusform>%n Modelle sind noch auf diesem Rechner und nicht in %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>They go to the class folder when the class begins and its folder is there.</source>
        <translation>Sie kommen in den Ordner der Klasse, sobald die Klasse beginnt und der Ordner erreichbar ist.</translation>
    </message>
    <message numerus="yes">
        <source>%n models were moved to %1.</source>
        <translation>
            <numerusform>%n Modell wurde nach %1 verschoben.</numerusform>
            <numerusform>%n Modelle wurden nach %1 verschoben.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>app::TurnAnswers</name>
    <message>
        <source>%1 is a link to a file that is not there.</source>
        <translation>%1 verweist auf eine Datei, die es nicht gibt.</translation>
    </message>
    <message>
        <source>%1 was made by a newer version of Fettle.</source>
        <translation>%1 stammt von einer neueren Version von Fettle.</translation>
    </message>
    <message>
        <source>%1 contains no answers that can be read.</source>
        <translation>%1 enthält keine lesbaren Antworten.</translation>
    </message>
    <message>
        <source>%1: the answer &quot;%2&quot; is left out, because it is not a whole number from %3 to %4.</source>
        <translation>%1: Die Antwort „%2“ wird ausgelassen, weil sie keine ganze Zahl von %3 bis %4 ist.</translation>
    </message>
</context>
<context>
    <name>app::WorkArchive</name>
    <message>
        <source>%1: there is not enough memory to write this model.</source>
        <translation>%1: Der Speicher reicht nicht, um dieses Modell zu schreiben.</translation>
    </message>
</context>
<context>
    <name>app::ClassFile</name>
    <message>
        <source>%1 could not be started.</source>
        <translation>%1 konnte nicht gestartet werden.</translation>
    </message>
    <message>
        <source>%1 cannot be read (%2).</source>
        <translation>%1 kann nicht gelesen werden (%2).</translation>
    </message>
    <message>
        <source>%1 is not a class file: it is not UTF-8 text, or it is too long.</source>
        <translation>%1 ist keine Klassendatei: kein UTF-8-Text oder zu lang.</translation>
    </message>
    <message>
        <source>each line must be key = value, or begin with #.</source>
        <translation>Jede Zeile muss Schlüssel = Wert sein oder mit # beginnen.</translation>
    </message>
    <message>
        <source>%1 appears twice.</source>
        <translation>%1 kommt zweimal vor.</translation>
    </message>
    <message>
        <source>%1: %2 is missing.</source>
        <translation>%1: %2 fehlt.</translation>
    </message>
    <message>
        <source>it is empty.</source>
        <translation>ist leer.</translation>
    </message>
    <message>
        <source>must be a whole number from 0 to %2, not &quot;%1&quot;.</source>
        <translation>muss eine ganze Zahl von 0 bis %2 sein, nicht „%1“.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is none of %2.</source>
        <translation>„%1“ ist keines von %2.</translation>
    </message>
    <message>
        <source>%1 is not a key of a class file.</source>
        <translation>%1 ist kein Schlüssel einer Klassendatei.</translation>
    </message>
    <message>
        <source>%1, line %2: %3</source>
        <translation>%1, Zeile %2: %3</translation>
    </message>
    <message>
        <source># A class for Fettle. It begins with: fettle --classroom and the name of this file.</source>
        <translation># Eine Klasse für Fettle. Start mit: fettle --classroom und dem Namen dieser Datei.</translation>
    </message>
    <message>
        <source>this is not a PIN as Fettle writes it; set one with Edit › Classroom.</source>
        <translation>Das ist keine von Fettle geschriebene PIN; legen Sie eine unter Bearbeiten › Klassenraum fest.</translation>
    </message>
    <message>
        <source>there are no names to choose from.</source>
        <translation>Es gibt keine Namen zur Auswahl.</translation>
    </message>
    <message>
        <source>at most %1 names of at most %2 characters.</source>
        <translation>höchstens %1 Namen mit je höchstens %2 Zeichen.</translation>
    </message>
    <message>
        <source>%1 is not a lesson: it is neither one of %2 nor a folder or ZIP file.</source>
        <translation>%1 ist keine Lektion: weder eine von %2 noch ein Ordner oder eine ZIP-Datei.</translation>
    </message>
    <message>
        <source>Step %1 of the lesson needs the tool %2 (%3), which is not among the class&apos;s tools.</source>
        <translation>Schritt %1 der Lektion braucht das Werkzeug %2 (%3), das nicht zu den Werkzeugen der Klasse gehört.</translation>
    </message>
</context>
<context>
    <name>app::ClassLesson</name>
    <message>
        <source>Opening %1</source>
        <translation>%1 wird geöffnet</translation>
    </message>
</context>
<context>
    <name>app::ClassWork</name>
    <message>
        <source>%1 Until then they are in %2.</source>
        <translation>%1 Bis dahin liegen sie in %2.</translation>
    </message>
    <message>
        <source>The class folder cannot be reached. The work is saved on this computer and will be moved there as soon as possible.</source>
        <translation>Der Ordner der Klasse ist nicht erreichbar. Die Arbeit ist auf diesem Rechner gespeichert und wird so bald wie möglich dorthin verschoben.</translation>
    </message>
</context>
<context>
    <name>app::ClassroomMode</name>
    <message>
        <source>somebody</source>
        <translation>jemand</translation>
    </message>
    <message>
        <source>Saving the work of %1</source>
        <translation>Die Arbeit wird gespeichert: %1</translation>
    </message>
    <message>
        <source>Please wait: another operation on the model is still running.</source>
        <translation>Bitte warten: Am Modell läuft noch ein anderer Vorgang.</translation>
    </message>
    <message>
        <source>%1 The work of %2 stays open; nothing is lost.</source>
        <translation>%1 Die Arbeit bleibt offen (%2); es geht nichts verloren.</translation>
    </message>
    <message>
        <source>Time is up. Please finish: it is the next pupil&apos;s turn.</source>
        <translation>Die Zeit ist um. Mach noch fertig, was du gerade tust; dann ist das nächste Kind dran.</translation>
    </message>
    <message numerus="yes">
        <source>%n minutes left. Please finish soon.</source>
        <translation>
            <numerusform>Noch %n Minute: Komm bald zum Ende.</numerusform>
            <numerusform>Noch %n Minuten: Komm bald zum Ende.</numerusform>
        </translation>
    </message>
    <message>
        <source>Opening the work of %1</source>
        <translation>Die Arbeit wird geöffnet: %1</translation>
    </message>
</context>
<context>
    <name>app::CommandLine</name>
    <message>
        <source>There is not enough memory for this.</source>
        <translation>Dafür reicht der Speicher nicht.</translation>
    </message>
    <message numerus="yes">
        <source>One file at a time can be opened, but %n were given; fettle --help says more.</source>
        <translation>
            <numerusform>Es kann nur eine Datei geöffnet werden, angegeben wurde %n; mehr dazu mit fettle --help.</numerusform>
            <numerusform>Es kann nur eine Datei geöffnet werden, angegeben wurden %n; mehr dazu mit fettle --help.</numerusform>
        </translation>
    </message>
    <message>
        <source>The answer cannot be written to the standard output (%1).</source>
        <translation>Die Antwort kann nicht auf die Standardausgabe geschrieben werden (%1).</translation>
    </message>
    <message>
        <source>--classroom needs the file of a class, which Edit › Classroom writes.</source>
        <translation>--classroom braucht eine Klassendatei, wie Bearbeiten › Klassenraum sie schreibt.</translation>
    </message>
    <message>
        <source>%1 cannot be opened in a class, which begins with its own models.</source>
        <translation>%1 kann in einer Klasse nicht geöffnet werden: Sie beginnt mit eigenen Modellen.</translation>
    </message>
    <message>
        <source>write a starting shape: a ball, a cube, a vase and others</source>
        <translation>eine Ausgangsform schreiben: eine Kugel, einen Würfel, eine Vase und andere</translation>
    </message>
    <message>
        <source>check whether models are watertight and will print; several files or a folder: a table</source>
        <translation>prüfen, ob Modelle wasserdicht sind und sich drucken lassen; mehrere Dateien oder ein Ordner: eine Tabelle</translation>
    </message>
    <message>
        <source>write a model in another format or size, repaired, or with fewer triangles</source>
        <translation>ein Modell in anderem Format oder anderer Größe schreiben, repariert oder mit weniger Dreiecken</translation>
    </message>
    <message>
        <source>unite models, subtract them from the first, or keep what they share</source>
        <translation>Modelle vereinigen, vom ersten abziehen oder behalten, was ihnen gemeinsam ist</translation>
    </message>
    <message>
        <source>play recorded strokes on a model</source>
        <translation>aufgezeichnete Striche auf einem Modell abspielen</translation>
    </message>
    <message>
        <source>write a class report: picture, size, print-ready or why not, strokes and time of each model</source>
        <translation>einen Klassenbericht schreiben: zu jedem Modell Bild, Größe, druckfertig oder warum nicht, Striche und Zeit</translation>
    </message>
    <message>
        <source>draw models or folders of models to scale, a page each</source>
        <translation>Modelle oder Ordner mit Modellen maßstäblich zeichnen, je eine Seite</translation>
    </message>
    <message>
        <source>check a lesson by playing it to its end, or a pupil&apos;s model by one of its steps</source>
        <translation>eine Lektion prüfen, indem sie bis zum Ende abgespielt wird, oder das Modell eines Kindes anhand eines ihrer Schritte</translation>
    </message>
    <message>
        <source>show what a brush preset contains, or why it is invalid</source>
        <translation>zeigen, was eine Pinselvorlage enthält oder warum sie ungültig ist</translation>
    </message>
    <message>
        <source>There is no command &quot;%1&quot;: the commands are %2.</source>
        <translation>Es gibt keinen Befehl „%1“: Die Befehle sind %2.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not an option.</source>
        <translation>„%1“ ist keine Option.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is neither a command nor a file.</source>
        <translation>„%1“ ist weder ein Befehl noch eine Datei.</translation>
    </message>
    <message>
        <source>%1 See fettle --help.</source>
        <translation>%1 Siehe fettle --help.</translation>
    </message>
    <message>
        <source>%1 Did you mean %2? See fettle --help.</source>
        <translation>%1 Meinten Sie %2? Siehe fettle --help.</translation>
    </message>
    <message>
        <source>%1: cannot tell the format: the ending must be one of %2.</source>
        <translation>%1: Das Format ist nicht erkennbar: Die Endung muss eine von %2 sein.</translation>
    </message>
    <message>
        <source>Fettle sculpts closed models that stay ready to print.

  fettle [--vr] [FILE]             open the window, with a model or with a ball of clay; --vr enters VR with it
  fettle --vr-simulator [FILE]     the same without a headset: a window stands in for it; mouse and keyboard move head and controllers
  fettle [--vr] --classroom CLASS.fettleclass
                                   start a class session, as its teacher set it up (Edit &gt; Classroom)
</source>
        <translation>Fettle formt geschlossene Modelle, die druckfertig bleiben.

  fettle [--vr] [FILE]             das Fenster öffnen, mit einem Modell oder einer Tonkugel; --vr betritt damit VR
  fettle --vr-simulator [FILE]     dasselbe ohne VR-Brille: ein Fenster zeigt ihr Bild, Maus und Tasten sind Kopf und Controller
  fettle [--vr] --classroom CLASS.fettleclass
                                   eine Klasse beginnen, wie ihre Lehrkraft sie eingerichtet hat (Bearbeiten &gt; Klassenraum)
</translation>
    </message>
    <message>
        <source>  fettle help COMMAND              show the options of one of them
  fettle --version                 show the version, and those of the libraries

Formats: %1. Lengths are in millimetres. The file - is the standard input or output.
Status: 0 done, 1 the answer is no, 2 bad input or usage (with a line on standard error).
</source>
        <translation>  fettle help COMMAND              die Optionen eines dieser Befehle zeigen
  fettle --version                 die Version zeigen, auch die der Bibliotheken

Formate: %1. Längen in Millimetern. Die Datei - ist die Standardeingabe oder -ausgabe.
Status: 0 erledigt, 1 die Antwort ist nein, 2 Eingabe oder Aufruf fehlerhaft (mit einer Zeile auf der Standardfehlerausgabe).
</translation>
    </message>
    <message>
        <source>MIT License: free to use, change and pass on, without warranty</source>
        <translation>MIT-Lizenz: frei zu nutzen, zu ändern und weiterzugeben, ohne Gewähr</translation>
    </message>
</context>
<context>
    <name>app::CommandModels</name>
    <message>
        <source>%1: no file was given.</source>
        <translation>%1: Es wurde keine Datei angegeben.</translation>
    </message>
</context>
<context>
    <name>app::CommandUnit</name>
    <message>
        <source>Unit of the files that are read (default: mm).</source>
        <translation>Einheit der Dateien, die gelesen werden (Vorgabe: mm).</translation>
    </message>
</context>
<context>
    <name>app::ConvertCommand</name>
    <message>
        <source>%1 could be reduced to %2 triangles, not to %3: its holes and parts need at least %4. Nothing was written.</source>
        <translation>%1 ließ sich auf %2 Dreiecke reduzieren, nicht auf %3: Löcher und Teile brauchen mindestens %4. Es wurde nichts geschrieben.</translation>
    </message>
    <message>
        <source>%1 could be reduced to %2 triangles, not to %3: with fewer, no surface was found that keeps its holes open and does not intersect itself. Nothing was written.</source>
        <translation>%1 ließ sich auf %2 Dreiecke reduzieren, nicht auf %3: Mit weniger fand sich keine Oberfläche, die ihre Löcher offen hält und sich nicht selbst schneidet. Es wurde nichts geschrieben.</translation>
    </message>
    <message>
        <source>--repair may make it watertight.</source>
        <translation>--repair kann es vielleicht wasserdicht machen.</translation>
    </message>
    <message>
        <source>--wrap may make a new surface.</source>
        <translation>--wrap kann vielleicht eine neue Oberfläche bilden.</translation>
    </message>
    <message>
        <source>Writes a model in another format, unit or size. OUT is in mm.</source>
        <translation>Schreibt ein Modell in anderem Format, anderer Einheit oder Größe. OUT ist in mm.</translation>
    </message>
    <message>
        <source>The model to read; or -.</source>
        <translation>Das Modell, das gelesen wird; oder -.</translation>
    </message>
    <message>
        <source>The file to write, in the format of its ending; or -.</source>
        <translation>Die zu schreibende Datei, im Format ihrer Endung; oder -.</translation>
    </message>
    <message>
        <source>Length of the longest side in mm (default: as it is).</source>
        <translation>Länge der längsten Seite in mm (Vorgabe: wie sie ist).</translation>
    </message>
    <message>
        <source>Axis of IN that points up (default: z for STL, 3MF and AMF, y for others).</source>
        <translation>Achse von IN, die nach oben zeigt (Vorgabe: z bei STL, 3MF und AMF, y bei anderen).</translation>
    </message>
    <message>
        <source>Most triangles of OUT, 4 or more (default: as many as it has). They are removed where shape and colours change least.</source>
        <translation>Höchstzahl der Dreiecke von OUT, 4 oder mehr (Vorgabe: so viele wie vorhanden). Sie werden dort entfernt, wo sich Form und Farben am wenigsten ändern.</translation>
    </message>
    <message>
        <source>Repair a model that is not watertight, and say what changed.</source>
        <translation>Ein Modell reparieren, das nicht wasserdicht ist, und sagen, was sich geändert hat.</translation>
    </message>
    <message>
        <source>With --repair: make a new surface if the model cannot be kept otherwise; detail is lost.</source>
        <translation>Mit --repair: eine neue Oberfläche bilden, wo nichts anderes das Modell erhält; Details gehen verloren.</translation>
    </message>
    <message>
        <source>With --repair: what to do with holes longer than a quarter of the model (default: fill).</source>
        <translation>Mit --repair: Umgang mit Löchern, die länger als ein Viertel des Modells sind (Vorgabe: fill).</translation>
    </message>
    <message>
        <source>With --repair: what to do with parts inside of others that face outwards (default: fill).</source>
        <translation>Mit --repair: Umgang mit Teilen im Innern anderer, die nach außen zeigen (Vorgabe: fill).</translation>
    </message>
    <message>
        <source>Move the middle of the model to the origin.</source>
        <translation>Verschiebt die Mitte des Modells in den Ursprung.</translation>
    </message>
    <message>
        <source>--recentre does that.</source>
        <translation>--recentre tut das.</translation>
    </message>
    <message numerus="yes">
        <source>convert: needs two files, IN and OUT; %n were given.</source>
        <translation>
            <numerusform>convert: braucht zwei Dateien, IN und OUT; angegeben wurde %n.</numerusform>
            <numerusform>convert: braucht zwei Dateien, IN und OUT; angegeben wurden %n.</numerusform>
        </translation>
    </message>
    <message>
        <source>Make a part of each object of IN; parts may overlap.</source>
        <translation>Aus jedem Objekt von IN ein Teil machen; Teile dürfen sich überschneiden.</translation>
    </message>
    <message>
        <source>What to do with parts that overlap if OUT is STL, PLY, OFF or 3MF (default: unite).</source>
        <translation>Was mit Teilen geschieht, die sich überschneiden, wenn OUT STL, PLY, OFF oder 3MF ist (Vorgabe: unite).</translation>
    </message>
    <message>
        <source>--parts keeps its objects apart, which may overlap then; --repair may make it watertight.</source>
        <translation>--parts hält seine Objekte getrennt, die sich dann überschneiden dürfen; --repair kann es wasserdicht machen.</translation>
    </message>
    <message>
        <source>%1: all its parts are hidden, and only GLB keeps hidden parts. Nothing was written.</source>
        <translation>%1: Alle Teile sind ausgeblendet, und nur GLB behält ausgeblendete Teile. Es wurde nichts geschrieben.</translation>
    </message>
    <message>
        <source>%1: its parts overlap and cannot be united. --overlaps keep writes them as they are.</source>
        <translation>%1: Seine Teile überschneiden sich und lassen sich nicht vereinigen. --overlaps keep schreibt sie, wie sie sind.</translation>
    </message>
    <message>
        <source>The parts overlap, so they were united.</source>
        <translation>Die Teile überschneiden sich und wurden daher vereinigt.</translation>
    </message>
</context>
<context>
    <name>app::Document</name>
    <message>
        <source>The earlier steps can no longer be undone: their file on disk cannot be read. The model itself is intact.</source>
        <translation>Die früheren Schritte lassen sich nicht mehr rückgängig machen: Ihre Datei auf der Festplatte ist nicht lesbar. Das Modell selbst ist unversehrt.</translation>
    </message>
    <message>
        <source>Sculpting is paused until the model is ready.</source>
        <translation>Das Formen ist angehalten, bis das Modell bereit ist.</translation>
    </message>
    <message>
        <source>Apply or cancel the preview before you sculpt on.</source>
        <translation>Wenden Sie die Vorschau an oder brechen Sie sie ab, bevor Sie weiter formen.</translation>
    </message>
</context>
<context>
    <name>app::DrawingWorker</name>
    <message>
        <source>Saved %1.</source>
        <translation>%1 wurde gespeichert.</translation>
    </message>
</context>
<context>
    <name>app::HandoutSaving</name>
    <message>
        <source>Saved %1.</source>
        <translation>%1 wurde gespeichert.</translation>
    </message>
</context>
<context>
    <name>app::Headset</name>
    <message>
        <source>Leaving VR…</source>
        <translation>VR wird verlassen …</translation>
    </message>
    <message>
        <source>Somebody is sculpting in the headset: your turn comes when that stroke has ended.</source>
        <translation>Jemand formt in der VR-Brille: Sie sind an der Reihe, sobald dieser Strich beendet ist.</translation>
    </message>
</context>
<context>
    <name>app::HeadsetController</name>
    <message>
        <source>%1 You can repair it in the window.</source>
        <translation>%1 Sie können es im Fenster reparieren.</translation>
    </message>
</context>
<context>
    <name>app::RuntimeProbe</name>
    <message>
        <source>The headset&apos;s program does not answer. If it is not just starting, restart it.</source>
        <translation>Das Programm der VR-Brille antwortet nicht. Wenn es nicht gerade startet, starten Sie es neu.</translation>
    </message>
</context>
<context>
    <name>app::HeadsetRequests</name>
    <message>
        <source>Apply or cancel the preview first.</source>
        <translation>Wenden Sie die Vorschau zuerst an, oder brechen Sie sie ab.</translation>
    </message>
    <message>
        <source>The model was not restored: another operation on it is still running.</source>
        <translation>Das Modell wurde nicht zurückgesetzt: Daran läuft noch ein anderer Vorgang.</translation>
    </message>
    <message>
        <source>The model was not saved: another operation on it is still running.</source>
        <translation>Das Modell wurde nicht gespeichert: Daran läuft noch ein anderer Vorgang.</translation>
    </message>
    <message>
        <source>%1 was not opened: another operation on the model is still running.</source>
        <translation>%1 wurde nicht geöffnet: Am Modell läuft noch ein anderer Vorgang.</translation>
    </message>
    <message>
        <source>%1 was not opened: the current model has unsaved changes.</source>
        <translation>%1 wurde nicht geöffnet: Das aktuelle Modell hat ungespeicherte Änderungen.</translation>
    </message>
    <message>
        <source>This tool is not available in this class.</source>
        <translation>Dieses Werkzeug gibt es in dieser Klasse nicht.</translation>
    </message>
    <message>
        <source>In a class, Next Pupil saves the work, in the window.</source>
        <translation>In einer Klasse speichert „Nächstes Kind“ am Fenster die Arbeit.</translation>
    </message>
    <message>
        <source>%1 was not opened: during a class, only its starting models can be used.</source>
        <translation>%1 wurde nicht geöffnet: In einer Klasse sind nur ihre Ausgangsformen verfügbar.</translation>
    </message>
    <message>
        <source>The mask was not changed: another operation on the model is still running.</source>
        <translation>Die Maske wurde nicht geändert: Am Modell läuft noch ein anderer Vorgang.</translation>
    </message>
    <message>
        <source>The parts were not changed: another operation on the model is still running.</source>
        <translation>Die Teile wurden nicht geändert: Am Modell läuft noch ein anderer Vorgang.</translation>
    </message>
</context>
<context>
    <name>app::RecoveryStore</name>
    <message>
        <source>Fettle was ended from outside. The changes to %1 are kept; the next start offers them.</source>
        <translation>Fettle wurde von außen beendet. Die Änderungen an %1 sind gesichert; der nächste Start bietet sie an.</translation>
    </message>
    <message>
        <source>Changes are not being recorded, so save often: %1</source>
        <translation>Änderungen werden nicht aufgezeichnet, speichern Sie daher oft: %1</translation>
    </message>
    <message>
        <source>%1 cannot be recovered: its recording is damaged.</source>
        <translation>%1 kann nicht wiederhergestellt werden: Die Aufzeichnung ist beschädigt.</translation>
    </message>
    <message>
        <source>%1: there is not enough memory for this model.</source>
        <translation>%1: Für dieses Modell reicht der Speicher nicht.</translation>
    </message>
    <message>
        <source>The recording of an unsaved model is damaged and cannot be opened. It is in %1.</source>
        <translation>Die Aufzeichnung eines nicht gespeicherten Modells ist beschädigt und lässt sich nicht öffnen. Sie liegt in %1.</translation>
    </message>
    <message>
        <source>The recording of %1 is damaged and cannot be opened. It is in %2.</source>
        <translation>Die Aufzeichnung von %1 ist beschädigt und lässt sich nicht öffnen. Sie liegt in %2.</translation>
    </message>
    <message>
        <source>Part of the recording of %1 is damaged: its last steps may be missing. It is in %2.</source>
        <translation>Ein Teil der Aufzeichnung von %1 ist beschädigt: Die letzten Schritte können fehlen. Er liegt in %2.</translation>
    </message>
    <message>
        <source>The disk is slow: a power cut could cost the changes of the last %1 seconds.</source>
        <translation>Die Festplatte ist langsam: Bei einem Stromausfall könnten die Änderungen der letzten %1 Sekunden verloren gehen.</translation>
    </message>
    <message>
        <source>Changes are being recorded again.</source>
        <translation>Änderungen werden wieder aufgezeichnet.</translation>
    </message>
</context>
<context>
    <name>app::LessonCommand</name>
    <message>
        <source>Plays a lesson to its end and says whether each step meets its checkpoint. Status 0: all do; 1: not all. Without a lesson: lists those of the program.</source>
        <translation>Spielt eine Lektion bis zum Ende ab und prüft, ob jeder Schritt seinen Prüfpunkt erfüllt. Status 0: alle; 1: nicht alle. Ohne Lektion: listet die mitgelieferten auf.</translation>
    </message>
    <message>
        <source>A folder or a zip, or the name of a lesson of the program.</source>
        <translation>Ein Ordner, eine ZIP-Datei oder der Name einer mitgelieferten Lektion.</translation>
    </message>
    <message>
        <source>lesson: %1 does not end in .zip.</source>
        <translation>lesson: %1 endet nicht auf .zip.</translation>
    </message>
    <message>
        <source>lesson: %1 must be a folder, but ends in .zip.</source>
        <translation>lesson: %1 muss ein Ordner sein, endet aber auf .zip.</translation>
    </message>
    <message>
        <source>lesson: one lesson at a time can be played, not %1 as well.</source>
        <translation>lesson: Es kann immer nur eine Lektion abgespielt werden, nicht auch noch %1.</translation>
    </message>
    <message>
        <source>lesson: no lesson was given.</source>
        <translation>lesson: Es wurde keine Lektion angegeben.</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>%1. %2 (strokes: %3; tools: %4)</source>
        <translation>%1. %2 (Striche: %3; Werkzeuge: %4)</translation>
    </message>
    <message>
        <source>all</source>
        <translation>alle</translation>
    </message>
    <message>
        <source>%1: this picture cannot be written.</source>
        <translation>%1: Dieses Bild kann nicht geschrieben werden.</translation>
    </message>
    <message>
        <source>lesson: there is no step %1: the last one is %2.</source>
        <translation>lesson: Es gibt keinen Schritt %1: Der letzte ist %2.</translation>
    </message>
    <message>
        <source>lesson: step %1 has no checkpoint.</source>
        <translation>lesson: Schritt %1 hat keinen Prüfpunkt.</translation>
    </message>
    <message>
        <source>Language of the lesson and of the answer (default: the system&apos;s).</source>
        <translation>Sprache der Lektion und der Antwort (Vorgabe: die des Systems).</translation>
    </message>
    <message>
        <source>Print what pupils read, instead of playing.</source>
        <translation>Ausgeben, was die Kinder lesen, statt abzuspielen.</translation>
    </message>
    <message>
        <source>Judge this model of a pupil instead of playing; or -. A folder, or a class&apos;s work folder: judge each model.</source>
        <translation>Dieses Modell eines Kindes beurteilen, statt abzuspielen; oder -. Bei einem Ordner oder dem Arbeitsordner einer Klasse: jedes Modell.</translation>
    </message>
    <message>
        <source>Step whose checkpoint judges the model, from 1 (default: the last).</source>
        <translation>Schritt, dessen Prüfpunkt das Modell beurteilt, ab 1 (Vorgabe: der letzte).</translation>
    </message>
    <message>
        <source>File for the whole lesson, if all is well.</source>
        <translation>Datei für die ganze Lektion, wenn alles stimmt.</translation>
    </message>
    <message>
        <source>Folder for the lesson, where it can be changed.</source>
        <translation>Ordner für die Lektion, in dem sie geändert werden kann.</translation>
    </message>
    <message>
        <source>Folder for a picture of the result of each step, step-1.png and so on.</source>
        <translation>Ordner für ein Bild vom Ergebnis jedes Schritts, step-1.png und so weiter.</translation>
    </message>
    <message>
        <source>File for the model that the last step leaves.</source>
        <translation>Datei für das Modell nach dem letzten Schritt.</translation>
    </message>
    <message>
        <source>JSON: one object; of a folder of models, one for each, on a line of its own; without a lesson, the list of the program&apos;s.</source>
        <translation>JSON: ein Objekt; bei einem Ordner mit Modellen eines je Modell, jedes in einer eigenen Zeile; ohne Lektion die Liste der mitgelieferten.</translation>
    </message>
    <message>
        <source>CSV with a header row: a row for each goal; of a folder, for each model.</source>
        <translation>CSV mit Kopfzeile: eine Zeile für jedes Ziel, bei einem Ordner für jedes Modell.</translation>
    </message>
    <message>
        <source>%1 is not a folder.</source>
        <translation>%1 ist kein Ordner.</translation>
    </message>
    <message>
        <source>lesson: &quot;%1&quot; is not a lesson: it is neither one of %2 nor a folder or ZIP file.</source>
        <translation>lesson: „%1“ ist keine Lektion: weder eine von %2 noch ein Ordner oder eine ZIP-Datei.</translation>
    </message>
    <message>
        <source>no goal</source>
        <translation>kein Ziel</translation>
    </message>
    <message>
        <source>File for a handout: what pupils read, with the pictures; instead of playing.</source>
        <translation>Datei für ein Arbeitsblatt: was die Kinder lesen, mit den Bildern; statt abzuspielen.</translation>
    </message>
    <message>
        <source>lesson: %1 does not end in .pdf.</source>
        <translation>lesson: %1 endet nicht auf .pdf.</translation>
    </message>
</context>
<context>
    <name>app::LessonController</name>
    <message>
        <source>Opening %1</source>
        <translation>%1 wird geöffnet</translation>
    </message>
    <message>
        <source>Step %1 is not done yet. You can go back, or start from the teacher&apos;s model.</source>
        <translation>Schritt %1 ist noch nicht fertig. Du kannst zurückgehen oder mit dem Modell der Lehrkraft anfangen.</translation>
    </message>
    <message>
        <source>This is the teacher&apos;s model. Press Try It and make your own.</source>
        <translation>Das ist das Modell der Lehrkraft. Drücke „Versuchen“ und mach dein eigenes.</translation>
    </message>
</context>
<context>
    <name>app::LessonEditorController</name>
    <message>
        <source>Undone: a lesson cannot contain images or models from other files.</source>
        <translation>Rückgängig gemacht: Eine Lektion kann keine Bilder oder Modelle aus anderen Dateien enthalten.</translation>
    </message>
    <message>
        <source>The model is too large for a lesson.</source>
        <translation>Das Modell ist zu groß für eine Lektion.</translation>
    </message>
    <message>
        <source>Preparing the lesson</source>
        <translation>Die Lektion wird vorbereitet</translation>
    </message>
    <message>
        <source>Please wait: another operation on the model is still running.</source>
        <translation>Bitte warten: Am Modell läuft noch ein anderer Vorgang.</translation>
    </message>
    <message>
        <source>Playing the lesson to its end</source>
        <translation>Die Lektion wird bis zum Ende abgespielt</translation>
    </message>
    <message>
        <source>Unsaved lesson</source>
        <translation>Ungespeicherte Lektion</translation>
    </message>
    <message>
        <source>The lesson has unsaved changes.</source>
        <translation>Die Lektion hat ungespeicherte Änderungen.</translation>
    </message>
    <message>
        <source>An unsaved lesson was kept: Sculpt &gt; Record Lesson lists it.</source>
        <translation>Eine ungespeicherte Lektion wurde gesichert: Sie finden sie unter Formen &gt; Lektion aufzeichnen.</translation>
    </message>
    <message>
        <source>Not saved: %1</source>
        <translation>Nicht gespeichert: %1</translation>
    </message>
    <message>
        <source>New Lesson</source>
        <translation>Neue Lektion</translation>
    </message>
</context>
<context>
    <name>app::LessonProgress</name>
    <message numerus="yes">
        <source>You met %1 of %n goals.</source>
        <translation>
            <numerusform>Du hast %1 von %n Ziel erreicht.</numerusform>
            <numerusform>Du hast %1 von %n Zielen erreicht.</numerusform>
        </translation>
    </message>
    <message>
        <source>Keep sculpting, export your model, or save the steps as a handout.</source>
        <translation>Forme weiter, exportiere dein Modell oder speichere die Schritte als Arbeitsblatt.</translation>
    </message>
    <message>
        <source>Keep sculpting, if you like.</source>
        <translation>Forme weiter, wenn du magst.</translation>
    </message>
    <message>
        <source>Well done!</source>
        <translation>Gut gemacht!</translation>
    </message>
    <message>
        <source>That was the last step</source>
        <translation>Das war der letzte Schritt</translation>
    </message>
    <message>
        <source>%1: %2 of %3</source>
        <comment>step: goals met of goals</comment>
        <translation>%1: %2 von %3</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <comment>two sentences</comment>
        <extracomment>%1: how many of them</extracomment>
        <translation>%1 %2</translation>
    </message>
</context>
<context>
    <name>app::LessonResult</name>
    <message>
        <source>Lesson %1: step %2 of %3</source>
        <translation>Lektion %1: Schritt %2 von %3</translation>
    </message>
    <message>
        <source>this is the teacher&apos;s model</source>
        <translation>das ist das Modell der Lehrkraft</translation>
    </message>
</context>
<context>
    <name>app::LessonSaving</name>
    <message>
        <source>The lesson has no title yet.</source>
        <translation>Die Lektion hat noch keinen Titel.</translation>
    </message>
    <message>
        <source>The lesson has no steps yet.</source>
        <translation>Die Lektion hat noch keine Schritte.</translation>
    </message>
    <message>
        <source>Step %1 has no title yet.</source>
        <translation>Schritt %1 hat noch keinen Titel.</translation>
    </message>
    <message>
        <source>Step %1 has no text yet.</source>
        <translation>Schritt %1 hat noch keinen Text.</translation>
    </message>
    <message>
        <source>Step %1, stroke %2 (%3) no longer changes anything.</source>
        <translation>Schritt %1, Strich %2 (%3) ändert nichts mehr.</translation>
    </message>
    <message>
        <source>%1, %2 mm</source>
        <extracomment>a stroke&apos;s tool and radius</extracomment>
        <translation>%1, %2 mm</translation>
    </message>
    <message>
        <source>When replayed, the lesson does not end with the model in the window.</source>
        <translation>Beim erneuten Abspielen endet die Lektion nicht mit dem Modell im Fenster.</translation>
    </message>
    <message>
        <source>%1 already exists. Choose another name for the lesson&apos;s folder.</source>
        <translation>%1 gibt es schon. Wählen Sie einen anderen Namen für den Ordner der Lektion.</translation>
    </message>
    <message>
        <source>Step %1 is not met: %2.</source>
        <extracomment>a step&apos;s number; what it asks for, and what the teacher&apos;s own model has</extracomment>
        <translation>Schritt %1 ist nicht erfüllt: %2.</translation>
    </message>
</context>
<context>
    <name>app::LessonMessages</name>
    <message>
        <source>%1: %2</source>
        <comment>file: reason</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1: %2: %3</source>
        <comment>file: place: reason</comment>
        <translation>%1: %2: %3</translation>
    </message>
    <message>
        <source>step %1 (steps[%2])</source>
        <extracomment>counted from 1; in brackets as in the file, counted from 0</extracomment>
        <translation>Schritt %1 (steps[%2])</translation>
    </message>
    <message>
        <source>line %1, byte %2</source>
        <translation>Zeile %1, Byte %2</translation>
    </message>
    <message>
        <source>its lesson.json is not a lesson of Fettle</source>
        <translation>ihre lesson.json ist keine Lektion von Fettle</translation>
    </message>
    <message>
        <source>this lesson was made for a newer version of the program (format %1; this one reads format 1)</source>
        <translation>diese Lektion wurde für eine neuere Version des Programms erstellt (Format %1; diese liest Format 1)</translation>
    </message>
    <message>
        <source>its lesson.json is not JSON</source>
        <translation>ihre lesson.json ist kein JSON</translation>
    </message>
    <message>
        <source>its lesson.json nests deeper than a lesson does</source>
        <translation>ihre lesson.json ist tiefer verschachtelt als eine Lektion</translation>
    </message>
    <message>
        <source>&quot;%1&quot; appears twice</source>
        <translation>„%1“ kommt zweimal vor</translation>
    </message>
    <message>
        <source>unknown key %1</source>
        <translation>unbekannter Schlüssel %1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is missing</source>
        <translation>„%1“ fehlt</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must contain texts by language, as in {&quot;en&quot;: &quot;A mug&quot;}</source>
        <translation>„%1“ muss Texte nach Sprachen enthalten, wie in {&quot;de&quot;: &quot;Eine Tasse&quot;}</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must be a list of steps, as in [{…}, {…}]</source>
        <translation>„%1“ muss eine Liste von Schritten sein, wie in [{…}, {…}]</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must be a list of tools, as in [&quot;pull&quot;, &quot;smooth&quot;]</source>
        <translation>„%1“ muss eine Liste von Werkzeugen sein, wie in [&quot;pull&quot;, &quot;smooth&quot;]</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must contain goals, as in {&quot;height_mm&quot;: {&quot;least&quot;: 60}}</source>
        <translation>„%1“ muss Ziele enthalten, wie in {&quot;height_mm&quot;: {&quot;least&quot;: 60}}</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must be angles, as in {&quot;yaw_deg&quot;: 75, &quot;pitch_deg&quot;: -25}</source>
        <translation>„%1“ muss aus Winkeln bestehen, wie in {&quot;yaw_deg&quot;: 75, &quot;pitch_deg&quot;: -25}</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must contain a distance, as in {&quot;tolerance_mm&quot;: 2}</source>
        <translation>„%1“ muss einen Abstand enthalten, wie in {&quot;tolerance_mm&quot;: 2}</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must be a name in quotation marks</source>
        <translation>„%1“ muss ein Name in Anführungszeichen sein</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must be a whole number</source>
        <translation>„%1“ muss eine ganze Zahl sein</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must be a number</source>
        <translation>„%1“ muss eine Zahl sein</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must be true</source>
        <translation>„%1“ muss true sein</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must be a whole number or a range, such as {&quot;least&quot;: 1, &quot;most&quot;: 2}</source>
        <translation>„%1“ muss eine ganze Zahl sein, oder Grenzen, wie in {&quot;least&quot;: 1, &quot;most&quot;: 2}</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must be a number or a range, such as {&quot;least&quot;: 1, &quot;most&quot;: 2}</source>
        <translation>„%1“ muss eine Zahl sein, oder Grenzen, wie in {&quot;least&quot;: 1, &quot;most&quot;: 2}</translation>
    </message>
    <message>
        <source>unknown value, %1</source>
        <translation>unbekannter Wert, %1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is out of range, %2 to %3</source>
        <translation>„%1“ liegt außerhalb des Bereichs, %2 bis %3</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has no text in some language</source>
        <translation>„%1“ hat in einer Sprache keinen Text</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is too long: at most %2 of text are read</source>
        <translation>„%1“ ist zu lang: Höchstens %2 Text werden gelesen</translation>
    </message>
    <message>
        <source>it contains too many files: at most %1 are allowed</source>
        <translation>sie enthält zu viele Dateien: Höchstens %1 sind erlaubt</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has too many entries: at most %2 are read</source>
        <translation>„%1“ hat zu viele Einträge: Höchstens %2 werden gelesen</translation>
    </message>
    <message>
        <source>it refers to a file that is outside of its folder, or whose name is not allowed: %1</source>
        <translation>sie verweist auf eine Datei, die außerhalb ihres Ordners liegt oder deren Name nicht erlaubt ist: %1</translation>
    </message>
    <message>
        <source>it has no lesson.json: a lesson is a folder or ZIP file that contains one</source>
        <translation>sie enthält keine lesson.json: Eine Lektion ist ein Ordner oder eine ZIP-Datei, die eine enthält</translation>
    </message>
    <message>
        <source>this file is missing</source>
        <translation>diese Datei fehlt</translation>
    </message>
    <message>
        <source>this is too large for a lesson: at most %1 are read</source>
        <translation>das ist zu groß für eine Lektion: Höchstens %1 werden gelesen</translation>
    </message>
    <message>
        <source>this is not a PNG or JPEG picture</source>
        <translation>das ist kein PNG- oder JPEG-Bild</translation>
    </message>
    <message>
        <source>the strokes of a lesson cannot need other images or models</source>
        <translation>die Striche einer Lektion dürfen keine anderen Bilder oder Modelle verwenden</translation>
    </message>
    <message>
        <source>this command would break the model that it is applied to</source>
        <translation>dieser Befehl würde das Modell beschädigen, auf das er angewendet wird</translation>
    </message>
    <message>
        <source>ready to print</source>
        <translation>druckfertig</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1 cm²</source>
        <translation>%1 cm²</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>mindestens %1</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <comment>from; to</comment>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>höchstens %1</translation>
    </message>
    <message>
        <source>no holes</source>
        <translation>keine Löcher</translation>
    </message>
    <message>
        <source>one hole</source>
        <translation>ein Loch</translation>
    </message>
    <message>
        <source>holes: %1</source>
        <translation>Löcher: %1</translation>
    </message>
    <message>
        <source>in one piece</source>
        <translation>aus einem Stück</translation>
    </message>
    <message>
        <source>pieces: %1</source>
        <translation>Stücke: %1</translation>
    </message>
    <message>
        <source>%1 tall</source>
        <extracomment>%1 as in &quot;at least 60 mm&quot;, as in all that follow</extracomment>
        <translation>%1 hoch</translation>
    </message>
    <message>
        <source>%1 wide</source>
        <translation>%1 breit</translation>
    </message>
    <message>
        <source>%1 deep</source>
        <translation>%1 tief</translation>
    </message>
    <message>
        <source>%1 long, seen from above</source>
        <translation>von oben gesehen %1 lang</translation>
    </message>
    <message>
        <source>legs on the ground: %1</source>
        <translation>Beine am Boden: %1</translation>
    </message>
    <message>
        <source>flat base: %1</source>
        <translation>ebene Standfläche: %1</translation>
    </message>
    <message>
        <source>narrow places all around: %1</source>
        <translation>schmale Stellen ringsum: %1</translation>
    </message>
    <message>
        <source>%1 of clay</source>
        <translation>%1 Ton</translation>
    </message>
    <message>
        <source>triangles: %1</source>
        <translation>Dreiecke: %1</translation>
    </message>
    <message>
        <source>%1 (cannot be said of this model)</source>
        <translation>%1 (bei diesem Modell nicht messbar)</translation>
    </message>
    <message>
        <source>%1 (not yet)</source>
        <translation>%1 (noch nicht)</translation>
    </message>
    <message>
        <source>%1 (now %2)</source>
        <translation>%1 (jetzt %2)</translation>
    </message>
    <message>
        <source>%1 %2 mm</source>
        <extracomment>a tool and its radius</extracomment>
        <translation>%1 %2 mm</translation>
    </message>
    <message>
        <source>%1 %2 mm (strength %3)</source>
        <translation>%1 %2 mm (Stärke %3)</translation>
    </message>
    <message>
        <source>like the teacher&apos;s to %1 mm</source>
        <translation>wie das der Lehrkraft, bis auf %1 mm</translation>
    </message>
    <message>
        <source>something sculpted in this step</source>
        <translation>in diesem Schritt etwas geformt</translation>
    </message>
    <message>
        <source>like the teacher&apos;s to %1 mm (now up to %2)</source>
        <translation>wie das der Lehrkraft, bis auf %1 mm (jetzt bis zu %2)</translation>
    </message>
</context>
<context>
    <name>app::LessonWriter</name>
    <message>
        <source>%1 was not written.</source>
        <translation>%1 wurde nicht geschrieben.</translation>
    </message>
    <message numerus="yes">
        <source>And %n more.</source>
        <translation>
            <numerusform>Und %n weitere Meldung.</numerusform>
            <numerusform>Und %n weitere Meldungen.</numerusform>
        </translation>
    </message>
    <message>
        <source>Save the lesson</source>
        <translation>Lektion speichern</translation>
    </message>
    <message>
        <source>Not all goals of the lesson are met.</source>
        <translation>Nicht alle Ziele der Lektion sind erreicht.</translation>
    </message>
    <message>
        <source>Save All the Same</source>
        <translation>Trotzdem speichern</translation>
    </message>
    <message>
        <source>Saving %1</source>
        <translation>%1 wird gespeichert</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 wurde gespeichert.</translation>
    </message>
    <message>
        <source>Please wait: another operation on the model is still running.</source>
        <translation>Bitte warten: Am Modell läuft noch ein anderer Vorgang.</translation>
    </message>
    <message>
        <source>Playing the lesson to its end</source>
        <translation>Die Lektion wird bis zum Ende abgespielt</translation>
    </message>
</context>
<context>
    <name>app::ModelExport</name>
    <message>
        <source>Reducing the triangles</source>
        <translation>Dreiecke werden reduziert</translation>
    </message>
    <message>
        <source>Saved %1. It was not verified.</source>
        <translation>%1 wurde gespeichert, aber nicht geprüft.</translation>
    </message>
    <message>
        <source>%1: there is not enough memory to write this model.</source>
        <translation>%1: Der Speicher reicht nicht, um dieses Modell zu schreiben.</translation>
    </message>
    <message>
        <source>Exporting %1</source>
        <translation>%1 wird exportiert</translation>
    </message>
    <message>
        <source>Reading %1 back</source>
        <translation>%1 wird zur Prüfung gelesen</translation>
    </message>
    <message>
        <source>Saved %1, but reading it back gave something else. The disk may be failing, or another program may be changing the file.</source>
        <translation>%1 wurde gespeichert, ergab beim Lesen aber etwas anderes. Vielleicht ist der Datenträger defekt, oder ein anderes Programm ändert die Datei.</translation>
    </message>
    <message>
        <source>%1: %2 × %3 × %4 mm, %5 triangles; verified, watertight.</source>
        <translation>%1: %2 × %3 × %4 mm, %5 Dreiecke; geprüft, wasserdicht.</translation>
    </message>
    <message>
        <source>Its format has no colours; GLB and 3MF keep them.</source>
        <translation>Sein Format kennt keine Farben; GLB und 3MF behalten sie.</translation>
    </message>
    <message>
        <source>%1 triangles were asked for; this could not be reached without losing handles or parts, or flipping faces.</source>
        <translation>Verlangt waren %1 Dreiecke; das war nicht möglich, ohne Henkel oder Teile zu verlieren oder Flächen umzudrehen.</translation>
    </message>
    <message>
        <source>Slicing %1</source>
        <translation>%1 wird gesliced</translation>
    </message>
    <message>
        <source>Joining the parts</source>
        <translation>Teile werden vereinigt</translation>
    </message>
    <message>
        <source>%1 was not written: its parts overlap and cannot be joined. Move one a little, or export them one by one.</source>
        <translation>%1 wurde nicht geschrieben: Die Teile überlappen sich und lassen sich nicht vereinigen. Verschieben Sie eines ein wenig, oder exportieren Sie sie einzeln.</translation>
    </message>
    <message>
        <source>%1 was written with parts that overlap, as you wished: their surfaces intersect.</source>
        <translation>%1 wurde wie gewünscht mit Teilen geschrieben, die sich überschneiden: Ihre Oberflächen durchdringen sich.</translation>
    </message>
</context>
<context>
    <name>app::ModelLoader</name>
    <message>
        <source>Checking %1</source>
        <translation>%1 wird geprüft</translation>
    </message>
    <message>
        <source>%1 cannot be sculpted where it is: so far from the origin its coordinates are too coarse for its detail.</source>
        <translation>%1 lässt sich an seinem Ort nicht formen: So weit vom Ursprung entfernt sind seine Koordinaten zu grob für seine Details.</translation>
    </message>
    <message>
        <source>%1: there is not enough memory for this model.</source>
        <translation>%1: Für dieses Modell reicht der Speicher nicht.</translation>
    </message>
    <message>
        <source>Ball of clay</source>
        <translation>Tonkugel</translation>
    </message>
    <message>
        <source>%1: there is not enough memory to write this model.</source>
        <translation>%1: Der Speicher reicht nicht, um dieses Modell zu schreiben.</translation>
    </message>
    <message>
        <source>Cube</source>
        <translation>Würfel</translation>
    </message>
    <message>
        <source>Torus</source>
        <translation>Ring</translation>
    </message>
    <message>
        <source>Slab</source>
        <translation>Platte</translation>
    </message>
    <message>
        <source>Vase</source>
        <translation>Vase</translation>
    </message>
    <message>
        <source>Head</source>
        <translation>Kopf</translation>
    </message>
    <message>
        <source>Tablet</source>
        <translation>Tafel</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>%1 is very small in millimetres (%2). If it was made in another unit, undo, and say which when you insert it again.</source>
        <translation>%1 ist in Millimetern sehr klein (%2). Falls es in einer anderen Einheit erstellt wurde, machen Sie das Einfügen rückgängig und geben Sie beim nächsten Mal die Einheit an.</translation>
    </message>
    <message>
        <source>%1 was not written, because all parts are hidden. GLB keeps hidden parts.</source>
        <translation>%1 wurde nicht geschrieben, weil alle Teile ausgeblendet sind. GLB behält ausgeblendete Teile.</translation>
    </message>
    <message>
        <source>The objects of %1 overlap or touch, so each is a part.</source>
        <translation>Die Objekte von %1 überschneiden oder berühren sich, daher ist jedes ein Teil.</translation>
    </message>
    <message numerus="yes">
        <source>A repair makes one part of its %Ln objects.</source>
        <translation>
            <numerusform>Eine Reparatur macht aus seinem %Ln Objekt ein Teil.</numerusform>
            <numerusform>Eine Reparatur macht aus seinen %Ln Objekten ein Teil.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 has more objects than a model may have parts (%Ln), so they are one part.</source>
        <translation>
            <numerusform>%1 hat mehr Objekte, als ein Modell Teile haben darf (%Ln), daher sind sie ein Teil.</numerusform>
            <numerusform>%1 hat mehr Objekte, als ein Modell Teile haben darf (%Ln), daher sind sie ein Teil.</numerusform>
        </translation>
    </message>
    <message>
        <source>The objects of %1 are not solids of their own, so they are one part.</source>
        <translation>Die Objekte von %1 sind einzeln keine Körper, deshalb sind sie ein Teil.</translation>
    </message>
</context>
<context>
    <name>app::ModelOpener</name>
    <message>
        <source>Preparing the clay</source>
        <translation>Der Ton wird vorbereitet</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>%1 wird geöffnet</translation>
    </message>
    <message>
        <source>The model that you chose will open as soon as this is done.</source>
        <translation>Das gewählte Modell wird geöffnet, sobald dieser Vorgang fertig ist.</translation>
    </message>
    <message>
        <source>Recovering %1</source>
        <translation>%1 wird wiederhergestellt</translation>
    </message>
</context>
<context>
    <name>app::ModelSaver</name>
    <message>
        <source>Exporting %1</source>
        <translation>%1 wird exportiert</translation>
    </message>
    <message>
        <source>Saving %1</source>
        <translation>%1 wird gespeichert</translation>
    </message>
    <message>
        <source>%1 was not written.</source>
        <translation>%1 wurde nicht geschrieben.</translation>
    </message>
    <message>
        <source>Making a brush of %1</source>
        <translation>%1 wird zum Pinsel gemacht</translation>
    </message>
</context>
<context>
    <name>app::ModelSaving</name>
    <message>
        <source>Saved %1 without colours: its format has none. GLB keeps them.</source>
        <translation>%1 wurde ohne Farben gespeichert: Sein Format kennt keine. GLB behält sie.</translation>
    </message>
    <message>
        <source>%1 and %2 were written.</source>
        <translation>%1 und %2 wurden gespeichert.</translation>
    </message>
    <message>
        <source>Only %1 was written. %2</source>
        <translation>Nur %1 wurde gespeichert. %2</translation>
    </message>
    <message>
        <source>Saved %1 without the hidden parts: its format cannot keep them hidden. GLB keeps them.</source>
        <translation>%1 wurde ohne die ausgeblendeten Teile gespeichert: Das Format kann sie nicht ausgeblendet behalten. GLB behält sie.</translation>
    </message>
</context>
<context>
    <name>app::ModelChangeJob</name>
    <message>
        <source>There is not enough memory for this; the model stays as it is.</source>
        <translation>Dafür reicht der Speicher nicht; das Modell bleibt, wie es ist.</translation>
    </message>
</context>
<context>
    <name>app::CommandNames</name>
    <message>
        <source>Move</source>
        <comment>undo step</comment>
        <translation>Verschieben</translation>
    </message>
    <message>
        <source>Moving the model</source>
        <translation>Das Modell wird verschoben</translation>
    </message>
    <message>
        <source>Rotate</source>
        <comment>undo step</comment>
        <translation>Drehen</translation>
    </message>
    <message>
        <source>Rotating the model</source>
        <translation>Das Modell wird gedreht</translation>
    </message>
    <message>
        <source>Scale</source>
        <comment>undo step</comment>
        <translation>Skalieren</translation>
    </message>
    <message>
        <source>Scaling the model</source>
        <translation>Das Modell wird skaliert</translation>
    </message>
    <message>
        <source>Mirror</source>
        <comment>undo step</comment>
        <translation>Spiegeln</translation>
    </message>
    <message>
        <source>Mirroring the model</source>
        <translation>Das Modell wird gespiegelt</translation>
    </message>
    <message>
        <source>Recentre</source>
        <comment>undo step</comment>
        <translation>Zentrieren</translation>
    </message>
    <message>
        <source>Recentring the model</source>
        <translation>Das Modell wird zentriert</translation>
    </message>
    <message>
        <source>Insert</source>
        <comment>undo step</comment>
        <translation>Einfügen</translation>
    </message>
    <message>
        <source>Inserting a model</source>
        <translation>Ein Modell wird eingefügt</translation>
    </message>
    <message>
        <source>Fill</source>
        <comment>undo step</comment>
        <translation>Füllen</translation>
    </message>
    <message>
        <source>Colouring the model</source>
        <translation>Das Modell wird eingefärbt</translation>
    </message>
    <message>
        <source>Remesh</source>
        <comment>undo step</comment>
        <translation>Neu vernetzen</translation>
    </message>
    <message>
        <source>Remeshing the model</source>
        <translation>Das Modell wird neu vernetzt</translation>
    </message>
    <message>
        <source>Symmetrize</source>
        <comment>undo step</comment>
        <translation>Symmetrisieren</translation>
    </message>
    <message>
        <source>Making the model symmetric</source>
        <translation>Das Modell wird symmetrisiert</translation>
    </message>
    <message>
        <source>The mesh is as uniform as that already.</source>
        <translation>Das Netz ist bereits so gleichmäßig.</translation>
    </message>
    <message>
        <source>The model is like that already.</source>
        <translation>Das Modell ist bereits so.</translation>
    </message>
    <message>
        <source>The model stays as it is, because some of its faces would intersect after rounding to the program&apos;s grid (faces: %1).</source>
        <translation>Das Modell bleibt, wie es ist, weil sich einige seiner Flächen nach dem Runden auf das Raster des Programms schneiden würden (Flächen: %1).</translation>
    </message>
    <message>
        <source>The model stays as it is: nothing may be farther from the origin than four times its size.</source>
        <translation>Das Modell bleibt, wie es ist: Nichts darf weiter vom Ursprung entfernt liegen als das Vierfache seiner Größe.</translation>
    </message>
    <message>
        <source>The model stays as it is: its size must be between a millionth of a millimetre and ten kilometres.</source>
        <translation>Das Modell bleibt, wie es ist: Seine Größe muss zwischen einem Millionstel Millimeter und zehn Kilometern liegen.</translation>
    </message>
    <message>
        <source>%1 was not inserted, because one model would be inside the other. It must be outside, or in a hollow.</source>
        <translation>%1 wurde nicht eingefügt, weil ein Modell im anderen läge; es muss außerhalb oder in einem Hohlraum liegen.</translation>
    </message>
    <message>
        <source>%1 was not inserted, because there it would touch the model.</source>
        <translation>%1 wurde nicht eingefügt, weil es dort das Modell berühren würde.</translation>
    </message>
    <message>
        <source>The model stays as it is, because no part of it is on the side to keep.</source>
        <translation>Das Modell bleibt, wie es ist, weil auf der Seite, die bleiben soll, nichts davon liegt.</translation>
    </message>
    <message>
        <source>The model stays as it is, because the half and its mirror image would not make one sound surface.</source>
        <translation>Das Modell bleibt, wie es ist, weil die Hälfte und ihr Spiegelbild keine fehlerfreie Oberfläche ergäben.</translation>
    </message>
    <message>
        <source>The mesh stays as it is: with edges this short it would need too many triangles (%1).</source>
        <translation>Das Netz bleibt, wie es ist: Mit so kurzen Kanten bräuchte es zu viele Dreiecke (%1).</translation>
    </message>
    <message>
        <source>Reset</source>
        <comment>undo step</comment>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>Going back to the start</source>
        <translation>Zurück zum Anfang</translation>
    </message>
    <message>
        <source>Place on Bed</source>
        <comment>undo step</comment>
        <translation>Aufs Druckbett stellen</translation>
    </message>
    <message>
        <source>Placing the model on the bed</source>
        <translation>Das Modell wird aufs Druckbett gestellt</translation>
    </message>
    <message>
        <source>Flatten Base</source>
        <comment>undo step</comment>
        <translation>Unterseite ebnen</translation>
    </message>
    <message>
        <source>Flattening the base</source>
        <translation>Die Unterseite wird geebnet</translation>
    </message>
    <message>
        <source>The model stays as it is, because a cut at this height would not leave one sound surface; another height may do.</source>
        <translation>Das Modell bleibt, wie es ist, weil ein Schnitt in dieser Höhe keine fehlerfreie Oberfläche ergäbe; vielleicht geht es in einer anderen.</translation>
    </message>
    <message>
        <source>Changing the mask</source>
        <translation>Die Maske wird geändert</translation>
    </message>
    <message>
        <source>Invert Mask</source>
        <comment>undo step</comment>
        <translation>Maske umkehren</translation>
    </message>
    <message>
        <source>Clear Mask</source>
        <comment>undo step</comment>
        <translation>Maske löschen</translation>
    </message>
    <message>
        <source>Blur Mask</source>
        <comment>undo step</comment>
        <translation>Maske weichzeichnen</translation>
    </message>
    <message>
        <source>Sharpen Mask</source>
        <comment>undo step</comment>
        <translation>Maske schärfen</translation>
    </message>
    <message>
        <source>Grow Mask</source>
        <comment>undo step</comment>
        <translation>Maske vergrößern</translation>
    </message>
    <message>
        <source>Shrink Mask</source>
        <comment>undo step</comment>
        <translation>Maske verkleinern</translation>
    </message>
    <message>
        <source>Mask Cavities</source>
        <comment>undo step</comment>
        <translation>Vertiefungen maskieren</translation>
    </message>
    <message>
        <source>Mask by Colour</source>
        <comment>undo step</comment>
        <translation>Nach Farbe maskieren</translation>
    </message>
    <message>
        <source>The mask is like that already.</source>
        <translation>Die Maske ist bereits so.</translation>
    </message>
    <message>
        <source>Mask Whole Pieces</source>
        <comment>undo step</comment>
        <translation>Ganze Stücke maskieren</translation>
    </message>
    <message>
        <source>Join</source>
        <comment>undo step</comment>
        <translation>Vereinigen</translation>
    </message>
    <message>
        <source>Joining the parts</source>
        <translation>Teile werden vereinigt</translation>
    </message>
    <message>
        <source>Subtract</source>
        <comment>undo step</comment>
        <translation>Abziehen</translation>
    </message>
    <message>
        <source>Subtracting the parts</source>
        <translation>Teile werden abgezogen</translation>
    </message>
    <message>
        <source>Intersect</source>
        <comment>undo step</comment>
        <translation>Schnittmenge</translation>
    </message>
    <message>
        <source>Intersecting the parts</source>
        <translation>Schnittmenge der Teile wird gebildet</translation>
    </message>
    <message>
        <source>Edit Part</source>
        <comment>undo step</comment>
        <translation>Teil ändern</translation>
    </message>
    <message>
        <source>Changing the list of parts</source>
        <translation>Liste der Teile wird geändert</translation>
    </message>
    <message>
        <source>Show or Hide Parts</source>
        <comment>undo step</comment>
        <translation>Teile ein- oder ausblenden</translation>
    </message>
    <message>
        <source>Show</source>
        <comment>undo step</comment>
        <translation>Einblenden</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <comment>undo step</comment>
        <translation>Duplizieren</translation>
    </message>
    <message>
        <source>Duplicating the part</source>
        <translation>Teil wird dupliziert</translation>
    </message>
    <message>
        <source>Delete</source>
        <comment>undo step</comment>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Deleting the part</source>
        <translation>Teil wird gelöscht</translation>
    </message>
    <message>
        <source>Separate</source>
        <comment>undo step</comment>
        <translation>Trennen</translation>
    </message>
    <message>
        <source>Separating the part</source>
        <translation>Teil wird getrennt</translation>
    </message>
    <message>
        <source>The model stays as it is: it has no such part, or the part is empty.</source>
        <translation>Das Modell bleibt, wie es ist: Dieses Teil gibt es nicht, oder es ist leer.</translation>
    </message>
    <message>
        <source>The model stays as it is, because a part is hidden or locked. Show and unlock it first.</source>
        <translation>Das Modell bleibt, wie es ist, weil ein Teil ausgeblendet oder gesperrt ist. Blenden Sie es zuerst ein und entsperren Sie es.</translation>
    </message>
    <message>
        <source>The last part cannot be deleted.</source>
        <translation>Das letzte Teil lässt sich nicht löschen.</translation>
    </message>
    <message>
        <source>The part is in one piece already, so nothing was separated.</source>
        <translation>Das Teil besteht schon aus einem Stück; es wurde nichts getrennt.</translation>
    </message>
    <message numerus="yes">
        <source>The model stays as it is: it may have %Ln parts at most.</source>
        <translation>
            <numerusform>Das Modell bleibt, wie es ist: Es darf höchstens %Ln Teil haben.</numerusform>
            <numerusform>Das Modell bleibt, wie es ist: Es darf höchstens %Ln Teile haben.</numerusform>
        </translation>
    </message>
    <message>
        <source>The parts do not overlap, so nothing was subtracted.</source>
        <translation>Die Teile überschneiden sich nicht; es wurde nichts abgezogen.</translation>
    </message>
    <message>
        <source>Show All</source>
        <comment>undo step</comment>
        <translation>Alles einblenden</translation>
    </message>
    <message>
        <source>Hide</source>
        <comment>undo step</comment>
        <translation>Ausblenden</translation>
    </message>
    <message>
        <source>Hiding and showing</source>
        <translation>Ausblenden und Einblenden</translation>
    </message>
    <message>
        <source>Trim</source>
        <comment>undo step</comment>
        <translation>Wegschneiden</translation>
    </message>
    <message>
        <source>Trimming the model</source>
        <translation>Ein Teil des Modells wird weggeschnitten</translation>
    </message>
    <message>
        <source>Nothing is hidden.</source>
        <translation>Es ist nichts ausgeblendet.</translation>
    </message>
    <message>
        <source>The name was too long, so its end was cut off.</source>
        <translation>Der Name war zu lang; sein Ende wurde weggelassen.</translation>
    </message>
    <message>
        <source>Nothing is masked, so nothing was hidden.</source>
        <translation>Es ist nichts maskiert; es wurde nichts ausgeblendet.</translation>
    </message>
    <message>
        <source>The model stays as it is, because the curve does not go around an area.</source>
        <translation>Das Modell bleibt, wie es ist, weil die Kurve keine Fläche umschließt.</translation>
    </message>
    <message>
        <source>There is nothing to subtract: the models do not overlap.</source>
        <translation>Es gibt nichts abzuziehen: Die Modelle überschneiden sich nicht.</translation>
    </message>
    <message>
        <source>The shape</source>
        <translation>Der Körper</translation>
    </message>
    <message>
        <source>The model stays as it is, because nothing of it would be left.</source>
        <translation>Das Modell bleibt, wie es ist, weil nichts davon übrig bliebe.</translation>
    </message>
    <message>
        <source>The model stays as it is, because the surfaces nearly coincide and no sound cut was found; another place may do.</source>
        <translation>Das Modell bleibt, wie es ist, weil die Flächen fast aufeinander liegen und kein fehlerfreier Schnitt gefunden wurde; an einem anderen Ort kann es gelingen.</translation>
    </message>
    <message>
        <source>Unmask Area</source>
        <comment>undo step</comment>
        <translation>Maske im Bereich entfernen</translation>
    </message>
    <message>
        <source>Mask Area</source>
        <comment>undo step</comment>
        <translation>Bereich maskieren</translation>
    </message>
    <message>
        <source>Hide Area</source>
        <comment>undo step</comment>
        <translation>Bereich ausblenden</translation>
    </message>
    <message>
        <source>Split Off</source>
        <comment>undo step</comment>
        <translation>Abtrennen</translation>
    </message>
    <message>
        <source>Splitting the part</source>
        <translation>Teil wird zerschnitten</translation>
    </message>
    <message>
        <source>The part stays as it is, because all of it is masked or hidden.</source>
        <translation>Das Teil bleibt, wie es ist, weil es ganz maskiert oder ausgeblendet ist.</translation>
    </message>
    <message>
        <source>Nothing is masked in the area.</source>
        <translation>In dem Bereich ist nichts maskiert.</translation>
    </message>
    <message>
        <source>Nothing was masked: none of the model is in the area, or it is masked already.</source>
        <translation>Nichts wurde maskiert: In dem Bereich ist nichts vom Modell, oder es ist bereits maskiert.</translation>
    </message>
    <message>
        <source>Nothing was hidden: none of the model is in the area.</source>
        <translation>Nichts wurde ausgeblendet: In dem Bereich ist nichts vom Modell.</translation>
    </message>
    <message>
        <source>A part can only be combined with others. Choose at least one more.</source>
        <translation>Ein Teil lässt sich nur mit anderen verbinden. Wählen Sie mindestens ein weiteres.</translation>
    </message>
    <message>
        <source>Nothing was split off: all of the part is on one side of the cut.</source>
        <translation>Nichts wurde abgetrennt: Das ganze Teil liegt auf einer Seite des Schnitts.</translation>
    </message>
    <message>
        <source>Nothing was cut away: none of the model is on that side of the cut.</source>
        <translation>Nichts wurde weggeschnitten: Auf dieser Seite des Schnitts ist nichts vom Modell.</translation>
    </message>
    <message>
        <source>The model stays as it is, because its surface would pass through itself (faces: %1). Turn or move it less, or blur the mask.</source>
        <translation>Das Modell bleibt, wie es ist, weil seine Oberfläche sich selbst durchdringen würde (Flächen: %1). Drehen oder verschieben Sie es weniger, oder machen Sie den Rand der Maske weicher.</translation>
    </message>
    <message>
        <source>The model stays as it is, because the cut would not leave one sound surface; a cut elsewhere may do.</source>
        <translation>Das Modell bleibt, wie es ist, weil der Schnitt keine fehlerfreie Oberfläche ergäbe; vielleicht geht es mit einem Schnitt an anderer Stelle.</translation>
    </message>
</context>
<context>
    <name>app::PartnerView</name>
    <message>
        <source>Your partner undid: %1.</source>
        <translation>Am Fenster rückgängig gemacht: %1.</translation>
    </message>
    <message>
        <source>Your partner redid: %1.</source>
        <translation>Am Fenster wiederholt: %1.</translation>
    </message>
    <message>
        <source>Your partner chose %1, %2 mm.</source>
        <extracomment>%1: a tool; %2: a length</extracomment>
        <translation>Am Fenster gewählt: %1, %2 mm.</translation>
    </message>
    <message>
        <source>Your partner chose a strength of %1 %.</source>
        <translation>Am Fenster gewählt: Stärke %1 %.</translation>
    </message>
    <message>
        <source>Your partner is sculpting now.</source>
        <translation>Jetzt wird am Fenster geformt.</translation>
    </message>
    <message>
        <source>It is your turn again.</source>
        <translation>Sie sind wieder an der Reihe.</translation>
    </message>
</context>
<context>
    <name>app::ReplayCommand</name>
    <message>
        <source>Plays recorded strokes on a model, or on the paper&apos;s sphere.</source>
        <translation>Spielt aufgezeichnete Striche auf einem Modell ab oder auf der Kugel der Veröffentlichung.</translation>
    </message>
    <message>
        <source>replay: %1 is not an option; give the model with --in.</source>
        <translation>replay: %1 ist keine Option; das Modell wird mit --in angegeben.</translation>
    </message>
    <message>
        <source>--parts keeps its objects apart, which may overlap then.</source>
        <translation>--parts hält seine Objekte getrennt, die sich dann überschneiden dürfen.</translation>
    </message>
    <message>
        <source>replay: --strokes is missing.</source>
        <translation>replay: --strokes fehlt.</translation>
    </message>
    <message>
        <source>replay: %1 and %2 name the same file, %3.</source>
        <translation>replay: %1 und %2 nennen dieselbe Datei, %3.</translation>
    </message>
    <message>
        <source>replay: the mesh is not valid after dab %1.</source>
        <translation>replay: Das Netz ist nach Tupfer %1 ungültig.</translation>
    </message>
    <message>
        <source>replay: strokes[%1]: %2</source>
        <translation>replay: strokes[%1]: %2</translation>
    </message>
    <message>
        <source>The strokes, JSON; or -.</source>
        <translation>Die Striche, JSON; oder -.</translation>
    </message>
    <message>
        <source>The model; or - (default: a sphere of 2562 vertices, radius 1).</source>
        <translation>Das Modell; oder - (Vorgabe: eine Kugel mit 2562 Eckpunkten und Radius 1).</translation>
    </message>
    <message>
        <source>File for the sculpted model; or -.</source>
        <translation>Datei für das geformte Modell; oder -.</translation>
    </message>
    <message>
        <source>File for cost and outcome of each dab, JSON; or -.</source>
        <translation>Datei für Aufwand und Ergebnis jedes Tupfers, JSON; oder -.</translation>
    </message>
    <message>
        <source>Folder for pictures of the model, PNG, at the start and after each stroke.</source>
        <translation>Ordner für Bilder des Modells, PNG, am Anfang und nach jedem Strich.</translation>
    </message>
    <message>
        <source>Strokes from one picture to the next (default: 1).</source>
        <translation>Striche von einem Bild zum nächsten (Vorgabe: 1).</translation>
    </message>
    <message>
        <source>local: what changed (as in the window, the default); full: the whole mesh after each dab as well; none: for measurements, without --out.</source>
        <translation>local: was sich geändert hat (wie im Fenster, die Vorgabe); full: nach jedem Tupfer auch das ganze Netz; none: für Messungen, ohne --out.</translation>
    </message>
    <message>
        <source>replay: --verify none and --out cannot be used together: what is not verified is not kept.</source>
        <translation>replay: --verify none und --out lassen sich nicht zusammen verwenden: Was nicht geprüft ist, wird nicht behalten.</translation>
    </message>
    <message>
        <source>%1: %2: %3</source>
        <comment>file: place: reason</comment>
        <translation>%1: %2: %3</translation>
    </message>
    <message>
        <source>Strokes: %1, commands: %2, dabs: %3. Size: %4 x %5 x %6 mm, triangles: %7. Time: %8 s.</source>
        <translation>Striche: %1, Befehle: %2, Tupfer: %3. Größe: %4 x %5 x %6 mm, Dreiecke: %7. Zeit: %8 s.</translation>
    </message>
    <message>
        <source>Make a part of each object of the model; parts may overlap.</source>
        <translation>Aus jedem Objekt des Modells ein Teil machen; Teile dürfen sich überschneiden.</translation>
    </message>
    <message>
        <source>The parts overlap, so they were united.</source>
        <translation>Die Teile überschneiden sich, deshalb wurden sie vereinigt.</translation>
    </message>
    <message>
        <source>%1: the parts overlap and cannot be united. A GLB file keeps them apart.</source>
        <translation>%1: Die Teile überschneiden sich und lassen sich nicht vereinigen. Eine GLB-Datei hält sie getrennt.</translation>
    </message>
</context>
<context>
    <name>app::ReportCommand</name>
    <message>
        <source>Writes a class report: for each model in a folder its picture, size and volume, whether it is print-ready or why not, and, for GLB files, the number of strokes and the time spent. Pupils&apos; models are listed by pupil, with the time of the turn. Status 1: not all models can be read.</source>
        <translation>Schreibt einen Klassenbericht: zu jedem Modell eines Ordners Bild, Größe und Volumen, ob es druckfertig ist oder warum nicht, und bei GLB-Dateien die Zahl der Striche und die Arbeitszeit. Modelle von Kindern stehen unter deren Namen, mit der Dauer des Durchgangs. Status 1: nicht alle Modelle sind lesbar.</translation>
    </message>
    <message>
        <source>The models. Subfolders are skipped, except the pupils&apos; models of a class.</source>
        <translation>Die Modelle. Unterordner werden übergangen, außer denen mit den Modellen der Kinder einer Klasse.</translation>
    </message>
    <message numerus="yes">
        <source>report: needs one folder; %n were given.</source>
        <translation>
            <numerusform>report: braucht einen Ordner; angegeben wurde %n.</numerusform>
            <numerusform>report: braucht einen Ordner; angegeben wurden %n.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>app::ReportController</name>
    <message>
        <source>The class report has to wait until this is done; try again then.</source>
        <translation>Der Klassenbericht muss warten, bis dies fertig ist; versuchen Sie es dann noch einmal.</translation>
    </message>
    <message>
        <source>Looking at the models in %1</source>
        <translation>Die Modelle in %1 werden untersucht</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 wurde gespeichert.</translation>
    </message>
    <message>
        <source>%1 was not written.</source>
        <translation>%1 wurde nicht geschrieben.</translation>
    </message>
</context>
<context>
    <name>app::ReportWriter</name>
    <message>
        <source>%1: there is not enough memory for this model.</source>
        <translation>%1: Für dieses Modell reicht der Speicher nicht.</translation>
    </message>
</context>
<context>
    <name>app::SheetCommand</name>
    <message>
        <source>Writes scale drawings of models, one A4 page each, in the order of their names. Pupils&apos; models are named by pupil. Status 1: not all models can be drawn.</source>
        <translation>Schreibt maßstäbliche Zeichnungen von Modellen, je eine Seite A4, nach Namen geordnet. Modelle von Kindern tragen deren Namen. Status 1: nicht alle Modelle lassen sich zeichnen.</translation>
    </message>
    <message>
        <source>%1 has no sheet, because its surface does not enclose anything (%2).</source>
        <translation>%1 bekommt kein Blatt, weil seine Oberfläche nichts umschließt (%2).</translation>
    </message>
    <message>
        <source>%1 was not written: none of the models can be drawn.</source>
        <translation>%1 wurde nicht geschrieben: Keines der Modelle lässt sich zeichnen.</translation>
    </message>
    <message>
        <source>Models, or folders of models; or -.</source>
        <translation>Modelle oder Ordner mit Modellen; oder -.</translation>
    </message>
    <message>
        <source>Draws colours under the lines.</source>
        <translation>Farben unter den Linien.</translation>
    </message>
</context>
<context>
    <name>app::Simulator</name>
    <message>
        <source>The VR simulator cannot be loaded: %1</source>
        <translation>Der VR-Simulator lässt sich nicht laden: %1</translation>
    </message>
    <message>
        <source>The VR simulator is not installed with this program: there is no folder %1 beside it with fettle_simulator.json.</source>
        <translation>Der VR-Simulator ist nicht mit diesem Programm installiert: Daneben fehlt der Ordner %1 mit fettle_simulator.json.</translation>
    </message>
</context>
<context>
    <name>app::SlicerCheck</name>
    <message>
        <source>PrusaSlicer was stopped.</source>
        <translation>PrusaSlicer wurde abgebrochen.</translation>
    </message>
    <message>
        <source>PrusaSlicer took longer than three minutes and was stopped.</source>
        <translation>PrusaSlicer brauchte länger als drei Minuten und wurde abgebrochen.</translation>
    </message>
    <message>
        <source>PrusaSlicer cannot slice it: %1</source>
        <translation>PrusaSlicer kann es nicht slicen: %1</translation>
    </message>
    <message>
        <source>The sliced file cannot be read: %1</source>
        <translation>Die Ausgabe von PrusaSlicer kann nicht gelesen werden: %1</translation>
    </message>
    <message>
        <source>PrusaSlicer slices it: layers %1, time %2.</source>
        <translation>PrusaSlicer hat es gesliced: Schichten %1, Zeit %2.</translation>
    </message>
</context>
<context>
    <name>app::StrokeStep</name>
    <message>
        <source>Pull</source>
        <comment>undo step</comment>
        <translation>Ziehen</translation>
    </message>
    <message>
        <source>Push</source>
        <comment>undo step</comment>
        <translation>Drücken</translation>
    </message>
    <message>
        <source>Flatten</source>
        <comment>undo step</comment>
        <translation>Abflachen</translation>
    </message>
    <message>
        <source>Smooth</source>
        <comment>undo step</comment>
        <translation>Glätten</translation>
    </message>
    <message>
        <source>Paint</source>
        <comment>undo step</comment>
        <translation>Bemalen</translation>
    </message>
    <message>
        <source>Add Ball</source>
        <comment>undo step</comment>
        <translation>Kugel hinzufügen</translation>
    </message>
    <message>
        <source>Inflate</source>
        <comment>undo step</comment>
        <translation>Aufblähen</translation>
    </message>
    <message>
        <source>Clay</source>
        <comment>undo step</comment>
        <translation>Auftragen</translation>
    </message>
    <message>
        <source>Layer</source>
        <comment>undo step</comment>
        <translation>Schichten</translation>
    </message>
    <message>
        <source>Scrape</source>
        <comment>undo step</comment>
        <translation>Schaben</translation>
    </message>
    <message>
        <source>Pinch</source>
        <comment>undo step</comment>
        <translation>Kneifen</translation>
    </message>
    <message>
        <source>Crease</source>
        <comment>undo step</comment>
        <translation>Kerben</translation>
    </message>
    <message>
        <source>Grab</source>
        <comment>undo step</comment>
        <translation>Greifen</translation>
    </message>
    <message>
        <source>Snake Hook</source>
        <comment>undo step</comment>
        <translation>Tentakel</translation>
    </message>
    <message>
        <source>Twist</source>
        <comment>undo step</comment>
        <translation>Verdrehen</translation>
    </message>
    <message>
        <source>Mask</source>
        <comment>undo step</comment>
        <translation>Maske</translation>
    </message>
    <message>
        <source>Stamp</source>
        <comment>undo step</comment>
        <translation>Stempel</translation>
    </message>
    <message>
        <source>Add Model</source>
        <comment>undo step</comment>
        <translation>Modell hinzufügen</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>undo step: name of the part, what was done to it</comment>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>app::StrokeEdit</name>
    <message>
        <source>With this brush it does nothing.</source>
        <translation>Mit diesem Pinsel bewirkt der Strich nichts.</translation>
    </message>
</context>
<context>
    <name>app::StrokeAssets</name>
    <message>
        <source>%1: %2: %3</source>
        <comment>file: place: reason</comment>
        <translation>%1: %2: %3</translation>
    </message>
    <message>
        <source>%1 has changed since this stroke was recorded.</source>
        <translation>%1 hat sich geändert, seit dieser Strich aufgezeichnet wurde.</translation>
    </message>
    <message>
        <source>alpha: &quot;%1&quot; is none of %2, and no file</source>
        <translation>alpha: „%1“ ist keins von %2 und keine Datei</translation>
    </message>
</context>
<context>
    <name>app::TimeLapse</name>
    <message>
        <source>%1 already contains %2, and nothing was overwritten: choose an empty folder.</source>
        <translation>In %1 gibt es schon %2; nichts wurde überschrieben. Wählen Sie einen leeren Ordner.</translation>
    </message>
    <message>
        <source>There is not enough memory for a time-lapse of this model.</source>
        <translation>Für einen Zeitraffer dieses Modells reicht der Speicher nicht.</translation>
    </message>
    <message>
        <source>The earlier steps of the model can no longer be read, so they are not in the time-lapse.</source>
        <translation>Die früheren Schritte des Modells sind nicht mehr lesbar und fehlen daher im Zeitraffer.</translation>
    </message>
    <message>
        <source>%1 is not a folder.</source>
        <translation>%1 ist kein Ordner.</translation>
    </message>
</context>
<context>
    <name>app::TimeLapseController</name>
    <message>
        <source>Drawing the time-lapse</source>
        <translation>Der Zeitraffer wird gezeichnet</translation>
    </message>
    <message>
        <source>The time-lapse has to wait until this is done; try again then.</source>
        <translation>Der Zeitraffer muss warten, bis dies fertig ist; versuchen Sie es dann noch einmal.</translation>
    </message>
    <message>
        <source>The time-lapse was stopped; no picture of it is in %1.</source>
        <translation>Der Zeitraffer wurde abgebrochen; in %1 liegt kein Bild davon.</translation>
    </message>
    <message numerus="yes">
        <source>%1: %Ln pictures were written.</source>
        <translation>
            <numerusform>%1: %Ln Bild wurde gespeichert.</numerusform>
            <numerusform>%1: %Ln Bilder wurden gespeichert.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::About</name>
    <message>
        <source>About Fettle</source>
        <translation>Über Fettle</translation>
    </message>
    <message>
        <source>Fettle %1

Sculpt a model with mouse, pen or VR controllers, and export it ready to print.</source>
        <translation>Fettle %1

Modelle mit Maus, Stift oder VR-Controllern formen und druckfertig exportieren.</translation>
    </message>
</context>
<context>
    <name>ui::Actions</name>
    <message>
        <source>&amp;Open…</source>
        <translation>Ö&amp;ffnen …</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>E&amp;xportieren …</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>Closes the window and ends the program.</source>
        <translation>Schließt das Fenster und beendet das Programm.</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>Undoes the last step.</source>
        <translation>Macht den letzten Schritt rückgängig.</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederherstellen</translation>
    </message>
    <message>
        <source>Redoes the last undone step.</source>
        <translation>Stellt den zuletzt rückgängig gemachten Schritt wieder her.</translation>
    </message>
    <message>
        <source>&amp;Pull</source>
        <translation>&amp;Ziehen</translation>
    </message>
    <message>
        <source>P&amp;ush</source>
        <translation>&amp;Drücken</translation>
    </message>
    <message>
        <source>&amp;Smooth</source>
        <translation>&amp;Glätten</translation>
    </message>
    <message>
        <source>Smooths the surface.</source>
        <translation>Glättet die Oberfläche.</translation>
    </message>
    <message>
        <source>S&amp;maller Brush</source>
        <translation>&amp;Kleinerer Pinsel</translation>
    </message>
    <message>
        <source>Makes the brush&apos;s radius a tenth smaller.</source>
        <translation>Verkleinert den Pinselradius um ein Zehntel.</translation>
    </message>
    <message>
        <source>&amp;Larger Brush</source>
        <translation>G&amp;rößerer Pinsel</translation>
    </message>
    <message>
        <source>Makes the brush&apos;s radius a tenth larger.</source>
        <translation>Vergrößert den Pinselradius um ein Zehntel.</translation>
    </message>
    <message>
        <source>&amp;Frame Model</source>
        <translation>Modell &amp;einpassen</translation>
    </message>
    <message>
        <source>Shows the whole model.</source>
        <translation>Zeigt das ganze Modell.</translation>
    </message>
    <message>
        <source>F&amp;ront</source>
        <translation>&amp;Vorn</translation>
    </message>
    <message>
        <source>Shows the model from the front: x to the right, y up.</source>
        <translation>Zeigt das Modell von vorn: x nach rechts, y nach oben.</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Hinten</translation>
    </message>
    <message>
        <source>Shows the model from behind: x to the left, y up.</source>
        <translation>Zeigt das Modell von hinten: x nach links, y nach oben.</translation>
    </message>
    <message>
        <source>R&amp;ight</source>
        <translation>&amp;Rechts</translation>
    </message>
    <message>
        <source>Shows the model from the right: z to the left, y up.</source>
        <translation>Zeigt das Modell von rechts: z nach links, y nach oben.</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>&amp;Links</translation>
    </message>
    <message>
        <source>Shows the model from the left: z to the right, y up.</source>
        <translation>Zeigt das Modell von links: z nach rechts, y nach oben.</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>&amp;Oben</translation>
    </message>
    <message>
        <source>Shows the model from above: x to the right, z down.</source>
        <translation>Zeigt das Modell von oben: x nach rechts, z nach unten.</translation>
    </message>
    <message>
        <source>Botto&amp;m</source>
        <translation>&amp;Unten</translation>
    </message>
    <message>
        <source>Shows the model from below: x to the right, z up.</source>
        <translation>Zeigt das Modell von unten: x nach rechts, z nach oben.</translation>
    </message>
    <message>
        <source>&amp;Orthographic</source>
        <translation>&amp;Parallelprojektion</translation>
    </message>
    <message>
        <source>Turns perspective off and on.</source>
        <translation>Schaltet die Perspektive aus und ein.</translation>
    </message>
    <message>
        <source>&amp;Look for a Headset</source>
        <translation>VR-&amp;Brille suchen</translation>
    </message>
    <message>
        <source>Checks whether a VR headset is ready.</source>
        <translation>Prüft, ob eine VR-Brille bereit ist.</translation>
    </message>
    <message>
        <source>&amp;About Fettle</source>
        <translation>Ü&amp;ber Fettle</translation>
    </message>
    <message>
        <source>Shows what this program is, and its version.</source>
        <translation>Zeigt, was dieses Programm ist, und seine Version.</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;Sculpt</source>
        <translation>&amp;Formen</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>V&amp;R</source>
        <translation>V&amp;R</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Abbrechen</translation>
    </message>
    <message>
        <source>Stops what is running. The model stays as it is.</source>
        <translation>Bricht ab, was gerade läuft. Das Modell bleibt, wie es ist.</translation>
    </message>
    <message>
        <source>&amp;Scale…</source>
        <translation>&amp;Skalieren …</translation>
    </message>
    <message>
        <source>Makes the whole model larger or smaller.</source>
        <translation>Macht das ganze Modell größer oder kleiner.</translation>
    </message>
    <message>
        <source>M&amp;irror…</source>
        <translation>S&amp;piegeln …</translation>
    </message>
    <message>
        <source>Turns the active part into its mirror image.</source>
        <translation>Ersetzt das aktive Teil durch sein Spiegelbild.</translation>
    </message>
    <message>
        <source>S&amp;ymmetrize…</source>
        <translation>S&amp;ymmetrisieren …</translation>
    </message>
    <message>
        <source>Replaces one half of the model by the mirror image of the other.</source>
        <translation>Ersetzt eine Hälfte des Modells durch das Spiegelbild der anderen.</translation>
    </message>
    <message>
        <source>Re&amp;centre</source>
        <translation>&amp;Zentrieren</translation>
    </message>
    <message>
        <source>Moves the middle of the model to the origin.</source>
        <translation>Verschiebt die Mitte des Modells in den Ursprung.</translation>
    </message>
    <message>
        <source>I&amp;nsert…</source>
        <translation>&amp;Einfügen …</translation>
    </message>
    <message>
        <source>Remesh &amp;Uniformly…</source>
        <translation>&amp;Gleichmäßig neu vernetzen …</translation>
    </message>
    <message>
        <source>Makes all triangles of the model about the same size.</source>
        <translation>Macht alle Dreiecke des Modells etwa gleich groß.</translation>
    </message>
    <message>
        <source>&amp;Flatten</source>
        <translation>Ab&amp;flachen</translation>
    </message>
    <message>
        <source>Levels the surface. Shift smooths.</source>
        <translation>Ebnet die Oberfläche ein. Umschalt glättet.</translation>
    </message>
    <message>
        <source>P&amp;aint</source>
        <translation>B&amp;emalen</translation>
    </message>
    <message>
        <source>Colours the surface without changing its shape. Shift smooths.</source>
        <translation>Färbt die Oberfläche, ohne ihre Form zu ändern. Umschalt glättet.</translation>
    </message>
    <message>
        <source>&amp;Ray Brush</source>
        <translation>&amp;Strahlpinsel</translation>
    </message>
    <message>
        <source>Affects only points connected along the surface, not the far side of a fold.</source>
        <translation>Wirkt nur auf Punkte, die entlang der Oberfläche verbunden sind, nicht auf die andere Seite einer Falte.</translation>
    </message>
    <message>
        <source>Un&amp;iform Topology</source>
        <translation>Gle&amp;ichmäßiges Netz</translation>
    </message>
    <message>
        <source>Keeps one edge length for the whole model instead of one that follows the brush.</source>
        <translation>Verwendet eine Kantenlänge für das ganze Modell statt einer, die dem Pinsel folgt.</translation>
    </message>
    <message>
        <source>&amp;Fusion</source>
        <translation>&amp;Verschmelzen</translation>
    </message>
    <message>
        <source>Joins surfaces that touch and parts thin necks. When off, surfaces stop where they touch.</source>
        <translation>Verbindet Flächen, die sich berühren, und trennt dünne Stege. Ist es aus, halten Flächen an, wo sie sich berühren.</translation>
    </message>
    <message>
        <source>S&amp;ymmetry</source>
        <translation>S&amp;ymmetrie</translation>
    </message>
    <message>
        <source>Mirrors your strokes across the symmetry plane.</source>
        <translation>Spiegelt Ihre Striche an der Symmetrieebene.</translation>
    </message>
    <message>
        <source>&amp;Commands and Keys…</source>
        <translation>B&amp;efehle und Tasten …</translation>
    </message>
    <message>
        <source>Shows every command with its key, and searches them.</source>
        <translation>Listet alle Befehle mit ihren Tasten auf und durchsucht sie.</translation>
    </message>
    <message>
        <source>&amp;Wireframe</source>
        <translation>&amp;Drahtgitter</translation>
    </message>
    <message>
        <source>Draws the edges of the triangles over the model.</source>
        <translation>Zeichnet die Kanten der Dreiecke über das Modell.</translation>
    </message>
    <message>
        <source>Fl&amp;at Shading</source>
        <translation>Fl&amp;ach schattieren</translation>
    </message>
    <message>
        <source>Shows each triangle in one shade instead of a smooth surface.</source>
        <translation>Schattiert jedes Dreieck einzeln statt als glatte Oberfläche.</translation>
    </message>
    <message>
        <source>Cavit&amp;y Shade</source>
        <translation>Vertie&amp;fungen abdunkeln</translation>
    </message>
    <message>
        <source>Darkens hollows and lightens ridges, so that fine shapes stand out.</source>
        <translation>Dunkelt Vertiefungen ab und hellt Grate auf, damit feine Formen hervortreten.</translation>
    </message>
    <message>
        <source>Tint &amp;under the Brush</source>
        <translation>Tönung unter dem Pi&amp;nsel</translation>
    </message>
    <message>
        <source>Tints the area that the brush would affect.</source>
        <translation>Tönt den Bereich, auf den der Pinsel wirken würde.</translation>
    </message>
    <message>
        <source>Symmetry &amp;Plane</source>
        <translation>S&amp;ymmetrieebene</translation>
    </message>
    <message>
        <source>Shows where the model is mirrored while symmetry is on.</source>
        <translation>Zeigt, wo das Modell gespiegelt wird, solange die Symmetrie an ist.</translation>
    </message>
    <message>
        <source>&amp;Ground Grid</source>
        <translation>Boden&amp;gitter</translation>
    </message>
    <message>
        <source>Shows a grid in millimetres under the model.</source>
        <translation>Zeigt unter dem Modell ein Gitter in Millimetern.</translation>
    </message>
    <message>
        <source>&amp;Scale Bar</source>
        <translation>&amp;Maßstab</translation>
    </message>
    <message>
        <source>Shows a length in millimetres in the corner of the view.</source>
        <translation>Zeigt in der Ecke der Ansicht eine Länge in Millimetern.</translation>
    </message>
    <message>
        <source>View &amp;Cube</source>
        <translation>Ansichts&amp;würfel</translation>
    </message>
    <message>
        <source>Shows a cube in the corner of the view: click a face to look from there.</source>
        <translation>Zeigt in der Ecke der Ansicht einen Würfel: Ein Klick auf eine Seite zeigt das Modell von dort.</translation>
    </message>
    <message>
        <source>Tool &amp;Names</source>
        <translation>Wer&amp;kzeugnamen</translation>
    </message>
    <message>
        <source>Writes the name of each tool below its icon.</source>
        <translation>Schreibt den Namen jedes Werkzeugs unter sein Symbol.</translation>
    </message>
    <message>
        <source>Panels on the Left Si&amp;de</source>
        <translation>Bedienfelder auf der linken Sei&amp;te</translation>
    </message>
    <message>
        <source>Moves the panels to the left of the view, for left-handed use.</source>
        <translation>Setzt die Bedienfelder links neben die Ansicht, für Linkshänder.</translation>
    </message>
    <message>
        <source>Brus&amp;h Palette</source>
        <translation>Palette &amp;beim Zeiger</translation>
    </message>
    <message>
        <source>Opens tools, radius and strength at the pointer, as a right click does.</source>
        <translation>Öffnet Werkzeuge, Radius und Stärke am Zeiger, wie ein Rechtsklick.</translation>
    </message>
    <message>
        <source>Brus&amp;h Presets</source>
        <translation>P&amp;inselvorlagen</translation>
    </message>
    <message>
        <source>Shows the panel with brush presets.</source>
        <translation>Zeigt das Bedienfeld mit den Pinselvorlagen.</translation>
    </message>
    <message>
        <source>&amp;Clay</source>
        <translation>&amp;Ton</translation>
    </message>
    <message>
        <source>Shows the model as warm, dull clay.</source>
        <translation>Zeigt das Modell als warmen, matten Ton.</translation>
    </message>
    <message>
        <source>&amp;Grey Clay</source>
        <translation>&amp;Grauer Ton</translation>
    </message>
    <message>
        <source>Shows the model as cool grey clay, which hides no bump.</source>
        <translation>Zeigt das Modell als kühlen grauen Ton, auf dem jede Unebenheit zu sehen ist.</translation>
    </message>
    <message>
        <source>Red &amp;Wax</source>
        <translation>Rotes &amp;Wachs</translation>
    </message>
    <message>
        <source>Shows the model as red wax, soft in the shadows and shiny in the light.</source>
        <translation>Zeigt das Modell als rotes Wachs, weich im Schatten und glänzend im Licht.</translation>
    </message>
    <message>
        <source>&amp;Porcelain</source>
        <translation>&amp;Porzellan</translation>
    </message>
    <message>
        <source>Shows the model as white, glazed porcelain.</source>
        <translation>Zeigt das Modell als weißes, glasiertes Porzellan.</translation>
    </message>
    <message>
        <source>P&amp;earl</source>
        <translation>P&amp;erle</translation>
    </message>
    <message>
        <source>Shows the model as pearl, which shimmers where it turns away.</source>
        <translation>Zeigt das Modell als Perle, die zum Rand hin schimmert.</translation>
    </message>
    <message>
        <source>&amp;Skin</source>
        <translation>&amp;Haut</translation>
    </message>
    <message>
        <source>Shows the model as skin, with light in its shadows.</source>
        <translation>Zeigt das Modell als Haut, mit Licht in den Schatten.</translation>
    </message>
    <message>
        <source>Painted C&amp;olours</source>
        <translation>Gemalte &amp;Farben</translation>
    </message>
    <message>
        <source>Shows the colours that were painted as they are, shaded.</source>
        <translation>Zeigt die gemalten Farben unverändert, schattiert.</translation>
    </message>
    <message>
        <source>As the &amp;Window</source>
        <translation>Wie das &amp;Fenster</translation>
    </message>
    <message>
        <source>Uses a background that matches the window, light or dark.</source>
        <translation>Hintergrund passend zum Fenster, hell oder dunkel.</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Hell</translation>
    </message>
    <message>
        <source>Uses a light grey background.</source>
        <translation>Hellgrauer Hintergrund.</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Dunkel</translation>
    </message>
    <message>
        <source>Uses a dark grey background.</source>
        <translation>Dunkelgrauer Hintergrund.</translation>
    </message>
    <message>
        <source>&amp;Sky</source>
        <translation>H&amp;immel</translation>
    </message>
    <message>
        <source>Uses a pale blue sky as background.</source>
        <translation>Blassblauer Himmel als Hintergrund.</translation>
    </message>
    <message>
        <source>W&amp;hite</source>
        <translation>&amp;Weiß</translation>
    </message>
    <message>
        <source>Uses a plain white background.</source>
        <translation>Rein weißer Hintergrund.</translation>
    </message>
    <message>
        <source>&amp;Black</source>
        <translation>&amp;Schwarz</translation>
    </message>
    <message>
        <source>Uses a plain black background.</source>
        <translation>Rein schwarzer Hintergrund.</translation>
    </message>
    <message>
        <source>Mat&amp;erial</source>
        <translation>Mat&amp;erial</translation>
    </message>
    <message>
        <source>Ba&amp;ckground</source>
        <translation>&amp;Hintergrund</translation>
    </message>
    <message>
        <source>Set Radius by &amp;Dragging</source>
        <translation>R&amp;adius durch Ziehen</translation>
    </message>
    <message>
        <source>Changes the radius as the pointer moves. Click or press Return to keep it; Esc or a right click cancels.</source>
        <translation>Ändert den Radius mit der Zeigerbewegung. Klick oder Eingabetaste übernimmt ihn; Esc oder Rechtsklick bricht ab.</translation>
    </message>
    <message>
        <source>Set Strength by Draggin&amp;g</source>
        <translation>S&amp;tärke durch Ziehen</translation>
    </message>
    <message>
        <source>Changes the strength as the pointer moves. Click or press Return to keep it; Esc or a right click cancels.</source>
        <translation>Ändert die Stärke mit der Zeigerbewegung. Klick oder Eingabetaste übernimmt sie; Esc oder Rechtsklick bricht ab.</translation>
    </message>
    <message>
        <source>S&amp;teady Stroke</source>
        <translation>R&amp;uhiger Strich</translation>
    </message>
    <message>
        <source>Drags the brush on a string behind the pointer, for smooth lines even with a trembling hand.</source>
        <translation>Zieht den Pinsel an einer Schnur hinter dem Zeiger her, für glatte Linien auch mit zitternder Hand.</translation>
    </message>
    <message>
        <source>Paint &amp;Colour</source>
        <translation>&amp;Malfarbe</translation>
    </message>
    <message>
        <source>Shows the panel with the paint colour.</source>
        <translation>Zeigt das Bedienfeld mit der Malfarbe.</translation>
    </message>
    <message>
        <source>Pic&amp;k Colour</source>
        <translation>Farbe auf&amp;nehmen</translation>
    </message>
    <message>
        <source>Picks the paint colour from the model with the next click.</source>
        <translation>Nimmt mit dem nächsten Klick die Malfarbe vom Modell auf.</translation>
    </message>
    <message>
        <source>S&amp;wap Colours</source>
        <translation>Farben tausc&amp;hen</translation>
    </message>
    <message>
        <source>Paints with the other colour, and keeps this one for the next swap.</source>
        <translation>Malt mit der anderen Farbe und behält diese für den nächsten Tausch.</translation>
    </message>
    <message>
        <source>&amp;Fill with Colour</source>
        <translation>Mit &amp;Farbe füllen</translation>
    </message>
    <message>
        <source>Fills the active part with the paint colour.</source>
        <translation>Füllt das aktive Teil mit der Malfarbe.</translation>
    </message>
    <message>
        <source>&amp;Preferences…</source>
        <translation>&amp;Einstellungen …</translation>
    </message>
    <message>
        <source>Sets colours, language, keys, pen and mouse.</source>
        <translation>Stellt Farben, Sprache, Tasten, Stift und Maus ein.</translation>
    </message>
    <message>
        <source>Add &amp;Ball</source>
        <translation>Kuge&amp;l hinzufügen</translation>
    </message>
    <message>
        <source>Export &amp;Drawing…</source>
        <translation>&amp;Zeichnung exportieren …</translation>
    </message>
    <message>
        <source>Writes a sheet with front, side and top view to scale: PDF, SVG or PNG.</source>
        <translation>Schreibt ein maßstäbliches Blatt mit Vorder-, Seiten- und Draufsicht: PDF, SVG oder PNG.</translation>
    </message>
    <message>
        <source>Re&amp;vert</source>
        <translation>Neu &amp;laden</translation>
    </message>
    <message>
        <source>Opens the model&apos;s file again, as it was last saved.</source>
        <translation>Öffnet die Datei des Modells neu, wie sie zuletzt gespeichert wurde.</translation>
    </message>
    <message>
        <source>&amp;Ball</source>
        <translation>&amp;Kugel</translation>
    </message>
    <message>
        <source>Begins with a ball of clay.</source>
        <translation>Beginnt mit einer Kugel aus Ton.</translation>
    </message>
    <message>
        <source>&amp;Cube</source>
        <translation>&amp;Würfel</translation>
    </message>
    <message>
        <source>Begins with a cube of clay.</source>
        <translation>Beginnt mit einem Würfel aus Ton.</translation>
    </message>
    <message>
        <source>&amp;Torus</source>
        <translation>&amp;Ring</translation>
    </message>
    <message>
        <source>Begins with a ring of clay.</source>
        <translation>Beginnt mit einem Ring aus Ton.</translation>
    </message>
    <message>
        <source>&amp;Slab</source>
        <translation>&amp;Platte</translation>
    </message>
    <message>
        <source>Begins with a thick square plate.</source>
        <translation>Beginnt mit einer dicken quadratischen Platte.</translation>
    </message>
    <message>
        <source>&amp;Vase</source>
        <translation>&amp;Vase</translation>
    </message>
    <message>
        <source>Begins with a vase.</source>
        <translation>Beginnt mit einer Vase.</translation>
    </message>
    <message>
        <source>&amp;Head</source>
        <translation>K&amp;opf</translation>
    </message>
    <message>
        <source>Begins with a head and neck.</source>
        <translation>Beginnt mit Kopf und Hals.</translation>
    </message>
    <message>
        <source>T&amp;ablet</source>
        <translation>&amp;Tafel</translation>
    </message>
    <message>
        <source>Begins with a thin plate for a relief.</source>
        <translation>Beginnt mit einer dünnen Tafel für ein Relief.</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Neu</translation>
    </message>
    <message>
        <source>Tur&amp;ntable</source>
        <translation>Drehs&amp;cheibe</translation>
    </message>
    <message>
        <source>Turns the model under your hand. Hold still to cut a groove all around.</source>
        <translation>Dreht das Modell unter Ihrer Hand. Halten Sie still, um ringsum eine Rille zu schneiden.</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>Saves the model to its file.</source>
        <translation>Speichert das Modell in seiner Datei.</translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation>Speichern &amp;unter …</translation>
    </message>
    <message>
        <source>Saves the model to another file and continues with that one.</source>
        <translation>Speichert das Modell in einer anderen Datei und arbeitet mit dieser weiter.</translation>
    </message>
    <message>
        <source>Reset to S&amp;tart</source>
        <translation>Auf &amp;Anfang zurücksetzen</translation>
    </message>
    <message>
        <source>Gives the model the shape and the colours that it was opened with. You can undo this.</source>
        <translation>Setzt Form und Farben des Modells auf den Stand beim Öffnen zurück. Das lässt sich rückgängig machen.</translation>
    </message>
    <message>
        <source>Save Nu&amp;mbered Copy</source>
        <translation>Nu&amp;mmerierte Kopie speichern</translation>
    </message>
    <message>
        <source>Writes the model beside its file, with the next free number in the name.</source>
        <translation>Speichert das Modell neben seiner Datei, mit der nächsten freien Nummer im Namen.</translation>
    </message>
    <message>
        <source>&amp;Browse Files</source>
        <translation>Dateien &amp;durchsuchen</translation>
    </message>
    <message>
        <source>Shows the panel with a folder of models as pictures.</source>
        <translation>Zeigt ein Bedienfeld mit den Modellen eines Ordners als Bildern.</translation>
    </message>
    <message>
        <source>Pulls the surface outwards. %1 pushes instead, Shift smooths.</source>
        <translation>Zieht die Oberfläche nach außen. %1 drückt stattdessen, Umschalt glättet.</translation>
    </message>
    <message>
        <source>Pushes the surface inwards. %1 pulls instead, Shift smooths.</source>
        <translation>Drückt die Oberfläche nach innen. %1 zieht stattdessen, Umschalt glättet.</translation>
    </message>
    <message>
        <source>The right button turns the view.</source>
        <translation>Die rechte Taste dreht die Ansicht.</translation>
    </message>
    <message>
        <source>&amp;User Guide</source>
        <translation>&amp;Anleitung</translation>
    </message>
    <message>
        <source>Opens the guide beside the window: first steps, lessons, and a page for everything.</source>
        <translation>Öffnet die Anleitung neben dem Fenster: erste Schritte, Lektionen und eine Seite zu jedem Thema.</translation>
    </message>
    <message>
        <source>&amp;Start Page</source>
        <translation>&amp;Startseite</translation>
    </message>
    <message>
        <source>Shows what to begin with: starters, recent files, and three short lessons.</source>
        <translation>Zeigt, womit Sie beginnen können: Ausgangsformen, zuletzt geöffnete Dateien und drei kurze Lektionen.</translation>
    </message>
    <message>
        <source>&amp;Choose…</source>
        <translation>&amp;Wählen …</translation>
    </message>
    <message>
        <source>Adds an image behind the model, on the side that you look from.</source>
        <translation>Stellt ein Bild hinter das Modell, für die Seite, von der Sie schauen.</translation>
    </message>
    <message>
        <source>&amp;Show Reference Images</source>
        <translation>Referenzen &amp;zeigen</translation>
    </message>
    <message>
        <source>Shows the image of a side while the view looks from there.</source>
        <translation>Zeigt das Bild einer Seite, solange Sie von dort schauen.</translation>
    </message>
    <message>
        <source>&amp;Remove Reference Image</source>
        <translation>Referenz &amp;entfernen</translation>
    </message>
    <message>
        <source>Removes the image of the side that you look from.</source>
        <translation>Entfernt das Bild der Seite, von der Sie schauen.</translation>
    </message>
    <message>
        <source>Refere&amp;nce Image</source>
        <translation>Refere&amp;nzbild</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>&amp;Öffnen</translation>
    </message>
    <message>
        <source>Opens the selected model of the Files panel, or enters the folder.</source>
        <translation>Öffnet das im Bedienfeld „Dateien“ markierte Modell oder wechselt in den Ordner.</translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation>&amp;Umbenennen</translation>
    </message>
    <message>
        <source>Renames the selected file of the Files panel; its ending stays.</source>
        <translation>Benennt die im Bedienfeld „Dateien“ markierte Datei um; ihre Endung bleibt.</translation>
    </message>
    <message>
        <source>&amp;Duplicate</source>
        <translation>&amp;Duplizieren</translation>
    </message>
    <message>
        <source>Makes a copy of the selected file of the Files panel beside it.</source>
        <translation>Legt neben der im Bedienfeld „Dateien“ markierten Datei eine Kopie an.</translation>
    </message>
    <message>
        <source>Move to &amp;Trash</source>
        <translation>In den &amp;Papierkorb</translation>
    </message>
    <message>
        <source>Moves the selected file of the Files panel to the trash.</source>
        <translation>Verschiebt die im Bedienfeld „Dateien“ markierte Datei in den Papierkorb.</translation>
    </message>
    <message>
        <source>&amp;Show in Folder</source>
        <translation>Im Ordner &amp;zeigen</translation>
    </message>
    <message>
        <source>Shows the selected file of the Files panel in the desktop&apos;s file manager.</source>
        <translation>Zeigt die im Bedienfeld „Dateien“ markierte Datei in der Dateiverwaltung.</translation>
    </message>
    <message>
        <source>&amp;Up</source>
        <translation>Nach &amp;oben</translation>
    </message>
    <message>
        <source>Goes up one folder in the Files panel.</source>
        <translation>Wechselt im Bedienfeld „Dateien“ in den übergeordneten Ordner.</translation>
    </message>
    <message>
        <source>&amp;Choose Folder…</source>
        <translation>Ordner &amp;wählen …</translation>
    </message>
    <message>
        <source>Asks for the folder that the Files panel shows.</source>
        <translation>Wählt den Ordner, den das Bedienfeld „Dateien“ zeigt.</translation>
    </message>
    <message>
        <source>Files &amp;Panel</source>
        <translation>&amp;Bedienfeld „Dateien“</translation>
    </message>
    <message>
        <source>Opens a model from a file.</source>
        <translation>Öffnet ein Modell aus einer Datei.</translation>
    </message>
    <message>
        <source>Writes the model to an STL, OBJ, PLY, OFF, GLB or 3MF file. Its own file stays as it is.</source>
        <translation>Schreibt das Modell als STL, OBJ, PLY, OFF, GLB oder 3MF. Seine eigene Datei bleibt unverändert.</translation>
    </message>
    <message>
        <source>Export for &amp;Print or Game…</source>
        <translation>Für Druc&amp;k oder Spiel exportieren …</translation>
    </message>
    <message>
        <source>Writes STL, 3MF or GLB with as many triangles as you like, and verifies the file.</source>
        <translation>Schreibt STL, 3MF oder GLB mit beliebig vielen Dreiecken und prüft die Datei.</translation>
    </message>
    <message>
        <source>P&amp;lace on Bed</source>
        <translation>Aufs Druckbett s&amp;tellen</translation>
    </message>
    <message>
        <source>Moves the model&apos;s lowest point to height 0, onto the printer&apos;s bed.</source>
        <translation>Setzt den tiefsten Punkt des Modells auf Höhe 0, auf das Druckbett.</translation>
    </message>
    <message>
        <source>Flatten &amp;Base…</source>
        <translation>&amp;Unterseite ebnen …</translation>
    </message>
    <message>
        <source>Cuts the bottom off level, so that the model stands flat.</source>
        <translation>Schneidet das Modell unten waagrecht ab, damit es eben steht.</translation>
    </message>
    <message>
        <source>&amp;Print Check</source>
        <translation>Druckp&amp;rüfung</translation>
    </message>
    <message>
        <source>Shows whether the model prints: walls, overhangs, base, and the printer&apos;s bed.</source>
        <translation>Zeigt, ob sich das Modell drucken lässt: Wände, Überhänge, Standfläche und Druckbett.</translation>
    </message>
    <message>
        <source>&amp;Enter VR</source>
        <translation>VR be&amp;treten</translation>
    </message>
    <message>
        <source>Sculpts in VR with a headset. Choose it again to leave VR.</source>
        <translation>Formt in VR mit der VR-Brille. Erneut wählen, um VR zu verlassen.</translation>
    </message>
    <message>
        <source>&amp;Follow the Head</source>
        <translation>Dem &amp;Kopf folgen</translation>
    </message>
    <message>
        <source>Shows in this window what the headset sees, for a class to watch.</source>
        <translation>Zeigt in diesem Fenster, was die VR-Brille sieht, damit eine Klasse zusehen kann.</translation>
    </message>
    <message>
        <source>&amp;Inflate</source>
        <translation>Auf&amp;blähen</translation>
    </message>
    <message>
        <source>Swells the surface in all directions. %1 shrinks it instead, Shift smooths.</source>
        <translation>Bläht die Oberfläche nach allen Seiten auf. %1 lässt sie schrumpfen, Umschalt glättet.</translation>
    </message>
    <message>
        <source>Adds a flat layer and fills hollows first. %1 digs instead, Shift smooths.</source>
        <translation>Trägt eine flache Schicht auf und füllt zuerst Vertiefungen. %1 gräbt stattdessen, Umschalt glättet.</translation>
    </message>
    <message>
        <source>Raises the surface to one height per stroke, however often you go over it. %1 sinks it instead, Shift smooths.</source>
        <translation>Hebt die Oberfläche je Strich auf eine Höhe, so oft Sie auch darüberfahren. %1 senkt sie stattdessen, Umschalt glättet.</translation>
    </message>
    <message>
        <source>Sc&amp;rape</source>
        <translation>S&amp;chaben</translation>
    </message>
    <message>
        <source>Removes what is above the average plane. %1 fills what is below instead, Shift smooths.</source>
        <translation>Trägt ab, was über der mittleren Ebene liegt. %1 füllt, was darunter liegt, Umschalt glättet.</translation>
    </message>
    <message>
        <source>Pi&amp;nch</source>
        <translation>&amp;Kneifen</translation>
    </message>
    <message>
        <source>Pulls the surface together towards the stroke. %1 spreads it instead, Shift smooths.</source>
        <translation>Zieht die Oberfläche zum Strich hin zusammen. %1 zieht sie auseinander, Umschalt glättet.</translation>
    </message>
    <message>
        <source>Cr&amp;ease</source>
        <translation>Ke&amp;rben</translation>
    </message>
    <message>
        <source>Cuts a sharp groove. %1 raises a sharp ridge instead, Shift smooths.</source>
        <translation>Schneidet eine scharfe Kerbe. %1 hebt stattdessen einen scharfen Grat, Umschalt glättet.</translation>
    </message>
    <message>
        <source>&amp;Grab</source>
        <translation>Gre&amp;ifen</translation>
    </message>
    <message>
        <source>Moves the surface under the brush along with the pointer. Shift smooths.</source>
        <translation>Bewegt die Oberfläche unter dem Pinsel mit dem Zeiger. Umschalt glättet.</translation>
    </message>
    <message>
        <source>Snake &amp;Hook</source>
        <translation>&amp;Tentakel</translation>
    </message>
    <message>
        <source>Pulls out a tentacle, and the brush follows its tip. Shift smooths.</source>
        <translation>Zieht einen Tentakel heraus; der Pinsel folgt seiner Spitze. Umschalt glättet.</translation>
    </message>
    <message>
        <source>&amp;Twist</source>
        <translation>&amp;Verdrehen</translation>
    </message>
    <message>
        <source>Twists the surface under the brush as you drag away from it. %1 twists it the other way, Shift smooths.</source>
        <translation>Verdreht die Oberfläche unter dem Pinsel, wenn Sie von ihm wegziehen. %1 verdreht andersherum, Umschalt glättet.</translation>
    </message>
    <message>
        <source>Hold %1 on the model to invert the tool, %2 to smooth.</source>
        <translation>Halten Sie auf dem Modell %1, um das Werkzeug umzukehren, %2, um zu glätten.</translation>
    </message>
    <message>
        <source>Tool&amp;s</source>
        <translation>&amp;Werkzeuge</translation>
    </message>
    <message>
        <source>C&amp;lay</source>
        <translation>&amp;Auftragen</translation>
    </message>
    <message>
        <source>La&amp;yer</source>
        <translation>&amp;Schichten</translation>
    </message>
    <message>
        <source>Protects the surface from other tools. %1 erases the mask instead, Shift smooths.</source>
        <translation>Schützt die Oberfläche vor anderen Werkzeugen. %1 wischt die Maske weg, Umschalt glättet.</translation>
    </message>
    <message>
        <source>&amp;Invert Mask</source>
        <translation>Maske &amp;umkehren</translation>
    </message>
    <message>
        <source>Swaps protected and unprotected areas.</source>
        <translation>Vertauscht geschützte und ungeschützte Bereiche.</translation>
    </message>
    <message>
        <source>&amp;Clear Mask</source>
        <translation>Maske &amp;löschen</translation>
    </message>
    <message>
        <source>Removes the mask from the active part.</source>
        <translation>Entfernt die Maske vom aktiven Teil.</translation>
    </message>
    <message>
        <source>&amp;Blur Mask</source>
        <translation>Maske &amp;weichzeichnen</translation>
    </message>
    <message>
        <source>Makes the mask&apos;s edge softer.</source>
        <translation>Macht den Rand der Maske weicher.</translation>
    </message>
    <message>
        <source>&amp;Sharpen Mask</source>
        <translation>Maske &amp;schärfen</translation>
    </message>
    <message>
        <source>Makes the mask&apos;s edge harder.</source>
        <translation>Macht den Rand der Maske härter.</translation>
    </message>
    <message>
        <source>&amp;Grow Mask</source>
        <translation>Maske ver&amp;größern</translation>
    </message>
    <message>
        <source>Widens the mask by one triangle.</source>
        <translation>Erweitert die Maske um ein Dreieck.</translation>
    </message>
    <message>
        <source>S&amp;hrink Mask</source>
        <translation>Maske ver&amp;kleinern</translation>
    </message>
    <message>
        <source>Narrows the mask by one triangle.</source>
        <translation>Verkleinert die Maske um ein Dreieck.</translation>
    </message>
    <message>
        <source>Mask C&amp;avities</source>
        <translation>&amp;Vertiefungen maskieren</translation>
    </message>
    <message>
        <source>Also protects hollows.</source>
        <translation>Schützt auch Vertiefungen.</translation>
    </message>
    <message>
        <source>Mask by Co&amp;lour</source>
        <translation>Nach &amp;Farbe maskieren</translation>
    </message>
    <message>
        <source>Also protects areas close to the paint colour.</source>
        <translation>Schützt auch Bereiche, die der Malfarbe nahekommen.</translation>
    </message>
    <message>
        <source>M&amp;ask</source>
        <translation>Mask&amp;e</translation>
    </message>
    <message>
        <source>Sta&amp;mp</source>
        <translation>Stem&amp;pel</translation>
    </message>
    <message>
        <source>Presses a ball or a model of yours into the surface. %1 raises it instead, Shift smooths.</source>
        <translation>Drückt eine Kugel oder ein eigenes Modell in die Oberfläche. %1 hebt die Form heraus, Umschalt glättet.</translation>
    </message>
    <message>
        <source>Repeats strokes around the vertical axis. Set the count in the Symmetry panel.</source>
        <translation>Wiederholt Striche rings um die senkrechte Achse. Die Anzahl stellen Sie im Bedienfeld Symmetrie ein.</translation>
    </message>
    <message>
        <source>Mas&amp;k</source>
        <translation>&amp;Maske</translation>
    </message>
    <message>
        <source>Adds a ball of the brush&apos;s radius, or the stamp&apos;s model, where you click next.</source>
        <translation>Setzt mit dem nächsten Klick eine Kugel mit dem Radius des Pinsels oder das Modell des Stempels.</translation>
    </message>
    <message>
        <source>Radial Symm&amp;etry</source>
        <translation>Ra&amp;diale Symmetrie</translation>
    </message>
    <message>
        <source>Mo&amp;del</source>
        <translation>Mod&amp;ell</translation>
    </message>
    <message>
        <source>&amp;Lessons</source>
        <translation>&amp;Lektionen</translation>
    </message>
    <message>
        <source>Shows how something is made, stroke by stroke, and lets you try it.</source>
        <translation>Zeigt Strich für Strich, wie etwas gemacht wird, und lässt Sie es selbst versuchen.</translation>
    </message>
    <message>
        <source>&amp;Classroom…</source>
        <translation>&amp;Klassenraum …</translation>
    </message>
    <message>
        <source>Makes a class file: what pupils may do, how long their turns are, and the PIN that ends the class.</source>
        <translation>Erstellt eine Klassendatei: was Kinder tun dürfen, wie lange jedes an der Reihe ist und welche PIN die Klasse beendet.</translation>
    </message>
    <message>
        <source>&amp;Class Report…</source>
        <translation>Klassenbe&amp;richt …</translation>
    </message>
    <message>
        <source>Writes a report on the models in a folder: picture, size, print-ready or why not, strokes and time. HTML or PDF.</source>
        <translation>Schreibt einen Bericht über die Modelle eines Ordners: Bild, Größe, druckfertig oder warum nicht, Striche und Zeit. HTML oder PDF.</translation>
    </message>
    <message>
        <source>&amp;Use Model as Brush</source>
        <translation>Modell als &amp;Pinsel verwenden</translation>
    </message>
    <message>
        <source>Uses this model, as it is now, as the stamp.</source>
        <translation>Verwendet dieses Modell, wie es jetzt ist, als Stempel.</translation>
    </message>
    <message>
        <source>Caption in &amp;VR</source>
        <translation>Be&amp;schriftung in VR</translation>
    </message>
    <message>
        <source>Shows tool, radius and the time left in large letters while somebody is in VR.</source>
        <translation>Zeigt Werkzeug, Radius und übrige Zeit in großer Schrift, solange jemand in VR ist.</translation>
    </message>
    <message>
        <source>&amp;Point</source>
        <translation>&amp;Zeigen</translation>
    </message>
    <message>
        <source>Shows the person in VR a light where the pointer is on the model. Hold the key to point only for that time.</source>
        <translation>Zeigt der Person in VR ein Licht, wo der Zeiger auf dem Modell ist. Halten Sie die Taste, um nur solange zu zeigen.</translation>
    </message>
    <message>
        <source>&amp;Take Over</source>
        <translation>Über&amp;nehmen</translation>
    </message>
    <message>
        <source>Lets only this window sculpt until you give it back; the person in VR watches.</source>
        <translation>Lässt nur dieses Fenster formen, bis Sie zurückgeben; die Person in VR sieht zu.</translation>
    </message>
    <message>
        <source>Rec&amp;ord Lesson…</source>
        <translation>Lektion auf&amp;zeichnen …</translation>
    </message>
    <message>
        <source>Makes a lesson from what you sculpt, step by step, or changes an existing one.</source>
        <translation>Macht aus dem, was Sie formen, Schritt für Schritt eine Lektion oder ändert eine vorhandene.</translation>
    </message>
    <message>
        <source>Edit &amp;Last Stroke…</source>
        <translation>&amp;Letzten Strich ändern …</translation>
    </message>
    <message>
        <source>Changes tool, radius or strength of the last stroke.</source>
        <translation>Ändert Werkzeug, Radius oder Stärke des letzten Strichs.</translation>
    </message>
    <message>
        <source>Export Time-&amp;Lapse…</source>
        <translation>Zei&amp;traffer exportieren …</translation>
    </message>
    <message>
        <source>Draws the model after each of its steps, as numbered PNG pictures for a film.</source>
        <translation>Zeichnet das Modell nach jedem seiner Schritte, als nummerierte PNG-Bilder für einen Film.</translation>
    </message>
    <message>
        <source>In&amp;vert</source>
        <translation>Um&amp;gekehrt</translation>
    </message>
    <message>
        <source>Inverts the tools without holding %1: Pull pushes, Clay digs.</source>
        <translation>Kehrt die Werkzeuge um, ohne dass Sie %1 halten: Ziehen drückt, Auftragen gräbt.</translation>
    </message>
    <message>
        <source>Shows a cross that the arrow keys move: on the model Space or Return uses the tool, beside it the view turns.</source>
        <translation>Zeigt ein Kreuz, das die Pfeiltasten bewegen: Auf dem Modell wendet Leertaste oder Eingabetaste das Werkzeug an, daneben dreht sich die Ansicht.</translation>
    </message>
    <message>
        <source>Turn &amp;Left</source>
        <translation>Nach &amp;links drehen</translation>
    </message>
    <message>
        <source>Turns the model&apos;s near side to the left by 15 degrees.</source>
        <translation>Dreht die Vorderseite des Modells um 15 Grad nach links.</translation>
    </message>
    <message>
        <source>Turn &amp;Right</source>
        <translation>Nach &amp;rechts drehen</translation>
    </message>
    <message>
        <source>Turns the model&apos;s near side to the right by 15 degrees.</source>
        <translation>Dreht die Vorderseite des Modells um 15 Grad nach rechts.</translation>
    </message>
    <message>
        <source>Turn &amp;Up</source>
        <translation>Nach &amp;oben drehen</translation>
    </message>
    <message>
        <source>Turns the model&apos;s near side upwards by 15 degrees.</source>
        <translation>Dreht die Vorderseite des Modells um 15 Grad nach oben.</translation>
    </message>
    <message>
        <source>Turn &amp;Down</source>
        <translation>Nach &amp;unten drehen</translation>
    </message>
    <message>
        <source>Turns the model&apos;s near side downwards by 15 degrees.</source>
        <translation>Dreht die Vorderseite des Modells um 15 Grad nach unten.</translation>
    </message>
    <message>
        <source>&amp;Nearer</source>
        <translation>&amp;Näher</translation>
    </message>
    <message>
        <source>Shows the model larger.</source>
        <translation>Zeigt das Modell größer.</translation>
    </message>
    <message>
        <source>&amp;Farther</source>
        <translation>&amp;Weiter weg</translation>
    </message>
    <message>
        <source>Shows the model smaller.</source>
        <translation>Zeigt das Modell kleiner.</translation>
    </message>
    <message>
        <source>&amp;One Hand</source>
        <translation>Ein&amp;händig</translation>
    </message>
    <message>
        <source>Uses one controller, with the panels in front of you, from the next time you enter VR.</source>
        <translation>Verwendet ab dem nächsten Betreten von VR nur einen Controller; die Tafeln stehen vor Ihnen.</translation>
    </message>
    <message>
        <source>Sculpts with the left hand, from the next time you enter VR.</source>
        <translation>Formt ab dem nächsten Betreten von VR mit der linken Hand.</translation>
    </message>
    <message>
        <source>T&amp;urn and Zoom</source>
        <translation>Drehen und &amp;Zoomen</translation>
    </message>
    <message>
        <source>Scul&amp;pt by Keys</source>
        <translation>Mit Tasten &amp;formen</translation>
    </message>
    <message>
        <source>Left-&amp;Handed</source>
        <translation>&amp;Linkshändig</translation>
    </message>
    <message>
        <source>Mask Whole &amp;Pieces</source>
        <translation>Ganze S&amp;tücke maskieren</translation>
    </message>
    <message>
        <source>Extends the mask to the whole of each connected piece that it touches.</source>
        <translation>Dehnt die Maske auf jedes zusammenhängende Stück aus, das sie berührt.</translation>
    </message>
    <message>
        <source>Adds a copy of the active part at the same place. The copy becomes active.</source>
        <translation>Fügt eine Kopie des aktiven Teils an derselben Stelle hinzu. Die Kopie wird aktiv.</translation>
    </message>
    <message>
        <source>Selec&amp;t a Part</source>
        <translation>Teil aus&amp;wählen</translation>
    </message>
    <message>
        <source>Makes the part active that you click next. Alt and a click do the same, where the desktop leaves Alt to the program.</source>
        <translation>Aktiviert das Teil, das Sie als Nächstes anklicken. Alt und ein Klick tun dasselbe, wo der Desktop dem Programm Alt lässt.</translation>
    </message>
    <message>
        <source>&amp;Separate</source>
        <translation>&amp;Trennen</translation>
    </message>
    <message>
        <source>Makes each connected piece of the active part a part of its own.</source>
        <translation>Macht jedes zusammenhängende Stück des aktiven Teils zu einem eigenen Teil.</translation>
    </message>
    <message>
        <source>D&amp;elete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>Deletes the active part.</source>
        <translation>Löscht das aktive Teil.</translation>
    </message>
    <message>
        <source>&amp;Join</source>
        <translation>&amp;Vereinigen</translation>
    </message>
    <message>
        <source>Joins the active part with the other selected parts into one solid.</source>
        <translation>Vereinigt das aktive Teil mit den anderen ausgewählten Teilen zu einem Körper.</translation>
    </message>
    <message>
        <source>S&amp;ubtract</source>
        <translation>&amp;Abziehen</translation>
    </message>
    <message>
        <source>Takes the other selected parts away from the active part.</source>
        <translation>Nimmt die anderen ausgewählten Teile vom aktiven Teil weg.</translation>
    </message>
    <message>
        <source>&amp;Intersect</source>
        <translation>S&amp;chnittmenge</translation>
    </message>
    <message>
        <source>Keeps what the active part has in common with the other selected parts.</source>
        <translation>Behält, was das aktive Teil mit den anderen ausgewählten Teilen gemeinsam hat.</translation>
    </message>
    <message>
        <source>Is&amp;olate</source>
        <translation>&amp;Isolieren</translation>
    </message>
    <message>
        <source>Shows only the active part. Again: shows the others as before.</source>
        <translation>Zeigt nur das aktive Teil. Noch einmal: zeigt die anderen wie zuvor.</translation>
    </message>
    <message>
        <source>&amp;Hide or Show</source>
        <translation>Au&amp;s- oder einblenden</translation>
    </message>
    <message>
        <source>Hides the active part, or shows it again.</source>
        <translation>Blendet das aktive Teil aus oder wieder ein.</translation>
    </message>
    <message>
        <source>Show &amp;All</source>
        <translation>Alle &amp;einblenden</translation>
    </message>
    <message>
        <source>Shows everything that is hidden: parts and areas.</source>
        <translation>Blendet alles ein, was ausgeblendet ist: Teile und Bereiche.</translation>
    </message>
    <message>
        <source>&amp;Lock or Unlock</source>
        <translation>S&amp;perren oder entsperren</translation>
    </message>
    <message>
        <source>Protects the active part from all changes, or unlocks it again.</source>
        <translation>Schützt das aktive Teil vor allen Änderungen oder entsperrt es wieder.</translation>
    </message>
    <message>
        <source>Changes the name of the active part.</source>
        <translation>Ändert den Namen des aktiven Teils.</translation>
    </message>
    <message>
        <source>&amp;Colour in the List…</source>
        <translation>&amp;Farbe in der Liste …</translation>
    </message>
    <message>
        <source>Marks the active part with a colour in the list.</source>
        <translation>Kennzeichnet das aktive Teil in der Liste mit einer Farbe.</translation>
    </message>
    <message>
        <source>Move U&amp;p</source>
        <translation>Nach &amp;oben</translation>
    </message>
    <message>
        <source>Moves the active part up in the list.</source>
        <translation>Schiebt das aktive Teil in der Liste nach oben.</translation>
    </message>
    <message>
        <source>Move Do&amp;wn</source>
        <translation>&amp;Nach unten</translation>
    </message>
    <message>
        <source>Moves the active part down in the list.</source>
        <translation>Schiebt das aktive Teil in der Liste nach unten.</translation>
    </message>
    <message>
        <source>Pa&amp;rts</source>
        <translation>Tei&amp;le</translation>
    </message>
    <message>
        <source>Hide &amp;Masked</source>
        <translation>Maskiertes aus&amp;blenden</translation>
    </message>
    <message>
        <source>Hides what is masked. Hidden clay is neither seen nor changed.</source>
        <translation>Blendet aus, was maskiert ist. Ausgeblendeter Ton wird weder gezeigt noch geändert.</translation>
    </message>
    <message>
        <source>Hide &amp;Unmasked</source>
        <translation>U&amp;nmaskiertes ausblenden</translation>
    </message>
    <message>
        <source>Hides what is not masked.</source>
        <translation>Blendet aus, was nicht maskiert ist.</translation>
    </message>
    <message>
        <source>Sho&amp;w Hidden</source>
        <translation>Ausgeblendetes &amp;zeigen</translation>
    </message>
    <message>
        <source>Shows all clay that was hidden by its mask.</source>
        <translation>Zeigt allen Ton, der nach seiner Maske ausgeblendet wurde.</translation>
    </message>
    <message>
        <source>Adds another model from a file to this one, or subtracts it.</source>
        <translation>Fügt diesem Modell ein weiteres aus einer Datei hinzu oder zieht es ab.</translation>
    </message>
    <message>
        <source>Insert Primiti&amp;ve…</source>
        <translation>Gru&amp;ndkörper einfügen …</translation>
    </message>
    <message>
        <source>Adds a box, ball, cylinder or other solid with given measures, or subtracts it.</source>
        <translation>Fügt einen Quader, eine Kugel, einen Zylinder oder anderen Körper mit gegebenen Maßen hinzu oder zieht ihn ab.</translation>
    </message>
    <message>
        <source>&amp;Move, Rotate, Scale</source>
        <translation>&amp;Verschieben, drehen, skalieren</translation>
    </message>
    <message>
        <source>Shows handles and numbers to move, rotate and scale the active part, or the part of it that is not masked.</source>
        <translation>Zeigt Griffe und Zahlen, um das aktive Teil, oder was davon nicht maskiert ist, zu verschieben, zu drehen und zu skalieren.</translation>
    </message>
    <message>
        <source>&amp;Mask Area</source>
        <translation>Bereich &amp;maskieren</translation>
    </message>
    <message>
        <source>Protects what you draw around: with a lasso, box, line or polygon.</source>
        <translation>Schützt, was Sie umfahren: mit Lasso, Rechteck, Linie oder Vieleck.</translation>
    </message>
    <message>
        <source>&amp;Unmask Area</source>
        <translation>Maske im Bereich &amp;entfernen</translation>
    </message>
    <message>
        <source>Removes the mask in an area that you draw.</source>
        <translation>Entfernt die Maske in einem Bereich, den Sie zeichnen.</translation>
    </message>
    <message>
        <source>&amp;Hide Area</source>
        <translation>Bereich &amp;ausblenden</translation>
    </message>
    <message>
        <source>Hides an area that you draw. Hidden clay is neither seen nor changed.</source>
        <translation>Blendet einen Bereich aus, den Sie zeichnen. Ausgeblendeter Ton wird weder gezeigt noch geändert.</translation>
    </message>
    <message>
        <source>&amp;Trim Away</source>
        <translation>&amp;Wegschneiden</translation>
    </message>
    <message>
        <source>Cuts away what you draw around, through the whole depth or only in front.</source>
        <translation>Schneidet weg, was Sie umfahren, durch die ganze Tiefe oder nur vorn.</translation>
    </message>
    <message>
        <source>&amp;Split Off</source>
        <translation>A&amp;btrennen</translation>
    </message>
    <message>
        <source>Makes what you draw around a part of its own.</source>
        <translation>Macht aus dem, was Sie umfahren, ein eigenes Teil.</translation>
    </message>
    <message>
        <source>Cut by &amp;Plane</source>
        <translation>An Ebene s&amp;chneiden</translation>
    </message>
    <message>
        <source>Cuts along a plane that you place with handles: removes one side, or makes two parts.</source>
        <translation>Schneidet entlang einer Ebene, die Sie mit Griffen legen: entfernt eine Seite oder macht zwei Teile daraus.</translation>
    </message>
    <message>
        <source>&amp;Area in the View</source>
        <translation>&amp;Bereich in der Ansicht</translation>
    </message>
    <message>
        <source>Puts a box, ball, cylinder or other solid on the model or the ground, by a press and a drag.</source>
        <translation>Stellt durch Drücken und Ziehen einen Quader, eine Kugel, einen Zylinder oder anderen Körper auf das Modell oder den Boden.</translation>
    </message>
    <message>
        <source>Makes a tube along a curve that you draw over the view; each of its points gets a radius.</source>
        <translation>Macht ein Rohr entlang einer Kurve, die Sie über die Ansicht zeichnen; jeder ihrer Punkte erhält einen Radius.</translation>
    </message>
    <message>
        <source>&amp;Draw a Tube</source>
        <translation>R&amp;ohr zeichnen</translation>
    </message>
    <message>
        <source>Plac&amp;e a Primitive</source>
        <translation>Grund&amp;körper aufstellen</translation>
    </message>
</context>
<context>
    <name>ui::AnswerScale</name>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
</context>
<context>
    <name>ui::BrushDrag</name>
    <message>
        <source>%1: %2 mm</source>
        <translation>%1: %2 mm</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>ui::BrushFiles</name>
    <message>
        <source>%1 is too flat for a brush shape.</source>
        <translation>%1 ist zu flach für eine Pinselform.</translation>
    </message>
    <message>
        <source>%1 is too small for a brush shape.</source>
        <translation>%1 ist zu klein für eine Pinselform.</translation>
    </message>
    <message>
        <source>%1 has too many triangles for a brush shape: at most %2 are allowed. Export it with fewer triangles first.</source>
        <translation>%1 hat zu viele Dreiecke für eine Pinselform: Höchstens %2 sind erlaubt. Exportieren Sie es zuerst mit weniger Dreiecken.</translation>
    </message>
    <message>
        <source>%1: there is no such file.</source>
        <translation>%1: Diese Datei gibt es nicht.</translation>
    </message>
    <message>
        <source>%1 is not an image that can be read.</source>
        <translation>%1 ist kein lesbares Bild.</translation>
    </message>
    <message>
        <source>%1 has %2 × %3 pixels: an alpha may have %4 on a side at most.</source>
        <translation>%1 hat %2 × %3 Pixel: Ein Alpha darf höchstens %4 je Seite haben.</translation>
    </message>
    <message>
        <source>%1: this image is damaged.</source>
        <translation>%1: Dieses Bild ist beschädigt.</translation>
    </message>
    <message>
        <source>%1 is all black: the brush would do nothing.</source>
        <translation>%1 ist ganz schwarz: Der Pinsel würde nichts bewirken.</translation>
    </message>
    <message>
        <source>%1: there is not enough memory for this model.</source>
        <translation>%1: Für dieses Modell reicht der Speicher nicht.</translation>
    </message>
</context>
<context>
    <name>ui::BrushPalette</name>
    <message>
        <source>Palette</source>
        <translation>Palette</translation>
    </message>
    <message>
        <source>Brush presets</source>
        <translation>Pinselvorlagen</translation>
    </message>
</context>
<context>
    <name>ui::BrushPanels</name>
    <message>
        <source>Brush</source>
        <translation>Pinsel</translation>
    </message>
    <message>
        <source>Reach</source>
        <translation>Reichweite</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>Along the surface</source>
        <translation>Entlang der Oberfläche</translation>
    </message>
    <message>
        <source>Topology</source>
        <translation>Netz</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>Kanten</translation>
    </message>
    <message>
        <source>Refine</source>
        <translation>Verfeinern</translation>
    </message>
    <message>
        <source>Adaptive</source>
        <translation>Adaptiv</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Belassen</translation>
    </message>
    <message>
        <source>Uniform</source>
        <translation>Gleichmäßig</translation>
    </message>
    <message>
        <source>Fuse touching surfaces</source>
        <translation>Flächen bei Berührung verschmelzen</translation>
    </message>
    <message>
        <source>Symmetry</source>
        <translation>Symmetrie</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Spiegelung</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Left and right (x = 0)</source>
        <translation>Links und rechts (x = 0)</translation>
    </message>
    <message>
        <source>Top and bottom (y = 0)</source>
        <translation>Oben und unten (y = 0)</translation>
    </message>
    <message>
        <source>Front and back (z = 0)</source>
        <translation>Vorn und hinten (z = 0)</translation>
    </message>
    <message>
        <source>Length of the string between pointer and brush. A longer one makes smoother lines.</source>
        <translation>Länge der Schnur zwischen Zeiger und Pinsel. Eine längere macht Linien glatter.</translation>
    </message>
    <message>
        <source>Airbrush</source>
        <translation>Airbrush</translation>
    </message>
    <message>
        <source>The tool continues for as long as you hold it in one place.</source>
        <translation>Das Werkzeug wirkt weiter, solange Sie es an einer Stelle halten.</translation>
    </message>
    <message>
        <source>Drag out size and direction</source>
        <translation>Größe und Richtung aufziehen</translation>
    </message>
    <message>
        <source>Press where the alpha or the stamp should go, and drag: the distance sets its radius, and it points up where you drag. A click makes it as large as the brush.</source>
        <translation>Drücken Sie dort, wo Alpha oder Stempel hinsoll, und ziehen Sie: Die Entfernung bestimmt den Radius, die Richtung, wo oben ist. Ein Klick nimmt die Größe des Pinsels.</translation>
    </message>
    <message>
        <source>Steady stroke</source>
        <translation>Ruhiger Strich</translation>
    </message>
    <message>
        <source>Length of the string</source>
        <translation>Länge der Schnur</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Sectors of the radial symmetry</source>
        <translation>Sektoren der radialen Symmetrie</translation>
    </message>
    <message>
        <source>Repeats your strokes in this number of sectors around the vertical axis (y), mirrored in each if Mirror is on.</source>
        <translation>Wiederholt Ihre Striche in so vielen Sektoren um die senkrechte Achse (y), in jedem gespiegelt, wenn eine Spiegelung an ist.</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Aus</translation>
    </message>
    <message>
        <source>With this count the sectors look alike; with 2 and 4 they are exactly alike.</source>
        <translation>Bei dieser Anzahl sehen die Sektoren gleich aus; bei 2 und 4 sind sie genau gleich.</translation>
    </message>
    <message>
        <source>Radial</source>
        <translation>Radial</translation>
    </message>
    <message>
        <source>Alpha</source>
        <translation>Alpha</translation>
    </message>
    <message>
        <source>Follows the stroke</source>
        <translation>Folgt dem Strich</translation>
    </message>
    <message>
        <source>Stamp</source>
        <translation>Stempel</translation>
    </message>
    <message>
        <source>Same radius for all tools</source>
        <translation>Ein Radius für alle Werkzeuge</translation>
    </message>
    <message>
        <source>Keeps the radius when you change the tool. When off, each tool has its own radius, just as it has its own strength.</source>
        <translation>Behält den Radius, wenn Sie das Werkzeug wechseln. Sonst hat jedes Werkzeug seinen eigenen Radius, so wie seine eigene Stärke.</translation>
    </message>
</context>
<context>
    <name>ui::BrushShapes</name>
    <message>
        <source>The brush is without its alpha: %1</source>
        <comment>a sentence that says why</comment>
        <translation>Der Pinsel hat kein Alpha mehr: %1</translation>
    </message>
    <message>
        <source>Stamp has a ball again: %1</source>
        <comment>a sentence that says why</comment>
        <translation>Der Stempel ist wieder eine Kugel: %1</translation>
    </message>
</context>
<context>
    <name>ui::ClassBar</name>
    <message>
        <source>Class</source>
        <translation>Klasse</translation>
    </message>
    <message>
        <source>Undoes Next Pupil: reopens the pupil&apos;s work and continues the turn. Possible until somebody sculpts.</source>
        <translation>Macht „Nächstes Kind“ rückgängig: öffnet die Arbeit wieder und setzt den Durchgang fort. Möglich, bis jemand formt.</translation>
    </message>
    <message>
        <source>&amp;Next Pupil</source>
        <translation>&amp;Nächstes Kind</translation>
    </message>
    <message>
        <source>Saves the work in the class folder, and begins the next turn with fresh clay.</source>
        <translation>Speichert die Arbeit im Ordner der Klasse; das nächste Kind beginnt mit frischem Ton.</translation>
    </message>
    <message>
        <source>&amp;Leave…</source>
        <translation>&amp;Verlassen …</translation>
    </message>
    <message>
        <source>Asks for the teacher&apos;s PIN, saves the work, and ends the class.</source>
        <translation>Fragt nach der PIN der Lehrkraft, speichert die Arbeit und beendet die Klasse.</translation>
    </message>
    <message>
        <source>Time is up</source>
        <translation>Die Zeit ist um</translation>
    </message>
    <message numerus="yes">
        <source>%n minutes left</source>
        <translation>
            <numerusform>noch %n Minute</numerusform>
            <numerusform>noch %n Minuten</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n seconds left</source>
        <translation>
            <numerusform>noch %n Sekunde</numerusform>
            <numerusform>noch %n Sekunden</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Resume %1&apos;s Turn</source>
        <translation>&amp;Weiter mit %1</translation>
    </message>
    <message numerus="yes">
        <source>%n models not yet in the class folder</source>
        <translation>
            <numerusform>%n Modell noch nicht im Ordner der Klasse</numerusform>
            <numerusform>%n Modelle noch nicht im Ordner der Klasse</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Clock</source>
        <translation>&amp;Uhr</translation>
    </message>
    <message>
        <source>Shows a large clock in a window of its own, for the projector.</source>
        <translation>Zeigt eine große Uhr in einem eigenen Fenster, für den Beamer.</translation>
    </message>
</context>
<context>
    <name>ui::ClassClock</name>
    <message>
        <source>Next: %1</source>
        <translation>Danach: %1</translation>
    </message>
</context>
<context>
    <name>ui::ClassReport</name>
    <message>
        <source>Print-ready</source>
        <translation>Druckfertig</translation>
    </message>
    <message>
        <source>Not print-ready</source>
        <translation>Nicht druckfertig</translation>
    </message>
    <message>
        <source>Cannot be read</source>
        <translation>Nicht lesbar</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>Size, mm</source>
        <translation>Größe, mm</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Strokes</source>
        <translation>Striche</translation>
    </message>
    <message>
        <source>Class report: %1</source>
        <translation>Klassenbericht: %1</translation>
    </message>
    <message>
        <source>%1 · models: %2 · print-ready: %3 · not print-ready: %4 · cannot be read: %5</source>
        <translation>%1 · Modelle: %2 · druckfertig: %3 · nicht druckfertig: %4 · nicht lesbar: %5</translation>
    </message>
    <message>
        <source>Page %1 of %2</source>
        <translation>Seite %1 von %2</translation>
    </message>
    <message>
        <source>Question</source>
        <translation>Frage</translation>
    </message>
    <message>
        <source>Answers</source>
        <translation>Antworten</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>What the pupils answered</source>
        <translation>Was die Kinder geantwortet haben</translation>
    </message>
</context>
<context>
    <name>ui::ClassroomDialog</name>
    <message>
        <source>Classroom</source>
        <translation>Klassenraum</translation>
    </message>
    <message>
        <source>Pupils take turns: each begins with fresh clay, and Next Pupil saves the work in the class folder. Pupils cannot reach other files; leaving asks for your PIN.</source>
        <translation>Jedes Kind beginnt mit frischem Ton, und „Nächstes Kind“ speichert die Arbeit im Ordner der Klasse. Andere Dateien sind nicht erreichbar; das Verlassen braucht Ihre PIN.</translation>
    </message>
    <message>
        <source>Starting shapes</source>
        <translation>Ausgangsformen</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>&amp;Save…</source>
        <translation>&amp;Speichern …</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation>Speichern &amp;unter …</translation>
    </message>
    <message>
        <source>Saves the class to another file.</source>
        <translation>Speichert die Klasse in einer anderen Datei.</translation>
    </message>
    <message>
        <source>Shown in the top bar, such as the name of the class.</source>
        <translation>Steht in der obersten Leiste, etwa der Name der Klasse.</translation>
    </message>
    <message>
        <source>&amp;Title:</source>
        <translation>&amp;Titel:</translation>
    </message>
    <message>
        <source>Each turn gets a folder there, with model, picture and recording.</source>
        <translation>Dort bekommt jede Arbeit einen Ordner mit Modell, Bild und Aufzeichnung.</translation>
    </message>
    <message>
        <source>C&amp;hoose…</source>
        <translation>&amp;Wählen …</translation>
    </message>
    <message>
        <source>&amp;Folder for pupils&apos; work:</source>
        <translation>&amp;Ordner für die Arbeiten:</translation>
    </message>
    <message>
        <source> min</source>
        <translation> min</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>unbegrenzt</translation>
    </message>
    <message>
        <source>The length of a turn. Nothing is lost when it is over.</source>
        <translation>Dauer je Kind. Ist die Zeit um, geht nichts verloren.</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>How long before the end a notice appears, also in the headset.</source>
        <translation>So lange vor dem Ende erscheint ein Hinweis, auch in der VR-Brille.</translation>
    </message>
    <message>
        <source>Full s&amp;creen</source>
        <translation>Voll&amp;bild</translation>
    </message>
    <message>
        <source>Hides everything else on the screen.</source>
        <translation>Verdeckt alles andere auf dem Bildschirm.</translation>
    </message>
    <message>
        <source>The language of the window in this class.</source>
        <translation>Die Sprache des Fensters in dieser Klasse.</translation>
    </message>
    <message>
        <source>T&amp;urn:</source>
        <translation>&amp;Dauer je Kind:</translation>
    </message>
    <message>
        <source>&amp;Warning before the end:</source>
        <translation>W&amp;arnung vor dem Ende:</translation>
    </message>
    <message>
        <source>&amp;Language:</source>
        <translation>Sp&amp;rache:</translation>
    </message>
    <message>
        <source>Needed to leave the class. Stored as a hash, not as plain text.</source>
        <translation>Zum Verlassen der Klasse nötig. Gespeichert wird nur ein Hash, nicht die PIN selbst.</translation>
    </message>
    <message>
        <source>P&amp;IN:</source>
        <translation>&amp;PIN:</translation>
    </message>
    <message>
        <source>&amp;Repeat PIN:</source>
        <translation>PIN w&amp;iederholen:</translation>
    </message>
    <message>
        <source>The class has no title yet.</source>
        <translation>Die Klasse hat noch keinen Titel.</translation>
    </message>
    <message>
        <source>This folder does not exist.</source>
        <translation>Diesen Ordner gibt es nicht.</translation>
    </message>
    <message>
        <source>Choose at least one starting shape.</source>
        <translation>Wählen Sie mindestens eine Ausgangsform.</translation>
    </message>
    <message>
        <source>Choose at least one tool.</source>
        <translation>Wählen Sie mindestens ein Werkzeug.</translation>
    </message>
    <message numerus="yes">
        <source>The PIN needs at least %n characters.</source>
        <translation>
            <numerusform>Die PIN braucht mindestens %n Zeichen.</numerusform>
            <numerusform>Die PIN braucht mindestens %n Zeichen.</numerusform>
        </translation>
    </message>
    <message>
        <source>The two PINs are not the same.</source>
        <translation>Die beiden PINs stimmen nicht überein.</translation>
    </message>
    <message>
        <source>Six &amp;questions after each turn</source>
        <translation>Sechs &amp;Fragen nach jedem Kind</translation>
    </message>
    <message>
        <source>Next Pupil shows a form about the program first. Its answers are saved with the work and summed up in the class report; each may be left out.</source>
        <translation>„Nächstes Kind“ zeigt zuerst einen Fragebogen über das Programm. Die Antworten werden mit der Arbeit gespeichert und im Klassenbericht zusammengefasst; jede ist freiwillig.</translation>
    </message>
    <message>
        <source>&amp;Open a Class…</source>
        <translation>Klasse &amp;öffnen …</translation>
    </message>
    <message>
        <source>Opens a class file to change it.</source>
        <translation>Öffnet eine Klassendatei, um sie zu ändern.</translation>
    </message>
    <message>
        <source>unchanged</source>
        <translation>unverändert</translation>
    </message>
    <message>
        <source>&amp;Make This Folder</source>
        <translation>Diesen Ordner an&amp;legen</translation>
    </message>
    <message>
        <source>This folder cannot be created.</source>
        <translation>Dieser Ordner kann nicht angelegt werden.</translation>
    </message>
    <message>
        <source>Allow other &amp;names</source>
        <translation>Andere &amp;Namen erlauben</translation>
    </message>
    <message>
        <source>For guests, and for names that are not on the list.</source>
        <translation>Für Gäste und für Namen, die nicht in der Liste stehen.</translation>
    </message>
    <message>
        <source>&amp;Pupils&apos; names:</source>
        <translation>Na&amp;men der Kinder:</translation>
    </message>
    <message>
        <source>L&amp;esson:</source>
        <translation>L&amp;ektion:</translation>
    </message>
</context>
<context>
    <name>ui::ColorPanel</name>
    <message>
        <source>Colour as #rrggbb</source>
        <translation>Farbe als #rrggbb</translation>
    </message>
    <message>
        <source>The paint colour as in web pages: # and two digits, 0 to f, for each of red, green and blue.</source>
        <translation>Die Malfarbe wie auf Webseiten: # und je zwei Ziffern, 0 bis f, für Rot, Grün und Blau.</translation>
    </message>
    <message>
        <source>Red</source>
        <translation>Rot</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>Grün</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>Blau</translation>
    </message>
    <message>
        <source>%1 of the paint colour, 0 to 255.</source>
        <translation>%1 der Malfarbe, 0 bis 255.</translation>
    </message>
    <message>
        <source>%1 is not a colour: write # and six digits from 0 to f.</source>
        <translation>%1 ist keine Farbe: Schreiben Sie # und sechs Ziffern von 0 bis f.</translation>
    </message>
    <message>
        <source>Paint colour %1, the other %2</source>
        <translation>Malfarbe %1, die andere %2</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>No colour was picked: you did not click on the model.</source>
        <translation>Keine Farbe aufgenommen: Sie haben nicht auf das Modell geklickt.</translation>
    </message>
</context>
<context>
    <name>ui::ColorSwatches</name>
    <message>
        <source>Keep this colour</source>
        <translation>Diese Farbe behalten</translation>
    </message>
    <message>
        <source>Keeps the paint colour among the swatches.</source>
        <translation>Nimmt die Malfarbe in die Farbfelder auf.</translation>
    </message>
    <message>
        <source>%1: click to use it, press Delete to remove it.</source>
        <translation>%1: klicken zum Verwenden, Entf zum Entfernen.</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
</context>
<context>
    <name>ui::ColorWheel</name>
    <message>
        <source>Hue, saturation and value</source>
        <translation>Farbton, Sättigung und Helligkeit</translation>
    </message>
    <message>
        <source>The ring is the hue, the square its saturation and value. Drag, or use the arrow keys and Page Up and Down.</source>
        <translation>Der Ring ist der Farbton, das Quadrat seine Sättigung und Helligkeit. Ziehen Sie, oder drücken Sie die Pfeiltasten, Bild auf und Bild ab.</translation>
    </message>
</context>
<context>
    <name>ui::CommandPalette</name>
    <message>
        <source>Commands and Keys</source>
        <translation>Befehle und Tasten</translation>
    </message>
    <message>
        <source>What do you want to do?</source>
        <translation>Was möchten Sie tun?</translation>
    </message>
    <message>
        <source>Words of a command</source>
        <translation>Wörter eines Befehls</translation>
    </message>
</context>
<context>
    <name>ui::CommandList</name>
    <message>
        <source>Command</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Taste</translation>
    </message>
    <message>
        <source>What it does</source>
        <translation>Was er tut</translation>
    </message>
</context>
<context>
    <name>ui::DrawingLayout</name>
    <message>
        <source>Front</source>
        <translation>Vorn</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
</context>
<context>
    <name>ui::DrawingSheet</name>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>Width × height × depth</source>
        <translation>Breite × Höhe × Tiefe</translation>
    </message>
    <message>
        <source>%1 × %2 × %3 mm</source>
        <translation>%1 × %2 × %3 mm</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Maßstab</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>True to scale when printed at 100 % on A4</source>
        <translation>Maßstäblich bei Druck mit 100 % auf A4</translation>
    </message>
</context>
<context>
    <name>ui::ExportDialog</name>
    <message>
        <source>&amp;Print: STL</source>
        <translation>&amp;Drucken: STL</translation>
    </message>
    <message>
        <source>The shape alone, in millimetres, Z up. Every slicer reads it.</source>
        <translation>Nur die Form, in Millimetern, Z nach oben. Jeder Slicer liest es.</translation>
    </message>
    <message>
        <source>Print with &amp;colour: 3MF</source>
        <translation>In &amp;Farbe drucken: 3MF</translation>
    </message>
    <message>
        <source>Shape and colours, always in millimetres, Z up. Newer slicers read it.</source>
        <translation>Form und Farben, immer in Millimetern, Z nach oben. Neuere Slicer lesen es.</translation>
    </message>
    <message>
        <source>&amp;Game: GLB</source>
        <translation>&amp;Spiel: GLB</translation>
    </message>
    <message>
        <source>Shape and colours, in metres, Y up. Game engines, web pages and Blender read it.</source>
        <translation>Form und Farben, in Metern, Y nach oben. Spiele-Engines, Webseiten und Blender lesen es.</translation>
    </message>
    <message>
        <source>Export for Print or Game</source>
        <translation>Für Druck oder Spiel exportieren</translation>
    </message>
    <message>
        <source>What is the file for?</source>
        <translation>Wofür ist die Datei?</translation>
    </message>
    <message>
        <source>&amp;Limit triangles to:</source>
        <translation>Dreiecke &amp;höchstens:</translation>
    </message>
    <message>
        <source>Removes triangles where shape and colours change least. The model in the window stays as it is.</source>
        <translation>Entfernt Dreiecke dort, wo sich Form und Farben am wenigsten ändern. Das Modell im Fenster bleibt, wie es ist.</translation>
    </message>
    <message>
        <source>Most triangles</source>
        <translation>Höchstzahl der Dreiecke</translation>
    </message>
    <message>
        <source>Maximum number of triangles in the file. A notice appears if the model&apos;s holes and parts require more.</source>
        <translation>Höchstzahl der Dreiecke in der Datei. Brauchen Löcher und Teile mehr, erscheint ein Hinweis.</translation>
    </message>
    <message>
        <source>The model has %1 triangles. The file is verified after saving.</source>
        <translation>Das Modell hat %1 Dreiecke. Die Datei wird nach dem Speichern geprüft.</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exportieren …</translation>
    </message>
    <message>
        <source>&amp;Test in PrusaSlicer</source>
        <translation>In PrusaSlicer &amp;testen</translation>
    </message>
    <message>
        <source>Slices the file with PrusaSlicer&apos;s own settings and reports layers and time, or its error. Esc stops it.</source>
        <translation>Lässt PrusaSlicer die Datei mit seinen eigenen Einstellungen slicen und meldet Schichten und Zeit oder den Fehler. Esc bricht ab.</translation>
    </message>
    <message>
        <source>&amp;Unite overlapping parts</source>
        <translation>Ü&amp;berschneidende Teile vereinigen</translation>
    </message>
    <message>
        <source>Writes the exact union of the visible parts. The model in the window keeps its parts.</source>
        <translation>Schreibt die exakte Vereinigung der sichtbaren Teile. Das Modell im Fenster behält seine Teile.</translation>
    </message>
    <message>
        <source>Parts of the model overlap. Slicers expect surfaces that do not intersect; GLB files keep parts.</source>
        <translation>Teile des Modells überschneiden sich. Slicer erwarten Oberflächen, die sich nicht durchdringen; GLB-Dateien behalten die Teile.</translation>
    </message>
</context>
<context>
    <name>ui::InfoBar</name>
    <message numerus="yes">
        <source>%Ln vertices</source>
        <translation>
            <numerusform>%Ln Eckpunkt</numerusform>
            <numerusform>%Ln Eckpunkte</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 × %2 × %3 mm</source>
        <translation>%1 × %2 × %3 mm</translation>
    </message>
    <message>
        <source>Radius %1 mm</source>
        <translation>Radius %1 mm</translation>
    </message>
</context>
<context>
    <name>ui::FalloffCurve</name>
    <message>
        <source>How the brush fades from its centre to its rim. Drag to change the curve.</source>
        <translation>Wie der Pinsel von der Mitte zum Rand abnimmt. Ziehen Sie, um die Kurve zu biegen.</translation>
    </message>
</context>
<context>
    <name>ui::FileDialogs</name>
    <message>
        <source>Open a Model</source>
        <translation>Modell öffnen</translation>
    </message>
    <message>
        <source>Models (%1)</source>
        <translation>Modelle (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Export the Model</source>
        <translation>Modell exportieren</translation>
    </message>
    <message>
        <source>Insert a Model</source>
        <translation>Modell einfügen</translation>
    </message>
    <message>
        <source>Export the Drawing</source>
        <translation>Zeichnung exportieren</translation>
    </message>
    <message>
        <source>Save the Model</source>
        <translation>Modell speichern</translation>
    </message>
    <message>
        <source>Choose a Reference Image</source>
        <translation>Referenzbild wählen</translation>
    </message>
    <message>
        <source>Images (%1)</source>
        <translation>Bilder (%1)</translation>
    </message>
    <message>
        <source>Choose the Brush&apos;s Shape</source>
        <translation>Pinselform wählen</translation>
    </message>
    <message>
        <source>Choose an Alpha</source>
        <translation>Alpha wählen</translation>
    </message>
    <message>
        <source>Open a Lesson</source>
        <translation>Lektion öffnen</translation>
    </message>
    <message>
        <source>Lessons (%1)</source>
        <translation>Lektionen (%1)</translation>
    </message>
    <message>
        <source>Choose a Folder</source>
        <translation>Ordner wählen</translation>
    </message>
    <message>
        <source>Save the Class</source>
        <translation>Klasse speichern</translation>
    </message>
    <message>
        <source>Open a Class</source>
        <translation>Klasse öffnen</translation>
    </message>
    <message>
        <source>Classes (%1)</source>
        <translation>Klassen (%1)</translation>
    </message>
    <message>
        <source>Write the Class Report</source>
        <translation>Klassenbericht schreiben</translation>
    </message>
    <message>
        <source>Class report</source>
        <translation>Klassenbericht</translation>
    </message>
    <message>
        <source>One file (%1)</source>
        <translation>Eine Datei (%1)</translation>
    </message>
    <message>
        <source>A folder (*)</source>
        <translation>Ein Ordner (*)</translation>
    </message>
    <message>
        <source>Save the Lesson</source>
        <translation>Lektion speichern</translation>
    </message>
    <message>
        <source>Write the Handout</source>
        <translation>Arbeitsblatt schreiben</translation>
    </message>
    <message>
        <source>Import a Brush Preset</source>
        <translation>Pinselvorlage importieren</translation>
    </message>
    <message>
        <source>Brush presets (%1)</source>
        <translation>Pinselvorlagen (%1)</translation>
    </message>
    <message>
        <source>Export the Brush Preset</source>
        <translation>Pinselvorlage exportieren</translation>
    </message>
</context>
<context>
    <name>ui::FileItemDelegate</name>
    <message>
        <source>New name</source>
        <translation>Neuer Name</translation>
    </message>
</context>
<context>
    <name>ui::FileJobs</name>
    <message>
        <source>%1 is not a folder.</source>
        <translation>%1 ist kein Ordner.</translation>
    </message>
    <message>
        <source>%1 cannot be opened: permission denied.</source>
        <translation>%1 lässt sich nicht öffnen: keine Berechtigung.</translation>
    </message>
    <message>
        <source>There is a file named %1 already; %2 keeps its name.</source>
        <translation>Es gibt schon eine Datei namens %1; %2 behält ihren Namen.</translation>
    </message>
    <message>
        <source>%1 could not be renamed (%2).</source>
        <translation>%1 konnte nicht umbenannt werden (%2).</translation>
    </message>
    <message>
        <source>A file needs a name.</source>
        <translation>Eine Datei braucht einen Namen.</translation>
    </message>
    <message>
        <source>A file name may not contain %1.</source>
        <translation>Ein Dateiname darf %1 nicht enthalten.</translation>
    </message>
    <message>
        <source>A file name may not contain control characters.</source>
        <translation>Ein Dateiname darf keine Steuerzeichen enthalten.</translation>
    </message>
    <message>
        <source>%1 cannot be a file&apos;s name.</source>
        <translation>%1 kann kein Dateiname sein.</translation>
    </message>
    <message>
        <source>%1 could not be duplicated (%2).</source>
        <translation>%1 konnte nicht dupliziert werden (%2).</translation>
    </message>
    <message>
        <source> copy</source>
        <comment>behind the name of a file that was duplicated</comment>
        <translation> Kopie</translation>
    </message>
    <message>
        <source>%1 was not deleted: it could not be moved to the trash, and Fettle deletes nothing permanently.</source>
        <translation>%1 wurde nicht gelöscht: Die Datei ließ sich nicht in den Papierkorb verschieben, und Fettle löscht nichts endgültig.</translation>
    </message>
    <message>
        <source>%1 is in the trash.</source>
        <translation>%1 liegt im Papierkorb.</translation>
    </message>
    <message numerus="yes">
        <source>%Ln files are in the trash.</source>
        <translation>
            <numerusform>%Ln Datei liegt im Papierkorb.</numerusform>
            <numerusform>%Ln Dateien liegen im Papierkorb.</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing in %1 can be changed: permission denied.</source>
        <translation>In %1 lässt sich nichts ändern: keine Berechtigung.</translation>
    </message>
</context>
<context>
    <name>ui::FileListModel</name>
    <message>
        <source>folder</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>cannot be read</source>
        <translation>nicht lesbar</translation>
    </message>
    <message>
        <source>not read yet</source>
        <translation>noch nicht gelesen</translation>
    </message>
    <message numerus="yes">
        <source>%Ln vertices</source>
        <translation>
            <numerusform>%Ln Eckpunkt</numerusform>
            <numerusform>%Ln Eckpunkte</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>size, date</comment>
        <translation>%1, %2</translation>
    </message>
</context>
<context>
    <name>ui::FileBrowser</name>
    <message>
        <source>Models in this folder</source>
        <translation>Modelle in diesem Ordner</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>The folder that is shown; type another and press Return.</source>
        <translation>Der gezeigte Ordner; geben Sie einen anderen ein und drücken Sie die Eingabetaste.</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filtern</translation>
    </message>
    <message>
        <source>Shows only files whose names contain these letters.</source>
        <translation>Zeigt nur Dateien, deren Name diese Buchstaben enthält.</translation>
    </message>
    <message>
        <source>Sorted by</source>
        <translation>Sortiert nach</translation>
    </message>
    <message>
        <source>How the files are sorted; folders come first.</source>
        <translation>Sortierung der Dateien; Ordner kommen zuerst.</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>Eckpunkte</translation>
    </message>
    <message>
        <source>Descending</source>
        <translation>Absteigend</translation>
    </message>
    <message>
        <source>Turns the order round.</source>
        <translation>Kehrt die Reihenfolge um.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Stops making pictures of this folder.</source>
        <translation>Erstellt für diesen Ordner keine weiteren Bilder.</translation>
    </message>
    <message>
        <source>Size of the pictures</source>
        <translation>Größe der Bilder</translation>
    </message>
    <message>
        <source>Size of the pictures.</source>
        <translation>Größe der Bilder.</translation>
    </message>
    <message>
        <source>%L1 of %L2 read</source>
        <translation>%L1 von %L2 gelesen</translation>
    </message>
    <message numerus="yes">
        <source>%Ln models</source>
        <translation>
            <numerusform>%Ln Modell</numerusform>
            <numerusform>%Ln Modelle</numerusform>
        </translation>
    </message>
    <message>
        <source>No file name contains %1.</source>
        <translation>Kein Dateiname enthält %1.</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Dateien</translation>
    </message>
    <message>
        <source>No models in this folder (%1).</source>
        <translation>In diesem Ordner sind keine Modelle (%1).</translation>
    </message>
</context>
<context>
    <name>ui::GuideWindow</name>
    <message>
        <source>User Guide</source>
        <translation>Anleitung</translation>
    </message>
    <message>
        <source>Search the guide</source>
        <translation>Anleitung durchsuchen</translation>
    </message>
    <message>
        <source>Words to search for</source>
        <translation>Gesuchte Wörter</translation>
    </message>
    <message>
        <source>Shows only pages with these words. Return jumps to the next match.</source>
        <translation>Zeigt nur Seiten mit diesen Wörtern. Die Eingabetaste geht zur nächsten Stelle.</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Inhalt</translation>
    </message>
    <message>
        <source>No page has all of these words.</source>
        <translation>Keine Seite enthält alle diese Wörter.</translation>
    </message>
    <message>
        <source>Page of the guide</source>
        <translation>Seite der Anleitung</translation>
    </message>
    <message>
        <source>Lesson: %1</source>
        <translation>Lektion: %1</translation>
    </message>
    <message>
        <source>The pages of the guide.</source>
        <translation>Die Seiten der Anleitung.</translation>
    </message>
</context>
<context>
    <name>ui::InputActions</name>
    <message>
        <source>Click to place the ball. Esc cancels.</source>
        <translation>Klicken Sie, um die Kugel zu setzen. Esc bricht ab.</translation>
    </message>
    <message>
        <source>Click the part that is to be active. Esc cancels.</source>
        <translation>Klicken Sie das Teil an, das aktiv werden soll. Esc bricht ab.</translation>
    </message>
    <message>
        <source>Arrow keys move the cross. Space presses while it is held, Return until the next Return.</source>
        <translation>Die Pfeiltasten bewegen das Kreuz. Die Leertaste drückt, solange Sie sie halten, die Eingabetaste bis zum nächsten Mal.</translation>
    </message>
</context>
<context>
    <name>ui::HeadsetActions</name>
    <message>
        <source>L&amp;eave VR</source>
        <translation>VR &amp;verlassen</translation>
    </message>
    <message>
        <source>&amp;Give Back</source>
        <translation>Zurück&amp;geben</translation>
    </message>
</context>
<context>
    <name>ui::HelpText</name>
    <message>
        <source>(no key)</source>
        <translation>(keine Taste)</translation>
    </message>
    <message>
        <source> or </source>
        <comment>one key or the other</comment>
        <translation> oder </translation>
    </message>
</context>
<context>
    <name>ui::HistoryPanel</name>
    <message>
        <source>%1: %2</source>
        <comment>step: what it took</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Anfang</translation>
    </message>
    <message>
        <source>expired</source>
        <translation>verfallen</translation>
    </message>
    <message>
        <source>undone</source>
        <translation>rückgängig gemacht</translation>
    </message>
    <message numerus="yes">
        <source>%Ln dabs</source>
        <translation>
            <numerusform>%Ln Tupfer</numerusform>
            <numerusform>%Ln Tupfer</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>dabs, fusions</comment>
        <translation>%1, %2</translation>
    </message>
    <message numerus="yes">
        <source>%Ln fusions</source>
        <translation>
            <numerusform>%Ln Fusion</numerusform>
            <numerusform>%Ln Fusionen</numerusform>
        </translation>
    </message>
    <message>
        <source>History</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>Every step since the model was opened. Click one, or press Return, to go there.</source>
        <translation>Jeder Schritt seit dem Öffnen des Modells. Klicken Sie auf einen, oder drücken Sie die Eingabetaste, um dorthin zu gehen.</translation>
    </message>
    <message>
        <source>Memory for the history</source>
        <translation>Speicher für den Verlauf</translation>
    </message>
    <message>
        <source>The memory that the history may use. Older steps are moved to disk; if the disk is full, they expire.</source>
        <translation>Der Speicher, den der Verlauf belegen darf. Ältere Schritte werden auf die Festplatte ausgelagert; ist sie voll, verfallen sie.</translation>
    </message>
    <message>
        <source> MB</source>
        <translation> MB</translation>
    </message>
    <message>
        <source>%1 MB of</source>
        <translation>%1 MB von</translation>
    </message>
</context>
<context>
    <name>ui::NamesField</name>
    <message>
        <source>One name per line; you can paste a list. Pupils choose their name; those who had a turn today are marked.</source>
        <translation>Ein Name je Zeile; Sie können eine Liste einfügen. Die Kinder wählen ihren Namen; wer heute schon dran war, ist markiert.</translation>
    </message>
    <message>
        <source>One name per line. Without names, pupils type theirs.</source>
        <translation>Ein Name je Zeile. Ohne Namen tippen Kinder ihren.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is longer than %2 characters.</source>
        <translation>„%1“ ist länger als %2 Zeichen.</translation>
    </message>
    <message>
        <source>A class has at most %1 names; these are %2.</source>
        <translation>Eine Klasse hat höchstens %1 Namen; das sind %2.</translation>
    </message>
    <message>
        <source>In the list more than once, and counted once: %1.</source>
        <translation>Mehrmals in der Liste, aber nur einmal gezählt: %1.</translation>
    </message>
</context>
<context>
    <name>ui::NavigationCube</name>
    <message>
        <source>Front</source>
        <translation>Vorn</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Hinten</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Unten</translation>
    </message>
    <message>
        <source>View cube</source>
        <translation>Ansichtswürfel</translation>
    </message>
    <message>
        <source>Click a face to look from there. Drag to turn the view.</source>
        <translation>Ein Klick auf eine Seite zeigt das Modell von dort. Ziehen dreht die Ansicht.</translation>
    </message>
</context>
<context>
    <name>ui::RecentFiles</name>
    <message>
        <source>None yet</source>
        <translation>Noch keine</translation>
    </message>
</context>
<context>
    <name>ui::ShortcutEdit</name>
    <message>
        <source>no key</source>
        <translation>keine Taste</translation>
    </message>
</context>
<context>
    <name>ui::ShortcutsPage</name>
    <message>
        <source>Fettle</source>
        <translation>Fettle</translation>
    </message>
    <message>
        <source>Blender</source>
        <translation>Blender</translation>
    </message>
    <message>
        <source>ZBrush</source>
        <translation>ZBrush</translation>
    </message>
    <message>
        <source>Search for a command or a key</source>
        <translation>Befehl oder Taste suchen</translation>
    </message>
    <message>
        <source>Words of a command</source>
        <translation>Wörter eines Befehls</translation>
    </message>
    <message>
        <source>Shows only commands with these words or this key.</source>
        <translation>Zeigt nur Befehle mit diesen Wörtern oder dieser Taste.</translation>
    </message>
    <message>
        <source>Commands and Keys</source>
        <translation>Befehle und Tasten</translation>
    </message>
    <message>
        <source>Every command with its keys. Change the keys of the selected one below.</source>
        <translation>Alle Befehle mit ihren Tasten. Die des markierten ändern Sie unten.</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Belegung</translation>
    </message>
    <message>
        <source>Chooses a set of keys. Keys that you changed yourself stay.</source>
        <translation>Wählt eine Tastenbelegung. Tasten, die Sie selbst geändert haben, bleiben.</translation>
    </message>
    <message>
        <source>Reset A&amp;ll Keys</source>
        <translation>A&amp;lle Tasten zurücksetzen</translation>
    </message>
    <message>
        <source>Resets all commands to the keys of the preset.</source>
        <translation>Setzt alle Befehle auf die Tasten der Belegung zurück.</translation>
    </message>
    <message>
        <source>&amp;Preset</source>
        <translation>&amp;Belegung</translation>
    </message>
    <message>
        <source>First key</source>
        <translation>Erste Taste</translation>
    </message>
    <message>
        <source>Second key</source>
        <translation>Zweite Taste</translation>
    </message>
    <message>
        <source>Press the new key for the command, or Backspace to remove it.</source>
        <translation>Drücken Sie die neue Taste für den Befehl, oder die Rücktaste, um sie zu entfernen.</translation>
    </message>
    <message>
        <source>R&amp;eset</source>
        <translation>Zurück&amp;setzen</translation>
    </message>
    <message>
        <source>Resets the command to the keys of the preset.</source>
        <translation>Setzt den Befehl auf die Tasten der Belegung zurück.</translation>
    </message>
    <message>
        <source>&amp;Go There</source>
        <translation>Dort&amp;hin</translation>
    </message>
    <message>
        <source>Selects the command that uses the key.</source>
        <translation>Markiert den Befehl, der diese Taste verwendet.</translation>
    </message>
    <message>
        <source>This key cannot be changed.</source>
        <translation>Diese Taste lässt sich nicht ändern.</translation>
    </message>
    <message>
        <source>%1 is already used by %2.</source>
        <translation>%1 wird schon von „%2“ verwendet.</translation>
    </message>
    <message>
        <source>%1 stays with %2.</source>
        <translation>%1 bleibt bei „%2“.</translation>
    </message>
    <message>
        <source>A modifier key cannot be a shortcut on its own.</source>
        <translation>Eine Zusatztaste allein kann kein Tastenkürzel sein.</translation>
    </message>
    <message>
        <source>%1 is needed to move and type in panels and dialogs.</source>
        <translation>%1 wird zum Bewegen und Tippen in Bedienfeldern und Dialogen gebraucht.</translation>
    </message>
    <message>
        <source>Alt with a letter opens menus and reaches controls.</source>
        <translation>Alt mit einem Buchstaben öffnet Menüs und wählt Bedienelemente.</translation>
    </message>
</context>
<context>
    <name>ui::LessonChoice</name>
    <message>
        <source>Pupils can begin with it: it is shown stroke by stroke, and the report says how far they got.</source>
        <translation>Die Kinder können damit beginnen: Die Lektion wird Strich für Strich gezeigt, und der Bericht sagt, wie weit sie gekommen sind.</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>From a File…</source>
        <translation>Aus einer Datei …</translation>
    </message>
</context>
<context>
    <name>ui::LessonEditor</name>
    <message>
        <source>A lesson records what you sculpt, step by step, here or in the headset. It begins with:</source>
        <translation>Eine Lektion zeichnet auf, was Sie formen, Schritt für Schritt, hier oder in der VR-Brille. Sie beginnt mit:</translation>
    </message>
    <message>
        <source>Begins with</source>
        <translation>Beginnt mit</translation>
    </message>
    <message>
        <source>The model as it is now</source>
        <translation>Modell, wie es jetzt ist</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Aufzeichnen</translation>
    </message>
    <message>
        <source>Begins a lesson of one step. Earlier strokes can no longer be undone.</source>
        <translation>Beginnt eine Lektion mit einem Schritt. Frühere Striche lassen sich dann nicht mehr rückgängig machen.</translation>
    </message>
    <message>
        <source>Or change an existing lesson:</source>
        <translation>Oder eine vorhandene Lektion ändern:</translation>
    </message>
    <message>
        <source>Built-in lessons</source>
        <translation>Mitgelieferte Lektionen</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Bearbeiten</translation>
    </message>
    <message>
        <source>Opens it here; you save it under a name of your own.</source>
        <translation>Öffnet sie hier; Sie speichern sie unter einem eigenen Namen.</translation>
    </message>
    <message>
        <source>Open a Lesson…</source>
        <translation>Lektion öffnen …</translation>
    </message>
    <message>
        <source>Opens a lesson from a zip or a folder, to change it.</source>
        <translation>Öffnet eine Lektion aus einer ZIP-Datei oder einem Ordner, um sie zu ändern.</translation>
    </message>
    <message>
        <source>Language of the texts</source>
        <translation>Sprache der Texte</translation>
    </message>
    <message>
        <source>The language that you write in. Where a text is missing, pupils read it in another language.</source>
        <translation>Die Sprache, in der Sie schreiben. Wo ein Text fehlt, lesen Kinder ihn in einer anderen.</translation>
    </message>
    <message>
        <source>Title of the lesson</source>
        <translation>Titel der Lektion</translation>
    </message>
    <message>
        <source>Title of the lesson.</source>
        <translation>Titel der Lektion.</translation>
    </message>
    <message>
        <source>In one sentence</source>
        <translation>In einem Satz</translation>
    </message>
    <message>
        <source>Subject of the lesson, in one sentence.</source>
        <translation>Thema der Lektion, in einem Satz.</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>New Step</source>
        <translation>Neuer Schritt</translation>
    </message>
    <message>
        <source>Starts a new step at the end; strokes belong to it from here on.</source>
        <translation>Beginnt am Ende einen neuen Schritt; von hier an gehören Striche dazu.</translation>
    </message>
    <message>
        <source>Moves the step up</source>
        <translation>Schiebt den Schritt nach oben</translation>
    </message>
    <message>
        <source>Moves the step down</source>
        <translation>Schiebt den Schritt nach unten</translation>
    </message>
    <message>
        <source>Removes the step with its strokes</source>
        <translation>Entfernt den Schritt mit seinen Strichen</translation>
    </message>
    <message>
        <source>Plays the lesson to its end and records from there. Press again to stop.</source>
        <translation>Spielt die Lektion bis zum Ende ab und zeichnet von dort an auf. Erneut drücken, um aufzuhören.</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Speichern …</translation>
    </message>
    <message>
        <source>Plays the lesson to its end, checks each step, and saves it as a file or a folder.</source>
        <translation>Spielt die Lektion bis zum Ende ab, prüft jeden Schritt und schreibt sie als eine Datei oder einen Ordner.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Closes this lesson. The model stays as it is.</source>
        <translation>Schließt diese Lektion. Das Modell bleibt, wie es ist.</translation>
    </message>
    <message>
        <source>%1. %2 (%3)</source>
        <extracomment>number of a step, its title, how many strokes it has</extracomment>
        <translation>%1. %2 (%3)</translation>
    </message>
    <message>
        <source>Step %1</source>
        <translation>Schritt %1</translation>
    </message>
    <message>
        <source>Stop Recording</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Record On</source>
        <translation>Weiter aufzeichnen</translation>
    </message>
    <message>
        <source>Lesson Editor</source>
        <translation>Lektion bearbeiten</translation>
    </message>
    <message>
        <source>● Recording into step %1</source>
        <translation>● Aufzeichnung in Schritt %1</translation>
    </message>
    <message>
        <source>○ Not recording</source>
        <translation>○ Keine Aufzeichnung</translation>
    </message>
</context>
<context>
    <name>ui::LessonPanel</name>
    <message>
        <source>Choose a lesson. It starts with its own model.</source>
        <translation>Wähle eine Lektion. Sie beginnt mit einem eigenen Modell.</translation>
    </message>
    <message>
        <source>Open a Lesson…</source>
        <translation>Lektion öffnen …</translation>
    </message>
    <message>
        <source>Opens a lesson from a zip or a folder.</source>
        <translation>Öffnet eine Lektion aus einer ZIP-Datei oder einem Ordner.</translation>
    </message>
    <message>
        <source>How far the teacher is</source>
        <translation>Wie weit die Lehrkraft ist</translation>
    </message>
    <message>
        <source>Show Me</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>One Stroke</source>
        <translation>Ein Strich</translation>
    </message>
    <message>
        <source>Shows the teacher&apos;s next stroke alone.</source>
        <translation>Zeigt nur den nächsten Strich der Lehrkraft.</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>Speed of the demonstration.</source>
        <translation>Tempo der Vorführung.</translation>
    </message>
    <message>
        <source>%1 ×</source>
        <comment>speed</comment>
        <translation>%1 ×</translation>
    </message>
    <message>
        <source>Try It</source>
        <translation>Versuchen</translation>
    </message>
    <message>
        <source>Undoes the strokes of this step. Now it is your turn.</source>
        <translation>Macht die Striche dieses Schritts rückgängig. Jetzt bist du dran.</translation>
    </message>
    <message>
        <source>Show the difference</source>
        <translation>Unterschied zeigen</translation>
    </message>
    <message>
        <source>Colours the model by how far it is from the teacher&apos;s.</source>
        <translation>Färbt das Modell nach seinem Abstand von dem der Lehrkraft.</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>Verlassen</translation>
    </message>
    <message>
        <source>Ends the lesson. The model stays as it is.</source>
        <translation>Beendet die Lektion. Das Modell bleibt, wie es ist.</translation>
    </message>
    <message>
        <source>%1: step %2 of %3</source>
        <translation>%1: Schritt %2 von %3</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>Lektionen</translation>
    </message>
    <message>
        <source>Start from the Teacher&apos;s Model</source>
        <translation>Mit dem Modell der Lehrkraft anfangen</translation>
    </message>
    <message>
        <source>Begins this step with the teacher&apos;s model. Undo brings yours back.</source>
        <translation>Beginnt diesen Schritt mit dem Modell der Lehrkraft. Rückgängig bringt deines zurück.</translation>
    </message>
    <message>
        <source>Handout as PDF…</source>
        <translation>Arbeitsblatt als PDF …</translation>
    </message>
    <message>
        <source>Writes the texts and pictures of all steps to a PDF for pupils.</source>
        <translation>Schreibt die Texte und Bilder aller Schritte als PDF für die Kinder.</translation>
    </message>
    <message>
        <source>Brush: %1</source>
        <comment>tools and sizes</comment>
        <translation>Pinsel: %1</translation>
    </message>
    <message>
        <source>This turn has no lesson.</source>
        <translation>Dieser Durchgang hat keine Lektion.</translation>
    </message>
</context>
<context>
    <name>ui::LessonStepEditor</name>
    <message>
        <source>Title of the step</source>
        <translation>Titel des Schritts</translation>
    </message>
    <message>
        <source>What the step is called.</source>
        <translation>Wie der Schritt heißt.</translation>
    </message>
    <message>
        <source>Text of the step</source>
        <translation>Text des Schritts</translation>
    </message>
    <message>
        <source>Text that the pupil reads beside the model.</source>
        <translation>Der Text, den das Kind neben dem Modell liest.</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>Strokes of the step</source>
        <translation>Striche des Schritts</translation>
    </message>
    <message>
        <source>Cut Stroke</source>
        <translation>Strich herausnehmen</translation>
    </message>
    <message>
        <source>Removes this stroke from the lesson. Later ones are played without it when the lesson is saved.</source>
        <translation>Nimmt diesen Strich aus der Lektion. Spätere werden beim Speichern ohne ihn abgespielt.</translation>
    </message>
    <message>
        <source>Strokes</source>
        <translation>Striche</translation>
    </message>
    <message>
        <source>Tools that the pupil has; if none is chosen, all of them.</source>
        <translation>Werkzeuge, die das Kind hat; alle, wenn keines gewählt ist.</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>%1, at least</source>
        <translation>%1, mindestens</translation>
    </message>
    <message>
        <source>%1, at most</source>
        <translation>%1, höchstens</translation>
    </message>
    <message>
        <source>The step is done when the pupil&apos;s model is so:</source>
        <translation>Der Schritt ist geschafft, wenn das Modell des Kindes so ist:</translation>
    </message>
    <message>
        <source>at least</source>
        <translation>mindestens</translation>
    </message>
    <message>
        <source>at most</source>
        <translation>höchstens</translation>
    </message>
    <message>
        <source>Holes</source>
        <translation>Löcher</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Teile</translation>
    </message>
    <message>
        <source>Height, mm</source>
        <translation>Höhe, mm</translation>
    </message>
    <message>
        <source>Width, mm</source>
        <translation>Breite, mm</translation>
    </message>
    <message>
        <source>Depth, mm</source>
        <translation>Tiefe, mm</translation>
    </message>
    <message>
        <source>Volume, mm³</source>
        <translation>Volumen, mm³</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Dreiecke</translation>
    </message>
    <message>
        <source>How close the pupil&apos;s shape must be to the teacher&apos;s.</source>
        <translation>Wie nahe die Form des Kindes der Form der Lehrkraft kommen muss.</translation>
    </message>
    <message>
        <source>Near the teacher&apos;s, mm</source>
        <translation>Nahe am Vorbild, mm</translation>
    </message>
    <message>
        <source>Ready to print</source>
        <translation>Druckfertig</translation>
    </message>
    <message>
        <source>Take from the Model</source>
        <translation>Vom Modell übernehmen</translation>
    </message>
    <message>
        <source>Asks for the holes and parts that the model in the window has, for its height at least, and that it can be printed.</source>
        <translation>Verlangt so viele Löcher und Teile, wie das Modell im Fenster hat, mindestens seine Höhe und dass es druckfertig ist.</translation>
    </message>
    <message>
        <source>Goal</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>What the pupil reads</source>
        <translation>Was das Kind liest</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <comment>number of a stroke; what it is</comment>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>Length from above, mm</source>
        <translation>Länge von oben, mm</translation>
    </message>
    <message>
        <source>Legs on the ground</source>
        <translation>Beine am Boden</translation>
    </message>
    <message>
        <source>Flat base, mm²</source>
        <translation>Ebene Standfläche, mm²</translation>
    </message>
    <message>
        <source>Narrow places all around</source>
        <translation>Schmale Stellen ringsum</translation>
    </message>
</context>
<context>
    <name>ui::MainWindow</name>
    <message>
        <source>Fettle</source>
        <translation>Fettle</translation>
    </message>
    <message>
        <source>&amp;Choose Another Place…</source>
        <translation>Anderen &amp;Ort wählen …</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Undo %1</source>
        <translation>&amp;Rückgängig: %1</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederherstellen</translation>
    </message>
    <message>
        <source>&amp;Redo %1</source>
        <translation>&amp;Wiederherstellen: %1</translation>
    </message>
    <message>
        <source>%1[*] – Fettle</source>
        <translation>%1[*] – Fettle</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 wurde gespeichert.</translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation>&amp;Bedienfelder</translation>
    </message>
    <message>
        <source>Tool Bar</source>
        <translation>Werkzeugleiste</translation>
    </message>
    <message>
        <source>Tool Options</source>
        <translation>Werkzeugoptionen</translation>
    </message>
    <message>
        <source>Stamp now uses the current shape of %1.</source>
        <translation>Der Stempel verwendet jetzt %1, wie es gerade ist.</translation>
    </message>
</context>
<context>
    <name>ui::NumberFormat</name>
    <message>
        <source>%1 mm³</source>
        <translation>%1 mm³</translation>
    </message>
    <message>
        <source>%1 cm³</source>
        <translation>%1 cm³</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>%1 h %2 min</source>
        <translation>%1 h %2 min</translation>
    </message>
    <message>
        <source>%1 mm²</source>
        <translation>%1 mm²</translation>
    </message>
    <message>
        <source>%1 cm²</source>
        <translation>%1 cm²</translation>
    </message>
</context>
<context>
    <name>ui::RepairDialogs</name>
    <message>
        <source>Repair the Model</source>
        <translation>Modell reparieren</translation>
    </message>
    <message>
        <source>Also fill large holes (over a quarter of the model&apos;s size)</source>
        <translation>Auch große Löcher füllen (über ein Viertel der Modellgröße)</translation>
    </message>
    <message>
        <source>Treat enclosed parts as cavities</source>
        <translation>Eingeschlossene Teile als Hohlräume behandeln</translation>
    </message>
    <message>
        <source>Repair and Open</source>
        <translation>Reparieren und öffnen</translation>
    </message>
    <message>
        <source>Fettle can repair it: it fills holes, turns faces outwards and joins parts that intersect. You will see what changed. The file stays as it is.</source>
        <translation>Fettle kann es reparieren: Es füllt Löcher, dreht Flächen nach außen und verbindet Teile, die sich schneiden. Sie sehen, was sich geändert hat. Die Datei bleibt, wie sie ist.</translation>
    </message>
    <message>
        <source>Fettle</source>
        <translation>Fettle</translation>
    </message>
    <message>
        <source>%1 was repaired. Save to keep the repaired model; the original file stays as it is.</source>
        <translation>%1 wurde repariert. Speichern Sie, um das reparierte Modell zu behalten; die ursprüngliche Datei bleibt, wie sie ist.</translation>
    </message>
    <message>
        <source>Repair and Insert</source>
        <translation>Reparieren und einfügen</translation>
    </message>
    <message>
        <source>%1 was repaired and inserted. Undo reverts both.</source>
        <translation>%1 wurde repariert und eingefügt. „Rückgängig“ macht beides rückgängig.</translation>
    </message>
    <message>
        <source>Repaired, but Changed</source>
        <translation>Repariert, aber verändert</translation>
    </message>
    <message>
        <source>In the file</source>
        <translation>In der Datei</translation>
    </message>
    <message>
        <source>Repaired</source>
        <translation>Repariert</translation>
    </message>
    <message>
        <source>Open This</source>
        <translation>Dieses öffnen</translation>
    </message>
    <message>
        <source>Insert This</source>
        <translation>Dieses einfügen</translation>
    </message>
</context>
<context>
    <name>ui::RepairMessages</name>
    <message>
        <source>Points welded: %1</source>
        <translation>Verschweißte Punkte: %1</translation>
    </message>
    <message>
        <source>Faces without area removed: %1</source>
        <translation>Entfernte Flächen ohne Flächeninhalt: %1</translation>
    </message>
    <message>
        <source>Duplicate faces removed: %1</source>
        <translation>Entfernte doppelte Flächen: %1</translation>
    </message>
    <message>
        <source>Faces or parts turned outwards: %1</source>
        <translation>Nach außen gedrehte Flächen oder Teile: %1</translation>
    </message>
    <message>
        <source>Faces of inner sheets removed: %1</source>
        <translation>Entfernte Flächen innerer Schichten: %1</translation>
    </message>
    <message>
        <source>Holes filled: %1</source>
        <translation>Gefüllte Löcher: %1</translation>
    </message>
    <message>
        <source>of these, longer than a quarter of the model: %1</source>
        <translation>davon länger als ein Viertel des Modells: %1</translation>
    </message>
    <message>
        <source>Parts inside of others: %1</source>
        <translation>Teile im Innern anderer: %1</translation>
    </message>
    <message>
        <source>Intersections resolved: %1</source>
        <translation>Aufgelöste Durchdringungen: %1</translation>
    </message>
    <message>
        <source>Touching edges and points separated: %1</source>
        <translation>Getrennte Kanten und Punkte, die sich nur berührten: %1</translation>
    </message>
    <message>
        <source>Tangles that could not be resolved, covered by small solids: %1, the widest %2 mm</source>
        <translation>Knäuel, die sich nicht auflösen ließen, von kleinen Körpern bedeckt: %1, das breiteste %2 mm</translation>
    </message>
    <message>
        <source>Walls on each other within rounding, joined or removed: %1</source>
        <translation>Bis auf Rundung aufeinanderliegende Wände, verbunden oder entfernt: %1</translation>
    </message>
    <message>
        <source>Tiny thin parts left out: %1</source>
        <translation>Weggelassene winzige dünne Teile: %1</translation>
    </message>
    <message>
        <source>The surface was rebuilt, with edges of about %1 mm.</source>
        <translation>Die Oberfläche wurde neu gebildet, mit Kanten von etwa %1 mm.</translation>
    </message>
    <message>
        <source>The new surface is at most %1 mm (mean %2 mm) from the old one; the old one at most %3 mm (mean %4 mm) from the new.</source>
        <translation>Die neue Oberfläche ist höchstens %1 mm (im Mittel %2 mm) von der alten entfernt, die alte höchstens %3 mm (im Mittel %4 mm) von der neuen.</translation>
    </message>
    <message>
        <source>%1 was not repaired: it has holes longer than a quarter of its size (%2), the largest near %3.</source>
        <translation>%1 wurde nicht repariert: Es hat Löcher, die länger als ein Viertel seiner Größe sind (%2), das größte bei %3.</translation>
    </message>
    <message>
        <source>%1 cannot be repaired: its faces enclose no space.</source>
        <translation>%1 kann nicht repariert werden: Seine Flächen umschließen keinen Raum.</translation>
    </message>
    <message>
        <source>Open points joined at cracks: %1, within %2 mm</source>
        <translation>An Rissen verbundene offene Punkte: %1, höchstens %2 mm auseinander</translation>
    </message>
    <message>
        <source>Repairing %1: points and faces</source>
        <translation>%1 wird repariert: Punkte und Flächen</translation>
    </message>
    <message>
        <source>Repairing %1: cracks</source>
        <translation>%1 wird repariert: Risse</translation>
    </message>
    <message>
        <source>Repairing %1: face directions</source>
        <translation>%1 wird repariert: Richtung der Flächen</translation>
    </message>
    <message>
        <source>Repairing %1: holes</source>
        <translation>%1 wird repariert: Löcher</translation>
    </message>
    <message>
        <source>Repairing %1: intersections</source>
        <translation>%1 wird repariert: Durchdringungen</translation>
    </message>
    <message>
        <source>Repairing %1: new surface</source>
        <translation>%1 wird repariert: neue Oberfläche</translation>
    </message>
    <message>
        <source>Repairing %1: check</source>
        <translation>%1 wird repariert: Prüfung</translation>
    </message>
    <message>
        <source>Repairing %1: measuring the changes</source>
        <translation>%1 wird repariert: Änderungen messen</translation>
    </message>
    <message>
        <source>Masked points lost in the repair: %1</source>
        <translation>Entfernte maskierte Punkte, samt ihrer Maske: %1</translation>
    </message>
    <message>
        <source>Volume: %1, before %2</source>
        <translation>Volumen: %1, vorher %2</translation>
    </message>
    <message>
        <source>Surface: %1, before %2</source>
        <translation>Oberfläche: %1, vorher %2</translation>
    </message>
    <message>
        <source>Parts: %1, before %2</source>
        <translation>Teile: %1, vorher %2</translation>
    </message>
    <message>
        <source>%1 could only be rebuilt, with edges of about %2 mm: its shape is close to the old one, but detail is lost.</source>
        <translation>%1 ließ sich nur neu aufbauen, mit Kanten von etwa %2 mm: Die Form ist nahe an der alten, aber Details sind verloren.</translation>
    </message>
    <message>
        <source>%1 was repaired, but lost surface inside: on average, the old one is %2 mm (%3 %) away.</source>
        <translation>%1 wurde repariert, verlor aber Fläche im Inneren: im Mittel %2 mm (%3 %) Abstand.</translation>
    </message>
    <message>
        <source>%1 was repaired, but now has %2 % of its volume.</source>
        <translation>%1 wurde repariert, hat aber nun %2 % seines Volumens.</translation>
    </message>
    <message>
        <source>%1 was repaired, but parts that could be holes were treated as parts that face the wrong way: %2 % of the space.</source>
        <translation>%1 wurde repariert, aber Teile, die Löcher sein könnten, wurden als falsch herum gedrehte Teile behandelt: %2 % des Raums.</translation>
    </message>
    <message>
        <source>%1 was repaired, but the space that it encloses differs by %2 % from what its faces enclosed before.</source>
        <translation>%1 wurde repariert, aber der Raum, den es umschließt, weicht um %2 % von dem ab, den seine Flächen vorher umschlossen.</translation>
    </message>
    <message>
        <source>%1 was repaired, but part of its surface was lost: it is %2 mm from the new one on average, %3 % of the size.</source>
        <translation>%1 wurde repariert, aber ein Teil der Oberfläche ging verloren: Sie liegt im Mittel %2 mm von der neuen entfernt, %3 % der Größe.</translation>
    </message>
    <message>
        <source>%1 cannot be repaired as it is: its faces could not be separated near %2.</source>
        <translation>%1 lässt sich so nicht reparieren: Bei %2 ließen sich die Flächen nicht trennen.</translation>
    </message>
    <message>
        <source>%1 cannot be repaired as it is: its faces could not be separated.</source>
        <translation>%1 lässt sich so nicht reparieren: Die Flächen ließen sich nicht trennen.</translation>
    </message>
    <message>
        <source>%1 cannot be repaired as it is: its faces are too badly connected, and most of it would be lost.</source>
        <translation>%1 lässt sich so nicht reparieren: Die Flächen sind zu schlecht verbunden, das meiste ginge verloren.</translation>
    </message>
    <message>
        <source>%1 cannot be repaired as it is: its faces are too badly connected, and most of it would be lost. Openings: %2, the widest near %3.</source>
        <translation>%1 lässt sich so nicht reparieren: Die Flächen sind zu schlecht verbunden, das meiste ginge verloren. Öffnungen: %2, die weiteste bei %3.</translation>
    </message>
    <message numerus="yes">
        <source>%n open sheets left out, which enclose no space; the largest is %1 x %2 mm</source>
        <translation>
            <numerusform>%n offene Fläche, die keinen Raum umschließt, weggelassen; sie ist %1 x %2 mm groß</numerusform>
            <numerusform>%n offene Flächen, die keinen Raum umschließen, weggelassen; die größte ist %1 x %2 mm groß</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 cannot be repaired: it has %n open sheets that enclose no space, the largest %2 x %3 mm.</source>
        <translation>
            <numerusform>%1 lässt sich nicht reparieren: Es hat nur %n offene Fläche, die keinen Raum umschließt, %2 x %3 mm groß.</numerusform>
            <numerusform>%1 lässt sich nicht reparieren: Es hat %n offene Flächen, die keinen Raum umschließen, die größte %2 x %3 mm groß.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::ErrorMessages</name>
    <message>
        <source>%1 cannot be used.</source>
        <translation>%1 kann nicht verwendet werden.</translation>
    </message>
    <message>
        <source>open edges: %1</source>
        <translation>offene Kanten: %1</translation>
    </message>
    <message>
        <source>edges of more than two faces: %1</source>
        <translation>Kanten mit mehr als zwei Flächen: %1</translation>
    </message>
    <message>
        <source>points at which parts merely touch: %1</source>
        <translation>Punkte, an denen sich Teile nur berühren: %1</translation>
    </message>
    <message>
        <source>edges between faces that face different ways: %1</source>
        <translation>Kanten zwischen verschieden ausgerichteten Flächen: %1</translation>
    </message>
    <message>
        <source>faces without area: %1</source>
        <translation>Flächen ohne Flächeninhalt: %1</translation>
    </message>
    <message>
        <source>pairs of faces that intersect: %1</source>
        <translation>Flächenpaare, die sich durchdringen: %1</translation>
    </message>
    <message>
        <source>it is inside out, or its shells are wrongly nested</source>
        <translation>Innen und Außen sind vertauscht, oder die Hüllen sind falsch verschachtelt</translation>
    </message>
    <message>
        <source>%1 cannot be sculpted yet, because its surface does not bound a solid (%2).</source>
        <translation>%1 lässt sich noch nicht formen, weil seine Oberfläche keinen Körper umschließt (%2).</translation>
    </message>
    <message>
        <source>, </source>
        <comment>between the faults of a model</comment>
        <translation>, </translation>
    </message>
    <message>
        <source>%1 cannot be sculpted yet, because some of its faces would intersect after rounding to the program&apos;s grid (faces: %2).</source>
        <translation>%1 lässt sich noch nicht formen, weil sich einige Flächen nach dem Runden auf das Raster des Programms schneiden würden (Flächen: %2).</translation>
    </message>
    <message>
        <source>%1: there is no such file or folder.</source>
        <translation>%1: Diese Datei oder diesen Ordner gibt es nicht.</translation>
    </message>
    <message>
        <source>%1 cannot be read%2.</source>
        <translation>%1 kann nicht gelesen werden%2.</translation>
    </message>
    <message>
        <source>%1 is not a file but a folder or a device.</source>
        <translation>%1 ist keine Datei, sondern ein Ordner oder ein Gerät.</translation>
    </message>
    <message>
        <source>%1 is empty.</source>
        <translation>%1 ist leer.</translation>
    </message>
    <message>
        <source>%1 is too large: it has %2, and at most %3 are read.</source>
        <translation>%1 ist zu groß: Die Datei hat %2, gelesen werden höchstens %3.</translation>
    </message>
    <message>
        <source>%1 is not a valid %2 file.</source>
        <translation>%1 ist keine gültige %2-Datei.</translation>
    </message>
    <message>
        <source>%1 is not a valid %2 file; it looks like %3.</source>
        <translation>%1 ist keine gültige %2-Datei; es sieht nach %3 aus.</translation>
    </message>
    <message>
        <source>plain text</source>
        <translation>reinem Text</translation>
    </message>
    <message>
        <source>%1: the file is incomplete; it ends here.</source>
        <translation>%1: Die Datei ist unvollständig; sie endet hier.</translation>
    </message>
    <message>
        <source>%1: the file is incomplete; %2 are expected, but it has %3.</source>
        <translation>%1: Die Datei ist unvollständig; erwartet werden %2, vorhanden sind %3.</translation>
    </message>
    <message>
        <source>%1: %2 elements are announced, but the file has room for %3.</source>
        <translation>%1: Angekündigt sind %2 Elemente, die Datei hat aber nur Platz für %3.</translation>
    </message>
    <message>
        <source>%1: the file is incomplete; %2 vertices are announced, but it has room for %3.</source>
        <translation>%1: Die Datei ist unvollständig; %2 Eckpunkte sind angekündigt, aber sie hat nur Platz für %3.</translation>
    </message>
    <message>
        <source>%1: the file is incomplete; %2 faces are announced, but it has room for %3.</source>
        <translation>%1: Die Datei ist unvollständig; %2 Flächen sind angekündigt, aber sie hat nur Platz für %3.</translation>
    </message>
    <message>
        <source>%1: %2 faces are announced, but the file has %3.</source>
        <translation>%1: %2 Flächen sind angekündigt, aber die Datei hat %3.</translation>
    </message>
    <message>
        <source>%1: a coordinate is not a finite number.</source>
        <translation>%1: Eine Koordinate ist keine endliche Zahl.</translation>
    </message>
    <message>
        <source>%1: a number is missing here, or is not finite.</source>
        <translation>%1: Hier fehlt eine Zahl, oder sie ist nicht endlich.</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not a whole number that is valid here.</source>
        <translation>%1: „%2“ ist keine hier gültige ganze Zahl.</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not a finite number.</source>
        <translation>%1: „%2“ ist keine endliche Zahl.</translation>
    </message>
    <message>
        <source>%1: a face refers to vertex %2, but there are only %3 vertices.</source>
        <translation>%1: Eine Fläche verweist auf Eckpunkt %2, es gibt aber nur %3 Eckpunkte.</translation>
    </message>
    <message>
        <source>%1: too many %2; at most %3 are allowed.</source>
        <translation>%1: zu viele Elemente (%2); höchstens %3 sind erlaubt.</translation>
    </message>
    <message>
        <source>%1 contains no faces.</source>
        <translation>%1 enthält keine Flächen.</translation>
    </message>
    <message>
        <source>%1 contains no faces, except those of slicer parts that are not printed (%2): negative volumes, modifiers and supports, which are left out.</source>
        <translation>%1 enthält keine Flächen außer denen von Slicer-Teilen, die nicht gedruckt werden (%2): negative Volumen, Modifizierer und Stützen; diese werden weggelassen.</translation>
    </message>
    <message>
        <source>%1 cannot be written: it is not allowed%2.</source>
        <translation>%1 lässt sich nicht schreiben: keine Berechtigung%2.</translation>
    </message>
    <message>
        <source>%1 was not written: the disk is full.</source>
        <translation>%1 wurde nicht geschrieben: Der Datenträger ist voll.</translation>
    </message>
    <message>
        <source>%1 was not written%2.</source>
        <translation>%1 wurde nicht geschrieben%2.</translation>
    </message>
    <message>
        <source>, line %1</source>
        <translation>, Zeile %1</translation>
    </message>
    <message>
        <source>, byte %1</source>
        <translation>, Byte %1</translation>
    </message>
    <message>
        <source>%1 was not written: so far from the origin its coordinates are too coarse for the model&apos;s detail. Recentre the model.</source>
        <translation>%1 wurde nicht geschrieben: So weit vom Ursprung entfernt sind die Koordinaten zu grob für die Details des Modells. Zentrieren Sie das Modell.</translation>
    </message>
    <message>
        <source>%1 cannot be written: the folder %2 does not exist.</source>
        <translation>%1 lässt sich nicht schreiben: Den Ordner %2 gibt es nicht.</translation>
    </message>
    <message>
        <source>Nothing happened here: the surface would have intersected itself.</source>
        <translation>Hier ist nichts geschehen: Die Oberfläche hätte sich selbst geschnitten.</translation>
    </message>
    <message>
        <source>The brush stopped: surfaces touch, and they may not join here.</source>
        <translation>Der Pinsel hielt an: Flächen berühren sich und dürfen sich hier nicht verbinden.</translation>
    </message>
    <message>
        <source>The brush stopped at the edge of the workspace.</source>
        <translation>Der Pinsel hielt am Rand des Arbeitsraums an.</translation>
    </message>
    <message>
        <source>The brush is too large for this much detail. Continue with another stroke.</source>
        <translation>Der Pinsel ist zu groß für so viele Details. Machen Sie mit einem weiteren Strich weiter.</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Stärke</translation>
    </message>
    <message>
        <source>Falloff</source>
        <translation>Abnahme</translation>
    </message>
    <message>
        <source>Detail</source>
        <translation>Detail</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>%1: from %2 to %3 mm with this model.</source>
        <translation>%1: bei diesem Modell von %2 bis %3 mm.</translation>
    </message>
    <message>
        <source>%1: from %2 to %3.</source>
        <translation>%1: von %2 bis %3.</translation>
    </message>
    <message>
        <source>The model is not symmetric here: both sides were changed, but they are not exact mirror images.</source>
        <translation>Das Modell ist hier nicht symmetrisch: Beide Seiten wurden geändert, sind aber keine genauen Spiegelbilder.</translation>
    </message>
    <message>
        <source>%1: drawings are written as PDF, SVG or PNG; the file extension decides which.</source>
        <translation>%1: Zeichnungen werden als PDF, SVG oder PNG geschrieben; die Endung bestimmt das Format.</translation>
    </message>
    <message>
        <source>%1 contains no image that can be read.</source>
        <translation>%1 enthält kein lesbares Bild.</translation>
    </message>
    <message>
        <source>The reference image %1 no longer exists.</source>
        <translation>Das Referenzbild %1 gibt es nicht mehr.</translation>
    </message>
    <message>
        <source>%1 has no known file extension: use one of %2.</source>
        <translation>%1 hat keine bekannte Dateiendung: Verwendbar sind %2.</translation>
    </message>
    <message>
        <source>%1: the format &quot;%2&quot; is not known; %3 can be used.</source>
        <translation>%1: Das Format „%2“ ist unbekannt; verwendbar sind %3.</translation>
    </message>
    <message>
        <source>%1 is Blender&apos;s own file, which only Blender reads as it is: save it as GLB there.</source>
        <translation>%1 ist eine Blender-Datei, die nur Blender richtig liest: Speichern Sie sie dort als GLB.</translation>
    </message>
    <message>
        <source>%1 is OpenGEX, which is not read: save it as GLB.</source>
        <translation>%1 ist OpenGEX, das nicht gelesen wird: Speichern Sie es als GLB.</translation>
    </message>
    <message>
        <source>%1 is X3D in its binary, packed or VRML encoding, which is not read: save it as XML (.x3d) or GLB.</source>
        <translation>%1 ist X3D in binärer, gepackter oder VRML-Kodierung, die nicht gelesen wird: Speichern Sie die Datei als XML (.x3d) oder GLB.</translation>
    </message>
    <message>
        <source>%1 was not read: unpacked it is larger than %2, which is too much for a file of its size.</source>
        <translation>%1 wurde nicht gelesen: Entpackt ist die Datei größer als %2, zu viel für eine Datei ihrer Größe.</translation>
    </message>
    <message>
        <source>The model has only %1 mm³: slicers may read it as inches.</source>
        <translation>Das Modell hat nur %1 mm³: Slicer könnten seine Maße als Zoll lesen.</translation>
    </message>
    <message>
        <source>The model has only %1 mm³: slicers may read it as metres.</source>
        <translation>Das Modell hat nur %1 mm³: Slicer könnten seine Maße als Meter lesen.</translation>
    </message>
    <message>
        <source>materials</source>
        <translation>Materialien</translation>
    </message>
    <message>
        <source>textures</source>
        <translation>Texturen</translation>
    </message>
    <message>
        <source>poses</source>
        <translation>Posen</translation>
    </message>
    <message>
        <source>left out: %1</source>
        <comment>materials, textures</comment>
        <translation>weggelassen: %1</translation>
    </message>
    <message>
        <source>, </source>
        <comment>between the parts of a model that are left out</comment>
        <translation>, </translation>
    </message>
    <message numerus="yes">
        <source>%n objects are one model now</source>
        <translation>
            <numerusform>aus %n Objekt wurde ein Modell</numerusform>
            <numerusform>aus %n Objekten wurde ein Modell</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 refers to &quot;%2&quot;, which is not in its folder; files elsewhere are not read.</source>
        <translation>%1 verweist auf „%2“, was nicht in seinem Ordner liegt; Dateien von anderswo werden nicht gelesen.</translation>
    </message>
    <message>
        <source>%1 was not written: %2 is only read; %3 can be written.</source>
        <translation>%1 wurde nicht geschrieben: %2 wird nur gelesen; geschrieben werden können %3.</translation>
    </message>
    <message>
        <source>%1 breaks the rules of the format %2; the importer does not say where.</source>
        <translation>%1 verletzt die Regeln des Formats %2; der Importer sagt nicht, wo.</translation>
    </message>
    <message>
        <source>%1 cannot be read; the importer says: &quot;%2&quot;.</source>
        <translation>%1 kann nicht gelesen werden; der Importer meldet: „%2“.</translation>
    </message>
    <message>
        <source>%1 was not read: the process that reads it ended unexpectedly.</source>
        <translation>%1 wurde nicht gelesen: Der Prozess, der die Datei liest, ist unerwartet abgebrochen.</translation>
    </message>
    <message>
        <source>%1 was not read: it took longer than the limit of %2 seconds for a file of its size.</source>
        <translation>%1 wurde nicht gelesen: Es dauerte länger als die %2 Sekunden, die für eine Datei dieser Größe erlaubt sind.</translation>
    </message>
    <message>
        <source>%1 was not read: it needs more memory than the limit of %2 for a file of its size.</source>
        <translation>%1 wurde nicht gelesen: Die Datei braucht mehr Speicher als die %2, die für eine Datei dieser Größe erlaubt sind.</translation>
    </message>
    <message>
        <source>%1: at that size the coordinates overflow.</source>
        <translation>%1: Bei dieser Größe laufen die Koordinaten über.</translation>
    </message>
    <message>
        <source>%1 cannot be a brush&apos;s shape, because its surface does not bound a solid (%2).</source>
        <translation>%1 kann keine Pinselform sein, weil seine Oberfläche keinen Körper umschließt (%2).</translation>
    </message>
    <message>
        <source>Nothing was added, because it would be inside the model.</source>
        <translation>Es wurde nichts hinzugefügt, weil es im Modell läge.</translation>
    </message>
    <message>
        <source>Nothing was added, because it would be too close to the surface.</source>
        <translation>Es wurde nichts hinzugefügt, weil es zu nahe an der Oberfläche wäre.</translation>
    </message>
    <message>
        <source>Nothing was added, because it would reach beyond the workspace.</source>
        <translation>Es wurde nichts hinzugefügt, weil es über den Arbeitsraum hinausreichen würde.</translation>
    </message>
    <message>
        <source>Nothing was added, because the brush&apos;s shape would intersect itself at that size.</source>
        <translation>Es wurde nichts hinzugefügt, weil sich die Pinselform in dieser Größe selbst durchdringen würde.</translation>
    </message>
    <message>
        <source>Nothing was added, because the mask protects the surface there.</source>
        <translation>Es wurde nichts hinzugefügt, weil die Maske die Oberfläche dort schützt.</translation>
    </message>
    <message>
        <source>The sectors meet here, or the model differs between them: they were changed one after the other and are not exact copies.</source>
        <translation>Die Sektoren treffen hier aufeinander, oder das Modell ist nicht in allen gleich: Sie wurden nacheinander geändert und sind keine genauen Kopien.</translation>
    </message>
    <message>
        <source>%1: class reports are written as HTML or PDF; the file extension decides which.</source>
        <translation>%1: Klassenberichte werden als HTML oder PDF geschrieben; die Endung bestimmt das Format.</translation>
    </message>
    <message>
        <source>%1: sheets are written as one PDF; the name has to end in .pdf.</source>
        <translation>%1: Blätter werden in ein PDF geschrieben; der Name muss auf .pdf enden.</translation>
    </message>
    <message>
        <source>%1: this folder cannot be read%2.</source>
        <translation>%1: Dieser Ordner ist nicht lesbar%2.</translation>
    </message>
    <message>
        <source>%1: this folder contains no models (%2).</source>
        <translation>%1: Dieser Ordner enthält keine Modelle (%2).</translation>
    </message>
    <message>
        <source>%1 is text in UTF-16, which is not read: save it as UTF-8.</source>
        <translation>%1 ist Text in UTF-16, das nicht gelesen wird: Speichern Sie die Datei als UTF-8.</translation>
    </message>
    <message>
        <source>corners that faces name twice (%1)</source>
        <translation>Ecken, die Flächen doppelt nennen (%1)</translation>
    </message>
    <message>
        <source>faces without three different corners (%1)</source>
        <translation>Flächen ohne drei verschiedene Ecken (%1)</translation>
    </message>
    <message>
        <source>values that its header does not announce</source>
        <translation>Werte, die der Dateikopf nicht ankündigt</translation>
    </message>
    <message>
        <source>data after the end of the model (%1)</source>
        <translation>Daten nach dem Ende des Modells (%1)</translation>
    </message>
    <message>
        <source>it announces %1 triangles and contains %2</source>
        <translation>sie kündigt %1 Dreiecke an und enthält %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot;</source>
        <comment>the name of a part</comment>
        <translation>„%1“</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <comment>names of parts</comment>
        <translation>%1 und noch %2</translation>
    </message>
    <message>
        <source>parts that a slicer would cut out of the model (%1)</source>
        <translation>Teile, die ein Slicer aus dem Modell herausschneiden würde (%1)</translation>
    </message>
    <message>
        <source>modifiers and supports of a slicer (%1)</source>
        <translation>Modifizierer und Stützen eines Slicers (%1)</translation>
    </message>
    <message>
        <source>further models in its package (%1)</source>
        <translation>weitere Modelle im selben Paket (%1)</translation>
    </message>
    <message>
        <source>the curvature of edges and triangles</source>
        <translation>die Krümmung von Kanten und Dreiecken</translation>
    </message>
    <message>
        <source>beams of a lattice (%1)</source>
        <translation>Stäbe eines Gitters (%1)</translation>
    </message>
    <message>
        <source>animations (%1)</source>
        <translation>Animationen (%1)</translation>
    </message>
    <message>
        <source>the subdivision of surfaces (%1)</source>
        <translation>die Unterteilung von Flächen (%1)</translation>
    </message>
    <message>
        <source>unsupported surfaces (%1)</source>
        <translation>Flächen, die nicht gelesen werden (%1)</translation>
    </message>
    <message>
        <source>objects that are hidden or not in the scene (%1)</source>
        <translation>Objekte, die ausgeblendet sind oder nicht zur Szene gehören (%1)</translation>
    </message>
</context>
<context>
    <name>ui::FileFaultMessages</name>
    <message>
        <source>a number above 0</source>
        <translation>eine Zahl über 0</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; changes the shape, but is not read: save the model without it.</source>
        <translation>%1: „%2“ ändert die Form und wird nicht gelesen: Speichern Sie das Modell ohne dies.</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; has faces, but no object with faces is connected to the scene.</source>
        <translation>%1: „%2“ hat Flächen, aber kein Objekt mit Flächen ist mit der Szene verbunden.</translation>
    </message>
    <message>
        <source>&quot;%1&quot;</source>
        <comment>a word of the format</comment>
        <translation>„%1“</translation>
    </message>
    <message>
        <source>%1: expected %2, found nothing.</source>
        <translation>%1: Hier wird %2 erwartet, aber es steht nichts da.</translation>
    </message>
    <message>
        <source>%1: expected %2, found &quot;%3&quot;.</source>
        <translation>%1: Hier wird %2 erwartet, aber es steht „%3“ da.</translation>
    </message>
    <message>
        <source>%1: the file breaks the rules of its format.</source>
        <translation>%1: Die Datei verletzt die Regeln ihres Formats.</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; breaks the rules of the file&apos;s format.</source>
        <translation>%1: „%2“ verletzt die Regeln des Dateiformats.</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>eine Zahl</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>eine ganze Zahl</translation>
    </message>
    <message>
        <source>a count that is not negative and fits here</source>
        <translation>eine Anzahl, die nicht negativ ist und hierher passt,</translation>
    </message>
    <message>
        <source>a vertex of 3 or 4 numbers, with 3 more for a colour or none</source>
        <translation>ein Eckpunkt aus 3 oder 4 Zahlen, mit 3 weiteren für eine Farbe oder ohne,</translation>
    </message>
    <message>
        <source>the number of a vertex</source>
        <translation>die Nummer eines Eckpunkts</translation>
    </message>
    <message>
        <source>ascii, binary_little_endian or binary_big_endian</source>
        <translation>ascii, binary_little_endian oder binary_big_endian</translation>
    </message>
    <message>
        <source>a type such as float or int</source>
        <translation>ein Typ wie float oder int</translation>
    </message>
    <message>
        <source>a type of whole numbers, such as uchar or int</source>
        <translation>ein Typ ganzer Zahlen, etwa uchar oder int,</translation>
    </message>
    <message>
        <source>a name</source>
        <translation>ein Name</translation>
    </message>
    <message>
        <source>an element before its first property</source>
        <translation>ein Element vor seiner ersten Eigenschaft</translation>
    </message>
    <message>
        <source>one of the units millimeter, micron, centimeter, inch, foot and meter</source>
        <translation>eine der Einheiten millimeter, micron, centimeter, inch, foot und meter</translation>
    </message>
    <message>
        <source>%1: the element &quot;%2&quot; has no properties x, y and z.</source>
        <translation>%1: Das Element „%2“ hat keine Eigenschaften x, y und z.</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is needed here, but is missing.</source>
        <translation>%1: „%2“ wird hier gebraucht, fehlt aber.</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; appears twice.</source>
        <translation>%1: „%2“ kommt zweimal vor.</translation>
    </message>
    <message>
        <source>%1: the JSON of the file is broken here.</source>
        <translation>%1: Das JSON der Datei ist hier fehlerhaft.</translation>
    </message>
    <message>
        <source>%1: a chunk with a JSON object is expected first, but another is there.</source>
        <translation>%1: Zuerst wird ein Abschnitt mit einem JSON-Objekt erwartet, aber da steht ein anderer.</translation>
    </message>
    <message>
        <source>%1: the data in &quot;%2&quot; is not packed as base64, which is expected there.</source>
        <translation>%1: Die Daten in „%2“ sind nicht als base64 gepackt, wie es dort erwartet wird.</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; should be a list, but is something else.</source>
        <translation>%1: „%2“ sollte eine Liste sein, ist aber etwas anderes.</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; should be a JSON object, but is something else or missing.</source>
        <translation>%1: „%2“ sollte ein JSON-Objekt sein, ist aber etwas anderes oder fehlt.</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; should be a whole number that is not negative, but is something else.</source>
        <translation>%1: „%2“ sollte eine ganze, nicht negative Zahl sein, ist aber etwas anderes.</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; should be a list of as many numbers as the format requires, but is something else.</source>
        <translation>%1: „%2“ sollte eine Liste von so vielen Zahlen sein, wie das Format verlangt, ist aber etwas anderes.</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; contains less data than should be read from it.</source>
        <translation>%1: „%2“ enthält weniger Daten, als daraus gelesen werden sollen.</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; has a type or a count that does not fit its use.</source>
        <translation>%1: „%2“ hat einen Typ oder eine Anzahl, die nicht zu seiner Verwendung passt.</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; contain themselves, or are nested too deeply.</source>
        <translation>%1: „%2“ enthalten sich selbst oder sind zu tief verschachtelt.</translation>
    </message>
    <message>
        <source>%1 needs the extension %2, which Fettle cannot read: save it without, in the program that made it.</source>
        <translation>%1 braucht die Erweiterung %2, die Fettle nicht lesen kann: Speichern Sie die Datei ohne sie, in dem Programm, das sie erstellt hat.</translation>
    </message>
    <message>
        <source>%1 is glTF of version %2; version 2.0 is read: save it as that.</source>
        <translation>%1 ist glTF der Version %2; gelesen wird Version 2.0: Speichern Sie die Datei als solche.</translation>
    </message>
    <message>
        <source>%1: the compressed data of &quot;%2&quot; ends too early.</source>
        <translation>%1: Die komprimierten Daten von „%2“ enden zu früh.</translation>
    </message>
    <message>
        <source>%1: the compressed data of &quot;%2&quot; is not packed as its extension says.</source>
        <translation>%1: Die komprimierten Daten von „%2“ sind nicht so gepackt, wie ihre Erweiterung es vorschreibt.</translation>
    </message>
    <message>
        <source>%1 is FBX of version %2; versions from 7.1 on are read: save it as FBX 7 or GLB.</source>
        <translation>%1 ist FBX der Version %2; gelesen wird ab Version 7.1: Speichern Sie die Datei als FBX 7 oder GLB.</translation>
    </message>
    <message>
        <source>%1 is IFC of the schema %2; IFC2X3 is read: save it as that or as GLB.</source>
        <translation>%1 nutzt IFC-Schema %2; gelesen wird IFC2X3: Speichern Sie die Datei so oder als GLB.</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; leads out of the package; nothing from elsewhere is read.</source>
        <translation>%1: „%2“ führt aus dem Paket hinaus; von anderswo wird nichts gelesen.</translation>
    </message>
    <message>
        <source>%1: the part &quot;%2&quot; is not in the package.</source>
        <translation>%1: Der Teil „%2“ ist nicht im Paket.</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; should say where in the package the model is, but does not.</source>
        <translation>%1: „%2“ sollte sagen, wo im Paket das Modell liegt, tut es aber nicht.</translation>
    </message>
    <message>
        <source>%1: the part &quot;%2&quot; is encrypted, or packed in a way that is not read.</source>
        <translation>%1: Der Teil „%2“ ist verschlüsselt oder auf eine Art gepackt, die nicht gelesen wird.</translation>
    </message>
    <message>
        <source>%1: the XML of the file is broken here: &quot;%2&quot;.</source>
        <translation>%1: Das XML der Datei ist hier fehlerhaft: „%2“.</translation>
    </message>
    <message>
        <source>%1: a document type is declared here, which models may not have.</source>
        <translation>%1: Hier wird ein Dokumenttyp deklariert, den Modelle nicht haben dürfen.</translation>
    </message>
    <message>
        <source>%1: XML elements are nested too deeply here.</source>
        <translation>%1: XML-Elemente sind hier zu tief verschachtelt.</translation>
    </message>
    <message>
        <source>%1: an XML tag is longer here than 1 MiB.</source>
        <translation>%1: Ein XML-Tag ist hier länger als 1 MiB.</translation>
    </message>
</context>
<context>
    <name>ui::ModelDialogs</name>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>X, to the right</source>
        <translation>X, nach rechts</translation>
    </message>
    <message>
        <source>Y, upwards</source>
        <translation>Y, nach oben</translation>
    </message>
    <message>
        <source>Z, to the front</source>
        <translation>Z, nach vorn</translation>
    </message>
    <message>
        <source>Scale the Model</source>
        <translation>Modell skalieren</translation>
    </message>
    <message>
        <source>New size of the model:</source>
        <translation>Neue Größe des Modells:</translation>
    </message>
    <message>
        <source>Longest side</source>
        <translation>Längste Seite</translation>
    </message>
    <message>
        <source>Factor</source>
        <translation>Faktor</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Skalieren</translation>
    </message>
    <message>
        <source>Mirror the Model</source>
        <translation>Modell spiegeln</translation>
    </message>
    <message>
        <source>Mirror across a plane through the origin:</source>
        <translation>An einer Ebene durch den Ursprung spiegeln:</translation>
    </message>
    <message>
        <source>Left and right (X)</source>
        <translation>Links und rechts (X)</translation>
    </message>
    <message>
        <source>Top and bottom (Y)</source>
        <translation>Oben und unten (Y)</translation>
    </message>
    <message>
        <source>Front and back (Z)</source>
        <translation>Vorn und hinten (Z)</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Spiegeln</translation>
    </message>
    <message>
        <source>Symmetrize the Model</source>
        <translation>Modell symmetrisieren</translation>
    </message>
    <message>
        <source>Mirror across a plane through the origin. Which half is kept?</source>
        <translation>An einer Ebene durch den Ursprung spiegeln. Welche Hälfte bleibt?</translation>
    </message>
    <message>
        <source>Right (X above 0)</source>
        <translation>Rechts (X über 0)</translation>
    </message>
    <message>
        <source>Left (X below 0)</source>
        <translation>Links (X unter 0)</translation>
    </message>
    <message>
        <source>Top (Y above 0)</source>
        <translation>Oben (Y über 0)</translation>
    </message>
    <message>
        <source>Bottom (Y below 0)</source>
        <translation>Unten (Y unter 0)</translation>
    </message>
    <message>
        <source>Front (Z above 0)</source>
        <translation>Vorn (Z über 0)</translation>
    </message>
    <message>
        <source>Back (Z below 0)</source>
        <translation>Hinten (Z unter 0)</translation>
    </message>
    <message>
        <source>Symmetrize</source>
        <translation>Symmetrisieren</translation>
    </message>
    <message>
        <source>Remesh Uniformly</source>
        <translation>Gleichmäßig neu vernetzen</translation>
    </message>
    <message>
        <source>Rebuild the mesh with triangles of about the same size. Maximum edge length:</source>
        <translation>Das Netz mit etwa gleich großen Dreiecken neu aufbauen. Längste Kante:</translation>
    </message>
    <message>
        <source>Longest edge</source>
        <translation>Längste Kante</translation>
    </message>
    <message>
        <source>Edges from %1 to %2 mm; about %3 triangles, currently %4.</source>
        <translation>Kanten von %1 bis %2 mm; etwa %3 Dreiecke, jetzt sind es %4.</translation>
    </message>
    <message>
        <source>Remesh</source>
        <translation>Neu vernetzen</translation>
    </message>
    <message>
        <source>Insert a Model</source>
        <translation>Modell einfügen</translation>
    </message>
    <message>
        <source>Beside the present model</source>
        <translation>Neben das vorhandene Modell</translation>
    </message>
    <message>
        <source>Where its file has it</source>
        <translation>Dorthin, wo es in seiner Datei liegt</translation>
    </message>
    <message>
        <source>With its middle at</source>
        <translation>Mit seiner Mitte bei</translation>
    </message>
    <message>
        <source>Insert</source>
        <translation>Einfügen</translation>
    </message>
    <message>
        <source>Flatten the Base</source>
        <translation>Unterseite ebnen</translation>
    </message>
    <message>
        <source>Cuts the bottom off level, so that the model stands. Height of the cut above the lowest point:</source>
        <translation>Schneidet das Modell unten waagrecht ab, sodass es steht. Höhe des Schnitts über dem tiefsten Punkt:</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Flatten</source>
        <translation>Ebnen</translation>
    </message>
    <message>
        <source>Original unit</source>
        <translation>Ursprüngliche Einheit</translation>
    </message>
    <message>
        <source>Millimetres</source>
        <translation>Millimeter</translation>
    </message>
    <message>
        <source>Centimetres</source>
        <translation>Zentimeter</translation>
    </message>
    <message>
        <source>Inches</source>
        <translation>Zoll</translation>
    </message>
    <message>
        <source>Metres</source>
        <translation>Meter</translation>
    </message>
    <message>
        <source>Its unit</source>
        <translation>Seine Einheit</translation>
    </message>
    <message>
        <source>As stated in the file, otherwise mm</source>
        <translation>Wie die Datei sagt, sonst Millimeter</translation>
    </message>
    <message>
        <source>Combine</source>
        <translation>Verknüpfen</translation>
    </message>
    <message>
        <source>Join</source>
        <translation>Vereinigen</translation>
    </message>
    <message>
        <source>Subtract</source>
        <translation>Abziehen</translation>
    </message>
    <message>
        <source>Intersect</source>
        <translation>Schnittmenge</translation>
    </message>
    <message>
        <source>%1: where does it go, and how is it combined with the present model?</source>
        <translation>%1: Wo soll es hin, und wie wird es mit dem vorhandenen Modell verknüpft?</translation>
    </message>
    <message>
        <source>As a part of its own</source>
        <translation>Als eigenes Teil</translation>
    </message>
    <message>
        <source>In the same part, without touching</source>
        <translation>Im selben Teil, ohne Berührung</translation>
    </message>
</context>
<context>
    <name>ui::ModelFiles</name>
    <message>
        <source>Unsaved changes</source>
        <translation>Nicht gespeicherte Änderungen</translation>
    </message>
    <message>
        <source>Open &amp;Recent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>&amp;Clear This List</source>
        <translation>Diese Liste &amp;leeren</translation>
    </message>
    <message>
        <source>The file was changed</source>
        <translation>Die Datei wurde geändert</translation>
    </message>
    <message>
        <source>Another program has changed %1 since it was read or written here.</source>
        <translation>Ein anderes Programm hat %1 geändert, seit die Datei hier gelesen oder geschrieben wurde.</translation>
    </message>
    <message>
        <source>&amp;Overwrite</source>
        <translation>Über&amp;schreiben</translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation>Speichern &amp;unter …</translation>
    </message>
    <message>
        <source>%1 was deleted or moved. Save to write it again.</source>
        <translation>%1 wurde gelöscht oder verschoben. Speichern schreibt die Datei neu.</translation>
    </message>
    <message>
        <source>%1 had been deleted or moved and was written again.</source>
        <translation>%1 war gelöscht oder verschoben und wurde neu geschrieben.</translation>
    </message>
    <message>
        <source>Saved %1. Only GLB files keep view, brush, symmetry and reference images: use Save As.</source>
        <translation>%1 wurde gespeichert. Nur GLB-Dateien behalten Ansicht, Pinsel, Symmetrie und Referenzbilder: Wählen Sie „Speichern unter“.</translation>
    </message>
    <message>
        <source>Save changes to %1?</source>
        <translation>Änderungen an %1 speichern?</translation>
    </message>
</context>
<context>
    <name>ui::FormatFilters</name>
    <message>
        <source>%1 and others</source>
        <translation>%1 und andere</translation>
    </message>
</context>
<context>
    <name>ui::ModelPanel</name>
    <message>
        <source>Vertices</source>
        <translation>Eckpunkte</translation>
    </message>
    <message>
        <source>Corners of the triangles.</source>
        <translation>Ecken der Dreiecke.</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Flächen</translation>
    </message>
    <message>
        <source>Triangles of the surface.</source>
        <translation>Dreiecke der Oberfläche.</translation>
    </message>
    <message>
        <source>Components</source>
        <translation>Teile</translation>
    </message>
    <message>
        <source>Parts of the surface that are not connected, including hollows.</source>
        <translation>Teile der Oberfläche, die nicht zusammenhängen, auch Hohlräume.</translation>
    </message>
    <message>
        <source>Genus</source>
        <translation>Genus</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Width, height and depth of the box around the model.</source>
        <translation>Breite, Höhe und Tiefe des Kastens um das Modell.</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Volume inside the surface.</source>
        <translation>Volumen innerhalb der Oberfläche.</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Oberfläche</translation>
    </message>
    <message>
        <source>Area of the whole surface.</source>
        <translation>Inhalt der ganzen Oberfläche.</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>Kanten</translation>
    </message>
    <message>
        <source>The shortest and the longest edge of a triangle.</source>
        <translation>Die kürzeste und die längste Kante eines Dreiecks.</translation>
    </message>
    <message>
        <source>%1 × %2 × %3 mm</source>
        <translation>%1 × %2 × %3 mm</translation>
    </message>
    <message>
        <source>%1 cm³</source>
        <translation>%1 cm³</translation>
    </message>
    <message>
        <source>%1 cm²</source>
        <translation>%1 cm²</translation>
    </message>
    <message>
        <source>%1 to %2 mm</source>
        <translation>%1 bis %2 mm</translation>
    </message>
    <message>
        <source>Watertight</source>
        <translation>Wasserdicht</translation>
    </message>
    <message>
        <source>Closed and free of self-intersections. Checked exactly.</source>
        <translation>Geschlossen und frei von Selbstdurchdringungen. Exakt geprüft.</translation>
    </message>
    <message>
        <source>Needs repair</source>
        <translation>Muss repariert werden</translation>
    </message>
    <message>
        <source>The surface is open, intersects itself or encloses no space.</source>
        <translation>Die Oberfläche ist offen, durchdringt sich selbst oder umschließt keinen Raum.</translation>
    </message>
    <message>
        <source>Not checked since the last change</source>
        <translation>Seit der letzten Änderung nicht geprüft</translation>
    </message>
    <message>
        <source>These values are from before the last change. They are updated when the model is idle.</source>
        <translation>Diese Werte sind von vor der letzten Änderung. Sie werden aktualisiert, sobald das Modell ruht.</translation>
    </message>
    <message>
        <source>Model</source>
        <comment>panel</comment>
        <translation>Modell</translation>
    </message>
    <message>
        <source>The number of handles or through holes: 0 for a ball, 1 for a ring or a cup.</source>
        <translation>Zahl der Henkel oder durchgehenden Löcher: 0 bei einer Kugel, 1 bei einem Ring oder einer Tasse.</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>The active part, whose values these are.</source>
        <translation>Das aktive Teil, dessen Werte dies sind.</translation>
    </message>
</context>
<context>
    <name>ui::PupilNamePanel</name>
    <message>
        <source>&amp;Begin</source>
        <translation>&amp;Anfangen</translation>
    </message>
    <message>
        <source>The next turn</source>
        <translation>Wer als Nächstes dran ist</translation>
    </message>
    <message>
        <source>Who is next?</source>
        <translation>Wer ist dran?</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Name or nickname</source>
        <translation>Name oder Spitzname</translation>
    </message>
    <message>
        <source>Starts the turn. (Return)</source>
        <translation>Beginnt den Durchgang. (Eingabetaste)</translation>
    </message>
    <message>
        <source>Pupils</source>
        <translation>Kinder</translation>
    </message>
    <message>
        <source>%1 ✓ has had a turn</source>
        <translation>%1 ✓ war schon dran</translation>
    </message>
    <message>
        <source>Lesson</source>
        <translation>Lektion</translation>
    </message>
</context>
<context>
    <name>ui::ParameterControl</name>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
</context>
<context>
    <name>ui::PartnerBar</name>
    <message>
        <source>Partner</source>
        <translation>Partner</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Time is up</source>
        <translation>Die Zeit ist um</translation>
    </message>
</context>
<context>
    <name>ui::PressureCurve</name>
    <message>
        <source>Pressure curve</source>
        <translation>Druckkurve</translation>
    </message>
    <message>
        <source>Effect of pen pressure: above the diagonal a light touch does much, below it little. Drag to bend the curve.</source>
        <translation>Wirkung des Stiftdrucks: Über der Diagonalen bewirkt eine leichte Berührung viel, darunter wenig. Ziehen Sie, um die Kurve zu biegen.</translation>
    </message>
</context>
<context>
    <name>ui::PressureTest</name>
    <message>
        <source>Pen test</source>
        <translation>Stifttest</translation>
    </message>
    <message>
        <source>Draw here: the line shows the effect of your pen&apos;s pressure.</source>
        <translation>Zeichnen Sie hier: Die Linie zeigt, wie der Druck Ihres Stifts wirkt.</translation>
    </message>
    <message>
        <source>Draw here with the pen or the mouse.</source>
        <translation>Zeichnen Sie hier mit Stift oder Maus.</translation>
    </message>
    <message>
        <source>Mouse: no pressure</source>
        <translation>Maus: kein Druck</translation>
    </message>
    <message>
        <source>Eraser: %1</source>
        <translation>Radierer: %1</translation>
    </message>
    <message>
        <source>Pen: %1</source>
        <translation>Stift: %1</translation>
    </message>
</context>
<context>
    <name>ui::PinDialog</name>
    <message>
        <source>Teacher&apos;s PIN</source>
        <translation>PIN der Lehrkraft</translation>
    </message>
    <message>
        <source>End &amp;Class</source>
        <translation>Klasse &amp;beenden</translation>
    </message>
    <message>
        <source>This is not the PIN.</source>
        <translation>Das ist nicht die PIN.</translation>
    </message>
    <message numerus="yes">
        <source>Too many wrong PINs. Try again in %n seconds.</source>
        <translation>
            <numerusform>Zu viele falsche PINs: Der nächste Versuch ist in %n Sekunde möglich.</numerusform>
            <numerusform>Zu viele falsche PINs: Der nächste Versuch ist in %n Sekunden möglich.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>&amp;Appearance</source>
        <translation>&amp;Aussehen</translation>
    </message>
    <message>
        <source>&amp;Reset to Defaults</source>
        <translation>Auf &amp;Vorgaben zurücksetzen</translation>
    </message>
    <message>
        <source>&amp;Colours</source>
        <translation>&amp;Farben</translation>
    </message>
    <message>
        <source>Chooses a light or a dark window, or follows the desktop.</source>
        <translation>Wählt ein helles oder dunkles Fenster oder folgt dem Desktop.</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Sprache</translation>
    </message>
    <message>
        <source>Chooses the language of the window&apos;s texts.</source>
        <translation>Wählt die Sprache der Texte im Fenster.</translation>
    </message>
    <message>
        <source>Same as the system</source>
        <translation>Wie das System</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>&amp;Input</source>
        <translation>&amp;Eingabe</translation>
    </message>
    <message>
        <source>Pen pressure controls &amp;strength</source>
        <translation>Stiftdruck bestimmt die &amp;Stärke</translation>
    </message>
    <message>
        <source>A light touch changes little, a firm touch much.</source>
        <translation>Eine leichte Berührung ändert wenig, eine feste viel.</translation>
    </message>
    <message>
        <source>Pen pressure controls ra&amp;dius</source>
        <translation>Stiftdruck bestimmt den &amp;Radius</translation>
    </message>
    <message>
        <source>A light touch makes a narrow stroke, a firm touch a wide one.</source>
        <translation>Eine leichte Berührung macht einen schmalen Strich, eine feste einen breiten.</translation>
    </message>
    <message>
        <source>Alt and &amp;mouse navigate</source>
        <translation>Alt und &amp;Maus bewegen die Ansicht</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>&amp;Tasten</translation>
    </message>
    <message>
        <source>Resets all settings of the program to their defaults, after a question.</source>
        <translation>Setzt nach einer Rückfrage alle Einstellungen des Programms auf ihre Vorgaben zurück.</translation>
    </message>
    <message>
        <source>Reset all settings to defaults?</source>
        <translation>Alle Einstellungen zurücksetzen?</translation>
    </message>
    <message>
        <source>This resets colours, language, keys, pen and mouse, brush, view and the layout of panels. Models, recent files and swatches stay. The language changes at the next start.</source>
        <translation>Zurückgesetzt werden Farben, Sprache, Tasten, Stift und Maus, Pinsel, Ansicht und die Anordnung der Bedienfelder. Modelle, zuletzt geöffnete Dateien und Farbfelder bleiben. Die Sprache ändert sich beim nächsten Start.</translation>
    </message>
    <message>
        <source>&amp;Reset</source>
        <translation>Zu&amp;rücksetzen</translation>
    </message>
    <message>
        <source>Hold Alt: left orbits, middle pans and right zooms, on the model too. The keys of ZBrush differ.</source>
        <translation>Mit gehaltener Alt-Taste dreht die linke Taste, verschiebt die mittlere und zoomt die rechte, auch auf dem Modell. Bei den Tasten von ZBrush ist es anders.</translation>
    </message>
    <message>
        <source>Pressure &amp;curve</source>
        <translation>Druck&amp;kurve</translation>
    </message>
    <message>
        <source>Pen test</source>
        <translation>Stifttest</translation>
    </message>
    <message>
        <source>&amp;Files</source>
        <translation>&amp;Dateien</translation>
    </message>
    <message>
        <source>Keep the last three &amp;versions of each saved file</source>
        <translation>Beim Speichern die letzten drei Ve&amp;rsionen der Datei behalten</translation>
    </message>
    <message>
        <source>Older versions stay beside the file, as vase.glb~1, vase.glb~2 and so on. Open them like any other file.</source>
        <translation>Ältere Versionen bleiben neben der Datei, als vase.glb~1, vase.glb~2 und so weiter. Sie lassen sich öffnen wie jede andere Datei.</translation>
    </message>
    <message>
        <source>Unsaved changes are always kept if Fettle ends unexpectedly. The next start offers to recover them.</source>
        <translation>Ungespeicherte Änderungen bleiben immer erhalten, wenn Fettle unerwartet endet. Der nächste Start bietet an, sie wiederherzustellen.</translation>
    </message>
    <message>
        <source>&amp;Text size</source>
        <translation>Schrift&amp;größe</translation>
    </message>
    <message>
        <source>Makes the window&apos;s text larger than the desktop&apos;s.</source>
        <translation>Macht den Text im Fenster größer als auf dem Desktop.</translation>
    </message>
    <message>
        <source>Restart Fettle to apply language and text size.</source>
        <translation>Sprache und Schriftgröße gelten ab dem nächsten Start.</translation>
    </message>
    <message>
        <source>Reduced moti&amp;on</source>
        <translation>Weniger &amp;Bewegung</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>The view jumps to its place instead of flying there, and the ring around a place that is pointed at stands still.</source>
        <translation>Die Ansicht springt ans Ziel, statt hinzufliegen, und der Ring um eine Stelle, auf die gezeigt wird, steht still.</translation>
    </message>
    <message>
        <source>Open the &amp;objects of a file as parts</source>
        <translation>&amp;Objekte einer Datei als Teile öffnen</translation>
    </message>
    <message>
        <source>Makes a part of each object of a 3MF, OBJ, glTF or AMF file. Otherwise all objects become one part.</source>
        <translation>Macht aus jedem Objekt einer 3MF-, OBJ-, glTF- oder AMF-Datei ein Teil. Sonst wird aus allen Objekten ein Teil.</translation>
    </message>
</context>
<context>
    <name>ui::PreviewPanel</name>
    <message>
        <source>2D Preview</source>
        <translation>2D-Vorschau</translation>
    </message>
    <message>
        <source>Drawing of the model</source>
        <translation>Zeichnung des Modells</translation>
    </message>
    <message>
        <source>Sides</source>
        <translation>Seiten</translation>
    </message>
    <message>
        <source>Shows all three drawings, or one of them larger.</source>
        <translation>Zeigt alle drei Zeichnungen oder eine davon größer.</translation>
    </message>
    <message>
        <source>All sides</source>
        <translation>Alle Seiten</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Vorn</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>Drawn as</source>
        <translation>Gezeichnet als</translation>
    </message>
    <message>
        <source>Shows the lines only, or colours under them.</source>
        <translation>Zeigt nur die Linien oder Farben darunter.</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>Linien</translation>
    </message>
    <message>
        <source>Shaded</source>
        <translation>Schattiert</translation>
    </message>
    <message>
        <source>Dimensions</source>
        <translation>Maße</translation>
    </message>
    <message>
        <source>Shows the model&apos;s dimensions beside it.</source>
        <translation>Schreibt die Maße des Modells daneben.</translation>
    </message>
    <message>
        <source>Fit (0)</source>
        <translation>Einpassen (0)</translation>
    </message>
    <message>
        <source>Shows the whole drawing; the wheel zooms, a drag moves it.</source>
        <translation>Zeigt die ganze Zeichnung; das Rad zoomt, Ziehen verschiebt.</translation>
    </message>
    <message>
        <source>Coarser while you sculpt; the fine drawing follows.</source>
        <translation>Gröber, während Sie formen; die feine Zeichnung folgt.</translation>
    </message>
    <message>
        <source>Creases are left out: the surface has too many.</source>
        <translation>Knickkanten fehlen: Die Oberfläche hat zu viele.</translation>
    </message>
</context>
<context>
    <name>ui::PrintFindings</name>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>Watertight surface</source>
        <translation>Wasserdichte Oberfläche</translation>
    </message>
    <message>
        <source>Closed, all faces outwards, no self-intersections. Checked exactly.</source>
        <translation>Geschlossen, alle Flächen nach außen gerichtet, keine Selbstdurchdringungen. Exakt geprüft.</translation>
    </message>
    <message>
        <source>The surface needs repair</source>
        <translation>Die Oberfläche muss repariert werden</translation>
    </message>
    <message>
        <source>It is open, intersects itself or encloses no space; walls were not measured.</source>
        <translation>Sie ist offen, durchdringt sich selbst oder umschließt keinen Raum; Wände wurden nicht gemessen.</translation>
    </message>
    <message numerus="yes">
        <source>%Ln parts</source>
        <translation>
            <numerusform>%Ln Teil</numerusform>
            <numerusform>%Ln Teile</numerusform>
        </translation>
    </message>
    <message>
        <source>Separate parts of the surface; closed hollows count as parts.</source>
        <translation>Getrennte Teile der Oberfläche; geschlossene Hohlräume zählen mit.</translation>
    </message>
    <message>
        <source>%1 mm wide, %2 mm deep, %3 mm high.</source>
        <translation>%1 × %2 × %3 mm breit, tief und hoch.</translation>
    </message>
    <message>
        <source>Fits %1</source>
        <translation>Passt auf %1</translation>
    </message>
    <message>
        <source>Fits %1, turned by 90°</source>
        <translation>Passt auf %1, um 90° gedreht</translation>
    </message>
    <message>
        <source>Too large for %1</source>
        <translation>Zu groß für %1</translation>
    </message>
    <message>
        <source>Shares are of the surface. The thinnest place: %1 mm.</source>
        <translation>Anteile beziehen sich auf die Oberfläche. Die dünnste Stelle: %1 mm.</translation>
    </message>
    <message>
        <source>Walls from %1 mm on</source>
        <translation>Wände ab %1 mm</translation>
    </message>
    <message>
        <source>No thin walls</source>
        <translation>Keine dünnen Wände</translation>
    </message>
    <message>
        <source>%1 thinner than %2 mm</source>
        <translation>%1 dünner als %2 mm</translation>
    </message>
    <message>
        <source>Only specks thinner than %1 mm</source>
        <translation>Nur winzige Stellen unter %1 mm</translation>
    </message>
    <message>
        <source>%1 mm²</source>
        <translation>%1 mm²</translation>
    </message>
    <message>
        <source>%1 mm, %2</source>
        <comment>thickness, area</comment>
        <translation>%1 mm, %2</translation>
    </message>
    <message>
        <source>Faces that lean out more than %1 from the vertical print on supports only; those on the bed do not count.</source>
        <translation>Flächen, die sich mehr als %1 aus der Senkrechten neigen, brauchen Stützen; solche auf dem Druckbett zählen nicht.</translation>
    </message>
    <message>
        <source>No overhangs beyond %1</source>
        <translation>Keine Überhänge über %1</translation>
    </message>
    <message>
        <source>%1 overhangs beyond %2</source>
        <translation>%1 Überhang über %2</translation>
    </message>
    <message>
        <source>up to %1, %2</source>
        <translation>bis %1, %2</translation>
    </message>
    <message>
        <source>Area of the surface that is flat on the bed.</source>
        <translation>Fläche, die flach auf dem Druckbett liegt.</translation>
    </message>
    <message>
        <source>Stands on %1</source>
        <translation>Steht auf %1</translation>
    </message>
    <message>
        <source>Rests on a point or an edge</source>
        <translation>Steht auf einer Spitze oder Kante</translation>
    </message>
    <message>
        <source>Scale the model, or choose millimetres in the slicer.</source>
        <translation>Skalieren Sie das Modell, oder wählen Sie im Slicer Millimeter.</translation>
    </message>
    <message>
        <source>Overlapping parts checked as one</source>
        <translation>Überschneidende Teile als eines geprüft</translation>
    </message>
    <message>
        <source>The visible parts overlap. They were united for the check, as exporting for print unites them.</source>
        <translation>Die sichtbaren Teile überschneiden sich. Sie wurden für die Prüfung vereinigt, wie der Export zum Drucken sie vereinigt.</translation>
    </message>
    <message>
        <source>Overlapping parts cannot be united</source>
        <translation>Teile lassen sich nicht vereinigen</translation>
    </message>
    <message>
        <source>Each part was checked alone. Move one a little; otherwise the export will not unite them, either.</source>
        <translation>Jedes Teil wurde einzeln geprüft. Verschieben Sie eines ein wenig, sonst kann auch der Export sie nicht vereinigen.</translation>
    </message>
</context>
<context>
    <name>ui::PrintLegend</name>
    <message>
        <source>Colours on the model</source>
        <translation>Farben am Modell</translation>
    </message>
    <message>
        <source>The meaning of the colours on the model. Hatched places are beyond the limit.</source>
        <translation>Was die Farben am Modell bedeuten. Schraffierte Stellen überschreiten die Grenze.</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>thick</source>
        <translation>dick</translation>
    </message>
</context>
<context>
    <name>ui::PrintPanel</name>
    <message>
        <source>Printers…</source>
        <translation>Drucker …</translation>
    </message>
    <message>
        <source>Edits the list of printers.</source>
        <translation>Bearbeitet die Liste der Drucker.</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Wandstärke</translation>
    </message>
    <message>
        <source>Overhang</source>
        <translation>Überhang</translation>
    </message>
    <message>
        <source>Printer</source>
        <translation>Drucker</translation>
    </message>
    <message>
        <source>The printer to check against.</source>
        <translation>Der Drucker, für den geprüft wird.</translation>
    </message>
    <message>
        <source>Minimum wall</source>
        <translation>Mindestwand</translation>
    </message>
    <message>
        <source>Finds thinner walls. Two lines of the nozzle are usual.</source>
        <translation>Findet dünnere Wände. Üblich sind zwei Linien der Düse.</translation>
    </message>
    <message>
        <source>Steepest overhang that prints without support, from the vertical.</source>
        <translation>Stärkster Überhang, der sich ohne Stützen drucken lässt, aus der Senkrechten gemessen.</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>Colours the model by wall thickness or by overhang.</source>
        <translation>Färbt das Modell nach Wandstärke oder Überhang.</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Befunde</translation>
    </message>
    <message>
        <source>The findings. Click a place, or press Return, to see it on the model.</source>
        <translation>Die Befunde. Klicken Sie auf eine Stelle, oder drücken Sie die Eingabetaste, um sie am Modell zu sehen.</translation>
    </message>
    <message>
        <source>good</source>
        <translation>gut</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>Vorsicht</translation>
    </message>
    <message>
        <source>to fix</source>
        <translation>zu beheben</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Check Now</source>
        <translation>Jetzt prüfen</translation>
    </message>
    <message>
        <source>Ends the check.</source>
        <translation>Bricht die Prüfung ab.</translation>
    </message>
    <message>
        <source>Checks the model as it is now.</source>
        <translation>Prüft das Modell, wie es jetzt ist.</translation>
    </message>
    <message>
        <source>Ready to print</source>
        <translation>Druckfertig</translation>
    </message>
    <message>
        <source>Printable, with warnings</source>
        <translation>Druckbar, mit Warnungen</translation>
    </message>
    <message>
        <source>Fix before printing</source>
        <translation>Vor dem Druck beheben</translation>
    </message>
    <message>
        <source>Checking…</source>
        <translation>Wird geprüft …</translation>
    </message>
    <message>
        <source>Not checked since the last change</source>
        <translation>Seit der letzten Änderung nicht geprüft</translation>
    </message>
    <message>
        <source>Print Check</source>
        <translation>Druckprüfung</translation>
    </message>
</context>
<context>
    <name>ui::PrintersDialog</name>
    <message>
        <source>Printers</source>
        <translation>Drucker</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>&amp;Add</source>
        <translation>&amp;Hinzufügen</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Entfernen</translation>
    </message>
    <message>
        <source>Another printer</source>
        <translation>Weiterer Drucker</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
</context>
<context>
    <name>ui::Questionnaire</name>
    <message>
        <source>How easy was it to learn to use the program?</source>
        <translation>Wie leicht war es, das Programm bedienen zu lernen?</translation>
    </message>
    <message>
        <source>extremely difficult</source>
        <translation>äußerst schwer</translation>
    </message>
    <message>
        <source>extremely easy</source>
        <translation>äußerst leicht</translation>
    </message>
    <message>
        <source>Was everything there that you needed?</source>
        <translation>War alles da, was du gebraucht hast?</translation>
    </message>
    <message>
        <source>incomplete</source>
        <translation>unvollständig</translation>
    </message>
    <message>
        <source>complete</source>
        <translation>vollständig</translation>
    </message>
    <message>
        <source>How often did something go wrong while you sculpted?</source>
        <translation>Wie oft ging beim Formen etwas schief?</translation>
    </message>
    <message>
        <source>extremely often</source>
        <translation>äußerst oft</translation>
    </message>
    <message>
        <source>extremely rarely</source>
        <translation>äußerst selten</translation>
    </message>
    <message>
        <source>How convenient was it to make details?</source>
        <translation>Wie bequem ließen sich Details machen?</translation>
    </message>
    <message>
        <source>very inconvenient</source>
        <translation>sehr unbequem</translation>
    </message>
    <message>
        <source>very convenient</source>
        <translation>sehr bequem</translation>
    </message>
    <message>
        <source>How freely could you make holes and handles, and join parts?</source>
        <translation>Wie frei konntest du Löcher und Henkel machen und Teile verbinden?</translation>
    </message>
    <message>
        <source>not freely at all</source>
        <translation>gar nicht frei</translation>
    </message>
    <message>
        <source>completely freely</source>
        <translation>völlig frei</translation>
    </message>
    <message>
        <source>How do you find the program as a whole?</source>
        <translation>Wie findest du das Programm insgesamt?</translation>
    </message>
    <message>
        <source>poor</source>
        <translation>schlecht</translation>
    </message>
    <message>
        <source>good</source>
        <translation>gut</translation>
    </message>
</context>
<context>
    <name>ui::QuestionnairePanel</name>
    <message>
        <source>D&amp;one</source>
        <translation>Ferti&amp;g</translation>
    </message>
    <message>
        <source>Questions after the turn</source>
        <translation>Fragen am Ende</translation>
    </message>
    <message>
        <source>Six questions about the program. Answer what you like: press a number; press it again to clear it.</source>
        <translation>Sechs Fragen zum Programm. Beantworte, was du magst: Drücke eine Zahl; drücke sie noch einmal, um sie zu löschen.</translation>
    </message>
    <message>
        <source>S&amp;kip</source>
        <translation>Übers&amp;pringen</translation>
    </message>
    <message>
        <source>Continues without answers; nothing is saved.</source>
        <translation>Geht ohne Antworten weiter; es wird nichts gespeichert.</translation>
    </message>
    <message>
        <source>Saves the answers with the work, and continues.</source>
        <translation>Speichert die Antworten mit der Arbeit und geht weiter.</translation>
    </message>
    <message>
        <source>How was it, %1?</source>
        <translation>Wie war es, %1?</translation>
    </message>
</context>
<context>
    <name>ui::RecoveryBar</name>
    <message>
        <source>Unsaved Model</source>
        <translation>Ungespeichertes Modell</translation>
    </message>
    <message>
        <source>Unsaved changes to %1 can be recovered: %2, %3.</source>
        <translation>Ungespeicherte Änderungen an %1 lassen sich wiederherstellen: %2, %3.</translation>
    </message>
    <message numerus="yes">
        <source>%Ln steps</source>
        <translation>
            <numerusform>%Ln Schritt</numerusform>
            <numerusform>%Ln Schritte</numerusform>
        </translation>
    </message>
    <message>
        <source>Rec&amp;over</source>
        <translation>&amp;Wiederherstellen</translation>
    </message>
    <message>
        <source>Opens the model as it was, with its history.</source>
        <translation>Öffnet das Modell, wie es war, samt Verlauf.</translation>
    </message>
    <message>
        <source>&amp;Discard…</source>
        <translation>&amp;Verwerfen …</translation>
    </message>
    <message>
        <source>Deletes these changes, after a question.</source>
        <translation>Löscht diese Änderungen nach einer Rückfrage.</translation>
    </message>
    <message>
        <source>&amp;Later</source>
        <translation>S&amp;päter</translation>
    </message>
    <message>
        <source>Hides this bar; the next start offers it again.</source>
        <translation>Blendet diese Leiste aus; der nächste Start bietet es wieder an.</translation>
    </message>
    <message>
        <source>Fettle</source>
        <translation>Fettle</translation>
    </message>
    <message>
        <source>Permanently delete the unsaved changes to %1?</source>
        <translation>Die ungespeicherten Änderungen an %1 endgültig löschen?</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Entfernen</translation>
    </message>
</context>
<context>
    <name>ui::ReferencePanel</name>
    <message>
        <source>Image</source>
        <translation>Referenz</translation>
    </message>
    <message>
        <source>In front of the model</source>
        <translation>Vor dem Modell</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>The side that shows the image. Choosing another side turns the view to it.</source>
        <translation>Die Seite, auf der das Bild erscheint. Eine andere zu wählen dreht die Ansicht dorthin.</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>How wide the image is, measured beside the model.</source>
        <translation>Breite des Bildes, am Modell gemessen.</translation>
    </message>
    <message>
        <source>To the right</source>
        <translation>Nach rechts</translation>
    </message>
    <message>
        <source>How far the image&apos;s middle is to the right of the origin.</source>
        <translation>Wie weit die Bildmitte rechts vom Ursprung liegt.</translation>
    </message>
    <message>
        <source>Upwards</source>
        <translation>Nach oben</translation>
    </message>
    <message>
        <source>How far the image&apos;s middle is above the origin in this view.</source>
        <translation>Wie weit die Bildmitte in dieser Ansicht über dem Ursprung liegt.</translation>
    </message>
    <message>
        <source>Draws the image over the model instead of behind it, so that both can be compared.</source>
        <translation>Zeichnet das Bild vor das Modell statt dahinter, um beide zu vergleichen.</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Opacity of the image.</source>
        <translation>Deckkraft des Bildes.</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Vorn</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Hinten</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Unten</translation>
    </message>
    <message>
        <source>%1, with an image</source>
        <translation>%1, mit Bild</translation>
    </message>
    <message>
        <source>No image</source>
        <translation>Kein Bild</translation>
    </message>
    <message>
        <source>Choose an image, or drop its file on the window.</source>
        <translation>Wählen Sie ein Bild, oder ziehen Sie seine Datei auf das Fenster.</translation>
    </message>
</context>
<context>
    <name>ui::RevealFile</name>
    <message>
        <source>No file manager was found; the file is in %1.</source>
        <translation>Es wurde keine Dateiverwaltung gefunden; die Datei liegt in %1.</translation>
    </message>
</context>
<context>
    <name>ui::ScaleBar</name>
    <message>
        <source>Scale: %L1 mm</source>
        <translation>Maßstab: %L1 mm</translation>
    </message>
    <message>
        <source>%L1 mm</source>
        <translation>%L1 mm</translation>
    </message>
</context>
<context>
    <name>ui::Scene</name>
    <message>
        <source>The model cannot be shown: this display offers no OpenGL.</source>
        <translation>Das Modell lässt sich nicht anzeigen: Diese Anzeige bietet kein OpenGL.</translation>
    </message>
    <message>
        <source>The model cannot be shown: OpenGL does not start on this display.</source>
        <translation>Das Modell lässt sich nicht anzeigen: OpenGL startet auf dieser Anzeige nicht.</translation>
    </message>
    <message>
        <source>The model cannot be shown: OpenGL 3.3 is needed, and this display offers %1.%2 (%3). Update the graphics driver, or install Mesa&apos;s software driver, llvmpipe.</source>
        <extracomment>%1.%2: a version; %3: the name of the OpenGL driver</extracomment>
        <translation>Das Modell lässt sich nicht anzeigen: Nötig ist OpenGL 3.3, diese Anzeige bietet %1.%2 (%3). Aktualisieren Sie den Grafiktreiber, oder installieren Sie den Softwaretreiber von Mesa, llvmpipe.</translation>
    </message>
</context>
<context>
    <name>ui::ShapeChoosers</name>
    <message>
        <source>Pores</source>
        <translation>Poren</translation>
    </message>
    <message>
        <source>Scales</source>
        <translation>Schuppen</translation>
    </message>
    <message>
        <source>Cracks</source>
        <translation>Risse</translation>
    </message>
    <message>
        <source>Weave</source>
        <translation>Geflecht</translation>
    </message>
    <message>
        <source>Stripes</source>
        <translation>Streifen</translation>
    </message>
    <message>
        <source>Noise</source>
        <translation>Rauschen</translation>
    </message>
    <message>
        <source>Ring</source>
        <translation>Ring</translation>
    </message>
    <message>
        <source>Star</source>
        <translation>Stern</translation>
    </message>
    <message>
        <source>Alpha</source>
        <translation>Alpha</translation>
    </message>
    <message>
        <source>An image that weights the brush: white is full strength, black is none. A spacing of 2 places prints side by side.</source>
        <translation>Ein Bild, das den Pinsel gewichtet: Weiß ist volle Stärke, Schwarz keine. Ein Abstand von 2 setzt Abdrücke nebeneinander.</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keines</translation>
    </message>
    <message>
        <source>Load Image…</source>
        <translation>Bild laden …</translation>
    </message>
    <message>
        <source>Stamp</source>
        <translation>Stempel</translation>
    </message>
    <message>
        <source>The model that Stamp presses in or raises, with its top outwards, and that Add Ball adds.</source>
        <translation>Das Modell, das „Stempel“ eindrückt oder heraushebt, mit der Oberseite nach außen, und das „Kugel hinzufügen“ setzt.</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>Load Model…</source>
        <translation>Modell laden …</translation>
    </message>
    <message>
        <source>This Model</source>
        <translation>Dieses Modell</translation>
    </message>
    <message>
        <source>The model that you sculpt, as it is now.</source>
        <translation>Das Modell, das Sie formen, wie es jetzt ist.</translation>
    </message>
</context>
<context>
    <name>ui::SideColumn</name>
    <message>
        <source>Panels</source>
        <translation>Bedienfelder</translation>
    </message>
</context>
<context>
    <name>ui::SidePanel</name>
    <message>
        <source>Folds or unfolds this panel. With Ctrl it stays open alone.</source>
        <translation>Klappt dieses Bedienfeld zu oder auf. Mit Strg bleibt es allein offen.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Hides this panel. View › Panels brings it back.</source>
        <translation>Blendet dieses Bedienfeld aus. Ansicht › Bedienfelder bringt es zurück.</translation>
    </message>
    <message>
        <source>open</source>
        <translation>offen</translation>
    </message>
    <message>
        <source>folded</source>
        <translation>zugeklappt</translation>
    </message>
</context>
<context>
    <name>ui::SimulatorView</name>
    <message>
        <source>VR starts…</source>
        <translation>VR startet …</translation>
    </message>
    <message>
        <source>%1 cm before the surface</source>
        <extracomment>%1: a number</extracomment>
        <translation>%1 cm vor der Oberfläche</translation>
    </message>
    <message>
        <source>%1 cm behind the surface</source>
        <translation>%1 cm hinter der Oberfläche</translation>
    </message>
</context>
<context>
    <name>ui::SimulatorWindow</name>
    <message>
        <source>Mouse</source>
        <translation>Maus</translation>
    </message>
    <message>
        <source>moves the controller on the surface</source>
        <translation>bewegt den Controller auf der Oberfläche</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Mausrad</translation>
    </message>
    <message>
        <source>farther and nearer</source>
        <translation>weiter weg und näher</translation>
    </message>
    <message>
        <source>Shift and wheel</source>
        <translation>Umschalt und Mausrad</translation>
    </message>
    <message>
        <source>turns the controller about its own axis</source>
        <translation>dreht den Controller um seine Achse</translation>
    </message>
    <message>
        <source>Left button, Space</source>
        <translation>Linke Taste, Leertaste</translation>
    </message>
    <message>
        <source>trigger; with Shift half as strong</source>
        <translation>Abzug; mit Umschalt halb so stark</translation>
    </message>
    <message>
        <source>Tab</source>
        <translation>Tab</translation>
    </message>
    <message>
        <source>the other controller</source>
        <translation>der andere Controller</translation>
    </message>
    <message>
        <source>Arrows</source>
        <translation>Pfeiltasten</translation>
    </message>
    <message>
        <source>press the pad at that side</source>
        <translation>drücken das Touchpad an dieser Seite</translation>
    </message>
    <message>
        <source>Ctrl and mouse</source>
        <translation>Strg und Maus</translation>
    </message>
    <message>
        <source>the thumb slides on the pad</source>
        <translation>der Daumen gleitet auf dem Touchpad</translation>
    </message>
    <message>
        <source>M</source>
        <translation>M</translation>
    </message>
    <message>
        <source>menu button</source>
        <translation>Menütaste</translation>
    </message>
    <message>
        <source>G</source>
        <translation>G</translation>
    </message>
    <message>
        <source>squeezes the controller</source>
        <translation>drückt die Seitentaste</translation>
    </message>
    <message>
        <source>B</source>
        <translation>B</translation>
    </message>
    <message>
        <source>squeezes both controllers</source>
        <translation>drückt beide Seitentasten</translation>
    </message>
    <message>
        <source>Right button</source>
        <translation>Rechte Taste</translation>
    </message>
    <message>
        <source>looks around</source>
        <translation>sieht sich um</translation>
    </message>
    <message>
        <source>W A S D</source>
        <translation>W A S D</translation>
    </message>
    <message>
        <source>walk</source>
        <translation>gehen</translation>
    </message>
    <message>
        <source>E, Q</source>
        <translation>E, Q</translation>
    </message>
    <message>
        <source>up and down</source>
        <translation>nach oben und unten</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>leaves VR</source>
        <translation>verlässt VR</translation>
    </message>
    <message>
        <source>VR Simulator</source>
        <translation>VR-Simulator</translation>
    </message>
    <message>
        <source>What the headset shows</source>
        <translation>Was die VR-Brille zeigt</translation>
    </message>
    <message>
        <source>The mouse moves the left controller.</source>
        <translation>Die Maus bewegt den linken Controller.</translation>
    </message>
    <message>
        <source>The mouse moves the right controller.</source>
        <translation>Die Maus bewegt den rechten Controller.</translation>
    </message>
</context>
<context>
    <name>ui::StartPage</name>
    <message>
        <source>Start page</source>
        <translation>Startseite</translation>
    </message>
    <message>
        <source>Begin with</source>
        <translation>Beginnen mit</translation>
    </message>
    <message>
        <source>Recent files</source>
        <translation>Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>Three short lessons</source>
        <translation>Drei kurze Lektionen</translation>
    </message>
    <message>
        <source>What will you make?</source>
        <translation>Was soll es werden?</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Starts with the ball of clay. (Esc)</source>
        <translation>Beginnt mit der Tonkugel. (Esc)</translation>
    </message>
    <message>
        <source>Opens a model that was open before.</source>
        <translation>Öffnet ein früher geöffnetes Modell.</translation>
    </message>
    <message>
        <source>&amp;Show this page at start</source>
        <translation>Diese Seite beim Start &amp;zeigen</translation>
    </message>
    <message>
        <source>Otherwise Fettle starts with a ball of clay; Help › Start Page brings this page back.</source>
        <translation>Sonst beginnt Fettle mit einer Tonkugel; Hilfe › Startseite bringt diese Seite zurück.</translation>
    </message>
</context>
<context>
    <name>ui::StrokeEditBar</name>
    <message>
        <source>Edit Last Stroke</source>
        <translation>Letzten Strich ändern</translation>
    </message>
    <message>
        <source>Last stroke:</source>
        <translation>Letzter Strich:</translation>
    </message>
    <message>
        <source>Tool of the last stroke</source>
        <translation>Werkzeug des letzten Strichs</translation>
    </message>
    <message>
        <source>Changes the tool of the stroke.</source>
        <translation>Ändert das Werkzeug des Strichs.</translation>
    </message>
    <message>
        <source>&amp;Keep</source>
        <translation>&amp;Behalten</translation>
    </message>
    <message>
        <source>Leaves the stroke as it is now, and hides this bar.</source>
        <translation>Lässt den Strich, wie er jetzt ist, und blendet diese Leiste aus.</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Abbrechen</translation>
    </message>
    <message>
        <source>Restores the stroke as it was, and hides this bar.</source>
        <translation>Stellt den Strich wieder her, wie er war, und blendet diese Leiste aus.</translation>
    </message>
</context>
<context>
    <name>ui::Synonyms</name>
    <message>
        <source>add, raise, build, extrude, bump</source>
        <translation>aufbauen, erhöhen, hinzufügen, Beule</translation>
    </message>
    <message>
        <source>carve, dig, dent, hole, sink</source>
        <translation>schnitzen, graben, Delle, Loch, eindrücken</translation>
    </message>
    <message>
        <source>swell, blow up, fatten</source>
        <translation>aufpusten, dicker</translation>
    </message>
    <message>
        <source>build up, fill, strips</source>
        <translation>aufbauen, füllen, Streifen</translation>
    </message>
    <message>
        <source>plane, level</source>
        <translation>eben, hobeln</translation>
    </message>
    <message>
        <source>plane, polish, shave</source>
        <translation>hobeln, polieren, abziehen</translation>
    </message>
    <message>
        <source>blur, relax, soften, even</source>
        <translation>weich, glatt, ausgleichen</translation>
    </message>
    <message>
        <source>squeeze, sharpen, gather</source>
        <translation>zusammenziehen, schärfen</translation>
    </message>
    <message>
        <source>move, drag, pull out</source>
        <translation>bewegen, verschieben, ziehen</translation>
    </message>
    <message>
        <source>horn, tail, tentacle, handle</source>
        <translation>Horn, Schwanz, Arm, Henkel</translation>
    </message>
    <message>
        <source>rotate, turn, screw</source>
        <translation>drehen, Schraube</translation>
    </message>
    <message>
        <source>imprint, pattern, hollow</source>
        <translation>Abdruck, Muster, aushöhlen</translation>
    </message>
    <message>
        <source>color, colour, draw</source>
        <translation>Farbe, anmalen, einfärben</translation>
    </message>
    <message>
        <source>protect, freeze, lock</source>
        <translation>schützen, einfrieren, sperren</translation>
    </message>
    <message>
        <source>eraser, unfreeze, unlock</source>
        <translation>Radiergummi, auftauen, entsperren</translation>
    </message>
    <message>
        <source>size, bigger, wider, thicker</source>
        <translation>Größe, breiter, dicker</translation>
    </message>
    <message>
        <source>size, thinner, finer</source>
        <translation>Größe, dünner, feiner</translation>
    </message>
    <message>
        <source>size, bigger, diameter</source>
        <translation>Größe, größer, Durchmesser</translation>
    </message>
    <message>
        <source>power, intensity, pressure</source>
        <translation>Kraft, Druck, Intensität</translation>
    </message>
    <message>
        <source>opposite, subtract, eraser</source>
        <translation>umgekehrt, abziehen, Radiergummi</translation>
    </message>
    <message>
        <source>sphere, primitive, eye</source>
        <translation>hinzufügen, Auge, Grundform</translation>
    </message>
    <message>
        <source>brushes, library</source>
        <translation>Pinsel, Bibliothek</translation>
    </message>
    <message>
        <source>lazy, stabilizer, tremor</source>
        <translation>ruhig, zittern, Stabilisator</translation>
    </message>
    <message>
        <source>pottery, lathe, wheel, spin</source>
        <translation>töpfern, drechseln, kreisen</translation>
    </message>
    <message>
        <source>mirror, both sides, half</source>
        <translation>spiegeln, beide Seiten, Hälfte</translation>
    </message>
    <message>
        <source>join, merge, union, boolean</source>
        <translation>verbinden, vereinigen, verschmelzen</translation>
    </message>
    <message>
        <source>remesh, voxel, even</source>
        <translation>gleichmäßig, neu vernetzen</translation>
    </message>
    <message>
        <source>back, mistake, eraser</source>
        <translation>zurück, Fehler, Radiergummi</translation>
    </message>
    <message>
        <source>adjust, change, correct</source>
        <translation>ändern, anpassen, korrigieren</translation>
    </message>
    <message>
        <source>settings, options, language, dark, pen, pressure, tablet</source>
        <translation>Optionen, Sprache, dunkel, Stift, Stiftdruck</translation>
    </message>
    <message>
        <source>size, bigger, smaller, resize, unit</source>
        <translation>Größe, größer, kleiner, Einheit</translation>
    </message>
    <message>
        <source>flip, reflect</source>
        <translation>umdrehen, spiegelverkehrt</translation>
    </message>
    <message>
        <source>voxel, resolution, subdivide, triangles</source>
        <translation>Auflösung, unterteilen, Dreiecke</translation>
    </message>
    <message>
        <source>cut, bottom, stand, trim</source>
        <translation>schneiden, Boden, stehen</translation>
    </message>
    <message>
        <source>watertight, thickness, overhang, hollow, support</source>
        <translation>wasserdicht, dick, Überhang, hohl, Stütze</translation>
    </message>
    <message>
        <source>stl, slicer, reduce, decimate</source>
        <translation>Slicer, verkleinern, vereinfachen</translation>
    </message>
    <message>
        <source>video, film, animation</source>
        <translation>Video, Animation</translation>
    </message>
    <message>
        <source>zoom, fit, center, lost</source>
        <translation>zoomen, einpassen, zentrieren, verloren</translation>
    </message>
    <message>
        <source>mesh, polygons, edges</source>
        <translation>Netz, Polygone, Kanten</translation>
    </message>
    <message>
        <source>parallel, isometric</source>
        <translation>parallel, isometrisch</translation>
    </message>
    <message>
        <source>VR, headset, goggles, vive</source>
        <translation>VR, Brille, Headset</translation>
    </message>
    <message>
        <source>manual, documentation</source>
        <translation>Handbuch, Hilfe</translation>
    </message>
    <message>
        <source>tutorial, course, learn</source>
        <translation>Kurs, lernen, üben</translation>
    </message>
    <message>
        <source>recover, restore, reload</source>
        <translation>wiederherstellen, neu laden</translation>
    </message>
    <message>
        <source>shadow, contrast, relief</source>
        <translation>Schatten, Kontrast</translation>
    </message>
    <message>
        <source>bright, daylight</source>
        <translation>Licht, Tageslicht</translation>
    </message>
    <message>
        <source>line, groove, wrinkle</source>
        <translation>Rille, Linie, Falte</translation>
    </message>
    <message>
        <source>cut, slice, crop, scissors, knife, trim</source>
        <translation>schneiden, Schere, Messer, beschneiden, stutzen</translation>
    </message>
    <message>
        <source>boolean, union, difference, merge, combine</source>
        <translation>Boolesch, Vereinigung, Differenz, verbinden, verknüpfen</translation>
    </message>
    <message>
        <source>cut, slice, divide, knife, lasso</source>
        <translation>schneiden, teilen, zerlegen, Messer, Lasso</translation>
    </message>
    <message>
        <source>lasso, select, box, polygon</source>
        <translation>Lasso, auswählen, Rechteck, Vieleck</translation>
    </message>
    <message>
        <source>boolean, hole, drill, cube, sphere, lathe</source>
        <translation>boolesch, Loch, bohren, Würfel, Kugel, drehen</translation>
    </message>
    <message>
        <source>primitive, cube, sphere, cylinder, drag out</source>
        <translation>Grundkörper, Würfel, Kugel, Zylinder, aufziehen</translation>
    </message>
    <message>
        <source>pipe, rope, tail, arm, horn, spline</source>
        <translation>Röhre, Seil, Schwanz, Arm, Horn, Spline</translation>
    </message>
</context>
<context>
    <name>ui::ThumbnailMaker</name>
    <message>
        <source>%1: there is not enough memory for its picture.</source>
        <translation>%1: Für das Bild reicht der Speicher nicht.</translation>
    </message>
</context>
<context>
    <name>ui::TimeLapseDialog</name>
    <message>
        <source>Export Time-Lapse</source>
        <translation>Zeitraffer exportieren</translation>
    </message>
    <message>
        <source>Draws the model after each step, from the current view, as numbered PNG files in a folder that you choose. Sculpting is paused while it runs.</source>
        <translation>Zeichnet das Modell nach jedem Schritt, aus der aktuellen Ansicht, als nummerierte PNG-Dateien in einen Ordner Ihrer Wahl. Solange ist das Formen angehalten.</translation>
    </message>
    <message>
        <source>%1 × %2 pixels</source>
        <translation>%1 × %2 Pixel</translation>
    </message>
    <message>
        <source>&amp;Size:</source>
        <translation>&amp;Größe:</translation>
    </message>
    <message>
        <source>Steps per &amp;picture:</source>
        <translation>&amp;Schritte je Bild:</translation>
    </message>
    <message>
        <source>&amp;Choose Folder…</source>
        <translation>Ordner &amp;wählen …</translation>
    </message>
    <message numerus="yes">
        <source>%Ln pictures</source>
        <translation>
            <numerusform>%Ln Bild</numerusform>
            <numerusform>%Ln Bilder</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::Timeline</name>
    <message>
        <source>Timeline</source>
        <translation>Zeitleiste</translation>
    </message>
    <message>
        <source>Drag to see the model after each step; Left and Right move by one. Sculpting there removes the later steps.</source>
        <translation>Ziehen Sie, um das Modell nach jedem Schritt zu sehen; Links und Rechts gehen um einen weiter. Wer dort formt, entfernt die späteren Schritte.</translation>
    </message>
    <message>
        <source>Play the steps</source>
        <translation>Schritte abspielen</translation>
    </message>
    <message>
        <source>Plays the steps in order, from here or from the first.</source>
        <translation>Spielt die Schritte der Reihe nach ab, von hier oder vom ersten an.</translation>
    </message>
    <message>
        <source>%1 of %2: %3</source>
        <comment>step, steps, its name</comment>
        <translation>%1 von %2: %3</translation>
    </message>
</context>
<context>
    <name>ui::ToolPalette</name>
    <message>
        <source>Tool Palette</source>
        <translation>Werkzeugpalette</translation>
    </message>
</context>
<context>
    <name>ui::TurnCountdown</name>
    <message>
        <source>Time is up</source>
        <translation>Die Zeit ist um</translation>
    </message>
</context>
<context>
    <name>ui::TurntablePanel</name>
    <message>
        <source>The model turns</source>
        <translation>Das Modell dreht sich</translation>
    </message>
    <message>
        <source>Turns the model under your hand. Hold still to cut a groove all around (T).</source>
        <translation>Dreht das Modell unter Ihrer Hand. Halten Sie still, um ringsum eine Rille zu schneiden (T).</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Direction of the turn, seen from above.</source>
        <translation>Drehrichtung, von oben gesehen.</translation>
    </message>
    <message>
        <source>Anticlockwise</source>
        <translation>Gegen den Uhrzeigersinn</translation>
    </message>
    <message>
        <source>Clockwise</source>
        <translation>Im Uhrzeigersinn</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>Speed in degrees per second; 360 are one turn.</source>
        <translation>Tempo in Grad pro Sekunde; 360 sind eine Umdrehung.</translation>
    </message>
    <message>
        <source> °/s</source>
        <translation> °/s</translation>
    </message>
    <message>
        <source>Turntable</source>
        <translation>Drehscheibe</translation>
    </message>
</context>
<context>
    <name>ui::UnitBar</name>
    <message>
        <source>%1 is %2 units long. Is it in metres (%3 mm)?</source>
        <translation>%1 ist %2 Einheiten lang. Sind es Meter (%3 mm)?</translation>
    </message>
    <message>
        <source>As Me&amp;tres</source>
        <translation>Als Me&amp;ter</translation>
    </message>
    <message>
        <source>Makes the model 1000 times as large, as one step.</source>
        <translation>Vergrößert das Modell auf das 1000-Fache, in einem Schritt.</translation>
    </message>
    <message>
        <source>%1 is %2 units long. Is it in inches (%3 mm)?</source>
        <translation>%1 ist %2 Einheiten lang. Sind es Zoll (%3 mm)?</translation>
    </message>
    <message>
        <source>As I&amp;nches</source>
        <translation>Als Z&amp;oll</translation>
    </message>
    <message>
        <source>Makes the model 25.4 times as large, as one step.</source>
        <translation>Vergrößert das Modell auf das 25,4-Fache, in einem Schritt.</translation>
    </message>
    <message>
        <source>As &amp;Centimetres</source>
        <translation>Als Ze&amp;ntimeter</translation>
    </message>
    <message>
        <source>Makes the model 10 times as large, as one step.</source>
        <translation>Vergrößert das Modell auf das 10-Fache, in einem Schritt.</translation>
    </message>
    <message>
        <source>Unit of the Model</source>
        <translation>Einheit des Modells</translation>
    </message>
    <message>
        <source>Le&amp;ave as mm</source>
        <translation>M&amp;illimeter behalten</translation>
    </message>
    <message>
        <source>Leaves the model as it is, and hides this bar.</source>
        <translation>Lässt das Modell, wie es ist, und blendet diese Leiste aus.</translation>
    </message>
</context>
<context>
    <name>ui::Viewport</name>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>The model cannot be shown: the graphics driver lacks a feature that it claims to have.</source>
        <translation>Das Modell lässt sich nicht anzeigen: Dem Grafiktreiber fehlt eine Funktion, die er zu haben angibt.</translation>
    </message>
</context>
<context>
    <name>ui::WaitingWorksDialog</name>
    <message>
        <source>Models on This Computer</source>
        <translation>Arbeiten auf diesem Rechner</translation>
    </message>
    <message numerus="yes">
        <source>%n models are not yet in the class folder.</source>
        <translation>
            <numerusform>%n Modell ist noch nicht im Ordner der Klasse.</numerusform>
            <numerusform>%n Modelle sind noch nicht im Ordner der Klasse.</numerusform>
        </translation>
    </message>
    <message>
        <source>They are safe in %1 and go to the class folder when this class begins on this computer again. You can copy them now, to a USB drive for example.</source>
        <translation>Sie liegen sicher in %1 und kommen in den Ordner der Klasse, wenn diese Klasse auf diesem Rechner wieder beginnt. Sie können sie jetzt kopieren, zum Beispiel auf einen USB-Stick.</translation>
    </message>
    <message>
        <source>&amp;Copy to a Folder…</source>
        <translation>In einen Ordner &amp;kopieren …</translation>
    </message>
    <message>
        <source>&amp;End Class</source>
        <translation>Klasse &amp;beenden</translation>
    </message>
</context>
<context>
    <name>ui::WaitingWorksNote</name>
    <message>
        <source>Mo&amp;ve to a Folder…</source>
        <translation>In einen Ordner &amp;verschieben …</translation>
    </message>
    <message>
        <source>Moves each waiting model, in its own folder, to the folder that you choose.</source>
        <translation>Verschiebt jedes wartende Modell, in seinem eigenen Ordner, in den Ordner, den Sie wählen.</translation>
    </message>
</context>
<context>
    <name>vr::Actions</name>
    <message>
        <source>Hand</source>
        <translation>Hand</translation>
    </message>
    <message>
        <source>Pointing</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Trigger</source>
        <translation>Abzug</translation>
    </message>
    <message>
        <source>Pad</source>
        <translation>Touchpad</translation>
    </message>
    <message>
        <source>Pad touched</source>
        <translation>Touchpad berührt</translation>
    </message>
    <message>
        <source>Pad pressed</source>
        <translation>Touchpad gedrückt</translation>
    </message>
    <message>
        <source>Side button</source>
        <translation>Seitentaste</translation>
    </message>
    <message>
        <source>Menu button</source>
        <translation>Menütaste</translation>
    </message>
    <message>
        <source>Buzz</source>
        <translation>Vibration</translation>
    </message>
    <message>
        <source>Pinch</source>
        <translation>Fingergriff</translation>
    </message>
    <message>
        <source>Sculpting</source>
        <translation>Formen</translation>
    </message>
</context>
<context>
    <name>vr::ColorPanel</name>
    <message>
        <source>Red</source>
        <translation>Rot</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>Grün</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>Blau</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
</context>
<context>
    <name>vr::FilesPanel</name>
    <message>
        <source>One moment…</source>
        <translation>Einen Moment …</translation>
    </message>
    <message>
        <source>The model has unsaved changes: save it first, or hold to open.</source>
        <translation>Das Modell hat ungespeicherte Änderungen: zuerst speichern oder zum Öffnen halten.</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <extracomment>%1: names of files</extracomment>
        <translation>Gespeichert: %1</translation>
    </message>
    <message>
        <source>There are no models here yet. Save adds the first one.</source>
        <translation>Hier sind noch keine Modelle. Speichern legt das erste an.</translation>
    </message>
    <message>
        <source>%1 / %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>Hold to open</source>
        <translation>Zum Öffnen halten</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Dateien</translation>
    </message>
</context>
<context>
    <name>vr::HeadsetReport</name>
    <message>
        <source>VR starts. Put on the headset.</source>
        <translation>VR startet. Bitte die VR-Brille aufsetzen.</translation>
    </message>
    <message>
        <source>VR is on, but the headset shows another program.</source>
        <translation>VR läuft, aber die VR-Brille zeigt ein anderes Programm.</translation>
    </message>
    <message>
        <source>The headset&apos;s own menu is open: the controllers are paused here.</source>
        <translation>Das Menü der VR-Brille ist offen: Die Controller sind hier angehalten.</translation>
    </message>
    <message>
        <source>In VR with %1.</source>
        <extracomment>%1: a headset&apos;s name</extracomment>
        <translation>In VR mit %1.</translation>
    </message>
    <message>
        <source>The headset is not worn. Put it on to continue.</source>
        <translation>Die VR-Brille ist abgesetzt. Setzen Sie sie auf, um weiterzumachen.</translation>
    </message>
    <message>
        <source>Left VR.</source>
        <translation>VR verlassen.</translation>
    </message>
    <message>
        <source>VR was ended in the headset&apos;s own program.</source>
        <translation>VR wurde im Programm der VR-Brille beendet.</translation>
    </message>
    <message>
        <source>The headset&apos;s program does not support the window system “%1”. Start Fettle with QT_QPA_PLATFORM=xcb and QT_XCB_GL_INTEGRATION=xcb_glx, then enter VR again.</source>
        <extracomment>%1: a window system, such as wayland</extracomment>
        <translation>Das Programm der VR-Brille unterstützt Fenster der Art „%1“ nicht. Bitte Fettle mit QT_QPA_PLATFORM=xcb und QT_XCB_GL_INTEGRATION=xcb_glx starten und VR erneut betreten.</translation>
    </message>
    <message>
        <source>VR cannot be drawn with this OpenGL.</source>
        <translation>VR lässt sich mit diesem OpenGL nicht zeichnen.</translation>
    </message>
    <message>
        <source>The headset&apos;s program has stopped. The model is as it was; when the program runs again, enter VR again.</source>
        <translation>Das Programm der VR-Brille läuft nicht mehr. Das Modell ist, wie es war; sobald das Programm wieder läuft, VR erneut betreten.</translation>
    </message>
    <message>
        <source>The headset is gone. The model is as it was; plug the headset in, then enter VR again.</source>
        <translation>Die VR-Brille ist nicht mehr da. Das Modell ist, wie es war; bitte die VR-Brille anschließen und VR erneut betreten.</translation>
    </message>
    <message>
        <source>The headset&apos;s program does not answer. The model is as it was; restart that program, then enter VR again.</source>
        <translation>Das Programm der VR-Brille antwortet nicht. Das Modell ist, wie es war; bitte das Programm der VR-Brille neu starten und VR erneut betreten.</translation>
    </message>
    <message>
        <source>The headset&apos;s program still does not answer, and VR cannot be entered. Restart that program; if that does not help, save the model and restart Fettle.</source>
        <translation>Das Programm der VR-Brille antwortet noch immer nicht, und VR lässt sich nicht betreten. Bitte das Programm der VR-Brille neu starten; hilft das nicht, das Modell speichern und Fettle neu starten.</translation>
    </message>
    <message>
        <source>VR ended: the headset&apos;s program reports a fault (%1). The model is as it was; try to enter VR again.</source>
        <extracomment>%1: a call of OpenXR and its result, such as xrCreateSession: XR_ERROR_RUNTIME_FAILURE</extracomment>
        <translation>VR ist beendet: Das Programm der VR-Brille meldet einen Fehler (%1). Das Modell ist, wie es war; bitte VR erneut betreten.</translation>
    </message>
</context>
<context>
    <name>vr::LessonPanel</name>
    <message>
        <source>%1 / %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Show Me</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Try It</source>
        <translation>Versuchen</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>%1: step %2 of %3</source>
        <extracomment>%1: a lesson&apos;s name; %2 of %3: its step</extracomment>
        <translation>%1: Schritt %2 von %3</translation>
    </message>
</context>
<context>
    <name>vr::ActiveRuntime</name>
    <message>
        <source>No OpenXR runtime is set up on this computer (%1). Install SteamVR, Monado or the headset&apos;s own program, make it the active OpenXR runtime there, then ask again.</source>
        <extracomment>%1: a name from OpenXR, such as XR_ERROR_RUNTIME_UNAVAILABLE</extracomment>
        <translation>Auf diesem Computer ist keine OpenXR-Laufzeitumgebung eingerichtet (%1). Bitte SteamVR, Monado oder das Programm der VR-Brille installieren, dort zur aktiven OpenXR-Laufzeitumgebung machen und erneut suchen.</translation>
    </message>
    <message>
        <source>Make SteamVR, Monado or the headset&apos;s own program the active OpenXR runtime again, then ask again.</source>
        <translation>Bitte SteamVR, Monado oder das Programm der VR-Brille wieder zur aktiven OpenXR-Laufzeitumgebung machen und erneut suchen.</translation>
    </message>
    <message>
        <source>The file of the active OpenXR runtime, %1, is missing or cannot be read (%2).</source>
        <extracomment>%1: a file&apos;s path; %2: a name from OpenXR</extracomment>
        <translation>Die Datei der aktiven OpenXR-Laufzeitumgebung, %1, fehlt oder ist nicht lesbar (%2).</translation>
    </message>
    <message>
        <source>The file of the active OpenXR runtime, %1, names no runtime (%2).</source>
        <extracomment>%1: a file&apos;s path; %2: a name from OpenXR</extracomment>
        <translation>Die Datei der aktiven OpenXR-Laufzeitumgebung, %1, nennt keine Laufzeitumgebung (%2).</translation>
    </message>
    <message>
        <source>The active OpenXR runtime is not where its file %1 says: there is no %3 (%2).</source>
        <extracomment>%1: a file&apos;s path; %2: a name from OpenXR; %3: the path of a program library</extracomment>
        <translation>Die aktive OpenXR-Laufzeitumgebung ist nicht dort, wo ihre Datei %1 sie angibt: %3 gibt es nicht (%2).</translation>
    </message>
</context>
<context>
    <name>vr::OpenXrRuntime</name>
    <message>
        <source>The OpenXR runtime needs OpenXR 1.1, which this computer&apos;s OpenXR loader does not know (%1). Install a newer loader, or choose another runtime.</source>
        <extracomment>%1: a name from OpenXR, such as XR_ERROR_API_VERSION_UNSUPPORTED</extracomment>
        <translation>Die OpenXR-Laufzeitumgebung braucht OpenXR 1.1, das der OpenXR-Loader dieses Computers nicht kennt (%1). Bitte einen neueren Loader installieren oder eine andere Laufzeitumgebung wählen.</translation>
    </message>
    <message>
        <source>No OpenXR runtime answers (%1). Start SteamVR, Monado or the headset&apos;s own program, then ask again.</source>
        <extracomment>%1: a name from OpenXR, such as XR_ERROR_RUNTIME_UNAVAILABLE</extracomment>
        <translation>Es antwortet keine OpenXR-Laufzeitumgebung (%1). Bitte SteamVR, Monado oder das Programm der VR-Brille starten und erneut suchen.</translation>
    </message>
    <message>
        <source>%1 is running, but no headset is ready (%2). Plug it in and switch it on, then ask again.</source>
        <translation>%1 läuft, aber keine VR-Brille ist bereit (%2). Bitte anschließen, einschalten und erneut suchen.</translation>
    </message>
    <message>
        <source>%1 supports %2, but it does not support OpenGL.</source>
        <translation>%1 unterstützt %2, aber kein OpenGL.</translation>
    </message>
    <message>
        <source>%1 is ready, through %2.</source>
        <translation>%1 ist bereit, über %2.</translation>
    </message>
    <message>
        <source>The headset is in use here.</source>
        <translation>Die VR-Brille wird hier bereits verwendet.</translation>
    </message>
    <message>
        <source>%1 asks for OpenGL %2 and refuses OpenGL %3, which Fettle uses. Another OpenXR runtime may accept it.</source>
        <extracomment>%1: the headset&apos;s program; %2, %3: versions, such as 4.5</extracomment>
        <translation>%1 verlangt OpenGL %2 und lehnt OpenGL %3 ab, das Fettle verwendet. Eine andere OpenXR-Laufzeitumgebung akzeptiert es vielleicht.</translation>
    </message>
</context>
<context>
    <name>vr::PerformancePanel</name>
    <message>
        <source>Events</source>
        <translation>Ereignisse</translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation>Warten</translation>
    </message>
    <message>
        <source>Input</source>
        <translation>Eingabe</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>Images</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Drawing</source>
        <translation>Zeichnen</translation>
    </message>
    <message>
        <source>Handing over</source>
        <translation>Übergabe</translation>
    </message>
    <message>
        <source>Without draw calls</source>
        <translation>Ohne Zeichenaufrufe</translation>
    </message>
    <message>
        <source>Draw calls</source>
        <translation>Zeichenaufrufe</translation>
    </message>
    <message>
        <source>Dropped frames</source>
        <translation>Ausgefallene Bilder</translation>
    </message>
    <message>
        <source>%1 fps</source>
        <extracomment>%1: how many frames a second</extracomment>
        <translation>%1 fps</translation>
    </message>
    <message>
        <source>CPU, ms</source>
        <translation>CPU, ms</translation>
    </message>
</context>
<context>
    <name>vr::Presets</name>
    <message>
        <source>Turn clockwise</source>
        <translation>Rechtsherum drehen</translation>
    </message>
    <message>
        <source>Turn anticlockwise</source>
        <translation>Linksherum drehen</translation>
    </message>
    <message>
        <source>Uniform or not</source>
        <translation>Gleichmäßig oder nicht</translation>
    </message>
    <message>
        <source>Slide: scale</source>
        <translation>Wischen: Größe</translation>
    </message>
    <message>
        <source>Press, push: scale</source>
        <translation>Drücken, schieben: Größe</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>Previous tool</source>
        <translation>Voriges Werkzeug</translation>
    </message>
    <message>
        <source>Next tool</source>
        <translation>Nächstes Werkzeug</translation>
    </message>
    <message>
        <source>Move model</source>
        <translation>Modell bewegen</translation>
    </message>
    <message>
        <source>Hold: save</source>
        <translation>Halten: speichern</translation>
    </message>
    <message>
        <source>Sphere or ray</source>
        <translation>Kugel oder Strahl</translation>
    </message>
    <message>
        <source>Symmetry</source>
        <translation>Symmetrie</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Slide: radius</source>
        <translation>Wischen: Radius</translation>
    </message>
    <message>
        <source>Press, push: radius</source>
        <translation>Drücken, schieben: Radius</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Previous channel</source>
        <translation>Voriger Kanal</translation>
    </message>
    <message>
        <source>Next channel</source>
        <translation>Nächster Kanal</translation>
    </message>
    <message>
        <source>Slide: value</source>
        <translation>Wischen: Wert</translation>
    </message>
    <message>
        <source>Press, push: value</source>
        <translation>Drücken, schieben: Wert</translation>
    </message>
    <message>
        <source>Sculpt</source>
        <translation>Formen</translation>
    </message>
    <message>
        <source>Hold: restore</source>
        <translation>Halten: zurücksetzen</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Glätten</translation>
    </message>
    <message>
        <source>Hold: invert</source>
        <translation>Halten: umkehren</translation>
    </message>
    <message>
        <source>Invert</source>
        <translation>Umkehren</translation>
    </message>
    <message>
        <source>Hold: colour</source>
        <translation>Halten: Farbe</translation>
    </message>
    <message>
        <source>Choose part</source>
        <translation>Teil wählen</translation>
    </message>
    <message>
        <source>Move part</source>
        <translation>Teil bewegen</translation>
    </message>
    <message>
        <source>Pinch: smooth</source>
        <translation>Fingergriff: glätten</translation>
    </message>
    <message>
        <source>Fist: move model</source>
        <translation>Faust: bewegen</translation>
    </message>
    <message>
        <source>Palm: tools</source>
        <translation>Handfläche: Werkzeuge</translation>
    </message>
    <message>
        <source>Pinch: sculpt</source>
        <translation>Fingergriff: formen</translation>
    </message>
    <message>
        <source>Palm: colour</source>
        <translation>Handfläche: Farbe</translation>
    </message>
    <message>
        <source>Place shape</source>
        <translation>Form setzen</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Schneiden</translation>
    </message>
    <message>
        <source>Draw tube</source>
        <translation>Rohr zeichnen</translation>
    </message>
</context>
<context>
    <name>vr::SettingsPanel</name>
    <message>
        <source>First contact</source>
        <translation>Erste Berührung</translation>
    </message>
    <message>
        <source>Sculpting</source>
        <translation>Formen</translation>
    </message>
    <message>
        <source>Surfaces join</source>
        <translation>Verschmelzen</translation>
    </message>
    <message>
        <source>Refusal</source>
        <translation>Ablehnung</translation>
    </message>
    <message>
        <source>Menus</source>
        <translation>Menüs</translation>
    </message>
    <message>
        <source>Holding a button</source>
        <translation>Taste halten</translation>
    </message>
    <message>
        <source>Buttons</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>Paper</translation>
    </message>
    <message>
        <source>Studio</source>
        <translation>Studio</translation>
    </message>
    <message>
        <source>Sculpting hand</source>
        <translation>Arbeitshand</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>On</source>
        <translation>An</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Aus</translation>
    </message>
    <message>
        <source>Floor grid</source>
        <translation>Bodengitter</translation>
    </message>
    <message>
        <source>Real room</source>
        <translation>Echter Raum</translation>
    </message>
    <message>
        <source>Not on this headset</source>
        <translation>Nicht verfügbar</translation>
    </message>
    <message>
        <source>Performance</source>
        <translation>Leistung</translation>
    </message>
    <message>
        <source>%1 cm</source>
        <extracomment>%1: a number, perhaps with a sign</extracomment>
        <translation>%1 cm</translation>
    </message>
    <message>
        <source>Raise model</source>
        <translation>Modell höher</translation>
    </message>
    <message>
        <source>%1°/s</source>
        <extracomment>%1: degrees a second</extracomment>
        <translation>%1°/s</translation>
    </message>
    <message>
        <source>Turning speed</source>
        <translation>Drehtempo</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>General</source>
        <translation>Allgemein</translation>
    </message>
    <message>
        <source>Vibration</source>
        <translation>Vibration</translation>
    </message>
    <message>
        <source>One hand</source>
        <translation>Einhand</translation>
    </message>
</context>
<context>
    <name>vr::ToolPanel</name>
    <message>
        <source>Pull</source>
        <translation>Ziehen</translation>
    </message>
    <message>
        <source>Push</source>
        <translation>Drücken</translation>
    </message>
    <message>
        <source>Flatten</source>
        <translation>Abflachen</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Glätten</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>Bemalen</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Dateien</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Recentre</source>
        <translation>Zentrieren</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Aufrichten</translation>
    </message>
    <message>
        <source>Add ball</source>
        <translation>Neue Kugel</translation>
    </message>
    <message>
        <source>Hold to restore</source>
        <translation>Zum Zurücksetzen halten</translation>
    </message>
    <message>
        <source>Leave VR</source>
        <translation>VR verlassen</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>Pinsel</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>Ray</source>
        <translation>Strahl</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <extracomment>%1: a radius in the room</extracomment>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Topology</source>
        <translation>Netz</translation>
    </message>
    <message>
        <source>Refine</source>
        <translation>Verfeinern</translation>
    </message>
    <message>
        <source>Adaptive</source>
        <translation>Adaptiv</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Belassen</translation>
    </message>
    <message>
        <source>Uniform</source>
        <translation>Gleichmäßig</translation>
    </message>
    <message>
        <source>Symmetry</source>
        <translation>Symmetrie</translation>
    </message>
    <message>
        <source>On</source>
        <translation>An</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Aus</translation>
    </message>
    <message>
        <source>Inflate</source>
        <translation>Aufblähen</translation>
    </message>
    <message>
        <source>Clay</source>
        <translation>Auftragen</translation>
    </message>
    <message>
        <source>Layer</source>
        <translation>Schichten</translation>
    </message>
    <message>
        <source>Scrape</source>
        <translation>Schaben</translation>
    </message>
    <message>
        <source>Pinch</source>
        <translation>Kneifen</translation>
    </message>
    <message>
        <source>Crease</source>
        <translation>Kerben</translation>
    </message>
    <message>
        <source>Grab</source>
        <translation>Greifen</translation>
    </message>
    <message>
        <source>Snake Hook</source>
        <translation>Tentakel</translation>
    </message>
    <message>
        <source>Twist</source>
        <translation>Verdrehen</translation>
    </message>
    <message>
        <source>Inverted</source>
        <translation>Umgekehrt</translation>
    </message>
    <message>
        <source>Mask</source>
        <translation>Maske</translation>
    </message>
    <message>
        <source>Stamp</source>
        <translation>Stempel</translation>
    </message>
    <message>
        <source>Radial</source>
        <translation>Radial</translation>
    </message>
    <message>
        <source>Invert</source>
        <translation>Umkehren</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Teile</translation>
    </message>
</context>
<context>
    <name>app::BrushCommand</name>
    <message>
        <source>%1: tool %2, strength %3, falloff %4, spacing %5</source>
        <translation>%1: Werkzeug %2, Stärke %3, Abnahme %4, Abstand %5</translation>
    </message>
    <message>
        <source>, alpha %1</source>
        <translation>, Alpha %1</translation>
    </message>
    <message>
        <source>%1: this picture cannot be written.</source>
        <translation>%1: Dieses Bild kann nicht geschrieben werden.</translation>
    </message>
    <message>
        <source>Shows what a brush preset contains, or why it is invalid (status 2). Without a preset: lists the program&apos;s presets.</source>
        <translation>Zeigt, was eine Pinselvorlage enthält oder warum sie ungültig ist (Status 2). Ohne Vorlage: listet die mitgelieferten auf.</translation>
    </message>
    <message>
        <source>A preset file, or the name of a preset of the program.</source>
        <translation>Eine Vorlagendatei oder der Name einer mitgelieferten Vorlage.</translation>
    </message>
    <message>
        <source>File for a picture of one stroke of the brush, PNG.</source>
        <translation>Datei für ein Bild von einem Strich des Pinsels, PNG.</translation>
    </message>
    <message>
        <source>brush: one preset at a time can be read, not %1 as well.</source>
        <translation>brush: Es kann immer nur eine Vorlage gelesen werden, nicht auch noch %1.</translation>
    </message>
    <message>
        <source>brush: no preset was given.</source>
        <translation>brush: Es wurde keine Vorlage angegeben.</translation>
    </message>
</context>
<context>
    <name>ui::PresetFiles</name>
    <message>
        <source>%1: there is not enough memory for this preset.</source>
        <translation>%1: Für diese Vorlage reicht der Speicher nicht.</translation>
    </message>
    <message>
        <source>%1: the alpha in this preset cannot be used: %2</source>
        <comment>a sentence that says why</comment>
        <translation>%1: Das Alpha in dieser Vorlage ist nicht verwendbar: %2</translation>
    </message>
</context>
<context>
    <name>ui::PresetLibrary</name>
    <message>
        <source>A brush preset was left out: %1</source>
        <comment>a sentence that says why</comment>
        <translation>Eine Pinselvorlage wurde weggelassen: %1</translation>
    </message>
    <message numerus="yes">
        <source>%n brush presets were left out. The first: %1</source>
        <comment>a sentence that says why</comment>
        <translation>
            <numerusform>%n Pinselvorlage wurde weggelassen: %1</numerusform>
            <numerusform>%n Pinselvorlagen wurden weggelassen. Die erste: %1</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 was not deleted: it cannot be moved to the trash.</source>
        <translation>%1 wurde nicht gelöscht: Die Datei lässt sich nicht in den Papierkorb verschieben.</translation>
    </message>
</context>
<context>
    <name>ui::PresetList</name>
    <message>
        <source>Brush presets</source>
        <translation>Pinselvorlagen</translation>
    </message>
    <message>
        <source>New Preset</source>
        <translation>Neue Vorlage</translation>
    </message>
    <message>
        <source>Saves the current brush as a preset, and asks for its name.</source>
        <translation>Speichert den aktuellen Pinsel als Vorlage und fragt nach ihrem Namen.</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>Renames this preset (F2).</source>
        <translation>Benennt diese Vorlage um (F2).</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Moves this preset to the trash.</source>
        <translation>Verschiebt diese Vorlage in den Papierkorb.</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importieren</translation>
    </message>
    <message>
        <source>Imports a preset from a file.</source>
        <translation>Importiert eine Vorlage aus einer Datei.</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Writes this preset to a file that others can import.</source>
        <translation>Schreibt diese Vorlage in eine Datei, die andere importieren können.</translation>
    </message>
    <message>
        <source>My brush</source>
        <translation>Mein Pinsel</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>Vorlagen</translation>
    </message>
</context>
<context>
    <name>ui::PresetTexts</name>
    <message>
        <source>Clay Buildup</source>
        <translation>Ton auftragen</translation>
    </message>
    <message>
        <source>Adds clay in thick rolls, more where you pause.</source>
        <translation>Trägt Ton in dicken Wülsten auf, mehr davon, wo Sie innehalten.</translation>
    </message>
    <message>
        <source>Raked Clay</source>
        <translation>Gekämmter Ton</translation>
    </message>
    <message>
        <source>Adds clay in strips, as a rake does.</source>
        <translation>Trägt Ton in Streifen auf, wie ein Kamm.</translation>
    </message>
    <message>
        <source>Carve</source>
        <translation>Schnitzen</translation>
    </message>
    <message>
        <source>Cuts a groove with soft edges.</source>
        <translation>Gräbt eine Rinne mit weichen Rändern.</translation>
    </message>
    <message>
        <source>Swell</source>
        <translation>Schwellen</translation>
    </message>
    <message>
        <source>Inflates the surface under it, with a soft edge.</source>
        <translation>Bläht die Oberfläche darunter auf, mit weichem Rand.</translation>
    </message>
    <message>
        <source>Panel</source>
        <translation>Platte</translation>
    </message>
    <message>
        <source>Raises a plate of one height, with steep sides.</source>
        <translation>Hebt eine Platte gleicher Höhe mit steilem Rand.</translation>
    </message>
    <message>
        <source>Fine Line</source>
        <translation>Feine Linie</translation>
    </message>
    <message>
        <source>Scores a sharp line: wrinkles, eyelids, seams.</source>
        <translation>Ritzt eine scharfe Linie: Falten, Lider, Nähte.</translation>
    </message>
    <message>
        <source>Ridge</source>
        <translation>Grat</translation>
    </message>
    <message>
        <source>Raises a sharp edge.</source>
        <translation>Hebt eine scharfe Kante.</translation>
    </message>
    <message>
        <source>Polish</source>
        <translation>Polieren</translation>
    </message>
    <message>
        <source>Removes bumps and keeps hollows.</source>
        <translation>Trägt Buckel ab und lässt Mulden stehen.</translation>
    </message>
    <message>
        <source>Plane Off</source>
        <translation>Abhobeln</translation>
    </message>
    <message>
        <source>Cuts flat faces, like a knife.</source>
        <translation>Schneidet ebene Flächen wie ein Messer.</translation>
    </message>
    <message>
        <source>Big Move</source>
        <translation>Großer Griff</translation>
    </message>
    <message>
        <source>Moves large parts of the model, softly.</source>
        <translation>Verschiebt sanft große Teile des Modells.</translation>
    </message>
    <message>
        <source>Horn</source>
        <translation>Horn</translation>
    </message>
    <message>
        <source>Pulls out horns, tails and roots.</source>
        <translation>Zieht Hörner, Schwänze und Wurzeln heraus.</translation>
    </message>
    <message>
        <source>Pores</source>
        <translation>Poren</translation>
    </message>
    <message>
        <source>Stamps skin pores.</source>
        <translation>Prägt die Poren von Haut ein.</translation>
    </message>
    <message>
        <source>Scales</source>
        <translation>Schuppen</translation>
    </message>
    <message>
        <source>Stamps scales along the stroke.</source>
        <translation>Prägt Schuppen entlang des Strichs ein.</translation>
    </message>
    <message>
        <source>Cracks</source>
        <translation>Risse</translation>
    </message>
    <message>
        <source>Stamps the cracks of dry earth.</source>
        <translation>Prägt die Risse trockener Erde ein.</translation>
    </message>
    <message>
        <source>Weave</source>
        <translation>Gewebe</translation>
    </message>
    <message>
        <source>Stamps woven cloth along the stroke.</source>
        <translation>Prägt gewebtes Tuch entlang des Strichs ein.</translation>
    </message>
    <message>
        <source>Rough Stone</source>
        <translation>Rauer Stein</translation>
    </message>
    <message>
        <source>Makes the surface rough, like broken stone.</source>
        <translation>Macht die Oberfläche rau wie gebrochenen Stein.</translation>
    </message>
</context>
<context>
    <name>ui::StrokeFileMessages</name>
    <message>
        <source>%1: %2</source>
        <comment>file: reason</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1: %2: %3</source>
        <comment>file: place: reason</comment>
        <translation>%1: %2: %3</translation>
    </message>
    <message>
        <source>line %1, byte %2</source>
        <translation>Zeile %1, Byte %2</translation>
    </message>
    <message>
        <source>stroke %1, sample %2 (strokes[%3].samples[%4])</source>
        <extracomment>counted from 1; in brackets as in the file, counted from 0</extracomment>
        <translation>Strich %1, Messpunkt %2 (strokes[%3].samples[%4])</translation>
    </message>
    <message>
        <source>stroke %1 (strokes[%2])</source>
        <translation>Strich %1 (strokes[%2])</translation>
    </message>
    <message>
        <source>this file cannot be read</source>
        <translation>diese Datei ist nicht lesbar</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>diese Datei gibt es nicht</translation>
    </message>
    <message>
        <source>this file cannot be read (%1)</source>
        <translation>diese Datei ist nicht lesbar (%1)</translation>
    </message>
    <message>
        <source>this is not JSON</source>
        <translation>das ist kein JSON</translation>
    </message>
    <message>
        <source>this is not a stroke file of version 1 (%1)</source>
        <translation>das ist keine Strichdatei der Version 1 (%1)</translation>
    </message>
    <message>
        <source>no object</source>
        <translation>kein Objekt</translation>
    </message>
    <message>
        <source>unknown key %1</source>
        <translation>unbekannter Schlüssel %1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is missing</source>
        <translation>„%1“ fehlt</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must be a number</source>
        <translation>„%1“ muss eine Zahl sein</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must be a whole number</source>
        <translation>„%1“ muss eine ganze Zahl sein</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must be three numbers, as in [0, 1, 0]</source>
        <translation>„%1“ muss aus drei Zahlen bestehen, wie in [0, 1, 0]</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must be four numbers, as in [0, 0, 0, 1]</source>
        <translation>„%1“ muss aus vier Zahlen bestehen, wie in [0, 0, 0, 1]</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must be three whole numbers from 0 to 255, as in [200, 120, 80]</source>
        <translation>„%1“ muss aus drei ganzen Zahlen von 0 bis 255 bestehen, wie in [200, 120, 80]</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must be true or false</source>
        <translation>„%1“ muss true oder false sein</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must be a word in quotation marks</source>
        <translation>„%1“ muss ein Wort in Anführungszeichen sein</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must be a word in quotation marks, true or false</source>
        <translation>„%1“ muss ein Wort in Anführungszeichen, true oder false sein</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must be an object in braces</source>
        <translation>„%1“ muss ein Objekt in geschweiften Klammern sein</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must be a list of objects, as in [{…}, {…}]</source>
        <translation>„%1“ muss eine Liste von Objekten sein, wie in [{…}, {…}]</translation>
    </message>
    <message>
        <source>unknown value, %1</source>
        <translation>unbekannter Wert, %1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a finite number</source>
        <translation>„%1“ ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is out of range, %2 to %3</source>
        <translation>„%1“ liegt außerhalb des Bereichs, %2 bis %3</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is out of range</source>
        <translation>„%1“ liegt außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is out of range, 0 or %2 to %3</source>
        <translation>„%1“ liegt außerhalb des Bereichs, 0 oder %2 bis %3</translation>
    </message>
    <message>
        <source>this file is too large: at most %1 are read</source>
        <translation>diese Datei ist zu groß: Höchstens %1 werden gelesen</translation>
    </message>
    <message>
        <source>this is not a brush preset of version 1 (%1)</source>
        <translation>das ist keine Pinselvorlage der Version 1 (%1)</translation>
    </message>
    <message>
        <source>this brush preset was made by a newer version of Fettle</source>
        <translation>diese Pinselvorlage stammt von einer neueren Version von Fettle</translation>
    </message>
    <message>
        <source>&quot;%1&quot; appears twice</source>
        <translation>„%1“ kommt zweimal vor</translation>
    </message>
    <message>
        <source>it has version %1; this program reads version 1</source>
        <translation>sie hat Version %1; dieses Programm liest Version 1</translation>
    </message>
    <message>
        <source>%1 is none of %2</source>
        <extracomment>key and value, as in place: &quot;there&quot;</extracomment>
        <translation>%1 ist keins von %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must be a list of whole numbers, as in [0, 2]</source>
        <translation>„%1“ muss eine Liste ganzer Zahlen sein, wie in [0, 2]</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must be a list of pairs of numbers, as in [[10, 0], [8, 20]]</source>
        <translation>„%1“ muss eine Liste von Zahlenpaaren sein, wie in [[10, 0], [8, 20]]</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must be a list of points of three numbers, as in [[0, 0, 5], [9, 0, 5], [0, 9, 5]]</source>
        <translation>&quot;%1&quot; muss eine Liste von Punkten aus drei Zahlen sein, wie in [[0, 0, 5], [9, 0, 5], [0, 9, 5]]</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must be a list of points of four numbers, as in [[0, 0, 0, 2], [9, 0, 0, 1]]</source>
        <translation>&quot;%1&quot; muss eine Liste von Punkten aus vier Zahlen sein, wie in [[0, 0, 0, 2], [9, 0, 0, 1]]</translation>
    </message>
</context>
<context>
    <name>app::CommandOptions</name>
    <message>
        <source>Show this help.</source>
        <translation>Diese Hilfe zeigen.</translation>
    </message>
    <message>
        <source>%1: --%2 must be %3, not &quot;%4&quot;.</source>
        <translation>%1: --%2 muss %3 sein, nicht „%4“.</translation>
    </message>
    <message>
        <source>one of %1</source>
        <translation>eins von %1</translation>
    </message>
    <message>
        <source>a number from %1 to %2</source>
        <translation>eine Zahl von %1 bis %2</translation>
    </message>
    <message>
        <source>a whole number, %1 or more</source>
        <translation>eine ganze Zahl, mindestens %1</translation>
    </message>
    <message>
        <source>%1: --%2 and --%3 cannot be used together.</source>
        <translation>%1: --%2 und --%3 lassen sich nicht zusammen verwenden.</translation>
    </message>
    <message>
        <source>%1: %2 can only be used with --%3.</source>
        <translation>%1: %2 lässt sich nur mit --%3 verwenden.</translation>
    </message>
    <message>
        <source>Overwrite no existing file; end with status 2 instead.</source>
        <translation>Keine vorhandene Datei überschreiben, sondern mit Status 2 enden.</translation>
    </message>
    <message>
        <source>%1: %2 already exists and is not overwritten, because of --no-clobber.</source>
        <translation>%1: %2 ist schon da und wird wegen --no-clobber nicht überschrieben.</translation>
    </message>
    <message>
        <source>The file to write, in the format of its ending; or -.</source>
        <translation>Die zu schreibende Datei, im Format ihrer Endung; oder -.</translation>
    </message>
    <message>
        <source>%1: the output file is missing; name it with -o.</source>
        <translation>%1: Die Ausgabedatei fehlt; nennen Sie sie mit -o.</translation>
    </message>
</context>
<context>
    <name>app::NewCommand</name>
    <message>
        <source>The shape.</source>
        <translation>Die Form.</translation>
    </message>
    <message>
        <source>The file to write, in the format of its ending; or -.</source>
        <translation>Die zu schreibende Datei, im Format ihrer Endung; oder -.</translation>
    </message>
    <message>
        <source>Length of its longest side in mm (default: 100).</source>
        <translation>Länge der längsten Seite in mm (Vorgabe: 100).</translation>
    </message>
    <message>
        <source>new: needs a shape and a file, as in new ball ball.glb; the shapes are %1.</source>
        <translation>new: braucht eine Form und eine Datei, wie in new ball ball.glb; die Formen sind %1.</translation>
    </message>
    <message>
        <source>Width of a box, along x, in mm.</source>
        <translation>Breite eines Quaders, entlang x, in mm.</translation>
    </message>
    <message>
        <source>Height along y in mm; a capsule&apos;s with its round ends.</source>
        <translation>Höhe entlang y in mm; bei einer Kapsel mit ihren runden Enden.</translation>
    </message>
    <message>
        <source>Depth of a box, along z, in mm.</source>
        <translation>Tiefe eines Quaders, entlang z, in mm.</translation>
    </message>
    <message>
        <source>Radius in mm; a cone&apos;s at the bottom, a torus&apos;s to the middle of its tube.</source>
        <translation>Radius in mm; bei einem Kegel unten, bei einem Ring bis zur Mitte seines Rohrs.</translation>
    </message>
    <message>
        <source>Radius of a cone at the top, in mm (default: 0).</source>
        <translation>Radius eines Kegels oben, in mm (Vorgabe: 0).</translation>
    </message>
    <message>
        <source>Radius of a torus&apos;s tube, in mm.</source>
        <translation>Radius des Rohrs eines Rings, in mm.</translation>
    </message>
    <message>
        <source>Profile of a lathe: points of radius and height in mm.</source>
        <translation>Profil eines Drehkörpers: Punkte aus Radius und Höhe in mm.</translation>
    </message>
    <message>
        <source>Length of a primitive&apos;s edges in mm (default: automatic).</source>
        <translation>Länge der Kanten eines Grundkörpers in mm (Vorgabe: automatisch).</translation>
    </message>
    <message>
        <source>new: --profile must be points of radius and height, as in &quot;10,0 8,20&quot;, not &quot;%1&quot;.</source>
        <translation>new: --profile muss aus Punkten mit Radius und Höhe bestehen, wie in &quot;10,0 8,20&quot;, nicht &quot;%1&quot;.</translation>
    </message>
    <message>
        <source>Writes one of the program&apos;s starting shapes: %1. Or a solid of the given measures: %2.</source>
        <translation>Schreibt eine der Ausgangsformen des Programms: %1. Oder einen Körper mit den gegebenen Maßen: %2.</translation>
    </message>
    <message>
        <source>new: %1 needs --%2.</source>
        <translation>new: %1 braucht --%2.</translation>
    </message>
    <message>
        <source>new: %1 has no --%2.</source>
        <translation>new: %1 hat kein --%2.</translation>
    </message>
    <message>
        <source>new: %1 with measures has no --%2.</source>
        <translation>new: %1 mit Maßen hat kein --%2.</translation>
    </message>
    <message>
        <source>new: the shape must be one of %1, or with measures %2, not &quot;%3&quot;.</source>
        <translation>new: Die Form muss eine von %1 sein, oder mit Maßen %2, nicht &quot;%3&quot;.</translation>
    </message>
    <message>
        <source>new: %1 has no measures but --%2.</source>
        <translation>new: %1 hat kein anderes Maß als --%2.</translation>
    </message>
    <message>
        <source>Path of a tube: points of x, y, z and radius in mm.</source>
        <translation>Verlauf eines Rohrs: Punkte aus x, y, z und Radius in mm.</translation>
    </message>
    <message>
        <source>new: --path must be points of x, y, z and radius, as in &quot;0,0,0,2 9,5,0,1&quot;, not &quot;%1&quot;.</source>
        <translation>new: --path muss aus Punkten mit x, y, z und Radius bestehen, wie in &quot;0,0,0,2 9,5,0,1&quot;, nicht &quot;%1&quot;.</translation>
    </message>
</context>
<context>
    <name>app::StandardFiles</name>
    <message>
        <source>Format of a model that is read from the standard input, -.</source>
        <translation>Format eines Modells, das von der Standardeingabe, -, gelesen wird.</translation>
    </message>
    <message>
        <source>Format of the standard output, -.</source>
        <translation>Format der Standardausgabe, -.</translation>
    </message>
    <message>
        <source>%1: --%2 must say the format of -: one of %3.</source>
        <translation>%1: --%2 muss das Format von - nennen: eins von %3.</translation>
    </message>
    <message>
        <source>The standard input cannot be read (%1).</source>
        <translation>Die Standardeingabe kann nicht gelesen werden (%1).</translation>
    </message>
    <message>
        <source>%1: %2 is binary and is not printed to a terminal: redirect the standard output to a file or a program.</source>
        <translation>%1: %2 ist binär und wird nicht auf einem Terminal ausgegeben: Leiten Sie die Standardausgabe in eine Datei oder ein Programm um.</translation>
    </message>
    <message>
        <source>The standard output cannot be written (%1).</source>
        <translation>Auf die Standardausgabe kann nicht geschrieben werden (%1).</translation>
    </message>
    <message>
        <source>(standard input)</source>
        <translation>(Standardeingabe)</translation>
    </message>
    <message>
        <source>(standard output)</source>
        <translation>(Standardausgabe)</translation>
    </message>
</context>
<context>
    <name>app::DocumentStrokes</name>
    <message>
        <source>%1 is hidden. Show it, or choose another part.</source>
        <translation>%1 ist ausgeblendet. Blenden Sie es ein, oder wählen Sie ein anderes Teil.</translation>
    </message>
    <message>
        <source>%1 is locked. Unlock it, or choose another part.</source>
        <translation>%1 ist gesperrt. Entsperren Sie es, oder wählen Sie ein anderes Teil.</translation>
    </message>
</context>
<context>
    <name>ui::CurveDrawing</name>
    <message>
        <source>Draw around an area.</source>
        <translation>Umfahren Sie einen Bereich.</translation>
    </message>
    <message>
        <source>Drag a box over an area.</source>
        <translation>Ziehen Sie ein Rechteck über einen Bereich auf.</translation>
    </message>
    <message>
        <source>Drag a line; the area is on its right.</source>
        <translation>Ziehen Sie eine Linie; der Bereich liegt rechts davon.</translation>
    </message>
    <message>
        <source>Click the corners of an area; a double click ends.</source>
        <translation>Klicken Sie die Ecken eines Bereichs an; ein Doppelklick schließt ab.</translation>
    </message>
    <message>
        <source>The box is too small: drag from one corner to the opposite one.</source>
        <translation>Das Rechteck ist zu klein: Ziehen Sie von einer Ecke zur gegenüberliegenden.</translation>
    </message>
    <message>
        <source>The line is too short: drag it across the model.</source>
        <translation>Die Linie ist zu kurz: Ziehen Sie sie über das Modell.</translation>
    </message>
    <message>
        <source>A polygon needs at least three corners that are not in one line.</source>
        <translation>Ein Vieleck braucht mindestens drei Ecken, die nicht auf einer Linie liegen.</translation>
    </message>
    <message>
        <source>The lasso is too small: drag it around something.</source>
        <translation>Das Lasso ist zu klein: Ziehen Sie es um etwas herum.</translation>
    </message>
    <message>
        <source>What is inside is masked.</source>
        <translation>Was innen liegt, wird maskiert.</translation>
    </message>
    <message>
        <source>The mask inside is removed.</source>
        <translation>Die Maske innen wird entfernt.</translation>
    </message>
    <message>
        <source>What is inside is hidden.</source>
        <translation>Was innen liegt, wird ausgeblendet.</translation>
    </message>
    <message>
        <source>What is inside is cut away.</source>
        <translation>Was innen liegt, wird weggeschnitten.</translation>
    </message>
    <message>
        <source>What is inside becomes a part of its own.</source>
        <translation>Was innen liegt, wird ein eigenes Teil.</translation>
    </message>
    <message>
        <source>What is outside is masked.</source>
        <translation>Was außen liegt, wird maskiert.</translation>
    </message>
    <message>
        <source>The mask outside is removed.</source>
        <translation>Die Maske außen wird entfernt.</translation>
    </message>
    <message>
        <source>What is outside is hidden.</source>
        <translation>Was außen liegt, wird ausgeblendet.</translation>
    </message>
    <message>
        <source>What is outside is cut away.</source>
        <translation>Was außen liegt, wird weggeschnitten.</translation>
    </message>
    <message>
        <source>What is outside becomes a part of its own.</source>
        <translation>Was außen liegt, wird ein eigenes Teil.</translation>
    </message>
    <message>
        <source>Only what is in front counts.</source>
        <translation>Nur was vorn liegt, zählt.</translation>
    </message>
    <message>
        <source>Shift: the other side. Esc cancels.</source>
        <translation>Umschalt: die andere Seite. Esc bricht ab.</translation>
    </message>
</context>
<context>
    <name>ui::PartName</name>
    <message>
        <source>Part %1</source>
        <translation>Teil %1</translation>
    </message>
</context>
<context>
    <name>ui::PartsPanel</name>
    <message>
        <source>Shown. Click to hide.</source>
        <translation>Eingeblendet. Klicken blendet aus.</translation>
    </message>
    <message>
        <source>Hidden. Click to show.</source>
        <translation>Ausgeblendet. Klicken blendet ein.</translation>
    </message>
    <message>
        <source>Locked. Click to unlock.</source>
        <translation>Gesperrt. Klicken entsperrt.</translation>
    </message>
    <message>
        <source>Unlocked. Click to lock.</source>
        <translation>Nicht gesperrt. Klicken sperrt.</translation>
    </message>
    <message>
        <source>%1, locked</source>
        <translation>%1, gesperrt</translation>
    </message>
    <message>
        <source>%1, active</source>
        <translation>%1, aktiv</translation>
    </message>
    <message>
        <source>%1, hidden</source>
        <translation>%1, ausgeblendet</translation>
    </message>
    <message>
        <source>The parts of the model. Click one to sculpt it, and its name becomes bold; with Ctrl choose others to combine it with. Double-click a name to change it.</source>
        <translation>Die Teile des Modells. Klicken Sie eines an, um es zu formen; sein Name wird fett. Mit Strg wählen Sie andere, mit denen es verbunden wird. Ein Doppelklick auf einen Namen ändert ihn.</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Teile</translation>
    </message>
    <message>
        <source>%1 copy</source>
        <comment>name of a copied part</comment>
        <translation>%1 Kopie</translation>
    </message>
    <message>
        <source>Colour of %1 in the List</source>
        <translation>Farbe von %1 in der Liste</translation>
    </message>
</context>
<context>
    <name>ui::PrimitiveDialog</name>
    <message>
        <source>Insert a Primitive</source>
        <translation>Grundkörper einfügen</translation>
    </message>
    <message>
        <source>Measures, place, and how it is combined with the present model:</source>
        <translation>Maße, Ort und wie er mit dem vorhandenen Modell verknüpft wird:</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>Its axis</source>
        <translation>Seine Achse</translation>
    </message>
    <message>
        <source>Edge length</source>
        <translation>Kantenlänge</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>One point a line: its distance from the axis and its height, in millimetres.</source>
        <translation>Ein Punkt je Zeile: sein Abstand von der Achse und seine Höhe, in Millimetern.</translation>
    </message>
    <message>
        <source>Profile: radius, height</source>
        <translation>Profil: Radius, Höhe</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Ort</translation>
    </message>
    <message>
        <source>With the middle of its bottom at</source>
        <translation>Mit der Mitte seiner Unterseite bei</translation>
    </message>
    <message>
        <source>Path: X, Y, Z, radius</source>
        <translation>Verlauf: X, Y, Z, Radius</translation>
    </message>
    <message>
        <source>One point a line: its place, and the radius of the tube there, in millimetres.</source>
        <translation>Ein Punkt je Zeile: sein Ort und der Radius des Rohrs dort, in Millimetern.</translation>
    </message>
</context>
<context>
    <name>ui::PrimitiveMessages</name>
    <message>
        <source>Box</source>
        <translation>Quader</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>Cylinder</source>
        <translation>Zylinder</translation>
    </message>
    <message>
        <source>Cone</source>
        <translation>Kegel</translation>
    </message>
    <message>
        <source>Capsule</source>
        <translation>Kapsel</translation>
    </message>
    <message>
        <source>Torus</source>
        <translation>Ring</translation>
    </message>
    <message>
        <source>Turned profile</source>
        <translation>Gedrehtes Profil</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Radius at the top</source>
        <translation>Radius oben</translation>
    </message>
    <message>
        <source>Radius of the tube</source>
        <translation>Radius des Rohrs</translation>
    </message>
    <message>
        <source>%1: it must be between a millionth of a millimetre and ten kilometres.</source>
        <extracomment>%1: a measure, for example Height</extracomment>
        <translation>%1: Der Wert muss zwischen einem Millionstel Millimeter und zehn Kilometern liegen.</translation>
    </message>
    <message>
        <source>The radius of a torus must be larger than the radius of its tube.</source>
        <translation>Der Radius eines Rings muss größer sein als der Radius seines Rohrs.</translation>
    </message>
    <message>
        <source>The height of a capsule must be more than twice its radius.</source>
        <translation>Die Höhe einer Kapsel muss mehr als das Doppelte ihres Radius betragen.</translation>
    </message>
    <message>
        <source>A profile needs 2 to 1000 different points, none with a radius below 0; only its ends may be on the axis.</source>
        <translation>Ein Profil braucht 2 bis 1000 verschiedene Punkte, keinen mit einem Radius unter 0; nur seine Enden dürfen auf der Achse liegen.</translation>
    </message>
    <message>
        <source>The profile crosses or touches itself, or its walls are too thin for edges this long.</source>
        <translation>Das Profil kreuzt oder berührt sich selbst, oder seine Wände sind zu dünn für so lange Kanten.</translation>
    </message>
    <message>
        <source>For this shape, the edges may be %1 mm long at most.</source>
        <translation>Bei dieser Form dürfen die Kanten höchstens %1 mm lang sein.</translation>
    </message>
    <message>
        <source>This shape would need too many triangles (%1, at most 2 million): its edges would be too short for its size.</source>
        <translation>Diese Form würde zu viele Dreiecke brauchen (%1, höchstens 2 Millionen): Ihre Kanten wären für ihre Größe zu kurz.</translation>
    </message>
    <message>
        <source>Tube</source>
        <translation>Rohr</translation>
    </message>
    <message>
        <source>A tube needs 2 to 1000 points, each at another place than the one before it, with radii that are not tiny beside their distance from the origin.</source>
        <translation>Ein Rohr braucht 2 bis 1000 Punkte, jeder an einem anderen Ort als der vor ihm, mit Radien, die neben ihrem Abstand vom Ursprung nicht winzig sind.</translation>
    </message>
    <message>
        <source>The tube crosses itself too often. Make it thinner, or its curve smoother.</source>
        <translation>Das Rohr kreuzt sich zu oft. Machen Sie es dünner oder seine Kurve glatter.</translation>
    </message>
</context>
<context>
    <name>ui::AreaBar</name>
    <message>
        <source>Lasso</source>
        <translation>Lasso</translation>
    </message>
    <message>
        <source>Draw freely around the area (1).</source>
        <translation>Umfahren Sie den Bereich frei (1).</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Rechteck</translation>
    </message>
    <message>
        <source>Drag a box over the area (2).</source>
        <translation>Ziehen Sie ein Rechteck über den Bereich auf (2).</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Linie</translation>
    </message>
    <message>
        <source>Drag a line; the area is on its right (3).</source>
        <translation>Ziehen Sie eine Linie; der Bereich liegt rechts davon (3).</translation>
    </message>
    <message>
        <source>Polygon</source>
        <translation>Vieleck</translation>
    </message>
    <message>
        <source>Click the corners of the area (4).</source>
        <translation>Klicken Sie die Ecken des Bereichs an (4).</translation>
    </message>
    <message>
        <source>Outside</source>
        <translation>Außerhalb</translation>
    </message>
    <message>
        <source>Takes what is beside the curve instead (O, or hold Shift).</source>
        <translation>Nimmt stattdessen, was neben der Kurve liegt (O, oder Umschalt halten).</translation>
    </message>
    <message>
        <source>Only in Front</source>
        <translation>Nur vorn</translation>
    </message>
    <message>
        <source>Takes only what is seen first, not what is behind it (F).</source>
        <translation>Nimmt nur, was man zuerst sieht, nicht was dahinter liegt (F).</translation>
    </message>
    <message>
        <source>Coloured</source>
        <translation>Farbig</translation>
    </message>
    <message>
        <source>Gives the faces of the cut the paint colour (P).</source>
        <translation>Gibt den Flächen des Schnitts die Malfarbe (P).</translation>
    </message>
</context>
<context>
    <name>ui::ObjectsBar</name>
    <message>
        <source>Objects of the File</source>
        <translation>Objekte der Datei</translation>
    </message>
    <message numerus="yes">
        <source>%1 has %Ln objects. Each is a part now.</source>
        <translation>
            <numerusform>%1 hat %Ln Objekt. Es ist jetzt ein Teil.</numerusform>
            <numerusform>%1 hat %Ln Objekte. Jedes ist jetzt ein Teil.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 has %Ln objects. They are one part now.</source>
        <translation>
            <numerusform>%1 hat %Ln Objekt. Es ist jetzt ein Teil.</numerusform>
            <numerusform>%1 hat %Ln Objekte. Sie sind jetzt ein Teil.</numerusform>
        </translation>
    </message>
    <message>
        <source>Open as &amp;One Part</source>
        <translation>A&amp;ls ein Teil öffnen</translation>
    </message>
    <message>
        <source>Opens the file again and makes one part of all objects, also of files opened later.</source>
        <translation>Öffnet die Datei neu und macht aus allen Objekten ein Teil, auch bei später geöffneten Dateien.</translation>
    </message>
    <message>
        <source>Open as &amp;Parts</source>
        <translation>Als Tei&amp;le öffnen</translation>
    </message>
    <message>
        <source>Opens the file again and makes a part of each object, also of files opened later.</source>
        <translation>Öffnet die Datei neu und macht aus jedem Objekt ein Teil, auch bei später geöffneten Dateien.</translation>
    </message>
    <message>
        <source>&amp;Keep as It Is</source>
        <translation>&amp;So lassen</translation>
    </message>
    <message>
        <source>Leaves the model as it is, and hides this bar.</source>
        <translation>Lässt das Modell, wie es ist, und blendet diese Leiste aus.</translation>
    </message>
</context>
<context>
    <name>ui::PlaneCutTool</name>
    <message>
        <source>Colour the cu&amp;t</source>
        <translation>Den Schnitt &amp;färben</translation>
    </message>
    <message>
        <source>Cut Away gives the flat face the paint colour.</source>
        <translation>Wegschneiden gibt der ebenen Fläche die Malfarbe.</translation>
    </message>
    <message>
        <source>&amp;Cut Away</source>
        <translation>&amp;Wegschneiden</translation>
    </message>
    <message>
        <source>Removes what is tinted, and closes the cut with a flat face.</source>
        <translation>Entfernt, was getönt ist, und schließt den Schnitt mit einer ebenen Fläche.</translation>
    </message>
    <message>
        <source>&amp;Split</source>
        <translation>&amp;Teilen</translation>
    </message>
    <message>
        <source>Makes what is tinted a part of its own.</source>
        <translation>Macht aus dem, was getönt ist, ein eigenes Teil.</translation>
    </message>
    <message>
        <source>S&amp;wap Sides</source>
        <translation>&amp;Seiten tauschen</translation>
    </message>
    <message>
        <source>Turns the plane over, so that the other side is tinted.</source>
        <translation>Wendet die Ebene, sodass die andere Seite getönt ist.</translation>
    </message>
    <message>
        <source>D&amp;one</source>
        <translation>Ferti&amp;g</translation>
    </message>
    <message>
        <source>Hides the plane (Esc).</source>
        <translation>Blendet die Ebene aus (Esc).</translation>
    </message>
    <message>
        <source>Symmetry: the mirror image of the plane cuts, too.</source>
        <translation>Symmetrie: Auch das Spiegelbild der Ebene schneidet.</translation>
    </message>
    <message>
        <source>Symmetry: the plane is its own mirror image, so it cuts once.</source>
        <translation>Symmetrie: Die Ebene ist ihr eigenes Spiegelbild und schneidet einmal.</translation>
    </message>
    <message>
        <source>This is the plane of symmetry, so one half goes.</source>
        <translation>Dies ist die Symmetrieebene, also fällt eine Hälfte weg.</translation>
    </message>
</context>
<context>
    <name>ui::TransformFields</name>
    <message>
        <source>Move, mm</source>
        <translation>Verschieben, mm</translation>
    </message>
    <message>
        <source>Rotate, °</source>
        <translation>Drehen, °</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Skalieren</translation>
    </message>
    <message>
        <source>Axes of the handles and of these numbers: the document&apos;s, or those that turn with the part.</source>
        <translation>Achsen der Griffe und dieser Zahlen: die des Dokuments oder die, die sich mit dem Teil drehen.</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Achsen</translation>
    </message>
    <message>
        <source>Document&apos;s axes</source>
        <translation>Achsen des Dokuments</translation>
    </message>
    <message>
        <source>Part&apos;s own axes</source>
        <translation>Eigene Achsen des Teils</translation>
    </message>
    <message>
        <source>&amp;Apply</source>
        <translation>&amp;Anwenden</translation>
    </message>
    <message>
        <source>Applies these numbers (Return).</source>
        <translation>Führt die Änderung mit diesen Zahlen aus (Eingabetaste).</translation>
    </message>
    <message>
        <source>D&amp;one</source>
        <translation>Ferti&amp;g</translation>
    </message>
    <message>
        <source>Hides the handles (Esc).</source>
        <translation>Blendet die Griffe aus (Esc).</translation>
    </message>
    <message>
        <source>Move along %1</source>
        <translation>Verschieben entlang %1</translation>
    </message>
    <message>
        <source>Rotate about %1</source>
        <translation>Drehen um %1</translation>
    </message>
    <message>
        <source>Scale along %1</source>
        <translation>Skalieren entlang %1</translation>
    </message>
</context>
<context>
    <name>vr::PartsPanel</name>
    <message>
        <source>%1 copy</source>
        <comment>name of a copied part</comment>
        <translation>%1 Kopie</translation>
    </message>
    <message>
        <source>%1 / %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>Isolate</source>
        <translation>Isolieren</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Alle einblenden</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplizieren</translation>
    </message>
    <message>
        <source>Hold to delete</source>
        <translation>Zum Löschen halten</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Anwenden</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Join</source>
        <translation>Vereinigen</translation>
    </message>
    <message>
        <source>Subtract</source>
        <translation>Abziehen</translation>
    </message>
    <message>
        <source>Intersect</source>
        <translation>Schnittmenge</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Quader</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>Cylinder</source>
        <translation>Zylinder</translation>
    </message>
    <message>
        <source>Cone</source>
        <translation>Kegel</translation>
    </message>
    <message>
        <source>Capsule</source>
        <translation>Kapsel</translation>
    </message>
    <message>
        <source>Torus</source>
        <translation>Ring</translation>
    </message>
    <message>
        <source>Trigger: chooses the part that you point at. Side button: moves the chosen part. Mark others to combine them with it.</source>
        <translation>Abzug: wählt das Teil, auf das Sie zeigen. Seitentaste: bewegt das gewählte Teil. Markieren Sie andere, um sie mit ihm zu verknüpfen.</translation>
    </message>
    <message>
        <source>Join with the part</source>
        <translation>Mit Teil vereinigen</translation>
    </message>
    <message>
        <source>Part of its own</source>
        <translation>Eigenes Teil</translation>
    </message>
    <message>
        <source>Trigger: puts the shape at the tip, as large as the brush. Side button: moves the chosen part.</source>
        <translation>Abzug: setzt die Form an die Spitze, so groß wie der Pinsel. Seitentaste: bewegt das gewählte Teil.</translation>
    </message>
    <message>
        <source>Cut away</source>
        <translation>Wegschneiden</translation>
    </message>
    <message>
        <source>Keep both</source>
        <translation>Beide behalten</translation>
    </message>
    <message>
        <source>Trigger: cuts the chosen part at the disc. What lies beyond the disc, away from your hand, becomes a part of its own. Side button: moves the part.</source>
        <translation>Abzug: schneidet das gewählte Teil an der Scheibe. Was jenseits der Scheibe liegt, von Ihrer Hand aus gesehen, wird ein eigenes Teil. Seitentaste: bewegt das Teil.</translation>
    </message>
    <message>
        <source>Trigger: cuts the chosen part at the disc. What lies beyond the disc, away from your hand, is removed. Side button: moves the part.</source>
        <translation>Abzug: schneidet das gewählte Teil an der Scheibe. Was jenseits der Scheibe liegt, von Ihrer Hand aus gesehen, verschwindet. Seitentaste: bewegt das Teil.</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Teile</translation>
    </message>
    <message>
        <source>Shapes</source>
        <translation>Formen</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Schneiden</translation>
    </message>
    <message>
        <source>Tube</source>
        <translation>Rohr</translation>
    </message>
    <message>
        <source>Body</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>Head</source>
        <translation>Kopf</translation>
    </message>
    <message>
        <source>Hair</source>
        <translation>Haar</translation>
    </message>
    <message>
        <source>Eye</source>
        <translation>Auge</translation>
    </message>
    <message>
        <source>Ear</source>
        <translation>Ohr</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>Arm</translation>
    </message>
    <message>
        <source>Hand</source>
        <translation>Hand</translation>
    </message>
    <message>
        <source>Leg</source>
        <translation>Bein</translation>
    </message>
    <message>
        <source>Wing</source>
        <translation>Flügel</translation>
    </message>
    <message>
        <source>Tail</source>
        <translation>Schwanz</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Rad</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>Sockel</translation>
    </message>
    <message>
        <source>No colour</source>
        <translation>Keine Farbe</translation>
    </message>
    <message>
        <source>Name and colour go to the chosen part. Trigger: chooses the part that you point at. Side button: moves it.</source>
        <translation>Name und Farbe bekommt das gewählte Teil. Abzug: wählt das Teil, auf das Sie zeigen. Seitentaste: bewegt es.</translation>
    </message>
    <message>
        <source>Trigger: hold it and move your hand to draw a tube, as thick as the brush. Side button: moves the chosen part.</source>
        <translation>Abzug: halten und die Hand bewegen, um ein Rohr zu zeichnen, so dick wie der Pinsel. Seitentaste: bewegt das gewählte Teil.</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
</context>
<context>
    <name>app::ModelChanger</name>
    <message>
        <source>Preview: %1</source>
        <translation>Vorschau: %1</translation>
    </message>
</context>
<context>
    <name>ui::CombinationCard</name>
    <message>
        <source>Join</source>
        <translation>Vereinigen</translation>
    </message>
    <message>
        <source>Subtract</source>
        <translation>Abziehen</translation>
    </message>
    <message>
        <source>Intersect</source>
        <translation>Schnittmenge</translation>
    </message>
    <message>
        <source>&amp;Apply</source>
        <translation>&amp;Anwenden</translation>
    </message>
    <message>
        <source>Keeps what is shown, as one step (Return).</source>
        <translation>Behält, was zu sehen ist, als einen Schritt (Eingabetaste).</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>Abbre&amp;chen</translation>
    </message>
    <message>
        <source>Leaves the parts as they were (Esc).</source>
        <translation>Lässt die Teile, wie sie waren (Esc).</translation>
    </message>
</context>
<context>
    <name>ui::SolidCard</name>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>A&amp;pply</source>
        <translation>An&amp;wenden</translation>
    </message>
    <message>
        <source>Makes the solid (Return).</source>
        <translation>Macht den Körper (Eingabetaste).</translation>
    </message>
    <message>
        <source>Middle, %1</source>
        <translation>Mitte, %1</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>Abbre&amp;chen</translation>
    </message>
    <message>
        <source>Makes no solid (Esc).</source>
        <translation>Macht keinen Körper (Esc).</translation>
    </message>
    <message>
        <source>&amp;Turn to the surface</source>
        <translation>Zur Fläche &amp;drehen</translation>
    </message>
    <message>
        <source>The solid stands at a right angle to the surface. Off: along the nearest axis.</source>
        <translation>Der Körper steht im rechten Winkel auf der Fläche. Aus: entlang der nächsten Achse.</translation>
    </message>
</context>
<context>
    <name>ui::SolidTool</name>
    <message>
        <source>Change the numbers, then apply (Return). Esc cancels.</source>
        <translation>Ändern Sie die Zahlen, und wenden Sie sie an (Eingabetaste). Esc bricht ab.</translation>
    </message>
    <message>
        <source>Press on the model or the ground, and drag to the size. Esc cancels.</source>
        <translation>Drücken Sie auf das Modell oder den Boden, und ziehen Sie bis zur Größe. Esc bricht ab.</translation>
    </message>
</context>
<context>
    <name>ui::TubeCard</name>
    <message>
        <source>Radius of the tube at the chosen point.</source>
        <translation>Radius des Rohrs am gewählten Punkt.</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>of &amp;all points</source>
        <translation>&amp;aller Punkte</translation>
    </message>
    <message>
        <source>Gives every point this radius.</source>
        <translation>Gibt jedem Punkt diesen Radius.</translation>
    </message>
    <message>
        <source>A&amp;pply</source>
        <translation>An&amp;wenden</translation>
    </message>
    <message>
        <source>Makes the tube (Return).</source>
        <translation>Macht das Rohr (Eingabetaste).</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>Abbre&amp;chen</translation>
    </message>
    <message>
        <source>Makes no tube (Esc).</source>
        <translation>Macht kein Rohr (Esc).</translation>
    </message>
</context>
<context>
    <name>ui::TubeTool</name>
    <message>
        <source>Draw the middle of a tube, on the model or beside it. Esc cancels.</source>
        <translation>Zeichnen Sie die Mitte eines Rohrs, auf dem Modell oder daneben. Esc bricht ab.</translation>
    </message>
    <message>
        <source>Drag a point or its circle; with Shift all circles. A double click on the line adds a point, Delete removes one.</source>
        <translation>Ziehen Sie einen Punkt oder seinen Kreis; mit Umschalt alle Kreise. Ein Doppelklick auf die Linie fügt einen Punkt hinzu, Entf entfernt einen.</translation>
    </message>
</context>
</TS>
