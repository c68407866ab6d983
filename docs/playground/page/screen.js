// What a terminal does with text: how many columns there are, and colours.

// Of more a browser makes hard work; whoever needs it downloads it.
const MOST = 200_000;

// The text, or its beginning with a word on the rest.
export function begun(text) {
    return text.length > MOST ? `${text.slice(0, text.lastIndexOf("\n", MOST) + 1)}… the rest is in the download\n` : text;
}

// How many characters of its type stand side by side in a box.
export function columnsOf(box) {
    const ruler = document.createElement("span"), style = getComputedStyle(box);
    ruler.style.cssText = `position: absolute; visibility: hidden; font: ${style.font}; white-space: pre`;
    ruler.textContent = "0".repeat(100);
    document.body.append(ruler);
    const width = ruler.getBoundingClientRect().width / 100;
    ruler.remove();
    const across = box.parentElement.clientWidth - parseFloat(style.paddingLeft) - parseFloat(style.paddingRight) - 20;
    return Math.max(Math.floor(across / width), 30);
}

// The text as nodes; the codes of colours become classes.
export function painted(text) {
    const nodes = [];
    let codes = [];
    for (const [index, piece] of text.split(/\x1b\[([0-9;]*)m/).entries()) {
        if (index % 2) codes = piece.split(";").filter(code => code !== "" && code !== "0");
        else if (codes.length) {
            const span = document.createElement("span");
            span.className = codes.map(code => `c${code}`).join(" ");
            span.textContent = piece;
            nodes.push(span);
        } else if (piece) nodes.push(piece);
    }
    return nodes;
}
