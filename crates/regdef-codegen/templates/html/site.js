"use strict";
// Theme, navigation on small screens, and search. Works from file:// and fetches nothing: the search index is a
// script that is added when the search is first used.
(function () {
  const root = document.documentElement;
  const base = root.dataset.root || "";
  const params = new URLSearchParams(location.search);
  const byId = (id) => document.getElementById(id);

  // Theme: what the system says, until the reader says otherwise.
  const themeButton = byId("site-theme");
  const icons = {
    light: '<svg viewBox="0 0 20 20" width="18" height="18" aria-hidden="true"><circle cx="10" cy="10" r="4" fill="currentColor"/><path d="M10 1v3M10 16v3M1 10h3M16 10h3M3.6 3.6l2.1 2.1M14.3 14.3l2.1 2.1M3.6 16.4l2.1-2.1M14.3 5.7l2.1-2.1" stroke="currentColor" stroke-width="1.6"/></svg>',
    dark: '<svg viewBox="0 0 20 20" width="18" height="18" aria-hidden="true"><path d="M16.5 12.6A7 7 0 0 1 7.4 3.5 7 7 0 1 0 16.5 12.6z" fill="currentColor"/></svg>',
    auto: '<svg viewBox="0 0 20 20" width="18" height="18" aria-hidden="true"><circle cx="10" cy="10" r="7" fill="none" stroke="currentColor" stroke-width="1.6"/><path d="M10 3a7 7 0 0 1 0 14z" fill="currentColor"/></svg>',
  };
  const order = ["auto", "light", "dark"];
  function showTheme(name) {
    if (name === "auto") delete root.dataset.theme;
    else root.dataset.theme = name;
    themeButton.innerHTML = icons[name];
    const said = { auto: "as the system", light: "light", dark: "dark" }[name];
    themeButton.setAttribute("aria-label", "Colours: " + said);
    themeButton.title = "Colours: " + said;
  }
  let theme = root.dataset.theme || "auto";
  showTheme(theme);
  themeButton.hidden = false;
  themeButton.addEventListener("click", () => {
    theme = order[(order.indexOf(theme) + 1) % order.length];
    showTheme(theme);
    try {
      if (theme === "auto") localStorage.removeItem("regdef-theme");
      else localStorage.setItem("regdef-theme", theme);
    } catch (e) { /* a browser without storage forgets the choice */ }
  });

  // Navigation: keeps the current entry in sight; a drawer on small screens.
  const nav = byId("site-nav");
  const current = nav.querySelector("[aria-current]");
  if (current && nav.scrollHeight > nav.clientHeight) {
    nav.scrollTop = current.offsetTop - nav.clientHeight / 3;
  }
  const menu = document.querySelector(".menu");
  menu.setAttribute("role", "button");
  function drawer(open) {
    nav.classList.toggle("open", open);
    menu.setAttribute("aria-expanded", String(open));
  }
  drawer(false);
  menu.addEventListener("click", (event) => {
    event.preventDefault();
    drawer(!nav.classList.contains("open"));
  });

  // A closed list of values opens when an address points into it.
  function reveal() {
    const target = location.hash.length > 1 && byId(decodeURIComponent(location.hash.slice(1)));
    for (let at = target; at; at = at.parentElement) if (at.tagName === "DETAILS") at.open = true;
  }
  window.addEventListener("hashchange", reveal);
  reveal();

  // Search.
  const box = byId("site-search-box");
  const input = byId("site-search");
  const list = byId("site-results");
  let hits = [];
  let chosen = 0;
  let loading = null;
  box.hidden = false;

  function load() {
    if (window.REGDEF_INDEX) return Promise.resolve();
    loading = loading || new Promise((resolve, reject) => {
      const script = document.createElement("script");
      script.src = base + "assets/search.js";
      script.onload = resolve;
      script.onerror = () => { loading = null; reject(new Error("the search index is missing")); };
      document.head.append(script);
    });
    return loading;
  }

  const escapes = { "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;", "'": "&#39;" };
  const escape = (text) => String(text).replace(/[&<>"']/g, (c) => escapes[c]);

  // Bus_Off, bus-off and bus off are one notion.
  const plain = (text) => text.toLowerCase().replace(/[_\s-]+/g, " ");

  // How well a name fits a term: whole name, whole part of a dotted name, beginning, beginning of a word, inside.
  function scoreName(name, term) {
    const at = name.indexOf(term);
    if (at < 0) return 0;
    if (name === term) return 100;
    if (name.split(".").includes(term)) return 90;
    if (at === 0) return 70;
    if (/[^a-z0-9]/.test(name[at - 1])) return 60;
    return 40;
  }

  function search(query) {
    const index = window.REGDEF_INDEX;
    const terms = query.toLowerCase().split(/\s+/).filter(Boolean);
    const here = index.controllers.findIndex((c) => c[0] === root.dataset.controller);
    const phrase = plain(query);
    const found = [];
    if (!terms.length) return found;
    index.entries.forEach((entry, position) => {
      const [kind, controller, name, title, , text] = entry;
      const lower = name.toLowerCase();
      let score = 0;
      for (const term of terms) {
        let one = scoreName(lower, term);
        if (!one && title.toLowerCase().includes(term)) one = 25;
        if (!one && text.toLowerCase().includes(term)) one = 12;
        if (!one && controller >= 0 && index.controllers[controller].join(" ").toLowerCase().includes(term)) one = 5;
        if (!one) return;
        score += one;
      }
      score = score / terms.length + (plain(title + " " + text).includes(phrase) ? 16 : 0);
      // Questions about the manual have long telling names; what the manual does say comes first.
      if (/^(conflict|not stated)$/.test(index.kinds[kind])) score *= 0.45;
      score += (controller === here ? 8 : 0) - kind * 0.4 - name.length * 0.02;
      found.push([score, position]);
    });
    found.sort((a, b) => b[0] - a[0] || a[1] - b[1]);
    return found.slice(0, 40).map(([, position]) => index.entries[position]);
  }

  function marked(text, terms) {
    const lower = text.toLowerCase();
    const on = new Array(text.length).fill(false);
    for (const term of terms) {
      for (let at = lower.indexOf(term); at >= 0; at = lower.indexOf(term, at + term.length)) on.fill(true, at, at + term.length);
    }
    let html = "";
    for (let from = 0; from < text.length;) {
      let to = from;
      while (to < text.length && on[to] === on[from]) to++;
      const piece = escape(text.slice(from, to));
      html += on[from] ? "<mark>" + piece + "</mark>" : piece;
      from = to;
    }
    return html;
  }

  function show() {
    const query = input.value.trim();
    if (!query) return close();
    const index = window.REGDEF_INDEX;
    const terms = query.toLowerCase().split(/\s+/).filter(Boolean);
    hits = search(query);
    chosen = 0;
    list.innerHTML = hits.map((hit, n) => {
      const [kind, controller, name, title, url, text] = hit;
      const where = controller < 0 ? "" : index.controllers[controller][0];
      const first = Math.max(0, text.toLowerCase().search(terms.map((t) => t.replace(/[^a-z0-9_]/g, "\\$&")).join("|")) - 40);
      const cut = (first ? "… " : "") + text.slice(first, first + 160);
      return '<a role="option" tabindex="-1" id="site-hit-' + n + '" aria-selected="false" href="' + escape(base + url) + '">' +
        '<span class="kind">' + escape(index.kinds[kind]) + (where ? " <br>" + escape(where) : "") + "</span>" +
        '<span class="name">' + marked(name, terms) + (title ? "<small>" + marked(title, terms) + "</small>" : "") + "</span>" +
        (text ? '<span class="text">' + marked(cut, terms) + "</span>" : "") + "</a>";
    }).join("") || "<p>Nothing is called that or says that.</p>";
    list.hidden = false;
    input.setAttribute("aria-expanded", "true");
    choose(0);
  }

  function close() {
    list.hidden = true;
    hits = [];
    input.setAttribute("aria-expanded", "false");
    input.removeAttribute("aria-activedescendant");
  }

  function choose(n) {
    if (!hits.length) return;
    const old = byId("site-hit-" + chosen);
    if (old) old.setAttribute("aria-selected", "false");
    chosen = (n + hits.length) % hits.length;
    const hit = byId("site-hit-" + chosen);
    hit.setAttribute("aria-selected", "true");
    hit.scrollIntoView({ block: "nearest" });
    input.setAttribute("aria-activedescendant", hit.id);
  }

  const run = () => load().then(show, () => {
    list.innerHTML = "<p>The search index could not be loaded.</p>";
    list.hidden = false;
  });
  input.addEventListener("focus", () => load().catch(() => {}), { once: true });
  input.addEventListener("input", run);
  input.addEventListener("keydown", (event) => {
    if (event.key === "ArrowDown" && hits.length) choose(chosen + 1);
    else if (event.key === "ArrowUp" && hits.length) choose(chosen - 1);
    else if (event.key === "Enter" && hits.length) { byId("site-hit-" + chosen).click(); close(); input.blur(); }
    else if (event.key === "Escape") { if (list.hidden) input.blur(); close(); }
    else return;
    event.preventDefault();
  });
  document.addEventListener("click", (event) => { if (!box.contains(event.target)) close(); });
  list.addEventListener("click", close);
  document.addEventListener("keydown", (event) => {
    const typing = /^(INPUT|TEXTAREA|SELECT)$/.test(event.target.tagName) || event.target.isContentEditable;
    if (event.key === "Escape") drawer(false);
    if (event.key !== "/" || typing || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    input.focus();
    input.select();
  });

  // `?q=` opens the page with a search.
  if (params.get("q")) {
    input.value = params.get("q");
    run();
  }
})();
