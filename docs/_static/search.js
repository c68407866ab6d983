// How the search orders what it finds: a page whose title has the word before pages that mention it, and among
// these what explains before what lists and shows.
var Scorer = {
  score: ([page, title, anchor, description, score]) => {
    const words = (new URLSearchParams(location.search).get("q") ?? "").toLowerCase().split(/\s+/).filter(Boolean);
    const called = !anchor && words.length && words.every(word => title.toLowerCase().includes(word));
    return score + (called ? 20 : 0) + (/^(subjects|howto|tutorial)/.test(page) ? 3 : 0);
  },
  objNameMatch: 11,
  objPartialMatch: 6,
  objPrio: { 0: 15, 1: 5, 2: -5 },
  objPrioDefault: 0,
  title: 15,
  partialTitle: 7,
  term: 5,
  partialTerm: 2,
};
