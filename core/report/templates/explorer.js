"use strict";
(() => {
  const read = (id) => JSON.parse(document.getElementById(id).textContent);
  const data = read("explorer-data"), words = read("explorer-words");
  const SVG = document.querySelector("#map svg").namespaceURI;
  const colour = new Map(data.classes.map((c) => [c.key, c.colour]));
  const className = new Map(data.classes.map((c) => [c.key, c.name]));
  const units = data.units;
  // lengths of the pictures are shares of a unit's height: a model of a tank is a tenth of a metre high
  const H = data.height;
  const byId = new Map(units.map((u, k) => [u.id, k]));
  const element = (tag, attributes, parent) => {
    const made = document.createElementNS(SVG, tag);
    for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
    if (parent) parent.appendChild(made);
    return made;
  };
  const nice = (value) => {
    const power = 10 ** Math.floor(Math.log10(value));
    return [1, 2, 5, 10].map((s) => s * power).filter((s) => s <= value * 1.0001).pop() || power;
  };
  const decimals = (step) => Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  const probability = (p) => (p === null ? "–" : p < 0.001 ? "< 0.001" : String(p));
  const number = (value, digits, signed) =>
    value === null ? "–" : ((signed && value > 0 ? "+" : "") + value.toFixed(digits)).replace(/^[+-](0\.?0*)$/, "$1");

  // one choice, which map, table and scene follow
  const followers = [];
  let chosen = -1;
  const choose = (k, from) => {
    chosen = k;
    followers.forEach((follow) => follow(k, from));
  };

  // two fingers zoom where there is no wheel; what is given back tells whether they are down
  const pinch = (target, zoomBy) => {
    const fingers = new Map();
    let apart = 0;
    const lift = (event) => fingers.delete(event.pointerId);
    target.addEventListener("pointerdown", (event) => {
      fingers.set(event.pointerId, event);
      apart = 0;
    });
    window.addEventListener("pointerup", lift);
    window.addEventListener("pointercancel", lift);
    window.addEventListener("pointermove", (event) => {
      if (!fingers.has(event.pointerId)) return;
      fingers.set(event.pointerId, event);
      if (fingers.size !== 2) return;
      const [one, other] = fingers.values(), now = Math.hypot(one.clientX - other.clientX, one.clientY - other.clientY);
      if (apart && now) zoomBy(now / apart, { clientX: (one.clientX + other.clientX) / 2, clientY: (one.clientY + other.clientY) / 2 });
      apart = now;
    });
    return () => fingers.size > 1;
  };

  /* map */
  const map = document.getElementById("map");
  const drawing = map.querySelector(".map-units"), frame = map.querySelector(".map-frame"), tip = map.querySelector(".tip");
  const layer = element("g", {}, drawing);
  const polygons = units.map((u, k) => {
    const shape = u.outline
      ? element("polygon", { points: pairs(u.outline) }, layer)
      : element("circle", { cx: u.place[0], cy: -u.place[1], r: 0.25 * H }, layer);
    shape.setAttribute("class", "unit");
    shape.setAttribute("fill", colour.get(u.kind) || "#d5d8dc");
    shape.dataset.unit = String(k);
    return shape;
  });
  function pairs(flat) {
    const parts = [];
    for (let k = 0; k < flat.length; k += 2) parts.push(flat[k] / data.outline_steps + "," + -flat[k + 1] / data.outline_steps);
    return parts.join(" ");
  }
  const arrows = element("g", { "pointer-events": "none" }, drawing);
  data.arrows.drawn.forEach(([x, north, dx, dn, cut]) => {
    const y = -north, dy = -dn, size = Math.hypot(dx, dy) || 1, head = Math.min(0.26 * H, size / 2) / size;
    const hx = dx * head, hy = dy * head, tipX = x + dx, tipY = y + dy;
    const look = { fill: "none", stroke: "#17202a", "stroke-width": 1.4, "vector-effect": "non-scaling-stroke" };
    element("path", { d: `M${x} ${y}L${tipX} ${tipY}`, ...look, ...(cut ? { "stroke-dasharray": "5 3" } : {}) }, arrows);
    element("path", { d: `M${tipX - hx - hy / 2} ${tipY - hy + hx / 2}L${tipX} ${tipY}L${tipX - hx + hy / 2} ${tipY - hy - hx / 2}`, ...look }, arrows);
  });
  const told_scale = [words.scale.replace("{times}", data.arrows.times)].concat(data.arrows.drawn.some((arrow) => arrow[4]) ? [words.cut] : []);
  document.getElementById("arrow-scale").textContent = data.arrows.drawn.length ? `(${told_scale.join("; ")})` : "";
  const marks = data.control.map((c) => {
    const mark = element("path", { d: "M0-7l6 11h-12z", fill: c.used ? "#1b4f72" : "#fff", stroke: "#1b4f72" }, drawing);
    element("title", {}, mark).textContent = `${words.control} ${c.id}`;
    return mark;
  });
  const names = element("g", { "pointer-events": "none" }, drawing);
  const xs = units.map((u) => u.place[0]).concat(data.control.map((c) => c.place[0]));
  const ys = units.map((u) => -u.place[1]).concat(data.control.map((c) => -c.place[1]));
  const low = [Math.min(...xs) - 1.3 * H, Math.min(...ys) - 1.3 * H], high = [Math.max(...xs) + 1.3 * H, Math.max(...ys) + 1.3 * H];
  let view = { x: 0, y: 0, metre: 10 };  // centre of the map, and pixels a metre
  const size = () => [Math.max(map.clientWidth, 50), Math.max(map.clientHeight, 50)];
  const fit = () => {
    const [w, h] = size();
    view = { x: (low[0] + high[0]) / 2, y: (low[1] + high[1]) / 2, metre: Math.min((w - 60) / (high[0] - low[0]), (h - 50) / (high[1] - low[1])) };
    draw();
  };
  const draw = () => {
    const [w, h] = size();
    const left = view.x - w / 2 / view.metre, top = view.y - h / 2 / view.metre;
    drawing.setAttribute("viewBox", `${left} ${top} ${w / view.metre} ${h / view.metre}`);
    frame.setAttribute("viewBox", `0 0 ${w} ${h}`);
    frame.textContent = "";
    const east = data.origin[0] + left, north = data.origin[1] - top;
    let step = nice(110 / view.metre);
    // seven digits with decimals are wider than the lines' usual distance
    while (step * view.metre < 7 * east.toFixed(decimals(step)).length + 8) step = nice(2.6 * step);
    const digits = decimals(step);
    for (let e = Math.ceil(east / step) * step; e < east + w / view.metre; e += step) {
      const x = (e - east) * view.metre;
      element("line", { x1: x, x2: x, y1: 0, y2: h, stroke: "#34424e", "stroke-opacity": 0.12 }, frame);
      element("text", { x, y: h - 4, "text-anchor": "middle" }, frame).textContent = e.toFixed(digits);
    }
    for (let n = Math.ceil((north - h / view.metre) / step) * step; n < north; n += step) {
      const y = (north - n) * view.metre;
      if (y > h - 16) continue;
      element("line", { x1: 0, x2: w, y1: y, y2: y, stroke: "#34424e", "stroke-opacity": 0.12 }, frame);
      element("text", { x: 4, y: y - 3 }, frame).textContent = n.toFixed(digits);
    }
    const bar = nice(120 / view.metre);
    const end = w - 14, begin = end - bar * view.metre;
    element("path", { d: `M${begin} ${h - 34}v8H${end}v-8`, fill: "none", stroke: "#17202a", "stroke-width": 2 }, frame);
    element("text", { x: (begin + end) / 2, y: h - 38, "text-anchor": "middle" }, frame).textContent = `${bar.toFixed(decimals(bar))} m`;
    element("path", { d: `M${w - 22} 10l7 24-7-6-7 6z`, fill: "#17202a" }, frame);
    element("text", { x: w - 22, y: 48, "text-anchor": "middle" }, frame).textContent = "N";
    // marks keep their size on the screen
    marks.forEach((mark, k) => mark.setAttribute("transform", `translate(${data.control[k].place[0]} ${-data.control[k].place[1]}) scale(${1 / view.metre})`));
    names.textContent = "";
    const seen = units.filter((u) => Math.abs(u.place[0] - view.x) < w / 2 / view.metre && Math.abs(-u.place[1] - view.y) < h / 2 / view.metre);
    // names where a unit is wide enough for its own
    if (view.metre * H > 45)
      seen.forEach((u) => {
        element("text", {
          x: u.place[0], y: -u.place[1], "font-size": 11 / view.metre, "text-anchor": "middle", "font-family": "sans-serif",
          stroke: "#fff", "stroke-width": 3 / view.metre, "paint-order": "stroke", fill: "#17202a",
        }, names).textContent = u.id;
      });
  };
  const zoom = (factor, px, py) => {
    const [w, h] = size();
    const dx = (px ?? w / 2) - w / 2, dy = (py ?? h / 2) - h / 2;
    const metre = Math.min(Math.max(view.metre * factor, 0.1 / H), 4000 / H);
    view.x += dx / view.metre - dx / metre;
    view.y += dy / view.metre - dy / metre;
    view.metre = metre;
    draw();
  };
  const at = (event) => {
    const box = map.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  };
  map.addEventListener("wheel", (event) => {
    event.preventDefault();
    zoom(Math.exp(-event.deltaY / 400), ...at(event));
  }, { passive: false });
  const pinched = pinch(map, (factor, middle) => zoom(factor, ...at(middle)));
  let held = null, dragged = false;
  drawing.addEventListener("pointerdown", (event) => {
    held = at(event);
    dragged = false;
  });
  window.addEventListener("pointerup", () => (held = null));
  window.addEventListener("pointermove", (event) => {
    if (!held || pinched()) return;
    const now = at(event);
    if (Math.hypot(now[0] - held[0], now[1] - held[1]) < 3 && !dragged) return;
    dragged = true;
    view.x -= (now[0] - held[0]) / view.metre;
    view.y -= (now[1] - held[1]) / view.metre;
    held = now;
    draw();
  });
  const fine = decimals(H / 100);
  const told = (u) =>
    `${u.id} · ${className.get(u.kind) || u.kind}\n` +
    (u.d === null ? "" : `${number(u.d, data.decimals)} ± ${number(u.sd, data.decimals)} cm\n${words.east} ${number(u.e, data.decimals, true)}  ${words.north} ${number(u.n, data.decimals, true)}  ${words.up} ${number(u.h, data.decimals, true)} cm\n${words.turn} ${number(u.turn, 2)}°, p ${probability(u.p)}`) +
    (u.broken.length ? `\n${words.broken}: ${u.broken.join(", ")}` : "");
  drawing.addEventListener("pointermove", (event) => {
    const [x, y] = at(event), [w, h] = size();
    const east = data.origin[0] + view.x + (x - w / 2) / view.metre, north = data.origin[1] - view.y - (y - h / 2) / view.metre;
    document.getElementById("place").textContent = `${east.toFixed(fine)}  ${north.toFixed(fine)}`;
    const k = event.target.dataset ? event.target.dataset.unit : undefined;
    tip.hidden = k === undefined || held !== null;
    if (!tip.hidden) {
      tip.textContent = told(units[k]);
      tip.style.left = `${Math.min(x + 14, w - tip.offsetWidth - 4)}px`;
      tip.style.top = `${Math.min(y + 14, h - tip.offsetHeight - 4)}px`;
    }
  });
  drawing.addEventListener("pointerleave", () => (tip.hidden = true));
  drawing.addEventListener("click", (event) => {
    if (!dragged && event.target.dataset && event.target.dataset.unit !== undefined) choose(Number(event.target.dataset.unit), "map");
  });
  document.querySelectorAll("[data-map]").forEach((button) =>
    button.addEventListener("click", () => ({ in: () => zoom(1.5), out: () => zoom(1 / 1.5), fit })[button.dataset.map]()));
  document.getElementById("show-arrows").addEventListener("change", (event) => (arrows.style.display = event.target.checked ? "" : "none"));
  followers.push((k, from) => {
    polygons.forEach((p, j) => p.classList.toggle("chosen", j === k));
    layer.appendChild(polygons[k]);
    if (from !== "map") {
      view.x = units[k].place[0];
      view.y = -units[k].place[1];
      view.metre = Math.max(view.metre, 60 / H);
      draw();
    }
  });
  const legend = document.getElementById("legend");
  const explain = (sign, name) => {
    const item = document.createElement("span"), patch = document.createElement("i");
    sign(patch);
    item.append(patch, name);
    legend.appendChild(item);
  };
  data.classes.filter((c) => units.some((u) => u.kind === c.key)).forEach((c) => {
    explain((patch) => (patch.style.background = c.colour), c.name);
    document.getElementById("filter-class").add(new Option(c.name, c.key));
  });
  [[true, words.control], [false, words.unused]].filter(([used]) => data.control.some((c) => c.used === used)).forEach(([used, name]) =>
    explain((patch) => {
      patch.className = "control";
      patch.textContent = used ? "▲" : "△";
    }, name));

  /* table */
  const body = document.querySelector("#units-table tbody");
  const lines = units.map((u, k) => {
    const line = document.createElement("tr");
    line.tabIndex = 0;
    line.dataset.unit = String(k);
    const cells = [u.id, className.get(u.kind) || u.kind, ...[u.d, u.sd].map((v) => number(v, data.decimals)), ...[u.e, u.n, u.h].map((v) => number(v, data.decimals, true)), number(u.turn, 2), probability(u.p), u.decision];
    cells.forEach((text, column) => {
      const cell = line.insertCell();
      cell.textContent = String(text);
      if (column >= 2 && column <= 8) cell.className = "n";
    });
    line.addEventListener("click", () => choose(k, "table"));
    line.addEventListener("keydown", (event) => event.key === "Enter" && choose(k, "table"));
    return line;
  });
  let key = "d", down = true;
  const sort = () => {
    const value = (k) => (units[k][key] === null || units[k][key] === "" ? undefined : units[k][key]);
    const order = units.map((_, k) => k).sort((a, b) => {
      const x = value(a), y = value(b);
      if (x === undefined || y === undefined) return (x === undefined) - (y === undefined) || a - b;
      return ((x < y ? -1 : x > y ? 1 : 0) * (down ? -1 : 1)) || a - b;
    });
    body.append(...order.map((k) => lines[k]));
    document.querySelectorAll("#units-table th").forEach((head) => {
      const own = head.firstElementChild.dataset.key === key;
      head.setAttribute("aria-sort", own ? (down ? "descending" : "ascending") : "none");
    });
  };
  document.querySelectorAll("[data-key]").forEach((button) =>
    button.addEventListener("click", () => {
      down = button.dataset.key === key ? !down : !["id", "kind", "decision"].includes(button.dataset.key);
      key = button.dataset.key;
      sort();
    }));
  const filters = ["filter-text", "filter-class", "filter-least", "filter-significant"].map((id) => document.getElementById(id));
  const filter = () => {
    const [text, kind, least, significant] = filters;
    let shown = 0;
    units.forEach((u, k) => {
      const kept = (!text.value || u.id.toLowerCase().includes(text.value.toLowerCase()))
        && (!kind.value || u.kind === kind.value)
        && (least.value === "" || (u.d !== null && u.d >= Number(least.value)))
        && (!significant.checked || u.significant);
      lines[k].hidden = !kept;
      polygons[k].classList.toggle("dimmed", !kept);
      shown += kept;
    });
    document.getElementById("count").textContent = words.count.replace("{shown}", shown).replace("{all}", units.length);
  };
  filters.forEach((input) => input.addEventListener("input", filter));
  followers.push((k, from) => {
    lines.forEach((line, j) => line.classList.toggle("chosen", j === k));
    if (from !== "table") {
      // the row's own box scrolls, not the page
      const box = body.closest(".rows");
      box.scrollTop = lines[k].offsetTop - box.clientHeight / 2;
    }
  });

  /* scene */
  const scene = document.getElementById("scene"), canvas = scene.querySelector("canvas");
  const VERTEX = `attribute vec3 corner; attribute vec3 normal; uniform mat4 camera; uniform mat3 turn; uniform vec3 centre; varying vec3 facing;
    void main() { facing = turn * normal; gl_Position = camera * vec4(turn * corner + centre, 1.0); }`;
  const FRAGMENT = `precision mediump float; varying vec3 facing; uniform vec4 paint; uniform vec3 light;
    void main() { float lit = 0.45 + 0.55 * max(dot(normalize(facing), light), 0.0); gl_FragColor = vec4(paint.rgb * lit, paint.a); }`;
  const startScene = (gl) => {
    const program = gl.createProgram();
    [[gl.VERTEX_SHADER, VERTEX], [gl.FRAGMENT_SHADER, FRAGMENT]].forEach(([kind, source]) => {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
    });
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) return false;
    gl.useProgram(program);
    const place = (name) => gl.getUniformLocation(program, name);
    const uniform = { camera: place("camera"), turn: place("turn"), centre: place("centre"), paint: place("paint"), light: place("light") };
    const attribute = { corner: gl.getAttribLocation(program, "corner"), normal: gl.getAttribLocation(program, "normal") };
    const buffer = (kind, values) => {
      const made = gl.createBuffer();
      gl.bindBuffer(kind, made);
      gl.bufferData(kind, values, gl.STATIC_DRAW);
      return made;
    };
    const solids = data.solids.map((s) => ({
      corners: buffer(gl.ARRAY_BUFFER, new Float32Array(s.corners)), normals: buffer(gl.ARRAY_BUFFER, new Float32Array(s.normals)),
      triangles: buffer(gl.ELEMENT_ARRAY_BUFFER, new Uint16Array(s.triangles)), count: s.triangles.length,
    }));
    const rgb = (text) => [1, 3, 5].map((k) => parseInt(text.slice(k, k + 2), 16) / 255);
    const middle = units.length ? [0, 1, 2].map((c) => units.reduce((sum, u) => sum + u.place[c], 0) / units.length) : [0, 0, 0];
    const radius = Math.max(2 * H, ...units.map((u) => Math.hypot(u.place[0] - middle[0], u.place[1] - middle[1]))) + H;
    const VIEW = Math.tan(0.4);  // half of what is seen up and down, a metre away
    const axes = (from) => {
      const ch = Math.cos(from.height), sh = Math.sin(from.height), ca = Math.cos(from.azimuth), sa = Math.sin(from.azimuth);
      return { right: [ca, -sa, 0], back: [-sa * ch, -ca * ch, sh], up: [sa * sh, ca * sh, ch] };
    };
    // near enough to fill the window, and far enough that no block is cut by its edges
    const home = () => {
      const found = { target: [...middle], distance: H, azimuth: -0.5, height: 0.6 };
      const { right, back, up } = axes(found), aspect = scene.clientWidth / scene.clientHeight;
      units.forEach((u) => {
        const along = (axis) => axis.reduce((sum, a, k) => sum + a * (u.place[k] - middle[k]), 0);
        const reach = (u.solid === undefined ? H / 2 : data.solids[u.solid].reach) + (u.e === null ? 0 : Math.hypot(u.e, u.n, u.h) / 100);
        // a ball touches the edge of what is seen where its radius over the sine does
        const clear = (off, view) => Math.abs(off) / view + reach * Math.hypot(1, 1 / view);
        const needed = Math.max(clear(along(right), VIEW * aspect), clear(along(up), VIEW));
        found.distance = Math.max(found.distance, along(back) + needed);
      });
      return found;
    };
    let eye = home(), waiting = false, untouched = true;
    const camera = (aspect) => {
      const { right, back, up } = axes(eye);
      const from = eye.target.map((t, k) => t + back[k] * eye.distance);
      const dot = (a) => -(a[0] * from[0] + a[1] * from[1] + a[2] * from[2]);
      const f = 1 / VIEW, near = eye.distance / 100, far = eye.distance + 4 * radius, depth = (far + near) / (near - far);
      const rows = [right, up, back].map((axis) => [...axis, dot(axis)]);
      const column = [];
      for (let c = 0; c < 4; c += 1)
        column.push(rows[0][c] * (f / aspect), rows[1][c] * f, rows[2][c] * depth + (c === 3 ? (2 * far * near) / (near - far) : 0), -rows[2][c]);
      gl.uniform3fv(uniform.light, [0.35 * right[0] + 0.5 * back[0] + 0.3 * up[0], 0.35 * right[1] + 0.5 * back[1] + 0.3 * up[1], 0.35 * right[2] + 0.5 * back[2] + 0.3 * up[2] + 0.3].map((v, _, all) => v / Math.hypot(...all)));
      return new Float32Array(column);
    };
    const pose = (u, name, alpha, paint) => {
      const p = u[name];
      gl.uniform3f(uniform.centre, p[0], p[1], p[2]);
      // rows of the rotation become columns
      gl.uniformMatrix3fv(uniform.turn, false, [p[3], p[6], p[9], p[4], p[7], p[10], p[5], p[8], p[11]]);
      gl.uniform4f(uniform.paint, ...paint, alpha);
      const solid = solids[u.solid];
      gl.bindBuffer(gl.ARRAY_BUFFER, solid.corners);
      gl.vertexAttribPointer(attribute.corner, 3, gl.FLOAT, false, 0, 0);
      gl.bindBuffer(gl.ARRAY_BUFFER, solid.normals);
      gl.vertexAttribPointer(attribute.normal, 3, gl.FLOAT, false, 0, 0);
      gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, solid.triangles);
      gl.drawElements(gl.TRIANGLES, solid.count, gl.UNSIGNED_SHORT, 0);
    };
    const render = () => {
      waiting = false;
      const ratio = window.devicePixelRatio || 1;
      canvas.width = Math.max(1, Math.round(scene.clientWidth * ratio));
      canvas.height = Math.max(1, Math.round(scene.clientHeight * ratio));
      gl.viewport(0, 0, canvas.width, canvas.height);
      gl.clearColor(0.93, 0.95, 0.96, 1);
      gl.depthMask(true);
      gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
      gl.enable(gl.DEPTH_TEST);
      gl.enable(gl.CULL_FACE);
      gl.enableVertexAttribArray(attribute.corner);
      gl.enableVertexAttribArray(attribute.normal);
      gl.uniformMatrix4fv(uniform.camera, false, camera(canvas.width / canvas.height));
      gl.disable(gl.BLEND);
      if (document.getElementById("show-late").checked)
        units.forEach((u, k) => u.late && pose(u, "late", 1, k === chosen ? [0.85, 0.15, 0.1] : rgb(colour.get(u.kind) || "#d5d8dc")));
      gl.enable(gl.BLEND);
      gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
      gl.depthMask(false);
      if (document.getElementById("show-early").checked)
        units.forEach((u) => u.early && (u.kind !== "stable" || !u.late) && pose(u, "early", 0.4, rgb((u.kind !== "unseen" && colour.get(u.kind)) || "#5d6d7e")));
      scene.querySelector(".north svg").style.transform = `rotate(${-eye.azimuth}rad)`;
    };
    const ask = () => {
      if (!waiting) {
        waiting = true;
        requestAnimationFrame(render);
      }
    };
    const near = (factor) => {
      untouched = false;
      eye.distance = Math.min(radius * 6, Math.max(H, eye.distance * factor));
      ask();
    };
    const pinched = pinch(canvas, (factor) => near(1 / factor));
    let grip = null;
    canvas.addEventListener("pointerdown", (event) => (grip = [event.clientX, event.clientY, event.shiftKey || event.button === 2]));
    canvas.addEventListener("contextmenu", (event) => event.preventDefault());
    window.addEventListener("pointerup", () => (grip = null));
    window.addEventListener("pointermove", (event) => {
      if (!grip || pinched()) return;
      untouched = false;
      const dx = event.clientX - grip[0], dy = event.clientY - grip[1];
      if (grip[2]) {
        const metre = (eye.distance * 0.85) / scene.clientHeight;
        eye.target[0] += (-dx * Math.cos(eye.azimuth) + dy * Math.sin(eye.azimuth)) * metre;
        eye.target[1] += (dx * Math.sin(eye.azimuth) + dy * Math.cos(eye.azimuth)) * metre;
      } else {
        eye.azimuth += dx / 150;
        eye.height = Math.min(1.55, Math.max(-0.2, eye.height + dy / 150));
      }
      grip = [event.clientX, event.clientY, grip[2]];
      ask();
    });
    canvas.addEventListener("wheel", (event) => {
      event.preventDefault();
      near(Math.exp(event.deltaY / 500));
    }, { passive: false });
    ["show-late", "show-early"].forEach((id) => document.getElementById(id).addEventListener("change", ask));
    document.getElementById("scene-fit").addEventListener("click", () => {
      untouched = true;
      eye = home();
      ask();
    });
    const lookAt = (k) => {
      untouched = false;
      eye.target = [...units[k].place];
      eye.distance = Math.min(eye.distance, 6 * H);
      ask();
    };
    followers.push(lookAt);
    if (chosen >= 0) lookAt(chosen);
    window.addEventListener("resize", () => {
      // a phone that is turned, or a window made narrow, still shows all
      if (untouched) eye = home();
      ask();
    });
    ask();
    return true;
  };
  const showScene = () => {
    const gl = canvas.getContext("webgl", { antialias: true, preserveDrawingBuffer: true });
    if (gl && startScene(gl)) return;
    scene.hidden = true;
    document.getElementById("scene-missing").hidden = false;
  };
  // a machine without a graphics processor draws a thousand blocks in seconds: not before the scene comes near the window
  if (window.IntersectionObserver) {
    const watch = new IntersectionObserver((seen) => {
      if (!seen.some((entry) => entry.isIntersecting)) return;
      watch.disconnect();
      showScene();
    }, { rootMargin: "200px" });
    watch.observe(scene);
  } else showScene();

  window.addEventListener("resize", draw);
  sort();
  filter();
  fit();
})();
