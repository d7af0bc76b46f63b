//! The linear systems of the polynomials: from the neighbours, or from conditions anywhere.

use crate::board::{Board, LETTERS, cell, two};
use crate::number::{self, number as numeral, symbol};
use crate::segment::Part;
use levalab_core::Svaj;
use levalab_core::law::{Data, condition_system, end_system};
use levalab_formula::Formula;
use levalab_formula::exact::Exact;

/// Most unknowns with which a system is written out; a larger one would not fit on a page.
const WRITTEN_OUT: usize = 8;

/// The polynomial that takes s, v, a (and j) from both neighbours.
pub fn between_neighbours(board: &mut Board, part: &Part, orders: usize) {
    let Some(form) = part.whole() else { return };
    let form = form.clone().scaled(board.scale(), 0.0);
    let (start, end) = (form.at(0.0), form.at(1.0));
    let scale = form.coefficients().unwrap_or_default().iter().fold(0.0_f64, |size, c| size.max(c.abs()));
    board.say(
        two(
            "It takes its ends from the neighbouring segments; with respect to $x$, $s' = β v$, $s'' = β^2 a$ and $s''' = β^3 j$:",
            "Toma sus extremos de los tramos vecinos; respecto a $x$, $s' = β v$, $s'' = β^2 a$ y $s''' = β^3 j$:",
        ),
        &[],
    );
    let side = |motion: Svaj| {
        let each = (0..orders).map(|order| {
            let value = number::result(number::settled(motion.order(order), scale));
            format!("s{} = {value}", "'".repeat(order))
        });
        each.collect::<Vec<_>>().join(", ")
    };
    board.show(&format!("x = 0 ⇒ {}", side(start)));
    board.show(&format!("x = 1 ⇒ {}", side(end)));
    board.say(
        two(
            "The polynomial $s = c_0 + c_1 x + … + c_n x^n$ has as many coefficients as there are conditions, $n = {n}$. Those at $x = 0$ give the first ones, $c_k = (s^{(k)})/(k{!})$:",
            "El polinomio $s = c_0 + c_1 x + … + c_n x^n$ tiene tantos coeficientes como condiciones hay, $n = {n}$. Las de $x = 0$ dan los primeros, $c_k = (s^{(k)})/(k{!})$:",
        ),
        &[("n", &(2 * orders - 1).to_string())],
    );
    let (lower, system) = end_system(orders, start, end);
    let settled = |value: f64| number::result(number::settled(value, scale));
    board.show(
        &lower.iter().enumerate().map(|(k, c)| format!("c_{k} = {}", settled(*c))).collect::<Vec<_>>().join(", "),
    );
    board.say(
        two("Those at $x = 1$ are a system for the others:", "Las de $x = 1$ son un sistema para los demás:"),
        &[],
    );
    let unknowns: Vec<usize> = (orders..2 * orders).collect();
    let known: Vec<f64> = system.known.iter().map(|&value| number::settled(value, scale)).collect();
    board.equate(
        Formula::Product(vec![matrix(&system.matrix, exactly), letters(&unknowns)]),
        vec![('=', vector(&known.iter().map(|&value| number::result(value)).collect::<Vec<_>>()))],
    );
    let (Some(inverse), Some(found)) = (system.inverse(), form.coefficients()) else { return };
    let known = vector(&known.iter().map(|&value| number::result(value)).collect::<Vec<_>>());
    board.say(two("and with the inverse of its matrix:", "y con la inversa de su matriz:"), &[]);
    board.equate(
        letters(&unknowns),
        vec![
            ('=', Formula::Product(vec![matrix(&inverse, exactly), known])),
            ('=', vector(&number::coefficients(&found)[orders.min(found.len())..])),
        ],
    );
    board.say(two("So, with $s$ in $x$:", "Así, con $s$ en función de $x$:"), &[]);
}

/// The polynomial, or the spline, through the conditions of the design.
pub fn conditions(board: &mut Board, part: &Part) {
    let Some(conditions) = part.segment.data.conditions() else { return };
    let (scale, beta) = (board.scale(), part.beta());
    let heads = vec![
        board.line(two("No.", "N.º"), &[]),
        cell("θ"),
        cell("x"),
        board.line(two("condition", "condición"), &[]),
        board.line(two("with respect to $x$", "respecto a $x$"), &[]),
    ];
    let rows = conditions.iter().enumerate().map(|(i, condition)| {
        let order = usize::from(condition.order).min(3);
        let value = condition.value * scale;
        let in_x = number::result(value * beta.powi(order as i32));
        vec![
            crate::document::line(&(i + 1).to_string()),
            cell(&board.place(part.from + condition.at)),
            cell(&number::height(condition.at / beta)),
            cell(&format!("{} = {}{}", LETTERS[order], number::datum(value), board.unit(order))),
            cell(&format!("s{} = {in_x}", "'".repeat(order))),
        ]
    });
    let rows = rows.collect();
    board.table(two("Conditions", "Condiciones"), heads, rows);
    if part.segment.law.id == "polynomial" {
        powers(board, part);
    } else {
        spline(board, part);
    }
}

