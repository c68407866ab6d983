// Compiles the packages in a folder with the Python that browsers will run: node compile.mjs PYODIDE FOLDER.
import { pathToFileURL } from "node:url";

const [pyodide, folder] = process.argv.slice(2);
const { loadPyodide } = await import(pathToFileURL(pyodide).href);
const python = await loadPyodide();
python.mountNodeFS("/packages", folder);
const compiled = python.runPython(`
import compileall, py_compile

unchecked = py_compile.PycInvalidationMode.UNCHECKED_HASH
bool(compileall.compile_dir("/packages", quiet=1, maxlevels=20, invalidation_mode=unchecked))
`);
process.exit(compiled ? 0 : 1);
