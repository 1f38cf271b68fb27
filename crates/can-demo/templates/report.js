"use strict";
// Colours, and the filter of the trace. The page is whole without it.
(function () {
  const root = document.documentElement;
  const byId = (id) => document.getElementById(id);

  const icons = {
    light: '<svg viewBox="0 0 20 20" width="18" height="18" aria-hidden="true"><circle cx="10" cy="10" r="4" fill="currentColor"/><path d="M10 1v3M10 16v3M1 10h3M16 10h3M3.6 3.6l2.1 2.1M14.3 14.3l2.1 2.1M3.6 16.4l2.1-2.1M14.3 5.7l2.1-2.1" stroke="currentColor" stroke-width="1.6"/></svg>',
    dark: '<svg viewBox="0 0 20 20" width="18" height="18" aria-hidden="true"><path d="M16.5 12.6A7 7 0 0 1 7.4 3.5 7 7 0 1 0 16.5 12.6z" fill="currentColor"/></svg>',
    auto: '<svg viewBox="0 0 20 20" width="18" height="18" aria-hidden="true"><circle cx="10" cy="10" r="7" fill="none" stroke="currentColor" stroke-width="1.6"/><path d="M10 3a7 7 0 0 1 0 14z" fill="currentColor"/></svg>',
  };
  const order = ["auto", "light", "dark"];
  const button = byId("theme");
  function show(name) {
    if (name === "auto") delete root.dataset.theme;
    else root.dataset.theme = name;
    button.innerHTML = icons[name];
    const said = "Colours: " + { auto: "as the system", light: "light", dark: "dark" }[name];
    button.setAttribute("aria-label", said);
    button.title = said;
  }
  let theme = root.dataset.theme || "auto";
  show(theme);
  button.hidden = false;
  button.addEventListener("click", () => {
    theme = order[(order.indexOf(theme) + 1) % order.length];
    show(theme);
    try {
      if (theme === "auto") localStorage.removeItem("canpac-theme");
      else localStorage.setItem("canpac-theme", theme);
    } catch (e) { /* a browser without storage forgets the choice */ }
  });

  const steps = [...document.querySelectorAll(".step")].map((element) => ({
    element,
    node: element.dataset.node,
    error: element.classList.contains("e-error") || element.classList.contains("e-restart"),
    words: element.querySelector("summary").textContent.toLowerCase(),
    rows: [...element.querySelectorAll("tr")].map((row) => ({ row, times: Number(row.dataset.times), write: row.classList.contains("w"), words: row.textContent.toLowerCase() })),
  }));
  const parts = [...document.querySelectorAll(".part")];
  const words = byId("words"), errors = byId("errors"), count = byId("count");
  const chosen = (name) => new Set([...document.querySelectorAll("input[name=" + name + "]:checked")].map((box) => box.value));
  function filter() {
    const wanted = words.value.toLowerCase().split(/\s+/).filter(Boolean);
    const nodes = chosen("node"), ways = chosen("way");
    let shown = 0, all = 0;
    for (const step of steps) {
      let any = false;
      for (const { row, times, write, words } of step.rows) {
        // A word may stand in the row or in what its step is about.
        const found = wanted.every((word) => words.includes(word) || step.words.includes(word));
        const visible = ways.has(write ? "w" : "r") && nodes.has(step.node) && (!errors.checked || step.error) && found;
        row.hidden = !visible;
        any = any || visible;
        shown += visible ? times : 0;
        all += times;
      }
      step.element.hidden = !any;
      if (wanted.length && any) step.element.open = true;
    }
    for (const part of parts) {
      let next = part.nextElementSibling, any = false;
      while (next && next.classList.contains("step")) { any = any || !next.hidden; next = next.nextElementSibling; }
      part.hidden = !any;
    }
    count.textContent = shown === all ? all + " accesses" : shown + " of " + all + " accesses";
  }
  const set = (open) => steps.forEach((step) => { if (!step.element.hidden) step.element.open = open; });
  byId("open").addEventListener("click", () => set(true));
  byId("close").addEventListener("click", () => set(false));
  byId("filter").addEventListener("input", filter);
  byId("filter").addEventListener("submit", (event) => event.preventDefault());
  const asked = new URLSearchParams(location.search).get("filter");
  if (asked) words.value = asked;
  filter();
})();
