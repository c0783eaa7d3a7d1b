<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>AboutDialog</name>
    <message>
        <source>About Impronta</source>
        <translation>Über Impronta</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Copy versions</source>
        <translation>Versionen kopieren</translation>
    </message>
    <message>
        <source>Impronta itself is free software under the MIT licence.</source>
        <translation>Impronta selbst ist freie Software unter der MIT-Lizenz.</translation>
    </message>
    <message>
        <source>Impronta {version}</source>
        <translation>Impronta {version}</translation>
    </message>
    <message>
        <source>Its package brings no text of the licence along.</source>
        <translation>Das Paket bringt keinen Lizenztext mit.</translation>
    </message>
    <message>
        <source>Libraries and their licences</source>
        <translation>Bibliotheken und ihre Lizenzen</translation>
    </message>
    <message>
        <source>Libraries in this program</source>
        <translation>Bibliotheken in diesem Programm</translation>
    </message>
    <message>
        <source>Measures an object with two cameras and a laser spot, and turns the points into a closed surface: ear impressions, dental models.</source>
        <translation>Vermisst ein Objekt mit zwei Kameras und einem Laserpunkt und macht aus den Punkten eine geschlossene Oberfläche: Ohrabformungen, Dentalmodelle.</translation>
    </message>
    <message>
        <source>Names and versions of everything in this program, as text</source>
        <translation>Namen und Versionen von allem in diesem Programm, als Text</translation>
    </message>
    <message>
        <source>Text of the licence</source>
        <translation>Text der Lizenz</translation>
    </message>
    <message>
        <source>The method is the published one of G. Tognola et al., “Contact-less 3D-Coordinate Measurement System by Laser Scanning and Image Reconstruction from Unorganized Data”: two cameras see a laser spot, and a surface adapts itself to the points.</source>
        <translation>Das Verfahren ist das veröffentlichte von G. Tognola et al., „Contact-less 3D-Coordinate Measurement System by Laser Scanning and Image Reconstruction from Unorganized Data“: Zwei Kameras sehen einen Laserpunkt, und eine Oberfläche passt sich den Punkten an.</translation>
    </message>
</context>
<context>
    <name>AccuracyCard</name>
    <message>
        <source>95 % of the measured points lie within this width around the sphere</source>
        <translation>95 % der Messpunkte liegen innerhalb dieser Breite um die Kugel</translation>
    </message>
    <message>
        <source>Calibrated on {date}; {rms} µm rms at corners of the board that were left out.</source>
        <translation>Kalibriert am {date}; {rms} µm rms an nicht benutzten Ecken der Tafel.</translation>
    </message>
    <message>
        <source>Diameter of the reference sphere as measured, less what its certificate says</source>
        <translation>Gemessener Durchmesser der Referenzkugel abzüglich dessen, was ihr Zertifikat nennt</translation>
    </message>
    <message>
        <source>How accurate is it?</source>
        <translation>Wie genau misst der Messplatz?</translation>
    </message>
    <message>
        <source>It measures otherwise than in the tests before: calibrate, and test it again.</source>
        <translation>Er misst anders als in den Prüfungen zuvor: kalibrieren und neu prüfen.</translation>
    </message>
    <message>
        <source>Measure the sphere…</source>
        <translation>Kugel messen…</translation>
    </message>
    <message>
        <source>No reference sphere was measured with this rig yet.</source>
        <translation>Mit diesem Messplatz wurde noch keine Referenzkugel gemessen.</translation>
    </message>
    <message>
        <source>Reference sphere, {date} ({age})</source>
        <translation>Referenzkugel, {date} ({age})</translation>
    </message>
    <message>
        <source>The Rig page says what is wrong with the rig file.</source>
        <translation>Die Seite Messplatz sagt, was an der Messplatzdatei falsch ist.</translation>
    </message>
    <message>
        <source>The rig was calibrated since: measure the sphere again.</source>
        <translation>Der Messplatz wurde seither kalibriert: Kugel neu messen.</translation>
    </message>
    <message>
        <source>The test is {n} days old: measure the sphere again.</source>
        <translation>Die Prüfung ist {n} Tage alt: Kugel neu messen.</translation>
    </message>
    <message>
        <source>This rig is not calibrated. The Rig page does that in a few minutes.</source>
        <translation>Dieser Messplatz ist nicht kalibriert. Die Seite Messplatz tut das in wenigen Minuten.</translation>
    </message>
    <message>
        <source>µm D95</source>
        <translation>µm D95</translation>
    </message>
    <message>
        <source>µm size deviation</source>
        <translation>µm Maßabweichung</translation>
    </message>
</context>
<context>
    <name>AimPage</name>
    <message>
        <source>Aim</source>
        <translation>Anvisieren</translation>
    </message>
    <message>
        <source>Automatic exposure</source>
        <translation>Belichtung automatisch</translation>
    </message>
    <message>
        <source>Beam down</source>
        <translation>Strahl nach unten</translation>
    </message>
    <message>
        <source>Beam left</source>
        <translation>Strahl nach links</translation>
    </message>
    <message>
        <source>Beam right</source>
        <translation>Strahl nach rechts</translation>
    </message>
    <message>
        <source>Beam up</source>
        <translation>Strahl nach oben</translation>
    </message>
    <message>
        <source>By hand</source>
        <translation>Von Hand</translation>
    </message>
    <message>
        <source>Camera left</source>
        <translation>Kamera links</translation>
    </message>
    <message>
        <source>Camera right</source>
        <translation>Kamera rechts</translation>
    </message>
    <message>
        <source>Finds exposure and gain for the object: the beam visits some places of it</source>
        <translation>Sucht Belichtung und Verstärkung für das Objekt: Der Strahl fährt einige Stellen davon an</translation>
    </message>
    <message>
        <source>Go on to the scan</source>
        <translation>Weiter zum Scan</translation>
    </message>
    <message>
        <source>Keep as…</source>
        <translation>Merken als…</translation>
    </message>
    <message>
        <source>Keep what is set now as a material of your own</source>
        <translation>Die jetzigen Einstellungen als eigenes Material merken</translation>
    </message>
    <message>
        <source>Laser off</source>
        <translation>Laser aus</translation>
    </message>
    <message>
        <source>Laser on. It goes dark on Esc, when this page is left, or in {seconds} s if nothing is touched.</source>
        <translation>Laser an. Er erlischt mit Esc, beim Verlassen der Seite oder in {seconds} s ohne Bedienung.</translation>
    </message>
    <message>
        <source>Learn</source>
        <translation>Lernen</translation>
    </message>
    <message>
        <source>Live: light the laser</source>
        <translation>Live: Laser an</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>Name of the material</source>
        <translation>Name des Materials</translation>
    </message>
    <message>
        <source>Progress of learning</source>
        <translation>Fortschritt des Lernens</translation>
    </message>
    <message>
        <source>Size of a spot, pixels</source>
        <translation>Größe eines Lichtpunkts, Pixel</translation>
    </message>
    <message>
        <source>Steps of {n} degrees</source>
        <translation>Schritte von {n} Grad</translation>
    </message>
    <message>
        <source>Table clockwise</source>
        <translation>Teller im Uhrzeigersinn</translation>
    </message>
    <message>
        <source>Table counter-clockwise</source>
        <translation>Teller gegen den Uhrzeigersinn</translation>
    </message>
    <message>
        <source>The laser is off. Goggles on, nobody looks into the beam: then light it.</source>
        <translation>Der Laser ist aus. Schutzbrille auf, niemand blickt in den Strahl: dann einschalten.</translation>
    </message>
    <message>
        <source>The rig is not free; the Rig page says why.</source>
        <translation>Der Messplatz ist nicht frei; die Seite Messplatz sagt, warum.</translation>
    </message>
    <message>
        <source>The spot is lit while this page is shown, and goes dark on Esc or when nobody touches anything for a while</source>
        <translation>Der Laserpunkt leuchtet, solange diese Seite gezeigt wird, und erlischt mit Esc oder wenn eine Weile niemand etwas bedient</translation>
    </message>
    <message>
        <source>Two seconds of live pictures while the beam moves a little: sizes of spots that both cameras agree on</source>
        <translation>Zwei Sekunden Livebilder, während sich der Strahl ein wenig bewegt: Punktgrößen, in denen beide Kameras übereinstimmen</translation>
    </message>
</context>
<context>
    <name>AimPicture</name>
    <message>
        <source>Click: bring the spot there. Arrow keys: move the beam. Page Up and Page Down: turn the table. Wheel, + and −: zoom.</source>
        <translation>Klick: Laserpunkt dorthin bringen. Pfeiltasten: Strahl bewegen. Bild auf und Bild ab: Teller drehen. Rad, + und −: Zoom.</translation>
    </message>
    <message>
        <source>{camera}: {count} bright places, no spot accepted</source>
        <translation>{camera}: {count} helle Stellen, kein Laserpunkt angenommen</translation>
    </message>
    <message>
        <source>{camera}: {count} bright places, spot accepted</source>
        <translation>{camera}: {count} helle Stellen, Laserpunkt angenommen</translation>
    </message>
</context>
<context>
    <name>AlignmentPanel</name>
    <message>
        <source>Erase</source>
        <translation>Radieren</translation>
    </message>
    <message>
        <source>Held fixed</source>
        <translation>Festgehalten</translation>
    </message>
    <message>
        <source>Noise of a distance</source>
        <translation>Rauschen eines Abstands</translation>
    </message>
    <message>
        <source>Paint stable</source>
        <translation>Stabil malen</translation>
    </message>
    <message>
        <source>Pick three points on each…</source>
        <translation>Je drei Punkte wählen…</translation>
    </message>
    <message>
        <source>Residual there</source>
        <translation>Restfehler dort</translation>
    </message>
    <message>
        <source>Show the stable region</source>
        <translation>Stabilen Bereich zeigen</translation>
    </message>
    <message>
        <source>Size, after to before</source>
        <translation>Größe, nachher zu vorher</translation>
    </message>
    <message>
        <source>Stable share</source>
        <translation>Anteil stabil</translation>
    </message>
    <message>
        <source>Start found by</source>
        <translation>Start gefunden durch</translation>
    </message>
    <message>
        <source>Uncertainty</source>
        <translation>Unsicherheit</translation>
    </message>
    <message>
        <source>With a counterpart</source>
        <translation>Mit Gegenstück</translation>
    </message>
    <message>
        <source>not estimated</source>
        <translation>nicht geschätzt</translation>
    </message>
    <message>
        <source>{frame} instead would shift everything by {rms} mm on average, {most} mm at most.</source>
        <translation>{frame} würde stattdessen alles um im Mittel {rms} mm verschieben, höchstens {most} mm.</translation>
    </message>
    <message>
        <source>{frame} instead would shift the front teeth by {n} mm.</source>
        <translation>{frame} würde stattdessen die Frontzähne um {n} mm verschieben.</translation>
    </message>
    <message>
        <source>{frame} instead would shift the molars by {n} mm.</source>
        <translation>{frame} würde stattdessen die Backenzähne um {n} mm verschieben.</translation>
    </message>
    <message>
        <source>{n} %</source>
        <translation>{n} %</translation>
    </message>
    <message>
        <source>{n} mm</source>
        <translation>{n} mm</translation>
    </message>
    <message>
        <source>{n} mm rms</source>
        <translation>{n} mm rms</translation>
    </message>
    <message>
        <source>± {n} mm (k = 2)</source>
        <translation>± {n} mm (k = 2)</translation>
    </message>
</context>
<context>
    <name>AreaList</name>
    <message>
        <source>Areas of greatest difference</source>
        <translation>Flächen mit dem größten Unterschied</translation>
    </message>
</context>
<context>
    <name>AssistantPage</name>
    <message>
        <source>1  Find the devices</source>
        <translation>1  Geräte finden</translation>
    </message>
    <message>
        <source>2  Check the rig</source>
        <translation>2  Messplatz prüfen</translation>
    </message>
    <message>
        <source>3  Write its file</source>
        <translation>3  Datei schreiben</translation>
    </message>
    <message>
        <source>Asking every port and every camera  ·  {left} left</source>
        <translation>Jeder Anschluss und jede Kamera wird gefragt  ·  noch {left}</translation>
    </message>
    <message>
        <source>Back to the Rig page; the devices are released</source>
        <translation>Zurück zur Seite Messplatz; die Geräte werden freigegeben</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Every serial port and every camera is asked who it is. A board may restart; nothing moves, and no laser is lit.</source>
        <translation>Jeder serielle Anschluss und jede Kamera wird gefragt, wer sie sind. Eine Steuerung kann dabei neu starten; nichts bewegt sich, und kein Laser leuchtet.</translation>
    </message>
    <message>
        <source>Go on without a check</source>
        <translation>Ohne Prüfung weiter</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>Verlassen</translation>
    </message>
    <message>
        <source>Look again</source>
        <translation>Neu suchen</translation>
    </message>
    <message>
        <source>Look for devices</source>
        <translation>Geräte suchen</translation>
    </message>
    <message>
        <source>Next: check the rig</source>
        <translation>Weiter: Messplatz prüfen</translation>
    </message>
    <message>
        <source>Next: write its file</source>
        <translation>Weiter: Datei schreiben</translation>
    </message>
    <message>
        <source>Progress of the search</source>
        <translation>Fortschritt der Suche</translation>
    </message>
    <message>
        <source>Set up a rig</source>
        <translation>Messplatz einrichten</translation>
    </message>
    <message>
        <source>Still to be chosen: {what}.</source>
        <translation>Noch zu wählen: {what}.</translation>
    </message>
    <message>
        <source>The rig of the program is measuring: its devices are free afterwards.</source>
        <translation>Der Messplatz des Programms misst gerade: Danach sind seine Geräte frei.</translation>
    </message>
    <message>
        <source>a controller</source>
        <translation>eine Steuerung</translation>
    </message>
    <message>
        <source>the left camera</source>
        <translation>die linke Kamera</translation>
    </message>
    <message>
        <source>the right camera</source>
        <translation>die rechte Kamera</translation>
    </message>
</context>
<context>
    <name>AssistantPictures</name>
    <message>
        <source>Camera left</source>
        <translation>Kamera links</translation>
    </message>
    <message>
        <source>Camera right</source>
        <translation>Kamera rechts</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>Live</translation>
    </message>
    <message>
        <source>What the cameras see</source>
        <translation>Was die Kameras sehen</translation>
    </message>
    <message>
        <source>no spot</source>
        <translation>kein Lichtpunkt</translation>
    </message>
</context>
<context>
    <name>Banner</name>
    <message>
        <source>Close this message</source>
        <translation>Diese Meldung schließen</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Details</translation>
    </message>
    <message>
        <source>Support bundle…</source>
        <translation>Support-Paket…</translation>
    </message>
</context>
<context>
    <name>BaseShape</name>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Find it again</source>
        <translation>Neu suchen</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Tilt along x</source>
        <translation>Neigung längs x</translation>
    </message>
    <message>
        <source>Tilt along y</source>
        <translation>Neigung längs y</translation>
    </message>
    <message>
        <source>What is below the plane goes.</source>
        <translation>Was unter der Ebene liegt, fällt weg.</translation>
    </message>
</context>
<context>
    <name>BoardWatchView</name>
    <message>
        <source>Camera left</source>
        <translation>Kamera links</translation>
    </message>
    <message>
        <source>Camera right</source>
        <translation>Kamera rechts</translation>
    </message>
    <message>
        <source>Starting…</source>
        <translation>Beginnt…</translation>
    </message>
</context>
<context>
    <name>BrushSize</name>
    <message>
        <source>Brush {mm} mm</source>
        <translation>Pinsel {mm} mm</translation>
    </message>
    <message>
        <source>Size of the brush</source>
        <translation>Größe des Pinsels</translation>
    </message>
</context>
<context>
    <name>ByHandPanel</name>
    <message>
        <source>1.  Light the board well and evenly; the cameras set their exposure by themselves.</source>
        <translation>1.  Die Tafel gut und gleichmäßig beleuchten; die Kameras stellen ihre Belichtung selbst ein.</translation>
    </message>
    <message>
        <source>2.  Hold it into the volume, each time tilted another way and at another place. Rest it until the view is taken.</source>
        <translation>2.  Sie in das Messvolumen halten, jedes Mal anders geneigt und an anderer Stelle. Ruhig halten, bis die Ansicht aufgenommen ist.</translation>
    </message>
    <message>
        <source>3.  With a length bar: hold that likewise, both ends in sight.</source>
        <translation>3.  Mit einem Längenstab: ebenso halten, beide Enden im Bild.</translation>
    </message>
    <message>
        <source>4.  Lay the board on the table and take your hands away: the table turns by itself.</source>
        <translation>4.  Die Tafel auf den Teller legen und die Hände wegnehmen: Der Teller dreht von selbst.</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Calibrate by hand</source>
        <translation>Von Hand kalibrieren</translation>
    </message>
    <message>
        <source>Certified length bar</source>
        <translation>Zertifizierter Längenstab</translation>
    </message>
    <message>
        <source>Certified length of the bar</source>
        <translation>Zertifizierte Länge des Stabs</translation>
    </message>
    <message>
        <source>From the table to the printed face: it places the origin on the table.</source>
        <translation>Vom Teller bis zur bedruckten Seite: Das legt den Ursprung auf den Teller.</translation>
    </message>
    <message>
        <source>Known length</source>
        <translation>Bekannte Länge</translation>
    </message>
    <message>
        <source>Neither: the scale stays unverified</source>
        <translation>Keines: Der Maßstab bleibt ungeprüft</translation>
    </message>
    <message>
        <source>Print measured with a caliper</source>
        <translation>Druck mit Messschieber gemessen</translation>
    </message>
    <message>
        <source>Printed row of squares, outer edge to outer edge</source>
        <translation>Gedruckte Feldreihe, Außenkante zu Außenkante</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Starten</translation>
    </message>
    <message>
        <source>The print: its whole row of squares, from outer edge to outer edge.</source>
        <translation>Der Druck: seine ganze Feldreihe, von Außenkante zu Außenkante.</translation>
    </message>
    <message>
        <source>Thickness of the board</source>
        <translation>Dicke der Tafel</translation>
    </message>
    <message>
        <source>You show the printed board to both cameras; it takes about ten minutes. The laser stays off.</source>
        <translation>Die gedruckte Tafel wird beiden Kameras gezeigt; das dauert etwa zehn Minuten. Der Laser bleibt aus.</translation>
    </message>
</context>
<context>
    <name>CalibratingPanel</name>
    <message>
        <source>% done</source>
        <translation>% fertig</translation>
    </message>
    <message>
        <source>Calibrating</source>
        <translation>Kalibrierung</translation>
    </message>
    <message>
        <source>Camera left</source>
        <translation>Kamera links</translation>
    </message>
    <message>
        <source>Camera right</source>
        <translation>Kamera rechts</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Cancelling…</source>
        <translation>Wird abgebrochen…</translation>
    </message>
    <message>
        <source>Covered by the board</source>
        <translation>Von der Tafel überdeckt</translation>
    </message>
    <message>
        <source>Distances of the board</source>
        <translation>Entfernungen der Tafel</translation>
    </message>
    <message>
        <source>Largest tilt between two boards</source>
        <translation>Größte Neigung zwischen zwei Tafeln</translation>
    </message>
    <message>
        <source>Nothing: all views are taken.</source>
        <translation>Nichts: Alle Ansichten sind aufgenommen.</translation>
    </message>
    <message>
        <source>Still missing</source>
        <translation>Noch fehlt</translation>
    </message>
    <message>
        <source>Then the calibration of {date} stays in use.</source>
        <translation>Dann bleibt die Kalibrierung vom {date} in Gebrauch.</translation>
    </message>
    <message>
        <source>Transcript…</source>
        <translation>Mitschrift…</translation>
    </message>
    <message>
        <source>Without a calibration the rig cannot scan.</source>
        <translation>Ohne Kalibrierung kann der Messplatz nicht scannen.</translation>
    </message>
    <message>
        <source>and {n} more</source>
        <translation>und {n} weitere</translation>
    </message>
    <message>
        <source>{left}  ·  the virtual rig shows the board by itself</source>
        <translation>{left}  ·  der virtuelle Messplatz zeigt die Tafel von selbst</translation>
    </message>
    <message>
        <source>{left} left</source>
        <translation>noch {left}</translation>
    </message>
    <message>
        <source>{near} to {far} mm</source>
        <translation>{near} bis {far} mm</translation>
    </message>
    <message>
        <source>{n} of {count} fields</source>
        <translation>{n} von {count} Feldern</translation>
    </message>
</context>
<context>
    <name>CalibrationPanel</name>
    <message>
        <source>Accepted  ·  {age}</source>
        <translation>Angenommen  ·  {age}</translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation>Kalibrieren</translation>
    </message>
    <message>
        <source>Calibrated on {date}, {age}.</source>
        <translation>Kalibriert am {date}, {age}.</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Kalibrierung</translation>
    </message>
    <message>
        <source>Its calibration stands in the rig file.</source>
        <translation>Seine Kalibrierung steht in der Messplatzdatei.</translation>
    </message>
    <message>
        <source>New calibration not accepted</source>
        <translation>Neue Kalibrierung nicht angenommen</translation>
    </message>
    <message>
        <source>Not calibrated</source>
        <translation>Nicht kalibriert</translation>
    </message>
    <message>
        <source>Not calibrated yet: show the board to both cameras before the first scan.</source>
        <translation>Noch nicht kalibriert: Vor dem ersten Scan die Tafel beiden Kameras zeigen.</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Print the target…</source>
        <translation>Tafel drucken…</translation>
    </message>
    <message>
        <source>Since the previous calibration</source>
        <translation>Seit der vorigen Kalibrierung</translation>
    </message>
    <message>
        <source>The calibration of {date} stays in use.</source>
        <translation>Die Kalibrierung vom {date} bleibt in Gebrauch.</translation>
    </message>
    <message>
        <source>The calibration target as a page to print</source>
        <translation>Die Kalibriertafel als Seite zum Drucken</translation>
    </message>
    <message>
        <source>Without a calibration the rig cannot scan.</source>
        <translation>Ohne Kalibrierung kann der Messplatz nicht scannen.</translation>
    </message>
    <message>
        <source>Written to {path}. Print it at 100 % and check that its ruler measures {ruler} mm.</source>
        <translation>Geschrieben nach {path}. Mit 100 % drucken und prüfen, dass das Lineal {ruler} mm misst.</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>µm rms at board corners that were not used</source>
        <translation>µm rms an nicht benutzten Tafelecken</translation>
    </message>
</context>
<context>
    <name>CameraCard</name>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>{camera} is the {side} camera</source>
        <translation>{camera} ist die Kamera {side}</translation>
    </message>
</context>
<context>
    <name>CameraPreview</name>
    <message>
        <source>Wheel: zoom. Drag: move. Double click: whole picture.</source>
        <translation>Rad: Zoom. Ziehen: verschieben. Doppelklick: ganzes Bild.</translation>
    </message>
    <message>
        <source>no picture yet</source>
        <translation>noch kein Bild</translation>
    </message>
    <message>
        <source>recorded: shown while it is measured</source>
        <translation>Aufnahme: wird beim Messen gezeigt</translation>
    </message>
    <message>
        <source>σ {x} × {y} px · peak {peak} %</source>
        <translation>σ {x} × {y} px · Spitze {peak} %</translation>
    </message>
</context>
<context>
    <name>CameraSettings</name>
    <message>
        <source> frames/s</source>
        <translation> Bilder/s</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> ms</translation>
    </message>
    <message>
        <source>Exposure</source>
        <translation>Belichtung</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Bildrate</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Trigger</source>
        <translation>Trigger</translation>
    </message>
    <message>
        <source>as the camera has it</source>
        <translation>wie in der Kamera</translation>
    </message>
    <message>
        <source>{width} × {height} px</source>
        <translation>{width} × {height} px</translation>
    </message>
</context>
<context>
    <name>CheckLine</name>
    <message>
        <source>Pictures</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Pictures of: {check}</source>
        <translation>Bilder zu: {check}</translation>
    </message>
</context>
<context>
    <name>CheckList</name>
    <message>
        <source>Checks</source>
        <translation>Prüfungen</translation>
    </message>
</context>
<context>
    <name>CheckStep</name>
    <message>
        <source>All {n} checks are good.</source>
        <translation>Alle {n} Prüfungen sind gut.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Cancelling…</source>
        <translation>Wird abgebrochen…</translation>
    </message>
    <message>
        <source>Check again</source>
        <translation>Neu prüfen</translation>
    </message>
    <message>
        <source>Everybody near the rig is protected, and nothing is in the way of beam and table</source>
        <translation>Alle am Messplatz sind geschützt, und nichts steht Strahl und Teller im Weg</translation>
    </message>
    <message>
        <source>Not everything is as it should be: {checks}.</source>
        <translation>Nicht alles ist, wie es sein soll: {checks}.</translation>
    </message>
    <message>
        <source>Only look and move by hand</source>
        <translation>Nur ansehen und von Hand bewegen</translation>
    </message>
    <message>
        <source>Opening the devices</source>
        <translation>Geräte werden geöffnet</translation>
    </message>
    <message>
        <source>Progress of the check</source>
        <translation>Fortschritt der Prüfung</translation>
    </message>
    <message>
        <source>Start the check</source>
        <translation>Prüfung starten</translation>
    </message>
    <message>
        <source>The check moves beam and table and lights the laser. A laser of class 3R can injure the eye: do not look into the beam or its reflections, wear goggles for its wavelength, take rings and watches off, and keep hands and hair out of the rig. Esc and the red button at the lower left stop everything at once.</source>
        <translation>Die Prüfung bewegt Strahl und Teller und schaltet den Laser ein. Ein Laser der Klasse 3R kann das Auge verletzen: nicht in den Strahl oder seine Reflexe blicken, Schutzbrille für seine Wellenlänge tragen, Ringe und Uhren ablegen, Hände und Haare aus dem Messplatz halten. Esc und der rote Knopf unten links stoppen alles sofort.</translation>
    </message>
    <message>
        <source>{doing}  ·  {left} left</source>
        <translation>{doing}  ·  noch {left}</translation>
    </message>
</context>
<context>
    <name>ChosenView</name>
    <message>
        <source>Measure this view once more: after the last one while the scan runs, else at once</source>
        <translation>Diese Ansicht noch einmal messen: bei laufendem Scan nach der letzten, sonst sofort</translation>
    </message>
    <message>
        <source>Redo this view</source>
        <translation>Ansicht wiederholen</translation>
    </message>
</context>
<context>
    <name>CompareFoot</name>
    <message>
        <source>Align on the painted region</source>
        <translation>Am gemalten Bereich ausrichten</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Cancelling…</source>
        <translation>Wird abgebrochen…</translation>
    </message>
    <message>
        <source>Click three points on each surface, in the same order and far from each other. Before: {b} of 3, after: {a} of 3.</source>
        <translation>Auf jeder Oberfläche drei Punkte anklicken, in gleicher Reihenfolge und weit auseinander. Vorher: {b} von 3, nachher: {a} von 3.</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleichen</translation>
    </message>
    <message>
        <source>Keep it in the open case</source>
        <translation>Im offenen Fall sichern</translation>
    </message>
    <message>
        <source>Paint what did not move, then align on it.</source>
        <translation>Malen, was sich nicht bewegt hat, dann daran ausrichten.</translation>
    </message>
    <message>
        <source>Pick three points on each…</source>
        <translation>Je drei Punkte wählen…</translation>
    </message>
    <message>
        <source>Save the report…</source>
        <translation>Bericht speichern…</translation>
    </message>
    <message>
        <source>Show in its folder</source>
        <translation>Im Ordner zeigen</translation>
    </message>
    <message>
        <source>Starting…</source>
        <translation>Beginnt…</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Noch einmal</translation>
    </message>
    <message>
        <source>Two surfaces are needed: one before, one after.</source>
        <translation>Zwei Oberflächen sind nötig: eine vorher, eine nachher.</translation>
    </message>
    <message>
        <source>Writing the report: {left} left</source>
        <translation>Bericht wird geschrieben: noch {left}</translation>
    </message>
    <message>
        <source>Writing the report…</source>
        <translation>Bericht wird geschrieben…</translation>
    </message>
    <message>
        <source>Written: {folder}</source>
        <translation>Geschrieben: {folder}</translation>
    </message>
    <message>
        <source>{phase}: {left} left</source>
        <translation>{phase}: noch {left}</translation>
    </message>
</context>
<context>
    <name>ComparePage</name>
    <message>
        <source>A surface is an STL, PLY, OBJ, VTP or 3MF file, or a case.</source>
        <translation>Eine Oberfläche ist eine STL-, PLY-, OBJ-, VTP- oder 3MF-Datei oder ein Fall.</translation>
    </message>
    <message>
        <source>After</source>
        <translation>Nachher</translation>
    </message>
    <message>
        <source>Alignment</source>
        <translation>Ausrichtung</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Vorher</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleichen</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Befunde</translation>
    </message>
    <message>
        <source>Folder for the report</source>
        <translation>Ordner für den Bericht</translation>
    </message>
    <message>
        <source>Preparing the 3D view…</source>
        <translation>3D-Ansicht wird vorbereitet…</translation>
    </message>
    <message>
        <source>Surfaces</source>
        <translation>Oberflächen</translation>
    </message>
    <message>
        <source>Surfaces ({kinds})</source>
        <translation>Oberflächen ({kinds})</translation>
    </message>
    <message>
        <source>The state that everything is compared with</source>
        <translation>Der Zustand, mit dem alles verglichen wird</translation>
    </message>
    <message>
        <source>The state whose changes are shown</source>
        <translation>Der Zustand, dessen Änderungen gezeigt werden</translation>
    </message>
    <message>
        <source>The surface after</source>
        <translation>Die Oberfläche nachher</translation>
    </message>
    <message>
        <source>The surface before</source>
        <translation>Die Oberfläche vorher</translation>
    </message>
    <message>
        <source>There is no 3D view; the numbers stand beside it.</source>
        <translation>Es gibt keine 3D-Ansicht; die Zahlen stehen daneben.</translation>
    </message>
    <message>
        <source>Two surfaces are compared: the first two files were taken.</source>
        <translation>Zwei Oberflächen werden verglichen: Die ersten zwei Dateien wurden genommen.</translation>
    </message>
    <message>
        <source>{names}: not read.</source>
        <translation>{names}: nicht gelesen.</translation>
    </message>
</context>
<context>
    <name>CompareStage</name>
    <message>
        <source>Blend</source>
        <translation>Mischen</translation>
    </message>
    <message>
        <source>Comparison</source>
        <translation>Vergleich</translation>
    </message>
    <message>
        <source>Curtain</source>
        <translation>Vorhang</translation>
    </message>
    <message>
        <source>Cut both: through the chosen area from cheek to tongue, or through the middle</source>
        <translation>Beide schneiden: durch die gewählte Fläche von der Wange zur Zunge oder durch die Mitte</translation>
    </message>
    <message>
        <source>Fit (F)</source>
        <translation>Einpassen (F)</translation>
    </message>
    <message>
        <source>Flicker</source>
        <translation>Blinken</translation>
    </message>
    <message>
        <source>From before to after</source>
        <translation>Von vorher zu nachher</translation>
    </message>
    <message>
        <source>Frontal (1)</source>
        <translation>Frontal (1)</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Lingual</source>
        <translation>Lingual</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Karte</translation>
    </message>
    <message>
        <source>Morph</source>
        <translation>Morphen</translation>
    </message>
    <message>
        <source>Occlusal (7)</source>
        <translation>Okklusal (7)</translation>
    </message>
    <message>
        <source>One surface in place of the other (space bar)</source>
        <translation>Eine Oberfläche anstelle der anderen (Leertaste)</translation>
    </message>
    <message>
        <source>Place of the section</source>
        <translation>Lage des Schnitts</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>Side by side</source>
        <translation>Beide</translation>
    </message>
    <message>
        <source>Underside</source>
        <translation>Unterseite</translation>
    </message>
</context>
<context>
    <name>ComparisonCaptions</name>
    <message>
        <source>After</source>
        <translation>Nachher</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Vorher</translation>
    </message>
    <message>
        <source>L</source>
        <translation>L</translation>
    </message>
    <message>
        <source>R</source>
        <translation>R</translation>
    </message>
    <message>
        <source>{mm:g} mm</source>
        <translation>{mm:g} mm</translation>
    </message>
</context>
<context>
    <name>ComparisonTools</name>
    <message>
        <source>no counterpart</source>
        <translation>kein Gegenstück</translation>
    </message>
    <message>
        <source>within ±{mm} mm</source>
        <translation>innerhalb ±{mm} mm</translation>
    </message>
    <message>
        <source>{mm} mm</source>
        <translation>{mm} mm</translation>
    </message>
</context>
<context>
    <name>Corrections</name>
    <message>
        <source>Correct and check again</source>
        <translation>Berichtigen und neu prüfen</translation>
    </message>
    <message>
        <source>To be corrected</source>
        <translation>Zu berichtigen</translation>
    </message>
</context>
<context>
    <name>CoverageMap</name>
    <message>
        <source>{n} of {count} fields covered</source>
        <translation>{n} von {count} Feldern überdeckt</translation>
    </message>
</context>
<context>
    <name>CoveragePage</name>
    <message>
        <source>% of all</source>
        <translation>% von allem</translation>
    </message>
    <message>
        <source>% of what can be seen</source>
        <translation>% des Sichtbaren</translation>
    </message>
    <message>
        <source>Accept</source>
        <translation>Annehmen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Complete</source>
        <translation>Ergänzen</translation>
    </message>
    <message>
        <source>Computing</source>
        <translation>Berechnung</translation>
    </message>
    <message>
        <source>Cut away what does not belong to the object before it becomes a surface</source>
        <translation>Abschneiden, was nicht zum Objekt gehört, bevor eine Oberfläche daraus wird</translation>
    </message>
    <message>
        <source>Do not accept</source>
        <translation>Nicht annehmen</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Bearbeiten</translation>
    </message>
    <message>
        <source>Every place is as certain as wanted.</source>
        <translation>Jede Stelle ist so sicher wie gewünscht.</translation>
    </message>
    <message>
        <source>Fill now</source>
        <translation>Jetzt ergänzen</translation>
    </message>
    <message>
        <source>Find out</source>
        <translation>Feststellen</translation>
    </message>
    <message>
        <source>Leave the chosen place as it is: the case keeps that, the certificate tells it (A; again to take it back)</source>
        <translation>Die gewählte Stelle lassen, wie sie ist: Der Fall vermerkt es, der Prüfbericht nennt es (A; noch einmal nimmt es zurück)</translation>
    </message>
    <message>
        <source>Leave the object as it stands: the scan goes on where points are missing, until it is as wanted (Shift+F5)</source>
        <translation>Das Objekt stehen lassen: Der Scan geht dort weiter, wo Punkte fehlen, bis es ist wie gewünscht (Umschalt+F5)</translation>
    </message>
    <message>
        <source>Making a surface of the points…</source>
        <translation>Aus den Punkten wird eine Oberfläche…</translation>
    </message>
    <message>
        <source>Needs another mount</source>
        <translation>Neue Aufstellung nötig</translation>
    </message>
    <message>
        <source>Of a surface that was made of the points for this; the case has none yet.</source>
        <translation>Einer Oberfläche, die dafür aus den Punkten gemacht wurde; der Fall hat noch keine.</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Grund</translation>
    </message>
    <message>
        <source>Reconstruct</source>
        <translation>Rekonstruieren</translation>
    </message>
    <message>
        <source>Scan an object or open a case first.</source>
        <translation>Zuerst ein Objekt scannen oder einen Fall öffnen.</translation>
    </message>
    <message>
        <source>Scan another mount</source>
        <translation>Neu aufstellen und scannen</translation>
    </message>
    <message>
        <source>Standard uncertainty that is enough</source>
        <translation>Standardunsicherheit, die genügt</translation>
    </message>
    <message>
        <source>Uncertainty</source>
        <translation>Unsicherheit</translation>
    </message>
    <message>
        <source>Within</source>
        <translation>Innerhalb</translation>
    </message>
    <message>
        <source>{n} open, {mm2:.0f} mm² together</source>
        <translation>{n} offen, zusammen {mm2:.0f} mm²</translation>
    </message>
    <message>
        <source>{open}; {n} accepted</source>
        <translation>{open}; {n} angenommen</translation>
    </message>
</context>
<context>
    <name>CropShape</name>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>What is inside the box stays.</source>
        <translation>Was im Quader liegt, bleibt.</translation>
    </message>
    <message>
        <source>x from</source>
        <translation>x von</translation>
    </message>
    <message>
        <source>x to</source>
        <translation>x bis</translation>
    </message>
    <message>
        <source>y from</source>
        <translation>y von</translation>
    </message>
    <message>
        <source>y to</source>
        <translation>y bis</translation>
    </message>
    <message>
        <source>z from</source>
        <translation>z von</translation>
    </message>
    <message>
        <source>z to</source>
        <translation>z bis</translation>
    </message>
</context>
<context>
    <name>DeliverPage</name>
    <message>
        <source>All {passed} checks passed.</source>
        <translation>Alle {passed} Prüfungen bestanden.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Prüfen</translation>
    </message>
    <message>
        <source>Checking…</source>
        <translation>Prüfung läuft…</translation>
    </message>
    <message>
        <source>Closed, and free of self-intersections</source>
        <translation>Geschlossen und ohne Selbstdurchdringung</translation>
    </message>
    <message>
        <source>Deliver</source>
        <translation>Ausliefern</translation>
    </message>
    <message>
        <source>Deliver anyway</source>
        <translation>Trotzdem ausliefern</translation>
    </message>
    <message>
        <source>Deliver it although it is not ready</source>
        <translation>Ausliefern, obwohl es nicht bereit ist</translation>
    </message>
    <message>
        <source>Deliver once more</source>
        <translation>Erneut ausliefern</translation>
    </message>
    <message>
        <source>Delivered</source>
        <translation>Ausgeliefert</translation>
    </message>
    <message>
        <source>Edit the profile</source>
        <translation>Profil bearbeiten</translation>
    </message>
    <message>
        <source>Edit…</source>
        <translation>Bearbeiten…</translation>
    </message>
    <message>
        <source>Failed: {failed}. Remarks: {remarks}. Passed: {passed}.</source>
        <translation>Nicht bestanden: {failed}. Hinweise: {remarks}. Bestanden: {passed}.</translation>
    </message>
    <message>
        <source>How it was measured</source>
        <translation>Wie gemessen wurde</translation>
    </message>
    <message>
        <source>In {folder}</source>
        <translation>In {folder}</translation>
    </message>
    <message>
        <source>Next order</source>
        <translation>Nächster Auftrag</translation>
    </message>
    <message>
        <source>No surface yet</source>
        <translation>Noch keine Oberfläche</translation>
    </message>
    <message>
        <source>Not checked</source>
        <translation>Nicht geprüft</translation>
    </message>
    <message>
        <source>Open an order or begin one, then scan and reconstruct it.</source>
        <translation>Einen Auftrag öffnen oder anlegen, dann scannen und rekonstruieren.</translation>
    </message>
    <message>
        <source>Open folder</source>
        <translation>Ordner öffnen</translation>
    </message>
    <message>
        <source>Orders</source>
        <translation>Aufträge</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Reconstruct</source>
        <translation>Rekonstruieren</translation>
    </message>
    <message>
        <source>Reconstruct first</source>
        <translation>Zuerst rekonstruieren</translation>
    </message>
    <message>
        <source>Remarks: {remarks}. Passed: {passed}.</source>
        <translation>Hinweise: {remarks}. Bestanden: {passed}.</translation>
    </message>
    <message>
        <source>Replace the existing files</source>
        <translation>Vorhandene Dateien ersetzen</translation>
    </message>
    <message>
        <source>The certificate says so, in words and in its JSON.</source>
        <translation>Der Prüfbericht sagt es, in Worten und in seinem JSON.</translation>
    </message>
    <message>
        <source>The check was cancelled.</source>
        <translation>Die Prüfung wurde abgebrochen.</translation>
    </message>
    <message>
        <source>There is no surface to deliver yet.</source>
        <translation>Es gibt noch keine Oberfläche zum Ausliefern.</translation>
    </message>
    <message>
        <source>These files exist already. With {rev} in the name every delivery gets its own number.</source>
        <translation>Diese Dateien gibt es schon. Mit {rev} im Namen erhält jede Lieferung ihre eigene Nummer.</translation>
    </message>
    <message>
        <source>Whether it mirrors the other ear</source>
        <translation>Ob es das andere Ohr spiegelt</translation>
    </message>
    <message>
        <source>Written to {folder}</source>
        <translation>Geschrieben nach {folder}</translation>
    </message>
    <message>
        <source>{counted}
Delivered before, on {day}: {name}</source>
        <translation>{counted}
Zuvor ausgeliefert am {day}: {name}</translation>
    </message>
    <message>
        <source>{place}, with {others}</source>
        <translation>{place}, mit {others}</translation>
    </message>
    <message>
        <source>{written}, with {others}</source>
        <translation>{written}, mit {others}</translation>
    </message>
</context>
<context>
    <name>DeviationLegend</name>
    <message>
        <source>after against before, mm</source>
        <translation>nachher gegen vorher, mm</translation>
    </message>
    <message>
        <source>no counterpart</source>
        <translation>kein Gegenstück</translation>
    </message>
    <message>
        <source>outward +</source>
        <translation>nach außen +</translation>
    </message>
    <message>
        <source>within ±{mm} mm: not detectable</source>
        <translation>innerhalb ±{mm} mm: nicht nachweisbar</translation>
    </message>
    <message>
        <source>±{mm} mm</source>
        <translation>±{mm} mm</translation>
    </message>
    <message>
        <source>− inward</source>
        <translation>− nach innen</translation>
    </message>
</context>
<context>
    <name>DeviceList</name>
    <message>
        <source>Camera left</source>
        <translation>Kamera links</translation>
    </message>
    <message>
        <source>Camera right</source>
        <translation>Kamera rechts</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>Steuerung</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>Geräte</translation>
    </message>
    <message>
        <source>Ends the alarm; nothing moves, and the position may be lost</source>
        <translation>Beendet den Alarm; nichts bewegt sich, und die Position kann verloren sein</translation>
    </message>
    <message>
        <source>Find reference</source>
        <translation>Referenz suchen</translation>
    </message>
    <message>
        <source>It is opened again by itself when it is back.</source>
        <translation>Es wird von selbst wieder geöffnet, sobald es zurück ist.</translation>
    </message>
    <message>
        <source>Laser</source>
        <translation>Laser</translation>
    </message>
    <message>
        <source>Take it off the list</source>
        <translation>Aus der Liste nehmen</translation>
    </message>
    <message>
        <source>The axes move until they find their switches; nobody may reach into the rig</source>
        <translation>Die Achsen fahren, bis sie ihre Schalter finden; niemand darf in den Messplatz greifen</translation>
    </message>
    <message>
        <source>The last 200 lines to and from the controller</source>
        <translation>Die letzten 200 Zeilen von und zur Steuerung</translation>
    </message>
    <message>
        <source>Transcript…</source>
        <translation>Mitschrift…</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Noch einmal</translation>
    </message>
    <message>
        <source>Turntable</source>
        <translation>Drehteller</translation>
    </message>
    <message>
        <source>Unlock</source>
        <translation>Entriegeln</translation>
    </message>
    <message>
        <source>alarm</source>
        <translation>Alarm</translation>
    </message>
    <message>
        <source>as the controller reports it</source>
        <translation>wie die Steuerung meldet</translation>
    </message>
    <message>
        <source>axes {letters}</source>
        <translation>Achsen {letters}</translation>
    </message>
    <message>
        <source>door open</source>
        <translation>Tür offen</translation>
    </message>
    <message>
        <source>emitting</source>
        <translation>leuchtet</translation>
    </message>
    <message>
        <source>finding its reference…</source>
        <translation>sucht seine Referenz…</translation>
    </message>
    <message>
        <source>free running</source>
        <translation>frei laufend</translation>
    </message>
    <message>
        <source>hardware trigger</source>
        <translation>Hardware-Trigger</translation>
    </message>
    <message>
        <source>held</source>
        <translation>gehalten</translation>
    </message>
    <message>
        <source>homing</source>
        <translation>Referenzfahrt</translation>
    </message>
    <message>
        <source>idle</source>
        <translation>ruht</translation>
    </message>
    <message>
        <source>laser mode off</source>
        <translation>Lasermodus aus</translation>
    </message>
    <message>
        <source>laser mode on</source>
        <translation>Lasermodus an</translation>
    </message>
    <message>
        <source>moving</source>
        <translation>fährt</translation>
    </message>
    <message>
        <source>not available</source>
        <translation>nicht verfügbar</translation>
    </message>
    <message>
        <source>not open</source>
        <translation>nicht offen</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>opening…</source>
        <translation>wird geöffnet…</translation>
    </message>
    <message>
        <source>position unknown: find the reference</source>
        <translation>Position unbekannt: Referenz suchen</translation>
    </message>
    <message>
        <source>ready</source>
        <translation>bereit</translation>
    </message>
    <message>
        <source>ready, not as asked</source>
        <translation>bereit, nicht wie verlangt</translation>
    </message>
    <message>
        <source>software trigger</source>
        <translation>Software-Trigger</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>gestoppt</translation>
    </message>
    <message>
        <source>take it for lit: the controller reports nothing</source>
        <translation>als leuchtend ansehen: Die Steuerung meldet nichts</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
</context>
<context>
    <name>DistanceChart</name>
    <message>
        <source>95 % {length}</source>
        <translation>95 % {length}</translation>
    </message>
    <message>
        <source>Distance of the points from the surface</source>
        <translation>Abstand der Punkte zur Oberfläche</translation>
    </message>
    <message>
        <source>Half of the points are nearer to the surface than the first mark, 95 of 100 nearer than the second.</source>
        <translation>Die Hälfte der Punkte liegt näher an der Oberfläche als die erste Marke, 95 von 100 näher als die zweite.</translation>
    </message>
    <message>
        <source>Half of the points are within {median} of the surface, 95 of 100 within {p95}.</source>
        <translation>Die Hälfte der Punkte liegt innerhalb {median} zur Oberfläche, 95 von 100 innerhalb {p95}.</translation>
    </message>
    <message>
        <source>half {length}</source>
        <translation>Hälfte {length}</translation>
    </message>
</context>
<context>
    <name>DropTarget</name>
    <message>
        <source>Choose a file…</source>
        <translation>Datei wählen…</translation>
    </message>
    <message>
        <source>Drop a file here</source>
        <translation>Datei hierher ziehen</translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation>Wird gelesen…</translation>
    </message>
    <message>
        <source>Recent cases</source>
        <translation>Letzte Fälle</translation>
    </message>
    <message>
        <source>STL, PLY, OBJ, VTP, 3MF, or a case</source>
        <translation>STL, PLY, OBJ, VTP, 3MF oder ein Fall</translation>
    </message>
    <message>
        <source>The open case</source>
        <translation>Der offene Fall</translation>
    </message>
    <message>
        <source>{n} triangles</source>
        <translation>{n} Dreiecke</translation>
    </message>
</context>
<context>
    <name>EditPage</name>
    <message>
        <source>Edit</source>
        <translation>Bearbeiten</translation>
    </message>
    <message>
        <source>Go on to the surface</source>
        <translation>Weiter zur Oberfläche</translation>
    </message>
    <message>
        <source>Leave them in</source>
        <translation>Darin lassen</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Reading the points…</source>
        <translation>Punkte werden gelesen…</translation>
    </message>
    <message>
        <source>Reconstruct</source>
        <translation>Rekonstruieren</translation>
    </message>
    <message>
        <source>Scan an object or open a case first.</source>
        <translation>Zuerst ein Objekt scannen oder einen Fall öffnen.</translation>
    </message>
    <message>
        <source>Take out {n} points</source>
        <translation>{n} Punkte herausnehmen</translation>
    </message>
    <message>
        <source>The surface was made when other points were taken out. Reconstruct it again.</source>
        <translation>Als die Oberfläche entstand, waren andere Punkte herausgenommen. Neu rekonstruieren.</translation>
    </message>
    <message>
        <source>{n} points</source>
        <translation>{n} Punkte</translation>
    </message>
</context>
<context>
    <name>FaultPanel</name>
    <message>
        <source> s from now</source>
        <translation> s ab jetzt</translation>
    </message>
    <message>
        <source>Fault</source>
        <translation>Störung</translation>
    </message>
    <message>
        <source>Let it happen</source>
        <translation>Geschehen lassen</translation>
    </message>
    <message>
        <source>Let something go wrong…</source>
        <translation>Etwas schiefgehen lassen…</translation>
    </message>
    <message>
        <source>Opens the virtual rig anew</source>
        <translation>Öffnet den virtuellen Messplatz neu</translation>
    </message>
    <message>
        <source>Put everything right</source>
        <translation>Alles in Ordnung bringen</translation>
    </message>
    <message>
        <source>So far: {faults}</source>
        <translation>Bisher: {faults}</translation>
    </message>
    <message>
        <source>now</source>
        <translation>jetzt</translation>
    </message>
    <message>
        <source>{fault} in {n} s</source>
        <translation>{fault} in {n} s</translation>
    </message>
    <message>
        <source>{happens}. The program {expected}.</source>
        <translation>{happens}. Das Programm {expected}.</translation>
    </message>
    <message>
        <source>{n} before</source>
        <translation>{n} zuvor</translation>
    </message>
</context>
<context>
    <name>FileDialog</name>
    <message>
        <source>Replace it</source>
        <translation>Ersetzen</translation>
    </message>
    <message>
        <source>There is no such file:</source>
        <translation>Diese Datei gibt es nicht:</translation>
    </message>
    <message>
        <source>This file exists:</source>
        <translation>Diese Datei gibt es schon:</translation>
    </message>
</context>
<context>
    <name>FileNameLine</name>
    <message>
        <source>Both files would have one name: put {side} into the template.</source>
        <translation>Beide Dateien hießen gleich: {side} in die Vorlage setzen.</translation>
    </message>
    <message>
        <source>Change the file names…</source>
        <translation>Dateinamen ändern…</translation>
    </message>
    <message>
        <source>In braces: {fields}</source>
        <translation>In Klammern: {fields}</translation>
    </message>
    <message>
        <source>Template of the file names</source>
        <translation>Vorlage der Dateinamen</translation>
    </message>
    <message>
        <source>The patient code may stand in file names</source>
        <translation>Der Patientencode darf in Dateinamen stehen</translation>
    </message>
    <message>
        <source>There is no field {unknown}; the fields are {fields}.</source>
        <translation>Es gibt kein Feld {unknown}; die Felder sind {fields}.</translation>
    </message>
    <message>
        <source>{field} is left out: no patient in file names unless that is switched on below.</source>
        <translation>{field} fehlt: kein Patient in Dateinamen, außer es wird unten erlaubt.</translation>
    </message>
</context>
<context>
    <name>FindStep</name>
    <message>
        <source>Cameras</source>
        <translation>Kameras</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>Steuerung</translation>
    </message>
    <message>
        <source>Exchange left and right</source>
        <translation>Links und rechts tauschen</translation>
    </message>
    <message>
        <source>How both cameras are wanted</source>
        <translation>Wie beide Kameras gewünscht sind</translation>
    </message>
    <message>
        <source>Left and right as seen from behind the cameras. Wave a hand before one: its picture moves.</source>
        <translation>Links und rechts, von hinter den Kameras gesehen. Eine Hand vor eine halten: Ihr Bild bewegt sich.</translation>
    </message>
    <message>
        <source>Looking…</source>
        <translation>Suche…</translation>
    </message>
    <message>
        <source>No camera was found on this machine. Plug both cameras in, each into a USB port of its own, and look again.</source>
        <translation>An diesem Rechner wurde keine Kamera gefunden. Beide Kameras einstecken, jede an ihren eigenen USB-Anschluss, und neu suchen.</translation>
    </message>
    <message>
        <source>No serial port was found on this machine. Plug the controller in by USB, switch it on, and look again.</source>
        <translation>An diesem Rechner wurde kein serieller Anschluss gefunden. Die Steuerung per USB einstecken, einschalten und neu suchen.</translation>
    </message>
    <message>
        <source>None of these ports can move the rig: see what each of them says.</source>
        <translation>Keiner dieser Anschlüsse kann den Messplatz bewegen: ansehen, was jeder meldet.</translation>
    </message>
    <message>
        <source>Plug both cameras in, each into a USB port of its own and not into a common hub.</source>
        <translation>Beide Kameras einstecken, jede an ihren eigenen USB-Anschluss, nicht an einen gemeinsamen Hub.</translation>
    </message>
    <message>
        <source>Plug the controller of laser and turntable in by USB, and switch it on.</source>
        <translation>Die Steuerung von Laser und Drehteller per USB einstecken und einschalten.</translation>
    </message>
    <message>
        <source>Take the lens caps off, and close other programs that use the cameras or the port.</source>
        <translation>Objektivdeckel abnehmen und andere Programme schließen, die Kameras oder Anschluss benutzen.</translation>
    </message>
    <message>
        <source>The rig needs two cameras that give pictures: see what each of them says.</source>
        <translation>Der Messplatz braucht zwei Kameras, die Bilder liefern: ansehen, was jede meldet.</translation>
    </message>
    <message>
        <source>Then look for devices, below. Without any, everything here can be tried on the virtual rig, which is always found.</source>
        <translation>Dann unten nach Geräten suchen. Ohne Geräte lässt sich hier alles am virtuellen Messplatz ausprobieren, der immer gefunden wird.</translation>
    </message>
    <message>
        <source>Try it on the virtual rig</source>
        <translation>Am virtuellen Messplatz probieren</translation>
    </message>
    <message>
        <source>What is plugged in?</source>
        <translation>Was ist eingesteckt?</translation>
    </message>
</context>
<context>
    <name>FindingsPanel</name>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>95 % below</source>
        <translation>95 % unter</translation>
    </message>
    <message>
        <source>99 % below</source>
        <translation>99 % unter</translation>
    </message>
    <message>
        <source>Above {n} mm</source>
        <translation>Über {n} mm</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Areas</source>
        <translation>Flächen</translation>
    </message>
    <message>
        <source>Click it: the mark grows to its edge, and its motion is told</source>
        <translation>Anklicken: Die Marke wächst bis zu seinem Rand, und seine Bewegung wird genannt</translation>
    </message>
    <message>
        <source>Detection level here</source>
        <translation>Nachweisgrenze hier</translation>
    </message>
    <message>
        <source>Detection level of the rig</source>
        <translation>Nachweisgrenze des Messplatzes</translation>
    </message>
    <message>
        <source>From which change on it matters: the line on the map</source>
        <translation>Ab welcher Änderung es zählt: die Linie auf der Karte</translation>
    </message>
    <message>
        <source>Greatest</source>
        <translation>Größte</translation>
    </message>
    <message>
        <source>Half below</source>
        <translation>Hälfte unter</translation>
    </message>
    <message>
        <source>Hausdorff of counterparts, after to before</source>
        <translation>Hausdorff der Gegenstücke, nachher zu vorher</translation>
    </message>
    <message>
        <source>Hausdorff of counterparts, before to after</source>
        <translation>Hausdorff der Gegenstücke, vorher zu nachher</translation>
    </message>
    <message>
        <source>Mark a tooth</source>
        <translation>Zahn markieren</translation>
    </message>
    <message>
        <source>Mean, signed</source>
        <translation>Mittel, vorzeichenbehaftet</translation>
    </message>
    <message>
        <source>No area of {area} mm² or more differs by more than {n} mm (smoothed). The map shows smaller differences.</source>
        <translation>Keine Fläche von {area} mm² oder mehr weicht um mehr als {n} mm ab (geglättet). Die Karte zeigt kleinere Unterschiede.</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>Zahlen</translation>
    </message>
    <message>
        <source>Remove the mark</source>
        <translation>Marke entfernen</translation>
    </message>
    <message>
        <source>Take off</source>
        <translation>Wegnehmen</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>Schwelle</translation>
    </message>
    <message>
        <source>Which jaw?</source>
        <translation>Welcher Kiefer?</translation>
    </message>
    <message>
        <source>Without counterpart</source>
        <translation>Ohne Gegenstück</translation>
    </message>
    <message>
        <source>areas</source>
        <translation>Flächen</translation>
    </message>
    <message>
        <source>mm detectable</source>
        <translation>mm nachweisbar</translation>
    </message>
    <message>
        <source>mm² above threshold</source>
        <translation>mm² über Schwelle</translation>
    </message>
    <message>
        <source>mm² above {n} mm</source>
        <translation>mm² über {n} mm</translation>
    </message>
    <message>
        <source>rms</source>
        <translation>rms</translation>
    </message>
    <message>
        <source>{n} %</source>
        <translation>{n} %</translation>
    </message>
    <message>
        <source>{n} mm</source>
        <translation>{n} mm</translation>
    </message>
    <message>
        <source>{n} mm²</source>
        <translation>{n} mm²</translation>
    </message>
</context>
<context>
    <name>HelpPanel</name>
    <message>
        <source>? shows all keys</source>
        <translation>? zeigt alle Tasten</translation>
    </message>
    <message>
        <source>Close the help</source>
        <translation>Hilfe schließen</translation>
    </message>
    <message>
        <source>Close the help (F1)</source>
        <translation>Hilfe schließen (F1)</translation>
    </message>
    <message>
        <source>Go to a control with Tab: what it does is said here.</source>
        <translation>Mit Tab zu einem Bedienelement gehen: Was es tut, steht dann hier.</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>What is this?</source>
        <translation>Was ist das?</translation>
    </message>
    <message>
        <source>What the numbers mean</source>
        <translation>Was die Zahlen bedeuten</translation>
    </message>
    <message>
        <source>What this page is for</source>
        <translation>Wozu diese Seite da ist</translation>
    </message>
    <message>
        <source>What to do now</source>
        <translation>Was jetzt zu tun ist</translation>
    </message>
</context>
<context>
    <name>HomePage</name>
    <message>
        <source>A scan is running.</source>
        <translation>Ein Scan läuft.</translation>
    </message>
    <message>
        <source>A scan is running: the order can wait in the list.</source>
        <translation>Ein Scan läuft: Der Auftrag kann in der Liste warten.</translation>
    </message>
    <message>
        <source>Del; the file is moved, never deleted</source>
        <translation>Entf; die Datei wird verschoben, nie gelöscht</translation>
    </message>
    <message>
        <source>Enter makes a new order {number}.</source>
        <translation>Eingabe legt den neuen Auftrag {number} an.</translation>
    </message>
    <message>
        <source>Enter opens the order of that number, or begins a new one.</source>
        <translation>Eingabe öffnet den Auftrag mit dieser Nummer oder legt einen neuen an.</translation>
    </message>
    <message>
        <source>Enter opens {order}.</source>
        <translation>Eingabe öffnet {order}.</translation>
    </message>
    <message>
        <source>Enter, or a double click</source>
        <translation>Eingabe oder Doppelklick</translation>
    </message>
    <message>
        <source>Looking…</source>
        <translation>Suche…</translation>
    </message>
    <message>
        <source>No order has that in it.</source>
        <translation>Kein Auftrag enthält das.</translation>
    </message>
    <message>
        <source>No orders yet. They stand here as soon as they are entered.</source>
        <translation>Noch keine Aufträge. Sie stehen hier, sobald sie erfasst sind.</translation>
    </message>
    <message>
        <source>Open another case…</source>
        <translation>Anderen Fall öffnen…</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>The surface of this order is being made.</source>
        <translation>Die Oberfläche dieses Auftrags entsteht gerade.</translation>
    </message>
    <message>
        <source>This order is being scanned.</source>
        <translation>Dieser Auftrag wird gerade gescannt.</translation>
    </message>
    <message>
        <source>Wait for it, or cancel it on the Reconstruct page.</source>
        <translation>Darauf warten oder auf der Seite Rekonstruieren abbrechen.</translation>
    </message>
    <message>
        <source>Wait for its end or stop it first (Esc).</source>
        <translation>Das Ende abwarten oder zuerst stoppen (Esc).</translation>
    </message>
    <message>
        <source>{n} orders, the newest first. Arrow down goes into the list.</source>
        <translation>{n} Aufträge, der neueste zuerst. Pfeil nach unten führt in die Liste.</translation>
    </message>
</context>
<context>
    <name>HomeStart</name>
    <message>
        <source>A scan is running.</source>
        <translation>Ein Scan läuft.</translation>
    </message>
    <message>
        <source>An ear on the virtual rig: nothing has to be connected, and nothing is overwritten</source>
        <translation>Ein Ohr am virtuellen Messplatz: Nichts muss angeschlossen sein, und nichts wird überschrieben</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Ändern</translation>
    </message>
    <message>
        <source>Change the order</source>
        <translation>Auftrag ändern</translation>
    </message>
    <message>
        <source>Left and right: two cases with one order number</source>
        <translation>Links und rechts: zwei Fälle mit einer Auftragsnummer</translation>
    </message>
    <message>
        <source>New dental model</source>
        <translation>Neues Dentalmodell</translation>
    </message>
    <message>
        <source>New ear impression</source>
        <translation>Neue Ohrabformung</translation>
    </message>
    <message>
        <source>New ear pair</source>
        <translation>Neues Ohrpaar</translation>
    </message>
    <message>
        <source>Open now</source>
        <translation>Jetzt offen</translation>
    </message>
    <message>
        <source>Rig</source>
        <translation>Messplatz</translation>
    </message>
    <message>
        <source>Try a demo order</source>
        <translation>Demo-Auftrag ausprobieren</translation>
    </message>
    <message>
        <source>{rig}, virtual; on the table: {specimen}</source>
        <translation>{rig}, virtuell; auf dem Teller: {specimen}</translation>
    </message>
</context>
<context>
    <name>InterruptedStrip</name>
    <message>
        <source>A fault ended it.</source>
        <translation>Eine Störung beendete ihn.</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Keep what is there</source>
        <translation>Vorhandenes behalten</translation>
    </message>
    <message>
        <source>Leave it out of the case; nothing is deleted.</source>
        <translation>Nicht in den Fall nehmen; nichts wird gelöscht.</translation>
    </message>
    <message>
        <source>Nothing was deleted.</source>
        <translation>Nichts wurde gelöscht.</translation>
    </message>
    <message>
        <source>Put the same object back: known points are measured again, and only what is missing is scanned.</source>
        <translation>Dasselbe Objekt zurückstellen: Bekannte Punkte werden noch einmal gemessen, und nur das Fehlende wird gescannt.</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>Fortsetzen</translation>
    </message>
    <message>
        <source>Take what was measured for the whole, and open the case.</source>
        <translation>Das Gemessene als Ganzes nehmen und den Fall öffnen.</translation>
    </message>
    <message>
        <source>The program ended in the middle of it.</source>
        <translation>Das Programm endete mittendrin.</translation>
    </message>
    <message>
        <source>The scan of {order} did not come to its end.</source>
        <translation>Der Scan von {order} kam nicht zu Ende.</translation>
    </message>
    <message>
        <source>The scan of {order} was discarded.</source>
        <translation>Der Scan von {order} wurde verworfen.</translation>
    </message>
    <message>
        <source>There are {n} more.</source>
        <translation>Es gibt {n} weitere.</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>{measured} of {wanted} points, {done} of {views} views complete; begun {when}.</source>
        <translation>{measured} von {wanted} Punkten, {done} von {views} Ansichten vollständig; begonnen {when}.</translation>
    </message>
</context>
<context>
    <name>JogPanel</name>
    <message>
        <source>Beam down</source>
        <translation>Strahl nach unten</translation>
    </message>
    <message>
        <source>Beam left</source>
        <translation>Strahl nach links</translation>
    </message>
    <message>
        <source>Beam right</source>
        <translation>Strahl nach rechts</translation>
    </message>
    <message>
        <source>Beam up</source>
        <translation>Strahl nach oben</translation>
    </message>
    <message>
        <source>By hand</source>
        <translation>Von Hand</translation>
    </message>
    <message>
        <source>Show the spot</source>
        <translation>Laserpunkt zeigen</translation>
    </message>
    <message>
        <source>Steps of {n} degrees</source>
        <translation>Schritte von {n} Grad</translation>
    </message>
    <message>
        <source>Stop moving</source>
        <translation>Bewegung stoppen</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Teller</translation>
    </message>
    <message>
        <source>Table clockwise</source>
        <translation>Teller im Uhrzeigersinn</translation>
    </message>
    <message>
        <source>Table counter-clockwise</source>
        <translation>Teller gegen den Uhrzeigersinn</translation>
    </message>
</context>
<context>
    <name>Legend</name>
    <message>
        <source>Age</source>
        <translation>Alter</translation>
    </message>
    <message>
        <source>Colours: {name}, {low} to {high}</source>
        <translation>Farben: {name}, {low} bis {high}</translation>
    </message>
    <message>
        <source>Density, points/mm²</source>
        <translation>Dichte, Punkte/mm²</translation>
    </message>
    <message>
        <source>Epipolar residual, σ</source>
        <translation>Epipolarfehler, σ</translation>
    </message>
    <message>
        <source>Height, mm</source>
        <translation>Höhe, mm</translation>
    </message>
    <message>
        <source>Points by</source>
        <translation>Punkte nach</translation>
    </message>
    <message>
        <source>Standard uncertainty, µm</source>
        <translation>Standardunsicherheit, µm</translation>
    </message>
    <message>
        <source>Support by points</source>
        <translation>Von Punkten belegt</translation>
    </message>
    <message>
        <source>Surface by</source>
        <translation>Oberfläche nach</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>What the colours mean; click to choose  (K: the next one)</source>
        <translation>Was die Farben bedeuten; Klick zum Wählen  (K: die nächste)</translation>
    </message>
    <message>
        <source>filled in</source>
        <translation>überbrückt</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>gemessen</translation>
    </message>
    <message>
        <source>newest</source>
        <translation>neueste</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>oldest</source>
        <translation>älteste</translation>
    </message>
    <message>
        <source>{n} and more</source>
        <translation>{n} und mehr</translation>
    </message>
    <message>
        <source>{n} s ago</source>
        <translation>vor {n} s</translation>
    </message>
</context>
<context>
    <name>LiveSurface</name>
    <message>
        <source>No surface yet: some parts are too thin so far</source>
        <translation>Noch keine Oberfläche: Manche Teile sind bisher zu dünn belegt</translation>
    </message>
    <message>
        <source>No surface yet: the body has a hole right through it</source>
        <translation>Noch keine Oberfläche: Der Körper hat ein Loch, das hindurchgeht</translation>
    </message>
    <message>
        <source>No surface yet: the points make no body</source>
        <translation>Noch keine Oberfläche: Die Punkte ergeben keinen Körper</translation>
    </message>
    <message>
        <source>No surface yet: too few points</source>
        <translation>Noch keine Oberfläche: zu wenige Punkte</translation>
    </message>
    <message>
        <source>Surface so far: {share} % scanned, its base included; nets are holes</source>
        <translation>Oberfläche bisher: {share} % gescannt, Standfläche mitgezählt; Netze sind Lücken</translation>
    </message>
    <message>
        <source>The live surface has ended; the scan goes on without it.</source>
        <translation>Die Live-Oberfläche ist beendet; der Scan geht ohne sie weiter.</translation>
    </message>
</context>
<context>
    <name>MainWindow</name>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>A scan is running.</source>
        <translation>Ein Scan läuft.</translation>
    </message>
    <message>
        <source>Both ears are measured: {left} points on the left one, {right} on the right one.</source>
        <translation>Beide Ohren sind gemessen: {left} Punkte auf dem linken, {right} auf dem rechten.</translation>
    </message>
    <message>
        <source>Cases (*.impronta)</source>
        <translation>Fälle (*.impronta)</translation>
    </message>
    <message>
        <source>Each is an order of its own now; both stand in the worklist.</source>
        <translation>Jedes ist jetzt ein eigener Auftrag; beide stehen in der Arbeitsliste.</translation>
    </message>
    <message>
        <source>It is kept in its case.</source>
        <translation>Sie ist in ihrem Fall gesichert.</translation>
    </message>
    <message>
        <source>Open a case</source>
        <translation>Fall öffnen</translation>
    </message>
    <message>
        <source>Open it</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>The surface of {case} is done.</source>
        <translation>Die Oberfläche von {case} ist fertig.</translation>
    </message>
    <message>
        <source>Wait for its end or stop it first (Esc).</source>
        <translation>Das Ende abwarten oder zuerst stoppen (Esc).</translation>
    </message>
</context>
<context>
    <name>MeasurePanel</name>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Across x</source>
        <translation>Quer zu x</translation>
    </message>
    <message>
        <source>Across y</source>
        <translation>Quer zu y</translation>
    </message>
    <message>
        <source>Canal</source>
        <translation>Gehörgang</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Click a place, or move the plane.</source>
        <translation>Eine Stelle anklicken oder die Ebene verschieben.</translation>
    </message>
    <message>
        <source>Click the second place.</source>
        <translation>Die zweite Stelle anklicken.</translation>
    </message>
    <message>
        <source>Click two places on the surface.</source>
        <translation>Zwei Stellen auf der Oberfläche anklicken.</translation>
    </message>
    <message>
        <source>Click two points. Sections, canal and volume are measured on the surface: reconstruct it first.</source>
        <translation>Zwei Punkte anklicken. Schnitte, Gehörgang und Volumen werden an der Oberfläche gemessen: Zuerst rekonstruieren.</translation>
    </message>
    <message>
        <source>Copy as text</source>
        <translation>Als Text kopieren</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>From the highest point, or click the tip of the canal.</source>
        <translation>Vom höchsten Punkt, oder die Gehörgangspitze anklicken.</translation>
    </message>
    <message>
        <source>Keep this section</source>
        <translation>Diesen Schnitt behalten</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Waagrecht</translation>
    </message>
    <message>
        <source>Measure the canal</source>
        <translation>Gehörgang messen</translation>
    </message>
    <message>
        <source>Measure the volume</source>
        <translation>Volumen messen</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Gemessen</translation>
    </message>
    <message>
        <source>Measuring…</source>
        <translation>Misst…</translation>
    </message>
    <message>
        <source>No canal was found there. Click the tip of the canal on the surface.</source>
        <translation>Dort wurde kein Gehörgang gefunden. Die Gehörgangspitze auf der Oberfläche anklicken.</translation>
    </message>
    <message>
        <source>Nothing yet.</source>
        <translation>Noch nichts.</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Lage</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove measurement {n}</source>
        <translation>Messung {n} entfernen</translation>
    </message>
    <message>
        <source>Scan an object or open a case first.</source>
        <translation>Zuerst ein Objekt scannen oder einen Fall öffnen.</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>The surface is not closed, so it encloses no volume.</source>
        <translation>Die Oberfläche ist nicht geschlossen, sie umschließt also kein Volumen.</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>What the closed surface encloses.</source>
        <translation>Was die geschlossene Oberfläche umschließt.</translation>
    </message>
    <message>
        <source>mm perimeter</source>
        <translation>mm Umfang</translation>
    </message>
    <message>
        <source>mm² area</source>
        <translation>mm² Fläche</translation>
    </message>
    <message>
        <source>{told}. Of another surface than the one that is shown.</source>
        <translation>{told}. Von einer anderen Oberfläche als der gezeigten.</translation>
    </message>
</context>
<context>
    <name>MountsPage</name>
    <message>
        <source>1  Set the object down anew</source>
        <translation>1  Das Objekt neu aufstellen</translation>
    </message>
    <message>
        <source>2  Scan it into the same case</source>
        <translation>2  In denselben Fall scannen</translation>
    </message>
    <message>
        <source>Another mount</source>
        <translation>Neue Aufstellung</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>How the mounts lie</source>
        <translation>Wie die Aufstellungen liegen</translation>
    </message>
    <message>
        <source>Leave about half of what was scanned in sight, near the middle of the table, and see that nothing wobbles.</source>
        <translation>Etwa die Hälfte des Gescannten sichtbar lassen, nahe der Tellermitte, und darauf achten, dass nichts wackelt.</translation>
    </message>
    <message>
        <source>Look again how they lie</source>
        <translation>Lage noch einmal suchen</translation>
    </message>
    <message>
        <source>Looking how the mounts lie on each other…</source>
        <translation>Gesucht wird, wie die Aufstellungen aufeinander liegen…</translation>
    </message>
    <message>
        <source>Nothing is lost: all points are kept in the case.</source>
        <translation>Nichts ist verloren: Alle Punkte sind im Fall gesichert.</translation>
    </message>
    <message>
        <source>Pick three points</source>
        <translation>Drei Punkte wählen</translation>
    </message>
    <message>
        <source>Reconstruct</source>
        <translation>Rekonstruieren</translation>
    </message>
    <message>
        <source>Registration</source>
        <translation>Registrierung</translation>
    </message>
    <message>
        <source>Scan another mount</source>
        <translation>Neu aufstellen und scannen</translation>
    </message>
    <message>
        <source>Scan this mount</source>
        <translation>Diese Aufstellung scannen</translation>
    </message>
    <message>
        <source>The points of the earlier mounts stay (Shift+F9)</source>
        <translation>Die Punkte der früheren Aufstellungen bleiben (Umschalt+F9)</translation>
    </message>
    <message>
        <source>Tip it by 60 to 90° or turn it over, so that what was hidden comes into view.</source>
        <translation>Um 60 bis 90° kippen oder umdrehen, damit Verdecktes sichtbar wird.</translation>
    </message>
    <message>
        <source>Tip the virtual object</source>
        <translation>Virtuelles Objekt kippen</translation>
    </message>
</context>
<context>
    <name>OrderForm</name>
    <message>
        <source>Another order has this number and side too; both are kept.</source>
        <translation>Ein anderer Auftrag hat dieselbe Nummer und Seite; beide bleiben erhalten.</translation>
    </message>
    <message>
        <source>Back to the list</source>
        <translation>Zurück zur Liste</translation>
    </message>
    <message>
        <source>Ctrl+Enter</source>
        <translation>Strg+Eingabe</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Every change is kept in the case, and can be undone.</source>
        <translation>Jede Änderung wird im Fall gesichert und lässt sich rückgängig machen.</translation>
    </message>
    <message>
        <source>File names</source>
        <translation>Dateinamen</translation>
    </message>
    <message>
        <source>Keep it in the list</source>
        <translation>In der Liste lassen</translation>
    </message>
    <message>
        <source>Make both orders, scan the first</source>
        <translation>Beide Aufträge anlegen, ersten scannen</translation>
    </message>
    <message>
        <source>Make the order and scan</source>
        <translation>Auftrag anlegen und scannen</translation>
    </message>
    <message>
        <source>New order</source>
        <translation>Neuer Auftrag</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Auftrag</translation>
    </message>
    <message>
        <source>Order number</source>
        <translation>Auftragsnummer</translation>
    </message>
    <message>
        <source>Patient code</source>
        <translation>Patientencode</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>The order has no number yet.</source>
        <translation>Der Auftrag hat noch keine Nummer.</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Typ</translation>
    </message>
    <message>
        <source>Which jaw is it?</source>
        <translation>Welcher Kiefer ist es?</translation>
    </message>
    <message>
        <source>Which side is it?</source>
        <translation>Welche Seite ist es?</translation>
    </message>
    <message>
        <source>a code, not the name</source>
        <translation>ein Code, nicht der Name</translation>
    </message>
    <message>
        <source>as on the order form</source>
        <translation>wie auf dem Auftragsschein</translation>
    </message>
</context>
<context>
    <name>OrderList</name>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Orders</source>
        <translation>Aufträge</translation>
    </message>
    <message>
        <source>Remove from the list</source>
        <translation>Aus der Liste entfernen</translation>
    </message>
</context>
<context>
    <name>OutlierShape</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>How many times the usual distance to its neighbours a point may lie off them</source>
        <translation>Um das Wievielfache des üblichen Abstands zu seinen Nachbarn ein Punkt neben ihnen liegen darf</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>Grenze</translation>
    </message>
    <message>
        <source>Looking at every point</source>
        <translation>Alle Punkte werden geprüft</translation>
    </message>
    <message>
        <source>Points that are far from their neighbours, off their surface, or in a small group of their own.</source>
        <translation>Punkte weit weg von ihren Nachbarn, neben deren Oberfläche oder in einer kleinen Gruppe für sich.</translation>
    </message>
</context>
<context>
    <name>PickPage</name>
    <message>
        <source>All mounts lie together; there is nothing to pick.</source>
        <translation>Alle Aufstellungen liegen aufeinander; es gibt nichts zu wählen.</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Click place {n} of three on the left, then the same place on the right; far from each other and easy to tell.</source>
        <translation>Links die Stelle {n} von drei anklicken, dann dieselbe rechts; weit voneinander und leicht zu erkennen.</translation>
    </message>
    <message>
        <source>It did not fit from these points. Take the last one back, or start again with places that you are sure of.</source>
        <translation>Von diesen Punkten aus passte es nicht. Den letzten zurücknehmen oder mit sicheren Stellen neu beginnen.</translation>
    </message>
    <message>
        <source>Looking whether the mounts fit from there…</source>
        <translation>Prüft, ob die Aufstellungen von dort aus passen…</translation>
    </message>
    <message>
        <source>Now click the same place {n} on the right.</source>
        <translation>Jetzt dieselbe Stelle {n} rechts anklicken.</translation>
    </message>
    <message>
        <source>Pick three points</source>
        <translation>Drei Punkte wählen</translation>
    </message>
    <message>
        <source>Points of the mount to be joined</source>
        <translation>Punkte der Aufstellung, die hinzukommen soll</translation>
    </message>
    <message>
        <source>Points of the mounts that lie together</source>
        <translation>Punkte der Aufstellungen, die aufeinander liegen</translation>
    </message>
    <message>
        <source>Preparing the 3D view…</source>
        <translation>3D-Ansicht wird vorbereitet…</translation>
    </message>
    <message>
        <source>Start again</source>
        <translation>Neu beginnen</translation>
    </message>
    <message>
        <source>Take the last point back (Ctrl+Z)</source>
        <translation>Letzten Punkt zurücknehmen (Strg+Z)</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Where it is known</source>
        <translation>Wo es bekannt ist</translation>
    </message>
</context>
<context>
    <name>PickView</name>
    <message>
        <source>Turn it with the arrow keys, come nearer with plus and minus, pick the point in the middle with the space bar.</source>
        <translation>Mit den Pfeiltasten drehen, mit Plus und Minus nähern, den Punkt in der Mitte mit der Leertaste wählen.</translation>
    </message>
</context>
<context>
    <name>PlaceEntry</name>
    <message>
        <source>✓ Accepted as it is: {why}</source>
        <translation>✓ So angenommen: {why}</translation>
    </message>
</context>
<context>
    <name>PlaceList</name>
    <message>
        <source>Places that are not as certain as wanted</source>
        <translation>Stellen, die nicht so sicher sind wie gewünscht</translation>
    </message>
</context>
<context>
    <name>PlanBar</name>
    <message>
        <source>Plan: {done} of {count} views are done</source>
        <translation>Plan: {done} von {count} Ansichten sind fertig</translation>
    </message>
    <message>
        <source>View {number} at {angle:.0f}°: {state}</source>
        <translation>Ansicht {number} bei {angle:.0f}°: {state}</translation>
    </message>
    <message>
        <source>being measured</source>
        <translation>wird gemessen</translation>
    </message>
    <message>
        <source>done</source>
        <translation>fertig</translation>
    </message>
    <message>
        <source>far fewer points than its neighbours</source>
        <translation>weit weniger Punkte als ihre Nachbarn</translation>
    </message>
    <message>
        <source>to come</source>
        <translation>folgt</translation>
    </message>
    <message>
        <source>will be measured once more</source>
        <translation>wird noch einmal gemessen</translation>
    </message>
    <message>
        <source>{points} of {wanted} points, {rejected} rejected</source>
        <translation>{points} von {wanted} Punkten, {rejected} verworfen</translation>
    </message>
    <message>
        <source>{points} points, {rejected} rejected</source>
        <translation>{points} Punkte, {rejected} verworfen</translation>
    </message>
    <message>
        <source>{told}; measured twice</source>
        <translation>{told}; zweimal gemessen</translation>
    </message>
</context>
<context>
    <name>PointsPanel</name>
    <message>
        <source>Also what lies behind</source>
        <translation>Auch, was dahinter liegt</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Quader</translation>
    </message>
    <message>
        <source>Bring all back</source>
        <translation>Alle zurückholen</translation>
    </message>
    <message>
        <source>Bring points back instead</source>
        <translation>Stattdessen Punkte zurückholen</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>Pinsel</translation>
    </message>
    <message>
        <source>Crop</source>
        <translation>Zuschneiden</translation>
    </message>
    <message>
        <source>Cut the base</source>
        <translation>Basis abschneiden</translation>
    </message>
    <message>
        <source>Invert</source>
        <translation>Umkehren</translation>
    </message>
    <message>
        <source>Lasso</source>
        <translation>Lasso</translation>
    </message>
    <message>
        <source>Many at once</source>
        <translation>Viele auf einmal</translation>
    </message>
    <message>
        <source>On the picture</source>
        <translation>Im Bild</translation>
    </message>
    <message>
        <source>Otherwise only what is in front, as it is seen, is taken</source>
        <translation>Sonst wird nur genommen, was vorne zu sehen ist</translation>
    </message>
    <message>
        <source>Outliers</source>
        <translation>Ausreißer</translation>
    </message>
    <message>
        <source>Show what was taken out</source>
        <translation>Herausgenommenes zeigen</translation>
    </message>
    <message>
        <source>Take out what is left, and bring back what was taken out</source>
        <translation>Herausnehmen, was übrig ist, und zurückholen, was herausgenommen war</translation>
    </message>
    <message>
        <source>of {n} points taken out</source>
        <translation>von {n} Punkten herausgenommen</translation>
    </message>
</context>
<context>
    <name>PortLine</name>
    <message>
        <source>Part of the program: to try the assistant without devices.</source>
        <translation>Teil des Programms: um den Assistenten ohne Geräte zu erproben.</translation>
    </message>
    <message>
        <source>Virtual controller</source>
        <translation>Virtuelle Steuerung</translation>
    </message>
</context>
<context>
    <name>Preferences</name>
    <message>
        <source>reset of the settings</source>
        <translation>Zurücksetzen der Einstellungen</translation>
    </message>
</context>
<context>
    <name>ProcessingRows</name>
    <message>
        <source> σ</source>
        <translation> σ</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Kalibrierung</translation>
    </message>
    <message>
        <source>Epipolar gate</source>
        <translation>Epipolargrenze</translation>
    </message>
    <message>
        <source>How far the two cameras may disagree, in standard uncertainties; scanned with 3.</source>
        <translation>Wie weit die beiden Kameras abweichen dürfen, in Standardunsicherheiten; gescannt mit 3.</translation>
    </message>
    <message>
        <source>Points of darker spots are left out; the brightest pixel is 255.</source>
        <translation>Punkte aus dunkleren Lichtpunkten fallen weg; das hellste Pixel ist 255.</translation>
    </message>
    <message>
        <source>Spot peak</source>
        <translation>Lichtpunktspitze</translation>
    </message>
    <message>
        <source>as scanned</source>
        <translation>wie gescannt</translation>
    </message>
    <message>
        <source>of the rig now</source>
        <translation>des Messplatzes jetzt</translation>
    </message>
</context>
<context>
    <name>ProfilePanel</name>
    <message>
        <source>Certificate beside it (PDF and JSON)</source>
        <translation>Prüfbericht daneben (PDF und JSON)</translation>
    </message>
    <message>
        <source>Choose a folder</source>
        <translation>Ordner wählen</translation>
    </message>
    <message>
        <source>Copy as my own</source>
        <translation>Als eigenes kopieren</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Every change counts at once; Ctrl+Z takes it back.</source>
        <translation>Jede Änderung gilt sofort; Strg+Z nimmt sie zurück.</translation>
    </message>
    <message>
        <source>File name</source>
        <translation>Dateiname</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>Folder for exported files</source>
        <translation>Ordner für exportierte Dateien</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>In braces: {fields}</source>
        <translation>In Klammern: {fields}</translation>
    </message>
    <message>
        <source>Lies</source>
        <translation>Lage</translation>
    </message>
    <message>
        <source>Measured points beside it (XYZ)</source>
        <translation>Messpunkte daneben (XYZ)</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>This profile belongs to the program. Copy it to change it.</source>
        <translation>Dieses Profil gehört zum Programm. Zum Ändern kopieren.</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Without its base (open surface)</source>
        <translation>Ohne Basis (offene Oberfläche)</translation>
    </message>
</context>
<context>
    <name>Rail</name>
    <message>
        <source>Before: {before}
After: {after}</source>
        <translation>Vorher: {before}
Nachher: {after}</translation>
    </message>
    <message>
        <source>Esc, from every page</source>
        <translation>Esc, auf jeder Seite</translation>
    </message>
    <message>
        <source>Laser on · stop</source>
        <translation>Laser an · Stopp</translation>
    </message>
    <message>
        <source>No order number</source>
        <translation>Keine Auftragsnummer</translation>
    </message>
    <message>
        <source>No order open</source>
        <translation>Kein Auftrag offen</translation>
    </message>
    <message>
        <source>Stop · laser off</source>
        <translation>Stopp · Laser aus</translation>
    </message>
    <message>
        <source>Stop · laser?</source>
        <translation>Stopp · Laser?</translation>
    </message>
    <message>
        <source>Stops every movement and switches the laser off, from every page (Esc)</source>
        <translation>Stoppt jede Bewegung und schaltet den Laser aus, auf jeder Seite (Esc)</translation>
    </message>
    <message>
        <source>none yet</source>
        <translation>noch keine</translation>
    </message>
</context>
<context>
    <name>ReadyLine</name>
    <message>
        <source>Attention</source>
        <translation>Achtung</translation>
    </message>
    <message>
        <source>Checking</source>
        <translation>Prüfung</translation>
    </message>
    <message>
        <source>Not now</source>
        <translation>Nicht jetzt</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>Bereit</translation>
    </message>
</context>
<context>
    <name>ReconstructPage</name>
    <message>
        <source>% supported</source>
        <translation>% belegt</translation>
    </message>
    <message>
        <source>As many orders wait as can be kept in mind. Take one out, or wait for the next to begin.</source>
        <translation>Es warten so viele Aufträge, wie der Speicher fasst. Einen herausnehmen oder warten, bis der nächste beginnt.</translation>
    </message>
    <message>
        <source>Back to the result</source>
        <translation>Zurück zum Ergebnis</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Complete</source>
        <translation>Ergänzen</translation>
    </message>
    <message>
        <source>Compute the points anew…</source>
        <translation>Punkte neu berechnen…</translation>
    </message>
    <message>
        <source>Deliver</source>
        <translation>Ausliefern</translation>
    </message>
    <message>
        <source>Distance of the points from the surface</source>
        <translation>Abstand der Punkte zur Oberfläche</translation>
    </message>
    <message>
        <source>Finishes the surface as it is now: whole and closed, but coarser than the points allow.</source>
        <translation>Stellt die Oberfläche so fertig, wie sie ist: ganz und geschlossen, aber gröber, als die Punkte erlauben.</translation>
    </message>
    <message>
        <source>It waits</source>
        <translation>Wartet</translation>
    </message>
    <message>
        <source>Other settings…</source>
        <translation>Andere Einstellungen…</translation>
    </message>
    <message>
        <source>Places that are not as certain as wanted, why, and what can be done about them (F8)</source>
        <translation>Stellen, die nicht so sicher sind wie gewünscht, warum, und was dagegen hilft (F8)</translation>
    </message>
    <message>
        <source>Reconstruct</source>
        <translation>Rekonstruieren</translation>
    </message>
    <message>
        <source>Reconstruct again</source>
        <translation>Neu rekonstruieren</translation>
    </message>
    <message>
        <source>Reconstruct next</source>
        <translation>Als Nächstes</translation>
    </message>
    <message>
        <source>Scan first, or open a case with points.</source>
        <translation>Zuerst scannen oder einen Fall mit Punkten öffnen.</translation>
    </message>
    <message>
        <source>Share of the whole surface that rests on measured points, the base on which the object stood included; Deliver leaves the base out.</source>
        <translation>Anteil der ganzen Oberfläche, der von Messpunkten belegt ist, die Standfläche des Objekts mitgezählt; „Ausliefern“ lässt sie weg.</translation>
    </message>
    <message>
        <source>Stop here and keep</source>
        <translation>Hier beenden</translation>
    </message>
    <message>
        <source>The surface is kept in the case.</source>
        <translation>Die Oberfläche ist im Fall gesichert.</translation>
    </message>
    <message>
        <source>These points wait for their turn.</source>
        <translation>Diese Punkte warten, bis sie an der Reihe sind.</translation>
    </message>
    <message>
        <source>mm³ volume</source>
        <translation>mm³ Volumen</translation>
    </message>
    <message>
        <source>triangles</source>
        <translation>Dreiecke</translation>
    </message>
    <message>
        <source>{points} points are ready.</source>
        <translation>{points} Punkte sind bereit.</translation>
    </message>
    <message>
        <source>µm expected error</source>
        <translation>µm erwarteter Fehler</translation>
    </message>
</context>
<context>
    <name>ReconstructionPhases</name>
    <message>
        <source>Cancelling…</source>
        <translation>Wird abgebrochen…</translation>
    </message>
    <message>
        <source>Finishing what there is…</source>
        <translation>Vorhandenes wird fertiggestellt…</translation>
    </message>
    <message>
        <source>Looking at the points…</source>
        <translation>Punkte werden durchgesehen…</translation>
    </message>
    <message>
        <source>Progress of the reconstruction</source>
        <translation>Fortschritt der Rekonstruktion</translation>
    </message>
    <message>
        <source>Starting…</source>
        <translation>Beginnt…</translation>
    </message>
    <message>
        <source>{left} left</source>
        <translation>noch {left}</translation>
    </message>
</context>
<context>
    <name>ReconstructionWaiting</name>
    <message>
        <source>Waiting</source>
        <translation>Wartend</translation>
    </message>
</context>
<context>
    <name>ReconstructionWishes</name>
    <message>
        <source>Detail</source>
        <translation>Detailgrad</translation>
    </message>
    <message>
        <source>Expert…</source>
        <translation>Experte…</translation>
    </message>
    <message>
        <source>Hide expert settings</source>
        <translation>Experteneinstellungen ausblenden</translation>
    </message>
    <message>
        <source>The middle is the default: as many triangles as the points carry. Each step halves or doubles them.</source>
        <translation>Die Mitte ist die Vorgabe: so viele Dreiecke, wie die Punkte tragen. Jeder Schritt halbiert oder verdoppelt sie.</translation>
    </message>
    <message>
        <source>coarse</source>
        <translation>grob</translation>
    </message>
    <message>
        <source>default</source>
        <translation>Vorgabe</translation>
    </message>
    <message>
        <source>fine</source>
        <translation>fein</translation>
    </message>
</context>
<context>
    <name>RejectList</name>
    <message>
        <source>Rejected</source>
        <translation>Verworfen</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>other</source>
        <translation>andere</translation>
    </message>
    <message>
        <source>{count}  ·  {share} %</source>
        <translation>{count}  ·  {share} %</translation>
    </message>
</context>
<context>
    <name>Remarks</name>
    <message>
        <source>1 remark</source>
        <translation>1 Hinweis</translation>
    </message>
    <message>
        <source>{n} remarks</source>
        <translation>{n} Hinweise</translation>
    </message>
</context>
<context>
    <name>RemovedStrip</name>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>{order} was removed; its file is kept.</source>
        <translation>{order} wurde entfernt; die Datei bleibt erhalten.</translation>
    </message>
</context>
<context>
    <name>RigChoice</name>
    <message>
        <source>A mesh as specimen</source>
        <translation>Ein Netz als Prüfling</translation>
    </message>
    <message>
        <source>Mesh file…</source>
        <translation>Netzdatei…</translation>
    </message>
    <message>
        <source>Meshes (*.stl *.ply *.obj *.vtp *.3mf)</source>
        <translation>Netze (*.stl *.ply *.obj *.vtp *.3mf)</translation>
    </message>
    <message>
        <source>On the table</source>
        <translation>Auf dem Teller</translation>
    </message>
    <message>
        <source>Open a rig file</source>
        <translation>Messplatzdatei öffnen</translation>
    </message>
    <message>
        <source>Open a rig file (TOML); it can be dropped here, too</source>
        <translation>Eine Messplatzdatei (TOML) öffnen; sie kann auch hierher gezogen werden</translation>
    </message>
    <message>
        <source>Own rig…</source>
        <translation>Eigener…</translation>
    </message>
    <message>
        <source>Rig</source>
        <translation>Messplatz</translation>
    </message>
    <message>
        <source>Rig files (*.toml)</source>
        <translation>Messplatzdateien (*.toml)</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Tempo</translation>
    </message>
</context>
<context>
    <name>RigPage</name>
    <message>
        <source>Camera left</source>
        <translation>Kamera links</translation>
    </message>
    <message>
        <source>Camera right</source>
        <translation>Kamera rechts</translation>
    </message>
    <message>
        <source>Finds ports and cameras, checks them by what the cameras see, and writes a rig file</source>
        <translation>Findet Anschlüsse und Kameras, prüft sie an dem, was die Kameras sehen, und schreibt eine Messplatzdatei</translation>
    </message>
    <message>
        <source>Measure the sphere…</source>
        <translation>Kugel messen…</translation>
    </message>
    <message>
        <source>Set up a rig…</source>
        <translation>Messplatz einrichten…</translation>
    </message>
    <message>
        <source>Two cameras, a laser and a turntable, computed frame by frame; the rest is the real program.</source>
        <translation>Zwei Kameras, ein Laser und ein Drehteller, Bild für Bild berechnet; alles Übrige ist das echte Programm.</translation>
    </message>
    <message>
        <source>Virtual rig</source>
        <translation>Virtueller Messplatz</translation>
    </message>
    <message>
        <source>{rig} (virtual rig)</source>
        <translation>{rig} (virtueller Messplatz)</translation>
    </message>
</context>
<context>
    <name>ScanPage</name>
    <message>
        <source>  (and {count} more)</source>
        <translation>  (und {count} weitere)</translation>
    </message>
    <message>
        <source>1 place cannot be seen from this mount</source>
        <translation>1 Stelle ist in dieser Aufstellung nicht sichtbar</translation>
    </message>
    <message>
        <source>A fault: the laser is off</source>
        <translation>Störung: Der Laser ist aus</translation>
    </message>
    <message>
        <source>Another mount</source>
        <translation>Neue Aufstellung</translation>
    </message>
    <message>
        <source>Bringing the views together…</source>
        <translation>Ansichten werden zusammengeführt…</translation>
    </message>
    <message>
        <source>By how much the first view lay beside itself when it was measured again at the end of the turn</source>
        <translation>Um wie viel die erste Ansicht neben sich selbst lag, als sie am Ende der Drehung noch einmal gemessen wurde</translation>
    </message>
    <message>
        <source>Camera left</source>
        <translation>Kamera links</translation>
    </message>
    <message>
        <source>Camera right</source>
        <translation>Kamera rechts</translation>
    </message>
    <message>
        <source>Closing the turn: the first view is measured again and compared.</source>
        <translation>Drehung schließen: Die erste Ansicht wird noch einmal gemessen und verglichen.</translation>
    </message>
    <message>
        <source>Coarse pass: view {view} of {views}</source>
        <translation>Grober Durchgang: Ansicht {view} von {views}</translation>
    </message>
    <message>
        <source>Complete</source>
        <translation>Ergänzen</translation>
    </message>
    <message>
        <source>Computing where more points are needed…</source>
        <translation>Berechnet, wo mehr Punkte nötig sind…</translation>
    </message>
    <message>
        <source>Ended by a fault; what was measured is kept</source>
        <translation>Durch eine Störung beendet; das Gemessene ist gesichert</translation>
    </message>
    <message>
        <source>Finding the object, view {view} of {views}</source>
        <translation>Objekt wird gesucht, Ansicht {view} von {views}</translation>
    </message>
    <message>
        <source>How far off the surface may be (standard uncertainty). With a value, the scan measures more where the surface is less certain, until it is as certain everywhere that light can reach or the points are spent. With none, the points are spread evenly.</source>
        <translation>Wie weit die Oberfläche danebenliegen darf (Standardunsicherheit). Mit einem Wert misst der Scan dort mehr, wo die Oberfläche unsicherer ist, bis sie überall sicher genug ist, wo Licht hinkommt, oder die Punkte verbraucht sind. Ohne Wert werden die Punkte gleichmäßig verteilt.</translation>
    </message>
    <message>
        <source>Laser off at once, and the end of the scan; what was measured is kept (Esc)</source>
        <translation>Laser sofort aus und Ende des Scans; das Gemessene bleibt erhalten (Esc)</translation>
    </message>
    <message>
        <source>Opening the rig…</source>
        <translation>Messplatz wird geöffnet…</translation>
    </message>
    <message>
        <source>Pass {number}, where it is needed: view {view} of {views}</source>
        <translation>Durchgang {number}, wo nötig: Ansicht {view} von {views}</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Paused in view {view} of {views}. The laser is dark, beam and table rest, all points so far are kept; it goes on with the next row.</source>
        <translation>Pause in Ansicht {view} von {views}. Der Laser ist dunkel, Strahl und Teller ruhen, alle bisherigen Punkte sind gesichert; weiter geht es mit der nächsten Zeile.</translation>
    </message>
    <message>
        <source>Pausing: the row that is being swept is finished first.</source>
        <translation>Pause folgt: Die begonnene Zeile wird noch beendet.</translation>
    </message>
    <message>
        <source>Places that are not as certain as wanted, why, and what can be done about them (F8)</source>
        <translation>Stellen, die nicht so sicher sind wie gewünscht, warum, und was dagegen hilft (F8)</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Points at most</source>
        <translation>Punkte höchstens</translation>
    </message>
    <message>
        <source>Ready to scan</source>
        <translation>Bereit zum Scannen</translation>
    </message>
    <message>
        <source>Reconstruct</source>
        <translation>Rekonstruieren</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>Fortsetzen</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>Scannen</translation>
    </message>
    <message>
        <source>Scan again</source>
        <translation>Neu scannen</translation>
    </message>
    <message>
        <source>Scan again…</source>
        <translation>Neu scannen…</translation>
    </message>
    <message>
        <source>Scan until {wanted} µm</source>
        <translation>Scannen bis {wanted} µm</translation>
    </message>
    <message>
        <source>Set the object down in another way and scan it into the same case (F9)</source>
        <translation>Das Objekt anders aufstellen und in denselben Fall scannen (F9)</translation>
    </message>
    <message>
        <source>Start scan</source>
        <translation>Scan starten</translation>
    </message>
    <message>
        <source>Starting…</source>
        <translation>Beginnt…</translation>
    </message>
    <message>
        <source>Still far fewer points than their neighbours: {views}</source>
        <translation>Immer noch weit weniger Punkte als ihre Nachbarn: {views}</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>Stopped; what was measured is kept</source>
        <translation>Gestoppt; das Gemessene ist gesichert</translation>
    </message>
    <message>
        <source>The rig has to be calibrated first.</source>
        <translation>Der Messplatz muss zuerst kalibriert werden.</translation>
    </message>
    <message>
        <source>The rig is not ready; the Rig page says why.</source>
        <translation>Der Messplatz ist nicht bereit; die Seite Messplatz sagt, warum.</translation>
    </message>
    <message>
        <source>The scan is complete.</source>
        <translation>Der Scan ist vollständig.</translation>
    </message>
    <message>
        <source>Uncertainty wanted</source>
        <translation>Gewünschte Unsicherheit</translation>
    </message>
    <message>
        <source>View {view} of {views}</source>
        <translation>Ansicht {view} von {views}</translation>
    </message>
    <message>
        <source>View {view} once more</source>
        <translation>Ansicht {view} noch einmal</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>Ansichten</translation>
    </message>
    <message>
        <source>Views measured once more: {views}</source>
        <translation>Noch einmal gemessene Ansichten: {views}</translation>
    </message>
    <message>
        <source>Whether the turn closes is not known: too few points of the first view were seen again.</source>
        <translation>Ob sich die Drehung schließt, ist nicht bekannt: Zu wenige Punkte der ersten Ansicht wurden wiedergesehen.</translation>
    </message>
    <message>
        <source>all points are spent</source>
        <translation>alle Punkte sind verbraucht</translation>
    </message>
    <message>
        <source>min:s</source>
        <translation>min:s</translation>
    </message>
    <message>
        <source>min:s left</source>
        <translation>min:s noch</translation>
    </message>
    <message>
        <source>more points would not help</source>
        <translation>mehr Punkte würden nicht helfen</translation>
    </message>
    <message>
        <source>no further view fits into this scan</source>
        <translation>keine weitere Ansicht passt in diesen Scan</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>points / s</source>
        <translation>Punkte / s</translation>
    </message>
    <message>
        <source>{count} places cannot be seen from this mount</source>
        <translation>{count} Stellen sind in dieser Aufstellung nicht sichtbar</translation>
    </message>
    <message>
        <source>{points} points  ·  view {view} of {views}</source>
        <translation>{points} Punkte  ·  Ansicht {view} von {views}</translation>
    </message>
    <message>
        <source>{points} points  ·  view {view} once more</source>
        <translation>{points} Punkte  ·  Ansicht {view} noch einmal</translation>
    </message>
    <message>
        <source>{share} % within {wanted} µm</source>
        <translation>{share} % innerhalb {wanted} µm</translation>
    </message>
    <message>
        <source>{share} % within {wanted} µm so far</source>
        <translation>bisher {share} % innerhalb {wanted} µm</translation>
    </message>
    <message>
        <source>µm closure</source>
        <translation>µm Ringschluss</translation>
    </message>
</context>
<context>
    <name>ScanTray</name>
    <message>
        <source>Both ears on the pair tray</source>
        <translation>Beide Ohren auf dem Paarträger</translation>
    </message>
    <message>
        <source>The left ear on seat L, the right one on seat R, the arrow at the table&apos;s zero: one run measures both for their orders</source>
        <translation>Linkes Ohr auf Sitz L, rechtes auf Sitz R, der Pfeil am Nullpunkt des Tellers: Ein Lauf misst beide für ihre Aufträge</translation>
    </message>
</context>
<context>
    <name>SceneLink</name>
    <message>
        <source>{n} points</source>
        <translation>{n} Punkte</translation>
    </message>
    <message>
        <source>{n} triangles</source>
        <translation>{n} Dreiecke</translation>
    </message>
</context>
<context>
    <name>SceneView</name>
    <message>
        <source>grid {mm:.0f} mm</source>
        <translation>Raster {mm:.0f} mm</translation>
    </message>
</context>
<context>
    <name>SettingsPage</name>
    <message>
        <source>As the system</source>
        <translation>Wie das System</translation>
    </message>
    <message>
        <source>As the system ({language})</source>
        <translation>Wie das System ({language})</translation>
    </message>
    <message>
        <source>At the end of a view, with the beam as slow as it needs to be; it costs some seconds.</source>
        <translation>Am Ende einer Ansicht, mit so langsamem Strahl wie nötig; es kostet einige Sekunden.</translation>
    </message>
    <message>
        <source>Cases</source>
        <translation>Fälle</translation>
    </message>
    <message>
        <source>Choose a folder</source>
        <translation>Ordner wählen</translation>
    </message>
    <message>
        <source>Choose the folder: {name}</source>
        <translation>Ordner wählen: {name}</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen…</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>Deliveries</source>
        <translation>Lieferungen</translation>
    </message>
    <message>
        <source>Everything on this page as on the first day; Ctrl+Z takes it back.</source>
        <translation>Alles auf dieser Seite wie am ersten Tag; Strg+Z nimmt es zurück.</translation>
    </message>
    <message>
        <source>File names</source>
        <translation>Dateinamen</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Dateien</translation>
    </message>
    <message>
        <source>Folder of the log</source>
        <translation>Ordner des Protokolls</translation>
    </message>
    <message>
        <source>Folder: {name}</source>
        <translation>Ordner: {name}</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>Live surface</source>
        <translation>Oberfläche live</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>Looks</source>
        <translation>Aussehen</translation>
    </message>
    <message>
        <source>Measure weak places again by itself</source>
        <translation>Schwache Stellen von selbst noch einmal messen</translation>
    </message>
    <message>
        <source>Of everything in the window, from the next start on.</source>
        <translation>Von allem im Fenster, ab dem nächsten Start.</translation>
    </message>
    <message>
        <source>Off leaves a slow computer more time for the points.</source>
        <translation>Aus lässt einem langsamen Rechner mehr Zeit für die Punkte.</translation>
    </message>
    <message>
        <source>Open the folder</source>
        <translation>Ordner öffnen</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programm</translation>
    </message>
    <message>
        <source>Reset to defaults</source>
        <translation>Auf Vorgaben zurücksetzen</translation>
    </message>
    <message>
        <source>Scanning</source>
        <translation>Scannen</translation>
    </message>
    <message>
        <source>Second try</source>
        <translation>Zweiter Versuch</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Show the surface while it is scanned</source>
        <translation>Die Oberfläche während des Scans zeigen</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>The log holds no patients and no orders. A support bundle (Help) packs it with what else helps.</source>
        <translation>Das Protokoll enthält keine Patienten und keine Aufträge. Ein Support-Paket (Hilfe) packt es mit dem, was sonst noch hilft.</translation>
    </message>
    <message>
        <source>The window changes its language when the scan or the reconstruction has ended and the program starts again.</source>
        <translation>Das Fenster wechselt seine Sprache, wenn Scan oder Rekonstruktion beendet ist und das Programm neu startet.</translation>
    </message>
    <message>
        <source>The window is made anew in it; the open case stays.</source>
        <translation>Das Fenster wird in ihr neu aufgebaut; der offene Fall bleibt.</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Design</translation>
    </message>
    <message>
        <source>Without it a file that leaves the house tells the order, the side and the day, and no patient.</source>
        <translation>Ohne ihn nennt eine Datei, die das Haus verlässt, Auftrag, Seite und Tag, aber keinen Patienten.</translation>
    </message>
    <message>
        <source>{n} %</source>
        <translation>{n} %</translation>
    </message>
</context>
<context>
    <name>ShortcutsDialog</name>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Copy as text</source>
        <translation>Als Text kopieren</translation>
    </message>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>No shortcut fits.</source>
        <translation>Kein Tastenkürzel passt.</translation>
    </message>
    <message>
        <source>Search the shortcuts</source>
        <translation>Tastenkürzel suchen</translation>
    </message>
    <message>
        <source>Search: a word, or a key</source>
        <translation>Suchen: ein Wort oder eine Taste</translation>
    </message>
    <message>
        <source>What it does</source>
        <translation>Was es tut</translation>
    </message>
</context>
<context>
    <name>SizeHistogram</name>
    <message>
        <source>Drag a limit, or choose it with up and down and move it with left and right</source>
        <translation>Eine Grenze ziehen, oder mit auf und ab wählen und mit links und rechts verschieben</translation>
    </message>
    <message>
        <source>Live shows how large spots are</source>
        <translation>Live zeigt die Größen</translation>
    </message>
    <message>
        <source>Size of a spot: {low} to {high} pixels, {chosen}</source>
        <translation>Größe eines Lichtpunkts: {low} bis {high} Pixel, {chosen}</translation>
    </message>
    <message>
        <source>largest size chosen</source>
        <translation>größte Größe gewählt</translation>
    </message>
    <message>
        <source>smallest size chosen</source>
        <translation>kleinste Größe gewählt</translation>
    </message>
</context>
<context>
    <name>Sparkline</name>
    <message>
        <source>Size deviation of the last tests in µm: {values}</source>
        <translation>Maßabweichung der letzten Prüfungen in µm: {values}</translation>
    </message>
</context>
<context>
    <name>SphereResultPanel</name>
    <message>
        <source>Save certificate…</source>
        <translation>Prüfbericht speichern…</translation>
    </message>
    <message>
        <source>Saved: {path}</source>
        <translation>Gespeichert: {path}</translation>
    </message>
    <message>
        <source>To the calibration</source>
        <translation>Zur Kalibrierung</translation>
    </message>
    <message>
        <source>Writing the certificate…</source>
        <translation>Prüfbericht wird geschrieben…</translation>
    </message>
    <message>
        <source>µm size deviation, U = {uncertainty} µm (k = 2)</source>
        <translation>µm Maßabweichung, U = {uncertainty} µm (k = 2)</translation>
    </message>
</context>
<context>
    <name>Stage</name>
    <message>
        <source>Preparing the 3D view…</source>
        <translation>3D-Ansicht wird vorbereitet…</translation>
    </message>
</context>
<context>
    <name>StatusLine</name>
    <message>
        <source>Calibration</source>
        <translation>Kalibrierung</translation>
    </message>
    <message>
        <source>Calibration expired</source>
        <translation>Kalibrierung abgelaufen</translation>
    </message>
    <message>
        <source>Calibration {age}</source>
        <translation>Kalibrierung {age}</translation>
    </message>
    <message>
        <source>Camera left not available</source>
        <translation>Kamera links nicht verfügbar</translation>
    </message>
    <message>
        <source>Camera right not available</source>
        <translation>Kamera rechts nicht verfügbar</translation>
    </message>
    <message>
        <source>Cameras not open</source>
        <translation>Kameras nicht offen</translation>
    </message>
    <message>
        <source>Cameras opening</source>
        <translation>Kameras werden geöffnet</translation>
    </message>
    <message>
        <source>Cameras ready</source>
        <translation>Kameras bereit</translation>
    </message>
    <message>
        <source>Controller not available</source>
        <translation>Steuerung nicht verfügbar</translation>
    </message>
    <message>
        <source>Not calibrated</source>
        <translation>Nicht kalibriert</translation>
    </message>
    <message>
        <source>Open the order that is being reconstructed</source>
        <translation>Den Auftrag öffnen, der rekonstruiert wird</translation>
    </message>
    <message>
        <source>The rig file cannot be used</source>
        <translation>Die Messplatzdatei ist nicht verwendbar</translation>
    </message>
    <message>
        <source>Turntable</source>
        <translation>Drehteller</translation>
    </message>
    <message>
        <source>Turntable {angle}°</source>
        <translation>Drehteller {angle}°</translation>
    </message>
    <message>
        <source>Virtual rig  ·  {rig}</source>
        <translation>Virtueller Messplatz  ·  {rig}</translation>
    </message>
    <message>
        <source>Virtual rig  ·  {rig}  ·  {speed}</source>
        <translation>Virtueller Messplatz  ·  {rig}  ·  {speed}</translation>
    </message>
    <message>
        <source>full speed</source>
        <translation>volles Tempo</translation>
    </message>
</context>
<context>
    <name>SupportDialog</name>
    <message>
        <source>&amp;Save…</source>
        <translation>&amp;Speichern…</translation>
    </message>
    <message>
        <source>Archives (*.zip)</source>
        <translation>Archive (*.zip)</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Collect &amp;again</source>
        <translation>&amp;Neu sammeln</translation>
    </message>
    <message>
        <source>Collecting…</source>
        <translation>Wird gesammelt…</translation>
    </message>
    <message>
        <source>Entries; those with a tick are saved</source>
        <translation>Einträge; gespeichert werden die mit Haken</translation>
    </message>
    <message>
        <source>One file for whoever helps you. Orders, patients, file names, the user and this machine are replaced, as marked in the text. Nothing leaves this machine by itself: you save the file and send it.</source>
        <translation>Eine Datei für die, die helfen. Aufträge, Patienten, Dateinamen, der Benutzer und dieser Rechner sind ersetzt, wie im Text markiert. Nichts verlässt diesen Rechner von selbst: Die Datei wird gespeichert und dann selbst versendet.</translation>
    </message>
    <message>
        <source>Save the support bundle</source>
        <translation>Support-Paket speichern</translation>
    </message>
    <message>
        <source>Saved as {path}.</source>
        <translation>Gespeichert als {path}.</translation>
    </message>
    <message>
        <source>Support bundle</source>
        <translation>Support-Paket</translation>
    </message>
    <message>
        <source>{size} in {n} entries. Replaced: {taken}.</source>
        <translation>{size} in {n} Einträgen. Ersetzt: {taken}.</translation>
    </message>
</context>
<context>
    <name>SupportPreview</name>
    <message>
        <source>(Only the first part is shown; the file holds all.)</source>
        <translation>(Nur der erste Teil wird gezeigt; die Datei enthält alles.)</translation>
    </message>
    <message>
        <source>(Only the last part is shown; the file holds all.)</source>
        <translation>(Nur der letzte Teil wird gezeigt; die Datei enthält alles.)</translation>
    </message>
    <message>
        <source>Content of the entry</source>
        <translation>Inhalt des Eintrags</translation>
    </message>
</context>
<context>
    <name>SurfaceCard</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen…</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>Reading {name}…</source>
        <translation>{name} wird gelesen…</translation>
    </message>
    <message>
        <source>Replace…</source>
        <translation>Ersetzen…</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Take this surface out</source>
        <translation>Diese Oberfläche herausnehmen</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Dreiecke</translation>
    </message>
    <message>
        <source>Unit of the file</source>
        <translation>Einheit der Datei</translation>
    </message>
    <message>
        <source>as you said</source>
        <translation>wie angegeben</translation>
    </message>
    <message>
        <source>centimetres</source>
        <translation>Zentimeter</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>Zoll</translation>
    </message>
    <message>
        <source>metres</source>
        <translation>Meter</translation>
    </message>
    <message>
        <source>millimetres</source>
        <translation>Millimeter</translation>
    </message>
    <message>
        <source>none yet</source>
        <translation>noch keine</translation>
    </message>
    <message>
        <source>{size} mm</source>
        <translation>{size} mm</translation>
    </message>
</context>
<context>
    <name>SurfacesPanel</name>
    <message>
        <source>After</source>
        <translation>Nachher</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Vorher</translation>
    </message>
    <message>
        <source>Kept in the open case</source>
        <translation>Im offenen Fall gesichert</translation>
    </message>
    <message>
        <source>Nothing of a file is repaired: what is noticed about it is said here.</source>
        <translation>Nichts an einer Datei wird repariert: Was an ihr auffällt, steht hier.</translation>
    </message>
    <message>
        <source>Swap before and after</source>
        <translation>Vorher und nachher tauschen</translation>
    </message>
    <message>
        <source>not reliable</source>
        <translation>nicht belastbar</translation>
    </message>
    <message>
        <source>reliable</source>
        <translation>belastbar</translation>
    </message>
    <message>
        <source>{day}: with {before}, 1 area, {verdict}</source>
        <translation>{day}: mit {before}, 1 Fläche, {verdict}</translation>
    </message>
    <message>
        <source>{day}: with {before}, {n} areas, {verdict}</source>
        <translation>{day}: mit {before}, {n} Flächen, {verdict}</translation>
    </message>
    <message>
        <source>{line}; of an earlier surface</source>
        <translation>{line}; einer früheren Oberfläche</translation>
    </message>
</context>
<context>
    <name>Thumbnail</name>
    <message>
        <source>no picture</source>
        <translation>kein Bild</translation>
    </message>
</context>
<context>
    <name>TourCard</name>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>End the tour</source>
        <translation>Rundgang beenden</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>Rundgang</translation>
    </message>
    <message>
        <source>{n} of {all}</source>
        <translation>{n} von {all}</translation>
    </message>
</context>
<context>
    <name>TranscriptWindow</name>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>&amp;Leave out the questions for the status</source>
        <translation>&amp;Statusabfragen weglassen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Lines to (&gt;) and from (&lt;) the controller</source>
        <translation>Zeilen zur (&gt;) und von der (&lt;) Steuerung</translation>
    </message>
    <message>
        <source>Port {port}. Nothing has been said yet.</source>
        <translation>Anschluss {port}. Noch wurde nichts gesprochen.</translation>
    </message>
    <message>
        <source>Port {port}. Seconds since the start, &gt; to the controller, &lt; from it.</source>
        <translation>Anschluss {port}. Sekunden seit dem Start, &gt; zur Steuerung, &lt; von ihr.</translation>
    </message>
    <message>
        <source>Transcript of the controller</source>
        <translation>Mitschrift der Steuerung</translation>
    </message>
</context>
<context>
    <name>Verdict</name>
    <message>
        <source>And {n} more, under Surfaces and Alignment.</source>
        <translation>Und {n} weitere, unter Oberflächen und Ausrichtung.</translation>
    </message>
    <message>
        <source>Held fixed: {frame} ({share} %).</source>
        <translation>Festgehalten: {frame} ({share} %).</translation>
    </message>
    <message>
        <source>Not reliable</source>
        <translation>Nicht belastbar</translation>
    </message>
    <message>
        <source>Out of date</source>
        <translation>Veraltet</translation>
    </message>
    <message>
        <source>Reliable</source>
        <translation>Belastbar</translation>
    </message>
    <message>
        <source>Remarks, under Surfaces and Alignment: {n}</source>
        <translation>Hinweise, unter Oberflächen und Ausrichtung: {n}</translation>
    </message>
    <message>
        <source>What is shown was computed before the last change.</source>
        <translation>Das Gezeigte wurde vor der letzten Änderung berechnet.</translation>
    </message>
</context>
<context>
    <name>VerifyPage</name>
    <message>
        <source>% done</source>
        <translation>% fertig</translation>
    </message>
    <message>
        <source>1.  Take away what stands on the table.</source>
        <translation>1.  Wegnehmen, was auf dem Teller steht.</translation>
    </message>
    <message>
        <source>2.  Put the reference sphere into the middle of the table, clean and alone.</source>
        <translation>2.  Die Referenzkugel sauber und allein in die Tellermitte stellen.</translation>
    </message>
    <message>
        <source>3.  Close the lid.</source>
        <translation>3.  Deckel schließen.</translation>
    </message>
    <message>
        <source>A scan is running: wait for its end or stop it first (Esc).</source>
        <translation>Ein Scan läuft: das Ende abwarten oder zuerst stoppen (Esc).</translation>
    </message>
    <message>
        <source>A sphere of certified size tells whether the rig still measures right. It takes about a minute; nothing is scanned meanwhile.</source>
        <translation>Eine Kugel mit zertifiziertem Maß zeigt, ob der Messplatz noch richtig misst. Das dauert etwa eine Minute; solange wird nichts gescannt.</translation>
    </message>
    <message>
        <source>Back to the rig</source>
        <translation>Zurück zum Messplatz</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Cancelled: nothing was kept, and the laser is off.</source>
        <translation>Abgebrochen: Nichts wurde gesichert, und der Laser ist aus.</translation>
    </message>
    <message>
        <source>Cancelling…</source>
        <translation>Wird abgebrochen…</translation>
    </message>
    <message>
        <source>Certified diameter</source>
        <translation>Zertifizierter Durchmesser</translation>
    </message>
    <message>
        <source>Diameter {diameter} mm, U = {uncertainty} µm: the sphere of the virtual rig.</source>
        <translation>Durchmesser {diameter} mm, U = {uncertainty} µm: die Kugel des virtuellen Messplatzes.</translation>
    </message>
    <message>
        <source>Enter the diameter from the sphere&apos;s certificate.</source>
        <translation>Den Durchmesser aus dem Zertifikat der Kugel eingeben.</translation>
    </message>
    <message>
        <source>From its certificate</source>
        <translation>Aus ihrem Zertifikat</translation>
    </message>
    <message>
        <source>Its uncertainty U (k = 2)</source>
        <translation>Seine Unsicherheit U (k = 2)</translation>
    </message>
    <message>
        <source>Keep your hands off and the lid closed. Esc switches the laser off at once.</source>
        <translation>Hände weg, Deckel geschlossen lassen. Esc schaltet den Laser sofort aus.</translation>
    </message>
    <message>
        <source>Measure again</source>
        <translation>Neu messen</translation>
    </message>
    <message>
        <source>Measure the sphere</source>
        <translation>Kugel messen</translation>
    </message>
    <message>
        <source>Measuring the reference sphere</source>
        <translation>Referenzkugel wird gemessen</translation>
    </message>
    <message>
        <source>Progress of the measurement</source>
        <translation>Fortschritt der Messung</translation>
    </message>
    <message>
        <source>Reference sphere</source>
        <translation>Referenzkugel</translation>
    </message>
    <message>
        <source>Save the certificate</source>
        <translation>Prüfbericht speichern</translation>
    </message>
    <message>
        <source>The rig is not open: the Rig page says why.</source>
        <translation>Der Messplatz ist nicht offen: Die Seite Messplatz sagt, warum.</translation>
    </message>
    <message>
        <source>The virtual rig puts its sphere on the table by itself, and afterwards puts back what stood there. Nothing has to be done.</source>
        <translation>Der virtuelle Messplatz stellt seine Kugel von selbst auf den Teller und danach zurück, was dort stand. Es ist nichts zu tun.</translation>
    </message>
    <message>
        <source>The whole test measures the sphere ten times and belongs to an acceptance: impronta verify sphere</source>
        <translation>Die ganze Prüfung misst die Kugel zehnmal und gehört zu einer Abnahme: impronta verify sphere</translation>
    </message>
    <message>
        <source>This rig is not calibrated: calibrate it first.</source>
        <translation>Dieser Messplatz ist nicht kalibriert: zuerst kalibrieren.</translation>
    </message>
    <message>
        <source>not entered</source>
        <translation>nicht eingegeben</translation>
    </message>
    <message>
        <source>{left} left</source>
        <translation>noch {left}</translation>
    </message>
</context>
<context>
    <name>WedgeField</name>
    <message>
        <source>Order number, by barcode or keys</source>
        <translation>Auftragsnummer, per Barcode oder Tasten</translation>
    </message>
    <message>
        <source>Scan or type an order number</source>
        <translation>Auftragsnummer scannen oder tippen</translation>
    </message>
</context>
<context>
    <name>WindowHelp</name>
    <message>
        <source>At the end stands a file for the next machine, with its checks in plain words.</source>
        <translation>Am Ende steht eine Datei für die nächste Maschine, mit ihren Prüfungen in klaren Worten.</translation>
    </message>
    <message>
        <source>Checked, then delivered</source>
        <translation>Geprüft, dann ausgeliefert</translation>
    </message>
    <message>
        <source>Esc does the same on every page. It is filled with red while the laser is on.</source>
        <translation>Esc tut dasselbe auf jeder Seite. Der Knopf ist rot gefüllt, solange der Laser an ist.</translation>
    </message>
    <message>
        <source>Every order passes these steps. Ctrl and a number opens each.</source>
        <translation>Jeder Auftrag durchläuft diese Schritte. Strg und eine Zahl öffnet jeden.</translation>
    </message>
    <message>
        <source>F1 explains the page and the control in hand, ? lists all keys, and Ctrl+Z takes back what you did.</source>
        <translation>F1 erklärt die Seite und das gewählte Bedienelement, ? zeigt alle Tasten, und Strg+Z nimmt zurück, was getan wurde.</translation>
    </message>
    <message>
        <source>Help is at hand</source>
        <translation>Hilfe ist zur Hand</translation>
    </message>
    <message>
        <source>One button is next</source>
        <translation>Ein Knopf ist der nächste</translation>
    </message>
    <message>
        <source>Points and surface grow before you. Pause is safe: the laser goes dark and nothing is lost.</source>
        <translation>Punkte und Oberfläche wachsen vor Augen. Pause ist sicher: Der Laser erlischt, und nichts geht verloren.</translation>
    </message>
    <message>
        <source>Scanning runs by itself</source>
        <translation>Das Scannen läuft von selbst</translation>
    </message>
    <message>
        <source>Stop, from everywhere</source>
        <translation>Stopp, von überall</translation>
    </message>
    <message>
        <source>The filled button is what to do now. A demo order stands here already: press it and watch.</source>
        <translation>Der gefüllte Knopf ist jetzt zu drücken. Ein Demo-Auftrag steht schon hier: drücken und zusehen.</translation>
    </message>
    <message>
        <source>The work goes from the top down</source>
        <translation>Die Arbeit läuft von oben nach unten</translation>
    </message>
</context>
<context>
    <name>WriteStep</name>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Limits, the laser&apos;s place and the volume are those of the shipped bench. Correct them for your mechanics before the first scan.</source>
        <translation>Grenzen, Ort des Lasers und Messvolumen sind die der mitgelieferten Werkbank. Vor dem ersten Scan für die eigene Mechanik berichtigen.</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Name of the rig</source>
        <translation>Name des Messplatzes</translation>
    </message>
    <message>
        <source>Other file…</source>
        <translation>Andere Datei…</translation>
    </message>
    <message>
        <source>Replace it</source>
        <translation>Ersetzen</translation>
    </message>
    <message>
        <source>Rigs (*.toml)</source>
        <translation>Messplätze (*.toml)</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>The Rig page shows it, and calibrates it anew.</source>
        <translation>Die Seite Messplatz zeigt ihn und kalibriert ihn neu.</translation>
    </message>
    <message>
        <source>The rig cannot measure before it is calibrated: the Rig page prints the target and takes you through it.</source>
        <translation>Der Messplatz kann erst messen, wenn er kalibriert ist: Die Seite Messplatz druckt die Tafel und führt hindurch.</translation>
    </message>
    <message>
        <source>The rig&apos;s file</source>
        <translation>Die Datei des Messplatzes</translation>
    </message>
    <message>
        <source>There is a file of this name already. Press once more to replace it, or choose another name.</source>
        <translation>Eine Datei dieses Namens gibt es schon. Zum Ersetzen noch einmal drücken oder anderen Namen wählen.</translation>
    </message>
    <message>
        <source>Use this rig now</source>
        <translation>Diesen Messplatz benutzen</translation>
    </message>
    <message>
        <source>What will be written</source>
        <translation>Was geschrieben wird</translation>
    </message>
    <message>
        <source>Where to write the rig</source>
        <translation>Wohin der Messplatz geschrieben wird</translation>
    </message>
    <message>
        <source>Written to {path}.</source>
        <translation>Geschrieben nach {path}.</translation>
    </message>
</context>
<context>
    <name>_Entry</name>
    <message>
        <source>{n} mm</source>
        <translation>{n} mm</translation>
    </message>
</context>
<context>
    <name>_ExpertFields</name>
    <message>
        <source>As many triangles as it takes that 95 of 100 facets keep this tolerance; goes before the number of triangles.</source>
        <translation>So viele Dreiecke, dass 95 von 100 Facetten diese Toleranz einhalten; geht vor der Zahl der Dreiecke.</translation>
    </message>
    <message>
        <source>Back to the defaults</source>
        <translation>Zurück zu den Vorgaben</translation>
    </message>
    <message>
        <source>Density of the points, of that which they have among themselves, from which on the surface counts as measured. Default 45 %.</source>
        <translation>Punktdichte, gemessen an der Dichte der Punkte unter sich, ab der die Oberfläche als gemessen gilt. Vorgabe 45 %.</translation>
    </message>
    <message>
        <source>Goes before the slider.</source>
        <translation>Geht vor dem Regler.</translation>
    </message>
    <message>
        <source>Leave open what was not scanned</source>
        <translation>Nicht Gescanntes offen lassen</translation>
    </message>
    <message>
        <source>Of every random choice: the same points and seed give the same surface. Default 0.</source>
        <translation>Jeder zufälligen Wahl: Gleiche Punkte und gleicher Startwert ergeben dieselbe Oberfläche. Vorgabe 0.</translation>
    </message>
    <message>
        <source>Pass-band</source>
        <translation>Durchlassbereich</translation>
    </message>
    <message>
        <source>Rounds of Taubin&apos;s filter in the last phase. Default 3; many of them inflate the surface.</source>
        <translation>Runden des Taubin-Filters in der letzten Phase. Vorgabe 3; viele davon blähen die Oberfläche auf.</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Startwert</translation>
    </message>
    <message>
        <source>Smoothing rounds</source>
        <translation>Glättungsrunden</translation>
    </message>
    <message>
        <source>Support from</source>
        <translation>Belegt ab</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>Triangles, at most</source>
        <translation>Dreiecke, höchstens</translation>
    </message>
    <message>
        <source>Waves longer than this share of the highest spatial frequency stay. Default 10 %.</source>
        <translation>Wellen, die länger sind als dieser Anteil der höchsten Ortsfrequenz, bleiben. Vorgabe 10 %.</translation>
    </message>
    <message>
        <source>Without it the surface is closed, as printing needs it; what is bridged is marked as not scanned.</source>
        <translation>Ohne das wird die Oberfläche geschlossen, wie der Druck sie braucht; Überbrücktes wird als nicht gescannt markiert.</translation>
    </message>
    <message>
        <source>by detail</source>
        <translation>nach Detailgrad</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
</context>
<context>
    <name>_Facts</name>
    <message>
        <source>Closed</source>
        <translation>Geschlossen</translation>
    </message>
    <message>
        <source>Noise of the points</source>
        <translation>Rauschen der Punkte</translation>
    </message>
    <message>
        <source>Outliers rejected</source>
        <translation>Ausreißer verworfen</translation>
    </message>
    <message>
        <source>Points to surface</source>
        <translation>Punkte zur Oberfläche</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>{n} s</source>
        <translation>{n} s</translation>
    </message>
    <message>
        <source>{n} µm</source>
        <translation>{n} µm</translation>
    </message>
    <message>
        <source>{n} µm rms</source>
        <translation>{n} µm rms</translation>
    </message>
</context>
<context>
    <name>_Line</name>
    <message>
        <source>{order}: do not reconstruct</source>
        <translation>{order}: nicht rekonstruieren</translation>
    </message>
    <message>
        <source>{order}: one place forward</source>
        <translation>{order}: einen Platz nach vorn</translation>
    </message>
</context>
<context>
    <name>_PhaseLine</name>
    <message>
        <source>{n} s</source>
        <translation>{n} s</translation>
    </message>
</context>
<context>
    <name>actions</name>
    <message>
        <source>&amp;About Impronta</source>
        <translation>Über &amp;Impronta</translation>
    </message>
    <message>
        <source>&amp;Case</source>
        <translation>&amp;Fall</translation>
    </message>
    <message>
        <source>&amp;Colours: the next</source>
        <translation>&amp;Farben: die nächste</translation>
    </message>
    <message>
        <source>&amp;Complete</source>
        <translation>&amp;Ergänzen</translation>
    </message>
    <message>
        <source>&amp;Deliver…</source>
        <translation>Aus&amp;liefern…</translation>
    </message>
    <message>
        <source>&amp;Edges</source>
        <translation>&amp;Kanten</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;Fill now</source>
        <translation>&amp;Jetzt ergänzen</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>&amp;Einpassen</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>&amp;Help on this page</source>
        <translation>&amp;Hilfe zu dieser Seite</translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts</source>
        <translation>&amp;Tastenkürzel</translation>
    </message>
    <message>
        <source>&amp;New case</source>
        <translation>&amp;Neuer Fall</translation>
    </message>
    <message>
        <source>&amp;Open case…</source>
        <translation>Fall ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>&amp;Pause or resume</source>
        <translation>&amp;Pause oder weiter</translation>
    </message>
    <message>
        <source>&amp;Points</source>
        <translation>&amp;Punkte</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>&amp;Reconstruct</source>
        <translation>&amp;Rekonstruieren</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>&amp;Scan</source>
        <translation>&amp;Scan</translation>
    </message>
    <message>
        <source>&amp;Start scan</source>
        <translation>Scan &amp;starten</translation>
    </message>
    <message>
        <source>&amp;Support bundle…</source>
        <translation>&amp;Support-Paket…</translation>
    </message>
    <message>
        <source>&amp;Surface</source>
        <translation>&amp;Oberfläche</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>Von o&amp;ben</translation>
    </message>
    <message>
        <source>&amp;Tour</source>
        <translation>&amp;Rundgang</translation>
    </message>
    <message>
        <source>&amp;Uncertainty</source>
        <translation>&amp;Unsicherheit</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>Another &amp;mount</source>
        <translation>Neue &amp;Aufstellung</translation>
    </message>
    <message>
        <source>F&amp;ront</source>
        <translation>Von &amp;vorn</translation>
    </message>
    <message>
        <source>Scan &amp;this mount</source>
        <translation>Diese Aufstellung s&amp;cannen</translation>
    </message>
    <message>
        <source>Set up a ri&amp;g…</source>
        <translation>Messplat&amp;z einrichten…</translation>
    </message>
    <message>
        <source>Stop and &amp;laser off</source>
        <translation>Stopp und &amp;Laser aus</translation>
    </message>
</context>
<context>
    <name>activity</name>
    <message>
        <source>Bringing the mounts together</source>
        <translation>Aufstellungen werden zusammengeführt</translation>
    </message>
    <message>
        <source>Calibrating</source>
        <translation>Kalibrierung</translation>
    </message>
    <message>
        <source>Comparing</source>
        <translation>Vergleich</translation>
    </message>
    <message>
        <source>Computing the points anew…</source>
        <translation>Punkte werden neu berechnet…</translation>
    </message>
    <message>
        <source>Looking for what is missing</source>
        <translation>Fehlendes wird gesucht</translation>
    </message>
    <message>
        <source>Measuring the reference sphere</source>
        <translation>Referenzkugel wird gemessen</translation>
    </message>
    <message>
        <source>Opening the case…</source>
        <translation>Fall wird geöffnet…</translation>
    </message>
    <message>
        <source>Scan paused</source>
        <translation>Scan angehalten</translation>
    </message>
    <message>
        <source>Scanning</source>
        <translation>Scannen</translation>
    </message>
    <message>
        <source>Setting up a rig</source>
        <translation>Messplatz wird eingerichtet</translation>
    </message>
</context>
<context>
    <name>aim</name>
    <message>
        <source>As it was set on the Aim page.</source>
        <translation>Wie auf der Seite Anvisieren eingestellt.</translation>
    </message>
    <message>
        <source>As the rig file says</source>
        <translation>Laut Messplatzdatei</translation>
    </message>
    <message>
        <source>Automatic exposure</source>
        <translation>Belichtung automatisch</translation>
    </message>
    <message>
        <source>Both cameras saw too few spots to learn from: bring the spot to a place that both see.</source>
        <translation>Beide Kameras sahen zu wenige Lichtpunkte zum Lernen: Laserpunkt an eine Stelle bringen, die beide sehen.</translation>
    </message>
    <message>
        <source>Both cameras see the spot.</source>
        <translation>Beide Kameras sehen den Laserpunkt.</translation>
    </message>
    <message>
        <source>Bringing the spot there…</source>
        <translation>Laserpunkt fährt dorthin…</translation>
    </message>
    <message>
        <source>Change limits of the spot&apos;s size</source>
        <translation>Grenzen der Punktgröße ändern</translation>
    </message>
    <message>
        <source>Choose material</source>
        <translation>Material wählen</translation>
    </message>
    <message>
        <source>Finding the exposure…</source>
        <translation>Belichtung wird gesucht…</translation>
    </message>
    <message>
        <source>Learn the spot&apos;s size</source>
        <translation>Punktgröße lernen</translation>
    </message>
    <message>
        <source>Learned from {spots} spots; {strays} reflections were seen beside them.</source>
        <translation>Aus {spots} Lichtpunkten gelernt; daneben wurden {strays} Reflexe gesehen.</translation>
    </message>
    <message>
        <source>Learning: the beam moves a little…</source>
        <translation>Lernen: Der Strahl bewegt sich ein wenig…</translation>
    </message>
    <message>
        <source>Live lights the laser and shows what the cameras make of its spot.</source>
        <translation>Live schaltet den Laser ein und zeigt, wie die Kameras seinen Lichtpunkt beurteilen.</translation>
    </message>
    <message>
        <source>Looking for the object…</source>
        <translation>Objekt wird gesucht…</translation>
    </message>
    <message>
        <source>Moving…</source>
        <translation>In Bewegung…</translation>
    </message>
    <message>
        <source>No point here: {reason}.</source>
        <translation>Hier kein Punkt: {reason}.</translation>
    </message>
    <message>
        <source>The background is too bright: switch off the lamp or close the lid.</source>
        <translation>Der Hintergrund ist zu hell: Lampe ausschalten oder Deckel schließen.</translation>
    </message>
    <message>
        <source>The rig is not calibrated: each camera is judged alone.</source>
        <translation>Der Messplatz ist nicht kalibriert: Jede Kamera wird für sich beurteilt.</translation>
    </message>
    <message>
        <source>Too bright even at the shortest exposure: close the apertures.</source>
        <translation>Selbst bei kürzester Belichtung zu hell: Blenden schließen.</translation>
    </message>
    <message>
        <source>Too dark even at the longest exposure: look at the laser and the lens caps, or open the apertures.</source>
        <translation>Selbst bei längster Belichtung zu dunkel: Laser und Objektivdeckel prüfen oder Blenden öffnen.</translation>
    </message>
    <message>
        <source>{left} and {right}</source>
        <translation>{left} und {right}</translation>
    </message>
    <message>
        <source>{material}: {exposure} ms, {gain} dB, spots of {low} to {high} pixels</source>
        <translation>{material}: {exposure} ms, {gain} dB, Lichtpunkte von {low} bis {high} Pixel</translation>
    </message>
</context>
<context>
    <name>assistant</name>
    <message>
        <source>Camera left</source>
        <translation>Kamera links</translation>
    </message>
    <message>
        <source>Camera right</source>
        <translation>Kamera rechts</translation>
    </message>
    <message>
        <source>Correct the steps of beam X: it moves {percent} % of what it is told.</source>
        <translation>Schritte von Strahl X berichtigen: Er fährt {percent} % des Verlangten.</translation>
    </message>
    <message>
        <source>Correct the steps of beam Y: it moves {percent} % of what it is told.</source>
        <translation>Schritte von Strahl Y berichtigen: Er fährt {percent} % des Verlangten.</translation>
    </message>
    <message>
        <source>Correct the steps of the table: it turns {percent} % of what it is told.</source>
        <translation>Schritte des Tellers berichtigen: Er dreht {percent} % des Verlangten.</translation>
    </message>
    <message>
        <source>Exchange the cameras: the one that is called left stands to the right of the other.</source>
        <translation>Kameras tauschen: Die als linke bezeichnete steht rechts von der anderen.</translation>
    </message>
    <message>
        <source>Expose both cameras for {ms} ms (left {left} dB, right {right} dB): it suits what stands there.</source>
        <translation>Passende Belichtung setzen: {ms} ms (links {left} dB, rechts {right} dB).</translation>
    </message>
    <message>
        <source>Free: each by its own clock</source>
        <translation>Frei: jede nach eigenem Takt</translation>
    </message>
    <message>
        <source>GRBL board, set up for something else</source>
        <translation>GRBL-Steuerung, für anderes eingerichtet</translation>
    </message>
    <message>
        <source>Hardware: a cable to both</source>
        <translation>Hardware: ein Kabel zu beiden</translation>
    </message>
    <message>
        <source>Left, difference</source>
        <translation>Links, Differenz</translation>
    </message>
    <message>
        <source>Left, first end</source>
        <translation>Links, erstes Ende</translation>
    </message>
    <message>
        <source>Left, laser off</source>
        <translation>Links, Laser aus</translation>
    </message>
    <message>
        <source>Left, laser on</source>
        <translation>Links, Laser an</translation>
    </message>
    <message>
        <source>Left, other end</source>
        <translation>Links, anderes Ende</translation>
    </message>
    <message>
        <source>Right, difference</source>
        <translation>Rechts, Differenz</translation>
    </message>
    <message>
        <source>Right, first end</source>
        <translation>Rechts, erstes Ende</translation>
    </message>
    <message>
        <source>Right, laser off</source>
        <translation>Rechts, Laser aus</translation>
    </message>
    <message>
        <source>Right, laser on</source>
        <translation>Rechts, Laser an</translation>
    </message>
    <message>
        <source>Right, other end</source>
        <translation>Rechts, anderes Ende</translation>
    </message>
    <message>
        <source>Software: a command for every picture</source>
        <translation>Software: ein Befehl für jedes Bild</translation>
    </message>
    <message>
        <source>Turn the direction of beam X round: it moves the spot the other way.</source>
        <translation>Richtung von Strahl X umkehren: Er bewegt den Lichtpunkt andersherum.</translation>
    </message>
    <message>
        <source>Turn the direction of beam Y round: it moves the spot the other way.</source>
        <translation>Richtung von Strahl Y umkehren: Er bewegt den Lichtpunkt andersherum.</translation>
    </message>
    <message>
        <source>Turn the direction of the table round: it turns the other way.</source>
        <translation>Richtung des Tellers umkehren: Er dreht andersherum.</translation>
    </message>
    <message>
        <source>Virtual camera, left</source>
        <translation>Virtuelle Kamera, links</translation>
    </message>
    <message>
        <source>Virtual camera, right</source>
        <translation>Virtuelle Kamera, rechts</translation>
    </message>
    <message>
        <source>black picture</source>
        <translation>schwarzes Bild</translation>
    </message>
    <message>
        <source>cannot be opened</source>
        <translation>lässt sich nicht öffnen</translation>
    </message>
    <message>
        <source>controller</source>
        <translation>Steuerung</translation>
    </message>
    <message>
        <source>does not work</source>
        <translation>arbeitet nicht</translation>
    </message>
    <message>
        <source>good</source>
        <translation>gut</translation>
    </message>
    <message>
        <source>look at this</source>
        <translation>ansehen</translation>
    </message>
    <message>
        <source>no picture</source>
        <translation>kein Bild</translation>
    </message>
    <message>
        <source>not permitted</source>
        <translation>nicht erlaubt</translation>
    </message>
    <message>
        <source>ready</source>
        <translation>bereit</translation>
    </message>
    <message>
        <source>silent</source>
        <translation>stumm</translation>
    </message>
    <message>
        <source>something else</source>
        <translation>etwas anderes</translation>
    </message>
    <message>
        <source>used by another program</source>
        <translation>von anderem Programm benutzt</translation>
    </message>
    <message>
        <source>wrong format</source>
        <translation>falsches Format</translation>
    </message>
    <message>
        <source>{width} × {height} px, {rate} frames/s</source>
        <translation>{width} × {height} px, {rate} Bilder/s</translation>
    </message>
</context>
<context>
    <name>board</name>
    <message>
        <source>Angle {n} of {count}</source>
        <translation>Winkel {n} von {count}</translation>
    </message>
    <message>
        <source>Angle {n} taken. The table turns: hands off.</source>
        <translation>Winkel {n} aufgenommen. Der Teller dreht: Hände weg.</translation>
    </message>
    <message>
        <source>Bar {n} taken. Now hold it another way.</source>
        <translation>Stab {n} aufgenommen. Jetzt anders halten.</translation>
    </message>
    <message>
        <source>Blurred</source>
        <translation>Unscharf</translation>
    </message>
    <message>
        <source>Both cameras see the board, but not the same part of it.</source>
        <translation>Beide Kameras sehen die Tafel, aber nicht denselben Teil.</translation>
    </message>
    <message>
        <source>Both of its ends in sight of both cameras.</source>
        <translation>Beide Enden im Bild beider Kameras.</translation>
    </message>
    <message>
        <source>Bring the board nearer and farther</source>
        <translation>Die Tafel näher und weiter weg bringen</translation>
    </message>
    <message>
        <source>Bring the board to the left of the {camera} picture</source>
        <translation>Die Tafel nach links im Bild der {camera} bringen</translation>
    </message>
    <message>
        <source>Bring the board to the lower left of the {camera} picture</source>
        <translation>Die Tafel nach unten links im Bild der {camera} bringen</translation>
    </message>
    <message>
        <source>Bring the board to the lower middle of the {camera} picture</source>
        <translation>Die Tafel nach unten Mitte im Bild der {camera} bringen</translation>
    </message>
    <message>
        <source>Bring the board to the lower right of the {camera} picture</source>
        <translation>Die Tafel nach unten rechts im Bild der {camera} bringen</translation>
    </message>
    <message>
        <source>Bring the board to the middle of the {camera} picture</source>
        <translation>Die Tafel in die Mitte des Bildes der {camera} bringen</translation>
    </message>
    <message>
        <source>Bring the board to the right of the {camera} picture</source>
        <translation>Die Tafel nach rechts im Bild der {camera} bringen</translation>
    </message>
    <message>
        <source>Bring the board to the upper left of the {camera} picture</source>
        <translation>Die Tafel nach oben links im Bild der {camera} bringen</translation>
    </message>
    <message>
        <source>Bring the board to the upper middle of the {camera} picture</source>
        <translation>Die Tafel nach oben Mitte im Bild der {camera} bringen</translation>
    </message>
    <message>
        <source>Bring the board to the upper right of the {camera} picture</source>
        <translation>Die Tafel nach oben rechts im Bild der {camera} bringen</translation>
    </message>
    <message>
        <source>Computing cameras and lenses from all views.</source>
        <translation>Kameras und Objektive werden aus allen Ansichten berechnet.</translation>
    </message>
    <message>
        <source>Computing the scale from the length bar.</source>
        <translation>Der Maßstab wird aus dem Längenstab berechnet.</translation>
    </message>
    <message>
        <source>Computing the table&apos;s axis and the uncertainty.</source>
        <translation>Die Achse des Tellers und die Unsicherheit werden berechnet.</translation>
    </message>
    <message>
        <source>Cut by the picture&apos;s edge</source>
        <translation>Vom Bildrand abgeschnitten</translation>
    </message>
    <message>
        <source>Each time at another place and tilted another way; hold it still until it is taken.</source>
        <translation>Jedes Mal an anderer Stelle und anders geneigt; ruhig halten, bis aufgenommen ist.</translation>
    </message>
    <message>
        <source>Flat, face up, about the table&apos;s middle; then the table turns by itself.</source>
        <translation>Flach, bedruckte Seite oben, um die Tellermitte; dann dreht der Teller von selbst.</translation>
    </message>
    <message>
        <source>Hold the bar still.</source>
        <translation>Den Stab ruhig halten.</translation>
    </message>
    <message>
        <source>Hold the board into the volume</source>
        <translation>Die Tafel in das Messvolumen halten</translation>
    </message>
    <message>
        <source>Hold the board still.</source>
        <translation>Die Tafel ruhig halten.</translation>
    </message>
    <message>
        <source>Hold the length bar into the volume</source>
        <translation>Den Längenstab in das Messvolumen halten</translation>
    </message>
    <message>
        <source>Lay the board on the table</source>
        <translation>Die Tafel auf den Teller legen</translation>
    </message>
    <message>
        <source>Length bar {n} of {count}</source>
        <translation>Längenstab {n} von {count}</translation>
    </message>
    <message>
        <source>More angles of the table: {n}</source>
        <translation>Weitere Winkel des Tellers: {n}</translation>
    </message>
    <message>
        <source>More views of the length bar: {n}</source>
        <translation>Weitere Ansichten des Längenstabs: {n}</translation>
    </message>
    <message>
        <source>More views: {n}</source>
        <translation>Weitere Ansichten: {n}</translation>
    </message>
    <message>
        <source>Neither camera sees the board.</source>
        <translation>Keine Kamera sieht die Tafel.</translation>
    </message>
    <message>
        <source>No board in sight</source>
        <translation>Keine Tafel im Bild</translation>
    </message>
    <message>
        <source>Only one camera sees the board.</source>
        <translation>Nur eine Kamera sieht die Tafel.</translation>
    </message>
    <message>
        <source>Take your hands away.</source>
        <translation>Hände wegnehmen.</translation>
    </message>
    <message>
        <source>Tilt the board more, each time to another side</source>
        <translation>Die Tafel stärker neigen, jedes Mal zu einer anderen Seite</translation>
    </message>
    <message>
        <source>Too bright</source>
        <translation>Zu hell</translation>
    </message>
    <message>
        <source>Too dark</source>
        <translation>Zu dunkel</translation>
    </message>
    <message>
        <source>Too little of the board in sight</source>
        <translation>Zu wenig von der Tafel im Bild</translation>
    </message>
    <message>
        <source>Too similar to an earlier view: move or tilt the board.</source>
        <translation>Einer früheren Ansicht zu ähnlich: Tafel bewegen oder neigen.</translation>
    </message>
    <message>
        <source>View taken.</source>
        <translation>Ansicht aufgenommen.</translation>
    </message>
    <message>
        <source>View {n} of {count}</source>
        <translation>Ansicht {n} von {count}</translation>
    </message>
    <message>
        <source>View {n} taken. Now tilt it another way.</source>
        <translation>Ansicht {n} aufgenommen. Jetzt anders neigen.</translation>
    </message>
    <message>
        <source>left camera&apos;s</source>
        <translation>linken Kamera</translation>
    </message>
    <message>
        <source>right camera&apos;s</source>
        <translation>rechten Kamera</translation>
    </message>
    <message>
        <source>{n} corners</source>
        <translation>{n} Ecken</translation>
    </message>
    <message>
        <source>{what} in the {camera} picture</source>
        <translation>{what} im Bild der {camera}</translation>
    </message>
</context>
<context>
    <name>calibration</name>
    <message>
        <source>Age unknown</source>
        <translation>Alter unbekannt</translation>
    </message>
    <message>
        <source>Distance between the cameras</source>
        <translation>Abstand der Kameras</translation>
    </message>
    <message>
        <source>Expired {n} days ago</source>
        <translation>Vor {n} Tagen abgelaufen</translation>
    </message>
    <message>
        <source>Expires soon: {n} days left</source>
        <translation>Läuft bald ab: noch {n} Tage</translation>
    </message>
    <message>
        <source>Focal length, left and right</source>
        <translation>Brennweite, links und rechts</translation>
    </message>
    <message>
        <source>Identity</source>
        <translation>Kennung</translation>
    </message>
    <message>
        <source>Image centre, left</source>
        <translation>Bildmitte, links</translation>
    </message>
    <message>
        <source>Image centre, right</source>
        <translation>Bildmitte, rechts</translation>
    </message>
    <message>
        <source>Length bar where it took no part</source>
        <translation>Längenstab, wo er nicht mitwirkte</translation>
    </message>
    <message>
        <source>Measured shapes change by {rms} µm rms over the volume, {largest} µm at most</source>
        <translation>Gemessene Formen ändern sich im Messvolumen um {rms} µm rms, höchstens {largest} µm</translation>
    </message>
    <message>
        <source>Reference sphere</source>
        <translation>Referenzkugel</translation>
    </message>
    <message>
        <source>Reprojection error</source>
        <translation>Reprojektionsfehler</translation>
    </message>
    <message>
        <source>Right camera against the left, turned</source>
        <translation>Rechte Kamera gegen linke, gedreht</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Maßstab</translation>
    </message>
    <message>
        <source>Scale by a length measured on the print alone, to {ppm} ppm: no second length has verified it.</source>
        <translation>Maßstab nur nach einer am Druck gemessenen Länge, auf {ppm} ppm: Keine zweite Länge hat ihn bestätigt.</translation>
    </message>
    <message>
        <source>Scale not verified: no known length was shown, and the board&apos;s nominal size was believed ({ppm} ppm, k = 1).</source>
        <translation>Maßstab nicht bestätigt: Keine bekannte Länge wurde gezeigt, das Nennmaß der Tafel wurde geglaubt ({ppm} ppm, k = 1).</translation>
    </message>
    <message>
        <source>The board is bent: its corners lie within {bend_mm} mm of height; this is taken into account.</source>
        <translation>Die Tafel ist verbogen: Ihre Ecken liegen innerhalb von {bend_mm} mm Höhe; das ist berücksichtigt.</translation>
    </message>
    <message>
        <source>The print is {percent} % larger than its nominal size; this is corrected.</source>
        <translation>Der Druck ist {percent} % größer als sein Nennmaß; das ist berichtigt.</translation>
    </message>
    <message>
        <source>The print is {percent} % smaller than its nominal size; this is corrected.</source>
        <translation>Der Druck ist {percent} % kleiner als sein Nennmaß; das ist berichtigt.</translation>
    </message>
    <message>
        <source>The reference sphere measured {change} µm otherwise than in the tests before: calibrate and test it again.</source>
        <translation>Die Referenzkugel maß {change} µm anders als in den Prüfungen zuvor: kalibrieren und neu prüfen.</translation>
    </message>
    <message>
        <source>The table stood {error_deg} degrees off its reported angle at {table_deg} degrees: backlash or lost steps.</source>
        <translation>Der Teller stand bei {table_deg} Grad um {error_deg} Grad neben dem gemeldeten Winkel: Spiel oder verlorene Schritte.</translation>
    </message>
    <message>
        <source>This calibration is {n} days old and has expired: cameras creep. Calibrate before you measure.</source>
        <translation>Diese Kalibrierung ist {n} Tage alt und abgelaufen: Kameras driften. Vor dem Messen kalibrieren.</translation>
    </message>
    <message>
        <source>Turntable axis</source>
        <translation>Achse des Drehtellers</translation>
    </message>
    <message>
        <source>Turntable axis, turned</source>
        <translation>Achse des Drehtellers, gedreht</translation>
    </message>
    <message>
        <source>Valid: {n} days left</source>
        <translation>Gültig: noch {n} Tage</translation>
    </message>
    <message>
        <source>Views of the board</source>
        <translation>Ansichten der Tafel</translation>
    </message>
    <message>
        <source>by the print alone, not verified</source>
        <translation>nur durch den Druck, nicht bestätigt</translation>
    </message>
    <message>
        <source>more than three standard uncertainties of {u} µm explain: something has moved.</source>
        <translation>mehr, als drei Standardunsicherheiten von {u} µm erklären: Etwas hat sich bewegt.</translation>
    </message>
    <message>
        <source>not verified</source>
        <translation>nicht bestätigt</translation>
    </message>
    <message>
        <source>radius error {size} µm, D95 {d95} µm, {date}</source>
        <translation>Radiusfehler {size} µm, D95 {d95} µm, {date}</translation>
    </message>
    <message>
        <source>the previous one does not state its uncertainty.</source>
        <translation>die vorige nennt ihre Unsicherheit nicht.</translation>
    </message>
    <message>
        <source>verified by the {length} mm bar</source>
        <translation>bestätigt durch den {length}-mm-Stab</translation>
    </message>
    <message>
        <source>within three standard uncertainties of {u} µm each.</source>
        <translation>innerhalb von drei Standardunsicherheiten von je {u} µm.</translation>
    </message>
</context>
<context>
    <name>checks</name>
    <message>
        <source>beam axes</source>
        <translation>Strahlachsen</translation>
    </message>
    <message>
        <source>beam axis x</source>
        <translation>Strahlachse x</translation>
    </message>
    <message>
        <source>beam axis y</source>
        <translation>Strahlachse y</translation>
    </message>
    <message>
        <source>camera left</source>
        <translation>Kamera links</translation>
    </message>
    <message>
        <source>camera right</source>
        <translation>Kamera rechts</translation>
    </message>
    <message>
        <source>cameras</source>
        <translation>Kameras</translation>
    </message>
    <message>
        <source>controller</source>
        <translation>Steuerung</translation>
    </message>
    <message>
        <source>controller handshake</source>
        <translation>Steuerung: Verbindung</translation>
    </message>
    <message>
        <source>controller laser</source>
        <translation>Steuerung: Laser</translation>
    </message>
    <message>
        <source>controller laser left off</source>
        <translation>Steuerung: Laser bleibt aus</translation>
    </message>
    <message>
        <source>controller move</source>
        <translation>Steuerung: Bewegung</translation>
    </message>
    <message>
        <source>done</source>
        <translation>fertig</translation>
    </message>
    <message>
        <source>exposure</source>
        <translation>Belichtung</translation>
    </message>
    <message>
        <source>frame rate</source>
        <translation>Bildrate</translation>
    </message>
    <message>
        <source>frame rate left</source>
        <translation>Bildrate links</translation>
    </message>
    <message>
        <source>frame rate right</source>
        <translation>Bildrate rechts</translation>
    </message>
    <message>
        <source>laser seen</source>
        <translation>Laser gesehen</translation>
    </message>
    <message>
        <source>laser spot</source>
        <translation>Laserpunkt</translation>
    </message>
    <message>
        <source>left and right</source>
        <translation>links und rechts</translation>
    </message>
    <message>
        <source>rest of the rig</source>
        <translation>übriger Messplatz</translation>
    </message>
    <message>
        <source>table</source>
        <translation>Teller</translation>
    </message>
    <message>
        <source>trigger skew</source>
        <translation>Triggerversatz</translation>
    </message>
</context>
<context>
    <name>comparison</name>
    <message>
        <source>95 % below {p} mm, on {a} mm²</source>
        <translation>95 % unter {p} mm, auf {a} mm²</translation>
    </message>
    <message>
        <source>Aligning</source>
        <translation>Ausrichten</translation>
    </message>
    <message>
        <source>As they lie</source>
        <translation>Wie sie liegen</translation>
    </message>
    <message>
        <source>Change threshold</source>
        <translation>Schwelle ändern</translation>
    </message>
    <message>
        <source>Change unit</source>
        <translation>Einheit ändern</translation>
    </message>
    <message>
        <source>Change what is held fixed</source>
        <translation>Ändern, was festgehalten wird</translation>
    </message>
    <message>
        <source>Click the tooth in the picture: the mark grows to its edge, and its motion is told.</source>
        <translation>Den Zahn im Bild anklicken: Die Marke wächst bis zu seinem Rand, und seine Bewegung wird genannt.</translation>
    </message>
    <message>
        <source>Correct the marked tooth</source>
        <translation>Markierten Zahn berichtigen</translation>
    </message>
    <message>
        <source>Draw a line round what belongs to the tooth, too; only what is seen is added.</source>
        <translation>Eine Linie um das ziehen, was auch zum Zahn gehört; nur Sichtbares kommt hinzu.</translation>
    </message>
    <message>
        <source>Draw a line round what does not belong to the tooth; only what is seen is taken off.</source>
        <translation>Eine Linie um das ziehen, was nicht zum Zahn gehört; nur Sichtbares fällt weg.</translation>
    </message>
    <message>
        <source>Erase from the stable region</source>
        <translation>Vom stabilen Bereich wegradieren</translation>
    </message>
    <message>
        <source>Finding the areas</source>
        <translation>Flächen suchen</translation>
    </message>
    <message>
        <source>Load the surface after</source>
        <translation>Oberfläche nachher laden</translation>
    </message>
    <message>
        <source>Load the surface before</source>
        <translation>Oberfläche vorher laden</translation>
    </message>
    <message>
        <source>Looking for its edge…</source>
        <translation>Sein Rand wird gesucht…</translation>
    </message>
    <message>
        <source>Lower</source>
        <translation>Unterkiefer</translation>
    </message>
    <message>
        <source>Mark a tooth</source>
        <translation>Zahn markieren</translation>
    </message>
    <message>
        <source>Measuring its motion…</source>
        <translation>Seine Bewegung wird gemessen…</translation>
    </message>
    <message>
        <source>Measuring the distances</source>
        <translation>Abstände messen</translation>
    </message>
    <message>
        <source>Paint as stable</source>
        <translation>Als stabil malen</translation>
    </message>
    <message>
        <source>Paint with the left button what did not move, then align on it.</source>
        <translation>Mit der linken Taste malen, was sich nicht bewegt hat, dann daran ausrichten.</translation>
    </message>
    <message>
        <source>Painted region</source>
        <translation>Gemalter Bereich</translation>
    </message>
    <message>
        <source>Pick no points</source>
        <translation>Keine Punkte wählen</translation>
    </message>
    <message>
        <source>Pick three points on each</source>
        <translation>Je drei Punkte wählen</translation>
    </message>
    <message>
        <source>Remove a surface</source>
        <translation>Oberfläche entfernen</translation>
    </message>
    <message>
        <source>Remove the mark of the tooth</source>
        <translation>Marke des Zahns entfernen</translation>
    </message>
    <message>
        <source>Say which jaw it is</source>
        <translation>Angeben, welcher Kiefer es ist</translation>
    </message>
    <message>
        <source>Swap before and after</source>
        <translation>Vorher und nachher tauschen</translation>
    </message>
    <message>
        <source>Upper</source>
        <translation>Oberkiefer</translation>
    </message>
    <message>
        <source>What did not move</source>
        <translation>Unbewegtes</translation>
    </message>
    <message>
        <source>Whole surface</source>
        <translation>Ganze Oberfläche</translation>
    </message>
    <message>
        <source>Wipe with the left button over what may have moved, then align on the rest.</source>
        <translation>Mit der linken Taste über das wischen, was sich bewegt haben kann, dann am Rest ausrichten.</translation>
    </message>
    <message>
        <source>best fit of everything, also of what moved</source>
        <translation>beste Anpassung von allem, auch von Bewegtem</translation>
    </message>
    <message>
        <source>given</source>
        <translation>vorgegeben</translation>
    </message>
    <message>
        <source>moved {d} ± {u} mm, turned {a} ± {v}°</source>
        <translation>{d} ± {u} mm bewegt, {a} ± {v}° gedreht</translation>
    </message>
    <message>
        <source>no counterpart</source>
        <translation>kein Gegenstück</translation>
    </message>
    <message>
        <source>picked points</source>
        <translation>gewählte Punkte</translation>
    </message>
    <message>
        <source>point-pair features</source>
        <translation>Punktpaar-Merkmale</translation>
    </message>
    <message>
        <source>principal axes</source>
        <translation>Hauptachsen</translation>
    </message>
    <message>
        <source>the files share one frame; nothing is aligned</source>
        <translation>die Dateien teilen ein Koordinatensystem; nichts wird ausgerichtet</translation>
    </message>
    <message>
        <source>the stable region is found and held fixed</source>
        <translation>stabiler Bereich, selbst gefunden</translation>
    </message>
    <message>
        <source>what was painted is held fixed</source>
        <translation>was gemalt wurde, wird festgehalten</translation>
    </message>
    <message>
        <source>{n} mm inwards</source>
        <translation>{n} mm nach innen</translation>
    </message>
    <message>
        <source>{n} mm outwards</source>
        <translation>{n} mm nach außen</translation>
    </message>
    <message>
        <source>± {u} mm, turned {a} ± {v}°</source>
        <translation>± {u} mm, {a} ± {v}° gedreht</translation>
    </message>
</context>
<context>
    <name>coverage</name>
    <message>
        <source>Dust it with a matt powder, or expose shorter.</source>
        <translation>Mit mattem Puder bestäuben oder kürzer belichten.</translation>
    </message>
    <message>
        <source>Dust it with a matt white powder, or expose longer.</source>
        <translation>Mit mattem weißem Puder bestäuben oder länger belichten.</translation>
    </message>
    <message>
        <source>Fill it now.</source>
        <translation>Jetzt ergänzen.</translation>
    </message>
    <message>
        <source>Following the light to every place…</source>
        <translation>Dem Licht wird an jede Stelle gefolgt…</translation>
    </message>
    <message>
        <source>Looking for a better way to set the object down…</source>
        <translation>Eine bessere Aufstellung wird gesucht…</translation>
    </message>
    <message>
        <source>Move the object to the middle of the table.</source>
        <translation>Das Objekt in die Mitte des Tellers stellen.</translation>
    </message>
    <message>
        <source>On the side</source>
        <translation>An der Seite</translation>
    </message>
    <message>
        <source>On top</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>Put the object down in another way.</source>
        <translation>Das Objekt anders aufstellen.</translation>
    </message>
    <message>
        <source>Reading the case…</source>
        <translation>Fall wird gelesen…</translation>
    </message>
    <message>
        <source>Tilt the object by about {deg}°.</source>
        <translation>Das Objekt um etwa {deg}° kippen.</translation>
    </message>
    <message>
        <source>Turn the object over, or tilt it by about {deg}°.</source>
        <translation>Das Objekt umdrehen oder um etwa {deg}° kippen.</translation>
    </message>
    <message>
        <source>Turn the object upside down.</source>
        <translation>Das Objekt auf den Kopf stellen.</translation>
    </message>
    <message>
        <source>Underneath</source>
        <translation>Unten</translation>
    </message>
    <message>
        <source>With the table at {turn:.0f}°, tip the top of the object by about {tip:.0f}° towards the cameras.</source>
        <translation>Bei Teller auf {turn:.0f}° die Oberseite des Objekts um etwa {tip:.0f}° zu den Kameras kippen.</translation>
    </message>
    <message>
        <source>as wanted</source>
        <translation>wie gewünscht</translation>
    </message>
    <message>
        <source>faces the laser at {deg}°</source>
        <translation>steht {deg}° zum Laser</translation>
    </message>
    <message>
        <source>hidden from the laser by the object</source>
        <translation>vom Objekt vor dem Laser verdeckt</translation>
    </message>
    <message>
        <source>hidden from the left camera by the object</source>
        <translation>vom Objekt vor der linken Kamera verdeckt</translation>
    </message>
    <message>
        <source>hidden from the right camera by the object</source>
        <translation>vom Objekt vor der rechten Kamera verdeckt</translation>
    </message>
    <message>
        <source>looks down or lies on the table</source>
        <translation>blickt nach unten oder liegt auf dem Teller</translation>
    </message>
    <message>
        <source>never seen by both cameras at once</source>
        <translation>nie von beiden Kameras zugleich gesehen</translation>
    </message>
    <message>
        <source>no points</source>
        <translation>keine Punkte</translation>
    </message>
    <message>
        <source>outside of the pictures or the volume</source>
        <translation>außerhalb der Bilder oder des Messvolumens</translation>
    </message>
    <message>
        <source>seen too flatly at every angle</source>
        <translation>aus jedem Winkel zu flach gesehen</translation>
    </message>
    <message>
        <source>the spot is too bright there</source>
        <translation>der Laserpunkt ist dort zu hell</translation>
    </message>
    <message>
        <source>the spot is too dark there</source>
        <translation>der Laserpunkt ist dort zu dunkel</translation>
    </message>
    <message>
        <source>too few points</source>
        <translation>zu wenige Punkte</translation>
    </message>
    <message>
        <source>up to {um} µm</source>
        <translation>bis {um} µm</translation>
    </message>
    <message>
        <source>{gained:.0f} of {unreached:.0f} mm² that are hidden now come into view; {share:.0f} % of what is seen then is known already.</source>
        <translation>{gained:.0f} von {unreached:.0f} mm², die jetzt verdeckt sind, werden sichtbar; {share:.0f} % des dann Sichtbaren sind schon bekannt.</translation>
    </message>
    <message>
        <source>{mm2} mm²</source>
        <translation>{mm2} mm²</translation>
    </message>
    <message>
        <source>{mm} mm up</source>
        <translation>{mm} mm hoch</translation>
    </message>
</context>
<context>
    <name>delivery</name>
    <message>
        <source>2-manifold</source>
        <translation>2-Mannigfaltigkeit</translation>
    </message>
    <message>
        <source>3MF, carries its unit</source>
        <translation>3MF, trägt seine Einheit</translation>
    </message>
    <message>
        <source>A person accepted {count} holes or thin places as they are.</source>
        <translation>Eine Person hat {count} Lücken oder dünn belegte Stellen so angenommen.</translation>
    </message>
    <message>
        <source>A person took out {count} measured points, {percent} % of all.</source>
        <translation>Eine Person hat {count} Messpunkte herausgenommen, {percent} % von allen.</translation>
    </message>
    <message>
        <source>A person took out {count} measured points.</source>
        <translation>Eine Person hat {count} Messpunkte herausgenommen.</translation>
    </message>
    <message>
        <source>Accepted places</source>
        <translation>Angenommene Stellen</translation>
    </message>
    <message>
        <source>All triangles face outwards.</source>
        <translation>Alle Dreiecke zeigen nach außen.</translation>
    </message>
    <message>
        <source>Another ear of this order is labelled {side} too, and yet the two mirror each other. Is one of them labelled wrongly?</source>
        <translation>Ein anderes Ohr dieses Auftrags ist auch als „{side}“ bezeichnet, und doch spiegeln sich die beiden. Ist eines falsch bezeichnet?</translation>
    </message>
    <message>
        <source>Archive (PLY with uncertainty, and points)</source>
        <translation>Archiv (PLY mit Unsicherheit, und Punkte)</translation>
    </message>
    <message>
        <source>As it was scanned</source>
        <translation>Wie gescannt</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Kalibrierung</translation>
    </message>
    <message>
        <source>Calibration {id} of {date} had expired {days} days before the scan. Calibrate, compute the points anew or scan again.</source>
        <translation>Kalibrierung {id} vom {date} war {days} Tage vor dem Scan abgelaufen. Kalibrieren, Punkte neu berechnen oder neu scannen.</translation>
    </message>
    <message>
        <source>Calibration {id} of {date} was off by {error_um} µm on corners that it had not seen, more than {limit_um} µm.</source>
        <translation>Kalibrierung {id} vom {date} lag an nicht benutzten Ecken um {error_um} µm daneben, mehr als {limit_um} µm.</translation>
    </message>
    <message>
        <source>Calibration {id} of {date} was valid at the scan for {days} more days only; calibrate before the next order.</source>
        <translation>Kalibrierung {id} vom {date} war beim Scan nur noch {days} Tage gültig; vor dem nächsten Auftrag kalibrieren.</translation>
    </message>
    <message>
        <source>Calibration {id} of {date} was valid at the scan, but no known length has verified its scale.</source>
        <translation>Kalibrierung {id} vom {date} war beim Scan gültig, aber keine bekannte Länge hat ihren Maßstab bestätigt.</translation>
    </message>
    <message>
        <source>Calibration {id} of {date} was valid at the scan, its scale verified; held-out error {error_um} µm.</source>
        <translation>Kalibrierung {id} vom {date} war beim Scan gültig, ihr Maßstab bestätigt; Fehler an nicht benutzten Ecken {error_um} µm.</translation>
    </message>
    <message>
        <source>Canal tip up</source>
        <translation>Gehörgangspitze oben</translation>
    </message>
    <message>
        <source>Centimetres</source>
        <translation>Zentimeter</translation>
    </message>
    <message>
        <source>Closed</source>
        <translation>Geschlossen</translation>
    </message>
    <message>
        <source>Closure of the turn</source>
        <translation>Ringschluss</translation>
    </message>
    <message>
        <source>Coverage</source>
        <translation>Abdeckung</translation>
    </message>
    <message>
        <source>Dental model (STL, occlusal plane XY)</source>
        <translation>Dentalmodell (STL, Okklusionsebene XY)</translation>
    </message>
    <message>
        <source>Ear shell laboratory (STL)</source>
        <translation>Otoplastiklabor (STL)</translation>
    </message>
    <message>
        <source>Every edge and every vertex lies on one sheet of surface.</source>
        <translation>Jede Kante und jeder Eckpunkt liegt auf einem einzigen Flächenblatt.</translation>
    </message>
    <message>
        <source>Every edge belongs to two triangles.</source>
        <translation>Jede Kante gehört zu zwei Dreiecken.</translation>
    </message>
    <message>
        <source>Expected error</source>
        <translation>Erwarteter Fehler</translation>
    </message>
    <message>
        <source>Facing outwards</source>
        <translation>Nach außen gerichtet</translation>
    </message>
    <message>
        <source>How far this surface is off is not recorded; it was not reconstructed by this program.</source>
        <translation>Wie weit diese Oberfläche daneben liegt, ist nicht vermerkt; sie wurde nicht mit diesem Programm rekonstruiert.</translation>
    </message>
    <message>
        <source>Inches</source>
        <translation>Zoll</translation>
    </message>
    <message>
        <source>It consists of {count} separate pieces. Remove what does not belong to the object, and reconstruct again.</source>
        <translation>Sie besteht aus {count} getrennten Teilen. Entfernen, was nicht zum Objekt gehört, und neu rekonstruieren.</translation>
    </message>
    <message>
        <source>It is one piece.</source>
        <translation>Sie ist ein Stück.</translation>
    </message>
    <message>
        <source>It is {longest_mm} x {middle_mm} x {shortest_mm} mm large, as {kind} is.</source>
        <translation>Sie ist {longest_mm} x {middle_mm} x {shortest_mm} mm groß, wie {kind} es ist.</translation>
    </message>
    <message>
        <source>It is {longest_mm} x {middle_mm} x {shortest_mm} mm large; {kind} is {least_mm} to {most_mm} mm long. Are unit and type right?</source>
        <translation>Sie ist {longest_mm} x {middle_mm} x {shortest_mm} mm groß; {kind} ist {least_mm} bis {most_mm} mm lang. Stimmen Einheit und Typ?</translation>
    </message>
    <message>
        <source>It is {longest_mm} x {middle_mm} x {shortest_mm} mm large; {kind} is {least_mm} to {most_mm} mm long. Is it whole, and alone?</source>
        <translation>Sie ist {longest_mm} x {middle_mm} x {shortest_mm} mm groß; {kind} ist {least_mm} bis {most_mm} mm lang. Ist sie ganz, und allein?</translation>
    </message>
    <message>
        <source>It mirrors the other ear: {mirrored_um} µm apart mirrored, {direct_um} µm as it is.</source>
        <translation>Es spiegelt das andere Ohr: gespiegelt {mirrored_um} µm Abstand, ungespiegelt {direct_um} µm.</translation>
    </message>
    <message>
        <source>Marks on the table</source>
        <translation>Marken am Drehteller</translation>
    </message>
    <message>
        <source>Metres</source>
        <translation>Meter</translation>
    </message>
    <message>
        <source>Millimetres</source>
        <translation>Millimeter</translation>
    </message>
    <message>
        <source>Modelling (OBJ)</source>
        <translation>Modellieren (OBJ)</translation>
    </message>
    <message>
        <source>Mount {mount} is not part of the surface: it could not be brought together with the others.</source>
        <translation>Aufstellung {mount} ist nicht Teil der Oberfläche: Sie ließ sich nicht mit den anderen zusammenführen.</translation>
    </message>
    <message>
        <source>Mounts</source>
        <translation>Aufstellungen</translation>
    </message>
    <message>
        <source>No hole or thin place had to be accepted.</source>
        <translation>Keine Lücke oder dünn belegte Stelle musste angenommen werden.</translation>
    </message>
    <message>
        <source>No measured point was taken out.</source>
        <translation>Kein Messpunkt wurde herausgenommen.</translation>
    </message>
    <message>
        <source>No self-intersections</source>
        <translation>Ohne Selbstdurchdringung</translation>
    </message>
    <message>
        <source>No size is expected of an object of this type; it is {longest_mm} x {middle_mm} x {shortest_mm} mm large.</source>
        <translation>Für diesen Typ wird keine Größe erwartet; sie ist {longest_mm} x {middle_mm} x {shortest_mm} mm groß.</translation>
    </message>
    <message>
        <source>No triangle runs through another one.</source>
        <translation>Kein Dreieck durchdringt ein anderes.</translation>
    </message>
    <message>
        <source>Not checked: the other ear of this order is not there yet.</source>
        <translation>Nicht geprüft: Das andere Ohr dieses Auftrags ist noch nicht da.</translation>
    </message>
    <message>
        <source>Not ready</source>
        <translation>Nicht bereit</translation>
    </message>
    <message>
        <source>Occlusal plane XY, +Z to occlusal</source>
        <translation>Okklusionsebene XY, +Z nach okklusal</translation>
    </message>
    <message>
        <source>Of which points this surface was made is not recorded.</source>
        <translation>Aus welchen Punkten diese Oberfläche entstand, ist nicht vermerkt.</translation>
    </message>
    <message>
        <source>One shell</source>
        <translation>Eine Schale</translation>
    </message>
    <message>
        <source>Only {percent} % of the surface beside its base rests on measured points: too much of it is a guess. Scan the rest first.</source>
        <translation>Nur {percent} % der Oberfläche außer der Basis sind von Messpunkten belegt: Zu viel ist Vermutung. Zuerst den Rest scannen.</translation>
    </message>
    <message>
        <source>Only {percent} % of the surface beside its base rests on measured points; the rest is a guess. Fill the holes, or say so.</source>
        <translation>Nur {percent} % der Oberfläche außer der Basis sind von Messpunkten belegt; der Rest ist Vermutung. Lücken ergänzen oder es angeben.</translation>
    </message>
    <message>
        <source>PLY, with uncertainty and support</source>
        <translation>PLY, mit Unsicherheit und Beleg</translation>
    </message>
    <message>
        <source>Points taken out</source>
        <translation>Herausgenommene Punkte</translation>
    </message>
    <message>
        <source>Printing (3MF)</source>
        <translation>Drucken (3MF)</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>Bereit</translation>
    </message>
    <message>
        <source>Ready, with remarks</source>
        <translation>Bereit, mit Hinweisen</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>The first view was not measured again, and the views of the turn agree only to {closure_um} µm.</source>
        <translation>Die erste Ansicht wurde nicht noch einmal gemessen, und die Ansichten der Drehung stimmen nur auf {closure_um} µm überein.</translation>
    </message>
    <message>
        <source>The first view was not measured again; the views of the turn agree to {closure_um} µm.</source>
        <translation>Die erste Ansicht wurde nicht noch einmal gemessen; die Ansichten der Drehung stimmen auf {closure_um} µm überein.</translation>
    </message>
    <message>
        <source>The first view, measured again after the turn, lies {closure_um} µm off, more than {limit_um} µm: something moved a little.</source>
        <translation>Die erste Ansicht, nach der Drehung noch einmal gemessen, liegt {closure_um} µm daneben, mehr als {limit_um} µm: Etwas hat sich leicht bewegt.</translation>
    </message>
    <message>
        <source>The first view, measured again at the end of the turn, lies {closure_um} µm beside its first measurement.</source>
        <translation>Die erste Ansicht, am Ende der Drehung noch einmal gemessen, liegt {closure_um} µm neben ihrer ersten Messung.</translation>
    </message>
    <message>
        <source>The marks on the table&apos;s rim kept their distances to {marks_um} µm only, more than {limit_um} µm: something moved.</source>
        <translation>Die Marken am Tellerrand hielten ihre Abstände nur auf {marks_um} µm, mehr als {limit_um} µm: Etwas hat sich bewegt.</translation>
    </message>
    <message>
        <source>The marks on the table&apos;s rim kept their distances to {marks_um} µm.</source>
        <translation>Die Marken am Tellerrand hielten ihre Abstände auf {marks_um} µm.</translation>
    </message>
    <message>
        <source>The measured surface is expected to be off by {error_um} µm rms; the points scatter by {residual_um} µm about it.</source>
        <translation>Die gemessene Oberfläche liegt voraussichtlich {error_um} µm rms daneben; die Punkte streuen um sie mit {residual_um} µm.</translation>
    </message>
    <message>
        <source>The order does not say which ear it is.</source>
        <translation>Der Auftrag sagt nicht, welches Ohr es ist.</translation>
    </message>
    <message>
        <source>The order does not say which jaw it is.</source>
        <translation>Der Auftrag sagt nicht, welcher Kiefer es ist.</translation>
    </message>
    <message>
        <source>The points were changed after this surface was made of them. Reconstruct again.</source>
        <translation>Die Punkte wurden geändert, nachdem diese Oberfläche aus ihnen entstand. Neu rekonstruieren.</translation>
    </message>
    <message>
        <source>The scan had no marks on the table&apos;s rim to watch over it.</source>
        <translation>Der Scan hatte keine Marken am Tellerrand, die über ihn wachten.</translation>
    </message>
    <message>
        <source>The surface has {count} open edges; a printer may fill it wrongly. Reconstruct again with closed holes.</source>
        <translation>Die Oberfläche hat {count} offene Kanten; ein Drucker füllt sie womöglich falsch. Mit geschlossenen Lücken neu rekonstruieren.</translation>
    </message>
    <message>
        <source>The surface is expected to be off by {error_um} µm rms, more than {limit_um} µm. More points, or a calibration, would help.</source>
        <translation>Die Oberfläche liegt voraussichtlich {error_um} µm rms daneben, mehr als {limit_um} µm. Mehr Punkte oder eine Kalibrierung würden helfen.</translation>
    </message>
    <message>
        <source>The surface is expected to be off by {error_um} µm rms, more than {limit_um} µm: it was kept early. Reconstruct it to its end.</source>
        <translation>Die Oberfläche liegt voraussichtlich {error_um} µm rms daneben, mehr als {limit_um} µm: sie wurde vorzeitig behalten. Bis zum Ende rekonstruieren.</translation>
    </message>
    <message>
        <source>The surface is expected to be off by {error_um} µm rms: too much for a shell. Calibrate, and scan again.</source>
        <translation>Die Oberfläche liegt voraussichtlich {error_um} µm rms daneben: zu viel für eine Otoplastik. Kalibrieren und neu scannen.</translation>
    </message>
    <message>
        <source>The surface touches itself at {count} places. Reconstruct again.</source>
        <translation>Die Oberfläche berührt sich an {count} Stellen selbst. Neu rekonstruieren.</translation>
    </message>
    <message>
        <source>The surface was made of the points as they are now.</source>
        <translation>Die Oberfläche entstand aus den Punkten, wie sie jetzt sind.</translation>
    </message>
    <message>
        <source>The turn does not close: the first view, measured again, lies {closure_um} µm off. Object or camera moved; scan again.</source>
        <translation>Die Drehung schließt sich nicht: Die erste Ansicht, noch einmal gemessen, liegt {closure_um} µm daneben. Objekt oder Kamera hat sich bewegt; neu scannen.</translation>
    </message>
    <message>
        <source>The two ears do not mirror each other ({direct_um} µm apart as they are, {mirrored_um} µm mirrored). Is one labelled wrongly?</source>
        <translation>Die beiden Ohren spiegeln sich nicht (ungespiegelt {direct_um} µm Abstand, gespiegelt {mirrored_um} µm). Ist eines falsch bezeichnet?</translation>
    </message>
    <message>
        <source>There is no other side to compare with.</source>
        <translation>Es gibt keine andere Seite zum Vergleichen.</translation>
    </message>
    <message>
        <source>There is one mount; nothing had to be brought together.</source>
        <translation>Es gibt eine Aufstellung; nichts musste zusammengeführt werden.</translation>
    </message>
    <message>
        <source>Triangles face inwards or against their neighbours. Reconstruct again.</source>
        <translation>Dreiecke zeigen nach innen oder gegen ihre Nachbarn. Neu rekonstruieren.</translation>
    </message>
    <message>
        <source>Up to date</source>
        <translation>Aktuell</translation>
    </message>
    <message>
        <source>Whether it mirrors the other ear cannot be told ({mirrored_um} µm apart mirrored, {direct_um} µm as it is). Look at both.</source>
        <translation>Ob es das andere Ohr spiegelt, lässt sich nicht sagen (gespiegelt {mirrored_um} µm Abstand, ungespiegelt {direct_um} µm). Beide ansehen.</translation>
    </message>
    <message>
        <source>Whether the turn closes was not measured.</source>
        <translation>Ob sich die Drehung schließt, wurde nicht gemessen.</translation>
    </message>
    <message>
        <source>Which part of this surface was measured is not recorded.</source>
        <translation>Welcher Teil dieser Oberfläche gemessen wurde, ist nicht vermerkt.</translation>
    </message>
    <message>
        <source>With which calibration this surface was measured is not recorded.</source>
        <translation>Mit welcher Kalibrierung diese Oberfläche gemessen wurde, ist nicht vermerkt.</translation>
    </message>
    <message>
        <source>a dental arch</source>
        <translation>ein Zahnbogen</translation>
    </message>
    <message>
        <source>an ear impression</source>
        <translation>eine Ohrabformung</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>nicht bestanden</translation>
    </message>
    <message>
        <source>not checked</source>
        <translation>nicht geprüft</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>bestanden</translation>
    </message>
    <message>
        <source>remark</source>
        <translation>Hinweis</translation>
    </message>
    <message>
        <source>{count} mounts lie on each other to {residual_um} µm only, more than {limit_um} µm.</source>
        <translation>{count} Aufstellungen liegen nur auf {residual_um} µm aufeinander, mehr als {limit_um} µm.</translation>
    </message>
    <message>
        <source>{count} mounts lie on each other to {residual_um} µm.</source>
        <translation>{count} Aufstellungen liegen auf {residual_um} µm aufeinander.</translation>
    </message>
    <message>
        <source>{count} triangles run through others. Reconstruct again, with less detail if need be.</source>
        <translation>{count} Dreiecke durchdringen andere. Neu rekonstruieren, nötigenfalls mit weniger Details.</translation>
    </message>
    <message>
        <source>{percent} % of the surface beside its base rests on measured points.</source>
        <translation>{percent} % der Oberfläche außer der Basis sind von Messpunkten belegt.</translation>
    </message>
</context>
<context>
    <name>doubts</name>
    <message>
        <source>1 triangle has no area; it has no normal and is measured only by its neighbours.</source>
        <translation>1 Dreieck hat keine Fläche; es hat keine Normale und wird nur über seine Nachbarn gemessen.</translation>
    </message>
    <message>
        <source>A best fit of the whole spreads what moved over everything: against the region that did not move it shifts the surface by up to {length}. Use the automatic or a painted frame.</source>
        <translation>Eine beste Anpassung des Ganzen verteilt die Bewegung auf alles: Gegen den unbewegten Bereich verschiebt sie die Oberfläche um bis zu {length}. Den automatischen oder einen gemalten Bezug nehmen.</translation>
    </message>
    <message>
        <source>Another pose fits about as well, because the shape resembles itself: pick three points to say which one is meant.</source>
        <translation>Eine andere Lage passt etwa ebenso gut, weil die Form sich selbst ähnelt: drei Punkte wählen, um zu sagen, welche gemeint ist.</translation>
    </message>
    <message>
        <source>By its order {before} is &apos;{first}&apos;, but {after} &apos;{second}&apos;; choose two that belong together.</source>
        <translation>Laut Auftrag ist {before} „{first}“, {after} aber „{second}“; zwei wählen, die zusammengehören.</translation>
    </message>
    <message>
        <source>By its order {before} is of the side &apos;{first}&apos;, but {after} &apos;{second}&apos;; choose two that belong together.</source>
        <translation>Laut Auftrag ist {before} von der Seite „{first}“, {after} aber „{second}“; zwei wählen, die zusammengehören.</translation>
    </message>
    <message>
        <source>Edges that belong to more than two triangles: {edges}; corners that join separate parts: {corners}. Inside and outside are not defined there.</source>
        <translation>Kanten mit mehr als zwei Dreiecken: {edges}; Ecken, die getrennte Teile verbinden: {corners}. Innen und außen sind dort nicht bestimmt.</translation>
    </message>
    <message>
        <source>Hardly anything ({percent} % of the surface) kept its place, so geometry does not say what is fixed: paint what you know to be stable.</source>
        <translation>Kaum etwas ({percent} % der Oberfläche) behielt seinen Platz, die Form sagt also nicht, was fest ist: malen, was sicher stabil ist.</translation>
    </message>
    <message>
        <source>It consists of {count} separate shells; the largest has {share} of the area. All of them are compared.</source>
        <translation>Sie besteht aus {count} getrennten Schalen; die größte hat {share} der Fläche. Alle werden verglichen.</translation>
    </message>
    <message>
        <source>It is open: its border has {mm} mm in one line. What lies beyond a border has no counterpart and is left out.</source>
        <translation>Sie ist offen: Ihr Rand misst {mm} mm in einer Linie. Was jenseits eines Rands liegt, hat kein Gegenstück und bleibt weg.</translation>
    </message>
    <message>
        <source>It is open: its border has {mm} mm in {count} lines. What lies beyond a border has no counterpart and is left out.</source>
        <translation>Sie ist offen: Ihr Rand misst {mm} mm in {count} Linien. Was jenseits eines Rands liegt, hat kein Gegenstück und bleibt weg.</translation>
    </message>
    <message>
        <source>It is {mm} mm long, which neither an arch nor an ear is; check the unit of the file.</source>
        <translation>Sie ist {mm} mm lang, was weder Zahnbogen noch Ohr ist; die Einheit der Datei prüfen.</translation>
    </message>
    <message>
        <source>It touches or crosses itself: more than {count} triangles cut others. Distances near them may go to the wrong layer.</source>
        <translation>Sie berührt oder durchdringt sich: Mehr als {count} Dreiecke schneiden andere. Abstände in ihrer Nähe können zur falschen Schicht führen.</translation>
    </message>
    <message>
        <source>It touches or crosses itself: {count} triangles cut others. Distances near them may go to the wrong layer.</source>
        <translation>Sie berührt oder durchdringt sich: {count} Dreiecke schneiden andere. Abstände in ihrer Nähe können zur falschen Schicht führen.</translation>
    </message>
    <message>
        <source>Its normals point inwards: + and - would be exchanged; turn them round in the program that wrote it.</source>
        <translation>Ihre Normalen zeigen nach innen: + und - wären vertauscht; im Programm, das sie schrieb, umkehren.</translation>
    </message>
    <message>
        <source>Its normals point inwards: they look to the side of the gum, not of the teeth. If it is no impression (a negative), + and - are exchanged; turn them round in the program that wrote it.</source>
        <translation>Ihre Normalen zeigen nach innen: zur Seite des Zahnfleischs, nicht der Zähne. Ist es keine Abformung (ein Negativ), sind + und - vertauscht; im Programm, das sie schrieb, umkehren.</translation>
    </message>
    <message>
        <source>Its normals seem to point inwards: it is open, but what it encloses lies on their side. If it is no impression (a negative), + and - are exchanged; turn them round in the program that wrote it.</source>
        <translation>Ihre Normalen scheinen nach innen zu zeigen: Sie ist offen, aber was sie umschließt, liegt auf deren Seite. Ist es keine Abformung (ein Negativ), sind + und - vertauscht; im Programm, das sie schrieb, umkehren.</translation>
    </message>
    <message>
        <source>Its numbers were taken as {unit} ({why}), so it is {mm} mm long; say the unit if that is wrong.</source>
        <translation>Ihre Zahlen wurden als {unit} genommen ({why}), sie ist also {mm} mm lang; ist das falsch, die Einheit angeben.</translation>
    </message>
    <message>
        <source>No region was stable throughout the series; each surface was aligned by a region of its own, so small motions may not add up.</source>
        <translation>Kein Bereich war durch die ganze Serie stabil; jede Oberfläche wurde an einem eigenen Bereich ausgerichtet, kleine Bewegungen summieren sich also womöglich nicht.</translation>
    </message>
    <message>
        <source>Only {percent} % of the after surface has a counterpart before: scan the same region both times.</source>
        <translation>Nur {percent} % der Oberfläche nachher haben vorher ein Gegenstück: beide Male denselben Bereich scannen.</translation>
    </message>
    <message>
        <source>Points that belong to no triangle were left out: {count}.</source>
        <translation>Punkte ohne Dreieck blieben weg: {count}.</translation>
    </message>
    <message>
        <source>Points with exactly the place of another one were joined: {count}.</source>
        <translation>Punkte an genau derselben Stelle wurden zusammengefasst: {count}.</translation>
    </message>
    <message>
        <source>Some triangles ({share} of its area) face the other way than their neighbours; + and - are exchanged there.</source>
        <translation>Einige Dreiecke ({share} der Fläche) zeigen anders als ihre Nachbarn; dort sind + und - vertauscht.</translation>
    </message>
    <message>
        <source>The after surface is {percent} % (+- {uncertainty} %) larger than the before surface where nothing should have changed, {length} at its rim: check units and the calibration of both scanners; nothing was rescaled.</source>
        <translation>Die Oberfläche nachher ist {percent} % (+- {uncertainty} %) größer als die vorher, wo sich nichts geändert haben sollte, am Rand {length}: Einheiten und Kalibrierung beider Scanner prüfen; nichts wurde skaliert.</translation>
    </message>
    <message>
        <source>The after surface is {percent} % (+- {uncertainty} %) smaller than the before surface where nothing should have changed, {length} at its rim: check units and the calibration of both scanners; nothing was rescaled.</source>
        <translation>Die Oberfläche nachher ist {percent} % (+- {uncertainty} %) kleiner als die vorher, wo sich nichts geändert haben sollte, am Rand {length}: Einheiten und Kalibrierung beider Scanner prüfen; nichts wurde skaliert.</translation>
    </message>
    <message>
        <source>The alignment rests on {mm2} mm2, {percent} % of the surface that both files show: look whether the region drawn as stable is, or paint it.</source>
        <translation>Die Ausrichtung ruht auf {mm2} mm², {percent} % der in beiden Dateien gezeigten Oberfläche: prüfen, ob der als stabil gezeichnete Bereich es ist, oder ihn malen.</translation>
    </message>
    <message>
        <source>The file says {unit}, so it is {mm} mm long; by its size it would be in {guess}.</source>
        <translation>Die Datei sagt {unit}, sie ist also {mm} mm lang; nach ihrer Größe wäre sie in {guess}.</translation>
    </message>
    <message>
        <source>The later surface is {ratio} times as large as the earlier one; check the units ({units} differ by {factor}), or whether the two belong together.</source>
        <translation>Die spätere Oberfläche ist {ratio}-mal so groß wie die frühere; die Einheiten prüfen ({units} unterscheiden sich um {factor}), oder ob beide zusammengehören.</translation>
    </message>
    <message>
        <source>The later surface is {ratio} times as large as the earlier one; check the units, or whether the two belong together.</source>
        <translation>Die spätere Oberfläche ist {ratio}-mal so groß wie die frühere; die Einheiten prüfen, oder ob beide zusammengehören.</translation>
    </message>
    <message>
        <source>The material was not named; of the rig&apos;s null comparisons the largest level is shown (&apos;{other}&apos;).</source>
        <translation>Das Material wurde nicht genannt; gezeigt ist die größte Grenze der Nullvergleiche des Messplatzes („{other}“).</translation>
    </message>
    <message>
        <source>The null comparison is of the rig &apos;{rig}&apos;, but the surfaces were measured with &apos;{others}&apos;.</source>
        <translation>Der Nullvergleich ist vom Messplatz „{rig}“, die Oberflächen wurden aber mit „{others}“ gemessen.</translation>
    </message>
    <message>
        <source>The null comparison of &apos;{material}&apos; ({date}) is older than the rig&apos;s calibration ({calibrated}); repeat it.</source>
        <translation>Der Nullvergleich von „{material}“ ({date}) ist älter als die Kalibrierung des Messplatzes ({calibrated}); wiederholen.</translation>
    </message>
    <message>
        <source>The orders of {before} and {after} name different patients; choose two of one patient.</source>
        <translation>Die Aufträge von {before} und {after} nennen verschiedene Patienten; zwei von einem Patienten wählen.</translation>
    </message>
    <message>
        <source>The stable region lies too much in one lump to hold the far end of the surface, which may be off by {length}: take in stable places that are farther apart.</source>
        <translation>Der stabile Bereich liegt zu sehr an einem Fleck, um das ferne Ende der Oberfläche zu halten, das um {length} daneben liegen kann: weiter auseinander liegende stabile Stellen hinzunehmen.</translation>
    </message>
    <message>
        <source>This rig has no null comparison of &apos;{material}&apos;; the level shown is of another material, &apos;{other}&apos;. Measure one twice.</source>
        <translation>Dieser Messplatz hat keinen Nullvergleich von „{material}“; die gezeigte Grenze ist von einem anderen Material, „{other}“. Eines zweimal messen.</translation>
    </message>
    <message>
        <source>Triangles without an extent but a line or point were left out: {count}.</source>
        <translation>Dreiecke, die nur Linie oder Punkt sind, blieben weg: {count}.</translation>
    </message>
    <message>
        <source>What is taken for unchanged differs by up to {length} (95 %): either the scans are that noisy, or it changed everywhere and nothing is fixed. Smaller changes cannot be told.</source>
        <translation>Was als unverändert gilt, weicht um bis zu {length} ab (95 %): Entweder rauschen die Scans so stark, oder es änderte sich überall und nichts ist fest. Kleinere Änderungen sind nicht erkennbar.</translation>
    </message>
    <message>
        <source>{before} and {after} are identical files: nothing was measured twice; choose the other state.</source>
        <translation>{before} und {after} sind gleiche Dateien: Nichts wurde zweimal gemessen; den anderen Zustand wählen.</translation>
    </message>
    <message>
        <source>{before} and {after} hold the identical surface: nothing was measured twice; choose the other state.</source>
        <translation>{before} und {after} enthalten dieselbe Oberfläche: Nichts wurde zweimal gemessen; den anderen Zustand wählen.</translation>
    </message>
    <message>
        <source>{before} was measured after {after} ({first} and {second}): are the two exchanged?</source>
        <translation>{before} wurde nach {after} gemessen ({first} und {second}): Sind die beiden vertauscht?</translation>
    </message>
    <message>
        <source>{count} triangles have no area; they have no normal and are measured only by their neighbours.</source>
        <translation>{count} Dreiecke haben keine Fläche; sie haben keine Normale und werden nur über ihre Nachbarn gemessen.</translation>
    </message>
    <message>
        <source>{name} lands {closure} um beside its place when it goes over {previous} (+- {uncertainty} um, k = 2): what is taken as stable may have moved.</source>
        <translation>{name} landet {closure} um neben seinem Platz, wenn es über {previous} geht (+- {uncertainty} um, k = 2): Was als stabil gilt, hat sich womöglich bewegt.</translation>
    </message>
    <message>
        <source>{share} of its area faces the other way than its neighbours, so + and - cannot be told apart; let the program that wrote it orient it.</source>
        <translation>{share} der Fläche zeigen anders als die Nachbarn, + und - sind also nicht zu unterscheiden; im Programm, das sie schrieb, ausrichten lassen.</translation>
    </message>
</context>
<context>
    <name>draft</name>
    <message>
        <source>Accept a place as it is</source>
        <translation>Stelle annehmen, wie sie ist</translation>
    </message>
    <message>
        <source>Back to the defaults</source>
        <translation>Zurück zu den Vorgaben</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>Beide</translation>
    </message>
    <message>
        <source>Bring points back</source>
        <translation>Punkte zurückholen</translation>
    </message>
    <message>
        <source>Change detail</source>
        <translation>Detailgrad ändern</translation>
    </message>
    <message>
        <source>Change number of points</source>
        <translation>Punktzahl ändern</translation>
    </message>
    <message>
        <source>Change number of triangles</source>
        <translation>Zahl der Dreiecke ändern</translation>
    </message>
    <message>
        <source>Change number of views</source>
        <translation>Zahl der Ansichten ändern</translation>
    </message>
    <message>
        <source>Change open or closed base</source>
        <translation>Basis offen oder geschlossen</translation>
    </message>
    <message>
        <source>Change pass-band</source>
        <translation>Durchlassbereich ändern</translation>
    </message>
    <message>
        <source>Change seed</source>
        <translation>Startwert ändern</translation>
    </message>
    <message>
        <source>Change side</source>
        <translation>Seite ändern</translation>
    </message>
    <message>
        <source>Change smoothing</source>
        <translation>Glättung ändern</translation>
    </message>
    <message>
        <source>Change support threshold</source>
        <translation>Beleggrenze ändern</translation>
    </message>
    <message>
        <source>Change tolerance</source>
        <translation>Toleranz ändern</translation>
    </message>
    <message>
        <source>Change type</source>
        <translation>Typ ändern</translation>
    </message>
    <message>
        <source>Change wanted uncertainty</source>
        <translation>Gewünschte Unsicherheit ändern</translation>
    </message>
    <message>
        <source>Dental model</source>
        <translation>Dentalmodell</translation>
    </message>
    <message>
        <source>Dental model, after treatment</source>
        <translation>Dentalmodell, nach Behandlung</translation>
    </message>
    <message>
        <source>Dental model, before treatment</source>
        <translation>Dentalmodell, vor Behandlung</translation>
    </message>
    <message>
        <source>Do not accept a place</source>
        <translation>Stelle nicht annehmen</translation>
    </message>
    <message>
        <source>Ear impression</source>
        <translation>Ohrabformung</translation>
    </message>
    <message>
        <source>Edit order number</source>
        <translation>Auftragsnummer ändern</translation>
    </message>
    <message>
        <source>Edit patient code</source>
        <translation>Patientencode ändern</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Lower jaw</source>
        <translation>Unterkiefer</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>Other</source>
        <translation>Anderes</translation>
    </message>
    <message>
        <source>Remove a measurement</source>
        <translation>Messung entfernen</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Split the pair tray</source>
        <translation>Paarträger aufteilen</translation>
    </message>
    <message>
        <source>Take points out</source>
        <translation>Punkte herausnehmen</translation>
    </message>
    <message>
        <source>Upper jaw</source>
        <translation>Oberkiefer</translation>
    </message>
</context>
<context>
    <name>emission</name>
    <message>
        <source>Laser ON</source>
        <translation>Laser AN</translation>
    </message>
    <message>
        <source>Laser off</source>
        <translation>Laser aus</translation>
    </message>
    <message>
        <source>Laser unknown</source>
        <translation>Laser unbekannt</translation>
    </message>
    <message>
        <source>Laser: no rig</source>
        <translation>Laser: kein Messplatz</translation>
    </message>
</context>
<context>
    <name>faults</name>
    <message>
        <source>Something unexpected happened ({kind}).</source>
        <translation>Etwas Unerwartetes ist geschehen ({kind}).</translation>
    </message>
    <message>
        <source>What was measured is kept; the details help us to mend it.</source>
        <translation>Das Gemessene ist gesichert; die Details helfen uns, es zu beheben.</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
</context>
<context>
    <name>format</name>
    <message>
        <source>1 day old</source>
        <translation>1 Tag alt</translation>
    </message>
    <message>
        <source>1 hour ago</source>
        <translation>vor 1 Stunde</translation>
    </message>
    <message>
        <source>1 minute ago</source>
        <translation>vor 1 Minute</translation>
    </message>
    <message>
        <source>just now</source>
        <translation>gerade eben</translation>
    </message>
    <message>
        <source>today</source>
        <translation>heute</translation>
    </message>
    <message>
        <source>yesterday</source>
        <translation>gestern</translation>
    </message>
    <message>
        <source>{n} days ago</source>
        <translation>vor {n} Tagen</translation>
    </message>
    <message>
        <source>{n} days old</source>
        <translation>{n} Tage alt</translation>
    </message>
    <message>
        <source>{n} hours ago</source>
        <translation>vor {n} Stunden</translation>
    </message>
    <message>
        <source>{n} minutes ago</source>
        <translation>vor {n} Minuten</translation>
    </message>
</context>
<context>
    <name>help</name>
    <message>
        <source>A deviation is positive where the surface after lies outside of the one before. What is smaller than the detection level cannot be told from noise and stays grey.</source>
        <translation>Eine Abweichung ist positiv, wo die Oberfläche nachher außerhalb der vorherigen liegt. Was kleiner ist als die Nachweisgrenze, ist von Rauschen nicht zu unterscheiden und bleibt grau.</translation>
    </message>
    <message>
        <source>A rig of your own is set up here: its board and cameras are found, checked, and written into a file.</source>
        <translation>Hier wird ein eigener Messplatz eingerichtet: Steuerung und Kameras werden gefunden, geprüft und in eine Datei geschrieben.</translation>
    </message>
    <message>
        <source>A sphere of certified size is measured: it tells whether the rig still measures right.</source>
        <translation>Eine Kugel mit zertifiziertem Maß wird gemessen: Sie zeigt, ob der Messplatz noch richtig misst.</translation>
    </message>
    <message>
        <source>An area is that of the missing surface in square millimetres. The sign at each place says why it is missing.</source>
        <translation>Eine Fläche ist die der fehlenden Oberfläche in Quadratmillimetern. Das Zeichen an jeder Stelle sagt, warum sie fehlt.</translation>
    </message>
    <message>
        <source>Both cameras live, with the laser spot that is accepted and every spot that is not.</source>
        <translation>Beide Kameras live, mit dem angenommenen Laserpunkt und jedem, der es nicht ist.</translation>
    </message>
    <message>
        <source>Cut the base off, then brush or lasso what is left over. Every step can be taken back with Ctrl+Z; no point is ever deleted.</source>
        <translation>Die Basis abschneiden, dann mit Pinsel oder Lasso nehmen, was übrig ist. Jeder Schritt lässt sich mit Strg+Z zurücknehmen; kein Punkt wird je gelöscht.</translation>
    </message>
    <message>
        <source>Directions and steps are measured by what the cameras see, and corrected in the file where they differ.</source>
        <translation>Richtungen und Schritte werden an dem gemessen, was die Kameras sehen, und in der Datei berichtigt, wo sie abweichen.</translation>
    </message>
    <message>
        <source>Drop both files, say which part has not changed, and compare. Then go through the areas, the largest first.</source>
        <translation>Beide Dateien hineinziehen, angeben, welcher Teil sich nicht geändert hat, und vergleichen. Dann die Flächen durchgehen, die größte zuerst.</translation>
    </message>
    <message>
        <source>Every change is in force at once or says when it will be, and Ctrl+Z takes it back.</source>
        <translation>Jede Änderung gilt sofort oder sagt, wann sie gelten wird, und Strg+Z nimmt sie zurück.</translation>
    </message>
    <message>
        <source>Fill now scans more where the laser reaches as the object stands. For what is hidden set the object down another way and scan that, or accept the place as it is.</source>
        <translation>„Jetzt ergänzen“ scannt mehr, wo der Laser hinkommt, wie das Objekt steht. Für Verdecktes das Objekt anders aufstellen und das scannen, oder die Stelle annehmen, wie sie ist.</translation>
    </message>
    <message>
        <source>Go from step to step. Each says what it moves before it does; keep the lid closed and the stop button within reach.</source>
        <translation>Schritt für Schritt vorgehen. Jeder sagt vorher, was er bewegt; den Deckel geschlossen und den Stoppknopf in Reichweite halten.</translation>
    </message>
    <message>
        <source>Here the day begins: an order is chosen or made, and its scan is started.</source>
        <translation>Hier beginnt der Tag: Ein Auftrag wird gewählt oder angelegt und sein Scan gestartet.</translation>
    </message>
    <message>
        <source>Lengths are in millimetres between measured points, areas in square millimetres within the section.</source>
        <translation>Längen gelten in Millimetern zwischen Messpunkten, Flächen in Quadratmillimetern innerhalb des Schnitts.</translation>
    </message>
    <message>
        <source>Let the exposure be set by itself, or choose a material. Change the limits of the size only when good spots are refused: the reason stands at each of them.</source>
        <translation>Die Belichtung von selbst einstellen lassen oder ein Material wählen. Die Größengrenzen nur ändern, wenn gute Lichtpunkte abgelehnt werden: Der Grund steht an jedem.</translation>
    </message>
    <message>
        <source>Nothing needs to be done while it runs. Pause stops at a safe place with the laser dark; Esc ends the scan and keeps what was measured.</source>
        <translation>Während er läuft, ist nichts zu tun. Pause hält an sicherer Stelle mit dunklem Laser; Esc beendet den Scan und behält das Gemessene.</translation>
    </message>
    <message>
        <source>Pick a place on the left, then the same place on the right, three times and far apart. Without a mouse: turn with the arrow keys, pick with space.</source>
        <translation>Links eine Stelle wählen, dann dieselbe rechts, dreimal und weit auseinander. Ohne Maus: mit den Pfeiltasten drehen, mit der Leertaste wählen.</translation>
    </message>
    <message>
        <source>Points that do not belong to the object are taken out here, and distances are measured.</source>
        <translation>Punkte, die nicht zum Objekt gehören, werden hier herausgenommen, und Abstände werden gemessen.</translation>
    </message>
    <message>
        <source>Put the sphere into the middle of the table, enter the diameter from its certificate, and start. Do it once a month, and after every calibration.</source>
        <translation>Die Kugel in die Tellermitte stellen, den Durchmesser aus ihrem Zertifikat eingeben und starten. Einmal im Monat und nach jeder Kalibrierung.</translation>
    </message>
    <message>
        <source>Read the checks: what is amber says in one sentence what it means. Choose the profile of the receiver and deliver.</source>
        <translation>Die Prüfungen lesen: Was gelb ist, sagt in einem Satz, was es bedeutet. Das Profil des Empfängers wählen und ausliefern.</translation>
    </message>
    <message>
        <source>Set it down so that what was below looks up, and scan this mount. If it does not fit by itself, pick three points on both.</source>
        <translation>So aufstellen, dass nach oben blickt, was unten war, und diese Aufstellung scannen. Passt sie nicht von selbst, auf beiden drei Punkte wählen.</translation>
    </message>
    <message>
        <source>Start it with the detail as it stands. You may stop it and keep what is there, or scan the next order meanwhile.</source>
        <translation>Mit dem eingestellten Detailgrad starten. Man kann sie beenden und behalten, was da ist, oder inzwischen den nächsten Auftrag scannen.</translation>
    </message>
    <message>
        <source>The coverage is the share of the surface that was measured, the rest was spanned. The uncertainty is that of a point of the surface, one standard deviation.</source>
        <translation>Die Abdeckung ist der Anteil der Oberfläche, der gemessen wurde; der Rest wurde überspannt. Die Unsicherheit gilt für einen Punkt der Oberfläche, eine Standardabweichung.</translation>
    </message>
    <message>
        <source>The distance says how well both agree where they overlap; it should be about the noise of a point.</source>
        <translation>Der Abstand sagt, wie gut beide übereinstimmen, wo sie sich überlappen; er sollte etwa dem Rauschen eines Punkts entsprechen.</translation>
    </message>
    <message>
        <source>The ellipse is the spot&apos;s size, one sigma in pixels. The line is where the other camera says that the spot must be.</source>
        <translation>Die Ellipse ist die Größe des Lichtpunkts, ein Sigma in Pixeln. Die Linie zeigt, wo er laut der anderen Kamera liegen muss.</translation>
    </message>
    <message>
        <source>The error is the distance of the points to the surface: half of them are nearer than the first number, 95 % nearer than the second. Its width should be about the noise of a point.</source>
        <translation>Der Fehler ist der Abstand der Punkte zur Oberfläche: Die Hälfte liegt näher als die erste Zahl, 95 % näher als die zweite. Seine Breite sollte etwa dem Rauschen eines Punkts entsprechen.</translation>
    </message>
    <message>
        <source>The error of the calibration is measured at corners of the board that were not used to calibrate. Its age counts since then: calibrate again when something was moved.</source>
        <translation>Der Fehler der Kalibrierung wird an Ecken der Tafel gemessen, die nicht zum Kalibrieren dienten. Ihr Alter zählt seither: neu kalibrieren, wenn etwas bewegt wurde.</translation>
    </message>
    <message>
        <source>The large number says how accurate the rig measured the last time it was checked, and when that was.</source>
        <translation>Die große Zahl sagt, wie genau der Messplatz bei der letzten Prüfung maß und wann das war.</translation>
    </message>
    <message>
        <source>The object is measured: the laser visits it point by point, and the table turns it from view to view.</source>
        <translation>Das Objekt wird gemessen: Der Laser fährt es Punkt für Punkt ab, und der Teller dreht es von Ansicht zu Ansicht.</translation>
    </message>
    <message>
        <source>The object is scanned again, set down another way, and both scans are brought together.</source>
        <translation>Das Objekt wird anders aufgestellt noch einmal gescannt, und beide Scans werden zusammengeführt.</translation>
    </message>
    <message>
        <source>The places need not be exact: a few millimetres are enough, the rest is computed from all points.</source>
        <translation>Die Stellen müssen nicht genau sein: Ein paar Millimeter genügen, der Rest wird aus allen Punkten berechnet.</translation>
    </message>
    <message>
        <source>The points become a closed surface: a balloon is inflated inside them, refined where they ask for it, and smoothed.</source>
        <translation>Aus den Punkten wird eine geschlossene Oberfläche: Ein Ballon wird in ihnen aufgeblasen, wo nötig verfeinert und geglättet.</translation>
    </message>
    <message>
        <source>The points count what is in the case already. Rejected points were seen by one camera only, or not sharply enough: a few of them are normal. The time left is computed from the views that are done.</source>
        <translation>Die Punkte zählen, was schon im Fall ist. Verworfene Punkte sah nur eine Kamera, oder nicht scharf genug: Einige wenige sind normal. Die Restzeit wird aus den fertigen Ansichten berechnet.</translation>
    </message>
    <message>
        <source>The size deviation is the measured diameter less the certified one; U is its uncertainty, k = 2. PF is the distance between the outermost and the innermost point, D95 the width that holds 95 % of the points, σ their standard deviation.</source>
        <translation>Die Maßabweichung ist der gemessene Durchmesser minus der zertifizierte; U ist ihre Unsicherheit, k = 2. PF ist der Abstand zwischen äußerstem und innerstem Punkt, D95 die Breite, die 95 % der Punkte fasst, σ ihre Standardabweichung.</translation>
    </message>
    <message>
        <source>The size is that of everything in the window: 150 % makes texts and buttons half as large again.</source>
        <translation>Die Größe gilt für alles im Fenster: 150 % macht Texte und Knöpfe um die Hälfte größer.</translation>
    </message>
    <message>
        <source>The surface is checked and leaves the program as a file for the next machine, with a certificate beside it.</source>
        <translation>Die Oberfläche wird geprüft und verlässt das Programm als Datei für die nächste Maschine, mit einem Prüfbericht daneben.</translation>
    </message>
    <message>
        <source>This page shows the cameras, the laser, the table and their calibration.</source>
        <translation>Diese Seite zeigt die Kameras, den Laser, den Teller und ihre Kalibrierung.</translation>
    </message>
    <message>
        <source>Three places that both mounts have in common tell the program how the object was set down.</source>
        <translation>Drei Stellen, die beide Aufstellungen gemeinsam haben, sagen dem Programm, wie das Objekt aufgestellt wurde.</translation>
    </message>
    <message>
        <source>Two surfaces of the same object, before and after, are laid upon each other and their difference is shown.</source>
        <translation>Zwei Oberflächen desselben Objekts, vorher und nachher, werden aufeinandergelegt und ihr Unterschied gezeigt.</translation>
    </message>
    <message>
        <source>Type the order&apos;s number or read it with the scanner, choose the side and the type, put the object on the table, and start. An interrupted scan is offered at the top and can be resumed.</source>
        <translation>Auftragsnummer eintippen oder mit dem Scanner lesen, Seite und Typ wählen, Objekt auf den Teller stellen und starten. Ein unterbrochener Scan wird oben angeboten und kann fortgesetzt werden.</translation>
    </message>
    <message>
        <source>What is set once: looks, language, folders, and what a scan does by itself.</source>
        <translation>Was einmal eingestellt wird: Aussehen, Sprache, Ordner, und was ein Scan von selbst tut.</translation>
    </message>
    <message>
        <source>When everything is green there is nothing to do. Otherwise read the one sentence that is amber: it says what helps, with a button.</source>
        <translation>Ist alles grün, gibt es nichts zu tun. Sonst den einen Satz lesen, der gelb ist: Er sagt, was hilft, mit einem Knopf.</translation>
    </message>
    <message>
        <source>Where the surface is not measured, or only thinly: a list of places, the largest first.</source>
        <translation>Wo die Oberfläche nicht oder nur dünn gemessen ist: eine Liste der Stellen, die größte zuerst.</translation>
    </message>
</context>
<context>
    <name>keys</name>
    <message>
        <source>Compare</source>
        <translation>Vergleichen</translation>
    </message>
    <message>
        <source>Everywhere</source>
        <translation>Überall</translation>
    </message>
    <message>
        <source>Nearer and farther</source>
        <translation>Näher und weiter weg</translation>
    </message>
    <message>
        <source>Next and previous control</source>
        <translation>Nächstes und voriges Bedienelement</translation>
    </message>
    <message>
        <source>Open the menus</source>
        <translation>Menüs öffnen</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>Seiten</translation>
    </message>
    <message>
        <source>Pick the point in the middle</source>
        <translation>Punkt in der Mitte wählen</translation>
    </message>
    <message>
        <source>Pick three points</source>
        <translation>Drei Punkte wählen</translation>
    </message>
    <message>
        <source>Press the control in hand</source>
        <translation>Gewähltes Bedienelement drücken</translation>
    </message>
    <message>
        <source>The other surface, for a moment</source>
        <translation>Die andere Oberfläche, für einen Augenblick</translation>
    </message>
    <message>
        <source>Turn the view</source>
        <translation>Ansicht drehen</translation>
    </message>
</context>
<context>
    <name>materials</name>
    <message>
        <source>A clipped top hides where the peak is, and on gloss it is seldom in the middle.</source>
        <translation>Eine abgeschnittene Spitze verdeckt, wo das Maximum ist, und auf Glanz liegt es selten in der Mitte.</translation>
    </message>
    <message>
        <source>A dim halo without its spot must not be taken for one.</source>
        <translation>Ein dunkler Hof ohne seinen Lichtpunkt darf nicht für einen gelten.</translation>
    </message>
    <message>
        <source>A higher threshold keeps the foot of the halo, which is no part of the beam, out of the spot.</source>
        <translation>Eine höhere Schwelle hält den Fuß des Hofs, der nicht zum Strahl gehört, aus dem Lichtpunkt heraus.</translation>
    </message>
    <message>
        <source>A little light spreads inside of the plaster and comes out around the spot.</source>
        <translation>Ein wenig Licht breitet sich im Gips aus und tritt um den Lichtpunkt herum aus.</translation>
    </message>
    <message>
        <source>Alginate or another wet, glossy impression under a thin coat of white powder.</source>
        <translation>Alginat oder eine andere nasse, glänzende Abformung unter einer dünnen Schicht weißen Puders.</translation>
    </message>
    <message>
        <source>Alginate, scan-sprayed</source>
        <translation>Alginat, mit Scanspray</translation>
    </message>
    <message>
        <source>Dry plaster does not mirror; what is less bright by four is light from a neighbouring wall.</source>
        <translation>Trockener Gips spiegelt nicht; was viermal dunkler ist, ist Licht von einer Nachbarwand.</translation>
    </message>
    <message>
        <source>Ear impression silicone</source>
        <translation>Abformsilikon (Ohr)</translation>
    </message>
    <message>
        <source>Glare flattens the top of a spot on a wet place: fewer clipped pixels are borne than on a matt surface.</source>
        <translation>Glanz flacht die Spitze eines Lichtpunkts auf nasser Stelle ab: Es werden weniger abgeschnittene Pixel geduldet als auf matter Fläche.</translation>
    </message>
    <message>
        <source>Glossy plastic</source>
        <translation>Glänzender Kunststoff</translation>
    </message>
    <message>
        <source>Light goes in and comes out around: the peak is lower than on silicone that scatters as much.</source>
        <translation>Licht dringt ein und tritt ringsum aus: Die Spitze ist niedriger als auf Silikon, das ebenso stark streut.</translation>
    </message>
    <message>
        <source>Matt, light silicone that has set; coloured ones may need more light.</source>
        <translation>Mattes, helles, ausgehärtetes Silikon; farbiges kann mehr Licht brauchen.</translation>
    </message>
    <message>
        <source>Mirrored light is drawn out along the surface: spots that are longer than three times their width are doubtful here.</source>
        <translation>Gespiegeltes Licht ist längs der Fläche gestreckt: Lichtpunkte, die länger sind als das Dreifache ihrer Breite, sind hier zweifelhaft.</translation>
    </message>
    <message>
        <source>Mirrored spots are nearly as bright as true ones: the frame alone decides nothing, the other camera does.</source>
        <translation>Gespiegelte Lichtpunkte sind fast so hell wie echte: Das Bild allein entscheidet nichts, die andere Kamera schon.</translation>
    </message>
    <message>
        <source>Plaster</source>
        <translation>Gips</translation>
    </message>
    <message>
        <source>Plaster scatters back about 0.8 of the light where silicone scatters 0.5: the same peak comes in 0.65 of the time.</source>
        <translation>Gips streut etwa 0,8 des Lichts zurück, Silikon 0,5: dieselbe Spitze in 0,65 der Zeit.</translation>
    </message>
    <message>
        <source>Printed models, varnish, enamel; spray it where you can.</source>
        <translation>Gedruckte Modelle, Lack, Schmelz; wo möglich einsprühen.</translation>
    </message>
    <message>
        <source>Set silicone hardly mirrors: four times as bright tells the spot from the few reflections.</source>
        <translation>Ausgehärtetes Silikon spiegelt kaum: Vierfache Helligkeit trennt den Lichtpunkt von den wenigen Reflexen.</translation>
    </message>
    <message>
        <source>Skin-like</source>
        <translation>Hautähnlich</translation>
    </message>
    <message>
        <source>The halo of the light that comes out around the spot is wider than the spot.</source>
        <translation>Der Hof des Lichts, das um den Lichtpunkt austritt, ist breiter als der Lichtpunkt.</translation>
    </message>
    <message>
        <source>The part that is mirrored is lost to both cameras or blinds one: between plaster and silicone.</source>
        <translation>Der gespiegelte Anteil geht beiden Kameras verloren oder blendet eine: zwischen Gips und Silikon.</translation>
    </message>
    <message>
        <source>The powder is as white as plaster where the coat covers; a little more light for where it is thin.</source>
        <translation>Der Puder ist weiß wie Gips, wo die Schicht deckt; etwas mehr Licht für die Stellen, wo sie dünn ist.</translation>
    </message>
    <message>
        <source>The rig&apos;s own exposure is made for a matt, light surface that scatters back about half of the light, as silicone does.</source>
        <translation>Die eigene Belichtung des Messplatzes gilt für eine matte, helle Fläche, die etwa die Hälfte des Lichts zurückstreut, wie Silikon.</translation>
    </message>
    <message>
        <source>The walls of the canal are seen at up to 80 degrees: their spots are drawn out, and still good.</source>
        <translation>Die Wände des Gehörgangs werden mit bis zu 80 Grad gesehen: Ihre Lichtpunkte sind gestreckt und trotzdem gut.</translation>
    </message>
    <message>
        <source>Translucent and reddish: skin, wax, flesh-coloured silicone.</source>
        <translation>Durchscheinend und rötlich: Haut, Wachs, hautfarbenes Silikon.</translation>
    </message>
    <message>
        <source>Where the coat is thin the wet surface mirrors: only what is clearly the brightest is taken, the rest is left to the other camera.</source>
        <translation>Wo die Schicht dünn ist, spiegelt die nasse Fläche: Nur das eindeutig Hellste wird genommen, der Rest bleibt der anderen Kamera überlassen.</translation>
    </message>
    <message>
        <source>White gypsum, as dental models and casts are made of.</source>
        <translation>Weißer Gips, wie für Dental- und andere Modelle.</translation>
    </message>
</context>
<context>
    <name>measure</name>
    <message>
        <source>Canal length</source>
        <translation>Länge des Gehörgangs</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>at most ±{mm3} mm³; surface {mm2} mm²</source>
        <translation>höchstens ±{mm3} mm³; Oberfläche {mm2} mm²</translation>
    </message>
    <message>
        <source>from end to end</source>
        <translation>von Ende zu Ende</translation>
    </message>
    <message>
        <source>from the tip to where it opens</source>
        <translation>von der Spitze bis zu seiner Öffnung</translation>
    </message>
    <message>
        <source>its uncertainty is not known</source>
        <translation>seine Unsicherheit ist nicht bekannt</translation>
    </message>
    <message>
        <source>perimeter {mm} mm</source>
        <translation>Umfang {mm} mm</translation>
    </message>
    <message>
        <source>perimeter {mm} mm; the section is open</source>
        <translation>Umfang {mm} mm; der Schnitt ist offen</translation>
    </message>
    <message>
        <source>surface {mm2} mm²</source>
        <translation>Oberfläche {mm2} mm²</translation>
    </message>
    <message>
        <source>{mm2} mm²</source>
        <translation>{mm2} mm²</translation>
    </message>
    <message>
        <source>{mm3} mm³</source>
        <translation>{mm3} mm³</translation>
    </message>
    <message>
        <source>{mm} mm</source>
        <translation>{mm} mm</translation>
    </message>
    <message>
        <source>± {um} µm, standard uncertainty of both places</source>
        <translation>± {um} µm, Standardunsicherheit beider Stellen</translation>
    </message>
</context>
<context>
    <name>mounts</name>
    <message>
        <source>Mount {n}</source>
        <translation>Aufstellung {n}</translation>
    </message>
    <message>
        <source>Pick a point on a mount</source>
        <translation>Punkt auf einer Aufstellung wählen</translation>
    </message>
    <message>
        <source>from your points</source>
        <translation>von den gewählten Punkten</translation>
    </message>
    <message>
        <source>margin to the second-best pose {margin}</source>
        <translation>Vorsprung vor der zweitbesten Lage {margin}</translation>
    </message>
    <message>
        <source>unique</source>
        <translation>eindeutig</translation>
    </message>
    <message>
        <source>{points} points, kept apart</source>
        <translation>{points} Punkte, getrennt gehalten</translation>
    </message>
    <message>
        <source>{points} points; the others lie on it</source>
        <translation>{points} Punkte; die anderen liegen darauf</translation>
    </message>
    <message>
        <source>{share} % overlap</source>
        <translation>{share} % Überlappung</translation>
    </message>
    <message>
        <source>{um} µm residual</source>
        <translation>{um} µm Restfehler</translation>
    </message>
</context>
<context>
    <name>pages</name>
    <message>
        <source>Aim</source>
        <translation>Anvisieren</translation>
    </message>
    <message>
        <source>Another mount</source>
        <translation>Neue Aufstellung</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleichen</translation>
    </message>
    <message>
        <source>Complete</source>
        <translation>Ergänzen</translation>
    </message>
    <message>
        <source>Deliver</source>
        <translation>Ausliefern</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Bearbeiten</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Live point cloud</source>
        <translation>Punktwolke live</translation>
    </message>
    <message>
        <source>Missing places</source>
        <translation>Fehlende Stellen</translation>
    </message>
    <message>
        <source>Mounts</source>
        <translation>Aufstellungen</translation>
    </message>
    <message>
        <source>Pick three points</source>
        <translation>Drei Punkte wählen</translation>
    </message>
    <message>
        <source>Points and measurements</source>
        <translation>Punkte und Messungen</translation>
    </message>
    <message>
        <source>Reconstruct</source>
        <translation>Rekonstruieren</translation>
    </message>
    <message>
        <source>Reference sphere</source>
        <translation>Referenzkugel</translation>
    </message>
    <message>
        <source>Rig</source>
        <translation>Messplatz</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>Scannen</translation>
    </message>
    <message>
        <source>Set up a rig</source>
        <translation>Messplatz einrichten</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Oberfläche</translation>
    </message>
</context>
<context>
    <name>phases</name>
    <message>
        <source>Inflate</source>
        <translation>Aufblasen</translation>
    </message>
    <message>
        <source>Refine</source>
        <translation>Verfeinern</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Glätten</translation>
    </message>
    <message>
        <source>grows to the points</source>
        <translation>wächst zu den Punkten</translation>
    </message>
    <message>
        <source>where the error is</source>
        <translation>wo der Fehler ist</translation>
    </message>
    <message>
        <source>without shrinking</source>
        <translation>ohne Schrumpfen</translation>
    </message>
</context>
<context>
    <name>preferences</name>
    <message>
        <source>another folder for cases</source>
        <translation>anderer Ordner für Fälle</translation>
    </message>
    <message>
        <source>another folder for exports</source>
        <translation>anderer Ordner für Exporte</translation>
    </message>
    <message>
        <source>another pattern of file names</source>
        <translation>anderes Muster der Dateinamen</translation>
    </message>
    <message>
        <source>change of the export profiles</source>
        <translation>Änderung der Exportprofile</translation>
    </message>
    <message>
        <source>change of the language</source>
        <translation>Änderung der Sprache</translation>
    </message>
    <message>
        <source>change of the size</source>
        <translation>Änderung der Größe</translation>
    </message>
    <message>
        <source>change of the theme</source>
        <translation>Änderung des Designs</translation>
    </message>
    <message>
        <source>measuring weak places again</source>
        <translation>schwache Stellen noch einmal messen</translation>
    </message>
    <message>
        <source>patient&apos;s code in file names</source>
        <translation>Patientencode in Dateinamen</translation>
    </message>
    <message>
        <source>surface while scanning</source>
        <translation>Oberfläche während des Scans</translation>
    </message>
</context>
<context>
    <name>ready</name>
    <message>
        <source>Calibrate…</source>
        <translation>Kalibrieren…</translation>
    </message>
    <message>
        <source>Check again</source>
        <translation>Neu prüfen</translation>
    </message>
    <message>
        <source>Checking the rig…</source>
        <translation>Messplatz wird geprüft…</translation>
    </message>
    <message>
        <source>Find reference</source>
        <translation>Referenz suchen</translation>
    </message>
    <message>
        <source>Laser off</source>
        <translation>Laser aus</translation>
    </message>
    <message>
        <source>Measure the sphere…</source>
        <translation>Kugel messen…</translation>
    </message>
    <message>
        <source>Only {free_gib} GB are free where the cases are kept: free some space.</source>
        <translation>Wo die Fälle liegen, sind nur {free_gib} GB frei: Platz schaffen.</translation>
    </message>
    <message>
        <source>Ready to measure.</source>
        <translation>Bereit zum Messen.</translation>
    </message>
    <message>
        <source>Reconnect</source>
        <translation>Neu verbinden</translation>
    </message>
    <message>
        <source>Set up…</source>
        <translation>Einrichten…</translation>
    </message>
    <message>
        <source>The axes have not found their reference yet.</source>
        <translation>Die Achsen haben ihre Referenz noch nicht gefunden.</translation>
    </message>
    <message>
        <source>The calibration does not fit this rig: it must be another one&apos;s.</source>
        <translation>Die Kalibrierung passt nicht zu diesem Messplatz: Sie muss von einem anderen sein.</translation>
    </message>
    <message>
        <source>The calibration expired {days} days ago.</source>
        <translation>Die Kalibrierung ist vor {days} Tagen abgelaufen.</translation>
    </message>
    <message>
        <source>The controller is halted.</source>
        <translation>Die Steuerung ist angehalten.</translation>
    </message>
    <message>
        <source>The controller is in alarm: look what stopped it, then unlock it.</source>
        <translation>Die Steuerung ist im Alarm: nachsehen, was sie anhielt, dann entriegeln.</translation>
    </message>
    <message>
        <source>The controller reports that the laser is lit, and nobody has asked for it.</source>
        <translation>Die Steuerung meldet, dass der Laser leuchtet, und niemand hat es verlangt.</translation>
    </message>
    <message>
        <source>The lid was opened: close it, then unlock.</source>
        <translation>Der Deckel wurde geöffnet: schließen, dann entriegeln.</translation>
    </message>
    <message>
        <source>The reference sphere was last measured {days} days ago: have the rig verified.</source>
        <translation>Die Referenzkugel wurde zuletzt vor {days} Tagen gemessen: Messplatz prüfen lassen.</translation>
    </message>
    <message>
        <source>The reference sphere was never measured on this rig: have it verified.</source>
        <translation>Die Referenzkugel wurde an diesem Messplatz nie gemessen: Messplatz prüfen lassen.</translation>
    </message>
    <message>
        <source>The rig is not calibrated yet.</source>
        <translation>Der Messplatz ist noch nicht kalibriert.</translation>
    </message>
    <message>
        <source>The {camera} camera sends black pictures: take the cap off its lens and look at its cable.</source>
        <translation>Die {camera} Kamera sendet schwarze Bilder: Objektivdeckel abnehmen und Kabel prüfen.</translation>
    </message>
    <message>
        <source>The {camera} camera sends pictures of {size} pixels, the rig file says {expected}.</source>
        <translation>Die {camera} Kamera sendet Bilder mit {size} Pixeln, die Messplatzdatei sagt {expected}.</translation>
    </message>
    <message>
        <source>Too much light falls into the {camera} camera: switch the lamp off or close the lid.</source>
        <translation>In die {camera} Kamera fällt zu viel Licht: Lampe ausschalten oder Deckel schließen.</translation>
    </message>
    <message>
        <source>Unlock</source>
        <translation>Entriegeln</translation>
    </message>
    <message>
        <source>left</source>
        <translation>linke</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechte</translation>
    </message>
    <message>
        <source>{sentence} (and {more} more)</source>
        <translation>{sentence} (und {more} weitere)</translation>
    </message>
</context>
<context>
    <name>reasons</name>
    <message>
        <source>cameras did not expose together</source>
        <translation>Kameras haben nicht gleichzeitig belichtet</translation>
    </message>
    <message>
        <source>cameras saw different spots</source>
        <translation>Kameras sahen verschiedene Lichtpunkte</translation>
    </message>
    <message>
        <source>cut by the picture&apos;s edge</source>
        <translation>vom Bildrand abgeschnitten</translation>
    </message>
    <message>
        <source>hidden from the left camera</source>
        <translation>vor der linken Kamera verdeckt</translation>
    </message>
    <message>
        <source>hidden from the right camera</source>
        <translation>vor der rechten Kamera verdeckt</translation>
    </message>
    <message>
        <source>measured again in a later view</source>
        <translation>in einer späteren Ansicht neu gemessen</translation>
    </message>
    <message>
        <source>more than one spot</source>
        <translation>mehr als ein Lichtpunkt</translation>
    </message>
    <message>
        <source>no spot in either camera</source>
        <translation>kein Lichtpunkt in beiden Kameras</translation>
    </message>
    <message>
        <source>on a mark of the table&apos;s rim</source>
        <translation>auf einer Marke am Tellerrand</translation>
    </message>
    <message>
        <source>on the table</source>
        <translation>auf dem Teller</translation>
    </message>
    <message>
        <source>outside the volume</source>
        <translation>außerhalb des Messvolumens</translation>
    </message>
    <message>
        <source>picture lost</source>
        <translation>Bild verloren</translation>
    </message>
    <message>
        <source>picture too bright</source>
        <translation>Bild zu hell</translation>
    </message>
    <message>
        <source>picture torn</source>
        <translation>Bild zerrissen</translation>
    </message>
    <message>
        <source>spot overexposed</source>
        <translation>Lichtpunkt überbelichtet</translation>
    </message>
    <message>
        <source>spot smeared along the surface</source>
        <translation>Lichtpunkt längs der Fläche verschmiert</translation>
    </message>
    <message>
        <source>spot too dim</source>
        <translation>Lichtpunkt zu schwach</translation>
    </message>
    <message>
        <source>spot too large</source>
        <translation>Lichtpunkt zu groß</translation>
    </message>
    <message>
        <source>spot too small</source>
        <translation>Lichtpunkt zu klein</translation>
    </message>
    <message>
        <source>taken out by hand</source>
        <translation>von Hand entfernt</translation>
    </message>
</context>
<context>
    <name>reconstruction</name>
    <message>
        <source>About {triangles} triangles, expected error about {n} µm.</source>
        <translation>Etwa {triangles} Dreiecke, erwarteter Fehler etwa {n} µm.</translation>
    </message>
    <message>
        <source>About {triangles} triangles, expected error about {n} µm: rounder, but no more certain.</source>
        <translation>Etwa {triangles} Dreiecke, erwarteter Fehler etwa {n} µm: runder, aber nicht sicherer.</translation>
    </message>
    <message>
        <source>About {triangles} triangles.</source>
        <translation>Etwa {triangles} Dreiecke.</translation>
    </message>
    <message>
        <source>As many triangles as a tolerance of {n} µm needs (set under Expert).</source>
        <translation>So viele Dreiecke, wie eine Toleranz von {n} µm braucht (unter Experte gesetzt).</translation>
    </message>
    <message>
        <source>Closed and whole: points support all of it.</source>
        <translation>Geschlossen und ganz: alles von Punkten belegt.</translation>
    </message>
    <message>
        <source>Closed and whole; {share} % of the points did not belong to it and were left out.</source>
        <translation>Geschlossen und ganz; {share} % der Punkte gehörten nicht dazu und blieben weg.</translation>
    </message>
    <message>
        <source>Closed; {share} % of it was not scanned and is only bridged.</source>
        <translation>Geschlossen; {share} % davon wurden nicht gescannt und sind nur überbrückt.</translation>
    </message>
    <message>
        <source>Kept early: closed and whole, but coarser than the points allow.</source>
        <translation>Vorzeitig behalten: geschlossen und ganz, aber gröber, als die Punkte erlauben.</translation>
    </message>
    <message>
        <source>Left open where nothing was scanned, as it was asked for.</source>
        <translation>Wie verlangt offen gelassen, wo nichts gescannt wurde.</translation>
    </message>
    <message>
        <source>No order number</source>
        <translation>Keine Auftragsnummer</translation>
    </message>
    <message>
        <source>The points carry the number of triangles.</source>
        <translation>Die Punkte tragen diese Zahl von Dreiecken.</translation>
    </message>
    <message>
        <source>{order} · {side}</source>
        <translation>{order} · {side}</translation>
    </message>
    <message>
        <source>{order}: being finished</source>
        <translation>{order}: wird fertiggestellt</translation>
    </message>
    <message>
        <source>{order}: reconstructing</source>
        <translation>{order}: wird rekonstruiert</translation>
    </message>
    <message>
        <source>{order}: reconstructing, {left} left</source>
        <translation>{order}: wird rekonstruiert, noch {left}</translation>
    </message>
    <message>
        <source>{order}: reconstructing, {left} left, {count} waiting</source>
        <translation>{order}: wird rekonstruiert, noch {left}, {count} wartend</translation>
    </message>
</context>
<context>
    <name>reject_advice</name>
    <message>
        <source>Check the trigger cable of the cameras (Rig).</source>
        <translation>Triggerkabel der Kameras prüfen (Messplatz).</translation>
    </message>
    <message>
        <source>Focus the lenses on the object (Aim).</source>
        <translation>Objektive auf das Objekt scharf stellen (Anvisieren).</translation>
    </message>
    <message>
        <source>Lengthen the exposure (Aim), or dust the object with a matt white powder.</source>
        <translation>Länger belichten (Anvisieren) oder das Objekt mit mattem weißem Puder bestäuben.</translation>
    </message>
    <message>
        <source>Move the object to the middle of the table.</source>
        <translation>Das Objekt in die Mitte des Tellers stellen.</translation>
    </message>
    <message>
        <source>Normal at the edges of the object, where the beam passes it.</source>
        <translation>Normal an den Rändern des Objekts, wo der Strahl vorbeigeht.</translation>
    </message>
    <message>
        <source>Normal at the edges; if there are many, defocus the lenses a little (Aim).</source>
        <translation>Normal an den Rändern; sind es viele, die Objektive etwas unscharf stellen (Anvisieren).</translation>
    </message>
    <message>
        <source>Normal in small numbers; if there are many, check the calibration (Rig).</source>
        <translation>In kleiner Zahl normal; sind es viele, die Kalibrierung prüfen (Messplatz).</translation>
    </message>
    <message>
        <source>Normal on steep flanks; another mount turns them towards the laser.</source>
        <translation>Normal an steilen Flanken; eine andere Aufstellung dreht sie zum Laser.</translation>
    </message>
    <message>
        <source>Normal: the beam met a mark of the table&apos;s rim.</source>
        <translation>Normal: Der Strahl traf eine Marke am Tellerrand.</translation>
    </message>
    <message>
        <source>Normal: the beam met the table beside the object.</source>
        <translation>Normal: Der Strahl traf den Teller neben dem Objekt.</translation>
    </message>
    <message>
        <source>Pictures come damaged: plug each camera into a USB port of its own.</source>
        <translation>Bilder kommen beschädigt an: jede Kamera an ihren eigenen USB-Anschluss stecken.</translation>
    </message>
    <message>
        <source>Pictures get lost: plug each camera into a USB port of its own, and close other programs.</source>
        <translation>Bilder gehen verloren: jede Kamera an ihren eigenen USB-Anschluss stecken und andere Programme schließen.</translation>
    </message>
    <message>
        <source>Shorten the exposure (Aim), or dust shiny places with a matt powder.</source>
        <translation>Kürzer belichten (Anvisieren) oder glänzende Stellen mit mattem Puder bestäuben.</translation>
    </message>
    <message>
        <source>Something mirrors the laser: dust it with matt powder, or cover what shines beside the object.</source>
        <translation>Etwas spiegelt den Laser: mit mattem Puder bestäuben oder abdecken, was neben dem Objekt glänzt.</translation>
    </message>
    <message>
        <source>Switch off lamps, keep the sun away, close the lid.</source>
        <translation>Lampen aus, Sonne fernhalten, Deckel schließen.</translation>
    </message>
    <message>
        <source>The object stands in the camera&apos;s way: another mount shows what is hidden.</source>
        <translation>Das Objekt steht der Kamera im Weg: Eine andere Aufstellung zeigt das Verdeckte.</translation>
    </message>
</context>
<context>
    <name>remarks</name>
    <message>
        <source>The body that stands on the table could not be filled; the base was closed by what the points alone enclose.</source>
        <translation>Der auf dem Teller stehende Körper ließ sich nicht füllen; die Basis wurde durch das geschlossen, was die Punkte allein umschließen.</translation>
    </message>
    <message>
        <source>The coordinates are rounded to steps of {step_mm} mm, single precision far from the origin; export the points in double precision, or nearer to the origin.</source>
        <translation>Die Koordinaten sind auf Schritte von {step_mm} mm gerundet, einfache Genauigkeit fern vom Ursprung; die Punkte in doppelter Genauigkeit oder näher am Ursprung exportieren.</translation>
    </message>
    <message>
        <source>The object is only {extent_mm} mm large, less than an anatomical part: if the coordinates are {unit}, use --units {option}.</source>
        <translation>Das Objekt ist nur {extent_mm} mm groß, weniger als ein Körperteil: Sind die Koordinaten in {unit}, --units {option} verwenden.</translation>
    </message>
    <message>
        <source>The object is {extent_mm} mm large, more than any anatomical part: if the coordinates are micrometres, divide them by 1000; if they are millimetres, use --units mm.</source>
        <translation>Das Objekt ist {extent_mm} mm groß, mehr als jeder Körperteil: Sind die Koordinaten Mikrometer, durch 1000 teilen; sind sie Millimeter, --units mm verwenden.</translation>
    </message>
    <message>
        <source>The object lies {away_mm} mm from the origin; it was computed about its centre, so that no precision was lost.</source>
        <translation>Das Objekt liegt {away_mm} mm vom Ursprung; es wurde um seine Mitte berechnet, sodass keine Genauigkeit verloren ging.</translation>
    </message>
    <message>
        <source>{count} points ({share}) lie more than {link_mm} mm from the object; they were left out as strays.</source>
        <translation>{count} Punkte ({share}) liegen mehr als {link_mm} mm vom Objekt; sie blieben als Streupunkte weg.</translation>
    </message>
    <message>
        <source>{share} % of the closed surface was not scanned; it is capped and marked as unsupported.</source>
        <translation>{share} % der geschlossenen Oberfläche wurden nicht gescannt; sie sind überbrückt und als nicht belegt markiert.</translation>
    </message>
    <message>
        <source>{share} % of the closed surface was not scanned; it is left open.</source>
        <translation>{share} % der geschlossenen Oberfläche wurden nicht gescannt; dort bleibt sie offen.</translation>
    </message>
    <message>
        <source>{share} % of the points do not belong to the surface and were rejected.</source>
        <translation>{share} % der Punkte gehören nicht zur Oberfläche und wurden verworfen.</translation>
    </message>
    <message>
        <source>{share} of the points repeat others exactly; each place was counted once.</source>
        <translation>{share} der Punkte wiederholen andere genau; jede Stelle zählte einmal.</translation>
    </message>
</context>
<context>
    <name>remedies</name>
    <message>
        <source>A reset was sent to switch the laser off; see that it is dark, check cable and power, then try again.</source>
        <translation>Zum Ausschalten des Lasers wurde ein Reset gesendet; nachsehen, dass er dunkel ist, Kabel und Strom prüfen, dann noch einmal versuchen.</translation>
    </message>
    <message>
        <source>A reset was sent; check the cable (length, shield, plugs), then try again.</source>
        <translation>Ein Reset wurde gesendet; Kabel prüfen (Länge, Schirm, Stecker), dann noch einmal versuchen.</translation>
    </message>
    <message>
        <source>A sweep ends dark by itself, a standing spot may stay lit: see that the laser is off, plug it in, then try again.</source>
        <translation>Eine Bahn endet von selbst dunkel, ein stehender Laserpunkt kann weiterleuchten: nachsehen, dass der Laser aus ist, einstecken, dann noch einmal versuchen.</translation>
    </message>
    <message>
        <source>Nothing was measured; choose another size or pixel format, or another camera.</source>
        <translation>Nichts wurde gemessen; andere Größe, anderes Pixelformat oder andere Kamera wählen.</translation>
    </message>
    <message>
        <source>Nothing was measured; take the lens cap off, open the shutter, or lengthen its exposure.</source>
        <translation>Nichts wurde gemessen; Objektivdeckel abnehmen, Verschluss öffnen oder länger belichten.</translation>
    </message>
    <message>
        <source>Nothing was moved; if it should be the controller, it has to be given GRBL first.</source>
        <translation>Nichts wurde bewegt; soll es die Steuerung sein, muss sie zuerst GRBL erhalten.</translation>
    </message>
    <message>
        <source>Nothing was moved; if it should be the controller, see that it has power and that the cable carries data, then try again.</source>
        <translation>Nichts wurde bewegt; soll es die Steuerung sein, prüfen, dass sie Strom hat und das Kabel Daten führt, dann noch einmal versuchen.</translation>
    </message>
    <message>
        <source>Nothing was moved; plug it in, then try again.</source>
        <translation>Nichts wurde bewegt; einstecken, dann noch einmal versuchen.</translation>
    </message>
    <message>
        <source>Nothing was moved; plug the controller in again, then try again.</source>
        <translation>Nichts wurde bewegt; Steuerung wieder einstecken, dann noch einmal versuchen.</translation>
    </message>
    <message>
        <source>Nothing was moved; such a rig needs a rig file that names one of these as &apos;table_axis&apos;.</source>
        <translation>Nichts wurde bewegt; ein solcher Messplatz braucht eine Messplatzdatei, die eine davon als &apos;table_axis&apos; nennt.</translation>
    </message>
    <message>
        <source>The laser is off; check its cable, then try again.</source>
        <translation>Der Laser ist aus; ihr Kabel prüfen, dann noch einmal versuchen.</translation>
    </message>
    <message>
        <source>The laser is off; check the trigger cable, or let the cameras run freely.</source>
        <translation>Der Laser ist aus; Triggerkabel prüfen oder die Kameras frei laufen lassen.</translation>
    </message>
    <message>
        <source>The laser is off; close other programs, then try again.</source>
        <translation>Der Laser ist aus; andere Programme schließen, dann noch einmal versuchen.</translation>
    </message>
    <message>
        <source>The laser is off; close the door, then try again.</source>
        <translation>Der Laser ist aus; Tür schließen, dann noch einmal versuchen.</translation>
    </message>
    <message>
        <source>The laser is off; its position is lost: home it, then try again.</source>
        <translation>Der Laser ist aus; die Position ist verloren: Referenz suchen, dann noch einmal versuchen.</translation>
    </message>
    <message>
        <source>The laser is off; plug it in, then try again.</source>
        <translation>Der Laser ist aus; einstecken, dann noch einmal versuchen.</translation>
    </message>
    <message>
        <source>The laser is off; try again when the rig is free.</source>
        <translation>Der Laser ist aus; noch einmal versuchen, wenn der Messplatz frei ist.</translation>
    </message>
    <message>
        <source>The laser is off; unplug the camera, plug it in again, then try again.</source>
        <translation>Der Laser ist aus; Kamera ausstecken, wieder einstecken, dann noch einmal versuchen.</translation>
    </message>
    <message>
        <source>The laser is off; {remedy}.</source>
        <translation>Der Laser ist aus; {remedy}.</translation>
    </message>
    <message>
        <source>The laser was switched off; free the machine of other work, then try again.</source>
        <translation>Der Laser wurde ausgeschaltet; den Rechner von anderer Arbeit befreien, dann noch einmal versuchen.</translation>
    </message>
</context>
<context>
    <name>rig</name>
    <message>
        <source>5 times</source>
        <translation>5-fach</translation>
    </message>
    <message>
        <source>As fast as it can</source>
        <translation>So schnell es geht</translation>
    </message>
    <message>
        <source>Bench: 604 × 294 px at 435 mm</source>
        <translation>Werkbank: 604 × 294, 435 mm</translation>
    </message>
    <message>
        <source>Both ears on a pair tray</source>
        <translation>Beide Ohren auf einem Paarträger</translation>
    </message>
    <message>
        <source>Dental arch</source>
        <translation>Zahnbogen</translation>
    </message>
    <message>
        <source>Ear impression</source>
        <translation>Ohrabformung</translation>
    </message>
    <message>
        <source>Heart</source>
        <translation>Herz</translation>
    </message>
    <message>
        <source>Paper 2003: the published rig at 770 mm</source>
        <translation>Artikel 2003: Messplatz, 770 mm</translation>
    </message>
    <message>
        <source>Real time</source>
        <translation>Echtzeit</translation>
    </message>
    <message>
        <source>Reference sphere</source>
        <translation>Referenzkugel</translation>
    </message>
    <message>
        <source>Workshop: 1440 × 1080 px at 600 mm</source>
        <translation>Werkstatt: 1440 × 1080, 600 mm</translation>
    </message>
    <message>
        <source>{rig}  (the file is missing)</source>
        <translation>{rig}  (die Datei fehlt)</translation>
    </message>
</context>
<context>
    <name>rig-faults</name>
    <message>
        <source>ALARM:1 (limit switch)</source>
        <translation>ALARM:1 (Endschalter)</translation>
    </message>
    <message>
        <source>ALARM:2 (soft limit)</source>
        <translation>ALARM:2 (Soft-Limit)</translation>
    </message>
    <message>
        <source>ALARM:3 (reset in a move)</source>
        <translation>ALARM:3 (Reset in Bewegung)</translation>
    </message>
    <message>
        <source>Camera bumped</source>
        <translation>Kamera angestoßen</translation>
    </message>
    <message>
        <source>Camera stalled</source>
        <translation>Kamera hängt</translation>
    </message>
    <message>
        <source>Camera unplugged</source>
        <translation>Kamera ausgesteckt</translation>
    </message>
    <message>
        <source>Cameras out of step</source>
        <translation>Kameras versetzt</translation>
    </message>
    <message>
        <source>Case locked</source>
        <translation>Fall gesperrt</translation>
    </message>
    <message>
        <source>Clock jump</source>
        <translation>Uhrsprung</translation>
    </message>
    <message>
        <source>Controller reset</source>
        <translation>Reset der Steuerung</translation>
    </message>
    <message>
        <source>Disk full</source>
        <translation>Datenträger voll</translation>
    </message>
    <message>
        <source>E-JOB-01; the points are safe, a new worker is started</source>
        <translation>meldet E-JOB-01; die Punkte sind sicher, ein neuer Arbeitsprozess startet</translation>
    </message>
    <message>
        <source>E-JOB-02 or E-JOB-01; the points are safe</source>
        <translation>meldet E-JOB-02 oder E-JOB-01; die Punkte sind sicher</translation>
    </message>
    <message>
        <source>Frames dropped</source>
        <translation>Bilder verloren</translation>
    </message>
    <message>
        <source>Frames late</source>
        <translation>Bilder verspätet</translation>
    </message>
    <message>
        <source>Frames torn</source>
        <translation>Bilder zerrissen</translation>
    </message>
    <message>
        <source>Lamp on</source>
        <translation>Lampe an</translation>
    </message>
    <message>
        <source>Lenses warm</source>
        <translation>Objektive warm</translation>
    </message>
    <message>
        <source>Lid opened</source>
        <translation>Deckel geöffnet</translation>
    </message>
    <message>
        <source>Lost ok</source>
        <translation>ok verloren</translation>
    </message>
    <message>
        <source>Mark knocked off</source>
        <translation>Marke abgeschlagen</translation>
    </message>
    <message>
        <source>Partial lines</source>
        <translation>Zeilen in Stücken</translation>
    </message>
    <message>
        <source>Port gone</source>
        <translation>Anschluss weg</translation>
    </message>
    <message>
        <source>Port gone and back</source>
        <translation>Anschluss weg und zurück</translation>
    </message>
    <message>
        <source>Program killed</source>
        <translation>Programm abgeschossen</translation>
    </message>
    <message>
        <source>Serial noise</source>
        <translation>Serielle Störungen</translation>
    </message>
    <message>
        <source>Shiny patch</source>
        <translation>Glänzende Stelle</translation>
    </message>
    <message>
        <source>Steps lost</source>
        <translation>Schritte verloren</translation>
    </message>
    <message>
        <source>Trigger lost</source>
        <translation>Trigger verloren</translation>
    </message>
    <message>
        <source>Worker killed</source>
        <translation>Arbeitsprozess abgeschossen</translation>
    </message>
    <message>
        <source>Worker out of memory</source>
        <translation>Arbeitsprozess ohne Speicher</translation>
    </message>
    <message>
        <source>a camera exposes 8 ms later than the other</source>
        <translation>eine Kamera belichtet 8 ms später als die andere</translation>
    </message>
    <message>
        <source>a camera hangs: no frame and no error comes any more</source>
        <translation>eine Kamera hängt: kein Bild und kein Fehler kommt mehr</translation>
    </message>
    <message>
        <source>a camera is turned by a small angle and stays so</source>
        <translation>eine Kamera wird um einen kleinen Winkel verdreht und bleibt so</translation>
    </message>
    <message>
        <source>a camera loses a fifth of its frames</source>
        <translation>eine Kamera verliert ein Fünftel ihrer Bilder</translation>
    </message>
    <message>
        <source>a camera misses a trigger: its frames belong to the next exposure from then on</source>
        <translation>eine Kamera verpasst einen Trigger: Von da an gehören ihre Bilder zur nächsten Belichtung</translation>
    </message>
    <message>
        <source>a garbled report is asked for again and the scan goes on; a garbled ok ends it with E-MOT-01</source>
        <translation>fragt bei verstümmelter Meldung nach, und der Scan läuft weiter; ein verstümmeltes ok beendet ihn mit E-MOT-01</translation>
    </message>
    <message>
        <source>a lamp shines into the cameras</source>
        <translation>eine Lampe scheint in die Kameras</translation>
    </message>
    <message>
        <source>a limit switch is touched; nothing but a reset gets through</source>
        <translation>ein Endschalter wird berührt; nur ein Reset kommt durch</translation>
    </message>
    <message>
        <source>a wet place on the object mirrors the beam: glare, and second spots</source>
        <translation>eine nasse Stelle am Objekt spiegelt den Strahl: Glanz und zweite Lichtpunkte</translation>
    </message>
    <message>
        <source>an &apos;ok&apos; of the controller gets lost on its way</source>
        <translation>ein &apos;ok&apos; der Steuerung geht unterwegs verloren</translation>
    </message>
    <message>
        <source>another program tries to open the case; at the opening it holds it</source>
        <translation>ein anderes Programm versucht den Fall zu öffnen; beim Öffnen hält es ihn</translation>
    </message>
    <message>
        <source>both lenses get longer by a thousandth, so that everything is measured too large</source>
        <translation>beide Objektive werden um ein Tausendstel länger, sodass alles zu groß gemessen wird</translation>
    </message>
    <message>
        <source>ends with E-CAM-01 after 4 s; laser off, points kept</source>
        <translation>endet nach 4 s mit E-CAM-01; Laser aus, Punkte gesichert</translation>
    </message>
    <message>
        <source>ends with E-CAM-02; laser off, points kept</source>
        <translation>endet mit E-CAM-02; Laser aus, Punkte gesichert</translation>
    </message>
    <message>
        <source>ends with E-DISK-01; laser off, everything acknowledged is kept</source>
        <translation>endet mit E-DISK-01; Laser aus, alles Bestätigte ist gesichert</translation>
    </message>
    <message>
        <source>ends with E-MOT-01, 2 s after the controller fell idle</source>
        <translation>endet mit E-MOT-01, 2 s nachdem die Steuerung ruht</translation>
    </message>
    <message>
        <source>ends with E-MOT-02; a sweep ends dark by itself</source>
        <translation>endet mit E-MOT-02; eine Bahn endet von selbst dunkel</translation>
    </message>
    <message>
        <source>ends with E-MOT-02; the next start works</source>
        <translation>endet mit E-MOT-02; der nächste Start gelingt</translation>
    </message>
    <message>
        <source>ends with E-MOT-05</source>
        <translation>endet mit E-MOT-05</translation>
    </message>
    <message>
        <source>ends with E-MOT-09; dark by the restart</source>
        <translation>endet mit E-MOT-09; dunkel durch den Neustart</translation>
    </message>
    <message>
        <source>ends with E-MOT-16; the controller itself stops and darkens the beam</source>
        <translation>endet mit E-MOT-16; die Steuerung selbst stoppt und verdunkelt den Strahl</translation>
    </message>
    <message>
        <source>for 10 s one byte in a hundred of the controller&apos;s answers is changed, or another one comes in between</source>
        <translation>10 s lang ist eines von hundert Bytes der Antworten der Steuerung verändert, oder ein fremdes kommt dazwischen</translation>
    </message>
    <message>
        <source>for 10 s the worker process gets no more memory; the time counts from the start of the reconstruction</source>
        <translation>10 s lang erhält der Arbeitsprozess keinen Speicher mehr; die Zeit zählt ab dem Start der Rekonstruktion</translation>
    </message>
    <message>
        <source>for 20 s the controller&apos;s answers come in pieces of 5 bytes with pauses of 20 ms</source>
        <translation>20 s lang kommen die Antworten der Steuerung in Stücken von 5 Bytes mit Pausen von 20 ms</translation>
    </message>
    <message>
        <source>goes on</source>
        <translation>läuft weiter</translation>
    </message>
    <message>
        <source>goes on, the other program is refused; a case that the other holds is refused with E-CASE-02</source>
        <translation>läuft weiter, das andere Programm wird abgewiesen; ein Fall, den das andere hält, wird mit E-CASE-02 abgewiesen</translation>
    </message>
    <message>
        <source>goes on; H-EPI-01 when it moved across the epipolar lines, H-VIEW-02 when along them</source>
        <translation>läuft weiter; H-EPI-01 bei Bewegung quer zu den Epipolarlinien, H-VIEW-02 bei Bewegung längs</translation>
    </message>
    <message>
        <source>goes on; H-MARK-03 where the rig has marks, else nothing tells</source>
        <translation>läuft weiter; H-MARK-03, wo der Messplatz Marken hat, sonst meldet es nichts</translation>
    </message>
    <message>
        <source>goes on; H-MARK-05</source>
        <translation>läuft weiter; H-MARK-05</translation>
    </message>
    <message>
        <source>goes on; H-SYN-01</source>
        <translation>läuft weiter; H-SYN-01</translation>
    </message>
    <message>
        <source>goes on; H-SYN-02</source>
        <translation>läuft weiter; H-SYN-02</translation>
    </message>
    <message>
        <source>goes on; H-TAB-01</source>
        <translation>läuft weiter; H-TAB-01</translation>
    </message>
    <message>
        <source>goes on; every frame is waited for</source>
        <translation>läuft weiter; auf jedes Bild wird gewartet</translation>
    </message>
    <message>
        <source>goes on; glare is rejected as saturated, second spots are settled by the other camera or ambiguous</source>
        <translation>läuft weiter; Glanz wird als übersteuert verworfen, zweite Lichtpunkte klärt die andere Kamera, oder sie gelten als mehrdeutig</translation>
    </message>
    <message>
        <source>goes on; no duration, rate or deadline is touched</source>
        <translation>läuft weiter; keine Dauer, Rate oder Frist ist berührt</translation>
    </message>
    <message>
        <source>goes on; rejected as dropped_frame, H-CAM-01</source>
        <translation>läuft weiter; verworfen als dropped_frame, H-CAM-01</translation>
    </message>
    <message>
        <source>goes on; rejected as too_bright, H-LGT-01</source>
        <translation>läuft weiter; verworfen als too_bright, H-LGT-01</translation>
    </message>
    <message>
        <source>goes on; torn frames are rejected, H-CAM-03</source>
        <translation>läuft weiter; zerrissene Bilder werden verworfen, H-CAM-03</translation>
    </message>
    <message>
        <source>in a tenth of a camera&apos;s frames the lower half is another exposure&apos;s, or garbage</source>
        <translation>in einem Zehntel der Bilder einer Kamera ist die untere Hälfte von einer anderen Belichtung oder Unsinn</translation>
    </message>
    <message>
        <source>is gone; the guardian darkens a real laser within 0.6 s, everything acknowledged is kept</source>
        <translation>ist weg; der Wächter verdunkelt einen echten Laser innerhalb von 0,6 s, alles Bestätigte ist gesichert</translation>
    </message>
    <message>
        <source>one of the balls on the table&apos;s rim is knocked off; nothing where the rig has no marks</source>
        <translation>eine der Kugeln am Tellerrand wird abgeschlagen; nichts, wo der Messplatz keine Marken hat</translation>
    </message>
    <message>
        <source>the board&apos;s reset button is pressed in the middle of a move</source>
        <translation>der Resetknopf der Steuerung wird mitten in einer Bewegung gedrückt</translation>
    </message>
    <message>
        <source>the cable of a camera comes off</source>
        <translation>das Kabel einer Kamera löst sich</translation>
    </message>
    <message>
        <source>the computer&apos;s clock jumps back by an hour</source>
        <translation>die Uhr des Rechners springt um eine Stunde zurück</translation>
    </message>
    <message>
        <source>the controller believes that a move leaves the travel of its axes</source>
        <translation>die Steuerung meint, eine Bewegung verlasse den Weg ihrer Achsen</translation>
    </message>
    <message>
        <source>the controller&apos;s cable comes off and stays off</source>
        <translation>das Kabel der Steuerung löst sich und bleibt ab</translation>
    </message>
    <message>
        <source>the controller&apos;s cable comes off, and is plugged in again after 3 s</source>
        <translation>das Kabel der Steuerung löst sich und wird nach 3 s wieder eingesteckt</translation>
    </message>
    <message>
        <source>the controller&apos;s supply breaks down in the middle of a move; it starts anew and has lost its position</source>
        <translation>die Versorgung der Steuerung bricht mitten in einer Bewegung zusammen; sie startet neu und hat ihre Position verloren</translation>
    </message>
    <message>
        <source>the frames of a camera arrive 0.4 s late, with the right ids and time stamps</source>
        <translation>die Bilder einer Kamera kommen 0,4 s zu spät, mit richtigen Kennungen und Zeitstempeln</translation>
    </message>
    <message>
        <source>the lid is opened, and closed after 10 s</source>
        <translation>der Deckel wird geöffnet und nach 10 s geschlossen</translation>
    </message>
    <message>
        <source>the program is killed (SIGKILL)</source>
        <translation>das Programm wird abgeschossen (SIGKILL)</translation>
    </message>
    <message>
        <source>the table&apos;s motor loses steps in its next move, unknown to the controller</source>
        <translation>der Motor des Tellers verliert bei seiner nächsten Bewegung Schritte, ohne dass die Steuerung es weiß</translation>
    </message>
    <message>
        <source>the worker process is killed; the time counts from the start of the reconstruction</source>
        <translation>der Arbeitsprozess wird abgeschossen; die Zeit zählt ab dem Start der Rekonstruktion</translation>
    </message>
    <message>
        <source>there is no space left on the disk of the case</source>
        <translation>auf dem Datenträger des Falls ist kein Platz mehr</translation>
    </message>
</context>
<context>
    <name>sentences</name>
    <message>
        <source>A camera moved by about {shift_px} px: since the view at {table_deg} deg the marks on the table&apos;s rim are seen {shift_um} um beside.</source>
        <translation>Eine Kamera hat sich um etwa {shift_px} px bewegt: Seit der Ansicht bei {table_deg}° liegen die Marken am Tellerrand {shift_um} µm daneben.</translation>
    </message>
    <message>
        <source>A camera moved or the object moved: the view at {table_deg} deg lies {shift_um} um beside the earlier ones ({direction}).</source>
        <translation>Eine Kamera oder das Objekt hat sich bewegt: Die Ansicht bei {table_deg}° liegt {shift_um} µm neben den früheren ({direction}).</translation>
    </message>
    <message>
        <source>A camera moved: the views from {table_deg} deg on lie {shift_um} um beside the earlier ones ({direction}, always as seen by the cameras).</source>
        <translation>Eine Kamera hat sich bewegt: Die Ansichten ab {table_deg}° liegen {shift_um} µm neben den früheren ({direction}, stets aus Sicht der Kameras).</translation>
    </message>
    <message>
        <source>A camera or the object moved on the way; fix both, and scan again.</source>
        <translation>Eine Kamera oder das Objekt hat sich unterwegs bewegt; beide befestigen und neu scannen.</translation>
    </message>
    <message>
        <source>A camera was moved across the epipolar lines by about {shift_px} px ({where}; noticed after {points} points).</source>
        <translation>Eine Kamera wurde um etwa {shift_px} px quer zu den Epipolarlinien bewegt ({where}; bemerkt nach {points} Punkten).</translation>
    </message>
    <message>
        <source>A mesh of {triangles} triangles is too large to be kept in {path}.</source>
        <translation>Ein Netz mit {triangles} Dreiecken ist zu groß, um in {path} gesichert zu werden.</translation>
    </message>
    <message>
        <source>A reset was sent and the points so far are kept; check the cable (length, shield, plugs) and resume.</source>
        <translation>Ein Reset wurde gesendet, und die bisherigen Punkte sind gesichert; Kabel prüfen (Länge, Schirm, Stecker) und fortsetzen.</translation>
    </message>
    <message>
        <source>A reset was sent to switch it off; see that it is dark, then check the controller&apos;s laser mode ($32).</source>
        <translation>Zum Ausschalten wurde ein Reset gesendet; nachsehen, dass er dunkel ist, dann den Lasermodus der Steuerung ($32) prüfen.</translation>
    </message>
    <message>
        <source>A reset was sent to switch the laser off and the points so far are kept; see that it is dark, check cable and power, then resume.</source>
        <translation>Zum Ausschalten des Lasers wurde ein Reset gesendet, und die bisherigen Punkte sind gesichert; nachsehen, dass er dunkel ist, Kabel und Strom prüfen, dann fortsetzen.</translation>
    </message>
    <message>
        <source>A rig needs a controller and two cameras that work; what was found: {controller}, cameras: {cameras}.</source>
        <translation>Ein Messplatz braucht eine Steuerung und zwei Kameras, die arbeiten; gefunden wurde: {controller}, Kameras: {cameras}.</translation>
    </message>
    <message>
        <source>A scan by a laser line is not steered by the uncertainty that it reaches.</source>
        <translation>Ein Scan mit einer Laserlinie wird nicht nach der erreichten Unsicherheit gesteuert.</translation>
    </message>
    <message>
        <source>All lengths are off by as much; calibrate, or check &apos;distances_mm&apos; in the table [marks] of the rig file.</source>
        <translation>Alle Längen weichen um so viel ab; kalibrieren oder &apos;distances_mm&apos; in der Tabelle [marks] der Messplatzdatei prüfen.</translation>
    </message>
    <message>
        <source>All points are kept in {path}; pick three points on both mounts (&apos;impronta register CASE --pairs FILE&apos;), or scan another mount that shares more with the earlier ones.</source>
        <translation>Alle Punkte sind in {path} gesichert; auf beiden Aufstellungen drei Punkte wählen (&apos;impronta register CASE --pairs FILE&apos;) oder eine weitere Aufstellung scannen, die mehr mit den früheren gemeinsam hat.</translation>
    </message>
    <message>
        <source>All points are kept; measure another mount that shares more.</source>
        <translation>Alle Punkte sind gesichert; eine weitere Aufstellung messen, die mehr gemeinsam hat.</translation>
    </message>
    <message>
        <source>Both cameras of the rig file are the same one ({id}).</source>
        <translation>Beide Kameras der Messplatzdatei sind dieselbe ({id}).</translation>
    </message>
    <message>
        <source>Both files are untouched and nothing was mirrored; choose the same side, or export the mirrored one again without mirroring.</source>
        <translation>Beide Dateien sind unberührt, und nichts wurde gespiegelt; dieselbe Seite wählen oder die gespiegelte noch einmal ohne Spiegeln exportieren.</translation>
    </message>
    <message>
        <source>Both files are untouched; check that they show the same object and that the normals of both point outwards, then pick three points on both.</source>
        <translation>Beide Dateien sind unberührt; prüfen, ob sie dasselbe Objekt zeigen und beide Normalen nach außen zeigen, dann auf beiden drei Punkte wählen.</translation>
    </message>
    <message>
        <source>Both files are untouched; let the program find the pose, or pick three points on both.</source>
        <translation>Beide Dateien sind unberührt; das Programm die Lage suchen lassen oder auf beiden drei Punkte wählen.</translation>
    </message>
    <message>
        <source>Camera {camera} ({id}) cannot be opened: {reason}.</source>
        <translation>Kamera {camera} ({id}) lässt sich nicht öffnen: {reason}.</translation>
    </message>
    <message>
        <source>Camera {camera} ({id}) is used by another program.</source>
        <translation>Kamera {camera} ({id}) wird von einem anderen Programm benutzt.</translation>
    </message>
    <message>
        <source>Camera {camera} cannot be triggered by {line}; it has: {lines}.</source>
        <translation>Kamera {camera} lässt sich nicht über {line} auslösen; sie hat: {lines}.</translation>
    </message>
    <message>
        <source>Camera {camera} delivered frames faster than they could be evaluated: {frames} frames are waiting.</source>
        <translation>Kamera {camera} lieferte Bilder schneller, als sie ausgewertet werden konnten: {frames} Bilder warten.</translation>
    </message>
    <message>
        <source>Camera {camera} delivered {count} torn frames of {exposures}: part of each is another exposure&apos;s, or no picture.</source>
        <translation>Kamera {camera} lieferte {count} zerrissene Bilder auf {exposures} Belichtungen: Ein Teil jedes Bildes gehört zu einer anderen Belichtung oder ist kein Bild.</translation>
    </message>
    <message>
        <source>Camera {camera} did not deliver {count} of {exposures} frames ({share} % of the last ones).</source>
        <translation>Kamera {camera} lieferte {count} von {exposures} Bildern nicht ({share} % der letzten).</translation>
    </message>
    <message>
        <source>Camera {camera} gave no frame within {seconds} s.</source>
        <translation>Kamera {camera} lieferte innerhalb von {seconds} s kein Bild.</translation>
    </message>
    <message>
        <source>Camera {camera} gives black frames.</source>
        <translation>Kamera {camera} liefert schwarze Bilder.</translation>
    </message>
    <message>
        <source>Camera {camera} gives frames of another kind than can be measured: {reason}.</source>
        <translation>Kamera {camera} liefert andere Bilder, als gemessen werden können: {reason}.</translation>
    </message>
    <message>
        <source>Camera {camera} gives {measured_hz} frames/s where {wanted_hz} were asked for.</source>
        <translation>Kamera {camera} liefert {measured_hz} Bilder/s, verlangt waren {wanted_hz}.</translation>
    </message>
    <message>
        <source>Camera {camera} is blind: {frames} spots in a row were seen by camera {other} alone.</source>
        <translation>Kamera {camera} ist blind: {frames} Lichtpunkte in Folge sah nur Kamera {other}.</translation>
    </message>
    <message>
        <source>Camera {camera} is driven through OpenCV, which cannot trigger it by {trigger}.</source>
        <translation>Kamera {camera} läuft über OpenCV, das sie nicht über {trigger} auslösen kann.</translation>
    </message>
    <message>
        <source>Camera {camera} reported a fault: {reason}.</source>
        <translation>Kamera {camera} meldete einen Fehler: {reason}.</translation>
    </message>
    <message>
        <source>Camera {camera} was unplugged.</source>
        <translation>Kamera {camera} wurde ausgesteckt.</translation>
    </message>
    <message>
        <source>Camera {camera} was used after it had been closed.</source>
        <translation>Kamera {camera} wurde benutzt, nachdem sie geschlossen war.</translation>
    </message>
    <message>
        <source>DICOM files are written by the package pydicom, which is not installed.</source>
        <translation>DICOM-Dateien schreibt das Paket pydicom, das nicht installiert ist.</translation>
    </message>
    <message>
        <source>Everything measured so far is safe and a new worker was started; run it again.</source>
        <translation>Alles bisher Gemessene ist sicher, und ein neuer Arbeitsprozess wurde gestartet; noch einmal ausführen.</translation>
    </message>
    <message>
        <source>Everything measured so far is safe; send the log if it happens again.</source>
        <translation>Alles bisher Gemessene ist sicher; geschieht es wieder, das Protokoll einsenden.</translation>
    </message>
    <message>
        <source>Everything written before is kept; open it again.</source>
        <translation>Alles zuvor Geschriebene ist gesichert; wieder öffnen.</translation>
    </message>
    <message>
        <source>Files of the kind &apos;{suffix}&apos; cannot be written.</source>
        <translation>Dateien der Art &apos;{suffix}&apos; lassen sich nicht schreiben.</translation>
    </message>
    <message>
        <source>In the best pose the new mount stands where light to the earlier one passed: {share} % of it.</source>
        <translation>In der besten Lage steht die neue Aufstellung dort, wo Licht zur früheren hindurchging: {share} % von ihr.</translation>
    </message>
    <message>
        <source>It contradicts the others: the loop of mounts would close with an error of {closure_um} um.</source>
        <translation>Sie widerspricht den anderen: Der Ring der Aufstellungen schlösse sich mit einem Fehler von {closure_um} µm.</translation>
    </message>
    <message>
        <source>It is left out of the list; correct the file or remove it.</source>
        <translation>Es fehlt in der Liste; die Datei berichtigen oder entfernen.</translation>
    </message>
    <message>
        <source>It is not used; take more views with the board filling the volume.</source>
        <translation>Sie wird nicht benutzt; weitere Ansichten aufnehmen, in denen die Tafel das Messvolumen füllt.</translation>
    </message>
    <message>
        <source>It was not touched; choose another name, or overwrite it with --force.</source>
        <translation>Sie wurde nicht angerührt; anderen Namen wählen oder mit --force überschreiben.</translation>
    </message>
    <message>
        <source>It was not touched; open it with the newer program.</source>
        <translation>Er wurde nicht angerührt; mit dem neueren Programm öffnen.</translation>
    </message>
    <message>
        <source>It was not touched; scan into a new case.</source>
        <translation>Er wurde nicht angerührt; in einen neuen Fall scannen.</translation>
    </message>
    <message>
        <source>It was switched off again; check the controller&apos;s settings $30 to $32.</source>
        <translation>Er wurde wieder ausgeschaltet; die Einstellungen $30 bis $32 der Steuerung prüfen.</translation>
    </message>
    <message>
        <source>Its points are kept; fix cameras and object, then scan again.</source>
        <translation>Ihre Punkte sind gesichert; Kameras und Objekt befestigen, dann neu scannen.</translation>
    </message>
    <message>
        <source>Its points may be right; a shape without rotational symmetry would tell.</source>
        <translation>Seine Punkte können stimmen; eine Form ohne Drehsymmetrie würde es zeigen.</translation>
    </message>
    <message>
        <source>Its surface lies nowhere over that of the others.</source>
        <translation>Ihre Oberfläche liegt nirgends über der der anderen.</translation>
    </message>
    <message>
        <source>Lengths from there on are off by as much; let the cameras warm up, calibrate, and scan again.</source>
        <translation>Längen weichen ab dort um so viel ab; Kameras warm werden lassen, kalibrieren und neu scannen.</translation>
    </message>
    <message>
        <source>Mark {number} on the table&apos;s rim was moved by {shift_um} um before the view at {table_deg} deg.</source>
        <translation>Marke {number} am Tellerrand wurde vor der Ansicht bei {table_deg}° um {shift_um} µm verschoben.</translation>
    </message>
    <message>
        <source>Mark {number} on the table&apos;s rim was not found at {table_deg} deg, where nothing should hide it.</source>
        <translation>Marke {number} am Tellerrand wurde bei {table_deg}° nicht gefunden, wo nichts sie verdecken sollte.</translation>
    </message>
    <message>
        <source>Mount {mount} was not joined to the others. {reason}</source>
        <translation>Aufstellung {mount} wurde nicht mit den anderen verbunden. {reason}</translation>
    </message>
    <message>
        <source>Neither camera has seen the laser spot for {frames} exposures ({seconds} s), where the object was before.</source>
        <translation>Keine Kamera sah den Laserpunkt seit {frames} Belichtungen ({seconds} s), wo vorher das Objekt war.</translation>
    </message>
    <message>
        <source>No mesh was written and the points are kept; {do}.</source>
        <translation>Kein Netz wurde geschrieben, und die Punkte sind gesichert; {do}.</translation>
    </message>
    <message>
        <source>No mesh was written; export the points again.</source>
        <translation>Kein Netz wurde geschrieben; die Punkte noch einmal exportieren.</translation>
    </message>
    <message>
        <source>No mesh was written; reconstruct one object at a time, and cut the points of the others off.</source>
        <translation>Kein Netz wurde geschrieben; ein Objekt nach dem anderen rekonstruieren und die Punkte der übrigen abschneiden.</translation>
    </message>
    <message>
        <source>No mesh was written; scan more of the object.</source>
        <translation>Kein Netz wurde geschrieben; mehr vom Objekt scannen.</translation>
    </message>
    <message>
        <source>No mesh was written; scan the object from more sides.</source>
        <translation>Kein Netz wurde geschrieben; das Objekt von mehr Seiten scannen.</translation>
    </message>
    <message>
        <source>No part of the surface in {path} was measured: its vertices all say that nothing supports them.</source>
        <translation>Kein Teil der Oberfläche in {path} wurde gemessen: Alle ihre Eckpunkte sagen, dass nichts sie belegt.</translation>
    </message>
    <message>
        <source>No rig file was written; &apos;impronta doctor --find&apos; says what became of every port and camera.</source>
        <translation>Keine Messplatzdatei wurde geschrieben; &apos;impronta doctor --find&apos; sagt, was mit jedem Anschluss und jeder Kamera ist.</translation>
    </message>
    <message>
        <source>No sphere of {radius_mm} mm radius was found: {points} points were measured, {share} % of them lie on the best candidate.</source>
        <translation>Keine Kugel mit {radius_mm} mm Radius gefunden: {points} Punkte wurden gemessen, {share} % davon liegen auf der besten Kandidatin.</translation>
    </message>
    <message>
        <source>No surface was found: of {planned} planned measurements none gave a point ({reasons}).</source>
        <translation>Keine Oberfläche gefunden: Von {planned} geplanten Messungen ergab keine einen Punkt ({reasons}).</translation>
    </message>
    <message>
        <source>No trigger reached camera {camera} on {line} within {seconds} s.</source>
        <translation>Kein Trigger erreichte Kamera {camera} an {line} innerhalb von {seconds} s.</translation>
    </message>
    <message>
        <source>Nobody can place the artefacts of the test.</source>
        <translation>Niemand kann die Prüfkörper der Prüfung aufstellen.</translation>
    </message>
    <message>
        <source>Nothing answers on the port {port}.</source>
        <translation>Am Anschluss {port} antwortet nichts.</translation>
    </message>
    <message>
        <source>Nothing is measured meanwhile; see to its lens cap, aperture and view.</source>
        <translation>Solange wird nichts gemessen; Objektivdeckel, Blende und Sicht der Kamera prüfen.</translation>
    </message>
    <message>
        <source>Nothing is measured meanwhile; see whether the beam is blocked, the laser is off, or the object fell over.</source>
        <translation>Solange wird nichts gemessen; prüfen, ob der Strahl verdeckt, der Laser aus oder das Objekt umgefallen ist.</translation>
    </message>
    <message>
        <source>Nothing is measured meanwhile; shorten the exposure or lower the laser&apos;s power.</source>
        <translation>Solange wird nichts gemessen; kürzer belichten oder die Laserleistung senken.</translation>
    </message>
    <message>
        <source>Nothing is measured meanwhile; switch the lamp off.</source>
        <translation>Solange wird nichts gemessen; Lampe ausschalten.</translation>
    </message>
    <message>
        <source>Nothing was changed; check the name.</source>
        <translation>Nichts wurde geändert; den Namen prüfen.</translation>
    </message>
    <message>
        <source>Nothing was changed; choose another folder or give permission.</source>
        <translation>Nichts wurde geändert; anderen Ordner wählen oder die Berechtigung geben.</translation>
    </message>
    <message>
        <source>Nothing was changed; close it there, or choose another case.</source>
        <translation>Nichts wurde geändert; dort schließen oder anderen Fall wählen.</translation>
    </message>
    <message>
        <source>Nothing was changed; mark more of the tooth.</source>
        <translation>Nichts wurde geändert; mehr vom Zahn markieren.</translation>
    </message>
    <message>
        <source>Nothing was changed; paint more, or use the automatic frame.</source>
        <translation>Nichts wurde geändert; mehr malen oder den automatischen Bezug nehmen.</translation>
    </message>
    <message>
        <source>Nothing was changed; pick at least three points far from each other, in the same order on both surfaces.</source>
        <translation>Nichts wurde geändert; mindestens drei Punkte weit auseinander wählen, auf beiden Oberflächen in gleicher Reihenfolge.</translation>
    </message>
    <message>
        <source>Nothing was changed; write one line a point: mount, x, y, z on that mount, and x, y, z of the same place on the first mount, in mm.</source>
        <translation>Nichts wurde geändert; je Punkt eine Zeile schreiben: Aufstellung, x, y, z auf dieser Aufstellung und x, y, z derselben Stelle auf der ersten Aufstellung, in mm.</translation>
    </message>
    <message>
        <source>Nothing was changed; {do}.</source>
        <translation>Nichts wurde geändert; {do}.</translation>
    </message>
    <message>
        <source>Nothing was compared; choose the whole surface.</source>
        <translation>Nichts wurde verglichen; die ganze Oberfläche wählen.</translation>
    </message>
    <message>
        <source>Nothing was compared; export the mesh again from its program.</source>
        <translation>Nichts wurde verglichen; das Netz noch einmal aus seinem Programm exportieren.</translation>
    </message>
    <message>
        <source>Nothing was compared; mark the stable part again.</source>
        <translation>Nichts wurde verglichen; den stabilen Teil neu markieren.</translation>
    </message>
    <message>
        <source>Nothing was compared; scan it again, or reconstruct it from its points.</source>
        <translation>Nichts wurde verglichen; neu scannen oder aus den Punkten rekonstruieren.</translation>
    </message>
    <message>
        <source>Nothing was done; check the file.</source>
        <translation>Nichts wurde getan; die Datei prüfen.</translation>
    </message>
    <message>
        <source>Nothing was done; check the name.</source>
        <translation>Nichts wurde getan; den Namen prüfen.</translation>
    </message>
    <message>
        <source>Nothing was done; export the mesh again from its program.</source>
        <translation>Nichts wurde getan; das Netz noch einmal aus seinem Programm exportieren.</translation>
    </message>
    <message>
        <source>Nothing was done; use PLY, XYZ, TXT, CSV, ASC, NPY or a case.</source>
        <translation>Nichts wurde getan; PLY, XYZ, TXT, CSV, ASC, NPY oder einen Fall nehmen.</translation>
    </message>
    <message>
        <source>Nothing was done; use STL, PLY, OBJ, VTP or 3MF.</source>
        <translation>Nichts wurde getan; STL, PLY, OBJ, VTP oder 3MF nehmen.</translation>
    </message>
    <message>
        <source>Nothing was joined and all points are kept; measure more of it.</source>
        <translation>Nichts wurde verbunden, und alle Punkte sind gesichert; mehr davon messen.</translation>
    </message>
    <message>
        <source>Nothing was joined and all points are kept; pick three points far from each other, in the same order on both.</source>
        <translation>Nichts wurde verbunden, und alle Punkte sind gesichert; drei Punkte weit auseinander wählen, auf beiden in gleicher Reihenfolge.</translation>
    </message>
    <message>
        <source>Nothing was joined and all points are kept; pick three points on both, or measure another mount that shares more with the earlier ones.</source>
        <translation>Nichts wurde verbunden, und alle Punkte sind gesichert; auf beiden drei Punkte wählen oder eine weitere Aufstellung messen, die mehr mit den früheren gemeinsam hat.</translation>
    </message>
    <message>
        <source>Nothing was joined and all points are kept; see that the object did not change its shape, and measure the mount again.</source>
        <translation>Nichts wurde verbunden, und alle Punkte sind gesichert; prüfen, dass das Objekt seine Form behielt, und die Aufstellung neu messen.</translation>
    </message>
    <message>
        <source>Nothing was measured; ask for a number of points instead, or scan by the spot.</source>
        <translation>Nichts wurde gemessen; stattdessen eine Punktzahl verlangen oder mit dem Laserpunkt scannen.</translation>
    </message>
    <message>
        <source>Nothing was measured; choose another recording.</source>
        <translation>Nichts wurde gemessen; andere Aufzeichnung wählen.</translation>
    </message>
    <message>
        <source>Nothing was measured; correct &apos;pixel_format&apos; or &apos;size_px&apos; in the rig file.</source>
        <translation>Nichts wurde gemessen; &apos;pixel_format&apos; oder &apos;size_px&apos; in der Messplatzdatei berichtigen.</translation>
    </message>
    <message>
        <source>Nothing was measured; correct &apos;trigger_line&apos; in the rig file.</source>
        <translation>Nichts wurde gemessen; &apos;trigger_line&apos; in der Messplatzdatei berichtigen.</translation>
    </message>
    <message>
        <source>Nothing was measured; give both the same &apos;rate_hz&apos; in the rig file.</source>
        <translation>Nichts wurde gemessen; beiden in der Messplatzdatei dieselbe &apos;rate_hz&apos; geben.</translation>
    </message>
    <message>
        <source>Nothing was measured; plug it into a USB port of its own, choose a smaller size, or lower &apos;rate_hz&apos; in the rig file.</source>
        <translation>Nichts wurde gemessen; an einen eigenen USB-Anschluss stecken, kleinere Größe wählen oder &apos;rate_hz&apos; in der Messplatzdatei senken.</translation>
    </message>
    <message>
        <source>Nothing was measured; run &apos;impronta calibrate&apos; or the Rig page first.</source>
        <translation>Nichts wurde gemessen; zuerst &apos;impronta calibrate&apos; ausführen oder auf der Seite Messplatz kalibrieren.</translation>
    </message>
    <message>
        <source>Nothing was measured; run it where a person or the virtual bench can.</source>
        <translation>Nichts wurde gemessen; dort ausführen, wo eine Person oder die virtuelle Werkbank es kann.</translation>
    </message>
    <message>
        <source>Nothing was measured; take the lens cap off, open the shutter, and look at &apos;exposure_ms&apos; in the rig file.</source>
        <translation>Nichts wurde gemessen; Objektivdeckel abnehmen, Verschluss öffnen und &apos;exposure_ms&apos; in der Messplatzdatei prüfen.</translation>
    </message>
    <message>
        <source>Nothing was moved; choose another port in the rig file.</source>
        <translation>Nichts wurde bewegt; anderen Anschluss in der Messplatzdatei wählen.</translation>
    </message>
    <message>
        <source>Nothing was moved; choose another target, or correct the limits.</source>
        <translation>Nichts wurde bewegt; anderes Ziel wählen oder die Grenzen berichtigen.</translation>
    </message>
    <message>
        <source>Nothing was moved; close the other program and connect again.</source>
        <translation>Nichts wurde bewegt; das andere Programm schließen und neu verbinden.</translation>
    </message>
    <message>
        <source>Nothing was moved; correct &apos;table_axis&apos; in the rig file.</source>
        <translation>Nichts wurde bewegt; &apos;table_axis&apos; in der Messplatzdatei berichtigen.</translation>
    </message>
    <message>
        <source>Nothing was moved; correct the file or take one of the presets.</source>
        <translation>Nichts wurde bewegt; die Datei berichtigen oder eine der Vorlagen nehmen.</translation>
    </message>
    <message>
        <source>Nothing was moved; give the left and the right camera each an &apos;id&apos; of its own.</source>
        <translation>Nichts wurde bewegt; der linken und der rechten Kamera je eine eigene &apos;id&apos; geben.</translation>
    </message>
    <message>
        <source>Nothing was moved; install GRBL 1.1 or grblHAL with laser power on its PWM output.</source>
        <translation>Nichts wurde bewegt; GRBL 1.1 oder grblHAL mit der Laserleistung am PWM-Ausgang installieren.</translation>
    </message>
    <message>
        <source>Nothing was moved; install GRBL 1.1 or newer on the controller.</source>
        <translation>Nichts wurde bewegt; GRBL 1.1 oder neuer auf der Steuerung installieren.</translation>
    </message>
    <message>
        <source>Nothing was moved; install the rule of packaging/udev or join the group &apos;dialout&apos;, then log in again.</source>
        <translation>Nichts wurde bewegt; die Regel aus packaging/udev installieren oder der Gruppe &apos;dialout&apos; beitreten, dann neu anmelden.</translation>
    </message>
    <message>
        <source>Nothing was moved; install the rule of packaging/udev or join the group &apos;video&apos;, then log in again.</source>
        <translation>Nichts wurde bewegt; die Regel aus packaging/udev installieren oder der Gruppe &apos;video&apos; beitreten, dann neu anmelden.</translation>
    </message>
    <message>
        <source>Nothing was moved; plug it in, or correct &apos;id&apos; in the rig file.</source>
        <translation>Nichts wurde bewegt; einstecken oder &apos;id&apos; in der Messplatzdatei berichtigen.</translation>
    </message>
    <message>
        <source>Nothing was moved; plug the controller in or correct &apos;port&apos; in the rig file.</source>
        <translation>Nichts wurde bewegt; die Steuerung einstecken oder &apos;port&apos; in der Messplatzdatei berichtigen.</translation>
    </message>
    <message>
        <source>Nothing was moved; run: pip install &apos;impronta[{driver}]&apos;.</source>
        <translation>Nichts wurde bewegt; ausführen: pip install &apos;impronta[{driver}]&apos;.</translation>
    </message>
    <message>
        <source>Nothing was moved; see that the controller has power and that the cable carries data, then check &apos;port&apos; and &apos;baud&apos; in the rig file.</source>
        <translation>Nichts wurde bewegt; prüfen, dass die Steuerung Strom hat und das Kabel Daten führt, dann &apos;port&apos; und &apos;baud&apos; in der Messplatzdatei prüfen.</translation>
    </message>
    <message>
        <source>Nothing was moved; unplug it, plug it in again, and connect again.</source>
        <translation>Nichts wurde bewegt; ausstecken, wieder einstecken und neu verbinden.</translation>
    </message>
    <message>
        <source>Nothing was moved; with $32=0 the beam would stand still while lit: send $32=1 to the controller once.</source>
        <translation>Nichts wurde bewegt; mit $32=0 stünde der Strahl leuchtend still: einmal $32=1 an die Steuerung senden.</translation>
    </message>
    <message>
        <source>Nothing was moved; write trigger = &quot;free&quot; into the rig file, or use a camera with a trigger of its own and its own driver.</source>
        <translation>Nichts wurde bewegt; trigger = &quot;free&quot; in die Messplatzdatei schreiben oder eine Kamera mit eigenem Trigger und eigenem Treiber verwenden.</translation>
    </message>
    <message>
        <source>Nothing was scanned; choose a smaller specimen, or scale it (is its unit millimetres?).</source>
        <translation>Nichts wurde gescannt; kleineren Prüfling wählen oder ihn skalieren (ist seine Einheit Millimeter?).</translation>
    </message>
    <message>
        <source>Nothing was scanned; correct the plan.</source>
        <translation>Nichts wurde gescannt; den Plan berichtigen.</translation>
    </message>
    <message>
        <source>Nothing was split and every point is kept; a single impression needs no tray, for a pair set both on their seats and scan again.</source>
        <translation>Nichts wurde aufgeteilt, und jeder Punkt ist gesichert; eine einzelne Abformung braucht keinen Träger, für ein Paar beide auf ihre Sitze stellen und neu scannen.</translation>
    </message>
    <message>
        <source>Nothing was split and every point is kept; take those points out (Edit), or set the impressions on their seats and scan again.</source>
        <translation>Nichts wurde aufgeteilt, und jeder Punkt ist gesichert; diese Punkte herausnehmen (Bearbeiten) oder die Abformungen auf ihre Sitze stellen und neu scannen.</translation>
    </message>
    <message>
        <source>Nothing was touched, and what was measured can be used as it is; scan again into a new case, which takes about half a minute.</source>
        <translation>Nichts wurde angerührt, und das Gemessene ist so verwendbar; neu in einen neuen Fall scannen, das dauert etwa eine halbe Minute.</translation>
    </message>
    <message>
        <source>Nothing was written; close other programs, or ask for fewer points or triangles.</source>
        <translation>Nichts wurde geschrieben; andere Programme schließen oder weniger Punkte oder Dreiecke verlangen.</translation>
    </message>
    <message>
        <source>Nothing was written; install it with pip install &apos;impronta[dicom]&apos;, or choose another format.</source>
        <translation>Nichts wurde geschrieben; mit pip install &apos;impronta[dicom]&apos; installieren oder anderes Format wählen.</translation>
    </message>
    <message>
        <source>Nothing was written; mend that, or deliver it anyway, and the certificate says so.</source>
        <translation>Nichts wurde geschrieben; das beheben oder trotzdem ausliefern, und der Prüfbericht sagt es.</translation>
    </message>
    <message>
        <source>Nothing was written; see what would be in it with --list.</source>
        <translation>Nichts wurde geschrieben; mit --list ansehen, was darin wäre.</translation>
    </message>
    <message>
        <source>Nothing was written; use one of {known}.</source>
        <translation>Nichts wurde geschrieben; eines von {known} nehmen.</translation>
    </message>
    <message>
        <source>Nothing was written; use one of: {known}.</source>
        <translation>Nichts wurde geschrieben; eines davon nehmen: {known}.</translation>
    </message>
    <message>
        <source>Nothing was written; write .ply, .obj or .3mf instead, or move the points nearer to the origin.</source>
        <translation>Nichts wurde geschrieben; stattdessen .ply, .obj oder .3mf schreiben oder die Punkte näher an den Ursprung bringen.</translation>
    </message>
    <message>
        <source>One of {after} and {before} is mirrored, or they show opposite sides: {score} % of the surface agrees as it is, {mirrored} % of its mirror image.</source>
        <translation>Eines von {after} und {before} ist gespiegelt, oder sie zeigen gegenüberliegende Seiten: Ungespiegelt stimmen {score} % der Oberfläche überein, gespiegelt {mirrored} %.</translation>
    </message>
    <message>
        <source>Only {count} points in {path} lie on the seat of the {side} ear.</source>
        <translation>Nur {count} Punkte in {path} liegen auf dem Sitz des Ohrs ({side}).</translation>
    </message>
    <message>
        <source>Over the others its surface is {residual_um} um away (noise explains {most_um} um), and {agree} % of it agrees with theirs.</source>
        <translation>Über den anderen liegt ihre Oberfläche {residual_um} µm entfernt (Rauschen erklärt {most_um} µm), und {agree} % davon stimmen mit deren überein.</translation>
    </message>
    <message>
        <source>Points from there on may be off; see that both cameras are fixed, and calibrate before the next scan.</source>
        <translation>Punkte ab dort können daneben liegen; nachsehen, dass beide Kameras fest sind, und vor dem nächsten Scan kalibrieren.</translation>
    </message>
    <message>
        <source>Room light drowned the laser spot: of {planned} planned measurements none gave a point.</source>
        <translation>Raumlicht überstrahlte den Laserpunkt: Von {planned} geplanten Messungen ergab keine einen Punkt.</translation>
    </message>
    <message>
        <source>Room light drowns the laser spot: {frames} frames in a row of camera {camera} are too bright.</source>
        <translation>Raumlicht überstrahlt den Laserpunkt: {frames} Bilder in Folge von Kamera {camera} sind zu hell.</translation>
    </message>
    <message>
        <source>The ball bar was not found in position {position}: {found} of its two spheres was seen.</source>
        <translation>Der Kugelstab wurde in Position {position} nicht gefunden: {found} seiner zwei Kugeln war zu sehen.</translation>
    </message>
    <message>
        <source>The board&apos;s squares measure {measured_mm} mm where {given_mm} mm was given (by the bar of {bar_mm} mm).</source>
        <translation>Die Felder der Tafel messen {measured_mm} mm, angegeben waren {given_mm} mm (laut dem {bar_mm}-mm-Stab).</translation>
    </message>
    <message>
        <source>The calibration failed: {reason}.</source>
        <translation>Die Kalibrierung ist fehlgeschlagen: {reason}.</translation>
    </message>
    <message>
        <source>The calibration of this rig is not the one with which the scan in {path} was begun.</source>
        <translation>Die Kalibrierung dieses Messplatzes ist nicht die, mit der der Scan in {path} begann.</translation>
    </message>
    <message>
        <source>The calibration was not accepted: {reason}.</source>
        <translation>Die Kalibrierung wurde nicht angenommen: {reason}.</translation>
    </message>
    <message>
        <source>The cameras are exchanged: what is called the right camera stands to the left of the other.</source>
        <translation>Die Kameras sind vertauscht: Die als rechte bezeichnete steht links von der anderen.</translation>
    </message>
    <message>
        <source>The cameras are out of step by {count} frame: camera {late} lost a trigger, and every pair since then mixes two instants.</source>
        <translation>Die Kameras sind um {count} Bild versetzt: Kamera {late} verlor einen Trigger, und jedes Paar seither mischt zwei Augenblicke.</translation>
    </message>
    <message>
        <source>The cameras do not expose together: camera {late} is {skew_ms} ms late.</source>
        <translation>Die Kameras belichten nicht gleichzeitig: Kamera {late} ist {skew_ms} ms zu spät.</translation>
    </message>
    <message>
        <source>The case is unchanged; reconstruct it with &apos;impronta reconstruct&apos; and ask again.</source>
        <translation>Der Fall ist unverändert; mit &apos;impronta reconstruct&apos; rekonstruieren und noch einmal anfragen.</translation>
    </message>
    <message>
        <source>The case is unchanged; reconstruct with fewer triangles.</source>
        <translation>Der Fall ist unverändert; mit weniger Dreiecken rekonstruieren.</translation>
    </message>
    <message>
        <source>The case is unchanged; {do}.</source>
        <translation>Der Fall ist unverändert; {do}.</translation>
    </message>
    <message>
        <source>The case {path} was used after it had been closed.</source>
        <translation>Der Fall {path} wurde benutzt, nachdem er geschlossen war.</translation>
    </message>
    <message>
        <source>The connection to the controller on {port} was lost.</source>
        <translation>Die Verbindung zur Steuerung an {port} ging verloren.</translation>
    </message>
    <message>
        <source>The controller on {port} did not answer &apos;{command}&apos; within {seconds} s.</source>
        <translation>Die Steuerung an {port} beantwortete &apos;{command}&apos; nicht innerhalb von {seconds} s.</translation>
    </message>
    <message>
        <source>The controller on {port} does not tell its setting {setting} ({meaning}).</source>
        <translation>Die Steuerung an {port} nennt ihre Einstellung {setting} ({meaning}) nicht.</translation>
    </message>
    <message>
        <source>The controller on {port} has no axis &apos;{axis}&apos; for the table (it has {axes}).</source>
        <translation>Die Steuerung an {port} hat keine Achse &apos;{axis}&apos; für den Drehteller (sie hat {axes}).</translation>
    </message>
    <message>
        <source>The controller on {port} is not in laser mode ($32={value}).</source>
        <translation>Die Steuerung an {port} ist nicht im Lasermodus ($32={value}).</translation>
    </message>
    <message>
        <source>The controller on {port} reports another position each time although it rests.</source>
        <translation>Die Steuerung an {port} meldet jedes Mal eine andere Position, obwohl sie ruht.</translation>
    </message>
    <message>
        <source>The controller on {port} restarted by itself.</source>
        <translation>Die Steuerung an {port} hat von selbst neu gestartet.</translation>
    </message>
    <message>
        <source>The controller on {port} runs {firmware}, which knows no laser mode.</source>
        <translation>Auf der Steuerung an {port} läuft {firmware}, das keinen Lasermodus kennt.</translation>
    </message>
    <message>
        <source>The controller on {port} was used after it had been closed.</source>
        <translation>Die Steuerung an {port} wurde benutzt, nachdem sie geschlossen war.</translation>
    </message>
    <message>
        <source>The controller refused &apos;{command}&apos; with error:{number} ({meaning}).</source>
        <translation>Die Steuerung lehnte &apos;{command}&apos; mit error:{number} ab ({meaning}).</translation>
    </message>
    <message>
        <source>The controller reports ALARM:{alarm} ({meaning}).</source>
        <translation>Die Steuerung meldet ALARM:{alarm} ({meaning}).</translation>
    </message>
    <message>
        <source>The controller reports a lit laser (S{power}) where it must be dark.</source>
        <translation>Die Steuerung meldet einen leuchtenden Laser (S{power}), wo er dunkel sein muss.</translation>
    </message>
    <message>
        <source>The file is untouched; scan or export the surface again.</source>
        <translation>Die Datei ist unberührt; die Oberfläche neu scannen oder neu exportieren.</translation>
    </message>
    <message>
        <source>The file of picked points {path} cannot be used: {reason}.</source>
        <translation>Die Datei gewählter Punkte {path} ist nicht verwendbar: {reason}.</translation>
    </message>
    <message>
        <source>The file was not touched; choose another file.</source>
        <translation>Die Datei wurde nicht angerührt; andere Datei wählen.</translation>
    </message>
    <message>
        <source>The frames of camera {camera} cannot be recorded into {path}: {reason}.</source>
        <translation>Die Bilder von Kamera {camera} lassen sich nicht nach {path} aufzeichnen: {reason}.</translation>
    </message>
    <message>
        <source>The interrupted scan cannot go on: of {known} known points {seen} were found again, {shift_um} um beside where they were.</source>
        <translation>Der unterbrochene Scan kann nicht weitergehen: Von {known} bekannten Punkten wurden {seen} wiedergefunden, {shift_um} µm neben ihrem Platz.</translation>
    </message>
    <message>
        <source>The interrupted scan cannot go on: the marks on the table&apos;s rim are seen {shift_um} um beside where they were ({cause}).</source>
        <translation>Der unterbrochene Scan kann nicht weitergehen: Die Marken am Tellerrand liegen {shift_um} µm neben ihrem Platz ({cause}).</translation>
    </message>
    <message>
        <source>The interrupted scan of {path} was made by a laser line, which is not resumed.</source>
        <translation>Der unterbrochene Scan von {path} entstand mit einer Laserlinie, das lässt sich nicht fortsetzen.</translation>
    </message>
    <message>
        <source>The laser did not light although it was asked to.</source>
        <translation>Der Laser leuchtete nicht, obwohl es verlangt war.</translation>
    </message>
    <message>
        <source>The laser is off and everything written before is kept; free some space and go on.</source>
        <translation>Der Laser ist aus, und alles zuvor Geschriebene ist gesichert; Platz schaffen und weitermachen.</translation>
    </message>
    <message>
        <source>The laser is off and the points so far are in {case}.</source>
        <translation>Der Laser ist aus, und die bisherigen Punkte sind in {case}.</translation>
    </message>
    <message>
        <source>The laser is off and the points so far are kept; check its cable and resume.</source>
        <translation>Der Laser ist aus, und die bisherigen Punkte sind gesichert; ihr Kabel prüfen und fortsetzen.</translation>
    </message>
    <message>
        <source>The laser is off and the points so far are kept; check the trigger cable, or set trigger = &quot;free&quot; in the rig file.</source>
        <translation>Der Laser ist aus, und die bisherigen Punkte sind gesichert; Triggerkabel prüfen oder trigger = &quot;free&quot; in die Messplatzdatei setzen.</translation>
    </message>
    <message>
        <source>The laser is off and the points so far are kept; close other programs and resume.</source>
        <translation>Der Laser ist aus, und die bisherigen Punkte sind gesichert; andere Programme schließen und fortsetzen.</translation>
    </message>
    <message>
        <source>The laser is off and the points so far are kept; close the door and resume.</source>
        <translation>Der Laser ist aus, und die bisherigen Punkte sind gesichert; Tür schließen und fortsetzen.</translation>
    </message>
    <message>
        <source>The laser is off and the points so far are kept; free some space or choose another folder, and resume.</source>
        <translation>Der Laser ist aus, und die bisherigen Punkte sind gesichert; Platz schaffen oder anderen Ordner wählen und fortsetzen.</translation>
    </message>
    <message>
        <source>The laser is off and the points so far are kept; its position is lost, home it and resume.</source>
        <translation>Der Laser ist aus, und die bisherigen Punkte sind gesichert; ihre Position ist verloren, Referenz suchen und fortsetzen.</translation>
    </message>
    <message>
        <source>The laser is off and the points so far are kept; plug it in and resume.</source>
        <translation>Der Laser ist aus, und die bisherigen Punkte sind gesichert; einstecken und fortsetzen.</translation>
    </message>
    <message>
        <source>The laser is off and the points so far are kept; resume when the rig is free.</source>
        <translation>Der Laser ist aus, und die bisherigen Punkte sind gesichert; fortsetzen, wenn der Messplatz frei ist.</translation>
    </message>
    <message>
        <source>The laser is off and the points so far are kept; unplug the camera, plug it in again, and resume.</source>
        <translation>Der Laser ist aus, und die bisherigen Punkte sind gesichert; Kamera ausstecken, wieder einstecken und fortsetzen.</translation>
    </message>
    <message>
        <source>The laser is off and the points so far are kept; {remedy}.</source>
        <translation>Der Laser ist aus, und die bisherigen Punkte sind gesichert; {remedy}.</translation>
    </message>
    <message>
        <source>The laser is off and what was measured before is kept; put table and cameras back as they were and resume, or scan anew.</source>
        <translation>Der Laser ist aus, und das zuvor Gemessene ist gesichert; Teller und Kameras zurückstellen und fortsetzen oder von vorn scannen.</translation>
    </message>
    <message>
        <source>The laser is off and what was measured before is kept; put the object and the cameras back as they were and resume, or scan anew.</source>
        <translation>Der Laser ist aus, und das zuvor Gemessene ist gesichert; Objekt und Kameras zurückstellen und fortsetzen oder von vorn scannen.</translation>
    </message>
    <message>
        <source>The laser is off and what was measured before is kept; switch the lamp off, then resume or scan again.</source>
        <translation>Der Laser ist aus, und das zuvor Gemessene ist gesichert; Lampe ausschalten, dann fortsetzen oder neu scannen.</translation>
    </message>
    <message>
        <source>The laser is off; ask for more points, or more views.</source>
        <translation>Der Laser ist aus; mehr Punkte oder mehr Ansichten verlangen.</translation>
    </message>
    <message>
        <source>The laser is off; check --spacing-mm and that nothing else of the spheres&apos; size stands in the volume.</source>
        <translation>Der Laser ist aus; --spacing-mm prüfen, und dass nichts anderes von der Größe der Kugeln im Messvolumen steht.</translation>
    </message>
    <message>
        <source>The laser is off; check the rig file and the controller&apos;s settings.</source>
        <translation>Der Laser ist aus; Messplatzdatei und Einstellungen der Steuerung prüfen.</translation>
    </message>
    <message>
        <source>The laser is off; open the rig again.</source>
        <translation>Der Laser ist aus; den Messplatz neu öffnen.</translation>
    </message>
    <message>
        <source>The laser is off; place the bar as the plan of the test says, and check --reference-mm.</source>
        <translation>Der Laser ist aus; den Stab nach dem Plan der Prüfung aufstellen und --reference-mm prüfen.</translation>
    </message>
    <message>
        <source>The laser is off; put the matt white plate into the middle of the volume, facing the cameras, and keep the lamps away.</source>
        <translation>Der Laser ist aus; die matte weiße Platte in die Mitte des Messvolumens stellen, zu den Kameras gewandt, und Lampen fernhalten.</translation>
    </message>
    <message>
        <source>The laser is off; put the object on the table, and check the laser and the lens caps.</source>
        <translation>Der Laser ist aus; das Objekt auf den Teller stellen und Laser und Objektivdeckel prüfen.</translation>
    </message>
    <message>
        <source>The laser is off; put the reference sphere alone into the middle of the table, and check the size that was given.</source>
        <translation>Der Laser ist aus; die Referenzkugel allein in die Tellermitte stellen und das angegebene Maß prüfen.</translation>
    </message>
    <message>
        <source>The laser is off; take all but one away and start the test again.</source>
        <translation>Der Laser ist aus; alle bis auf eine wegnehmen und die Prüfung neu starten.</translation>
    </message>
    <message>
        <source>The laser may be on: switch off its power before you reach into the rig, then connect again.</source>
        <translation>Der Laser kann an sein: seinen Strom abschalten, bevor jemand in den Messplatz greift, dann neu verbinden.</translation>
    </message>
    <message>
        <source>The laser spot is saturated in {frames} frames in a row of camera {camera}.</source>
        <translation>Der Laserpunkt ist in {frames} Bildern in Folge von Kamera {camera} übersteuert.</translation>
    </message>
    <message>
        <source>The laser was switched off and the points so far are kept; free the machine of other work, then resume.</source>
        <translation>Der Laser wurde ausgeschaltet, und die bisherigen Punkte sind gesichert; den Rechner von anderer Arbeit befreien, dann fortsetzen.</translation>
    </message>
    <message>
        <source>The laser was switched off by a reset; connect again.</source>
        <translation>Der Laser wurde durch einen Reset ausgeschaltet; neu verbinden.</translation>
    </message>
    <message>
        <source>The left camera gives {left_hz} frames/s and the right one {right_hz}.</source>
        <translation>Die linke Kamera liefert {left_hz} Bilder/s und die rechte {right_hz}.</translation>
    </message>
    <message>
        <source>The marked part holds {marked} measured vertices; at least {least} are needed for a motion.</source>
        <translation>Der markierte Teil enthält {marked} gemessene Eckpunkte; für eine Bewegung sind mindestens {least} nötig.</translation>
    </message>
    <message>
        <source>The mask {path} cannot be used: {reason}.</source>
        <translation>Die Maske {path} ist nicht verwendbar: {reason}.</translation>
    </message>
    <message>
        <source>The material {path} cannot be used: {reason}.</source>
        <translation>Das Material {path} ist nicht verwendbar: {reason}.</translation>
    </message>
    <message>
        <source>The mesh of {path} does not say how certain it is.</source>
        <translation>Das Netz aus {path} sagt nicht, wie sicher es ist.</translation>
    </message>
    <message>
        <source>The motion was stopped during &apos;{command}&apos;.</source>
        <translation>Die Bewegung wurde während &apos;{command}&apos; gestoppt.</translation>
    </message>
    <message>
        <source>The new mount fits in more than one way: a pose that is turned by {angle} degrees against the best one fits about as well.</source>
        <translation>Die neue Aufstellung passt auf mehr als eine Weise: Eine um {angle} Grad gegen die beste gedrehte Lage passt etwa ebenso gut.</translation>
    </message>
    <message>
        <source>The new mount fits nowhere on what was measured before: in the best pose only {agree} % of the surface that both show agrees.</source>
        <translation>Die neue Aufstellung passt nirgends auf das zuvor Gemessene: In der besten Lage stimmen nur {agree} % der gemeinsam gezeigten Oberfläche überein.</translation>
    </message>
    <message>
        <source>The new mount shares too little with what was measured before: {overlap} % of it, and at least {least} % are needed.</source>
        <translation>Die neue Aufstellung hat zu wenig mit dem zuvor Gemessenen gemeinsam: {overlap} % von ihr, mindestens {least} % sind nötig.</translation>
    </message>
    <message>
        <source>The new mount, or what was measured before, has too few points to find its place: {points}, but at least {least} are needed.</source>
        <translation>Die neue Aufstellung oder das zuvor Gemessene hat zu wenige Punkte, um ihre Lage zu finden: {points}, mindestens {least} sind nötig.</translation>
    </message>
    <message>
        <source>The null comparison says nothing of the rig: {reason}.</source>
        <translation>Der Nullvergleich sagt nichts über den Messplatz: {reason}.</translation>
    </message>
    <message>
        <source>The object moved on the table: the views from {table_deg} deg on lie {shift_um} um beside the earlier ones.</source>
        <translation>Das Objekt hat sich auf dem Teller bewegt: Die Ansichten ab {table_deg}° liegen {shift_um} µm neben den früheren.</translation>
    </message>
    <message>
        <source>The picked points do not belong to each other: after the best fit of the surfaces they lie {apart_mm} mm apart.</source>
        <translation>Die gewählten Punkte gehören nicht zueinander: Nach der besten Anpassung der Oberflächen liegen sie {apart_mm} mm auseinander.</translation>
    </message>
    <message>
        <source>The picked points do not say how the surfaces lie: {reason}.</source>
        <translation>Die gewählten Punkte sagen nicht, wie die Oberflächen liegen: {reason}.</translation>
    </message>
    <message>
        <source>The plan {path} cannot be used: {reason}.</source>
        <translation>Der Plan {path} ist nicht verwendbar: {reason}.</translation>
    </message>
    <message>
        <source>The points are kept and the other marks go on watching; fix it, and see that nothing touches it.</source>
        <translation>Die Punkte sind gesichert, und die anderen Marken wachen weiter; sie befestigen und darauf achten, dass nichts sie berührt.</translation>
    </message>
    <message>
        <source>The points are kept and the other marks go on watching; see whether it is covered or was knocked off.</source>
        <translation>Die Punkte sind gesichert, und die anderen Marken wachen weiter; nachsehen, ob sie verdeckt oder abgeschlagen ist.</translation>
    </message>
    <message>
        <source>The points are noisier than they claim; look for vibration, moving reflections or a dirty lens.</source>
        <translation>Die Punkte rauschen stärker, als sie angeben; nach Erschütterungen, bewegten Reflexen oder einem schmutzigen Objektiv suchen.</translation>
    </message>
    <message>
        <source>The points are shifted along the sweep; trigger both cameras from one source.</source>
        <translation>Die Punkte sind längs der Bahn verschoben; beide Kameras aus einer Quelle auslösen.</translation>
    </message>
    <message>
        <source>The points belong to {count} separate objects: the second largest holds {share} % of them and lies {gap_mm} mm from the largest.</source>
        <translation>Die Punkte gehören zu {count} getrennten Objekten: Das zweitgrößte enthält {share} % davon und liegt {gap_mm} mm vom größten.</translation>
    </message>
    <message>
        <source>The points contain {count} values that are not finite numbers, or impossibly far away.</source>
        <translation>Die Punkte enthalten {count} Werte, die keine endlichen Zahlen oder unmöglich weit weg sind.</translation>
    </message>
    <message>
        <source>The points do not enclose a body: {reason}.</source>
        <translation>Die Punkte umschließen keinen Körper: {reason}.</translation>
    </message>
    <message>
        <source>The points from there on are off; fix the cameras, calibrate, and scan again.</source>
        <translation>Die Punkte ab dort liegen daneben; Kameras befestigen, kalibrieren und neu scannen.</translation>
    </message>
    <message>
        <source>The points since then are wrong; check the trigger cable and scan again.</source>
        <translation>Die Punkte seither sind falsch; Triggerkabel prüfen und neu scannen.</translation>
    </message>
    <message>
        <source>The points so far are kept. A sweep ends dark by itself, a standing spot may stay lit: see that the laser is off, plug it in, then resume.</source>
        <translation>Die bisherigen Punkte sind gesichert. Eine Bahn endet von selbst dunkel, ein stehender Laserpunkt kann weiterleuchten: nachsehen, dass der Laser aus ist, einstecken, dann fortsetzen.</translation>
    </message>
    <message>
        <source>The port {port} does not exist or cannot be opened.</source>
        <translation>Den Anschluss {port} gibt es nicht, oder er lässt sich nicht öffnen.</translation>
    </message>
    <message>
        <source>The port {port} is used by another program.</source>
        <translation>Der Anschluss {port} wird von einem anderen Programm benutzt.</translation>
    </message>
    <message>
        <source>The previous calibration stays in use; exchange the two cameras in the rig file, then calibrate again.</source>
        <translation>Die vorige Kalibrierung bleibt in Gebrauch; die Kameras in der Messplatzdatei tauschen, dann neu kalibrieren.</translation>
    </message>
    <message>
        <source>The previous calibration stays in use; give the right size with --square-mm, or the bar&apos;s certified length with --length-mm.</source>
        <translation>Die vorige Kalibrierung bleibt in Gebrauch; die richtige Größe mit --square-mm oder die zertifizierte Länge des Stabs mit --length-mm angeben.</translation>
    </message>
    <message>
        <source>The previous calibration stays in use; take the views again.</source>
        <translation>Die vorige Kalibrierung bleibt in Gebrauch; die Ansichten neu aufnehmen.</translation>
    </message>
    <message>
        <source>The program did not look after the lit laser for {seconds} s.</source>
        <translation>Das Programm kümmerte sich {seconds} s lang nicht um den leuchtenden Laser.</translation>
    </message>
    <message>
        <source>The recording {path} cannot be replayed: {reason}.</source>
        <translation>Die Aufzeichnung {path} lässt sich nicht abspielen: {reason}.</translation>
    </message>
    <message>
        <source>The recording {path} holds no frames for what was asked of camera {camera}: {reason}.</source>
        <translation>Die Aufzeichnung {path} enthält keine Bilder für das, was von Kamera {camera} verlangt wurde: {reason}.</translation>
    </message>
    <message>
        <source>The rig file is unchanged; measure the same model twice.</source>
        <translation>Die Messplatzdatei ist unverändert; dasselbe Modell zweimal messen.</translation>
    </message>
    <message>
        <source>The rig file {path} cannot be used: {reason}.</source>
        <translation>Die Messplatzdatei {path} ist nicht verwendbar: {reason}.</translation>
    </message>
    <message>
        <source>The rig file&apos;s own settings are used; set exposure and sizes on the Aim page again.</source>
        <translation>Die Einstellungen der Messplatzdatei gelten; Belichtung und Größen auf der Seite Anvisieren neu einstellen.</translation>
    </message>
    <message>
        <source>The rig has no calibration.</source>
        <translation>Der Messplatz hat keine Kalibrierung.</translation>
    </message>
    <message>
        <source>The right camera exposes {skew_us} us after the left one, and a moving laser line is then not the same line in both images.</source>
        <translation>Die rechte Kamera belichtet {skew_us} µs nach der linken, und eine bewegte Laserlinie ist dann in beiden Bildern nicht dieselbe Linie.</translation>
    </message>
    <message>
        <source>The safety door of the rig is open.</source>
        <translation>Die Schutztür des Messplatzes ist offen.</translation>
    </message>
    <message>
        <source>The safety relay of the serial port stopped.</source>
        <translation>Das Sicherheitsrelais des seriellen Anschlusses ist stehen geblieben.</translation>
    </message>
    <message>
        <source>The safety relay of the serial port {port} stopped, and the controller could not be reset.</source>
        <translation>Das Sicherheitsrelais des seriellen Anschlusses {port} ist stehen geblieben, und die Steuerung ließ sich nicht zurücksetzen.</translation>
    </message>
    <message>
        <source>The scale changed by {percent} %: since the view at {table_deg} deg the marks on the table&apos;s rim have other distances.</source>
        <translation>Der Maßstab hat sich um {percent} % geändert: Seit der Ansicht bei {table_deg}° haben die Marken am Tellerrand andere Abstände.</translation>
    </message>
    <message>
        <source>The scale is off by {percent} % against the calibrated distances of the marks on the table&apos;s rim.</source>
        <translation>Der Maßstab weicht um {percent} % von den kalibrierten Abständen der Marken am Tellerrand ab.</translation>
    </message>
    <message>
        <source>The scan stopped on an unexpected fault ({reason}).</source>
        <translation>Der Scan stoppte durch eine unerwartete Störung ({reason}).</translation>
    </message>
    <message>
        <source>The software for cameras of the kind &apos;{driver}&apos; is not installed.</source>
        <translation>Die Software für Kameras der Art &apos;{driver}&apos; ist nicht installiert.</translation>
    </message>
    <message>
        <source>The specimen is {size_mm} mm large, but both cameras see a volume of {volume_mm} mm.</source>
        <translation>Der Prüfling ist {size_mm} mm groß, beide Kameras sehen aber ein Volumen von {volume_mm} mm.</translation>
    </message>
    <message>
        <source>The spheres in position {position} stand {measured_mm} mm apart, not {reference_mm} mm.</source>
        <translation>Die Kugeln in Position {position} stehen {measured_mm} mm auseinander, nicht {reference_mm} mm.</translation>
    </message>
    <message>
        <source>The standing spot was seen by both cameras in {seen} of {exposed} exposures only ({reasons}).</source>
        <translation>Der stehende Lichtpunkt wurde von beiden Kameras nur in {seen} von {exposed} Belichtungen gesehen ({reasons}).</translation>
    </message>
    <message>
        <source>The support bundle has no entry &apos;{name}&apos;; it has {known}.</source>
        <translation>Das Support-Paket hat keinen Eintrag &apos;{name}&apos;; es hat {known}.</translation>
    </message>
    <message>
        <source>The surface that both mounts show does not tell how they lie: {directions} of six directions of motion stay open, as on a ball or a cylinder.</source>
        <translation>Die Oberfläche, die beide Aufstellungen zeigen, sagt nicht, wie sie liegen: {directions} von sechs Bewegungsrichtungen bleiben offen, wie bei Kugel oder Zylinder.</translation>
    </message>
    <message>
        <source>The surface that was found is not trustworthy: {reason}.</source>
        <translation>Die gefundene Oberfläche ist nicht vertrauenswürdig: {reason}.</translation>
    </message>
    <message>
        <source>The table lost steps: by the marks on its rim it stands {turn_deg} deg beside its reading, since the view at {table_deg} deg.</source>
        <translation>Der Teller hat Schritte verloren: Nach den Marken an seinem Rand steht er {turn_deg}° neben seiner Anzeige, seit der Ansicht bei {table_deg}°.</translation>
    </message>
    <message>
        <source>The table lost steps: it stands {turn_deg} deg beside its reading{where}.</source>
        <translation>Der Teller hat Schritte verloren: Er steht {turn_deg}° neben seiner Anzeige{where}.</translation>
    </message>
    <message>
        <source>The table or a camera moved: since the view at {table_deg} deg the marks on the table&apos;s rim are seen up to {shift_um} um beside.</source>
        <translation>Der Teller oder eine Kamera hat sich bewegt: Seit der Ansicht bei {table_deg}° liegen die Marken am Tellerrand bis zu {shift_um} µm daneben.</translation>
    </message>
    <message>
        <source>The triangles of {path} all lie in one point or line.</source>
        <translation>Die Dreiecke aus {path} liegen alle in einem Punkt oder einer Linie.</translation>
    </message>
    <message>
        <source>The turn does not close: the first view measured again lies {shift_um} um beside its first measurement.</source>
        <translation>Die Drehung schließt sich nicht: Die erste Ansicht, noch einmal gemessen, liegt {shift_um} µm neben ihrer ersten Messung.</translation>
    </message>
    <message>
        <source>The two ears in {path} cannot be told apart: {count} points lie half way between the seats of the tray.</source>
        <translation>Die beiden Ohren in {path} lassen sich nicht trennen: {count} Punkte liegen auf halbem Weg zwischen den Sitzen des Trägers.</translation>
    </message>
    <message>
        <source>The two images of the spot disagree by {sd_px} px, where {expected_px} px are expected ({where}).</source>
        <translation>Die beiden Bilder des Lichtpunkts weichen um {sd_px} px ab, erwartet werden {expected_px} px ({where}).</translation>
    </message>
    <message>
        <source>The views from there on are turned; see that the table moves freely, and scan again.</source>
        <translation>Die Ansichten ab dort sind verdreht; prüfen, dass der Teller frei läuft, und neu scannen.</translation>
    </message>
    <message>
        <source>The worker process ended unexpectedly during {phase} ({reason}).</source>
        <translation>Der Arbeitsprozess endete unerwartet während {phase} ({reason}).</translation>
    </message>
    <message>
        <source>The worker process failed: {reason}.</source>
        <translation>Der Arbeitsprozess ist gescheitert: {reason}.</translation>
    </message>
    <message>
        <source>The {part} of the rig is not the one with which the scan in {path} was begun.</source>
        <translation>Teil des Messplatzes ({part}) ist nicht der, mit dem der Scan in {path} begann.</translation>
    </message>
    <message>
        <source>Their points are kept; fix the cameras, calibrate, and scan again.</source>
        <translation>Ihre Punkte sind gesichert; Kameras befestigen, kalibrieren und neu scannen.</translation>
    </message>
    <message>
        <source>Their points are kept; fix the object to the table and scan again.</source>
        <translation>Ihre Punkte sind gesichert; das Objekt am Teller befestigen und neu scannen.</translation>
    </message>
    <message>
        <source>There is no camera {camera} ({id}); this machine has: {found}.</source>
        <translation>Es gibt keine Kamera {camera} ({id}); dieser Rechner hat: {found}.</translation>
    </message>
    <message>
        <source>There is no export profile &apos;{name}&apos;.</source>
        <translation>Es gibt kein Exportprofil &apos;{name}&apos;.</translation>
    </message>
    <message>
        <source>There is no space left on the disk of {path}.</source>
        <translation>Auf dem Datenträger von {path} ist kein Platz mehr.</translation>
    </message>
    <message>
        <source>There is not enough memory for &apos;{command}&apos;.</source>
        <translation>Für &apos;{command}&apos; ist nicht genug Speicher da.</translation>
    </message>
    <message>
        <source>This surface is not ready to be delivered: {checks}.</source>
        <translation>Diese Oberfläche ist nicht bereit zur Auslieferung: {checks}.</translation>
    </message>
    <message>
        <source>This user may not open camera {camera} ({id}).</source>
        <translation>Dieser Benutzer darf Kamera {camera} ({id}) nicht öffnen.</translation>
    </message>
    <message>
        <source>This user may not open the port {port}.</source>
        <translation>Dieser Benutzer darf den Anschluss {port} nicht öffnen.</translation>
    </message>
    <message>
        <source>Those measurements are missing; check its cable and port, and close other programs.</source>
        <translation>Diese Messungen fehlen; Kabel und Anschluss prüfen und andere Programme schließen.</translation>
    </message>
    <message>
        <source>Two spheres stand on the table: {first} points lie on the one, {second} on the other.</source>
        <translation>Zwei Kugeln stehen auf dem Teller: {first} Punkte liegen auf der einen, {second} auf der anderen.</translation>
    </message>
    <message>
        <source>What answers on {port} is no GRBL controller (it said: {said}).</source>
        <translation>Was an {port} antwortet, ist keine GRBL-Steuerung (es sagte: {said}).</translation>
    </message>
    <message>
        <source>What was measured is kept; use the rig file of that scan to resume it, or keep what is there and scan anew.</source>
        <translation>Das Gemessene ist gesichert; zum Fortsetzen die Messplatzdatei jenes Scans benutzen, oder Vorhandenes behalten und von vorn scannen.</translation>
    </message>
    <message>
        <source>What was measured so far is kept and the laser is off; let a trigger line expose both cameras at once, then scan again.</source>
        <translation>Das bisher Gemessene ist gesichert, und der Laser ist aus; eine Triggerleitung beide Kameras gleichzeitig auslösen lassen, dann neu scannen.</translation>
    </message>
    <message>
        <source>What was measured so far is kept; replay with the rig, plan and seed that it was recorded with.</source>
        <translation>Das bisher Gemessene ist gesichert; mit Messplatz, Plan und Startwert der Aufzeichnung abspielen.</translation>
    </message>
    <message>
        <source>What was set while aiming cannot be read ({path}: {reason}).</source>
        <translation>Die Einstellungen vom Anvisieren sind nicht lesbar ({path}: {reason}).</translation>
    </message>
    <message>
        <source>Whether the table lost steps cannot be judged on this object: {reason}.</source>
        <translation>Ob der Teller Schritte verlor, lässt sich an diesem Objekt nicht beurteilen: {reason}.</translation>
    </message>
    <message>
        <source>Which of them it was is not decided; the points from there on are off: fix cameras and table, calibrate, and scan again.</source>
        <translation>Was davon es war, ist nicht entschieden; die Punkte ab dort liegen daneben: Kameras und Teller befestigen, kalibrieren und neu scannen.</translation>
    </message>
    <message>
        <source>{after} and {before} do not fit onto each other: in the best pose only {score} % of the surface agrees. They seem to be different objects, or opposite sides of one.</source>
        <translation>{after} und {before} passen nicht aufeinander: In der besten Lage stimmen nur {score} % der Oberfläche überein. Es scheinen verschiedene Objekte zu sein oder gegenüberliegende Seiten von einem.</translation>
    </message>
    <message>
        <source>{after} and {before} do not overlap: nothing of one lies within {reach_mm} mm of the other.</source>
        <translation>{after} und {before} überlappen sich nicht: Nichts vom einen liegt innerhalb von {reach_mm} mm des anderen.</translation>
    </message>
    <message>
        <source>{area_mm2} mm2 with a counterpart are painted as stable; at least {least_mm2} mm2 are needed.</source>
        <translation>{area_mm2} mm² mit Gegenstück sind als stabil gemalt; mindestens {least_mm2} mm² sind nötig.</translation>
    </message>
    <message>
        <source>{axis} cannot go to {target} deg: {whose} allow {low} to {high} deg.</source>
        <translation>{axis} kann nicht auf {target}° fahren: {whose} erlauben {low} bis {high}°.</translation>
    </message>
    <message>
        <source>{name} holds too few measured triangles with an area: {triangles}, but a comparison needs at least {least}.</source>
        <translation>{name} enthält zu wenige gemessene Dreiecke mit Fläche: {triangles}, ein Vergleich braucht mindestens {least}.</translation>
    </message>
    <message>
        <source>{path} cannot be read as points: {reason}.</source>
        <translation>{path} ist nicht als Punkte lesbar: {reason}.</translation>
    </message>
    <message>
        <source>{path} cannot be read: {reason}.</source>
        <translation>{path} ist nicht lesbar: {reason}.</translation>
    </message>
    <message>
        <source>{path} cannot be written: {reason}.</source>
        <translation>{path} lässt sich nicht schreiben: {reason}.</translation>
    </message>
    <message>
        <source>{path} cannot hold this mesh: so far from the origin the numbers of an STL file have steps of {step_mm} mm, wider than its triangles allow.</source>
        <translation>{path} kann dieses Netz nicht fassen: So weit vom Ursprung haben die Zahlen einer STL-Datei Schritte von {step_mm} mm, gröber, als seine Dreiecke erlauben.</translation>
    </message>
    <message>
        <source>{path} does not exist.</source>
        <translation>{path} gibt es nicht.</translation>
    </message>
    <message>
        <source>{path} exists already.</source>
        <translation>{path} gibt es schon.</translation>
    </message>
    <message>
        <source>{path} holds no interrupted scan.</source>
        <translation>{path} enthält keinen unterbrochenen Scan.</translation>
    </message>
    <message>
        <source>{path} holds no triangles.</source>
        <translation>{path} enthält keine Dreiecke.</translation>
    </message>
    <message>
        <source>{path} holds no {what} yet.</source>
        <translation>{path} enthält noch nicht: {what}.</translation>
    </message>
    <message>
        <source>{path} holds too few triangles for a comparison: {triangles}, but at least {least} are needed.</source>
        <translation>{path} enthält zu wenige Dreiecke für einen Vergleich: {triangles}, mindestens {least} sind nötig.</translation>
    </message>
    <message>
        <source>{path} is no Impronta case: {reason}.</source>
        <translation>{path} ist kein Impronta-Fall: {reason}.</translation>
    </message>
    <message>
        <source>{path} is no mesh that can be read: {reason}.</source>
        <translation>{path} ist kein lesbares Netz: {reason}.</translation>
    </message>
    <message>
        <source>{path} is open in another window or program.</source>
        <translation>{path} ist in einem anderen Fenster oder Programm offen.</translation>
    </message>
    <message>
        <source>{path} was written by a newer Impronta (case version {version}, this program knows {known}).</source>
        <translation>{path} wurde von einem neueren Impronta geschrieben (Fallversion {version}, dieses Programm kennt {known}).</translation>
    </message>
    <message>
        <source>{points} points are too few for a sphere; at least {least} are needed.</source>
        <translation>{points} Punkte sind zu wenige für eine Kugel; mindestens {least} sind nötig.</translation>
    </message>
    <message>
        <source>{points} points are too few for a surface; at least {least} are needed.</source>
        <translation>{points} Punkte sind zu wenige für eine Oberfläche; mindestens {least} sind nötig.</translation>
    </message>
    <message>
        <source>{what}.</source>
        <translation>{what}.</translation>
    </message>
</context>
<context>
    <name>sphere</name>
    <message>
        <source>A value is so near its limit that its uncertainty leaves it open: nothing is proved. Measure again.</source>
        <translation>Ein Wert liegt so nah an seiner Grenze, dass seine Unsicherheit es offen lässt: Nichts ist bewiesen. Neu messen.</translation>
    </message>
    <message>
        <source>Certified diameter</source>
        <translation>Zertifizierter Durchmesser</translation>
    </message>
    <message>
        <source>Coverage</source>
        <translation>Abdeckung</translation>
    </message>
    <message>
        <source>Dispersion D95</source>
        <translation>Streuung D95</translation>
    </message>
    <message>
        <source>Failed</source>
        <translation>Nicht bestanden</translation>
    </message>
    <message>
        <source>Form PF without the worst 0.3 %</source>
        <translation>Form PF ohne die schlechtesten 0,3 %</translation>
    </message>
    <message>
        <source>Form PF, all points</source>
        <translation>Form PF, alle Punkte</translation>
    </message>
    <message>
        <source>Kept in the history of this rig.</source>
        <translation>Im Verlauf dieses Messplatzes gesichert.</translation>
    </message>
    <message>
        <source>Measured diameter</source>
        <translation>Gemessener Durchmesser</translation>
    </message>
    <message>
        <source>Measured on every side, from the top down to</source>
        <translation>Auf jeder Seite gemessen, von oben hinab bis</translation>
    </message>
    <message>
        <source>Not kept in the history: a fault was rehearsed on this rig, or it shows a recording.</source>
        <translation>Nicht im Verlauf gesichert: An diesem Messplatz wurde eine Störung geprobt, oder er zeigt eine Aufzeichnung.</translation>
    </message>
    <message>
        <source>Not kept in the history: its file could not be written.</source>
        <translation>Nicht im Verlauf gesichert: Seine Datei ließ sich nicht schreiben.</translation>
    </message>
    <message>
        <source>Passed</source>
        <translation>Bestanden</translation>
    </message>
    <message>
        <source>Points on the sphere</source>
        <translation>Punkte auf der Kugel</translation>
    </message>
    <message>
        <source>Size and D95 are within the rig&apos;s limits, even with their uncertainty added.</source>
        <translation>Maß und D95 liegen innerhalb der Grenzen des Messplatzes, auch mit ihrer Unsicherheit.</translation>
    </message>
    <message>
        <source>Size deviation</source>
        <translation>Maßabweichung</translation>
    </message>
    <message>
        <source>Standard deviation σ of the points</source>
        <translation>Standardabweichung σ der Punkte</translation>
    </message>
    <message>
        <source>The points do not reach down to the sphere&apos;s equator on every side: nothing is proved. See that nothing stands in the way, and measure again.</source>
        <translation>Die Punkte reichen nicht auf jeder Seite bis zum Äquator der Kugel: Nichts ist bewiesen. Prüfen, dass nichts im Weg steht, und neu messen.</translation>
    </message>
    <message>
        <source>The rig measures outside of its limits. Calibrate it, then measure the sphere again.</source>
        <translation>Der Messplatz misst außerhalb seiner Grenzen. Kalibrieren, dann die Kugel neu messen.</translation>
    </message>
    <message>
        <source>Undecided</source>
        <translation>Offen</translation>
    </message>
    <message>
        <source>{count}, and {rejected} left out</source>
        <translation>{count}, {rejected} weggelassen</translation>
    </message>
    <message>
        <source>{reach}° (at least {needed}°)</source>
        <translation>{reach}° (mindestens {needed}°)</translation>
    </message>
    <message>
        <source>{share} % of the surface</source>
        <translation>{share} % der Oberfläche</translation>
    </message>
    <message>
        <source>{value} mm</source>
        <translation>{value} mm</translation>
    </message>
    <message>
        <source>{value} µm</source>
        <translation>{value} µm</translation>
    </message>
    <message>
        <source>{value} µm, U = {uncertainty} µm, limit {limit} µm</source>
        <translation>{value} µm, U = {uncertainty} µm, Grenze {limit} µm</translation>
    </message>
</context>
<context>
    <name>spot</name>
    <message>
        <source>cut by the edge</source>
        <translation>vom Rand abgeschnitten</translation>
    </message>
    <message>
        <source>drawn out</source>
        <translation>gestreckt</translation>
    </message>
    <message>
        <source>no spot</source>
        <translation>kein Lichtpunkt</translation>
    </message>
    <message>
        <source>off the other camera&apos;s line</source>
        <translation>neben der Linie der anderen Kamera</translation>
    </message>
    <message>
        <source>on the table</source>
        <translation>auf dem Teller</translation>
    </message>
    <message>
        <source>one of several</source>
        <translation>einer von mehreren</translation>
    </message>
    <message>
        <source>outside the volume</source>
        <translation>außerhalb des Messvolumens</translation>
    </message>
    <message>
        <source>overexposed</source>
        <translation>überbelichtet</translation>
    </message>
    <message>
        <source>reflection: much dimmer</source>
        <translation>Reflex: viel dunkler</translation>
    </message>
    <message>
        <source>spot clipped: shorten the exposure</source>
        <translation>Lichtpunkt übersteuert: kürzer belichten</translation>
    </message>
    <message>
        <source>spot dim: lengthen the exposure</source>
        <translation>Lichtpunkt schwach: länger belichten</translation>
    </message>
    <message>
        <source>spot too sharp: defocus the lens</source>
        <translation>Lichtpunkt zu scharf: Objektiv defokussieren</translation>
    </message>
    <message>
        <source>spot too wide: focus the lens</source>
        <translation>Lichtpunkt zu breit: Objektiv fokussieren</translation>
    </message>
    <message>
        <source>too dim</source>
        <translation>zu schwach</translation>
    </message>
    <message>
        <source>too large: {area} px</source>
        <translation>zu groß: {area} px</translation>
    </message>
    <message>
        <source>too small: {area} px</source>
        <translation>zu klein: {area} px</translation>
    </message>
</context>
<context>
    <name>support</name>
    <message>
        <source>Checks</source>
        <translation>Prüfungen</translation>
    </message>
    <message>
        <source>How large the cases are and when they changed; nothing of what is in them.</source>
        <translation>Wie groß die Fälle sind und wann sie geändert wurden; nichts von ihrem Inhalt.</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>Rig file</source>
        <translation>Messplatzdatei</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Sizes of the cases</source>
        <translation>Größen der Fälle</translation>
    </message>
    <message>
        <source>The rig as it is used, with its calibration.</source>
        <translation>Der Messplatz, wie er benutzt wird, mit seiner Kalibrierung.</translation>
    </message>
    <message>
        <source>Transcript of the controller</source>
        <translation>Mitschrift der Steuerung</translation>
    </message>
    <message>
        <source>Versions and machine</source>
        <translation>Versionen und Rechner</translation>
    </message>
    <message>
        <source>Versions, system, processors, memory, graphics.</source>
        <translation>Versionen, System, Prozessoren, Speicher, Grafik.</translation>
    </message>
    <message>
        <source>What program and controller said to each other: seconds, direction, line.</source>
        <translation>Was Programm und Steuerung einander sagten: Sekunden, Richtung, Zeile.</translation>
    </message>
    <message>
        <source>What the program noted, the newest at the end.</source>
        <translation>Was das Programm notierte, das Neueste am Ende.</translation>
    </message>
    <message>
        <source>What was checked without moving anything, each with its remedy.</source>
        <translation>Was geprüft wurde, ohne etwas zu bewegen, jeweils mit Abhilfe.</translation>
    </message>
    <message>
        <source>Without folders, recent cases and orders.</source>
        <translation>Ohne Ordner, letzte Fälle und Aufträge.</translation>
    </message>
</context>
<context>
    <name>worklist</name>
    <message>
        <source>Being scanned</source>
        <translation>Wird gescannt</translation>
    </message>
    <message>
        <source>Cannot be read</source>
        <translation>Nicht lesbar</translation>
    </message>
    <message>
        <source>Damaged</source>
        <translation>Beschädigt</translation>
    </message>
    <message>
        <source>Deliver it</source>
        <translation>Ausliefern</translation>
    </message>
    <message>
        <source>Delivered</source>
        <translation>Ausgeliefert</translation>
    </message>
    <message>
        <source>Go on with it</source>
        <translation>Fortsetzen</translation>
    </message>
    <message>
        <source>Interrupted</source>
        <translation>Unterbrochen</translation>
    </message>
    <message>
        <source>Made by a newer version</source>
        <translation>Neuere Version</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Neu</translation>
    </message>
    <message>
        <source>Open in another program</source>
        <translation>Anderswo offen</translation>
    </message>
    <message>
        <source>Open it</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Reconstruct it</source>
        <translation>Rekonstruieren</translation>
    </message>
    <message>
        <source>Reconstructed</source>
        <translation>Rekonstruiert</translation>
    </message>
    <message>
        <source>Scan it</source>
        <translation>Scannen</translation>
    </message>
    <message>
        <source>Scanned</source>
        <translation>Gescannt</translation>
    </message>
</context>
</TS>
