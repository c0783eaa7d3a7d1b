<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="it" sourcelanguage="en">
<context>
    <name>AboutDialog</name>
    <message>
        <source>About Impronta</source>
        <translation>Informazioni su Impronta</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Chiudi</translation>
    </message>
    <message>
        <source>Copy versions</source>
        <translation>Copia versioni</translation>
    </message>
    <message>
        <source>Impronta itself is free software under the MIT licence.</source>
        <translation>Impronta è software libero con licenza MIT.</translation>
    </message>
    <message>
        <source>Impronta {version}</source>
        <translation>Impronta {version}</translation>
    </message>
    <message>
        <source>Its package brings no text of the licence along.</source>
        <translation>Il suo pacchetto non contiene il testo della licenza.</translation>
    </message>
    <message>
        <source>Libraries and their licences</source>
        <translation>Librerie e loro licenze</translation>
    </message>
    <message>
        <source>Libraries in this program</source>
        <translation>Librerie di questo programma</translation>
    </message>
    <message>
        <source>Measures an object with two cameras and a laser spot, and turns the points into a closed surface: ear impressions, dental models.</source>
        <translation>Misura un oggetto con due telecamere e un punto laser, e fa dei punti una superficie chiusa: impronte auricolari, modelli dentali.</translation>
    </message>
    <message>
        <source>Names and versions of everything in this program, as text</source>
        <translation>Nomi e versioni di tutto ciò che è nel programma, come testo</translation>
    </message>
    <message>
        <source>Text of the licence</source>
        <translation>Testo della licenza</translation>
    </message>
    <message>
        <source>The method is the published one of G. Tognola et al., “Contact-less 3D-Coordinate Measurement System by Laser Scanning and Image Reconstruction from Unorganized Data”: two cameras see a laser spot, and a surface adapts itself to the points.</source>
        <translation>Il metodo è quello pubblicato da G. Tognola et al., “Contact-less 3D-Coordinate Measurement System by Laser Scanning and Image Reconstruction from Unorganized Data”: due telecamere vedono un punto laser, e una superficie si adatta ai punti.</translation>
    </message>
</context>
<context>
    <name>AccuracyCard</name>
    <message>
        <source>95 % of the measured points lie within this width around the sphere</source>
        <translation>Il 95 % dei punti misurati sta entro questa fascia attorno alla sfera</translation>
    </message>
    <message>
        <source>Calibrated on {date}; {rms} µm rms at corners of the board that were left out.</source>
        <translation>Calibrato il {date}; {rms} µm rms agli angoli della scacchiera lasciati fuori.</translation>
    </message>
    <message>
        <source>Diameter of the reference sphere as measured, less what its certificate says</source>
        <translation>Diametro misurato della sfera di riferimento, meno quello del suo certificato</translation>
    </message>
    <message>
        <source>How accurate is it?</source>
        <translation>Quanto è accurato?</translation>
    </message>
    <message>
        <source>It measures otherwise than in the tests before: calibrate, and test it again.</source>
        <translation>Misura in modo diverso dalle prove precedenti: calibrare e rifare la prova.</translation>
    </message>
    <message>
        <source>Measure the sphere…</source>
        <translation>Misura la sfera…</translation>
    </message>
    <message>
        <source>No reference sphere was measured with this rig yet.</source>
        <translation>Nessuna sfera di riferimento ancora misurata con questo banco.</translation>
    </message>
    <message>
        <source>Reference sphere, {date} ({age})</source>
        <translation>Sfera di riferimento, {date} ({age})</translation>
    </message>
    <message>
        <source>The Rig page says what is wrong with the rig file.</source>
        <translation>La pagina Banco dice che cosa non va nel file del banco.</translation>
    </message>
    <message>
        <source>The rig was calibrated since: measure the sphere again.</source>
        <translation>Da allora il banco è stato calibrato: misurare di nuovo la sfera.</translation>
    </message>
    <message>
        <source>The test is {n} days old: measure the sphere again.</source>
        <translation>La prova ha {n} giorni: misurare di nuovo la sfera.</translation>
    </message>
    <message>
        <source>This rig is not calibrated. The Rig page does that in a few minutes.</source>
        <translation>Banco non calibrato. Si fa in pochi minuti dalla pagina Banco.</translation>
    </message>
    <message>
        <source>µm D95</source>
        <translation>µm D95</translation>
    </message>
    <message>
        <source>µm size deviation</source>
        <translation>µm scarto di misura</translation>
    </message>
</context>
<context>
    <name>AimPage</name>
    <message>
        <source>Aim</source>
        <translation>Puntamento</translation>
    </message>
    <message>
        <source>Automatic exposure</source>
        <translation>Esposizione automatica</translation>
    </message>
    <message>
        <source>Beam down</source>
        <translation>Raggio in basso</translation>
    </message>
    <message>
        <source>Beam left</source>
        <translation>Raggio a sinistra</translation>
    </message>
    <message>
        <source>Beam right</source>
        <translation>Raggio a destra</translation>
    </message>
    <message>
        <source>Beam up</source>
        <translation>Raggio in alto</translation>
    </message>
    <message>
        <source>By hand</source>
        <translation>Manuale</translation>
    </message>
    <message>
        <source>Camera left</source>
        <translation>Telecamera sinistra</translation>
    </message>
    <message>
        <source>Camera right</source>
        <translation>Telecamera destra</translation>
    </message>
    <message>
        <source>Finds exposure and gain for the object: the beam visits some places of it</source>
        <translation>Trova esposizione e guadagno per l&apos;oggetto: il raggio ne visita alcuni punti</translation>
    </message>
    <message>
        <source>Go on to the scan</source>
        <translation>Alla scansione</translation>
    </message>
    <message>
        <source>Keep as…</source>
        <translation>Salva come…</translation>
    </message>
    <message>
        <source>Keep what is set now as a material of your own</source>
        <translation>Salva i valori attuali come materiale proprio</translation>
    </message>
    <message>
        <source>Laser off</source>
        <translation>Spegni laser</translation>
    </message>
    <message>
        <source>Laser on. It goes dark on Esc, when this page is left, or in {seconds} s if nothing is touched.</source>
        <translation>Laser acceso. Si spegne con Esc, lasciando la pagina, o dopo {seconds} s se non si tocca nulla.</translation>
    </message>
    <message>
        <source>Learn</source>
        <translation>Impara</translation>
    </message>
    <message>
        <source>Live: light the laser</source>
        <translation>Dal vivo: accendi laser</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Materiale</translation>
    </message>
    <message>
        <source>Name of the material</source>
        <translation>Nome del materiale</translation>
    </message>
    <message>
        <source>Progress of learning</source>
        <translation>Avanzamento dell&apos;apprendimento</translation>
    </message>
    <message>
        <source>Size of a spot, pixels</source>
        <translation>Dimensione di un punto, pixel</translation>
    </message>
    <message>
        <source>Steps of {n} degrees</source>
        <translation>Passi di {n} gradi</translation>
    </message>
    <message>
        <source>Table clockwise</source>
        <translation>Tavola in senso orario</translation>
    </message>
    <message>
        <source>Table counter-clockwise</source>
        <translation>Tavola in senso antiorario</translation>
    </message>
    <message>
        <source>The laser is off. Goggles on, nobody looks into the beam: then light it.</source>
        <translation>Il laser è spento. Occhiali indossati, nessuno guardi nel raggio: poi accenderlo.</translation>
    </message>
    <message>
        <source>The rig is not free; the Rig page says why.</source>
        <translation>Il banco non è libero; la pagina Banco dice perché.</translation>
    </message>
    <message>
        <source>The spot is lit while this page is shown, and goes dark on Esc or when nobody touches anything for a while</source>
        <translation>Il punto resta acceso finché si vede questa pagina; si spegne con Esc o se per un po&apos; nessuno tocca nulla</translation>
    </message>
    <message>
        <source>Two seconds of live pictures while the beam moves a little: sizes of spots that both cameras agree on</source>
        <translation>Due secondi di immagini dal vivo con piccoli moti del raggio: dimensioni dei punti su cui le due telecamere concordano</translation>
    </message>
</context>
<context>
    <name>AimPicture</name>
    <message>
        <source>Click: bring the spot there. Arrow keys: move the beam. Page Up and Page Down: turn the table. Wheel, + and −: zoom.</source>
        <translation>Clic: porta lì il punto. Frecce: muovono il raggio. Pag su e Pag giù: girano la tavola. Rotella, + e −: zoom.</translation>
    </message>
    <message>
        <source>{camera}: {count} bright places, no spot accepted</source>
        <translation>{camera}: {count} macchie chiare, nessun punto accettato</translation>
    </message>
    <message>
        <source>{camera}: {count} bright places, spot accepted</source>
        <translation>{camera}: {count} macchie chiare, punto accettato</translation>
    </message>
</context>
<context>
    <name>AlignmentPanel</name>
    <message>
        <source>Erase</source>
        <translation>Cancella</translation>
    </message>
    <message>
        <source>Held fixed</source>
        <translation>Tenuto fermo</translation>
    </message>
    <message>
        <source>Noise of a distance</source>
        <translation>Rumore di una distanza</translation>
    </message>
    <message>
        <source>Paint stable</source>
        <translation>Dipingi stabile</translation>
    </message>
    <message>
        <source>Pick three points on each…</source>
        <translation>Scegli tre punti su ognuna…</translation>
    </message>
    <message>
        <source>Residual there</source>
        <translation>Residuo lì</translation>
    </message>
    <message>
        <source>Show the stable region</source>
        <translation>Mostra la regione stabile</translation>
    </message>
    <message>
        <source>Size, after to before</source>
        <translation>Dimensione, dopo su prima</translation>
    </message>
    <message>
        <source>Stable share</source>
        <translation>Quota stabile</translation>
    </message>
    <message>
        <source>Start found by</source>
        <translation>Inizio trovato con</translation>
    </message>
    <message>
        <source>Uncertainty</source>
        <translation>Incertezza</translation>
    </message>
    <message>
        <source>With a counterpart</source>
        <translation>Con corrispondente</translation>
    </message>
    <message>
        <source>not estimated</source>
        <translation>non stimata</translation>
    </message>
    <message>
        <source>{frame} instead would shift everything by {rms} mm on average, {most} mm at most.</source>
        <translation>{frame} sposterebbe tutto di {rms} mm in media, al massimo di {most} mm.</translation>
    </message>
    <message>
        <source>{frame} instead would shift the front teeth by {n} mm.</source>
        <translation>{frame} sposterebbe i denti anteriori di {n} mm.</translation>
    </message>
    <message>
        <source>{frame} instead would shift the molars by {n} mm.</source>
        <translation>{frame} sposterebbe i molari di {n} mm.</translation>
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
        <translation>Aree di maggiore differenza</translation>
    </message>
</context>
<context>
    <name>AssistantPage</name>
    <message>
        <source>1  Find the devices</source>
        <translation>1  Trova i dispositivi</translation>
    </message>
    <message>
        <source>2  Check the rig</source>
        <translation>2  Verifica il banco</translation>
    </message>
    <message>
        <source>3  Write its file</source>
        <translation>3  Scrivi il file</translation>
    </message>
    <message>
        <source>Asking every port and every camera  ·  {left} left</source>
        <translation>Interrogazione di porte e telecamere  ·  ancora {left}</translation>
    </message>
    <message>
        <source>Back to the Rig page; the devices are released</source>
        <translation>Torna alla pagina Banco; i dispositivi sono liberati</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annulla</translation>
    </message>
    <message>
        <source>Every serial port and every camera is asked who it is. A board may restart; nothing moves, and no laser is lit.</source>
        <translation>A ogni porta seriale e a ogni telecamera si chiede chi è. Una scheda può riavviarsi; niente si muove e nessun laser si accende.</translation>
    </message>
    <message>
        <source>Go on without a check</source>
        <translation>Continua senza verifica</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>Esci</translation>
    </message>
    <message>
        <source>Look again</source>
        <translation>Cerca di nuovo</translation>
    </message>
    <message>
        <source>Look for devices</source>
        <translation>Cerca dispositivi</translation>
    </message>
    <message>
        <source>Next: check the rig</source>
        <translation>Avanti: verifica il banco</translation>
    </message>
    <message>
        <source>Next: write its file</source>
        <translation>Avanti: scrivi il file</translation>
    </message>
    <message>
        <source>Progress of the search</source>
        <translation>Avanzamento della ricerca</translation>
    </message>
    <message>
        <source>Set up a rig</source>
        <translation>Configura un banco</translation>
    </message>
    <message>
        <source>Still to be chosen: {what}.</source>
        <translation>Ancora da scegliere: {what}.</translation>
    </message>
    <message>
        <source>The rig of the program is measuring: its devices are free afterwards.</source>
        <translation>Il banco del programma sta misurando: dopo, i suoi dispositivi saranno liberi.</translation>
    </message>
    <message>
        <source>a controller</source>
        <translation>un controllore</translation>
    </message>
    <message>
        <source>the left camera</source>
        <translation>la telecamera sinistra</translation>
    </message>
    <message>
        <source>the right camera</source>
        <translation>la telecamera destra</translation>
    </message>
</context>
<context>
    <name>AssistantPictures</name>
    <message>
        <source>Camera left</source>
        <translation>Telecamera sinistra</translation>
    </message>
    <message>
        <source>Camera right</source>
        <translation>Telecamera destra</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>Dal vivo</translation>
    </message>
    <message>
        <source>What the cameras see</source>
        <translation>Che cosa vedono le telecamere</translation>
    </message>
    <message>
        <source>no spot</source>
        <translation>nessun punto</translation>
    </message>
</context>
<context>
    <name>Banner</name>
    <message>
        <source>Close this message</source>
        <translation>Chiudi questo messaggio</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copia</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Dettagli</translation>
    </message>
    <message>
        <source>Support bundle…</source>
        <translation>Pacchetto di assistenza…</translation>
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
        <translation>Trova di nuovo</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Altezza</translation>
    </message>
    <message>
        <source>Tilt along x</source>
        <translation>Inclinazione in x</translation>
    </message>
    <message>
        <source>Tilt along y</source>
        <translation>Inclinazione in y</translation>
    </message>
    <message>
        <source>What is below the plane goes.</source>
        <translation>Ciò che sta sotto il piano va via.</translation>
    </message>
</context>
<context>
    <name>BoardWatchView</name>
    <message>
        <source>Camera left</source>
        <translation>Telecamera sinistra</translation>
    </message>
    <message>
        <source>Camera right</source>
        <translation>Telecamera destra</translation>
    </message>
    <message>
        <source>Starting…</source>
        <translation>Avvio…</translation>
    </message>
</context>
<context>
    <name>BrushSize</name>
    <message>
        <source>Brush {mm} mm</source>
        <translation>Pennello {mm} mm</translation>
    </message>
    <message>
        <source>Size of the brush</source>
        <translation>Dimensione del pennello</translation>
    </message>
</context>
<context>
    <name>ByHandPanel</name>
    <message>
        <source>1.  Light the board well and evenly; the cameras set their exposure by themselves.</source>
        <translation>1.  Illuminare bene e in modo uniforme la scacchiera; le telecamere regolano da sé l&apos;esposizione.</translation>
    </message>
    <message>
        <source>2.  Hold it into the volume, each time tilted another way and at another place. Rest it until the view is taken.</source>
        <translation>2.  Tenerla nel volume, ogni volta inclinata diversamente e in un altro punto. Tenerla ferma finché la vista è presa.</translation>
    </message>
    <message>
        <source>3.  With a length bar: hold that likewise, both ends in sight.</source>
        <translation>3.  Con una barra campione: tenerla allo stesso modo, con i due capi in vista.</translation>
    </message>
    <message>
        <source>4.  Lay the board on the table and take your hands away: the table turns by itself.</source>
        <translation>4.  Posare la scacchiera sulla tavola e togliere le mani: la tavola gira da sé.</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Indietro</translation>
    </message>
    <message>
        <source>Calibrate by hand</source>
        <translation>Calibrazione manuale</translation>
    </message>
    <message>
        <source>Certified length bar</source>
        <translation>Barra campione certificata</translation>
    </message>
    <message>
        <source>Certified length of the bar</source>
        <translation>Lunghezza certificata della barra</translation>
    </message>
    <message>
        <source>From the table to the printed face: it places the origin on the table.</source>
        <translation>Dalla tavola alla faccia stampata: mette l&apos;origine sulla tavola.</translation>
    </message>
    <message>
        <source>Known length</source>
        <translation>Lunghezza nota</translation>
    </message>
    <message>
        <source>Neither: the scale stays unverified</source>
        <translation>Nessuna: la scala resta non verificata</translation>
    </message>
    <message>
        <source>Print measured with a caliper</source>
        <translation>Stampa misurata col calibro</translation>
    </message>
    <message>
        <source>Printed row of squares, outer edge to outer edge</source>
        <translation>Fila di quadretti stampata, da bordo esterno a bordo esterno</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Avvia</translation>
    </message>
    <message>
        <source>The print: its whole row of squares, from outer edge to outer edge.</source>
        <translation>La stampa: l&apos;intera fila di quadretti, da bordo esterno a bordo esterno.</translation>
    </message>
    <message>
        <source>Thickness of the board</source>
        <translation>Spessore della scacchiera</translation>
    </message>
    <message>
        <source>You show the printed board to both cameras; it takes about ten minutes. The laser stays off.</source>
        <translation>La scacchiera stampata si mostra a entrambe le telecamere; servono circa dieci minuti. Il laser resta spento.</translation>
    </message>
</context>
<context>
    <name>CalibratingPanel</name>
    <message>
        <source>% done</source>
        <translation>% fatto</translation>
    </message>
    <message>
        <source>Calibrating</source>
        <translation>Calibrazione</translation>
    </message>
    <message>
        <source>Camera left</source>
        <translation>Telecamera sinistra</translation>
    </message>
    <message>
        <source>Camera right</source>
        <translation>Telecamera destra</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annulla</translation>
    </message>
    <message>
        <source>Cancelling…</source>
        <translation>Annullamento…</translation>
    </message>
    <message>
        <source>Covered by the board</source>
        <translation>Coperto dalla scacchiera</translation>
    </message>
    <message>
        <source>Distances of the board</source>
        <translation>Distanze della scacchiera</translation>
    </message>
    <message>
        <source>Largest tilt between two boards</source>
        <translation>Massima inclinazione fra due posizioni</translation>
    </message>
    <message>
        <source>Nothing: all views are taken.</source>
        <translation>Niente: tutte le viste sono prese.</translation>
    </message>
    <message>
        <source>Still missing</source>
        <translation>Manca ancora</translation>
    </message>
    <message>
        <source>Then the calibration of {date} stays in use.</source>
        <translation>Altrimenti resta in uso la calibrazione del {date}.</translation>
    </message>
    <message>
        <source>Transcript…</source>
        <translation>Trascrizione…</translation>
    </message>
    <message>
        <source>Without a calibration the rig cannot scan.</source>
        <translation>Senza calibrazione il banco non può scansionare.</translation>
    </message>
    <message>
        <source>and {n} more</source>
        <translation>e altre {n}</translation>
    </message>
    <message>
        <source>{left}  ·  the virtual rig shows the board by itself</source>
        <translation>{left}  ·  il banco virtuale mostra da sé la scacchiera</translation>
    </message>
    <message>
        <source>{left} left</source>
        <translation>ancora {left}</translation>
    </message>
    <message>
        <source>{near} to {far} mm</source>
        <translation>da {near} a {far} mm</translation>
    </message>
    <message>
        <source>{n} of {count} fields</source>
        <translation>{n} campi di {count}</translation>
    </message>
</context>
<context>
    <name>CalibrationPanel</name>
    <message>
        <source>Accepted  ·  {age}</source>
        <translation>Accettata  ·  {age}</translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation>Calibra</translation>
    </message>
    <message>
        <source>Calibrated on {date}, {age}.</source>
        <translation>Calibrato il {date} ({age}).</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Calibrazione</translation>
    </message>
    <message>
        <source>Its calibration stands in the rig file.</source>
        <translation>La sua calibrazione è nel file del banco.</translation>
    </message>
    <message>
        <source>New calibration not accepted</source>
        <translation>Nuova calibrazione non accettata</translation>
    </message>
    <message>
        <source>Not calibrated</source>
        <translation>Non calibrato</translation>
    </message>
    <message>
        <source>Not calibrated yet: show the board to both cameras before the first scan.</source>
        <translation>Non ancora calibrato: mostrare la scacchiera alle due telecamere prima della prima scansione.</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Print the target…</source>
        <translation>Stampa la scacchiera…</translation>
    </message>
    <message>
        <source>Since the previous calibration</source>
        <translation>Dalla calibrazione precedente</translation>
    </message>
    <message>
        <source>The calibration of {date} stays in use.</source>
        <translation>Resta in uso la calibrazione del {date}.</translation>
    </message>
    <message>
        <source>The calibration target as a page to print</source>
        <translation>La scacchiera di calibrazione come pagina da stampare</translation>
    </message>
    <message>
        <source>Without a calibration the rig cannot scan.</source>
        <translation>Senza calibrazione il banco non può scansionare.</translation>
    </message>
    <message>
        <source>Written to {path}. Print it at 100 % and check that its ruler measures {ruler} mm.</source>
        <translation>Scritto in {path}. Stampare al 100 % e controllare che il righello misuri {ruler} mm.</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>non noto</translation>
    </message>
    <message>
        <source>µm rms at board corners that were not used</source>
        <translation>µm rms agli angoli della scacchiera non usati</translation>
    </message>
</context>
<context>
    <name>CameraCard</name>
    <message>
        <source>Left</source>
        <translation>Sinistra</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Destra</translation>
    </message>
    <message>
        <source>{camera} is the {side} camera</source>
        <translation>{camera} è la telecamera {side}</translation>
    </message>
</context>
<context>
    <name>CameraPreview</name>
    <message>
        <source>Wheel: zoom. Drag: move. Double click: whole picture.</source>
        <translation>Rotella: zoom. Trascina: sposta. Doppio clic: immagine intera.</translation>
    </message>
    <message>
        <source>no picture yet</source>
        <translation>ancora nessuna immagine</translation>
    </message>
    <message>
        <source>recorded: shown while it is measured</source>
        <translation>registrata: mostrata mentre si misura</translation>
    </message>
    <message>
        <source>σ {x} × {y} px · peak {peak} %</source>
        <translation>σ {x} × {y} px · picco {peak} %</translation>
    </message>
</context>
<context>
    <name>CameraSettings</name>
    <message>
        <source> frames/s</source>
        <translation> immagini/s</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> ms</translation>
    </message>
    <message>
        <source>Exposure</source>
        <translation>Esposizione</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Frequenza</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Dimensioni</translation>
    </message>
    <message>
        <source>Trigger</source>
        <translation>Trigger</translation>
    </message>
    <message>
        <source>as the camera has it</source>
        <translation>come dà la telecamera</translation>
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
        <translation>Immagini</translation>
    </message>
    <message>
        <source>Pictures of: {check}</source>
        <translation>Immagini di: {check}</translation>
    </message>
</context>
<context>
    <name>CheckList</name>
    <message>
        <source>Checks</source>
        <translation>Verifiche</translation>
    </message>
</context>
<context>
    <name>CheckStep</name>
    <message>
        <source>All {n} checks are good.</source>
        <translation>Tutte le {n} verifiche sono buone.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annulla</translation>
    </message>
    <message>
        <source>Cancelling…</source>
        <translation>Annullamento…</translation>
    </message>
    <message>
        <source>Check again</source>
        <translation>Verifica di nuovo</translation>
    </message>
    <message>
        <source>Everybody near the rig is protected, and nothing is in the way of beam and table</source>
        <translation>Tutti vicino al banco sono protetti, e niente ostacola raggio e tavola</translation>
    </message>
    <message>
        <source>Not everything is as it should be: {checks}.</source>
        <translation>Non tutto è come dovrebbe: {checks}.</translation>
    </message>
    <message>
        <source>Only look and move by hand</source>
        <translation>Solo guardare e muovere a mano</translation>
    </message>
    <message>
        <source>Opening the devices</source>
        <translation>Apertura dei dispositivi</translation>
    </message>
    <message>
        <source>Progress of the check</source>
        <translation>Avanzamento della verifica</translation>
    </message>
    <message>
        <source>Start the check</source>
        <translation>Avvia la verifica</translation>
    </message>
    <message>
        <source>The check moves beam and table and lights the laser. A laser of class 3R can injure the eye: do not look into the beam or its reflections, wear goggles for its wavelength, take rings and watches off, and keep hands and hair out of the rig. Esc and the red button at the lower left stop everything at once.</source>
        <translation>La verifica muove raggio e tavola e accende il laser. Un laser di classe 3R può ferire l&apos;occhio: non guardare nel raggio né nei suoi riflessi, portare occhiali per la sua lunghezza d&apos;onda, togliere anelli e orologi, tenere mani e capelli fuori dal banco. Esc e il pulsante rosso in basso a sinistra fermano subito tutto.</translation>
    </message>
    <message>
        <source>{doing}  ·  {left} left</source>
        <translation>{doing}  ·  ancora {left}</translation>
    </message>
</context>
<context>
    <name>ChosenView</name>
    <message>
        <source>Measure this view once more: after the last one while the scan runs, else at once</source>
        <translation>Rimisura questa vista: durante la scansione dopo l&apos;ultima, altrimenti subito</translation>
    </message>
    <message>
        <source>Redo this view</source>
        <translation>Rifai questa vista</translation>
    </message>
</context>
<context>
    <name>CompareFoot</name>
    <message>
        <source>Align on the painted region</source>
        <translation>Allinea sulla regione dipinta</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annulla</translation>
    </message>
    <message>
        <source>Cancelling…</source>
        <translation>Annullamento…</translation>
    </message>
    <message>
        <source>Click three points on each surface, in the same order and far from each other. Before: {b} of 3, after: {a} of 3.</source>
        <translation>Fare clic su tre punti per superficie, nello stesso ordine e lontani fra loro. Prima: {b} di 3, dopo: {a} di 3.</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Confronta</translation>
    </message>
    <message>
        <source>Keep it in the open case</source>
        <translation>Conserva nel caso aperto</translation>
    </message>
    <message>
        <source>Paint what did not move, then align on it.</source>
        <translation>Dipingere ciò che non si è mosso, poi allineare su quello.</translation>
    </message>
    <message>
        <source>Pick three points on each…</source>
        <translation>Scegli tre punti su ognuna…</translation>
    </message>
    <message>
        <source>Save the report…</source>
        <translation>Salva il rapporto…</translation>
    </message>
    <message>
        <source>Show in its folder</source>
        <translation>Mostra nella cartella</translation>
    </message>
    <message>
        <source>Starting…</source>
        <translation>Avvio…</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Riprova</translation>
    </message>
    <message>
        <source>Two surfaces are needed: one before, one after.</source>
        <translation>Servono due superfici: una prima e una dopo.</translation>
    </message>
    <message>
        <source>Writing the report: {left} left</source>
        <translation>Scrittura del rapporto: ancora {left}</translation>
    </message>
    <message>
        <source>Writing the report…</source>
        <translation>Scrittura del rapporto…</translation>
    </message>
    <message>
        <source>Written: {folder}</source>
        <translation>Scritto: {folder}</translation>
    </message>
    <message>
        <source>{phase}: {left} left</source>
        <translation>{phase}: ancora {left}</translation>
    </message>
</context>
<context>
    <name>ComparePage</name>
    <message>
        <source>A surface is an STL, PLY, OBJ, VTP or 3MF file, or a case.</source>
        <translation>Una superficie è un file STL, PLY, OBJ, VTP o 3MF, o un caso.</translation>
    </message>
    <message>
        <source>After</source>
        <translation>Dopo</translation>
    </message>
    <message>
        <source>Alignment</source>
        <translation>Allineamento</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Prima</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Confronto</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Risultati</translation>
    </message>
    <message>
        <source>Folder for the report</source>
        <translation>Cartella per il rapporto</translation>
    </message>
    <message>
        <source>Preparing the 3D view…</source>
        <translation>Preparazione della vista 3D…</translation>
    </message>
    <message>
        <source>Surfaces</source>
        <translation>Superfici</translation>
    </message>
    <message>
        <source>Surfaces ({kinds})</source>
        <translation>Superfici ({kinds})</translation>
    </message>
    <message>
        <source>The state that everything is compared with</source>
        <translation>Lo stato con cui si confronta tutto</translation>
    </message>
    <message>
        <source>The state whose changes are shown</source>
        <translation>Lo stato di cui si mostrano i cambiamenti</translation>
    </message>
    <message>
        <source>The surface after</source>
        <translation>La superficie dopo</translation>
    </message>
    <message>
        <source>The surface before</source>
        <translation>La superficie prima</translation>
    </message>
    <message>
        <source>There is no 3D view; the numbers stand beside it.</source>
        <translation>Non c&apos;è vista 3D; i numeri stanno accanto.</translation>
    </message>
    <message>
        <source>Two surfaces are compared: the first two files were taken.</source>
        <translation>Si confrontano due superfici: presi i primi due file.</translation>
    </message>
    <message>
        <source>{names}: not read.</source>
        <translation>{names}: non letti.</translation>
    </message>
</context>
<context>
    <name>CompareStage</name>
    <message>
        <source>Blend</source>
        <translation>Dissolvenza</translation>
    </message>
    <message>
        <source>Comparison</source>
        <translation>Confronto</translation>
    </message>
    <message>
        <source>Curtain</source>
        <translation>Tendina</translation>
    </message>
    <message>
        <source>Cut both: through the chosen area from cheek to tongue, or through the middle</source>
        <translation>Taglia entrambe: attraverso l&apos;area scelta da guancia a lingua, o nel mezzo</translation>
    </message>
    <message>
        <source>Fit (F)</source>
        <translation>Adatta (F)</translation>
    </message>
    <message>
        <source>Flicker</source>
        <translation>Alternanza</translation>
    </message>
    <message>
        <source>From before to after</source>
        <translation>Da prima a dopo</translation>
    </message>
    <message>
        <source>Frontal (1)</source>
        <translation>Frontale (1)</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Sinistra</translation>
    </message>
    <message>
        <source>Lingual</source>
        <translation>Linguale</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Mappa</translation>
    </message>
    <message>
        <source>Morph</source>
        <translation>Morphing</translation>
    </message>
    <message>
        <source>Occlusal (7)</source>
        <translation>Occlusale (7)</translation>
    </message>
    <message>
        <source>One surface in place of the other (space bar)</source>
        <translation>Una superficie al posto dell&apos;altra (barra spaziatrice)</translation>
    </message>
    <message>
        <source>Place of the section</source>
        <translation>Posizione della sezione</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Destra</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Sezione</translation>
    </message>
    <message>
        <source>Side by side</source>
        <translation>Affiancate</translation>
    </message>
    <message>
        <source>Underside</source>
        <translation>Da sotto</translation>
    </message>
</context>
<context>
    <name>ComparisonCaptions</name>
    <message>
        <source>After</source>
        <translation>Dopo</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Prima</translation>
    </message>
    <message>
        <source>L</source>
        <translation>S</translation>
    </message>
    <message>
        <source>R</source>
        <translation>D</translation>
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
        <translation>senza corrispondente</translation>
    </message>
    <message>
        <source>within ±{mm} mm</source>
        <translation>entro ±{mm} mm</translation>
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
        <translation>Correggi e verifica di nuovo</translation>
    </message>
    <message>
        <source>To be corrected</source>
        <translation>Da correggere</translation>
    </message>
</context>
<context>
    <name>CoverageMap</name>
    <message>
        <source>{n} of {count} fields covered</source>
        <translation>{n} campi su {count} coperti</translation>
    </message>
</context>
<context>
    <name>CoveragePage</name>
    <message>
        <source>% of all</source>
        <translation>% del totale</translation>
    </message>
    <message>
        <source>% of what can be seen</source>
        <translation>% di ciò che si vede</translation>
    </message>
    <message>
        <source>Accept</source>
        <translation>Accetta</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annulla</translation>
    </message>
    <message>
        <source>Complete</source>
        <translation>Completa</translation>
    </message>
    <message>
        <source>Computing</source>
        <translation>Calcolo</translation>
    </message>
    <message>
        <source>Cut away what does not belong to the object before it becomes a surface</source>
        <translation>Toglie ciò che non è dell&apos;oggetto prima che diventi superficie</translation>
    </message>
    <message>
        <source>Do not accept</source>
        <translation>Non accettare</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Modifica</translation>
    </message>
    <message>
        <source>Every place is as certain as wanted.</source>
        <translation>Ogni zona è certa quanto richiesto.</translation>
    </message>
    <message>
        <source>Fill now</source>
        <translation>Completa ora</translation>
    </message>
    <message>
        <source>Find out</source>
        <translation>Scopri</translation>
    </message>
    <message>
        <source>Leave the chosen place as it is: the case keeps that, the certificate tells it (A; again to take it back)</source>
        <translation>Lascia la zona scelta com&apos;è: il caso lo conserva, il certificato lo dice (A; di nuovo per revocare)</translation>
    </message>
    <message>
        <source>Leave the object as it stands: the scan goes on where points are missing, until it is as wanted (Shift+F5)</source>
        <translation>Lasciare l&apos;oggetto com&apos;è: la scansione continua dove mancano punti, fino a quanto richiesto (Maiusc+F5)</translation>
    </message>
    <message>
        <source>Making a surface of the points…</source>
        <translation>Superficie dai punti…</translation>
    </message>
    <message>
        <source>Needs another mount</source>
        <translation>Serve un altro posizionamento</translation>
    </message>
    <message>
        <source>Of a surface that was made of the points for this; the case has none yet.</source>
        <translation>Di una superficie ricavata apposta dai punti; il caso non ne ha ancora una.</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Motivo</translation>
    </message>
    <message>
        <source>Reconstruct</source>
        <translation>Ricostruisci</translation>
    </message>
    <message>
        <source>Scan an object or open a case first.</source>
        <translation>Prima scansionare un oggetto o aprire un caso.</translation>
    </message>
    <message>
        <source>Scan another mount</source>
        <translation>Altro posizionamento</translation>
    </message>
    <message>
        <source>Standard uncertainty that is enough</source>
        <translation>Incertezza tipo sufficiente</translation>
    </message>
    <message>
        <source>Uncertainty</source>
        <translation>Incertezza</translation>
    </message>
    <message>
        <source>Within</source>
        <translation>Entro</translation>
    </message>
    <message>
        <source>{n} open, {mm2:.0f} mm² together</source>
        <translation>{n} aperte, {mm2:.0f} mm² in tutto</translation>
    </message>
    <message>
        <source>{open}; {n} accepted</source>
        <translation>{open}; {n} accettate</translation>
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
        <translation>Ciò che sta nel riquadro resta.</translation>
    </message>
    <message>
        <source>x from</source>
        <translation>x da</translation>
    </message>
    <message>
        <source>x to</source>
        <translation>x a</translation>
    </message>
    <message>
        <source>y from</source>
        <translation>y da</translation>
    </message>
    <message>
        <source>y to</source>
        <translation>y a</translation>
    </message>
    <message>
        <source>z from</source>
        <translation>z da</translation>
    </message>
    <message>
        <source>z to</source>
        <translation>z a</translation>
    </message>
</context>
<context>
    <name>DeliverPage</name>
    <message>
        <source>All {passed} checks passed.</source>
        <translation>Tutte le {passed} verifiche superate.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annulla</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Verifica</translation>
    </message>
    <message>
        <source>Checking…</source>
        <translation>Verifica…</translation>
    </message>
    <message>
        <source>Closed, and free of self-intersections</source>
        <translation>Chiusa e senza autointersezioni</translation>
    </message>
    <message>
        <source>Deliver</source>
        <translation>Consegna</translation>
    </message>
    <message>
        <source>Deliver anyway</source>
        <translation>Consegna comunque</translation>
    </message>
    <message>
        <source>Deliver it although it is not ready</source>
        <translation>Consegna anche se non è pronta</translation>
    </message>
    <message>
        <source>Deliver once more</source>
        <translation>Consegna di nuovo</translation>
    </message>
    <message>
        <source>Delivered</source>
        <translation>Consegnato</translation>
    </message>
    <message>
        <source>Edit the profile</source>
        <translation>Modifica il profilo</translation>
    </message>
    <message>
        <source>Edit…</source>
        <translation>Modifica…</translation>
    </message>
    <message>
        <source>Failed: {failed}. Remarks: {remarks}. Passed: {passed}.</source>
        <translation>Non superate: {failed}. Osservazioni: {remarks}. Superate: {passed}.</translation>
    </message>
    <message>
        <source>How it was measured</source>
        <translation>Come è stata misurata</translation>
    </message>
    <message>
        <source>In {folder}</source>
        <translation>In {folder}</translation>
    </message>
    <message>
        <source>Next order</source>
        <translation>Prossimo ordine</translation>
    </message>
    <message>
        <source>No surface yet</source>
        <translation>Ancora niente superficie</translation>
    </message>
    <message>
        <source>Not checked</source>
        <translation>Non verificata</translation>
    </message>
    <message>
        <source>Open an order or begin one, then scan and reconstruct it.</source>
        <translation>Aprire o iniziare un ordine, poi scansionarlo e ricostruirlo.</translation>
    </message>
    <message>
        <source>Open folder</source>
        <translation>Apri cartella</translation>
    </message>
    <message>
        <source>Orders</source>
        <translation>Ordini</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Profilo</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Avanzamento</translation>
    </message>
    <message>
        <source>Reconstruct</source>
        <translation>Ricostruisci</translation>
    </message>
    <message>
        <source>Reconstruct first</source>
        <translation>Prima ricostruisci</translation>
    </message>
    <message>
        <source>Remarks: {remarks}. Passed: {passed}.</source>
        <translation>Osservazioni: {remarks}. Superate: {passed}.</translation>
    </message>
    <message>
        <source>Replace the existing files</source>
        <translation>Sostituisci i file esistenti</translation>
    </message>
    <message>
        <source>The certificate says so, in words and in its JSON.</source>
        <translation>Il certificato lo riporta, a parole e nel suo JSON.</translation>
    </message>
    <message>
        <source>The check was cancelled.</source>
        <translation>La verifica è stata annullata.</translation>
    </message>
    <message>
        <source>There is no surface to deliver yet.</source>
        <translation>Non c&apos;è ancora una superficie da consegnare.</translation>
    </message>
    <message>
        <source>These files exist already. With {rev} in the name every delivery gets its own number.</source>
        <translation>Questi file esistono già. Con {rev} nel nome ogni consegna riceve un suo numero.</translation>
    </message>
    <message>
        <source>Whether it mirrors the other ear</source>
        <translation>Se è speculare all&apos;altro orecchio</translation>
    </message>
    <message>
        <source>Written to {folder}</source>
        <translation>Scritto in {folder}</translation>
    </message>
    <message>
        <source>{counted}
Delivered before, on {day}: {name}</source>
        <translation>{counted}
Già consegnato il {day}: {name}</translation>
    </message>
    <message>
        <source>{place}, with {others}</source>
        <translation>{place}, con {others}</translation>
    </message>
    <message>
        <source>{written}, with {others}</source>
        <translation>{written}, con {others}</translation>
    </message>
</context>
<context>
    <name>DeviationLegend</name>
    <message>
        <source>after against before, mm</source>
        <translation>dopo rispetto a prima, mm</translation>
    </message>
    <message>
        <source>no counterpart</source>
        <translation>senza corrispondente</translation>
    </message>
    <message>
        <source>outward +</source>
        <translation>verso fuori +</translation>
    </message>
    <message>
        <source>within ±{mm} mm: not detectable</source>
        <translation>entro ±{mm} mm: non rilevabile</translation>
    </message>
    <message>
        <source>±{mm} mm</source>
        <translation>±{mm} mm</translation>
    </message>
    <message>
        <source>− inward</source>
        <translation>− verso dentro</translation>
    </message>
</context>
<context>
    <name>DeviceList</name>
    <message>
        <source>Camera left</source>
        <translation>Telecamera sinistra</translation>
    </message>
    <message>
        <source>Camera right</source>
        <translation>Telecamera destra</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>Controllore</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>Dispositivi</translation>
    </message>
    <message>
        <source>Ends the alarm; nothing moves, and the position may be lost</source>
        <translation>Termina l&apos;allarme; niente si muove, e la posizione può andare persa</translation>
    </message>
    <message>
        <source>Find reference</source>
        <translation>Cerca riferimento</translation>
    </message>
    <message>
        <source>It is opened again by itself when it is back.</source>
        <translation>Si riapre da sé quando torna.</translation>
    </message>
    <message>
        <source>Laser</source>
        <translation>Laser</translation>
    </message>
    <message>
        <source>Take it off the list</source>
        <translation>Togli dalla lista</translation>
    </message>
    <message>
        <source>The axes move until they find their switches; nobody may reach into the rig</source>
        <translation>Gli assi si muovono fino ai finecorsa; nessuno deve mettere le mani nel banco</translation>
    </message>
    <message>
        <source>The last 200 lines to and from the controller</source>
        <translation>Le ultime 200 righe da e verso il controllore</translation>
    </message>
    <message>
        <source>Transcript…</source>
        <translation>Trascrizione…</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Riprova</translation>
    </message>
    <message>
        <source>Turntable</source>
        <translation>Tavola rotante</translation>
    </message>
    <message>
        <source>Unlock</source>
        <translation>Sblocca</translation>
    </message>
    <message>
        <source>alarm</source>
        <translation>allarme</translation>
    </message>
    <message>
        <source>as the controller reports it</source>
        <translation>secondo il controllore</translation>
    </message>
    <message>
        <source>axes {letters}</source>
        <translation>assi {letters}</translation>
    </message>
    <message>
        <source>door open</source>
        <translation>sportello aperto</translation>
    </message>
    <message>
        <source>emitting</source>
        <translation>emette</translation>
    </message>
    <message>
        <source>finding its reference…</source>
        <translation>ricerca del riferimento…</translation>
    </message>
    <message>
        <source>free running</source>
        <translation>libera</translation>
    </message>
    <message>
        <source>hardware trigger</source>
        <translation>trigger hardware</translation>
    </message>
    <message>
        <source>held</source>
        <translation>in pausa</translation>
    </message>
    <message>
        <source>homing</source>
        <translation>azzeramento</translation>
    </message>
    <message>
        <source>idle</source>
        <translation>a riposo</translation>
    </message>
    <message>
        <source>laser mode off</source>
        <translation>modo laser spento</translation>
    </message>
    <message>
        <source>laser mode on</source>
        <translation>modo laser attivo</translation>
    </message>
    <message>
        <source>moving</source>
        <translation>in moto</translation>
    </message>
    <message>
        <source>not available</source>
        <translation>non disponibile</translation>
    </message>
    <message>
        <source>not open</source>
        <translation>non aperto</translation>
    </message>
    <message>
        <source>off</source>
        <translation>spento</translation>
    </message>
    <message>
        <source>opening…</source>
        <translation>apertura…</translation>
    </message>
    <message>
        <source>position unknown: find the reference</source>
        <translation>posizione ignota: cercare il riferimento</translation>
    </message>
    <message>
        <source>ready</source>
        <translation>pronto</translation>
    </message>
    <message>
        <source>ready, not as asked</source>
        <translation>pronto, non come richiesto</translation>
    </message>
    <message>
        <source>software trigger</source>
        <translation>trigger software</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>fermo</translation>
    </message>
    <message>
        <source>take it for lit: the controller reports nothing</source>
        <translation>considerarlo acceso: il controllore non segnala nulla</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>ignoto</translation>
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
        <translation>Distanza dei punti dalla superficie</translation>
    </message>
    <message>
        <source>Half of the points are nearer to the surface than the first mark, 95 of 100 nearer than the second.</source>
        <translation>La metà dei punti è più vicina alla superficie del primo segno, 95 su 100 del secondo.</translation>
    </message>
    <message>
        <source>Half of the points are within {median} of the surface, 95 of 100 within {p95}.</source>
        <translation>La metà dei punti sta entro {median} dalla superficie, 95 su 100 entro {p95}.</translation>
    </message>
    <message>
        <source>half {length}</source>
        <translation>metà {length}</translation>
    </message>
</context>
<context>
    <name>DropTarget</name>
    <message>
        <source>Choose a file…</source>
        <translation>Scegli un file…</translation>
    </message>
    <message>
        <source>Drop a file here</source>
        <translation>Trascinare qui un file</translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation>Lettura…</translation>
    </message>
    <message>
        <source>Recent cases</source>
        <translation>Casi recenti</translation>
    </message>
    <message>
        <source>STL, PLY, OBJ, VTP, 3MF, or a case</source>
        <translation>STL, PLY, OBJ, VTP, 3MF o un caso</translation>
    </message>
    <message>
        <source>The open case</source>
        <translation>Il caso aperto</translation>
    </message>
    <message>
        <source>{n} triangles</source>
        <translation>{n} triangoli</translation>
    </message>
</context>
<context>
    <name>EditPage</name>
    <message>
        <source>Edit</source>
        <translation>Modifica</translation>
    </message>
    <message>
        <source>Go on to the surface</source>
        <translation>Alla superficie</translation>
    </message>
    <message>
        <source>Leave them in</source>
        <translation>Non togliere</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Misura</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punti</translation>
    </message>
    <message>
        <source>Reading the points…</source>
        <translation>Lettura dei punti…</translation>
    </message>
    <message>
        <source>Reconstruct</source>
        <translation>Ricostruisci</translation>
    </message>
    <message>
        <source>Scan an object or open a case first.</source>
        <translation>Prima scansionare un oggetto o aprire un caso.</translation>
    </message>
    <message>
        <source>Take out {n} points</source>
        <translation>Togli {n} punti</translation>
    </message>
    <message>
        <source>The surface was made when other points were taken out. Reconstruct it again.</source>
        <translation>La superficie è stata fatta con altri punti tolti. Ricostruirla.</translation>
    </message>
    <message>
        <source>{n} points</source>
        <translation>{n} punti</translation>
    </message>
</context>
<context>
    <name>FaultPanel</name>
    <message>
        <source> s from now</source>
        <translation> s da ora</translation>
    </message>
    <message>
        <source>Fault</source>
        <translation>Guasto</translation>
    </message>
    <message>
        <source>Let it happen</source>
        <translation>Fallo accadere</translation>
    </message>
    <message>
        <source>Let something go wrong…</source>
        <translation>Provoca un guasto…</translation>
    </message>
    <message>
        <source>Opens the virtual rig anew</source>
        <translation>Riapre il banco virtuale</translation>
    </message>
    <message>
        <source>Put everything right</source>
        <translation>Rimetti tutto a posto</translation>
    </message>
    <message>
        <source>So far: {faults}</source>
        <translation>Finora: {faults}</translation>
    </message>
    <message>
        <source>now</source>
        <translation>ora</translation>
    </message>
    <message>
        <source>{fault} in {n} s</source>
        <translation>{fault} fra {n} s</translation>
    </message>
    <message>
        <source>{happens}. The program {expected}.</source>
        <translation>{happens}. Il programma: {expected}.</translation>
    </message>
    <message>
        <source>{n} before</source>
        <translation>{n} prima</translation>
    </message>
</context>
<context>
    <name>FileDialog</name>
    <message>
        <source>Replace it</source>
        <translation>Sostituisci</translation>
    </message>
    <message>
        <source>There is no such file:</source>
        <translation>Non esiste il file:</translation>
    </message>
    <message>
        <source>This file exists:</source>
        <translation>Il file esiste già:</translation>
    </message>
</context>
<context>
    <name>FileNameLine</name>
    <message>
        <source>Both files would have one name: put {side} into the template.</source>
        <translation>I due file avrebbero lo stesso nome: inserire {side} nel modello.</translation>
    </message>
    <message>
        <source>Change the file names…</source>
        <translation>Cambia i nomi dei file…</translation>
    </message>
    <message>
        <source>In braces: {fields}</source>
        <translation>Fra graffe: {fields}</translation>
    </message>
    <message>
        <source>Template of the file names</source>
        <translation>Modello dei nomi dei file</translation>
    </message>
    <message>
        <source>The patient code may stand in file names</source>
        <translation>Codice paziente ammesso nei nomi dei file</translation>
    </message>
    <message>
        <source>There is no field {unknown}; the fields are {fields}.</source>
        <translation>Il campo {unknown} non esiste; i campi sono {fields}.</translation>
    </message>
    <message>
        <source>{field} is left out: no patient in file names unless that is switched on below.</source>
        <translation>{field} viene omesso: niente paziente nei nomi dei file, se non lo si attiva qui sotto.</translation>
    </message>
</context>
<context>
    <name>FindStep</name>
    <message>
        <source>Cameras</source>
        <translation>Telecamere</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>Controllore</translation>
    </message>
    <message>
        <source>Exchange left and right</source>
        <translation>Scambia sinistra e destra</translation>
    </message>
    <message>
        <source>How both cameras are wanted</source>
        <translation>Come servono le due telecamere</translation>
    </message>
    <message>
        <source>Left and right as seen from behind the cameras. Wave a hand before one: its picture moves.</source>
        <translation>Sinistra e destra viste da dietro le telecamere. Agitare una mano davanti a una: la sua immagine si muove.</translation>
    </message>
    <message>
        <source>Looking…</source>
        <translation>Ricerca…</translation>
    </message>
    <message>
        <source>No camera was found on this machine. Plug both cameras in, each into a USB port of its own, and look again.</source>
        <translation>Nessuna telecamera trovata su questo computer. Collegare entrambe, ognuna a una sua porta USB, e cercare di nuovo.</translation>
    </message>
    <message>
        <source>No serial port was found on this machine. Plug the controller in by USB, switch it on, and look again.</source>
        <translation>Nessuna porta seriale trovata su questo computer. Collegare il controllore via USB, accenderlo e cercare di nuovo.</translation>
    </message>
    <message>
        <source>None of these ports can move the rig: see what each of them says.</source>
        <translation>Nessuna di queste porte può muovere il banco: leggere che cosa dice ciascuna.</translation>
    </message>
    <message>
        <source>Plug both cameras in, each into a USB port of its own and not into a common hub.</source>
        <translation>Collegare entrambe le telecamere, ognuna a una sua porta USB e non a un hub comune.</translation>
    </message>
    <message>
        <source>Plug the controller of laser and turntable in by USB, and switch it on.</source>
        <translation>Collegare via USB il controllore di laser e tavola rotante, e accenderlo.</translation>
    </message>
    <message>
        <source>Take the lens caps off, and close other programs that use the cameras or the port.</source>
        <translation>Togliere i tappi degli obiettivi e chiudere altri programmi che usano le telecamere o la porta.</translation>
    </message>
    <message>
        <source>The rig needs two cameras that give pictures: see what each of them says.</source>
        <translation>Il banco richiede due telecamere che diano immagini: leggere che cosa dice ciascuna.</translation>
    </message>
    <message>
        <source>Then look for devices, below. Without any, everything here can be tried on the virtual rig, which is always found.</source>
        <translation>Poi cercare i dispositivi, qui sotto. Anche senza, tutto si può provare sul banco virtuale, che si trova sempre.</translation>
    </message>
    <message>
        <source>Try it on the virtual rig</source>
        <translation>Prova sul banco virtuale</translation>
    </message>
    <message>
        <source>What is plugged in?</source>
        <translation>Che cosa è collegato?</translation>
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
        <translation>95 % sotto</translation>
    </message>
    <message>
        <source>99 % below</source>
        <translation>99 % sotto</translation>
    </message>
    <message>
        <source>Above {n} mm</source>
        <translation>Oltre {n} mm</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Aggiungi</translation>
    </message>
    <message>
        <source>Areas</source>
        <translation>Aree</translation>
    </message>
    <message>
        <source>Click it: the mark grows to its edge, and its motion is told</source>
        <translation>Clic sul dente: il segno cresce fino al bordo e ne è detto il moto</translation>
    </message>
    <message>
        <source>Detection level here</source>
        <translation>Soglia di rilevabilità qui</translation>
    </message>
    <message>
        <source>Detection level of the rig</source>
        <translation>Soglia di rilevabilità del banco</translation>
    </message>
    <message>
        <source>From which change on it matters: the line on the map</source>
        <translation>Da quale cambiamento conta: la linea sulla mappa</translation>
    </message>
    <message>
        <source>Greatest</source>
        <translation>Massimo</translation>
    </message>
    <message>
        <source>Half below</source>
        <translation>Metà sotto</translation>
    </message>
    <message>
        <source>Hausdorff of counterparts, after to before</source>
        <translation>Hausdorff dei corrispondenti, da dopo a prima</translation>
    </message>
    <message>
        <source>Hausdorff of counterparts, before to after</source>
        <translation>Hausdorff dei corrispondenti, da prima a dopo</translation>
    </message>
    <message>
        <source>Mark a tooth</source>
        <translation>Segna un dente</translation>
    </message>
    <message>
        <source>Mean, signed</source>
        <translation>Media, con segno</translation>
    </message>
    <message>
        <source>No area of {area} mm² or more differs by more than {n} mm (smoothed). The map shows smaller differences.</source>
        <translation>Nessuna area di {area} mm² o più differisce oltre {n} mm (lisciata). La mappa mostra differenze minori.</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>Numeri</translation>
    </message>
    <message>
        <source>Remove the mark</source>
        <translation>Rimuovi il segno</translation>
    </message>
    <message>
        <source>Take off</source>
        <translation>Togli</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>Soglia</translation>
    </message>
    <message>
        <source>Which jaw?</source>
        <translation>Quale arcata?</translation>
    </message>
    <message>
        <source>Without counterpart</source>
        <translation>Senza corrispondente</translation>
    </message>
    <message>
        <source>areas</source>
        <translation>aree</translation>
    </message>
    <message>
        <source>mm detectable</source>
        <translation>mm rilevabili</translation>
    </message>
    <message>
        <source>mm² above threshold</source>
        <translation>mm² oltre soglia</translation>
    </message>
    <message>
        <source>mm² above {n} mm</source>
        <translation>mm² oltre {n} mm</translation>
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
        <translation>? mostra tutti i tasti</translation>
    </message>
    <message>
        <source>Close the help</source>
        <translation>Chiudi l&apos;aiuto</translation>
    </message>
    <message>
        <source>Close the help (F1)</source>
        <translation>Chiudi l&apos;aiuto (F1)</translation>
    </message>
    <message>
        <source>Go to a control with Tab: what it does is said here.</source>
        <translation>Andare su un controllo con Tab: qui si dice che cosa fa.</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Aiuto</translation>
    </message>
    <message>
        <source>What is this?</source>
        <translation>Che cos&apos;è?</translation>
    </message>
    <message>
        <source>What the numbers mean</source>
        <translation>Che cosa dicono i numeri</translation>
    </message>
    <message>
        <source>What this page is for</source>
        <translation>A che cosa serve la pagina</translation>
    </message>
    <message>
        <source>What to do now</source>
        <translation>Che cosa fare ora</translation>
    </message>
</context>
<context>
    <name>HomePage</name>
    <message>
        <source>A scan is running.</source>
        <translation>Scansione in corso.</translation>
    </message>
    <message>
        <source>A scan is running: the order can wait in the list.</source>
        <translation>Scansione in corso: l&apos;ordine può attendere nella lista.</translation>
    </message>
    <message>
        <source>Del; the file is moved, never deleted</source>
        <translation>Canc; il file viene spostato, mai cancellato</translation>
    </message>
    <message>
        <source>Enter makes a new order {number}.</source>
        <translation>Invio crea il nuovo ordine {number}.</translation>
    </message>
    <message>
        <source>Enter opens the order of that number, or begins a new one.</source>
        <translation>Invio apre l&apos;ordine con quel numero, o ne inizia uno nuovo.</translation>
    </message>
    <message>
        <source>Enter opens {order}.</source>
        <translation>Invio apre {order}.</translation>
    </message>
    <message>
        <source>Enter, or a double click</source>
        <translation>Invio o doppio clic</translation>
    </message>
    <message>
        <source>Looking…</source>
        <translation>Ricerca…</translation>
    </message>
    <message>
        <source>No order has that in it.</source>
        <translation>Nessun ordine contiene questo testo.</translation>
    </message>
    <message>
        <source>No orders yet. They stand here as soon as they are entered.</source>
        <translation>Ancora nessun ordine. Compaiono qui appena inseriti.</translation>
    </message>
    <message>
        <source>Open another case…</source>
        <translation>Apri un altro caso…</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Rimuovi</translation>
    </message>
    <message>
        <source>The surface of this order is being made.</source>
        <translation>La superficie di questo ordine è in lavorazione.</translation>
    </message>
    <message>
        <source>This order is being scanned.</source>
        <translation>Questo ordine è in scansione.</translation>
    </message>
    <message>
        <source>Wait for it, or cancel it on the Reconstruct page.</source>
        <translation>Attendere, o annullarla nella pagina Ricostruzione.</translation>
    </message>
    <message>
        <source>Wait for its end or stop it first (Esc).</source>
        <translation>Attendere la fine o prima fermare (Esc).</translation>
    </message>
    <message>
        <source>{n} orders, the newest first. Arrow down goes into the list.</source>
        <translation>{n} ordini, prima i più recenti. Freccia giù: va nella lista.</translation>
    </message>
</context>
<context>
    <name>HomeStart</name>
    <message>
        <source>A scan is running.</source>
        <translation>Scansione in corso.</translation>
    </message>
    <message>
        <source>An ear on the virtual rig: nothing has to be connected, and nothing is overwritten</source>
        <translation>Un orecchio sul banco virtuale: niente da collegare, niente viene sovrascritto</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Cambia</translation>
    </message>
    <message>
        <source>Change the order</source>
        <translation>Modifica l&apos;ordine</translation>
    </message>
    <message>
        <source>Left and right: two cases with one order number</source>
        <translation>Sinistro e destro: due casi con un solo numero d&apos;ordine</translation>
    </message>
    <message>
        <source>New dental model</source>
        <translation>Nuovo modello dentale</translation>
    </message>
    <message>
        <source>New ear impression</source>
        <translation>Nuova impronta auricolare</translation>
    </message>
    <message>
        <source>New ear pair</source>
        <translation>Nuova coppia</translation>
    </message>
    <message>
        <source>Open now</source>
        <translation>Aperto ora</translation>
    </message>
    <message>
        <source>Rig</source>
        <translation>Banco</translation>
    </message>
    <message>
        <source>Try a demo order</source>
        <translation>Prova un ordine demo</translation>
    </message>
    <message>
        <source>{rig}, virtual; on the table: {specimen}</source>
        <translation>{rig}, virtuale; sulla tavola: {specimen}</translation>
    </message>
</context>
<context>
    <name>InterruptedStrip</name>
    <message>
        <source>A fault ended it.</source>
        <translation>Terminata da un guasto.</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Scarta</translation>
    </message>
    <message>
        <source>Keep what is there</source>
        <translation>Tieni ciò che c&apos;è</translation>
    </message>
    <message>
        <source>Leave it out of the case; nothing is deleted.</source>
        <translation>La lascia fuori dal caso; niente viene cancellato.</translation>
    </message>
    <message>
        <source>Nothing was deleted.</source>
        <translation>Niente è stato cancellato.</translation>
    </message>
    <message>
        <source>Put the same object back: known points are measured again, and only what is missing is scanned.</source>
        <translation>Rimettere lo stesso oggetto: punti noti sono rimisurati, e si scansiona solo ciò che manca.</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>Riprendi</translation>
    </message>
    <message>
        <source>Take what was measured for the whole, and open the case.</source>
        <translation>Prende quanto misurato per intero e apre il caso.</translation>
    </message>
    <message>
        <source>The program ended in the middle of it.</source>
        <translation>Il programma è terminato nel mezzo.</translation>
    </message>
    <message>
        <source>The scan of {order} did not come to its end.</source>
        <translation>La scansione di {order} non è arrivata alla fine.</translation>
    </message>
    <message>
        <source>The scan of {order} was discarded.</source>
        <translation>La scansione di {order} è stata scartata.</translation>
    </message>
    <message>
        <source>There are {n} more.</source>
        <translation>Ce ne sono altre {n}.</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Annulla</translation>
    </message>
    <message>
        <source>{measured} of {wanted} points, {done} of {views} views complete; begun {when}.</source>
        <translation>{measured} di {wanted} punti, {done} di {views} viste complete; iniziata {when}.</translation>
    </message>
</context>
<context>
    <name>JogPanel</name>
    <message>
        <source>Beam down</source>
        <translation>Raggio in basso</translation>
    </message>
    <message>
        <source>Beam left</source>
        <translation>Raggio a sinistra</translation>
    </message>
    <message>
        <source>Beam right</source>
        <translation>Raggio a destra</translation>
    </message>
    <message>
        <source>Beam up</source>
        <translation>Raggio in alto</translation>
    </message>
    <message>
        <source>By hand</source>
        <translation>Manuale</translation>
    </message>
    <message>
        <source>Show the spot</source>
        <translation>Mostra il punto</translation>
    </message>
    <message>
        <source>Steps of {n} degrees</source>
        <translation>Passi di {n} gradi</translation>
    </message>
    <message>
        <source>Stop moving</source>
        <translation>Ferma il moto</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tavola</translation>
    </message>
    <message>
        <source>Table clockwise</source>
        <translation>Tavola in senso orario</translation>
    </message>
    <message>
        <source>Table counter-clockwise</source>
        <translation>Tavola in senso antiorario</translation>
    </message>
</context>
<context>
    <name>Legend</name>
    <message>
        <source>Age</source>
        <translation>Età</translation>
    </message>
    <message>
        <source>Colours: {name}, {low} to {high}</source>
        <translation>Colori: {name}, da {low} a {high}</translation>
    </message>
    <message>
        <source>Density, points/mm²</source>
        <translation>Densità, punti/mm²</translation>
    </message>
    <message>
        <source>Epipolar residual, σ</source>
        <translation>Residuo epipolare, σ</translation>
    </message>
    <message>
        <source>Height, mm</source>
        <translation>Altezza, mm</translation>
    </message>
    <message>
        <source>Points by</source>
        <translation>Punti secondo</translation>
    </message>
    <message>
        <source>Standard uncertainty, µm</source>
        <translation>Incertezza tipo, µm</translation>
    </message>
    <message>
        <source>Support by points</source>
        <translation>Sostegno dei punti</translation>
    </message>
    <message>
        <source>Surface by</source>
        <translation>Superficie secondo</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vista</translation>
    </message>
    <message>
        <source>What the colours mean; click to choose  (K: the next one)</source>
        <translation>Che cosa dicono i colori; clic per scegliere  (K: il successivo)</translation>
    </message>
    <message>
        <source>filled in</source>
        <translation>colmata</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>misurata</translation>
    </message>
    <message>
        <source>newest</source>
        <translation>più nuovo</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>non noto</translation>
    </message>
    <message>
        <source>oldest</source>
        <translation>più vecchio</translation>
    </message>
    <message>
        <source>{n} and more</source>
        <translation>{n} e oltre</translation>
    </message>
    <message>
        <source>{n} s ago</source>
        <translation>{n} s fa</translation>
    </message>
</context>
<context>
    <name>LiveSurface</name>
    <message>
        <source>No surface yet: some parts are too thin so far</source>
        <translation>Ancora niente superficie: alcune parti finora sono troppo rade</translation>
    </message>
    <message>
        <source>No surface yet: the body has a hole right through it</source>
        <translation>Ancora niente superficie: il corpo è forato da parte a parte</translation>
    </message>
    <message>
        <source>No surface yet: the points make no body</source>
        <translation>Ancora niente superficie: i punti non formano un corpo</translation>
    </message>
    <message>
        <source>No surface yet: too few points</source>
        <translation>Ancora niente superficie: troppo pochi punti</translation>
    </message>
    <message>
        <source>Surface so far: {share} % scanned, its base included; nets are holes</source>
        <translation>Superficie finora: {share} % scansionato, base compresa; le reti sono lacune</translation>
    </message>
    <message>
        <source>The live surface has ended; the scan goes on without it.</source>
        <translation>La superficie dal vivo si è interrotta; la scansione continua senza.</translation>
    </message>
</context>
<context>
    <name>MainWindow</name>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Ripeti</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Annulla</translation>
    </message>
    <message>
        <source>A scan is running.</source>
        <translation>Scansione in corso.</translation>
    </message>
    <message>
        <source>Both ears are measured: {left} points on the left one, {right} on the right one.</source>
        <translation>Entrambi gli orecchi sono misurati: {left} punti sul sinistro, {right} sul destro.</translation>
    </message>
    <message>
        <source>Cases (*.impronta)</source>
        <translation>Casi (*.impronta)</translation>
    </message>
    <message>
        <source>Each is an order of its own now; both stand in the worklist.</source>
        <translation>Ora ognuno è un ordine a sé; entrambi sono nella lista di lavoro.</translation>
    </message>
    <message>
        <source>It is kept in its case.</source>
        <translation>È conservata nel suo caso.</translation>
    </message>
    <message>
        <source>Open a case</source>
        <translation>Apri un caso</translation>
    </message>
    <message>
        <source>Open it</source>
        <translation>Apri</translation>
    </message>
    <message>
        <source>The surface of {case} is done.</source>
        <translation>La superficie di {case} è finita.</translation>
    </message>
    <message>
        <source>Wait for its end or stop it first (Esc).</source>
        <translation>Attendere la fine o prima fermare (Esc).</translation>
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
        <translation>Attraverso x</translation>
    </message>
    <message>
        <source>Across y</source>
        <translation>Attraverso y</translation>
    </message>
    <message>
        <source>Canal</source>
        <translation>Condotto</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annulla</translation>
    </message>
    <message>
        <source>Click a place, or move the plane.</source>
        <translation>Fare clic su un punto, o spostare il piano.</translation>
    </message>
    <message>
        <source>Click the second place.</source>
        <translation>Fare clic sul secondo punto.</translation>
    </message>
    <message>
        <source>Click two places on the surface.</source>
        <translation>Fare clic su due punti della superficie.</translation>
    </message>
    <message>
        <source>Click two points. Sections, canal and volume are measured on the surface: reconstruct it first.</source>
        <translation>Fare clic su due punti. Sezioni, condotto e volume si misurano sulla superficie: prima ricostruirla.</translation>
    </message>
    <message>
        <source>Copy as text</source>
        <translation>Copia come testo</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Distanza</translation>
    </message>
    <message>
        <source>From the highest point, or click the tip of the canal.</source>
        <translation>Dal punto più alto, o fare clic sulla punta del condotto.</translation>
    </message>
    <message>
        <source>Keep this section</source>
        <translation>Tieni questa sezione</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Orizzontale</translation>
    </message>
    <message>
        <source>Measure the canal</source>
        <translation>Misura il condotto</translation>
    </message>
    <message>
        <source>Measure the volume</source>
        <translation>Misura il volume</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Misurato</translation>
    </message>
    <message>
        <source>Measuring…</source>
        <translation>Misura…</translation>
    </message>
    <message>
        <source>No canal was found there. Click the tip of the canal on the surface.</source>
        <translation>Lì nessun condotto trovato. Fare clic sulla punta del condotto, sulla superficie.</translation>
    </message>
    <message>
        <source>Nothing yet.</source>
        <translation>Ancora niente.</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Posizione</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Rimuovi</translation>
    </message>
    <message>
        <source>Remove measurement {n}</source>
        <translation>Rimuovi misura {n}</translation>
    </message>
    <message>
        <source>Scan an object or open a case first.</source>
        <translation>Prima scansionare un oggetto o aprire un caso.</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Sezione</translation>
    </message>
    <message>
        <source>The surface is not closed, so it encloses no volume.</source>
        <translation>La superficie non è chiusa, quindi non racchiude un volume.</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volume</translation>
    </message>
    <message>
        <source>What the closed surface encloses.</source>
        <translation>Ciò che la superficie chiusa racchiude.</translation>
    </message>
    <message>
        <source>mm perimeter</source>
        <translation>mm perimetro</translation>
    </message>
    <message>
        <source>mm² area</source>
        <translation>mm² area</translation>
    </message>
    <message>
        <source>{told}. Of another surface than the one that is shown.</source>
        <translation>{told}. Di un&apos;altra superficie, non di quella mostrata.</translation>
    </message>
</context>
<context>
    <name>MountsPage</name>
    <message>
        <source>1  Set the object down anew</source>
        <translation>1  Posare l&apos;oggetto in altro modo</translation>
    </message>
    <message>
        <source>2  Scan it into the same case</source>
        <translation>2  Scansionare nello stesso caso</translation>
    </message>
    <message>
        <source>Another mount</source>
        <translation>Altro posizionamento</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annulla</translation>
    </message>
    <message>
        <source>How the mounts lie</source>
        <translation>Come stanno i posizionamenti</translation>
    </message>
    <message>
        <source>Leave about half of what was scanned in sight, near the middle of the table, and see that nothing wobbles.</source>
        <translation>Lasciare in vista circa metà di quanto scansionato, vicino al centro della tavola, e badare che niente dondoli.</translation>
    </message>
    <message>
        <source>Look again how they lie</source>
        <translation>Riesamina come stanno</translation>
    </message>
    <message>
        <source>Looking how the mounts lie on each other…</source>
        <translation>Esame di come stanno i posizionamenti fra loro…</translation>
    </message>
    <message>
        <source>Nothing is lost: all points are kept in the case.</source>
        <translation>Niente va perso: tutti i punti restano nel caso.</translation>
    </message>
    <message>
        <source>Pick three points</source>
        <translation>Scegli tre punti</translation>
    </message>
    <message>
        <source>Reconstruct</source>
        <translation>Ricostruisci</translation>
    </message>
    <message>
        <source>Registration</source>
        <translation>Registrazione</translation>
    </message>
    <message>
        <source>Scan another mount</source>
        <translation>Altro posizionamento</translation>
    </message>
    <message>
        <source>Scan this mount</source>
        <translation>Scansiona posizionamento</translation>
    </message>
    <message>
        <source>The points of the earlier mounts stay (Shift+F9)</source>
        <translation>I punti dei posizionamenti precedenti restano (Maiusc+F9)</translation>
    </message>
    <message>
        <source>Tip it by 60 to 90° or turn it over, so that what was hidden comes into view.</source>
        <translation>Inclinarlo di 60-90° o capovolgerlo, così che il nascosto diventi visibile.</translation>
    </message>
    <message>
        <source>Tip the virtual object</source>
        <translation>Inclina l&apos;oggetto virtuale</translation>
    </message>
</context>
<context>
    <name>OrderForm</name>
    <message>
        <source>Another order has this number and side too; both are kept.</source>
        <translation>Un altro ordine ha lo stesso numero e lo stesso lato; restano entrambi.</translation>
    </message>
    <message>
        <source>Back to the list</source>
        <translation>Torna alla lista</translation>
    </message>
    <message>
        <source>Ctrl+Enter</source>
        <translation>Ctrl+Invio</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fatto</translation>
    </message>
    <message>
        <source>Every change is kept in the case, and can be undone.</source>
        <translation>Ogni modifica è conservata nel caso e si può annullare.</translation>
    </message>
    <message>
        <source>File names</source>
        <translation>Nomi dei file</translation>
    </message>
    <message>
        <source>Keep it in the list</source>
        <translation>Tieni nella lista</translation>
    </message>
    <message>
        <source>Make both orders, scan the first</source>
        <translation>Crea i due ordini, scansiona il primo</translation>
    </message>
    <message>
        <source>Make the order and scan</source>
        <translation>Crea l&apos;ordine e scansiona</translation>
    </message>
    <message>
        <source>New order</source>
        <translation>Nuovo ordine</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Ordine</translation>
    </message>
    <message>
        <source>Order number</source>
        <translation>Numero d&apos;ordine</translation>
    </message>
    <message>
        <source>Patient code</source>
        <translation>Codice paziente</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Lato</translation>
    </message>
    <message>
        <source>The order has no number yet.</source>
        <translation>L&apos;ordine non ha ancora un numero.</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Which jaw is it?</source>
        <translation>Quale arcata?</translation>
    </message>
    <message>
        <source>Which side is it?</source>
        <translation>Quale lato?</translation>
    </message>
    <message>
        <source>a code, not the name</source>
        <translation>un codice, non il nome</translation>
    </message>
    <message>
        <source>as on the order form</source>
        <translation>come sul modulo d&apos;ordine</translation>
    </message>
</context>
<context>
    <name>OrderList</name>
    <message>
        <source>Open</source>
        <translation>Apri</translation>
    </message>
    <message>
        <source>Orders</source>
        <translation>Ordini</translation>
    </message>
    <message>
        <source>Remove from the list</source>
        <translation>Togli dalla lista</translation>
    </message>
</context>
<context>
    <name>OutlierShape</name>
    <message>
        <source>Cancel</source>
        <translation>Annulla</translation>
    </message>
    <message>
        <source>How many times the usual distance to its neighbours a point may lie off them</source>
        <translation>Quante volte la distanza usuale dai vicini un punto può scostarsene</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>Limite</translation>
    </message>
    <message>
        <source>Looking at every point</source>
        <translation>Esame di ogni punto</translation>
    </message>
    <message>
        <source>Points that are far from their neighbours, off their surface, or in a small group of their own.</source>
        <translation>Punti lontani dai vicini, fuori dalla loro superficie, o in un piccolo gruppo a sé.</translation>
    </message>
</context>
<context>
    <name>PickPage</name>
    <message>
        <source>All mounts lie together; there is nothing to pick.</source>
        <translation>Tutti i posizionamenti stanno insieme; niente da scegliere.</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Indietro</translation>
    </message>
    <message>
        <source>Click place {n} of three on the left, then the same place on the right; far from each other and easy to tell.</source>
        <translation>Fare clic sul punto {n} di tre a sinistra, poi sullo stesso a destra; lontani fra loro e facili da riconoscere.</translation>
    </message>
    <message>
        <source>It did not fit from these points. Take the last one back, or start again with places that you are sure of.</source>
        <translation>Con questi punti non combacia. Togliere l&apos;ultimo, o ricominciare con punti sicuri.</translation>
    </message>
    <message>
        <source>Looking whether the mounts fit from there…</source>
        <translation>Prova se da lì i posizionamenti combaciano…</translation>
    </message>
    <message>
        <source>Now click the same place {n} on the right.</source>
        <translation>Ora fare clic sullo stesso punto {n} a destra.</translation>
    </message>
    <message>
        <source>Pick three points</source>
        <translation>Scelta di tre punti</translation>
    </message>
    <message>
        <source>Points of the mount to be joined</source>
        <translation>Punti del posizionamento da unire</translation>
    </message>
    <message>
        <source>Points of the mounts that lie together</source>
        <translation>Punti dei posizionamenti già uniti</translation>
    </message>
    <message>
        <source>Preparing the 3D view…</source>
        <translation>Preparazione della vista 3D…</translation>
    </message>
    <message>
        <source>Start again</source>
        <translation>Ricomincia</translation>
    </message>
    <message>
        <source>Take the last point back (Ctrl+Z)</source>
        <translation>Togli l&apos;ultimo punto (Ctrl+Z)</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Annulla</translation>
    </message>
    <message>
        <source>Where it is known</source>
        <translation>Dove è noto</translation>
    </message>
</context>
<context>
    <name>PickView</name>
    <message>
        <source>Turn it with the arrow keys, come nearer with plus and minus, pick the point in the middle with the space bar.</source>
        <translation>Girare con le frecce, avvicinare con più e meno, scegliere il punto al centro con la barra spaziatrice.</translation>
    </message>
</context>
<context>
    <name>PlaceEntry</name>
    <message>
        <source>✓ Accepted as it is: {why}</source>
        <translation>✓ Accettata così com&apos;è: {why}</translation>
    </message>
</context>
<context>
    <name>PlaceList</name>
    <message>
        <source>Places that are not as certain as wanted</source>
        <translation>Zone meno certe di quanto richiesto</translation>
    </message>
</context>
<context>
    <name>PlanBar</name>
    <message>
        <source>Plan: {done} of {count} views are done</source>
        <translation>Piano: {done} viste di {count} fatte</translation>
    </message>
    <message>
        <source>View {number} at {angle:.0f}°: {state}</source>
        <translation>Vista {number} a {angle:.0f}°: {state}</translation>
    </message>
    <message>
        <source>being measured</source>
        <translation>in misura</translation>
    </message>
    <message>
        <source>done</source>
        <translation>fatta</translation>
    </message>
    <message>
        <source>far fewer points than its neighbours</source>
        <translation>molti meno punti delle vicine</translation>
    </message>
    <message>
        <source>to come</source>
        <translation>da fare</translation>
    </message>
    <message>
        <source>will be measured once more</source>
        <translation>sarà rimisurata</translation>
    </message>
    <message>
        <source>{points} of {wanted} points, {rejected} rejected</source>
        <translation>{points} di {wanted} punti, {rejected} scartati</translation>
    </message>
    <message>
        <source>{points} points, {rejected} rejected</source>
        <translation>{points} punti, {rejected} scartati</translation>
    </message>
    <message>
        <source>{told}; measured twice</source>
        <translation>{told}; misurata due volte</translation>
    </message>
</context>
<context>
    <name>PointsPanel</name>
    <message>
        <source>Also what lies behind</source>
        <translation>Anche ciò che sta dietro</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Riquadro</translation>
    </message>
    <message>
        <source>Bring all back</source>
        <translation>Recupera tutti</translation>
    </message>
    <message>
        <source>Bring points back instead</source>
        <translation>Recupera punti, invece</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>Pennello</translation>
    </message>
    <message>
        <source>Crop</source>
        <translation>Ritaglia</translation>
    </message>
    <message>
        <source>Cut the base</source>
        <translation>Taglia la base</translation>
    </message>
    <message>
        <source>Invert</source>
        <translation>Inverti</translation>
    </message>
    <message>
        <source>Lasso</source>
        <translation>Lazo</translation>
    </message>
    <message>
        <source>Many at once</source>
        <translation>Molti insieme</translation>
    </message>
    <message>
        <source>On the picture</source>
        <translation>Sull&apos;immagine</translation>
    </message>
    <message>
        <source>Otherwise only what is in front, as it is seen, is taken</source>
        <translation>Altrimenti si prende solo ciò che sta davanti, come si vede</translation>
    </message>
    <message>
        <source>Outliers</source>
        <translation>Anomali</translation>
    </message>
    <message>
        <source>Show what was taken out</source>
        <translation>Mostra i punti tolti</translation>
    </message>
    <message>
        <source>Take out what is left, and bring back what was taken out</source>
        <translation>Toglie ciò che resta e recupera ciò che era tolto</translation>
    </message>
    <message>
        <source>of {n} points taken out</source>
        <translation>di {n} punti tolti</translation>
    </message>
</context>
<context>
    <name>PortLine</name>
    <message>
        <source>Part of the program: to try the assistant without devices.</source>
        <translation>Parte del programma: per provare l&apos;assistente senza dispositivi.</translation>
    </message>
    <message>
        <source>Virtual controller</source>
        <translation>Controllore virtuale</translation>
    </message>
</context>
<context>
    <name>Preferences</name>
    <message>
        <source>reset of the settings</source>
        <translation>ripristino delle impostazioni</translation>
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
        <translation>Calibrazione</translation>
    </message>
    <message>
        <source>Epipolar gate</source>
        <translation>Soglia epipolare</translation>
    </message>
    <message>
        <source>How far the two cameras may disagree, in standard uncertainties; scanned with 3.</source>
        <translation>Quanto le due telecamere possono discordare, in incertezze tipo; scansionato con 3.</translation>
    </message>
    <message>
        <source>Points of darker spots are left out; the brightest pixel is 255.</source>
        <translation>I punti laser più scuri sono esclusi; il pixel più chiaro è 255.</translation>
    </message>
    <message>
        <source>Spot peak</source>
        <translation>Picco del punto</translation>
    </message>
    <message>
        <source>as scanned</source>
        <translation>come scansionato</translation>
    </message>
    <message>
        <source>of the rig now</source>
        <translation>del banco attuale</translation>
    </message>
</context>
<context>
    <name>ProfilePanel</name>
    <message>
        <source>Certificate beside it (PDF and JSON)</source>
        <translation>Certificato accanto (PDF e JSON)</translation>
    </message>
    <message>
        <source>Choose a folder</source>
        <translation>Scelta di una cartella</translation>
    </message>
    <message>
        <source>Copy as my own</source>
        <translation>Copia come mio</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fatto</translation>
    </message>
    <message>
        <source>Every change counts at once; Ctrl+Z takes it back.</source>
        <translation>Ogni modifica vale subito; Ctrl+Z la annulla.</translation>
    </message>
    <message>
        <source>File name</source>
        <translation>Nome del file</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Cartella</translation>
    </message>
    <message>
        <source>Folder for exported files</source>
        <translation>Cartella dei file esportati</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Formato</translation>
    </message>
    <message>
        <source>In braces: {fields}</source>
        <translation>Fra graffe: {fields}</translation>
    </message>
    <message>
        <source>Lies</source>
        <translation>Orientamento</translation>
    </message>
    <message>
        <source>Measured points beside it (XYZ)</source>
        <translation>Punti misurati accanto (XYZ)</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nome</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Rimuovi</translation>
    </message>
    <message>
        <source>This profile belongs to the program. Copy it to change it.</source>
        <translation>Questo profilo è del programma. Copiarlo per modificarlo.</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unità</translation>
    </message>
    <message>
        <source>Without its base (open surface)</source>
        <translation>Senza base (superficie aperta)</translation>
    </message>
</context>
<context>
    <name>Rail</name>
    <message>
        <source>Before: {before}
After: {after}</source>
        <translation>Prima: {before}
Dopo: {after}</translation>
    </message>
    <message>
        <source>Esc, from every page</source>
        <translation>Esc, da ogni pagina</translation>
    </message>
    <message>
        <source>Laser on · stop</source>
        <translation>Laser acceso · ferma</translation>
    </message>
    <message>
        <source>No order number</source>
        <translation>Senza numero d&apos;ordine</translation>
    </message>
    <message>
        <source>No order open</source>
        <translation>Nessun ordine aperto</translation>
    </message>
    <message>
        <source>Stop · laser off</source>
        <translation>Ferma · laser spento</translation>
    </message>
    <message>
        <source>Stop · laser?</source>
        <translation>Ferma · laser?</translation>
    </message>
    <message>
        <source>Stops every movement and switches the laser off, from every page (Esc)</source>
        <translation>Ferma ogni movimento e spegne il laser, da ogni pagina (Esc)</translation>
    </message>
    <message>
        <source>none yet</source>
        <translation>ancora nessuna</translation>
    </message>
</context>
<context>
    <name>ReadyLine</name>
    <message>
        <source>Attention</source>
        <translation>Attenzione</translation>
    </message>
    <message>
        <source>Checking</source>
        <translation>Verifica</translation>
    </message>
    <message>
        <source>Not now</source>
        <translation>Non ora</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>Pronto</translation>
    </message>
</context>
<context>
    <name>ReconstructPage</name>
    <message>
        <source>% supported</source>
        <translation>% sostenuto</translation>
    </message>
    <message>
        <source>As many orders wait as can be kept in mind. Take one out, or wait for the next to begin.</source>
        <translation>Attendono già tutti gli ordini che la memoria contiene. Toglierne uno, o attendere che inizi il prossimo.</translation>
    </message>
    <message>
        <source>Back to the result</source>
        <translation>Torna al risultato</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annulla</translation>
    </message>
    <message>
        <source>Complete</source>
        <translation>Completa</translation>
    </message>
    <message>
        <source>Compute the points anew…</source>
        <translation>Ricalcola i punti…</translation>
    </message>
    <message>
        <source>Deliver</source>
        <translation>Consegna</translation>
    </message>
    <message>
        <source>Distance of the points from the surface</source>
        <translation>Distanza dei punti dalla superficie</translation>
    </message>
    <message>
        <source>Finishes the surface as it is now: whole and closed, but coarser than the points allow.</source>
        <translation>Termina la superficie com&apos;è ora: intera e chiusa, ma più grossolana di quanto i punti consentano.</translation>
    </message>
    <message>
        <source>It waits</source>
        <translation>In attesa</translation>
    </message>
    <message>
        <source>Other settings…</source>
        <translation>Altre impostazioni…</translation>
    </message>
    <message>
        <source>Places that are not as certain as wanted, why, and what can be done about them (F8)</source>
        <translation>Zone meno certe di quanto richiesto, perché, e che cosa si può fare (F8)</translation>
    </message>
    <message>
        <source>Reconstruct</source>
        <translation>Ricostruisci</translation>
    </message>
    <message>
        <source>Reconstruct again</source>
        <translation>Ricostruisci di nuovo</translation>
    </message>
    <message>
        <source>Reconstruct next</source>
        <translation>Ricostruisci dopo</translation>
    </message>
    <message>
        <source>Scan first, or open a case with points.</source>
        <translation>Prima scansionare, o aprire un caso con punti.</translation>
    </message>
    <message>
        <source>Share of the whole surface that rests on measured points, the base on which the object stood included; Deliver leaves the base out.</source>
        <translation>Parte dell&apos;intera superficie sostenuta da punti misurati, compresa la base su cui poggiava l&apos;oggetto; la consegna esclude la base.</translation>
    </message>
    <message>
        <source>Stop here and keep</source>
        <translation>Ferma qui e conserva</translation>
    </message>
    <message>
        <source>The surface is kept in the case.</source>
        <translation>La superficie è conservata nel caso.</translation>
    </message>
    <message>
        <source>These points wait for their turn.</source>
        <translation>Questi punti attendono il loro turno.</translation>
    </message>
    <message>
        <source>mm³ volume</source>
        <translation>mm³ volume</translation>
    </message>
    <message>
        <source>triangles</source>
        <translation>triangoli</translation>
    </message>
    <message>
        <source>{points} points are ready.</source>
        <translation>{points} punti sono pronti.</translation>
    </message>
    <message>
        <source>µm expected error</source>
        <translation>µm errore atteso</translation>
    </message>
</context>
<context>
    <name>ReconstructionPhases</name>
    <message>
        <source>Cancelling…</source>
        <translation>Annullamento…</translation>
    </message>
    <message>
        <source>Finishing what there is…</source>
        <translation>Si termina ciò che c&apos;è…</translation>
    </message>
    <message>
        <source>Looking at the points…</source>
        <translation>Esame dei punti…</translation>
    </message>
    <message>
        <source>Progress of the reconstruction</source>
        <translation>Avanzamento della ricostruzione</translation>
    </message>
    <message>
        <source>Starting…</source>
        <translation>Avvio…</translation>
    </message>
    <message>
        <source>{left} left</source>
        <translation>{left} rimasti</translation>
    </message>
</context>
<context>
    <name>ReconstructionWaiting</name>
    <message>
        <source>Waiting</source>
        <translation>In attesa</translation>
    </message>
</context>
<context>
    <name>ReconstructionWishes</name>
    <message>
        <source>Detail</source>
        <translation>Dettaglio</translation>
    </message>
    <message>
        <source>Expert…</source>
        <translation>Avanzate…</translation>
    </message>
    <message>
        <source>Hide expert settings</source>
        <translation>Nascondi impostazioni avanzate</translation>
    </message>
    <message>
        <source>The middle is the default: as many triangles as the points carry. Each step halves or doubles them.</source>
        <translation>Il centro è il valore predefinito: tanti triangoli quanti i punti ne reggono. Ogni passo dimezza o raddoppia.</translation>
    </message>
    <message>
        <source>coarse</source>
        <translation>grossolano</translation>
    </message>
    <message>
        <source>default</source>
        <translation>predefinito</translation>
    </message>
    <message>
        <source>fine</source>
        <translation>fine</translation>
    </message>
</context>
<context>
    <name>RejectList</name>
    <message>
        <source>Rejected</source>
        <translation>Scartati</translation>
    </message>
    <message>
        <source>none</source>
        <translation>nessuno</translation>
    </message>
    <message>
        <source>other</source>
        <translation>altro</translation>
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
        <translation>1 osservazione</translation>
    </message>
    <message>
        <source>{n} remarks</source>
        <translation>{n} osservazioni</translation>
    </message>
</context>
<context>
    <name>RemovedStrip</name>
    <message>
        <source>Undo</source>
        <translation>Annulla</translation>
    </message>
    <message>
        <source>{order} was removed; its file is kept.</source>
        <translation>{order} rimosso; il suo file è conservato.</translation>
    </message>
</context>
<context>
    <name>RigChoice</name>
    <message>
        <source>A mesh as specimen</source>
        <translation>Una mesh come oggetto</translation>
    </message>
    <message>
        <source>Mesh file…</source>
        <translation>File mesh…</translation>
    </message>
    <message>
        <source>Meshes (*.stl *.ply *.obj *.vtp *.3mf)</source>
        <translation>Mesh (*.stl *.ply *.obj *.vtp *.3mf)</translation>
    </message>
    <message>
        <source>On the table</source>
        <translation>Sulla tavola</translation>
    </message>
    <message>
        <source>Open a rig file</source>
        <translation>Apri un file del banco</translation>
    </message>
    <message>
        <source>Open a rig file (TOML); it can be dropped here, too</source>
        <translation>Apre un file del banco (TOML); si può anche trascinare qui</translation>
    </message>
    <message>
        <source>Own rig…</source>
        <translation>Altro banco…</translation>
    </message>
    <message>
        <source>Rig</source>
        <translation>Banco</translation>
    </message>
    <message>
        <source>Rig files (*.toml)</source>
        <translation>File del banco (*.toml)</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Velocità</translation>
    </message>
</context>
<context>
    <name>RigPage</name>
    <message>
        <source>Camera left</source>
        <translation>Telecamera sinistra</translation>
    </message>
    <message>
        <source>Camera right</source>
        <translation>Telecamera destra</translation>
    </message>
    <message>
        <source>Finds ports and cameras, checks them by what the cameras see, and writes a rig file</source>
        <translation>Trova porte e telecamere, le verifica con ciò che le telecamere vedono e scrive un file del banco</translation>
    </message>
    <message>
        <source>Measure the sphere…</source>
        <translation>Misura la sfera…</translation>
    </message>
    <message>
        <source>Set up a rig…</source>
        <translation>Configura un banco…</translation>
    </message>
    <message>
        <source>Two cameras, a laser and a turntable, computed frame by frame; the rest is the real program.</source>
        <translation>Due telecamere, un laser e una tavola rotante, calcolati immagine per immagine; il resto è il programma vero.</translation>
    </message>
    <message>
        <source>Virtual rig</source>
        <translation>Banco virtuale</translation>
    </message>
    <message>
        <source>{rig} (virtual rig)</source>
        <translation>{rig} (banco virtuale)</translation>
    </message>
</context>
<context>
    <name>ScanPage</name>
    <message>
        <source>  (and {count} more)</source>
        <translation>  (e altri {count})</translation>
    </message>
    <message>
        <source>1 place cannot be seen from this mount</source>
        <translation>1 zona non si vede da questo posizionamento</translation>
    </message>
    <message>
        <source>A fault: the laser is off</source>
        <translation>Guasto: il laser è spento</translation>
    </message>
    <message>
        <source>Another mount</source>
        <translation>Altro posizionamento</translation>
    </message>
    <message>
        <source>Bringing the views together…</source>
        <translation>Unione delle viste…</translation>
    </message>
    <message>
        <source>By how much the first view lay beside itself when it was measured again at the end of the turn</source>
        <translation>Di quanto la prima vista era spostata da sé stessa quando è stata rimisurata a fine giro</translation>
    </message>
    <message>
        <source>Camera left</source>
        <translation>Telecamera sinistra</translation>
    </message>
    <message>
        <source>Camera right</source>
        <translation>Telecamera destra</translation>
    </message>
    <message>
        <source>Closing the turn: the first view is measured again and compared.</source>
        <translation>Chiusura del giro: la prima vista è rimisurata e confrontata.</translation>
    </message>
    <message>
        <source>Coarse pass: view {view} of {views}</source>
        <translation>Passata grossolana: vista {view} di {views}</translation>
    </message>
    <message>
        <source>Complete</source>
        <translation>Completa</translation>
    </message>
    <message>
        <source>Computing where more points are needed…</source>
        <translation>Calcolo di dove servono altri punti…</translation>
    </message>
    <message>
        <source>Ended by a fault; what was measured is kept</source>
        <translation>Terminata per un guasto; quanto misurato è conservato</translation>
    </message>
    <message>
        <source>Finding the object, view {view} of {views}</source>
        <translation>Ricerca dell&apos;oggetto, vista {view} di {views}</translation>
    </message>
    <message>
        <source>How far off the surface may be (standard uncertainty). With a value, the scan measures more where the surface is less certain, until it is as certain everywhere that light can reach or the points are spent. With none, the points are spread evenly.</source>
        <translation>Di quanto la superficie può scostarsi dal vero (incertezza tipo). Con un valore, la scansione misura di più dove la superficie è meno certa, finché lo è abbastanza ovunque la luce arriva o i punti sono esauriti. Senza, i punti sono distribuiti in modo uniforme.</translation>
    </message>
    <message>
        <source>Laser off at once, and the end of the scan; what was measured is kept (Esc)</source>
        <translation>Spegne subito il laser e termina la scansione; quanto misurato è conservato (Esc)</translation>
    </message>
    <message>
        <source>Opening the rig…</source>
        <translation>Apertura del banco…</translation>
    </message>
    <message>
        <source>Pass {number}, where it is needed: view {view} of {views}</source>
        <translation>Passata {number}, dove serve: vista {view} di {views}</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pausa</translation>
    </message>
    <message>
        <source>Paused in view {view} of {views}. The laser is dark, beam and table rest, all points so far are kept; it goes on with the next row.</source>
        <translation>In pausa nella vista {view} di {views}. Laser spento, raggio e tavola fermi, tutti i punti conservati; riprende dalla riga successiva.</translation>
    </message>
    <message>
        <source>Pausing: the row that is being swept is finished first.</source>
        <translation>Pausa: prima finisce la riga in corso.</translation>
    </message>
    <message>
        <source>Places that are not as certain as wanted, why, and what can be done about them (F8)</source>
        <translation>Zone meno certe di quanto richiesto, perché, e che cosa si può fare (F8)</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punti</translation>
    </message>
    <message>
        <source>Points at most</source>
        <translation>Punti al massimo</translation>
    </message>
    <message>
        <source>Ready to scan</source>
        <translation>Pronto a scansionare</translation>
    </message>
    <message>
        <source>Reconstruct</source>
        <translation>Ricostruisci</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>Riprendi</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>Scansione</translation>
    </message>
    <message>
        <source>Scan again</source>
        <translation>Ripeti scansione</translation>
    </message>
    <message>
        <source>Scan again…</source>
        <translation>Ripeti scansione…</translation>
    </message>
    <message>
        <source>Scan until {wanted} µm</source>
        <translation>Scansione fino a {wanted} µm</translation>
    </message>
    <message>
        <source>Set the object down in another way and scan it into the same case (F9)</source>
        <translation>Posare l&apos;oggetto in altro modo e scansionarlo nello stesso caso (F9)</translation>
    </message>
    <message>
        <source>Start scan</source>
        <translation>Avvia scansione</translation>
    </message>
    <message>
        <source>Starting…</source>
        <translation>Avvio…</translation>
    </message>
    <message>
        <source>Still far fewer points than their neighbours: {views}</source>
        <translation>Ancora molti meno punti delle vicine: {views}</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Ferma</translation>
    </message>
    <message>
        <source>Stopped; what was measured is kept</source>
        <translation>Fermata; quanto misurato è conservato</translation>
    </message>
    <message>
        <source>The rig has to be calibrated first.</source>
        <translation>Prima occorre calibrare il banco.</translation>
    </message>
    <message>
        <source>The rig is not ready; the Rig page says why.</source>
        <translation>Il banco non è pronto; la pagina Banco dice perché.</translation>
    </message>
    <message>
        <source>The scan is complete.</source>
        <translation>La scansione è completa.</translation>
    </message>
    <message>
        <source>Uncertainty wanted</source>
        <translation>Incertezza voluta</translation>
    </message>
    <message>
        <source>View {view} of {views}</source>
        <translation>Vista {view} di {views}</translation>
    </message>
    <message>
        <source>View {view} once more</source>
        <translation>Vista {view} di nuovo</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>Viste</translation>
    </message>
    <message>
        <source>Views measured once more: {views}</source>
        <translation>Viste misurate di nuovo: {views}</translation>
    </message>
    <message>
        <source>Whether the turn closes is not known: too few points of the first view were seen again.</source>
        <translation>Non si sa se il giro si chiude: troppo pochi punti della prima vista rivisti.</translation>
    </message>
    <message>
        <source>all points are spent</source>
        <translation>punti esauriti</translation>
    </message>
    <message>
        <source>min:s</source>
        <translation>min:s</translation>
    </message>
    <message>
        <source>min:s left</source>
        <translation>min:s rimasti</translation>
    </message>
    <message>
        <source>more points would not help</source>
        <translation>altri punti non servirebbero</translation>
    </message>
    <message>
        <source>no further view fits into this scan</source>
        <translation>non ci sta un&apos;altra vista in questa scansione</translation>
    </message>
    <message>
        <source>none</source>
        <translation>nessuna</translation>
    </message>
    <message>
        <source>points</source>
        <translation>punti</translation>
    </message>
    <message>
        <source>points / s</source>
        <translation>punti / s</translation>
    </message>
    <message>
        <source>{count} places cannot be seen from this mount</source>
        <translation>{count} zone non si vedono da questo posizionamento</translation>
    </message>
    <message>
        <source>{points} points  ·  view {view} of {views}</source>
        <translation>{points} punti  ·  vista {view} di {views}</translation>
    </message>
    <message>
        <source>{points} points  ·  view {view} once more</source>
        <translation>{points} punti  ·  vista {view} di nuovo</translation>
    </message>
    <message>
        <source>{share} % within {wanted} µm</source>
        <translation>{share} % entro {wanted} µm</translation>
    </message>
    <message>
        <source>{share} % within {wanted} µm so far</source>
        <translation>{share} % entro {wanted} µm finora</translation>
    </message>
    <message>
        <source>µm closure</source>
        <translation>µm chiusura</translation>
    </message>
</context>
<context>
    <name>ScanTray</name>
    <message>
        <source>Both ears on the pair tray</source>
        <translation>Due orecchie sul vassoio doppio</translation>
    </message>
    <message>
        <source>The left ear on seat L, the right one on seat R, the arrow at the table&apos;s zero: one run measures both for their orders</source>
        <translation>Orecchio sinistro sulla sede L, destro sulla sede R, freccia sullo zero della tavola: una sola corsa misura entrambi per i loro ordini</translation>
    </message>
</context>
<context>
    <name>SceneLink</name>
    <message>
        <source>{n} points</source>
        <translation>{n} punti</translation>
    </message>
    <message>
        <source>{n} triangles</source>
        <translation>{n} triangoli</translation>
    </message>
</context>
<context>
    <name>SceneView</name>
    <message>
        <source>grid {mm:.0f} mm</source>
        <translation>griglia {mm:.0f} mm</translation>
    </message>
</context>
<context>
    <name>SettingsPage</name>
    <message>
        <source>As the system</source>
        <translation>Come il sistema</translation>
    </message>
    <message>
        <source>As the system ({language})</source>
        <translation>Come il sistema ({language})</translation>
    </message>
    <message>
        <source>At the end of a view, with the beam as slow as it needs to be; it costs some seconds.</source>
        <translation>A fine vista, col raggio lento quanto serve; costa qualche secondo.</translation>
    </message>
    <message>
        <source>Cases</source>
        <translation>Casi</translation>
    </message>
    <message>
        <source>Choose a folder</source>
        <translation>Scelta di una cartella</translation>
    </message>
    <message>
        <source>Choose the folder: {name}</source>
        <translation>Scegli la cartella: {name}</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Scegli…</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Scuro</translation>
    </message>
    <message>
        <source>Deliveries</source>
        <translation>Consegne</translation>
    </message>
    <message>
        <source>Everything on this page as on the first day; Ctrl+Z takes it back.</source>
        <translation>Tutto in questa pagina come il primo giorno; Ctrl+Z lo annulla.</translation>
    </message>
    <message>
        <source>File names</source>
        <translation>Nomi dei file</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>File</translation>
    </message>
    <message>
        <source>Folder of the log</source>
        <translation>Cartella del registro</translation>
    </message>
    <message>
        <source>Folder: {name}</source>
        <translation>Cartella: {name}</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Lingua</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Chiaro</translation>
    </message>
    <message>
        <source>Live surface</source>
        <translation>Superficie dal vivo</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Registro</translation>
    </message>
    <message>
        <source>Looks</source>
        <translation>Aspetto</translation>
    </message>
    <message>
        <source>Measure weak places again by itself</source>
        <translation>Rimisura da sé le zone deboli</translation>
    </message>
    <message>
        <source>Of everything in the window, from the next start on.</source>
        <translation>Di tutto nella finestra, dal prossimo avvio.</translation>
    </message>
    <message>
        <source>Off leaves a slow computer more time for the points.</source>
        <translation>Disattivata lascia più tempo per i punti a un computer lento.</translation>
    </message>
    <message>
        <source>Open the folder</source>
        <translation>Apri la cartella</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programma</translation>
    </message>
    <message>
        <source>Reset to defaults</source>
        <translation>Ripristina predefiniti</translation>
    </message>
    <message>
        <source>Scanning</source>
        <translation>Scansione</translation>
    </message>
    <message>
        <source>Second try</source>
        <translation>Secondo tentativo</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Impostazioni</translation>
    </message>
    <message>
        <source>Show the surface while it is scanned</source>
        <translation>Mostra la superficie durante la scansione</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Dimensione</translation>
    </message>
    <message>
        <source>The log holds no patients and no orders. A support bundle (Help) packs it with what else helps.</source>
        <translation>Il registro non contiene pazienti né ordini. Il pacchetto di assistenza (Aiuto) lo unisce ad altro di utile.</translation>
    </message>
    <message>
        <source>The window changes its language when the scan or the reconstruction has ended and the program starts again.</source>
        <translation>La lingua cambia quando la scansione o la ricostruzione è finita e il programma riparte.</translation>
    </message>
    <message>
        <source>The window is made anew in it; the open case stays.</source>
        <translation>La finestra viene ricreata in questa lingua; il caso aperto resta.</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Tema</translation>
    </message>
    <message>
        <source>Without it a file that leaves the house tells the order, the side and the day, and no patient.</source>
        <translation>Senza, un file che esce dal laboratorio dice ordine, lato e giorno, e nessun paziente.</translation>
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
        <translation>Chiudi</translation>
    </message>
    <message>
        <source>Copy as text</source>
        <translation>Copia come testo</translation>
    </message>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>Scorciatoie da tastiera</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasti</translation>
    </message>
    <message>
        <source>No shortcut fits.</source>
        <translation>Nessuna scorciatoia trovata.</translation>
    </message>
    <message>
        <source>Search the shortcuts</source>
        <translation>Cerca nelle scorciatoie</translation>
    </message>
    <message>
        <source>Search: a word, or a key</source>
        <translation>Cerca: una parola o un tasto</translation>
    </message>
    <message>
        <source>What it does</source>
        <translation>Che cosa fa</translation>
    </message>
</context>
<context>
    <name>SizeHistogram</name>
    <message>
        <source>Drag a limit, or choose it with up and down and move it with left and right</source>
        <translation>Trascinare un limite, o sceglierlo con su e giù e muoverlo con sinistra e destra</translation>
    </message>
    <message>
        <source>Live shows how large spots are</source>
        <translation>«Dal vivo» mostra i punti</translation>
    </message>
    <message>
        <source>Size of a spot: {low} to {high} pixels, {chosen}</source>
        <translation>Dimensione di un punto: da {low} a {high} pixel, {chosen}</translation>
    </message>
    <message>
        <source>largest size chosen</source>
        <translation>scelta la dimensione massima</translation>
    </message>
    <message>
        <source>smallest size chosen</source>
        <translation>scelta la dimensione minima</translation>
    </message>
</context>
<context>
    <name>Sparkline</name>
    <message>
        <source>Size deviation of the last tests in µm: {values}</source>
        <translation>Scarto di misura delle ultime prove in µm: {values}</translation>
    </message>
</context>
<context>
    <name>SphereResultPanel</name>
    <message>
        <source>Save certificate…</source>
        <translation>Salva certificato…</translation>
    </message>
    <message>
        <source>Saved: {path}</source>
        <translation>Salvato: {path}</translation>
    </message>
    <message>
        <source>To the calibration</source>
        <translation>Alla calibrazione</translation>
    </message>
    <message>
        <source>Writing the certificate…</source>
        <translation>Scrittura del certificato…</translation>
    </message>
    <message>
        <source>µm size deviation, U = {uncertainty} µm (k = 2)</source>
        <translation>µm scarto di misura, U = {uncertainty} µm (k = 2)</translation>
    </message>
</context>
<context>
    <name>Stage</name>
    <message>
        <source>Preparing the 3D view…</source>
        <translation>Preparazione della vista 3D…</translation>
    </message>
</context>
<context>
    <name>StatusLine</name>
    <message>
        <source>Calibration</source>
        <translation>Calibrazione</translation>
    </message>
    <message>
        <source>Calibration expired</source>
        <translation>Calibrazione scaduta</translation>
    </message>
    <message>
        <source>Calibration {age}</source>
        <translation>Calibrazione: {age}</translation>
    </message>
    <message>
        <source>Camera left not available</source>
        <translation>Telecamera sinistra non disponibile</translation>
    </message>
    <message>
        <source>Camera right not available</source>
        <translation>Telecamera destra non disponibile</translation>
    </message>
    <message>
        <source>Cameras not open</source>
        <translation>Telecamere non aperte</translation>
    </message>
    <message>
        <source>Cameras opening</source>
        <translation>Apertura telecamere</translation>
    </message>
    <message>
        <source>Cameras ready</source>
        <translation>Telecamere pronte</translation>
    </message>
    <message>
        <source>Controller not available</source>
        <translation>Controllore non disponibile</translation>
    </message>
    <message>
        <source>Not calibrated</source>
        <translation>Non calibrato</translation>
    </message>
    <message>
        <source>Open the order that is being reconstructed</source>
        <translation>Apre l&apos;ordine in ricostruzione</translation>
    </message>
    <message>
        <source>The rig file cannot be used</source>
        <translation>Il file del banco non è utilizzabile</translation>
    </message>
    <message>
        <source>Turntable</source>
        <translation>Tavola rotante</translation>
    </message>
    <message>
        <source>Turntable {angle}°</source>
        <translation>Tavola rotante {angle}°</translation>
    </message>
    <message>
        <source>Virtual rig  ·  {rig}</source>
        <translation>Banco virtuale  ·  {rig}</translation>
    </message>
    <message>
        <source>Virtual rig  ·  {rig}  ·  {speed}</source>
        <translation>Banco virtuale  ·  {rig}  ·  {speed}</translation>
    </message>
    <message>
        <source>full speed</source>
        <translation>piena velocità</translation>
    </message>
</context>
<context>
    <name>SupportDialog</name>
    <message>
        <source>&amp;Save…</source>
        <translation>&amp;Salva…</translation>
    </message>
    <message>
        <source>Archives (*.zip)</source>
        <translation>Archivi (*.zip)</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Chiudi</translation>
    </message>
    <message>
        <source>Collect &amp;again</source>
        <translation>Raccogli di &amp;nuovo</translation>
    </message>
    <message>
        <source>Collecting…</source>
        <translation>Raccolta…</translation>
    </message>
    <message>
        <source>Entries; those with a tick are saved</source>
        <translation>Voci; si salvano quelle spuntate</translation>
    </message>
    <message>
        <source>One file for whoever helps you. Orders, patients, file names, the user and this machine are replaced, as marked in the text. Nothing leaves this machine by itself: you save the file and send it.</source>
        <translation>Un solo file per chi vi assiste. Ordini, pazienti, nomi di file, utente e computer sono sostituiti, come segnato nel testo. Niente lascia da sé questo computer: il file si salva e si invia a mano.</translation>
    </message>
    <message>
        <source>Save the support bundle</source>
        <translation>Salva il pacchetto di assistenza</translation>
    </message>
    <message>
        <source>Saved as {path}.</source>
        <translation>Salvato come {path}.</translation>
    </message>
    <message>
        <source>Support bundle</source>
        <translation>Pacchetto di assistenza</translation>
    </message>
    <message>
        <source>{size} in {n} entries. Replaced: {taken}.</source>
        <translation>{size} in {n} voci. Sostituiti: {taken}.</translation>
    </message>
</context>
<context>
    <name>SupportPreview</name>
    <message>
        <source>(Only the first part is shown; the file holds all.)</source>
        <translation>(Si mostra solo la prima parte; il file contiene tutto.)</translation>
    </message>
    <message>
        <source>(Only the last part is shown; the file holds all.)</source>
        <translation>(Si mostra solo l&apos;ultima parte; il file contiene tutto.)</translation>
    </message>
    <message>
        <source>Content of the entry</source>
        <translation>Contenuto della voce</translation>
    </message>
</context>
<context>
    <name>SurfaceCard</name>
    <message>
        <source>Cancel</source>
        <translation>Annulla</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Scegli…</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Data</translation>
    </message>
    <message>
        <source>Reading {name}…</source>
        <translation>Lettura di {name}…</translation>
    </message>
    <message>
        <source>Replace…</source>
        <translation>Sostituisci…</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Dimensioni</translation>
    </message>
    <message>
        <source>Take this surface out</source>
        <translation>Togli questa superficie</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Triangoli</translation>
    </message>
    <message>
        <source>Unit of the file</source>
        <translation>Unità del file</translation>
    </message>
    <message>
        <source>as you said</source>
        <translation>come indicato</translation>
    </message>
    <message>
        <source>centimetres</source>
        <translation>centimetri</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>pollici</translation>
    </message>
    <message>
        <source>metres</source>
        <translation>metri</translation>
    </message>
    <message>
        <source>millimetres</source>
        <translation>millimetri</translation>
    </message>
    <message>
        <source>none yet</source>
        <translation>ancora nessuna</translation>
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
        <translation>Dopo</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Prima</translation>
    </message>
    <message>
        <source>Kept in the open case</source>
        <translation>Conservati nel caso aperto</translation>
    </message>
    <message>
        <source>Nothing of a file is repaired: what is noticed about it is said here.</source>
        <translation>Niente di un file viene riparato: ciò che vi si nota è detto qui.</translation>
    </message>
    <message>
        <source>Swap before and after</source>
        <translation>Scambia prima e dopo</translation>
    </message>
    <message>
        <source>not reliable</source>
        <translation>non affidabile</translation>
    </message>
    <message>
        <source>reliable</source>
        <translation>affidabile</translation>
    </message>
    <message>
        <source>{day}: with {before}, 1 area, {verdict}</source>
        <translation>{day}: con {before}, 1 area, {verdict}</translation>
    </message>
    <message>
        <source>{day}: with {before}, {n} areas, {verdict}</source>
        <translation>{day}: con {before}, {n} aree, {verdict}</translation>
    </message>
    <message>
        <source>{line}; of an earlier surface</source>
        <translation>{line}; di una superficie precedente</translation>
    </message>
</context>
<context>
    <name>Thumbnail</name>
    <message>
        <source>no picture</source>
        <translation>senza immagine</translation>
    </message>
</context>
<context>
    <name>TourCard</name>
    <message>
        <source>Back</source>
        <translation>Indietro</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fine</translation>
    </message>
    <message>
        <source>End the tour</source>
        <translation>Termina la visita</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Avanti</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>Visita guidata</translation>
    </message>
    <message>
        <source>{n} of {all}</source>
        <translation>{n} di {all}</translation>
    </message>
</context>
<context>
    <name>TranscriptWindow</name>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Copia</translation>
    </message>
    <message>
        <source>&amp;Leave out the questions for the status</source>
        <translation>&amp;Ometti le richieste di stato</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Chiudi</translation>
    </message>
    <message>
        <source>Lines to (&gt;) and from (&lt;) the controller</source>
        <translation>Righe verso (&gt;) e da (&lt;) il controllore</translation>
    </message>
    <message>
        <source>Port {port}. Nothing has been said yet.</source>
        <translation>Porta {port}. Ancora nessuno scambio.</translation>
    </message>
    <message>
        <source>Port {port}. Seconds since the start, &gt; to the controller, &lt; from it.</source>
        <translation>Porta {port}. Secondi dall&apos;avvio, &gt; verso il controllore, &lt; da esso.</translation>
    </message>
    <message>
        <source>Transcript of the controller</source>
        <translation>Trascrizione del controllore</translation>
    </message>
</context>
<context>
    <name>Verdict</name>
    <message>
        <source>And {n} more, under Surfaces and Alignment.</source>
        <translation>E altre {n}, in Superfici e Allineamento.</translation>
    </message>
    <message>
        <source>Held fixed: {frame} ({share} %).</source>
        <translation>Tenuto fermo: {frame} ({share} %).</translation>
    </message>
    <message>
        <source>Not reliable</source>
        <translation>Non affidabile</translation>
    </message>
    <message>
        <source>Out of date</source>
        <translation>Superato</translation>
    </message>
    <message>
        <source>Reliable</source>
        <translation>Affidabile</translation>
    </message>
    <message>
        <source>Remarks, under Surfaces and Alignment: {n}</source>
        <translation>Osservazioni, in Superfici e Allineamento: {n}</translation>
    </message>
    <message>
        <source>What is shown was computed before the last change.</source>
        <translation>Ciò che si vede è stato calcolato prima dell&apos;ultima modifica.</translation>
    </message>
</context>
<context>
    <name>VerifyPage</name>
    <message>
        <source>% done</source>
        <translation>% fatto</translation>
    </message>
    <message>
        <source>1.  Take away what stands on the table.</source>
        <translation>1.  Togliere ciò che sta sulla tavola.</translation>
    </message>
    <message>
        <source>2.  Put the reference sphere into the middle of the table, clean and alone.</source>
        <translation>2.  Mettere la sfera di riferimento al centro della tavola, pulita e sola.</translation>
    </message>
    <message>
        <source>3.  Close the lid.</source>
        <translation>3.  Chiudere il coperchio.</translation>
    </message>
    <message>
        <source>A scan is running: wait for its end or stop it first (Esc).</source>
        <translation>Scansione in corso: attendere la fine o prima fermare (Esc).</translation>
    </message>
    <message>
        <source>A sphere of certified size tells whether the rig still measures right. It takes about a minute; nothing is scanned meanwhile.</source>
        <translation>Una sfera di misura certificata dice se il banco misura ancora bene. Serve circa un minuto; intanto non si scansiona.</translation>
    </message>
    <message>
        <source>Back to the rig</source>
        <translation>Torna al banco</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annulla</translation>
    </message>
    <message>
        <source>Cancelled: nothing was kept, and the laser is off.</source>
        <translation>Annullata: niente è stato conservato, e il laser è spento.</translation>
    </message>
    <message>
        <source>Cancelling…</source>
        <translation>Annullamento…</translation>
    </message>
    <message>
        <source>Certified diameter</source>
        <translation>Diametro certificato</translation>
    </message>
    <message>
        <source>Diameter {diameter} mm, U = {uncertainty} µm: the sphere of the virtual rig.</source>
        <translation>Diametro {diameter} mm, U = {uncertainty} µm: la sfera del banco virtuale.</translation>
    </message>
    <message>
        <source>Enter the diameter from the sphere&apos;s certificate.</source>
        <translation>Inserire il diametro dal certificato della sfera.</translation>
    </message>
    <message>
        <source>From its certificate</source>
        <translation>Dal suo certificato</translation>
    </message>
    <message>
        <source>Its uncertainty U (k = 2)</source>
        <translation>La sua incertezza U (k = 2)</translation>
    </message>
    <message>
        <source>Keep your hands off and the lid closed. Esc switches the laser off at once.</source>
        <translation>Tenere lontane le mani e chiuso il coperchio. Esc spegne subito il laser.</translation>
    </message>
    <message>
        <source>Measure again</source>
        <translation>Misura di nuovo</translation>
    </message>
    <message>
        <source>Measure the sphere</source>
        <translation>Misura la sfera</translation>
    </message>
    <message>
        <source>Measuring the reference sphere</source>
        <translation>Misura della sfera di riferimento</translation>
    </message>
    <message>
        <source>Progress of the measurement</source>
        <translation>Avanzamento della misura</translation>
    </message>
    <message>
        <source>Reference sphere</source>
        <translation>Sfera di riferimento</translation>
    </message>
    <message>
        <source>Save the certificate</source>
        <translation>Salva il certificato</translation>
    </message>
    <message>
        <source>The rig is not open: the Rig page says why.</source>
        <translation>Il banco non è aperto: la pagina Banco dice perché.</translation>
    </message>
    <message>
        <source>The virtual rig puts its sphere on the table by itself, and afterwards puts back what stood there. Nothing has to be done.</source>
        <translation>Il banco virtuale mette da sé la sfera sulla tavola, e poi rimette ciò che c&apos;era. Non c&apos;è niente da fare.</translation>
    </message>
    <message>
        <source>The whole test measures the sphere ten times and belongs to an acceptance: impronta verify sphere</source>
        <translation>La prova intera misura la sfera dieci volte ed è parte di un collaudo: impronta verify sphere</translation>
    </message>
    <message>
        <source>This rig is not calibrated: calibrate it first.</source>
        <translation>Banco non calibrato: prima calibrarlo.</translation>
    </message>
    <message>
        <source>not entered</source>
        <translation>non inserito</translation>
    </message>
    <message>
        <source>{left} left</source>
        <translation>ancora {left}</translation>
    </message>
</context>
<context>
    <name>WedgeField</name>
    <message>
        <source>Order number, by barcode or keys</source>
        <translation>Numero d&apos;ordine, da codice a barre o tastiera</translation>
    </message>
    <message>
        <source>Scan or type an order number</source>
        <translation>Leggere o digitare un numero d&apos;ordine</translation>
    </message>
</context>
<context>
    <name>WindowHelp</name>
    <message>
        <source>At the end stands a file for the next machine, with its checks in plain words.</source>
        <translation>Alla fine c&apos;è un file per la macchina successiva, con le verifiche in parole semplici.</translation>
    </message>
    <message>
        <source>Checked, then delivered</source>
        <translation>Verificato, poi consegnato</translation>
    </message>
    <message>
        <source>Esc does the same on every page. It is filled with red while the laser is on.</source>
        <translation>Esc fa lo stesso in ogni pagina. È rosso finché il laser è acceso.</translation>
    </message>
    <message>
        <source>Every order passes these steps. Ctrl and a number opens each.</source>
        <translation>Ogni ordine passa questi passi. Ctrl e un numero apre ciascuno.</translation>
    </message>
    <message>
        <source>F1 explains the page and the control in hand, ? lists all keys, and Ctrl+Z takes back what you did.</source>
        <translation>F1 spiega la pagina e il controllo attivo, ? elenca tutti i tasti, e Ctrl+Z annulla l&apos;ultima azione.</translation>
    </message>
    <message>
        <source>Help is at hand</source>
        <translation>L&apos;aiuto è a portata di mano</translation>
    </message>
    <message>
        <source>One button is next</source>
        <translation>Un pulsante indica il prossimo passo</translation>
    </message>
    <message>
        <source>Points and surface grow before you. Pause is safe: the laser goes dark and nothing is lost.</source>
        <translation>Punti e superficie crescono sotto gli occhi. La pausa è sicura: il laser si spegne e niente va perso.</translation>
    </message>
    <message>
        <source>Scanning runs by itself</source>
        <translation>La scansione procede da sé</translation>
    </message>
    <message>
        <source>Stop, from everywhere</source>
        <translation>Fermare, da ovunque</translation>
    </message>
    <message>
        <source>The filled button is what to do now. A demo order stands here already: press it and watch.</source>
        <translation>Il pulsante pieno è ciò che va fatto ora. C&apos;è già un ordine demo: premere e osservare.</translation>
    </message>
    <message>
        <source>The work goes from the top down</source>
        <translation>Il lavoro va dall&apos;alto in basso</translation>
    </message>
</context>
<context>
    <name>WriteStep</name>
    <message>
        <source>File</source>
        <translation>File</translation>
    </message>
    <message>
        <source>Limits, the laser&apos;s place and the volume are those of the shipped bench. Correct them for your mechanics before the first scan.</source>
        <translation>Limiti, posizione del laser e volume sono quelli del banco fornito. Correggerli per la propria meccanica prima della prima scansione.</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nome</translation>
    </message>
    <message>
        <source>Name of the rig</source>
        <translation>Nome del banco</translation>
    </message>
    <message>
        <source>Other file…</source>
        <translation>Altro file…</translation>
    </message>
    <message>
        <source>Replace it</source>
        <translation>Sostituisci</translation>
    </message>
    <message>
        <source>Rigs (*.toml)</source>
        <translation>Banchi (*.toml)</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Salva</translation>
    </message>
    <message>
        <source>The Rig page shows it, and calibrates it anew.</source>
        <translation>La pagina Banco lo mostra e lo ricalibra.</translation>
    </message>
    <message>
        <source>The rig cannot measure before it is calibrated: the Rig page prints the target and takes you through it.</source>
        <translation>Il banco non può misurare prima di essere calibrato: la pagina Banco stampa la scacchiera e guida nella calibrazione.</translation>
    </message>
    <message>
        <source>The rig&apos;s file</source>
        <translation>Il file del banco</translation>
    </message>
    <message>
        <source>There is a file of this name already. Press once more to replace it, or choose another name.</source>
        <translation>C&apos;è già un file con questo nome. Premere ancora per sostituirlo, o scegliere un altro nome.</translation>
    </message>
    <message>
        <source>Use this rig now</source>
        <translation>Usa ora questo banco</translation>
    </message>
    <message>
        <source>What will be written</source>
        <translation>Che cosa verrà scritto</translation>
    </message>
    <message>
        <source>Where to write the rig</source>
        <translation>Dove scrivere il banco</translation>
    </message>
    <message>
        <source>Written to {path}.</source>
        <translation>Scritto in {path}.</translation>
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
        <translation>Tanti triangoli quanti servono perché 95 faccette su 100 rispettino la tolleranza; prevale sul numero di triangoli.</translation>
    </message>
    <message>
        <source>Back to the defaults</source>
        <translation>Ripristina predefiniti</translation>
    </message>
    <message>
        <source>Density of the points, of that which they have among themselves, from which on the surface counts as measured. Default 45 %.</source>
        <translation>Densità dei punti, rispetto a quella che hanno fra loro, da cui la superficie vale come misurata. Predefinito 45 %.</translation>
    </message>
    <message>
        <source>Goes before the slider.</source>
        <translation>Prevale sul cursore.</translation>
    </message>
    <message>
        <source>Leave open what was not scanned</source>
        <translation>Lascia aperto il non scansionato</translation>
    </message>
    <message>
        <source>Of every random choice: the same points and seed give the same surface. Default 0.</source>
        <translation>Di ogni scelta casuale: stessi punti e stesso seme danno la stessa superficie. Predefinito 0.</translation>
    </message>
    <message>
        <source>Pass-band</source>
        <translation>Banda passante</translation>
    </message>
    <message>
        <source>Rounds of Taubin&apos;s filter in the last phase. Default 3; many of them inflate the surface.</source>
        <translation>Passate del filtro di Taubin nell&apos;ultima fase. Predefinito 3; molte gonfiano la superficie.</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Seme</translation>
    </message>
    <message>
        <source>Smoothing rounds</source>
        <translation>Passate di lisciatura</translation>
    </message>
    <message>
        <source>Support from</source>
        <translation>Sostegno da</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolleranza</translation>
    </message>
    <message>
        <source>Triangles, at most</source>
        <translation>Triangoli, al massimo</translation>
    </message>
    <message>
        <source>Waves longer than this share of the highest spatial frequency stay. Default 10 %.</source>
        <translation>Le onde più lunghe di questa quota della massima frequenza spaziale restano. Predefinito 10 %.</translation>
    </message>
    <message>
        <source>Without it the surface is closed, as printing needs it; what is bridged is marked as not scanned.</source>
        <translation>Senza, la superficie è chiusa, come serve per la stampa; ciò che è colmato è segnato come non scansionato.</translation>
    </message>
    <message>
        <source>by detail</source>
        <translation>da dettaglio</translation>
    </message>
    <message>
        <source>none</source>
        <translation>nessuna</translation>
    </message>
</context>
<context>
    <name>_Facts</name>
    <message>
        <source>Closed</source>
        <translation>Chiusa</translation>
    </message>
    <message>
        <source>Noise of the points</source>
        <translation>Rumore dei punti</translation>
    </message>
    <message>
        <source>Outliers rejected</source>
        <translation>Anomali scartati</translation>
    </message>
    <message>
        <source>Points to surface</source>
        <translation>Da punti a superficie</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>no</source>
        <translation>no</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>sì</translation>
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
        <translation>{order}: non ricostruire</translation>
    </message>
    <message>
        <source>{order}: one place forward</source>
        <translation>{order}: un posto avanti</translation>
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
        <translation>&amp;Informazioni su Impronta</translation>
    </message>
    <message>
        <source>&amp;Case</source>
        <translation>&amp;Caso</translation>
    </message>
    <message>
        <source>&amp;Colours: the next</source>
        <translation>&amp;Colori: successivo</translation>
    </message>
    <message>
        <source>&amp;Complete</source>
        <translation>&amp;Completa</translation>
    </message>
    <message>
        <source>&amp;Deliver…</source>
        <translation>&amp;Consegna…</translation>
    </message>
    <message>
        <source>&amp;Edges</source>
        <translation>Sp&amp;igoli</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Modifica</translation>
    </message>
    <message>
        <source>&amp;Fill now</source>
        <translation>Completa &amp;ora</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>&amp;Adatta</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Aiuto</translation>
    </message>
    <message>
        <source>&amp;Help on this page</source>
        <translation>&amp;Aiuto su questa pagina</translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts</source>
        <translation>&amp;Scorciatoie da tastiera</translation>
    </message>
    <message>
        <source>&amp;New case</source>
        <translation>&amp;Nuovo caso</translation>
    </message>
    <message>
        <source>&amp;Open case…</source>
        <translation>&amp;Apri caso…</translation>
    </message>
    <message>
        <source>&amp;Pause or resume</source>
        <translation>&amp;Pausa o riprendi</translation>
    </message>
    <message>
        <source>&amp;Points</source>
        <translation>&amp;Punti</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Esci</translation>
    </message>
    <message>
        <source>&amp;Reconstruct</source>
        <translation>&amp;Ricostruisci</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Ripeti</translation>
    </message>
    <message>
        <source>&amp;Scan</source>
        <translation>&amp;Scansione</translation>
    </message>
    <message>
        <source>&amp;Start scan</source>
        <translation>&amp;Avvia scansione</translation>
    </message>
    <message>
        <source>&amp;Support bundle…</source>
        <translation>&amp;Pacchetto di assistenza…</translation>
    </message>
    <message>
        <source>&amp;Surface</source>
        <translation>&amp;Superficie</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>Dall&apos;al&amp;to</translation>
    </message>
    <message>
        <source>&amp;Tour</source>
        <translation>&amp;Visita guidata</translation>
    </message>
    <message>
        <source>&amp;Uncertainty</source>
        <translation>I&amp;ncertezza</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Annulla</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Vista</translation>
    </message>
    <message>
        <source>Another &amp;mount</source>
        <translation>Altro posiziona&amp;mento</translation>
    </message>
    <message>
        <source>F&amp;ront</source>
        <translation>&amp;Frontale</translation>
    </message>
    <message>
        <source>Scan &amp;this mount</source>
        <translation>Scansiona &amp;questo posizionamento</translation>
    </message>
    <message>
        <source>Set up a ri&amp;g…</source>
        <translation>Configura un &amp;banco…</translation>
    </message>
    <message>
        <source>Stop and &amp;laser off</source>
        <translation>Ferma e spegni &amp;laser</translation>
    </message>
</context>
<context>
    <name>activity</name>
    <message>
        <source>Bringing the mounts together</source>
        <translation>Unione dei posizionamenti</translation>
    </message>
    <message>
        <source>Calibrating</source>
        <translation>Calibrazione</translation>
    </message>
    <message>
        <source>Comparing</source>
        <translation>Confronto</translation>
    </message>
    <message>
        <source>Computing the points anew…</source>
        <translation>Ricalcolo dei punti…</translation>
    </message>
    <message>
        <source>Looking for what is missing</source>
        <translation>Ricerca di ciò che manca</translation>
    </message>
    <message>
        <source>Measuring the reference sphere</source>
        <translation>Misura della sfera di riferimento</translation>
    </message>
    <message>
        <source>Opening the case…</source>
        <translation>Apertura del caso…</translation>
    </message>
    <message>
        <source>Scan paused</source>
        <translation>Scansione in pausa</translation>
    </message>
    <message>
        <source>Scanning</source>
        <translation>Scansione</translation>
    </message>
    <message>
        <source>Setting up a rig</source>
        <translation>Configurazione di un banco</translation>
    </message>
</context>
<context>
    <name>aim</name>
    <message>
        <source>As it was set on the Aim page.</source>
        <translation>Come impostato nella pagina Puntamento.</translation>
    </message>
    <message>
        <source>As the rig file says</source>
        <translation>Come dice il file del banco</translation>
    </message>
    <message>
        <source>Automatic exposure</source>
        <translation>Esposizione automatica</translation>
    </message>
    <message>
        <source>Both cameras saw too few spots to learn from: bring the spot to a place that both see.</source>
        <translation>Troppo pochi punti visti dalle due telecamere per imparare: portare il punto dove lo vedono entrambe.</translation>
    </message>
    <message>
        <source>Both cameras see the spot.</source>
        <translation>Entrambe le telecamere vedono il punto.</translation>
    </message>
    <message>
        <source>Bringing the spot there…</source>
        <translation>Spostamento del punto…</translation>
    </message>
    <message>
        <source>Change limits of the spot&apos;s size</source>
        <translation>Modifica limiti della dimensione</translation>
    </message>
    <message>
        <source>Choose material</source>
        <translation>Scelta del materiale</translation>
    </message>
    <message>
        <source>Finding the exposure…</source>
        <translation>Ricerca dell&apos;esposizione…</translation>
    </message>
    <message>
        <source>Learn the spot&apos;s size</source>
        <translation>Apprendimento della dimensione</translation>
    </message>
    <message>
        <source>Learned from {spots} spots; {strays} reflections were seen beside them.</source>
        <translation>Imparato da {spots} punti; accanto si sono visti {strays} riflessi.</translation>
    </message>
    <message>
        <source>Learning: the beam moves a little…</source>
        <translation>Apprendimento: il raggio si muove un poco…</translation>
    </message>
    <message>
        <source>Live lights the laser and shows what the cameras make of its spot.</source>
        <translation>«Dal vivo» accende il laser e mostra come le telecamere vedono il punto.</translation>
    </message>
    <message>
        <source>Looking for the object…</source>
        <translation>Ricerca dell&apos;oggetto…</translation>
    </message>
    <message>
        <source>Moving…</source>
        <translation>Movimento…</translation>
    </message>
    <message>
        <source>No point here: {reason}.</source>
        <translation>Qui nessun punto: {reason}.</translation>
    </message>
    <message>
        <source>The background is too bright: switch off the lamp or close the lid.</source>
        <translation>Lo sfondo è troppo chiaro: spegnere la lampada o chiudere il coperchio.</translation>
    </message>
    <message>
        <source>The rig is not calibrated: each camera is judged alone.</source>
        <translation>Il banco non è calibrato: ogni telecamera è giudicata da sola.</translation>
    </message>
    <message>
        <source>Too bright even at the shortest exposure: close the apertures.</source>
        <translation>Troppa luce anche con l&apos;esposizione più breve: chiudere i diaframmi.</translation>
    </message>
    <message>
        <source>Too dark even at the longest exposure: look at the laser and the lens caps, or open the apertures.</source>
        <translation>Troppo buio anche con l&apos;esposizione più lunga: controllare il laser e i tappi degli obiettivi, o aprire i diaframmi.</translation>
    </message>
    <message>
        <source>{left} and {right}</source>
        <translation>{left} e {right}</translation>
    </message>
    <message>
        <source>{material}: {exposure} ms, {gain} dB, spots of {low} to {high} pixels</source>
        <translation>{material}: {exposure} ms, {gain} dB, punti da {low} a {high} pixel</translation>
    </message>
</context>
<context>
    <name>assistant</name>
    <message>
        <source>Camera left</source>
        <translation>Telecamera sinistra</translation>
    </message>
    <message>
        <source>Camera right</source>
        <translation>Telecamera destra</translation>
    </message>
    <message>
        <source>Correct the steps of beam X: it moves {percent} % of what it is told.</source>
        <translation>Correggi i passi del raggio X: si muove del {percent} % del comando.</translation>
    </message>
    <message>
        <source>Correct the steps of beam Y: it moves {percent} % of what it is told.</source>
        <translation>Correggi i passi del raggio Y: si muove del {percent} % del comando.</translation>
    </message>
    <message>
        <source>Correct the steps of the table: it turns {percent} % of what it is told.</source>
        <translation>Correggi i passi della tavola: gira del {percent} % del comando.</translation>
    </message>
    <message>
        <source>Exchange the cameras: the one that is called left stands to the right of the other.</source>
        <translation>Scambia le telecamere: quella detta sinistra sta a destra dell&apos;altra.</translation>
    </message>
    <message>
        <source>Expose both cameras for {ms} ms (left {left} dB, right {right} dB): it suits what stands there.</source>
        <translation>Esponi entrambe le telecamere per {ms} ms (sinistra {left} dB, destra {right} dB): adatto a ciò che c&apos;è.</translation>
    </message>
    <message>
        <source>Free: each by its own clock</source>
        <translation>Libero: ognuna col suo orologio</translation>
    </message>
    <message>
        <source>GRBL board, set up for something else</source>
        <translation>Scheda GRBL, configurata per altro</translation>
    </message>
    <message>
        <source>Hardware: a cable to both</source>
        <translation>Hardware: un cavo a entrambe</translation>
    </message>
    <message>
        <source>Left, difference</source>
        <translation>Sinistra, differenza</translation>
    </message>
    <message>
        <source>Left, first end</source>
        <translation>Sinistra, primo capo</translation>
    </message>
    <message>
        <source>Left, laser off</source>
        <translation>Sinistra, laser spento</translation>
    </message>
    <message>
        <source>Left, laser on</source>
        <translation>Sinistra, laser acceso</translation>
    </message>
    <message>
        <source>Left, other end</source>
        <translation>Sinistra, altro capo</translation>
    </message>
    <message>
        <source>Right, difference</source>
        <translation>Destra, differenza</translation>
    </message>
    <message>
        <source>Right, first end</source>
        <translation>Destra, primo capo</translation>
    </message>
    <message>
        <source>Right, laser off</source>
        <translation>Destra, laser spento</translation>
    </message>
    <message>
        <source>Right, laser on</source>
        <translation>Destra, laser acceso</translation>
    </message>
    <message>
        <source>Right, other end</source>
        <translation>Destra, altro capo</translation>
    </message>
    <message>
        <source>Software: a command for every picture</source>
        <translation>Software: un comando per ogni immagine</translation>
    </message>
    <message>
        <source>Turn the direction of beam X round: it moves the spot the other way.</source>
        <translation>Inverti la direzione del raggio X: muove il punto al contrario.</translation>
    </message>
    <message>
        <source>Turn the direction of beam Y round: it moves the spot the other way.</source>
        <translation>Inverti la direzione del raggio Y: muove il punto al contrario.</translation>
    </message>
    <message>
        <source>Turn the direction of the table round: it turns the other way.</source>
        <translation>Inverti la direzione della tavola: gira al contrario.</translation>
    </message>
    <message>
        <source>Virtual camera, left</source>
        <translation>Telecamera virtuale, sinistra</translation>
    </message>
    <message>
        <source>Virtual camera, right</source>
        <translation>Telecamera virtuale, destra</translation>
    </message>
    <message>
        <source>black picture</source>
        <translation>immagine nera</translation>
    </message>
    <message>
        <source>cannot be opened</source>
        <translation>non si apre</translation>
    </message>
    <message>
        <source>controller</source>
        <translation>controllore</translation>
    </message>
    <message>
        <source>does not work</source>
        <translation>non funziona</translation>
    </message>
    <message>
        <source>good</source>
        <translation>buono</translation>
    </message>
    <message>
        <source>look at this</source>
        <translation>da guardare</translation>
    </message>
    <message>
        <source>no picture</source>
        <translation>nessuna immagine</translation>
    </message>
    <message>
        <source>not permitted</source>
        <translation>non permesso</translation>
    </message>
    <message>
        <source>ready</source>
        <translation>pronto</translation>
    </message>
    <message>
        <source>silent</source>
        <translation>muto</translation>
    </message>
    <message>
        <source>something else</source>
        <translation>qualcos&apos;altro</translation>
    </message>
    <message>
        <source>used by another program</source>
        <translation>usato da un altro programma</translation>
    </message>
    <message>
        <source>wrong format</source>
        <translation>formato errato</translation>
    </message>
    <message>
        <source>{width} × {height} px, {rate} frames/s</source>
        <translation>{width} × {height} px, {rate} immagini/s</translation>
    </message>
</context>
<context>
    <name>board</name>
    <message>
        <source>Angle {n} of {count}</source>
        <translation>Angolo {n} di {count}</translation>
    </message>
    <message>
        <source>Angle {n} taken. The table turns: hands off.</source>
        <translation>Angolo {n} preso. La tavola gira: via le mani.</translation>
    </message>
    <message>
        <source>Bar {n} taken. Now hold it another way.</source>
        <translation>Barra {n} presa. Ora tenerla in altro modo.</translation>
    </message>
    <message>
        <source>Blurred</source>
        <translation>Sfocata</translation>
    </message>
    <message>
        <source>Both cameras see the board, but not the same part of it.</source>
        <translation>Entrambe le telecamere vedono la scacchiera, ma non la stessa parte.</translation>
    </message>
    <message>
        <source>Both of its ends in sight of both cameras.</source>
        <translation>I due capi in vista a entrambe le telecamere.</translation>
    </message>
    <message>
        <source>Bring the board nearer and farther</source>
        <translation>Portare la scacchiera più vicino e più lontano</translation>
    </message>
    <message>
        <source>Bring the board to the left of the {camera} picture</source>
        <translation>Portare la scacchiera a sinistra nell&apos;immagine {camera}</translation>
    </message>
    <message>
        <source>Bring the board to the lower left of the {camera} picture</source>
        <translation>Portare la scacchiera in basso a sinistra nell&apos;immagine {camera}</translation>
    </message>
    <message>
        <source>Bring the board to the lower middle of the {camera} picture</source>
        <translation>Portare la scacchiera in basso al centro nell&apos;immagine {camera}</translation>
    </message>
    <message>
        <source>Bring the board to the lower right of the {camera} picture</source>
        <translation>Portare la scacchiera in basso a destra nell&apos;immagine {camera}</translation>
    </message>
    <message>
        <source>Bring the board to the middle of the {camera} picture</source>
        <translation>Portare la scacchiera al centro dell&apos;immagine {camera}</translation>
    </message>
    <message>
        <source>Bring the board to the right of the {camera} picture</source>
        <translation>Portare la scacchiera a destra nell&apos;immagine {camera}</translation>
    </message>
    <message>
        <source>Bring the board to the upper left of the {camera} picture</source>
        <translation>Portare la scacchiera in alto a sinistra nell&apos;immagine {camera}</translation>
    </message>
    <message>
        <source>Bring the board to the upper middle of the {camera} picture</source>
        <translation>Portare la scacchiera in alto al centro nell&apos;immagine {camera}</translation>
    </message>
    <message>
        <source>Bring the board to the upper right of the {camera} picture</source>
        <translation>Portare la scacchiera in alto a destra nell&apos;immagine {camera}</translation>
    </message>
    <message>
        <source>Computing cameras and lenses from all views.</source>
        <translation>Calcolo di telecamere e obiettivi da tutte le viste.</translation>
    </message>
    <message>
        <source>Computing the scale from the length bar.</source>
        <translation>Calcolo della scala dalla barra campione.</translation>
    </message>
    <message>
        <source>Computing the table&apos;s axis and the uncertainty.</source>
        <translation>Calcolo dell&apos;asse della tavola e dell&apos;incertezza.</translation>
    </message>
    <message>
        <source>Cut by the picture&apos;s edge</source>
        <translation>Tagliata dal bordo dell&apos;immagine</translation>
    </message>
    <message>
        <source>Each time at another place and tilted another way; hold it still until it is taken.</source>
        <translation>Ogni volta in un altro punto e con altra inclinazione; tenerla ferma finché è presa.</translation>
    </message>
    <message>
        <source>Flat, face up, about the table&apos;s middle; then the table turns by itself.</source>
        <translation>In piano, faccia in su, attorno al centro della tavola; poi la tavola gira da sé.</translation>
    </message>
    <message>
        <source>Hold the bar still.</source>
        <translation>Tenere ferma la barra.</translation>
    </message>
    <message>
        <source>Hold the board into the volume</source>
        <translation>Tenere la scacchiera nel volume</translation>
    </message>
    <message>
        <source>Hold the board still.</source>
        <translation>Tenere ferma la scacchiera.</translation>
    </message>
    <message>
        <source>Hold the length bar into the volume</source>
        <translation>Tenere la barra campione nel volume</translation>
    </message>
    <message>
        <source>Lay the board on the table</source>
        <translation>Posare la scacchiera sulla tavola</translation>
    </message>
    <message>
        <source>Length bar {n} of {count}</source>
        <translation>Barra campione {n} di {count}</translation>
    </message>
    <message>
        <source>More angles of the table: {n}</source>
        <translation>Altri angoli della tavola: {n}</translation>
    </message>
    <message>
        <source>More views of the length bar: {n}</source>
        <translation>Altre viste della barra campione: {n}</translation>
    </message>
    <message>
        <source>More views: {n}</source>
        <translation>Altre viste: {n}</translation>
    </message>
    <message>
        <source>Neither camera sees the board.</source>
        <translation>Nessuna telecamera vede la scacchiera.</translation>
    </message>
    <message>
        <source>No board in sight</source>
        <translation>Nessuna scacchiera in vista</translation>
    </message>
    <message>
        <source>Only one camera sees the board.</source>
        <translation>Una sola telecamera vede la scacchiera.</translation>
    </message>
    <message>
        <source>Take your hands away.</source>
        <translation>Togliere le mani.</translation>
    </message>
    <message>
        <source>Tilt the board more, each time to another side</source>
        <translation>Inclinare di più la scacchiera, ogni volta da un altro lato</translation>
    </message>
    <message>
        <source>Too bright</source>
        <translation>Troppo chiara</translation>
    </message>
    <message>
        <source>Too dark</source>
        <translation>Troppo scura</translation>
    </message>
    <message>
        <source>Too little of the board in sight</source>
        <translation>Scacchiera troppo poco in vista</translation>
    </message>
    <message>
        <source>Too similar to an earlier view: move or tilt the board.</source>
        <translation>Troppo simile a una vista precedente: spostare o inclinare la scacchiera.</translation>
    </message>
    <message>
        <source>View taken.</source>
        <translation>Vista presa.</translation>
    </message>
    <message>
        <source>View {n} of {count}</source>
        <translation>Vista {n} di {count}</translation>
    </message>
    <message>
        <source>View {n} taken. Now tilt it another way.</source>
        <translation>Vista {n} presa. Ora inclinare in altro modo.</translation>
    </message>
    <message>
        <source>left camera&apos;s</source>
        <translation>sinistra</translation>
    </message>
    <message>
        <source>right camera&apos;s</source>
        <translation>destra</translation>
    </message>
    <message>
        <source>{n} corners</source>
        <translation>{n} angoli</translation>
    </message>
    <message>
        <source>{what} in the {camera} picture</source>
        <translation>{what} nell&apos;immagine {camera}</translation>
    </message>
</context>
<context>
    <name>calibration</name>
    <message>
        <source>Age unknown</source>
        <translation>Età ignota</translation>
    </message>
    <message>
        <source>Distance between the cameras</source>
        <translation>Distanza fra le telecamere</translation>
    </message>
    <message>
        <source>Expired {n} days ago</source>
        <translation>Scaduta da {n} giorni</translation>
    </message>
    <message>
        <source>Expires soon: {n} days left</source>
        <translation>Scade presto: ancora {n} giorni</translation>
    </message>
    <message>
        <source>Focal length, left and right</source>
        <translation>Distanza focale, sinistra e destra</translation>
    </message>
    <message>
        <source>Identity</source>
        <translation>Identità</translation>
    </message>
    <message>
        <source>Image centre, left</source>
        <translation>Centro immagine, sinistra</translation>
    </message>
    <message>
        <source>Image centre, right</source>
        <translation>Centro immagine, destra</translation>
    </message>
    <message>
        <source>Length bar where it took no part</source>
        <translation>Barra campione, se non usata</translation>
    </message>
    <message>
        <source>Measured shapes change by {rms} µm rms over the volume, {largest} µm at most</source>
        <translation>Le forme misurate cambiano di {rms} µm rms nel volume, al massimo {largest} µm</translation>
    </message>
    <message>
        <source>Reference sphere</source>
        <translation>Sfera di riferimento</translation>
    </message>
    <message>
        <source>Reprojection error</source>
        <translation>Errore di riproiezione</translation>
    </message>
    <message>
        <source>Right camera against the left, turned</source>
        <translation>Telecamera destra rispetto alla sinistra, ruotata</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Scala</translation>
    </message>
    <message>
        <source>Scale by a length measured on the print alone, to {ppm} ppm: no second length has verified it.</source>
        <translation>Scala da una lunghezza misurata sulla sola stampa, a {ppm} ppm: nessuna seconda lunghezza l&apos;ha verificata.</translation>
    </message>
    <message>
        <source>Scale not verified: no known length was shown, and the board&apos;s nominal size was believed ({ppm} ppm, k = 1).</source>
        <translation>Scala non verificata: nessuna lunghezza nota è stata mostrata, e si è creduto alla misura nominale della scacchiera ({ppm} ppm, k = 1).</translation>
    </message>
    <message>
        <source>The board is bent: its corners lie within {bend_mm} mm of height; this is taken into account.</source>
        <translation>La scacchiera è curva: i suoi angoli stanno entro {bend_mm} mm di altezza; se ne tiene conto.</translation>
    </message>
    <message>
        <source>The print is {percent} % larger than its nominal size; this is corrected.</source>
        <translation>La stampa è più grande del {percent} % della misura nominale; se ne tiene conto.</translation>
    </message>
    <message>
        <source>The print is {percent} % smaller than its nominal size; this is corrected.</source>
        <translation>La stampa è più piccola del {percent} % della misura nominale; se ne tiene conto.</translation>
    </message>
    <message>
        <source>The reference sphere measured {change} µm otherwise than in the tests before: calibrate and test it again.</source>
        <translation>La sfera di riferimento misurata differisce di {change} µm dalle prove precedenti: calibrare e riprovare.</translation>
    </message>
    <message>
        <source>The table stood {error_deg} degrees off its reported angle at {table_deg} degrees: backlash or lost steps.</source>
        <translation>La tavola stava a {error_deg} gradi dall&apos;angolo indicato, a {table_deg} gradi: gioco o passi persi.</translation>
    </message>
    <message>
        <source>This calibration is {n} days old and has expired: cameras creep. Calibrate before you measure.</source>
        <translation>Questa calibrazione ha {n} giorni ed è scaduta: le telecamere si assestano. Calibrare prima di misurare.</translation>
    </message>
    <message>
        <source>Turntable axis</source>
        <translation>Asse della tavola rotante</translation>
    </message>
    <message>
        <source>Turntable axis, turned</source>
        <translation>Asse della tavola rotante, ruotato</translation>
    </message>
    <message>
        <source>Valid: {n} days left</source>
        <translation>Valida: ancora {n} giorni</translation>
    </message>
    <message>
        <source>Views of the board</source>
        <translation>Viste della scacchiera</translation>
    </message>
    <message>
        <source>by the print alone, not verified</source>
        <translation>solo dalla stampa, non verificata</translation>
    </message>
    <message>
        <source>more than three standard uncertainties of {u} µm explain: something has moved.</source>
        <translation>più di quanto spieghino tre incertezze tipo di {u} µm: qualcosa si è mosso.</translation>
    </message>
    <message>
        <source>not verified</source>
        <translation>non verificata</translation>
    </message>
    <message>
        <source>radius error {size} µm, D95 {d95} µm, {date}</source>
        <translation>errore del raggio {size} µm, D95 {d95} µm, {date}</translation>
    </message>
    <message>
        <source>the previous one does not state its uncertainty.</source>
        <translation>la precedente non dichiara la sua incertezza.</translation>
    </message>
    <message>
        <source>verified by the {length} mm bar</source>
        <translation>con la barra da {length} mm</translation>
    </message>
    <message>
        <source>within three standard uncertainties of {u} µm each.</source>
        <translation>entro tre incertezze tipo di {u} µm ciascuna.</translation>
    </message>
</context>
<context>
    <name>checks</name>
    <message>
        <source>beam axes</source>
        <translation>assi del raggio</translation>
    </message>
    <message>
        <source>beam axis x</source>
        <translation>asse x del raggio</translation>
    </message>
    <message>
        <source>beam axis y</source>
        <translation>asse y del raggio</translation>
    </message>
    <message>
        <source>camera left</source>
        <translation>telecamera sinistra</translation>
    </message>
    <message>
        <source>camera right</source>
        <translation>telecamera destra</translation>
    </message>
    <message>
        <source>cameras</source>
        <translation>telecamere</translation>
    </message>
    <message>
        <source>controller</source>
        <translation>controllore</translation>
    </message>
    <message>
        <source>controller handshake</source>
        <translation>contatto col controllore</translation>
    </message>
    <message>
        <source>controller laser</source>
        <translation>laser del controllore</translation>
    </message>
    <message>
        <source>controller laser left off</source>
        <translation>laser lasciato spento dal controllore</translation>
    </message>
    <message>
        <source>controller move</source>
        <translation>moto del controllore</translation>
    </message>
    <message>
        <source>done</source>
        <translation>fatto</translation>
    </message>
    <message>
        <source>exposure</source>
        <translation>esposizione</translation>
    </message>
    <message>
        <source>frame rate</source>
        <translation>frequenza immagini</translation>
    </message>
    <message>
        <source>frame rate left</source>
        <translation>frequenza immagini sinistra</translation>
    </message>
    <message>
        <source>frame rate right</source>
        <translation>frequenza immagini destra</translation>
    </message>
    <message>
        <source>laser seen</source>
        <translation>laser visto</translation>
    </message>
    <message>
        <source>laser spot</source>
        <translation>punto laser</translation>
    </message>
    <message>
        <source>left and right</source>
        <translation>sinistra e destra</translation>
    </message>
    <message>
        <source>rest of the rig</source>
        <translation>resto del banco</translation>
    </message>
    <message>
        <source>table</source>
        <translation>tavola</translation>
    </message>
    <message>
        <source>trigger skew</source>
        <translation>ritardo di trigger</translation>
    </message>
</context>
<context>
    <name>comparison</name>
    <message>
        <source>95 % below {p} mm, on {a} mm²</source>
        <translation>95 % sotto {p} mm, su {a} mm²</translation>
    </message>
    <message>
        <source>Aligning</source>
        <translation>Allineamento</translation>
    </message>
    <message>
        <source>As they lie</source>
        <translation>Come stanno</translation>
    </message>
    <message>
        <source>Change threshold</source>
        <translation>Modifica soglia</translation>
    </message>
    <message>
        <source>Change unit</source>
        <translation>Modifica unità</translation>
    </message>
    <message>
        <source>Change what is held fixed</source>
        <translation>Modifica ciò che è tenuto fermo</translation>
    </message>
    <message>
        <source>Click the tooth in the picture: the mark grows to its edge, and its motion is told.</source>
        <translation>Clic sul dente nell&apos;immagine: il segno cresce fino al bordo e ne è detto il moto.</translation>
    </message>
    <message>
        <source>Correct the marked tooth</source>
        <translation>Correzione del dente segnato</translation>
    </message>
    <message>
        <source>Draw a line round what belongs to the tooth, too; only what is seen is added.</source>
        <translation>Tracciare una linea attorno a ciò che appartiene ancora al dente; si aggiunge solo ciò che si vede.</translation>
    </message>
    <message>
        <source>Draw a line round what does not belong to the tooth; only what is seen is taken off.</source>
        <translation>Tracciare una linea attorno a ciò che non appartiene al dente; si toglie solo ciò che si vede.</translation>
    </message>
    <message>
        <source>Erase from the stable region</source>
        <translation>Cancellazione dalla regione stabile</translation>
    </message>
    <message>
        <source>Finding the areas</source>
        <translation>Ricerca delle aree</translation>
    </message>
    <message>
        <source>Load the surface after</source>
        <translation>Caricamento della superficie dopo</translation>
    </message>
    <message>
        <source>Load the surface before</source>
        <translation>Caricamento della superficie prima</translation>
    </message>
    <message>
        <source>Looking for its edge…</source>
        <translation>Ricerca del bordo…</translation>
    </message>
    <message>
        <source>Lower</source>
        <translation>Inferiore</translation>
    </message>
    <message>
        <source>Mark a tooth</source>
        <translation>Segno su un dente</translation>
    </message>
    <message>
        <source>Measuring its motion…</source>
        <translation>Misura del suo moto…</translation>
    </message>
    <message>
        <source>Measuring the distances</source>
        <translation>Misura delle distanze</translation>
    </message>
    <message>
        <source>Paint as stable</source>
        <translation>Dipinto come stabile</translation>
    </message>
    <message>
        <source>Paint with the left button what did not move, then align on it.</source>
        <translation>Dipingere col pulsante sinistro ciò che non si è mosso, poi allineare su quello.</translation>
    </message>
    <message>
        <source>Painted region</source>
        <translation>Regione dipinta</translation>
    </message>
    <message>
        <source>Pick no points</source>
        <translation>Rinuncia alla scelta dei punti</translation>
    </message>
    <message>
        <source>Pick three points on each</source>
        <translation>Scelta di tre punti su ognuna</translation>
    </message>
    <message>
        <source>Remove a surface</source>
        <translation>Rimozione di una superficie</translation>
    </message>
    <message>
        <source>Remove the mark of the tooth</source>
        <translation>Rimozione del segno del dente</translation>
    </message>
    <message>
        <source>Say which jaw it is</source>
        <translation>Indicazione dell&apos;arcata</translation>
    </message>
    <message>
        <source>Swap before and after</source>
        <translation>Scambio di prima e dopo</translation>
    </message>
    <message>
        <source>Upper</source>
        <translation>Superiore</translation>
    </message>
    <message>
        <source>What did not move</source>
        <translation>Ciò che non si è mosso</translation>
    </message>
    <message>
        <source>Whole surface</source>
        <translation>Superficie intera</translation>
    </message>
    <message>
        <source>Wipe with the left button over what may have moved, then align on the rest.</source>
        <translation>Passare col pulsante sinistro su ciò che può essersi mosso, poi allineare sul resto.</translation>
    </message>
    <message>
        <source>best fit of everything, also of what moved</source>
        <translation>miglior adattamento di tutto, anche di ciò che si è mosso</translation>
    </message>
    <message>
        <source>given</source>
        <translation>dato</translation>
    </message>
    <message>
        <source>moved {d} ± {u} mm, turned {a} ± {v}°</source>
        <translation>spostato {d} ± {u} mm, ruotato {a} ± {v}°</translation>
    </message>
    <message>
        <source>no counterpart</source>
        <translation>senza corrispondente</translation>
    </message>
    <message>
        <source>picked points</source>
        <translation>punti scelti</translation>
    </message>
    <message>
        <source>point-pair features</source>
        <translation>coppie di punti</translation>
    </message>
    <message>
        <source>principal axes</source>
        <translation>assi principali</translation>
    </message>
    <message>
        <source>the files share one frame; nothing is aligned</source>
        <translation>i file condividono un riferimento; niente è allineato</translation>
    </message>
    <message>
        <source>the stable region is found and held fixed</source>
        <translation>la regione stabile è trovata e tenuta ferma</translation>
    </message>
    <message>
        <source>what was painted is held fixed</source>
        <translation>ciò che è dipinto è tenuto fermo</translation>
    </message>
    <message>
        <source>{n} mm inwards</source>
        <translation>{n} mm verso dentro</translation>
    </message>
    <message>
        <source>{n} mm outwards</source>
        <translation>{n} mm verso fuori</translation>
    </message>
    <message>
        <source>± {u} mm, turned {a} ± {v}°</source>
        <translation>± {u} mm, ruotato {a} ± {v}°</translation>
    </message>
</context>
<context>
    <name>coverage</name>
    <message>
        <source>Dust it with a matt powder, or expose shorter.</source>
        <translation>Opacizzare con polvere, o ridurre l&apos;esposizione.</translation>
    </message>
    <message>
        <source>Dust it with a matt white powder, or expose longer.</source>
        <translation>Opacizzare con polvere bianca, o aumentare l&apos;esposizione.</translation>
    </message>
    <message>
        <source>Fill it now.</source>
        <translation>Completare ora.</translation>
    </message>
    <message>
        <source>Following the light to every place…</source>
        <translation>Percorso della luce verso ogni zona…</translation>
    </message>
    <message>
        <source>Looking for a better way to set the object down…</source>
        <translation>Ricerca di un posizionamento migliore…</translation>
    </message>
    <message>
        <source>Move the object to the middle of the table.</source>
        <translation>Spostare l&apos;oggetto al centro della tavola.</translation>
    </message>
    <message>
        <source>On the side</source>
        <translation>Di lato</translation>
    </message>
    <message>
        <source>On top</source>
        <translation>In alto</translation>
    </message>
    <message>
        <source>Put the object down in another way.</source>
        <translation>Posare l&apos;oggetto in altro modo.</translation>
    </message>
    <message>
        <source>Reading the case…</source>
        <translation>Lettura del caso…</translation>
    </message>
    <message>
        <source>Tilt the object by about {deg}°.</source>
        <translation>Inclinare l&apos;oggetto di circa {deg}°.</translation>
    </message>
    <message>
        <source>Turn the object over, or tilt it by about {deg}°.</source>
        <translation>Capovolgere l&apos;oggetto o inclinarlo di circa {deg}°.</translation>
    </message>
    <message>
        <source>Turn the object upside down.</source>
        <translation>Capovolgere l&apos;oggetto.</translation>
    </message>
    <message>
        <source>Underneath</source>
        <translation>Di sotto</translation>
    </message>
    <message>
        <source>With the table at {turn:.0f}°, tip the top of the object by about {tip:.0f}° towards the cameras.</source>
        <translation>Con la tavola a {turn:.0f}°, inclinare la cima dell&apos;oggetto di circa {tip:.0f}° verso le telecamere.</translation>
    </message>
    <message>
        <source>as wanted</source>
        <translation>come richiesto</translation>
    </message>
    <message>
        <source>faces the laser at {deg}°</source>
        <translation>guarda il laser a {deg}°</translation>
    </message>
    <message>
        <source>hidden from the laser by the object</source>
        <translation>nascosta al laser dall&apos;oggetto</translation>
    </message>
    <message>
        <source>hidden from the left camera by the object</source>
        <translation>nascosta alla telecamera sinistra dall&apos;oggetto</translation>
    </message>
    <message>
        <source>hidden from the right camera by the object</source>
        <translation>nascosta alla telecamera destra dall&apos;oggetto</translation>
    </message>
    <message>
        <source>looks down or lies on the table</source>
        <translation>guarda in basso o poggia sulla tavola</translation>
    </message>
    <message>
        <source>never seen by both cameras at once</source>
        <translation>mai vista da entrambe le telecamere insieme</translation>
    </message>
    <message>
        <source>no points</source>
        <translation>senza punti</translation>
    </message>
    <message>
        <source>outside of the pictures or the volume</source>
        <translation>fuori dalle immagini o dal volume</translation>
    </message>
    <message>
        <source>seen too flatly at every angle</source>
        <translation>vista troppo radente da ogni angolo</translation>
    </message>
    <message>
        <source>the spot is too bright there</source>
        <translation>lì il punto laser è troppo forte</translation>
    </message>
    <message>
        <source>the spot is too dark there</source>
        <translation>lì il punto laser è troppo debole</translation>
    </message>
    <message>
        <source>too few points</source>
        <translation>troppo pochi punti</translation>
    </message>
    <message>
        <source>up to {um} µm</source>
        <translation>fino a {um} µm</translation>
    </message>
    <message>
        <source>{gained:.0f} of {unreached:.0f} mm² that are hidden now come into view; {share:.0f} % of what is seen then is known already.</source>
        <translation>{gained:.0f} dei {unreached:.0f} mm² ora nascosti diventano visibili; il {share:.0f} % di ciò che si vede è già noto.</translation>
    </message>
    <message>
        <source>{mm2} mm²</source>
        <translation>{mm2} mm²</translation>
    </message>
    <message>
        <source>{mm} mm up</source>
        <translation>{mm} mm in alto</translation>
    </message>
</context>
<context>
    <name>delivery</name>
    <message>
        <source>2-manifold</source>
        <translation>Varietà 2D</translation>
    </message>
    <message>
        <source>3MF, carries its unit</source>
        <translation>3MF, con la sua unità</translation>
    </message>
    <message>
        <source>A person accepted {count} holes or thin places as they are.</source>
        <translation>{count} lacune o zone rade sono state accettate così come sono.</translation>
    </message>
    <message>
        <source>A person took out {count} measured points, {percent} % of all.</source>
        <translation>{count} punti misurati sono stati tolti a mano, il {percent} % del totale.</translation>
    </message>
    <message>
        <source>A person took out {count} measured points.</source>
        <translation>{count} punti misurati sono stati tolti a mano.</translation>
    </message>
    <message>
        <source>Accepted places</source>
        <translation>Zone accettate</translation>
    </message>
    <message>
        <source>All triangles face outwards.</source>
        <translation>Tutti i triangoli guardano in fuori.</translation>
    </message>
    <message>
        <source>Another ear of this order is labelled {side} too, and yet the two mirror each other. Is one of them labelled wrongly?</source>
        <translation>Anche un altro orecchio di quest&apos;ordine è indicato {side}, eppure i due sono speculari. Uno è indicato male?</translation>
    </message>
    <message>
        <source>Archive (PLY with uncertainty, and points)</source>
        <translation>Archivio (PLY con incertezza, e punti)</translation>
    </message>
    <message>
        <source>As it was scanned</source>
        <translation>Come scansionata</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Calibrazione</translation>
    </message>
    <message>
        <source>Calibration {id} of {date} had expired {days} days before the scan. Calibrate, compute the points anew or scan again.</source>
        <translation>La calibrazione {id} del {date} era scaduta {days} giorni prima della scansione. Calibrare, ricalcolare i punti o ripetere la scansione.</translation>
    </message>
    <message>
        <source>Calibration {id} of {date} was off by {error_um} µm on corners that it had not seen, more than {limit_um} µm.</source>
        <translation>La calibrazione {id} del {date} errava di {error_um} µm agli angoli non usati, più di {limit_um} µm.</translation>
    </message>
    <message>
        <source>Calibration {id} of {date} was valid at the scan for {days} more days only; calibrate before the next order.</source>
        <translation>La calibrazione {id} del {date} era valida alla scansione solo per altri {days} giorni; calibrare prima del prossimo ordine.</translation>
    </message>
    <message>
        <source>Calibration {id} of {date} was valid at the scan, but no known length has verified its scale.</source>
        <translation>La calibrazione {id} del {date} era valida alla scansione, ma nessuna lunghezza nota ne ha verificato la scala.</translation>
    </message>
    <message>
        <source>Calibration {id} of {date} was valid at the scan, its scale verified; held-out error {error_um} µm.</source>
        <translation>La calibrazione {id} del {date} era valida alla scansione, scala verificata; errore agli angoli non usati {error_um} µm.</translation>
    </message>
    <message>
        <source>Canal tip up</source>
        <translation>Punta del condotto in alto</translation>
    </message>
    <message>
        <source>Centimetres</source>
        <translation>Centimetri</translation>
    </message>
    <message>
        <source>Closed</source>
        <translation>Chiusa</translation>
    </message>
    <message>
        <source>Closure of the turn</source>
        <translation>Chiusura del giro</translation>
    </message>
    <message>
        <source>Coverage</source>
        <translation>Copertura</translation>
    </message>
    <message>
        <source>Dental model (STL, occlusal plane XY)</source>
        <translation>Modello dentale (STL, piano occlusale XY)</translation>
    </message>
    <message>
        <source>Ear shell laboratory (STL)</source>
        <translation>Laboratorio gusci auricolari (STL)</translation>
    </message>
    <message>
        <source>Every edge and every vertex lies on one sheet of surface.</source>
        <translation>Ogni spigolo e ogni vertice sta su un solo foglio di superficie.</translation>
    </message>
    <message>
        <source>Every edge belongs to two triangles.</source>
        <translation>Ogni spigolo appartiene a due triangoli.</translation>
    </message>
    <message>
        <source>Expected error</source>
        <translation>Errore atteso</translation>
    </message>
    <message>
        <source>Facing outwards</source>
        <translation>Rivolta in fuori</translation>
    </message>
    <message>
        <source>How far this surface is off is not recorded; it was not reconstructed by this program.</source>
        <translation>Quanto erra questa superficie non è registrato; non l&apos;ha ricostruita questo programma.</translation>
    </message>
    <message>
        <source>Inches</source>
        <translation>Pollici</translation>
    </message>
    <message>
        <source>It consists of {count} separate pieces. Remove what does not belong to the object, and reconstruct again.</source>
        <translation>È fatta di {count} pezzi separati. Togliere ciò che non è dell&apos;oggetto, e ricostruire di nuovo.</translation>
    </message>
    <message>
        <source>It is one piece.</source>
        <translation>È un pezzo solo.</translation>
    </message>
    <message>
        <source>It is {longest_mm} x {middle_mm} x {shortest_mm} mm large, as {kind} is.</source>
        <translation>È grande {longest_mm} x {middle_mm} x {shortest_mm} mm, come {kind}.</translation>
    </message>
    <message>
        <source>It is {longest_mm} x {middle_mm} x {shortest_mm} mm large; {kind} is {least_mm} to {most_mm} mm long. Are unit and type right?</source>
        <translation>È grande {longest_mm} x {middle_mm} x {shortest_mm} mm; {kind} è lunga da {least_mm} a {most_mm} mm. Unità e tipo sono giusti?</translation>
    </message>
    <message>
        <source>It is {longest_mm} x {middle_mm} x {shortest_mm} mm large; {kind} is {least_mm} to {most_mm} mm long. Is it whole, and alone?</source>
        <translation>È grande {longest_mm} x {middle_mm} x {shortest_mm} mm; {kind} è lunga da {least_mm} a {most_mm} mm. È intera, e sola?</translation>
    </message>
    <message>
        <source>It mirrors the other ear: {mirrored_um} µm apart mirrored, {direct_um} µm as it is.</source>
        <translation>È speculare all&apos;altro orecchio: {mirrored_um} µm di distanza se specchiata, {direct_um} µm com&apos;è.</translation>
    </message>
    <message>
        <source>Marks on the table</source>
        <translation>Tacche sulla tavola</translation>
    </message>
    <message>
        <source>Metres</source>
        <translation>Metri</translation>
    </message>
    <message>
        <source>Millimetres</source>
        <translation>Millimetri</translation>
    </message>
    <message>
        <source>Modelling (OBJ)</source>
        <translation>Modellazione (OBJ)</translation>
    </message>
    <message>
        <source>Mount {mount} is not part of the surface: it could not be brought together with the others.</source>
        <translation>Il posizionamento {mount} non fa parte della superficie: non si è potuto unire agli altri.</translation>
    </message>
    <message>
        <source>Mounts</source>
        <translation>Posizionamenti</translation>
    </message>
    <message>
        <source>No hole or thin place had to be accepted.</source>
        <translation>Nessuna lacuna o zona rada è stata accettata.</translation>
    </message>
    <message>
        <source>No measured point was taken out.</source>
        <translation>Nessun punto misurato è stato tolto.</translation>
    </message>
    <message>
        <source>No self-intersections</source>
        <translation>Senza autointersezioni</translation>
    </message>
    <message>
        <source>No size is expected of an object of this type; it is {longest_mm} x {middle_mm} x {shortest_mm} mm large.</source>
        <translation>Per un oggetto di questo tipo non c&apos;è una misura attesa; è grande {longest_mm} x {middle_mm} x {shortest_mm} mm.</translation>
    </message>
    <message>
        <source>No triangle runs through another one.</source>
        <translation>Nessun triangolo ne attraversa un altro.</translation>
    </message>
    <message>
        <source>Not checked: the other ear of this order is not there yet.</source>
        <translation>Non verificato: l&apos;altro orecchio di quest&apos;ordine non c&apos;è ancora.</translation>
    </message>
    <message>
        <source>Not ready</source>
        <translation>Non pronta</translation>
    </message>
    <message>
        <source>Occlusal plane XY, +Z to occlusal</source>
        <translation>Piano occlusale XY, +Z verso occlusale</translation>
    </message>
    <message>
        <source>Of which points this surface was made is not recorded.</source>
        <translation>Non è registrato da quali punti è stata fatta questa superficie.</translation>
    </message>
    <message>
        <source>One shell</source>
        <translation>Un guscio solo</translation>
    </message>
    <message>
        <source>Only {percent} % of the surface beside its base rests on measured points: too much of it is a guess. Scan the rest first.</source>
        <translation>Solo il {percent} % della superficie oltre la base poggia su punti misurati: troppo è ipotesi. Prima scansionare il resto.</translation>
    </message>
    <message>
        <source>Only {percent} % of the surface beside its base rests on measured points; the rest is a guess. Fill the holes, or say so.</source>
        <translation>Solo il {percent} % della superficie oltre la base poggia su punti misurati; il resto è ipotesi. Colmare le lacune, o dichiararlo.</translation>
    </message>
    <message>
        <source>PLY, with uncertainty and support</source>
        <translation>PLY, con incertezza e sostegno</translation>
    </message>
    <message>
        <source>Points taken out</source>
        <translation>Punti tolti</translation>
    </message>
    <message>
        <source>Printing (3MF)</source>
        <translation>Stampa (3MF)</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>Pronta</translation>
    </message>
    <message>
        <source>Ready, with remarks</source>
        <translation>Pronta, con osservazioni</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Lato</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Dimensioni</translation>
    </message>
    <message>
        <source>The first view was not measured again, and the views of the turn agree only to {closure_um} µm.</source>
        <translation>La prima vista non è stata rimisurata, e le viste del giro concordano solo entro {closure_um} µm.</translation>
    </message>
    <message>
        <source>The first view was not measured again; the views of the turn agree to {closure_um} µm.</source>
        <translation>La prima vista non è stata rimisurata; le viste del giro concordano entro {closure_um} µm.</translation>
    </message>
    <message>
        <source>The first view, measured again after the turn, lies {closure_um} µm off, more than {limit_um} µm: something moved a little.</source>
        <translation>La prima vista, rimisurata dopo il giro, sta a {closure_um} µm, più di {limit_um} µm: qualcosa si è mosso un poco.</translation>
    </message>
    <message>
        <source>The first view, measured again at the end of the turn, lies {closure_um} µm beside its first measurement.</source>
        <translation>La prima vista, rimisurata a fine giro, sta a {closure_um} µm dalla sua prima misura.</translation>
    </message>
    <message>
        <source>The marks on the table&apos;s rim kept their distances to {marks_um} µm only, more than {limit_um} µm: something moved.</source>
        <translation>Le tacche del bordo della tavola hanno tenuto le distanze solo entro {marks_um} µm, più di {limit_um} µm: qualcosa si è mosso.</translation>
    </message>
    <message>
        <source>The marks on the table&apos;s rim kept their distances to {marks_um} µm.</source>
        <translation>Le tacche del bordo della tavola hanno tenuto le distanze entro {marks_um} µm.</translation>
    </message>
    <message>
        <source>The measured surface is expected to be off by {error_um} µm rms; the points scatter by {residual_um} µm about it.</source>
        <translation>L&apos;errore atteso della superficie misurata è {error_um} µm rms; i punti le si scostano di {residual_um} µm.</translation>
    </message>
    <message>
        <source>The order does not say which ear it is.</source>
        <translation>L&apos;ordine non dice quale orecchio è.</translation>
    </message>
    <message>
        <source>The order does not say which jaw it is.</source>
        <translation>L&apos;ordine non dice quale arcata è.</translation>
    </message>
    <message>
        <source>The points were changed after this surface was made of them. Reconstruct again.</source>
        <translation>I punti sono cambiati dopo che ne è stata fatta questa superficie. Ricostruire di nuovo.</translation>
    </message>
    <message>
        <source>The scan had no marks on the table&apos;s rim to watch over it.</source>
        <translation>La scansione non aveva tacche sul bordo della tavola che la sorvegliassero.</translation>
    </message>
    <message>
        <source>The surface has {count} open edges; a printer may fill it wrongly. Reconstruct again with closed holes.</source>
        <translation>La superficie ha {count} spigoli aperti; una stampante può riempirla male. Ricostruire di nuovo con lacune chiuse.</translation>
    </message>
    <message>
        <source>The surface is expected to be off by {error_um} µm rms, more than {limit_um} µm. More points, or a calibration, would help.</source>
        <translation>L&apos;errore atteso della superficie è {error_um} µm rms, più di {limit_um} µm. Aiuterebbero più punti, o una calibrazione.</translation>
    </message>
    <message>
        <source>The surface is expected to be off by {error_um} µm rms, more than {limit_um} µm: it was kept early. Reconstruct it to its end.</source>
        <translation>L&apos;errore atteso della superficie è {error_um} µm rms, più di {limit_um} µm: è stata tenuta prima della fine. Ricostruirla fino in fondo.</translation>
    </message>
    <message>
        <source>The surface is expected to be off by {error_um} µm rms: too much for a shell. Calibrate, and scan again.</source>
        <translation>L&apos;errore atteso della superficie è {error_um} µm rms: troppo per un guscio. Calibrare, e ripetere la scansione.</translation>
    </message>
    <message>
        <source>The surface touches itself at {count} places. Reconstruct again.</source>
        <translation>La superficie tocca sé stessa in {count} punti. Ricostruire di nuovo.</translation>
    </message>
    <message>
        <source>The surface was made of the points as they are now.</source>
        <translation>La superficie è fatta dai punti come sono ora.</translation>
    </message>
    <message>
        <source>The turn does not close: the first view, measured again, lies {closure_um} µm off. Object or camera moved; scan again.</source>
        <translation>Il giro non si chiude: la prima vista, rimisurata, sta a {closure_um} µm. L&apos;oggetto o una telecamera si è mosso; ripetere la scansione.</translation>
    </message>
    <message>
        <source>The two ears do not mirror each other ({direct_um} µm apart as they are, {mirrored_um} µm mirrored). Is one labelled wrongly?</source>
        <translation>I due orecchi non sono speculari (distano {direct_um} µm come sono, {mirrored_um} µm se specchiati). Uno è indicato male?</translation>
    </message>
    <message>
        <source>There is no other side to compare with.</source>
        <translation>Non c&apos;è un altro lato con cui confrontare.</translation>
    </message>
    <message>
        <source>There is one mount; nothing had to be brought together.</source>
        <translation>C&apos;è un solo posizionamento; niente da unire.</translation>
    </message>
    <message>
        <source>Triangles face inwards or against their neighbours. Reconstruct again.</source>
        <translation>Alcuni triangoli guardano in dentro o contro i vicini. Ricostruire di nuovo.</translation>
    </message>
    <message>
        <source>Up to date</source>
        <translation>Aggiornata</translation>
    </message>
    <message>
        <source>Whether it mirrors the other ear cannot be told ({mirrored_um} µm apart mirrored, {direct_um} µm as it is). Look at both.</source>
        <translation>Non si può dire se è speculare all&apos;altro orecchio ({mirrored_um} µm se specchiata, {direct_um} µm com&apos;è). Guardare entrambi.</translation>
    </message>
    <message>
        <source>Whether the turn closes was not measured.</source>
        <translation>Non è stato misurato se il giro si chiude.</translation>
    </message>
    <message>
        <source>Which part of this surface was measured is not recorded.</source>
        <translation>Non è registrato quale parte di questa superficie è stata misurata.</translation>
    </message>
    <message>
        <source>With which calibration this surface was measured is not recorded.</source>
        <translation>Non è registrato con quale calibrazione è stata misurata questa superficie.</translation>
    </message>
    <message>
        <source>a dental arch</source>
        <translation>un&apos;arcata dentaria</translation>
    </message>
    <message>
        <source>an ear impression</source>
        <translation>un&apos;impronta auricolare</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>non superata</translation>
    </message>
    <message>
        <source>not checked</source>
        <translation>non verificata</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>superata</translation>
    </message>
    <message>
        <source>remark</source>
        <translation>osservazione</translation>
    </message>
    <message>
        <source>{count} mounts lie on each other to {residual_um} µm only, more than {limit_um} µm.</source>
        <translation>{count} posizionamenti combaciano solo entro {residual_um} µm, più di {limit_um} µm.</translation>
    </message>
    <message>
        <source>{count} mounts lie on each other to {residual_um} µm.</source>
        <translation>{count} posizionamenti combaciano entro {residual_um} µm.</translation>
    </message>
    <message>
        <source>{count} triangles run through others. Reconstruct again, with less detail if need be.</source>
        <translation>{count} triangoli ne attraversano altri. Ricostruire di nuovo, se occorre con meno dettaglio.</translation>
    </message>
    <message>
        <source>{percent} % of the surface beside its base rests on measured points.</source>
        <translation>Il {percent} % della superficie oltre la base poggia su punti misurati.</translation>
    </message>
</context>
<context>
    <name>doubts</name>
    <message>
        <source>1 triangle has no area; it has no normal and is measured only by its neighbours.</source>
        <translation>1 triangolo non ha area; non ha normale ed è misurato solo tramite i vicini.</translation>
    </message>
    <message>
        <source>A best fit of the whole spreads what moved over everything: against the region that did not move it shifts the surface by up to {length}. Use the automatic or a painted frame.</source>
        <translation>Il miglior adattamento dell&apos;insieme spalma su tutto ciò che si è mosso: rispetto alla regione ferma sposta la superficie fino a {length}. Usare il riferimento automatico o uno dipinto.</translation>
    </message>
    <message>
        <source>Another pose fits about as well, because the shape resembles itself: pick three points to say which one is meant.</source>
        <translation>Un&apos;altra posa combacia quasi altrettanto, perché la forma somiglia a sé stessa: scegliere tre punti per dire quale vale.</translation>
    </message>
    <message>
        <source>By its order {before} is &apos;{first}&apos;, but {after} &apos;{second}&apos;; choose two that belong together.</source>
        <translation>Secondo il suo ordine {before} è &apos;{first}&apos;, ma {after} &apos;{second}&apos;; sceglierne due che vanno insieme.</translation>
    </message>
    <message>
        <source>By its order {before} is of the side &apos;{first}&apos;, but {after} &apos;{second}&apos;; choose two that belong together.</source>
        <translation>Secondo il suo ordine {before} è del lato &apos;{first}&apos;, ma {after} &apos;{second}&apos;; sceglierne due che vanno insieme.</translation>
    </message>
    <message>
        <source>Edges that belong to more than two triangles: {edges}; corners that join separate parts: {corners}. Inside and outside are not defined there.</source>
        <translation>Spigoli di più di due triangoli: {edges}; vertici che uniscono parti separate: {corners}. Lì dentro e fuori non sono definiti.</translation>
    </message>
    <message>
        <source>Hardly anything ({percent} % of the surface) kept its place, so geometry does not say what is fixed: paint what you know to be stable.</source>
        <translation>Quasi niente ({percent} % della superficie) è rimasto al suo posto, e la geometria non dice che cosa è fermo: dipingere ciò che si sa stabile.</translation>
    </message>
    <message>
        <source>It consists of {count} separate shells; the largest has {share} of the area. All of them are compared.</source>
        <translation>È fatta di {count} gusci separati; il più grande ha il {share} dell&apos;area. Si confrontano tutti.</translation>
    </message>
    <message>
        <source>It is open: its border has {mm} mm in one line. What lies beyond a border has no counterpart and is left out.</source>
        <translation>È aperta: il suo bordo è di {mm} mm in una sola linea. Ciò che sta oltre un bordo non ha corrispondente ed è escluso.</translation>
    </message>
    <message>
        <source>It is open: its border has {mm} mm in {count} lines. What lies beyond a border has no counterpart and is left out.</source>
        <translation>È aperta: il suo bordo è di {mm} mm in {count} linee. Ciò che sta oltre un bordo non ha corrispondente ed è escluso.</translation>
    </message>
    <message>
        <source>It is {mm} mm long, which neither an arch nor an ear is; check the unit of the file.</source>
        <translation>È lunga {mm} mm, quanto né un&apos;arcata né un orecchio; controllare l&apos;unità del file.</translation>
    </message>
    <message>
        <source>It touches or crosses itself: more than {count} triangles cut others. Distances near them may go to the wrong layer.</source>
        <translation>Si tocca o si attraversa: più di {count} triangoli ne tagliano altri. Lì vicino le distanze possono riferirsi allo strato sbagliato.</translation>
    </message>
    <message>
        <source>It touches or crosses itself: {count} triangles cut others. Distances near them may go to the wrong layer.</source>
        <translation>Si tocca o si attraversa: {count} triangoli ne tagliano altri. Lì vicino le distanze possono riferirsi allo strato sbagliato.</translation>
    </message>
    <message>
        <source>Its normals point inwards: + and - would be exchanged; turn them round in the program that wrote it.</source>
        <translation>Le sue normali guardano in dentro: + e - sarebbero scambiati; invertirle nel programma che l&apos;ha scritta.</translation>
    </message>
    <message>
        <source>Its normals point inwards: they look to the side of the gum, not of the teeth. If it is no impression (a negative), + and - are exchanged; turn them round in the program that wrote it.</source>
        <translation>Le sue normali guardano in dentro: verso la gengiva, non verso i denti. Se non è un&apos;impronta (un negativo), + e - sono scambiati; invertirle nel programma che l&apos;ha scritta.</translation>
    </message>
    <message>
        <source>Its normals seem to point inwards: it is open, but what it encloses lies on their side. If it is no impression (a negative), + and - are exchanged; turn them round in the program that wrote it.</source>
        <translation>Le sue normali sembrano guardare in dentro: è aperta, ma ciò che racchiude sta dalla loro parte. Se non è un&apos;impronta (un negativo), + e - sono scambiati; invertirle nel programma che l&apos;ha scritta.</translation>
    </message>
    <message>
        <source>Its numbers were taken as {unit} ({why}), so it is {mm} mm long; say the unit if that is wrong.</source>
        <translation>I suoi numeri sono presi come {unit} ({why}), quindi è lunga {mm} mm; se è sbagliato, indicare l&apos;unità.</translation>
    </message>
    <message>
        <source>No region was stable throughout the series; each surface was aligned by a region of its own, so small motions may not add up.</source>
        <translation>Nessuna regione è stata stabile in tutta la serie; ogni superficie è allineata su una regione propria, e piccoli moti possono non sommarsi.</translation>
    </message>
    <message>
        <source>Only {percent} % of the after surface has a counterpart before: scan the same region both times.</source>
        <translation>Solo il {percent} % della superficie dopo ha un corrispondente prima: scansionare la stessa regione entrambe le volte.</translation>
    </message>
    <message>
        <source>Points that belong to no triangle were left out: {count}.</source>
        <translation>Punti che non sono di alcun triangolo, esclusi: {count}.</translation>
    </message>
    <message>
        <source>Points with exactly the place of another one were joined: {count}.</source>
        <translation>Punti con esattamente la posizione di un altro, uniti: {count}.</translation>
    </message>
    <message>
        <source>Some triangles ({share} of its area) face the other way than their neighbours; + and - are exchanged there.</source>
        <translation>Alcuni triangoli ({share} della sua area) guardano al contrario dei vicini; lì + e - sono scambiati.</translation>
    </message>
    <message>
        <source>The after surface is {percent} % (+- {uncertainty} %) larger than the before surface where nothing should have changed, {length} at its rim: check units and the calibration of both scanners; nothing was rescaled.</source>
        <translation>La superficie dopo è più grande del {percent} % (+- {uncertainty} %) di quella prima dove niente doveva cambiare, {length} al bordo: controllare le unità e la calibrazione dei due scanner; niente è stato riscalato.</translation>
    </message>
    <message>
        <source>The after surface is {percent} % (+- {uncertainty} %) smaller than the before surface where nothing should have changed, {length} at its rim: check units and the calibration of both scanners; nothing was rescaled.</source>
        <translation>La superficie dopo è più piccola del {percent} % (+- {uncertainty} %) di quella prima dove niente doveva cambiare, {length} al bordo: controllare le unità e la calibrazione dei due scanner; niente è stato riscalato.</translation>
    </message>
    <message>
        <source>The alignment rests on {mm2} mm2, {percent} % of the surface that both files show: look whether the region drawn as stable is, or paint it.</source>
        <translation>L&apos;allineamento poggia su {mm2} mm2, il {percent} % della superficie comune ai due file: controllare che la regione disegnata come stabile lo sia, o dipingerla.</translation>
    </message>
    <message>
        <source>The file says {unit}, so it is {mm} mm long; by its size it would be in {guess}.</source>
        <translation>Il file dice {unit}, quindi è lunga {mm} mm; a giudicare dalla dimensione sarebbe in {guess}.</translation>
    </message>
    <message>
        <source>The later surface is {ratio} times as large as the earlier one; check the units ({units} differ by {factor}), or whether the two belong together.</source>
        <translation>La superficie successiva è {ratio} volte la precedente; controllare le unità ({units} differiscono di {factor}), o se le due vanno insieme.</translation>
    </message>
    <message>
        <source>The later surface is {ratio} times as large as the earlier one; check the units, or whether the two belong together.</source>
        <translation>La superficie successiva è {ratio} volte la precedente; controllare le unità, o se le due vanno insieme.</translation>
    </message>
    <message>
        <source>The material was not named; of the rig&apos;s null comparisons the largest level is shown (&apos;{other}&apos;).</source>
        <translation>Il materiale non è stato indicato; dei confronti nulli del banco si mostra la soglia maggiore (&apos;{other}&apos;).</translation>
    </message>
    <message>
        <source>The null comparison is of the rig &apos;{rig}&apos;, but the surfaces were measured with &apos;{others}&apos;.</source>
        <translation>Il confronto nullo è del banco &apos;{rig}&apos;, ma le superfici sono state misurate con &apos;{others}&apos;.</translation>
    </message>
    <message>
        <source>The null comparison of &apos;{material}&apos; ({date}) is older than the rig&apos;s calibration ({calibrated}); repeat it.</source>
        <translation>Il confronto nullo di &apos;{material}&apos; ({date}) è precedente alla calibrazione del banco ({calibrated}); ripeterlo.</translation>
    </message>
    <message>
        <source>The orders of {before} and {after} name different patients; choose two of one patient.</source>
        <translation>Gli ordini di {before} e {after} indicano pazienti diversi; sceglierne due di un solo paziente.</translation>
    </message>
    <message>
        <source>The stable region lies too much in one lump to hold the far end of the surface, which may be off by {length}: take in stable places that are farther apart.</source>
        <translation>La regione stabile è troppo raccolta per tenere il capo lontano della superficie, che può errare di {length}: aggiungere zone stabili più distanti fra loro.</translation>
    </message>
    <message>
        <source>This rig has no null comparison of &apos;{material}&apos;; the level shown is of another material, &apos;{other}&apos;. Measure one twice.</source>
        <translation>Questo banco non ha un confronto nullo di &apos;{material}&apos;; la soglia mostrata è di un altro materiale, &apos;{other}&apos;. Misurarne uno due volte.</translation>
    </message>
    <message>
        <source>Triangles without an extent but a line or point were left out: {count}.</source>
        <translation>Triangoli ridotti a una linea o un punto, esclusi: {count}.</translation>
    </message>
    <message>
        <source>What is taken for unchanged differs by up to {length} (95 %): either the scans are that noisy, or it changed everywhere and nothing is fixed. Smaller changes cannot be told.</source>
        <translation>Ciò che si prende per invariato differisce fino a {length} (95 %): o le scansioni sono così rumorose, o è cambiato ovunque e niente è fermo. Cambiamenti minori non si distinguono.</translation>
    </message>
    <message>
        <source>{before} and {after} are identical files: nothing was measured twice; choose the other state.</source>
        <translation>{before} e {after} sono file identici: niente è stato misurato due volte; scegliere l&apos;altro stato.</translation>
    </message>
    <message>
        <source>{before} and {after} hold the identical surface: nothing was measured twice; choose the other state.</source>
        <translation>{before} e {after} contengono la stessa superficie: niente è stato misurato due volte; scegliere l&apos;altro stato.</translation>
    </message>
    <message>
        <source>{before} was measured after {after} ({first} and {second}): are the two exchanged?</source>
        <translation>{before} è stata misurata dopo {after} ({first} e {second}): sono scambiate?</translation>
    </message>
    <message>
        <source>{count} triangles have no area; they have no normal and are measured only by their neighbours.</source>
        <translation>{count} triangoli non hanno area; non hanno normale e sono misurati solo tramite i vicini.</translation>
    </message>
    <message>
        <source>{name} lands {closure} um beside its place when it goes over {previous} (+- {uncertainty} um, k = 2): what is taken as stable may have moved.</source>
        <translation>{name} finisce a {closure} um dal suo posto passando per {previous} (+- {uncertainty} um, k = 2): ciò che è preso per stabile può essersi mosso.</translation>
    </message>
    <message>
        <source>{share} of its area faces the other way than its neighbours, so + and - cannot be told apart; let the program that wrote it orient it.</source>
        <translation>Il {share} della sua area guarda al contrario dei vicini, e + e - non si distinguono; farla orientare dal programma che l&apos;ha scritta.</translation>
    </message>
</context>
<context>
    <name>draft</name>
    <message>
        <source>Accept a place as it is</source>
        <translation>Accettazione di una zona così com&apos;è</translation>
    </message>
    <message>
        <source>Back to the defaults</source>
        <translation>Ripristino dei valori predefiniti</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>Entrambi</translation>
    </message>
    <message>
        <source>Bring points back</source>
        <translation>Recupero di punti</translation>
    </message>
    <message>
        <source>Change detail</source>
        <translation>Modifica dettaglio</translation>
    </message>
    <message>
        <source>Change number of points</source>
        <translation>Modifica numero di punti</translation>
    </message>
    <message>
        <source>Change number of triangles</source>
        <translation>Modifica numero di triangoli</translation>
    </message>
    <message>
        <source>Change number of views</source>
        <translation>Modifica numero di viste</translation>
    </message>
    <message>
        <source>Change open or closed base</source>
        <translation>Modifica base aperta o chiusa</translation>
    </message>
    <message>
        <source>Change pass-band</source>
        <translation>Modifica banda passante</translation>
    </message>
    <message>
        <source>Change seed</source>
        <translation>Modifica seme</translation>
    </message>
    <message>
        <source>Change side</source>
        <translation>Modifica lato</translation>
    </message>
    <message>
        <source>Change smoothing</source>
        <translation>Modifica lisciatura</translation>
    </message>
    <message>
        <source>Change support threshold</source>
        <translation>Modifica soglia di sostegno</translation>
    </message>
    <message>
        <source>Change tolerance</source>
        <translation>Modifica tolleranza</translation>
    </message>
    <message>
        <source>Change type</source>
        <translation>Modifica tipo</translation>
    </message>
    <message>
        <source>Change wanted uncertainty</source>
        <translation>Modifica incertezza richiesta</translation>
    </message>
    <message>
        <source>Dental model</source>
        <translation>Modello dentale</translation>
    </message>
    <message>
        <source>Dental model, after treatment</source>
        <translation>Modello dentale, dopo il trattamento</translation>
    </message>
    <message>
        <source>Dental model, before treatment</source>
        <translation>Modello dentale, prima del trattamento</translation>
    </message>
    <message>
        <source>Do not accept a place</source>
        <translation>Revoca dell&apos;accettazione di una zona</translation>
    </message>
    <message>
        <source>Ear impression</source>
        <translation>Impronta auricolare</translation>
    </message>
    <message>
        <source>Edit order number</source>
        <translation>Modifica numero d&apos;ordine</translation>
    </message>
    <message>
        <source>Edit patient code</source>
        <translation>Modifica codice paziente</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Sinistro</translation>
    </message>
    <message>
        <source>Lower jaw</source>
        <translation>Arcata inferiore</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Misura</translation>
    </message>
    <message>
        <source>Other</source>
        <translation>Altro</translation>
    </message>
    <message>
        <source>Remove a measurement</source>
        <translation>Rimozione di una misura</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Destro</translation>
    </message>
    <message>
        <source>Split the pair tray</source>
        <translation>Divisione del vassoio doppio</translation>
    </message>
    <message>
        <source>Take points out</source>
        <translation>Rimozione di punti</translation>
    </message>
    <message>
        <source>Upper jaw</source>
        <translation>Arcata superiore</translation>
    </message>
</context>
<context>
    <name>emission</name>
    <message>
        <source>Laser ON</source>
        <translation>Laser ACCESO</translation>
    </message>
    <message>
        <source>Laser off</source>
        <translation>Laser spento</translation>
    </message>
    <message>
        <source>Laser unknown</source>
        <translation>Laser ignoto</translation>
    </message>
    <message>
        <source>Laser: no rig</source>
        <translation>Laser: nessun banco</translation>
    </message>
</context>
<context>
    <name>faults</name>
    <message>
        <source>Something unexpected happened ({kind}).</source>
        <translation>È accaduto qualcosa di imprevisto ({kind}).</translation>
    </message>
    <message>
        <source>What was measured is kept; the details help us to mend it.</source>
        <translation>Quanto misurato è conservato; i dettagli aiutano a rimediare.</translation>
    </message>
    <message>
        <source>left</source>
        <translation>sinistra</translation>
    </message>
    <message>
        <source>right</source>
        <translation>destra</translation>
    </message>
</context>
<context>
    <name>format</name>
    <message>
        <source>1 day old</source>
        <translation>1 giorno fa</translation>
    </message>
    <message>
        <source>1 hour ago</source>
        <translation>1 ora fa</translation>
    </message>
    <message>
        <source>1 minute ago</source>
        <translation>1 minuto fa</translation>
    </message>
    <message>
        <source>just now</source>
        <translation>adesso</translation>
    </message>
    <message>
        <source>today</source>
        <translation>oggi</translation>
    </message>
    <message>
        <source>yesterday</source>
        <translation>ieri</translation>
    </message>
    <message>
        <source>{n} days ago</source>
        <translation>{n} giorni fa</translation>
    </message>
    <message>
        <source>{n} days old</source>
        <translation>{n} giorni fa</translation>
    </message>
    <message>
        <source>{n} hours ago</source>
        <translation>{n} ore fa</translation>
    </message>
    <message>
        <source>{n} minutes ago</source>
        <translation>{n} minuti fa</translation>
    </message>
</context>
<context>
    <name>help</name>
    <message>
        <source>A deviation is positive where the surface after lies outside of the one before. What is smaller than the detection level cannot be told from noise and stays grey.</source>
        <translation>Lo scostamento è positivo dove la superficie dopo sta fuori da quella prima. Ciò che è sotto la soglia di rilevabilità non si distingue dal rumore e resta grigio.</translation>
    </message>
    <message>
        <source>A rig of your own is set up here: its board and cameras are found, checked, and written into a file.</source>
        <translation>Qui si configura un banco proprio: scheda e telecamere sono trovate, verificate e scritte in un file.</translation>
    </message>
    <message>
        <source>A sphere of certified size is measured: it tells whether the rig still measures right.</source>
        <translation>Si misura una sfera di misura certificata: dice se il banco misura ancora bene.</translation>
    </message>
    <message>
        <source>An area is that of the missing surface in square millimetres. The sign at each place says why it is missing.</source>
        <translation>L&apos;area è quella della superficie mancante, in millimetri quadrati. Il segno a ogni zona dice perché manca.</translation>
    </message>
    <message>
        <source>Both cameras live, with the laser spot that is accepted and every spot that is not.</source>
        <translation>Le due telecamere dal vivo, col punto laser accettato e ogni punto che non lo è.</translation>
    </message>
    <message>
        <source>Cut the base off, then brush or lasso what is left over. Every step can be taken back with Ctrl+Z; no point is ever deleted.</source>
        <translation>Tagliare la base, poi pennello o lazo per ciò che avanza. Ogni passo si annulla con Ctrl+Z; nessun punto viene mai cancellato.</translation>
    </message>
    <message>
        <source>Directions and steps are measured by what the cameras see, and corrected in the file where they differ.</source>
        <translation>Direzioni e passi sono misurati con ciò che vedono le telecamere, e corretti nel file dove non coincidono.</translation>
    </message>
    <message>
        <source>Drop both files, say which part has not changed, and compare. Then go through the areas, the largest first.</source>
        <translation>Trascinare i due file, indicare la parte che non è cambiata e confrontare. Poi scorrere le aree, dalla più grande.</translation>
    </message>
    <message>
        <source>Every change is in force at once or says when it will be, and Ctrl+Z takes it back.</source>
        <translation>Ogni modifica vale subito o dice quando varrà, e Ctrl+Z la annulla.</translation>
    </message>
    <message>
        <source>Fill now scans more where the laser reaches as the object stands. For what is hidden set the object down another way and scan that, or accept the place as it is.</source>
        <translation>«Completa ora» scansiona ancora dove il laser arriva con l&apos;oggetto com&apos;è. Per ciò che è nascosto, posare l&apos;oggetto in altro modo e scansionarlo, o accettare la zona com&apos;è.</translation>
    </message>
    <message>
        <source>Go from step to step. Each says what it moves before it does; keep the lid closed and the stop button within reach.</source>
        <translation>Procedere passo per passo. Ognuno dice che cosa muove prima di farlo; tenere il coperchio chiuso e il pulsante di arresto a portata di mano.</translation>
    </message>
    <message>
        <source>Here the day begins: an order is chosen or made, and its scan is started.</source>
        <translation>Qui comincia la giornata: si sceglie o si crea un ordine e se ne avvia la scansione.</translation>
    </message>
    <message>
        <source>Lengths are in millimetres between measured points, areas in square millimetres within the section.</source>
        <translation>Le lunghezze sono in millimetri fra punti misurati, le aree in millimetri quadrati entro la sezione.</translation>
    </message>
    <message>
        <source>Let the exposure be set by itself, or choose a material. Change the limits of the size only when good spots are refused: the reason stands at each of them.</source>
        <translation>Lasciare l&apos;esposizione automatica o scegliere un materiale. Cambiare i limiti della dimensione solo se vengono rifiutati punti buoni: il motivo sta accanto a ciascuno.</translation>
    </message>
    <message>
        <source>Nothing needs to be done while it runs. Pause stops at a safe place with the laser dark; Esc ends the scan and keeps what was measured.</source>
        <translation>Durante la scansione non c&apos;è niente da fare. Pausa ferma in un punto sicuro col laser spento; Esc termina e conserva quanto misurato.</translation>
    </message>
    <message>
        <source>Pick a place on the left, then the same place on the right, three times and far apart. Without a mouse: turn with the arrow keys, pick with space.</source>
        <translation>Scegliere un punto a sinistra, poi lo stesso a destra, tre volte e lontani fra loro. Senza mouse: girare con le frecce, scegliere con la barra spaziatrice.</translation>
    </message>
    <message>
        <source>Points that do not belong to the object are taken out here, and distances are measured.</source>
        <translation>Qui si tolgono i punti estranei all&apos;oggetto e si misurano distanze.</translation>
    </message>
    <message>
        <source>Put the sphere into the middle of the table, enter the diameter from its certificate, and start. Do it once a month, and after every calibration.</source>
        <translation>Mettere la sfera al centro della tavola, inserire il diametro del suo certificato e avviare. Una volta al mese, e dopo ogni calibrazione.</translation>
    </message>
    <message>
        <source>Read the checks: what is amber says in one sentence what it means. Choose the profile of the receiver and deliver.</source>
        <translation>Leggere le verifiche: ciò che è ambra dice in una frase che cosa significa. Scegliere il profilo del destinatario e consegnare.</translation>
    </message>
    <message>
        <source>Set it down so that what was below looks up, and scan this mount. If it does not fit by itself, pick three points on both.</source>
        <translation>Posarlo in modo che il sotto guardi in alto, e scansionare questo posizionamento. Se non combacia da sé, scegliere tre punti su entrambi.</translation>
    </message>
    <message>
        <source>Start it with the detail as it stands. You may stop it and keep what is there, or scan the next order meanwhile.</source>
        <translation>Avviarla col dettaglio com&apos;è. Si può fermare e conservare ciò che c&apos;è, o intanto scansionare il prossimo ordine.</translation>
    </message>
    <message>
        <source>The coverage is the share of the surface that was measured, the rest was spanned. The uncertainty is that of a point of the surface, one standard deviation.</source>
        <translation>La copertura è la parte di superficie misurata; il resto è stato colmato. L&apos;incertezza è quella di un punto della superficie, uno scarto tipo.</translation>
    </message>
    <message>
        <source>The distance says how well both agree where they overlap; it should be about the noise of a point.</source>
        <translation>La distanza dice quanto i due concordano dove si sovrappongono; dev&apos;essere circa il rumore di un punto.</translation>
    </message>
    <message>
        <source>The ellipse is the spot&apos;s size, one sigma in pixels. The line is where the other camera says that the spot must be.</source>
        <translation>L&apos;ellisse è la dimensione del punto, un sigma in pixel. La linea è dove il punto deve stare secondo l&apos;altra telecamera.</translation>
    </message>
    <message>
        <source>The error is the distance of the points to the surface: half of them are nearer than the first number, 95 % nearer than the second. Its width should be about the noise of a point.</source>
        <translation>L&apos;errore è la distanza dei punti dalla superficie: la metà sta entro il primo numero, il 95 % entro il secondo. La larghezza dev&apos;essere circa il rumore di un punto.</translation>
    </message>
    <message>
        <source>The error of the calibration is measured at corners of the board that were not used to calibrate. Its age counts since then: calibrate again when something was moved.</source>
        <translation>L&apos;errore della calibrazione è misurato ad angoli della scacchiera non usati per calibrare. L&apos;età conta da allora: ricalibrare se qualcosa è stato spostato.</translation>
    </message>
    <message>
        <source>The large number says how accurate the rig measured the last time it was checked, and when that was.</source>
        <translation>Il numero grande dice quanto accurato era il banco all&apos;ultima verifica, e quando è stata fatta.</translation>
    </message>
    <message>
        <source>The object is measured: the laser visits it point by point, and the table turns it from view to view.</source>
        <translation>L&apos;oggetto viene misurato: il laser lo visita punto per punto e la tavola lo gira da vista a vista.</translation>
    </message>
    <message>
        <source>The object is scanned again, set down another way, and both scans are brought together.</source>
        <translation>L&apos;oggetto viene scansionato di nuovo, posato in altro modo, e le due scansioni sono unite.</translation>
    </message>
    <message>
        <source>The places need not be exact: a few millimetres are enough, the rest is computed from all points.</source>
        <translation>I punti non devono essere esatti: bastano pochi millimetri, il resto è calcolato da tutti i punti.</translation>
    </message>
    <message>
        <source>The points become a closed surface: a balloon is inflated inside them, refined where they ask for it, and smoothed.</source>
        <translation>Dai punti nasce una superficie chiusa: un palloncino vi si gonfia dentro, si raffina dove serve e viene lisciato.</translation>
    </message>
    <message>
        <source>The points count what is in the case already. Rejected points were seen by one camera only, or not sharply enough: a few of them are normal. The time left is computed from the views that are done.</source>
        <translation>I punti contano quanto è già nel caso. I punti scartati li ha visti una sola telecamera, o non erano abbastanza nitidi: alcuni sono normali. Il tempo rimasto è calcolato dalle viste fatte.</translation>
    </message>
    <message>
        <source>The size deviation is the measured diameter less the certified one; U is its uncertainty, k = 2. PF is the distance between the outermost and the innermost point, D95 the width that holds 95 % of the points, σ their standard deviation.</source>
        <translation>Lo scarto di misura è il diametro misurato meno quello certificato; U è la sua incertezza, k = 2. PF è la distanza fra il punto più esterno e il più interno, D95 la fascia che contiene il 95 % dei punti, σ il loro scarto tipo.</translation>
    </message>
    <message>
        <source>The size is that of everything in the window: 150 % makes texts and buttons half as large again.</source>
        <translation>La dimensione vale per tutta la finestra: 150 % rende testi e pulsanti grandi una volta e mezza.</translation>
    </message>
    <message>
        <source>The surface is checked and leaves the program as a file for the next machine, with a certificate beside it.</source>
        <translation>La superficie viene verificata e lascia il programma come file per la macchina successiva, con accanto un certificato.</translation>
    </message>
    <message>
        <source>This page shows the cameras, the laser, the table and their calibration.</source>
        <translation>Questa pagina mostra telecamere, laser, tavola e la loro calibrazione.</translation>
    </message>
    <message>
        <source>Three places that both mounts have in common tell the program how the object was set down.</source>
        <translation>Tre punti comuni ai due posizionamenti dicono al programma come è stato posato l&apos;oggetto.</translation>
    </message>
    <message>
        <source>Two surfaces of the same object, before and after, are laid upon each other and their difference is shown.</source>
        <translation>Due superfici dello stesso oggetto, prima e dopo, sono sovrapposte e se ne mostra la differenza.</translation>
    </message>
    <message>
        <source>Type the order&apos;s number or read it with the scanner, choose the side and the type, put the object on the table, and start. An interrupted scan is offered at the top and can be resumed.</source>
        <translation>Digitare il numero d&apos;ordine o leggerlo con il lettore, scegliere lato e tipo, mettere l&apos;oggetto sulla tavola e avviare. Una scansione interrotta è proposta in alto e si può riprendere.</translation>
    </message>
    <message>
        <source>What is set once: looks, language, folders, and what a scan does by itself.</source>
        <translation>Ciò che si imposta una volta: aspetto, lingua, cartelle, e ciò che la scansione fa da sé.</translation>
    </message>
    <message>
        <source>When everything is green there is nothing to do. Otherwise read the one sentence that is amber: it says what helps, with a button.</source>
        <translation>Se tutto è verde non c&apos;è niente da fare. Altrimenti leggere la frase ambra: dice che cosa aiuta, con un pulsante.</translation>
    </message>
    <message>
        <source>Where the surface is not measured, or only thinly: a list of places, the largest first.</source>
        <translation>Dove la superficie non è misurata, o solo poco: una lista di zone, dalla più grande.</translation>
    </message>
</context>
<context>
    <name>keys</name>
    <message>
        <source>Compare</source>
        <translation>Confronto</translation>
    </message>
    <message>
        <source>Everywhere</source>
        <translation>Ovunque</translation>
    </message>
    <message>
        <source>Nearer and farther</source>
        <translation>Più vicino e più lontano</translation>
    </message>
    <message>
        <source>Next and previous control</source>
        <translation>Controllo successivo e precedente</translation>
    </message>
    <message>
        <source>Open the menus</source>
        <translation>Apre i menu</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>Pagine</translation>
    </message>
    <message>
        <source>Pick the point in the middle</source>
        <translation>Sceglie il punto al centro</translation>
    </message>
    <message>
        <source>Pick three points</source>
        <translation>Scelta di tre punti</translation>
    </message>
    <message>
        <source>Press the control in hand</source>
        <translation>Aziona il controllo attivo</translation>
    </message>
    <message>
        <source>The other surface, for a moment</source>
        <translation>L&apos;altra superficie, per un momento</translation>
    </message>
    <message>
        <source>Turn the view</source>
        <translation>Gira la vista</translation>
    </message>
</context>
<context>
    <name>materials</name>
    <message>
        <source>A clipped top hides where the peak is, and on gloss it is seldom in the middle.</source>
        <translation>Una cima saturata nasconde il picco, e sul lucido raramente sta al centro.</translation>
    </message>
    <message>
        <source>A dim halo without its spot must not be taken for one.</source>
        <translation>Un alone debole senza il suo punto non va preso per un punto.</translation>
    </message>
    <message>
        <source>A higher threshold keeps the foot of the halo, which is no part of the beam, out of the spot.</source>
        <translation>Una soglia più alta tiene fuori dal punto il piede dell&apos;alone, che non è parte del raggio.</translation>
    </message>
    <message>
        <source>A little light spreads inside of the plaster and comes out around the spot.</source>
        <translation>Un po&apos; di luce si diffonde nel gesso ed esce attorno al punto.</translation>
    </message>
    <message>
        <source>Alginate or another wet, glossy impression under a thin coat of white powder.</source>
        <translation>Alginato o altra impronta bagnata e lucida, sotto un velo di polvere bianca.</translation>
    </message>
    <message>
        <source>Alginate, scan-sprayed</source>
        <translation>Alginato, opacizzato</translation>
    </message>
    <message>
        <source>Dry plaster does not mirror; what is less bright by four is light from a neighbouring wall.</source>
        <translation>Il gesso asciutto non riflette; ciò che è quattro volte più debole è luce di una parete vicina.</translation>
    </message>
    <message>
        <source>Ear impression silicone</source>
        <translation>Silicone per impronte auricolari</translation>
    </message>
    <message>
        <source>Glare flattens the top of a spot on a wet place: fewer clipped pixels are borne than on a matt surface.</source>
        <translation>Il bagliore appiattisce la cima di un punto sul bagnato: si tollerano meno pixel saturi che su una superficie opaca.</translation>
    </message>
    <message>
        <source>Glossy plastic</source>
        <translation>Plastica lucida</translation>
    </message>
    <message>
        <source>Light goes in and comes out around: the peak is lower than on silicone that scatters as much.</source>
        <translation>La luce entra ed esce attorno: il picco è più basso che su un silicone che diffonde altrettanto.</translation>
    </message>
    <message>
        <source>Matt, light silicone that has set; coloured ones may need more light.</source>
        <translation>Silicone opaco e chiaro, indurito; quelli colorati possono volere più luce.</translation>
    </message>
    <message>
        <source>Mirrored light is drawn out along the surface: spots that are longer than three times their width are doubtful here.</source>
        <translation>La luce riflessa si allunga lungo la superficie: punti più lunghi di tre volte la larghezza qui sono dubbi.</translation>
    </message>
    <message>
        <source>Mirrored spots are nearly as bright as true ones: the frame alone decides nothing, the other camera does.</source>
        <translation>I punti riflessi sono chiari quasi quanto i veri: l&apos;immagine da sola non decide, decide l&apos;altra telecamera.</translation>
    </message>
    <message>
        <source>Plaster</source>
        <translation>Gesso</translation>
    </message>
    <message>
        <source>Plaster scatters back about 0.8 of the light where silicone scatters 0.5: the same peak comes in 0.65 of the time.</source>
        <translation>Il gesso rimanda circa 0.8 della luce dove il silicone ne rimanda 0.5: lo stesso picco arriva in 0.65 del tempo.</translation>
    </message>
    <message>
        <source>Printed models, varnish, enamel; spray it where you can.</source>
        <translation>Modelli stampati, vernice, smalto; opacizzare dove si può.</translation>
    </message>
    <message>
        <source>Set silicone hardly mirrors: four times as bright tells the spot from the few reflections.</source>
        <translation>Il silicone indurito quasi non riflette: quattro volte più chiaro distingue il punto dai pochi riflessi.</translation>
    </message>
    <message>
        <source>Skin-like</source>
        <translation>Simile alla pelle</translation>
    </message>
    <message>
        <source>The halo of the light that comes out around the spot is wider than the spot.</source>
        <translation>L&apos;alone della luce che esce attorno al punto è più largo del punto.</translation>
    </message>
    <message>
        <source>The part that is mirrored is lost to both cameras or blinds one: between plaster and silicone.</source>
        <translation>La parte riflessa si perde per entrambe le telecamere o ne acceca una: fra gesso e silicone.</translation>
    </message>
    <message>
        <source>The powder is as white as plaster where the coat covers; a little more light for where it is thin.</source>
        <translation>La polvere è bianca come il gesso dove copre; un po&apos; più di luce per dove è sottile.</translation>
    </message>
    <message>
        <source>The rig&apos;s own exposure is made for a matt, light surface that scatters back about half of the light, as silicone does.</source>
        <translation>L&apos;esposizione propria del banco è fatta per una superficie opaca e chiara che rimanda circa metà della luce, come il silicone.</translation>
    </message>
    <message>
        <source>The walls of the canal are seen at up to 80 degrees: their spots are drawn out, and still good.</source>
        <translation>Le pareti del condotto si vedono fino a 80 gradi: i loro punti sono allungati, e ancora buoni.</translation>
    </message>
    <message>
        <source>Translucent and reddish: skin, wax, flesh-coloured silicone.</source>
        <translation>Traslucido e rossiccio: pelle, cera, silicone color carne.</translation>
    </message>
    <message>
        <source>Where the coat is thin the wet surface mirrors: only what is clearly the brightest is taken, the rest is left to the other camera.</source>
        <translation>Dove il velo è sottile la superficie bagnata riflette: si prende solo ciò che è nettamente il più chiaro, il resto lo decide l&apos;altra telecamera.</translation>
    </message>
    <message>
        <source>White gypsum, as dental models and casts are made of.</source>
        <translation>Gesso bianco, di cui sono fatti i modelli dentali.</translation>
    </message>
</context>
<context>
    <name>measure</name>
    <message>
        <source>Canal length</source>
        <translation>Lunghezza del condotto</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Distanza</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Sezione</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volume</translation>
    </message>
    <message>
        <source>at most ±{mm3} mm³; surface {mm2} mm²</source>
        <translation>al massimo ±{mm3} mm³; superficie {mm2} mm²</translation>
    </message>
    <message>
        <source>from end to end</source>
        <translation>da capo a capo</translation>
    </message>
    <message>
        <source>from the tip to where it opens</source>
        <translation>dalla punta a dove si apre</translation>
    </message>
    <message>
        <source>its uncertainty is not known</source>
        <translation>la sua incertezza non è nota</translation>
    </message>
    <message>
        <source>perimeter {mm} mm</source>
        <translation>perimetro {mm} mm</translation>
    </message>
    <message>
        <source>perimeter {mm} mm; the section is open</source>
        <translation>perimetro {mm} mm; la sezione è aperta</translation>
    </message>
    <message>
        <source>surface {mm2} mm²</source>
        <translation>superficie {mm2} mm²</translation>
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
        <translation>± {um} µm, incertezza tipo dei due punti</translation>
    </message>
</context>
<context>
    <name>mounts</name>
    <message>
        <source>Mount {n}</source>
        <translation>Posizionamento {n}</translation>
    </message>
    <message>
        <source>Pick a point on a mount</source>
        <translation>Scelta di un punto su un posizionamento</translation>
    </message>
    <message>
        <source>from your points</source>
        <translation>dai punti scelti</translation>
    </message>
    <message>
        <source>margin to the second-best pose {margin}</source>
        <translation>margine sulla seconda posa {margin}</translation>
    </message>
    <message>
        <source>unique</source>
        <translation>univoco</translation>
    </message>
    <message>
        <source>{points} points, kept apart</source>
        <translation>{points} punti, tenuti a parte</translation>
    </message>
    <message>
        <source>{points} points; the others lie on it</source>
        <translation>{points} punti; gli altri vi combaciano</translation>
    </message>
    <message>
        <source>{share} % overlap</source>
        <translation>{share} % di sovrapposizione</translation>
    </message>
    <message>
        <source>{um} µm residual</source>
        <translation>{um} µm di residuo</translation>
    </message>
</context>
<context>
    <name>pages</name>
    <message>
        <source>Aim</source>
        <translation>Puntamento</translation>
    </message>
    <message>
        <source>Another mount</source>
        <translation>Altro posizionamento</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Confronto</translation>
    </message>
    <message>
        <source>Complete</source>
        <translation>Completa</translation>
    </message>
    <message>
        <source>Deliver</source>
        <translation>Consegna</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Modifica</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Inizio</translation>
    </message>
    <message>
        <source>Live point cloud</source>
        <translation>Punti dal vivo</translation>
    </message>
    <message>
        <source>Missing places</source>
        <translation>Zone mancanti</translation>
    </message>
    <message>
        <source>Mounts</source>
        <translation>Posizionamenti</translation>
    </message>
    <message>
        <source>Pick three points</source>
        <translation>Scelta di tre punti</translation>
    </message>
    <message>
        <source>Points and measurements</source>
        <translation>Punti e misure</translation>
    </message>
    <message>
        <source>Reconstruct</source>
        <translation>Ricostruzione</translation>
    </message>
    <message>
        <source>Reference sphere</source>
        <translation>Sfera di riferimento</translation>
    </message>
    <message>
        <source>Rig</source>
        <translation>Banco</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>Scansione</translation>
    </message>
    <message>
        <source>Set up a rig</source>
        <translation>Configura un banco</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Impostazioni</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Superficie</translation>
    </message>
</context>
<context>
    <name>phases</name>
    <message>
        <source>Inflate</source>
        <translation>Gonfia</translation>
    </message>
    <message>
        <source>Refine</source>
        <translation>Raffina</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Liscia</translation>
    </message>
    <message>
        <source>grows to the points</source>
        <translation>cresce fino ai punti</translation>
    </message>
    <message>
        <source>where the error is</source>
        <translation>dove c&apos;è errore</translation>
    </message>
    <message>
        <source>without shrinking</source>
        <translation>senza ritiro</translation>
    </message>
</context>
<context>
    <name>preferences</name>
    <message>
        <source>another folder for cases</source>
        <translation>altra cartella dei casi</translation>
    </message>
    <message>
        <source>another folder for exports</source>
        <translation>altra cartella delle esportazioni</translation>
    </message>
    <message>
        <source>another pattern of file names</source>
        <translation>altro modello dei nomi dei file</translation>
    </message>
    <message>
        <source>change of the export profiles</source>
        <translation>modifica dei profili di esportazione</translation>
    </message>
    <message>
        <source>change of the language</source>
        <translation>modifica della lingua</translation>
    </message>
    <message>
        <source>change of the size</source>
        <translation>modifica della dimensione</translation>
    </message>
    <message>
        <source>change of the theme</source>
        <translation>modifica del tema</translation>
    </message>
    <message>
        <source>measuring weak places again</source>
        <translation>rimisura delle zone deboli</translation>
    </message>
    <message>
        <source>patient&apos;s code in file names</source>
        <translation>codice paziente nei nomi dei file</translation>
    </message>
    <message>
        <source>surface while scanning</source>
        <translation>superficie durante la scansione</translation>
    </message>
</context>
<context>
    <name>ready</name>
    <message>
        <source>Calibrate…</source>
        <translation>Calibra…</translation>
    </message>
    <message>
        <source>Check again</source>
        <translation>Verifica di nuovo</translation>
    </message>
    <message>
        <source>Checking the rig…</source>
        <translation>Verifica del banco…</translation>
    </message>
    <message>
        <source>Find reference</source>
        <translation>Cerca riferimento</translation>
    </message>
    <message>
        <source>Laser off</source>
        <translation>Spegni laser</translation>
    </message>
    <message>
        <source>Measure the sphere…</source>
        <translation>Misura la sfera…</translation>
    </message>
    <message>
        <source>Only {free_gib} GB are free where the cases are kept: free some space.</source>
        <translation>Solo {free_gib} GB liberi dove si conservano i casi: liberare spazio.</translation>
    </message>
    <message>
        <source>Ready to measure.</source>
        <translation>Pronto a misurare.</translation>
    </message>
    <message>
        <source>Reconnect</source>
        <translation>Ricollega</translation>
    </message>
    <message>
        <source>Set up…</source>
        <translation>Configura…</translation>
    </message>
    <message>
        <source>The axes have not found their reference yet.</source>
        <translation>Gli assi non hanno ancora trovato il riferimento.</translation>
    </message>
    <message>
        <source>The calibration does not fit this rig: it must be another one&apos;s.</source>
        <translation>La calibrazione non è di questo banco: dev&apos;essere di un altro.</translation>
    </message>
    <message>
        <source>The calibration expired {days} days ago.</source>
        <translation>La calibrazione è scaduta da {days} giorni.</translation>
    </message>
    <message>
        <source>The controller is halted.</source>
        <translation>Il controllore è fermo.</translation>
    </message>
    <message>
        <source>The controller is in alarm: look what stopped it, then unlock it.</source>
        <translation>Il controllore è in allarme: vedere che cosa l&apos;ha fermato, poi sbloccarlo.</translation>
    </message>
    <message>
        <source>The controller reports that the laser is lit, and nobody has asked for it.</source>
        <translation>Il controllore segnala il laser acceso, e nessuno l&apos;ha chiesto.</translation>
    </message>
    <message>
        <source>The lid was opened: close it, then unlock.</source>
        <translation>Il coperchio è stato aperto: chiuderlo, poi sbloccare.</translation>
    </message>
    <message>
        <source>The reference sphere was last measured {days} days ago: have the rig verified.</source>
        <translation>Sfera di riferimento misurata l&apos;ultima volta {days} giorni fa: far verificare il banco.</translation>
    </message>
    <message>
        <source>The reference sphere was never measured on this rig: have it verified.</source>
        <translation>La sfera di riferimento non è mai stata misurata su questo banco: farlo verificare.</translation>
    </message>
    <message>
        <source>The rig is not calibrated yet.</source>
        <translation>Il banco non è ancora calibrato.</translation>
    </message>
    <message>
        <source>The {camera} camera sends black pictures: take the cap off its lens and look at its cable.</source>
        <translation>La telecamera {camera} dà immagini nere: togliere il tappo dell&apos;obiettivo e controllare il cavo.</translation>
    </message>
    <message>
        <source>The {camera} camera sends pictures of {size} pixels, the rig file says {expected}.</source>
        <translation>La telecamera {camera} dà immagini di {size} pixel, il file del banco dice {expected}.</translation>
    </message>
    <message>
        <source>Too much light falls into the {camera} camera: switch the lamp off or close the lid.</source>
        <translation>Troppa luce nella telecamera {camera}: spegnere la lampada o chiudere il coperchio.</translation>
    </message>
    <message>
        <source>Unlock</source>
        <translation>Sblocca</translation>
    </message>
    <message>
        <source>left</source>
        <translation>sinistra</translation>
    </message>
    <message>
        <source>right</source>
        <translation>destra</translation>
    </message>
    <message>
        <source>{sentence} (and {more} more)</source>
        <translation>{sentence} (e altri {more})</translation>
    </message>
</context>
<context>
    <name>reasons</name>
    <message>
        <source>cameras did not expose together</source>
        <translation>telecamere non sincrone nell&apos;esposizione</translation>
    </message>
    <message>
        <source>cameras saw different spots</source>
        <translation>le telecamere vedono punti diversi</translation>
    </message>
    <message>
        <source>cut by the picture&apos;s edge</source>
        <translation>tagliato dal bordo dell&apos;immagine</translation>
    </message>
    <message>
        <source>hidden from the left camera</source>
        <translation>nascosto alla telecamera sinistra</translation>
    </message>
    <message>
        <source>hidden from the right camera</source>
        <translation>nascosto alla telecamera destra</translation>
    </message>
    <message>
        <source>measured again in a later view</source>
        <translation>misurato di nuovo in una vista successiva</translation>
    </message>
    <message>
        <source>more than one spot</source>
        <translation>più di un punto</translation>
    </message>
    <message>
        <source>no spot in either camera</source>
        <translation>nessun punto nelle due telecamere</translation>
    </message>
    <message>
        <source>on a mark of the table&apos;s rim</source>
        <translation>su una tacca del bordo della tavola</translation>
    </message>
    <message>
        <source>on the table</source>
        <translation>sulla tavola</translation>
    </message>
    <message>
        <source>outside the volume</source>
        <translation>fuori dal volume</translation>
    </message>
    <message>
        <source>picture lost</source>
        <translation>immagine persa</translation>
    </message>
    <message>
        <source>picture too bright</source>
        <translation>immagine troppo chiara</translation>
    </message>
    <message>
        <source>picture torn</source>
        <translation>immagine spezzata</translation>
    </message>
    <message>
        <source>spot overexposed</source>
        <translation>punto sovraesposto</translation>
    </message>
    <message>
        <source>spot smeared along the surface</source>
        <translation>punto strisciato sulla superficie</translation>
    </message>
    <message>
        <source>spot too dim</source>
        <translation>punto troppo debole</translation>
    </message>
    <message>
        <source>spot too large</source>
        <translation>punto troppo grande</translation>
    </message>
    <message>
        <source>spot too small</source>
        <translation>punto troppo piccolo</translation>
    </message>
    <message>
        <source>taken out by hand</source>
        <translation>tolto a mano</translation>
    </message>
</context>
<context>
    <name>reconstruction</name>
    <message>
        <source>About {triangles} triangles, expected error about {n} µm.</source>
        <translation>Circa {triangles} triangoli, errore atteso circa {n} µm.</translation>
    </message>
    <message>
        <source>About {triangles} triangles, expected error about {n} µm: rounder, but no more certain.</source>
        <translation>Circa {triangles} triangoli, errore atteso circa {n} µm: più tonda, ma non più certa.</translation>
    </message>
    <message>
        <source>About {triangles} triangles.</source>
        <translation>Circa {triangles} triangoli.</translation>
    </message>
    <message>
        <source>As many triangles as a tolerance of {n} µm needs (set under Expert).</source>
        <translation>Tanti triangoli quanti ne richiede una tolleranza di {n} µm (vedi Avanzate).</translation>
    </message>
    <message>
        <source>Closed and whole: points support all of it.</source>
        <translation>Chiusa e intera: tutta sostenuta dai punti.</translation>
    </message>
    <message>
        <source>Closed and whole; {share} % of the points did not belong to it and were left out.</source>
        <translation>Chiusa e intera; il {share} % dei punti non le apparteneva ed è stato escluso.</translation>
    </message>
    <message>
        <source>Closed; {share} % of it was not scanned and is only bridged.</source>
        <translation>Chiusa; il {share} % non è stato scansionato ed è solo colmato.</translation>
    </message>
    <message>
        <source>Kept early: closed and whole, but coarser than the points allow.</source>
        <translation>Fermata prima: chiusa e intera, ma più grossolana di quanto i punti consentano.</translation>
    </message>
    <message>
        <source>Left open where nothing was scanned, as it was asked for.</source>
        <translation>Lasciata aperta dove non si è scansionato, come richiesto.</translation>
    </message>
    <message>
        <source>No order number</source>
        <translation>Senza numero d&apos;ordine</translation>
    </message>
    <message>
        <source>The points carry the number of triangles.</source>
        <translation>I punti reggono il numero di triangoli.</translation>
    </message>
    <message>
        <source>{order} · {side}</source>
        <translation>{order} · {side}</translation>
    </message>
    <message>
        <source>{order}: being finished</source>
        <translation>{order}: si termina</translation>
    </message>
    <message>
        <source>{order}: reconstructing</source>
        <translation>{order}: in ricostruzione</translation>
    </message>
    <message>
        <source>{order}: reconstructing, {left} left</source>
        <translation>{order}: in ricostruzione, ancora {left}</translation>
    </message>
    <message>
        <source>{order}: reconstructing, {left} left, {count} waiting</source>
        <translation>{order}: in ricostruzione, ancora {left}, {count} in attesa</translation>
    </message>
</context>
<context>
    <name>reject_advice</name>
    <message>
        <source>Check the trigger cable of the cameras (Rig).</source>
        <translation>Controllare il cavo di trigger delle telecamere (Banco).</translation>
    </message>
    <message>
        <source>Focus the lenses on the object (Aim).</source>
        <translation>Mettere a fuoco gli obiettivi sull&apos;oggetto (Puntamento).</translation>
    </message>
    <message>
        <source>Lengthen the exposure (Aim), or dust the object with a matt white powder.</source>
        <translation>Aumentare l&apos;esposizione (Puntamento), o opacizzare l&apos;oggetto con polvere bianca.</translation>
    </message>
    <message>
        <source>Move the object to the middle of the table.</source>
        <translation>Spostare l&apos;oggetto al centro della tavola.</translation>
    </message>
    <message>
        <source>Normal at the edges of the object, where the beam passes it.</source>
        <translation>Normale ai bordi dell&apos;oggetto, dove il raggio lo oltrepassa.</translation>
    </message>
    <message>
        <source>Normal at the edges; if there are many, defocus the lenses a little (Aim).</source>
        <translation>Normale ai bordi; se sono molti, sfocare un poco gli obiettivi (Puntamento).</translation>
    </message>
    <message>
        <source>Normal in small numbers; if there are many, check the calibration (Rig).</source>
        <translation>Normale in piccolo numero; se sono molti, controllare la calibrazione (Banco).</translation>
    </message>
    <message>
        <source>Normal on steep flanks; another mount turns them towards the laser.</source>
        <translation>Normale sui fianchi ripidi; un altro posizionamento li gira verso il laser.</translation>
    </message>
    <message>
        <source>Normal: the beam met a mark of the table&apos;s rim.</source>
        <translation>Normale: il raggio ha colpito una tacca del bordo della tavola.</translation>
    </message>
    <message>
        <source>Normal: the beam met the table beside the object.</source>
        <translation>Normale: il raggio ha colpito la tavola accanto all&apos;oggetto.</translation>
    </message>
    <message>
        <source>Pictures come damaged: plug each camera into a USB port of its own.</source>
        <translation>Le immagini arrivano guaste: collegare ogni telecamera a una sua porta USB.</translation>
    </message>
    <message>
        <source>Pictures get lost: plug each camera into a USB port of its own, and close other programs.</source>
        <translation>Si perdono immagini: collegare ogni telecamera a una sua porta USB, e chiudere altri programmi.</translation>
    </message>
    <message>
        <source>Shorten the exposure (Aim), or dust shiny places with a matt powder.</source>
        <translation>Ridurre l&apos;esposizione (Puntamento), o opacizzare i punti lucidi con polvere.</translation>
    </message>
    <message>
        <source>Something mirrors the laser: dust it with matt powder, or cover what shines beside the object.</source>
        <translation>Qualcosa riflette il laser: opacizzarlo con polvere, o coprire ciò che luccica accanto all&apos;oggetto.</translation>
    </message>
    <message>
        <source>Switch off lamps, keep the sun away, close the lid.</source>
        <translation>Spegnere le lampade, tenere lontano il sole, chiudere il coperchio.</translation>
    </message>
    <message>
        <source>The object stands in the camera&apos;s way: another mount shows what is hidden.</source>
        <translation>L&apos;oggetto copre la vista alla telecamera: un altro posizionamento mostra il nascosto.</translation>
    </message>
</context>
<context>
    <name>remarks</name>
    <message>
        <source>The body that stands on the table could not be filled; the base was closed by what the points alone enclose.</source>
        <translation>Il corpo che sta sulla tavola non si è potuto riempire; la base è stata chiusa da ciò che i soli punti racchiudono.</translation>
    </message>
    <message>
        <source>The coordinates are rounded to steps of {step_mm} mm, single precision far from the origin; export the points in double precision, or nearer to the origin.</source>
        <translation>Le coordinate sono arrotondate a passi di {step_mm} mm, singola precisione lontano dall&apos;origine; esportare i punti in doppia precisione, o più vicino all&apos;origine.</translation>
    </message>
    <message>
        <source>The object is only {extent_mm} mm large, less than an anatomical part: if the coordinates are {unit}, use --units {option}.</source>
        <translation>L&apos;oggetto è grande solo {extent_mm} mm, meno di una parte anatomica: se le coordinate sono in {unit}, usare --units {option}.</translation>
    </message>
    <message>
        <source>The object is {extent_mm} mm large, more than any anatomical part: if the coordinates are micrometres, divide them by 1000; if they are millimetres, use --units mm.</source>
        <translation>L&apos;oggetto è grande {extent_mm} mm, più di ogni parte anatomica: se le coordinate sono in micrometri, dividerle per 1000; se in millimetri, usare --units mm.</translation>
    </message>
    <message>
        <source>The object lies {away_mm} mm from the origin; it was computed about its centre, so that no precision was lost.</source>
        <translation>L&apos;oggetto sta a {away_mm} mm dall&apos;origine; è stato calcolato attorno al suo centro, senza perdita di precisione.</translation>
    </message>
    <message>
        <source>{count} points ({share}) lie more than {link_mm} mm from the object; they were left out as strays.</source>
        <translation>{count} punti ({share}) stanno a più di {link_mm} mm dall&apos;oggetto; sono stati esclusi come estranei.</translation>
    </message>
    <message>
        <source>{share} % of the closed surface was not scanned; it is capped and marked as unsupported.</source>
        <translation>Il {share} % della superficie chiusa non è stato scansionato; è colmato e segnato come non sostenuto.</translation>
    </message>
    <message>
        <source>{share} % of the closed surface was not scanned; it is left open.</source>
        <translation>Il {share} % della superficie chiusa non è stato scansionato; è lasciato aperto.</translation>
    </message>
    <message>
        <source>{share} % of the points do not belong to the surface and were rejected.</source>
        <translation>Il {share} % dei punti non appartiene alla superficie ed è stato scartato.</translation>
    </message>
    <message>
        <source>{share} of the points repeat others exactly; each place was counted once.</source>
        <translation>{share} dei punti ne ripetono altri esattamente; ogni posizione è contata una volta.</translation>
    </message>
</context>
<context>
    <name>remedies</name>
    <message>
        <source>A reset was sent to switch the laser off; see that it is dark, check cable and power, then try again.</source>
        <translation>È stato inviato un reset per spegnere il laser; accertarsi che sia spento, controllare cavo e alimentazione, poi riprovare.</translation>
    </message>
    <message>
        <source>A reset was sent; check the cable (length, shield, plugs), then try again.</source>
        <translation>È stato inviato un reset; controllare il cavo (lunghezza, schermo, connettori), poi riprovare.</translation>
    </message>
    <message>
        <source>A sweep ends dark by itself, a standing spot may stay lit: see that the laser is off, plug it in, then try again.</source>
        <translation>Una passata si spegne da sé, un punto fermo può restare acceso: accertarsi che il laser sia spento, ricollegare, poi riprovare.</translation>
    </message>
    <message>
        <source>Nothing was measured; choose another size or pixel format, or another camera.</source>
        <translation>Niente è stato misurato; scegliere un&apos;altra dimensione o un altro formato di pixel, o un&apos;altra telecamera.</translation>
    </message>
    <message>
        <source>Nothing was measured; take the lens cap off, open the shutter, or lengthen its exposure.</source>
        <translation>Niente è stato misurato; togliere il tappo, aprire l&apos;otturatore, o aumentarne l&apos;esposizione.</translation>
    </message>
    <message>
        <source>Nothing was moved; if it should be the controller, it has to be given GRBL first.</source>
        <translation>Niente è stato mosso; se dev&apos;essere il controllore, prima va dotato di GRBL.</translation>
    </message>
    <message>
        <source>Nothing was moved; if it should be the controller, see that it has power and that the cable carries data, then try again.</source>
        <translation>Niente è stato mosso; se dev&apos;essere il controllore, accertarsi che sia alimentato e il cavo porti dati, poi riprovare.</translation>
    </message>
    <message>
        <source>Nothing was moved; plug it in, then try again.</source>
        <translation>Niente è stato mosso; collegare, poi riprovare.</translation>
    </message>
    <message>
        <source>Nothing was moved; plug the controller in again, then try again.</source>
        <translation>Niente è stato mosso; ricollegare il controllore, poi riprovare.</translation>
    </message>
    <message>
        <source>Nothing was moved; such a rig needs a rig file that names one of these as &apos;table_axis&apos;.</source>
        <translation>Niente è stato mosso; un tale banco richiede un file che indichi uno di questi come &apos;table_axis&apos;.</translation>
    </message>
    <message>
        <source>The laser is off; check its cable, then try again.</source>
        <translation>Il laser è spento; controllarne il cavo, poi riprovare.</translation>
    </message>
    <message>
        <source>The laser is off; check the trigger cable, or let the cameras run freely.</source>
        <translation>Il laser è spento; controllare il cavo di trigger, o lasciare libere le telecamere.</translation>
    </message>
    <message>
        <source>The laser is off; close other programs, then try again.</source>
        <translation>Il laser è spento; chiudere altri programmi, poi riprovare.</translation>
    </message>
    <message>
        <source>The laser is off; close the door, then try again.</source>
        <translation>Il laser è spento; chiudere lo sportello, poi riprovare.</translation>
    </message>
    <message>
        <source>The laser is off; its position is lost: home it, then try again.</source>
        <translation>Il laser è spento; la posizione è persa: cercare il riferimento, poi riprovare.</translation>
    </message>
    <message>
        <source>The laser is off; plug it in, then try again.</source>
        <translation>Il laser è spento; ricollegare, poi riprovare.</translation>
    </message>
    <message>
        <source>The laser is off; try again when the rig is free.</source>
        <translation>Il laser è spento; riprovare quando il banco è libero.</translation>
    </message>
    <message>
        <source>The laser is off; unplug the camera, plug it in again, then try again.</source>
        <translation>Il laser è spento; scollegare la telecamera, ricollegarla, poi riprovare.</translation>
    </message>
    <message>
        <source>The laser is off; {remedy}.</source>
        <translation>Il laser è spento; {remedy}.</translation>
    </message>
    <message>
        <source>The laser was switched off; free the machine of other work, then try again.</source>
        <translation>Il laser è stato spento; liberare il computer da altro lavoro, poi riprovare.</translation>
    </message>
</context>
<context>
    <name>rig</name>
    <message>
        <source>5 times</source>
        <translation>5 volte</translation>
    </message>
    <message>
        <source>As fast as it can</source>
        <translation>Massima</translation>
    </message>
    <message>
        <source>Bench: 604 × 294 px at 435 mm</source>
        <translation>Bench: 604 × 294 a 435 mm</translation>
    </message>
    <message>
        <source>Both ears on a pair tray</source>
        <translation>Due orecchie su vassoio doppio</translation>
    </message>
    <message>
        <source>Dental arch</source>
        <translation>Arcata dentaria</translation>
    </message>
    <message>
        <source>Ear impression</source>
        <translation>Impronta auricolare</translation>
    </message>
    <message>
        <source>Heart</source>
        <translation>Cuore</translation>
    </message>
    <message>
        <source>Paper 2003: the published rig at 770 mm</source>
        <translation>Paper 2003: il banco pubblicato, a 770 mm</translation>
    </message>
    <message>
        <source>Real time</source>
        <translation>Tempo reale</translation>
    </message>
    <message>
        <source>Reference sphere</source>
        <translation>Sfera di riferimento</translation>
    </message>
    <message>
        <source>Workshop: 1440 × 1080 px at 600 mm</source>
        <translation>Workshop: 1440 × 1080 px a 600 mm</translation>
    </message>
    <message>
        <source>{rig}  (the file is missing)</source>
        <translation>{rig}  (il file manca)</translation>
    </message>
</context>
<context>
    <name>rig-faults</name>
    <message>
        <source>ALARM:1 (limit switch)</source>
        <translation>ALARM:1 (finecorsa)</translation>
    </message>
    <message>
        <source>ALARM:2 (soft limit)</source>
        <translation>ALARM:2 (limite software)</translation>
    </message>
    <message>
        <source>ALARM:3 (reset in a move)</source>
        <translation>ALARM:3 (reset in moto)</translation>
    </message>
    <message>
        <source>Camera bumped</source>
        <translation>Telecamera urtata</translation>
    </message>
    <message>
        <source>Camera stalled</source>
        <translation>Telecamera bloccata</translation>
    </message>
    <message>
        <source>Camera unplugged</source>
        <translation>Telecamera scollegata</translation>
    </message>
    <message>
        <source>Cameras out of step</source>
        <translation>Telecamere sfasate</translation>
    </message>
    <message>
        <source>Case locked</source>
        <translation>Caso occupato</translation>
    </message>
    <message>
        <source>Clock jump</source>
        <translation>Salto dell&apos;orologio</translation>
    </message>
    <message>
        <source>Controller reset</source>
        <translation>Reset del controllore</translation>
    </message>
    <message>
        <source>Disk full</source>
        <translation>Disco pieno</translation>
    </message>
    <message>
        <source>E-JOB-01; the points are safe, a new worker is started</source>
        <translation>E-JOB-01; i punti sono al sicuro, un nuovo processo è avviato</translation>
    </message>
    <message>
        <source>E-JOB-02 or E-JOB-01; the points are safe</source>
        <translation>E-JOB-02 o E-JOB-01; i punti sono al sicuro</translation>
    </message>
    <message>
        <source>Frames dropped</source>
        <translation>Immagini perse</translation>
    </message>
    <message>
        <source>Frames late</source>
        <translation>Immagini in ritardo</translation>
    </message>
    <message>
        <source>Frames torn</source>
        <translation>Immagini spezzate</translation>
    </message>
    <message>
        <source>Lamp on</source>
        <translation>Lampada accesa</translation>
    </message>
    <message>
        <source>Lenses warm</source>
        <translation>Obiettivi caldi</translation>
    </message>
    <message>
        <source>Lid opened</source>
        <translation>Coperchio aperto</translation>
    </message>
    <message>
        <source>Lost ok</source>
        <translation>ok perso</translation>
    </message>
    <message>
        <source>Mark knocked off</source>
        <translation>Tacca staccata</translation>
    </message>
    <message>
        <source>Partial lines</source>
        <translation>Righe parziali</translation>
    </message>
    <message>
        <source>Port gone</source>
        <translation>Porta sparita</translation>
    </message>
    <message>
        <source>Port gone and back</source>
        <translation>Porta sparita e tornata</translation>
    </message>
    <message>
        <source>Program killed</source>
        <translation>Programma ucciso</translation>
    </message>
    <message>
        <source>Serial noise</source>
        <translation>Rumore seriale</translation>
    </message>
    <message>
        <source>Shiny patch</source>
        <translation>Zona lucida</translation>
    </message>
    <message>
        <source>Steps lost</source>
        <translation>Passi persi</translation>
    </message>
    <message>
        <source>Trigger lost</source>
        <translation>Trigger perso</translation>
    </message>
    <message>
        <source>Worker killed</source>
        <translation>Processo ucciso</translation>
    </message>
    <message>
        <source>Worker out of memory</source>
        <translation>Processo senza memoria</translation>
    </message>
    <message>
        <source>a camera exposes 8 ms later than the other</source>
        <translation>una telecamera espone 8 ms dopo l&apos;altra</translation>
    </message>
    <message>
        <source>a camera hangs: no frame and no error comes any more</source>
        <translation>una telecamera si blocca: non arriva più né immagine né errore</translation>
    </message>
    <message>
        <source>a camera is turned by a small angle and stays so</source>
        <translation>una telecamera viene ruotata di un piccolo angolo e resta così</translation>
    </message>
    <message>
        <source>a camera loses a fifth of its frames</source>
        <translation>una telecamera perde un quinto delle immagini</translation>
    </message>
    <message>
        <source>a camera misses a trigger: its frames belong to the next exposure from then on</source>
        <translation>una telecamera perde un trigger: da allora le sue immagini sono dell&apos;esposizione successiva</translation>
    </message>
    <message>
        <source>a garbled report is asked for again and the scan goes on; a garbled ok ends it with E-MOT-01</source>
        <translation>un rapporto alterato è richiesto e la scansione continua; un ok alterato la termina con E-MOT-01</translation>
    </message>
    <message>
        <source>a lamp shines into the cameras</source>
        <translation>una lampada illumina le telecamere</translation>
    </message>
    <message>
        <source>a limit switch is touched; nothing but a reset gets through</source>
        <translation>un finecorsa è toccato; passa solo un reset</translation>
    </message>
    <message>
        <source>a wet place on the object mirrors the beam: glare, and second spots</source>
        <translation>una zona bagnata dell&apos;oggetto riflette il raggio: bagliore e secondi punti</translation>
    </message>
    <message>
        <source>an &apos;ok&apos; of the controller gets lost on its way</source>
        <translation>un &apos;ok&apos; del controllore va perso per strada</translation>
    </message>
    <message>
        <source>another program tries to open the case; at the opening it holds it</source>
        <translation>un altro programma prova ad aprire il caso; all&apos;apertura lo tiene</translation>
    </message>
    <message>
        <source>both lenses get longer by a thousandth, so that everything is measured too large</source>
        <translation>i due obiettivi si allungano di un millesimo, e tutto è misurato troppo grande</translation>
    </message>
    <message>
        <source>ends with E-CAM-01 after 4 s; laser off, points kept</source>
        <translation>termina con E-CAM-01 dopo 4 s; laser spento, punti conservati</translation>
    </message>
    <message>
        <source>ends with E-CAM-02; laser off, points kept</source>
        <translation>termina con E-CAM-02; laser spento, punti conservati</translation>
    </message>
    <message>
        <source>ends with E-DISK-01; laser off, everything acknowledged is kept</source>
        <translation>termina con E-DISK-01; laser spento, tutto ciò che è confermato è conservato</translation>
    </message>
    <message>
        <source>ends with E-MOT-01, 2 s after the controller fell idle</source>
        <translation>termina con E-MOT-01, 2 s dopo che il controllore è a riposo</translation>
    </message>
    <message>
        <source>ends with E-MOT-02; a sweep ends dark by itself</source>
        <translation>termina con E-MOT-02; una passata si spegne da sé</translation>
    </message>
    <message>
        <source>ends with E-MOT-02; the next start works</source>
        <translation>termina con E-MOT-02; il prossimo avvio funziona</translation>
    </message>
    <message>
        <source>ends with E-MOT-05</source>
        <translation>termina con E-MOT-05</translation>
    </message>
    <message>
        <source>ends with E-MOT-09; dark by the restart</source>
        <translation>termina con E-MOT-09; spento dal riavvio</translation>
    </message>
    <message>
        <source>ends with E-MOT-16; the controller itself stops and darkens the beam</source>
        <translation>termina con E-MOT-16; il controllore stesso si ferma e spegne il raggio</translation>
    </message>
    <message>
        <source>for 10 s one byte in a hundred of the controller&apos;s answers is changed, or another one comes in between</source>
        <translation>per 10 s un byte su cento delle risposte del controllore cambia, o ne arriva un altro in mezzo</translation>
    </message>
    <message>
        <source>for 10 s the worker process gets no more memory; the time counts from the start of the reconstruction</source>
        <translation>per 10 s il processo di calcolo non riceve più memoria; il tempo conta dall&apos;inizio della ricostruzione</translation>
    </message>
    <message>
        <source>for 20 s the controller&apos;s answers come in pieces of 5 bytes with pauses of 20 ms</source>
        <translation>per 20 s le risposte del controllore arrivano in pezzi di 5 byte con pause di 20 ms</translation>
    </message>
    <message>
        <source>goes on</source>
        <translation>continua</translation>
    </message>
    <message>
        <source>goes on, the other program is refused; a case that the other holds is refused with E-CASE-02</source>
        <translation>continua, l&apos;altro programma è rifiutato; un caso tenuto dall&apos;altro è rifiutato con E-CASE-02</translation>
    </message>
    <message>
        <source>goes on; H-EPI-01 when it moved across the epipolar lines, H-VIEW-02 when along them</source>
        <translation>continua; H-EPI-01 se si è mossa attraverso le linee epipolari, H-VIEW-02 se lungo di esse</translation>
    </message>
    <message>
        <source>goes on; H-MARK-03 where the rig has marks, else nothing tells</source>
        <translation>continua; H-MARK-03 se il banco ha tacche, altrimenti niente lo dice</translation>
    </message>
    <message>
        <source>goes on; H-MARK-05</source>
        <translation>continua; H-MARK-05</translation>
    </message>
    <message>
        <source>goes on; H-SYN-01</source>
        <translation>continua; H-SYN-01</translation>
    </message>
    <message>
        <source>goes on; H-SYN-02</source>
        <translation>continua; H-SYN-02</translation>
    </message>
    <message>
        <source>goes on; H-TAB-01</source>
        <translation>continua; H-TAB-01</translation>
    </message>
    <message>
        <source>goes on; every frame is waited for</source>
        <translation>continua; si attende ogni immagine</translation>
    </message>
    <message>
        <source>goes on; glare is rejected as saturated, second spots are settled by the other camera or ambiguous</source>
        <translation>continua; il bagliore è scartato come saturo, i secondi punti sono decisi dall&apos;altra telecamera o ambigui</translation>
    </message>
    <message>
        <source>goes on; no duration, rate or deadline is touched</source>
        <translation>continua; nessuna durata, frequenza o scadenza ne risente</translation>
    </message>
    <message>
        <source>goes on; rejected as dropped_frame, H-CAM-01</source>
        <translation>continua; scartati come dropped_frame, H-CAM-01</translation>
    </message>
    <message>
        <source>goes on; rejected as too_bright, H-LGT-01</source>
        <translation>continua; scartati come too_bright, H-LGT-01</translation>
    </message>
    <message>
        <source>goes on; torn frames are rejected, H-CAM-03</source>
        <translation>continua; le immagini spezzate sono scartate, H-CAM-03</translation>
    </message>
    <message>
        <source>in a tenth of a camera&apos;s frames the lower half is another exposure&apos;s, or garbage</source>
        <translation>in un decimo delle immagini di una telecamera la metà inferiore è di un&apos;altra esposizione, o casuale</translation>
    </message>
    <message>
        <source>is gone; the guardian darkens a real laser within 0.6 s, everything acknowledged is kept</source>
        <translation>sparisce; il guardiano spegne un laser vero entro 0.6 s, tutto ciò che è confermato è conservato</translation>
    </message>
    <message>
        <source>one of the balls on the table&apos;s rim is knocked off; nothing where the rig has no marks</source>
        <translation>una delle sfere del bordo della tavola è staccata; niente se il banco non ha tacche</translation>
    </message>
    <message>
        <source>the board&apos;s reset button is pressed in the middle of a move</source>
        <translation>il pulsante di reset della scheda è premuto durante un moto</translation>
    </message>
    <message>
        <source>the cable of a camera comes off</source>
        <translation>il cavo di una telecamera si stacca</translation>
    </message>
    <message>
        <source>the computer&apos;s clock jumps back by an hour</source>
        <translation>l&apos;orologio del computer torna indietro di un&apos;ora</translation>
    </message>
    <message>
        <source>the controller believes that a move leaves the travel of its axes</source>
        <translation>il controllore crede che un moto esca dalla corsa dei suoi assi</translation>
    </message>
    <message>
        <source>the controller&apos;s cable comes off and stays off</source>
        <translation>il cavo del controllore si stacca e resta staccato</translation>
    </message>
    <message>
        <source>the controller&apos;s cable comes off, and is plugged in again after 3 s</source>
        <translation>il cavo del controllore si stacca, ed è ricollegato dopo 3 s</translation>
    </message>
    <message>
        <source>the controller&apos;s supply breaks down in the middle of a move; it starts anew and has lost its position</source>
        <translation>l&apos;alimentazione del controllore cade durante un moto; riparte e ha perso la posizione</translation>
    </message>
    <message>
        <source>the frames of a camera arrive 0.4 s late, with the right ids and time stamps</source>
        <translation>le immagini di una telecamera arrivano con 0.4 s di ritardo, con id e tempi giusti</translation>
    </message>
    <message>
        <source>the lid is opened, and closed after 10 s</source>
        <translation>il coperchio è aperto, e chiuso dopo 10 s</translation>
    </message>
    <message>
        <source>the program is killed (SIGKILL)</source>
        <translation>il programma è ucciso (SIGKILL)</translation>
    </message>
    <message>
        <source>the table&apos;s motor loses steps in its next move, unknown to the controller</source>
        <translation>il motore della tavola perde passi nel prossimo moto, senza che il controllore lo sappia</translation>
    </message>
    <message>
        <source>the worker process is killed; the time counts from the start of the reconstruction</source>
        <translation>il processo di calcolo è ucciso; il tempo conta dall&apos;inizio della ricostruzione</translation>
    </message>
    <message>
        <source>there is no space left on the disk of the case</source>
        <translation>non c&apos;è più spazio sul disco del caso</translation>
    </message>
</context>
<context>
    <name>sentences</name>
    <message>
        <source>A camera moved by about {shift_px} px: since the view at {table_deg} deg the marks on the table&apos;s rim are seen {shift_um} um beside.</source>
        <translation>Una telecamera si è mossa di circa {shift_px} px: dalla vista a {table_deg} deg le tacche del bordo della tavola si vedono spostate di {shift_um} um.</translation>
    </message>
    <message>
        <source>A camera moved or the object moved: the view at {table_deg} deg lies {shift_um} um beside the earlier ones ({direction}).</source>
        <translation>Una telecamera o l&apos;oggetto si è mosso: la vista a {table_deg} deg sta a {shift_um} um dalle precedenti ({direction}).</translation>
    </message>
    <message>
        <source>A camera moved: the views from {table_deg} deg on lie {shift_um} um beside the earlier ones ({direction}, always as seen by the cameras).</source>
        <translation>Una telecamera si è mossa: le viste da {table_deg} deg in poi stanno a {shift_um} um dalle precedenti ({direction}, sempre come vede la telecamera).</translation>
    </message>
    <message>
        <source>A camera or the object moved on the way; fix both, and scan again.</source>
        <translation>Una telecamera o l&apos;oggetto si è mosso durante la scansione; fissare entrambi e ripetere la scansione.</translation>
    </message>
    <message>
        <source>A camera was moved across the epipolar lines by about {shift_px} px ({where}; noticed after {points} points).</source>
        <translation>Una telecamera si è spostata attraverso le linee epipolari di circa {shift_px} px ({where}; notato dopo {points} punti).</translation>
    </message>
    <message>
        <source>A mesh of {triangles} triangles is too large to be kept in {path}.</source>
        <translation>Una mesh di {triangles} triangoli è troppo grande per essere conservata in {path}.</translation>
    </message>
    <message>
        <source>A reset was sent and the points so far are kept; check the cable (length, shield, plugs) and resume.</source>
        <translation>È stato inviato un reset e i punti finora sono conservati; controllare il cavo (lunghezza, schermo, connettori) e riprendere.</translation>
    </message>
    <message>
        <source>A reset was sent to switch it off; see that it is dark, then check the controller&apos;s laser mode ($32).</source>
        <translation>È stato inviato un reset per spegnerlo; accertarsi che sia spento, poi controllare il modo laser del controllore ($32).</translation>
    </message>
    <message>
        <source>A reset was sent to switch the laser off and the points so far are kept; see that it is dark, check cable and power, then resume.</source>
        <translation>È stato inviato un reset per spegnere il laser e i punti finora sono conservati; accertarsi che sia spento, controllare cavo e alimentazione, poi riprendere.</translation>
    </message>
    <message>
        <source>A rig needs a controller and two cameras that work; what was found: {controller}, cameras: {cameras}.</source>
        <translation>Un banco richiede un controllore e due telecamere funzionanti; trovati: {controller}, telecamere: {cameras}.</translation>
    </message>
    <message>
        <source>A scan by a laser line is not steered by the uncertainty that it reaches.</source>
        <translation>Una scansione a linea laser non si può guidare con l&apos;incertezza raggiunta.</translation>
    </message>
    <message>
        <source>All lengths are off by as much; calibrate, or check &apos;distances_mm&apos; in the table [marks] of the rig file.</source>
        <translation>Tutte le lunghezze sono errate di altrettanto; calibrare, o controllare &apos;distances_mm&apos; nella tabella [marks] del file del banco.</translation>
    </message>
    <message>
        <source>All points are kept in {path}; pick three points on both mounts (&apos;impronta register CASE --pairs FILE&apos;), or scan another mount that shares more with the earlier ones.</source>
        <translation>Tutti i punti sono conservati in {path}; scegliere tre punti sui due posizionamenti (&apos;impronta register CASE --pairs FILE&apos;), o scansionarne un altro che abbia più in comune con i precedenti.</translation>
    </message>
    <message>
        <source>All points are kept; measure another mount that shares more.</source>
        <translation>Tutti i punti sono conservati; misurare un altro posizionamento che abbia più in comune.</translation>
    </message>
    <message>
        <source>Both cameras of the rig file are the same one ({id}).</source>
        <translation>Le due telecamere del file del banco sono la stessa ({id}).</translation>
    </message>
    <message>
        <source>Both files are untouched and nothing was mirrored; choose the same side, or export the mirrored one again without mirroring.</source>
        <translation>I due file sono intatti e niente è stato specchiato; scegliere lo stesso lato, o esportare di nuovo quello speculare senza specchiarlo.</translation>
    </message>
    <message>
        <source>Both files are untouched; check that they show the same object and that the normals of both point outwards, then pick three points on both.</source>
        <translation>I due file sono intatti; controllare che mostrino lo stesso oggetto e che le normali di entrambi guardino in fuori, poi scegliere tre punti su entrambi.</translation>
    </message>
    <message>
        <source>Both files are untouched; let the program find the pose, or pick three points on both.</source>
        <translation>I due file sono intatti; lasciare che il programma trovi la posa, o scegliere tre punti su entrambi.</translation>
    </message>
    <message>
        <source>Camera {camera} ({id}) cannot be opened: {reason}.</source>
        <translation>La telecamera {camera} ({id}) non si apre: {reason}.</translation>
    </message>
    <message>
        <source>Camera {camera} ({id}) is used by another program.</source>
        <translation>La telecamera {camera} ({id}) è usata da un altro programma.</translation>
    </message>
    <message>
        <source>Camera {camera} cannot be triggered by {line}; it has: {lines}.</source>
        <translation>La telecamera {camera} non si può comandare con il trigger {line}; ha: {lines}.</translation>
    </message>
    <message>
        <source>Camera {camera} delivered frames faster than they could be evaluated: {frames} frames are waiting.</source>
        <translation>La telecamera {camera} ha fornito immagini più in fretta di quanto si potessero valutare: {frames} immagini attendono.</translation>
    </message>
    <message>
        <source>Camera {camera} delivered {count} torn frames of {exposures}: part of each is another exposure&apos;s, or no picture.</source>
        <translation>La telecamera {camera} ha fornito {count} immagini spezzate su {exposures}: una parte è di un&apos;altra esposizione, o non è immagine.</translation>
    </message>
    <message>
        <source>Camera {camera} did not deliver {count} of {exposures} frames ({share} % of the last ones).</source>
        <translation>La telecamera {camera} non ha fornito {count} immagini su {exposures} ({share} % delle ultime).</translation>
    </message>
    <message>
        <source>Camera {camera} gave no frame within {seconds} s.</source>
        <translation>La telecamera {camera} non ha dato immagini entro {seconds} s.</translation>
    </message>
    <message>
        <source>Camera {camera} gives black frames.</source>
        <translation>La telecamera {camera} dà immagini nere.</translation>
    </message>
    <message>
        <source>Camera {camera} gives frames of another kind than can be measured: {reason}.</source>
        <translation>La telecamera {camera} dà immagini di un tipo che non si può misurare: {reason}.</translation>
    </message>
    <message>
        <source>Camera {camera} gives {measured_hz} frames/s where {wanted_hz} were asked for.</source>
        <translation>La telecamera {camera} dà {measured_hz} immagini/s dove ne erano chieste {wanted_hz}.</translation>
    </message>
    <message>
        <source>Camera {camera} is blind: {frames} spots in a row were seen by camera {other} alone.</source>
        <translation>La telecamera {camera} non vede: {frames} punti di seguito sono stati visti solo dalla telecamera {other}.</translation>
    </message>
    <message>
        <source>Camera {camera} is driven through OpenCV, which cannot trigger it by {trigger}.</source>
        <translation>La telecamera {camera} è gestita da OpenCV, che non può comandarla con {trigger}.</translation>
    </message>
    <message>
        <source>Camera {camera} reported a fault: {reason}.</source>
        <translation>La telecamera {camera} ha segnalato un guasto: {reason}.</translation>
    </message>
    <message>
        <source>Camera {camera} was unplugged.</source>
        <translation>La telecamera {camera} è stata scollegata.</translation>
    </message>
    <message>
        <source>Camera {camera} was used after it had been closed.</source>
        <translation>La telecamera {camera} è stata usata dopo la chiusura.</translation>
    </message>
    <message>
        <source>DICOM files are written by the package pydicom, which is not installed.</source>
        <translation>I file DICOM sono scritti dal pacchetto pydicom, che non è installato.</translation>
    </message>
    <message>
        <source>Everything measured so far is safe and a new worker was started; run it again.</source>
        <translation>Quanto misurato finora è al sicuro ed è stato avviato un nuovo processo; eseguire di nuovo.</translation>
    </message>
    <message>
        <source>Everything measured so far is safe; send the log if it happens again.</source>
        <translation>Quanto misurato finora è al sicuro; se si ripete, inviare il registro.</translation>
    </message>
    <message>
        <source>Everything written before is kept; open it again.</source>
        <translation>Quanto scritto prima è conservato; aprirlo di nuovo.</translation>
    </message>
    <message>
        <source>Files of the kind &apos;{suffix}&apos; cannot be written.</source>
        <translation>I file di tipo &apos;{suffix}&apos; non si possono scrivere.</translation>
    </message>
    <message>
        <source>In the best pose the new mount stands where light to the earlier one passed: {share} % of it.</source>
        <translation>Nella posa migliore il nuovo posizionamento sta dove prima la luce passava: il {share} % di esso.</translation>
    </message>
    <message>
        <source>It contradicts the others: the loop of mounts would close with an error of {closure_um} um.</source>
        <translation>Contraddice gli altri: l&apos;anello dei posizionamenti si chiuderebbe con un errore di {closure_um} um.</translation>
    </message>
    <message>
        <source>It is left out of the list; correct the file or remove it.</source>
        <translation>È escluso dalla lista; correggere il file o rimuoverlo.</translation>
    </message>
    <message>
        <source>It is not used; take more views with the board filling the volume.</source>
        <translation>Non viene usata; prendere altre viste con la scacchiera che riempie il volume.</translation>
    </message>
    <message>
        <source>It was not touched; choose another name, or overwrite it with --force.</source>
        <translation>Non è stato toccato; scegliere un altro nome, o sovrascrivere con --force.</translation>
    </message>
    <message>
        <source>It was not touched; open it with the newer program.</source>
        <translation>Non è stato toccato; aprirlo con il programma più recente.</translation>
    </message>
    <message>
        <source>It was not touched; scan into a new case.</source>
        <translation>Non è stato toccato; scansionare in un nuovo caso.</translation>
    </message>
    <message>
        <source>It was switched off again; check the controller&apos;s settings $30 to $32.</source>
        <translation>È stato spento di nuovo; controllare le impostazioni da $30 a $32 del controllore.</translation>
    </message>
    <message>
        <source>Its points are kept; fix cameras and object, then scan again.</source>
        <translation>I suoi punti sono conservati; fissare telecamere e oggetto, poi ripetere la scansione.</translation>
    </message>
    <message>
        <source>Its points may be right; a shape without rotational symmetry would tell.</source>
        <translation>I suoi punti possono essere giusti; lo direbbe una forma senza simmetria di rotazione.</translation>
    </message>
    <message>
        <source>Its surface lies nowhere over that of the others.</source>
        <translation>La sua superficie non sta in nessun punto su quella degli altri.</translation>
    </message>
    <message>
        <source>Lengths from there on are off by as much; let the cameras warm up, calibrate, and scan again.</source>
        <translation>Da lì in poi le lunghezze sono errate di altrettanto; lasciare scaldare le telecamere, calibrare e ripetere la scansione.</translation>
    </message>
    <message>
        <source>Mark {number} on the table&apos;s rim was moved by {shift_um} um before the view at {table_deg} deg.</source>
        <translation>La tacca {number} del bordo della tavola si è spostata di {shift_um} um prima della vista a {table_deg} deg.</translation>
    </message>
    <message>
        <source>Mark {number} on the table&apos;s rim was not found at {table_deg} deg, where nothing should hide it.</source>
        <translation>La tacca {number} del bordo della tavola non è stata trovata a {table_deg} deg, dove niente dovrebbe nasconderla.</translation>
    </message>
    <message>
        <source>Mount {mount} was not joined to the others. {reason}</source>
        <translation>Il posizionamento {mount} non è stato unito agli altri. {reason}</translation>
    </message>
    <message>
        <source>Neither camera has seen the laser spot for {frames} exposures ({seconds} s), where the object was before.</source>
        <translation>Nessuna telecamera ha visto il punto laser per {frames} esposizioni ({seconds} s), dove prima c&apos;era l&apos;oggetto.</translation>
    </message>
    <message>
        <source>No mesh was written and the points are kept; {do}.</source>
        <translation>Nessuna mesh è stata scritta e i punti sono conservati; {do}.</translation>
    </message>
    <message>
        <source>No mesh was written; export the points again.</source>
        <translation>Nessuna mesh è stata scritta; esportare di nuovo i punti.</translation>
    </message>
    <message>
        <source>No mesh was written; reconstruct one object at a time, and cut the points of the others off.</source>
        <translation>Nessuna mesh è stata scritta; ricostruire un oggetto alla volta, e togliere i punti degli altri.</translation>
    </message>
    <message>
        <source>No mesh was written; scan more of the object.</source>
        <translation>Nessuna mesh è stata scritta; scansionare di più dell&apos;oggetto.</translation>
    </message>
    <message>
        <source>No mesh was written; scan the object from more sides.</source>
        <translation>Nessuna mesh è stata scritta; scansionare l&apos;oggetto da più lati.</translation>
    </message>
    <message>
        <source>No part of the surface in {path} was measured: its vertices all say that nothing supports them.</source>
        <translation>Nessuna parte della superficie in {path} è stata misurata: tutti i suoi vertici risultano senza sostegno.</translation>
    </message>
    <message>
        <source>No rig file was written; &apos;impronta doctor --find&apos; says what became of every port and camera.</source>
        <translation>Nessun file del banco è stato scritto; &apos;impronta doctor --find&apos; dice com&apos;è andata con ogni porta e telecamera.</translation>
    </message>
    <message>
        <source>No sphere of {radius_mm} mm radius was found: {points} points were measured, {share} % of them lie on the best candidate.</source>
        <translation>Nessuna sfera di {radius_mm} mm di raggio trovata: {points} punti misurati, il {share} % sta sulla candidata migliore.</translation>
    </message>
    <message>
        <source>No surface was found: of {planned} planned measurements none gave a point ({reasons}).</source>
        <translation>Nessuna superficie trovata: di {planned} misure previste nessuna ha dato un punto ({reasons}).</translation>
    </message>
    <message>
        <source>No trigger reached camera {camera} on {line} within {seconds} s.</source>
        <translation>Nessun trigger è arrivato alla telecamera {camera} su {line} entro {seconds} s.</translation>
    </message>
    <message>
        <source>Nobody can place the artefacts of the test.</source>
        <translation>Nessuno può collocare i campioni della prova.</translation>
    </message>
    <message>
        <source>Nothing answers on the port {port}.</source>
        <translation>Niente risponde sulla porta {port}.</translation>
    </message>
    <message>
        <source>Nothing is measured meanwhile; see to its lens cap, aperture and view.</source>
        <translation>Intanto non si misura; controllarne tappo, diaframma e visuale.</translation>
    </message>
    <message>
        <source>Nothing is measured meanwhile; see whether the beam is blocked, the laser is off, or the object fell over.</source>
        <translation>Intanto non si misura; vedere se il raggio è ostruito, il laser è spento o l&apos;oggetto è caduto.</translation>
    </message>
    <message>
        <source>Nothing is measured meanwhile; shorten the exposure or lower the laser&apos;s power.</source>
        <translation>Intanto non si misura; ridurre l&apos;esposizione o la potenza del laser.</translation>
    </message>
    <message>
        <source>Nothing is measured meanwhile; switch the lamp off.</source>
        <translation>Intanto non si misura; spegnere la lampada.</translation>
    </message>
    <message>
        <source>Nothing was changed; check the name.</source>
        <translation>Niente è stato cambiato; controllare il nome.</translation>
    </message>
    <message>
        <source>Nothing was changed; choose another folder or give permission.</source>
        <translation>Niente è stato cambiato; scegliere un&apos;altra cartella o dare il permesso.</translation>
    </message>
    <message>
        <source>Nothing was changed; close it there, or choose another case.</source>
        <translation>Niente è stato cambiato; chiuderlo lì, o scegliere un altro caso.</translation>
    </message>
    <message>
        <source>Nothing was changed; mark more of the tooth.</source>
        <translation>Niente è stato cambiato; segnare di più del dente.</translation>
    </message>
    <message>
        <source>Nothing was changed; paint more, or use the automatic frame.</source>
        <translation>Niente è stato cambiato; dipingere di più, o usare il riferimento automatico.</translation>
    </message>
    <message>
        <source>Nothing was changed; pick at least three points far from each other, in the same order on both surfaces.</source>
        <translation>Niente è stato cambiato; scegliere almeno tre punti lontani fra loro, nello stesso ordine sulle due superfici.</translation>
    </message>
    <message>
        <source>Nothing was changed; write one line a point: mount, x, y, z on that mount, and x, y, z of the same place on the first mount, in mm.</source>
        <translation>Niente è stato cambiato; scrivere una riga per punto: posizionamento, x, y, z su di esso, e x, y, z dello stesso punto sul primo, in mm.</translation>
    </message>
    <message>
        <source>Nothing was changed; {do}.</source>
        <translation>Niente è stato cambiato; {do}.</translation>
    </message>
    <message>
        <source>Nothing was compared; choose the whole surface.</source>
        <translation>Niente è stato confrontato; scegliere la superficie intera.</translation>
    </message>
    <message>
        <source>Nothing was compared; export the mesh again from its program.</source>
        <translation>Niente è stato confrontato; esportare di nuovo la mesh dal suo programma.</translation>
    </message>
    <message>
        <source>Nothing was compared; mark the stable part again.</source>
        <translation>Niente è stato confrontato; segnare di nuovo la parte stabile.</translation>
    </message>
    <message>
        <source>Nothing was compared; scan it again, or reconstruct it from its points.</source>
        <translation>Niente è stato confrontato; scansionarla di nuovo, o ricostruirla dai suoi punti.</translation>
    </message>
    <message>
        <source>Nothing was done; check the file.</source>
        <translation>Niente è stato fatto; controllare il file.</translation>
    </message>
    <message>
        <source>Nothing was done; check the name.</source>
        <translation>Niente è stato fatto; controllare il nome.</translation>
    </message>
    <message>
        <source>Nothing was done; export the mesh again from its program.</source>
        <translation>Niente è stato fatto; esportare di nuovo la mesh dal suo programma.</translation>
    </message>
    <message>
        <source>Nothing was done; use PLY, XYZ, TXT, CSV, ASC, NPY or a case.</source>
        <translation>Niente è stato fatto; usare PLY, XYZ, TXT, CSV, ASC, NPY o un caso.</translation>
    </message>
    <message>
        <source>Nothing was done; use STL, PLY, OBJ, VTP or 3MF.</source>
        <translation>Niente è stato fatto; usare STL, PLY, OBJ, VTP o 3MF.</translation>
    </message>
    <message>
        <source>Nothing was joined and all points are kept; measure more of it.</source>
        <translation>Niente è stato unito e tutti i punti sono conservati; misurarne di più.</translation>
    </message>
    <message>
        <source>Nothing was joined and all points are kept; pick three points far from each other, in the same order on both.</source>
        <translation>Niente è stato unito e tutti i punti sono conservati; scegliere tre punti lontani fra loro, nello stesso ordine su entrambi.</translation>
    </message>
    <message>
        <source>Nothing was joined and all points are kept; pick three points on both, or measure another mount that shares more with the earlier ones.</source>
        <translation>Niente è stato unito e tutti i punti sono conservati; scegliere tre punti su entrambi, o misurare un altro posizionamento che abbia più in comune con i precedenti.</translation>
    </message>
    <message>
        <source>Nothing was joined and all points are kept; see that the object did not change its shape, and measure the mount again.</source>
        <translation>Niente è stato unito e tutti i punti sono conservati; accertarsi che l&apos;oggetto non abbia cambiato forma, e misurare di nuovo il posizionamento.</translation>
    </message>
    <message>
        <source>Nothing was measured; ask for a number of points instead, or scan by the spot.</source>
        <translation>Niente è stato misurato; chiedere invece un numero di punti, o scansionare col punto laser.</translation>
    </message>
    <message>
        <source>Nothing was measured; choose another recording.</source>
        <translation>Niente è stato misurato; scegliere un&apos;altra registrazione.</translation>
    </message>
    <message>
        <source>Nothing was measured; correct &apos;pixel_format&apos; or &apos;size_px&apos; in the rig file.</source>
        <translation>Niente è stato misurato; correggere &apos;pixel_format&apos; o &apos;size_px&apos; nel file del banco.</translation>
    </message>
    <message>
        <source>Nothing was measured; correct &apos;trigger_line&apos; in the rig file.</source>
        <translation>Niente è stato misurato; correggere &apos;trigger_line&apos; nel file del banco.</translation>
    </message>
    <message>
        <source>Nothing was measured; give both the same &apos;rate_hz&apos; in the rig file.</source>
        <translation>Niente è stato misurato; dare a entrambe lo stesso &apos;rate_hz&apos; nel file del banco.</translation>
    </message>
    <message>
        <source>Nothing was measured; plug it into a USB port of its own, choose a smaller size, or lower &apos;rate_hz&apos; in the rig file.</source>
        <translation>Niente è stato misurato; collegarla a una sua porta USB, scegliere un formato più piccolo, o ridurre &apos;rate_hz&apos; nel file del banco.</translation>
    </message>
    <message>
        <source>Nothing was measured; run &apos;impronta calibrate&apos; or the Rig page first.</source>
        <translation>Niente è stato misurato; eseguire prima &apos;impronta calibrate&apos; o la pagina Banco.</translation>
    </message>
    <message>
        <source>Nothing was measured; run it where a person or the virtual bench can.</source>
        <translation>Niente è stato misurato; eseguire dove può farlo una persona o il banco virtuale.</translation>
    </message>
    <message>
        <source>Nothing was measured; take the lens cap off, open the shutter, and look at &apos;exposure_ms&apos; in the rig file.</source>
        <translation>Niente è stato misurato; togliere il tappo, aprire l&apos;otturatore e vedere &apos;exposure_ms&apos; nel file del banco.</translation>
    </message>
    <message>
        <source>Nothing was moved; choose another port in the rig file.</source>
        <translation>Niente è stato mosso; scegliere un&apos;altra porta nel file del banco.</translation>
    </message>
    <message>
        <source>Nothing was moved; choose another target, or correct the limits.</source>
        <translation>Niente è stato mosso; scegliere un&apos;altra meta, o correggere i limiti.</translation>
    </message>
    <message>
        <source>Nothing was moved; close the other program and connect again.</source>
        <translation>Niente è stato mosso; chiudere l&apos;altro programma e ricollegare.</translation>
    </message>
    <message>
        <source>Nothing was moved; correct &apos;table_axis&apos; in the rig file.</source>
        <translation>Niente è stato mosso; correggere &apos;table_axis&apos; nel file del banco.</translation>
    </message>
    <message>
        <source>Nothing was moved; correct the file or take one of the presets.</source>
        <translation>Niente è stato mosso; correggere il file o prendere uno di quelli forniti.</translation>
    </message>
    <message>
        <source>Nothing was moved; give the left and the right camera each an &apos;id&apos; of its own.</source>
        <translation>Niente è stato mosso; dare alla telecamera sinistra e alla destra un &apos;id&apos; ciascuna.</translation>
    </message>
    <message>
        <source>Nothing was moved; install GRBL 1.1 or grblHAL with laser power on its PWM output.</source>
        <translation>Niente è stato mosso; installare GRBL 1.1 o grblHAL con la potenza laser sull&apos;uscita PWM.</translation>
    </message>
    <message>
        <source>Nothing was moved; install GRBL 1.1 or newer on the controller.</source>
        <translation>Niente è stato mosso; installare GRBL 1.1 o più recente sul controllore.</translation>
    </message>
    <message>
        <source>Nothing was moved; install the rule of packaging/udev or join the group &apos;dialout&apos;, then log in again.</source>
        <translation>Niente è stato mosso; installare la regola di packaging/udev o entrare nel gruppo &apos;dialout&apos;, poi accedere di nuovo.</translation>
    </message>
    <message>
        <source>Nothing was moved; install the rule of packaging/udev or join the group &apos;video&apos;, then log in again.</source>
        <translation>Niente è stato mosso; installare la regola di packaging/udev o entrare nel gruppo &apos;video&apos;, poi accedere di nuovo.</translation>
    </message>
    <message>
        <source>Nothing was moved; plug it in, or correct &apos;id&apos; in the rig file.</source>
        <translation>Niente è stato mosso; collegarla, o correggere &apos;id&apos; nel file del banco.</translation>
    </message>
    <message>
        <source>Nothing was moved; plug the controller in or correct &apos;port&apos; in the rig file.</source>
        <translation>Niente è stato mosso; collegare il controllore o correggere &apos;port&apos; nel file del banco.</translation>
    </message>
    <message>
        <source>Nothing was moved; run: pip install &apos;impronta[{driver}]&apos;.</source>
        <translation>Niente è stato mosso; eseguire: pip install &apos;impronta[{driver}]&apos;.</translation>
    </message>
    <message>
        <source>Nothing was moved; see that the controller has power and that the cable carries data, then check &apos;port&apos; and &apos;baud&apos; in the rig file.</source>
        <translation>Niente è stato mosso; accertarsi che il controllore sia alimentato e il cavo porti dati, poi controllare &apos;port&apos; e &apos;baud&apos; nel file del banco.</translation>
    </message>
    <message>
        <source>Nothing was moved; unplug it, plug it in again, and connect again.</source>
        <translation>Niente è stato mosso; scollegare, ricollegare il cavo e riconnettere.</translation>
    </message>
    <message>
        <source>Nothing was moved; with $32=0 the beam would stand still while lit: send $32=1 to the controller once.</source>
        <translation>Niente è stato mosso; con $32=0 il raggio acceso starebbe fermo: inviare una volta $32=1 al controllore.</translation>
    </message>
    <message>
        <source>Nothing was moved; write trigger = &quot;free&quot; into the rig file, or use a camera with a trigger of its own and its own driver.</source>
        <translation>Niente è stato mosso; scrivere trigger = &quot;free&quot; nel file del banco, o usare una telecamera con un proprio trigger e il proprio driver.</translation>
    </message>
    <message>
        <source>Nothing was scanned; choose a smaller specimen, or scale it (is its unit millimetres?).</source>
        <translation>Niente è stato scansionato; scegliere un oggetto più piccolo, o scalarlo (l&apos;unità è il millimetro?).</translation>
    </message>
    <message>
        <source>Nothing was scanned; correct the plan.</source>
        <translation>Niente è stato scansionato; correggere il piano.</translation>
    </message>
    <message>
        <source>Nothing was split and every point is kept; a single impression needs no tray, for a pair set both on their seats and scan again.</source>
        <translation>Niente è stato diviso e ogni punto è conservato; un&apos;impronta sola non vuole vassoio, per una coppia metterle sulle loro sedi e ripetere la scansione.</translation>
    </message>
    <message>
        <source>Nothing was split and every point is kept; take those points out (Edit), or set the impressions on their seats and scan again.</source>
        <translation>Niente è stato diviso e ogni punto è conservato; togliere quei punti (Modifica), o mettere le impronte sulle loro sedi e ripetere la scansione.</translation>
    </message>
    <message>
        <source>Nothing was touched, and what was measured can be used as it is; scan again into a new case, which takes about half a minute.</source>
        <translation>Niente è stato toccato e quanto misurato si può usare com&apos;è; ripetere la scansione in un nuovo caso, serve circa mezzo minuto.</translation>
    </message>
    <message>
        <source>Nothing was written; close other programs, or ask for fewer points or triangles.</source>
        <translation>Niente è stato scritto; chiudere altri programmi, o chiedere meno punti o triangoli.</translation>
    </message>
    <message>
        <source>Nothing was written; install it with pip install &apos;impronta[dicom]&apos;, or choose another format.</source>
        <translation>Niente è stato scritto; installarlo con pip install &apos;impronta[dicom]&apos;, o scegliere un altro formato.</translation>
    </message>
    <message>
        <source>Nothing was written; mend that, or deliver it anyway, and the certificate says so.</source>
        <translation>Niente è stato scritto; rimediare, o consegnare comunque, e il certificato lo dice.</translation>
    </message>
    <message>
        <source>Nothing was written; see what would be in it with --list.</source>
        <translation>Niente è stato scritto; con --list si vede che cosa conterrebbe.</translation>
    </message>
    <message>
        <source>Nothing was written; use one of {known}.</source>
        <translation>Niente è stato scritto; usare uno di {known}.</translation>
    </message>
    <message>
        <source>Nothing was written; use one of: {known}.</source>
        <translation>Niente è stato scritto; usare uno di: {known}.</translation>
    </message>
    <message>
        <source>Nothing was written; write .ply, .obj or .3mf instead, or move the points nearer to the origin.</source>
        <translation>Niente è stato scritto; scrivere invece .ply, .obj o .3mf, o portare i punti più vicino all&apos;origine.</translation>
    </message>
    <message>
        <source>One of {after} and {before} is mirrored, or they show opposite sides: {score} % of the surface agrees as it is, {mirrored} % of its mirror image.</source>
        <translation>Una fra {after} e {before} è specchiata, o mostrano lati opposti: il {score} % della superficie concorda così com&apos;è, il {mirrored} % specchiata.</translation>
    </message>
    <message>
        <source>Only {count} points in {path} lie on the seat of the {side} ear.</source>
        <translation>Solo {count} punti in {path} stanno sulla sede dell&apos;orecchio {side}.</translation>
    </message>
    <message>
        <source>Over the others its surface is {residual_um} um away (noise explains {most_um} um), and {agree} % of it agrees with theirs.</source>
        <translation>Sugli altri la sua superficie dista {residual_um} um (il rumore ne spiega {most_um} um), e il {agree} % concorda con la loro.</translation>
    </message>
    <message>
        <source>Points from there on may be off; see that both cameras are fixed, and calibrate before the next scan.</source>
        <translation>Da lì in poi i punti possono essere errati; accertarsi che le telecamere siano fissate, e calibrare prima della prossima scansione.</translation>
    </message>
    <message>
        <source>Room light drowned the laser spot: of {planned} planned measurements none gave a point.</source>
        <translation>La luce ambiente copre il punto laser: di {planned} misure previste nessuna ha dato un punto.</translation>
    </message>
    <message>
        <source>Room light drowns the laser spot: {frames} frames in a row of camera {camera} are too bright.</source>
        <translation>La luce ambiente copre il punto laser: {frames} immagini di seguito della telecamera {camera} sono troppo chiare.</translation>
    </message>
    <message>
        <source>The ball bar was not found in position {position}: {found} of its two spheres was seen.</source>
        <translation>La barra a sfere non è stata trovata in posizione {position}: delle due sfere ne è stata vista {found}.</translation>
    </message>
    <message>
        <source>The board&apos;s squares measure {measured_mm} mm where {given_mm} mm was given (by the bar of {bar_mm} mm).</source>
        <translation>I quadretti della scacchiera misurano {measured_mm} mm dove era dato {given_mm} mm (dalla barra di {bar_mm} mm).</translation>
    </message>
    <message>
        <source>The calibration failed: {reason}.</source>
        <translation>La calibrazione non è riuscita: {reason}.</translation>
    </message>
    <message>
        <source>The calibration of this rig is not the one with which the scan in {path} was begun.</source>
        <translation>La calibrazione di questo banco non è quella con cui è iniziata la scansione in {path}.</translation>
    </message>
    <message>
        <source>The calibration was not accepted: {reason}.</source>
        <translation>La calibrazione non è stata accettata: {reason}.</translation>
    </message>
    <message>
        <source>The cameras are exchanged: what is called the right camera stands to the left of the other.</source>
        <translation>Le telecamere sono scambiate: quella detta destra sta a sinistra dell&apos;altra.</translation>
    </message>
    <message>
        <source>The cameras are out of step by {count} frame: camera {late} lost a trigger, and every pair since then mixes two instants.</source>
        <translation>Le telecamere sono sfasate di {count} immagine: la telecamera {late} ha perso un trigger, e da allora ogni coppia mescola due istanti.</translation>
    </message>
    <message>
        <source>The cameras do not expose together: camera {late} is {skew_ms} ms late.</source>
        <translation>Le telecamere non espongono insieme: la telecamera {late} ritarda di {skew_ms} ms.</translation>
    </message>
    <message>
        <source>The case is unchanged; reconstruct it with &apos;impronta reconstruct&apos; and ask again.</source>
        <translation>Il caso è invariato; ricostruirlo con &apos;impronta reconstruct&apos; e richiedere.</translation>
    </message>
    <message>
        <source>The case is unchanged; reconstruct with fewer triangles.</source>
        <translation>Il caso è invariato; ricostruire con meno triangoli.</translation>
    </message>
    <message>
        <source>The case is unchanged; {do}.</source>
        <translation>Il caso è invariato; {do}.</translation>
    </message>
    <message>
        <source>The case {path} was used after it had been closed.</source>
        <translation>Il caso {path} è stato usato dopo la chiusura.</translation>
    </message>
    <message>
        <source>The connection to the controller on {port} was lost.</source>
        <translation>Il collegamento al controllore su {port} è caduto.</translation>
    </message>
    <message>
        <source>The controller on {port} did not answer &apos;{command}&apos; within {seconds} s.</source>
        <translation>Il controllore su {port} non ha risposto a &apos;{command}&apos; entro {seconds} s.</translation>
    </message>
    <message>
        <source>The controller on {port} does not tell its setting {setting} ({meaning}).</source>
        <translation>Il controllore su {port} non comunica la sua impostazione {setting} ({meaning}).</translation>
    </message>
    <message>
        <source>The controller on {port} has no axis &apos;{axis}&apos; for the table (it has {axes}).</source>
        <translation>Il controllore su {port} non ha un asse &apos;{axis}&apos; per la tavola (ha {axes}).</translation>
    </message>
    <message>
        <source>The controller on {port} is not in laser mode ($32={value}).</source>
        <translation>Il controllore su {port} non è in modo laser ($32={value}).</translation>
    </message>
    <message>
        <source>The controller on {port} reports another position each time although it rests.</source>
        <translation>Il controllore su {port} riporta ogni volta un&apos;altra posizione benché sia fermo.</translation>
    </message>
    <message>
        <source>The controller on {port} restarted by itself.</source>
        <translation>Il controllore su {port} si è riavviato da sé.</translation>
    </message>
    <message>
        <source>The controller on {port} runs {firmware}, which knows no laser mode.</source>
        <translation>Il controllore su {port} esegue {firmware}, che non ha modo laser.</translation>
    </message>
    <message>
        <source>The controller on {port} was used after it had been closed.</source>
        <translation>Il controllore su {port} è stato usato dopo la chiusura.</translation>
    </message>
    <message>
        <source>The controller refused &apos;{command}&apos; with error:{number} ({meaning}).</source>
        <translation>Il controllore ha rifiutato &apos;{command}&apos; con error:{number} ({meaning}).</translation>
    </message>
    <message>
        <source>The controller reports ALARM:{alarm} ({meaning}).</source>
        <translation>Il controllore segnala ALARM:{alarm} ({meaning}).</translation>
    </message>
    <message>
        <source>The controller reports a lit laser (S{power}) where it must be dark.</source>
        <translation>Il controllore segnala il laser acceso (S{power}) dove deve essere spento.</translation>
    </message>
    <message>
        <source>The file is untouched; scan or export the surface again.</source>
        <translation>Il file è intatto; scansionare o esportare di nuovo la superficie.</translation>
    </message>
    <message>
        <source>The file of picked points {path} cannot be used: {reason}.</source>
        <translation>Il file dei punti scelti {path} non è utilizzabile: {reason}.</translation>
    </message>
    <message>
        <source>The file was not touched; choose another file.</source>
        <translation>Il file non è stato toccato; scegliere un altro file.</translation>
    </message>
    <message>
        <source>The frames of camera {camera} cannot be recorded into {path}: {reason}.</source>
        <translation>Le immagini della telecamera {camera} non si possono registrare in {path}: {reason}.</translation>
    </message>
    <message>
        <source>The interrupted scan cannot go on: of {known} known points {seen} were found again, {shift_um} um beside where they were.</source>
        <translation>La scansione interrotta non può continuare: di {known} punti noti {seen} sono stati ritrovati, a {shift_um} um da dove erano.</translation>
    </message>
    <message>
        <source>The interrupted scan cannot go on: the marks on the table&apos;s rim are seen {shift_um} um beside where they were ({cause}).</source>
        <translation>La scansione interrotta non può continuare: le tacche del bordo della tavola si vedono a {shift_um} um da dove erano ({cause}).</translation>
    </message>
    <message>
        <source>The interrupted scan of {path} was made by a laser line, which is not resumed.</source>
        <translation>La scansione interrotta di {path} era a linea laser, e non si riprende.</translation>
    </message>
    <message>
        <source>The laser did not light although it was asked to.</source>
        <translation>Il laser non si è acceso benché richiesto.</translation>
    </message>
    <message>
        <source>The laser is off and everything written before is kept; free some space and go on.</source>
        <translation>Il laser è spento e quanto scritto prima è conservato; liberare spazio e continuare.</translation>
    </message>
    <message>
        <source>The laser is off and the points so far are in {case}.</source>
        <translation>Il laser è spento e i punti finora sono in {case}.</translation>
    </message>
    <message>
        <source>The laser is off and the points so far are kept; check its cable and resume.</source>
        <translation>Il laser è spento e i punti finora sono conservati; controllarne il cavo e riprendere.</translation>
    </message>
    <message>
        <source>The laser is off and the points so far are kept; check the trigger cable, or set trigger = &quot;free&quot; in the rig file.</source>
        <translation>Il laser è spento e i punti finora sono conservati; controllare il cavo di trigger, o mettere trigger = &quot;free&quot; nel file del banco.</translation>
    </message>
    <message>
        <source>The laser is off and the points so far are kept; close other programs and resume.</source>
        <translation>Il laser è spento e i punti finora sono conservati; chiudere altri programmi e riprendere.</translation>
    </message>
    <message>
        <source>The laser is off and the points so far are kept; close the door and resume.</source>
        <translation>Il laser è spento e i punti finora sono conservati; chiudere lo sportello e riprendere.</translation>
    </message>
    <message>
        <source>The laser is off and the points so far are kept; free some space or choose another folder, and resume.</source>
        <translation>Il laser è spento e i punti finora sono conservati; liberare spazio o scegliere un&apos;altra cartella, e riprendere.</translation>
    </message>
    <message>
        <source>The laser is off and the points so far are kept; its position is lost, home it and resume.</source>
        <translation>Il laser è spento e i punti finora sono conservati; la posizione è persa, cercare il riferimento e riprendere.</translation>
    </message>
    <message>
        <source>The laser is off and the points so far are kept; plug it in and resume.</source>
        <translation>Il laser è spento e i punti finora sono conservati; ricollegare e riprendere.</translation>
    </message>
    <message>
        <source>The laser is off and the points so far are kept; resume when the rig is free.</source>
        <translation>Il laser è spento e i punti finora sono conservati; riprendere quando il banco è libero.</translation>
    </message>
    <message>
        <source>The laser is off and the points so far are kept; unplug the camera, plug it in again, and resume.</source>
        <translation>Il laser è spento e i punti finora sono conservati; scollegare la telecamera, ricollegarla e riprendere.</translation>
    </message>
    <message>
        <source>The laser is off and the points so far are kept; {remedy}.</source>
        <translation>Il laser è spento e i punti finora sono conservati; {remedy}.</translation>
    </message>
    <message>
        <source>The laser is off and what was measured before is kept; put table and cameras back as they were and resume, or scan anew.</source>
        <translation>Il laser è spento e quanto misurato prima è conservato; rimettere tavola e telecamere com&apos;erano e riprendere, o scansionare da capo.</translation>
    </message>
    <message>
        <source>The laser is off and what was measured before is kept; put the object and the cameras back as they were and resume, or scan anew.</source>
        <translation>Il laser è spento e quanto misurato prima è conservato; rimettere l&apos;oggetto e le telecamere com&apos;erano e riprendere, o scansionare da capo.</translation>
    </message>
    <message>
        <source>The laser is off and what was measured before is kept; switch the lamp off, then resume or scan again.</source>
        <translation>Il laser è spento e quanto misurato prima è conservato; spegnere la lampada, poi riprendere o ripetere la scansione.</translation>
    </message>
    <message>
        <source>The laser is off; ask for more points, or more views.</source>
        <translation>Il laser è spento; chiedere più punti, o più viste.</translation>
    </message>
    <message>
        <source>The laser is off; check --spacing-mm and that nothing else of the spheres&apos; size stands in the volume.</source>
        <translation>Il laser è spento; controllare --spacing-mm e che nel volume non ci sia altro grande quanto le sfere.</translation>
    </message>
    <message>
        <source>The laser is off; check the rig file and the controller&apos;s settings.</source>
        <translation>Il laser è spento; controllare il file del banco e le impostazioni del controllore.</translation>
    </message>
    <message>
        <source>The laser is off; open the rig again.</source>
        <translation>Il laser è spento; aprire di nuovo il banco.</translation>
    </message>
    <message>
        <source>The laser is off; place the bar as the plan of the test says, and check --reference-mm.</source>
        <translation>Il laser è spento; collocare la barra come dice il piano della prova, e controllare --reference-mm.</translation>
    </message>
    <message>
        <source>The laser is off; put the matt white plate into the middle of the volume, facing the cameras, and keep the lamps away.</source>
        <translation>Il laser è spento; mettere la piastra bianca opaca al centro del volume, rivolta alle telecamere, e tenere lontane le lampade.</translation>
    </message>
    <message>
        <source>The laser is off; put the object on the table, and check the laser and the lens caps.</source>
        <translation>Il laser è spento; mettere l&apos;oggetto sulla tavola, e controllare il laser e i tappi degli obiettivi.</translation>
    </message>
    <message>
        <source>The laser is off; put the reference sphere alone into the middle of the table, and check the size that was given.</source>
        <translation>Il laser è spento; mettere la sola sfera di riferimento al centro della tavola, e controllare la misura indicata.</translation>
    </message>
    <message>
        <source>The laser is off; take all but one away and start the test again.</source>
        <translation>Il laser è spento; toglierle tutte tranne una e riavviare la prova.</translation>
    </message>
    <message>
        <source>The laser may be on: switch off its power before you reach into the rig, then connect again.</source>
        <translation>Il laser può essere acceso: togliere l&apos;alimentazione prima di mettere le mani nel banco, poi ricollegare.</translation>
    </message>
    <message>
        <source>The laser spot is saturated in {frames} frames in a row of camera {camera}.</source>
        <translation>Il punto laser è saturo in {frames} immagini di seguito della telecamera {camera}.</translation>
    </message>
    <message>
        <source>The laser was switched off and the points so far are kept; free the machine of other work, then resume.</source>
        <translation>Il laser è stato spento e i punti finora sono conservati; liberare il computer da altro lavoro, poi riprendere.</translation>
    </message>
    <message>
        <source>The laser was switched off by a reset; connect again.</source>
        <translation>Il laser è stato spento con un reset; ricollegare.</translation>
    </message>
    <message>
        <source>The left camera gives {left_hz} frames/s and the right one {right_hz}.</source>
        <translation>La telecamera sinistra dà {left_hz} immagini/s e la destra {right_hz}.</translation>
    </message>
    <message>
        <source>The marked part holds {marked} measured vertices; at least {least} are needed for a motion.</source>
        <translation>La parte segnata contiene {marked} vertici misurati; per un moto ne servono almeno {least}.</translation>
    </message>
    <message>
        <source>The mask {path} cannot be used: {reason}.</source>
        <translation>La maschera {path} non è utilizzabile: {reason}.</translation>
    </message>
    <message>
        <source>The material {path} cannot be used: {reason}.</source>
        <translation>Il materiale {path} non è utilizzabile: {reason}.</translation>
    </message>
    <message>
        <source>The mesh of {path} does not say how certain it is.</source>
        <translation>La mesh di {path} non dice quanto è certa.</translation>
    </message>
    <message>
        <source>The motion was stopped during &apos;{command}&apos;.</source>
        <translation>Il moto è stato fermato durante &apos;{command}&apos;.</translation>
    </message>
    <message>
        <source>The new mount fits in more than one way: a pose that is turned by {angle} degrees against the best one fits about as well.</source>
        <translation>Il nuovo posizionamento combacia in più modi: una posa ruotata di {angle} gradi rispetto alla migliore combacia quasi altrettanto.</translation>
    </message>
    <message>
        <source>The new mount fits nowhere on what was measured before: in the best pose only {agree} % of the surface that both show agrees.</source>
        <translation>Il nuovo posizionamento non combacia con quanto misurato prima: nella posa migliore concorda solo il {agree} % della superficie comune.</translation>
    </message>
    <message>
        <source>The new mount shares too little with what was measured before: {overlap} % of it, and at least {least} % are needed.</source>
        <translation>Il nuovo posizionamento ha troppo poco in comune con quanto misurato prima: il {overlap} %, e serve almeno il {least} %.</translation>
    </message>
    <message>
        <source>The new mount, or what was measured before, has too few points to find its place: {points}, but at least {least} are needed.</source>
        <translation>Il nuovo posizionamento, o quanto misurato prima, ha troppo pochi punti per trovare il suo posto: {points}, e ne servono almeno {least}.</translation>
    </message>
    <message>
        <source>The null comparison says nothing of the rig: {reason}.</source>
        <translation>Il confronto nullo non dice nulla del banco: {reason}.</translation>
    </message>
    <message>
        <source>The object moved on the table: the views from {table_deg} deg on lie {shift_um} um beside the earlier ones.</source>
        <translation>L&apos;oggetto si è mosso sulla tavola: le viste da {table_deg} deg in poi stanno a {shift_um} um dalle precedenti.</translation>
    </message>
    <message>
        <source>The picked points do not belong to each other: after the best fit of the surfaces they lie {apart_mm} mm apart.</source>
        <translation>I punti scelti non si corrispondono: dopo il miglior adattamento delle superfici distano {apart_mm} mm.</translation>
    </message>
    <message>
        <source>The picked points do not say how the surfaces lie: {reason}.</source>
        <translation>I punti scelti non dicono come stanno le superfici: {reason}.</translation>
    </message>
    <message>
        <source>The plan {path} cannot be used: {reason}.</source>
        <translation>Il piano {path} non è utilizzabile: {reason}.</translation>
    </message>
    <message>
        <source>The points are kept and the other marks go on watching; fix it, and see that nothing touches it.</source>
        <translation>I punti sono conservati e le altre tacche continuano a vigilare; fissarla, e badare che niente la tocchi.</translation>
    </message>
    <message>
        <source>The points are kept and the other marks go on watching; see whether it is covered or was knocked off.</source>
        <translation>I punti sono conservati e le altre tacche continuano a vigilare; vedere se è coperta o è stata staccata.</translation>
    </message>
    <message>
        <source>The points are noisier than they claim; look for vibration, moving reflections or a dirty lens.</source>
        <translation>I punti sono più rumorosi di quanto dichiarano; cercare vibrazioni, riflessi mobili o un obiettivo sporco.</translation>
    </message>
    <message>
        <source>The points are shifted along the sweep; trigger both cameras from one source.</source>
        <translation>I punti sono spostati lungo la passata; comandare le due telecamere da un solo trigger.</translation>
    </message>
    <message>
        <source>The points belong to {count} separate objects: the second largest holds {share} % of them and lies {gap_mm} mm from the largest.</source>
        <translation>I punti sono di {count} oggetti separati: il secondo ne ha il {share} % e dista {gap_mm} mm dal più grande.</translation>
    </message>
    <message>
        <source>The points contain {count} values that are not finite numbers, or impossibly far away.</source>
        <translation>I punti contengono {count} valori non finiti, o impossibilmente lontani.</translation>
    </message>
    <message>
        <source>The points do not enclose a body: {reason}.</source>
        <translation>I punti non racchiudono un corpo: {reason}.</translation>
    </message>
    <message>
        <source>The points from there on are off; fix the cameras, calibrate, and scan again.</source>
        <translation>Da lì in poi i punti sono errati; fissare le telecamere, calibrare e ripetere la scansione.</translation>
    </message>
    <message>
        <source>The points since then are wrong; check the trigger cable and scan again.</source>
        <translation>Da allora i punti sono errati; controllare il cavo di trigger e ripetere la scansione.</translation>
    </message>
    <message>
        <source>The points so far are kept. A sweep ends dark by itself, a standing spot may stay lit: see that the laser is off, plug it in, then resume.</source>
        <translation>I punti finora sono conservati. Una passata si spegne da sé, un punto fermo può restare acceso: accertarsi che il laser sia spento, ricollegare, poi riprendere.</translation>
    </message>
    <message>
        <source>The port {port} does not exist or cannot be opened.</source>
        <translation>La porta {port} non esiste o non si apre.</translation>
    </message>
    <message>
        <source>The port {port} is used by another program.</source>
        <translation>La porta {port} è usata da un altro programma.</translation>
    </message>
    <message>
        <source>The previous calibration stays in use; exchange the two cameras in the rig file, then calibrate again.</source>
        <translation>Resta in uso la calibrazione precedente; scambiare le due telecamere nel file del banco, poi calibrare di nuovo.</translation>
    </message>
    <message>
        <source>The previous calibration stays in use; give the right size with --square-mm, or the bar&apos;s certified length with --length-mm.</source>
        <translation>Resta in uso la calibrazione precedente; dare la misura giusta con --square-mm, o la lunghezza certificata della barra con --length-mm.</translation>
    </message>
    <message>
        <source>The previous calibration stays in use; take the views again.</source>
        <translation>Resta in uso la calibrazione precedente; riprendere le viste.</translation>
    </message>
    <message>
        <source>The program did not look after the lit laser for {seconds} s.</source>
        <translation>Il programma non ha sorvegliato il laser acceso per {seconds} s.</translation>
    </message>
    <message>
        <source>The recording {path} cannot be replayed: {reason}.</source>
        <translation>La registrazione {path} non si può riprodurre: {reason}.</translation>
    </message>
    <message>
        <source>The recording {path} holds no frames for what was asked of camera {camera}: {reason}.</source>
        <translation>La registrazione {path} non contiene immagini per quanto chiesto alla telecamera {camera}: {reason}.</translation>
    </message>
    <message>
        <source>The rig file is unchanged; measure the same model twice.</source>
        <translation>Il file del banco è invariato; misurare due volte lo stesso modello.</translation>
    </message>
    <message>
        <source>The rig file {path} cannot be used: {reason}.</source>
        <translation>Il file del banco {path} non è utilizzabile: {reason}.</translation>
    </message>
    <message>
        <source>The rig file&apos;s own settings are used; set exposure and sizes on the Aim page again.</source>
        <translation>Si usano le impostazioni del file del banco; regolare di nuovo esposizione e dimensioni nella pagina Puntamento.</translation>
    </message>
    <message>
        <source>The rig has no calibration.</source>
        <translation>Il banco non ha calibrazione.</translation>
    </message>
    <message>
        <source>The right camera exposes {skew_us} us after the left one, and a moving laser line is then not the same line in both images.</source>
        <translation>La telecamera destra espone {skew_us} us dopo la sinistra, e una linea laser in moto non è più la stessa nelle due immagini.</translation>
    </message>
    <message>
        <source>The safety door of the rig is open.</source>
        <translation>Lo sportello di sicurezza del banco è aperto.</translation>
    </message>
    <message>
        <source>The safety relay of the serial port stopped.</source>
        <translation>Il relè di sicurezza della porta seriale si è fermato.</translation>
    </message>
    <message>
        <source>The safety relay of the serial port {port} stopped, and the controller could not be reset.</source>
        <translation>Il relè di sicurezza della porta seriale {port} si è fermato, e non si è potuto resettare il controllore.</translation>
    </message>
    <message>
        <source>The scale changed by {percent} %: since the view at {table_deg} deg the marks on the table&apos;s rim have other distances.</source>
        <translation>La scala è cambiata del {percent} %: dalla vista a {table_deg} deg le tacche del bordo della tavola hanno altre distanze.</translation>
    </message>
    <message>
        <source>The scale is off by {percent} % against the calibrated distances of the marks on the table&apos;s rim.</source>
        <translation>La scala è errata del {percent} % rispetto alle distanze calibrate delle tacche del bordo della tavola.</translation>
    </message>
    <message>
        <source>The scan stopped on an unexpected fault ({reason}).</source>
        <translation>La scansione si è fermata per un guasto imprevisto ({reason}).</translation>
    </message>
    <message>
        <source>The software for cameras of the kind &apos;{driver}&apos; is not installed.</source>
        <translation>Il software per telecamere di tipo &apos;{driver}&apos; non è installato.</translation>
    </message>
    <message>
        <source>The specimen is {size_mm} mm large, but both cameras see a volume of {volume_mm} mm.</source>
        <translation>L&apos;oggetto è grande {size_mm} mm, ma le due telecamere vedono un volume di {volume_mm} mm.</translation>
    </message>
    <message>
        <source>The spheres in position {position} stand {measured_mm} mm apart, not {reference_mm} mm.</source>
        <translation>Le sfere in posizione {position} distano {measured_mm} mm, non {reference_mm} mm.</translation>
    </message>
    <message>
        <source>The standing spot was seen by both cameras in {seen} of {exposed} exposures only ({reasons}).</source>
        <translation>Il punto fermo è stato visto dalle due telecamere solo in {seen} esposizioni su {exposed} ({reasons}).</translation>
    </message>
    <message>
        <source>The support bundle has no entry &apos;{name}&apos;; it has {known}.</source>
        <translation>Il pacchetto di assistenza non ha la voce &apos;{name}&apos;; ha {known}.</translation>
    </message>
    <message>
        <source>The surface that both mounts show does not tell how they lie: {directions} of six directions of motion stay open, as on a ball or a cylinder.</source>
        <translation>La superficie comune ai due posizionamenti non dice come stanno: {directions} direzioni di moto su sei restano libere, come su una sfera o un cilindro.</translation>
    </message>
    <message>
        <source>The surface that was found is not trustworthy: {reason}.</source>
        <translation>La superficie trovata non è attendibile: {reason}.</translation>
    </message>
    <message>
        <source>The table lost steps: by the marks on its rim it stands {turn_deg} deg beside its reading, since the view at {table_deg} deg.</source>
        <translation>La tavola ha perso passi: secondo le tacche del bordo sta a {turn_deg} deg dalla sua lettura, dalla vista a {table_deg} deg.</translation>
    </message>
    <message>
        <source>The table lost steps: it stands {turn_deg} deg beside its reading{where}.</source>
        <translation>La tavola ha perso passi: sta a {turn_deg} deg dalla sua lettura{where}.</translation>
    </message>
    <message>
        <source>The table or a camera moved: since the view at {table_deg} deg the marks on the table&apos;s rim are seen up to {shift_um} um beside.</source>
        <translation>La tavola o una telecamera si è mossa: dalla vista a {table_deg} deg le tacche del bordo della tavola si vedono spostate fino a {shift_um} um.</translation>
    </message>
    <message>
        <source>The triangles of {path} all lie in one point or line.</source>
        <translation>I triangoli di {path} stanno tutti in un punto o su una retta.</translation>
    </message>
    <message>
        <source>The turn does not close: the first view measured again lies {shift_um} um beside its first measurement.</source>
        <translation>Il giro non si chiude: la prima vista rimisurata sta a {shift_um} um dalla sua prima misura.</translation>
    </message>
    <message>
        <source>The two ears in {path} cannot be told apart: {count} points lie half way between the seats of the tray.</source>
        <translation>I due orecchi in {path} non si possono distinguere: {count} punti stanno a metà fra le sedi del vassoio.</translation>
    </message>
    <message>
        <source>The two images of the spot disagree by {sd_px} px, where {expected_px} px are expected ({where}).</source>
        <translation>Le due immagini del punto discordano di {sd_px} px, dove se ne attendono {expected_px} ({where}).</translation>
    </message>
    <message>
        <source>The views from there on are turned; see that the table moves freely, and scan again.</source>
        <translation>Da lì in poi le viste sono ruotate; accertarsi che la tavola si muova liberamente, e ripetere la scansione.</translation>
    </message>
    <message>
        <source>The worker process ended unexpectedly during {phase} ({reason}).</source>
        <translation>Il processo di calcolo è terminato inatteso durante {phase} ({reason}).</translation>
    </message>
    <message>
        <source>The worker process failed: {reason}.</source>
        <translation>Il processo di calcolo non è riuscito: {reason}.</translation>
    </message>
    <message>
        <source>The {part} of the rig is not the one with which the scan in {path} was begun.</source>
        <translation>La parte {part} del banco non è quella con cui è iniziata la scansione in {path}.</translation>
    </message>
    <message>
        <source>Their points are kept; fix the cameras, calibrate, and scan again.</source>
        <translation>I loro punti sono conservati; fissare le telecamere, calibrare e ripetere la scansione.</translation>
    </message>
    <message>
        <source>Their points are kept; fix the object to the table and scan again.</source>
        <translation>I loro punti sono conservati; fissare l&apos;oggetto alla tavola e ripetere la scansione.</translation>
    </message>
    <message>
        <source>There is no camera {camera} ({id}); this machine has: {found}.</source>
        <translation>Non c&apos;è la telecamera {camera} ({id}); questo computer ha: {found}.</translation>
    </message>
    <message>
        <source>There is no export profile &apos;{name}&apos;.</source>
        <translation>Non c&apos;è un profilo di esportazione &apos;{name}&apos;.</translation>
    </message>
    <message>
        <source>There is no space left on the disk of {path}.</source>
        <translation>Non c&apos;è più spazio sul disco di {path}.</translation>
    </message>
    <message>
        <source>There is not enough memory for &apos;{command}&apos;.</source>
        <translation>Non c&apos;è memoria sufficiente per &apos;{command}&apos;.</translation>
    </message>
    <message>
        <source>This surface is not ready to be delivered: {checks}.</source>
        <translation>Questa superficie non è pronta per la consegna: {checks}.</translation>
    </message>
    <message>
        <source>This user may not open camera {camera} ({id}).</source>
        <translation>Questo utente non può aprire la telecamera {camera} ({id}).</translation>
    </message>
    <message>
        <source>This user may not open the port {port}.</source>
        <translation>Questo utente non può aprire la porta {port}.</translation>
    </message>
    <message>
        <source>Those measurements are missing; check its cable and port, and close other programs.</source>
        <translation>Quelle misure mancano; controllarne cavo e porta, e chiudere altri programmi.</translation>
    </message>
    <message>
        <source>Two spheres stand on the table: {first} points lie on the one, {second} on the other.</source>
        <translation>Due sfere stanno sulla tavola: {first} punti sull&apos;una, {second} sull&apos;altra.</translation>
    </message>
    <message>
        <source>What answers on {port} is no GRBL controller (it said: {said}).</source>
        <translation>Ciò che risponde su {port} non è un controllore GRBL (ha detto: {said}).</translation>
    </message>
    <message>
        <source>What was measured is kept; use the rig file of that scan to resume it, or keep what is there and scan anew.</source>
        <translation>Quanto misurato è conservato; usare il file del banco di quella scansione per riprenderla, o tenere ciò che c&apos;è e scansionare da capo.</translation>
    </message>
    <message>
        <source>What was measured so far is kept and the laser is off; let a trigger line expose both cameras at once, then scan again.</source>
        <translation>Quanto misurato finora è conservato e il laser è spento; esporre le due telecamere insieme con una linea di trigger, poi ripetere la scansione.</translation>
    </message>
    <message>
        <source>What was measured so far is kept; replay with the rig, plan and seed that it was recorded with.</source>
        <translation>Quanto misurato finora è conservato; riprodurre con il banco, il piano e il seme con cui è stato registrato.</translation>
    </message>
    <message>
        <source>What was set while aiming cannot be read ({path}: {reason}).</source>
        <translation>Le impostazioni di puntamento non si leggono ({path}: {reason}).</translation>
    </message>
    <message>
        <source>Whether the table lost steps cannot be judged on this object: {reason}.</source>
        <translation>Su questo oggetto non si può giudicare se la tavola ha perso passi: {reason}.</translation>
    </message>
    <message>
        <source>Which of them it was is not decided; the points from there on are off: fix cameras and table, calibrate, and scan again.</source>
        <translation>Non si sa quale dei due; da lì in poi i punti sono errati: fissare telecamere e tavola, calibrare e ripetere la scansione.</translation>
    </message>
    <message>
        <source>{after} and {before} do not fit onto each other: in the best pose only {score} % of the surface agrees. They seem to be different objects, or opposite sides of one.</source>
        <translation>{after} e {before} non combaciano: nella posa migliore concorda solo il {score} % della superficie. Sembrano oggetti diversi, o lati opposti di uno.</translation>
    </message>
    <message>
        <source>{after} and {before} do not overlap: nothing of one lies within {reach_mm} mm of the other.</source>
        <translation>{after} e {before} non si sovrappongono: niente dell&apos;una sta entro {reach_mm} mm dall&apos;altra.</translation>
    </message>
    <message>
        <source>{area_mm2} mm2 with a counterpart are painted as stable; at least {least_mm2} mm2 are needed.</source>
        <translation>{area_mm2} mm2 con corrispondente sono dipinti come stabili; ne servono almeno {least_mm2} mm2.</translation>
    </message>
    <message>
        <source>{axis} cannot go to {target} deg: {whose} allow {low} to {high} deg.</source>
        <translation>{axis} non può andare a {target} deg: {whose} consentono da {low} a {high} deg.</translation>
    </message>
    <message>
        <source>{name} holds too few measured triangles with an area: {triangles}, but a comparison needs at least {least}.</source>
        <translation>{name} contiene troppo pochi triangoli misurati con area: {triangles}, ma per un confronto ne servono almeno {least}.</translation>
    </message>
    <message>
        <source>{path} cannot be read as points: {reason}.</source>
        <translation>{path} non si può leggere come punti: {reason}.</translation>
    </message>
    <message>
        <source>{path} cannot be read: {reason}.</source>
        <translation>{path} non si può leggere: {reason}.</translation>
    </message>
    <message>
        <source>{path} cannot be written: {reason}.</source>
        <translation>{path} non si può scrivere: {reason}.</translation>
    </message>
    <message>
        <source>{path} cannot hold this mesh: so far from the origin the numbers of an STL file have steps of {step_mm} mm, wider than its triangles allow.</source>
        <translation>{path} non può contenere questa mesh: così lontano dall&apos;origine i numeri di un file STL hanno passi di {step_mm} mm, più dei suoi triangoli.</translation>
    </message>
    <message>
        <source>{path} does not exist.</source>
        <translation>{path} non esiste.</translation>
    </message>
    <message>
        <source>{path} exists already.</source>
        <translation>{path} esiste già.</translation>
    </message>
    <message>
        <source>{path} holds no interrupted scan.</source>
        <translation>{path} non contiene una scansione interrotta.</translation>
    </message>
    <message>
        <source>{path} holds no triangles.</source>
        <translation>{path} non contiene triangoli.</translation>
    </message>
    <message>
        <source>{path} holds no {what} yet.</source>
        <translation>{path} non contiene ancora: {what}.</translation>
    </message>
    <message>
        <source>{path} holds too few triangles for a comparison: {triangles}, but at least {least} are needed.</source>
        <translation>{path} contiene troppo pochi triangoli per un confronto: {triangles}, ma ne servono almeno {least}.</translation>
    </message>
    <message>
        <source>{path} is no Impronta case: {reason}.</source>
        <translation>{path} non è un caso di Impronta: {reason}.</translation>
    </message>
    <message>
        <source>{path} is no mesh that can be read: {reason}.</source>
        <translation>{path} non è una mesh leggibile: {reason}.</translation>
    </message>
    <message>
        <source>{path} is open in another window or program.</source>
        <translation>{path} è aperto in un&apos;altra finestra o in un altro programma.</translation>
    </message>
    <message>
        <source>{path} was written by a newer Impronta (case version {version}, this program knows {known}).</source>
        <translation>{path} è stato scritto da una versione più recente di Impronta (versione del caso {version}, questo programma conosce la {known}).</translation>
    </message>
    <message>
        <source>{points} points are too few for a sphere; at least {least} are needed.</source>
        <translation>{points} punti sono troppo pochi per una sfera; ne servono almeno {least}.</translation>
    </message>
    <message>
        <source>{points} points are too few for a surface; at least {least} are needed.</source>
        <translation>{points} punti sono troppo pochi per una superficie; ne servono almeno {least}.</translation>
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
        <translation>Un valore è così vicino al suo limite che l&apos;incertezza lo lascia aperto: niente è provato. Misurare di nuovo.</translation>
    </message>
    <message>
        <source>Certified diameter</source>
        <translation>Diametro certificato</translation>
    </message>
    <message>
        <source>Coverage</source>
        <translation>Copertura</translation>
    </message>
    <message>
        <source>Dispersion D95</source>
        <translation>Dispersione D95</translation>
    </message>
    <message>
        <source>Failed</source>
        <translation>Non superata</translation>
    </message>
    <message>
        <source>Form PF without the worst 0.3 %</source>
        <translation>Forma PF senza il peggior 0.3 %</translation>
    </message>
    <message>
        <source>Form PF, all points</source>
        <translation>Forma PF, tutti i punti</translation>
    </message>
    <message>
        <source>Kept in the history of this rig.</source>
        <translation>Conservata nella storia di questo banco.</translation>
    </message>
    <message>
        <source>Measured diameter</source>
        <translation>Diametro misurato</translation>
    </message>
    <message>
        <source>Measured on every side, from the top down to</source>
        <translation>Misurata da ogni lato, dall&apos;alto fino a</translation>
    </message>
    <message>
        <source>Not kept in the history: a fault was rehearsed on this rig, or it shows a recording.</source>
        <translation>Non conservata nella storia: su questo banco è stato provato un guasto, o mostra una registrazione.</translation>
    </message>
    <message>
        <source>Not kept in the history: its file could not be written.</source>
        <translation>Non conservata nella storia: il suo file non si è potuto scrivere.</translation>
    </message>
    <message>
        <source>Passed</source>
        <translation>Superata</translation>
    </message>
    <message>
        <source>Points on the sphere</source>
        <translation>Punti sulla sfera</translation>
    </message>
    <message>
        <source>Size and D95 are within the rig&apos;s limits, even with their uncertainty added.</source>
        <translation>Scarto di misura e D95 sono nei limiti del banco, anche sommando l&apos;incertezza.</translation>
    </message>
    <message>
        <source>Size deviation</source>
        <translation>Scarto di misura</translation>
    </message>
    <message>
        <source>Standard deviation σ of the points</source>
        <translation>Scarto tipo σ dei punti</translation>
    </message>
    <message>
        <source>The points do not reach down to the sphere&apos;s equator on every side: nothing is proved. See that nothing stands in the way, and measure again.</source>
        <translation>I punti non arrivano da ogni lato fino all&apos;equatore della sfera: niente è provato. Badare che niente ostacoli, e misurare di nuovo.</translation>
    </message>
    <message>
        <source>The rig measures outside of its limits. Calibrate it, then measure the sphere again.</source>
        <translation>Il banco misura fuori dai limiti. Calibrarlo, poi misurare di nuovo la sfera.</translation>
    </message>
    <message>
        <source>Undecided</source>
        <translation>Indecisa</translation>
    </message>
    <message>
        <source>{count}, and {rejected} left out</source>
        <translation>{count}, e {rejected} esclusi</translation>
    </message>
    <message>
        <source>{reach}° (at least {needed}°)</source>
        <translation>{reach}° (almeno {needed}°)</translation>
    </message>
    <message>
        <source>{share} % of the surface</source>
        <translation>{share} % della superficie</translation>
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
        <translation>{value} µm, U = {uncertainty} µm, limite {limit} µm</translation>
    </message>
</context>
<context>
    <name>spot</name>
    <message>
        <source>cut by the edge</source>
        <translation>tagliato dal bordo</translation>
    </message>
    <message>
        <source>drawn out</source>
        <translation>allungato</translation>
    </message>
    <message>
        <source>no spot</source>
        <translation>nessun punto</translation>
    </message>
    <message>
        <source>off the other camera&apos;s line</source>
        <translation>fuori dalla linea dell&apos;altra telecamera</translation>
    </message>
    <message>
        <source>on the table</source>
        <translation>sulla tavola</translation>
    </message>
    <message>
        <source>one of several</source>
        <translation>uno fra diversi</translation>
    </message>
    <message>
        <source>outside the volume</source>
        <translation>fuori dal volume</translation>
    </message>
    <message>
        <source>overexposed</source>
        <translation>sovraesposto</translation>
    </message>
    <message>
        <source>reflection: much dimmer</source>
        <translation>riflesso: molto più debole</translation>
    </message>
    <message>
        <source>spot clipped: shorten the exposure</source>
        <translation>punto saturo: ridurre l&apos;esposizione</translation>
    </message>
    <message>
        <source>spot dim: lengthen the exposure</source>
        <translation>punto debole: aumentare l&apos;esposizione</translation>
    </message>
    <message>
        <source>spot too sharp: defocus the lens</source>
        <translation>punto troppo nitido: sfocare l&apos;obiettivo</translation>
    </message>
    <message>
        <source>spot too wide: focus the lens</source>
        <translation>punto troppo largo: mettere a fuoco</translation>
    </message>
    <message>
        <source>too dim</source>
        <translation>troppo debole</translation>
    </message>
    <message>
        <source>too large: {area} px</source>
        <translation>troppo grande: {area} px</translation>
    </message>
    <message>
        <source>too small: {area} px</source>
        <translation>troppo piccolo: {area} px</translation>
    </message>
</context>
<context>
    <name>support</name>
    <message>
        <source>Checks</source>
        <translation>Verifiche</translation>
    </message>
    <message>
        <source>How large the cases are and when they changed; nothing of what is in them.</source>
        <translation>Quanto sono grandi i casi e quando sono cambiati; niente di ciò che contengono.</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Registro</translation>
    </message>
    <message>
        <source>Rig file</source>
        <translation>File del banco</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Impostazioni</translation>
    </message>
    <message>
        <source>Sizes of the cases</source>
        <translation>Dimensioni dei casi</translation>
    </message>
    <message>
        <source>The rig as it is used, with its calibration.</source>
        <translation>Il banco come è usato, con la sua calibrazione.</translation>
    </message>
    <message>
        <source>Transcript of the controller</source>
        <translation>Trascrizione del controllore</translation>
    </message>
    <message>
        <source>Versions and machine</source>
        <translation>Versioni e computer</translation>
    </message>
    <message>
        <source>Versions, system, processors, memory, graphics.</source>
        <translation>Versioni, sistema, processori, memoria, grafica.</translation>
    </message>
    <message>
        <source>What program and controller said to each other: seconds, direction, line.</source>
        <translation>Ciò che programma e controllore si sono detti: secondi, direzione, riga.</translation>
    </message>
    <message>
        <source>What the program noted, the newest at the end.</source>
        <translation>Ciò che il programma ha annotato, il più recente alla fine.</translation>
    </message>
    <message>
        <source>What was checked without moving anything, each with its remedy.</source>
        <translation>Ciò che è stato verificato senza muovere nulla, ognuno col suo rimedio.</translation>
    </message>
    <message>
        <source>Without folders, recent cases and orders.</source>
        <translation>Senza cartelle, casi recenti e ordini.</translation>
    </message>
</context>
<context>
    <name>worklist</name>
    <message>
        <source>Being scanned</source>
        <translation>In scansione</translation>
    </message>
    <message>
        <source>Cannot be read</source>
        <translation>Illeggibile</translation>
    </message>
    <message>
        <source>Damaged</source>
        <translation>Danneggiato</translation>
    </message>
    <message>
        <source>Deliver it</source>
        <translation>Consegna</translation>
    </message>
    <message>
        <source>Delivered</source>
        <translation>Consegnato</translation>
    </message>
    <message>
        <source>Go on with it</source>
        <translation>Continua</translation>
    </message>
    <message>
        <source>Interrupted</source>
        <translation>Interrotto</translation>
    </message>
    <message>
        <source>Made by a newer version</source>
        <translation>Fatto con una versione più recente</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Nuovo</translation>
    </message>
    <message>
        <source>Open in another program</source>
        <translation>Aperto in un altro programma</translation>
    </message>
    <message>
        <source>Open it</source>
        <translation>Apri</translation>
    </message>
    <message>
        <source>Reconstruct it</source>
        <translation>Ricostruisci</translation>
    </message>
    <message>
        <source>Reconstructed</source>
        <translation>Ricostruito</translation>
    </message>
    <message>
        <source>Scan it</source>
        <translation>Scansiona</translation>
    </message>
    <message>
        <source>Scanned</source>
        <translation>Scansionato</translation>
    </message>
</context>
</TS>