fn powers(board: &mut Board, part: &Part) {
    let Some(parts) = condition_system(&part.segment.data, part.segment.beta) else { return };
    let scale = board.scale();
    let n = parts.given.len() + parts.unknown.len();
    board.say(
        two(
            "As many coefficients as conditions: $s = c_0 + c_1 x + … + c_n x^n$ with $n = {n}$. A condition on the derivative of order $m$ at $x$ is the row",
            "Tantos coeficientes como condiciones: $s = c_0 + c_1 x + … + c_n x^n$ con $n = {n}$. Una condición sobre la derivada de orden $m$ en $x$ es la fila",
        ),
        &[("n", &n.saturating_sub(1).to_string())],
    );
    board.show("(m{!})/(0{!}) c_m + ((m + 1){!})/(1{!}) c_(m+1) x + … + (n{!})/((n - m){!}) c_n x^(n - m) = s^{(m)}");
    if !parts.given.is_empty() {
        board.say(two("Those at $x = 0$ give a coefficient each:", "Las de $x = 0$ dan un coeficiente cada una:"), &[]);
        let each = parts.given.iter().map(|(k, c)| format!("c_{k} = {}", number::result(c * scale)));
        board.show(&each.collect::<Vec<_>>().join(", "));
    }
    let system = &parts.system;
    if (1..=WRITTEN_OUT).contains(&parts.unknown.len()) {
        let numbers = |value: f64| numeral(&number::entry(value));
        let known = |values: &[f64]| vector(&values.iter().map(|&c| number::result(c * scale)).collect::<Vec<_>>());
        board.say(two("The others are a system for the rest:", "Las demás son un sistema para el resto:"), &[]);
        board.equate(
            Formula::Product(vec![matrix(&system.matrix, numbers), letters(&parts.unknown)]),
            vec![('=', known(&system.known))],
        );
        let reduced = system.eliminated();
        if parts.unknown.len() > 1 {
            board.say(
                two(
                    "Gaussian elimination (rows in the order of their pivots) makes it triangular:",
                    "La eliminación de Gauss (filas en el orden de sus pivotes) la hace triangular:",
                ),
                &[],
            );
            board.equate(
                Formula::Product(vec![matrix(&reduced.matrix, numbers), letters(&parts.unknown)]),
                vec![('=', known(&reduced.known))],
            );
            board.say(two("and from the last row up:", "y de la última fila hacia arriba:"), &[]);
        }
    } else if parts.unknown.len() > WRITTEN_OUT {
        board.say(
            two(
                "The {count} rows that are left are solved in Chebyshev's polynomials, which keep the digits that powers lose:",
                "Las {count} filas restantes se resuelven en polinomios de Chebyshev, que conservan las cifras que pierden las potencias:",
            ),
            &[("count", &parts.unknown.len().to_string())],
        );
    }
    let Some(found) = part.whole().and_then(|form| form.clone().scaled(scale, 0.0).coefficients()) else { return };
    let texts = number::coefficients(&found);
    let each = parts.unknown.iter().filter_map(|&k| Some(format!("c_({k}) = {}", texts.get(k)?)));
    board.show(&each.collect::<Vec<_>>().join(", "));
    let doubt = board.cam().program.doubts().iter().find(|doubt| doubt.segment == part.stretches[0].segment);
    if let Some(doubt) = doubt {
        board.say(
            two(
                "Beware: the condition number of the system is {number}; errors of the data come out that many times larger.",
                "Cuidado: el número de condición del sistema es {number}; los errores de los datos se amplifican otras tantas veces.",
            ),
            &[("number", &format!("${}$", number::result(doubt.condition)))],
        );
    }
}

fn spline(board: &mut Board, part: &Part) {
    let degree = part.segment.parameters[0];
    board.say(
        two(
            "A B-spline of degree $n = {n}$ has as many coefficients as conditions, $s = b_1 N_1(x) + b_2 N_2(x) + …$, and each condition is a row of a system for them, $b_1 N_1^{(m)} + b_2 N_2^{(m)} + … = s^{(m)}$. Its knots part the segment into polynomials that join up to the derivative of order $n - 1$:",
            "Una B-spline de grado $n = {n}$ tiene tantos coeficientes como condiciones, $s = b_1 N_1(x) + b_2 N_2(x) + …$, y cada condición es una fila de un sistema para ellos, $b_1 N_1^{(m)} + b_2 N_2^{(m)} + … = s^{(m)}$. Sus nudos dividen el tramo en polinomios que enlazan hasta la derivada de orden $n - 1$:",
        ),
        &[("n", &number::datum(degree))],
    );
    let mut knots: Vec<String> =
        part.stretches.iter().map(|stretch| number::part((stretch.from - part.from) / part.beta())).collect();
    knots.push("1".into());
    board.show(&format!("x = {}", knots.join(", ")));
    if !matches!(part.segment.data, Data::Spline { .. }) {
        let about =
            two("Each of them is the mean of $n$ neighbouring places.", "Cada uno es la media de $n$ lugares vecinos.");
        board.say(about, &[]);
    }
}

fn matrix(rows: &[Vec<f64>], entry: impl Fn(f64) -> Formula) -> Formula {
    Formula::Matrix(rows.iter().map(|row| row.iter().map(|&value| entry(value)).collect()).collect())
}

/// A fraction when it is one.
fn exactly(value: f64) -> Formula {
    let sign = if value < 0.0 { "-" } else { "" };
    let known = Exact::of(value).filter(Exact::is_simple).map(|exact| format!("{sign}{}", exact.notation("")));
    known.map_or_else(|| numeral(&number::result(value)), |text| crate::document::formula(&text))
}

fn vector(entries: &[String]) -> Formula {
    Formula::Matrix(entries.iter().map(|entry| vec![numeral(entry)]).collect())
}

fn letters(powers: &[usize]) -> Formula {
    Formula::Matrix(powers.iter().map(|k| vec![symbol(&format!("c_{k}"))]).collect())
}
