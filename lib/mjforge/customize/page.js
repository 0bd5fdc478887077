// The page of `mjforge customize`: controls, picture, findings. The program keeps no state of the
// page; every request contains the whole state.
(function () {
  "use strict";
  const byId = (id) => document.getElementById(id);
  const kView = { azimuth: 122.8, elevation: -29.6, zoom: 1 }; // default; `view:` of the spec replaces it
  const kFullDelay = 150; // ms without a change until the full picture is drawn
  const client = Math.random().toString(36).slice(2);

  let [revision, seed, index] = [0, "0", "0"];
  let pins = {}; // set values by parameter; all others are drawn
  let [firstView, view] = [kView, kView]; // `view` is a new object after each change
  let joints = {}; // positions of joints that were moved, rad or m
  let [basePose, jointNames] = ["view", ""]; // pose of all other joints: view, start or zero; joints that are shown
  let filmed = ""; // state that the film shows
  let checked = {}; // version, and the reply to its physical checks when it has arrived
  let controls = new Map();
  const known = new Set(); // parameters that the spec has or had

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
    const settings = Object.entries(pins).filter(([name]) => controls.has(name) || !known.has(name))
      .map(([name, value]) => ({ name, value }));
    return {
      action, revision: String(revision), settings, seed, index, joints, pose: basePose, ...view,
      layer: byId("layer").value || "visual", nine: byId("nine").checked, ...more,
    };
  }

  // Drawing: at most one request is under way, and only the newest state waits.
  let [wanted, isDrawing, fullTimer] = [null, false, 0];

  async function draw(quick) {
    clearTimeout(fullTimer);
    wanted = { quick: Boolean(quick) };
    byId("view").classList.add("outdated");
    byId("state").textContent = quick ? "" : "drawing ...";
    if (filmed !== filmable()) byId("film").hidden = true;
    if (isDrawing) return;
    isDrawing = true;
    while (wanted) {
      const options = wanted;
      wanted = null;
      try {
        const reply = await ask(request("draw", options), "draw?client=" + client);
        if (reply) show(reply, options.quick);
      } catch (error) {
        byId("state").textContent = "outdated: no answer";
      }
    }
    isDrawing = false;
  }

  function show(reply, quick) {
    if (reply.error) return showError(reply.error);
    const hasPicture = reply.picture.length > 0;
    if (hasPicture) showPicture(byId("picture"), reply.picture);
    for (const [name, control] of controls) if (Object.hasOwn(reply.values, name) && !wanted) control.show(reply.values[name]);
    byId("cells").replaceChildren(...reply.cells.map((text) => make("span", {}, text)));
    showFacts(reply.facts);
    showJoints(reply.joints);
    const isCurrent = hasPicture && !wanted;
    const isChecked = isCurrent && !quick && byId("simulate").checked;
    if (!isChecked && !(quick && isCurrent)) showFindings(reply.findings);
    if (!wanted) {
      byId("view").classList.toggle("outdated", !isCurrent);
      byId("state").textContent = isCurrent ? "" : "outdated: see the findings";
      if (isChecked) check();
      if (quick && hasPicture) fullTimer = setTimeout(() => draw(false), kFullDelay);
    }
  }

  // Sends a request that takes longer than a picture. Returns the reply; null after an error, or if the
  // state changed.
  async function askSlowly(action, more, doing) {
    const state = version();
    byId("state").textContent = doing;
    const reply = await ask(request(action, more), "slow?client=" + action + "-" + client)
      .catch(() => ({ error: "no answer" }));
    if (!reply || state !== version()) return null;
    byId("state").textContent = reply.error || "";
    return reply.error ? null : reply;
  }

  // Runs the physical checks, once for each variant, and shows all findings.
  async function check() {
    if (checked.version !== version()) {
      const mine = checked = { version: version() };
      mine.reply = await askSlowly("check", {}, "checking ...");
      if (checked === mine && !mine.reply) checked = {};
    }
    if (checked.reply && byId("simulate").checked)
      showFindings(checked.reply.findings, "No findings; the physical checks passed.");
  }

  const showError = (message) => {
    byId("state").textContent = "outdated";
    showFindings([{ finding: { severity: "error", message }, text: "" }]);
  };

  function showPicture(picture, bytes) {
    const old = picture.src;
    picture.src = URL.createObjectURL(new Blob([bytes], { type: "image/webp" }));
    picture.alt = byId("name").textContent + ", seed " + seed + ", index " + index;
    if (old) URL.revokeObjectURL(old);
  }

  const digits = (number) => String(Number(Number.isInteger(Number(number)) ? number : Number(number).toPrecision(5)));

  function showFacts(facts) {
    const rows = facts ? [["mass", digits(facts.mass) + " kg"], ["size", facts.size.map(digits).join(" × ") + " m"],
      ["bodies", facts.bodies], ["geoms", facts.geoms]] : [];
    byId("facts").replaceChildren(...rows.map(([key, value]) =>
      make("div", {}, make("dt", {}, key), make("dd", {}, String(value)))));
  }

  const placeOfLine = ({ file, line }) => [file.split("/").pop(), line].filter(Boolean).join(":");

  function showFindings(findings, none = "No findings.") {
    const count = (word, number = findings.filter(({ finding }) => finding.severity === word).length) =>
      number ? [number + " " + word + (number > 1 ? "s" : "")] : [];
    byId("count-findings").textContent = [...count("error"), ...count("warning")].join(", ");
    byId("count-findings").hidden = !findings.length;
    for (const [name, { fault }] of controls)
      fault.textContent = findings.filter(({ finding, text }) => finding.file === "control" && text.startsWith(name + ": "))
        .map(({ finding, text }) => text.slice(name.length + 2) + ": " + finding.message).join("; ");
    const items = findings.map(({ finding, text }) => {
      const place = finding.file
        ? make("button", { type: "button", onclick: () => openPlace(finding, text) },
          finding.file === "control" ? "the control" : placeOfLine(finding))
        : null;
      return make("li", { className: finding.severity },
        make("span", { className: "severity" }, finding.severity), " ", place, " ", finding.message,
        finding.code ? " [" + finding.code + "]" : "",
        text ? make("code", {}, text.trim()) : null,
        finding.hint ? make("div", {}, "Hint: " + finding.hint) : null);
    });
    if (!items.length) items.push(make("li", { className: "none" }, none));
    byId("findings").replaceChildren(...items);
  }

  // Shows the place of a finding: the control of its setting, or its line of the spec.
  async function openPlace(finding, text) {
    if (finding.file === "control") return controls.get(text.slice(0, text.indexOf(": ")))?.focus();
    const reply = await ask(request("source", { name: finding.file }));
    if (!reply || reply.text === undefined) return;
    const lines = reply.text.split("\n").map((line, i) => make("span",
      { className: i + 1 === finding.line ? "here" : "" }, String(i + 1).padStart(4) + "  " + line + "\n"));
    byId("source-name").textContent = finding.file;
    byId("source-text").replaceChildren(...lines);
    byId("source").hidden = false;
    const pre = byId("source-text");
    pre.scrollTop = (pre.querySelector(".here") || pre).offsetTop - pre.offsetTop - 60; // a few lines above
    pre.focus({ preventScroll: true });
    byId("source").scrollIntoView({ block: "nearest" });
  }

  // History: the first state, and the state after each complete change.
  let [states, current] = [[], 0];
  const now = () => JSON.stringify({ pins, seed, index });
  const version = () => revision + now(); // identifies the state of the page and of the spec's files
  const filmable = () => version() + byId("layer").value + byId("nine").checked;

  function commit() {
    if (now() === states[current]) return;
    states.splice(++current, Infinity, now());
    showHistory();
  }

  function restore(position) {
    current = position;
    ({ pins, seed, index } = JSON.parse(states[current]));
    showHistory();
    draw(false);
  }

  function showHistory() {
    byId("undo").disabled = current === 0;
    byId("redo").disabled = current === states.length - 1;
    byId("seed").value = seed;
    byId("index").value = index;
    for (const control of controls.values()) control.showPin();
  }

  // Sets a parameter. A change is incomplete while a slider moves or a text is typed.
  function set(name, value, isComplete) {
    pins[name] = value;
    if (isComplete) commit();
    controls.get(name).showPin();
    draw(!isComplete);
  }

  // Makes a complete change of the state.
  function change(action) {
    action();
    commit();
    draw(false);
  }

  const setNumber = (id, value) => change(() => { if (id === "seed") seed = value; else index = value; });

  const isNumber = (text) => text.trim() !== "" && Number.isFinite(Number(text));

  // A slider and a number field, which always show the same value.
  function makeNumber(id, label, low, high, whole, unit, changed) {
    const slider = make("input", { type: "range", step: whole ? 1 : "any", "aria-label": label + ", slider" });
    const field = make("input", { type: "text", inputMode: "decimal", id, "aria-label": label + (unit ? ", " + unit : "") });
    let [number, last, typed] = [NaN, NaN, ""]; // last number, last number or expression, text of the field
    let isEdited = false; // true after a change that is not complete
    function range(value) {
      if (low === null || high === null || !(low < high)) {
        const width = Math.abs(value) || 1;
        [low, high] = value < 0 ? [2 * value, 0] : [value > 0 ? 0 : -width, value + width];
        if (whole) high = Math.max(high, 10);
      }
      slider.min = Math.min(low, value);
      slider.max = Math.max(high, value);
    }
    // Rounds a number to 5 digits, or more if the range is narrow, but not beyond the range.
    function near(value) {
      const more = Math.floor(Math.log10(Math.abs(value) / (slider.max - slider.min)));
      const rounded = Number.isInteger(Number(value)) ? value : Number(value).toPrecision(5 + Math.min(Math.max(more, 0), 12));
      return Math.min(Math.max(rounded, slider.min), slider.max);
    }
    function show(value) {
      number = last = value;
      range(value);
      slider.value = value;
      if (document.activeElement !== field || field.value !== typed) field.value = near(value);
    }
    function take(element, isComplete) {
      const text = element.value.trim();
      typed = field.value;
      if (!text && (!isComplete || Number.isNaN(number))) return;
      const value = element === slider ? near(text) : !text ? number : isNumber(text) ? Number(text) : text;
      if (element === slider || !text) field.value = near(value);
      if (isComplete && !isEdited && value === last) return;
      [last, isEdited] = [value, !isComplete];
      if (typeof value === "string") return changed({ yaml: value }, isComplete);
      number = value;
      range(value);
      if (element === field) slider.value = value;
      changed(value, isComplete);
    }
    for (const element of [slider, field]) {
      element.addEventListener("input", () => take(element, false));
      element.addEventListener("change", () => take(element, true));
    }
    const row = make("div", { className: "row" }, slider, field, make("span", { className: "unit" }, unit === "1" ? "" : unit));
    return { row, show, focus: () => field.focus() };
  }

  // Makes a control of one element; each of its changes is complete.
  function makeSingle(control, element, read, show) {
    element.addEventListener("change", () => set(control.name, read(), true));
    return { rows: [make("div", { className: "row single" }, element)], show, focus: () => element.focus() };
  }

  function makeField(control, id, read, write) {
    const field = make("input", { type: "text", id });
    return makeSingle(control, field, () => read(field.value),
      (value) => { if (document.activeElement !== field) field.value = write(value); });
  }

  // Each function returns the elements of a control, and functions that show a value and set focus.
  const makers = {
    number: (control, id) => makers.vector(control, id),
    vector(control, id) {
      let values = Array(control.components).fill(0);
      const isOne = control.kind === "number";
      const numbers = Array.from({ length: control.components }, (_, i) =>
        makeNumber(i ? id + "-" + i : id, control.name + (isOne ? "" : " " + (i + 1)), control.low && control.low[i],
          control.high && control.high[i], control.whole, control.unit.split(", ").slice(0, i + 1).pop(),
          (value, isComplete) => {
            values = values.map((old, k) => k === i ? value : old);
            set(control.name, isOne ? value : values, isComplete);
          }));
      const show = (value) => { values = isOne ? [value] : value; numbers.forEach((number, i) => number.show(values[i])); };
      return { rows: numbers.map((number) => number.row), show, focus: numbers[0].focus };
    },
    color(control, id) {
      let values = [];
      const picker = make("input", { type: "color", id });
      const change = (rgb, rest, isComplete) => set(control.name, values = rgb.concat(rest), isComplete);
      const picked = () => [1, 3, 5].map((at) => Number(digits(parseInt(picker.value.slice(at, at + 2), 16) / 255)));
      for (const event of ["input", "change"])
        picker.addEventListener(event, () => change(picked(), values.slice(3), event === "change"));
      const alpha = control.components === 4 ? makeNumber(id + "-alpha", control.name, 0, 1, false, "opacity",
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
      control.choices.forEach((value, i) => list.append(make("option", { value: String(i) }, [value].flat().join(", "))));
      return makeSingle(control, list, () => control.choices[Number(list.value)], (value) => {
        list.value = String(control.choices.findIndex((choice) => JSON.stringify(choice) === JSON.stringify(value)));
      });
    },
    switch: (control, id, box = make("input", { type: "checkbox", id })) =>
      makeSingle(control, box, () => box.checked, (value) => { box.checked = value; }),
    text: (control, id) => makeField(control, id, (text) => text, String),
    list: (control, id) => makeField(control, id, (text) => ({ yaml: text }), JSON.stringify),
    fixed: (control, id, output = make("output", { id })) =>
      ({ rows: [output], show: (value) => { output.textContent = String(value); }, focus: () => {} }),
  };

  function makeControl(control, i) {
    const id = "p" + i;
    const { rows, show, focus } = makers[control.kind](control, id);
    const label = make("label", { className: "title", htmlFor: id }, control.name);
    const help = control.doc ? make("p", { className: "help", id: id + "-doc" }, control.doc) : null;
    const button = (sign, title, onclick) => make("button", { type: "button", title, "aria-label": title + ": " + control.name, onclick }, sign);
    const dice = button("⚂", "Draw another value", () => redraw(control.name));
    const free = button("↺", "As in the spec", () => change(() => { delete pins[control.name]; }));
    const fault = make("p", { className: "fault" });
    const box = make("div", { className: "control", "data-name": control.name },
      make("div", { className: "head" }, label, make("span", { className: "spec" }, control.spec),
        control.random && control.kind !== "fixed" ? dice : null, control.kind !== "fixed" ? free : null), ...rows, fault, help);
    if (help) rows[0].querySelectorAll("input, select").forEach((element) =>
      element.setAttribute("aria-describedby", help.id));
    const showPin = () => { free.disabled = !box.classList.toggle("set", Object.hasOwn(pins, control.name)); };
    return { box, show, showPin, fault, focus };
  }

  function showControls(list) {
    controls = new Map();
    const groups = new Map();
    list.forEach((control, i) => {
      const made = makeControl(control, i);
      controls.set(control.name, made);
      known.add(control.name);
      groups.set(control.group, [...(groups.get(control.group) || []), made.box]);
    });
    byId("controls").replaceChildren(...Array.from(groups, ([title, boxes]) =>
      make("fieldset", {}, make("legend", {}, title || "Parameters"), ...boxes)));
  }

  async function redraw(name) {
    const reply = await ask(request("redraw", { name, seed: String(Math.floor(Math.random() * 2 ** 53)) }));
    if (reply && reply.value !== undefined) set(name, reply.value, true);
  }

  // Returns a position that may have a unit in rad or m; NaN if it is not a number.
  function positionOf(value) {
    const [, number, unit] = /^(.*?)(deg|rad|mm|cm|m|)$/.exec(value.yaml ?? value);
    return isNumber(number) ? Number(number) * ({ deg: Math.PI / 180, mm: 0.001, cm: 0.01 }[unit] || 1) : NaN;
  }

  // Shows joints of the variant, with one slider each.
  function showJoints(list) {
    const names = JSON.stringify(list.map((joint) => [joint.name, joint.limited, joint.range, joint.value]));
    if (names === jointNames) return;
    jointNames = names;
    byId("joints").hidden = !list.length;
    const rows = list.map((joint, i) => {
      const ends = joint.limited ? joint.range : joint.type === "hinge" ? [-Math.PI, Math.PI] : [-1, 1];
      const number = makeNumber("j" + i, joint.name, ends[0], ends[1], false, joint.type === "hinge" ? "rad" : "m",
        (value, isComplete) => {
          const position = positionOf(value);
          if (Number.isNaN(position)) return showError("'" + value.yaml + "' is not a position of " + joint.name);
          number.show(joints[joint.name] = position);
          draw(!isComplete);
        });
      number.show(Object.hasOwn(joints, joint.name) ? joints[joint.name] : joint.value);
      const drive = make("button", { type: "button", "aria-label": "Film of the drive of " + joint.name,
        onclick: () => film(joint.name) }, "Film");
      return make("div", { className: "control" }, make("div", { className: "head" },
        make("label", { htmlFor: "j" + i }, joint.name), make("span", { className: "spec" }, joint.type), drive), number.row);
    });
    byId("joint-rows").replaceChildren(...rows);
  }

  // Moves all joints to the pose of the spec's view, to the start pose, or to zero.
  const pose = (base) => { [basePose, joints, jointNames] = [base, {}, ""]; draw(false); };

  // Shows the simulated drop or, if there is a name, the simulated drive of that joint.
  async function film(name) {
    const state = filmable();
    const reply = await askSlowly("film", { name, width: 360, height: 270 }, "simulating ...");
    if (!reply || state !== filmable()) return;
    filmed = state;
    showPicture(byId("film-picture"), reply.picture);
    byId("film-text").textContent = reply.text;
    byId("film").hidden = false;
  }

  // The view: pointer, wheel and keyboard.
  function turn(right, up, quick) {
    view = { ...view, azimuth: (view.azimuth + right) % 360, elevation: Math.min(Math.max(view.elevation + up, -90), 90) };
    draw(quick);
  }

  const zoom = (factor) => { view = { ...view, zoom: Math.min(Math.max(view.zoom * factor, 0.1), 50) }; draw(true); };

  function listenToView() {
    const figure = byId("view");
    const kDegreesPerPixel = 0.4;
    let at = null;
    figure.addEventListener("pointerdown", (event) => {
      if (byId("nine").checked) return chooseOfNine(event);
      at = [event.clientX, event.clientY];
      figure.setPointerCapture(event.pointerId);
    });
    figure.addEventListener("pointermove", (event) => {
      if (!at) return;
      turn(-(event.clientX - at[0]) * kDegreesPerPixel, -(event.clientY - at[1]) * kDegreesPerPixel, true);
      at = [event.clientX, event.clientY];
    });
    for (const name of ["pointerup", "pointercancel"]) figure.addEventListener(name, () => at && (at = null, draw(false)));
    figure.addEventListener("wheel", (event) => {
      event.preventDefault();
      zoom(Math.exp(-event.deltaY * 0.001));
    }, { passive: false });
    figure.addEventListener("dblclick", showPart);
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

  const showFirstView = () => { view = firstView; draw(false); };

  // Returns the place of a pointer in the picture, from 0 to 1.
  function placeOf(event) {
    const box = byId("view").getBoundingClientRect();
    return { x: (event.clientX - box.left) / box.width, y: (event.clientY - box.top) / box.height };
  }

  // Shows the part at a place of the picture, and its line of the spec.
  async function showPart(event) {
    const found = await ask(request("pick", placeOf(event)));
    const facts = found?.part ? [found.part, found.material, digits(found.mass) + " kg"] : ["no part"];
    const place = found?.file && make("button", { type: "button", onclick: () => openPlace(found, "") }, placeOfLine(found));
    byId("part").replaceChildren(facts.filter(Boolean).join(", "), " ", place || "");
    if (place) place.click();
  }

  // Shows only the variant, of nine variants, at the place of the pointer.
  function chooseOfNine(event) {
    const { x, y } = placeOf(event);
    byId("nine").checked = false;
    setNumber("index", String(BigInt(index) + BigInt(3 * Math.floor(3 * y) + Math.floor(3 * x))));
  }

  // Presets: named sets of values beside the spec.
  const showPresets = (names) => byId("preset").replaceChildren(
    make("option", { value: "" }, "Presets"), ...names.map((name) => make("option", {}, name)));

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
    change(() => { pins = Object.fromEntries(reply.settings.map(({ name, text }) => [name, { yaml: text }])); });
  }

  // Exports: texts to copy and files to save.
  async function take(form) {
    const reply = await ask(request("export", { name: form, count: byId("count").value || "1",
      ...(form === "png" ? { width: 1280, height: 960 } : {}) }));
    if (reply.error) copy(reply.error);
    else if (form === "png") save(reply.file + ".png", "image/png", reply.picture);
    else if (form === "mjcf" && reply.picture.length) save(reply.file + ".tar", "application/x-tar", reply.picture);
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

  const save = (name, type, content) =>
    make("a", { href: URL.createObjectURL(new Blob([content], { type })), download: name }).click();

  // Reads the spec again. Requests leave out set values of parameters that were removed.
  async function open() {
    const reply = await ask(request("open", { settings: [] }));
    if (reply.error) return showError(reply.error);
    if (!states.length) {
      ({ seed, index } = reply);
      for (const { name, text } of reply.settings) pins[name] = { yaml: text };
      byId("layer").replaceChildren(...reply.layers.map((layer) => make("option", {}, layer)));
    }
    document.title = reply.name + " - mjforge customize";
    byId("name").textContent = reply.name;
    byId("description").textContent = reply.description;
    const hasControls = reply.controls !== null;
    if (hasControls) {
      showControls(reply.controls);
      const isTurned = view !== firstView;
      const { pose, ...directions } = reply.view;
      firstView = { ...kView, ...directions };
      if (!isTurned) view = firstView;
      byId("view-pose").hidden = !Object.keys(pose).length;
    }
    states[current] = now();
    showHistory();
    showPresets(reply.presets);
    if (hasControls) return draw(false);
    showFindings(reply.findings);
    byId("view").classList.add("outdated");
    byId("state").textContent = "outdated: see the findings";
  }

  // Waits for changes of the spec's files, and shows a message if the program has stopped.
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

  const on = (id, event, action) => byId(id).addEventListener(event, action);
  function listen() {
    on("controls", "submit", (event) => event.preventDefault());
    for (const id of ["layer", "simulate", "nine"]) on(id, "change", () => draw(false));
    on("front", "click", showFirstView);
    on("count-findings", "click", () => byId("all-findings").scrollIntoView({ block: "nearest" }));
    on("drop", "click", () => film(""));
    for (const base of ["view", "start", "zero"]) on(base + "-pose", "click", () => pose(base));
    for (const id of ["film", "source"]) {
      on(id + "-close", "click", () => { byId(id).hidden = true; });
      document.addEventListener("keydown", (event) => { byId(id).hidden ||= event.key === "Escape"; });
    }
    on("preset-save", "click", savePreset);
    on("preset", "change", loadPreset);
    for (const [id, step] of [["undo", -1], ["redo", 1]]) on(id, "click", () => restore(current + step));
    on("reset", "click", () => change(() => { ({ pins, seed, index } = JSON.parse(states[0])); pose("view"); }));
    on("dice", "click", () => setNumber("seed", String(Math.floor(Math.random() * 2 ** 32))));
    for (const id of ["seed", "index"])
      on(id, "change", () => /^\d{1,20}$/.test(byId(id).value) && BigInt(byId(id).value) < 2n ** 64n ? setNumber(id, byId(id).value) : showHistory());
    for (const button of document.querySelectorAll("[data-export]")) button.addEventListener("click", () => take(button.dataset.export));
    listenToView();
  }

  listen();
  open().catch(() => { byId("stopped").hidden = false; }).then(watch);
})();
