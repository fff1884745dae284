"use strict";

// GLSL in the page, by WebGL 2: programs that draw, and functions that run over a table.
const Gl = {
  HEAD: "#version 300 es\nprecision highp float; precision highp int; precision highp sampler2D; precision highp sampler3D;\n",
  TRIANGLE: "#version 300 es\nvoid main() { gl_Position = vec4(vec2(gl_VertexID == 1 ? 3 : -1, gl_VertexID == 2 ? 3 : -1), 0, 1); }\n",

  // Throws Error where the browser has no WebGL 2.
  context(canvas = document.createElement("canvas"), options = {}) {
    const gl = canvas.getContext("webgl2", {antialias: false, alpha: false, ...options});
    if (!gl) throw new Error("this browser has no WebGL 2, which draws here");
    return gl;
  },

  // Throws Gl.Mistake with the compiler's lines; those of part 1 of the text (#line N 1) are the reader's.
  Mistake: class extends Error {
    constructor(log) {
      super(log);
      this.lines = [...log.matchAll(/^ERROR: (\d+):(\d+): (.*)$/gm)].map(([, part, line, words]) => ({part: +part, line: +line, words}));
    }
    get words() {
      const own = this.lines.find(one => one.part === 1) ?? this.lines[0];
      return own ? `${own.part === 1 ? `line ${own.line}: ` : ""}${own.words}` : this.message.trim().split("\n")[0];
    }
  },

  shader(gl, type, text) {
    const shader = gl.createShader(type);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS) && !gl.isContextLost()) {
      const log = gl.getShaderInfoLog(shader);
      gl.deleteShader(shader);
      throw new Gl.Mistake(log || "the driver refuses this shader and does not say why");
    }
    return shader;
  },

  program(gl, vertex, fragment) {
    const program = gl.createProgram(), shaders = [Gl.shader(gl, gl.FRAGMENT_SHADER, fragment), Gl.shader(gl, gl.VERTEX_SHADER, vertex)];
    for (const shader of shaders) gl.attachShader(program, shader);
    gl.linkProgram(program);
    for (const shader of shaders) gl.deleteShader(shader);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS) && !gl.isContextLost()) throw new Gl.Mistake(gl.getProgramInfoLog(program));
    return program;
  },

  // GLSL ES has no implicit conversions: where the compiler complains of types, integers of that line become floats,
  // one at a time, as long as that brings it further. `attempt` compiles a text, which is a part of it, or throws Gl.Mistake.
  forgiving(text, attempt, part = 1) {
    for (let turn = 0; ; ++turn) {
      try {
        return attempt(text);
      } catch (error) {
        const first = error.lines?.find(one => one.part === part);
        const better = turn < 40 && first && Gl.converted(text, first.line, error, attempt, part);
        if (!better) throw error;
        text = better;
      }
    }
  },

  converted(text, number, error, attempt, part) {
    const lines = text.split("\n"), line = lines[number - 1] ?? "";
    const whole = new Set([...text.matchAll(/\bu?int\s+(\w+)/g)].map(found => found[1]));
    const places = [...line.replace(/\/\/.*/, "").matchAll(/(?<![\w.])(\d+u?|[A-Za-z_]\w*)(?![\w.]|\s*\()/g)]
      .filter(([word]) => /^\d/.test(word) || whole.has(word));
    for (const {0: word, index} of places) {
      const tried = [...lines];
      tried[number - 1] = `${line.slice(0, index)}float(${word})${line.slice(index + word.length)}`;
      try {
        attempt(tried.join("\n"));
        return tried.join("\n");
      } catch (other) {
        const first = other.lines?.find(one => one.part === part);
        if (first && (other.lines.length < error.lines.length || first.line > number)) return tried.join("\n");
      }
    }
    return null;
  },

  // Runs a fragment shader whose outputs are `outs` unsigned words for each of `count` rows of `words`. Returns the words
  // of each row. Words hold the bits of floats: no driver rounds them, and all devices can draw into such a target.
  table(gl, program, words, count, outs) {
    const wide = 64, high = Math.ceil(count / wide), targets = Math.ceil(outs / 4), made = [];
    const texture = (format, width, height, layout, data) => {
      made.push(gl.createTexture());
      gl.bindTexture(gl.TEXTURE_2D, made.at(-1));
      gl.texImage2D(gl.TEXTURE_2D, 0, format, width, height, 0, layout, gl.UNSIGNED_INT, data);
      for (const name of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, name, gl.NEAREST);
      return made.at(-1);
    };
    const frame = gl.createFramebuffer(), places = [...Array(targets).keys()].map(i => gl.COLOR_ATTACHMENT0 + i);
    gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
    for (const place of places)
      gl.framebufferTexture2D(gl.FRAMEBUFFER, place, gl.TEXTURE_2D, texture(gl.RGBA32UI, wide, high, gl.RGBA_INTEGER, null), 0);
    gl.drawBuffers(places);
    const rows = Math.max(Math.ceil(words.length / 1024), 1), padded = new Uint32Array(1024 * rows);
    padded.set(words);
    texture(gl.R32UI, 1024, rows, gl.RED_INTEGER, padded);
    gl.viewport(0, 0, wide, high);
    gl.disable(gl.DEPTH_TEST);
    gl.useProgram(program);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    const results = [...Array(count)].map(() => new Uint32Array(outs)), read = new Uint32Array(4 * wide * high);
    places.forEach((place, target) => {
      gl.readBuffer(place);
      gl.readPixels(0, 0, wide, high, gl.RGBA_INTEGER, gl.UNSIGNED_INT, read);
      results.forEach((row, i) => { for (let k = 4 * target; k < Math.min(outs, 4 * target + 4); ++k) row[k] = read[4 * i + k % 4]; });
    });
    gl.deleteFramebuffer(frame);
    for (const one of made) gl.deleteTexture(one);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    if (gl.isContextLost()) throw new Error("it does not end: the graphics device gave up");
    return results;
  },
};

