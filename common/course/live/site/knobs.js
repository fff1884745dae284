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
        const scale = Knobs.scale(knob), range = make("input", {type: "range", min: 0, max: 1000});
        const show = text => { field.value = text; range.setAttribute("aria-valuetext", knob.unit ? `${text} ${knob.unit}` : text); };
        range.oninput = () => { show(scale.text(+range.value)); change(field.value, false); };
        range.onchange = () => { show(scale.text(+range.value)); change(field.value, true); };
        row.set = text => { show(text); range.value = scale.place(+text); };
        row.set(value);
        row.append(range);
      }
      row.append(field);
    }
    for (const one of row.querySelectorAll("select, input")) one.setAttribute("aria-label", knob.name);
    return row;
  },

  options: knob => knob.type === "choice" ? knob.options : knob.type === "switch" ? ["on", "off"] : [],

  is_number: knob => typeof knob.default === "number" && Array.isArray(knob.range),

  // The middle of a slider is the default: ranges reach from what is useful to what is possible.
  scale(knob) {
    const [low, high] = knob.range, whole = knob.type === "integer";
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

  // Makes the knobs that a text names (pages/knob_links.py) into links. `turn(knob, value or null)` is called for a click.
  link_text(article, knobs, turn) {
    const named = new Set();
    for (const code of article.querySelectorAll("code[data-knob]")) {
      const knob = knobs.find(one => one.name === code.dataset.knob), value = code.dataset.value ?? null;
      if (!knob) continue;
      named.add(knob);
      code.classList.add("live-link");
      code.tabIndex = 0;
      code.role = "button";
      code.title = value ? `set ${knob.name} to ${value}` : `${knob.name}: ${knob.help}`;
      code.onclick = () => turn(knob, value, code);
      code.onkeydown = event => { if (event.key === "Enter") turn(knob, value, code); };
    }
    return [...named];
  },
};
