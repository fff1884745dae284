"use strict";

// The knobs of a chapter, their controls, and those that a lesson's text names.
const Knobs = {
  known: {},
  lists: {}, // of those that have been read

  of(chapter) {
    return Knobs.known[chapter] ??= Live.get(`knobs/${chapter}`).catch(error => {
      delete Knobs.known[chapter];
      throw error;
    }).then(knobs => Knobs.lists[chapter] = knobs);
  },

  // A knob by its path, or by its name as --set takes it: the one that answers to its name alone, or the only one of that name.
  find(knobs, name) {
    const named = knobs.filter(knob => knob.name.split(".").pop() === name);
    return knobs.find(knob => knob.name === name) ?? named.find(knob => knob.alone) ?? (named.length === 1 ? named[0] : undefined);
  },

  default_text(knob) {
    const short = value => typeof value === "number" ? String(+value.toPrecision(6)) : value;
    return Array.isArray(knob.default) ? knob.default.map(short).join(" ") : short(knob.default);
  },

  // A control; change(text, still) is called as it is turned. set(text) shows another value.
  control(knob, value, change) {
    const row = make("div", {className: "live-knob", title: knob.help});
    row.dataset.knob = knob.name;
    row.append(make("label", {textContent: knob.name + (knob.unit ? ` (${knob.unit})` : "")}));
    const options = Knobs.options(knob);
    if (options.length) {
      const select = make("select", {}, ...options.map(option => make("option", {value: option, textContent: option})));
      select.value = value;
      select.onchange = () => change(select.value, true);
      row.append(select);
      row.set = text => { select.value = text; };
    } else {
      const field = make("input", {type: "text", className: "live-number", value});
      field.onchange = () => change(field.value, true);
      row.set = text => { field.value = text; };
      if (Knobs.is_number(knob)) {
        const scale = Knobs.scale(knob), range = make("input", {type: "range", min: 0, max: 1000, value: scale.place(+value)});
        range.oninput = () => { field.value = scale.text(+range.value); change(field.value, false); };
        range.onchange = () => { field.value = scale.text(+range.value); change(field.value, true); };
        row.set = text => { field.value = text; range.value = scale.place(+text); };
        row.append(range);
      }
      row.append(field);
    }
    row.querySelector("select, input").setAttribute("aria-label", knob.name);
    return row;
  },

  options: knob => knob.type === "choice" ? knob.options : knob.type === "switch" ? ["on", "off"] : [],

  is_number: knob => typeof knob.default === "number" && Array.isArray(knob.range),

  // The middle of a slider is the default: ranges reach from what is useful to what is possible.
  scale(knob) {
    const [low, high] = knob.range, whole = knob.type === "whole number";
    const share = (knob.default - low) / (high - low);
    const bend = share > 0 && share < 1 ? Math.min(Math.max(Math.log(share) / Math.log(0.5), 0.25), 12) : high - low > 4 && share <= 0 ? 4 : 1;
    return {
      text: place => {
        const value = low + (high - low) * (place / 1000) ** bend;
        return String(whole ? Math.round(value) : +value.toPrecision(3));
      },
      place: value => 1000 * Math.max((value - low) / (high - low), 0) ** (1 / bend),
    };
  },

  // Makes the knobs that a text names into links. `turn(knob, value or null)` is called for a click.
  link_text(article, knobs, turn) {
    const named = [];
    for (const block of article.querySelectorAll("p, li, td, summary")) {
      let last = null;
      for (const code of block.querySelectorAll("code")) {
        if (code.closest("pre, a, .live-panel, h1, h2, h3") || code.closest("p, li, td, summary") !== block) continue;
        const text = code.textContent.trim().replace(/^--(set )?/, "");
        const [, name, value] = text.match(/^([\w.]+)\s*=\s*(\S+)$/) ?? [null, text, null];
        const knob = Knobs.find(knobs, name);
        let of = knob, to = value;
        if (!knob && last && (Knobs.options(last).includes(text) || (Knobs.is_number(last) && /^-?[\d.]+$/.test(text)))) [of, to] = [last, text];
        if (!of) {
          const owners = knobs.filter(one => one.type === "choice" && one.options.includes(text));
          if (owners.length === 1) [of, to] = [owners[0], text];
        }
        if (!of) continue;
        if (knob) last = knob;
        if (!named.includes(of)) named.push(of);
        code.classList.add("live-link");
        code.tabIndex = 0;
        code.role = "button";
        code.title = to ? `set ${of.name} to ${to}` : `${of.name}: ${of.help}`;
        code.onclick = () => turn(of, to, code);
        code.onkeydown = event => { if (event.key === "Enter") turn(of, to, code); };
      }
    }
    return named;
  },
};