// A fragment shader of docs/minimal as WebGL takes it: Vulkan's declarations become ES's, line by line.
Gl.ported = (text, lights = 1) => {
  const members = list => list.split(";").map(one => one.trim()).filter(Boolean).map(one => `uniform ${one};`).join(" ");
  return text.replace(/^#version.*$/m, "")
    .replace(/layout\(push_constant\) uniform \w+ \{([^}]*)\};/g, (_, list) => members(list))
    .replace(/layout\(std430, binding = \d+\) readonly buffer (\w+) \{ (\w+ \w+)\[\]; \};/g, `layout(std140) uniform $1 { $2[${lights}]; };`)
    .replace(/layout\(location = \d+\) in /g, "in ").replace(/layout\(binding = \d+\) uniform/g, "uniform");
};

// Draws such a shader: on the whole picture, or on shapes seen by an orbiting camera.
class Drawing {
  static SHAPES = {screen: [0, 3], sphere: [1, 6 * 64 * 64], floor: [2, 6], wall: [3, 6]}; // number, corners
  static STAGE = `#version 300 es
    uniform int stage_shape; uniform vec3 stage_eye, stage_forward, stage_right, stage_up; uniform vec2 stage_half;
    out vec3 ray, position, corner_normal; out vec2 uv;
    void main() {
      int cells = stage_shape == 1 ? 64 : 1, quad = gl_VertexID / 6, corner = gl_VertexID % 6;
      vec2 at = (vec2(quad % cells, quad / cells) + vec2(corner == 1 || corner == 3 || corner == 4, corner == 2 || corner == 4 || corner == 5)) / float(cells);
      if (stage_shape == 0) {
        vec2 p = vec2(gl_VertexID == 1 ? 3 : -1, gl_VertexID == 2 ? 3 : -1);
        ray = stage_forward + p.x * stage_half.x * stage_right + p.y * stage_half.y * stage_up;
        uv = vec2(0.5 + 0.5 * p.x, 0.5 - 0.5 * p.y);
        gl_Position = vec4(p, 0, 1);
        return;
      }
      uv = vec2(at.x, 1.0 - at.y);
      if (stage_shape == 1) {
        float azimuth = 6.28318531 * at.x, polar = 3.14159265 * at.y;
        position = corner_normal = vec3(sin(polar) * sin(azimuth), cos(polar), sin(polar) * cos(azimuth));
      } else if (stage_shape == 2) {
        position = vec3(10.0 * at.x - 5.0, -1, 5.0 - 10.0 * at.y);
        corner_normal = vec3(0, 1, 0);
      } else {
        position = vec3(2.0 * at.x - 1.0, 2.0 * at.y - 1.0, 0);
        corner_normal = vec3(0, 0, 1);
      }
      vec3 way = position - stage_eye;
      float depth = dot(way, stage_forward);
      gl_Position = vec4(dot(way, stage_right) / stage_half.x, dot(way, stage_up) / stage_half.y, 1.002 * depth - 0.1, depth);
    }`;
  // Linear light is kept as sRGB codes of 8 bits, as Vulkan's targets keep it, and shown as they are.
  static SHOW = `${Gl.HEAD}uniform sampler2D drawn; uniform bool is_linear; out vec4 code;
    void main() {
      vec3 l = texelFetch(drawn, ivec2(gl_FragCoord.xy), 0).rgb;
      code = vec4(is_linear ? mix(1.055 * pow(l, vec3(1.0 / 2.4)) - 0.055, 12.92 * l, lessThanEqual(l, vec3(0.0031308))) : l, 1);
    }`;

