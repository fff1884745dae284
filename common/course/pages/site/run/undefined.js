"use strict";

// An answer with its divisions, indices and loops as calls, as common/check/instrument.cpp writes them: operations whose
// result GLSL leaves open are noted, and a loop without an end has one.
class Undefined {
  static TURNS = "int probe_turns = 0;\nbool probe_turn() { return ++probe_turns < 100000; }\n";
  static ENDLESS = 99; // as a noted operation: the loop that had to be ended
  static NOTED_TURNS = Undefined.TURNS.replace("return", `if (probe_turns >= 99999) undefined_what = ${Undefined.ENDLESS};\n    return`);

  // With the calls, and behind `defines`, by which pow, sqrt, ... mean others. Throws where a bracket is not closed.
  static instrumented(text, defines) {
    const one = new Undefined(text);
    one.on = defines;
    one.off = defines.replace(/#define (\w+).*/g, "#undef $1");
    return `${one.on}${one.all()}\n${one.off}`;
  }

  // A limit for each loop, in text without other changes.
  static limited(text) {
    const one = new Undefined(text);
    one.limit_loops();
    return one.tokens.map(token => token.space + token.text).join("");
  }

  constructor(text) {
    this.tokens = [];
    this.at = 0;
    this.declares = this.product = false;
    this.arrays = new Set([...text.matchAll(/(?:\w\s+|,\s*)(\w+)\s*\[\w*\]\s*[=;,)]/g), ...text.matchAll(/\w\s*\[\w*\]\s+(\w+)/g)].map(found => found[1]));
    const rule = /(\s+|#(?:\\\n|[^\n])*|\/\/[^\n]*|\/\*[^]*?\*\/)|(\.?\d(?:[eE][+-]|[\w.])*|\w+|[/%*+\-<>=!&|^]=|[^])/gy;
    let space = "";
    for (let found; rule.lastIndex < text.length && (found = rule.exec(text));)
      if (found[1] !== undefined) {
        space += found[1];
      } else {
        this.tokens.push({text: found[2], space});
        space = "";
      }
    this.tokens.push({text: "", space});
  }

  all() {
    this.limit_loops();
    return this.expression(this.tokens.length - 1) + this.tokens.at(-1).space;
  }

  limit_loops() {
    for (let i = 0; i < this.tokens.length; ++i) {
      const {text} = this.tokens[i];
      if ((text !== "for" && text !== "while") || this.tokens[i + 1]?.text !== "(") continue;
      const end = this.closing(i + 1);
      let begin = i + 1, last = end;
      if (text === "for") {
        begin = this.tokens.findIndex((token, k) => k > i && token.text === ";");
        last = this.tokens.findIndex((token, k) => k > begin && token.text === ";");
      }
      if (begin < 0 || last < 0 || last > end) continue;
      this.tokens[begin].text += last === begin + 1 ? " probe_turn()" : " probe_turn() && (";
      if (last > begin + 1) this.tokens[last].text = `)${this.tokens[last].text}`;
    }
    // The words that were joined to a token are tokens themselves.
    const whole = this.tokens.map(token => token.space + token.text).join("");
    const again = new Undefined(whole);
    Object.assign(this, {tokens: again.tokens});
  }

  // Tokens up to `end`, with each division as a call. `factors` is where the product that is being written begins,
  // `operand` where its last operand does.
  expression(end) {
    let out = "", factors = 0, operand = 0, after_operand = false;
    while (this.at < end) {
      const token = this.tokens[this.at], {text, space} = token;
      if (text === "/" || text === "%") {
        ++this.at;
        const right = this.unary(end);
        after_operand = true;
        if (Undefined.is_number(right) && /[1-9]/.test(right)) {
          out += space + text + right;
          continue;
        }
        out = `${out.slice(0, factors)}${text === "/" ? "undefined_divide(" : "undefined_remainder("}${out.slice(factors)},${space}${right})`;
        operand = factors;
      } else if (text === "/=" || text === "%=") {
        ++this.at;
        const left = out.slice(factors), right = this.expression(this.end_of_assignment(end));
        out += ` = ${text === "/=" ? "undefined_divide(" : "undefined_remainder("}${left}, ${right})`;
        after_operand = false;
      } else if ("([{".includes(text) && text) {
        const close = this.closing(this.at);
        if (!after_operand) operand = out.length + space.length;
        if (!after_operand && !this.product) factors = operand;
        ++this.at;
        let inner = this.expression(close);
        if (text === "[" && after_operand && !Undefined.is_number(inner) && !this.declares)
          inner = `undefined_index(${inner}, ${this.length_of(out.slice(operand))})`;
        out += space + text + inner + this.tokens[close].space + this.tokens[close].text;
        this.at = close + 1;
        after_operand = text !== "{";
        if (text === "{") factors = operand = out.length;
      } else if (text === "const" && end + 1 === this.tokens.length) {
        const stop = this.end_of_statement(end), whole = this.tokens.slice(this.at, stop).map(one => one.space + one.text).join("");
        out += `\n${this.off}${whole}\n${this.on}`;  // ES takes no call in a global's value
        this.at = stop;
        factors = operand = out.length;
      } else if (/^[\w]|^\.\d/.test(text)) {
        this.declares = after_operand && !this.product;  // a type was before it
        if (!after_operand || this.declares) {
          operand = out.length + space.length;
          if (!this.product) factors = operand;
        }
        out += space + text;
        ++this.at;
        after_operand = !["return", "else", "case"].includes(text);
        if (!after_operand) factors = operand = out.length;
      } else {
        out += space + text;
        ++this.at;
        if (text === ".") {
          out += this.tokens[this.at].space + this.tokens[this.at].text;
          ++this.at;
          continue;
        }
        after_operand = false;
        if (text === "*") {
          this.product = true;
          continue;
        }
        factors = operand = out.length;
      }
      this.product = false;
    }
    return out;
  }

  // One operand with its signs, calls, indices and members.
  unary(end) {
    let signs = "";
    while (this.at < end && /^[-+!~]$/.test(this.tokens[this.at].text)) {
      signs += this.tokens[this.at].space + this.tokens[this.at].text;
      ++this.at;
    }
    let stop = this.at;
    const open = () => this.tokens[stop].text === "(" || this.tokens[stop].text === "[";
    if (stop < end) stop = open() ? this.closing(stop) + 1 : stop + 1;
    while (stop < end && (open() || this.tokens[stop].text === ".")) stop = open() ? this.closing(stop) + 1 : Math.min(stop + 2, end);
    return signs + this.expression(stop);
  }

  // Vectors have no length() in ES: a function of their type tells it.
  length_of(operand) {
    const name = operand.match(/(\w+)\s*$/)?.[1];
    return this.arrays.has(name) ? `${operand}.length()` : `undefined_length(${operand})`;
  }

  closing(open) {
    let depth = 0;
    for (let i = open; i + 1 < this.tokens.length; ++i) {
      if (/^[([{]$/.test(this.tokens[i].text)) ++depth;
      if (/^[)\]}]$/.test(this.tokens[i].text) && --depth === 0) return i;
    }
    throw new Error("a bracket is not closed");
  }

  end_of_statement(end) {
    const found = this.tokens.findIndex((token, i) => i > this.at && token.text === ";");
    return found < 0 ? end : found;
  }

  end_of_assignment(end) {
    for (let i = this.at; i < end; ++i) {
      const {text} = this.tokens[i];
      if (text === ";" || text === ",") return i;
      if (text === "(" || text === "[") i = this.closing(i);
    }
    return end;
  }

  static is_number(text) {
    return /^[ .0-9uf]*$/.test(text);
  }

  static LENGTHS = ["vec", "ivec", "uvec", "bvec", "mat"].map(type => [2, 3, 4].map(n =>
    `int undefined_length(${type}${n} v) { return ${n}; }\n`).join("")).join("");
}
