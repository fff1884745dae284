"use strict";

// Checks an answer in the page: its function runs over the table of its check, and the verdict is in the check's words.
const Tables = {
  known: new Map(),
  undefined: null, // of undefined.js: the GLSL that notes operations without a defined result, and words for them

  // A device may be off by 2^-11 in these, more than a table allows, and give no 0 for pow(0, y): ours are exact to a float's
  // last digits. fma and the functions of bits are not part of ES.
  EXACT: (() => {
    const scalar = `float probe_turned(float x, int more) {
        float turns = floor(x * 0.636619772 + 0.5), r = ((x - turns * 1.5703125) - turns * 4.83751297e-4) - turns * 7.54979013e-8, q = r * r;
        int quarter = (int(turns) + more) & 3;
        float even = 1.0 - q / 2.0 * (1.0 - q / 12.0 * (1.0 - q / 30.0 * (1.0 - q / 56.0 * (1.0 - q / 90.0))));
        float odd = r * (1.0 - q / 6.0 * (1.0 - q / 20.0 * (1.0 - q / 42.0 * (1.0 - q / 72.0))));
        float s = (quarter & 1) == 1 ? even : odd;
        return (quarter & 2) == 2 ? -s : s;
      }
      float probe_sin(float x) { return probe_turned(x, 0); }
      float probe_cos(float x) { return probe_turned(x, 1); }
      float probe_atan(float t) {
        float size = abs(t), low = size > 1.0 ? 1.0 / size : size, near = low > 0.41421356 ? (low - 1.0) / (low + 1.0) : low, q = near * near, sum = 0.0;
        for (int i = 21; i > 0; i -= 2) sum = 1.0 / float(i) - q * sum;
        float angle = near * sum + (low > 0.41421356 ? 0.785398163 : 0.0);
        angle = size > 1.0 ? 1.57079633 - angle : angle;
        return t < 0.0 ? -angle : angle;
      }
      float probe_atan(float y, float x) {
        if (x == 0.0) return y == 0.0 ? 0.0 : y < 0.0 ? -1.57079633 : 1.57079633;
        return probe_atan(y / x) + (x > 0.0 ? 0.0 : y < 0.0 ? -3.14159265 : 3.14159265);
      }
      float probe_pow(float x, float y) { return x == 0.0 && y > 0.0 ? 0.0 : pow(x, y); }
      int findMSB(uint bits) { int last = -1; for (; bits != 0u; bits >>= 1u) ++last; return last; }
      int findMSB(int bits) { return findMSB(uint(bits < 0 ? ~bits : bits)); }
      ivec2 findMSB(ivec2 bits) { return ivec2(findMSB(bits.x), findMSB(bits.y)); }
      int findLSB(uint bits) { return findMSB(bits & (~bits + 1u)); }
      int findLSB(int bits) { return findLSB(uint(bits)); }
      int bitCount(uint bits) { int count = 0; for (; bits != 0u; bits &= bits - 1u) ++count; return count; }
      int bitCount(int bits) { return bitCount(uint(bits)); }
      float fma(float a, float b, float c) { return a * b + c; }\n`;
    const spread = (name, count) => [2, 3, 4].map(n => {
      const operands = ["a", "b", "c"].slice(0, count), parts = [..."xyzw"].slice(0, n).map(axis => `${name}(${operands.map(one => `${one}.${axis}`).join(", ")})`);
      return `vec${n} ${name}(${operands.map(one => `vec${n} ${one}`).join(", ")}) { return vec${n}(${parts.join(", ")}); }\n`;
    }).join("");
    const names = ["sin", "cos", "atan", "pow"];
    return {glsl: scalar + names.map(name => spread(`probe_${name}`, name === "pow" ? 2 : 1)).join("") + spread("probe_atan", 2) + spread("fma", 3),
      on: names.map(name => `#define ${name} probe_${name}\n`).join(""), off: names.map(name => `#undef ${name}\n`).join("")};
  })(),

  take(table) {
    Tables.known.set(table.exercise, table);
  },

  // {ok, passed, failed, first_failure, hint}, as ./course check says it; "note" names what was not looked at.
  check(table, answer) {
    const result = {exercise: table.exercise, ok: false, passed: 0, failed: 0, first_failure: null, hint: null};
    const text = Tables.included(table, answer);
    try {
      for (const probe of table.probes) Tables.run(table, probe, text, result);
      result.ok = result.failed === 0;
    } catch (error) {
      result.failed += 1;
      result.first_failure = error instanceof Gl.Mistake ? `it does not compile: ${error.words}` : error.message;
    }
    if (!result.ok) result.hint ||= table.hint;
    return result;
  },

  // The answer without the #includes of the starter, whose text the table has.
  included(table, answer) {
    return answer.replace(/\r\n?/g, "\n").replace(/^[ \t]*#[ \t]*include[ \t]*"([^"]*)".*$/gm, (line, name) => table.includes.includes(name) ? "" : line);
  },

  run(table, probe, answer, result) {
    const gl = Tables.context(), words = Tables.packed(probe), count = probe.inputs.length;
    let program;
    const attempt = (text, exact) => {
      const whole = `${Gl.HEAD}${Tables.EXACT.glsl}${exact}${Undefined.TURNS}${probe.before}#line 1 1\n${Undefined.limited(text)}\n#line 1 2\n${probe.after}${probe.main}`;
      if (program) gl.deleteProgram(program);
      program = Gl.program(gl, Gl.TRIANGLE, whole);
      return text;
    };
    const compiled = Gl.forgiving(answer, text => {
      try {
        return attempt(text, Tables.EXACT.on);
      } catch {
        return attempt(text, ""); // a global constant may not call ours
      }
    });
    const got = Gl.table(gl, program, words, count, probe.outputs).map(row => Tables.numbers(probe, row));
    gl.deleteProgram(program);
    const open = Tables.look_for_undefined(gl, probe, compiled, words, result);
    for (let row = 0; row < count; ++row) {
      const truth = probe.truth[row].map(Number), undefined_ = open.get(row);
      const right = undefined_ === undefined && Tables.excess(probe, truth, got[row]) <= 1;
      ++result[right ? "passed" : "failed"];
      if (right || result.first_failure) continue;
      const call = Tables.call(probe, row), expected = probe.expected?.[row] ?? Tables.tuple(truth);
      if (undefined_ === "") {
        result.first_failure = `${call} does not return: does a loop never end?`;
      } else if (undefined_) {
        result.first_failure = `${call} ${undefined_}. GLSL leaves open what that gives: it differs from device to device. Expected ${expected}`;
        result.hint = "look for this case before the operation, and return there what is right; what max or clamp makes of an undefined number is undefined too";
      } else {
        result.first_failure = `${call} gave ${Tables.tuple(got[row])}, expected ${expected}`;
        result.hint = Tables.hint(probe, row, truth, got[row]);
      }
    }
  },

  // What each row's call does that GLSL leaves open, where its result depends on that: by row, in words.
  look_for_undefined(gl, probe, answer, words, result) {
    const {glsl, words: operations, results} = Tables.undefined, found = new Map(), defines = glsl.indexOf("#define");
    let program;
    try {
      const whole = `${Gl.HEAD}#define PROBE_TURNS ${results.length}\n#define PROBE_RESULTS ${results.map(Tables.literal).join(", ")}\n${Tables.EXACT.glsl}${Tables.EXACT.on}${glsl.slice(0, defines)}` +
        `${Undefined.LENGTHS}${Undefined.NOTED_TURNS}${probe.before}\n${Tables.EXACT.off}${Undefined.instrumented(answer, glsl.slice(defines))}` +
        `${Tables.EXACT.on}${probe.after}${probe.main}`;
      program = Gl.program(gl, Gl.TRIANGLE, whole);
    } catch (error) {
      result.note = "operations that GLSL leaves undefined were not looked for: the check cannot follow how it is written";
      result.why = error.message;
      return found;
    }
    const rows = Gl.table(gl, program, words, results.length * probe.inputs.length, 3 + probe.outputs);
    gl.deleteProgram(program);
    rows.forEach((one, i) => {
      const row = Math.floor(i / results.length), what = one[0];
      if (!what || found.has(row)) return;
      if (what === Undefined.ENDLESS) {
        found.set(row, "");
        return;
      }
      const [, template, always] = operations.find(([number]) => number === what), [a, b] = new Float32Array(one.buffer, 4, 2);
      if (always || Tables.excess(probe, probe.truth[row].map(Number), Tables.numbers(probe, one.subarray(3))) > 1)
        found.set(row, template.replace("B", Tables.number(b)).replace("A", Tables.number(a)));
    });
    return found;
  },

  literal(value) {
    return value === "NaN" ? "uintBitsToFloat(0x7fc00000u)" : `float(${value})`;
  },

  context() {
    if (!Tables.gl || Tables.gl.isContextLost()) Tables.gl = Gl.context();
    return Tables.gl;
  },

  packed(probe) {
    const width = probe.whole.length, words = new Uint32Array(width * probe.inputs.length), floats = new Float32Array(words.buffer);
    probe.inputs.forEach((row, i) => row.forEach((value, k) => {
      if (probe.whole[k]) words[i * width + k] = Number(value);
      else floats[i * width + k] = Tables.parsed(value);
    }));
    return words;
  },

  parsed(value) {
    return value === "infinity" ? Infinity : value === "-infinity" ? -Infinity : Number(value);
  },

  numbers(probe, words) {
    const kind = !probe.whole_result ? Float32Array : probe.signature.startsWith("u") ? Uint32Array : Int32Array;
    return [...new kind(words.buffer, words.byteOffset, words.length)];
  },

  // As common/check/probe.cpp: how far a result is from the truth, in units of the bound.
  excess({bound: [absolute, relative, ulps]}, truth, got) {
    return Math.max(...truth.map((t, k) => {
      if (Number.isFinite(t) && Number.isFinite(got[k]))
        return Math.abs(got[k] - t) / Math.max(absolute, relative * Math.abs(t), ulps * Tables.ulp(t), 1e-300);
      return got[k] === t || (Number.isNaN(got[k]) && Number.isNaN(t)) ? 0 : Infinity;
    }));
  },

  ulp(value) {
    const word = new Uint32Array(1), float = new Float32Array(word.buffer);
    float[0] = Math.abs(value);
    const near = float[0];
    ++word[0];
    return Number.isFinite(float[0]) ? float[0] - near : 0;
  },

  // The check's hint for this kind of wrong result, where it has one.
  hint({hints}, row, truth, got) {
    if (!hints) return "";
    const k = Math.max(truth.findIndex((t, i) => !(Math.abs(got[i] - t) < 1e-6 + 1e-3 * Math.abs(t))), 0);
    const kind = !Number.isFinite(got[k]) ? "nan" : got[k] === 0 ? "zero" : got[k] < 0 && truth[k] >= 0 ? "negative" : got[k] < truth[k] ? "low" : "high";
    return hints.texts[hints.kinds[kind][row]];
  },

  call(probe, row) {
    if (probe.calls) return probe.calls[row];
    let at = 0;
    const told = probe.parameters.map(([name, count]) => `${name} = ${Tables.tuple(probe.inputs[row].slice(at, at += count).map(Tables.parsed))}`);
    return `${probe.signature.match(/\w+\s+(\w+)/)[1]}(${told.join(", ")})`;
  },

  tuple(values) {
    return values.length === 1 ? Tables.number(values[0]) : `(${values.map(Tables.number).join(", ")})`;
  },

  // An integer whole, else the shortest decimal that is this float, as std::to_chars writes it.
  number(value) {
    if (Number.isInteger(value) && Math.abs(value) < 9e15) return String(value || 0);
    const float = Math.fround(value);
    if (!Number.isFinite(float)) return Number.isNaN(float) ? "NaN" : float > 0 ? "infinity" : "-infinity";
    if (float === 0) return "0";
    let digits = 1;
    while (digits < 9 && Math.fround(Number(float.toPrecision(digits))) !== float) ++digits;
    const short = Number(float.toPrecision(digits));
    const scientific = short.toExponential().replace(/e([+-])(\d)$/, "e$10$2"), fixed = short.toLocaleString("en", {useGrouping: false, maximumFractionDigits: 20});
    return fixed.length <= scientific.length ? fixed : scientific;
  },
};