  constructor(canvas, scene) {
    Object.assign(this, {canvas, scene, gl: Gl.context(canvas, {preserveDrawingBuffer: true}), camera: {...scene.camera}});
    this.show = Gl.program(this.gl, Gl.TRIANGLE, Drawing.SHOW);
    this.textures = Object.entries(scene.textures ?? {}).map(([name, what]) => [name, Textures.upload(this.gl, what)]);
    if (scene.lights) {
      this.lights = this.gl.createBuffer();
      this.gl.bindBufferBase(this.gl.UNIFORM_BUFFER, 0, this.lights);
    }
    this.target();
  }

  target() {
    const {gl, canvas: {width, height}} = this, depth = gl.createRenderbuffer();
    this.drawn = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, this.drawn);
    gl.texStorage2D(gl.TEXTURE_2D, 1, this.scene.encoded ? gl.RGBA8 : gl.SRGB8_ALPHA8, width, height);
    for (const name of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, name, gl.NEAREST);
    gl.bindRenderbuffer(gl.RENDERBUFFER, depth);
    gl.renderbufferStorage(gl.RENDERBUFFER, gl.DEPTH_COMPONENT24, width, height);
    this.frame = gl.createFramebuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.frame);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, this.drawn, 0);
    gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.RENDERBUFFER, depth);
  }

  // Takes a text as it stands in the lesson. Throws Gl.Mistake and keeps the last program.
  compile(text) {
    const {gl} = this, fragment = `${Gl.HEAD}#line 1 1\n${Gl.ported(text, this.scene.lights?.length)}`;
    const made = Gl.program(gl, Drawing.STAGE, fragment);
    if (this.program) gl.deleteProgram(this.program);
    this.program = made;
    this.uniforms = new Map([...Array(gl.getProgramParameter(made, gl.ACTIVE_UNIFORMS)).keys()].map(i => {
      const {name, type} = gl.getActiveUniform(made, i);
      return [name, [gl.getUniformLocation(made, name), type]];
    }));
  }

  set(name, values) {
    const {gl} = this, [place, type] = this.uniforms.get(name) ?? [];
    if (!place) return;
    const write = {[gl.FLOAT]: "uniform1f", [gl.FLOAT_VEC2]: "uniform2f", [gl.FLOAT_VEC3]: "uniform3f", [gl.FLOAT_VEC4]: "uniform4f"}[type] ?? "uniform1i";
    const count = Math.max(Number(write[7]), 1);
    gl[write](place, ...[...values, 0, 0, 0].slice(0, count));
  }

  // Where the camera is and how it is turned: eye, forward, right, up.
  view() {
    const {target: [x, y, z], distance, yaw, pitch} = this.camera, r = Math.PI / 180;
    const out = [Math.cos(pitch * r) * Math.sin(yaw * r), Math.sin(pitch * r), Math.cos(pitch * r) * Math.cos(yaw * r)];
    const right = [Math.cos(yaw * r), 0, -Math.sin(yaw * r)];
    const up = [-Math.sin(pitch * r) * Math.sin(yaw * r), Math.cos(pitch * r), -Math.sin(pitch * r) * Math.cos(yaw * r)];
    return {eye: [x + distance * out[0], y + distance * out[1], z + distance * out[2]], forward: out.map(v => -v), right, up};
  }

  draw(values) {
    const {gl, canvas: {width, height}, scene} = this;
    if (!this.program || gl.isContextLost()) return;
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.frame);
    gl.viewport(0, 0, width, height);
    gl.clearColor(...scene.sky ?? [0.02, 0.025, 0.035], 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.enable(gl.DEPTH_TEST);
    gl.useProgram(this.program);
    if (scene.camera) {
      const {eye, forward, right, up} = this.view(), tangent = Math.tan(this.camera.fov * Math.PI / 360);
      for (const [name, value] of Object.entries({eye, forward, right, up, half: [tangent * width / height, tangent]})) this.set(`stage_${name}`, value);
      if (!scene.camera.still) this.set("eye", eye);
    }
    for (const [name, value] of Object.entries(values)) this.set(name, value);
    if (this.lights) gl.bufferData(gl.UNIFORM_BUFFER, new Float32Array(values.lights.flat()), gl.DYNAMIC_DRAW);
    this.textures.forEach(([name, {texture, kind}], i) => {
      gl.activeTexture(gl.TEXTURE0 + i);
      gl.bindTexture(kind, texture);
      this.set(name, [i]);
    });
    gl.activeTexture(gl.TEXTURE0);
    for (const shape of scene.shapes) {
      const [number, corners] = Drawing.SHAPES[shape];
      this.set("stage_shape", [number]);
      gl.drawArrays(gl.TRIANGLES, 0, corners);
    }
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.disable(gl.DEPTH_TEST);
    gl.useProgram(this.show);
    gl.bindTexture(gl.TEXTURE_2D, this.drawn);
    gl.uniform1i(gl.getUniformLocation(this.show, "is_linear"), scene.encoded ? 0 : 1);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }
}

