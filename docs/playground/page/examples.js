// Commands to begin with, and what one sees.
export const EXAMPLES = [
    ["kurbel --help", "all commands; each has its own --help"],
    ["kurbel table --ratio 1:5 --lang en", "path, velocity and acceleration of the piston"],
    ["kurbel table --ratio 1:5 --columns phi,x --angle 0..90:15 --digits 20 --lang en", "twenty digits, every one right"],
    ["kurbel solve --ratio 1:5 --where c=max --lang en", "where the piston is fastest"],
    ["kurbel delta --eps 2..4 --ratio 1:4..1:6 --lang en", "the irregularity of steam engines"],
    ["kurbel flywheel --machine examples/engine.toml --lang en", "the flywheel of a machine from its file"],
    ["kurbel balance --engine v2-90 --share 0.5 --lang en", "free forces and moments of an engine"],
    ["kurbel collate roetscher-112 --lang en", "a printed table, value by value against the true ones"],
    ["kurbel table --ratio 1:5 --lang en --standalone -o table.html", "a page for the web"],
    ["kurbel table --ratio 1:5 --lang en -o table.tex", "LaTeX, to be included in a document"],
    ["kurbel table --ratio 1:5 --lang en -o table.pdf", "PDF; what sets it, 26 MB, is loaded first"],
    ["kurbel table --ratio 1:4 --step 0.5 -o turn.csv", "numbers for a spreadsheet"],
    ["kurbel layouts --lang en", "all arrangements of tables"],
];
