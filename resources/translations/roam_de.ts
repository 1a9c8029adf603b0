<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name></name>
    <message>
        <source>  (on)</source>
        <translation>  (an)</translation>
    </message>
    <message>
        <source>  doubtful</source>
        <translation>  zweifelhaft</translation>
    </message>
    <message>
        <source>  out of sight</source>
        <translation>  außer Sicht</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message numerus="yes">
        <source> %n of its {count} points is/are doubtful and ringed.</source>
        <translation>
            <numerusform> %n von {count} Punkten ist zweifelhaft und eingekreist.</numerusform>
            <numerusform> %n von {count} Punkten sind zweifelhaft und eingekreist.</numerusform>
        </translation>
    </message>
    <message>
        <source> (ripple)</source>
        <translation> (Ripple)</translation>
    </message>
    <message>
        <source> Bridged without a picture: {bridged}.</source>
        <translation> Ohne Bild überbrückt: {bridged}.</translation>
    </message>
    <message>
        <source> GB</source>
        <translation> GB</translation>
    </message>
    <message>
        <source> It goes on from that.</source>
        <translation> Es geht von da aus weiter.</translation>
    </message>
    <message>
        <source> It goes on with the others.</source>
        <translation> Es geht mit den anderen weiter.</translation>
    </message>
    <message>
        <source> Its plate was found at {path}; save to keep that.</source>
        <translation> Die Plate wurde in {path} gefunden; durch Speichern bleibt das so.</translation>
    </message>
    <message>
        <source> MB</source>
        <translation> MB</translation>
    </message>
    <message>
        <source> Tracked frames are out of date: they were found in other colours.</source>
        <translation> Getrackte Frames sind veraltet: Sie wurden in anderen Farben gefunden.</translation>
    </message>
    <message>
        <source> and </source>
        <translation> und </translation>
    </message>
    <message>
        <source> and on others</source>
        <translation> und auf anderen</translation>
    </message>
    <message>
        <source> fps</source>
        <translation> fps</translation>
    </message>
    <message>
        <source> frames</source>
        <translation> Frames</translation>
    </message>
    <message numerus="yes">
        <source> in %n shape(s)</source>
        <translation>
            <numerusform> in %n Form</numerusform>
            <numerusform> in %n Formen</numerusform>
        </translation>
    </message>
    <message>
        <source> or </source>
        <translation> oder </translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source> px²</source>
        <translation> px²</translation>
    </message>
    <message>
        <source> since the last save</source>
        <translation> seit dem letzten Speichern</translation>
    </message>
    <message>
        <source> {shapes} edited or locked meanwhile: left as they are.</source>
        <translation> {shapes} inzwischen bearbeitet oder gesperrt und nicht verändert.</translation>
    </message>
    <message>
        <source>&quot;colour&quot; must be a list of three numbers</source>
        <translation>&quot;colour&quot; muss eine Liste aus drei Zahlen sein</translation>
    </message>
    <message>
        <source>&quot;depth&quot; must be a list of frames, each with -1, 0 or 1</source>
        <translation>&quot;depth&quot; muss eine Liste von Frames sein, jeder mit -1, 0 oder 1</translation>
    </message>
    <message>
        <source>&quot;kind&quot; must be &quot;layer&quot; or &quot;shape&quot;</source>
        <translation>&quot;kind&quot; muss &quot;layer&quot; oder &quot;shape&quot; sein</translation>
    </message>
    <message>
        <source>&quot;lifetime&quot; must be null or a first frame and the frame after the last</source>
        <translation>&quot;lifetime&quot; muss null sein oder der erste Frame und der nach dem letzten</translation>
    </message>
    <message>
        <source>&quot;lifetime&quot; must not end before it begins</source>
        <translation>&quot;lifetime&quot; darf nicht enden, bevor es beginnt</translation>
    </message>
    <message>
        <source>&quot;motion_blur&quot; must be null or an object</source>
        <translation>&quot;motion_blur&quot; muss null oder ein Objekt sein</translation>
    </message>
    <message>
        <source>&quot;slopes&quot; must be two numbers</source>
        <translation>&quot;slopes&quot; müssen zwei Zahlen sein</translation>
    </message>
    <message>
        <source>&quot;{field}&quot; must be a list</source>
        <translation>&quot;{field}&quot; muss eine Liste sein</translation>
    </message>
    <message>
        <source>&quot;{field}&quot; must be a number</source>
        <translation>&quot;{field}&quot; muss eine Zahl sein</translation>
    </message>
    <message>
        <source>&quot;{field}&quot; must be a text</source>
        <translation>&quot;{field}&quot; muss ein Text sein</translation>
    </message>
    <message>
        <source>&quot;{field}&quot; must be one of {words}</source>
        <translation>&quot;{field}&quot; muss eines davon sein: {words}</translation>
    </message>
    <message>
        <source>&quot;{field}&quot; must be true or false</source>
        <translation>&quot;{field}&quot; muss true oder false sein</translation>
    </message>
    <message>
        <source>&quot;{field}&quot; must lie between 0 and 1</source>
        <translation>&quot;{field}&quot; muss zwischen 0 und 1 liegen</translation>
    </message>
    <message numerus="yes">
        <source>%n boiling frame(s)</source>
        <translation>
            <numerusform>%n flimmernder Frame</numerusform>
            <numerusform>%n flimmernde Frames</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n doubtful frame(s)</source>
        <translation>
            <numerusform>%n zweifelhafter Frame</numerusform>
            <numerusform>%n zweifelhafte Frames</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n doubtful frame(s): &lt;track.most_doubtful&gt; goes to the worst one.</source>
        <translation>
            <numerusform>%n zweifelhafter Frame: &lt;track.most_doubtful&gt; springt zum schlechtesten.</numerusform>
            <numerusform>%n zweifelhafte Frames: &lt;track.most_doubtful&gt; springt zum schlechtesten.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n doubtful frame(s): &lt;track.next_doubtful&gt; goes to the next one.</source>
        <translation>
            <numerusform>%n zweifelhafter Frame: &lt;track.next_doubtful&gt; springt zum nächsten.</numerusform>
            <numerusform>%n zweifelhafte Frames: &lt;track.next_doubtful&gt; springt zum nächsten.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n edit(s)</source>
        <translation>
            <numerusform>%n Bearbeitung</numerusform>
            <numerusform>%n Bearbeitungen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s)</source>
        <translation>
            <numerusform>%n Frame</numerusform>
            <numerusform>%n Frames</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s) back</source>
        <translation>
            <numerusform>%n Frame zurück</numerusform>
            <numerusform>%n Frames zurück</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s) is/are missing.</source>
        <translation>
            <numerusform>%n Frame fehlt.</numerusform>
            <numerusform>%n Frames fehlen.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s) on</source>
        <translation>
            <numerusform>%n Frame weiter</numerusform>
            <numerusform>%n Frames weiter</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n key(s)</source>
        <translation>
            <numerusform>%n Keyframe</numerusform>
            <numerusform>%n Keyframes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n layer(s)</source>
        <translation>
            <numerusform>%n Ebene</numerusform>
            <numerusform>%n Ebenen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n note(s)</source>
        <translation>
            <numerusform>%n Notiz</numerusform>
            <numerusform>%n Notizen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n page(s)</source>
        <translation>
            <numerusform>%n Seite</numerusform>
            <numerusform>%n Seiten</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n point(s) of it.</source>
        <translation>
            <numerusform>%n Punkt davon.</numerusform>
            <numerusform>%n Punkte davon.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n proposal(s) to answer: &lt;proposal.next&gt; goes there.</source>
        <translation>
            <numerusform>%n Vorschlag wartet auf Antwort: &lt;proposal.next&gt; springt dorthin.</numerusform>
            <numerusform>%n Vorschläge warten auf Antwort: &lt;proposal.next&gt; springt dorthin.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n selected row(s) is/are not in this list.</source>
        <translation>
            <numerusform>%n ausgewählte Zeile ist nicht in dieser Liste.</numerusform>
            <numerusform>%n ausgewählte Zeilen sind nicht in dieser Liste.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n shape(s)</source>
        <translation>
            <numerusform>%n Form</numerusform>
            <numerusform>%n Formen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n shape(s) is/are begun with the selected point now, on all keys.</source>
        <translation>
            <numerusform>%n Form beginnt jetzt mit dem ausgewählten Punkt, auf allen Keyframes.</numerusform>
            <numerusform>%n Formen beginnen jetzt mit dem ausgewählten Punkt, auf allen Keyframes.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n shape(s) is/are opened or closed now.</source>
        <translation>
            <numerusform>%n Form ist jetzt geöffnet oder geschlossen.</numerusform>
            <numerusform>%n Formen sind jetzt geöffnet oder geschlossen.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n shape(s) is/are reversed now, on all keys.</source>
        <translation>
            <numerusform>%n Form läuft jetzt andersherum, auf allen Keyframes.</numerusform>
            <numerusform>%n Formen laufen jetzt andersherum, auf allen Keyframes.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n shape(s) not tracked: their first keys lie ahead. Track from there, or set keys here (&lt;key.set&gt;).</source>
        <translation>
            <numerusform>%n Form nicht getrackt: ihre ersten Keyframes liegen voraus. Von dort tracken oder hier Keyframes setzen (&lt;key.set&gt;).</numerusform>
            <numerusform>%n Formen nicht getrackt: ihre ersten Keyframes liegen voraus. Von dort tracken oder hier Keyframes setzen (&lt;key.set&gt;).</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n shape(s) not tracked: their last keys lie ahead. Track from there, or set keys here (&lt;key.set&gt;).</source>
        <translation>
            <numerusform>%n Form nicht getrackt: ihre letzten Keyframes liegen voraus. Von dort tracken oder hier Keyframes setzen (&lt;key.set&gt;).</numerusform>
            <numerusform>%n Formen nicht getrackt: ihre letzten Keyframes liegen voraus. Von dort tracken oder hier Keyframes setzen (&lt;key.set&gt;).</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n tracked frame(s)</source>
        <translation>
            <numerusform>%n getrackter Frame</numerusform>
            <numerusform>%n getrackte Frames</numerusform>
        </translation>
    </message>
    <message>
        <source>&apos;the {what} of {name}&apos;</source>
        <translation>&apos;{what} von {name}&apos;</translation>
    </message>
    <message>
        <source>, a key</source>
        <translation>, ein Keyframe</translation>
    </message>
    <message>
        <source>, and joins its even feather roughly</source>
        <translation>, und schließt grob an die gleichmäßige weiche Kante an</translation>
    </message>
    <message>
        <source>, worth a look</source>
        <translation>, einen Blick wert</translation>
    </message>
    <message>
        <source>, {count} missing</source>
        <translation>, {count} fehlen</translation>
    </message>
    <message>
        <source>.
Now: {level}, {changes}</source>
        <translation>.
Jetzt: {level}, {changes}</translation>
    </message>
    <message>
        <source>. Stale: what it was made from has changed, track it again</source>
        <translation>. Veraltet: Die Grundlage hat sich geändert, bitte neu tracken</translation>
    </message>
    <message>
        <source>1 frame, {each:.0f} ms</source>
        <translation>1 Frame, {each:.0f} ms</translation>
    </message>
    <message>
        <source>1 key</source>
        <translation>1 Keyframe</translation>
    </message>
    <message>
        <source>100 %</source>
        <translation>100 %</translation>
    </message>
    <message>
        <source>1001,1010-1020 or 1001-1048x5, x10 for every tenth, all, keys, notes, doubtful or boil</source>
        <translation>1001,1010-1020 oder 1001-1048x5, x10 für jeden zehnten, alle, Keyframes, Notizen, zweifelhafte oder Flimmern</translation>
    </message>
    <message>
        <source>16 bits</source>
        <translation>16 Bit</translation>
    </message>
    <message>
        <source>24 of 23.976 fps × 0.125</source>
        <translation>24 von 23,976 fps × 0,125</translation>
    </message>
    <message>
        <source>8 bits</source>
        <translation>8 Bit</translation>
    </message>
    <message>
        <source>: out of sight</source>
        <translation>: außer Sicht</translation>
    </message>
    <message>
        <source>: worth a look</source>
        <translation>: einen Blick wert</translation>
    </message>
    <message>
        <source>; confidence {confidence:.2f}</source>
        <translation>; Konfidenz {confidence:.2f}</translation>
    </message>
    <message>
        <source>; not held on frame {frames}</source>
        <translation>; nicht gehalten auf Frame {frames}</translation>
    </message>
    <message>
        <source>; what came after them is damaged</source>
        <translation>; was danach kam, ist beschädigt</translation>
    </message>
    <message>
        <source>&lt;track.backward&gt; tracks back.</source>
        <translation>&lt;track.backward&gt; trackt rückwärts.</translation>
    </message>
    <message>
        <source>&lt;track.forward&gt; tracks forward.</source>
        <translation>&lt;track.forward&gt; trackt vorwärts.</translation>
    </message>
    <message>
        <source>A closed shape needs at least {min_points_closed} points; click to place more.</source>
        <translation>Eine geschlossene Form braucht mindestens {min_points_closed} Punkte; weitere durch Klicken setzen.</translation>
    </message>
    <message>
        <source>A contact sheet has {least} to {most} {what}, not {number}.</source>
        <translation>Ein Kontaktbogen hat {least} bis {most} {what}, nicht {number}.</translation>
    </message>
    <message>
        <source>A contact sheet is written as PNG; {name} does not end in .png.</source>
        <translation>Ein Kontaktbogen wird als PNG geschrieben; {name} endet nicht auf .png.</translation>
    </message>
    <message>
        <source>A copy of {name}; save to keep it.</source>
        <translation>Eine Kopie von {name}; bleibt nur, wenn sie gespeichert wird.</translation>
    </message>
    <message>
        <source>A hidden shape takes no part in the matte</source>
        <translation>Eine ausgeblendete Form zählt nicht zur Matte</translation>
    </message>
    <message>
        <source>A key of your own</source>
        <translation>Eine eigene Taste</translation>
    </message>
    <message>
        <source>A key on each so many frames; 0: at both ends of the range alone</source>
        <translation>Ein Keyframe alle so viele Frames; 0: nur an beiden Enden des Bereichs</translation>
    </message>
    <message>
        <source>A keyframe of {name} has no frame number: it was left out.</source>
        <translation>Ein Keyframe von {name} hat keine Framenummer und entfällt.</translation>
    </message>
    <message>
        <source>A layer has no colour of its own: copy a shape, and select shapes.</source>
        <translation>Eine Ebene hat keine eigene Farbe: eine Form kopieren und Formen auswählen.</translation>
    </message>
    <message>
        <source>A layer was copied, and its properties go to layers: select one, or copy a shape.</source>
        <translation>Kopiert ist eine Ebene, deren Eigenschaften Ebenen bekommen: eine auswählen, oder eine Form kopieren.</translation>
    </message>
    <message>
        <source>A locked shape cannot be changed by hand</source>
        <translation>Eine gesperrte Form lässt sich nicht von Hand ändern</translation>
    </message>
    <message>
        <source>A mask of shape {shape} has its channels first; give one of them, such as mask[0].</source>
        <translation>Eine Maske der Form {shape} hat ihre Kanäle vorn; einen davon geben, etwa mask[0].</translation>
    </message>
    <message>
        <source>A mask of shape {shape} is no image; give one of (height, width) pixels.</source>
        <translation>Eine Maske der Form {shape} ist kein Bild; eine mit (Höhe, Breite) Pixeln geben.</translation>
    </message>
    <message>
        <source>A mask of {name} is damaged and was left out ({reason}).</source>
        <translation>Eine Maske von {name} ist beschädigt und entfällt ({reason}).</translation>
    </message>
    <message>
        <source>A matte of {width} x {height} pixels cannot be encoded as PNG.</source>
        <translation>Eine Matte von {width} x {height} Pixeln lässt sich nicht als PNG kodieren.</translation>
    </message>
    <message>
        <source>A movie ends in {suffixes}; pictures go to a folder.</source>
        <translation>Ein Film endet auf {suffixes}; Bilder kommen in einen Ordner.</translation>
    </message>
    <message>
        <source>A movie or pictures of the outlines or the cut-out, to show</source>
        <translation>Ein Film oder Bilder der Umrisse oder des Freistellers, zum Zeigen</translation>
    </message>
    <message>
        <source>A movie runs at {least:g} to {most:g} frames a second, not at {fps:g}; choose another speed.</source>
        <translation>Ein Film läuft mit {least:g} bis {most:g} Frames pro Sekunde, nicht mit {fps:g}; eine andere Geschwindigkeit wählen.</translation>
    </message>
    <message>
        <source>A part hangs by joints on the parts that it overlaps</source>
        <translation>Ein Teil hängt über Gelenke an den Teilen, die er überlappt</translation>
    </message>
    <message>
        <source>A point lies outside of the picture, or under what is left out: put it elsewhere.</source>
        <translation>Ein Punkt liegt außerhalb des Bildes oder unter dem, was ausgelassen wird: anderswohin setzen.</translation>
    </message>
    <message>
        <source>A point that is dragged, enlarged</source>
        <translation>Ein Punkt, der gezogen wird, vergrößert</translation>
    </message>
    <message>
        <source>A polygon of {name} is damaged and was left out.</source>
        <translation>Ein Polygon von {name} ist beschädigt und entfällt.</translation>
    </message>
    <message>
        <source>A short shot to try everything on</source>
        <translation>Ein kurzer Shot, um alles auszuprobieren</translation>
    </message>
    <message>
        <source>A spline is a path alone; give the filter of {name}: {settings}.</source>
        <translation>Ein Spline ist nur ein Pfad; dem Filter von {name} fehlt noch: {settings}.</translation>
    </message>
    <message>
        <source>A spline is always there: switch off or cut the filter of {name} where it is not.</source>
        <translation>Ein Spline ist immer da: den Filter von {name} abschalten oder schneiden, wo er fehlen soll.</translation>
    </message>
    <message>
        <source>A still picture has no shutter: that of {name!r} is left out.</source>
        <translation>Ein Standbild hat keinen Verschluss: Der von {name!r} entfällt.</translation>
    </message>
    <message>
        <source>About ROAM</source>
        <translation>Über ROAM</translation>
    </message>
    <message>
        <source>About ROAM…</source>
        <translation>Über ROAM…</translation>
    </message>
    <message>
        <source>About the middle of what is selected.</source>
        <translation>Um die Mitte der Auswahl.</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Aktion</translation>
    </message>
    <message>
        <source>Actions</source>
        <translation>Aktionen</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Addieren</translation>
    </message>
    <message>
        <source>Add an empty layer, to drop shapes on</source>
        <translation>Leere Ebene anlegen, auf die sich Formen ziehen lassen</translation>
    </message>
    <message>
        <source>Adjust key</source>
        <translation>Korrektur-Keyframe</translation>
    </message>
    <message>
        <source>Adjust key on frame {frame}: what it changes is spread to the adjust keys beside it.</source>
        <translation>Korrektur-Keyframe auf Frame {frame}: Die Änderung verteilt sich bis zu den Korrektur-Keyframes daneben.</translation>
    </message>
    <message>
        <source>Adjust key on frame {here}: the track is right here.</source>
        <translation>Korrektur-Keyframe auf Frame {here}: Hier stimmt der Track.</translation>
    </message>
    <message>
        <source>Adjust track</source>
        <translation>Track korrigieren</translation>
    </message>
    <message>
        <source>After</source>
        <translation>Danach</translation>
    </message>
    <message>
        <source>After Effects masks (script)</source>
        <translation>After-Effects-Masken (Skript)</translation>
    </message>
    <message>
        <source>After Effects&apos; feather points lie square to the outline: the feather curve of {name!r} keeps its width at each point, not its handles.</source>
        <translation>Kantenpunkte von After Effects liegen senkrecht zum Umriss: Die weiche Kante von {name!r} behält ihre Breite an jedem Punkt, nicht ihre Tangenten.</translation>
    </message>
    <message>
        <source>After Effects&apos; shutter is the composition&apos;s: that of {name!r} is left out.</source>
        <translation>In After Effects gilt der Verschluss der Komposition: Der von {name!r} entfällt.</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alle</translation>
    </message>
    <message>
        <source>All channels</source>
        <translation>Alle Kanäle</translation>
    </message>
    <message>
        <source>All keys and notes, or those of what is selected, later or earlier</source>
        <translation>Alle Keyframes und Notizen oder die der Auswahl früher oder später setzen</translation>
    </message>
    <message>
        <source>All of them, or those between in and out; artist keys stay</source>
        <translation>Alle oder die zwischen In und Out; eigene Keyframes bleiben</translation>
    </message>
    <message>
        <source>All other visible shapes lie before the surface</source>
        <translation>Alle anderen sichtbaren Formen liegen vor der Fläche</translation>
    </message>
    <message>
        <source>All pixels</source>
        <translation>Alle Pixel</translation>
    </message>
    <message>
        <source>All settings as they were at first; keys stay</source>
        <translation>Alle Einstellungen wie am Anfang; Tasten bleiben</translation>
    </message>
    <message>
        <source>All shapes</source>
        <translation>Alle Formen</translation>
    </message>
    <message>
        <source>All shapes together</source>
        <translation>Alle Formen zusammen</translation>
    </message>
    <message>
        <source>Alpha alone</source>
        <translation>Nur Alpha</translation>
    </message>
    <message>
        <source>Also of those that are not selected</source>
        <translation>Auch von denen, die nicht ausgewählt sind</translation>
    </message>
    <message>
        <source>Alt+arrows</source>
        <translation>Alt+Pfeiltasten</translation>
    </message>
    <message>
        <source>Always</source>
        <translation>Immer</translation>
    </message>
    <message>
        <source>An edit changes all keys of the in/out range alike</source>
        <translation>Eine Änderung gilt gleichermaßen für alle Keyframes von In bis Out</translation>
    </message>
    <message>
        <source>An edit keys only the points that it moves</source>
        <translation>Eine Änderung setzt nur für die bewegten Punkte Keyframes</translation>
    </message>
    <message>
        <source>An error inside ROAM ended the work: {error}. Help &gt; Problem report… tells more.</source>
        <translation>Ein Fehler in ROAM hat die Arbeit beendet: {error}. Hilfe &gt; Problembericht… sagt mehr.</translation>
    </message>
    <message>
        <source>An offset of {offset} would number frames beyond {most}; choose a smaller one.</source>
        <translation>Ein Versatz von {offset} würde Frames jenseits von {most} nummerieren; einen kleineren wählen.</translation>
    </message>
    <message>
        <source>An opacity or feather has a key on frame {frame}; Nuke rounds those beyond {most}.</source>
        <translation>Eine Deckkraft oder weiche Kante hat einen Keyframe auf Frame {frame}; Nuke rundet jenseits von {most}.</translation>
    </message>
    <message>
        <source>An outline of {name} is damaged and was left out.</source>
        <translation>Ein Umriss von {name} ist beschädigt und entfällt.</translation>
    </message>
    <message>
        <source>Annotations without an image of the file were left out.</source>
        <translation>Annotationen ohne ein Bild der Datei entfallen.</translation>
    </message>
    <message>
        <source>Another colour…</source>
        <translation>Andere Farbe…</translation>
    </message>
    <message>
        <source>Another version of the plate below the same shapes</source>
        <translation>Eine andere Version der Plate unter denselben Formen</translation>
    </message>
    <message>
        <source>Another view of the same frame</source>
        <translation>Eine andere Ansicht desselben Frames</translation>
    </message>
    <message>
        <source>Around the shapes only</source>
        <translation>Nur um die Formen</translation>
    </message>
    <message>
        <source>Artist keys only</source>
        <translation>Nur eigene Keyframes</translation>
    </message>
    <message>
        <source>As few as hold the outline</source>
        <translation>So wenige, dass der Umriss hält</translation>
    </message>
    <message>
        <source>As many as there are</source>
        <translation>Alle vorhandenen</translation>
    </message>
    <message>
        <source>As one new object</source>
        <translation>Als ein neues Objekt</translation>
    </message>
    <message>
        <source>As one: {link}</source>
        <translation>Als eines: {link}</translation>
    </message>
    <message>
        <source>As opened</source>
        <translation>Wie geöffnet</translation>
    </message>
    <message>
        <source>As stacked</source>
        <translation>Wie gestapelt</translation>
    </message>
    <message>
        <source>As stacked from here</source>
        <translation>Wie gestapelt ab hier</translation>
    </message>
    <message>
        <source>As the desktop</source>
        <translation>Wie im System</translation>
    </message>
    <message>
        <source>Ask again</source>
        <translation>Erneut fragen</translation>
    </message>
    <message>
        <source>Asked for in the Help menu; no error was noted.</source>
        <translation>Im Hilfemenü angefordert; kein Fehler wurde festgestellt.</translation>
    </message>
    <message>
        <source>At the pointer, where it is over the viewer</source>
        <translation>Am Zeiger, wo er über dem Viewer steht</translation>
    </message>
    <message>
        <source>Attach to neighbours</source>
        <translation>An Nachbarn hängen</translation>
    </message>
    <message>
        <source>Attached</source>
        <translation>Angehängt</translation>
    </message>
    <message>
        <source>Auto-key</source>
        <translation>Auto-Key</translation>
    </message>
    <message>
        <source>B-spline</source>
        <translation>B-Spline</translation>
    </message>
    <message>
        <source>BSD 3-Clause licence, copyright the ROAM developers. The libraries beneath it:</source>
        <translation>BSD-3-Clause-Lizenz, Copyright die Entwickler von ROAM. Die Bibliotheken darunter:</translation>
    </message>
    <message>
        <source>Back and forth</source>
        <translation>Hin und her</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Hintergrund</translation>
    </message>
    <message>
        <source>Backups</source>
        <translation>Sicherungen</translation>
    </message>
    <message>
        <source>Backups of ROAM projects (*.roam.*)</source>
        <translation>Sicherungen von ROAM-Projekten (*.roam.*)</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Davor</translation>
    </message>
    <message>
        <source>Begin again at the end of the range</source>
        <translation>Am Ende des Bereichs wieder von vorn</translation>
    </message>
    <message>
        <source>Begin and end softly after the chosen keys or this one</source>
        <translation>Nach den gewählten Keyframes oder diesem weich beginnen und enden</translation>
    </message>
    <message>
        <source>Behind</source>
        <translation>Dahinter</translation>
    </message>
    <message>
        <source>Behind from here</source>
        <translation>Dahinter ab hier</translation>
    </message>
    <message>
        <source>Bend the chosen keys of values smoothly</source>
        <translation>Die gewählten Keyframes von Werten glatt führen</translation>
    </message>
    <message>
        <source>Besides:</source>
        <translation>Außerdem:</translation>
    </message>
    <message>
        <source>Between in and out, {first} to {last}, no frame is tracked.</source>
        <translation>Zwischen In und Out, {first} bis {last}, ist kein Frame getrackt.</translation>
    </message>
    <message>
        <source>Bezier</source>
        <translation>Bézier</translation>
    </message>
    <message>
        <source>Black</source>
        <translation>Schwarz</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>Mischen</translation>
    </message>
    <message>
        <source>Blender blurs masks in its compositor: the shutter of {name!r} is left out.</source>
        <translation>Blender zeichnet Masken im Compositor weich: Der Verschluss von {name!r} entfällt.</translation>
    </message>
    <message>
        <source>Blender cuts masks off where pixels are this narrow: {name!r} reaches beyond the middle {rows:.0f} of {height} rows.</source>
        <translation>Blender schneidet Masken bei so schmalen Pixeln ab: {name!r} reicht über die mittleren {rows:.0f} von {height} Zeilen hinaus.</translation>
    </message>
    <message>
        <source>Blender cuts names after {longest_name} bytes: {name!r}... is one.</source>
        <translation>Blender kürzt Namen nach {longest_name} Bytes: {name!r}... ist so einer.</translation>
    </message>
    <message>
        <source>Blender mask (script)</source>
        <translation>Blender-Maske (Skript)</translation>
    </message>
    <message>
        <source>Blender softens edges by up to {pixels:.1f} pixels in a picture of {width} x {height}.</source>
        <translation>Blender macht Kanten um bis zu {pixels:.1f} Pixel weicher, in einem Bild von {width} x {height}.</translation>
    </message>
    <message>
        <source>Blender&apos;s feather lies square to the outline: the feather curve of {name!r} keeps its width at each point, not its handles.</source>
        <translation>Blenders weiche Kante liegt senkrecht zum Umriss: Die von {name!r} behält ihre Breite an jedem Punkt, nicht ihre Tangenten.</translation>
    </message>
    <message>
        <source>Blender&apos;s feather slides from key to key: that of {name!r}, which steps, does so during the last frame before each step.</source>
        <translation>Blenders weiche Kante gleitet von Keyframe zu Keyframe: Die von {name!r}, die springt, tut das im letzten Frame vor jedem Sprung.</translation>
    </message>
    <message>
        <source>Blender&apos;s masks slide from key to key: {name!r}, which steps {count} times, does so during the last frame before each step.</source>
        <translation>Blenders Masken gleiten von Keyframe zu Keyframe: {name!r}, mit {count} Sprüngen, tut das im letzten Frame vor jedem Sprung.</translation>
    </message>
    <message>
        <source>Blender&apos;s masks slide from key to key: {name!r}, which steps, becomes {layers} layers, one for each stretch between steps.</source>
        <translation>Blenders Masken gleiten von Keyframe zu Keyframe: Aus {name!r}, das springt, werden {layers} Ebenen, eine für jede Strecke zwischen Sprüngen.</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>Blau</translation>
    </message>
    <message>
        <source>Boil</source>
        <translation>Flimmern</translation>
    </message>
    <message>
        <source>Boil is measured by the picture.</source>
        <translation>Das Flimmern ist am Bild gemessen.</translation>
    </message>
    <message>
        <source>Boil is measured when what is being written has ended.</source>
        <translation>Das Flimmern wird gemessen, sobald fertig geschrieben ist.</translation>
    </message>
    <message>
        <source>Box or click an object: a shape is fitted to it</source>
        <translation>Rahmen oder Klick auf ein Objekt: Eine Form wird angepasst</translation>
    </message>
    <message>
        <source>Box the object or click on it; before that, Shift+click marks more of it and Ctrl+click what is not.</source>
        <translation>Objekt einrahmen oder anklicken; davor markiert Umschalt+Klick mehr davon und Strg+Klick, was nicht dazugehört.</translation>
    </message>
    <message>
        <source>Break a tangent; from an anchor: pull its handles out</source>
        <translation>Tangente brechen; von einem Punkt aus: Tangenten herausziehen</translation>
    </message>
    <message>
        <source>Brightness alone, and back</source>
        <translation>Nur Helligkeit, und zurück</translation>
    </message>
    <message>
        <source>Browse…</source>
        <translation>Auswählen…</translation>
    </message>
    <message>
        <source>By</source>
        <translation>Um</translation>
    </message>
    <message>
        <source>By itself</source>
        <translation>Für sich</translation>
    </message>
    <message>
        <source>By outlines</source>
        <translation>Nach Umrissen</translation>
    </message>
    <message>
        <source>By outlines again: shapes that overlap are parts</source>
        <translation>Wieder nach Umrissen: Formen, die sich überlappen, sind Teile</translation>
    </message>
    <message>
        <source>COCO has no mode &apos;difference&apos;: {name!r} is an object of its own.</source>
        <translation>COCO hat keinen Modus Differenz: {name!r} ist ein eigenes Objekt.</translation>
    </message>
    <message>
        <source>COCO instances</source>
        <translation>COCO-Instanzen</translation>
    </message>
    <message>
        <source>CVAT</source>
        <translation>CVAT</translation>
    </message>
    <message>
        <source>CVAT counts pictures without gaps, and {plate} lacks {count}: fill them, or from frame {first} on shapes lie on other pictures there.</source>
        <translation>CVAT zählt Bilder ohne Lücken, und in {plate} fehlen {count}: Füllen Sie sie, sonst liegen Formen dort ab Frame {first} auf anderen Bildern.</translation>
    </message>
    <message>
        <source>CVAT for video</source>
        <translation>CVAT für Video</translation>
    </message>
    <message>
        <source>CVAT has no layers of masks: {name!r} loses {lost}.</source>
        <translation>CVAT hat keine Maskenebenen: {name!r} verliert {lost}.</translation>
    </message>
    <message>
        <source>CVAT hides no tracks in a file: the invisible {name} is seen there.</source>
        <translation>CVAT blendet in Dateien keine Tracks aus: Das unsichtbare {name} ist dort zu sehen.</translation>
    </message>
    <message>
        <source>CVAT&apos;s masks were left out; export the task as COCO, whose masks ROAM reads.</source>
        <translation>Masken aus CVAT entfallen; die Aufgabe als COCO exportieren, dessen Masken ROAM liest.</translation>
    </message>
    <message>
        <source>CVAT&apos;s {kind} was left out: ROAM reads outlines only.</source>
        <translation>{kind} aus CVAT entfällt: ROAM liest nur Umrisse.</translation>
    </message>
    <message>
        <source>Cannot allocate memory</source>
        <translation>Der Arbeitsspeicher reicht nicht</translation>
    </message>
    <message>
        <source>Change keys</source>
        <translation>Tasten ändern</translation>
    </message>
    <message>
        <source>Change keys…</source>
        <translation>Tasten ändern…</translation>
    </message>
    <message>
        <source>Change the reach of soft selection, of the brush</source>
        <translation>Reichweite der weichen Auswahl oder des Pinsels ändern</translation>
    </message>
    <message>
        <source>Channels of one file</source>
        <translation>Kanäle einer Datei</translation>
    </message>
    <message>
        <source>Checkerboard</source>
        <translation>Schachbrett</translation>
    </message>
    <message>
        <source>Choose keys in the timeline first: click one, or drag a box around several.</source>
        <translation>Zuerst Keyframes in der Zeitleiste wählen: einen anklicken oder um mehrere einen Rahmen ziehen.</translation>
    </message>
    <message>
        <source>Choose keys of opacity or feather in the timeline or the curve editor first.</source>
        <translation>Zuerst Keyframes von Deckkraft oder Feather in der Zeitleiste oder im Kurveneditor wählen.</translation>
    </message>
    <message>
        <source>Choose keys on two frames at least, in the timeline or the curve editor.</source>
        <translation>Keyframes auf mindestens zwei Frames wählen, in der Zeitleiste oder im Kurveneditor.</translation>
    </message>
    <message>
        <source>Choose the shapes that lie before the surface, one by one</source>
        <translation>Die Formen einzeln wählen, die vor der Fläche liegen</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen…</translation>
    </message>
    <message>
        <source>Cineon log</source>
        <translation>Cineon-Log</translation>
    </message>
    <message>
        <source>Clear in and out</source>
        <translation>In und Out löschen</translation>
    </message>
    <message>
        <source>Click along an edge: the line clings to it, straight with Ctrl. Return or the first point closes.</source>
        <translation>Entlang einer Kante klicken: Die Linie schmiegt sich an, mit Strg gerade. Eingabe oder der erste Punkt schließt.</translation>
    </message>
    <message>
        <source>Click control points around the object. Return or the first point closes, Esc leaves it open.</source>
        <translation>Kontrollpunkte um das Objekt klicken. Eingabe oder der erste Punkt schließt, Esc lässt offen.</translation>
    </message>
    <message>
        <source>Click for a corner, drag for a curve. Return or the first point closes, Esc leaves it open.</source>
        <translation>Klicken für eine Ecke, ziehen für eine Kurve. Eingabe oder der erste Punkt schließt, Esc lässt offen.</translation>
    </message>
    <message>
        <source>Click for each corner. Return or the first point closes, Esc leaves it open.</source>
        <translation>Jede Ecke anklicken. Eingabe oder der erste Punkt schließt, Esc lässt offen.</translation>
    </message>
    <message>
        <source>Click here, then press the new key</source>
        <translation>Hier klicken, dann die neue Taste drücken</translation>
    </message>
    <message>
        <source>Click on the object, inside of the picture.</source>
        <translation>Auf das Objekt klicken, innerhalb des Bildes.</translation>
    </message>
    <message>
        <source>Click one, two or four marks, then &lt;planar.forward&gt;; Ctrl and the wheel size their areas.</source>
        <translation>Ein, zwei oder vier Marken klicken, dann &lt;planar.forward&gt;; Strg und Mausrad ändern ihre Bereiche.</translation>
    </message>
    <message>
        <source>Click or box the object to find it, Return finds what is marked.</source>
        <translation>Objekt anklicken oder einrahmen, um es zu finden; Eingabe findet das Markierte.</translation>
    </message>
    <message>
        <source>Click selects, a drag moves; beside the outlines it frames points. Ctrl+Alt and a click add a point.</source>
        <translation>Klicken wählt, Ziehen bewegt; neben den Umrissen rahmt es Punkte ein. Strg+Alt+Klick fügt einen Punkt ein.</translation>
    </message>
    <message>
        <source>Clip settings</source>
        <translation>Clip-Einstellungen</translation>
    </message>
    <message>
        <source>Clip settings…</source>
        <translation>Clip-Einstellungen…</translation>
    </message>
    <message>
        <source>Clips</source>
        <translation>Clips</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Close a shape being drawn, leave it open</source>
        <translation>Gezeichnete Form schließen, offen lassen</translation>
    </message>
    <message>
        <source>Closed</source>
        <translation>Geschlossen</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Colour of the outline</source>
        <translation>Farbe des Umrisses</translation>
    </message>
    <message>
        <source>Colour under the cut-out</source>
        <translation>Farbe unter dem Freisteller</translation>
    </message>
    <message>
        <source>Colour {number}</source>
        <translation>Farbe {number}</translation>
    </message>
    <message>
        <source>Colours, layer, frames per second and pixels of the clip</source>
        <translation>Farben, Ebene, Frames pro Sekunde und Pixel des Clips</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleichen</translation>
    </message>
    <message>
        <source>Compare what is shown now with what will be: drag the line</source>
        <translation>Vergleichen, was jetzt zu sehen ist, mit dem, was kommt: Linie ziehen</translation>
    </message>
    <message>
        <source>Compare with what is shown now, in place of what was pinned</source>
        <translation>Mit dem vergleichen, was jetzt zu sehen ist, statt mit dem zuvor Gemerkten</translation>
    </message>
    <message>
        <source>Confidence</source>
        <translation>Konfidenz</translation>
    </message>
    <message>
        <source>Confidence is {confidence:.2f} at least.</source>
        <translation>Die Konfidenz ist mindestens {confidence:.2f}.</translation>
    </message>
    <message>
        <source>Confidence of the tracked frames; under the dashed line a frame is worth a look. Click to go there</source>
        <translation>Konfidenz der getrackten Frames; unter der gestrichelten Linie ist ein Frame einen Blick wert. Klicken springt hin</translation>
    </message>
    <message>
        <source>Confidence: thin and blue is sure, broad and orange is doubtful, grey is not the engine&apos;s</source>
        <translation>Konfidenz: dünn und blau ist sicher, breit und orange ist zweifelhaft, grau ist nicht von der Engine</translation>
    </message>
    <message>
        <source>Connection timed out</source>
        <translation>Die Verbindung antwortet nicht</translation>
    </message>
    <message>
        <source>Contact sheet</source>
        <translation>Kontaktbogen</translation>
    </message>
    <message>
        <source>Contact sheet…</source>
        <translation>Kontaktbogen…</translation>
    </message>
    <message>
        <source>Copied the key of frame {frame}: paste puts it on another frame.</source>
        <translation>Keyframe von Frame {frame} kopiert: Einfügen setzt ihn auf einen anderen Frame.</translation>
    </message>
    <message>
        <source>Copied {keys}: paste puts the first one on the playhead&apos;s frame.</source>
        <translation>{keys} kopiert: Einfügen setzt den ersten auf den Frame des Abspielkopfs.</translation>
    </message>
    <message>
        <source>Copied {shapes} for {program}; paste there.</source>
        <translation>{shapes} für {program} kopiert; dort einfügen.</translation>
    </message>
    <message>
        <source>Copied {shapes}.</source>
        <translation>{shapes} kopiert.</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copy all messages</source>
        <translation>Alle Meldungen kopieren</translation>
    </message>
    <message>
        <source>Copy for Fusion</source>
        <translation>Für Fusion kopieren</translation>
    </message>
    <message>
        <source>Copy for Nuke</source>
        <translation>Für Nuke kopieren</translation>
    </message>
    <message>
        <source>Copy key</source>
        <translation>Keyframe kopieren</translation>
    </message>
    <message>
        <source>Copy keys</source>
        <translation>Keyframes kopieren</translation>
    </message>
    <message>
        <source>Copy the report</source>
        <translation>Bericht kopieren</translation>
    </message>
    <message>
        <source>Copy the selected shapes</source>
        <translation>Ausgewählte Formen kopieren</translation>
    </message>
    <message>
        <source>Copy the selected shapes as they are on this frame</source>
        <translation>Ausgewählte Formen kopieren, wie sie auf diesem Frame sind</translation>
    </message>
    <message>
        <source>Copy {keys} {frames}: {first} to {last}.</source>
        <translation>{keys} {frames} kopieren: {first} nach {last}.</translation>
    </message>
    <message>
        <source>Copying for {program} …</source>
        <translation>Kopieren für {program} …</translation>
    </message>
    <message>
        <source>Corner pin</source>
        <translation>Eckpunkt versetzen</translation>
    </message>
    <message>
        <source>Corner pin {dx:+.1f}, {dy:+.1f} px</source>
        <translation>Eckpunkt versetzen {dx:+.1f}, {dy:+.1f} px</translation>
    </message>
    <message>
        <source>Cryptomatte</source>
        <translation>Cryptomatte</translation>
    </message>
    <message>
        <source>Cryptomatte cannot tell {other!r} from {word!r}: it knows both by {bits:08x}. Give one of them another name.</source>
        <translation>Cryptomatte kann {other!r} nicht von {word!r} unterscheiden: Es kennt beide als {bits:08x}. Eines davon anders nennen.</translation>
    </message>
    <message>
        <source>Cryptomatte is {own} deep, not {depth}: its numbers stand for names.</source>
        <translation>Cryptomatte ist {own} tief, nicht {depth}: Seine Zahlen stehen für Namen.</translation>
    </message>
    <message>
        <source>Ctrl+Alt+click</source>
        <translation>Strg+Alt+Klick</translation>
    </message>
    <message>
        <source>Ctrl+Alt+click on an outline inserts a point there; a drag is a lasso.</source>
        <translation>Strg+Alt+Klick auf einen Umriss fügt dort einen Punkt ein; Ziehen ist ein Lasso.</translation>
    </message>
    <message>
        <source>Ctrl+Alt+drag</source>
        <translation>Strg+Alt+Ziehen</translation>
    </message>
    <message>
        <source>Ctrl+drag</source>
        <translation>Strg+Ziehen</translation>
    </message>
    <message>
        <source>Ctrl+wheel</source>
        <translation>Strg+Mausrad</translation>
    </message>
    <message>
        <source>Curve editor</source>
        <translation>Kurveneditor</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>Kurven</translation>
    </message>
    <message>
        <source>Curves are written as polygons that stray from them by at most {tolerance:g} px.</source>
        <translation>Kurven werden als Polygone geschrieben, die um höchstens {tolerance:g} px abweichen.</translation>
    </message>
    <message>
        <source>Curves carried through a shot</source>
        <translation>Kurven, durch den Shot getragen</translation>
    </message>
    <message>
        <source>Curves of {name}</source>
        <translation>Kurven von {name}</translation>
    </message>
    <message numerus="yes">
        <source>Cusp %n point(s)</source>
        <translation>
            <numerusform>%n Punkt zur Ecke machen</numerusform>
            <numerusform>%n Punkte zu Ecken machen</numerusform>
        </translation>
    </message>
    <message>
        <source>Cusp points</source>
        <translation>Punkte zu Ecken</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Ausschneiden</translation>
    </message>
    <message>
        <source>Cut keys</source>
        <translation>Keyframes ausschneiden</translation>
    </message>
    <message>
        <source>Cut the selected shapes</source>
        <translation>Ausgewählte Formen ausschneiden</translation>
    </message>
    <message>
        <source>Cut-out</source>
        <translation>Freisteller</translation>
    </message>
    <message>
        <source>Cuts a hole into what lies under it</source>
        <translation>Schneidet ein Loch in das, was darunter liegt</translation>
    </message>
    <message>
        <source>Cutting out …</source>
        <translation>Freistellen …</translation>
    </message>
    <message>
        <source>Defaults</source>
        <translation>Standard</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message numerus="yes">
        <source>Delete %n point(s)</source>
        <translation>
            <numerusform>%n Punkt löschen</numerusform>
            <numerusform>%n Punkte löschen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Delete %n shape(s)</source>
        <translation>
            <numerusform>%n Form löschen</numerusform>
            <numerusform>%n Formen löschen</numerusform>
        </translation>
    </message>
    <message>
        <source>Delete all keys</source>
        <translation>Alle Keyframes löschen</translation>
    </message>
    <message>
        <source>Delete key</source>
        <translation>Keyframe löschen</translation>
    </message>
    <message>
        <source>Delete keys</source>
        <translation>Keyframes löschen</translation>
    </message>
    <message>
        <source>Delete shape</source>
        <translation>Form löschen</translation>
    </message>
    <message>
        <source>Delete the keys of the selected shapes on this frame</source>
        <translation>Keyframes der ausgewählten Formen auf diesem Frame löschen</translation>
    </message>
    <message>
        <source>Delete the selected points or shapes</source>
        <translation>Ausgewählte Punkte oder Formen löschen</translation>
    </message>
    <message>
        <source>Delete the selected shapes and layers</source>
        <translation>Ausgewählte Formen und Ebenen löschen</translation>
    </message>
    <message>
        <source>Delete tracked frames</source>
        <translation>Getrackte Frames löschen</translation>
    </message>
    <message numerus="yes">
        <source>Deleted %n tracked frame(s) from {first} to {last}.</source>
        <translation>
            <numerusform>%n getrackter Frame von {first} bis {last} gelöscht.</numerusform>
            <numerusform>%n getrackte Frames von {first} bis {last} gelöscht.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Deleted %n tracked frame(s).</source>
        <translation>
            <numerusform>%n getrackter Frame gelöscht.</numerusform>
            <numerusform>%n getrackte Frames gelöscht.</numerusform>
        </translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>Detach</source>
        <translation>Lösen</translation>
    </message>
    <message>
        <source>Device or resource busy</source>
        <translation>Das Gerät oder die Datei wird gerade benutzt</translation>
    </message>
    <message>
        <source>Dials that were turned and are not offered (any more) stay at 100 %: {names}.</source>
        <translation>Regler, die verstellt waren und nicht (mehr) angeboten werden, bleiben bei 100 %: {names}.</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Differenz</translation>
    </message>
    <message>
        <source>Disk quota exceeded</source>
        <translation>Der zugeteilte Speicherplatz ist aufgebraucht</translation>
    </message>
    <message>
        <source>Display and view, for looking only: {shown}</source>
        <translation>Anzeige und Ansicht, nur zum Betrachten: {shown}</translation>
    </message>
    <message>
        <source>Dissolve the layer; its shapes stay as they are seen</source>
        <translation>Ebene auflösen; ihre Formen bleiben, wie sie zu sehen sind</translation>
    </message>
    <message>
        <source>Do anything by a few letters of its name</source>
        <translation>Alles finden und ausführen, mit ein paar Buchstaben seines Namens</translation>
    </message>
    <message>
        <source>Do not offer again</source>
        <translation>Nicht mehr anbieten</translation>
    </message>
    <message>
        <source>Do what?</source>
        <translation>Was tun?</translation>
    </message>
    <message>
        <source>Doubtful frames</source>
        <translation>Zweifelhafte Frames</translation>
    </message>
    <message>
        <source>Drag a free line about points, not a rectangle</source>
        <translation>Freie Linie um Punkte ziehen statt eines Rechtecks</translation>
    </message>
    <message>
        <source>Drag around the object; end near the start to close it. Zoom in or press a pen harder for a finer fit.</source>
        <translation>Um das Objekt ziehen; nahe am Anfang enden schließt die Form. Hineinzoomen oder stärkerer Stiftdruck passt feiner an.</translation>
    </message>
    <message>
        <source>Drag from corner to corner of the ellipse. Shift: a circle. Ctrl: from its centre.</source>
        <translation>Von Ecke zu Ecke der Ellipse ziehen. Umschalt: Kreis. Strg: von der Mitte aus.</translation>
    </message>
    <message>
        <source>Drag from corner to corner of the rectangle. Shift: a square. Ctrl: from its centre.</source>
        <translation>Von Ecke zu Ecke des Rechtecks ziehen. Umschalt: Quadrat. Strg: von der Mitte aus.</translation>
    </message>
    <message>
        <source>Drag out of a point of the selected shape to soften its edge; double-click a feather point to take it back.</source>
        <translation>Aus einem Punkt der gewählten Form ziehen, um die Kante weich zu machen; Doppelklick auf einen Kantenpunkt nimmt es zurück.</translation>
    </message>
    <message>
        <source>Drag the corners to where they belong on this frame, or the inside to move all; Return says: right here.</source>
        <translation>Ecken dorthin ziehen, wo sie auf diesem Frame hingehören, oder innen ziehen, um alle zu bewegen; Eingabe heißt: stimmt hier.</translation>
    </message>
    <message>
        <source>Drag to change; Shift: faster, Ctrl: finer</source>
        <translation>Ziehen ändert; Umschalt: schneller, Strg: feiner</translation>
    </message>
    <message>
        <source>Drag to pull the points under the brush. Ctrl+wheel or Ctrl+drag changes its size, a pen&apos;s pressure too.</source>
        <translation>Ziehen bewegt die Punkte unter dem Pinsel. Strg+Mausrad oder Strg+Ziehen ändert seine Größe, auch der Stiftdruck.</translation>
    </message>
    <message>
        <source>Drag to scrub, wheel to zoom, Shift+wheel to pan, double-click to see the whole clip</source>
        <translation>Ziehen zum Scrubben, Mausrad zum Zoomen, Umschalt+Mausrad zum Verschieben, Doppelklick zeigt den ganzen Clip</translation>
    </message>
    <message>
        <source>Drag to stretch the chosen keys in time</source>
        <translation>Ziehen streckt die gewählten Keyframes in der Zeit</translation>
    </message>
    <message>
        <source>Draw a Bezier shape: click corners, drag curves</source>
        <translation>Bézier-Form zeichnen: Ecken klicken, Kurven ziehen</translation>
    </message>
    <message>
        <source>Draw a line that clings to the edges</source>
        <translation>Linie zeichnen, die sich an Kanten schmiegt</translation>
    </message>
    <message>
        <source>Draw a polygon</source>
        <translation>Polygon zeichnen</translation>
    </message>
    <message>
        <source>Draw a shape first: press &lt;tool.bezier&gt; in the viewer.</source>
        <translation>Zuerst eine Form zeichnen: &lt;tool.bezier&gt; im Viewer.</translation>
    </message>
    <message>
        <source>Draw a shape: press &lt;tool.bezier&gt;</source>
        <translation>Form zeichnen: &lt;tool.bezier&gt; drücken</translation>
    </message>
    <message>
        <source>Draw a shape: press &lt;tool.bezier&gt; in the viewer,
click for corners, drag for curves.</source>
        <translation>Form zeichnen: &lt;tool.bezier&gt; im Viewer drücken,
klicken für Ecken, ziehen für Kurven.</translation>
    </message>
    <message>
        <source>Draw a smooth shape by its control points</source>
        <translation>Glatte Form durch ihre Kontrollpunkte zeichnen</translation>
    </message>
    <message>
        <source>Draw by hand; few points are fitted</source>
        <translation>Von Hand zeichnen; wenige Punkte werden angepasst</translation>
    </message>
    <message>
        <source>Draw shape</source>
        <translation>Form zeichnen</translation>
    </message>
    <message>
        <source>Drop a folder of images or a movie here</source>
        <translation>Hier einen Ordner mit Bildern oder einen Film ablegen</translation>
    </message>
    <message>
        <source>Drop part</source>
        <translation>Teil entfernen</translation>
    </message>
    <message>
        <source>Drop the part that came off {name}?</source>
        <translation>Den Teil entfernen, der sich von {name} gelöst hat?</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplizieren</translation>
    </message>
    <message>
        <source>EXR files only</source>
        <translation>Nur bei EXR-Dateien</translation>
    </message>
    <message numerus="yes">
        <source>Each key has a frame of its own: %n frame(s) at least.</source>
        <translation>
            <numerusform>Jeder Keyframe hat einen eigenen Frame: mindestens %n Frame.</numerusform>
            <numerusform>Jeder Keyframe hat einen eigenen Frame: mindestens %n Frames.</numerusform>
        </translation>
    </message>
    <message>
        <source>Each key keeps its place among them.</source>
        <translation>Jeder Keyframe behält seinen Platz unter ihnen.</translation>
    </message>
    <message>
        <source>Earlier steps were dropped</source>
        <translation>Ältere Schritte sind verworfen</translation>
    </message>
    <message>
        <source>Edges alone: for clean contours on a plain background.</source>
        <translation>Nur Kanten: für klare Konturen vor ruhigem Hintergrund.</translation>
    </message>
    <message>
        <source>Edges and nearby colours, carried along by landmarks: for objects with much texture.</source>
        <translation>Kanten und nahe Farben, von Landmarken getragen: für Objekte mit viel Textur.</translation>
    </message>
    <message>
        <source>Edges and the colours on both sides of them: for plain objects that move little.</source>
        <translation>Kanten und die Farben zu beiden Seiten: für schlichte Objekte, die sich wenig bewegen.</translation>
    </message>
    <message>
        <source>Edges, colours and landmarks; proposes to split a shape where the object comes apart. Slow.</source>
        <translation>Kanten, Farben und Landmarken; schlägt vor, eine Form zu teilen, wo das Objekt zerfällt. Langsam.</translation>
    </message>
    <message>
        <source>Edges: solid is free, dashed a seam, dotted is hidden</source>
        <translation>Kanten: durchgezogen frei, gestrichelt Naht, gepunktet verdeckt</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Bearbeiten</translation>
    </message>
    <message>
        <source>Edits make keys on their frames; off: they change keys around</source>
        <translation>Änderungen setzen Keyframes auf ihren Frames; aus: Sie ändern die Keyframes ringsum</translation>
    </message>
    <message>
        <source>Elements of the kind {kind} were left out: ROAM reads outlines only.</source>
        <translation>Elemente der Art {kind} entfallen: ROAM liest nur Umrisse.</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>Ellipse</translation>
    </message>
    <message>
        <source>Empty: what is shown only takes away, and nothing lies below it</source>
        <translation>Leer: Was gezeigt wird, nimmt nur weg, und nichts liegt darunter</translation>
    </message>
    <message>
        <source>Equalise the handles</source>
        <translation>Tangenten gleich lang machen</translation>
    </message>
    <message numerus="yes">
        <source>Erase %n point(s)</source>
        <translation>
            <numerusform>%n Punkt radieren</numerusform>
            <numerusform>%n Punkte radieren</numerusform>
        </translation>
    </message>
    <message>
        <source>Eraser</source>
        <translation>Radierer</translation>
    </message>
    <message>
        <source>Every</source>
        <translation>Alle</translation>
    </message>
    <message>
        <source>Every key</source>
        <translation>Jeder Keyframe</translation>
    </message>
    <message>
        <source>Every layer</source>
        <translation>Jede Ebene</translation>
    </message>
    <message>
        <source>Every part in its place, as in a new window</source>
        <translation>Jeder Teil an seinem Platz wie in einem neuen Fenster</translation>
    </message>
    <message>
        <source>Every shape</source>
        <translation>Jede Form</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Export anyway</source>
        <translation>Trotzdem exportieren</translation>
    </message>
    <message>
        <source>Export elsewhere…</source>
        <translation>Woandershin exportieren …</translation>
    </message>
    <message>
        <source>Export keys</source>
        <translation>Tasten exportieren</translation>
    </message>
    <message>
        <source>Export mattes to a folder</source>
        <translation>Mattes in einen Ordner exportieren</translation>
    </message>
    <message>
        <source>Export mattes…</source>
        <translation>Mattes exportieren…</translation>
    </message>
    <message>
        <source>Export selected shapes…</source>
        <translation>Ausgewählte Formen exportieren…</translation>
    </message>
    <message>
        <source>Export stopped; the files that are finished stay.</source>
        <translation>Export angehalten; die fertigen Dateien bleiben.</translation>
    </message>
    <message>
        <source>Export to Nuke</source>
        <translation>Nach Nuke exportieren</translation>
    </message>
    <message>
        <source>Export to Nuke…</source>
        <translation>Nach Nuke exportieren…</translation>
    </message>
    <message>
        <source>Export, although the mattes would differ in the other program?</source>
        <translation>Exportieren, obwohl die Mattes im anderen Programm abweichen würden?</translation>
    </message>
    <message>
        <source>Export: {title}</source>
        <translation>Export: {title}</translation>
    </message>
    <message numerus="yes">
        <source>Exported to {path} and %n other file(s) beside it.</source>
        <translation>
            <numerusform>Exportiert nach {path} und in %n weitere Datei daneben.</numerusform>
            <numerusform>Exportiert nach {path} und in %n weitere Dateien daneben.</numerusform>
        </translation>
    </message>
    <message>
        <source>Exported to {path}.</source>
        <translation>Exportiert nach {path}.</translation>
    </message>
    <message>
        <source>Exporting to {name} …</source>
        <translation>Export nach {name} …</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportieren…</translation>
    </message>
    <message>
        <source>Exposure in stops, for looking only</source>
        <translation>Belichtung in Blenden, nur zum Betrachten</translation>
    </message>
    <message>
        <source>Feather</source>
        <translation>Feather</translation>
    </message>
    <message>
        <source>Feather and shutter as the plate shows them, on all keys</source>
        <translation>Weiche Kante und Verschluss, wie die Plate sie zeigt, auf allen Keyframes</translation>
    </message>
    <message>
        <source>Feather for all keys</source>
        <translation>Feather für alle Keyframes</translation>
    </message>
    <message>
        <source>Feather handle</source>
        <translation>Feather-Tangente</translation>
    </message>
    <message>
        <source>Feather of the selected shapes, in pixels</source>
        <translation>Feather der ausgewählten Formen, in Pixeln</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>File exists</source>
        <translation>Die Datei gibt es schon</translation>
    </message>
    <message>
        <source>File name too long</source>
        <translation>Der Dateiname ist zu lang</translation>
    </message>
    <message>
        <source>File too large</source>
        <translation>Die Datei ist zu groß</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Dateien</translation>
    </message>
    <message>
        <source>Files of their own</source>
        <translation>Eigene Dateien</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>Füllen</translation>
    </message>
    <message>
        <source>Fill between keys</source>
        <translation>Zwischen Keyframes füllen</translation>
    </message>
    <message>
        <source>Filled already: nothing that it depends on has changed.</source>
        <translation>Schon gefüllt: Nichts, wovon es abhängt, hat sich geändert.</translation>
    </message>
    <message>
        <source>Filled the frames {first} to {last}.</source>
        <translation>Frames {first} bis {last} gefüllt.</translation>
    </message>
    <message>
        <source>Filled {count} gaps between frames {first} and {last}.</source>
        <translation>{count} Lücken zwischen den Frames {first} und {last} gefüllt.</translation>
    </message>
    <message>
        <source>Filled {done} of {all} pieces on {count} processes</source>
        <translation>{done} von {all} Teilen gefüllt, auf {count} Prozessen</translation>
    </message>
    <message>
        <source>Filling between keys</source>
        <translation>Zwischen Keyframes wird gefüllt</translation>
    </message>
    <message>
        <source>Filling frames {first} to {last}</source>
        <translation>Frames {first} bis {last} werden gefüllt</translation>
    </message>
    <message>
        <source>Filling stopped after the gap up to frame {frame}; its frames were taken back.</source>
        <translation>Füllen angehalten nach der Lücke bis Frame {frame}; seine Frames wurden zurückgenommen.</translation>
    </message>
    <message>
        <source>Filling stopped after the gap up to frame {frame}; the finished frames stay.</source>
        <translation>Füllen angehalten nach der Lücke bis Frame {frame}; die fertigen Frames bleiben.</translation>
    </message>
    <message>
        <source>Filling stopped before a gap was finished.</source>
        <translation>Füllen angehalten, bevor eine Lücke fertig war.</translation>
    </message>
    <message>
        <source>Filling {names} begins when the fill under way has ended.</source>
        <translation>Das Füllen von {names} beginnt, sobald das laufende zu Ende ist.</translation>
    </message>
    <message>
        <source>Filling {names} begins when the planar track has ended.</source>
        <translation>Das Füllen von {names} beginnt, sobald der Flächen-Track zu Ende ist.</translation>
    </message>
    <message>
        <source>Find an action…</source>
        <translation>Aktion finden…</translation>
    </message>
    <message>
        <source>Find by name or layer</source>
        <translation>Nach Name oder Ebene suchen</translation>
    </message>
    <message>
        <source>Find in the list</source>
        <translation>In der Liste suchen</translation>
    </message>
    <message>
        <source>Find object</source>
        <translation>Objekt finden</translation>
    </message>
    <message>
        <source>Finding the object …</source>
        <translation>Objekt wird gesucht …</translation>
    </message>
    <message>
        <source>Fine tuning</source>
        <translation>Feinabstimmung</translation>
    </message>
    <message>
        <source>Fine tuning, changed</source>
        <translation>Feinabstimmung, geändert</translation>
    </message>
    <message>
        <source>Firmness</source>
        <translation>Festigkeit</translation>
    </message>
    <message>
        <source>First frame</source>
        <translation>Erster Frame</translation>
    </message>
    <message>
        <source>First frame on which the shape exists</source>
        <translation>Erster Frame, auf dem die Form existiert</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Einpassen</translation>
    </message>
    <message>
        <source>Fit shapes to a folder of mask pictures</source>
        <translation>Formen an einen Ordner mit Maskenbildern anpassen</translation>
    </message>
    <message>
        <source>Fit shapes to a picture of this frame&apos;s mask</source>
        <translation>Formen an ein Bild der Maske dieses Frames anpassen</translation>
    </message>
    <message>
        <source>Fit time</source>
        <translation>Zeit einpassen</translation>
    </message>
    <message>
        <source>Float</source>
        <translation>Float</translation>
    </message>
    <message>
        <source>Float: Curve editor</source>
        <translation>Abdocken: Kurveneditor</translation>
    </message>
    <message>
        <source>Float: History</source>
        <translation>Abdocken: Verlauf</translation>
    </message>
    <message>
        <source>Float: Messages</source>
        <translation>Abdocken: Meldungen</translation>
    </message>
    <message>
        <source>Float: Planar track</source>
        <translation>Abdocken: Flächen-Track</translation>
    </message>
    <message>
        <source>Float: Review</source>
        <translation>Abdocken: Review</translation>
    </message>
    <message>
        <source>Float: Second viewer</source>
        <translation>Abdocken: Zweiter Viewer</translation>
    </message>
    <message>
        <source>Float: Shape</source>
        <translation>Abdocken: Form</translation>
    </message>
    <message>
        <source>Float: Shapes</source>
        <translation>Abdocken: Formen</translation>
    </message>
    <message>
        <source>Float: Timeline</source>
        <translation>Abdocken: Zeitleiste</translation>
    </message>
    <message>
        <source>Float: Track</source>
        <translation>Abdocken: Tracking</translation>
    </message>
    <message>
        <source>Fold or unfold</source>
        <translation>Ein- oder ausklappen</translation>
    </message>
    <message>
        <source>Follow all</source>
        <translation>Allen folgen</translation>
    </message>
    <message>
        <source>Follow the surface in the shapes</source>
        <translation>Der Fläche in den Formen folgen</translation>
    </message>
    <message>
        <source>Follow the surface in the shapes back</source>
        <translation>Der Fläche in den Formen rückwärts folgen</translation>
    </message>
    <message>
        <source>Followed {what} to frame {last}: {done} frames. {verdict}</source>
        <translation>{what} bis Frame {last} verfolgt: {done} Frames. {verdict}</translation>
    </message>
    <message>
        <source>Follows the whole object by colour and motion: the surest on most shots, and the quickest.</source>
        <translation>Folgt dem ganzen Objekt nach Farbe und Bewegung: in den meisten Shots am sichersten und am schnellsten.</translation>
    </message>
    <message>
        <source>For decoding pictures and for the engine</source>
        <translation>Zum Lesen der Bilder und für die Engine</translation>
    </message>
    <message>
        <source>For filling many frames; 1: ROAM itself does it all</source>
        <translation>Zum Füllen vieler Frames; 1: alles macht ROAM selbst</translation>
    </message>
    <message>
        <source>Forget all keys of your own</source>
        <translation>Alle eigenen Tasten vergessen</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>Four points are enough: drag one of them, or take one back with Backspace.</source>
        <translation>Vier Punkte genügen: einen davon ziehen oder mit der Rücktaste einen zurücknehmen.</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Frame</translation>
    </message>
    <message>
        <source>Frame number</source>
        <translation>Framenummer</translation>
    </message>
    <message>
        <source>Frame of the first key</source>
        <translation>Frame des ersten Keyframes</translation>
    </message>
    <message>
        <source>Frame of the last key</source>
        <translation>Frame des letzten Keyframes</translation>
    </message>
    <message>
        <source>Frame rate</source>
        <translation>Bildrate</translation>
    </message>
    <message>
        <source>Frame selection</source>
        <translation>Auswahl einpassen</translation>
    </message>
    <message>
        <source>Frame {frame}</source>
        <translation>Frame {frame}</translation>
    </message>
    <message>
        <source>Frame {frame} is marked; double-click the mark to write a note.</source>
        <translation>Frame {frame} ist markiert; Doppelklick auf die Markierung schreibt eine Notiz.</translation>
    </message>
    <message>
        <source>Frame {frame} is missing from the plate, or damaged</source>
        <translation>Frame {frame} fehlt in der Plate oder ist beschädigt</translation>
    </message>
    <message>
        <source>Frame {frame} is not read; go to it again to try.</source>
        <translation>Frame {frame} wird nicht gelesen; dorthin gehen, um es noch einmal zu versuchen.</translation>
    </message>
    <message>
        <source>Frame {frame} is {size}, frame {first} is {other}; all frames of a span must have one size.</source>
        <translation>Frame {frame} ist {size}, Frame {first} ist {other}; alle Frames einer Strecke müssen gleich groß sein.</translation>
    </message>
    <message>
        <source>Frame {frame} is {size}, the one before {other}; all frames of a shot need one size.</source>
        <translation>Frame {frame} ist {size}, der davor {other}; alle Frames eines Shots müssen gleich groß sein.</translation>
    </message>
    <message>
        <source>Frame {frame} lies outside of the clip&apos;s, which are {first} to {last}.</source>
        <translation>Frame {frame} liegt außerhalb des Clips mit den Frames {first} bis {last}.</translation>
    </message>
    <message>
        <source>Frame {frame} of {path} cannot be decoded; the movie is damaged or cut short.</source>
        <translation>Frame {frame} von {path} lässt sich nicht dekodieren; der Film ist beschädigt oder abgeschnitten.</translation>
    </message>
    <message>
        <source>Frame {frame} of {path} differs in size from the first; a plate needs one size.</source>
        <translation>Frame {frame} von {path} hat eine andere Größe als der erste; alle Frames einer Plate brauchen dieselbe.</translation>
    </message>
    <message>
        <source>Frame {frame} of {path} is missing: the files there are {first} to {last}, with {count} missing between.</source>
        <translation>Frame {frame} von {path} fehlt: dort liegen die Dateien {first} bis {last}, dazwischen fehlen {count}.</translation>
    </message>
    <message>
        <source>Frame {frame} of {path} is missing: the files there are {first} to {last}.</source>
        <translation>Frame {frame} von {path} fehlt: dort liegen die Dateien {first} bis {last}.</translation>
    </message>
    <message>
        <source>Frame {frame} of {path} is missing: the movie has the frames 1 to {last}.</source>
        <translation>Frame {frame} von {path} fehlt: der Film hat die Frames 1 bis {last}.</translation>
    </message>
    <message>
        <source>Frame {frame} of {path} is missing: {file} is no longer there.</source>
        <translation>Frame {frame} von {path} fehlt: {file} ist nicht mehr da.</translation>
    </message>
    <message>
        <source>Frame {frame} of {refusal}</source>
        <translation>Frame {frame} von {refusal}</translation>
    </message>
    <message>
        <source>Frame {frame} shows nothing; track from a frame that does.</source>
        <translation>Frame {frame} zeigt nichts; von einem Frame aus tracken, der etwas zeigt.</translation>
    </message>
    <message>
        <source>Frame {frame}, {kind}</source>
        <translation>Frame {frame}, {kind}</translation>
    </message>
    <message>
        <source>Frame {frame}.</source>
        <translation>Frame {frame}.</translation>
    </message>
    <message>
        <source>Frame {frame}: an adjust key of {name}
Click to go there, right-click to remove it</source>
        <translation>Frame {frame}: ein Korrektur-Keyframe von {name}
Klicken springt hin, Rechtsklick entfernt ihn</translation>
    </message>
    <message>
        <source>Frame {frame}: the confidence of the track {name} is {trust:.2f}.</source>
        <translation>Frame {frame}: Die Konfidenz des Tracks {name} ist {trust:.2f}.</translation>
    </message>
    <message>
        <source>Frame {frame}: the confidence of {name} is {confidence:.2f}.{rings}</source>
        <translation>Frame {frame}: Die Konfidenz von {name} ist {confidence:.2f}.{rings}</translation>
    </message>
    <message>
        <source>Frame {frame}: {name} boils by {pixels:.1f} px.</source>
        <translation>Frame {frame}: {name} flimmert um {pixels:.1f} px.</translation>
    </message>
    <message>
        <source>Frame {frame}: {text}</source>
        <translation>Frame {frame}: {text}</translation>
    </message>
    <message>
        <source>Frame {frame}: {text}, {value}.</source>
        <translation>Frame {frame}: {text}, {value}.</translation>
    </message>
    <message>
        <source>Frame {frame}: {told}</source>
        <translation>Frame {frame}: {told}</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Frames</translation>
    </message>
    <message>
        <source>Frames a second of the movie</source>
        <translation>Frames pro Sekunde des Films</translation>
    </message>
    <message>
        <source>Frames after this one</source>
        <translation>Frames nach diesem</translation>
    </message>
    <message>
        <source>Frames before this one</source>
        <translation>Frames vor diesem</translation>
    </message>
    <message>
        <source>Frames from one outline to the next</source>
        <translation>Frames von einem Umriss zum nächsten</translation>
    </message>
    <message>
        <source>Frames without a picture are left out of the images: {count}, the first is {first}.</source>
        <translation>Frames ohne Bild fehlen unter den Bildern: {count}, der erste ist {first}.</translation>
    </message>
    <message>
        <source>Frames worth a look</source>
        <translation>Frames, die einen Blick wert sind</translation>
    </message>
    <message>
        <source>Free edges, which the picture shows, solid; seams of an object dashed; what a nearer part hides dotted</source>
        <translation>Freie Kanten, die das Bild zeigt, durchgezogen; Nähte eines Objekts gestrichelt; was ein näherer Teil verdeckt, gepunktet</translation>
    </message>
    <message>
        <source>Freehand</source>
        <translation>Freihand</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>From frame</source>
        <translation>Ab Frame</translation>
    </message>
    <message>
        <source>From here on {where}</source>
        <translation>Von hier an {where}</translation>
    </message>
    <message>
        <source>From mask image…</source>
        <translation>Aus Maskenbild…</translation>
    </message>
    <message>
        <source>From the next start on</source>
        <translation>Ab dem nächsten Start</translation>
    </message>
    <message>
        <source>From this frame on</source>
        <translation>Ab diesem Frame</translation>
    </message>
    <message>
        <source>From this frame on the others hide the shapes</source>
        <translation>Ab diesem Frame verdecken die anderen die Formen</translation>
    </message>
    <message>
        <source>From this frame on the shapes hide the others</source>
        <translation>Ab diesem Frame verdecken die Formen die anderen</translation>
    </message>
    <message>
        <source>From this frame on what hides what goes by the list</source>
        <translation>Ab diesem Frame gilt die Reihenfolge der Liste</translation>
    </message>
    <message>
        <source>Full resolution</source>
        <translation>Volle Auflösung</translation>
    </message>
    <message>
        <source>Full-screen viewer</source>
        <translation>Viewer im Vollbild</translation>
    </message>
    <message>
        <source>Fusion / DaVinci Resolve masks</source>
        <translation>Fusion-/DaVinci-Resolve-Masken</translation>
    </message>
    <message>
        <source>Fusion softens on both sides of an outline: {name!r} may look a little different.</source>
        <translation>Fusion zeichnet zu beiden Seiten eines Umrisses weich: {name!r} kann etwas anders aussehen.</translation>
    </message>
    <message>
        <source>Gamma, for looking only</source>
        <translation>Gamma, nur zum Betrachten</translation>
    </message>
    <message>
        <source>Give the key to this action; the other one goes without it</source>
        <translation>Die Taste dieser Aktion geben; die andere verliert sie</translation>
    </message>
    <message>
        <source>Give the keyboard to the next part of the window</source>
        <translation>Die Tastatur dem nächsten Teil des Fensters geben</translation>
    </message>
    <message>
        <source>Give the keyboard to the part before</source>
        <translation>Die Tastatur dem Teil davor geben</translation>
    </message>
    <message>
        <source>Give the selected B-splines handles; no outline changes</source>
        <translation>Den ausgewählten B-Splines Tangenten geben; kein Umriss ändert sich</translation>
    </message>
    <message>
        <source>Give the selected shapes control points: smooth everywhere</source>
        <translation>Den ausgewählten Formen Kontrollpunkte geben: überall glatt</translation>
    </message>
    <message>
        <source>Give the soft edge as it is here to every key</source>
        <translation>Die weiche Kante, wie sie hier ist, jedem Keyframe geben</translation>
    </message>
    <message>
        <source>Give the timeline half of the window</source>
        <translation>Der Zeitleiste das halbe Fenster geben</translation>
    </message>
    <message>
        <source>Give this action the keys of the preset again</source>
        <translation>Dieser Aktion wieder die Tasten der Vorgabe geben</translation>
    </message>
    <message>
        <source>Go one key, or change of depth, of the shapes in hand back</source>
        <translation>Einen Keyframe oder Tiefenwechsel der aktiven Formen zurück</translation>
    </message>
    <message>
        <source>Go one key, or change of depth, of the shapes in hand on</source>
        <translation>Einen Keyframe oder Tiefenwechsel der aktiven Formen weiter</translation>
    </message>
    <message>
        <source>Go to the frame that the engine trusts least</source>
        <translation>Zum Frame springen, dem die Engine am wenigsten traut</translation>
    </message>
    <message>
        <source>Go to the mark or note after this frame</source>
        <translation>Zur Markierung oder Notiz nach diesem Frame springen</translation>
    </message>
    <message>
        <source>Go to the mark or note before this frame</source>
        <translation>Zur Markierung oder Notiz vor diesem Frame springen</translation>
    </message>
    <message>
        <source>Go to the next frame on which the engine proposes a change</source>
        <translation>Zum nächsten Frame springen, auf dem die Engine eine Änderung vorschlägt</translation>
    </message>
    <message>
        <source>Go to the next frame worth fixing: where confidence is low, or the outline boils</source>
        <translation>Zum nächsten Frame springen, der eine Korrektur wert ist: wo die Konfidenz niedrig ist oder der Umriss flimmert</translation>
    </message>
    <message>
        <source>Gone with what was dissolved: {what}.</source>
        <translation>Mit dem Aufgelösten entfallen: {what}.</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>Grün</translation>
    </message>
    <message>
        <source>Grey</source>
        <translation>Grau</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Gruppieren</translation>
    </message>
    <message>
        <source>Group into a layer</source>
        <translation>Zu Ebene gruppieren</translation>
    </message>
    <message>
        <source>Half float</source>
        <translation>Half Float</translation>
    </message>
    <message>
        <source>Have the chosen keys lie between two frames, evenly spread</source>
        <translation>Die gewählten Keyframes gleichmäßig zwischen zwei Frames verteilen</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Ausblenden</translation>
    </message>
    <message>
        <source>Hide layer</source>
        <translation>Ebene ausblenden</translation>
    </message>
    <message>
        <source>Hide shapes</source>
        <translation>Formen ausblenden</translation>
    </message>
    <message>
        <source>Hide the shapes while you look</source>
        <translation>Formen beim Betrachten ausblenden</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>Halten</translation>
    </message>
    <message>
        <source>Hold the copied key through a range of frames</source>
        <translation>Den kopierten Keyframe über einen Bereich von Frames halten</translation>
    </message>
    <message>
        <source>Holding Alt while dropping a clip opens it without a question</source>
        <translation>Wird beim Ablegen eines Clips Alt gehalten, öffnet er sich ohne Nachfrage</translation>
    </message>
    <message>
        <source>Hole of {name}</source>
        <translation>Loch in {name}</translation>
    </message>
    <message>
        <source>How far a curve may stray from its mask&apos;s outline on any frame, in pixels of the masks; of masks that tremble, a fifth of the outline may stray farther</source>
        <translation>Wie weit eine Kurve auf einem Frame vom Umriss ihrer Maske abweichen darf, in Pixeln der Masken; bei zitternden Masken darf ein Fünftel des Umrisses weiter abweichen</translation>
    </message>
    <message>
        <source>How far it reaches, in heights of an image pixel  (Ctrl+wheel in the viewer)</source>
        <translation>Wie weit es reicht, in Höhen eines Bildpixels  (Strg+Mausrad im Viewer)</translation>
    </message>
    <message>
        <source>How far the outline may go in one frame from where the motion puts it</source>
        <translation>Wie weit der Umriss in einem Frame von dort abweichen darf, wohin ihn die Bewegung setzt</translation>
    </message>
    <message>
        <source>How far the outline may stray from the tracked one when keys are left out</source>
        <translation>Wie weit der Umriss vom getrackten abweichen darf, wenn Keyframes entfallen</translation>
    </message>
    <message>
        <source>How far tracked keys may move so that shapes move evenly through time, in pixels of the plate;
your own keys stay where they are, and so does the project</source>
        <translation>Wie weit sich getrackte Keyframes verschieben dürfen, damit sich Formen gleichmäßig bewegen, in Pixeln der Plate;
eigene Keyframes bleiben, wo sie sind, und das Projekt auch</translation>
    </message>
    <message>
        <source>How firmly the outline keeps its form from frame to frame</source>
        <translation>Wie fest der Umriss von Frame zu Frame seine Form behält</translation>
    </message>
    <message>
        <source>How long the shutter is open; 0.5 is 180 degrees</source>
        <translation>Wie lange der Verschluss offen ist; 0,5 sind 180 Grad</translation>
    </message>
    <message>
        <source>How much the shapes in hand jitter beyond the motion of the plate: for shapes that bend as they move</source>
        <translation>Wie sehr die aktiven Formen über die Bewegung der Plate hinaus zittern: für Formen, die sich beim Bewegen biegen</translation>
    </message>
    <message>
        <source>How much your key&apos;s colours count beside later ones</source>
        <translation>Wie viel die Farben des eigenen Keyframes neben späteren zählen</translation>
    </message>
    <message>
        <source>How quickly new colours are learned; at 0 never</source>
        <translation>Wie schnell neue Farben gelernt werden; bei 0 nie</translation>
    </message>
    <message>
        <source>How smooth the edge is: less follows finer detail</source>
        <translation>Wie glatt die Kante ist: weniger folgt feineren Details</translation>
    </message>
    <message>
        <source>How strongly tracked edges are drawn to the motion of the picture. At 50 % they boil less by a tenth on rendered figures and by a twentieth on filmed shots, about a third of what tracking adds there to a drawn mask&apos;s own; at 100 % hardly less still. At 0 % nothing moves</source>
        <translation>Wie stark getrackte Kanten der Bewegung des Bildes folgen. Bei 50 % flimmern sie bei gerenderten Figuren um ein Zehntel und bei gefilmten Einstellungen um ein Zwanzigstel weniger, etwa ein Drittel dessen, was das Tracking dort zum Flimmern einer gezeichneten Maske hinzufügt; bei 100 % kaum noch weniger. Bei 0 % bewegt sich nichts</translation>
    </message>
    <message>
        <source>How strongly what is filled between two keys is drawn to the motion of the picture: as it is, edges boil less by a tenth on rendered figures; at 0 they stay as they were found</source>
        <translation>Wie stark das, was zwischen zwei Keyframes gefüllt wird, der Bewegung des Bildes folgt: so, wie es ist, flimmern Kanten bei gerenderten Figuren um ein Zehntel weniger; bei 0 bleiben sie, wie sie gefunden wurden</translation>
    </message>
    <message>
        <source>How the engine works</source>
        <translation>Wie die Engine arbeitet</translation>
    </message>
    <message>
        <source>How the engine works: what it looks at, and how long it takes</source>
        <translation>Wie die Engine arbeitet: worauf sie achtet und wie lange es dauert</translation>
    </message>
    <message>
        <source>How the joint matte of the layer joins what lies under it</source>
        <translation>Wie sich die gemeinsame Matte der Ebene mit dem verbindet, was darunter liegt</translation>
    </message>
    <message>
        <source>How the shape joins what lies under it in its layer</source>
        <translation>Wie sich die Form mit dem verbindet, was in ihrer Ebene darunter liegt</translation>
    </message>
    <message>
        <source>How the value goes on from its key here, or the last one before</source>
        <translation>Wie der Wert von seinem Keyframe hier oder dem letzten davor weitergeht</translation>
    </message>
    <message>
        <source>If both save, the later one wins. A copy is a project of its own, without a file until you save it.</source>
        <translation>Speichern beide, gewinnt der spätere. Eine Kopie ist ein eigenes Projekt, ohne Datei bis zum Speichern.</translation>
    </message>
    <message>
        <source>If you save anyway, what is in the file now stays beside it as a backup.</source>
        <translation>Wird trotzdem gespeichert, bleibt der jetzige Inhalt als Sicherung neben der Datei.</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importieren</translation>
    </message>
    <message>
        <source>Import keys</source>
        <translation>Tasten importieren</translation>
    </message>
    <message>
        <source>Import masks</source>
        <translation>Masken importieren</translation>
    </message>
    <message>
        <source>Import masks…</source>
        <translation>Masken importieren…</translation>
    </message>
    <message>
        <source>Import shapes</source>
        <translation>Formen importieren</translation>
    </message>
    <message>
        <source>Import shapes…</source>
        <translation>Formen importieren…</translation>
    </message>
    <message>
        <source>Import stopped.</source>
        <translation>Import angehalten.</translation>
    </message>
    <message>
        <source>Import the masks of a folder</source>
        <translation>Masken eines Ordners importieren</translation>
    </message>
    <message>
        <source>Import…</source>
        <translation>Importieren…</translation>
    </message>
    <message>
        <source>In front</source>
        <translation>Davor</translation>
    </message>
    <message>
        <source>In front from here</source>
        <translation>Davor ab hier</translation>
    </message>
    <message>
        <source>In the viewer</source>
        <translation>Im Viewer</translation>
    </message>
    <message>
        <source>In to out</source>
        <translation>In bis Out</translation>
    </message>
    <message>
        <source>In: frame {first}. Drag it</source>
        <translation>In: Frame {first}. Ziehen verschiebt</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>Fehler beim Lesen oder Schreiben des Datenträgers</translation>
    </message>
    <message>
        <source>Insert a point on the outline</source>
        <translation>Punkt auf dem Umriss einfügen</translation>
    </message>
    <message>
        <source>Insert point</source>
        <translation>Punkt einfügen</translation>
    </message>
    <message>
        <source>Inside moves, handles scale, Ctrl pins corners, sides shear, beside a corner turns; Shift, Ctrl vary it.</source>
        <translation>Innen bewegt, Anfasser skalieren, Strg versetzt eine Ecke allein, Seiten scheren, neben einer Ecke dreht; Umschalt, Strg variieren es.</translation>
    </message>
    <message>
        <source>Intersect</source>
        <translation>Schnittmenge</translation>
    </message>
    <message>
        <source>Invert</source>
        <translation>Invertieren</translation>
    </message>
    <message>
        <source>Invert layer</source>
        <translation>Ebene invertieren</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>Das ist ein Ordner</translation>
    </message>
    <message>
        <source>It goes on after what begins now.</source>
        <translation>Es geht nach dem weiter, was jetzt beginnt.</translation>
    </message>
    <message>
        <source>It has a key on this frame. Click to delete it</source>
        <translation>Keyframe auf diesem Frame. Klicken löscht ihn</translation>
    </message>
    <message>
        <source>It is locked; unlock it to change its keys.</source>
        <translation>Gesperrt; erst entsperrt lassen sich die Keyframes ändern.</translation>
    </message>
    <message>
        <source>It joins soft edges as older versions did (Plus), so that its mattes stay as they were; choose Add in the Shape panel where they are to join as in other programs.</source>
        <translation>Es verbindet weiche Kanten wie ältere Versionen (Plus), damit die Mattes bleiben, wie sie waren; Addieren im Formbereich verbindet sie wie in anderen Programmen.</translation>
    </message>
    <message>
        <source>It lies at the bottom already.</source>
        <translation>Liegt schon ganz unten.</translation>
    </message>
    <message>
        <source>It lies on top already.</source>
        <translation>Liegt schon ganz oben.</translation>
    </message>
    <message>
        <source>It never varies. Click to set a key on this frame</source>
        <translation>Ändert sich nie. Klicken setzt einen Keyframe auf diesem Frame</translation>
    </message>
    <message>
        <source>It runs smoothly through its key here, or the last one before, by tangents</source>
        <translation>Verläuft mit Tangenten glatt durch den Keyframe hier oder den letzten davor</translation>
    </message>
    <message>
        <source>It stays, and is found under File &gt; Recover work…</source>
        <translation>Sie bleibt und findet sich unter Datei &gt; Arbeit wiederherstellen…</translation>
    </message>
    <message>
        <source>It varies, without a key on this frame. Click to set one</source>
        <translation>Ändert sich, ohne Keyframe auf diesem Frame. Klicken setzt einen</translation>
    </message>
    <message>
        <source>Its plate is numbered from {first} now, not from {before}.</source>
        <translation>Seine Plate ist jetzt ab {first} nummeriert, nicht ab {before}.</translation>
    </message>
    <message>
        <source>Its shapes were restacked meanwhile.</source>
        <translation>Ihre Formen wurden inzwischen umgeordnet.</translation>
    </message>
    <message>
        <source>JSON (ROAM, COCO, MLT)</source>
        <translation>JSON (ROAM, COCO, MLT)</translation>
    </message>
    <message>
        <source>Joins with what lies under it, soft edges as one painted over the other</source>
        <translation>Verbindet sich mit dem, was darunter liegt, weiche Kanten wie übereinander gemalt</translation>
    </message>
    <message>
        <source>Joints: on frames with keys of yours alone</source>
        <translation>Gelenke: nur auf Frames mit eigenen Keyframes</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Annehmen</translation>
    </message>
    <message>
        <source>Keep it running</source>
        <translation>Weiterlaufen lassen</translation>
    </message>
    <message>
        <source>Keep the keys that the action has, and add the new one</source>
        <translation>Die Tasten der Aktion behalten und die neue hinzufügen</translation>
    </message>
    <message>
        <source>Keeps only what both cover</source>
        <translation>Behält nur, was beide bedecken</translation>
    </message>
    <message>
        <source>Keeps what one of both covers and the other does not</source>
        <translation>Behält, was eines von beiden bedeckt und das andere nicht</translation>
    </message>
    <message>
        <source>Kept: it is yours now. {key} tracks on from here.</source>
        <translation>Angenommen: Es gehört jetzt dazu. {key} trackt von hier weiter.</translation>
    </message>
    <message>
        <source>Key by hand of {count} of {all} points; the shape {moves}</source>
        <translation>Keyframe von Hand für {count} von {all} Punkten; die Form {moves}</translation>
    </message>
    <message>
        <source>Key by hand; the shape {moves}</source>
        <translation>Keyframe von Hand; die Form {moves}</translation>
    </message>
    <message>
        <source>Key colours</source>
        <translation>Keyframe-Farben</translation>
    </message>
    <message>
        <source>Key points</source>
        <translation>Punkt-Keyframes</translation>
    </message>
    <message>
        <source>Keymaps (*.json)</source>
        <translation>Tastenbelegungen (*.json)</translation>
    </message>
    <message>
        <source>Keys</source>
        <comment>of the keyboard</comment>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Keyframes</translation>
    </message>
    <message>
        <source>Keys of</source>
        <translation>Tasten von</translation>
    </message>
    <message>
        <source>Keys of opacity and feather</source>
        <translation>Keyframes von Deckkraft und Feather</translation>
    </message>
    <message>
        <source>Keys of other programs, and keys of your own</source>
        <translation>Tasten anderer Programme und eigene Tasten</translation>
    </message>
    <message>
        <source>Keys of shapes</source>
        <translation>Keyframes der Formen</translation>
    </message>
    <message>
        <source>Keys on frames {low} to {high} lie beside the clip now, which has {first} to {last}; &lt;key.shift&gt; shifts keys.</source>
        <translation>Keyframes auf den Frames {low} bis {high} liegen jetzt neben dem Clip, der {first} bis {last} hat; &lt;key.shift&gt; verschiebt Keyframes.</translation>
    </message>
    <message>
        <source>Keys were tracked {how}.</source>
        <translation>Getrackte Keyframes: {how}.</translation>
    </message>
    <message>
        <source>Keys, lifetimes, opacity and feather, depth and the motion of layers go along; the clip stays. Earlier is below zero.</source>
        <translation>Keyframes, Lebensdauer, Deckkraft und Feather, Tiefe und die Bewegung von Ebenen gehen mit; der Clip bleibt. Früher heißt: unter null.</translation>
    </message>
    <message>
        <source>Keys…</source>
        <translation>Tasten…</translation>
    </message>
    <message>
        <source>Labels are hard and opaque, without the {left} of {name!r}.</source>
        <translation>Labels sind hart und deckend, ohne {left} von {name!r}.</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>Lasso</source>
        <translation>Lasso</translation>
    </message>
    <message>
        <source>Lasso selection</source>
        <translation>Lasso-Auswahl</translation>
    </message>
    <message>
        <source>Last frame</source>
        <translation>Letzter Frame</translation>
    </message>
    <message>
        <source>Last frame on which the shape exists</source>
        <translation>Letzter Frame, auf dem die Form existiert</translation>
    </message>
    <message>
        <source>Last mark</source>
        <translation>Letzte Markierung</translation>
    </message>
    <message>
        <source>Last point</source>
        <translation>Letzten Punkt</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Später</translation>
    </message>
    <message>
        <source>Layer</source>
        <translation>Ebene</translation>
    </message>
    <message>
        <source>Layer blend</source>
        <translation>Mischmodus der Ebene</translation>
    </message>
    <message>
        <source>Layer opacity</source>
        <translation>Deckkraft der Ebene</translation>
    </message>
    <message>
        <source>Layer opacity: {text}</source>
        <translation>Deckkraft der Ebene: {text}</translation>
    </message>
    <message>
        <source>Learning</source>
        <translation>Lernen</translation>
    </message>
    <message>
        <source>Leave out all others</source>
        <translation>Alle anderen auslassen</translation>
    </message>
    <message>
        <source>Leave out chosen ones</source>
        <translation>Gewählte auslassen</translation>
    </message>
    <message>
        <source>Leave out nothing</source>
        <translation>Nichts auslassen</translation>
    </message>
    <message>
        <source>Leave out shapes above</source>
        <translation>Formen darüber auslassen</translation>
    </message>
    <message>
        <source>Leave the shape as it is</source>
        <translation>Die Form lassen, wie sie ist</translation>
    </message>
    <message>
        <source>Leave them</source>
        <translation>Nicht verschieben</translation>
    </message>
    <message>
        <source>Leave this action without a key</source>
        <translation>Diese Aktion ohne Taste lassen</translation>
    </message>
    <message>
        <source>Left as it is.</source>
        <translation>Bleibt, wie es ist.</translation>
    </message>
    <message>
        <source>Left out, for they are locked or no closed outlines: {shown}</source>
        <translation>Ausgelassen, weil gesperrt oder keine geschlossenen Umrisse: {shown}</translation>
    </message>
    <message>
        <source>Let go of all shapes, points and layers</source>
        <translation>Alle Formen, Punkte und Ebenen loslassen</translation>
    </message>
    <message>
        <source>Let parts hang by joints on those that they overlap</source>
        <translation>Teile mit Gelenken an die hängen, die sie überlappen</translation>
    </message>
    <message>
        <source>Let parts move free of those that they overlap</source>
        <translation>Teile von denen lösen, die sie überlappen</translation>
    </message>
    <message>
        <source>Let the layer stand still; every key stays where it is seen</source>
        <translation>Ebene stillstehen lassen; jeder Keyframe bleibt, wo er zu sehen ist</translation>
    </message>
    <message>
        <source>Let the selected shapes run the other way, on all keys</source>
        <translation>Die ausgewählten Formen andersherum laufen lassen, auf allen Keyframes</translation>
    </message>
    <message>
        <source>Let the shape begin with the selected point, on all keys</source>
        <translation>Die Form mit dem ausgewählten Punkt beginnen lassen, auf allen Keyframes</translation>
    </message>
    <message>
        <source>Let the view go along with what is selected: it stands still on the screen from frame to frame</source>
        <translation>Die Ansicht mit dem Ausgewählten mitgehen lassen: Es steht von Frame zu Frame still auf dem Bildschirm</translation>
    </message>
    <message>
        <source>Let what is selected count in the matte as what was copied; outlines and colours stay</source>
        <translation>Die Auswahl zählt in der Matte wie das Kopierte; Umrisse und Farben bleiben</translation>
    </message>
    <message>
        <source>Let what is selected look and count as what was copied; outlines, names and frames stay</source>
        <translation>Die Auswahl sieht aus und zählt wie das Kopierte; Umrisse, Namen und Frames bleiben</translation>
    </message>
    <message>
        <source>Libraries</source>
        <translation>Bibliotheken</translation>
    </message>
    <message>
        <source>Lifetime</source>
        <translation>Lebensdauer</translation>
    </message>
    <message>
        <source>Limited</source>
        <translation>Begrenzt</translation>
    </message>
    <message>
        <source>Linear</source>
        <translation>Linear</translation>
    </message>
    <message>
        <source>List only the shapes and layers that are called so</source>
        <translation>Nur die Formen und Ebenen auflisten, die so heißen</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>Sperren</translation>
    </message>
    <message>
        <source>Lock layer</source>
        <translation>Ebene sperren</translation>
    </message>
    <message>
        <source>Lock or unlock</source>
        <translation>Sperren oder entsperren</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>Gesperrt</translation>
    </message>
    <message>
        <source>Look at frame {frame}: confidence is {confidence:.2f} there.</source>
        <translation>Bitte Frame {frame} prüfen: Die Konfidenz ist dort {confidence:.2f}.</translation>
    </message>
    <message>
        <source>Looking at frame {frame}</source>
        <translation>Frame {frame} wird vermessen</translation>
    </message>
    <message>
        <source>Looking at the masks</source>
        <translation>Masken werden geprüft</translation>
    </message>
    <message>
        <source>Looking at the plate&apos;s edge …</source>
        <translation>Die Kante der Plate wird vermessen …</translation>
    </message>
    <message>
        <source>Looking at {name} …</source>
        <translation>{name} wird geprüft …</translation>
    </message>
    <message>
        <source>Looking for what the format cannot hold …</source>
        <translation>Prüfung, was das Format nicht halten kann …</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>Schleife</translation>
    </message>
    <message>
        <source>Lower</source>
        <translation>Nach unten</translation>
    </message>
    <message>
        <source>Luminance</source>
        <translation>Luminanz</translation>
    </message>
    <message>
        <source>MLT has no layers of masks: what {name!r} takes away within itself goes from all under it.</source>
        <translation>MLT hat keine Maskenebenen: Was {name!r} in sich wegnimmt, fehlt auch allem darunter.</translation>
    </message>
    <message>
        <source>MLT has no layers of masks: {name!r} loses {lost}.</source>
        <translation>MLT hat keine Maskenebenen: {name!r} verliert {lost}.</translation>
    </message>
    <message>
        <source>MLT has no mode {mode!r}: that of {name} is lost.</source>
        <translation>MLT hat keinen Modus {mode!r}: Der von {name} geht verloren.</translation>
    </message>
    <message>
        <source>MLT has no motion blur: that of {name} is left out.</source>
        <translation>MLT hat keine Bewegungsunschärfe: Die von {name} entfällt.</translation>
    </message>
    <message>
        <source>MLT has one feather all around: the feather curve of {name} is lost.</source>
        <translation>MLT hat eine weiche Kante rundum: Die Kurve der weichen Kante von {name} geht verloren.</translation>
    </message>
    <message>
        <source>MLT rotoscoping (Kdenlive, Shotcut)</source>
        <translation>MLT-Rotoskopie (Kdenlive, Shotcut)</translation>
    </message>
    <message>
        <source>MLT&apos;s rotoscoping has no opacity: that of {name} is lost.</source>
        <translation>Die Rotoskopie von MLT hat keine Deckkraft: Die von {name} geht verloren.</translation>
    </message>
    <message>
        <source>MLT&apos;s splines are closed: the open {name!r} is left out.</source>
        <translation>Splines von MLT sind geschlossen: Das offene {name!r} entfällt.</translation>
    </message>
    <message>
        <source>Magnetic lasso</source>
        <translation>Magnetisches Lasso</translation>
    </message>
    <message>
        <source>Magnifier</source>
        <translation>Lupe</translation>
    </message>
    <message>
        <source>Make B-spline</source>
        <translation>Zu B-Spline machen</translation>
    </message>
    <message>
        <source>Make Bezier</source>
        <translation>Zu Bézier machen</translation>
    </message>
    <message>
        <source>Make the change that the engine proposes here</source>
        <translation>Die Änderung ausführen, die die Engine hier vorschlägt</translation>
    </message>
    <message>
        <source>Make the selected points yours here</source>
        <translation>Die ausgewählten Punkte hier zu eigenen machen</translation>
    </message>
    <message>
        <source>Make the selected shapes, as they are here, artist keys</source>
        <translation>Aus den ausgewählten Formen, wie sie hier sind, eigene Keyframes machen</translation>
    </message>
    <message>
        <source>Make this change, and every one proposed for this shape</source>
        <translation>Diese Änderung ausführen und jede weitere, die für diese Form vorgeschlagen wird</translation>
    </message>
    <message>
        <source>Mark frame</source>
        <translation>Frame markieren</translation>
    </message>
    <message>
        <source>Mark this frame, or take its mark away</source>
        <translation>Diesen Frame markieren oder seine Markierung entfernen</translation>
    </message>
    <message>
        <source>Marks</source>
        <translation>Markierungen</translation>
    </message>
    <message>
        <source>Mask of frame {frame}</source>
        <translation>Maske von Frame {frame}</translation>
    </message>
    <message>
        <source>Mask pictures</source>
        <translation>Maskenbilder</translation>
    </message>
    <message>
        <source>Mask pictures (*.png *.tif *.tiff *.jpg *.jpeg *.exr);;All files (*)</source>
        <translation>Maskenbilder (*.png *.tif *.tiff *.jpg *.jpeg *.exr);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Masks cannot be hidden in After Effects: {name!r} has the mode None instead of {blend}.</source>
        <translation>Masken lassen sich in After Effects nicht ausblenden: {name!r} hat den Modus „Ohne“ statt {blend}.</translation>
    </message>
    <message>
        <source>Masks have no keys of an artist&apos;s; ask for every key or for reduced ones.</source>
        <translation>Masken haben keine von Hand gesetzten Keyframes; alle oder reduzierte Keyframes verlangen.</translation>
    </message>
    <message>
        <source>Masks of the kind {kind} are not read.</source>
        <translation>Masken der Art {kind} werden nicht gelesen.</translation>
    </message>
    <message>
        <source>Match the plate&apos;s edge</source>
        <translation>An Kante der Plate anpassen</translation>
    </message>
    <message>
        <source>Matte</source>
        <translation>Matte</translation>
    </message>
    <message>
        <source>Matte of frame {frame}</source>
        <translation>Matte von Frame {frame}</translation>
    </message>
    <message>
        <source>Mattes (PNG, EXR, TIFF)</source>
        <translation>Mattes (PNG, EXR, TIFF)</translation>
    </message>
    <message>
        <source>Mattes are written as PNG, EXR or TIFF; {name} would be none of these.</source>
        <translation>Mattes werden als PNG, EXR oder TIFF geschrieben; {name} wäre nichts davon.</translation>
    </message>
    <message>
        <source>Mattes have 8 or 16 bits, not {bits}.</source>
        <translation>Mattes haben 8 oder 16 Bit, nicht {bits}.</translation>
    </message>
    <message>
        <source>Mattes of</source>
        <translation>Mattes von</translation>
    </message>
    <message>
        <source>Max</source>
        <translation>Max</translation>
    </message>
    <message>
        <source>Measure boil by the picture</source>
        <translation>Flimmern am Bild messen</translation>
    </message>
    <message>
        <source>Memory for frames</source>
        <translation>Speicher für Frames</translation>
    </message>
    <message>
        <source>Memory for undo</source>
        <translation>Speicher für Verlauf</translation>
    </message>
    <message>
        <source>Menu</source>
        <translation>Menü</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Meldungen</translation>
    </message>
    <message>
        <source>Middle button, Alt+left</source>
        <translation>Mittlere Taste, Alt+Linke</translation>
    </message>
    <message>
        <source>Mirror horizontally</source>
        <translation>Horizontal spiegeln</translation>
    </message>
    <message>
        <source>Mirror vertically</source>
        <translation>Vertikal spiegeln</translation>
    </message>
    <message>
        <source>Missing</source>
        <translation>Fehlend</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Modus</translation>
    </message>
    <message>
        <source>Mode at the start</source>
        <translation>Modus beim Start</translation>
    </message>
    <message>
        <source>Moments of the open shutter that are joined</source>
        <translation>Momente des offenen Verschlusses, die verbunden werden</translation>
    </message>
    <message>
        <source>More</source>
        <translation>Mehr</translation>
    </message>
    <message>
        <source>More controls of how the plate is looked at</source>
        <translation>Weitere Regler für die Ansicht der Plate</translation>
    </message>
    <message>
        <source>More keeps more of a clip ready to play</source>
        <translation>Mehr hält mehr von einem Clip zum Abspielen bereit</translation>
    </message>
    <message>
        <source>More tools</source>
        <translation>Weitere Werkzeuge</translation>
    </message>
    <message>
        <source>Most doubtful frame</source>
        <translation>Zweifelhaftester Frame</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>Motion blur</source>
        <translation>Motion Blur</translation>
    </message>
    <message>
        <source>Motion blur needs a shutter of 0 frames or more, and at least two samples.</source>
        <translation>Bewegungsunschärfe braucht einen Verschluss von 0 Frames oder mehr und mindestens zwei Samples.</translation>
    </message>
    <message>
        <source>Motion of layers</source>
        <translation>Bewegung der Ebenen</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Bewegen</translation>
    </message>
    <message>
        <source>Move handle</source>
        <translation>Tangente bewegen</translation>
    </message>
    <message>
        <source>Move keys</source>
        <translation>Keyframes verschieben</translation>
    </message>
    <message>
        <source>Move mark</source>
        <translation>Markierung verschieben</translation>
    </message>
    <message>
        <source>Move on evenly from the chosen keys, or from this one</source>
        <translation>Von den gewählten Keyframes oder diesem gleichmäßig weiterbewegen</translation>
    </message>
    <message>
        <source>Move pivot</source>
        <translation>Drehpunkt bewegen</translation>
    </message>
    <message>
        <source>Move point</source>
        <translation>Punkt bewegen</translation>
    </message>
    <message>
        <source>Move shape</source>
        <translation>Form bewegen</translation>
    </message>
    <message>
        <source>Move tracked keys so that their outlines boil less</source>
        <translation>Getrackte Keyframes so bewegen, dass ihre Umrisse weniger flimmern</translation>
    </message>
    <message>
        <source>Move x, y</source>
        <translation>Bewegen x, y</translation>
    </message>
    <message>
        <source>Move {count} points</source>
        <translation>{count} Punkte bewegen</translation>
    </message>
    <message>
        <source>Move {count} shapes</source>
        <translation>{count} Formen bewegen</translation>
    </message>
    <message>
        <source>Move {dx:+.1f}, {dy:+.1f} px</source>
        <translation>Bewegen {dx:+.1f}, {dy:+.1f} px</translation>
    </message>
    <message>
        <source>Move {keys} {frames}: {first} to {last}.</source>
        <translation>{keys} {frames} verschieben: {first} nach {last}.</translation>
    </message>
    <message>
        <source>Move, turn, scale and shear by numbers</source>
        <translation>Nach Zahlen bewegen, drehen, skalieren und scheren</translation>
    </message>
    <message>
        <source>Move, turn, scale and shear points or shapes</source>
        <translation>Punkte oder Formen bewegen, drehen, skalieren und scheren</translation>
    </message>
    <message>
        <source>Movie</source>
        <translation>Film</translation>
    </message>
    <message>
        <source>Movies (*.mov *.mp4 *.avi *.mkv *.m4v *.mxf *.webm *.mpg *.mpeg *.gif);;All files (*)</source>
        <translation>Filme (*.mov *.mp4 *.avi *.mkv *.m4v *.mxf *.webm *.mpg *.mpeg *.gif);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Movie…</source>
        <translation>Film…</translation>
    </message>
    <message>
        <source>My keys only</source>
        <translation>Nur eigene Keyframes</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Natron Roto node (script)</source>
        <translation>Natron-Roto-Node (Skript)</translation>
    </message>
    <message>
        <source>Natron&apos;s Plus goes beyond 1 where {name!r} overlaps what lies under it.</source>
        <translation>Natrons Plus geht über 1 hinaus, wo {name!r} überlappt, was darunter liegt.</translation>
    </message>
    <message>
        <source>Neither {folder} nor a temporary folder can be written to: {error}.</source>
        <translation>Weder {folder} noch ein temporärer Ordner ist beschreibbar: {error}.</translation>
    </message>
    <message>
        <source>Never</source>
        <translation>Nie</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Neu</translation>
    </message>
    <message>
        <source>New layer</source>
        <translation>Neue Ebene</translation>
    </message>
    <message>
        <source>Next doubtful frame</source>
        <translation>Nächster zweifelhafter Frame</translation>
    </message>
    <message>
        <source>Next frame</source>
        <translation>Nächster Frame</translation>
    </message>
    <message>
        <source>Next key</source>
        <translation>Nächster Keyframe</translation>
    </message>
    <message>
        <source>Next note</source>
        <translation>Nächste Notiz</translation>
    </message>
    <message>
        <source>Next part</source>
        <translation>Nächster Fensterteil</translation>
    </message>
    <message>
        <source>Next point</source>
        <translation>Nächster Punkt</translation>
    </message>
    <message>
        <source>Next proposal</source>
        <translation>Nächster Vorschlag</translation>
    </message>
    <message>
        <source>No action is called that; try another word, or fewer letters.</source>
        <translation>Nichts heißt so; bitte ein anderes Wort versuchen oder weniger Buchstaben.</translation>
    </message>
    <message>
        <source>No backup of {path} can be kept: files of others have the names of its backups.</source>
        <translation>Von {path} kann keine Sicherung aufgehoben werden: Fremde Dateien tragen die Namen der Sicherungen.</translation>
    </message>
    <message>
        <source>No backup of {path} can be kept: {reason} ({folder}).</source>
        <translation>Von {path} kann keine Sicherung aufgehoben werden: {reason} ({folder}).</translation>
    </message>
    <message>
        <source>No boil is measured here</source>
        <translation>Hier ist kein Flimmern gemessen</translation>
    </message>
    <message>
        <source>No doubtful frame after frame {frame}.</source>
        <translation>Kein zweifelhafter Frame nach Frame {frame}.</translation>
    </message>
    <message>
        <source>No doubtful frame before frame {frame}.</source>
        <translation>Kein zweifelhafter Frame vor Frame {frame}.</translation>
    </message>
    <message>
        <source>No edge of these shapes could be read in the plate; nothing was changed.</source>
        <translation>Keine Kante dieser Formen ließ sich in der Plate messen; nichts wurde geändert.</translation>
    </message>
    <message>
        <source>No encoder for {suffix} movies works here; name a folder, and each frame is written as a picture.</source>
        <translation>Hier läuft kein Encoder für Filme mit {suffix}; einen Ordner nennen, dann wird jeder Frame als Bild geschrieben.</translation>
    </message>
    <message>
        <source>No file in {folder} follows the pattern {name}; {hint}.</source>
        <translation>Keine Datei in {folder} passt zum Muster {name}; {hint}.</translation>
    </message>
    <message>
        <source>No font of this machine has {named}: {unknown} stands for each; install a font that has them.</source>
        <translation>Keine Schrift dieses Rechners hat {named}: Für jedes steht {unknown}; bitte eine passende Schrift installieren.</translation>
    </message>
    <message>
        <source>No frame between these keys shows anything: there is nothing to fill.</source>
        <translation>Kein Frame zwischen diesen Keyframes zeigt etwas: Es gibt nichts zu füllen.</translation>
    </message>
    <message>
        <source>No frame is numbered {offset} too high; choose a smaller offset.</source>
        <translation>Kein Frame ist um {offset} zu hoch nummeriert; einen kleineren Versatz wählen.</translation>
    </message>
    <message>
        <source>No frame is tracked yet.</source>
        <translation>Noch ist kein Frame getrackt.</translation>
    </message>
    <message>
        <source>No gap lies wholly between in and out; &lt;time.clear_range&gt; clears them.</source>
        <translation>Keine Lücke liegt ganz zwischen In und Out; &lt;time.clear_range&gt; löscht sie.</translation>
    </message>
    <message>
        <source>No key</source>
        <translation>Keine Taste</translation>
    </message>
    <message>
        <source>No key: the shape is between frames {first} and {last}</source>
        <translation>Kein Keyframe: Die Form liegt zwischen den Frames {first} und {last}</translation>
    </message>
    <message>
        <source>No key: the shape stands as on frame {frame}</source>
        <translation>Kein Keyframe: Die Form steht wie auf Frame {frame}</translation>
    </message>
    <message>
        <source>No landmark was found on {least} frame(s) or more; {path} was not written.</source>
        <translation>Keine Landmarke fand sich auf {least} Frames oder mehr; {path} wurde nicht geschrieben.</translation>
    </message>
    <message>
        <source>No motion blur.</source>
        <translation>Keine Bewegungsunschärfe.</translation>
    </message>
    <message>
        <source>No object ends around that place; drag a box around it instead.</source>
        <translation>Um diese Stelle endet kein Objekt; stattdessen einen Rahmen darum ziehen.</translation>
    </message>
    <message>
        <source>No plate was named; give a folder of images, a pattern, an image or a movie.</source>
        <translation>Es ist keine Plate genannt; einen Ordner mit Bildern, ein Muster, ein Bild oder einen Film angeben.</translation>
    </message>
    <message>
        <source>No point lies under the brush; Ctrl and the wheel make it wider.</source>
        <translation>Unter dem Pinsel liegt kein Punkt; Strg und Mausrad machen ihn größer.</translation>
    </message>
    <message>
        <source>No point was found on frame {frame}; put them anew there, or make their areas larger.</source>
        <translation>Auf Frame {frame} wurde kein Punkt gefunden; dort neu setzen, oder ihre Bereiche vergrößern.</translation>
    </message>
    <message>
        <source>No proposal waits for an answer.</source>
        <translation>Kein Vorschlag wartet auf Antwort.</translation>
    </message>
    <message>
        <source>No shape is in sight here that could be selected; show or unlock some.</source>
        <translation>Hier ist keine Form zu sehen, die sich auswählen ließe; bitte einige einblenden oder entsperren.</translation>
    </message>
    <message>
        <source>No shape is selected; select some, or export all.</source>
        <translation>Keine Form ist ausgewählt; bitte einige auswählen oder alle exportieren.</translation>
    </message>
    <message>
        <source>No shape or layer is called that.</source>
        <translation>Nichts heißt so.</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>Auf dem Datenträger ist kein Platz mehr</translation>
    </message>
    <message>
        <source>No such device</source>
        <translation>Das Gerät gibt es nicht</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>Die Datei oder den Ordner gibt es nicht</translation>
    </message>
    <message>
        <source>No tracked key could be steadied; nothing was changed.</source>
        <translation>Kein getrackter Keyframe ließ sich beruhigen; nichts wurde geändert.</translation>
    </message>
    <message>
        <source>No tracked key lies between in and out; track or fill the shapes first.</source>
        <translation>Zwischen In und Out liegt kein getrackter Keyframe; bitte die Formen zuerst tracken oder füllen.</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>Das ist kein Ordner</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Notiz</translation>
    </message>
    <message>
        <source>Note on frame {frame}; Ctrl+Return keeps it</source>
        <translation>Notiz auf Frame {frame}; Strg+Eingabe behält sie</translation>
    </message>
    <message>
        <source>Note on this frame</source>
        <translation>Notiz auf diesem Frame</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notizen</translation>
    </message>
    <message>
        <source>Notes and doubts</source>
        <translation>Notizen und Zweifel</translation>
    </message>
    <message>
        <source>Notes, doubtful frames and boil as a list</source>
        <translation>Notizen, zweifelhafte Frames und Flimmern als Liste</translation>
    </message>
    <message>
        <source>Notes, doubts and boil</source>
        <translation>Notizen, Zweifel, Flimmern</translation>
    </message>
    <message>
        <source>Nothing changed: what is selected has these properties already.</source>
        <translation>Nichts geändert: Die Auswahl hat diese Eigenschaften schon.</translation>
    </message>
    <message>
        <source>Nothing is selected.</source>
        <translation>Nichts ist ausgewählt.</translation>
    </message>
    <message>
        <source>Nothing is sent. Copy it into an issue if you like.</source>
        <translation>Nichts wird gesendet. Der Bericht lässt sich in eine Fehlermeldung kopieren.</translation>
    </message>
    <message>
        <source>Nothing is tracked here</source>
        <translation>Hier ist nichts getrackt</translation>
    </message>
    <message>
        <source>Nothing is tracked yet whose boil could be measured.</source>
        <translation>Noch ist nichts getrackt, dessen Flimmern sich messen ließe.</translation>
    </message>
    <message>
        <source>Nothing is white in the masks {path}; paint the object white and the rest black.</source>
        <translation>In den Masken {path} ist nichts weiß; das Objekt weiß malen und den Rest schwarz.</translation>
    </message>
    <message>
        <source>Nothing is white in {name}; paint the object white and the rest black.</source>
        <translation>In {name} ist nichts weiß; das Objekt weiß malen und den Rest schwarz.</translation>
    </message>
    <message>
        <source>Nothing lies over what is selected from this frame on; it is in front already.</source>
        <translation>Ab diesem Bild liegt nichts über dem Ausgewählten; es liegt schon vorn.</translation>
    </message>
    <message>
        <source>Nothing lies under what is selected from this frame on; it is behind already.</source>
        <translation>Ab diesem Bild liegt nichts unter dem Ausgewählten; es liegt schon hinten.</translation>
    </message>
    <message>
        <source>Nothing of it was found on this frame: it is hidden, has left the picture, or was lost</source>
        <translation>Nichts davon wurde auf diesem Bild gefunden: Es ist verdeckt, hat das Bild verlassen oder ging verloren</translation>
    </message>
    <message>
        <source>Nothing stands out there; drag a closer box around the object.</source>
        <translation>Dort hebt sich nichts ab; den Rahmen enger um das Objekt ziehen.</translation>
    </message>
    <message>
        <source>Nothing to list: no notes, no doubtful frames and none that boil, of the shapes in hand.</source>
        <translation>Nichts aufzulisten: keine Notizen, keine zweifelhaften und keine flimmernden Frames der aktiven Formen.</translation>
    </message>
    <message>
        <source>Nothing was copied.</source>
        <translation>Nichts wurde kopiert.</translation>
    </message>
    <message>
        <source>Nothing was exported; the files that are there stay.</source>
        <translation>Nichts wurde exportiert; die vorhandenen Dateien bleiben.</translation>
    </message>
    <message>
        <source>Nothing was written; the files that are there stay.</source>
        <translation>Nichts wurde geschrieben; die vorhandenen Dateien bleiben.</translation>
    </message>
    <message>
        <source>Nothing yet</source>
        <translation>Noch nichts</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Jetzt</translation>
    </message>
    <message>
        <source>Now: {shown}</source>
        <translation>Jetzt: {shown}</translation>
    </message>
    <message numerus="yes">
        <source>Nudge %n point(s)</source>
        <translation>
            <numerusform>%n Punkt schubsen</numerusform>
            <numerusform>%n Punkte schubsen</numerusform>
        </translation>
    </message>
    <message>
        <source>Nudge points by a pixel, with Shift by ten</source>
        <translation>Punkte um ein Pixel schubsen, mit Umschalt um zehn</translation>
    </message>
    <message>
        <source>Nuke Python script</source>
        <translation>Nuke-Python-Skript</translation>
    </message>
    <message>
        <source>Nuke Roto node</source>
        <translation>Nuke-Roto-Node</translation>
    </message>
    <message>
        <source>Nuke Tracker and CornerPin nodes</source>
        <translation>Nuke-Tracker- und CornerPin-Nodes</translation>
    </message>
    <message>
        <source>Nuke gets nodes of their own for {what}: one Roto node is not known to join layers as ROAM does.</source>
        <translation>Nuke erhält eigene Nodes für {what}: Ein einzelner Roto-Node verbindet Ebenen nicht sicher wie ROAM.</translation>
    </message>
    <message>
        <source>Nuke has linear keys on every frame for the opacity of {name!r}, straight between frames.</source>
        <translation>Nuke erhält für die Deckkraft von {name!r} lineare Keyframes auf jedem Frame, dazwischen geht es gerade.</translation>
    </message>
    <message>
        <source>Nuke script</source>
        <translation>Nuke-Skript</translation>
    </message>
    <message>
        <source>Nuke unites where ROAM adds {some}: pixels that two edges share are darker there.</source>
        <translation>Nuke vereinigt, wo ROAM {some} addiert: Pixel, die sich zwei Kanten teilen, sind dort dunkler.</translation>
    </message>
    <message>
        <source>Nuke&apos;s names of shapes are ASCII: {listed}. The true names stand in the node&apos;s label and come back when ROAM reads the file.</source>
        <translation>Formnamen in Nuke sind ASCII: {listed}. Die wahren Namen stehen in der Beschriftung des Nodes und kommen zurück, wenn ROAM die Datei liest.</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objekt</translation>
    </message>
    <message>
        <source>Objects are hard, without the {left} of {name!r}.</source>
        <translation>Objekte sind hart, ohne {left} von {name!r}.</translation>
    </message>
    <message>
        <source>Objects are opaque: the opacity of {name!r} is left out.</source>
        <translation>Objekte sind deckend: Die Deckkraft von {name!r} entfällt.</translation>
    </message>
    <message>
        <source>Occluder</source>
        <translation>Verdecker</translation>
    </message>
    <message>
        <source>Of the joint matte of all that lies in the layer</source>
        <translation>Von der gemeinsamen Matte von allem, was in der Ebene liegt</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Aus</translation>
    </message>
    <message>
        <source>Older versions of a project, kept beside it when you save</source>
        <translation>Ältere Versionen eines Projekts, beim Speichern daneben aufgehoben</translation>
    </message>
    <message>
        <source>On</source>
        <translation>An</translation>
    </message>
    <message>
        <source>On another key points would go beyond the horizon of this perspective; pull the corner less far.</source>
        <translation>Auf einem anderen Keyframe lägen Punkte hinter dem Horizont dieser Perspektive; ziehen Sie die Ecke weniger weit.</translation>
    </message>
    <message>
        <source>On empty background: add points to the selection, take them away</source>
        <translation>Auf leerem Hintergrund: Punkte zur Auswahl hinzufügen, aus ihr entfernen</translation>
    </message>
    <message>
        <source>On it</source>
        <translation>Darauf</translation>
    </message>
    <message>
        <source>One for two cores</source>
        <translation>Einer für zwei Kerne</translation>
    </message>
    <message>
        <source>One object</source>
        <translation>Ein Objekt</translation>
    </message>
    <message>
        <source>One object takes two shapes or more; select them all, or a layer.</source>
        <translation>Zu einem Objekt gehören mindestens zwei Formen; alle auswählen, oder eine Ebene.</translation>
    </message>
    <message>
        <source>One on every frame</source>
        <translation>Einer auf jedem Frame</translation>
    </message>
    <message>
        <source>One place higher in the list: over what lies above</source>
        <translation>Einen Platz höher in der Liste: über das, was darüber liegt</translation>
    </message>
    <message>
        <source>One place lower in the list: under what lies below</source>
        <translation>Einen Platz tiefer in der Liste: unter das, was darunter liegt</translation>
    </message>
    <message>
        <source>Onion skin</source>
        <translation>Zwiebelhaut</translation>
    </message>
    <message>
        <source>Only a closed shape has a matte</source>
        <translation>Nur eine geschlossene Form hat eine Matte</translation>
    </message>
    <message>
        <source>Only a closed shape that is not locked can be steadied; unlock or close one.</source>
        <translation>Nur eine geschlossene Form, die nicht gesperrt ist, lässt sich beruhigen; bitte eine entsperren oder schließen.</translation>
    </message>
    <message>
        <source>Only a closed shape that is not locked has an edge to match; unlock or close one.</source>
        <translation>Nur eine geschlossene, nicht gesperrte Form hat eine anpassbare Kante; bitte eine entsperren oder schließen.</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>Opacity of the selected shapes and layers, in percent</source>
        <translation>Deckkraft der ausgewählten Formen und Ebenen, in Prozent</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Open a clip first: a mask belongs to one of its frames.</source>
        <translation>Zuerst einen Clip öffnen: Eine Maske gehört zu einem seiner Frames.</translation>
    </message>
    <message>
        <source>Open a clip first: drop a folder of
images or a movie on the window.</source>
        <translation>Zuerst einen Clip öffnen: einen Ordner mit
Bildern oder einen Film ins Fenster ziehen.</translation>
    </message>
    <message>
        <source>Open a clip first: drop a folder of images or a movie on the window.</source>
        <translation>Zuerst einen Clip öffnen: einen Ordner mit Bildern oder einen Film ins Fenster ziehen.</translation>
    </message>
    <message>
        <source>Open a clip first: marks lie on its frames.</source>
        <translation>Zuerst einen Clip öffnen: Markierungen liegen auf seinen Frames.</translation>
    </message>
    <message>
        <source>Open a clip first: notes lie on its frames.</source>
        <translation>Zuerst einen Clip öffnen: Notizen liegen auf seinen Frames.</translation>
    </message>
    <message>
        <source>Open a clip first: shapes come into its frames and pixels.</source>
        <translation>Zuerst einen Clip öffnen: Formen kommen in seine Frames und Pixel.</translation>
    </message>
    <message>
        <source>Open a copy</source>
        <translation>Kopie öffnen</translation>
    </message>
    <message>
        <source>Open anyway</source>
        <translation>Trotzdem öffnen</translation>
    </message>
    <message>
        <source>Open clip</source>
        <translation>Clip öffnen</translation>
    </message>
    <message>
        <source>Open clip: the folder of its frames</source>
        <translation>Clip öffnen: der Ordner seiner Frames</translation>
    </message>
    <message>
        <source>Open clips without asking from now on</source>
        <translation>Clips künftig ohne Nachfrage öffnen</translation>
    </message>
    <message>
        <source>Open clip…</source>
        <translation>Clip öffnen…</translation>
    </message>
    <message>
        <source>Open movie</source>
        <translation>Film öffnen</translation>
    </message>
    <message>
        <source>Open movie…</source>
        <translation>Film öffnen…</translation>
    </message>
    <message>
        <source>Open or close</source>
        <translation>Öffnen oder schließen</translation>
    </message>
    <message>
        <source>Open or close shape</source>
        <translation>Form öffnen oder schließen</translation>
    </message>
    <message>
        <source>Open project</source>
        <translation>Projekt öffnen</translation>
    </message>
    <message>
        <source>Open project…</source>
        <translation>Projekt öffnen…</translation>
    </message>
    <message>
        <source>Open recent</source>
        <translation>Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>Open the demo</source>
        <translation>Demo öffnen</translation>
    </message>
    <message>
        <source>Open: not tracked</source>
        <translation>Offen: wird nicht getrackt</translation>
    </message>
    <message>
        <source>OpenColorIO cannot convert {spaces}: {reason}.</source>
        <translation>OpenColorIO kann {spaces} nicht umrechnen: {reason}.</translation>
    </message>
    <message>
        <source>OpenColorIO cannot show the view {view} on {display}: {reason}.</source>
        <translation>OpenColorIO kann die Ansicht {view} auf {display} nicht zeigen: {reason}.</translation>
    </message>
    <message>
        <source>Opened lately</source>
        <translation>Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>Opened {name}.{moved}</source>
        <translation>{name} geöffnet.{moved}</translation>
    </message>
    <message>
        <source>Opened {name}: {count} frames. {gaps}</source>
        <translation>{name} geöffnet: {count} Frames. {gaps}</translation>
    </message>
    <message>
        <source>Opening {name} …</source>
        <translation>{name} wird geöffnet …</translation>
    </message>
    <message>
        <source>Opening …</source>
        <translation>Wird geöffnet …</translation>
    </message>
    <message>
        <source>Operation not permitted</source>
        <translation>Das ist nicht erlaubt</translation>
    </message>
    <message>
        <source>Or drop a folder of images, a movie or a project anywhere in this window.</source>
        <translation>Oder einen Ordner mit Bildern, einen Film oder ein Projekt irgendwo in dieses Fenster ziehen.</translation>
    </message>
    <message>
        <source>Other shapes say nothing about what lies before the surface</source>
        <translation>Andere Formen sagen nichts darüber, was vor der Fläche liegt</translation>
    </message>
    <message>
        <source>Out: frame {last}. Drag it</source>
        <translation>Out: Frame {last}. Ziehen verschiebt</translation>
    </message>
    <message>
        <source>Outlines move straight, smoothly or not at all: opacity and feather have tangents.</source>
        <translation>Umrisse bewegen sich gerade, weich oder gar nicht: Tangenten haben Deckkraft und Feather.</translation>
    </message>
    <message>
        <source>Outlines of frames after</source>
        <translation>Umrisse der Frames danach</translation>
    </message>
    <message>
        <source>Outlines of frames before</source>
        <translation>Umrisse der Frames davor</translation>
    </message>
    <message>
        <source>Outlines on the plate</source>
        <translation>Umrisse auf der Plate</translation>
    </message>
    <message>
        <source>Outside of the shape&apos;s lifetime</source>
        <translation>Außerhalb der Lebensdauer der Form</translation>
    </message>
    <message>
        <source>Overlay</source>
        <translation>Overlay</translation>
    </message>
    <message>
        <source>Packing</source>
        <translation>Kompression</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>Pages of small pictures with frame numbers and notes</source>
        <translation>Seiten mit kleinen Bildern, Framenummern und Notizen</translation>
    </message>
    <message>
        <source>Pan</source>
        <translation>Verschieben</translation>
    </message>
    <message>
        <source>Panel: Planar track</source>
        <translation>Bereich: Flächen-Track</translation>
    </message>
    <message>
        <source>Panel: Shape</source>
        <translation>Bereich: Form</translation>
    </message>
    <message>
        <source>Panel: Shapes</source>
        <translation>Bereich: Formen</translation>
    </message>
    <message>
        <source>Panel: Track</source>
        <translation>Bereich: Tracking</translation>
    </message>
    <message>
        <source>Panels</source>
        <translation>Bereiche</translation>
    </message>
    <message>
        <source>Part of {count}</source>
        <translation>Teil von {count}</translation>
    </message>
    <message>
        <source>Parts and holes that are never larger are left out</source>
        <translation>Teile und Löcher, die nie größer sind, entfallen</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Einfügen</translation>
    </message>
    <message>
        <source>Paste all properties</source>
        <translation>Alle Eigenschaften einfügen</translation>
    </message>
    <message>
        <source>Paste colour</source>
        <translation>Farbe einfügen</translation>
    </message>
    <message>
        <source>Paste key</source>
        <translation>Keyframe einfügen</translation>
    </message>
    <message>
        <source>Paste key to range</source>
        <translation>Keyframe in Bereich einfügen</translation>
    </message>
    <message>
        <source>Paste key to range…</source>
        <translation>Keyframe in Bereich einfügen…</translation>
    </message>
    <message>
        <source>Paste keys</source>
        <translation>Keyframes einfügen</translation>
    </message>
    <message>
        <source>Paste matte properties</source>
        <translation>Matte-Eigenschaften einfügen</translation>
    </message>
    <message>
        <source>Paste properties</source>
        <translation>Eigenschaften einfügen</translation>
    </message>
    <message>
        <source>Paste the copied shapes, also those copied in Nuke or Fusion</source>
        <translation>Kopierte Formen einfügen, auch in Nuke oder Fusion kopierte</translation>
    </message>
    <message>
        <source>Pasted into the selected shapes, in their order: {names}.</source>
        <translation>In die ausgewählten Formen eingefügt, der Reihe nach: {names}.</translation>
    </message>
    <message>
        <source>Pasted onto {items}: {properties}.</source>
        <translation>Auf {items} übertragen: {properties}.</translation>
    </message>
    <message>
        <source>Pattern {pattern:.0f} px, search {search:.0f} px.</source>
        <translation>Muster {pattern:.0f} px, Suche {search:.0f} px.</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>Die Berechtigung fehlt</translation>
    </message>
    <message>
        <source>Perspective</source>
        <translation>Perspektive</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>Phase</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Picture under the cut-out</source>
        <translation>Bild unter dem Freisteller</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Pictures (*.exr *.dpx *.png *.jpg *.jpeg *.tif *.tiff);;All files (*)</source>
        <translation>Bilder (*.exr *.dpx *.png *.jpg *.jpeg *.tif *.tiff);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Pictures (PNG)</source>
        <translation>Bilder (PNG)</translation>
    </message>
    <message>
        <source>Pictures are scaled by {least:g} to {most:g}, not by {scale:g}.</source>
        <translation>Bilder werden mit {least:g} bis {most:g} skaliert, nicht mit {scale:g}.</translation>
    </message>
    <message>
        <source>Pictures beside each other on a page</source>
        <translation>Bilder nebeneinander auf einer Seite</translation>
    </message>
    <message>
        <source>Pictures to a folder</source>
        <translation>Bilder in einen Ordner</translation>
    </message>
    <message>
        <source>Pin as A</source>
        <translation>Als A merken</translation>
    </message>
    <message>
        <source>Pin the corners of a tracked surface</source>
        <translation>Ecken einer getrackten Fläche festlegen</translation>
    </message>
    <message>
        <source>Pixel aspect</source>
        <translation>Pixelseitenverhältnis</translation>
    </message>
    <message>
        <source>Pixels</source>
        <translation>Pixel</translation>
    </message>
    <message>
        <source>Pixels of {frames} frame(s), the first is {first}, show more than {most} shapes: the Cryptomatte has those that cover most.</source>
        <translation>Pixel von {frames} Frame(s), der erste ist {first}, zeigen mehr als {most} Formen: Das Cryptomatte enthält die, die am meisten decken.</translation>
    </message>
    <message>
        <source>Plain JSON</source>
        <translation>Einfaches JSON</translation>
    </message>
    <message>
        <source>Planar track</source>
        <translation>Flächen-Track</translation>
    </message>
    <message>
        <source>Planar track backward</source>
        <translation>Fläche rückwärts tracken</translation>
    </message>
    <message>
        <source>Planar track forward</source>
        <translation>Fläche vorwärts tracken</translation>
    </message>
    <message>
        <source>Plate</source>
        <translation>Plate</translation>
    </message>
    <message>
        <source>Play backward</source>
        <translation>Rückwärts abspielen</translation>
    </message>
    <message>
        <source>Play backward at half speed; again: slower</source>
        <translation>Mit halber Geschwindigkeit rückwärts; nochmals: langsamer</translation>
    </message>
    <message>
        <source>Play backward slowly</source>
        <translation>Langsam rückwärts abspielen</translation>
    </message>
    <message>
        <source>Play backward; again: faster</source>
        <translation>Rückwärts abspielen; nochmals: schneller</translation>
    </message>
    <message>
        <source>Play forward</source>
        <translation>Vorwärts abspielen</translation>
    </message>
    <message>
        <source>Play forward at half speed; again: slower</source>
        <translation>Mit halber Geschwindigkeit vorwärts; nochmals: langsamer</translation>
    </message>
    <message>
        <source>Play forward; again: faster</source>
        <translation>Vorwärts abspielen; nochmals: schneller</translation>
    </message>
    <message>
        <source>Play or pause</source>
        <translation>Abspielen oder anhalten</translation>
    </message>
    <message>
        <source>Play slowly</source>
        <translation>Langsam abspielen</translation>
    </message>
    <message>
        <source>Playback</source>
        <translation>Wiedergabe</translation>
    </message>
    <message>
        <source>Plus</source>
        <translation>Plus</translation>
    </message>
    <message>
        <source>Point at a curve of opacity or feather to set a key on it.</source>
        <translation>Auf eine Kurve von Deckkraft oder Feather zeigen, um darauf einen Keyframe zu setzen.</translation>
    </message>
    <message>
        <source>Point track</source>
        <translation>Punkt-Track</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Points near the selected ones follow them</source>
        <translation>Punkte nahe den ausgewählten folgen ihnen</translation>
    </message>
    <message>
        <source>Polygon</source>
        <translation>Polygon</translation>
    </message>
    <message>
        <source>Polygons of CVAT only add: the {what} of {name} is lost.</source>
        <translation>Polygone in CVAT addieren nur: {what} von {name} geht verloren.</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Position x</source>
        <translation>Position x</translation>
    </message>
    <message>
        <source>Position y</source>
        <translation>Position y</translation>
    </message>
    <message>
        <source>Position, turn, size</source>
        <translation>Position, Drehung, Größe</translation>
    </message>
    <message>
        <source>Previous doubtful frame</source>
        <translation>Vorheriger zweifelhafter Frame</translation>
    </message>
    <message>
        <source>Previous frame</source>
        <translation>Vorheriger Frame</translation>
    </message>
    <message>
        <source>Previous key</source>
        <translation>Vorheriger Keyframe</translation>
    </message>
    <message>
        <source>Previous note</source>
        <translation>Vorherige Notiz</translation>
    </message>
    <message>
        <source>Previous part</source>
        <translation>Vorheriger Fensterteil</translation>
    </message>
    <message>
        <source>Previous point</source>
        <translation>Vorheriger Punkt</translation>
    </message>
    <message>
        <source>Problem report</source>
        <translation>Problembericht</translation>
    </message>
    <message>
        <source>Problem report…</source>
        <translation>Problembericht…</translation>
    </message>
    <message>
        <source>Processes</source>
        <translation>Prozesse</translation>
    </message>
    <message>
        <source>Proposal</source>
        <translation>Vorschlag</translation>
    </message>
    <message>
        <source>Proposals wait for shapes that are not shown while others are soloed; &lt;shape.solo&gt; shows all.</source>
        <translation>Vorschläge warten zu Formen, die nicht zu sehen sind, solange andere auf Solo stehen; &lt;shape.solo&gt; zeigt alle.</translation>
    </message>
    <message>
        <source>Propose changes for the selected shapes again</source>
        <translation>Für die ausgewählten Formen wieder Änderungen vorschlagen</translation>
    </message>
    <message>
        <source>Proxy 1/2</source>
        <translation>Proxy 1/2</translation>
    </message>
    <message>
        <source>Proxy 1/4</source>
        <translation>Proxy 1/4</translation>
    </message>
    <message>
        <source>Pull out handles</source>
        <translation>Tangenten herausziehen</translation>
    </message>
    <message>
        <source>Pull the points under a soft, round brush</source>
        <translation>Punkte unter einem weichen, runden Pinsel ziehen</translation>
    </message>
    <message>
        <source>Put a note on this frame&apos;s mark</source>
        <translation>Eine Notiz zur Markierung dieses Frames schreiben</translation>
    </message>
    <message>
        <source>Put into</source>
        <translation>Ablegen in</translation>
    </message>
    <message>
        <source>Put one, two, three or four points on the picture to track them.</source>
        <translation>Zum Tracken einen, zwei, drei oder vier Punkte auf das Bild setzen.</translation>
    </message>
    <message>
        <source>Put points that a track follows, with the shapes</source>
        <translation>Punkte setzen, denen ein Track mit den Formen folgt</translation>
    </message>
    <message>
        <source>Put the copied key on this frame</source>
        <translation>Den kopierten Keyframe auf diesen Frame setzen</translation>
    </message>
    <message>
        <source>Put the feather of the selected points back on the outline</source>
        <translation>Die weiche Kante der ausgewählten Punkte auf den Umriss zurücksetzen</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>ROAM did not close properly</source>
        <translation>ROAM wurde nicht richtig beendet</translation>
    </message>
    <message>
        <source>ROAM did not make what is there in {folder}. It would be lost.</source>
        <translation>Was in {folder} liegt, stammt nicht von ROAM. Es ginge verloren.</translation>
    </message>
    <message>
        <source>ROAM ended in a crash</source>
        <translation>ROAM ist abgestürzt</translation>
    </message>
    <message>
        <source>ROAM has one view, and shows what Nuke shows in some of the script&apos;s alone: {names}.</source>
        <translation>ROAM hat eine Ansicht und zeigt, was Nuke nur in manchen Ansichten des Skripts zeigt: {names}.</translation>
    </message>
    <message>
        <source>ROAM projects (*.roam)</source>
        <translation>ROAM-Projekte (*.roam)</translation>
    </message>
    <message>
        <source>Raise</source>
        <translation>Nach oben</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Bereich</translation>
    </message>
    <message>
        <source>Reach</source>
        <translation>Reichweite</translation>
    </message>
    <message>
        <source>Read again pictures that were rendered anew</source>
        <translation>Bilder noch einmal lesen, die neu gerendert wurden</translation>
    </message>
    <message>
        <source>Read {shapes} from {name}.</source>
        <translation>{shapes} aus {name} gelesen.</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>Der Datenträger ist schreibgeschützt</translation>
    </message>
    <message>
        <source>Reading {name} …</source>
        <translation>{name} wird gelesen …</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Recover work</source>
        <translation>Arbeit wiederherstellen</translation>
    </message>
    <message>
        <source>Recover work…</source>
        <translation>Arbeit wiederherstellen…</translation>
    </message>
    <message>
        <source>Recovered; save to keep it.</source>
        <translation>Wiederhergestellt; bleibt nur, wenn es gespeichert wird.</translation>
    </message>
    <message>
        <source>Recovering …</source>
        <translation>Wiederherstellung …</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Rechteck</translation>
    </message>
    <message>
        <source>Red</source>
        <translation>Rot</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Redo {step}</source>
        <translation>{step} wiederholen</translation>
    </message>
    <message>
        <source>Redone: {text}.</source>
        <translation>Wiederholt: {text}.</translation>
    </message>
    <message>
        <source>Refuse</source>
        <translation>Ablehnen</translation>
    </message>
    <message>
        <source>Refuse, and propose nothing more for this shape</source>
        <translation>Ablehnen und für diese Form nichts mehr vorschlagen</translation>
    </message>
    <message>
        <source>Relink clip: a frame of the plate, or a movie</source>
        <translation>Clip neu verknüpfen: ein Frame der Plate oder ein Film</translation>
    </message>
    <message>
        <source>Relink clip…</source>
        <translation>Clip neu verknüpfen…</translation>
    </message>
    <message>
        <source>Reload clip</source>
        <translation>Clip neu laden</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove adjust key</source>
        <translation>Korrektur-Keyframe entfernen</translation>
    </message>
    <message>
        <source>Remove mark</source>
        <translation>Markierung entfernen</translation>
    </message>
    <message>
        <source>Remove motion</source>
        <translation>Bewegung entfernen</translation>
    </message>
    <message>
        <source>Remove note</source>
        <translation>Notiz entfernen</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>Rendering the demo shot, frame {frame} …</source>
        <translation>Demo-Shot wird gerendert, Frame {frame} …</translation>
    </message>
    <message>
        <source>Rendering the matte …</source>
        <translation>Matte wird gerendert …</translation>
    </message>
    <message>
        <source>Replaces files that are there.</source>
        <translation>Ersetzt vorhandene Dateien.</translation>
    </message>
    <message>
        <source>Replaces the file that is there.</source>
        <translation>Ersetzt die vorhandene Datei.</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation>Alle zurücksetzen</translation>
    </message>
    <message>
        <source>Reset exposure</source>
        <translation>Belichtung zurücksetzen</translation>
    </message>
    <message>
        <source>Reset feather</source>
        <translation>Feather zurücksetzen</translation>
    </message>
    <message>
        <source>Reset layout</source>
        <translation>Anordnung zurücksetzen</translation>
    </message>
    <message>
        <source>Reshape</source>
        <translation>Verformen</translation>
    </message>
    <message>
        <source>Restack</source>
        <translation>Umordnen</translation>
    </message>
    <message>
        <source>Return, Esc</source>
        <translation>Eingabe, Esc</translation>
    </message>
    <message>
        <source>Reverse direction</source>
        <translation>Richtung umkehren</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>Review</translation>
    </message>
    <message>
        <source>Ripple</source>
        <translation>Ripple</translation>
    </message>
    <message>
        <source>Ripple edit</source>
        <translation>Ripple-Bearbeitung</translation>
    </message>
    <message>
        <source>Ripple: edits change all keys {first}–{last}</source>
        <translation>Ripple: Änderungen gelten für alle Keyframes {first}–{last}</translation>
    </message>
    <message>
        <source>Rotate</source>
        <translation>Drehen</translation>
    </message>
    <message>
        <source>Rotate {degrees:+.1f}°</source>
        <translation>Drehen {degrees:+.1f}°</translation>
    </message>
    <message>
        <source>Rotoscoping with a Rich Online Appearance Model: editable curves carried through a shot.</source>
        <translation>Rotoskopie mit einem Rich Online Appearance Model: editierbare Kurven, durch einen Shot getragen.</translation>
    </message>
    <message>
        <source>Rows of pictures on a page</source>
        <translation>Bildzeilen auf einer Seite</translation>
    </message>
    <message>
        <source>SVG</source>
        <translation>SVG</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Samples</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Save anyway</source>
        <translation>Trotzdem speichern</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Speichern unter…</translation>
    </message>
    <message>
        <source>Save beside the project&apos;s file, under the next version number: v003 is followed by v004</source>
        <translation>Neben der Datei des Projekts speichern, unter der nächsten Versionsnummer: Auf v003 folgt v004</translation>
    </message>
    <message>
        <source>Save new version</source>
        <translation>Neue Version speichern</translation>
    </message>
    <message>
        <source>Save project</source>
        <translation>Projekt speichern</translation>
    </message>
    <message>
        <source>Save the changes to {name}?</source>
        <translation>Änderungen an {name} speichern?</translation>
    </message>
    <message>
        <source>Save your work under a new name now.</source>
        <translation>Bitte die Arbeit jetzt unter neuem Namen speichern.</translation>
    </message>
    <message>
        <source>Saved as {name}: {there} exists already.</source>
        <translation>Als {name} gespeichert: {there} gibt es schon.</translation>
    </message>
    <message>
        <source>Saved {name}. {warning}</source>
        <translation>{name} gespeichert. {warning}</translation>
    </message>
    <message>
        <source>Say where to write it.</source>
        <translation>Bitte angeben, wohin geschrieben wird.</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Skalieren</translation>
    </message>
    <message>
        <source>Scale x, y</source>
        <translation>Skalieren x, y</translation>
    </message>
    <message>
        <source>Scale {x:.1f} %, {y:.1f} %</source>
        <translation>Skalieren {x:.1f} %, {y:.1f} %</translation>
    </message>
    <message>
        <source>Scene linear</source>
        <translation>Szenenlinear</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Search for an action or a key</source>
        <translation>Aktion oder Taste suchen</translation>
    </message>
    <message>
        <source>Second viewer</source>
        <translation>Zweiter Viewer</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>Auswählen</translation>
    </message>
    <message>
        <source>Select a layer first: click it in the list of shapes.</source>
        <translation>Zuerst eine Ebene auswählen: in der Liste der Formen anklicken.</translation>
    </message>
    <message>
        <source>Select a shape first, or choose keys in the timeline.</source>
        <translation>Zuerst eine Form auswählen oder Keyframes in der Zeitleiste wählen.</translation>
    </message>
    <message>
        <source>Select a shape first: click it in the viewer or in the list.</source>
        <translation>Zuerst eine Form auswählen: im Viewer oder in der Liste anklicken.</translation>
    </message>
    <message>
        <source>Select a shape first: its key on this frame is copied.</source>
        <translation>Zuerst eine Form auswählen: Ihr Keyframe auf diesem Frame wird kopiert.</translation>
    </message>
    <message>
        <source>Select a shape or a layer: from then on the view goes along with it.</source>
        <translation>Eine Form oder Ebene auswählen: Von da an geht die Ansicht mit ihr mit.</translation>
    </message>
    <message>
        <source>Select a shape or points to transform: click an outline or drag a marquee.</source>
        <translation>Eine Form oder Punkte zum Transformieren auswählen: Umriss anklicken oder Rahmen ziehen.</translation>
    </message>
    <message>
        <source>Select a shape or some of its points first.</source>
        <translation>Zuerst eine Form oder einige ihrer Punkte auswählen.</translation>
    </message>
    <message>
        <source>Select a shape to see its properties.</source>
        <translation>Eine ausgewählte Form zeigt hier ihre Eigenschaften.</translation>
    </message>
    <message>
        <source>Select a shape whose plane is tracked (&lt;planar.forward&gt;), then pin its corners here.</source>
        <translation>Eine Form auswählen, deren Fläche getrackt ist (&lt;planar.forward&gt;), dann hier ihre Ecken festlegen.</translation>
    </message>
    <message>
        <source>Select a shape: the eraser deletes points of selected shapes.</source>
        <translation>Eine Form auswählen: Der Radierer löscht Punkte ausgewählter Formen.</translation>
    </message>
    <message>
        <source>Select all points</source>
        <translation>Alle Punkte auswählen</translation>
    </message>
    <message>
        <source>Select all shapes</source>
        <translation>Alle Formen auswählen</translation>
    </message>
    <message>
        <source>Select an action first.</source>
        <translation>Zuerst eine Aktion auswählen.</translation>
    </message>
    <message>
        <source>Select an action to give it another key.</source>
        <translation>Eine ausgewählte Aktion kann hier eine andere Taste bekommen.</translation>
    </message>
    <message>
        <source>Select and drag shapes, points and handles</source>
        <translation>Formen, Punkte und Tangenten auswählen und ziehen</translation>
    </message>
    <message>
        <source>Select nothing</source>
        <translation>Nichts auswählen</translation>
    </message>
    <message>
        <source>Select points with a lasso</source>
        <translation>Punkte mit einem Lasso auswählen</translation>
    </message>
    <message>
        <source>Select the one point with which a shape is to begin.</source>
        <translation>Den einen Punkt auswählen, mit dem eine Form beginnen soll.</translation>
    </message>
    <message>
        <source>Select the points that are right here first; a run then derives the others anew.</source>
        <translation>Zuerst die Punkte auswählen, die hier stimmen; ein Lauf leitet die anderen dann neu her.</translation>
    </message>
    <message>
        <source>Select the shapes first that you want to be asked about again.</source>
        <translation>Zuerst die Formen auswählen, zu denen wieder gefragt werden soll.</translation>
    </message>
    <message>
        <source>Select the shapes in sight that are not locked</source>
        <translation>Alle sichtbaren, nicht gesperrten Formen auswählen</translation>
    </message>
    <message>
        <source>Selected shapes only</source>
        <translation>Nur ausgewählte Formen</translation>
    </message>
    <message>
        <source>Selected shapes, or all</source>
        <translation>Ausgewählte Formen oder alle</translation>
    </message>
    <message>
        <source>Selected, each alone</source>
        <translation>Ausgewählte, jede einzeln</translation>
    </message>
    <message>
        <source>Selected: {names}.</source>
        <translation>Ausgewählt: {names}.</translation>
    </message>
    <message>
        <source>Set as first point</source>
        <translation>Als ersten Punkt setzen</translation>
    </message>
    <message>
        <source>Set in</source>
        <translation>In setzen</translation>
    </message>
    <message>
        <source>Set key</source>
        <translation>Keyframe setzen</translation>
    </message>
    <message>
        <source>Set key for points</source>
        <translation>Keyframe für Punkte setzen</translation>
    </message>
    <message>
        <source>Set out</source>
        <translation>Out setzen</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Settings…</source>
        <translation>Einstellungen…</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>Shape from mask</source>
        <translation>Form aus Maske</translation>
    </message>
    <message>
        <source>Shape from the mask of this frame</source>
        <translation>Form aus der Maske dieses Frames</translation>
    </message>
    <message>
        <source>Shape panel</source>
        <translation>Formbereich</translation>
    </message>
    <message>
        <source>Shape {name}</source>
        <translation>Form {name}</translation>
    </message>
    <message>
        <source>Shapes</source>
        <translation>Formen</translation>
    </message>
    <message>
        <source>Shapes ({kinds});;All files (*)</source>
        <translation>Formen ({kinds});;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Shapes and layers</source>
        <translation>Formen und Ebenen</translation>
    </message>
    <message>
        <source>Shapes for other programs, and mattes: every format, keys and frames</source>
        <translation>Formen für andere Programme und Mattes: jedes Format, Keyframes und Frames</translation>
    </message>
    <message>
        <source>Shapes hidden</source>
        <translation>Formen ausgeblendet</translation>
    </message>
    <message>
        <source>Shapes of Nuke, Silhouette and others; or drop the file</source>
        <translation>Formen aus Nuke, Silhouette und anderen; die Datei lässt sich auch ablegen</translation>
    </message>
    <message>
        <source>Shear</source>
        <translation>Scheren</translation>
    </message>
    <message>
        <source>Shear x, y</source>
        <translation>Scheren x, y</translation>
    </message>
    <message>
        <source>Shear {percent:+.1f} %</source>
        <translation>Scheren {percent:+.1f} %</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Verschieben</translation>
    </message>
    <message>
        <source>Shift by {number}</source>
        <translation>Um {number} verschieben</translation>
    </message>
    <message>
        <source>Shift in time</source>
        <translation>Zeitlich verschieben</translation>
    </message>
    <message>
        <source>Shift in time…</source>
        <translation>Zeitlich verschieben…</translation>
    </message>
    <message>
        <source>Shift keys and notes with the new numbers?</source>
        <translation>Keyframes und Notizen mit den neuen Nummern verschieben?</translation>
    </message>
    <message>
        <source>Shift to the new numbers</source>
        <translation>Auf die neuen Nummern verschieben</translation>
    </message>
    <message>
        <source>Shift+click, Ctrl+click</source>
        <translation>Umschalt+Klick, Strg+Klick</translation>
    </message>
    <message>
        <source>Shift+drag</source>
        <translation>Umschalt+Ziehen</translation>
    </message>
    <message>
        <source>Shift+drag, Ctrl+drag</source>
        <translation>Umschalt+Ziehen, Strg+Ziehen</translation>
    </message>
    <message numerus="yes">
        <source>Shifted %n frame(s) earlier.</source>
        <translation>
            <numerusform>Um %n Frame nach früher verschoben.</numerusform>
            <numerusform>Um %n Frames nach früher verschoben.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Shifted %n frame(s) later.</source>
        <translation>
            <numerusform>Um %n Frame nach später verschoben.</numerusform>
            <numerusform>Um %n Frames nach später verschoben.</numerusform>
        </translation>
    </message>
    <message>
        <source>Shifted by {offset} frames, keys would lie beyond frame {last}; choose a smaller number.</source>
        <translation>Um {offset} Frames verschoben lägen Keyframes jenseits von Frame {last}; eine kleinere Zahl wählen.</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Einblenden</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Alle einblenden</translation>
    </message>
    <message>
        <source>Show all that the Shape panel has of the selected shapes</source>
        <translation>Alles zeigen, was der Formbereich über die ausgewählten Formen weiß</translation>
    </message>
    <message>
        <source>Show alone, or with the others again</source>
        <translation>Allein zeigen oder wieder mit den anderen</translation>
    </message>
    <message>
        <source>Show edges</source>
        <translation>Kanten zeigen</translation>
    </message>
    <message>
        <source>Show every key, and find one</source>
        <translation>Alle Tasten zeigen, eine finden</translation>
    </message>
    <message>
        <source>Show every pixel of the plate</source>
        <translation>Jeden Bildpunkt der Plate zeigen</translation>
    </message>
    <message>
        <source>Show every step and go back to any</source>
        <translation>Jeden Schritt zeigen und zu jedem zurückgehen</translation>
    </message>
    <message>
        <source>Show fewer frames in the timeline</source>
        <translation>Weniger Frames in der Zeitleiste zeigen</translation>
    </message>
    <message>
        <source>Show joints</source>
        <translation>Gelenke zeigen</translation>
    </message>
    <message>
        <source>Show layer</source>
        <translation>Ebene einblenden</translation>
    </message>
    <message>
        <source>Show more frames in the timeline</source>
        <translation>Mehr Frames in der Zeitleiste zeigen</translation>
    </message>
    <message>
        <source>Show or hide</source>
        <translation>Ein- oder ausblenden</translation>
    </message>
    <message>
        <source>Show or hide it, also in full screen</source>
        <translation>Ein- oder ausblenden, auch im Vollbild</translation>
    </message>
    <message>
        <source>Show or hide the list of shapes</source>
        <translation>Liste der Formen ein- oder ausblenden</translation>
    </message>
    <message>
        <source>Show or hide the panels on the right</source>
        <translation>Die Bereiche rechts ein- oder ausblenden</translation>
    </message>
    <message>
        <source>Show or hide the planar tracker</source>
        <translation>Flächen-Tracker ein- oder ausblenden</translation>
    </message>
    <message>
        <source>Show or hide the tracker</source>
        <translation>Tracker ein- oder ausblenden</translation>
    </message>
    <message>
        <source>Show or hide what the selected shapes have</source>
        <translation>Eigenschaften der ausgewählten Formen ein- oder ausblenden</translation>
    </message>
    <message>
        <source>Show the plate as it is: all channels, neutral</source>
        <translation>Die Plate zeigen, wie sie ist: alle Kanäle, neutral</translation>
    </message>
    <message>
        <source>Show the plate at a quarter of its size: plays sooner, changes no result</source>
        <translation>Die Plate in einem Viertel ihrer Größe zeigen: spielt eher ab, ändert kein Ergebnis</translation>
    </message>
    <message>
        <source>Show the plate at half its size: plays sooner, changes no result</source>
        <translation>Die Plate in halber Größe zeigen: spielt eher ab, ändert kein Ergebnis</translation>
    </message>
    <message>
        <source>Show the selected shapes and layers alone, and all again</source>
        <translation>Nur die ausgewählten Formen und Ebenen zeigen, und wieder alle</translation>
    </message>
    <message>
        <source>Show the whole clip in the timeline</source>
        <translation>Den ganzen Clip in der Zeitleiste zeigen</translation>
    </message>
    <message>
        <source>Show what was found before a clip opens</source>
        <translation>Vor dem Öffnen eines Clips zeigen, was gefunden wurde</translation>
    </message>
    <message>
        <source>Show what was said, and when</source>
        <translation>Zeigen, was wann gemeldet wurde</translation>
    </message>
    <message>
        <source>Shutter</source>
        <translation>Verschluss</translation>
    </message>
    <message>
        <source>Shutter {shutter:.2f} frames.</source>
        <translation>Verschluss {shutter:.2f} Frames.</translation>
    </message>
    <message>
        <source>Silhouette has one Add for ROAM&apos;s add and plus: that is what {some} becomes.</source>
        <translation>Silhouette hat ein Add für Addieren und Plus von ROAM: Das wird aus {some}.</translation>
    </message>
    <message>
        <source>Silhouette layers have no opacity: that of {name!r} goes into its shapes.</source>
        <translation>Ebenen in Silhouette haben keine Deckkraft: Die von {name!r} geht in ihre Formen ein.</translation>
    </message>
    <message>
        <source>Silhouette layers have no opacity: that of {name!r} is a shape inside, {veil!r}.</source>
        <translation>Ebenen in Silhouette haben keine Deckkraft: Die von {name!r} ist eine Form darin, {veil!r}.</translation>
    </message>
    <message>
        <source>Silhouette refuses shapes of a single point: {name!r} gets another one halfway around.</source>
        <translation>Silhouette lehnt Formen aus einem einzigen Punkt ab: {name!r} bekommt auf halbem Weg einen zweiten.</translation>
    </message>
    <message>
        <source>Silhouette refuses shapes of a single point: {name!r} is left out.</source>
        <translation>Silhouette lehnt Formen aus einem einzigen Punkt ab: {name!r} entfällt.</translation>
    </message>
    <message>
        <source>Silhouette shapes</source>
        <translation>Silhouette-Formen</translation>
    </message>
    <message>
        <source>Silhouette&apos;s shutter is the session&apos;s: that of {name!r} is left out.</source>
        <translation>In Silhouette gilt der Verschluss der Sitzung: Der von {name!r} entfällt.</translation>
    </message>
    <message>
        <source>Silhouette&apos;s shutter is the session&apos;s: {name} has ROAM&apos;s own.</source>
        <translation>In Silhouette gilt der Verschluss der Sitzung: {name} hat den von ROAM.</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Size of the pictures</source>
        <translation>Größe der Bilder</translation>
    </message>
    <message>
        <source>Size on the screen</source>
        <translation>Größe am Bildschirm</translation>
    </message>
    <message>
        <source>Skip frames whose files are there</source>
        <translation>Frames auslassen, deren Dateien da sind</translation>
    </message>
    <message>
        <source>Smooth</source>
        <comment>what is done to keys</comment>
        <translation>Glätten</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Weich</translation>
    </message>
    <message numerus="yes">
        <source>Smooth %n point(s)</source>
        <translation>
            <numerusform>%n Punkt glätten</numerusform>
            <numerusform>%n Punkte glätten</numerusform>
        </translation>
    </message>
    <message>
        <source>Smooth points</source>
        <translation>Punkte glätten</translation>
    </message>
    <message>
        <source>Smoothness</source>
        <translation>Glätte</translation>
    </message>
    <message>
        <source>Soft</source>
        <translation>Weich</translation>
    </message>
    <message>
        <source>Soft edges where the points move while the shutter is open</source>
        <translation>Weiche Kanten, wo sich die Punkte bei offenem Verschluss bewegen</translation>
    </message>
    <message>
        <source>Soft selection</source>
        <translation>Weiche Auswahl</translation>
    </message>
    <message>
        <source>Soften the edge: pull the feather out of points</source>
        <translation>Kante weich machen: die weiche Kante aus Punkten ziehen</translation>
    </message>
    <message>
        <source>Solo</source>
        <translation>Solo</translation>
    </message>
    <message>
        <source>Solo: {names}</source>
        <translation>Solo: {names}</translation>
    </message>
    <message>
        <source>Solve</source>
        <translation>Tracken</translation>
    </message>
    <message>
        <source>Solve as one object</source>
        <translation>Als ein Objekt tracken</translation>
    </message>
    <message>
        <source>Solve as parts</source>
        <translation>Als Teile tracken</translation>
    </message>
    <message>
        <source>Solve by itself</source>
        <translation>Für sich tracken</translation>
    </message>
    <message>
        <source>Some have a key on this frame or vary, others do not. Click to set a key on all</source>
        <translation>Manche haben auf diesem Frame einen Keyframe oder ändern sich, andere nicht. Klicken setzt überall einen Keyframe</translation>
    </message>
    <message>
        <source>Something is still being written. Files that are finished stay; the rest is not written.</source>
        <translation>Es wird noch etwas geschrieben. Fertige Dateien bleiben; der Rest wird nicht geschrieben.</translation>
    </message>
    <message>
        <source>Something went wrong inside ROAM</source>
        <translation>In ROAM ist etwas schiefgegangen</translation>
    </message>
    <message>
        <source>Something went wrong inside ROAM. {kept}</source>
        <translation>In ROAM ist etwas schiefgegangen. {kept}</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <source>Span a rectangle; Shift makes it a square</source>
        <translation>Rechteck aufziehen; Umschalt macht es zum Quadrat</translation>
    </message>
    <message>
        <source>Span an ellipse; Shift makes it a circle</source>
        <translation>Ellipse aufziehen; Umschalt macht sie zum Kreis</translation>
    </message>
    <message>
        <source>Specks</source>
        <translation>Flecken</translation>
    </message>
    <message>
        <source>Splines of other numbers of points than the first were left out: no point moves between them.</source>
        <translation>Splines mit anderer Punktzahl als der erste entfallen: Zwischen ihnen bewegt sich kein Punkt.</translation>
    </message>
    <message>
        <source>Split shape</source>
        <translation>Form teilen</translation>
    </message>
    <message>
        <source>Split {name} into {count} shapes?</source>
        <translation>{name} in {count} Formen teilen?</translation>
    </message>
    <message>
        <source>Stabilise view</source>
        <translation>Ansicht stabilisieren</translation>
    </message>
    <message>
        <source>Stabilised</source>
        <translation>Stabilisiert</translation>
    </message>
    <message>
        <source>Stale file handle</source>
        <translation>Die Datei auf dem Server gibt es nicht mehr</translation>
    </message>
    <message>
        <source>Stand still after the chosen keys, or this one</source>
        <translation>Nach den gewählten Keyframes oder diesem stillstehen</translation>
    </message>
    <message>
        <source>Starting to fill {names} …</source>
        <translation>Füllen von {names} beginnt …</translation>
    </message>
    <message>
        <source>Starting to track {names} …</source>
        <translation>Tracken von {names} beginnt …</translation>
    </message>
    <message>
        <source>Starting {count} processes …</source>
        <translation>{count} Prozesse werden gestartet …</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Status</translation>
    </message>
    <message>
        <source>Steadiness</source>
        <translation>Ruhe</translation>
    </message>
    <message>
        <source>Steady</source>
        <translation>Beruhigen</translation>
    </message>
    <message>
        <source>Steady the outline</source>
        <translation>Umriss beruhigen</translation>
    </message>
    <message>
        <source>Steady the outline…</source>
        <translation>Umriss beruhigen…</translation>
    </message>
    <message>
        <source>Steadying the outlines …</source>
        <translation>Umrisse werden beruhigt …</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Stop it and close</source>
        <translation>Abbrechen und schließen</translation>
    </message>
    <message>
        <source>Stop the export and close?</source>
        <translation>Den Export abbrechen und schließen?</translation>
    </message>
    <message>
        <source>Stop; the frames that are finished stay</source>
        <translation>Anhalten; die fertigen Frames bleiben</translation>
    </message>
    <message>
        <source>Stop; what is finished stays</source>
        <translation>Anhalten; was fertig ist, bleibt</translation>
    </message>
    <message>
        <source>Stop; what is finished stays  ({keys})</source>
        <translation>Anhalten; was fertig ist, bleibt  ({keys})</translation>
    </message>
    <message>
        <source>Stopped measuring.</source>
        <translation>Messung angehalten.</translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation>Angehalten.</translation>
    </message>
    <message>
        <source>Stopped; no edge was changed.</source>
        <translation>Angehalten; keine Kante wurde geändert.</translation>
    </message>
    <message>
        <source>Stopped; no key was moved.</source>
        <translation>Angehalten; kein Keyframe wurde bewegt.</translation>
    </message>
    <message>
        <source>Stopped; pictures that are finished stay.</source>
        <translation>Angehalten; die fertigen Bilder bleiben.</translation>
    </message>
    <message>
        <source>Stretch</source>
        <translation>Strecken</translation>
    </message>
    <message>
        <source>Stretch keys</source>
        <translation>Keyframes strecken</translation>
    </message>
    <message>
        <source>Stretch keys…</source>
        <translation>Keyframes strecken…</translation>
    </message>
    <message>
        <source>Stretch {keys}: they go from frame {first} to {last}.</source>
        <translation>{keys} strecken: sie reichen von Frame {first} bis {last}.</translation>
    </message>
    <message>
        <source>Style rules with {rule} were left out.</source>
        <translation>Stilregeln mit {rule} entfallen.</translation>
    </message>
    <message>
        <source>Subtract</source>
        <translation>Subtrahieren</translation>
    </message>
    <message>
        <source>Swap left and right of what is selected</source>
        <translation>Links und rechts der Auswahl vertauschen</translation>
    </message>
    <message>
        <source>Swap top and bottom of what is selected</source>
        <translation>Oben und unten der Auswahl vertauschen</translation>
    </message>
    <message>
        <source>Take it out of the main window, to another monitor, or put it back</source>
        <translation>Aus dem Hauptfenster nehmen, auf einen anderen Monitor, oder zurücksetzen</translation>
    </message>
    <message>
        <source>Take it over</source>
        <translation>Übernehmen</translation>
    </message>
    <message>
        <source>Take off this list</source>
        <translation>Aus dieser Liste nehmen</translation>
    </message>
    <message>
        <source>Take the preset and the keys of a file in place of your own</source>
        <translation>Vorgabe und Tasten einer Datei anstelle der eigenen übernehmen</translation>
    </message>
    <message>
        <source>Tall timeline</source>
        <translation>Hohe Zeitleiste</translation>
    </message>
    <message>
        <source>Tangents</source>
        <translation>Tangenten</translation>
    </message>
    <message>
        <source>Ten frames back</source>
        <translation>Zehn Frames zurück</translation>
    </message>
    <message>
        <source>Ten frames on</source>
        <translation>Zehn Frames weiter</translation>
    </message>
    <message>
        <source>The B-spline {name!r} is written as Bezier: the same curve, with other handles.</source>
        <translation>Der B-Spline {name!r} wird als Bézier geschrieben: dieselbe Kurve mit anderen Tangenten.</translation>
    </message>
    <message>
        <source>The OpenColorIO configuration {path} cannot be read: {reason}. Correct ${variable}, or unset it.</source>
        <translation>Die OpenColorIO-Konfiguration {path} kann nicht gelesen werden: {reason}. ${variable} korrigieren oder löschen.</translation>
    </message>
    <message>
        <source>The area around a point is too small to know it again by: make it larger.</source>
        <translation>Der Bereich um einen Punkt ist zu klein, um ihn daran wiederzuerkennen: größer machen.</translation>
    </message>
    <message>
        <source>The area of specks must be a number of square pixels, not {speckle:g}.</source>
        <translation>Die Fläche von Flecken muss eine Zahl von Quadratpixeln sein, nicht {speckle:g}.</translation>
    </message>
    <message>
        <source>The bitmap mask {name} was left out: its picture is not made of masks.</source>
        <translation>Die Bitmap-Maske {name} entfällt: Ihr Bild besteht nicht aus Masken.</translation>
    </message>
    <message>
        <source>The blue channel alone, and back</source>
        <translation>Nur der blaue Kanal, und zurück</translation>
    </message>
    <message>
        <source>The border of {name}, which moves its edge, is not read.</source>
        <translation>Der Rand von {name}, der die Kante verschiebt, wird nicht gelesen.</translation>
    </message>
    <message>
        <source>The box is too small; drag one of at least {least:.0f} pixels around the object.</source>
        <translation>Der Rahmen ist zu klein; einen von mindestens {least:.0f} Pixeln um das Objekt ziehen.</translation>
    </message>
    <message>
        <source>The box leaves no background around the object; drag one that does not fill the picture.</source>
        <translation>Der Rahmen lässt keinen Hintergrund um das Objekt; einen ziehen, der das Bild nicht ausfüllt.</translation>
    </message>
    <message>
        <source>The clip begins here: there is no frame to track to.</source>
        <translation>Der Clip beginnt hier: Es gibt keinen Frame, zu dem getrackt werden könnte.</translation>
    </message>
    <message>
        <source>The clip ends here: there is no frame to track to.</source>
        <translation>Der Clip endet hier: Es gibt keinen Frame, zu dem getrackt werden könnte.</translation>
    </message>
    <message>
        <source>The clip is read so from now on; save to keep that.</source>
        <translation>Der Clip wird von jetzt an so gelesen; speichern, um das zu behalten.</translation>
    </message>
    <message>
        <source>The clip {path} is {size} now; the project was made for {before}. Put the old clip back, or open the project and choose another.</source>
        <translation>Der Clip {path} ist jetzt {size}; das Projekt entstand für {before}. Den alten Clip zurücklegen oder das Projekt öffnen und einen anderen wählen.</translation>
    </message>
    <message>
        <source>The clip&apos;s frames a second; while it plays, those that are shown, and the speed</source>
        <translation>Frames pro Sekunde des Clips; beim Abspielen die gezeigten und die Geschwindigkeit</translation>
    </message>
    <message>
        <source>The clipboard</source>
        <translation>Die Zwischenablage</translation>
    </message>
    <message>
        <source>The clipboard holds no shapes of a kind that ROAM reads.</source>
        <translation>Die Zwischenablage enthält keine Formen einer Art, die ROAM liest.</translation>
    </message>
    <message>
        <source>The colour space {name!r} is not known; choose one of {spaces}, or of the OpenColorIO configuration: {others}.</source>
        <translation>Der Farbraum {name!r} ist nicht bekannt; einen aus {spaces} wählen oder aus der OpenColorIO-Konfiguration: {others}.</translation>
    </message>
    <message>
        <source>The colour space {space!r} is not known to the OpenColorIO configuration {path}; choose another, or set ${variable} to the one that has it.</source>
        <translation>Die OpenColorIO-Konfiguration {path} kennt den Farbraum {space!r} nicht; einen anderen wählen oder ${variable} auf die setzen, die ihn hat.</translation>
    </message>
    <message>
        <source>The copied keys are of other shapes: select those, or as many shapes as were copied.</source>
        <translation>Die kopierten Keyframes sind von anderen Formen: diese auswählen, oder so viele Formen, wie kopiert wurden.</translation>
    </message>
    <message>
        <source>The copied keys do not fit {names}: locked, or of other points, or beside the clip.</source>
        <translation>Die kopierten Keyframes passen nicht zu {names}: gesperrt, andere Punkte oder neben dem Clip.</translation>
    </message>
    <message>
        <source>The copied keys fit no shape here: shapes may be locked, or have other points.</source>
        <translation>Die kopierten Keyframes passen hier zu keiner Form: Formen sind vielleicht gesperrt oder haben andere Punkte.</translation>
    </message>
    <message>
        <source>The copied keys fit nothing here: what they go to may be locked or gone.</source>
        <translation>Die kopierten Keyframes passen hier nirgends: Ihr Ziel ist gesperrt oder nicht mehr da.</translation>
    </message>
    <message>
        <source>The defaults are used; it could not be set aside ({reason}).</source>
        <translation>Es gelten die Vorgaben; die Datei ließ sich nicht beiseitelegen ({reason}).</translation>
    </message>
    <message>
        <source>The defaults are used; it was set aside as {name}.</source>
        <translation>Es gelten die Vorgaben; die Datei wurde als {name} beiseitegelegt.</translation>
    </message>
    <message>
        <source>The demo shot cannot be written to {folder}: {reason}.</source>
        <translation>Der Demo-Shot lässt sich nicht nach {folder} schreiben: {reason}.</translation>
    </message>
    <message>
        <source>The demo shot is rendered …</source>
        <translation>Der Demo-Shot ist gerendert …</translation>
    </message>
    <message>
        <source>The demo shot: press &lt;track.forward&gt; to track the shape, &lt;track.stop&gt; to stop; drag its points to correct it.</source>
        <translation>Der Demo-Shot: &lt;track.forward&gt; trackt die Form, &lt;track.stop&gt; hält an; ihre Punkte lassen sich zur Korrektur ziehen.</translation>
    </message>
    <message>
        <source>The drag was dropped: its shape or the frame changed meanwhile.</source>
        <translation>Das Ziehen wurde verworfen: Seine Form oder der Frame hat sich inzwischen geändert.</translation>
    </message>
    <message>
        <source>The drawing measures {wide} x {high}: it was fitted to the clip&apos;s {clip_width} x {clip_height} pixels, each axis by its own ratio.</source>
        <translation>Die Zeichnung misst {wide} x {high}: Sie wurde in die {clip_width} x {clip_height} Pixel des Clips eingepasst, jede Achse mit eigenem Faktor.</translation>
    </message>
    <message>
        <source>The drawing measures {wide} x {high}: it was fitted to the clip&apos;s {clip_width} x {clip_height} pixels.</source>
        <translation>Die Zeichnung misst {wide} x {high}: Sie wurde in die {clip_width} x {clip_height} Pixel des Clips eingepasst.</translation>
    </message>
    <message>
        <source>The energy is the engine&apos;s measure of how badly outlines agree with the picture:
the farther it falls, the more speaks for the change.</source>
        <translation>Die Energie misst, wie schlecht Umrisse mit dem Bild übereinstimmen:
je weiter sie fällt, desto mehr spricht für die Änderung.</translation>
    </message>
    <message>
        <source>The engine is being prepared, once on this machine; you can draw meanwhile.</source>
        <translation>Die Engine wird vorbereitet, einmal auf diesem Rechner; Zeichnen geht inzwischen.</translation>
    </message>
    <message>
        <source>The engine is prepared first, which may take a minute, once on this machine.</source>
        <translation>Zuerst wird die Engine vorbereitet, das dauert bis zu einer Minute, einmal auf diesem Rechner.</translation>
    </message>
    <message>
        <source>The engine is ready.</source>
        <translation>Die Engine ist bereit.</translation>
    </message>
    <message>
        <source>The engine&apos;s trust in this frame, 0 to 1</source>
        <translation>Das Vertrauen der Engine in diesen Frame, 0 bis 1</translation>
    </message>
    <message>
        <source>The feather curve of {name!r} is lost: Fusion&apos;s masks have one soft edge all around.</source>
        <translation>Die Kurve der weichen Kante von {name!r} geht verloren: Masken in Fusion sind rundum gleich weich.</translation>
    </message>
    <message>
        <source>The feather curve of {name!r} is written as outlines between it and the shape{more}: who moves the shape&apos;s path in another program does not move them.</source>
        <translation>Die weiche Kante von {name!r} wird als Umrisse zwischen ihr und der Form geschrieben{more}: Wer den Pfad der Form in einem anderen Programm bewegt, bewegt sie nicht mit.</translation>
    </message>
    <message>
        <source>The feather of {name!r} becomes a feather and an expansion of half its width, which together cover the same ground.</source>
        <translation>Aus der weichen Kante von {name!r} werden eine weiche Kante und eine Erweiterung um ihre halbe Breite, die zusammen dieselbe Fläche bedecken.</translation>
    </message>
    <message>
        <source>The feather of {name!r} is lost: how a Silhouette file holds it is not known.</source>
        <translation>Die weiche Kante von {name!r} geht verloren: Wie eine Silhouette-Datei sie hält, ist nicht bekannt.</translation>
    </message>
    <message>
        <source>The few numbers of the engine that are worth turning</source>
        <translation>Die wenigen Zahlen der Engine, an denen Drehen sich lohnt</translation>
    </message>
    <message>
        <source>The file ends within the node {name}: what is whole was read.</source>
        <translation>Die Datei endet mitten im Knoten {name}: Gelesen wurde, was vollständig ist.</translation>
    </message>
    <message>
        <source>The file speaks of pictures of {width:g} x {height:g} pixels, the clip has {clip_width} x {clip_height}: the shapes were scaled, each axis by its own ratio.</source>
        <translation>Die Datei spricht von Bildern mit {width:g} x {height:g} Pixeln, der Clip hat {clip_width} x {clip_height}: Die Formen wurden skaliert, jede Achse mit eigenem Faktor.</translation>
    </message>
    <message>
        <source>The file speaks of pictures of {width:g} x {height:g} pixels, the clip has {clip_width} x {clip_height}: the shapes were scaled.</source>
        <translation>Die Datei spricht von Bildern mit {width:g} x {height:g} Pixeln, der Clip hat {clip_width} x {clip_height}: Die Formen wurden skaliert.</translation>
    </message>
    <message>
        <source>The filter of {name} was left out.</source>
        <translation>Der Filter von {name} entfällt.</translation>
    </message>
    <message>
        <source>The first frame</source>
        <translation>Der erste Frame</translation>
    </message>
    <message>
        <source>The first frame of {path} is not that of the plate that the project was made on ({before}); check that the shapes fit the picture.</source>
        <translation>Der erste Frame von {path} ist nicht der der Plate, auf der das Projekt entstand ({before}); bitte prüfen, ob die Formen zum Bild passen.</translation>
    </message>
    <message>
        <source>The first frame to export</source>
        <translation>Der erste zu exportierende Frame</translation>
    </message>
    <message>
        <source>The folder {folder} cannot be made: {reason}.</source>
        <translation>Der Ordner {folder} kann nicht angelegt werden: {reason}.</translation>
    </message>
    <message>
        <source>The folder {folder} cannot be read: {reason}.</source>
        <translation>Der Ordner {folder} kann nicht gelesen werden: {reason}.</translation>
    </message>
    <message>
        <source>The folder {folder} cannot be written to; choose another or change its permissions.</source>
        <translation>In den Ordner {folder} kann nicht geschrieben werden; wählen Sie einen anderen oder ändern Sie seine Berechtigungen.</translation>
    </message>
    <message>
        <source>The folder {folder} does not exist; check the path.</source>
        <translation>Den Ordner {folder} gibt es nicht; prüfen Sie den Pfad.</translation>
    </message>
    <message>
        <source>The folder {wanted} cannot be written to: settings and the journal of edits are kept in {used} for now.</source>
        <translation>Der Ordner {wanted} ist nicht beschreibbar: Einstellungen und das Journal der Bearbeitungen liegen vorerst in {used}.</translation>
    </message>
    <message>
        <source>The format holds all that is chosen.</source>
        <translation>Das Format hält alles, was gewählt ist.</translation>
    </message>
    <message>
        <source>The four corners must stay corners of one surface: none of them may cross its sides.</source>
        <translation>Die vier Ecken müssen Ecken einer Fläche bleiben: keine darf deren Seiten überqueren.</translation>
    </message>
    <message>
        <source>The frame of the {what} of {name} was left out: what lies beyond it masks, too.</source>
        <translation>Ein Rahmen entfällt, {what} von {name}: Auch was außerhalb liegt, maskiert.</translation>
    </message>
    <message>
        <source>The frame of {name} was left out: what lies beyond it shows, too.</source>
        <translation>Der Rahmen von {name} entfällt: Auch was außerhalb liegt, ist zu sehen.</translation>
    </message>
    <message>
        <source>The frames on which a track moves the layer</source>
        <translation>Die Frames, auf denen ein Track die Ebene bewegt</translation>
    </message>
    <message>
        <source>The frames to export must lie between {first} and {last}, the clip&apos;s own.</source>
        <translation>Die Frames zum Exportieren müssen zwischen {first} und {last} liegen, denen des Clips.</translation>
    </message>
    <message>
        <source>The greater of both</source>
        <translation>Das größere von beiden</translation>
    </message>
    <message>
        <source>The green channel alone, and back</source>
        <translation>Nur der grüne Kanal, und zurück</translation>
    </message>
    <message>
        <source>The grey of {name} in a mask was read as its opacity.</source>
        <translation>Das Grau von {name} in einer Maske wurde als Deckkraft gelesen.</translation>
    </message>
    <message>
        <source>The images&apos; names do not number the clip&apos;s frames: they were taken in their order.</source>
        <translation>Die Namen der Bilder nummerieren nicht die Frames des Clips: Sie wurden der Reihe nach genommen.</translation>
    </message>
    <message>
        <source>The in point is here: move it, or clear in and out (&lt;time.clear_range&gt;), to track on.</source>
        <translation>Hier ist In: verschieben Sie es, oder löschen Sie In und Out (&lt;time.clear_range&gt;), um weiter zu tracken.</translation>
    </message>
    <message>
        <source>The inversion and visibility of the root layer are lost: it is no object.</source>
        <translation>Invertierung und Sichtbarkeit der obersten Ebene gehen verloren: Sie ist kein Objekt.</translation>
    </message>
    <message>
        <source>The journal builds on {name} as it was, and that file has changed or gone.</source>
        <translation>Das Journal baut auf {name} auf, wie es war; diese Datei hat sich geändert oder fehlt.</translation>
    </message>
    <message>
        <source>The journal is damaged: its last edits could not be put together.</source>
        <translation>Das Journal ist beschädigt: Seine letzten Bearbeitungen ließen sich nicht zusammensetzen.</translation>
    </message>
    <message>
        <source>The journal is damaged: what came after its last sound entry is lost.</source>
        <translation>Das Journal ist beschädigt: Was nach seinem letzten heilen Eintrag kam, ist verloren.</translation>
    </message>
    <message>
        <source>The journal is written again; it holds all your edits.</source>
        <translation>Das Journal wird wieder geschrieben; es enthält alle Bearbeitungen.</translation>
    </message>
    <message>
        <source>The journal {journal} has no beginning; nothing of it can be recovered.</source>
        <translation>Das Journal {journal} hat keinen Anfang; daraus lässt sich nichts wiederherstellen.</translation>
    </message>
    <message>
        <source>The key of {name!r} on frame {frame} does not say which configuration made it; track it again.</source>
        <translation>Der Keyframe von {name!r} auf Frame {frame} nennt nicht die Konfiguration, aus der er entstand; bitte neu tracken.</translation>
    </message>
    <message>
        <source>The key of {name!r} on frame {frame} is out of date: the artist&apos;s key, the clip or the parameters have changed since. Track it again first.</source>
        <translation>Der Keyframe von {name!r} auf Frame {frame} ist veraltet: Der eigene Keyframe, der Clip oder die Parameter haben sich seitdem geändert. Zuerst neu tracken.</translation>
    </message>
    <message>
        <source>The keys before and after, however far</source>
        <translation>Die Keyframes davor und danach, wie weit sie auch liegen</translation>
    </message>
    <message>
        <source>The keys lie on frames {begins} to {ends}, none of them on the clip&apos;s {first} to {last}: the shapes stand still there. &apos;roam import --frame-offset {shift}&apos; would begin with the clip.</source>
        <translation>Die Keyframes liegen auf den Frames {begins} bis {ends}, keiner davon auf denen des Clips, {first} bis {last}: Die Formen stehen dort still. &apos;roam import --frame-offset {shift}&apos; begänne mit dem Clip.</translation>
    </message>
    <message>
        <source>The keys lie on frames {low} to {high}, none of them on the clip&apos;s {first} to {last}; &lt;key.shift&gt; moves them.</source>
        <translation>Die Keyframes liegen auf den Frames {low} bis {high}, keiner davon auf denen des Clips, {first} bis {last}; &lt;key.shift&gt; verschiebt sie.</translation>
    </message>
    <message>
        <source>The keys of your shapes appear here.</source>
        <translation>Hier erscheinen die Keyframes der Formen.</translation>
    </message>
    <message>
        <source>The keys of {name} hold now.</source>
        <translation>Jetzt gelten die Tasten aus {name}.</translation>
    </message>
    <message>
        <source>The last frame</source>
        <translation>Der letzte Frame</translation>
    </message>
    <message>
        <source>The last frame to export</source>
        <translation>Der letzte zu exportierende Frame</translation>
    </message>
    <message>
        <source>The last frame to export lies before the first; name the earlier one first.</source>
        <translation>Der letzte Frame zum Exportieren liegt vor dem ersten; den früheren zuerst nennen.</translation>
    </message>
    <message>
        <source>The layer {name!r} cannot be moved into itself.</source>
        <translation>Die Ebene {name!r} kann nicht in sich selbst verschoben werden.</translation>
    </message>
    <message>
        <source>The mask bears no number of the clip&apos;s frames: its key stands on the first, {first}.</source>
        <translation>Die Maske trägt keine Nummer aus den Frames des Clips: Ihr Keyframe steht auf dem ersten, {first}.</translation>
    </message>
    <message>
        <source>The mask {name} was left out: {reason}.</source>
        <translation>Die Maske {name} entfällt: {reason}.</translation>
    </message>
    <message>
        <source>The mask {path} is {width}x{height}, the clip is {clip_width}x{clip_height}; give a mask of the start frame in the clip&apos;s size.</source>
        <translation>Die Maske {path} hat {width}x{height} Pixel, der Clip {clip_width}x{clip_height}; eine Maske des Startframes in der Größe des Clips angeben.</translation>
    </message>
    <message>
        <source>The matte could not be rendered</source>
        <translation>Die Matte konnte nicht gerendert werden</translation>
    </message>
    <message>
        <source>The matte is what lies outside of the shape</source>
        <translation>Die Matte ist, was außerhalb der Form liegt</translation>
    </message>
    <message>
        <source>The matte is what lies outside of the shapes of the layer</source>
        <translation>Die Matte ist, was außerhalb der Formen der Ebene liegt</translation>
    </message>
    <message>
        <source>The matte of all visible shapes</source>
        <translation>Die Matte aller sichtbaren Formen</translation>
    </message>
    <message>
        <source>The matte without its outlines, and back</source>
        <translation>Die Matte ohne ihre Umrisse, und zurück</translation>
    </message>
    <message>
        <source>The mattes of frames {other} and {frame} would both be named {name!r}.</source>
        <translation>Die Mattes der Frames {other} und {frame} hießen beide {name!r}.</translation>
    </message>
    <message>
        <source>The mattes would differ in the other program:</source>
        <translation>Die Mattes würden im anderen Programm abweichen:</translation>
    </message>
    <message>
        <source>The mode {mode} of the {subject} is none of ROAM&apos;s; it adds.</source>
        <translation>Den Modus {mode} von {subject} hat ROAM nicht; es wird addiert.</translation>
    </message>
    <message>
        <source>The motion of {name}: click to select its shapes</source>
        <translation>Die Bewegung von {name}: Klicken wählt ihre Formen aus</translation>
    </message>
    <message>
        <source>The moving centre of {name} is not read: it stays where its points are.</source>
        <translation>Der bewegte Mittelpunkt von {name} wird nicht gelesen: Die Form bleibt, wo ihre Punkte sind.</translation>
    </message>
    <message>
        <source>The name {name}… is too long; choose a shorter one.</source>
        <translation>Der Name {name}… ist zu lang; einen kürzeren wählen.</translation>
    </message>
    <message>
        <source>The next frame is a key already: there is nothing to track before it.</source>
        <translation>Der nächste Frame ist schon ein Keyframe: Davor gibt es nichts zu tracken.</translation>
    </message>
    <message>
        <source>The node {node} names no format, and was read as of the clip&apos;s, {own_width} x {own_height} pixels; its middle is that of {width:g} x {height:g}. If its shapes lie askew, set its format in Nuke.</source>
        <translation>Der Knoten {node} nennt kein Format und wurde in dem des Clips gelesen, {own_width} x {own_height} Pixel; seine Mitte ist die von {width:g} x {height:g}. Liegen die Formen schief, in Nuke das Format setzen.</translation>
    </message>
    <message>
        <source>The note of frame {frame} went with its mark; &lt;edit.undo&gt; brings it back.</source>
        <translation>Die Notiz von Frame {frame} ging mit ihrer Markierung; &lt;edit.undo&gt; bringt sie zurück.</translation>
    </message>
    <message>
        <source>The numbers of {path} run from {first} to {last}; that is no sequence of frames. Rename the files so that they count the frames.</source>
        <translation>Die Nummern von {path} laufen von {first} bis {last}; das ist keine Folge von Frames. Die Dateien so umbenennen, dass sie die Frames zählen.</translation>
    </message>
    <message>
        <source>The oldest steps go first</source>
        <translation>Die ältesten Schritte gehen zuerst</translation>
    </message>
    <message>
        <source>The one used last</source>
        <translation>Zuletzt benutzter</translation>
    </message>
    <message>
        <source>The opacity of the {subject} was left out: {reason}.</source>
        <translation>Die Deckkraft von {subject} entfällt: {reason}.</translation>
    </message>
    <message>
        <source>The out point is here: move it, or clear in and out (&lt;time.clear_range&gt;), to track on.</source>
        <translation>Hier ist Out: verschieben Sie es, oder löschen Sie In und Out (&lt;time.clear_range&gt;), um weiter zu tracken.</translation>
    </message>
    <message>
        <source>The outline colour of the copied shape, for the selected ones; mattes stay</source>
        <translation>Die Umrissfarbe der kopierten Form, für die ausgewählten; Mattes bleiben</translation>
    </message>
    <message>
        <source>The outlines of frames before and after</source>
        <translation>Die Umrisse der Frames davor und danach</translation>
    </message>
    <message>
        <source>The paint mode {mode} of {name} is not read; the mask is added.</source>
        <translation>Der Malmodus {mode} von {name} wird nicht gelesen; die Maske wird addiert.</translation>
    </message>
    <message>
        <source>The paint of {name} in a mask is no plain colour: it was read as white.</source>
        <translation>Die Füllung von {name} in einer Maske ist keine einfache Farbe: Sie wurde als Weiß gelesen.</translation>
    </message>
    <message>
        <source>The path of {name} is damaged: what stands before the damage was read.</source>
        <translation>Der Pfad von {name} ist beschädigt: Gelesen wurde, was vor dem Schaden steht.</translation>
    </message>
    <message>
        <source>The picture alone; Esc leaves</source>
        <translation>Nur das Bild; Esc verlässt es</translation>
    </message>
    <message>
        <source>The picture of this frame is still being made; pin it once it is there.</source>
        <translation>Das Bild dieses Frames entsteht noch; vergleichen Sie damit, sobald es da ist.</translation>
    </message>
    <message>
        <source>The pictures are {first} and so on.</source>
        <translation>Die Bilder heißen {first} und so weiter.</translation>
    </message>
    <message>
        <source>The pixel under the pointer; the values are the plate&apos;s own, before exposure and gamma</source>
        <translation>Das Pixel unter dem Zeiger; die Werte sind die der Plate, vor Belichtung und Gamma</translation>
    </message>
    <message>
        <source>The plane also tilts a little</source>
        <translation>Die Fläche kippt auch ein wenig</translation>
    </message>
    <message>
        <source>The plane moves, and neither turns nor grows</source>
        <translation>Die Fläche bewegt sich, ohne sich zu drehen oder zu wachsen</translation>
    </message>
    <message>
        <source>The plane moves, turns and comes nearer: most things far away</source>
        <translation>Die Fläche bewegt sich, dreht sich und kommt näher: das meiste, was weit entfernt ist</translation>
    </message>
    <message>
        <source>The plane tilts as screens and walls near the camera do</source>
        <translation>Die Fläche kippt, wie Bildschirme und Wände nahe der Kamera</translation>
    </message>
    <message>
        <source>The plane was lost on frame {frame}: it would tip over; try a simpler motion.</source>
        <translation>Die Fläche ging auf Frame {frame} verloren: Sie würde kippen; eine einfachere Bewegung versuchen.</translation>
    </message>
    <message>
        <source>The plane was lost on frame {frame}: too little of it looks as it did; start again there, or leave out what covers it.</source>
        <translation>Die Fläche ging auf Frame {frame} verloren: Zu wenig davon sieht aus wie zuvor; dort neu beginnen, oder auslassen, was sie verdeckt.</translation>
    </message>
    <message>
        <source>The plate alone</source>
        <translation>Nur die Plate</translation>
    </message>
    <message>
        <source>The plate could not be opened; choose it again in the File menu. {error}</source>
        <translation>Die Plate ließ sich nicht öffnen; sie kann im Menü Datei neu gewählt werden. {error}</translation>
    </message>
    <message>
        <source>The plate has frames {first} to {last} now, the project {before} to {after}; File &gt; Relink clip takes them.</source>
        <translation>Die Plate hat jetzt die Frames {first} bis {last}, das Projekt {before} bis {after}; Datei &gt; Clip neu verknüpfen übernimmt sie.</translation>
    </message>
    <message>
        <source>The plate inside of the matte, on a ground</source>
        <translation>Die Plate innerhalb der Matte, auf einem Hintergrund</translation>
    </message>
    <message>
        <source>The plate is not where it was: choose it again with File &gt; Relink clip</source>
        <translation>Die Plate ist nicht mehr an ihrem Ort: mit Datei &gt; Clip neu verknüpfen neu wählen</translation>
    </message>
    <message>
        <source>The plate is {name} now; save to keep that.</source>
        <translation>Die Plate ist jetzt {name}; durch Speichern bleibt das so.</translation>
    </message>
    <message>
        <source>The plate of the project is not there: File &gt; Relink clip says where it lies.</source>
        <translation>Die Plate des Projekts ist nicht da: Datei &gt; Clip neu verknüpfen sagt, wo sie liegt.</translation>
    </message>
    <message>
        <source>The plate shows the same pictures, numbered from {now} now, not from {before}. Tracked frames stay up to date if you shift them now; with Keys &gt; Shift in time later they do not.</source>
        <translation>Die Plate zeigt dieselben Bilder, jetzt ab {now} nummeriert statt ab {before}. Jetzt verschoben bleiben getrackte Frames aktuell; später mit Keyframes &gt; Zeitlich verschieben nicht.</translation>
    </message>
    <message>
        <source>The plate was read anew. Track again what it shows otherwise now.</source>
        <translation>Die Plate wurde neu gelesen. Was sie nun anders zeigt, noch einmal tracken.</translation>
    </message>
    <message>
        <source>The plate was read anew: it has changed; save to keep that.</source>
        <translation>Die Plate wurde neu gelesen: Sie hat sich geändert; durch Speichern bleibt das so.</translation>
    </message>
    <message>
        <source>The plate with its shapes</source>
        <translation>Die Plate mit ihren Formen</translation>
    </message>
    <message>
        <source>The points lie on one line, or on one another: put them apart.</source>
        <translation>Die Punkte liegen auf einer Linie oder aufeinander: bitte auseinanderziehen.</translation>
    </message>
    <message>
        <source>The pre-warp {name!r} wants landmarks; give the configuration LandmarkParams.</source>
        <translation>Der Pre-Warp {name!r} braucht Landmarken; der Konfiguration LandmarkParams geben.</translation>
    </message>
    <message>
        <source>The process that decodes answered without a {name} that makes sense; the file is damaged.</source>
        <translation>Die Antwort des dekodierenden Prozesses enthält kein brauchbares {name}; die Datei ist beschädigt.</translation>
    </message>
    <message>
        <source>The process that decodes pictures cannot be started ({reason}); install ROAM again, or set ROAM_DECODER=inside to do without one.</source>
        <translation>Der Prozess, der Bilder dekodiert, lässt sich nicht starten ({reason}); ROAM neu installieren, oder ROAM_DECODER=inside setzen, dann geht es ohne.</translation>
    </message>
    <message>
        <source>The project cannot be saved: {reason}; take some away.</source>
        <translation>Das Projekt kann nicht gespeichert werden: {reason}; einige entfernen.</translation>
    </message>
    <message>
        <source>The project has no clip yet; open a folder of images or a movie first.</source>
        <translation>Das Projekt hat noch keinen Clip; zuerst einen Ordner mit Bildern oder einen Film öffnen.</translation>
    </message>
    <message>
        <source>The project holds no closed shape, and MLT&apos;s splines are closed; nothing was written.</source>
        <translation>Das Projekt enthält keine geschlossene Form, und Splines von MLT sind geschlossen; nichts wurde geschrieben.</translation>
    </message>
    <message>
        <source>The project is being saved …</source>
        <translation>Das Projekt wird gespeichert …</translation>
    </message>
    <message>
        <source>The project is too large for a file that can be opened again; take keys or shapes away.</source>
        <translation>Das Projekt ist zu groß für eine Datei, die sich wieder öffnen lässt; Keyframes oder Formen entfernen.</translation>
    </message>
    <message>
        <source>The project was changed meanwhile; nothing was opened.</source>
        <translation>Das Projekt wurde inzwischen geändert; es wurde nichts geöffnet.</translation>
    </message>
    <message>
        <source>The range holds no frame; its last frame lies before its first.</source>
        <translation>Der Bereich enthält keinen Frame; sein letzter liegt vor dem ersten.</translation>
    </message>
    <message>
        <source>The reach of smoothing must be a positive number of pixels, not {reach:g}.</source>
        <translation>Die Reichweite der Glättung muss eine positive Zahl von Pixeln sein, nicht {reach:g}.</translation>
    </message>
    <message>
        <source>The red channel alone, and back</source>
        <translation>Nur der rote Kanal, und zurück</translation>
    </message>
    <message>
        <source>The selected shapes alone, in any format</source>
        <translation>Nur die ausgewählten Formen, in jedem Format</translation>
    </message>
    <message>
        <source>The selected shapes are B-spline already.</source>
        <translation>Die ausgewählten Formen sind schon B-Splines.</translation>
    </message>
    <message>
        <source>The selected shapes are Bezier already.</source>
        <translation>Die ausgewählten Formen sind schon Bézier.</translation>
    </message>
    <message>
        <source>The selected shapes, or all, as a node to paste into a script</source>
        <translation>Ausgewählte oder alle Formen als Node zum Einfügen in ein Skript</translation>
    </message>
    <message>
        <source>The selected shapes, or all, as nodes to paste into a flow</source>
        <translation>Ausgewählte oder alle Formen als Nodes zum Einfügen in einen Flow</translation>
    </message>
    <message>
        <source>The shape exists on some frames only</source>
        <translation>Die Form existiert nur auf manchen Frames</translation>
    </message>
    <message>
        <source>The shape is locked; unlock it to change its keys.</source>
        <translation>Die Form ist gesperrt; erst entsperrt lassen sich ihre Keyframes ändern.</translation>
    </message>
    <message>
        <source>The shape is locked; unlock it to move its keys.</source>
        <translation>Die Form ist gesperrt; erst entsperrt lassen sich ihre Keyframes verschieben.</translation>
    </message>
    <message>
        <source>The shape stands still there: other keys in the range give way.</source>
        <translation>Dort steht die Form still: Andere Keyframes im Bereich weichen.</translation>
    </message>
    <message>
        <source>The shape {name!r} has a point on frame {frame} that lies nowhere near the image; correct or delete it first.</source>
        <translation>Die Form {name!r} hat auf Frame {frame} einen Punkt, der weitab vom Bild liegt; ihn zuerst korrigieren oder löschen.</translation>
    </message>
    <message>
        <source>The shape {name!r} has a point on frame {frame} that lies nowhere near the image; correct or delete it, then export again.</source>
        <translation>Die Form {name!r} hat auf Frame {frame} einen Punkt, der weitab vom Bild liegt; ihn korrigieren oder löschen, dann noch einmal exportieren.</translation>
    </message>
    <message>
        <source>The shape {name!r} has keys on frames beyond {most}, which Nuke rounds.</source>
        <translation>Die Form {name!r} hat Keyframes jenseits von Frame {most}, die Nuke rundet.</translation>
    </message>
    <message>
        <source>The shape {name!r} is locked, or lies in a locked layer; unlock that before it is solved.</source>
        <translation>Die Form {name!r} ist gesperrt oder liegt in einer gesperrten Ebene; vor dem Berechnen entsperren.</translation>
    </message>
    <message>
        <source>The shape {name} follows the expression {expression}, which is not run: it was left out.</source>
        <translation>Die Form {name} folgt der Expression {expression}, die nicht ausgeführt wird: Sie entfällt.</translation>
    </message>
    <message>
        <source>The shape {name} was left out: {reason}.</source>
        <translation>Die Form {name} entfällt: {reason}.</translation>
    </message>
    <message>
        <source>The shapes are hidden; show them (overlay view) to draw and edit.</source>
        <translation>Die Formen sind ausgeblendet; zum Zeichnen und Bearbeiten bitte einblenden (Ansicht Overlay).</translation>
    </message>
    <message>
        <source>The shapes chosen by the button beside lie before it, hidden or not</source>
        <translation>Die mit der Schaltfläche daneben gewählten Formen liegen davor, ausgeblendet oder nicht</translation>
    </message>
    <message>
        <source>The smooth spans of {name!r} become linear keys on every frame, straight between frames.</source>
        <translation>Aus den weichen Abschnitten von {name!r} werden lineare Keyframes auf jedem Frame, dazwischen geht es gerade.</translation>
    </message>
    <message>
        <source>The soft edge goes over to your next keys, through the tracked frames between; &lt;feather.all_keys&gt; gives it to all.</source>
        <translation>Die weiche Kante geht durch die getrackten Frames in die nächsten eigenen Keyframes über; &lt;feather.all_keys&gt; gibt sie allen.</translation>
    </message>
    <message>
        <source>The soft edge of {name} lies on both sides of its outline; it was read as outside.</source>
        <translation>Die weiche Kante von {name} liegt zu beiden Seiten des Umrisses; sie wurde als außen gelesen.</translation>
    </message>
    <message>
        <source>The stroke {name} came as an open shape, without its brush.</source>
        <translation>Der Strich {name} kam als offene Form, ohne seinen Pinsel.</translation>
    </message>
    <message>
        <source>The style rule for {rule} was not understood and left out.</source>
        <translation>Die Stilregel für {rule} ist unverständlich und entfällt.</translation>
    </message>
    <message>
        <source>The sum of both, as projects of earlier versions added: soft edges that overlap grow hard</source>
        <translation>Die Summe beider, wie Projekte früherer Versionen addierten: sich überlappende weiche Kanten werden hart</translation>
    </message>
    <message>
        <source>The tangents in opacity or feather of {name!r} become linear keys on every frame.</source>
        <translation>Aus den Tangenten in Deckkraft oder weicher Kante von {name!r} werden lineare Keyframes auf jedem Frame.</translation>
    </message>
    <message>
        <source>The tolerance of masks must be a positive number of pixels, not {tolerance:g}.</source>
        <translation>Die Toleranz der Masken muss eine positive Zahl von Pixeln sein, nicht {tolerance:g}.</translation>
    </message>
    <message>
        <source>The tolerance of reduced keys must be a positive number of pixels, not {tolerance:g}.</source>
        <translation>Die Toleranz reduzierter Keyframes muss eine positive Zahl von Pixeln sein, nicht {tolerance:g}.</translation>
    </message>
    <message>
        <source>The tool {name} is no polygon mask and was left out of its chain.</source>
        <translation>Das Werkzeug {name} ist keine Polygonmaske und entfällt in seiner Kette.</translation>
    </message>
    <message>
        <source>The track {name!r} goes where no image is; it cannot be exported.</source>
        <translation>Der Track {name!r} führt dorthin, wo kein Bild ist, und kann nicht exportiert werden.</translation>
    </message>
    <message>
        <source>The translation {code!r} is not installed; choose another language in the settings.</source>
        <translation>Die Übersetzung {code!r} ist nicht installiert; bitte in den Einstellungen eine andere Sprache wählen.</translation>
    </message>
    <message>
        <source>The whole project, what is locked and notes too</source>
        <translation>Das ganze Projekt, auch Gesperrtes und Notizen</translation>
    </message>
    <message>
        <source>The width and feather of single points of {name} were left out.</source>
        <translation>Breite und weiche Kante einzelner Punkte von {name} entfallen.</translation>
    </message>
    <message>
        <source>The width of lines was left out; {lines_only} of the outlines are drawn as lines only.</source>
        <translation>Die Breite von Linien entfällt; nur als Linien gezeichnete Umrisse: {lines_only}.</translation>
    </message>
    <message>
        <source>The {property} of the layer {name} was left out: {reason}.</source>
        <translation>{property} der Ebene {name} entfällt: {reason}.</translation>
    </message>
    <message>
        <source>The {property} of the {subject} varies: it was read as {value}, its first key.</source>
        <translation>{property} von {subject} ändert sich: Gelesen wurde {value}, der erste Keyframe.</translation>
    </message>
    <message>
        <source>The {subject}: keys of the kind {kinds} were read as linear.</source>
        <translation>{subject}: Keyframes der Art {kinds} wurden linear gelesen.</translation>
    </message>
    <message>
        <source>The {subject}: {meaning} was left out.</source>
        <translation>{subject}: {meaning} entfällt.</translation>
    </message>
    <message>
        <source>The {subject}: {told}.</source>
        <translation>{subject}: {told}.</translation>
    </message>
    <message>
        <source>The {what} of {name} is given in shares of its box: it was left out.</source>
        <translation>{what} von {name} steht in Anteilen des umgebenden Rechtecks und entfällt.</translation>
    </message>
    <message>
        <source>The {what} of {name} is no outline of the drawing: it was left out.</source>
        <translation>{what} von {name} ist kein Umriss der Zeichnung und entfällt.</translation>
    </message>
    <message>
        <source>The {what} of {name} was left out ({reason}).</source>
        <translation>{what} von {name} entfällt ({reason}).</translation>
    </message>
    <message>
        <source>Their keys lie on frames {low} to {high}, none of them on the clip&apos;s {first} to {last}: nothing varies here.</source>
        <translation>Ihre Keyframes liegen auf Frame {low} bis {high}, keiner davon im Clip von {first} bis {last}: Hier ändert sich nichts mit der Zeit.</translation>
    </message>
    <message>
        <source>Then</source>
        <translation>Dann</translation>
    </message>
    <message>
        <source>There are no instances with an outline in the file.</source>
        <translation>In der Datei sind keine Instanzen mit einem Umriss.</translation>
    </message>
    <message>
        <source>There are no outlines in the drawing.</source>
        <translation>In der Zeichnung sind keine Umrisse.</translation>
    </message>
    <message>
        <source>There are no outlines in the file.</source>
        <translation>In der Datei sind keine Umrisse.</translation>
    </message>
    <message>
        <source>There is a file of that name in {folder}, now that {suffix} is added to it. It would be lost.</source>
        <translation>Mit dem ergänzten {suffix} gibt es in {folder} schon eine Datei dieses Namens. Sie ginge verloren.</translation>
    </message>
    <message>
        <source>There is no clip yet; open one.</source>
        <translation>Es gibt noch keinen Clip; einen öffnen.</translation>
    </message>
    <message>
        <source>There is no closed shape to track; draw one, or select one, first.</source>
        <translation>Es gibt keine geschlossene Form zum Tracken; zuerst eine zeichnen oder auswählen.</translation>
    </message>
    <message>
        <source>There is no closed shape yet</source>
        <translation>Noch gibt es keine geschlossene Form</translation>
    </message>
    <message>
        <source>There is no display to open a window on; use the command line (roam --help), or log in with a display or X forwarding.</source>
        <translation>Es gibt keinen Bildschirm für ein Fenster; bitte die Kommandozeile benutzen (roam --help) oder sich mit Bildschirm oder X-Weiterleitung anmelden.</translation>
    </message>
    <message>
        <source>There is no export format {name!r}; there are: {known}.</source>
        <translation>Es gibt kein Exportformat {name!r}; es gibt: {known}.</translation>
    </message>
    <message>
        <source>There is no feather here to reset; the Feather number stands in the Shape panel.</source>
        <translation>Hier ist kein Feather zurückzusetzen; die Zahl Feather steht im Formbereich.</translation>
    </message>
    <message>
        <source>There is no font for text.</source>
        <translation>Es gibt keine Schrift für Text.</translation>
    </message>
    <message>
        <source>There is no font {font!r}; name the file of one.</source>
        <translation>Es gibt keine Schrift {font!r}; die Datei einer Schrift angeben.</translation>
    </message>
    <message>
        <source>There is no frame of {words!r} between {first} and {last}.</source>
        <translation>Zwischen {first} und {last} gibt es keinen Frame von {words!r}.</translation>
    </message>
    <message>
        <source>There is no frame to track backward to.</source>
        <translation>Es gibt keinen Frame, zu dem rückwärts getrackt werden könnte.</translation>
    </message>
    <message>
        <source>There is no frame to track forward to.</source>
        <translation>Es gibt keinen Frame, zu dem vorwärts getrackt werden könnte.</translation>
    </message>
    <message>
        <source>There is no frame to track to.</source>
        <translation>Es gibt keinen Frame, zu dem getrackt werden könnte.</translation>
    </message>
    <message>
        <source>There is no frame to track; name the one to begin on, and those to go to.</source>
        <translation>Es gibt keinen Frame zum Tracken; den ersten nennen und die, zu denen es geht.</translation>
    </message>
    <message>
        <source>There is no frame to write.</source>
        <translation>Es gibt keinen Frame zu schreiben.</translation>
    </message>
    <message>
        <source>There is no gap to fill here: set a key (&lt;key.set&gt;) on two frames, with others between them.</source>
        <translation>Hier ist keine Lücke zu füllen: auf zwei Frames mit anderen dazwischen einen Keyframe setzen (&lt;key.set&gt;).</translation>
    </message>
    <message>
        <source>There is no image of frame {frame}; give one, or raise MissingFrame where the plate has none.</source>
        <translation>Von Frame {frame} gibt es kein Bild; eines geben, oder MissingFrame auslösen, wo die Plate keines hat.</translation>
    </message>
    <message>
        <source>There is no key after this frame.</source>
        <translation>Nach diesem Frame gibt es keinen Keyframe.</translation>
    </message>
    <message>
        <source>There is no key before this frame.</source>
        <translation>Vor diesem Frame gibt es keinen Keyframe.</translation>
    </message>
    <message>
        <source>There is no key on frame {frame} to delete.</source>
        <translation>Auf Frame {frame} ist kein Keyframe, der zu löschen wäre.</translation>
    </message>
    <message>
        <source>There is no key to paste; copy keys in the timeline first.</source>
        <translation>Es gibt keinen Keyframe zum Einfügen; zuerst Keyframes in der Zeitleiste kopieren.</translation>
    </message>
    <message>
        <source>There is no key to paste; copy one first.</source>
        <translation>Es gibt keinen Keyframe zum Einfügen; zuerst einen kopieren.</translation>
    </message>
    <message>
        <source>There is no keymap {name!r}; choose one that lies in resources/keymaps.</source>
        <translation>Es gibt keine Tastenbelegung {name!r}; bitte eine aus resources/keymaps wählen.</translation>
    </message>
    <message>
        <source>There is no mark after this frame.</source>
        <translation>Nach diesem Frame gibt es keine Markierung.</translation>
    </message>
    <message>
        <source>There is no mark before this frame.</source>
        <translation>Vor diesem Frame gibt es keine Markierung.</translation>
    </message>
    <message>
        <source>There is no picture of this frame to find edges in (yet).</source>
        <translation>Von diesem Frame gibt es (noch) kein Bild, in dem sich Kanten finden ließen.</translation>
    </message>
    <message>
        <source>There is no picture of this frame to look at (yet).</source>
        <translation>Von diesem Frame gibt es (noch) kein Bild.</translation>
    </message>
    <message>
        <source>There is no plate to track in; open a clip first.</source>
        <translation>Es gibt keine Plate zum Tracken; zuerst einen Clip öffnen.</translation>
    </message>
    <message>
        <source>There is no pre-warp {name!r}; choose none, klt or flow.</source>
        <translation>Es gibt keinen Pre-Warp {name!r}; none, klt oder flow wählen.</translation>
    </message>
    <message>
        <source>There is no room for decoded pictures {place} ({reason}); make room there, raise the limit of a file&apos;s size, or set ROAM_DECODER=inside to do without.</source>
        <translation>Für dekodierte Bilder ist {place} kein Platz ({reason}); dort Platz schaffen, die Grenze für Dateigrößen anheben, oder ROAM_DECODER=inside setzen, dann geht es ohne.</translation>
    </message>
    <message>
        <source>There is no shape here that can be reshaped; draw one, or unlock and show it.</source>
        <translation>Hier ist keine Form, die sich verformen ließe; bitte eine zeichnen oder entsperren und einblenden.</translation>
    </message>
    <message>
        <source>There is no shape to copy for {programs}; draw one first.</source>
        <translation>Es gibt keine Form, die sich für {programs} kopieren ließe; zuerst eine zeichnen.</translation>
    </message>
    <message>
        <source>There is no shape to fill; draw one, or select one, first.</source>
        <translation>Es gibt keine Form zum Füllen; zuerst eine zeichnen oder auswählen.</translation>
    </message>
    <message>
        <source>There is no shape to paste; copy one first, here or in another program.</source>
        <translation>Es gibt keine Form zum Einfügen; zuerst eine kopieren, hier oder in einem anderen Programm.</translation>
    </message>
    <message>
        <source>There is no shape to track yet</source>
        <translation>Noch gibt es keine Form zum Tracken</translation>
    </message>
    <message>
        <source>There is no shape to track; draw one, or select one, first.</source>
        <translation>Es gibt keine Form zum Tracken; zuerst eine zeichnen oder auswählen.</translation>
    </message>
    <message>
        <source>There is no shape whose properties could be pasted; copy one first.</source>
        <translation>Es gibt keine Form, deren Eigenschaften sich einfügen ließen; zuerst eine kopieren.</translation>
    </message>
    <message>
        <source>There is no track to export.</source>
        <translation>Es gibt keinen Track zum Exportieren.</translation>
    </message>
    <message>
        <source>There is nothing to compare yet; open a clip first.</source>
        <translation>Es gibt noch nichts zu vergleichen; zuerst einen Clip öffnen.</translation>
    </message>
    <message>
        <source>There is nothing to export yet; open a clip first.</source>
        <translation>Es gibt noch nichts zu exportieren; zuerst einen Clip öffnen.</translation>
    </message>
    <message>
        <source>There is nothing to fill from frame {start} to {stop}: no shape has two artist keys there. Set a key on both ends first.</source>
        <translation>Von Frame {start} bis {stop} ist nichts zu füllen: keine Form hat dort zwei eigene Keyframes. Zuerst an beiden Enden einen setzen.</translation>
    </message>
    <message>
        <source>There is nothing to recover.</source>
        <translation>Es gibt nichts wiederherzustellen.</translation>
    </message>
    <message>
        <source>There is nothing to shift: the project has neither keys nor notes.</source>
        <translation>Nichts zu verschieben: Das Projekt hat weder Keyframes noch Notizen.</translation>
    </message>
    <message>
        <source>There is nothing to show yet; open a clip first.</source>
        <translation>Es gibt noch nichts zu zeigen; zuerst einen Clip öffnen.</translation>
    </message>
    <message>
        <source>There is too little of the picture there; drag a box around the object.</source>
        <translation>Dort ist zu wenig vom Bild; einen Rahmen um das Objekt ziehen.</translation>
    </message>
    <message>
        <source>They are lost if you do not.</source>
        <translation>Ohne Speichern gehen sie verloren.</translation>
    </message>
    <message>
        <source>This frame is not tracked</source>
        <translation>Dieser Frame ist nicht getrackt</translation>
    </message>
    <message>
        <source>Threads</source>
        <translation>Threads</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Zeitleiste</translation>
    </message>
    <message>
        <source>Timeline ruler</source>
        <translation>Zeitlineal</translation>
    </message>
    <message>
        <source>To</source>
        <comment>where it is written</comment>
        <translation>Nach</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Bis</translation>
    </message>
    <message>
        <source>To frame</source>
        <translation>Bis Frame</translation>
    </message>
    <message>
        <source>Too little motion to tell the shutter.</source>
        <translation>Zu wenig Bewegung, um den Verschluss zu bestimmen.</translation>
    </message>
    <message>
        <source>Too little of the picture lies inside the shapes to track a plane by it.</source>
        <translation>In den Formen liegt zu wenig vom Bild, um daran eine Fläche zu tracken.</translation>
    </message>
    <message>
        <source>Too many levels of symbolic links</source>
        <translation>Zu viele symbolische Links führen aufeinander</translation>
    </message>
    <message>
        <source>Too many open files</source>
        <translation>Zu viele Dateien sind geöffnet</translation>
    </message>
    <message>
        <source>Track</source>
        <translation>Tracking</translation>
    </message>
    <message>
        <source>Track backward</source>
        <translation>Rückwärts tracken</translation>
    </message>
    <message>
        <source>Track each of the selected shapes with no other</source>
        <translation>Jede der ausgewählten Formen ohne andere tracken</translation>
    </message>
    <message>
        <source>Track forward</source>
        <translation>Vorwärts tracken</translation>
    </message>
    <message>
        <source>Track one frame backward</source>
        <translation>Einen Frame rückwärts tracken</translation>
    </message>
    <message>
        <source>Track one frame forward</source>
        <translation>Einen Frame vorwärts tracken</translation>
    </message>
    <message>
        <source>Track points</source>
        <translation>Track-Punkte</translation>
    </message>
    <message>
        <source>Track the frames between two keys from both at once</source>
        <translation>Die Frames zwischen zwei Keyframes von beiden zugleich aus tracken</translation>
    </message>
    <message>
        <source>Track the selected shapes as one whole object</source>
        <translation>Die ausgewählten Formen als ein ganzes Objekt tracken</translation>
    </message>
    <message>
        <source>Track to the next key</source>
        <translation>Bis zum nächsten Keyframe tracken</translation>
    </message>
    <message>
        <source>Tracked frames are out of date: they were solved on other pictures.</source>
        <translation>Getrackte Frames sind veraltet: Sie wurden auf anderen Bildern berechnet.</translation>
    </message>
    <message>
        <source>Tracked frames of {names} are out of date: shapes join otherwise now.</source>
        <translation>Getrackte Frames von {names} sind veraltet: Formen mischen sich jetzt anders.</translation>
    </message>
    <message>
        <source>Tracked frames of {names} are out of date: what hides what goes by the order in the list.</source>
        <translation>Getrackte Frames von {names} sind veraltet: Was was verdeckt, richtet sich nach der Reihenfolge in der Liste.</translation>
    </message>
    <message>
        <source>Tracked frames of {names} are out of date: what is gone was a part of its object.</source>
        <translation>Getrackte Frames von {names} sind veraltet: Was gelöscht ist, war Teil desselben Objekts.</translation>
    </message>
    <message>
        <source>Tracked frames of {names} are out of date: what is new lies on it and counts as a part of its object. Move it away, or solve it by itself: &lt;object.apart&gt;.</source>
        <translation>Getrackte Frames von {names} sind veraltet: Was neu ist, liegt darauf und gilt als Teil desselben Objekts. Wegschieben oder für sich berechnen: &lt;object.apart&gt;.</translation>
    </message>
    <message>
        <source>Tracked {names} to frame {frame}: {paced}.{gaps}</source>
        <translation>{names} bis Frame {frame} getrackt: {paced}.{gaps}</translation>
    </message>
    <message>
        <source>Tracking stopped at frame {frame}; its frames were taken back.</source>
        <translation>Tracken bei Frame {frame} angehalten; seine Frames wurden zurückgenommen.</translation>
    </message>
    <message>
        <source>Tracking stopped at frame {frame}; the finished frames stay.</source>
        <translation>Tracken bei Frame {frame} angehalten; die fertigen Frames bleiben.</translation>
    </message>
    <message>
        <source>Tracking stopped before a frame was finished.</source>
        <translation>Tracken angehalten, bevor ein Frame fertig war.</translation>
    </message>
    <message>
        <source>Tracking {names} backward: {place}</source>
        <translation>{names} wird rückwärts getrackt: {place}</translation>
    </message>
    <message>
        <source>Tracking {names} forward: {place}</source>
        <translation>{names} wird vorwärts getrackt: {place}</translation>
    </message>
    <message>
        <source>Tracks hold how shapes and layers move, not their outlines.</source>
        <translation>Tracks halten, wie sich Formen und Ebenen bewegen, nicht ihre Umrisse.</translation>
    </message>
    <message>
        <source>Transform</source>
        <translation>Transformieren</translation>
    </message>
    <message>
        <source>Transform by numbers…</source>
        <translation>Nach Zahlen transformieren…</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Noch einmal versuchen</translation>
    </message>
    <message>
        <source>Turn all of them back to 100 %</source>
        <translation>Alle auf 100 % zurückdrehen</translation>
    </message>
    <message>
        <source>Turn at both ends</source>
        <translation>An beiden Enden umkehren</translation>
    </message>
    <message>
        <source>Turn tangent</source>
        <translation>Tangente drehen</translation>
    </message>
    <message>
        <source>Type another name, in the list</source>
        <translation>Einen anderen Namen eingeben, in der Liste</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Undo invert</source>
        <translation>Invertieren rückgängig</translation>
    </message>
    <message>
        <source>Undo invert layer</source>
        <translation>Invertieren der Ebene rückgängig</translation>
    </message>
    <message>
        <source>Undo {step}</source>
        <translation>{step} rückgängig machen</translation>
    </message>
    <message>
        <source>Undone: {text}.</source>
        <translation>Rückgängig gemacht: {text}.</translation>
    </message>
    <message>
        <source>Ungroup</source>
        <translation>Gruppierung aufheben</translation>
    </message>
    <message>
        <source>Unlock</source>
        <translation>Entsperren</translation>
    </message>
    <message>
        <source>Unlock layer</source>
        <translation>Ebene entsperren</translation>
    </message>
    <message>
        <source>Up to this frame</source>
        <translation>Bis zu diesem Frame</translation>
    </message>
    <message>
        <source>Versions, system and messages, to copy into an issue</source>
        <translation>Versionen, System und Meldungen, zum Kopieren in eine Fehlermeldung</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Viewer</source>
        <translation>Viewer</translation>
    </message>
    <message>
        <source>Visible</source>
        <translation>Sichtbar</translation>
    </message>
    <message>
        <source>Visible shapes above the tracked ones lie before the surface</source>
        <translation>Sichtbare Formen über den getrackten liegen vor der Fläche</translation>
    </message>
    <message>
        <source>Waiting for the picture of frame {frame} …</source>
        <translation>Das Bild von Frame {frame} wird erwartet …</translation>
    </message>
    <message>
        <source>What ROAM says is kept here.</source>
        <translation>Hier steht, was ROAM meldet.</translation>
    </message>
    <message>
        <source>What could be found out about it is below; your edits up to then are in the journal.</source>
        <translation>Was sich darüber herausfinden ließ, steht unten; die Bearbeitungen bis dahin sind im Journal.</translation>
    </message>
    <message>
        <source>What crashes left, and what was thrown away, session by session</source>
        <translation>Was Abstürze hinterließen und was verworfen wurde, Sitzung für Sitzung</translation>
    </message>
    <message>
        <source>What cuts the {what} of {name} itself was left out.</source>
        <translation>Es entfällt, was seinerseits zuschneidet: {what} von {name}.</translation>
    </message>
    <message>
        <source>What hides what, from this frame on; mattes go by the order in the list</source>
        <translation>Was was verdeckt, ab diesem Frame; Mattes gehen nach der Reihenfolge in der Liste</translation>
    </message>
    <message>
        <source>What is keyed, as curves over time</source>
        <translation>Was Keyframes hat, als Kurven über die Zeit</translation>
    </message>
    <message>
        <source>What is locked gives locked copies; &lt;shape.lock&gt; unlocks them.</source>
        <translation>Kopien von Gesperrtem sind gesperrt; &lt;shape.lock&gt; entsperrt sie.</translation>
    </message>
    <message>
        <source>What is locked stays; unlock it first (&lt;shape.lock&gt;).</source>
        <translation>Was gesperrt ist, bleibt; zuerst entsperren (&lt;shape.lock&gt;).</translation>
    </message>
    <message>
        <source>What is selected</source>
        <translation>Was ausgewählt ist</translation>
    </message>
    <message>
        <source>What is selected is locked; unlock it first (&lt;shape.lock&gt;).</source>
        <translation>Die Auswahl ist gesperrt; zuerst entsperren (&lt;shape.lock&gt;).</translation>
    </message>
    <message>
        <source>What is solved together. By outlines: shapes that overlap or touch are parts, which move by themselves and hang together; the outlines of one mask or path are one whole; others are objects of their own, however near they lie.</source>
        <translation>Was zusammen getrackt wird. Nach Umrissen: Formen, die sich überlappen oder berühren, sind Teile, die sich selbst bewegen und zusammenhängen; die Umrisse einer Maske oder eines Pfads sind ein Ganzes; alle anderen sind eigene Objekte, auch wenn sie nah beieinanderliegen.</translation>
    </message>
    <message>
        <source>What lies in a hidden layer takes no part in the matte</source>
        <translation>Was in einer ausgeblendeten Ebene liegt, zählt nicht zur Matte</translation>
    </message>
    <message>
        <source>What lies in a locked layer cannot be changed by hand</source>
        <translation>Was in einer gesperrten Ebene liegt, lässt sich nicht von Hand ändern</translation>
    </message>
    <message>
        <source>What the chosen keys belong to is locked; unlock it to stretch them.</source>
        <translation>Wozu die gewählten Keyframes gehören, ist gesperrt; zum Strecken entsperren.</translation>
    </message>
    <message>
        <source>What the cut-out lies on</source>
        <translation>Worauf der Freisteller liegt</translation>
    </message>
    <message>
        <source>What the format cannot hold</source>
        <translation>Was das Format nicht halten kann</translation>
    </message>
    <message>
        <source>What the list shows</source>
        <translation>Was die Liste zeigt</translation>
    </message>
    <message>
        <source>What the second viewer shows</source>
        <translation>Was der zweite Viewer zeigt</translation>
    </message>
    <message>
        <source>What the surface inside the shapes may do; choose the simplest that fits</source>
        <translation>Was die Fläche in den Formen tun darf; das Einfachste, das passt, ist das Beste</translation>
    </message>
    <message>
        <source>What was copied differs in its properties: copy one shape, or select as many.</source>
        <translation>Das Kopierte hat verschiedene Eigenschaften: eine Form kopieren, oder ebenso viele auswählen.</translation>
    </message>
    <message>
        <source>What {name} refers to ({key}) is not in the drawing: it was left out.</source>
        <translation>Worauf {name} verweist ({key}), ist nicht in der Zeichnung und entfällt.</translation>
    </message>
    <message>
        <source>What {name} refers to lies in another file, not opened: it was left out.</source>
        <translation>Worauf {name} verweist, liegt in einer anderen Datei, die nicht geöffnet wird, und entfällt.</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Mausrad</translation>
    </message>
    <message>
        <source>When it opens, counted from the frame</source>
        <translation>Wann er sich öffnet, vom Frame an gezählt</translation>
    </message>
    <message>
        <source>Where parts hang together, on frames with keys</source>
        <translation>Wo Teile zusammenhängen, auf Frames mit Keyframes</translation>
    </message>
    <message>
        <source>Where the engine trusts the outline</source>
        <translation>Wo die Engine dem Umriss traut</translation>
    </message>
    <message>
        <source>Where the selected points are, or the whole shape, from the left edge, in pixels</source>
        <translation>Wo die ausgewählten Punkte oder die ganze Form liegen, vom linken Rand, in Pixeln</translation>
    </message>
    <message>
        <source>Where the selected points are, or the whole shape, from the top edge, in pixels</source>
        <translation>Wo die ausgewählten Punkte oder die ganze Form liegen, vom oberen Rand, in Pixeln</translation>
    </message>
    <message>
        <source>Whether the node {name} is disabled varies: it was read as on.</source>
        <translation>Ob der Knoten {name} abgeschaltet ist, ändert sich: Er wurde als eingeschaltet gelesen.</translation>
    </message>
    <message>
        <source>Which channel is shown</source>
        <translation>Welcher Kanal zu sehen ist</translation>
    </message>
    <message>
        <source>Which frames the onion skin shows</source>
        <translation>Welche Frames die Zwiebelhaut zeigt</translation>
    </message>
    <message>
        <source>Which other shapes cover the surface: what lies inside them is not looked at, frame by frame</source>
        <translation>Welche anderen Formen die Fläche verdecken: Was in ihnen liegt, wird Frame für Frame nicht beachtet</translation>
    </message>
    <message>
        <source>Whole of {count} shapes</source>
        <translation>Ganzes aus {count} Formen</translation>
    </message>
    <message>
        <source>Width of an even soft edge; below zero it lies inside</source>
        <translation>Breite einer gleichmäßig weichen Kante; unter null liegt sie innen</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>With the object tool: mark more of the object, mark what is not it</source>
        <translation>Mit dem Objektwerkzeug: mehr vom Objekt markieren, markieren, was nicht dazugehört</translation>
    </message>
    <message>
        <source>Within</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>Work that is in no file</source>
        <translation>Arbeit, die in keiner Datei steht</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>Schreiben</translation>
    </message>
    <message>
        <source>Write note</source>
        <translation>Notiz schreiben</translation>
    </message>
    <message>
        <source>Write note…</source>
        <translation>Notiz schreiben…</translation>
    </message>
    <message>
        <source>Write over</source>
        <translation>Überschreiben</translation>
    </message>
    <message numerus="yes">
        <source>Write over {name} and %n other file(s)?</source>
        <translation>
            <numerusform>{name} und %n weitere Datei überschreiben?</numerusform>
            <numerusform>{name} und %n weitere Dateien überschreiben?</numerusform>
        </translation>
    </message>
    <message>
        <source>Write over {name}?</source>
        <translation>{name} überschreiben?</translation>
    </message>
    <message>
        <source>Write the preset and your own keys to a file, for another machine</source>
        <translation>Vorgabe und eigene Tasten in eine Datei schreiben, für einen anderen Rechner</translation>
    </message>
    <message>
        <source>Writing {name}</source>
        <translation>{name} wird geschrieben</translation>
    </message>
    <message>
        <source>Writing {name} …</source>
        <translation>{name} wird geschrieben …</translation>
    </message>
    <message>
        <source>Wrote {count} frame(s) at {fps:g} fps to {path}.</source>
        <translation>Nach {path} geschrieben, mit {fps:g} fps; Frames: {count}.</translation>
    </message>
    <message>
        <source>Wrote {count} frame(s) on {pages} page(s) to {path} and {more} more.</source>
        <translation>Nach {path} und {more} weiteren geschrieben; Frames: {count}, Seiten: {pages}.</translation>
    </message>
    <message>
        <source>Wrote {count} frame(s) on {pages} page(s) to {path}.</source>
        <translation>Nach {path} geschrieben; Frames: {count}, Seiten: {pages}.</translation>
    </message>
    <message>
        <source>Wrote {count} picture(s) to {path}.</source>
        <translation>Nach {path} geschrieben; Bilder: {count}.</translation>
    </message>
    <message>
        <source>Wrote {made} matte(s){place}.</source>
        <translation>Geschriebene Mattes{place}: {made}.</translation>
    </message>
    <message>
        <source>Wrote {made} matte(s){place}; {kept} there already.</source>
        <translation>Geschriebene Mattes{place}: {made}; schon vorhanden: {kept}.</translation>
    </message>
    <message>
        <source>You will be asked about {names} again.</source>
        <translation>Zu {names} wird wieder gefragt.</translation>
    </message>
    <message>
        <source>Your edits cannot be written to the journal ({reason}); save the project yourself.</source>
        <translation>Die Bearbeitungen lassen sich nicht ins Journal schreiben ({reason}); bitte das Projekt selbst speichern.</translation>
    </message>
    <message>
        <source>Your keys are in {path}.</source>
        <translation>Die Tasten stehen in {path}.</translation>
    </message>
    <message>
        <source>Your keys stay as they are; tracking again replaces what is moved.</source>
        <translation>Eigene Keyframes bleiben, wie sie sind; erneutes Tracken ersetzt, was bewegt wird.</translation>
    </message>
    <message>
        <source>Your own files are not changed until you save. What you leave here stays.</source>
        <translation>Die eigenen Dateien ändern sich erst beim Speichern. Was hier liegen bleibt, bleibt erhalten.</translation>
    </message>
    <message>
        <source>Your project is as it was, and every edit is in the journal.</source>
        <translation>Das Projekt ist, wie es war, und jede Bearbeitung ist im Journal.</translation>
    </message>
    <message>
        <source>Your work is still here. Save it elsewhere; or make room there, or see to the permissions, and try again.</source>
        <translation>Ihre Arbeit ist noch da. Speichern Sie sie an einem anderen Ort; oder schaffen Sie dort Platz oder Zugriffsrechte, und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>Your work is unharmed. Export elsewhere, or see to what stands in the way and try again.</source>
        <translation>Ihre Arbeit ist unversehrt. Exportieren Sie woandershin, oder beheben Sie das Hindernis und versuchen Sie es erneut.</translation>
    </message>
    <message>
        <source>Zoom at the pointer</source>
        <translation>Am Zeiger zoomen</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>Vergrößern</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>Verkleinern</translation>
    </message>
    <message>
        <source>Zoom time in</source>
        <translation>Zeit vergrößern</translation>
    </message>
    <message>
        <source>Zoom time out</source>
        <translation>Zeit verkleinern</translation>
    </message>
    <message>
        <source>a colour</source>
        <translation>eine Farbe</translation>
    </message>
    <message>
        <source>a depth</source>
        <translation>eine Tiefe</translation>
    </message>
    <message>
        <source>a feather of about {width}, which is a blur</source>
        <translation>eine weiche Kante von etwa {width}, als Unschärfe</translation>
    </message>
    <message>
        <source>a frame of a track</source>
        <translation>ein Frame eines Tracks</translation>
    </message>
    <message>
        <source>a frame of a transform</source>
        <translation>ein Frame einer Transformation</translation>
    </message>
    <message>
        <source>a frame of {name}</source>
        <translation>ein Frame ({name})</translation>
    </message>
    <message>
        <source>a key has no points</source>
        <translation>ein Keyframe hat keine Punkte</translation>
    </message>
    <message>
        <source>a key has {found} parts</source>
        <translation>ein Keyframe hat {found} Teile</translation>
    </message>
    <message>
        <source>a key must be an object</source>
        <translation>ein Keyframe muss ein Objekt sein</translation>
    </message>
    <message>
        <source>a key&apos;s feather has shape {shape}, its points {points}</source>
        <translation>die weiche Kante eines Keyframes hat die Form {shape}, seine Punkte {points}</translation>
    </message>
    <message>
        <source>a key&apos;s points have shape {shape}, not (P, 3, 2)</source>
        <translation>die Punkte eines Keyframes haben die Form {shape}, nicht (P, 3, 2)</translation>
    </message>
    <message>
        <source>a key&apos;s vertex_confidence has shape {shape}, its points {points}</source>
        <translation>die Konfidenz der Punkte eines Keyframes hat die Form {shape}, seine Punkte {points}</translation>
    </message>
    <message>
        <source>a length of inputs</source>
        <translation>eine Länge von Grundlagen</translation>
    </message>
    <message>
        <source>a length of packed numbers</source>
        <translation>eine Länge gepackter Zahlen</translation>
    </message>
    <message>
        <source>a lifetime</source>
        <translation>eine Lebensdauer</translation>
    </message>
    <message>
        <source>a list of keys is empty</source>
        <translation>eine Liste von Keyframes ist leer</translation>
    </message>
    <message>
        <source>a list of numbers holds something else</source>
        <translation>eine Liste von Zahlen enthält etwas anderes</translation>
    </message>
    <message>
        <source>a list of packed numbers is damaged</source>
        <translation>eine Liste gepackter Zahlen ist beschädigt</translation>
    </message>
    <message>
        <source>a list stands where a number belongs</source>
        <translation>eine Liste steht, wo eine Zahl hingehört</translation>
    </message>
    <message>
        <source>a matrix of a transform has no inverse</source>
        <translation>eine Matrix einer Transformation hat keine Umkehrung</translation>
    </message>
    <message>
        <source>a matrix of a transform must be 3x3 numbers, the last not zero</source>
        <translation>eine Matrix einer Transformation muss aus 3x3 Zahlen bestehen, die letzte nicht null</translation>
    </message>
    <message>
        <source>a matrix sends it to infinity</source>
        <translation>eine Matrix führt ins Unendliche</translation>
    </message>
    <message>
        <source>a note on this frame</source>
        <translation>eine Notiz zu diesem Frame</translation>
    </message>
    <message>
        <source>a number is not finite</source>
        <translation>eine Zahl ist nicht endlich</translation>
    </message>
    <message>
        <source>a number of the project is not finite</source>
        <translation>eine Zahl des Projekts ist nicht endlich</translation>
    </message>
    <message>
        <source>a packed number is not finite</source>
        <translation>eine gepackte Zahl ist nicht endlich</translation>
    </message>
    <message>
        <source>a place of a track</source>
        <translation>eine Position eines Tracks</translation>
    </message>
    <message>
        <source>a point lies nowhere near the image</source>
        <translation>ein Punkt liegt weitab vom Bild</translation>
    </message>
    <message>
        <source>a point of it has {found} positions, not {count}</source>
        <translation>ein Punkt hat {found} Positionen, nicht {count}</translation>
    </message>
    <message>
        <source>a point of it lies nowhere near the image</source>
        <translation>ein Punkt davon liegt weitab vom Bild</translation>
    </message>
    <message>
        <source>a point that was set</source>
        <translation>ein gesetzter Punkt</translation>
    </message>
    <message>
        <source>a run of keys has none of the known forms</source>
        <translation>eine Folge von Keyframes hat keine der bekannten Formen</translation>
    </message>
    <message>
        <source>a spline must be a list of points</source>
        <translation>ein Spline muss eine Liste von Punkten sein</translation>
    </message>
    <message>
        <source>a surface has four corners</source>
        <translation>eine Fläche hat vier Ecken</translation>
    </message>
    <message>
        <source>a tangent of {name}</source>
        <translation>eine Tangente ({name})</translation>
    </message>
    <message>
        <source>a transform has none of the known forms</source>
        <translation>eine Transformation hat keine der bekannten Formen</translation>
    </message>
    <message>
        <source>a transform needs a frame for each matrix, and at least one</source>
        <translation>eine Transformation braucht zu jeder Matrix einen Frame, und mindestens eine</translation>
    </message>
    <message>
        <source>a value in it is of another kind than it must be</source>
        <translation>ein Wert darin ist von anderer Art, als er sein muss</translation>
    </message>
    <message>
        <source>a word stands where a key belongs</source>
        <translation>ein Wort steht, wo ein Keyframe hingehört</translation>
    </message>
    <message>
        <source>a word stands where a point belongs</source>
        <translation>ein Wort steht, wo ein Punkt hingehört</translation>
    </message>
    <message>
        <source>accept yes topology</source>
        <translation>annehmen ja topologie</translation>
    </message>
    <message>
        <source>add</source>
        <translation>Addieren</translation>
    </message>
    <message>
        <source>again repeat</source>
        <translation>nochmals wiederholen</translation>
    </message>
    <message>
        <source>all</source>
        <translation>alle</translation>
    </message>
    <message>
        <source>alone single isolate unlink</source>
        <translation>allein einzeln isolieren trennen</translation>
    </message>
    <message>
        <source>alpha mask black white</source>
        <translation>alpha maske schwarz weiß</translation>
    </message>
    <message>
        <source>alpha operation {operation!r}</source>
        <translation>Alpha-Operation {operation!r}</translation>
    </message>
    <message>
        <source>an adjust key</source>
        <translation>ein Korrektur-Keyframe</translation>
    </message>
    <message>
        <source>an animated value has no key</source>
        <translation>ein animierter Wert hat keinen Keyframe</translation>
    </message>
    <message>
        <source>an animated value has two keys on one frame</source>
        <translation>ein animierter Wert hat zwei Keyframes auf einem Frame</translation>
    </message>
    <message>
        <source>an area of a track&apos;s points</source>
        <translation>ein Bereich der Punkte eines Tracks</translation>
    </message>
    <message>
        <source>an impossible picture</source>
        <translation>einem unmöglichen Bild</translation>
    </message>
    <message>
        <source>and {count} more</source>
        <translation>und {count} weitere</translation>
    </message>
    <message>
        <source>as stacked again</source>
        <translation>wieder wie gestapelt</translation>
    </message>
    <message>
        <source>at both ends</source>
        <translation>an beiden Enden</translation>
    </message>
    <message>
        <source>at depth {level}</source>
        <translation>in Tiefe {level}</translation>
    </message>
    <message>
        <source>at quarter frames, too</source>
        <translation>auch auf Viertelbildern</translation>
    </message>
    <message>
        <source>attributes style color look outline match same transfer</source>
        <translation>attribute stil aussehen umriss angleichen gleich übertragen</translation>
    </message>
    <message>
        <source>attributes style parameters look settings values match same transfer</source>
        <translation>attribute stil parameter aussehen einstellungen werte angleichen gleich übertragen</translation>
    </message>
    <message>
        <source>attributes style settings values match same transfer</source>
        <translation>attribute stil einstellungen werte angleichen gleich übertragen</translation>
    </message>
    <message>
        <source>autokey keyframe record stopwatch</source>
        <translation>autokey keyframe aufzeichnen stoppuhr</translation>
    </message>
    <message>
        <source>begin start rewind home</source>
        <translation>anfang start zurückspulen</translation>
    </message>
    <message>
        <source>behind the others</source>
        <translation>hinter den anderen</translation>
    </message>
    <message>
        <source>below </source>
        <translation>unter </translation>
    </message>
    <message>
        <source>bezier handles ease spline curve animation smooth f-curve</source>
        <translation>bezier anfasser ease spline kurve animation weich f-kurve</translation>
    </message>
    <message>
        <source>boil</source>
        <translation>Flimmern</translation>
    </message>
    <message>
        <source>boil jitter tremble smooth stabilise stabilize temporal steadiness</source>
        <translation>flimmern zittern beben glätten stabilisieren beruhigen zeitlich ruhe</translation>
    </message>
    <message>
        <source>bookmark marker flag note</source>
        <translation>lesezeichen marker flagge notiz</translation>
    </message>
    <message>
        <source>bookmark marker jump</source>
        <translation>lesezeichen marker springen</translation>
    </message>
    <message>
        <source>bookmark marker label note comment remark annotate</source>
        <translation>lesezeichen marker beschriftung notiz kommentar anmerkung</translation>
    </message>
    <message>
        <source>bounce back and forth loop</source>
        <translation>pendeln vor und zurück schleife</translation>
    </message>
    <message>
        <source>brightness grey luma channel</source>
        <translation>helligkeit grau luma kanal</translation>
    </message>
    <message>
        <source>bug crash error issue trace support</source>
        <translation>fehler absturz problem hilfe</translation>
    </message>
    <message>
        <source>by</source>
        <translation>mal</translation>
    </message>
    <message>
        <source>cancel abort interrupt</source>
        <translation>abbrechen stopp unterbrechen</translation>
    </message>
    <message>
        <source>changes</source>
        <translation>Änderungen</translation>
    </message>
    <message>
        <source>channel rgb</source>
        <translation>kanal rgb</translation>
    </message>
    <message>
        <source>circle oval round draw roto mask</source>
        <translation>kreis oval rund zeichnen roto maske</translation>
    </message>
    <message>
        <source>clear track reset remove</source>
        <translation>track löschen zurücksetzen entfernen</translation>
    </message>
    <message>
        <source>clip path</source>
        <translation>Beschneidungspfad</translation>
    </message>
    <message>
        <source>clipboard</source>
        <translation>zwischenablage</translation>
    </message>
    <message>
        <source>clipboard davinci resolve setting mask node export</source>
        <translation>zwischenablage davinci resolve setting maske node export</translation>
    </message>
    <message>
        <source>clipboard insert</source>
        <translation>zwischenablage einsetzen</translation>
    </message>
    <message>
        <source>clipboard move</source>
        <translation>zwischenablage verschieben</translation>
    </message>
    <message>
        <source>clipboard roto node script export</source>
        <translation>zwischenablage roto node skript export</translation>
    </message>
    <message>
        <source>closer magnify larger enlarge</source>
        <translation>zoom näher größer lupe hineinzoomen</translation>
    </message>
    <message>
        <source>color rgb all channels</source>
        <translation>farbe rgb alle kanäle</translation>
    </message>
    <message>
        <source>commands search find</source>
        <translation>befehle suchen finden</translation>
    </message>
    <message>
        <source>comments remarks review list doubtful boil jitter flicker supervisor</source>
        <translation>kommentare anmerkungen review liste zweifelhaft flimmern zittern supervisor</translation>
    </message>
    <message>
        <source>composite comp cutout transparent background checkerboard colour</source>
        <translation>komposition freistellen ausschnitt transparent hintergrund schachbrett farbe</translation>
    </message>
    <message>
        <source>confidence</source>
        <translation>Konfidenz</translation>
    </message>
    <message>
        <source>confidence worst error fix bad</source>
        <translation>konfidenz schlechtester fehler korrigieren</translation>
    </message>
    <message>
        <source>confidence wrong error fix bad</source>
        <translation>konfidenz falsch fehler korrigieren</translation>
    </message>
    <message>
        <source>confidence wrong error fix bad boil jitter</source>
        <translation>konfidenz falsch fehler korrigieren flimmern zittern</translation>
    </message>
    <message>
        <source>confidence {confidence:.2f}</source>
        <translation>Konfidenz {confidence:.2f}</translation>
    </message>
    <message>
        <source>contact sheet thumbnails overview export pages print</source>
        <translation>kontaktbogen vorschaubilder übersicht export seiten drucken</translation>
    </message>
    <message>
        <source>convert tangents handles</source>
        <translation>umwandeln tangenten anfasser</translation>
    </message>
    <message>
        <source>convert xspline smooth</source>
        <translation>umwandeln xspline glatt</translation>
    </message>
    <message>
        <source>copy clone</source>
        <translation>kopieren klonen</translation>
    </message>
    <message>
        <source>corner linear sharp</source>
        <translation>ecke linear scharf</translation>
    </message>
    <message>
        <source>crash autosave backup journal lost restore</source>
        <translation>absturz sicherung journal verloren retten</translation>
    </message>
    <message>
        <source>cyclic finish open spline</source>
        <translation>zyklisch schließen öffnen spline</translation>
    </message>
    <message>
        <source>dd MMM yyyy</source>
        <translation>dd. MMM yyyy</translation>
    </message>
    <message>
        <source>delete all keys</source>
        <translation>alle Keyframes löschen</translation>
    </message>
    <message>
        <source>delete key</source>
        <translation>Keyframe löschen</translation>
    </message>
    <message>
        <source>depth order occlusion over above z</source>
        <translation>tiefe reihenfolge verdeckung über z</translation>
    </message>
    <message>
        <source>depth order occlusion reset z</source>
        <translation>tiefe reihenfolge verdeckung zurücksetzen z</translation>
    </message>
    <message>
        <source>depth order occlusion under below hidden z</source>
        <translation>tiefe reihenfolge verdeckung unter hinter z</translation>
    </message>
    <message>
        <source>deselect unselect clear selection</source>
        <translation>abwählen auswahl aufheben</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>Differenz</translation>
    </message>
    <message>
        <source>dissolve unparent folder</source>
        <translation>auflösen lösen ordner</translation>
    </message>
    <message>
        <source>dock panels back default workspace</source>
        <translation>andocken bereiche zurück standard arbeitsbereich</translation>
    </message>
    <message>
        <source>dopesheet keys height bigger large half</source>
        <translation>keyframes höhe größer halb</translation>
    </message>
    <message>
        <source>doubtful</source>
        <translation>zweifelhafte</translation>
    </message>
    <message>
        <source>each point must be a handle, a point and a handle of two numbers</source>
        <translation>jeder Punkt muss aus Tangente, Punkt und Tangente mit je zwei Zahlen bestehen</translation>
    </message>
    <message>
        <source>each point must be a list of two or six numbers, and there must be one</source>
        <translation>jeder Punkt muss eine Liste aus zwei oder sechs Zahlen sein, und einer muss da sein</translation>
    </message>
    <message>
        <source>empty begin</source>
        <translation>leer beginnen</translation>
    </message>
    <message>
        <source>end</source>
        <translation>ende</translation>
    </message>
    <message>
        <source>every </source>
        <translation>alle </translation>
    </message>
    <message>
        <source>everything splines layers</source>
        <translation>alles splines ebenen</translation>
    </message>
    <message>
        <source>example sample tutorial manta</source>
        <translation>beispiel muster anleitung manta</translation>
    </message>
    <message>
        <source>exit close leave</source>
        <translation>schließen verlassen ende</translation>
    </message>
    <message>
        <source>exit code {code}</source>
        <translation>Rückgabewert {code}</translation>
    </message>
    <message>
        <source>farther smaller reduce</source>
        <translation>zoom ferner kleiner herauszoomen</translation>
    </message>
    <message>
        <source>feather</source>
        <translation>weiche Kante</translation>
    </message>
    <message>
        <source>fewer pixels than were told</source>
        <translation>weniger Pixeln als angekündigt</translation>
    </message>
    <message>
        <source>filled between two keys</source>
        <translation>zwischen zwei Keyframes gefüllt</translation>
    </message>
    <message>
        <source>flip flop horizontal</source>
        <translation>spiegeln horizontal umdrehen</translation>
    </message>
    <message>
        <source>flip order clockwise winding path morph paint stroke</source>
        <translation>umdrehen reihenfolge uhrzeigersinn pfad morph strich</translation>
    </message>
    <message>
        <source>flip vertical</source>
        <translation>spiegeln vertikal umdrehen</translation>
    </message>
    <message>
        <source>focus keyboard accessibility tab region pane</source>
        <translation>fokus tastatur barrierefreiheit tab bereich</translation>
    </message>
    <message>
        <source>focus keyboard accessibility tab region pane back</source>
        <translation>fokus tastatur barrierefreiheit tab bereich zurück</translation>
    </message>
    <message>
        <source>folder group create</source>
        <translation>ordner gruppe anlegen</translation>
    </message>
    <message>
        <source>folder layer parent</source>
        <translation>ordner ebene gruppe</translation>
    </message>
    <message>
        <source>frame {frame} is missing or damaged</source>
        <translation>Frame {frame} fehlt oder ist beschädigt</translation>
    </message>
    <message>
        <source>frame {frame} of {last}</source>
        <translation>Frame {frame} von {last}</translation>
    </message>
    <message>
        <source>frames</source>
        <translation>Frames</translation>
    </message>
    <message>
        <source>frames between the keys of {name!r}</source>
        <translation>Frames zwischen den Keyframes von {name!r}</translation>
    </message>
    <message>
        <source>frames in its clip</source>
        <translation>Frames im Clip</translation>
    </message>
    <message>
        <source>frames {first} to {last}</source>
        <translation>Frames {first} bis {last}</translation>
    </message>
    <message>
        <source>freehand marquee</source>
        <translation>freihand rahmen</translation>
    </message>
    <message>
        <source>from {frame} {level}</source>
        <translation>ab {frame} {level}</translation>
    </message>
    <message>
        <source>fullscreen maximise maximize whole monitor theatre</source>
        <translation>vollbild maximieren ganzer monitor kino</translation>
    </message>
    <message>
        <source>gain gamma viewer neutral default</source>
        <translation>belichtung gamma viewer neutral standard</translation>
    </message>
    <message>
        <source>graph editor dope sheet f-curve animation keyframes handles</source>
        <translation>graph editor kurven animation keyframes anfasser</translation>
    </message>
    <message>
        <source>handles shape the curve now, and no outline changed</source>
        <translation>die Tangenten formen jetzt die Kurve, und kein Umriss hat sich geändert</translation>
    </message>
    <message>
        <source>here</source>
        <translation>hier</translation>
    </message>
    <message>
        <source>hidden: the motion goes evenly from the frames before to those after</source>
        <translation>verdeckt: Die Bewegung geht gleichmäßig von den Frames davor zu denen danach</translation>
    </message>
    <message>
        <source>hide show dopesheet</source>
        <translation>ausblenden einblenden zeitleiste</translation>
    </message>
    <message>
        <source>hold</source>
        <translation>halten</translation>
    </message>
    <message>
        <source>holds still up to the next key</source>
        <translation>hält bis zum nächsten Keyframe still</translation>
    </message>
    <message>
        <source>import footage mov mp4 quicktime read load</source>
        <translation>importieren film mov mp4 quicktime lesen laden</translation>
    </message>
    <message>
        <source>import footage plate read sequence images source load</source>
        <translation>importieren material plate lesen sequenz bilder quelle laden</translation>
    </message>
    <message>
        <source>in</source>
        <translation>In</translation>
    </message>
    <message>
        <source>in front of the others</source>
        <translation>vor den anderen</translation>
    </message>
    <message>
        <source>in memory</source>
        <translation>im Speicher</translation>
    </message>
    <message>
        <source>in {folder}</source>
        <translation>in {folder}</translation>
    </message>
    <message>
        <source>increment incremental up number next plus</source>
        <translation>inkrementell hochzählen nummer nächste plus</translation>
    </message>
    <message>
        <source>intelligent scissors edge snap draw roto mask path</source>
        <translation>kante einrasten zeichnen roto maske pfad schere</translation>
    </message>
    <message>
        <source>interpolate inbetween tween both directions</source>
        <translation>interpolieren zwischenbilder beide richtungen</translation>
    </message>
    <message>
        <source>interpolation easing ease</source>
        <translation>interpolation easing</translation>
    </message>
    <message>
        <source>interpolation easing ease bezier</source>
        <translation>interpolation easing bezier weich</translation>
    </message>
    <message>
        <source>interpolation easing ease step constant freeze</source>
        <translation>interpolation stufe konstant einfrieren</translation>
    </message>
    <message>
        <source>interpret footage colourspace fps frame rate pixel aspect channel read properties</source>
        <translation>Footage interpretieren Farbraum fps Bildrate Pixelseitenverhältnis Ebene lesen Eigenschaften</translation>
    </message>
    <message>
        <source>intersect</source>
        <translation>Schnittmenge</translation>
    </message>
    <message>
        <source>inversion</source>
        <translation>Invertierung</translation>
    </message>
    <message>
        <source>isolate alone only local view exclusive visibility eye</source>
        <translation>isolieren allein nur lokale ansicht sichtbarkeit auge</translation>
    </message>
    <message>
        <source>it answered with {what}</source>
        <translation>der dekodierende Prozess antwortete mit {what}</translation>
    </message>
    <message>
        <source>it does not end</source>
        <translation>kein Ende</translation>
    </message>
    <message>
        <source>it falls into more than {most} parts and holes</source>
        <translation>mehr als {most} Teile und Löcher</translation>
    </message>
    <message>
        <source>it has a point that lies nowhere near the picture</source>
        <translation>ein Punkt liegt weitab vom Bild</translation>
    </message>
    <message>
        <source>it has fewer than two points</source>
        <translation>weniger als zwei Punkte</translation>
    </message>
    <message>
        <source>it has more than {most} runs</source>
        <translation>mehr als {most} Läufe</translation>
    </message>
    <message>
        <source>it has more {what} than {most}</source>
        <translation>mehr {what} als {most}</translation>
    </message>
    <message>
        <source>it has no path</source>
        <translation>kein Pfad</translation>
    </message>
    <message>
        <source>it has no polyline</source>
        <translation>keine Polylinie</translation>
    </message>
    <message>
        <source>it has none of the known forms</source>
        <translation>keine der bekannten Formen</translation>
    </message>
    <message>
        <source>it has two keys on one frame</source>
        <translation>zwei Keyframes auf einem Frame</translation>
    </message>
    <message>
        <source>it has {count} entries of points, not three for each point</source>
        <translation>{count} Einträge für Punkte, nicht drei je Punkt</translation>
    </message>
    <message>
        <source>it is a {species} shape</source>
        <translation>eine Form der Art {species}</translation>
    </message>
    <message>
        <source>it is a {species} stroke</source>
        <translation>ein Strich der Art {species}</translation>
    </message>
    <message>
        <source>it is closed on some keys only</source>
        <translation>nur auf manchen Keyframes geschlossen</translation>
    </message>
    <message>
        <source>it is cut off</source>
        <translation>abgeschnitten</translation>
    </message>
    <message>
        <source>it is damaged</source>
        <translation>sie ist beschädigt</translation>
    </message>
    <message>
        <source>it is no text file</source>
        <translation>keine Textdatei</translation>
    </message>
    <message>
        <source>it is not valid JSON</source>
        <translation>kein gültiges JSON</translation>
    </message>
    <message>
        <source>it is of the kind {kind}</source>
        <translation>von der Art {kind}</translation>
    </message>
    <message>
        <source>it lies nowhere near the picture</source>
        <translation>weitab vom Bild</translation>
    </message>
    <message>
        <source>it speaks of pictures of {width:g} x {height:g} pixels</source>
        <translation>sie spricht von Bildern mit {width:g} x {height:g} Pixeln</translation>
    </message>
    <message>
        <source>it takes longer than {seconds:.0f} seconds</source>
        <translation>es dauert länger als {seconds:.0f} Sekunden</translation>
    </message>
    <message>
        <source>item {number} of {place}</source>
        <translation>Eintrag {number} in {place}</translation>
    </message>
    <message>
        <source>its blend mode {value:g} is none of ROAM&apos;s; it adds</source>
        <translation>den Mischmodus {value:g} hat ROAM nicht; es wird addiert</translation>
    </message>
    <message>
        <source>its blur</source>
        <translation>die Unschärfe</translation>
    </message>
    <message>
        <source>its clip ends, on frame {last}, before it begins, on frame {first}</source>
        <translation>der Clip endet, auf Frame {last}, bevor er beginnt, auf Frame {first}</translation>
    </message>
    <message>
        <source>its corner pin</source>
        <translation>der Eckenpin</translation>
    </message>
    <message>
        <source>its counts must be whole numbers</source>
        <translation>ihre Läufe müssen ganze Zahlen sein</translation>
    </message>
    <message>
        <source>its curve is smooth everywhere now, and its points moved by up to {moved:.1f} pixels</source>
        <translation>die Kurve ist jetzt überall glatt, und ihre Punkte haben sich um bis zu {moved:.1f} Pixel verschoben</translation>
    </message>
    <message>
        <source>its feather</source>
        <translation>die weiche Kante</translation>
    </message>
    <message>
        <source>its feather differs in x and y; it has the mean</source>
        <translation>die weiche Kante ist in x und y verschieden; es gilt der Mittelwert</translation>
    </message>
    <message>
        <source>its feather has not as many points as its outline</source>
        <translation>die weiche Kante hat nicht so viele Punkte wie der Umriss</translation>
    </message>
    <message>
        <source>its keys are of several kinds</source>
        <translation>die Keyframes sind von verschiedener Art</translation>
    </message>
    <message>
        <source>its keys differ in their number of points</source>
        <translation>die Keyframes haben verschieden viele Punkte</translation>
    </message>
    <message>
        <source>its keys have no path, or differ in their number of points</source>
        <translation>die Keyframes haben keinen Pfad oder verschieden viele Punkte</translation>
    </message>
    <message>
        <source>its points have none of the known forms</source>
        <translation>die Punkte haben keine der bekannten Formen</translation>
    </message>
    <message>
        <source>its shrinking or growing</source>
        <translation>das Schrumpfen oder Wachsen</translation>
    </message>
    <message>
        <source>its size must be a height and a width</source>
        <translation>ihre Größe muss eine Höhe und eine Breite sein</translation>
    </message>
    <message>
        <source>its spline {name} has a key that is none</source>
        <translation>der Spline {name} hat einen Keyframe, der keiner ist</translation>
    </message>
    <message>
        <source>its transform follows the expression {expression} and was left out</source>
        <translation>die Transformation folgt der Expression {expression} und entfällt</translation>
    </message>
    <message>
        <source>its transform was left out, {reason}</source>
        <translation>die Transformation entfällt, {reason}</translation>
    </message>
    <message>
        <source>its visibility is switched by keys; its opacity has them</source>
        <translation>die Sichtbarkeit wird durch Keyframes geschaltet; die Deckkraft hat sie nun</translation>
    </message>
    <message>
        <source>its {name!r} cannot be read</source>
        <translation>{name!r} ist nicht lesbar</translation>
    </message>
    <message>
        <source>its {name!r} follows an expression, which is not run; it has its last value</source>
        <translation>{name!r} folgt einer Expression, die nicht ausgeführt wird; es gilt der letzte Wert</translation>
    </message>
    <message>
        <source>its {name!r} is animated; it has the first value</source>
        <translation>{name!r} ist animiert; es gilt der erste Wert</translation>
    </message>
    <message>
        <source>its {name} is no number</source>
        <translation>{name} ist keine Zahl</translation>
    </message>
    <message>
        <source>jitter flicker steady flow temporal</source>
        <translation>zittern flimmern ruhig zeitlich</translation>
    </message>
    <message>
        <source>joint free unpin unparent rig</source>
        <translation>gelenk frei lösen rig</translation>
    </message>
    <message>
        <source>joint pin hinge parent rig</source>
        <translation>gelenk anheften scharnier rig</translation>
    </message>
    <message>
        <source>jump skip</source>
        <translation>springen</translation>
    </message>
    <message>
        <source>keyframe hold many frames</source>
        <translation>keyframe halten viele frames</translation>
    </message>
    <message>
        <source>keyframe insert add autokey</source>
        <translation>keyframe einfügen autokey</translation>
    </message>
    <message>
        <source>keyframe jump</source>
        <translation>keyframe springen</translation>
    </message>
    <message>
        <source>keyframe offset slip slide renumber conform handles move all frames</source>
        <translation>keyframe versatz versetzen umnummerieren conform alle frames</translation>
    </message>
    <message>
        <source>keyframe partial vertex single some add</source>
        <translation>keyframe teilweise punkt einzeln einige hinzufügen</translation>
    </message>
    <message>
        <source>keyframe partial vertex single some record</source>
        <translation>keyframe teilweise punkt einzeln einige aufzeichnen</translation>
    </message>
    <message>
        <source>keyframe pose</source>
        <translation>keyframe pose</translation>
    </message>
    <message>
        <source>keyframe remove</source>
        <translation>keyframe entfernen</translation>
    </message>
    <message>
        <source>keyframe scale retime time compress speed faster slower</source>
        <translation>Keyframe skalieren Retime Zeit stauchen Tempo schneller langsamer</translation>
    </message>
    <message>
        <source>keys</source>
        <translation>Keyframes</translation>
    </message>
    <message>
        <source>keys are not in the order of time</source>
        <translation>Keyframes stehen nicht in zeitlicher Reihenfolge</translation>
    </message>
    <message>
        <source>layer {name}</source>
        <translation>Ebene {name}</translation>
    </message>
    <message>
        <source>layers and shapes</source>
        <translation>Ebenen und Formen</translation>
    </message>
    <message>
        <source>layers in layers</source>
        <translation>Ebenen in Ebenen</translation>
    </message>
    <message>
        <source>letters in the clip&apos;s path</source>
        <translation>Buchstaben im Pfad des Clips</translation>
    </message>
    <message>
        <source>line: before, white dashes: after, hatched: what differs</source>
        <translation>Linie: vorher, weiße Striche: nachher, schraffiert: was sich unterscheidet</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>linear</translation>
    </message>
    <message>
        <source>linear straight draw roto mask path</source>
        <translation>linear gerade zeichnen roto maske pfad</translation>
    </message>
    <message>
        <source>link join group glue whole together</source>
        <translation>verbinden gruppe kleben ganz zusammen</translation>
    </message>
    <message>
        <source>list outliner layers hide show</source>
        <translation>Liste Ebenen Gliederung ausblenden einblenden</translation>
    </message>
    <message>
        <source>load script scene session</source>
        <translation>laden skript szene sitzung</translation>
    </message>
    <message>
        <source>loupe lens zoom window pixels precise</source>
        <translation>lupe linse vergrößerung zoom fenster pixel genau</translation>
    </message>
    <message>
        <source>magic wand quick selection rotobrush ai auto sam box</source>
        <translation>zauberstab schnellauswahl rotobrush ki automatisch</translation>
    </message>
    <message>
        <source>marked</source>
        <translation>markiert</translation>
    </message>
    <message>
        <source>marks</source>
        <translation>Markierungen</translation>
    </message>
    <message>
        <source>mask</source>
        <translation>Maske</translation>
    </message>
    <message>
        <source>mask black white channel</source>
        <translation>maske schwarz weiß kanal</translation>
    </message>
    <message>
        <source>mattes alpha segmentation load</source>
        <translation>mattes alpha segmentierung laden</translation>
    </message>
    <message>
        <source>max</source>
        <translation>Max</translation>
    </message>
    <message>
        <source>memory {used} of {limit}</source>
        <translation>Speicher {used} von {limit}</translation>
    </message>
    <message>
        <source>messages errors console</source>
        <translation>meldungen fehler konsole</translation>
    </message>
    <message>
        <source>mixed</source>
        <translation>gemischt</translation>
    </message>
    <message>
        <source>mode {mode!r}</source>
        <translation>Modus {mode!r}</translation>
    </message>
    <message>
        <source>more than {limit} keys stand for {limit} times</source>
        <translation>mehr als {limit} Keyframes stehen für {limit} Zeiten</translation>
    </message>
    <message>
        <source>more than {most} transforms in one list</source>
        <translation>mehr als {most} Transformationen in einer Liste</translation>
    </message>
    <message>
        <source>motion blur</source>
        <translation>Bewegungsunschärfe</translation>
    </message>
    <message>
        <source>motion tracker stabilise stabilize corner pin perspective mocha plane surface homography</source>
        <translation>tracker stabilisieren corner pin perspektive mocha ebene fläche</translation>
    </message>
    <message>
        <source>move rotate turn scale resize skew shear box jack gizmo</source>
        <translation>bewegen drehen größe skalieren neigen scheren rahmen</translation>
    </message>
    <message>
        <source>moves on evenly</source>
        <translation>bewegt sich gleichmäßig weiter</translation>
    </message>
    <message>
        <source>moves on smoothly</source>
        <translation>bewegt sich weich weiter</translation>
    </message>
    <message>
        <source>name title label call</source>
        <translation>name titel bezeichnung benennen</translation>
    </message>
    <message>
        <source>no line of JSON</source>
        <translation>keiner Zeile JSON</translation>
    </message>
    <message>
        <source>no picture</source>
        <translation>keinem Bild</translation>
    </message>
    <message>
        <source>no reason given</source>
        <translation>kein Grund genannt</translation>
    </message>
    <message>
        <source>no sentence</source>
        <translation>keinem Satz</translation>
    </message>
    <message>
        <source>no transform: {name!r} of {count} numbers</source>
        <translation>keine Transformation: {name!r} mit {count} Zahlen</translation>
    </message>
    <message>
        <source>no transform: {text!r}</source>
        <translation>keine Transformation: {text!r}</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>not installed</source>
        <translation>nicht installiert</translation>
    </message>
    <message>
        <source>not to be offered</source>
        <translation>soll nicht angeboten werden</translation>
    </message>
    <message>
        <source>not tracked</source>
        <translation>nicht getrackt</translation>
    </message>
    <message>
        <source>notes</source>
        <translation>Notizen</translation>
    </message>
    <message>
        <source>nuke silhouette fusion blender mocha after effects svg render write output</source>
        <translation>nuke silhouette fusion blender mocha after effects svg rendern schreiben ausgabe</translation>
    </message>
    <message>
        <source>nuke silhouette fusion svg roto load</source>
        <translation>nuke silhouette fusion svg roto laden</translation>
    </message>
    <message>
        <source>numeric move rotate scale type exact</source>
        <translation>zahlen bewegen drehen skalieren genau</translation>
    </message>
    <message>
        <source>of the plate</source>
        <translation>der Plate</translation>
    </message>
    <message>
        <source>on</source>
        <translation>auf</translation>
    </message>
    <message>
        <source>on whole frames and between them</source>
        <translation>auf ganzen Bildern und dazwischen</translation>
    </message>
    <message>
        <source>onionskin ghost light table frames before after</source>
        <translation>zwiebelhaut geister leuchttisch frames davor danach</translation>
    </message>
    <message>
        <source>only some shapes write output</source>
        <translation>nur einige formen schreiben ausgabe</translation>
    </message>
    <message>
        <source>opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>open on {host} by {user} since {when} (process {process})</source>
        <translation>auf {host} von {user} seit {when} geöffnet (Prozess {process})</translation>
    </message>
    <message>
        <source>order stack bring forward to front up above restack arrange</source>
        <translation>Reihenfolge Stapel in den Vordergrund heben darüber anordnen</translation>
    </message>
    <message>
        <source>order stack send backward to back down below restack arrange</source>
        <translation>Reihenfolge Stapel in den Hintergrund senken darunter anordnen</translation>
    </message>
    <message>
        <source>out</source>
        <translation>Out</translation>
    </message>
    <message>
        <source>packed numbers are not as many as they say</source>
        <translation>gepackte Zahlen sind nicht so viele wie angegeben</translation>
    </message>
    <message>
        <source>part {number} of {count}</source>
        <translation>Teil {number} von {count}</translation>
    </message>
    <message>
        <source>pen spline draw roto mask path</source>
        <translation>stift feder spline zeichnen roto maske pfad</translation>
    </message>
    <message>
        <source>pencil sketch lasso draw roto mask path</source>
        <translation>bleistift skizze lasso zeichnen roto maske pfad</translation>
    </message>
    <message>
        <source>pick arrow move edit transform deselect</source>
        <translation>pfeil bewegen bearbeiten transformieren abwählen</translation>
    </message>
    <message>
        <source>pictures</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>pictures beside each other</source>
        <translation>Bilder nebeneinander</translation>
    </message>
    <message>
        <source>pixels of width</source>
        <translation>Pixel Breite</translation>
    </message>
    <message>
        <source>planar track corner pin surface drift fix mocha keyframe</source>
        <translation>fläche track corner pin drift korrigieren mocha keyframe</translation>
    </message>
    <message>
        <source>plate footage rgb image</source>
        <translation>plate material rgb bild</translation>
    </message>
    <message>
        <source>plus</source>
        <translation>Plus</translation>
    </message>
    <message>
        <source>point mark begin work area range</source>
        <translation>punkt markieren anfang arbeitsbereich</translation>
    </message>
    <message>
        <source>point mark end work area range</source>
        <translation>punkt markieren ende arbeitsbereich</translation>
    </message>
    <message>
        <source>point tracker tracking one two four corners pattern search area follow</source>
        <translation>punkt tracker tracking eins zwei vier ecken muster suchbereich folgen</translation>
    </message>
    <message>
        <source>points in the shape {name!r}</source>
        <translation>Punkte in der Form {name!r}</translation>
    </message>
    <message>
        <source>points of a track need the sizes of two areas</source>
        <translation>Punkte eines Tracks brauchen die Größen zweier Bereiche</translation>
    </message>
    <message>
        <source>preferences options configuration memory cache threads scale</source>
        <translation>optionen konfiguration speicher cache threads größe sprache</translation>
    </message>
    <message>
        <source>propagate engine mode hide show</source>
        <translation>nachverfolgen Engine Modus ausblenden einblenden</translation>
    </message>
    <message>
        <source>propagate rotobrush follow solve motion tracker</source>
        <translation>propagieren rotobrush folgen tracker bewegung</translation>
    </message>
    <message>
        <source>propagate rotobrush follow solve play motion tracker</source>
        <translation>propagieren rotobrush folgen abspielen tracker bewegung</translation>
    </message>
    <message>
        <source>propagate step motion</source>
        <translation>propagieren schritt bewegung</translation>
    </message>
    <message>
        <source>propagate until</source>
        <translation>propagieren bis</translation>
    </message>
    <message>
        <source>properties attributes hide show</source>
        <translation>Eigenschaften Attribute ausblenden einblenden</translation>
    </message>
    <message>
        <source>properties attributes parameters motion blur shutter opacity transparency blend mode add subtract hole intersect difference invert colour color lifetime feather rename</source>
        <translation>eigenschaften attribute parameter bewegungsunschärfe verschluss deckkraft transparenz mischmodus addieren subtrahieren loch schnittmenge differenz invertieren farbe lebensdauer weiche kante umbenennen</translation>
    </message>
    <message>
        <source>properties sidebar column interface toggle</source>
        <translation>eigenschaften seitenleiste spalte oberfläche umschalten</translation>
    </message>
    <message>
        <source>proportional falloff magnet</source>
        <translation>proportional abfall magnet</translation>
    </message>
    <message>
        <source>protect</source>
        <translation>schützen</translation>
    </message>
    <message>
        <source>proxy resolution downres fast playback</source>
        <translation>proxy auflösung verkleinert schnell abspielen wiedergabe</translation>
    </message>
    <message>
        <source>proxy resolution pixels</source>
        <translation>proxy auflösung bildpunkte pixel</translation>
    </message>
    <message>
        <source>quicktime mp4 mov avi export playblast preview dailies supervisor render</source>
        <translation>quicktime mp4 mov avi export vorschau muster supervisor rendern</translation>
    </message>
    <message>
        <source>read from a file between two of its keys</source>
        <translation>aus einer Datei zwischen zweien ihrer Keyframes gelesen</translation>
    </message>
    <message>
        <source>recovered</source>
        <translation>wiederhergestellt</translation>
    </message>
    <message>
        <source>recovered work</source>
        <translation>wiederhergestellte Arbeit</translation>
    </message>
    <message>
        <source>refresh reread update plate footage changed rendered</source>
        <translation>auffrischen aktualisieren einlesen plate material geändert gerendert</translation>
    </message>
    <message>
        <source>reject no topology</source>
        <translation>ablehnen nein topologie</translation>
    </message>
    <message>
        <source>remove erase</source>
        <translation>entfernen löschen</translation>
    </message>
    <message>
        <source>remove erase vertex vertices</source>
        <translation>entfernen löschen punkt punkte</translation>
    </message>
    <message>
        <source>render alpha png exr tiff masks write output</source>
        <translation>rendern alpha png exr tiff masken schreiben ausgabe</translation>
    </message>
    <message>
        <source>repeat cycle</source>
        <translation>wiederholen zyklus</translation>
    </message>
    <message>
        <source>replace plate version footage path missing moved</source>
        <translation>ersetzen plate version material pfad fehlt verschoben</translation>
    </message>
    <message>
        <source>reset work area remove</source>
        <translation>zurücksetzen arbeitsbereich entfernen</translation>
    </message>
    <message>
        <source>reverse rewind</source>
        <translation>rückwärts zurückspulen</translation>
    </message>
    <message>
        <source>revert back</source>
        <translation>zurück</translation>
    </message>
    <message>
        <source>rig skeleton hinges bones pins</source>
        <translation>rig skelett gelenke knochen</translation>
    </message>
    <message>
        <source>rotation in depth</source>
        <translation>die Drehung in die Tiefe</translation>
    </message>
    <message>
        <source>roto node script write output</source>
        <translation>roto node skript schreiben ausgabe</translation>
    </message>
    <message>
        <source>rows of pictures</source>
        <translation>Reihen von Bildern</translation>
    </message>
    <message>
        <source>samples of motion blur</source>
        <translation>Abtastungen der Bewegungsunschärfe</translation>
    </message>
    <message>
        <source>saved</source>
        <translation>gespeichert</translation>
    </message>
    <message>
        <source>seam free contrast boundary outline kinds dashed dotted</source>
        <translation>naht frei kontrast grenze umriss arten gestrichelt gepunktet</translation>
    </message>
    <message>
        <source>search filter list name layer outliner</source>
        <translation>suchen filtern liste name ebene outliner</translation>
    </message>
    <message>
        <source>see its package</source>
        <translation>siehe Paket</translation>
    </message>
    <message>
        <source>set key</source>
        <translation>Keyframe setzen</translation>
    </message>
    <message>
        <source>set on {frame}</source>
        <translation>gesetzt auf {frame}</translation>
    </message>
    <message>
        <source>shape {name!r} has no key</source>
        <translation>die Form {name!r} hat keinen Keyframe</translation>
    </message>
    <message>
        <source>shape {name!r} has two keys on one frame</source>
        <translation>die Form {name!r} hat zwei Keyframes auf einem Frame</translation>
    </message>
    <message>
        <source>shape {name}</source>
        <translation>Form {name}</translation>
    </message>
    <message>
        <source>shape {name} ({place})</source>
        <translation>Form {name} ({place})</translation>
    </message>
    <message>
        <source>shapes splines</source>
        <translation>formen splines</translation>
    </message>
    <message>
        <source>shortcuts hotkeys keyboard bindings remap</source>
        <translation>tastenkürzel tastatur belegung</translation>
    </message>
    <message>
        <source>shortcuts hotkeys keyboard help</source>
        <translation>tastenkürzel tastatur hilfe</translation>
    </message>
    <message>
        <source>skew</source>
        <translation>die Scherung</translation>
    </message>
    <message>
        <source>slow half speed</source>
        <translation>langsam halbe geschwindigkeit</translation>
    </message>
    <message>
        <source>slow reverse half speed</source>
        <translation>langsam rückwärts halbe geschwindigkeit</translation>
    </message>
    <message>
        <source>smooth</source>
        <translation>weich</translation>
    </message>
    <message>
        <source>snapshot store buffer compare reference</source>
        <translation>schnappschuss merken vergleichen referenz</translation>
    </message>
    <message>
        <source>soft edge blur every frame copy</source>
        <translation>weiche kante unschärfe jeder frame kopieren</translation>
    </message>
    <message>
        <source>soft edge blur falloff</source>
        <translation>weiche kante unschärfe abfall</translation>
    </message>
    <message>
        <source>soft edge remove clear hard</source>
        <translation>weiche kante entfernen hart</translation>
    </message>
    <message>
        <source>soften feather softness blurred focus defocus shutter width</source>
        <translation>weichzeichnen unschärfe fokus defokus verschluss breite</translation>
    </message>
    <message>
        <source>splines outlines invisible</source>
        <translation>splines umrisse unsichtbar</translation>
    </message>
    <message>
        <source>split it into several files</source>
        <translation>auf mehrere Dateien aufteilen</translation>
    </message>
    <message>
        <source>square box quad draw roto mask</source>
        <translation>quadrat rahmen viereck zeichnen roto maske</translation>
    </message>
    <message>
        <source>stabilize follow lock steady centre still slide chatter drift mocha</source>
        <translation>stabilize stabilisierte Ansicht folgen verfolgen festhalten sperren ruhig zentrieren still rutschen zittern driften mocha</translation>
    </message>
    <message>
        <source>stands still</source>
        <translation>steht still</translation>
    </message>
    <message>
        <source>start run</source>
        <translation>starten laufen</translation>
    </message>
    <message>
        <source>start stop</source>
        <translation>starten stoppen</translation>
    </message>
    <message>
        <source>start vertex begin order morph paint stroke</source>
        <translation>startpunkt anfang reihenfolge morph strich</translation>
    </message>
    <message>
        <source>step back arrow</source>
        <translation>schritt zurück pfeil</translation>
    </message>
    <message>
        <source>step on arrow</source>
        <translation>schritt weiter pfeil</translation>
    </message>
    <message>
        <source>stop halt</source>
        <translation>stopp halt</translation>
    </message>
    <message>
        <source>subtract</source>
        <translation>Subtrahieren</translation>
    </message>
    <message>
        <source>surface plane corner pin mocha hide show</source>
        <translation>Oberfläche Ebene Eckpunkte mocha ausblenden einblenden</translation>
    </message>
    <message>
        <source>tangents</source>
        <translation>Tangenten</translation>
    </message>
    <message>
        <source>tangents curve handles</source>
        <translation>tangenten kurve anfasser</translation>
    </message>
    <message>
        <source>the clip&apos;s absolute path</source>
        <translation>der absolute Pfad des Clips</translation>
    </message>
    <message>
        <source>the clip&apos;s colour_space</source>
        <translation>colour_space des Clips</translation>
    </message>
    <message>
        <source>the clip&apos;s content</source>
        <translation>content des Clips</translation>
    </message>
    <message>
        <source>the clip&apos;s first frame</source>
        <translation>der erste Frame des Clips</translation>
    </message>
    <message>
        <source>the clip&apos;s fps</source>
        <translation>fps des Clips</translation>
    </message>
    <message>
        <source>the clip&apos;s height</source>
        <translation>die Höhe des Clips</translation>
    </message>
    <message>
        <source>the clip&apos;s last frame</source>
        <translation>der letzte Frame des Clips</translation>
    </message>
    <message>
        <source>the clip&apos;s layer</source>
        <translation>layer des Clips</translation>
    </message>
    <message>
        <source>the clip&apos;s path</source>
        <translation>der Pfad des Clips</translation>
    </message>
    <message>
        <source>the clip&apos;s path holds a null character</source>
        <translation>der Pfad des Clips enthält ein Nullzeichen</translation>
    </message>
    <message>
        <source>the clip&apos;s pixel_aspect</source>
        <translation>pixel_aspect des Clips</translation>
    </message>
    <message>
        <source>the clip&apos;s width</source>
        <translation>die Breite des Clips</translation>
    </message>
    <message>
        <source>the clipboard</source>
        <translation>die Zwischenablage</translation>
    </message>
    <message>
        <source>the colour of its paint</source>
        <translation>die Farbe der Füllung</translation>
    </message>
    <message>
        <source>the compound of a shape</source>
        <translation>compound einer Form</translation>
    </message>
    <message>
        <source>the confidence of a key</source>
        <translation>die Konfidenz eines Keyframes</translation>
    </message>
    <message>
        <source>the confidence of a track</source>
        <translation>die Konfidenz eines Tracks</translation>
    </message>
    <message>
        <source>the fall-off of its feather</source>
        <translation>der Abfall der weichen Kante</translation>
    </message>
    <message>
        <source>the feather has other points than the outline</source>
        <translation>die weiche Kante hat andere Punkte als der Umriss</translation>
    </message>
    <message>
        <source>the feather of a shape</source>
        <translation>die weiche Kante einer Form</translation>
    </message>
    <message>
        <source>the file</source>
        <translation>der Datei</translation>
    </message>
    <message>
        <source>the folder holds no image</source>
        <translation>im Ordner liegt kein Bild</translation>
    </message>
    <message>
        <source>the folder holds {names}</source>
        <translation>im Ordner liegen {names}</translation>
    </message>
    <message>
        <source>the frame of a key</source>
        <translation>der Frame eines Keyframes</translation>
    </message>
    <message>
        <source>the frame of a mark</source>
        <translation>der Frame einer Markierung</translation>
    </message>
    <message>
        <source>the frames of a transform must increase</source>
        <translation>die Frames einer Transformation müssen ansteigen</translation>
    </message>
    <message>
        <source>the frames of packed keys are no whole numbers</source>
        <translation>die Frames gepackter Keyframes sind keine ganzen Zahlen</translation>
    </message>
    <message>
        <source>the id of a layer</source>
        <translation>die id einer Ebene</translation>
    </message>
    <message>
        <source>the id of a shape</source>
        <translation>die id einer Form</translation>
    </message>
    <message>
        <source>the inputs of a key</source>
        <translation>die Grundlage eines Keyframes</translation>
    </message>
    <message>
        <source>the inversion</source>
        <translation>die Invertierung</translation>
    </message>
    <message>
        <source>the keys are not in order</source>
        <translation>die Keyframes sind nicht in Reihenfolge</translation>
    </message>
    <message>
        <source>the keys of shape {name!r} differ in their number of points</source>
        <translation>die Keyframes der Form {name!r} haben verschieden viele Punkte</translation>
    </message>
    <message>
        <source>the link of a shape</source>
        <translation>die Verknüpfung einer Form</translation>
    </message>
    <message>
        <source>the mode {mode!r}</source>
        <translation>den Modus {mode!r}</translation>
    </message>
    <message>
        <source>the motion blur must have 1 to 1024 samples and a shutter of at most 1000 frames</source>
        <translation>die Bewegungsunschärfe muss 1 bis 1024 Abtastungen und einen Verschluss von höchstens 1000 Frames haben</translation>
    </message>
    <message>
        <source>the name of a layer</source>
        <translation>der Name einer Ebene</translation>
    </message>
    <message>
        <source>the name of a shape</source>
        <translation>der Name einer Form</translation>
    </message>
    <message>
        <source>the number of samples of motion blur</source>
        <translation>die Zahl der Abtastungen der Bewegungsunschärfe</translation>
    </message>
    <message>
        <source>the opacity</source>
        <translation>die Deckkraft</translation>
    </message>
    <message>
        <source>the opacity of a layer</source>
        <translation>die Deckkraft einer Ebene</translation>
    </message>
    <message>
        <source>the opacity of a shape</source>
        <translation>die Deckkraft einer Form</translation>
    </message>
    <message>
        <source>the packed keys and their {name} differ in length</source>
        <translation>die gepackten Keyframes und {name} sind verschieden lang</translation>
    </message>
    <message>
        <source>the phase of motion blur</source>
        <translation>die Phase der Bewegungsunschärfe</translation>
    </message>
    <message>
        <source>the plane</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>the plate&apos;s light with the sRGB curve</source>
        <translation>das Licht der Plate mit der sRGB-Kurve</translation>
    </message>
    <message>
        <source>the points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>the points that were set are not in order</source>
        <translation>die gesetzten Punkte sind nicht in Reihenfolge</translation>
    </message>
    <message>
        <source>the runs of a mask do not fill its picture</source>
        <translation>die Läufe einer Maske füllen ihr Bild nicht</translation>
    </message>
    <message>
        <source>the shutter of motion blur</source>
        <translation>der Verschluss der Bewegungsunschärfe</translation>
    </message>
    <message>
        <source>the text of a mark</source>
        <translation>der Text einer Markierung</translation>
    </message>
    <message>
        <source>the text of a mask is damaged</source>
        <translation>der Text einer Maske ist beschädigt</translation>
    </message>
    <message>
        <source>the whole</source>
        <translation>dem Ganzen</translation>
    </message>
    <message>
        <source>the width of its stroke</source>
        <translation>die Breite des Strichs</translation>
    </message>
    <message>
        <source>the {part} of its transform was left out</source>
        <translation>{part} der Transformation entfällt</translation>
    </message>
    <message>
        <source>through time</source>
        <translation>durch die Zeit</translation>
    </message>
    <message>
        <source>thrown away</source>
        <translation>verworfen</translation>
    </message>
    <message>
        <source>timeline dopesheet closer magnify</source>
        <translation>zoom zeitleiste näher hineinzoomen</translation>
    </message>
    <message>
        <source>timeline dopesheet farther</source>
        <translation>zoom zeitleiste ferner herauszoomen</translation>
    </message>
    <message>
        <source>times are missing or not in order</source>
        <translation>Zeiten fehlen oder sind nicht in Reihenfolge</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>topology split suggestion</source>
        <translation>topologie teilen vorschlag</translation>
    </message>
    <message>
        <source>topology suggestion reset</source>
        <translation>topologie vorschlag zurücksetzen</translation>
    </message>
    <message>
        <source>trace vectorise matte image</source>
        <translation>nachzeichnen vektorisieren matte bild</translation>
    </message>
    <message>
        <source>tracked</source>
        <translation>getrackt</translation>
    </message>
    <message>
        <source>tracked backward</source>
        <translation>rückwärts getrackt</translation>
    </message>
    <message>
        <source>tracked before confidence was kept</source>
        <translation>getrackt, bevor Konfidenz aufgehoben wurde</translation>
    </message>
    <message>
        <source>tracked forward</source>
        <translation>vorwärts getrackt</translation>
    </message>
    <message>
        <source>trust doubt heat quality</source>
        <translation>vertrauen zweifel qualität</translation>
    </message>
    <message>
        <source>two viewers beside split compare matte monitor dual</source>
        <translation>zwei viewer nebeneinander geteilt vergleichen matte monitor</translation>
    </message>
    <message>
        <source>uberkey multi-frame multiframe all keys offset</source>
        <translation>uberkey alle keyframes versatz mehrere frames</translation>
    </message>
    <message>
        <source>undo list steps</source>
        <translation>rückgängig liste schritte</translation>
    </message>
    <message>
        <source>undock detach tear off monitor</source>
        <translation>abdocken lösen monitor</translation>
    </message>
    <message>
        <source>undock detach tear off monitor dopesheet</source>
        <translation>abdocken lösen monitor zeitleiste</translation>
    </message>
    <message>
        <source>undock detach tear off monitor errors console</source>
        <translation>lösen abdocken schweben Monitor Fehler Konsole</translation>
    </message>
    <message>
        <source>undock detach tear off monitor graph editor</source>
        <translation>abdocken lösen monitor kurveneditor</translation>
    </message>
    <message>
        <source>undock detach tear off monitor list outliner</source>
        <translation>lösen abdocken schweben Monitor Liste Gliederung</translation>
    </message>
    <message>
        <source>undock detach tear off monitor notes doubtful boil</source>
        <translation>lösen abdocken schweben Monitor Notizen zweifelhaft Flimmern</translation>
    </message>
    <message>
        <source>undock detach tear off monitor propagate engine</source>
        <translation>lösen abdocken schweben Monitor nachverfolgen Engine</translation>
    </message>
    <message>
        <source>undock detach tear off monitor properties attributes</source>
        <translation>lösen abdocken schweben Monitor Eigenschaften Attribute</translation>
    </message>
    <message>
        <source>undock detach tear off monitor surface plane</source>
        <translation>lösen abdocken schweben Monitor Oberfläche Ebene</translation>
    </message>
    <message>
        <source>undock detach tear off monitor undo steps</source>
        <translation>lösen abdocken schweben Monitor rückgängig Schritte</translation>
    </message>
    <message>
        <source>unhide reveal visibility eye</source>
        <translation>einblenden sichtbarkeit auge</translation>
    </message>
    <message>
        <source>unlink limbs articulated overlap rig</source>
        <translation>trennen glieder gelenke überlappen rig</translation>
    </message>
    <message>
        <source>untitled</source>
        <translation>unbenannt</translation>
    </message>
    <message>
        <source>version copy</source>
        <translation>version kopie</translation>
    </message>
    <message>
        <source>version licence credits libraries</source>
        <translation>version lizenz mitwirkende bibliotheken</translation>
    </message>
    <message>
        <source>vertex cycle</source>
        <translation>punkt durchgehen</translation>
    </message>
    <message>
        <source>vertices</source>
        <translation>punkte</translation>
    </message>
    <message>
        <source>visibility invisible eye</source>
        <translation>sichtbarkeit unsichtbar auge</translation>
    </message>
    <message>
        <source>warp push pull liquify sculpt brush magnet</source>
        <translation>verbiegen schieben ziehen verflüssigen modellieren pinsel magnet</translation>
    </message>
    <message>
        <source>what decodes it ended unexpectedly ({how})</source>
        <translation>der dekodierende Prozess endete unerwartet ({how})</translation>
    </message>
    <message>
        <source>what should be rows of {width} numbers is something else</source>
        <translation>was Reihen aus {width} Zahlen sein sollte, ist etwas anderes</translation>
    </message>
    <message>
        <source>what stands among the keys is no key</source>
        <translation>unter den Keyframes steht etwas, das keiner ist</translation>
    </message>
    <message>
        <source>what stands among the layers is no layer and no shape</source>
        <translation>unter den Ebenen steht etwas, das weder Ebene noch Form ist</translation>
    </message>
    <message>
        <source>width and height must be positive</source>
        <translation>Breite und Höhe müssen positiv sein</translation>
    </message>
    <message>
        <source>wipe compare split screen ab buffer before after snapshot</source>
        <translation>wischen vergleichen teilen ab puffer vorher nachher schnappschuss</translation>
    </message>
    <message>
        <source>with {names}, which this program does not know: they count as stale</source>
        <translation>mit {names}: Das kennt dieses Programm nicht, sie gelten als veraltet</translation>
    </message>
    <message>
        <source>with {names}, which turns a dial that is offered no more: they stay as they are</source>
        <translation>mit {names}: Den Regler gibt es nicht mehr, sie bleiben, wie sie sind</translation>
    </message>
    <message>
        <source>write store keep</source>
        <translation>schreiben sichern behalten</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>xspline x-spline spline smooth draw roto mask path</source>
        <translation>xspline x-spline spline glatt zeichnen roto maske pfad</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>zoom focus</source>
        <translation>zoom fokus</translation>
    </message>
    <message>
        <source>zoom pixels one to one</source>
        <translation>zoom pixel eins zu eins</translation>
    </message>
    <message>
        <source>zoom timeline dopesheet whole all</source>
        <translation>zoom zeitleiste ganz alles</translation>
    </message>
    <message>
        <source>zoom whole frame all</source>
        <translation>zoom ganzer frame alles</translation>
    </message>
    <message>
        <source>{action} cannot be done at the moment.</source>
        <translation>{action} ist im Moment nicht möglich.</translation>
    </message>
    <message>
        <source>{act} point</source>
        <translation>{act}: Punkt</translation>
    </message>
    <message>
        <source>{act} shape</source>
        <translation>{act}: Form</translation>
    </message>
    <message>
        <source>{act} {count} points</source>
        <translation>{act}: {count} Punkte</translation>
    </message>
    <message>
        <source>{act} {count} shapes</source>
        <translation>{act}: {count} Formen</translation>
    </message>
    <message>
        <source>{before} and {after}</source>
        <translation>{before} und {after}</translation>
    </message>
    <message>
        <source>{before}, {after}</source>
        <translation>{before}, {after}</translation>
    </message>
    <message>
        <source>{bits} bits</source>
        <translation>{bits} Bit</translation>
    </message>
    <message>
        <source>{blur} Edge {width:.1f} px at the median. {shapes} changed, {soft} with feather.</source>
        <translation>{blur} Kante {width:.1f} px im Median. {shapes} geändert, {soft} mit weicher Kante.</translation>
    </message>
    <message>
        <source>{confidence:.2f}{doubt}</source>
        <translation>{confidence:.2f}{doubt}</translation>
    </message>
    <message>
        <source>{count} B-spline(s) lie in a layer that moves in perspective, which carries the curve in place of its control points: {word} strays by up to {most:.1f} px.</source>
        <translation>B-Splines in einer perspektivisch bewegten Ebene, die die Kurve statt ihrer Kontrollpunkte mitnimmt: {count}; {word} weicht bis zu {most:.1f} px ab.</translation>
    </message>
    <message>
        <source>{count} B-splines, {name!r} among them, are written as Bezier: the same curves, with other handles.</source>
        <translation>{count} B-Splines, darunter {name!r}, werden als Bézier geschrieben: dieselben Kurven mit anderen Tangenten.</translation>
    </message>
    <message>
        <source>{count} frames, from {first} to {last}</source>
        <translation>{count} Frames, von {first} bis {last}</translation>
    </message>
    <message>
        <source>{count} key</source>
        <translation>{count} Keyframe</translation>
    </message>
    <message>
        <source>{count} keys</source>
        <translation>{count} Keyframes</translation>
    </message>
    <message>
        <source>{count} keys stand for {times} times</source>
        <translation>{count} Keyframes stehen für {times} Zeiten</translation>
    </message>
    <message>
        <source>{count} layers</source>
        <translation>{count} Ebenen</translation>
    </message>
    <message>
        <source>{count} masks are missing between the first and the last; no keys stand there.</source>
        <translation>Zwischen der ersten und der letzten Maske fehlen {count}; dort stehen keine Keyframes.</translation>
    </message>
    <message>
        <source>{count} more</source>
        <translation>{count} weitere</translation>
    </message>
    <message>
        <source>{count} more shapes: {keys} keys for {frames} frames; at least {share:.0f} % of the outline within {tolerance:g} px, {greatest:.1f} px at the farthest, IoU at least {overlap:.3f}; not held on {missed} frames.</source>
        <translation>{count} weitere Formen: {keys} Keyframes für {frames} Frames; mindestens {share:.0f} % des Umrisses innerhalb von {tolerance:g} px, höchstens {greatest:.1f} px entfernt, IoU mindestens {overlap:.3f}; auf {missed} Frames nicht gehalten.</translation>
    </message>
    <message>
        <source>{count} of {all} gap(s) could not be filled: {reason}</source>
        <translation>{count} von {all} Lücken ließen sich nicht füllen: {reason}</translation>
    </message>
    <message>
        <source>{count} points over all keys</source>
        <translation>{count} Punkte über alle Keyframes</translation>
    </message>
    <message>
        <source>{count} shape</source>
        <translation>{count} Form</translation>
    </message>
    <message>
        <source>{count} shapes</source>
        <translation>{count} Formen</translation>
    </message>
    <message>
        <source>{count} shapes and layers</source>
        <translation>{count} Formen und Ebenen</translation>
    </message>
    <message>
        <source>{count} shapes are fitted: drag the points to adjust.</source>
        <translation>{count} Formen sind angepasst: zum Korrigieren die Punkte ziehen.</translation>
    </message>
    <message>
        <source>{count} shapes are selected.</source>
        <translation>{count} Formen sind ausgewählt.</translation>
    </message>
    <message>
        <source>{count} shapes changed. {sentence}</source>
        <translation>{count} Formen geändert. {sentence}</translation>
    </message>
    <message>
        <source>{count} shapes lie {where} from frame {frame} on.</source>
        <translation>{count} Formen liegen {where} ab Frame {frame}.</translation>
    </message>
    <message>
        <source>{damage} The shapes pass over frame {number}.</source>
        <translation>{damage} Die Formen gehen über Frame {number} hinweg.</translation>
    </message>
    <message>
        <source>{done} frames, {each:.0f} ms each</source>
        <translation>{done} Frames, je {each:.0f} ms</translation>
    </message>
    <message numerus="yes">
        <source>{edit}: %n key(s) changed.</source>
        <translation>
            <numerusform>{edit}: %n Keyframe geändert.</numerusform>
            <numerusform>{edit}: %n Keyframes geändert.</numerusform>
        </translation>
    </message>
    <message>
        <source>{error} Its newest backup is {backup}.</source>
        <translation>{error} Die neueste Sicherung ist {backup}.</translation>
    </message>
    <message>
        <source>{field} of {name} comes from {source}, which is not read.</source>
        <translation>{field} von {name} kommt aus {source} und wird nicht gelesen.</translation>
    </message>
    <message>
        <source>{files} is no plain file and cannot be written over; name another.</source>
        <translation>{files}: Das ist keine gewöhnliche Datei und kann nicht überschrieben werden; eine andere angeben.</translation>
    </message>
    <message>
        <source>{files} is read for this and is never written over; name another place.</source>
        <translation>{files}: Das wird hierfür gelesen und niemals überschrieben; einen anderen Ort angeben.</translation>
    </message>
    <message>
        <source>{files} is there already and is no file of this kind that ROAM made; name another place, or say --overwrite.</source>
        <translation>{files}: Das gibt es schon und stammt nicht als Datei dieser Art von ROAM; einen anderen Ort angeben, oder --overwrite.</translation>
    </message>
    <message>
        <source>{files} would be written twice; give each result a place of its own.</source>
        <translation>{files}: Das würde zweimal geschrieben; jedem Ergebnis einen eigenen Ort geben.</translation>
    </message>
    <message>
        <source>{files} would lie among the frames of the plate; choose another folder.</source>
        <translation>{files}: Das läge unter den Frames der Plate; einen anderen Ordner wählen.</translation>
    </message>
    <message>
        <source>{file} asks for too much memory; it is damaged or too large.</source>
        <translation>{file} verlangt zu viel Speicher; die Datei ist beschädigt oder zu groß.</translation>
    </message>
    <message>
        <source>{file} cannot be decoded: {reason}. It is damaged; render it again, or take it out of the plate.</source>
        <translation>{file} lässt sich nicht dekodieren: {reason}. Die Datei ist beschädigt; bitte neu rendern oder aus der Plate nehmen.</translation>
    </message>
    <message>
        <source>{file} cannot be read; it is damaged or cut short ({reason}). Render it again.</source>
        <translation>{file} kann nicht gelesen werden; die Datei ist beschädigt oder abgeschnitten ({reason}). Bitte neu rendern.</translation>
    </message>
    <message>
        <source>{file} claims to be {width} x {height} pixels, more than the {most} million that ROAM works with; it is damaged or too large, scale it down.</source>
        <translation>{file} hat angeblich {width} x {height} Pixel, mehr als die {most} Millionen, mit denen ROAM arbeitet; die Datei ist beschädigt oder zu groß und muss verkleinert werden.</translation>
    </message>
    <message>
        <source>{file} has no layer {name!r}; it has {layers}.</source>
        <translation>{file} hat keine Ebene {name!r}; vorhanden: {layers}.</translation>
    </message>
    <message>
        <source>{file} has tiles of 64-bit values; save it with 32 bits.</source>
        <translation>{file} hat Kacheln aus 64-Bit-Werten; mit 32 Bit speichern.</translation>
    </message>
    <message>
        <source>{file} holds deep pixels and no picture; flatten it to one.</source>
        <translation>{file} enthält Deep-Pixel und kein Bild; bitte zu einem Bild reduzieren.</translation>
    </message>
    <message>
        <source>{file} holds more than {most} MiB of pixels; give a mask of one channel.</source>
        <translation>{file} enthält mehr als {most} MiB an Pixeln; eine Maske mit einem Kanal angeben.</translation>
    </message>
    <message>
        <source>{file} is a project, not a plate; name the plate: a folder of images, a pattern, an image or a movie.</source>
        <translation>{file} ist ein Projekt, keine Plate; die Plate angeben: einen Ordner mit Bildern, ein Muster, ein Bild oder einen Film.</translation>
    </message>
    <message>
        <source>{file} is no ROAM project, no picture and no movie. Open a folder of pictures, a movie, or a project, whose name ends with .roam; shapes of other programs are imported into a project.</source>
        <translation>{file} ist kein ROAM-Projekt, kein Bild und kein Film. Einen Ordner mit Bildern, einen Film oder ein Projekt öffnen, dessen Name auf .roam endet; Formen anderer Programme werden in ein Projekt importiert.</translation>
    </message>
    <message>
        <source>{file} is no image that can be read ({reason}); replace it or take it out of the plate.</source>
        <translation>{file} ist kein lesbares Bild ({reason}); bitte ersetzen oder aus der Plate nehmen.</translation>
    </message>
    <message>
        <source>{file} is {width} x {height} pixels, the plate is {plate_width} x {plate_height}; all frames of a plate need one size.</source>
        <translation>{file} hat {width} x {height} Pixel, die Plate {plate_width} x {plate_height}; alle Frames einer Plate brauchen dieselbe Größe.</translation>
    </message>
    <message>
        <source>{first!r} and {second!r} have one id</source>
        <translation>{first!r} und {second!r} haben dieselbe id</translation>
    </message>
    <message>
        <source>{first}, a single picture</source>
        <translation>{first}, ein einzelnes Bild</translation>
    </message>
    <message>
        <source>{first}–{last}, {count} frames</source>
        <translation>{first}–{last}, {count} Frames</translation>
    </message>
    <message>
        <source>{folder} holds no image and no movie; choose the folder that holds the plate&apos;s frames.</source>
        <translation>{folder} enthält kein Bild und keinen Film; den Ordner wählen, in dem die Frames der Plate liegen.</translation>
    </message>
    <message>
        <source>{folder} holds several movies ({names}); name one of them.</source>
        <translation>{folder} enthält mehrere Filme ({names}); einen davon angeben.</translation>
    </message>
    <message>
        <source>{folder} holds several sequences, none longer than the others, and none begins as the project&apos;s plate: {names}. Leave the plate alone in its folder, or relink the clip.</source>
        <translation>{folder} enthält mehrere Bildsequenzen, keine länger als die anderen, und keine beginnt wie die Plate des Projekts: {names}. Nur die Plate in ihrem Ordner lassen oder den Clip neu verknüpfen.</translation>
    </message>
    <message>
        <source>{folder} holds several sequences, none longer than the others: {names}. Give a pattern, such as {advised}.</source>
        <translation>{folder} enthält mehrere Bildsequenzen, keine länger als die anderen: {names}. Ein Muster angeben, etwa {advised}.</translation>
    </message>
    <message>
        <source>{folder} holds {count} images whose names do not count frames: {names}. Number them, with nine digits at most, such as shot.0001.png, or give one of them.</source>
        <translation>{folder} enthält {count} Bilder, deren Namen keine Frames zählen: {names}. Die Bilder mit höchstens neun Ziffern nummerieren, etwa shot.0001.png, oder eines davon angeben.</translation>
    </message>
    <message>
        <source>{frames} on {pages}</source>
        <translation>{frames} auf {pages}</translation>
    </message>
    <message>
        <source>{frames}, {width} × {height}</source>
        <translation>{frames}, {width} × {height}</translation>
    </message>
    <message>
        <source>{grey} of the {count} masks are grey for the most part, neither black nor white; if they are pictures, give the masks of them, white inside.</source>
        <translation>Größtenteils grau, weder schwarz noch weiß: {grey} der {count} Masken; sind es Bilder, die Masken davon angeben, innen weiß.</translation>
    </message>
    <message>
        <source>{journal} cannot be marked: {reason}.</source>
        <translation>{journal} lässt sich nicht kennzeichnen: {reason}.</translation>
    </message>
    <message>
        <source>{journal} cannot be read: {reason}.</source>
        <translation>{journal} lässt sich nicht lesen: {reason}.</translation>
    </message>
    <message>
        <source>{keys} is the key of “{action}”.</source>
        <translation>{keys} ist die Taste von „{action}“.</translation>
    </message>
    <message>
        <source>{keys} keys for {frames} frames</source>
        <translation>{keys} Keyframes für {frames} Frames</translation>
    </message>
    <message>
        <source>{keys} moved; boil by the picture {before:.2f} px before, {after:.2f} px now.</source>
        <translation>{keys} bewegt; Flimmern am Bild gemessen vorher {before:.2f} px, jetzt {after:.2f} px.</translation>
    </message>
    <message>
        <source>{keys} moved; their boil could not be measured.</source>
        <translation>{keys} bewegt; ihr Flimmern ließ sich nicht messen.</translation>
    </message>
    <message>
        <source>{keys} moves the selected points; choose another key.</source>
        <translation>{keys} bewegt die ausgewählten Punkte; bitte eine andere Taste wählen.</translation>
    </message>
    <message>
        <source>{keys} stops</source>
        <translation>{keys} hält an</translation>
    </message>
    <message>
        <source>{key} of {name} has an expression, which is not evaluated.</source>
        <translation>{key} von {name} hat eine Expression, die nicht ausgewertet wird.</translation>
    </message>
    <message>
        <source>{key} of {name} is not read: it stays where its points are.</source>
        <translation>{key} von {name} wird nicht gelesen: Die Form bleibt, wo ihre Punkte sind.</translation>
    </message>
    <message>
        <source>{left} speck(s) and pinhole(s) on {count} mask(s) were left out, each below {speck:.0f} square pixels; the smallest area that is followed can be chosen (--speckle).</source>
        <translation>{left} Fleck(en) und Löcher auf {count} Maske(n) entfallen, jedes unter {speck:.0f} Quadratpixeln; die kleinste Fläche, der gefolgt wird, ist wählbar (--speckle).</translation>
    </message>
    <message>
        <source>{made} {unwritten}</source>
        <translation>{made} {unwritten}</translation>
    </message>
    <message>
        <source>{meaning} was left out</source>
        <translation>{meaning} entfällt</translation>
    </message>
    <message>
        <source>{name!r} does not exist on frame {frame}: it is left out.</source>
        <translation>{name!r} existiert auf Frame {frame} nicht und entfällt.</translation>
    </message>
    <message>
        <source>{name!r} does not exist on frame {frame}: its lifetime is in the Shape panel.</source>
        <translation>{name!r} gibt es auf Frame {frame} nicht: Die Lebensdauer steht im Formbereich.</translation>
    </message>
    <message>
        <source>{name!r} does not exist on frames {frames}{more}: it is left out.</source>
        <translation>{name!r} existiert auf den Frames {frames}{more} nicht und entfällt.</translation>
    </message>
    <message>
        <source>{name!r} does not exist on the frames that are written: it is left out.</source>
        <translation>{name!r} existiert auf den geschriebenen Frames nicht und entfällt.</translation>
    </message>
    <message>
        <source>{name!r} has a feather curve and a uniform feather; Natron adds one to the other.</source>
        <translation>{name!r} hat eine Kurve der weichen Kante und eine gleichmäßige; Natron addiert beide.</translation>
    </message>
    <message>
        <source>{name!r} has one key and no motion; it is left out.</source>
        <translation>{name!r} hat einen Keyframe und keine Bewegung und entfällt.</translation>
    </message>
    <message>
        <source>{name!r} has too few points for CVAT: it is left out.</source>
        <translation>{name!r} hat zu wenige Punkte für CVAT und entfällt.</translation>
    </message>
    <message>
        <source>{name!r} has {count} points and the copied key {copied}: a key fits shapes with as many points.</source>
        <translation>{name!r} hat {count} Punkte und der kopierte Keyframe {copied}: er passt zu Formen mit ebenso vielen Punkten.</translation>
    </message>
    <message>
        <source>{name!r} is a B-spline, which is smooth everywhere; make it Bezier for corners.</source>
        <translation>{name!r} ist ein B-Spline und überall glatt; Ecken hat er erst als Bézier.</translation>
    </message>
    <message>
        <source>{name!r} is a single point; draw an outline around the object first.</source>
        <translation>{name!r} ist ein einzelner Punkt; zuerst einen Umriss um das Objekt zeichnen.</translation>
    </message>
    <message>
        <source>{name!r} is a single point; draw an outline around the object to fill it.</source>
        <translation>{name!r} ist ein einzelner Punkt; zum Füllen einen Umriss um das Objekt zeichnen.</translation>
    </message>
    <message>
        <source>{name!r} is a single point; draw an outline around the object to track it.</source>
        <translation>{name!r} ist ein einzelner Punkt; zum Tracken einen Umriss um das Objekt zeichnen.</translation>
    </message>
    <message>
        <source>{name!r} is locked or hidden; unlock and show it to edit it.</source>
        <translation>{name!r} ist gesperrt oder ausgeblendet; zum Bearbeiten bitte entsperren und einblenden.</translation>
    </message>
    <message>
        <source>{name!r} is missing or unknown</source>
        <translation>{name!r} fehlt oder ist unbekannt</translation>
    </message>
    <message>
        <source>{name!r} is no file name for the matte of frame {frame}.</source>
        <translation>{name!r} ist kein Dateiname für die Matte von Frame {frame}.</translation>
    </message>
    <message>
        <source>{name!r} is not shown while others are soloed; &lt;shape.solo&gt; shows all.</source>
        <translation>{name!r} ist nicht zu sehen, solange andere auf Solo stehen; &lt;shape.solo&gt; zeigt alle.</translation>
    </message>
    <message>
        <source>{name!r} is open and begins at one of its ends; reverse its direction to begin at the other.</source>
        <translation>{name!r} ist offen und beginnt an einem ihrer Enden; damit sie am anderen beginnt, die Richtung umkehren.</translation>
    </message>
    <message>
        <source>{name!r} is open or invisible, no object: it is left out.</source>
        <translation>{name!r} ist offen oder unsichtbar, kein Objekt, und entfällt.</translation>
    </message>
    <message>
        <source>{name!r} is open; close it (C) before it can be filled.</source>
        <translation>{name!r} ist offen; vor dem Füllen schließen (C).</translation>
    </message>
    <message>
        <source>{name!r} is open; close it (C) before it can be tracked.</source>
        <translation>{name!r} ist offen; vor dem Tracken schließen (C).</translation>
    </message>
    <message>
        <source>{name!r} lies in {layer!r}, which is locked or hidden; unlock and show that layer to edit it.</source>
        <translation>{name!r} liegt in {layer!r}, einer gesperrten oder ausgeblendeten Ebene; diese entsperren und einblenden, um die Form zu bearbeiten.</translation>
    </message>
    <message>
        <source>{name!r} lies in {layer!r}, which is locked: unlock that layer in the list.</source>
        <translation>{name!r} liegt in {layer!r}, einer gesperrten Ebene: diese in der Liste entsperren.</translation>
    </message>
    <message>
        <source>{name!r} needs at least one key; delete the shape instead.</source>
        <translation>{name!r} braucht mindestens einen Keyframe; stattdessen die Form löschen.</translation>
    </message>
    <message>
        <source>{name!r} needs at least {least} points to be closed; add one.</source>
        <translation>{name!r} braucht mindestens {least} Punkte, um geschlossen zu sein; einen hinzufügen.</translation>
    </message>
    <message>
        <source>{name!r} needs at least {least} points; delete the shape instead.</source>
        <translation>{name!r} braucht mindestens {least} Punkte; stattdessen die Form löschen.</translation>
    </message>
    <message>
        <source>{name!r} takes away where nothing lies under it: it is written as hidden.</source>
        <translation>{name!r} nimmt weg, wo nichts darunter liegt, und wird ausgeblendet geschrieben.</translation>
    </message>
    <message>
        <source>{name!r}: smoothed through time; the engine&apos;s outlines moved by at most {max_error:.2f} px, {mean_error:.2f} px on average.</source>
        <translation>{name!r}: durch die Zeit geglättet; Umrisse der Engine bewegten sich um höchstens {max_error:.2f} px, im Mittel {mean_error:.2f} px.</translation>
    </message>
    <message>
        <source>{name!r}: {keys} keys for {frames} frames; the outline moves by at most {max_error:.2f} px, {mean_error:.2f} px on average ({checked}).</source>
        <translation>{name!r}: {keys} Keys für {frames} Bilder; der Umriss bewegt sich um höchstens {max_error:.2f} px, im Mittel {mean_error:.2f} px ({checked}).</translation>
    </message>
    <message>
        <source>{name!r}: {points} points, {kept}; at least {share:.0f} % of the outline within {tolerance:g} px on every frame ({mean:.2f} px on average, {greatest:.1f} px at the farthest), IoU at least {overlap:.3f}{missed}.</source>
        <translation>{name!r}: {points} Punkte, {kept}; mindestens {share:.0f} % des Umrisses innerhalb von {tolerance:g} px auf jedem Frame (im Mittel {mean:.2f} px, höchstens {greatest:.1f} px), IoU mindestens {overlap:.3f}{missed}.</translation>
    </message>
    <message>
        <source>{named}, and {count} more alike</source>
        <translation>{named} und {count} weitere ebenso</translation>
    </message>
    <message>
        <source>{names} and others</source>
        <translation>{names} und weiteren</translation>
    </message>
    <message>
        <source>{names} and {count} more</source>
        <translation>{names} und {count} weitere</translation>
    </message>
    <message>
        <source>{names} or {last}</source>
        <translation>{names} oder {last}</translation>
    </message>
    <message>
        <source>{name} (one frame, {first} to {last})</source>
        <translation>{name} (ein Frame, {first} bis {last})</translation>
    </message>
    <message>
        <source>{name} (one image)</source>
        <translation>{name} (ein Bild)</translation>
    </message>
    <message>
        <source>{name} ({count} frames, {first} to {last})</source>
        <translation>{name} ({count} Frames, {first} bis {last})</translation>
    </message>
    <message>
        <source>{name} belongs to the same object now.</source>
        <translation>{name} gehört jetzt zum selben Objekt.</translation>
    </message>
    <message>
        <source>{name} boils</source>
        <translation>{name} flimmert</translation>
    </message>
    <message>
        <source>{name} comes and goes, or changes its number of points: it became several shapes.</source>
        <translation>{name} kommt und geht oder wechselt die Punktzahl: Daraus wurden mehrere Formen.</translation>
    </message>
    <message>
        <source>{name} files hold all pixels; ask for EXR to leave out the black around the shapes.</source>
        <translation>{name}-Dateien enthalten alle Pixel; um das Schwarz um die Formen wegzulassen, EXR wählen.</translation>
    </message>
    <message>
        <source>{name} files hold no Cryptomatte; ask for EXR.</source>
        <translation>{name}-Dateien nehmen kein Cryptomatte auf; EXR wählen.</translation>
    </message>
    <message>
        <source>{name} files hold no channels with names; ask for EXR.</source>
        <translation>{name}-Dateien haben keine benannten Kanäle; EXR wählen.</translation>
    </message>
    <message>
        <source>{name} has boxes without outlines, which were left out.</source>
        <translation>{name} hat Rahmen ohne Umrisse; diese entfallen.</translation>
    </message>
    <message>
        <source>{name} has eased keys; they were read as straight ones.</source>
        <translation>{name} hat weich laufende Keyframes; sie wurden als gerade gelesen.</translation>
    </message>
    <message>
        <source>{name} has keys between frames; they were moved to the nearest ones.</source>
        <translation>{name} hat Keyframes zwischen den Frames; sie wurden auf die nächsten verschoben.</translation>
    </message>
    <message>
        <source>{name} has {count} frames that can be read, its header says {claimed}: it may be cut short.</source>
        <translation>{name} hat {count} lesbare Bilder, laut Kopf der Datei {claimed}: sie ist vielleicht abgeschnitten.</translation>
    </message>
    <message>
        <source>{name} holds several pictures, of which the first is the mask: to have all, save them as numbered files.</source>
        <translation>{name} enthält mehrere Bilder, von denen das erste die Maske ist: um alle zu haben, speichern Sie sie als nummerierte Dateien.</translation>
    </message>
    <message>
        <source>{name} holds several pictures, of which the first is the plate: to have all, save them as numbered files.</source>
        <translation>{name} enthält mehrere Bilder, von denen das erste die Plate ist: bitte als nummerierte Dateien speichern, um alle zu haben.</translation>
    </message>
    <message>
        <source>{name} in {layer}</source>
        <translation>{name} in {layer}</translation>
    </message>
    <message>
        <source>{name} is a line, whose width is not read: it came in hidden.</source>
        <translation>{name} ist eine Linie, deren Breite nicht gelesen wird: Sie kam ausgeblendet.</translation>
    </message>
    <message>
        <source>{name} is a picture in colour, no mask; paint the object white and the rest black.</source>
        <translation>{name} ist ein Farbbild, keine Maske; das Objekt weiß malen und den Rest schwarz.</translation>
    </message>
    <message>
        <source>{name} is a single point; draw an outline around the object to track it.</source>
        <translation>{name} ist ein einzelner Punkt; zum Tracken einen Umriss um das Objekt zeichnen.</translation>
    </message>
    <message>
        <source>{name} is closed now.</source>
        <translation>{name} ist jetzt geschlossen.</translation>
    </message>
    <message>
        <source>{name} is drawn: drag its points to adjust it, it is open, &lt;points.toggle_closed&gt; closes it.</source>
        <translation>{name} ist gezeichnet: zum Anpassen die Punkte ziehen; die Form ist offen, &lt;points.toggle_closed&gt; schließt sie.</translation>
    </message>
    <message>
        <source>{name} is drawn: drag its points to adjust it.</source>
        <translation>{name} ist gezeichnet: zum Anpassen die Punkte ziehen.</translation>
    </message>
    <message>
        <source>{name} is fitted: drag the points to adjust.</source>
        <translation>{name} ist angepasst: zum Korrigieren die Punkte ziehen.</translation>
    </message>
    <message>
        <source>{name} is locked; unlock it to remove its adjust keys.</source>
        <translation>{name} ist gesperrt; zum Entfernen der Korrektur-Keyframes entsperren.</translation>
    </message>
    <message>
        <source>{name} is locked; unlock it to track it.</source>
        <translation>{name} ist gesperrt; zum Tracken bitte entsperren.</translation>
    </message>
    <message>
        <source>{name} is neither a folder nor a movie that ends in {known} or {last}.</source>
        <translation>{name} ist weder ein Ordner noch ein Film, der auf {known} oder {last} endet.</translation>
    </message>
    <message>
        <source>{name} is neither true nor false</source>
        <translation>{name} ist weder true noch false</translation>
    </message>
    <message>
        <source>{name} is no name for a project; end it in {suffix}, as {better}.</source>
        <translation>{name} ist kein Name für ein Projekt; er muss auf {suffix} enden, etwa {better}.</translation>
    </message>
    <message>
        <source>{name} is no number</source>
        <translation>{name} ist keine Zahl</translation>
    </message>
    <message>
        <source>{name} is no number and no animated value</source>
        <translation>{name} ist weder Zahl noch animierter Wert</translation>
    </message>
    <message>
        <source>{name} is no text</source>
        <translation>{name} ist kein Text</translation>
    </message>
    <message>
        <source>{name} is no whole number</source>
        <translation>{name} ist keine ganze Zahl</translation>
    </message>
    <message>
        <source>{name} is not exported.</source>
        <translation>{name} ist nicht exportiert.</translation>
    </message>
    <message>
        <source>{name} is not saved yet.</source>
        <translation>{name} ist noch nicht gespeichert.</translation>
    </message>
    <message>
        <source>{name} is not saved.</source>
        <translation>{name} ist nicht gespeichert.</translation>
    </message>
    <message>
        <source>{name} is not tracked: its first key lies on frame {key}. Track from there, or set a key here (&lt;key.set&gt;).</source>
        <translation>{name} wird nicht getrackt: Der erste Keyframe liegt auf Frame {key}. Von dort tracken oder hier einen setzen (&lt;key.set&gt;).</translation>
    </message>
    <message>
        <source>{name} is not tracked: its last key lies on frame {key}. Track from there, or set a key here (&lt;key.set&gt;).</source>
        <translation>{name} wird nicht getrackt: Der letzte Keyframe liegt auf Frame {key}. Von dort tracken oder hier einen setzen (&lt;key.set&gt;).</translation>
    </message>
    <message>
        <source>{name} is not tracked: the plate has no picture of frame {key}, where its key lies. Set one where it has (&lt;key.set&gt;).</source>
        <translation>{name} wird nicht getrackt: die Plate hat kein Bild von Frame {key}, wo der Keyframe liegt. Einen setzen, wo sie eines hat (&lt;key.set&gt;).</translation>
    </message>
    <message>
        <source>{name} is open now and has no matte; &lt;points.toggle_closed&gt; closes it.</source>
        <translation>{name} ist jetzt offen und hat keine Matte; &lt;points.toggle_closed&gt; schließt die Form.</translation>
    </message>
    <message>
        <source>{name} is open; close it (&lt;points.toggle_closed&gt; in the viewer) to track it.</source>
        <translation>{name} ist offen; zum Tracken bitte schließen (&lt;points.toggle_closed&gt; im Viewer).</translation>
    </message>
    <message>
        <source>{name} is open; close it (&lt;points.toggle_closed&gt; in the viewer) to track its plane.</source>
        <translation>{name} ist offen; zum Tracken der Fläche bitte schließen (&lt;points.toggle_closed&gt; im Viewer).</translation>
    </message>
    <message>
        <source>{name} is the name of {kind} files, but {asked} is asked for.</source>
        <translation>{name} ist ein Name für {kind}-Dateien, verlangt ist aber {asked}.</translation>
    </message>
    <message>
        <source>{name} is the new version already; nothing changed since it was saved.</source>
        <translation>{name} ist schon die neue Version; seit dem Speichern hat sich nichts geändert.</translation>
    </message>
    <message>
        <source>{name} is {value:g}, not between {low:g} and {high:g}</source>
        <translation>{name} ist {value:g}, nicht zwischen {low:g} und {high:g}</translation>
    </message>
    <message>
        <source>{name} is {who}.</source>
        <translation>{name} ist {who}.</translation>
    </message>
    <message>
        <source>{name} lies not between {low} and {high}</source>
        <translation>{name} liegt nicht zwischen {low} und {high}</translation>
    </message>
    <message>
        <source>{name} lies {where} from frame {frame} on.</source>
        <translation>{name} liegt {where} ab Frame {frame}.</translation>
    </message>
    <message>
        <source>{name} mattes are compressed by {choice}, not {compression!r}.</source>
        <translation>{name}-Mattes werden mit {choice} komprimiert, nicht mit {compression!r}.</translation>
    </message>
    <message>
        <source>{name} mattes are {choice} deep, not {depth}.</source>
        <translation>{name}-Mattes haben die Tiefe {choice}, nicht {depth}.</translation>
    </message>
    <message>
        <source>{name} refers to itself: it was left out.</source>
        <translation>{name} verweist auf sich selbst und entfällt.</translation>
    </message>
    <message>
        <source>{name} was changed by another program since it was opened or saved here.</source>
        <translation>{name} wurde von einem anderen Programm geändert, seit es hier geöffnet oder gespeichert wurde.</translation>
    </message>
    <message>
        <source>{name} was changed meanwhile.</source>
        <translation>{name} wurde inzwischen geändert.</translation>
    </message>
    <message>
        <source>{name} was deleted meanwhile.</source>
        <translation>{name} wurde inzwischen gelöscht.</translation>
    </message>
    <message>
        <source>{name} was left out ({reason}).</source>
        <translation>{name} entfällt ({reason}).</translation>
    </message>
    <message>
        <source>{name} was left out: it lies nowhere near the image.</source>
        <translation>{name} liegt weitab vom Bild und entfällt.</translation>
    </message>
    <message>
        <source>{name} was locked meanwhile.</source>
        <translation>{name} wurde inzwischen gesperrt.</translation>
    </message>
    <message>
        <source>{name} was not opened.</source>
        <translation>{name} wurde nicht geöffnet.</translation>
    </message>
    <message>
        <source>{name}, frame {frame}</source>
        <translation>{name}, Frame {frame}</translation>
    </message>
    <message>
        <source>{name}: click to select, Shift adds</source>
        <translation>{name}: Klicken wählt aus, Umschalt fügt hinzu</translation>
    </message>
    <message>
        <source>{name}={text} makes no sense; give a number from {low:g} to {high:g}.</source>
        <translation>{name}={text} ergibt keinen Sinn; eine Zahl von {low:g} bis {high:g} angeben.</translation>
    </message>
    <message>
        <source>{note} So it is with {names}.</source>
        <translation>{note} Ebenso: {names}.</translation>
    </message>
    <message>
        <source>{number} is no frame number</source>
        <translation>{number} ist keine Framenummer</translation>
    </message>
    <message>
        <source>{one} and {other} in {folder} bear the same frame number; remove one, or give a pattern with the number of digits, such as name.%04d.png.</source>
        <translation>{one} und {other} in {folder} tragen dieselbe Framenummer; eine davon entfernen oder ein Muster mit der Zahl der Ziffern angeben, etwa name.%04d.png.</translation>
    </message>
    <message>
        <source>{pace:.0f} ms a frame</source>
        <translation>{pace:.0f} ms pro Frame</translation>
    </message>
    <message>
        <source>{path!r} is no path that can be opened: {reason}.</source>
        <translation>{path!r} ist kein Pfad, der sich öffnen lässt: {reason}.</translation>
    </message>
    <message>
        <source>{path} (and {count} other file)</source>
        <translation>{path} (und {count} weitere Datei)</translation>
    </message>
    <message>
        <source>{path} (and {count} other files)</source>
        <translation>{path} (und {count} weitere Dateien)</translation>
    </message>
    <message>
        <source>{path} cannot be encoded: of {count} frames {found} can be read; is the disk full?</source>
        <translation>{path} kann nicht kodiert werden: Von {count} Frames sind {found} lesbar; ist die Platte voll?</translation>
    </message>
    <message>
        <source>{path} cannot be encoded: {reason}.</source>
        <translation>{path} kann nicht kodiert werden: {reason}.</translation>
    </message>
    <message>
        <source>{path} cannot be read as a mask image; give a PNG, TIFF or JPEG, white inside.</source>
        <translation>{path} kann nicht als Maskenbild gelesen werden; ein PNG, TIFF oder JPEG angeben, innen weiß.</translation>
    </message>
    <message>
        <source>{path} cannot be read: a point lies nowhere near the image.</source>
        <translation>{path} kann nicht gelesen werden: Ein Punkt liegt weitab vom Bild.</translation>
    </message>
    <message>
        <source>{path} cannot be read: an image has no number.</source>
        <translation>{path} kann nicht gelesen werden: Ein Bild hat keine Nummer.</translation>
    </message>
    <message>
        <source>{path} cannot be read: at {word}, {reason}.</source>
        <translation>{path} kann nicht gelesen werden: bei {word}, {reason}.</translation>
    </message>
    <message>
        <source>{path} cannot be read: in {place}, {trouble}.</source>
        <translation>{path} kann nicht gelesen werden: in {place}, {trouble}.</translation>
    </message>
    <message>
        <source>{path} cannot be read: width and height of its images must be positive.</source>
        <translation>{path} kann nicht gelesen werden: Breite und Höhe der Bilder müssen positiv sein.</translation>
    </message>
    <message>
        <source>{path} cannot be read: {reason}.</source>
        <translation>{path} kann nicht gelesen werden: {reason}.</translation>
    </message>
    <message>
        <source>{path} cannot be written: it is a folder.</source>
        <translation>{path} kann nicht geschrieben werden: Das ist ein Ordner.</translation>
    </message>
    <message>
        <source>{path} cannot be written: it is no regular file.</source>
        <translation>{path} kann nicht geschrieben werden: Das ist keine gewöhnliche Datei.</translation>
    </message>
    <message>
        <source>{path} cannot be written: it is read-only; change its permissions, or save elsewhere.</source>
        <translation>{path} kann nicht geschrieben werden: Die Datei ist schreibgeschützt; ändern Sie ihre Berechtigungen, oder speichern Sie woanders.</translation>
    </message>
    <message>
        <source>{path} cannot be written: {reason} ({folder}).</source>
        <translation>{path} kann nicht geschrieben werden: {reason} ({folder}).</translation>
    </message>
    <message>
        <source>{path} cannot be written: {reason}.</source>
        <translation>{path} kann nicht geschrieben werden: {reason}.</translation>
    </message>
    <message>
        <source>{path} declares a document type or an entity, which files of shapes do not need; it was not read.</source>
        <translation>{path} deklariert einen Dokumenttyp oder eine Entität, was Dateien mit Formen nicht brauchen, und wurde nicht gelesen.</translation>
    </message>
    <message>
        <source>{path} does not exist.</source>
        <translation>{path} gibt es nicht.</translation>
    </message>
    <message>
        <source>{path} does not exist; give a file of shapes, a mask or a folder of masks.</source>
        <translation>{path} gibt es nicht; eine Datei mit Formen, eine Maske oder einen Ordner mit Masken angeben.</translation>
    </message>
    <message>
        <source>{path} does not exist; give a folder of images, a pattern, an image or a movie.</source>
        <translation>{path} gibt es nicht; einen Ordner mit Bildern, ein Muster, ein Bild oder einen Film angeben.</translation>
    </message>
    <message>
        <source>{path} does not say what pictures its shapes belong to: {reason}.</source>
        <translation>{path} sagt nicht, zu welchen Bildern die Formen gehören: {reason}.</translation>
    </message>
    <message>
        <source>{path} has no suffix that ROAM reads shapes from; it reads: {known}, and folders of masks.</source>
        <translation>{path} hat keine Endung, aus der ROAM Formen liest; es liest: {known}, und Ordner mit Masken.</translation>
    </message>
    <message>
        <source>{path} has version {version} of the format; this program reads up to {newest}.</source>
        <translation>{path} hat Version {version} des Formats; dieses Programm liest bis {newest}.</translation>
    </message>
    <message>
        <source>{path} holds masks of more than {most} parts and holes; bring them in as pictures of masks.</source>
        <translation>{path} enthält Masken mit mehr als {most} Teilen und Löchern; als Maskenbilder importieren.</translation>
    </message>
    <message>
        <source>{path} holds masks of more than {most} runs; bring them in as pictures of masks.</source>
        <translation>{path} enthält Masken mit mehr als {most} Läufen; als Maskenbilder importieren.</translation>
    </message>
    <message>
        <source>{path} holds more than {most} MiB; copy fewer shapes at once.</source>
        <translation>{path} enthält mehr als {most} MiB; weniger Formen auf einmal kopieren.</translation>
    </message>
    <message>
        <source>{path} holds more than {most} attributes; split it into several files.</source>
        <translation>{path} enthält mehr als {most} Attribute; auf mehrere Dateien aufteilen.</translation>
    </message>
    <message>
        <source>{path} holds more than {most} keys; split it into several files.</source>
        <translation>{path} enthält mehr als {most} Keyframes; auf mehrere Dateien aufteilen.</translation>
    </message>
    <message>
        <source>{path} holds more than {most} lists and objects; split it into several files.</source>
        <translation>{path} enthält mehr als {most} Listen und Objekte; auf mehrere Dateien aufteilen.</translation>
    </message>
    <message>
        <source>{path} holds more than {most} lists; split it into several files.</source>
        <translation>{path} enthält mehr als {most} Listen; auf mehrere Dateien aufteilen.</translation>
    </message>
    <message>
        <source>{path} holds more than {most} parts; split it into several files.</source>
        <translation>{path} enthält mehr als {most} Teile; auf mehrere Dateien aufteilen.</translation>
    </message>
    <message>
        <source>{path} holds more than {most} shapes and layers; split it into several files.</source>
        <translation>{path} enthält mehr als {most} Formen und Ebenen; auf mehrere Dateien aufteilen.</translation>
    </message>
    <message>
        <source>{path} holds more than {much} (at shape {shape}); split it into several files.</source>
        <translation>{path} enthält mehr als {much} (bei Form {shape}); auf mehrere Dateien aufteilen.</translation>
    </message>
    <message>
        <source>{path} holds more values ({values}) than can be opened; it is damaged, or no ROAM project.</source>
        <translation>{path} enthält mehr Werte ({values}), als sich öffnen lassen; die Datei ist beschädigt oder kein ROAM-Projekt.</translation>
    </message>
    <message>
        <source>{path} holds no Roto or RotoPaint node.</source>
        <translation>{path} enthält keinen Roto- oder RotoPaint-Knoten.</translation>
    </message>
    <message>
        <source>{path} holds no picture that can be decoded; convert it to images.</source>
        <translation>{path} enthält kein Bild, das sich dekodieren lässt; bitte in Bilder umwandeln.</translation>
    </message>
    <message>
        <source>{path} holds no shapes: it has neither a &quot;format&quot; of &quot;{format}&quot;, nor &quot;images&quot; and &quot;annotations&quot; as COCO has, nor is it a spline of MLT.</source>
        <translation>{path} enthält keine Formen: Es gibt weder ein &quot;format&quot; mit &quot;{format}&quot; noch &quot;images&quot; und &quot;annotations&quot; wie in COCO, noch ist es ein Spline von MLT.</translation>
    </message>
    <message>
        <source>{path} holds no tools of Fusion&apos;s.</source>
        <translation>{path} enthält keine Werkzeuge von Fusion.</translation>
    </message>
    <message>
        <source>{path} holds pictures in colour, no masks; give the masks of them, white inside and black elsewhere.</source>
        <translation>{path} enthält Farbbilder, keine Masken; die Masken dazu angeben, innen weiß und sonst schwarz.</translation>
    </message>
    <message>
        <source>{path} holds the number {word}; no picture is that large.</source>
        <translation>{path} enthält die Zahl {word}; so groß ist kein Bild.</translation>
    </message>
    <message>
        <source>{path} is a folder, not a file.</source>
        <translation>{path} ist ein Ordner, keine Datei.</translation>
    </message>
    <message>
        <source>{path} is a folder, not a project file.</source>
        <translation>{path} ist ein Ordner, keine Projektdatei.</translation>
    </message>
    <message>
        <source>{path} is a movie: it has no layer {layer!r}.</source>
        <translation>{path} ist ein Film und hat keine Ebene {layer!r}.</translation>
    </message>
    <message>
        <source>{path} is a pipe, a socket or a device, not a file; give a regular file.</source>
        <translation>{path} ist eine Pipe, ein Socket oder ein Gerät, keine Datei; geben Sie eine gewöhnliche Datei an.</translation>
    </message>
    <message>
        <source>{path} is a project; export its shapes (--to json) and import those, or copy them from window to window.</source>
        <translation>{path} ist ein Projekt; seine Formen exportieren (--to json) und diese importieren, oder sie von Fenster zu Fenster kopieren.</translation>
    </message>
    <message>
        <source>{path} is damaged or cut short ({reason}).</source>
        <translation>{path} ist beschädigt oder abgeschnitten ({reason}).</translation>
    </message>
    <message>
        <source>{path} is damaged.</source>
        <translation>{path} ist beschädigt.</translation>
    </message>
    <message>
        <source>{path} is damaged: {reason}.</source>
        <translation>{path} ist beschädigt: {reason}.</translation>
    </message>
    <message>
        <source>{path} is empty: it was cut short while it was written or copied.</source>
        <translation>{path} ist leer: Die Datei wurde beim Schreiben oder Kopieren abgeschnitten.</translation>
    </message>
    <message>
        <source>{path} is interlaced: each of its frames shows two moments, in every other row. Deinterlace it in another program, as images or as a progressive movie, and open that.</source>
        <translation>{path} ist interlaced: Jeder Frame zeigt zwei Momente, in jeder zweiten Zeile. In einem anderen Programm deinterlacen, als Bilder oder als progressiver Film, und das öffnen.</translation>
    </message>
    <message>
        <source>{path} is larger than {most} MiB; that is no ROAM project.</source>
        <translation>{path} ist größer als {most} MiB; das ist kein ROAM-Projekt.</translation>
    </message>
    <message>
        <source>{path} is larger than {size}; {remedy}.</source>
        <translation>{path} ist größer als {size}; {remedy}.</translation>
    </message>
    <message>
        <source>{path} is no SVG picture (its root element is {element}).</source>
        <translation>{path} ist kein SVG-Bild (das Wurzelelement ist {element}).</translation>
    </message>
    <message>
        <source>{path} is no Silhouette shape file (it begins with {element}).</source>
        <translation>{path} ist keine Formendatei von Silhouette (sie beginnt mit {element}).</translation>
    </message>
    <message>
        <source>{path} is no file of CVAT&apos;s (its root element is {element}).</source>
        <translation>{path} ist keine Datei von CVAT (das Wurzelelement ist {element}).</translation>
    </message>
    <message>
        <source>{path} is no keymap; keys are set in Edit &gt; Change keys.</source>
        <translation>{path} ist keine Tastenbelegung; Tasten werden unter Bearbeiten &gt; Tasten ändern festgelegt.</translation>
    </message>
    <message>
        <source>{path} is no movie that can be decoded ({reason}); convert it to images.</source>
        <translation>{path} ist kein Film, der sich dekodieren lässt ({reason}); bitte in Bilder umwandeln.</translation>
    </message>
    <message>
        <source>{path} is no movie that can be decoded, or it is damaged; convert it to images.</source>
        <translation>{path} ist kein Film, der sich dekodieren lässt, oder ist beschädigt; bitte in Bilder umwandeln.</translation>
    </message>
    <message>
        <source>{path} is no regular file, so it is no ROAM project.</source>
        <translation>{path} ist keine gewöhnliche Datei und damit kein ROAM-Projekt.</translation>
    </message>
    <message>
        <source>{path} is no setting of Fusion&apos;s, or it is cut off (at {word}).</source>
        <translation>{path} ist kein Setting von Fusion oder ist abgeschnitten (bei {word}).</translation>
    </message>
    <message>
        <source>{path} is no setting of Fusion&apos;s, or it is cut off.</source>
        <translation>{path} ist kein Setting von Fusion oder ist abgeschnitten.</translation>
    </message>
    <message>
        <source>{path} is no valid JSON (line {line}, column {column}).</source>
        <translation>{path} ist kein gültiges JSON (Zeile {line}, Spalte {column}).</translation>
    </message>
    <message>
        <source>{path} is no valid JSON.</source>
        <translation>{path} ist kein gültiges JSON.</translation>
    </message>
    <message>
        <source>{path} is no valid XML ({reason}).</source>
        <translation>{path} ist kein gültiges XML ({reason}).</translation>
    </message>
    <message>
        <source>{path} is not a ROAM project ({reason}).</source>
        <translation>{path} ist kein ROAM-Projekt ({reason}).</translation>
    </message>
    <message>
        <source>{path} is not a ROAM project.</source>
        <translation>{path} ist kein ROAM-Projekt.</translation>
    </message>
    <message>
        <source>{path} is packed, but damaged; save it again.</source>
        <translation>{path} ist gepackt, aber beschädigt; bitte neu speichern.</translation>
    </message>
    <message>
        <source>{path} is there already; nothing is written over it.</source>
        <translation>{path} gibt es schon; es wird nicht überschrieben.</translation>
    </message>
    <message>
        <source>{path} is written, but the disk may not keep it: {reason} ({folder}); save elsewhere, too.</source>
        <translation>{path} ist geschrieben, aber der Datenträger behält es vielleicht nicht: {reason} ({folder}); auch anderswo speichern.</translation>
    </message>
    <message>
        <source>{path} joins the mask {following} with itself.</source>
        <translation>{path} verbindet die Maske {following} mit sich selbst.</translation>
    </message>
    <message>
        <source>{path} may not be read; give yourself the permission, or ask its owner for it.</source>
        <translation>{path} darf nicht gelesen werden; geben Sie sich die Berechtigung, oder fragen Sie den Eigentümer danach.</translation>
    </message>
    <message>
        <source>{path} nests its parts more than {most} deep; no program writes such a file.</source>
        <translation>{path} verschachtelt Teile mehr als {most} tief; so eine Datei schreibt kein Programm.</translation>
    </message>
    <message>
        <source>{path} says no valid version; it may be damaged.</source>
        <translation>{path} nennt keine gültige Version und ist vielleicht beschädigt.</translation>
    </message>
    <message>
        <source>{path} speaks of pictures of several sizes, which cannot be frames of one clip.</source>
        <translation>{path} spricht von Bildern verschiedener Größen, die nicht Frames eines Clips sein können.</translation>
    </message>
    <message>
        <source>{path} speaks of pictures of {width:g} x {height:g} pixels; that cannot be.</source>
        <translation>{path} spricht von Bildern mit {width:g} x {height:g} Pixeln; das kann nicht sein.</translation>
    </message>
    <message>
        <source>{path} unpacks to more than {most} MiB; split it into several files.</source>
        <translation>{path} ist entpackt größer als {most} MiB; auf mehrere Dateien aufteilen.</translation>
    </message>
    <message>
        <source>{path} was written by a newer ROAM (file version {version}, this program reads up to {newest}); open it with that version.</source>
        <translation>{path} wurde von einem neueren ROAM geschrieben (Dateiversion {version}, dieses Programm liest bis {newest}); mit jener Version öffnen.</translation>
    </message>
    <message>
        <source>{path}: the curves of the node {node} are not in the form of Nuke 7 and later; save the script with such a version.</source>
        <translation>{path}: Die Kurven des Knotens {node} haben nicht die Form von Nuke 7 und später; das Skript mit so einer Version speichern.</translation>
    </message>
    <message>
        <source>{pattern}: nothing is put in place of {place}; {name} stands for a layer or shape.</source>
        <translation>{pattern}: Für {place} wird nichts eingesetzt; {name} steht für eine Ebene oder Form.</translation>
    </message>
    <message>
        <source>{pattern}: {name} stands for a layer or shape, but there is one matte of all; ask for one per layer or per shape, or take it out.</source>
        <translation>{pattern}: {name} steht für eine Ebene oder Form, es gibt aber eine Matte für alle; eine je Ebene oder je Form verlangen, oder es herausnehmen.</translation>
    </message>
    <message>
        <source>{pixels:.1f} px</source>
        <translation>{pixels:.1f} px</translation>
    </message>
    <message>
        <source>{pixels:.1f} px  {name}</source>
        <translation>{pixels:.1f} px  {name}</translation>
    </message>
    <message>
        <source>{pixels:.1f} px  {name}, boils</source>
        <translation>{pixels:.1f} px  {name}, flimmert</translation>
    </message>
    <message>
        <source>{pixels:g} px</source>
        <translation>{pixels:g} px</translation>
    </message>
    <message>
        <source>{place}, item {number}</source>
        <translation>{place}, Eintrag {number}</translation>
    </message>
    <message>
        <source>{place}, key on frame {frame}</source>
        <translation>{place}, Keyframe auf Frame {frame}</translation>
    </message>
    <message>
        <source>{place}, {field}</source>
        <translation>{place}, {field}</translation>
    </message>
    <message>
        <source>{plate} gives no picture files: the images&apos; names are made up, as {name}.</source>
        <translation>{plate} hat keine Bilddateien: Die Namen der Bilder sind erfunden, etwa {name}.</translation>
    </message>
    <message>
        <source>{program} counts from 0, the clip&apos;s first frame: an offset of {offset} numbers frames below that, which it does not show.</source>
        <translation>{program} zählt ab 0, dem ersten Frame des Clips: Ein Versatz von {offset} nummeriert Frames darunter, die es nicht zeigt.</translation>
    </message>
    <message>
        <source>{property!r} has no value</source>
        <translation>{property!r} hat keinen Wert</translation>
    </message>
    <message>
        <source>{property!r} has {found} numbers, not {count}</source>
        <translation>{property!r} hat {found} Zahlen, nicht {count}</translation>
    </message>
    <message>
        <source>{rate:.0f} of </source>
        <translation>{rate:.0f} von </translation>
    </message>
    <message>
        <source>{sentence}. Drag to change</source>
        <translation>{sentence}. Ziehen ändert</translation>
    </message>
    <message>
        <source>{shapes}, tracked keys of frames {first} to {last}</source>
        <translation>{shapes}, getrackte Keyframes von Frame {first} bis {last}</translation>
    </message>
    <message>
        <source>{shown}{fps:g} fps{times}</source>
        <translation>{shown}{fps:g} fps{times}</translation>
    </message>
    <message>
        <source>{size:.0f} MB</source>
        <translation>{size:.0f} MB</translation>
    </message>
    <message>
        <source>{size:.1f} GB</source>
        <translation>{size:.1f} GB</translation>
    </message>
    <message>
        <source>{size:.1f} MB</source>
        <translation>{size:.1f} MB</translation>
    </message>
    <message>
        <source>{space} (found)</source>
        <translation>{space} (gefunden)</translation>
    </message>
    <message>
        <source>{species} {name} warps by its curves, which make no matte: they came in hidden.</source>
        <translation>{species} {name} verzerrt mit seinen Kurven, die keine Matte ergeben: Sie kamen ausgeblendet.</translation>
    </message>
    <message>
        <source>{stays}; and {stale}</source>
        <translation>{stays}; und {stale}</translation>
    </message>
    <message>
        <source>{text!r} is no number</source>
        <translation>{text!r} ist keine Zahl</translation>
    </message>
    <message>
        <source>{text!r} is no sensible number</source>
        <translation>{text!r} ist keine sinnvolle Zahl</translation>
    </message>
    <message>
        <source>{tip}; double click: neutral</source>
        <translation>{tip}; Doppelklick: neutral</translation>
    </message>
    <message>
        <source>{title}
Drag to move, double-click to write, right-click to remove</source>
        <translation>{title}
Ziehen verschiebt, Doppelklick schreibt, Rechtsklick entfernt</translation>
    </message>
    <message>
        <source>{title}, frame {frame}: {value:.4g} {unit}</source>
        <translation>{title}, Frame {frame}: {value:.4g} {unit}</translation>
    </message>
    <message>
        <source>{title}. Click to select</source>
        <translation>{title}. Klicken wählt aus</translation>
    </message>
    <message>
        <source>{true!r} is called {plain!r}</source>
        <translation>{true!r} heißt {plain!r}</translation>
    </message>
    <message>
        <source>{value:.2f}</source>
        <translation>{value:.2f}</translation>
    </message>
    <message>
        <source>{view} on {display}</source>
        <translation>{view} auf {display}</translation>
    </message>
    <message>
        <source>{what}  The energy falls by {figures}.</source>
        <translation>{what}  Die Energie fällt um {figures}.</translation>
    </message>
    <message>
        <source>{what} is starting …</source>
        <translation>{what} beginnt …</translation>
    </message>
    <message>
        <source>{what} stopped at frame {frame}; its frames were taken back.</source>
        <translation>{what} bei Frame {frame} angehalten; seine Frames wurden zurückgenommen.</translation>
    </message>
    <message>
        <source>{what} stopped at frame {frame}; the finished frames stay.</source>
        <translation>{what} bei Frame {frame} angehalten; die fertigen Frames bleiben.</translation>
    </message>
    <message>
        <source>{what} stopped before a frame was finished; the finished frames stay.</source>
        <translation>{what} angehalten, bevor ein Frame fertig war; die fertigen Frames bleiben.</translation>
    </message>
    <message>
        <source>{what}: look at frame {frame}, the confidence is {confidence:.2f} there.</source>
        <translation>{what}: Bitte Frame {frame} prüfen, die Konfidenz ist dort {confidence:.2f}.</translation>
    </message>
    <message>
        <source>{where} since frame {frame}</source>
        <translation>{where} seit Frame {frame}</translation>
    </message>
    <message>
        <source>{width:.0f} × {height:.0f} pixels. Shift: equal sides. Ctrl: from the centre.</source>
        <translation>{width:.0f} × {height:.0f} Pixel. Umschalt: gleiche Seiten. Strg: von der Mitte aus.</translation>
    </message>
    <message>
        <source>{word!r} ends before it begins; the first frame comes first.</source>
        <translation>{word!r} endet, bevor es beginnt; der erste Frame steht vorn.</translation>
    </message>
    <message>
        <source>{word!r} lies outside the clip&apos;s frames {first}-{last}.</source>
        <translation>{word!r} liegt außerhalb der Frames {first}-{last} des Clips.</translation>
    </message>
    <message>
        <source>{word!r} names no frames; say {words}.</source>
        <translation>{word!r} nennt keine Frames; möglich ist {words}.</translation>
    </message>
    <message>
        <source>“{action}” in the menu</source>
        <translation>„{action}“ im Menü</translation>
    </message>
    <message>
        <source>“{action}” is {keys} now.</source>
        <translation>„{action}“ ist jetzt {keys}.</translation>
    </message>
    <message>
        <source>… and shear</source>
        <translation>… und Scherung</translation>
    </message>
</context>
</TS>
