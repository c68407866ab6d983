"use strict";
// A drawing in steps: what a step draws is shown from there on. Nothing is computed here.
(() => {
  const page = document.querySelector(".lesson");
  const one = name => page.querySelector(`.lesson-${name}`);
  const parts = [...page.querySelectorAll("[data-step]")];
  const sentences = [...page.querySelectorAll(".lesson-steps > li")];
  const last = sentences.length, at = one("at");
  // Behind the last step all of them are shown, and none is the present one.
  const all = last + 1;
  let step = 1;

  function show(number, told = true) {
    step = Math.min(Math.max(number, 1), all);
    for (const part of parts) {
      const own = Number(part.dataset.step);
      part.classList.toggle("lesson-later", own > step);
      part.classList.toggle("lesson-now", own === step);
    }
    sentences.forEach((sentence, place) => {
      sentence.classList.toggle("lesson-later", place + 1 > step);
      if (place + 1 === step) sentence.setAttribute("aria-current", "step");
      else sentence.removeAttribute("aria-current");
    });
    at.textContent = step === all ? at.dataset.whole.replace("{}", last) : at.dataset.of.replace("{}", step).replace("{}", last);
    one("start").disabled = one("back").disabled = step === 1;
    one("next").disabled = one("all").disabled = step === all;
    if (told) history.replaceState(null, "", step === all ? "#all" : `#step-${step}`);
  }

  function asked() {
    if (location.hash === "#all") return all;
    return Number(/^#step-(\d+)$/.exec(location.hash)?.[1] ?? 1);
  }

  one("start").addEventListener("click", () => show(1));
  one("back").addEventListener("click", () => show(step - 1));
  one("next").addEventListener("click", () => show(step + 1));
  one("all").addEventListener("click", () => show(all));
  sentences.forEach((sentence, place) => sentence.addEventListener("click", () => show(place + 1)));
  addEventListener("hashchange", () => show(asked(), false));
  addEventListener("keydown", event => {
    // A table that is wider than the screen is moved by the same keys.
    if (event.altKey || event.ctrlKey || event.metaKey || event.shiftKey || event.target.closest?.(".scroll")) return;
    const turn = {ArrowLeft: -1, ArrowRight: 1}[event.key];
    if (!turn) return;
    event.preventDefault();
    show(step + turn);
  });
  one("choices").hidden = false;
  page.classList.add("lesson-live");
  show(asked(), false);
})();
