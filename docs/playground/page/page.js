// Of a worker's own address the page's rules would not hold; of one that the page wrote they do.
const begin = new Blob([`import "${new URL("worker.js", import.meta.url)}";`], { type: "text/javascript" });
const worker = new Worker(URL.createObjectURL(begin), { type: "module" });
worker.onmessage = ({ data }) => {
    const screen = document.getElementById("screen");
    if (data.kind === "ready")
        worker.postMessage({ number: 1, action: "run", words: ["kurbel table --ratio 1:5 --lang en", 100] });
    else if (data.kind === "answer") screen.textContent = new TextDecoder().decode(data.answer.out) + data.answer.err;
    else if (data.kind === "failed") screen.textContent = data.reason;
};
