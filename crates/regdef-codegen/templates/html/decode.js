"use strict";
// Decode boxes: a register value to fields, fields to a value. `?value=0x...` sets the first box of a page.
(function () {
  // Values are at most 32 bits wide; arithmetic on plain numbers avoids the sign of the bit operators.
  const get = (value, lsb, width) => Math.floor(value / 2 ** lsb) % 2 ** width;
  const set = (value, lsb, width, part) => value + (part - get(value, lsb, width)) * 2 ** lsb;

  function parse(text) {
    const plain = text.trim().replace(/[\s_']/g, "");
    if (/^0x[0-9a-f]+$/i.test(plain)) return parseInt(plain.slice(2), 16);
    if (/^0b[01]+$/i.test(plain)) return parseInt(plain.slice(2), 2);
    if (/^[0-9a-f]+h$/i.test(plain)) return parseInt(plain.slice(0, -1), 16);
    if (/^[0-9]+$/.test(plain)) return parseInt(plain, 10);
    return NaN;
  }

  const hex = (value, width) => "0x" + value.toString(16).toUpperCase().padStart(Math.ceil(width / 4), "0");
  const bin = (value, width) => {
    const digits = value.toString(2).padStart(width, "0");
    return "0b" + digits.replace(/\B(?=(.{4})+$)/g, "_");
  };

  function element(tag, properties, ...children) {
    const made = document.createElement(tag);
    for (const [name, value] of Object.entries(properties || {})) {
      if (name in made) made[name] = value;
      else made.setAttribute(name, value);
    }
    made.append(...children);
    return made;
  }

  // One entry per lane: `n` is the number the lane has in element `position` of an array of registers.
  function lanes(field, position) {
    if (!field.lanes) return [{ field, name: field.name, lsb: field.lsb }];
    const [count, stride, first] = field.lanes;
    return Array.from({ length: count }, (_, lane) => ({
      field,
      name: field.name.replace("{n}", first + position * count + lane),
      lsb: field.lsb + lane * stride,
    }));
  }

  // What a field's value means, and whether it must not be used.
  function meaning(field, value) {
    const says = [];
    let bad = false;
    if (field.values) {
      const variant = field.values.find(([first, last]) => first <= value && value <= last);
      const reserved = (field.reserved || []).some(([first, last]) => first <= value && value <= last);
      if (variant) {
        says.push(variant[2] + (variant[3] ? ": " + variant[3] : ""));
      } else {
        bad = true;
        says.push(reserved ? "reserved: must not be used" : "no such value in the manual");
      }
    }
    if (field.range && (value < field.range[0] || value > field.range[1])) {
      bad = true;
      says.push("illegal: only " + field.range[0] + " to " + field.range[1] + " may be programmed");
    }
    if (field.must !== undefined && value !== field.must) {
      bad = true;
      says.push("must be written " + field.must);
    }
    if (field.encoding && !bad) {
      const [add, times, signed, unit] = field.encoding;
      const number = signed && value >= 2 ** (field.width - 1) ? value - 2 ** field.width : value;
      says.push("= " + (number + add) * times + (unit ? " " + unit : ""));
    }
    return { text: says.join("; "), bad };
  }

  let serial = 0;

  function build(section) {
    const data = JSON.parse(section.querySelector("script").textContent);
    const id = "decode-" + serial++;
    const start = data.reset ?? 0;
    let value = start;
    let position = 0;
    let rows = [];

    const input = element("input", { className: "value", type: "text", id: id + "-value", spellcheck: false, autocomplete: "off" });
    const problem = element("div", { className: "problem", role: "status" });
    const forms = element("div", { className: "forms" });
    const strip = element("div", { className: "strip", role: "group", "aria-label": "Bits" });
    const out = element("div", { className: "out" });
    const bar = element("div", { className: "bar" }, element("label", { htmlFor: input.id }, "Value of " + data.name + " "), input);
    const button = (text, act) => bar.append(element("button", { type: "button", onclick: act }, text));
    if (data.reset !== null) button("Reset value", () => change(start));
    button("All 0", () => change(0));
    button("All 1", () => change(2 ** data.width - 1));
    if (data.elements.length > 1) {
      const select = element("select", { "aria-label": "Element", onchange: () => { position = select.selectedIndex; layOut(); change(value); } });
      data.elements.forEach((name) => select.append(element("option", {}, name)));
      if (data.fields.some((field) => field.lanes)) bar.append(select);
    }
    bar.append(problem);
    section.append(element("h2", {}, "Decode a value"), bar, forms, strip, out,
      element("p", { className: "key" }, "Hexadecimal (0x…), binary (0b…) or decimal; _ may group digits." + (data.unknown ? " Bits with a dashed frame are unknown after reset and start as 0." : "")));

    const bits = [];
    for (let high = data.width - 1; high > 0; high -= 8) {
      const group = element("span");
      for (let bit = high; bit > high - 8; bit--) {
        const one = element("button", { type: "button", "aria-label": "Bit " + bit, onclick: () => change(set(value, bit, 1, 1 - get(value, bit, 1))) });
        if (get(data.unknown, bit, 1)) one.className = "unknown";
        bits[bit] = one;
        group.append(one);
      }
      strip.append(group);
    }

    function layOut() {
      const all = data.fields.flatMap((field) => lanes(field, position)).sort((a, b) => b.lsb - a.lsb);
      rows = all.map((row, n) => {
        const { field } = row;
        const controlId = id + "-field-" + n;
        const to = (part) => change(set(value, row.lsb, field.width, part));
        let control;
        if (field.values) {
          control = element("select", { id: controlId, onchange: () => to(Number(control.value)) });
          for (const [first, last, name] of field.values) {
            for (let one = first; one <= last && one - first < 64; one++) {
              control.append(element("option", { value: String(one) }, one + " " + name + (last > first ? " " + (one - first) : "")));
            }
          }
        } else if (field.width === 1) {
          control = element("input", { id: controlId, type: "checkbox", onchange: () => to(control.checked ? 1 : 0) });
        } else {
          control = element("input", { id: controlId, type: "text", spellcheck: false, autocomplete: "off", onchange: () => {
            const part = parse(control.value);
            const fits = part < 2 ** field.width;
            control.setAttribute("aria-invalid", String(!fits));
            if (fits) to(part);
            else says.textContent = "does not fit: 0 to " + (2 ** field.width - 1);
          } });
        }
        const range = field.width === 1 ? String(row.lsb) : row.lsb + field.width - 1 + ":" + row.lsb;
        const says = element("span", { className: "says" });
        const box = element("div", { className: "field" },
          element("label", { htmlFor: controlId }, row.name + " ", element("small", {}, "[" + range + "]")), control, says);
        return { ...row, control, says, box };
      });
      out.replaceChildren(...rows.map((row) => row.box));
    }

    // Shows a value everywhere; `typing` keeps the text that is being typed.
    function change(next, typing) {
      value = next;
      if (!typing) input.value = hex(value, data.width);
      input.setAttribute("aria-invalid", "false");
      problem.textContent = "";
      forms.textContent = hex(value, data.width) + "  ·  " + value + "  ·  " + bin(value, data.width);
      bits.forEach((one, bit) => {
        const is = get(value, bit, 1);
        one.setAttribute("aria-pressed", String(is === 1));
        one.replaceChildren(element("small", { "aria-hidden": "true" }, String(bit)), String(is));
      });
      let covered = 0;
      for (const row of rows) {
        const { field, control } = row;
        const part = get(value, row.lsb, field.width);
        covered = set(covered, row.lsb, field.width, 2 ** field.width - 1);
        const { text, bad } = meaning(field, part);
        row.says.textContent = text;
        row.box.classList.toggle("bad", bad);
        row.box.classList.toggle("changed", part !== get(start, row.lsb, field.width));
        if (control.type === "checkbox") {
          control.checked = part === 1;
        } else if (control.tagName === "SELECT") {
          for (const stale of control.querySelectorAll("[data-extra]")) stale.remove();
          if (![...control.options].some((option) => option.value === String(part))) {
            control.append(element("option", { value: String(part), "data-extra": "" }, part + (bad ? " (reserved)" : "")));
          }
          control.value = String(part);
        } else {
          control.value = field.width > 8 ? hex(part, field.width) : String(part);
          control.setAttribute("aria-invalid", "false");
        }
      }
      const stray = [];
      for (let bit = 0; bit < data.width; bit++) if (get(value, bit, 1) && !get(covered, bit, 1)) stray.push(bit);
      if (stray.length) problem.textContent = "Not implemented, but 1: bit " + stray.join(", ");
    }

    input.addEventListener("input", () => {
      const typed = parse(input.value);
      const fits = typed < 2 ** data.width;
      if (fits) return change(typed, true);
      input.setAttribute("aria-invalid", "true");
      problem.textContent = Number.isNaN(typed) ? "Not a number." : "Does not fit in " + data.width + " bits.";
    });
    layOut();
    change(value);
    return { change, width: data.width };
  }

  const boxes = [...document.querySelectorAll(".decode")].map(build);
  const asked = parse(new URLSearchParams(location.search).get("value") || "");
  if (boxes.length && asked < 2 ** boxes[0].width) boxes[0].change(asked);
})();
