// The page of `mjforge customize`: controls, picture, findings. The program keeps no state of the
// page; every request contains all of it.
(function () {
  "use strict";
  const byId = (id) => document.getElementById(id);
  const kFirstView = { azimuth: 122.8, elevation: -29.6, zoom: 1 };
  const kFullDelay = 150; // ms without a change, after which the full picture is drawn
  const client = Math.random().toString(36).slice(2);

  let revision = 0;
  let seed = "0";
  let index = "0";
  let pins = {}; // set values by parameter; all others are drawn
  let first = null; // pins, seed and index with which the page began
  let view = { ...kFirstView };
  let joints = {};
  let controls = new Map();

  // Creates an element with properties and children.
  function make(tag, properties, ...children) {
    const element = document.createElement(tag);
    for (const [key, value] of Object.entries(properties || {})) {
      if (key in element) element[key] = value;
      else element.setAttribute(key, value);
    }
    element.append(...children.filter((child) => child !== null));
    return element;
  }

  // Requests. A reply is the length of its JSON (4 bytes), the JSON, and a picture.
  async function ask(request, path) {
    const response = await fetch(path || "ask", { method: "POST", body: JSON.stringify(request) });
    if (response.status === 409) return null; // a newer request of this page replaced it
    if (!response.ok) throw new Error(await response.text());
    const bytes = await response.arrayBuffer();
    const length = new DataView(bytes).getUint32(0, true);
    const reply = JSON.parse(new TextDecoder().decode(new Uint8Array(bytes, 4, length)));
    reply.picture = new Uint8Array(bytes, 4 + length);
    return reply;
  }

  function request(action, more) {
    const settings = Object.entries(pins).map(([name, value]) => ({ name, value }));
    return {
      action, revision: String(revision), settings, seed, index, joints, ...view,
      layer: byId("layer").value || "visual", simulate: byId("simulate").checked, nine: byId("nine").checked, ...more,
    };
  }

  // Drawing: at most one request is under way, and only the newest state waits.
  let wanted = null;
  let running = null;
  let fullTimer = 0;

  function draw(quick) {
    clearTimeout(fullTimer);
    wanted = { quick: Boolean(quick) };
    byId("view").classList.add("outdated");
    byId("state").textContent = quick ? "" : "drawing ...";
    return pump();
  }

  const pump = () => running || (running = drawWanted().finally(() => { running = null; }));
  async function drawWanted() {
    while (wanted) {
      const quick = wanted.quick;
      wanted = null;
      try {
        const reply = await ask(request("draw", { quick }), "draw?client=" + client);
        if (reply) show(reply, quick);
      } catch (error) {
        byId("state").textContent = "outdated: no answer";
      }
    }
  }

  function show(reply, quick) {
    if (reply.error) return showError(reply.error);
    const hasPicture = reply.picture.length > 0;
    if (hasPicture) showPicture(reply.picture);
    for (const [name, control] of controls) if (Object.hasOwn(reply.values, name) && !wanted) control.show(reply.values[name]);
    showFacts(reply.facts);
    showJoints(reply.joints);
    const isCurrent = hasPicture && !wanted;
    if (!quick || !isCurrent) showFindings(reply.findings);
    if (!wanted) {
      byId("view").classList.toggle("outdated", !isCurrent);
      byId("state").textContent = isCurrent ? "" : "outdated: see the findings";
      if (quick && hasPicture) fullTimer = setTimeout(() => draw(false), kFullDelay);
    }
  }

  function showError(message) {
    byId("state").textContent = "outdated";
    showFindings([{ finding: { severity: "error", message }, text: "" }]);
  }

  function showPicture(bytes) {
    const picture = byId("picture");
    const old = picture.src;
    picture.src = URL.createObjectURL(new Blob([bytes], { type: "image/webp" }));
    picture.alt = byId("name").textContent + ", seed " + seed + ", index " + index;
    if (old) URL.revokeObjectURL(old);
  }

  const digits = (number) => String(Number(Number.isInteger(Number(number)) ? number : Number(number).toPrecision(5)));

  function showFacts(facts) {
    const rows = facts ? [["mass", digits(facts.mass) + " kg"],
      ["size", facts.size.map(digits).join(" × ") + " m"],
      ["bodies", facts.bodies], ["geoms", facts.geoms]] : [];
    byId("facts").replaceChildren(...rows.map(([key, value]) =>
      make("div", {}, make("dt", {}, key), make("dd", {}, String(value)))));
  }

  function showFindings(findings) {
    const items = findings.map(({ finding, text }) => {
      const place = finding.file
        ? make("button", { type: "button", onclick: () => openPlace(finding, text) },
          finding.file === "control" ? "the control" : [finding.file, finding.line].filter(Boolean).join(":"))
        : null;
      return make("li", { className: finding.severity },
        make("span", { className: "severity" }, finding.severity), " ", place, " ", finding.message,
        finding.code ? " [" + finding.code + "]" : "",
        text ? make("code", {}, text.trim()) : null,
        finding.hint ? make("div", {}, "Hint: " + finding.hint) : null);
    });
    if (!items.length) items.push(make("li", { className: "none" }, "No findings."));
    byId("findings").replaceChildren(...items);
  }

  // Shows the place of a finding: the control of its setting, or its line of the spec.
  async function openPlace(finding, text) {
    if (finding.file === "control") {
      const control = controls.get(text.slice(0, text.indexOf(": ")));
      return control && control.focus();
    }
    const reply = await ask(request("source", { name: finding.file }));
    if (!reply || reply.text === undefined) return;
    const lines = reply.text.split("\n").map((line, i) => make("span",
      { className: i + 1 === finding.line ? "here" : "" }, String(i + 1).padStart(4) + "  " + line + "\n"));
    byId("source-name").textContent = finding.file;
    byId("source-text").replaceChildren(...lines);
    byId("source").hidden = false;
    const pre = byId("source-text");
    pre.scrollTop = (pre.querySelector(".here") || pre).offsetTop - pre.offsetTop - 60; // a few lines above
    pre.focus({ preventScroll: !text });
  }

  // History: states before each change that is complete.
  const past = [], future = [];
  const now = () => JSON.stringify({ pins, seed, index });
  let last = now();

  function commit() {
    if (now() === last) return;
    past.push(last);
    last = now();
    future.length = 0;
    showHistory();
  }

  function restore(from, to) {
    if (!from.length) return;
    to.push(last);
    last = from.pop();
    ({ pins, seed, index } = JSON.parse(last));
    showHistory();
    draw(false);
  }

  function showHistory() {
    byId("undo").disabled = !past.length;
    byId("redo").disabled = !future.length;
    byId("seed").value = seed;
    byId("index").value = index;
    for (const control of controls.values()) control.showPin();
  }

  // Sets a parameter; a change that is not complete draws quickly.
  function set(name, value, isComplete) {
    pins[name] = value;
    if (isComplete) commit();
    controls.get(name).showPin();
    draw(!isComplete);
  }

  function setNumber(id, value) {
    if (id === "seed") seed = value;
    else index = value;
    commit();
    showHistory();
    draw(false);
  }

  function unset(name) {
    delete pins[name];
    commit();
    draw(false);
  }

  const isNumber = (text) => text.trim() !== "" && Number.isFinite(Number(text));

  // A slider and a number field, which always show the same value.
  function makeNumber(id, label, low, high, whole, unit, changed) {
    const step = whole ? 1 : "any";
    const slider = make("input", { type: "range", step, "aria-label": label + ", slider" });
    const field = make("input", { type: "number", id, step, "aria-label": label + (unit ? ", " + unit : "") });
    let [shown, isEdited] = [NaN, false]; // the value, and whether it changed since the last complete change
    function range(value) {
      if (low === null || high === null || !(low < high)) {
        const width = Math.abs(value) || 1;
        [low, high] = value < 0 ? [2 * value, 0] : [value > 0 ? 0 : -width, value + width];
        if (whole) high = Math.max(high, 10);
      }
      slider.min = Math.min(low, value);
      slider.max = Math.max(high, value);
    }
    function show(value) {
      shown = value;
      range(value);
      slider.value = value;
      if (document.activeElement !== field || !isNumber(field.value) || Number(field.value) !== value) field.value = digits(value);
    }
    function take(element, isComplete) {
      if (!isNumber(element.value)) return isComplete && show(shown);
      const value = element === slider ? Number(digits(element.value)) : Number(element.value);
      if (isComplete && !isEdited && (value === shown || element.value === digits(shown))) return;
      isEdited = !isComplete;
      shown = value;
      range(value);
      if (element === slider) field.value = digits(value);
      else slider.value = value;
      changed(value, isComplete);
    }
    for (const element of [slider, field]) {
      element.addEventListener("input", () => take(element, false));
      element.addEventListener("change", () => take(element, true));
    }
    field.addEventListener("keydown", (event) => { if (event.key === "Enter") take(field, true); });
    const row = make("div", { className: "row" }, slider, field,
      make("span", { className: "unit" }, unit === "1" ? "" : unit));
    return { row, show, focus: () => field.focus() };
  }

  function makeField(control, id, read, write) {
    const field = make("input", { type: "text", id });
    field.addEventListener("change", () => set(control.name, read(field.value), true));
    const show = (value) => { if (document.activeElement !== field) field.value = write(value); };
    return { rows: [make("div", { className: "row single" }, field)], show, focus: () => field.focus() };
  }

  // Each function returns the elements of a control, and functions that show a value and set focus.
  const makers = {
    number(control, id) {
      const number = makeNumber(id, control.name, control.low && control.low[0], control.high && control.high[0],
        control.whole, control.unit, (value, isComplete) => set(control.name, value, isComplete));
      return { rows: [number.row], show: number.show, focus: number.focus };
    },
    vector(control, id) {
      let values = [];
      const units = control.unit.split(", ");
      const numbers = Array.from({ length: control.components }, (_, i) =>
        makeNumber(i ? id + "-" + i : id, control.name + " " + (i + 1), control.low && control.low[i],
          control.high && control.high[i], false, units[Math.min(i, units.length - 1)],
          (value, isComplete) => {
            values = values.slice();
            values[i] = value;
            set(control.name, values, isComplete);
          }));
      const show = (value) => {
        values = value;
        numbers.forEach((number, i) => number.show(value[i]));
      };
      return { rows: numbers.map((number) => number.row), show, focus: numbers[0].focus };
    },
    color(control, id) {
      let values = [];
      const picker = make("input", { type: "color", id });
      const change = (rgb, rest, isComplete) => set(control.name, values = rgb.concat(rest), isComplete);
      const picked = () => [1, 3, 5].map((at) => Number(digits(parseInt(picker.value.slice(at, at + 2), 16) / 255)));
      picker.addEventListener("input", () => change(picked(), values.slice(3), false));
      picker.addEventListener("change", () => change(picked(), values.slice(3), true));
      const alpha = control.components === 4 ? makeNumber(id + "-alpha", control.name + ", opacity", 0, 1, false, "",
        (value, isComplete) => change(values.slice(0, 3), [value], isComplete)) : null;
      const list = control.choices ? makers.choice(control, id + "-list") : null;
      const hex = (value) => Math.round(255 * Math.min(Math.max(value, 0), 1)).toString(16).padStart(2, "0");
      const show = (value) => {
        values = value;
        picker.value = "#" + value.slice(0, 3).map(hex).join("");
        if (alpha) alpha.show(value[3]);
        if (list) list.show(value);
      };
      return { rows: [make("div", { className: "row single" }, picker), alpha && alpha.row, list && list.rows[0]], show, focus: () => picker.focus() };
    },
    choice(control, id) {
      const list = make("select", { id, "aria-label": control.name });
      const text = (value) => Array.isArray(value) ? value.join(", ") : String(value);
      control.choices.forEach((value, i) => list.append(make("option", { value: String(i) }, text(value))));
      list.addEventListener("change", () => {
        if (list.value !== "") set(control.name, control.choices[Number(list.value)], true);
      });
      const show = (value) => {
        list.value = String(control.choices.findIndex((choice) => JSON.stringify(choice) === JSON.stringify(value)));
      };
      return { rows: [make("div", { className: "row single" }, list)], show, focus: () => list.focus() };
    },
    switch(control, id) {
      const box = make("input", { type: "checkbox", id });
      box.addEventListener("change", () => set(control.name, box.checked, true));
      return { rows: [make("div", {}, box)], show: (value) => { box.checked = value; }, focus: () => box.focus() };
    },
    text: (control, id) => makeField(control, id, (text) => text, String),
    list: (control, id) => makeField(control, id, (text) => ({ yaml: text }), JSON.stringify),
    fixed(control, id) {
      const output = make("output", { id });
      return { rows: [output], show: (value) => { output.textContent = String(value); }, focus: () => {} };
    },
  };

  function makeControl(control, i) {
    const id = "p" + i;
    const { rows, show, focus } = makers[control.kind](control, id);
    const label = make("label", { className: "title", htmlFor: id }, control.name);
    const help = control.doc ? make("p", { className: "help", id: id + "-doc" }, control.doc) : null;
    const button = (sign, title, onclick) =>
      make("button", { type: "button", title, "aria-label": title + ": " + control.name, onclick }, sign);
    const dice = button("⚂", "Draw another value", () => redraw(control.name));
    const free = button("↺", "As in the spec", () => unset(control.name));
    const spec = make("span", { className: "spec" }, control.spec);
    const buttons = control.kind === "fixed" ? [] : control.random ? [dice, free] : [free];
    const box = make("div", { className: "control" },
      make("div", { className: "head" }, label, spec, ...buttons), ...rows, help);
    box.dataset.name = control.name;
    if (help) rows[0].querySelectorAll("input, select").forEach((element) =>
      element.setAttribute("aria-describedby", help.id));
    const showPin = () => {
      box.classList.toggle("set", Object.hasOwn(pins, control.name));
      free.disabled = !Object.hasOwn(pins, control.name);
    };
    return { box, show, showPin, focus };
  }

  function showControls(list) {
    controls = new Map();
    const groups = new Map();
    list.forEach((control, i) => {
      const made = makeControl(control, i);
      controls.set(control.name, made);
      if (!groups.has(control.group)) groups.set(control.group, []);
      groups.get(control.group).push(made.box);
    });
    byId("controls").replaceChildren(...Array.from(groups, ([title, boxes]) =>
      make("fieldset", {}, make("legend", {}, title || "Parameters"), ...boxes)));
  }

  async function redraw(name) {
    const reply = await ask(request("redraw", { name, seed: String(Math.floor(Math.random() * 2 ** 53)) }));
    if (!reply || reply.value === undefined) return;
    controls.get(name).show(reply.value);
    set(name, reply.value, true);
  }

  // Joints of the variant, with one slider each.
  let jointNames = "";

  function showJoints(list) {
    const names = JSON.stringify(list.map((joint) => [joint.name, joint.limited, joint.range]));
    if (names === jointNames) return;
    jointNames = names;
    byId("joints").hidden = !list.length;
    const rows = list.map((joint, i) => {
      const ends = joint.limited ? joint.range : joint.type === "hinge" ? [-Math.PI, Math.PI] : [-1, 1];
      const number = makeNumber("j" + i, joint.name, ends[0], ends[1], false, joint.type === "hinge" ? "rad" : "m",
        (value, isComplete) => {
          joints[joint.name] = value;
          draw(!isComplete);
        });
      number.show(Object.hasOwn(joints, joint.name) ? joints[joint.name] : joint.value);
      const sweep = make("button", { type: "button", "aria-label": "Move " + joint.name,
        onclick: () => play(joint.name, ends, number) }, "Move");
      return make("div", { className: "control" }, make("div", { className: "head" },
        make("label", { htmlFor: "j" + i }, joint.name), make("span", { className: "spec" }, joint.type), sweep), number.row);
    });
    byId("joints").replaceChildren(make("legend", {}, "Joints"), ...rows);
  }

  // Moves a joint to both ends of its range and back.
  async function play(name, [low, high], number) {
    const start = joints[name];
    const from = start === undefined ? Math.min(Math.max(0, low), high) : start;
    const kSteps = 24;
    for (let step = 1; step <= kSteps; ++step) {
      const way = 4 * step / kSteps;
      const to = way < 1 ? from + (high - from) * way : way < 3 ? high + (low - high) * (way - 1) / 2
        : low + (from - low) * (way - 3);
      joints[name] = to;
      number.show(to);
      await draw(step < kSteps);
    }
    if (start === undefined) delete joints[name];
  }

  // The view: pointer, wheel and keyboard.
  function turn(right, up, quick) {
    view.azimuth = (view.azimuth + right) % 360;
    view.elevation = Math.min(Math.max(view.elevation + up, -90), 90);
    draw(quick);
  }

  function zoom(factor) {
    view.zoom = Math.min(Math.max(view.zoom * factor, 0.1), 50);
    draw(true);
  }

  function listenToView() {
    const figure = byId("view");
    const kDegreesPerPixel = 0.4;
    let at = null;
    figure.addEventListener("pointerdown", (event) => {
      if (byId("nine").checked) return chooseOfNine(event, figure.getBoundingClientRect());
      at = [event.clientX, event.clientY];
      figure.setPointerCapture(event.pointerId);
    });
    figure.addEventListener("pointermove", (event) => {
      if (!at) return;
      turn(-(event.clientX - at[0]) * kDegreesPerPixel, -(event.clientY - at[1]) * kDegreesPerPixel, true);
      at = [event.clientX, event.clientY];
    });
    const release = () => at && (at = null, draw(false));
    for (const name of ["pointerup", "pointercancel"]) figure.addEventListener(name, release);
    figure.addEventListener("wheel", (event) => {
      event.preventDefault();
      zoom(Math.exp(-event.deltaY * 0.001));
    }, { passive: false });
    figure.addEventListener("dblclick", (event) => showPart(event, figure.getBoundingClientRect()));
    const keys = {
      ArrowLeft: () => turn(10, 0, true), ArrowRight: () => turn(-10, 0, true),
      ArrowUp: () => turn(0, 10, true), ArrowDown: () => turn(0, -10, true),
      "+": () => zoom(1.2), "-": () => zoom(1 / 1.2), 0: showFirstView,
    };
    figure.addEventListener("keydown", (event) => {
      if (!(event.key in keys) || event.ctrlKey || event.metaKey) return;
      event.preventDefault();
      keys[event.key]();
    });
  }

  function showFirstView() {
    view = { ...kFirstView };
    draw(false);
  }

  // Shows the part at a place of the picture, and its line of the spec.
  async function showPart(event, box) {
    const found = await ask(request("pick", { x: (event.clientX - box.left) / box.width, y: (event.clientY - box.top) / box.height }));
    byId("part").textContent = found && found.part
      ? [found.part, found.material, digits(found.mass) + " kg"].filter(Boolean).join(", ") : "no part";
    if (found && found.file) openPlace(found, "");
  }

  // Shows the one of nine variants at a place of the picture.
  function chooseOfNine(event, box) {
    const column = Math.floor(3 * (event.clientX - box.left) / box.width);
    const row = Math.floor(3 * (event.clientY - box.top) / box.height);
    byId("nine").checked = false;
    setNumber("index", String(BigInt(index) + BigInt(3 * row + column)));
  }

  // Presets: named sets of values beside the spec.
  function showPresets(names) {
    byId("preset").replaceChildren(make("option", { value: "" }, "Presets"), ...names.map((name) => make("option", {}, name)));
  }

  async function savePreset() {
    const reply = await ask(request("save", { name: byId("preset-name").value }));
    if (reply.presets) showPresets(reply.presets);
    copy(reply.error || "saved: " + reply.file);
  }

  async function loadPreset() {
    const name = byId("preset").value;
    byId("preset").value = ""; // so that the same preset can be chosen again
    if (!name) return;
    const reply = await ask(request("preset", { name }));
    if (reply.error) return showError(reply.error);
    if (reply.findings.some(({ finding }) => finding.severity === "error")) return showFindings(reply.findings);
    pins = Object.fromEntries(reply.settings.map(({ name, text }) => [name, { yaml: text }]));
    commit();
    showHistory();
    draw(false);
  }

  // Texts and files to take away.
  async function take(form) {
    const size = form === "png" ? { width: 1280, height: 960 } : {};
    const reply = await ask(request("export", { name: form, ...size }));
    if (!reply) return;
    if (reply.error) copy(reply.error);
    else if (form === "png") save(reply.file + ".png", "image/png", reply.picture);
    else if (form === "mjcf") save(reply.file + ".xml", "application/xml", reply.text);
    else copy(reply.text);
  }

  function copy(text) {
    const field = byId("copied");
    field.value = text;
    field.focus();
    field.select();
    if (navigator.clipboard) navigator.clipboard.writeText(text).catch(() => {});
  }

  function save(name, type, content) {
    make("a", { href: URL.createObjectURL(new Blob([content], { type })), download: name }).click();
  }

  // Shows the spec, as it is now in its file. Set values stay set if there still is such a parameter.
  async function open() {
    const reply = await ask(request("open", { settings: [] }));
    if (reply.error) return showError(reply.error);
    if (!first) {
      seed = reply.seed;
      index = reply.index;
      for (const { name, text } of reply.settings) pins[name] = { yaml: text };
      first = last = now();
      byId("layer").replaceChildren(...reply.layers.map((layer) => make("option", {}, layer)));
    }
    document.title = reply.name + " - mjforge customize";
    byId("name").textContent = reply.name;
    byId("description").textContent = reply.description;
    const hasControls = reply.controls !== null;
    if (hasControls) {
      const names = new Set(reply.controls.map((control) => control.name));
      for (const name of Object.keys(pins)) {
        if (controls.has(name) && !names.has(name)) delete pins[name];
      }
      showControls(reply.controls);
      last = now();
    }
    showHistory();
    showPresets(reply.presets);
    if (hasControls) return draw(false);
    showFindings(reply.findings);
    byId("view").classList.add("outdated");
    byId("state").textContent = "outdated: see the findings";
  }

  // Waits for changes of the spec's files, and notices when the program stops.
  async function watch() {
    for (;;) {
      // A hidden tab does not wait, because browsers allow a host only six connections.
      if (document.hidden) await new Promise((resolve) => { document.addEventListener("visibilitychange", resolve, { once: true }); });
      try {
        const response = await fetch("events?revision=" + revision);
        if (!response.ok) throw new Error(response.statusText);
        const answer = await response.json();
        const wasStopped = !byId("stopped").hidden;
        byId("stopped").hidden = true;
        if (answer.revision !== revision || wasStopped) {
          revision = answer.revision;
          await open();
        }
      } catch (error) {
        byId("stopped").hidden = false;
        await new Promise((resolve) => { setTimeout(resolve, 1000); });
      }
    }
  }

  function listen() {
    byId("controls").addEventListener("submit", (event) => event.preventDefault());
    for (const id of ["layer", "simulate", "nine"]) byId(id).addEventListener("change", () => draw(false));
    byId("front").addEventListener("click", showFirstView);
    byId("source-close").addEventListener("click", () => { byId("source").hidden = true; });
    byId("preset-save").addEventListener("click", savePreset);
    byId("preset").addEventListener("change", loadPreset);
    byId("undo").addEventListener("click", () => restore(past, future));
    byId("redo").addEventListener("click", () => restore(future, past));
    byId("reset").addEventListener("click", () => {
      ({ pins, seed, index } = JSON.parse(first));
      joints = {};
      jointNames = "";
      commit();
      showHistory();
      draw(false);
    });
    byId("dice").addEventListener("click", () => setNumber("seed", String(Math.floor(Math.random() * 2 ** 32))));
    for (const id of ["seed", "index"]) {
      byId(id).addEventListener("change", () =>
        /^\d{1,19}$/.test(byId(id).value) ? setNumber(id, byId(id).value) : showHistory());
    }
    for (const button of document.querySelectorAll("[data-export]")) button.addEventListener("click", () => take(button.dataset.export));
    byId("copy-seed").addEventListener("click", () => copy("--seed " + seed + " --index " + index));
    listenToView();
  }

  listen();
  showHistory();
  open().catch(() => { byId("stopped").hidden = false; }).then(watch);
})();
