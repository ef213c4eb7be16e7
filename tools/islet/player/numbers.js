// The panel of numbers: one row for each, and which of them the timeline draws as a curve.

const digits = 3;
const prefixes = [[1e9, "G"], [1e6, "M"], [1e3, "k"], [1, ""], [1e-3, "m"], [1e-6, "µ"]];

/// A number with a unit, as 12.3 kJ.
export function withUnit(value, unit) {
    const size = Math.abs(value);
    if (!(size >= prefixes.at(-1)[0] / 200)) return `0 ${unit}`; // it would be rounded to that
    // Rounding may lead into the next prefix: 999.9 mJ is 1.00 J.
    const [scale, prefix] = prefixes.find(([s]) => Number((size / s).toPrecision(digits)) >= 1) ?? prefixes.at(-1);
    const scaled = value / scale;
    const decimals = Math.max(0, digits - 1 - Math.max(0, Math.floor(Math.log10(Number(Math.abs(scaled).toPrecision(digits))))));
    return `${scaled.toFixed(Math.min(decimals, digits - 1))} ${prefix}${unit}`;
}

const count = (n) => n.toLocaleString("en");
/// `text` says a number, `height` is how high its curve goes (the number itself if not given).
const rows = [
    { column: "kineticEnergy", label: "kinetic energy", text: (n) => withUnit(n, "J"), height: Math.sqrt },
    { column: "potentialEnergy", label: "potential energy", text: (n) => withUnit(n, "J") },
    { column: "bodies", label: "bodies", text: count },
    { column: "awakeBodies", label: "awake", text: count },
    { column: "islands", label: "islands awake", text: count },
    { column: "contacts", label: "contacts", text: count },
    { column: "touching", label: "of them touching", text: count },
    { column: "maxPenetration", label: "deepest overlap", text: (n) => withUnit(n, "m") },
    { column: "joints", label: "joints", text: count },
    { column: "maxJointError", label: "largest joint error", text: (n) => withUnit(n, "m") },
    { column: "ms", label: "time of the step", text: (n) => withUnit(n / 1000, "s") },
];

export class Numbers {
    /// `columns`: by name, an entry per frame. `onPick` is told when another row is picked.
    constructor(element, columns, onPick) {
        this.columns = columns;
        this.picked = rows[0];
        this.rows = rows.map((row) => {
            const button = document.createElement("button");
            button.className = "number";
            button.title = `Show the curve of this number: ${row.label}`;
            button.dataset.column = row.column;
            button.append(document.createElement("span"), document.createElement("output"));
            button.firstChild.textContent = row.label;
            button.addEventListener("click", () => {
                this.picked = row;
                this.#mark();
                onPick();
            });
            element.append(button);
            return { ...row, button, output: button.lastChild };
        });
        this.#mark();
    }

    /// Heights of the picked row's curve. One blow would flatten all the rest of the kinetic energy, so that is drawn by its root.
    get curve() {
        const column = this.columns[this.picked.column];
        return this.picked.height ? column.map(this.picked.height) : column;
    }

    show(frame) {
        for (const { column, text, output } of this.rows) output.textContent = text(this.columns[column][frame]);
    }

    #mark() {
        for (const { column, button } of this.rows) button.setAttribute("aria-pressed", String(column === this.picked.column));
    }
}