// What the programs read: computed, so that a page from a file needs no image.
const Textures = {
  // {size: [width, height, depth?], texels(x, y, z) → [r, g, b], 0 to 1 (light: without limit)}
  makers: {
    "wall albedo": {size: [256, 256], srgb: true, texels: (x, y) => { const d = Textures.stones(x, y), n = Textures.grain(x, y); return [0.62 - 0.3 * d + 0.14 * n, 0.52 - 0.27 * d + 0.12 * n, 0.42 - 0.22 * d + 0.1 * n]; }},
    "wall depth": {size: [256, 256], texels: (x, y) => Array(3).fill(Textures.stones(x, y))},
    "wall normal": {size: [256, 256], texels: (x, y) => {
      const e = 1 / 256, slope = at => 0.06 / (2 * e) * at, across = slope(Textures.stones(x + e, y) - Textures.stones(x - e, y)), along = slope(Textures.stones(x, y + e) - Textures.stones(x, y - e));
      const length = Math.hypot(across, along, 1);
      return [across, along, 1].map(v => 0.5 + 0.5 * v / length);
    }},
    light: {size: [480, 270], half: true, texels: (x, y) => {
      const sky = 1.3 - y, sun = Math.exp(-2400 * ((x - 0.7) ** 2 + 0.32 * (y - 0.3) ** 2)), hill = 0.62 + 0.09 * Math.sin(9 * x) + 0.04 * Math.sin(23 * x + 1);
      const lamp = [0.15, 0.35, 0.52].reduce((sum, at, i) => sum + [5, 9, 3][i] * Math.exp(-9000 * ((x - at) ** 2 + 0.32 * (y - 0.8) ** 2)), 0);
      return y < hill ? [0.35 * sky + 40 * sun + 0.8 * Math.exp(-30 * (y - 0.3) ** 2) * 0.4, 0.5 * sky + 34 * sun + 0.12, 0.9 * sky + 26 * sun] : [0.05 + 0.04 * x + lamp, 0.045 + 0.6 * lamp, 0.03 + 0.25 * lamp];
    }},
    nebula: {size: [64, 64, 64], texels: (x, y, z) => {
      const [a, b, c] = [x, y, z].map(v => 2 * v - 1), r = Math.hypot(a, 1.3 * b, c);
      const wave = Math.sin(7 * a + 3 * Math.sin(4 * b)) * Math.sin(6 * b + 2 * Math.sin(5 * c)) * Math.sin(8 * c + 2 * Math.sin(3 * a));
      return Array(3).fill(Math.max(Math.exp(-18 * (r - 0.62) ** 2) * (0.55 + 0.45 * wave) + 0.9 * Math.exp(-30 * r * r), 0));
    }},
  },

  // How deep a wall of stones is, 0 to 1; its rows are half a stone apart.
  stones(x, y) {
    const row = Math.floor(6 * y), u = 3 * x + 0.5 * (row & 1), v = 6 * y, edge = Math.min(u - Math.floor(u), Math.ceil(u) - u, 0.5 * (v - row), 0.5 * (row + 1 - v));
    const t = Math.min(Math.max((edge - 0.02) / 0.1, 0), 1), stone = Math.sin(12.9 * (Math.floor(u) % 3) + 78.2 * row) * 0.5 + 0.5;
    return 1 - t * t * (3 - 2 * t) * (0.75 + 0.25 * stone) + 0.06 * Textures.grain(x, y) * t;
  },

  grain: (x, y) => 0.25 * (Math.sin(61 * x + 9 * Math.sin(37 * y)) + Math.sin(83 * y + 7 * Math.sin(53 * x))),

  upload(gl, what) {
    const {size: [width, height, depth = 1], srgb, half, texels} = Textures.makers[what], kind = depth > 1 ? gl.TEXTURE_3D : gl.TEXTURE_2D;
    const values = new Float32Array(4 * width * height * depth), texture = gl.createTexture();
    for (let i = 0, at = 0; i < width * height * depth; ++i, at += 4)
      values.set([...texels((i % width + 0.5) / width, (Math.floor(i / width) % height + 0.5) / height, (Math.floor(i / width / height) + 0.5) / depth), 1], at);
    gl.bindTexture(kind, texture);
    const data = half ? values : Uint8Array.from(values, v => Math.round(255 * Math.min(Math.max(v, 0), 1)));
    const format = half ? gl.RGBA16F : srgb ? gl.SRGB8_ALPHA8 : gl.RGBA8, type = half ? gl.FLOAT : gl.UNSIGNED_BYTE;
    if (depth > 1) gl.texImage3D(kind, 0, format, width, height, depth, 0, gl.RGBA, type, data);
    else gl.texImage2D(kind, 0, format, width, height, 0, gl.RGBA, type, data);
    const levels = depth === 1 && !half;
    if (levels) gl.generateMipmap(kind);
    gl.texParameteri(kind, gl.TEXTURE_MIN_FILTER, levels ? gl.LINEAR_MIPMAP_LINEAR : gl.LINEAR);
    for (const name of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(kind, name, levels ? gl.REPEAT : gl.CLAMP_TO_EDGE);
    if (depth > 1) gl.texParameteri(kind, gl.TEXTURE_WRAP_R, gl.CLAMP_TO_EDGE);
    return {texture, kind};
  },
};
