//! The manual: a section for each part of the page. Names of buttons are keys of the page's own strings.

use super::{Two, two};

/// A section of the manual.
pub struct Screen {
    /// Its place in the page.
    pub id: &'static str,
    /// Its heading.
    pub name: Two,
    /// Its text, in the markup of [`crate::html`].
    pub text: Two,
}

/// Every section, in the order of the page.
pub const SCREENS: &[Screen] = &[
    Screen {
        id: "start",
        name: two("In a minute", "En un minuto"),
        text: two(
            "LevaLab opens with a cam that turns. Change any number: cam, diagrams and verdict follow at once. There is nothing to calculate and nothing to save: the whole design is in the address of the page.

- Choose another cam under {header.examples}.
- Press {transport.pause}, and drag the cam or a diagram: one cursor $θ$ moves everything.
- Read the verdict below. What is wrong is told with its place, and its cure is a button.
- {header.share} puts the whole design on the clipboard as a link.

The question mark beside a magnitude explains it; {help.tour} under {header.help} shows the page around.",
            "LevaLab se abre con una leva que gira. Cambie cualquier número: la leva, los diagramas y el veredicto responden al momento. No hay nada que calcular ni que guardar: todo el diseño está en la dirección de la página.

- Elija otra leva en {header.examples}.
- Pulse {transport.pause} y arrastre la leva o un diagrama: un único cursor $θ$ lo mueve todo.
- Lea el veredicto de abajo. Lo que está mal se dice con su lugar, y su remedio es un botón.
- {header.share} copia todo el diseño en forma de enlace.

La interrogación junto a una magnitud la explica; {help.tour}, en {header.help}, enseña la página.",
        ),
    },
    Screen {
        id: "design",
        name: two("Design panel", "Panel de diseño"),
        text: two(
            "{design.follower}: six drawings, one for each follower. A change keeps every number that makes sense in the new one.

{design.geometry}: the drawing shows what each field measures; click a dimension to go to its field. Type with decimal point or comma, use the arrow keys, or drag sideways on the symbol. {design.rotation} is the sense in which the cam turns, {design.length-unit} the unit of all lengths. Another unit asks whether the cam is to stay the same, its numbers converted, or the numbers, of another cam; a design that is converted back is as it was.

{design.program}: each row is a segment, with its law, its angle $β$ and its rise $L$. The number at the left is a handle to move it, and ⋯ holds {action.insert-before}, {action.insert-after}, {action.duplicate}, {action.up}, {action.down} and {action.delete}. {segments.add} adds one at the end. {segments.auto} asks only what the machine must do, dwells, lines and points, and joins them by the smoothest laws, saying which and why. They are drawn on the diagram of $s$ or typed in the table below it, which show the same: drag across the empty diagram for a dwell or a line, click for a point; then drag a bar, an end or a point, and the curve follows; the tangent of a point is turned to give it a velocity. All goes to round values, ten times finer with Alt. With the keyboard, the arrows move what has the focus and Del removes it; {header.undo} takes back one step. Below the program, the panel tells what is missing for 360° and for closing the height, and offers {segments.fill}, {segments.fill.return}, {segments.stretch} or {segments.spread}.

A number that cannot be is explained beside its field; the last good cam stays on screen, dimmed.",
            "{design.follower}: seis dibujos, uno por seguidor. Al cambiar se conservan todos los números que tienen sentido en el nuevo.

{design.geometry}: el dibujo muestra qué mide cada campo; al pulsar una cota se va a su campo. Se escribe con coma o punto decimal, con las flechas, o arrastrando el símbolo hacia los lados. {design.rotation} es el sentido en que gira la leva y {design.length-unit} la unidad de todas las longitudes. Al cambiarla se pregunta qué debe quedar igual: la leva, con sus números convertidos, o los números, que serán de otra leva; un diseño que se convierte de vuelta queda como estaba.

{design.program}: cada fila es un tramo, con su ley, su ángulo $β$ y su elevación $L$. El número de la izquierda es un asidero para moverlo, y ⋯ contiene {action.insert-before}, {action.insert-after}, {action.duplicate}, {action.up}, {action.down} y {action.delete}. {segments.add} añade uno al final. {segments.auto} pide solo lo que debe hacer la máquina, detenimientos, rectas y puntos, y lo une con las leyes más suaves, diciendo cuáles y por qué. Se dibujan sobre el diagrama de $s$ o se escriben en la tabla de debajo, que muestran lo mismo: arrastre sobre el diagrama vacío para un detenimiento o una recta, y haga clic para un punto; después arrastre una barra, un extremo o un punto, y la curva lo sigue; la tangente de un punto se gira para darle una velocidad. Todo va a valores redondos, diez veces más finos con Alt. Con el teclado, las flechas mueven lo que tiene el foco y Supr lo quita; {header.undo} deshace un paso. Debajo del programa, el panel dice lo que falta para 360° y para cerrar la altura, y ofrece {segments.fill}, {segments.fill.return}, {segments.stretch} o {segments.spread}.

Un número imposible se explica junto a su campo; la última leva válida sigue en pantalla, atenuada.",
        ),
    },
    Screen {
        id: "mechanism",
        name: two("Mechanism and animation", "Mecanismo y animación"),
        text: two(
            "Cam and follower to scale. Drag the cam to turn it by hand; drag beside it to move the picture; the wheel or two fingers zoom, and {stage.fit} shows all of it.

{stage.layers} lays over it {stage.layer.base}, {stage.layer.prime}, {stage.layer.pitch}, {stage.layer.axes}, {stage.layer.normal}, {stage.layer.osculating} and {stage.layer.stations}, the graphical construction.

{transport.play} and {transport.pause} turn and stop the cam; −1° and +1° step it; the slider and the field beside it set $θ$. {transport.speed} is a hand wheel: in the middle the cam stands still. The time of a turn is told as it is shown and as it really is.",
            "Leva y seguidor a escala. Arrastre la leva para girarla a mano; arrastre fuera de ella para desplazar el dibujo; la rueda o dos dedos acercan, y {stage.fit} lo muestra entero.

{stage.layers} superpone {stage.layer.base}, {stage.layer.prime}, {stage.layer.pitch}, {stage.layer.axes}, {stage.layer.normal}, {stage.layer.osculating} y {stage.layer.stations}, que es la construcción gráfica.

{transport.play} y {transport.pause} mueven y detienen la leva; −1° y +1° la hacen avanzar por grados; la barra y el campo de al lado fijan $θ$. {transport.speed} es un volante: en el centro la leva está quieta. La duración de una vuelta se dice tal como se ve y tal como es.",
        ),
    },
    Screen {
        id: "diagrams",
        name: two("Diagrams and instant values", "Diagramas y valores instantáneos"),
        text: two(
            "*SVAJ* shows $s$, $v$, $a$ and $j$; *φ* the pressure angle with its limit; *ρ* the radius of curvature. Each quantity has one colour and one dash everywhere. A circle left open at a jump is the limit from the left, a filled one that from the right.

{diagram.per.radian.short} shows derivatives with respect to $θ$, {diagram.per.second.short} with respect to time. Drag over a diagram to move the cursor. Below are the {readout.title} at the cursor.",
            "*SVAJ* muestra $s$, $v$, $a$ y $j$; *φ*, el ángulo de presión con su límite; *ρ*, el radio de curvatura. Cada magnitud tiene el mismo color y el mismo trazo en todas partes. En un salto, el círculo hueco es el límite por la izquierda y el lleno, por la derecha.

{diagram.per.radian.short} muestra las derivadas respecto a $θ$ y {diagram.per.second.short}, respecto al tiempo. Arrastre sobre un diagrama para mover el cursor. Debajo están los {readout.title} en el cursor.",
        ),
    },
    Screen {
        id: "verdict",
        name: two("Verdict", "Veredicto"),
        text: two(
            "A light with a shape and a word: *acceptable* (disc), *not for high speeds* (triangle), *unacceptable* (octagon). Beside it the {verdict.figures}, which lead to where they are reached.

Each of the {verdict.findings} says what is wrong, where and by how much; its angles move the cursor there. The buttons under it are cures computed for this very cam, tried before they are offered; one click applies them and {header.undo} takes them back.",
            "Una señal con forma y palabra: *aceptable* (disco), *no apta para altas velocidades* (triángulo), *inaceptable* (octógono). A su lado, las {verdict.figures}, que llevan a donde se alcanzan.

Cada una de las {verdict.findings} dice qué está mal, dónde y cuánto; sus ángulos llevan allí el cursor. Los botones de debajo son remedios calculados para esta misma leva y probados antes de ofrecerlos; un clic los aplica y {header.undo} los retira.",
        ),
    },
    Screen {
        id: "application",
        name: two("Application", "Aplicación"),
        text: two(
            "{design.application}, below the program, opens a panel beside the mechanism for what the follower drives: a force, a piston on enclosed fluid, a pump or a valve. Its parameters are part of the design, in the link, the file and the exports.

Each output has its diagram, {application.against.theta} or {application.against.time}, with the page's own cursor and the value there. Under {application.targets} type or paste places and values, one to a line; they are ringed in the diagram, and the table tells what is found at each and the error. A place in the table takes the cursor there.",
            "{design.application}, bajo el programa, abre junto al mecanismo un panel para lo que mueve el seguidor: una fuerza, un pistón sobre fluido encerrado, una bomba o una válvula. Sus parámetros son parte del diseño, del enlace, del archivo y de las exportaciones.

Cada resultado tiene su diagrama, {application.against.theta} o {application.against.time}, con el mismo cursor de la página y el valor en él. En {application.targets} escriba o pegue lugares y valores, uno por línea; se rodean en el diagrama, y la tabla dice el resultado y el error en cada uno. Un lugar de la tabla lleva allí el cursor.",
        ),
    },
    Screen {
        id: "compare",
        name: two("Compare", "Comparar"),
        text: two(
            "{compare.title} opens a panel with two views. Under {compare.view.slate}, {compare.pin} keeps the cam at hand: its curves stay in every diagram and its outline on the mechanism while you change the design or open another. The table puts geometry, peaks, $φ$, $ρ$ and verdict side by side; a pinned design can be renamed, moved, hidden, removed, or opened with {compare.load}.

Under {compare.view.laws} the program at hand is moved by every law in turn, ranked by whichever column you choose; {compare.use} adopts a law and {compare.pin.short} keeps it for comparison.",
            "{compare.title} abre un panel con dos vistas. En {compare.view.slate}, {compare.pin} conserva la leva actual: sus curvas quedan en todos los diagramas y su contorno sobre el mecanismo mientras cambia el diseño o abre otro. La tabla pone lado a lado geometría, máximos, $φ$, $ρ$ y veredicto; un diseño fijado se puede renombrar, mover, ocultar, quitar, o abrir con {compare.load}.

En {compare.view.laws} el programa actual se mueve con cada una de las leyes, ordenadas por la columna que elija; {compare.use} adopta una ley y {compare.pin.short} la conserva para compararla.",
        ),
    },
    Screen {
        id: "solution",
        name: two("Worked solution", "Solución desarrollada"),
        text: two(
            "{header.solution} derives the cam on screen as on a blackboard: the data; the conditions, the linear system and the formulas of each segment; the limits at every joint; where each derivative is greatest; the size that $φ$ and $ρ$ ask for; and the verdict, argued. It follows the design while you change it.

{solution.segment} picks one segment. {solution.theta} puts numbers into all formulas at an angle of your choice, {solution.follows} at that of the cursor; left empty, where $|v|$ is greatest. {solution.latex} and {solution.markdown} take the text along, {solution.print} puts it on paper. The solved examples R1 to R6 have a button that opens them with it.",
            "{header.solution} desarrolla la leva en pantalla como en la pizarra: los datos; las condiciones, el sistema lineal y las fórmulas de cada tramo; los límites en cada unión; dónde es máxima cada derivada; el tamaño que piden $φ$ y $ρ$; y el veredicto, razonado. Sigue al diseño mientras usted lo cambia.

{solution.segment} elige un solo tramo. {solution.theta} sustituye números en todas las fórmulas en el ángulo que elija, {solution.follows} en el del cursor; vacío, donde $|v|$ es máxima. {solution.latex} y {solution.markdown} se llevan el texto y {solution.print} lo pasa a papel. Los ejemplos resueltos R1 a R6 tienen un botón que los abre con ella.",
        ),
    },
    Screen {
        id: "files",
        name: two("Links and files", "Enlaces y archivos"),
        text: two(
            "{header.share} copies a link that holds the whole design: nothing is sent to any server. A link that was damaged on the way is told, and never opened as another cam.

Under {header.files}, {header.save} keeps the design as a file and {header.open} brings it back; a file can also be dropped on the page. {header.recent} lists the designs that this browser keeps; each tab has a design of its own. {header.undo} and {header.redo} cover everything, an opened link or file too.

From the second visit on the page works without the network, and browsers offer to install it. A new version is announced and taken over whole, when you say so.",
            "{header.share} copia un enlace que contiene todo el diseño: nada se envía a ningún servidor. Si un enlace se estropea por el camino, se avisa y nunca se abre como otra leva.

En {header.files}, {header.save} guarda el diseño en un archivo y {header.open} lo recupera; un archivo también puede soltarse sobre la página. {header.recent} enumera los diseños que guarda este navegador; cada pestaña tiene el suyo. {header.undo} y {header.redo} lo cubren todo, también un enlace o un archivo abiertos.

Desde la segunda visita la página funciona sin red, y los navegadores ofrecen instalarla. Una versión nueva se anuncia y se adopta entera, cuando usted lo diga.",
        ),
    },
    Screen {
        id: "export",
        name: two("Export", "Exportar"),
        text: two(
            "{export.title} is under {header.files}. What it writes is loaded when it is first asked for; in the single file, {export.save} is left to the command line.

- *XLSX* and *CSV* hold the design, the motion by angle and by time, the profile in polar and cartesian coordinates, the pitch curve, the verdict and, when there is one, the application; you choose the step of the angle. Numbers are numbers, with the decimal sign of the language's spreadsheets.
- *DXF* holds the profile, the pitch curve and the base and prime circles, each on its layer, for CAD.
- *STL* is a solid to print or to mill, with thickness, bore and keyway.
- *SVG* and *PNG* are the cam to scale, or a diagram.",
            "{export.title} está en {header.files}. Lo que escribe los archivos se carga la primera vez que se pide; en la página de un solo archivo, {export.save} queda para la línea de órdenes.

- *XLSX* y *CSV* contienen el diseño, el movimiento por ángulo y por tiempo, el perfil en coordenadas polares y cartesianas, la curva de paso, el veredicto y, si la hay, la aplicación; usted elige el paso del ángulo. Cada número llega como número, con el signo decimal de las hojas de cálculo del idioma.
- *DXF* contiene el perfil, la curva de paso y las circunferencias base y primaria, cada una en su capa, para CAD.
- *STL* es un sólido para imprimir o fresar, con espesor, agujero y chavetero.
- *SVG* y *PNG* son la leva a escala, o un diagrama.",
        ),
    },
    Screen {
        id: "print",
        name: two("Print", "Imprimir"),
        text: two(
            "{print.title}, Ctrl P, makes a report of one to three A4 pages: design and program, the cam at true scale where it fits, with a line to check the printer by, the verdict with its cures, the diagrams and the table at the step that you choose under {print.table}. Of a pair both cams are shown; an application brings its diagrams and the error at each point. Everything is drawn in lines.

The browser's own print gives the same report, with the cam as it stands on the screen unless {print.title} was opened before.",
            "{print.title}, Ctrl P, compone un informe de una a tres páginas A4: diseño y programa, la leva a escala real si cabe, con una línea para comprobar la impresora, el veredicto con sus remedios, los diagramas y la tabla con el paso que elija en {print.table}. De una pareja se muestran las dos levas; una aplicación aporta sus diagramas y el error en cada punto. Todo se dibuja con líneas.

La impresión del propio navegador da el mismo informe, con la leva tal como está en la pantalla si no se abrió antes {print.title}.",
        ),
    },
    Screen {
        id: "view",
        name: two("Language, theme and projector", "Idioma, tema y proyector"),
        text: two(
            "*ES* and *EN* change the language in place; the half disc changes between the light and the dark theme and that of the system. {header.projector}, or the key P, enlarges type and strokes and leaves mechanism, diagrams and verdict for the classroom. There {projector.speed} adds the hand wheel of the animation, and {projector.values} the instant values of the chosen diagrams in large figures; Esc leads back.",
            "*ES* y *EN* cambian el idioma sobre la marcha; el medio disco alterna entre el tema claro, el oscuro y el del sistema. {header.projector}, o la tecla P, agranda letra y trazos y deja el mecanismo, los diagramas y el veredicto para el aula. Allí {projector.speed} añade el volante de la animación, y {projector.values} los valores instantáneos de los diagramas elegidos en cifras grandes; con Esc se vuelve.",
        ),
    },
    Screen {
        id: "keyboard",
        name: two("Keyboard", "Teclado"),
        text: two(
            "Everything is reached with Tab. Besides:

- *Space*: {help.play}. *← →*: {help.step}.
- *Ctrl Z*, *Ctrl Y*: {help.undo}.
- *↑ ↓*: {help.step-field}. *Esc*: {help.escape}.
- *Alt ↑*, *Alt ↓*: {help.move}.
- *P*, *Esc*: {help.projector}. *S*, *V*: {help.projector.shown}. *?*: {help.help}.",
            "A todo se llega con el tabulador. Además:

- *Espacio*: {help.play}. *← →*: {help.step}.
- *Ctrl Z*, *Ctrl Y*: {help.undo}.
- *↑ ↓*: {help.step-field}. *Esc*: {help.escape}.
- *Alt ↑*, *Alt ↓*: {help.move}.
- *P*, *Esc*: {help.projector}. *S*, *V*: {help.projector.shown}. *?*: {help.help}.",
        ),
    },
];
